//! A motion: a trajectory and everything that formulas refer to along it.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use num_dual::Dual64;

use super::abreast::Halt;
use super::angle::{Angle, AngleBenches};
use super::core::{Core, Origin};
use super::definitions::{Continued, Definitions, fresh};
use super::error::{FlowError, Problem};
use super::estimate::Estimation;
use super::expansion::{Expansion, Memory};
use super::field::VectorField;
use super::incomplete::Incomplete;
use super::points::Points;
use super::program::{DualBench, Program};
use super::resolve::{Resolution, resolve};
use super::setup::Begun;
use super::start::Start;
use super::trajectory::Trajectory;
use super::zeros::{self, Minimum, Zeros};
use expr::{Expr, Graph, Leaf};
use number::{Bounded, NoValue};

/// The values of the prepared leaves at one time, in the order in which they were asked for.
pub type Point = Vec<Result<Bounded, NoValue>>;

/// Where the states of a motion come from.
#[derive(Clone, Debug)]
pub enum Source<'a> {
    /// A system and an initial value, in the parameters, for every state variable.
    Integrated {
        /// The system.
        field: &'a VectorField,
        /// State leaf and value at the initial time, in the parameters, the unknowns of `start`, and rates that the system gives.
        initial: Vec<(Leaf, Expr)>,
        /// What determines the unknowns.
        start: Start,
    },
    /// Every state is a formula in parameters and time.
    Formula {
        /// State leaf and formula.
        states: Vec<(Leaf, Expr)>,
    },
    /// Every state is an expression in what another motion knows, values at fixed times included.
    Derived {
        /// The other motion.
        from: Arc<Motion>,
        /// State leaf and expression in the leaves of the other motion.
        states: Vec<(Leaf, Expr)>,
    },
}

/// A quantity defined by an expression in states, rates, parameters, time and observables before it.
#[derive(Clone, Copy, Debug)]
pub struct Observable {
    /// The leaf that formulas use.
    pub leaf: Leaf,
    /// What it stands for.
    pub definition: Expr,
    /// Whether the value is an angle modulo 2π, to be continuous along the motion.
    pub angle: bool,
}

/// Everything a motion is made from.
#[derive(Clone, Debug)]
pub struct Setup<'a> {
    /// The time.
    pub time: Leaf,
    /// First and last time. For a derived motion, that of the source is used.
    pub span: (f64, f64),
    /// Where the initial values hold, and from where angles are continuous; in the span.
    pub initial_time: f64,
    /// Parameters in an order in which each depends on earlier ones only.
    pub parameters: Vec<(Leaf, Expr)>,
    /// The states.
    pub source: Source<'a>,
    /// Observables in an order in which each depends on earlier ones only.
    pub observables: Vec<Observable>,
}

/// What [`Motion::prepare`] compiles.
#[derive(Clone, Debug)]
struct Prepared {
    core: Core,
    leaves: Expansion,
    dual: Arc<Program>,
    /// Output for the value (with whether it is in the tangent) and for the rate of every leaf.
    dual_places: Arc<[(usize, Option<usize>)]>,
}

/// Memory of one evaluation.
#[derive(Debug, Default)]
struct Scratch {
    leaves: Memory,
    dual: Option<DualBench>,
    angles: AngleBenches,
}

/// A motion. Evaluation takes `&self` and may run on many threads.
///
/// Formulas are compiled once by [`Motion::prepare`]; then [`Motion::at`] yields the values at a time.
#[derive(Debug)]
pub struct Motion {
    pub(super) core: Core,
    /// Leaves with a definition that was given, not derived.
    given: Arc<[Leaf]>,
    prepared: Option<Prepared>,
    pool: Mutex<Vec<Scratch>>,
}

impl Clone for Motion {
    fn clone(&self) -> Motion {
        Motion {
            core: self.core.clone(),
            given: self.given.clone(),
            prepared: self.prepared.clone(),
            pool: Mutex::default(),
        }
    }
}

/// For each parameter the first one that is given in the same way, if that is no number of binary64: what stands for the one stands for
/// the other, so that what is equal in the file is equal, though neither is known exactly. All others stand for themselves.
pub(super) fn shared(graph: &Graph, parameters: &[(Leaf, Expr)]) -> Vec<usize> {
    let mut first: BTreeMap<Expr, usize> = BTreeMap::new();
    let of = |(at, &(_, e)): (usize, &(Leaf, Expr))| match graph.is_binary64(e) {
        true => at,
        false => *first.entry(e).or_insert(at),
    };
    parameters.iter().enumerate().map(of).collect()
}

