//! What samples leave open: why a finding at some times is not yet one of the motion.
//!
//! **In:** what was found at the times at which a claim was tried, and what the searches for zeros say of the times between them.
//! **Out:** the same finding, or one that leaves more possible, with the reason.
//!
//! **Guaranteed.** Nothing here decides: what was open stays open.

use crate::between::may_lie_beyond;
use crate::describe::{Left, incomplete};
use crate::events::Events;
use crate::expr::{Expr, Leaf};
use crate::flow::{Incomplete, Zeros};
use crate::number::NoValue;
use crate::pointwise::{Pointwise, Tried};
use crate::stretches;
use crate::stretches::BESIDE;
use crate::trace::Trial;
use crate::verdict::{Evidence, Exclusion, Finding, Possible, Strength, Truth};
use claim::comparison::Group;
use claim::program::{Part, What};
use claim::sides::{MeasuredGroup, Measurements, measure};
use reason::{Plain, Reason, Sampling, Search};
use std::sync::Arc;

/// Times that are closer than this share of the span are one.
const SINGLE: f64 = 1e-9;

/// What samples leave possible of a part.
pub(super) fn known(finding: &Finding) -> Possible {
    finding.known(Strength::Sampled).unwrap_or(Possible::ANY)
}

/// The same finding, of which some values are not excluded after all.
pub(super) fn reopened(finding: Finding, possible: Possible, reason: impl Into<Reason>) -> Finding {
    let known = known(&finding).or_else(possible);
    Finding::sampled(known, Evidence { reason: Some(reason.into()), ..finding.evidence().clone() })
}

/// What is known of a part whose selectors may be met at other times than those at which it was tried.
pub(super) fn unless_met_elsewhere(met: &stretches::Search, finding: Finding) -> Finding {
    let reason = match known(&finding).decided() {
        Some(Truth::True | Truth::Void) => met.open.clone().or(met.touches.clone()),
        Some(Truth::False) | None => None,
    };
    match reason {
        Some(reason) => reopened(finding, Possible::ANY, reason),
        None => finding,
    }
}

/// What is known of a part that is true, or void, and may have a value at a single time of a stretch without one; or that is
/// false at such a time.
pub(super) fn unless_valued_between(
    trial: &Trial,
    measured: &Measurements,
    of: &dyn for<'m, 'p> Fn(&'m Measurements<'p>) -> &'m MeasuredGroup<'p>,
    tried: &Tried,
    finding: Finding,
) -> Finding {
    let part = of(measured);
    let seen = match known(&finding).decided() {
        Some(Truth::True | Truth::Void) => None,
        Some(Truth::False) => match &finding.evidence().witness {
            Some(witness) => Some(witness.t),
            None => return finding,
        },
        None => return finding,
    };
    let (from, to) = trial.trace.stage.span(trial.trace.trajectory);
    let counts = |t: &&f64| seen.is_none_or(|seen| (seen - **t).abs() <= SINGLE * (to - from));
    let missing = |i: usize| {
        let mut groups = measured.selectors.iter().chain([part]);
        groups.any(|g| g.signs.iter().flatten().any(|series| series.difference(i).is_err()))
    };
    let single = |t: &&f64| {
        let before = tried.times.partition_point(|x| x < t).checked_sub(1);
        let after = tried.times.partition_point(|x| x <= t);
        let beside = [before, Some(after)].into_iter().flatten().filter(|i| *i < tried.times.len());
        beside.into_iter().any(missing)
    };
    let zeros = || trial.program.closed_edges().filter_map(|e| trial.trace.zeros(e));
    // What passes through 0 at an end of the span has a value at that time alone, if beside it there is none.
    let at_end = |t: &&f64| (**t - from).min(to - **t) <= SINGLE * (to - from);
    let touching = zeros().flat_map(|z| z.touching.iter().chain(z.times.iter().filter(at_end)));
    // Or it has one on a side on which a selector, or another edge, leaves nothing.
    let lives = |t: f64| {
        let point = trial.trace.points_at(trial.program, &[t]);
        let measured = measure(trial.program, &point, None);
        let has_values = |g: &MeasuredGroup| g.signs.iter().any(|sign| sign.iter().all(|s| s.difference(0).is_ok()));
        let judged = |g| Pointwise::new(g, trial.claim.precision).at(0).decided();
        from <= t
            && t <= to
            && has_values(of(&measured))
            && measured.selectors.iter().all(|g| !matches!(judged(g), Some(Truth::False | Truth::Void)))
    };
    let alone = |t: &&f64| !at_end(t) && ![-BESIDE, BESIDE].iter().any(|share| lives(**t + share * (to - from)));
    let crossing = || zeros().flat_map(|z| &z.times).filter(counts).find(alone);
    match touching.into_iter().filter(counts).find(single).or_else(crossing) {
        Some(&t) => reopened(finding, Possible::ANY, Sampling::SingleValue(t)),
        None => finding,
    }
}

