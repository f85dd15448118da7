//! The same value by two routes: series, dual numbers and symbolic derivatives of random expressions; Taylor coefficients
//! against published ones.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use num_dual::{Dual2_64, Dual64};
use rederive::expr::{Expr, Graph, Leaf, Op, Rational, Shape};
use rederive::number::{Bounded, DualLanes, Jet, Lanes, Number, Orders};
use rederive::tape::Tape;

/// Xorshift: the same expressions on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 33) as usize) % n
    }
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.below(1 << 30) as f64 / (1_u64 << 30) as f64
    }
}

/// An expression of `size` operations in the leaves, kept of moderate size: a result that may have left the domain of the
/// next operation is brought back by a sine or a rational function without poles.
fn random_expression(g: &mut Graph, random: &mut Random, leaves: &[Leaf], size: usize) -> Expr {
    let mut pool: Vec<Expr> = leaves.iter().map(|&leaf| g.leaf(leaf)).collect();
    pool.push(g.constant(Rational::from(3) / Rational::from(7)));
    pool.push(g.pi());
    for _ in 0..size {
        // The newest results more often, so that the expression is deep.
        let span = pool.len().min(4);
        let recent = pool[pool.len() - 1 - random.below(span)];
        let any = pool[random.below(pool.len())];
        let op = Op::ALL[random.below(Op::ALL.len())];
        let tame = |g: &mut Graph, e: Expr| {
            // 2/5 + sin(e)/4 lies in (0, 1).
            let (a, b) = (Rational::from(2) / Rational::from(5), Rational::from(1) / Rational::from(4));
            let (a, b) = (g.constant(a), g.constant(b));
            let wave = g.unary(Op::Sin, e);
            let product = g.mul(b, wave);
            g.add(a, product)
        };
        let e = match op {
            Op::Agm => continue,
            Op::Add | Op::Sub | Op::Mul => g.binary(op, recent, any),
            Op::Div | Op::Arctan2 => {
                let below = tame(g, any);
                g.binary(op, recent, below)
            }
            Op::Pow => {
                let (a, b) = (tame(g, recent), tame(g, any));
                g.binary(op, a, b)
            }
            Op::Neg | Op::Sin | Op::Cos | Op::Arctan | Op::Tanh => g.unary(op, recent),
            _ => {
                let a = tame(g, recent);
                g.unary(op, a)
            }
        };
        pool.push(e);
    }
    pool[pool.len() - 1]
}

fn close(x: f64, y: f64, scale: f64) -> bool {
    (x - y).abs() <= 1e-10 * (1.0 + x.abs().max(y.abs()).max(scale))
}

/// e and its first two derivatives along a line, by five routes.
#[test]
fn derivatives_of_random_expressions() {
    let mut random = Random(0x5EED);
    let mut compared = 0;
    for _ in 0..200 {
        let mut g = Graph::new();
        let leaves: Vec<Leaf> =
            ["a", "b", "c"].iter().map(|name| Leaf::now(g.declare(name, Shape::scalar(), false), 0)).collect();
        let size = 4 + random.below(16);
        let e = random_expression(&mut g, &mut random, &leaves, size);
        let speeds: Vec<Expr> = (0..3).map(|_| g.integer(random.below(7) as i64 - 3)).collect();
        let along = |g: &mut Graph, e: Expr| {
            g.directional_derivative(e, |_, leaf| leaves.iter().position(|l| *l == leaf).map(|i| speeds[i]))
        };
        let d1 = along(&mut g, e).expect("no agm in it");
        let d2 = along(&mut g, d1).expect("no agm in it");
        let speed: Vec<f64> = speeds.iter().map(|s| g.as_constant(*s).expect("an integer").to_f64().value()).collect();
        let plain = Tape::compile(&g, &leaves, &[e]).expect("leaves given");
        let symbolic = Tape::compile(&g, &leaves, &[e, d1, d2]).expect("leaves given");
        for _ in 0..5 {
            let at: Vec<f64> = (0..3).map(|_| random.within(-1.5, 1.5)).collect();
            let out = evaluate(&symbolic, &(), at.iter().copied());
            let [Ok(v), Ok(s1), Ok(s2)] = out[..] else { continue };
            if v.abs().max(s1.abs()).max(s2.abs()) > 1e6 {
                continue;
            }
            let context = || format!("case {compared}: e = {v:e}, e′ = {s1:e}, e″ = {s2:e}");
            let moving = |i: usize| (at[i], speed[i]);

            let orders = Orders::all(2);
            let inputs = (0..3).map(|i| Jet::variable(moving(i).0, moving(i).1, &orders));
            let jet = evaluate(&plain, &orders, inputs).remove(0).expect("as the symbolic one");
            assert_eq!(jet.coefficient(0).to_bits(), v.to_bits(), "{}", context());
            assert!(close(jet.coefficient(1), s1, v), "{}: jet {:e}", context(), jet.coefficient(1));
            assert!(close(2.0 * jet.coefficient(2), s2, s1 * s1), "{}: jet {:e}", context(), 2.0 * jet.coefficient(2));

            let inputs = (0..3).map(|i| Dual64::new(moving(i).0, moving(i).1));
            let dual = evaluate(&plain, &(), inputs).remove(0).expect("as the symbolic one");
            assert_eq!(dual.re.to_bits(), v.to_bits(), "{}", context());
            assert!(close(dual.eps, s1, v), "{}: dual {:e}", context(), dual.eps);

            let inputs = (0..3).map(|i| Dual2_64::new(moving(i).0, moving(i).1, 0.0));
            let second = evaluate(&plain, &(), inputs).remove(0).expect("as the symbolic one");
            assert!(close(second.v2, s2, s1 * s1), "{}: dual {:e}", context(), second.v2);

            let inputs = (0..3).map(|i| DualLanes::<4> { value: Lanes([at[i]; 4]), tangent: Lanes([speed[i]; 4]) });
            let lanes = evaluate(&plain, &(), inputs).remove(0).expect("lanes never fail");
            assert_eq!(lanes.value.0, [v; 4], "{}", context());
            assert_eq!(lanes.tangent.0, [dual.eps; 4], "{}", context());

            // Bounds of the symbolic derivative and of the series must overlap.
            let exact = evaluate(&symbolic, &(), at.iter().map(|&x| Bounded::exact(x)));
            let inputs = (0..3).map(|i| Jet::variable(Bounded::exact(at[i]), Bounded::exact(speed[i]), &orders));
            let balls = evaluate(&plain, &orders, inputs).remove(0);
            if let ([Ok(b0), Ok(b1), Ok(b2)], Ok(balls)) = (&exact[..], balls) {
                assert_eq!(b0.value.to_bits(), v.to_bits(), "{}", context());
                for (k, (factor, ball)) in [(1.0, b0), (1.0, b1), (2.0, b2)].into_iter().enumerate() {
                    let c = balls.coefficient(k);
                    let apart = (factor * c.value - ball.value).abs();
                    assert!(apart <= (factor * c.error + ball.error) * (1.0 + 1e-12), "{}: {c:?}, {ball:?}", context());
                }
            }
            compared += 1;
        }
    }
    assert!(compared > 500, "only {compared} points had derivatives");
}

