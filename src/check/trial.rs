//! One claim on one motion.
//!
//! **In:** a compiled claim, and a [`Course`]: the points of a motion. **Out:** a verdict. The same few steps for every
//! form of claim: measure, see which points the assumptions leave, weigh.

use std::sync::Arc;

use super::between::{Between, between_samples};
use super::comparison::{Group, Standing};
use super::describe::{Describer, short};
use super::limit::limit;
use super::measured::{Measurements, measure, measure_first};
use super::met;
use super::occurrence::occurrence;
use super::program::{Program, Use};
use super::stage::Stage;
use super::steep;
use super::telling::silence;
use super::verdict::{Evidence, Exclusion, Outcome, Verdict};
use super::weigh::{Judged, Left, TOLERATED_INCONCLUSIVE, weigh};
use crate::derivation::{Claim, Form};
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::{Incomplete, Motion, Points, Zeros};
use crate::latex::Role;
use crate::number::{Bounded, NoValue};

/// The values of all leaves at one time.
pub(super) type Values = Vec<Result<Bounded, NoValue>>;

/// A motion, sampled.
pub(super) struct Course<'a> {
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
}

impl Course<'_> {
    /// The values of all leaves at another time.
    pub fn values(&self, t: f64) -> Values {
        self.stage.values(self.trajectory, t)
    }

    /// The same motion at the same times, with the values of other leaves, by their positions.
    pub fn again(&self, leaves: Vec<usize>) -> Course<'_> {
        let points = Arc::new(self.stage.points(self.trajectory, &self.times, &leaves));
        Course { points, times: self.times.clone(), ..*self }
    }

    /// Forgets the values of all leaves but these, by their positions, and what helped to find them.
    pub fn keep(&mut self, leaves: &[usize]) {
        Arc::make_mut(&mut self.points).keep(leaves);
        self.motion.rest();
    }

    /// Times around a sample: a few between it and its neighbours, increasing.
    fn near(&self, at: usize) -> Vec<f64> {
        let (centre, neighbours) = (self.times[at], [at.checked_sub(1), Some(at + 1)]);
        let between = |other: f64| (1..=CLOSER).map(move |k| centre + (other - centre) * k as f64 / (CLOSER + 1) as f64);
        let neighbours = neighbours.into_iter().flatten().filter_map(|i| self.times.get(i).copied());
        let mut times: Vec<f64> = neighbours.flat_map(between).collect();
        times.sort_by(f64::total_cmp);
        times
    }

    /// The zeros of an expression that the claims ask for; `None` where it has no meaning on the motion.
    pub fn zeros(&self, e: Expr) -> Option<&Zeros> {
        self.stage.zeros(self.trajectory, e)
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
pub(super) struct Trial<'a> {
    /// The expressions.
    pub graph: &'a Graph,
    /// The claim.
    pub claim: &'a Claim,
    /// The claim, compiled.
    pub program: &'a Program,
    /// The motion.
    pub course: &'a Course<'a>,
    /// Whether a reader is shown both sides along the motion.
    pub shown: bool,
}

