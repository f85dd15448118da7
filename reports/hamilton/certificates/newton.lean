-- hamilton / newton: Hamilton's equations are Newton's.
--
-- Given: the definitions, the assumptions and canonical.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- m\cdot \ddot{x} = -\frac{k\cdot x}{r^3}
-- root stands for \sqrt{x^2+y^2}
-- m stands for m
theorem equation_1 (root m : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4*root^6*m) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- m\cdot \ddot{y} = -\frac{k\cdot y}{r^3}
-- root stands for \sqrt{x^2+y^2}
-- m stands for m
theorem equation_2 (root m : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4*root^6*m) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
