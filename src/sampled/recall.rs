//! What may be known from before, of the same motions and the same claims.
//!
//! **In:** a question, and how to find its answer. **Out:** the answer: the one that is known, or the one that is found. Those who ask
//! do not know whether anything is kept, nor by what name.
//!
//! **Guaranteed** by whoever keeps something: an answer is the one that would be found now.

use crate::derivation::{Claim, Derivation};
use crate::expr::Graph;
use crate::stage::{Built, Requests};
use crate::verdict::Verdict;

/// What is known from before; by default nothing is.
pub trait Recall: Sync {
    /// Whether anything is kept.
    fn is_known(&self) -> bool {
        false
    }

    /// The motions of a family, if they are kept and fit for what is asked: each with the position of its trajectory.
    fn motions(&self, _: &Derivation, _: &Requests, _: &[usize]) -> Option<Vec<(usize, Built)>> {
        None
    }

    /// Keeps the motions of a family, with the graph that they were built in.
    fn keep(&self, _: &Derivation, _: &[usize], _: Graph, _: &[(usize, Built)]) {}

    /// Notes that a motion was built for a part of the claims only.
    fn builds_for_a_part(&self) {}

    /// The verdict of a claim of the file without one of its assumptions, by its place, on a motion.
    fn without(&self, _: &Derivation, _: (&Claim, &str, usize), _: usize, compute: &dyn Fn() -> Verdict) -> Verdict {
        compute()
    }

    /// How a condition stands on a motion. It is named by what it says in the notation of the whole file.
    fn standing(&self, _: &Derivation, _: &[&str], _: usize, compute: &dyn Fn() -> Option<bool>) -> Option<bool> {
        compute()
    }
}

/// Nothing is known.
pub struct Nothing;

impl Recall for Nothing {}
