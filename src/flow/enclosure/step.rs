//! One validated step, and the sequence of them.
//!
//! **A step.** Let X be a box around the states at t, x⁽ᵏ⁾ the k-th Taylor coefficient of the motion as a function of the
//! state, and p the order. (1) A box E is found with Σₖ≤ₚ x⁽ᵏ⁾(X)·[0, h]ᵏ + x⁽ᵖ⁺¹⁾(E)·[0, h]ᵖ⁺¹ inside E. Then every motion
//! from X exists on [t, t + h], is unique and stays in E (high-order enclosure: [Nedialkov, Jackson & Pryce 2001, Theorem 4.1],
//! [Corliss & Rihm 1996]). (2) By Taylor's theorem with Lagrange's remainder the state at t + h is T(x) + e with
//! T(x) = Σₖ≤ₚ x⁽ᵏ⁾(x)·hᵏ and e ∈ x⁽ᵖ⁺¹⁾(E)·hᵖ⁺¹. (3) T is evaluated at the centre of the set, and its derivative, which is
//! the Taylor polynomial of the variational equation V′ = Df·V, V(t) = I, over X; the set then moves by the mean value
//! theorem, see `set`.
//!
//! All coefficients come from the tape of the system, and from that tape with its partial derivatives, over intervals.
//!
//! [Nedialkov, Jackson & Pryce 2001, Theorem 4.1]: https://doi.org/10.1023/A:1014798618404
//! [Corliss & Rihm 1996]: https://doi.org/10.1007/978-3-322-91233-9

use super::set::{Set, faults};
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::core::fresh;
use crate::flow::error::{FlowError, leaf_name};
use crate::flow::taylor::Flow;
use crate::number::{Interval, Jet, NoValue, Number, Scalar, TaylorModel};
use crate::tape::{Slots, Tape};
use std::sync::Arc;

/// Order of the Taylor polynomials.
pub(super) const ORDER: usize = 20;
/// The remainder of a step shall be below this part of the largest state.
const REMAINDER: f64 = 1e-17;
/// Or below this part of the width of the set: what a step adds would otherwise decide on its directions.
const REMAINDER_OF_WIDTH: f64 = 1e-8;
/// The set may become as wide as this part of the largest state.
const WIDEST: f64 = 0.5;
/// Number of parts of a step over which its remainder is sharpened.
const PARTS: usize = 4;
/// Largest number of steps in one direction.
const MAX_STEPS: usize = 2_000;
/// After so many steps it is asked whether the end is within reach.
const OUTLOOK: usize = 100;

/// A vector field compiled for enclosures.
#[derive(Clone, Debug)]
pub(super) struct Field {
    pub(super) flow: Flow,
    /// The field and its variational equations, as one field whose further states are the entries of V.
    variation: Flow,
    /// Row and column of every further state.
    entries: Arc<[(usize, usize)]>,
    pub(super) constants: Vec<Interval>,
    driven: bool,
}

/// Why an enclosure ends. What was reached is kept.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Stop {
    /// The set of states has become so wide that nothing is left to be said.
    #[error("the enclosure is {width:.1e} wide at t = {time}")]
    TooWide {
        /// The time that was reached.
        time: f64,
        /// Largest width of a state there.
        width: f64,
    },
    /// No step could be validated, however short: a singularity is near, or the set is too wide.
    #[error("no step could be validated at t = {time}, where the enclosure is {width:.1e} wide: {reason}")]
    NoStep {
        /// The time that was reached.
        time: f64,
        /// Largest width of a state there.
        width: f64,
        /// What failed in the last attempt.
        reason: String,
    },
    /// More steps than the limit, or as it seems twice as many as that.
    #[error(
        "t = {time} is reached after {steps} validated steps, and the limit of {MAX_STEPS} is too few for the span; the \
         enclosure is {width:.1e} wide there"
    )]
    TooManySteps {
        /// The time that was reached.
        time: f64,
        /// The number of steps.
        steps: usize,
        /// Largest width of a state there.
        width: f64,
    },
}

/// The motions through a set of states, over one step.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    /// Time at the start, and at the end (which is earlier for a step back).
    pub(super) from: f64,
    pub(super) to: f64,
    /// `ORDER + 2` coefficients for every state, over all states at the start; the last one holds throughout.
    coefficients: Vec<Interval>,
    /// The states at the start, the coefficients at their centre (but the first) and those of the derivatives.
    set: Set,
    of_centre: Vec<Interval>,
    of_derivatives: Vec<Interval>,
    /// Row and column of every derivative.
    entries: Arc<[(usize, usize)]>,
    /// All states of the step.
    pub(super) hull: Vec<Interval>,
}

