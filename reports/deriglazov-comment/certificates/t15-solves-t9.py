# deriglazov-comment / t15-solves-t9: The closed forms solve the three equations t9, for every value of the constants c, φ₀, m₃ and every body for which ψ₀ is real.
#
# Given: the definitions, the assumptions and I_{(n-k)}.
#
# Each equation below is proved by an identity of polynomials, d*N = q1*p1 + q2*p2 + ...
# N is the difference of its sides, without its denominator. Every p is 0 where what is given holds,
# and d is not 0 there, where the formulas have a value. So N is 0 there, and the equation holds.
# Run with Python and SymPy, this file prints one 0 for each equation.

from sympy import expand, symbols

# Equation 1: \cos(\theta) = \frac{1-\gamma\cdot \exp(2\cdot (\frac{1}{2}\cdot \mu\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot t)}{1+\gamma\cdot \exp(2\cdot (\frac{1}{2}\cdot \mu\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot t)}
# where \theta = 2\cdot \arctan(\sqrt{\gamma}\cdot \exp(\frac{1}{2}\cdot \mu\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}))\cdot t))
# Variables:
# root stands for \sqrt{1+(\sqrt{\gamma}\cdot (\exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot (\exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}))))^{-1}))^{2}}
# root_3 stands for \sqrt{\gamma}
# exp stands for \exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
# exp_2 stands for \exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
# gamma stands for \gamma
root, root_3, exp, exp_2, gamma, = symbols("root, root_3, exp, exp_2, gamma,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2*exp**2 - root_3**2*exp_2**2 - exp**2
q1 = root**2*exp**2*exp_2**2*gamma - root**2*exp**4
# p2 = 0 because of what the variables stand for: a root is squared
p2 = root_3**2 - gamma
q2 = -2*root**2*exp**4*exp_2**2
d = 1
N = root**4*exp**4*exp_2**2*gamma - root**2*root_3**2*exp**2*exp_2**4*gamma - root**4*exp**6 - root**2*root_3**2*exp**4*exp_2**2 + root**2*exp**4*exp_2**2*gamma + root**2*exp**6
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 2: \dot{\theta} = \mu\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(\theta)\cdot \sin(\psi)\cdot \cos(\psi)
# where \theta = 2\cdot \arctan(\sqrt{\gamma}\cdot \exp(\frac{1}{2}\cdot \mu\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}))\cdot t))
# where \dot{\theta} = (an expression of 103 operations)
# where \psi = \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})
# Variables:
# root stands for \sqrt{1+(\sqrt{\gamma}\cdot (\exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot (\exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}))))^{-1}))^{2}}
# root_2 stands for \sqrt{1-(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})^{2}}
# root_3 stands for \sqrt{\gamma}
# root_4 stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
# exp stands for \exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
# exp_2 stands for \exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
# mu stands for \mu
# I2 stands for I_2
# I1 stands for I_1
root, root_2, root_3, root_4, exp, exp_2, mu, I2, I1, = symbols("root, root_2, root_3, root_4, exp, exp_2, mu, I2, I1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2*exp**2 - root_3**2*exp_2**2 - exp**2
q1 = 4*root_2*root_3*root_4*exp*exp_2*mu*I2**2*I1 - 4*root_2*root_3*root_4*exp*exp_2*mu*I2*I1**2
d = 1
N = 4*root**2*root_2*root_3*root_4*exp**3*exp_2*mu*I2**2*I1 - 4*root_2*root_3**3*root_4*exp*exp_2**3*mu*I2**2*I1 - 4*root**2*root_2*root_3*root_4*exp**3*exp_2*mu*I2*I1**2 + 4*root_2*root_3**3*root_4*exp*exp_2**3*mu*I2*I1**2 - 4*root_2*root_3*root_4*exp**3*exp_2*mu*I2**2*I1 + 4*root_2*root_3*root_4*exp**3*exp_2*mu*I2*I1**2
print(expand(d*N - (q1*p1)))

# Equation 3: \dot{\varphi} = \frac{\mu}{I_1}\cdot (\sin(\psi))^{2}+\frac{\mu}{I_2}\cdot (\cos(\psi))^{2}
# where \psi = \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})
# where \dot{\varphi} = \frac{\mu}{I_3}
# Variables:
# root_2 stands for \sqrt{1-(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})^{2}}
# root_4 stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
# mu stands for \mu
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
root_2, root_4, mu, I3, I2, I1, = symbols("root_2, root_4, mu, I3, I2, I1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root_2**2 + root_4**2 - 1
q1 = -mu*I3*I2
# p2 = 0 because of what the variables stand for: a root is squared
p2 = root_4**2*I3*I2 - root_4**2*I3*I1 - I3*I2 + I2*I1
q2 = mu
d = 1
N = -root_2**2*mu*I3*I2 - root_4**2*mu*I3*I1 + mu*I2*I1
print(expand(d*N - (q1*p1 + q2*p2)))

# Equation 4: \dot{\psi} = -(\frac{\mu}{I_1}\cdot (\sin(\psi))^{2}+\frac{\mu}{I_2}\cdot (\cos(\psi))^{2})\cdot \cos(\theta)+\frac{\mu}{I_3}\cdot \cos(\theta)
# where \theta = 2\cdot \arctan(\sqrt{\gamma}\cdot \exp(\frac{1}{2}\cdot \mu\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}))\cdot t))
# where \psi = \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})
# where \dot{\psi} = 0
# Variables:
# root stands for \sqrt{1+(\sqrt{\gamma}\cdot (\exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot (\exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}))))^{-1}))^{2}}
# root_2 stands for \sqrt{1-(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})^{2}}
# root_3 stands for \sqrt{\gamma}
# root_4 stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
# exp stands for \exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
# exp_2 stands for \exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
# gamma stands for \gamma
# mu stands for \mu
# I3 stands for I_3
# I2 stands for I_2
# I1 stands for I_1
root, root_2, root_3, root_4, exp, exp_2, gamma, mu, I3, I2, I1, = symbols("root, root_2, root_3, root_4, exp, exp_2, gamma, mu, I3, I2, I1,")
# p1 = 0 because of what the variables stand for: a root is squared
p1 = root**2*exp**2 - root_3**2*exp_2**2 - exp**2
q1 = -root**4*root_2**2*exp_2**2*gamma*mu*I3*I2 - root**4*root_4**2*exp_2**2*gamma*mu*I3*I1 + root**4*root_2**2*exp**2*mu*I3*I2 + root**4*root_4**2*exp**2*mu*I3*I1 + root**4*exp_2**2*gamma*mu*I2*I1 + root**2*root_2**2*exp**2*mu*I3*I2 + root**2*root_4**2*exp**2*mu*I3*I1 - root**4*exp**2*mu*I2*I1 + root_2**2*exp_2**2*gamma*mu*I3*I2 + root_4**2*exp_2**2*gamma*mu*I3*I1 + root_2**2*exp**2*mu*I3*I2 + root_4**2*exp**2*mu*I3*I1 - root**2*exp**2*mu*I2*I1 - exp_2**2*gamma*mu*I2*I1 - exp**2*mu*I2*I1
# p2 = 0 because of what the variables stand for: a root is squared
p2 = root_2**2 + root_4**2 - 1
q2 = -root**4*exp_2**4*gamma**2*mu*I3*I2 + exp_2**4*gamma**2*mu*I3*I2 + 2*exp**2*exp_2**2*gamma*mu*I3*I2 + exp**4*mu*I3*I2
# p3 = 0 because of what the variables stand for: a root is squared
p3 = root_3**2 - gamma
q3 = -root**6*root_2**2*exp**2*exp_2**2*mu*I3*I2 - root**6*root_4**2*exp**2*exp_2**2*mu*I3*I1 - root**4*root_2**2*exp_2**4*gamma*mu*I3*I2 - root**4*root_4**2*exp_2**4*gamma*mu*I3*I1 + root**4*root_2**2*exp**2*exp_2**2*mu*I3*I2 + root**4*root_4**2*exp**2*exp_2**2*mu*I3*I1 + root**6*exp**2*exp_2**2*mu*I2*I1 + root**4*exp_2**4*gamma*mu*I2*I1 + root**2*root_2**2*exp**2*exp_2**2*mu*I3*I2 + root**2*root_4**2*exp**2*exp_2**2*mu*I3*I1 - root**4*exp**2*exp_2**2*mu*I2*I1 + root_2**2*exp_2**4*gamma*mu*I3*I2 + root_4**2*exp_2**4*gamma*mu*I3*I1 + root_2**2*exp**2*exp_2**2*mu*I3*I2 + root_4**2*exp**2*exp_2**2*mu*I3*I1 - root**2*exp**2*exp_2**2*mu*I2*I1 - exp_2**4*gamma*mu*I2*I1 - exp**2*exp_2**2*mu*I2*I1
# p4 = 0 because of what the variables stand for: a root is squared
p4 = root_4**2*I3*I2 - root_4**2*I3*I1 - I3*I2 + I2*I1
q4 = root**4*exp_2**4*gamma**2*mu - exp_2**4*gamma**2*mu - 2*exp**2*exp_2**2*gamma*mu - exp**4*mu
d = 1
N = -root**6*root_2**2*root_3**2*exp**2*exp_2**2*mu*I3*I2 - root**6*root_3**2*root_4**2*exp**2*exp_2**2*mu*I3*I1 + root**6*root_2**2*exp**4*mu*I3*I2 + root**6*root_4**2*exp**4*mu*I3*I1 + root**6*root_3**2*exp**2*exp_2**2*mu*I2*I1 - root**6*exp**4*mu*I2*I1
print(expand(d*N - (q1*p1 + q2*p2 + q3*p3 + q4*p4)))
