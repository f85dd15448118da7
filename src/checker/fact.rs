//! Facts: relations, each with the times at which it is known, what it needs, and why it is known.
//!
//! **In:** what a rule made. **Out:** [`Fact`], which can be read and not be made outside. **Guaranteed:** on every motion on which what is given is
//! true and S₀ has a time in it, at each time of `when` at which all `needs` hold, both sides have values and `says` is true.

use super::context::Says;
use super::needs::Needs;
use super::step::{FactId, Given};
use super::when::When;

/// Why a fact is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Because {
    /// The sequent gives it.
    Given(Given, Vec<FactId>),
    /// The supposition of a case.
    Supposed,
    /// A rule, by its name, from facts.
    Rule(&'static str, Vec<FactId>),
}

impl Because {
    /// The facts that it rests on.
    pub fn facts(&self) -> &[FactId] {
        match self {
            Because::Given(_, facts) | Because::Rule(_, facts) => facts,
            Because::Supposed => &[],
        }
    }
}

/// A relation that is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    pub(crate) says: Says,
    pub(crate) when: When,
    pub(crate) needs: Needs,
    pub(crate) because: Because,
}

impl Fact {
    /// The times at which it is known.
    pub fn when(&self) -> &When {
        &self.when
    }

    /// Why it is known.
    pub fn because(&self) -> &Because {
        &self.because
    }

    /// Whether nothing is left that must hold for it to be used.
    pub fn is_free(&self) -> bool {
        self.needs.is_empty()
    }
}
