//! Residuals of the Comment on the tennis racket effect at many points, by hand and on the tape; and the Taylor series of
//! the Euler–Poisson equations, order by order.
//!
//! `cargo bench --bench number`. Figures are comparable within one run only: quote ratios.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use num_dual::{Dual64, DualNum};
use rederive::expr::{Expr, Graph, Leaf, Op, Rational, Shape};
use rederive::number::{Jet, Lanes, Orders};
use rederive::tape::{Needed, Slots, Tape};

fn main() {
    divan::main();
}

/// Lanes of one block.
const BLOCK: usize = 64;
const INERTIA: [f64; 3] = [1.748, 1.638, 0.121];
const M3: f64 = 0.75;

/// One point: R33 R31 R32 R13 R23, their rates, and 2E.
type Point = [f64; 11];

/// Points with arbitrary rates: here only the time counts.
fn points(n: usize) -> Vec<Point> {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..n).map(|_| std::array::from_fn(|i| if i < 10 { 2.0 * next() - 1.0 } else { 3.0 + next() })).collect()
}

/// The residuals, written out for one point.
fn by_hand(p: &Point) -> [f64; 6] {
    let [r33, r31, r32, r13, r23] = std::array::from_fn(|i| Dual64::new(p[i], p[i + 5]));
    let [i1, i2, i3] = INERTIA.map(|i| 1.0 / i);
    let (i12, i13) = (i1 - i2, i1 - i3);
    let theta = (r31 * r31 + r32 * r32).sqrt().atan2(r33);
    let psi = r31.atan2(r32);
    let phi = r13.atan2(-r23);
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    let (st, ct, sp, cp) = (sin_theta.re, cos_theta.re, sin_psi.re, cos_psi.re);
    let rate = M3 * i1 * sp * sp + M3 * i2 * cp * cp;
    let under = i13 - i12 * cp * cp;
    let ratio = psi.eps / phi.eps;
    let below = i1 - i12 * cp * cp;
    let energy = (cos_psi * cos_psi * -i12 + i13) * (sin_theta * sin_theta) * (M3 * M3) + M3 * M3 * i3;
    [
        theta.eps - M3 * i12 * st * sp * cp,
        phi.eps - rate,
        psi.eps - (-rate * ct + M3 * i3 * ct),
        p[10] - energy.re,
        ratio * ratio - under * (i3 - p[10] / (M3 * M3) + under) / (below * below),
        energy.eps,
    ]
}

#[divan::bench(args = [1_000, 100_000])]
fn residuals_by_hand(bencher: Bencher, n: usize) {
    let points = points(n);
    bencher.counter(ItemsCount::new(n)).bench_local(|| {
        let mut worst = [0.0_f64; 6];
        for p in &points {
            for (w, r) in worst.iter_mut().zip(by_hand(black_box(p))) {
                *w = w.max(r.abs());
            }
        }
        worst
    });
}

