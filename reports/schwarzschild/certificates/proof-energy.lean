-- schwarzschild / energy: The energy is conserved, since the metric does not change with time.
--
-- Given: the definitions, the assumptions and geodesic.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{E} = 0
-- T_ddot stands for \ddot{T}
-- r_dot stands for \dot{r}
-- T_dot stands for \dot{T}
-- r stands for r
-- M stands for M
theorem equation_1 (T_ddot r_dot T_dot r M : ℝ)
    (h1 : T_ddot*r^2 + 2*r_dot*T_dot*M - 2*T_ddot*r*M = 0)
    (hd : (1 : ℝ) ≠ 0) : (T_ddot*r^3 + 2*r_dot*T_dot*r*M - 2*T_ddot*r^2*M : ℝ) / (r^3) = 0 := by
  have key : (1 : ℝ) * (T_ddot*r^3 + 2*r_dot*T_dot*r*M - 2*T_ddot*r^2*M) = 0 := by linear_combination (r) * h1
  have top : (T_ddot*r^3 + 2*r_dot*T_dot*r*M - 2*T_ddot*r^2*M : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
