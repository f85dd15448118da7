# kepler / angular-momentum: The angular momentum does not change.
#
# Given: the definitions, the assumptions and kepler.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \dot{\bf L}_1 = 0
# where \dot{\bf L}_1 = \dot{\bf r}_2\cdot \dot{\bf r}_3+{\bf r}_2\cdot (-\frac{\mu}{(\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3})^{3}}\cdot {\bf r}_3)-(\dot{\bf r}_2\cdot \dot{\bf r}_3+{\bf r}_3\cdot (-\frac{\mu}{(\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3})^{3}}\cdot {\bf r}_2))
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: \dot{\bf L}_2 = 0
# where \dot{\bf L}_2 = \dot{\bf r}_3\cdot \dot{\bf r}_1+{\bf r}_3\cdot (-\frac{\mu}{(\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3})^{3}}\cdot {\bf r}_1)-(\dot{\bf r}_3\cdot \dot{\bf r}_1+{\bf r}_1\cdot (-\frac{\mu}{(\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3})^{3}}\cdot {\bf r}_3))
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 3: \dot{\bf L}_3 = 0
# where \dot{\bf L}_3 = \dot{\bf r}_1\cdot \dot{\bf r}_2+{\bf r}_1\cdot (-\frac{\mu}{(\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3})^{3}}\cdot {\bf r}_2)-(\dot{\bf r}_1\cdot \dot{\bf r}_2+{\bf r}_2\cdot (-\frac{\mu}{(\sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3})^{3}}\cdot {\bf r}_1))
d = 1
N = 0
print(expand(d*N - (0)))
