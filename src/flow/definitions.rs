//! How a leaf is traced back to what a motion is made of.
//!
//! Every leaf that a formula may name has a definition in *basic* leaves: the time, the integrated states, constants with a value,
//! and what counts the turns of angles. A sampled motion and an enclosed one differ in what a constant is worth and in how a value
//! at a fixed time is found; all else is here, once.
//!
//! **In:** leaves and expressions as formulas name them. **Out:** expressions in basic leaves. **Guaranteed:** a rate is the
//! derivative of the definition, and has no value where the definition has none.

use std::collections::BTreeMap;

use super::error::{FlowError, leaf_name};
use super::field::VectorField;
use super::hoist::hoist;
use expr::{Expr, Graph, Leaf, NoDerivative, Shape};

/// A new symbol for a number that formulas cannot name.
pub(super) fn fresh(graph: &mut Graph, name: &str) -> Leaf {
    let symbol = graph.declare(name, Shape::scalar(), false);
    Leaf::now(symbol, 0)
}

/// An angle that is continued beyond its cut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Continued {
    /// As it is continued.
    pub(super) angle: Expr,
    /// What it is but for whole turns.
    pub(super) raw: Expr,
    /// Its derivative along the motion, if there is one.
    pub(super) rate: Option<Expr>,
}

/// The right sides of a system in basic leaves.
pub(super) struct Rates {
    /// Basic leaves of the states.
    pub(super) states: Vec<Leaf>,
    /// Their rates.
    pub(super) rates: Vec<Expr>,
    /// What does not move and stands in the rates: a new leaf for each, and what it is.
    pub(super) constants: Vec<(Leaf, Expr)>,
}

/// See the module.
pub(super) trait Definitions {
    /// The leaf of the time.
    fn time(&self) -> Leaf;
    /// What is defined already.
    fn known(&mut self) -> &mut BTreeMap<Leaf, Expr>;
    /// The integrated states, and their rates.
    fn integrated(&self) -> Option<(&[Leaf], &[Expr])>;
    /// Whether a leaf is a constant, or counts turns.
    fn is_constant(&self, leaf: Leaf) -> bool;
    /// Angles as they are continued.
    fn continued(&self) -> &[Continued];
    /// A leaf at the fixed time `instant`, as a constant.
    ///
    /// # Errors
    /// See [`Definitions::definition`].
    fn at_instant(&mut self, graph: &mut Graph, now: Leaf, instant: Expr) -> Result<Expr, FlowError>;

    /// Expressions of the same values, without angles of which only a direction is asked.
    fn without_angles(&self, graph: &mut Graph, of: &[Expr]) -> Vec<Expr> {
        let turned: Vec<(Expr, Expr)> = self.continued().iter().map(|c| (c.angle, c.raw)).collect();
        graph.without_angles(of, &turned)
    }

    /// An expression in basic leaves.
    ///
    /// # Errors
    /// [`FlowError::UnknownLeaf`], [`FlowError::NoDerivative`].
    fn resolve(&mut self, graph: &mut Graph, e: Expr) -> Result<Expr, FlowError> {
        let mut image = BTreeMap::new();
        for leaf in graph.leaves([e]) {
            image.insert(leaf, self.definition(graph, leaf)?);
        }
        let resolved = graph.substitute(e, |_, leaf| image.get(&leaf).copied());
        Ok(self.without_angles(graph, &[resolved]).pop().unwrap_or(resolved))
    }

    /// The definition of a leaf; rates are derived, values at fixed times become constants.
    ///
    /// # Errors
    /// See [`Definitions::resolve`].
    fn definition(&mut self, graph: &mut Graph, leaf: Leaf) -> Result<Expr, FlowError> {
        if let Some(&known) = self.known().get(&leaf) {
            return Ok(known);
        }
        let is_state = self.integrated().is_some_and(|(states, _)| states.contains(&leaf));
        if leaf == self.time() || is_state || self.is_constant(leaf) {
            return Ok(graph.leaf(leaf));
        }
        let unknown = |graph: &Graph| FlowError::UnknownLeaf { leaf: leaf_name(graph, leaf) };
        let found = if let Some(instant) = leaf.instant {
            self.at_instant(graph, Leaf { instant: None, ..leaf }, instant)?
        } else if leaf.rate > 0 {
            let lower = self.definition(graph, Leaf { rate: leaf.rate - 1, ..leaf }).map_err(|error| match error {
                FlowError::UnknownLeaf { .. } => unknown(graph),
                other => other,
            })?;
            self.derivative(graph, lower)
                .map_err(|reason| FlowError::NoDerivative { leaf: leaf_name(graph, leaf), reason })?
        } else {
            return Err(unknown(graph));
        };
        self.known().insert(leaf, found);
        Ok(found)
    }

    /// The derivative along the motion of an expression in basic leaves.
    ///
    /// # Errors
    /// See [`Graph::directional_derivative`].
    fn derivative(&self, graph: &mut Graph, e: Expr) -> Result<Expr, NoDerivative> {
        let known: Vec<(Expr, Expr)> = self.continued().iter().filter_map(|c| Some((c.angle, c.rate?))).collect();
        let rate = graph.derivative_knowing(e, &known, |graph, leaf| {
            if leaf == self.time() {
                return Some(graph.integer(1));
            }
            let (states, rates) = self.integrated()?;
            states.iter().position(|&l| l == leaf).map(|i| rates[i])
        })?;
        Ok(graph.rate_of(e, rate, |_| false))
    }

    /// Makes the states of a system basic leaves. Their rates can be resolved before there is a motion.
    ///
    /// # Errors
    /// See [`Definitions::resolve`].
    fn rates_of(&mut self, graph: &mut Graph, field: &VectorField) -> Result<Rates, FlowError> {
        let mut states = Vec::new();
        for &leaf in field.states() {
            let name = graph.leaf_latex(leaf);
            let basic = fresh(graph, &name);
            let e = graph.leaf(basic);
            self.known().insert(leaf, e);
            states.push(basic);
        }
        let mut image: BTreeMap<Leaf, Expr> = BTreeMap::new();
        for leaf in graph.leaves(field.rates().iter().copied()) {
            image.insert(leaf, self.definition(graph, leaf)?);
        }
        let rates: Vec<Expr> =
            field.rates().iter().map(|&e| graph.substitute(e, |_, leaf| image.get(&leaf).copied())).collect();
        let rates = self.without_angles(graph, &rates);
        let (time, mut constants) = (self.time(), Vec::new());
        let moves = |l| l == time || states.contains(&l);
        let rates = hoist(graph, &rates, moves, |graph, e| {
            let leaf = fresh(graph, "constant");
            constants.push((leaf, e));
            leaf
        });
        Ok(Rates { states, rates, constants })
    }
}
