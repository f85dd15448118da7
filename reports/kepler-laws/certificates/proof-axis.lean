-- kepler-laws / axis: The semi-major axis, and the angular momentum by it.
--
-- Given: the definitions, the assumptions and newton.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}+\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1-\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}}{2} = \frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1-(\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M})^{2}}
-- theta_dot stands for \dot{\theta}
-- C stands for C
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (theta_dot C M G r : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2*theta_dot^8*C^4*M^3*G^3*r^16 - 4*theta_dot^4*C^2*M^5*G^5*r^8 + 2*M^7*G^7) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (r_ddot theta_ddot r_dot theta_dot sin_theta cos_theta C M G r theta : ℝ) (hD : (2*theta_dot^8*C^4*M^3*G^3*r^16 - 4*theta_dot^4*C^2*M^5*G^5*r^8 + 2*M^7*G^7 : ℝ) ≠ 0) : (((r^2*theta_dot)^2/(G*M)/(1 + C*(r^2*theta_dot)^2/(G*M)) + (r^2*theta_dot)^2/(G*M)/(1 - C*(r^2*theta_dot)^2/(G*M)))/2 : ℝ) - ((r^2*theta_dot)^2/(G*M)/(1 - (C*(r^2*theta_dot)^2/(G*M))^2)) = (0) / (2*theta_dot^8*C^4*M^3*G^3*r^16 - 4*theta_dot^4*C^2*M^5*G^5*r^8 + 2*M^7*G^7) := by
  field_simp
  ring

-- (r^2\cdot \dot{\theta})^{2} = G\cdot M\cdot \frac{\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}+\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1-\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}}{2}\cdot (1-(\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M})^{2})
-- theta_dot stands for \dot{\theta}
-- C stands for C
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (theta_dot C M G r : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (-2*theta_dot^4*C^2*M^4*G^4*r^8 + 2*M^6*G^6) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (r_ddot theta_ddot r_dot theta_dot sin_theta cos_theta C M G r theta : ℝ) (hD : (-2*theta_dot^4*C^2*M^4*G^4*r^8 + 2*M^6*G^6 : ℝ) ≠ 0) : ((r^2*theta_dot)^2 : ℝ) - (G*M*(((r^2*theta_dot)^2/(G*M)/(1 + C*(r^2*theta_dot)^2/(G*M)) + (r^2*theta_dot)^2/(G*M)/(1 - C*(r^2*theta_dot)^2/(G*M)))/2)*(1 - (C*(r^2*theta_dot)^2/(G*M))^2)) = (0) / (-2*theta_dot^4*C^2*M^4*G^4*r^8 + 2*M^6*G^6) := by
  field_simp
  ring
