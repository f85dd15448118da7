-- fresnel / tangents: By angles alone, in the plane.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{m\cdot \cos(\alpha)-n\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{m\cdot \cos(\alpha)+n\cdot \cos(\arcsin(\frac{n}{m}\cdot \sin(\alpha)))} = \frac{\tan(\alpha-\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}{\tan(\alpha+\arcsin(\frac{n}{m}\cdot \sin(\alpha)))}
-- root stands for \sqrt{1-(\frac{n}{m}\cdot \sin(\alpha))^{2}}
-- sin_alpha stands for \sin(\alpha)
-- cos_alpha stands for \cos(\alpha)
-- m stands for m
-- n stands for n
theorem equation_1 (root sin_alpha cos_alpha m n : ℝ)
    (h1 : root^2*m^2 + sin_alpha^2*n^2 - m^2 = 0)
    (h2 : sin_alpha^2 + cos_alpha^2 - 1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-2*root^3*sin_alpha*cos_alpha*m^4*n + 2*root*sin_alpha^3*cos_alpha*m^4*n + 2*root*sin_alpha*cos_alpha^3*m^4*n - 2*root*sin_alpha^3*cos_alpha*m^2*n^3 : ℝ) / (root^2*sin_alpha*cos_alpha^2*m^5 + root^3*sin_alpha*cos_alpha*m^4*n + root*sin_alpha^3*cos_alpha*m^4*n + root*sin_alpha*cos_alpha^3*m^4*n + root^2*sin_alpha^3*m^3*n^2 + root^2*sin_alpha*cos_alpha^2*m^3*n^2 + sin_alpha^3*cos_alpha^2*m^3*n^2 + root*sin_alpha^3*cos_alpha*m^2*n^3) = 0 := by
  have key : (1 : ℝ) * (-2*root^3*sin_alpha*cos_alpha*m^4*n + 2*root*sin_alpha^3*cos_alpha*m^4*n + 2*root*sin_alpha*cos_alpha^3*m^4*n - 2*root*sin_alpha^3*cos_alpha*m^2*n^3) = 0 := by linear_combination (-2*root*sin_alpha*cos_alpha*m^2*n) * h1 + (2*root*sin_alpha*cos_alpha*m^4*n) * h2
  have top : (-2*root^3*sin_alpha*cos_alpha*m^4*n + 2*root*sin_alpha^3*cos_alpha*m^4*n + 2*root*sin_alpha*cos_alpha^3*m^4*n - 2*root*sin_alpha^3*cos_alpha*m^2*n^3 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
