-- circuit / parts: Resistance and reactance.
--
-- Given: the definitions, the assumptions and circuit.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- R+\frac{0}{(\omega\cdot C)^{2}} = R
-- C stands for C
-- omega stands for \omega
theorem equation_1 (C omega : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (C^2*omega^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (C L omega R : ℝ) (hD : (C^2*omega^2 : ℝ) ≠ 0) : (R + 0/(omega*C)^2 : ℝ) - (R) = (0) / (C^2*omega^2) := by
  field_simp
  ring

-- \omega\cdot L+\frac{-\omega\cdot C}{(\omega\cdot C)^{2}} = \omega\cdot L-\frac{1}{\omega\cdot C}
-- C stands for C
-- omega stands for \omega
theorem equation_2 (C omega : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (C^3*omega^3) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (C L omega R : ℝ) (hD : (C^3*omega^3 : ℝ) ≠ 0) : (omega*L + (-(omega*C))/(omega*C)^2 : ℝ) - (omega*L - 1/(omega*C)) = (0) / (C^3*omega^3) := by
  field_simp
  ring