/// Tries a claim on a motion.
pub(super) fn try_claim(trial: &Trial) -> Verdict {
    let Trial { program, course, .. } = *trial;
    let zeros = program.at.and_then(|e| course.zeros(e));
    let at_events: Option<(Vec<f64>, Arc<Points>)> = match (&program.at, zeros) {
        (None, _) => None,
        (Some(_), Some(zeros)) if !zeros.times.is_empty() => {
            let events: Vec<_> = zeros.times.iter().copied().zip(zeros.slack.iter().copied().map(Some)).collect();
            Some((zeros.times.clone(), course.points_at_events(program, &events)))
        }
        (Some(_), zeros) => return no_event(trial, zeros),
    };
    let samples = || (course.times.as_slice(), &course.points);
    let (mut times, mut points) = match &at_events {
        Some((t, p)) => (t.as_slice(), p),
        None => samples(),
    };
    // An equation among the assumptions that fails at the first point settles it.
    if program.assumptions.iter().any(|a| a.throughout) {
        let applied = apply(trial, &measure_first(program, points, 1), &Describer::new(trial, &times[..1], points));
        if let Some(reason) = applied.unmet {
            return not_applicable(reason);
        }
    }
    let met = if at_events.is_none() { met::look(trial) } else { met::Search::default() };
    if let Some(more) = &met.more {
        (times, points) = (&more.times, &more.points);
    }
    let describer = Describer::new(trial, times, points);
    let mut measured = measure(program, points, None);
    silence(trial.graph, program, course.leaves, points, &mut measured);
    let left = match apply(trial, &measured, &describer).conclude() {
        Ok(left) => left,
        Err(verdict) => return unless_met_elsewhere(&met, *verdict),
    };
    let setting = || describer.setting(left.clone());

    let mut verdicts = Vec::new();
    let mut held = Vec::new();
    for (position, ((how, _), group)) in program.groups.iter().zip(&measured.groups).enumerate() {
        match how {
            // Formula by formula: where one has no value, the others still count.
            Use::Always | Use::Defined => held.push(weigh(setting(), group)),
            Use::Never(_) | Use::Eventually(_) => {
                let between = || at_events.is_none().then(|| Between::look(trial, &measured, position));
                verdicts.push(occurrence(trial, &setting(), group, how, &between));
            }
            Use::Limit(point) => verdicts.push(limit(trial, position, point)),
        }
    }
    if !held.is_empty() {
        let verdict = all_of(held);
        verdicts.push(match zeros {
            Some(zeros) => only_at_events(trial, zeros, verdict),
            None => {
                let verdict = at_peaks(trial, &measured, look_closer(trial, &measured, verdict));
                between_samples(trial, &measured, verdict)
            }
        });
    }
    unless_met_elsewhere(&met, all_of(verdicts))
}

/// The verdict of a claim whose assumptions may be met at other times than those at which it was tried.
fn unless_met_elsewhere(met: &met::Search, verdict: Verdict) -> Verdict {
    let reason = match verdict.outcome() {
        Outcome::Holds(_) => met.open.clone(),
        Outcome::NotApplicable => met.open.clone().or(met.touches.clone()),
        Outcome::Fails(_) | Outcome::Undecided => None,
    };
    match reason {
        Some(_) => Verdict::new(Outcome::Undecided, Evidence { reason, ..verdict.evidence().clone() }),
        None => verdict,
    }
}

/// Points between neighbouring samples at which a claim that holds is tried again, on each side of its worst sample.
const CLOSER: usize = 4;

/// Tries a claim that holds at further times around its worst sample: the worst of all times lies between samples.
fn look_closer(trial: &Trial, along: &Measurements, verdict: Verdict) -> Verdict {
    let Trial { course, .. } = *trial;
    let (Outcome::Holds(_), Some(worst)) = (verdict.outcome(), &verdict.evidence().residual) else { return verdict };
    let Some(at) = course.times.iter().position(|&t| t == worst.at) else { return verdict };
    let near = course.near(at);
    let points = course.points_at(trial.program, &near);
    let Some(closer) = at_further_times(trial, along, &near, &points) else { return verdict };
    match (closer.outcome(), &closer.evidence().residual) {
        (Outcome::Fails(_), _) => closer,
        (Outcome::Holds(_), Some(r)) if r.max * worst.bound > worst.max * r.bound => {
            let samples = verdict.evidence().samples + closer.evidence().samples;
            let residual = Some(r.clone());
            Verdict::new(verdict.outcome(), Evidence { samples, residual, ..verdict.evidence().clone() })
        }
        _ => verdict,
    }
}

/// The verdict of what a claim says of all times, at further times; `None` where its assumptions leave none of them.
fn at_further_times(trial: &Trial, along: &Measurements, times: &[f64], points: &Arc<Points>) -> Option<Verdict> {
    let program = trial.program;
    let describer = Describer::new(trial, times, points);
    let measured = measure(program, points, Some(along));
    let left = apply(trial, &measured, &describer).conclude().ok()?;
    let held = program.groups.iter().zip(&measured.groups);
    let held = held.filter(|((how, _), _)| matches!(how, Use::Always | Use::Defined));
    Some(all_of(held.map(|(_, group)| weigh(describer.setting(left.clone()), group)).collect()))
}

