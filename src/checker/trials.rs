//! Trials of identities of rational functions at random points of finite fields.
//!
//! **In:** an expression, of which everything that is no sum, product, quotient or whole power is an indeterminate. **Out:** a bound of the probability that it is taken
//! for 0 though it is not. **Guaranteed** (Schwartz 1980, Zippel 1979): let P be the numerator that the expression has when its fractions are put over a common
//! denominator step by step, of degree ≤ D, with integer coefficients whose sizes add up to at most 2ʰ after denominators of numbers are cleared. If P ≠ 0,
//! fewer than h/61 primes above 2⁶¹ divide all its coefficients, of more than 2⁵⁴ from which one is drawn; for another prime p, P vanishes at a random point of GF(p) with
//! probability ≤ D/p. A point at which a denominator vanishes is drawn again, of at most n points: that one of them is such a zero has a probability ≤ nD/p. Trials are independent.
//!
//! **Modulo squares.** Of indeterminates v₁, …, vₖ it may be known that vᵢ² = uᵢ, where uᵢ is made of others and of v₁, …, vᵢ₋₁. *Theorem.* P, reduced by vᵢ² → uᵢ, is Σ c_m·v^m over sets m of
//! the vᵢ, with polynomials c_m of the other indeterminates. If c_m ≠ 0 for some m, and no c_m vanishes at a point x that has c_m ≠ 0 there for one m, and all vᵢ ≠ 0 there, P is not 0 for some choice of the
//! signs of the roots vᵢ. *Proof.* By the last one: P = A + B·vₖ; if both signs of vₖ give 0, A = B = 0 for that choice of the other signs; so by induction all c_m are 0. □ So a point is tried with
//! all signs. It is drawn again where a root is 0, or is not in GF(p²). *Degrees.* A root counts with half the degree and half the size of its square, cleared of denominators: reducing enlarges neither, so that D and h
//! are bounds of the c_m, too.
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
use std::sync::LazyLock;

/// Trials go on until the bound is 2 to this power.
const WANTED: f64 = -100.0;
/// Most trials.
const MOST_TRIALS: usize = 64;
/// Points drawn in one trial until no denominator and no root vanishes, and log₂ of their number.
const MOST_POINTS: usize = 64;
const LOG2_POINTS: f64 = 6.0;
/// Most squares modulo which is tried.
const MOST_SQUARES: usize = 6;
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

/// What is known of an indeterminate: that `difference` = 0 says v² = u.
#[derive(Clone, Copy)]
pub(crate) struct Square {
    /// The indeterminate.
    pub(crate) v: Expr,
    /// u, as an expression.
    pub(crate) of: Expr,
}