impl Piece {
    /// The states at all times of an interval that lies in the step: at one time, by the mean value form.
    pub(super) fn at(&self, time: Interval) -> Vec<Interval> {
        let s = time - Interval::point(self.from);
        let row = ORDER + 2;
        let all = self.coefficients.chunks_exact(row).zip(&self.hull);
        let direct = all.map(|(c, &hull)| polynomial(c, s).intersection(hull).unwrap_or(hull));
        if !time.is_point() {
            return direct.collect();
        }
        let (shift, jacobian) = self.map(s);
        let centred = self.set.hull_of_image(&shift, &jacobian);
        direct.zip(centred).map(|(d, c)| d.intersection(c).unwrap_or(d)).collect()
    }

    /// The states over an interval of times that lies in the step, as models over it.
    pub(super) fn models(&self, middle: f64, half: f64) -> Result<Vec<TaylorModel>, NoValue> {
        let s = TaylorModel::variable(Interval::point(middle) - Interval::point(self.from), half);
        let of = |c: &[Interval]| {
            let mut sum = TaylorModel::ZERO;
            for &c in c.iter().rev() {
                let mut product = TaylorModel::ZERO;
                product.mul(&(), &sum, &s)?;
                sum.add(&(), &product, &TaylorModel::constant(c))?;
            }
            Ok(sum)
        };
        self.coefficients.chunks_exact(ORDER + 2).map(of).collect()
    }

    /// The map from the states at the start to those s later, as [`Set::image`] takes it.
    fn map(&self, s: Interval) -> (Vec<Interval>, Vec<Interval>) {
        let n = self.set.centre.len();
        let mut last = s;
        (0..ORDER).for_each(|_| last = last * s);
        let remainder = self.coefficients.chunks_exact(ORDER + 2).map(|c| c[ORDER + 1] * last);
        let moved = self.of_centre.chunks_exact(ORDER).map(|c| s * polynomial(c, s));
        let shift = moved.zip(remainder).map(|(m, r)| m + r).collect();
        let mut jacobian = vec![Interval::ZERO; n * n];
        for (c, &(i, j)) in self.of_derivatives.chunks_exact(ORDER + 1).zip(self.entries.iter()) {
            jacobian[i * n + j] = polynomial(c, s);
        }
        (shift, jacobian)
    }
}

/// c₀ + c₁s + …
fn polynomial(c: &[Interval], s: Interval) -> Interval {
    c.iter().rev().copied().reduce(|sum, c| sum * s + c).unwrap_or(Interval::ZERO)
}

/// Memory of the steps.
struct Bench {
    point: Slots<Jet<Interval>>,
    around: Slots<Jet<Interval>>,
    whole: Slots<Jet<Interval>>,
    of_point: Vec<Interval>,
    of_set: Vec<Interval>,
    of_hull: Vec<Interval>,
}

