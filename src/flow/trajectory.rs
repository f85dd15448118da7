//! A trajectory: the Taylor polynomials of all steps, and how far they may be from the truth.
//!
//! **Error estimate.** The motion is integrated again, with another order and another sequence of steps; and where initial
//! values or constants are only known within a bound, twice more from opposite ends of it. It starts a little beside, as rounding on
//! the first step may put it. At every step end of these
//! companions the difference is compared; the largest so far, times a safety factor, plus a floor for rounding, is the
//! error. The companions go side by side with the motion (see the module `abreast`). It is an estimate, no enclosure: it
//! sees truncation, rounding and the growth of both, because rounding takes another course in every companion. Who asks for
//! it ([`Estimation::Steps`]) has another one, wider and for less work: differences that are carried along the steps that were
//! made, see the module `estimate`. Values are the same.

pub(super) use place::Place;

use super::abreast::{self, Event, Halt, Runner};
use super::error::Problem;
use super::estimate::{Estimate, Estimation};
use super::taylor::{Control, Flow, Moved, Step, Stop, Walker};
use number::{Bounded, NoValue, widely};

/// What the differences between independent integrations are multiplied with.
const SAFETY: f64 = 8.0;
/// How far beside the start of a motion its companion starts, in units of the states.
const SLIP: f64 = f64::EPSILON;
/// Rounding floor in units of the largest value of a state so far.
const FLOOR: f64 = 4.0 * f64::EPSILON;
/// Order of the trajectory: −ln(2⁻⁵²)/2 + 1, rounded up.
pub(super) const ORDER: usize = 20;

/// For so many steps there is room at first.
const FEW_STEPS: usize = 64;

/// Polynomials and errors from the initial time in one direction.
#[derive(Clone, Debug, Default)]
pub(super) struct Branch {
    /// Step boundaries, from the initial time on; one more than steps.
    pub(super) times: Vec<f64>,
    /// For every step the coefficients of all states, order by order.
    pub(super) coefficients: Vec<f64>,
    /// What the zeroth coefficients leave out, for every state of every step.
    pub(super) low: Vec<f64>,
    /// While it is not known how far it may be off: how far the slopes are from the rates at the end of every step.
    pub(super) defects: Vec<f64>,
    /// Error of every state up to the end of every step; never decreasing.
    error: Vec<f64>,
    /// Whether its errors are from its own steps.
    by_steps: bool,
    problem: Option<Problem>,
}

/// The motion through given initial values, forward and backward, as piecewise polynomials of order 20.
#[derive(Clone, Debug)]
pub(super) struct Trajectory {
    dimension: usize,
    initial_time: f64,
    initial_error: Vec<f64>,
    forward: Branch,
    backward: Branch,
}

/// What a trajectory is made from.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    /// The constants of the field.
    pub(super) constants: Vec<Bounded>,
    /// Where the state is given.
    pub(super) initial_time: f64,
    /// The state there.
    pub(super) state: Vec<Bounded>,
    /// Between which times.
    pub(super) span: (f64, f64),
    /// Most steps in each direction.
    pub(super) max_steps: usize,
}

/// A branch that was integrated, with the companions beside it; or why there is none.
type Found<'a> = Result<(Branch, Vec<Ends<'a>>), (usize, NoValue)>;

/// Whether a branch has steps.
fn moves(found: &Found) -> bool {
    found.as_ref().is_ok_and(|(whole, _)| whole.times.len() > 1)
}

/// The numbers without their bounds.
fn values(of: &[Bounded]) -> Vec<f64> {
    of.iter().map(|x| x.value).collect()
}

impl Trajectory {
    /// Integrates several motions of one field; each is what it is alone, bit for bit. `None` if it was stopped.
    ///
    /// # Errors
    /// For each of them: the state whose rate has no value at the initial time. Later obstacles end the trajectory and are kept
    /// with it.
    pub(super) fn integrate(
        flow: &Flow,
        plans: &[Plan],
        estimation: Estimation,
        halt: Halt,
    ) -> Option<Vec<Result<Trajectory, (usize, NoValue)>>> {
        Trajectory::by(|flow, runs| abreast::run(flow, runs, halt), flow, plans, estimation)
    }

