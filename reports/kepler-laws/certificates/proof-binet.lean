-- kepler-laws / binet: The equation of the orbit: that of an oscillator under a constant force.
--
-- Given: the definitions, the assumptions and along, substitution.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- -(r^2\cdot \dot{\theta})^{2}\cdot (\frac{1}{r})^{2}\cdot \frac{\frac{\frac{-(\frac{-\frac{1}{r}\cdot \dot{r}}{r}\cdot \dot{r}+\frac{1}{r}\cdot \ddot{r})-\frac{-\frac{1}{r}\cdot \dot{r}}{r}\cdot \dot{r}}{r}-\frac{\frac{-\frac{1}{r}\cdot \dot{r}}{r}}{\dot{\theta}}\cdot \ddot{\theta}}{\dot{\theta}}}{\dot{\theta}}-(r^2\cdot \dot{\theta})^{2}\cdot (\frac{1}{r})^{3} = -G\cdot M\cdot (\frac{1}{r})^{2}
-- r_ddot stands for \ddot{r}
-- theta_ddot stands for \ddot{\theta}
-- r_dot stands for \dot{r}
-- theta_dot stands for \dot{\theta}
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (r_ddot theta_ddot r_dot theta_dot M G r : ℝ)
    (h1 : -theta_dot^2*r^3 + r_ddot*r^2 + M*G = 0)
    (h2 : 2*r_dot^2*theta_dot^3*r^9 + theta_ddot*r_dot*theta_dot^2*r^10 = 0)
    (hd : (1 : ℝ) ≠ 0) : (-theta_dot^5*r^16 - 2*r_dot^2*theta_dot^3*r^14 - theta_ddot*r_dot*theta_dot^2*r^15 + r_ddot*theta_dot^3*r^15 + theta_dot^3*M*G*r^13 : ℝ) / (theta_dot^3*r^15) = 0 := by
  have key : (1 : ℝ) * (-theta_dot^5*r^16 - 2*r_dot^2*theta_dot^3*r^14 - theta_ddot*r_dot*theta_dot^2*r^15 + r_ddot*theta_dot^3*r^15 + theta_dot^3*M*G*r^13) = 0 := by linear_combination (theta_dot^3*r^13) * h1 + (-r^5) * h2
  have top : (-theta_dot^5*r^16 - 2*r_dot^2*theta_dot^3*r^14 - theta_ddot*r_dot*theta_dot^2*r^15 + r_ddot*theta_dot^3*r^15 + theta_dot^3*M*G*r^13 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (r_ddot theta_ddot r_dot theta_dot M G r : ℝ) (hD : (theta_dot^3*r^15 : ℝ) ≠ 0) : (-((r^2*theta_dot)^2*(1/r)^2*(((-((-(1/r*r_dot))/r*r_dot + 1/r*r_ddot) - (-(1/r*r_dot))/r*r_dot)/r - (-(1/r*r_dot))/r/theta_dot*theta_ddot)/theta_dot/theta_dot)) - (r^2*theta_dot)^2*(1/r)^3 : ℝ) - (-(G*M*(1/r)^2)) = (-theta_dot^5*r^16 - 2*r_dot^2*theta_dot^3*r^14 - theta_ddot*r_dot*theta_dot^2*r^15 + r_ddot*theta_dot^3*r^15 + theta_dot^3*M*G*r^13) / (theta_dot^3*r^15) := by
  field_simp
  ring

-- \frac{\frac{\frac{-(\frac{-\frac{1}{r}\cdot \dot{r}}{r}\cdot \dot{r}+\frac{1}{r}\cdot \ddot{r})-\frac{-\frac{1}{r}\cdot \dot{r}}{r}\cdot \dot{r}}{r}-\frac{\frac{-\frac{1}{r}\cdot \dot{r}}{r}}{\dot{\theta}}\cdot \ddot{\theta}}{\dot{\theta}}}{\dot{\theta}}+\frac{1}{r} = \frac{G\cdot M}{(r^2\cdot \dot{\theta})^{2}}
-- r_ddot stands for \ddot{r}
-- theta_ddot stands for \ddot{\theta}
-- r_dot stands for \dot{r}
-- theta_dot stands for \dot{\theta}
-- M stands for M
-- G stands for G
-- r stands for r
theorem equation_1 (r_ddot theta_ddot r_dot theta_dot M G r : ℝ)
    (h1 : -theta_dot^2*r^3 + r_ddot*r^2 + M*G = 0)
    (h2 : 2*r_dot^2*theta_dot^3*r^9 + theta_ddot*r_dot*theta_dot^2*r^10 = 0)
    (hd : (1 : ℝ) ≠ 0) : (theta_dot^5*r^12 + 2*r_dot^2*theta_dot^3*r^10 + theta_ddot*r_dot*theta_dot^2*r^11 - r_ddot*theta_dot^3*r^11 - theta_dot^3*M*G*r^9 : ℝ) / (theta_dot^5*r^13) = 0 := by
  have key : (1 : ℝ) * (theta_dot^5*r^12 + 2*r_dot^2*theta_dot^3*r^10 + theta_ddot*r_dot*theta_dot^2*r^11 - r_ddot*theta_dot^3*r^11 - theta_dot^3*M*G*r^9) = 0 := by linear_combination (-theta_dot^3*r^9) * h1 + (r) * h2
  have top : (theta_dot^5*r^12 + 2*r_dot^2*theta_dot^3*r^10 + theta_ddot*r_dot*theta_dot^2*r^11 - r_ddot*theta_dot^3*r^11 - theta_dot^3*M*G*r^9 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (r_ddot theta_ddot r_dot theta_dot M G r : ℝ) (hD : (theta_dot^5*r^13 : ℝ) ≠ 0) : (((-((-(1/r*r_dot))/r*r_dot + 1/r*r_ddot) - (-(1/r*r_dot))/r*r_dot)/r - (-(1/r*r_dot))/r/theta_dot*theta_ddot)/theta_dot/theta_dot + 1/r : ℝ) - (G*M/(r^2*theta_dot)^2) = (theta_dot^5*r^12 + 2*r_dot^2*theta_dot^3*r^10 + theta_ddot*r_dot*theta_dot^2*r^11 - r_ddot*theta_dot^3*r^11 - theta_dot^3*M*G*r^9) / (theta_dot^5*r^13) := by
  field_simp
  ring
