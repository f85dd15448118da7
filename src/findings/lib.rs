//! What a check found, as plain data: every number that a report shows.
//!
//! **In:** nothing; those who find something fill it in. **Out:** an [`Account`] of a derivation file, an [`IdentityAccount`] of a
//! formula, a [`Swept`](family::Swept) part of a family.
//!
//! **Guaranteed:** nothing is computed here but what follows from the data themselves: sums, shares, and words for what is stored. What
//! decides has doors of its own: a [`Verdict`] is made by the kernel, a [`Finding`](standing::Finding) for all values
//! only from the answer of a proof, see [`standing`].

#![forbid(unsafe_code)]

mod account;
mod alone;
pub mod conditions;
pub mod family;
mod identity;
mod picture;
pub mod recorded;
pub mod region;
#[cfg(debug_assertions)]
#[doc(hidden)]
pub mod sample;
pub mod search;
mod single_motion;
pub mod standing;
mod variant;
mod words;

pub use account::{
    Account, AssumptionsUsed, ClaimAccount, IdentityAccount, Judged, Measurement, PairAccount, Summary,
    TrajectoryAccount, by_trajectory,
};
pub use alone::{AloneAccount, Premises, TrialScope};
pub use family::{FailingShare, FamilyAccount, MemberAccount};
pub use identity::{Counterexample, IdentityEvidence, Place, Proposition, Trials};
pub use picture::{Line, LineKind, PictureAccount};
pub use proof::{Certificate, Cofactor, Origin};
pub use recorded::{Grounds, Recorded, ReplayedRecord};
pub use units;
pub use variant::{ClassCount, Correction, Discrimination, EditClass, Erratum, SEED, Survivor, VariantAccount, WEAK};
pub use verdict::{
    Enclosed, Evidence, Exclusion, Obstacle, Outcome, Possible, Proof, Residual, ResidualPoint, Residuals, Strength,
    Verdict, Witness,
};
