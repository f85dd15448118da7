//! Signs that follow, wherever all formulas have values, from what is given of others.
//!
//! **In:** formulas, and expressions that are positive or not negative. **Out:** others that are. **How:** an odd power has the sign of its base; of what is
//! below a root, a logarithm or a power, the table of domains says the sign; sums have one by the ranges of their parts; functions by the stretch of the
//! table on which their argument lies, which is compared with the ends exactly: 0 < θ < π gives sin θ > 0 and cos(θ/2) > 0. **Guaranteed:** nothing is said of
//! an expression that brings a new generator: of functions, only of those that stand outside of the arguments of others.

use super::linear::{Combination, Combinations};
use super::outcome::Premises;
use super::polynomial::primitive;
use super::range::Ranges;
use expr::domain::{rises, stretches};
use expr::{Expr, FastSet, Graph, Node, Op, Rational};

/// Larger expressions and problems are not looked at for signs.
const MOST_BELOW: usize = 32;
const MOST_NODES: usize = 400;

/// Signs that are implied.
#[derive(Default)]
pub(super) struct Implied {
    pub(super) positive: Vec<Expr>,
    pub(super) not_negative: Vec<Expr>,
}

/// How far an expression is known to be from below 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Least {
    Zero,
    AboveZero,
}

/// Whether an expression has no function in it but roots and sizes.
fn is_plain(graph: &Graph, e: Expr) -> bool {
    let below = graph.reachable([e]);
    below.len() <= MOST_BELOW
        && below.iter().all(|&e| match *graph.node(e) {
            Node::Constant(_) | Node::Leaf(_) => true,
            Node::Pi => false,
            Node::Unary(op, _) => matches!(op, Op::Neg | Op::Powi(_)),
            Node::Binary(op, ..) => matches!(op, Op::Add | Op::Sub | Op::Mul | Op::Div),
        })
}

/// Whether a node is a function of something, and no root, size or power.
fn has_argument(graph: &Graph, e: Expr) -> bool {
    if let Node::Unary(Op::Neg | Op::Powi(_) | Op::Sqrt | Op::Abs, _) = *graph.node(e) {
        return false;
    }
    let Node::Unary(..) = *graph.node(e) else { return false };
    true
}

/// The nodes of formulas that stand below no function but roots and sizes.
fn outside(graph: &Graph, roots: &[Expr]) -> Vec<Expr> {
    let (mut open, mut found) = (roots.to_vec(), FastSet::default());
    while let Some(e) = open.pop() {
        if !found.insert(e) {
            continue;
        }
        if let Node::Unary(Op::Neg | Op::Powi(_) | Op::Sqrt | Op::Abs, a) = *graph.node(e) {
            open.push(a);
        } else if let Node::Binary(Op::Add | Op::Sub | Op::Mul | Op::Div, a, b) = *graph.node(e) {
            open.extend([a, b]);
        }
    }
    let mut found: Vec<Expr> = found.into_iter().collect();
    found.sort_unstable();
    found
}

/// The base of what is an odd power of it, with the sign that makes it positive.
fn odd_base(graph: &mut Graph, e: Expr) -> Option<Expr> {
    let (q, parts) = primitive(graph, e);
    match parts.as_slice() {
        &[(base, k)] if k % 2 != 0 => Some(if q > Rational::ZERO { base } else { graph.neg(base) }),
        _ => None,
    }
}