/// A motion that is set up, but not integrated.
#[derive(Debug)]
pub struct Draft {
    core: Core,
    states: Vec<(Leaf, Expr)>,
    observables: Vec<Observable>,
    orbit: Option<Begun>,
}

impl Draft {
    /// What is set up.
    pub(super) fn of(core: Core, orbit: Begun) -> Draft {
        Draft { core, states: Vec::new(), observables: Vec::new(), orbit: Some(orbit) }
    }

    /// With its trajectory, which is integrated, if that was not done; nothing else is done.
    pub(super) fn integrated(self) -> Result<Core, FlowError> {
        let orbit = self.orbit.map(Begun::finish).transpose()?.map(Arc::new);
        Ok(Core { orbit, ..self.core })
    }

    /// Sets a motion up.
    ///
    /// # Errors
    /// As [`Motion::new`].
    pub fn new(graph: &mut Graph, setup: Setup) -> Result<Draft, FlowError> {
        let derived = matches!(setup.source, Source::Derived { .. });
        let (from, to) = setup.span;
        let inside = from <= setup.initial_time && setup.initial_time <= to;
        let valid = from.is_finite() && to.is_finite() && from < to && inside;
        if !(derived || valid) {
            return Err(FlowError::Span { span: setup.span, initial_time: setup.initial_time });
        }
        let mut core = Core {
            time: setup.time,
            initial_time: setup.initial_time,
            span: setup.span,
            orbit: None,
            resolution: Resolution::default(),
            constants: Vec::new(),
            angles: Vec::new(),
            continued: Vec::new(),
            cuts: Vec::new(),
            definitions: BTreeMap::new(),
        };
        // States that come from another motion are resolved with its definitions, which are then forgotten.
        let mut states: Vec<(Leaf, Expr)> = Vec::new();
        if let Source::Derived { from, states: map } = &setup.source {
            core = from.core.clone();
            for &(leaf, e) in map {
                states.push((leaf, core.resolve(graph, e)?));
            }
            core.definitions.clear();
        }
        let time = graph.leaf(setup.time);
        core.definitions.insert(setup.time, time);
        let shared = shared(graph, &setup.parameters);
        let mut constants: Vec<Expr> = Vec::new();
        for (&(leaf, e), first) in setup.parameters.iter().zip(shared) {
            let resolved = core.resolve(graph, e)?;
            let value = core.constant_value(graph, resolved);
            constants.push(core.constant(graph, value, Origin::Given));
            core.definitions.insert(leaf, constants[first]);
        }
        let mut orbit = None;
        match &setup.source {
            Source::Derived { .. } => {}
            Source::Formula { states: formulas } => {
                for &(leaf, e) in formulas {
                    states.push((leaf, core.resolve(graph, e)?));
                }
            }
            Source::Integrated { field, initial, start } => {
                orbit = Some(core.set_up(graph, field, initial, start)?);
            }
        }
        Ok(Draft { core, states, observables: setup.observables, orbit })
    }

    /// Integrates several motions, as far as there is something to integrate: those of one field side by side, each as it is alone,
    /// bit for bit. `halt` is asked between steps whether to stop; `false` if it said so: then they are of no use.
    pub fn integrate<'d>(drafts: impl IntoIterator<Item = &'d mut Draft>, estimation: Estimation, halt: Halt) -> bool {
        Begun::integrate(drafts.into_iter().filter_map(|d| d.orbit.as_mut()).collect(), estimation, halt)
    }

    /// The motion; integrates it, if that was not done.
    ///
    /// # Errors
    /// As [`Motion::new`].
    pub fn finish(self, graph: &mut Graph) -> Result<Motion, FlowError> {
        let Draft { mut core, states, observables, orbit } = self;
        core.orbit = match orbit {
            Some(begun) => Some(Arc::new(begun.finish()?)),
            None => core.orbit,
        };
        let formulas: Vec<Expr> = states.iter().map(|(_, e)| *e).collect();
        core.note_cuts(graph, &formulas)?;
        core.definitions.extend(states);
        let given = core.definitions.keys().copied().collect();
        match core.orbit {
            Some(_) => core.resolution = Resolution::default(),
            None => {
                let roots: Vec<Expr> = core.definitions.values().copied().collect();
                let formulas = core.compile(graph, &roots)?;
                core.resolution = resolve(&core, &formulas);
            }
        }
        for Observable { leaf, definition, angle } in observables {
            let mut resolved = core.resolve(graph, definition)?;
            if angle {
                let raw = core.compile(graph, &[resolved])?;
                let turns = fresh(graph, "turns");
                let followed = Angle::follow(&core, turns, raw);
                core.angles.push(Arc::new(followed));
                let turns = graph.leaf(turns);
                let raw = resolved;
                resolved = graph.add(raw, turns);
                let rate = core.derivative(graph, raw).ok().map(|rate| graph.continued(raw, rate));
                core.continued.push(Continued { angle: resolved, raw, rate });
            }
            core.definitions.insert(leaf, resolved);
        }
        Ok(Motion { core, given, prepared: None, pool: Mutex::default() })
    }
}

