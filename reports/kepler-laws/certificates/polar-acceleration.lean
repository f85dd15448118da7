-- kepler-laws / polar-acceleration: The acceleration in polar coordinates.
--
-- Given: the definitions, the assumptions and newton.
--
-- Variables stand for the functions that the comments name; what holds of them is a hypothesis. The theorem says
-- that the difference of the sides, brought to N / D, is 0.

import Mathlib

-- \ddot{r}\cdot \cos(\theta)+\dot{r}\cdot (-\sin(\theta)\cdot \dot{\theta})+(\dot{r}\cdot (-\sin(\theta)\cdot \dot{\theta})+r\cdot (-(\cos(\theta)\cdot \dot{\theta}\cdot \dot{\theta}+\sin(\theta)\cdot \ddot{\theta}))) = (\ddot{r}-r\cdot \dot{\theta}^2)\cdot \cos(\theta)+(r\cdot \ddot{\theta}+2\cdot \dot{r}\cdot \dot{\theta})\cdot (-\sin(\theta))
theorem equation_1
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]

-- \ddot{r}\cdot \sin(\theta)+\dot{r}\cdot (\cos(\theta)\cdot \dot{\theta})+(\dot{r}\cdot (\cos(\theta)\cdot \dot{\theta})+r\cdot ((-\sin(\theta)\cdot \dot{\theta})\cdot \dot{\theta}+\cos(\theta)\cdot \ddot{\theta})) = (\ddot{r}-r\cdot \dot{\theta}^2)\cdot \sin(\theta)+(r\cdot \ddot{\theta}+2\cdot \dot{r}\cdot \dot{\theta})\cdot \cos(\theta)
theorem equation_2
    (hd : (1 : ℝ) ≠ 0) : (0 : ℝ) / (1) = 0 := by
  have key : (1 : ℝ) * (0) = 0 := by ring
  have top : (0 : ℝ) = 0 := (mul_eq_zero.mp key).resolve_left hd
  rw [top, zero_div]
