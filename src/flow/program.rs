//! Expressions of a motion, compiled, and evaluated at a time in several arithmetics.

use num_dual::Dual;

use super::arguments::{Arguments, changes_sign, moves};
use super::core::Core;
use super::trajectory::{ORDER, Place, Trajectory};
use expr::domain::{Change, Place as At, Term, row};
use expr::tape::{Slots, Tape};
use expr::{Expr, Graph, Leaf};
use number::{Bounded, BoundedLanes, Interval, Jet, Lanes, NoValue, Number, Orders, Scalar};

/// Where an input of a program comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Input {
    Time,
    State(usize),
    Constant(usize),
    /// 2π times the number of turns of an angle.
    Turns(usize),
    /// What no output depends on.
    Unused,
}

impl Input {
    /// Whether it moves.
    fn moves(&self) -> bool {
        match self {
            Input::Time | Input::State(_) => true,
            Input::Constant(_) | Input::Turns(_) | Input::Unused => false,
        }
    }
}

/// Expressions in the basic leaves of a motion, as one tape.
#[derive(Clone, Debug)]
pub(super) struct Program {
    pub(super) tape: Tape,
    pub(super) inputs: Vec<Input>,
    moving: bool,
    /// The states among the inputs, increasing.
    pub(super) needs: Vec<usize>,
    /// Branch points: see [`branches`].
    branches: Vec<(Term, usize)>,
    /// What hides what is small elsewhere.
    arguments: Arguments,
}

/// Numbers in which states and turns are available.
pub(super) trait Base: Scalar {
    fn from_bounded(x: Bounded) -> Self;
}

impl Base for f64 {
    fn from_bounded(x: Bounded) -> f64 {
        x.value
    }
}

impl Base for Bounded {
    fn from_bounded(x: Bounded) -> Bounded {
        x
    }
}

impl<const N: usize> Base for BoundedLanes<N> {
    fn from_bounded(x: Bounded) -> BoundedLanes<N> {
        BoundedLanes::splat(x)
    }
}

impl<const N: usize> Base for Lanes<N> {
    fn from_bounded(x: Bounded) -> Lanes<N> {
        Lanes::splat(x.value)
    }
}

impl Base for Interval {
    fn from_bounded(x: Bounded) -> Interval {
        Interval::ball(x.value, x.error)
    }
}

/// The memory of one program and its field over series of one degree.
#[derive(Clone, Debug)]
pub(super) struct Bench<B> {
    degree: usize,
    field: Option<Slots<Jet<B>>>,
    /// Whether states are the polynomials of the steps, not grown anew.
    of_steps: bool,
    slots: Slots<Jet<B>>,
    /// The states that are needed, and the values of all.
    states: Vec<usize>,
    state: Vec<B>,
    coefficients: Vec<B>,
}

/// The memory of one program over dual numbers.
#[derive(Clone, Debug)]
pub(super) struct DualBench {
    field: Option<Slots<Jet<f64>>>,
    slots: Slots<Dual<f64>>,
    state: Vec<f64>,
    coefficients: Vec<f64>,
}

/// Number of turns of every angle at one time, or why it has none.
pub(super) type Turns = Vec<Result<i64, NoValue>>;

/// The slots of arguments and the term of them whose zero is a branch point, for each that the steps have.
fn branches(tape: &Tape) -> Vec<(Term, usize)> {
    let mut out = Vec::new();
    for step in tape.instructions() {
        let steep = row(step.op).edges.into_iter().filter(|edge| edge.change == Change::Steep);
        out.extend(steep.filter_map(|edge| match edge.place {
            At::Zero(Term::Second) => Some((Term::First, step.b as usize)),
            At::Zero(term) => Some((term, step.a as usize)),
            At::ZeroWhile(..) | At::Infinity => None,
        }));
    }
    out
}

/// 2π·n with its rounding error.
fn turns(n: i64) -> Result<Bounded, NoValue> {
    if n == 0 {
        return Ok(Bounded::exact(0.0));
    }
    let (mut pi, mut out) = (Bounded::exact(0.0), Bounded::exact(0.0));
    pi.pi(&())?;
    out.mul(&(), &pi, &Bounded::exact(2.0 * n as f64))?;
    Ok(out)
}

/// One time, or several, around which a program is expanded.
trait When<B> {
    /// The time.
    fn time(&self) -> B;
    /// Whether it lies between two times.
    fn is_within(&self, reach: (f64, f64)) -> bool;
    /// Some states, put in their places; nothing else is changed there.
    fn states(&self, trajectory: &Trajectory, states: &[usize], out: &mut [B]);
    /// The polynomial of the step in which the time lies, around it.
    fn polynomial(&self, trajectory: &Trajectory, i: usize, out: &mut [B]);
    /// 2π times the number of turns of an angle.
    fn turns(&self, angle: usize) -> Result<B, NoValue>;
}

