//! Poisson brackets.
//!
//! **In:** two formulas, and the pairs of canonical variables that are declared. **Out:** {f, g} = Σ (∂f/∂q ∂g/∂p − ∂f/∂p ∂g/∂q),
//! the sum going over all pairs, so that {q, p} = 1 (Goldstein, Classical Mechanics, §9-4; Landau and Lifshitz, Mechanics, §42,
//! have the other sign). **Guaranteed:** f and g name nothing whose dependence on the canonical variables is not known: what
//! observables stand for is written out, and rates, other states, values at a time and arguments of functions are refused,
//! since their derivatives would be 0 here and need not be. A bracket has a value only where both f and g have one.

use std::ops::Range;

use super::super::scope::Role;
use super::super::syntax::{Node, NodeKind};
use super::super::tensor;
use super::{Elaborated, Elaborator, refuse};
use expr::{Leaf, Shape, Tensor};

impl Elaborator<'_> {
    /// {f, g}; one of the two may have components.
    pub(super) fn bracket(&mut self, left: &Node, right: &Node, span: &Range<usize>) -> Elaborated<Tensor> {
        let pairs = self.scope.canonical_pairs(self.graph);
        if pairs.is_empty() {
            let hint = "declare which momentum belongs to which coordinate, `'p' = { …, momentum-of = 'q' }`";
            let message = "a Poisson bracket needs canonical variables, and none are declared";
            return refuse("latex::derivative", message, span, hint);
        }
        if left.is_numeric() && right.is_numeric() {
            let hint = "write each value in an equation of its own, or the bracket's value";
            return refuse("latex::ambiguous", "a set of numbers, or a bracket?", span, hint);
        }
        let f = self.of_phase_space(left, &pairs)?;
        let g = self.of_phase_space(right, &pairs)?;
        let single = |t: &Tensor| t.shape.real_extents().is_empty();
        if !single(&f) && !single(&g) {
            let hint = r"write components, `\{L_i,L_j\}`";
            return refuse("latex::shape", "a bracket of two things that have components", span, hint);
        }
        let shape = if single(&f) { g.shape.real() } else { f.shape.real() };
        let (fs, gs) = (numbers(&f), numbers(&g));
        let mut values = Vec::with_capacity(shape.len());
        for i in 0..fs.len().max(gs.len()) {
            let one = |all: &[Tensor]| all[if all.len() == 1 { 0 } else { i }].clone();
            values.push(self.bracket_of_numbers(one(&fs), one(&gs), &pairs, span)?);
        }
        Ok(tensor::of_numbers(self.graph, shape, &values))
    }

    fn bracket_of_numbers(
        &mut self,
        f: Tensor,
        g: Tensor,
        pairs: &[(Leaf, Leaf)],
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        let mut sum = Tensor::scalar(self.graph.integer(0));
        for &(q, p) in pairs {
            let forth = self.product_of_slopes((&f, q), (&g, p), span)?;
            let back = self.product_of_slopes((&f, p), (&g, q), span)?;
            let term = self.both(forth, back, |g, a, b| g.sub(a, b));
            sum = self.both(sum, term, |g, a, b| g.add(a, b));
        }
        // Terms that are left out as 0 may have been all that needed f or g to have a value.
        // A product has a value where its factors have, whatever their units.
        let all = f.components.iter().chain(&g.components).copied();
        let varying: Vec<_> = all.filter(|&e| self.graph.as_constant(e).is_none()).collect();
        let Some(whole) = varying.into_iter().reduce(|a, b| self.graph.mul(a, b)) else { return Ok(sum) };
        for component in &mut sum.components {
            *component = self.graph.rate_of(whole, *component, |_| false);
        }
        Ok(sum)
    }

    fn product_of_slopes(
        &mut self,
        (f, a): (&Tensor, Leaf),
        (g, b): (&Tensor, Leaf),
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        let f = self.slope(f.clone(), a, span)?;
        let g = self.slope(g.clone(), b, span)?;
        // What does not change adds nothing; what f and g need is asked for the bracket as a whole.
        let [f, g] = [f, g].map(|t| tensor::sparse(self.graph, t));
        tensor::product(self.graph, vec![(f, span.clone()), (g, span.clone())], span)
    }

    /// The derivative by a canonical variable, the others being held fixed.
    fn slope(&mut self, t: Tensor, by: Leaf, span: &Range<usize>) -> Elaborated<Tensor> {
        match self.graph.coordinate(by) {
            Some(at) => self.by_coordinate(t, at, span),
            None => self.derived(t, span, |this, e| this.graph.partial_derivative(e, by)),
        }
    }

    /// Two numbers put together by parts: real and imaginary ones, where one of the two is complex.
    fn both(
        &mut self,
        a: Tensor,
        b: Tensor,
        by: impl Fn(&mut expr::Graph, expr::Expr, expr::Expr) -> expr::Expr,
    ) -> Tensor {
        let complex = a.shape.is_complex() || b.shape.is_complex();
        let [a, b] = [a, b].map(|t| if complex { tensor::complexified(self.graph, &t) } else { t });
        let pairs = a.components.iter().zip(&b.components);
        let components = pairs.map(|(&a, &b)| by(self.graph, a, b)).collect();
        Tensor { shape: a.shape, components }
    }

    /// What stands in a bracket, if it shows how it depends on the canonical variables.
    fn of_phase_space(&mut self, node: &Node, pairs: &[(Leaf, Leaf)]) -> Elaborated<Tensor> {
        let span = &node.span;
        let value = self.tensor(node)?;
        let t = self.spelled_out(value, span)?;
        let leaves = self.graph.leaves_within(t.components.iter().copied());
        let canonical = |l: &Leaf| pairs.iter().any(|(q, p)| q == l || p == l);
        let among_places = pairs.iter().all(|(q, _)| self.graph.coordinate(*q).is_some());
        for leaf in leaves.iter().filter(|l| !canonical(l)) {
            let name = self.graph.leaf_latex(*leaf);
            let (message, hint) = match self.scope.role(leaf.symbol) {
                _ if leaf.rate > 0 || leaf.instant.is_some() => {
                    (format!("how `{name}` depends on the canonical variables is not said"), "write it by momenta")
                }
                Some(Role::State | Role::Observable) => (
                    format!("`{name}` is no canonical variable, and may depend on them"),
                    "declare its momentum, with `momentum-of`, or write it as a formula",
                ),
                Some(Role::Argument) => (
                    format!("`{name}` stands for anything, and may depend on the canonical variables"),
                    "write the bracket where the function is applied",
                ),
                Some(Role::Field) if !among_places => (
                    format!("how `{name}` depends on the canonical variables is not said"),
                    "let these be coordinates, on which the field depends",
                ),
                Some(Role::Time | Role::Parameter | Role::Coordinate | Role::Field | Role::Abbreviation) | None => {
                    continue;
                }
            };
            return refuse("latex::derivative", message, span, hint);
        }
        if let NodeKind::Symbol(s) = &node.kind
            && self.resolve(s, span)?.definition.is_none()
            && !leaves.iter().any(|l| canonical(l) || self.graph.is_field(l.symbol))
        {
            let message = "this does not show how it depends on the canonical variables";
            let hint = "declare it as an abbreviation with a formula, or as a field of the canonical variables";
            return refuse("latex::derivative", message, span, hint);
        }
        Ok(t)
    }
}

/// The numbers of which something is made, real or complex ones.
fn numbers(t: &Tensor) -> Vec<Tensor> {
    let complex = t.shape.is_complex();
    let shape = if complex { Shape::scalar().complexified() } else { Shape::scalar() };
    let parts = t.components.chunks(if complex { 2 } else { 1 });
    parts.map(|part| Tensor { shape: shape.clone(), components: part.to_vec() }).collect()
}
