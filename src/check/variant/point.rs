//! Random points at which residuals are compared.
//!
//! **In:** the formulas of a claim and of its variants as a program. **Out:** values of everything at points that are drawn:
//! every state, rate, parameter and value at a fixed time by itself, observables from their definitions.
//!
//! Where the equations that a claim assumes shall hold, a drawn point is moved to the nearest one at which they do (Newton's
//! method, the shortest step): it is known to some units in the last place, and so are the values there.

use nalgebra::{DMatrix, DVector};

use super::battery::{Battery, Outputs, Value};
use super::equivalence::SEED;
use crate::check::comparison::{at_instant, traced};
use crate::derivation::{Claim, Derivation};
use crate::expr::{Expr, Graph, Leaf};
use crate::latex::{RelationKind, Role};
use crate::number::{Bounded, Draws};
use crate::tape::Tape;

/// Points at which residuals are compared.
const POINTS: usize = 5;
/// Points that are drawn at most: at some a formula may have no real value.
const DRAWN: usize = 40;
/// Most steps towards the equations that are assumed.
const STEPS: usize = 25;
/// Points that are drawn at most where equations shall hold: what is not met after so many is hard to meet.
const DRAWN_ASSUMED: usize = 12;
/// The step of the difference quotients: the derivatives only choose the way, not the goal.
const NEARBY: f64 = 1e-7;
/// How well the equations are met in the end, and how well the point is then known.
const MET: f64 = 4e-15;

/// The values of everything at one random point, for both signs of ±.
pub(super) struct Point<'a> {
    /// With the sign +.
    pub plus: Outputs<'a>,
    /// With the sign −, where a ± occurs.
    pub minus: Option<Outputs<'a>>,
}

/// How points are drawn.
#[derive(Clone, Copy, Default)]
pub(super) struct Manner {
    /// Parameters are the same at all points.
    pub steady: bool,
    /// Observables are what they are defined to be; otherwise they are independent, too.
    pub defined: bool,
    /// The equations that the claim assumes hold.
    pub assumed: bool,
}

/// Whether a claim assumes an equation.
pub(super) fn assumes_equations(claim: &Claim) -> bool {
    let mut relations = claim.assuming.iter().flat_map(|w| &w.value.relations);
    relations.any(|r| r.kind == RelationKind::Equal && r.limit.is_none())
}

/// What vanishes where the equations hold that a claim assumes: at every time, so at those that occur, too.
fn assumed(graph: &mut Graph, claim: &Claim, leaves: &[Leaf]) -> Vec<Expr> {
    let scope = &claim.scope;
    let mut instants: Vec<Expr> = leaves.iter().filter_map(|l| l.instant).collect();
    instants.sort_unstable();
    instants.dedup();
    let mut out = Vec::new();
    for relation in claim.assuming.iter().flat_map(|w| &w.value.relations) {
        if relation.kind != RelationKind::Equal || relation.limit.is_some() {
            continue;
        }
        for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
            let difference = graph.sub(l, r);
            let then: Vec<Expr> = instants.iter().map(|&i| at_instant(graph, scope, difference, i)).collect();
            for e in std::iter::once(difference).chain(then) {
                let e = traced(graph, scope, e);
                if graph.as_constant(e).is_none() && !out.contains(&e) {
                    out.push(e);
                }
            }
        }
    }
    out
}

