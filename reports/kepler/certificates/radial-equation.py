# kepler / radial-equation: The distance obeys an equation of its own, with the centrifugal term.
#
# Given: the definitions, the assumptions and kepler.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \ddot{r} = \frac{{\bf L}_1\cdot {\bf L}_1+{\bf L}_2\cdot {\bf L}_2+{\bf L}_3\cdot {\bf L}_3}{r^3}-\frac{\mu}{r^2}
# where r = \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
# where {\bf L}_1 = {\bf r}_2\cdot \dot{\bf r}_3-{\bf r}_3\cdot \dot{\bf r}_2
# where {\bf L}_2 = {\bf r}_3\cdot \dot{\bf r}_1-{\bf r}_1\cdot \dot{\bf r}_3
# where {\bf L}_3 = {\bf r}_1\cdot \dot{\bf r}_2-{\bf r}_2\cdot \dot{\bf r}_1
# where \ddot{r} = (an expression of 244 operations)
# Variables:
# root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
# r3_dot stands for \dot{\bf r}_3
# r2_dot stands for \dot{\bf r}_2
# r1_dot stands for \dot{\bf r}_1
# mu stands for \mu
# r3 stands for {\bf r}_3
# r2 stands for {\bf r}_2
# r1 stands for {\bf r}_1
root, r3_dot, r2_dot, r1_dot, mu, r3, r2, r1, = symbols("root, r3_dot, r2_dot, r1_dot, mu, r3, r2, r1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2 - r3**2 - r2**2 - r1**2
q1 = 8*root**8*r3_dot**2 + 8*root**8*r2_dot**2 + 8*root**8*r1_dot**2 + 8*root**7*mu
d = 1
N = 8*root**10*r3_dot**2 + 8*root**10*r2_dot**2 + 8*root**10*r1_dot**2 - 8*root**8*r3_dot**2*r3**2 - 8*root**8*r2_dot**2*r3**2 - 8*root**8*r1_dot**2*r3**2 - 8*root**8*r3_dot**2*r2**2 - 8*root**8*r2_dot**2*r2**2 - 8*root**8*r1_dot**2*r2**2 - 8*root**8*r3_dot**2*r1**2 - 8*root**8*r2_dot**2*r1**2 - 8*root**8*r1_dot**2*r1**2 + 8*root**9*mu - 8*root**7*mu*r3**2 - 8*root**7*mu*r2**2 - 8*root**7*mu*r1**2
print(expand(d*N - (q1*p1)))
