//! Fractions: an expression as a numerator over factors with powers.
//!
//! **In:** an expression. **Out:** n and d with e = n/d wherever e has a value, without a quotient left in n outside of functions. **Why factors:**
//! sums of fractions take the highest power of each factor, so that r⁻³ + r⁻¹ has r³ below and not r⁴.

use expr::{Expr, Graph, Node, Op};
use std::collections::BTreeMap;

/// Largest power of a factor.
const LARGEST_POWER: u32 = 40;

/// A fraction.
#[derive(Clone, Debug)]
pub(crate) struct Fraction {
    pub(crate) numerator: Expr,
    /// Factors of the denominator, and their powers.
    factors: BTreeMap<Expr, u32>,
}

impl Fraction {
    fn whole(e: Expr) -> Fraction {
        Fraction { numerator: e, factors: BTreeMap::new() }
    }

    /// The denominator.
    pub(crate) fn denominator(&self, graph: &mut Graph) -> Expr {
        product(graph, &self.factors)
    }

    /// Whether there is one.
    pub(crate) fn is_whole(&self) -> bool {
        self.factors.is_empty()
    }
}

fn product(graph: &mut Graph, factors: &BTreeMap<Expr, u32>) -> Expr {
    let mut out = graph.integer(1);
    for (&factor, &power) in factors {
        let term = graph.powi(factor, power as i32);
        out = graph.mul(out, term);
    }
    out
}

/// The factors of an expression that is divided by; numbers go into the numerator. What would have too large a power stays as it is.
fn split(graph: &mut Graph, e: Expr, power: u32, into: &mut BTreeMap<Expr, u32>, number: &mut Expr) {
    match *graph.node(e) {
        Node::Binary(Op::Mul, a, b) => {
            split(graph, a, power, into, number);
            split(graph, b, power, into, number);
        }
        Node::Unary(Op::Neg, a) => {
            if power % 2 == 1 {
                *number = graph.neg(*number);
            }
            split(graph, a, power, into, number);
        }
        Node::Unary(Op::Powi(n), a) if n > 0 && power.checked_mul(n as u32).is_some_and(|p| p <= LARGEST_POWER) => {
            split(graph, a, power * n as u32, into, number)
        }
        Node::Constant(_) => {
            let factor = graph.powi(e, power as i32);
            *number = graph.div(*number, factor);
        }
        Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {
            let known = into.entry(e).or_insert(0);
            *known = known.saturating_add(power);
        }
    }
}

/// e as a fraction; nothing where powers grow too large.
pub(crate) fn fraction(graph: &mut Graph, e: Expr) -> Option<Fraction> {
    let mut image: BTreeMap<Expr, Fraction> = BTreeMap::new();
    for node in graph.reachable([e]) {
        let of = |a: Expr| image.get(&a).cloned().unwrap_or_else(|| Fraction::whole(a));
        let new = match *graph.node(node) {
            Node::Binary(op @ (Op::Add | Op::Sub), a, b) => sum(graph, &of(a), &of(b), op),
            Node::Binary(Op::Mul, a, b) => times(graph, &of(a), &of(b)),
            Node::Binary(Op::Div, a, b) => {
                let inverse = inverse(graph, &of(b));
                times(graph, &of(a), &inverse)
            }
            // It has the value of its formula, where it has one.
            Node::Binary(Op::Restrict, a, _) => of(a),
            Node::Unary(Op::Neg, a) => {
                let of = of(a);
                Fraction { numerator: graph.neg(of.numerator), ..of }
            }
            Node::Unary(Op::Powi(n), a) if n != 0 => {
                let base = if n > 0 { of(a) } else { inverse(graph, &of(a)) };
                let n = n.unsigned_abs();
                Fraction {
                    numerator: graph.powi(base.numerator, n as i32),
                    factors: base.factors.into_iter().map(|(f, p)| (f, p.saturating_mul(n))).collect(),
                }
            }
            Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => Fraction::whole(node),
        };
        if new.factors.values().any(|p| *p > LARGEST_POWER) {
            return None;
        }
        image.insert(node, new);
    }
    image.remove(&e)
}

fn inverse(graph: &mut Graph, of: &Fraction) -> Fraction {
    let (mut factors, mut number) = (BTreeMap::new(), graph.integer(1));
    split(graph, of.numerator, 1, &mut factors, &mut number);
    let top = of.denominator(graph);
    Fraction { numerator: graph.mul(number, top), factors }
}

fn times(graph: &mut Graph, a: &Fraction, b: &Fraction) -> Fraction {
    let mut factors = a.factors.clone();
    for (&factor, &power) in &b.factors {
        *factors.entry(factor).or_insert(0) += power;
    }
    Fraction { numerator: graph.mul(a.numerator, b.numerator), factors }
}

fn sum(graph: &mut Graph, a: &Fraction, b: &Fraction, op: Op) -> Fraction {
    let mut factors = a.factors.clone();
    for (&factor, &power) in &b.factors {
        let known = factors.entry(factor).or_insert(0);
        *known = (*known).max(power);
    }
    let raised = |graph: &mut Graph, of: &Fraction| {
        let missing = factors.iter().map(|(&f, &p)| (f, p - of.factors.get(&f).copied().unwrap_or(0)));
        let missing: BTreeMap<Expr, u32> = missing.filter(|(_, p)| *p > 0).collect();
        let factor = product(graph, &missing);
        graph.mul(of.numerator, factor)
    };
    let (x, y) = (raised(graph, a), raised(graph, b));
    Fraction { numerator: graph.binary(op, x, y), factors }
}
