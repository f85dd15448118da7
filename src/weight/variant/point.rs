//! Random points at which residuals are compared.
//!
//! **In:** the formulas of a claim and of its variants as a program. **Out:** values of everything at points that are drawn:
//! every state, rate, parameter and value at a fixed time by itself, observables from their definitions.
//!
//! Where the equations that a claim assumes shall hold, a drawn point is moved to the nearest one at which they do (Newton's
//! method, the shortest step): it is known to some units in the last place, and so are the values there.

use nalgebra::{DMatrix, DVector};

use super::battery::{Battery, Outputs, Value};
use crate::derivation::{Claim, Derivation};
use crate::expr::tape::{Slots, Tape};
use crate::expr::{Expr, Graph, Leaf};
use crate::findings::SEED;
use crate::latex::{RelationKind, Role};
use crate::number::{Bounded, BoundedLanes, Draws};
use claim::comparison::{at_instant, traced};

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

/// What points are made of: leaves that are drawn, and what follows from them.
pub(super) struct Ground<'a> {
    battery: &'a Battery,
    /// Which of the leaves that are drawn are positive.
    positive: Vec<bool>,
    /// Which of them are parameters.
    parameter: Vec<bool>,
    /// The leaves of the battery.
    meanings: Tape,
    /// What vanishes.
    met: Option<Equations>,
}

impl<'a> Ground<'a> {
    /// Compiles what is needed; `None` where a leaf is missing.
    pub fn new(
        derivation: &Derivation,
        claim: &Claim,
        graph: &mut Graph,
        battery: &'a Battery,
        manner: Manner,
    ) -> Option<Ground<'a>> {
        let scope = &claim.scope;
        let mut meanings = Vec::new();
        for &leaf in battery.leaves() {
            let e = graph.leaf(leaf);
            // What has no definition stays what it is.
            let defined = manner.defined && leaf.rate == 0 && scope.definition(leaf.symbol).is_some();
            meanings.push(if defined { traced(graph, scope, e) } else { e });
        }
        let mut basic = graph.leaves(meanings.iter().copied());
        let conditions = if manner.assumed { assumed(graph, claim, &basic) } else { Vec::new() };
        basic.extend(graph.leaves(conditions.iter().copied()));
        basic.sort_unstable();
        basic.dedup();
        let meanings = Tape::compile(graph, &basic, &meanings).ok()?;
        let met = if conditions.is_empty() { None } else { Some(Equations::new(graph, &basic, &conditions)?) };
        let positive = |leaf: &Leaf| derivation.symbols.iter().any(|s| s.symbol == leaf.symbol && s.positive);
        let positive = basic.iter().map(positive).collect();
        let parameter = basic.iter().map(|leaf| scope.role(leaf.symbol) == Some(Role::Parameter)).collect();
        Some(Ground { battery, positive, parameter, meanings, met })
    }

    /// Whether it makes a difference that parameters are the same at all points.
    pub fn has_parameters(&self) -> bool {
        self.parameter.contains(&true)
    }

    /// Draws points and evaluates everything at them; `steady`: parameters are the same at all points. None where the
    /// equations that are assumed cannot be met.
    pub fn draw(&self, steady: bool) -> Vec<Point<'a>> {
        let mut draws = Draws::new(SEED);
        let mut random = |positive: &bool| {
            let size = 0.3 + draws.below(1 << 30) as f64 / f64::from(1u32 << 30) * 1.4;
            let negative = draws.below(2) == 1 && !positive;
            if negative { -size } else { size }
        };
        let mut slots = self.meanings.slots::<Bounded>(&());
        let mut run = self.battery.slots();
        let mut points: Vec<Point> = Vec::new();
        let mut first: Option<Vec<f64>> = None;
        for _ in 0..if self.met.is_none() { DRAWN } else { DRAWN_ASSUMED } {
            let mut at: Vec<f64> = self.positive.iter().map(&mut random).collect();
            if let (true, Some(first)) = (steady, &first) {
                for (i, _) in self.parameter.iter().enumerate().filter(|(_, parameter)| **parameter) {
                    at[i] = first[i];
                }
            }
            let mut error = 0.0;
            if let Some(met) = &self.met {
                let fixed = steady && first.is_some();
                let Some(moved) = met.nearest(at, |i| !fixed || !self.parameter[i]) else { continue };
                at = moved;
                if at.iter().zip(&self.positive).any(|(x, positive)| *positive && *x <= 0.0) {
                    continue;
                }
                error = MET;
            }
            let input = |x: &f64| Ok(Bounded { value: *x, error: error * x.abs().max(1.0) });
            let inputs: Vec<Value> = at.iter().map(input).collect();
            let values = self.meanings.evaluate(&(), &inputs, &mut slots);
            let plus = self.battery.at(values.iter().copied(), 1.0, &mut run);
            let sign = self.battery.has_sign();
            let minus = sign.then(|| self.battery.at(values.iter().copied(), -1.0, &mut run));
            // A point at which the print says nothing is no point.
            let counted = self.battery.formulas().any(|(f, parts)| (0..parts).all(|p| plus.own(f, p).is_ok()));
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
}

