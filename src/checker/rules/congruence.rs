//! Congruence: equals for equals.
//!
//! **Theorem.** If u = v at t, an expression in which some u are written as v has the same value at t, if both have one. *Proof.* The value of an operation depends on
//! the values of its arguments at t only; and x(u) = x(v) for fixed times u = v. □ So two relations that become the same when every v is written as u
//! say the same at t; and l = r, if l and r become the same.
//!
//! **Conditions.** All facts are known at the times of the result. *Trap.* A rate is no operation on values: ẋ stands beside x as a symbol of its own, and
//! x = 2 at a time does not make ẋ = 0; nothing is put into it.

use super::{made, needs_of};
use crate::context::{Context, Says};
use crate::draft::{Draft, Made};
use crate::step::FactId;
use crate::term::{Relation, Sense};
use expr::{Expr, Leaf, Node};
use std::collections::BTreeMap;

/// The expression with `u` for each `v`, at fixed times, too. Where u = v at a time, each formula in it keeps its value there.
pub(super) fn identified(context: &mut Context, e: Expr, v: Expr, u: Expr) -> Expr {
    let mut image: BTreeMap<Expr, Expr> = BTreeMap::new();
    for node in context.graph.reachable([e]) {
        let new = match *context.graph.node(node) {
            _ if node == v => u,
            Node::Constant(_) | Node::Pi => node,
            Node::Leaf(leaf @ Leaf { instant: Some(c), .. }) if c == v => {
                context.graph.leaf(Leaf { instant: Some(u), ..leaf })
            }
            Node::Leaf(_) => node,
            Node::Unary(op, a) => context.graph.unary(op, image[&a]),
            Node::Binary(op, a, b) => context.graph.rebuilt(op, image[&a], image[&b]),
        };
        image.insert(node, new);
    }
    image[&e]
}

pub(super) fn congruence(
    draft: &mut Draft,
    says: &Relation,
    from: Option<FactId>,
    equal: &[FactId],
) -> Result<Made, String> {
    let says = draft.context.relation(says)?;
    let facts: Vec<FactId> = from.into_iter().chain(equal.iter().copied()).collect();
    let when = draft.common(&facts)?;
    let mut open = needs_of(draft, says);
    let mut sides = says.sides().to_vec();
    if let Some(id) = from {
        let fact = draft.get(id)?;
        if fact.says.sense != says.sense {
            return Err("the sense differs".to_owned());
        }
        sides.extend(fact.says.sides());
        open.extend(fact.needs);
    }
    // What was put for one thing is looked through for the next.
    for id in equal {
        let fact = draft.equation(*id)?;
        for side in &mut sides {
            *side = identified(&mut draft.context, *side, fact.says.right, fact.says.left);
        }
        open.extend(fact.needs);
    }
    let become_same = match sides[..] {
        [left, right] => says.sense == Sense::Equal && left == right,
        [left, right, l, r] => {
            Says { left, sense: says.sense, right }.is(Says { left: l, sense: says.sense, right: r })
        }
        _ => false,
    };
    if !become_same {
        return Err("equals for equals does not make them the same".to_owned());
    }
    Ok(made("congruence", facts, says, when, open))
}