/// What is known of a part with ± that is true at the samples, where at single times between them some of it has no value, and
/// the rest is judged by the other sign.
pub(super) fn unless_one_sided(trial: &Trial, group: &Group, finding: Finding) -> Finding {
    if known(&finding).decided() != Some(Truth::True) {
        return finding;
    }
    let single = |&e: &Expr| {
        let zeros = trial.trace.zeros(e)?;
        let gaps = zeros.incomplete.iter().map(|gap| gap.stretch().0);
        zeros.times.iter().chain(&zeros.touching).copied().chain(gaps).next()
    };
    let (from, to) = trial.trace.stage.span(trial.trace.trajectory);
    // Where the formulas of the motion, or their rates, have no value, that of some parts may be all that is left.
    let motion = &trial.trace.motion;
    let gaps = motion.unresolved().iter().filter(|gap| matches!(gap, Incomplete::NoValue { .. }));
    let absent = gaps.map(Incomplete::stretch).chain(motion.corners().iter().map(|&t| (t, t)));
    let parts = group.chooses() && group.comparisons.len() > 1;
    let inside = absent.filter(|&(start, end)| parts && start <= to && end >= from).map(|(start, _)| start.max(from));
    match group.one_sided.iter().find_map(single).or(inside.min_by(f64::total_cmp)) {
        Some(t) => reopened(finding, Possible::OPEN, Sampling::OneSided(t)),
        None => finding,
    }
}

/// Why there may be more events than those that were found; of gaps in the search those count that `counts` says.
pub(super) fn open_events(trial: &Trial, events: &Events, counts: impl Fn(&Incomplete) -> bool) -> Option<Reason> {
    let event: Arc<str> = trial.claim.at.as_ref().map_or("", |at| at.equation.text.as_str()).into();
    let zeros = &events.zeros;
    if trial.program.leaps_at {
        return Some(Sampling::EventLeaps(event).into());
    }
    if let Some(doubt) = &events.doubt {
        return Some(doubt.clone());
    }
    if let Some(t) = leap_of_the_motion(trial) {
        return Some(Sampling::MotionLeaps { t, event }.into());
    }
    if let Some(&t) = zeros.touching.first() {
        return Some(Sampling::EventTouches { t, event }.into());
    }
    let gap = incomplete(zeros.incomplete.iter().find(|i| counts(i))?);
    Some(Sampling::Incomplete { search: Search::Event(event), gap }.into())
}

/// A time in the span at which a state leaps, or may, that an event names.
fn leap_of_the_motion(trial: &Trial) -> Option<f64> {
    let Trial { graph, claim, program, trace, .. } = *trial;
    let moves = |l: &Leaf| claim.scope.moves(l);
    if !trace.motion.leaps() || !graph.leaves(program.at).iter().any(moves) {
        return None;
    }
    let (from, to) = trace.stage.span(trace.trajectory);
    let known = |gap: &&Incomplete| matches!(gap, Incomplete::NoValue { reason: NoValue::OutOfDomain, .. });
    let gaps = trace.motion.unresolved().iter().filter(|gap| !known(gap)).map(Incomplete::stretch);
    gaps.filter(|(start, end)| *start <= to && *end >= from).map(|(start, _)| start).next()
}

