-- maxwell / energy: Poynting's theorem: what flows out, and what the currents take, is lost by the fields.
--
-- Given: the definitions, the assumptions and charges.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- (an expression of 153 operations) = -({\bf j}_1(x,y,z,t)\cdot {\bf E}_1(x,y,z,t)+{\bf j}_2(x,y,z,t)\cdot {\bf E}_2(x,y,z,t)+{\bf j}_3(x,y,z,t)\cdot {\bf E}_3(x,y,z,t))
-- jxyzt3 stands for {\bf j}_3(x,y,z,t)
-- jxyzt2 stands for {\bf j}_2(x,y,z,t)
-- jxyzt1 stands for {\bf j}_1(x,y,z,t)
-- Exyzt3_dt stands for \frac{\partial {\bf E}_3(x,y,z,t)}{\partial t}
-- Exyzt2_dt stands for \frac{\partial {\bf E}_2(x,y,z,t)}{\partial t}
-- Exyzt1_dt stands for \frac{\partial {\bf E}_1(x,y,z,t)}{\partial t}
-- varepsilon stands for \varepsilon
-- mu stands for \mu
-- Bxyzt1_dy stands for \frac{\partial {\bf B}_1(x,y,z,t)}{\partial y}
-- Bxyzt2_dx stands for \frac{\partial {\bf B}_2(x,y,z,t)}{\partial x}
-- Bxyzt3_dx stands for \frac{\partial {\bf B}_3(x,y,z,t)}{\partial x}
-- Bxyzt1_dz stands for \frac{\partial {\bf B}_1(x,y,z,t)}{\partial z}
-- Bxyzt2_dz stands for \frac{\partial {\bf B}_2(x,y,z,t)}{\partial z}
-- Bxyzt3_dy stands for \frac{\partial {\bf B}_3(x,y,z,t)}{\partial y}
-- Bxyzt3_dt stands for \frac{\partial {\bf B}_3(x,y,z,t)}{\partial t}
-- Bxyzt2_dt stands for \frac{\partial {\bf B}_2(x,y,z,t)}{\partial t}
-- Bxyzt1_dt stands for \frac{\partial {\bf B}_1(x,y,z,t)}{\partial t}
-- Exyzt1_dy stands for \frac{\partial {\bf E}_1(x,y,z,t)}{\partial y}
-- Exyzt2_dx stands for \frac{\partial {\bf E}_2(x,y,z,t)}{\partial x}
-- Exyzt3_dx stands for \frac{\partial {\bf E}_3(x,y,z,t)}{\partial x}
-- Exyzt1_dz stands for \frac{\partial {\bf E}_1(x,y,z,t)}{\partial z}
-- Exyzt2_dz stands for \frac{\partial {\bf E}_2(x,y,z,t)}{\partial z}
-- Exyzt3_dy stands for \frac{\partial {\bf E}_3(x,y,z,t)}{\partial y}
-- Bxyzt3 stands for {\bf B}_3(x,y,z,t)
-- Bxyzt2 stands for {\bf B}_2(x,y,z,t)
-- Bxyzt1 stands for {\bf B}_1(x,y,z,t)
-- Exyzt3 stands for {\bf E}_3(x,y,z,t)
-- Exyzt2 stands for {\bf E}_2(x,y,z,t)
-- Exyzt1 stands for {\bf E}_1(x,y,z,t)
theorem equation_1 (jxyzt3 jxyzt2 jxyzt1 Exyzt3_dt Exyzt2_dt Exyzt1_dt varepsilon mu Bxyzt1_dy Bxyzt2_dx Bxyzt3_dx Bxyzt1_dz Bxyzt2_dz Bxyzt3_dy Bxyzt3_dt Bxyzt2_dt Bxyzt1_dt Exyzt1_dy Exyzt2_dx Exyzt3_dx Exyzt1_dz Exyzt2_dz Exyzt3_dy Bxyzt3 Bxyzt2 Bxyzt1 Exyzt3 Exyzt2 Exyzt1 : ℝ)
    (h1 : Bxyzt1_dt - Exyzt2_dz + Exyzt3_dy = 0)
    (h2 : Bxyzt2_dt - Exyzt3_dx + Exyzt1_dz = 0)
    (h3 : Bxyzt3_dt - Exyzt1_dy + Exyzt2_dx = 0)
    (h4 : -Exyzt1_dt*varepsilon*mu - jxyzt1*mu - Bxyzt2_dz + Bxyzt3_dy = 0)
    (h5 : -Exyzt2_dt*varepsilon*mu - jxyzt2*mu - Bxyzt3_dx + Bxyzt1_dz = 0)
    (h6 : -Exyzt3_dt*varepsilon*mu - jxyzt3*mu - Bxyzt1_dy + Bxyzt2_dx = 0)
    (hd : (1 : ℝ) ≠ 0) : (4*Exyzt3_dt*varepsilon*mu^2*Exyzt3 + 4*Exyzt2_dt*varepsilon*mu^2*Exyzt2 + 4*Exyzt1_dt*varepsilon*mu^2*Exyzt1 + 4*jxyzt3*mu^2*Exyzt3 + 4*jxyzt2*mu^2*Exyzt2 + 4*jxyzt1*mu^2*Exyzt1 + 4*mu*Bxyzt3_dt*Bxyzt3 - 4*mu*Exyzt1_dy*Bxyzt3 + 4*mu*Exyzt2_dx*Bxyzt3 + 4*mu*Bxyzt2_dt*Bxyzt2 - 4*mu*Exyzt3_dx*Bxyzt2 + 4*mu*Exyzt1_dz*Bxyzt2 + 4*mu*Bxyzt1_dt*Bxyzt1 - 4*mu*Exyzt2_dz*Bxyzt1 + 4*mu*Exyzt3_dy*Bxyzt1 + 4*mu*Bxyzt1_dy*Exyzt3 - 4*mu*Bxyzt2_dx*Exyzt3 + 4*mu*Bxyzt3_dx*Exyzt2 - 4*mu*Bxyzt1_dz*Exyzt2 + 4*mu*Bxyzt2_dz*Exyzt1 - 4*mu*Bxyzt3_dy*Exyzt1 : ℝ) / (4*mu^2) = 0 := by
  have key : (1 : ℝ) * (4*Exyzt3_dt*varepsilon*mu^2*Exyzt3 + 4*Exyzt2_dt*varepsilon*mu^2*Exyzt2 + 4*Exyzt1_dt*varepsilon*mu^2*Exyzt1 + 4*jxyzt3*mu^2*Exyzt3 + 4*jxyzt2*mu^2*Exyzt2 + 4*jxyzt1*mu^2*Exyzt1 + 4*mu*Bxyzt3_dt*Bxyzt3 - 4*mu*Exyzt1_dy*Bxyzt3 + 4*mu*Exyzt2_dx*Bxyzt3 + 4*mu*Bxyzt2_dt*Bxyzt2 - 4*mu*Exyzt3_dx*Bxyzt2 + 4*mu*Exyzt1_dz*Bxyzt2 + 4*mu*Bxyzt1_dt*Bxyzt1 - 4*mu*Exyzt2_dz*Bxyzt1 + 4*mu*Exyzt3_dy*Bxyzt1 + 4*mu*Bxyzt1_dy*Exyzt3 - 4*mu*Bxyzt2_dx*Exyzt3 + 4*mu*Bxyzt3_dx*Exyzt2 - 4*mu*Bxyzt1_dz*Exyzt2 + 4*mu*Bxyzt2_dz*Exyzt1 - 4*mu*Bxyzt3_dy*Exyzt1) = 0 := by linear_combination (4*mu*Bxyzt1) * h1 + (4*mu*Bxyzt2) * h2 + (4*mu*Bxyzt3) * h3 + (-4*mu*Exyzt1) * h4 + (-4*mu*Exyzt2) * h5 + (-4*mu*Exyzt3) * h6
  have top : (4*Exyzt3_dt*varepsilon*mu^2*Exyzt3 + 4*Exyzt2_dt*varepsilon*mu^2*Exyzt2 + 4*Exyzt1_dt*varepsilon*mu^2*Exyzt1 + 4*jxyzt3*mu^2*Exyzt3 + 4*jxyzt2*mu^2*Exyzt2 + 4*jxyzt1*mu^2*Exyzt1 + 4*mu*Bxyzt3_dt*Bxyzt3 - 4*mu*Exyzt1_dy*Bxyzt3 + 4*mu*Exyzt2_dx*Bxyzt3 + 4*mu*Bxyzt2_dt*Bxyzt2 - 4*mu*Exyzt3_dx*Bxyzt2 + 4*mu*Exyzt1_dz*Bxyzt2 + 4*mu*Bxyzt1_dt*Bxyzt1 - 4*mu*Exyzt2_dz*Bxyzt1 + 4*mu*Exyzt3_dy*Bxyzt1 + 4*mu*Bxyzt1_dy*Exyzt3 - 4*mu*Bxyzt2_dx*Exyzt3 + 4*mu*Bxyzt3_dx*Exyzt2 - 4*mu*Bxyzt1_dz*Exyzt2 + 4*mu*Bxyzt2_dz*Exyzt1 - 4*mu*Bxyzt3_dy*Exyzt1 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (Bxyzt1_dy_dz Exyzt3_dz_dt Exyzt2_dy_dt Exyzt1_dx_dt Bxyzt2_dx_dz Bxyzt3_dx_dy Exyzt1_dy_dz Bxyzt3_dz_dt Bxyzt2_dy_dt Bxyzt1_dx_dt Exyzt2_dx_dz Exyzt3_dx_dy jxyzt3_dz jxyzt2_dy jxyzt1_dx rhoxyzt_dt jxyzt3 jxyzt2 jxyzt1 rhoxyzt Exyzt3_dt Exyzt2_dt Exyzt1_dt varepsilon mu Bxyzt1_dy Bxyzt2_dx Bxyzt3_dx Bxyzt1_dz Bxyzt2_dz Bxyzt3_dy Bxyzt3_dt Bxyzt2_dt Bxyzt1_dt Exyzt1_dy Exyzt2_dx Exyzt3_dx Exyzt1_dz Exyzt2_dz Exyzt3_dy Bxyzt3_dz Bxyzt2_dy Bxyzt1_dx Bxyzt3 Bxyzt2 Bxyzt1 Exyzt3_dz Exyzt2_dy Exyzt1_dx Exyzt3 Exyzt2 Exyzt1 : ℝ) (hD : (4*mu^2 : ℝ) ≠ 0) : (varepsilon/2*(Exyzt1_dt*Exyzt1 + Exyzt1_dt*Exyzt1 + (Exyzt2_dt*Exyzt2 + Exyzt2_dt*Exyzt2) + (Exyzt3_dt*Exyzt3 + Exyzt3_dt*Exyzt3)) + 1/(2*mu)*(Bxyzt1_dt*Bxyzt1 + Bxyzt1_dt*Bxyzt1 + (Bxyzt2_dt*Bxyzt2 + Bxyzt2_dt*Bxyzt2) + (Bxyzt3_dt*Bxyzt3 + Bxyzt3_dt*Bxyzt3)) + (1/mu*Exyzt2_dx*Bxyzt3 + 1/mu*Exyzt2*Bxyzt3_dx - (1/mu*Exyzt3_dx*Bxyzt2 + 1/mu*Exyzt3*Bxyzt2_dx) + (1/mu*Exyzt3_dy*Bxyzt1 + 1/mu*Exyzt3*Bxyzt1_dy - (1/mu*Exyzt1_dy*Bxyzt3 + 1/mu*Exyzt1*Bxyzt3_dy)) + (1/mu*Exyzt1_dz*Bxyzt2 + 1/mu*Exyzt1*Bxyzt2_dz - (1/mu*Exyzt2_dz*Bxyzt1 + 1/mu*Exyzt2*Bxyzt1_dz))) : ℝ) - (-(jxyzt1*Exyzt1 + jxyzt2*Exyzt2 + jxyzt3*Exyzt3)) = (4*Exyzt3_dt*varepsilon*mu^2*Exyzt3 + 4*Exyzt2_dt*varepsilon*mu^2*Exyzt2 + 4*Exyzt1_dt*varepsilon*mu^2*Exyzt1 + 4*jxyzt3*mu^2*Exyzt3 + 4*jxyzt2*mu^2*Exyzt2 + 4*jxyzt1*mu^2*Exyzt1 + 4*mu*Bxyzt3_dt*Bxyzt3 - 4*mu*Exyzt1_dy*Bxyzt3 + 4*mu*Exyzt2_dx*Bxyzt3 + 4*mu*Bxyzt2_dt*Bxyzt2 - 4*mu*Exyzt3_dx*Bxyzt2 + 4*mu*Exyzt1_dz*Bxyzt2 + 4*mu*Bxyzt1_dt*Bxyzt1 - 4*mu*Exyzt2_dz*Bxyzt1 + 4*mu*Exyzt3_dy*Bxyzt1 + 4*mu*Bxyzt1_dy*Exyzt3 - 4*mu*Bxyzt2_dx*Exyzt3 + 4*mu*Bxyzt3_dx*Exyzt2 - 4*mu*Bxyzt1_dz*Exyzt2 + 4*mu*Bxyzt2_dz*Exyzt1 - 4*mu*Bxyzt3_dy*Exyzt1) / (4*mu^2) := by
  field_simp
  ring