fn evaluate<N: Number>(
    tape: &Tape,
    cx: &N::Context,
    inputs: impl Iterator<Item = N>,
) -> Vec<Result<N, rederive::number::NoValue>> {
    let inputs: Vec<_> = inputs.map(Ok).collect();
    tape.evaluate(cx, &inputs, &mut tape.slots(cx))
}

/// The series of f(x₀ + h) up to h⁸.
fn expand(op: Op, at: f64) -> Jet<f64> {
    let orders = Orders::all(8);
    let mut out = Jet::blank(&orders);
    let x = Jet::variable(at, 1.0, &orders);
    op.apply(&orders, &mut out, &x, &x).expect("inside the domain");
    out
}

/// Taylor coefficients at 0 (ln: of 1 + h, pow: see below).
///
/// # Source
/// M. Abramowitz, I. A. Stegun, *Handbook of Mathematical Functions* (1964): 4.2.1 exp, 4.1.24 ln, 4.3.65–67 sin, cos, tan,
/// 4.4.40 arcsin, 4.4.42 arctan, 4.5.62–64 sinh, cosh, tanh, 3.6.9 the binomial series.
#[test]
fn published_coefficients() {
    let half_pi = std::f64::consts::FRAC_PI_2;
    let tables: &[(Op, f64, [f64; 9])] = &[
        (Op::Exp, 0.0, [1.0, 1.0, 1. / 2., 1. / 6., 1. / 24., 1. / 120., 1. / 720., 1. / 5040., 1. / 40320.]),
        (Op::Ln, 1.0, [0.0, 1.0, -1. / 2., 1. / 3., -1. / 4., 1. / 5., -1. / 6., 1. / 7., -1. / 8.]),
        (Op::Sin, 0.0, [0.0, 1.0, 0.0, -1. / 6., 0.0, 1. / 120., 0.0, -1. / 5040., 0.0]),
        (Op::Cos, 0.0, [1.0, 0.0, -1. / 2., 0.0, 1. / 24., 0.0, -1. / 720., 0.0, 1. / 40320.]),
        (Op::Tan, 0.0, [0.0, 1.0, 0.0, 1. / 3., 0.0, 2. / 15., 0.0, 17. / 315., 0.0]),
        (Op::Arcsin, 0.0, [0.0, 1.0, 0.0, 1. / 6., 0.0, 3. / 40., 0.0, 15. / 336., 0.0]),
        (Op::Arccos, 0.0, [half_pi, -1.0, 0.0, -1. / 6., 0.0, -3. / 40., 0.0, -15. / 336., 0.0]),
        (Op::Arctan, 0.0, [0.0, 1.0, 0.0, -1. / 3., 0.0, 1. / 5., 0.0, -1. / 7., 0.0]),
        (Op::Sinh, 0.0, [0.0, 1.0, 0.0, 1. / 6., 0.0, 1. / 120., 0.0, 1. / 5040., 0.0]),
        (Op::Cosh, 0.0, [1.0, 0.0, 1. / 2., 0.0, 1. / 24., 0.0, 1. / 720., 0.0, 1. / 40320.]),
        (Op::Tanh, 0.0, [0.0, 1.0, 0.0, -1. / 3., 0.0, 2. / 15., 0.0, -17. / 315., 0.0]),
        // The binomial series with exponents 1/2 and −2.
        (
            Op::Sqrt,
            1.0,
            [1.0, 1. / 2., -1. / 8., 1. / 16., -5. / 128., 7. / 256., -21. / 1024., 33. / 2048., -429. / 32768.],
        ),
        (Op::Powi(-2), 1.0, [1.0, -2.0, 3.0, -4.0, 5.0, -6.0, 7.0, -8.0, 9.0]),
        (Op::Powi(3), 1.0, [1.0, 3.0, 3.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        (Op::Powi(7), 0.0, [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]),
    ];
    for (op, at, expected) in tables {
        let got = expand(*op, *at);
        for (k, e) in expected.iter().enumerate() {
            let c = got.coefficient(k);
            assert!((c - e).abs() <= 1e-15 * e.abs().max(1.0), "{op:?}, order {k}: {c:e}, expected {e:e}");
        }
    }
}

/// (1 + h)^(1/2) as a power is √(1 + h); the angle of (cos h, sin h) is h.
#[test]
fn functions_of_two_arguments() {
    let orders = Orders::all(8);
    let base = Jet::variable(1.0, 1.0, &orders);
    let mut power = Jet::blank(&orders);
    power.pow(&orders, &base, &Jet::constant(0.5, &orders)).expect("defined");
    let root = expand(Op::Sqrt, 1.0);
    let h = Jet::variable(0.3, 1.0, &orders);
    let (mut sine, mut cosine, mut angle) = (Jet::blank(&orders), Jet::blank(&orders), Jet::blank(&orders));
    sine.sin(&orders, &h).expect("defined");
    cosine.cos(&orders, &h).expect("defined");
    angle.arctan2(&orders, &sine, &cosine).expect("defined");
    // x^x = e^(x ln x)
    let (mut own, mut log, mut product, mut exp) =
        (Jet::blank(&orders), Jet::blank(&orders), Jet::blank(&orders), Jet::blank(&orders));
    own.pow(&orders, &h, &h).expect("defined");
    log.ln(&orders, &h).expect("defined");
    product.mul(&orders, &h, &log).expect("defined");
    exp.exp(&orders, &product).expect("defined");
    for k in 0..=8 {
        assert!((power.coefficient(k) - root.coefficient(k)).abs() < 1e-15, "order {k}");
        assert!((angle.coefficient(k) - h.coefficient(k)).abs() < 1e-14, "order {k}: {:e}", angle.coefficient(k));
        let (x, y) = (own.coefficient(k), exp.coefficient(k));
        assert!((x - y).abs() < 1e-13 * y.abs().max(1.0), "order {k}: {x:e}, {y:e}");
    }
}

/// ẍ = −sin x as a system (x, v), order by order: the energy v²/2 − cos x of the series is constant.
#[test]
fn a_pendulum_order_by_order() {
    let mut g = Graph::new();
    let leaves = ["x", "v"].map(|name| Leaf::now(g.declare(name, Shape::scalar(), false), 0));
    let [x, v] = leaves.map(|leaf| g.leaf(leaf));
    let sine = g.unary(Op::Sin, x);
    let down = g.neg(sine);
    let (square, two) = (g.powi(v, 2), g.integer(2));
    let kinetic = g.div(square, two);
    let cosine = g.unary(Op::Cos, x);
    let energy = g.sub(kinetic, cosine);
    let tape = Tape::compile(&g, &leaves, &[v, down, energy]).expect("leaves given");
    let degree = 20;
    let mut slots = tape.slots::<Jet<f64>>(&Orders::all(degree));
    // Twice, so that the second series finds the remains of the first.
    for start in [[0.0, 0.0], [1.0, 0.5]] {
        for (i, s) in start.into_iter().enumerate() {
            slots.value_mut(i).set_coefficient(0, s);
        }
        for k in 0..=degree {
            tape.run(&Orders::only(k, degree), &mut slots);
            if k < degree {
                for i in 0..2 {
                    let next = tape.output(i, &slots).expect("defined").coefficient(k) / (k + 1) as f64;
                    slots.value_mut(i).set_coefficient(k + 1, next);
                }
            }
        }
        let energy = tape.output(2, &slots).expect("defined");
        for k in 1..=degree {
            assert!(energy.coefficient(k).abs() < 1e-15, "order {k}: {:e}", energy.coefficient(k));
        }
    }
    let x = slots.value(0).clone();
    let h = 0.1;
    let slope = slots.value(1).at(h);
    assert!((x.slope_at(h) - slope).abs() < 1e-15);
    assert!((x.derivative().at(h) - slope).abs() < 1e-15);
}