impl Motion {
    /// The motion with these numbers, prepared as this one is.
    pub(super) fn again(&self, core: Core) -> Motion {
        let prepared = self.prepared.as_ref().map(|prepared| {
            let with_leaves = prepared.core.again(&core);
            let leaves = prepared.leaves.again(&with_leaves);
            Prepared {
                core: with_leaves,
                leaves,
                dual: Arc::clone(&prepared.dual),
                dual_places: Arc::clone(&prepared.dual_places),
            }
        });
        Motion { core, given: Arc::clone(&self.given), prepared, pool: Mutex::default() }
    }

    /// Integrates, or sets up, a motion.
    ///
    /// A parameter without a value is no error; what depends on it has no value either. A trajectory that ends early is
    /// kept, see [`Motion::problem`].
    ///
    /// # Errors
    /// [`FlowError::Span`]; [`FlowError::UnknownLeaf`] and [`FlowError::NoDerivative`] for definitions that cannot be traced
    /// back to states, parameters and time; [`FlowError::NoInitial`], [`FlowError::Undefined`] (an initial value or a
    /// coefficient of the system without a value) and [`FlowError::Singular`] for a system that cannot start.
    pub fn new(graph: &mut Graph, setup: Setup) -> Result<Motion, FlowError> {
        Draft::new(graph, setup)?.finish(graph)
    }

    /// Compiles everything that [`Motion::at`] and [`Motion::dual_at`] shall yield: values now and at fixed times, and
    /// rates of any order, of states, parameters, observables and the time. Replaces what was prepared before.
    ///
    /// # Errors
    /// [`FlowError::UnknownLeaf`], [`FlowError::NoDerivative`].
    pub fn prepare(&mut self, graph: &mut Graph, wanted: &[Leaf]) -> Result<(), FlowError> {
        let mut core = self.core.clone();
        let (mut roots, mut places) = (Vec::new(), Vec::new());
        let (mut dual_roots, mut dual_places) = (Vec::new(), Vec::new());
        let place = |roots: &mut Vec<Expr>, e: Expr| {
            roots.iter().position(|&r| r == e).unwrap_or_else(|| {
                roots.push(e);
                roots.len() - 1
            })
        };
        for &leaf in wanted {
            // The rate of highest order that has a definition of its own; the others follow from its series.
            let mut base = leaf;
            if leaf.instant.is_none() {
                while base.rate > 0 && !self.given.contains(&base) {
                    base.rate -= 1;
                }
            }
            let order = usize::from(leaf.rate - base.rate);
            let definition = core.definition(graph, base)?;
            places.push((place(&mut roots, definition), order));
            let mut value = definition;
            if order > 1 {
                value = core.definition(graph, Leaf { rate: leaf.rate - 1, ..leaf })?;
            }
            let value = place(&mut dual_roots, value);
            // An operation without a symbolic derivative leaves the value, but no rate.
            let rate = if order == 0 { None } else { core.definition(graph, leaf).ok() };
            dual_places.push((value, if order == 0 { Some(value) } else { rate.map(|r| place(&mut dual_roots, r)) }));
        }
        let program = core.compile(graph, &roots)?;
        let dual = core.compile(graph, &dual_roots)?;
        let leaves = Expansion::new(&core, program, places);
        let (dual, dual_places) = (Arc::new(dual), dual_places.into());
        self.prepared = Some(Prepared { core, leaves, dual, dual_places });
        self.pool = Mutex::default();
        Ok(())
    }

    fn with_scratch<T>(&self, work: impl FnOnce(&mut Scratch) -> T) -> T {
        let taken = self.pool.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let mut scratch = taken.unwrap_or_default();
        let out = work(&mut scratch);
        self.pool.lock().unwrap_or_else(PoisonError::into_inner).push(scratch);
        out
    }

    /// Gives back the memory of evaluations; the next one takes it anew.
    pub fn rest(&self) {
        self.pool.lock().unwrap_or_else(PoisonError::into_inner).clear();
    }

