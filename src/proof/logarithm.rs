//! Logarithms and powers, taken apart by the factors of what they are of.
//!
//! **In:** the formulas of one problem. **Out:** the same formulas with ln(q·∏ bᵏ) written as ln|q| + Σ k·ln|b|, and powers
//! as exponentials of such sums.
//!
//! **Why |b|.** ln u has a value only where u > 0, and there ln u = ln|u| whatever the signs of the factors. So
//! no sign has to be known: the rule holds wherever the formula as written has a value, and the conditions under which it has
//! one are those of the formula as written. A factor bᵏ with k ≠ 0 is not 0 where u is not.
//!
//! **Names.** A factor is known by its polynomial up to a rational factor, so that x − 1 and 2 − 2x have one logarithm. It is
//! written as it stands where the logarithm of the factor itself occurs in the problem; otherwise as ln|b|.
//!
//! Constants are split into primes where several of them occur.

use super::linear::{Combinations, Monomial, expression};
use super::polynomial::{primitive, replaced};
use expr::{Expr, FastMap, FastSet, Graph, Node, Op, Rational};
use std::collections::BTreeMap;

/// Nested powers are looked through so far.
const DEEPEST: u32 = 6;
/// Factors of one logarithm.
const MOST_FACTORS: usize = 24;
/// Primes up to here are split off.
const LARGEST_PRIME: u32 = 1000;

/// ln u = Σ coefficient·ln|base| + Σ rest.
#[derive(Debug, Default)]
struct Sum {
    /// Logarithms of numbers.
    numbers: BTreeMap<Rational, Expr>,
    bases: Vec<(Expr, Expr)>,
    rest: Vec<Expr>,
}

/// The logarithms of one problem.
#[derive(Debug, Default)]
pub(super) struct Logarithms {
    /// Factors whose own logarithm occurs, by their polynomial.
    plain: FastMap<Expr, Expr>,
    /// What is declared to be positive.
    positive: FastSet<Expr>,
    /// Whether numbers are split into primes.
    split: bool,
    /// Whether there is anything to take apart.
    any: bool,
    /// For the monomials of exponents in arguments of logarithms, the common denominator of their coefficients.
    exponents: BTreeMap<Monomial, Rational>,
    image: FastMap<Expr, Expr>,
}

/// What a node takes the logarithm of.
fn logarithmic(graph: &Graph, node: Expr) -> Option<Expr> {
    match *graph.node(node) {
        Node::Unary(Op::Ln, a) | Node::Binary(Op::Pow, a, _) => Some(a),
        _ => None,
    }
}

/// The least common multiple of a whole number and of the denominator of another.
fn lcm(a: &Rational, b: &Rational) -> Rational {
    use dashu_int::ops::Gcd;
    let (a, b) = (a.numerator().clone().into_parts().1, b.denominator().clone());
    let g = (&a).gcd(&b);
    Rational::from(a / g * b)
}

impl Logarithms {
    /// Looks through all formulas of a problem.
    pub(super) fn of(graph: &mut Graph, roots: &[Expr], positive: &[Expr]) -> Logarithms {
        let mut out = Logarithms { positive: positive.iter().copied().collect(), ..Logarithms::default() };
        let nodes = graph.reachable(roots.iter().copied());
        let arguments: Vec<Expr> = nodes.into_iter().filter_map(|e| logarithmic(graph, e)).collect();
        out.any = !arguments.is_empty();
        for node in graph.reachable(arguments.iter().copied()) {
            let Node::Unary(Op::Exp, u) = *graph.node(node) else { continue };
            for (m, q) in Combinations::default().of(graph, u) {
                let n = out.exponents.entry(m).or_insert(Rational::ONE);
                *n = lcm(n, &q);
            }
        }
        let mut numbers = FastSet::default();
        for a in arguments {
            if let Some(q) = graph.as_constant(a) {
                numbers.insert(q.clone());
                continue;
            }
            let (q, parts) = out.factors(graph, a);
            if q != Rational::ONE && q != -Rational::ONE {
                numbers.insert(q);
            } else if let &[(base, 1)] = parts.as_slice() {
                // The factor itself, or its negative.
                out.plain.entry(base).or_insert(a);
            }
        }
        out.split = numbers.len() > 1;
        out
    }

