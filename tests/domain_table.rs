//! The table of domains against the operations themselves: where they have values, how large these are, how they move.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use rederive::expr::Graph;
use rederive::expr::domain::{Bound, Change, Order, Place, Sides, Sign, Slope, Term, row};
use rederive::number::{NoValue, Op};

/// Arguments: numbers of all sizes and signs, and everything that is special somewhere.
fn arguments() -> Vec<f64> {
    let mut out: Vec<f64> = (-64..=64).map(|k| f64::from(k) / 16.0).collect();
    out.extend([1e-9, -1e-9, 1e-3, -1e-3, 0.999_999, 1.000_001, 17.3, -17.3]);
    out
}

fn value(op: Op, a: f64, b: f64) -> Result<f64, NoValue> {
    let mut out = 0.0;
    op.apply(&(), &mut out, &a, &b).map(|()| out)
}

fn term(term: Term, a: f64, b: f64) -> f64 {
    match term {
        Term::First => a,
        Term::Second => b,
        Term::Opposite => -b,
        Term::Cosine => a.cos(),
        Term::Sine => a.sin(),
        Term::Unit => (1.0 - a) * (1.0 + a),
        Term::Excess => a - 1.0,
        Term::Product => a * b,
        Term::Squares => a * a + b * b,
        Term::Support => a + b + b.abs(),
    }
}

/// Every operation of the table, and powers of all kinds.
fn operations() -> Vec<Op> {
    let mut out = Op::EVERY.to_vec();
    out.extend([-3, -1, 0, 2, 4, 5].map(Op::Powi));
    out
}

fn pairs(op: Op) -> Vec<(f64, f64)> {
    let all = arguments();
    match op.arity() {
        1 => all.iter().map(|&a| (a, a)).collect(),
        _ => all.iter().flat_map(|&a| all.iter().map(move |&b| (a, b))).collect(),
    }
}

#[test]
fn an_operation_has_a_value_exactly_where_its_needs_are_met() {
    let (mut with, mut without) = (0, 0);
    for op in operations() {
        for (a, b) in pairs(op) {
            let met = row(op).needs.iter().all(|&(t, sign)| {
                let x = term(t, a, b);
                match sign {
                    Sign::Positive => x > 0.0,
                    Sign::NotNegative => x >= 0.0,
                    Sign::NotZero => x != 0.0,
                }
            });
            let found = value(op, a, b);
            assert_eq!(found.is_ok(), met, "{op:?} of {a}, {b}: {found:?}");
            *(if met { &mut with } else { &mut without }) += 1;
        }
    }
    assert!(with > 10_000 && without > 10_000, "{with} values, {without} holes");
}

#[test]
fn every_value_lies_in_the_range() {
    let number = |b: Bound| f64::from(b.whole) + f64::from(b.quarter_turns) * std::f64::consts::FRAC_PI_2;
    let mut looked = 0;
    for op in operations() {
        let range = row(op).range;
        for (a, b) in pairs(op) {
            let Ok(x) = value(op, a, b) else { continue };
            // A limit may be the nearest number to a value.
            assert!(range.low.is_none_or(|l| x >= number(l)), "{op:?} of {a}, {b} is {x}");
            assert!(range.high.is_none_or(|h| x <= number(h)), "{op:?} of {a}, {b} is {x}");
            looked += 1;
        }
        let bounded = range.low.is_some() && range.high.is_some();
        assert_eq!(row(op).is_bounded(), bounded);
    }
    assert!(looked > 10_000);
}

#[test]
fn slopes_have_the_signs_of_their_terms() {
    let mut looked = 0;
    for op in operations() {
        for (a, b) in pairs(op) {
            for (which, slope) in row(op).slopes.into_iter().enumerate().take(op.arity()) {
                let h = 1e-6;
                let at = |x: f64| if which == 0 { value(op, a + x, b) } else { value(op, a, b + x) };
                let (Ok(low), Ok(high)) = (at(-h), at(h)) else { continue };
                let sign = |t: Term| {
                    let at = |x: f64| if which == 0 { term(t, a + x, b) } else { term(t, a, b + x) };
                    (at(-h) * at(h) > 0.0).then(|| at(0.0).signum())
                };
                let expected = match slope {
                    Slope::Flat => Some(0.0),
                    Slope::Rising => Some(1.0),
                    Slope::Falling => Some(-1.0),
                    Slope::Of(t) => sign(t),
                    Slope::Against(t) => sign(t).map(|s| -s),
                };
                // Over an edge, or where the value does not change by more than its rounding, nothing can be seen.
                let (Some(expected), Ok(here)) = (expected, value(op, a, b)) else { continue };
                let change = high - low;
                if change.abs() <= 1e-14 * (1.0 + here.abs()) || low.abs() + high.abs() > 1e4 {
                    continue;
                }
                let crossed = row(op).edges.iter().any(|e| match e.place {
                    Place::Zero(t) | Place::ZeroWhile(t, _) => {
                        let at = |x: f64| if which == 0 { term(t, a + x, b) } else { term(t, a, b + x) };
                        at(-h) * at(h) <= 0.0
                    }
                    Place::Infinity => false,
                });
                if !crossed {
                    assert_eq!(change.signum(), expected, "{op:?} by its argument {which} at {a}, {b}");
                    looked += 1;
                }
            }
        }
    }
    assert!(looked > 10_000, "{looked}");
}

