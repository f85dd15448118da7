//! Needs: what must hold for an expression to have a value, to be continuous, to be differentiable.
//!
//! **In:** an expression. **Out:** relations v > 0, v ≥ 0, v ≠ 0, read from the table of domains ([`expr::domain`]), which has one row
//! for each operation. **Guaranteed:** at a time at which all of [`needs`] hold, the expression has a value; where all of
//! [`continuous`] hold, it has values on a neighbourhood in T and is continuous there; where all of [`smooth`] hold, it is
//! continuously differentiable, if the symbols in it are.
//!
//! **Why strict:** v ≥ 0 at a time says nothing of the times beside it (√x on x = −t² has a value at t = 0 only), while v > 0 does,
//! if v is continuous. So each v ≥ 0 whose v moves is sharpened to v > 0 wherever a neighbourhood is meant, unless v ≥ 0 is known at
//! all times in question.

use super::context::Context;
use super::signs::{Signs, signs};
use expr::domain::{Change, Sign};
use expr::{Expr, Leaf, Node, Op};
use std::collections::{BTreeMap, BTreeSet};

/// A condition on an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Need {
    pub(crate) value: Expr,
    pub(crate) sign: Sign,
}

impl Need {
    pub(crate) fn not_zero(value: Expr) -> Need {
        Need { value, sign: Sign::NotZero }
    }
}

/// The signs that a need allows.
pub(crate) fn allowed(sign: Sign) -> Signs {
    match sign {
        Sign::Positive => Signs::POSITIVE,
        Sign::NotNegative => Signs::POSITIVE.or(Signs::ZERO),
        Sign::NotZero => Signs::POSITIVE.or(Signs::NEGATIVE),
    }
}

/// Needs, each once, in the order of the graph.
pub(crate) type Needs = BTreeSet<Need>;

/// The nodes below an expression, and below the fixed times in it. Of a restriction, both formula and function.
fn below(context: &Context, e: Expr) -> Vec<Expr> {
    let mut roots = vec![e];
    loop {
        let instants = context.graph.leaves(roots.iter().copied()).into_iter().filter_map(|leaf| leaf.instant);
        let new: BTreeSet<Expr> = instants.filter(|c| !roots.contains(c)).collect();
        if new.is_empty() {
            return context.graph.reachable(roots);
        }
        roots.extend(new);
    }
}

/// Whether a need holds whatever the symbols are: by the signs of squares, exponentials, numbers and constants.
pub(crate) fn is_trivial(context: &Context, need: Need) -> bool {
    signs(context, need.value, &BTreeMap::new()).within(allowed(need.sign))
}

fn of_nodes(context: &mut Context, nodes: Vec<Expr>) -> Needs {
    let mut out = Needs::new();
    for node in nodes {
        for need in context.graph.needs(node) {
            // A product is not 0 exactly if no factor is; the factors have values where it has one.
            let values = match need.sign {
                Sign::NotZero => context.factors(need.value),
                Sign::Positive | Sign::NotNegative => vec![need.value],
            };
            let parts = values.into_iter().map(|value| Need { value, sign: need.sign });
            out.extend(parts.filter(|part| !is_trivial(context, *part)).collect::<Vec<_>>());
        }
    }
    out
}

/// Where these hold, the expression has a value.
pub(crate) fn needs(context: &mut Context, e: Expr) -> Needs {
    let nodes = below(context, e);
    of_nodes(context, nodes)
}

/// Where one of these does not hold, the expression has no value for certain. What stands in the formula for the rate of a
/// function only is not among them.
pub(crate) fn certain(context: &mut Context, e: Expr) -> Needs {
    let (mut seen, mut open) = (BTreeSet::new(), vec![e]);
    while let Some(node) = open.pop() {
        if seen.insert(node) {
            match *context.graph.node(node) {
                Node::Binary(Op::Restrict, _, of) => open.push(of),
                Node::Leaf(leaf) => open.extend(leaf.instant),
                Node::Constant(_) | Node::Pi => {}
                Node::Unary(..) | Node::Binary(..) => open.extend(context.graph.node(node).children()),
            }
        }
    }
    of_nodes(context, seen.into_iter().collect())
}

