# deriglazov-comment / psi0-in-t11/for-any-energy: The right side of t11 vanishes at ψ₀, whatever E is.
#
# Given: the definitions, the assumptions and psi0-formula.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: (\frac{1}{I_1}-\frac{1}{I_3}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))^{2})\cdot (\frac{1}{I_3}-\frac{2\cdot E}{{\bf m}_3^2}+(\frac{1}{I_1}-\frac{1}{I_3})-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))^{2}) = 0
# Variables:
# root stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
# E stands for E
# m3 stands for {\bf m}_3
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
root, E, m3, I3, I2, I1, = symbols("root, E, m3, I3, I2, I1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2*I3*I2 - root**2*I3*I1 - I3*I2 + I2*I1
q1 = root**2*m3**2*I3**2*I2*I1**2 - root**2*m3**2*I3**2*I1**3 - m3**2*I3**2*I2*I1**2 + 2*E*I3**2*I2*I1**3
d = 1
N = root**4*m3**2*I3**3*I2**2*I1**2 - 2*root**4*m3**2*I3**3*I2*I1**3 + root**4*m3**2*I3**3*I1**4 - 2*root**2*m3**2*I3**3*I2**2*I1**2 + 2*root**2*m3**2*I3**3*I2*I1**3 + root**2*m3**2*I3**2*I2**2*I1**3 + 2*root**2*E*I3**3*I2**2*I1**3 - root**2*m3**2*I3**2*I2*I1**4 - 2*root**2*E*I3**3*I2*I1**4 + m3**2*I3**3*I2**2*I1**2 - m3**2*I3**2*I2**2*I1**3 - 2*E*I3**3*I2**2*I1**3 + 2*E*I3**2*I2**2*I1**4
print(expand(d*N - (q1*p1)))
