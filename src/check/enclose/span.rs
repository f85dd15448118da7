//! What is shown over a whole span: that a claim holds at every time, at none, at some.

use super::cover::{Along, Judgement, Ranges};
use super::ready::{Ready, Shown, certain};
use crate::check::comparison::Comparison;
use crate::check::verdict::Witness;
use crate::derivation::Claim;
use crate::flow::Reach;
use crate::latex::RelationKind;
use crate::number::Interval;

/// Sides that differ for certain refute a claim that holds on samples only if they differ by this many times what the
/// precision allows.
const CLEARLY: f64 = 10.0;
/// Whether a quantity, continuous on a stretch, has opposite signs at its ends: then it vanishes between them.
pub(super) fn changes_sign(reach: &Reach, time: Interval) -> bool {
    let (a, b) = (reach.at(time.lo()), reach.at(time.hi()));
    (a.hi() < 0.0 && b.lo() > 0.0) || (a.lo() > 0.0 && b.hi() < 0.0)
}

pub(super) fn always(claim: &Claim, ready: &Ready, along: &mut Along) -> Result<Shown, String> {
    let (mut largest, mut counted) = (0.0_f64, 0);
    let mut serves = vec![true; ready.signs];
    let mut apart: Option<f64> = None;
    let mut doubt: Option<String> = None;
    let judge = |time: Interval, ranges: &Ranges| {
        let selected = ready.selected(ranges);
        if selected == Some(false) || (0..ready.signs).all(|s| ready.nowhere_defined(ranges, s)) {
            return Judgement::Settled;
        }
        // A sign that serves nowhere on the stretch, while the assumptions hold on all of it.
        let excluded = |s: usize| selected == Some(true) && ready.violated(ranges, s).is_some();
        if (0..ready.signs).all(excluded) {
            let size = |s: usize| {
                let reach = ready.violated(ranges, s).and_then(|c| ranges[ready.place(s, c)].as_ref().ok());
                reach.map_or(0.0, |r| r.range().mignitude())
            };
            let least = (0..ready.signs).map(size).fold(f64::INFINITY, f64::min);
            let why = format!(
                "at t = {:.6} the sides differ for certain, by at least {least:.1e}, which samples do not see",
                time.mid()
            );
            if least > CLEARLY * ready.precision * ready.scale {
                apart = Some(time.mid());
                return Judgement::Stop(why);
            }
            // Too little to refute what samples say; elsewhere it may be more.
            doubt.get_or_insert(why);
            return Judgement::Settled;
        }
        let each: Vec<Result<f64, String>> = (0..ready.signs).map(|s| ready.holds(ranges, s)).collect();
        let now: Vec<bool> = each.iter().map(Result::is_ok).collect();
        let best = each.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        if !now.contains(&true) {
            return Judgement::Open(each.into_iter().find_map(Result::err).unwrap_or_default());
        }
        serves.iter_mut().zip(now).for_each(|(s, n)| *s &= n);
        largest = largest.max(best);
        counted += 1;
        Judgement::Settled
    };
    let hopeless =
        |ranges: &Ranges| ready.selected(ranges) == Some(true) && (0..ready.signs).all(|s| ready.hopeless(ranges, s));
    let found = along.cover(&ready.roots, judge, hopeless);
    match (found, apart) {
        (Err(_), Some(t)) => Ok(match ready.witness(along, t, Vec::new()) {
            Some(witness) => Shown::Fails(witness, format!("certified at t = {t}")),
            None => Shown::Nothing(format!("near t = {t:.6} the sides differ")),
        }),
        (Err(reason), None) => Ok(Shown::Nothing(doubt.unwrap_or(reason))),
        (Ok(_), _) if doubt.is_some() => Ok(Shown::Nothing(doubt.unwrap_or_default())),
        (Ok(_), _) if counted == 0 => Ok(Shown::Nothing("no stretch of time is left by the assumptions".to_owned())),
        (Ok(_), _) if claim.branches_throughout && !serves.contains(&true) => {
            Ok(Shown::Nothing("no single sign of ± is shown to serve".to_owned()))
        }
        (Ok(looked), _) => {
            let equation = ready.group.comparisons.iter().any(|c| c.kind == RelationKind::Equal);
            let apart = if equation {
                format!(", within {largest:.1e} where terms are {:.1e}", ready.scale)
            } else {
                String::new()
            };
            Ok(Shown::Holds(format!("for every t of the span: in {looked} stretches{apart}")))
        }
    }
}

pub(super) fn defined(ready: &Ready, along: &mut Along) -> Shown {
    // The conditions among the comparisons say the same in other words.
    let judge = |_: Interval, ranges: &Ranges| {
        if ready.selected(ranges) == Some(false) {
            return Judgement::Settled;
        }
        for (c, comparison) in ready.group.comparisons.iter().enumerate() {
            if comparison.kind == RelationKind::Equal
                && let Err(reason) = &ranges[ready.place(0, c)]
            {
                return Judgement::Open(format!("`{}`: {reason}", comparison.label));
            }
        }
        Judgement::Settled
    };
    match along.cover(&ready.roots, judge, |_| false) {
        Ok(looked) => Shown::Holds(format!("for every t of the span: in {looked} stretches")),
        Err(reason) => Shown::Nothing(reason),
    }
}

