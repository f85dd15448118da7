//! One validated step, and the sequence of them.
//!
//! **A step.** Let x̂ be the centre of the set of states at t₀, e₀ a difference of one of its states from x̂, p the Taylor
//! polynomial of the motion through x̂, nearly, and Φ that of the variational equation Φ′ = Df·Φ, Φ(t₀) = I. Both are
//! polynomials around the middle of the step, and nothing is assumed of them. A box E is guessed, and with Taylor models over
//! the step one finds
//!
//! - r ≥ |x̂ + ∫f(p) − p|, what p misses of being a solution;
//! - A ∋ Df(p + e) for all |e| ≤ E, and R ≥ |I + ∫AΦ − Φ|.
//!
//! *Then every motion from x̂ + e₀ exists on the step, is unique, and is p + Φe₀ + w with |w| ≤ W := exp(h|A|)(r + R|e₀|),
//! if |Φ||e₀| + W ≤ E.* For f(p + e) − f(p) = Ae for some A of these matrices (mean value theorem), so that the Picard
//! operator takes p + Φe₀ + w to p + Φe₀ + w̃ with |w̃(t)| ≤ r + R|e₀| + ∫|A||w|. It maps the continuous w with
//! |w(t)| ≤ exp((t − t₀)|A|)(r + R|e₀|) into themselves, and has a fixed point there (Schauder); f is Lipschitz on the convex
//! tube, so that there is one only (Picard, Lindelöf). This is the a-posteriori bound by defect and Gronwall's inequality
//! ([Walter 1970, ch. III]; [Hairer, Nørsett & Wanner 1993, §I.10]), with Φ to carry what was there before: nothing but w is
//! estimated by absolute values, and w is of the size of rounding.
//!
//! **Precision.** x̂ and the coefficients of p are double-double, and r is found with [`PreciseModel`]s: in binary64 it would
//! be a rounding of p at every step, which a motion near a separatrix amplifies a million times. The rest is in binary64
//! ([`TaylorModel`]), Φ of a low order: it multiplies e₀, which is small, and Φ's own errors R are part of W.
//!
//! The set then moves by e₀ ↦ Φ(t₀ + h)e₀ + w, see `set`.
//!
//! [Walter 1970, ch. III]: https://doi.org/10.1007/978-3-642-86405-6
//! [Hairer, Nørsett & Wanner 1993, §I.10]: https://doi.org/10.1007/978-3-540-78862-1

use super::set::{Set, faults};
use crate::definitions::fresh;
use crate::error::{FlowError, leaf_name};
use crate::taylor::Flow;
use expr::tape::{Slots, Tape};
use expr::{Expr, Graph, Leaf};
use number::{DoubleDouble, Interval, Jet, NoValue, Number, Precise, PreciseModel, Scalar, TaylorModel};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Order of the Taylor polynomials of p: with twice the precision, so many terms pay.
const POINT_ORDER: usize = 27;
/// Order of those of Φ, which carry what is small already: they need not be precise.
const ORDER: usize = 12;
/// The last terms of p shall be below this part of the largest state,
const REMAINDER: f64 = 1e-22;
/// or of the width of the set, whichever is larger.
const REMAINDER_TO_WIDTH: f64 = 1e-9;
/// The last terms of Φ.
const REMAINDER_OF_DERIVATIVE: f64 = 1e-7;
/// A step is made shorter, if that helps, when it adds more than this part of the largest state,
const ADDED: f64 = 2e-22;
/// and more than this part of the width of the set.
const ADDED_TO_WIDTH: f64 = 1e-6;
/// The part of the longest step after which states that pass 0 are looked at.
const SOON: f64 = 1e-6;
/// The set may become as wide as this part of the largest state.
const WIDEST: f64 = 0.5;
/// More than all roundings of a sum of a few hundred terms that are not negative, as a factor.
const UP: f64 = 1.0 + 1e-12;
/// Largest number of steps in one direction.
const MAX_STEPS: usize = 10_000;
/// Largest number of unknowns: a step multiplies matrices of their size, and each is kept.
pub(super) const MOST_UNKNOWNS: usize = 100;
/// After so many steps it is asked whether the end is within reach.
const OUTLOOK: usize = 100;

