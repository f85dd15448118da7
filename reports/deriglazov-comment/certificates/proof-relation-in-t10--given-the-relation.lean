-- deriglazov-comment / relation-in-t10/given-the-relation: For motions that obey the relation.
--
-- Given: the definitions, the assumptions and t10, momentum.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (\frac{1}{I_1}-\frac{1}{I_3}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})\cdot (\sin(\theta))^{2} = 0
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
    (h2 : -m3^2*I2*I1 + 2*E*I3*I2*I1 = 0)
    (h3 : cos_psi^2*sin_theta^2*m3^2*I3^2*I2*I1 - cos_psi^2*sin_theta^2*m3^2*I3^2*I1^2 - sin_theta^2*m3^2*I3^2*I2*I1 + sin_theta^2*m3^2*I3*I2*I1^2 - m3^2*I3*I2*I1^2 + 2*E*I3^2*I2*I1^2 = 0)
    (hd : (sin_theta^2*m3^2*I3^2*I2^2*I1^2 : ℝ) ≠ 0) : (-cos_psi^2*sin_theta^2*I3*I2*I1 + cos_psi^2*sin_theta^2*I3*I1^2 + sin_theta^2*I3*I2*I1 - sin_theta^2*I2*I1^2 : ℝ) / (I3*I2*I1^2) = 0 := by
  have key : (sin_theta^2*m3^2*I3^2*I2^2*I1^2 : ℝ) * (-cos_psi^2*sin_theta^2*I3*I2*I1 + cos_psi^2*sin_theta^2*I3*I1^2 + sin_theta^2*I3*I2*I1 - sin_theta^2*I2*I1^2) = 0 := by linear_combination (-2*cos_psi^2*sin_theta^2*E*I3^4*I2^3*I1^3 + cos_psi^2*cos_theta^2*m3^2*I3^3*I2^2*I1^4 + 2*cos_psi^2*sin_theta^2*E*I3^4*I2^2*I1^4 - 2*cos_psi^2*cos_theta^2*E*I3^4*I2^2*I1^4 + 2*sin_theta^2*E*I3^4*I2^3*I1^3 - cos_psi^2*m3^2*I3^3*I2^2*I1^4 + 2*cos_psi^2*E*I3^4*I2^2*I1^4 - 2*sin_theta^2*E*I3^3*I2^3*I1^4) * h1 + (cos_psi^2*sin_theta^4*I3^3*I2^2*I1^2 + cos_psi^2*sin_theta^2*cos_theta^2*I3^3*I2^2*I1^2 - cos_psi^2*sin_theta^4*I3^3*I2*I1^3 + cos_psi^2*cos_theta^4*I3^3*I2*I1^3 - cos_psi^2*sin_theta^2*I3^3*I2^2*I1^2 - sin_theta^4*I3^3*I2^2*I1^2 - sin_theta^2*cos_theta^2*I3^3*I2^2*I1^2 - 2*cos_psi^2*cos_theta^2*I3^3*I2*I1^3 + sin_theta^4*I3^2*I2^2*I1^3 + sin_theta^2*cos_theta^2*I3^2*I2^2*I1^3 + sin_theta^2*I3^3*I2^2*I1^2 + cos_psi^2*I3^3*I2*I1^3 - sin_theta^2*I3^2*I2^2*I1^3 - cos_theta^2*I3^2*I2^2*I1^3 + I3^2*I2^2*I1^3) * h2 + (cos_theta^2*I3*I2^2*I1^2 - I3*I2^2*I1^2) * h3
  have top : (-cos_psi^2*sin_theta^2*I3*I2*I1 + cos_psi^2*sin_theta^2*I3*I1^2 + sin_theta^2*I3*I2*I1 - sin_theta^2*I2*I1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
