-- deriglazov-comment / psi0-in-t11/for-any-energy: The right side of t11 vanishes at ψ₀, whatever E is.
--
-- Given: the definitions, the assumptions and psi0-formula.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (\frac{1}{I_1}-\frac{1}{I_3}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))^{2})\cdot (\frac{1}{I_3}-\frac{2\cdot E}{{\bf m}_3^2}+(\frac{1}{I_1}-\frac{1}{I_3})-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\arccos(\sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}})))^{2}) = 0
-- root stands for \sqrt{\frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}}
-- E stands for E
-- m3 stands for {\bf m}_3
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (root E m3 I3 I2 I1 : ℝ)
    (h1 : root^2*I3*I2 - root^2*I3*I1 - I3*I2 + I2*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (root^4*m3^2*I3^3*I2^2*I1^2 - 2*root^4*m3^2*I3^3*I2*I1^3 + root^4*m3^2*I3^3*I1^4 - 2*root^2*m3^2*I3^3*I2^2*I1^2 + 2*root^2*m3^2*I3^3*I2*I1^3 + root^2*m3^2*I3^2*I2^2*I1^3 + 2*root^2*E*I3^3*I2^2*I1^3 - root^2*m3^2*I3^2*I2*I1^4 - 2*root^2*E*I3^3*I2*I1^4 + m3^2*I3^3*I2^2*I1^2 - m3^2*I3^2*I2^2*I1^3 - 2*E*I3^3*I2^2*I1^3 + 2*E*I3^2*I2^2*I1^4 : ℝ) / (m3^2*I3^3*I2^2*I1^4) = 0 := by
  have key : (1 : ℝ) * (root^4*m3^2*I3^3*I2^2*I1^2 - 2*root^4*m3^2*I3^3*I2*I1^3 + root^4*m3^2*I3^3*I1^4 - 2*root^2*m3^2*I3^3*I2^2*I1^2 + 2*root^2*m3^2*I3^3*I2*I1^3 + root^2*m3^2*I3^2*I2^2*I1^3 + 2*root^2*E*I3^3*I2^2*I1^3 - root^2*m3^2*I3^2*I2*I1^4 - 2*root^2*E*I3^3*I2*I1^4 + m3^2*I3^3*I2^2*I1^2 - m3^2*I3^2*I2^2*I1^3 - 2*E*I3^3*I2^2*I1^3 + 2*E*I3^2*I2^2*I1^4) = 0 := by linear_combination (root^2*m3^2*I3^2*I2*I1^2 - root^2*m3^2*I3^2*I1^3 - m3^2*I3^2*I2*I1^2 + 2*E*I3^2*I2*I1^3) * h1
  have top : (root^4*m3^2*I3^3*I2^2*I1^2 - 2*root^4*m3^2*I3^3*I2*I1^3 + root^4*m3^2*I3^3*I1^4 - 2*root^2*m3^2*I3^3*I2^2*I1^2 + 2*root^2*m3^2*I3^3*I2*I1^3 + root^2*m3^2*I3^2*I2^2*I1^3 + 2*root^2*E*I3^3*I2^2*I1^3 - root^2*m3^2*I3^2*I2*I1^4 - 2*root^2*E*I3^3*I2*I1^4 + m3^2*I3^3*I2^2*I1^2 - m3^2*I3^2*I2^2*I1^3 - 2*E*I3^3*I2^2*I1^3 + 2*E*I3^2*I2^2*I1^4 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
