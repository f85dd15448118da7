-- kepler-laws / across: Across the radius there is no force, so that one combination does not change.
--
-- Given: the definitions, the assumptions and newton.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- r\cdot \ddot{\theta}+2\cdot \dot{r}\cdot \dot{\theta} = 0
-- r_ddot stands for \ddot{r}
-- theta_ddot stands for \ddot{\theta}
-- r_dot stands for \dot{r}
-- theta_dot stands for \dot{\theta}
-- sin_theta stands for \sin(\theta)
-- cos_theta stands for \cos(\theta)
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (r_ddot theta_ddot r_dot theta_dot sin_theta cos_theta M G r : ℝ)
    (h1 : sin_theta^2 + cos_theta^2 - 1 = 0)
    (h2 : -theta_dot^2*cos_theta*r^3 - 2*r_dot*theta_dot*sin_theta*r^2 - theta_ddot*sin_theta*r^3 + r_ddot*cos_theta*r^2 + cos_theta*M*G = 0)
    (h3 : -theta_dot^2*sin_theta*r^3 + 2*r_dot*theta_dot*cos_theta*r^2 + theta_ddot*cos_theta*r^3 + r_ddot*sin_theta*r^2 + sin_theta*M*G = 0)
    (hd : (r^2 : ℝ) ≠ 0) : (2*r_dot*theta_dot + theta_ddot*r : ℝ) / (1) = 0 := by
  have key : (r^2 : ℝ) * (2*r_dot*theta_dot + theta_ddot*r) = 0 := by linear_combination (-2*r_dot*theta_dot*r^2 - theta_ddot*r^3) * h1 + (-sin_theta) * h2 + (cos_theta) * h3
  have top : (2*r_dot*theta_dot + theta_ddot*r : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- 2\cdot r\cdot \dot{r}\cdot \dot{\theta}+r^2\cdot \ddot{\theta} = 0
-- r_ddot stands for \ddot{r}
-- theta_ddot stands for \ddot{\theta}
-- r_dot stands for \dot{r}
-- theta_dot stands for \dot{\theta}
-- sin_theta stands for \sin(\theta)
-- cos_theta stands for \cos(\theta)
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_2 (r_ddot theta_ddot r_dot theta_dot sin_theta cos_theta M G r : ℝ)
    (h1 : sin_theta^2 + cos_theta^2 - 1 = 0)
    (h2 : -theta_dot^2*cos_theta*r^3 - 2*r_dot*theta_dot*sin_theta*r^2 - theta_ddot*sin_theta*r^3 + r_ddot*cos_theta*r^2 + cos_theta*M*G = 0)
    (h3 : -theta_dot^2*sin_theta*r^3 + 2*r_dot*theta_dot*cos_theta*r^2 + theta_ddot*cos_theta*r^3 + r_ddot*sin_theta*r^2 + sin_theta*M*G = 0)
    (hd : (r : ℝ) ≠ 0) : (2*r_dot*theta_dot*r + theta_ddot*r^2 : ℝ) / (1) = 0 := by
  have key : (r : ℝ) * (2*r_dot*theta_dot*r + theta_ddot*r^2) = 0 := by linear_combination (-2*r_dot*theta_dot*r^2 - theta_ddot*r^3) * h1 + (-sin_theta) * h2 + (cos_theta) * h3
  have top : (2*r_dot*theta_dot*r + theta_ddot*r^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- 2\cdot r\cdot \dot{r}\cdot \dot{\theta}+r^2\cdot \ddot{\theta} = 0
-- r_ddot stands for \ddot{r}
-- theta_ddot stands for \ddot{\theta}
-- r_dot stands for \dot{r}
-- theta_dot stands for \dot{\theta}
-- sin_theta stands for \sin(\theta)
-- cos_theta stands for \cos(\theta)
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_3 (r_ddot theta_ddot r_dot theta_dot sin_theta cos_theta M G r : ℝ)
    (h1 : sin_theta^2 + cos_theta^2 - 1 = 0)
    (h2 : -theta_dot^2*cos_theta*r^3 - 2*r_dot*theta_dot*sin_theta*r^2 - theta_ddot*sin_theta*r^3 + r_ddot*cos_theta*r^2 + cos_theta*M*G = 0)
    (h3 : -theta_dot^2*sin_theta*r^3 + 2*r_dot*theta_dot*cos_theta*r^2 + theta_ddot*cos_theta*r^3 + r_ddot*sin_theta*r^2 + sin_theta*M*G = 0)
    (hd : (r : ℝ) ≠ 0) : (2*r_dot*theta_dot*r + theta_ddot*r^2 : ℝ) / (1) = 0 := by
  have key : (r : ℝ) * (2*r_dot*theta_dot*r + theta_ddot*r^2) = 0 := by linear_combination (-2*r_dot*theta_dot*r^2 - theta_ddot*r^3) * h1 + (-sin_theta) * h2 + (cos_theta) * h3
  have top : (2*r_dot*theta_dot*r + theta_ddot*r^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
