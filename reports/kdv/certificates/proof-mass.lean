-- kdv / mass: The mass is conserved.
--
-- Given: the definitions, the assumptions and kdv.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{\partial u(x,t)}{\partial t}+(3\cdot (2\cdot u(x,t)\cdot \frac{\partial u(x,t)}{\partial x})+\frac{\partial^3 u(x,t)}{\partial x^3}) = 0
-- uxt_dx3 stands for \frac{\partial^3 u(x,t)}{\partial x^3}
-- uxt_dx stands for \frac{\partial u(x,t)}{\partial x}
-- uxt_dt stands for \frac{\partial u(x,t)}{\partial t}
-- uxt stands for u(x,t)
theorem equation_1 (uxt_dx3 uxt_dx uxt_dt uxt : ℝ)
    (h1 : 6*uxt_dx*uxt + uxt_dx3 + uxt_dt = 0)
    (hd : (1 : ℝ) ≠ 0) : (6*uxt_dx*uxt + uxt_dx3 + uxt_dt : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (6*uxt_dx*uxt + uxt_dx3 + uxt_dt) = 0 := by linear_combination (1) * h1
  have top : (6*uxt_dx*uxt + uxt_dx3 + uxt_dt : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (uxt_dx3 uxt_dx uxt_dt uxt : ℝ) (hD : (1 : ℝ) ≠ 0) : (uxt_dt + (3*(2*uxt*uxt_dx) + uxt_dx3) : ℝ) - (0) = (6*uxt_dx*uxt + uxt_dx3 + uxt_dt) / (1) := by
  field_simp
  ring
