-- deriglazov-comment / t15-solves-t9: The closed forms solve the three equations t9, for every value of the constants c, φ₀, m₃ and every body for which ψ₀ is real.
--
-- Given: the definitions, the assumptions and I_{(n-k)}.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \cos(\theta) = \frac{1-\gamma\cdot \exp(2\cdot (\frac{1}{2}\cdot \mu\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot t)}{1+\gamma\cdot \exp(2\cdot (\frac{1}{2}\cdot \mu\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot t)}
-- root stands for \sqrt{1+(\sqrt{\gamma}\cdot (\exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot (\exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}))))^{-1}))^{2}}
-- root_2 stands for \sqrt{\gamma}
-- exp_2 stands for \exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
-- exp_3 stands for \exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
-- gamma stands for \gamma
theorem equation_1 (root root_2 exp_2 exp_3 gamma : ℝ)
    (h1 : root^2*exp_2^2 - root_2^2*exp_3^2 - exp_2^2 = 0)
    (h2 : root_2^2 - gamma = 0)
    (hd : (1 : ℝ) ≠ 0) : (root^4*exp_2^4*exp_3^2*gamma - root^2*root_2^2*exp_2^2*exp_3^4*gamma - root^4*exp_2^6 - root^2*root_2^2*exp_2^4*exp_3^2 + root^2*exp_2^4*exp_3^2*gamma + root^2*exp_2^6 : ℝ) / (root^4*exp_2^4*exp_3^2*gamma + root^4*exp_2^6) = 0 := by
  have key : (1 : ℝ) * (root^4*exp_2^4*exp_3^2*gamma - root^2*root_2^2*exp_2^2*exp_3^4*gamma - root^4*exp_2^6 - root^2*root_2^2*exp_2^4*exp_3^2 + root^2*exp_2^4*exp_3^2*gamma + root^2*exp_2^6) = 0 := by linear_combination (root^2*exp_2^2*exp_3^2*gamma - root^2*exp_2^4) * h1 + (-2*root^2*exp_2^4*exp_3^2) * h2
  have top : (root^4*exp_2^4*exp_3^2*gamma - root^2*root_2^2*exp_2^2*exp_3^4*gamma - root^4*exp_2^6 - root^2*root_2^2*exp_2^4*exp_3^2 + root^2*exp_2^4*exp_3^2*gamma + root^2*exp_2^6 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\theta} = \mu\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(\theta)\cdot \sin(\psi)\cdot \cos(\psi)
