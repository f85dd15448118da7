-- klein-gordon / energy: What a place loses of energy flows out.
--
-- Given: the definitions, the assumptions and klein-gordon.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 154 operations) = 0
-- phixyzt2_dt2 stands for \operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial t^2})
-- phixyzt1_dt2 stands for \operatorname{Re}(\frac{\partial^2 \phi(x,y,z,t)}{\partial t^2})
-- phixyzt2_dz2 stands for \operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial z^2})
-- phixyzt1_dz2 stands for \operatorname{Re}(\frac{\partial^2 \phi(x,y,z,t)}{\partial z^2})
-- phixyzt2_dy2 stands for \operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial y^2})
-- phixyzt1_dy2 stands for \operatorname{Re}(\frac{\partial^2 \phi(x,y,z,t)}{\partial y^2})
-- phixyzt2_dx2 stands for \operatorname{Im}(\frac{\partial^2 \phi(x,y,z,t)}{\partial x^2})
-- phixyzt1_dx2 stands for \operatorname{Re}(\frac{\partial^2 \phi(x,y,z,t)}{\partial x^2})
-- phixyzt2_dt stands for \operatorname{Im}(\frac{\partial \phi(x,y,z,t)}{\partial t})
-- phixyzt1_dt stands for \operatorname{Re}(\frac{\partial \phi(x,y,z,t)}{\partial t})
-- phixyzt2 stands for \operatorname{Im}(\phi(x,y,z,t))
-- phixyzt1 stands for \operatorname{Re}(\phi(x,y,z,t))
-- hbar stands for \hbar
-- c stands for c
-- m stands for m
theorem equation_1 (phixyzt2_dt2 phixyzt1_dt2 phixyzt2_dz2 phixyzt1_dz2 phixyzt2_dy2 phixyzt1_dy2 phixyzt2_dx2 phixyzt1_dx2 phixyzt2_dt phixyzt1_dt phixyzt2 phixyzt1 hbar c m : ℝ)
    (h1 : phixyzt1*c^4*m^2 - phixyzt1_dz2*hbar^2*c^2 - phixyzt1_dy2*hbar^2*c^2 - phixyzt1_dx2*hbar^2*c^2 + phixyzt1_dt2*hbar^2 = 0)
    (h2 : phixyzt2*c^4*m^2 - phixyzt2_dz2*hbar^2*c^2 - phixyzt2_dy2*hbar^2*c^2 - phixyzt2_dx2*hbar^2*c^2 + phixyzt2_dt2*hbar^2 = 0)
    (hd : (1 : ℝ) ≠ 0) : (2*phixyzt2_dt*phixyzt2*c^4*m^2 + 2*phixyzt1_dt*phixyzt1*c^4*m^2 - 2*phixyzt2_dz2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt2_dy2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt2_dx2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt1_dz2*phixyzt1_dt*hbar^2*c^2 - 2*phixyzt1_dy2*phixyzt1_dt*hbar^2*c^2 - 2*phixyzt1_dx2*phixyzt1_dt*hbar^2*c^2 + 2*phixyzt2_dt2*phixyzt2_dt*hbar^2 + 2*phixyzt1_dt2*phixyzt1_dt*hbar^2 : ℝ) / (hbar^2*c^2) = 0 := by
  have key : (1 : ℝ) * (2*phixyzt2_dt*phixyzt2*c^4*m^2 + 2*phixyzt1_dt*phixyzt1*c^4*m^2 - 2*phixyzt2_dz2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt2_dy2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt2_dx2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt1_dz2*phixyzt1_dt*hbar^2*c^2 - 2*phixyzt1_dy2*phixyzt1_dt*hbar^2*c^2 - 2*phixyzt1_dx2*phixyzt1_dt*hbar^2*c^2 + 2*phixyzt2_dt2*phixyzt2_dt*hbar^2 + 2*phixyzt1_dt2*phixyzt1_dt*hbar^2) = 0 := by linear_combination (2*phixyzt1_dt) * h1 + (2*phixyzt2_dt) * h2
  have top : (2*phixyzt2_dt*phixyzt2*c^4*m^2 + 2*phixyzt1_dt*phixyzt1*c^4*m^2 - 2*phixyzt2_dz2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt2_dy2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt2_dx2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt1_dz2*phixyzt1_dt*hbar^2*c^2 - 2*phixyzt1_dy2*phixyzt1_dt*hbar^2*c^2 - 2*phixyzt1_dx2*phixyzt1_dt*hbar^2*c^2 + 2*phixyzt2_dt2*phixyzt2_dt*hbar^2 + 2*phixyzt1_dt2*phixyzt1_dt*hbar^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (phixyzt2_dz_dt phixyzt1_dz_dt phixyzt2_dy_dt phixyzt1_dy_dt phixyzt2_dx_dt phixyzt1_dx_dt phixyzt2_dt2 phixyzt1_dt2 phixyzt2_dz2 phixyzt1_dz2 phixyzt2_dy2 phixyzt1_dy2 phixyzt2_dx2 phixyzt1_dx2 phixyzt2_dz phixyzt1_dz phixyzt2_dy phixyzt1_dy phixyzt2_dx phixyzt1_dx phixyzt2_dt phixyzt1_dt phixyzt2 phixyzt1 hbar c m : ℝ) (hD : (hbar^2*c^2 : ℝ) ≠ 0) : (1/c^2*(phixyzt1_dt2*phixyzt1_dt + phixyzt1_dt2*phixyzt1_dt + (phixyzt2_dt2*phixyzt2_dt + phixyzt2_dt2*phixyzt2_dt)) + (phixyzt1_dx_dt*phixyzt1_dx + phixyzt1_dx_dt*phixyzt1_dx + (phixyzt2_dx_dt*phixyzt2_dx + phixyzt2_dx_dt*phixyzt2_dx) + (phixyzt1_dy_dt*phixyzt1_dy + phixyzt1_dy_dt*phixyzt1_dy) + (phixyzt2_dy_dt*phixyzt2_dy + phixyzt2_dy_dt*phixyzt2_dy) + (phixyzt1_dz_dt*phixyzt1_dz + phixyzt1_dz_dt*phixyzt1_dz) + (phixyzt2_dz_dt*phixyzt2_dz + phixyzt2_dz_dt*phixyzt2_dz)) + (m*c/hbar)^2*(phixyzt1*phixyzt1_dt + phixyzt1*phixyzt1_dt + (phixyzt2_dt*phixyzt2 + phixyzt2_dt*phixyzt2)) + (-(2*(phixyzt1_dx_dt*phixyzt1_dx + phixyzt1_dt*phixyzt1_dx2 - ((-phixyzt2_dx_dt)*phixyzt2_dx + (-phixyzt2_dt)*phixyzt2_dx2))) + (-(2*(phixyzt1_dy_dt*phixyzt1_dy + phixyzt1_dt*phixyzt1_dy2 - ((-phixyzt2_dy_dt)*phixyzt2_dy + (-phixyzt2_dt)*phixyzt2_dy2)))) + (-(2*(phixyzt1_dz_dt*phixyzt1_dz + phixyzt1_dt*phixyzt1_dz2 - ((-phixyzt2_dz_dt)*phixyzt2_dz + (-phixyzt2_dt)*phixyzt2_dz2))))) : ℝ) - (0) = (2*phixyzt2_dt*phixyzt2*c^4*m^2 + 2*phixyzt1_dt*phixyzt1*c^4*m^2 - 2*phixyzt2_dz2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt2_dy2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt2_dx2*phixyzt2_dt*hbar^2*c^2 - 2*phixyzt1_dz2*phixyzt1_dt*hbar^2*c^2 - 2*phixyzt1_dy2*phixyzt1_dt*hbar^2*c^2 - 2*phixyzt1_dx2*phixyzt1_dt*hbar^2*c^2 + 2*phixyzt2_dt2*phixyzt2_dt*hbar^2 + 2*phixyzt1_dt2*phixyzt1_dt*hbar^2) / (hbar^2*c^2) := by
  field_simp
  ring
