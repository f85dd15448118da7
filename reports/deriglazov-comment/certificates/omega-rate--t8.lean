-- deriglazov-comment / omega-rate/t8: In t8.
--
-- Given: the definitions, the assumptions and t8, omega-of-m.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \omega = \frac{{\bf m}_3}{I_3}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (I3 I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3^5*I2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- {\bf w}_1 = 0
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_2 (I3 I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3^4*I2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- {\bf w}_2 = 0
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_3 (I3 I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3^4*I2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- {\bf w}_3 = \omega
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_4 (I3 I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3^4*I2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\omega} = 0
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_5 (I3 I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3^10*I2^2*I1^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
