//! Independence of functions of the state.
//!
//! Functions f₁ … f_k are independent at a point of the set on which constraints g hold when their gradients are linearly
//! independent of one another and of those of the constraints: rank(∇g, ∇f) = rank(∇g) + k. The gradients are exact
//! derivatives of the expressions; the rank is read off singular values of the matrix with normalised rows.
//!
//! A singular value that is 0 within rounding may be one of 10⁻²⁰: elimination with error bounds may still tell that the rank is full,
//! and nothing but exact numbers tells that it is not. What is between the two is undecided by samples.

use std::cmp::Ordering;

use nalgebra::DMatrix;

use crate::derivation::{Claim, Form, Motion, Trajectory, Written};
use crate::describe::Left;
use crate::expr::tape::Tape;
use crate::expr::{Expr, Graph, Leaf, NoDerivative, Tensor};
use crate::flow::{Rapid, VectorField};
use crate::latex::{Role, Scope, Statement};
use crate::number::{Bounded, NoValue, Rational};
use crate::pointwise::Tried;
use crate::stretches::is_met;
use crate::systems::Fields;
use crate::trace::Trial;
use crate::verdict::{Evidence, Finding, Possible, Witness};
use claim::comparison::{GUARD, traced_now};
use reason::{Plain, Reason, Sampling};

/// Singular values below this share of the largest count as zero.
const ZERO: f64 = 5e-15;
/// Singular values above this share of the largest count as nonzero; between the two nothing is concluded.
const NONZERO: f64 = 1e-6;
/// Most minima of the smallest singular value that are followed between samples.
const MINIMA: usize = 12;
/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// How far beside an event the rank is taken, too: this share of the span.
const BESIDE: f64 = 1e-3;
/// Number of sample times at which the rank is taken.
const POINTS: usize = 33;

/// The gradients of constraints and functions, ready to be evaluated.
#[derive(Clone, Debug)]
pub struct Gradients {
    constraints: usize,
    functions: usize,
    variables: Vec<Leaf>,
    entries: Vec<Expr>,
    text: String,
}

impl Gradients {
    /// The gradients that a claim asks for; `None` if it asks for none. A rate that a system gives is what it gives; on motions by
    /// formulas, without a system, rates are variables of their own.
    ///
    /// # Errors
    /// A function without a derivative among the known operations; rates that several systems give differently.
    pub fn of_claim(
        graph: &mut Graph,
        trajectories: &[Trajectory],
        claim: &Claim,
        fields: &Fields,
    ) -> Option<Result<Gradients, Reason>> {
        let (functions, subject_to) = claim.forms.iter().find_map(|form| match form {
            Form::Independent { functions, subject_to } => Some((functions, subject_to)),
            _ => None,
        })?;
        let system = |t: &usize| match trajectories[*t].motion {
            Motion::Integrated { system, .. } => Some(system),
            Motion::Formula { .. } | Motion::Derived { .. } => None,
        };
        let mut systems: Vec<Option<usize>> = claim.trajectories.iter().map(system).collect();
        systems.sort_unstable();
        systems.dedup();
        let mut found: Option<Gradients> = None;
        for system in systems {
            let field = system.map(|s| &fields.all()[s]);
            let one = Gradients::new(graph, &claim.scope, field, &fields.state_leaves, functions, subject_to);
            let one = match one {
                Ok(one) => one,
                Err(reason) => return Some(Err(reason)),
            };
            if found.as_ref().is_some_and(|f| (&f.variables, &f.entries) != (&one.variables, &one.entries)) {
                return Some(Err(Plain::RatesOfSystemsDiffer.into()));
            }
            found = Some(one);
        }
        found.map(Ok)
    }

