# deriglazov-comment / letter-equation/same-right-side: The right sides agree, squared.
#
# Given: the definitions, the assumptions and I_{(n-k)}.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \frac{(\frac{I_1}{I_3}-1+(1-\frac{I_1}{I_2})\cdot (\cos(\psi))^{2})\cdot (\frac{2\cdot I_1\cdot E}{{\bf m}_3^2}-1+(1-\frac{I_1}{I_2})\cdot (\cos(\psi))^{2})}{(1-(1-\frac{I_1}{I_2})\cdot (\cos(\psi))^{2})^{2}} = \frac{(\frac{1}{I_1}-\frac{1}{I_3}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})\cdot (\frac{1}{I_3}-\frac{2\cdot E}{{\bf m}_3^2}+(\frac{1}{I_1}-\frac{1}{I_3})-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})}{(\frac{1}{I_1}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})^{2}}
d = 1
N = 0
print(expand(d*N - (0)))
