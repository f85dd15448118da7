//! Signs of expressions, by the rules of signs.
//!
//! **In:** an expression, and what facts say of the signs of expressions. **Out:** [`Signs`], the signs that it can have. **Guaranteed:** where
//! the expression has a value and the facts are true, the sign of the value is among them. Nothing is computed with decimals.

use super::context::{Context, Says};
use super::sequent::ConstantSign;
use super::term::Sense;
use expr::domain::{Bound, rises, stretches};
use expr::{Expr, Node, Op, Rational};
use std::collections::BTreeMap;

/// A set of signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Signs(u8);

impl Signs {
    pub(crate) const NONE: Signs = Signs(0);
    pub(crate) const NEGATIVE: Signs = Signs(1);
    pub(crate) const ZERO: Signs = Signs(2);
    pub(crate) const POSITIVE: Signs = Signs(4);
    pub(crate) const ALL: Signs = Signs(7);

    pub(crate) fn or(self, other: Signs) -> Signs {
        Signs(self.0 | other.0)
    }

    pub(crate) fn and(self, other: Signs) -> Signs {
        Signs(self.0 & other.0)
    }

    pub(crate) fn within(self, other: Signs) -> bool {
        self.0 & !other.0 == 0
    }

    /// The signs of −e.
    pub(crate) fn opposite(self) -> Signs {
        Signs(self.0 & 2 | self.0 << 2 & 4 | self.0 >> 2)
    }

    /// The sign of a number.
    pub(crate) fn of(r: &Rational) -> Signs {
        match r.cmp(&Rational::ZERO) {
            std::cmp::Ordering::Less => Signs::NEGATIVE,
            std::cmp::Ordering::Equal => Signs::ZERO,
            std::cmp::Ordering::Greater => Signs::POSITIVE,
        }
    }

    fn pairwise(self, other: Signs, rule: impl Fn(i8, i8) -> Signs) -> Signs {
        let each = |s: Signs| [-1i8, 0, 1].into_iter().filter(move |n| s.0 & 1 << (n + 1) != 0);
        each(self).flat_map(|a| each(other).map(move |b| (a, b))).fold(Signs::NONE, |out, (a, b)| out.or(rule(a, b)))
    }

    fn single(n: i8) -> Signs {
        match n.signum() {
            -1 => Signs::NEGATIVE,
            0 => Signs::ZERO,
            _ => Signs::POSITIVE,
        }
    }

    fn plus(self, other: Signs) -> Signs {
        self.pairwise(other, |a, b| if a * b < 0 { Signs::ALL } else { Signs::single(a + b) })
    }

    fn times(self, other: Signs) -> Signs {
        self.pairwise(other, |a, b| Signs::single(a * b))
    }
}

/// The signs that left − right has where the relation is true.
pub(crate) fn of_sense(sense: Sense) -> Signs {
    match sense {
        Sense::Equal => Signs::ZERO,
        Sense::NotEqual => Signs::NEGATIVE.or(Signs::POSITIVE),
        Sense::Less => Signs::NEGATIVE,
        Sense::LessOrEqual => Signs::NEGATIVE.or(Signs::ZERO),
    }
}

/// The signs that facts say: of a pair of expressions (l, r), the signs of l − r.
pub(crate) type KnownSigns = BTreeMap<(Expr, Expr), Signs>;

