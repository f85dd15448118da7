# deriglazov-comment / psi0-in-t9: ψ = ψ₀ satisfies the last equation of t9, whatever θ does.
#
# Given: the definitions, the assumptions and psi0-formula.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: 0 = -(\frac{{\bf m}_3}{I_1}\cdot (\sin(\arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))^{2}+\frac{{\bf m}_3}{I_2}\cdot (\cos(\arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))^{2})\cdot \cos(\theta)+\frac{{\bf m}_3}{I_3}\cdot \cos(\theta)
# Variables:
# root stands for \sqrt{1-(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})^{2}}
# root_2 stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
# cos_theta stands for \cos(\theta)
# m3 stands for {\bf m}_3
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
root, root_2, cos_theta, m3, I3, I2, I1, = symbols("root, root_2, cos_theta, m3, I3, I2, I1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2 + root_2**2 - 1
q1 = cos_theta*m3*I3*I2
# p2 = 0 because of what the variables stand for: a root is squared
p2 = root_2**2*I3*I2 - root_2**2*I3*I1 - I3*I2 + I2*I1
q2 = -cos_theta*m3
d = 1
N = root**2*cos_theta*m3*I3*I2 + root_2**2*cos_theta*m3*I3*I1 - cos_theta*m3*I2*I1
print(expand(d*N - (q1*p1 + q2*p2)))
