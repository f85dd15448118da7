# deriglazov-comment / start-velocity/none-is-forbidden: Every Ω(0) is allowed: it fixes m, and m fixes it back through R(0).
#
# Given: the definitions, the assumptions and omega-of-m, momentum, start-is-a-rotation.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: {\bf m}_1(0) = R_{11}(0)\cdot (I_1\cdot \Omega_1(0))+R_{12}(0)\cdot (I_2\cdot \Omega_2(0))+R_{13}(0)\cdot (I_3\cdot \Omega_3(0))
# where \Omega_1(0) = \frac{1}{I_1}\cdot (R_{11}(0)\cdot {\bf m}_1(0)+R_{21}(0)\cdot {\bf m}_2(0)+R_{31}(0)\cdot {\bf m}_3(0))
# where \Omega_2(0) = \frac{1}{I_2}\cdot (R_{12}(0)\cdot {\bf m}_1(0)+R_{22}(0)\cdot {\bf m}_2(0)+R_{32}(0)\cdot {\bf m}_3(0))
# where \Omega_3(0) = \frac{1}{I_3}\cdot (R_{13}(0)\cdot {\bf m}_1(0)+R_{23}(0)\cdot {\bf m}_2(0)+R_{33}(0)\cdot {\bf m}_3(0))
# Variables:
# R33_then stands for R_{33}(0)
# R32_then stands for R_{32}(0)
# R31_then stands for R_{31}(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# m3_then stands for {\bf m}_3(0)
# m2_then stands for {\bf m}_2(0)
# m1_then stands for {\bf m}_1(0)
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
R33_then, R32_then, R31_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, m3_then, m2_then, m1_then, I3, I2, I1, = symbols("R33_then, R32_then, R31_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, m3_then, m2_then, m1_then, I3, I2, I1,")
# p1 = 0 because of what is given: R_{11}(0)\cdot R_{11}(0)+R_{12}(0)\cdot R_{12}(0)+R_{13}(0)\cdot R_{13}(0) = 1
p1 = R13_then**2 + R12_then**2 + R11_then**2 - 1
q1 = -m1_then*I3*I2*I1
# p2 = 0 because of what is given: R_{11}(0)\cdot R_{21}(0)+R_{12}(0)\cdot R_{22}(0)+R_{13}(0)\cdot R_{23}(0) = 0
p2 = R23_then*R13_then + R22_then*R12_then + R21_then*R11_then
q2 = -m2_then*I3*I2*I1
# p3 = 0 because of what is given: R_{11}(0)\cdot R_{31}(0)+R_{12}(0)\cdot R_{32}(0)+R_{13}(0)\cdot R_{33}(0) = 0
p3 = R33_then*R13_then + R32_then*R12_then + R31_then*R11_then
q3 = -m3_then*I3*I2*I1
d = 1
N = -R33_then*R13_then*m3_then*I3*I2*I1 - R32_then*R12_then*m3_then*I3*I2*I1 - R31_then*R11_then*m3_then*I3*I2*I1 - R23_then*R13_then*m2_then*I3*I2*I1 - R22_then*R12_then*m2_then*I3*I2*I1 - R21_then*R11_then*m2_then*I3*I2*I1 - R13_then**2*m1_then*I3*I2*I1 - R12_then**2*m1_then*I3*I2*I1 - R11_then**2*m1_then*I3*I2*I1 + m1_then*I3*I2*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))

# Equation 2: {\bf m}_2(0) = R_{21}(0)\cdot (I_1\cdot \Omega_1(0))+R_{22}(0)\cdot (I_2\cdot \Omega_2(0))+R_{23}(0)\cdot (I_3\cdot \Omega_3(0))
# where \Omega_1(0) = \frac{1}{I_1}\cdot (R_{11}(0)\cdot {\bf m}_1(0)+R_{21}(0)\cdot {\bf m}_2(0)+R_{31}(0)\cdot {\bf m}_3(0))
# where \Omega_2(0) = \frac{1}{I_2}\cdot (R_{12}(0)\cdot {\bf m}_1(0)+R_{22}(0)\cdot {\bf m}_2(0)+R_{32}(0)\cdot {\bf m}_3(0))
# where \Omega_3(0) = \frac{1}{I_3}\cdot (R_{13}(0)\cdot {\bf m}_1(0)+R_{23}(0)\cdot {\bf m}_2(0)+R_{33}(0)\cdot {\bf m}_3(0))
# Variables:
# R33_then stands for R_{33}(0)
# R32_then stands for R_{32}(0)
# R31_then stands for R_{31}(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# m3_then stands for {\bf m}_3(0)
# m2_then stands for {\bf m}_2(0)
# m1_then stands for {\bf m}_1(0)
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
R33_then, R32_then, R31_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, m3_then, m2_then, m1_then, I3, I2, I1, = symbols("R33_then, R32_then, R31_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, m3_then, m2_then, m1_then, I3, I2, I1,")
# p1 = 0 because of what is given: R_{11}(0)\cdot R_{21}(0)+R_{12}(0)\cdot R_{22}(0)+R_{13}(0)\cdot R_{23}(0) = 0
p1 = R23_then*R13_then + R22_then*R12_then + R21_then*R11_then
q1 = -m1_then*I3*I2*I1
# p2 = 0 because of what is given: R_{21}(0)\cdot R_{21}(0)+R_{22}(0)\cdot R_{22}(0)+R_{23}(0)\cdot R_{23}(0) = 1
p2 = R23_then**2 + R22_then**2 + R21_then**2 - 1
q2 = -m2_then*I3*I2*I1
# p3 = 0 because of what is given: R_{21}(0)\cdot R_{31}(0)+R_{22}(0)\cdot R_{32}(0)+R_{23}(0)\cdot R_{33}(0) = 0
p3 = R33_then*R23_then + R32_then*R22_then + R31_then*R21_then
q3 = -m3_then*I3*I2*I1
d = 1
N = -R33_then*R23_then*m3_then*I3*I2*I1 - R32_then*R22_then*m3_then*I3*I2*I1 - R31_then*R21_then*m3_then*I3*I2*I1 - R23_then**2*m2_then*I3*I2*I1 - R22_then**2*m2_then*I3*I2*I1 - R21_then**2*m2_then*I3*I2*I1 - R23_then*R13_then*m1_then*I3*I2*I1 - R22_then*R12_then*m1_then*I3*I2*I1 - R21_then*R11_then*m1_then*I3*I2*I1 + m2_then*I3*I2*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))

