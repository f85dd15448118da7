//! What a proof needs that was not given: denominators, radicands, pivots.

use super::generators::{Generator, Generators};
use super::outcome::{Condition, Premises};
use super::polynomial::factors;
use super::prove::Lowered;
use super::restate::restated;
use super::sign::Facts;
use super::solve::{Resolved, unmarked};
use expr::domain::{Need, Sign, Term};
use expr::{Expr, Graph, Node, Op, Rational};
use expr::{FastMap, FastSet};

/// Radicands, denominators … of the operations of some formulas, see [`Condition`].
pub fn domains(graph: &mut Graph, exprs: &[Expr]) -> Vec<Condition> {
    let condition = |need: Need| match (need.term, need.sign) {
        // The rate of √x at x = 0, of |x| at 0: there may be one.
        (_, Sign::NotZero | Sign::Positive) if !need.certain => Condition::Rate(need.value),
        // Powers are shown to be what they are for positive bases, whatever the exponent.
        (Term::Support, _) => Condition::Positive(need.first),
        (Term::First, Sign::NotNegative) if need.op == Op::Pow => Condition::Positive(need.first),
        (Term::Unit, _) => Condition::Unit(need.first),
        (_, Sign::Positive) => Condition::Positive(need.value),
        (_, Sign::NotNegative) => Condition::Radicand(need.value),
        (_, Sign::NotZero) => Condition::Denominator(need.value),
    };
    let angles = graph.angles_with_rates(exprs.iter().copied());
    let open = |need: &Need| need.certain || need.op != Op::Tan || !angles.contains(&need.first);
    let needs = graph.needs_below(exprs.iter().copied()).into_iter().filter(open);
    let mut out: Vec<Condition> = needs.map(condition).collect();
    out.dedup();
    out
}

/// (σ√d)² written as d.
fn without_signs(graph: &mut Graph, generators: &Generators, e: Expr) -> Expr {
    let mut image: FastMap<Expr, Expr> = FastMap::default();
    for node in graph.reachable([e]) {
        let mut new = match *graph.node(node) {
            Node::Unary(op, a) => graph.unary(op, image[&a]),
            Node::Binary(op, a, b) => graph.binary(op, image[&a], image[&b]),
            _ => node,
        };
        if let Node::Unary(Op::Powi(2), a) = *graph.node(new)
            && let Node::Binary(Op::Mul, p, q) = *graph.node(a)
        {
            for root in [p, q] {
                if let Node::Unary(Op::Sqrt, radicand) = *graph.node(root)
                    && let Some(plain) = unmarked(graph, generators, radicand)
                {
                    new = plain;
                }
            }
        }
        image.insert(node, new);
    }
    image[&e]
}

/// A lowered expression in terms of the formulas as given; numbers that were made up on the way stay.
pub(super) fn raised(graph: &mut Graph, generators: &Generators, e: Expr) -> Expr {
    let e = without_signs(graph, generators, e);
    graph.replaced(e, |graph, leaf| {
        Some(match *generators.get(leaf)? {
            Generator::Cosine(a) => graph.unary(Op::Cos, a),
            Generator::Sine(a) => graph.unary(Op::Sin, a),
            Generator::Exponential(a) => graph.unary(Op::Exp, a),
            Generator::Opaque(e) => e,
            Generator::Sign | Generator::Half | Generator::Free => return None,
        })
    })
}

/// Bases of powers in premises that may be 0. A power is e^{b ln a} here, which is never 0, while 0^b is: what follows from a
/// premise by that leaves a = 0 out. (In what is claimed, both sides are continuous there.)
fn bases(graph: &mut Graph, given: &Premises, formulas: &[Expr]) -> Vec<Expr> {
    let falls = |b: Expr| graph.as_constant(b).is_some_and(|b| *b < Rational::ZERO);
    let mut out: Vec<Expr> = Vec::new();
    for e in graph.reachable(given.sides()) {
        match *graph.node(e) {
            Node::Binary(Op::Pow, a, b) if !falls(b) => out.push(a),
            Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {}
        }
    }
    // What a logarithm, or a divisor, needs anyway.
    let needed = graph.implied_below(formulas.iter().copied());
    let needed = |a: Expr| needed.iter().any(|n| n.op != Op::Pow && n.value == a && n.sign != Sign::NotNegative);
    out.retain(|&a| !needed(a));
    out
}

