-- kepler-laws / period: The period: the area of the ellipse by the areal velocity.
--
-- Given: the definitions, the assumptions and newton.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 119 operations) = \frac{\pi\cdot (\frac{\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}+\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1-\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}}{2})^{2}\cdot \sqrt{1-(\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M})^{2}}}{\frac{r^2\cdot \dot{\theta}}{2}}
-- theta_dot stands for \dot{\theta}
-- C stands for C
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (theta_dot C M G r : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4*theta_dot^9*C^4*M^4*G^4*r^18 - 8*theta_dot^5*C^2*M^6*G^6*r^10 + 4*theta_dot*M^8*G^8*r^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- (an expression of 119 operations) = \frac{2\cdot \pi\cdot (\frac{\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}+\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1-\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}}{2})^{2}\cdot \sqrt{1-(\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M})^{2}}}{r^2\cdot \dot{\theta}}
-- theta_dot stands for \dot{\theta}
-- C stands for C
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (theta_dot C M G r : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (4*theta_dot^9*C^4*M^4*G^4*r^18 - 8*theta_dot^5*C^2*M^6*G^6*r^10 + 4*theta_dot*M^8*G^8*r^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