/// The residuals in the entries and their rates as one tape, with angles that are continued, as a derivation is checked.
fn compile() -> Tape {
    let mut g = Graph::new();
    let symbol = |g: &mut Graph, name: &str| {
        let symbol = g.declare(name, Shape::scalar(), false);
        let leaf = Leaf::now(symbol, 0);
        (g.leaf(leaf), leaf)
    };
    let entries = ["R_{33}", "R_{31}", "R_{32}", "R_{13}", "R_{23}"].map(|name| symbol(&mut g, name));
    let [r33, r31, r32, r13, r23] = entries.map(|(e, _)| e);
    let (a, b) = (g.powi(r31, 2), g.powi(r32, 2));
    let sum = g.add(a, b);
    let root = g.unary(Op::Sqrt, sum);
    let theta = g.binary(Op::Arctan2, root, r33);
    let psi = g.binary(Op::Arctan2, r31, r32);
    let minus = g.neg(r23);
    let phi = g.binary(Op::Arctan2, r13, minus);
    let observables = [theta, psi, phi];

    let angles = [r"\theta", r"\psi", r"\varphi"].map(|name| symbol(&mut g, name));
    let [theta, psi, _] = angles.map(|(e, _)| e);
    let rates = angles.map(|(_, leaf)| Leaf { rate: 1, ..leaf });
    let [dtheta, dpsi, dphi] = rates.map(|leaf| g.leaf(leaf));
    let others = ["E2", "m_3", "I_1", "I_2", "I_3"].map(|name| symbol(&mut g, name));
    let [e2, m3, i1, i2, i3] = others.map(|(e, _)| e);
    let one = g.integer(1);
    let [i1, i2, i3] = [i1, i2, i3].map(|i| g.div(one, i));
    let (i12, i13) = (g.sub(i1, i2), g.sub(i1, i3));
    let [st, ct] = [Op::Sin, Op::Cos].map(|op| g.unary(op, theta));
    let [sp, cp] = [Op::Sin, Op::Cos].map(|op| g.unary(op, psi));
    let product = |g: &mut Graph, factors: &[Expr]| {
        let (first, rest) = factors.split_first().expect("at least one factor");
        rest.iter().fold(*first, |p, &f| g.mul(p, f))
    };
    let mut residuals = Vec::new();
    // t9a
    let right = product(&mut g, &[m3, i12, st, sp, cp]);
    residuals.push(g.sub(dtheta, right));
    // t9b
    let (sp2, cp2, st2) = (g.powi(sp, 2), g.powi(cp, 2), g.powi(st, 2));
    let (x, y) = (product(&mut g, &[m3, i1, sp2]), product(&mut g, &[m3, i2, cp2]));
    let rate = g.add(x, y);
    residuals.push(g.sub(dphi, rate));
    // t9c
    let slowed = g.neg(rate);
    let (x, y) = (product(&mut g, &[slowed, ct]), product(&mut g, &[m3, i3, ct]));
    let right = g.add(x, y);
    residuals.push(g.sub(dpsi, right));
    // t10
    let m2 = g.powi(m3, 2);
    let bend = g.mul(i12, cp2);
    let under = g.sub(i13, bend);
    let (x, y) = (g.mul(m2, i3), product(&mut g, &[m2, under, st2]));
    let energy = g.add(x, y);
    residuals.push(g.sub(e2, energy));
    // t11, squared
    let ratio = g.div(dpsi, dphi);
    let left = g.powi(ratio, 2);
    let share = g.div(e2, m2);
    let rest = g.sub(i3, share);
    let other = g.add(rest, under);
    let below = g.sub(i1, bend);
    let (top, below) = (g.mul(under, other), g.powi(below, 2));
    let right = g.div(top, below);
    residuals.push(g.sub(left, right));
    // the derivative of t10's right side
    let slope = g.directional_derivative(energy, |g, leaf| {
        angles.iter().any(|(_, angle)| *angle == leaf).then(|| g.leaf(Leaf { rate: 1, ..leaf }))
    });
    residuals.push(slope.expect("differentiable"));
    // What the angles and their rates are.
    let leaves = entries.map(|(_, leaf)| leaf);
    let moving = leaves.map(|leaf| Leaf { rate: 1, ..leaf });
    let speeds = observables.map(|angle| {
        let speed = g.directional_derivative(angle, |g, leaf| {
            leaves.iter().position(|&entry| entry == leaf).map(|i| g.leaf(moving[i]))
        });
        g.continued(angle, speed.expect("differentiable"))
    });
    let meaning: Vec<(Leaf, Expr)> =
        angles.iter().map(|(_, leaf)| *leaf).chain(rates).zip(observables.into_iter().chain(speeds)).collect();
    let known = |leaf: Leaf| meaning.iter().find(|(of, _)| *of == leaf).map(|(_, e)| *e);
    let residuals: Vec<Expr> = residuals.iter().map(|&e| g.replaced(e, |_, leaf| known(leaf))).collect();
    let residuals = g.without_angles(&residuals, &[]);
    let inputs: Vec<Leaf> = leaves.into_iter().chain(moving).chain(others.iter().map(|(_, leaf)| *leaf)).collect();
    Tape::compile(&g, &inputs, &residuals).expect("all leaves given")
}

/// The worst residuals of all points, block by block.
fn on_tape(tape: &Tape, needed: &Needed, columns: &[Vec<f64>; 11], slots: &mut Slots<Lanes<BLOCK>>) -> [f64; 6] {
    let n = columns[0].len();
    let mut worst = [Lanes::<BLOCK>::splat(0.0); 6];
    for start in (0..n).step_by(BLOCK) {
        let count = BLOCK.min(n - start);
        for (i, column) in columns.iter().enumerate() {
            slots.value_mut(i).0[..count].copy_from_slice(&column[start..start + count]);
        }
        tape.run_some(&(), slots, if start == 0 { &needed.instructions } else { &needed.varying });
        for (i, worst) in worst.iter_mut().enumerate() {
            let residual = slots.value(tape.output_slot(i));
            for (w, r) in worst.0[..count].iter_mut().zip(&residual.0) {
                *w = if r.abs() > *w { r.abs() } else { *w };
            }
        }
    }
    worst.map(|w| w.0.iter().fold(0.0, |a, &b| f64::max(a, b)))
}