/// A vector field compiled for enclosures.
#[derive(Clone, Debug)]
pub(super) struct Field {
    /// Names of the states.
    names: Vec<String>,
    /// The field, and its partial derivatives that do not vanish, each with its row and column.
    rates: Flow,
    slopes: Tape,
    partial: Vec<(usize, usize)>,
    /// The field and its variational equations, as one field whose further states are the entries of Φ.
    variation: Flow,
    /// Row and column of every further state.
    entries: Arc<[(usize, usize)]>,
    constants: Vec<Precise>,
    driven: bool,
}

/// Why an enclosure ends. What was reached is kept.
#[derive(Clone, Debug, PartialEq, thiserror::Error, Serialize, Deserialize)]
pub enum Stop {
    /// The set of states has become so wide that nothing is left to be said.
    #[error("the enclosure is {width:.1e} wide at t = {}", number::six(*time))]
    TooWide {
        /// The time that was reached.
        time: f64,
        /// Largest width of a state there.
        width: f64,
    },
    /// No step could be validated, however short: a singularity is near, or the set is too wide.
    #[error("no step could be validated at t = {}, where the enclosure is {width:.1e} wide: {reason}", number::six(*time))]
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
        "t = {} is reached after {steps} validated steps, and the limit of {MAX_STEPS} is too few for the span; the \
         enclosure is {width:.1e} wide there", number::six(*time)
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
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Piece {
    /// Time at the start, and at the end (which is earlier for a step back).
    pub(super) from: f64,
    pub(super) to: f64,
    /// Half of the step, or a little more: p and Φ are polynomials in s, t = from + half·(1 + s).
    half: f64,
    /// The states at the start, p − x̂ and Φ.
    set: Set,
    moved: Vec<TaylorModel>,
    derivatives: Vec<TaylorModel>,
    /// Row and column of every derivative: those of the field.
    #[serde(skip)]
    entries: Arc<[(usize, usize)]>,
    /// W, and E: bounds of w, and of the distance of all motions from p.
    errors: Vec<f64>,
    spread: Vec<f64>,
    /// All states of the step.
    pub(super) hull: Vec<Interval>,
}

impl Piece {
    /// The states at all times of an interval that lies in the step.
    pub(super) fn at(&self, time: Interval) -> Vec<Interval> {
        let within = |found: Vec<Interval>| {
            let both = found.into_iter().zip(&self.hull);
            both.map(|(f, &hull)| f.intersection(hull).unwrap_or(hull)).collect()
        };
        if time.is_point() {
            let (shift, jacobian) = self.map(time - Interval::point(self.from));
            return within(self.set.hull_of_image(&shift, &jacobian));
        }
        match self.models(time.mid(), time.radius()) {
            Ok(models) => within(models.iter().map(TaylorModel::range).collect()),
            Err(_) => self.hull.clone(),
        }
    }

    /// The states over an interval of times that lies in the step, as models over it.
    pub(super) fn models(&self, middle: f64, half: f64) -> Result<Vec<TaylorModel>, NoValue> {
        let place = self.place(Interval::point(middle) - Interval::point(self.from));
        let (mut s, mut scaled) = (TaylorModel::ZERO, TaylorModel::ZERO);
        scaled.div(
            &(),
            &TaylorModel::variable(Interval::ZERO, half),
            &TaylorModel::constant(Interval::point(self.half)),
        )?;
        s.add(&(), &TaylorModel::constant(place), &scaled)?;
        let of = |((m, &spread), centre): ((&TaylorModel, &f64), &DoubleDouble)| {
            let mut sum = TaylorModel::ZERO;
            sum.add(&(), &m.after(&s)?, &TaylorModel::constant(Interval::point(centre.high())))?;
            Ok(sum.widened(spread + centre.low().abs()))
        };
        self.moved.iter().zip(&self.spread).zip(&self.set.centre).map(of).collect()
    }

