//! Integration against solutions that are known by formula.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use crate::flow_support::{UNIT, World, rigid_motion};
use rederive::flow::{FlowError, Problem};

/// The largest |numerical − exact| over the span, which must lie within the claimed error at every time.
fn worst(world: &mut World, motion: &mut rederive::flow::Motion, name: &str, exact: impl Fn(f64) -> f64) -> (f64, f64) {
    world.prepare(motion, &[name]);
    let (mut worst, mut claimed) = (0.0_f64, 0.0_f64);
    for t in motion.sample_times(5) {
        let x = motion.at(t)[0].unwrap();
        let off = (x.value - exact(t)).abs();
        // The formula itself is rounded.
        let slack = 4.0 * f64::EPSILON * (1.0 + exact(t).abs());
        assert!(off <= x.error + slack, "{name} at {t}: off by {off:e}, claimed {:e}", x.error);
        worst = worst.max(off);
        claimed = claimed.max(x.error);
    }
    (worst, claimed)
}

#[test]
fn harmonic_oscillator_as_a_system_of_second_order() {
    let mut w = World::default();
    let field = w.field(&["x"], &["m*x'' + k*x = 0"]).unwrap();
    assert_eq!(field.states().len(), 2);
    let initial = [("x", "0.3"), ("x'", "1.7")];
    let mut m = w.integrate(&field, &initial, &[("m", "0.7"), ("k", "2.3")], &[], (0.0, 100.0), 0.0).unwrap();
    assert_eq!(m.problem(), None);
    let omega = (2.3_f64 / 0.7).sqrt();
    let (off, claimed) = worst(&mut w, &mut m, "x", |t| 0.3 * (omega * t).cos() + 1.7 / omega * (omega * t).sin());
    assert!(off < 1e-12 && claimed < 1e3 * off, "{off:e} {claimed:e}");
    worst(&mut w, &mut m, "x'", |t| -0.3 * omega * (omega * t).sin() + 1.7 * (omega * t).cos());
    worst(&mut w, &mut m, "x''", |t| -omega * omega * (0.3 * (omega * t).cos() + 1.7 / omega * (omega * t).sin()));
}

/// A circle in polar coordinates: the radius and its rate rest up to the rounding of two terms that cancel. No step is short
/// enough to follow that.
#[test]
fn what_rests_but_for_rounding_does_not_stop_the_integrator() {
    let mut w = World::default();
    let field = w.field(&["r", "p", "f"], &["r' = p", "p' = 1.1*10/r^3 - 1.1/r^2", "f' = sqrt(11)/r^2"]).unwrap();
    let initial = [("r", "10"), ("p", "0"), ("f", "0")];
    let mut m = w.integrate(&field, &initial, &[], &[], (0.0, 500.0), 0.0).unwrap();
    assert_eq!(m.problem(), None);
    let (off, claimed) = worst(&mut w, &mut m, "r", |_| 10.0);
    assert!(off < 1e-11 && claimed < 1e-8, "{off:e} {claimed:e}");
    worst(&mut w, &mut m, "f", |t| 11_f64.sqrt() / 100.0 * t);
}

#[test]
fn kepler_orbit_of_high_eccentricity() {
    let mut w = World::default();
    let field = w.field(&["x", "y"], &["x'' = -x/sqrt(x^2+y^2)^3", "y'' = -y/sqrt(x^2+y^2)^3"]).unwrap();
    // At perihelion: r = 1 − e, v² = (1 + e)/(1 − e), e = 0.9.
    let initial = [("x", "0.1"), ("y", "0"), ("x'", "0"), ("y'", "sqrt(19)")];
    let span = (0.0, 6.0 * std::f64::consts::TAU);
    let mut m = w.integrate(&field, &initial, &[], &[], span, 0.0).unwrap();
    assert_eq!(m.problem(), None);
    let anomaly = |t: f64| {
        let e = 0.9;
        let mean = t;
        let mut u = mean + e * mean.sin();
        for _ in 0..100 {
            u -= (u - e * u.sin() - mean) / (1.0 - e * u.cos());
        }
        u
    };
    let (off, claimed) = worst(&mut w, &mut m, "x", |t| anomaly(t).cos() - 0.9);
    assert!(off < 1e-11 && claimed < 1e4 * off, "{off:e} {claimed:e}");
    worst(&mut w, &mut m, "y", |t| 0.19_f64.sqrt() * anomaly(t).sin());
}

