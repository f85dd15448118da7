//! One claim on one motion.
//!
//! **In:** a compiled claim, and a [`Trace`](crate::trace::Trace): the points of a motion. **Out:** a verdict, from a finding for each part of the
//! claim and each hypothesis. The same few steps for every part: see which times count, measure, weigh, look between.

use std::sync::Arc;

use crate::between::between_samples;
use crate::derivation::{Derivation, Event};
use crate::describe::{Describer, Left};
use crate::events::Events;
use crate::expr::Leaf;
use crate::independence::Gradients;
use crate::limit::limit;
use crate::peaks::{Further, Of, Peaks};
use crate::pointwise::{Pointwise, Tried, selected};
use crate::trace::Trial;
use crate::verdict::{Evidence, Finding, Possible, Truth, Verdict, Witness};
use crate::weakening::{
    beyond_the_span, known, only_at_events, open_events, unless_met_elsewhere, unless_one_sided, unless_unresolved,
    unless_valued_between,
};
use crate::weigh::weigh;
use crate::{across, events, independence, same_motion, stretches};
use claim::mute::silence;
use claim::program::{Assumption, Part, What};
use claim::sides::{MeasuredGroup, Measurements, measure, measure_first};
use reason::{Plain, Reason, Sampling, Sides};

/// The most parts of a claim that are looked at closer, each by itself.
const MANY: usize = 64;

/// Tries a claim on a motion. `gradients` are those of a claim of independence.
pub fn try_claim(derivation: &Derivation, trial: &Trial, gradients: Option<&Result<Gradients, Reason>>) -> Verdict {
    let Trial { program, trace, .. } = *trial;
    let decide = |parts: Vec<Finding>, hypotheses: Vec<Finding>| {
        Verdict::decide(program.claim.clone(), parts.into_iter().chain(hypotheses).collect())
    };
    if let Some(unmet) = unmet_at_once(trial) {
        let parts = program.parts.iter().map(|_| Finding::open(Plain::NotTriedWhereUnmet));
        return decide(parts.collect(), unmet);
    }
    let mut met = stretches::look(trial);
    // Other motions and gradients need more values than the comparisons of the claim.
    let special = |p: &claim::program::Part| {
        matches!(p.what, What::SameMotion(..) | What::Independent | What::Across | What::Unread(_))
    };
    if program.parts.iter().any(special) && met.more.take().is_some() {
        met.open.get_or_insert(Sampling::MetBetween);
    }
    let shared = same_motion::times_of_both(trial);
    let (times, points) = match (&met.more, &shared) {
        (Some(more), _) => (&more.times, &more.points),
        (None, Some((times, points))) => (times, points),
        (None, None) => (&trace.times, &trace.points),
    };
    let describer = Describer::new(trial, times, points);
    let mut measured = measure(program, points, None);
    silence(trial.graph, program, trace.leaves, points, &mut measured);
    let left = selected(trial, &measured, &describer);
    let along = Tried { times, points, left };
    let peaks = Peaks::new(trial, &measured);
    let hypotheses: Vec<Finding> =
        (0..program.hypotheses.len()).map(|h| met_on(trial, &describer, &peaks, (h, &along), &met)).collect();
    // Parts at events, or at all of these times.
    let events = events::of_claim(trial.graph, (trial.claim, program), trace);
    let parts = match (&program.at, &events) {
        (None, _) => {
            let each = |position| {
                let finding = part(derivation, trial, (&peaks, &describer), &along, position, gradients);
                let finding = unless_met_elsewhere(&met, finding);
                unless_valued_between(trial, &measured, &|m| &m.parts[position], &along, finding)
            };
            (0..program.parts.len()).map(each).collect()
        }
        (Some(event), Some(found)) if !found.zeros.times.is_empty() => {
            let zeros = &found.zeros;
            let events: Vec<_> = zeros.times.iter().copied().zip(zeros.slack.iter().copied().map(Some)).collect();
            let points = match program.parts.iter().any(special) {
                true => {
                    let at = |&(t, slack): &(f64, Option<f64>)| trace.values_at_event(t, slack.unwrap_or(0.0));
                    Arc::new(events.iter().map(at).collect())
                }
                false => trace.points_at_events(program, &events),
            };
            let describer = Describer::new(trial, &zeros.times, &points);
            let along = peaks.along;
            let mut measured = measure(program, &points, None);
            measured.at_events(trial.graph, *event, along);
            silence(trial.graph, program, trace.leaves, &points, &mut measured);
            let peaks = Peaks::new(trial, &measured);
            let mut left = selected(trial, &measured, &describer);
            beyond_the_span(trial, zeros, &mut left);
            let tried = Tried { times: &zeros.times, points: &points, left };
            let each = |position| {
                let finding = part(derivation, trial, (&peaks, &describer), &tried, position, gradients);
                only_at_events(trial, found, finding)
            };
            (0..program.parts.len()).map(each).collect()
        }
        (Some(_), found) => program.parts.iter().map(|_| no_event(trial, found.as_ref())).collect(),
    };
    decide(parts, hypotheses)
}

