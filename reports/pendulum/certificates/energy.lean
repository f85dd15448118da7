-- pendulum / energy: The energy does not change.
--
-- Given: the definitions, the assumptions and pendulum.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{h} = 0
-- ell stands for \ell
theorem equation_1 (ell : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2*ell) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