    /// The same, where `run` lets integrations run.
    fn by(
        run: impl for<'a> Fn(&'a Flow, &mut [Run<'a>]) -> bool,
        flow: &Flow,
        plans: &[Plan],
        estimation: Estimation,
    ) -> Option<Vec<Result<Trajectory, (usize, NoValue)>>> {
        let ends = |plan: &Plan| [plan.span.1, plan.span.0];
        let mut estimate = match estimation {
            Estimation::Companions => None,
            Estimation::Steps => Estimate::new(flow),
        };
        let mut runs: Vec<Run> = Vec::new();
        for (plan, end) in plans.iter().flat_map(|plan| ends(plan).map(|end| (plan, end))) {
            if end == plan.initial_time {
                continue;
            }
            runs.push(Run::Whole(Whole::new(flow, plan, end)));
            if estimate.is_none() {
                runs.extend(Check::of(plan).iter().map(|check| Run::Ends(Ends::new(flow, plan, *check, end))));
            }
        }
        if !run(flow, &mut runs) {
            return None;
        }
        let mut runs = runs.into_iter().peekable();
        let mut branches: Vec<Found> = Vec::new();
        for (plan, end) in plans.iter().flat_map(|plan| ends(plan).map(|end| (plan, end))) {
            // What has nowhere to go is where it starts.
            let whole = match runs.next_if(|_| end != plan.initial_time) {
                Some(Run::Whole(whole)) => whole.finish(estimation),
                Some(Run::Ends(_)) | None => Ok(Branch { times: vec![plan.initial_time], ..Branch::default() }),
            };
            let mut companions = Vec::new();
            while let Some(Run::Ends(ends)) = runs.next_if(|run| matches!(run, Run::Ends(_))) {
                companions.push(ends);
            }
            branches.push(whole.map(|whole| (whole, companions)));
        }
        // The plan of every branch: that to the end comes first.
        let of = |n: usize| &plans[n / 2];
        if let Some(estimate) = &mut estimate {
            let moved: Vec<usize> = (0..branches.len()).filter(|&n| moves(&branches[n])).collect();
            let taken: Vec<(&Plan, &Branch)> =
                moved.iter().filter_map(|&n| branches[n].as_ref().ok().map(|(whole, _)| (of(n), whole))).collect();
            for (n, errors) in moved.iter().zip(estimate.of(&taken)) {
                let Ok((whole, companions)) = &mut branches[*n] else { continue };
                match errors {
                    Some(errors) => {
                        whole.raise(flow.dimension, &errors);
                        whole.by_steps = true;
                    }
                    None => {
                        let (plan, end) = (of(*n), whole.times.last().copied().unwrap_or(of(*n).initial_time));
                        let again = Check::of(plan).iter().map(|check| Run::Ends(Ends::new(flow, plan, *check, end)));
                        let mut again: Vec<Run> = again.collect();
                        if !run(flow, &mut again) {
                            return None;
                        }
                        companions.extend(again.into_iter().filter_map(|run| match run {
                            Run::Ends(ends) => Some(ends),
                            Run::Whole(_) => None,
                        }));
                    }
                }
            }
        }
        let checked = |(n, found): (usize, Found)| match found {
            Ok((whole, _)) if whole.by_steps => Some(Ok(whole)),
            Ok((whole, companions)) => whole.checked(&run, flow, of(n), companions).map(Ok),
            Err(singular) => Some(Err(singular)),
        };
        let mut branches = branches.into_iter().enumerate().map(checked);
        let mut trajectory = |plan: &Plan| {
            let (forward, backward) = (branches.next()??, branches.next()??);
            let initial_error = plan.state.iter().map(|x| x.error).collect();
            let (dimension, initial_time) = (flow.dimension, plan.initial_time);
            let whole = |forward, backward| Trajectory { dimension, initial_time, initial_error, forward, backward };
            Some(forward.and_then(|forward| Ok(whole(forward, backward?))))
        };
        plans.iter().map(&mut trajectory).collect()
    }

    /// One more integration over the forward part, without companions: number of steps.
    pub(super) fn again(&self, flow: &Flow, constants: &[Bounded]) -> usize {
        let place = self.place(self.initial_time);
        let (initial_time, span) = (self.initial_time, (self.initial_time, self.reach().1));
        let state: Vec<Bounded> = (0..self.dimension).map(|i| self.bounded(place, i)).collect();
        let plan = Plan { constants: constants.to_vec(), initial_time, state, span, max_steps: usize::MAX };
        let mut run = [Whole::new(flow, &plan, span.1)];
        abreast::run(flow, &mut run, &|| false);
        run[0].branch.times.len() - 1
    }

    /// Whether errors are from the steps of the motion, and may be less with companions.
    pub(super) fn is_by_steps(&self) -> bool {
        self.forward.by_steps || self.backward.by_steps
    }

    /// The times between which the motion is known.
    pub(super) fn reach(&self) -> (f64, f64) {
        let last = |b: &Branch| b.times.last().copied().unwrap_or(self.initial_time);
        (last(&self.backward), last(&self.forward))
    }

    /// Why the trajectory does not reach the ends of its span.
    pub(super) fn problem(&self) -> Option<&Problem> {
        self.forward.problem.as_ref().or(self.backward.problem.as_ref())
    }

    /// Step boundaries in ascending order.
    pub(super) fn boundaries(&self) -> Vec<f64> {
        let mut times: Vec<f64> = self.backward.times.iter().rev().copied().collect();
        times.extend(self.forward.times.iter().filter(|t| times.last() != Some(t)).copied().collect::<Vec<_>>());
        if times.is_empty() {
            times.push(self.initial_time);
        }
        times
    }

    fn branch(&self, backward: bool) -> &Branch {
        if backward { &self.backward } else { &self.forward }
    }

    /// The largest error of every state over the whole trajectory.
    pub(super) fn largest_errors(&self) -> Vec<f64> {
        let last = |b: &Branch, i: usize| {
            let from = b.error.len().saturating_sub(self.dimension);
            b.error.get(from + i).copied().unwrap_or(0.0)
        };
        (0..self.dimension)
            .map(|i| last(&self.forward, i).max(last(&self.backward, i)).max(self.initial_error[i]))
            .collect()
    }
}

fn problem(flow: &Flow, stop: Stop, time: f64) -> Problem {
    match stop {
        Stop::Collapsed => Problem::StepCollapsed { time },
        Stop::Undetermined => Problem::Undetermined { time },
        Stop::NoRate(i, reason) => Problem::NoRate { state: flow.names[i].clone(), time, reason },
    }
}

/// An integration that is kept.
struct Whole<'a> {
    walker: Walker<'a>,
    flow: &'a Flow,
    started: bool,
    branch: Branch,
    /// Largest value of every state so far, for the rounding floor.
    largest: Vec<f64>,
    initial_error: Vec<f64>,
    max_steps: usize,
    /// A rate without a value at the initial time.
    singular: Option<(usize, NoValue)>,
}

