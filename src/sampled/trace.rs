//! A motion, sampled, and a claim to be tried on it.
//!
//! **In:** a motion of a [`Stage`], and the leaves that are wanted. **Out:** a [`Trace`]: the sample times and the values there, from which
//! values at other times can be asked for.
//!
//! **Guaranteed:** values that dual numbers contradict are told, where it is asked.

use std::sync::{Arc, OnceLock};

use crate::derivation::Claim;
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::{Motion, Points, Rapid, Zeros};
use crate::number::{Bounded, NoValue};
use crate::stage::{Built, DENSITY, Stage, thinned};
use claim::program::{Program, Values};
use reason::{Reason, Sampling};

/// Every how many samples dual numbers are compared with the bounds.
const CROSS_CHECK: usize = 8;

/// Points between neighbouring samples at which a claim that holds is tried again, on each side of its worst sample.
const CLOSER: usize = 4;

/// Most values between the samples of a motion that are kept for all claims on it.
const SHARED: usize = 1_000_000;

/// A motion, sampled.
pub struct Trace<'a> {
    /// Where the motion is from.
    pub stage: &'a Stage,
    /// The position of its trajectory.
    pub trajectory: usize,
    /// The motion.
    pub motion: &'a Motion,
    /// The leaves that each point has values of.
    pub leaves: &'a [Leaf],
    /// The sample times, increasing.
    pub times: Vec<f64>,
    /// The values at the sample times.
    pub points: Arc<Points>,
    /// Times between the samples at which claims are tried that may vary rapidly, and the values there.
    pub(crate) between: OnceLock<Option<(Vec<f64>, Points)>>,
}

impl Trace<'_> {
    /// The values of all leaves at another time.
    pub fn values(&self, t: f64) -> Values {
        self.stage.values(self.trajectory, t)
    }

    /// Whether the motion knows a leaf, by its position.
    pub(crate) fn knows(&self, leaf: usize) -> bool {
        self.stage.knows(self.trajectory, leaf)
    }

    /// The same motion at the same times, with the values of other leaves, by their positions.
    pub fn again(&self, leaves: Vec<usize>) -> Trace<'_> {
        let points = Arc::new(self.stage.points(self.trajectory, &self.times, &leaves));
        Trace { points, times: self.times.clone(), between: OnceLock::new(), ..*self }
    }

    /// Forgets the values of all leaves but these, by their positions, and what helped to find them.
    pub fn keep(&mut self, leaves: &[usize]) {
        Arc::make_mut(&mut self.points).keep(leaves);
        self.between.take();
        self.motion.rest();
    }

    /// Times around a sample: a few between it and its neighbours, increasing.
    pub fn near(&self, at: usize) -> Vec<f64> {
        near(&self.times, at)
    }

    /// The zeros of an expression that the claims ask for; `None` where it has no meaning on the motion.
    pub fn zeros(&self, e: Expr) -> Option<&Zeros> {
        self.stage.zeros(self.trajectory, e)
    }

    /// Where expressions that the claims ask for vary more rapidly than the motion is sampled.
    pub fn rapid(&self, expressions: &[Expr]) -> Rapid {
        self.stage.rapid(self.trajectory, expressions, &self.times)
    }

    /// What a claim needs at times at which expressions vary more rapidly than the motion is sampled: many claims are tried at the same.
    pub(crate) fn points_between(&self, program: &Program, times: &[f64]) -> Arc<Points> {
        let known = self.between.get_or_init(|| {
            let times = self.stage.all_rapid(self.trajectory, &self.times);
            let leaves: Vec<usize> = (0..self.leaves.len()).collect();
            let shared = times.len() <= SHARED / leaves.len().max(1);
            shared.then(|| {
                let points = self.stage.points(self.trajectory, &times, &leaves);
                (times, points)
            })
        });
        let shared = known.as_ref().and_then(|(known, points)| {
            let place = |t: &f64| known.binary_search_by(|x| x.total_cmp(t)).ok();
            let places: Option<Vec<usize>> = times.iter().map(place).collect();
            Some(Arc::new(points.some(&places?, program.inputs())))
        });
        shared.unwrap_or_else(|| self.points_at(program, times))
    }

    /// What a claim needs at other times.
    pub fn points_at(&self, program: &Program, times: &[f64]) -> Arc<Points> {
        Arc::new(self.stage.points(self.trajectory, times, program.inputs()))
    }

    /// What a claim needs at events, and at other times: an event has a `slack`, up to which its time is known, and how far
    /// the values move meanwhile is part of their error.
    pub fn points_at_events(&self, program: &Program, events: &[(f64, Option<f64>)]) -> Arc<Points> {
        let around = |&(t, slack): &(f64, Option<f64>)| {
            let beside = slack.map(|slack| [t - slack, t + slack]);
            [t].into_iter().chain(beside.into_iter().flatten())
        };
        let times: Vec<f64> = events.iter().flat_map(around).collect();
        let found = self.points_at(program, &times);
        let mut next = 0;
        let point = |(_, slack): &(f64, Option<f64>)| -> Values {
            let at = next;
            next += if slack.is_some() { 3 } else { 1 };
            let here = found.row(at);
            if slack.is_none() { here } else { widened(here, found.row(at + 1), found.row(at + 2)) }
        };
        Arc::new(events.iter().map(point).collect())
    }

    /// The values of all leaves at an event, whose time is known up to `slack`: how far they move meanwhile is part of
    /// their error.
    pub fn values_at_event(&self, t: f64, slack: f64) -> Values {
        widened(self.values(t), self.values(t - slack), self.values(t + slack))
    }
}

