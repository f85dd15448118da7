# deriglazov-comment / t8-solves: Uniform rotation with the rate m₃/I₃ solves t7.1 and starts at R = 1, for all moments and either sign of m₃.
#
# Given: the definitions, the assumptions and momentum.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \dot{Q}_{11} = -(\frac{{\bf m}_3}{I_2}\cdot Q_{32}\cdot Q_{13}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot Q_{33}\cdot Q_{12})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{12} = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{13} = 0
# where Q_{32} = 0
# where Q_{33} = 1
# where \dot{Q}_{11} = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot \frac{{\bf m}_3(0)}{I_3}
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: \dot{Q}_{12} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot Q_{31}\cdot Q_{13}+\frac{{\bf m}_3}{I_3}\cdot Q_{33}\cdot Q_{11})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{11} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{13} = 0
# where Q_{31} = 0
# where Q_{33} = 1
# where \dot{Q}_{12} = -\cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot \frac{{\bf m}_3(0)}{I_3}
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 3: \dot{Q}_{13} = -(\frac{{\bf m}_3}{I_1}\cdot Q_{31}\cdot Q_{12}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot Q_{32}\cdot Q_{11})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{11} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{12} = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{31} = 0
# where Q_{32} = 0
# where \dot{Q}_{13} = 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 4: \dot{Q}_{21} = -(\frac{{\bf m}_3}{I_2}\cdot Q_{32}\cdot Q_{23}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot Q_{33}\cdot Q_{22})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{22} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{23} = 0
# where Q_{32} = 0
# where Q_{33} = 1
# where \dot{Q}_{21} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot \frac{{\bf m}_3(0)}{I_3}
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 5: \dot{Q}_{22} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot Q_{31}\cdot Q_{23}+\frac{{\bf m}_3}{I_3}\cdot Q_{33}\cdot Q_{21})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{21} = \sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{23} = 0
# where Q_{31} = 0
# where Q_{33} = 1
# where \dot{Q}_{22} = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot \frac{{\bf m}_3(0)}{I_3}
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 6: \dot{Q}_{23} = -(\frac{{\bf m}_3}{I_1}\cdot Q_{31}\cdot Q_{22}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot Q_{32}\cdot Q_{21})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{21} = \sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{22} = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)
# where Q_{31} = 0
# where Q_{32} = 0
# where \dot{Q}_{23} = 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 7: \dot{Q}_{31} = -(\frac{{\bf m}_3}{I_2}\cdot Q_{32}\cdot Q_{33}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot Q_{33}\cdot Q_{32})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{32} = 0
# where Q_{33} = 1
# where \dot{Q}_{31} = 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 8: \dot{Q}_{32} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot Q_{31}\cdot Q_{33}+\frac{{\bf m}_3}{I_3}\cdot Q_{33}\cdot Q_{31})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{31} = 0
# where Q_{33} = 1
# where \dot{Q}_{32} = 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 9: \dot{Q}_{33} = -(\frac{{\bf m}_3}{I_1}\cdot Q_{31}\cdot Q_{32}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot Q_{32}\cdot Q_{31})
# where {\bf m}_3 = {\bf m}_3(0)
# where Q_{31} = 0
# where Q_{32} = 0
# where \dot{Q}_{33} = 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 10: Q_{11}(0) = 1
# where Q_{11}(0) = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot 0)
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 11: Q_{12}(0) = 0
# where Q_{12}(0) = -\sin(\frac{{\bf m}_3(0)}{I_3}\cdot 0)
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 12: Q_{21}(0) = 0
# where Q_{21}(0) = \sin(\frac{{\bf m}_3(0)}{I_3}\cdot 0)
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 13: Q_{22}(0) = 1
# where Q_{22}(0) = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot 0)
d = 1
N = 0
print(expand(d*N - (0)))
