-- lorentz / velocity: The velocity of a body in the moving frame.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{\frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (\dot{x}-v)}{\frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (1-\frac{v\cdot \dot{x}}{c^2})} = \frac{\dot{x}-v}{1-\frac{v\cdot \dot{x}}{c^2}}
-- root stands for \sqrt{1-\frac{v^2}{c^2}}
-- x_dot stands for \dot{x}
-- c stands for c
-- v stands for v
theorem equation_1 (root x_dot c v : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (root*c^4 - 2*root*x_dot*c^2*v + root*x_dot^2*v^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
