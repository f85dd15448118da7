-- deriglazov-comment / point-of-the-body/body-coordinates: The position at the start is given in the body's axes.
--
-- Given: the definitions, the assumptions and euler-poisson.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- {\bf x}_{N1} = R_{11}\cdot (R_{11}(0)\cdot \frac{31}{100}+R_{21}(0)\cdot (-\frac{47}{100})+R_{31}(0)\cdot \frac{83}{100})+R_{12}\cdot (R_{12}(0)\cdot \frac{31}{100}+R_{22}(0)\cdot (-\frac{47}{100})+R_{32}(0)\cdot \frac{83}{100})+R_{13}\cdot (R_{13}(0)\cdot \frac{31}{100}+R_{23}(0)\cdot (-\frac{47}{100})+R_{33}(0)\cdot \frac{83}{100})
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (100) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- {\bf x}_{N2} = R_{21}\cdot (R_{11}(0)\cdot \frac{31}{100}+R_{21}(0)\cdot (-\frac{47}{100})+R_{31}(0)\cdot \frac{83}{100})+R_{22}\cdot (R_{12}(0)\cdot \frac{31}{100}+R_{22}(0)\cdot (-\frac{47}{100})+R_{32}(0)\cdot \frac{83}{100})+R_{23}\cdot (R_{13}(0)\cdot \frac{31}{100}+R_{23}(0)\cdot (-\frac{47}{100})+R_{33}(0)\cdot \frac{83}{100})
theorem equation_2
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (100) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- {\bf x}_{N3} = R_{31}\cdot (R_{11}(0)\cdot \frac{31}{100}+R_{21}(0)\cdot (-\frac{47}{100})+R_{31}(0)\cdot \frac{83}{100})+R_{32}\cdot (R_{12}(0)\cdot \frac{31}{100}+R_{22}(0)\cdot (-\frac{47}{100})+R_{32}(0)\cdot \frac{83}{100})+R_{33}\cdot (R_{13}(0)\cdot \frac{31}{100}+R_{23}(0)\cdot (-\frac{47}{100})+R_{33}(0)\cdot \frac{83}{100})
theorem equation_3
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (100) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