/// The signs of an expression.
pub(crate) fn signs(context: &Context, e: Expr, known: &KnownSigns) -> Signs {
    let zero = context.zero;
    let said = |a: Expr, b: Expr| {
        let one = known.get(&(a, b)).copied().unwrap_or(Signs::ALL);
        one.and(known.get(&(b, a)).map_or(Signs::ALL, |s| s.opposite()))
    };
    let mut found: BTreeMap<Expr, Signs> = BTreeMap::new();
    for node in context.graph.reachable([e]) {
        let mut here = match context.graph.node(node) {
            Node::Constant(r) => Signs::of(r),
            Node::Pi => Signs::POSITIVE,
            Node::Leaf(leaf) => match context.constant_sign(*leaf) {
                ConstantSign::Any => Signs::ALL,
                ConstantSign::Positive => Signs::POSITIVE,
                ConstantSign::NotNegative => Signs::POSITIVE.or(Signs::ZERO),
                ConstantSign::NotZero => Signs::POSITIVE.or(Signs::NEGATIVE),
            },
            Node::Unary(op, a) => unary(*op, found[a]).and(on_stretches(context, *op, *a, found[a], said)),
            Node::Binary(op, a, b) => {
                let own = binary(*op, *a, *b, [found[a], found[b]]);
                if *op == Op::Sub {
                    let more = excess(context, *a, *b).and(rising(context, [*a, *b], &found, said));
                    own.and(said(*a, *b)).and(more)
                } else if *op == Op::Add {
                    // a + b = a − (−b)
                    let minus = |e: Expr| context.graph.find(&Node::Unary(Op::Neg, e));
                    let of = |a: Expr, b: Expr| minus(b).map_or(Signs::ALL, |minus| said(a, minus));
                    own.and(of(*a, *b)).and(of(*b, *a))
                } else {
                    own
                }
            }
        };
        here = here.and(said(node, zero));
        if let Some(minus) = context.graph.find(&Node::Unary(Op::Neg, node)) {
            here = here.and(said(minus, zero).opposite());
        }
        found.insert(node, here);
    }
    found[&e]
}

/// The signs of a − b, if a is |b|. *Theorem.* |b| − b ≥ 0. *Proof.* It is 0 for b ≥ 0, and −2b otherwise. □
fn excess(context: &Context, a: Expr, b: Expr) -> Signs {
    if context.graph.find(&Node::Unary(Op::Abs, b)) == Some(a) { Signs::POSITIVE.or(Signs::ZERO) } else { Signs::ALL }
}

/// The signs of f(a), by where a lies: what facts say of a and the ends of the stretches on which the values of f have a sign, which the table of domains tells.
/// *Theorem.* On a stretch the value has its sign, or is 0, and that at ends only. *Proof.* The rows of the table: zeros and poles of sine, cosine and tangent; ln 1 = 0, and it rises; odd functions that rise. □
fn on_stretches(context: &Context, op: Op, a: Expr, of_a: Signs, said: impl Fn(Expr, Expr) -> Signs) -> Signs {
    let mut out = Signs::ALL;
    for stretch in stretches(op) {
        let (mut inside, mut within) = (true, true);
        for (end, allowed) in [(stretch.from, Signs::POSITIVE), (stretch.to, Signs::NEGATIVE)] {
            let Some(end) = end else { continue };
            // The signs of a − end.
            let signs =
                of_end(context, end).map_or(Signs::ALL, |end| if end == context.zero { of_a } else { said(a, end) });
            inside &= signs.within(allowed);
            within &= signs.within(allowed.or(Signs::ZERO));
        }
        let sign = if stretch.is_positive { Signs::POSITIVE } else { Signs::NEGATIVE };
        if within {
            out = out.and(if inside { sign } else { sign.or(Signs::ZERO) });
        }
    }
    out
}

/// An end as facts write it: a whole number, or a multiple of π; nothing where no formula has it.
fn of_end(context: &Context, end: Bound) -> Option<Expr> {
    let graph = &context.graph;
    let constant = |r: Rational| graph.find(&Node::Constant(r.into()));
    match end.quarter_turns {
        0 => constant(end.whole.into()),
        2 => graph.find(&Node::Pi),
        turns => {
            let factor = constant(Rational::from(turns) / Rational::from(2))?;
            let pi = graph.find(&Node::Pi)?;
            let product = |a, b| graph.find(&Node::Binary(Op::Mul, a, b));
            product(factor, pi).or_else(|| product(pi, factor))
        }
    }
}

/// The signs of x − y for x = f(a), y = f(b), and a rising f: those of a − b. Of exponentials, 1 is the value at 0.
fn rising(
    context: &Context,
    [x, y]: [Expr; 2],
    found: &BTreeMap<Expr, Signs>,
    said: impl Fn(Expr, Expr) -> Signs,
) -> Signs {
    let function = |e: Expr| {
        let Node::Unary(op, a) = *context.graph.node(e) else { return None };
        rises(op).then_some((op, a))
    };
    let is_one = |e: Expr| context.graph.as_constant(e) == Some(&Rational::ONE);
    let of_exponential = |(op, a): (Op, Expr)| if op == Op::Exp { found[&a] } else { Signs::ALL };
    if let (Some((f, a)), Some((g, b))) = (function(x), function(y)) {
        return if f == g { said(a, b) } else { Signs::ALL };
    }
    if is_one(y) {
        return function(x).map_or(Signs::ALL, of_exponential);
    }
    if is_one(x) { function(y).map_or(Signs::ALL, of_exponential).opposite() } else { Signs::ALL }
}

