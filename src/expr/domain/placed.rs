//! Times and places that are named: what is taken at them has a value only where they have one.
//!
//! **In:** expressions. **Out:** the times and places below them that may have no value. **Guaranteed:** none is left out; those of a
//! number with a value are.

use crate::{Expr, FastSet, Graph, Node};

impl Graph {
    /// The places of fields, and the fixed times at which something is taken, below some expressions: these have values only where all of them
    /// have one. A place or a time that always has one is left out.
    pub fn placed_below(&mut self, roots: impl IntoIterator<Item = Expr>) -> Vec<Expr> {
        let roots: Vec<Expr> = roots.into_iter().collect();
        let mut out = self.places_below(roots.iter().copied());
        let instants = self.leaves_within(roots).into_iter().filter_map(|leaf| leaf.instant);
        let instants: FastSet<Expr> = instants.collect();
        out.extend(instants.into_iter().filter(|e| !matches!(self.node(*e), Node::Constant(_) | Node::Pi)));
        out.sort_unstable();
        out.dedup();
        out.retain(|&e| {
            let all = self.reachable([e]);
            let needs: Vec<_> = all.into_iter().flat_map(|node| self.needs(node)).collect();
            needs.iter().any(|need| !self.as_constant(need.value).is_some_and(|number| need.sign.is_of(number)))
        });
        out
    }
}
