//! What a motion knows beside its states: observables, angles, values at fixed times, derived motions, formulas.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use crate::flow_support::{UNIT, World, rigid_motion};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use rederive::flow::{FlowError, Motion, Setup, Source};
use rederive::number::NoValue;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

const ANGLES: [(&str, &str); 3] =
    [("theta~", "atan2(sqrt(R31^2+R32^2),R33)"), ("psi~", "atan2(R31,R32)"), ("phi~", "atan2(R13,0-R23)")];

/// R(0) from Euler angles, Ω for m along z.
fn euler(world: &mut World, moments: [&str; 3], m3: &str, angles: [&str; 3], span: (f64, f64)) -> Motion {
    let [f, h, s] = angles;
    let fill = |e: &str| e.replace('F', f).replace('H', h).replace('S', s).replace('M', m3);
    let rotation = [
        "cos(F)*cos(S)-sin(F)*cos(H)*sin(S)",
        "0-cos(F)*sin(S)-sin(F)*cos(H)*cos(S)",
        "sin(F)*sin(H)",
        "sin(F)*cos(S)+cos(F)*cos(H)*sin(S)",
        "0-sin(F)*sin(S)+cos(F)*cos(H)*cos(S)",
        "0-cos(F)*sin(H)",
        "sin(H)*sin(S)",
        "sin(H)*cos(S)",
        "cos(H)",
    ]
    .map(fill);
    let omega = ["M*sin(H)*sin(S)/I1", "M*sin(H)*cos(S)/I2", "M*cos(H)/I3"].map(fill);
    rigid_motion(
        world,
        moments,
        rotation.each_ref().map(String::as_str),
        omega.each_ref().map(String::as_str),
        &ANGLES,
        span,
    )
}

fn value(m: &Motion, t: f64, i: usize) -> f64 {
    m.at(t)[i].unwrap().value
}

/// Neighbouring samples of a continuous angle differ by less than the fastest rate times their distance, on a fine grid.
fn assert_continuous(m: &Motion, index: usize, rate: usize) {
    let times = m.sample_times(60);
    for pair in times.windows(2) {
        let (a, b) = (m.at(pair[0]), m.at(pair[1]));
        let (Ok(x), Ok(y)) = (a[index], b[index]) else { continue };
        let speed = a[rate].map_or(0.0, |r| r.value.abs()).max(b[rate].map_or(0.0, |r| r.value.abs()));
        let dt = pair[1] - pair[0];
        let step = (x.value - y.value).abs();
        assert!(step <= 3.5 * speed * dt + 0.3, "jump by {step} between {} and {}", pair[0], pair[1]);
        assert!(step < 3.3, "jump by {step} between {} and {}", pair[0], pair[1]);
    }
}

#[test]
fn euler_angles_of_a_rotating_racket_are_continuous_and_have_their_rates() {
    let mut w = World::default();
    let mut m = euler(&mut w, ["1.9", "1.4", "0.7"], "2.2", ["0.3", "0.7", "0.4"], (0.0, 60.0));
    w.prepare(&mut m, &["theta", "psi", "phi", "theta'", "psi'", "phi'", "O1", "O2", "O3"]);
    assert_continuous(&m, 1, 4);
    // Surveyed independently: psi goes from 0.4 to 83.39 on this span.
    assert_abs_diff_eq!(value(&m, 0.0, 1), 0.4, epsilon = 1e-14);
    assert!((value(&m, 60.0, 1) - 83.39).abs() < 0.01, "{}", value(&m, 60.0, 1));
    for t in m.sample_times(3) {
        let x: Vec<f64> = m.at(t).iter().map(|x| x.unwrap().value).collect();
        let [theta, psi, _, dtheta, dpsi, dphi, o1, o2, o3] = x[..] else { panic!() };
        let error = m.at(t).iter().fold(0.0_f64, |a, x| a.max(x.unwrap().error));
        let phi_rate = (o1 * psi.sin() + o2 * psi.cos()) / theta.sin();
        assert!((dtheta - (o1 * psi.cos() - o2 * psi.sin())).abs() < 10.0 * error);
        assert!((dphi - phi_rate).abs() < 20.0 * error);
        assert!((dpsi - (o3 - phi_rate * theta.cos())).abs() < 20.0 * error);
        assert!(error < 1e-9);
    }
}