    /// Gradients on the motions of one system, or of none.
    fn new(
        graph: &mut Graph,
        scope: &Scope,
        field: Option<&VectorField>,
        states: &[Leaf],
        functions: &[Written<Tensor>],
        subject_to: &[Written<Statement>],
    ) -> Result<Gradients, Reason> {
        let mut rows: Vec<Expr> = Vec::new();
        for relation in subject_to.iter().flat_map(|w| &w.value.relations) {
            for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
                rows.push(graph.sub(l, r));
            }
        }
        let constraints = rows.len();
        rows.extend(functions.iter().flat_map(|w| &w.value.components));
        for row in &mut rows {
            *row = traced_now(graph, scope, *row);
            if let Some(field) = field {
                *row = with_rates(graph, field, *row);
            }
        }
        let mut variables = states.to_vec();
        let moves = |l: &Leaf| l.instant.is_none() && l.rate > 0 && scope.role(l.symbol) == Some(Role::State);
        if field.is_none() {
            variables.extend(graph.leaves(rows.iter().copied()).into_iter().filter(moves));
            variables.sort_unstable();
            variables.dedup();
        }
        if let Some(leaf) = graph.leaves(rows.iter().copied()).iter().find(|l| moves(l) && !variables.contains(l)) {
            return Err(Sampling::NoRate(leaf.rate.into()).into());
        }
        let mut entries = Vec::new();
        for &row in &rows {
            for &variable in &variables {
                let slope = graph.partial_derivative(row, variable).map_err(|e: NoDerivative| Reason::quoted(e))?;
                // Where a function has no value, it has no gradient.
                entries.push(graph.rate_of(row, slope, |_| false));
            }
        }
        let names: Vec<&str> = functions.iter().map(|w| w.text.as_str()).collect();
        let text = format!("rank of the gradients of {}", names.join(", "));
        Ok(Gradients { constraints, functions: rows.len() - constraints, variables, entries, text })
    }

    /// The number of constraints, and the gradients: those of the constraints first.
    pub fn rows(&self) -> (usize, Vec<&[Expr]>) {
        (self.constraints, self.entries.chunks(self.variables.len().max(1)).collect())
    }

    /// That so many of its functions are independent at a time, and not all.
    pub fn witness(&self, t: f64, independent: usize) -> Witness {
        let (left, right) = (independent as f64, self.functions as f64);
        Witness { t, formula: self.text.clone(), left, right, bound: 0.0, values: vec![] }
    }

    /// The leaves that must be known.
    pub fn leaves(&self, graph: &Graph) -> Vec<Leaf> {
        graph.leaves(self.entries.iter().copied())
    }
}

/// A function with the rates that a system gives put in. Higher rates than those stay.
fn with_rates(graph: &mut Graph, field: &VectorField, e: Expr) -> Expr {
    graph.substitute(e, |_, leaf| {
        let below = Leaf { rate: leaf.rate.checked_sub(1)?, ..leaf };
        let given = leaf.instant.is_none() && !field.states().contains(&leaf);
        let at = field.states().iter().position(|s| given && *s == below)?;
        field.rates().get(at).copied()
    })
}

