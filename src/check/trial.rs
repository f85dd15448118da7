//! One claim on one motion.
//!
//! **In:** a compiled claim, and a [`Course`]: the points of a motion. **Out:** a verdict. The same few steps for every
//! form of claim: measure, see which points the assumptions leave, weigh.

use std::cell::RefCell;

use super::comparison::{Comparison, Group, Standing};
use super::program::{Program, Use};
use super::stage::Stage;
use super::verdict::{Evidence, Outcome, Residual, Strength, Verdict};
use super::weigh::{Judged, Left, MeasuredGroup, Series, Setting, TOLERATED_INCONCLUSIVE, weigh, witness};
use crate::derivation::Claim;
use crate::expr::{Graph, Leaf};
use crate::flow::{Incomplete, Motion, Zeros};
use crate::latex::{LimitPoint, RelationKind};
use crate::number::{Bounded, NoValue};
use crate::tape::{Fault, Slots, Tape};

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
struct Measurements {
    assumptions: Vec<Vec<Vec<Series>>>,
    groups: Vec<Vec<Vec<Series>>>,
}

/// Measures all groups of a program at the given points: `[group][sign][comparison][time]`.
fn measure(program: &Program, points: &[Values]) -> Measurements {
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

/// Describes points in words and numbers, for witnesses and reasons.
struct Describer<'a> {
    graph: &'a Graph,
    program: &'a Program,
    leaves: &'a [Leaf],
    times: &'a [f64],
    points: &'a [Values],
    slots: RefCell<Option<Slots<Bounded>>>,
}

/// A number with as many digits as a reader wants.
fn short(x: f64) -> String {
    if x == 0.0 || (1e-3..1e5).contains(&x.abs()) { format!("{x:.6}") } else { format!("{x:.4e}") }
}

impl<'a> Describer<'a> {
    fn new(
        graph: &'a Graph,
        program: &'a Program,
        course: &'a Course,
        times: &'a [f64],
        points: &'a [Values],
    ) -> Describer<'a> {
        Describer { graph, program, leaves: course.leaves, times, points, slots: RefCell::new(None) }
    }

    /// Values of the leaves that both sides depend on.
    fn values(&self, comparison: &Comparison, time: usize) -> Vec<(String, f64)> {
        let wanted = self.graph.leaves([comparison.left, comparison.right]);
        let value = |leaf: Leaf| {
            let at = self.leaves.iter().position(|&l| l == leaf)?;
            let v = self.points[time][at].ok()?;
            Some((self.graph.leaf_latex(leaf), v.value))
        };
        wanted.into_iter().filter_map(value).collect()
    }

    /// Why a comparison has no value.
    fn fault(&self, comparison: &Comparison, time: usize, reason: NoValue) -> String {
        let Some(tape) = self.program.tape() else { return reason.to_string() };
        let mut slots = self.slots.borrow_mut();
        self.program.measure(&self.points[time], 1.0, &mut slots);
        let Some(slots) = slots.as_ref() else { return reason.to_string() };
        let position = self.program.position(comparison);
        let fault = position.and_then(|k| (0..2).find_map(|side| tape.fault(4 * k + side, slots)));
        match fault {
            Some(Fault::Input(i)) => match self.program.input(i).and_then(|at| self.leaves.get(at)) {
                Some(&leaf) => format!("{} has no value ({reason})", self.graph.leaf_latex(leaf)),
                None => reason.to_string(),
            },
            Some(Fault::Instruction(step)) => {
                let a = slots.value(step.a as usize).value;
                let b = slots.value(step.b as usize).value;
                match step.op.arity() {
                    1 => format!("`{}` has no value at {} ({reason})", step.op.spelling(), short(a)),
                    _ => format!("`{}` has no value at ({}, {}) ({reason})", step.op.spelling(), short(a), short(b)),
                }
            }
            Some(Fault::Constant) | None => reason.to_string(),
        }
    }
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
        let verdict = weigh(setting(), &weighed);
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
    let setting = Setting {
        times: &times,
        left,
        precision: claim.precision,
        one_sign_throughout: claim.branches_throughout,
        values: &values,
        fault: &fault,
    };
    let held =
        program.groups.iter().zip(measured.groups).filter(|((how, _), _)| matches!(how, Use::Always | Use::Defined));
    let groups: Vec<MeasuredGroup> = held
        .map(|((how, group), signs)| MeasuredGroup { group, signs, definedness: matches!(how, Use::Defined) })
        .collect();
    let closer = weigh(setting, &groups);
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

