//! Searches along a motion, compiled when a motion is made ready and carried out when they are first asked for.
//!
//! Compiling needs the graph of the motion, and costs little; the search itself may run later, on any thread, and only if
//! something depends on it.

use std::sync::{Arc, OnceLock};

use super::core::Core;
use super::definitions::Definitions;
use super::error::FlowError;
use super::motion::Motion;
use super::program::Program;
use super::rapid::RapidSearch;
use super::zeros::{Zeros, zeros};
use expr::{Expr, Graph};

/// A search for the zeros of one expression along a motion.
#[derive(Debug)]
pub struct Search {
    core: Arc<Core>,
    program: Arc<Program>,
    span: (f64, f64),
    found: OnceLock<Zeros>,
}

impl Search {
    /// The same search along a motion with other numbers.
    pub(super) fn again(&self, core: Arc<Core>, span: (f64, f64)) -> Search {
        Search { core, program: Arc::clone(&self.program), span, found: OnceLock::new() }
    }

    /// What is found inside the span; the search is made once.
    pub fn zeros(&self) -> &Zeros {
        self.found.get_or_init(|| zeros(&self.core, &self.program).within(self.span))
    }
}

/// Searches along one motion.
#[derive(Clone, Debug)]
pub struct Searches {
    /// For the zeros of expressions, in their order: for each, [`FlowError::UnknownLeaf`] or [`FlowError::NoDerivative`] if it has no
    /// meaning on the motion.
    pub zeros: Vec<Result<Arc<Search>, FlowError>>,
    /// For where expressions vary rapidly, by their positions; those without a meaning on the motion do so nowhere.
    pub rapid: Arc<RapidSearch>,
}

impl Motion {
    /// Compiles searches for the zeros of expressions in leaves, and for where expressions vary rapidly; of the zeros, only those that
    /// lie in `span` are kept.
    ///
    /// # Errors
    /// None that the expressions may cause: see [`Searches`].
    pub fn searches(
        &self,
        graph: &mut Graph,
        (zeros, rapid): (&[Expr], &[Expr]),
        span: (f64, f64),
    ) -> Result<Searches, FlowError> {
        let mut core = self.core.clone();
        let mut program = |&e: &Expr| {
            let resolved = core.resolve(graph, e)?;
            core.compile(graph, &[resolved])
        };
        let programs: Vec<Result<Program, FlowError>> = zeros.iter().map(&mut program).collect();
        let rapid: Vec<Option<Expr>> = rapid.iter().map(|&e| core.resolve(graph, e).ok()).collect();
        let core = Arc::new(core);
        let search = |program| {
            Arc::new(Search { core: Arc::clone(&core), program: Arc::new(program), span, found: OnceLock::new() })
        };
        let zeros = programs.into_iter().map(|program| program.map(search)).collect();
        Ok(Searches { zeros, rapid: Arc::new(core.rapid_search(graph, &rapid)?) })
    }
}