/// Tries the independence along a motion.
pub(super) fn try_on(of: &Gradients, trial: &Trial, tried: &Tried) -> Finding {
    let Trial { graph, trace, .. } = *trial;
    let Ok(tape) = Tape::compile(graph, trace.leaves, &of.entries) else {
        return Finding::open(Plain::FunctionsUnknown);
    };
    let mut slots = tape.slots::<Bounded>(&());
    let mut evidence = Evidence::default();
    let step = (tried.points.len() / POINTS).max(1);
    let (mut unclear, mut smallest) = (None, f64::INFINITY);
    let (mut dependent, mut certain) = (0, 0);
    let mut selected = 0;
    // Spread over the times that count.
    let counting: Vec<usize> = (0..tried.times.len()).filter(|&i| tried.left[i] == Left::In).collect();
    let spread = if counting.len() < POINTS * 2 { 1 } else { step.min(counting.len() / POINTS) };
    for &i in counting.iter().step_by(spread.max(1)) {
        let t = tried.times[i];
        selected += 1;
        let values = tape.evaluate(&(), &tried.points.row(i), &mut slots);
        let Ok(values) = values.into_iter().collect::<Result<Vec<Bounded>, _>>() else { continue };
        let (n, rows) = (of.variables.len(), of.constraints + of.functions);
        let all = normalised(rows, n, &values);
        let some = normalised(of.constraints, n, &values[..of.constraints * n]);
        let (full, full_gap) = rank(&all);
        let (base, base_gap) = rank(&some);
        evidence.samples += 1;
        smallest = smallest.min(full_gap);
        match (full, base) {
            (Some(full), Some(base)) if full == base + of.functions => {}
            (Some(_), Some(_)) if is_independent(rows, n, &values) => {}
            (Some(full), Some(base)) => {
                let found = full.saturating_sub(base);
                dependent += 1;
                certain += usize::from(is_dependent(of, base, &values));
                evidence.witness.get_or_insert_with(|| of.witness(t, found));
                let why = Sampling::Dependent { rank: found, of: of.functions };
                evidence.reason.get_or_insert(why.into());
            }
            (None, _) if is_independent(rows, n, &values) => {}
            _ => unclear = Some((t, full_gap.min(base_gap))),
        }
    }
    if dependent > 0 && dependent == evidence.samples {
        if certain < dependent {
            let rank = evidence.witness.as_ref().map_or(0.0, |w| w.left) as usize;
            return Finding::open(Sampling::RankBelowPrecision { rank, of: of.functions });
        }
        // The time of an event is a number of binary64: the rank that falls there alone may be whole at the event itself.
        if trial.program.at.is_some() && !dependent_beside(of, trial, &tape, evidence.witness.as_ref()) {
            return Finding::open(Plain::RankFallsAtEvent);
        }
        return Finding::sampled(Possible::FALSE, evidence);
    }
    if dependent > 0 {
        return Finding::open(Sampling::SometimesDependent { count: dependent, of: evidence.samples });
    }
    if let Some((t, gap)) = unclear {
        return Finding::open(Sampling::RankUnclear { t, size: gap });
    }
    if evidence.samples == 0 {
        let out = |l: &Left| match l {
            Left::Out(reason) | Left::Open(reason) => Some(Reason::clone(reason)),
            Left::In => None,
        };
        let open = tried.left.iter().any(|l| matches!(l, Left::Open(_)));
        return match (selected, open) {
            (0, false) => {
                let reason = tried.left.iter().find_map(out);
                let reason = reason.unwrap_or(Plain::NoTimeToTryIndependence.into());
                Finding::sampled(Possible::VOID, Evidence::because(reason))
            }
            (0, true) => Finding::open(Plain::NoTimeKnownToCountThere),
            _ => Finding::open(Plain::NoGradientAnywhere),
        };
    }
    let open = |l: &Left| match l {
        Left::Open(reason) => Some(Reason::clone(reason)),
        Left::In | Left::Out(_) => None,
    };
    if let Some(reason) = tried.left.iter().find_map(open) {
        return Finding::open(reason);
    }
    let rapid = trial.trace.rapid(&trial.program.rapid);
    if rapid.unresolved.is_some() {
        return Finding::open(Plain::TooManyPeaks);
    }
    if let Some((t, gap)) = lost_between(of, trial, tried, &tape, &rapid) {
        return Finding::open(Sampling::RankFalls { t, size: gap });
    }
    evidence.reason = Some(Sampling::SmallestSingularValue(smallest).into());
    Finding::sampled(Possible::TRUE, evidence)
}

/// Whether the functions are dependent also a little before and after a time.
fn dependent_beside(of: &Gradients, trial: &Trial, tape: &Tape, witness: Option<&Witness>) -> bool {
    let Some(t) = witness.map(|w| w.t) else { return false };
    let (from, to) = trial.trace.stage.span(trial.trace.trajectory);
    let (n, rows) = (of.variables.len(), of.constraints + of.functions);
    let mut slots = tape.slots::<Bounded>(&());
    let beside = [-BESIDE, BESIDE].map(|d| t + d * (to - from)).into_iter().filter(|t| (from..=to).contains(t));
    beside.into_iter().all(|t| {
        let values = tape.evaluate(&(), &trial.trace.values(t), &mut slots);
        let Ok(values) = values.into_iter().collect::<Result<Vec<Bounded>, _>>() else { return false };
        let base = rank(&normalised(of.constraints, n, &values[..of.constraints * n])).0;
        let full = rank(&normalised(rows, n, &values)).0;
        full.zip(base).is_some_and(|(full, base)| full < base + of.functions)
    })
}