    /// A formula with its logarithms taken apart.
    pub(super) fn put_into(&mut self, graph: &mut Graph, e: Expr) -> Expr {
        if !self.any {
            return e;
        }
        for node in graph.reachable([e]) {
            if self.image.contains_key(&node) {
                continue;
            }
            let at = |e: Expr| self.image.get(&e).copied().unwrap_or(e);
            let new = match *graph.node(node) {
                Node::Constant(_) | Node::Pi | Node::Leaf(_) => node,
                Node::Unary(Op::Ln, a) => self.logarithm(graph, a).unwrap_or(node),
                Node::Unary(Op::Exp, a) => self.exponential(graph, a),
                Node::Binary(Op::Pow, a, b) => {
                    let log = graph.unary(Op::Ln, a);
                    let argument = graph.mul(b, log);
                    self.exponential(graph, argument)
                }
                Node::Unary(op @ (Op::Sinh | Op::Cosh | Op::Tanh), a) if at(a) != a => self.hyperbolic(graph, op, a),
                Node::Unary(op, a) => graph.unary(op, at(a)),
                Node::Binary(op, a, b) => graph.binary(op, at(a), at(b)),
            };
            self.image.insert(node, new);
        }
        self.image.get(&e).copied().unwrap_or(e)
    }

    /// ln a; `None` where it is too long.
    fn logarithm(&mut self, graph: &mut Graph, a: Expr) -> Option<Expr> {
        let mut sum = Sum::default();
        let one = graph.integer(1);
        self.add(graph, a, one, 0, &mut sum)?;
        let mut out = graph.integer(0);
        for (q, coefficient) in sum.numbers {
            let number = graph.constant(q);
            let log = graph.unary(Op::Ln, number);
            let term = graph.mul(coefficient, log);
            out = graph.add(out, term);
        }
        for (base, coefficient) in sum.bases {
            let term = graph.mul(coefficient, base);
            out = graph.add(out, term);
        }
        for term in sum.rest {
            out = graph.add(out, term);
        }
        Some(out)
    }

    /// The factors of what a logarithm is of, as a polynomial in one exponential for each monomial of the exponents: 1 + e^{−x} is
    /// (e^x + 1)/e^x.
    fn factors(&self, graph: &mut Graph, a: Expr) -> (Rational, Vec<(Expr, i32)>) {
        let mut out = a;
        for node in graph.reachable([a]).into_iter().filter(|_| self.exponents.len() <= MOST_FACTORS) {
            let Node::Unary(Op::Exp, u) = *graph.node(node) else { continue };
            let mut power = graph.integer(1);
            for (m, q) in Combinations::default().of(graph, u) {
                let n = self.exponents.get(&m).cloned().unwrap_or(Rational::ONE);
                let Some(k) = i32::try_from(q * &n).ok().filter(|k| k.unsigned_abs() <= 64) else {
                    return primitive(graph, a);
                };
                let part = expression(graph, &m, &(Rational::ONE / &n));
                let part = graph.unary(Op::Exp, part);
                let part = graph.powi(part, k);
                power = graph.mul(power, part);
            }
            out = replaced(graph, out, node, power);
        }
        primitive(graph, out)
    }

    /// Adds times·ln|a| to a sum.
    fn add(&mut self, graph: &mut Graph, a: Expr, times: Expr, depth: u32, sum: &mut Sum) -> Option<()> {
        let (q, parts) = self.factors(graph, a);
        if q == Rational::ZERO || depth > DEEPEST || sum.bases.len() + parts.len() > MOST_FACTORS {
            return None;
        }
        self.add_number(graph, &q, times, sum);
        for (base, k) in parts {
            let k = graph.integer(i64::from(k));
            let times = graph.mul(times, k);
            match *graph.node(base) {
                Node::Unary(Op::Sqrt, inner) => {
                    let two = graph.integer(2);
                    let half = graph.div(times, two);
                    self.add(graph, inner, half, depth + 1, sum)?;
                }
                Node::Unary(Op::Abs, inner) => self.add(graph, inner, times, depth + 1, sum)?,
                Node::Unary(Op::Exp, y) => {
                    let y = self.put_into(graph, y);
                    sum.rest.push(graph.mul(times, y));
                }
                Node::Binary(Op::Pow, inner, exponent) => {
                    let exponent = self.put_into(graph, exponent);
                    let times = graph.mul(times, exponent);
                    self.add(graph, inner, times, depth + 1, sum)?;
                }
                _ => {
                    let log = self.name(graph, base);
                    match sum.bases.iter_mut().find(|(b, _)| *b == log) {
                        Some((_, all)) => *all = graph.add(*all, times),
                        None => sum.bases.push((log, times)),
                    }
                }
            }
        }
        Some(())
    }

    fn add_number(&self, graph: &mut Graph, q: &Rational, times: Expr, sum: &mut Sum) {
        let q = if *q < Rational::ZERO { -q.clone() } else { q.clone() };
        if q == Rational::ONE {
            return;
        }
        let parts = if self.split { primes(&q) } else { vec![(q, 1)] };
        for (p, k) in parts {
            let k = graph.integer(k);
            let term = graph.mul(times, k);
            let all = match sum.numbers.get(&p) {
                Some(&all) => graph.add(all, term),
                None => term,
            };
            sum.numbers.insert(p, all);
        }
    }