    /// The s of a time after the start, which lies between −1 and 1.
    fn place(&self, after: Interval) -> Interval {
        let s = after / Interval::point(self.half) - Interval::point(1.0);
        let all = Interval::point(-1.0).hull(Interval::point(1.0));
        s.intersection(all).unwrap_or(all)
    }

    /// The map from the states at the start to those some time later, as [`Set::hull_of_image`] takes it.
    fn map(&self, after: Interval) -> (Vec<Interval>, Vec<Interval>) {
        let s = self.place(after);
        let shift = self.moved.iter().zip(&self.errors).map(|(m, &w)| m.at(s) + Interval::ball(0.0, w)).collect();
        (shift, self.jacobian(|phi| phi.at(s)))
    }

    /// Its derivative, from values of the entries of Φ.
    fn jacobian(&self, at: impl Fn(&TaylorModel) -> Interval) -> Vec<Interval> {
        let n = self.set.centre.len();
        let mut jacobian = vec![Interval::ZERO; n * n];
        for (phi, &(i, j)) in self.derivatives.iter().zip(self.entries.iter()) {
            jacobian[i * n + j] = at(phi);
        }
        jacobian
    }
}

/// Memory of the steps.
struct Bench {
    series: Slots<Jet<f64>>,
    /// Coefficients of the motion through the centre, and of the entries of Φ.
    coefficients: Vec<f64>,
    point: Slots<Jet<DoubleDouble>>,
    /// Coefficients of p.
    point_coefficients: Vec<DoubleDouble>,
    precise: Slots<PreciseModel>,
    rates: Slots<TaylorModel>,
    slopes: Slots<TaylorModel>,
}

/// What is known of all motions of a step: p − x̂, Φ, W, E, and their hull.
struct Tube {
    half: f64,
    moved: Vec<PreciseModel>,
    derivatives: Vec<TaylorModel>,
    errors: Vec<f64>,
    spread: Vec<f64>,
    hull: Vec<Interval>,
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
        constants: Vec<(Leaf, Precise)>,
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
        let mut places = vec![None; n * n];
        entries.iter().zip(&leaves).for_each(|(&(i, j), &leaf)| places[n * i + j] = Some(leaf));
        let entry = |i: usize, j: usize| places[n * i + j];
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
        let places = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let known = places.filter_map(|(i, j)| partial[i][j].map(|d| ((i, j), d)));
        let (partial, slopes): (Vec<(usize, usize)>, Vec<Expr>) = known.unzip();
        let slopes = Tape::compile(graph, &inputs(states), &slopes).map_err(|l| unknown(graph, l))?;
        let variation = Tape::compile(graph, &inputs(&extended), &all_rates).map_err(|l| unknown(graph, l))?;
        let driven = tape.instructions().iter().any(|i| i.a == 0 || i.b == 0);
        Ok(Field {
            names,
            rates: Flow::new(tape, states, Vec::new()),
            slopes,
            partial,
            variation: Flow::new(variation, &extended, Vec::new()),
            entries: entries.into(),
            constants: constants.into_iter().map(|c| c.1).collect(),
            driven,
        })
    }

    /// All that its steps depend on, but where they begin and end, as a text.
    pub(super) fn content(&self) -> String {
        let Field { names, rates, slopes, partial, variation, entries, constants, driven } = self;
        let (rates, slopes, variation) = (rates.content(), slopes.content(), variation.content());
        format!("{names:?} {rates} {slopes} {partial:?} {variation} {entries:?} {constants:?} {driven}")
    }

    /// Gives steps that were read what they share.
    pub(super) fn complete(&self, steps: &mut [Piece]) {
        steps.iter_mut().for_each(|piece| piece.entries = Arc::clone(&self.entries));
    }

