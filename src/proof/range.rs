//! Where the values of expressions lie, by what is given of the signs of others.
//!
//! **In:** expressions that are not negative. **Out:** for an expression an interval that contains its value wherever what is
//! given holds and it has one. Rounded outwards; nothing is said of whether there is a value.

use super::linear::{Combinations, Monomial, expression};
use super::outcome::Premises;
use expr::domain::{Bound, Range, row};
use expr::{Expr, FastMap, Graph, Leaf, Node, Op, Rational};
use number::{Decorated, Interval, Number};

/// How often bounds of leaves are used for those of others.
const ROUNDS: usize = 3;

/// Intervals of the leaves of one problem.
#[derive(Debug, Default)]
pub(super) struct Ranges {
    leaves: FastMap<Leaf, Decorated>,
    /// Known not to be negative.
    not_negative: Vec<Expr>,
}

fn apply(op: Op, a: &Decorated, b: &Decorated) -> Decorated {
    let mut out = Decorated::blank(&());
    match op.apply(&(), &mut out, a, b) {
        Ok(()) => out,
        Err(_) => anywhere(op),
    }
}

/// All values of an operation.
fn anywhere(op: Op) -> Decorated {
    // A little more than π/2, and a little less.
    let end = |bound: Bound, [positive, negative]: [f64; 2]| {
        let turns = f64::from(bound.quarter_turns);
        f64::from(bound.whole) + turns * if turns > 0.0 { positive } else { negative }
    };
    match row(op).range {
        Range { low: Some(low), high: Some(high) } => {
            let all = Interval::new(end(low, [1.57, 1.58]), end(high, [1.58, 1.57]));
            all.map_or(Decorated::UNKNOWN, |all| Decorated::UNKNOWN.narrowed(all))
        }
        Range { low: Some(low), high: None } if low.whole >= 0 && low.quarter_turns >= 0 => upwards(),
        Range { .. } => Decorated::UNKNOWN,
    }
}

/// [0, ∞).
fn upwards() -> Decorated {
    let mut out = Decorated::blank(&());
    match Number::abs(&mut out, &(), &Decorated::UNKNOWN) {
        Ok(()) => out,
        Err(_) => Decorated::UNKNOWN,
    }
}

fn constant(r: &Rational) -> Decorated {
    let mut out = Decorated::blank(&());
    match Number::rational(&mut out, &(), r) {
        Ok(()) => out,
        Err(_) => Decorated::UNKNOWN,
    }
}

impl Ranges {
    pub(super) fn new(graph: &mut Graph, given: &Premises) -> Ranges {
        let not_negative: Vec<Expr> = given.positive.iter().chain(&given.not_negative).copied().collect();
        let mut out = Ranges { leaves: FastMap::default(), not_negative };
        let facts: Vec<_> = out.not_negative.iter().map(|&e| Combinations::default().of(graph, e)).collect();
        for _ in 0..ROUNDS {
            for fact in &facts {
                for (monomial, q) in fact {
                    let &[(base, power @ (1 | 2))] = monomial.as_slice() else { continue };
                    let &Node::Leaf(leaf) = graph.node(base) else { continue };
                    let others = || fact.iter().filter(|(m, _)| *m != monomial);
                    if others().any(|(m, _)| m.iter().any(|&(b, _)| b == base || graph.leaves([b]).contains(&leaf))) {
                        continue;
                    }
                    // q·xᵏ + rest ≥ 0.
                    let rest: Vec<(Monomial, Rational)> = others().map(|(m, q)| (m.clone(), q.clone())).collect();
                    let mut sum = graph.integer(0);
                    for (m, q) in &rest {
                        let term = expression(graph, m, q);
                        sum = graph.add(sum, term);
                    }
                    let rest = out.of(graph, sum);
                    let bound = apply(Op::Div, &apply(Op::Neg, &rest, &rest), &constant(q));
                    let beyond = match (power, *q > Rational::ZERO) {
                        (1, true) => apply(Op::Add, &bound, &upwards()),
                        (1, false) => apply(Op::Sub, &bound, &upwards()),
                        // x² ≤ bound.
                        (_, false) => {
                            let root = apply(Op::Sqrt, &bound, &bound);
                            let below = apply(Op::Sub, &root, &upwards());
                            let above = apply(Op::Sub, &upwards(), &root);
                            let known = out.leaves.get(&leaf).copied().unwrap_or(Decorated::UNKNOWN);
                            out.leaves.insert(leaf, known.narrowed(below.range()));
                            above
                        }
                        (_, true) => continue,
                    };
                    let known = out.leaves.get(&leaf).copied().unwrap_or(Decorated::UNKNOWN);
                    out.leaves.insert(leaf, known.narrowed(beyond.range()));
                }
            }
        }
        out
    }

    /// Where the values of an expression lie.
    pub(super) fn of(&self, graph: &Graph, e: Expr) -> Decorated {
        let mut values: FastMap<Expr, Decorated> = FastMap::default();
        for node in graph.reachable([e]) {
            let at = |e: Expr| values.get(&e).copied().unwrap_or(Decorated::UNKNOWN);
            let value = match *graph.node(node) {
                Node::Constant(ref r) => constant(r),
                Node::Pi => {
                    let mut out = Decorated::blank(&());
                    Number::pi(&mut out, &()).map_or(Decorated::UNKNOWN, |()| out)
                }
                Node::Leaf(leaf) => self.leaves.get(&leaf).copied().unwrap_or(Decorated::UNKNOWN),
                // There is a value in [−1, 1] only.
                Node::Unary(op @ (Op::Arcsin | Op::Arccos), a) => {
                    let within = Interval::new(-1.0, 1.0).map_or(at(a), |unit| at(a).narrowed(unit));
                    apply(op, &within, &within)
                }
                Node::Unary(op, a) => apply(op, &at(a), &at(a)),
                Node::Binary(Op::Arctan2, y, x) => angle(&at(y), &at(x)),
                Node::Binary(op, a, b) => apply(op, &at(a), &at(b)),
            };
            let known = self.not_negative.contains(&node);
            values.insert(node, if known { value.narrowed(upwards().range()) } else { value });
        }
        values.get(&e).copied().unwrap_or(Decorated::UNKNOWN)
    }
}

/// atan2(y, x): beyond what the operation says, by the signs of both.
fn angle(y: &Decorated, x: &Decorated) -> Decorated {
    let plain = apply(Op::Arctan2, y, x);
    // Where x ≥ 0 and (x, y) is not the origin, the angle is in [−π/2, π/2]; where y ≥ 0, in [0, π].
    let right = apply(Op::Arctan, &Decorated::UNKNOWN, &Decorated::UNKNOWN);
    let mut out = plain;
    if x.range().lo() >= 0.0 {
        out = out.narrowed(right.range());
    }
    if y.range().lo() >= 0.0 {
        out = out.narrowed(upwards().range());
    }
    out
}
