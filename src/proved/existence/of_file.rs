//! The motions of a file that may show that what is given to a claim can be so.
//!
//! **In:** a claim. **Out:** motions on which it is tried. **Guaranteed:** each moves by every system that the claim follows from, and goes
//! through all fixed times that are named; whether the claim applies to it, and other claims hold on it, is for those to say who tried them.

use crate::derivation::{Claim, Derivation, Motion, Premise, Written};
use crate::expr::domain::Change;
use crate::expr::{Expr, Symbol};
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
    let counts = |at| moves_by(derivation, at, &systems) && goes_through(derivation, at, &instants);
    out.retain(|&at| counts(at) && is_smooth(derivation, at));
    out
}

/// Whether a motion was integrated from all of some systems.
fn moves_by(derivation: &Derivation, at: usize, systems: &[usize]) -> bool {
    systems.iter().all(|wanted| match &derivation.trajectories[at].motion {
        Motion::Integrated { system, .. } => system == wanted,
        Motion::Formula { .. } | Motion::Derived { .. } => false,
    })
}

/// Whether a motion that is given by formulas has no hole and no edge; one that is integrated ends where it has one.
fn is_total_motion(derivation: &Derivation, at: usize) -> bool {
    let is_total = |formulas: &[Expr]| said::is_total(derivation, &mut derivation.graph.clone(), formulas);
    let written =
        |of: &[(Symbol, Written<Vec<Expr>>)]| of.iter().flat_map(|(_, w)| w.value.clone()).collect::<Vec<_>>();
    match &derivation.trajectories[at].motion {
        Motion::Integrated { .. } => true,
        Motion::Formula { states } => is_total(&written(states)),
        Motion::Derived { from, map } => is_total(&written(map)) && is_total_motion(derivation, *from),
    }
}

/// Whether a motion is as smooth as any formula needs: it has no hole and no edge, and the rates of the system that it was integrated from do
/// not leap, nor do their slopes.
fn is_smooth(derivation: &Derivation, at: usize) -> bool {
    let mut source = at;
    while let Motion::Derived { from, .. } = &derivation.trajectories[source].motion {
        source = *from;
    }
    let rates = match &derivation.trajectories[source].motion {
        Motion::Integrated { system, .. } => {
            let relations = derivation.systems[*system].equations.iter().flat_map(|w| &w.value.relations);
            relations.flat_map(|r| r.left.components.iter().chain(&r.right.components)).copied().collect()
        }
        Motion::Formula { .. } | Motion::Derived { .. } => Vec::new(),
    };
    let rates = Said::of_formulas(rates).with_definitions(derivation).formulas;
    let mut graph = derivation.graph.clone();
    let all = graph.reachable(rates);
    let leaps = |node: Expr| graph.edges(node).iter().any(|edge| matches!(edge.change, Change::Jump(_) | Change::Kink));
    !all.into_iter().any(leaps) && is_total_motion(derivation, at)
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
