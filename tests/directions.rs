//! Sine, cosine and tangent of angles without the angles: the same values as with them, in every number type, at the origin, on
//! the axes, on the cut, with tiny and with huge arguments.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use num_dual::{Dual, Dual64};
use rederive::expr::{Expr, Graph, Leaf, Op, Rational, Shape};
use rederive::number::{Bounded, Interval, Jet, Lanes, NoValue, Number, Orders};
use rederive::tape::Tape;

/// Formulas in y, x and w, as they are written and without angles.
struct Pair {
    name: String,
    plain: Tape,
    without: Tape,
    /// How much of w there is in the angle.
    of_w: f64,
}

fn pairs() -> Vec<Pair> {
    let mut g = Graph::new();
    let leaves: Vec<Leaf> =
        ["y", "x", "w"].map(|name| Leaf::now(g.declare(name, Shape::scalar(), false), 0)).into_iter().collect();
    let [y, x, w] = [0, 1, 2].map(|i| g.leaf(leaves[i]));
    let angle = g.binary(Op::Arctan2, y, x);
    let mut arguments: Vec<(String, Expr, f64)> = vec![("atan2".to_owned(), angle, 0.0)];
    let minus = g.neg(angle);
    arguments.push(("-atan2".to_owned(), minus, 0.0));
    for n in [2_i64, -3, 5] {
        let factor = g.constant(Rational::from(n));
        let multiple = g.mul(factor, angle);
        arguments.push((format!("{n} atan2"), multiple, 0.0));
        let less = g.sub(multiple, w);
        arguments.push((format!("{n} atan2 - w"), less, 1.0));
        let more = g.add(w, multiple);
        arguments.push((format!("w + {n} atan2"), more, 1.0));
    }
    let arc = g.unary(Op::Arctan, y);
    arguments.push(("arctan".to_owned(), arc, 0.0));
    let mut out = Vec::new();
    for (name, e, of_w) in arguments {
        for op in [Op::Sin, Op::Cos, Op::Tan] {
            let plain = g.unary(op, e);
            let without = g.without_angles(&[plain], &[])[0];
            let [plain, without] =
                [plain, without].map(|root| Tape::compile(&g, &leaves, &[root]).expect("all leaves are given"));
            let angles =
                |tape: &Tape| tape.instructions().iter().filter(|i| matches!(i.op, Op::Arctan2 | Op::Arctan)).count();
            assert!(angles(&plain) == 1 && angles(&without) == 0, "{op:?} {name}");
            out.push(Pair { name: format!("{op:?} {name}"), plain, without, of_w });
        }
    }
    out
}

/// y and x.
fn points() -> Vec<[f64; 2]> {
    let sizes = [0.0, 1e-300, 5e-324, 1e-160, 1e-8, 0.3, 1.0, 2.5, 1e8, 1e160, 1e300, f64::MAX];
    let signed: Vec<f64> = sizes.iter().flat_map(|&x| [x, -x]).collect();
    signed.iter().flat_map(|&y| signed.iter().map(move |&x| [y, x])).collect()
}

fn value<N: Number>(tape: &Tape, cx: &N::Context, inputs: [N; 3]) -> Result<N, NoValue> {
    let mut slots = tape.slots(cx);
    tape.evaluate(cx, &inputs.map(Ok), &mut slots).pop().expect("one output")
}

