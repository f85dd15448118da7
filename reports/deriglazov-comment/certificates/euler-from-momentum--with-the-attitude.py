# deriglazov-comment / euler-from-momentum/with-the-attitude: Given the equation for the attitude, the rate of m seen from the body is exactly what Euler's equations set to zero.
#
# Given: the definitions, the assumptions and t1-attitude, orthogonality.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: R_{11}\cdot \dot{\bf m}_1+R_{21}\cdot \dot{\bf m}_2+R_{31}\cdot \dot{\bf m}_3 = I_1\cdot \dot{\Omega}_1-(I_2\cdot \Omega_2\cdot \Omega_3-I_3\cdot \Omega_3\cdot \Omega_2)
# where \dot{\bf m}_1 = (-(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12}))\cdot (I_1\cdot \Omega_1)+R_{11}\cdot (I_1\cdot \dot{\Omega}_1)+((-((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11}))\cdot (I_2\cdot \Omega_2)+R_{12}\cdot (I_2\cdot \dot{\Omega}_2))+((-(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11}))\cdot (I_3\cdot \Omega_3)+R_{13}\cdot (I_3\cdot \dot{\Omega}_3))
# where \dot{\bf m}_2 = (-(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22}))\cdot (I_1\cdot \Omega_1)+R_{21}\cdot (I_1\cdot \dot{\Omega}_1)+((-((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21}))\cdot (I_2\cdot \Omega_2)+R_{22}\cdot (I_2\cdot \dot{\Omega}_2))+((-(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21}))\cdot (I_3\cdot \Omega_3)+R_{23}\cdot (I_3\cdot \dot{\Omega}_3))
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
# R23 stands for R_{23}
# R22 stands for R_{22}
# R21 stands for R_{21}
# R13 stands for R_{13}
# R12 stands for R_{12}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R33, R32, R31, R23, R22, R21, R13, R12, R11, I3, I2, I1, = symbols("Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R33, R32, R31, R23, R22, R21, R13, R12, R11, I3, I2, I1,")
# p1 = 0 because of what is given: R_{11}\cdot R_{11}+R_{21}\cdot R_{21}+R_{31}\cdot R_{31} = 1
p1 = R31**2 + R21**2 + R11**2 - 1
q1 = Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1
# p2 = 0 because of what is given: R_{11}\cdot R_{12}+R_{21}\cdot R_{22}+R_{31}\cdot R_{32} = 0
p2 = R32*R31 + R22*R21 + R12*R11
q2 = -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2
# p3 = 0 because of what is given: R_{11}\cdot R_{13}+R_{21}\cdot R_{23}+R_{31}\cdot R_{33} = 0
p3 = R33*R31 + R23*R21 + R13*R11
q3 = Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3
d = 1
N = -Omega3*Omega1*R32*R31*I3 + Omega3*Omega2*R31**2*I3 - Omega3*Omega1*R22*R21*I3 + Omega3*Omega2*R21**2*I3 - Omega3*Omega1*R12*R11*I3 + Omega3*Omega2*R11**2*I3 + Omega2*Omega1*R33*R31*I2 - Omega3*Omega2*R31**2*I2 + Omega2*Omega1*R23*R21*I2 - Omega3*Omega2*R21**2*I2 + Omega2*Omega1*R13*R11*I2 - Omega3*Omega2*R11**2*I2 - Omega2*Omega1*R33*R31*I1 + Omega3*Omega1*R32*R31*I1 - Omega2*Omega1*R23*R21*I1 + Omega3*Omega1*R22*R21*I1 - Omega2*Omega1*R13*R11*I1 + Omega3*Omega1*R12*R11*I1 + Omega3_dot*R33*R31*I3 + Omega3_dot*R23*R21*I3 + Omega3_dot*R13*R11*I3 + Omega2_dot*R32*R31*I2 + Omega2_dot*R22*R21*I2 + Omega2_dot*R12*R11*I2 + Omega1_dot*R31**2*I1 + Omega1_dot*R21**2*I1 + Omega1_dot*R11**2*I1 - Omega3*Omega2*I3 + Omega3*Omega2*I2 - Omega1_dot*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))

