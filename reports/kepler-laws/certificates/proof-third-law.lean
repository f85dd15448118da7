-- kepler-laws / third-law: The square of the period is as the cube of the axis.
--
-- Given: the definitions, the assumptions and newton.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 120 operations) = \frac{4\cdot (\pi)^{2}\cdot (\frac{\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1+\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}+\frac{\frac{(r^2\cdot \dot{\theta})^{2}}{G\cdot M}}{1-\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M}}}{2})^{3}}{G\cdot M}
-- root stands for \sqrt{1-(\frac{C\cdot (r^2\cdot \dot{\theta})^{2}}{G\cdot M})^{2}}
-- theta_dot stands for \dot{\theta}
-- f stands for \pi
-- C stands for C
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (root theta_dot f C M G r : ℝ)
    (h1 : theta_dot^4*C^2*r^8 + root^2*M^2*G^2 - M^2*G^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-512*theta_dot^24*f^2*C^8*M^17*G^17*r^48 - 512*root^2*theta_dot^20*f^2*C^6*M^19*G^19*r^40 + 2048*theta_dot^20*f^2*C^6*M^19*G^19*r^40 + 1536*root^2*theta_dot^16*f^2*C^4*M^21*G^21*r^32 - 3072*theta_dot^16*f^2*C^4*M^21*G^21*r^32 - 1536*root^2*theta_dot^12*f^2*C^2*M^23*G^23*r^24 + 2048*theta_dot^12*f^2*C^2*M^23*G^23*r^24 + 512*root^2*theta_dot^8*f^2*M^25*G^25*r^16 - 512*theta_dot^8*f^2*M^25*G^25*r^16 : ℝ) / (-128*theta_dot^30*C^14*M^15*G^15*r^60 + 896*theta_dot^26*C^12*M^17*G^17*r^52 - 2688*theta_dot^22*C^10*M^19*G^19*r^44 + 4480*theta_dot^18*C^8*M^21*G^21*r^36 - 4480*theta_dot^14*C^6*M^23*G^23*r^28 + 2688*theta_dot^10*C^4*M^25*G^25*r^20 - 896*theta_dot^6*C^2*M^27*G^27*r^12 + 128*theta_dot^2*M^29*G^29*r^4) = 0 := by
  have key : (1 : ℝ) * (-512*theta_dot^24*f^2*C^8*M^17*G^17*r^48 - 512*root^2*theta_dot^20*f^2*C^6*M^19*G^19*r^40 + 2048*theta_dot^20*f^2*C^6*M^19*G^19*r^40 + 1536*root^2*theta_dot^16*f^2*C^4*M^21*G^21*r^32 - 3072*theta_dot^16*f^2*C^4*M^21*G^21*r^32 - 1536*root^2*theta_dot^12*f^2*C^2*M^23*G^23*r^24 + 2048*theta_dot^12*f^2*C^2*M^23*G^23*r^24 + 512*root^2*theta_dot^8*f^2*M^25*G^25*r^16 - 512*theta_dot^8*f^2*M^25*G^25*r^16) = 0 := by linear_combination (-512*theta_dot^20*f^2*C^6*M^17*G^17*r^40 + 1536*theta_dot^16*f^2*C^4*M^19*G^19*r^32 - 1536*theta_dot^12*f^2*C^2*M^21*G^21*r^24 + 512*theta_dot^8*f^2*M^23*G^23*r^16) * h1
  have top : (-512*theta_dot^24*f^2*C^8*M^17*G^17*r^48 - 512*root^2*theta_dot^20*f^2*C^6*M^19*G^19*r^40 + 2048*theta_dot^20*f^2*C^6*M^19*G^19*r^40 + 1536*root^2*theta_dot^16*f^2*C^4*M^21*G^21*r^32 - 3072*theta_dot^16*f^2*C^4*M^21*G^21*r^32 - 1536*root^2*theta_dot^12*f^2*C^2*M^23*G^23*r^24 + 2048*theta_dot^12*f^2*C^2*M^23*G^23*r^24 + 512*root^2*theta_dot^8*f^2*M^25*G^25*r^16 - 512*theta_dot^8*f^2*M^25*G^25*r^16 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
