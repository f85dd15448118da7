-- deriglazov-comment / m-from-start/given-unit-start: Both equalities, given R(0) = 1.
--
-- Given: the definitions, the assumptions and euler-poisson.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{\bf m}_1 = 0
-- Omega3_dot stands for \dot{\Omega}_3
-- Omega2_dot stands for \dot{\Omega}_2
-- Omega1_dot stands for \dot{\Omega}_1
-- Omega3 stands for \Omega_3
-- Omega2 stands for \Omega_2
-- Omega1 stands for \Omega_1
-- R13 stands for R_{13}
-- R12 stands for R_{12}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_2 (Omega3_dot Omega2_dot Omega1_dot Omega3 Omega2 Omega1 R13 R12 R11 I3 I2 I1 : ℝ)
    (h1 : Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1 = 0)
    (h2 : -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2 = 0)
    (h3 : Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3*Omega1*R12*I3 + Omega3*Omega2*R11*I3 + Omega2*Omega1*R13*I2 - Omega3*Omega2*R11*I2 - Omega2*Omega1*R13*I1 + Omega3*Omega1*R12*I1 + Omega3_dot*R13*I3 + Omega2_dot*R12*I2 + Omega1_dot*R11*I1 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (-Omega3*Omega1*R12*I3 + Omega3*Omega2*R11*I3 + Omega2*Omega1*R13*I2 - Omega3*Omega2*R11*I2 - Omega2*Omega1*R13*I1 + Omega3*Omega1*R12*I1 + Omega3_dot*R13*I3 + Omega2_dot*R12*I2 + Omega1_dot*R11*I1) = 0 := by linear_combination (R11) * h1 + (R12) * h2 + (R13) * h3
  have top : (-Omega3*Omega1*R12*I3 + Omega3*Omega2*R11*I3 + Omega2*Omega1*R13*I2 - Omega3*Omega2*R11*I2 - Omega2*Omega1*R13*I1 + Omega3*Omega1*R12*I1 + Omega3_dot*R13*I3 + Omega2_dot*R12*I2 + Omega1_dot*R11*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\bf m}_2 = 0
-- Omega3_dot stands for \dot{\Omega}_3
-- Omega2_dot stands for \dot{\Omega}_2
-- Omega1_dot stands for \dot{\Omega}_1
-- Omega3 stands for \Omega_3
-- Omega2 stands for \Omega_2
-- Omega1 stands for \Omega_1
-- R23 stands for R_{23}
-- R22 stands for R_{22}
-- R21 stands for R_{21}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_4 (Omega3_dot Omega2_dot Omega1_dot Omega3 Omega2 Omega1 R23 R22 R21 I3 I2 I1 : ℝ)
    (h1 : Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1 = 0)
    (h2 : -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2 = 0)
    (h3 : Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3*Omega1*R22*I3 + Omega3*Omega2*R21*I3 + Omega2*Omega1*R23*I2 - Omega3*Omega2*R21*I2 - Omega2*Omega1*R23*I1 + Omega3*Omega1*R22*I1 + Omega3_dot*R23*I3 + Omega2_dot*R22*I2 + Omega1_dot*R21*I1 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (-Omega3*Omega1*R22*I3 + Omega3*Omega2*R21*I3 + Omega2*Omega1*R23*I2 - Omega3*Omega2*R21*I2 - Omega2*Omega1*R23*I1 + Omega3*Omega1*R22*I1 + Omega3_dot*R23*I3 + Omega2_dot*R22*I2 + Omega1_dot*R21*I1) = 0 := by linear_combination (R21) * h1 + (R22) * h2 + (R23) * h3
  have top : (-Omega3*Omega1*R22*I3 + Omega3*Omega2*R21*I3 + Omega2*Omega1*R23*I2 - Omega3*Omega2*R21*I2 - Omega2*Omega1*R23*I1 + Omega3*Omega1*R22*I1 + Omega3_dot*R23*I3 + Omega2_dot*R22*I2 + Omega1_dot*R21*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\bf m}_3 = 0
-- Omega3_dot stands for \dot{\Omega}_3
-- Omega2_dot stands for \dot{\Omega}_2
-- Omega1_dot stands for \dot{\Omega}_1
-- Omega3 stands for \Omega_3
-- Omega2 stands for \Omega_2
-- Omega1 stands for \Omega_1
-- R33 stands for R_{33}
-- R32 stands for R_{32}
-- R31 stands for R_{31}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_6 (Omega3_dot Omega2_dot Omega1_dot Omega3 Omega2 Omega1 R33 R32 R31 I3 I2 I1 : ℝ)
    (h1 : Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1 = 0)
    (h2 : -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2 = 0)
    (h3 : Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3*Omega1*R32*I3 + Omega3*Omega2*R31*I3 + Omega2*Omega1*R33*I2 - Omega3*Omega2*R31*I2 - Omega2*Omega1*R33*I1 + Omega3*Omega1*R32*I1 + Omega3_dot*R33*I3 + Omega2_dot*R32*I2 + Omega1_dot*R31*I1 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (-Omega3*Omega1*R32*I3 + Omega3*Omega2*R31*I3 + Omega2*Omega1*R33*I2 - Omega3*Omega2*R31*I2 - Omega2*Omega1*R33*I1 + Omega3*Omega1*R32*I1 + Omega3_dot*R33*I3 + Omega2_dot*R32*I2 + Omega1_dot*R31*I1) = 0 := by linear_combination (R31) * h1 + (R32) * h2 + (R33) * h3
  have top : (-Omega3*Omega1*R32*I3 + Omega3*Omega2*R31*I3 + Omega2*Omega1*R33*I2 - Omega3*Omega2*R31*I2 - Omega2*Omega1*R33*I1 + Omega3*Omega1*R32*I1 + Omega3_dot*R33*I3 + Omega2_dot*R32*I2 + Omega1_dot*R31*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
