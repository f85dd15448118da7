//! What a file says beside a claim, as far as its meaning hangs on it: systems that it names, and where its motions have no rates.
//!
//! **In:** a file. **Out:** its systems, and whether the rate of a state may be missing. **Guaranteed:** a state that is said to have its
//! rates has them at each time at which it has a value.

use crate::derivation::{Claim, Derivation, Motion, System, Trajectory};
use crate::expr::domain::Change;
use crate::expr::{Expr, Graph, Leaf, Symbol};

/// What a file has beside its claims.
#[derive(Clone, Copy, Default)]
pub struct Surroundings<'a> {
    /// Its systems.
    pub systems: &'a [System],
    /// Its motions.
    pub motions: &'a [Trajectory],
}

impl<'a> From<&'a Derivation> for Surroundings<'a> {
    fn from(file: &'a Derivation) -> Surroundings<'a> {
        Surroundings { systems: &file.systems, motions: &file.trajectories }
    }
}

impl Surroundings<'_> {
    /// Whether a state may be without a rate at a time at which it has a value: a formula gives it, and has an edge. The solution of a system
    /// has its rates at every time.
    pub(crate) fn may_lack_a_rate(&self, graph: &mut Graph, claim: &Claim, state: Symbol) -> bool {
        let mut formulas: Vec<Expr> = Vec::new();
        let mut open = claim.trajectories.clone();
        while let Some(motion) = open.pop().and_then(|at| self.motions.get(at)) {
            let given = match &motion.motion {
                Motion::Integrated { .. } => continue,
                Motion::Formula { states } => states.iter().filter(|(s, _)| *s == state).collect(),
                // Of a motion that is made of another one, the other one's states matter, too.
                Motion::Derived { from, map } => {
                    open.push(*from);
                    map.iter().collect::<Vec<_>>()
                }
            };
            formulas.extend(given.into_iter().flat_map(|(_, w)| w.value.iter().copied()));
        }
        let moves = |leaf: &Leaf| claim.scope.time() == Some(*leaf) || claim.scope.moves(leaf);
        let edges = graph.reachable(formulas).into_iter().flat_map(|e| graph.edges(e)).collect::<Vec<_>>();
        let kinks = edges.into_iter().filter(|edge| !matches!(edge.change, Change::Pole(..) | Change::Log));
        let vanishing: Vec<Expr> = kinks.filter_map(|edge| edge.vanishing).collect();
        graph.leaves_within(vanishing).iter().any(moves)
    }
}
