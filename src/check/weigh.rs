//! Weighing: from measured comparisons to a verdict.
//!
//! **In:** for every comparison and every time, both sides with their error bounds ([`Series`]). **Out:** a [`Verdict`].
//!
//! The rules, in their order: a point where an assumption is not met, or where a side has no value, is left out and named;
//! when nothing is left the claim is not applicable. One violated point refutes. Points whose bound is too large to tell
//! are named too; more than two in a hundred of them, and the verdict is `undecided`.

use super::comparison::{Comparison, Group, Standing, judge};
use super::describe::Describer;
use super::verdict::{Evidence, Exclusion, Outcome, Residual, Strength, Verdict, Witness};
use crate::latex::RelationKind;
use crate::number::{Bounded, NoValue};

/// Share of points whose bound may be too large, for a claim that holds at all others.
pub(super) const TOLERATED_INCONCLUSIVE: f64 = 0.02;

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
    /// What is typical of the size of the terms along the motion, for each sign.
    pub floors: Vec<f64>,
    /// For each sign and comparison, whether agreement within the error bound says nothing: see `telling`.
    pub mute: Vec<Vec<bool>>,
    /// For each sign and comparison, whether equality within the error bound refutes a strict relation. What is equal all
    /// along is equal; what is equal within its error at some times, as a power that decays, may be larger than 0 still.
    pub equal: Vec<Vec<bool>>,
}

impl<'a> MeasuredGroup<'a> {
    /// A group measured along a motion: what is typical of it is what is typical there.
    pub fn new(group: &'a Group, signs: Vec<Vec<Series>>, definedness: bool) -> MeasuredGroup<'a> {
        let floors = signs.iter().map(|s| floor(s)).collect();
        let mute = signs.iter().map(|s| vec![false; s.len()]).collect();
        let along = |series: &Series| {
            let within = |m: &Measured| m.difference.contains_zero();
            series.iter().any(Result::is_ok) && series.iter().flatten().all(within)
        };
        let equal = signs.iter().map(|s| s.iter().map(along).collect()).collect();
        MeasuredGroup { group, signs, definedness, floors, mute, equal }
    }

    /// What a residual must be small against: the size of the terms at that time, or what is typical of the group along
    /// the motion, whichever is larger.
    fn scale(&self, sign: usize, m: &Measured) -> f64 {
        m.magnitude.max(self.floors[sign])
    }

    /// Whether the sides are equal within an error, where that does not refute a strict relation.
    fn is_open(&self, sign: usize, comparison: usize, m: &Measured) -> bool {
        let strict = match self.group.comparisons[comparison].kind {
            RelationKind::NotEqual | RelationKind::Less | RelationKind::Greater => true,
            RelationKind::Equal | RelationKind::LessEqual | RelationKind::GreaterEqual => false,
        };
        strict && m.difference.error > 0.0 && m.difference.contains_zero() && !self.equal[sign][comparison]
    }

    /// How a comparison stands at a time.
    fn standing(&self, sign: usize, comparison: usize, time: usize, precision: f64) -> Standing {
        let kind = self.group.comparisons[comparison].kind;
        // Where something must have a value, an equation only says that there is one; its conditions are inequalities.
        let exists = self.definedness && kind == RelationKind::Equal;
        match &self.signs[sign][comparison][time] {
            Ok(_) if exists => Standing::Satisfied,
            // No bound is small enough for what cannot be seen.
            Ok(m) if self.mute[sign][comparison] => judge(kind, m.difference, 0.0, precision),
            Ok(m) => match judge(kind, m.difference, self.scale(sign, m), precision) {
                Standing::Violated if self.is_open(sign, comparison, m) => Standing::Inconclusive,
                standing => standing,
            },
            Err(NoValue::OutOfDomain) if self.definedness => Standing::Violated,
            Err(NoValue::OutOfDomain) => Standing::NoValue(NoValue::OutOfDomain),
            // A value may exist: this is a bound that is too large, not a formula that says nothing.
            Err(_) => Standing::Inconclusive,
        }
    }
}

/// What is typical of the size of the terms of a group. The components of a vector share it: that one of them vanishes does
/// not make its rounding significant.
fn floor(group: &[Series]) -> f64 {
    let typical = group.iter().map(typical).fold(0.0, f64::max);
    if typical > 0.0 {
        return typical;
    }
    // Terms that are 0 most of the time are of the size that they have at other times.
    let all = || group.iter().flatten().flatten();
    let largest = all().map(|m| m.magnitude).fold(0.0, f64::max);
    // Terms that are 0 with an error are not 0, but too small for a number: nothing is small against them.
    if largest > 0.0 || all().any(|m| m.difference.error > 0.0) { largest } else { 1.0 }
}

/// The median size of the terms of a comparison along the motion.
fn typical(series: &Series) -> f64 {
    let mut sizes: Vec<f64> = series.iter().filter_map(|m| m.as_ref().ok().map(|m| m.magnitude)).collect();
    if sizes.is_empty() {
        return 0.0;
    }
    let middle = sizes.len() / 2;
    *sizes.select_nth_unstable_by(middle, f64::total_cmp).1
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
    /// What describes the points.
    pub describer: &'a Describer<'a>,
}

/// A measured group, judged.
pub(super) struct Judged<'a, 'g> {
    /// The measurements.
    pub measured: &'a MeasuredGroup<'g>,
    precision: f64,
    /// `[s][i]`: standing of the whole group at time i for the sign s.
    pub whole: Vec<Vec<Standing>>,
}

impl<'a, 'g> Judged<'a, 'g> {
    /// Judges every comparison at every time.
    pub fn new(measured: &'a MeasuredGroup<'g>, precision: f64) -> Judged<'a, 'g> {
        let whole = |(s, series): (usize, &Vec<Series>)| -> Vec<Standing> {
            let count = series.first().map_or(0, Vec::len);
            let at = |i: usize| {
                let each = (0..series.len()).map(|c| measured.standing(s, c, i, precision));
                each.fold(Standing::Satisfied, Standing::and)
            };
            (0..count).map(at).collect()
        };
        Judged { measured, precision, whole: measured.signs.iter().enumerate().map(whole).collect() }
    }

