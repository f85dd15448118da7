//! Searches for zeros, compiled when a motion is made ready and carried out when they are first asked for.
//!
//! Compiling needs the graph of the motion, and costs little; the search itself may run later, on any thread, and only if
//! something depends on it.

use std::sync::{Arc, OnceLock};

use super::core::Core;
use super::definitions::Definitions;
use super::error::FlowError;
use super::motion::Motion;
use super::program::Program;
use super::rapid::{Rapid, rapid};
use super::zeros::{Zeros, zeros};
use expr::{Expr, Graph};

/// A search for the zeros of one expression along a motion.
#[derive(Debug)]
pub struct Search {
    core: Arc<Core>,
    program: Program,
    span: (f64, f64),
    found: OnceLock<Zeros>,
    rapid: OnceLock<Rapid>,
}

impl Search {
    /// What it is searched with.
    pub(super) fn core(&self) -> &Core {
        &self.core
    }

    /// The same search along a motion with other numbers.
    pub(super) fn again(&self, core: Arc<Core>, span: (f64, f64)) -> Search {
        Search { core, program: self.program.clone(), span, found: OnceLock::new(), rapid: OnceLock::new() }
    }

    /// What is found inside the span; the search is made once.
    pub fn zeros(&self) -> &Zeros {
        self.found.get_or_init(|| zeros(&self.core, &self.program).within(self.span))
    }

    /// Where the expression varies more rapidly than the samples of the motion tell; they are looked at once.
    pub fn rapid(&self, samples: &[f64]) -> &Rapid {
        self.rapid.get_or_init(|| rapid(&self.core, &self.program, samples))
    }
}

impl Motion {
    /// Compiles searches for the zeros of expressions in leaves; of what they find, only what lies in `span` is kept.
    ///
    /// # Errors
    /// For each expression, [`FlowError::UnknownLeaf`] or [`FlowError::NoDerivative`].
    pub fn searches(&self, graph: &mut Graph, exprs: &[Expr], span: (f64, f64)) -> Vec<Result<Search, FlowError>> {
        let mut core = self.core.clone();
        let programs: Vec<Result<Program, FlowError>> = exprs
            .iter()
            .map(|&e| {
                let resolved = core.resolve(graph, e)?;
                core.compile(graph, &[resolved])
            })
            .collect();
        let core = Arc::new(core);
        let search =
            |program| Search { core: Arc::clone(&core), program, span, found: OnceLock::new(), rapid: OnceLock::new() };
        programs.into_iter().map(|p| p.map(search)).collect()
    }
}