/// Other expressions that are positive, or not negative.
pub(super) fn implied(graph: &mut Graph, roots: &[Expr], [positive, not_negative]: [&[Expr]; 2]) -> Implied {
    let mut out = Implied::default();
    let is_leaf = |graph: &Graph, e: Expr| matches!(graph.node(e), Node::Leaf(_));
    let nodes = graph.reachable(roots.iter().copied());
    let mut rooted = false;
    let mut radicands = Vec::new();
    for &e in &nodes {
        rooted |= matches!(graph.node(e), Node::Unary(Op::Sqrt | Op::Abs, _) | Node::Binary(Op::Pow, ..));
        let (below, is_root) = if let Node::Unary(Op::Sqrt, a) = *graph.node(e) {
            (a, true)
        } else if let Node::Unary(Op::Ln, a) | Node::Binary(Op::Pow, a, _) = *graph.node(e) {
            (a, false)
        } else {
            continue;
        };
        if !is_plain(graph, below) {
            continue;
        }
        match odd_base(graph, below) {
            Some(base) => out.not_negative.push(base),
            None if is_root => {}
            None => out.not_negative.push(below),
        }
        radicands.extend(is_root.then_some(below));
    }
    for (list, implied) in [(positive, &mut out.positive), (not_negative, &mut out.not_negative)] {
        for &e in list.iter().filter(|&&e| !is_leaf(graph, e) && is_plain(graph, e)).collect::<Vec<_>>() {
            implied.extend(odd_base(graph, e));
        }
    }
    let restricted = !positive.iter().chain(not_negative).chain(&radicands).all(|&e| is_leaf(graph, e));
    let outer = outside(graph, roots);
    let has_function = outer.iter().any(|&e| has_argument(graph, e));
    if rooted && nodes.len() <= MOST_NODES && (restricted || has_function) {
        let not_negative: Vec<Expr> = not_negative.iter().chain(&out.not_negative).copied().chain(radicands).collect();
        let positive: Vec<Expr> = positive.iter().chain(&out.positive).copied().collect();
        let given = Premises { positive, not_negative, ..Premises::default() };
        Search { ranges: Ranges::new(graph, &given), known: of_known(graph, &given), given }
            .search(graph, &outer, &nodes, &mut out);
    }
    out
}

/// Expressions that are known not to be negative, multiplied out.
fn of_known(graph: &Graph, given: &Premises) -> Vec<(Combination, Least)> {
    let mut combinations = Combinations::default();
    let of = [(&given.positive, Least::AboveZero), (&given.not_negative, Least::Zero)];
    let each = of.into_iter().flat_map(|(list, least)| list.iter().map(move |&e| (e, least)));
    each.map(|(e, least)| (combinations.of(graph, e), least)).collect()
}

struct Search {
    given: Premises,
    ranges: Ranges,
    known: Vec<(Combination, Least)>,
}

impl Search {
    fn search(mut self, graph: &mut Graph, outer: &[Expr], nodes: &[Expr], out: &mut Implied) {
        for &e in nodes {
            let is_sum = matches!(graph.node(e), Node::Leaf(_) | Node::Binary(Op::Add | Op::Sub, ..));
            let is_outer = outer.contains(&e);
            if is_sum && (is_plain(graph, e) || is_outer) {
                self.of_sum(graph, e, out);
            }
            for (op, a) in parts(graph, e) {
                let part = graph.unary(op, a);
                if let Some(found) = self.of_function(graph, op, a) {
                    self.learn(graph, (part, found), is_outer.then_some(&mut *out));
                }
            }
            let found = if let Node::Unary(op, a) = *graph.node(e) {
                self.of_function(graph, op, a)
            } else if is_outer && is_sum {
                self.of_difference(graph, e)
            } else {
                None
            };
            if let Some(found) = found {
                // What stands in an argument says something of what is outside only.
                self.learn(graph, (e, found), is_outer.then_some(&mut *out));
            }
        }
    }

    /// Notes that an expression is positive, or negative.
    fn learn(
        &mut self,
        graph: &mut Graph,
        (e, (is_positive, least)): (Expr, (bool, Least)),
        out: Option<&mut Implied>,
    ) {
        let e = if is_positive { e } else { graph.neg(e) };
        match least {
            Least::AboveZero => self.given.positive.push(e),
            Least::Zero => self.given.not_negative.push(e),
        }
        if let Some(out) = out {
            let list = if least == Least::AboveZero { &mut out.positive } else { &mut out.not_negative };
            list.push(e);
        }
        self.known.push((Combinations::default().of(graph, e), least));
        self.ranges = Ranges::new(graph, &self.given);
    }

    fn of_sum(&self, graph: &mut Graph, e: Expr, out: &mut Implied) {
        let range = self.ranges.of(graph, e).range();
        if range.lo() >= 0.0 {
            out.not_negative.push(e);
        } else if range.hi() <= 0.0 {
            let opposite = graph.neg(e);
            out.not_negative.push(opposite);
        }
    }

    /// Whether the values of a function are positive, by the stretch on which its argument lies; or negative.
    fn of_function(&self, graph: &mut Graph, op: Op, a: Expr) -> Option<(bool, Least)> {
        stretches(op).iter().find_map(|stretch| {
            let mut least = Least::AboveZero;
            for (bound, is_lower) in [(stretch.from, true), (stretch.to, false)] {
                let Some(bound) = bound else { continue };
                let end = bound.expression(graph);
                let beyond = if is_lower { graph.sub(a, end) } else { graph.sub(end, a) };
                least = least.min(self.least(graph, beyond)?);
            }
            Some((stretch.is_positive, least))
        })
    }

