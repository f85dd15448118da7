-- lorentz / back: The inverse is the boost with the opposite velocity.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- x = \frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (\frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (x-v\cdot t)+v\cdot (\frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (t-\frac{v\cdot x}{c^2})))
-- root stands for \sqrt{1-\frac{v^2}{c^2}}
-- x stands for x
-- c stands for c
-- v stands for v
theorem equation_1 (root x c v : ℝ)
    (h1 : root^2*c^2 - c^2 + v^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (root^3*x*c^2 - root*x*c^2 + root*x*v^2 : ℝ) / (root^3*c^2) = 0 := by
  have key : (1 : ℝ) * (root^3*x*c^2 - root*x*c^2 + root*x*v^2) = 0 := by linear_combination (root*x) * h1
  have top : (root^3*x*c^2 - root*x*c^2 + root*x*v^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- t = \frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (\frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (t-\frac{v\cdot x}{c^2})+\frac{v\cdot (\frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (x-v\cdot t))}{c^2})
-- root stands for \sqrt{1-\frac{v^2}{c^2}}
-- t stands for t
-- c stands for c
-- v stands for v
theorem equation_2 (root t c v : ℝ)
    (h1 : root^2*c^2 - c^2 + v^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (root^2*t*c^2 - t*c^2 + t*v^2 : ℝ) / (root^2*c^2) = 0 := by
  have key : (1 : ℝ) * (root^2*t*c^2 - t*c^2 + t*v^2) = 0 := by linear_combination (t) * h1
  have top : (root^2*t*c^2 - t*c^2 + t*v^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