impl<'a> Whole<'a> {
    fn new(flow: &'a Flow, plan: &Plan, end: f64) -> Whole<'a> {
        let initial = values(&plan.state);
        let control = Control { order: ORDER, caution: 1.0 };
        Whole {
            walker: Walker::new(flow, control, &values(&plan.constants), (plan.initial_time, end), &initial),
            flow,
            started: false,
            branch: Branch { times: vec![plan.initial_time], ..Branch::default() },
            largest: initial.iter().map(|x| x.abs()).collect(),
            initial_error: plan.state.iter().map(|x| x.error).collect(),
            max_steps: plan.max_steps,
            singular: None,
        }
    }

    /// What was found: errors are the rounding floor.
    fn finish(self, estimation: Estimation) -> Result<Branch, (usize, NoValue)> {
        let mut out = self.branch;
        // How many steps there would be was not known. Of many motions none is kept.
        let kept = estimation == Estimation::Companions;
        for column in [&mut out.coefficients, &mut out.low, &mut out.times, &mut out.error].into_iter().filter(|_| kept)
        {
            column.shrink_to_fit();
        }
        self.singular.map_or(Ok(out), Err)
    }
}

impl<'a> Runner<'a> for Whole<'a> {
    fn walker(&mut self) -> &mut Walker<'a> {
        &mut self.walker
    }

    fn note(&mut self, event: Event) -> bool {
        let (walker, out) = (&self.walker, &mut self.branch);
        match event {
            Event::Started => {
                self.started = true;
                let (steps, n) = (FEW_STEPS.min(self.max_steps), self.flow.dimension);
                out.coefficients.reserve(steps * n * (ORDER + 1));
                for column in [&mut out.low, &mut out.defects, &mut out.error] {
                    column.reserve(steps * n);
                }
            }
            Event::Stepped => {
                let Step { coefficients, low, defects } = walker.made();
                out.coefficients.extend_from_slice(coefficients);
                out.low.extend_from_slice(low);
                out.defects.extend_from_slice(defects);
                out.times.push(walker.time);
                let of_start = self.initial_error.iter().zip(&walker.late);
                let states = self.largest.iter_mut().zip(&walker.state).zip(of_start);
                out.error.extend(states.map(|((largest, x), (initial, late))| {
                    *largest = largest.max(x.abs());
                    FLOOR * *largest + 2.0 * initial + SAFETY * late
                }));
            }
            Event::Stopped(Stop::NoRate(i, reason)) if !self.started => {
                self.singular = Some((i, reason));
                return false;
            }
            Event::Stopped(stop) => {
                out.problem = Some(problem(self.flow, stop, walker.time));
                return false;
            }
        }
        if !walker.finished() && out.times.len() > self.max_steps {
            out.problem = Some(Problem::TooManySteps { time: walker.time, steps: self.max_steps });
            return false;
        }
        !walker.finished()
    }
}

