//! Between the samples: the times at which an inequality, or a "never", may change.
//!
//! **In:** a group of comparisons, and what the search for zeros found for left − right. **Out:** the group, measured at the
//! zeros and at the peaks of what lies between two of them; and what the search left open.
//!
//! An inequality keeps its truth as long as left − right keeps its sign. So it is enough to look where the sign changes, and
//! once between two changes. Where the sides only touch, or where the search is incomplete, nothing is concluded: a claim
//! that would hold is then `undecided`.

use std::sync::Arc;

use super::comparison::Standing;
use super::describe::{Describer, short};
use super::measured::{Measurements, measure};
use super::program::Use;
use super::trial::{Applied, Trial, all_of, apply, incomplete, not_applicable};
use super::verdict::{Evidence, Outcome, Verdict};
use super::weigh::{Judged, Left, weigh};
use crate::flow::{Incomplete, Points};
use crate::latex::RelationKind;
use crate::number::NoValue;

/// Up to this share of the span a gap in the search is one point for relations that admit equality: what is true on both
/// sides of a point, and continuous, is true at it.
const POINT: f64 = 1e-9;

/// What a time is looked at for.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Role {
    /// left − right changes its sign there; how well the time is known.
    Crossing(f64),
    /// It is farthest from 0 there, between two changes of sign.
    Peak,
    /// It stays within its error of 0 around this time.
    Vanishing(usize),
    /// Whether the time counts at all decides whether a reason stays open.
    Probe(usize),
}

/// One group of a claim, between the samples.
pub(super) struct Between<'a> {
    /// The times, increasing.
    pub times: Vec<f64>,
    /// The values at these times.
    points: Arc<Points>,
    roles: Vec<Role>,
    /// What the search leaves open, in words.
    open: Vec<String>,
    measured: Measurements<'a>,
    position: usize,
}

/// Whether a relation admits equality, for which touching sides make no difference.
pub(super) fn is_weak(kind: RelationKind) -> bool {
    matches!(kind, RelationKind::LessEqual | RelationKind::GreaterEqual)
}

