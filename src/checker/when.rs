//! When a fact is known: sets of times, and which of them contain which.
//!
//! **In:** nothing. **Out:** [`When`], the one place that says at which times a relation is known; [`CaseId`], [`Instant`].
//! **Guaranteed:** no fact is without one, and no rule widens one without a theorem that says so.
//!
//! On a motion, T is its interval of times, which contains the fixed times that the formulas of the sequent name. S₀ ⊆ T are the times
//! at which all selectors are true and all assumed equations have values. A motion whose S₀ is empty makes no claim false, so that
//! S₀ is taken to have a time in it.

use serde::{Deserialize, Serialize};

/// A fixed time: its position in the list of the fixed times that a sequent names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Instant(pub u32);

/// A case: its position in the list of suppositions. The first one is [`CaseId::CLAIM`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct CaseId(pub u32);

impl CaseId {
    /// The case that both sides of the claim have values: where they have none, the claim is not false.
    pub const CLAIM: CaseId = CaseId(0);
}

/// A set of times of a motion.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum When {
    /// One fixed time. What is known there is a relation between constants: x(0) stands in it, and no x.
    At(Instant),
    /// The times of S₀; some may be isolated.
    Chosen,
    /// The times of S₀, each of which has a neighbourhood in S₀ (in T: one-sided at its ends). It is the same set; the name says that
    /// this was shown.
    ChosenOpen,
    /// All times of T.
    Always,
    /// Those times of a set at which the supposition of a case is true; or, for a case on intervals, those of them that have a
    /// neighbourhood in T of such times.
    In(CaseId, Box<When>),
}

impl When {
    /// The times of this set that belong to a case.
    pub fn within(self, case: CaseId) -> When {
        When::In(case, Box::new(self))
    }

    /// How many cases stand in each other.
    pub fn depth(&self) -> usize {
        let (mut depth, mut when) = (0, self);
        while let When::In(_, inner) = when {
            (depth, when) = (depth + 1, &**inner);
        }
        depth
    }

    /// Whether the set depends on the supposition of a case.
    pub fn is_in_case(&self) -> bool {
        match self {
            When::In(..) => true,
            When::At(_) | When::Chosen | When::ChosenOpen | When::Always => false,
        }
    }
}
