//! Tactics: search for proofs that the checker replays.
//!
//! **In:** a claim of a derivation. **Out:** [`ProofRecord`]: for each component of each equation that the claim says, the steps of a proof; or
//! the first obstacle. **Guaranteed:** nothing by this crate: what is recorded is what [`checker::Draft`] accepted, and anyone can
//! replay it. A wrong sequent would be a proof of something else, so `sequent.rs` is the part to read.
//!
//! **How a proof is searched.** All that is given is taken, with the rates that the claim needs and the values at the fixed times that it
//! names. Equations are solved one after the other for what is linear in them, highest rates first; what is solved for is put into the
//! others and into the claim, functions by congruence. The rest has to vanish as a polynomial, with sin² + cos² = 1 and other
//! squares divided out; or as a sum of multiples of what is known (`complete`, by the algorithm of Buchberger), before which may stand what is known not to be 0. A conserved quantity is carried
//! from a fixed time by its rate; what is assumed at some times, and conserved, is known at all of them.

#![forbid(unsafe_code)]

mod block;
mod buchberger;
mod complete;
mod eliminate;
mod fraction;
mod logarithm;
mod normal;
mod order;
mod prove;
mod ring;
mod sequent;
mod signs;
mod stretch;
mod unique;
mod used;
mod vanish;
mod weaken;
mod write;

pub use prove::prove;
pub use sequent::sequents;
use sequent::{Presupposing, Question};

use checker::{ProofRecord, RelationRecord};
use derivation::{Claim, Derivation};

/// All that a claim says, as questions for the checker; the same with what is presupposed; and the same of times between which nothing that is assumed ends.
#[derive(Debug)]
pub struct Asked {
    plain: Vec<Question>,
    presupposing: Vec<Question>,
    throughout: Vec<Question>,
}

/// What the verdict on a claim leaves open, so that a recorded proof may, too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum May {
    /// Assume what the claims assume that it follows from.
    Presuppose,
    /// Say nothing of what lies beyond a time at which something assumed is not so.
    EndWithAssumptions,
}

impl Asked {
    /// What a claim asks.
    ///
    /// # Errors
    /// A sentence: the form of the claim that no sequent expresses.
    pub fn of(derivation: &Derivation, claim: &Claim, may: &[May]) -> Result<Asked, String> {
        let plain = sequents(derivation, claim)?;
        let (presupposing, assumed) = match may.contains(&May::Presuppose) {
            true => (sequent::sequents_presupposing(derivation, claim)?, Presupposing::Given),
            false => (Vec::new(), Presupposing::Nothing),
        };
        let throughout = match may.contains(&May::EndWithAssumptions) {
            true => sequent::sequents_between(derivation, claim, assumed)?,
            false => Vec::new(),
        };
        Ok(Asked { plain, presupposing, throughout })
    }

    /// All that is given and claimed, as bytes: questions with the same have the same proofs.
    pub fn content(&self) -> Vec<u8> {
        let all = self.plain.iter().chain(&self.presupposing).chain(&self.throughout);
        let each: Vec<_> = all.map(|q| (&q.sequent, q.conserved, &q.presupposed, &q.throughout)).collect();
        serde_json::to_vec(&each).unwrap_or_default()
    }

    /// Whether a record proves what the claim asks: with the same given and the same claimed, in the same order.
    pub fn is_answered_by(&self, record: &ProofRecord) -> bool {
        let is_asked = |all: &[Question]| {
            !all.is_empty()
                && all.len() == record.relations.len()
                && all.iter().zip(&record.relations).all(|(question, relation)| {
                    question.sequent == record.sequent_of(relation)
                        && question.presupposed == record.presupposed
                        && question.throughout == record.throughout
                })
        };
        [&self.plain, &self.presupposing, &self.throughout].into_iter().any(|all| is_asked(all))
    }

    /// Proofs, for the checker: with nothing presupposed, unless that leaves out more cases.
    ///
    /// # Errors
    /// A sentence: that no proof was found.
    pub fn record(&self) -> Result<ProofRecord, String> {
        let found = self.at_its_times();
        if found.is_ok() || self.throughout.is_empty() { found } else { recorded(&self.throughout).or(found) }
    }

    fn at_its_times(&self) -> Result<ProofRecord, String> {
        let left_out = |record: &ProofRecord| {
            let shown = record.relations.iter().map(|of| checker::replay(&record.sequent_of(of), &of.steps));
            shown.map(|shown| shown.map_or(usize::MAX, |shown| shown.leaves_out().len())).fold(0, usize::saturating_add)
        };
        let plain = recorded(&self.plain);
        if self.presupposing.is_empty() || plain.as_ref().is_ok_and(|record| left_out(record) == 0) {
            return plain;
        }
        let presupposing = recorded(&self.presupposing);
        match (plain, presupposing) {
            (Ok(plain), Ok(presupposing)) if left_out(&plain) <= left_out(&presupposing) => Ok(plain),
            (_, Ok(presupposing)) => Ok(presupposing),
            (plain, Err(_)) => plain,
        }
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
    let first = questions.first().ok_or("nothing is claimed")?;
    let (sequent, presupposed) = (first.sequent.clone(), first.presupposed.clone());
    let mut relations = Vec::new();
    for question in questions {
        relations.push(RelationRecord { claim: question.sequent.claim.clone(), steps: prove(question)? });
    }
    Ok(ProofRecord { sequent, relations, presupposed, throughout: first.throughout.clone() })
}