/// The value beside an edge of an operation of one argument, on one side of it, closer and closer.
fn beside(op: Op, edge: f64, side: f64) -> Vec<f64> {
    (8..16).filter_map(|k| value(op, edge + side * 0.5_f64.powi(k), 0.0).ok()).collect()
}

#[test]
fn edges_are_of_their_kind() {
    let mut looked = 0;
    for op in operations().into_iter().filter(|op| op.arity() == 1) {
        for edge in row(op).edges {
            let Place::Zero(t) = edge.place else { continue };
            let at = match t {
                Term::First => 0.0,
                Term::Cosine => std::f64::consts::FRAC_PI_2,
                Term::Unit => 1.0,
                other => panic!("no edge of one argument is where {other:?} vanishes"),
            };
            let (left, right) = (beside(op, at, -1.0), beside(op, at, 1.0));
            let ratio = |xs: &[f64]| xs.windows(2).last().map(|w| w[1] / w[0]);
            let differences = |xs: &[f64]| xs.windows(2).map(|w| w[1] - w[0]).collect::<Vec<f64>>();
            match edge.change {
                Change::Pole(Order::Whole(n), sides) => {
                    let (l, r) = (ratio(&left).expect("values"), ratio(&right).expect("values"));
                    let grows = 2.0_f64.powi(n as i32);
                    assert!((l / grows - 1.0).abs() < 1e-3 && (r / grows - 1.0).abs() < 1e-3, "{op:?}: {l}, {r}");
                    assert_eq!(left[7].signum() == right[7].signum(), sides == Sides::Alike, "{op:?}");
                }
                Change::Log => {
                    let d = differences(&right);
                    assert!((d[6] / d[5] - 1.0).abs() < 1e-9 && d[6] != 0.0, "{op:?}");
                }
                Change::Kink => {
                    let (l, r) = (differences(&left), differences(&right));
                    assert!(l[6] * r[6] > 0.0, "{op:?}: both sides rise or fall towards the edge");
                }
                Change::Steep => {
                    let inner = if left.len() == 8 { left } else { right };
                    let d = differences(&inner);
                    // The slope grows: differences shrink by less than the half.
                    assert!((d[6] / d[5]).abs() > 0.6, "{op:?}");
                }
                Change::Pole(Order::Exponent, _) | Change::Jump(_) => panic!("{op:?} has one argument"),
            }
            looked += 1;
        }
    }
    assert!(looked >= 9, "{looked}");
    // Those of two arguments.
    let jump =
        |b: f64| value(Op::Arctan2, 1e-12, b).expect("a value") - value(Op::Arctan2, -1e-12, b).expect("a value");
    assert!((jump(-1.0) - 2.0 * std::f64::consts::PI).abs() < 1e-9 && jump(1.0).abs() < 1e-9);
    assert!(value(Op::Arctan2, 0.0, -1.0).expect("a value") > 3.0, "the value from where y ≥ 0");
    assert!(value(Op::Agm, 1e-12, 1.0).expect("a value") > 1e-3, "steep");
}

#[test]
fn needs_and_edges_of_a_node_are_expressions_of_the_graph() {
    let mut graph = Graph::new();
    let two = graph.integer(2);
    let third = graph.constant("1/3".parse().expect("a number"));
    let (power, minus) = (graph.binary(Op::Pow, two, third), graph.integer(-1));
    let needs = graph.needs(power);
    assert_eq!(needs.len(), 1, "an exponent that is a positive number asks for one thing");
    assert_eq!((needs[0].value, needs[0].sign), (two, Sign::NotNegative));
    let below = graph.mul(minus, third);
    let power = graph.binary(Op::Pow, two, below);
    assert_eq!(graph.needs(power)[0].sign, Sign::Positive);
    let quotient = graph.binary(Op::Div, power, power);
    let all = graph.needs_below([quotient]);
    assert_eq!(all.len(), 2);
    assert_eq!(graph.edges(quotient)[0].vanishing, Some(power));
    assert!(graph.edges(quotient)[0].is_pole() && !graph.edges(power)[1].is_pole());
}
