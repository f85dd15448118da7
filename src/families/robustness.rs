//! Whether a verdict on a member would be the same with another estimate of its errors.
//!
//! **In:** the programs of claims; a verdict from errors that were estimated from the steps of a motion. **Out:** whether it counts.
//! **Guaranteed:** a claim that holds is not refuted by any bound that is up to 80 times narrower, and one that fails has a
//! point at which its sides are apart by more than the wide bound. What is said of anything else is not settled.

use crate::verdict::{Finding, Possible, Strength, Truth, Verdict};
use claim::program::{Part, Program, What};

/// What sides may be apart that are one within their error bound, as a share of it. A bound that refutes what is true by this one is
/// narrower by more than 80 times: a refutation takes ten of its bounds, see [`claim::comparison::GUARD`].
pub(super) const WELL_WITHIN: f64 = 0.125;

/// Whether what decides claims are comparisons at the times of one motion. Only of these is it said how much rests on error bounds.
pub(super) fn are_plain(programs: &[Vec<Program>]) -> bool {
    let compares = |part: &Part| {
        let of_times = matches!(part.what, What::Every | What::Denied | What::Constant | What::Value);
        of_times && part.group.formula.is_none()
    };
    let plain = |program: &Program| {
        let assumed = program.hypotheses.iter().map(|a| &a.part);
        program.at.is_none() && program.selectors.is_empty() && program.parts.iter().chain(assumed).all(compares)
    };
    programs.iter().flatten().all(plain)
}

/// Whether the verdict on a claim is the same for any sensible estimate of errors. What is true must not need that bounds are as large as
/// they are, and what is false must be apart by more than they are.
pub(super) fn is_settled(verdict: &Verdict, programs: &[Program]) -> bool {
    // A value that is only used by the part before it is neither true nor false.
    let says = |n: usize| !programs.iter().any(|p| p.parts.get(n).is_some_and(|part| matches!(part.what, What::Value)));
    let mut findings = verdict.findings().iter().enumerate().filter(|(n, _)| says(*n)).map(|(_, finding)| finding);
    let settled = |finding: &Finding| match finding.known(Strength::Sampled).and_then(Possible::decided) {
        Some(Truth::True) => finding.evidence().within <= WELL_WITHIN,
        Some(Truth::False) => finding.evidence().witness.as_ref().is_some_and(|w| w.difference() > w.bound),
        Some(Truth::Void) | None => false,
    };
    verdict.defect().is_some() || verdict.outcome().truth().is_some() && findings.all(settled)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::verdict::{Evidence, Witness};
    use reason::Plain;

    fn verdict(known: Possible, evidence: Evidence) -> Verdict {
        Verdict::of(Finding::sampled(known, evidence))
    }

    #[test]
    fn what_rests_on_a_wide_bound_is_not_settled() {
        let holds =
            |within| is_settled(&verdict(Possible::TRUE, Evidence { samples: 9, within, ..Evidence::default() }), &[]);
        assert!(holds(0.0) && holds(WELL_WITHIN));
        assert!(!holds(0.2) && !holds(1.0) && !holds(f64::INFINITY) && !holds(f64::NAN));
        let fails = |right: f64| {
            let formula = "x=y".to_owned();
            let witness = Witness { t: 0.0, formula, left: 1.0, right, bound: 0.25, values: Vec::new() };
            is_settled(&verdict(Possible::FALSE, Evidence { witness: Some(witness), ..Evidence::default() }), &[])
        };
        assert!(fails(2.0) && !fails(1.125) && !fails(1.25));
        assert!(!is_settled(&verdict(Possible::OPEN, Evidence::because(Plain::ValueOpen)), &[]));
        assert!(!is_settled(&verdict(Possible::VOID, Evidence::because(Plain::NoTimeCounts)), &[]));
    }
}