    /// Whether a multiple of f(a) − f(b) is positive, for a rising f; or negative. Of exponentials, f(b) may be written 1.
    fn of_difference(&self, graph: &mut Graph, e: Expr) -> Option<(bool, Least)> {
        let sum = Combinations::default().of(graph, e);
        let terms: Vec<_> = sum.iter().map(|(m, q)| (m.as_slice(), q.clone())).collect();
        let [one, other] = terms.as_slice() else { return None };
        if one.1 != -other.1.clone() {
            return None;
        }
        let rising = |m: &[(Expr, i32)]| {
            let &[(node, 1)] = m else { return None };
            let Node::Unary(op, a) = *graph.node(node) else { return None };
            rises(op).then_some((op, a))
        };
        let of_exponential = |(op, a): (Op, Expr)| (op == Op::Exp).then_some(a);
        let (f, g) = (rising(one.0), rising(other.0));
        let (a, b, q) = if let (Some((f, a)), Some((g, b))) = (f, g) {
            (f == g).then_some((a, b, &one.1))?
        } else if other.0.is_empty() {
            (of_exponential(f?)?, graph.integer(0), &one.1)
        } else {
            let is_whole = one.0.is_empty();
            (of_exponential(g.filter(|_| is_whole)?)?, graph.integer(0), &other.1)
        };
        let [above, below] = [graph.sub(a, b), graph.sub(b, a)];
        let is_rising = *q > Rational::ZERO;
        let found = self.least(graph, above).map(|least| (is_rising, least));
        found.or_else(|| self.least(graph, below).map(|least| (!is_rising, least)))
    }

    /// Whether an expression is known not to be negative: as a multiple of one that is known, beside a number; or by its range.
    fn least(&self, graph: &Graph, e: Expr) -> Option<Least> {
        let sum = Combinations::default().of(graph, e);
        if let Some(found) = of_number(graph, &sum) {
            return found;
        }
        let (first, q) = sum.iter().find(|(m, _)| !is_number(graph, m))?;
        let by_known = self.known.iter().filter_map(|(known, least)| {
            let factor = q.clone() / known.get(first)?.clone();
            if factor <= Rational::ZERO {
                return None;
            }
            let mut rest = sum.clone();
            for (m, q) in known {
                super::linear::add_to(&mut rest, m.clone(), -(q.clone() * factor.clone()));
            }
            if rest.is_empty() { Some(*least) } else { of_number(graph, &rest)?.map(|number| number.max(*least)) }
        });
        let found = by_known.max();
        let range = self.ranges.of(graph, e).range();
        let by_range = match range.lo() {
            low if low > 0.0 => Some(Least::AboveZero),
            low if low >= 0.0 => Some(Least::Zero),
            _ => None,
        };
        found.max(by_range)
    }
}

/// The functions of the same that a tangent is written by.
fn parts(graph: &Graph, e: Expr) -> Vec<(Op, Expr)> {
    if let Node::Unary(Op::Tan, a) = *graph.node(e) {
        return vec![(Op::Sin, a), (Op::Cos, a)];
    }
    if let Node::Unary(Op::Tanh, a) = *graph.node(e) { vec![(Op::Sinh, a)] } else { Vec::new() }
}

/// Whether a monomial is 1 or π.
fn is_number(graph: &Graph, m: &[(Expr, i32)]) -> bool {
    m.is_empty() || matches!(m, [(base, 1)] if *graph.node(*base) == Node::Pi)
}

/// The least value of a sum of a number and of a multiple of π; nothing where it is no such sum.
fn of_number(graph: &Graph, sum: &Combination) -> Option<Option<Least>> {
    // 3.14 < π < 3.15
    let (mut low, mut is_zero) = (Rational::ZERO, true);
    for (m, q) in sum {
        if !is_number(graph, m) {
            return None;
        }
        let pi = Rational::from(if *q > Rational::ZERO { 314 } else { 315 }) / Rational::from(100);
        low += if m.is_empty() { q.clone() } else { q.clone() * pi };
        is_zero = false;
    }
    Some(match low {
        _ if is_zero => Some(Least::Zero),
        low if low > Rational::ZERO => Some(Least::AboveZero),
        _ => None,
    })
}
