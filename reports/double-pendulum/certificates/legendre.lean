-- double-pendulum / legendre: What momenta and rates give, less the Lagrangian, is the energy.
--
-- Given: the definitions, the assumptions and lagrange.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- p\cdot \dot{\alpha}+P\cdot \dot{\beta}-(\frac{m+M}{2}\cdot \ell^2\cdot \dot{\alpha}^2+\frac{M}{2}\cdot b^2\cdot \dot{\beta}^2+M\cdot \ell\cdot b\cdot \dot{\alpha}\cdot \dot{\beta}\cdot \cos(\alpha-\beta)-(-(m+M)\cdot g\cdot \ell\cdot \cos(\alpha)-M\cdot g\cdot b\cdot \cos(\beta))) = \frac{m+M}{2}\cdot \ell^2\cdot \dot{\alpha}^2+\frac{M}{2}\cdot b^2\cdot \dot{\beta}^2+M\cdot \ell\cdot b\cdot \dot{\alpha}\cdot \dot{\beta}\cdot \cos(\alpha-\beta)+(-(m+M)\cdot g\cdot \ell\cdot \cos(\alpha)-M\cdot g\cdot b\cdot \cos(\beta))
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