/// The verdict of a claim all of whose parts must hold: not applicable, failing, undecided, holding, in this order.
pub(super) fn all_of(verdicts: Vec<Verdict>) -> Verdict {
    let rank = |v: &Verdict| match v.outcome() {
        Outcome::NotApplicable => 3,
        Outcome::Fails(_) => 2,
        Outcome::Undecided => 1,
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
        for i in 0..count {
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
                    if left[i] == Left::In {
                        left[i] = Left::Out(describer.fault(comparison, i, reason));
                    }
                }
                Standing::Violated if assumption.throughout => {
                    return conclude(Outcome::NotApplicable, sides("is not met"));
                }
                Standing::Inconclusive if assumption.throughout => {
                    unclear.get_or_insert_with(|| sides("cannot be decided"));
                    unclear_count += 1;
                    if left[i] == Left::In {
                        left[i] = Left::Out(format!("the assumption `{}` cannot be decided", assumption.text));
                    }
                }
                Standing::Violated | Standing::Inconclusive => {
                    if left[i] == Left::In {
                        left[i] = Left::Out(format!("the assumption `{}` is not met", assumption.text));
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

/// The times that count at which a group holds, with the sign that makes it hold.
fn holding(setting: &Setting, judged: &Judged) -> Option<(usize, usize)> {
    let standing = &judged.whole;
    (0..setting.times.len())
        .filter(|&i| setting.left[i] == Left::In)
        .find_map(|i| (0..standing.len()).find(|&s| standing[s][i] == Standing::Satisfied).map(|s| (i, s)))
}

/// A claim that a relation holds at no time: samples can refute it, and never establish it.
fn never(
    claim: &Claim,
    setting: &Setting,
    group: &MeasuredGroup,
    course: &Course,
    describer: &Describer,
    zeros: Option<&Zeros>,
) -> Verdict {
    let counted = setting.left.iter().filter(|l| **l == Left::In).count();
    let mut evidence = Evidence { samples: counted, ..Evidence::default() };
    let judged = Judged::new(group, claim.precision);
    if let Some((i, s)) = holding(setting, &judged) {
        let c = judged.deciding(s, i);
        if let Ok(m) = &group.signs[s][c][i] {
            evidence.witness = Some(witness(setting, &group.group.comparisons[c], i, m));
            return Verdict::new(Outcome::Fails(Strength::Sampled), evidence);
        }
    }
    if let Some(&t) = zeros.and_then(|z| z.times.first()) {
        let points = [course.values(t)];
        let at_zero = Describer { times: &[t], points: &points, slots: RefCell::new(None), ..*describer };
        let measured = measure(describer.program, &points);
        let same =
            describer.program.groups.iter().zip(&measured.groups).find(|((_, g), _)| std::ptr::eq(g, group.group));
        if let Some((comparison, Ok(m))) =
            same.and_then(|(_, signs)| Some((group.group.comparisons.first()?, signs.first()?.first()?.first()?)))
        {
            let only = Setting {
                times: &[t],
                left: vec![Left::In],
                values: &|c: &Comparison, i: usize| at_zero.values(c, i),
                ..*setting
            };
            evidence.witness = Some(witness(&only, comparison, 0, m));
            return Verdict::new(Outcome::Fails(Strength::Sampled), evidence);
        }
    }
    // The closest approach, for the reader.
    let mut closest: Option<Residual> = None;
    for c in group.signs.iter().flatten() {
        for (i, m) in c.iter().enumerate() {
            if let (Ok(m), Left::In) = (m, &setting.left[i]) {
                let size = m.difference.value.abs();
                if closest.as_ref().is_none_or(|r| size < r.max) {
                    closest = Some(Residual { max: size, bound: m.difference.error, at: setting.times[i] });
                }
            }
        }
    }
    let approach = closest
        .as_ref()
        .map_or(String::new(), |r| format!("; the sides come closest, to {:.3e}, at t = {}", r.max, short(r.at)));
    evidence.residual = closest;
    evidence.reason = Some(format!(
        "not seen at {counted} samples, nor as a sign change between them{approach}; samples cannot show that something \
         never happens, an enclosure would"
    ));
    Verdict::new(Outcome::Undecided, evidence)
}

/// A claim that a relation holds at some time: samples and zeros can establish it, and never refute it.
fn eventually(
    claim: &Claim,
    setting: &Setting,
    group: &MeasuredGroup,
    course: &Course,
    zeros: Option<&Zeros>,
) -> Verdict {
    let counted = setting.left.iter().filter(|l| **l == Left::In).count();
    let mut evidence = Evidence { samples: counted, ..Evidence::default() };
    let judged = Judged::new(group, claim.precision);
    if let Some((i, s)) = holding(setting, &judged) {
        let c = judged.deciding(s, i);
        if let Ok(m) = &group.signs[s][c][i] {
            evidence.reason = Some(format!("first seen at the sample t = {}", short(setting.times[i])));
            evidence.residual =
                Some(Residual { max: m.difference.value.abs(), bound: m.difference.error, at: setting.times[i] });
            return Verdict::new(Outcome::Holds(Strength::Sampled), evidence);
        }
    }
    if let Some(&t) = zeros.and_then(|z| z.times.first()) {
        evidence.reason = Some(format!("happens first at t = {t:.12}"));
        return Verdict::new(Outcome::Holds(Strength::Sampled), evidence);
    }
    let (from, to) = course.stage.span(course.trajectory);
    evidence.reason = Some(format!(
        "not seen at {counted} samples between t = {from} and t = {to}; a longer motion may show it, an enclosure could \
         exclude it"
    ));
    Verdict::new(Outcome::Undecided, evidence)
}

/// Steps towards a limit point; the last few must agree with the limit within their bounds.
const APPROACH: usize = 12;

/// A claim about a limit, tried along times that approach the point.
fn limit(
    graph: &Graph,
    claim: &Claim,
    program: &Program,
    position: usize,
    course: &Course,
    point: &LimitPoint,
) -> Verdict {
    let (from, to) = course.stage.span(course.trajectory);
    let undecided =
        |reason: String| Verdict::new(Outcome::Undecided, Evidence { reason: Some(reason), ..Evidence::default() });
    let (target, times): (String, Vec<f64>) = match point {
        LimitPoint::Finite(e) => {
            let Some(t0) = course.stage.constant(graph, course.trajectory, *e) else {
                return undecided("the point of the limit has no value on this motion".to_owned());
            };
            let t0 = t0.value;
            if t0 < from || t0 > to {
                return undecided(format!("t = {} lies outside the span [{from}, {to}]", short(t0)));
            }
            let reach = (t0 - from).max(to - t0);
            let direction = if to - t0 >= t0 - from { 1.0 } else { -1.0 };
            let steps = (0..=3 * APPROACH).map(|k| t0 + direction * reach * (0.1f64).powi(k as i32 / 3 + 1));
            (format!("t → {}", short(t0)), steps.chain([t0]).collect())
        }
        LimitPoint::PlusInfinity | LimitPoint::MinusInfinity => {
            let end = if matches!(point, LimitPoint::PlusInfinity) { to } else { from };
            let start = if matches!(point, LimitPoint::PlusInfinity) { from } else { to };
            let times =
                (0..=3 * APPROACH).map(|k| start + (end - start) * k as f64 / (3.0 * APPROACH as f64)).collect();
            ("t → ±∞".to_owned(), times)
        }
    };
    let points: Vec<Values> = times.iter().map(|&t| course.values(t)).collect();
    let measured = measure(program, &points);
    let (_, group) = &program.groups[position];
    let series: Vec<&Series> = measured.groups[position].iter().flatten().collect();
    let describer = Describer::new(graph, program, course, &times, &points);
    let mut evidence = Evidence::default();
    for (comparison, series) in group.comparisons.iter().zip(series) {
        let valid: Vec<(usize, _)> =
            series.iter().enumerate().filter_map(|(i, m)| Some((i, m.as_ref().ok()?))).collect();
        let Some(&(i, last)) = valid.last() else {
            return undecided(format!("no value near the limit {target}"));
        };
        evidence.samples += valid.len();
        let size = last.difference.value.abs();
        if !matches!(comparison.kind, RelationKind::Equal | RelationKind::NotEqual) {
            return undecided("only `=` and `\\ne` can be tried of a limit".to_owned());
        }
        let claims_equal = comparison.kind == RelationKind::Equal;
        let settled = size <= last.difference.error.max(claim.precision * last.magnitude.max(f64::MIN_POSITIVE));
        let finite = matches!(point, LimitPoint::Finite(_));
        let reached = settled || (finite && vanishes(&valid, &times));
        if (claims_equal && reached) || (!claims_equal && finite && !reached) {
            evidence.residual = Some(Residual { max: size, bound: last.difference.error, at: times[i] });
            continue;
        }
        if (claims_equal && finite) || (!claims_equal && reached) {
            let setting = Setting {
                times: &times,
                left: vec![Left::In; times.len()],
                precision: claim.precision,
                one_sign_throughout: false,
                values: &|c: &Comparison, i: usize| describer.values(c, i),
                fault: &|c: &Comparison, i: usize, r: NoValue| describer.fault(c, i, r),
            };
            evidence.witness = Some(witness(&setting, comparison, i, last));
            evidence.reason = Some(format!("the difference tends to {} as {target}", short(last.difference.value)));
            return Verdict::new(Outcome::Fails(Strength::Sampled), evidence);
        }
        return undecided(format!(
            "{} away from the limit at t = {}; a limit at infinity needs a bound for all later times",
            short(size),
            short(times[i])
        ));
    }
    evidence.reason = Some(format!("followed towards {target}"));
    Verdict::new(Outcome::Holds(Strength::Sampled), evidence)
}

/// Whether differences shrink in proportion to the distance (or faster) as a finite point is approached.
fn vanishes(valid: &[(usize, &super::weigh::Measured)], times: &[f64]) -> bool {
    let Some(&t0) = times.last() else { return false };
    let near: Vec<(f64, f64)> = valid
        .iter()
        .map(|(i, m)| ((times[*i] - t0).abs(), (m.difference.value.abs() - m.difference.error).max(0.0)))
        .filter(|(distance, _)| *distance > 0.0)
        .collect();
    let (Some(first), Some(last)) = (near.first(), near.last()) else { return false };
    // |difference| ≤ C·√distance with the C of the first point: continuous with a margin for square-root behaviour.
    last.0 < 1e-6 * first.0 && last.1 <= 10.0 * first.1 * (last.0 / first.0).sqrt()
}
