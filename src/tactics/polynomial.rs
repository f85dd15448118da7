//! Polynomials in one node, with coefficients on the graph: division by an equation of a higher degree.
//!
//! **In:** an expression e, a node v and an expression p whose highest power of v has a factor that does not vanish. **Out:** a quotient q and a rest of lower
//! degree with e = q·p + rest. **Used for:** sin² + cos² = 1, (√u)² = u, and constraints such as x² + y² = ℓ².

use expr::{Expr, Graph, Node, Op};
use std::collections::BTreeMap;

/// Highest degree that is divided.
const HIGHEST: usize = 24;

/// The coefficients of the powers of a node, from the lowest; nothing if it stands below a function or in a denominator.
pub(crate) fn coefficients(graph: &mut Graph, e: Expr, v: Expr) -> Option<Vec<Expr>> {
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

/// A quotient and a rest.
pub(crate) struct Division {
    pub(crate) quotient: Expr,
    pub(crate) rest: Expr,
}

/// Divides e by p, as polynomials in v; nothing if there is nothing to divide, or the leading coefficient of p is no number.
pub(crate) fn divide(graph: &mut Graph, e: Expr, p: Expr, v: Expr) -> Option<Division> {
    let divisor = coefficients(graph, p, v)?;
    let mut rest = coefficients(graph, e, v)?;
    let (lead, degree) = (*divisor.last()?, divisor.len() - 1);
    if degree == 0 || rest.len() <= degree || graph.as_constant(lead).is_none_or(|_| graph.is_zero(lead)) {
        return None;
    }
    let mut quotient = graph.integer(0);
    while rest.len() > degree {
        let top = rest.len() - 1;
        let factor = graph.div(rest[top], lead);
        let power = graph.powi(v, (top - degree) as i32);
        let term = graph.mul(factor, power);
        quotient = graph.add(quotient, term);
        for (i, &c) in divisor.iter().enumerate().take(degree) {
            let at = top - degree + i;
            let taken = graph.mul(factor, c);
            rest[at] = graph.sub(rest[at], taken);
        }
        rest.pop();
    }
    let mut sum = graph.integer(0);
    for (i, &c) in rest.iter().enumerate() {
        let power = graph.powi(v, i as i32);
        let term = graph.mul(c, power);
        sum = graph.add(sum, term);
    }
    Some(Division { quotient, rest: sum })
}
