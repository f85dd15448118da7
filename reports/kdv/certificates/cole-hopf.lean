-- kdv / cole-hopf: From the conduction of heat follows Burgers' equation.
--
-- Given: the definitions, the assumptions and heat.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{\partial u(x,t)}{\partial t}+u(x,t)\cdot \frac{\partial u(x,t)}{\partial x} = \nu\cdot \frac{\partial^2 u(x,t)}{\partial x^2}
-- phixt stands for \phi(x,t)
theorem equation_1 (phixt : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (phixt^18) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
