//! Tactics: search for proofs that the checker replays.
//!
//! **In:** a claim of a derivation. **Out:** [`ProofRecord`]: for each component of each equation that the claim says, the steps of a proof; or
//! the first obstacle. **Guaranteed:** nothing by this crate: what is recorded is what [`checker::Draft`] accepted, and anyone can
//! replay it. A wrong sequent would be a proof of something else, so `sequent.rs` is the part to read.
//!
//! **How a proof is searched.** All that is given is taken, with the rates that the claim needs and the values at the fixed times that it
//! names. Equations are solved one after the other for what is linear in them, highest rates first; what is solved for is put into the
//! others and into the claim, functions by congruence. The rest has to vanish as a polynomial, with sin² + cos² = 1 and other
//! squares divided out. A conserved quantity is carried from a fixed time by its rate.

#![forbid(unsafe_code)]

mod block;
mod eliminate;
mod fraction;
mod normal;
mod prove;
mod sequent;
mod used;
mod vanish;
mod write;

pub use prove::prove;
use sequent::Question;
pub use sequent::sequents;

use checker::{ProofRecord, RelationRecord};
use derivation::{Claim, Derivation};

/// All that a claim says, as questions for the checker.
#[derive(Debug)]
pub struct Asked(Vec<Question>);

impl Asked {
    /// What a claim asks.
    ///
    /// # Errors
    /// A sentence: the form of the claim that no sequent expresses.
    pub fn of(derivation: &Derivation, claim: &Claim) -> Result<Asked, String> {
        sequents(derivation, claim).map(Asked)
    }

    /// All that is given and claimed, as bytes: questions with the same have the same proofs.
    pub fn content(&self) -> Vec<u8> {
        let each: Vec<_> = self.0.iter().map(|q| (&q.sequent, q.conserved)).collect();
        serde_json::to_vec(&each).unwrap_or_default()
    }

    /// Proofs, for the checker.
    ///
    /// # Errors
    /// A sentence: that no proof was found.
    pub fn record(&self) -> Result<ProofRecord, String> {
        recorded(&self.0)
    }
}

/// The same, at once, of a claim that is asked with premises of all times: its assumptions choose none.
///
/// # Errors
/// As for [`Asked::of`] and [`Asked::record`].
pub fn record_throughout(derivation: &Derivation, claim: &Claim) -> Result<ProofRecord, String> {
    recorded(&sequent::sequents_throughout(derivation, claim)?)
}

fn recorded(questions: &[Question]) -> Result<ProofRecord, String> {
    let sequent = questions.first().map(|q| q.sequent.clone()).ok_or("nothing is claimed")?;
    let mut relations = Vec::new();
    for question in questions {
        relations.push(RelationRecord { claim: question.sequent.claim.clone(), steps: prove(question)? });
    }
    Ok(ProofRecord { sequent, relations })
}
