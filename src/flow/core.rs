//! What a motion consists of, and the values of its constants.
//!
//! Its leaves are traced back to [basic ones](super::definitions). Basic leaves other than the time are symbols of their own,
//! declared here, so that a motion that is derived from another one can give the same names to other things.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::angle::{Angle, AngleBench, AngleBenches};
use super::cover::BLOCK;
use super::definitions::{Continued, Definitions, fresh};
use super::error::{FlowError, leaf_name};
use super::program::{Program, Turns};
use super::resolve::Resolution;
use super::taylor::Flow;
use super::trajectory::Trajectory;
use expr::tape::Tape;
use expr::{Expr, Graph, Leaf};
use number::{Bounded, NoValue};

/// A quantity that does not change along the motion.
#[derive(Clone, Debug)]
pub(super) struct Constant {
    pub(super) leaf: Leaf,
    pub(super) value: Result<Bounded, NoValue>,
    /// How it follows from those before it.
    pub(super) origin: Origin,
    /// How many angles there were before it.
    pub(super) angles: usize,
}

/// How a constant follows from those before it: what another motion of the same formulas has in its place.
#[derive(Clone, Debug)]
pub(super) enum Origin {
    /// It is given.
    Given,
    /// It is the value of a formula.
    Formula(Arc<Formula>),
    /// It is the value of a definition at a fixed time.
    At(Arc<Instant>),
}

/// An expression in constants, and in the initial time.
#[derive(Clone, Debug)]
pub(super) struct Formula {
    /// Nothing where it cannot be compiled: then it has no value.
    tape: Option<Tape>,
    leaves: Vec<Leaf>,
}

/// A definition, and the fixed time at which it is taken.
#[derive(Debug)]
pub(super) struct Instant {
    time: Formula,
    value: Program,
    /// y and x of the angles in the value that are not followed.
    cuts: Option<Program>,
}

impl Formula {
    pub(super) fn new(graph: &Graph, e: Expr) -> Formula {
        let leaves = graph.leaves([e]);
        Formula { tape: Tape::compile(graph, &leaves, &[e]).ok(), leaves }
    }
}

/// A field in basic leaves, compiled.
#[derive(Debug)]
pub(super) struct Integrand {
    /// Basic leaves of the states, and the rate of each in basic leaves.
    pub(super) states: Vec<Leaf>,
    pub(super) rates: Vec<Expr>,
    /// The constants in the rates.
    pub(super) used: Vec<Leaf>,
    pub(super) flow: Flow,
}

/// An integrated motion.
#[derive(Clone, Debug)]
pub(super) struct Orbit {
    pub(super) field: Arc<Integrand>,
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
    /// Angles with their turns: they have no cut.
    pub(super) continued: Vec<Continued>,
    /// y and x of every angle atan2(y, x) in the formulas of the states: on its cut such a state leaps.
    pub(super) cuts: Vec<Arc<Program>>,
    /// Definitions of leaves in basic leaves.
    pub(super) definitions: BTreeMap<Leaf, Expr>,
}

impl Definitions for Core {
    fn time(&self) -> Leaf {
        self.time
    }

    fn known(&mut self) -> &mut BTreeMap<Leaf, Expr> {
        &mut self.definitions
    }

    fn integrated(&self) -> Option<(&[Leaf], &[Expr])> {
        self.orbit.as_deref().map(|o| (o.field.states.as_slice(), o.field.rates.as_slice()))
    }

    fn is_constant(&self, leaf: Leaf) -> bool {
        self.constants.iter().any(|c| c.leaf == leaf) || self.angles.iter().any(|a| a.turns == leaf)
    }

    fn continued(&self) -> &[Continued] {
        &self.continued
    }

    fn at_instant(&mut self, graph: &mut Graph, now: Leaf, instant: Expr) -> Result<Expr, FlowError> {
        let at = self.at(graph, now, instant)?;
        let value = self.instant_value(&at);
        Ok(self.constant(graph, value, Origin::At(Arc::new(at))))
    }
}

impl Core {
    /// What the formulas of some states, in basic leaves, have of angles with cuts.
    pub(super) fn note_cuts(&mut self, graph: &Graph, formulas: &[Expr]) -> Result<(), FlowError> {
        let cuts = self.cuts_of(graph, formulas)?;
        self.cuts.extend(cuts.map(Arc::new));
        Ok(())
    }