/// Tries a claim that holds at further times, where exponentials in it may have peaks between the samples.
fn at_peaks(trial: &Trial, along: &Measurements, verdict: Verdict) -> Verdict {
    let Trial { program, course, .. } = *trial;
    let holds = match verdict.outcome() {
        Outcome::Holds(_) => true,
        Outcome::Undecided => false,
        Outcome::Fails(_) | Outcome::NotApplicable => return verdict,
    };
    let Some(times) = steep::times(trial) else {
        if !holds {
            return verdict;
        }
        let reason = Some("an exponential in it has too many peaks that samples may miss".to_owned());
        return Verdict::new(Outcome::Undecided, Evidence { reason, ..verdict.evidence().clone() });
    };
    if times.is_empty() {
        return verdict;
    }
    let points = course.points_at(program, &times);
    let Some(closer) = at_further_times(trial, along, &times, &points) else { return verdict };
    match closer.outcome() {
        Outcome::Fails(_) => closer,
        Outcome::Undecided if holds => closer,
        Outcome::Holds(_) if holds => {
            let samples = verdict.evidence().samples + closer.evidence().samples;
            Verdict::new(verdict.outcome(), Evidence { samples, ..verdict.evidence().clone() })
        }
        _ => verdict,
    }
}

/// The verdict of a claim all of whose parts must hold: failing, undecided, not applicable, holding, in this order.
pub(super) fn all_of(verdicts: Vec<Verdict>) -> Verdict {
    let rank = |v: &Verdict| match v.outcome() {
        Outcome::Fails(_) => 3,
        Outcome::Undecided => 2,
        Outcome::NotApplicable => 1,
        Outcome::Holds(_) => 0,
    };
    // Among equals the part with the largest residual in units of its bound.
    let ratio =
        |v: &Verdict| v.evidence().residual.as_ref().map_or(0.0, |r| if r.max > 0.0 { r.max / r.bound } else { 0.0 });
    let worst = verdicts.into_iter().reduce(|a, b| if (rank(&b), ratio(&b)) > (rank(&a), ratio(&a)) { b } else { a });
    worst.unwrap_or_else(|| {
        let reason = Some("the claim says nothing that could be tried".to_owned());
        Verdict::new(Outcome::Undecided, Evidence { reason, ..Evidence::default() })
    })
}

/// Why a search for events is incomplete, in words.
pub(super) fn incomplete(problem: &Incomplete) -> String {
    match problem {
        Incomplete::NoValue { start, end, reason } => {
            format!("on [{}, {}] there is no value ({reason})", short(*start), short(*end))
        }
        Incomplete::Vanishing { start, end } => {
            format!("on [{}, {}] it stays within its error of 0", short(*start), short(*end))
        }
        Incomplete::Unresolved { start, end } => format!("[{}, {}] could not be resolved", short(*start), short(*end)),
    }
}

/// The points that the assumptions of a claim leave of a course; a verdict when they leave none.
pub(super) fn assumptions_of(trial: &Trial) -> Result<Vec<Left>, Box<Verdict>> {
    let Trial { program, course, .. } = *trial;
    if program.assumptions.is_empty() {
        return Ok(vec![Left::In; course.times.len()]);
    }
    let describer = Describer::new(trial, &course.times, &course.points);
    apply(trial, &measure(program, &course.points, None), &describer).conclude()
}

/// The verdict where the event of a claim is not found.
fn no_event(trial: &Trial, zeros: Option<&Zeros>) -> Verdict {
    let course = trial.course;
    if let Some(reason) = zeros.and_then(|z| open_events(trial, z, |_| true)) {
        return Verdict::new(Outcome::Undecided, Evidence { reason: Some(reason), ..Evidence::default() });
    }
    let text = trial.claim.at.as_ref().map_or("", |w| w.text.as_str());
    let (from, to) = course.stage.span(course.trajectory);
    not_applicable(format!("`{text}` does not happen between t = {from} and t = {to}"))
}

