//! Whether a proof is recorded as steps, and the words for it.
//!
//! **In:** what a search for steps came to. **Out:** [`Recorded`]. **Guaranteed:** what is called recorded was replayed by the checker; the word is made here and nowhere else.

use checker::{ProofRecord, Shown, Told};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Most cases that are named in a sentence, and longest formula of one, in bytes.
const MOST_NAMED: usize = 3;
const LONGEST: usize = 120;

/// Whether a proof is recorded. Kept as the record alone: what is read back is replayed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
pub enum Recorded {
    /// It is, and the checker makes each step again.
    Proof(Arc<ProofRecord>, Vec<Shown>),
    /// It is not: why.
    Not(String),
}

/// What the word *proved* rests on: every output says which.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Grounds {
    /// The checker: it made all steps again.
    Checker,
    /// The checker, but for so many cases, which rest on the prover.
    CheckerBut(usize),
    /// The prover.
    Prover,
}

impl Grounds {
    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Grounds::Checker => "replayed",
            Grounds::CheckerBut(_) => "replayed in part",
            Grounds::Prover => "prover alone",
        }
    }
}

/// The outcome of a search for steps.
pub type Found = Result<ProofRecord, String>;

/// An outcome as text, to be kept: steps leave out what is empty, which bytes without names cannot.
pub fn written(found: &Found) -> String {
    serde_json::to_string(found).unwrap_or_default()
}

/// The outcome that was kept.
pub fn read(text: &str) -> Option<Found> {
    serde_json::from_str(text).ok()
}

impl From<String> for Recorded {
    fn from(text: String) -> Recorded {
        Recorded::of(read(&text).unwrap_or_else(|| Err("what was kept of it cannot be read".to_owned())))
    }
}

impl From<Recorded> for String {
    fn from(recorded: Recorded) -> String {
        written(&match recorded {
            Recorded::Proof(proof, _) => Ok(Arc::unwrap_or_clone(proof)),
            Recorded::Not(why) => Err(why),
        })
    }
}

impl Recorded {
    /// The outcome of a search for steps, which are replayed.
    pub fn of(found: Found) -> Recorded {
        match found {
            Ok(proof) => match proof.shown() {
                Ok(shown) => Recorded::Proof(Arc::new(proof), shown),
                Err((_, refused)) => Recorded::Not(format!("the checker refuses it: {refused}")),
            },
            Err(why) => Recorded::Not(why),
        }
    }

    /// What the word *proved* rests on.
    pub fn grounds(&self) -> Grounds {
        match (self, self.left_out()) {
            (Recorded::Not(_), _) => Grounds::Prover,
            (Recorded::Proof(..), 0) => Grounds::Checker,
            (Recorded::Proof(..), cases) => Grounds::CheckerBut(cases),
        }
    }

    /// What was shown of each relation; nothing where the proof is not recorded.
    fn shown(&self) -> &[Shown] {
        match self {
            Recorded::Proof(_, shown) => shown,
            Recorded::Not(_) => &[],
        }
    }

    /// The relations, in words, which are made when they are asked for; nothing where the proof is not recorded.
    pub fn told(&self) -> Vec<Told> {
        match self {
            Recorded::Proof(proof, _) => proof.told().unwrap_or_default(),
            Recorded::Not(_) => Vec::new(),
        }
    }

    /// The number of steps.
    pub fn steps(&self) -> Option<usize> {
        match self {
            Recorded::Proof(_, shown) => Some(shown.iter().map(Shown::steps).sum()),
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
        self.shown().iter().map(|shown| shown.leaves_out().len()).sum()
    }

    /// Where the steps say nothing, in words, if anywhere: up to so many cases, and no long formula.
    pub fn left_out_words(&self) -> Option<String> {
        let mut all: Vec<&str> = Vec::new();
        for text in self.shown().iter().flat_map(Shown::leaves_out_words) {
            if !all.contains(&text.as_str()) {
                all.push(text);
            }
        }
        let short: Vec<&str> = all.iter().copied().filter(|text| text.len() <= LONGEST).take(MOST_NAMED).collect();
        let named = short.join(", ");
        match (short.len(), all.len() - short.len()) {
            (0, 0) => None,
            (0, 1) => Some("where a long formula, which the audit prints, is not so".to_owned()),
            (0, n) => Some(format!("where one of {n} long formulas, which the audit prints, is not so")),
            (_, 0) => Some(format!("where it is not so that {named}")),
            (_, n) => Some(format!("where it is not so that {named}, or one of {n} more, which the audit prints")),
        }
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
        let sentence = match (self.steps(), self.left_out()) {
            (None, _) => format!(
                "The proof is not recorded: it rests on the prover alone ({}).",
                self.why_not().unwrap_or_default()
            ),
            (Some(steps), 0) => format!("The proof is recorded: the checker replayed its {steps} steps."),
            (Some(steps), _) => format!(
                "The checker replayed its {steps} steps; they say nothing {}.",
                self.left_out_words().unwrap_or_default()
            ),
        };
        let sentence = match self.throughout() {
            all if all.is_empty() => sentence,
            all => format!("{sentence} It is about times between which {} throughout.", all.join(", ")),
        };
        match self.presupposed() {
            all if all.is_empty() => sentence,
            all => format!("{sentence} It presupposes {}, as what it follows from does.", all.join(", ")),
        }
    }

    /// What a recorded proof assumes at all times between two, and the claim at those that it chooses, in words.
    pub fn throughout(&self) -> Vec<String> {
        match self {
            Recorded::Proof(proof, _) => proof.throughout_words(),
            Recorded::Not(_) => Vec::new(),
        }
    }

    /// What a recorded proof presupposes, in words.
    pub fn presupposed(&self) -> Vec<String> {
        match self {
            Recorded::Proof(proof, _) => proof.presupposed_words(),
            Recorded::Not(_) => Vec::new(),
        }
    }
}
