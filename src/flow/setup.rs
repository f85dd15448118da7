//! Integrations that are set up, and how many of them are carried out together.
//!
//! **In:** a field, and what its initial values and coefficients are. **Out:** what [`Trajectory`] integrates from, and the
//! trajectory. **Guaranteed:** what is integrated together is, bit for bit, what it is alone.

use std::sync::Arc;

use super::abreast::Halt;
use super::core::{Core, Formula, Integrand, Orbit, Origin};
use super::definitions::{Definitions, Rates};
use super::error::{FlowError, leaf_name};
use super::estimate::Estimation;
use super::field::VectorField;
use super::start::{self, Start};
use super::taylor::Flow;
use super::trajectory::{Plan, Trajectory};
use expr::tape::Tape;
use expr::{Expr, Graph, Leaf};
use number::{Bounded, DoubleDouble, Interval, NoValue, Precise};

/// An integration that is set up.
#[derive(Debug)]
pub(super) struct Begun {
    field: Arc<Integrand>,
    plan: Plan,
    found: Option<Result<Trajectory, (usize, NoValue)>>,
}

impl Begun {
    /// An integration that nothing is known of yet.
    pub(super) fn of(field: Arc<Integrand>, plan: Plan) -> Begun {
        Begun { field, plan, found: None }
    }

    /// Carries out several integrations, those of one field side by side; `false` if `halt` stopped it.
    pub(super) fn integrate(mut left: Vec<&mut Begun>, estimation: Estimation, halt: Halt) -> bool {
        while let Some(first) = left.pop() {
            let field = Arc::clone(&first.field);
            let is_alike = |other: &&mut Begun| Arc::ptr_eq(&other.field, &field) || other.field.flow == field.flow;
            let (mut alike, others): (Vec<_>, Vec<_>) = left.into_iter().partition(is_alike);
            left = others;
            alike.push(first);
            let plans: Vec<Plan> = alike.iter().map(|begun| begun.plan.clone()).collect();
            let Some(found) = Trajectory::integrate(&field.flow, &plans, estimation, halt) else { return false };
            alike.into_iter().zip(found).for_each(|(begun, found)| begun.found = Some(found));
        }
        true
    }

    /// What was integrated; integrates it, if that was not done.
    ///
    /// # Errors
    /// [`FlowError::Singular`].
    pub(super) fn finish(mut self) -> Result<Orbit, FlowError> {
        if self.found.is_none() {
            Begun::integrate(vec![&mut self], Estimation::Companions, &|| false);
        }
        let Begun { field, plan, found } = self;
        // What nothing stops is found.
        let found = found.unwrap_or(Err((0, NoValue::Indeterminate)));
        let state = |i: usize| field.flow.names.get(i).cloned().unwrap_or_default();
        let time = plan.initial_time;
        let trajectory = found.map_err(|(i, reason)| FlowError::Singular { state: state(i), time, reason })?;
        Ok(Orbit { field, constants: plan.constants, trajectory })
    }
}

impl Core {
    /// Sets up an integration.
    pub(super) fn set_up(
        &mut self,
        graph: &mut Graph,
        field: &VectorField,
        initial: &[(Leaf, Expr)],
        start: &Start,
    ) -> Result<Begun, FlowError> {
        let Rates { states, rates, constants: found } = self.rates_of(graph, field)?;
        let time = self.time;
        for (leaf, e) in found {
            let formula = Formula::new(graph, e);
            let value = self.formula_value(&formula);
            self.note(leaf, value, Origin::Formula(Arc::new(formula)));
        }
        let used: Vec<Leaf> =
            graph.leaves(rates.iter().copied()).into_iter().filter(|l| *l != time && !states.contains(l)).collect();
        let mut constants = Vec::new();
        for leaf in &used {
            let value = self.constants.iter().find(|c| c.leaf == *leaf).map_or(Err(NoValue::Unsupported), |c| c.value);
            // A coefficient without a value shows in the rates that need it.
            match value {
                Ok(x) => constants.push(x),
                Err(reason) => return Err(self.singular(graph, field, &rates, *leaf, reason)),
            }
        }
        let inputs: Vec<Leaf> = [time].into_iter().chain(states.iter().copied()).chain(used.iter().copied()).collect();
        let tape = Tape::compile(graph, &inputs, &rates)
            .map_err(|leaf| FlowError::UnknownLeaf { leaf: leaf_name(graph, leaf) })?;
        self.determine(graph, field, initial, start)?;
        let value = |leaf: &Leaf| self.initial_value(graph, field, initial, *leaf);
        let values = field.states().iter().map(value).collect::<Result<Vec<Bounded>, FlowError>>()?;
        let names: Vec<String> = field.states().iter().map(|&l| leaf_name(graph, l)).collect();
        let flow = Flow::new(tape, field.states(), names);
        let (begin, most) = (self.initial_time, field.most_steps());
        let plan = Plan { constants, initial_time: begin, state: values, span: self.span, max_steps: most };
        Ok(Begun::of(Arc::new(Integrand { states, rates, used, flow }), plan))
    }

    /// The value of a state at the initial time.
    pub(super) fn initial_value(
        &mut self,
        graph: &mut Graph,
        field: &VectorField,
        initial: &[(Leaf, Expr)],
        leaf: Leaf,
    ) -> Result<Bounded, FlowError> {
        let name = || leaf_name(graph, leaf);
        let given = initial.iter().find(|(l, _)| *l == leaf);
        let Some(&(_, e)) = given else { return Err(FlowError::NoInitial { state: name() }) };
        let e = start::at_start(graph, field, initial, e)?;
        let resolved = self.resolve(graph, e)?;
        let value = self.constant_value(graph, resolved);
        let what = || format!("the initial value of {}", leaf_name(graph, leaf));
        value.map_err(|reason| FlowError::Undefined { what: what(), reason })
    }

    /// Solves for the initial values that equations determine: each becomes a constant.
    fn determine(
        &mut self,
        graph: &mut Graph,
        field: &VectorField,
        initial: &[(Leaf, Expr)],
        start: &Start,
    ) -> Result<(), FlowError> {
        let start = start.resolved(graph, field, initial, |graph, e| self.resolve(graph, e))?;
        let value = |leaf: Leaf| match leaf == self.time {
            true => Some(Precise::enclosing(Interval::point(self.initial_time))),
            false => {
                let known = self.constants.iter().find(|c| c.leaf == leaf)?.value.ok()?;
                Some(Precise::new(DoubleDouble::point(known.value), known.error))
            }
        };
        for (leaf, value) in start.solve(graph, value)? {
            let (centre, error) = (value.centre(), value.error());
            let error = (centre.low().abs() + error) * (1.0 + f64::EPSILON);
            self.note(leaf, Ok(Bounded::new(centre.high(), error)), Origin::Given);
        }
        Ok(())
    }

    /// The first state whose rate needs a coefficient without a value.
    fn singular(&self, graph: &Graph, field: &VectorField, rates: &[Expr], leaf: Leaf, reason: NoValue) -> FlowError {
        let needs = |e: &Expr| graph.leaves([*e]).contains(&leaf);
        let state = rates.iter().position(needs).and_then(|i| field.states().get(i));
        let state = state.map_or_else(String::new, |&l| leaf_name(graph, l));
        FlowError::Singular { state, time: self.initial_time, reason }
    }
}
