-- kepler-laws / torque: A force along the radius has no torque.
--
-- Given: the definitions, the assumptions and newton.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- r\cdot \cos(\theta)\cdot (-G\cdot \frac{M\cdot m}{r^2}\cdot \sin(\theta))-r\cdot \sin(\theta)\cdot (-G\cdot \frac{M\cdot m}{r^2}\cdot \cos(\theta)) = 0
-- r stands for r
theorem equation_1 (r : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (r^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
