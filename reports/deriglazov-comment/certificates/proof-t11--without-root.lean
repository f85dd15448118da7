-- deriglazov-comment / t11/without-root: With cos θ in place of the root: what t9 says before θ is eliminated.
--
-- Given: the definitions, the assumptions and t9-phi, t9-psi, t10, momentum.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{\dot{\psi}}{\dot{\varphi}} = -\frac{\frac{1}{I_1}-\frac{1}{I_3}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2}}{\frac{1}{I_1}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2}}\cdot \cos(\theta)
-- sin_psi stands for \sin(\psi)
-- cos_psi stands for \cos(\psi)
-- cos_theta stands for \cos(\theta)
-- m3 stands for {\bf m}_3
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (sin_psi cos_psi cos_theta m3 I3 I2 I1 : ℝ)
    (h1 : sin_psi^2 + cos_psi^2 - 1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-sin_psi^2*cos_theta*m3*I3*I2^4*I1^5 - cos_psi^2*cos_theta*m3*I3*I2^4*I1^5 + cos_theta*m3*I3*I2^4*I1^5 : ℝ) / (-sin_psi^2*cos_psi^2*m3*I3^2*I2^4*I1^4 + sin_psi^2*cos_psi^2*m3*I3^2*I2^3*I1^5 - cos_psi^4*m3*I3^2*I2^3*I1^5 + cos_psi^4*m3*I3^2*I2^2*I1^6 + sin_psi^2*m3*I3^2*I2^4*I1^4 + cos_psi^2*m3*I3^2*I2^3*I1^5) = 0 := by
  have key : (1 : ℝ) * (-sin_psi^2*cos_theta*m3*I3*I2^4*I1^5 - cos_psi^2*cos_theta*m3*I3*I2^4*I1^5 + cos_theta*m3*I3*I2^4*I1^5) = 0 := by linear_combination (-cos_theta*m3*I3*I2^4*I1^5) * h1
  have top : (-sin_psi^2*cos_theta*m3*I3*I2^4*I1^5 - cos_psi^2*cos_theta*m3*I3*I2^4*I1^5 + cos_theta*m3*I3*I2^4*I1^5 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (\frac{1}{I_1}-\frac{1}{I_3}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})\cdot (\cos(\theta))^{2} = \frac{1}{I_3}-\frac{2\cdot E}{{\bf m}_3^2}+(\frac{1}{I_1}-\frac{1}{I_3})-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2}
-- cos_psi stands for \cos(\psi)
-- sin_theta stands for \sin(\theta)
-- cos_theta stands for \cos(\theta)
-- E stands for E
-- m3 stands for {\bf m}_3
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (cos_psi sin_theta cos_theta E m3 I3 I2 I1 : ℝ)
    (h1 : sin_theta^2 + cos_theta^2 - 1 = 0)
    (h2 : cos_psi^2*sin_theta^2*m3^2*I3^2*I2*I1 - cos_psi^2*sin_theta^2*m3^2*I3^2*I1^2 - sin_theta^2*m3^2*I3^2*I2*I1 + sin_theta^2*m3^2*I3*I2*I1^2 - m3^2*I3*I2*I1^2 + 2*E*I3^2*I2*I1^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-cos_psi^2*cos_theta^2*m3^2*I3^3*I2^2*I1^3 + cos_psi^2*cos_theta^2*m3^2*I3^3*I2*I1^4 + cos_psi^2*m3^2*I3^3*I2^2*I1^3 + cos_theta^2*m3^2*I3^3*I2^2*I1^3 - cos_psi^2*m3^2*I3^3*I2*I1^4 - cos_theta^2*m3^2*I3^2*I2^2*I1^4 - m3^2*I3^3*I2^2*I1^3 + 2*E*I3^3*I2^2*I1^4 : ℝ) / (m3^2*I3^3*I2^2*I1^4) = 0 := by
  have key : (1 : ℝ) * (-cos_psi^2*cos_theta^2*m3^2*I3^3*I2^2*I1^3 + cos_psi^2*cos_theta^2*m3^2*I3^3*I2*I1^4 + cos_psi^2*m3^2*I3^3*I2^2*I1^3 + cos_theta^2*m3^2*I3^3*I2^2*I1^3 - cos_psi^2*m3^2*I3^3*I2*I1^4 - cos_theta^2*m3^2*I3^2*I2^2*I1^4 - m3^2*I3^3*I2^2*I1^3 + 2*E*I3^3*I2^2*I1^4) = 0 := by linear_combination (-cos_psi^2*m3^2*I3^3*I2^2*I1^3 + cos_psi^2*m3^2*I3^3*I2*I1^4 + m3^2*I3^3*I2^2*I1^3 - m3^2*I3^2*I2^2*I1^4) * h1 + (I3*I2*I1^2) * h2
  have top : (-cos_psi^2*cos_theta^2*m3^2*I3^3*I2^2*I1^3 + cos_psi^2*cos_theta^2*m3^2*I3^3*I2*I1^4 + cos_psi^2*m3^2*I3^3*I2^2*I1^3 + cos_theta^2*m3^2*I3^3*I2^2*I1^3 - cos_psi^2*m3^2*I3^3*I2*I1^4 - cos_theta^2*m3^2*I3^2*I2^2*I1^4 - m3^2*I3^3*I2^2*I1^3 + 2*E*I3^3*I2^2*I1^4 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