    /// ln|base|.
    fn name(&mut self, graph: &mut Graph, base: Expr) -> Expr {
        let written = self.plain.get(&base).copied().or_else(|| self.positive.contains(&base).then_some(base));
        let of = match written {
            Some(written) => self.put_into(graph, written),
            None => {
                let inner = self.put_into(graph, base);
                graph.unary(Op::Abs, inner)
            }
        };
        graph.unary(Op::Ln, of)
    }

    /// r^q of numbers: whole powers of primes come out, and parts of the logarithms of primes are added to the exponent.
    fn power_of_number(
        &self,
        graph: &mut Graph,
        r: &Rational,
        q: &Rational,
        (rest, whole): (&mut Expr, &mut Rational),
    ) -> bool {
        let parts: Option<Vec<(Rational, i32, Rational)>> = primes(r)
            .into_iter()
            .map(|(p, k)| {
                let exponent = q * Rational::from(k);
                let floor = exponent.floor();
                let n = i32::try_from(floor.clone()).ok().filter(|n| n.unsigned_abs() <= 64)?;
                Some((p, n, exponent - Rational::from(floor)))
            })
            .collect();
        let Some(parts) = parts else { return false };
        for (p, n, part) in parts {
            *whole *= p.pow(n as isize);
            if part != Rational::ZERO {
                let prime = graph.constant(p);
                let log = graph.unary(Op::Ln, prime);
                let part = graph.constant(part);
                let term = graph.mul(part, log);
                *rest = graph.add(*rest, term);
            }
        }
        true
    }

    /// By exponentials, so that those of logarithms are powers.
    fn hyperbolic(&mut self, graph: &mut Graph, op: Op, a: Expr) -> Expr {
        let e = self.exponential(graph, a);
        let (one, two) = (graph.integer(1), graph.integer(2));
        let inverse = graph.div(one, e);
        let (sum, difference) = (graph.add(e, inverse), graph.sub(e, inverse));
        match op {
            Op::Sinh => graph.div(difference, two),
            Op::Cosh => graph.div(sum, two),
            _ => graph.div(difference, sum),
        }
    }

    /// e^a: half-integer multiples of single logarithms are powers of what they are of.
    fn exponential(&mut self, graph: &mut Graph, a: Expr) -> Expr {
        let combination = Combinations::default().of(graph, a);
        let mut powers = Vec::new();
        let mut rest = graph.integer(0);
        let mut whole = Rational::ONE;
        let mut changed = false;
        for (monomial, q) in &combination {
            if let &[(base, 1)] = monomial.as_slice()
                && let &Node::Unary(Op::Ln, u) = graph.node(base)
                && let Ok(halves) = i32::try_from(q * Rational::from(2))
                && halves.unsigned_abs() <= 64
            {
                powers.push((self.put_into(graph, u), halves));
                changed = true;
                continue;
            }
            let term = expression(graph, monomial, q);
            let image = self.put_into(graph, term);
            changed |= image != term;
            for (m, q) in Combinations::default().of(graph, image) {
                let number = match m.as_slice() {
                    &[(base, 1)] => number_of(graph, base),
                    _ => None,
                };
                if number.is_some_and(|r| self.power_of_number(graph, &r, &q, (&mut rest, &mut whole))) {
                    changed = true;
                } else {
                    let term = expression(graph, &m, &q);
                    rest = graph.add(rest, term);
                }
            }
        }
        let rest = if changed { rest } else { a };
        let mut out = match graph.is_zero(rest) {
            true => graph.integer(1),
            false => graph.unary(Op::Exp, rest),
        };
        if whole != Rational::ONE {
            let whole = graph.constant(whole);
            out = graph.mul(whole, out);
        }
        for (u, halves) in powers {
            let power = match halves % 2 {
                0 => graph.powi(u, halves / 2),
                _ => {
                    let root = graph.unary(Op::Sqrt, u);
                    graph.powi(root, halves)
                }
            };
            out = graph.mul(power, out);
        }
        out
    }
}

/// What number a node is the logarithm of.
fn number_of(graph: &Graph, e: Expr) -> Option<Rational> {
    let &Node::Unary(Op::Ln, u) = graph.node(e) else { return None };
    graph.as_constant(u).filter(|r| **r > Rational::ZERO).cloned()
}

/// q = ∏ pᵏ; what is left beyond the small primes stays in one piece.
pub(super) fn primes(q: &Rational) -> Vec<(Rational, i64)> {
    let (top, under) = q.clone().into_parts();
    let mut out = Vec::new();
    for (mut left, sign) in [(Rational::from(top), 1), (Rational::from(under), -1)] {
        let mut p: u32 = 2;
        while p < LARGEST_PRIME && left != Rational::ONE {
            let prime = Rational::from(p);
            let mut k = 0;
            while (&left / &prime).is_int() {
                left /= &prime;
                k += sign;
            }
            if k != 0 {
                out.push((prime, k));
            }
            p += 1;
        }
        if left != Rational::ONE {
            out.push((left, sign));
        }
    }
    out
}
