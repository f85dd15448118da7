//! Trials of identities of rational functions at random points of finite fields.
//!
//! **In:** an expression, of which everything that is no sum, product, quotient or whole power is an indeterminate. **Out:** a bound of the probability that it is taken
//! for 0 though it is not. **Guaranteed** (Schwartz 1980, Zippel 1979): let P be the numerator that the expression has when its fractions are put over a common
//! denominator step by step, of degree ≤ D, with integer coefficients whose sizes add up to at most 2ʰ after denominators of numbers are cleared. If P ≠ 0,
//! fewer than h/61 primes above 2⁶¹ divide all its coefficients, of more than 2⁵⁴ from which one is drawn; for another prime p, P vanishes at a random point of GF(p) with
//! probability ≤ D/p. A point at which a denominator vanishes is drawn again, which multiplies that by at most 1/(1 − D/p) ≤ 2. Trials are independent.
//!
//! **The draws** are made from the SHA-256 sum of the expression: a proof that was made to pass would have to be searched for among some 2¹⁰⁰.
//!
//! **Traps.** Degrees and sizes are computed here, not believed. A function of equal arguments that are written in different ways is not the same indeterminate: that
//! loses a proof and never makes one.

use crate::context::Context;
use crate::polynomial::bits;
use crate::term::Term;
use expr::{Expr, Graph, Node, Op};
use number::{Draws, Finite, FiniteField};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Trials go on until the bound is 2 to this power.
const WANTED: f64 = -100.0;
/// Most trials.
const MOST_TRIALS: usize = 64;
/// Points drawn in one trial until no denominator vanishes.
const MOST_POINTS: usize = 16;
/// log₂ of the largest degree and of the largest log of a size.
const LARGEST: f64 = 40.0;

/// An upper bound of log₂(2^a + 2^b), the same on every machine: log₂(1 + x) ≤ 1.45x.
pub(crate) fn sum_log2(a: f64, b: f64) -> f64 {
    let (high, low) = (a.max(b), a.min(b));
    if low == f64::NEG_INFINITY {
        return high;
    }
    let whole = (high - low).floor().min(60.0) as u32;
    high + (1.45 / (1u64 << whole) as f64).min(1.0)
}

/// An upper bound of log₂ x for x ≥ 1, the same on every machine: log₂ m ≤ m − 1 + 0.09 for 1 ≤ m ≤ 2.
fn log2_above(x: f64) -> f64 {
    let exponent = ((x.to_bits() >> 52 & 0x7ff) as i64 - 1023) as f64;
    let mantissa = f64::from_bits(x.to_bits() & ((1 << 52) - 1) | 1023 << 52);
    exponent + (mantissa - 1.0) + 0.09
}

/// Bounds of numerator and denominator: degree, and log₂ of the sum of the sizes of coefficients.
#[derive(Clone, Copy)]
struct Growth {
    degree: [f64; 2],
    size: [f64; 2],
}

impl Growth {
    fn product(self, other: Growth) -> Growth {
        let add = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        Growth { degree: add(self.degree, other.degree), size: add(self.size, other.size) }
    }

    fn sum(self, other: Growth) -> Growth {
        let cross = |a: [f64; 2], b: [f64; 2]| [(a[0] + b[1]).max(b[0] + a[1]), a[1] + b[1]];
        let mut size = cross(self.size, other.size);
        size[0] += 1.0;
        Growth { degree: cross(self.degree, other.degree), size }
    }

    fn power(self, n: f64) -> Growth {
        Growth { degree: self.degree.map(|d| d * n), size: self.size.map(|s| s * n) }
    }

    fn inverse(self) -> Growth {
        let turned = |[a, b]: [f64; 2]| [b, a];
        Growth { degree: turned(self.degree), size: turned(self.size) }
    }
}

