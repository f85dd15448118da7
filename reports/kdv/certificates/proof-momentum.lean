-- kdv / momentum: So is the momentum.
--
-- Given: the definitions, the assumptions and kdv.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- 2\cdot u(x,t)\cdot \frac{\partial u(x,t)}{\partial t}+(4\cdot (3\cdot u(x,t)^2\cdot \frac{\partial u(x,t)}{\partial x})+(2\cdot \frac{\partial u(x,t)}{\partial x}\cdot \frac{\partial^2 u(x,t)}{\partial x^2}+2\cdot u(x,t)\cdot \frac{\partial^3 u(x,t)}{\partial x^3})-2\cdot \frac{\partial u(x,t)}{\partial x}\cdot \frac{\partial^2 u(x,t)}{\partial x^2}) = 0
-- uxt_dx3 stands for \frac{\partial^3 u(x,t)}{\partial x^3}
-- uxt_dx stands for \frac{\partial u(x,t)}{\partial x}
-- uxt_dt stands for \frac{\partial u(x,t)}{\partial t}
-- uxt stands for u(x,t)
theorem equation_1 (uxt_dx3 uxt_dx uxt_dt uxt : ℝ)
    (h1 : 6*uxt_dx*uxt + uxt_dx3 + uxt_dt = 0)
    (hd : (1 : ℝ) ≠ 0) : (12*uxt_dx*uxt^2 + 2*uxt_dx3*uxt + 2*uxt_dt*uxt : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (12*uxt_dx*uxt^2 + 2*uxt_dx3*uxt + 2*uxt_dt*uxt) = 0 := by linear_combination (2*uxt) * h1
  have top : (12*uxt_dx*uxt^2 + 2*uxt_dx3*uxt + 2*uxt_dt*uxt : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (uxt_dx3 uxt_dx2 uxt_dx uxt_dt uxt : ℝ) (hD : (1 : ℝ) ≠ 0) : (2*uxt*uxt_dt + (4*(3*uxt^2*uxt_dx) + (2*uxt_dx*uxt_dx2 + 2*uxt*uxt_dx3) - 2*uxt_dx*uxt_dx2) : ℝ) - (0) = (12*uxt_dx*uxt^2 + 2*uxt_dx3*uxt + 2*uxt_dt*uxt) / (1) := by
  field_simp
  ring
