//! Parts of claims at events: at every time at which an expression vanishes.
//!
//! **All events are found.** The span is covered by stretches on which the expression e excludes 0, and stretches on which its
//! rate excludes 0 and the signs of e at the ends differ: there is exactly one zero in each of these (Bolzano, Rolle). It is
//! confined by the interval Newton operator, N = m − e(m)/ė(stretch), which contains every zero of the stretch
//! (Neumaier 1990, §5.1), and the claim is looked at on what is left. An event at which e only touches 0 is not settled by
//! any stretch, and leaves the claim as it was.

use super::cover::{Along, Judgement, Ranges};
use super::ready::{Ready, Shown, certain, changes_sign};
use crate::derivation::{Direction, Occasion};
use crate::flow::Reach;
use crate::latex::RelationKind;
use crate::number::{Interval, Scalar};
use crate::verdict::{Enclosed, Possible, Quantifier, Truth, Witness};
use claim::program::What;
use reason::{Enclosing, Place, Plain, Reason, Refutation};

/// Most steps of Newton's method for one event.
const STEPS: usize = 40;

/// Stretches with one event each, of those that are meant.
///
/// # Errors
/// The stretch on which there may be another one.
pub(super) fn events(ready: &Ready, (place, rate): (usize, usize), along: &mut Along) -> Result<Vec<Interval>, Reason> {
    let (mut found, mut ending) = (Vec::new(), Vec::new());
    // Events are counted, whether the assumptions are met at them or not.
    let all = !ready.occasion.is_any();
    let judge = |time: Interval, ranges: &Ranges| {
        if !all && ready.selected(ranges) == Some(false) {
            return Judgement::Settled;
        }
        let Ok(reach) = &ranges[place] else {
            return Judgement::Open(Plain::EventOpen.into());
        };
        if certain(RelationKind::Equal, reach.range()) == Some(false) {
            return Judgement::Settled;
        }
        let (a, b) = (reach.at(time.lo()), reach.at(time.hi()));
        let monotone = ranges[rate].as_ref().is_ok_and(|r| !r.range().contains(0.0));
        match (monotone, a.contains(0.0) || b.contains(0.0)) {
            (true, false) => {
                if changes_sign(reach, time) {
                    found.push(time);
                }
                return Judgement::Settled;
            }
            // Times of events are often round numbers, as the ends of stretches are.
            (true, true) if a.contains(0.0) != b.contains(0.0) => {
                ending.push(time);
                return Judgement::Settled;
            }
            (true, true) | (false, _) => {}
        }
        Judgement::Open(Plain::OneEventOpen.into())
    };
    along.cover(&ready.roots, judge, |_| false)?;
    for time in ending {
        if all && starts(ready, (place, rate), along, time) {
            continue;
        }
        let wider = widened(time, along.span);
        let ranges = along.over(&ready.roots, wider);
        let monotone = ranges[rate].as_ref().is_ok_and(|r| !r.range().contains(0.0));
        let mut sign = |t: f64| {
            let there = along.over(&ready.roots, Interval::point(t));
            there[place].as_ref().ok().map(Reach::range).filter(|r| !r.contains(0.0)).map(|r| r.lo() > 0.0)
        };
        match (sign(wider.lo()), sign(wider.hi())) {
            (Some(before), Some(after)) if monotone && before != after => found.push(wider),
            (Some(_), Some(_)) if monotone => {}
            _ => return Err(Enclosing::EventAtEnd(time.lo(), time.hi()).into()),
        }
    }
    let found = meant(ready, rate, along, united(found))?;
    Ok(found.into_iter().map(|time| confined(ready, (place, rate), along, time)).collect())
}

/// Whether the only event of a stretch is the start of the span, which is not counted: e is 0 there exactly, and monotone from
/// there on.
fn starts(ready: &Ready, (place, rate): (usize, usize), along: &mut Along, time: Interval) -> bool {
    let (from, _) = along.span;
    let here = along.over(&ready.roots, Interval::point(from));
    let exactly = here[place].as_ref().is_ok_and(|r| r.range() == Interval::point(0.0));
    let whole = along.over(&ready.roots, time);
    time.lo() == from && exactly && whole[rate].as_ref().is_ok_and(|r| !r.range().contains(0.0))
}

/// Those of all events, in order, that are meant.
///
/// # Errors
/// Which way an event is passed is not certain.
fn meant(ready: &Ready, rate: usize, along: &mut Along, found: Vec<Interval>) -> Result<Vec<Interval>, Reason> {
    let Occasion { direction, count } = ready.occasion;
    let mut out = Vec::new();
    for time in found {
        if let Some(wanted) = direction {
            let ranges = along.over(&ready.roots, time);
            let slope = ranges[rate].as_ref().map(|r| r.range()).ok().filter(|r| !r.contains(0.0));
            let Some(slope) = slope else {
                return Err(Enclosing::DirectionOpen(time.mid()).into());
            };
            let way = if slope.lo() > 0.0 { Direction::Up } else { Direction::Down };
            if way != wanted {
                continue;
            }
        }
        out.push(time);
    }
    let Some(count) = count else { return Ok(out) };
    let place = usize::try_from(count - 1).ok();
    Ok(place.and_then(|n| out.get(n).copied()).into_iter().collect())
}

/// A stretch with a quarter of its length added at each end, inside the span.
fn widened(time: Interval, (from, to): (f64, f64)) -> Interval {
    let more = 0.25 * time.width();
    Interval::new((time.lo() - more).max(from), (time.hi() + more).min(to)).unwrap_or(time)
}

