# deriglazov-comment / momentum: The angular momentum in the laboratory does not change.
#
# Given: the definitions, the assumptions and t1-attitude, t1-euler, orthogonality.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \dot{\bf m}_1 = 0
# where \dot{\bf m}_1 = (-(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12}))\cdot (I_1\cdot \Omega_1)+R_{11}\cdot (I_1\cdot \dot{\Omega}_1)+((-((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11}))\cdot (I_2\cdot \Omega_2)+R_{12}\cdot (I_2\cdot \dot{\Omega}_2))+((-(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11}))\cdot (I_3\cdot \Omega_3)+R_{13}\cdot (I_3\cdot \dot{\Omega}_3))
# Variables:
# Omega3_dot stands for \dot{\Omega}_3
# Omega2_dot stands for \dot{\Omega}_2
# Omega1_dot stands for \dot{\Omega}_1
# Omega3 stands for \Omega_3
# Omega2 stands for \Omega_2
# Omega1 stands for \Omega_1
# R13 stands for R_{13}
# R12 stands for R_{12}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R13, R12, R11, I3, I2, I1, = symbols("Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R13, R12, R11, I3, I2, I1,")
# p1 = 0 because of what is given: I_1\cdot \dot{\Omega}_1 = I_2\cdot \Omega_2\cdot \Omega_3-I_3\cdot \Omega_3\cdot \Omega_2
p1 = Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1
q1 = R11
# p2 = 0 because of what is given: I_2\cdot \dot{\Omega}_2 = I_3\cdot \Omega_3\cdot \Omega_1-I_1\cdot \Omega_1\cdot \Omega_3
p2 = -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2
q2 = R12
# p3 = 0 because of what is given: I_3\cdot \dot{\Omega}_3 = I_1\cdot \Omega_1\cdot \Omega_2-I_2\cdot \Omega_2\cdot \Omega_1
p3 = Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3
q3 = R13
d = 1
N = -Omega3*Omega1*R12*I3 + Omega3*Omega2*R11*I3 + Omega2*Omega1*R13*I2 - Omega3*Omega2*R11*I2 - Omega2*Omega1*R13*I1 + Omega3*Omega1*R12*I1 + Omega3_dot*R13*I3 + Omega2_dot*R12*I2 + Omega1_dot*R11*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))

# Equation 2: \dot{\bf m}_2 = 0
# where \dot{\bf m}_2 = (-(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22}))\cdot (I_1\cdot \Omega_1)+R_{21}\cdot (I_1\cdot \dot{\Omega}_1)+((-((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21}))\cdot (I_2\cdot \Omega_2)+R_{22}\cdot (I_2\cdot \dot{\Omega}_2))+((-(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21}))\cdot (I_3\cdot \Omega_3)+R_{23}\cdot (I_3\cdot \dot{\Omega}_3))
# Variables:
# Omega3_dot stands for \dot{\Omega}_3
# Omega2_dot stands for \dot{\Omega}_2
# Omega1_dot stands for \dot{\Omega}_1
# Omega3 stands for \Omega_3
# Omega2 stands for \Omega_2
# Omega1 stands for \Omega_1
# R23 stands for R_{23}
# R22 stands for R_{22}
# R21 stands for R_{21}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R23, R22, R21, I3, I2, I1, = symbols("Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R23, R22, R21, I3, I2, I1,")
# p1 = 0 because of what is given: I_1\cdot \dot{\Omega}_1 = I_2\cdot \Omega_2\cdot \Omega_3-I_3\cdot \Omega_3\cdot \Omega_2
p1 = Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1
q1 = R21
# p2 = 0 because of what is given: I_2\cdot \dot{\Omega}_2 = I_3\cdot \Omega_3\cdot \Omega_1-I_1\cdot \Omega_1\cdot \Omega_3
p2 = -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2
q2 = R22
# p3 = 0 because of what is given: I_3\cdot \dot{\Omega}_3 = I_1\cdot \Omega_1\cdot \Omega_2-I_2\cdot \Omega_2\cdot \Omega_1
p3 = Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3
q3 = R23
d = 1
N = -Omega3*Omega1*R22*I3 + Omega3*Omega2*R21*I3 + Omega2*Omega1*R23*I2 - Omega3*Omega2*R21*I2 - Omega2*Omega1*R23*I1 + Omega3*Omega1*R22*I1 + Omega3_dot*R23*I3 + Omega2_dot*R22*I2 + Omega1_dot*R21*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))

# Equation 3: \dot{\bf m}_3 = 0
# where \dot{\bf m}_3 = (-(\Omega_2\cdot R_{33}+(-1)\cdot \Omega_3\cdot R_{32}))\cdot (I_1\cdot \Omega_1)+R_{31}\cdot (I_1\cdot \dot{\Omega}_1)+((-((-1)\cdot \Omega_1\cdot R_{33}+\Omega_3\cdot R_{31}))\cdot (I_2\cdot \Omega_2)+R_{32}\cdot (I_2\cdot \dot{\Omega}_2))+((-(\Omega_1\cdot R_{32}+(-1)\cdot \Omega_2\cdot R_{31}))\cdot (I_3\cdot \Omega_3)+R_{33}\cdot (I_3\cdot \dot{\Omega}_3))
# Variables:
# Omega3_dot stands for \dot{\Omega}_3
# Omega2_dot stands for \dot{\Omega}_2
# Omega1_dot stands for \dot{\Omega}_1
# Omega3 stands for \Omega_3
# Omega2 stands for \Omega_2
# Omega1 stands for \Omega_1
# R33 stands for R_{33}
# R32 stands for R_{32}
# R31 stands for R_{31}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R33, R32, R31, I3, I2, I1, = symbols("Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R33, R32, R31, I3, I2, I1,")
# p1 = 0 because of what is given: I_1\cdot \dot{\Omega}_1 = I_2\cdot \Omega_2\cdot \Omega_3-I_3\cdot \Omega_3\cdot \Omega_2
p1 = Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1
q1 = R31
# p2 = 0 because of what is given: I_2\cdot \dot{\Omega}_2 = I_3\cdot \Omega_3\cdot \Omega_1-I_1\cdot \Omega_1\cdot \Omega_3
p2 = -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2
q2 = R32
# p3 = 0 because of what is given: I_3\cdot \dot{\Omega}_3 = I_1\cdot \Omega_1\cdot \Omega_2-I_2\cdot \Omega_2\cdot \Omega_1
p3 = Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3
q3 = R33
d = 1
N = -Omega3*Omega1*R32*I3 + Omega3*Omega2*R31*I3 + Omega2*Omega1*R33*I2 - Omega3*Omega2*R31*I2 - Omega2*Omega1*R33*I1 + Omega3*Omega1*R32*I1 + Omega3_dot*R33*I3 + Omega2_dot*R32*I2 + Omega1_dot*R31*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))