impl Field {
    /// Compiles rates (in the leaves of time, states and constants) and their partial derivatives.
    ///
    /// # Errors
    /// [`FlowError::NoDerivative`] for a rate with an operation that has no derivative.
    pub(super) fn new(
        graph: &mut Graph,
        time: Leaf,
        states: &[Leaf],
        rates: &[Expr],
        constants: Vec<(Leaf, Interval)>,
    ) -> Result<Field, FlowError> {
        let n = states.len();
        let unknown = |graph: &Graph, leaf| FlowError::UnknownLeaf { leaf: leaf_name(graph, leaf) };
        let names: Vec<String> = states.iter().map(|&l| leaf_name(graph, l)).collect();
        let mut partial: Vec<Vec<Option<Expr>>> = Vec::new();
        for &rate in rates {
            let present = graph.leaves([rate]);
            let mut row = Vec::new();
            for &state in states {
                let d = if present.contains(&state) { Some(graph.partial_derivative(rate, state)) } else { None };
                let d = d
                    .transpose()
                    .map_err(|reason| FlowError::NoDerivative { leaf: leaf_name(graph, state), reason })?;
                row.push(d.filter(|&d| !graph.is_zero(d)));
            }
            partial.push(row);
        }
        // An entry of V is 0 for ever unless its row depends, through any number of rates, on its column.
        let mut reaches: Vec<Vec<bool>> =
            (0..n).map(|i| (0..n).map(|j| i == j || partial[i][j].is_some()).collect()).collect();
        for k in 0..n {
            for i in 0..n {
                for j in 0..n {
                    reaches[i][j] |= reaches[i][k] && reaches[k][j];
                }
            }
        }
        let entries: Vec<(usize, usize)> =
            (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|&(i, j)| reaches[i][j]).collect();
        let leaves: Vec<Leaf> = entries.iter().map(|_| fresh(graph, "variation")).collect();
        let entry = |i: usize, j: usize| entries.iter().position(|&e| e == (i, j)).map(|at| leaves[at]);
        let mut all_rates = rates.to_vec();
        for &(i, j) in &entries {
            let mut sum: Option<Expr> = None;
            for (k, d) in partial[i].iter().enumerate() {
                let (Some(d), Some(v)) = (*d, entry(k, j)) else { continue };
                let v = graph.leaf(v);
                let term = graph.mul(d, v);
                sum = Some(sum.map_or(term, |sum| graph.add(sum, term)));
            }
            let rate = sum.unwrap_or_else(|| graph.integer(0));
            all_rates.push(rate);
        }
        let used: Vec<Leaf> = constants.iter().map(|c| c.0).collect();
        let inputs = |states: &[Leaf]| -> Vec<Leaf> {
            [time].into_iter().chain(states.iter().copied()).chain(used.iter().copied()).collect()
        };
        let extended: Vec<Leaf> = states.iter().chain(&leaves).copied().collect();
        let tape = Tape::compile(graph, &inputs(states), rates).map_err(|l| unknown(graph, l))?;
        let variation = Tape::compile(graph, &inputs(&extended), &all_rates).map_err(|l| unknown(graph, l))?;
        let driven = tape.instructions().iter().any(|i| i.a == 0 || i.b == 0);
        Ok(Field {
            flow: Flow::new(tape, states, names.clone()),
            variation: Flow::new(variation, &extended, Vec::new()),
            entries: entries.into(),
            constants: constants.into_iter().map(|c| c.1).collect(),
            driven,
        })
    }

    fn dimension(&self) -> usize {
        self.flow.dimension
    }

    /// The motions from `state` at `start` until `end`, and why they end earlier.
    pub(super) fn integrate(&self, start: f64, state: &[Interval], end: f64) -> (Vec<Piece>, Option<Stop>) {
        let (n, m) = (self.dimension(), self.entries.len());
        let mut bench = Bench {
            point: self.flow.slots(ORDER, &self.constants),
            around: self.variation.slots(ORDER, &self.constants),
            whole: self.flow.slots(ORDER + 1, &self.constants),
            of_point: vec![Interval::ZERO; n * (ORDER + 1)],
            of_set: vec![Interval::ZERO; (n + m) * (ORDER + 1)],
            of_hull: vec![Interval::ZERO; n * (ORDER + 2)],
        };
        let mut pieces = Vec::new();
        let (mut time, mut set) = (start, Set::new(state));
        while time != end {
            let width = set.hull().iter().map(Interval::width).fold(0.0, f64::max);
            let steps = pieces.len();
            let far = |part: f64| (time - start).abs() < part * (end - start).abs();
            if steps >= MAX_STEPS || (steps == OUTLOOK && far(OUTLOOK as f64 / (2 * MAX_STEPS) as f64)) {
                return (pieces, Some(Stop::TooManySteps { time, steps, width }));
            }
            match self.step(&mut bench, &set, time, start, end) {
                Ok((piece, next)) => {
                    time = piece.to;
                    set = next;
                    pieces.push(piece);
                }
                Err(reason) => {
                    let size = set.hull().iter().map(Interval::magnitude).fold(0.0, f64::max);
                    let stop = if width > WIDEST * size {
                        Stop::TooWide { time, width }
                    } else {
                        Stop::NoStep { time, width, reason }
                    };
                    return (pieces, Some(stop));
                }
            }
        }
        (pieces, None)
    }

