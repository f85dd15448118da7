-- fresnel / continuity: The field is the same on both sides of the border.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- 1+\frac{n\cdot \cos(\alpha)-m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{n\cdot \cos(\alpha)+m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))} = \frac{2\cdot n\cdot \cos(\alpha)}{n\cdot \cos(\alpha)+m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}
-- root stands for \sqrt{1-(\frac{n}{m}\cdot \sin(\alpha))^{2}}
-- cos_alpha stands for \cos(\alpha)
-- m stands for m
-- n stands for n
theorem equation_1 (root cos_alpha m n : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (root*m + cos_alpha*n) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- n\cdot (1+\frac{m\cdot \cos(\alpha)-n\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{m\cdot \cos(\alpha)+n\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}) = m\cdot \frac{2\cdot n\cdot \cos(\alpha)}{m\cdot \cos(\alpha)+n\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}
-- root stands for \sqrt{1-(\frac{n}{m}\cdot \sin(\alpha))^{2}}
-- cos_alpha stands for \cos(\alpha)
-- m stands for m
-- n stands for n
theorem equation_1 (root cos_alpha m n : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (cos_alpha*m + root*n) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
