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

use expr::domain::{Nature, row};
use expr::tape::{Slots, Tape};
use number::{Interval, Jet, Op, Orders};

/// Order of the series over intervals.
const ORDER: usize = 6;
/// What may be left out, relative to the size of the state. What is narrow is smaller than that by a power of how narrow it is.
pub(super) const FINE: f64 = 1e-3;
/// Below this size nothing counts.
const FLOOR: f64 = 1e-100;
/// The coefficients of a series over a step, found side by side: one more than there are, which fills the registers.
const LANES: usize = 8;
const _: () = assert!(ORDER < LANES);

/// The memory of series over steps.
pub(super) struct Narrow {
    slots: Slots<Jet<Interval>>,
    dimension: usize,
    /// The binomial coefficients (m + k over k), one row for each m.
    weights: Vec<[f64; LANES]>,
    /// A series, then zeros.
    series: Vec<f64>,
}

/// The coefficients of a series around all times from its start to `h` after it: of hᵏ, ∑ⱼ (j over k)·cⱼ·sʲ⁻ᵏ over all s between 0
/// and h, by Horner's rule. `series` ends with as many zeros as there are lanes. `None` where something is not finite.
///
/// Sums round to nearest; the bound of a polynomial of degree n by that rule is off by less than 2(n + 2) roundings of the sum of
/// the sizes of its terms ([Higham 2002, §5.1]), which is added twice over.
///
/// [Higham 2002, §5.1]: https://doi.org/10.1137/1.9780898718027
fn around_all(series: &[f64], weights: &[[f64; LANES]], h: f64) -> Option<[Interval; LANES]> {
    let (mut low, mut high, mut size) = ([0.0_f64; LANES], [0.0_f64; LANES], [0.0_f64; LANES]);
    let ends = h.abs();
    for (m, weights) in weights.iter().enumerate().rev() {
        let Some(terms) = series.get(m..).and_then(<[f64]>::first_chunk::<LANES>) else { continue };
        for k in 0..LANES {
            let term = weights[k] * terms[k];
            let (a, b) = (low[k] * h, high[k] * h);
            let (least, most) = if a < b { (a, b) } else { (b, a) };
            low[k] = if least < 0.0 { least } else { 0.0 } + term;
            high[k] = if most > 0.0 { most } else { 0.0 } + term;
            size[k] = size[k] * ends + term.abs();
        }
    }
    let slips = 4.0 * (weights.len() as f64 + 2.0) * f64::EPSILON;
    let is_finite = size.iter().all(|size| slips * size < f64::INFINITY);
    is_finite.then(|| {
        std::array::from_fn(|k| {
            let room = slips * size[k];
            Interval::point(low[k] - room).hull(Interval::point(high[k] + room))
        })
    })
}

/// What may be left out, for a state of some size.
fn most(scale: f64) -> f64 {
    FINE * scale + FLOOR
}

/// Whether an operation is a polynomial in what moves, of a degree that a step resolves.
fn is_polynomial(op: Op, first: bool, second: bool) -> bool {
    match row(op).nature {
        Nature::Algebraic(degrees) => {
            let low = |(moves, degree): (bool, Option<u32>)| !moves || degree.is_some_and(|degree| degree <= 4);
            [first, second].into_iter().zip(degrees).all(low)
        }
        Nature::Transcendental { .. } => !first && !second,
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
        (!hides_nothing).then(|| Narrow { slots: slots(ORDER), dimension, weights: Vec::new(), series: Vec::new() })
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
        let slot = self.slots.value_mut(0);
        slot.set_coefficient(0, Interval::point(time).hull(Interval::point(time + h)));
        slot.set_coefficient(1, Interval::point(1.0));
        let count = series.len() / self.dimension.max(1);
        while self.weights.len() < count {
            let mut row = [1.0; LANES];
            if let Some(before) = self.weights.last() {
                (1..LANES).for_each(|k| row[k] = row[k - 1] + before[k]);
            }
            self.weights.push(row);
        }
        for i in 0..self.dimension {
            self.series.clear();
            self.series.extend(series[i..].iter().step_by(self.dimension));
            self.series.resize(count + LANES, 0.0);
            let Some(all) = around_all(&self.series, &self.weights[..count], h) else { return false };
            let slot = self.slots.value_mut(1 + i);
            all.iter().take(ORDER + 1).enumerate().for_each(|(k, &c)| slot.set_coefficient(k, c));
        }
        // Order by order: where a low one is small, the others need not be known.
        tape.run(&Orders::only(0, ORDER), &mut self.slots);
        let mut power = h.abs();
        let mut is_small: Vec<bool> = (0..self.dimension)
            .map(|i| {
                let slot = tape.output_slot(i);
                let width = self.slots.value(slot).coefficient(0).width();
                self.slots.missing(slot).is_none() && width * power <= most(scale(i))
            })
            .collect();
        for k in 1..=ORDER {
            tape.run(&Orders::only(k, ORDER), &mut self.slots);
            power *= h.abs();
            for (i, is_small) in is_small.iter_mut().enumerate() {
                let slot = tape.output_slot(i);
                if self.slots.missing(slot).is_some() {
                    return false;
                }
                *is_small |= self.slots.value(slot).coefficient(k).magnitude() * power <= most(scale(i));
            }
            if is_small.iter().all(|is_small| *is_small) {
                return true;
            }
        }
        false
    }
}
