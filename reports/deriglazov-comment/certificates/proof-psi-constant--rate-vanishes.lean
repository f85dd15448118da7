-- deriglazov-comment / psi-constant/rate-vanishes: Where the product vanishes and θ ≠ 0, with I₁ ≠ I₂, the rate of ψ vanishes.
--
-- Given: the definitions, the assumptions and t9-psi.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{\psi} = 0
-- sin_psi stands for \sin(\psi)
-- cos_psi stands for \cos(\psi)
-- sin_theta stands for \sin(\theta)
-- cos_theta stands for \cos(\theta)
-- m3 stands for {\bf m}_3
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (sin_psi cos_psi sin_theta cos_theta m3 I3 I2 I1 : ℝ)
    (h1 : sin_psi^2 + cos_psi^2 - 1 = 0)
    (h2 : -cos_psi^2*sin_theta^2*I3*I2*I1 + cos_psi^2*sin_theta^2*I3*I1^2 + sin_theta^2*I3*I2*I1 - sin_theta^2*I2*I1^2 = 0)
    (hd : (sin_theta^2*I3^2*I2^4*I1^2 - 2*sin_theta^2*I3^2*I2^3*I1^3 + sin_theta^2*I3^2*I2^2*I1^4 : ℝ) ≠ 0) : (-sin_psi^2*cos_theta*m3*I3*I2 - cos_psi^2*cos_theta*m3*I3*I1 + cos_theta*m3*I2*I1 : ℝ) / (I3*I2*I1) = 0 := by
  have key : (sin_theta^2*I3^2*I2^4*I1^2 - 2*sin_theta^2*I3^2*I2^3*I1^3 + sin_theta^2*I3^2*I2^2*I1^4 : ℝ) * (-sin_psi^2*cos_theta*m3*I3*I2 - cos_psi^2*cos_theta*m3*I3*I1 + cos_theta*m3*I2*I1) = 0 := by linear_combination (-sin_theta^2*cos_theta*m3*I3^3*I2^5*I1^2 + 2*sin_theta^2*cos_theta*m3*I3^3*I2^4*I1^3 - sin_theta^2*cos_theta*m3*I3^3*I2^3*I1^4) * h1 + (-cos_theta*m3*I3^2*I2^4*I1 + 2*cos_theta*m3*I3^2*I2^3*I1^2 - cos_theta*m3*I3^2*I2^2*I1^3) * h2
  have top : (-sin_psi^2*cos_theta*m3*I3*I2 - cos_psi^2*cos_theta*m3*I3*I1 + cos_theta*m3*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
