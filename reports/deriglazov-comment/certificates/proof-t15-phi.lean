-- deriglazov-comment / t15-phi: The closed form of φ, for motions that obey the relation between E and m.
--
-- Given: the definitions, the assumptions and reduced-phi, momentum.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \varphi(0) = \frac{{\bf m}_3(0)}{I_3}\cdot 0+\varphi(0)
-- I3 stands for I_3
theorem equation_1 (I3 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (I3) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (E_then varphi_then E m3_then t I3 I2 I1 : ℝ) (hD : (I3 : ℝ) ≠ 0) : (varphi_then : ℝ) - (m3_then/I3*0 + varphi_then) = (0) / (I3) := by
  field_simp
  ring