fn growth(graph: &Graph, e: Expr) -> Growth {
    let mut found: BTreeMap<Expr, Growth> = BTreeMap::new();
    for node in graph.reachable([e]) {
        let made = match graph.node(node) {
            Node::Constant(r) => Growth { degree: [0.0; 2], size: bits(r).map(|n| n as f64) },
            Node::Unary(Op::Neg, a) | Node::Binary(Op::Restrict, a, _) => found[a],
            Node::Unary(Op::Powi(n), a) => {
                let base = if *n < 0 { found[a].inverse() } else { found[a] };
                base.power(f64::from(n.unsigned_abs()))
            }
            Node::Binary(Op::Add | Op::Sub, a, b) => found[a].sum(found[b]),
            Node::Binary(Op::Mul, a, b) => found[a].product(found[b]),
            Node::Binary(Op::Div, a, b) => found[a].product(found[b].inverse()),
            Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {
                Growth { degree: [1.0, 0.0], size: [0.0; 2] }
            }
        };
        found.insert(node, made);
    }
    found[&e]
}

/// The value at a random point; nothing where a denominator vanishes.
fn value(graph: &Graph, e: Expr, field: &FiniteField, draws: &mut Draws) -> Option<Finite> {
    let mut found: BTreeMap<Expr, Finite> = BTreeMap::new();
    for node in graph.reachable([e]) {
        let made = match graph.node(node) {
            Node::Constant(r) => field.of_rational(r)?,
            Node::Unary(Op::Neg, a) => field.difference(Finite::default(), found[a]),
            Node::Unary(Op::Powi(n), a) => {
                let mut base = if *n < 0 { field.inverse(found[a])? } else { found[a] };
                let (mut exponent, mut power) = (n.unsigned_abs(), field.integer(1));
                while exponent > 0 {
                    if exponent & 1 == 1 {
                        power = field.product(power, base);
                    }
                    base = field.product(base, base);
                    exponent >>= 1;
                }
                power
            }
            Node::Binary(Op::Add, a, b) => field.sum(found[a], found[b]),
            Node::Binary(Op::Sub, a, b) => field.difference(found[a], found[b]),
            Node::Binary(Op::Mul, a, b) => field.product(found[a], found[b]),
            Node::Binary(Op::Div, a, b) => field.product(found[a], field.inverse(found[b])?),
            Node::Binary(Op::Restrict, a, _) => found[a],
            Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => field.draw_element(draws),
        };
        found.insert(node, made);
    }
    found.remove(&e)
}

/// log₂ of the bound of the error, if the expression vanishes in all trials.
pub(crate) fn vanishes(context: &Context, e: Expr) -> Result<f64, String> {
    let graph = &context.graph;
    let Growth { degree: [top, under], size: [height, cleared] } = growth(graph, e);
    // What a denominator adds counts, too: those that are cleared on the way divide the last one.
    let (degree, height) = (top + under + 1.0, height + cleared + 1.0);
    let (of_degree, of_height) = (log2_above(degree.max(1.0)), log2_above(height.max(1.0)));
    if !(degree.is_finite() && height.is_finite() && of_degree < LARGEST && of_height < LARGEST) {
        return Err("the identity is too large to be tried".to_owned());
    }
    let of_points = 1.0 + of_degree - FiniteField::LOG2_P;
    let of_primes = of_height - 5.9 - FiniteField::LOG2_PRIMES;
    let one_trial = sum_log2(of_points, of_primes);
    let trials = (WANTED / one_trial).ceil();
    if !(one_trial < 0.0 && trials <= MOST_TRIALS as f64) {
        return Err("the identity is too large to be tried".to_owned());
    }
    let written = Term::of(graph, e, |symbol| Some(graph.name(symbol).to_owned()))?;
    let sum = Sha256::digest(format!("{written:?}"));
    for trial in 0..trials as u64 {
        let seed = |word: usize| {
            let bytes = sum.iter().skip(8 * word).take(8);
            bytes.fold(0u64, |out, byte| out << 8 | u64::from(*byte))
        };
        let mut primes = Draws::new(seed(0) ^ Draws::new(seed(1).wrapping_add(trial)).bits());
        let mut points = Draws::new(seed(2) ^ Draws::new(seed(3).wrapping_add(trial)).bits());
        let field = FiniteField::draw(&mut primes);
        let found = (0..MOST_POINTS).find_map(|_| value(graph, e, &field, &mut points));
        if !found.ok_or("a denominator vanishes")?.is_zero() {
            return Err("the equation does not follow".to_owned());
        }
    }
    Ok(trials * one_trial)
}
