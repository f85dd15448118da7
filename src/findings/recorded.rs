//! Whether a proof is recorded as steps, and the words for it.
//!
//! **In:** what a search for steps came to. **Out:** [`Recorded`]. **Guaranteed:** what is called recorded was replayed by the checker, in this run or in
//! the one of the same program that kept it; the word is made here and nowhere else.

use checker::{ProofRecord, Shown, Told};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Most cases that are named in a sentence, and longest formula of one, in bytes.
const MOST_NAMED: usize = 3;
const LONGEST: usize = 120;

/// Whether a proof is recorded.
///
/// It is kept with what the replay showed, like all evidence: who kept it has to see to that nobody else wrote it. A file that anybody may
/// have written holds the record alone, see `proofs.json`, and `audit` replays that.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Recorded {
    /// It is, and the checker made each step again.
    Proof(Arc<ReplayedRecord>),
    /// It is not: why.
    Not(String),
}

/// A record that the checker replayed. The record is kept as JSON, which takes a quarter of the memory of its steps: they are wanted for
/// the claims that are shown, and a file may have many.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct ReplayedRecord {
    json: Box<str>,
    relations: usize,
    steps: usize,
    left_out: usize,
    left_out_words: Vec<String>,
    presupposed: Vec<String>,
    throughout: Vec<String>,
}

impl ReplayedRecord {
    fn of(proof: &ProofRecord, all: &[Shown]) -> ReplayedRecord {
        let mut left_out_words: Vec<String> = Vec::new();
        for text in all.iter().flat_map(Shown::leaves_out_words) {
            if !left_out_words.contains(text) {
                left_out_words.push(text.clone());
            }
        }
        ReplayedRecord {
            json: serde_json::to_string(proof).unwrap_or_default().into_boxed_str(),
            relations: all.len(),
            steps: all.iter().map(Shown::steps).sum(),
            left_out: all.iter().map(|shown| shown.leaves_out().len()).sum(),
            left_out_words,
            presupposed: proof.presupposed_words(),
            throughout: proof.throughout_words(),
        }
    }

    /// The record, as JSON.
    pub fn json(&self) -> &str {
        &self.json
    }

    /// The number of relations.
    pub fn relations(&self) -> usize {
        self.relations
    }

    /// The number of their steps.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// The record; nothing if it was too large to be written.
    fn record(&self) -> Option<ProofRecord> {
        serde_json::from_str(&self.json).ok()
    }

    /// The relations in words, which are made by and by.
    pub fn told(&self) -> impl Iterator<Item = Told> {
        let record = self.record();
        (0..self.relations).map_while(move |at| record.as_ref()?.told(at).ok())
    }
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

impl Recorded {
    /// The outcome of a search for steps, which are replayed.
    pub fn of(found: Found) -> Recorded {
        match found {
            Ok(proof) => match proof.shown() {
                Ok(shown) => Recorded::Proof(Arc::new(ReplayedRecord::of(&proof, &shown))),
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

    /// The proof that was replayed, if it is recorded.
    pub fn replayed(&self) -> Option<&ReplayedRecord> {
        match self {
            Recorded::Proof(replayed) => Some(replayed),
            Recorded::Not(_) => None,
        }
    }

    /// The number of steps.
    pub fn steps(&self) -> Option<usize> {
        self.replayed().map(ReplayedRecord::steps)
    }

    /// Why no proof is recorded.
    pub fn why_not(&self) -> Option<&str> {
        match self {
            Recorded::Proof(..) => None,
            Recorded::Not(why) => Some(why),
        }
    }

    /// The number of cases that the steps leave out.
    pub fn left_out(&self) -> usize {
        self.replayed().map_or(0, |replayed| replayed.left_out)
    }

    /// Where the steps say nothing, in words, if anywhere: up to so many cases, and no long formula.
    pub fn left_out_words(&self) -> Option<String> {
        let all = self.replayed().map_or(&[][..], |replayed| &replayed.left_out_words);
        let short: Vec<&str> =
            all.iter().map(String::as_str).filter(|text| text.len() <= LONGEST).take(MOST_NAMED).collect();
        let named = short.join(", ");
        match (short.len(), all.len() - short.len()) {
            (0, 0) => None,
            (0, 1) => Some("where a long formula, which the audit prints, is not so".to_owned()),
            (0, n) => Some(format!("where one of {n} long formulas, which the audit prints, is not so")),
            (_, 0) => Some(format!("where it is not so that {named}")),
            (_, n) => Some(format!("where it is not so that {named}, or one of {n} more, which the audit prints")),
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
            [] => sentence,
            all => format!("{sentence} It is about times between which {} throughout.", all.join(", ")),
        };
        match self.presupposed() {
            [] => sentence,
            all => format!("{sentence} It presupposes {}, as what it follows from does.", all.join(", ")),
        }
    }

    /// What a recorded proof assumes at all times between two, and the claim at those that it chooses, in words.
    pub fn throughout(&self) -> &[String] {
        self.replayed().map_or(&[], |replayed| &replayed.throughout)
    }

    /// What a recorded proof presupposes, in words.
    pub fn presupposed(&self) -> &[String] {
        self.replayed().map_or(&[], |replayed| &replayed.presupposed)
    }
}
