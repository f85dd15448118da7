-- deriglazov-comment / reduced-theta/given-the-relation: For motions that obey the relation between E and m.
--
-- Given: the definitions, the assumptions and t9-theta, psi-constant/given-the-product.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{\theta} = \frac{1}{2}\cdot {\bf m}_3\cdot (\frac{1}{I_1}-\frac{1}{I_2})\cdot \sin(2\cdot \psi(0))\cdot \sin(\theta)
-- I2 stands for I_2
-- I1 stands for I_1
theorem equation_1 (I2 I1 : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (2*I2^2*I1^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
