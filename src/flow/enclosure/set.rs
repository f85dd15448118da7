//! Sets of states that turn and stretch with the motion.
//!
//! A set is { x̂ + C·r₀ + B·r : r₀ ∈ **r₀**, r ∈ **r** }: a centre of twice the precision of binary64, a part that stems from the initial box and keeps its
//! dependencies for ever (C is the product of all Jacobians so far), and a part that gathers errors, in directions B (a
//! *doubleton*: [Lohner 1987], [Mrozek & Zgliczyński 2000, §3]). B is carried along by the Jacobians as long as it is well
//! conditioned, so that errors do not wrap, and is then renewed by orthonormal directions (Lohner's QR method). Boxes alone would wrap: a rotated box is
//! put into a larger box at every step, and grows exponentially even where the motion does not.
//!
//! [Lohner 1987]: https://publikationen.bibliothek.kit.edu/38889
//! [Mrozek & Zgliczyński 2000, §3]: https://doi.org/10.4064/ap-74-1-237-259

use super::matrix::{
    apply, apply_point, identity, inverse, middle, orthogonal, rough_inverse, solve, times, times_point, transpose,
};
use number::{DoubleDouble, Interval, Precise, Scalar};
use serde::{Deserialize, Serialize};

/// Directions up to this condition number are carried along in any case.
const GOOD_CONDITION: f64 = 50.0;
/// Directions beyond this condition number are never carried along.
const WORST_CONDITION: f64 = 1e8;
/// An initial box that is smaller than this part of the largest state is treated like an error.
const POINT: f64 = 1e-20;
/// What a step may add to the errors, as a part of them, before their directions are renewed.
const RENEWAL: f64 = 0.05;

#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Set {
    pub(super) centre: Vec<DoubleDouble>,
    /// Empty when the start is a point.
    from_start: Vec<f64>,
    start: Vec<Interval>,
    directions: Vec<f64>,
    errors: Vec<Interval>,
}

impl Set {
    /// The states of a box.
    pub(super) fn new(state: &[Precise]) -> Set {
        let n = state.len();
        let (centre, around): (Vec<DoubleDouble>, Vec<Interval>) = state.iter().map(Precise::split).unzip();
        let size = centre.iter().map(|c| c.high().abs()).fold(0.0, f64::max);
        let moves = around.iter().any(|x| x.magnitude() > POINT * size);
        let nothing = vec![Interval::ZERO; n];
        let (from_start, start, errors) =
            if moves { (identity(n), around, nothing) } else { (Vec::new(), nothing, around) };
        Set { centre, from_start, start, directions: identity(n), errors }
    }

    /// How far the states may be from the centre.
    pub(super) fn radii(&self) -> Vec<f64> {
        let mut out = apply_point(&self.directions, &self.errors);
        if !self.from_start.is_empty() {
            let moved = apply_point(&self.from_start, &self.start);
            out.iter_mut().zip(moved).for_each(|(x, m)| *x = *x + m);
        }
        out.iter().map(Interval::magnitude).collect()
    }

    /// A box around the set.
    pub(super) fn hull(&self) -> Vec<Interval> {
        self.centre.iter().zip(self.radii()).map(|(&c, r)| Precise::new(c, r).interval()).collect()
    }

    /// A box around the image under the map of [`Set::image`].
    pub(super) fn hull_of_image(&self, shift: &[Interval], jacobian: &[Interval]) -> Vec<Interval> {
        let n = self.centre.len();
        let errors = apply(&times_point(jacobian, &self.directions, n), &self.errors);
        let mut out: Vec<Interval> = self
            .centre
            .iter()
            .zip(shift)
            .zip(errors)
            .map(|((&c, &s), e)| Precise::new(c, 0.0).interval() + (s + e))
            .collect();
        if !self.from_start.is_empty() {
            let moved = apply(&times_point(jacobian, &self.from_start, n), &self.start);
            out.iter_mut().zip(moved).for_each(|(x, m)| *x = *x + m);
        }
        out
    }