/// Numbers alone, in lanes, and with error bounds: the values are close, and where one has none for certain, so has the other.
#[test]
fn values_are_those_with_the_angle() {
    let mut compared = 0;
    for Pair { name, plain, without, .. } in pairs() {
        for [y, x] in points() {
            let inputs = [y, x, 0.7];
            let exact = inputs.map(Bounded::exact);
            let (old, new) = (value(&plain, &(), exact), value(&without, &(), exact));
            let told = |x: &Result<Bounded, NoValue>| *x == Err(NoValue::OutOfDomain);
            // The angle is rounded: at a pole of the tangent it has a value that is none.
            let pole = name.starts_with("Tan") && (old.as_ref().is_ok_and(|v| v.value.abs() > 1e12) || old.is_err());
            assert!(told(&old) == told(&new) || pole, "{name} at {y:e}, {x:e}: {old:?}, {new:?}");
            if name == "Tan atan2" {
                assert_eq!(told(&new), x == 0.0, "at {y:e}, {x:e}: {new:?}");
            }
            let number = value(&without, &(), inputs);
            let lanes = value(&without, &(), inputs.map(|x| Lanes([x, 0.5]))).expect("lanes never fail").0[0];
            assert!(number == Ok(lanes) || number.is_err() && lanes.is_nan(), "{name} at {y:e}, {x:e}");
            if let (Ok(old), Ok(new)) = (old, new) {
                let off = (old.value - new.value).abs();
                assert!(off <= old.error + new.error, "{name} at {y:e}, {x:e}: {old:?}, {new:?}");
                assert_eq!(number, Ok(new.value), "{name} at {y:e}, {x:e}");
                // What is known without the angle is known at least as well, but for a few roundings.
                let size = new.value.abs().max(1.0);
                assert!(new.error <= old.error + 2e-14 * size * size, "{name}: {old:?}, {new:?}");
                compared += 1;
            } else {
                assert!(new.is_ok() || old.is_err() || pole, "{name} at {y:e}, {x:e}: {old:?}, {new:?}");
            }
        }
    }
    assert!(compared > 15_000, "{compared}");
}

/// Balls and boxes: every value at a point of one lies in what is found for it, also across the cut.
#[test]
fn bounds_hold_across_the_cut() {
    let (mut compared, mut across) = (0, 0);
    for Pair { name, without, plain, .. } in pairs() {
        for centre in [[0.0_f64, -1.0], [1e-9, -2.0], [0.3, 0.4], [-0.2, 0.0], [1e-300, -1e-300], [3e299, -1e300]] {
            // An arctan has a size.
            if name.contains("arctan") && centre[0] == 1e-300 {
                continue;
            }
            for part in [1e-12_f64, 1e-3, 0.2] {
                let size = centre[0].abs().max(centre[1].abs());
                let radius = [part * size, 0.7 * part * size, part];
                let middle = [centre[0], centre[1], 0.7];
                let balls = [0, 1, 2].map(|i| Bounded::new(middle[i], radius[i]));
                let boxes = balls.map(|b| {
                    let (low, high) = (b.value - b.error, b.value + b.error);
                    Interval::new(low.next_down(), high.next_up()).expect("in order")
                });
                let (ball, range) = (value(&without, &(), balls), value(&without, &(), boxes));
                let steep = name.starts_with("Tan") || name.contains("arctan");
                assert!(steep || range.is_ok() || part > 0.1, "{name} around {centre:?}, {part}: {range:?}");
                across += usize::from(range.is_ok() && centre[0] == 0.0 && value(&plain, &(), boxes).is_err());
                for k in 0..25 {
                    let step = [f64::from(k % 5) / 2.0 - 1.0, f64::from(k / 5) / 2.0 - 1.0, f64::from(k % 3) - 1.0];
                    let at = [0, 1, 2].map(|i| middle[i] + 0.999 * step[i] * radius[i]);
                    let Ok(here) = value(&plain, &(), at.map(Bounded::exact)) else { continue };
                    if let Ok(ball) = ball {
                        let off = (here.value - ball.value).abs();
                        assert!(off <= ball.error * (1.0 + 1e-12) + here.error, "{name} at {at:?}: {here:?} {ball:?}");
                    }
                    if let Ok(range) = range {
                        let held = range.lo() <= here.value + here.error && here.value - here.error <= range.hi();
                        assert!(held, "{name} at {at:?}: {here:?} outside {range}");
                        compared += 1;
                    }
                }
            }
        }
    }
    assert!(compared > 5_000 && across > 20, "{compared}, {across}");
}

