# deriglazov-comment / t3-energy: The energy as a function of the attitude and the constants m.
#
# Given: the definitions, the assumptions and momentum, omega-of-m, orthogonality.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: E = \frac{1}{2}\cdot I_1\cdot (\frac{1}{I_1}\cdot (R_{11}\cdot {\bf m}_1(0)+R_{21}\cdot {\bf m}_2(0)+R_{31}\cdot {\bf m}_3(0)))^{2}+\frac{1}{2}\cdot I_2\cdot (\frac{1}{I_2}\cdot (R_{12}\cdot {\bf m}_1(0)+R_{22}\cdot {\bf m}_2(0)+R_{32}\cdot {\bf m}_3(0)))^{2}+\frac{1}{2}\cdot I_3\cdot (\frac{1}{I_3}\cdot (R_{13}\cdot {\bf m}_1(0)+R_{23}\cdot {\bf m}_2(0)+R_{33}\cdot {\bf m}_3(0)))^{2}
# where E = \frac{1}{2}\cdot I_1\cdot (\frac{1}{I_1}\cdot (R_{11}\cdot {\bf m}_1(0)+R_{21}\cdot {\bf m}_2(0)+R_{31}\cdot {\bf m}_3(0)))^{2}+\frac{1}{2}\cdot I_2\cdot (\frac{1}{I_2}\cdot (R_{12}\cdot {\bf m}_1(0)+R_{22}\cdot {\bf m}_2(0)+R_{32}\cdot {\bf m}_3(0)))^{2}+\frac{1}{2}\cdot I_3\cdot (\frac{1}{I_3}\cdot (R_{13}\cdot {\bf m}_1(0)+R_{23}\cdot {\bf m}_2(0)+R_{33}\cdot {\bf m}_3(0)))^{2}
d = 1
N = 0
print(expand(d*N - (0)))
