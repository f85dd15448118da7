-- resonance / size: The size of the response.
--
-- Given: the definitions, the assumptions and oscillator.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{k-m\cdot \omega^2}{(k-m\cdot \omega^2)^{2}+(\gamma\cdot \omega)^{2}}\cdot \frac{k-m\cdot \omega^2}{(k-m\cdot \omega^2)^{2}+(\gamma\cdot \omega)^{2}}+\frac{-\gamma\cdot \omega}{(k-m\cdot \omega^2)^{2}+(\gamma\cdot \omega)^{2}}\cdot \frac{-\gamma\cdot \omega}{(k-m\cdot \omega^2)^{2}+(\gamma\cdot \omega)^{2}} = \frac{1}{(k-m\cdot \omega^2)^{2}+\gamma^2\cdot \omega^2}
-- gamma stands for \gamma
-- omega stands for \omega
-- m stands for m
-- k stands for k
theorem equation_1 (gamma omega m k : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (omega^12*m^6 + 3*gamma^2*omega^10*m^4 - 6*omega^10*m^5*k + 3*gamma^4*omega^8*m^2 - 12*gamma^2*omega^8*m^3*k + 15*omega^8*m^4*k^2 + gamma^6*omega^6 - 6*gamma^4*omega^6*m*k + 18*gamma^2*omega^6*m^2*k^2 - 20*omega^6*m^3*k^3 + 3*gamma^4*omega^4*k^2 - 12*gamma^2*omega^4*m*k^3 + 15*omega^4*m^2*k^4 + 3*gamma^2*omega^2*k^4 - 6*omega^2*m*k^5 + k^6) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (gamma omega m k : ℝ) (hD : (omega^12*m^6 + 3*gamma^2*omega^10*m^4 - 6*omega^10*m^5*k + 3*gamma^4*omega^8*m^2 - 12*gamma^2*omega^8*m^3*k + 15*omega^8*m^4*k^2 + gamma^6*omega^6 - 6*gamma^4*omega^6*m*k + 18*gamma^2*omega^6*m^2*k^2 - 20*omega^6*m^3*k^3 + 3*gamma^4*omega^4*k^2 - 12*gamma^2*omega^4*m*k^3 + 15*omega^4*m^2*k^4 + 3*gamma^2*omega^2*k^4 - 6*omega^2*m*k^5 + k^6 : ℝ) ≠ 0) : ((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)*((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)) + (-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2)*((-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2)) : ℝ) - (1/((k - m*omega^2)^2 + gamma^2*omega^2)) = (0) / (omega^12*m^6 + 3*gamma^2*omega^10*m^4 - 6*omega^10*m^5*k + 3*gamma^4*omega^8*m^2 - 12*gamma^2*omega^8*m^3*k + 15*omega^8*m^4*k^2 + gamma^6*omega^6 - 6*gamma^4*omega^6*m*k + 18*gamma^2*omega^6*m^2*k^2 - 20*omega^6*m^3*k^3 + 3*gamma^4*omega^4*k^2 - 12*gamma^2*omega^4*m*k^3 + 15*omega^4*m^2*k^4 + 3*gamma^2*omega^2*k^4 - 6*omega^2*m*k^5 + k^6) := by
  field_simp
  ring
