-- lorentz / interval: All frames agree on the interval.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- c^2\cdot (\frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (t-\frac{v\cdot x}{c^2}))^{2}-(\frac{1}{\sqrt{1-\frac{v^2}{c^2}}}\cdot (x-v\cdot t))^{2} = c^2\cdot t^2-x^2
-- root stands for \sqrt{1-\frac{v^2}{c^2}}
-- t stands for t
-- x stands for x
-- c stands for c
-- v stands for v
theorem equation_1 (root t x c v : ℝ)
    (h1 : root^2*c^2 - c^2 + v^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-root^4*t^2*c^6 + root^4*x^2*c^4 + root^2*t^2*c^6 - root^2*t^2*c^4*v^2 - root^2*x^2*c^4 + root^2*x^2*c^2*v^2 : ℝ) / (root^4*c^4) = 0 := by
  have key : (1 : ℝ) * (-root^4*t^2*c^6 + root^4*x^2*c^4 + root^2*t^2*c^6 - root^2*t^2*c^4*v^2 - root^2*x^2*c^4 + root^2*x^2*c^2*v^2) = 0 := by linear_combination (-root^2*t^2*c^4 + root^2*x^2*c^2) * h1
  have top : (-root^4*t^2*c^6 + root^4*x^2*c^4 + root^2*t^2*c^6 - root^2*t^2*c^4*v^2 - root^2*x^2*c^4 + root^2*x^2*c^2*v^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
