-- deriglazov-comment / psi0-in-t9: ψ = ψ₀ satisfies the last equation of t9, whatever θ does.
--
-- Given: the definitions, the assumptions and psi0-formula.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- 0 = -(\frac{{\bf m}_3}{I_1}\cdot (\sin(\arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))^{2}+\frac{{\bf m}_3}{I_2}\cdot (\cos(\arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))^{2})\cdot \cos(\theta)+\frac{{\bf m}_3}{I_3}\cdot \cos(\theta)
-- root stands for \sqrt{1-(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})^{2}}
-- root_2 stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
-- cos_theta stands for \cos(\theta)
-- m3 stands for {\bf m}_3
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (root root_2 cos_theta m3 I3 I2 I1 : ℝ)
    (h1 : root^2 + root_2^2 - 1 = 0)
    (h2 : root_2^2*I3*I2 - root_2^2*I3*I1 - I3*I2 + I2*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (root^2*cos_theta*m3*I3*I2 + root_2^2*cos_theta*m3*I3*I1 - cos_theta*m3*I2*I1 : ℝ) / (I3*I2*I1) = 0 := by
  have key : (1 : ℝ) * (root^2*cos_theta*m3*I3*I2 + root_2^2*cos_theta*m3*I3*I1 - cos_theta*m3*I2*I1) = 0 := by linear_combination (cos_theta*m3*I3*I2) * h1 + (-cos_theta*m3) * h2
  have top : (root^2*cos_theta*m3*I3*I2 + root_2^2*cos_theta*m3*I3*I1 - cos_theta*m3*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