    /// The prepared leaves at a time; empty before [`Motion::prepare`].
    ///
    /// Outside the times of the trajectory nothing that depends on it has a value.
    ///
    /// # Error bound
    /// The error of a state is the estimate of its trajectory; from there on bounds are propagated.
    pub fn at(&self, t: f64) -> Point {
        let Some(prepared) = &self.prepared else { return Vec::new() };
        if self.core.may_leap(t) {
            return prepared.leaves.orders().map(|_| Err(NoValue::Indeterminate)).collect();
        }
        self.with_scratch(|scratch| prepared.leaves.at(&prepared.core, &mut scratch.leaves, t).0)
    }

    /// The program of the prepared leaves, where they follow from its inputs alone.
    pub(super) fn direct(&self) -> Option<&Arc<Program>> {
        self.prepared.as_ref().filter(|_| self.core.cuts.is_empty())?.leaves.direct()
    }

    /// The output of every prepared leaf.
    pub(super) fn outputs(&self) -> impl Iterator<Item = usize> {
        self.prepared.iter().flat_map(|prepared| prepared.leaves.outputs())
    }

    /// A constant of the prepared leaves.
    pub(super) fn constant(&self, at: usize) -> Result<Bounded, NoValue> {
        let constant = self.prepared.as_ref().and_then(|prepared| prepared.core.constants.get(at));
        constant.map_or(Err(NoValue::Unsupported), |constant| constant.value)
    }

    /// What was integrated.
    pub(super) fn trajectory(&self) -> Option<&Trajectory> {
        self.core.orbit.as_ref().map(|orbit| &orbit.trajectory)
    }

    /// The prepared leaves at many times; no times before [`Motion::prepare`].
    ///
    /// Values and error bounds are those of [`Motion::at`], except that a bound may be larger by a few units in its last
    /// place.
    pub fn along(&self, times: &[f64]) -> Points {
        let Some(prepared) = &self.prepared else { return Points::default() };
        if !self.core.cuts.is_empty() {
            return times.iter().map(|&t| self.at(t)).collect();
        }
        // Blocks take much memory, and are asked for once.
        prepared.leaves.along(&prepared.core, &mut Memory::default(), times)
    }

    /// The same for some of the prepared leaves, by their positions: the others have no values.
    pub fn along_some(&self, times: &[f64], leaves: &[usize]) -> Points {
        let Some(prepared) = &self.prepared else { return Points::default() };
        if !self.core.cuts.is_empty() {
            return self.along(times);
        }
        let part = prepared.leaves.part(leaves);
        let found = part.along(&prepared.core, &mut Memory::default(), times);
        let mut places = vec![None; prepared.leaves.orders().count()];
        leaves.iter().enumerate().for_each(|(i, &leaf)| places[leaf] = Some(i));
        found.arranged(&places)
    }

    /// The prepared leaves at the dual time t + ε, by dual numbers: each with its rate.
    ///
    /// An independent route to what [`Motion::at`] yields from series: the rate of a leaf that is wanted with order n ≥ 1
    /// is the tangent of its (n − 1)-th rate. A rate is NaN where it cannot be written as an expression.
    pub fn dual_at(&self, t: f64) -> Vec<Result<Dual64, NoValue>> {
        let Some(prepared) = &self.prepared else { return Vec::new() };
        self.with_scratch(|scratch| {
            let exact = prepared.leaves.at_branch_point(&prepared.core, &mut scratch.leaves, t);
            let turns = prepared.core.turns(&prepared.dual, t, &mut scratch.angles);
            let bench = scratch.dual.get_or_insert_with(|| prepared.dual.dual_bench(&prepared.core));
            let found = prepared.dual.run_dual(&prepared.core, bench, t, &turns);
            let get = |i: usize| found.get(i).copied().unwrap_or(Err(NoValue::Unsupported));
            let leaf = |at: usize, (value, rate): (usize, Option<usize>), order: usize| {
                let x = get(value)?;
                if let (Some(exact), true) = (&exact, order > 0) {
                    // A dual number knows too little of its argument here.
                    exact.get(at).copied().unwrap_or(Err(NoValue::Indeterminate))?;
                }
                if order == 0 {
                    return Ok(x);
                }
                let rate = rate.and_then(|r| get(r).ok()).map_or(f64::NAN, |r| r.eps);
                Ok(Dual64::new(x.eps, rate))
            };
            let places = prepared.dual_places.iter().zip(prepared.leaves.orders()).enumerate();
            places.map(|(at, (&dual, order))| leaf(at, dual, order)).collect()
        })
    }

