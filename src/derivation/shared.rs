//! Parameters that are given in the same way.
//!
//! **In:** a trajectory. **Out:** pairs of parameters, the second of which stands for the first: both are given by one decimal, or one
//! formula, that is no number of binary64. **Why:** 0.1 is known to half a unit in the last place, and so
//! is 0.1; that they are equal is known exactly.

use std::collections::BTreeMap;

use super::model::{Derivation, Trajectory};
use expr::{Expr, Leaf};

impl Derivation {
    /// The parameters of a trajectory that others stand for: each with the one that stands for it.
    pub fn shared_parameters(&self, of: &Trajectory) -> Vec<(Leaf, Leaf)> {
        let given = self.parameters_of(of);
        let mut first: BTreeMap<Expr, Leaf> = BTreeMap::new();
        let inexact = given.iter().filter(|(_, e)| !self.graph.is_binary64(**e));
        let pairs = inexact.map(|(&leaf, &e)| (leaf, *first.entry(e).or_insert(leaf)));
        pairs.filter(|(leaf, other)| leaf != other).collect()
    }

    /// What the components of the parameters of a trajectory are given by.
    fn parameters_of(&self, of: &Trajectory) -> BTreeMap<Leaf, Expr> {
        let leaf = |symbol, component: usize| Leaf::now(symbol, component as u16);
        let each = of.parameters.iter().flat_map(|(symbol, written)| {
            written.value.iter().enumerate().map(move |(component, e)| (leaf(*symbol, component), *e))
        });
        each.collect()
    }
}
