-- schwarzschild / angular-momentum: The angular momentum is conserved, since the metric does not change with the azimuth.
--
-- Given: the definitions, the assumptions and geodesic.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{\ell} = 0
-- varphi_ddot stands for \ddot{\varphi}
-- varphi_dot stands for \dot{\varphi}
-- r_dot stands for \dot{r}
-- r stands for r
theorem equation_1 (varphi_ddot varphi_dot r_dot r : ℝ)
    (h1 : 2*varphi_dot*r_dot + varphi_ddot*r = 0)
    (hd : (1 : ℝ) ≠ 0) : (2*varphi_dot*r_dot*r + varphi_ddot*r^2 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (2*varphi_dot*r_dot*r + varphi_ddot*r^2) = 0 := by linear_combination (r) * h1
  have top : (2*varphi_dot*r_dot*r + varphi_ddot*r^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