/// What is known of the hypotheses of a claim, if one of them is false at the first time, which counts.
fn unmet_at_once(trial: &Trial) -> Option<Vec<Finding>> {
    let Trial { program, trace, .. } = *trial;
    if program.hypotheses.is_empty() {
        return None;
    }
    let times = &trace.times[..1.min(trace.times.len())];
    let describer = Describer::new(trial, times, &trace.points);
    let measured = measure_first(program, &trace.points, times.len());
    let left = selected(trial, &measured, &describer);
    let along = Tried { times, points: &trace.points, left };
    let false_here = |h: usize| {
        let compared = matches!(program.hypotheses[h].part.what, What::Every);
        let judged = Pointwise::new(&measured.hypotheses[h], trial.claim.precision);
        compared && along.left.first() == Some(&Left::In) && judged.at(0) == Possible::FALSE
    };
    let count = program.hypotheses.len();
    (0..count).any(false_here).then(|| {
        let none = stretches::Search::default();
        let each = |h: usize| match false_here(h) {
            true => met_on(trial, &describer, &Peaks::new(trial, &measured), (h, &along), &none),
            false => Finding::open(Plain::NotLookedAt),
        };
        (0..count).map(each).collect()
    })
}

/// What is known of a hypothesis.
fn met_on(
    trial: &Trial,
    describer: &Describer,
    peaks: &Peaks,
    (position, along): (usize, &Tried),
    met: &stretches::Search,
) -> Finding {
    let measured = peaks.along;
    let Assumption { text, part } = &trial.program.hypotheses[position];
    let finding = match &part.what {
        What::Limit(point) => limit_where(trial, along, &|m| &m.hypotheses[position], point),
        _ => {
            let finding = weigh(describer.setting(along.left.clone()), &measured.hypotheses[position]);
            peaks.look(&|m| &m.hypotheses[position], finding)
        }
    };
    let text = || text.as_str().into();
    let sides = |w: &Witness| Sides { t: w.t, left: w.left, right: w.right, bound: w.bound };
    let reason = match known(&finding).decided() {
        Some(Truth::True) => None,
        Some(Truth::False) => {
            let sides = finding.evidence().witness.as_ref().map(sides);
            Some(Sampling::NotMet { text: text(), sides }.into())
        }
        Some(Truth::Void) => finding.evidence().reason.clone(),
        None => {
            let why = finding.evidence().reason.clone().map(Arc::new);
            Some(Sampling::AssumptionOpen { text: text(), why }.into())
        }
    };
    // What is left out where a hypothesis has no value is no matter of the claim.
    let unmet = finding.evidence().witness.clone().filter(|_| known(&finding) == Possible::FALSE);
    let evidence = Evidence { reason, unmet, excluded: Vec::new(), series: None, ..finding.evidence().clone() };
    let finding = unless_unresolved(trial, part, Finding::sampled(known(&finding), evidence));
    let finding = unless_one_sided(trial, &part.group, finding);
    let finding = unless_met_elsewhere(met, finding);
    unless_valued_between(trial, measured, &|m| &m.hypotheses[position], along, finding)
}

