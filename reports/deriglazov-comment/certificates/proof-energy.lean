-- deriglazov-comment / energy: The kinetic energy does not change.
--
-- Given: the definitions, the assumptions and t1-euler.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{E} = 0
-- Omega3_dot stands for \dot{\Omega}_3
-- Omega2_dot stands for \dot{\Omega}_2
-- Omega1_dot stands for \dot{\Omega}_1
-- Omega3 stands for \Omega_3
-- Omega2 stands for \Omega_2
-- Omega1 stands for \Omega_1
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (Omega3_dot Omega2_dot Omega1_dot Omega3 Omega2 Omega1 I3 I2 I1 : ℝ)
    (h1 : Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1 = 0)
    (h2 : -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2 = 0)
    (h3 : Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3 = 0)
    (hd : (1 : ℝ) ≠ 0) : (2*Omega3_dot*Omega3*I3 + 2*Omega2_dot*Omega2*I2 + 2*Omega1_dot*Omega1*I1 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (2*Omega3_dot*Omega3*I3 + 2*Omega2_dot*Omega2*I2 + 2*Omega1_dot*Omega1*I1) = 0 := by linear_combination (2*Omega1) * h1 + (2*Omega2) * h2 + (2*Omega3) * h3
  have top : (2*Omega3_dot*Omega3*I3 + 2*Omega2_dot*Omega2*I2 + 2*Omega1_dot*Omega1*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
