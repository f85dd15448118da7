//! Where one piece of a formula ends and the next begins: what is printed between them, so that they are read as they are.
//!
//! **In:** syntax trees beside one another. **Out:** whether the end of one can be seen, whether the next may follow it without
//! parentheses, and what stands between them.

use crate::syntax::{Bracket, Least, Nabla, Node, NodeKind, PartialForm, tightness};
use expr::Rational;

/// What stands between two factors, so that they are read as two factors.
///
/// Of each it is known whether it stands there without parentheses that the writer adds.
pub(super) fn between((before, bare): (&Node, bool), (after, fits): (&Node, bool)) -> &'static str {
    // `x(y)` would be a value of x, `x2` no product that is printed.
    let number = matches!(before.kind, NodeKind::Number(_));
    let mixed = number && matches!(after.kind, NodeKind::Quotient { slash: false, .. }) && after.is_numeric();
    // `1.5(2)` could be an uncertainty.
    let whole = |inside: &Node| matches!(&inside.kind, NodeKind::Number(n) if n.is_int());
    if number && matches!(&after.kind, NodeKind::Group(inside, Bracket::Round) if whole(inside)) {
        return r"\cdot ";
    }
    if bare && end(before) == End::Clear {
        return "";
    }
    let derivative = names_derivative(before) || matches!(before.kind, NodeKind::Poisson(..));
    // Behind what shows what it depends on, it could be a value at a time or place.
    if !fits || (!bare || derivative || names_derivative(after)) && begins_with_parenthesis(after) {
        return r"\cdot ";
    }
    if after.begins_with_number() || mixed || !before.is_numeric() && could_be_argument(after) {
        return r"\cdot ";
    }
    if could_be_call(before, after) {
        return r"\,";
    }
    // A space that is printed ends the argument of a function.
    let ends_alike = matches!(after.kind, NodeKind::Function(..));
    if bare && ends_with_bare_argument(before) && !ends_alike { r"\," } else { "" }
}

/// Whether a formula ends with the argument of a function that stands without parentheses.
pub(super) fn ends_with_bare_argument(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Function(name, _, arguments) => {
            crate::parse::takes_bare_argument(name)
                && matches!(arguments.as_slice(), [one] if !matches!(one.kind, NodeKind::Group(..) | NodeKind::Absolute(_) | NodeKind::Matrix(_)))
        }
        NodeKind::Product(parts) | NodeKind::Dot(parts) => parts.last().is_some_and(ends_with_bare_argument),
        _ => false,
    }
}

/// Whether the end of a formula can be seen in print.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// Anything may follow.
    Seen,
    /// A derivative of a symbol: another derivative may follow.
    Clear,
    /// Nobody could say how far its last derivative reaches, or what belongs to its denominator: the reader refuses it.
    Open,
}

/// How a formula ends that is printed without parentheses around it.
pub(super) fn end(node: &Node) -> End {
    match &node.kind {
        NodeKind::Product(parts) | NodeKind::Dot(parts) => parts.last().map_or(End::Seen, end),
        NodeKind::Cross { right, bracket: false, .. } => end(right),
        NodeKind::Quotient { slash: true, .. } => End::Open,
        NodeKind::Nabla { action: Nabla::Following { fraction: true }, .. }
        | NodeKind::Partial { form: PartialForm::Fraction, .. }
        | NodeKind::Derivative { operator: false, .. } => End::Seen,
        NodeKind::Derivative { of, .. } | NodeKind::Partial { of, .. } | NodeKind::Nabla { of, .. } => match &of.kind {
            _ if tightness(of) < Least::Factor || is_raised(of) || of.begins_with_number() => End::Seen,
            NodeKind::Group(..) => End::Seen,
            NodeKind::Symbol(s) if s.arguments.is_some() => End::Clear,
            _ if matches!(node.kind, NodeKind::Derivative { .. }) => End::Open,
            NodeKind::Poisson(..) => End::Seen,
            NodeKind::Symbol(_)
            | NodeKind::Nabla { action: Nabla::Following { fraction: true }, .. }
            | NodeKind::Partial { form: PartialForm::Fraction, .. } => End::Clear,
            NodeKind::Partial { .. } | NodeKind::Nabla { .. } => end(of),
            _ => End::Open,
        },
        _ => End::Seen,
    }
}

