//! Weighing: from measured comparisons to a verdict.
//!
//! **In:** for every comparison and every time, both sides with their error bounds ([`MeasuredGroup`]). **Out:** a [`Verdict`].
//!
//! The rules, in their order: a point where an assumption is not met, or where a side has no value, is left out and named;
//! when nothing is left the claim is not applicable. One violated point refutes. Points whose bound is too large to tell
//! are named too; more than two in a hundred of them, and the verdict is `undecided`.

use std::sync::Arc;

use super::comparison::{Comparison, Standing};
use super::describe::Describer;
use super::measured::{Measured, MeasuredGroup, Series};
use super::verdict::{Evidence, Exclusion, Outcome, Residual, Strength, Verdict, Witness};
use crate::latex::RelationKind;
use crate::number::{Bounded, NoValue};

/// Share of points whose bound may be too large, for a claim that holds at all others.
pub(super) const TOLERATED_INCONCLUSIVE: f64 = 0.02;

/// Most stretches of excluded times that are listed one by one.
const MOST_EXCLUSIONS: usize = 12;

/// Why a point does not count.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Left {
    /// It counts.
    In,
    /// It is left out, for this reason.
    Out(Arc<str>),
}

/// What is known of each time before the claim itself is looked at, and how to describe a point.
pub(super) struct Setting<'a> {
    /// The times, increasing.
    pub times: &'a [f64],
    /// Which of them count.
    pub left: Vec<Left>,
    /// The precision that the claim asks for.
    pub precision: f64,
    /// Whether one sign of ± must serve the whole motion.
    pub one_sign_throughout: bool,
    /// Whether a reader is shown both sides along the motion.
    pub shown: bool,
    /// What describes the points.
    pub describer: &'a Describer<'a>,
}

/// A measured group, judged.
pub(super) struct Judged<'a, 'g> {
    /// The measurements.
    pub measured: &'a MeasuredGroup<'g>,
    precision: f64,
    /// Whether it consists of equations only, that say more than that they have values.
    equations: bool,
    /// `[s][i]`: standing of the whole group at time i for the sign s.
    pub whole: Vec<Vec<Standing>>,
}

impl<'a, 'g> Judged<'a, 'g> {
    /// Judges every comparison at every time.
    pub fn new(measured: &'a MeasuredGroup<'g>, precision: f64) -> Judged<'a, 'g> {
        let whole = |(s, series): (usize, &Vec<Series>)| -> Vec<Standing> {
            let mut whole = vec![Standing::Satisfied; series.first().map_or(0, Series::len)];
            (0..series.len()).for_each(|c| measured.stand(s, c, precision, &mut whole));
            whole
        };
        let equations = measured.group.comparisons.iter().all(|c| c.kind == RelationKind::Equal);
        let equations = equations && !measured.definedness;
        Judged { measured, precision, equations, whole: measured.signs.iter().enumerate().map(whole).collect() }
    }

