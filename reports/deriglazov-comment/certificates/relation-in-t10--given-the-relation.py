# deriglazov-comment / relation-in-t10/given-the-relation: For motions that obey the relation.
#
# Given: the definitions, the assumptions and t10.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: (\frac{1}{I_1}-\frac{1}{I_3}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})\cdot (\sin(\theta))^{2} = 0
# Variables:
# cos_psi stands for \cos(\psi)
# sin_theta stands for \sin(\theta)
# cos_theta stands for \cos(\theta)
# E stands for E
# m3 stands for {\bf m}_3
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
cos_psi, sin_theta, cos_theta, E, m3, I3, I2, I1, = symbols("cos_psi, sin_theta, cos_theta, E, m3, I3, I2, I1,")
# p1 = 0 because of what the variables stand for: c² + s² = 1
p1 = sin_theta**2 + cos_theta**2 - 1
q1 = -2*cos_psi**2*sin_theta**2*E*I3**4*I2**3*I1**3 + cos_psi**2*cos_theta**2*m3**2*I3**3*I2**2*I1**4 + 2*cos_psi**2*sin_theta**2*E*I3**4*I2**2*I1**4 - 2*cos_psi**2*cos_theta**2*E*I3**4*I2**2*I1**4 + 2*sin_theta**2*E*I3**4*I2**3*I1**3 - cos_psi**2*m3**2*I3**3*I2**2*I1**4 + 2*cos_psi**2*E*I3**4*I2**2*I1**4 - 2*sin_theta**2*E*I3**3*I2**3*I1**4
# p2 = 0 because of what is given: 2\cdot E = (I_1)^{-1}\cdot 0+(I_2)^{-1}\cdot 0+(I_3)^{-1}\cdot {\bf m}_3^2
p2 = -m3**2*I2*I1 + 2*E*I3*I2*I1
q2 = cos_psi**2*sin_theta**4*I3**3*I2**2*I1**2 + cos_psi**2*sin_theta**2*cos_theta**2*I3**3*I2**2*I1**2 - cos_psi**2*sin_theta**4*I3**3*I2*I1**3 + cos_psi**2*cos_theta**4*I3**3*I2*I1**3 - cos_psi**2*sin_theta**2*I3**3*I2**2*I1**2 - sin_theta**4*I3**3*I2**2*I1**2 - sin_theta**2*cos_theta**2*I3**3*I2**2*I1**2 - 2*cos_psi**2*cos_theta**2*I3**3*I2*I1**3 + sin_theta**4*I3**2*I2**2*I1**3 + sin_theta**2*cos_theta**2*I3**2*I2**2*I1**3 + sin_theta**2*I3**3*I2**2*I1**2 + cos_psi**2*I3**3*I2*I1**3 - sin_theta**2*I3**2*I2**2*I1**3 - cos_theta**2*I3**2*I2**2*I1**3 + I3**2*I2**2*I1**3
# p3 = 0 because of what is given: 2\cdot E = \frac{{\bf m}_3^2}{I_3}+{\bf m}_3^2\cdot (\frac{1}{I_1}-\frac{1}{I_3}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})\cdot (\sin(\theta))^{2}
p3 = cos_psi**2*sin_theta**2*m3**2*I3**2*I2*I1 - cos_psi**2*sin_theta**2*m3**2*I3**2*I1**2 - sin_theta**2*m3**2*I3**2*I2*I1 + sin_theta**2*m3**2*I3*I2*I1**2 - m3**2*I3*I2*I1**2 + 2*E*I3**2*I2*I1**2
q3 = cos_theta**2*I3*I2**2*I1**2 - I3*I2**2*I1**2
# d is a product of these, which are not 0:
# I_1
# I_2
# I_3
# {\bf m}_3
# \sin(\theta)
d = sin_theta**2*m3**2*I3**2*I2**2*I1**2
N = -cos_psi**2*sin_theta**2*I3*I2*I1 + cos_psi**2*sin_theta**2*I3*I1**2 + sin_theta**2*I3*I2*I1 - sin_theta**2*I2*I1**2
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))
