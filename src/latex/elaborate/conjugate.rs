//! What is particular to complex numbers: conjugates, parts, functions, powers, and the imaginary unit.

use std::ops::{ControlFlow, Range};

use super::super::complex::{HIGHEST_POWER, Pair};
use super::super::name;
use super::super::syntax::{Node, NodeKind, SymbolNode};
use super::super::tensor;
use super::{Elaborated, Elaborator, Value, refuse};
use expr::{Expr, Op, Part, Rational, Tensor};

impl Elaborator<'_> {
    /// The complex conjugate; of something real it is refused, since there a bar or a star is a name, or a mean.
    pub(super) fn conjugate(&mut self, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
        if !t.shape.is_complex() {
            let message = "this is real, and its own conjugate";
            let hint = "leave the bar or star out, declare a symbol with it, or declare `complex = true`";
            return refuse("latex::ambiguous", message, span, hint);
        }
        Ok(tensor::conjugate(self.graph, t))
    }

    /// `A^*`, `A^\dagger`.
    pub(super) fn conjugated(&mut self, t: &Tensor, transposed: bool, span: &Range<usize>) -> Elaborated<Tensor> {
        if !transposed {
            return self.conjugate(t, span);
        }
        let matrix = !t.shape.real_extents().is_empty();
        let t = if t.shape.is_complex() || !matrix { self.conjugate(t, span)? } else { t.clone() };
        if matrix { tensor::transpose(self.graph, &t, span) } else { Ok(t) }
    }

    /// Whether a superscript says that something is conjugated, and whether it is transposed as well.
    pub(super) fn conjugation(node: &Node) -> Option<bool> {
        match node.kind {
            NodeKind::Conjugation { transposed } => Some(transposed),
            _ => None,
        }
    }

    /// Refuses the product `\cdot` of two complex vectors, unless one of them is written with a conjugate: books differ.
    pub(super) fn conjugation_is_clear(
        &self,
        a: &Tensor,
        b: &Tensor,
        parts: &[Node],
        span: &Range<usize>,
    ) -> Elaborated<()> {
        let both = a.shape.is_complex() && b.shape.is_complex();
        if !both || parts.iter().any(is_conjugated) {
            return Ok(());
        }
        let hint = r"write `{\bf a}^\dagger{\bf b}`, `{\bf a}^*\cdot{\bf b}` or `{\bf a}^T{\bf b}`";
        refuse("latex::ambiguous", "is one of these complex vectors conjugated?", span, hint)
    }

    /// Components by a number, where one of them is complex.
    pub(super) fn complex_quotient(&mut self, top: &Value, under: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
        match (top, Pair::of(self.graph, under)) {
            (Value::Tensor(t), Some(below)) => Ok(tensor::quotient(self.graph, t, below)),
            _ => refuse("latex::shape", "the size of the identity matrix is not clear here", span, ""),
        }
    }

    fn pair(&mut self, t: &Tensor, span: &Range<usize>) -> Elaborated<Pair> {
        match Pair::of(self.graph, t) {
            Some(pair) => Ok(pair),
            None => refuse("latex::shape", format!("a scalar is needed here, this is a {}", t.shape), span, ""),
        }
    }

    /// |z|, of products, quotients, powers and exponentials by their laws: they hold wherever both sides have a value, and the
    /// sizes of the parts have values where the parts have.
    pub(super) fn size(&mut self, node: &Node) -> Elaborated<Expr> {
        match &node.kind {
            NodeKind::Group(inner, _) if !self.sums_over(node) => return self.size(inner),
            NodeKind::Product(parts) | NodeKind::Dot(parts) if !self.sums_over(node) => {
                let mut product: Option<Expr> = None;
                for part in parts {
                    // Vectors and matrices have no sizes to be multiplied.
                    if !self.tensor(part)?.shape.real_extents().is_empty() {
                        product = None;
                        break;
                    }
                    let size = self.size(part)?;
                    product = Some(match product {
                        Some(p) => self.graph.mul(p, size),
                        None => size,
                    });
                }
                if let Some(product) = product {
                    return Ok(product);
                }
            }
            NodeKind::Quotient { top, bottom, .. } if !self.sums_over(node) => {
                let (above, below) = (self.size(top)?, self.size(bottom)?);
                return Ok(self.graph.div(above, below));
            }
            NodeKind::Symbol(s) if !self.sums_over(node) => {
                if let Some(n) = s.sup.as_deref().and_then(whole) {
                    let bare = SymbolNode { sup: None, ..s.clone() };
                    let size = self.size(&Node::new(NodeKind::Symbol(bare), node.span.clone()))?;
                    return Ok(self.graph.powi(size, n));
                }
            }
            NodeKind::Scripted { base, sub: None, sup: Some(sup), .. } if !self.sums_over(node) => {
                if let (Some(n), []) = (whole(sup), self.tensor(base)?.shape.real_extents()) {
                    let size = self.size(base)?;
                    return Ok(self.graph.powi(size, n));
                }
            }
            _ => {}
        }
        let t = self.number(node)?;
        let z = self.pair(&t, &node.span)?;
        Ok(z.size(self.graph))
    }

    /// Whether this is |z|², |z|⁴ … of something complex.
    pub(super) fn is_squared_size(&mut self, base: &Node, sup: &Node) -> Elaborated<bool> {
        match (&base.kind, whole(sup)) {
            (NodeKind::Absolute(inner), Some(n)) if n > 0 && n % 2 == 0 && !self.sums_over(base) => {
                let shape = self.tensor(inner)?.shape;
                Ok(shape.is_complex() && shape.real_extents().len() < 2)
            }
            _ => Ok(false),
        }
    }

    /// An even power of |z|, without a root: it has a rate at 0.
    pub(super) fn squared_size(&mut self, base: &Node, sup: &Node) -> Elaborated<Expr> {
        let NodeKind::Absolute(inner) = &base.kind else { return self.scalar(base) };
        let t = self.tensor(inner)?;
        let square = tensor::square_of_length(self.graph, &t);
        Ok(self.graph.powi(square, whole(sup).unwrap_or(2) / 2))
    }

    /// Whether a node is a sum over an index.
    fn sums_over(&self, node: &Node) -> bool {
        self.sums.contains_key(&std::ptr::from_ref(node))
    }

    /// A complex number to a rational power.
    pub(super) fn rational_power(&mut self, t: &Tensor, q: &Rational, span: &Range<usize>) -> Elaborated<Tensor> {
        match self.pair(t, span)?.rational_power(self.graph, q) {
            Some(power) => Ok(power.scalar()),
            None => {
                let message = format!("a power of a complex number above {HIGHEST_POWER}");
                refuse("latex::too-large", message, span, "")
            }
        }
    }

    /// A power of which base or exponent is complex. A real base has its real logarithm, and no value where that has none.
    pub(super) fn complex_power(
        &mut self,
        base: &Tensor,
        exponent: &Tensor,
        span: &Range<usize>,
    ) -> Elaborated<Tensor> {
        let power = self.pair(exponent, span)?;
        if let Some(real) = base.as_scalar() {
            let ln = self.graph.unary(Op::Ln, real);
            let ln = Pair::real(self.graph, ln);
            return Ok(power.times(self.graph, ln).exp(self.graph).scalar());
        }
        if let Some(q) = exponent.as_scalar().and_then(|e| self.graph.as_constant(e).cloned()) {
            return self.rational_power(base, &q, span);
        }
        Ok(self.pair(base, span)?.power(self.graph, power).scalar())
    }

    /// A function of one complex number, by its principal value.
    pub(super) fn complex_function(&mut self, function: &str, t: &Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
        let z = self.pair(t, span)?;
        if function == "log" {
            let ln = z.function(self.graph, "ln").unwrap_or(z);
            let base = self.logarithm_of_base(span)?;
            let base = Pair::real(self.graph, base);
            return Ok(ln.over(self.graph, base).scalar());
        }
        match z.function(self.graph, function) {
            Some(value) => Ok(value.scalar()),
            None => {
                let message = format!("`{function}` of a complex number is not known");
                refuse("latex::shape", message, span, "")
            }
        }
    }

    /// A function of one argument, if it is one of complex numbers, or its argument is complex; else the argument.
    pub(super) fn of_complex(
        &mut self,
        name: &str,
        node: &Node,
        span: &Range<usize>,
    ) -> Elaborated<ControlFlow<Tensor, Expr>> {
        let part = match name {
            "Re" => Some(Part::Real),
            "Im" => Some(Part::Imaginary),
            _ => None,
        };
        if let Some(part) = part {
            let t = self.tensor(node)?;
            let t = self.joined(t);
            return Ok(ControlFlow::Break(tensor::part(self.graph, &t, part)));
        }
        let t = self.number(node)?;
        if name == "arg" {
            let z = self.pair(&t, span)?;
            return Ok(ControlFlow::Break(Tensor::scalar(z.argument(self.graph))));
        }
        match t.as_scalar() {
            Some(real) => Ok(ControlFlow::Continue(real)),
            None => self.complex_function(name, &t, span).map(ControlFlow::Break),
        }
    }

    /// Whether a symbol, as it is written, is the imaginary unit.
    pub(super) fn is_imaginary_unit(&self, s: &SymbolNode, span: &Range<usize>) -> Elaborated<bool> {
        let bare = s.sub.is_none() && s.dots == 0 && s.arguments.is_none();
        if !bare || !name::is_imaginary_unit(&s.name) || self.scope.declares(&s.name) {
            return Ok(false);
        }
        if s.name != "i" {
            return Ok(true);
        }
        if !self.scope.speaks_of_complex_numbers() {
            let hint = r#"declare it, or write `\mathrm{i}` for the imaginary unit, or `i = "imaginary unit"` under [conventions]"#;
            return refuse("latex::unknown-symbol", "`i` is not declared, and nothing here is complex", span, hint);
        }
        if self.extents.contains_key("i") {
            let hint = r"write `\mathrm{i}` for the imaginary unit, or use another letter for the index";
            return refuse("latex::ambiguous", "`i` is an index here, and the imaginary unit", span, hint);
        }
        Ok(true)
    }
}

/// A whole number that is written out.
fn whole(node: &Node) -> Option<i32> {
    match &node.kind {
        NodeKind::Number(r) => i32::try_from(r.clone()).ok(),
        _ => None,
    }
}

/// Whether something is written as a conjugate.
fn is_conjugated(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Conjugate(_) => true,
        NodeKind::Symbol(s) => {
            name::split(&s.name).0 == Some("bar")
                || s.sup.as_deref().is_some_and(|sup| matches!(sup.kind, NodeKind::Conjugation { .. }))
        }
        NodeKind::Scripted { sup, .. } => {
            sup.as_deref().is_some_and(|sup| matches!(sup.kind, NodeKind::Conjugation { .. }))
        }
        NodeKind::Group(inner, _) => is_conjugated(inner),
        NodeKind::Product(parts) => parts.iter().any(is_conjugated),
        _ => false,
    }
}
