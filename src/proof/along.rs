//! Identities in time alone: what an equation is along a motion that is given by formulas.
//!
//! **In:** two sides in which time is the only leaf, what else must have a value, what selects the times that count, and a
//! span. **Out:** [`Along`]: both sides agree wherever they have values; or they differ for certain at a time of the span;
//! or neither was shown.
//!
//! **Guaranteed.** That sides agree is an identity, with the error bound of [`identity_test`](super::identity_test). That they
//! differ is shown at a time that is a number of binary64, at which every formula has a value: by rational numbers, at the ends of
//! the span, or by balls that lie apart. For these the difference is computed twice: as it is written, and with its sums and products
//! expanded over the generators, so that terms that cancel along the motion, however large, are gone before a number is put in; and
//! divided by its largest coefficient, so that what is too small for binary64 has a sign.

use super::conditions::raised;
use super::generators::Generators;
use super::linear::{Combination, Combinations, expression};
use super::lowering::lower;
use super::memory::Memory;
use super::outcome::{Identity, Options, Premises, Wanted};
use super::prove::identity_test_after;
use super::witness::{Decimals, Values};
use expr::domain::Sign;
use expr::{Expr, FastMap, Graph, Leaf, Rational};
use number::Bounded;

/// Which differences of the sides make a relation false.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Refuted {
    /// Any: an equation.
    #[default]
    Apart,
    /// left > right.
    Above,
    /// left < right.
    Below,
}

/// What is asked.
#[derive(Clone, Debug, Default)]
pub struct InTime {
    /// The time: the only leaf of what follows.
    pub time: Option<Leaf>,
    /// First and last time; finite.
    pub span: (f64, f64),
    /// The sides of the relation.
    pub sides: Option<(Expr, Expr)>,
    /// What makes it false; only of an equation it is asked whether the sides agree.
    pub refuted: Refuted,
    /// What must have a value beside the sides: the states, and the observables whose rates occur.
    pub needs: Vec<Expr>,
    /// Times count at which these are what is asked of them.
    pub guards: Vec<(Expr, Sign)>,
}

/// A time at which two sides differ for certain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apart {
    /// The time.
    pub time: f64,
    /// Left side there, as far as binary64 shows it: a difference that is smaller than its numbers is not in it.
    pub left: f64,
    /// Right side there.
    pub right: f64,
    /// How far the difference may be from that of these two.
    pub bound: f64,
}

/// What an equation is along a motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Along {
    /// Both sides agree at every time at which they have values.
    Agree {
        /// Whether the identity has no condition at all: nothing in it lacks a value at any time.
        everywhere: bool,
        /// A time that counts and at which both sides have values, with the value, if one was seen.
        seen: Option<(f64, Bounded)>,
    },
    /// They do not.
    Differ(Apart),
    /// Neither was shown.
    Open,
}

/// Times that are looked at.
const TIMES: u32 = 64;
/// Times at which it is seen first whether the sides differ: then nobody need ask whether they are an identity.
const FIRST_TIMES: u32 = 3;

