-- compton / half-angle: The same with half the angle.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{h\cdot c}{\frac{E}{1+\frac{E}{m\cdot c^2}\cdot (1-\cos(\theta))}}-\frac{h\cdot c}{E} = \frac{2\cdot h}{m\cdot c}\cdot (\sin(\frac{\theta}{2}))^{2}
-- sin_2 stands for \sin(\frac{1}{2}\cdot \theta)
-- cos_2 stands for \cos(\frac{1}{2}\cdot \theta)
-- h stands for h
-- c stands for c
-- m stands for m
-- E stands for E
theorem equation_1 (sin_2 cos_2 h c m E : ℝ)
    (h1 : sin_2^2 + cos_2^2 - 1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-sin_2^2*h*c^2*m*E^2 - cos_2^2*h*c^2*m*E^2 + h*c^2*m*E^2 : ℝ) / (c^3*m^2*E^2) = 0 := by
  have key : (1 : ℝ) * (-sin_2^2*h*c^2*m*E^2 - cos_2^2*h*c^2*m*E^2 + h*c^2*m*E^2) = 0 := by linear_combination (-h*c^2*m*E^2) * h1
  have top : (-sin_2^2*h*c^2*m*E^2 - cos_2^2*h*c^2*m*E^2 + h*c^2*m*E^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
