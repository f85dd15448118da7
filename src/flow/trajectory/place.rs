//! Values of states along a trajectory, and their polynomials around a time.
//!
//! **In:** a trajectory and times of it. **Out:** values with their errors, and series. **Guaranteed:** a value is, bit for bit, the same
//! alone, beside other states and beside other times: the same operations in the same order.

use std::ops::Range;

use super::{ORDER, Trajectory};
use number::{Bounded, Work, widely};

/// A place on a trajectory: a step and the time since its start.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Place {
    backward: bool,
    step: usize,
    since: f64,
}

/// The stretches of places that lie in one step, each with its first.
fn runs<const N: usize>(places: &[Place; N]) -> impl Iterator<Item = (Place, Range<usize>)> {
    let mut from = 0;
    std::iter::from_fn(move || {
        let first = *places.get(from)?;
        let is_there = |place: &&Place| (place.backward, place.step) == (first.backward, first.step);
        let run = from..from + places[from..].iter().take_while(is_there).count();
        from = run.end;
        Some((first, run))
    })
}

impl Trajectory {
    /// The step that contains a time; the nearest one for a time outside.
    pub(in super::super) fn place(&self, t: f64) -> Place {
        let backward = t < self.initial_time && self.backward.times.len() > 1 || self.forward.times.len() < 2;
        let branch = self.branch(backward);
        let before =
            if backward { branch.times.partition_point(|&s| s > t) } else { branch.times.partition_point(|&s| s <= t) };
        let step = before.saturating_sub(1).min(branch.times.len().saturating_sub(2));
        Place { backward, step, since: t - branch.times.get(step).copied().unwrap_or(t) }
    }

    /// The places of several times, of which neighbours are often in one step.
    pub(in super::super) fn places<const N: usize>(&self, times: &[f64; N]) -> [Place; N] {
        let mut last: Option<Place> = None;
        times.map(|t| {
            let within = |step: usize| {
                let ends = self.forward.times.get(step).zip(self.forward.times.get(step + 1));
                ends.is_some_and(|(start, end)| *start <= t && t < *end)
            };
            // In the same step, or in the one that follows.
            let near = last.filter(|place| !place.backward).map(|place| [place.step, place.step + 1]);
            let place = match near.and_then(|steps| steps.into_iter().find(|step| within(*step))) {
                Some(step) => Place { backward: false, step, since: t - self.forward.times[step] },
                None => self.place(t),
            };
            last = Some(place);
            place
        })
    }

    /// The place of a time at the end of a step of the forward part.
    #[cfg(test)]
    pub(in super::super) fn place_before(&self, t: f64, step: usize) -> Place {
        Place { backward: false, step, since: t - self.forward.times[step] }
    }

    /// The value of a state.
    pub(in super::super) fn value(&self, place: Place, state: usize) -> f64 {
        let [[value]] = self.values(&[place], [state]);
        value
    }

    /// The values of some states at several times at once: the same operations, state by state and time by time, none of which
    /// waits for those of another one.
    pub(in super::super) fn values<const N: usize, const M: usize>(
        &self,
        places: &[Place; N],
        states: [usize; M],
    ) -> [[f64; N]; M] {
        widely(Values { of: self, places, states })
    }

    /// The polynomial of a state around another time of its step: the first coefficients.
    ///
    /// This is the polynomial of the step, written anew; a series that is grown at that time is the same up to the error of
    /// the trajectory, and takes ten times as long.
    pub(in super::super) fn around(&self, place: Place, state: usize, out: &mut [f64]) {
        let mut found = [[f64::NAN]; ORDER + 1];
        self.around_lanes(&[place], state, &mut found);
        for (to, [from]) in out.iter_mut().zip(found) {
            *to = from;
        }
    }

    /// The same around several times at once: the same operations, time by time.
    pub(in super::super) fn around_lanes<const N: usize>(
        &self,
        places: &[Place; N],
        state: usize,
        out: &mut [[f64; N]],
    ) {
        let n = self.dimension;
        let mut c = [[f64::NAN; N]; ORDER + 1];
        for (i, place) in places.iter().enumerate() {
            let (stored, _) = self.branch(place.backward).polynomial(n, place.step, state);
            c.iter_mut().zip(stored.iter().step_by(n)).for_each(|(c, &x)| c[i] = x);
        }
        let since = places.map(|place| place.since);
        for lowest in 0..ORDER.min(out.len()) {
            for k in (lowest..ORDER).rev() {
                for i in 0..N {
                    c[k][i] += since[i] * c[k + 1][i];
                }
            }
        }
        [c[0]] = self.values(places, [state]);
        for (to, from) in out.iter_mut().zip(c) {
            *to = from;
        }
    }

    /// The value of a state with its error.
    pub(in super::super) fn bounded(&self, place: Place, state: usize) -> Bounded {
        Bounded { value: self.value(place, state), error: self.error(place, state) }
    }

    /// The same of some states at several times at once, each handed to `put`.
    pub(in super::super) fn bounded_values<const N: usize>(
        &self,
        places: &[Place; N],
        states: &[usize],
        mut put: impl FnMut(usize, [Bounded; N]),
    ) {
        let mut hand_over = |some: &[usize], values: &[[f64; N]]| {
            for (&state, values) in some.iter().zip(values) {
                let of = |i: usize| Bounded { value: values[i], error: self.error(places[i], state) };
                put(state, std::array::from_fn(of));
            }
        };
        // So many that their sums fill the registers.
        for some in states.chunks(4) {
            match *some {
                [a, b, c, d] => hand_over(some, &self.values(places, [a, b, c, d])),
                [a, b, c] => hand_over(some, &self.values(places, [a, b, c])),
                [a, b] => hand_over(some, &self.values(places, [a, b])),
                [a] => hand_over(some, &self.values(places, [a])),
                // No chunk is longer.
                _ => {}
            }
        }
    }

    fn error(&self, place: Place, state: usize) -> f64 {
        if place.since == 0.0 && place.step == 0 {
            self.initial_error[state]
        } else {
            let errors = &self.branch(place.backward).error;
            errors.get(place.step * self.dimension + state).copied().unwrap_or(f64::INFINITY)
        }
    }
}

/// The values of states at places.
struct Values<'v, const N: usize, const M: usize> {
    of: &'v Trajectory,
    places: &'v [Place; N],
    states: [usize; M],
}

impl<const N: usize, const M: usize> Work for Values<'_, N, M> {
    type Output = [[f64; N]; M];
    #[inline(always)]
    fn work(self) -> [[f64; N]; M] {
        let Values { of, places, states } = self;
        let n = of.dimension;
        let length = n * (ORDER + 1);
        let since = places.map(|place| place.since);
        let mut out = [[f64::NAN; N]; M];
        for (first, run) in runs(places) {
            // The polynomials of one step at all times, of which those count that lie in it: few blocks of times have many steps.
            let branch = of.branch(first.backward);
            let Some(series) = branch.coefficients.get(first.step * length..(first.step + 1) * length) else {
                continue;
            };
            let mut sums = [[0.0; N]; M];
            for row in series.chunks_exact(n.max(1)).skip(1).rev() {
                for (sums, &state) in sums.iter_mut().zip(&states) {
                    let x = row[state];
                    for i in 0..N {
                        sums[i] = sums[i] * since[i] + x;
                    }
                }
            }
            for ((out, sums), &state) in out.iter_mut().zip(&sums).zip(&states) {
                let low = branch.low.get(first.step * n + state).copied().unwrap_or(f64::NAN);
                for i in run.clone() {
                    out[i] = series[state] + (low + since[i] * sums[i]);
                }
            }
        }
        out
    }
}
