# deriglazov-comment / omega-chosen: With the momentum along z, the angular velocity in the body has a simple form.
#
# Given: the definitions, the assumptions and momentum, omega-of-m.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \frac{1}{I_1}\cdot (R_{11}\cdot {\bf m}_1(0)+R_{21}\cdot {\bf m}_2(0)+R_{31}\cdot {\bf m}_3(0)) = \frac{R_{31}\cdot {\bf m}_3}{I_1}
# where {\bf m}_3 = {\bf m}_3(0)
# where {\bf m}_1(0) = 0
# where {\bf m}_2(0) = 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: \frac{1}{I_2}\cdot (R_{12}\cdot {\bf m}_1(0)+R_{22}\cdot {\bf m}_2(0)+R_{32}\cdot {\bf m}_3(0)) = \frac{R_{32}\cdot {\bf m}_3}{I_2}
# where {\bf m}_3 = {\bf m}_3(0)
# where {\bf m}_1(0) = 0
# where {\bf m}_2(0) = 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 3: \frac{1}{I_3}\cdot (R_{13}\cdot {\bf m}_1(0)+R_{23}\cdot {\bf m}_2(0)+R_{33}\cdot {\bf m}_3(0)) = \frac{R_{33}\cdot {\bf m}_3}{I_3}
# where {\bf m}_3 = {\bf m}_3(0)
# where {\bf m}_1(0) = 0
# where {\bf m}_2(0) = 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 4: \Omega_1 = \frac{R_{31}\cdot {\bf m}_3}{I_1}
# where \Omega_1 = \frac{1}{I_1}\cdot (R_{11}\cdot 0+R_{21}\cdot 0+R_{31}\cdot {\bf m}_3(0))
# where {\bf m}_3 = {\bf m}_3(0)
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 5: \Omega_2 = \frac{R_{32}\cdot {\bf m}_3}{I_2}
# where \Omega_2 = \frac{1}{I_2}\cdot (R_{12}\cdot 0+R_{22}\cdot 0+R_{32}\cdot {\bf m}_3(0))
# where {\bf m}_3 = {\bf m}_3(0)
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 6: \Omega_3 = \frac{R_{33}\cdot {\bf m}_3}{I_3}
# where \Omega_3 = \frac{1}{I_3}\cdot (R_{13}\cdot 0+R_{23}\cdot 0+R_{33}\cdot {\bf m}_3(0))
# where {\bf m}_3 = {\bf m}_3(0)
d = 1
N = 0
print(expand(d*N - (0)))
