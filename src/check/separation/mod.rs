//! Under which condition a claim holds, and which of its assumptions it needs.
//!
//! **In:** the verdicts of every claim on every trajectory. **Out:** a [`ConditionsAccount`] for each claim: for one that holds
//! on some trajectories and fails on others, the weakest condition that is met exactly where it holds; for each assumption,
//! whether the claim fails without it.
//!
//! **How:** a condition is a claim of its own, and is judged on every trajectory as claims are; an assumption
//! is left out, and the claim is tried where it did not apply before. A condition that is undecided on a trajectory counts
//! there neither as met nor as unmet, and so can never separate anything. **Weakest** means: met on most of the trajectories at
//! hand, by inclusion. Trajectories are all the evidence that there is: what they cannot tell apart is said to be so.

mod account;
mod assumptions;
mod candidates;
mod explain;

pub use account::{AssumptionAccount, ConditionName, ConditionsAccount, Explanation, Join, Need, Rival, Separation};

use super::account::Account;
use super::verdict::Outcome;
use super::{CheckError, Options, Rigor, check_claims};
use crate::derivation::Derivation;
use candidates::Candidate;

/// What the ids of claims begin with that are made here: no id of a file can.
const PROBE: char = '~';

/// How a condition stands on every trajectory that was tried: met throughout, not met, or undecided.
type Truth = Vec<Option<bool>>;

/// Adds to every claim of an account what separates its trajectories, and which of its assumptions it needs.
///
/// # Errors
/// Those of [`check_claims`].
pub(super) fn separate(
    derivation: &mut Derivation,
    options: &Options,
    account: &mut Account,
) -> Result<(), CheckError> {
    let split = account.claims.iter().any(explain::is_split);
    let candidates = if split { candidates::candidates(derivation) } else { Vec::new() };
    let dropped = assumptions::without_one(derivation, account);
    if candidates.is_empty() && dropped.is_empty() {
        return Ok(());
    }
    let own = derivation.claims.len();
    let first_dropped = own + candidates.len();
    derivation.claims.extend(candidates.iter().map(|c| c.claim.clone()));
    derivation.claims.extend(dropped.iter().map(|d| d.claim.clone()));
    let claims = derivation.claims[own..].iter().map(|c| c.id.clone()).collect();
    let options = Options { claims, trajectories: options.trajectories.clone(), plain: true, rigor: Rigor::Sampled };
    let probed = check_claims(derivation, &options, &|_, _| {});
    derivation.claims.truncate(own);
    let probed = probed?;

    let ids: Vec<String> = account.trajectories.iter().map(|t| t.id.clone()).collect();
    let truth = |k: usize| -> Truth {
        let results = probed.claims.get(k).map_or(&[][..], |c| c.results.as_slice());
        let on = |id: &String| results.iter().find(|p| p.trajectory == *id).map(|p| &p.verdict);
        let standing = |id: &String| match on(id)?.outcome() {
            // Times without a value are not times at which it is met.
            Outcome::Holds(_) => on(id)?.evidence().excluded.is_empty().then_some(true),
            Outcome::Fails(_) => Some(false),
            Outcome::NotApplicable | Outcome::Undecided => None,
        };
        ids.iter().map(standing).collect()
    };
    let judged: Vec<(&Candidate, Truth)> = candidates.iter().enumerate().map(|(k, c)| (c, truth(k))).collect();
    for claim in account.claims.iter_mut().filter(|c| explain::is_split(c)) {
        // A claim explains nothing about itself.
        let said =
            derivation.claims.iter().find(|c| c.id == claim.id && c.reading == claim.reading).map(candidates::said);
        let others: Vec<(&Candidate, &Truth)> =
            judged.iter().filter(|(c, _)| Some(candidates::said(&c.claim)) != said).map(|(c, t)| (*c, t)).collect();
        claim.conditions.separation = Some(explain::separation(claim, &ids, &others));
    }
    for (k, drop) in dropped.iter().enumerate() {
        let (Some(claim), Some(without)) =
            (account.claims.get_mut(drop.of), probed.claims.get(first_dropped - own + k))
        else {
            continue;
        };
        let need = assumptions::need(claim, without, &drop.text);
        claim.conditions.assumptions.push(need);
    }
    Ok(())
}
