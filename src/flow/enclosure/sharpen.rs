//! First integrals make bounds of other quantities sharper.
//!
//! Over a stretch of time every state is x = p + e, with a polynomial p and |e| ≤ E. What is claimed to vanish, g, often does so
//! only because integrals F of the motion have the values that they have, and then E hides that: g(p + e) is as wide as E.
//! But F(x) is known, it is F(x₀).
//!
//! **Theorem.** Let Λ be any polynomials of time, and X(t) a convex set with p(t) and x(t). Then
//!
//! g(x) ∈ g(p) + Λ(F(x₀) − F(p)) + (∇g − Λ∇F)(X)·[−E, E].
//!
//! For the function g − ΛF of x, at fixed t, takes the value g(p) − ΛF(p) at p, and the mean value theorem applies to it
//! ([Neumaier 1990, §2.3]); at x it is g(x) − ΛF(x₀). Where ∇g is a combination of the ∇F on the set on which F = F(x₀), as it
//! is for every consequence of F = F(x₀), Λ can be chosen so that the last term is of second order in E.
//!
//! Λ is found in floating point: least squares at a few times of the stretch, and a polynomial through what is found. Nothing is
//! assumed of it. What must be true is that F is constant along the motion: see [`Enclosure::conserve`].
//!
//! [Neumaier 1990, §2.3]: https://doi.org/10.1017/CBO9780511526473

use super::compiled::{Compiled, Reach, Stretch};
use super::Enclosure;
use crate::expr::{Expr, Graph, Leaf};
use crate::flow::error::{FlowError, leaf_name};
use crate::number::{Interval, NODES, NoValue, Number, TaylorModel};
use nalgebra::DMatrix;

/// Singular values below this part of the largest one are taken for 0.
const NEGLIGIBLE: f64 = 1e-7;

/// Quantities that vanish, or nearly, with the gradients of theirs and of the integrals.
#[derive(Clone, Debug)]
pub struct Sharp {
    /// The quantities, then the integrals.
    values: Compiled,
    /// Derivatives by states that do not vanish, with row and state.
    slopes: Compiled,
    entries: Vec<(usize, usize)>,
    quantities: usize,
    states: usize,
    /// The integrals at the start.
    start: Vec<Interval>,
}

impl Sharp {
    /// Number of operations of one evaluation.
    pub fn operations(&self) -> usize {
        let integrals = self.start.len();
        self.values.operations() + self.slopes.operations() + 2 * self.quantities * integrals * (self.states + 1)
    }
}

impl Enclosure {
    /// Takes note of expressions in the leaves of an integrated motion.
    ///
    /// **What the caller guarantees:** each is constant along every motion of the system, wherever it has a value. One that the
    /// motion does not know, or that is no function of its states, is left out.
    pub fn conserve(&mut self, graph: &mut Graph, integrals: &[Expr]) {
        let Some(tube) = self.tube.clone() else { return };
        for &e in integrals {
            let Ok(resolved) = self.resolved(graph, e) else { continue };
            let leaves = graph.leaves([resolved]);
            let known = |l: &Leaf| tube.states.contains(l) || self.constants.iter().any(|c| c.0 == *l);
            if !leaves.iter().all(known) {
                continue;
            }
            let Ok(compiled) = self.compile_resolved(graph, &[resolved]) else { continue };
            if let Some(Ok(start)) = self.value(&compiled, Interval::point(self.initial_time)).pop() {
                self.integrals.push((resolved, start));
            }
        }
    }

    /// Whether there is anything that makes bounds sharper.
    pub fn conserves(&self) -> bool {
        !self.integrals.is_empty()
    }

    /// Compiles quantities, in the leaves of [`Enclosure::compile_resolved`], to be bounded with the help of the integrals.
    ///
    /// # Errors
    /// [`FlowError::NoDerivative`], [`FlowError::UnknownLeaf`].
    pub fn sharp(&self, graph: &mut Graph, quantities: &[Expr]) -> Result<Sharp, FlowError> {
        let states: &[Leaf] = self.tube.as_deref().map_or(&[], |t| &t.states);
        let mut roots = quantities.to_vec();
        roots.extend(self.integrals.iter().map(|i| i.0));
        let (mut entries, mut slopes) = (Vec::new(), Vec::new());
        for (row, &e) in roots.iter().enumerate() {
            let present = graph.leaves([e]);
            for (i, &state) in states.iter().enumerate().filter(|(_, s)| present.contains(s)) {
                let slope = graph
                    .partial_derivative(e, state)
                    .map_err(|reason| FlowError::NoDerivative { leaf: leaf_name(graph, state), reason })?;
                if !graph.is_zero(slope) {
                    entries.push((row, i));
                    slopes.push(slope);
                }
            }
        }
        Ok(Sharp {
            values: self.compile_resolved(graph, &roots)?,
            slopes: self.compile_resolved(graph, &slopes)?,
            entries,
            quantities: quantities.len(),
            states: states.len(),
            start: self.integrals.iter().map(|i| i.1).collect(),
        })
    }