    /// One step towards `end`.
    fn step(&self, bench: &mut Bench, set: &Set, time: f64, start: f64, end: f64) -> Result<(Piece, Set), String> {
        let n = self.dimension();
        let row = ORDER + 1;
        let hull = set.hull();
        let size = hull.iter().map(Interval::magnitude).fold(0.0, f64::max);
        let width = hull.iter().map(Interval::width).fold(0.0, f64::max);
        if width > WIDEST * size.max(f64::MIN_POSITIVE) {
            return Err("the set is too wide".to_owned());
        }
        let why = |(i, reason): (usize, NoValue)| match self.flow.names.get(i) {
            Some(name) => format!("the rate of {name} is {reason}"),
            None => format!("a derivative of a rate is {reason}"),
        };
        let now = Interval::point(time);
        let centre: Vec<Interval> = set.centre.iter().map(|&x| Interval::point(x)).collect();
        self.flow.expand(&mut bench.point, ORDER, now, &centre, &mut bench.of_point).map_err(why)?;
        let one = |&(i, j): &(usize, usize)| if i == j { Interval::point(1.0) } else { Interval::ZERO };
        let extended: Vec<Interval> = hull.iter().copied().chain(self.entries.iter().map(one)).collect();
        self.variation.expand(&mut bench.around, ORDER, now, &extended, &mut bench.of_set).map_err(why)?;

        let direction = if end > time { 1.0 } else { -1.0 };
        let remaining = (end - time).abs();
        let longest = (end - start).abs() * if self.driven { 1.0 / 64.0 } else { 0.25 };
        let mut step = self.proposal(&bench.of_point, size).min(longest);
        if step > 0.6 * remaining {
            step = if step >= remaining { remaining } else { 0.6 * remaining };
        }
        let smallest = (64.0 * f64::EPSILON * time.abs()).max(1e-9 * (end - start).abs()).min(remaining);
        let tolerance = (remainder_of_step() * size).max(REMAINDER_OF_WIDTH * width);
        let mut reason = "no box was found that holds the motion".to_owned();
        while step >= smallest {
            let mut to = if step >= remaining { end } else { time + direction * step };
            if let Err(found) = self.hold(bench, time, to, size) {
                reason = found.unwrap_or(reason);
                step *= 0.5;
                continue;
            }
            // E holds the motion for every shorter step too: the remainder may be made as small as it should be.
            let coefficient = |i: usize| bench.of_hull[i * (row + 1) + row];
            let largest = (0..n).map(|i| coefficient(i).magnitude()).fold(0.0, f64::max);
            let remainder = largest * power((to - time).abs(), row as u32);
            if remainder > tolerance {
                let factor = pxfm::f_exp(pxfm::f_log(tolerance / remainder) / row as f64);
                let shorter = time + direction * (0.98 * factor * (to - time).abs());
                if factor < 0.4 {
                    // A tighter E makes a longer step.
                    step *= (1.3 * factor).max(0.1);
                    continue;
                }
                if shorter != time {
                    to = shorter;
                }
            }
            let h = Interval::point(to) - now;
            if h.contains(0.0) {
                break;
            }
            let zero_to_h = h.hull(Interval::ZERO);
            let mut coefficients = Vec::with_capacity(n * (row + 1));
            let mut of_centre = Vec::with_capacity(n * ORDER);
            for i in 0..n {
                coefficients.extend_from_slice(&bench.of_set[i * row..(i + 1) * row]);
                coefficients.push(if faults::no_remainder() { Interval::ZERO } else { coefficient(i) });
                of_centre.extend_from_slice(&bench.of_point[i * row + 1..(i + 1) * row]);
            }
            let whole = coefficients.chunks_exact(row + 1).map(|c| polynomial(c, zero_to_h)).collect();
            let piece = Piece {
                from: time,
                to,
                coefficients,
                set: set.clone(),
                of_centre,
                of_derivatives: bench.of_set[n * row..].to_vec(),
                entries: Arc::clone(&self.entries),
                hull: whole,
            };
            let (shift, jacobian) = piece.map(h);
            return match set.image(&shift, &jacobian) {
                Some(next) => Ok((piece, next)),
                None => Err("the image of the set is not finite".to_owned()),
            };
        }
        Err(reason)
    }

