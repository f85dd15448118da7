-- pendulum / speed: The speed at each deflection follows from the amplitude.
--
-- Given: the definitions, the assumptions and energy.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{q}^2 = \frac{2\cdot g}{\ell}\cdot (\cos(q)-\cos(\arccos(-\frac{h}{g\cdot \ell})))
-- g stands for g
-- ell stands for \ell
theorem equation_1 (g ell : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2*g*ell^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
