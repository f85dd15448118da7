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

use super::Enclosure;
use super::reach::{Compiled, Reach, Stretch};
use crate::error::{FlowError, leaf_name};
use expr::{Expr, Graph, Leaf};
use nalgebra::DMatrix;
use number::{Interval, NODES, NoValue, Number, TaylorModel};

/// Singular values below this part of the largest one are taken for 0.
const NEGLIGIBLE: f64 = 1e-7;
/// Factors that move the last term by less than this part of what it would be without them are taken for 0.
const IDLE: f64 = 1e-8;

/// First integrals of a motion.
#[derive(Clone, Debug)]
pub(super) struct Integrals {
    /// The integrals, and their derivatives by states that do not vanish, with row and state.
    values: Compiled,
    slopes: Compiled,
    entries: Entries,
    /// Their values.
    start: Vec<Interval>,
}

/// What integrals do over a stretch of time.
#[derive(Clone, Debug)]
pub(super) struct Known {
    /// The states without what is not known of them, and how much that is.
    centre: Result<Vec<TaylorModel>, NoValue>,
    spread: Vec<f64>,
    /// For each integral with a value: F(x₀) − F(p), and ∇F.
    integrals: Vec<(TaylorModel, Slopes)>,
    /// Pseudo-inverses of the gradients at the nodes, by states in units of their spread.
    inverses: Vec<DMatrix<f64>>,
}

/// Row and state of each derivative that does not vanish.
type Entries = Vec<(usize, usize)>;

/// Derivatives by states: those that do not vanish.
type Slopes = Vec<(usize, TaylorModel)>;

/// Quantities that vanish, or nearly, with their gradients.
#[derive(Clone, Debug)]
pub struct Sharp {
    values: Compiled,
    slopes: Compiled,
    entries: Entries,
}

impl Sharp {
    /// Number of operations of one evaluation, without those on integrals.
    pub fn operations(&self) -> usize {
        self.values.operations() + self.slopes.operations()
    }
}

/// Derivatives of expressions by states, with row and state.
fn gradients(graph: &mut Graph, states: &[Leaf], roots: &[Expr]) -> Result<(Vec<Expr>, Entries), FlowError> {
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
    Ok((slopes, entries))
}

impl Enclosure {
    /// Takes note of expressions in the leaves of an integrated motion.
    ///
    /// **What the caller guarantees:** each is a rational function that is constant along every motion of the system. One that
    /// the motion does not know, or that is no function of its states, is left out.
    pub fn conserve(&mut self, graph: &mut Graph, integrals: &[Expr]) {
        let Some(tube) = self.tube.clone() else { return };
        let (mut kept, mut start) = (Vec::new(), Vec::new());
        for &e in integrals {
            let Ok(resolved) = self.resolved(graph, e) else { continue };
            let known = |l: &Leaf| tube.states.contains(l) || self.constants.iter().any(|c| c.0 == *l);
            if !graph.leaves([resolved]).iter().all(known) {
                continue;
            }
            let Ok(compiled) = self.compile_resolved(graph, &[resolved]) else { continue };
            if let Some(Ok(value)) = self.value(&compiled, Interval::point(self.initial_time)).pop() {
                kept.push(resolved);
                start.push(value);
            }
        }
        let Ok((slopes, entries)) = gradients(graph, &tube.states, &kept) else { return };
        if let (Ok(values), Ok(slopes)) = (self.compile_resolved(graph, &kept), self.compile_resolved(graph, &slopes))
            && !kept.is_empty()
        {
            self.integrals = Some(Integrals { values, slopes, entries, start });
        }
    }

    /// Whether there is anything that makes bounds sharper.
    pub fn conserves(&self) -> bool {
        self.integrals.is_some()
    }

    /// Compiles quantities, in the leaves of [`Enclosure::compile_resolved`], to be bounded with the help of the integrals.
    ///
    /// # Errors
    /// [`FlowError::NoDerivative`], [`FlowError::UnknownLeaf`].
    pub fn sharp(&self, graph: &mut Graph, quantities: &[Expr]) -> Result<Sharp, FlowError> {
        let states: &[Leaf] = self.tube.as_deref().map_or(&[], |t| &t.states);
        let (slopes, entries) = gradients(graph, states, quantities)?;
        let (values, slopes) = (self.compile_resolved(graph, quantities)?, self.compile_resolved(graph, &slopes)?);
        Ok(Sharp { values, slopes, entries })
    }

    /// What the integrals do over a stretch.
    fn known_over(&self, stretch: &Stretch) -> Option<Known> {
        let integrals = self.integrals.as_ref()?;
        let states = stretch.models().as_ref().ok()?;
        let spread: Vec<f64> = states.iter().map(TaylorModel::remainder).collect();
        let centre = Ok(states.iter().map(TaylorModel::polynomial).collect());
        let values = self.models(&integrals.values, stretch, &centre);
        let slopes = self.models(&integrals.slopes, stretch, stretch.models());
        let slopes = by_rows(&integrals.entries, slopes, values.len());
        let mut known = Vec::new();
        for ((value, slopes), &start) in values.into_iter().zip(slopes).zip(&integrals.start) {
            let mut left = TaylorModel::ZERO;
            if let (Ok(value), Ok(slopes)) = (value, slopes)
                && left.sub(&(), &TaylorModel::constant(start), &value).is_ok()
            {
                known.push((left, slopes));
            }
        }
        let inverses = (0..NODES).map(|node| inverse(&known, &spread, node)).collect::<Option<Vec<_>>>()?;
        Some(Known { centre, spread, integrals: known, inverses })
    }

