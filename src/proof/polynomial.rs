//! Lowered expressions as fractions, products and polynomials in one leaf, without expanding the rest.

use super::structure::Powers;
use expr::FastMap;
use expr::{Expr, Graph, Node, Op, Rational};

/// (N, D) with e = N/D and no division in either, except below a root or |·|.
pub(super) fn fraction(graph: &mut Graph, e: Expr) -> (Expr, Expr) {
    let one = graph.integer(1);
    let order = graph.reachable([e]);
    let mut known: FastMap<Expr, (Expr, Expr)> = FastMap::with_capacity_and_hasher(order.len(), Default::default());
    for node in order {
        let value = fraction_of_node(graph, &known, one, node);
        known.insert(node, value);
    }
    known.get(&e).copied().unwrap_or((e, one))
}

/// The same for a node, once it is known for its children.
pub(super) fn fraction_of_node(
    graph: &mut Graph,
    known: &FastMap<Expr, (Expr, Expr)>,
    one: Expr,
    node: Expr,
) -> (Expr, Expr) {
    match graph.node(node).clone() {
        Node::Constant(r) => {
            let (top, under) = Rational::clone(&r).into_parts();
            let top = graph.constant(Rational::from(top));
            (top, graph.constant(Rational::from(under)))
        }
        Node::Unary(Op::Neg, a) => match known.get(&a) {
            Some(&(n, d)) => (graph.neg(n), d),
            None => (node, one),
        },
        Node::Unary(Op::Powi(k), a) => match known.get(&a) {
            Some(&(n, d)) => {
                let (n, d) = if k < 0 { (d, n) } else { (n, d) };
                let k = k.saturating_abs();
                (graph.powi(n, k), graph.powi(d, k))
            }
            None => (node, one),
        },
        Node::Binary(op @ (Op::Add | Op::Sub | Op::Mul | Op::Div), a, b) => match (known.get(&a), known.get(&b)) {
            (Some(&(n, d)), Some(&(m, c))) => match op {
                Op::Mul => (graph.mul_structural(n, m), graph.mul(d, c)),
                Op::Div => (graph.mul_structural(n, c), graph.mul(d, m)),
                _ if d == c => (graph.binary(op, n, m), d),
                _ => {
                    let (left, right) = (graph.mul_structural(n, c), graph.mul_structural(m, d));
                    (graph.binary(op, left, right), graph.mul(d, c))
                }
            },
            _ => (node, one),
        },
        _ => (node, one),
    }
}

/// e = q·∏ baseᵏ by structure: products, quotients, powers and signs are taken apart, sums and roots are bases.
pub(super) fn factors(graph: &Graph, e: Expr) -> (Rational, Vec<(Expr, i32)>) {
    let mut q = Rational::ONE;
    let mut out: Vec<(Expr, i32)> = Vec::new();
    let mut stack = vec![(e, 1i32)];
    while let Some((e, k)) = stack.pop() {
        match graph.node(e) {
            Node::Constant(r) if **r != Rational::ZERO && k.unsigned_abs() <= 64 => q *= r.pow(k as isize),
            Node::Unary(Op::Neg, a) => {
                if k % 2 != 0 {
                    q = -q;
                }
                stack.push((*a, k));
            }
            Node::Unary(Op::Powi(n), a) if n.checked_mul(k).is_some_and(|m| m != 0) => stack.push((*a, n * k)),
            Node::Binary(Op::Mul, a, b) => stack.extend([(*a, k), (*b, k)]),
            Node::Binary(Op::Div, a, b) => stack.extend([(*a, k), (*b, -k)]),
            _ => match out.iter_mut().find(|(base, _)| *base == e) {
                Some((_, n)) => *n = n.saturating_add(k),
                None => out.push((e, k)),
            },
        }
    }
    out.retain(|&(_, k)| k != 0);
    (q, out)
}

/// Coefficients of a node as a polynomial in a leaf, lowest first, once they are known for its children: `None` for a node
/// that does not depend on the leaf, `Some(None)` where the leaf stands under a root or in a denominator, or the degree is
/// above `highest`. `known` gives them for nodes that depend on the leaf.
pub(super) fn powers_of_node(
    graph: &mut Graph,
    node: Expr,
    zero: Expr,
    highest: usize,
    known: impl Fn(Expr) -> Option<Powers>,
) -> Option<Option<Powers>> {
    let found: Powers = match *graph.node(node) {
        Node::Constant(_) | Node::Pi | Node::Leaf(_) => return None,
        Node::Unary(op, a) => {
            let a = known(a)?;
            match op {
                Op::Neg => a.iter().map(|&c| graph.neg(c)).collect(),
                Op::Powi(n) if n > 0 && n as usize * (a.len() - 1) <= highest => {
                    let mut out = a.to_vec();
                    for _ in 1..n {
                        out = convolve(graph, &out, &a);
                    }
                    out.into()
                }
                _ => return Some(None),
            }
        }
        Node::Binary(op, a, b) => {
            let (own_a, own_b) = ([a], [b]);
            let (a, b) = (known(a), known(b));
            if a.is_none() && b.is_none() {
                return None;
            }
            let (a, b) = (a.as_deref().unwrap_or(&own_a), b.as_deref().unwrap_or(&own_b));
            match op {
                Op::Add | Op::Sub => (0..a.len().max(b.len()))
                    .map(|i| {
                        let (p, q) = (a.get(i).copied().unwrap_or(zero), b.get(i).copied().unwrap_or(zero));
                        graph.binary(op, p, q)
                    })
                    .collect(),
                Op::Mul if a.len() + b.len() - 2 <= highest => convolve(graph, a, b).into(),
                Op::Div if b.len() == 1 => a.iter().map(|&c| graph.div(c, b[0])).collect(),
                _ => return Some(None),
            }
        }
    };
    Some(Some(found))
}

fn convolve(graph: &mut Graph, a: &[Expr], b: &[Expr]) -> Vec<Expr> {
    let mut out = vec![graph.integer(0); a.len() + b.len() - 1];
    for (i, &p) in a.iter().enumerate() {
        for (j, &q) in b.iter().enumerate() {
            let term = graph.mul_structural(p, q);
            out[i + j] = graph.add(out[i + j], term);
        }
    }
    out
}

/// The product of bases with exponents.
pub(super) fn product(graph: &mut Graph, q: &Rational, parts: &[(Expr, i32)]) -> Expr {
    let mut out = graph.constant(q.clone());
    for &(base, k) in parts {
        let power = graph.powi(base, k);
        out = graph.mul(out, power);
    }
    out
}