    /// Finds a box that holds all motions until `to`, and expands the field over it: its coefficients are then in `of_hull`.
    fn hold(&self, bench: &mut Bench, time: f64, to: f64, size: f64) -> Result<(), Option<String>> {
        let n = self.dimension();
        let row = ORDER + 1;
        let s = Interval::point(to) - Interval::point(time);
        let s = s.hull(Interval::ZERO);
        let over = Interval::point(time).hull(Interval::point(to));
        let polynomials: Vec<Interval> = (0..n).map(|i| polynomial(&bench.of_set[i * row..(i + 1) * row], s)).collect();
        let guess = |i: usize| {
            let last = bench.of_set[i * row + ORDER].magnitude() * power(s.magnitude(), ORDER as u32);
            last + 1e-16 * size + f64::MIN_POSITIVE
        };
        let mut candidate: Vec<Interval> = (0..n).map(|i| polynomials[i].widened(1e-3, 4.0 * guess(i))).collect();
        for _ in 0..3 {
            if candidate.iter().any(|x| x.checked().is_err()) {
                return Err(None);
            }
            let grown = self.flow.expand(&mut bench.whole, row, over, &candidate, &mut bench.of_hull);
            if let Err((i, reason)) = grown {
                return Err(self.flow.names.get(i).map(|name| format!("the rate of {name} is {reason}")));
            }
            let mut power = s;
            (1..row).for_each(|_| power = power * s);
            let found: Vec<Interval> =
                (0..n).map(|i| polynomials[i] + bench.of_hull[i * (row + 1) + row] * power).collect();
            if found.iter().zip(&candidate).all(|(f, c)| c.encloses_strictly(*f)) {
                return self.sharpen(bench, time, to, &polynomials);
            }
            candidate = found.iter().zip(&candidate).map(|(f, c)| f.hull(*c).widened(0.05, guess(0))).collect();
        }
        Err(None)
    }

    /// Replaces the last coefficients by sharper ones. Once it is known that the motion exists and what its last coefficients
    /// are, the states of each part of the step are known better than their hull, and the last coefficients over the parts
    /// together hold for the step.
    fn sharpen(&self, bench: &mut Bench, time: f64, to: f64, polynomials: &[Interval]) -> Result<(), Option<String>> {
        let n = self.dimension();
        let row = ORDER + 1;
        // Where states hardly move, there is nothing to be gained.
        let moves =
            |i: usize| polynomials[i].width() > 0.05 * polynomials.iter().map(Interval::magnitude).fold(0.0, f64::max);
        if !(0..n).any(moves) {
            return Ok(());
        }
        let last: Vec<Interval> = (0..n).map(|i| bench.of_hull[i * (row + 1) + row]).collect();
        let mut sharper: Option<Vec<Interval>> = None;
        for part in 0..PARTS {
            let at = |k: usize| if k == PARTS { to } else { time + (to - time) * (k as f64 / PARTS as f64) };
            let over = Interval::point(at(part)).hull(Interval::point(at(part + 1)));
            let s = over - Interval::point(time);
            let mut power = s;
            (1..row).for_each(|_| power = power * s);
            let states: Vec<Interval> =
                (0..n).map(|i| polynomial(&bench.of_set[i * row..(i + 1) * row], s) + last[i] * power).collect();
            let grown = self.flow.expand(&mut bench.whole, row, over, &states, &mut bench.of_hull);
            if grown.is_err() {
                return Err(None);
            }
            let of_part = (0..n).map(|i| bench.of_hull[i * (row + 1) + row]);
            sharper = Some(match sharper {
                None => of_part.collect(),
                Some(all) => all.into_iter().zip(of_part).map(|(a, b)| a.hull(b)).collect(),
            });
        }
        for (i, (found, old)) in sharper.into_iter().flatten().zip(last).enumerate() {
            bench.of_hull[i * (row + 1) + row] = found.intersection(old).unwrap_or(old);
        }
        Ok(())
    }

    /// The step at which the last terms of the series are of the size of the remainder that is asked for.
    fn proposal(&self, coefficients: &[Interval], size: f64) -> f64 {
        let row = ORDER + 1;
        let top = |k: usize| (0..self.dimension()).map(|i| coefficients[i * row + k].magnitude()).fold(0.0, f64::max);
        let mut step = f64::INFINITY;
        for k in [ORDER - 1, ORDER] {
            let last = top(k);
            if last > 1e-280 && size > 0.0 {
                step = step.min(pxfm::f_exp(pxfm::f_log(4.0 * remainder_of_step() * size / last) / k as f64));
            }
        }
        step
    }
}

/// What the remainder of a step shall be, as a part of the largest state.
fn remainder_of_step() -> f64 {
    if faults::long_steps() { 1e-9 } else { REMAINDER }
}

/// xⁿ for x ≥ 0, roughly: it decides on lengths of steps and nothing else.
fn power(x: f64, n: u32) -> f64 {
    (0..n).fold(1.0, |p, _| p * x)
}
