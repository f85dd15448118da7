# deriglazov-comment / t15-phi: The closed form of φ, for motions that obey the relation between E and m.
#
# Given: the definitions, the assumptions and reduced-phi, momentum.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \varphi(0) = \frac{{\bf m}_3(0)}{I_3}\cdot 0+\varphi(0)
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: \dot{\varphi} = \frac{\dot{\bf m}_3}{I_3}\cdot t+\frac{{\bf m}_3}{I_3}
# where {\bf m}_3 = {\bf m}_3(0)
# where \dot{\bf m}_3 = 0
# where \dot{\varphi} = \frac{{\bf m}_3(0)}{I_3}
d = 1
N = 0
print(expand(d*N - (0)))
