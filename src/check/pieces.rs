//! Pieces of a check: what ends one of them leaves it undecided, with the reason, and nothing else.
//!
//! **In:** a piece of work, see [`meter`]. **Out:** what it found; or a verdict, or a step, that is undecided because the piece [`Ended`].
//! Where that is a defect of the program, it is told at its claim, and the others have their verdicts.

use claim::limits::Limits;
use derivation::{Claim, Derivation};
use findings::IdentityAccount;
use meter::{Ended, Task};
use proved::step::Step;
use reason::Reason;
use verdict::Verdict;

/// The verdict on a claim, as far as the work of a piece goes; `open` is the one of which nothing is known, for a reason.
pub(super) fn verdict(
    task: Task,
    limits: &Limits,
    open: impl FnOnce(Reason) -> Verdict,
    find: impl FnOnce() -> Verdict,
) -> Verdict {
    meter::piece(task, limits, find).unwrap_or_else(|ended| undecided(open, ended))
}

/// The verdict on a claim where a piece ended before it was done.
pub(super) fn undecided(open: impl FnOnce(Reason) -> Verdict, ended: Ended) -> Verdict {
    let is_defect = matches!(ended, Ended::Defect(_));
    let reason: Reason = ended.into();
    let mut verdict = open(reason.clone());
    if is_defect {
        verdict.contradict(reason);
    }
    verdict
}

/// What a claim says for all values, as far as the work of a piece goes; or how the program contradicts itself.
pub(super) fn decided(
    derivation: &Derivation,
    claim: &Claim,
    limits: &Limits,
    decide: impl FnOnce() -> Option<Result<IdentityAccount, String>>,
) -> Option<Result<IdentityAccount, String>> {
    match meter::piece(Task::Proving, limits, decide) {
        Ok(found) => found,
        Err(Ended::Defect(what)) => Some(Err(format!("{}: {what}", claim.name()))),
        Err(ended) => {
            let (from, reason) = (Step::given(derivation, claim), Some(ended.into()));
            Some(Ok(IdentityAccount { from, reason, ..IdentityAccount::default() }))
        }
    }
}

/// The account of a step; where the program contradicts itself, it is undecided, and the defect is told there.
pub(super) fn account(
    derivation: &Derivation,
    claim: &Claim,
    found: Result<IdentityAccount, String>,
) -> IdentityAccount {
    found.unwrap_or_else(|what| {
        let (from, reason) = (Step::given(derivation, claim), Some(Ended::Defect(what).into()));
        IdentityAccount { from, reason, is_defect: true, ..IdentityAccount::default() }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use verdict::{Finding, Outcome};

    #[test]
    fn what_ends_a_piece_is_the_reason_of_its_verdict() {
        let limits = Limits::default();
        let open = |why: Reason| Verdict::of(Finding::open(why));
        let found = verdict(Task::Sampling, &limits, open, || {
            meter::charge(u64::MAX);
            Verdict::of(Finding::open(reason::Plain::NotLookedAt))
        });
        assert_eq!(found.outcome(), Outcome::Undecided);
        let reason = found.evidence().reason.as_ref().map(ToString::to_string).unwrap_or_default();
        assert!(
            reason.starts_with("work limit: trying a claim on a motion") && reason.contains("--work 10"),
            "{reason}"
        );
        assert!(found.defect().is_none());
        let broken = verdict(Task::Sampling, &limits, open, || std::panic::resume_unwind(Box::new("on purpose")));
        assert!(broken.outcome() == Outcome::Undecided && broken.defect().is_some());
    }
}