# Equation 2: R_{12}\cdot \dot{\bf m}_1+R_{22}\cdot \dot{\bf m}_2+R_{32}\cdot \dot{\bf m}_3 = I_2\cdot \dot{\Omega}_2-(I_3\cdot \Omega_3\cdot \Omega_1-I_1\cdot \Omega_1\cdot \Omega_3)
# where \dot{\bf m}_1 = (-(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12}))\cdot (I_1\cdot \Omega_1)+R_{11}\cdot (I_1\cdot \dot{\Omega}_1)+((-((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11}))\cdot (I_2\cdot \Omega_2)+R_{12}\cdot (I_2\cdot \dot{\Omega}_2))+((-(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11}))\cdot (I_3\cdot \Omega_3)+R_{13}\cdot (I_3\cdot \dot{\Omega}_3))
# where \dot{\bf m}_2 = (-(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22}))\cdot (I_1\cdot \Omega_1)+R_{21}\cdot (I_1\cdot \dot{\Omega}_1)+((-((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21}))\cdot (I_2\cdot \Omega_2)+R_{22}\cdot (I_2\cdot \dot{\Omega}_2))+((-(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21}))\cdot (I_3\cdot \Omega_3)+R_{23}\cdot (I_3\cdot \dot{\Omega}_3))
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
# R23 stands for R_{23}
# R22 stands for R_{22}
# R21 stands for R_{21}
# R13 stands for R_{13}
# R12 stands for R_{12}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R33, R32, R31, R23, R22, R21, R13, R12, R11, I3, I2, I1, = symbols("Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R33, R32, R31, R23, R22, R21, R13, R12, R11, I3, I2, I1,")
# p1 = 0 because of what is given: R_{11}\cdot R_{12}+R_{21}\cdot R_{22}+R_{31}\cdot R_{32} = 0
p1 = R32*R31 + R22*R21 + R12*R11
q1 = Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1
# p2 = 0 because of what is given: R_{12}\cdot R_{12}+R_{22}\cdot R_{22}+R_{32}\cdot R_{32} = 1
p2 = R32**2 + R22**2 + R12**2 - 1
q2 = -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2
# p3 = 0 because of what is given: R_{12}\cdot R_{13}+R_{22}\cdot R_{23}+R_{32}\cdot R_{33} = 0
p3 = R33*R32 + R23*R22 + R13*R12
q3 = Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3
d = 1
N = -Omega3*Omega1*R32**2*I3 + Omega3*Omega2*R32*R31*I3 - Omega3*Omega1*R22**2*I3 + Omega3*Omega2*R22*R21*I3 - Omega3*Omega1*R12**2*I3 + Omega3*Omega2*R12*R11*I3 + Omega2*Omega1*R33*R32*I2 - Omega3*Omega2*R32*R31*I2 + Omega2*Omega1*R23*R22*I2 - Omega3*Omega2*R22*R21*I2 + Omega2*Omega1*R13*R12*I2 - Omega3*Omega2*R12*R11*I2 - Omega2*Omega1*R33*R32*I1 + Omega3*Omega1*R32**2*I1 - Omega2*Omega1*R23*R22*I1 + Omega3*Omega1*R22**2*I1 - Omega2*Omega1*R13*R12*I1 + Omega3*Omega1*R12**2*I1 + Omega3_dot*R33*R32*I3 + Omega3_dot*R23*R22*I3 + Omega3_dot*R13*R12*I3 + Omega2_dot*R32**2*I2 + Omega2_dot*R22**2*I2 + Omega2_dot*R12**2*I2 + Omega1_dot*R32*R31*I1 + Omega1_dot*R22*R21*I1 + Omega1_dot*R12*R11*I1 + Omega3*Omega1*I3 - Omega3*Omega1*I1 - Omega2_dot*I2
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))

