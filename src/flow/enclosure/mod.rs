//! Motions between bounds: every state at every time lies in an interval that is computed with outward rounding.
//!
//! **In:** what a [`Motion`](super::Motion) is made from ([`Setup`]); decimal parameters and initial values are enclosed, not
//! rounded. **Out:** [`Enclosure`]: intervals for every expression in the leaves of the motion, over any stretch of time.
//!
//! **Guaranteed:** every motion with parameters and initial values in their intervals exists, is unique, and lies in the
//! enclosure, as far as the enclosure reaches ([`Enclosure::reach`]); if it ends early, [`Enclosure::stop`] says where, how
//! wide it was there, and why. A quantity is given for a stretch of time only if it has a value, and is continuous, at every
//! time of the stretch. The theorems are named in `step`, `set` and [`Reach`].
//!
//! **Why its own room beside the ordinary integrator:** the two share the tape and the recurrences of the series, and nothing
//! else, so that each checks the other.

mod angle;
mod matrix;
mod reach;
mod recall;
mod set;
mod sharpen;
mod step;
mod tail;

pub use reach::{Compiled, Reach, Reaches, Stretch};
pub use recall::{KnownSteps, Steps};
pub use sharpen::Sharp;
pub use step::Stop;

use std::collections::BTreeMap;

use super::definitions::{Continued, Definitions, Rates, fresh};
use super::error::{FlowError, leaf_name};
use super::field::VectorField;
use super::motion::{Setup, Source};
use super::start::{self, Start};
use angle::Angle;
use expr::tape::Tape;
use expr::{Expr, Graph, Leaf};
use number::{Interval, NoValue, Precise, PreciseModel};
use sharpen::Integrals;
use step::{Field, Piece};

/// An integrated motion.
#[derive(Clone, Debug)]
struct Tube {
    states: Vec<Leaf>,
    rates: Vec<Expr>,
    field: Field,
    initial: Vec<Interval>,
    steps: Steps,
}

impl Tube {
    /// The step that an interval of times lies in.
    fn step(&self, time: Interval) -> Option<&Piece> {
        let Steps { forward, backward, .. } = &self.steps;
        let ahead = forward.partition_point(|p| p.to < time.hi());
        let behind = backward.partition_point(|p| p.to > time.lo());
        let within = |p: &&Piece| p.from.min(p.to) <= time.lo() && time.hi() <= p.from.max(p.to);
        let ahead = forward.get(ahead).filter(within);
        ahead.or_else(|| backward.get(behind).filter(within))
    }
}

/// See the module.
#[derive(Clone, Debug)]
pub struct Enclosure {
    time: Leaf,
    initial_time: f64,
    span: (f64, f64),
    tube: Option<std::sync::Arc<Tube>>,
    constants: Vec<(Leaf, Result<Interval, NoValue>)>,
    /// What is known of constants, where that is more.
    precise: BTreeMap<Leaf, Precise>,
    angles: Vec<Angle>,
    /// Angles as they are followed: they have no cut.
    continued: Vec<Continued>,
    /// Definitions of leaves in basic leaves: time, states, constants, turns of angles.
    definitions: BTreeMap<Leaf, Expr>,
    /// Leaves that were given a definition, not derived.
    given: Vec<Leaf>,
    /// What is constant along the motion.
    integrals: Option<Integrals>,
}

impl Definitions for Enclosure {
    fn time(&self) -> Leaf {
        self.time
    }

    fn known(&mut self) -> &mut BTreeMap<Leaf, Expr> {
        &mut self.definitions
    }

    fn integrated(&self) -> Option<(&[Leaf], &[Expr])> {
        self.tube.as_deref().map(|t| (t.states.as_slice(), t.rates.as_slice()))
    }

    fn is_constant(&self, leaf: Leaf) -> bool {
        self.constants.iter().any(|c| c.0 == leaf) || self.angles.iter().any(|a| a.turns == leaf || a.side == leaf)
    }

    fn continued(&self) -> &[Continued] {
        &self.continued
    }

    fn at_instant(&mut self, graph: &mut Graph, now: Leaf, instant: Expr) -> Result<Expr, FlowError> {
        let (instant, value) = (self.resolve(graph, instant)?, self.definition(graph, now)?);
        let time = self.constant_value(graph, instant);
        let compiled = self.compile_resolved(graph, &[value])?;
        let value = time.and_then(|time| self.value(&compiled, time)[0]);
        Ok(self.constant(graph, value.map(Precise::enclosing)))
    }
}

