//! Differentials that are not part of a fraction: `dW=F\,dx`.
//!
//! Along a motion every differential is a rate times the same small time, so that a relation between them is one between
//! rates, if every term has just one. Terms of another number of differentials are small of another order, and a formula in
//! which they stand together says nothing of rates: it is refused. `dx/dt` has as many above as below.

use super::super::syntax::{Chain, Node, NodeKind, RelationKind};
use super::{Elaborated, refuse};
use std::ops::Range;

const HINT: &str = r"let every term have one differential, or write rates, `\dot x`";

/// The number of differentials that parts have in common; `None` where all are 0. Where they differ they are refused.
fn common<'n>(
    parts: impl IntoIterator<Item = &'n Node>,
    whole: &Range<usize>,
    refused: &str,
) -> Elaborated<Option<i32>> {
    parts.into_iter().try_fold(None, |common, part| match (common, degree(part)?) {
        (Some(a), Some(b)) if a != b => refuse("latex::derivative", refused, whole, HINT),
        (known, found) => Ok(known.or(found)),
    })
}

/// The number of differentials of every term; `None` of a 0, which agrees with all.
fn degree(node: &Node) -> Elaborated<Option<i32>> {
    const MIXED: &str = "a term with a differential beside one without";
    match &node.kind {
        NodeKind::Number(_) if node.is_zero() => Ok(None),
        NodeKind::Differential { of, .. } => match degree(of)? {
            None | Some(0) => Ok(Some(1)),
            Some(_) => refuse("latex::derivative", "a differential of a differential", &node.span, HINT),
        },
        NodeKind::Group(inner, _) => degree(inner),
        NodeKind::Sum(terms) => common(terms.iter().map(|(_, term)| term), &node.span, MIXED),
        NodeKind::Tuple(parts) => common(parts, &node.span, MIXED),
        NodeKind::Matrix(rows) => common(rows.iter().flatten(), &node.span, MIXED),
        NodeKind::Product(parts) | NodeKind::Dot(parts) => {
            parts.iter().try_fold(Some(0), |sum, part| Ok(sum.zip(degree(part)?).map(|(a, b)| a + b)))
        }
        NodeKind::Cross { left, right, .. } => Ok(degree(left)?.zip(degree(right)?).map(|(a, b)| a + b)),
        NodeKind::Quotient { top, bottom, .. } => Ok(degree(top)?.zip(degree(bottom)?).map(|(a, b)| a - b)),
        NodeKind::Number(_)
        | NodeKind::Pi
        | NodeKind::Euler { .. }
        | NodeKind::Identity
        | NodeKind::Symbol(_)
        | NodeKind::Scripted { .. }
        | NodeKind::Root(..)
        | NodeKind::Exponential { .. }
        | NodeKind::Function(..)
        | NodeKind::Conjugate(_)
        | NodeKind::Conjugation { .. }
        | NodeKind::Absolute(_)
        | NodeKind::Derivative { .. }
        | NodeKind::Partial { .. }
        | NodeKind::Nabla { .. }
        | NodeKind::Poisson(..)
        | NodeKind::Variation { .. }
        | NodeKind::At { .. }
        | NodeKind::Factorial(_)
        | NodeKind::Limit(..) => match node.children().into_iter().find(|n| holds_differential(n)) {
            None => Ok(Some(0)),
            Some(inside) => {
                refuse("latex::derivative", "a differential stands inside of something", &inside.span, HINT)
            }
        },
    }
}

fn holds_differential(node: &Node) -> bool {
    let mut stack = vec![node];
    while let Some(node) = stack.pop() {
        if matches!(node.kind, NodeKind::Differential { .. }) {
            return true;
        }
        stack.extend(node.children());
    }
    false
}

/// Refuses an expression in which differentials are left over.
pub(super) fn cancel(node: &Node) -> Elaborated<()> {
    if !holds_differential(node) || degree(node)?.is_none_or(|n| n == 0) {
        return Ok(());
    }
    refuse("latex::derivative", "a differential stands alone", &node.span, "write an equation between differentials")
}

/// Refuses a relation whose sides differ in their number of differentials, or have more than one.
pub(super) fn agree(chain: &Chain) -> Elaborated<()> {
    if !chain.sides.iter().any(holds_differential) {
        return Ok(());
    }
    match common(&chain.sides, &chain.span, "the sides differ in their number of differentials")? {
        None | Some(0) => Ok(()),
        Some(1) if chain.relations.iter().all(|r| *r == RelationKind::Equal) => Ok(()),
        Some(1) => {
            let hint = r"write rates, `\dot x>0`, for what happens in the course of time";
            refuse("latex::derivative", "differentials are compared by `=` only", &chain.span, hint)
        }
        Some(_) => refuse("latex::derivative", "products of differentials", &chain.span, HINT),
    }
}