/// Whether something is not 0 where formulas have values, by their own conditions: x where they divide by |x|.
fn is_needed(graph: &Graph, own: &[Condition], e: Expr) -> bool {
    own.iter().any(|c| match *c {
        Condition::Denominator(d) | Condition::Positive(d) => graph.root_of_zeros(d) == graph.root_of_zeros(e),
        Condition::Pivot(_) | Condition::Rate(_) | Condition::Radicand(_) | Condition::Discriminant(_) => false,
        Condition::Unit(_) => false,
    })
}

/// Conditions that are not among the facts, in words of the formulas as given.
pub(super) fn conditions(
    graph: &mut Graph,
    lowered: &Lowered,
    given: &Premises,
    cases: &[Resolved],
    formulas: &[Expr],
    explicit: &[Expr],
    (pivots, rates): (&[Expr], &[Expr]),
) -> Vec<Condition> {
    let generators = &lowered.generators;
    let mut out = domains(graph, formulas);
    out.extend(rates.iter().map(|&e| Condition::Rate(e)));
    let mut from_cases: Vec<Condition> = pivots.iter().map(|&e| Condition::Pivot(e)).collect();
    // Of several cases none restricts the premises.
    let possible: Vec<&Resolved> = cases.iter().filter(|c| !c.empty).collect();
    for case in possible.iter().filter(|_| possible.len() == 1) {
        from_cases.extend(case.radicands.iter().map(|&e| Condition::Discriminant(e)));
    }
    let unknown = |graph: &Graph, c: &Condition| match *c {
        Condition::Pivot(e) => !lowered.facts.sign(graph, generators, e).nonzero,
        Condition::Discriminant(e) => !lowered.facts.sign(graph, generators, e).not_negative,
        _ => true,
    };
    from_cases.retain(|c| unknown(graph, c));
    for c in from_cases {
        out.push(match c {
            Condition::Pivot(e) => Condition::Pivot(raised(graph, generators, e)),
            Condition::Discriminant(e) => Condition::Discriminant(raised(graph, generators, e)),
            other => other,
        });
    }
    out.extend(explicit.iter().map(|&e| Condition::Pivot(e)));
    out.extend(bases(graph, given, formulas).into_iter().map(Condition::Pivot));
    // Declared facts need no mention.
    let mut facts = Facts::default();
    given.positive.iter().for_each(|&e| facts.note_positive(graph, e));
    given.not_negative.iter().for_each(|&e| facts.note_not_negative(graph, e));
    for &e in &given.nonzero {
        facts.nonzero.insert(e);
        facts.nonzero.extend(factors(graph, e).1.into_iter().map(|(base, _)| base));
    }
    let mut out: Vec<Condition> = out.into_iter().flat_map(|c| restated(graph, generators, &facts, c)).collect();
    // What a formula needs anyway need not be said of the proof.
    let own: Vec<Condition> = out.clone();
    // Where a rate has no value is said once.
    let told: Vec<Expr> = rates.to_vec();
    let mut seen = FastSet::default();
    out.retain(|c| {
        let known = match *c {
            Condition::Pivot(e) => {
                own.contains(&Condition::Denominator(e))
                    || told.contains(&e)
                    || facts.sign(graph, generators, e).nonzero
            }
            Condition::Denominator(e) => facts.sign(graph, generators, e).nonzero,
            Condition::Rate(e) => is_needed(graph, &own, e) || facts.sign(graph, generators, e).nonzero,
            Condition::Discriminant(e) if own.contains(&Condition::Radicand(e)) => true,
            Condition::Radicand(e) | Condition::Discriminant(e) => facts.sign(graph, generators, e).not_negative,
            Condition::Positive(e) => {
                let k = facts.sign(graph, generators, e);
                k.nonzero && k.not_negative
            }
            Condition::Unit(_) => false,
        };
        !known && seen.insert(*c)
    });
    out
}