#[divan::bench(args = [1_000, 100_000, 1_000_000])]
fn residuals_on_tape(bencher: Bencher, n: usize) {
    let points = points(n);
    let columns: [Vec<f64>; 11] = std::array::from_fn(|i| points.iter().map(|p| p[i]).collect());
    let tape = compile();
    // The constants of the motion do not change, nor does what they alone determine.
    let needed = tape.needed(0..6, &std::array::from_fn::<bool, 15, _>(|i| i < 11));
    let mut slots = tape.slots(&());
    for (i, x) in [M3, INERTIA[0], INERTIA[1], INERTIA[2]].into_iter().enumerate() {
        slots.set(11 + i, Ok(Lanes::splat(x)));
    }
    // The two ways compute the same thing.
    let mut expected = [0.0_f64; 6];
    for p in &points {
        for (w, r) in expected.iter_mut().zip(by_hand(p)) {
            *w = w.max(r.abs());
        }
    }
    for (a, b) in on_tape(&tape, &needed, &columns, &mut slots).into_iter().zip(expected) {
        assert!((a - b).abs() <= 1e-9 * b.abs(), "{a} {b}");
    }
    bencher.counter(ItemsCount::new(n)).bench_local(|| on_tape(&tape, &needed, black_box(&columns), &mut slots));
}

/// The right sides of the Euler–Poisson equations for R (row by row) and Ω, with I = (1, 2, 3).
fn euler_poisson() -> Tape {
    let mut g = Graph::new();
    let leaves: Vec<Leaf> = (0..12)
        .map(|i| {
            let symbol = g.declare(&format!("x_{{{i}}}"), Shape::scalar(), false);
            Leaf::now(symbol, 0)
        })
        .collect();
    let x: Vec<Expr> = leaves.iter().map(|&leaf| g.leaf(leaf)).collect();
    let omega = [x[9], x[10], x[11]];
    let mut roots = Vec::new();
    for row in x[..9].chunks(3) {
        for j in 0..3 {
            let (k, l) = ((j + 1) % 3, (j + 2) % 3);
            let (p, q) = (g.mul(row[k], omega[l]), g.mul(row[l], omega[k]));
            roots.push(g.sub(p, q));
        }
    }
    let inertia = [1_i64, 2, 3];
    for j in 0..3 {
        let (k, l) = ((j + 1) % 3, (j + 2) % 3);
        let factor = g.constant(Rational::from(inertia[k] - inertia[l]) / Rational::from(inertia[j]));
        let p = g.mul(omega[k], omega[l]);
        roots.push(g.mul(factor, p));
    }
    Tape::compile(&g, &leaves, &roots).expect("all leaves given")
}

/// All coefficients of one step, order by order, as an integrator computes them.
fn series<B: rederive::number::Scalar>(tape: &Tape, slots: &mut Slots<Jet<B>>, start: &[B; 12], degree: usize) {
    for (i, &x) in start.iter().enumerate() {
        slots.value_mut(i).set_coefficient(0, x);
    }
    for k in 0..degree {
        tape.run(&Orders::only(k, degree), slots);
        for i in 0..12 {
            let next = slots.value(tape.output_slot(i)).coefficient(k) / B::integer(k as i32 + 1);
            slots.value_mut(i).set_coefficient(k + 1, next);
        }
    }
}

/// One step of order `degree` over a base type, `lanes` trajectories at once.
fn step<B: rederive::number::Scalar>(bencher: Bencher, degree: usize, lanes: usize, of: impl Fn(f64) -> B) {
    let tape = euler_poisson();
    let mut slots: Slots<Jet<B>> = tape.slots(&Orders::all(degree));
    let start = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.01, 1.0, 0.01].map(of);
    bencher.counter(ItemsCount::new(lanes)).bench_local(|| series(&tape, &mut slots, black_box(&start), degree));
}

#[divan::bench]
fn taylor_step_order_20(bencher: Bencher) {
    step(bencher, 20, 1, |x| x);
}

#[divan::bench]
fn taylor_step_order_20_bounded(bencher: Bencher) {
    step(bencher, 20, 1, rederive::number::Bounded::exact);
}

#[divan::bench]
fn taylor_step_order_20_of_8_trajectories(bencher: Bencher) {
    step(bencher, 20, 8, Lanes::<8>::splat);
}