fn growth(graph: &Graph, e: Expr, roots: &BTreeMap<Expr, Growth>) -> Growth {
    let mut found: BTreeMap<Expr, Growth> = BTreeMap::new();
    for node in graph.reachable([e]) {
        if let Some(root) = roots.get(&node) {
            found.insert(node, *root);
            continue;
        }
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

/// Bounds of roots of squares: with u = n/d, v is w/d, where w² = n·d.
fn roots(graph: &Graph, squares: &[Square]) -> BTreeMap<Expr, Growth> {
    let mut out = BTreeMap::new();
    for square in squares {
        let Growth { degree: [top, under], size: [height, cleared] } = growth(graph, square.of, &out);
        let root = Growth { degree: [(top + under) / 2.0, under], size: [(height + cleared) / 2.0, cleared] };
        out.insert(square.v, root);
    }
    out
}

/// The value where indeterminates have these values, and new ones are drawn; nothing where a denominator vanishes.
fn value(
    graph: &Graph,
    e: Expr,
    field: &FiniteField,
    draws: &mut Draws,
    point: &mut BTreeMap<Expr, Finite>,
) -> Option<Finite> {
    let mut found: BTreeMap<Expr, Finite> = BTreeMap::new();
    for node in graph.reachable([e]) {
        if let Some(known) = point.get(&node) {
            found.insert(node, *known);
            continue;
        }
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
            Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {
                let drawn = field.draw_element(draws);
                point.insert(node, drawn);
                drawn
            }
        };
        found.insert(node, made);
    }
    found.remove(&e)
}

/// Whether the expression vanishes at a random point, for all signs of roots; nothing for a point that does not count.
fn vanishes_at_point(
    graph: &Graph,
    e: Expr,
    squares: &[Square],
    field: &FiniteField,
    draws: &mut Draws,
) -> Option<bool> {
    let mut point = BTreeMap::new();
    for signs in 0..1u32 << squares.len() {
        for (at, square) in squares.iter().enumerate() {
            point.remove(&square.v);
            for later in &squares[at..] {
                point.remove(&later.v);
            }
            let u = value(graph, square.of, field, draws, &mut point)?;
            let root = field.square_root(u).filter(|root| !root.is_zero())?;
            let negative = signs >> at & 1 == 1;
            point.insert(square.v, if negative { field.difference(Finite::default(), root) } else { root });
        }
        if !value(graph, e, field, draws, &mut point)?.is_zero() {
            return Some(false);
        }
    }
    Some(true)
}

/// Whether squares are of expressions in which only roots before them stand, each once.
fn are_in_order(graph: &Graph, squares: &[Square]) -> bool {
    squares.len() <= MOST_SQUARES
        && squares.iter().enumerate().all(|(at, square)| {
            let below = graph.reachable([square.of]);
            squares[at..].iter().all(|later| !below.contains(&later.v))
                && squares[..at]
                    .iter()
                    .all(|before| before.v != square.v && !graph.reachable([before.v]).contains(&square.v))
        })
}

/// log₂ of the bound of the error, if the expression vanishes in all trials modulo squares.
pub(crate) fn vanishes(context: &Context, e: Expr, squares: &[Square]) -> Result<f64, String> {
    let graph = &context.graph;
    if !are_in_order(graph, squares) {
        return Err("the identity is too large to be expanded, and no trial modulo these relations is known".to_owned());
    }
    let one_trial = error_of_a_trial(graph, e, squares)?;
    let trials = (WANTED / one_trial).ceil();
    if !(one_trial < 0.0 && trials <= MOST_TRIALS as f64) {
        return Err("the identity is too large to be tried".to_owned());
    }
    let written = Term::of(graph, e, |symbol| Some(graph.name(symbol).to_owned()))?;
    let sum = Sha256::digest(format!("{written:?}"));
    for trial in 0..trials as u64 {
        let [mut primes, points] = draws(&sum, trial);
        if !one(graph, e, squares, &FiniteField::draw(&mut primes), points)? {
            return Err("the equation does not follow".to_owned());
        }
    }
    Ok(trials * one_trial)
}

/// log₂ of a bound of the probability that an expression which does not vanish does so in one trial.
fn error_of_a_trial(graph: &Graph, e: Expr, squares: &[Square]) -> Result<f64, String> {
    let Growth { degree: [top, under], size: [height, cleared] } = growth(graph, e, &roots(graph, squares));
    // What a denominator adds counts, too: those that are cleared on the way divide the last one.
    let (degree, height) = (top + under + 1.0, height + cleared + 1.0);
    let (of_degree, of_height) = (log2_above(degree.max(1.0)), log2_above(height.max(1.0)));
    if !(degree.is_finite() && height.is_finite() && of_degree < LARGEST && of_height < LARGEST) {
        return Err("the identity is too large to be tried".to_owned());
    }
    let of_points = LOG2_POINTS + of_degree - FiniteField::LOG2_P;
    let of_primes = of_height - 5.9 - FiniteField::LOG2_PRIMES;
    Ok(sum_log2(of_points, of_primes))
}

/// The draws of primes and of points in a trial.
fn draws(sum: &[u8], trial: u64) -> [Draws; 2] {
    let seed = |word: usize| {
        let bytes = sum.iter().skip(8 * word).take(8);
        bytes.fold(0u64, |out, byte| out << 8 | u64::from(*byte))
    };
    [0, 2].map(|word| Draws::new(seed(word) ^ Draws::new(seed(word + 1).wrapping_add(trial)).bits()))
}

/// Whether the expression vanishes at a point of a field.
fn one(graph: &Graph, e: Expr, squares: &[Square], field: &FiniteField, mut points: Draws) -> Result<bool, String> {
    let found = (0..MOST_POINTS).find_map(|_| vanishes_at_point(graph, e, squares, field, &mut points));
    found.ok_or_else(|| "a denominator vanishes".to_owned())
}

/// Whether one trial shows that an expression does not vanish modulo squares: cheap, and no proof of the contrary. Any field will do for
/// that: to look for a prime takes longer than the trial.
pub(crate) fn is_refuted(graph: &Graph, e: Expr, squares: &[Square]) -> bool {
    static FIELD: LazyLock<FiniteField> = LazyLock::new(|| FiniteField::draw(&mut draws(&[], 0)[0]));
    let [_, points] = draws(&[], 0);
    are_in_order(graph, squares) && one(graph, e, squares, &FIELD, points) == Ok(false)
}
