# deriglazov-comment / energy: The kinetic energy does not change.
#
# Given: the definitions, the assumptions and t1-euler.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \dot{E} = 0
# where \dot{E} = \frac{1}{2}\cdot I_1\cdot (2\cdot \Omega_1\cdot \dot{\Omega}_1)+\frac{1}{2}\cdot I_2\cdot (2\cdot \Omega_2\cdot \dot{\Omega}_2)+\frac{1}{2}\cdot I_3\cdot (2\cdot \Omega_3\cdot \dot{\Omega}_3)
# Variables:
# Omega3_dot stands for \dot{\Omega}_3
# Omega2_dot stands for \dot{\Omega}_2
# Omega1_dot stands for \dot{\Omega}_1
# Omega3 stands for \Omega_3
# Omega2 stands for \Omega_2
# Omega1 stands for \Omega_1
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, I3, I2, I1, = symbols("Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, I3, I2, I1,")
# p1 = 0 because of what is given: I_1\cdot \dot{\Omega}_1 = I_2\cdot \Omega_2\cdot \Omega_3-I_3\cdot \Omega_3\cdot \Omega_2
p1 = Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1
q1 = 2*Omega1
# p2 = 0 because of what is given: I_2\cdot \dot{\Omega}_2 = I_3\cdot \Omega_3\cdot \Omega_1-I_1\cdot \Omega_1\cdot \Omega_3
p2 = -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2
q2 = 2*Omega2
# p3 = 0 because of what is given: I_3\cdot \dot{\Omega}_3 = I_1\cdot \Omega_1\cdot \Omega_2-I_2\cdot \Omega_2\cdot \Omega_1
p3 = Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3
q3 = 2*Omega3
d = 1
N = 2*Omega3_dot*Omega3*I3 + 2*Omega2_dot*Omega2*I2 + 2*Omega1_dot*Omega1*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))