    fn dimension(&self) -> usize {
        self.names.len()
    }

    /// The motions from `state` at `start` until `end`, and why they end earlier.
    pub(super) fn integrate(&self, start: f64, state: &[Precise], end: f64) -> (Vec<Piece>, Option<Stop>) {
        let (n, m) = (self.dimension(), self.entries.len());
        let middles: Vec<DoubleDouble> = self.constants.iter().map(Precise::centre).collect();
        let rounded: Vec<f64> = middles.iter().map(DoubleDouble::high).collect();
        let mut bench = Bench {
            series: self.variation.slots(ORDER, &rounded),
            coefficients: vec![0.0; (n + m) * (ORDER + 1)],
            point: self.rates.slots(POINT_ORDER, &middles),
            point_coefficients: vec![DoubleDouble::ZERO; n * (POINT_ORDER + 1)],
            precise: self.rates.tape.slots(&()),
            rates: self.rates.tape.slots(&()),
            slopes: self.slopes.slots(&()),
        };
        for (i, c) in self.constants.iter().enumerate() {
            bench.precise.set(1 + n + i, Ok(PreciseModel::constant(c)));
            for slots in [&mut bench.rates, &mut bench.slopes] {
                slots.set(1 + n + i, Ok(TaylorModel::constant(c.interval())));
            }
        }
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
        let hull = set.hull();
        let size = hull.iter().map(Interval::magnitude).fold(0.0, f64::max);
        let width = hull.iter().map(Interval::width).fold(0.0, f64::max);
        let one = |&(i, j): &(usize, usize)| if i == j { 1.0 } else { 0.0 };
        let centre = set.centre.iter().map(DoubleDouble::high);
        let extended: Vec<f64> = centre.chain(self.entries.iter().map(one)).collect();
        let expanded = self.variation.expand(&mut bench.series, ORDER, time, &extended, &mut bench.coefficients);
        expanded.map_err(|(i, reason)| self.no_rate(i, reason))?;
        let (now, out) = (DoubleDouble::point(time), &mut bench.point_coefficients);
        let expanded = self.rates.expand(&mut bench.point, POINT_ORDER, now, &set.centre, out);
        expanded.map_err(|(i, reason)| self.no_rate(i, reason))?;

        let direction = if end > time { 1.0 } else { -1.0 };
        let remaining = (end - time).abs();
        let longest = (end - start).abs() * if self.driven { 1.0 / 64.0 } else { 0.25 };
        // Where all states pass 0 at once, they are as large as they become soon.
        let rate = (0..n).map(|i| bench.coefficients[i * (ORDER + 1) + 1].abs()).fold(0.0, f64::max);
        let size = size.max(rate * longest * SOON);
        if width > WIDEST * size.max(f64::MIN_POSITIVE) {
            return Err("the set is too wide".to_owned());
        }
        let mut step = self.proposal(bench, size, width).min(longest);
        if step > 0.6 * remaining {
            step = if step >= remaining { remaining } else { 0.6 * remaining };
        }
        let smallest = (64.0 * f64::EPSILON * time.abs()).max(1e-9 * (end - start).abs()).min(remaining);
        let tolerance = (ADDED * size).max(ADDED_TO_WIDTH * width);
        let starts = set.radii();
        let mut reason = String::new();
        let mut found: Option<(f64, Tube)> = None;
        // Of a span of the smallest numbers a part may be 0.
        while step >= smallest.max(f64::from_bits(1)) {
            meter::charge(1_000);
            let to = if step >= remaining { end } else { on_grid(time + direction * step, step) };
            match self.hold(bench, &set.centre, &starts, time, to) {
                Ok(tube) => {
                    // Of two steps the shorter one, if it adds less in proportion.
                    let added = tube.errors.iter().copied().fold(0.0, f64::max);
                    let better = found
                        .as_ref()
                        .is_none_or(|(_, longer)| added < 0.45 * longer.errors.iter().copied().fold(0.0, f64::max));
                    if better {
                        found = Some((to, tube));
                    }
                    if !better || added <= tolerance || faults::short_series() {
                        break;
                    }
                }
                Err(why) => reason = why,
            }
            step *= 0.5;
        }
        let Some((to, tube)) = found else { return Err(reason) };
        // T(x̂) − x̂ at the end; where the length of the step is not a binary number, s = 1 is a little later.
        let exact = Interval::point(to) - Interval::point(time);
        let gap = (Interval::point(exact.width()) / Interval::point(tube.half.abs())).hi();
        let errors = if faults::no_remainder() { vec![0.0; n] } else { tube.errors };
        let shift = |(m, &w): (&PreciseModel, &f64)| {
            let beyond = if exact.is_point() { 0.0 } else { m.change_before_end(gap) };
            let end = m.at_end();
            Precise::new(end.centre(), (end.error() + w + beyond) * UP)
        };
        let shift: Vec<Precise> = tube.moved.iter().zip(&errors).map(shift).collect();
        let piece = Piece {
            from: time,
            to,
            half: tube.half,
            set: set.clone(),
            moved: tube.moved.iter().map(PreciseModel::rounded).collect(),
            derivatives: tube.derivatives,
            entries: Arc::clone(&self.entries),
            errors,
            spread: tube.spread,
            hull: tube.hull,
        };
        let jacobian = match exact.is_point() {
            true => piece.jacobian(TaylorModel::at_end),
            false => piece.jacobian(|phi| phi.at(piece.place(exact))),
        };
        match set.image(&shift, &jacobian) {
            Some(next) => Ok((piece, next)),
            None => Err("the image of the set is not finite".to_owned()),
        }
    }

