-- kdv / energy: So is the energy.
--
-- Given: the definitions, the assumptions and kdv.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 73 operations) = 0
-- uxt_dx4 stands for \frac{\partial^4 u(x,t)}{\partial x^4}
-- uxt_dx_dt stands for \frac{\partial^2 u(x,t)}{\partial x\partial t}
-- uxt_dx3 stands for \frac{\partial^3 u(x,t)}{\partial x^3}
-- uxt_dx2 stands for \frac{\partial^2 u(x,t)}{\partial x^2}
-- uxt_dx stands for \frac{\partial u(x,t)}{\partial x}
-- uxt_dt stands for \frac{\partial u(x,t)}{\partial t}
-- uxt stands for u(x,t)
theorem equation_1 (uxt_dx4 uxt_dx_dt uxt_dx3 uxt_dx2 uxt_dx uxt_dt uxt : ℝ)
    (h1 : 6*uxt_dx*uxt + uxt_dx3 + uxt_dt = 0)
    (h2 : 6*uxt_dx^2 + 6*uxt_dx2*uxt + uxt_dx4 + uxt_dx_dt = 0)
    (hd : (1 : ℝ) ≠ 0) : (36*uxt_dx*uxt^3 - 12*uxt_dx^3 - 12*uxt_dx2*uxt_dx*uxt + 6*uxt_dx3*uxt^2 + 6*uxt_dt*uxt^2 - 2*uxt_dx4*uxt_dx - 2*uxt_dx_dt*uxt_dx : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (36*uxt_dx*uxt^3 - 12*uxt_dx^3 - 12*uxt_dx2*uxt_dx*uxt + 6*uxt_dx3*uxt^2 + 6*uxt_dt*uxt^2 - 2*uxt_dx4*uxt_dx - 2*uxt_dx_dt*uxt_dx) = 0 := by linear_combination (6*uxt^2) * h1 + (-2*uxt_dx) * h2
  have top : (36*uxt_dx*uxt^3 - 12*uxt_dx^3 - 12*uxt_dx2*uxt_dx*uxt + 6*uxt_dx3*uxt^2 + 6*uxt_dt*uxt^2 - 2*uxt_dx4*uxt_dx - 2*uxt_dx_dt*uxt_dx : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (uxt_dx4 uxt_dx_dt uxt_dx3 uxt_dx2 uxt_dx uxt_dt uxt : ℝ) (hD : (2 : ℝ) ≠ 0) : (3*uxt^2*uxt_dt - 1/2*(2*uxt_dx*uxt_dx_dt) + (9/2*(4*uxt^3*uxt_dx) + (3*(2*uxt*uxt_dx)*uxt_dx2 + 3*uxt^2*uxt_dx3) - (6*uxt_dx*uxt_dx^2 + 6*uxt*(2*uxt_dx*uxt_dx2)) - (uxt_dx2*uxt_dx3 + uxt_dx*uxt_dx4) + 1/2*(2*uxt_dx2*uxt_dx3)) : ℝ) - (0) = (36*uxt_dx*uxt^3 - 12*uxt_dx^3 - 12*uxt_dx2*uxt_dx*uxt + 6*uxt_dx3*uxt^2 + 6*uxt_dt*uxt^2 - 2*uxt_dx4*uxt_dx - 2*uxt_dx_dt*uxt_dx) / (2) := by
  field_simp
  ring
