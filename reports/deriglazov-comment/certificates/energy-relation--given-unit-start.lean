-- deriglazov-comment / energy-relation/given-unit-start: For motions with R(0) = 1.
--
-- Given: the definitions, the assumptions and momentum, energy, omega-of-m.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- 2\cdot E = (I_1)^{-1}\cdot {\bf m}_1^2+(I_2)^{-1}\cdot {\bf m}_2^2+(I_3)^{-1}\cdot {\bf m}_3^2
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (I3 I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (8*I3^3*I2^3*I1^3) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
