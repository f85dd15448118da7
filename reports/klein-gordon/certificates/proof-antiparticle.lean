-- klein-gordon / antiparticle: The conjugate of a solution is a solution.
--
-- Given: the definitions, the assumptions and klein-gordon.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{-\operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial t^2})}{c\cdot c}-(-\operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial x^2})+(-\operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial y^2}))+(-\operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial z^2})))+(\frac{m\cdot c}{\hbar})^{2}\cdot (-\operatorname{Im}(\phi(x,y,z,t))) = 0
-- phixyzt2_dt2 stands for \operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial t^2})
-- phixyzt2_dz2 stands for \operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial z^2})
-- phixyzt2_dy2 stands for \operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial y^2})
-- phixyzt2_dx2 stands for \operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial x^2})
-- phixyzt2 stands for \operatorname{Im}(\phi(x,y,z,t))
-- hbar stands for \hbar
-- c stands for c
-- m stands for m
theorem equation_1 (phixyzt2_dt2 phixyzt2_dz2 phixyzt2_dy2 phixyzt2_dx2 phixyzt2 hbar c m : ℝ)
    (h1 : phixyzt2*c^4*m^2 - phixyzt2_dz2*hbar^2*c^2 - phixyzt2_dy2*hbar^2*c^2 - phixyzt2_dx2*hbar^2*c^2 + phixyzt2_dt2*hbar^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-phixyzt2*c^4*m^2 + phixyzt2_dz2*hbar^2*c^2 + phixyzt2_dy2*hbar^2*c^2 + phixyzt2_dx2*hbar^2*c^2 - phixyzt2_dt2*hbar^2 : ℝ) / (hbar^2*c^2) = 0 := by
  have key : (1 : ℝ) * (-phixyzt2*c^4*m^2 + phixyzt2_dz2*hbar^2*c^2 + phixyzt2_dy2*hbar^2*c^2 + phixyzt2_dx2*hbar^2*c^2 - phixyzt2_dt2*hbar^2) = 0 := by linear_combination (-1) * h1
  have top : (-phixyzt2*c^4*m^2 + phixyzt2_dz2*hbar^2*c^2 + phixyzt2_dy2*hbar^2*c^2 + phixyzt2_dx2*hbar^2*c^2 - phixyzt2_dt2*hbar^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (phixyzt2_dt2 phixyzt1_dt2 phixyzt2_dz2 phixyzt1_dz2 phixyzt2_dy2 phixyzt1_dy2 phixyzt2_dx2 phixyzt1_dx2 phixyzt2 phixyzt1 hbar c m : ℝ) (hD : (hbar^2*c^2 : ℝ) ≠ 0) : ((-phixyzt2_dt2)/(c*c) - (-phixyzt2_dx2 + (-phixyzt2_dy2) + (-phixyzt2_dz2)) + (m*c/hbar)^2*(-phixyzt2) : ℝ) - (0) = (-phixyzt2*c^4*m^2 + phixyzt2_dz2*hbar^2*c^2 + phixyzt2_dy2*hbar^2*c^2 + phixyzt2_dx2*hbar^2*c^2 - phixyzt2_dt2*hbar^2) / (hbar^2*c^2) := by
  field_simp
  ring
