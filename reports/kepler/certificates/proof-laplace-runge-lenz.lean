-- kepler / laplace-runge-lenz: The Laplace–Runge–Lenz vector does not change, and lies in the plane of the orbit.
--
-- Given: the definitions, the assumptions and kepler.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{\bf A}_1 = 0
-- root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
-- r1_dot stands for \dot{\bf r}_1
-- mu stands for \mu
-- r3 stands for {\bf r}_3
-- r2 stands for {\bf r}_2
-- r1 stands for {\bf r}_1
theorem equation_2 (root r1_dot mu r3 r2 r1 : ℝ)
    (h1 : root^2 - r3^2 - r2^2 - r1^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-2*root^6*r1_dot*mu + 2*root^4*r1_dot*mu*r3^2 + 2*root^4*r1_dot*mu*r2^2 + 2*root^4*r1_dot*mu*r1^2 : ℝ) / (2*root^7) = 0 := by
  have key : (1 : ℝ) * (-2*root^6*r1_dot*mu + 2*root^4*r1_dot*mu*r3^2 + 2*root^4*r1_dot*mu*r2^2 + 2*root^4*r1_dot*mu*r1^2) = 0 := by linear_combination (-2*root^4*r1_dot*mu) * h1
  have top : (-2*root^6*r1_dot*mu + 2*root^4*r1_dot*mu*r3^2 + 2*root^4*r1_dot*mu*r2^2 + 2*root^4*r1_dot*mu*r1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\bf A}_2 = 0
-- root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
-- r2_dot stands for \dot{\bf r}_2
-- mu stands for \mu
-- r3 stands for {\bf r}_3
-- r2 stands for {\bf r}_2
-- r1 stands for {\bf r}_1
theorem equation_3 (root r2_dot mu r3 r2 r1 : ℝ)
    (h1 : root^2 - r3^2 - r2^2 - r1^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-2*root^6*r2_dot*mu + 2*root^4*r2_dot*mu*r3^2 + 2*root^4*r2_dot*mu*r2^2 + 2*root^4*r2_dot*mu*r1^2 : ℝ) / (2*root^7) = 0 := by
  have key : (1 : ℝ) * (-2*root^6*r2_dot*mu + 2*root^4*r2_dot*mu*r3^2 + 2*root^4*r2_dot*mu*r2^2 + 2*root^4*r2_dot*mu*r1^2) = 0 := by linear_combination (-2*root^4*r2_dot*mu) * h1
  have top : (-2*root^6*r2_dot*mu + 2*root^4*r2_dot*mu*r3^2 + 2*root^4*r2_dot*mu*r2^2 + 2*root^4*r2_dot*mu*r1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \dot{\bf A}_3 = 0
-- root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2+{\bf r}_3\cdot {\bf r}_3}
-- r3_dot stands for \dot{\bf r}_3
-- mu stands for \mu
-- r3 stands for {\bf r}_3
-- r2 stands for {\bf r}_2
-- r1 stands for {\bf r}_1
theorem equation_4 (root r3_dot mu r3 r2 r1 : ℝ)
    (h1 : root^2 - r3^2 - r2^2 - r1^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-2*root^6*r3_dot*mu + 2*root^4*r3_dot*mu*r3^2 + 2*root^4*r3_dot*mu*r2^2 + 2*root^4*r3_dot*mu*r1^2 : ℝ) / (2*root^7) = 0 := by
  have key : (1 : ℝ) * (-2*root^6*r3_dot*mu + 2*root^4*r3_dot*mu*r3^2 + 2*root^4*r3_dot*mu*r2^2 + 2*root^4*r3_dot*mu*r1^2) = 0 := by linear_combination (-2*root^4*r3_dot*mu) * h1
  have top : (-2*root^6*r3_dot*mu + 2*root^4*r3_dot*mu*r3^2 + 2*root^4*r3_dot*mu*r2^2 + 2*root^4*r3_dot*mu*r1^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
