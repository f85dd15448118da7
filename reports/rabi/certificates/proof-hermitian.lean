-- rabi / hermitian: The Hamiltonian is Hermitian.
--
-- Given: the definitions, the assumptions and schroedinger.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- -\frac{\hbar}{2}\cdot (-\operatorname{Im}(\Omega)) = \frac{\hbar}{2}\cdot \operatorname{Im}(\Omega)
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (Omega2 hbar : ℝ) (hD : (2 : ℝ) ≠ 0) : (-(hbar/2*(-Omega2)) : ℝ) - (hbar/2*Omega2) = (0) / (2) := by
  field_simp
  ring

-- -\frac{\hbar}{2}\cdot \operatorname{Im}(\Omega) = \frac{\hbar}{2}\cdot (-\operatorname{Im}(\Omega))
theorem equation_2
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (Omega2 hbar : ℝ) (hD : (2 : ℝ) ≠ 0) : (-(hbar/2*Omega2) : ℝ) - (hbar/2*(-Omega2)) = (0) / (2) := by
  field_simp
  ring
