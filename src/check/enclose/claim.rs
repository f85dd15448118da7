//! One claim along one enclosed motion.

use super::cover::Along;
use super::ready::{Ready, Shown};
use super::refute::certify;
use super::span;
use crate::check::comparison::Comparison;
use crate::check::program::{Program, Use};
use crate::check::verdict::{Evidence, Outcome, Strength, Verdict, Witness};
use crate::derivation::{Claim, Form};
use crate::number::Bounded;

/// How far two routes to the same residual may be apart, in units of the error bound of the sampled one.
const DISAGREEMENT: f64 = 100.0;

/// The residuals of all comparisons of a claim at a time, as samples see them: `None` for a comparison without a value.
pub(super) type Sampled<'a> = &'a dyn Fn(&Comparison, f64) -> Option<Bounded>;

/// Adds to a sampled verdict why it is not stronger.
pub(super) fn remark(verdict: &mut Verdict, reason: &str) {
    let outcome = verdict.outcome();
    let sampled = matches!(outcome, Outcome::Holds(Strength::Sampled) | Outcome::Fails(Strength::Sampled));
    if sampled || outcome == Outcome::Undecided {
        let before = verdict.evidence().reason.as_ref().map_or(String::new(), |r| format!("{r}; "));
        let reason = Some(format!("{before}not enclosed: {reason}"));
        *verdict = Verdict::new(outcome, Evidence { reason, ..verdict.evidence().clone() });
    }
}

/// The parts of a claim, each ready to be looked at along a motion; or why there is nothing to look at.
pub(super) type Parts<'a> = Result<Vec<Result<Ready<'a>, String>>, String>;

/// Tells a motion what a claim will ask for.
pub(super) fn prepare<'a>(claim: &Claim, program: &'a Program, along: &mut Along, outcome: Outcome) -> Parts<'a> {
    if claim.forms.iter().any(|f| matches!(f, Form::SameMotion { .. } | Form::Independent { .. })) {
        return Err("claims of this form are not enclosed".to_owned());
    }
    if program.at.is_some() {
        return Err("claims at events are not enclosed".to_owned());
    }
    let fails = matches!(outcome, Outcome::Fails(_));
    if let (false, Some(reason)) = (fails, along.incomplete()) {
        return Err(reason);
    }
    Ok(program.groups.iter().map(|(how, group)| Ready::new(program, (how, group), along, claim)).collect())
}

/// Strengthens one verdict.
///
/// # Errors
/// A contradiction between an enclosure and samples.
pub(super) fn strengthen(
    claim: &Claim,
    program: &Program,
    parts: Parts,
    along: &mut Along,
    sampled: Sampled,
    verdict: &mut Verdict,
) -> Result<(), String> {
    let outcome = verdict.outcome();
    if matches!(outcome, Outcome::NotApplicable | Outcome::Holds(Strength::Enclosed | Strength::Proved)) {
        return Ok(());
    }
    let parts = match parts {
        Ok(parts) => parts,
        Err(reason) => {
            remark(verdict, &reason);
            return Ok(());
        }
    };
    if let Outcome::Fails(_) = outcome {
        certify(program, parts, along, verdict);
        return Ok(());
    }
    along.refill();
    let mut reasons = Vec::new();
    for ((how, group), ready) in program.groups.iter().zip(parts) {
        let shown = match ready {
            Ok(mut ready) => {
                ready.weigh(along);
                part(claim, how, &ready, along)?
            }
            Err(reason) => Shown::Nothing(reason),
        };
        match shown {
            Shown::Holds(reason) => reasons.push(reason),
            Shown::Fails(witness, reason) => {
                let Witness { t, left, right, bound, .. } = witness;
                let same = group.comparisons.iter().find(|c| c.label == witness.formula).filter(|_| !group.branching);
                if let Some(seen) = same.and_then(|c| sampled(c, t)) {
                    // Between samples anything may happen; at one time both routes must find the same.
                    let (gap, size) = ((seen.value - (left - right)).abs(), left.abs() + right.abs());
                    if gap > DISAGREEMENT * (seen.error + bound + f64::EPSILON * size) {
                        return Err(format!(
                            "at t = {t} the sides differ by {} ± {:.1e} on the sampled motion, and by {} ± {bound:.1e} on \
                             the enclosed one",
                            seen.value,
                            seen.error,
                            left - right
                        ));
                    }
                }
                let evidence = Evidence { witness: Some(witness), reason: Some(reason), ..verdict.evidence().clone() };
                *verdict = Verdict::new(Outcome::Fails(Strength::Enclosed), evidence);
                return Ok(());
            }
            Shown::Nothing(reason) => {
                remark(verdict, &reason);
                return Ok(());
            }
        }
    }
    if reasons.is_empty() {
        return Ok(());
    }
    reasons.dedup();
    let samples = verdict.evidence().samples.max(1);
    let reason = match reasons.len() {
        1 => reasons.swap_remove(0),
        n => format!("{}; and {} more likewise", reasons[0], n - 1),
    };
    let evidence = Evidence { samples, reason: Some(reason), ..verdict.evidence().clone() };
    *verdict = Verdict::new(Outcome::Holds(Strength::Enclosed), evidence);
    Ok(())
}

/// One part of a claim, over the whole span.
fn part(claim: &Claim, how: &Use, ready: &Ready, along: &mut Along) -> Result<Shown, String> {
    if let Err(reason) = ready.presupposed(along) {
        return Ok(Shown::Nothing(reason));
    }
    match how {
        Use::Always => span::always(claim, ready, along),
        Use::Defined => Ok(span::defined(ready, along)),
        Use::Never(_) => Ok(span::never(ready, along)),
        Use::Eventually(_) => Ok(span::eventually(ready, along)),
        Use::Limit(point) => Ok(span::limit(ready, point, along)),
    }
}