/// Events at an end of the span, up to the error of their times: whether they lie in it is not known.
pub(super) fn beyond_the_span(trial: &Trial, zeros: &Zeros, left: &mut [Left]) {
    let span = trial.trace.stage.span(trial.trace.trajectory);
    for ((&t, &slack), left) in zeros.times.iter().zip(&zeros.slack).zip(left) {
        if *left == Left::In && may_lie_beyond(span, t, slack) {
            *left = Left::Open(Arc::new(Sampling::EventInSpan(t).into()));
        }
    }
}

/// What is known of a part that was tried at events: where some may be missing, it is not known to be true, or void.
pub(super) fn only_at_events(trial: &Trial, events: &Events, finding: Finding) -> Finding {
    // Where the sides have no value, they do not meet.
    let counts = |i: &Incomplete| !matches!(i, Incomplete::NoValue { reason: NoValue::OutOfDomain, .. });
    // What is found at a leap is no event for certain, either.
    let refutes = trial.program.leaps_at || events.all;
    match (known(&finding).decided(), open_events(trial, events, counts)) {
        (Some(truth), Some(reason)) if refutes || truth != Truth::False => {
            let reason = Sampling::TriedAtEvents(events.zeros.times.len(), Arc::new(reason));
            reopened(finding, Possible::ANY, reason)
        }
        _ => finding,
    }
}

/// What is known of a part that is true, where the motion is not known from samples, or not as far as its span: it stays
/// open, and times without a value are named.
pub(super) fn unless_unresolved(trial: &Trial, part: &Part, finding: Finding) -> Finding {
    let Trial { graph, claim, trace, .. } = *trial;
    if !matches!(known(&finding).decided(), Some(Truth::True | Truth::Void)) || matches!(part.what, What::Limit(_)) {
        return finding;
    }
    // What was not reached was not tried.
    if let Some(problem) = trace.motion.problem() {
        return reopened(finding, Possible::ANY, Reason::quoted(problem));
    }
    let gaps = trace.motion.unresolved();
    let (from, to) = trace.stage.span(trace.trajectory);
    let inside = |gap: &&Incomplete| gap.stretch().0 <= to && gap.stretch().1 >= from;
    if known(&finding) != Possible::TRUE || !gaps.iter().any(|gap| inside(&gap)) {
        return finding;
    }
    let moves = |l: &Leaf| l.instant.is_none() && claim.scope.moves(l);
    let asserted = part.group.asserted
        && graph.leaves(part.group.comparisons.iter().flat_map(|c| [c.left, c.right])).iter().any(moves);
    let open = |gap: &&Incomplete| match gap {
        Incomplete::NoValue { reason: NoValue::OutOfDomain, .. } => asserted,
        Incomplete::NoValue { .. } => asserted || trace.motion.leaps(),
        Incomplete::Vanishing { .. } | Incomplete::Unresolved { .. } => true,
    };
    if let Some(gap) = gaps.iter().filter(inside).find(open) {
        let (from, to) = gap.stretch();
        let reason = match *gap {
            Incomplete::NoValue { reason, .. } => Sampling::MotionHasNoValue { from, to, why: reason },
            _ => Sampling::MotionUnresolved { from, to },
        };
        return reopened(finding, Possible::OPEN, reason);
    }
    let mut evidence = finding.evidence().clone();
    for gap in gaps.iter().filter(inside) {
        let (start, end) = (gap.stretch().0.max(from), gap.stretch().1.min(to));
        if !evidence.excluded.iter().any(|e| e.from <= end && start <= e.to) {
            let reason = Arc::new(Plain::MotionHasNoValueThere.into());
            evidence.excluded.push(Exclusion { from: start, to: end, reason });
        }
    }
    evidence.excluded.sort_by(|a, b| a.from.total_cmp(&b.from));
    Finding::sampled(Possible::TRUE, evidence)
}
