//! A trajectory: the Taylor polynomials of all steps, and how far they may be from the truth.
//!
//! **Error estimate.** The motion is integrated again, with another order and another sequence of steps; and where initial
//! values or constants are only known within a bound, twice more from opposite ends of it. At every step end of these
//! companions the difference is compared; the largest so far, times a safety factor, plus a floor for rounding, is the
//! error. It is an estimate, not an enclosure: it sees truncation, rounding and the growth of both, because rounding takes
//! another course in every companion.

use super::error::Problem;
use super::taylor::{Control, Flow, Stop, Walker, horner};
use number::{Bounded, NoValue};

/// What the differences between independent integrations are multiplied with.
const SAFETY: f64 = 8.0;
/// Rounding floor in units of the largest value of a state so far.
const FLOOR: f64 = 4.0 * f64::EPSILON;
/// Order of the trajectory: −ln(2⁻⁵²)/2 + 1, rounded up.
pub(super) const ORDER: usize = 20;

/// Polynomials and errors from the initial time in one direction.
#[derive(Clone, Debug, Default)]
struct Branch {
    /// Step boundaries, from the initial time on; one more than steps.
    times: Vec<f64>,
    /// `ORDER + 1` coefficients for every state of every step.
    coefficients: Vec<f64>,
    /// What the zeroth coefficients leave out, for every state of every step.
    low: Vec<f64>,
    /// Error of every state up to the end of every step; never decreasing.
    error: Vec<f64>,
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

/// A place on a trajectory: a step and the time since its start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    backward: bool,
    step: usize,
    since: f64,
}

impl Trajectory {
    /// Integrates from (`initial_time`, `state`) over `span`.
    ///
    /// # Errors
    /// The state whose rate has no value at the initial time. Later obstacles end the trajectory and are kept with it.
    pub(super) fn integrate(
        flow: &Flow,
        constants: &[Bounded],
        initial_time: f64,
        state: &[Bounded],
        span: (f64, f64),
        max_steps: usize,
    ) -> Result<Trajectory, (usize, NoValue)> {
        let branch = |end: f64| branch(flow, constants, (initial_time, end), state, max_steps);
        Ok(Trajectory {
            dimension: flow.dimension,
            initial_time,
            initial_error: state.iter().map(|x| x.error).collect(),
            forward: branch(span.1)?,
            backward: branch(span.0)?,
        })
    }

