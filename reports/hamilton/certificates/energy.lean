-- hamilton / energy: The energy is conserved.
--
-- Given: the definitions, the assumptions and canonical.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{2\cdot p_x\cdot \dot{p}_x+2\cdot p_y\cdot \dot{p}_y}{2\cdot m}-\frac{-\frac{k}{r}\cdot \dot{r}}{r} = 0
-- root stands for \sqrt{x^2+y^2}
-- m stands for m
theorem equation_1 (root m : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4*root^3*m) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
