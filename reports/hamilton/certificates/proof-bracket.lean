-- hamilton / bracket: The angular momentum turns the Runge-Lenz vector, and the two components of this make an angular momentum, with the Hamiltonian for a factor: so say their Poisson brackets.
--
-- Given: the definitions, the assumptions and canonical.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 197 operations) = -2\cdot m\cdot (\frac{p_x^2+p_y^2}{2\cdot m}-\frac{k}{r})\cdot \ell
-- root stands for \sqrt{x^2+y^2}
-- k stands for k
-- m stands for m
-- py stands for p_y
-- px stands for p_x
-- y stands for y
-- x stands for x
theorem equation_3 (root k m py px y x : ℝ)
    (h1 : root^2 - y^2 - x^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-4*root^3*k*m^2*px*y + 4*root*k*m^2*px*y^3 + 4*root^3*k*m^2*py*x - 4*root*k*m^2*py*y^2*x + 4*root*k*m^2*px*y*x^2 - 4*root*k*m^2*py*x^3 : ℝ) / (4*root^4*m) = 0 := by
  have key : (1 : ℝ) * (-4*root^3*k*m^2*px*y + 4*root*k*m^2*px*y^3 + 4*root^3*k*m^2*py*x - 4*root*k*m^2*py*y^2*x + 4*root*k*m^2*px*y*x^2 - 4*root*k*m^2*py*x^3) = 0 := by linear_combination (-4*root*k*m^2*px*y + 4*root*k*m^2*py*x) * h1
  have top : (-4*root^3*k*m^2*px*y + 4*root*k*m^2*px*y^3 + 4*root^3*k*m^2*py*x - 4*root*k*m^2*py*y^2*x + 4*root*k*m^2*px*y*x^2 - 4*root*k*m^2*py*x^3 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (an expression of 174 operations) = 0
-- root stands for \sqrt{x^2+y^2}
-- k stands for k
-- m stands for m
-- px stands for p_x
-- y stands for y
-- x stands for x
theorem equation_4 (root k m px y x : ℝ)
    (h1 : root^2 - y^2 - x^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-8*root^5*k*m*px + 8*root^3*k*m*px*y^2 + 8*root^3*k*m*px*x^2 : ℝ) / (8*root^6*m) = 0 := by
  have key : (1 : ℝ) * (-8*root^5*k*m*px + 8*root^3*k*m*px*y^2 + 8*root^3*k*m*px*x^2) = 0 := by linear_combination (-8*root^3*k*m*px) * h1
  have top : (-8*root^5*k*m*px + 8*root^3*k*m*px*y^2 + 8*root^3*k*m*px*x^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (an expression of 178 operations) = 0
-- root stands for \sqrt{x^2+y^2}
-- k stands for k
-- m stands for m
-- py stands for p_y
-- y stands for y
-- x stands for x
theorem equation_5 (root k m py y x : ℝ)
    (h1 : root^2 - y^2 - x^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-8*root^5*k*m*py + 8*root^3*k*m*py*y^2 + 8*root^3*k*m*py*x^2 : ℝ) / (8*root^6*m) = 0 := by
  have key : (1 : ℝ) * (-8*root^5*k*m*py + 8*root^3*k*m*py*y^2 + 8*root^3*k*m*py*x^2) = 0 := by linear_combination (-8*root^3*k*m*py) * h1
  have top : (-8*root^5*k*m*py + 8*root^3*k*m*py*y^2 + 8*root^3*k*m*py*x^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
