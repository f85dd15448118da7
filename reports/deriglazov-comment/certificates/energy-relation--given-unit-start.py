# deriglazov-comment / energy-relation/given-unit-start: For motions with R(0) = 1.
#
# Given: the definitions, the assumptions and momentum, energy, omega-of-m.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: 2\cdot E = (I_1)^{-1}\cdot {\bf m}_1^2+(I_2)^{-1}\cdot {\bf m}_2^2+(I_3)^{-1}\cdot {\bf m}_3^2
# where {\bf m}_1 = {\bf m}_1(0)
# where {\bf m}_2 = {\bf m}_2(0)
# where {\bf m}_3 = {\bf m}_3(0)
# where E = \frac{1}{2}\cdot I_1\cdot (\frac{1}{I_1}\cdot ({\bf m}_1(0)+0\cdot {\bf m}_2(0)+0\cdot {\bf m}_3(0)))^{2}+\frac{1}{2}\cdot I_2\cdot (\frac{1}{I_2}\cdot (0\cdot {\bf m}_1(0)+{\bf m}_2(0)+0\cdot {\bf m}_3(0)))^{2}+\frac{1}{2}\cdot I_3\cdot (\frac{1}{I_3}\cdot (0\cdot {\bf m}_1(0)+0\cdot {\bf m}_2(0)+{\bf m}_3(0)))^{2}
d = 1
N = 0
print(expand(d*N - (0)))
