//! What is needed to enclose.

use crate::derivation::{Claim, Derivation};
use crate::flow::KnownSteps;
use crate::verdict::Verdict;
use claim::limits::Limits;
use reason::Reason;
use sampled::claim_program::Prepared;
use sampled::selection::Selection;
use sampled::stage::Stage;
use sampled::systems::Fields;
use serde::{Deserialize, Serialize};

/// What is needed to enclose.
pub struct Request<'a> {
    pub derivation: &'a Derivation,
    pub fields: &'a Fields,
    pub stage: &'a Stage,
    pub prepared: &'a [Vec<Prepared<'a>>],
    pub selection: &'a Selection,
    pub limits: &'a Limits,
    /// What was enclosed before.
    pub recall: &'a dyn Recall,
}

/// One claim on one motion, with the verdict that samples gave.
#[derive(Clone, Copy)]
pub struct Question<'a> {
    pub claim: &'a Claim,
    /// The position of the trajectory.
    pub motion: usize,
    pub before: &'a Verdict,
    /// The first integrals of all systems, as a text: any claim may name one.
    pub integrals: &'a str,
}

/// What an enclosure says of one claim on one motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    pub verdict: Verdict,
    /// Why the samples of the motion are not to be believed, for any claim.
    pub contradiction: Option<Reason>,
}

/// What was enclosed before. **Guaranteed** by whoever keeps something: an answer is the one that would be found now.
pub trait Recall: Sync {
    /// The answer to a question, if it is known.
    fn known(&self, _: &Question) -> Option<Answer> {
        None
    }

    /// Keeps an answer.
    fn keep(&self, _: &Question, _: &Answer) {}

    /// The steps of motions: they are those of all claims.
    fn steps(&self) -> &dyn KnownSteps;
}
