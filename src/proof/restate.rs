//! Conditions as briefly as they are meant.
//!
//! **In:** a condition as it arose. **Out:** conditions that together say the same wherever all of them are listed: a product
//! is not 0 where no factor is, a quotient is not negative where the product is not; what is known is left out, and short
//! polynomials are expanded.

use super::generators::Generators;
use super::linear::{Combination, Combinations, Monomial, expression, multiplied, put, to_power};
use super::outcome::Condition;
use super::polynomial::{factors, fraction};
use super::sign::Facts;
use expr::{Expr, Graph, Node, Op, Rational};

/// Polynomials with more terms stay as they are.
const MOST_TERMS: usize = 24;
/// Expressions with more nodes stay as they are.
const MOST_NODES: usize = 160;

/// The condition in parts.
pub(super) fn restated(
    graph: &mut Graph,
    generators: &Generators,
    facts: &Facts,
    condition: Condition,
) -> Vec<Condition> {
    let mut parts = |e: Expr| -> (Rational, Vec<(Expr, i32)>) { simple_factors(graph, e) };
    match condition {
        Condition::Denominator(e) | Condition::Pivot(e) | Condition::Rate(e) => {
            let same = |e: Expr| match condition {
                Condition::Pivot(_) => Condition::Pivot(e),
                Condition::Rate(_) => Condition::Rate(e),
                _ => Condition::Denominator(e),
            };
            let (q, factors) = parts(e);
            if q == Rational::ZERO {
                return vec![condition];
            }
            // What a denominator of the expression is, is a condition of its own.
            let bases = factors.into_iter().filter(|&(_, k)| k > 0).map(|(base, _)| base);
            bases.filter(|&base| !facts.sign(graph, generators, base).nonzero).map(same).collect()
        }
        Condition::Radicand(e) | Condition::Discriminant(e) => {
            let (q, factors) = parts(e);
            let mut negative = q < Rational::ZERO;
            let mut rest: Option<Expr> = None;
            for (base, k) in factors {
                let known = facts.sign(graph, generators, base);
                if k % 2 == 0 || known.not_negative {
                    continue;
                }
                if known.not_positive {
                    negative = !negative;
                    continue;
                }
                // b − a for −(a − b).
                let mut base = base;
                if negative && let Node::Binary(Op::Sub, a, b) = *graph.node(base) {
                    base = graph.sub(b, a);
                    negative = false;
                }
                rest = Some(rest.map_or(base, |r| graph.mul(r, base)));
            }
            let e = match rest {
                None if negative || q == Rational::ZERO => return vec![condition],
                None => return Vec::new(),
                Some(rest) if negative => graph.neg(rest),
                Some(rest) => rest,
            };
            vec![if matches!(condition, Condition::Radicand(_)) {
                Condition::Radicand(e)
            } else {
                Condition::Discriminant(e)
            }]
        }
        // |√u| ≤ 1
        Condition::Unit(e) => match *graph.node(e) {
            Node::Unary(Op::Sqrt, u) => {
                let one = graph.integer(1);
                let rest = graph.sub(one, u);
                restated(graph, generators, facts, Condition::Radicand(rest))
            }
            _ => vec![condition],
        },
        Condition::Positive(_) => vec![condition],
    }
}