    /// y and x of the angles in some formulas; nothing where there are none but those that are followed.
    fn cuts_of(&self, graph: &Graph, formulas: &[Expr]) -> Result<Option<Program>, FlowError> {
        let followed = graph.arctan2s(self.continued.iter().map(|c| c.angle));
        let mut of = graph.arctan2s(formulas.iter().copied());
        of.retain(|sides| !followed.contains(sides));
        let of: Vec<Expr> = of.into_iter().flatten().collect();
        if of.is_empty() { Ok(None) } else { self.compile(graph, &of).map(Some) }
    }

    /// Whether a state may leap at a time: an angle in its formula is on its cut, as far as errors tell, and what it is there is
    /// the value of one side.
    pub(super) fn may_leap(&self, t: f64) -> bool {
        self.cuts.iter().any(|cuts| self.straddles(cuts, Bounded::exact(t)))
    }

    /// Whether one of some angles, given by y and x, may be on either side of its cut at a time, as far as that is known.
    fn straddles(&self, cuts: &Program, Bounded { value: t, error: slack }: Bounded) -> bool {
        let turns = self.turns(cuts, t, &mut Vec::new());
        let mut bench = cuts.bench::<Bounded>(self, usize::from(slack > 0.0));
        cuts.run(self, &mut bench, t, &turns);
        let value = |i: usize| {
            let x = cuts.output(&bench, i)?;
            let moved = if slack > 0.0 { 2.0 * slack * x.coefficient(1).magnitude() } else { 0.0 };
            let Bounded { value, error } = x.coefficient(0);
            Ok::<_, NoValue>(Bounded { value, error: error + moved })
        };
        (0..cuts.output_count() / 2).any(|i| match (value(2 * i), value(2 * i + 1)) {
            (Ok(y), Ok(x)) => y.straddles_cut(&x),
            (Err(_), _) | (_, Err(_)) => false,
        })
    }

    /// A new constant.
    pub(super) fn constant(&mut self, graph: &mut Graph, value: Result<Bounded, NoValue>, origin: Origin) -> Expr {
        let leaf = fresh(graph, "constant");
        self.note(leaf, value, origin);
        graph.leaf(leaf)
    }

    /// Takes note of a constant.
    pub(super) fn note(&mut self, leaf: Leaf, value: Result<Bounded, NoValue>, origin: Origin) {
        self.constants.push(Constant { leaf, value, origin, angles: self.angles.len() });
    }

    /// The value of an expression in constants; the time, if it occurs, is the initial time.
    pub(super) fn constant_value(&self, graph: &Graph, e: Expr) -> Result<Bounded, NoValue> {
        self.formula_value(&Formula::new(graph, e))
    }

    /// The same of one that is compiled.
    pub(super) fn formula_value(&self, formula: &Formula) -> Result<Bounded, NoValue> {
        let Some(tape) = &formula.tape else { return Err(NoValue::Unsupported) };
        let value = |&leaf: &Leaf| {
            if leaf == self.time {
                return Ok(Bounded::exact(self.initial_time));
            }
            let known = self.constants.iter().find(|c| c.leaf == leaf);
            known.map_or(Err(NoValue::Unsupported), |c| c.value)
        };
        let inputs: Vec<_> = formula.leaves.iter().map(value).collect();
        tape.determined(&inputs).pop().unwrap_or(Err(NoValue::Unsupported))
    }

    /// A leaf at a fixed time.
    fn at(&mut self, graph: &mut Graph, now: Leaf, instant: Expr) -> Result<Instant, FlowError> {
        let time = self.resolve(graph, instant)?;
        let value = self.definition(graph, now)?;
        let time = Formula::new(graph, time);
        Ok(Instant { time, cuts: self.cuts_of(graph, &[value])?, value: self.compile(graph, &[value])? })
    }

    /// The value of a definition at its fixed time.
    pub(super) fn instant_value(&self, instant: &Instant) -> Result<Bounded, NoValue> {
        let Instant { time, value: program, cuts } = instant;
        let time = self.formula_value(time)?;
        if self.cuts.iter().map(Arc::as_ref).chain(cuts).any(|cuts| self.straddles(cuts, time)) {
            return Err(NoValue::Indeterminate);
        }
        let turns = self.turns(program, time.value, &mut Vec::new());
        let coefficient = |order: usize| {
            let mut bench = program.bench::<Bounded>(self, order);
            program.run(self, &mut bench, time.value, &turns);
            program.output(&bench, 0).map(|x| x.coefficient(order))
        };
        if time.error == 0.0 {
            return coefficient(0);
        }
        // The fixed time itself is rounded.
        coefficient(0).and_then(|value| {
            let moved = 2.0 * time.error * coefficient(1)?.magnitude();
            Ok(Bounded { value: value.value, error: value.error + moved })
        })
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
