-- rabi / square: The square of the Hamiltonian is a multiple of the identity.
--
-- Given: the definitions, the assumptions and schroedinger.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{\hbar}{2}\cdot (-\Delta)\cdot (\frac{\hbar}{2}\cdot (-\Delta))+(\frac{\hbar}{2}\cdot \operatorname{Re}(\Omega)\cdot (\frac{\hbar}{2}\cdot \operatorname{Re}(\Omega))-\frac{\hbar}{2}\cdot \operatorname{Im}(\Omega)\cdot (\frac{\hbar}{2}\cdot (-\operatorname{Im}(\Omega)))) = \frac{\hbar^2\cdot (\sqrt{\operatorname{Re}(\Omega)\cdot \operatorname{Re}(\Omega)+\operatorname{Im}(\Omega)\cdot \operatorname{Im}(\Omega)+\Delta^2})^{2}}{4}
-- root stands for \sqrt{\operatorname{Re}(\Omega)\cdot \operatorname{Re}(\Omega)+\operatorname{Im}(\Omega)\cdot \operatorname{Im}(\Omega)+\Delta^2}
-- Omega2 stands for \operatorname{Im}(\Omega)
-- Omega1 stands for \operatorname{Re}(\Omega)
-- Delta stands for \Delta
-- hbar stands for \hbar
theorem equation_1 (root Omega2 Omega1 Delta hbar : ℝ)
    (h1 : root^2 - Omega2^2 - Omega1^2 - Delta^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-root^2*hbar^2 + Omega2^2*hbar^2 + Omega1^2*hbar^2 + Delta^2*hbar^2 : ℝ) / (4) = 0 := by
  have key : (1 : ℝ) * (-root^2*hbar^2 + Omega2^2*hbar^2 + Omega1^2*hbar^2 + Delta^2*hbar^2) = 0 := by linear_combination (-hbar^2) * h1
  have top : (-root^2*hbar^2 + Omega2^2*hbar^2 + Omega1^2*hbar^2 + Delta^2*hbar^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \frac{\hbar}{2}\cdot \operatorname{Re}(\Omega)\cdot (\frac{\hbar}{2}\cdot (-\operatorname{Im}(\Omega)))+\frac{\hbar}{2}\cdot \operatorname{Im}(\Omega)\cdot (\frac{\hbar}{2}\cdot \operatorname{Re}(\Omega)) = 0
theorem equation_2
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (root Omega2 Omega1 Delta hbar : ℝ) (hD : (4 : ℝ) ≠ 0) : (hbar/2*Omega1*(hbar/2*(-Omega2)) + hbar/2*Omega2*(hbar/2*Omega1) : ℝ) - (0) = (0) / (4) := by
  field_simp
  ring

-- \frac{\hbar}{2}\cdot (-\Delta)\cdot (\frac{\hbar}{2}\cdot \operatorname{Re}(\Omega))+\frac{\hbar}{2}\cdot \operatorname{Re}(\Omega)\cdot (\frac{\hbar}{2}\cdot \Delta) = 0
theorem equation_3
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (root Omega2 Omega1 Delta hbar : ℝ) (hD : (4 : ℝ) ≠ 0) : (hbar/2*(-Delta)*(hbar/2*Omega1) + hbar/2*Omega1*(hbar/2*Delta) : ℝ) - (0) = (0) / (4) := by
  field_simp
  ring

-- \frac{\hbar}{2}\cdot (-\Delta)\cdot (\frac{\hbar}{2}\cdot \operatorname{Im}(\Omega))+\frac{\hbar}{2}\cdot \operatorname{Im}(\Omega)\cdot (\frac{\hbar}{2}\cdot \Delta) = 0
theorem equation_4
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (root Omega2 Omega1 Delta hbar : ℝ) (hD : (4 : ℝ) ≠ 0) : (hbar/2*(-Delta)*(hbar/2*Omega2) + hbar/2*Omega2*(hbar/2*Delta) : ℝ) - (0) = (0) / (4) := by
  field_simp
  ring

-- \frac{\hbar}{2}\cdot (-\Delta)\cdot (\frac{\hbar}{2}\cdot \operatorname{Re}(\Omega))+\frac{\hbar}{2}\cdot \operatorname{Re}(\Omega)\cdot (\frac{\hbar}{2}\cdot \Delta) = 0
theorem equation_5
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (root Omega2 Omega1 Delta hbar : ℝ) (hD : (4 : ℝ) ≠ 0) : (hbar/2*(-Delta)*(hbar/2*Omega1) + hbar/2*Omega1*(hbar/2*Delta) : ℝ) - (0) = (0) / (4) := by
  field_simp
  ring

-- \frac{\hbar}{2}\cdot (-\operatorname{Im}(\Omega))\cdot (\frac{\hbar}{2}\cdot (-\Delta))+\frac{\hbar}{2}\cdot \Delta\cdot (\frac{\hbar}{2}\cdot (-\operatorname{Im}(\Omega))) = 0
theorem equation_6
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (root Omega2 Omega1 Delta hbar : ℝ) (hD : (4 : ℝ) ≠ 0) : (hbar/2*(-Omega2)*(hbar/2*(-Delta)) + hbar/2*Delta*(hbar/2*(-Omega2)) : ℝ) - (0) = (0) / (4) := by
  field_simp
  ring

-- \frac{\hbar}{2}\cdot \operatorname{Re}(\Omega)\cdot (\frac{\hbar}{2}\cdot \operatorname{Re}(\Omega))-\frac{\hbar}{2}\cdot \operatorname{Im}(\Omega)\cdot (\frac{\hbar}{2}\cdot (-\operatorname{Im}(\Omega)))+\frac{\hbar}{2}\cdot \Delta\cdot (\frac{\hbar}{2}\cdot \Delta) = \frac{\hbar^2\cdot (\sqrt{\operatorname{Re}(\Omega)\cdot \operatorname{Re}(\Omega)+\operatorname{Im}(\Omega)\cdot \operatorname{Im}(\Omega)+\Delta^2})^{2}}{4}
-- root stands for \sqrt{\operatorname{Re}(\Omega)\cdot \operatorname{Re}(\Omega)+\operatorname{Im}(\Omega)\cdot \operatorname{Im}(\Omega)+\Delta^2}
-- Omega2 stands for \operatorname{Im}(\Omega)
-- Omega1 stands for \operatorname{Re}(\Omega)
-- Delta stands for \Delta
-- hbar stands for \hbar
theorem equation_7 (root Omega2 Omega1 Delta hbar : ℝ)
    (h1 : root^2 - Omega2^2 - Omega1^2 - Delta^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-root^2*hbar^2 + Omega2^2*hbar^2 + Omega1^2*hbar^2 + Delta^2*hbar^2 : ℝ) / (4) = 0 := by
  have key : (1 : ℝ) * (-root^2*hbar^2 + Omega2^2*hbar^2 + Omega1^2*hbar^2 + Delta^2*hbar^2) = 0 := by linear_combination (-hbar^2) * h1
  have top : (-root^2*hbar^2 + Omega2^2*hbar^2 + Omega1^2*hbar^2 + Delta^2*hbar^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \frac{\hbar}{2}\cdot \operatorname{Re}(\Omega)\cdot (\frac{\hbar}{2}\cdot (-\operatorname{Im}(\Omega)))+\frac{\hbar}{2}\cdot \operatorname{Im}(\Omega)\cdot (\frac{\hbar}{2}\cdot \operatorname{Re}(\Omega)) = 0
theorem equation_8
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (root Omega2 Omega1 Delta hbar : ℝ) (hD : (4 : ℝ) ≠ 0) : (hbar/2*Omega1*(hbar/2*(-Omega2)) + hbar/2*Omega2*(hbar/2*Omega1) : ℝ) - (0) = (0) / (4) := by
  field_simp
  ring
