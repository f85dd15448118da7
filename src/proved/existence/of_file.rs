//! The motions of a file that may show that what is given to a claim can be so.
//!
//! **In:** a claim. **Out:** motions on which it is tried. **Guaranteed:** each moves by every system that the claim follows from, and goes
//! through all fixed times that are named; whether the claim applies to it, and other claims hold on it, is for those to say who tried them.

use crate::derivation::{Claim, Derivation, Motion, Premise};
use crate::expr::Expr;
use crate::said::Sayings;

/// The positions of these motions, and of those that families vary.
pub fn motions_of_file(derivation: &Derivation, claim: &Claim) -> Vec<usize> {
    let said = Sayings::of(derivation, claim);
    let instants: Vec<Expr> =
        said.claimed.instants(derivation).union(&said.given.instants(derivation)).copied().collect();
    let premises = derivation.given_to(claim).into_iter().map(|name| derivation.premise(&name));
    let systems: Vec<usize> = premises
        .filter_map(|premise| match premise {
            Premise::System(at) => Some(at),
            Premise::Claim(_) | Premise::Definition => None,
        })
        .collect();
    let varied = claim.families.iter().map(|&f| derivation.families[f].of);
    let mut out: Vec<usize> = claim.trajectories.iter().copied().chain(varied).collect();
    out.sort_unstable();
    out.dedup();
    out.retain(|&at| moves_by(derivation, at, &systems) && goes_through(derivation, at, &instants));
    out
}

/// Whether a motion was integrated from all of some systems.
fn moves_by(derivation: &Derivation, at: usize, systems: &[usize]) -> bool {
    systems.iter().all(|wanted| match &derivation.trajectories[at].motion {
        Motion::Integrated { system, .. } => system == wanted,
        Motion::Formula { .. } | Motion::Derived { .. } => false,
    })
}

/// Whether all of some times lie in the span of a motion.
fn goes_through(derivation: &Derivation, at: usize, instants: &[Expr]) -> bool {
    let trajectory = &derivation.trajectories[at];
    let mut graph = derivation.graph.clone();
    instants.iter().all(|&instant| {
        let closed = graph.substitute(instant, |_, leaf| {
            trajectory.parameter(leaf.symbol)?.get(usize::from(leaf.component)).copied()
        });
        graph.number(closed).is_some_and(|t| (trajectory.span.0..=trajectory.span.1).contains(&t))
    })
}
