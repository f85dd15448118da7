-- deriglazov-comment / t15-integral: What the rate of θ integrates to: tan²(θ/2) grows by a constant exponential.
--
-- Given: the definitions, the assumptions and reduced-theta, momentum.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 90 operations) = 0
-- exp_2 stands for \exp((I_2)^{-1}\cdot t\cdot {\bf m}_3(0)\cdot \sin(2\cdot \psi(0)))
-- exp_3 stands for \exp((I_1)^{-1}\cdot t\cdot {\bf m}_3(0)\cdot \sin(2\cdot \psi(0)))
-- sin_2 stands for \sin(2\cdot \psi(0))
-- sin_3 stands for \sin(\frac{1}{2}\cdot \theta)
-- cos_3 stands for \cos(\frac{1}{2}\cdot \theta)
-- m3_then stands for {\bf m}_3(0)
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (exp_2 exp_3 sin_2 sin_3 cos_3 m3_then I2 I1 : ℝ)
    (h1 : sin_3^2 + cos_3^2 - 1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (8*exp_2*exp_3*sin_2*sin_3^4*cos_3^3*m3_then*I2^2*I1 + 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^5*m3_then*I2^2*I1 - 8*exp_2*exp_3*sin_2*sin_3^4*cos_3^3*m3_then*I2*I1^2 - 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^5*m3_then*I2*I1^2 - 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^3*m3_then*I2^2*I1 + 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^3*m3_then*I2*I1^2 : ℝ) / (8*exp_3^2*cos_3^5*I2^2*I1^2) = 0 := by
  have key : (1 : ℝ) * (8*exp_2*exp_3*sin_2*sin_3^4*cos_3^3*m3_then*I2^2*I1 + 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^5*m3_then*I2^2*I1 - 8*exp_2*exp_3*sin_2*sin_3^4*cos_3^3*m3_then*I2*I1^2 - 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^5*m3_then*I2*I1^2 - 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^3*m3_then*I2^2*I1 + 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^3*m3_then*I2*I1^2) = 0 := by linear_combination (8*exp_2*exp_3*sin_2*sin_3^2*cos_3^3*m3_then*I2^2*I1 - 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^3*m3_then*I2*I1^2) * h1
  have top : (8*exp_2*exp_3*sin_2*sin_3^4*cos_3^3*m3_then*I2^2*I1 + 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^5*m3_then*I2^2*I1 - 8*exp_2*exp_3*sin_2*sin_3^4*cos_3^3*m3_then*I2*I1^2 - 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^5*m3_then*I2*I1^2 - 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^3*m3_then*I2^2*I1 + 8*exp_2*exp_3*sin_2*sin_3^2*cos_3^3*m3_then*I2*I1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