/// One time.
struct Instant<'a> {
    t: f64,
    place: Option<Place>,
    turns: &'a Turns,
}

fn turns_of(all: &Turns, angle: usize) -> Result<Bounded, NoValue> {
    all.get(angle).copied().unwrap_or(Err(NoValue::Indeterminate)).and_then(turns)
}

impl<B: Base> When<B> for Instant<'_> {
    fn time(&self) -> B {
        B::from_bounded(Bounded::exact(self.t))
    }
    fn is_within(&self, (from, to): (f64, f64)) -> bool {
        from <= self.t && self.t <= to
    }
    fn states(&self, trajectory: &Trajectory, states: &[usize], out: &mut [B]) {
        let state = |i| self.place.map_or(B::INVALID, |place| B::from_bounded(trajectory.bounded(place, i)));
        states.iter().for_each(|&i| out[i] = state(i));
    }
    fn polynomial(&self, trajectory: &Trajectory, i: usize, out: &mut [B]) {
        let mut polynomial = [0.0; ORDER + 1];
        let polynomial = &mut polynomial[..out.len().min(ORDER + 1)];
        if let Some(place) = self.place {
            trajectory.around(place, i, polynomial);
        }
        for (to, &from) in out.iter_mut().zip(polynomial.iter()) {
            *to = B::from_bounded(Bounded::exact(from));
        }
    }
    fn turns(&self, angle: usize) -> Result<B, NoValue> {
        turns_of(self.turns, angle).map(B::from_bounded)
    }
}

/// Several times.
struct Instants<'a, const N: usize> {
    times: &'a [f64; N],
    places: Option<[Place; N]>,
    turns: &'a [Turns; N],
}

/// Numbers of several times.
pub(super) trait Wide<const N: usize>: Base {
    /// One for each time.
    fn of(each: [Bounded; N]) -> Self;
}

impl<const N: usize> Wide<N> for BoundedLanes<N> {
    fn of(each: [Bounded; N]) -> Self {
        BoundedLanes::of(each)
    }
}

impl<const N: usize> Wide<N> for Lanes<N> {
    fn of(each: [Bounded; N]) -> Self {
        Lanes(each.map(|x| x.value))
    }
}

impl<const N: usize, B: Wide<N>> When<B> for Instants<'_, N> {
    fn time(&self) -> B {
        B::of(self.times.map(Bounded::exact))
    }
    fn is_within(&self, (from, to): (f64, f64)) -> bool {
        self.times.iter().all(|&t| from <= t && t <= to)
    }
    fn states(&self, trajectory: &Trajectory, states: &[usize], out: &mut [B]) {
        match &self.places {
            Some(places) => trajectory.bounded_values(places, states, |i, x| out[i] = B::of(x)),
            None => states.iter().for_each(|&i| out[i] = B::INVALID),
        }
    }
    fn polynomial(&self, trajectory: &Trajectory, i: usize, out: &mut [B]) {
        let mut each = [[0.0; N]; ORDER + 1];
        let length = out.len().min(ORDER + 1);
        if let Some(places) = &self.places {
            trajectory.around_lanes(places, i, &mut each[..length]);
        }
        for (to, from) in out.iter_mut().zip(each) {
            *to = B::of(from.map(Bounded::exact));
        }
    }
    fn turns(&self, angle: usize) -> Result<B, NoValue> {
        let mut each = [Bounded::exact(0.0); N];
        for (x, all) in each.iter_mut().zip(self.turns) {
            *x = turns_of(all, angle)?;
        }
        Ok(B::of(each))
    }
}