    /// The image under a map x ↦ T(x) + e with e ∈ `error`: `shift` contains T(x̂) − x̂ + e, and `jacobian` the derivative of
    /// T at all states of the set. By the mean value theorem, T(x) ∈ T(x̂) + DT(**x**)·(x − x̂).
    ///
    /// `None` when no invertible directions are found or a bound is not finite.
    pub(super) fn image(&self, shift: &[Precise], jacobian: &[Interval]) -> Option<Set> {
        let n = self.centre.len();
        let moved = self.centre.iter().zip(shift).map(|(&c, s)| Precise::new(c, 0.0).plus(s).split());
        let (mut centre, mut error): (Vec<DoubleDouble>, Vec<Interval>) = moved.unzip();
        if faults::lost_low() {
            // The centre is rounded to binary64, and nobody is told.
            centre.iter_mut().for_each(|c| *c = DoubleDouble::point(c.high()));
        }
        let mut from_start = Vec::new();
        if !self.from_start.is_empty() {
            let moved = times_point(jacobian, &self.from_start, n);
            from_start = middle(&moved);
            // What rounding the new matrix to numbers leaves out.
            let rest: Vec<Interval> = moved.iter().zip(&from_start).map(|(&m, &c)| m - Interval::point(c)).collect();
            error.iter_mut().zip(apply(&rest, &self.start)).for_each(|(e, x)| *e = *e + x);
        }
        let moved = times_point(jacobian, &self.directions, n);
        let (directions, mut errors) = match self.carried(&moved, &error) {
            Some(carried) => carried,
            None => self.turned(&moved, &error)?,
        };
        if faults::lost_directions() {
            // The errors are kept, but said to lie along other directions.
            errors = self.errors.clone();
        }
        let finite = errors.iter().all(|e| e.checked().is_ok()) && centre.iter().all(|c| c.checked().is_ok());
        finite.then(|| Set { centre, from_start, start: self.start.clone(), directions, errors })
    }
}

/// The largest sum of a row of absolute values.
fn norm(m: &[f64], n: usize) -> f64 {
    m.chunks_exact(n).map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max)
}

impl Set {
    /// The errors in directions that are carried along: B′ is the middle of J·B, so that old errors keep their coordinates
    /// and do not wrap at all. A new error e adds B′⁻¹e, which is large when B′ is nearly singular: `None` then.
    fn carried(&self, moved: &[Interval], error: &[Interval]) -> Option<(Vec<f64>, Vec<Interval>)> {
        let n = self.centre.len();
        let directions = middle(moved);
        let rough = rough_inverse(&directions, n)?;
        let condition = norm(&directions, n) * norm(&rough, n);
        if condition.is_nan() || condition >= WORST_CONDITION || faults::no_rotation() {
            return None;
        }
        let rest: Vec<Interval> = moved.iter().zip(&directions).map(|(&m, &d)| m - Interval::point(d)).collect();
        let fresh: Vec<Interval> = apply(&rest, &self.errors).iter().zip(error).map(|(&r, &e)| r + e).collect();
        let added = solve(&directions, &rough, &fresh)?;
        if condition > GOOD_CONDITION {
            // Directions are renewed when what a step adds is no longer small against what is there.
            let size = |v: &[Interval]| apply_point(&directions, v).iter().map(Interval::width).fold(0.0, f64::max);
            if size(&added) > RENEWAL * size(&self.errors) {
                return None;
            }
        }
        let errors = self.errors.iter().zip(added).map(|(&r, a)| r + a).collect();
        Some((directions, errors))
    }

    /// The errors in new, nearly orthonormal directions.
    fn turned(&self, moved: &[Interval], error: &[Interval]) -> Option<(Vec<f64>, Vec<Interval>)> {
        let n = self.centre.len();
        let weights: Vec<f64> = self.errors.iter().map(|e| e.width() + f64::MIN_POSITIVE).collect();
        let directions = if faults::no_rotation() { identity(n) } else { orthogonal(&middle(moved), &weights, n) };
        let back = inverse(&directions, &transpose(&directions, n), n)?;
        let mut errors = apply(&times(&back, moved, n), &self.errors);
        errors.iter_mut().zip(apply(&back, error)).for_each(|(e, x)| *e = *e + x);
        Some((directions, errors))
    }
}

/// Mistakes that tests can make on purpose.
#[cfg(test)]
pub(super) mod faults {
    use std::cell::Cell;

    thread_local! {
        pub static NO_ROTATION: Cell<bool> = const { Cell::new(false) };
        pub static LOST_DIRECTIONS: Cell<bool> = const { Cell::new(false) };
        pub static NO_REMAINDER: Cell<bool> = const { Cell::new(false) };
        /// Forget the second part of the centre.
        pub static LOST_LOW: Cell<bool> = const { Cell::new(false) };
        /// No mistake: a p of so low an order that its remainder counts.
        pub static SHORT_SERIES: Cell<bool> = const { Cell::new(false) };
    }

    pub fn short_series() -> bool {
        SHORT_SERIES.get()
    }

    pub fn no_rotation() -> bool {
        NO_ROTATION.get()
    }
    pub fn lost_directions() -> bool {
        LOST_DIRECTIONS.get()
    }
    pub fn no_remainder() -> bool {
        NO_REMAINDER.get()
    }
    pub fn lost_low() -> bool {
        LOST_LOW.get()
    }
}

/// There are none.
#[cfg(not(test))]
pub(super) mod faults {
    #[inline(always)]
    pub fn short_series() -> bool {
        false
    }
    #[inline(always)]
    pub fn no_rotation() -> bool {
        false
    }
    #[inline(always)]
    pub fn lost_directions() -> bool {
        false
    }
    #[inline(always)]
    pub fn no_remainder() -> bool {
        false
    }
    #[inline(always)]
    pub fn lost_low() -> bool {
        false
    }
}
