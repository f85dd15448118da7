-- kepler-laws / angular-momentum: So the angular momentum does not change.
--
-- Given: the definitions, the assumptions and newton.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 137 operations) = r\cdot \cos(\theta)\cdot (-G\cdot \frac{M\cdot m}{r^2}\cdot \sin(\theta))-r\cdot \sin(\theta)\cdot (-G\cdot \frac{M\cdot m}{r^2}\cdot \cos(\theta))
-- r_ddot stands for \ddot{r}
-- theta_ddot stands for \ddot{\theta}
-- r_dot stands for \dot{r}
-- theta_dot stands for \dot{\theta}
-- sin_theta stands for \sin(\theta)
-- cos_theta stands for \cos(\theta)
-- M stands for M
-- G stands for G
-- m stands for m
-- r stands for r
theorem equation_3 (r_ddot theta_ddot r_dot theta_dot sin_theta cos_theta M G m r : ℝ)
    (h1 : sin_theta^2 + cos_theta^2 - 1 = 0)
    (h2 : -theta_dot^2*cos_theta*r^3 - 2*r_dot*theta_dot*sin_theta*r^2 - theta_ddot*sin_theta*r^3 + r_ddot*cos_theta*r^2 + cos_theta*M*G = 0)
    (h3 : -theta_dot^2*sin_theta*r^3 + 2*r_dot*theta_dot*cos_theta*r^2 + theta_ddot*cos_theta*r^3 + r_ddot*sin_theta*r^2 + sin_theta*M*G = 0)
    (hd : (1 : ℝ) ≠ 0) : (2*r_dot*theta_dot*sin_theta^2*m*r^3 + 2*r_dot*theta_dot*cos_theta^2*m*r^3 + theta_ddot*sin_theta^2*m*r^4 + theta_ddot*cos_theta^2*m*r^4 : ℝ) / (r^2) = 0 := by
  have key : (1 : ℝ) * (2*r_dot*theta_dot*sin_theta^2*m*r^3 + 2*r_dot*theta_dot*cos_theta^2*m*r^3 + theta_ddot*sin_theta^2*m*r^4 + theta_ddot*cos_theta^2*m*r^4) = 0 := by linear_combination (-2*r_dot*theta_dot*sin_theta^2*m*r^3 - 2*r_dot*theta_dot*cos_theta^2*m*r^3 - theta_ddot*sin_theta^2*m*r^4 - theta_ddot*cos_theta^2*m*r^4) * h1 + (-sin_theta^3*m*r - sin_theta*cos_theta^2*m*r) * h2 + (sin_theta^2*cos_theta*m*r + cos_theta^3*m*r) * h3
  have top : (2*r_dot*theta_dot*sin_theta^2*m*r^3 + 2*r_dot*theta_dot*cos_theta^2*m*r^3 + theta_ddot*sin_theta^2*m*r^4 + theta_ddot*cos_theta^2*m*r^4 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (an expression of 137 operations) = 0
-- r_ddot stands for \ddot{r}
-- theta_ddot stands for \ddot{\theta}
-- r_dot stands for \dot{r}
-- theta_dot stands for \dot{\theta}
-- sin_theta stands for \sin(\theta)
-- cos_theta stands for \cos(\theta)
-- M stands for M
-- G stands for G
-- m stands for m
-- r stands for r
theorem equation_7 (r_ddot theta_ddot r_dot theta_dot sin_theta cos_theta M G m r : ℝ)
    (h1 : sin_theta^2 + cos_theta^2 - 1 = 0)
    (h2 : -theta_dot^2*cos_theta*r^3 - 2*r_dot*theta_dot*sin_theta*r^2 - theta_ddot*sin_theta*r^3 + r_ddot*cos_theta*r^2 + cos_theta*M*G = 0)
    (h3 : -theta_dot^2*sin_theta*r^3 + 2*r_dot*theta_dot*cos_theta*r^2 + theta_ddot*cos_theta*r^3 + r_ddot*sin_theta*r^2 + sin_theta*M*G = 0)
    (hd : (r : ℝ) ≠ 0) : (2*r_dot*theta_dot*sin_theta^2*m*r + 2*r_dot*theta_dot*cos_theta^2*m*r + theta_ddot*sin_theta^2*m*r^2 + theta_ddot*cos_theta^2*m*r^2 : ℝ) / (1) = 0 := by
  have key : (r : ℝ) * (2*r_dot*theta_dot*sin_theta^2*m*r + 2*r_dot*theta_dot*cos_theta^2*m*r + theta_ddot*sin_theta^2*m*r^2 + theta_ddot*cos_theta^2*m*r^2) = 0 := by linear_combination (-2*r_dot*theta_dot*sin_theta^2*m*r^2 - 2*r_dot*theta_dot*cos_theta^2*m*r^2 - theta_ddot*sin_theta^2*m*r^3 - theta_ddot*cos_theta^2*m*r^3) * h1 + (-sin_theta^3*m - sin_theta*cos_theta^2*m) * h2 + (sin_theta^2*cos_theta*m + cos_theta^3*m) * h3
  have top : (2*r_dot*theta_dot*sin_theta^2*m*r + 2*r_dot*theta_dot*cos_theta^2*m*r + theta_ddot*sin_theta^2*m*r^2 + theta_ddot*cos_theta^2*m*r^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