/// How a companion differs from the motion whose error it is to show.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Check {
    /// Two orders less, but steps that make the truncation about as small.
    Method,
    /// One corner of the box of what is known.
    Corner,
    /// Another one; its signs alternate in a sequence without a short period.
    Alternating,
}

impl Check {
    /// The companions of a motion.
    fn of(plan: &Plan) -> &'static [Check] {
        match plan.constants.iter().chain(&plan.state).any(|x| x.error > 0.0) {
            true => &[Check::Method, Check::Corner, Check::Alternating],
            false => &[Check::Method],
        }
    }

    /// Order and caution.
    fn control(self) -> Control {
        match self {
            Check::Method => Control { order: ORDER - 2, caution: 0.8 },
            Check::Corner => Control { order: ORDER, caution: 0.97 },
            Check::Alternating => Control { order: ORDER, caution: 0.91 },
        }
    }

    /// The numbers with which it is integrated.
    fn shifted(self, of: &[Bounded]) -> Vec<f64> {
        match self {
            Check::Method => values(of),
            Check::Corner | Check::Alternating => {
                of.iter().enumerate().map(|(i, x)| x.value + self.sign(i) * x.error).collect()
            }
        }
    }

    /// In which direction a number is shifted.
    fn sign(self, i: usize) -> f64 {
        match self {
            Check::Method => 0.0,
            Check::Corner => 1.0,
            Check::Alternating if (i * i + i / 2).is_multiple_of(3) => 1.0,
            Check::Alternating => -1.0,
        }
    }
}

