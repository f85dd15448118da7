//! Claims of which only the premises have changed.
//!
//! **In:** the accounts of an earlier state of a file, and claims that say what they said, but follow from something else now.
//! **Out:** their accounts as a check of the whole file would give them, apart from the strength of the verdicts, see
//! [`strengthen_all`]; and the claims for which more than the proof depends on the premises.
//!
//! What a premise says matters for the proof, for motions that refute the step, and for the strength of the verdicts; verdicts on
//! motions, conditions and altered formulas do not know of it. Only the search for what a false claim should have said asks
//! whether its finds follow, so claims with such a search are left to a check.

use rayon::prelude::*;

use super::memory::{Known as Recalled, Question};
use super::pieces;
use super::premises::{Accounts, Column, counterexample, refuted_on, replay, strengthen};
use crate::derivation::{Claim, Derivation};
use claim::limits::Limits;
use findings::{ClaimAccount, IdentityAccount};
use proved::step::Step;
use sampled::selection::Selection;

/// What becomes of claims whose premises have changed.
pub(super) struct Followed {
    /// The accounts, with verdicts as the motions give them.
    pub(super) claims: Vec<ClaimAccount>,
    /// The ids of the claims that have to be checked.
    pub(super) rest: Vec<String>,
}

/// Claims, by their positions, whose premises have changed; `known` has the accounts of all others, `before` those of an earlier
/// state of the file.
pub(super) fn follow(
    derivation: &Derivation,
    following: &[usize],
    known: &[ClaimAccount],
    before: &[ClaimAccount],
    (limits, recall): (&Limits, Recalled),
) -> Followed {
    let claim = |&c: &usize| &derivation.claims[c];
    let before = Accounts::of(before);
    let known = Accounts::of(known);
    let mut rest: Vec<String> = Vec::new();
    let mut accounts: Vec<Option<ClaimAccount>> = Vec::new();
    for claim in following.iter().map(claim) {
        let account = unproved(derivation, claim, &before, recall);
        if account.is_none() && !rest.contains(&claim.id) {
            rest.push(claim.id.clone());
        }
        accounts.push(account);
    }
    // Every reading of a claim is checked, or none.
    for account in &mut accounts {
        *account = account.take().filter(|a| !rest.contains(&a.id));
    }
    // Verdicts on motions are what they were, also those of the claims that are left to a check.
    let selection = everywhere(derivation, following.to_vec());
    let of = |claim: &Claim| before.get(claim);
    let earlier: Vec<Option<&ClaimAccount>> = following.iter().map(claim).map(of).collect();
    let on = |account: &Option<&ClaimAccount>, t: usize| {
        let id = &derivation.trajectories[t].id;
        account.and_then(|a| a.on(id)).map(|r| r.verdict.clone())
    };
    let column = |&t: &usize| -> Column { earlier.iter().map(|account| on(account, t)).collect() };
    let columns: Vec<Column> = selection.tried.iter().map(column).collect();
    let identity = |k: usize| -> Option<Result<IdentityAccount, String>> {
        accounts[k].as_ref()?;
        let claim = &derivation.claims[following[k]];
        let step = Step::of(derivation, claim)?;
        match counterexample(derivation, &selection, k, &known, &columns) {
            Some((t, witness)) => Some(refuted_on(&step, (&derivation.trajectories[t].id, witness), k, &columns)),
            None => recall.answer(derivation, Question::Identity(claim), || {
                pieces::decided(derivation, claim, limits, || step.decide())
            }),
        }
    };
    let found: Vec<_> = (0..following.len()).into_par_iter().with_max_len(1).map(identity).collect();
    let mut claims = Vec::new();
    for ((account, identity), &c) in accounts.into_iter().zip(found).zip(following) {
        let Some(mut account) = account else { continue };
        account.identity = identity.map(|found| pieces::account(derivation, &derivation.claims[c], found));
        claims.push(account);
    }
    Followed { claims, rest }
}

/// Gives the verdicts of some claims the strength of the proofs behind them, once all have their accounts.
pub(super) fn strengthen_all(
    derivation: &Derivation,
    claims: &mut [ClaimAccount],
    known: &[ClaimAccount],
    (limits, recall): (&Limits, Recalled),
) {
    let position = |a: &ClaimAccount| derivation.claim_at(&a.id, a.reading.as_deref());
    // An account without a claim would be a defect of the caller; there is nothing to be said of it then.
    let Some(claimed) = claims.iter().map(position).collect::<Option<Vec<usize>>>() else { return };
    replay(derivation, claims, known, (limits, recall));
    strengthen(derivation, &everywhere(derivation, claimed), claims, known, (limits, Recalled::default()));
}

/// These claims, on all trajectories.
fn everywhere(derivation: &Derivation, claims: Vec<usize>) -> Selection {
    Selection { claims, tried: (0..derivation.trajectories.len()).collect(), ..Selection::default() }
}

/// An account with the verdicts that the motions gave, as they were before a proof stood behind them; `None` for a claim that
/// has to be checked.
fn unproved(derivation: &Derivation, claim: &Claim, before: &Accounts, recall: Recalled) -> Option<ClaimAccount> {
    let account = before.get(claim)?;
    let searched = account.variants.as_ref().is_some_and(|v| v.erratum.is_some());
    if searched || account.region.is_some() || claim.region.is_some() {
        return None;
    }
    let mut account = account.clone();
    for pair in &mut account.results {
        let t = derivation.trajectories.iter().position(|t| t.id == pair.trajectory)?;
        let sampled = Question::Sampled { claim, whole: &claim.name(), without: None, motion: t };
        pair.verdict = recall.known(derivation, sampled)?;
    }
    Some(account)
}
