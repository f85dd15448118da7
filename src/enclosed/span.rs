//! What is shown over a whole span: that a part of a claim is true at every time that counts, or false at one.
//!
//! **In:** a part, ready to be looked at on stretches. **Out:** [`Shown`]. The span is taken apart until every stretch is
//! settled: its times do not count; or false is excluded on it; or it is false for certain at a time of it. A place at which it is
//! false for certain stands against every allowance, however small the difference is.

use std::sync::Arc;

use super::cover::{Along, Judgement, Ranges, Selection};
use super::ready::{Ready, Shown, median, spread};
use crate::latex::RelationKind;
use crate::number::{Interval, NoValue};
use crate::verdict::{Enclosed, Possible, Quantifier, Truth, Witness};
use reason::{Enclosing, Plain, Reason, Refutation};

/// So many times are looked at to see whether an open stretch stands alone.
const LOOKS: usize = 16;
/// So often the time is narrowed at which an inequality is farthest from what it says.
const HALVINGS: usize = 40;

/// What a cover of the span found.
#[derive(Default)]
struct Covered {
    /// The largest |left − right| that is not excluded.
    gap: f64,
    /// The stretch on which that is.
    widest: Option<Interval>,
    /// Whether it says something on a stretch: it is true there, and all times count.
    says: bool,
    /// Whether anything but void is possible on a stretch that may count.
    may_say: bool,
    /// The stretch that was looked at last and is not settled.
    open: Option<Interval>,
    /// A stretch on which it is false at some time that counts.
    apart: Option<Interval>,
    /// Which signs of ± serve so far.
    serves: Vec<bool>,
}

/// That a part is true at every time that counts.
pub(super) fn always(ready: &Ready, along: &mut Along) -> Shown {
    let mut found = Covered { serves: vec![true; ready.signs], ..Covered::default() };
    let judge = |time: Interval, ranges: &Ranges| {
        let selected = ready.selected(ranges);
        let known = ready.value(ranges);
        if selected == Some(false) || known == Possible::VOID {
            return Judgement::Settled;
        }
        if selected == Some(true) && (known == Possible::FALSE || ready.crosses(ranges, time)) {
            found.apart = Some(time);
            return Judgement::Stop(Plain::FalseForCertain.into());
        }
        let each: Vec<Result<f64, Reason>> = (0..ready.signs).map(|s| ready.within(ranges, s)).collect();
        let now: Vec<bool> = each.iter().map(Result::is_ok).collect();
        let enough = match ready.group.signs {
            Quantifier::Some => now.contains(&true),
            Quantifier::Every => now.iter().all(|n| *n),
        };
        if !enough {
            found.open = Some(time);
            return Judgement::Open(each.into_iter().find_map(Result::err).unwrap_or(Plain::ValueOpen.into()));
        }
        // What a whole stretch leaves open its parts may settle.
        found.may_say = true;
        found.says |= selected == Some(true) && !known.may_be(Truth::Void);
        let gap = each.into_iter().flatten().fold(f64::INFINITY, f64::min);
        if gap > found.gap {
            (found.gap, found.widest) = (gap, Some(time));
        }
        found.serves.iter_mut().zip(now).for_each(|(s, n)| *s &= n);
        Judgement::Settled
    };
    let hopeless =
        |ranges: &Ranges| ready.selected(ranges) == Some(true) && (0..ready.signs).all(|s| ready.hopeless(ranges, s));
    let covered = along.cover(&ready.roots, judge, hopeless);
    if let Some(time) = found.apart {
        return match false_on(ready, along, time) {
            Some(witness) => {
                let reason = Refutation::At(witness.t).into();
                Shown::Fails(witness, reason)
            }
            None => Shown::Nothing(Enclosing::DifferNear(time.mid()).into()),
        };
    }
    let looked = match covered {
        Ok(looked) => looked,
        // It may be false for certain at single times that are known exactly.
        Err(reason) => {
            let open = found.open.iter().flat_map(|time| [time.mid(), time.lo(), time.hi()]);
            let times: Vec<f64> = open.chain(exact_times(along)).collect();
            return match times.into_iter().find_map(|t| ready.witness(along, t)) {
                Some(witness) => {
                    let reason = Refutation::At(witness.t).into();
                    Shown::Fails(witness, reason)
                }
                None => alone(along, &ready.roots, reason, |ranges| {
                    is_silent(ready, ranges) || (0..ready.signs).any(|s| ready.within(ranges, s).is_ok())
                }),
            };
        }
    };
    if ready.group.throughout && ready.signs > 1 && !found.serves.contains(&true) {
        return match against_each_sign(ready, along, &[]) {
            Some(witness) => Shown::Fails(witness, Plain::NoSingleSign.into()),
            None => Shown::Nothing(Plain::NoSingleSignShown.into()),
        };
    }
    if !found.may_say {
        return Shown::Void(Plain::NeverHasValue.into());
    }
    // An inequality may be false for certain by less than is allowed.
    if let Some(witness) = found.widest.and_then(|time| beyond(ready, along, time)) {
        let reason = Refutation::At(witness.t).into();
        return Shown::Fails(witness, reason);
    }
    let enclosed = Enclosed { places: looked, gap: found.gap, scale: ready.scale };
    let equation = ready.group.comparisons.iter().any(|c| c.kind == RelationKind::Equal);
    let within = found.gap > 0.0 || equation && ready.part.allows();
    let within = within.then_some((found.gap, ready.scale));
    let reason = Enclosing::EveryTime { stretches: looked, within }.into();
    match found.says || says_at_a_time(ready, along) {
        true => Shown::Holds(enclosed, reason),
        false => Shown::Unless(enclosed, reason),
    }
}