impl Program {
    /// Compiles resolved expressions.
    ///
    /// # Errors
    /// A leaf that is not basic.
    pub(super) fn compile(core: &Core, graph: &Graph, roots: &[Expr]) -> Result<Program, Leaf> {
        let leaves = graph.leaves(roots.iter().copied());
        let input = |&leaf: &Leaf| {
            if leaf == core.time {
                return Ok(Input::Time);
            }
            let state = core.orbit.as_ref().and_then(|o| o.field.states.iter().position(|&l| l == leaf));
            let constant = || core.constants.iter().position(|c| c.leaf == leaf);
            let angle = || core.angles.iter().position(|a| a.turns == leaf);
            state
                .map(Input::State)
                .or_else(|| constant().map(Input::Constant))
                .or_else(|| angle().map(Input::Turns))
                .ok_or(leaf)
        };
        let inputs: Vec<Input> = leaves.iter().map(input).collect::<Result<_, _>>()?;
        let dimension = core.orbit.as_ref().map_or(0, |o| o.field.states.len());
        let needs: Vec<usize> = (0..dimension).filter(|i| inputs.contains(&Input::State(*i))).collect();
        let moving = !needs.is_empty();
        let tape = Tape::compile(graph, &leaves, roots)?;
        let (branches, arguments) =
            (branches(&tape), Arguments::of(&tape, &inputs.iter().map(Input::moves).collect::<Vec<_>>()));
        Ok(Program { tape, inputs, moving, needs, branches, arguments })
    }

    /// The same for some of the outputs, in the order of `outputs`.
    pub(super) fn part(&self, outputs: &[usize]) -> Program {
        let tape = self.tape.part(outputs);
        let mut used = vec![false; tape.slot_count()];
        tape.instructions().iter().for_each(|i| [i.a, i.b].iter().for_each(|&slot| used[slot as usize] = true));
        (0..outputs.len()).for_each(|i| used[tape.output_slot(i)] = true);
        let kept = |(&input, used): (&Input, &bool)| if *used { input } else { Input::Unused };
        let inputs: Vec<Input> = self.inputs.iter().zip(&used).map(kept).collect();
        let needs: Vec<usize> = self.needs.iter().copied().filter(|i| inputs.contains(&Input::State(*i))).collect();
        let (moving, branches) = (!needs.is_empty(), branches(&tape));
        let arguments = Arguments::of(&tape, &inputs.iter().map(Input::moves).collect::<Vec<_>>());
        Program { tape, inputs, moving, needs, branches, arguments }
    }

    pub(super) fn output_count(&self) -> usize {
        self.tape.output_count()
    }

    /// Whether an angle's turns are among the inputs.
    pub(super) fn needs_turns(&self) -> bool {
        self.turns().next().is_some()
    }

