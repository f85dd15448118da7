# deriglazov-comment / attitude-products: The products of R with its transpose, and its determinant, do not change, whatever Ω does.
#
# Given: the definitions, the assumptions and t1-attitude.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \dot{R}_{11}\cdot R_{11}+\dot{R}_{11}\cdot R_{11}+(\dot{R}_{12}\cdot R_{12}+\dot{R}_{12}\cdot R_{12})+(\dot{R}_{13}\cdot R_{13}+\dot{R}_{13}\cdot R_{13}) = 0
# where \dot{R}_{11} = -(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12})
# where \dot{R}_{12} = -((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11})
# where \dot{R}_{13} = -(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11})
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 2: \dot{R}_{11}\cdot R_{21}+R_{11}\cdot \dot{R}_{21}+(\dot{R}_{12}\cdot R_{22}+R_{12}\cdot \dot{R}_{22})+(\dot{R}_{13}\cdot R_{23}+R_{13}\cdot \dot{R}_{23}) = 0
# where \dot{R}_{11} = -(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12})
# where \dot{R}_{12} = -((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11})
# where \dot{R}_{13} = -(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11})
# where \dot{R}_{21} = -(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22})
# where \dot{R}_{22} = -((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21})
# where \dot{R}_{23} = -(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21})
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 3: \dot{R}_{11}\cdot R_{31}+R_{11}\cdot \dot{R}_{31}+(\dot{R}_{12}\cdot R_{32}+R_{12}\cdot \dot{R}_{32})+(\dot{R}_{13}\cdot R_{33}+R_{13}\cdot \dot{R}_{33}) = 0
# where \dot{R}_{11} = -(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12})
# where \dot{R}_{12} = -((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11})
# where \dot{R}_{13} = -(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11})
# where \dot{R}_{31} = -(\Omega_2\cdot R_{33}+(-1)\cdot \Omega_3\cdot R_{32})
# where \dot{R}_{32} = -((-1)\cdot \Omega_1\cdot R_{33}+\Omega_3\cdot R_{31})
# where \dot{R}_{33} = -(\Omega_1\cdot R_{32}+(-1)\cdot \Omega_2\cdot R_{31})
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 4: \dot{R}_{11}\cdot R_{21}+R_{11}\cdot \dot{R}_{21}+(\dot{R}_{12}\cdot R_{22}+R_{12}\cdot \dot{R}_{22})+(\dot{R}_{13}\cdot R_{23}+R_{13}\cdot \dot{R}_{23}) = 0
# where \dot{R}_{11} = -(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12})
# where \dot{R}_{12} = -((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11})
# where \dot{R}_{13} = -(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11})
# where \dot{R}_{21} = -(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22})
# where \dot{R}_{22} = -((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21})
# where \dot{R}_{23} = -(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21})
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 5: \dot{R}_{21}\cdot R_{21}+\dot{R}_{21}\cdot R_{21}+(\dot{R}_{22}\cdot R_{22}+\dot{R}_{22}\cdot R_{22})+(\dot{R}_{23}\cdot R_{23}+\dot{R}_{23}\cdot R_{23}) = 0
# where \dot{R}_{21} = -(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22})
# where \dot{R}_{22} = -((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21})
# where \dot{R}_{23} = -(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21})
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 6: \dot{R}_{21}\cdot R_{31}+R_{21}\cdot \dot{R}_{31}+(\dot{R}_{22}\cdot R_{32}+R_{22}\cdot \dot{R}_{32})+(\dot{R}_{23}\cdot R_{33}+R_{23}\cdot \dot{R}_{33}) = 0
# where \dot{R}_{21} = -(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22})
# where \dot{R}_{22} = -((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21})
# where \dot{R}_{23} = -(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21})
# where \dot{R}_{31} = -(\Omega_2\cdot R_{33}+(-1)\cdot \Omega_3\cdot R_{32})
# where \dot{R}_{32} = -((-1)\cdot \Omega_1\cdot R_{33}+\Omega_3\cdot R_{31})
# where \dot{R}_{33} = -(\Omega_1\cdot R_{32}+(-1)\cdot \Omega_2\cdot R_{31})
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 7: \dot{R}_{11}\cdot R_{31}+R_{11}\cdot \dot{R}_{31}+(\dot{R}_{12}\cdot R_{32}+R_{12}\cdot \dot{R}_{32})+(\dot{R}_{13}\cdot R_{33}+R_{13}\cdot \dot{R}_{33}) = 0
# where \dot{R}_{11} = -(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12})
# where \dot{R}_{12} = -((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11})
# where \dot{R}_{13} = -(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11})
# where \dot{R}_{31} = -(\Omega_2\cdot R_{33}+(-1)\cdot \Omega_3\cdot R_{32})
# where \dot{R}_{32} = -((-1)\cdot \Omega_1\cdot R_{33}+\Omega_3\cdot R_{31})
# where \dot{R}_{33} = -(\Omega_1\cdot R_{32}+(-1)\cdot \Omega_2\cdot R_{31})
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 8: \dot{R}_{21}\cdot R_{31}+R_{21}\cdot \dot{R}_{31}+(\dot{R}_{22}\cdot R_{32}+R_{22}\cdot \dot{R}_{32})+(\dot{R}_{23}\cdot R_{33}+R_{23}\cdot \dot{R}_{33}) = 0
# where \dot{R}_{21} = -(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22})
# where \dot{R}_{22} = -((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21})
# where \dot{R}_{23} = -(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21})
# where \dot{R}_{31} = -(\Omega_2\cdot R_{33}+(-1)\cdot \Omega_3\cdot R_{32})
# where \dot{R}_{32} = -((-1)\cdot \Omega_1\cdot R_{33}+\Omega_3\cdot R_{31})
# where \dot{R}_{33} = -(\Omega_1\cdot R_{32}+(-1)\cdot \Omega_2\cdot R_{31})
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 9: \dot{R}_{31}\cdot R_{31}+\dot{R}_{31}\cdot R_{31}+(\dot{R}_{32}\cdot R_{32}+\dot{R}_{32}\cdot R_{32})+(\dot{R}_{33}\cdot R_{33}+\dot{R}_{33}\cdot R_{33}) = 0
# where \dot{R}_{31} = -(\Omega_2\cdot R_{33}+(-1)\cdot \Omega_3\cdot R_{32})
# where \dot{R}_{32} = -((-1)\cdot \Omega_1\cdot R_{33}+\Omega_3\cdot R_{31})
# where \dot{R}_{33} = -(\Omega_1\cdot R_{32}+(-1)\cdot \Omega_2\cdot R_{31})
d = 1
N = 0
print(expand(d*N - (0)))

