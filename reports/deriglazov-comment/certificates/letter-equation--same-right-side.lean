-- deriglazov-comment / letter-equation/same-right-side: The right side of t11 and that of the form known to us agree, squared.
--
-- Given: the definitions, the assumptions and I_{(n-k)}.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{(\frac{I_1}{I_3}-1+(1-\frac{I_1}{I_2})\cdot (\cos(\psi))^{2})\cdot (\frac{2\cdot I_1\cdot E}{{\bf m}_3^2}-1+(1-\frac{I_1}{I_2})\cdot (\cos(\psi))^{2})}{(1-(1-\frac{I_1}{I_2})\cdot (\cos(\psi))^{2})^{2}} = \frac{(\frac{1}{I_1}-\frac{1}{I_3}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})\cdot (\frac{1}{I_3}-\frac{2\cdot E}{{\bf m}_3^2}+(\frac{1}{I_1}-\frac{1}{I_3})-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})}{(\frac{1}{I_1}-(\frac{1}{I_1}-\frac{1}{I_2})\cdot (\cos(\psi))^{2})^{2}}
-- cos_psi stands for \cos(\psi)
-- m3 stands for {\bf m}_3
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (cos_psi m3 I3 I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (cos_psi^8*m3^4*I3^4*I2^8*I1^6 - 4*cos_psi^8*m3^4*I3^4*I2^7*I1^7 + 6*cos_psi^8*m3^4*I3^4*I2^6*I1^8 - 4*cos_psi^8*m3^4*I3^4*I2^5*I1^9 + cos_psi^8*m3^4*I3^4*I2^4*I1^10 - 4*cos_psi^6*m3^4*I3^4*I2^8*I1^6 + 12*cos_psi^6*m3^4*I3^4*I2^7*I1^7 - 12*cos_psi^6*m3^4*I3^4*I2^6*I1^8 + 4*cos_psi^6*m3^4*I3^4*I2^5*I1^9 + 6*cos_psi^4*m3^4*I3^4*I2^8*I1^6 - 12*cos_psi^4*m3^4*I3^4*I2^7*I1^7 + 6*cos_psi^4*m3^4*I3^4*I2^6*I1^8 - 4*cos_psi^2*m3^4*I3^4*I2^8*I1^6 + 4*cos_psi^2*m3^4*I3^4*I2^7*I1^7 + m3^4*I3^4*I2^8*I1^6) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