impl Enclosure {
    /// Encloses the motion of a setup. `from` is the enclosure of the motion that a derived one comes from.
    ///
    /// # Errors
    /// As [`Motion::new`](super::Motion::new). An enclosure that ends early is kept, see [`Enclosure::stop`].
    pub fn new(graph: &mut Graph, setup: &Setup, from: Option<&Enclosure>) -> Result<Enclosure, FlowError> {
        Enclosure::recalling(graph, setup, from, &recall::Nothing)
    }

    /// [`Enclosure::new`], with the steps that are known from before.
    ///
    /// # Errors
    /// As [`Enclosure::new`].
    pub fn recalling(
        graph: &mut Graph,
        setup: &Setup,
        from: Option<&Enclosure>,
        known: &dyn KnownSteps,
    ) -> Result<Enclosure, FlowError> {
        let mut new = Enclosure {
            time: setup.time,
            initial_time: setup.initial_time,
            span: setup.span,
            tube: None,
            constants: Vec::new(),
            precise: BTreeMap::new(),
            angles: Vec::new(),
            continued: Vec::new(),
            definitions: BTreeMap::new(),
            given: Vec::new(),
            integrals: None,
        };
        let mut states: Vec<(Leaf, Expr)> = Vec::new();
        if let Source::Derived { states: map, .. } = &setup.source {
            let Some(from) = from else {
                return Err(FlowError::Undefined {
                    what: "the motion that it comes from".to_owned(),
                    reason: NoValue::Indeterminate,
                });
            };
            new = from.clone();
            for &(leaf, e) in map {
                states.push((leaf, new.resolve(graph, e)?));
            }
            new.definitions.clear();
        }
        let time = graph.leaf(setup.time);
        new.definitions.insert(setup.time, time);
        for &(leaf, e) in &setup.parameters {
            let resolved = new.resolve(graph, e)?;
            // A rational number stays exact; anything else becomes an interval, computed once.
            let value = match graph.as_constant(resolved) {
                Some(_) => resolved,
                None => {
                    let value = new.precise_value(graph, resolved);
                    new.constant(graph, value)
                }
            };
            new.definitions.insert(leaf, value);
        }
        match &setup.source {
            Source::Derived { .. } => {}
            Source::Formula { states: formulas } => {
                for &(leaf, e) in formulas {
                    states.push((leaf, new.resolve(graph, e)?));
                }
            }
            Source::Integrated { field, initial, start } => new.integrate(graph, field, (initial, start), known)?,
        }
        new.definitions.extend(states);
        new.given = new.definitions.keys().copied().collect();
        for observable in &setup.observables {
            let resolved = new.resolve(graph, observable.definition)?;
            let value = if observable.angle { new.follow(graph, resolved)? } else { resolved };
            new.definitions.insert(observable.leaf, value);
        }
        Ok(new)
    }

    fn integrate(
        &mut self,
        graph: &mut Graph,
        field: &VectorField,
        (initial, start): (&[(Leaf, Expr)], &Start),
        known: &dyn KnownSteps,
    ) -> Result<(), FlowError> {
        let (unknowns, limit) = (field.states().len(), step::MOST_UNKNOWNS);
        if unknowns > limit {
            return Err(FlowError::TooManyUnknowns { unknowns, limit });
        }
        let Rates { states, rates, constants: found } = self.rates_of(graph, field)?;
        let time = self.time;
        for (leaf, e) in found {
            let value = self.precise_value(graph, e);
            self.add_constant(leaf, value);
        }
        let mut constants = Vec::new();
        for leaf in graph.leaves(rates.iter().copied()) {
            if leaf == time || states.contains(&leaf) {
                continue;
            }
            let value = self.constants.iter().find(|c| c.0 == leaf).map_or(Err(NoValue::Unsupported), |c| c.1);
            let what = || "a coefficient of the system".to_owned();
            let value = value.map_err(|reason| FlowError::Undefined { what: what(), reason })?;
            constants.push((leaf, self.precise.get(&leaf).copied().unwrap_or(Precise::enclosing(value))));
        }
        let compiled = Field::new(graph, time, &states, &rates, constants)?;
        let determined = start.resolved(graph, field, initial, |graph, e| self.resolve(graph, e))?;
        let value = |leaf: Leaf| match leaf == self.time {
            true => Some(Precise::enclosing(Interval::point(self.initial_time))),
            false => {
                let known = self.constants.iter().find(|c| c.0 == leaf)?.1.ok()?;
                Some(self.precise.get(&leaf).copied().unwrap_or(Precise::enclosing(known)))
            }
        };
        for (leaf, value) in determined.solve(graph, value)? {
            self.add_constant(leaf, Ok(value));
        }
        let mut state = Vec::new();
        for &leaf in field.states() {
            let name = || leaf_name(graph, leaf);
            let given = initial.iter().find(|(l, _)| *l == leaf);
            let Some(&(_, e)) = given else { return Err(FlowError::NoInitial { state: name() }) };
            let e = start::at_start(graph, field, initial, e)?;
            let resolved = self.resolve(graph, e)?;
            let value = self.precise_value(graph, resolved);
            let what = || format!("the initial value of {}", leaf_name(graph, leaf));
            state.push(value.map_err(|reason| FlowError::Undefined { what: what(), reason })?);
        }
        self.run((states, rates), compiled, state, known);
        Ok(())
    }

