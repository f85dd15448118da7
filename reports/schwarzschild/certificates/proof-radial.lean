-- schwarzschild / radial: The radius moves as in a potential, with one term more than Newton's.
--
-- Given: the definitions, the assumptions and normalisation.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{1}{2}\cdot \dot{r}^2+\frac{1}{2}\cdot (1-\frac{2\cdot M}{r})\cdot (1+\frac{\ell^2}{r^2}) = \frac{1}{2}\cdot E^2
-- varphi_dot stands for \dot{\varphi}
-- r_dot stands for \dot{r}
-- T_dot stands for \dot{T}
-- r stands for r
-- M stands for M
theorem equation_1 (varphi_dot r_dot T_dot r M : ℝ)
    (h1 : -varphi_dot^2*r^4 + 2*varphi_dot^2*r^3*M - r_dot^2*r^2 + T_dot^2*r^2 - 4*T_dot^2*r*M + 4*T_dot^2*M^2 - r^2 + 2*r*M = 0)
    (hd : (1 : ℝ) ≠ 0) : (4*varphi_dot^2*r^7 - 8*varphi_dot^2*r^6*M + 4*r_dot^2*r^5 - 4*T_dot^2*r^5 + 16*T_dot^2*r^4*M - 16*T_dot^2*r^3*M^2 + 4*r^5 - 8*r^4*M : ℝ) / (8*r^5) = 0 := by
  have key : (1 : ℝ) * (4*varphi_dot^2*r^7 - 8*varphi_dot^2*r^6*M + 4*r_dot^2*r^5 - 4*T_dot^2*r^5 + 16*T_dot^2*r^4*M - 16*T_dot^2*r^3*M^2 + 4*r^5 - 8*r^4*M) = 0 := by linear_combination (-4*r^3) * h1
  have top : (4*varphi_dot^2*r^7 - 8*varphi_dot^2*r^6*M + 4*r_dot^2*r^5 - 4*T_dot^2*r^5 + 16*T_dot^2*r^4*M - 16*T_dot^2*r^3*M^2 + 4*r^5 - 8*r^4*M : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
