-- fresnel / sines: By angles alone, perpendicular.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{n\cdot \cos(\alpha)-m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{n\cdot \cos(\alpha)+m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))} = -\frac{\sin(\alpha-\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{\sin(\alpha+\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}
-- root stands for \sqrt{1-(\frac{n}{m}\cdot \sin(\alpha))^{2}}
-- sin_alpha stands for \sin(\alpha)
-- cos_alpha stands for \cos(\alpha)
-- m stands for m
-- n stands for n
theorem equation_1 (root sin_alpha cos_alpha m n : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (root^2*sin_alpha*m^3 + 2*root*sin_alpha*cos_alpha*m^2*n + sin_alpha*cos_alpha^2*m*n^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
