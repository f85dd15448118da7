-- deriglazov-comment / hamiltonian: The system is Hamiltonian: with the momentum Π = IΩ in the body and the energy as a function of it, Ω is the derivative of the energy, and Π turns about it.
--
-- Given: the definitions, the assumptions and t1-euler.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{\Pi}_1 = \Pi_2\cdot (\frac{1}{I_3}\cdot \Pi_3)-\Pi_3\cdot (\frac{1}{I_2}\cdot \Pi_2)
-- Omega1_dot stands for \dot{\Omega}_1
-- Omega3 stands for \Omega_3
-- Omega2 stands for \Omega_2
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_5 (Omega1_dot Omega3 Omega2 I3 I2 I1 : ℝ)
    (h1 : Omega3*Omega2*I3 - Omega3*Omega2*I2 + Omega1_dot*I1 = 0)
    (hd : (1 : ℝ) ≠ 0) : (Omega3*Omega2*I3^2*I2 - Omega3*Omega2*I3*I2^2 + Omega1_dot*I3*I2*I1 : ℝ) / (I3*I2) = 0 := by
  have key : (1 : ℝ) * (Omega3*Omega2*I3^2*I2 - Omega3*Omega2*I3*I2^2 + Omega1_dot*I3*I2*I1) = 0 := by linear_combination (I3*I2) * h1
  have top : (Omega3*Omega2*I3^2*I2 - Omega3*Omega2*I3*I2^2 + Omega1_dot*I3*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\Pi}_2 = \Pi_3\cdot (\frac{1}{I_1}\cdot \Pi_1)-\Pi_1\cdot (\frac{1}{I_3}\cdot \Pi_3)
-- Omega2_dot stands for \dot{\Omega}_2
-- Omega3 stands for \Omega_3
-- Omega1 stands for \Omega_1
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_6 (Omega2_dot Omega3 Omega1 I3 I2 I1 : ℝ)
    (h1 : -Omega3*Omega1*I3 + Omega3*Omega1*I1 + Omega2_dot*I2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-Omega3*Omega1*I3^2*I1 + Omega3*Omega1*I3*I1^2 + Omega2_dot*I3*I2*I1 : ℝ) / (I3*I1) = 0 := by
  have key : (1 : ℝ) * (-Omega3*Omega1*I3^2*I1 + Omega3*Omega1*I3*I1^2 + Omega2_dot*I3*I2*I1) = 0 := by linear_combination (I3*I1) * h1
  have top : (-Omega3*Omega1*I3^2*I1 + Omega3*Omega1*I3*I1^2 + Omega2_dot*I3*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\Pi}_3 = \Pi_1\cdot (\frac{1}{I_2}\cdot \Pi_2)-\Pi_2\cdot (\frac{1}{I_1}\cdot \Pi_1)
-- Omega3_dot stands for \dot{\Omega}_3
-- Omega2 stands for \Omega_2
-- Omega1 stands for \Omega_1
-- I3 stands for I_3
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_7 (Omega3_dot Omega2 Omega1 I3 I2 I1 : ℝ)
    (h1 : Omega2*Omega1*I2 - Omega2*Omega1*I1 + Omega3_dot*I3 = 0)
    (hd : (1 : ℝ) ≠ 0) : (Omega2*Omega1*I2^2*I1 - Omega2*Omega1*I2*I1^2 + Omega3_dot*I3*I2*I1 : ℝ) / (I2*I1) = 0 := by
  have key : (1 : ℝ) * (Omega2*Omega1*I2^2*I1 - Omega2*Omega1*I2*I1^2 + Omega3_dot*I3*I2*I1) = 0 := by linear_combination (I2*I1) * h1
  have top : (Omega2*Omega1*I2^2*I1 - Omega2*Omega1*I2*I1^2 + Omega3_dot*I3*I2*I1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
