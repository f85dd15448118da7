//! The systems of a derivation, solved for their rates.
//!
//! **In:** the equations of every system. **Out:** [`Fields`]: a vector field for each, or a diagnostic with its place. The motions of a
//! file share the memory: each may have so many steps.

use derivation::Derivation;
use diag::Diagnostic;
use expr::{Expr, Graph, Leaf, Shape, Symbol};
use flow::VectorField;
use latex::Role;

use claim::system::solved;

/// The leaves of all components of a symbol.
pub(crate) fn leaves_of(graph: &Graph, symbol: Symbol) -> Vec<Leaf> {
    let count = graph.component_count(symbol);
    (0..count).map(|c| Leaf::now(symbol, c as u16)).collect()
}

pub(crate) fn paired(graph: &Graph, symbol: Symbol, rate: u8, values: &[Expr]) -> Vec<(Leaf, Expr)> {
    leaves_of(graph, symbol).into_iter().map(|l| Leaf { rate, ..l }).zip(values.iter().copied()).collect()
}

/// The systems of a derivation, solved for their rates.
pub struct Fields {
    pub(crate) time: Leaf,
    pub(crate) fields: Vec<VectorField>,
    /// The state variables of all systems, and the states of motions given by formulas.
    pub state_leaves: Vec<Leaf>,
}

/// The numbers that the motions of a file may keep together.
const MOST_NUMBERS: usize = 300_000_000;
/// The numbers that a motion keeps of a state for every step: its polynomial, and its error.
const NUMBERS_OF_A_STEP: usize = 23;
/// So many steps are allowed in any case.
const LEAST_STEPS: usize = 100;

impl Fields {
    /// The field of every system, in the order of the file.
    pub fn all(&self) -> &[VectorField] {
        &self.fields
    }

    /// Solves the systems of a file; the graph is that of the file, and grows.
    ///
    /// # Errors
    /// A diagnostic for every system that cannot be solved.
    pub fn solve(graph: &mut Graph, derivation: &Derivation) -> Result<Fields, Vec<Diagnostic>> {
        let mut problems = Vec::new();
        let Derivation { scope, systems, symbols, file, .. } = derivation;
        let motionless = derivation.trajectories.is_empty() && systems.iter().all(|s| s.states.is_empty());
        let absent = |graph: &mut Graph| motionless.then(|| Leaf::now(graph.declare("t", Shape::scalar(), false), 0));
        let Some(time) = scope.time().or_else(|| absent(graph)) else {
            return Err(vec![
                Diagnostic::at(file, "derivation::no-time", 0..0, "no symbol has the role `time`")
                    .hint("add `'t' = { role = \"time\" }` to [symbols]"),
            ]);
        };
        let mut fields = Vec::new();
        // The motions share the memory.
        let each = MOST_NUMBERS / derivation.trajectories.len().max(1);
        for system in systems.iter() {
            match solved(graph, scope, system, time) {
                Ok(field) => {
                    let most = (each / (NUMBERS_OF_A_STEP * field.states().len().max(1))).max(LEAST_STEPS);
                    fields.push(field.with_most_steps(most));
                }
                Err(error) => {
                    let message = format!("the system `{}` cannot be solved for its rates: {error}", system.id);
                    problems.push(Diagnostic::at(file, "flow::system", system.span.clone(), message));
                }
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        let mut state_leaves: Vec<Leaf> = fields.iter().flat_map(|f| f.states().to_vec()).collect();
        let of_formulas = symbols.iter().filter(|s| s.role == Role::State).flat_map(|s| leaves_of(graph, s.symbol));
        state_leaves.extend(of_formulas);
        state_leaves.sort_unstable();
        state_leaves.dedup();
        Ok(Fields { time, fields, state_leaves })
    }
}
