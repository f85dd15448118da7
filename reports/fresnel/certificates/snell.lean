-- fresnel / snell: The law of refraction.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- n\cdot \sin(\alpha) = m\cdot \sin(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))
-- m stands for m
theorem equation_1 (m : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (m) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