# Equation 10: (an expression of 113 operations) = 0
# where \dot{R}_{11} = -(\Omega_2\cdot R_{13}+(-1)\cdot \Omega_3\cdot R_{12})
# where \dot{R}_{12} = -((-1)\cdot \Omega_1\cdot R_{13}+\Omega_3\cdot R_{11})
# where \dot{R}_{13} = -(\Omega_1\cdot R_{12}+(-1)\cdot \Omega_2\cdot R_{11})
# where \dot{R}_{21} = -(\Omega_2\cdot R_{23}+(-1)\cdot \Omega_3\cdot R_{22})
# where \dot{R}_{22} = -((-1)\cdot \Omega_1\cdot R_{23}+\Omega_3\cdot R_{21})
# where \dot{R}_{23} = -(\Omega_1\cdot R_{22}+(-1)\cdot \Omega_2\cdot R_{21})
# where \dot{R}_{31} = -(\Omega_2\cdot R_{33}+(-1)\cdot \Omega_3\cdot R_{32})
# where \dot{R}_{32} = -((-1)\cdot \Omega_1\cdot R_{33}+\Omega_3\cdot R_{31})
# where \dot{R}_{33} = -(\Omega_1\cdot R_{32}+(-1)\cdot \Omega_2\cdot R_{31})
d = 1
N = 0
print(expand(d*N - (0)))