/// A time between samples near which the rank may fall, with the smallest singular value in units of the largest: where it is
/// smallest among samples, it is followed by the golden section; where something varies rapidly, it is looked at.
fn lost_between(of: &Gradients, trial: &Trial, tried: &Tried, tape: &Tape, rapid: &Rapid) -> Option<(f64, f64)> {
    if trial.program.at.is_some() {
        return None;
    }
    let mut slots = tape.slots::<Bounded>(&());
    let (n, rows) = (of.variables.len(), of.constraints + of.functions);
    let mut gradients = |point: &[Result<Bounded, NoValue>]| {
        tape.evaluate(&(), point, &mut slots).into_iter().collect::<Result<Vec<Bounded>, _>>().ok()
    };
    let at_samples: Vec<Option<Vec<Bounded>>> =
        (0..tried.times.len()).map(|i| gradients(&tried.points.row(i))).collect();
    // The lengths of gradients, which normalised rows do not show: against the longest of each along the motion.
    let lengths = |values: &[Bounded]| -> Vec<f64> {
        values.chunks(n.max(1)).map(|row| row.iter().map(|x| x.value * x.value).sum::<f64>().sqrt()).collect()
    };
    let mut longest = vec![0.0_f64; rows];
    for values in at_samples.iter().flatten() {
        longest.iter_mut().zip(lengths(values)).for_each(|(most, now)| *most = most.max(now));
    }
    // Redundant constraints are no loss.
    let smallest = |values: &[Bounded]| -> Option<f64> {
        let shrunk = lengths(values).into_iter().zip(&longest).skip(of.constraints);
        let shrunk = shrunk.filter(|(_, most)| **most > 0.0).map(|(now, most)| now / most).fold(1.0, f64::min);
        let base = rank(&normalised(of.constraints, n, &values[..of.constraints * n])).0?;
        let mut all: Vec<f64> = normalised(rows, n, values).0.singular_values().iter().copied().collect();
        all.sort_by(|a, b| b.total_cmp(a));
        let wanted = base + of.functions;
        Some(if wanted > all.len() { 0.0 } else { shrunk * all[wanted - 1] / all[0].max(f64::MIN_POSITIVE) })
    };
    let mut at = |t: f64| smallest(&gradients(&trial.trace.values(t))?);
    // The samples, and the times between them.
    let sampled = at_samples.iter().map(|values| values.as_deref().and_then(smallest));
    let sampled = sampled.enumerate().map(|(i, size)| (tried.times[i], size, tried.left[i] == Left::In));
    let mut along: Vec<(f64, Option<f64>, bool)> = sampled.collect();
    let between = rapid.times.iter().chain(&rapid.singular);
    along.extend(between.map(|&t| (t, at(t), is_met(trial, t))));
    along.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Where it goes on towards 0 at the rate that it has beside the smallest value, does it lose half of that?
    let may_vanish = |[(a, fa), (t, f), (b, fb)]: [(f64, f64); 3]| {
        let falls = |slope: f64, room: f64| (slope * room).partial_cmp(&(0.5 * f)).is_none_or(Ordering::is_gt);
        falls((fa - f) / (t - a), b - t) || falls((fb - f) / (b - t), t - a)
    };
    let mut lowest: Vec<[(f64, f64); 3]> = along
        .windows(3)
        .filter(|of| of[1].2)
        .filter_map(|of| Some([(of[0].0, of[0].1?), (of[1].0, of[1].1?), (of[2].0, of[2].1?)]))
        .filter(|[a, least, b]| least.1 <= a.1 && least.1 <= b.1 && may_vanish([*a, *least, *b]))
        .collect();
    lowest.sort_by(|[_, a, _], [_, b, _]| a.1.total_cmp(&b.1));
    for [start, mut least, end] in lowest.into_iter().take(MINIMA) {
        let (mut a, mut b) = (start.0, end.0);
        // Where a selector may change, the loss is at a time that does not count.
        if changes(trial, (a, b)) {
            continue;
        }
        // One of the two times within is also one of the next.
        let within = |a: f64, b: f64| (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
        let (mut x, mut y) = within(a, b);
        let (mut u, mut v) = (at(x), at(y));
        for _ in 0..60 {
            let (Some(left), Some(right)) = (u, v) else { break };
            for (t, size) in [(x, left), (y, right)] {
                if size < least.1 {
                    least = (t, size);
                }
            }
            if left < right {
                (b, y, v) = (y, x, u);
                x = within(a, b).0;
                u = at(x);
            } else {
                (a, x, u) = (x, y, v);
                y = within(a, b).1;
                v = at(y);
            }
        }
        if least.1 <= NONZERO {
            return Some(least);
        }
    }
    None
}

/// Whether the sides of a selector change their order between two times.
fn changes(trial: &Trial, (a, b): (f64, f64)) -> bool {
    let program = trial.program;
    let points = trial.trace.points_at(program, &[a, b]);
    let selected = program.selectors.iter().map(|s| s.part.group.comparisons.len()).sum();
    program.measure((&points, 2), 1.0).iter().take(selected).any(|series| {
        let signs = [0, 1].map(|i| series.difference(i).ok().map(|d| d.value.signum()));
        signs[0] != signs[1]
    })
}

/// Whether rows are independent for certain: by elimination with error bounds, in which every pivot is different from 0.
fn is_independent(rows: usize, columns: usize, values: &[Bounded]) -> bool {
    let mut left: Vec<Vec<Bounded>> = values.chunks(columns.max(1)).take(rows).map(<[Bounded]>::to_vec).collect();
    while let Some(mut row) = left.pop() {
        // Of the entries that are different from 0 for certain, that which is known best.
        let known = |x: &Bounded| if x.contains_zero() { f64::INFINITY } else { x.error / x.value.abs() };
        let pivot = (0..columns).min_by(|&i, &j| {
            let by_size = || row[j].value.abs().total_cmp(&row[i].value.abs());
            known(&row[i]).total_cmp(&known(&row[j])).then_with(by_size)
        });
        let Some(pivot) = pivot.filter(|&i| known(&row[i]).is_finite()) else { return false };
        for other in &mut left {
            if other[pivot] == Bounded::exact(0.0) {
                continue;
            }
            let factor = other[pivot] / row[pivot];
            for (x, of) in other.iter_mut().zip(&row) {
                *x = *x - factor * *of;
            }
            other[pivot] = Bounded::exact(0.0);
        }
        row.clear();
    }
    true
}

/// Whether functions are dependent for certain, where the constraints have this rank: there are more rows than columns, a function has
/// no gradient but 0, or all numbers are exact.
fn is_dependent(of: &Gradients, base: usize, values: &[Bounded]) -> bool {
    let (n, wanted) = (of.variables.len(), base + of.functions);
    let constraints = &values[..of.constraints * n];
    // A state that no function names is no place for a gradient.
    let used = (0..n).filter(|&j| values.iter().skip(j).step_by(n).any(|x| *x != Bounded::exact(0.0))).count();
    let is_zero = |row: &[Bounded]| row.iter().all(|x| *x == Bounded::exact(0.0));
    let exact_rank = |values: &[Bounded]| {
        let exact = |x: &Bounded| Rational::try_from(x.value).ok().filter(|_| x.error == 0.0);
        let rows = values.chunks(n.max(1)).map(|row| row.iter().map(exact).collect());
        rows.collect::<Option<Vec<Vec<Rational>>>>().map(exact_rank)
    };
    let more_than_columns =
        wanted > used && is_independent(base.min(of.constraints), n, constraints) && base == of.constraints;
    more_than_columns
        || values[of.constraints * n..].chunks(n.max(1)).any(is_zero)
        || exact_rank(values).zip(exact_rank(constraints)).is_some_and(|(full, base)| full < base + of.functions)
}

/// The rank of rows of rational numbers.
pub fn exact_rank(mut rows: Vec<Vec<Rational>>) -> usize {
    let columns = rows.first().map_or(0, Vec::len);
    let mut rank = 0;
    for column in 0..columns {
        let Some(pivot) = (rank..rows.len()).find(|&i| rows[i][column] != Rational::ZERO) else { continue };
        rows.swap(rank, pivot);
        let (done, rest) = rows.split_at_mut(rank + 1);
        let pivot = &done[rank];
        for row in rest.iter_mut().filter(|row| row[column] != Rational::ZERO) {
            let factor = &row[column] / &pivot[column];
            for (x, of) in row.iter_mut().zip(pivot) {
                *x -= &factor * of;
            }
        }
        rank += 1;
    }
    rank
}

/// Gradients with rows scaled to length 1, and how far the whole may be off; rows of zeros stay.
fn normalised(rows: usize, columns: usize, values: &[Bounded]) -> (DMatrix<f64>, f64) {
    let mut m = DMatrix::from_fn(rows, columns, |i, j| values[i * columns + j].value);
    let mut off = 0.0_f64;
    for (mut row, of) in m.row_iter_mut().zip(values.chunks(columns.max(1))) {
        let (length, error) = (row.norm(), of.iter().map(|x| x.error).fold(0.0, f64::hypot));
        if length > 0.0 {
            row /= length;
        }
        // A row that may vanish has any direction.
        off = off.hypot(if error == 0.0 {
            0.0
        } else if error < length {
            error / length
        } else {
            f64::INFINITY
        });
    }
    (m, off)
}

/// Rank, or `None` when a singular value lies in between, or no farther from 0 than errors reach; with the smallest one that is not
/// zero.
fn rank((m, off): &(DMatrix<f64>, f64)) -> (Option<usize>, f64) {
    if m.nrows() == 0 {
        return (Some(0), f64::INFINITY);
    }
    let values = m.clone().singular_values();
    let largest = values.max();
    let gap = values.iter().copied().filter(|&s| s > ZERO * largest).fold(f64::INFINITY, f64::min);
    let sure = values.iter().filter(|&&s| s > (NONZERO * largest).max(GUARD * off)).count();
    let zero = values.iter().filter(|&&s| s <= ZERO * largest).count();
    ((sure + zero == values.len()).then_some(sure), gap)
}
