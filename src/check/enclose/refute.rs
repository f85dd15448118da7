//! What refutes a claim for certain.

use super::claim::{Part, remark};
use super::cover::Along;
use super::event;
use super::limit::limit;
use super::ready::{POINTS, Ready, Shown, certain};
use super::span::{changes_sign, eventually};
use crate::check::program::Use;
use crate::check::verdict::{Evidence, Outcome, Strength, Verdict, Witness};
use crate::latex::RelationKind;
use crate::number::Interval;

/// Looks for a time at which a claim that fails on samples fails for certain.
pub(super) fn certify(parts: Vec<Part>, along: &mut Along, verdict: &mut Verdict) {
    let Some(sampled) = verdict.evidence().witness.clone() else { return };
    along.refill();
    let mut why = "no part of it is refuted at the witness".to_owned();
    for part in parts {
        let found = match part {
            Part::Comparisons(how, _, ready) => ready.and_then(|mut ready| refuted(how, &mut ready, along, &sampled)),
            Part::Rank(rank) => rank.and_then(|rank| rank.refuted(along, &sampled)),
            Part::Same(same) => same.and_then(|same| same.refuted(along, &sampled)),
        };
        match found {
            Ok((witness, reason)) => {
                let evidence = Evidence { witness: Some(witness), reason: Some(reason), ..verdict.evidence().clone() };
                *verdict = Verdict::new(Outcome::Fails(Strength::Enclosed), evidence);
                return;
            }
            Err(reason) => why = reason,
        }
    }
    remark(verdict, &why);
}

/// The refutation of a part of a claim, and how it comes about.
fn refuted(how: &Use, ready: &mut Ready, along: &mut Along, sampled: &Witness) -> Result<(Witness, String), String> {
    ready.presupposed(along)?;
    let apart = |w: Witness| {
        let reason = format!("certified, the enclosures of the two sides lie apart: at t = {}", w.t);
        (w, reason)
    };
    if let Some(event) = ready.event {
        return event::refuted(how, ready, event, along, sampled).map(apart);
    }
    match how {
        Use::Always => differing(ready, along, sampled).map(apart),
        Use::Defined => undefined(ready, along, sampled).map(|w| {
            let reason = format!("certified at t = {}: no value exists there", w.t);
            (w, reason)
        }),
        Use::Never(_) => occurs(ready, along, sampled).map(apart),
        Use::Eventually(_) | Use::Limit(_) => {
            if let (Use::Eventually(_), Some(reason)) = (how, along.incomplete()) {
                return Err(reason);
            }
            ready.weigh(along);
            let shown = match how {
                Use::Limit(point) => limit(ready, point, along),
                _ => eventually(ready, along),
            };
            match shown {
                Shown::Fails(witness, reason) => Ok((witness, reason)),
                Shown::Holds(_) => Err("the enclosure does not exclude it".to_owned()),
                Shown::Nothing(reason) => Err(reason),
            }
        }
    }
}

/// A time at which the sides are apart for certain: that of the witness, or another.
fn differing(ready: &Ready, along: &mut Along, sampled: &Witness) -> Result<Witness, String> {
    if let Some(found) = ready.witness(along, sampled.t, sampled.values.clone()) {
        return Ok(found);
    }
    let every = along.pieces().len().div_ceil(POINTS).max(1);
    let times: Vec<f64> = along.pieces().iter().step_by(every).map(Interval::mid).collect();
    if ready.throughout {
        // Each sign fails somewhere.
        let near = [sampled.t].into_iter().chain(times.iter().copied());
        let against: Option<Vec<Witness>> =
            (0..ready.signs).map(|s| near.clone().find_map(|t| ready.witness_against(s, along, t))).collect();
        if let Some(first) = against.and_then(|found| found.into_iter().next()) {
            return Ok(first);
        }
    }
    let other = times.into_iter().find_map(|t| ready.witness(along, t, Vec::new()));
    other.ok_or_else(|| match along.incomplete() {
        Some(reason) => format!("at t = {} the enclosure does not exclude it: {reason}", sampled.t),
        None => format!("at t = {} the enclosure does not exclude it", sampled.t),
    })
}

/// That something has no value at the time of the witness.
fn undefined(ready: &Ready, along: &mut Along, sampled: &Witness) -> Result<Witness, String> {
    let ranges = along.over(&ready.roots, Interval::point(sampled.t));
    // Beside the quantities the group has the conditions under which they have values.
    let conditions = ready.group.comparisons.iter().enumerate().filter(|(_, c)| c.kind != RelationKind::Equal);
    let unmet = conditions.filter_map(|(c, comparison)| {
        let reach = ranges[ready.place(0, c)].as_ref().ok()?;
        certain(comparison.kind, reach.range())
    });
    let unmet = unmet.into_iter().any(|met| !met);
    if ready.selected(&ranges) == Some(true) && (unmet || ready.nowhere_defined(&ranges, 0)) {
        return Ok(sampled.clone());
    }
    Err(format!("that it has no value at t = {} is not certain", sampled.t))
}

/// That something which never happens does happen, near the time of a witness.
fn occurs(ready: &Ready, along: &mut Along, sampled: &Witness) -> Result<Witness, String> {
    let here = along.over(&ready.roots, Interval::point(sampled.t));
    if ready.certainly(&here) {
        return Ok(sampled.clone());
    }
    let ([comparison], 1) = (ready.group.comparisons.as_slice(), ready.signs) else {
        return Err("that several equations hold exactly at one time is not seen from bounds".to_owned());
    };
    let place = ready.place(0, 0);
    if comparison.kind != RelationKind::Equal {
        return Err("that it holds at the witness is not certain".to_owned());
    }
    let (from, to) = along.span;
    for part in [1e-9, 1e-7, 1e-5, 1e-3] {
        let (a, b) = ((sampled.t - part * (to - from)).max(from), (sampled.t + part * (to - from)).min(to));
        let Ok(time) = Interval::new(a, b) else { continue };
        let ranges = along.over(&ready.roots, time);
        if ready.selected(&ranges) == Some(true)
            && let Ok(reach) = &ranges[place]
            && changes_sign(reach, time)
        {
            return Ok(sampled.clone());
        }
    }
    Err("no change of sign was shown near the witness".to_owned())
}