    /// The angles whose turns are among the inputs.
    pub(super) fn turns(&self) -> impl Iterator<Item = usize> + '_ {
        self.inputs.iter().filter_map(|i| match i {
            Input::Turns(angle) => Some(*angle),
            _ => None,
        })
    }

    /// Memory for series up to `degree`.
    pub(super) fn bench<B: Base>(&self, core: &Core, degree: usize) -> Bench<B> {
        self.memory(core, degree, false)
    }

    /// Memory for series that are made from the polynomials of the steps, up to a degree that is not above theirs.
    pub(super) fn bench_of_steps<B: Base>(&self, core: &Core, degree: usize) -> Bench<B> {
        self.memory(core, degree, true)
    }

    fn memory<B: Base>(&self, core: &Core, degree: usize, of_steps: bool) -> Bench<B> {
        let orders = Orders::all(degree);
        let mut slots = self.tape.slots::<Jet<B>>(&orders);
        for (at, input) in self.inputs.iter().enumerate() {
            if let Input::Constant(i) = input {
                let value = core.constants[*i].value;
                slots.set(at, value.map(|c| Jet::constant(B::from_bounded(c), &orders)));
            }
        }
        let orbit = core.orbit.as_deref().filter(|_| self.moving);
        let field = orbit.filter(|_| degree > 0 && !of_steps).map(|o| {
            let constants: Vec<B> = o.constants.iter().map(|&c| B::from_bounded(c)).collect();
            o.field.flow.slots(degree, &constants)
        });
        let n = orbit.map_or(0, |o| o.field.states.len());
        let coefficients = vec![B::ZERO; n * (degree + 1)];
        let states = if field.is_some() { (0..n).collect() } else { self.needs.clone() };
        Bench { degree, field, of_steps, slots, states, state: vec![B::ZERO; n], coefficients }
    }

    /// Expands all outputs around the time `t`; they are then read with [`Program::output`].
    pub(super) fn run<B: Base>(&self, core: &Core, bench: &mut Bench<B>, t: f64, of: &Turns) {
        let place = core.orbit.as_deref().filter(|_| self.moving).map(|o| o.trajectory.place(t));
        self.expand(core, bench, &Instant { t, place, turns: of });
    }

    /// Expands all outputs around several times at once. An output has a value only if it has one at all of them.
    pub(super) fn run_lanes<const N: usize, B: Wide<N>>(
        &self,
        core: &Core,
        bench: &mut Bench<B>,
        times: &[f64; N],
        of: &[Turns; N],
    ) {
        let places = core.orbit.as_deref().filter(|_| self.moving).map(|o| o.trajectory.places(times));
        self.expand(core, bench, &Instants { times, places, turns: of });
    }

    fn expand<B: Base>(&self, core: &Core, bench: &mut Bench<B>, when: &impl When<B>) {
        let orders = Orders::all(bench.degree);
        let row = bench.degree + 1;
        let mut missing = None;
        if let Some(orbit) = core.orbit.as_deref().filter(|_| self.moving) {
            // The field needs all states, the value of the outputs only their own.
            when.states(&orbit.trajectory, &bench.states, &mut bench.state);
            if !when.is_within(orbit.trajectory.reach()) || bench.state.iter().any(|x| x.checked().is_err()) {
                missing = Some(NoValue::Indeterminate);
            } else if let Some(field) = &mut bench.field {
                let grown =
                    orbit.field.flow.expand(field, bench.degree, when.time(), &bench.state, &mut bench.coefficients);
                missing = grown.err().map(|(_, reason)| reason);
            } else if bench.of_steps {
                // Each polynomial is shifted to another middle.
                meter::charge((self.needs.len() * row * row) as u64 * (2 + size_of::<B>() as u64 / 16) / 8);
                for &i in &self.needs {
                    when.polynomial(&orbit.trajectory, i, &mut bench.coefficients[i * row..(i + 1) * row]);
                }
            } else {
                bench.coefficients.copy_from_slice(&bench.state);
            }
        }
        for (at, input) in self.inputs.iter().enumerate() {
            match *input {
                Input::Constant(_) | Input::Unused => {}
                Input::Time => {
                    let slot = bench.slots.value_mut(at);
                    slot.set_coefficient(0, when.time());
                    slot.set_coefficient(1, B::integer(1));
                }
                Input::State(i) => {
                    if let Some(reason) = missing {
                        bench.slots.set(at, Err(reason));
                        continue;
                    }
                    if bench.slots.missing(at).is_some() {
                        bench.slots.set(at, Ok(Jet::constant(B::ZERO, &orders)));
                    }
                    let slot = bench.slots.value_mut(at);
                    for (k, &c) in bench.coefficients[i * row..(i + 1) * row].iter().enumerate() {
                        slot.set_coefficient(k, c);
                    }
                }
                Input::Turns(i) => match when.turns(i) {
                    Ok(shift) => {
                        if bench.slots.missing(at).is_some() {
                            bench.slots.set(at, Ok(Jet::constant(B::ZERO, &orders)));
                        }
                        bench.slots.value_mut(at).set_coefficient(0, shift);
                    }
                    Err(reason) => bench.slots.set(at, Err(reason)),
                },
            }
        }
        self.tape.run(&orders, &mut bench.slots);
    }

    /// Expands all outputs around all times of an interval, for programs in the time and constants alone.
    pub(super) fn run_over(&self, core: &Core, bench: &mut Bench<Interval>, time: Interval) {
        debug_assert!(!self.moving && !self.needs_turns() && core.orbit.is_none());
        for (at, input) in self.inputs.iter().enumerate() {
            if *input == Input::Time {
                let slot = bench.slots.value_mut(at);
                slot.set_coefficient(0, time);
                slot.set_coefficient(1, Interval::point(1.0));
            }
        }
        self.tape.run(&Orders::all(bench.degree), &mut bench.slots);
    }

    /// Whether an operation was evaluated at its branch point with an argument that looks constant to the degree of the
    /// series: √(c·h²) is then taken for a constant. Twice the degree tells.
    pub(super) fn at_branch_point<B: Base>(&self, bench: &Bench<B>) -> bool {
        bench.degree > 0 && self.is_at_branch_value(bench)
    }

    /// The same, whatever the degree; of values alone, whether there may be a branch point.
    pub(super) fn is_at_branch_value<B: Base>(&self, bench: &Bench<B>) -> bool {
        self.branches.iter().any(|&(term, slot)| {
            let argument = bench.slots.value(slot);
            let branch = term.vanishes(argument.coefficient(0));
            bench.slots.missing(slot).is_none() && argument.is_constant() && branch
        })
    }

    /// Whether all arguments move moderately up to a radius: `of` is one of the numbers in a coefficient, `error` that of a value.
    pub(super) fn is_moderate<B: Base, V: Base>(
        &self,
        (series, of): (&Bench<B>, impl Fn(&B) -> f64),
        (values, error): (&Bench<V>, impl Fn(&V) -> f64),
        radius: f64,
    ) -> bool {
        let coefficients = |slot: usize| series.slots.value(slot).coefficients().iter().map(&of);
        let error = |slot: usize| error(&values.slots.value(slot).coefficient(0));
        let how = |slot: usize| {
            let known = series.slots.missing(slot).is_none() && values.slots.missing(slot).is_none();
            known.then(|| moves(coefficients(slot), radius, error(slot)))
        };
        self.arguments
            .are_moderate(how, |slot| changes_sign(&coefficients(slot).collect::<Vec<f64>>(), radius, error(slot)))
    }

    /// Whether there are operations with a branch point.
    pub(super) fn has_branches(&self) -> bool {
        !self.branches.is_empty()
    }

    /// Whether an operation may have been evaluated at its branch point at one of several times.
    pub(super) fn may_be_at_branch_point<const N: usize>(&self, bench: &Bench<BoundedLanes<N>>) -> bool {
        bench.degree > 0
            && self.branches.iter().any(|&(term, slot)| {
                let argument = bench.slots.value(slot).coefficient(0);
                bench.slots.missing(slot).is_none() && (0..N).any(|i| term.vanishes(argument.lane(i)))
            })
    }

    /// For each output, whether it has no value at any time, since a constant that it depends on has none.
    pub(super) fn never_valued(&self, core: &Core) -> Vec<bool> {
        let constant = |input: &Input| matches!(input, Input::Constant(i) if core.constants[*i].value.is_err());
        self.tape.depends(&self.inputs.iter().map(constant).collect::<Vec<bool>>())
    }

    /// For each output, whether it depends on constants alone.
    pub(super) fn still(&self) -> Vec<bool> {
        let moves = |input: &Input| matches!(input, Input::Time | Input::State(_) | Input::Turns(_));
        self.tape
            .depends(&self.inputs.iter().map(moves).collect::<Vec<bool>>())
            .into_iter()
            .map(|moves| !moves)
            .collect()
    }

    /// An output after [`Program::run`].
    pub(super) fn output<'b, B: Base>(&self, bench: &'b Bench<B>, output: usize) -> Result<&'b Jet<B>, NoValue> {
        self.tape.output(output, &bench.slots)
    }

    pub(super) fn dual_bench(&self, core: &Core) -> DualBench {
        let mut slots = self.tape.slots::<Dual<f64>>(&());
        for (at, input) in self.inputs.iter().enumerate() {
            if let Input::Constant(i) = input {
                slots.set(at, core.constants[*i].value.map(|c| Dual::new(c.value, 0.0)));
            }
        }
        let orbit = core.orbit.as_deref().filter(|_| self.moving);
        let field = orbit.map(|o| {
            let constants: Vec<f64> = o.constants.iter().map(|c| c.value).collect();
            o.field.flow.slots(1, &constants)
        });
        let n = orbit.map_or(0, |o| o.field.states.len());
        DualBench { field, slots, state: vec![0.0; n], coefficients: vec![0.0; 2 * n] }
    }

    /// All outputs at the dual time t + ε: the tangent of a state is its rate.
    pub(super) fn run_dual(
        &self,
        core: &Core,
        bench: &mut DualBench,
        t: f64,
        of: &Turns,
    ) -> Vec<Result<Dual<f64>, NoValue>> {
        let mut missing = None;
        if let Some(orbit) = core.orbit.as_deref().filter(|_| self.moving) {
            let place = orbit.trajectory.place(t);
            for (i, x) in bench.state.iter_mut().enumerate() {
                *x = orbit.trajectory.value(place, i);
            }
            let (from, to) = orbit.trajectory.reach();
            if !(from <= t && t <= to) {
                missing = Some(NoValue::Indeterminate);
            } else if let Some(field) = &mut bench.field {
                let grown = orbit.field.flow.expand(field, 1, t, &bench.state, &mut bench.coefficients);
                missing = grown.err().map(|(_, reason)| reason);
            }
        }
        for (at, input) in self.inputs.iter().enumerate() {
            let value = match *input {
                Input::Constant(_) | Input::Unused => continue,
                Input::Time => Ok(Dual::new(t, 1.0)),
                Input::State(i) => match missing {
                    Some(reason) => Err(reason),
                    None => Ok(Dual::new(bench.coefficients[2 * i], bench.coefficients[2 * i + 1])),
                },
                Input::Turns(i) => turns_of(of, i).map(|x| Dual::new(x.value, 0.0)),
            };
            bench.slots.set(at, value);
        }
        self.tape.run(&(), &mut bench.slots);
        (0..self.tape.output_count()).map(|i| self.tape.output(i, &bench.slots).cloned()).collect()
    }
}
