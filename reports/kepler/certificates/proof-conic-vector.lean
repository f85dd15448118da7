-- kepler / conic-vector: The orbit is a conic section with the centre of force in a focus, in a form without angles.
--
-- Given: the definitions, the assumptions and laplace-runge-lenz.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- {\bf A}_1\cdot {\bf r}_1+{\bf A}_2\cdot {\bf r}_2+{\bf A}_3\cdot {\bf r}_3 = {\bf L}_1\cdot {\bf L}_1+{\bf L}_2\cdot {\bf L}_2+{\bf L}_3\cdot {\bf L}_3-\mu\cdot r
-- root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
-- mu stands for \mu
-- r3 stands for {\bf r}_3
-- r2 stands for {\bf r}_2
-- r1 stands for {\bf r}_1
theorem equation_1 (root mu r3 r2 r1 : ℝ)
    (h1 : root^2 - r3^2 - r2^2 - r1^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (root^2*mu - mu*r3^2 - mu*r2^2 - mu*r1^2 : ℝ) / (root) = 0 := by
  have key : (1 : ℝ) * (root^2*mu - mu*r3^2 - mu*r2^2 - mu*r1^2) = 0 := by linear_combination (mu) * h1
  have top : (root^2*mu - mu*r3^2 - mu*r2^2 - mu*r1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