/// Why there may be more events than those that were found; of gaps in the search those count that `counts` says.
fn open_events(trial: &Trial, zeros: &Zeros, counts: impl Fn(&Incomplete) -> bool) -> Option<String> {
    let text = trial.claim.at.as_ref().map_or("", |w| w.text.as_str());
    if let Some(&t) = zeros.touching.first() {
        return Some(format!(
            "the sides of `{text}` touch near t = {} without crossing: whether they meet there cannot be told",
            short(t)
        ));
    }
    let open = zeros.incomplete.iter().find(|i| counts(i));
    open.map(|problem| format!("the search for `{text}` is incomplete: {}", incomplete(problem)))
}

/// The verdict of a claim that was tried at events: where some may be missing, it cannot hold.
fn only_at_events(trial: &Trial, zeros: &Zeros, verdict: Verdict) -> Verdict {
    // Where the sides have no value, they do not meet.
    let counts = |i: &Incomplete| !matches!(i, Incomplete::NoValue { reason: NoValue::OutOfDomain, .. });
    match (verdict.outcome(), open_events(trial, zeros, counts)) {
        (Outcome::Holds(_) | Outcome::NotApplicable, Some(reason)) => {
            let reason = Some(format!("it was tried at {} events, but {reason}", zeros.times.len()));
            Verdict::new(Outcome::Undecided, Evidence { reason, ..verdict.evidence().clone() })
        }
        _ => verdict,
    }
}

/// The verdict of a claim that holds, where the formulas of the motion are not known from samples: it stays open, and times
/// without a value are named.
pub(super) fn unless_unresolved(trial: &Trial, verdict: Verdict) -> Verdict {
    let Trial { graph, claim, program, course, .. } = *trial;
    let gaps = course.motion.unresolved();
    let (from, to) = course.stage.span(course.trajectory);
    let inside = |gap: &&Incomplete| gap.stretch().0 <= to && gap.stretch().1 >= from;
    let Outcome::Holds(_) = verdict.outcome() else { return verdict };
    if !gaps.iter().any(|gap| inside(&gap)) {
        return verdict;
    }
    // What was found at one time remains found.
    let found = |how: &Use| matches!(how, Use::Eventually(_) | Use::Limit(_));
    let other = claim.forms.iter().any(|f| matches!(f, Form::SameMotion { .. } | Form::Independent { .. }));
    if !other && program.groups.iter().all(|(how, _)| found(how)) {
        return verdict;
    }
    let moves =
        |l: &Leaf| l.instant.is_none() && matches!(claim.scope.role(l.symbol), Some(Role::State | Role::Observable));
    let defined = |(how, group): &(Use, Group)| {
        matches!(how, Use::Defined) && graph.leaves(group.comparisons.iter().map(|c| c.left)).iter().any(moves)
    };
    let open = |gap: &&Incomplete| match gap {
        Incomplete::NoValue { .. } => program.groups.iter().any(defined),
        _ => true,
    };
    let mut evidence = verdict.evidence().clone();
    if let Some(gap) = gaps.iter().filter(inside).find(open) {
        let (start, end) = gap.stretch();
        let near = match short(start) == short(end) {
            true => format!("near t = {}", short(start)),
            false => format!("between t = {} and t = {}", short(start), short(end)),
        };
        evidence.reason = Some(match gap {
            Incomplete::NoValue { reason, .. } => format!("{near} the formulas of the motion have no value ({reason})"),
            _ => format!(
                "{near} the formulas of the motion do more than samples can show; a part of the span by itself may decide"
            ),
        });
        return Verdict::new(Outcome::Undecided, evidence);
    }
    for gap in gaps.iter().filter(inside) {
        let (start, end) = (gap.stretch().0.max(from), gap.stretch().1.min(to));
        if !evidence.excluded.iter().any(|e| e.from <= end && start <= e.to) {
            let reason = "the formulas of the motion have no value there".to_owned();
            evidence.excluded.push(Exclusion { from: start, to: end, reason });
        }
    }
    evidence.excluded.sort_by(|a, b| a.from.total_cmp(&b.from));
    Verdict::new(verdict.outcome(), evidence)
}