/// What is known of one part of a claim, at the times that count.
fn part(
    derivation: &Derivation,
    trial: &Trial,
    (peaks, describer): (&Peaks, &Describer),
    tried: &Tried,
    position: usize,
    gradients: Option<&Result<Gradients, Reason>>,
) -> Finding {
    let measured = peaks.along;
    let program = trial.program;
    let part = &program.parts[position];
    let setting = || describer.setting(tried.left.clone());
    let weighed = || weigh(setting(), &measured.parts[position]);
    // What is tried at events only is not looked at between them.
    // Further times are looked at for each part by itself: not for those of a chain of a thousand relations.
    let closer = |finding: Finding| match program.at {
        _ if program.parts.len() > MANY => finding,
        Some(_) => finding,
        None => peaks.look(&|m| &m.parts[position], look_closer(trial, measured, position, finding)),
    };
    let between = |finding: Finding| match program.at {
        Some(_) => finding,
        None => between_samples(trial, (measured, tried), position, finding),
    };
    let finding = match &part.what {
        What::Every => between(closer(weighed())),
        // What is not known is no lack of a value.
        What::Defined => match not_known(trial, part) {
            Some(reason) => Finding::sampled(Possible::VOID, Evidence::because(reason)),
            None => between(closer(weighed())),
        },
        What::Denied => {
            let mut setting = setting();
            setting.first = true;
            denied(trial, between(weigh(setting, &measured.parts[position])))
        }
        What::Constant => constant(trial, (measured, describer), tried, position, closer),
        What::Value => Finding::open(Plain::NothingByItself),
        What::Limit(point) => limit_where(trial, tried, &|m| &m.parts[position], point),
        What::SameMotion(other, of) => same_motion::try_on(derivation, trial, tried, *other, of),
        What::Across => across::try_on(derivation, trial, tried, position),
        What::Unread(why) => Finding::open(Reason::quoted(why)),
        What::Independent => match gradients {
            Some(Ok(gradients)) => independence::try_on(gradients, trial, tried),
            Some(Err(reason)) => Finding::open(reason.clone()),
            None => Finding::open(Plain::NoGradients),
        },
    };
    let finding = match program.at {
        Some(_) => finding,
        None => unless_one_sided(trial, &part.group, finding),
    };
    unless_unresolved(trial, part, finding)
}

/// What a part needs and a motion does not know.
fn not_known(trial: &Trial, part: &Part) -> Option<Reason> {
    let Trial { graph, trace, .. } = *trial;
    let known = |leaf: &Leaf| trace.leaves.iter().position(|of| of == leaf).is_none_or(|at| trace.knows(at));
    let needed = graph.leaves(part.group.comparisons.iter().map(|c| c.left));
    let missing = needed.into_iter().find(|leaf| !known(leaf))?;
    Some(Sampling::NotKnown(graph.leaf_latex(missing).into()).into())
}

/// A limit, where some time counts: without one, nothing is said of it.
fn limit_where(trial: &Trial, tried: &Tried, group: Of, point: &latex::LimitPoint) -> Finding {
    let out = |l: &Left| match l {
        Left::Out(reason) => Some(Reason::clone(reason)),
        Left::In | Left::Open(_) => None,
    };
    let reason = || tried.left.iter().find_map(out).unwrap_or(Plain::NoTimeCounts.into());
    if tried.left.contains(&Left::In) {
        // Selectors may cut off the point itself: enclosures look on each side of it.
        return match trial.program.selectors.is_empty() {
            true => limit(trial, group, point),
            false => Finding::open(Plain::LimitThroughAssumed),
        };
    }
    match tried.left.iter().all(|l| matches!(l, Left::Out(_))) {
        true => Finding::sampled(Possible::VOID, Evidence::because(reason())),
        false => Finding::open(Plain::WhetherTimesCountUntold),
    }
}