    /// The comparison that decides the standing at a time, for one sign: the one that is furthest off, against the size of its
    /// terms, among the worst; where all is well, the one with the largest residual.
    pub fn deciding(&self, sign: usize, time: usize) -> usize {
        if self.whole[sign][time] == Standing::Satisfied {
            return self.largest(sign, time);
        }
        let series = &self.measured.signs[sign];
        if series.len() == 1 {
            return 0;
        }
        let scale = |c: usize| self.measured.scale(sign, c, time);
        let off = |c: usize| series[c].difference(time).map_or(f64::INFINITY, |d| d.value.abs() / scale(c));
        let worst = self.worst(sign, time).map(|c| (c, off(c)));
        worst.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(c, _)| c)
    }

    /// The comparison with the largest residual at a time, in units of its error bound, among those that stand as the whole
    /// group does, for one sign. Among equals the one with the largest bound.
    fn largest(&self, sign: usize, time: usize) -> usize {
        let series = &self.measured.signs[sign];
        if series.len() == 1 {
            return 0;
        }
        let size = |c: usize| match series[c].difference(time) {
            Ok(d) => (ratio(d.value.abs(), d.error), d.error),
            Err(_) => (f64::INFINITY, f64::INFINITY),
        };
        let larger = |a: (usize, (f64, f64)), b: (usize, (f64, f64))| if b.1 > a.1 { b } else { a };
        let sized = |c| (c, size(c));
        // What is violated of an equation is further off than what is not.
        let found = match (self.whole[sign][time], self.equations) {
            (Standing::Satisfied, _) | (Standing::Violated, true) => (0..series.len()).map(sized).reduce(larger),
            _ => self.worst(sign, time).map(sized).reduce(larger),
        };
        found.map_or(0, |(c, _)| c)
    }

    /// The comparisons that stand as the whole group does at a time, for one sign.
    fn worst(&self, sign: usize, time: usize) -> impl Iterator<Item = usize> + '_ {
        let whole = self.whole[sign][time];
        let stands = move |c: &usize| self.measured.standing(sign, *c, time, self.precision) == whole;
        let count = self.measured.signs[sign].len();
        (0..count).filter(move |c| count == 1 || stands(c))
    }

    /// A comparison at some times, with the sign that does best there, and the size of its terms: what a reader is shown. Times
    /// without a value are left out.
    pub fn shown(&self, comparison: usize, times: &[usize]) -> Vec<(usize, Measured, f64)> {
        let rank = |&(s, time): &(usize, usize)| match self.whole[s].get(time) {
            Some(Standing::Satisfied) => 0,
            Some(Standing::Inconclusive) => 1,
            _ => 2,
        };
        let best = |time: usize| (0..self.whole.len()).map(|s| (s, time)).min_by_key(rank).map(|(s, _)| s);
        let mut out = Vec::with_capacity(times.len());
        for sign in 0..self.whole.len() {
            let here: Vec<usize> = times.iter().copied().filter(|&time| best(time) == Some(sign)).collect();
            let scales = self.measured.scales(sign, comparison, &here);
            let measured = |time: usize| self.measured.signs[sign].get(comparison)?.get(time).ok();
            let each = here.into_iter().zip(scales).filter_map(|(time, scale)| Some((time, measured(time)?, scale)));
            out.extend(each);
        }
        out.sort_by_key(|(time, ..)| *time);
        out
    }

    /// The standing at a time with the sign that does best.
    pub fn best(&self, time: usize) -> Option<Standing> {
        self.whole.iter().map(|s| s[time]).reduce(Standing::or)
    }
}

/// A point of a comparison that a reader can check.
pub(super) fn witness(setting: &Setting, comparison: &Comparison, time: usize, m: Measured) -> Witness {
    Witness {
        t: setting.times[time],
        formula: comparison.label.clone(),
        left: m.left,
        right: m.right,
        bound: m.difference.error,
        values: setting.describer.values(comparison, time),
    }
}

/// Joins neighbouring excluded points with the same reason.
fn exclusions(times: &[f64], left: &[Left]) -> Vec<Exclusion> {
    let mut out: Vec<Exclusion> = Vec::new();
    let mut open: Option<&str> = None;
    for (&t, l) in times.iter().zip(left) {
        match l {
            Left::In => open = None,
            Left::Out(reason) => {
                match (open, out.last_mut()) {
                    (Some(r), Some(last)) if r == &**reason => last.to = t,
                    _ => out.push(Exclusion { from: t, to: t, reason: reason.to_string() }),
                }
                open = Some(reason);
            }
        }
    }
    if out.len() > MOST_EXCLUSIONS {
        let rest = out.split_off(MOST_EXCLUSIONS - 1);
        if let (Some(first), Some(last)) = (rest.first(), rest.last()) {
            let reason = format!("{} more stretches, the first because {}", rest.len(), first.reason);
            out.push(Exclusion { from: first.from, to: last.to, reason });
        }
    }
    out
}

/// The signs of ± along the motion, in words, and a time at which one sign alone does not do.
struct Signs {
    words: Option<String>,
    change: Option<(usize, usize)>,
}

