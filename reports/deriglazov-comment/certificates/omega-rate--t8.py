# deriglazov-comment / omega-rate/t8: In t8.
#
# Given: the definitions, the assumptions and t8, omega-of-m.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \omega = \frac{{\bf m}_3}{I_3}
# where \omega = (an expression of 167 operations)
# where \frac{1}{I_3} is not 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: {\bf w}_1 = 0
# where {\bf w}_1 = (an expression of 210 operations)
# where \frac{1}{I_3} is not 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 3: {\bf w}_2 = 0
# where {\bf w}_2 = (an expression of 209 operations)
# where \frac{1}{I_3} is not 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 4: {\bf w}_3 = \omega
# where {\bf w}_3 = (an expression of 167 operations)
# where \omega = (an expression of 167 operations)
# where \frac{1}{I_3} is not 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 5: \dot{\omega} = 0
# where \dot{\omega} = (an expression of 417 operations)
# where \frac{1}{I_3} is not 0
d = 1
N = 0
print(expand(d*N - (0)))
