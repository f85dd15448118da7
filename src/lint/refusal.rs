//! Why a formula was not read.
//!
//! **In:** a feature that was seen, or what the reader of formulas says. **Out:** a [`NotRead`]. **Guaranteed:** it has the name of a feature.

use meter::Ended;

/// Why a formula was not read: the feature that is not understood, and a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotRead {
    /// The feature, in few words: `an integral`, `an operator`.
    pub feature: String,
    /// What the reader of formulas says, where it was asked.
    pub why: Option<String>,
    /// The limit that ended the work on it: of the formula itself nothing is said.
    pub ended: Option<Ended>,
}

/// The feature of a `\log` of which nobody says what it is.
const OF_BASE: &str = "a logarithm";

impl NotRead {
    /// Whether it is not known which logarithm is meant.
    pub fn is_of_base(&self) -> bool {
        self.feature == OF_BASE
    }

    /// A feature that was seen.
    pub fn of(feature: impl Into<String>) -> NotRead {
        NotRead { feature: feature.into(), why: None, ended: None }
    }

    /// Nothing was found out, since the work was ended.
    pub fn ended(by: Ended) -> NotRead {
        match by {
            Ended::Defect(what) => NotRead { why: Some(what), ..NotRead::of("a defect of this program") },
            by => NotRead { ended: Some(by.clone()), ..NotRead::of(by.to_string()) },
        }
    }
}

/// A refusal of a declaration as data.
pub(super) fn refused(error: latex::DeclareError) -> NotRead {
    match error {
        latex::DeclareError::Key(problem) => refusal(&[problem]),
        latex::DeclareError::Formula(problems) => refusal(&problems),
    }
}

/// A refusal of the reader of formulas as data.
pub(super) fn refusal(problems: &[diag::Problem]) -> NotRead {
    let Some(first) = problems.first() else { return NotRead::of("something") };
    let feature = match first.code {
        "latex::unknown-symbol" => "a name",
        "latex::unknown-command" => "a command",
        "latex::bad-name" => "a name",
        "latex::index" | "latex::double-script" => "indices",
        "latex::shape" => "vectors and numbers in one sum, or in one product",
        "latex::ambiguous" => "something with two readings",
        latex::NO_BASE => OF_BASE,
        _ => "a notation",
    };
    NotRead { why: Some(first.message.clone()), ..NotRead::of(feature) }
}
