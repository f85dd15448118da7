//! A claim with one of its assumptions left out.

use super::candidates::PROBE;
use crate::derivation::{Claim, Derivation};
use crate::findings::conditions::{AssumptionAccount, Need};
use crate::findings::{ClaimAccount, PairAccount};
use crate::latex::RelationKind;
use crate::verdict::{Outcome, Verdict};

/// A claim without one of its assumptions.
pub(super) struct Dropped {
    /// The claim.
    pub claim: Claim,
    /// The position of the whole claim in the account.
    pub of: usize,
    /// The name of the whole claim.
    pub whole: String,
    /// Which of its assumptions is left out.
    pub place: usize,
    /// The assumption.
    pub text: String,
    /// Whether it selects times.
    pub selects: bool,
}

/// Whether a verdict could become another one when an assumption is left out.
pub(super) fn is_open(verdict: &Verdict, selects: bool) -> bool {
    match verdict.outcome() {
        Outcome::NotApplicable(_) => true,
        // An inequality chooses the times that count: without it there may be more.
        Outcome::Holds(_) => selects && verdict.exclusions().next().is_some(),
        Outcome::Fails(_) | Outcome::Undecided => false,
    }
}

/// Whether a claim is tried without its assumptions: it holds wherever it applies and is decided, and does so somewhere.
pub(super) fn is_asked(found: &ClaimAccount) -> bool {
    let any = |want: fn(Outcome) -> bool| found.results.iter().any(|p| want(p.verdict.outcome()));
    any(|o| matches!(o, Outcome::Holds(_))) && !any(|o| matches!(o, Outcome::Fails(_)))
}

/// Most assumptions of a claim that is tried without each of them, and those of all such claims of a file together: each is there as often
/// as its claim has assumptions.
const MOST_ASSUMED: usize = 32;
const MOST_TOGETHER: usize = 100_000;

/// The claims at these positions, without each of their assumptions in turn.
pub(super) fn without_one(derivation: &Derivation, claimed: &[usize]) -> Vec<Dropped> {
    let (mut out, mut room) = (Vec::new(), MOST_TOGETHER);
    for (of, &c) in claimed.iter().enumerate() {
        let declared = &derivation.claims[c];
        let count = declared.assuming.len();
        let Some(left) = room.checked_sub(count * count).filter(|_| count <= MOST_ASSUMED) else { continue };
        room = left;
        for k in 0..count {
            let mut claim = declared.clone();
            let assumption = claim.assuming.remove(k);
            let selects = assumption.value.relations.iter().any(|r| r.kind != RelationKind::Equal);
            claim.id = format!("{PROBE}{of}/{k}");
            claim.reading = None;
            claim.follows_from.clear();
            out.push(Dropped { claim, of, whole: declared.name(), place: k, text: assumption.text, selects });
        }
    }
    out
}

/// What the verdicts without an assumption say of it.
pub(super) fn need(whole: &ClaimAccount, without: &[PairAccount], text: &str) -> AssumptionAccount {
    let before = |trajectory: &str| whole.on(trajectory).map(|p| &p.verdict);
    let (mut fails, mut holds, mut open) = (Vec::new(), Vec::new(), Vec::new());
    for pair in without {
        let name = pair.trajectory.clone();
        match pair.verdict.outcome() {
            Outcome::Fails(_) => fails.push(name),
            Outcome::Undecided => open.push(name),
            Outcome::NotApplicable(_) => {}
            Outcome::Holds(_) => {
                // Where it held before, it must hold at more times to say anything new.
                let more = before(&name).is_some_and(|v| pair.verdict.evidence().samples > v.evidence().samples);
                if more {
                    holds.push(name);
                }
            }
        }
    }
    let (need, on) = if !fails.is_empty() {
        (Need::Needed, fails)
    } else if !open.is_empty() {
        (Need::Undecided, open)
    } else if !holds.is_empty() {
        (Need::NotNeeded, holds)
    } else {
        (Need::Untested, Vec::new())
    };
    AssumptionAccount { text: text.to_owned(), need, on }
}
