//! Weighing: from measured comparisons to what is known of a part of a claim.
//!
//! **In:** for every comparison and every time, both sides with their error bounds ([`MeasuredGroup`]). **Out:** a [`Finding`].
//!
//! The rules, in their order: a point that is not selected, or where nothing is said, is left out and named; when nothing is
//! left the part is void. One false point refutes. Points whose bound is too large to tell, and points at which it is false
//! and not known whether they are selected, are named too; more than two in a hundred of them, and nothing is known.

use crate::between::is_weak;
use crate::describe::{Left, Setting};
use crate::latex::RelationKind;
use crate::number::{Bounded, NoValue};
use crate::pointwise::{Pointwise, ratio, witness};
use crate::verdict::{Evidence, Exclusion, Finding, Possible, Residual, Truth};
use claim::sides::{Measured, MeasuredGroup};
use reason::{Plain, Reason, Sampling, Sign, SignRun, SignsAlong};
use std::sync::Arc;

/// Share of points whose bound may be too large, for a claim that holds at all others.
pub(super) const TOLERATED_INCONCLUSIVE: f64 = 0.02;

/// Most stretches of excluded times that are listed one by one.
const MOST_EXCLUSIONS: usize = 12;

/// Joins neighbouring excluded points with the same reason.
fn exclusions(times: &[f64], left: &[Left]) -> Vec<Exclusion> {
    let mut out: Vec<Exclusion> = Vec::new();
    let mut open: Option<&Arc<Reason>> = None;
    for (&t, l) in times.iter().zip(left) {
        match l {
            Left::In => open = None,
            Left::Out(reason) | Left::Open(reason) => {
                match (open, out.last_mut()) {
                    (Some(r), Some(last)) if r == reason => last.to = t,
                    _ => out.push(Exclusion { from: t, to: t, reason: Arc::clone(reason) }),
                }
                open = Some(reason);
            }
        }
    }
    if out.len() > MOST_EXCLUSIONS {
        let rest = out.split_off(MOST_EXCLUSIONS - 1);
        if let (Some(first), Some(last)) = (rest.first(), rest.last()) {
            let why = Sampling::MoreStretches { count: rest.len(), first: Arc::clone(&first.reason) };
            out.push(Exclusion { from: first.from, to: last.to, reason: Arc::new(why.into()) });
        }
    }
    out
}

/// The signs of ± along the motion, and a time at which one sign alone does not do.
struct Signs {
    along: Option<SignsAlong>,
    change: Option<(usize, usize)>,
}