pub(super) fn not_applicable(reason: String) -> Verdict {
    Verdict::new(Outcome::NotApplicable, Evidence { reason: Some(reason), ..Evidence::default() })
}

/// What the assumptions of a claim say about a list of times.
pub(super) struct Applied {
    /// Which times are left.
    pub left: Vec<Left>,
    /// An equation among them that is not met.
    pub unmet: Option<String>,
    /// An equation among them that cannot be decided at too many times.
    unclear: Option<String>,
}

impl Applied {
    /// The times that are left; a verdict when none is, or when an equation among the assumptions is not met.
    fn conclude(self) -> Result<Vec<Left>, Box<Verdict>> {
        if let Some(reason) = self.unmet {
            return Err(Box::new(not_applicable(reason)));
        }
        if let Some(reason) = self.unclear {
            let evidence = Evidence { reason: Some(reason), ..Evidence::default() };
            return Err(Box::new(Verdict::new(Outcome::Undecided, evidence)));
        }
        if self.left.iter().all(|l| *l != Left::In) {
            let reason = self.left.into_iter().find_map(|l| match l {
                Left::Out(reason) => Some(reason.to_string()),
                Left::In => None,
            });
            let reason = reason.unwrap_or_else(|| "there is no time to try it at".to_owned());
            return Err(Box::new(not_applicable(reason)));
        }
        Ok(self.left)
    }
}

/// Which times the assumptions leave.
pub(super) fn apply(trial: &Trial, measured: &Measurements, describer: &Describer) -> Applied {
    let count = describer.times.len();
    let mut applied = Applied { left: vec![Left::In; count], unmet: None, unclear: None };
    for (assumption, group) in trial.program.assumptions.iter().zip(&measured.assumptions) {
        let judged = Judged::new(group, trial.claim.precision);
        let mut unclear = None;
        let mut unclear_count = 0;
        let not_met: Arc<str> = format!("the assumption `{}` is not met", assumption.text).into();
        let undecided: Arc<str> = format!("the assumption `{}` cannot be decided", assumption.text).into();
        for (i, left) in applied.left.iter_mut().enumerate() {
            let Some(standing) = judged.best(i) else { continue };
            if standing == Standing::Satisfied {
                continue;
            }
            let c = judged.deciding(0, i);
            let comparison = &assumption.group.comparisons[c];
            let sides = |what: &str| match group.signs[0][c].get(i) {
                Ok(m) => format!(
                    "the assumption `{}` {what}: at t = {} its sides are {} and {} (error bound {:.1e})",
                    assumption.text,
                    short(describer.times[i]),
                    short(m.left),
                    short(m.right),
                    m.difference.error
                ),
                Err(_) => format!("the assumption `{}` {what}", assumption.text),
            };
            match standing {
                Standing::Satisfied => {}
                Standing::NoValue(reason) => {
                    if *left == Left::In {
                        *left = Left::Out(describer.fault(comparison, i, reason));
                    }
                }
                Standing::Violated if assumption.throughout => {
                    applied.unmet = Some(sides("is not met"));
                    return applied;
                }
                Standing::Inconclusive if assumption.throughout => {
                    unclear.get_or_insert_with(|| sides("cannot be decided"));
                    unclear_count += 1;
                    if *left == Left::In {
                        *left = Left::Out(Arc::clone(&undecided));
                    }
                }
                Standing::Violated | Standing::Inconclusive => {
                    if *left == Left::In {
                        *left = Left::Out(Arc::clone(&not_met));
                    }
                }
            }
        }
        if unclear_count as f64 > TOLERATED_INCONCLUSIVE * count as f64 {
            applied.unclear = unclear;
            return applied;
        }
    }
    applied
}