/// Of each factor, whether the next one may follow it as it is: otherwise it gets parentheses.
pub(super) fn fitting(parts: &[Node]) -> Vec<bool> {
    let mut fits = vec![true; parts.len()];
    for at in (1..parts.len()).rev() {
        let (before, after) = (&parts[at - 1], &parts[at]);
        let derivative = match &after.kind {
            NodeKind::Derivative { .. } | NodeKind::Partial { .. } => true,
            NodeKind::Nabla { action, .. } => {
                !matches!(action, Nabla::Along(_) | Nabla::Following { .. } | Nabla::Laplacian { delta: true })
            }
            _ => false,
        };
        fits[at - 1] = match end(before) {
            End::Seen => !ends_with_bare_argument(before) || fits[at] && !begins_with_parenthesis(after),
            End::Clear => derivative && fits[at],
            End::Open => false,
        };
    }
    fits
}

/// Whether the factors of a product are joined by dots, in part at least.
pub(super) fn has_dots(node: &Node) -> bool {
    let NodeKind::Product(parts) = &node.kind else { return false };
    let fits = fitting(parts);
    let joint = |at: usize| between((&parts[at - 1], fits[at - 1]), (&parts[at], fits[at]));
    (1..parts.len()).any(|at| joint(at) == r"\cdot ")
}

/// Whether a factor is printed with a parenthesis first.
fn begins_with_parenthesis(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Group(_, Bracket::Round) | NodeKind::Tuple(_) => true,
        NodeKind::Nabla { action: Nabla::Along(_), .. } => true,
        NodeKind::Scripted { base, .. } => !is_one_piece(base) || begins_with_parenthesis(base),
        NodeKind::At { of, bar: None, .. } => end(of) != End::Seen || begins_with_parenthesis(of),
        _ => tightness(node) < Least::Factor,
    }
}

/// Whether a derivative occurs in something.
fn names_derivative(node: &Node) -> bool {
    let is_one = matches!(
        node.kind,
        NodeKind::Partial { .. } | NodeKind::Nabla { .. } | NodeKind::Derivative { .. } | NodeKind::Variation { .. }
    );
    is_one || node.children().into_iter().any(names_derivative)
}

/// What stands in an argument without parentheses beside others.
pub(super) fn is_letter_or_number(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Number(_) | NodeKind::Pi => true,
        NodeKind::Symbol(s) => s.sup.is_none() && s.arguments.is_none(),
        _ => false,
    }
}

/// Whether a script behind something belongs to all of it.
pub(super) fn is_one_piece(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Partial { .. }
        | NodeKind::Nabla { .. }
        | NodeKind::Derivative { .. }
        | NodeKind::Variation { .. }
        | NodeKind::Quotient { .. }
        | NodeKind::Exponential { .. }
        | NodeKind::Factorial(_)
        | NodeKind::Scripted { .. }
        | NodeKind::At { bar: Some(_), .. } => false,
        NodeKind::Function(name, power, _) => power.is_none() && crate::parse::whole_part(name).is_some(),
        NodeKind::Symbol(s) => s.sup.is_none() && crate::name::labelled(&s.name).is_none(),
        _ => true,
    }
}

/// Whether something has a power.
pub(super) fn is_raised(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Symbol(s) => s.sup.is_some(),
        NodeKind::Scripted { sup, .. } => sup.is_some(),
        _ => false,
    }
}

/// Whether a name before brackets, or before a function, would be taken for what is applied to it.
fn could_be_call(before: &Node, after: &Node) -> bool {
    let NodeKind::Symbol(s) = &before.kind else { return false };
    let brackets = match &after.kind {
        NodeKind::Scripted { base, .. } => base,
        _ => after,
    };
    let called = match &brackets.kind {
        NodeKind::Group(inner, Bracket::Square) => {
            !matches!(inner.kind, NodeKind::Sum(_)) || crate::convention::prints_as_function(&s.name)
        }
        NodeKind::Tuple(_) => true,
        NodeKind::Symbol(of) => of.arguments.is_some() && crate::convention::prints_as_operator(&s.name),
        _ => begins_with_parenthesis(after) && crate::convention::prints_as_function(&s.name),
    };
    s.arguments.is_none() && called
}

/// Whether something in parentheses could be the argument of what stands before it.
fn could_be_argument(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Group(inner, Bracket::Round) => match &inner.kind {
            NodeKind::Sum(_) => inner.is_numeric(),
            NodeKind::Dot(_) | NodeKind::Cross { .. } => false,
            _ => true,
        },
        // With indices it is no time.
        NodeKind::Scripted { base, sub, .. } => sub.is_none() && (!is_one_piece(base) || could_be_argument(base)),
        NodeKind::Nabla { action: Nabla::Along(_), .. } => true,
        NodeKind::Number(r) => *r < Rational::ZERO,
        NodeKind::Sum(_) => node.is_numeric(),
        // What gets its parentheses from the writer.
        _ => tightness(node) < Least::Factor,
    }
}
