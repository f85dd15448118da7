//! Equations between what is not negative, as equations between squares.
//!
//! **In:** equations and premises. **Out:** the equations with both sides squared, where neither side of any is negative; `None` where
//! that is not known, or where there is no root. **Guaranteed:** numbers that are not negative are equal exactly where
//! their squares are.
//!
//! A side is not negative as a root, a size, a power or an exponential, as a product or quotient of such, by what is given of it, or
//! as 1 + uv/cd where |u| < c and |v| < d are given: then cd ± uv is positive.

use super::linear::{Combination, Combinations};
use super::outcome::Premises;
use super::polynomial::fraction;
use expr::{Expr, Graph, Node, Op, Rational};

type Pairs = Vec<(Expr, Expr)>;

/// Bounds of sizes that are multiplied with each other.
const MOST_SIZES: usize = 4;

/// The equations between the squares.
pub(super) fn squared(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises) -> Option<Pairs> {
    let is_rooted = |graph: &Graph, e: Expr| {
        graph
            .reachable([e])
            .iter()
            .any(|&e| matches!(graph.node(e), Node::Unary(Op::Sqrt | Op::Abs, _) | Node::Binary(Op::Pow, ..)))
    };
    let is_square = |graph: &Graph, e: Expr| matches!(graph.node(e), Node::Unary(Op::Powi(2), _));
    let sides: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
    if !sides.iter().any(|&e| is_rooted(graph, e)) || sides.iter().all(|&e| is_square(graph, e)) {
        return None;
    }
    let mut known: Vec<Expr> = given.positive.iter().chain(&given.not_negative).copied().collect();
    known.extend(products_of_sizes(graph, given));
    let known: Vec<Combination> = known.into_iter().map(|e| Combinations::default().of(graph, e)).collect();
    let mut out = Pairs::new();
    for &(l, r) in equations {
        if !is_not_negative(graph, &known, l) || !is_not_negative(graph, &known, r) {
            return None;
        }
        out.push((graph.powi(l, 2), graph.powi(r, 2)));
    }
    Some(out)
}

/// cd + uv and cd − uv, where |u| < c and |v| < d.
fn products_of_sizes(graph: &mut Graph, given: &Premises) -> Vec<Expr> {
    let facts = given.positive.iter().chain(&given.not_negative);
    let size = |&e: &Expr| match *graph.node(e) {
        Node::Binary(Op::Sub, c, size) => match *graph.node(size) {
            Node::Unary(Op::Abs, u) => Some((u, c)),
            Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => None,
        },
        Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => None,
    };
    let sizes: Vec<(Expr, Expr)> = facts.filter_map(size).take(MOST_SIZES).collect();
    let mut out = Vec::new();
    for (i, &(u, c)) in sizes.iter().enumerate() {
        for &(v, d) in &sizes[i..] {
            let (bound, product) = (graph.mul(c, d), graph.mul(u, v));
            out.extend([graph.add(bound, product), graph.sub(bound, product)]);
        }
    }
    out
}

/// Whether an expression is not negative wherever it has a value; `known` are sums that are not.
fn is_not_negative(graph: &mut Graph, known: &[Combination], e: Expr) -> bool {
    match graph.node(e).clone() {
        Node::Constant(q) if *q >= Rational::ZERO => return true,
        Node::Pi | Node::Unary(Op::Sqrt | Op::Abs | Op::Exp | Op::Cosh, _) | Node::Binary(Op::Pow, ..) => return true,
        Node::Unary(Op::Powi(n), a) if n % 2 == 0 || is_not_negative(graph, known, a) => return true,
        Node::Binary(Op::Mul | Op::Div, a, b)
            if is_not_negative(graph, known, a) && is_not_negative(graph, known, b) =>
        {
            return true;
        }
        Node::Constant(_) | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {}
    }
    let (top, under) = fraction(graph, e);
    if top != e && graph.as_constant(under).is_none() {
        return is_not_negative(graph, known, under) && is_not_negative(graph, known, top);
    }
    let sum = Combinations::default().of(graph, e);
    known.iter().any(|fact| is_multiple(&sum, fact))
}

/// Whether a sum is another times a positive number.
fn is_multiple(sum: &Combination, fact: &Combination) -> bool {
    let (Some((m, p)), true) = (sum.iter().next(), sum.len() == fact.len()) else { return false };
    let Some(factor) = fact.get(m).map(|q| p / q).filter(|f| *f > Rational::ZERO) else { return false };
    sum.iter().all(|(m, q)| fact.get(m).is_some_and(|r| *q == &factor * r))
}
