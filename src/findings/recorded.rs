//! Whether a proof is recorded as steps, and the words for it.
//!
//! **In:** what a search for steps came to. **Out:** [`Recorded`]. **Guaranteed:** what is called recorded was replayed by the checker; the word is made here and nowhere else.

use checker::{ProofRecord, Told};
use std::sync::Arc;

/// Whether a proof is recorded.
#[derive(Clone, Debug, PartialEq)]
pub enum Recorded {
    /// It is, and the checker makes each step again.
    Proof(Arc<ProofRecord>, Vec<Told>),
    /// It is not: why.
    Not(String),
}

/// What searches came to, by the names of claims.
pub type Found = Vec<(String, Result<ProofRecord, String>)>;

/// What was kept of searches; nothing where the bytes are no record.
pub fn kept(bytes: &[u8]) -> Found {
    serde_json::from_slice(bytes).unwrap_or_default()
}

/// What is to be kept of searches.
pub fn to_keep<'a>(all: impl Iterator<Item = (String, &'a Recorded)>) -> Vec<u8> {
    let found = |recorded: &Recorded| match recorded {
        Recorded::Proof(proof, _) => Ok(ProofRecord::clone(proof)),
        Recorded::Not(why) => Err(why.clone()),
    };
    let found: Found = all.map(|(name, recorded)| (name, found(recorded))).collect();
    serde_json::to_vec(&found).unwrap_or_default()
}

impl Recorded {
    /// The outcome of a search for steps, which are replayed.
    pub fn of(found: Result<ProofRecord, String>) -> Recorded {
        match found {
            Ok(proof) => match proof.told() {
                Ok(told) => Recorded::Proof(Arc::new(proof), told),
                Err((_, refused)) => Recorded::Not(format!("the checker refuses it: {refused}")),
            },
            Err(why) => Recorded::Not(why),
        }
    }

    /// The relations, in words; nothing where the proof is not recorded.
    pub fn told(&self) -> &[Told] {
        match self {
            Recorded::Proof(_, told) => told,
            Recorded::Not(_) => &[],
        }
    }

    /// The number of steps.
    pub fn steps(&self) -> Option<usize> {
        match self {
            Recorded::Proof(_, told) => Some(told.iter().map(|t| t.shown.steps()).sum()),
            Recorded::Not(_) => None,
        }
    }

    /// Why no proof is recorded.
    pub fn why_not(&self) -> Option<&str> {
        match self {
            Recorded::Proof(..) => None,
            Recorded::Not(why) => Some(why),
        }
    }

    /// The cases that the steps leave out.
    pub fn left_out(&self) -> usize {
        self.told().iter().map(|t| t.shown.leaves_out().len()).sum()
    }

    /// The record, as JSON.
    pub fn json(&self) -> Option<serde_json::Value> {
        match self {
            Recorded::Proof(proof, _) => serde_json::to_value(&**proof).ok(),
            Recorded::Not(_) => None,
        }
    }

    /// A sentence, beside the word *proved*.
    pub fn sentence(&self) -> String {
        match (self.steps(), self.left_out()) {
            (None, _) => format!(
                "The proof is not recorded: it rests on the prover alone ({}).",
                self.why_not().unwrap_or_default()
            ),
            (Some(steps), 0) => format!("The proof is recorded: the checker replayed its {steps} steps."),
            (Some(steps), 1) => {
                format!("The proof is recorded, but for 1 case: the checker replayed its {steps} steps.")
            }
            (Some(steps), n) => {
                format!("The proof is recorded, but for {n} cases: the checker replayed its {steps} steps.")
            }
        }
    }
}