/// Expressions that are not 0 where the expression touches no edge of a kind for which `counts` says so. An edge at which a term
/// vanishes while another one, w, is positive is excluded by |v| + |w| − w ≠ 0. An argument that passes through infinity has no
/// value there. What does not move touches nothing.
pub(crate) fn edges(context: &mut Context, e: Expr, counts: impl Fn(Change) -> bool) -> Vec<Expr> {
    let mut out = Vec::new();
    for node in context.graph.reachable([e]) {
        for edge in context.graph.edges(node) {
            let Some(v) = edge.vanishing.filter(|_| counts(edge.change)) else { continue };
            let guard = match edge.whilst {
                None => v,
                Some(w) => {
                    let (v, size) = (context.graph.unary(Op::Abs, v), context.graph.unary(Op::Abs, w));
                    let rest = context.graph.sub(size, w);
                    context.graph.add(v, rest)
                }
            };
            if context.moves(guard) && !is_trivial(context, Need::not_zero(guard)) && !out.contains(&guard) {
                out.push(guard);
            }
        }
    }
    out
}

fn leaps(change: Change) -> bool {
    match change {
        Change::Jump(_) => true,
        // Where a pole or a logarithm is touched there is no value; kinks and steep edges are continuous.
        Change::Pole(..) | Change::Log | Change::Kink | Change::Steep => false,
    }
}

/// Needs, and what the expressions that they ask about need to have values.
pub(crate) fn closure(context: &mut Context, of: &Needs) -> Needs {
    let mut out = of.clone();
    for need in of {
        out.extend(needs(context, need.value));
    }
    out
}

/// If these hold at a time, the needs hold at all times beside it: strict where they move, unless they are among `everywhere`; what
/// they ask about has values on a neighbourhood, and does not leap.
pub(crate) fn around(context: &mut Context, needs: &Needs, everywhere: &Needs) -> Needs {
    let mut out = Needs::new();
    for need in closure(context, needs) {
        let sharp = match need.sign {
            Sign::NotNegative if context.moves(need.value) && !everywhere.contains(&need) => Sign::Positive,
            other => other,
        };
        out.insert(Need { sign: sharp, ..need });
        for edge in edges(context, need.value, leaps) {
            out.extend([Need::not_zero(edge)]);
        }
    }
    out
}

/// Where these hold, the expression has values on a neighbourhood in T, and is continuous.
pub(crate) fn continuous(context: &mut Context, e: Expr, everywhere: &Needs) -> Needs {
    let own = needs(context, e);
    let mut out = around(context, &own, everywhere);
    out.extend(edges(context, e, leaps).into_iter().map(Need::not_zero));
    out
}

/// Where these hold, the expression has values on a neighbourhood in T, and is as often continuously differentiable as the symbols
/// in it.
pub(crate) fn smooth(context: &mut Context, e: Expr) -> Needs {
    let own = needs(context, e);
    let mut out = around(context, &own, &Needs::new());
    out.extend(edges(context, e, |_| true).into_iter().map(Need::not_zero));
    out
}

/// An expression at a fixed time: each symbol that moves is taken at it.
pub(crate) fn frozen(context: &mut Context, e: Expr, at: Expr) -> Expr {
    replaced(context, e, |context, leaf| match context.leaf_moves(leaf) {
        false => None,
        true if matches!(context.kind(leaf), super::sequent::SymbolKind::Time) => Some(at),
        true => Some(context.graph.leaf(Leaf { instant: Some(at), ..leaf })),
    })
}

/// An expression with leaves replaced.
pub(crate) fn replaced(context: &mut Context, e: Expr, with: impl Fn(&mut Context, Leaf) -> Option<Expr>) -> Expr {
    let mut image: BTreeMap<Expr, Expr> = BTreeMap::new();
    for node in context.graph.reachable([e]) {
        let new = match *context.graph.node(node) {
            Node::Constant(_) | Node::Pi => node,
            Node::Leaf(leaf) => with(context, leaf).unwrap_or(node),
            Node::Unary(op, a) => context.graph.unary(op, image[&a]),
            Node::Binary(op, a, b) => context.graph.rebuilt(op, image[&a], image[&b]),
        };
        image.insert(node, new);
    }
    image[&e]
}
