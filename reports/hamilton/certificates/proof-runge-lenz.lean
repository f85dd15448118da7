-- hamilton / runge-lenz: So is the Runge-Lenz vector.
--
-- Given: the definitions, the assumptions and canonical.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{A}_x = 0
-- root stands for \sqrt{x^2+y^2}
-- k stands for k
-- m stands for m
-- px stands for p_x
-- y stands for y
-- x stands for x
theorem equation_1 (root k m px y x : ℝ)
    (h1 : root^2 - y^2 - x^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-64*root^8*k*m^3*px + 64*root^6*k*m^3*px*y^2 + 64*root^6*k*m^3*px*x^2 : ℝ) / (64*root^9*m^3) = 0 := by
  have key : (1 : ℝ) * (-64*root^8*k*m^3*px + 64*root^6*k*m^3*px*y^2 + 64*root^6*k*m^3*px*x^2) = 0 := by linear_combination (-64*root^6*k*m^3*px) * h1
  have top : (-64*root^8*k*m^3*px + 64*root^6*k*m^3*px*y^2 + 64*root^6*k*m^3*px*x^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{A}_y = 0
-- root stands for \sqrt{x^2+y^2}
-- k stands for k
-- m stands for m
-- py stands for p_y
-- y stands for y
-- x stands for x
theorem equation_2 (root k m py y x : ℝ)
    (h1 : root^2 - y^2 - x^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-64*root^8*k*m^3*py + 64*root^6*k*m^3*py*y^2 + 64*root^6*k*m^3*py*x^2 : ℝ) / (64*root^9*m^3) = 0 := by
  have key : (1 : ℝ) * (-64*root^8*k*m^3*py + 64*root^6*k*m^3*py*y^2 + 64*root^6*k*m^3*py*x^2) = 0 := by linear_combination (-64*root^6*k*m^3*py) * h1
  have top : (-64*root^8*k*m^3*py + 64*root^6*k*m^3*py*y^2 + 64*root^6*k*m^3*py*x^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
