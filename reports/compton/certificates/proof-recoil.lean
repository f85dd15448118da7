-- compton / recoil: The angle of the electron.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{\frac{E}{c}-\frac{\frac{E}{1+\frac{E}{m\cdot c^2}\cdot (1-\cos(\theta))}}{c}\cdot \cos(\theta)}{\frac{\frac{E}{1+\frac{E}{m\cdot c^2}\cdot (1-\cos(\theta))}}{c}\cdot \sin(\theta)} = (1+\frac{E}{m\cdot c^2})\cdot \tan(\frac{\theta}{2})
-- sin_2 stands for \sin(\frac{1}{2}\cdot \theta)
-- cos_2 stands for \cos(\frac{1}{2}\cdot \theta)
-- c stands for c
-- m stands for m
-- E stands for E
theorem equation_1 (sin_2 cos_2 c m E : ℝ)
    (h1 : sin_2^2 + cos_2^2 - 1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-sin_2^2*cos_2*c^8*m^3*E - cos_2^3*c^8*m^3*E - sin_2^4*cos_2*c^6*m^2*E^2 + cos_2^5*c^6*m^2*E^2 + cos_2*c^8*m^3*E - sin_2^2*cos_2*c^6*m^2*E^2 - 3*cos_2^3*c^6*m^2*E^2 - sin_2^4*cos_2*c^4*m*E^3 + cos_2^5*c^4*m*E^3 + 2*cos_2*c^6*m^2*E^2 - 2*cos_2^3*c^4*m*E^3 + cos_2*c^4*m*E^3 : ℝ) / (2*sin_2*cos_2^2*c^8*m^3*E + 2*sin_2^3*cos_2^2*c^6*m^2*E^2 - 2*sin_2*cos_2^4*c^6*m^2*E^2 + 2*sin_2*cos_2^2*c^6*m^2*E^2) = 0 := by
  have key : (1 : ℝ) * (-sin_2^2*cos_2*c^8*m^3*E - cos_2^3*c^8*m^3*E - sin_2^4*cos_2*c^6*m^2*E^2 + cos_2^5*c^6*m^2*E^2 + cos_2*c^8*m^3*E - sin_2^2*cos_2*c^6*m^2*E^2 - 3*cos_2^3*c^6*m^2*E^2 - sin_2^4*cos_2*c^4*m*E^3 + cos_2^5*c^4*m*E^3 + 2*cos_2*c^6*m^2*E^2 - 2*cos_2^3*c^4*m*E^3 + cos_2*c^4*m*E^3) = 0 := by linear_combination (-cos_2*c^8*m^3*E - sin_2^2*cos_2*c^6*m^2*E^2 + cos_2^3*c^6*m^2*E^2 - 2*cos_2*c^6*m^2*E^2 - sin_2^2*cos_2*c^4*m*E^3 + cos_2^3*c^4*m*E^3 - cos_2*c^4*m*E^3) * h1
  have top : (-sin_2^2*cos_2*c^8*m^3*E - cos_2^3*c^8*m^3*E - sin_2^4*cos_2*c^6*m^2*E^2 + cos_2^5*c^6*m^2*E^2 + cos_2*c^8*m^3*E - sin_2^2*cos_2*c^6*m^2*E^2 - 3*cos_2^3*c^6*m^2*E^2 - sin_2^4*cos_2*c^4*m*E^3 + cos_2^5*c^4*m*E^3 + 2*cos_2*c^6*m^2*E^2 - 2*cos_2^3*c^4*m*E^3 + cos_2*c^4*m*E^3 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
