-- deriglazov-comment / omega-of-m: The angular velocity in the body follows from the attitude and the constant momentum.
--
-- Given: the definitions, the assumptions and momentum, orthogonality.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \Omega_1 = \frac{1}{I_1}\cdot (R_{11}\cdot {\bf m}_1(0)+R_{21}\cdot {\bf m}_2(0)+R_{31}\cdot {\bf m}_3(0))
-- Omega3 stands for \Omega_3
-- Omega2 stands for \Omega_2
-- Omega1 stands for \Omega_1
-- R33 stands for R_{33}
-- R32 stands for R_{32}
-- R31 stands for R_{31}
-- R23 stands for R_{23}
-- R22 stands for R_{22}
-- R21 stands for R_{21}
-- R13 stands for R_{13}
-- R12 stands for R_{12}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_4 (Omega3 Omega2 Omega1 R33 R32 R31 R23 R22 R21 R13 R12 R11 I3 I2 I1 : ℝ)
    (h1 : R31^2 + R21^2 + R11^2 - 1 = 0)
    (h2 : R32*R31 + R22*R21 + R12*R11 = 0)
    (h3 : R33*R31 + R23*R21 + R13*R11 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3*R33*R31*I3 - Omega3*R23*R21*I3 - Omega3*R13*R11*I3 - Omega2*R32*R31*I2 - Omega2*R22*R21*I2 - Omega2*R12*R11*I2 - Omega1*R31^2*I1 - Omega1*R21^2*I1 - Omega1*R11^2*I1 + Omega1*I1 : ℝ) / (I1) = 0 := by
  have key : (1 : ℝ) * (-Omega3*R33*R31*I3 - Omega3*R23*R21*I3 - Omega3*R13*R11*I3 - Omega2*R32*R31*I2 - Omega2*R22*R21*I2 - Omega2*R12*R11*I2 - Omega1*R31^2*I1 - Omega1*R21^2*I1 - Omega1*R11^2*I1 + Omega1*I1) = 0 := by linear_combination (-Omega1*I1) * h1 + (-Omega2*I2) * h2 + (-Omega3*I3) * h3
  have top : (-Omega3*R33*R31*I3 - Omega3*R23*R21*I3 - Omega3*R13*R11*I3 - Omega2*R32*R31*I2 - Omega2*R22*R21*I2 - Omega2*R12*R11*I2 - Omega1*R31^2*I1 - Omega1*R21^2*I1 - Omega1*R11^2*I1 + Omega1*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \Omega_2 = \frac{1}{I_2}\cdot (R_{12}\cdot {\bf m}_1(0)+R_{22}\cdot {\bf m}_2(0)+R_{32}\cdot {\bf m}_3(0))
-- Omega3 stands for \Omega_3
-- Omega2 stands for \Omega_2
-- Omega1 stands for \Omega_1
-- R33 stands for R_{33}
-- R32 stands for R_{32}
-- R31 stands for R_{31}
-- R23 stands for R_{23}
-- R22 stands for R_{22}
-- R21 stands for R_{21}
-- R13 stands for R_{13}
-- R12 stands for R_{12}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_5 (Omega3 Omega2 Omega1 R33 R32 R31 R23 R22 R21 R13 R12 R11 I3 I2 I1 : ℝ)
    (h1 : R32*R31 + R22*R21 + R12*R11 = 0)
    (h2 : R32^2 + R22^2 + R12^2 - 1 = 0)
    (h3 : R33*R32 + R23*R22 + R13*R12 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3*R33*R32*I3 - Omega3*R23*R22*I3 - Omega3*R13*R12*I3 - Omega2*R32^2*I2 - Omega2*R22^2*I2 - Omega2*R12^2*I2 - Omega1*R32*R31*I1 - Omega1*R22*R21*I1 - Omega1*R12*R11*I1 + Omega2*I2 : ℝ) / (I2) = 0 := by
  have key : (1 : ℝ) * (-Omega3*R33*R32*I3 - Omega3*R23*R22*I3 - Omega3*R13*R12*I3 - Omega2*R32^2*I2 - Omega2*R22^2*I2 - Omega2*R12^2*I2 - Omega1*R32*R31*I1 - Omega1*R22*R21*I1 - Omega1*R12*R11*I1 + Omega2*I2) = 0 := by linear_combination (-Omega1*I1) * h1 + (-Omega2*I2) * h2 + (-Omega3*I3) * h3
  have top : (-Omega3*R33*R32*I3 - Omega3*R23*R22*I3 - Omega3*R13*R12*I3 - Omega2*R32^2*I2 - Omega2*R22^2*I2 - Omega2*R12^2*I2 - Omega1*R32*R31*I1 - Omega1*R22*R21*I1 - Omega1*R12*R11*I1 + Omega2*I2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \Omega_3 = \frac{1}{I_3}\cdot (R_{13}\cdot {\bf m}_1(0)+R_{23}\cdot {\bf m}_2(0)+R_{33}\cdot {\bf m}_3(0))
-- Omega3 stands for \Omega_3
-- Omega2 stands for \Omega_2
-- Omega1 stands for \Omega_1
-- R33 stands for R_{33}
-- R32 stands for R_{32}
-- R31 stands for R_{31}
-- R23 stands for R_{23}
-- R22 stands for R_{22}
-- R21 stands for R_{21}
-- R13 stands for R_{13}
-- R12 stands for R_{12}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_6 (Omega3 Omega2 Omega1 R33 R32 R31 R23 R22 R21 R13 R12 R11 I3 I2 I1 : ℝ)
    (h1 : R33*R31 + R23*R21 + R13*R11 = 0)
    (h2 : R33*R32 + R23*R22 + R13*R12 = 0)
    (h3 : R33^2 + R23^2 + R13^2 - 1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3*R33^2*I3 - Omega3*R23^2*I3 - Omega3*R13^2*I3 - Omega2*R33*R32*I2 - Omega2*R23*R22*I2 - Omega2*R13*R12*I2 - Omega1*R33*R31*I1 - Omega1*R23*R21*I1 - Omega1*R13*R11*I1 + Omega3*I3 : ℝ) / (I3) = 0 := by
  have key : (1 : ℝ) * (-Omega3*R33^2*I3 - Omega3*R23^2*I3 - Omega3*R13^2*I3 - Omega2*R33*R32*I2 - Omega2*R23*R22*I2 - Omega2*R13*R12*I2 - Omega1*R33*R31*I1 - Omega1*R23*R21*I1 - Omega1*R13*R11*I1 + Omega3*I3) = 0 := by linear_combination (-Omega1*I1) * h1 + (-Omega2*I2) * h2 + (-Omega3*I3) * h3
  have top : (-Omega3*R33^2*I3 - Omega3*R23^2*I3 - Omega3*R13^2*I3 - Omega2*R33*R32*I2 - Omega2*R23*R22*I2 - Omega2*R13*R12*I2 - Omega1*R33*R31*I1 - Omega1*R23*R21*I1 - Omega1*R13*R11*I1 + Omega3*I3 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
