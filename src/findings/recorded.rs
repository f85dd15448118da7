//! Whether a proof is recorded as steps, and the words for it.
//!
//! **In:** what a search for steps came to. **Out:** [`Recorded`]. **Guaranteed:** what is called recorded was replayed by the checker; the word is made here and nowhere else.

use checker::{ProofRecord, Told};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Whether a proof is recorded.
#[derive(Clone, Debug, PartialEq)]
pub enum Recorded {
    /// It is, and the checker makes each step again.
    Proof(Arc<ProofRecord>, Vec<Told>),
    /// It is not: why.
    Not(String),
}

/// For how many states of a file it is kept what a search came to that is not asked for.
const AGES: u64 = 8;

/// What a search for steps came to.
pub type Found = Result<ProofRecord, String>;

/// What searches for the last states of a file came to, by the names of their questions.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct Searches {
    age: u64,
    found: BTreeMap<String, (u64, Found)>,
}

/// The name under which the searches for a file are kept, by its id.
pub fn name_of(id: &str) -> String {
    let sum = Sha256::digest(format!("proofs of {id}"));
    sum.iter().map(|byte| format!("{byte:02x}")).collect()
}

impl Searches {
    /// What was kept; nothing where the bytes are no record.
    pub fn read(bytes: &[u8]) -> Searches {
        serde_json::from_slice(bytes).unwrap_or_default()
    }

    /// What a search came to.
    pub fn known(&self, name: &str) -> Option<&Found> {
        self.found.get(name).map(|(_, found)| found)
    }

    /// One more state of the file, with all that was asked for it, as bytes; `None` where all of it is kept already.
    pub fn with(mut self, asked: Vec<(String, Found)>) -> Option<Vec<u8>> {
        if asked.iter().all(|(name, _)| self.found.contains_key(name)) {
            return None;
        }
        self.age += 1;
        let now = self.age;
        self.found.extend(asked.into_iter().map(|(name, found)| (name, (now, found))));
        self.found.retain(|_, (age, _)| *age + AGES > now);
        serde_json::to_vec(&self).ok()
    }
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
