//! Commutators and anticommutators of matrices.
//!
//! **In:** two formulas between brackets, or between braces that are printed. **Out:** AB − BA, or AB + BA, where both are square matrices of
//! one size. **Guaranteed:** nothing else is read so: brackets of vectors are the vector product, braces of numbers the Poisson bracket; and
//! braces of matrices are refused where canonical variables are declared, since both could be meant.

use std::ops::Range;

use super::super::syntax::{Node, NodeKind};
use super::value::Value;
use super::{Elaborated, Elaborator, refuse};

impl Elaborator<'_> {
    /// [A, B], or with `plus` {A, B}; `None` where they are no two square matrices of one size.
    pub(super) fn commutator(
        &mut self,
        left: &Node,
        right: &Node,
        plus: bool,
        span: &Range<usize>,
    ) -> Elaborated<Option<Value>> {
        let (a, b) = (self.value(left)?, self.value(right)?);
        let size = |v: &Value| match v {
            Value::Tensor(t) => match *t.shape.real_extents() {
                [n, m] if n == m => Some(n),
                _ => None,
            },
            Value::Identity(_) => None,
        };
        let sizes = match (&a, &b) {
            (Value::Identity(_), _) => (size(&b), size(&b)),
            (_, Value::Identity(_)) => (size(&a), size(&a)),
            _ => (size(&a), size(&b)),
        };
        let (Some(n), Some(m)) = sizes else { return Ok(None) };
        if n != m {
            return refuse("latex::shape", format!("a {n}×{n} matrix and a {m}×{m} matrix"), span, "");
        }
        if plus && !self.scope.canonical_pairs(self.graph).is_empty() {
            let hint = "write `AB+BA` for the anticommutator, components for the Poisson bracket";
            return refuse("latex::ambiguous", "an anticommutator of matrices, or their Poisson bracket?", span, hint);
        }
        let (a, b) = ((a, left.span.clone()), (b, right.span.clone()));
        let forth = self.product(vec![a.clone(), b.clone()], span)?;
        let back = self.product(vec![b, a], span)?;
        self.combine(forth, back, span, |g, x, y| if plus { g.add(x, y) } else { g.sub(x, y) }).map(Some)
    }

    /// Refuses `AB_{12}` and `Au_1` where the matrices could be multiplied first: a subscript behind a product could be that of the product.
    pub(super) fn component_is_clear(&self, parts: &[Node], values: &[(Value, Range<usize>)]) -> Elaborated<()> {
        let Some(Node { kind: NodeKind::Symbol(s), span }) = parts.last() else { return Ok(()) };
        if s.sub.is_none() || self.builtin(s).is_some() {
            return Ok(());
        }
        let before = values.iter().rev().skip(1).find_map(|(value, _)| match value {
            Value::Tensor(t) if t.shape.real_extents().is_empty() => None,
            Value::Tensor(t) => Some(t.shape.real_extents().to_vec()),
            Value::Identity(_) => None,
        });
        let (Some([_, columns]), Ok(found)) = (before.as_deref(), self.resolve(s, span)) else { return Ok(()) };
        let shape = match found.definition {
            Some(t) => t.shape.clone(),
            None => self.graph.shape(found.symbol).clone(),
        };
        let extents = shape.real_extents();
        if extents.len() != found.indices.len() || extents.first() != Some(columns) {
            return Ok(());
        }
        let message = "is this a component of the product, or a matrix times a component?";
        let hint = r"write parentheses around the product, `(AB)_{12}`, or the number before the matrix, `B_{12}A`";
        refuse("latex::ambiguous", message, span, hint)
    }
}
