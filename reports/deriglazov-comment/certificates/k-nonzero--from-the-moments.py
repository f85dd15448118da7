# deriglazov-comment / k-nonzero/from-the-moments: Its square follows from the moments.
#
# Given: the definitions, the assumptions and momentum, psi0-formula.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: (\frac{1}{2}\cdot {\bf m}_3(0)\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \psi(0)))^{2} = {\bf m}_3^2\cdot (\frac{1}{I_1}-\frac{1}{I_3})\cdot (\frac{1}{I_3}-\frac{1}{I_2})
# where {\bf m}_3 = {\bf m}_3(0)
# Variables:
# sin_psi_then stands for \sin(\psi(0))
# cos_psi_then stands for \cos(\psi(0))
# E stands for E
# m3_then stands for {\bf m}_3(0)
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
sin_psi_then, cos_psi_then, E, m3_then, I3, I2, I1, = symbols("sin_psi_then, cos_psi_then, E, m3_then, I3, I2, I1,")
# p1 = 0 because of what the variables stand for: c² + s² = 1
p1 = sin_psi_then**2 + cos_psi_then**2 - 1
q1 = 8*cos_psi_then**2*E*I3**3*I2**3*I1 - 16*cos_psi_then**2*E*I3**3*I2**2*I1**2 + 8*cos_psi_then**2*E*I3**3*I2*I1**3
# p2 = 0 because of what is given: 2\cdot E = (I_1)^{-1}\cdot 0+(I_2)^{-1}\cdot 0+(I_3)^{-1}\cdot {\bf m}_3(0)^2
p2 = -m3_then**2*I2*I1 + 2*E*I3*I2*I1
q2 = -4*sin_psi_then**2*cos_psi_then**2*I3**2*I2**2 + 8*sin_psi_then**2*cos_psi_then**2*I3**2*I2*I1 - 4*sin_psi_then**2*cos_psi_then**2*I3**2*I1**2 - 4*I3**2*I2*I1 + 4*I3*I2**2*I1 + 4*I3*I2*I1**2 - 4*I2**2*I1**2
# p3 = 0 because of what is given: (\cos(\psi(0)))^{2} = \frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}
p3 = cos_psi_then**2*I3*I2 - cos_psi_then**2*I3*I1 - I3*I2 + I2*I1
q3 = -8*cos_psi_then**2*E*I3**2*I2**2*I1 + 8*cos_psi_then**2*E*I3**2*I2*I1**2 - 8*E*I3**2*I2*I1**2 + 8*E*I3*I2**2*I1**2
d = 1
N = 4*sin_psi_then**2*cos_psi_then**2*m3_then**2*I3**2*I2**3*I1 - 8*sin_psi_then**2*cos_psi_then**2*m3_then**2*I3**2*I2**2*I1**2 + 4*sin_psi_then**2*cos_psi_then**2*m3_then**2*I3**2*I2*I1**3 + 4*m3_then**2*I3**2*I2**2*I1**2 - 4*m3_then**2*I3*I2**3*I1**2 - 4*m3_then**2*I3*I2**2*I1**3 + 4*m3_then**2*I2**3*I1**3
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))