#[test]
fn a_passage_close_to_the_pole_unwraps() {
    // θ falls to 1.452e-3 at t = 5.9705 and φ, ψ turn by about π within 0.01 time units.
    let mut w = World::default();
    let mut m = euler(&mut w, ["0.6", "1.3", "1.1"], "1.7", ["0.4", "0.05", "0-0.4068"], (0.0, 20.0));
    w.prepare(&mut m, &["psi", "psi'", "phi", "phi'", "theta"]);
    assert_continuous(&m, 0, 1);
    assert_continuous(&m, 2, 3);
    let theta = w.e("theta");
    let least = m.minimum(&mut w.graph, theta).unwrap().unwrap();
    assert!((least.time - 5.9705).abs() < 1e-3 && (least.value.value - 1.452090e-3).abs() < 1e-8, "{least:?}");
    assert!(m.breaks().is_empty(), "{:?}", m.breaks());
    // φ + ψ is smooth through the passage: in numbers, m₃/I₃·t up to terms of the order of θ².
    let sum = |t: f64| value(&m, t, 0) + value(&m, t, 2);
    assert!((sum(7.0) - sum(5.0) - 1.7 / 1.1 * 2.0).abs() < 0.02, "{}", sum(7.0) - sum(5.0));
}

#[test]
fn passages_at_any_distance_turn_the_angle_by_pi_to_the_right_side() {
    let mut w = World::default();
    for (distance, sign) in [("0.002", 1.0), ("0.000001", 1.0), ("0.000000001", 1.0), ("0-0.000001", -1.0)] {
        let setup = Setup {
            time: w.leaf("t"),
            span: (-1.0, 1.0),
            initial_time: -1.0,
            parameters: w.pairs(&[("d", distance)]),
            source: Source::Formula { states: w.pairs(&[("x", "t-0.123"), ("y", "d")]) },
            observables: w.observables(&[("a~", "atan2(y,x)")]),
        };
        let mut m = Motion::new(&mut w.graph, setup).unwrap();
        w.prepare(&mut m, &["a"]);
        let turned = value(&m, 1.0, 0) - value(&m, -1.0, 0);
        assert!((turned + sign * PI).abs() < 0.01, "{distance}: {turned}");
        assert!(m.breaks().is_empty());
    }
    // Round the origin at the distance d², once: the ends look as if nothing had happened.
    for distance in ["0.002", "0.000001"] {
        let setup = Setup {
            time: w.leaf("t"),
            span: (-1.0, 1.0),
            initial_time: -1.0,
            parameters: w.pairs(&[("d", distance)]),
            source: Source::Formula { states: w.pairs(&[("x", "(t-0.123)^2-d^2"), ("y", "2*d*(t-0.123)")]) },
            observables: w.observables(&[("a~", "atan2(y,x)")]),
        };
        let mut m = Motion::new(&mut w.graph, setup).unwrap();
        w.prepare(&mut m, &["a"]);
        let turned = value(&m, 1.0, 0) - value(&m, -1.0, 0);
        assert!((turned - TAU).abs() < 0.02 || (turned + TAU).abs() < 0.02, "{distance}: {turned}");
    }
    // Through the origin there is no side: a new branch starts, and this is said.
    let setup = Setup {
        time: w.leaf("t"),
        span: (-1.0, 1.0),
        initial_time: -1.0,
        parameters: Vec::new(),
        source: Source::Formula { states: w.pairs(&[("x", "t-0.125"), ("y", "0")]) },
        observables: w.observables(&[("a~", "atan2(y,x)")]),
    };
    let mut m = Motion::new(&mut w.graph, setup).unwrap();
    w.prepare(&mut m, &["a"]);
    assert!(m.at(0.125)[0].is_err());
    assert!(m.breaks().len() == 1 && (m.breaks()[0] - 0.125).abs() < 1e-9, "{:?}", m.breaks());
}

#[test]
fn an_angle_that_makes_many_turns_within_a_stretch() {
    let mut w = World::default();
    let setup = Setup {
        time: w.leaf("t"),
        span: (-3.0, 5.0),
        initial_time: 1.0,
        parameters: Vec::new(),
        source: Source::Formula { states: w.pairs(&[("u", "50*t^2")]) },
        // The second angle is defined by the first, turns included.
        observables: w.observables(&[("a~", "atan2(sin(u),cos(u))"), ("b", "a/2"), ("c~", "atan2(sin(b),cos(b))")]),
    };
    let mut m = Motion::new(&mut w.graph, setup).unwrap();
    w.prepare(&mut m, &["a", "a'", "b", "c"]);
    let start = 50.0 - TAU * (50.0 / TAU).round();
    for t in m.sample_times(7) {
        let expected = start + 50.0 * (t * t - 1.0);
        assert!((value(&m, t, 0) - expected).abs() < 1e-10, "{t}");
        assert!((value(&m, t, 1) - 100.0 * t).abs() < 1e-9);
        assert!((value(&m, t, 2) - expected / 2.0).abs() < 1e-10);
        let turns = (value(&m, t, 3) - expected / 2.0) / TAU;
        assert!((turns - turns.round()).abs() < 1e-10);
        assert!((value(&m, t, 3) - value(&m, 1.0, 3) - 25.0 * (t * t - 1.0)).abs() < 1e-10);
    }
}

