//! Weighing: from measured comparisons to a verdict.
//!
//! **In:** for every comparison and every time, both sides with their error bounds ([`Series`]). **Out:** a [`Verdict`].
//!
//! The rules, in their order: a point where an assumption is not met, or where a side has no value, is left out and named;
//! when nothing is left the claim is not applicable. One violated point refutes. Points whose bound is too large to tell
//! are named too; more than one in ten of them, and the verdict is `undecided`.

use super::comparison::{Comparison, Group, Standing, judge};
use super::verdict::{Evidence, Exclusion, Outcome, Residual, Strength, Verdict, Witness};
use crate::number::{Bounded, NoValue};

/// Share of points whose bound may be too large, for a claim that holds at all others.
const TOLERATED_INCONCLUSIVE: f64 = 0.1;

/// Most stretches of excluded times that are listed one by one.
const MOST_EXCLUSIONS: usize = 12;

/// Both sides of a comparison at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Measured {
    /// The left side.
    pub left: Bounded,
    /// The right side.
    pub right: Bounded,
    /// Left − right.
    pub difference: Bounded,
    /// Size of the terms.
    pub magnitude: f64,
}

/// A comparison at all times, for one sign of ±.
pub(super) type Series = Vec<Result<Measured, NoValue>>;

/// One group, measured: `signs[s][c][i]` is comparison c at time i for the sign s; one sign only where no ± occurs.
pub(super) struct MeasuredGroup<'a> {
    /// What was compared.
    pub group: &'a Group,
    /// The measurements.
    pub signs: Vec<Vec<Series>>,
    /// Whether the group only says that its left sides have values.
    pub definedness: bool,
}

/// Why a point does not count.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Left {
    /// It counts.
    In,
    /// It is left out, for this reason.
    Out(String),
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
    /// Values that a comparison depends on at a time, for a witness.
    pub values: &'a dyn Fn(&Comparison, usize) -> Vec<(String, f64)>,
    /// Why a comparison has no value at a time, in words.
    pub fault: &'a dyn Fn(&Comparison, usize, NoValue) -> String,
}

/// What a point must be large against: the size of the terms there, or typically along the motion, whichever is larger.
fn scales(series: &Series) -> Vec<f64> {
    let mut sizes: Vec<f64> = series.iter().filter_map(|m| m.as_ref().ok().map(|m| m.magnitude)).collect();
    sizes.sort_by(f64::total_cmp);
    let typical = sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
    let scale = |m: &Result<Measured, NoValue>| match m {
        Ok(m) => m.magnitude.max(typical),
        Err(_) => typical,
    };
    series.iter().map(scale).map(|s| if s > 0.0 { s } else { 1.0 }).collect()
}

/// Standing of every comparison of a group at every time, for one sign: `[c][i]`.
fn standings(group: &MeasuredGroup, sign: usize, precision: f64) -> Vec<Vec<Standing>> {
    let one = |(comparison, series): (&Comparison, &Series)| {
        let scales = scales(series);
        let at = |(m, scale): (&Result<Measured, NoValue>, f64)| match (m, group.definedness) {
            (Ok(_), true) => Standing::Satisfied,
            (Err(NoValue::OutOfDomain), true) => Standing::Violated,
            (Err(_), true) => Standing::Inconclusive,
            (Ok(m), false) => judge(comparison.kind, m.difference, scale, precision),
            (Err(reason), false) => Standing::NoValue(*reason),
        };
        series.iter().zip(scales).map(at).collect()
    };
    group.group.comparisons.iter().zip(&group.signs[sign]).map(one).collect()
}

/// Standing of a whole group at every time, with each sign: `[s][i]`.
pub(super) fn group_standings(group: &MeasuredGroup, precision: f64) -> Vec<Vec<Standing>> {
    let whole = |sign: usize| {
        let each = standings(group, sign, precision);
        let count = each.first().map_or(0, Vec::len);
        (0..count).map(|i| each.iter().map(|s| s[i]).fold(Standing::Satisfied, Standing::and)).collect()
    };
    (0..group.signs.len()).map(whole).collect()
}

/// The comparison of a group that decides its standing at a time, for one sign.
pub(super) fn deciding(group: &MeasuredGroup, sign: usize, time: usize, precision: f64) -> usize {
    let each = standings(group, sign, precision);
    let worst = each.iter().map(|s| s[time]).fold(Standing::Satisfied, Standing::and);
    let excess = |c: usize| match &group.signs[sign][c][time] {
        Ok(m) => m.difference.value.abs() / scales(&group.signs[sign][c])[time],
        Err(_) => f64::INFINITY,
    };
    let candidates = (0..each.len()).filter(|&c| each[c][time] == worst);
    candidates.max_by(|&a, &b| excess(a).total_cmp(&excess(b))).unwrap_or(0)
}

/// A point of a comparison that a reader can check.
pub(super) fn witness(setting: &Setting, comparison: &Comparison, time: usize, m: &Measured) -> Witness {
    Witness {
        t: setting.times[time],
        formula: comparison.label.clone(),
        left: m.left.value,
        right: m.right.value,
        bound: m.difference.error,
        values: (setting.values)(comparison, time),
    }
}

