-- deriglazov-comment / t8-solves: Uniform rotation with the rate m₃/I₃ solves t7.1 and starts at R = 1, for all moments and either sign of m₃.
--
-- Given: the definitions, the assumptions and momentum.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{Q}_{11} = -(\frac{{\bf m}_3}{I_2}\cdot Q_{32}\cdot Q_{13}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot Q_{33}\cdot Q_{12})
-- I3 stands for I_3
-- I2 stands for I_2
theorem equation_1 (I3 I2 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3^2*I2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{Q}_{12} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot Q_{31}\cdot Q_{13}+\frac{{\bf m}_3}{I_3}\cdot Q_{33}\cdot Q_{11})
-- I3 stands for I_3
-- I1 stands for I_1
theorem equation_2 (I3 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3^2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{Q}_{13} = -(\frac{{\bf m}_3}{I_1}\cdot Q_{31}\cdot Q_{12}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot Q_{32}\cdot Q_{11})
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_3 (I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{Q}_{21} = -(\frac{{\bf m}_3}{I_2}\cdot Q_{32}\cdot Q_{23}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot Q_{33}\cdot Q_{22})
-- I3 stands for I_3
-- I2 stands for I_2
theorem equation_4 (I3 I2 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3^2*I2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{Q}_{22} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot Q_{31}\cdot Q_{23}+\frac{{\bf m}_3}{I_3}\cdot Q_{33}\cdot Q_{21})
-- I3 stands for I_3
-- I1 stands for I_1
theorem equation_5 (I3 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3^2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{Q}_{23} = -(\frac{{\bf m}_3}{I_1}\cdot Q_{31}\cdot Q_{22}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot Q_{32}\cdot Q_{21})
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_6 (I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{Q}_{31} = -(\frac{{\bf m}_3}{I_2}\cdot Q_{32}\cdot Q_{33}+\frac{{\bf m}_3}{I_3}\cdot (-1)\cdot Q_{33}\cdot Q_{32})
-- I3 stands for I_3
-- I2 stands for I_2
theorem equation_7 (I3 I2 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3*I2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{Q}_{32} = -(\frac{{\bf m}_3}{I_1}\cdot (-1)\cdot Q_{31}\cdot Q_{33}+\frac{{\bf m}_3}{I_3}\cdot Q_{33}\cdot Q_{31})
-- I3 stands for I_3
-- I1 stands for I_1
theorem equation_8 (I3 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{Q}_{33} = -(\frac{{\bf m}_3}{I_1}\cdot Q_{31}\cdot Q_{32}+\frac{{\bf m}_3}{I_2}\cdot (-1)\cdot Q_{32}\cdot Q_{31})
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_9 (I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- Q_{11}(0) = 1
theorem equation_10
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- Q_{12}(0) = 0
theorem equation_11
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- Q_{21}(0) = 0
theorem equation_12
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- Q_{22}(0) = 1
theorem equation_13
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
