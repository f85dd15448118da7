//! Where the selectors of a claim, the inequalities among its assumptions, are met between two samples, and where it has values.
//!
//! **In:** the samples of a motion, the zeros of left − right of the assumptions, and the edges of domains. **Out:** more times, so
//! that every stretch on which the assumptions may be met has some of its own; and why there may be more such stretches.
//!
//! An inequality keeps its truth as long as left − right keeps its sign. Between two changes of sign it is met everywhere or
//! nowhere. A stretch that falls between two samples would be taken for one on which nothing is assumed, and one with a
//! single sample for one on which the claim was tried.

use std::sync::Arc;

use crate::between::is_weak;
use crate::describe::incomplete;
use crate::flow::{Incomplete, Points};
use crate::number::NoValue;
use crate::pointwise::Pointwise;
use crate::trace::Trial;
use crate::verdict::Possible;
use claim::program::{Values, What};
use claim::sides::measure;
use reason::{Sampling, Search as Searched};

/// Samples that a stretch between two changes must have; as many are added where there are fewer.
const FEW: usize = 8;
/// How far beside a time it is looked whether the assumptions are met, and whether something has a value: this share of the span.
pub(super) const BESIDE: f64 = 1e-7;
/// Most stretches that get times of their own.
const MOST: usize = 64;

/// The times at which a claim is tried, where its assumptions ask for more than the samples of the motion.
pub(super) struct Met {
    /// The times, increasing.
    pub times: Vec<f64>,
    /// The values at these times.
    pub points: Arc<Points>,
}

/// What was looked for.
#[derive(Default)]
pub(super) struct Search {
    /// More times; none where the samples do.
    pub more: Option<Met>,
    /// Why the assumptions may be met at other times, too.
    pub open: Option<Sampling>,
    /// A time at which an assumption may be met at that time alone.
    pub touches: Option<Sampling>,
}

/// Looks for stretches on which the assumptions are met.
pub(super) fn look(trial: &Trial) -> Search {
    let Trial { program, trace, .. } = *trial;
    let mut found = Search::default();
    let (from, to) = trace.stage.span(trace.trajectory);
    let mut cuts: Vec<f64> = vec![from, to];
    let mut any = false;
    for (assumption, kind, e) in program.met() {
        any = true;
        let text = || assumption.text.as_str().into();
        let Some(zeros) = trace.zeros(e) else { continue };
        cuts.extend(&zeros.times);
        // It may be met where the sides touch, and be violated on both sides of it.
        let mut met_at: Vec<f64> = zeros.times.iter().chain(&zeros.touching).copied().collect();
        met_at.sort_by(f64::total_cmp);
        let alone = |t: f64| {
            let (before, after) = (met_at.partition_point(|x| *x < t), met_at.partition_point(|x| *x <= t));
            let before = met_at[..before].last().map_or(from, |x| x.max(from));
            let after = met_at.get(after).map_or(to, |x| x.min(to));
            [before, after].into_iter().all(|end| end == t || !is_met(trial, t + 0.5 * (end - t)))
        };
        if let Some(&t) = zeros.touching.iter().find(|&&t| is_weak(kind) || alone(t)) {
            found.touches = Some(Sampling::MetAtMostNear { text: text(), t });
        }
        // Where several meet, each may be met at that time alone.
        if let (true, Some(&t)) = (is_weak(kind), zeros.times.iter().find(|&&t| is_met_alone(trial, t))) {
            found.touches.get_or_insert(Sampling::MetAlone(t));
        }
        for gap in &zeros.incomplete {
            let (start, end) = gap.stretch();
            cuts.extend([start, end].map(|t| t.clamp(from, to)));
            // Where it stays within its error of 0, or has no value, the samples of the motion say so.
            if let Incomplete::Unresolved { .. } | Incomplete::NoValue { reason: NoValue::Indeterminate, .. } = gap
                && end - start > 1e-9 * (to - from)
            {
                let search = Searched::Assumption(text());
                found.open = Some(Sampling::Incomplete { search, gap: incomplete(gap) });
            }
        }
    }
    // What has values between two edges of domains is tried on each stretch between them.
    for edge in program.edges() {
        let Some(zeros) = trace.zeros(edge) else { continue };
        any |= !zeros.times.is_empty();
        cuts.extend(&zeros.times);
    }
    // What two motions have in common ends where one of them has a corner.
    let others = program.parts.iter().filter_map(|part| match part.what {
        What::SameMotion(other, _) => trace.stage.motion(other),
        What::Every | What::Denied | What::Defined | What::Constant | What::Value | What::Limit(_) => None,
        What::Independent | What::Across | What::Unread(_) => None,
    });
    for other in others {
        any = true;
        let corners = other.corners().iter().chain(trace.motion.corners()).copied();
        cuts.extend(corners.filter(|t| from < *t && *t < to));
    }
    if !any {
        return found;
    }
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let mut times = Vec::new();
    for pair in cuts.windows(2) {
        let (start, end) = (pair[0], pair[1]);
        let inside = trace.times.partition_point(|&t| t < end) - trace.times.partition_point(|&t| t <= start);
        if inside >= FEW || !is_met(trial, start + 0.5 * (end - start)) {
            continue;
        }
        if times.len() >= MOST * FEW {
            found.open = Some(Sampling::MetTooOften(MOST));
            break;
        }
        times.extend((0..FEW).map(|k| start + (end - start) * (k as f64 + 0.5) / FEW as f64));
    }
    times.retain(|t| trace.times.binary_search_by(|x| x.total_cmp(t)).is_err());
    if times.is_empty() {
        return found;
    }
    // In the order of time, each once; those of the motion lie between.
    times.sort_by(f64::total_cmp);
    times.dedup();
    let values = trace.points_at(program, &times);
    let place = |(i, &t): (usize, &f64)| (trace.times.partition_point(|&x| x < t), values.row(i));
    let more: Vec<(usize, Values)> = times.iter().enumerate().map(place).collect();
    let points = Arc::new(trace.points.with(&more, program.inputs()));
    times.extend(&trace.times);
    times.sort_by(f64::total_cmp);
    found.more = Some(Met { times, points });
    found
}

/// Whether the inequalities among the assumptions may be met at a time, and are violated a little before and after it.
fn is_met_alone(trial: &Trial, t: f64) -> bool {
    let (from, to) = trial.trace.stage.span(trial.trace.trajectory);
    let beside = BESIDE * (to - from);
    let violated = |t: f64| t < from || t > to || !is_met(trial, t);
    violated(t - beside) && violated(t + beside) && is_met(trial, t)
}

/// Whether the inequalities among the assumptions are not violated at a time.
pub(super) fn is_met(trial: &Trial, t: f64) -> bool {
    if trial.program.selectors.is_empty() {
        return true;
    }
    let point = trial.trace.points_at(trial.program, &[t]);
    let measured = measure(trial.program, &point, None);
    let precision = trial.claim.precision;
    measured.selectors.iter().all(|group| Pointwise::new(group, precision).at(0) != Possible::FALSE)
}
