//! What a search for a motion on which a claim fails came to.

use serde::{Deserialize, Serialize};
use verdict::Verdict;

/// How the tries ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tries {
    /// The claim holds.
    pub holds: usize,
    /// The claim fails.
    pub fails: usize,
    /// An assumption is not met.
    pub not_applicable: usize,
    /// The evidence does not settle it.
    pub undecided: usize,
    /// There is no such motion: its values are refused, or it cannot be integrated.
    pub impossible: usize,
}

impl Tries {
    /// How many there were.
    pub fn all(self) -> usize {
        self.holds + self.fails + self.not_applicable + self.undecided + self.impossible
    }
}

/// A number of a motion that is other than in the motion that it was made from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ChangedNumber {
    /// LaTeX of what has this value.
    pub name: String,
    /// What it is.
    pub now: f64,
    /// What it is there.
    pub then: f64,
}

/// A motion on which the claim fails.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FailingMotion {
    /// The number of the try, from 0.
    pub number: usize,
    /// The claim, `id` or `id/reading`.
    pub claim: String,
    /// The trajectory of the file that it was made from.
    pub from: String,
    /// Its id.
    pub id: String,
    /// The table `[[trajectory]]`, ready to be put into the file.
    pub table: String,
    /// The numbers of it that are other than there.
    pub changed: Vec<ChangedNumber>,
    /// The verdict on it.
    pub verdict: Verdict,
    /// Whether the claim names its trajectories: the id must then be added there.
    pub listed: bool,
}

/// What a check found of a claim that holds on every motion of its file, on motions that it drew beside these.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DrawnAccount {
    /// The seed of all draws.
    pub seed: u64,
    /// How the claim fares on them.
    pub tries: Tries,
    /// The first on which it fails, if there is one.
    pub found: Option<Box<FailingMotion>>,
}

/// What a search has found.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchAccount {
    /// The claim that was meant, for any of its readings or `id/reading`.
    pub claim: String,
    /// The altered formula that was meant in its place.
    pub variant: Option<String>,
    /// The seed of all draws.
    pub seed: u64,
    /// The motion, if there is one.
    pub found: Option<FailingMotion>,
    /// How the tries ended, up to the one that was taken.
    pub tries: Tries,
    /// Trajectories of the file on which the claim, or its altered formula, fails already.
    pub known: Vec<String>,
}
