# deriglazov-comment / point-of-the-body/body-coordinates: The position at the start is given in the body's axes.
#
# Given: the definitions, the assumptions and euler-poisson.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: {\bf x}_{N1} = R_{11}\cdot (R_{11}(0)\cdot \frac{31}{100}+R_{21}(0)\cdot (-\frac{47}{100})+R_{31}(0)\cdot \frac{83}{100})+R_{12}\cdot (R_{12}(0)\cdot \frac{31}{100}+R_{22}(0)\cdot (-\frac{47}{100})+R_{32}(0)\cdot \frac{83}{100})+R_{13}\cdot (R_{13}(0)\cdot \frac{31}{100}+R_{23}(0)\cdot (-\frac{47}{100})+R_{33}(0)\cdot \frac{83}{100})
# where {\bf x}_{N1} = (R_{11}\cdot R_{11}(0)+R_{12}\cdot R_{12}(0)+R_{13}\cdot R_{13}(0))\cdot \frac{31}{100}+(R_{11}\cdot R_{21}(0)+R_{12}\cdot R_{22}(0)+R_{13}\cdot R_{23}(0))\cdot (-\frac{47}{100})+(R_{11}\cdot R_{31}(0)+R_{12}\cdot R_{32}(0)+R_{13}\cdot R_{33}(0))\cdot \frac{83}{100}
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: {\bf x}_{N2} = R_{21}\cdot (R_{11}(0)\cdot \frac{31}{100}+R_{21}(0)\cdot (-\frac{47}{100})+R_{31}(0)\cdot \frac{83}{100})+R_{22}\cdot (R_{12}(0)\cdot \frac{31}{100}+R_{22}(0)\cdot (-\frac{47}{100})+R_{32}(0)\cdot \frac{83}{100})+R_{23}\cdot (R_{13}(0)\cdot \frac{31}{100}+R_{23}(0)\cdot (-\frac{47}{100})+R_{33}(0)\cdot \frac{83}{100})
# where {\bf x}_{N2} = (R_{21}\cdot R_{11}(0)+R_{22}\cdot R_{12}(0)+R_{23}\cdot R_{13}(0))\cdot \frac{31}{100}+(R_{21}\cdot R_{21}(0)+R_{22}\cdot R_{22}(0)+R_{23}\cdot R_{23}(0))\cdot (-\frac{47}{100})+(R_{21}\cdot R_{31}(0)+R_{22}\cdot R_{32}(0)+R_{23}\cdot R_{33}(0))\cdot \frac{83}{100}
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 3: {\bf x}_{N3} = R_{31}\cdot (R_{11}(0)\cdot \frac{31}{100}+R_{21}(0)\cdot (-\frac{47}{100})+R_{31}(0)\cdot \frac{83}{100})+R_{32}\cdot (R_{12}(0)\cdot \frac{31}{100}+R_{22}(0)\cdot (-\frac{47}{100})+R_{32}(0)\cdot \frac{83}{100})+R_{33}\cdot (R_{13}(0)\cdot \frac{31}{100}+R_{23}(0)\cdot (-\frac{47}{100})+R_{33}(0)\cdot \frac{83}{100})
# where {\bf x}_{N3} = (R_{31}\cdot R_{11}(0)+R_{32}\cdot R_{12}(0)+R_{33}\cdot R_{13}(0))\cdot \frac{31}{100}+(R_{31}\cdot R_{21}(0)+R_{32}\cdot R_{22}(0)+R_{33}\cdot R_{23}(0))\cdot (-\frac{47}{100})+(R_{31}\cdot R_{31}(0)+R_{32}\cdot R_{32}(0)+R_{33}\cdot R_{33}(0))\cdot \frac{83}{100}
d = 1
N = 0
print(expand(d*N - (0)))
