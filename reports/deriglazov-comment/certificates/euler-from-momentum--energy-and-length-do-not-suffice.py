# deriglazov-comment / euler-from-momentum/energy-and-length-do-not-suffice: The conservation of E and of the length of m would not do in place of m: they are conserved whatever the sign or size of the bracket.
#
# Given: the definitions, the assumptions and euler-poisson.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \Omega_1\cdot (I_2\cdot \Omega_2\cdot \Omega_3-I_3\cdot \Omega_3\cdot \Omega_2)+\Omega_2\cdot (I_3\cdot \Omega_3\cdot \Omega_1-I_1\cdot \Omega_1\cdot \Omega_3)+\Omega_3\cdot (I_1\cdot \Omega_1\cdot \Omega_2-I_2\cdot \Omega_2\cdot \Omega_1) = 0
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: I_1\cdot \Omega_1\cdot (I_2\cdot \Omega_2\cdot \Omega_3-I_3\cdot \Omega_3\cdot \Omega_2)+I_2\cdot \Omega_2\cdot (I_3\cdot \Omega_3\cdot \Omega_1-I_1\cdot \Omega_1\cdot \Omega_3)+I_3\cdot \Omega_3\cdot (I_1\cdot \Omega_1\cdot \Omega_2-I_2\cdot \Omega_2\cdot \Omega_1) = 0
d = 1
N = 0
print(expand(d*N - (0)))
