//! Euler–Poisson equations, 12 unknowns, I = (1, 2, 3), Ω(0) = (0.01, 1, 0.01), R(0) = 1, t = 0 … 100, to 1e-15: the tape
//! against the same method written by hand. Figures per trajectory; `cargo bench --bench flow`.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

#[path = "../tests/flow_support/mod.rs"]
mod flow_support;

use flow_support::{UNIT, World, rigid_states};
use rederive::flow::{Draft, Estimation, Setup, Source, VectorField};

fn main() {
    divan::main();
}

const SPAN: f64 = 100.0;

fn world() -> (World, VectorField) {
    let mut w = World::default();
    let field = flow_support::rigid_body(&mut w);
    (w, field)
}

/// The motion through the unit attitude, with its principal moments of inertia.
fn setup<'f>(w: &mut World, field: &'f VectorField, first_moment: &str) -> Setup<'f> {
    let values: Vec<(&str, &str)> =
        rigid_states().into_iter().zip(UNIT.into_iter().chain(["0.01", "1", "0.01"])).collect();
    let initial = w.pairs(&values);
    let parameters = w.pairs(&[("I1", first_moment), ("I2", "2"), ("I3", "3")]);
    let source = Source::Integrated { field, initial, start: Default::default() };
    Setup { time: w.leaf("t"), span: (0.0, SPAN), initial_time: 0.0, parameters, source, observables: Vec::new() }
}

/// One integration on the tape, without the error estimate: steps and dense output.
#[divan::bench]
fn tape_one_integration(bencher: divan::Bencher) {
    let (mut w, field) = world();
    let setup = setup(&mut w, &field, "1");
    let motion = rederive::flow::Motion::new(&mut w.graph, setup).unwrap();
    bencher.bench_local(|| motion.integrate_again());
}

/// Eight motions side by side, as those of one file are integrated, with their error estimates: per motion.
#[divan::bench(args = [Estimation::Companions, Estimation::Steps])]
fn tape_motions_with_error_estimates(bencher: divan::Bencher, estimation: Estimation) {
    let (mut w, field) = world();
    let moments = ["1", "1.1", "1.2", "1.3", "1.4", "1.5", "1.6", "1.7"];
    let mut drafts = || moments.map(|first| setup(&mut w, &field, first)).map(|s| Draft::new(&mut w.graph, s).unwrap());
    bencher
        .counter(divan::counter::ItemsCount::new(moments.len()))
        .with_inputs(&mut drafts)
        .bench_local_refs(|drafts: &mut [Draft; 8]| Draft::integrate(drafts, estimation, &|| false));
}

/// The whole motion: integration, error estimate, compilation.
#[divan::bench]
fn tape_motion_with_error_estimate(bencher: divan::Bencher) {
    let (mut w, field) = world();
    let values: Vec<(&str, &str)> =
        rigid_states().into_iter().zip(UNIT.into_iter().chain(["0.01", "1", "0.01"])).collect();
    let parameters = [("I1", "1"), ("I2", "2"), ("I3", "3")];
    bencher.bench_local(|| w.integrate(&field, &values, &parameters, &[], (0.0, SPAN), 0.0).unwrap().steps());
}

/// The same equations, order and step choice by hand.
#[divan::bench]
fn by_hand(bencher: divan::Bencher) {
    bencher.bench_local(|| hand::integrate(divan::black_box([0.01, 1.0, 0.01]), SPAN));
}

/// Values of Ω, R and Ṙ with error bounds at one time.
#[divan::bench]
fn values_at_a_time(bencher: divan::Bencher) {
    let (mut w, field) = world();
    let values: Vec<(&str, &str)> =
        rigid_states().into_iter().zip(UNIT.into_iter().chain(["0.01", "1", "0.01"])).collect();
    let parameters = [("I1", "1"), ("I2", "2"), ("I3", "3")];
    let angle = [("theta~", "atan2(sqrt(R31^2+R32^2),R33)"), ("psi~", "atan2(R31,R32)"), ("phi~", "atan2(R13,0-R23)")];
    let mut m = w.integrate(&field, &values, &parameters, &angle, (0.0, SPAN), 0.0).unwrap();
    w.prepare(&mut m, &["theta", "psi", "phi", "theta'", "psi'", "phi'", "O1", "O2", "O3"]);
    bencher.bench_local(|| m.at(divan::black_box(37.3)));
}

