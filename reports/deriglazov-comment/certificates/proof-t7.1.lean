-- deriglazov-comment / t7.1: The equation for the attitude with the momentum along z.
--
-- Given: the definitions, the assumptions and t3-attitude, momentum.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{R}_{11} = -(\frac{{\bf m}_3}{I_2}\cdot R_{32}\cdot R_{13}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot R_{33}\cdot R_{12})
-- Omega3_then stands for \Omega_3(0)
-- Omega2_then stands for \Omega_2(0)
-- Omega1_then stands for \Omega_1(0)
-- R23_then stands for R_{23}(0)
-- R22_then stands for R_{22}(0)
-- R21_then stands for R_{21}(0)
-- R13_then stands for R_{13}(0)
-- R12_then stands for R_{12}(0)
-- R11_then stands for R_{11}(0)
-- R23 stands for R_{23}
-- R22 stands for R_{22}
-- R13 stands for R_{13}
-- R12 stands for R_{12}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (Omega3_then Omega2_then Omega1_then R23_then R22_then R21_then R13_then R12_then R11_then R23 R22 R13 R12 I3 I2 I1 : ℝ)
    (h1 : -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1 = 0)
    (h2 : -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3_then*R23_then*R22*R13*I3^2 - Omega3_then*R13_then*R13*R12*I3^2 - Omega2_then*R22_then*R22*R13*I3*I2 + Omega3_then*R23_then*R23*R12*I3*I2 + Omega3_then*R13_then*R13*R12*I3*I2 - Omega2_then*R12_then*R13*R12*I3*I2 + Omega2_then*R22_then*R23*R12*I2^2 + Omega2_then*R12_then*R13*R12*I2^2 - Omega1_then*R21_then*R22*R13*I3*I1 - Omega1_then*R11_then*R13*R12*I3*I1 + Omega1_then*R21_then*R23*R12*I2*I1 + Omega1_then*R11_then*R13*R12*I2*I1 : ℝ) / (I3*I2) = 0 := by
  have key : (1 : ℝ) * (-Omega3_then*R23_then*R22*R13*I3^2 - Omega3_then*R13_then*R13*R12*I3^2 - Omega2_then*R22_then*R22*R13*I3*I2 + Omega3_then*R23_then*R23*R12*I3*I2 + Omega3_then*R13_then*R13*R12*I3*I2 - Omega2_then*R12_then*R13*R12*I3*I2 + Omega2_then*R22_then*R23*R12*I2^2 + Omega2_then*R12_then*R13*R12*I2^2 - Omega1_then*R21_then*R22*R13*I3*I1 - Omega1_then*R11_then*R13*R12*I3*I1 + Omega1_then*R21_then*R23*R12*I2*I1 + Omega1_then*R11_then*R13*R12*I2*I1) = 0 := by linear_combination (R22*R13*I3 - R23*R12*I2) * h1 + (R13*R12*I3 - R13*R12*I2) * h2
  have top : (-Omega3_then*R23_then*R22*R13*I3^2 - Omega3_then*R13_then*R13*R12*I3^2 - Omega2_then*R22_then*R22*R13*I3*I2 + Omega3_then*R23_then*R23*R12*I3*I2 + Omega3_then*R13_then*R13*R12*I3*I2 - Omega2_then*R12_then*R13*R12*I3*I2 + Omega2_then*R22_then*R23*R12*I2^2 + Omega2_then*R12_then*R13*R12*I2^2 - Omega1_then*R21_then*R22*R13*I3*I1 - Omega1_then*R11_then*R13*R12*I3*I1 + Omega1_then*R21_then*R23*R12*I2*I1 + Omega1_then*R11_then*R13*R12*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{12} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot R_{31}\cdot R_{13}+\frac{{\bf m}_3}{I_3}\cdot R_{33}\cdot R_{11})