# Equation 3: R_{13}\cdot \dot{\bf m}_1+R_{23}\cdot \dot{\bf m}_2+R_{33}\cdot \dot{\bf m}_3 = I_3\cdot \dot{\Omega}_3-(I_1\cdot \Omega_1\cdot \Omega_2-I_2\cdot \Omega_2\cdot \Omega_1)
# where \dot{\bf m}_1 = (-(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12}))\cdot (I_1\cdot \Omega_1)+R_{11}\cdot (I_1\cdot \dot{\Omega}_1)+((-((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11}))\cdot (I_2\cdot \Omega_2)+R_{12}\cdot (I_2\cdot \dot{\Omega}_2))+((-(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11}))\cdot (I_3\cdot \Omega_3)+R_{13}\cdot (I_3\cdot \dot{\Omega}_3))
# where \dot{\bf m}_2 = (-(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22}))\cdot (I_1\cdot \Omega_1)+R_{21}\cdot (I_1\cdot \dot{\Omega}_1)+((-((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21}))\cdot (I_2\cdot \Omega_2)+R_{22}\cdot (I_2\cdot \dot{\Omega}_2))+((-(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21}))\cdot (I_3\cdot \Omega_3)+R_{23}\cdot (I_3\cdot \dot{\Omega}_3))
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
# R23 stands for R_{23}
# R22 stands for R_{22}
# R21 stands for R_{21}
# R13 stands for R_{13}
# R12 stands for R_{12}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R33, R32, R31, R23, R22, R21, R13, R12, R11, I3, I2, I1, = symbols("Omega3_dot, Omega2_dot, Omega1_dot, Omega3, Omega2, Omega1, R33, R32, R31, R23, R22, R21, R13, R12, R11, I3, I2, I1,")
# p1 = 0 because of what is given: R_{11}\cdot R_{13}+R_{21}\cdot R_{23}+R_{31}\cdot R_{33} = 0
p1 = R33*R31 + R23*R21 + R13*R11
q1 = Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1
# p2 = 0 because of what is given: R_{12}\cdot R_{13}+R_{22}\cdot R_{23}+R_{32}\cdot R_{33} = 0
p2 = R33*R32 + R23*R22 + R13*R12
q2 = -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2
# p3 = 0 because of what is given: R_{13}\cdot R_{13}+R_{23}\cdot R_{23}+R_{33}\cdot R_{33} = 1
p3 = R33**2 + R23**2 + R13**2 - 1
q3 = Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3
d = 1
N = -Omega3*Omega1*R33*R32*I3 + Omega3*Omega2*R33*R31*I3 - Omega3*Omega1*R23*R22*I3 + Omega3*Omega2*R23*R21*I3 - Omega3*Omega1*R13*R12*I3 + Omega3*Omega2*R13*R11*I3 + Omega2*Omega1*R33**2*I2 - Omega3*Omega2*R33*R31*I2 + Omega2*Omega1*R23**2*I2 - Omega3*Omega2*R23*R21*I2 + Omega2*Omega1*R13**2*I2 - Omega3*Omega2*R13*R11*I2 - Omega2*Omega1*R33**2*I1 + Omega3*Omega1*R33*R32*I1 - Omega2*Omega1*R23**2*I1 + Omega3*Omega1*R23*R22*I1 - Omega2*Omega1*R13**2*I1 + Omega3*Omega1*R13*R12*I1 + Omega3_dot*R33**2*I3 + Omega3_dot*R23**2*I3 + Omega3_dot*R13**2*I3 + Omega2_dot*R33*R32*I2 + Omega2_dot*R23*R22*I2 + Omega2_dot*R13*R12*I2 + Omega1_dot*R33*R31*I1 + Omega1_dot*R23*R21*I1 + Omega1_dot*R13*R11*I1 - Omega2*Omega1*I2 + Omega2*Omega1*I1 - Omega3_dot*I3
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))