/// Draws points and evaluates everything at them. None where the equations that are assumed cannot be met.
pub(super) fn draw<'a>(
    derivation: &Derivation,
    claim: &Claim,
    graph: &mut Graph,
    battery: &'a Battery,
    manner: Manner,
) -> Vec<Point<'a>> {
    let scope = &claim.scope;
    let leaves: Vec<Leaf> = battery.leaves().to_vec();
    let mut meanings = Vec::new();
    for &leaf in &leaves {
        let e = graph.leaf(leaf);
        meanings.push(if manner.defined { traced(graph, scope, e) } else { e });
    }
    let mut basic = graph.leaves(meanings.iter().copied());
    let conditions = if manner.assumed { assumed(graph, claim, &basic) } else { Vec::new() };
    basic.extend(graph.leaves(conditions.iter().copied()));
    basic.sort_unstable();
    basic.dedup();
    let Ok(tape) = Tape::compile(graph, &basic, &meanings) else { return Vec::new() };
    let Ok(met) = Tape::compile(graph, &basic, &conditions) else { return Vec::new() };
    let positive = |leaf: &Leaf| derivation.symbols.iter().any(|s| s.symbol == leaf.symbol && s.positive);
    let positive: Vec<bool> = basic.iter().map(positive).collect();
    let mut draws = Draws::new(SEED);
    let mut random = |positive: &bool| {
        let size = 0.3 + draws.below(1 << 30) as f64 / f64::from(1u32 << 30) * 1.4;
        let negative = draws.below(2) == 1 && !positive;
        if negative { -size } else { size }
    };
    let mut slots = tape.slots::<Bounded>(&());
    let mut run = battery.slots();
    let mut points: Vec<Point> = Vec::new();
    let mut first: Option<Vec<f64>> = None;
    for _ in 0..if conditions.is_empty() { DRAWN } else { DRAWN_ASSUMED } {
        let mut at: Vec<f64> = positive.iter().map(&mut random).collect();
        if let (true, Some(first)) = (manner.steady, &first) {
            for (i, leaf) in basic.iter().enumerate() {
                if scope.role(leaf.symbol) == Some(Role::Parameter) {
                    at[i] = first[i];
                }
            }
        }
        let mut error = 0.0;
        if !conditions.is_empty() {
            let may_move =
                |l: &Leaf| !manner.steady || first.is_none() || scope.role(l.symbol) != Some(Role::Parameter);
            let may_move: Vec<bool> = basic.iter().map(may_move).collect();
            let Some(moved) = moved_to(&met, at, &may_move) else { continue };
            at = moved;
            if at.iter().zip(&positive).any(|(x, positive)| *positive && *x <= 0.0) {
                continue;
            }
            error = MET;
        }
        let input = |x: &f64| Ok(Bounded { value: *x, error: error * x.abs().max(1.0) });
        let inputs: Vec<Value> = at.iter().map(input).collect();
        let values = tape.evaluate(&(), &inputs, &mut slots);
        let plus = battery.at(values.iter().copied(), 1.0, &mut run);
        let minus = battery.has_sign().then(|| battery.at(values.iter().copied(), -1.0, &mut run));
        // A point at which the print says nothing is no point.
        let counted = battery.formulas().any(|(f, parts)| (0..parts).all(|p| plus.own(f, p).is_ok()));
        if counted {
            first.get_or_insert(at);
            points.push(Point { plus, minus });
        }
        if points.len() == POINTS {
            break;
        }
    }
    points
}

/// The nearest point at which all outputs of a tape vanish, if only some of the inputs move; `None` where the way there does not
/// end.
fn moved_to(tape: &Tape, start: Vec<f64>, may_move: &[bool]) -> Option<Vec<f64>> {
    let mut slots = tape.slots::<Bounded>(&());
    let mut values = |at: &[f64]| -> Option<DVector<f64>> {
        let inputs: Vec<Value> = at.iter().map(|x| Ok(Bounded::exact(*x))).collect();
        let out: Vec<f64> = tape
            .evaluate(&(), &inputs, &mut slots)
            .into_iter()
            .map(|v| v.ok().map(|v| v.value))
            .collect::<Option<_>>()?;
        Some(DVector::from_vec(out))
    };
    let mut at = start;
    let mut here = values(&at)?;
    for _ in 0..STEPS {
        let size = at.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
        if here.amax() <= MET * size {
            return Some(at);
        }
        let mut slope = DMatrix::zeros(here.len(), at.len());
        for k in (0..at.len()).filter(|k| may_move[*k]) {
            let mut beside = at.clone();
            beside[k] += NEARBY;
            slope.set_column(k, &((values(&beside)? - &here) / NEARBY));
        }
        let step = slope.pseudo_inverse(1e-6).ok()? * &here;
        at.iter_mut().zip(step.iter()).for_each(|(x, d)| *x -= d);
        here = values(&at)?;
        if !here.amax().is_finite() {
            return None;
        }
    }
    None
}
