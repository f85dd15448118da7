-- hamilton / momentum-field: Momenta that are the gradient of such an action change as the force wants it.
--
-- Given: the definitions, the assumptions and hamilton-jacobi.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{\partial P(q,t)}{\partial t}+\frac{P(q,t)}{m}\cdot \frac{\partial P(q,t)}{\partial q} = -\frac{\partial V(q)}{\partial q}
-- Sqt_dq2 stands for \frac{\partial^2 S(q,t)}{\partial q^2}
-- Sqt_dq_dt stands for \frac{\partial^2 S(q,t)}{\partial q\partial t}
-- Vq_dq stands for \frac{\partial V(q)}{\partial q}
-- Sqt_dq stands for \frac{\partial S(q,t)}{\partial q}
-- m stands for m
theorem equation_1 (Sqt_dq2 Sqt_dq_dt Vq_dq Sqt_dq m : ℝ)
    (h1 : 2*Sqt_dq2*Sqt_dq + 2*Sqt_dq_dt*m + 2*Vq_dq*m = 0)
    (hd : (2 : ℝ) ≠ 0) : (Sqt_dq2*Sqt_dq + Sqt_dq_dt*m + Vq_dq*m : ℝ) / (m) = 0 := by
  have key : (2 : ℝ) * (Sqt_dq2*Sqt_dq + Sqt_dq_dt*m + Vq_dq*m) = 0 := by linear_combination (1) * h1
  have top : (Sqt_dq2*Sqt_dq + Sqt_dq_dt*m + Vq_dq*m : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
