//! What is needed to enclose.

use crate::derivation::{Claim, Derivation};
use crate::verdict::Verdict;
use claim::limits::Limits;
use sampled::claim_program::Prepared;
use sampled::selection::Selection;
use sampled::stage::Stage;
use sampled::systems::Fields;

/// What is needed to enclose.
pub struct Request<'a> {
    pub derivation: &'a Derivation,
    pub fields: &'a Fields,
    pub stage: &'a Stage,
    pub prepared: &'a [Vec<Prepared<'a>>],
    pub selection: &'a Selection,
    pub limits: &'a Limits,
    /// Encloses, or recalls what was enclosed.
    pub recall: Recall<'a>,
}

/// Finds, or recalls, the verdicts on claims on a motion, by the verdicts before, and by the first integrals of all systems: any claim
/// may name one.
pub type Recall<'a> =
    &'a (dyn Fn(usize, &str, &[(&Claim, &Verdict)], &mut dyn FnMut() -> Vec<Verdict>) -> Vec<Verdict> + Sync);