    /// What the quantities do over a stretch of time, by the theorem of the module.
    ///
    /// # Errors
    /// For each quantity, why the theorem does not apply: it or a derivative has no value, or may have none.
    pub fn sharpened(&self, sharp: &Sharp, stretch: &Stretch) -> Vec<Result<Reach, NoValue>> {
        let nothing = |reason| vec![Err(reason); sharp.quantities];
        let states = match stretch.models() {
            Ok(states) if states.len() == sharp.states => states,
            Ok(_) => return nothing(NoValue::Indeterminate),
            Err(reason) => return nothing(*reason),
        };
        let spread: Vec<f64> = states.iter().map(TaylorModel::remainder).collect();
        let centre: Vec<TaylorModel> = states.iter().map(TaylorModel::polynomial).collect();
        let values = self.models(&sharp.values, stretch, &Ok(centre));
        let slopes = self.models(&sharp.slopes, stretch, stretch.models());
        let n = sharp.states;
        let mut of: Vec<Vec<Option<Result<TaylorModel, NoValue>>>> = vec![vec![None; n]; values.len()];
        for (&(row, i), slope) in sharp.entries.iter().zip(slopes) {
            of[row][i] = Some(slope);
        }
        // The integrals that have values.
        let integrals: Vec<usize> = (sharp.quantities..values.len())
            .filter(|&k| values[k].is_ok() && of[k].iter().flatten().all(Result::is_ok))
            .collect();
        let inverses: Vec<DMatrix<f64>> = (0..NODES).filter_map(|node| inverse(&integrals, &of, &spread, node)).collect();
        if inverses.len() != NODES {
            return nothing(NoValue::Indeterminate);
        }
        let one = |q: usize| {
            let mut sum = values[q].clone()?;
            let mut rest: Vec<Option<TaylorModel>> = Vec::new();
            for slope in &of[q] {
                rest.push(slope.clone().transpose()?);
            }
            let factors = factors(&rest, &inverses, &spread);
            for (&k, factor) in integrals.iter().zip(&factors) {
                let (Ok(now), true) = (&values[k], factor.bound() > 0.0) else { continue };
                let (mut left, mut product) = (TaylorModel::ZERO, TaylorModel::ZERO);
                left.sub(&(), &TaylorModel::constant(sharp.start[k - sharp.quantities]), now)?;
                product.mul(&(), factor, &left)?;
                let before = sum;
                sum.add(&(), &before, &product)?;
                for (rest, slope) in rest.iter_mut().zip(&of[k]) {
                    let Some(Ok(slope)) = slope else { continue };
                    let (mut product, before) = (TaylorModel::ZERO, rest.unwrap_or(TaylorModel::ZERO));
                    product.mul(&(), factor, slope)?;
                    let mut after = TaylorModel::ZERO;
                    after.sub(&(), &before, &product)?;
                    *rest = Some(after);
                }
            }
            let spreads = rest.iter().zip(&spread).filter_map(|(rest, &e)| Some((rest.as_ref()?, e)));
            let room = spreads.fold(Interval::point(0.0), |sum, (rest, e)| {
                sum + Interval::point(rest.bound()) * Interval::point(e)
            });
            Ok(Reach::new(stretch, sum.widened(room.hi())))
        };
        (0..sharp.quantities).map(one).collect()
    }
}

/// The pseudo-inverse of the gradients of the integrals at a node, by states in units of their spread.
fn inverse(
    integrals: &[usize],
    slopes: &[Vec<Option<Result<TaylorModel, NoValue>>>],
    spread: &[f64],
    node: usize,
) -> Option<DMatrix<f64>> {
    let entry = |k: usize, i: usize| match &slopes[integrals[k]][i] {
        Some(Ok(slope)) => slope.at_node(node) * spread[i],
        _ => 0.0,
    };
    let gradients = DMatrix::from_fn(integrals.len(), spread.len(), entry);
    let largest = gradients.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if !largest.is_finite() {
        return None;
    }
    if largest == 0.0 {
        return Some(DMatrix::zeros(spread.len(), integrals.len()));
    }
    gradients.pseudo_inverse(NEGLIGIBLE * largest).ok()
}

/// Λ for one quantity: its gradient, in the gradients of the integrals.
fn factors(gradient: &[Option<TaylorModel>], inverses: &[DMatrix<f64>], spread: &[f64]) -> Vec<TaylorModel> {
    let count = inverses.first().map_or(0, DMatrix::ncols);
    let mut values = vec![[0.0; NODES]; count];
    for (node, inverse) in inverses.iter().enumerate() {
        for (i, slope) in gradient.iter().enumerate() {
            let Some(slope) = slope else { continue };
            let size = slope.at_node(node) * spread[i];
            for (k, value) in values.iter_mut().enumerate() {
                value[node] += size * inverse[(i, k)];
            }
        }
    }
    values.iter().map(|v| TaylorModel::through(v).unwrap_or(TaylorModel::ZERO)).collect()
}