    fn no_rate(&self, i: usize, reason: NoValue) -> String {
        match self.names.get(i) {
            Some(name) => format!("the rate of {name} is {reason}"),
            None => format!("a derivative of a rate is {reason}"),
        }
    }

    /// Finds bounds W and E that hold for all motions until `to`, as the module says; `starts` is |e₀|.
    fn hold(
        &self,
        bench: &mut Bench,
        centre: &[DoubleDouble],
        starts: &[f64],
        time: f64,
        to: f64,
    ) -> Result<Tube, String> {
        let n = self.dimension();
        let row = ORDER + 1;
        let shape = |reason: NoValue| format!("no box was found that holds the motion: a bound is {reason}");
        let exact = Interval::point(to) - Interval::point(time);
        if exact.contains(0.0) {
            return Err("the step is too short".to_owned());
        }
        // At least as long as the step.
        let h = if to > time { exact.hi() } else { exact.lo() };
        let half = 0.5 * h;
        let polynomial = |c: &[f64]| TaylorModel::close_to(c, h).map_err(shape);
        let no_rate = |(i, reason)| self.no_rate(i, reason);
        // p without x̂.
        let terms = if faults::short_series() { 8 } else { POINT_ORDER };
        let from_zero =
            |c: &[DoubleDouble]| PreciseModel::close_to(&[&[DoubleDouble::ZERO], &c[1..=terms]].concat(), h);
        let point = bench.point_coefficients.as_chunks::<{ POINT_ORDER + 1 }>().0.iter();
        let moved: Vec<PreciseModel> = point.map(|c| from_zero(c)).collect::<Result<_, _>>().map_err(shape)?;
        let from = |(m, &c): (&PreciseModel, &DoubleDouble)| {
            let mut sum = PreciseModel::ZERO;
            sum.add(&(), m, &PreciseModel::constant(&Precise::new(c, 0.0))).map(|()| sum).map_err(shape)
        };
        let precise: Vec<PreciseModel> = moved.iter().zip(centre).map(from).collect::<Result<_, _>>()?;
        let middle = Precise::new(DoubleDouble::new(time, half), 0.0);
        let now = PreciseModel::variable(&middle, half);
        let rates = run(&self.rates.tape, &mut bench.precise, now, precise.iter().copied()).map_err(no_rate)?;
        let mut defects = vec![0.0; n];
        for ((defect, rate), moved) in defects.iter_mut().zip(&rates).zip(&moved) {
            let mut left = PreciseModel::ZERO;
            left.sub(&(), &rate.integral(half), moved).map_err(shape)?;
            *defect = left.bound();
        }

        let now = now.rounded();
        let states: Vec<TaylorModel> = precise.iter().map(PreciseModel::rounded).collect();
        let rows = bench.coefficients.chunks_exact(row);
        let phi: Vec<TaylorModel> = rows.skip(n).map(polynomial).collect::<Result<_, _>>()?;
        let mut carried = vec![0.0; n];
        for (model, &(i, j)) in phi.iter().zip(self.entries.iter()) {
            carried[i] += model.bound() * starts[j] * UP;
        }
        let size = states.iter().map(TaylorModel::bound).fold(0.0, f64::max);
        let mut spread: Vec<f64> =
            carried.iter().zip(&defects).map(|(c, d)| 1.5 * c + 4.0 * d + 1e-15 * size + f64::MIN_POSITIVE).collect();
        for _ in 0..4 {
            let tube = || states.iter().zip(&spread).map(|(x, &e)| x.widened(e));
            // The field must have values in the whole tube, also where its derivatives would.
            run(&self.rates.tape, &mut bench.rates, now, tube()).map_err(no_rate)?;
            let slopes = run(&self.slopes, &mut bench.slopes, now, tube());
            let slopes = slopes.map_err(|(_, reason)| self.no_rate(n, reason))?;
            let errors = self.errors(&slopes, &phi, &defects, starts, half).map_err(shape)?;
            if errors.iter().zip(&carried).zip(&spread).all(|((w, c), e)| (w + c) * UP <= *e) {
                let hull = states.iter().zip(&spread).map(|(x, &e)| x.widened(e).range()).collect();
                return Ok(Tube { half, moved, derivatives: phi, errors, spread, hull });
            }
            spread = errors.iter().zip(&carried).map(|(w, c)| 1.5 * (w + c)).collect();
            if spread.iter().any(|e| !e.is_finite()) {
                break;
            }
        }
        Err("no box was found that holds the motion".to_owned())
    }

