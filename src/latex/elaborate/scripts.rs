//! Subscripts and superscripts: components, powers, inverses, transposes.

use std::ops::Range;

use super::super::syntax::{Node, NodeKind, Sign, SubItem};
use super::super::tensor;
use super::{Elaborated, Elaborator, Value, refuse};
use expr::{Op, Rational, Tensor};

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
                let Some(sup) = sup.filter(|sup| !self.is_transpose(sup)) else { return Ok(Value::Identity(s)) };
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
        let matrix = base.shape.rank() == 2;
        if matrix && (self.is_transpose(sup) || is_integer(sup, -1)) {
            if !sup_first {
                let message = "is this the inverse or transpose of the matrix, or of its component?";
                let hint = r"write the superscript first, `A^{-1}_{ij}`, or a fraction `\frac{1}{A_{ij}}`";
                return refuse("latex::ambiguous", message, span, hint);
            }
            let Value::Tensor(t) = self.power(base, sup, span)? else {
                return refuse("latex::shape", "a matrix of unknown size", span, "");
            };
            return self.indexed(t, items, span).map(Value::Tensor);
        }
        if matrix && sup_first {
            let message = "is this a component of the power, or the power of a component?";
            let hint = r"write `A_{ij}^2` for the power of the component, `(A^2)_{ij}` for the component of the power";
            return refuse("latex::ambiguous", message, span, hint);
        }
        let t = self.indexed(base, items, span)?;
        self.power(t, sup, span)
    }

    fn indexed(&mut self, base: Tensor, items: &[SubItem], span: &Range<usize>) -> Elaborated<Tensor> {
        let indices = self.index_values(items, span)?;
        match base.shape.position(&indices).and_then(|p| base.components.get(p)) {
            Some(&e) => Ok(Tensor::scalar(e)),
            None if indices.len() != base.shape.rank() => {
                let count = match indices.len() {
                    1 => "one index".to_owned(),
                    n => format!("{n} indices"),
                };
                let hint = if base.shape.rank() == 0 { "declare a symbol with this subscript" } else { "" };
                refuse("latex::index", format!("{count} on a {}", base.shape), span, hint)
            }
            None => {
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
        if base.shape.rank() > 0 && self.is_transpose(sup) {
            return tensor::transpose(&base, span).map(Value::Tensor);
        }
        let exponent = self.scalar(sup)?;
        let integer = self.integer(exponent);
        match (base.shape.rank(), integer) {
            (0, Some(n)) => Ok(self.map(Value::Tensor(base), |g, e| g.powi(e, n))),
            (0, None) => Ok(self.map(Value::Tensor(base), |g, e| g.binary(Op::Pow, e, exponent))),
            (1, Some(2)) => tensor::dot(self.graph, &base, &base, span).map(Value::Tensor),
            (2, Some(-1)) => tensor::inverse(self.graph, &base, span).map(Value::Tensor),
            (2, Some(n @ 2..=HIGHEST)) => {
                let mut t = base.clone();
                for _ in 1..n {
                    let factors = vec![(t, span.clone()), (base.clone(), span.clone())];
                    t = tensor::product(self.graph, factors, false, span)?;
                }
                Ok(Value::Tensor(t))
            }
            _ => {
                let hint = if matches!(&sup.kind, NodeKind::Symbol(s) if s.name == "T") {
                    r"`T` is declared, so the transpose is written `^\top`"
                } else if base.shape.rank() == 1 {
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
