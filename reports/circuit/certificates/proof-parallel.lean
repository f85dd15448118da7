-- circuit / parallel: Inductor and capacitor in parallel: their admittances add.
--
-- Given: the definitions, the assumptions and circuit.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{\frac{0}{(\omega\cdot L)^{2}}}{(\frac{0}{(\omega\cdot L)^{2}})^{2}+(\frac{-\omega\cdot L}{(\omega\cdot L)^{2}}+\omega\cdot C)^{2}} = \frac{0}{1-\omega^2\cdot L\cdot C}
-- C stands for C
-- L stands for L
-- omega stands for \omega
theorem equation_1 (C L omega : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (-C^3*L^7*omega^10 + 3*C^2*L^6*omega^8 - 3*C*L^5*omega^6 + L^4*omega^4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (C L omega : ℝ) (hD : (-C^3*L^7*omega^10 + 3*C^2*L^6*omega^8 - 3*C*L^5*omega^6 + L^4*omega^4 : ℝ) ≠ 0) : (0/(omega*L)^2/((0/(omega*L)^2)^2 + ((-(omega*L))/(omega*L)^2 + omega*C)^2) : ℝ) - (0/(1 - omega^2*L*C)) = (0) / (-C^3*L^7*omega^10 + 3*C^2*L^6*omega^8 - 3*C*L^5*omega^6 + L^4*omega^4) := by
  field_simp
  ring

-- \frac{-(\frac{-\omega\cdot L}{(\omega\cdot L)^{2}}+\omega\cdot C)}{(\frac{0}{(\omega\cdot L)^{2}})^{2}+(\frac{-\omega\cdot L}{(\omega\cdot L)^{2}}+\omega\cdot C)^{2}} = \frac{\omega\cdot L}{1-\omega^2\cdot L\cdot C}
-- C stands for C
-- L stands for L
-- omega stands for \omega
theorem equation_2 (C L omega : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (-C^3*L^7*omega^10 + 3*C^2*L^6*omega^8 - 3*C*L^5*omega^6 + L^4*omega^4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (C L omega : ℝ) (hD : (-C^3*L^7*omega^10 + 3*C^2*L^6*omega^8 - 3*C*L^5*omega^6 + L^4*omega^4 : ℝ) ≠ 0) : ((-((-(omega*L))/(omega*L)^2 + omega*C))/((0/(omega*L)^2)^2 + ((-(omega*L))/(omega*L)^2 + omega*C)^2) : ℝ) - (omega*L/(1 - omega^2*L*C)) = (0) / (-C^3*L^7*omega^10 + 3*C^2*L^6*omega^8 - 3*C*L^5*omega^6 + L^4*omega^4) := by
  field_simp
  ring
