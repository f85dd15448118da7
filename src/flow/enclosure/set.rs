//! Sets of states that turn and stretch with the motion.
//!
//! A set is { x̂ + C·r₀ + B·r : r₀ ∈ **r₀**, r ∈ **r** }: a centre, a part that stems from the initial box and keeps its
//! dependencies for ever (C is the product of all Jacobians so far), and a part that gathers errors, in nearly orthonormal
//! directions B (a *doubleton*: [Lohner 1987], [Mrozek & Zgliczyński 2000, §3]). Boxes alone would wrap: a rotated box is
//! put into a larger box at every step, and grows exponentially even where the motion does not.
//!
//! [Lohner 1987]: https://publikationen.bibliothek.kit.edu/38889
//! [Mrozek & Zgliczyński 2000, §3]: https://doi.org/10.4064/ap-74-1-237-259

use super::matrix::{apply, apply_point, identity, inverse, middle, orthogonal, times, times_point};
use crate::number::{Interval, Scalar};

#[derive(Clone, Debug)]
pub(super) struct Set {
    pub(super) centre: Vec<f64>,
    /// Empty when the start is a point.
    from_start: Vec<f64>,
    start: Vec<Interval>,
    directions: Vec<f64>,
    errors: Vec<Interval>,
}

impl Set {
    /// The states of a box.
    pub(super) fn new(state: &[Interval]) -> Set {
        let n = state.len();
        let centre: Vec<f64> = state.iter().map(Interval::mid).collect();
        let start: Vec<Interval> = state.iter().zip(&centre).map(|(&x, &m)| x - Interval::point(m)).collect();
        let moves = start.iter().any(|x| !x.is_zero());
        Set {
            centre,
            from_start: if moves { identity(n) } else { Vec::new() },
            start,
            directions: identity(n),
            errors: vec![Interval::ZERO; n],
        }
    }

    /// A box around the set.
    pub(super) fn hull(&self) -> Vec<Interval> {
        let errors = apply_point(&self.directions, &self.errors);
        let mut out: Vec<Interval> = self.centre.iter().zip(errors).map(|(&c, e)| Interval::point(c) + e).collect();
        if !self.from_start.is_empty() {
            let moved = apply_point(&self.from_start, &self.start);
            out.iter_mut().zip(moved).for_each(|(x, m)| *x = *x + m);
        }
        out
    }

    /// The image under a map x ↦ T(x) + e with e ∈ `error`: `shift` contains T(x̂) − x̂ + e, and `jacobian` the derivative of
    /// T at all states of the set. By the mean value theorem, T(x) ∈ T(x̂) + DT(**x**)·(x − x̂).
    ///
    /// `None` when no invertible directions are found or a bound is not finite.
    pub(super) fn image(&self, shift: &[Interval], jacobian: &[Interval]) -> Option<Set> {
        let n = self.centre.len();
        let centre: Vec<f64> = self.centre.iter().zip(shift).map(|(&c, s)| c + s.mid()).collect();
        let mut error: Vec<Interval> =
            (0..n).map(|i| (Interval::point(self.centre[i]) - Interval::point(centre[i])) + shift[i]).collect();
        let mut from_start = Vec::new();
        if !self.from_start.is_empty() {
            let moved = times_point(jacobian, &self.from_start, n);
            from_start = middle(&moved);
            // What rounding the new matrix to numbers leaves out.
            let rest: Vec<Interval> = moved.iter().zip(&from_start).map(|(&m, &c)| m - Interval::point(c)).collect();
            error.iter_mut().zip(apply(&rest, &self.start)).for_each(|(e, x)| *e = *e + x);
        }
        let moved = times_point(jacobian, &self.directions, n);
        let weights: Vec<f64> = self.errors.iter().map(|e| e.width() + f64::MIN_POSITIVE).collect();
        let directions = if faults::no_rotation() { identity(n) } else { orthogonal(&middle(&moved), &weights, n) };
        let back = inverse(&directions, n)?;
        let turned = times(&back, &moved, n);
        let mut errors = apply(&turned, &self.errors);
        errors.iter_mut().zip(apply(&back, &error)).for_each(|(e, x)| *e = *e + x);
        if faults::lost_directions() {
            // The errors are kept, but said to lie along other directions.
            errors = self.errors.clone();
        }
        let finite = errors.iter().all(|e| e.checked().is_ok()) && centre.iter().all(|c| c.is_finite());
        finite.then(|| Set { centre, from_start, start: self.start.clone(), directions, errors })
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
}

/// There are none.
#[cfg(not(test))]
pub(super) mod faults {
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
}
