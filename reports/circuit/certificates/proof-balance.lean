-- circuit / balance: What the source gives is stored or turned into heat.
--
-- Given: the definitions, the assumptions and circuit.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{1}{2}\cdot L\cdot (2\cdot \dot{q}\cdot \ddot{q})+\frac{2\cdot q\cdot \dot{q}}{2\cdot C} = \dot{q}\cdot (\operatorname{Re}(V)\cdot \cos(\omega\cdot t)-\operatorname{Im}(V)\cdot \sin(\omega\cdot t))-R\cdot \dot{q}^2
-- q_ddot stands for \ddot{q}
-- q_dot stands for \dot{q}
-- sin_2 stands for \sin(\omega\cdot t)
-- cos_2 stands for \cos(\omega\cdot t)
-- q stands for q
-- V2 stands for \operatorname{Im}(V)
-- V1 stands for \operatorname{Re}(V)
-- C stands for C
-- L stands for L
-- R stands for R
theorem equation_1 (q_ddot q_dot sin_2 cos_2 q V2 V1 C L R : ℝ)
    (h1 : sin_2*V2*C - cos_2*V1*C + q_ddot*C*L + q_dot*C*R + q = 0)
    (hd : (1 : ℝ) ≠ 0) : (4*q_dot*sin_2*V2*C - 4*q_dot*cos_2*V1*C + 4*q_ddot*q_dot*C*L + 4*q_dot^2*C*R + 4*q_dot*q : ℝ) / (4*C) = 0 := by
  have key : (1 : ℝ) * (4*q_dot*sin_2*V2*C - 4*q_dot*cos_2*V1*C + 4*q_ddot*q_dot*C*L + 4*q_dot^2*C*R + 4*q_dot*q) = 0 := by linear_combination (4*q_dot) * h1
  have top : (4*q_dot*sin_2*V2*C - 4*q_dot*cos_2*V1*C + 4*q_ddot*q_dot*C*L + 4*q_dot^2*C*R + 4*q_dot*q : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