/// Which sign of ± serves where. `standing[s][i]` with s = 0 for + and 1 for −.
fn signs(times: &[f64], left: &[Left], standing: &[Vec<Possible>]) -> Signs {
    if standing.len() < 2 {
        return Signs { along: None, change: None };
    }
    let mut runs: Vec<SignRun> = Vec::new();
    let mut first: [Option<usize>; 2] = [None, None];
    for i in 0..times.len() {
        if left[i] != Left::In {
            continue;
        }
        let only = match (standing[0][i], standing[1][i]) {
            (Possible::TRUE, Possible::FALSE) => 0,
            (Possible::FALSE, Possible::TRUE) => 1,
            _ => continue,
        };
        first[only].get_or_insert(i);
        let (sign, t) = ([Sign::Plus, Sign::Minus][only], times[i]);
        match runs.last_mut() {
            Some(run) if run.sign == sign => run.to = t,
            _ => runs.push(SignRun { sign, from: t, to: t }),
        }
    }
    Signs { along: Some(SignsAlong::of(runs)), change: first[0].zip(first[1]) }
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

/// The largest error bound within which the sides of a weak inequality agree at a time.
fn agreement(group: &MeasuredGroup, sign: usize, time: usize) -> Option<f64> {
    let each = group.group.comparisons.iter().zip(&group.signs[sign]).filter(|(c, _)| is_weak(c.kind));
    let agree = |d: &Bounded| d.error > 0.0 && d.contains_zero();
    each.filter_map(|(_, series)| series.difference(time).ok().filter(agree)).map(|d| d.error).reduce(f64::max)
}

/// Weighs a part of a claim that speaks of every time that counts.
pub(super) fn weigh(mut setting: Setting, group: &MeasuredGroup) -> Finding {
    let count = setting.times.len();
    let mut evidence = Evidence::default();
    let mut inconclusive: Option<Reason> = None;
    let mut inconclusive_count = 0;
    let mut leaps = false;
    let mut failures: Vec<Failure> = Vec::new();
    let mut worst: Option<(usize, usize)> = None;
    let mut largest = 0.0;
    let judged = Pointwise::new(group, setting.precision);
    let standing = &judged.whole;
    let fault = |c: usize, i: usize, reason| setting.describer.fault(&group.group.comparisons[c], i, reason);
    // What must differ is worth seeing where it comes closest.
    let apart = group.group.comparisons.iter().all(|c| c.kind == RelationKind::NotEqual);
    let any_weak = group.group.comparisons.iter().any(|c| is_weak(c.kind));

    // First where nothing is said: such points are left out.
    for (i, left) in setting.left.iter_mut().enumerate() {
        if let (Possible::VOID, Left::In | Left::Open(_)) = (judged.at(i), &*left) {
            let (c, reason) = judged.missing(0, i);
            *left = Left::Out(fault(c, i, reason));
        }
    }
    // One sign that serves throughout serves there, too.
    let each = group.group.throughout && group.signs.len() > 1;
    let open = |i: &usize| matches!(setting.left[*i], Left::Open(_)) && (each || judged.at(*i).may_be(Truth::False));
    let doubtful: Vec<usize> = (0..count).filter(open).collect();
    let counted: Vec<usize> = (0..count).filter(|&i| setting.left[i] == Left::In).collect();
    evidence.excluded = exclusions(setting.times, &setting.left);
    evidence.samples = counted.len();
    if let (true, Some(&i)) = (counted.is_empty(), doubtful.first()) {
        let Left::Open(reason) = &setting.left[i] else { return Finding::open(Plain::NoTimeKnownToCount) };
        evidence.reason = Some(Reason::clone(reason));
        return Finding::sampled(Possible::ANY, evidence);
    }
    // Times that may count, and at which it would be true.
    if let (true, Some(Left::Open(reason))) =
        (counted.is_empty(), setting.left.iter().find(|l| matches!(l, Left::Open(_))))
    {
        evidence.reason = Some(Reason::clone(reason));
        // What is asked of what lies between the samples, too, may be otherwise there.
        let between = setting.first || group.group.comparisons.iter().any(|c| c.kind != RelationKind::Equal);
        return Finding::sampled(if between { Possible::ANY } else { Possible::TRUE_OR_VOID }, evidence);
    }
    if counted.is_empty() {
        let reason = setting.left.iter().find_map(|l| match l {
            Left::Out(reason) | Left::Open(reason) => Some(Reason::clone(reason)),
            Left::In => None,
        });
        evidence.reason = Some(reason.unwrap_or(Plain::NoTimeToTry.into()));
        return Finding::sampled(Possible::VOID, evidence);
    }

    let sign = signs(setting.times, &setting.left, standing);
    evidence.branch = sign.along;
    for &i in &counted {
        let best = judged.sign(i);
        let c = judged.largest(best, i);
        let known = judged.at(i);
        let Ok(difference) = group.signs[best][c].difference(i) else {
            if known == Possible::FALSE {
                // A claim of definedness: there is no value to show, the reason is.
                evidence.reason.get_or_insert_with(|| Reason::clone(&fault(c, i, NoValue::OutOfDomain)));
                failures.push(Failure { size: 0.0, sign: best, comparison: c, time: i });
            } else if known.decided().is_none() {
                inconclusive_count += 1;
                leaps |= group.group.leaps();
                inconclusive.get_or_insert_with(|| {
                    let why = fault(c, i, group.signs[best][c].difference(i).err().unwrap_or(NoValue::Indeterminate));
                    Sampling::At(setting.times[i], why).into()
                });
            }
            continue;
        };
        let (size, bound) = (difference.value.abs(), difference.error);
        let worse = match &evidence.residual {
            None => true,
            Some(r) if apart => size < r.max,
            Some(_) => ratio(size, bound) > largest,
        };
        if worse && !group.group.asserted {
            largest = ratio(size, bound);
            evidence.residual = Some(Residual { max: size, bound, at: setting.times[i] });
            worst = Some((c, i));
        }
        match known.decided() {
            Some(truth @ (Truth::True | Truth::Void)) => {
                if truth == Truth::True {
                    evidence.within = evidence.within.max(judged.within(best, i));
                }
                if any_weak {
                    let slack = agreement(group, best, i);
                    evidence.slack = evidence.slack.into_iter().chain(slack).reduce(f64::max);
                }
            }
            None => {
                inconclusive_count += 1;
                inconclusive.get_or_insert_with(|| {
                    let (t, lost) = (setting.times[i], group.mute[best][c]);
                    Sampling::Differ { t, difference: difference.value, bound, lost }.into()
                });
            }
            Some(Truth::False) => {
                let off = |c: usize| group.signs[best][c].difference(i).map_or(0.0, |d| d.value.abs());
                let failed = |c: usize| Failure { size: off(c), sign: best, comparison: c, time: i };
                failures.extend(judged.worst(best, i).map(failed));
            }
        }
    }
    for &i in &doubtful {
        inconclusive_count += 1;
        let Left::Open(reason) = &setting.left[i] else { continue };
        inconclusive.get_or_insert_with(|| Sampling::FalseAt(setting.times[i], Arc::clone(reason)).into());
    }
    if let (true, Some((plus, minus))) = (group.group.throughout, sign.change) {
        // + alone serves at one time, − alone at another: refute with the later of the two, where the other fails.
        let (i, wrong) = if plus > minus { (plus, 1) } else { (minus, 0) };
        let c = judged.deciding(wrong, i);
        if let Ok(difference) = group.signs[wrong][c].difference(i) {
            failures.push(Failure { size: difference.value.abs(), sign: wrong, comparison: c, time: i });
            evidence.reason = Some(Plain::NoSingleSign.into());
        }
    }

    let clearest = match setting.first {
        true => failures.first().copied(),
        false => clearest(group, &failures),
    };
    let telling = clearest.as_ref().map(|f| (f.comparison, f.time)).or(worst);
    evidence.series = crate::series::residuals(&setting, &judged, telling, apart || setting.first);
    let shown = |f: &Failure| {
        let absent = Measured { left: 0.0, right: 0.0, difference: Bounded::exact(0.0) };
        let m = group.signs[f.sign][f.comparison].get(f.time).unwrap_or(absent);
        witness(&setting, &group.group.comparisons[f.comparison], f.time, m)
    };
    if let Some(f) = clearest {
        evidence.witness = Some(shown(&f));
        return Finding::sampled(Possible::FALSE, evidence);
    }
    if let (true, Some((comparison, time))) = (setting.first, worst) {
        // What never happens, though it should: where it comes closest.
        evidence.witness = Some(shown(&Failure { size: 0.0, sign: judged.sign(time), comparison, time }));
    }
    // That something has a value is claimed of every point: one that cannot tell leaves it open. So does one at which what
    // is compared may leap: its value there is none of those around it.
    let asserted = (group.group.asserted || leaps) && inconclusive_count > 0;
    if asserted || inconclusive_count as f64 > TOLERATED_INCONCLUSIVE * counted.len() as f64 {
        let example = Arc::new(inconclusive.unwrap_or(Plain::NoValueDetermined.into()));
        let lost = group.mute.iter().flatten().any(|&mute| mute);
        let (count, of) = (inconclusive_count, counted.len());
        evidence.reason = Some(Sampling::TooLarge { count, of, example, lost }.into());
        // One time at which it says something excludes that it says nothing.
        let says = counted.iter().any(|&i| !judged.at(i).may_be(Truth::Void));
        return Finding::sampled(if says { Possible::OPEN } else { Possible::ANY }, evidence);
    }
    evidence.samples = counted.len() - inconclusive_count.min(counted.len() - 1);
    if inconclusive_count > 0 {
        evidence.within = f64::INFINITY;
        evidence.reason = Some(Sampling::TooLargeElsewhere(inconclusive_count).into());
    }
    Finding::sampled(Possible::TRUE, evidence)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Graph;
    use crate::number::Draws;
    use claim::comparison::{Comparison, Group};
    use claim::sides::{Series, Sizes};

    #[test]
    fn the_clearest_failure_is_that_of_all() {
        let mut graph = Graph::default();
        let node = graph.integer(0);
        let label = String::new();
        let kind = RelationKind::Equal;
        let comparison = Comparison::measured(label, kind, node);
        let group = Group { comparisons: vec![comparison; 3], ..Group::default() };
        let mut draws = Draws::new(11);
        let mut sized_apart = 0;
        for _ in 0..200 {
            let mut number = |most: u64| draws.below(most) as f64 / 8.0;
            let (mut columns, mut sizes) = (Vec::new(), Vec::new());
            for _ in 0..3 {
                let mut series = Series::with_capacity(40);
                for _ in 0..40 {
                    let value = number(60) - 3.0;
                    series.push(Ok(Measured { left: value, right: 0.0, difference: Bounded::new(value, 1e-3) }));
                }
                columns.push(series);
                sizes.push((0..40).map(|_| number(40)).collect::<Vec<f64>>());
            }
            let known = (vec![Sizes::Known(sizes.into())], 0);
            let measured = MeasuredGroup::new(&group, vec![columns], known);
            let judged = Pointwise::new(&measured, 1e-9);
            let mut failures = Vec::new();
            for time in (0..40).filter(|&i| judged.whole[0][i] == Possible::FALSE) {
                let size = |c: usize| measured.signs[0][c].difference(time).unwrap().value.abs();
                failures.extend(judged.worst(0, time).map(|c| Failure { size: size(c), sign: 0, comparison: c, time }));
            }
            let scaled = |f: &Failure| f.size / measured.scale(0, f.comparison, f.time);
            let largest = failures.iter().map(scaled).fold(0.0, f64::max);
            let first = failures.iter().find(|f| scaled(f) == largest).unwrap().time;
            let last = failures.iter().rfind(|f| scaled(f) == largest && f.time == first).unwrap();
            let found = clearest(&measured, &failures).unwrap();
            assert_eq!((found.size, found.time, found.comparison), (largest, first, last.comparison));
            let furthest = failures.iter().max_by(|a, b| a.size.total_cmp(&b.size)).unwrap();
            sized_apart += usize::from(furthest.time != found.time);
        }
        assert!(sized_apart > 20, "the size of the terms decides: {sized_apart}");
    }

    #[test]
    fn what_a_weak_inequality_agrees_within_is_told_and_nothing_else() {
        let mut graph = Graph::default();
        let node = graph.integer(0);
        let at = |value, error| {
            let mut series = Series::with_capacity(1);
            series.push(Ok(Measured { left: value, right: 0.0, difference: Bounded { value, error } }));
            series
        };
        let of = |each: &[(RelationKind, f64, f64)]| {
            let comparisons = each.iter().map(|&(kind, ..)| Comparison::measured(String::new(), kind, node)).collect();
            let group = Group { comparisons, ..Group::default() };
            let series = each.iter().map(|&(_, value, error)| at(value, error)).collect();
            let sizes = (vec![Sizes::Known(vec![vec![1.0]; each.len()].into())], 0);
            agreement(&MeasuredGroup::new(&group, vec![series], sizes), 0, 0)
        };
        let (less, greater) = (RelationKind::LessEqual, RelationKind::GreaterEqual);
        assert_eq!(of(&[(less, 1e-16, 2e-16), (greater, 0.0, 3e-16), (less, -1.0, 0.5)]), Some(3e-16));
        assert_eq!(of(&[(less, -1e-3, 2e-16), (RelationKind::Equal, 0.0, 1e-16), (greater, 0.0, 0.0)]), None);
    }
}
