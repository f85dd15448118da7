//! Factors side by side, and relations: whether two pieces may stand beside one another.

use super::super::syntax::{Bracket, Node, NodeKind, RelationKind};
use super::{Parsed, refuse};

/// Refuses numbers where they could be read as part of what stands before them.
pub(super) fn side_by_side(last: &Node, factor: &Node) -> Parsed<()> {
    let span = last.span.start..factor.span.end;
    let number = |n: &Node| matches!(n.kind, NodeKind::Number(_));
    if factor.begins_with_number() {
        // `r^3 4\pi^2`: the exponent ends where the line goes on. Without a space it could be `r^{34}`.
        let raised = match &last.kind {
            NodeKind::Symbol(s) => s.arguments.is_none() && s.sup.as_deref().is_some_and(number),
            _ => false,
        };
        return if number(last) {
            refuse("latex::ambiguous", "two numbers stand side by side", span, r"write `\cdot` between them")
        } else if raised && last.span.end < factor.span.start {
            Ok(())
        } else {
            // `(a+b)10^{-3}`: nothing touches a power of a number behind a parenthesis.
            let power = matches!(&factor.kind, NodeKind::Scripted { base, .. } if number(base));
            if power && matches!(last.kind, NodeKind::Group(..)) {
                return Ok(());
            }
            let hint = r"write the number first, or `\cdot` before it, or a subscript";
            refuse("latex::ambiguous", "a number stands behind a factor", span, hint)
        };
    }
    if let (true, NodeKind::Group(inside, Bracket::Round)) = (number(last), &factor.kind)
        && matches!(&inside.kind, NodeKind::Number(n) if n.is_int())
    {
        let hint = r"write `\cdot` between them; an uncertainty is no part of a formula";
        return refuse(
            "latex::ambiguous",
            "a number and one in parentheses: a product, or its uncertainty",
            span,
            hint,
        );
    }
    if let (true, NodeKind::Quotient { top, bottom, .. }) = (number(last), &factor.kind)
        && number(top)
        && number(bottom)
    {
        let hint = r"write `\cdot` between them, or one fraction";
        return refuse("latex::ambiguous", "a number and a fraction: a product or a sum?", span, hint);
    }
    Ok(())
}

/// The relation that a command is.
pub(super) fn relation(command: &str) -> Option<RelationKind> {
    Some(match command {
        "equiv" | "coloneqq" => RelationKind::Equal,
        "ne" | "neq" => RelationKind::NotEqual,
        "lt" => RelationKind::Less,
        "gt" => RelationKind::Greater,
        "le" | "leq" | "leqslant" => RelationKind::LessEqual,
        "ge" | "geq" | "geqslant" => RelationKind::GreaterEqual,
        _ => return None,
    })
}

/// Whether a command is a relation.
pub(crate) fn is_relation(command: &str) -> bool {
    relation(command).is_some()
}
