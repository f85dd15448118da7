-- kepler-laws / first-law: The orbit is an ellipse with the sun in a focus: the first law.
--
-- Given: the definitions, the assumptions and conic, axis.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- r = \frac{\frac{\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}+\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1-\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}}{2}\cdot (1-(\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M})^{2})}{1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}\cdot \cos(\theta)}
-- theta_dot stands for \dot{\theta}
-- cos_theta stands for \cos(\theta)
-- C stands for C
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (theta_dot cos_theta C M G r : ℝ)
    (h1 : -theta_dot^2*cos_theta*C*M*G*r^5 + theta_dot^2*M*G*r^4 - M^2*G^2*r = 0)
    (hd : (1 : ℝ) ≠ 0) : (-2*theta_dot^6*cos_theta*C^3*M^4*G^4*r^13 + 2*theta_dot^6*C^2*M^4*G^4*r^12 - 2*theta_dot^4*C^2*M^5*G^5*r^9 + 2*theta_dot^2*cos_theta*C*M^6*G^6*r^5 - 2*theta_dot^2*M^6*G^6*r^4 + 2*M^7*G^7*r : ℝ) / (-2*theta_dot^6*cos_theta*C^3*M^4*G^4*r^12 - 2*theta_dot^4*C^2*M^5*G^5*r^8 + 2*theta_dot^2*cos_theta*C*M^6*G^6*r^4 + 2*M^7*G^7) = 0 := by
  have key : (1 : ℝ) * (-2*theta_dot^6*cos_theta*C^3*M^4*G^4*r^13 + 2*theta_dot^6*C^2*M^4*G^4*r^12 - 2*theta_dot^4*C^2*M^5*G^5*r^9 + 2*theta_dot^2*cos_theta*C*M^6*G^6*r^5 - 2*theta_dot^2*M^6*G^6*r^4 + 2*M^7*G^7*r) = 0 := by linear_combination (2*theta_dot^4*C^2*M^3*G^3*r^8 - 2*M^5*G^5) * h1
  have top : (-2*theta_dot^6*cos_theta*C^3*M^4*G^4*r^13 + 2*theta_dot^6*C^2*M^4*G^4*r^12 - 2*theta_dot^4*C^2*M^5*G^5*r^9 + 2*theta_dot^2*cos_theta*C*M^6*G^6*r^5 - 2*theta_dot^2*M^6*G^6*r^4 + 2*M^7*G^7*r : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