-- Omega3_then stands for \Omega_3(0)
-- Omega2_then stands for \Omega_2(0)
-- Omega1_then stands for \Omega_1(0)
-- R23_then stands for R_{23}(0)
-- R22_then stands for R_{22}(0)
-- R21_then stands for R_{21}(0)
-- R13_then stands for R_{13}(0)
-- R12_then stands for R_{12}(0)
-- R11_then stands for R_{11}(0)
-- R23 stands for R_{23}
-- R21 stands for R_{21}
-- R13 stands for R_{13}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_2 (Omega3_then Omega2_then Omega1_then R23_then R22_then R21_then R13_then R12_then R11_then R23 R21 R13 R11 I3 I2 I1 : ℝ)
    (h1 : -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1 = 0)
    (h2 : -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (Omega3_then*R23_then*R21*R13*I3^2 + Omega3_then*R13_then*R13*R11*I3^2 + Omega2_then*R22_then*R21*R13*I3*I2 + Omega2_then*R12_then*R13*R11*I3*I2 + Omega1_then*R21_then*R21*R13*I3*I1 - Omega3_then*R23_then*R23*R11*I3*I1 - Omega3_then*R13_then*R13*R11*I3*I1 + Omega1_then*R11_then*R13*R11*I3*I1 - Omega2_then*R22_then*R23*R11*I2*I1 - Omega2_then*R12_then*R13*R11*I2*I1 - Omega1_then*R21_then*R23*R11*I1^2 - Omega1_then*R11_then*R13*R11*I1^2 : ℝ) / (I3*I1) = 0 := by
  have key : (1 : ℝ) * (Omega3_then*R23_then*R21*R13*I3^2 + Omega3_then*R13_then*R13*R11*I3^2 + Omega2_then*R22_then*R21*R13*I3*I2 + Omega2_then*R12_then*R13*R11*I3*I2 + Omega1_then*R21_then*R21*R13*I3*I1 - Omega3_then*R23_then*R23*R11*I3*I1 - Omega3_then*R13_then*R13*R11*I3*I1 + Omega1_then*R11_then*R13*R11*I3*I1 - Omega2_then*R22_then*R23*R11*I2*I1 - Omega2_then*R12_then*R13*R11*I2*I1 - Omega1_then*R21_then*R23*R11*I1^2 - Omega1_then*R11_then*R13*R11*I1^2) = 0 := by linear_combination (-R21*R13*I3 + R23*R11*I1) * h1 + (-R13*R11*I3 + R13*R11*I1) * h2
  have top : (Omega3_then*R23_then*R21*R13*I3^2 + Omega3_then*R13_then*R13*R11*I3^2 + Omega2_then*R22_then*R21*R13*I3*I2 + Omega2_then*R12_then*R13*R11*I3*I2 + Omega1_then*R21_then*R21*R13*I3*I1 - Omega3_then*R23_then*R23*R11*I3*I1 - Omega3_then*R13_then*R13*R11*I3*I1 + Omega1_then*R11_then*R13*R11*I3*I1 - Omega2_then*R22_then*R23*R11*I2*I1 - Omega2_then*R12_then*R13*R11*I2*I1 - Omega1_then*R21_then*R23*R11*I1^2 - Omega1_then*R11_then*R13*R11*I1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{13} = -(\frac{{\bf m}_3}{I_1}\cdot R_{31}\cdot R_{12}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot R_{32}\cdot R_{11})
-- Omega3_then stands for \Omega_3(0)
-- Omega2_then stands for \Omega_2(0)
-- Omega1_then stands for \Omega_1(0)
-- R23_then stands for R_{23}(0)
-- R22_then stands for R_{22}(0)
-- R21_then stands for R_{21}(0)
-- R13_then stands for R_{13}(0)
-- R12_then stands for R_{12}(0)
-- R11_then stands for R_{11}(0)
-- R22 stands for R_{22}
-- R21 stands for R_{21}
-- R12 stands for R_{12}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_3 (Omega3_then Omega2_then Omega1_then R23_then R22_then R21_then R13_then R12_then R11_then R22 R21 R12 R11 I3 I2 I1 : ℝ)
    (h1 : -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1 = 0)
    (h2 : -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3_then*R23_then*R21*R12*I3*I2 - Omega3_then*R13_then*R12*R11*I3*I2 - Omega2_then*R22_then*R21*R12*I2^2 - Omega2_then*R12_then*R12*R11*I2^2 + Omega3_then*R23_then*R22*R11*I3*I1 + Omega3_then*R13_then*R12*R11*I3*I1 - Omega1_then*R21_then*R21*R12*I2*I1 + Omega2_then*R22_then*R22*R11*I2*I1 + Omega2_then*R12_then*R12*R11*I2*I1 - Omega1_then*R11_then*R12*R11*I2*I1 + Omega1_then*R21_then*R22*R11*I1^2 + Omega1_then*R11_then*R12*R11*I1^2 : ℝ) / (I2*I1) = 0 := by
  have key : (1 : ℝ) * (-Omega3_then*R23_then*R21*R12*I3*I2 - Omega3_then*R13_then*R12*R11*I3*I2 - Omega2_then*R22_then*R21*R12*I2^2 - Omega2_then*R12_then*R12*R11*I2^2 + Omega3_then*R23_then*R22*R11*I3*I1 + Omega3_then*R13_then*R12*R11*I3*I1 - Omega1_then*R21_then*R21*R12*I2*I1 + Omega2_then*R22_then*R22*R11*I2*I1 + Omega2_then*R12_then*R12*R11*I2*I1 - Omega1_then*R11_then*R12*R11*I2*I1 + Omega1_then*R21_then*R22*R11*I1^2 + Omega1_then*R11_then*R12*R11*I1^2) = 0 := by linear_combination (R21*R12*I2 - R22*R11*I1) * h1 + (R12*R11*I2 - R12*R11*I1) * h2
  have top : (-Omega3_then*R23_then*R21*R12*I3*I2 - Omega3_then*R13_then*R12*R11*I3*I2 - Omega2_then*R22_then*R21*R12*I2^2 - Omega2_then*R12_then*R12*R11*I2^2 + Omega3_then*R23_then*R22*R11*I3*I1 + Omega3_then*R13_then*R12*R11*I3*I1 - Omega1_then*R21_then*R21*R12*I2*I1 + Omega2_then*R22_then*R22*R11*I2*I1 + Omega2_then*R12_then*R12*R11*I2*I1 - Omega1_then*R11_then*R12*R11*I2*I1 + Omega1_then*R21_then*R22*R11*I1^2 + Omega1_then*R11_then*R12*R11*I1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{21} = -(\frac{{\bf m}_3}{I_2}\cdot R_{32}\cdot R_{23}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot R_{33}\cdot R_{22})
-- Omega3_then stands for \Omega_3(0)
-- Omega2_then stands for \Omega_2(0)
-- Omega1_then stands for \Omega_1(0)
-- R23_then stands for R_{23}(0)
-- R22_then stands for R_{22}(0)
-- R21_then stands for R_{21}(0)
-- R13_then stands for R_{13}(0)
-- R12_then stands for R_{12}(0)
-- R11_then stands for R_{11}(0)
-- R23 stands for R_{23}
-- R22 stands for R_{22}
-- R13 stands for R_{13}
-- R12 stands for R_{12}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_4 (Omega3_then Omega2_then Omega1_then R23_then R22_then R21_then R13_then R12_then R11_then R23 R22 R13 R12 I3 I2 I1 : ℝ)
    (h1 : -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1 = 0)
    (h2 : -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3_then*R23_then*R23*R22*I3^2 - Omega3_then*R13_then*R23*R12*I3^2 + Omega3_then*R23_then*R23*R22*I3*I2 - Omega2_then*R22_then*R23*R22*I3*I2 + Omega3_then*R13_then*R22*R13*I3*I2 - Omega2_then*R12_then*R23*R12*I3*I2 + Omega2_then*R22_then*R23*R22*I2^2 + Omega2_then*R12_then*R22*R13*I2^2 - Omega1_then*R21_then*R23*R22*I3*I1 - Omega1_then*R11_then*R23*R12*I3*I1 + Omega1_then*R21_then*R23*R22*I2*I1 + Omega1_then*R11_then*R22*R13*I2*I1 : ℝ) / (I3*I2) = 0 := by
  have key : (1 : ℝ) * (-Omega3_then*R23_then*R23*R22*I3^2 - Omega3_then*R13_then*R23*R12*I3^2 + Omega3_then*R23_then*R23*R22*I3*I2 - Omega2_then*R22_then*R23*R22*I3*I2 + Omega3_then*R13_then*R22*R13*I3*I2 - Omega2_then*R12_then*R23*R12*I3*I2 + Omega2_then*R22_then*R23*R22*I2^2 + Omega2_then*R12_then*R22*R13*I2^2 - Omega1_then*R21_then*R23*R22*I3*I1 - Omega1_then*R11_then*R23*R12*I3*I1 + Omega1_then*R21_then*R23*R22*I2*I1 + Omega1_then*R11_then*R22*R13*I2*I1) = 0 := by linear_combination (R23*R22*I3 - R23*R22*I2) * h1 + (R23*R12*I3 - R22*R13*I2) * h2
  have top : (-Omega3_then*R23_then*R23*R22*I3^2 - Omega3_then*R13_then*R23*R12*I3^2 + Omega3_then*R23_then*R23*R22*I3*I2 - Omega2_then*R22_then*R23*R22*I3*I2 + Omega3_then*R13_then*R22*R13*I3*I2 - Omega2_then*R12_then*R23*R12*I3*I2 + Omega2_then*R22_then*R23*R22*I2^2 + Omega2_then*R12_then*R22*R13*I2^2 - Omega1_then*R21_then*R23*R22*I3*I1 - Omega1_then*R11_then*R23*R12*I3*I1 + Omega1_then*R21_then*R23*R22*I2*I1 + Omega1_then*R11_then*R22*R13*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{22} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot R_{31}\cdot R_{23}+\frac{{\bf m}_3}{I_3}\cdot R_{33}\cdot R_{21})
-- Omega3_then stands for \Omega_3(0)
-- Omega2_then stands for \Omega_2(0)
-- Omega1_then stands for \Omega_1(0)
-- R23_then stands for R_{23}(0)
-- R22_then stands for R_{22}(0)
-- R21_then stands for R_{21}(0)
-- R13_then stands for R_{13}(0)
-- R12_then stands for R_{12}(0)
-- R11_then stands for R_{11}(0)
-- R23 stands for R_{23}
-- R21 stands for R_{21}
-- R13 stands for R_{13}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_5 (Omega3_then Omega2_then Omega1_then R23_then R22_then R21_then R13_then R12_then R11_then R23 R21 R13 R11 I3 I2 I1 : ℝ)
    (h1 : -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1 = 0)
    (h2 : -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (Omega3_then*R23_then*R23*R21*I3^2 + Omega3_then*R13_then*R23*R11*I3^2 + Omega2_then*R22_then*R23*R21*I3*I2 + Omega2_then*R12_then*R23*R11*I3*I2 - Omega3_then*R23_then*R23*R21*I3*I1 + Omega1_then*R21_then*R23*R21*I3*I1 - Omega3_then*R13_then*R21*R13*I3*I1 + Omega1_then*R11_then*R23*R11*I3*I1 - Omega2_then*R22_then*R23*R21*I2*I1 - Omega2_then*R12_then*R21*R13*I2*I1 - Omega1_then*R21_then*R23*R21*I1^2 - Omega1_then*R11_then*R21*R13*I1^2 : ℝ) / (I3*I1) = 0 := by
  have key : (1 : ℝ) * (Omega3_then*R23_then*R23*R21*I3^2 + Omega3_then*R13_then*R23*R11*I3^2 + Omega2_then*R22_then*R23*R21*I3*I2 + Omega2_then*R12_then*R23*R11*I3*I2 - Omega3_then*R23_then*R23*R21*I3*I1 + Omega1_then*R21_then*R23*R21*I3*I1 - Omega3_then*R13_then*R21*R13*I3*I1 + Omega1_then*R11_then*R23*R11*I3*I1 - Omega2_then*R22_then*R23*R21*I2*I1 - Omega2_then*R12_then*R21*R13*I2*I1 - Omega1_then*R21_then*R23*R21*I1^2 - Omega1_then*R11_then*R21*R13*I1^2) = 0 := by linear_combination (-R23*R21*I3 + R23*R21*I1) * h1 + (-R23*R11*I3 + R21*R13*I1) * h2
  have top : (Omega3_then*R23_then*R23*R21*I3^2 + Omega3_then*R13_then*R23*R11*I3^2 + Omega2_then*R22_then*R23*R21*I3*I2 + Omega2_then*R12_then*R23*R11*I3*I2 - Omega3_then*R23_then*R23*R21*I3*I1 + Omega1_then*R21_then*R23*R21*I3*I1 - Omega3_then*R13_then*R21*R13*I3*I1 + Omega1_then*R11_then*R23*R11*I3*I1 - Omega2_then*R22_then*R23*R21*I2*I1 - Omega2_then*R12_then*R21*R13*I2*I1 - Omega1_then*R21_then*R23*R21*I1^2 - Omega1_then*R11_then*R21*R13*I1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{23} = -(\frac{{\bf m}_3}{I_1}\cdot R_{31}\cdot R_{22}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot R_{32}\cdot R_{21})
-- Omega3_then stands for \Omega_3(0)
-- Omega2_then stands for \Omega_2(0)
-- Omega1_then stands for \Omega_1(0)
-- R23_then stands for R_{23}(0)
-- R22_then stands for R_{22}(0)
-- R21_then stands for R_{21}(0)
-- R13_then stands for R_{13}(0)
-- R12_then stands for R_{12}(0)
-- R11_then stands for R_{11}(0)
-- R22 stands for R_{22}
-- R21 stands for R_{21}
-- R12 stands for R_{12}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_6 (Omega3_then Omega2_then Omega1_then R23_then R22_then R21_then R13_then R12_then R11_then R22 R21 R12 R11 I3 I2 I1 : ℝ)
    (h1 : -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1 = 0)
    (h2 : -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3_then*R23_then*R22*R21*I3*I2 - Omega3_then*R13_then*R22*R11*I3*I2 - Omega2_then*R22_then*R22*R21*I2^2 - Omega2_then*R12_then*R22*R11*I2^2 + Omega3_then*R23_then*R22*R21*I3*I1 + Omega3_then*R13_then*R21*R12*I3*I1 + Omega2_then*R22_then*R22*R21*I2*I1 - Omega1_then*R21_then*R22*R21*I2*I1 + Omega2_then*R12_then*R21*R12*I2*I1 - Omega1_then*R11_then*R22*R11*I2*I1 + Omega1_then*R21_then*R22*R21*I1^2 + Omega1_then*R11_then*R21*R12*I1^2 : ℝ) / (I2*I1) = 0 := by
  have key : (1 : ℝ) * (-Omega3_then*R23_then*R22*R21*I3*I2 - Omega3_then*R13_then*R22*R11*I3*I2 - Omega2_then*R22_then*R22*R21*I2^2 - Omega2_then*R12_then*R22*R11*I2^2 + Omega3_then*R23_then*R22*R21*I3*I1 + Omega3_then*R13_then*R21*R12*I3*I1 + Omega2_then*R22_then*R22*R21*I2*I1 - Omega1_then*R21_then*R22*R21*I2*I1 + Omega2_then*R12_then*R21*R12*I2*I1 - Omega1_then*R11_then*R22*R11*I2*I1 + Omega1_then*R21_then*R22*R21*I1^2 + Omega1_then*R11_then*R21*R12*I1^2) = 0 := by linear_combination (R22*R21*I2 - R22*R21*I1) * h1 + (R22*R11*I2 - R21*R12*I1) * h2
  have top : (-Omega3_then*R23_then*R22*R21*I3*I2 - Omega3_then*R13_then*R22*R11*I3*I2 - Omega2_then*R22_then*R22*R21*I2^2 - Omega2_then*R12_then*R22*R11*I2^2 + Omega3_then*R23_then*R22*R21*I3*I1 + Omega3_then*R13_then*R21*R12*I3*I1 + Omega2_then*R22_then*R22*R21*I2*I1 - Omega1_then*R21_then*R22*R21*I2*I1 + Omega2_then*R12_then*R21*R12*I2*I1 - Omega1_then*R11_then*R22*R11*I2*I1 + Omega1_then*R21_then*R22*R21*I1^2 + Omega1_then*R11_then*R21*R12*I1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{31} = -(\frac{{\bf m}_3}{I_2}\cdot R_{32}\cdot R_{33}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot R_{33}\cdot R_{32})
-- Omega3_then stands for \Omega_3(0)
-- Omega2_then stands for \Omega_2(0)
-- Omega1_then stands for \Omega_1(0)
-- R23_then stands for R_{23}(0)
-- R22_then stands for R_{22}(0)
-- R21_then stands for R_{21}(0)
-- R13_then stands for R_{13}(0)
-- R12_then stands for R_{12}(0)
-- R11_then stands for R_{11}(0)
-- R33 stands for R_{33}
-- R32 stands for R_{32}
-- R23 stands for R_{23}
-- R22 stands for R_{22}
-- R13 stands for R_{13}
-- R12 stands for R_{12}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_7 (Omega3_then Omega2_then Omega1_then R23_then R22_then R21_then R13_then R12_then R11_then R33 R32 R23 R22 R13 R12 I3 I2 I1 : ℝ)
    (h1 : -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1 = 0)
    (h2 : -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3_then*R23_then*R33*R22*I3^2 - Omega3_then*R13_then*R33*R12*I3^2 + Omega3_then*R23_then*R32*R23*I3*I2 - Omega2_then*R22_then*R33*R22*I3*I2 + Omega3_then*R13_then*R32*R13*I3*I2 - Omega2_then*R12_then*R33*R12*I3*I2 + Omega2_then*R22_then*R32*R23*I2^2 + Omega2_then*R12_then*R32*R13*I2^2 - Omega1_then*R21_then*R33*R22*I3*I1 - Omega1_then*R11_then*R33*R12*I3*I1 + Omega1_then*R21_then*R32*R23*I2*I1 + Omega1_then*R11_then*R32*R13*I2*I1 : ℝ) / (I3*I2) = 0 := by
  have key : (1 : ℝ) * (-Omega3_then*R23_then*R33*R22*I3^2 - Omega3_then*R13_then*R33*R12*I3^2 + Omega3_then*R23_then*R32*R23*I3*I2 - Omega2_then*R22_then*R33*R22*I3*I2 + Omega3_then*R13_then*R32*R13*I3*I2 - Omega2_then*R12_then*R33*R12*I3*I2 + Omega2_then*R22_then*R32*R23*I2^2 + Omega2_then*R12_then*R32*R13*I2^2 - Omega1_then*R21_then*R33*R22*I3*I1 - Omega1_then*R11_then*R33*R12*I3*I1 + Omega1_then*R21_then*R32*R23*I2*I1 + Omega1_then*R11_then*R32*R13*I2*I1) = 0 := by linear_combination (R33*R22*I3 - R32*R23*I2) * h1 + (R33*R12*I3 - R32*R13*I2) * h2
  have top : (-Omega3_then*R23_then*R33*R22*I3^2 - Omega3_then*R13_then*R33*R12*I3^2 + Omega3_then*R23_then*R32*R23*I3*I2 - Omega2_then*R22_then*R33*R22*I3*I2 + Omega3_then*R13_then*R32*R13*I3*I2 - Omega2_then*R12_then*R33*R12*I3*I2 + Omega2_then*R22_then*R32*R23*I2^2 + Omega2_then*R12_then*R32*R13*I2^2 - Omega1_then*R21_then*R33*R22*I3*I1 - Omega1_then*R11_then*R33*R12*I3*I1 + Omega1_then*R21_then*R32*R23*I2*I1 + Omega1_then*R11_then*R32*R13*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{32} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot R_{31}\cdot R_{33}+\frac{{\bf m}_3}{I_3}\cdot R_{33}\cdot R_{31})
-- Omega3_then stands for \Omega_3(0)
-- Omega2_then stands for \Omega_2(0)
-- Omega1_then stands for \Omega_1(0)
-- R23_then stands for R_{23}(0)
-- R22_then stands for R_{22}(0)
-- R21_then stands for R_{21}(0)
-- R13_then stands for R_{13}(0)
-- R12_then stands for R_{12}(0)
-- R11_then stands for R_{11}(0)
-- R33 stands for R_{33}
-- R31 stands for R_{31}
-- R23 stands for R_{23}
-- R21 stands for R_{21}
-- R13 stands for R_{13}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_8 (Omega3_then Omega2_then Omega1_then R23_then R22_then R21_then R13_then R12_then R11_then R33 R31 R23 R21 R13 R11 I3 I2 I1 : ℝ)
    (h1 : -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1 = 0)
    (h2 : -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (Omega3_then*R23_then*R33*R21*I3^2 + Omega3_then*R13_then*R33*R11*I3^2 + Omega2_then*R22_then*R33*R21*I3*I2 + Omega2_then*R12_then*R33*R11*I3*I2 - Omega3_then*R23_then*R31*R23*I3*I1 + Omega1_then*R21_then*R33*R21*I3*I1 - Omega3_then*R13_then*R31*R13*I3*I1 + Omega1_then*R11_then*R33*R11*I3*I1 - Omega2_then*R22_then*R31*R23*I2*I1 - Omega2_then*R12_then*R31*R13*I2*I1 - Omega1_then*R21_then*R31*R23*I1^2 - Omega1_then*R11_then*R31*R13*I1^2 : ℝ) / (I3*I1) = 0 := by
  have key : (1 : ℝ) * (Omega3_then*R23_then*R33*R21*I3^2 + Omega3_then*R13_then*R33*R11*I3^2 + Omega2_then*R22_then*R33*R21*I3*I2 + Omega2_then*R12_then*R33*R11*I3*I2 - Omega3_then*R23_then*R31*R23*I3*I1 + Omega1_then*R21_then*R33*R21*I3*I1 - Omega3_then*R13_then*R31*R13*I3*I1 + Omega1_then*R11_then*R33*R11*I3*I1 - Omega2_then*R22_then*R31*R23*I2*I1 - Omega2_then*R12_then*R31*R13*I2*I1 - Omega1_then*R21_then*R31*R23*I1^2 - Omega1_then*R11_then*R31*R13*I1^2) = 0 := by linear_combination (-R33*R21*I3 + R31*R23*I1) * h1 + (-R33*R11*I3 + R31*R13*I1) * h2
  have top : (Omega3_then*R23_then*R33*R21*I3^2 + Omega3_then*R13_then*R33*R11*I3^2 + Omega2_then*R22_then*R33*R21*I3*I2 + Omega2_then*R12_then*R33*R11*I3*I2 - Omega3_then*R23_then*R31*R23*I3*I1 + Omega1_then*R21_then*R33*R21*I3*I1 - Omega3_then*R13_then*R31*R13*I3*I1 + Omega1_then*R11_then*R33*R11*I3*I1 - Omega2_then*R22_then*R31*R23*I2*I1 - Omega2_then*R12_then*R31*R13*I2*I1 - Omega1_then*R21_then*R31*R23*I1^2 - Omega1_then*R11_then*R31*R13*I1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{33} = -(\frac{{\bf m}_3}{I_1}\cdot R_{31}\cdot R_{32}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot R_{32}\cdot R_{31})
-- Omega3_then stands for \Omega_3(0)
-- Omega2_then stands for \Omega_2(0)
-- Omega1_then stands for \Omega_1(0)
-- R23_then stands for R_{23}(0)
-- R22_then stands for R_{22}(0)
-- R21_then stands for R_{21}(0)
-- R13_then stands for R_{13}(0)
-- R12_then stands for R_{12}(0)
-- R11_then stands for R_{11}(0)
-- R32 stands for R_{32}
-- R31 stands for R_{31}
-- R22 stands for R_{22}
-- R21 stands for R_{21}
-- R12 stands for R_{12}
-- R11 stands for R_{11}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_9 (Omega3_then Omega2_then Omega1_then R23_then R22_then R21_then R13_then R12_then R11_then R32 R31 R22 R21 R12 R11 I3 I2 I1 : ℝ)
    (h1 : -Omega3_then*R23_then*I3 - Omega2_then*R22_then*I2 - Omega1_then*R21_then*I1 = 0)
    (h2 : -Omega3_then*R13_then*I3 - Omega2_then*R12_then*I2 - Omega1_then*R11_then*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3_then*R23_then*R32*R21*I3*I2 - Omega3_then*R13_then*R32*R11*I3*I2 - Omega2_then*R22_then*R32*R21*I2^2 - Omega2_then*R12_then*R32*R11*I2^2 + Omega3_then*R23_then*R31*R22*I3*I1 + Omega3_then*R13_then*R31*R12*I3*I1 + Omega2_then*R22_then*R31*R22*I2*I1 - Omega1_then*R21_then*R32*R21*I2*I1 + Omega2_then*R12_then*R31*R12*I2*I1 - Omega1_then*R11_then*R32*R11*I2*I1 + Omega1_then*R21_then*R31*R22*I1^2 + Omega1_then*R11_then*R31*R12*I1^2 : ℝ) / (I2*I1) = 0 := by
  have key : (1 : ℝ) * (-Omega3_then*R23_then*R32*R21*I3*I2 - Omega3_then*R13_then*R32*R11*I3*I2 - Omega2_then*R22_then*R32*R21*I2^2 - Omega2_then*R12_then*R32*R11*I2^2 + Omega3_then*R23_then*R31*R22*I3*I1 + Omega3_then*R13_then*R31*R12*I3*I1 + Omega2_then*R22_then*R31*R22*I2*I1 - Omega1_then*R21_then*R32*R21*I2*I1 + Omega2_then*R12_then*R31*R12*I2*I1 - Omega1_then*R11_then*R32*R11*I2*I1 + Omega1_then*R21_then*R31*R22*I1^2 + Omega1_then*R11_then*R31*R12*I1^2) = 0 := by linear_combination (R32*R21*I2 - R31*R22*I1) * h1 + (R32*R11*I2 - R31*R12*I1) * h2
  have top : (-Omega3_then*R23_then*R32*R21*I3*I2 - Omega3_then*R13_then*R32*R11*I3*I2 - Omega2_then*R22_then*R32*R21*I2^2 - Omega2_then*R12_then*R32*R11*I2^2 + Omega3_then*R23_then*R31*R22*I3*I1 + Omega3_then*R13_then*R31*R12*I3*I1 + Omega2_then*R22_then*R31*R22*I2*I1 - Omega1_then*R21_then*R32*R21*I2*I1 + Omega2_then*R12_then*R31*R12*I2*I1 - Omega1_then*R11_then*R32*R11*I2*I1 + Omega1_then*R21_then*R31*R22*I1^2 + Omega1_then*R11_then*R31*R12*I1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