/// What a relation between e and 0 says of parts of e. *Theorem.* Where a product, a quotient, a power with an exponent above 0 or |a| is not 0, its factors, its numerator, its base, a are not 0; −a has the opposite sign of a, a power with an
/// odd exponent above 0 has the sign of its base, and √a that of a, which is not negative. (The relation is true, so that all parts have values.)
pub(crate) fn of_parts(context: &Context, says: Says) -> Vec<(Expr, Signs)> {
    let not_zero = Signs::NEGATIVE.or(Signs::POSITIVE);
    let (whole, signs) = match says.sides() {
        [e, z] if z == context.zero => (e, of_sense(says.sense)),
        [z, e] if z == context.zero => (e, of_sense(says.sense).opposite()),
        _ => return Vec::new(),
    };
    let (mut open, mut out) = (vec![(whole, signs)], Vec::new());
    while let Some((e, signs)) = open.pop() {
        match *context.graph.node(e) {
            Node::Binary(Op::Mul, a, b) if signs.within(not_zero) => open.extend([(a, not_zero), (b, not_zero)]),
            Node::Binary(Op::Div, a, _) | Node::Unary(Op::Abs, a) if signs.within(not_zero) => open.push((a, not_zero)),
            Node::Unary(Op::Neg, a) => open.push((a, signs.opposite())),
            Node::Unary(Op::Powi(n), a) if n > 0 && n % 2 == 1 => open.push((a, signs)),
            Node::Unary(Op::Powi(n), a) if n > 0 && signs.within(not_zero) => open.push((a, not_zero)),
            Node::Unary(Op::Sqrt, a) => open.push((a, signs.and(Signs::POSITIVE.or(Signs::ZERO)))),
            Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {}
        }
        if e != whole {
            out.push((e, signs));
        }
    }
    out
}

fn unary(op: Op, a: Signs) -> Signs {
    let not_negative = Signs::POSITIVE.or(Signs::ZERO);
    match op {
        Op::Neg => a.opposite(),
        // Only what has a value is asked about.
        Op::Sqrt => a.and(not_negative),
        Op::Exp | Op::Cosh => Signs::POSITIVE,
        Op::Ln | Op::Sin | Op::Cos | Op::Tan => Signs::ALL,
        // Odd, rising, 0 at 0.
        Op::Arcsin | Op::Arctan | Op::Sinh | Op::Tanh => a,
        Op::Arccos => not_negative,
        Op::Abs => absolute(a),
        Op::Powi(0) => Signs::POSITIVE,
        Op::Powi(n) if n % 2 == 0 => absolute(a),
        Op::Powi(_) => a,
        Op::Add
        | Op::Sub
        | Op::Mul
        | Op::Div
        | Op::Pow
        | Op::Arctan2
        | Op::Agm
        | Op::DirectionCosine
        | Op::Restrict => Signs::ALL,
    }
}

fn absolute(a: Signs) -> Signs {
    a.pairwise(Signs::POSITIVE, |a, _| Signs::single(a * a))
}

fn binary(op: Op, left: Expr, right: Expr, [a, b]: [Signs; 2]) -> Signs {
    let not_negative = Signs::POSITIVE.or(Signs::ZERO);
    match op {
        Op::Add => a.plus(b),
        Op::Sub if left == right => Signs::ZERO,
        Op::Sub => a.plus(b.opposite()),
        Op::Mul if left == right => absolute(a),
        Op::Mul => a.times(b),
        Op::Div => a.times(b.and(Signs::NEGATIVE.or(Signs::POSITIVE))),
        // a > 0 makes it positive; a = 0 makes it 0.
        Op::Pow => a.and(not_negative),
        Op::Agm => not_negative,
        Op::DirectionCosine | Op::Restrict => a,
        Op::Arctan2
        | Op::Neg
        | Op::Sqrt
        | Op::Exp
        | Op::Ln
        | Op::Sin
        | Op::Cos
        | Op::Tan
        | Op::Arcsin
        | Op::Arccos
        | Op::Arctan
        | Op::Sinh
        | Op::Cosh
        | Op::Tanh
        | Op::Abs
        | Op::Powi(_) => Signs::ALL,
    }
}
