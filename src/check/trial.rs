//! One claim on one motion.
//!
//! **In:** a compiled claim, and a [`Course`]: the points of a motion. **Out:** a verdict. The same few steps for every
//! form of claim: measure, see which points the assumptions leave, weigh.

use super::comparison::{Comparison, Group, Standing};
use super::describe::{Describer, short};
use super::limit::limit;
use super::occurrence::{eventually, never};
use super::program::{Program, Use};
use super::stage::Stage;
use super::verdict::{Evidence, Outcome, Verdict};
use super::weigh::{Judged, Left, MeasuredGroup, Series, Setting, TOLERATED_INCONCLUSIVE, weigh};
use crate::derivation::Claim;
use crate::expr::{Graph, Leaf};
use crate::flow::{Incomplete, Motion, Zeros};
use crate::number::{Bounded, NoValue};
use crate::tape::{Slots, Tape};

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
    pub points: Vec<Values>,
}

impl Course<'_> {
    /// The values of all leaves at another time.
    pub fn values(&self, t: f64) -> Values {
        self.stage.values(self.trajectory, t)
    }

    /// The values of all leaves at an event, whose time is known up to `slack`: how far they move meanwhile is part of
    /// their error.
    pub fn values_at_event(&self, t: f64, slack: f64) -> Values {
        let (before, after) = (self.values(t - slack), self.values(t + slack));
        let widened = |((here, a), b): ((Result<Bounded, NoValue>, _), _)| {
            let here = here?;
            let moved = |x: Result<Bounded, NoValue>| x.map_or(0.0, |x| (x.value - here.value).abs());
            // Over so short a time everything moves linearly; twice the change covers what is not.
            Ok(Bounded { value: here.value, error: here.error + 2.0 * moved(a).max(moved(b)) })
        };
        self.values(t).into_iter().zip(before).zip(after).map(widened).collect()
    }
}

/// How well the time of an event is known: the error of the expression that vanishes there, over its speed.
pub(super) fn slack(tape: &Tape, output: usize, course: &Course, t: f64, slots: &mut Slots<Bounded>) -> f64 {
    let (from, to) = course.stage.span(course.trajectory);
    let step = 1e-6 * (to - from);
    let floor = 4.0 * f64::EPSILON * t.abs().max(f64::MIN_POSITIVE);
    let mut value = |t: f64| -> Option<Bounded> {
        for (i, v) in course.values(t).into_iter().enumerate() {
            slots.set(i, v);
        }
        tape.run(&(), slots);
        tape.output(output, slots).ok().copied()
    };
    match (value(t), value((t - step).max(from)), value((t + step).min(to))) {
        (Some(here), Some(before), Some(after)) => {
            let speed = (after.value - before.value).abs() / ((t + step).min(to) - (t - step).max(from));
            if speed > 0.0 { (here.value.abs() + here.error) / speed + floor } else { floor }
        }
        _ => floor,
    }
}

/// Events that a claim asks for on a motion: times at which `at` holds, and zeros for `never` and `eventually`.
#[derive(Clone, Debug, Default)]
pub(super) struct Events {
    /// Zeros of the event expression of the claim.
    pub at: Option<Zeros>,
    /// Zeros of what must vanish, for each `never` and `eventually` group, by its position.
    pub occurrences: Vec<(usize, Zeros)>,
}

/// Everything measured for one claim at a list of times.
pub(super) struct Measurements {
    /// Those of the assumptions: `[group][sign][comparison][time]`.
    pub assumptions: Vec<Vec<Vec<Series>>>,
    /// Those of the claim, likewise.
    pub groups: Vec<Vec<Vec<Series>>>,
}

/// Measures all groups of a program at the given points: `[group][sign][comparison][time]`.
pub(super) fn measure(program: &Program, points: &[Values]) -> Measurements {
    let signs: &[f64] = if program.is_branching() { &[1.0, -1.0] } else { &[1.0] };
    let mut slots: Option<Slots<Bounded>> = None;
    let by_sign: Vec<Vec<Vec<_>>> =
        signs.iter().map(|&sign| points.iter().map(|p| program.measure(p, sign, &mut slots)).collect()).collect();
    let mut next = 0;
    let mut gather = |group: &Group| -> Vec<Vec<Series>> {
        let first = next;
        next += group.comparisons.len();
        let used = if group.branching { by_sign.len() } else { 1 };
        let series = |s: usize, c: usize| by_sign[s].iter().map(|point: &Vec<_>| point[first + c]).collect();
        (0..used).map(|s| (0..group.comparisons.len()).map(|c| series(s, c)).collect()).collect()
    };
    let assumptions = program.assumptions.iter().map(|a| gather(&a.group)).collect();
    let groups = program.groups.iter().map(|(_, g)| gather(g)).collect();
    Measurements { assumptions, groups }
}