    fn run(
        &mut self,
        (states, rates): (Vec<Leaf>, Vec<Expr>),
        field: Field,
        initial: Vec<Precise>,
        known: &dyn KnownSteps,
    ) {
        let steps = Steps::of(&field, &initial, (self.initial_time, self.span), known);
        let initial = initial.iter().map(Precise::interval).collect();
        let tube = Tube { states, rates, field, initial, steps };
        self.tube = Some(std::sync::Arc::new(tube));
    }

    /// The same system from other initial states, in the order of the field; nothing for a motion that is not integrated.
    ///
    /// Definitions of observables and values at fixed times are those of the first: use it for states only.
    pub fn restart(&self, initial: &[Interval]) -> Option<Enclosure> {
        self.restart_over(initial, self.span)
    }

    /// [`Enclosure::restart`] over another span, which must contain the initial time.
    pub fn restart_over(&self, initial: &[Interval], span: (f64, f64)) -> Option<Enclosure> {
        let tube = self.tube.as_deref().filter(|t| t.states.len() == initial.len())?;
        let mut new = Enclosure { span, integrals: None, ..self.clone() };
        let initial = initial.iter().copied().map(Precise::enclosing).collect();
        new.run((tube.states.clone(), tube.rates.clone()), tube.field.clone(), initial, &recall::Nothing);
        Some(new)
    }

    /// The time at which the initial state is given.
    pub fn initial_time(&self) -> f64 {
        self.initial_time
    }

    /// The time, as a leaf.
    pub fn time(&self) -> Leaf {
        self.time
    }

    /// The times between which everything is enclosed.
    pub fn reach(&self) -> (f64, f64) {
        match &self.tube {
            None => self.span,
            Some(tube) => (
                tube.steps.backward.last().map_or(self.initial_time, |p| p.to),
                tube.steps.forward.last().map_or(self.initial_time, |p| p.to),
            ),
        }
    }

    /// Why the enclosure ends before the span does.
    pub fn stop(&self) -> Option<&Stop> {
        self.tube.as_deref().and_then(|t| t.steps.stops.iter().flatten().next())
    }

    /// Number of validated steps.
    pub fn steps(&self) -> usize {
        self.tube.as_deref().map_or(0, |t| t.steps.forward.len() + t.steps.backward.len())
    }

