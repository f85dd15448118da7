-- kepler / eccentricity-and-energy: The length of the Laplace–Runge–Lenz vector follows from energy and angular momentum.
--
-- Given: the definitions, the assumptions and kepler.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- {\bf A}_1\cdot {\bf A}_1+{\bf A}_2\cdot {\bf A}_2+{\bf A}_3\cdot {\bf A}_3 = \mu^2+(2\cdot h\cdot {\bf L}_1\cdot {\bf L}_1+2\cdot h\cdot {\bf L}_2\cdot {\bf L}_2+2\cdot h\cdot {\bf L}_3\cdot {\bf L}_3)
-- root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
-- mu stands for \mu
-- r3 stands for {\bf r}_3
-- r2 stands for {\bf r}_2
-- r1 stands for {\bf r}_1
theorem equation_1 (root mu r3 r2 r1 : ℝ)
    (h1 : root^2 - r3^2 - r2^2 - r1^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-2*root^3*mu^2 + 2*root*mu^2*r3^2 + 2*root*mu^2*r2^2 + 2*root*mu^2*r1^2 : ℝ) / (2*root^3) = 0 := by
  have key : (1 : ℝ) * (-2*root^3*mu^2 + 2*root*mu^2*r3^2 + 2*root*mu^2*r2^2 + 2*root*mu^2*r1^2) = 0 := by linear_combination (-2*root*mu^2) * h1
  have top : (-2*root^3*mu^2 + 2*root*mu^2*r3^2 + 2*root*mu^2*r2^2 + 2*root*mu^2*r1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