    /// W = exp(h|A|)(r + R|e₀|).
    fn errors(
        &self,
        slopes: &[TaylorModel],
        phi: &[TaylorModel],
        defects: &[f64],
        starts: &[f64],
        half: f64,
    ) -> Result<Vec<f64>, NoValue> {
        let n = self.dimension();
        let mut place = vec![None; n * n];
        self.entries.iter().enumerate().for_each(|(at, &(i, j))| place[i * n + j] = Some(at));
        let mut sums = vec![TaylorModel::ZERO; self.entries.len()];
        for (slope, &(i, k)) in slopes.iter().zip(&self.partial) {
            for j in 0..n {
                let (Some(of), Some(to)) = (place[k * n + j], place[i * n + j]) else { continue };
                let (mut product, before) = (TaylorModel::ZERO, sums[to]);
                product.mul(&(), slope, &phi[of])?;
                sums[to].add(&(), &before, &product)?;
            }
        }
        let mut total = defects.to_vec();
        for ((sum, phi), &(i, j)) in sums.iter().zip(phi).zip(self.entries.iter()) {
            let start = if i == j { 1.0 } else { 0.0 };
            total[i] += defect_of(sum, half, phi, start)? * starts[j] * UP;
        }
        total.iter_mut().for_each(|t| *t *= UP);
        // The series of the exponential; of its terms, from some on, each is at most half of the one before.
        let sizes: Vec<f64> = slopes.iter().map(|s| s.bound() * 2.0 * half.abs() * UP).collect();
        let mut rows = vec![0.0; n];
        sizes.iter().zip(&self.partial).for_each(|(s, &(i, _))| rows[i] += s);
        let norm = rows.iter().copied().fold(0.0, f64::max) * UP;
        let mut term = total.clone();
        let mut k = 0.0;
        loop {
            k += 1.0;
            let mut next = vec![0.0; n];
            sizes.iter().zip(&self.partial).for_each(|(s, &(i, j))| next[i] += s * term[j]);
            term = next.iter().map(|x| x / k * UP).collect();
            total.iter_mut().zip(&term).for_each(|(t, x)| *t += x);
            let largest = term.iter().copied().fold(0.0, f64::max);
            let smallest = total.iter().copied().fold(f64::INFINITY, f64::min);
            if norm <= 0.5 * (k + 1.0) && (largest <= 1e-3 * smallest || k > 40.0) {
                total.iter_mut().for_each(|t| *t = (*t + 2.0 * largest) * UP);
                return Ok(total);
            }
            if k > 400.0 || largest.is_nan() {
                return Err(NoValue::Indeterminate);
            }
        }
    }

