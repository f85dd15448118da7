//! Equations with ±, as equations without.
//!
//! **In:** what a claim says of one time with ±: that it is so with one sign or the other, the same in all of it. **Out:** sides of equations that say the same; nothing where the two signs have values at different times.

use expr::{Expr, Graph, Leaf, Node, Op};
use latex::{Relation as Read, RelationKind};

/// Most differences with ±, which are multiplied with each other.
const MOST_SIGNED: usize = 4;

/// Whether an expression has a value for either sign of ± as soon as it has one for some: ± stands in sums, products and whole powers, and below no function.
fn is_polynomial_in(graph: &Graph, e: Expr, sign: Leaf) -> bool {
    let names = |e: Expr| graph.leaves([e]).contains(&sign);
    graph.reachable([e]).into_iter().filter(|node| names(*node)).all(|node| {
        let node = graph.node(node);
        if let Node::Leaf(_) | Node::Binary(Op::Add | Op::Sub | Op::Mul, ..) | Node::Unary(Op::Neg, _) = *node {
            return true;
        }
        if let Node::Binary(Op::Div, _, under) = *node {
            return !names(under);
        }
        if let Node::Unary(Op::Powi(n), _) = *node { n > 0 } else { false }
    })
}

/// l² = r², for l − (±1)·r, where ± stands in neither.
fn as_squares(graph: &mut Graph, difference: Expr, sign: Leaf) -> Option<(Expr, Expr)> {
    let Node::Binary(Op::Sub, l, signed) = *graph.node(difference) else { return None };
    let Node::Binary(Op::Mul, a, b) = *graph.node(signed) else { return None };
    let leaf = graph.leaf(sign);
    let r = if a == leaf { b } else { a };
    let is_whole = (a == leaf || b == leaf) && !graph.leaves([l, r]).contains(&sign);
    is_whole.then(|| (graph.powi(l, 2), graph.powi(r, 2)))
}

/// What relations with ± say of one time: they are true for the one sign, or all for the other. *Theorem.* That is so exactly if each product of a difference with the one sign and one with the other is
/// 0. *Proof.* If one product is not 0, neither all of the first differences are 0 nor all of the second. If some difference with the one sign is not 0, and some with the other, nor is their product. □ (All have values for either sign, or for none.)
pub(crate) fn of_either_sign(graph: &mut Graph, relations: &[Read], sign: Leaf) -> Option<Vec<(Expr, Expr)>> {
    let mut sides = Vec::new();
    for relation in relations {
        let plain = relation.kind == RelationKind::Equal && relation.limit.is_none();
        let pairs = relation.left.components.iter().copied().zip(relation.right.components.iter().copied());
        for (l, r) in pairs {
            if !plain || ![l, r].iter().all(|&e| is_polynomial_in(graph, e, sign)) {
                return None;
            }
            sides.push(graph.sub(l, r));
        }
    }
    if sides.len() > MOST_SIGNED {
        return None;
    }
    let mut out = Vec::new();
    let zero = graph.integer(0);
    for (at, &first) in sides.iter().enumerate() {
        for (other, &second) in sides.iter().enumerate() {
            if let Some(squares) = as_squares(graph, first, sign).filter(|_| at == other) {
                out.push(squares);
                continue;
            }
            let [plus, minus] =
                [(first, 1), (second, -1)].map(|(e, n)| graph.rewrite(e, |g, l| (l == sign).then(|| g.integer(n))));
            out.push((graph.mul(plus, minus), zero));
        }
    }
    Some(out)
}
