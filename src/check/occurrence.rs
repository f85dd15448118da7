//! "Never" and "at some time".
//!
//! Samples and zeros can refute that something never happens, and establish that it happens; never the other way round.

use super::comparison::{Comparison, Standing};
use super::describe::{Describer, short};
use super::trial::{Course, measure};
use super::verdict::{Evidence, Outcome, Residual, Strength, Verdict};
use super::weigh::{Judged, Left, MeasuredGroup, Setting, witness};
use crate::derivation::Claim;
use crate::flow::Zeros;

/// The times that count at which a group holds, with the sign that makes it hold.
fn holding(setting: &Setting, judged: &Judged) -> Option<(usize, usize)> {
    let standing = &judged.whole;
    (0..setting.times.len())
        .filter(|&i| setting.left[i] == Left::In)
        .find_map(|i| (0..standing.len()).find(|&s| standing[s][i] == Standing::Satisfied).map(|s| (i, s)))
}

/// A claim that a relation holds at no time: samples can refute it, and never establish it.
pub(super) fn never(
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
        let at_zero = describer.at(std::slice::from_ref(&t), &points);
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
pub(super) fn eventually(
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