    /// The comparison that decides the standing at a time, for one sign: the one that is furthest off among the worst.
    pub fn deciding(&self, sign: usize, time: usize) -> usize {
        let worst = self.whole[sign][time];
        let series = &self.measured.signs[sign];
        if series.len() == 1 {
            return 0;
        }
        let off = |c: usize| match &series[c][time] {
            Ok(m) => m.difference.value.abs() / self.measured.scale(sign, m),
            Err(_) => f64::INFINITY,
        };
        let candidates = (0..series.len()).filter(|&c| self.measured.standing(sign, c, time, self.precision) == worst);
        candidates.max_by(|&a, &b| off(a).total_cmp(&off(b))).unwrap_or(0)
    }

    /// A comparison at a time with the sign that does best, and the size of its terms: what a reader is shown.
    pub fn shown(&self, comparison: usize, time: usize) -> Option<(&Measured, f64)> {
        let rank = |&s: &usize| match self.whole[s].get(time) {
            Some(Standing::Satisfied) => 0,
            Some(Standing::Inconclusive) => 1,
            _ => 2,
        };
        let sign = (0..self.whole.len()).min_by_key(rank)?;
        let m = self.measured.signs[sign].get(comparison)?.get(time)?.as_ref().ok()?;
        Some((m, self.measured.scale(sign, m)))
    }

    /// The standing at a time with the sign that does best.
    pub fn best(&self, time: usize) -> Option<Standing> {
        self.whole.iter().map(|s| s[time]).reduce(Standing::or)
    }
}

/// A point of a comparison that a reader can check.
pub(super) fn witness(setting: &Setting, comparison: &Comparison, time: usize, m: &Measured) -> Witness {
    Witness {
        t: setting.times[time],
        formula: comparison.label.clone(),
        left: m.left.value,
        right: m.right.value,
        bound: m.difference.error,
        values: setting.describer.values(comparison, time),
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

/// A violated comparison: where it is, and how far off in units of the size of its terms.
struct Failure {
    size: f64,
    sign: usize,
    comparison: usize,
    time: usize,
}

/// Weighs a group, all comparisons of which must hold.
pub(super) fn weigh(mut setting: Setting, group: &MeasuredGroup) -> Verdict {
    let count = setting.times.len();
    let mut evidence = Evidence::default();
    let mut inconclusive: Option<String> = None;
    let mut inconclusive_count = 0;
    let mut clearest: Option<Failure> = None;
    let mut worst: Option<(usize, usize)> = None;
    let mut fail = |failure: Failure| {
        // The clearest failure is the witness; among equals the earliest.
        if clearest.as_ref().is_none_or(|c| failure.size > c.size) {
            clearest = Some(failure);
        }
    };
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
            Left::Out(reason) => Some(reason.clone()),
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
        let c = judged.deciding(best, i);
        let Ok(m) = &group.signs[best][c][i] else {
            if standing[best][i] == Standing::Violated {
                // A claim of definedness: there is no value to show, the reason is.
                evidence.reason.get_or_insert_with(|| fault(c, i, NoValue::OutOfDomain));
                fail(Failure { size: 0.0, sign: best, comparison: c, time: i });
            } else if standing[best][i] == Standing::Inconclusive {
                inconclusive_count += 1;
                inconclusive.get_or_insert_with(|| {
                    let why = fault(c, i, group.signs[best][c][i].err().unwrap_or(NoValue::Indeterminate));
                    format!("at t = {:.6}, {why}", setting.times[i])
                });
            }
            continue;
        };
        let ratio = |m: f64, b: f64| if m == 0.0 { 0.0 } else { m / b };
        let (size, bound) = (m.difference.value.abs(), m.difference.error);
        let worse = evidence.residual.as_ref().is_none_or(|r| ratio(size, bound) > ratio(r.max, r.bound));
        if worse && !group.definedness {
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
                        setting.times[i], m.difference.value, bound
                    )
                });
            }
            Standing::Violated => {
                fail(Failure { size: size / group.scale(best, m), sign: best, comparison: c, time: i });
            }
        }
    }
    if let (true, Some((plus, minus))) = (setting.one_sign_throughout, sign.change) {
        // + alone serves at one time, − alone at another: refute with the later of the two, where the other fails.
        let (i, wrong) = if plus > minus { (plus, 1) } else { (minus, 0) };
        let c = judged.deciding(wrong, i);
        if let Ok(m) = &group.signs[wrong][c][i] {
            let size = m.difference.value.abs() / group.scale(wrong, m);
            fail(Failure { size, sign: wrong, comparison: c, time: i });
            evidence.reason = Some("no single sign of ± serves the whole motion".to_owned());
        }
    }

    let telling = clearest.as_ref().map(|f| (f.comparison, f.time)).or(worst);
    evidence.series = super::series::residuals(&setting, &judged, telling, false);
    if let Some(f) = clearest {
        let none = Bounded { value: 0.0, error: 0.0 };
        let absent = Measured { left: none, right: none, difference: none, magnitude: 0.0 };
        let m = group.signs[f.sign][f.comparison][f.time].as_ref().unwrap_or(&absent);
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
