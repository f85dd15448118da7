//! What a motion consists of, and how a leaf is traced back to states, time and constants.
//!
//! Every leaf a formula may name has a definition in *basic* leaves: the time, the integrated states, constants with a value,
//! and the numbers of turns of angles. Basic leaves other than the time are symbols of their own, declared here, so that a
//! motion that is derived from another one can give the same names to other things.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::angle::{Angle, AngleBench, AngleBenches};
use super::cover::BLOCK;
use super::error::{FlowError, leaf_name};
use super::program::{Program, Turns};
use super::resolve::Resolution;
use super::taylor::Flow;
use super::trajectory::Trajectory;
use expr::tape::Tape;
use expr::{Expr, Graph, Leaf, Shape};
use number::{Bounded, NoValue};

/// A quantity that does not change along the motion.
#[derive(Clone, Debug)]
pub(super) struct Constant {
    pub(super) leaf: Leaf,
    pub(super) value: Result<Bounded, NoValue>,
}

/// An integrated motion.
#[derive(Clone, Debug)]
pub(super) struct Orbit {
    /// Basic leaves of the states, and the rate of each in basic leaves.
    pub(super) states: Vec<Leaf>,
    pub(super) rates: Vec<Expr>,
    pub(super) flow: Flow,
    pub(super) constants: Vec<Bounded>,
    pub(super) trajectory: Trajectory,
}

/// See the module.
#[derive(Clone, Debug)]
pub(super) struct Core {
    pub(super) time: Leaf,
    pub(super) initial_time: f64,
    pub(super) span: (f64, f64),
    pub(super) orbit: Option<Arc<Orbit>>,
    /// Of a motion by formulas: where it is cut, and where it is not known from samples.
    pub(super) resolution: Resolution,
    pub(super) constants: Vec<Constant>,
    pub(super) angles: Vec<Arc<Angle>>,
    /// Definitions of leaves in basic leaves.
    pub(super) definitions: BTreeMap<Leaf, Expr>,
}

/// A new symbol for a number that formulas cannot name.
pub(super) fn fresh(graph: &mut Graph, name: &str) -> Leaf {
    let symbol = graph.declare(name, Shape::scalar(), false);
    Leaf::now(symbol, 0)
}

impl Core {
    /// An expression in basic leaves.
    ///
    /// # Errors
    /// [`FlowError::UnknownLeaf`], [`FlowError::NoDerivative`].
    pub(super) fn resolve(&mut self, graph: &mut Graph, e: Expr) -> Result<Expr, FlowError> {
        let mut image = BTreeMap::new();
        for leaf in graph.leaves([e]) {
            image.insert(leaf, self.definition(graph, leaf)?);
        }
        Ok(graph.substitute(e, |_, leaf| image.get(&leaf).copied()))
    }

    /// The definition of a leaf; rates are derived, values at fixed times become constants.
    pub(super) fn definition(&mut self, graph: &mut Graph, leaf: Leaf) -> Result<Expr, FlowError> {
        if let Some(&known) = self.definitions.get(&leaf) {
            return Ok(known);
        }
        if self.is_basic(leaf) {
            return Ok(graph.leaf(leaf));
        }
        let found = if leaf.instant.is_some() {
            let value = self.at_instant(graph, leaf)?;
            self.constant(graph, value)
        } else if leaf.rate > 0 {
            let lower = self.definition(graph, Leaf { rate: leaf.rate - 1, ..leaf }).map_err(|error| match error {
                FlowError::UnknownLeaf { .. } => FlowError::UnknownLeaf { leaf: leaf_name(graph, leaf) },
                other => other,
            })?;
            self.derivative(graph, lower)
                .map_err(|reason| FlowError::NoDerivative { leaf: leaf_name(graph, leaf), reason })?
        } else {
            return Err(FlowError::UnknownLeaf { leaf: leaf_name(graph, leaf) });
        };
        self.definitions.insert(leaf, found);
        Ok(found)
    }

    fn is_basic(&self, leaf: Leaf) -> bool {
        leaf == self.time
            || self.orbit.as_ref().is_some_and(|o| o.states.contains(&leaf))
            || self.constants.iter().any(|c| c.leaf == leaf)
            || self.angles.iter().any(|a| a.turns == leaf)
    }

    /// The derivative along the motion of an expression in basic leaves.
    fn derivative(&self, graph: &mut Graph, e: Expr) -> Result<Expr, expr::NoDerivative> {
        let rate = graph.directional_derivative(e, |graph, leaf| {
            if leaf == self.time {
                return Some(graph.integer(1));
            }
            let orbit = self.orbit.as_deref()?;
            orbit.states.iter().position(|&l| l == leaf).map(|i| orbit.rates[i])
        })?;
        Ok(graph.rate_of(e, rate, |_| false))
    }

