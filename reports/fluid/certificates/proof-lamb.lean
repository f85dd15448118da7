-- fluid / lamb: The acceleration in the form of Lamb.
--
-- Given: the definitions and assumptions.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- {\bf v}_1(x,y,z,t)\cdot \frac{\partial {\bf v}_1(x,y,z,t)}{\partial x}+{\bf v}_2(x,y,z,t)\cdot \frac{\partial {\bf v}_1(x,y,z,t)}{\partial y}+{\bf v}_3(x,y,z,t)\cdot \frac{\partial {\bf v}_1(x,y,z,t)}{\partial z} = (an expression of 37 operations)
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (vxyzt3_dz vxyzt2_dz vxyzt1_dz vxyzt3_dy vxyzt2_dy vxyzt1_dy vxyzt3_dx vxyzt2_dx vxyzt1_dx vxyzt3 vxyzt2 vxyzt1 : ℝ) (hD : (2 : ℝ) ≠ 0) : (vxyzt1*vxyzt1_dx + vxyzt2*vxyzt1_dy + vxyzt3*vxyzt1_dz : ℝ) - (1/2*(vxyzt1*vxyzt1_dx + vxyzt1*vxyzt1_dx + (vxyzt2_dx*vxyzt2 + vxyzt2_dx*vxyzt2) + (vxyzt3_dx*vxyzt3 + vxyzt3_dx*vxyzt3)) - (vxyzt2*(vxyzt2_dx - vxyzt1_dy) - vxyzt3*(vxyzt1_dz - vxyzt3_dx))) = (0) / (2) := by
  field_simp
  ring

-- {\bf v}_1(x,y,z,t)\cdot \frac{\partial {\bf v}_2(x,y,z,t)}{\partial x}+{\bf v}_2(x,y,z,t)\cdot \frac{\partial {\bf v}_2(x,y,z,t)}{\partial y}+{\bf v}_3(x,y,z,t)\cdot \frac{\partial {\bf v}_2(x,y,z,t)}{\partial z} = (an expression of 37 operations)
theorem equation_2
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (vxyzt3_dz vxyzt2_dz vxyzt1_dz vxyzt3_dy vxyzt2_dy vxyzt1_dy vxyzt3_dx vxyzt2_dx vxyzt1_dx vxyzt3 vxyzt2 vxyzt1 : ℝ) (hD : (2 : ℝ) ≠ 0) : (vxyzt1*vxyzt2_dx + vxyzt2*vxyzt2_dy + vxyzt3*vxyzt2_dz : ℝ) - (1/2*(vxyzt1_dy*vxyzt1 + vxyzt1_dy*vxyzt1 + (vxyzt2*vxyzt2_dy + vxyzt2*vxyzt2_dy) + (vxyzt3_dy*vxyzt3 + vxyzt3_dy*vxyzt3)) - (vxyzt3*(vxyzt3_dy - vxyzt2_dz) - vxyzt1*(vxyzt2_dx - vxyzt1_dy))) = (0) / (2) := by
  field_simp
  ring

-- {\bf v}_1(x,y,z,t)\cdot \frac{\partial {\bf v}_3(x,y,z,t)}{\partial x}+{\bf v}_2(x,y,z,t)\cdot \frac{\partial {\bf v}_3(x,y,z,t)}{\partial y}+{\bf v}_3(x,y,z,t)\cdot \frac{\partial {\bf v}_3(x,y,z,t)}{\partial z} = (an expression of 37 operations)
theorem equation_3
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (vxyzt3_dz vxyzt2_dz vxyzt1_dz vxyzt3_dy vxyzt2_dy vxyzt1_dy vxyzt3_dx vxyzt2_dx vxyzt1_dx vxyzt3 vxyzt2 vxyzt1 : ℝ) (hD : (2 : ℝ) ≠ 0) : (vxyzt1*vxyzt3_dx + vxyzt2*vxyzt3_dy + vxyzt3*vxyzt3_dz : ℝ) - (1/2*(vxyzt1_dz*vxyzt1 + vxyzt1_dz*vxyzt1 + (vxyzt2_dz*vxyzt2 + vxyzt2_dz*vxyzt2) + (vxyzt3*vxyzt3_dz + vxyzt3*vxyzt3_dz)) - (vxyzt1*(vxyzt1_dz - vxyzt3_dx) - vxyzt2*(vxyzt3_dy - vxyzt2_dz))) = (0) / (2) := by
  field_simp
  ring