/// Slopes and series are those of a turning angle, also where it passes its cut.
#[test]
fn series_pass_the_cut() {
    let degree = 8;
    let all = Orders::all(degree);
    let mut compared = 0;
    for Pair { name, without, plain, of_w } in pairs() {
        if name.contains("arctan") {
            continue;
        }
        for turned in [0.0_f64, 0.4, 2.0, 3.0, -2.9] {
            for scale in [1.0, 1e-300, 1e300] {
                // (x, y) = ((1 + s)·cos(turned + s), (1 + s)·sin(turned + s)), as series in s.
                let wave = |phase: f64| {
                    let mut out = Jet::constant(0.0, &all);
                    let mut factorial = 1.0;
                    let mut before = 0.0;
                    for k in 0..=degree {
                        factorial *= (k as f64).max(1.0);
                        let c = (turned + phase + k as f64 * std::f64::consts::FRAC_PI_2).sin() / factorial;
                        out.set_coefficient(k, scale * (c + before));
                        before = c;
                    }
                    out
                };
                let (y, x) = (wave(0.0), wave(std::f64::consts::FRAC_PI_2));
                let w = Jet::variable(0.7, of_w, &all);
                let dual = [&y, &x, &w].map(|j| Dual64::new(j.coefficient(0), j.coefficient(1)));
                let Ok(series) = value(&without, &all, [y.clone(), x.clone(), w.clone()]) else {
                    panic!("{name} at {turned}, {scale:e}")
                };
                let by_dual = value(&without, &(), dual).expect("a slope");
                // A slope of 10³⁰⁰ is no matter for the dual number of the angle either.
                if let Ok(old) = value(&plain, &all, [y, x, w]) {
                    for k in 0..=degree {
                        let (a, b) = (old.coefficient(k), series.coefficient(k));
                        let size = (0..=k).map(|i| old.coefficient(i).abs()).fold(1.0, f64::max);
                        assert!((a - b).abs() <= 1e-9 * size * size, "{name} at {turned}, order {k}: {a:e}, {b:e}");
                    }
                    compared += 1;
                }
                let (a, b) = (series.coefficient(1), by_dual.eps);
                assert!((a - b).abs() <= 1e-11 * a.abs().max(1.0), "{name} at {turned}: {a:e}, {b:e}");
            }
        }
        // Over boxes that meet the cut there are slopes.
        let across = [(-0.1, 0.1, 1.0), (-1.1, -0.9, 0.0), (0.6, 0.8, of_w)]
            .map(|(lo, hi, d)| Dual::new(Interval::new(lo, hi).expect("in order"), Interval::point(d)));
        assert!(value(&without, &(), across).is_ok() || name.starts_with("Tan"), "{name}");
    }
    assert!(compared > 300, "{compared}");
}

/// Derivatives of the formulas: without the angle, there is one on its cut.
#[test]
fn derivatives_go_through_the_cut() {
    let mut g = Graph::new();
    let leaves = ["y", "x"].map(|name| Leaf::now(g.declare(name, Shape::scalar(), false), 0));
    let [y, x] = leaves.map(|leaf| g.leaf(leaf));
    let angle = g.binary(Op::Arctan2, y, x);
    let sine = g.unary(Op::Sin, angle);
    let without = g.without_angles(&[sine], &[])[0];
    let slope = g.partial_derivative(without, leaves[0]).expect("smooth");
    let tape = Tape::compile(&g, &leaves, &[slope]).expect("all leaves are given");
    let at = |y: f64, x: f64| tape.evaluate(&(), &[Ok(y), Ok(x)], &mut tape.slots(&())).pop().expect("one output");
    for [y, x] in [[0.0_f64, -1.0], [0.0, 2.0], [3.0, -4.0], [-3.0, 0.0]] {
        let r = y.hypot(x);
        let found = at(y, x).expect("a value");
        assert!((found - x * x / (r * r * r)).abs() < 1e-15, "{found}");
    }
    assert!(at(0.0, 0.0).is_err());
}

/// An angle and its turns: the turns are not asked.
#[test]
fn turns_do_not_matter() {
    let mut g = Graph::new();
    let leaves = ["y", "x", "turns"].map(|name| Leaf::now(g.declare(name, Shape::scalar(), false), 0));
    let [y, x, turns] = leaves.map(|leaf| g.leaf(leaf));
    let raw = g.binary(Op::Arctan2, y, x);
    let angle = g.add(raw, turns);
    let two = g.integer(2);
    let twice = g.mul(two, angle);
    let cosine = g.unary(Op::Cos, twice);
    let half = g.div(angle, two);
    let of_half = g.unary(Op::Sin, half);
    let found = g.without_angles(&[cosine, of_half, angle], &[(angle, raw)]);
    assert!(!g.leaves([found[0]]).contains(&leaves[2]));
    // The half of a turn is none.
    assert_eq!(found[1..], [of_half, angle]);
    let tape = Tape::compile(&g, &leaves[..2], &found[..1]).expect("no turns");
    let value = tape.evaluate(&(), &[Ok(0.6), Ok(-0.8)], &mut tape.slots(&())).pop().expect("one output");
    assert!((value.expect("a value") - (0.64 - 0.36)).abs() < 1e-15);
}
