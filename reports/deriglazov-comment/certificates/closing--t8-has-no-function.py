# deriglazov-comment / closing/t8-has-no-function: t8 does not have the properties of ψ(φ): θ is 0 throughout, and its energy is m₃²/(2 I₃).
#
# Given: the definitions, the assumptions and t8.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \theta = 0
# where \theta = \operatorname{atan2}(0,1)
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: 2\cdot E = \frac{{\bf m}_3^2}{I_3}
# where {\bf m}_3 = 0\cdot (I_1\cdot \Omega_1)+0\cdot (I_2\cdot \Omega_2)+I_3\cdot \Omega_3
# where E = \frac{1}{2}\cdot I_1\cdot \Omega_1^2+\frac{1}{2}\cdot I_2\cdot \Omega_2^2+\frac{1}{2}\cdot I_3\cdot \Omega_3^2
# Variables:
# sin stands for \sin((I_3)^{-1}\cdot t\cdot {\bf m}_3(0))
# cos stands for \cos((I_3)^{-1}\cdot t\cdot {\bf m}_3(0))
# Omega2 stands for \Omega_2
# Omega1 stands for \Omega_1
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
sin, cos, Omega2, Omega1, I3, I2, I1, = symbols("sin, cos, Omega2, Omega1, I3, I2, I1,")
# p1 = 0 because of what the variables stand for: c² + s² = 1
p1 = sin**2 + cos**2 - 1
q1 = -2*Omega2**2*I3*I2 - 2*Omega1**2*I3*I1
# p2 = 0 because of what is given: 0 = \sin(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot (I_1\cdot \Omega_1)+\cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot (I_2\cdot \Omega_2)+0\cdot (I_3\cdot \Omega_3)
p2 = -cos*Omega2*I2 - sin*Omega1*I1
q2 = -2*cos*Omega2*I3 - 2*sin*Omega1*I3
# p3 = 0 because of what is given: 0 = \cos(\frac{{\bf m}_3(0)}{I_3}\cdot t)\cdot (I_1\cdot \Omega_1)+(-\sin(\frac{{\bf m}_3(0)}{I_3}\cdot t))\cdot (I_2\cdot \Omega_2)+0\cdot (I_3\cdot \Omega_3)
p3 = sin*Omega2*I2 - cos*Omega1*I1
q3 = 2*sin*Omega2*I3 - 2*cos*Omega1*I3
d = 1
N = 2*Omega2**2*I3*I2 + 2*Omega1**2*I3*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))
