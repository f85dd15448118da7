-- kepler-laws / every-solution: Every solution is of this form: what would be $C\cos\theta_0$ and $C\sin\theta_0$ does not change.
--
-- Given: the definitions, the assumptions and binet, across.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 133 operations) = 0
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
    (h1 : -theta_dot^5*r^16 - 2*r_dot^2*theta_dot^3*r^14 - theta_ddot*r_dot*theta_dot^2*r^15 + r_ddot*theta_dot^3*r^15 + theta_dot^3*M*G*r^13 = 0)
    (h2 : 2*r_dot*theta_dot + theta_ddot*r = 0)
    (hd : (1 : ℝ) ≠ 0) : (-theta_dot^10*sin_theta*r^24 - 2*r_dot^2*theta_dot^8*sin_theta*r^22 - theta_ddot*r_dot*theta_dot^7*sin_theta*r^23 + r_ddot*theta_dot^8*sin_theta*r^23 + theta_dot^8*sin_theta*M*G*r^21 + 4*r_dot*theta_dot^7*cos_theta*M*G*r^20 + 2*theta_ddot*theta_dot^6*cos_theta*M*G*r^21 : ℝ) / (theta_dot^9*r^25) = 0 := by
  have key : (1 : ℝ) * (-theta_dot^10*sin_theta*r^24 - 2*r_dot^2*theta_dot^8*sin_theta*r^22 - theta_ddot*r_dot*theta_dot^7*sin_theta*r^23 + r_ddot*theta_dot^8*sin_theta*r^23 + theta_dot^8*sin_theta*M*G*r^21 + 4*r_dot*theta_dot^7*cos_theta*M*G*r^20 + 2*theta_ddot*theta_dot^6*cos_theta*M*G*r^21) = 0 := by linear_combination (theta_dot^5*sin_theta*r^8) * h1 + (2*theta_dot^6*cos_theta*M*G*r^20) * h2
  have top : (-theta_dot^10*sin_theta*r^24 - 2*r_dot^2*theta_dot^8*sin_theta*r^22 - theta_ddot*r_dot*theta_dot^7*sin_theta*r^23 + r_ddot*theta_dot^8*sin_theta*r^23 + theta_dot^8*sin_theta*M*G*r^21 + 4*r_dot*theta_dot^7*cos_theta*M*G*r^20 + 2*theta_ddot*theta_dot^6*cos_theta*M*G*r^21 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (an expression of 133 operations) = 0
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
    (h1 : -theta_dot^5*r^16 - 2*r_dot^2*theta_dot^3*r^14 - theta_ddot*r_dot*theta_dot^2*r^15 + r_ddot*theta_dot^3*r^15 + theta_dot^3*M*G*r^13 = 0)
    (h2 : 2*r_dot*theta_dot + theta_ddot*r = 0)
    (hd : (1 : ℝ) ≠ 0) : (theta_dot^10*cos_theta*r^24 + 2*r_dot^2*theta_dot^8*cos_theta*r^22 + theta_ddot*r_dot*theta_dot^7*cos_theta*r^23 - r_ddot*theta_dot^8*cos_theta*r^23 - theta_dot^8*cos_theta*M*G*r^21 + 4*r_dot*theta_dot^7*sin_theta*M*G*r^20 + 2*theta_ddot*theta_dot^6*sin_theta*M*G*r^21 : ℝ) / (theta_dot^9*r^25) = 0 := by
  have key : (1 : ℝ) * (theta_dot^10*cos_theta*r^24 + 2*r_dot^2*theta_dot^8*cos_theta*r^22 + theta_ddot*r_dot*theta_dot^7*cos_theta*r^23 - r_ddot*theta_dot^8*cos_theta*r^23 - theta_dot^8*cos_theta*M*G*r^21 + 4*r_dot*theta_dot^7*sin_theta*M*G*r^20 + 2*theta_ddot*theta_dot^6*sin_theta*M*G*r^21) = 0 := by linear_combination (-theta_dot^5*cos_theta*r^8) * h1 + (2*theta_dot^6*sin_theta*M*G*r^20) * h2
  have top : (theta_dot^10*cos_theta*r^24 + 2*r_dot^2*theta_dot^8*cos_theta*r^22 + theta_ddot*r_dot*theta_dot^7*cos_theta*r^23 - r_ddot*theta_dot^8*cos_theta*r^23 - theta_dot^8*cos_theta*M*G*r^21 + 4*r_dot*theta_dot^7*sin_theta*M*G*r^20 + 2*theta_ddot*theta_dot^6*sin_theta*M*G*r^21 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
