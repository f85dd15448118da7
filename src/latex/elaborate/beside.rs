//! A vector beside a scalar product: `\frac{{\bf r}}{r^3}\,{\bf v}\cdot{\bf r}`.
//!
//! **In:** the two parts of a scalar product, of which the first ends with two vectors side by side. **Out:** the first vector times the scalar
//! product of the others. **Guaranteed:** two vectors side by side have no product of their own, so that there is one reading; everybody who gives
//! them one, as a dyad or in an algebra, reads the same here.

use std::ops::Range;

use super::super::syntax::{Node, NodeKind};
use super::super::tensor;
use super::value::Value;
use super::{Elaborated, Elaborator};

impl Elaborator<'_> {
    /// The value of such a product; `None` where it is none.
    // Out of line: what calls it is deep enough as it is.
    #[inline(never)]
    pub(super) fn vector_by_scalar_product(
        &mut self,
        parts: &[Node],
        span: &Range<usize>,
    ) -> Elaborated<Option<Value>> {
        let [Node { kind: NodeKind::Product(factors), .. }, second] = parts else { return Ok(None) };
        let Some((first, before)) = factors.split_last() else { return Ok(None) };
        // What holds another one is not looked into twice.
        if parts.iter().any(holds_scalar_product) {
            return Ok(None);
        }
        let mut values = Vec::new();
        for node in before.iter().chain([first, second]) {
            match self.value(node)? {
                Value::Tensor(t) => values.push((t, node.span.clone())),
                Value::Identity(_) => return Ok(None),
            }
        }
        let ranks: Vec<usize> = values.iter().map(|(t, _)| t.shape.real_extents().len()).collect();
        let [others @ .., 1, 1] = ranks.as_slice() else { return Ok(None) };
        if others.iter().filter(|r| **r == 1).count() != 1 {
            return Ok(None);
        }
        let mut last = values.split_off(before.len()).into_iter();
        let (Some((a, at)), Some((b, _))) = (last.next(), last.next()) else { return Ok(None) };
        self.conjugation_is_clear(&a, &b, &[first.clone(), second.clone()], span)?;
        let whole = at.start..span.end;
        let number = tensor::dot(self.graph, &a, &b, &whole)?;
        let mut factors: Vec<(Value, Range<usize>)> =
            values.into_iter().map(|(t, at)| (Value::Tensor(t), at)).collect();
        factors.push((Value::Tensor(number), whole));
        self.product(factors, span).map(Some)
    }
}

fn holds_scalar_product(node: &Node) -> bool {
    matches!(node.kind, NodeKind::Dot(_)) || node.children().into_iter().any(holds_scalar_product)
}