#[test]
fn a_rotation_that_starts_at_the_pole_has_no_angle_there() {
    let mut w = World::default();
    let mut m = rigid_motion(&mut w, ["1.9", "1.4", "0.7"], UNIT, ["0.6", "-1.1", "1.7"], &ANGLES, (0.0, 40.0));
    w.prepare(&mut m, &["psi", "theta", "psi'", "theta'"]);
    let start = m.at(0.0);
    assert_eq!(start[0], Err(NoValue::OutOfDomain));
    assert_eq!(start[1].unwrap().value, 0.0);
    assert!(start[3].is_err(), "the rate of θ has two one-sided limits at θ = 0");
    assert_continuous(&m, 0, 2);
    // Surveyed independently: ψ reaches 60.66 up to a multiple of π, θ 2.096.
    assert!(m.at(1e-7)[0].is_ok());
    // An exactly stationary axis never has an angle.
    let mut s = rigid_motion(&mut w, ["0.6", "1.3", "1.1"], UNIT, ["0", "0", "2.1"], &ANGLES, (0.0, 20.0));
    w.prepare(&mut s, &["psi", "theta"]);
    assert!(s.sample_times(2).iter().all(|&t| s.at(t)[0].is_err() && s.at(t)[1].unwrap().value == 0.0));
}

#[test]
fn dual_numbers_and_series_agree() {
    let mut w = World::default();
    let mut m = euler(&mut w, ["1.748", "1.638", "0.121"], "2.7", ["0.3", "1.5645", "0.08"], (0.0, 40.0));
    let names = ["theta", "psi'", "phi'", "psi''", "O1", "O2'", "R33''", "t", "I3", "I3'", "t'"];
    w.prepare(&mut m, &names);
    for t in m.sample_times(2) {
        for ((x, d), name) in m.at(t).iter().zip(m.dual_at(t)).zip(names) {
            let (x, d) = (x.unwrap(), d.unwrap());
            assert!((x.value - d.re).abs() <= x.error + 1e-300, "{name} at {t}: {x:?} {d:?}");
        }
        let (x, d) = (m.at(t), m.dual_at(t));
        assert!((x[3].unwrap().value - d[1].unwrap().eps).abs() <= x[3].unwrap().error);
        assert_eq!((x[7].unwrap().value, x[8].unwrap().value), (t, 0.121));
        assert_eq!((x[9].unwrap().value, x[10].unwrap().value), (0.0, 1.0));
    }
}

#[test]
fn parameters_without_a_value_spoil_only_what_needs_them() {
    let mut w = World::default();
    let setup = Setup {
        time: w.leaf("t"),
        span: (0.0, 2.0),
        initial_time: 0.0,
        parameters: w.pairs(&[("a", "2"), ("b", "sqrt(1-a)"), ("c", "b+1"), ("d", "a/3")]),
        source: Source::Formula { states: w.pairs(&[("x", "d*t")]) },
        observables: w.observables(&[("y", "x+c"), ("z", "x^2")]),
    };
    let mut m = Motion::new(&mut w.graph, setup).unwrap();
    w.prepare(&mut m, &["b", "c", "y", "z", "z'", "d"]);
    let x = m.at(1.5);
    assert_eq!([x[0], x[1], x[2]], [Err(NoValue::OutOfDomain); 3]);
    assert_abs_diff_eq!(x[3].unwrap().value, 1.0, epsilon = 1e-15);
    assert_relative_eq!(x[4].unwrap().value, 4.0 / 3.0, max_relative = 1e-15);
    assert!(x[5].unwrap().error > 0.0, "2/3 is rounded");
}

#[test]
fn a_formula_gets_its_rates_from_the_time() {
    let mut w = World::default();
    let setup = Setup {
        time: w.leaf("t"),
        span: (-8.0, 14.0),
        initial_time: 0.0,
        parameters: w.pairs(&[("c", "0.04"), ("k", "0.55")]),
        source: Source::Formula { states: w.pairs(&[("h", "acos((1-c*exp(2*k*t))/(1+c*exp(2*k*t)))")]) },
        observables: w.observables(&[("s", "sin(h)")]),
    };
    let mut m = Motion::new(&mut w.graph, setup).unwrap();
    w.prepare(&mut m, &["h", "h'", "s", "s''", "h@0"]);
    for t in m.sample_times(6) {
        let x = m.at(t);
        // tan(h/2) = √c·e^{kt}, so ḣ = k·sin h.
        let (h, rate, s) = (x[0].unwrap(), x[1].unwrap(), x[2].unwrap());
        assert!((rate.value - 0.55 * s.value).abs() <= rate.error + s.error, "{t}");
        assert!((h.value - 2.0 * (0.2 * (0.55 * t).exp()).atan()).abs() <= h.error + 1e-15);
    }
    assert!((value(&m, 3.0, 4) - 2.0 * 0.2_f64.atan()).abs() < 1e-15);
    assert!(m.sample_times(6).len() > 100 && m.steps() == 0);
}

