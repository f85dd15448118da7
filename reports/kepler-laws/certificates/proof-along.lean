-- kepler-laws / along: Along the radius there is gravity.
--
-- Given: the definitions, the assumptions and newton.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \ddot{r}-r\cdot \dot{\theta}^2 = -\frac{G\cdot M}{r^2}
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
    (hd : (1 : ℝ) ≠ 0) : (-theta_dot^2*r^3 + r_ddot*r^2 + M*G : ℝ) / (r^2) = 0 := by
  have key : (1 : ℝ) * (-theta_dot^2*r^3 + r_ddot*r^2 + M*G) = 0 := by linear_combination (theta_dot^2*r^3 - r_ddot*r^2 - M*G) * h1 + (cos_theta) * h2 + (sin_theta) * h3
  have top : (-theta_dot^2*r^3 + r_ddot*r^2 + M*G : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \ddot{r}-r\cdot \frac{(r^2\cdot \dot{\theta})^{2}}{r^4} = -\frac{G\cdot M}{r^2}
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
    (hd : (1 : ℝ) ≠ 0) : (-theta_dot^2*r^7 + r_ddot*r^6 + M*G*r^4 : ℝ) / (r^6) = 0 := by
  have key : (1 : ℝ) * (-theta_dot^2*r^7 + r_ddot*r^6 + M*G*r^4) = 0 := by linear_combination (theta_dot^2*r^7 - r_ddot*r^6 - M*G*r^4) * h1 + (cos_theta*r^4) * h2 + (sin_theta*r^4) * h3
  have top : (-theta_dot^2*r^7 + r_ddot*r^6 + M*G*r^4 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \ddot{r}-\frac{(r^2\cdot \dot{\theta})^{2}}{r^3} = -\frac{G\cdot M}{r^2}
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
    (hd : (1 : ℝ) ≠ 0) : (-theta_dot^2*r^6 + r_ddot*r^5 + M*G*r^3 : ℝ) / (r^5) = 0 := by
  have key : (1 : ℝ) * (-theta_dot^2*r^6 + r_ddot*r^5 + M*G*r^3) = 0 := by linear_combination (theta_dot^2*r^6 - r_ddot*r^5 - M*G*r^3) * h1 + (cos_theta*r^3) * h2 + (sin_theta*r^3) * h3
  have top : (-theta_dot^2*r^6 + r_ddot*r^5 + M*G*r^3 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
