-- kepler / energy: The energy per unit mass does not change.
--
-- Given: the definitions, the assumptions and kepler.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{h} = 0
-- root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
theorem equation_1 (root : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2*root^3) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
