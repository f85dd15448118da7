//! Values of expressions on motions that are given by formulas: against these, facts are tried.

use super::formula::*;
use crate::draft::{Case, Draft};
use crate::needs::Need;
use crate::sequent::SymbolKind;
use crate::term::Sense;
use crate::*;
use expr::domain::Sign;
use expr::{Expr, Node, Op};
use number::NoValue;
use std::collections::BTreeMap;

/// The rates of a function at a time: f, f′, f″, f‴.
pub(super) type Jet = fn(f64) -> [f64; 4];

/// A motion: functions by names of symbols, numbers of constants.
#[derive(Clone)]
pub(super) struct Numbers {
    pub(super) functions: Vec<(&'static str, Jet)>,
    pub(super) constants: Vec<(&'static str, f64)>,
}

/// Smaller numbers are taken for 0: times and coefficients are chosen so that what is not 0 is larger.
const TINY: f64 = 1e-10;
/// Larger numbers are not told from others: nothing is said of them.
const HUGE: f64 = 1e4;
/// An interval around a time.
const BESIDE: [f64; 5] = [-0.01, -0.005, 0.0, 0.005, 0.01];
/// A difference of this size refutes an equation.
const DIFFERENCE: f64 = 1e-7;

fn number(r: &expr::Rational) -> f64 {
    r.to_f64().value()
}

impl Numbers {
    /// The value at a time; nothing where it has none; NaN where it is too large to be told.
    pub(super) fn value(&self, draft: &Draft, e: Expr, t: f64) -> Option<f64> {
        let graph = &draft.context.graph;
        let mut found: BTreeMap<Expr, Option<f64>> = BTreeMap::new();
        for node in graph.reachable([e]) {
            let made = match *graph.node(node) {
                Node::Constant(ref r) => Some(number(r)),
                Node::Pi => Some(std::f64::consts::PI),
                Node::Leaf(leaf) => {
                    let name = graph.name(leaf.symbol);
                    let time = match leaf.instant {
                        Some(c) => self.value(draft, c, t)?,
                        None => t,
                    };
                    match draft.context.kind(leaf) {
                        SymbolKind::Time => Some(time),
                        SymbolKind::Constant(_) => self.constants.iter().find(|c| c.0 == name).map(|c| c.1),
                        SymbolKind::Coordinate | SymbolKind::Field(_) => None,
                        SymbolKind::Moves(_) | SymbolKind::Defined => {
                            let f = self.functions.iter().find(|f| f.0 == name)?.1;
                            f(time).get(usize::from(leaf.rate)).copied()
                        }
                    }
                }
                Node::Unary(op, a) => found[&a].and_then(|a| operation(op, a, a)),
                Node::Binary(op, a, b) => found[&a].zip(found[&b]).and_then(|(a, b)| operation(op, a, b)),
            };
            // What is neither 0, up to rounding, nor a number of a usual size is not told.
            let usual = |v: f64| v.abs() < 1e-12 || v.abs() > TINY && v.abs() < HUGE;
            let grows = match *graph.node(node) {
                Node::Unary(Op::Exp, _) => true,
                Node::Unary(Op::Powi(_), a) => found[&a].is_some_and(|a| a.abs() > TINY),
                Node::Binary(Op::Mul | Op::Div | Op::Pow, a, b) => {
                    [a, b].iter().all(|e| found[e].is_some_and(|v| v.abs() > TINY))
                }
                Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => false,
            };
            found.insert(node, made.map(|v| if usual(v) && !(grows && v.abs() < TINY) { v } else { f64::NAN }));
        }
        found[&e]
    }

    fn holds(&self, draft: &Draft, need: Need, t: f64) -> bool {
        self.value(draft, need.value, t).is_some_and(|v| match need.sign {
            Sign::Positive => v > TINY,
            Sign::NotNegative => v >= -TINY,
            Sign::NotZero => v.abs() > TINY,
        })
    }

    /// Whether a relation is true at a time; nothing where a side has no value.
    fn is_true(&self, draft: &Draft, left: Expr, sense: Sense, right: Expr, t: f64, tiny: f64) -> Option<bool> {
        let (l, r) = (self.value(draft, left, t)?, self.value(draft, right, t)?);
        let (d, tiny) = (l - r, tiny * (1.0 + l.abs() + r.abs()));
        if d.is_nan() {
            return Some(true);
        }
        Some(match sense {
            Sense::Equal => d.abs() <= tiny,
            Sense::NotEqual => d.abs() > tiny,
            Sense::Less => d < -tiny,
            Sense::LessOrEqual => d <= tiny,
        })
    }

    fn in_case(&self, draft: &Draft, case: &Case, inner: &When, t: f64) -> bool {
        let at = |t: f64| {
            let supposed = match case.says {
                Some(says) => self.is_true(draft, says.left, says.sense, says.right, t, TINY) == Some(true),
                None => draft.claim_needs.iter().all(|need| self.holds(draft, *need, t)),
            };
            supposed && self.within(draft, inner, t)
        };
        match case.manner {
            Manner::AtTimes => at(t),
            Manner::OnIntervals => BESIDE.into_iter().all(|d| at(t + d)),
        }
    }

    fn chosen(&self, draft: &Draft, t: f64) -> bool {
        let selects = |s: &crate::context::Says| self.is_true(draft, s.left, s.sense, s.right, t, TINY) == Some(true);
        let has_values = |s: &crate::context::Says| s.sides().iter().all(|e| self.value(draft, *e, t).is_some());
        draft.context.selectors.iter().all(selects) && draft.context.assumed.iter().all(has_values)
    }

    fn within(&self, draft: &Draft, when: &When, t: f64) -> bool {
        match when {
            When::At(_) | When::Always => true,
            When::Chosen | When::ChosenOpen => self.chosen(draft, t),
            When::In(case, inner) => self.in_case(draft, &draft.cases[case.0 as usize], inner, t),
        }
    }

    /// Whether the suppositions of all cases have values that can be told.
    fn is_told(&self, draft: &Draft, when: &When, t: f64) -> bool {
        match when {
            When::In(case, inner) => {
                let case = &draft.cases[case.0 as usize];
                let sides = case.says.map(|s| s.sides().to_vec()).unwrap_or_default();
                let beside: &[f64] = match case.manner {
                    Manner::AtTimes => &[0.0],
                    Manner::OnIntervals => &BESIDE,
                };
                beside.iter().all(|d| {
                    let told = |e: &Expr| self.value(draft, *e, t + d).is_none_or(|v| !v.is_nan());
                    sides.iter().all(told) && self.is_told(draft, inner, t + d)
                })
            }
            When::At(_) | When::Chosen | When::ChosenOpen | When::Always => true,
        }
    }

    /// A time at which a fact is wrong.
    pub(super) fn refutes(&self, draft: &Draft, id: FactId, times: &[f64]) -> Option<f64> {
        let fact = draft.fact(id)?;
        if !times.iter().any(|t| self.chosen(draft, *t)) {
            return None;
        }
        times.iter().copied().find(|&t| {
            let applies =
                self.within(draft, &fact.when, t) && fact.needs.iter().all(|need| self.holds(draft, *need, t));
            let says = fact.says;
            // A number that is too large somewhere says nothing.
            let tiny = if matches!(says.sense, Sense::Equal | Sense::LessOrEqual) { DIFFERENCE } else { TINY };
            let told = |e: &Expr| self.value(draft, *e, t).is_none_or(|v| !v.is_nan());
            applies
                && self.is_told(draft, &fact.when, t)
                && says.sides().iter().all(told)
                && self.is_true(draft, says.left, says.sense, says.right, t, tiny) != Some(true)
        })
    }
}

/// A value of an operation; what has rounding errors beside a whole number is that number.
fn operation(op: Op, a: f64, b: f64) -> Option<f64> {
    if a.is_nan() || b.is_nan() {
        return Some(f64::NAN);
    }
    let snapped = |v: f64| if (v - v.round()).abs() < 1e-12 { v.round() } else { v };
    let mut out = 0.0;
    match op.apply(&(), &mut out, &snapped(a), &snapped(b)) {
        Ok(()) => Some(snapped(out)),
        Err(NoValue::OutOfDomain) => None,
        Err(NoValue::Indeterminate | NoValue::Unsupported) => Some(f64::NAN),
    }
}

/// Every law, on numbers: where all needs hold, both sides have values, and they are equal.
#[test]
fn laws_hold_on_numbers() {
    let zero: Vec<(&str, Jet)> = vec![];
    let values = [-3.0, -1.5, -1.0, -0.25, 0.0, 0.5, 1.0, 1.25, 2.0];
    // A law of whole numbers is about numbers that are written.
    let powers = [["a", "b", "3"], ["a", "b", "-2"], ["a", "1/3", "3"], ["a", "2/3", "-3"], ["a", "-1/2", "4"]];
    for &law in Law::ALL {
        let mut s = sequent("", 0, "0=0");
        for name in ["a", "b", "c"] {
            s = s.constant(name, ConstantSign::Any);
        }
        let mut w = Work::new(&s);
        let plain = [["a", "b", "c"]];
        let about: &[[&str; 3]] = if law == Law::PowerOfPower { &powers } else { &plain };
        for of in about {
            let of: Vec<Term> = of.iter().take(law.arity()).map(|n| term(n)).collect();
            let id = w.step(Step::Law { law, of });
            let mut applied = 0;
            for at in 0..values.len().pow(3) {
                let [a, b, c] = [0, 1, 2].map(|place| values[at / values.len().pow(place) % values.len()]);
                let n = Numbers { functions: zero.clone(), constants: vec![("a", a), ("b", b), ("c", c)] };
                let fact = w.0.fact(id).unwrap();
                assert!(fact.says.left != fact.says.right, "{law:?} says nothing");
                applied += usize::from(fact.needs.iter().all(|need| n.holds(&w.0, *need, 0.0)));
                assert_eq!(n.refutes(&w.0, id, &[0.0]), None, "{law:?}: {} at {a} {b} {c}", w.0.words(id));
            }
            assert!(applied > 20, "{law:?} is never applied");
        }
    }
}

/// The derivative of every operation, on numbers.
#[test]
fn derivatives_are_those_of_differences() {
    let jet: Jet = |t| [0.3 * t + 0.1 * t * t, 0.3 + 0.2 * t, 0.2, 0.0];
    let other: Jet = |t| [0.7 - 0.2 * t * t, -0.4 * t, -0.4, 0.0];
    let motion = Numbers { functions: vec![("x", jet), ("y", other)], constants: vec![] };
    let texts = [
        "-x",
        "sqrt(x)",
        "exp(x)",
        "ln(x)",
        "sin(x)",
        "cos(x)",
        "tan(x)",
        "arcsin(x)",
        "arccos(x)",
        "arctan(x)",
        "sinh(x)",
        "cosh(x)",
        "tanh(x)",
        "abs(x)",
        "x^3",
        "1/x^2",
        "x+y",
        "x-y",
        "x*y",
        "x/y",
        "x^y",
        "y^(1/3)",
        "atan2(x,y)",
        "atan2(y,x)",
        "restrict(x,y)",
        "t*x",
        "x^0",
    ];
    for text in texts {
        let mut w = Work::new(&sequent("x,y", 2, "0=0"));
        let e = w.0.context.read(&term(text)).unwrap();
        let d = crate::derivative::derivative(&mut w.0.context, e).unwrap();
        let smooth = crate::needs::smooth(&mut w.0.context, e);
        let mut tried = 0;
        for t in [-2.5, -1.0, 0.25, 0.5, 1.0, 1.5, 2.5] {
            if !smooth.iter().all(|need| motion.holds(&w.0, *need, t)) {
                continue;
            }
            let at = |t: f64| motion.value(&w.0, e, t).expect("a value beside a time at which it is smooth");
            let quotient = (at(t + 1e-5) - at(t - 1e-5)) / 2e-5;
            let exact = motion.value(&w.0, d, t).expect("a derivative");
            assert!((quotient - exact).abs() < 1e-5 * (1.0 + exact.abs()), "{text} at {t}: {quotient} {exact}");
            tried += 1;
        }
        assert!(tried > 1, "{text}");
    }
}
