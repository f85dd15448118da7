# kepler / eccentricity-and-energy: The length of the Laplace–Runge–Lenz vector follows from energy and angular momentum.
#
# Given: the definitions, the assumptions and kepler.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: {\bf A}_1\cdot {\bf A}_1+{\bf A}_2\cdot {\bf A}_2+{\bf A}_3\cdot {\bf A}_3 = \mu^2+(2\cdot h\cdot {\bf L}_1\cdot {\bf L}_1+2\cdot h\cdot {\bf L}_2\cdot {\bf L}_2+2\cdot h\cdot {\bf L}_3\cdot {\bf L}_3)
# where {\bf L}_1 = {\bf r}_2\cdot \dot{\bf r}_3-{\bf r}_3\cdot \dot{\bf r}_2
# where {\bf L}_2 = {\bf r}_3\cdot \dot{\bf r}_1-{\bf r}_1\cdot \dot{\bf r}_3
# where {\bf L}_3 = {\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1
# where h = \frac{1}{2}\cdot \dot{\bf r}_1\cdot \dot{\bf r}_1+\frac{1}{2}\cdot \dot{\bf r}_2\cdot \dot{\bf r}_2+\frac{1}{2}\cdot \dot{\bf r}_3\cdot \dot{\bf r}_3-\frac{\mu}{\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}}
# where {\bf A}_1 = \dot{\bf r}_2\cdot ({\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1)-\dot{\bf r}_3\cdot ({\bf r}_3\cdot \dot{\bf r}_1-{\bf r}_1\cdot \dot{\bf r}_3)-\frac{\mu}{\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}}\cdot {\bf r}_1
# where {\bf A}_2 = \dot{\bf r}_3\cdot ({\bf r}_2\cdot \dot{\bf r}_3-{\bf r}_3\cdot \dot{\bf r}_2)-\dot{\bf r}_1\cdot ({\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1)-\frac{\mu}{\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}}\cdot {\bf r}_2
# where {\bf A}_3 = \dot{\bf r}_1\cdot ({\bf r}_3\cdot \dot{\bf r}_1-{\bf r}_1\cdot \dot{\bf r}_3)-\dot{\bf r}_2\cdot ({\bf r}_2\cdot \dot{\bf r}_3-{\bf r}_3\cdot \dot{\bf r}_2)-\frac{\mu}{\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}}\cdot {\bf r}_3
# Variables:
# root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
# mu stands for \mu
# r3 stands for {\bf r}_3
# r2 stands for {\bf r}_2
# r1 stands for {\bf r}_1
root, mu, r3, r2, r1, = symbols("root, mu, r3, r2, r1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2 - r3**2 - r2**2 - r1**2
q1 = -2*root*mu**2
d = 1
N = -2*root**3*mu**2 + 2*root*mu**2*r3**2 + 2*root*mu**2*r2**2 + 2*root*mu**2*r1**2
print(expand(d*N - (q1*p1)))