/// Decides an equation along a motion that is given by formulas.
pub fn along(memory: &mut Memory, graph: &mut Graph, question: &InTime) -> Along {
    let (Some(time), Some((left, right))) = (question.time, question.sides) else { return Along::Open };
    let all = [left, right].into_iter().chain(question.needs.iter().copied());
    let guards = question.guards.iter().map(|&(e, _)| e);
    if graph.leaves(all.chain(guards)).iter().any(|&l| l != time) {
        return Along::Open;
    }
    let mut formulas = question.needs.clone();
    formulas.extend([left, right]);
    let domain: Vec<(Expr, Sign)> =
        graph.needs_below(formulas.iter().copied()).into_iter().map(|n| (n.value, n.sign)).collect();
    let place = |at: u32| {
        let (from, to) = question.span;
        // The ends, the middle, and what is no simple fraction of the span.
        match at {
            0 => from,
            1 => to,
            _ => from + (to - from) * ((f64::from(at) * 0.618_033_988_749_894_9).fract()),
        }
    };
    // The sides at a time at which, for certain, everything has a value: a ball that reaches out of a domain has values only
    // where it does not.
    let mut sides_at = SidesAt::of(graph, question, time, (left, right));
    let mut domain = Asked::of(graph, &domain);
    let mut sides_for_certain = |sides_at: &mut SidesAt, t: f64| {
        let sides = sides_at.at(t)?;
        domain.are_met(&values_at(time, t)).then_some(sides)
    };
    let mut differ = || {
        (0..FIRST_TIMES).map(place).any(|t| {
            let sides = sides_for_certain(&mut sides_at, t);
            sides.is_some_and(|(l, r)| lie_apart(l.value - r.value, l.error + r.error))
        })
    };
    let options = Options { attempts: 1, wanted: Wanted::Proof, ..Options::default() };
    let agrees = match left == right {
        _ if question.refuted != Refuted::Apart => None,
        false if differ() => None,
        true => Some(Vec::new()),
        false => match identity_test_after(memory, graph, &[(left, right)], &Premises::default(), &options) {
            Identity::Proved(proof) => Some(proof.conditions),
            Identity::Refuted(_) | Identity::Undecided(_) => None,
        },
    };
    if let Some(conditions) = agrees {
        let seen = (0..TIMES).map(place).find_map(|t| {
            let (l, r) = sides_at.at(t)?;
            Some((t, if l.error < r.error { l } else { r }))
        });
        let everywhere = conditions.is_empty() && super::domains(graph, &formulas).is_empty();
        return Along::Agree { everywhere, seen };
    }
    // At the ends everything may be a rational number.
    let exact = [0, 1].into_iter().find_map(|at| {
        let t = place(at);
        let (l, r) = exactly_at(graph, question, time, t)?;
        let refutes = match question.refuted {
            Refuted::Apart => l != r,
            Refuted::Above => l > r,
            Refuted::Below => l < r,
        };
        let [left, right] = [&l, &r].map(|q| q.to_f64().value());
        let bound = f64::EPSILON * (left.abs() + right.abs());
        refutes.then_some(Apart { time: t, left, right, bound })
    });
    if let Some(exact) = exact {
        return Along::Differ(exact);
    }
    let expanded = expanded(graph, left, right);
    let mut expanded = expanded.map(|(e, unit)| (Decimals::of(graph, &[e]), unit));
    let apart = (0..TIMES).map(place).find_map(|t| {
        let (l, r) = sides_for_certain(&mut sides_at, t)?;
        let refutes = |difference: f64, error: f64| {
            lie_apart(difference, error)
                && match question.refuted {
                    Refuted::Apart => true,
                    Refuted::Above => difference > 0.0,
                    Refuted::Below => difference < 0.0,
                }
        };
        let error = l.error + r.error;
        if refutes(l.value - r.value, error) {
            return Some(Apart { time: t, left: l.value, right: r.value, bound: error });
        }
        // What is left when everything that cancels is gone.
        let (expanded, unit) = expanded.as_mut()?;
        let rest = expanded.at(&values_at(time, t))[0]?;
        let left = r.value + rest.value * *unit;
        refutes(rest.value, rest.error).then_some(Apart { time: t, left, right: r.value, bound: rest.error * *unit })
    });
    apart.map_or(Along::Open, Along::Differ)
}

/// Whether a difference with this error is not 0.
fn lie_apart(difference: f64, error: f64) -> bool {
    difference.is_finite() && error.is_finite() && difference.abs() > 2.0 * error
}

/// A time, as the value of its leaf.
fn values_at(time: Leaf, at: f64) -> Values {
    FastMap::from_iter([(time, Bounded::exact(at))])
}

/// Terms with what is asked of them.
struct Asked<'a> {
    terms: Decimals,
    asked: &'a [(Expr, Sign)],
}

impl<'a> Asked<'a> {
    fn of(graph: &Graph, asked: &'a [(Expr, Sign)]) -> Asked<'a> {
        let terms: Vec<Expr> = asked.iter().map(|&(e, _)| e).collect();
        Asked { terms: Decimals::of(graph, &terms), asked }
    }

    /// Whether they are, at a time, what is asked of them, for certain.
    fn are_met(&mut self, values: &Values) -> bool {
        let found = self.terms.at(values).into_iter().zip(self.asked);
        found.into_iter().all(|(v, (_, sign))| v.is_some_and(|v| sign.is_certain_of(v)))
    }
}

/// Both sides, with what must have a value and what selects the times, compiled for many times.
struct SidesAt<'a> {
    time: Leaf,
    needs: Decimals,
    guards: Asked<'a>,
    sides: Decimals,
}

