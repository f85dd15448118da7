-- deriglazov-comment / reduced-phi/given-the-relation: For motions that obey the relation between E and m.
--
-- Given: the definitions, the assumptions and t9-phi, psi0-formula.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{\varphi} = \frac{{\bf m}_3}{I_3}
-- sin_psi stands for \sin(\psi)
-- cos_psi stands for \cos(\psi)
-- sin_theta stands for \sin(\theta)
-- cos_theta stands for \cos(\theta)
-- sin_psi_then stands for \sin(\psi(0))
-- cos_psi_then stands for \cos(\psi(0))
-- m3 stands for {\bf m}_3
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (sin_psi cos_psi sin_theta cos_theta sin_psi_then cos_psi_then m3 I3 I2 I1 : ℝ)
    (h1 : sin_psi^2 + cos_psi^2 - 1 = 0)
    (h2 : sin_theta^2 + cos_theta^2 - 1 = 0)
    (h3 : sin_psi_then^2 + cos_psi_then^2 - 1 = 0)
    (h4 : cos_psi_then^2*I3*I2 - cos_psi_then^2*I3*I1 - I3*I2 + I2*I1 = 0)
    (h5 : sin_psi_then^2*I3*I2 - sin_psi_then^2*I3*I1 + I3*I1 - I2*I1 = 0)
    (h6 : -cos_psi^2*sin_theta^2*I3*I2*I1 + cos_psi^2*sin_theta^2*I3*I1^2 + sin_theta^2*I3*I2*I1 - sin_theta^2*I2*I1^2 = 0)
    (hd : (sin_theta^2*I3^2*I2^6*I1^2 - 4*sin_theta^2*I3^2*I2^5*I1^3 + 6*sin_theta^2*I3^2*I2^4*I1^4 - 4*sin_theta^2*I3^2*I2^3*I1^5 + sin_theta^2*I3^2*I2^2*I1^6 : ℝ) ≠ 0) : (sin_psi^2*m3*I3*I2 + cos_psi^2*m3*I3*I1 - m3*I2*I1 : ℝ) / (I3*I2*I1) = 0 := by
  have key : (sin_theta^2*I3^2*I2^6*I1^2 - 4*sin_theta^2*I3^2*I2^5*I1^3 + 6*sin_theta^2*I3^2*I2^4*I1^4 - 4*sin_theta^2*I3^2*I2^3*I1^5 + sin_theta^2*I3^2*I2^2*I1^6 : ℝ) * (sin_psi^2*m3*I3*I2 + cos_psi^2*m3*I3*I1 - m3*I2*I1) = 0 := by linear_combination (sin_theta^2*m3*I3^3*I2^7*I1^2 - 4*sin_theta^2*m3*I3^3*I2^6*I1^3 + 6*sin_theta^2*m3*I3^3*I2^5*I1^4 - 4*sin_theta^2*m3*I3^3*I2^4*I1^5 + sin_theta^2*m3*I3^3*I2^3*I1^6) * h1 + (cos_psi^2*sin_psi_then^2*m3*I3^4*I2^7*I1 - 6*cos_psi^2*sin_psi_then^2*m3*I3^4*I2^6*I1^2 + 15*cos_psi^2*sin_psi_then^2*m3*I3^4*I2^5*I1^3 - 20*cos_psi^2*sin_psi_then^2*m3*I3^4*I2^4*I1^4 + 15*cos_psi^2*sin_psi_then^2*m3*I3^4*I2^3*I1^5 - 6*cos_psi^2*sin_psi_then^2*m3*I3^4*I2^2*I1^6 + cos_psi^2*sin_psi_then^2*m3*I3^4*I2*I1^7 - sin_psi_then^2*m3*I3^4*I2^7*I1 + cos_psi^2*m3*I3^4*I2^6*I1^2 + 5*sin_psi_then^2*m3*I3^4*I2^6*I1^2 - cos_psi^2*m3*I3^3*I2^7*I1^2 + sin_psi_then^2*m3*I3^3*I2^7*I1^2 - 5*cos_psi^2*m3*I3^4*I2^5*I1^3 - 10*sin_psi_then^2*m3*I3^4*I2^5*I1^3 + 5*cos_psi^2*m3*I3^3*I2^6*I1^3 - 5*sin_psi_then^2*m3*I3^3*I2^6*I1^3 + 10*cos_psi^2*m3*I3^4*I2^4*I1^4 + 10*sin_psi_then^2*m3*I3^4*I2^4*I1^4 - 10*cos_psi^2*m3*I3^3*I2^5*I1^4 + 10*sin_psi_then^2*m3*I3^3*I2^5*I1^4 - 10*cos_psi^2*m3*I3^4*I2^3*I1^5 - 5*sin_psi_then^2*m3*I3^4*I2^3*I1^5 + 10*cos_psi^2*m3*I3^3*I2^4*I1^5 - 10*sin_psi_then^2*m3*I3^3*I2^4*I1^5 + 5*cos_psi^2*m3*I3^4*I2^2*I1^6 + sin_psi_then^2*m3*I3^4*I2^2*I1^6 - 5*cos_psi^2*m3*I3^3*I2^3*I1^6 + 5*sin_psi_then^2*m3*I3^3*I2^3*I1^6 - cos_psi^2*m3*I3^4*I2*I1^7 + cos_psi^2*m3*I3^3*I2^2*I1^7 - sin_psi_then^2*m3*I3^3*I2^2*I1^7 - m3*I3^4*I2^6*I1^2 + m3*I3^3*I2^7*I1^2 + 4*m3*I3^4*I2^5*I1^3 - 3*m3*I3^3*I2^6*I1^3 - m3*I3^2*I2^7*I1^3 - 6*m3*I3^4*I2^4*I1^4 + 2*m3*I3^3*I2^5*I1^4 + 4*m3*I3^2*I2^6*I1^4 + 4*m3*I3^4*I2^3*I1^5 + 2*m3*I3^3*I2^4*I1^5 - 6*m3*I3^2*I2^5*I1^5 - m3*I3^4*I2^2*I1^6 - 3*m3*I3^3*I2^3*I1^6 + 4*m3*I3^2*I2^4*I1^6 + m3*I3^3*I2^2*I1^7 - m3*I3^2*I2^3*I1^7) * h2 + (cos_psi^2*m3*I3^4*I2^7*I1 + cos_theta^2*m3*I3^4*I2^7*I1 - 6*cos_psi^2*m3*I3^4*I2^6*I1^2 - 5*cos_theta^2*m3*I3^4*I2^6*I1^2 - cos_theta^2*m3*I3^3*I2^7*I1^2 + 15*cos_psi^2*m3*I3^4*I2^5*I1^3 + 10*cos_theta^2*m3*I3^4*I2^5*I1^3 + 5*cos_theta^2*m3*I3^3*I2^6*I1^3 - 20*cos_psi^2*m3*I3^4*I2^4*I1^4 - 10*cos_theta^2*m3*I3^4*I2^4*I1^4 - 10*cos_theta^2*m3*I3^3*I2^5*I1^4 + 15*cos_psi^2*m3*I3^4*I2^3*I1^5 + 5*cos_theta^2*m3*I3^4*I2^3*I1^5 + 10*cos_theta^2*m3*I3^3*I2^4*I1^5 - 6*cos_psi^2*m3*I3^4*I2^2*I1^6 - cos_theta^2*m3*I3^4*I2^2*I1^6 - 5*cos_theta^2*m3*I3^3*I2^3*I1^6 + cos_psi^2*m3*I3^4*I2*I1^7 + cos_theta^2*m3*I3^3*I2^2*I1^7 - m3*I3^4*I2^7*I1 + 5*m3*I3^4*I2^6*I1^2 + m3*I3^3*I2^7*I1^2 - 10*m3*I3^4*I2^5*I1^3 - 5*m3*I3^3*I2^6*I1^3 + 10*m3*I3^4*I2^4*I1^4 + 10*m3*I3^3*I2^5*I1^4 - 5*m3*I3^4*I2^3*I1^5 - 10*m3*I3^3*I2^4*I1^5 + m3*I3^4*I2^2*I1^6 + 5*m3*I3^3*I2^3*I1^6 - m3*I3^3*I2^2*I1^7) * h3 + (-cos_psi^2*m3*I3^3*I2^6*I1 - cos_theta^2*m3*I3^3*I2^6*I1 + 5*cos_psi^2*m3*I3^3*I2^5*I1^2 + 4*cos_theta^2*m3*I3^3*I2^5*I1^2 + cos_theta^2*m3*I3^2*I2^6*I1^2 - 10*cos_psi^2*m3*I3^3*I2^4*I1^3 - 6*cos_theta^2*m3*I3^3*I2^4*I1^3 - 4*cos_theta^2*m3*I3^2*I2^5*I1^3 + 10*cos_psi^2*m3*I3^3*I2^3*I1^4 + 4*cos_theta^2*m3*I3^3*I2^3*I1^4 + 6*cos_theta^2*m3*I3^2*I2^4*I1^4 - 5*cos_psi^2*m3*I3^3*I2^2*I1^5 - cos_theta^2*m3*I3^3*I2^2*I1^5 - 4*cos_theta^2*m3*I3^2*I2^3*I1^5 + cos_psi^2*m3*I3^3*I2*I1^6 + cos_theta^2*m3*I3^2*I2^2*I1^6 + m3*I3^3*I2^6*I1 - 4*m3*I3^3*I2^5*I1^2 - m3*I3^2*I2^6*I1^2 + 6*m3*I3^3*I2^4*I1^3 + 4*m3*I3^2*I2^5*I1^3 - 4*m3*I3^3*I2^3*I1^4 - 6*m3*I3^2*I2^4*I1^4 + m3*I3^3*I2^2*I1^5 + 4*m3*I3^2*I2^3*I1^5 - m3*I3^2*I2^2*I1^6) * h4 + (-cos_psi^2*cos_theta^2*m3*I3^3*I2^6*I1 + 5*cos_psi^2*cos_theta^2*m3*I3^3*I2^5*I1^2 - 10*cos_psi^2*cos_theta^2*m3*I3^3*I2^4*I1^3 + 10*cos_psi^2*cos_theta^2*m3*I3^3*I2^3*I1^4 - 5*cos_psi^2*cos_theta^2*m3*I3^3*I2^2*I1^5 + cos_psi^2*cos_theta^2*m3*I3^3*I2*I1^6) * h5 + (sin_psi_then^2*m3*I3^3*I2^6 - 5*sin_psi_then^2*m3*I3^3*I2^5*I1 + 10*sin_psi_then^2*m3*I3^3*I2^4*I1^2 - 10*sin_psi_then^2*m3*I3^3*I2^3*I1^3 + 5*sin_psi_then^2*m3*I3^3*I2^2*I1^4 - sin_psi_then^2*m3*I3^3*I2*I1^5 + m3*I3^3*I2^5*I1 - 4*m3*I3^3*I2^4*I1^2 + 6*m3*I3^3*I2^3*I1^3 - 4*m3*I3^3*I2^2*I1^4 + m3*I3^3*I2*I1^5) * h6
  have top : (sin_psi^2*m3*I3*I2 + cos_psi^2*m3*I3*I1 - m3*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
