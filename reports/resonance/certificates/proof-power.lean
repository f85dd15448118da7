-- resonance / power: The mean power of the force is what friction takes.
--
-- Given: the definitions, the assumptions and oscillator.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 97 operations) = (an expression of 174 operations)
-- gamma stands for \gamma
-- omega stands for \omega
-- m stands for m
-- k stands for k
theorem equation_1 (gamma omega m k : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4*omega^12*m^6 + 12*gamma^2*omega^10*m^4 - 24*omega^10*m^5*k + 12*gamma^4*omega^8*m^2 - 48*gamma^2*omega^8*m^3*k + 60*omega^8*m^4*k^2 + 4*gamma^6*omega^6 - 24*gamma^4*omega^6*m*k + 72*gamma^2*omega^6*m^2*k^2 - 80*omega^6*m^3*k^3 + 12*gamma^4*omega^4*k^2 - 48*gamma^2*omega^4*m*k^3 + 60*omega^4*m^2*k^4 + 12*gamma^2*omega^2*k^4 - 24*omega^2*m*k^5 + 4*k^6) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (F2 F1 gamma omega m k : ℝ) (hD : (4*omega^12*m^6 + 12*gamma^2*omega^10*m^4 - 24*omega^10*m^5*k + 12*gamma^4*omega^8*m^2 - 48*gamma^2*omega^8*m^3*k + 60*omega^8*m^4*k^2 + 4*gamma^6*omega^6 - 24*gamma^4*omega^6*m*k + 72*gamma^2*omega^6*m^2*k^2 - 80*omega^6*m^3*k^3 + 12*gamma^4*omega^4*k^2 - 48*gamma^2*omega^4*m*k^3 + 60*omega^4*m^2*k^4 + 12*gamma^2*omega^2*k^4 - 24*omega^2*m*k^5 + 4*k^6 : ℝ) ≠ 0) : (1/2*((F2*omega*((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)) - F1*omega*((-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2)))*F1 - (F2*omega*((-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2)) + F1*omega*((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)))*F2) : ℝ) - (1/2*gamma*omega^2*(((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)*F1 - (-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2)*F2)*((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)*F1 - (-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2)*F2) + ((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)*F2 + (-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2)*F1)*((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)*F2 + (-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2)*F1))) = (0) / (4*omega^12*m^6 + 12*gamma^2*omega^10*m^4 - 24*omega^10*m^5*k + 12*gamma^4*omega^8*m^2 - 48*gamma^2*omega^8*m^3*k + 60*omega^8*m^4*k^2 + 4*gamma^6*omega^6 - 24*gamma^4*omega^6*m*k + 72*gamma^2*omega^6*m^2*k^2 - 80*omega^6*m^3*k^3 + 12*gamma^4*omega^4*k^2 - 48*gamma^2*omega^4*m*k^3 + 60*omega^4*m^2*k^4 + 12*gamma^2*omega^2*k^4 - 24*omega^2*m*k^5 + 4*k^6) := by
  field_simp
  ring