impl<'a> SidesAt<'a> {
    fn of(graph: &Graph, question: &'a InTime, time: Leaf, (left, right): (Expr, Expr)) -> SidesAt<'a> {
        let [needs, sides] = [question.needs.as_slice(), &[left, right]].map(|of| Decimals::of(graph, of));
        SidesAt { time, needs, guards: Asked::of(graph, &question.guards), sides }
    }

    /// The sides at a time that counts, at which everything has a value; `None` otherwise.
    fn at(&mut self, t: f64) -> Option<(Bounded, Bounded)> {
        let values = values_at(self.time, t);
        let counts = self.needs.at(&values).iter().all(Option::is_some) && self.guards.are_met(&values);
        let sides = if counts { self.sides.at(&values) } else { return None };
        sides[0].zip(sides[1])
    }
}

/// Both sides at a time that counts, at which everything is a rational number; `None` otherwise.
fn exactly_at(graph: &mut Graph, question: &InTime, time: Leaf, at: f64) -> Option<(Rational, Rational)> {
    let (left, right) = question.sides?;
    let at = Rational::try_from(at).ok()?;
    let at = graph.constant(at);
    let mut value = |e: Expr| {
        let then = graph.substitute(e, |_, l| (l == time).then_some(at));
        graph.as_constant(then).cloned()
    };
    let sides = (value(left)?, value(right)?);
    let counts = question.needs.iter().all(|&e| value(e).is_some())
        && question.guards.iter().all(|&(e, sign)| value(e).is_some_and(|v| sign.is_of(&v)));
    counts.then_some(sides)
}

/// left − right with all sums and products expanded over the generators, written in the formulas as given, divided by its
/// largest coefficient; and that coefficient.
fn expanded(graph: &mut Graph, left: Expr, right: Expr) -> Option<(Expr, f64)> {
    let mut combinations = Combinations::default();
    let lowered = lower(graph, &[], &[(left, right)], [&[], &[], &[]], &[], [false; 2], &mut combinations).ok()?;
    let &(l, r) = lowered.claim.first()?;
    let difference = graph.sub(l, r);
    let combination: Combination = Combinations::default().of(graph, difference);
    let size = |q: &Rational| if *q < Rational::ZERO { -q.clone() } else { q.clone() };
    let unit = combination.values().map(size).max()?;
    let mut sum = graph.integer(0);
    for (monomial, q) in &combination {
        let term = expression(graph, monomial, &(q.clone() / unit.clone()));
        sum = graph.add(sum, term);
    }
    let generators: &Generators = &lowered.generators;
    Some((raised(graph, generators, sum), unit.to_f64().value()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use expr::{Op, Shape};

    /// A graph with the time t, and e^{−t}.
    fn decaying() -> (Graph, Leaf, Expr) {
        let mut g = Graph::new();
        let t = g.declare("t", Shape::scalar(), false);
        let time = Leaf::now(t, 0);
        let node = g.leaf(time);
        let minus = g.neg(node);
        let f = g.unary(Op::Exp, minus);
        (g, time, f)
    }

    fn ask(g: &mut Graph, time: Leaf, span: (f64, f64), sides: (Expr, Expr)) -> Along {
        let question = InTime { time: Some(time), span, sides: Some(sides), ..InTime::default() };
        along(&mut Memory::default(), g, &question)
    }

    #[test]
    fn what_cancels_is_gone_before_numbers_are_put_in() {
        let (mut g, time, f) = decaying();
        let rate = g.time_derivative(f, time, |_| false).expect("elementary");
        let sum = g.add(rate, f);
        let zero = g.integer(0);
        assert!(matches!(ask(&mut g, time, (-100.0, -33.0), (sum, zero)), Along::Agree { everywhere: true, .. }));
        let little = g.constant(expr::Rational::from(37) / expr::Rational::from(100));
        match ask(&mut g, time, (-100.0, -33.0), (sum, little)) {
            Along::Differ(apart) => assert!(apart.right == 0.37 && apart.bound < 1e-12, "{apart:?}"),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn an_identity_of_positive_times_does_not_differ_on_them() {
        let (mut g, time, _) = decaying();
        let t = g.leaf(time);
        let size = g.unary(Op::Abs, t);
        assert_eq!(ask(&mut g, time, (1.0, 2.0), (size, t)), Along::Open);
        assert!(matches!(ask(&mut g, time, (-1.0, 2.0), (size, t)), Along::Differ(a) if a.time < 0.0));
    }

    #[test]
    fn what_has_no_value_does_not_differ() {
        let (mut g, time, _) = decaying();
        let t = g.leaf(time);
        let root = g.unary(Op::Sqrt, t);
        let one = g.integer(1);
        assert_eq!(ask(&mut g, time, (-2.0, -1.0), (root, one)), Along::Open);
        let question = InTime {
            time: Some(time),
            span: (-2.0, -1.0),
            sides: Some((t, one)),
            needs: vec![root],
            ..InTime::default()
        };
        assert_eq!(along(&mut Memory::default(), &mut g, &question), Along::Open);
    }
}
