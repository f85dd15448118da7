-- kepler-laws / substitution: Rates by the reciprocal distance as a function of the angle.
--
-- Given: the definitions, the assumptions and across.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \dot{r} = -r^2\cdot \dot{\theta}\cdot \frac{\frac{-\frac{1}{r}\cdot \dot{r}}{r}}{\dot{\theta}}
-- theta_dot stands for \dot{\theta}
-- r stands for r
theorem equation_1 (theta_dot r : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (theta_dot*r^2) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (theta_rate r_ddot theta_ddot r_dot theta_dot r : ℝ) (hD : (theta_dot*r^2 : ℝ) ≠ 0) : (r_dot : ℝ) - (-(r^2*theta_dot*((-(1/r*r_dot))/r/theta_dot))) = (0) / (theta_dot*r^2) := by
  field_simp
  ring

-- \ddot{r} = -(r^2\cdot \dot{\theta})^{2}\cdot (\frac{1}{r})^{2}\cdot \frac{\frac{\frac{-(\frac{-\frac{1}{r}\cdot \dot{r}}{r}\cdot \dot{r}+\frac{1}{r}\cdot \ddot{r})-\frac{-\frac{1}{r}\cdot \dot{r}}{r}\cdot \dot{r}}{r}-\frac{\frac{-\frac{1}{r}\cdot \dot{r}}{r}}{\dot{\theta}}\cdot \ddot{\theta}}{\dot{\theta}}}{\dot{\theta}}
-- theta_ddot stands for \ddot{\theta}
-- r_dot stands for \dot{r}
-- theta_dot stands for \dot{\theta}
-- r stands for r
theorem equation_2 (theta_ddot r_dot theta_dot r : ℝ)
    (h1 : 2*r_dot*theta_dot + theta_ddot*r = 0)
    (hd : (1 : ℝ) ≠ 0) : (2*r_dot^2*theta_dot^3*r^9 + theta_ddot*r_dot*theta_dot^2*r^10 : ℝ) / (theta_dot^3*r^10) = 0 := by
  have key : (1 : ℝ) * (2*r_dot^2*theta_dot^3*r^9 + theta_ddot*r_dot*theta_dot^2*r^10) = 0 := by linear_combination (r_dot*theta_dot^2*r^9) * h1
  have top : (2*r_dot^2*theta_dot^3*r^9 + theta_ddot*r_dot*theta_dot^2*r^10 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (theta_rate r_ddot theta_ddot r_dot theta_dot r : ℝ) (hD : (theta_dot^3*r^10 : ℝ) ≠ 0) : (r_ddot : ℝ) - (-((r^2*theta_dot)^2*(1/r)^2*(((-((-(1/r*r_dot))/r*r_dot + 1/r*r_ddot) - (-(1/r*r_dot))/r*r_dot)/r - (-(1/r*r_dot))/r/theta_dot*theta_ddot)/theta_dot/theta_dot))) = (2*r_dot^2*theta_dot^3*r^9 + theta_ddot*r_dot*theta_dot^2*r^10) / (theta_dot^3*r^10) := by
  field_simp
  ring

-- r\cdot \dot{\theta}^2 = \frac{1}{\frac{1}{r}}\cdot ((r^2\cdot \dot{\theta})^{2}\cdot (\frac{1}{r})^{4})
-- r stands for r
theorem equation_1 (r : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (r^4) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (theta_ddot r_dot theta_dot r : ℝ) (hD : (r^4 : ℝ) ≠ 0) : (r*theta_dot^2 : ℝ) - (1/(1/r)*((r^2*theta_dot)^2*(1/r)^4)) = (0) / (r^4) := by
  field_simp
  ring

-- \frac{1}{\frac{1}{r}}\cdot ((r^2\cdot \dot{\theta})^{2}\cdot (\frac{1}{r})^{4}) = (r^2\cdot \dot{\theta})^{2}\cdot (\frac{1}{r})^{3}
-- r stands for r
theorem equation_2 (r : ℝ)
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (r^7) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

example (theta_ddot r_dot theta_dot r : ℝ) (hD : (r^7 : ℝ) ≠ 0) : (1/(1/r)*((r^2*theta_dot)^2*(1/r)^4) : ℝ) - ((r^2*theta_dot)^2*(1/r)^3) = (0) / (r^7) := by
  field_simp
  ring