    /// The step at which the last terms of the series, and what models of them leave out, are as small as they should be.
    fn proposal(&self, bench: &Bench, size: f64, width: f64) -> f64 {
        let mut step = f64::INFINITY;
        let mut limit = |last: f64, most: f64, order: usize, reach: f64| {
            if last > 1e-280 && most > 0.0 {
                step = step.min(reach * pxfm::f_exp(pxfm::f_log(most / last) / order as f64));
            }
        };
        let most = (REMAINDER * size).max(REMAINDER_TO_WIDTH * width);
        let rows = || bench.point_coefficients.as_chunks::<{ POINT_ORDER + 1 }>().0.iter();
        // Around its middle a step reaches half as far.
        for (k, reach) in [(PreciseModel::DEGREE + 1, 2.0), (POINT_ORDER - 1, 1.0), (POINT_ORDER, 1.0)] {
            limit(rows().map(|c| c[k].high().abs()).fold(0.0, f64::max), most, k, reach);
        }
        let rows = || bench.coefficients.as_chunks::<{ ORDER + 1 }>().0.iter().skip(self.dimension());
        for (k, reach) in [(ORDER - 1, 1.0), (ORDER, 1.0)] {
            limit(rows().map(|c| c[k].abs()).fold(0.0, f64::max), REMAINDER_OF_DERIVATIVE, k, reach);
        }
        step
    }
}

/// Runs a tape over models of the states.
fn run<N: Number<Context = ()>>(
    tape: &Tape,
    slots: &mut Slots<N>,
    time: N,
    states: impl Iterator<Item = N>,
) -> Result<Vec<N>, (usize, NoValue)> {
    slots.set(0, Ok(time));
    states.enumerate().for_each(|(i, x)| slots.set(1 + i, Ok(x)));
    tape.run(&(), slots);
    (0..tape.output_count()).map(|i| tape.output(i, slots).cloned().map_err(|reason| (i, reason))).collect()
}

/// A time near a given one that is a multiple of a millionth of the step, or less: the difference of two such times is a
/// binary number.
fn on_grid(time: f64, step: f64) -> f64 {
    let exponent = (step.to_bits() >> 52).saturating_sub(20).max(1);
    let grid = f64::from_bits(exponent << 52);
    let near = (time / grid).round() * grid;
    if near.is_finite() { near } else { time }
}

/// A bound of |x₀ + ∫rate − x| over a step.
fn defect_of(rate: &TaylorModel, half: f64, x: &TaylorModel, start: f64) -> Result<f64, NoValue> {
    let (mut moved, mut left) = (TaylorModel::ZERO, TaylorModel::ZERO);
    // First what nearly cancels, so that little is lost to rounding.
    moved.sub(&(), x, &TaylorModel::constant(Interval::point(start)))?;
    left.sub(&(), &rate.integral(half), &moved)?;
    Ok(left.bound())
}