/// A time of a stretch at which an inequality is false for certain: where its sides go farthest beyond one another.
fn beyond(ready: &Ready, along: &mut Along, stretch: Interval) -> Option<Witness> {
    let comparisons = ready.group.comparisons.iter().enumerate();
    let weak: Vec<(usize, f64)> = comparisons
        .filter_map(|(c, comparison)| match comparison.kind {
            RelationKind::LessEqual => Some((c, 1.0)),
            RelationKind::GreaterEqual => Some((c, -1.0)),
            RelationKind::Equal | RelationKind::NotEqual | RelationKind::Less | RelationKind::Greater => None,
        })
        .collect();
    let places = (0..ready.signs).flat_map(|s| weak.iter().map(move |&(c, sign)| (ready.place(s, c), sign)));
    places.collect::<Vec<_>>().into_iter().find_map(|(place, sign)| {
        let mut over = |t: f64| {
            let ranges = along.over(&ready.roots, Interval::point(t));
            ranges[place].as_ref().map_or(f64::NEG_INFINITY, |reach| sign * reach.range().mid())
        };
        // The farthest of a few times, then between its neighbours.
        let at = |k: usize| stretch.lo() + stretch.width() * k as f64 / LOOKS as f64;
        let most = (0..=LOOKS).max_by(|&a, &b| over(at(a)).total_cmp(&over(at(b))))?;
        let (mut low, mut high) = (at(most.saturating_sub(1)), at((most + 1).min(LOOKS)));
        for _ in 0..HALVINGS {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if over(a) < over(b) { low = a } else { high = b }
        }
        [at(most), 0.5 * (low + high)].into_iter().find_map(|t| ready.witness(along, t))
    })
}

/// Whether a part says nothing at the times of these ranges: they do not count, or it has no value.
fn is_silent(ready: &Ready, ranges: &Ranges) -> bool {
    ready.selected(ranges) == Some(false) || ready.value(ranges) == Possible::VOID
}

/// What is shown where one stretch stays open: whether nearly all single times are settled.
pub(super) fn alone(
    along: &mut Along,
    roots: &Selection,
    reason: Reason,
    is_settled: impl Fn(&Ranges) -> bool,
) -> Shown {
    let every = along.pieces().len().div_ceil(LOOKS).max(1);
    let times: Vec<f64> = along.pieces().iter().step_by(every).map(|time| 0.3 * time.lo() + 0.7 * time.hi()).collect();
    let settled = times.iter().filter(|&&t| is_settled(&along.over(roots, Interval::point(t)))).count();
    if 4 * settled >= 3 * times.len() { Shown::Isolated(reason) } else { Shown::Nothing(reason) }
}

/// That a part says nothing at any time; or at no time but perhaps single ones.
pub(super) fn silent(ready: &Ready, along: &mut Along, shown: Shown) -> Shown {
    let judge = |_: Interval, ranges: &Ranges| match is_silent(ready, ranges) {
        true => Judgement::Settled,
        false => Judgement::Open(Plain::WhetherTimesCountOpen.into()),
    };
    match along.cover(&ready.roots, judge, |_| false) {
        Ok(_) => Shown::Void(Plain::NeverHasValue.into()),
        Err(reason) => match alone(along, &ready.roots, reason, |ranges| is_silent(ready, ranges)) {
            Shown::Isolated(reason) => Shown::Isolated(reason),
            _ => shown,
        },
    }
}

/// Times that are known exactly: where the motion starts, and the ends of the span.
fn exact_times(along: &Along) -> Vec<f64> {
    let (from, to) = along.span;
    [along.enclosure.initial_time(), from, to].into_iter().filter(|t| (from..=to).contains(t)).collect()
}

