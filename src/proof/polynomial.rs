//! Lowered expressions as fractions, products and polynomials in one leaf, without expanding the rest.

use super::linear::{Combinations, Monomial, expression, multiplied, put, times, to_power};
use super::structure::Powers;
use expr::FastMap;
use expr::{Expr, Graph, Node, Op, Rational};
use std::collections::BTreeMap;

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
                match k.checked_abs() {
                    Some(k) => (graph.powi(n, k), graph.powi(d, k)),
                    None => (node, one),
                }
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
            Node::Unary(Op::Powi(n), a) if multiplied(*n, k).is_some_and(|m| m != 0) => stack.push((*a, n * k)),
            Node::Binary(Op::Mul, a, b) => stack.extend([(*a, k), (*b, k)]),
            Node::Binary(Op::Div, a, b) => stack.extend([(*a, k), (*b, -k)]),
            _ => put(&mut out, e, k),
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

/// Sums among the factors written as a monomial times a polynomial without monomial factor, the same for all multiples:
/// the sign of a·x² + b·x² is that of a + b.
///
/// Even powers of sums, which have one sign, are left as they are unless `even`.
pub(super) fn without_content(
    graph: &mut Graph,
    q: Rational,
    parts: Vec<(Expr, i32)>,
    even: bool,
) -> (Rational, Vec<(Expr, i32)>) {
    let (mut q, mut out): (Rational, Vec<(Expr, i32)>) = (q, Vec::new());
    let mut put = |base: Expr, k: i32| put(&mut out, base, k);
    for (base, k) in parts {
        let sum = matches!(graph.node(base), Node::Binary(Op::Add | Op::Sub, ..));
        if !sum || k % 2 == 0 && !even || k.unsigned_abs() > 64 {
            put(base, k);
            continue;
        }
        let (top, under) = fraction(graph, base);
        for (polynomial, k) in [(top, k), (under, -k)] {
            let all = Combinations::default().of(graph, polynomial);
            let Some((first, lead)) = all.iter().next().map(|(m, q)| (m.clone(), q.clone())) else {
                // It vanishes identically.
                put(polynomial, k);
                continue;
            };
            let Some(scale) = expr::raised(&lead, k) else {
                put(polynomial, k);
                continue;
            };
            let mut content = first;
            for m in all.keys() {
                for (base, power) in &mut content {
                    *power = (*power).min(m.iter().find(|(b, _)| b == base).map_or(0, |&(_, n)| n));
                }
            }
            content.retain(|&(_, power)| power != 0);
            let inverse: Monomial = content.iter().map(|&(base, power)| (base, -power)).collect();
            let outside = to_power(&content, k);
            let inside: Option<Vec<Monomial>> = all.keys().map(|m| times(m, &inverse)).collect();
            let (Some(outside), Some(inside)) = (outside, inside) else {
                put(polynomial, k);
                continue;
            };
            q *= scale;
            outside.into_iter().for_each(|(base, power)| put(base, power));
            if all.len() == 1 {
                continue;
            }
            let mut rest = graph.integer(0);
            for (m, coefficient) in inside.iter().zip(all.values()) {
                let term = expression(graph, m, &(coefficient / &lead));
                rest = graph.add(rest, term);
            }
            put(rest, k);
        }
    }
    out.retain(|&(_, k)| k != 0);
    (q, out)
}

/// The factors of an expression, sums brought to a form that is the same for all multiples.
pub(super) fn primitive(graph: &mut Graph, e: Expr) -> (Rational, Vec<(Expr, i32)>) {
    let (q, parts) = factors(graph, e);
    without_content(graph, q, parts, true)
}

/// The polynomial in its own order: sums and products multiplied out.
pub(super) fn flat(graph: &mut Graph, e: Expr) -> Expr {
    let all = Combinations::default().of(graph, e);
    let mut out = graph.integer(0);
    for (m, q) in &all {
        let term = expression(graph, m, q);
        out = graph.add(out, term);
    }
    out
}

/// Whether an expression is 0 once it is multiplied out.
pub(super) fn is_nothing(graph: &mut Graph, e: Expr) -> bool {
    let (top, _) = fraction(graph, e);
    Combinations::default().of(graph, top).is_empty()
}