/// e = q·∏ baseᵏ, the bases expanded and without common monomials where that is short.
fn simple_factors(graph: &mut Graph, e: Expr) -> (Rational, Vec<(Expr, i32)>) {
    if graph.reachable([e]).len() > MOST_NODES {
        return (Rational::ONE, vec![(e, 1)]);
    }
    let (top, under) = fraction(graph, e);
    let (mut q, mut out) = (Rational::ONE, Vec::new());
    for (part, sign) in [(top, 1), (under, -1)] {
        if graph.is_zero(part) {
            return (Rational::ZERO, Vec::new());
        }
        let (factor, bases) = factors(graph, part);
        if factor < Rational::ZERO {
            q = -q;
        }
        for (base, k) in bases {
            let k = k * sign;
            // Exponents that would be too large are left as they are.
            match *graph.node(base) {
                // Neither vanishes but where its argument does; and both are not negative.
                Node::Unary(Op::Sqrt | Op::Abs, a) => {
                    let (_, parts) = without_content(graph, a);
                    let parts = multiplied(k, 2).and_then(|twice| to_power(&parts, twice));
                    parts.unwrap_or_else(|| vec![(base, k)]).into_iter().for_each(|(b, n)| put(&mut out, b, n));
                }
                _ => {
                    let (sign, parts) = without_content(graph, base);
                    let Some(parts) = to_power(&parts, k) else {
                        put(&mut out, base, k);
                        continue;
                    };
                    if sign && k % 2 != 0 {
                        q = -q;
                    }
                    parts.into_iter().for_each(|(b, n)| put(&mut out, b, n));
                }
            }
        }
    }
    (q, out)
}

/// A sum as monomial times the rest, up to a positive number; whether a factor −1 is left out.
fn without_content(graph: &mut Graph, base: Expr) -> (bool, Vec<(Expr, i32)>) {
    let whole = (false, vec![(base, 1)]);
    if !matches!(graph.node(base), Node::Binary(Op::Add | Op::Sub, ..)) {
        return whole;
    }
    let all: Combination = Combinations::default().of(graph, base);
    let (Some((first, _)), true) = (all.iter().next(), all.len() <= MOST_TERMS) else { return whole };
    let mut content: Monomial = first.clone();
    for m in all.keys() {
        for (b, power) in &mut content {
            *power = (*power).min(m.iter().find(|(other, _)| other == b).map_or(0, |&(_, n)| n));
        }
    }
    content.retain(|&(_, power)| power > 0);
    let reduce = |m: &Monomial| -> Monomial {
        let less = |&(b, n): &(Expr, i32)| (b, n - content.iter().find(|(c, _)| *c == b).map_or(0, |&(_, k)| k));
        m.iter().map(less).filter(|&(_, n)| n != 0).collect()
    };
    // Positive terms first; a sum of negative ones only is turned over.
    let mut terms: Vec<(Monomial, Rational)> = all.iter().map(|(m, q)| (reduce(m), q.clone())).collect();
    let scale = terms.iter().map(|(_, q)| if *q < Rational::ZERO { -q.clone() } else { q.clone() }).min();
    let scale = scale.unwrap_or(Rational::ONE);
    let turned = terms.iter().all(|(_, q)| *q < Rational::ZERO);
    for (_, q) in &mut terms {
        *q = &*q / &scale;
        if turned {
            *q = -q.clone();
        }
    }
    terms.sort_by_key(|(_, q)| *q < Rational::ZERO);
    let rest = match square_of_circle(graph, &terms) {
        Some(part) => (part, 2),
        None => {
            let mut sum: Option<Expr> = None;
            for (m, q) in &terms {
                let magnitude = if *q < Rational::ZERO { -q.clone() } else { q.clone() };
                let term = expression(graph, m, &magnitude);
                sum = Some(match sum {
                    None => term,
                    Some(s) if *q < Rational::ZERO => graph.sub(s, term),
                    Some(s) => graph.add(s, term),
                });
            }
            (sum.unwrap_or(base), 1)
        }
    };
    let mut out: Vec<(Expr, i32)> = content;
    if terms.len() > 1 || !terms.iter().all(|(m, _)| m.is_empty()) {
        out.push(rest);
    }
    (turned, out)
}

/// sin a for 1 − cos²a, and the other way round.
fn square_of_circle(graph: &mut Graph, terms: &[(Monomial, Rational)]) -> Option<Expr> {
    let [(one, q), (square, r)] = terms else { return None };
    let &[(base, 2)] = square.as_slice() else { return None };
    if !one.is_empty() || *q != -r.clone() {
        return None;
    }
    match *graph.node(base) {
        Node::Unary(Op::Cos, a) => Some(graph.unary(Op::Sin, a)),
        Node::Unary(Op::Sin, a) => Some(graph.unary(Op::Cos, a)),
        _ => None,
    }
}
