-- deriglazov-comment / psi0-formula/where-psi-is-constant: Where the product in t10 vanishes with θ ≠ 0 and I₁ ≠ I₂.
--
-- Given: the definitions, the assumptions and relation-in-t10.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (\cos(\psi))^{2} = \frac{I_2\cdot (I_3-I_1)}{I_3\cdot (I_2-I_1)}
-- cos_psi stands for \cos(\psi)
-- sin_theta stands for \sin(\theta)
-- E stands for E
-- m3 stands for {\bf m}_3
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (cos_psi sin_theta E m3 I3 I2 I1 : ℝ)
    (h1 : -cos_psi^2*sin_theta^2*I3*I2*I1 + cos_psi^2*sin_theta^2*I3*I1^2 + sin_theta^2*I3*I2*I1 - sin_theta^2*I2*I1^2 = 0)
    (h2 : -m3^2*I2*I1 + 2*E*I3*I2*I1 = 0)
    (hd : (sin_theta^2*m3^2*I3^2*I2^6*I1^2 - 4*sin_theta^2*m3^2*I3^2*I2^5*I1^3 + 6*sin_theta^2*m3^2*I3^2*I2^4*I1^4 - 4*sin_theta^2*m3^2*I3^2*I2^3*I1^5 + sin_theta^2*m3^2*I3^2*I2^2*I1^6 : ℝ) ≠ 0) : (cos_psi^2*I3*I2 - cos_psi^2*I3*I1 - I3*I2 + I2*I1 : ℝ) / (I3*I2 - I3*I1) = 0 := by
  have key : (sin_theta^2*m3^2*I3^2*I2^6*I1^2 - 4*sin_theta^2*m3^2*I3^2*I2^5*I1^3 + 6*sin_theta^2*m3^2*I3^2*I2^4*I1^4 - 4*sin_theta^2*m3^2*I3^2*I2^3*I1^5 + sin_theta^2*m3^2*I3^2*I2^2*I1^6 : ℝ) * (cos_psi^2*I3*I2 - cos_psi^2*I3*I1 - I3*I2 + I2*I1) = 0 := by linear_combination (-2*E*I3^3*I2^6*I1 + 8*E*I3^3*I2^5*I1^2 - 12*E*I3^3*I2^4*I1^3 + 8*E*I3^3*I2^3*I1^4 - 2*E*I3^3*I2^2*I1^5) * h1 + (-cos_psi^2*sin_theta^2*I3^3*I2^6*I1 + 5*cos_psi^2*sin_theta^2*I3^3*I2^5*I1^2 - 10*cos_psi^2*sin_theta^2*I3^3*I2^4*I1^3 + 10*cos_psi^2*sin_theta^2*I3^3*I2^3*I1^4 - 5*cos_psi^2*sin_theta^2*I3^3*I2^2*I1^5 + cos_psi^2*sin_theta^2*I3^3*I2*I1^6 + sin_theta^2*I3^3*I2^6*I1 - 4*sin_theta^2*I3^3*I2^5*I1^2 - sin_theta^2*I3^2*I2^6*I1^2 + 6*sin_theta^2*I3^3*I2^4*I1^3 + 4*sin_theta^2*I3^2*I2^5*I1^3 - 4*sin_theta^2*I3^3*I2^3*I1^4 - 6*sin_theta^2*I3^2*I2^4*I1^4 + sin_theta^2*I3^3*I2^2*I1^5 + 4*sin_theta^2*I3^2*I2^3*I1^5 - sin_theta^2*I3^2*I2^2*I1^6) * h2
  have top : (cos_psi^2*I3*I2 - cos_psi^2*I3*I1 - I3*I2 + I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (\sin(\psi))^{2} = \frac{I_1\cdot (I_2-I_3)}{I_3\cdot (I_2-I_1)}
-- sin_psi stands for \sin(\psi)
-- cos_psi stands for \cos(\psi)
-- sin_theta stands for \sin(\theta)
-- E stands for E
-- m3 stands for {\bf m}_3
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_2 (sin_psi cos_psi sin_theta E m3 I3 I2 I1 : ℝ)
    (h1 : sin_psi^2 + cos_psi^2 - 1 = 0)
    (h2 : -cos_psi^2*sin_theta^2*I3*I2*I1 + cos_psi^2*sin_theta^2*I3*I1^2 + sin_theta^2*I3*I2*I1 - sin_theta^2*I2*I1^2 = 0)
    (h3 : -m3^2*I2*I1 + 2*E*I3*I2*I1 = 0)
    (hd : (sin_theta^2*m3^2*I3^2*I2^6*I1^2 - 4*sin_theta^2*m3^2*I3^2*I2^5*I1^3 + 6*sin_theta^2*m3^2*I3^2*I2^4*I1^4 - 4*sin_theta^2*m3^2*I3^2*I2^3*I1^5 + sin_theta^2*m3^2*I3^2*I2^2*I1^6 : ℝ) ≠ 0) : (sin_psi^2*I3*I2 - sin_psi^2*I3*I1 + I3*I1 - I2*I1 : ℝ) / (I3*I2 - I3*I1) = 0 := by
  have key : (sin_theta^2*m3^2*I3^2*I2^6*I1^2 - 4*sin_theta^2*m3^2*I3^2*I2^5*I1^3 + 6*sin_theta^2*m3^2*I3^2*I2^4*I1^4 - 4*sin_theta^2*m3^2*I3^2*I2^3*I1^5 + sin_theta^2*m3^2*I3^2*I2^2*I1^6 : ℝ) * (sin_psi^2*I3*I2 - sin_psi^2*I3*I1 + I3*I1 - I2*I1) = 0 := by linear_combination (2*sin_theta^2*E*I3^4*I2^7*I1^2 - 10*sin_theta^2*E*I3^4*I2^6*I1^3 + 20*sin_theta^2*E*I3^4*I2^5*I1^4 - 20*sin_theta^2*E*I3^4*I2^4*I1^5 + 10*sin_theta^2*E*I3^4*I2^3*I1^6 - 2*sin_theta^2*E*I3^4*I2^2*I1^7) * h1 + (2*E*I3^3*I2^6*I1 - 8*E*I3^3*I2^5*I1^2 + 12*E*I3^3*I2^4*I1^3 - 8*E*I3^3*I2^3*I1^4 + 2*E*I3^3*I2^2*I1^5) * h2 + (-sin_psi^2*sin_theta^2*I3^3*I2^6*I1 + 5*sin_psi^2*sin_theta^2*I3^3*I2^5*I1^2 - 10*sin_psi^2*sin_theta^2*I3^3*I2^4*I1^3 + 10*sin_psi^2*sin_theta^2*I3^3*I2^3*I1^4 - 5*sin_psi^2*sin_theta^2*I3^3*I2^2*I1^5 + sin_psi^2*sin_theta^2*I3^3*I2*I1^6 - sin_theta^2*I3^3*I2^5*I1^2 + sin_theta^2*I3^2*I2^6*I1^2 + 4*sin_theta^2*I3^3*I2^4*I1^3 - 4*sin_theta^2*I3^2*I2^5*I1^3 - 6*sin_theta^2*I3^3*I2^3*I1^4 + 6*sin_theta^2*I3^2*I2^4*I1^4 + 4*sin_theta^2*I3^3*I2^2*I1^5 - 4*sin_theta^2*I3^2*I2^3*I1^5 - sin_theta^2*I3^3*I2*I1^6 + sin_theta^2*I3^2*I2^2*I1^6) * h3
  have top : (sin_psi^2*I3*I2 - sin_psi^2*I3*I1 + I3*I1 - I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
