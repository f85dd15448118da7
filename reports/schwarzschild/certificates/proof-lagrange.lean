-- schwarzschild / lagrange: They are Lagrange's equations.
--
-- Given: the definitions, the assumptions and geodesic.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \frac{1}{2}\cdot (-((-\frac{-\frac{2\cdot M}{r}\cdot \dot{r}}{r})\cdot (2\cdot \dot{T})+(1-\frac{2\cdot M}{r})\cdot (2\cdot \ddot{T}))) = 0
-- T_ddot stands for \ddot{T}
-- r_dot stands for \dot{r}
-- T_dot stands for \dot{T}
-- r stands for r
-- M stands for M
theorem equation_1 (T_ddot r_dot T_dot r M : ℝ)
    (h1 : T_ddot*r^2 + 2*r_dot*T_dot*M - 2*T_ddot*r*M = 0)
    (hd : (1 : ℝ) ≠ 0) : (-2*T_ddot*r^3 - 4*r_dot*T_dot*r*M + 4*T_ddot*r^2*M : ℝ) / (2*r^3) = 0 := by
  have key : (1 : ℝ) * (-2*T_ddot*r^3 - 4*r_dot*T_dot*r*M + 4*T_ddot*r^2*M) = 0 := by linear_combination (-2*r) * h1
  have top : (-2*T_ddot*r^3 - 4*r_dot*T_dot*r*M + 4*T_ddot*r^2*M : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (varphi_ddot r_ddot T_ddot varphi_dot r_dot T_dot r M : ℝ) (hD : (2*r^3 : ℝ) ≠ 0) : (1/2*(-((-((-(2*M/r*r_dot))/r))*(2*T_dot) + (1 - 2*M/r)*(2*T_ddot))) : ℝ) - (0) = (-2*T_ddot*r^3 - 4*r_dot*T_dot*r*M + 4*T_ddot*r^2*M) / (2*r^3) := by
  field_simp
  ring

-- \frac{1}{2}\cdot \frac{2\cdot \ddot{r}-\frac{2\cdot \dot{r}}{1-\frac{2\cdot M}{r}}\cdot (-\frac{-\frac{2\cdot M}{r}\cdot \dot{r}}{r})}{1-\frac{2\cdot M}{r}} = \frac{1}{2}\cdot (-(-\frac{-\frac{2\cdot M}{r}}{r})\cdot \dot{T}^2+\frac{-\frac{\dot{r}^2}{1-\frac{2\cdot M}{r}}\cdot (-\frac{-\frac{2\cdot M}{r}}{r})}{1-\frac{2\cdot M}{r}}+2\cdot r\cdot \dot{\varphi}^2)
-- r_ddot stands for \ddot{r}
-- varphi_dot stands for \dot{\varphi}
-- r_dot stands for \dot{r}
-- T_dot stands for \dot{T}
-- r stands for r
-- M stands for M
theorem equation_1 (r_ddot varphi_dot r_dot T_dot r M : ℝ)
    (h1 : -varphi_dot^2*r^6 + 4*varphi_dot^2*r^5*M - 4*varphi_dot^2*r^4*M^2 + r_ddot*r^5 - r_dot^2*r^3*M + T_dot^2*r^3*M - 2*r_ddot*r^4*M - 4*T_dot^2*r^2*M^2 + 4*T_dot^2*r*M^3 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-4*varphi_dot^2*r^11 + 32*varphi_dot^2*r^10*M - 96*varphi_dot^2*r^9*M^2 + 128*varphi_dot^2*r^8*M^3 - 64*varphi_dot^2*r^7*M^4 + 4*r_ddot*r^10 - 4*r_dot^2*r^8*M + 4*T_dot^2*r^8*M - 24*r_ddot*r^9*M + 16*r_dot^2*r^7*M^2 - 32*T_dot^2*r^7*M^2 + 48*r_ddot*r^8*M^2 - 16*r_dot^2*r^6*M^3 + 96*T_dot^2*r^6*M^3 - 32*r_ddot*r^7*M^3 - 128*T_dot^2*r^5*M^4 + 64*T_dot^2*r^4*M^5 : ℝ) / (4*r^10 - 32*r^9*M + 96*r^8*M^2 - 128*r^7*M^3 + 64*r^6*M^4) = 0 := by
  have key : (1 : ℝ) * (-4*varphi_dot^2*r^11 + 32*varphi_dot^2*r^10*M - 96*varphi_dot^2*r^9*M^2 + 128*varphi_dot^2*r^8*M^3 - 64*varphi_dot^2*r^7*M^4 + 4*r_ddot*r^10 - 4*r_dot^2*r^8*M + 4*T_dot^2*r^8*M - 24*r_ddot*r^9*M + 16*r_dot^2*r^7*M^2 - 32*T_dot^2*r^7*M^2 + 48*r_ddot*r^8*M^2 - 16*r_dot^2*r^6*M^3 + 96*T_dot^2*r^6*M^3 - 32*r_ddot*r^7*M^3 - 128*T_dot^2*r^5*M^4 + 64*T_dot^2*r^4*M^5) = 0 := by linear_combination (4*r^5 - 16*r^4*M + 16*r^3*M^2) * h1
  have top : (-4*varphi_dot^2*r^11 + 32*varphi_dot^2*r^10*M - 96*varphi_dot^2*r^9*M^2 + 128*varphi_dot^2*r^8*M^3 - 64*varphi_dot^2*r^7*M^4 + 4*r_ddot*r^10 - 4*r_dot^2*r^8*M + 4*T_dot^2*r^8*M - 24*r_ddot*r^9*M + 16*r_dot^2*r^7*M^2 - 32*T_dot^2*r^7*M^2 + 48*r_ddot*r^8*M^2 - 16*r_dot^2*r^6*M^3 + 96*T_dot^2*r^6*M^3 - 32*r_ddot*r^7*M^3 - 128*T_dot^2*r^5*M^4 + 64*T_dot^2*r^4*M^5 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (varphi_ddot r_ddot T_ddot varphi_dot r_dot T_dot r M : ℝ) (hD : (4*r^10 - 32*r^9*M + 96*r^8*M^2 - 128*r^7*M^3 + 64*r^6*M^4 : ℝ) ≠ 0) : (1/2*((2*r_ddot - 2*r_dot/(1 - 2*M/r)*(-((-(2*M/r*r_dot))/r)))/(1 - 2*M/r)) : ℝ) - (1/2*(-((-((-(2*M/r))/r))*T_dot^2) + (-(r_dot^2/(1 - 2*M/r)*(-((-(2*M/r))/r))))/(1 - 2*M/r) + 2*r*varphi_dot^2)) = (-4*varphi_dot^2*r^11 + 32*varphi_dot^2*r^10*M - 96*varphi_dot^2*r^9*M^2 + 128*varphi_dot^2*r^8*M^3 - 64*varphi_dot^2*r^7*M^4 + 4*r_ddot*r^10 - 4*r_dot^2*r^8*M + 4*T_dot^2*r^8*M - 24*r_ddot*r^9*M + 16*r_dot^2*r^7*M^2 - 32*T_dot^2*r^7*M^2 + 48*r_ddot*r^8*M^2 - 16*r_dot^2*r^6*M^3 + 96*T_dot^2*r^6*M^3 - 32*r_ddot*r^7*M^3 - 128*T_dot^2*r^5*M^4 + 64*T_dot^2*r^4*M^5) / (4*r^10 - 32*r^9*M + 96*r^8*M^2 - 128*r^7*M^3 + 64*r^6*M^4) := by
  field_simp
  ring

-- \frac{1}{2}\cdot (2\cdot r\cdot \dot{r}\cdot (2\cdot \dot{\varphi})+r^2\cdot (2\cdot \ddot{\varphi})) = 0
-- varphi_ddot stands for \ddot{\varphi}
-- varphi_dot stands for \dot{\varphi}
-- r_dot stands for \dot{r}
-- r stands for r
theorem equation_2 (varphi_ddot varphi_dot r_dot r : ℝ)
    (h1 : 2*varphi_dot*r_dot + varphi_ddot*r = 0)
    (hd : (1 : ℝ) ≠ 0) : (4*varphi_dot*r_dot*r + 2*varphi_ddot*r^2 : ℝ) / (2) = 0 := by
  have key : (1 : ℝ) * (4*varphi_dot*r_dot*r + 2*varphi_ddot*r^2) = 0 := by linear_combination (2*r) * h1
  have top : (4*varphi_dot*r_dot*r + 2*varphi_ddot*r^2 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (varphi_ddot r_ddot T_ddot varphi_dot r_dot T_dot r M : ℝ) (hD : (2 : ℝ) ≠ 0) : (1/2*(2*r*r_dot*(2*varphi_dot) + r^2*(2*varphi_ddot)) : ℝ) - (0) = (4*varphi_dot*r_dot*r + 2*varphi_ddot*r^2) / (2) := by
  field_simp
  ring
