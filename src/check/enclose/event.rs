//! Claims at events: at every time at which an expression vanishes.
//!
//! **All events are found.** The span is covered by stretches on which the expression e excludes 0, and stretches on which its
//! rate excludes 0 and the signs of e at the ends differ: there is exactly one zero in each of these (Bolzano, Rolle). It is
//! confined by the interval Newton operator, N = m − e(m)/ė(stretch), which contains every zero of the stretch
//! (Neumaier 1990, §5.1), and the claim is looked at on what is left. An event at which e only touches 0 is not settled by
//! any stretch, and leaves the claim as it was.

use super::cover::{Along, Judgement, Ranges};
use super::ready::{Ready, Shown, certain};
use super::span::changes_sign;
use crate::check::program::Use;
use crate::check::verdict::Witness;
use crate::derivation::Claim;
use crate::latex::RelationKind;
use crate::number::{Interval, Scalar};

/// Most steps of Newton's method for one event.
const STEPS: usize = 40;

/// Stretches with one event each.
///
/// # Errors
/// The stretch on which there may be another one.
pub(super) fn events(ready: &Ready, (place, rate): (usize, usize), along: &mut Along) -> Result<Vec<Interval>, String> {
    let mut found = Vec::new();
    let judge = |time: Interval, ranges: &Ranges| {
        if ready.selected(ranges) == Some(false) {
            return Judgement::Settled;
        }
        let Ok(reach) = &ranges[place] else {
            return Judgement::Open("whether there is an event cannot be told".to_owned());
        };
        if certain(RelationKind::Equal, reach.range()) == Some(false) {
            return Judgement::Settled;
        }
        let (a, b) = (reach.at(time.lo()), reach.at(time.hi()));
        let monotone = ranges[rate].as_ref().is_ok_and(|r| !r.range().contains(0.0));
        if monotone && !a.contains(0.0) && !b.contains(0.0) {
            if changes_sign(reach, time) {
                found.push(time);
            }
            return Judgement::Settled;
        }
        Judgement::Open("whether there is an event, and one only, cannot be told".to_owned())
    };
    along.cover(&ready.roots, judge, |_| false)?;
    Ok(found.into_iter().map(|time| confined(ready, (place, rate), along, time)).collect())
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

/// That a claim holds at all events.
pub(super) fn always(claim: &Claim, how: &Use, ready: &Ready, event: (usize, usize), along: &mut Along) -> Shown {
    if !matches!(how, Use::Always) {
        return Shown::Nothing("a claim of this form at events is not enclosed".to_owned());
    }
    let events = match events(ready, event, along) {
        Ok(events) => events,
        Err(reason) => return Shown::Nothing(reason),
    };
    let (mut counted, mut serves) = (0, vec![true; ready.signs]);
    for time in events {
        let ranges = along.over(&ready.roots, time);
        match ready.selected(&ranges) {
            Some(false) => continue,
            Some(true) => {}
            None => return Shown::Nothing(format!("whether the event at t = {:.6} counts is not certain", time.mid())),
        }
        let each: Vec<Result<f64, String>> = (0..ready.signs).map(|s| ready.holds(&ranges, s)).collect();
        if let (false, Some(Err(reason))) = (each.iter().any(Result::is_ok), each.first()) {
            return Shown::Nothing(format!("{reason}, at the event at t = {:.6}", time.mid()));
        }
        serves.iter_mut().zip(each).for_each(|(s, e)| *s &= e.is_ok());
        counted += 1;
    }
    if counted == 0 {
        return Shown::Nothing("there is no event in the span".to_owned());
    }
    if claim.branches_throughout && !serves.contains(&true) {
        return Shown::Nothing("no single sign of ± is shown to serve".to_owned());
    }
    Shown::Holds(match counted {
        1 => "at the only event in the span".to_owned(),
        n => format!("at all {n} events in the span"),
    })
}

/// An event at which a claim fails for certain: where samples see one, or elsewhere.
///
/// # Errors
/// Why there is none.
pub(super) fn refuted(
    how: &Use,
    ready: &Ready,
    (place, rate): (usize, usize),
    along: &mut Along,
    sampled: &Witness,
) -> Result<Witness, String> {
    if !matches!(how, Use::Always) {
        return Err("a claim of this form at events is not enclosed".to_owned());
    }
    // Around the event of the witness there need be no other: a change of sign is enough.
    let (from, to) = along.span;
    for part in [1e-9, 1e-7, 1e-5, 1e-3] {
        let (a, b) = ((sampled.t - part * (to - from)).max(from), (sampled.t + part * (to - from)).min(to));
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
            && let Some(c) = (0..ready.signs).map(|s| ready.violated(&ranges, s)).collect::<Option<Vec<_>>>()
            && let (Some(&c), Ok(difference)) = (c.first(), &ranges[ready.place(0, *c.first().unwrap_or(&0))])
        {
            let Some((left, right)) = ready.sides_at(along, sampled.t, ready.place(0, c)) else { break };
            let (t, values, bound) = (sampled.t, sampled.values.clone(), difference.range().width());
            let formula = ready.group.comparisons[c].label.clone();
            return Ok(Witness { t, formula, left: left.mid(), right: right.mid(), bound, values });
        }
    }
    Err(format!("at the event at t = {} the enclosure does not exclude it", sampled.t))
}
