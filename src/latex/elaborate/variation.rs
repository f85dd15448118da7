//! Variational derivatives: the expression of Euler and Lagrange.
//!
//! **In:** a density L, that is what stands under the integral of an action or of another functional, and what is varied.
//! **Out:** of a motion q(t), δL/δq = ∂L/∂q − d/dt ∂L/∂q̇ + d²/dt² ∂L/∂q̈ − …; of a field u, Σ (−1)^|α| D^α ∂L/∂(D^α u), the sum
//! going over the derivatives of u that L names (Gelfand and Fomin, Calculus of Variations, §§11 and 35). Of a complex field ψ,
//! ½(δ/δRe ψ − i δ/δIm ψ), and the conjugate of that operator for ψ*, as if both were independent.
//!
//! **Guaranteed:** the integral goes over the time, or over all coordinates of the field: a density that depends on another
//! coordinate is refused, and so is one that hides what it depends on. Boundary terms are left out by definition.

use std::ops::Range;

use super::super::scope::Role;
use super::super::syntax::{Node, NodeKind};
use super::super::tensor;
use super::{Elaborated, Elaborator, refuse};
use expr::{Expr, Leaf, Node as Part, Op, Shape, Tensor};

impl Elaborator<'_> {
    /// `\frac{\delta L}{\delta q}`: a number for each component of what is varied.
    pub(super) fn variation(&mut self, of: &Node, by: &Node, span: &Range<usize>) -> Elaborated<Tensor> {
        let value = self.tensor(of)?;
        let Some(density) = self.spelled_out(value, &of.span)?.as_scalar() else {
            return refuse("latex::shape", "what is varied is a real number, a density", &of.span, "");
        };
        if let NodeKind::Symbol(s) = &by.kind
            && self.resolve(s, &by.span)?.definition.is_some()
        {
            let hint = "vary what it is made of";
            return refuse("latex::derivative", "this stands for a formula", &by.span, hint);
        }
        let varied = self.tensor(by)?;
        let mut leaves = Vec::with_capacity(varied.components.len());
        for &e in &varied.components {
            leaves.push(self.varied(e, &by.span)?);
        }
        self.is_density(of, density, &leaves, span)?;
        let mut slopes = Vec::with_capacity(leaves.len());
        for &(leaf, _) in &leaves {
            slopes.push(self.euler_lagrange(density, leaf, span)?);
        }
        if !varied.shape.is_complex() {
            return Ok(Tensor { shape: varied.shape, components: slopes });
        }
        let two = self.graph.integer(2);
        let mut numbers = Vec::new();
        for (pair, names) in slopes.chunks(2).zip(leaves.chunks(2)) {
            let [real, imaginary] = *pair else { continue };
            // By ψ the imaginary part has the other sign; by ψ*, whose imaginary part is that of ψ with the other sign, not.
            let conjugated = names.last().is_some_and(|(_, turned)| *turned);
            let imaginary = if conjugated { imaginary } else { self.graph.neg(imaginary) };
            let components = vec![self.graph.div(real, two), self.graph.div(imaginary, two)];
            numbers.push(Tensor { shape: Shape::scalar().complexified(), components });
        }
        Ok(tensor::of_numbers(self.graph, varied.shape.real(), &numbers))
    }

    /// The state or field that is varied, and whether it stands there with the other sign, as the imaginary part of ψ* does.
    fn varied(&mut self, e: Expr, span: &Range<usize>) -> Elaborated<(Leaf, bool)> {
        let (e, turned) = match *self.graph.node(e) {
            Part::Unary(Op::Neg, inner) => (inner, true),
            Part::Unary(..) | Part::Binary(..) | Part::Leaf(_) | Part::Constant(_) | Part::Pi => (e, false),
        };
        let leaf = self.leaf(e).filter(|l| l.rate == 0 && l.instant.is_none() && l.partials.is_none());
        match leaf.map(|l| (l, self.scope.role(l.symbol))) {
            Some((leaf, Some(Role::State | Role::Field))) if turned => Ok((leaf, true)),
            Some((leaf, Some(Role::State | Role::Field))) => Ok((leaf, false)),
            Some(_) | None => {
                let hint =
                    "a state, or a field that is not given by a formula; `\\partial` for a derivative by anything else";
                refuse("latex::derivative", "this is not varied", span, hint)
            }
        }
    }

    /// Refuses a density of which it is not clear over what it is integrated, or how it depends on what is varied.
    fn is_density(&mut self, of: &Node, density: Expr, varied: &[(Leaf, bool)], span: &Range<usize>) -> Elaborated<()> {
        let Some(&(first, _)) = varied.first() else {
            return refuse("latex::derivative", "nothing is varied", span, "");
        };
        let of_fields = self.graph.is_field(first.symbol);
        let leaves = self.graph.leaves_within([density]);
        if let NodeKind::Symbol(s) = &of.kind
            && self.resolve(s, &of.span)?.definition.is_none()
            && !leaves.iter().any(|l| l.symbol == first.symbol)
        {
            let message = format!("this does not show how it depends on `{}`", self.graph.name(first.symbol));
            let hint = "declare the density as an abbreviation with a formula";
            return refuse("latex::derivative", message, &of.span, hint);
        }
        if of_fields && self.scope.scale_factors(self.graph).is_some() {
            let message = "is this a density per volume, or per unit of each coordinate?";
            let hint = "with scale factors write the equation out";
            return refuse("latex::ambiguous", message, span, hint);
        }
        let within = |at: usize| self.graph.depends(first.symbol, at);
        let outside =
            |symbol| (0..self.graph.coordinates().count()).any(|at| self.graph.depends(symbol, at) && !within(at));
        let wrong = leaves.iter().find(|l| {
            let role = self.scope.role(l.symbol);
            let place = self.graph.place(l.symbol);
            // Elsewhere, what is varied is another thing; any other function is one of what stands in its place.
            if let Some(place) = place {
                return place.field == first.symbol || of_fields && outside(l.symbol);
            }
            l.instant.is_some()
                || role == Some(Role::Argument)
                || match self.graph.coordinate(**l) {
                    Some(at) if of_fields => !within(at),
                    Some(_) => role != Some(Role::Time),
                    None if self.graph.is_field(l.symbol) => !of_fields || outside(l.symbol),
                    None => of_fields && matches!(role, Some(Role::State | Role::Observable | Role::Time)),
                }
        });
        let Some(leaf) = wrong else { return Ok(()) };
        let name = self.graph.leaf_latex(*leaf);
        let message = format!("`{name}` is not integrated over together with `{}`", self.graph.name(first.symbol));
        let hint = "a density depends on what is varied, and on the time or the coordinates that this depends on";
        refuse("latex::derivative", message, span, hint)
    }

    fn euler_lagrange(&mut self, density: Expr, varied: Leaf, span: &Range<usize>) -> Elaborated<Expr> {
        let own = |l: &Leaf| l.symbol == varied.symbol && l.component == varied.component;
        let named: Vec<Leaf> = self.graph.leaves_within([density]).into_iter().filter(own).collect();
        let mut sum = self.graph.integer(0);
        for leaf in named {
            let whole = Tensor::scalar(density);
            let mut term = self.derived(whole, span, |this, e| this.graph.partial_derivative(e, leaf))?;
            for _ in 0..leaf.rate {
                term = self.time_derivative(term, span)?;
            }
            for at in leaf.partials.steps() {
                term = self.by_coordinate(term, at, span)?;
            }
            let order = u32::from(leaf.rate) + leaf.partials.order();
            let term = term.components.into_iter().next().unwrap_or(sum);
            sum = if order % 2 == 0 { self.graph.add(sum, term) } else { self.graph.sub(sum, term) };
        }
        Ok(self.graph.rate_of(density, sum, |_| false))
    }
}