    /// Times at which to look: `density` Chebyshev points of every step, and the ends of steps; ascending.
    ///
    /// A motion by formulas is cut into stretches on each of which its states are polynomials up to rounding.
    pub fn sample_times(&self, density: usize) -> Vec<f64> {
        let cuts = self.core.boundaries();
        let mut times = Vec::with_capacity(cuts.len() * (density + 1));
        let share = |k: usize| {
            let angle = std::f64::consts::PI * (2 * k + 1) as f64 / (2 * density) as f64;
            0.5 - 0.5 * pxfm::f_cos(angle)
        };
        let shares: Vec<f64> = (0..density).map(share).collect();
        for pair in cuts.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            times.push(a);
            times.extend(shares.iter().map(|share| a + (b - a) * share));
        }
        times.extend(cuts.last());
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// Where the formulas of a motion by formulas are not known from samples: they have no value, or may have none, or do
    /// more between two samples than samples can show.
    pub fn unresolved(&self) -> &[Incomplete] {
        &self.core.resolution.gaps
    }

    /// Whether the formulas of the states have angles with cuts, at which they leap: there they have a value that is not known.
    pub fn leaps(&self) -> bool {
        !self.core.cuts.is_empty()
    }

    /// Times, known to about a billionth of the span, at which a state of a motion by formulas has a corner, and a rate no value.
    pub fn corners(&self) -> &[f64] {
        &self.core.resolution.corners
    }

    /// All zeros along the motion of an expression in leaves.
    ///
    /// # Errors
    /// [`FlowError::UnknownLeaf`], [`FlowError::NoDerivative`]; what could not be decided is in [`Zeros::incomplete`].
    pub fn zeros(&self, graph: &mut Graph, g: Expr) -> Result<Zeros, FlowError> {
        let mut core = self.core.clone();
        let resolved = core.resolve(graph, g)?;
        let program = core.compile(graph, &[resolved])?;
        Ok(zeros::zeros(&core, &program))
    }

    /// The smallest absolute value along the motion of an expression in leaves; `None` if it has no value anywhere.
    ///
    /// # Errors
    /// [`FlowError::UnknownLeaf`], [`FlowError::NoDerivative`].
    pub fn minimum(&self, graph: &mut Graph, g: Expr) -> Result<Option<Minimum>, FlowError> {
        let mut core = self.core.clone();
        let resolved = core.resolve(graph, g)?;
        let program = core.compile(graph, &[resolved])?;
        Ok(zeros::minimum(&core, &program))
    }

    /// The times between which the motion is known; shorter than asked for if there is a [`Motion::problem`].
    pub fn span(&self) -> (f64, f64) {
        self.core.reach()
    }

    /// Where the initial values hold.
    pub fn initial_time(&self) -> f64 {
        self.core.initial_time
    }

    /// Why the trajectory ends before its span does.
    pub fn problem(&self) -> Option<&Problem> {
        self.core.orbit.as_ref().and_then(|o| o.trajectory.problem())
    }

    /// Whether its errors are from its own steps ([`Estimation::Steps`]): companions may show that they are less.
    pub fn is_by_steps(&self) -> bool {
        self.core.orbit.as_ref().is_some_and(|o| o.trajectory.is_by_steps())
    }

    /// Number of steps of the integration; 0 for formulas.
    pub fn steps(&self) -> usize {
        self.core.orbit.as_ref().map_or(0, |o| o.trajectory.boundaries().len() - 1)
    }

    /// Integrates once more over the same span, keeping every polynomial but not estimating errors: for benchmarks.
    #[doc(hidden)]
    pub fn integrate_again(&self) -> usize {
        self.core.orbit.as_ref().map_or(0, |o| o.trajectory.again(&o.field.flow, &o.constants))
    }

    /// The largest estimated error over the span of every integrated state variable, in the order of the field; empty for
    /// formulas. A derived motion has that of its source.
    pub fn error(&self) -> Vec<f64> {
        self.core.orbit.as_ref().map_or_else(Vec::new, |o| o.trajectory.largest_errors())
    }

    /// The integrated states and their estimated errors at a time, in the order of the field; empty for formulas.
    pub fn state(&self, t: f64) -> Vec<Bounded> {
        let Some(orbit) = &self.core.orbit else { return Vec::new() };
        let place = orbit.trajectory.place(t);
        (0..orbit.field.states.len()).map(|i| orbit.trajectory.bounded(place, i)).collect()
    }

    /// Times at which an angle of this motion has no value, so that a new branch starts there; ascending.
    pub fn breaks(&self) -> Vec<f64> {
        let mut times: Vec<f64> = self.core.angles.iter().flat_map(|a| a.breaks.iter().copied()).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }
}
