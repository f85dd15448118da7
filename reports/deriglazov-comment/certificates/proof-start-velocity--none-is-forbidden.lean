-- deriglazov-comment / start-velocity/none-is-forbidden: Every Ω(0) is allowed: it fixes m, and m fixes it back through R(0).
--
-- Given: the definitions, the assumptions and omega-of-m, momentum, start-is-a-rotation.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- {\bf m}_1 = R_{11}\cdot (I_1\cdot \Omega_1)+R_{12}\cdot (I_2\cdot \Omega_2)+R_{13}\cdot (I_3\cdot \Omega_3)
-- m3_then stands for {\bf m}_3(0)
-- m2_then stands for {\bf m}_2(0)
-- m1_then stands for {\bf m}_1(0)
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
theorem equation_1 (m3_then m2_then m1_then R33 R32 R31 R23 R22 R21 R13 R12 R11 I3 I2 I1 : ℝ)
    (h1 : R13^2 + R12^2 + R11^2 - 1 = 0)
    (h2 : R23*R13 + R22*R12 + R21*R11 = 0)
    (h3 : R33*R13 + R32*R12 + R31*R11 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-m3_then*R33*R13*I3*I2*I1 - m2_then*R23*R13*I3*I2*I1 - m1_then*R13^2*I3*I2*I1 - m3_then*R32*R12*I3*I2*I1 - m2_then*R22*R12*I3*I2*I1 - m1_then*R12^2*I3*I2*I1 - m3_then*R31*R11*I3*I2*I1 - m2_then*R21*R11*I3*I2*I1 - m1_then*R11^2*I3*I2*I1 + m1_then*I3*I2*I1 : ℝ) / (I3*I2*I1) = 0 := by
  have key : (1 : ℝ) * (-m3_then*R33*R13*I3*I2*I1 - m2_then*R23*R13*I3*I2*I1 - m1_then*R13^2*I3*I2*I1 - m3_then*R32*R12*I3*I2*I1 - m2_then*R22*R12*I3*I2*I1 - m1_then*R12^2*I3*I2*I1 - m3_then*R31*R11*I3*I2*I1 - m2_then*R21*R11*I3*I2*I1 - m1_then*R11^2*I3*I2*I1 + m1_then*I3*I2*I1) = 0 := by linear_combination (-m1_then*I3*I2*I1) * h1 + (-m2_then*I3*I2*I1) * h2 + (-m3_then*I3*I2*I1) * h3
  have top : (-m3_then*R33*R13*I3*I2*I1 - m2_then*R23*R13*I3*I2*I1 - m1_then*R13^2*I3*I2*I1 - m3_then*R32*R12*I3*I2*I1 - m2_then*R22*R12*I3*I2*I1 - m1_then*R12^2*I3*I2*I1 - m3_then*R31*R11*I3*I2*I1 - m2_then*R21*R11*I3*I2*I1 - m1_then*R11^2*I3*I2*I1 + m1_then*I3*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- {\bf m}_2 = R_{21}\cdot (I_1\cdot \Omega_1)+R_{22}\cdot (I_2\cdot \Omega_2)+R_{23}\cdot (I_3\cdot \Omega_3)
-- m3_then stands for {\bf m}_3(0)
-- m2_then stands for {\bf m}_2(0)
-- m1_then stands for {\bf m}_1(0)
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
theorem equation_2 (m3_then m2_then m1_then R33 R32 R31 R23 R22 R21 R13 R12 R11 I3 I2 I1 : ℝ)
    (h1 : R23*R13 + R22*R12 + R21*R11 = 0)
    (h2 : R23^2 + R22^2 + R21^2 - 1 = 0)
    (h3 : R33*R23 + R32*R22 + R31*R21 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-m3_then*R33*R23*I3*I2*I1 - m2_then*R23^2*I3*I2*I1 - m3_then*R32*R22*I3*I2*I1 - m2_then*R22^2*I3*I2*I1 - m3_then*R31*R21*I3*I2*I1 - m2_then*R21^2*I3*I2*I1 - m1_then*R23*R13*I3*I2*I1 - m1_then*R22*R12*I3*I2*I1 - m1_then*R21*R11*I3*I2*I1 + m2_then*I3*I2*I1 : ℝ) / (I3*I2*I1) = 0 := by
  have key : (1 : ℝ) * (-m3_then*R33*R23*I3*I2*I1 - m2_then*R23^2*I3*I2*I1 - m3_then*R32*R22*I3*I2*I1 - m2_then*R22^2*I3*I2*I1 - m3_then*R31*R21*I3*I2*I1 - m2_then*R21^2*I3*I2*I1 - m1_then*R23*R13*I3*I2*I1 - m1_then*R22*R12*I3*I2*I1 - m1_then*R21*R11*I3*I2*I1 + m2_then*I3*I2*I1) = 0 := by linear_combination (-m1_then*I3*I2*I1) * h1 + (-m2_then*I3*I2*I1) * h2 + (-m3_then*I3*I2*I1) * h3
  have top : (-m3_then*R33*R23*I3*I2*I1 - m2_then*R23^2*I3*I2*I1 - m3_then*R32*R22*I3*I2*I1 - m2_then*R22^2*I3*I2*I1 - m3_then*R31*R21*I3*I2*I1 - m2_then*R21^2*I3*I2*I1 - m1_then*R23*R13*I3*I2*I1 - m1_then*R22*R12*I3*I2*I1 - m1_then*R21*R11*I3*I2*I1 + m2_then*I3*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- {\bf m}_3 = R_{31}\cdot (I_1\cdot \Omega_1)+R_{32}\cdot (I_2\cdot \Omega_2)+R_{33}\cdot (I_3\cdot \Omega_3)
-- m3_then stands for {\bf m}_3(0)
-- m2_then stands for {\bf m}_2(0)
-- m1_then stands for {\bf m}_1(0)
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
theorem equation_3 (m3_then m2_then m1_then R33 R32 R31 R23 R22 R21 R13 R12 R11 I3 I2 I1 : ℝ)
    (h1 : R33*R13 + R32*R12 + R31*R11 = 0)
    (h2 : R33*R23 + R32*R22 + R31*R21 = 0)
    (h3 : R33^2 + R32^2 + R31^2 - 1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-m3_then*R33^2*I3*I2*I1 - m3_then*R32^2*I3*I2*I1 - m3_then*R31^2*I3*I2*I1 - m2_then*R33*R23*I3*I2*I1 - m2_then*R32*R22*I3*I2*I1 - m2_then*R31*R21*I3*I2*I1 - m1_then*R33*R13*I3*I2*I1 - m1_then*R32*R12*I3*I2*I1 - m1_then*R31*R11*I3*I2*I1 + m3_then*I3*I2*I1 : ℝ) / (I3*I2*I1) = 0 := by
  have key : (1 : ℝ) * (-m3_then*R33^2*I3*I2*I1 - m3_then*R32^2*I3*I2*I1 - m3_then*R31^2*I3*I2*I1 - m2_then*R33*R23*I3*I2*I1 - m2_then*R32*R22*I3*I2*I1 - m2_then*R31*R21*I3*I2*I1 - m1_then*R33*R13*I3*I2*I1 - m1_then*R32*R12*I3*I2*I1 - m1_then*R31*R11*I3*I2*I1 + m3_then*I3*I2*I1) = 0 := by linear_combination (-m1_then*I3*I2*I1) * h1 + (-m2_then*I3*I2*I1) * h2 + (-m3_then*I3*I2*I1) * h3
  have top : (-m3_then*R33^2*I3*I2*I1 - m3_then*R32^2*I3*I2*I1 - m3_then*R31^2*I3*I2*I1 - m2_then*R33*R23*I3*I2*I1 - m2_then*R32*R22*I3*I2*I1 - m2_then*R31*R21*I3*I2*I1 - m1_then*R33*R13*I3*I2*I1 - m1_then*R32*R12*I3*I2*I1 - m1_then*R31*R11*I3*I2*I1 + m3_then*I3*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
