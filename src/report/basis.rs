//! The basis on which a claim stands: how it is known, in words, as a symbol, and for counting.
//!
//! **In:** what was found of a reading. **Out:** a [`Basis`]; of several the least is the weakest.

use super::numbers::count;
use super::shape::VerdictShape;
use findings::standing::MOST_TOLD;

/// How it is known that a reading holds wherever it applies; the weakest first.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Basis {
    /// At samples of so many motions.
    Sampled(usize),
    /// At every time of so many motions.
    Enclosed(usize),
    /// At every point of its ranges.
    Ranges,
    /// For all values, as the prover says; the checker has not replayed it.
    Unreplayed,
    /// For all values, given what is not proved.
    Given(Vec<String>),
    /// For all values, special cases apart.
    Except,
    /// For all values.
    Proved,
}

impl Basis {
    /// In a few words; ids between backticks.
    pub fn words(&self) -> String {
        match self {
            Basis::Sampled(n) => format!("at all samples of {}", count(*n, "motion")),
            Basis::Enclosed(n) => format!("at every time of {}", count(*n, "motion")),
            Basis::Ranges => "at every point of its ranges".to_owned(),
            Basis::Unreplayed => "proved by the prover alone, not replayed".to_owned(),
            Basis::Given(open) => format!("proved, given {}", given(open)),
            Basis::Except => "proved, special cases of what is given apart".to_owned(),
            Basis::Proved => "proved for all values".to_owned(),
        }
    }

    /// Whether it is a proof.
    pub fn is_proof(&self) -> bool {
        match self {
            Basis::Proved | Basis::Except | Basis::Given(_) => true,
            // Its words say already that the checker did not replay it.
            Basis::Unreplayed | Basis::Sampled(_) | Basis::Enclosed(_) | Basis::Ranges => false,
        }
    }

    /// Its symbol.
    pub fn shape(&self) -> VerdictShape {
        match self {
            Basis::Sampled(_) => VerdictShape::Sampled,
            Basis::Enclosed(_) | Basis::Ranges => VerdictShape::Enclosed,
            Basis::Unreplayed => VerdictShape::Unreplayed,
            Basis::Given(_) => VerdictShape::ProvedGiven,
            Basis::Except => VerdictShape::ProvedExcept,
            Basis::Proved => VerdictShape::Proved,
        }
    }

    /// The kind, for counting.
    pub fn kind(&self) -> &'static str {
        match self {
            Basis::Sampled(_) => "at samples",
            Basis::Enclosed(_) => "at every time",
            Basis::Ranges => "at every point of ranges",
            Basis::Unreplayed => "proved, not replayed",
            Basis::Given(_) => "proved, given others",
            Basis::Except => "proved but for special cases",
            Basis::Proved => "proved",
        }
    }
}

/// Most premises that are named in one line.
const MOST_GIVEN: usize = 3;

fn given(open: &[String]) -> String {
    let named: Vec<String> = open.iter().take(MOST_GIVEN).map(|id| format!("“{id}”")).collect();
    match open.len().saturating_sub(MOST_GIVEN) {
        0 => named.join(", "),
        // What stands for the rest is one of these.
        more if open.len() > MOST_TOLD => format!("{} and more than {} more", named.join(", "), more - 1),
        more => format!("{} and {more} more", named.join(", ")),
    }
}