/// Times around one of several: a few between it and its neighbours, increasing.
pub(crate) fn near(times: &[f64], at: usize) -> Vec<f64> {
    let (centre, neighbours) = (times[at], [at.checked_sub(1), Some(at + 1)]);
    let between = |other: f64| (1..=CLOSER).map(move |k| centre + (other - centre) * k as f64 / (CLOSER + 1) as f64);
    let neighbours = neighbours.into_iter().flatten().filter_map(|i| times.get(i).copied());
    let mut times: Vec<f64> = neighbours.flat_map(between).collect();
    times.sort_by(f64::total_cmp);
    times
}

/// Values at an event, with how far they move until just before and just after it.
fn widened(here: Values, before: Values, after: Values) -> Values {
    let widened = |((here, a), b): ((Result<Bounded, NoValue>, _), _)| {
        let here = here?;
        let moved = |x: Result<Bounded, NoValue>| x.map_or(0.0, |x| (x.value - here.value).abs());
        // Over so short a time everything moves linearly; twice the change covers what is not.
        Ok(Bounded { value: here.value, error: here.error + 2.0 * moved(a).max(moved(b)) })
    };
    here.into_iter().zip(before).zip(after).map(widened).collect()
}

/// A claim to be tried on a motion.
#[derive(Clone, Copy)]
pub struct Trial<'a> {
    /// The expressions.
    pub graph: &'a Graph,
    /// The claim.
    pub claim: &'a Claim,
    /// The claim, compiled.
    pub program: &'a Program,
    /// The motion.
    pub trace: &'a Trace<'a>,
    /// Whether a reader is shown both sides along the motion.
    pub shown: bool,
}

impl Built {
    /// The times at which it is sampled.
    pub(crate) fn sample_times(&self) -> Vec<f64> {
        let mut times = self.motion.sample_times(DENSITY);
        // A derived motion may be tried on a part of the span of its source.
        let (from, to) = self.span;
        times.retain(|t| (from..=to).contains(t));
        for end in [from, to] {
            if let Err(at) = times.binary_search_by(|t| t.total_cmp(&end)) {
                times.insert(at, end);
            }
        }
        thinned(times)
    }
}

impl Stage {
    /// Samples a motion.
    ///
    /// # Errors
    /// That the trajectory was not built.
    pub fn sampled<'a>(&'a self, trajectory: usize, leaves: &'a [Leaf]) -> Result<Trace<'a>, String> {
        let Some(built) = self.built(trajectory) else { return Err("a trajectory was not built".to_owned()) };
        let motion = built.motion.as_ref();
        if let Some((times, points)) = built.samples.get().cloned() {
            let points = points.arranged(&built.places);
            return Ok(Trace {
                stage: self,
                trajectory,
                motion,
                leaves,
                times,
                points: points.into(),
                between: OnceLock::new(),
            });
        }
        let times = built.sample_times();
        let points = motion.along(&times);
        if self.keeping {
            // Another thread can only have found the same.
            let _ = built.samples.set((times.clone(), points.clone()));
        }
        let points = points.arranged(&built.places);
        Ok(Trace { stage: self, trajectory, motion, leaves, times, points: points.into(), between: OnceLock::new() })
    }

    /// Compares the two routes to the values along a motion: a value for which dual numbers and propagated bounds disagree.
    pub fn contradiction(&self, graph: &Graph, trace: &Trace) -> Option<Reason> {
        let built = self.built(trace.trajectory)?;
        let Trace { motion, leaves, times, points, .. } = trace;
        let mut contradiction = None;
        for (i, &t) in times.iter().enumerate().step_by(CROSS_CHECK) {
            let duals = motion.dual_at(t);
            for (k, place) in built.places.iter().enumerate() {
                let (Some(place), Ok(bounded)) = (place, points.get(i, k)) else { continue };
                let Some(Ok(dual)) = duals.get(*place) else { continue };
                let gap = (dual.re - bounded.value).abs();
                // Both routes round on their own way: the bound of one covers its distance from the truth. Where a value
                // changes by much within the rounding of the time, dual numbers may be off by that.
                let steep = 8.0 * f64::EPSILON * (t * dual.eps).abs();
                let room = 2.0 * bounded.error + 1e-12 * bounded.value.abs() + steep + f64::MIN_POSITIVE;
                if gap > room.max(1e-14) && gap > 1e3 * bounded.error {
                    contradiction.get_or_insert_with(|| {
                        let (name, series) = (graph.leaf_latex(leaves[k]).into(), (bounded.value, bounded.error));
                        Sampling::TwoRoutesDiffer { name, t, dual: dual.re, series }.into()
                    });
                }
            }
        }
        contradiction
    }
}
