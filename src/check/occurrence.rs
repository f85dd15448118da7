//! "Never" and "at some time".
//!
//! Samples and zeros can refute that something never happens, and establish that it happens; never the other way round.

use super::between::Between;
use super::comparison::Standing;
use super::describe::short;
use super::measured::MeasuredGroup;
use super::program::Use;
use super::series::residuals;
use super::trial::Trial;
use super::verdict::{Evidence, Outcome, Residual, Strength, Verdict, Witness};
use super::weigh::{Judged, Left, Setting, witness};

/// What lies between the samples, looked for when it is needed; none for a claim that is tried at events only.
type Looked<'f, 'a> = dyn Fn() -> Option<Between<'a>> + 'f;

/// A point at which a relation holds.
struct Occurrence {
    t: f64,
    residual: Residual,
    witness: Witness,
    between: bool,
}

/// The point of a judged group at a time, for one sign.
fn point(setting: &Setting, judged: &Judged, (i, s): (usize, usize), between: bool) -> Option<Occurrence> {
    let group = judged.measured;
    let c = judged.deciding(s, i);
    let m = group.signs[s][c].get(i).ok()?;
    let (t, max, bound) = (setting.times[i], m.difference.value.abs(), m.difference.error);
    let witness = witness(setting, &group.group.comparisons[c], i, m);
    Some(Occurrence { t, residual: Residual { max, bound, at: t }, witness, between })
}

/// The first time that counts at which a group holds: among the samples, otherwise between them.
fn first(trial: &Trial, setting: &Setting, judged: &Judged, between: &Looked<'_, '_>) -> Option<Occurrence> {
    let holding = (0..setting.times.len())
        .filter(|&i| setting.left[i] == Left::In)
        .find_map(|i| (0..judged.whole.len()).find(|&s| judged.whole[s][i] == Standing::Satisfied).map(|s| (i, s)));
    if let Some(at) = holding {
        return point(setting, judged, at, false);
    }
    let between = between()?;
    let at = between.holding(trial)?;
    let describer = between.describer(trial);
    point(&describer.setting(Vec::new()), &between.judged(trial), at, true)
}

/// The verdict on a group of a claim that says that something happens never, or at some time.
pub(super) fn occurrence(
    trial: &Trial,
    setting: &Setting,
    group: &MeasuredGroup,
    how: &Use,
    between: &Looked<'_, '_>,
) -> Verdict {
    let never = matches!(how, Use::Never(_));
    let counted = setting.left.iter().filter(|l| **l == Left::In).count();
    let mut evidence = Evidence { samples: counted, ..Evidence::default() };
    let judged = Judged::new(group, setting.precision);
    let nearest = closest(setting, group);
    // How far the sides are apart is worth seeing, whatever was found.
    evidence.series = residuals(setting, &judged, nearest.as_ref().map(|(_, at)| *at), true);
    match first(trial, setting, &judged, between) {
        Some(found) if never => {
            evidence.witness = Some(found.witness);
            return Verdict::new(Outcome::Fails(Strength::Sampled), evidence);
        }
        Some(found) => {
            evidence.reason = Some(match found.between {
                true => format!("happens first at t = {:.12}", found.t),
                false => format!("first seen at the sample t = {}", short(found.t)),
            });
            if !found.between {
                evidence.residual = Some(found.residual);
            }
            return Verdict::new(Outcome::Holds(Strength::Sampled), evidence);
        }
        None => {}
    }
    if never {
        let closest = nearest.map(|(residual, _)| residual);
        let approach = closest
            .as_ref()
            .map_or(String::new(), |r| format!("; the sides come closest, to {:.3e}, at t = {}", r.max, short(r.at)));
        evidence.residual = closest;
        evidence.reason = Some(format!(
            "not seen at {counted} samples, nor as a sign change between them{approach}; samples cannot show that \
             something never happens, an enclosure would"
        ));
    } else {
        let course = trial.course;
        let (from, to) = course.stage.span(course.trajectory);
        evidence.reason = Some(format!(
            "not seen at {counted} samples between t = {from} and t = {to}; a longer motion may show it, an enclosure \
             could exclude it"
        ));
    }
    Verdict::new(Outcome::Undecided, evidence)
}

/// The closest approach of the sides of a group, for the reader, with its comparison and time.
fn closest(setting: &Setting, group: &MeasuredGroup) -> Option<(Residual, (usize, usize))> {
    let mut closest: Option<(Residual, (usize, usize))> = None;
    for (c, series) in group.signs.iter().flat_map(|s| s.iter().enumerate()) {
        for (i, left) in setting.left.iter().enumerate() {
            if let (Ok(difference), Left::In) = (series.difference(i), left) {
                let size = difference.value.abs();
                if closest.as_ref().is_none_or(|(r, _)| size < r.max) {
                    closest = Some((Residual { max: size, bound: difference.error, at: setting.times[i] }, (c, i)));
                }
            }
        }
    }
    closest
}
