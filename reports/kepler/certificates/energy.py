# kepler / energy: The energy per unit mass does not change.
#
# Given: the definitions, the assumptions and kepler.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \dot{h} = 0
# where \dot{h} = (an expression of 205 operations)
d = 1
N = 0
print(expand(d*N - (0)))
