-- double-pendulum / energy: The energy is conserved.
--
-- Given: the definitions, the assumptions and lagrange.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 99 operations) = 0
-- beta_ddot stands for \ddot{\beta}
-- alpha_ddot stands for \ddot{\alpha}
-- beta_dot stands for \dot{\beta}
-- alpha_dot stands for \dot{\alpha}
-- sin_beta stands for \sin(\beta)
-- cos_beta stands for \cos(\beta)
-- sin_alpha stands for \sin(\alpha)
-- cos_alpha stands for \cos(\alpha)
-- g stands for g
-- b stands for b
-- ell stands for \ell
-- M stands for M
-- m stands for m
theorem equation_1 (beta_ddot alpha_ddot beta_dot alpha_dot sin_beta cos_beta sin_alpha cos_alpha g b ell M m : ℝ)
    (h1 : 2*beta_dot^2*cos_beta*sin_alpha*b*ell*M - 2*beta_dot^2*sin_beta*cos_alpha*b*ell*M + 2*beta_ddot*sin_beta*sin_alpha*b*ell*M + 2*beta_ddot*cos_beta*cos_alpha*b*ell*M + 2*sin_alpha*g*ell*M + 2*alpha_ddot*ell^2*M + 2*sin_alpha*g*ell*m + 2*alpha_ddot*ell^2*m = 0)
    (h2 : -2*alpha_dot^2*cos_beta*sin_alpha*b*ell*M + 2*alpha_dot^2*sin_beta*cos_alpha*b*ell*M + 2*alpha_ddot*sin_beta*sin_alpha*b*ell*M + 2*alpha_ddot*cos_beta*cos_alpha*b*ell*M + 2*sin_beta*g*b*M + 2*beta_ddot*b^2*M = 0)
    (hd : (1 : ℝ) ≠ 0) : (2*beta_dot^2*alpha_dot*cos_beta*sin_alpha*b*ell*M - 2*beta_dot*alpha_dot^2*cos_beta*sin_alpha*b*ell*M - 2*beta_dot^2*alpha_dot*sin_beta*cos_alpha*b*ell*M + 2*beta_dot*alpha_dot^2*sin_beta*cos_alpha*b*ell*M + 2*alpha_ddot*beta_dot*sin_beta*sin_alpha*b*ell*M + 2*beta_ddot*alpha_dot*sin_beta*sin_alpha*b*ell*M + 2*alpha_ddot*beta_dot*cos_beta*cos_alpha*b*ell*M + 2*beta_ddot*alpha_dot*cos_beta*cos_alpha*b*ell*M + 2*beta_dot*sin_beta*g*b*M + 2*beta_ddot*beta_dot*b^2*M + 2*alpha_dot*sin_alpha*g*ell*M + 2*alpha_ddot*alpha_dot*ell^2*M + 2*alpha_dot*sin_alpha*g*ell*m + 2*alpha_ddot*alpha_dot*ell^2*m : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (2*beta_dot^2*alpha_dot*cos_beta*sin_alpha*b*ell*M - 2*beta_dot*alpha_dot^2*cos_beta*sin_alpha*b*ell*M - 2*beta_dot^2*alpha_dot*sin_beta*cos_alpha*b*ell*M + 2*beta_dot*alpha_dot^2*sin_beta*cos_alpha*b*ell*M + 2*alpha_ddot*beta_dot*sin_beta*sin_alpha*b*ell*M + 2*beta_ddot*alpha_dot*sin_beta*sin_alpha*b*ell*M + 2*alpha_ddot*beta_dot*cos_beta*cos_alpha*b*ell*M + 2*beta_ddot*alpha_dot*cos_beta*cos_alpha*b*ell*M + 2*beta_dot*sin_beta*g*b*M + 2*beta_ddot*beta_dot*b^2*M + 2*alpha_dot*sin_alpha*g*ell*M + 2*alpha_ddot*alpha_dot*ell^2*M + 2*alpha_dot*sin_alpha*g*ell*m + 2*alpha_ddot*alpha_dot*ell^2*m) = 0 := by linear_combination (alpha_dot) * h1 + (beta_dot) * h2
  have top : (2*beta_dot^2*alpha_dot*cos_beta*sin_alpha*b*ell*M - 2*beta_dot*alpha_dot^2*cos_beta*sin_alpha*b*ell*M - 2*beta_dot^2*alpha_dot*sin_beta*cos_alpha*b*ell*M + 2*beta_dot*alpha_dot^2*sin_beta*cos_alpha*b*ell*M + 2*alpha_ddot*beta_dot*sin_beta*sin_alpha*b*ell*M + 2*beta_ddot*alpha_dot*sin_beta*sin_alpha*b*ell*M + 2*alpha_ddot*beta_dot*cos_beta*cos_alpha*b*ell*M + 2*beta_ddot*alpha_dot*cos_beta*cos_alpha*b*ell*M + 2*beta_dot*sin_beta*g*b*M + 2*beta_ddot*beta_dot*b^2*M + 2*alpha_dot*sin_alpha*g*ell*M + 2*alpha_ddot*alpha_dot*ell^2*M + 2*alpha_dot*sin_alpha*g*ell*m + 2*alpha_ddot*alpha_dot*ell^2*m : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
