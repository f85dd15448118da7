-- deriglazov-comment / euler-from-momentum/energy-and-length-do-not-suffice: The conservation of E and of the length of m would not do in place of m: they are conserved whatever the sign or size of the bracket.
--
-- Given: the definitions, the assumptions and euler-poisson.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \Omega_1\cdot (I_2\cdot \Omega_2\cdot \Omega_3-I_3\cdot \Omega_3\cdot \Omega_2)+\Omega_2\cdot (I_3\cdot \Omega_3\cdot \Omega_1-I_1\cdot \Omega_1\cdot \Omega_3)+\Omega_3\cdot (I_1\cdot \Omega_1\cdot \Omega_2-I_2\cdot \Omega_2\cdot \Omega_1) = 0
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (Omega3 Omega2 Omega1 I3 I2 I1 : ℝ) (hD : (1 : ℝ) ≠ 0) : (Omega1*(I2*Omega2*Omega3 - I3*Omega3*Omega2) + Omega2*(I3*Omega3*Omega1 - I1*Omega1*Omega3) + Omega3*(I1*Omega1*Omega2 - I2*Omega2*Omega1) : ℝ) - (0) = (0) / (1) := by
  field_simp
  ring

-- I_1\cdot \Omega_1\cdot (I_2\cdot \Omega_2\cdot \Omega_3-I_3\cdot \Omega_3\cdot \Omega_2)+I_2\cdot \Omega_2\cdot (I_3\cdot \Omega_3\cdot \Omega_1-I_1\cdot \Omega_1\cdot \Omega_3)+I_3\cdot \Omega_3\cdot (I_1\cdot \Omega_1\cdot \Omega_2-I_2\cdot \Omega_2\cdot \Omega_1) = 0
theorem equation_2
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (Omega3 Omega2 Omega1 I3 I2 I1 : ℝ) (hD : (1 : ℝ) ≠ 0) : (I1*Omega1*(I2*Omega2*Omega3 - I3*Omega3*Omega2) + I2*Omega2*(I3*Omega3*Omega1 - I1*Omega1*Omega3) + I3*Omega3*(I1*Omega1*Omega2 - I2*Omega2*Omega1) : ℝ) - (0) = (0) / (1) := by
  field_simp
  ring
