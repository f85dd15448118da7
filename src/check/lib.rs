//! A derivation, checked: the methods in their order, and what is known from before.
//!
//! **In:** a [`Derivation`]. **Out:** an [`Account`]: one verdict for every claim on every trajectory, with its evidence.
//!
//! The order of work (`run.rs`): claims are compiled (`claim`), all that they will ask of motions is collected, and the motions are built and
//! sampled (`sampled`); each claim is tried on each; what claims say for all values is proved (`proved`), and lends its strength
//! (`premises`); verdicts are enclosed (`enclosed`) and weighed (`weight`). Claims over ranges (`boxes`) and on families (`families`) go
//! beside. Motions are independent of one another and are tried in parallel; the result does not depend on how many threads there are.
//!
//! **Guaranteed:** no evidence is found here, and no method calls another. What is known from before, by content, is asked at one seam,
//! [`Recall`](sampled::recall::Recall).

#![forbid(unsafe_code)]

use ::{derivation, diag, expr, findings, flow, latex, number, verdict};

mod answers;
mod cache;
mod compilation;
mod draft;
mod drawn;
mod follow;
mod memory;
mod motions;
mod on_drafts;
mod on_motions;
mod picture;
mod pieces;
mod premises;
mod record;
mod run;
pub mod search;

pub use ::proof as identity;
pub use ::units;
pub use cache::Cache;
pub use claim::error::CheckError;
pub use claim::limits::{Cancel, Limits, WorkFactor};
pub use claim::options::{Options, Rigor};
pub use families as family;
use families::{Checker, Families, Joined};
pub use files::records::Store;
use findings::conditions::ConditionName;
#[cfg(debug_assertions)]
#[doc(hidden)]
pub use findings::sample;
pub use findings::{
    Account, Certificate, ClaimAccount, ClassCount, Cofactor, Correction, Counterexample, Discrimination, EditClass,
    Erratum, IdentityAccount, IdentityEvidence, Judged, Line, LineKind, Measurement, Origin, PairAccount,
    PictureAccount, Place, Proposition, SEED, Summary, Survivor, TrajectoryAccount, Trials, VariantAccount, WEAK,
    family::{FailingShare, FamilyAccount, MemberAccount},
    standing,
};
pub use meter::Defects;
pub use proved::agreement::agree;
pub use proved::proposition::{prove, stated, with_symbols_of};
pub use record::{Recalled, check_again_recorded, check_recorded};
pub use verdict::{
    Enclosed, Evidence, Exclusion, Finding, Outcome, Possible, Proof, Residual, ResidualPoint, Residuals, Strength,
    Verdict, Witness,
};
pub use weight::separation;
pub use weight::variant::{AlteredFormula, Sameness, altered_formulas, says_the_same};

use derivation::{Claim, Derivation};
use expr::Graph;
use memory::Known;
use run::Run;

/// Tries every claim on every trajectory.
///
/// `progress` is told how many of how many trajectories are done.
///
/// # Errors
/// [`CheckError::Problems`] for systems that cannot be solved for their rates and trajectories that cannot be built;
/// [`CheckError::Defect`] when two independent computations of the same value disagree.
pub fn check(
    derivation: &Derivation,
    options: &Options,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    check_recalling(derivation, options, Known::default(), None, progress)
}

/// The verdicts on a family whose members were counted in parts: what [`check()`] finds with the options `trajectories = [FAMILY]` and
/// `plain`.
///
/// # Errors
/// As for [`check()`]; a member that is shown is not what its part says.
pub fn check_joined(
    derivation: &Derivation,
    joined: &Joined,
    limits: &Limits,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    let trajectories = vec![joined.id(derivation).to_owned()];
    let options = Options { trajectories, plain: true, limits: limits.clone(), ..Options::default() };
    check_recalling(derivation, &options, Known::default(), Some(joined), progress)
}

/// [`check()`], with what is known from before.
fn check_recalling(
    derivation: &Derivation,
    options: &Options,
    recall: Known,
    joined: Option<&Joined>,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Account, CheckError> {
    let families = Families::of(derivation, options)?;
    let mut account = Run { recall, progress, ..Run::new(derivation, options) }.account()?;
    if let Some(families) = families {
        account.distributions = recall.on_families(derivation, &mut account.claims, |claims| {
            families.try_all(&Trajectories, options, claims, joined, progress)
        })?;
    }
    // A part of the trajectories does not say that a claim holds on all.
    if !options.plain && options.trajectories.is_empty() {
        drawn::add(derivation, &mut account, options, recall)?;
    }
    account.units = units::units(derivation);
    account.units.keep(&options.claims);
    Ok(account)
}

/// The accounts of the claims that are asked for, beside others that are known from before: these are premises as if they
/// had been tried again.
fn check_beside(
    derivation: &Derivation,
    options: &Options,
    known: &[ClaimAccount],
    recall: Known,
) -> Result<Vec<ClaimAccount>, CheckError> {
    let families = Families::of(derivation, options)?;
    let mut claims = Run { known, separating: true, recall, ..Run::new(derivation, options) }.account()?.claims;
    if let Some(families) = families {
        families.try_all(&Trajectories, options, &mut claims, None, &|_, _| {})?;
    }
    Ok(claims)
}

/// Members of families, tried as trajectories.
struct Trajectories;

impl Checker for Trajectories {
    fn check(
        &self,
        derivation: &Derivation,
        options: &Options,
        separating: bool,
    ) -> Result<Vec<ClaimAccount>, CheckError> {
        Run { separating, ..Run::new(derivation, options) }.account().map(|account| account.claims)
    }

    fn conditions(&self, derivation: &Derivation, graph: &mut Graph, names: &[ConditionName]) -> Vec<Option<Claim>> {
        separation::as_claims(derivation, graph, names)
    }
}
