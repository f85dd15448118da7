-- rabi / energy: The mean energy does not change; it is a real number.
--
-- Given: the definitions, the assumptions and schroedinger.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 109 operations) = 0
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (c22_dot c21_dot c12_dot c11_dot c22 c21 c12 c11 Omega2 Omega1 Delta hbar : ℝ) (hD : (2 : ℝ) ≠ 0) : (c11*(hbar/2*(-Delta)*c12 + (hbar/2*Omega1*c22 + hbar/2*Omega2*c21)) + (-c12)*(hbar/2*(-Delta)*c11 + (hbar/2*Omega1*c21 - hbar/2*Omega2*c22)) + (c21*(hbar/2*Omega1*c12 + hbar/2*(-Omega2)*c11 + hbar/2*Delta*c22) + (-c22)*(hbar/2*Omega1*c11 - hbar/2*(-Omega2)*c12 + hbar/2*Delta*c21)) : ℝ) - (0) = (0) / (2) := by
  field_simp
  ring

-- (an expression of 219 operations) = 0
-- c22_dot stands for \operatorname{Im}(\dot{c}_2)
-- c21_dot stands for \operatorname{Re}(\dot{c}_2)
-- c12_dot stands for \operatorname{Im}(\dot{c}_1)
-- c11_dot stands for \operatorname{Re}(\dot{c}_1)
-- c22 stands for \operatorname{Im}(c_2)
-- c21 stands for \operatorname{Re}(c_2)
-- c12 stands for \operatorname{Im}(c_1)
-- c11 stands for \operatorname{Re}(c_1)
-- Omega2 stands for \operatorname{Im}(\Omega)
-- Omega1 stands for \operatorname{Re}(\Omega)
-- Delta stands for \Delta
-- hbar stands for \hbar
theorem equation_2 (c22_dot c21_dot c12_dot c11_dot c22 c21 c12 c11 Omega2 Omega1 Delta hbar : ℝ)
    (h1 : c22*Omega2*hbar - c21*Omega1*hbar + c11*Delta*hbar - 2*c12_dot*hbar = 0)
    (h2 : -c21*Omega2*hbar - c22*Omega1*hbar + c12*Delta*hbar + 2*c11_dot*hbar = 0)
    (h3 : -c12*Omega2*hbar - c11*Omega1*hbar - c21*Delta*hbar - 2*c22_dot*hbar = 0)
    (h4 : c11*Omega2*hbar - c12*Omega1*hbar - c22*Delta*hbar + 2*c21_dot*hbar = 0)
    (hd : (1 : ℝ) ≠ 0) : (-2*c11_dot*c22*Omega2*hbar + 2*c12_dot*c21*Omega2*hbar + 2*c21_dot*c12*Omega2*hbar - 2*c22_dot*c11*Omega2*hbar + 2*c12_dot*c22*Omega1*hbar + 2*c11_dot*c21*Omega1*hbar + 2*c22_dot*c12*Omega1*hbar + 2*c21_dot*c11*Omega1*hbar + 2*c22_dot*c22*Delta*hbar + 2*c21_dot*c21*Delta*hbar - 2*c12_dot*c12*Delta*hbar - 2*c11_dot*c11*Delta*hbar : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (-2*c11_dot*c22*Omega2*hbar + 2*c12_dot*c21*Omega2*hbar + 2*c21_dot*c12*Omega2*hbar - 2*c22_dot*c11*Omega2*hbar + 2*c12_dot*c22*Omega1*hbar + 2*c11_dot*c21*Omega1*hbar + 2*c22_dot*c12*Omega1*hbar + 2*c21_dot*c11*Omega1*hbar + 2*c22_dot*c22*Delta*hbar + 2*c21_dot*c21*Delta*hbar - 2*c12_dot*c12*Delta*hbar - 2*c11_dot*c11*Delta*hbar) = 0 := by linear_combination (-2*c11_dot) * h1 + (-2*c12_dot) * h2 + (-2*c21_dot) * h3 + (-2*c22_dot) * h4
  have top : (-2*c11_dot*c22*Omega2*hbar + 2*c12_dot*c21*Omega2*hbar + 2*c21_dot*c12*Omega2*hbar - 2*c22_dot*c11*Omega2*hbar + 2*c12_dot*c22*Omega1*hbar + 2*c11_dot*c21*Omega1*hbar + 2*c22_dot*c12*Omega1*hbar + 2*c21_dot*c11*Omega1*hbar + 2*c22_dot*c22*Delta*hbar + 2*c21_dot*c21*Delta*hbar - 2*c12_dot*c12*Delta*hbar - 2*c11_dot*c11*Delta*hbar : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (c22_dot c21_dot c12_dot c11_dot c22 c21 c12 c11 Omega2 Omega1 Delta hbar : ℝ) (hD : (2 : ℝ) ≠ 0) : (c11_dot*(hbar/2*(-Delta)*c11 + (hbar/2*Omega1*c21 - hbar/2*Omega2*c22)) + c11*(hbar/2*(-Delta)*c11_dot + (hbar/2*Omega1*c21_dot - hbar/2*Omega2*c22_dot)) - ((-c12_dot)*(hbar/2*(-Delta)*c12 + (hbar/2*Omega1*c22 + hbar/2*Omega2*c21)) + (-c12)*(hbar/2*(-Delta)*c12_dot + (hbar/2*Omega1*c22_dot + hbar/2*Omega2*c21_dot))) + (c21_dot*(hbar/2*Omega1*c11 - hbar/2*(-Omega2)*c12 + hbar/2*Delta*c21) + c21*(hbar/2*Omega1*c11_dot - hbar/2*(-Omega2)*c12_dot + hbar/2*Delta*c21_dot) - ((-c22_dot)*(hbar/2*Omega1*c12 + hbar/2*(-Omega2)*c11 + hbar/2*Delta*c22) + (-c22)*(hbar/2*Omega1*c12_dot + hbar/2*(-Omega2)*c11_dot + hbar/2*Delta*c22_dot))) : ℝ) - (0) = (-2*c11_dot*c22*Omega2*hbar + 2*c12_dot*c21*Omega2*hbar + 2*c21_dot*c12*Omega2*hbar - 2*c22_dot*c11*Omega2*hbar + 2*c12_dot*c22*Omega1*hbar + 2*c11_dot*c21*Omega1*hbar + 2*c22_dot*c12*Omega1*hbar + 2*c21_dot*c11*Omega1*hbar + 2*c22_dot*c22*Delta*hbar + 2*c21_dot*c21*Delta*hbar - 2*c12_dot*c12*Delta*hbar - 2*c11_dot*c11*Delta*hbar) / (2) := by
  field_simp
  ring

-- (an expression of 219 operations) = 0
theorem equation_3
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (c22_dot c21_dot c12_dot c11_dot c22 c21 c12 c11 Omega2 Omega1 Delta hbar : ℝ) (hD : (2 : ℝ) ≠ 0) : (c11_dot*(hbar/2*(-Delta)*c12 + (hbar/2*Omega1*c22 + hbar/2*Omega2*c21)) + c11*(hbar/2*(-Delta)*c12_dot + (hbar/2*Omega1*c22_dot + hbar/2*Omega2*c21_dot)) + ((-c12_dot)*(hbar/2*(-Delta)*c11 + (hbar/2*Omega1*c21 - hbar/2*Omega2*c22)) + (-c12)*(hbar/2*(-Delta)*c11_dot + (hbar/2*Omega1*c21_dot - hbar/2*Omega2*c22_dot))) + (c21_dot*(hbar/2*Omega1*c12 + hbar/2*(-Omega2)*c11 + hbar/2*Delta*c22) + c21*(hbar/2*Omega1*c12_dot + hbar/2*(-Omega2)*c11_dot + hbar/2*Delta*c22_dot) + ((-c22_dot)*(hbar/2*Omega1*c11 - hbar/2*(-Omega2)*c12 + hbar/2*Delta*c21) + (-c22)*(hbar/2*Omega1*c11_dot - hbar/2*(-Omega2)*c12_dot + hbar/2*Delta*c21_dot))) : ℝ) - (0) = (0) / (2) := by
  field_simp
  ring
