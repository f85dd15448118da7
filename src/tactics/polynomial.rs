//! Polynomials in one node, with coefficients on the graph.
//!
//! **In:** an expression and a node. **Out:** the coefficients of its powers; whether the highest one is a number, so that the checker can divide by it.

use crate::fraction::fraction;
use expr::{Expr, Graph, Node, Op};
use std::collections::BTreeMap;

/// Highest degree that is looked at.
const HIGHEST: usize = 24;

/// The coefficients of the powers of a node, from the lowest; nothing if it stands below a function or in a denominator.
fn coefficients(graph: &mut Graph, e: Expr, v: Expr) -> Option<Vec<Expr>> {
    let (zero, one) = (graph.integer(0), graph.integer(1));
    let mut image: BTreeMap<Expr, Vec<Expr>> = BTreeMap::new();
    for node in graph.reachable([e]) {
        let of = |a: Expr| image.get(&a).cloned().unwrap_or_default();
        let new = match *graph.node(node) {
            _ if node == v => vec![zero, one],
            Node::Constant(_) | Node::Pi | Node::Leaf(_) => vec![node],
            Node::Unary(op, a) if of(a).len() > 1 => unary(graph, op, &of(a))?,
            Node::Binary(op, a, b) if of(a).len() > 1 || of(b).len() > 1 => binary(graph, op, &of(a), (&of(b), b))?,
            Node::Unary(..) | Node::Binary(..) => vec![node],
        };
        image.insert(node, new);
    }
    image.remove(&e)
}

fn unary(graph: &mut Graph, op: Op, a: &[Expr]) -> Option<Vec<Expr>> {
    if op == Op::Neg {
        return Some(a.iter().map(|&c| graph.neg(c)).collect());
    }
    let Op::Powi(n @ 1..) = op else { return None };
    let mut power = vec![graph.integer(1)];
    for _ in 0..n {
        power = product(graph, &power, a)?;
    }
    Some(power)
}

fn binary(graph: &mut Graph, op: Op, a: &[Expr], (b, divisor): (&[Expr], Expr)) -> Option<Vec<Expr>> {
    if [Op::Add, Op::Sub].contains(&op) {
        return Some(sum(graph, a, b, op));
    }
    if op == Op::Mul {
        return product(graph, a, b);
    }
    let divides = op == Op::Div && b.len() == 1;
    divides.then(|| a.iter().map(|&c| graph.div(c, divisor)).collect())
}

fn sum(graph: &mut Graph, p: &[Expr], q: &[Expr], op: Op) -> Vec<Expr> {
    let zero = graph.integer(0);
    let mut out = Vec::new();
    for i in 0..p.len().max(q.len()) {
        let [x, y] = [p, q].map(|list| list.get(i).copied().unwrap_or(zero));
        out.push(graph.binary(op, x, y));
    }
    out
}

fn product(graph: &mut Graph, p: &[Expr], q: &[Expr]) -> Option<Vec<Expr>> {
    let length = (p.len() + q.len()).checked_sub(1).filter(|n| *n <= HIGHEST + 1)?;
    let mut out = vec![graph.integer(0); length];
    for (i, &x) in p.iter().enumerate() {
        for (j, &y) in q.iter().enumerate() {
            let term = graph.mul(x, y);
            out[i + j] = graph.add(out[i + j], term);
        }
    }
    Some(out)
}

/// Whether the numerator of an expression begins with a number times a power of a node.
pub(crate) fn leads(graph: &mut Graph, e: Expr, v: Expr) -> bool {
    let Some(quotient) = fraction(graph, e) else { return false };
    let Some(all) = coefficients(graph, quotient.numerator, v) else { return false };
    all.len() > 1 && all.last().is_some_and(|&lead| graph.as_constant(lead).is_some() && !graph.is_zero(lead))
}