/// Whether some time of the span counts: for certain, for certain not, or unknown.
pub(super) fn counts(ready: &Ready, event: Option<(usize, usize)>, along: &mut Along) -> Option<bool> {
    if !ready.is_restricted() {
        return Some(true);
    }
    if let Some(event) = event {
        let mut all = Some(false);
        for time in super::event::events(ready, event, along).ok()? {
            match ready.selected(&along.over(&ready.roots, time)) {
                Some(true) => return Some(true),
                Some(false) => {}
                None => all = None,
            }
        }
        return all;
    }
    let mut may = false;
    for time in along.pieces().to_vec() {
        match ready.selected(&along.over(&ready.roots, time)) {
            Some(true) => return Some(true),
            Some(false) => {}
            None => may = true,
        }
        if ready.selected(&along.over(&ready.roots, Interval::point(time.mid()))) == Some(true) {
            return Some(true);
        }
    }
    if may { None } else { Some(false) }
}

/// Whether the part has a value at some time that counts.
fn says_at_a_time(ready: &Ready, along: &mut Along) -> bool {
    let mut times: Vec<f64> = spread(along).iter().map(Interval::mid).collect();
    times.extend(exact_times(along));
    times.into_iter().any(|t| {
        let ranges = along.over(&ready.roots, Interval::point(t));
        ready.selected(&ranges) == Some(true) && !ready.value(&ranges).may_be(Truth::Void)
    })
}

/// A time of a stretch on which the part is false at some time that counts, with what can be shown of it.
fn false_on(ready: &Ready, along: &mut Along, time: Interval) -> Option<Witness> {
    if let Some(witness) = [time.mid(), time.lo(), time.hi()].into_iter().find_map(|t| ready.witness(along, t)) {
        return Some(witness);
    }
    // The sides meet on the stretch: it is halved as long as that is seen.
    let mut time = time;
    for _ in 0..60 {
        let middle = time.mid();
        let halves = [Interval::new(time.lo(), middle), Interval::new(middle, time.hi())];
        let next = halves.into_iter().flatten().filter(|half| half.width() > 0.0).find(|half| {
            let ranges = along.over(&ready.roots, *half);
            ready.selected(&ranges) == Some(true)
                && (ready.value(&ranges) == Possible::FALSE || ready.crosses(&ranges, *half))
        });
        match next {
            Some(half) if half.width() < time.width() => time = half,
            _ => break,
        }
    }
    let t = time.mid();
    let ranges = along.over(&ready.roots, Interval::point(t));
    let mut witness = ready.shown(along, &ranges, t)?;
    // How far the sides can be apart, at a time that is known only so well.
    witness.bound = witness.bound.max((witness.left - witness.right).abs());
    Some(witness)
}

/// Times at which each sign of ± fails: the last of them.
fn against_each_sign(ready: &Ready, along: &mut Along, near: &[f64]) -> Option<Witness> {
    let mut times: Vec<f64> = near.to_vec();
    times.extend(spread(along).iter().map(Interval::mid));
    let against: Option<Vec<Witness>> =
        (0..ready.signs).map(|s| times.iter().find_map(|&t| ready.witness_against(s, along, t))).collect();
    against?.into_iter().max_by(|a, b| a.t.total_cmp(&b.t))
}

/// A time at which the part is false for certain: near those that samples point to, or elsewhere.
pub(super) fn refuted(ready: &Ready, along: &mut Along, near: f64) -> Result<Witness, Reason> {
    if let Some(found) = ready.witness(along, near) {
        return Ok(found);
    }
    // A change of sign around the time that samples found.
    let (from, to) = along.span;
    for part in [1e-9, 1e-7, 1e-5, 1e-3] {
        let (a, b) = ((near - part * (to - from)).max(from), (near + part * (to - from)).min(to));
        let Ok(time) = Interval::new(a, b) else { continue };
        let ranges = along.over(&ready.roots, time);
        if ready.selected(&ranges) == Some(true)
            && ready.crosses(&ranges, time)
            && let Some(found) = false_on(ready, along, time)
        {
            return Ok(found);
        }
    }
    let mut times = exact_times(along);
    times.extend(spread(along).iter().map(Interval::mid));
    if let Some(found) = times.iter().find_map(|&t| ready.witness(along, t)) {
        return Ok(found);
    }
    if ready.group.throughout
        && ready.signs > 1
        && let Some(found) = against_each_sign(ready, along, &[near])
    {
        return Ok(found);
    }
    Err(Enclosing::NotExcluded(near, along.incomplete().map(Arc::new)).into())
}

