//! A system of a file, closed and solved for its rates.
//!
//! **In:** the equations of a system, as written. **Out:** the rates of its states, in states, parameters and the time; or why they
//! cannot be told. **Guaranteed:** observables and their rates are written out, so that nothing but states moves in them.

use crate::comparison::{behind_rates, traced_now};
use crate::derivation::System;
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::FlowError;
pub use crate::flow::VectorField;
use crate::latex::Scope;

/// A system, solved for its rates. Observables in its equations are part of the system: it is closed in its states.
///
/// # Errors
/// See [`VectorField::solve`].
pub fn solved(graph: &mut Graph, scope: &Scope, system: &System, time: Leaf) -> Result<VectorField, FlowError> {
    let mut closed: Vec<(Expr, Expr)> = Vec::new();
    // Equations of fields have no motions.
    let of_states = system.equations.iter().filter(|_| !system.states.is_empty());
    for relation in of_states.flat_map(|w| &w.value.relations) {
        for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
            let [l, r] = [l, r].map(|side| {
                let side = behind_rates(graph, scope, side);
                traced_now(graph, scope, side)
            });
            closed.push((l, r));
        }
    }
    VectorField::solve(graph, Some(time), &system.states, &closed)
}

/// The rate of each state variable; `None` where the system cannot be solved.
pub fn rates(graph: &mut Graph, scope: &Scope, system: &System, time: Leaf) -> Option<Vec<(Leaf, Expr)>> {
    let field = solved(graph, scope, system, time).ok()?;
    Some(field.states().iter().copied().zip(field.rates().iter().copied()).collect())
}
