# kepler / areal-velocity: The radius sweeps equal areas in equal times: Kepler's second law, for an orbit in the plane.
#
# Given: the definitions, the assumptions and kepler.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: r^2\cdot \dot{\varphi} = {\bf L}_3
# where r = \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2}
# where {\bf L}_3 = {\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1
# where \dot{\varphi} = \frac{{\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1}{{\bf r}_2^2+{\bf r}_1^2}
# Variables:
# root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2}
# r2_dot stands for \dot{\bf r}_2
# r1_dot stands for \dot{\bf r}_1
# r2 stands for {\bf r}_2
# r1 stands for {\bf r}_1
root, r2_dot, r1_dot, r2, r1, = symbols("root, r2_dot, r1_dot, r2, r1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2 - r2**2 - r1**2
q1 = -r1_dot*r2 + r2_dot*r1
d = 1
N = -root**2*r1_dot*r2 + r1_dot*r2**3 + root**2*r2_dot*r1 - r2_dot*r2**2*r1 + r1_dot*r2*r1**2 - r2_dot*r1**3
print(expand(d*N - (q1*p1)))

# Equation 2: 2\cdot r\cdot \dot{r}\cdot \dot{\varphi}+r^2\cdot \ddot{\varphi} = 0
# where r = \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2}
# where \dot{\varphi} = \frac{{\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1}{{\bf r}_2^2+{\bf r}_1^2}
# where \dot{r} = \frac{\dot{\bf r}_1\cdot {\bf r}_1+\dot{\bf r}_1\cdot {\bf r}_1+(\dot{\bf r}_2\cdot {\bf r}_2+\dot{\bf r}_2\cdot {\bf r}_2)}{2\cdot \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2}}
# where \ddot{\varphi} = (an expression of 73 operations)
# Variables:
# root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2}
# r2_dot stands for \dot{\bf r}_2
# r1_dot stands for \dot{\bf r}_1
# r2 stands for {\bf r}_2
# r1 stands for {\bf r}_1
root, r2_dot, r1_dot, r2, r1, = symbols("root, r2_dot, r1_dot, r2, r1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2 - r2**2 - r1**2
q1 = 4*root**4*r2_dot*r1_dot*r2**4 - 4*root**4*r2_dot**2*r2**3*r1 + 4*root**4*r1_dot**2*r2**3*r1 - 4*root**4*r2_dot**2*r2*r1**3 + 4*root**4*r1_dot**2*r2*r1**3 - 4*root**4*r2_dot*r1_dot*r1**4
d = 1
N = 4*root**6*r2_dot*r1_dot*r2**4 - 4*root**4*r2_dot*r1_dot*r2**6 - 4*root**6*r2_dot**2*r2**3*r1 + 4*root**6*r1_dot**2*r2**3*r1 + 4*root**4*r2_dot**2*r2**5*r1 - 4*root**4*r1_dot**2*r2**5*r1 - 4*root**4*r2_dot*r1_dot*r2**4*r1**2 - 4*root**6*r2_dot**2*r2*r1**3 + 4*root**6*r1_dot**2*r2*r1**3 + 8*root**4*r2_dot**2*r2**3*r1**3 - 8*root**4*r1_dot**2*r2**3*r1**3 - 4*root**6*r2_dot*r1_dot*r1**4 + 4*root**4*r2_dot*r1_dot*r2**2*r1**4 + 4*root**4*r2_dot**2*r2*r1**5 - 4*root**4*r1_dot**2*r2*r1**5 + 4*root**4*r2_dot*r1_dot*r1**6
print(expand(d*N - (q1*p1)))