/// Stretches with one event each, in order. On the union of two that overlap the expression is monotone: they have the same
/// event.
fn united(mut stretches: Vec<Interval>) -> Vec<Interval> {
    stretches.sort_by(|a, b| a.lo().total_cmp(&b.lo()));
    let mut united: Vec<Interval> = Vec::new();
    for next in stretches {
        match united.last_mut() {
            Some(last) if last.intersection(next).is_some_and(|common| !common.is_point()) => *last = last.hull(next),
            _ => united.push(next),
        }
    }
    united
}

/// The event of a stretch on which there is one.
fn confined(ready: &Ready, (place, rate): (usize, usize), along: &mut Along, stretch: Interval) -> Interval {
    let mut time = stretch;
    for _ in 0..STEPS {
        let middle = Interval::point(time.mid());
        let (there, whole) = (along.over(&ready.roots, middle), along.over(&ready.roots, time));
        let (Ok(value), Ok(slope)) = (&there[place], &whole[rate]) else { break };
        let newton = (middle - value.range() / slope.range()).checked();
        let Some(next) = newton.ok().and_then(|n| n.intersection(time)) else { break };
        let done = next.width() > 0.5 * time.width();
        time = next;
        if done || time.is_point() {
            break;
        }
    }
    time
}

/// That a part is true at all events.
pub(super) fn always(ready: &Ready, event: (usize, usize), along: &mut Along) -> Shown {
    match ready.part.what {
        What::Every | What::Denied | What::Defined => {}
        What::Constant
        | What::Value
        | What::Limit(_)
        | What::SameMotion(..)
        | What::Independent
        | What::Across
        | What::Unread(_) => {
            return Shown::Nothing(Plain::FormAtEvents.into());
        }
    }
    let events = match events(ready, event, along) {
        Ok(events) => events,
        Err(reason) => return Shown::Nothing(reason),
    };
    let (mut counted, mut void, mut serves, mut gap) = (0, 0, vec![true; ready.signs], 0.0_f64);
    for time in events {
        let ranges = along.over(&ready.roots, time);
        match ready.selected(&ranges) {
            Some(false) => continue,
            Some(true) => {}
            None => return Shown::Nothing(Enclosing::EventCounts(time.mid()).into()),
        }
        let known = ready.value(&ranges);
        if known == Possible::VOID {
            void += 1;
            continue;
        }
        if known == Possible::FALSE
            && let Some(witness) = ready.shown(along, &ranges, time.mid())
        {
            let reason = Refutation::AtEvent(witness.t).into();
            return Shown::Fails(witness, reason);
        }
        let each: Vec<Result<f64, Reason>> = (0..ready.signs).map(|s| ready.within(&ranges, s)).collect();
        let enough = match ready.group.signs {
            Quantifier::Some => each.iter().any(Result::is_ok),
            Quantifier::Every => each.iter().all(Result::is_ok),
        };
        if !enough || known.may_be(Truth::Void) {
            let why = each.iter().find_map(|e| e.as_ref().err().cloned()).unwrap_or(Plain::ValueOpen.into());
            let place = Place::Event { middle: time.mid(), from: time.lo(), to: time.hi() };
            return Shown::Nothing(why.placed(place));
        }
        gap = each.iter().flatten().copied().fold(f64::INFINITY, f64::min).max(gap);
        serves.iter_mut().zip(each).for_each(|(s, e)| *s &= e.is_ok());
        counted += 1;
    }
    if counted == 0 {
        return Shown::Void(match void {
            0 => Plain::NoEventCounts.into(),
            n => Enclosing::NoEventHasValue(n).into(),
        });
    }
    if ready.group.throughout && !serves.contains(&true) {
        return Shown::Nothing(Plain::NoSingleSignShown.into());
    }
    let reason = match counted {
        1 if ready.occasion.count.is_some() => Plain::CountedEvent.into(),
        1 => Plain::OnlyEvent.into(),
        n => Enclosing::AllEvents(n).into(),
    };
    Shown::Holds(Enclosed { places: counted, gap, scale: ready.scale }, reason)
}

/// An event at which a part is false for certain: where samples see one, or elsewhere.
///
/// # Errors
/// Why there is none.
pub(super) fn refuted(
    ready: &Ready,
    (place, rate): (usize, usize),
    along: &mut Along,
    near: f64,
) -> Result<Witness, Reason> {
    if !ready.occasion.is_any() {
        return Err(Plain::MeantFromAll.into());
    }
    // Around the event of the witness there need be no other: a change of sign is enough.
    let (from, to) = along.span;
    for part in [1e-9, 1e-7, 1e-5, 1e-3] {
        let (a, b) = ((near - part * (to - from)).max(from), (near + part * (to - from)).min(to));
        let Ok(mut time) = Interval::new(a, b) else { continue };
        let ranges = along.over(&ready.roots, time);
        let monotone = ranges[rate].as_ref().is_ok_and(|r| !r.range().contains(0.0));
        if !ranges[place].as_ref().is_ok_and(|reach| changes_sign(reach, time)) {
            continue;
        }
        if monotone {
            time = confined(ready, (place, rate), along, time);
        }
        let ranges = along.over(&ready.roots, time);
        if ready.selected(&ranges) == Some(true)
            && ready.value(&ranges) == Possible::FALSE
            && let Some(mut witness) = middle(ready, along, time.mid())
        {
            // How far the difference moves while the event is known only so well.
            let width = |c: usize| ranges[ready.place(0, c)].as_ref().map_or(0.0, |r| r.range().width());
            witness.bound = (0..ready.group.comparisons.len()).map(width).fold(witness.bound, f64::max);
            return Ok(witness);
        }
    }
    Err(Enclosing::NotExcludedAtEvent(near).into())
}

/// What is shown of the middle of an event.
fn middle(ready: &Ready, along: &mut Along, t: f64) -> Option<Witness> {
    let ranges = along.over(&ready.roots, Interval::point(t));
    ready.shown(along, &ranges, t)
}