    /// A new constant.
    pub(super) fn constant(&mut self, graph: &mut Graph, value: Result<Bounded, NoValue>) -> Expr {
        let leaf = fresh(graph, "constant");
        self.constants.push(Constant { leaf, value });
        graph.leaf(leaf)
    }

    /// The value of an expression in constants; the time, if it occurs, is the initial time.
    pub(super) fn constant_value(&self, graph: &Graph, e: Expr) -> Result<Bounded, NoValue> {
        let leaves = graph.leaves([e]);
        let Ok(tape) = Tape::compile(graph, &leaves, &[e]) else { return Err(NoValue::Unsupported) };
        let inputs: Vec<_> = leaves
            .iter()
            .map(|&leaf| {
                if leaf == self.time {
                    return Ok(Bounded::exact(self.initial_time));
                }
                let known = self.constants.iter().find(|c| c.leaf == leaf);
                known.map_or(Err(NoValue::Unsupported), |c| c.value)
            })
            .collect();
        let mut slots = tape.slots::<Bounded>(&());
        tape.evaluate(&(), &inputs, &mut slots).pop().unwrap_or(Err(NoValue::Unsupported))
    }

    /// The value of a leaf at its fixed time.
    fn at_instant(&mut self, graph: &mut Graph, leaf: Leaf) -> Result<Result<Bounded, NoValue>, FlowError> {
        let Some(instant) = leaf.instant else { return Ok(Err(NoValue::Unsupported)) };
        let now = Leaf { instant: None, ..leaf };
        let instant = self.resolve(graph, instant)?;
        let value = self.definition(graph, now)?;
        let time = match self.constant_value(graph, instant) {
            Ok(time) => time,
            Err(reason) => return Ok(Err(reason)),
        };
        let program = self.compile(graph, &[value])?;
        let turns = self.turns(&program, time.value, &mut Vec::new());
        let coefficient = |order: usize| {
            let mut bench = program.bench::<Bounded>(self, order);
            program.run(self, &mut bench, time.value, &turns);
            program.output(&bench, 0).map(|x| x.coefficient(order))
        };
        if time.error == 0.0 {
            return Ok(coefficient(0));
        }
        // The fixed time itself is rounded.
        Ok(coefficient(0).and_then(|value| {
            let moved = 2.0 * time.error * coefficient(1)?.magnitude();
            Ok(Bounded { value: value.value, error: value.error + moved })
        }))
    }

    /// Compiles resolved expressions.
    pub(super) fn compile(&self, graph: &Graph, roots: &[Expr]) -> Result<Program, FlowError> {
        Program::compile(self, graph, roots).map_err(|leaf| FlowError::UnknownLeaf { leaf: leaf_name(graph, leaf) })
    }

    /// The number of turns of the angles that `program` needs, at a time; `benches` is memory kept between calls.
    pub(super) fn turns(&self, program: &Program, t: f64, benches: &mut AngleBenches) -> Turns {
        let needed = self.needed_turns(program);
        let mut turns = Vec::with_capacity(needed.len());
        benches.resize(self.angles.len(), AngleBench::default());
        for ((angle, bench), needed) in self.angles.iter().zip(benches).zip(needed) {
            let n = if needed { angle.turns_at(self, t, &turns, bench) } else { Err(NoValue::Indeterminate) };
            turns.push(n);
        }
        turns
    }

    /// The same at several times at once.
    pub(super) fn turns_of_block(
        &self,
        program: &Program,
        times: &[f64; BLOCK],
        benches: &mut AngleBenches,
    ) -> [Turns; BLOCK] {
        let needed = self.needed_turns(program);
        let mut turns = std::array::from_fn(|_| Vec::with_capacity(needed.len()));
        benches.resize(self.angles.len(), AngleBench::default());
        for ((angle, bench), needed) in self.angles.iter().zip(benches).zip(needed) {
            if needed {
                angle.push_turns(self, times, &mut turns, bench);
            } else {
                turns.iter_mut().for_each(|turns| turns.push(Err(NoValue::Indeterminate)));
            }
        }
        turns
    }

    /// The angles whose turns a program needs: the definition of an angle may need those of the ones before it.
    fn needed_turns(&self, program: &Program) -> Vec<bool> {
        if !program.needs_turns() {
            return Vec::new();
        }
        let mut needed = vec![false; self.angles.len()];
        program.turns().for_each(|i| needed[i] = true);
        for i in (0..needed.len()).rev() {
            if needed[i] {
                self.angles[i].raw.turns().for_each(|before| needed[before] = true);
            }
        }
        needed
    }

    /// The times between which the motion is known.
    pub(super) fn reach(&self) -> (f64, f64) {
        self.orbit.as_ref().map_or(self.span, |o| o.trajectory.reach())
    }

    /// Times that cut the motion into stretches over which its states are well approximated by polynomials.
    pub(super) fn boundaries(&self) -> Vec<f64> {
        match &self.orbit {
            Some(orbit) => orbit.trajectory.boundaries(),
            None => self.resolution.cuts.clone(),
        }
    }
}
