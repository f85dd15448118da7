//! Derivatives by the time, and by what changes with it.
//!
//! **In:** what is derived, and by what. **Out:** its rate, or the quotient of two. **Guaranteed:** what has no rate, and what could be another
//! derivative, is refused.

use std::ops::Range;

use super::super::scope::Role;
use super::super::syntax::{Node, NodeKind};
use super::{Elaborated, Elaborator, refuse};
use expr::{Leaf, Tensor};

impl Elaborator<'_> {
    pub(super) fn derivative(&mut self, of: &Node, by: &Node, order: u8, span: &Range<usize>) -> Elaborated<Tensor> {
        if let NodeKind::Symbol(s) = &of.kind {
            let role = self.resolve(s, &of.span)?.role;
            // `dx/dx` is 1, and `dx/dt` of a coordinate a slip.
            if role != Role::Coordinate || self.coordinate(by)? != self.coordinate(of)? {
                self.has_rate(role, &of.span)?;
            }
        }
        let value = self.tensor(of)?;
        if self.number(by)?.shape.is_complex() {
            let hint = "derivatives are taken by something real, along a motion";
            return refuse("latex::derivative", "a derivative by a complex number", &by.span, hint);
        }
        let by_value = self.scalar(by)?;
        if let Some(at) = self.coordinate(by)?
            && self.scope.time().is_none_or(|time| self.graph.leaf(time) != by_value)
        {
            return (0..order).try_fold(value, |value, _| self.total(value, at, span));
        }
        if let Some(leaf) = self.leaf(by_value)
            && self.depends_on_parameter(&value, leaf)
        {
            return (0..order).try_fold(value, |value, _| {
                self.derived(value, span, |this, e| this.graph.partial_derivative(e, leaf))
            });
        }
        let Some(time) = self.scope.time() else {
            let hint = "give one the role `time`";
            return refuse("latex::derivative", "no symbol is declared as the time", span, hint);
        };
        let time_node = self.graph.leaf(time);
        if by_value == time_node {
            let mut t = value;
            for _ in 0..order {
                t = self.time_derivative(t, span)?;
            }
            return Ok(t);
        }
        if order > 1 {
            let message = "a higher derivative by something other than time";
            return refuse("latex::derivative", message, span, "write it out");
        }
        if !self.moves(by_value) {
            let message = "what stands in the denominator does not depend on time";
            let hint = "derivatives are taken along a motion, by the time or by something that moves";
            return refuse("latex::derivative", message, &by.span, hint);
        }
        let top = self.time_derivative(value, span)?;
        let below = self.time_derivative(Tensor::scalar(by_value), &by.span)?;
        let below = below.as_scalar().unwrap_or(by_value);
        let components = top.components.into_iter().map(|x| self.graph.div(x, below)).collect();
        Ok(Tensor { shape: top.shape, components })
    }

    /// Whether a leaf has rates.
    pub(super) fn is_moving(&self, leaf: Leaf) -> bool {
        leaf.instant.is_none()
            && matches!(self.scope.role(leaf.symbol), Some(Role::State | Role::Observable | Role::Time))
    }

    pub(super) fn time_derivative(&mut self, t: Tensor, span: &Range<usize>) -> Elaborated<Tensor> {
        let Some(time) = self.scope.time() else {
            let hint = "give one the role `time`";
            return refuse("latex::derivative", "no symbol is declared as the time", span, hint);
        };
        self.names_no_argument(&t, span)?;
        self.is_total(&t, self.graph.coordinate(time), span)?;
        let scope = self.scope;
        let moves = |leaf: Leaf| scope.moves(&leaf);
        self.derived(t, span, |this, e| this.graph.time_derivative(e, time, moves))
    }
}
