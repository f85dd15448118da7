//! What to check, and how.

use crate::limits::Limits;

/// What to check.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Options {
    /// Only claims with these ids; all when empty.
    pub claims: Vec<String>,
    /// Only trajectories with these ids; all when empty.
    pub trajectories: Vec<String>,
    /// The verdicts alone: no variants, no corrections, nothing that separates the motions, no pictures.
    pub plain: bool,
    /// How much is asked of a verdict.
    pub rigor: Rigor,
    /// When the run must end.
    pub limits: Limits,
}

/// How much is asked of a verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Rigor {
    /// At finitely many times.
    #[default]
    Sampled,
    /// At every time, where it is possible.
    Enclosed,
}

impl Rigor {
    /// All of them.
    pub const ALL: [Rigor; 2] = [Rigor::Sampled, Rigor::Enclosed];

    /// Its name, and what it is, in words.
    pub fn words(self) -> (&'static str, &'static str) {
        match self {
            Rigor::Sampled => ("sampled", "At finitely many times"),
            Rigor::Enclosed => {
                ("enclosed", "At every time of the span where it is possible, with rounding accounted for")
            }
        }
    }
}
