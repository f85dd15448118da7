-- compton / kinetic: The energy that the electron takes.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- E-\frac{E}{1+\frac{E}{m\cdot c^2}\cdot (1-\cos(\theta))} = E\cdot \frac{\frac{E}{m\cdot c^2}\cdot (1-\cos(\theta))}{1+\frac{E}{m\cdot c^2}\cdot (1-\cos(\theta))}
-- cos_theta stands for \cos(\theta)
-- c stands for c
-- m stands for m
-- E stands for E
theorem equation_1 (cos_theta c m E : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (c^6*m^3 - 2*cos_theta*c^4*m^2*E + 2*c^4*m^2*E + cos_theta^2*c^2*m*E^2 - 2*cos_theta*c^2*m*E^2 + c^2*m*E^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
