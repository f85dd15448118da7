-- kepler / areal-velocity: The radius sweeps equal areas in equal times: Kepler's second law, for an orbit in the plane.
--
-- Given: the definitions, the assumptions and kepler.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- r^2\cdot \dot{\varphi} = {\bf L}_3
-- root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2}
-- r2_dot stands for \dot{\bf r}_2
-- r1_dot stands for \dot{\bf r}_1
-- r2 stands for {\bf r}_2
-- r1 stands for {\bf r}_1
theorem equation_1 (root r2_dot r1_dot r2 r1 : ℝ)
    (h1 : root^2 - r2^2 - r1^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-root^2*r1_dot*r2 + r1_dot*r2^3 + root^2*r2_dot*r1 - r2_dot*r2^2*r1 + r1_dot*r2*r1^2 - r2_dot*r1^3 : ℝ) / (r2^2 + r1^2) = 0 := by
  have key : (1 : ℝ) * (-root^2*r1_dot*r2 + r1_dot*r2^3 + root^2*r2_dot*r1 - r2_dot*r2^2*r1 + r1_dot*r2*r1^2 - r2_dot*r1^3) = 0 := by linear_combination (-r1_dot*r2 + r2_dot*r1) * h1
  have top : (-root^2*r1_dot*r2 + r1_dot*r2^3 + root^2*r2_dot*r1 - r2_dot*r2^2*r1 + r1_dot*r2*r1^2 - r2_dot*r1^3 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- 2\cdot r\cdot \dot{r}\cdot \dot{\varphi}+r^2\cdot \ddot{\varphi} = 0
-- root stands for \sqrt{{\bf r}_1\cdot {\bf r}_1+{\bf r}_2\cdot {\bf r}_2}
-- r2_dot stands for \dot{\bf r}_2
-- r1_dot stands for \dot{\bf r}_1
-- r2 stands for {\bf r}_2
-- r1 stands for {\bf r}_1
theorem equation_2 (root r2_dot r1_dot r2 r1 : ℝ)
    (h1 : root^2 - r2^2 - r1^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (4*root^6*r2_dot*r1_dot*r2^4 - 4*root^4*r2_dot*r1_dot*r2^6 - 4*root^6*r2_dot^2*r2^3*r1 + 4*root^6*r1_dot^2*r2^3*r1 + 4*root^4*r2_dot^2*r2^5*r1 - 4*root^4*r1_dot^2*r2^5*r1 - 4*root^4*r2_dot*r1_dot*r2^4*r1^2 - 4*root^6*r2_dot^2*r2*r1^3 + 4*root^6*r1_dot^2*r2*r1^3 + 8*root^4*r2_dot^2*r2^3*r1^3 - 8*root^4*r1_dot^2*r2^3*r1^3 - 4*root^6*r2_dot*r1_dot*r1^4 + 4*root^4*r2_dot*r1_dot*r2^2*r1^4 + 4*root^4*r2_dot^2*r2*r1^5 - 4*root^4*r1_dot^2*r2*r1^5 + 4*root^4*r2_dot*r1_dot*r1^6 : ℝ) / (2*root^4*r2^6 + 6*root^4*r2^4*r1^2 + 6*root^4*r2^2*r1^4 + 2*root^4*r1^6) = 0 := by
  have key : (1 : ℝ) * (4*root^6*r2_dot*r1_dot*r2^4 - 4*root^4*r2_dot*r1_dot*r2^6 - 4*root^6*r2_dot^2*r2^3*r1 + 4*root^6*r1_dot^2*r2^3*r1 + 4*root^4*r2_dot^2*r2^5*r1 - 4*root^4*r1_dot^2*r2^5*r1 - 4*root^4*r2_dot*r1_dot*r2^4*r1^2 - 4*root^6*r2_dot^2*r2*r1^3 + 4*root^6*r1_dot^2*r2*r1^3 + 8*root^4*r2_dot^2*r2^3*r1^3 - 8*root^4*r1_dot^2*r2^3*r1^3 - 4*root^6*r2_dot*r1_dot*r1^4 + 4*root^4*r2_dot*r1_dot*r2^2*r1^4 + 4*root^4*r2_dot^2*r2*r1^5 - 4*root^4*r1_dot^2*r2*r1^5 + 4*root^4*r2_dot*r1_dot*r1^6) = 0 := by linear_combination (4*root^4*r2_dot*r1_dot*r2^4 - 4*root^4*r2_dot^2*r2^3*r1 + 4*root^4*r1_dot^2*r2^3*r1 - 4*root^4*r2_dot^2*r2*r1^3 + 4*root^4*r1_dot^2*r2*r1^3 - 4*root^4*r2_dot*r1_dot*r1^4) * h1
  have top : (4*root^6*r2_dot*r1_dot*r2^4 - 4*root^4*r2_dot*r1_dot*r2^6 - 4*root^6*r2_dot^2*r2^3*r1 + 4*root^6*r1_dot^2*r2^3*r1 + 4*root^4*r2_dot^2*r2^5*r1 - 4*root^4*r1_dot^2*r2^5*r1 - 4*root^4*r2_dot*r1_dot*r2^4*r1^2 - 4*root^6*r2_dot^2*r2*r1^3 + 4*root^6*r1_dot^2*r2*r1^3 + 8*root^4*r2_dot^2*r2^3*r1^3 - 8*root^4*r1_dot^2*r2^3*r1^3 - 4*root^6*r2_dot*r1_dot*r1^4 + 4*root^4*r2_dot*r1_dot*r2^2*r1^4 + 4*root^4*r2_dot^2*r2*r1^5 - 4*root^4*r1_dot^2*r2*r1^5 + 4*root^4*r2_dot*r1_dot*r1^6 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