/// Tries a claim on a motion.
pub(super) fn try_claim(graph: &Graph, claim: &Claim, program: &Program, course: &Course, events: &Events) -> Verdict {
    let at_events: Option<(Vec<f64>, Vec<Values>)> = match (&program.at, &events.at) {
        (None, _) => None,
        (Some(_), Some(zeros)) if !zeros.times.is_empty() => {
            let at = |&t: &f64| course.values_at_event(t, program.event_slack(course, t));
            Some((zeros.times.clone(), zeros.times.iter().map(at).collect()))
        }
        (Some(_), zeros) => return no_event(claim, course, zeros.as_ref()),
    };
    let (times, points) = match &at_events {
        Some((t, p)) => (t.as_slice(), p.as_slice()),
        None => (course.times.as_slice(), course.points.as_slice()),
    };
    // An equation among the assumptions that fails at the first point settles it.
    if program.assumptions.iter().any(|a| a.throughout) {
        let (first, point) = (&times[..1], &points[..1]);
        let describer = Describer::new(graph, program, course, first, point);
        if let Err(verdict) = apply_assumptions(claim, program, &measure(program, point), &describer)
            && verdict.outcome() == Outcome::NotApplicable
            && verdict.evidence().excluded.is_empty()
            && program.assumptions.iter().all(|a| a.throughout)
        {
            return *verdict;
        }
    }
    let describer = Describer::new(graph, program, course, times, points);
    let measured = measure(program, points);

    let left = match apply_assumptions(claim, program, &measured, &describer) {
        Ok(left) => left,
        Err(verdict) => return *verdict,
    };
    let values = |c: &Comparison, i: usize| describer.values(c, i);
    let fault = |c: &Comparison, i: usize, reason: NoValue| describer.fault(c, i, reason);
    let setting = || Setting {
        times,
        left: left.clone(),
        precision: claim.precision,
        one_sign_throughout: claim.branches_throughout,
        values: &values,
        fault: &fault,
    };

    let mut verdicts = Vec::new();
    let mut weighed = Vec::new();
    for (position, ((how, group), signs)) in program.groups.iter().zip(measured.groups).enumerate() {
        let group = MeasuredGroup { group, signs, definedness: matches!(how, Use::Defined) };
        match how {
            Use::Always | Use::Defined => weighed.push(group),
            Use::Never(vanishing) => {
                let zeros = vanishing.and_then(|_| find(&events.occurrences, position));
                verdicts.push(never(claim, &setting(), &group, course, &describer, zeros));
            }
            Use::Eventually(vanishing) => {
                let zeros = vanishing.and_then(|_| find(&events.occurrences, position));
                verdicts.push(eventually(claim, &setting(), &group, course, zeros));
            }
            Use::Limit(point) => verdicts.push(limit(graph, claim, program, position, course, point)),
        }
    }
    if !weighed.is_empty() {
        // Formula by formula: where one has no value, the others still count.
        let verdict = all_of(weighed.iter().map(|group| weigh(setting(), std::slice::from_ref(group))).collect());
        verdicts.push(match at_events {
            Some(_) => verdict,
            None => look_closer(graph, claim, program, course, verdict),
        });
    }
    all_of(verdicts)
}

/// Points between neighbouring samples at which a claim that holds is tried again, on each side of its worst sample.
const CLOSER: usize = 4;

