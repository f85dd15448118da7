//! From what the prover says to what the checker shows: the last part of every proof.
//!
//! **In:** a claim with its account, in which the prover says *proved*. **Out:** the account once the checker has replayed the steps that tactics find; or has not, for a reason. **Guaranteed:**
//! *proved* and *proved except* come from here alone: see [`Finding::replayed`](findings::standing::Finding::replayed); what the checker does not replay is *proved unreplayed* at most, and that only where times do not matter: see `alone.rs`.

use crate::derivation::{Claim, Derivation};
use crate::said::Sayings;
use findings::IdentityAccount;
use findings::recorded::{Found, Recorded};
use meter::{Limits, Task};
use proof::When;
use reason::Plain;
use tactics::{Asked, May};

/// A search for steps, as far as its work goes.
fn search(limits: &Limits, work: impl FnOnce() -> Found) -> Found {
    meter::piece(Task::Proving, limits, work).unwrap_or_else(|ended| Err(ended.to_string()))
}

/// What a verdict leaves open, so that the steps may.
fn left_open(account: &IdentityAccount) -> Vec<May> {
    let presupposes = (!account.presupposed.is_empty()).then_some(May::Presuppose);
    let ends = account.finding.ends_on_the_way().then_some(May::EndWithAssumptions);
    presupposes.into_iter().chain(ends).collect()
}

/// Whether a claim has motions in its file that move by its systems; on which of them all that is given is so is another question.
pub fn has_motions(derivation: &Derivation, claim: &Claim) -> bool {
    !crate::existence::motions_of_file(derivation, claim).is_empty()
}

/// Finds steps that are replayed, or recalls them by all that is given and claimed.
pub type RecallSteps<'a> = &'a dyn Fn(&Asked, &dyn Fn() -> Recorded) -> Recorded;

/// The account, with its proof replayed if there is one. `has_motion`: whether a motion of the file is known on which what is given is so.
pub fn replayed(
    derivation: &Derivation,
    claim: &Claim,
    account: IdentityAccount,
    has_motion: bool,
    (limits, recall): (&Limits, RecallSteps),
) -> IdentityAccount {
    if !account.finding.is_proved_in_part() || account.recorded.is_some() {
        return account;
    }
    let recorded = match Asked::of(derivation, claim, &left_open(&account)) {
        Ok(asked) => recall(&asked, &|| Recorded::of(search(limits, || asked.record()))),
        Err(why) => Recorded::Not(why),
    };
    finished(derivation, claim, account.replayed(recorded), has_motion, When::Chosen)
}

/// What is not replayed leaves the claim undecided, where it might be that a fact was used at times at which it is not known; and so does
/// what is given of several fixed times, if no motion is found that is so. `inequalities`: when those that are assumed hold.
fn finished(
    derivation: &Derivation,
    claim: &Claim,
    account: IdentityAccount,
    has_motion: bool,
    inequalities: When,
) -> IdentityAccount {
    if !account.finding.is_proved_in_part() {
        return account;
    }
    let said = Sayings::of(derivation, claim).presupposing(derivation, claim, &account.presupposed);
    let known = (account.finding.is_whole(), has_motion);
    if !crate::existence::is_known(derivation, claim, &said, known, inequalities) {
        return account.left_open(Plain::NoMotionKnown.into());
    }
    if account.finding.is_unreplayed() && !crate::alone::counts(derivation, &said) {
        return account.left_open(Plain::Unreplayed.into());
    }
    account
}

/// The same of a claim that is typed, with premises of all times.
pub fn replayed_throughout(derivation: &Derivation, claim: &Claim, account: IdentityAccount) -> IdentityAccount {
    if !account.finding.is_proved_in_part() {
        return account;
    }
    let found = search(&meter::limits(), || tactics::record_throughout(derivation, claim));
    finished(derivation, claim, account.replayed(Recorded::of(found)), false, When::Always)
}

/// Whether what the prover says of a claim beside the one that is asked about counts: of what that one denies. `typed`: its premises
/// are of all times.
pub(crate) fn is_replayed(derivation: &Derivation, claim: &Claim, account: IdentityAccount, typed: bool) -> bool {
    let account = match typed {
        true => replayed_throughout(derivation, claim, account),
        false => replayed(derivation, claim, account, false, (&meter::limits(), &|_, search| search())),
    };
    account.finding.is_proved_in_part()
}