/// Joins neighbouring excluded points with the same reason.
fn exclusions(times: &[f64], left: &[Left]) -> Vec<Exclusion> {
    let mut out: Vec<Exclusion> = Vec::new();
    let mut open: Option<String> = None;
    for (&t, l) in times.iter().zip(left) {
        match l {
            Left::In => open = None,
            Left::Out(reason) => {
                match (&open, out.last_mut()) {
                    (Some(r), Some(last)) if r == reason => last.to = t,
                    _ => out.push(Exclusion { from: t, to: t, reason: reason.clone() }),
                }
                open = Some(reason.clone());
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

/// Weighs the groups of a claim, all of which must hold.
pub(super) fn weigh(mut setting: Setting, groups: &[MeasuredGroup]) -> Verdict {
    let count = setting.times.len();
    let mut evidence = Evidence::default();
    let mut satisfied_everywhere = vec![true; count];
    let mut inconclusive: Option<String> = None;
    let mut inconclusive_count = 0;
    let mut failures: Vec<(f64, Witness)> = Vec::new();
    let all: Vec<Vec<Vec<Standing>>> = groups.iter().map(|g| group_standings(g, setting.precision)).collect();

    // First what has no value: such points are left out of the claim as a whole.
    for (group, standing) in groups.iter().zip(&all) {
        for i in 0..count {
            let best = standing.iter().map(|s| s[i]).reduce(Standing::or);
            if let (Some(Standing::NoValue(reason)), Left::In) = (best, &setting.left[i]) {
                let c = deciding(group, 0, i, setting.precision);
                setting.left[i] = Left::Out((setting.fault)(&group.group.comparisons[c], i, reason));
            }
        }
    }
    let counted: Vec<usize> = (0..count).filter(|&i| setting.left[i] == Left::In).collect();
    evidence.excluded = exclusions(setting.times, &setting.left);
    evidence.samples = counted.len();
    if counted.is_empty() {
        let reason = setting.left.iter().find_map(|l| match l {
            Left::Out(reason) => Some(reason.clone()),
            Left::In => None,
        });
        evidence.reason = Some(reason.unwrap_or_else(|| "no time at which it could be tried".to_owned()));
        return Verdict::new(Outcome::NotApplicable, evidence);
    }

    for (group, standing) in groups.iter().zip(&all) {
        let sign = signs(setting.times, &setting.left, standing);
        if sign.words.is_some() {
            evidence.branch = sign.words;
        }
        for &i in &counted {
            // For ±: the sign that does best at this time.
            let best = (0..standing.len()).min_by_key(|&s| match standing[s][i] {
                Standing::Satisfied => 0,
                Standing::Inconclusive => 1,
                Standing::Violated => 2,
                Standing::NoValue(_) => 3,
            });
            let Some(best) = best else { continue };
            let c = deciding(group, best, i, setting.precision);
            let Ok(m) = &group.signs[best][c][i] else {
                if standing[best][i] == Standing::Violated {
                    // A claim of definedness: there is no value to show, the reason is.
                    let reason = (setting.fault)(&group.group.comparisons[c], i, NoValue::OutOfDomain);
                    evidence.reason.get_or_insert(reason);
                    let none = Bounded { value: 0.0, error: 0.0 };
                    let m = Measured { left: none, right: none, difference: none, magnitude: 0.0 };
                    failures.push((0.0, witness(&setting, &group.group.comparisons[c], i, &m)));
                } else {
                    inconclusive_count += 1;
                }
                continue;
            };
            let ratio = |m: f64, b: f64| if m == 0.0 { 0.0 } else { m / b };
            let (size, bound) = (m.difference.value.abs(), m.difference.error);
            let worse = evidence.residual.as_ref().is_none_or(|r| ratio(size, bound) > ratio(r.max, r.bound));
            if worse && !group.definedness {
                evidence.residual = Some(Residual { max: size, bound, at: setting.times[i] });
            }
            match standing[best][i] {
                Standing::Satisfied | Standing::NoValue(_) => {}
                Standing::Inconclusive => {
                    inconclusive_count += usize::from(std::mem::replace(&mut satisfied_everywhere[i], false));
                    inconclusive.get_or_insert_with(|| {
                        format!(
                            "at t = {:.6} the two sides differ by {:.2e}, with an error bound of {:.2e}",
                            setting.times[i], m.difference.value, bound
                        )
                    });
                }
                Standing::Violated => {
                    let scale = scales(&group.signs[best][c])[i];
                    failures.push((size / scale, witness(&setting, &group.group.comparisons[c], i, m)));
                }
            }
        }
        if let (true, Some((plus, minus))) = (setting.one_sign_throughout, sign.change) {
            // + alone serves at one time, − alone at another: refute with the later of the two, where the other fails.
            let (i, wrong) = if plus > minus { (plus, 1) } else { (minus, 0) };
            let c = deciding(group, wrong, i, setting.precision);
            if let Ok(m) = &group.signs[wrong][c][i] {
                let scale = scales(&group.signs[wrong][c])[i];
                failures.push((m.difference.value.abs() / scale, witness(&setting, &group.group.comparisons[c], i, m)));
                evidence.reason = Some("no single sign of ± serves the whole motion".to_owned());
            }
        }
    }

    // The clearest failure is the witness; among equals the earliest.
    let clearest = failures.into_iter().reduce(|a, b| if b.0 > a.0 { b } else { a });
    if let Some((_, witness)) = clearest {
        evidence.witness = Some(witness);
        return Verdict::new(Outcome::Fails(Strength::Sampled), evidence);
    }
    if inconclusive_count as f64 > TOLERATED_INCONCLUSIVE * counted.len() as f64 {
        let example = inconclusive.unwrap_or_else(|| "no value could be determined".to_owned());
        evidence.reason = Some(format!(
            "the error bound is too large to tell at {inconclusive_count} of {} times: {example}; a more accurate \
             trajectory or a lower precision would decide",
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