/// A start beside that of a motion, as far away as rounding on the first step may put it, if its rates have values there.
///
/// All series at the start are the same, and so is what is rounded in them: a motion and its companion from the very same start may
/// leave an unstable solution side by side. A state that stays 0 is exact, and stays 0.
fn beside(flow: &Flow, constants: &[f64], (from, to): (f64, f64), state: Vec<f64>) -> Vec<f64> {
    let mut slots = flow.slots(2, constants);
    let mut series = vec![0.0; 3 * state.len()];
    if flow.expand(&mut slots, 2, from, &state, &mut series).is_err() {
        return state;
    }
    let rows = || series.as_chunks::<3>().0.iter();
    // How long states take to become others, as far as two coefficients tell.
    let times = rows().filter(|c| c[0] != 0.0 && c[1] != 0.0).map(|c| (c[0] / c[1]).abs());
    let time = times.fold((to - from).abs() / 64.0, f64::min);
    let moved = |sign: f64| -> Vec<f64> {
        let size = |c: &[f64]| if c[0] == 0.0 { (c[1].abs() * time).max(c[2].abs() * time * time) } else { c[0].abs() };
        let by = |i: usize, c: &[f64]| sign * Check::Alternating.sign(i) * SLIP * size(c);
        rows().enumerate().map(|(i, c)| c[0] + by(i, c)).collect()
    };
    let mut known = |at: &Vec<f64>| flow.expand(&mut slots, 1, from, at, &mut vec![0.0; 2 * at.len()]).is_ok();
    [1.0, -1.0].map(moved).into_iter().find(|at| known(at)).unwrap_or(state)
}

/// An integration of which the states at the ends of steps are kept.
struct Ends<'a> {
    walker: Walker<'a>,
    check: Check,
    times: Vec<f64>,
    /// All states at each of these times.
    states: Vec<f64>,
    max_steps: usize,
    /// Where it ends before its end.
    broken: Option<f64>,
}

impl<'a> Ends<'a> {
    fn new(flow: &'a Flow, plan: &Plan, check: Check, end: f64) -> Ends<'a> {
        let (constants, mut state) = (check.shifted(&plan.constants), check.shifted(&plan.state));
        if check == Check::Method {
            state = beside(flow, &constants, (plan.initial_time, end), state);
        }
        Ends {
            walker: Walker::new(flow, check.control(), &constants, (plan.initial_time, end), &state),
            check,
            times: Vec::new(),
            states: Vec::new(),
            max_steps: plan.max_steps.saturating_mul(4),
            broken: None,
        }
    }
}

impl<'a> Runner<'a> for Ends<'a> {
    fn walker(&mut self) -> &mut Walker<'a> {
        &mut self.walker
    }

    fn note(&mut self, event: Event) -> bool {
        let walker = &self.walker;
        match event {
            Event::Started => {}
            Event::Stepped => {
                self.times.push(walker.time);
                self.states.extend_from_slice(&walker.state);
            }
            Event::Stopped(_) => {
                self.broken = Some(walker.time);
                return false;
            }
        }
        if !walker.finished() && self.times.len() >= self.max_steps {
            self.broken = Some(walker.time);
            return false;
        }
        !walker.finished()
    }
}

/// An integration of one kind or the other.
enum Run<'a> {
    Whole(Whole<'a>),
    Ends(Ends<'a>),
}

impl<'a> Runner<'a> for Run<'a> {
    fn walker(&mut self) -> &mut Walker<'a> {
        match self {
            Run::Whole(of) => of.walker(),
            Run::Ends(of) => of.walker(),
        }
    }

    fn note(&mut self, event: Event) -> bool {
        match self {
            Run::Whole(of) => of.note(event),
            Run::Ends(of) => of.note(event),
        }
    }
}

impl Branch {
    /// The coefficients of all states on a step, order by order.
    pub(super) fn series(&self, n: usize, step: usize) -> &[f64] {
        &self.coefficients[step * n * (ORDER + 1)..(step + 1) * n * (ORDER + 1)]
    }

    /// The polynomial of a state on a step: its coefficients, one in `n`, and what the zeroth leaves out. Nothing where there is no
    /// such step.
    fn polynomial(&self, n: usize, step: usize, state: usize) -> (&[f64], f64) {
        let row = n * (ORDER + 1);
        let all = self.coefficients.get(step * row..(step + 1) * row).and_then(|all| all.get(state..));
        match (all, self.low.get(step * n + state)) {
            (Some(all), Some(&low)) => (all, low),
            (Some(_) | None, _) => (&[], f64::NAN),
        }
    }