impl<'a> Between<'a> {
    /// Looks for the changes of a group of the program.
    pub fn look(trial: &Trial<'a>, along: &Measurements, position: usize) -> Between<'a> {
        let Trial { program, course, .. } = *trial;
        let (from, to) = course.stage.span(course.trajectory);
        let mut found: Vec<(f64, Role)> = Vec::new();
        let mut open: Vec<String> = Vec::new();
        let (how, group) = &program.groups[position];
        for (kind, e) in how.boundaries(group) {
            let Some(zeros) = course.zeros(e) else {
                open.push("what lies between the samples cannot be searched".to_owned());
                found.extend([from, to].map(|t| (t, Role::Probe(open.len() - 1))));
                continue;
            };
            found.extend(zeros.times.iter().zip(&zeros.slack).map(|(&t, &slack)| (t, Role::Crossing(slack))));
            found.extend(zeros.peaks.iter().map(|&t| (t, Role::Peak)));
            for &t in zeros.touching.iter().filter(|_| !is_weak(kind)) {
                let text = format!("the sides touch near t = {}: whether they meet there cannot be told", short(t));
                open.push(text);
                found.push((t, Role::Probe(open.len() - 1)));
            }
            for gap in &zeros.incomplete {
                let (start, end) = gap.stretch();
                let excused = match gap {
                    // Such times are left out, as among the samples.
                    Incomplete::NoValue { reason: NoValue::OutOfDomain, .. } => true,
                    Incomplete::Vanishing { .. } => is_weak(kind),
                    _ => is_weak(kind) && end - start <= POINT * (to - from),
                };
                if excused {
                    continue;
                }
                open.push(format!("the search between the samples is incomplete: {}", incomplete(gap)));
                let middle = start + 0.5 * (end - start);
                let reason = open.len() - 1;
                let role = match gap {
                    Incomplete::Vanishing { .. } => Role::Vanishing(reason),
                    _ => Role::Probe(reason),
                };
                let probes =
                    [(start.max(from), Role::Probe(reason)), (middle, role), (end.min(to), Role::Probe(reason))];
                found.extend(probes.into_iter().filter(|(t, _)| (from..=to).contains(t)));
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let event = |&(t, role): &(f64, Role)| match role {
            Role::Crossing(slack) => (t, Some(slack)),
            _ => (t, None),
        };
        let points = course.points_at_events(program, &found.iter().map(event).collect::<Vec<_>>());
        let mut measured = measure(program, &points, Some(along));
        // Where the sign changes, the sides are equal.
        for group in &mut measured.groups {
            group.equal.iter_mut().flatten().for_each(|equal| *equal = true);
        }
        let (times, roles) = found.into_iter().unzip();
        Between { times, points, roles, open, measured, position }
    }

    /// The times that the assumptions leave.
    fn applied(&self, trial: &Trial) -> Applied {
        apply(trial, &self.measured, &Describer::new(trial, &self.times, &self.points))
    }

    /// What the search leaves open at times that count.
    fn still_open(&self, left: &[Left], judged: &Judged) -> Option<&String> {
        let reason = |(i, role): (usize, &Role)| {
            let (Role::Probe(reason) | Role::Vanishing(reason)) = role else { return None };
            let without_value = matches!(judged.best(i), Some(Standing::NoValue(_)));
            (left[i] == Left::In && !without_value).then(|| self.open.get(*reason))?
        };
        self.roles.iter().enumerate().find_map(reason)
    }

    /// The verdict of a group that holds at all samples.
    fn held(&self, trial: &Trial) -> Option<Verdict> {
        let group = &self.measured.groups[self.position];
        if self.times.is_empty() {
            return None;
        }
        let describer = Describer::new(trial, &self.times, &self.points);
        let applied = self.applied(trial);
        if let Some(reason) = applied.unmet {
            return Some(not_applicable(reason));
        }
        let judged = Judged::new(group, trial.claim.precision);
        // Whether a time at which the sides touch refutes cannot be told: such times are not weighed.
        let weighed = |(left, role): (&Left, &Role)| match role {
            Role::Probe(_) | Role::Vanishing(_) => Left::Out(Arc::from("")),
            _ => left.clone(),
        };
        let left: Vec<Left> = applied.left.iter().zip(&self.roles).map(weighed).collect();
        let undecided = |reason: String, samples: usize| {
            let evidence = Evidence { samples, reason: Some(reason), ..Evidence::default() };
            Some(Verdict::new(Outcome::Undecided, evidence))
        };
        let counted = left.iter().filter(|l| **l == Left::In).count();
        if counted > 0 {
            let verdict = weigh(describer.setting(left.clone()), group);
            if let Outcome::Fails(_) = verdict.outcome() {
                return Some(verdict);
            }
        }
        let unclear = |i: &usize| left[*i] == Left::In && judged.best(*i) == Some(Standing::Inconclusive);
        if let Some(i) = (0..self.times.len()).find(unclear) {
            let t = short(self.times[i]);
            return undecided(
                format!("near t = {t}, between two samples, the error bound is too large to tell"),
                counted,
            );
        }
        self.still_open(&applied.left, &judged).and_then(|reason| undecided(reason.clone(), counted))
    }

    /// The first time at which a group holds, with the sign that makes it hold. An equation holds where left − right changes
    /// its sign, also if the error bound is too large for a single point.
    pub fn holding(&self, trial: &Trial) -> Option<(usize, usize)> {
        let group = &self.measured.groups[self.position];
        let judged = Judged::new(group, trial.claim.precision);
        let applied = self.applied(trial);
        if applied.unmet.is_some() {
            return None;
        }
        let equation = group.group.comparisons.iter().all(|c| c.kind == RelationKind::Equal);
        let happens = |i: usize, s: usize| match (judged.whole[s][i], self.roles[i]) {
            (_, Role::Probe(_)) => false,
            (Standing::Satisfied, _) => true,
            (Standing::Inconclusive, Role::Crossing(_)) => equation,
            _ => false,
        };
        let counted = (0..self.times.len()).filter(|&i| applied.left[i] == Left::In);
        counted.flat_map(|i| (0..judged.whole.len()).map(move |s| (i, s))).find(|&(i, s)| happens(i, s))
    }

    /// The group as measured at the times.
    pub fn judged(&self, trial: &Trial) -> Judged<'_, 'a> {
        Judged::new(&self.measured.groups[self.position], trial.claim.precision)
    }

    /// What describes the times.
    pub fn describer<'b>(&'b self, trial: &Trial<'b>) -> Describer<'b> {
        Describer::new(trial, &self.times, &self.points)
    }
}

/// The verdict of a claim that holds at all samples, with what lies between them.
pub(super) fn between_samples(trial: &Trial, along: &Measurements, verdict: Verdict) -> Verdict {
    let Outcome::Holds(_) = verdict.outcome() else { return verdict };
    let mut found = Vec::new();
    for (position, (how, group)) in trial.program.groups.iter().enumerate() {
        if matches!(how, Use::Always | Use::Defined) && how.boundaries(group).next().is_some() {
            found.extend(Between::look(trial, along, position).held(trial));
        }
    }
    if found.is_empty() {
        return verdict;
    }
    let found = all_of(found);
    let samples = verdict.evidence().samples + found.evidence().samples;
    let excluded = verdict.evidence().excluded.clone();
    Verdict::new(found.outcome(), Evidence { samples, excluded, ..found.evidence().clone() })
}
