//! Subscripts and superscripts: components, powers, inverses, transposes.

use std::ops::Range;

use super::super::syntax::{Node, NodeKind, Sign, SubItem};
use super::super::tensor;
use super::{Elaborated, Elaborator, Value, refuse};
use expr::{Op, Rational, Shape, Tensor};

/// Highest power of a matrix that is written out.
const HIGHEST: i32 = 16;

impl Elaborator<'_> {
    pub(super) fn scripted(
        &mut self,
        base: Value,
        sub: Option<&[SubItem]>,
        sup: Option<&Node>,
        sup_first: bool,
        span: &Range<usize>,
    ) -> Elaborated<Value> {
        let base = match base {
            Value::Tensor(t) => t,
            Value::Identity(_) if sub.is_some() => {
                let hint = r"the components of the identity matrix are written `\delta_{ij}`";
                return refuse("latex::shape", "indices on the identity matrix", span, hint);
            }
            Value::Identity(s) => {
                let same = |sup: &&Node| !self.is_transpose(sup) && Self::conjugation(sup).is_none();
                let Some(sup) = sup.filter(same) else { return Ok(Value::Identity(s)) };
                let exponent = self.scalar(sup)?;
                return match self.integer(exponent) {
                    Some(n) => Ok(Value::Identity(self.graph.powi(s, n))),
                    None => refuse("latex::shape", "this power of a matrix is not defined", span, ""),
                };
            }
        };
        let (Some(items), Some(sup)) = (sub, sup) else {
            let t = match sub {
                Some(items) => self.indexed(base, items, span)?,
                None => base,
            };
            return match sup {
                Some(sup) => self.power(t, sup, span),
                None => Ok(Value::Tensor(t)),
            };
        };
        let matrix = base.shape.real_extents().len() == 2;
        if matrix && (self.is_transpose(sup) || is_integer(sup, -1) || Self::conjugation(sup) == Some(true)) {
            // That of a component is none.
            if !sup_first && !self.is_transpose(sup) {
                let message = "is this the inverse or transpose of the matrix, or of its component?";
                let hint = r"write the superscript first, `A^{-1}_{ij}`, or a fraction `\frac{1}{A_{ij}}`";
                return refuse("latex::ambiguous", message, span, hint);
            }
            let Value::Tensor(t) = self.power(base, sup, span)? else {
                return refuse("latex::shape", "a matrix of unknown size", span, "");
            };
            return self.indexed(t, items, span).map(Value::Tensor);
        }
        if matrix && sup_first && Self::conjugation(sup).is_none() {
            let message = "is this a component of the power, or the power of a component?";
            let hint = r"write `A_{ij}^2` for the power of the component, `(A^2)_{ij}` for the component of the power";
            return refuse("latex::ambiguous", message, span, hint);
        }
        let t = self.indexed(base, items, span)?;
        self.power(t, sup, span)
    }

    fn indexed(&mut self, base: Tensor, items: &[SubItem], span: &Range<usize>) -> Elaborated<Tensor> {
        let indices = self.index_values(items, span)?;
        let complex = base.shape.is_complex();
        match base.shape.real().position(&indices) {
            Some(p) if complex => {
                let components = base.components.into_iter().skip(2 * p).take(2).collect();
                Ok(Tensor { shape: Shape::scalar().complexified(), components })
            }
            Some(p) if p < base.components.len() => Ok(Tensor::scalar(base.components[p])),
            _ if indices.len() != base.shape.real_extents().len() => {
                let count = match indices.len() {
                    1 => "one index".to_owned(),
                    n => format!("{n} indices"),
                };
                let hint =
                    if base.shape.real_extents().is_empty() { "declare a symbol with this subscript" } else { "" };
                refuse("latex::index", format!("{count} on a {}", base.shape), span, hint)
            }
            _ => {
                let list: Vec<String> = indices.iter().map(u16::to_string).collect();
                let message = format!("a {} has no component {}", base.shape, list.join(", "));
                refuse("latex::index", message, span, "")
            }
        }
    }

    fn integer(&self, e: expr::Expr) -> Option<i32> {
        self.graph.as_constant(e).and_then(|r| i32::try_from(r.clone()).ok())
    }

    fn power(&mut self, base: Tensor, sup: &Node, span: &Range<usize>) -> Elaborated<Value> {
        let rank = base.shape.real_extents().len();
        if rank > 0 && self.is_transpose(sup) {
            return tensor::transpose(self.graph, &base, span).map(Value::Tensor);
        }
        if let Some(transposed) = Self::conjugation(sup) {
            return self.conjugated(&base, transposed, span).map(Value::Tensor);
        }
        let raised = self.number(sup)?;
        if rank == 0 && (base.shape.is_complex() || raised.shape.is_complex()) {
            return self.complex_power(&base, &raised, span).map(Value::Tensor);
        }
        if rank == 1 && base.shape.is_complex() {
            let hint = r"write `|{\bf a}|^2`, `{\bf a}^\dagger{\bf a}` or `{\bf a}^T{\bf a}`";
            return refuse("latex::ambiguous", "is the square of a complex vector that of its length?", span, hint);
        }
        let exponent = self.scalar(sup)?;
        let integer = self.integer(exponent);
        match (rank, integer) {
            (0, Some(n)) => Ok(self.map(Value::Tensor(base), |g, e| g.powi(e, n))),
            (0, None) => Ok(self.map(Value::Tensor(base), |g, e| g.binary(Op::Pow, e, exponent))),
            (1, Some(2)) => tensor::dot(self.graph, &base, &base, span).map(Value::Tensor),
            (2, Some(-1)) => tensor::inverse(self.graph, &base, span).map(Value::Tensor),
            (2, Some(n @ 2..=HIGHEST)) => {
                let mut t = base.clone();
                for _ in 1..n {
                    let factors = vec![(t, span.clone()), (base.clone(), span.clone())];
                    t = tensor::product(self.graph, factors, span)?;
                }
                Ok(Value::Tensor(t))
            }
            _ => {
                let hint = if matches!(&sup.kind, NodeKind::Symbol(s) if s.name == "T") {
                    r"`T` is declared, so the transpose is written `^\top`"
                } else if rank == 1 {
                    r"powers of its length are written `|{\bf x}|^3`"
                } else {
                    ""
                };
                refuse("latex::shape", format!("this power of a {} is not defined", base.shape), span, hint)
            }
        }
    }

    /// `T` as a superscript, unless it is declared.
    pub(super) fn is_transpose(&self, node: &Node) -> bool {
        match &node.kind {
            NodeKind::Symbol(s) => {
                matches!(s.name.as_str(), "T" | "\\top" | "rm:T") && s.sub.is_none() && !self.scope.declares(&s.name)
            }
            _ => false,
        }
    }
}

pub(super) fn is_integer(node: &Node, n: i64) -> bool {
    match &node.kind {
        NodeKind::Number(r) => *r == Rational::from(n),
        NodeKind::Sum(terms) => match terms.as_slice() {
            [(Sign::Minus, inner)] => is_integer(inner, -n),
            _ => false,
        },
        _ => false,
    }
}