    /// With its errors, from companions that were integrated beside it; `None` if `run` was stopped.
    fn checked(
        mut self,
        run: &impl for<'a> Fn(&'a Flow, &mut [Run<'a>]) -> bool,
        flow: &Flow,
        plan: &Plan,
        companions: Vec<Ends>,
    ) -> Option<Branch> {
        if self.times.len() < 2 {
            return Some(self);
        }
        for companion in companions {
            let end = self.times.last().copied().unwrap_or(plan.initial_time);
            if companion.walker.end == end {
                self.compare(&companion);
                continue;
            }
            // The motion ends before its span: so shall its companion, which chooses its steps by the end.
            let mut again = [Run::Ends(Ends::new(flow, plan, companion.check, end))];
            if end != plan.initial_time && !run(flow, &mut again) {
                return None;
            }
            if let [Run::Ends(again)] = &again {
                self.compare(again);
            }
        }
        self.settle(flow.dimension);
        Some(self)
    }

    /// Raises the errors to what was found, and makes them monotone.
    fn raise(&mut self, n: usize, errors: &[f64]) {
        self.error.iter_mut().zip(errors).for_each(|(error, found)| *error += found);
        self.settle(n);
    }

    /// Raises the errors where a companion differs; ends the branch where the companion ends.
    fn compare(&mut self, companion: &Ends) {
        let n = companion.walker.state.len();
        let (Some(&start), Some(&end)) = (self.times.first(), self.times.last()) else { return };
        let forward = end > start;
        let (mut here, row, mut sums) = (0, n * (ORDER + 1), vec![0.0; n]);
        for (&time, state) in companion.times.iter().zip(companion.states.chunks(n.max(1))) {
            // What is found at the end of the companion's step counts from the step in which it began.
            let first = here;
            let after = |t: f64| if forward { t < time } else { t > time };
            while here + 2 < self.times.len() && after(self.times[here + 1]) {
                here += 1;
            }
            let since = time - self.times[here];
            let orders = &self.coefficients[here * row..(here + 1) * row];
            widely(Moved { orders, h: since, sums: &mut sums });
            for (i, &x) in state.iter().enumerate() {
                let (value, low) = (self.coefficients[here * row + i], self.low[here * n + i]);
                let difference = ((value - x) + (low + since * sums[i])).abs() * SAFETY;
                for step in first..=here {
                    let error = &mut self.error[step * n + i];
                    *error = error.max(difference + FLOOR * x.abs());
                }
            }
        }
        if let Some(time) = companion.broken {
            self.cut(n, time);
        }
    }

    /// Forgets everything after `time`, beyond which the error is not known.
    fn cut(&mut self, n: usize, time: f64) {
        let forward = self.times.last() > self.times.first();
        let keep = self.times.iter().take_while(|&&t| if forward { t <= time } else { t >= time }).count().max(1);
        self.times.truncate(keep);
        let steps = keep - 1;
        self.coefficients.truncate(steps * n * (ORDER + 1));
        self.low.truncate(steps * n);
        self.error.truncate(steps * n);
        let reached = self.times.last().copied().unwrap_or(time);
        self.problem = Some(match self.problem.take() {
            Some(Problem::StepCollapsed { .. }) => Problem::StepCollapsed { time: reached },
            Some(Problem::NoRate { state, reason, .. }) => Problem::NoRate { state, time: reached, reason },
            Some(Problem::TooManySteps { steps, .. }) => Problem::TooManySteps { time: reached, steps },
            Some(Problem::Undetermined { .. }) => Problem::Undetermined { time: reached },
            Some(Problem::ErrorUnknown { .. }) | None => Problem::ErrorUnknown { time: reached },
        });
    }

    /// Makes the errors monotone.
    fn settle(&mut self, n: usize) {
        self.defects = Vec::new();
        for i in n..self.error.len() {
            self.error[i] = self.error[i].max(self.error[i - n]);
        }
    }
}

mod place;
#[cfg(test)]
mod tests;
