//! The motions of a file that may show that what is given to a claim can be so.
//!
//! **In:** a claim. **Out:** motions on which it is tried. **Guaranteed:** each moves by every system that the claim follows from, and goes
//! through all fixed times that are named; whether the claim applies to it, and other claims hold on it, is for those to say who tried them.

use crate::derivation::{Claim, Derivation, Motion, Premise, Written};
use crate::expr::domain::{Change, EdgeOf};
use crate::expr::{Expr, Graph, Symbol};
use crate::said::{self, Said, Sayings};

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
    out.retain(|&at| moves_by(derivation, at, &systems));
    if out.is_empty() {
        return out;
    }
    let mut graph = derivation.graph.clone();
    out.retain(|&at| goes_through(derivation, &mut graph, at, &instants) && is_smooth(derivation, &mut graph, at));
    out
}

/// Whether a motion was integrated from all of some systems.
fn moves_by(derivation: &Derivation, at: usize, systems: &[usize]) -> bool {
    systems.iter().all(|wanted| match &derivation.trajectories[at].motion {
        Motion::Integrated { system, .. } => system == wanted,
        Motion::Formula { .. } | Motion::Derived { .. } => false,
    })
}

/// Whether a motion is as smooth as any formula needs: one by formulas has no hole and no edge; of one that is integrated the rates do not
/// leap, nor do their slopes, and it ends where they have no value.
fn is_smooth(derivation: &Derivation, graph: &mut Graph, at: usize) -> bool {
    let mut is_total = |of: &[(Symbol, Written<Vec<Expr>>)]| {
        let formulas: Vec<Expr> = of.iter().flat_map(|(_, w)| w.value.iter().copied()).collect();
        said::is_total(derivation, graph, &Said::of_formulas(formulas).with_definitions(derivation).formulas)
    };
    match &derivation.trajectories[at].motion {
        Motion::Formula { states } => is_total(states),
        Motion::Derived { from, map } => is_total(map) && is_smooth(derivation, graph, *from),
        Motion::Integrated { system, .. } => {
            let relations = derivation.systems[*system].equations.iter().flat_map(|w| &w.value.relations);
            let rates = relations.flat_map(|r| r.left.components.iter().chain(&r.right.components)).copied().collect();
            let rates = Said::of_formulas(rates).with_definitions(derivation).formulas;
            let all = graph.reachable(rates);
            let leaps = |edge: &EdgeOf| matches!(edge.change, Change::Jump(_) | Change::Kink);
            !all.into_iter().any(|node| graph.edges(node).iter().any(leaps))
        }
    }
}

/// Whether all of some times lie in the span of a motion.
fn goes_through(derivation: &Derivation, graph: &mut Graph, at: usize, instants: &[Expr]) -> bool {
    let trajectory = &derivation.trajectories[at];
    instants.iter().all(|&instant| {
        let closed = graph.substitute(instant, |_, leaf| {
            trajectory.parameter(leaf.symbol)?.get(usize::from(leaf.component)).copied()
        });
        graph.number(closed).is_some_and(|t| (trajectory.span.0..=trajectory.span.1).contains(&t))
    })
}
