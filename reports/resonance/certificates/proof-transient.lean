-- resonance / transient: What a motion differs by from the steady one obeys the equation without force.
--
-- Given: the definitions, the assumptions and oscillator.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- m\cdot \ddot{y}+\gamma\cdot \dot{y}+k\cdot y = 0
-- x_ddot stands for \ddot{x}
-- x_dot stands for \dot{x}
-- sin_2 stands for \sin(\omega\cdot t)
-- cos_2 stands for \cos(\omega\cdot t)
-- F2 stands for \operatorname{Im}(F)
-- F1 stands for \operatorname{Re}(F)
-- x stands for x
-- gamma stands for \gamma
-- omega stands for \omega
-- m stands for m
-- k stands for k
theorem equation_1 (x_ddot x_dot sin_2 cos_2 F2 F1 x gamma omega m k : ℝ)
    (h1 : sin_2*F2 - cos_2*F1 + x_dot*gamma + x_ddot*m + x*k = 0)
    (hd : (1 : ℝ) ≠ 0) : (sin_2*F2*omega^4*m^2 - cos_2*F1*omega^4*m^2 + x_dot*gamma*omega^4*m^2 + x_ddot*omega^4*m^3 + x*omega^4*m^2*k + sin_2*F2*gamma^2*omega^2 - cos_2*F1*gamma^2*omega^2 + x_dot*gamma^3*omega^2 + x_ddot*gamma^2*omega^2*m + x*gamma^2*omega^2*k - 2*sin_2*F2*omega^2*m*k + 2*cos_2*F1*omega^2*m*k - 2*x_dot*gamma*omega^2*m*k - 2*x_ddot*omega^2*m^2*k - 2*x*omega^2*m*k^2 + sin_2*F2*k^2 - cos_2*F1*k^2 + x_dot*gamma*k^2 + x_ddot*m*k^2 + x*k^3 : ℝ) / (omega^4*m^2 + gamma^2*omega^2 - 2*omega^2*m*k + k^2) = 0 := by
  have key : (1 : ℝ) * (sin_2*F2*omega^4*m^2 - cos_2*F1*omega^4*m^2 + x_dot*gamma*omega^4*m^2 + x_ddot*omega^4*m^3 + x*omega^4*m^2*k + sin_2*F2*gamma^2*omega^2 - cos_2*F1*gamma^2*omega^2 + x_dot*gamma^3*omega^2 + x_ddot*gamma^2*omega^2*m + x*gamma^2*omega^2*k - 2*sin_2*F2*omega^2*m*k + 2*cos_2*F1*omega^2*m*k - 2*x_dot*gamma*omega^2*m*k - 2*x_ddot*omega^2*m^2*k - 2*x*omega^2*m*k^2 + sin_2*F2*k^2 - cos_2*F1*k^2 + x_dot*gamma*k^2 + x_ddot*m*k^2 + x*k^3) = 0 := by linear_combination (omega^4*m^2 + gamma^2*omega^2 - 2*omega^2*m*k + k^2) * h1
  have top : (sin_2*F2*omega^4*m^2 - cos_2*F1*omega^4*m^2 + x_dot*gamma*omega^4*m^2 + x_ddot*omega^4*m^3 + x*omega^4*m^2*k + sin_2*F2*gamma^2*omega^2 - cos_2*F1*gamma^2*omega^2 + x_dot*gamma^3*omega^2 + x_ddot*gamma^2*omega^2*m + x*gamma^2*omega^2*k - 2*sin_2*F2*omega^2*m*k + 2*cos_2*F1*omega^2*m*k - 2*x_dot*gamma*omega^2*m*k - 2*x_ddot*omega^2*m^2*k - 2*x*omega^2*m*k^2 + sin_2*F2*k^2 - cos_2*F1*k^2 + x_dot*gamma*k^2 + x_ddot*m*k^2 + x*k^3 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