    /// Times that cut the span into steps; for formulas, into equal parts. Ascending.
    pub fn boundaries(&self) -> Vec<f64> {
        let mut times: Vec<f64> = match self.tube.as_deref() {
            Some(tube) => {
                let ends = tube.steps.backward.iter().rev().chain(&tube.steps.forward).map(|p| p.to);
                ends.chain([self.initial_time]).collect()
            }
            None => {
                const PARTS: usize = 16;
                let (a, b) = self.span;
                let inner = (1..PARTS).map(|i| a + (b - a) * (i as f64 / PARTS as f64));
                inner.chain([a, b, self.initial_time]).collect()
            }
        };
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// The integrated states at all times of an interval, in the order of the field; `None` outside of the reach.
    pub fn state(&self, time: Interval) -> Option<Vec<Interval>> {
        let tube = self.tube.as_deref()?;
        let (from, to) = self.reach();
        if !(from <= time.lo() && time.hi() <= to) {
            return None;
        }
        let mut out: Option<Vec<Interval>> = None;
        let mut add = |found: Vec<Interval>| match &mut out {
            None => out = Some(found),
            Some(all) => all.iter_mut().zip(found).for_each(|(a, f)| *a = a.hull(f)),
        };
        let initial = Interval::point(self.initial_time);
        if time.intersection(initial).is_some() {
            add(tube.initial.clone());
            if time.is_point() {
                return out;
            }
        }
        // Steps are in the order of their times: only those that meet the interval are looked at.
        let Steps { forward, backward, .. } = &tube.steps;
        let first = forward.partition_point(|p| p.to < time.lo());
        let ahead = forward[first..].iter().take_while(|p| p.from <= time.hi());
        let first = backward.partition_point(|p| p.to > time.hi());
        let behind = backward[first..].iter().take_while(|p| p.from >= time.lo());
        for piece in ahead.chain(behind) {
            let stretch = Interval::point(piece.from).hull(Interval::point(piece.to));
            if let Some(part) = time.intersection(stretch) {
                add(if part == stretch { piece.hull.clone() } else { piece.at(part) });
                if time.is_point() {
                    break;
                }
            }
        }
        out
    }

    /// An expression in the leaves of the motion, in those that [`Enclosure::compile_resolved`] knows.
    ///
    /// # Errors
    /// As [`Enclosure::compile`].
    pub fn resolved(&mut self, graph: &mut Graph, e: Expr) -> Result<Expr, FlowError> {
        self.resolve(graph, e)
    }

    /// A quantity of which only bounds are known, and that does not depend on anything.
    pub fn between(&mut self, graph: &mut Graph, value: Interval) -> Expr {
        self.constant(graph, Ok(Precise::enclosing(value)))
    }

    /// The derivative along the motion of an expression in its leaves.
    ///
    /// # Errors
    /// As [`Enclosure::compile`].
    pub fn rate(&mut self, graph: &mut Graph, e: Expr) -> Result<Expr, FlowError> {
        let resolved = self.resolve(graph, e)?;
        let name = "an expression".to_owned();
        self.derivative(graph, resolved).map_err(|reason| FlowError::NoDerivative { leaf: name, reason })
    }

    fn constant(&mut self, graph: &mut Graph, value: Result<Precise, NoValue>) -> Expr {
        let leaf = fresh(graph, "constant");
        self.add_constant(leaf, value);
        graph.leaf(leaf)
    }

    fn add_constant(&mut self, leaf: Leaf, value: Result<Precise, NoValue>) {
        self.constants.push((leaf, value.map(|v| v.interval())));
        if let Ok(value) = value {
            self.precise.insert(leaf, value);
        }
    }

    /// The value of an expression in constants, as precisely as it can be had.
    fn precise_value(&self, graph: &Graph, e: Expr) -> Result<Precise, NoValue> {
        let plain = self.constant_value(graph, e)?;
        let precise = || -> Option<Precise> {
            let leaves = graph.leaves([e]);
            let tape = Tape::compile(graph, &leaves, &[e]).ok()?;
            let input = |leaf: &Leaf| match *leaf == self.time {
                true => Some(Precise::enclosing(Interval::point(self.initial_time))),
                false => self.precise.get(leaf).copied(),
            };
            let inputs: Vec<_> =
                leaves.iter().map(|l| Some(Ok(PreciseModel::constant(&input(l)?)))).collect::<Option<_>>()?;
            let mut slots = tape.slots::<PreciseModel>(&());
            let found = tape.evaluate(&(), &inputs, &mut slots).pop()?.ok()?.value();
            (found.error() < plain.radius()).then_some(found)
        };
        Ok(precise().unwrap_or(Precise::enclosing(plain)))
    }

    /// The value of an expression in constants; the time, if it occurs, is the initial time.
    fn constant_value(&self, graph: &Graph, e: Expr) -> Result<Interval, NoValue> {
        let leaves = graph.leaves([e]);
        let Ok(tape) = Tape::compile(graph, &leaves, &[e]) else { return Err(NoValue::Unsupported) };
        let inputs: Vec<_> = leaves
            .iter()
            .map(|&leaf| {
                if leaf == self.time {
                    return Ok(Interval::point(self.initial_time));
                }
                self.constants.iter().find(|c| c.0 == leaf).map_or(Err(NoValue::Unsupported), |c| c.1)
            })
            .collect();
        let mut slots = tape.slots::<Interval>(&());
        tape.evaluate(&(), &inputs, &mut slots).pop().unwrap_or(Err(NoValue::Unsupported))
    }
}

#[cfg(test)]
mod tests;
