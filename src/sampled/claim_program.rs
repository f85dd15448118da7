//! A claim with everything that is compiled for it.

use crate::derivation::Claim;
use crate::expr::{Graph, Leaf};
use crate::independence::Gradients;
use claim::program::Program;

/// A claim with everything that is compiled for it.
pub struct Prepared<'a> {
    pub claim: &'a Claim,
    pub program: Program,
    pub gradients: Option<Result<Gradients, reason::Reason>>,
}

impl Prepared<'_> {
    /// The leaves that points must have values of.
    pub fn leaves(&self, graph: &Graph) -> Vec<Leaf> {
        let gradients = self.gradients.iter().flatten().flat_map(|g| g.leaves(graph));
        self.program.leaves(graph).into_iter().chain(gradients).collect()
    }
}