#[test]
fn fields_that_depend_on_time() {
    let mut w = World::default();
    let field = w.field(&["y", "z"], &["y' = 7*t^6", "z' = z + t"]).unwrap();
    let mut m = w.integrate(&field, &[("y", "0"), ("z", "1")], &[], &[], (0.0, 3.0), 0.0).unwrap();
    let (off, _) = worst(&mut w, &mut m, "y", |t| t.powi(7));
    assert!(off < 1e-12 * 2187.0, "{off:e}");
    let (off, _) = worst(&mut w, &mut m, "z", |t| 2.0 * t.exp() - t - 1.0);
    assert!(off < 1e-13, "{off:e}");
}

#[test]
fn a_series_that_starts_with_many_zeros_is_not_mistaken_for_a_constant() {
    let mut w = World::default();
    let field = w.field(&["y"], &["y' = t^39/(1+t^40)"]).unwrap();
    let mut m = w.integrate(&field, &[("y", "0")], &[], &[], (0.0, 16.0), 0.0).unwrap();
    let (off, _) = worst(&mut w, &mut m, "y", |t| t.powi(40).ln_1p() / 40.0);
    assert!(off < 1e-13, "{off:e}");
}

#[test]
fn forward_and_backward_from_the_middle() {
    let mut w = World::default();
    let field = w.field(&["x"], &["x' = -x*t"]).unwrap();
    let mut m = w.integrate(&field, &[("x", "2")], &[], &[], (-3.0, 4.0), 1.0).unwrap();
    assert_eq!(m.span(), (-3.0, 4.0));
    let (off, _) = worst(&mut w, &mut m, "x", |t| 2.0 * (0.5 - 0.5 * t * t).exp());
    assert!(off < 1e-13, "{off:e}");
    let mut back = w.integrate(&field, &[("x", "2")], &[], &[], (-3.0, 1.0), 1.0).unwrap();
    worst(&mut w, &mut back, "x", |t| 2.0 * (0.5 - 0.5 * t * t).exp());
    assert_eq!(back.span(), (-3.0, 1.0));
}

#[test]
fn a_motion_that_blows_up_is_kept_up_to_there() {
    let mut w = World::default();
    let field = w.field(&["x"], &["x' = x^2"]).unwrap();
    let mut m = w.integrate(&field, &[("x", "1")], &[], &[], (0.0, 3.0), 0.0).unwrap();
    let Some(Problem::StepCollapsed { time }) = m.problem().cloned() else { panic!("{:?}", m.problem()) };
    assert!((0.999..=1.0).contains(&time), "{time}");
    assert_eq!(m.span().1, time);
    w.prepare(&mut m, &["x"]);
    let x = m.at(0.5)[0].unwrap();
    assert!((x.value - 2.0).abs() < 1e-14);
    assert!(m.at(2.0)[0].is_err(), "after the pole there is no value");
    for t in m.sample_times(3) {
        if let Ok(x) = m.at(t)[0] {
            assert!((x.value - 1.0 / (1.0 - t)).abs() <= x.error + 1e-15 * x.value.abs(), "{t}");
        }
    }
}

#[test]
fn a_singular_inertia_names_the_state() {
    let mut w = World::default();
    let field = crate::flow_support::rigid_body(&mut w);
    let initial: Vec<(&str, &str)> =
        crate::flow_support::rigid_states().into_iter().zip(UNIT.into_iter().chain(["1", "2", "3"])).collect();
    let parameters = [("I1", "1.9"), ("I2", "0"), ("I3", "0.7")];
    let error = w.integrate(&field, &initial, &parameters, &[], (0.0, 1.0), 0.0).unwrap_err();
    assert!(matches!(&error, FlowError::Singular { state, .. } if state == "O2"), "{error}");
    assert!(error.to_string().contains("O2"));
}

#[test]
fn a_rate_that_loses_its_value_on_the_way() {
    let mut w = World::default();
    // x reaches 0 at t = 1, where the rate of y ends.
    let field = w.field(&["x", "y"], &["x' = -1", "y' = sqrt(x)"]).unwrap();
    let m = w.integrate(&field, &[("x", "1"), ("y", "0")], &[], &[], (0.0, 3.0), 0.0).unwrap();
    assert!(m.problem().is_some());
    assert!(m.span().1 > 0.9 && m.span().1 <= 1.0 + 1e-12, "{:?}", m.span());
}

