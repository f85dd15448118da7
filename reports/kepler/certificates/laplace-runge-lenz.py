# kepler / laplace-runge-lenz: The Laplace–Runge–Lenz vector does not change, and lies in the plane of the orbit.
#
# Given: the definitions, the assumptions and kepler.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: {\bf A}_1\cdot {\bf L}_1+{\bf A}_2\cdot {\bf L}_2+{\bf A}_3\cdot {\bf L}_3 = 0
# where {\bf L}_1 = {\bf r}_2\cdot \dot{\bf r}_3-{\bf r}_3\cdot \dot{\bf r}_2
# where {\bf L}_2 = {\bf r}_3\cdot \dot{\bf r}_1-{\bf r}_1\cdot \dot{\bf r}_3
# where {\bf L}_3 = {\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1
# where {\bf A}_1 = \dot{\bf r}_2\cdot ({\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1)-\dot{\bf r}_3\cdot ({\bf r}_3\cdot \dot{\bf r}_1-{\bf r}_1\cdot \dot{\bf r}_3)-\frac{\mu}{\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}}\cdot {\bf r}_1
# where {\bf A}_2 = \dot{\bf r}_3\cdot ({\bf r}_2\cdot \dot{\bf r}_3-{\bf r}_3\cdot \dot{\bf r}_2)-\dot{\bf r}_1\cdot ({\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1)-\frac{\mu}{\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}}\cdot {\bf r}_2
# where {\bf A}_3 = \dot{\bf r}_1\cdot ({\bf r}_3\cdot \dot{\bf r}_1-{\bf r}_1\cdot \dot{\bf r}_3)-\dot{\bf r}_2\cdot ({\bf r}_2\cdot \dot{\bf r}_3-{\bf r}_3\cdot \dot{\bf r}_2)-\frac{\mu}{\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}}\cdot {\bf r}_3
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: \dot{\bf A}_1 = 0
# where \dot{\bf A}_1 = (an expression of 244 operations)
# Variables:
# root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
# r1_dot stands for \dot{\bf r}_1
# mu stands for \mu
# r3 stands for {\bf r}_3
# r2 stands for {\bf r}_2
# r1 stands for {\bf r}_1
root, r1_dot, mu, r3, r2, r1, = symbols("root, r1_dot, mu, r3, r2, r1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2 - r3**2 - r2**2 - r1**2
q1 = -2*root**4*r1_dot*mu
d = 1
N = -2*root**6*r1_dot*mu + 2*root**4*r1_dot*mu*r3**2 + 2*root**4*r1_dot*mu*r2**2 + 2*root**4*r1_dot*mu*r1**2
print(expand(d*N - (q1*p1)))

# Equation 3: \dot{\bf A}_2 = 0
# where \dot{\bf A}_2 = (an expression of 244 operations)
# Variables:
# root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
# r2_dot stands for \dot{\bf r}_2
# mu stands for \mu
# r3 stands for {\bf r}_3
# r2 stands for {\bf r}_2
# r1 stands for {\bf r}_1
root, r2_dot, mu, r3, r2, r1, = symbols("root, r2_dot, mu, r3, r2, r1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2 - r3**2 - r2**2 - r1**2
q1 = -2*root**4*r2_dot*mu
d = 1
N = -2*root**6*r2_dot*mu + 2*root**4*r2_dot*mu*r3**2 + 2*root**4*r2_dot*mu*r2**2 + 2*root**4*r2_dot*mu*r1**2
print(expand(d*N - (q1*p1)))

# Equation 4: \dot{\bf A}_3 = 0
# where \dot{\bf A}_3 = (an expression of 244 operations)
# Variables:
# root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
# r3_dot stands for \dot{\bf r}_3
# mu stands for \mu
# r3 stands for {\bf r}_3
# r2 stands for {\bf r}_2
# r1 stands for {\bf r}_1
root, r3_dot, mu, r3, r2, r1, = symbols("root, r3_dot, mu, r3, r2, r1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2 - r3**2 - r2**2 - r1**2
q1 = -2*root**4*r3_dot*mu
d = 1
N = -2*root**6*r3_dot*mu + 2*root**4*r3_dot*mu*r3**2 + 2*root**4*r3_dot*mu*r2**2 + 2*root**4*r3_dot*mu*r1**2
print(expand(d*N - (q1*p1)))
