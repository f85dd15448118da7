-- kepler-laws / conic: With the axis through the perihelion, the orbit is a conic section.
--
-- Given: the definitions, the assumptions and solution.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{1}{r} = \frac{G\cdot M}{(r^2\cdot \dot{\theta})^{2}}\cdot (1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}\cdot \cos(\theta))
-- theta_dot stands for \dot{\theta}
-- cos_theta stands for \cos(\theta)
-- C stands for C
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (theta_dot cos_theta C M G r : ℝ)
    (h1 : -theta_dot^2*cos_theta*C*r^5 + theta_dot^2*r^4 - M*G*r = 0)
    (hd : (1 : ℝ) ≠ 0) : (-theta_dot^2*cos_theta*C*M*G*r^5 + theta_dot^2*M*G*r^4 - M^2*G^2*r : ℝ) / (theta_dot^2*M*G*r^5) = 0 := by
  have key : (1 : ℝ) * (-theta_dot^2*cos_theta*C*M*G*r^5 + theta_dot^2*M*G*r^4 - M^2*G^2*r) = 0 := by linear_combination (M*G) * h1
  have top : (-theta_dot^2*cos_theta*C*M*G*r^5 + theta_dot^2*M*G*r^4 - M^2*G^2*r : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- r = \frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M\cdot (1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}\cdot \cos(\theta))}
-- theta_dot stands for \dot{\theta}
-- cos_theta stands for \cos(\theta)
-- C stands for C
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (theta_dot cos_theta C M G r : ℝ)
    (h1 : -theta_dot^2*cos_theta*C*r^5 + theta_dot^2*r^4 - M*G*r = 0)
    (hd : (1 : ℝ) ≠ 0) : (theta_dot^2*cos_theta*C*M*G*r^5 - theta_dot^2*M*G*r^4 + M^2*G^2*r : ℝ) / (theta_dot^2*cos_theta*C*M*G*r^4 + M^2*G^2) = 0 := by
  have key : (1 : ℝ) * (theta_dot^2*cos_theta*C*M*G*r^5 - theta_dot^2*M*G*r^4 + M^2*G^2*r) = 0 := by linear_combination (-M*G) * h1
  have top : (theta_dot^2*cos_theta*C*M*G*r^5 - theta_dot^2*M*G*r^4 + M^2*G^2*r : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- r = \frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}\cdot \cos(\theta)}
-- theta_dot stands for \dot{\theta}
-- cos_theta stands for \cos(\theta)
-- C stands for C
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (theta_dot cos_theta C M G r : ℝ)
    (h1 : -theta_dot^2*cos_theta*C*r^5 + theta_dot^2*r^4 - M*G*r = 0)
    (hd : (1 : ℝ) ≠ 0) : (theta_dot^2*cos_theta*C*M*G*r^5 - theta_dot^2*M*G*r^4 + M^2*G^2*r : ℝ) / (theta_dot^2*cos_theta*C*M*G*r^4 + M^2*G^2) = 0 := by
  have key : (1 : ℝ) * (theta_dot^2*cos_theta*C*M*G*r^5 - theta_dot^2*M*G*r^4 + M^2*G^2*r) = 0 := by linear_combination (-M*G) * h1
  have top : (theta_dot^2*cos_theta*C*M*G*r^5 - theta_dot^2*M*G*r^4 + M^2*G^2*r : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