/// Tries a claim that holds at further times around its worst sample: the worst of all times lies between samples.
fn look_closer(graph: &Graph, claim: &Claim, program: &Program, course: &Course, verdict: Verdict) -> Verdict {
    let (Outcome::Holds(_), Some(worst)) = (verdict.outcome(), &verdict.evidence().residual) else { return verdict };
    let Some(at) = course.times.iter().position(|&t| t == worst.at) else { return verdict };
    let neighbours = [at.checked_sub(1), Some(at + 1)].into_iter().flatten().filter_map(|i| course.times.get(i));
    let between = |&other: &f64| {
        let worst = worst.at;
        (1..=CLOSER).map(move |k| worst + (other - worst) * k as f64 / (CLOSER + 1) as f64)
    };
    let mut times: Vec<f64> = neighbours.flat_map(between).collect();
    times.sort_by(f64::total_cmp);
    let points: Vec<Values> = times.iter().map(|&t| course.values(t)).collect();
    let describer = Describer::new(graph, program, course, &times, &points);
    let measured = measure(program, &points);
    let Ok(left) = apply_assumptions(claim, program, &measured, &describer) else { return verdict };
    let values = |c: &Comparison, i: usize| describer.values(c, i);
    let fault = |c: &Comparison, i: usize, reason: NoValue| describer.fault(c, i, reason);
    let setting = || Setting {
        times: &times,
        left: left.clone(),
        precision: claim.precision,
        one_sign_throughout: claim.branches_throughout,
        values: &values,
        fault: &fault,
    };
    let held =
        program.groups.iter().zip(measured.groups).filter(|((how, _), _)| matches!(how, Use::Always | Use::Defined));
    let weigh_one = |((how, group), signs): (&(Use, Group), Vec<Vec<Series>>)| {
        let group = MeasuredGroup { group, signs, definedness: matches!(how, Use::Defined) };
        weigh(setting(), &[group])
    };
    let closer = all_of(held.map(weigh_one).collect());
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

fn find(occurrences: &[(usize, Zeros)], position: usize) -> Option<&Zeros> {
    occurrences.iter().find(|(p, _)| *p == position).map(|(_, z)| z)
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
pub(super) fn assumptions_of(
    graph: &Graph,
    claim: &Claim,
    program: &Program,
    course: &Course,
) -> Result<Vec<Left>, Box<Verdict>> {
    if program.assumptions.is_empty() {
        return Ok(vec![Left::In; course.times.len()]);
    }
    let describer = Describer::new(graph, program, course, &course.times, &course.points);
    apply_assumptions(claim, program, &measure(program, &course.points), &describer)
}

/// Weighs groups that were measured at the points of a course.
pub(super) fn settle(
    graph: &Graph,
    claim: &Claim,
    program: &Program,
    course: &Course,
    left: Vec<Left>,
    groups: &[MeasuredGroup],
) -> Verdict {
    let describer = Describer::new(graph, program, course, &course.times, &course.points);
    let setting = Setting {
        times: &course.times,
        left,
        precision: claim.precision,
        one_sign_throughout: claim.branches_throughout,
        values: &|c: &Comparison, i: usize| describer.values(c, i),
        fault: &|c: &Comparison, i: usize, reason: NoValue| describer.fault(c, i, reason),
    };
    weigh(setting, groups)
}

/// The verdict where the event of a claim is not found.
fn no_event(claim: &Claim, course: &Course, zeros: Option<&Zeros>) -> Verdict {
    let text = claim.at.as_ref().map_or("", |w| w.text.as_str());
    let (from, to) = course.stage.span(course.trajectory);
    let mut evidence = Evidence::default();
    if let Some(&t) = zeros.and_then(|z| z.touching.first()) {
        evidence.reason = Some(format!(
            "the sides of `{text}` touch near t = {} without crossing: whether they meet there cannot be told",
            short(t)
        ));
        return Verdict::new(Outcome::Undecided, evidence);
    }
    match zeros.and_then(|z| z.incomplete.as_ref()) {
        Some(problem) => {
            evidence.reason = Some(format!("the search for `{text}` is incomplete: {}", incomplete(problem)));
            Verdict::new(Outcome::Undecided, evidence)
        }
        None => {
            evidence.reason = Some(format!("`{text}` does not happen between t = {from} and t = {to}"));
            Verdict::new(Outcome::NotApplicable, evidence)
        }
    }
}

/// Which points the assumptions leave; a verdict when they leave none, or when an equation among them is not met.
fn apply_assumptions(
    claim: &Claim,
    program: &Program,
    measured: &Measurements,
    describer: &Describer,
) -> Result<Vec<Left>, Box<Verdict>> {
    let count = describer.times.len();
    let mut left = vec![Left::In; count];
    let conclude = |outcome, reason: String| {
        Err(Box::new(Verdict::new(outcome, Evidence { reason: Some(reason), ..Evidence::default() })))
    };
    for (assumption, signs) in program.assumptions.iter().zip(&measured.assumptions) {
        let group = MeasuredGroup { group: &assumption.group, signs: signs.clone(), definedness: false };
        let judged = Judged::new(&group, claim.precision);
        let mut unclear = None;
        let mut unclear_count = 0;
        for (i, left) in left.iter_mut().enumerate() {
            let Some(standing) = judged.best(i) else { continue };
            if standing == Standing::Satisfied {
                continue;
            }
            let c = judged.deciding(0, i);
            let comparison = &assumption.group.comparisons[c];
            let sides = |what: &str| match &group.signs[0][c][i] {
                Ok(m) => format!(
                    "the assumption `{}` {what}: at t = {} its sides are {} and {} (error bound {:.1e})",
                    assumption.text,
                    short(describer.times[i]),
                    short(m.left.value),
                    short(m.right.value),
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
                    return conclude(Outcome::NotApplicable, sides("is not met"));
                }
                Standing::Inconclusive if assumption.throughout => {
                    unclear.get_or_insert_with(|| sides("cannot be decided"));
                    unclear_count += 1;
                    if *left == Left::In {
                        *left = Left::Out(format!("the assumption `{}` cannot be decided", assumption.text));
                    }
                }
                Standing::Violated | Standing::Inconclusive => {
                    if *left == Left::In {
                        *left = Left::Out(format!("the assumption `{}` is not met", assumption.text));
                    }
                }
            }
        }
        if let Some(reason) = unclear
            && unclear_count as f64 > TOLERATED_INCONCLUSIVE * count as f64
        {
            return conclude(Outcome::Undecided, reason);
        }
    }
    if left.iter().all(|l| *l != Left::In) {
        let reason = left.iter().find_map(|l| match l {
            Left::Out(reason) => Some(reason.clone()),
            Left::In => None,
        });
        return conclude(Outcome::NotApplicable, reason.unwrap_or_else(|| "there is no time to try it at".to_owned()));
    }
    Ok(left)
}