/// A time that counts, with both sides of a component in which they differ, where there is one: for what never happens though it should.
pub(super) fn some_time(ready: &Ready, along: &mut Along) -> Option<Witness> {
    let mut times = exact_times(along);
    times.extend(along.pieces().iter().map(Interval::mid));
    times.into_iter().find_map(|t| {
        let ranges = along.over(&ready.roots, Interval::point(t));
        if ready.selected(&ranges) != Some(true) {
            return None;
        }
        let component = ready.violated(&ranges, 0).unwrap_or(0);
        let (left, right) = ready.sides_at(along, t, ready.place(0, component))?;
        let (formula, bound) = (ready.group.comparisons.get(component)?.label.clone(), left.width() + right.width());
        Some(Witness { t, formula, left: left.mid(), right: right.mid(), bound, values: Vec::new() })
    })
}

/// A bound of a value, and the time at which it is known.
type Bound = Option<(f64, f64)>;

/// That quantities are the same at all times that count, whichever these are: their ranges over all of them.
pub(super) fn constant(ready: &Ready, along: &mut Along) -> Shown {
    let count = ready.group.comparisons.len();
    let points = super::ready::at_middles(along);
    let size = |c: usize| {
        let place = ready.sides[3 * ready.place(0, c)];
        let sizes = points.iter().filter_map(|p| p.get(place)?.as_ref().ok().map(Interval::magnitude));
        median(sizes.collect())
    };
    let scale = (0..count).map(size).fold(0.0, f64::max);
    let room = ready.precision * if scale > 0.0 { scale } else { 1.0 };
    if ready.signs > 1 {
        return Shown::Nothing(Plain::ConstantOfOneSign.into());
    }
    // For each quantity the hull over all stretches that may count, and what it is for certain at times that do.
    let mut hulls: Vec<Option<Interval>> = vec![None; count];
    let mut certain: Vec<(Bound, Bound)> = vec![(None, None); count];
    let mut says = false;
    let judge = |time: Interval, ranges: &Ranges| {
        let selected = ready.selected(ranges);
        if selected == Some(false) {
            return Judgement::Settled;
        }
        let mut void = true;
        for c in 0..count {
            match &ranges[ready.place(0, c)] {
                Err(NoValue::OutOfDomain) => {}
                Err(reason) => return Judgement::Open(Enclosing::ValueUnknown(*reason).into()),
                Ok(reach) => {
                    void = false;
                    let range = reach.range();
                    if selected == Some(true) {
                        let (low, high) = &mut certain[c];
                        if high.is_none_or(|(h, _)| range.lo() > h) {
                            *high = Some((range.lo(), time.mid()));
                        }
                        if low.is_none_or(|(l, _)| range.hi() < l) {
                            *low = Some((range.hi(), time.mid()));
                        }
                        if let (Some((l, _)), Some((h, _))) = (*low, *high)
                            && h > l
                        {
                            return Judgement::Stop(Plain::TwoValuesForCertain.into());
                        }
                    }
                    if range.width() > room {
                        return Judgement::Open(Enclosing::KnownWithin(range.width()).into());
                    }
                    hulls[c] = Some(hulls[c].map_or(range, |h| h.hull(range)));
                }
            }
        }
        says |= selected == Some(true) && !void;
        Judgement::Settled
    };
    let covered = along.cover(&ready.roots, judge, |_| false);
    for (c, (low, high)) in certain.iter().enumerate() {
        if let (Some((l, at_low)), Some((h, at_high))) = (low, high)
            && h > l
        {
            let (first, last) = (at_low.min(*at_high), at_low.max(*at_high));
            let value = |t: f64| {
                let sides = ready.sides_at(along, t, ready.place(0, c));
                sides.map(|(left, _)| left.mid())
            };
            if let (Some(right), Some(left)) = (value(first), value(last)) {
                let formula = format!("{}, compared with t = {first}", ready.group.comparisons[c].label);
                let witness = Witness { t: last, formula, left, right, bound: 0.0, values: Vec::new() };
                return Shown::Fails(witness, Refutation::TwoValues(first, last).into());
            }
        }
    }
    let looked = match covered {
        Ok(looked) => looked,
        Err(reason) => return Shown::Nothing(reason),
    };
    let gap = hulls.iter().flatten().map(Interval::width).fold(0.0, f64::max);
    // A component without a value leaves the others without a say.
    if hulls.iter().any(Option::is_none) {
        return Shown::Void(Plain::NeverHasValue.into());
    }
    if gap > room {
        return Shown::Nothing(Enclosing::KnownWithin(gap).into());
    }
    let reason = Enclosing::EveryTime { stretches: looked, within: Some((gap, scale)) }.into();
    let enclosed = Enclosed { places: looked, gap, scale };
    if says { Shown::Holds(enclosed, reason) } else { Shown::Unless(enclosed, reason) }
}