-- root stands for \sqrt{1-(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})^{2}}
-- root_2 stands for \sqrt{1+(\sqrt{\gamma}\cdot (\exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot (\exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}))))^{-1}))^{2}}
-- root_3 stands for \sqrt{\gamma}
-- root_4 stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
-- exp_2 stands for \exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
-- exp_3 stands for \exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
-- mu stands for \mu
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (root root_2 root_3 root_4 exp_2 exp_3 mu I2 I1 : ℝ)
    (h1 : root_2^2*exp_2^2 - root_3^2*exp_3^2 - exp_2^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (4*root*root_2^2*root_3*root_4*exp_2^3*exp_3*mu*I2^2*I1 - 4*root*root_3^3*root_4*exp_2*exp_3^3*mu*I2^2*I1 - 4*root*root_2^2*root_3*root_4*exp_2^3*exp_3*mu*I2*I1^2 + 4*root*root_3^3*root_4*exp_2*exp_3^3*mu*I2*I1^2 - 4*root*root_3*root_4*exp_2^3*exp_3*mu*I2^2*I1 + 4*root*root_3*root_4*exp_2^3*exp_3*mu*I2*I1^2 : ℝ) / (2*root_2^2*root_3^2*exp_2^2*exp_3^2*I2^2*I1^2 + 2*root_2^2*exp_2^4*I2^2*I1^2) = 0 := by
  have key : (1 : ℝ) * (4*root*root_2^2*root_3*root_4*exp_2^3*exp_3*mu*I2^2*I1 - 4*root*root_3^3*root_4*exp_2*exp_3^3*mu*I2^2*I1 - 4*root*root_2^2*root_3*root_4*exp_2^3*exp_3*mu*I2*I1^2 + 4*root*root_3^3*root_4*exp_2*exp_3^3*mu*I2*I1^2 - 4*root*root_3*root_4*exp_2^3*exp_3*mu*I2^2*I1 + 4*root*root_3*root_4*exp_2^3*exp_3*mu*I2*I1^2) = 0 := by linear_combination (4*root*root_3*root_4*exp_2*exp_3*mu*I2^2*I1 - 4*root*root_3*root_4*exp_2*exp_3*mu*I2*I1^2) * h1
  have top : (4*root*root_2^2*root_3*root_4*exp_2^3*exp_3*mu*I2^2*I1 - 4*root*root_3^3*root_4*exp_2*exp_3^3*mu*I2^2*I1 - 4*root*root_2^2*root_3*root_4*exp_2^3*exp_3*mu*I2*I1^2 + 4*root*root_3^3*root_4*exp_2*exp_3^3*mu*I2*I1^2 - 4*root*root_3*root_4*exp_2^3*exp_3*mu*I2^2*I1 + 4*root*root_3*root_4*exp_2^3*exp_3*mu*I2*I1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\varphi} = \frac{\mu}{I_1}\cdot (\sin(\psi))^{2}+\frac{\mu}{I_2}\cdot (\cos(\psi))^{2}
-- root stands for \sqrt{1-(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})^{2}}
-- root_4 stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
-- mu stands for \mu
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_2 (root root_4 mu I3 I2 I1 : ℝ)
    (h1 : root^2 + root_4^2 - 1 = 0)
    (h2 : root_4^2*I3*I2 - root_4^2*I3*I1 - I3*I2 + I2*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-root^2*mu*I3*I2 - root_4^2*mu*I3*I1 + mu*I2*I1 : ℝ) / (I3*I2*I1) = 0 := by
  have key : (1 : ℝ) * (-root^2*mu*I3*I2 - root_4^2*mu*I3*I1 + mu*I2*I1) = 0 := by linear_combination (-mu*I3*I2) * h1 + (mu) * h2
  have top : (-root^2*mu*I3*I2 - root_4^2*mu*I3*I1 + mu*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\psi} = -(\frac{\mu}{I_1}\cdot (\sin(\psi))^{2}+\frac{\mu}{I_2}\cdot (\cos(\psi))^{2})\cdot \cos(\theta)+\frac{\mu}{I_3}\cdot \cos(\theta)
