//! One claim along one enclosed motion.

use super::cover::Along;
use super::rank::Rank;
use super::ready::{Ready, Shown};
use super::refute::certify;
use super::same::Same;
use super::{event, limit, span};
use crate::check::comparison::{Comparison, Group};
use crate::check::independence::Gradients;
use crate::check::program::{Program, Use};
use crate::check::verdict::{Evidence, Outcome, Strength, Verdict, Witness};
use crate::derivation::{Claim, Form};
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::Enclosure;
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

/// A part of a claim, ready to be looked at along a motion; or why it is not.
pub(super) enum Part<'a> {
    Comparisons(&'a Use, &'a Group, Result<Ready<'a>, String>),
    Rank(Result<Rank<'a>, String>),
    Same(Result<Box<Same<'a>>, String>),
}

/// The parts of a claim, or why there is nothing to look at.
pub(super) type Parts<'a> = Result<Vec<Part<'a>>, String>;

/// What a claim is prepared from.
pub(super) struct Asked<'a, 'r> {
    pub claim: &'a Claim,
    pub program: &'a Program,
    pub gradients: Option<&'a Result<Gradients, String>>,
    /// Parameters and initial states, as they are given.
    pub start: &'r [(Leaf, Expr)],
    /// Another motion, enclosed.
    pub other: &'r dyn Fn(usize, &mut Graph) -> Result<Enclosure, String>,
}

/// Tells a motion what a claim will ask for.
pub(super) fn prepare<'a>(asked: &Asked<'a, '_>, along: &mut Along, outcome: Outcome) -> Parts<'a> {
    let Asked { claim, program, gradients, .. } = *asked;
    let fails = matches!(outcome, Outcome::Fails(_));
    if let (false, Some(reason)) = (fails, along.incomplete()) {
        return Err(reason);
    }
    let ready = |(how, group): &'a (Use, Group), along: &mut Along| {
        Part::Comparisons(how, group, Ready::new(program, (how, group), along, claim))
    };
    let mut parts: Vec<Part> = program.groups.iter().map(|part| ready(part, along)).collect();
    for form in &claim.forms {
        match (form, gradients) {
            (Form::SameMotion { other, of }, _) => {
                parts.push(Part::Same(Same::new(asked, *other, of, along).map(Box::new)))
            }
            (Form::Independent { .. }, Some(Ok(gradients))) => {
                parts.push(Part::Rank(Rank::new(asked, gradients, along)))
            }
            (Form::Independent { .. }, Some(Err(reason))) => parts.push(Part::Rank(Err(reason.clone()))),
            _ => {}
        }
    }
    Ok(parts)
}

/// Strengthens one verdict.
///
/// # Errors
/// A contradiction between an enclosure and samples.
pub(super) fn strengthen(
    claim: &Claim,
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
        certify(parts, along, verdict);
        return Ok(());
    }
    along.refill();
    let mut reasons = Vec::new();
    for part in parts {
        let compared = match part {
            Part::Comparisons(_, group, _) => Some(group),
            Part::Rank(_) | Part::Same(_) => None,
        };
        let definedness = matches!(part, Part::Comparisons(Use::Defined, _, Ok(_)));
        let shown = match part {
            Part::Comparisons(how, _, Ok(mut ready)) => {
                ready.weigh(along);
                shown(claim, how, &ready, along)?
            }
            Part::Rank(Ok(rank)) => rank.always(along),
            Part::Same(Ok(same)) => same.always(along),
            Part::Comparisons(.., Err(reason)) | Part::Rank(Err(reason)) | Part::Same(Err(reason)) => {
                Shown::Nothing(reason)
            }
        };
        match shown {
            Shown::Holds(reason) => reasons.push(reason),
            Shown::Fails(witness, reason) => {
                let Witness { t, left, right, bound, .. } = witness;
                let same = compared.filter(|group| !group.branching);
                let same = same.and_then(|group| group.comparisons.iter().find(|c| c.label == witness.formula));
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
            Shown::Nothing(reason) if definedness => {
                // That there is a value everywhere is what was asked, and somewhere it is open.
                let reason = Some(format!("whether there is a value everywhere is open: {reason}"));
                *verdict = Verdict::new(Outcome::Undecided, Evidence { reason, ..verdict.evidence().clone() });
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

/// What is shown of comparisons, over the whole span.
fn shown(claim: &Claim, how: &Use, ready: &Ready, along: &mut Along) -> Result<Shown, String> {
    if let Err(reason) = ready.presupposed(along) {
        return Ok(Shown::Nothing(reason));
    }
    if let Some(event) = ready.event {
        return Ok(event::always(claim, how, ready, event, along));
    }
    match how {
        Use::Always => span::always(claim, ready, along),
        Use::Defined => Ok(span::defined(ready, along)),
        Use::Never(_) => Ok(span::never(ready, along)),
        Use::Eventually(_) => Ok(span::eventually(ready, along)),
        Use::Limit(point) => Ok(limit::limit(ready, point, along)),
    }
}