    /// One more integration over the forward part, without companions: number of steps.
    pub(super) fn again(&self, flow: &Flow, constants: &[Bounded]) -> usize {
        let place = self.place(self.initial_time);
        let state: Vec<Bounded> = (0..self.dimension).map(|i| self.bounded(place, i)).collect();
        let numbers: Vec<f64> = constants.iter().map(|c| c.value).collect();
        let control = Control { order: ORDER, caution: 1.0, max_steps: usize::MAX };
        let span = (self.initial_time, self.reach().1);
        Branch::integrate(flow, control, &numbers, span, &state).map_or(0, |b| b.times.len() - 1)
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

    /// The step that contains a time; the nearest one for a time outside.
    pub(super) fn place(&self, t: f64) -> Place {
        let backward = t < self.initial_time && self.backward.times.len() > 1 || self.forward.times.len() < 2;
        let branch = self.branch(backward);
        let before =
            if backward { branch.times.partition_point(|&s| s > t) } else { branch.times.partition_point(|&s| s <= t) };
        let step = before.saturating_sub(1).min(branch.times.len().saturating_sub(2));
        Place { backward, step, since: t - branch.times.get(step).copied().unwrap_or(t) }
    }

    fn branch(&self, backward: bool) -> &Branch {
        if backward { &self.backward } else { &self.forward }
    }

    /// The value of a state.
    pub(super) fn value(&self, place: Place, state: usize) -> f64 {
        let branch = self.branch(place.backward);
        let at = place.step * self.dimension + state;
        match branch.coefficients.get(at * (ORDER + 1)..(at + 1) * (ORDER + 1)) {
            Some(c) => c[0] + (branch.low[at] + place.since * horner(&c[1..], place.since)),
            None => f64::NAN,
        }
    }

    /// The values of a state at several times at once: the same operations, time by time, none of which waits for those of
    /// another time.
    pub(super) fn values<const N: usize>(&self, places: &[Place; N], state: usize) -> [f64; N] {
        let mut steps = [(&[0.0; ORDER + 1], 0.0); N];
        for (step, place) in steps.iter_mut().zip(places) {
            let branch = self.branch(place.backward);
            let at = place.step * self.dimension + state;
            // Of a known length, so that the loop below need not look at it.
            match branch.coefficients.get(at * (ORDER + 1)..).and_then(<[f64]>::first_chunk) {
                Some(c) => *step = (c, branch.low[at]),
                None => return places.map(|place| self.value(place, state)),
            }
        }
        let since = places.map(|place| place.since);
        let mut sums = [0.0; N];
        for k in (1..=ORDER).rev() {
            for i in 0..N {
                sums[i] = sums[i] * since[i] + steps[i].0[k];
            }
        }
        std::array::from_fn(|i| steps[i].0[0] + (steps[i].1 + since[i] * sums[i]))
    }

    /// The polynomial of a state around another time of its step: the first coefficients.
    ///
    /// This is the polynomial of the step, written anew; a series that is grown at that time is the same up to the error of
    /// the trajectory, and takes ten times as long.
    pub(super) fn around(&self, place: Place, state: usize, out: &mut [f64]) {
        let branch = self.branch(place.backward);
        let at = place.step * self.dimension + state;
        let mut c = [f64::NAN; ORDER + 1];
        if let Some(stored) = branch.coefficients.get(at * (ORDER + 1)..(at + 1) * (ORDER + 1)) {
            c.copy_from_slice(stored);
            for lowest in 0..ORDER.min(out.len()) {
                for k in (lowest..ORDER).rev() {
                    c[k] += place.since * c[k + 1];
                }
            }
            c[0] = self.value(place, state);
        }
        for (to, from) in out.iter_mut().zip(c) {
            *to = from;
        }
    }

    /// The same around several times at once: the same operations, time by time.
    pub(super) fn around_lanes<const N: usize>(&self, places: &[Place; N], state: usize, out: &mut [[f64; N]]) {
        let mut c = [[f64::NAN; N]; ORDER + 1];
        for (i, place) in places.iter().enumerate() {
            let branch = self.branch(place.backward);
            let at = place.step * self.dimension + state;
            let stored = branch.coefficients.get(at * (ORDER + 1)..(at + 1) * (ORDER + 1)).unwrap_or_default();
            c.iter_mut().zip(stored).for_each(|(c, &x)| c[i] = x);
        }
        let since = places.map(|place| place.since);
        for lowest in 0..ORDER.min(out.len()) {
            for k in (lowest..ORDER).rev() {
                for i in 0..N {
                    c[k][i] += since[i] * c[k + 1][i];
                }
            }
        }
        c[0] = self.values(places, state);
        for (to, from) in out.iter_mut().zip(c) {
            *to = from;
        }
    }

    /// The value of a state with its error.
    pub(super) fn bounded(&self, place: Place, state: usize) -> Bounded {
        Bounded { value: self.value(place, state), error: self.error(place, state) }
    }

    /// The same at several times at once.
    pub(super) fn bounded_values<const N: usize>(&self, places: &[Place; N], state: usize) -> [Bounded; N] {
        let values = self.values(places, state);
        std::array::from_fn(|i| Bounded { value: values[i], error: self.error(places[i], state) })
    }

    fn error(&self, place: Place, state: usize) -> f64 {
        if place.since == 0.0 && place.step == 0 {
            self.initial_error[state]
        } else {
            let errors = &self.branch(place.backward).error;
            errors.get(place.step * self.dimension + state).copied().unwrap_or(f64::INFINITY)
        }
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

fn branch(
    flow: &Flow,
    constants: &[Bounded],
    (start, end): (f64, f64),
    state: &[Bounded],
    max_steps: usize,
) -> Result<Branch, (usize, NoValue)> {
    let n = flow.dimension;
    let values = |of: &[Bounded]| of.iter().map(|x| x.value).collect::<Vec<f64>>();
    let (numbers, initial) = (values(constants), values(state));
    let control = Control { order: ORDER, caution: 1.0, max_steps };
    let mut out = Branch::integrate(flow, control, &numbers, (start, end), state)?;
    if out.times.len() > 1 {
        // Two orders less, but steps that make the truncation about as small.
        out.compare(flow, control, &numbers, &initial, 2, 0.8);
        if constants.iter().chain(state).any(|x| x.error > 0.0) {
            let shifted = |of: &[Bounded], sign: &dyn Fn(usize) -> f64| {
                of.iter().enumerate().map(|(i, x)| x.value + sign(i) * x.error).collect::<Vec<f64>>()
            };
            // Two corners of the box of what is known; the second alternates in a sequence without a short period.
            let corner = |i: usize| if (i * i + i / 2).is_multiple_of(3) { 1.0 } else { -1.0 };
            for (sign, caution) in [(&(|_| 1.0) as &dyn Fn(usize) -> f64, 0.97), (&corner, 0.91)] {
                out.compare(flow, control, &shifted(constants, sign), &shifted(state, sign), 0, caution);
            }
        }
        out.settle(n);
    }
    Ok(out)
}

impl Branch {
    /// The integration itself; errors are the rounding floor.
    fn integrate(
        flow: &Flow,
        control: Control,
        constants: &[f64],
        (start, end): (f64, f64),
        state: &[Bounded],
    ) -> Result<Branch, (usize, NoValue)> {
        let mut out = Branch { times: vec![start], ..Branch::default() };
        let initial: Vec<f64> = state.iter().map(|x| x.value).collect();
        let mut walker = match Walker::new(flow, control, constants, (start, end), &initial) {
            Ok(walker) => walker,
            Err(Stop::NoRate(i, reason)) => return Err((i, reason)),
            Err(stop @ (Stop::Collapsed | Stop::Undetermined)) => {
                out.problem = Some(problem(flow, stop, start));
                return Ok(out);
            }
        };
        // Largest value so far, for the rounding floor.
        let mut largest: Vec<f64> = initial.iter().map(|x| x.abs()).collect();
        while !walker.finished() {
            if out.times.len() > control.max_steps {
                out.problem = Some(Problem::TooManySteps { time: walker.time, steps: control.max_steps });
                break;
            }
            match walker.step() {
                Ok(step) => {
                    out.coefficients.extend_from_slice(step.coefficients);
                    out.low.extend_from_slice(step.low);
                }
                Err(stop) => {
                    out.problem = Some(problem(flow, stop, walker.time));
                    break;
                }
            }
            out.times.push(walker.time);
            for (((l, x), b), late) in largest.iter_mut().zip(&walker.state).zip(state).zip(&walker.late) {
                *l = l.max(x.abs());
                out.error.push(FLOOR * *l + 2.0 * b.error + SAFETY * late);
            }
        }
        // How many steps there would be was not known.
        for column in [&mut out.coefficients, &mut out.low, &mut out.times, &mut out.error] {
            column.shrink_to_fit();
        }
        Ok(out)
    }

    /// Integrates once more and raises the errors where the two differ; ends the branch where the other ends.
    fn compare(
        &mut self,
        flow: &Flow,
        control: Control,
        constants: &[f64],
        initial: &[f64],
        less: usize,
        caution: f64,
    ) {
        let n = flow.dimension;
        let (Some(&start), Some(&end)) = (self.times.first(), self.times.last()) else { return };
        let forward = end > start;
        let control = Control { order: control.order - less, caution, max_steps: 4 * control.max_steps };
        let Ok(mut walker) = Walker::new(flow, control, constants, (start, end), initial) else {
            self.cut(n, start);
            return;
        };
        let (mut here, mut steps) = (0, 0);
        while !walker.finished() {
            // What is found at the end of the companion's step counts from the step in which it began.
            let first = here;
            steps += 1;
            if steps > control.max_steps || walker.step().is_err() {
                let time = walker.time;
                self.cut(n, time);
                return;
            }
            let after = |t: f64| if forward { t < walker.time } else { t > walker.time };
            while here + 2 < self.times.len() && after(self.times[here + 1]) {
                here += 1;
            }
            let since = walker.time - self.times[here];
            for (i, &x) in walker.state.iter().enumerate() {
                let at = here * n + i;
                let c = &self.coefficients[at * (ORDER + 1)..(at + 1) * (ORDER + 1)];
                let difference = ((c[0] - x) + (self.low[at] + since * horner(&c[1..], since))).abs() * SAFETY;
                for step in first..=here {
                    let error = &mut self.error[step * n + i];
                    *error = error.max(difference + FLOOR * x.abs());
                }
            }
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
        for i in n..self.error.len() {
            self.error[i] = self.error[i].max(self.error[i - n]);
        }
    }
}