    /// What the quantities do over a stretch of time, by the theorem of the module, and how many operations that took beyond
    /// [`Sharp::operations`].
    ///
    /// **What the caller knows:** each quantity is continuous for all states of the stretch, as it is where [`Enclosure::over`]
    /// has a range of it.
    ///
    /// # Errors
    /// For each quantity, why the theorem does not apply: it or a derivative has no value, or may have none.
    pub fn sharpened(&self, sharp: &Sharp, stretch: &Stretch) -> (Vec<Result<Reach, NoValue>>, usize) {
        let count = sharp.values.outputs();
        let Some(known) = stretch.known(|| self.known_over(stretch)) else {
            return (vec![Err(NoValue::Indeterminate); count], 0);
        };
        let values = self.models(&sharp.values, stretch, &known.centre);
        let slopes = self.models(&sharp.slopes, stretch, stretch.models());
        let slopes = by_rows(&sharp.entries, slopes, count);
        let mut work = 0;
        let each = values.into_iter().zip(slopes).map(|(value, slopes)| {
            let (model, operations) = sharpened(known, value?, &slopes?)?;
            work += operations;
            Ok(Reach::new(stretch, model))
        });
        (each.collect(), work)
    }
}

/// Derivatives, gathered by rows; an error for a row with one that has no value.
fn by_rows(
    entries: &[(usize, usize)],
    slopes: Vec<Result<TaylorModel, NoValue>>,
    rows: usize,
) -> Vec<Result<Slopes, NoValue>> {
    let mut all: Vec<Result<Slopes, NoValue>> = vec![Ok(Vec::new()); rows];
    for (&(row, i), slope) in entries.iter().zip(slopes) {
        match (slope, &mut all[row]) {
            (Ok(slope), Ok(known)) => known.push((i, slope)),
            (Err(reason), known) => *known = Err(reason),
            (Ok(_), Err(_)) => {}
        }
    }
    all
}

/// g(p) + Λ(F(x₀) − F(p)) + (∇g − Λ∇F)(X)·[−E, E], and the number of operations.
fn sharpened(known: &Known, value: TaylorModel, slopes: &Slopes) -> Result<(TaylorModel, usize), NoValue> {
    let mut sum = value;
    let mut rest: Vec<Option<TaylorModel>> = vec![None; known.spread.len()];
    slopes.iter().for_each(|&(i, slope)| rest[i] = Some(slope));
    let moved = |slopes: &Slopes| slopes.iter().map(|(i, s)| s.bound() * known.spread[*i]).fold(0.0, f64::max);
    let least = IDLE * moved(slopes);
    let mut work = 0;
    for ((left, gradient), factor) in known.integrals.iter().zip(factors(slopes, known)) {
        if factor.bound() * moved(gradient) <= least {
            continue;
        }
        let (mut product, before) = (TaylorModel::ZERO, sum);
        product.mul(&(), &factor, left)?;
        sum.add(&(), &before, &product)?;
        for (i, slope) in gradient {
            let (mut product, mut after) = (TaylorModel::ZERO, TaylorModel::ZERO);
            product.mul(&(), &factor, slope)?;
            after.sub(&(), &rest[*i].unwrap_or(TaylorModel::ZERO), &product)?;
            rest[*i] = Some(after);
        }
        work += 2 * (gradient.len() + 1);
    }
    let terms = rest.iter().zip(&known.spread).filter_map(|(rest, &e)| Some((rest.as_ref()?.bound(), e)));
    let room = terms.fold(Interval::point(0.0), |sum, (bound, e)| sum + Interval::point(bound) * Interval::point(e));
    Ok((sum.widened(room.hi()), work))
}

/// The pseudo-inverse of the gradients of the integrals at a node, by states in units of their spread.
fn inverse(integrals: &[(TaylorModel, Slopes)], spread: &[f64], node: usize) -> Option<DMatrix<f64>> {
    let mut gradients = DMatrix::zeros(integrals.len(), spread.len());
    for (k, (_, slopes)) in integrals.iter().enumerate() {
        slopes.iter().for_each(|&(i, slope)| gradients[(k, i)] = slope.at_node(node) * spread[i]);
    }
    let largest = gradients.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    if !gradients.iter().all(|x| x.is_finite()) {
        return None;
    }
    if largest == 0.0 {
        return Some(DMatrix::zeros(spread.len(), integrals.len()));
    }
    gradients.pseudo_inverse(NEGLIGIBLE * largest).ok()
}

/// Λ for one quantity: its gradient, in the gradients of the integrals.
fn factors(slopes: &Slopes, known: &Known) -> Vec<TaylorModel> {
    let mut values = vec![[0.0; NODES]; known.integrals.len()];
    for (node, inverse) in known.inverses.iter().enumerate() {
        for &(i, slope) in slopes {
            let size = slope.at_node(node) * known.spread[i];
            for (k, value) in values.iter_mut().enumerate() {
                value[node] += size * inverse[(i, k)];
            }
        }
    }
    values.iter().map(|v| TaylorModel::through(v).unwrap_or(TaylorModel::ZERO)).collect()
}