-- root stands for \sqrt{1-(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})^{2}}
-- root_2 stands for \sqrt{1+(\sqrt{\gamma}\cdot (\exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))\cdot (\exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}))))^{-1}))^{2}}
-- root_3 stands for \sqrt{\gamma}
-- root_4 stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
-- exp_2 stands for \exp(\frac{1}{2}\cdot (I_2)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
-- exp_3 stands for \exp(\frac{1}{2}\cdot (I_1)^{-1}\cdot t\cdot \mu\cdot \sin(2\cdot \arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))
-- gamma stands for \gamma
-- mu stands for \mu
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_3 (root root_2 root_3 root_4 exp_2 exp_3 gamma mu I3 I2 I1 : ℝ)
    (h1 : root^2 + root_4^2 - 1 = 0)
    (h2 : root_2^2*exp_2^2 - root_3^2*exp_3^2 - exp_2^2 = 0)
    (h3 : root_3^2 - gamma = 0)
    (h4 : root_4^2*I3*I2 - root_4^2*I3*I1 - I3*I2 + I2*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-root^2*root_2^6*root_3^2*exp_2^2*exp_3^2*mu*I3*I2 - root_2^6*root_3^2*root_4^2*exp_2^2*exp_3^2*mu*I3*I1 + root^2*root_2^6*exp_2^4*mu*I3*I2 + root_2^6*root_4^2*exp_2^4*mu*I3*I1 + root_2^6*root_3^2*exp_2^2*exp_3^2*mu*I2*I1 - root_2^6*exp_2^4*mu*I2*I1 : ℝ) / (root_2^8*exp_2^4*I3*I2*I1) = 0 := by
  have key : (1 : ℝ) * (-root^2*root_2^6*root_3^2*exp_2^2*exp_3^2*mu*I3*I2 - root_2^6*root_3^2*root_4^2*exp_2^2*exp_3^2*mu*I3*I1 + root^2*root_2^6*exp_2^4*mu*I3*I2 + root_2^6*root_4^2*exp_2^4*mu*I3*I1 + root_2^6*root_3^2*exp_2^2*exp_3^2*mu*I2*I1 - root_2^6*exp_2^4*mu*I2*I1) = 0 := by linear_combination (-root_2^6*exp_2^2*exp_3^2*gamma*mu*I3*I2 + root_2^6*exp_2^4*mu*I3*I2) * h1 + (root_2^4*root_4^2*exp_3^2*gamma*mu*I3*I2 - root_2^4*root_4^2*exp_3^2*gamma*mu*I3*I1 - root_2^4*root_4^2*exp_2^2*mu*I3*I2 + root_2^4*root_4^2*exp_2^2*mu*I3*I1 - root_2^4*exp_3^2*gamma*mu*I3*I2 + root_2^4*exp_3^2*gamma*mu*I2*I1 + root_2^4*exp_2^2*mu*I3*I2 - root_2^2*root_4^2*exp_2^2*mu*I3*I2 + root_2^2*root_4^2*exp_2^2*mu*I3*I1 - root_2^4*exp_2^2*mu*I2*I1 - root_4^2*exp_3^2*gamma*mu*I3*I2 + root_4^2*exp_3^2*gamma*mu*I3*I1 + root_2^2*exp_2^2*mu*I3*I2 - root_4^2*exp_2^2*mu*I3*I2 + root_4^2*exp_2^2*mu*I3*I1 - root_2^2*exp_2^2*mu*I2*I1 + exp_3^2*gamma*mu*I3*I2 - exp_3^2*gamma*mu*I2*I1 + exp_2^2*mu*I3*I2 - exp_2^2*mu*I2*I1) * h2 + (-root^2*root_2^6*exp_2^2*exp_3^2*mu*I3*I2 - root_2^6*root_4^2*exp_2^2*exp_3^2*mu*I3*I1 + root_2^4*root_4^2*exp_3^4*gamma*mu*I3*I2 - root_2^4*root_4^2*exp_3^4*gamma*mu*I3*I1 - root_2^4*root_4^2*exp_2^2*exp_3^2*mu*I3*I2 + root_2^4*root_4^2*exp_2^2*exp_3^2*mu*I3*I1 + root_2^6*exp_2^2*exp_3^2*mu*I2*I1 - root_2^4*exp_3^4*gamma*mu*I3*I2 + root_2^4*exp_3^4*gamma*mu*I2*I1 + root_2^4*exp_2^2*exp_3^2*mu*I3*I2 - root_2^2*root_4^2*exp_2^2*exp_3^2*mu*I3*I2 + root_2^2*root_4^2*exp_2^2*exp_3^2*mu*I3*I1 - root_2^4*exp_2^2*exp_3^2*mu*I2*I1 - root_4^2*exp_3^4*gamma*mu*I3*I2 + root_4^2*exp_3^4*gamma*mu*I3*I1 + root_2^2*exp_2^2*exp_3^2*mu*I3*I2 - root_4^2*exp_2^2*exp_3^2*mu*I3*I2 + root_4^2*exp_2^2*exp_3^2*mu*I3*I1 - root_2^2*exp_2^2*exp_3^2*mu*I2*I1 + exp_3^4*gamma*mu*I3*I2 - exp_3^4*gamma*mu*I2*I1 + exp_2^2*exp_3^2*mu*I3*I2 - exp_2^2*exp_3^2*mu*I2*I1) * h3 + (root_2^4*exp_3^4*gamma^2*mu - exp_3^4*gamma^2*mu - 2*exp_2^2*exp_3^2*gamma*mu - exp_2^4*mu) * h4
  have top : (-root^2*root_2^6*root_3^2*exp_2^2*exp_3^2*mu*I3*I2 - root_2^6*root_3^2*root_4^2*exp_2^2*exp_3^2*mu*I3*I1 + root^2*root_2^6*exp_2^4*mu*I3*I2 + root_2^6*root_4^2*exp_2^4*mu*I3*I1 + root_2^6*root_3^2*exp_2^2*exp_3^2*mu*I2*I1 - root_2^6*exp_2^4*mu*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
