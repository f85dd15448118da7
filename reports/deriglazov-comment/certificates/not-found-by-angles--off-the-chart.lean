-- deriglazov-comment / not-found-by-angles/off-the-chart: All its points lie off the chart, where sin θ = 0 and φ and ψ cannot be read off.
--
-- Given: the definitions, the assumptions and t8.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \sin(\theta) = 0
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