/// A part that says that something never happens, for a claim that it happens: with words of the happening.
fn denied(trial: &Trial, finding: Finding) -> Finding {
    let mut evidence = finding.evidence().clone();
    let (from, to) = trial.trace.stage.span(trial.trace.trajectory);
    match (known(&finding).decided(), &evidence.witness) {
        (Some(Truth::False), Some(w)) => {
            let found = evidence.residual.as_ref().is_some_and(|r| r.at == w.t);
            let reason = match trial.trace.times.binary_search_by(|t| t.total_cmp(&w.t)) {
                Ok(_) => Sampling::FirstSeen(w.t),
                Err(_) => Sampling::HappensFirst(w.t),
            };
            evidence.reason = Some(reason.into());
            if !found {
                evidence.residual = None;
            }
            evidence.samples = evidence.samples.max(1);
        }
        (Some(Truth::True), _) => {
            evidence.reason = Some(Sampling::NotSeen { samples: None, from, to, why: None }.into());
        }
        (Some(Truth::Void), _) => {}
        (None, _) | (Some(Truth::False), None) => {
            let (samples, why) = (Some(evidence.samples), evidence.reason.take().map(Arc::new));
            evidence.reason = Some(Sampling::NotSeen { samples, from, to, why }.into());
        }
    }
    Finding::sampled(known(&finding), evidence)
}

/// That a quantity is the same at all times that count: as at the start, if that counts; else as at the first that does.
fn constant(
    trial: &Trial,
    (measured, describer): (&Measurements, &Describer),
    tried: &Tried,
    position: usize,
    closer: impl Fn(Finding) -> Finding,
) -> Finding {
    let Trial { program, trace, .. } = *trial;
    let group = &measured.parts[position];
    let start = trace.stage.initial_time(trace.trajectory);
    let valued = |group: &MeasuredGroup, i: usize| {
        group.signs.iter().all(|s| s.iter().all(|series| series.difference(i).is_ok()))
    };
    let counts = |i: usize| tried.left[i] == Left::In;
    let at_start = tried.times.binary_search_by(|t| t.total_cmp(&start)).ok();
    let compared = at_start.is_some_and(|i| counts(i) && valued(group, i)) && program.at.is_none();
    let values = program.parts.get(position + 1).filter(|p| matches!(p.what, What::Value));
    if compared || values.is_none() {
        return closer(weigh(describer.setting(tried.left.clone()), group));
    }
    let all = measure(program, tried.points, None);
    let Some(mut values) = all.parts.into_iter().nth(position + 1) else {
        return Finding::open(Plain::NotMeasured);
    };
    values.relative_to_the_first(tried.times.len(), counts);
    weigh(describer.setting(tried.left.clone()), &values)
}

/// Tries a part that is true at further times around its worst sample: the worst of all times lies between samples.
fn look_closer(trial: &Trial, along: &Measurements, position: usize, finding: Finding) -> Finding {
    let Trial { trace, .. } = *trial;
    let (Possible::TRUE, Some(worst)) = (known(&finding), &finding.evidence().residual) else { return finding };
    let Some(at) = trace.times.iter().position(|&t| t == worst.at) else { return finding };
    let near = trace.near(at);
    let points = trace.points_at(trial.program, &near);
    let Some(closer) = Further::new(trial, along, near, points) else { return finding };
    let closer = closer.weigh(trial, &|m| &m.parts[position]);
    match (known(&closer), &closer.evidence().residual) {
        (Possible::FALSE, _) => closer,
        (Possible::TRUE, Some(r)) if r.max * worst.bound > worst.max * r.bound => {
            let samples = finding.evidence().samples + closer.evidence().samples;
            let (residual, within) = (Some(r.clone()), finding.evidence().within.max(closer.evidence().within));
            Finding::sampled(Possible::TRUE, Evidence { samples, residual, within, ..finding.evidence().clone() })
        }
        (known, _) => {
            let closer = if known == Possible::TRUE { closer.evidence().within } else { f64::INFINITY };
            let within = finding.evidence().within.max(closer);
            Finding::sampled(Possible::TRUE, Evidence { within, ..finding.evidence().clone() })
        }
    }
}

/// What is known of a part where the event of a claim is not found.
fn no_event(trial: &Trial, events: Option<&Events>) -> Finding {
    let trace = trial.trace;
    if let Some(reason) = events.and_then(|found| open_events(trial, found, |_| true)) {
        return Finding::open(reason);
    }
    if let Some(problem) = trace.motion.problem() {
        return Finding::open(Reason::quoted(problem));
    }
    let event = trial.claim.at.as_ref().map(Event::says).unwrap_or_default();
    let (from, to) = trace.stage.span(trace.trajectory);
    Finding::sampled(Possible::VOID, Evidence::because(Sampling::NoEvent(event.into(), from, to)))
}
