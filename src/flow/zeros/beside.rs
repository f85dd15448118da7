//! What an expression does at a time at which it has no polynomial: beside a pole, an edge of its domain, a kink.
//!
//! **In:** values of the expression a little before such a time, and a little after. **Out:** whether it grows there, falls to 0, or may
//! vanish. What cannot be told is not said.

use super::super::cover::Explorer;
use super::super::incomplete::Incomplete;
use number::{Bounded, NoValue};

/// The stretch beside a time, as a share of the span, of which nothing is known where an expression turns.
const NEAR: f64 = 1e-8;

/// The size of the expression a little before and a little after a time, where it has a value.
fn beside(explorer: &mut Explorer, t: f64) -> [Option<f64>; 2] {
    let (from, to) = explorer.core.reach();
    let step = 1e-6 * (to - from);
    [t - step, t + step].map(|t| match explorer.values(t.clamp(from, to)).first() {
        Some(Ok(x)) => Some(x.value.abs()),
        _ => None,
    })
}

/// A pole as a gap of the search.
pub(super) fn pole(time: f64) -> Incomplete {
    Incomplete::NoValue { start: time, end: time, reason: NoValue::OutOfDomain }
}

/// A stretch outside of the domain.
pub(super) fn edge(gap: &Incomplete) -> Option<(f64, f64)> {
    matches!(gap, Incomplete::NoValue { reason: NoValue::OutOfDomain, .. }).then(|| gap.stretch())
}

/// Whether the expression falls to 0 towards an edge of its domain, from the side on which it has values; if it does, whether
/// in proportion to the distance.
pub(super) fn vanishes_towards(explorer: &mut Explorer, at: f64, onwards: bool) -> Option<bool> {
    let (from, to) = explorer.core.reach();
    let length = (to - from) * if onwards { 1.0 } else { -1.0 };
    // A power of the distance falls by the same factor at each step, whatever its size; a sum with a number does not.
    let mut sizes: Vec<f64> = Vec::new();
    for share in [1e-4, 1e-7, 1e-10, 1e-13] {
        let t = at + share * length;
        let value = (from..=to).contains(&t).then(|| explorer.values(t).first().copied());
        let Some(Some(Ok(x))) = value else { return None };
        if sizes.last().is_some_and(|last| x.value.abs() > 0.7 * last + x.error) {
            return None;
        }
        sizes.push(x.value.abs());
    }
    let ratio = sizes[2] / sizes[1];
    Some((0.3e-3..3e-3).contains(&ratio))
}

/// Where the expression goes on towards the other sign, nearer to a time than times are resolved: as a logarithm does, or a pole that
/// is subtracted from a large number. Towards something continuous it would go less and less.
pub(super) fn turns_towards(explorer: &mut Explorer, at: f64, onwards: bool) -> Option<Incomplete> {
    let (from, to) = explorer.core.reach();
    let length = (to - from) * if onwards { 1.0 } else { -1.0 };
    let mut values: Vec<Bounded> = Vec::new();
    for share in [1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
        let t = at + share * length;
        let value = (from..=to).contains(&t).then(|| explorer.values(t).first().copied())??;
        values.push(value.ok()?);
    }
    let moves: Vec<f64> = values.windows(2).map(|pair| pair[1].value - pair[0].value).collect();
    let clear = values.windows(2).zip(&moves).all(|(pair, by)| by.abs() > 4.0 * (pair[0].error + pair[1].error));
    let goes_on = moves.windows(2).all(|pair| pair[1] / pair[0] >= 0.25);
    let last = values.last().copied()?;
    let turns = last.contains_zero() || last.value * moves[0] < 0.0;
    // More than a point: what is so on both sides of it says nothing.
    let end = at + NEAR * length;
    (clear && goes_on && turns).then(|| Incomplete::Unresolved { start: at.min(end), end: at.max(end) })
}

/// Whether the expression grows towards a point from both sides: it has no value there, and no zero near.
pub(super) fn is_pole(explorer: &mut Explorer, (start, end): (f64, f64)) -> bool {
    let (from, to) = explorer.core.reach();
    let step = 1e-6 * (to - from);
    if end - start > 1e-6 * step {
        return false;
    }
    let mut grows = |near: f64, far: f64| match (explorer.values(near).first(), explorer.values(far).first()) {
        (Some(Ok(a)), Some(Ok(b))) => a.value.abs() > 10.0 * b.value.abs() + 10.0 * a.error,
        _ => false,
    };
    grows(start - step, start - 100.0 * step) && grows(end + step, end + 100.0 * step)
}

/// Whether the expression is so small at a kink, compared with its size beside it, that it may vanish there; `None` where too
/// few values are known: a root may end there, too, at an edge of its domain that is as near to a pole, or to an end of the
/// motion, as times are resolved.
pub(super) fn vanishes(explorer: &mut Explorer, kink: f64) -> Option<bool> {
    let here = explorer.values(kink).first().copied().and_then(Result::ok);
    let around = beside(explorer, kink);
    match here {
        Some(x) => {
            let largest = around.into_iter().flatten().reduce(f64::max)?;
            Some(x.value.abs() <= 1e-3 * largest + x.error)
        }
        // A pole, or a gap at one time with values around it: nothing that could be 0.
        None => around.iter().all(Option::is_some).then_some(false),
    }
}