/// Which sign of ± serves where. `standing[s][i]` with s = 0 for + and 1 for −.
fn signs(times: &[f64], left: &[Left], standing: &[Vec<Standing>]) -> Signs {
    if standing.len() < 2 {
        return Signs { words: None, change: None };
    }
    let mut runs: Vec<(usize, f64, f64)> = Vec::new();
    let mut first: [Option<usize>; 2] = [None, None];
    for i in 0..times.len() {
        if left[i] != Left::In {
            continue;
        }
        let only = match (standing[0][i], standing[1][i]) {
            (Standing::Satisfied, Standing::Violated) => 0,
            (Standing::Violated, Standing::Satisfied) => 1,
            _ => continue,
        };
        first[only].get_or_insert(i);
        match runs.last_mut() {
            Some((sign, _, to)) if *sign == only => *to = times[i],
            _ => runs.push((only, times[i], times[i])),
        }
    }
    let name = ["+", "−"];
    let words = match runs.as_slice() {
        [] => "either sign".to_owned(),
        [(sign, ..)] => format!("{} throughout", name[*sign]),
        _ => {
            let listed: Vec<String> =
                runs.iter().take(6).map(|(s, a, b)| format!("{} on [{a:.4}, {b:.4}]", name[*s])).collect();
            let more = if runs.len() > 6 { format!(" and {} more changes", runs.len() - 6) } else { String::new() };
            format!("{}{more}", listed.join(", "))
        }
    };
    Signs { words: Some(words), change: first[0].zip(first[1]) }
}

/// A residual in units of its bound.
fn ratio(size: f64, bound: f64) -> f64 {
    if size == 0.0 { 0.0 } else { size / bound }
}

/// A violated comparison: where it is, and how far off; in units of the size of its terms once that is known.
#[derive(Clone, Copy)]
struct Failure {
    size: f64,
    sign: usize,
    comparison: usize,
    time: usize,
}

/// The failure that is largest against the size of its terms; among equals the earliest, and there the last comparison.
///
/// No size is below what is typical along the motion: so sizes are asked for only where a failure may be the largest.
fn clearest(group: &MeasuredGroup, failures: &[Failure]) -> Option<Failure> {
    let most = |f: &Failure| f.size / group.floor(f.sign);
    let exactly = |f: &Failure| Failure { size: f.size / group.scale(f.sign, f.comparison, f.time), ..*f };
    let first = failures.iter().max_by(|a, b| most(a).total_cmp(&most(b)))?;
    let least = exactly(first).size;
    let mut clearest: Option<Failure> = None;
    for f in failures {
        if most(f) < clearest.map_or(least, |c| c.size.max(least)) {
            continue;
        }
        let f = exactly(f);
        if clearest.is_none_or(|c| f.size > c.size || f.size == c.size && f.time == c.time) {
            clearest = Some(f);
        }
    }
    clearest
}

