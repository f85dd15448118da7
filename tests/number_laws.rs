//! One suite of laws for every number type and every operation of the table.
//!
//! Each law counts what it really compared, per number type and operation, and a count of 0 fails: a law that skips all its
//! cases proves nothing.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use dashu_float::{FBig, round::mode::HalfEven};
use num_dual::{Dual, Dual2, Dual2_64, Dual64};
use rederive::expr::{Expr, Graph, Leaf, Shape};
use rederive::number::{Bounded, DualLanes, Interval, Jet, Lanes, NoValue, Number, Op, Orders, Scalar};
use rederive::tape::Tape;
use std::collections::BTreeMap;

/// Xorshift: the same cases on every machine.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
    /// In [0, 1).
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
    /// 2^e for a real e, with a random sign.
    fn scaled(&mut self, low: f64, high: f64) -> f64 {
        let size = self.within(low, high).exp2();
        if self.bits() & 1 == 0 { size } else { -size }
    }
}

/// How many comparisons were made, for each number type (or law) and operation.
#[derive(Default)]
struct Tally(BTreeMap<(&'static str, Op), usize>);

impl Tally {
    fn count(&mut self, name: &'static str, op: Op) {
        *self.0.entry((name, op)).or_default() += 1;
    }
    /// Every name met every operation.
    fn require(&self, names: &[&'static str], except: &[Op]) {
        for &name in names {
            for &op in Op::EVERY.iter().filter(|op| !except.contains(op)) {
                assert!(self.0.contains_key(&(name, op)), "{name} never compared {op:?}");
            }
        }
    }
}

fn apply<N: Number>(op: Op, cx: &N::Context, a: &N, b: &N) -> Result<N, NoValue> {
    let mut out = N::blank(cx);
    op.apply(cx, &mut out, a, b).map(|()| out)
}

fn plain(op: Op, a: f64, b: f64) -> Result<f64, NoValue> {
    apply(op, &(), &a, &b)
}

/// Numbers at which functions change their behaviour.
const EDGES: [f64; 30] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    2.0,
    -2.0,
    3.0,
    1.0 - f64::EPSILON / 2.0,
    1.0 + f64::EPSILON,
    -1.0 - f64::EPSILON,
    std::f64::consts::PI,
    std::f64::consts::FRAC_PI_2,
    -std::f64::consts::FRAC_PI_4,
    1e-8,
    -1e-8,
    1e-160,
    1e160,
    -1e160,
    5e-324,
    -5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    710.0,
    -746.0,
    1e22,
    20.0,
    -36.7,
];

/// Pairs of arguments: all pairs of edges, and random pairs of all sizes.
fn arguments(random: &mut Random) -> Vec<(f64, f64)> {
    let mut all: Vec<(f64, f64)> = EDGES.iter().flat_map(|&a| EDGES.iter().map(move |&b| (a, b))).collect();
    for _ in 0..300 {
        all.push((random.scaled(-6.0, 6.0), random.scaled(-6.0, 6.0)));
        all.push((random.scaled(-2.0, 0.0), random.unit()));
        all.push((random.scaled(-1000.0, 1000.0), random.scaled(-40.0, 40.0)));
    }
    all
}

/// Coefficients of a series, for comparison with another type.
const DEGREE: usize = 5;

/// The value of constant arguments is that of `f64`, bit for bit, in every number type; and it exists exactly where that
/// of `f64` does.
#[test]
fn values_are_those_of_f64() {
    fn law<N: Number>(
        tally: &mut Tally,
        name: &'static str,
        cx: &N::Context,
        lift: impl Fn(f64) -> N,
        value: impl Fn(&N) -> f64,
    ) {
        for &op in Op::EVERY {
            for (a, b) in arguments(&mut Random(1)) {
                let got = apply(op, cx, &lift(a), &lift(b)).map(|x| value(&x));
                match (plain(op, a, b), got) {
                    (Ok(x), Ok(y)) => assert_eq!(x.to_bits(), y.to_bits(), "{name} {op:?}({a:e}, {b:e}): {x:e}, {y:e}"),
                    // Lanes have no error of their own.
                    (Err(_), Ok(y)) => {
                        assert!(name.contains("Lanes") && y.is_nan(), "{name} {op:?}({a:e}, {b:e}): {y:e}")
                    }
                    (x, y) => assert_eq!(x, y, "{name} {op:?}({a:e}, {b:e})"),
                }
                tally.count(name, op);
            }
        }
    }
    let mut t = Tally::default();
    let all = Orders::all(DEGREE);
    law(&mut t, "f64", &(), |x| x, |x| *x);
    law(&mut t, "Dual64", &(), |x| Dual64::new(x, 0.0), |x| x.re);
    law(&mut t, "Dual2", &(), |x| Dual2_64::new(x, 0.0, 0.0), |x| x.re);
    law(&mut t, "Jet", &all, |x| Jet::constant(x, &all), |x| x.coefficient(0));
    law(&mut t, "Lanes", &(), Lanes::<3>::splat, |x| x.0[2]);
    law(&mut t, "DualLanes", &(), DualLanes::<3>::constant, |x| x.value.0[1]);
    law(&mut t, "Lanes in Jet", &all, |x| Jet::constant(Lanes::<2>::splat(x), &all), |x| x.coefficient(0).0[1]);
    law(&mut t, "Lanes in Dual", &(), |x| Dual::new(Lanes::<2>::splat(x), Lanes::ZERO), |x| x.re.0[1]);
    t.require(&["f64", "Dual64", "Dual2", "Jet", "Lanes", "DualLanes", "Lanes in Jet", "Lanes in Dual"], &[]);
}

/// A bound may be missing where `f64` has a value, but only where none exists; the value is that of `f64`.
#[test]
fn bounded_values_are_those_of_f64() {
    let mut tally = Tally::default();
    for &op in Op::EVERY {
        for (a, b) in arguments(&mut Random(2)) {
            let got = apply(op, &(), &Bounded::exact(a), &Bounded::exact(b));
            match (plain(op, a, b), got) {
                (Ok(x), Ok(y)) => assert_eq!(x.to_bits(), y.value.to_bits(), "{op:?}({a:e}, {b:e})"),
                // The error of a result near the largest number may itself be too large.
                (Ok(x), Err(why)) => {
                    assert!(why == NoValue::Indeterminate && x.abs() > 1e300, "{op:?}({a:e}, {b:e}) = {x:e}: {why}")
                }
                (x, y) => assert_eq!(x.err(), y.err(), "{op:?}({a:e}, {b:e})"),
            }
            tally.count("Bounded", op);
            // The value does not depend on the error.
            let (e, f) = (a.abs() * 1e-3, b.abs() * 1e-3);
            if let (Ok(x), Ok(y)) = (plain(op, a, b), apply(op, &(), &Bounded::new(a, e), &Bounded::new(b, f))) {
                assert_eq!(x.to_bits(), y.value.to_bits(), "{op:?}({a:e}, {b:e})");
                tally.count("ball", op);
            }
        }
    }
    tally.require(&["Bounded", "ball"], &[]);
}

/// The interval of one number contains the value of `f64` within its bound, alone and as the first coefficient of a series or a dual
/// number; where there is no value, the reason is the same. More laws of intervals stand in `interval_laws.rs`.
#[test]
fn intervals_contain_the_values_of_f64() {
    let mut tally = Tally::default();
    let all = Orders::all(DEGREE);
    for &op in Op::EVERY {
        for (a, b) in arguments(&mut Random(10)) {
            // Over intervals −0 is 0, and lies on the upper side of the cut; near 0 the mean of f64 has lost all digits.
            let small = op == Op::Agm && a.abs().min(b.abs()) < 1e-300;
            if (op == Op::Arctan2 && a == 0.0 && a.is_sign_negative()) || small {
                continue;
            }
            let (x, y) = (Interval::point(a), Interval::point(b));
            let range = apply(op, &(), &x, &y);
            let series = apply(op, &all, &Jet::constant(x, &all), &Jet::constant(y, &all)).map(|j| j.coefficient(0));
            let dual = apply(op, &(), &Dual::new(x, Interval::ZERO), &Dual::new(y, Interval::ZERO)).map(|d| d.re);
            assert_eq!((range, range), (series, dual), "{op:?}({a:e}, {b:e})");
            match (plain(op, a, b), range) {
                (Ok(v), Ok(range)) => {
                    let error = apply(op, &(), &Bounded::exact(a), &Bounded::exact(b)).map_or(0.0, |ball| ball.error);
                    let contains = range.lo() <= v + error && v - error <= range.hi();
                    assert!(contains, "{op:?}({a:e}, {b:e}): {range} lacks {v:e} ± {error:e}");
                }
                (Ok(v), Err(why)) => {
                    assert!(why == NoValue::Indeterminate && v.abs() > 1e300, "{op:?}({a:e}, {b:e}) = {v:e}: {why}")
                }
                (Err(NoValue::Indeterminate), Ok(_)) => {}
                (v, range) => assert_eq!(v.err(), range.err(), "{op:?}({a:e}, {b:e})"),
            }
            tally.count("Interval", op);
        }
    }
    tally.require(&["Interval"], &[]);
}

/// What is not a number never becomes one, and never comes out.
#[test]
fn infinity_and_nan_are_never_results() {
    let strange = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    let mut tally = Tally::default();
    let all = Orders::all(2);
    for &op in Op::EVERY {
        let cases = EDGES.iter().flat_map(|&e| strange.iter().flat_map(move |&s| [(e, s), (s, e), (s, s)]));
        for (a, b) in cases {
            let finite = |what: &str, x: f64| assert!(x.is_finite(), "{what} {op:?}({a:e}, {b:e}) = {x:e}");
            if let Ok(x) = plain(op, a, b) {
                finite("f64", x);
            }
            if let Ok(x) = apply(op, &(), &Bounded::exact(a), &Bounded::exact(b)) {
                finite("value", x.value);
                finite("error", x.error);
            }
            if let Ok(x) = apply(op, &(), &Dual64::new(a, 1.0), &Dual64::new(b, 1.0)) {
                finite("Dual64", x.re);
                finite("Dual64 tangent", x.eps);
            }
            if let Ok(x) = apply(op, &all, &Jet::variable(a, 1.0, &all), &Jet::variable(b, 1.0, &all)) {
                (0..=2).for_each(|k| finite("Jet", x.coefficient(k)));
            }
            if let Ok(x) = apply(op, &(), &Lanes([a]), &Lanes([b])) {
                assert!(!x.0[0].is_infinite(), "Lanes {op:?}({a:e}, {b:e})");
            }
            if a.is_nan() || (b.is_nan() && op.arity() == 2) {
                assert!(plain(op, a, b).is_err(), "{op:?}({a:e}, {b:e})");
                let lanes = apply(op, &(), &Lanes([a]), &Lanes([b])).expect("lanes never fail");
                assert!(lanes.0[0].is_nan(), "Lanes {op:?}({a:e}, {b:e})");
                tally.count("NaN", op);
            }
        }
    }
    tally.require(&["NaN"], &[]);
}

/// 53 bits are the double; this many are enough to tell on which side of it the exact result lies.
const PRECISION: usize = 160;

type Exact = FBig<HalfEven, 2>;

fn exact(x: f64) -> Exact {
    Exact::try_from(x).expect("finite").with_precision(PRECISION).value()
}

/// The operation with many digits. Arguments must be in the domain.
fn oracle(op: Op, a: f64, b: f64) -> Exact {
    let (x, y) = (exact(a), exact(b));
    let one = exact(1.0);
    match op {
        Op::Neg => -x,
        Op::Restrict => x,
        Op::Sqrt => x.sqrt(),
        Op::Exp => x.exp(),
        Op::Ln => x.ln(),
        Op::Sin => x.sin(),
        Op::Cos => x.cos(),
        Op::Tan => x.tan(),
        Op::Arcsin => x.asin(),
        Op::Arccos => x.acos(),
        Op::Arctan => x.atan(),
        Op::Sinh => x.sinh(),
        Op::Cosh => x.cosh(),
        Op::Tanh => x.tanh(),
        Op::Abs => exact(a.abs()),
        Op::Add => x + y,
        Op::Sub => x - y,
        Op::Mul => x * y,
        Op::Div => x / y,
        Op::Pow if a == 0.0 => exact(0.0),
        Op::Pow => (x.ln() * y).exp(),
        Op::Arctan2 => x.atan2(&y),
        Op::DirectionCosine => {
            let square = x.clone() * x.clone() + y.clone() * y;
            x / square.sqrt()
        }
        Op::Agm if a == 0.0 || b == 0.0 => exact(0.0),
        Op::Agm => {
            let (mut x, mut y) = (x, y);
            for _ in 0..14 {
                let mean = (x.clone() + y.clone()) / exact(2.0);
                y = (x * y).sqrt();
                x = mean;
            }
            x
        }
        Op::Powi(n) => {
            let power = (0..n.unsigned_abs()).fold(one.clone(), |p, _| p * x.clone());
            if n < 0 { one / power } else { power }
        }
    }
}

/// Arguments near which the operation has a value, from small to large and close to the ends of the domain.
fn interesting(op: Op, random: &mut Random) -> (f64, f64) {
    let near_one = |random: &mut Random| 1.0 - random.within(-52.0, 0.0).exp2();
    match op {
        Op::Arcsin | Op::Arccos => {
            let sign = random.scaled(0.0, 0.0);
            (if random.bits() & 1 == 0 { random.scaled(-30.0, 0.0) } else { sign * near_one(random) }, 0.0)
        }
        Op::Sqrt | Op::Ln | Op::Agm => (random.scaled(-40.0, 40.0).abs(), random.scaled(-40.0, 40.0).abs()),
        Op::Pow => (random.scaled(-8.0, 8.0).abs(), random.scaled(-4.0, 4.0)),
        Op::Exp | Op::Sinh | Op::Cosh | Op::Tanh => (random.scaled(-30.0, 8.0), 0.0),
        Op::Tan if random.bits() & 1 == 0 => (std::f64::consts::FRAC_PI_2 + random.scaled(-30.0, -1.0), 0.0),
        Op::Add | Op::Sub if random.bits() & 1 == 0 => {
            let a = random.scaled(-3.0, 3.0);
            (a, a * (1.0 + random.scaled(-50.0, -1.0)))
        }
        _ => (random.scaled(-20.0, 20.0), random.scaled(-20.0, 20.0)),
    }
}

/// The distance of two angles on the circle; for other operations, of two numbers.
fn distance(op: Op, x: f64, y: f64) -> f64 {
    let d = (x - y).abs();
    if op == Op::Arctan2 { d.min((d - 2.0 * std::f64::consts::PI).abs()) } else { d }
}

/// Results of exact arguments, against many digits.
#[test]
fn bounds_hold_for_exact_arguments() {
    let mut tally = Tally::default();
    let mut random = Random(3);
    for &op in Op::EVERY {
        for _ in 0..60 {
            let (a, b) = interesting(op, &mut random);
            let got = match apply(op, &(), &Bounded::exact(a), &Bounded::exact(b)) {
                Ok(got) => got,
                Err(why) => panic!("{op:?}({a:e}, {b:e}): {why}"),
            };
            let off = oracle(op, a, b) - exact(got.value);
            let off = if off < exact(0.0) { -off } else { off };
            assert!(off <= exact(got.error), "{op:?}({a:e}, {b:e}): {got:?} is off by {:e}", off.to_f64().value());
            // A bound is of use only if it is small: three units, or the iterations of the mean.
            let allowed = if op == Op::Agm { 60.0 } else { 3.5 };
            let limit = allowed * f64::EPSILON * got.value.abs() + 1e-300;
            assert!(got.error <= limit, "{op:?}({a:e}, {b:e}): {got:?} is too wide");
            tally.count("exact", op);
        }
    }
    tally.require(&["exact"], &[]);
}

/// Results of all arguments in a ball: random ones, and the ends.
#[test]
fn bounds_hold_for_all_arguments() {
    let mut tally = Tally::default();
    let mut random = Random(4);
    for &op in Op::EVERY {
        for _ in 0..2000 {
            let (a, b) = interesting(op, &mut random);
            let mut radius = |x: f64| match random.bits() % 4 {
                0 => 0.0,
                1 => x.abs() * random.within(-52.0, -20.0).exp2(),
                2 => random.within(-40.0, 1.0).exp2(),
                _ => x.abs() * random.within(-6.0, 1.0).exp2(),
            };
            let (x, y) = (Bounded::new(a, radius(a)), Bounded::new(b, radius(b)));
            let Ok(got) = apply(op, &(), &x, &y) else { continue };
            for trial in 0..12 {
                let step = match trial {
                    0 => (1.0, 1.0),
                    1 => (-1.0, 1.0),
                    2 => (1.0, -1.0),
                    3 => (-1.0, -1.0),
                    _ => (random.within(-1.0, 1.0), random.within(-1.0, 1.0)),
                };
                let (p, q) = (a + step.0 * x.error, b + step.1 * y.error);
                // Rounding must not have left the ball.
                let (p, q) = (pull(p, x), pull(q, y));
                let Ok(other) = plain(op, p, q) else { continue };
                let rounding = if op == Op::Agm { 1e-14 } else { f64::EPSILON } * other.abs();
                let off = distance(op, other, got.value);
                assert!(
                    off <= got.error * (1.0 + 1e-14) + rounding + 1e-305,
                    "{op:?}({x:?}, {y:?}) = {got:?}, but ({p:e}, {q:e}) gives {other:e}, off by {off:e}"
                );
                tally.count("ball", op);
            }
        }
    }
    tally.require(&["ball"], &[]);
}

/// A number next to `p` that is in the ball for certain.
fn pull(p: f64, ball: Bounded) -> f64 {
    if exact_distance(p, ball.value) <= exact(ball.error) {
        p
    } else if p > ball.value {
        p.next_down()
    } else {
        p.next_up()
    }
}

fn exact_distance(p: f64, q: f64) -> Exact {
    let d = exact(p) - exact(q);
    if d < exact(0.0) { -d } else { d }
}

/// Bounds of small balls are not much wider than the derivative says.
#[test]
fn bounds_are_tight() {
    let mut tally = Tally::default();
    let mut random = Random(5);
    for &op in Op::EVERY {
        for _ in 0..300 {
            let (a, b) = (random.within(0.1, 0.9), random.within(0.1, 0.9));
            let e = 1e-9;
            let Ok(d) = apply(op, &(), &Dual64::new(a, 1.0), &Dual64::new(b, 0.0)) else { continue };
            let got = apply(op, &(), &Bounded::new(a, e), &Bounded::exact(b)).expect("far from the ends");
            // arctan2 uses the chord for the arc, and both directions.
            let room = match op {
                Op::Arctan2 => e / a.hypot(b),
                Op::DirectionCosine => b * e / (a * a + b * b),
                _ => d.eps.abs() * e,
            };
            assert!(got.error <= 1.01 * room + 1e-15, "{op:?}({a}, {b}): {got:?}, slope {}", d.eps);
            tally.count("tight", op);
        }
    }
    tally.require(&["tight"], &[Op::Agm]);
}

/// At the ends of a domain: a bound where there is one, and the reason where there is none.
#[test]
fn balls_at_the_ends_of_domains() {
    let ball = Bounded::new;
    let get = |op, a, b| apply(op, &(), &a, &b);
    let zero = Bounded::exact(0.0);
    for (op, at) in [(Op::Sqrt, 0.0), (Op::Arccos, 1.0), (Op::Arcsin, -1.0)] {
        let got = get(op, ball(at, 1e-10), zero).expect("a bound exists");
        assert!(got.error > 1e-6 && got.error < 3e-5, "{op:?}: {got:?}");
    }
    // A centre that rounding has moved across 0: the root of whatever is in the ball lies within the bound.
    let moved = get(Op::Sqrt, ball(-1e-20, 1e-10), zero).expect("a bound exists");
    assert!(moved.value == 0.0 && moved.error >= 1e-10f64.sqrt() * (1.0 - 1e-9) && moved.error < 1.1e-5, "{moved:?}");
    assert_eq!(get(Op::Sqrt, ball(-1.0, 1e-10), zero), Err(NoValue::OutOfDomain));
    assert_eq!(get(Op::Arccos, ball(1.0 + 1e-12, 1e-10), zero), Err(NoValue::Indeterminate));
    assert_eq!(get(Op::Arccos, ball(1.1, 1e-10), zero), Err(NoValue::OutOfDomain));
    assert_eq!(get(Op::Ln, ball(1e-12, 1e-10), zero), Err(NoValue::Indeterminate));
    assert_eq!(get(Op::Ln, ball(-1e-12, 1e-10), zero), Err(NoValue::Indeterminate));
    assert_eq!(get(Op::Ln, zero, zero), Err(NoValue::OutOfDomain));
    assert_eq!(get(Op::Div, ball(1.0, 0.0), ball(1e-12, 1e-10)), Err(NoValue::Indeterminate));
    assert_eq!(get(Op::Div, ball(1.0, 0.0), zero), Err(NoValue::OutOfDomain));
    assert_eq!(get(Op::Powi(-2), ball(1e-12, 1e-10), zero), Err(NoValue::Indeterminate));
    assert_eq!(get(Op::Tan, ball(1.57, 0.01), zero), Err(NoValue::Indeterminate));
    assert_eq!(get(Op::Arctan2, ball(0.0, 1e-10), ball(0.0, 1e-10)), Err(NoValue::Indeterminate));
    assert_eq!(get(Op::Arctan2, zero, zero), Err(NoValue::OutOfDomain));
    assert_eq!(get(Op::DirectionCosine, ball(0.0, 1e-10), ball(0.0, 1e-10)), Err(NoValue::Indeterminate));
    assert_eq!(get(Op::DirectionCosine, zero, zero), Err(NoValue::OutOfDomain));
    // The cut: one representative of the angle, with the bound of the angle.
    let cut = get(Op::Arctan2, ball(1e-12, 1e-10), ball(-1.0, 0.0)).expect("a value on the cut");
    assert!(cut.value > 3.0 && cut.error < 1e-9, "{cut:?}");
    let power = get(Op::Pow, ball(1e-12, 1e-10), ball(0.5, 0.0)).expect("a bound exists");
    assert!(power.error >= (1.01e-10_f64).sqrt() && power.error < 2e-5, "{power:?}");
    assert_eq!(get(Op::Agm, ball(-1.0, 1e-3), ball(1.0, 0.0)), Err(NoValue::OutOfDomain));
}

/// f along a straight line in its arguments, in every type that has derivatives, and by symbolic differentiation.
#[test]
fn derivatives_agree() {
    let mut tally = Tally::default();
    let mut random = Random(6);
    let mut graph = Graph::new();
    let leaves: [Leaf; 2] = ["a", "b"].map(|name| {
        let symbol = graph.declare(name, Shape::scalar(), false);
        Leaf::now(symbol, 0)
    });
    let all = Orders::all(DEGREE);
    for &op in Op::EVERY {
        let partials = symbolic(&mut graph, op, leaves);
        for _ in 0..400 {
            let (a, b) = (random.scaled(-3.0, 1.5), random.scaled(-3.0, 1.5));
            let (da, db) = (random.scaled(-2.0, 2.0), random.scaled(-2.0, 2.0));
            let dual = apply(op, &(), &Dual64::new(a, da), &Dual64::new(b, db));
            let jet = apply(op, &all, &Jet::variable(a, da, &all), &Jet::variable(b, db, &all));
            let second = apply(op, &(), &Dual2::new(a, da, 0.0), &Dual2::new(b, db, 0.0));
            let ball = |x, d| Dual::new(Bounded::exact(x), Bounded::exact(d));
            let bounded = apply(op, &(), &ball(a, da), &ball(b, db));
            let lanes = apply(op, &(), &lane(a, da), &lane(b, db)).expect("lanes never fail");
            assert_eq!(dual.as_ref().err(), jet.as_ref().err(), "{op:?}({a}, {b})");
            assert_eq!(dual.as_ref().err(), second.as_ref().err(), "{op:?}({a}, {b})");
            let Ok(dual) = dual else {
                assert!(lanes.value.0[1].is_nan() && lanes.tangent.0[1].is_nan());
                continue;
            };
            let (jet, second) = (jet.expect("as the dual"), second.expect("as the dual"));
            assert_eq!(dual.re.to_bits(), second.re.to_bits());
            assert_eq!(dual.re.to_bits(), jet.coefficient(0).to_bits());
            assert_eq!([dual.re, dual.eps].map(f64::to_bits), [lanes.value.0[1], lanes.tangent.0[1]].map(f64::to_bits));
            let close = |what: &str, x: f64, y: f64, scale: f64| {
                let room = 1e-13 * scale.max(1e-3).max(y.abs());
                assert!((x - y).abs() <= room, "{what} of {op:?}({a}, {b}) by ({da}, {db}): {x:e}, {y:e}");
            };
            // What cancels in a sum of two terms decides how close is close.
            let steep = [(da, 0.0), (0.0, db)]
                .map(|(da, db)| apply(op, &(), &Dual64::new(a, da), &Dual64::new(b, db)).map_or(0.0, |d| d.eps.abs()));
            let scale = steep[0] + steep[1];
            close("slope", jet.coefficient(1), dual.eps, scale);
            close("slope", second.v1, dual.eps, scale);
            let bent = second.v2.abs() + scale * scale / (1e-3 + dual.re.abs()) + scale * (da.abs() + db.abs()) * 10.0;
            close("curvature", 2.0 * jet.coefficient(2), second.v2, bent);
            tally.count("series", op);
            if let Ok(ball) = bounded {
                assert_eq!(ball.re.value.to_bits(), dual.re.to_bits());
                let room = ball.eps.error + 1e-13 * scale.max(1e-3);
                assert!((ball.eps.value - dual.eps).abs() <= room, "{op:?}({a}, {b}): {ball:?}, {dual:?}");
                tally.count("bounded", op);
            }
            if let Some(tape) = &partials {
                let mut slots = tape.slots(&());
                let out = tape.evaluate(&(), &[Ok(a), Ok(b)], &mut slots);
                let [Ok(x), Ok(y)] = out[..] else { panic!("no derivative of {op:?} at ({a}, {b}): {out:?}") };
                close("symbolic slope", x * da + y * db, dual.eps, scale);
                tally.count("symbolic", op);
            }
        }
    }
    tally.require(&["series", "bounded", "symbolic"], &[Op::Agm]);
}

/// Both partial derivatives of an operation as a tape; none for operations whose derivative is not in the table.
fn symbolic(graph: &mut Graph, op: Op, leaves: [Leaf; 2]) -> Option<Tape> {
    let [x, y] = leaves.map(|leaf| graph.leaf(leaf));
    let f = if op.arity() == 1 { graph.unary(op, x) } else { graph.binary(op, x, y) };
    let roots: Vec<Expr> = leaves.iter().map_while(|&leaf| graph.partial_derivative(f, leaf).ok()).collect();
    if roots.len() < 2 {
        return None;
    }
    Tape::compile(graph, &leaves, &roots).ok()
}

/// A point in a lane that is not the first.
fn lane(x: f64, d: f64) -> DualLanes<4> {
    DualLanes { value: Lanes([1.0, x, 0.5, 0.0]), tangent: Lanes([1.0, d, 0.0, 0.0]) }
}

/// Moving arguments at branch points: no derivative, in no type. Resting ones have derivative 0.
#[test]
fn branch_points() {
    let all = Orders::all(2);
    let cases = [
        (Op::Sqrt, 0.0, 0.0),
        (Op::Arccos, 1.0, 0.0),
        (Op::Arccos, -1.0, 0.0),
        (Op::Arcsin, 1.0, 0.0),
        (Op::Abs, 0.0, 0.0),
        (Op::Pow, 0.0, 0.5),
        (Op::Agm, 1.0, 2.0),
    ];
    for (op, a, b) in cases {
        for d in [1.0, -1e-3, 0.0] {
            let expected = if d == 0.0 { Ok(()) } else { Err(NoValue::Indeterminate) };
            let name = format!("{op:?}({a}) moving by {d}");
            let dual = apply(op, &(), &Dual64::new(a, d), &Dual64::new(b, 0.0));
            let second = apply(op, &(), &Dual2::new(a, d, 0.0), &Dual2::new(b, 0.0, 0.0));
            let jet = apply(op, &all, &Jet::variable(a, d, &all), &Jet::constant(b, &all));
            let ball = apply(
                op,
                &(),
                &Dual::new(Bounded::exact(a), Bounded::exact(d)),
                &Dual::new(Bounded::exact(b), Bounded::ZERO),
            );
            let lanes = apply(op, &(), &lane(a, d), &lane(b, 0.0)).expect("lanes never fail");
            assert_eq!(dual.map(|x| assert_eq!(x.eps, 0.0)), expected, "{name}");
            assert_eq!(second.map(|x| assert_eq!((x.v1, x.v2), (0.0, 0.0))), expected, "{name}");
            assert_eq!(jet.map(|x| assert!(x.is_constant())), expected, "{name}");
            assert_eq!(ball.map(|x| assert_eq!(x.eps, Bounded::ZERO)), expected, "{name}");
            assert_eq!(lanes.value.0[1].is_nan(), expected.is_err(), "{name}");
            assert_eq!(lanes.tangent.0[1].is_nan(), expected.is_err(), "{name}");
        }
    }
    // The value of 0^2.5 is 0, and it leaves it with slope 0.
    let got = apply(Op::Pow, &(), &Dual64::new(0.0, 1.0), &Dual64::new(2.5, 0.0)).expect("defined");
    assert_eq!((got.re, got.eps), (0.0, 0.0));
}

/// What has no value stays without one.
#[test]
fn lanes_do_not_forget() {
    let zero = Lanes([0.0, 2.0]);
    let one = Lanes([1.0, 1.0]);
    let pole = apply(Op::Div, &(), &one, &zero).expect("lanes never fail");
    let back = apply(Op::Div, &(), &one, &pole).expect("lanes never fail");
    assert!(back.0[0].is_nan() && back.0[1] == 2.0, "{back:?}");
    let huge = apply(Op::Mul, &(), &Lanes([1e200]), &Lanes([1e200])).expect("lanes never fail");
    assert!(huge.0[0].is_nan());
}

/// Order by order, all at once, over bounds and over lanes: the same coefficients, bit for bit.
#[test]
fn series_agree_bit_for_bit() {
    let mut tally = Tally::default();
    let mut random = Random(7);
    let degree = 9;
    let all = Orders::all(degree);
    for &op in Op::EVERY {
        for case in 0..40 {
            let mut draw = |constant: bool| {
                let mut x = Jet::constant(random.scaled(-2.0, 0.9), &all);
                let top = if constant { 0 } else { random.bits() as usize % (degree + 1) };
                // Some coefficients are 0, so that an argument rests before it moves.
                for k in 1..=top {
                    let c = random.scaled(-2.0, 1.0);
                    x.set_coefficient(k, if random.bits().is_multiple_of(3) { 0.0 } else { c });
                }
                x
            };
            let (a, b) = (draw(case % 5 == 0), draw(case % 3 == 0));
            let whole = apply(op, &all, &a, &b);
            let mut out: Jet<f64> = Jet::blank(&all);
            let mut ordered = Ok(());
            let part = |x: &Jet<f64>, k: usize| {
                let mut part = Jet::constant(x.coefficient(0), &all);
                (1..=k).for_each(|i| part.set_coefficient(i, x.coefficient(i)));
                part
            };
            // What an earlier run left behind must not matter.
            let _ = op.apply(&all, &mut out, &b, &a);
            for k in 0..=degree {
                if ordered.is_ok() {
                    ordered = op.apply(&Orders::only(k, degree), &mut out, &part(&a, k), &part(&b, k));
                }
            }
            let bounded = apply(op, &all, &over(&a, &all, Bounded::exact), &over(&b, &all, Bounded::exact));
            let lanes = apply(op, &all, &over(&a, &all, Lanes::<2>::splat), &over(&b, &all, Lanes::<2>::splat));
            let Ok(whole) = whole else {
                assert_eq!(whole.err(), ordered.err(), "{op:?}");
                continue;
            };
            assert_eq!(ordered, Ok(()), "{op:?}");
            for k in 0..=degree {
                let c = whole.coefficient(k);
                assert_eq!(c, out.coefficient(k), "{op:?} at order {k}");
                if let Ok(lanes) = &lanes {
                    assert_eq!([c, c], lanes.coefficient(k).0, "{op:?} at order {k}");
                }
                if let Ok(bounded) = &bounded {
                    assert_eq!(c, bounded.coefficient(k).value, "{op:?} at order {k}");
                    tally.count("bounded", op);
                }
            }
            tally.count("ordered", op);
        }
    }
    tally.require(&["ordered", "bounded"], &[]);
}

/// The same series over another base.
fn over<B: Scalar>(x: &Jet<f64>, orders: &Orders, of: impl Fn(f64) -> B) -> Jet<B> {
    let mut out = Jet::constant(of(x.coefficient(0)), orders);
    (1..x.coefficients().len()).for_each(|k| out.set_coefficient(k, of(x.coefficient(k))));
    out
}

/// The coefficients of a series over balls and over points of those balls are compatible.
#[test]
fn bounds_of_series_hold() {
    let mut tally = Tally::default();
    let mut random = Random(8);
    let all = Orders::all(6);
    for &op in Op::EVERY {
        for _ in 0..60 {
            let e = random.within(-40.0, -8.0).exp2();
            let mut pair = || {
                let x = random.within(0.2, 0.8);
                let mut ball = Jet::constant(Bounded::new(x, e), &all);
                let mut point = Jet::constant(Bounded::exact(x + 0.99 * e), &all);
                for k in 1..=4 {
                    let c = random.within(-1.0, 1.0);
                    ball.set_coefficient(k, Bounded::new(c, e));
                    point.set_coefficient(k, Bounded::exact(c + random.within(-0.99, 0.99) * e));
                }
                (ball, point)
            };
            let ((a, p), (b, q)) = (pair(), pair());
            let (Ok(ball), Ok(point)) = (apply(op, &all, &a, &b), apply(op, &all, &p, &q)) else { continue };
            for k in 0..=6 {
                let (x, y) = (ball.coefficient(k), point.coefficient(k));
                assert!(
                    (x.value - y.value).abs() <= (x.error + y.error) * (1.0 + 1e-14),
                    "{op:?} order {k}: {x:?}, {y:?}"
                );
                tally.count("series of balls", op);
            }
        }
    }
    tally.require(&["series of balls"], &[Op::Agm]);
}

/// Coefficients of a product of series with exact coefficients, against many digits.
#[test]
fn bounds_hold_for_convolutions() {
    let mut random = Random(9);
    for degree in 0..40 {
        let all = Orders::all(degree);
        let mut draw = || {
            let mut x = Jet::constant(Bounded::exact(random.scaled(-3.0, 3.0)), &all);
            (1..=degree).for_each(|k| x.set_coefficient(k, Bounded::exact(random.scaled(-3.0, 3.0))));
            x
        };
        let (a, b) = (draw(), draw());
        let product = apply(Op::Mul, &all, &a, &b).expect("no overflow");
        let (mut sum, mut size) = (exact(0.0), 0.0);
        for i in 0..=degree {
            let (x, y) = (a.coefficient(i).value, b.coefficient(degree - i).value);
            sum += exact(x) * exact(y);
            size += (x * y).abs();
        }
        let got = product.coefficient(degree);
        let off = sum - exact(got.value);
        let off = if off < exact(0.0) { -off } else { off };
        assert!(off <= exact(got.error), "order {degree}: {got:?} is off by {:e}", off.to_f64().value());
        assert!(got.error <= (degree + 3) as f64 * f64::EPSILON * size, "order {degree}: {got:?} is too wide");
    }
}