/// Points at which equations are evaluated at once.
const LANES: usize = 8;

/// What shall vanish.
struct Equations {
    tape: Tape,
    /// Positions of the inputs that make a difference.
    used: Vec<usize>,
}

impl Equations {
    fn new(graph: &Graph, basic: &[Leaf], conditions: &[Expr]) -> Option<Equations> {
        let tape = Tape::compile(graph, basic, conditions).ok()?;
        let leaves = graph.leaves(conditions.iter().copied());
        let used = (0..basic.len()).filter(|&i| leaves.contains(&basic[i])).collect();
        Some(Equations { tape, used })
    }

    fn values(&self, at: &[f64], slots: &mut Slots<Bounded>) -> Option<DVector<f64>> {
        let inputs: Vec<Value> = at.iter().map(|x| Ok(Bounded::exact(*x))).collect();
        let out = self.tape.evaluate(&(), &inputs, slots).into_iter().map(|v| v.ok().map(|v| v.value));
        Some(DVector::from_vec(out.collect::<Option<Vec<f64>>>()?))
    }

    /// Difference quotients along some of the inputs, by columns; `None` where one has no value.
    fn slopes(&self, at: &[f64], along: &[usize], here: &DVector<f64>, memory: &mut Memory) -> Option<DMatrix<f64>> {
        let mut slope = DMatrix::zeros(here.len(), along.len());
        for (block, inputs) in along.chunks(LANES).enumerate() {
            for (i, x) in at.iter().enumerate() {
                memory.lanes.set(i, Ok(BoundedLanes::splat(Bounded::exact(*x))));
            }
            for (lane, &i) in inputs.iter().enumerate() {
                memory.lanes.value_mut(i).set_lane(lane, Bounded::exact(at[i] + NEARBY));
            }
            self.tape.run(&(), &mut memory.lanes);
            let values: Option<Vec<_>> =
                (0..here.len()).map(|o| self.tape.output(o, &memory.lanes).ok().copied()).collect();
            for (lane, &i) in inputs.iter().enumerate() {
                let beside = match &values {
                    Some(values) => DVector::from_iterator(here.len(), values.iter().map(|v| v.lane(lane).value)),
                    // Where one of several points has no value, each is looked at by itself.
                    None => {
                        let mut beside = at.to_vec();
                        beside[i] += NEARBY;
                        self.values(&beside, &mut memory.single)?
                    }
                };
                slope.set_column(LANES * block + lane, &((beside - here) / NEARBY));
            }
        }
        Some(slope)
    }

    /// The nearest point at which all of them vanish, if only some of the inputs move; `None` where the way there does not
    /// end.
    fn nearest(&self, start: Vec<f64>, may_move: impl Fn(usize) -> bool) -> Option<Vec<f64>> {
        let along: Vec<usize> = self.used.iter().copied().filter(|&i| may_move(i)).collect();
        let mut memory = Memory { single: self.tape.slots(&()), lanes: self.tape.slots(&()) };
        let mut at = start;
        let mut here = self.values(&at, &mut memory.single)?;
        for _ in 0..STEPS {
            let size = at.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
            if here.amax() <= MET * size {
                return Some(at);
            }
            if along.is_empty() {
                return None;
            }
            let slope = self.slopes(&at, &along, &here, &mut memory)?;
            let step = slope.pseudo_inverse(1e-6).ok()? * &here;
            along.iter().zip(step.iter()).for_each(|(&i, d)| at[i] -= d);
            here = self.values(&at, &mut memory.single)?;
            if !here.amax().is_finite() {
                return None;
            }
        }
        None
    }
}

/// The memory of evaluations.
struct Memory {
    single: Slots<Bounded>,
    lanes: Slots<BoundedLanes<LANES>>,
}
