-- circuit / mean-power: The mean power of the source is what the resistor takes.
--
-- Given: the definitions, the assumptions and circuit.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 112 operations) = (an expression of 215 operations)
-- C stands for C
-- L stands for L
-- omega stands for \omega
-- R stands for R
theorem equation_1 (C L omega R : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4*C^18*L^6*omega^24 + 12*C^18*L^4*omega^22*R^2 - 24*C^17*L^5*omega^22 + 12*C^18*L^2*omega^20*R^4 - 48*C^17*L^3*omega^20*R^2 + 4*C^18*omega^18*R^6 + 60*C^16*L^4*omega^20 - 24*C^17*L*omega^18*R^4 + 72*C^16*L^2*omega^18*R^2 - 80*C^15*L^3*omega^18 + 12*C^16*omega^16*R^4 - 48*C^15*L*omega^16*R^2 + 60*C^14*L^2*omega^16 + 12*C^14*omega^14*R^2 - 24*C^13*L*omega^14 + 4*C^12*omega^12) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (V2 V1 C L omega R : ℝ) (hD : (4*C^18*L^6*omega^24 + 12*C^18*L^4*omega^22*R^2 - 24*C^17*L^5*omega^22 + 12*C^18*L^2*omega^20*R^4 - 48*C^17*L^3*omega^20*R^2 + 4*C^18*omega^18*R^6 + 60*C^16*L^4*omega^20 - 24*C^17*L*omega^18*R^4 + 72*C^16*L^2*omega^18*R^2 - 80*C^15*L^3*omega^18 + 12*C^16*omega^16*R^4 - 48*C^15*L*omega^16*R^2 + 60*C^14*L^2*omega^16 + 12*C^14*omega^14*R^2 - 24*C^13*L*omega^14 + 4*C^12*omega^12 : ℝ) ≠ 0) : (1/2*(V1*((V1*(R + 0/(omega*C)^2) - V2*(-(omega*L + (-(omega*C))/(omega*C)^2)))/((R + 0/(omega*C)^2)^2 + (omega*L + (-(omega*C))/(omega*C)^2)^2)) - V2*(-((V1*(-(omega*L + (-(omega*C))/(omega*C)^2)) + V2*(R + 0/(omega*C)^2))/((R + 0/(omega*C)^2)^2 + (omega*L + (-(omega*C))/(omega*C)^2)^2)))) : ℝ) - (1/2*R*((V1*(R + 0/(omega*C)^2) - V2*(-(omega*L + (-(omega*C))/(omega*C)^2)))/((R + 0/(omega*C)^2)^2 + (omega*L + (-(omega*C))/(omega*C)^2)^2)*((V1*(R + 0/(omega*C)^2) - V2*(-(omega*L + (-(omega*C))/(omega*C)^2)))/((R + 0/(omega*C)^2)^2 + (omega*L + (-(omega*C))/(omega*C)^2)^2)) + (V1*(-(omega*L + (-(omega*C))/(omega*C)^2)) + V2*(R + 0/(omega*C)^2))/((R + 0/(omega*C)^2)^2 + (omega*L + (-(omega*C))/(omega*C)^2)^2)*((V1*(-(omega*L + (-(omega*C))/(omega*C)^2)) + V2*(R + 0/(omega*C)^2))/((R + 0/(omega*C)^2)^2 + (omega*L + (-(omega*C))/(omega*C)^2)^2)))) = (0) / (4*C^18*L^6*omega^24 + 12*C^18*L^4*omega^22*R^2 - 24*C^17*L^5*omega^22 + 12*C^18*L^2*omega^20*R^4 - 48*C^17*L^3*omega^20*R^2 + 4*C^18*omega^18*R^6 + 60*C^16*L^4*omega^20 - 24*C^17*L*omega^18*R^4 + 72*C^16*L^2*omega^18*R^2 - 80*C^15*L^3*omega^18 + 12*C^16*omega^16*R^4 - 48*C^15*L*omega^16*R^2 + 60*C^14*L^2*omega^16 + 12*C^14*omega^14*R^2 - 24*C^13*L*omega^14 + 4*C^12*omega^12) := by
  field_simp
  ring
