# deriglazov-comment / t15-integral: What the rate of θ integrates to: tan²(θ/2) grows by a constant exponential.
#
# Given: the definitions, the assumptions and reduced-theta, momentum.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: (an expression of 90 operations) = 0
# where \dot{\theta} = \frac{1}{2}\cdot {\bf m}_3(0)\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \psi(0))\cdot \sin(\theta)
# Variables:
# exp stands for \exp((I_2)^{-1}\cdot t\cdot {\bf m}_3(0)\cdot \sin(2\cdot \psi(0)))
# exp_2 stands for \exp((I_1)^{-1}\cdot t\cdot {\bf m}_3(0)\cdot \sin(2\cdot \psi(0)))
# sin_psi_then stands for \sin(\psi(0))
# cos_psi_then stands for \cos(\psi(0))
# sin stands for \sin(\frac{1}{2}\cdot \theta)
# cos stands for \cos(\frac{1}{2}\cdot \theta)
# m3_then stands for {\bf m}_3(0)
# I2 stands for I_2
# I1 stands for I_1
exp, exp_2, sin_psi_then, cos_psi_then, sin, cos, m3_then, I2, I1, = symbols("exp, exp_2, sin_psi_then, cos_psi_then, sin, cos, m3_then, I2, I1,")
# p1 = 0 because of what the variables stand for: c² + s² = 1
p1 = sin**2 + cos**2 - 1
q1 = 16*exp*exp_2*sin_psi_then*cos_psi_then*sin**2*cos**3*m3_then*I2**2*I1 - 16*exp*exp_2*sin_psi_then*cos_psi_then*sin**2*cos**3*m3_then*I2*I1**2
d = 1
N = 16*exp*exp_2*sin_psi_then*cos_psi_then*sin**4*cos**3*m3_then*I2**2*I1 + 16*exp*exp_2*sin_psi_then*cos_psi_then*sin**2*cos**5*m3_then*I2**2*I1 - 16*exp*exp_2*sin_psi_then*cos_psi_then*sin**4*cos**3*m3_then*I2*I1**2 - 16*exp*exp_2*sin_psi_then*cos_psi_then*sin**2*cos**5*m3_then*I2*I1**2 - 16*exp*exp_2*sin_psi_then*cos_psi_then*sin**2*cos**3*m3_then*I2**2*I1 + 16*exp*exp_2*sin_psi_then*cos_psi_then*sin**2*cos**3*m3_then*I2*I1**2
print(expand(d*N - (q1*p1)))