/// Weighs a group, all comparisons of which must hold.
pub(super) fn weigh(mut setting: Setting, group: &MeasuredGroup) -> Verdict {
    let count = setting.times.len();
    let mut evidence = Evidence::default();
    let mut inconclusive: Option<String> = None;
    let mut inconclusive_count = 0;
    let mut failures: Vec<Failure> = Vec::new();
    let mut worst: Option<(usize, usize)> = None;
    let mut largest = 0.0;
    let judged = Judged::new(group, setting.precision);
    let standing = &judged.whole;
    let fault = |c: usize, i: usize, reason| setting.describer.fault(&group.group.comparisons[c], i, reason);

    // First what has no value: such points are left out.
    for (i, left) in setting.left.iter_mut().enumerate() {
        if let (Some(Standing::NoValue(reason)), Left::In) = (judged.best(i), &*left) {
            *left = Left::Out(fault(judged.deciding(0, i), i, reason));
        }
    }
    let counted: Vec<usize> = (0..count).filter(|&i| setting.left[i] == Left::In).collect();
    evidence.excluded = exclusions(setting.times, &setting.left);
    evidence.samples = counted.len();
    if counted.is_empty() {
        let reason = setting.left.iter().find_map(|l| match l {
            Left::Out(reason) => Some(reason.to_string()),
            Left::In => None,
        });
        evidence.reason = Some(reason.unwrap_or_else(|| "no time at which it could be tried".to_owned()));
        return Verdict::new(Outcome::NotApplicable, evidence);
    }

    let sign = signs(setting.times, &setting.left, standing);
    evidence.branch = sign.words;
    for &i in &counted {
        // For ±: the sign that does best at this time.
        let best = (0..standing.len()).min_by_key(|&s| match standing[s][i] {
            Standing::Satisfied => 0,
            Standing::Inconclusive => 1,
            Standing::Violated => 2,
            Standing::NoValue(_) => 3,
        });
        let Some(best) = best else { continue };
        let c = judged.largest(best, i);
        let Ok(difference) = group.signs[best][c].difference(i) else {
            if standing[best][i] == Standing::Violated {
                // A claim of definedness: there is no value to show, the reason is.
                evidence.reason.get_or_insert_with(|| fault(c, i, NoValue::OutOfDomain).to_string());
                failures.push(Failure { size: 0.0, sign: best, comparison: c, time: i });
            } else if standing[best][i] == Standing::Inconclusive {
                inconclusive_count += 1;
                inconclusive.get_or_insert_with(|| {
                    let why = fault(c, i, group.signs[best][c].difference(i).err().unwrap_or(NoValue::Indeterminate));
                    format!("at t = {:.6}, {why}", setting.times[i])
                });
            }
            continue;
        };
        let (size, bound) = (difference.value.abs(), difference.error);
        let worse = evidence.residual.is_none() || ratio(size, bound) > largest;
        if worse && !group.definedness {
            largest = ratio(size, bound);
            evidence.residual = Some(Residual { max: size, bound, at: setting.times[i] });
            worst = Some((c, i));
        }
        match standing[best][i] {
            Standing::Satisfied | Standing::NoValue(_) => {}
            Standing::Inconclusive => {
                inconclusive_count += 1;
                inconclusive.get_or_insert_with(|| {
                    let unseen = if group.mute[best][c] { ", below which a term of the formula is lost" } else { "" };
                    format!(
                        "at t = {:.6} the two sides differ by {:.2e}, with an error bound of {:.2e}{unseen}",
                        setting.times[i], difference.value, bound
                    )
                });
            }
            Standing::Violated => {
                let off = |c: usize| group.signs[best][c].difference(i).map_or(0.0, |d| d.value.abs());
                let failed = |c: usize| Failure { size: off(c), sign: best, comparison: c, time: i };
                failures.extend(judged.worst(best, i).map(failed));
            }
        }
    }
    if let (true, Some((plus, minus))) = (setting.one_sign_throughout, sign.change) {
        // + alone serves at one time, − alone at another: refute with the later of the two, where the other fails.
        let (i, wrong) = if plus > minus { (plus, 1) } else { (minus, 0) };
        let c = judged.deciding(wrong, i);
        if let Ok(difference) = group.signs[wrong][c].difference(i) {
            failures.push(Failure { size: difference.value.abs(), sign: wrong, comparison: c, time: i });
            evidence.reason = Some("no single sign of ± serves the whole motion".to_owned());
        }
    }

    let clearest = clearest(group, &failures);
    let telling = clearest.as_ref().map(|f| (f.comparison, f.time)).or(worst);
    evidence.series = super::series::residuals(&setting, &judged, telling, false);
    if let Some(f) = clearest {
        let absent = Measured { left: 0.0, right: 0.0, difference: Bounded::exact(0.0) };
        let m = group.signs[f.sign][f.comparison].get(f.time).unwrap_or(absent);
        evidence.witness = Some(witness(&setting, &group.group.comparisons[f.comparison], f.time, m));
        return Verdict::new(Outcome::Fails(Strength::Sampled), evidence);
    }
    // That something has a value is claimed of every point: one that cannot tell leaves it open.
    let definedness = group.definedness && inconclusive_count > 0;
    if definedness || inconclusive_count as f64 > TOLERATED_INCONCLUSIVE * counted.len() as f64 {
        let example = inconclusive.unwrap_or_else(|| "no value could be determined".to_owned());
        let would = match group.mute.iter().flatten().any(|&mute| mute) {
            true => "a formula whose large terms do not cancel",
            false => "a more accurate trajectory or a lower precision",
        };
        evidence.reason = Some(format!(
            "the error bound is too large to tell at {inconclusive_count} of {} times: {example}; {would} would decide",
            counted.len()
        ));
        return Verdict::new(Outcome::Undecided, evidence);
    }
    evidence.samples = counted.len() - inconclusive_count;
    if inconclusive_count > 0 {
        evidence.reason = Some(format!("at {inconclusive_count} further times the error bound is too large to tell"));
    }
    Verdict::new(Outcome::Holds(Strength::Sampled), evidence)
}
