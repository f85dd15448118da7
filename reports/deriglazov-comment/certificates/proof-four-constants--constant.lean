-- deriglazov-comment / four-constants/constant: All four are constant along a motion.
--
-- Given: the definitions, the assumptions and energy, momentum.
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

example (unused : ℝ) (hD : (1 : ℝ) ≠ 0) : (0 : ℝ) - (0) = (0) / (1) := by
  field_simp
  ring
