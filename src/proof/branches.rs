//! A formula with ±: a family of questions, one for each choice of the sign.
//!
//! **In:** the equations for each choice, what is given, and what ± is claimed to be. **Out:** the answer of each choice and that of all of
//! them point by point; and which of these is the answer of the claim.

use super::memory::Memory;
use super::outcome::{Identity, Options, Premises, Reason};
use super::prove::identity_test_after;
use expr::{Expr, Graph};

type Pairs = Vec<(Expr, Expr)>;

/// The answer for a family of branches: a formula with ±, one list of equations for each choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Branches {
    /// For each branch: whether it holds by itself, at every point.
    pub throughout: Vec<Identity>,
    /// Whether at every point some branch holds (which one may change from point to point).
    pub pointwise: Identity,
}

/// What ± is claimed to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branching {
    /// Some sign at each point.
    Pointwise,
    /// One sign for all points.
    Throughout,
    /// One sign for all points of a motion, or of a field; another one may have the other sign.
    ThroughoutMotion,
}

impl Branches {
    /// The answer, and the branch that it is of; of an answer point by point there is none.
    ///
    /// One sign is proved where one branch is, and refuted where points refute both. Points of what moves may belong to two motions, each of
    /// which has its sign: only a point at which no sign serves refutes there.
    pub fn told(self, branching: Branching) -> (Identity, Option<usize>) {
        let Branches { throughout: mut each, pointwise } = self;
        if branching == Branching::Pointwise {
            return (pointwise, None);
        }
        let first = |wanted: fn(&Identity) -> bool| each.iter().position(wanted);
        let proved = first(|i| matches!(i, Identity::Proved(_)));
        let open = first(|i| matches!(i, Identity::Undecided(_)));
        match (proved, branching, &pointwise) {
            (None, Branching::ThroughoutMotion, Identity::Refuted(_)) => (pointwise, None),
            (None, Branching::ThroughoutMotion, _) if open.is_none() => {
                (Identity::Undecided(Reason::EachSign), Some(0))
            }
            _ => {
                let at = proved.or(open).unwrap_or(0);
                (each.swap_remove(at), Some(at))
            }
        }
    }
}

/// Tests a family of branches, as a whole and each by itself.
///
/// "Some branch at each point" is one identity: of the residuals f of the branches, ∏ f = 0; for systems, every product that
/// takes one residual of each branch.
pub fn branches_test(
    graph: &mut Graph,
    branches: &[Vec<(Expr, Expr)>],
    given: &Premises,
    options: &Options,
) -> Branches {
    branches_test_after(&mut Memory::default(), graph, branches, given, options)
}

/// The same, after other questions about the same graph.
pub fn branches_test_after(
    memory: &mut Memory,
    graph: &mut Graph,
    branches: &[Vec<(Expr, Expr)>],
    given: &Premises,
    options: &Options,
) -> Branches {
    let throughout = branches.iter().map(|b| identity_test_after(memory, graph, b, given, options)).collect();
    let zero = graph.integer(0);
    let mut products = vec![graph.integer(1)];
    for branch in branches {
        let mut next = Vec::new();
        for &p in &products {
            for &(l, r) in branch {
                let residual = graph.sub(l, r);
                next.push(graph.mul(p, residual));
            }
        }
        if next.len() > 256 {
            return Branches { throughout, pointwise: Identity::Undecided(Reason::TooLarge) };
        }
        products = next;
    }
    let equations: Pairs = products.into_iter().map(|p| (p, zero)).collect();
    Branches { throughout, pointwise: identity_test_after(memory, graph, &equations, given, options) }
}
