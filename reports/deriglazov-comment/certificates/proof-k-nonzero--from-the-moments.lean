-- deriglazov-comment / k-nonzero/from-the-moments: Its square follows from the moments.
--
-- Given: the definitions, the assumptions and momentum, psi0-formula.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (\frac{1}{2}\cdot {\bf m}_3(0)\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \psi(0)))^{2} = {\bf m}_3^2\cdot (\frac{1}{I_1}-\frac{1}{I_3})\cdot (\frac{1}{I_3}-\frac{1}{I_2})
-- sin_psi_then stands for \sin(\psi(0))
-- cos_psi_then stands for \cos(\psi(0))
-- E stands for E
-- m3_then stands for {\bf m}_3(0)
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (sin_psi_then cos_psi_then E m3_then I3 I2 I1 : ℝ)
    (h1 : sin_psi_then^2 + cos_psi_then^2 - 1 = 0)
    (h2 : -m3_then^2*I2*I1 + 2*E*I3*I2*I1 = 0)
    (h3 : cos_psi_then^2*I3*I2 - cos_psi_then^2*I3*I1 - I3*I2 + I2*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (4*sin_psi_then^2*cos_psi_then^2*m3_then^2*I3^2*I2^3*I1 - 8*sin_psi_then^2*cos_psi_then^2*m3_then^2*I3^2*I2^2*I1^2 + 4*sin_psi_then^2*cos_psi_then^2*m3_then^2*I3^2*I2*I1^3 + 4*m3_then^2*I3^2*I2^2*I1^2 - 4*m3_then^2*I3*I2^3*I1^2 - 4*m3_then^2*I3*I2^2*I1^3 + 4*m3_then^2*I2^3*I1^3 : ℝ) / (4*I3^2*I2^3*I1^3) = 0 := by
  have key : (1 : ℝ) * (4*sin_psi_then^2*cos_psi_then^2*m3_then^2*I3^2*I2^3*I1 - 8*sin_psi_then^2*cos_psi_then^2*m3_then^2*I3^2*I2^2*I1^2 + 4*sin_psi_then^2*cos_psi_then^2*m3_then^2*I3^2*I2*I1^3 + 4*m3_then^2*I3^2*I2^2*I1^2 - 4*m3_then^2*I3*I2^3*I1^2 - 4*m3_then^2*I3*I2^2*I1^3 + 4*m3_then^2*I2^3*I1^3) = 0 := by linear_combination (8*cos_psi_then^2*E*I3^3*I2^3*I1 - 16*cos_psi_then^2*E*I3^3*I2^2*I1^2 + 8*cos_psi_then^2*E*I3^3*I2*I1^3) * h1 + (-4*sin_psi_then^2*cos_psi_then^2*I3^2*I2^2 + 8*sin_psi_then^2*cos_psi_then^2*I3^2*I2*I1 - 4*sin_psi_then^2*cos_psi_then^2*I3^2*I1^2 - 4*I3^2*I2*I1 + 4*I3*I2^2*I1 + 4*I3*I2*I1^2 - 4*I2^2*I1^2) * h2 + (-8*cos_psi_then^2*E*I3^2*I2^2*I1 + 8*cos_psi_then^2*E*I3^2*I2*I1^2 - 8*E*I3^2*I2*I1^2 + 8*E*I3*I2^2*I1^2) * h3
  have top : (4*sin_psi_then^2*cos_psi_then^2*m3_then^2*I3^2*I2^3*I1 - 8*sin_psi_then^2*cos_psi_then^2*m3_then^2*I3^2*I2^2*I1^2 + 4*sin_psi_then^2*cos_psi_then^2*m3_then^2*I3^2*I2*I1^3 + 4*m3_then^2*I3^2*I2^2*I1^2 - 4*m3_then^2*I3*I2^3*I1^2 - 4*m3_then^2*I3*I2^2*I1^3 + 4*m3_then^2*I2^3*I1^3 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