/// The expression with one of the nodes below it replaced.
pub(super) fn replaced(graph: &mut Graph, e: Expr, node: Expr, value: Expr) -> Expr {
    let mut image: FastMap<Expr, Expr> = FastMap::default();
    for n in graph.reachable([e]) {
        let at = |e: Expr| image.get(&e).copied().unwrap_or(e);
        let new = match *graph.node(n) {
            _ if n == node => value,
            Node::Constant(_) | Node::Pi | Node::Leaf(_) => n,
            Node::Unary(op, a) => graph.unary(op, at(a)),
            Node::Binary(op, a, b) => graph.binary(op, at(a), at(b)),
        };
        image.insert(n, new);
    }
    image.get(&e).copied().unwrap_or(e)
}

/// The root of a whole number, if it is one.
pub(super) fn whole_root(n: &Rational) -> Option<Rational> {
    use dashu_int::ops::SquareRoot;
    if *n < Rational::ZERO || !n.is_int() {
        return None;
    }
    let root = n.numerator().clone().into_parts().1.sqrt();
    let root = Rational::from(root);
    (&root * &root == *n).then_some(root)
}

/// (m, q) with e = q·m², m a fraction of polynomials with rational coefficients and q > 0: exact, by the leading terms in the
/// order of exponents.
pub(super) fn polynomial_root(graph: &mut Graph, e: Expr) -> Option<(Expr, Rational)> {
    let (top, under) = fraction(graph, e);
    if let (Some((a, p)), Some((b, q))) = (root_of_polynomial(graph, top), root_of_polynomial(graph, under)) {
        return Some((graph.div(a, b), p / q));
    }
    // N/D = N·D/D².
    let product = graph.mul(top, under);
    let (m, q) = root_of_polynomial(graph, product)?;
    Some((graph.div(m, under), q))
}

fn root_of_polynomial(graph: &mut Graph, e: Expr) -> Option<(Expr, Rational)> {
    let all = Combinations::default().of(graph, e);
    let mut variables: Vec<Expr> = all.keys().flatten().map(|&(base, _)| base).collect();
    variables.sort_unstable();
    variables.dedup();
    let vector = |m: &Monomial| -> Vec<i32> {
        variables.iter().map(|v| m.iter().find(|(b, _)| b == v).map_or(0, |&(_, k)| k)).collect()
    };
    let mut left: BTreeMap<Vec<i32>, Rational> = all.iter().map(|(m, q)| (vector(m), q.clone())).collect();
    let (lead, q) = left.last_key_value().map(|(m, q)| (m.clone(), q.clone()))?;
    if q <= Rational::ZERO || lead.iter().any(|k| k % 2 != 0) {
        return None;
    }
    // With leading coefficient 1: p = q·m².
    left.values_mut().for_each(|c| *c /= &q);
    let half: Vec<i32> = lead.iter().map(|k| k / 2).collect();
    let mut root: BTreeMap<Vec<i32>, Rational> = BTreeMap::from([(half.clone(), Rational::ONE)]);
    left.remove(&lead);
    let sum = |a: &[i32], b: &[i32]| -> Vec<i32> { a.iter().zip(b).map(|(x, y)| x + y).collect() };
    for _ in 0..all.len() {
        let Some((m, c)) = left.last_key_value().map(|(m, c)| (m.clone(), c.clone())) else { break };
        let next: Vec<i32> = m.iter().zip(&half).map(|(x, y)| x - y).collect();
        let coefficient = c / Rational::from(2);
        if root.contains_key(&next) || root.first_key_value().is_none_or(|(least, _)| next > *least) {
            return None;
        }
        // (r + t)² = r² + 2rt + t².
        let mut subtract = |m: Vec<i32>, c: Rational| {
            let old = left.remove(&m).unwrap_or(Rational::ZERO);
            let new = old - c;
            if new != Rational::ZERO {
                left.insert(m, new);
            }
        };
        for (r, q) in &root {
            subtract(sum(r, &next), Rational::from(2) * q * &coefficient);
        }
        subtract(sum(&next, &next), &coefficient * &coefficient);
        root.insert(next, coefficient);
    }
    if !left.is_empty() {
        return None;
    }
    let mut m = graph.integer(0);
    for (exponents, c) in &root {
        let monomial: Monomial =
            variables.iter().zip(exponents).filter(|(_, k)| **k != 0).map(|(&v, &k)| (v, k)).collect();
        let term = expression(graph, &monomial, c);
        m = graph.add(m, term);
    }
    Some((m, q))
}