# Equation 3: {\bf m}_3(0) = R_{31}(0)\cdot (I_1\cdot \Omega_1(0))+R_{32}(0)\cdot (I_2\cdot \Omega_2(0))+R_{33}(0)\cdot (I_3\cdot \Omega_3(0))
# where \Omega_1(0) = \frac{1}{I_1}\cdot (R_{11}(0)\cdot {\bf m}_1(0)+R_{21}(0)\cdot {\bf m}_2(0)+R_{31}(0)\cdot {\bf m}_3(0))
# where \Omega_2(0) = \frac{1}{I_2}\cdot (R_{12}(0)\cdot {\bf m}_1(0)+R_{22}(0)\cdot {\bf m}_2(0)+R_{32}(0)\cdot {\bf m}_3(0))
# where \Omega_3(0) = \frac{1}{I_3}\cdot (R_{13}(0)\cdot {\bf m}_1(0)+R_{23}(0)\cdot {\bf m}_2(0)+R_{33}(0)\cdot {\bf m}_3(0))
# Variables:
# R33_then stands for R_{33}(0)
# R32_then stands for R_{32}(0)
# R31_then stands for R_{31}(0)
# R23_then stands for R_{23}(0)
# R22_then stands for R_{22}(0)
# R21_then stands for R_{21}(0)
# R13_then stands for R_{13}(0)
# R12_then stands for R_{12}(0)
# R11_then stands for R_{11}(0)
# m3_then stands for {\bf m}_3(0)
# m2_then stands for {\bf m}_2(0)
# m1_then stands for {\bf m}_1(0)
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
R33_then, R32_then, R31_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, m3_then, m2_then, m1_then, I3, I2, I1, = symbols("R33_then, R32_then, R31_then, R23_then, R22_then, R21_then, R13_then, R12_then, R11_then, m3_then, m2_then, m1_then, I3, I2, I1,")
# p1 = 0 because of what is given: R_{11}(0)\cdot R_{31}(0)+R_{12}(0)\cdot R_{32}(0)+R_{13}(0)\cdot R_{33}(0) = 0
p1 = R33_then*R13_then + R32_then*R12_then + R31_then*R11_then
q1 = -m1_then*I3*I2*I1
# p2 = 0 because of what is given: R_{21}(0)\cdot R_{31}(0)+R_{22}(0)\cdot R_{32}(0)+R_{23}(0)\cdot R_{33}(0) = 0
p2 = R33_then*R23_then + R32_then*R22_then + R31_then*R21_then
q2 = -m2_then*I3*I2*I1
# p3 = 0 because of what is given: R_{31}(0)\cdot R_{31}(0)+R_{32}(0)\cdot R_{32}(0)+R_{33}(0)\cdot R_{33}(0) = 1
p3 = R33_then**2 + R32_then**2 + R31_then**2 - 1
q3 = -m3_then*I3*I2*I1
d = 1
N = -R33_then**2*m3_then*I3*I2*I1 - R32_then**2*m3_then*I3*I2*I1 - R31_then**2*m3_then*I3*I2*I1 - R33_then*R23_then*m2_then*I3*I2*I1 - R32_then*R22_then*m2_then*I3*I2*I1 - R31_then*R21_then*m2_then*I3*I2*I1 - R33_then*R13_then*m1_then*I3*I2*I1 - R32_then*R12_then*m1_then*I3*I2*I1 - R31_then*R11_then*m1_then*I3*I2*I1 + m3_then*I3*I2*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3)))