#[test]
fn spans_are_checked() {
    let mut w = World::default();
    let field = w.field(&["x"], &["x' = x"]).unwrap();
    for (span, initial) in [((1.0, 0.0), 0.5), ((0.0, 1.0), 2.0), ((0.0, f64::NAN), 0.0), ((0.0, 0.0), 0.0)] {
        let error = w.integrate(&field, &[("x", "1")], &[], &[], span, initial).unwrap_err();
        assert!(matches!(error, FlowError::Span { .. }));
    }
    let missing = w.integrate(&field, &[], &[], &[], (0.0, 1.0), 0.0).unwrap_err();
    assert_eq!(missing.to_string(), "no initial value is given for x");
    let undefined = w.integrate(&field, &[("x", "sqrt(-1)")], &[], &[], (0.0, 1.0), 0.0).unwrap_err();
    assert!(matches!(undefined, FlowError::Undefined { .. }));
}

#[test]
fn exact_zeros_stay_exact_on_an_unstable_equilibrium() {
    let mut w = World::default();
    let mut m = rigid_motion(&mut w, ["0.6", "1.3", "1.1"], UNIT, ["0", "0", "2.1"], &[], (0.0, 20.0));
    w.prepare(&mut m, &["O1", "R31", "O3", "R11"]);
    let x = m.at(17.0);
    assert_eq!((x[0].unwrap().value, x[0].unwrap().error), (0.0, 0.0));
    assert_eq!((x[1].unwrap().value, x[1].unwrap().error), (0.0, 0.0));
    assert_eq!(x[2].unwrap().value, 2.1);
    let r = x[3].unwrap();
    assert!((r.value - (2.1_f64 * 17.0).cos()).abs() <= r.error + 1e-14);
}

/// The Lorenz system by a Taylor series of order 40 with 200 bits and steps of 1/64: far more than binary64 can see.
mod reference {
    use dashu_float::FBig;
    type Real = FBig;
    const ORDER: usize = 40;

    fn real(x: i32) -> Real {
        Real::from(x).with_precision(200).value()
    }

    pub fn lorenz(times: usize) -> Vec<[f64; 3]> {
        let mut at = [real(1), real(2), real(20)];
        let h = real(1) / real(64);
        let beta = real(8) / real(3);
        let mut out = vec![[1.0, 2.0, 20.0]];
        for _ in 0..times {
            for _ in 0..64 {
                let [mut x, mut y, mut z] = at.map(|v| vec![v]);
                for k in 0..ORDER {
                    let product =
                        |a: &[Real], b: &[Real]| (0..=k).fold(real(0), |sum, i| sum + a[i].clone() * b[k - i].clone());
                    let (xy, xz) = (product(&x, &y), product(&x, &z));
                    let n = real(k as i32 + 1);
                    let dx = (y[k].clone() - x[k].clone()) * real(10);
                    let dy = x[k].clone() * real(28) - xz - y[k].clone();
                    let dz = xy - beta.clone() * z[k].clone();
                    x.push(dx / n.clone());
                    y.push(dy / n.clone());
                    z.push(dz / n);
                }
                at = [x, y, z].map(|c| c.into_iter().rev().reduce(|sum, c| sum * h.clone() + c).unwrap());
            }
            out.push(at.each_ref().map(|v| v.to_f64().value()));
        }
        out
    }
}

#[test]
fn the_estimated_error_follows_the_true_one_in_a_chaotic_system() {
    let mut w = World::default();
    let field = w.field(&["x", "y", "z"], &["x' = s*(y-x)", "y' = x*(r-z)-y", "z' = x*y-b*z"]).unwrap();
    let initial = [("x", "1"), ("y", "2"), ("z", "20")];
    let parameters = [("s", "10"), ("r", "28"), ("b", "8/3")];
    let mut m = w.integrate(&field, &initial, &parameters, &[], (0.0, 20.0), 0.0).unwrap();
    w.prepare(&mut m, &["x", "y", "z"]);
    let mut largest = [0.0_f64; 3];
    for (t, exact) in reference::lorenz(20).iter().enumerate() {
        for ((x, exact), largest) in m.at(t as f64).iter().zip(exact).zip(&mut largest) {
            let x = x.unwrap();
            let off = (x.value - exact).abs();
            *largest = largest.max(off);
            assert!(off <= x.error + f64::EPSILON * exact.abs(), "t = {t}: {off:e} against {:e}", x.error);
            assert!(t < 3 || x.error < 1e4 * *largest, "t = {t}: {largest:e} against {:e}", x.error);
        }
    }
    assert!(largest[0] > 1e-11, "the system amplifies rounding: {largest:?}");
}
