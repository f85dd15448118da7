-- kepler / radial-equation: The distance obeys an equation of its own, with the centrifugal term.
--
-- Given: the definitions, the assumptions and kepler.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \ddot{r} = \frac{{\bf L}_1\cdot {\bf L}_1+{\bf L}_2\cdot {\bf L}_2+{\bf L}_3\cdot {\bf L}_3}{r^3}-\frac{\mu}{r^2}
-- root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
-- r3_dot stands for \dot{\bf r}_3
-- r2_dot stands for \dot{\bf r}_2
-- r1_dot stands for \dot{\bf r}_1
-- mu stands for \mu
-- r3 stands for {\bf r}_3
-- r2 stands for {\bf r}_2
-- r1 stands for {\bf r}_1
theorem equation_1 (root r3_dot r2_dot r1_dot mu r3 r2 r1 : ℝ)
    (h1 : root^2 - r3^2 - r2^2 - r1^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (8*root^10*r3_dot^2 + 8*root^10*r2_dot^2 + 8*root^10*r1_dot^2 - 8*root^8*r3_dot^2*r3^2 - 8*root^8*r2_dot^2*r3^2 - 8*root^8*r1_dot^2*r3^2 - 8*root^8*r3_dot^2*r2^2 - 8*root^8*r2_dot^2*r2^2 - 8*root^8*r1_dot^2*r2^2 - 8*root^8*r3_dot^2*r1^2 - 8*root^8*r2_dot^2*r1^2 - 8*root^8*r1_dot^2*r1^2 + 8*root^9*mu - 8*root^7*mu*r3^2 - 8*root^7*mu*r2^2 - 8*root^7*mu*r1^2 : ℝ) / (8*root^11) = 0 := by
  have key : (1 : ℝ) * (8*root^10*r3_dot^2 + 8*root^10*r2_dot^2 + 8*root^10*r1_dot^2 - 8*root^8*r3_dot^2*r3^2 - 8*root^8*r2_dot^2*r3^2 - 8*root^8*r1_dot^2*r3^2 - 8*root^8*r3_dot^2*r2^2 - 8*root^8*r2_dot^2*r2^2 - 8*root^8*r1_dot^2*r2^2 - 8*root^8*r3_dot^2*r1^2 - 8*root^8*r2_dot^2*r1^2 - 8*root^8*r1_dot^2*r1^2 + 8*root^9*mu - 8*root^7*mu*r3^2 - 8*root^7*mu*r2^2 - 8*root^7*mu*r1^2) = 0 := by linear_combination (8*root^8*r3_dot^2 + 8*root^8*r2_dot^2 + 8*root^8*r1_dot^2 + 8*root^7*mu) * h1
  have top : (8*root^10*r3_dot^2 + 8*root^10*r2_dot^2 + 8*root^10*r1_dot^2 - 8*root^8*r3_dot^2*r3^2 - 8*root^8*r2_dot^2*r3^2 - 8*root^8*r1_dot^2*r3^2 - 8*root^8*r3_dot^2*r2^2 - 8*root^8*r2_dot^2*r2^2 - 8*root^8*r1_dot^2*r2^2 - 8*root^8*r3_dot^2*r1^2 - 8*root^8*r2_dot^2*r1^2 - 8*root^8*r1_dot^2*r1^2 + 8*root^9*mu - 8*root^7*mu*r3^2 - 8*root^7*mu*r2^2 - 8*root^7*mu*r1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
