//! What hides between the ends of a step.
//!
//! The coefficients of a series know the right sides at one time only. A pulse that is narrower than the step, as
//! e^{−(x − c)²/w²} is, leaves no trace in them if the step begins far from it. Here the right sides are expanded over *all*
//! times of the step at once: by Taylor's theorem with Lagrange's remainder, the coefficient of order k over an interval bounds
//! what a polynomial of degree k − 1 leaves out. A pulse of width w and height H has coefficients of about H/wᵏ, so that one
//! that is left out at order k is as small as (w/h)ᵏ.
//!
//! **In:** a step, as polynomials of the states. **Out:** whether the rates are polynomials on it, up to a small part of the
//! size of the states. Right sides that are polynomials themselves have nothing to hide.

use expr::tape::{Slots, Tape};
use number::{Interval, Jet, Op, Orders};

/// Order of the series over intervals.
const ORDER: usize = 6;
/// What may be left out, relative to the size of the state. What is narrow is smaller than that by a power of how narrow it is.
const FINE: f64 = 1e-3;
/// Below this size nothing counts.
const FLOOR: f64 = 1e-100;

/// The memory of series over steps.
pub(super) struct Narrow {
    slots: Slots<Jet<Interval>>,
    dimension: usize,
}

/// Whether an operation is a polynomial in what moves.
fn is_polynomial(op: Op, first: bool, second: bool) -> bool {
    match op {
        Op::Neg | Op::Add | Op::Sub | Op::Mul | Op::Restrict => true,
        Op::Powi(n) => (0..=4).contains(&n) || !first,
        Op::Div => !second,
        Op::Sqrt
        | Op::Exp
        | Op::Ln
        | Op::Sin
        | Op::Cos
        | Op::Tan
        | Op::Arcsin
        | Op::Arccos
        | Op::Arctan
        | Op::Sinh
        | Op::Cosh
        | Op::Tanh
        | Op::Abs => !first,
        Op::Pow | Op::Arctan2 | Op::Agm => !first && !second,
    }
}

impl Narrow {
    /// Memory for a field of some dimension, whose inputs are the time, then the states; nothing where its right sides are
    /// polynomials, which hide nothing. `slots` makes memory for series up to an order.
    pub(super) fn new(
        hides_nothing: bool,
        dimension: usize,
        slots: impl FnOnce(usize) -> Slots<Jet<Interval>>,
    ) -> Option<Narrow> {
        (!hides_nothing).then(|| Narrow { slots: slots(ORDER), dimension })
    }

    /// Whether the right sides are polynomials in the slots that are `moving`.
    pub(super) fn hides_nothing(tape: &Tape, moving: &[bool]) -> bool {
        let polynomial = |op: Op, a: u32, b: u32| is_polynomial(op, moving[a as usize], moving[b as usize]);
        tape.instructions().iter().all(|i| polynomial(i.op, i.a, i.b))
    }

    /// Whether all rates are polynomials over the step from `time` to `time + h`, on which the states are the polynomials
    /// `series` in the time since its start, order by order; `scale` is the size of a state.
    pub(super) fn resolves(
        &mut self,
        tape: &Tape,
        (time, h): (f64, f64),
        series: &[f64],
        scale: impl Fn(usize) -> f64,
    ) -> bool {
        let since = Interval::point(0.0).hull(Interval::point(h));
        let slot = self.slots.value_mut(0);
        slot.set_coefficient(0, Interval::point(time).hull(Interval::point(time + h)));
        slot.set_coefficient(1, Interval::point(1.0));
        for i in 0..self.dimension {
            let c: Vec<f64> = series[i..].iter().step_by(self.dimension).copied().collect();
            let slot = self.slots.value_mut(1 + i);
            // The coefficients around all times of the step: ∑ⱼ (j over k)·cⱼ·sʲ⁻ᵏ.
            let mut weights: Vec<f64> = vec![1.0; c.len()];
            for k in 0..=ORDER {
                let sum = (k..c.len())
                    .rev()
                    .fold(Interval::point(0.0), |sum, j| sum * since + Interval::point(weights[j] * c[j]));
                slot.set_coefficient(k, sum);
                for (j, weight) in weights.iter_mut().enumerate().skip(k + 1) {
                    *weight *= (j - k) as f64 / (k + 1) as f64;
                }
            }
        }
        tape.run(&Orders::all(ORDER), &mut self.slots);
        (0..self.dimension).all(|i| {
            let slot = tape.output_slot(i);
            if self.slots.missing(slot).is_some() {
                return false;
            }
            let (rate, most) = (self.slots.value(slot), FINE * scale(i) + FLOOR);
            let flat = rate.coefficient(0).width() * h.abs() <= most;
            let mut power = h.abs();
            flat || (1..=ORDER).any(|k| {
                power *= h.abs();
                rate.coefficient(k).magnitude() * power <= most
            })
        })
    }
}
