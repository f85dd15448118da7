# deriglazov-comment / t7.1: The equation for the attitude with the momentum along z.
#
# Given: the definitions, the assumptions and t3-attitude, momentum.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \dot{R}_{11} = -(\frac{{\bf m}_3}{I_2}\cdot R_{32}\cdot R_{13}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot R_{33}\cdot R_{12})
# where {\bf m}_3 = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \dot{R}_{11} = (an expression of 132 operations)
# Variables:
# Omega3_then stands for \Omega_3(0)
# Omega2_then stands for \Omega_2(0)
# Omega1_then stands for \Omega_1(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# R23 stands for R_{23}
# R22 stands for R_{22}
# R13 stands for R_{13}
# R12 stands for R_{12}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R23, R22, R13, R12, I3, I2, I1, = symbols("Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R23, R22, R13, R12, I3, I2, I1,")
# p1 = 0 because of what is given: 0 = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
p1 = -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1
q1 = R22*R13*I3 - R23*R12*I2
# p2 = 0 because of what is given: 0 = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
p2 = -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1
q2 = R13*R12*I3 - R13*R12*I2
d = 1
N = -Omega3_then*R23_then*R22*R13*I3**2 - Omega3_then*R13_then*R13*R12*I3**2 - Omega2_then*R22_then*R22*R13*I3*I2 + Omega3_then*R23_then*R23*R12*I3*I2 + Omega3_then*R13_then*R13*R12*I3*I2 - Omega2_then*R12_then*R13*R12*I3*I2 + Omega2_then*R22_then*R23*R12*I2**2 + Omega2_then*R12_then*R13*R12*I2**2 - Omega1_then*R21_then*R22*R13*I3*I1 - Omega1_then*R11_then*R13*R12*I3*I1 + Omega1_then*R21_then*R23*R12*I2*I1 + Omega1_then*R11_then*R13*R12*I2*I1
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 2: \dot{R}_{12} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot R_{31}\cdot R_{13}+\frac{{\bf m}_3}{I_3}\cdot R_{33}\cdot R_{11})
# where {\bf m}_3 = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \dot{R}_{12} = (an expression of 132 operations)
# Variables:
# Omega3_then stands for \Omega_3(0)
# Omega2_then stands for \Omega_2(0)
# Omega1_then stands for \Omega_1(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# R23 stands for R_{23}
# R21 stands for R_{21}
# R13 stands for R_{13}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R23, R21, R13, R11, I3, I2, I1, = symbols("Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R23, R21, R13, R11, I3, I2, I1,")
# p1 = 0 because of what is given: 0 = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
p1 = -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1
q1 = -R21*R13*I3 + R23*R11*I1
# p2 = 0 because of what is given: 0 = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
p2 = -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1
q2 = -R13*R11*I3 + R13*R11*I1
d = 1
N = Omega3_then*R23_then*R21*R13*I3**2 + Omega3_then*R13_then*R13*R11*I3**2 + Omega2_then*R22_then*R21*R13*I3*I2 + Omega2_then*R12_then*R13*R11*I3*I2 + Omega1_then*R21_then*R21*R13*I3*I1 - Omega3_then*R23_then*R23*R11*I3*I1 - Omega3_then*R13_then*R13*R11*I3*I1 + Omega1_then*R11_then*R13*R11*I3*I1 - Omega2_then*R22_then*R23*R11*I2*I1 - Omega2_then*R12_then*R13*R11*I2*I1 - Omega1_then*R21_then*R23*R11*I1**2 - Omega1_then*R11_then*R13*R11*I1**2
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 3: \dot{R}_{13} = -(\frac{{\bf m}_3}{I_1}\cdot R_{31}\cdot R_{12}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot R_{32}\cdot R_{11})
# where {\bf m}_3 = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \dot{R}_{13} = (an expression of 132 operations)
# Variables:
# Omega3_then stands for \Omega_3(0)
# Omega2_then stands for \Omega_2(0)
# Omega1_then stands for \Omega_1(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# R22 stands for R_{22}
# R21 stands for R_{21}
# R12 stands for R_{12}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R22, R21, R12, R11, I3, I2, I1, = symbols("Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R22, R21, R12, R11, I3, I2, I1,")
# p1 = 0 because of what is given: 0 = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
p1 = -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1
q1 = R21*R12*I2 - R22*R11*I1
# p2 = 0 because of what is given: 0 = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
p2 = -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1
q2 = R12*R11*I2 - R12*R11*I1
d = 1
N = -Omega3_then*R23_then*R21*R12*I3*I2 - Omega3_then*R13_then*R12*R11*I3*I2 - Omega2_then*R22_then*R21*R12*I2**2 - Omega2_then*R12_then*R12*R11*I2**2 + Omega3_then*R23_then*R22*R11*I3*I1 + Omega3_then*R13_then*R12*R11*I3*I1 - Omega1_then*R21_then*R21*R12*I2*I1 + Omega2_then*R22_then*R22*R11*I2*I1 + Omega2_then*R12_then*R12*R11*I2*I1 - Omega1_then*R11_then*R12*R11*I2*I1 + Omega1_then*R21_then*R22*R11*I1**2 + Omega1_then*R11_then*R12*R11*I1**2
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 4: \dot{R}_{21} = -(\frac{{\bf m}_3}{I_2}\cdot R_{32}\cdot R_{23}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot R_{33}\cdot R_{22})
# where {\bf m}_3 = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \dot{R}_{21} = (an expression of 132 operations)
# Variables:
# Omega3_then stands for \Omega_3(0)
# Omega2_then stands for \Omega_2(0)
# Omega1_then stands for \Omega_1(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# R23 stands for R_{23}
# R22 stands for R_{22}
# R13 stands for R_{13}
# R12 stands for R_{12}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R23, R22, R13, R12, I3, I2, I1, = symbols("Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R23, R22, R13, R12, I3, I2, I1,")
# p1 = 0 because of what is given: 0 = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
p1 = -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1
q1 = R23*R22*I3 - R23*R22*I2
# p2 = 0 because of what is given: 0 = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
p2 = -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1
q2 = R23*R12*I3 - R22*R13*I2
d = 1
N = -Omega3_then*R23_then*R23*R22*I3**2 - Omega3_then*R13_then*R23*R12*I3**2 + Omega3_then*R23_then*R23*R22*I3*I2 - Omega2_then*R22_then*R23*R22*I3*I2 + Omega3_then*R13_then*R22*R13*I3*I2 - Omega2_then*R12_then*R23*R12*I3*I2 + Omega2_then*R22_then*R23*R22*I2**2 + Omega2_then*R12_then*R22*R13*I2**2 - Omega1_then*R21_then*R23*R22*I3*I1 - Omega1_then*R11_then*R23*R12*I3*I1 + Omega1_then*R21_then*R23*R22*I2*I1 + Omega1_then*R11_then*R22*R13*I2*I1
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 5: \dot{R}_{22} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot R_{31}\cdot R_{23}+\frac{{\bf m}_3}{I_3}\cdot R_{33}\cdot R_{21})
# where {\bf m}_3 = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \dot{R}_{22} = (an expression of 132 operations)
# Variables:
# Omega3_then stands for \Omega_3(0)
# Omega2_then stands for \Omega_2(0)
# Omega1_then stands for \Omega_1(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# R23 stands for R_{23}
# R21 stands for R_{21}
# R13 stands for R_{13}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R23, R21, R13, R11, I3, I2, I1, = symbols("Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R23, R21, R13, R11, I3, I2, I1,")
# p1 = 0 because of what is given: 0 = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
p1 = -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1
q1 = -R23*R21*I3 + R23*R21*I1
# p2 = 0 because of what is given: 0 = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
p2 = -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1
q2 = -R23*R11*I3 + R21*R13*I1
d = 1
N = Omega3_then*R23_then*R23*R21*I3**2 + Omega3_then*R13_then*R23*R11*I3**2 + Omega2_then*R22_then*R23*R21*I3*I2 + Omega2_then*R12_then*R23*R11*I3*I2 - Omega3_then*R23_then*R23*R21*I3*I1 + Omega1_then*R21_then*R23*R21*I3*I1 - Omega3_then*R13_then*R21*R13*I3*I1 + Omega1_then*R11_then*R23*R11*I3*I1 - Omega2_then*R22_then*R23*R21*I2*I1 - Omega2_then*R12_then*R21*R13*I2*I1 - Omega1_then*R21_then*R23*R21*I1**2 - Omega1_then*R11_then*R21*R13*I1**2
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 6: \dot{R}_{23} = -(\frac{{\bf m}_3}{I_1}\cdot R_{31}\cdot R_{22}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot R_{32}\cdot R_{21})
# where {\bf m}_3 = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \dot{R}_{23} = (an expression of 132 operations)
# Variables:
# Omega3_then stands for \Omega_3(0)
# Omega2_then stands for \Omega_2(0)
# Omega1_then stands for \Omega_1(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# R22 stands for R_{22}
# R21 stands for R_{21}
# R12 stands for R_{12}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R22, R21, R12, R11, I3, I2, I1, = symbols("Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R22, R21, R12, R11, I3, I2, I1,")
# p1 = 0 because of what is given: 0 = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
p1 = -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1
q1 = R22*R21*I2 - R22*R21*I1
# p2 = 0 because of what is given: 0 = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
p2 = -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1
q2 = R22*R11*I2 - R21*R12*I1
d = 1
N = -Omega3_then*R23_then*R22*R21*I3*I2 - Omega3_then*R13_then*R22*R11*I3*I2 - Omega2_then*R22_then*R22*R21*I2**2 - Omega2_then*R12_then*R22*R11*I2**2 + Omega3_then*R23_then*R22*R21*I3*I1 + Omega3_then*R13_then*R21*R12*I3*I1 + Omega2_then*R22_then*R22*R21*I2*I1 - Omega1_then*R21_then*R22*R21*I2*I1 + Omega2_then*R12_then*R21*R12*I2*I1 - Omega1_then*R11_then*R22*R11*I2*I1 + Omega1_then*R21_then*R22*R21*I1**2 + Omega1_then*R11_then*R21*R12*I1**2
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 7: \dot{R}_{31} = -(\frac{{\bf m}_3}{I_2}\cdot R_{32}\cdot R_{33}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot R_{33}\cdot R_{32})
# where {\bf m}_3 = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \dot{R}_{31} = (an expression of 132 operations)
# Variables:
# Omega3_then stands for \Omega_3(0)
# Omega2_then stands for \Omega_2(0)
# Omega1_then stands for \Omega_1(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# R33 stands for R_{33}
# R32 stands for R_{32}
# R23 stands for R_{23}
# R22 stands for R_{22}
# R13 stands for R_{13}
# R12 stands for R_{12}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R33, R32, R23, R22, R13, R12, I3, I2, I1, = symbols("Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R33, R32, R23, R22, R13, R12, I3, I2, I1,")
# p1 = 0 because of what is given: 0 = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
p1 = -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1
q1 = R33*R22*I3 - R32*R23*I2
# p2 = 0 because of what is given: 0 = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
p2 = -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1
q2 = R33*R12*I3 - R32*R13*I2
d = 1
N = -Omega3_then*R23_then*R33*R22*I3**2 - Omega3_then*R13_then*R33*R12*I3**2 + Omega3_then*R23_then*R32*R23*I3*I2 - Omega2_then*R22_then*R33*R22*I3*I2 + Omega3_then*R13_then*R32*R13*I3*I2 - Omega2_then*R12_then*R33*R12*I3*I2 + Omega2_then*R22_then*R32*R23*I2**2 + Omega2_then*R12_then*R32*R13*I2**2 - Omega1_then*R21_then*R33*R22*I3*I1 - Omega1_then*R11_then*R33*R12*I3*I1 + Omega1_then*R21_then*R32*R23*I2*I1 + Omega1_then*R11_then*R32*R13*I2*I1
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 8: \dot{R}_{32} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot R_{31}\cdot R_{33}+\frac{{\bf m}_3}{I_3}\cdot R_{33}\cdot R_{31})
# where {\bf m}_3 = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \dot{R}_{32} = (an expression of 132 operations)
# Variables:
# Omega3_then stands for \Omega_3(0)
# Omega2_then stands for \Omega_2(0)
# Omega1_then stands for \Omega_1(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# R33 stands for R_{33}
# R31 stands for R_{31}
# R23 stands for R_{23}
# R21 stands for R_{21}
# R13 stands for R_{13}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R33, R31, R23, R21, R13, R11, I3, I2, I1, = symbols("Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R33, R31, R23, R21, R13, R11, I3, I2, I1,")
# p1 = 0 because of what is given: 0 = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
p1 = -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1
q1 = -R33*R21*I3 + R31*R23*I1
# p2 = 0 because of what is given: 0 = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
p2 = -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1
q2 = -R33*R11*I3 + R31*R13*I1
d = 1
N = Omega3_then*R23_then*R33*R21*I3**2 + Omega3_then*R13_then*R33*R11*I3**2 + Omega2_then*R22_then*R33*R21*I3*I2 + Omega2_then*R12_then*R33*R11*I3*I2 - Omega3_then*R23_then*R31*R23*I3*I1 + Omega1_then*R21_then*R33*R21*I3*I1 - Omega3_then*R13_then*R31*R13*I3*I1 + Omega1_then*R11_then*R33*R11*I3*I1 - Omega2_then*R22_then*R31*R23*I2*I1 - Omega2_then*R12_then*R31*R13*I2*I1 - Omega1_then*R21_then*R31*R23*I1**2 - Omega1_then*R11_then*R31*R13*I1**2
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 9: \dot{R}_{33} = -(\frac{{\bf m}_3}{I_1}\cdot R_{31}\cdot R_{32}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot R_{32}\cdot R_{31})
# where {\bf m}_3 = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \dot{R}_{33} = (an expression of 132 operations)
# Variables:
# Omega3_then stands for \Omega_3(0)
# Omega2_then stands for \Omega_2(0)
# Omega1_then stands for \Omega_1(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# R32 stands for R_{32}
# R31 stands for R_{31}
# R22 stands for R_{22}
# R21 stands for R_{21}
# R12 stands for R_{12}
# R11 stands for R_{11}
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R32, R31, R22, R21, R12, R11, I3, I2, I1, = symbols("Omega3_then, Omega2_then, Omega1_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, R32, R31, R22, R21, R12, R11, I3, I2, I1,")
# p1 = 0 because of what is given: 0 = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
p1 = -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1
q1 = R32*R21*I2 - R31*R22*I1
# p2 = 0 because of what is given: 0 = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
p2 = -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1
q2 = R32*R11*I2 - R31*R12*I1
d = 1
N = -Omega3_then*R23_then*R32*R21*I3*I2 - Omega3_then*R13_then*R32*R11*I3*I2 - Omega2_then*R22_then*R32*R21*I2**2 - Omega2_then*R12_then*R32*R11*I2**2 + Omega3_then*R23_then*R31*R22*I3*I1 + Omega3_then*R13_then*R31*R12*I3*I1 + Omega2_then*R22_then*R31*R22*I2*I1 - Omega1_then*R21_then*R32*R21*I2*I1 + Omega2_then*R12_then*R31*R12*I2*I1 - Omega1_then*R11_then*R32*R11*I2*I1 + Omega1_then*R21_then*R31*R22*I1**2 + Omega1_then*R11_then*R31*R12*I1**2
print(expand(d*N - (q1*p1 + q2*p2)))
