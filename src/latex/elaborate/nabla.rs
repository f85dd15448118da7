//! ∇: gradient, divergence, curl and Laplacian, in Cartesian coordinates and in orthogonal ones.
//!
//! **In:** a node and what acts on it. **Out:** its components along the unit vectors of the coordinates. **Guaranteed:** what ∇ acts on
//! depends on a place; coordinates whose names are polar need scale factors.

use std::ops::Range;

use super::super::scope::{Role, Signature};
use super::super::syntax::{Nabla, Node};
use super::super::tensor;
use super::partial::POLAR;
use super::{Elaborated, Elaborator, refuse};
use expr::{Expr, Graph, Leaf, Shape, Tensor};

impl Elaborator<'_> {
    /// ∇ before something, in Cartesian coordinates, or in orthogonal ones with scale factors hᵢ; components are along the unit
    /// vectors of the coordinates.
    ///
    /// With h = h₁h₂h₃: (∇f)ᵢ = ∂ᵢf/hᵢ, ∇·A = (1/h) Σ ∂ᵢ(hAᵢ/hᵢ), (∇×A)₁ = (∂₂(h₃A₃) − ∂₃(h₂A₂))/h₂h₃ and so on, and
    /// ∇²f = ∇·∇f (Morse and Feshbach, Methods of Theoretical Physics, §1.3).
    pub(super) fn nabla(&mut self, of: &Node, action: &Nabla, span: &Range<usize>) -> Elaborated<Tensor> {
        let leaves = self.scope.space(self.graph);
        if leaves.is_empty() {
            let hint = "declare `x`, `y`, `z` with the role `coordinate`";
            return refuse("latex::derivative", "there are no coordinates of space", span, hint);
        }
        let scales = self.scope.scale_factors(self.graph);
        for leaf in leaves.iter().filter(|_| scales.is_none()) {
            let name = self.graph.name(leaf.symbol);
            if self.graph.component_count(leaf.symbol) == 1 && POLAR.contains(&name) {
                let message = format!(r"`\nabla` is Cartesian, and `{name}` is no such coordinate by its name");
                let hint = "declare its scale factors, `scale = 'r'` for θ, or write the derivatives out";
                return refuse("latex::unsupported", message, span, hint);
            }
        }
        let places: Vec<usize> = leaves.iter().filter_map(|&leaf| self.graph.coordinate(leaf)).collect();
        let one = self.graph.integer(1);
        let scales = scales.unwrap_or_else(|| vec![one; places.len()]);
        let space: Vec<(usize, Expr)> = places.into_iter().zip(scales).collect();
        let curved = space.iter().any(|(_, h)| *h != one);
        let value = self.tensor(of)?;
        for leaf in self.graph.leaves_within(value.components.iter().copied()) {
            if self.scope.moves(&leaf) {
                let message = format!("`{}` is no field: it does not depend on a place", self.graph.leaf_latex(leaf));
                return refuse("latex::derivative", message, &of.span, "declare it as a field of its coordinates");
            }
        }
        self.depends_on_places(&value, &of.span)?;
        let n = space.len();
        let number = value.shape.real_extents().is_empty();
        let vector = |t: &Tensor| matches!(*t.shape.real_extents(), [m] if usize::from(m) == n);
        let vectors = format!("a vector of {n} components is needed here, as there are coordinates of space");
        let turning = "the unit vectors of these coordinates turn, and what that adds is not known here";
        match action {
            Nabla::Gradient => {
                if !number {
                    let hint = r"write `({\bf v}\cdot\nabla){\bf A}`, or components";
                    return refuse("latex::shape", "the gradient of something that is no number", &of.span, hint);
                }
                let parts = self.gradient(&value, &space, span)?;
                Ok(tensor::of_numbers(self.graph, Shape::vector(n as u16), &parts))
            }
            Nabla::Laplacian { .. } => {
                if curved && n == 3 && vector(&value) {
                    // By definition ∇(∇·A) − ∇×(∇×A).
                    let parts = (0..n).map(|i| component(&value, i)).collect();
                    let flow = self.divergence(parts, &space, span)?;
                    let forth = self.gradient(&flow, &space, span)?;
                    let once = self.curl(&value, &space, span)?;
                    let back = self.curl(&once, &space, span)?;
                    let forth = tensor::of_numbers(self.graph, Shape::vector(3), &forth);
                    let pairs = forth.components.iter().zip(&back.components);
                    let components = pairs.map(|(&a, &b)| self.graph.sub(a, b)).collect();
                    return Ok(Tensor { shape: forth.shape, components });
                }
                if curved && !number {
                    return refuse("latex::unsupported", turning, &of.span, "write the components out");
                }
                let slopes = self.gradient(&value, &space, span)?;
                self.divergence(slopes, &space, span)
            }
            Nabla::Divergence => {
                if !vector(&value) {
                    return refuse("latex::shape", vectors, &of.span, "");
                }
                let parts = (0..n).map(|i| component(&value, i)).collect();
                self.divergence(parts, &space, span)
            }
            Nabla::Curl => {
                if n != 3 || !vector(&value) {
                    let message = "the curl is that of a vector of three components, with three coordinates of space";
                    return refuse("latex::shape", message, &of.span, "");
                }
                self.curl(&value, &space, span)
            }
            Nabla::Wave => {
                if curved && !number {
                    return refuse("latex::unsupported", turning, &of.span, "write the components out");
                }
                let (speed, signature) = self.waves(span)?;
                let slopes = self.gradient(&value, &space, span)?;
                let here = self.divergence(slopes, &space, span)?;
                let first = self.by_time(value, span)?;
                let second = self.by_time(first, span)?;
                let square = self.graph.mul(speed, speed);
                let later = self.each(second, |g, e| g.div(e, square));
                let pairs = later.components.iter().zip(&here.components);
                let components = pairs
                    .map(|(&time, &space)| match signature {
                        Signature::Time => self.graph.sub(time, space),
                        Signature::Space => self.graph.sub(space, time),
                    })
                    .collect();
                Ok(Tensor { shape: here.shape, components })
            }
            Nabla::Along(_) | Nabla::Following { .. } => {
                let along = if let Nabla::Along(direction) = action {
                    self.tensor(direction)?
                } else {
                    self.velocity(n, span)?
                };
                if along.shape.is_complex() || !vector(&along) {
                    return refuse("latex::shape", vectors, span, "");
                }
                if curved && !number && !vector(&value) {
                    return refuse("latex::unsupported", turning, &of.span, "write the components out");
                }
                let slopes = self.gradient(&value, &space, span)?;
                let each = slopes.into_iter().zip(&along.components);
                let mut terms: Vec<Tensor> = each.map(|(slope, &by)| self.each(slope, |g, e| g.mul(by, e))).collect();
                if curved && !number {
                    terms.push(self.turned(&value, &along, &space, span)?);
                }
                if matches!(action, Nabla::Following { .. }) {
                    terms.insert(0, self.by_time(value.clone(), span)?);
                }
                Ok(self.sum_of(terms).unwrap_or(value))
            }
        }
    }

    /// Refuses ∇ before what is the same everywhere by its declaration: the answer would be 0.
    fn depends_on_places(&self, t: &Tensor, span: &Range<usize>) -> Elaborated<()> {
        let leaves = self.graph.leaves_within(t.components.iter().copied());
        let still =
            |l: &Leaf| self.scope.role(l.symbol) == Some(Role::Parameter) && self.graph.coordinate(*l).is_none();
        if leaves.iter().any(|l| !still(l)) {
            return Ok(());
        }
        let Some(leaf) = leaves.first() else { return Ok(()) };
        let message = format!("`{}` is the same everywhere, so this is 0", self.graph.leaf_latex(*leaf));
        refuse("latex::derivative", message, span, "declare it as a field of its coordinates")
    }

    /// ∇×A of three components.
    fn curl(&mut self, of: &Tensor, space: &[(usize, Expr)], span: &Range<usize>) -> Elaborated<Tensor> {
        let mut parts = Vec::new();
        for i in 0..3 {
            let [j, k] = [(i + 1) % 3, (i + 2) % 3];
            let [(at_j, h_j), (at_k, h_k)] = [space[j], space[k]];
            let [along_j, along_k] = [(j, h_j), (k, h_k)].map(|(i, h)| self.each(component(of, i), |g, e| g.mul(h, e)));
            let forth = self.by_coordinate(along_k, at_j, span)?;
            let back = self.by_coordinate(along_j, at_k, span)?;
            let pairs = forth.components.iter().zip(&back.components);
            let components = pairs.map(|(&a, &b)| self.graph.sub(a, b)).collect();
            let area = self.graph.mul(h_j, h_k);
            parts.push(self.each(Tensor { shape: forth.shape, components }, |g, e| g.div(e, area)));
        }
        Ok(tensor::of_numbers(self.graph, Shape::vector(3), &parts))
    }

    /// What (v·∇)A has beyond the derivatives of its components, since the unit vectors turn:
    /// Σₖ Aₖ (vᵢ ∂ₖhᵢ − vₖ ∂ᵢhₖ)/(hᵢ hₖ) along the i-th.
    fn turned(
        &mut self,
        of: &Tensor,
        along: &Tensor,
        space: &[(usize, Expr)],
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        let mut parts = Vec::new();
        for (i, &(at_i, h_i)) in space.iter().enumerate() {
            let mut terms = Vec::new();
            for (k, &(at_k, h_k)) in space.iter().enumerate() {
                let forth = self.by_coordinate(Tensor::scalar(h_i), at_k, span)?.components[0];
                let back = self.by_coordinate(Tensor::scalar(h_k), at_i, span)?.components[0];
                let forth = self.graph.mul(along.components[i], forth);
                let back = self.graph.mul(along.components[k], back);
                let (top, area) = (self.graph.sub(forth, back), self.graph.mul(h_i, h_k));
                if !self.graph.is_zero(top) {
                    let by = self.graph.div(top, area);
                    terms.push(self.each(component(of, k), |g, e| g.mul(by, e)));
                }
            }
            let none = self.each(component(of, i), |g, _| g.integer(0));
            parts.push(self.sum_of(terms).unwrap_or(none));
        }
        Ok(tensor::of_numbers(self.graph, Shape::vector(space.len() as u16), &parts))
    }

    /// The derivative by the time, all places being held fixed.
    fn by_time(&mut self, t: Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
        let Some(time) = self.scope.time() else {
            let hint = "give one the role `time`";
            return refuse("latex::derivative", "no symbol is declared as the time", span, hint);
        };
        self.names_no_argument(&t, span)?;
        match self.graph.coordinate(time) {
            Some(at) => self.by_coordinate(t, at, span),
            None => self.derived(t, span, |this, e| this.graph.partial_derivative(e, time)),
        }
    }

    /// The speed of waves and the sign of the time in `\Box`.
    fn waves(&mut self, span: &Range<usize>) -> Elaborated<(Expr, Signature)> {
        let Some(signature) = self.scope.signature() else {
            let hint = r#"say `signature = "+---"` or `signature = "-+++"` under [conventions]"#;
            return refuse("latex::ambiguous", "the sign of `\\Box` is not clear", span, hint);
        };
        let hint = "declare `c`, the speed of the waves; where it is 1, as an abbreviation with this formula";
        let speed = self.scope.symbol("c").and_then(|c| match self.scope.definition(c) {
            Some(value) => value.as_scalar(),
            None => (self.graph.component_count(c) == 1).then(|| self.graph.leaf(Leaf::now(c, 0))),
        });
        let constant = |l: &Leaf| self.scope.role(l.symbol) == Some(Role::Parameter);
        match speed {
            Some(speed) if self.graph.leaves_within([speed]).iter().all(constant) => Ok((speed, signature)),
            Some(_) | None => refuse("latex::derivative", "`\\Box` needs a constant `c`", span, hint),
        }
    }

    /// The velocity with which `\frac{D}{Dt}` moves, in n coordinates of space; of one, it may be a number.
    fn velocity(&mut self, n: usize, span: &Range<usize>) -> Elaborated<Tensor> {
        let Some(symbol) = self.scope.velocity() else {
            let hint = "declare the field of velocities with `velocity = true`";
            return refuse("latex::derivative", "which flow is followed is not said", span, hint);
        };
        let components: Vec<Expr> = match self.scope.definition(symbol) {
            Some(formula) => formula.components.clone(),
            None => {
                let count = self.graph.component_count(symbol) as u16;
                (0..count).map(|c| self.graph.leaf(Leaf::now(symbol, c))).collect()
            }
        };
        if components.len() != n {
            let message = format!("a velocity of {n} components is needed here, as there are coordinates of space");
            return refuse("latex::shape", message, span, "");
        }
        Ok(Tensor { shape: Shape::vector(n as u16), components })
    }

    /// Every component by a formula.
    fn each(&mut self, t: Tensor, mut by: impl FnMut(&mut Graph, Expr) -> Expr) -> Tensor {
        let components = t.components.into_iter().map(|e| by(self.graph, e)).collect();
        Tensor { shape: t.shape, components }
    }

    /// ∂ᵢf/hᵢ for each coordinate.
    fn gradient(&mut self, t: &Tensor, space: &[(usize, Expr)], span: &Range<usize>) -> Elaborated<Vec<Tensor>> {
        let mut parts = Vec::with_capacity(space.len());
        for &(at, h) in space {
            let slope = self.by_coordinate(t.clone(), at, span)?;
            parts.push(self.each(slope, |g, e| g.div(e, h)));
        }
        Ok(parts)
    }

    /// (1/h) Σ ∂ᵢ(hAᵢ/hᵢ), h being the product of all scale factors.
    fn divergence(&mut self, parts: Vec<Tensor>, space: &[(usize, Expr)], span: &Range<usize>) -> Elaborated<Tensor> {
        let volume = space.iter().fold(self.graph.integer(1), |volume, &(_, h)| self.graph.mul(volume, h));
        let mut terms = Vec::with_capacity(parts.len());
        for (i, (part, &(at, _))) in parts.into_iter().zip(space).enumerate() {
            let others = space.iter().enumerate().filter(|(j, _)| *j != i);
            let area = others.fold(self.graph.integer(1), |area, (_, &(_, h))| self.graph.mul(area, h));
            let flux = self.each(part, |g, e| g.mul(area, e));
            terms.push(self.by_coordinate(flux, at, span)?);
        }
        let Some(sum) = self.sum_of(terms) else {
            return refuse("latex::derivative", "there are no coordinates of space", span, "");
        };
        Ok(self.each(sum, |g, e| g.div(e, volume)))
    }

    fn sum_of(&mut self, terms: Vec<Tensor>) -> Option<Tensor> {
        terms.into_iter().reduce(|sum, term| {
            let pairs = sum.components.iter().zip(&term.components);
            let components = pairs.map(|(&a, &b)| self.graph.add(a, b)).collect();
            Tensor { shape: sum.shape, components }
        })
    }
}

/// The i-th component of a vector, as a number.
fn component(t: &Tensor, i: usize) -> Tensor {
    let parts = t.components.len() / usize::from(t.shape.real_extents().first().copied().unwrap_or(1)).max(1);
    let components = t.components[i * parts..(i + 1) * parts].to_vec();
    Tensor { shape: if parts == 1 { Shape::scalar() } else { Shape::scalar().complexified() }, components }
}
