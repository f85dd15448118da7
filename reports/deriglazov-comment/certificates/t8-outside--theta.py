# deriglazov-comment / t8-outside/theta: θ is 0 throughout.
#
# Given: the definitions, the assumptions and t8.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \theta = 0
# where \theta = \operatorname{atan2}(0,1)
d = 1
N = 0
print(expand(d*N - (0)))