#[test]
fn derived_motions() {
    let mut w = World::default();
    let omega = ["0.6", "-1.1", "1.7"];
    let source = Arc::new(rigid_motion(&mut w, ["1.9", "1.4", "0.7"], UNIT, omega, &ANGLES, (0.0, 20.0)));
    // Seen from a laboratory turned by a quarter about x; parameters of the same name mean something else here.
    let mut names = Vec::new();
    let mut maps = Vec::new();
    for j in 1..=3 {
        names.push((format!("R1{j}"), format!("R1{j}")));
        names.push((format!("R2{j}"), format!("0-R3{j}")));
        names.push((format!("R3{j}"), format!("R2{j}")));
        // S = R(t)·R(2)ᵀ, first row.
        maps.push((format!("S1{j}"), (1..=3).map(|k| format!("R1{k}*R{j}{k}@2")).collect::<Vec<_>>().join("+")));
    }
    names.extend(maps);
    names.push(("p".to_owned(), "psi-psi@3".to_owned()));
    names.push(("J1".to_owned(), "I1*O1'".to_owned()));
    let list: Vec<(&str, &str)> = names.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
    let setup = Setup {
        time: w.leaf("t"),
        span: (0.0, 1.0),
        initial_time: 0.0,
        parameters: w.pairs(&[("I1", "100")]),
        source: Source::Derived { from: Arc::clone(&source), states: w.pairs(&list) },
        observables: w.observables(&[("q", "I1*R22"), ("norm", "S11^2+S12^2+S13^2")]),
    };
    let mut m = Motion::new(&mut w.graph, setup).unwrap();
    assert_eq!(m.span(), (0.0, 20.0));
    let mut plain = (*source).clone();
    w.prepare(&mut plain, &["R32", "psi", "O1'", "R32'"]);
    w.prepare(&mut m, &["R22", "q", "p", "J1", "norm", "R22'", "S11"]);
    for t in m.sample_times(2) {
        let (x, y) = (m.at(t), plain.at(t));
        assert_eq!(x[0].unwrap().value, -y[0].unwrap().value);
        assert_eq!(x[1].unwrap().value, -100.0 * y[0].unwrap().value);
        if let (Ok(p), Ok(psi)) = (x[2], y[1]) {
            let shift = psi.value - plain.at(3.0)[1].unwrap().value;
            assert!((p.value - shift).abs() <= p.error + 1e-14);
        }
        assert!((x[3].unwrap().value - 1.9 * y[2].unwrap().value).abs() <= x[3].unwrap().error);
        let norm = x[4].unwrap();
        assert!((norm.value - 1.0).abs() <= norm.error && norm.error < 1e-12);
        assert_eq!(x[5].unwrap().value, -y[3].unwrap().value);
    }
    assert!((m.at(2.0)[6].unwrap().value - 1.0).abs() < 1e-14);
}

#[test]
fn unknown_leaves_are_named() {
    let mut w = World::default();
    let field = w.field(&["x"], &["x' = a*x"]).unwrap();
    let error = w.integrate(&field, &[("x", "1")], &[], &[], (0.0, 1.0), 0.0).unwrap_err();
    assert!(matches!(&error, FlowError::UnknownLeaf { leaf } if leaf == "a"), "{error}");
    let mut m = w.integrate(&field, &[("x", "1")], &[("a", "1")], &[], (0.0, 1.0), 0.0).unwrap();
    let leaf = w.leaf("nothing'");
    assert!(m.prepare(&mut w.graph, &[leaf]).is_err());
}

#[test]
fn one_motion_on_many_threads() {
    fn shared<T: Send + Sync>(_: &T) {}
    let mut w = World::default();
    let mut m = euler(&mut w, ["1.9", "1.4", "0.7"], "2.2", ["0.3", "0.7", "0.4"], (0.0, 20.0));
    shared(&m);
    w.prepare(&mut m, &["psi", "phi'"]);
    let times = m.sample_times(5);
    let one: Vec<_> = times.iter().map(|&t| m.at(t)).collect();
    std::thread::scope(|s| {
        for _ in 0..4 {
            s.spawn(|| {
                let again: Vec<_> = times.iter().map(|&t| m.at(t)).collect();
                assert_eq!(again, one);
            });
        }
    });
}