pub(super) fn never(ready: &Ready, along: &mut Along) -> Shown {
    let judge = |_: Interval, ranges: &Ranges| {
        let gone = |s: usize| ready.violated(ranges, s).is_some() || ready.nowhere_defined(ranges, s);
        if ready.selected(ranges) == Some(false) || (0..ready.signs).all(gone) {
            return Judgement::Settled;
        }
        Judgement::Open("it cannot be excluded".to_owned())
    };
    match along.cover(&ready.roots, judge, |_| false) {
        Ok(looked) => Shown::Holds(format!("excluded for every t of the span: in {looked} stretches")),
        Err(reason) => Shown::Nothing(reason),
    }
}

/// That something never happens, though it should at some time.
fn excluded(ready: &Ready, along: &mut Along) -> Shown {
    let mut times: Vec<f64> = along.pieces().iter().map(Interval::lo).collect();
    times.push(along.span.1);
    for t in times {
        let ranges = along.over(&ready.roots, Interval::point(t));
        let Some(c) = ready.violated(&ranges, 0).filter(|_| ready.selected(&ranges) == Some(true)) else { continue };
        let place = ready.place(0, c);
        if let (Ok(reach), Some((left, right))) = (&ranges[place], ready.sides_at(along, t, place)) {
            let formula = ready.group.comparisons[c].label.clone();
            let (left, right, bound) = (left.mid(), right.mid(), reach.range().width());
            let witness = Witness { t, formula, left, right, bound, values: Vec::new() };
            return Shown::Fails(witness, "excluded at every time of the span".to_owned());
        }
    }
    Shown::Nothing("it does not happen, but there is no time to show at which the assumptions hold".to_owned())
}

pub(super) fn eventually(ready: &Ready, along: &mut Along) -> Shown {
    let single = match ready.group.comparisons.as_slice() {
        [Comparison { kind, .. }] if ready.signs == 1 => Some(*kind),
        _ => None,
    };
    let place = ready.place(0, 0);
    if single != Some(RelationKind::Equal) {
        for time in along.pieces().to_vec() {
            for t in [time.lo(), time.mid(), time.hi()] {
                if ready.certainly(&along.over(&ready.roots, Interval::point(t))) {
                    return Shown::Holds(format!("certain at t = {t}"));
                }
            }
        }
        return match never(ready, along) {
            Shown::Holds(_) => excluded(ready, along),
            _ => Shown::Nothing("at no time that was looked at is it certain, or excluded at all times".to_owned()),
        };
    }
    // Where it is exact, as at a start.
    let (from, to) = along.span;
    for t in [along.enclosure.initial_time(), from, to] {
        if from <= t && t <= to && ready.certainly(&along.over(&ready.roots, Interval::point(t))) {
            return Shown::Holds(format!("certain at t = {t}"));
        }
    }
    // Stretches without a zero, and stretches on which the difference is monotone and changes its sign: one zero each.
    let mut zeros: Vec<Interval> = Vec::new();
    let mut unselected = false;
    let judge = |time: Interval, ranges: &Ranges| {
        let Ok(reach) = &ranges[place] else { return Judgement::Open("it has no value".to_owned()) };
        let selected = ready.selected(ranges);
        if selected == Some(false) || certain(RelationKind::Equal, reach.range()) == Some(false) {
            return Judgement::Settled;
        }
        let slope = ready.slope.and_then(|at| ranges[at].as_ref().ok()).map(Reach::range);
        if slope.is_some_and(|s| !s.contains(0.0)) {
            let (a, b) = (reach.at(time.lo()), reach.at(time.hi()));
            if !a.contains(0.0) && !b.contains(0.0) {
                if changes_sign(reach, time) {
                    unselected |= selected != Some(true);
                    zeros.push(time);
                }
                return Judgement::Settled;
            }
        }
        Judgement::Open("whether it happens cannot be told".to_owned())
    };
    let found = along.cover(&ready.roots, judge, |_| false);
    let listed = || {
        let shown: Vec<String> = zeros.iter().take(4).map(|z| format!("[{:.6}, {:.6}]", z.lo(), z.hi())).collect();
        shown.join(", ")
    };
    match (&found, zeros.is_empty()) {
        (_, false) if unselected => Shown::Nothing("whether the assumptions hold there is not certain".to_owned()),
        (Ok(_), false) => Shown::Holds(format!("happens {} times, once in each of {}", zeros.len(), listed())),
        (Err(_), false) => Shown::Holds(format!("happens, in {}", listed())),
        (Ok(_), true) => excluded(ready, along),
        (Err(reason), true) => Shown::Nothing(reason.clone()),
    }
}