/// A long motion (about 2200 steps) with its error estimate and three Euler angles that are followed.
#[divan::bench(sample_count = 10)]
fn long_motion_with_angles(bencher: divan::Bencher) {
    let (mut w, field) = world();
    let values: Vec<(&str, &str)> =
        rigid_states().into_iter().zip(UNIT.into_iter().chain(["0.6", "-1.1", "1.7"])).collect();
    let parameters = [("I1", "1.9"), ("I2", "1.4"), ("I3", "0.7")];
    let angle = [("theta~", "atan2(sqrt(R31^2+R32^2),R33)"), ("psi~", "atan2(R31,R32)"), ("phi~", "atan2(R13,0-R23)")];
    bencher.bench_local(|| w.integrate(&field, &values, &parameters, &angle, (0.0, 1000.0), 0.0).unwrap().steps());
}

/// All sign changes of R₃₃ on t = 0 … 100.
#[divan::bench(sample_count = 20)]
fn zeros_of_a_component(bencher: divan::Bencher) {
    let (mut w, field) = world();
    let values: Vec<(&str, &str)> =
        rigid_states().into_iter().zip(UNIT.into_iter().chain(["0.6", "-1.1", "1.7"])).collect();
    let parameters = [("I1", "1.9"), ("I2", "1.4"), ("I3", "0.7")];
    let m = w.integrate(&field, &values, &parameters, &[], (0.0, SPAN), 0.0).unwrap();
    let g = w.e("R33");
    bencher.bench_local(|| m.zeros(&mut w.graph, g).unwrap().times.len());
}

mod hand {
    const ORDER: usize = 20;
    type Jet = [f64; ORDER + 1];

    fn product(a: &Jet, b: &Jet, k: usize) -> f64 {
        (0..=k).map(|i| a[i] * b[k - i]).sum()
    }

    pub fn integrate(omega: [f64; 3], end: f64) -> (usize, [f64; 12]) {
        let inertia = [1.0, 2.0, 3.0];
        let mut x = [0.0; 12];
        (x[0], x[4], x[8]) = (1.0, 1.0, 1.0);
        x[9..].copy_from_slice(&omega);
        let mut low = [0.0; 12];
        let mut t = 0.0;
        let mut steps = 0;
        let mut dense: Vec<[Jet; 12]> = Vec::new();
        while t < end {
            let mut s = [[0.0; ORDER + 1]; 12];
            for (jet, x) in s.iter_mut().zip(x) {
                jet[0] = x;
            }
            for k in 0..ORDER {
                let share = 1.0 / (k + 1) as f64;
                for i in 0..3 {
                    for (j, a, b) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
                        let rate = product(&s[9 + b], &s[3 * i + a], k) - product(&s[9 + a], &s[3 * i + b], k);
                        s[3 * i + j][k + 1] = rate * share;
                    }
                }
                for (j, a, b) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
                    let factor = (inertia[a] - inertia[b]) / inertia[j];
                    s[9 + j][k + 1] = factor * product(&s[9 + a], &s[9 + b], k) * share;
                }
            }
            let size = |k: usize| s.iter().map(|j| j[k].abs()).fold(0.0, f64::max);
            let radius = |k: usize| (size(0) / size(k)).powf(1.0 / k as f64);
            let mut h = radius(ORDER).min(radius(ORDER - 1)) * (-2.0 - 0.7 / 19.0_f64).exp();
            if t + h > end {
                h = end - t;
            }
            for i in 0..12 {
                let inner = s[i][1..].iter().rev().fold(0.0, |sum, c| sum * h + c);
                let y = low[i] + h * inner;
                let new = x[i] + y;
                let virtual_part = new - x[i];
                low[i] = (x[i] - (new - virtual_part)) + (y - virtual_part);
                x[i] = new;
            }
            dense.push(s);
            t += h;
            steps += 1;
        }
        divan::black_box(&dense);
        (steps, x)
    }
}
