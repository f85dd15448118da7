-- resonance / square: The inverse of the squared response is a square, which vanishes at the frequency of resonance, and a rest that does not depend on the frequency.
--
-- Given: the definitions, the assumptions and oscillator.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{1}{\frac{k-m\cdot \omega^2}{(k-m\cdot \omega^2)^{2}+(\gamma\cdot \omega)^{2}}\cdot \frac{k-m\cdot \omega^2}{(k-m\cdot \omega^2)^{2}+(\gamma\cdot \omega)^{2}}+\frac{-\gamma\cdot \omega}{(k-m\cdot \omega^2)^{2}+(\gamma\cdot \omega)^{2}}\cdot \frac{-\gamma\cdot \omega}{(k-m\cdot \omega^2)^{2}+(\gamma\cdot \omega)^{2}}} = (m\cdot \omega^2-k+\frac{\gamma^2}{2\cdot m})^{2}+\gamma^2\cdot (\frac{k}{m}-\frac{\gamma^2}{4\cdot m^2})
-- gamma stands for \gamma
-- omega stands for \omega
-- m stands for m
-- k stands for k
theorem equation_1 (gamma omega m k : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (16*omega^4*m^7 + 16*gamma^2*omega^2*m^5 - 32*omega^2*m^6*k + 16*m^5*k^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (gamma omega m k : ℝ) (hD : (16*omega^4*m^7 + 16*gamma^2*omega^2*m^5 - 32*omega^2*m^6*k + 16*m^5*k^2 : ℝ) ≠ 0) : (1/((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)*((k - m*omega^2)/((k - m*omega^2)^2 + (gamma*omega)^2)) + (-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2)*((-(gamma*omega))/((k - m*omega^2)^2 + (gamma*omega)^2))) : ℝ) - ((m*omega^2 - k + gamma^2/(2*m))^2 + gamma^2*(k/m - gamma^2/(4*m^2))) = (0) / (16*omega^4*m^7 + 16*gamma^2*omega^2*m^5 - 32*omega^2*m^6*k + 16*m^5*k^2) := by
  field_simp
  ring
