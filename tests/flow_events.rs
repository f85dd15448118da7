//! Zeros and minima of expressions along a motion.

#![allow(clippy::disallowed_methods, reason = "an oracle may use the platform's functions")]

use crate::flow_support::World;
use approx::assert_abs_diff_eq;
use rederive::flow::{Incomplete, Motion, Setup, Source, Zeros};
use rederive::number::NoValue;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// sin t and cos t by integration.
fn circle(w: &mut World, span: (f64, f64)) -> Motion {
    let field = w.field(&["x", "y"], &["x' = y", "y' = -x"]).unwrap();
    w.integrate(&field, &[("x", "0"), ("y", "1")], &[], &[("a~", "atan2(x,y)")], span, 0.0).unwrap()
}

fn zeros(w: &mut World, m: &Motion, text: &str) -> Zeros {
    let g = w.e(text);
    m.zeros(&mut w.graph, g).unwrap()
}

fn assert_times(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?} instead of {expected:?}");
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance, "{a} instead of {b}");
    }
}

#[test]
fn simple_zeros_to_the_last_digits() {
    let mut w = World::default();
    let m = circle(&mut w, (0.0, 20.0));
    let found = zeros(&mut w, &m, "y");
    let expected: Vec<f64> = (0..6).map(|k| FRAC_PI_2 + f64::from(k) * PI).collect();
    assert_times(&found.times, &expected, 2e-14);
    assert_eq!((found.touching.len(), found.incomplete.len()), (0, 0));
    assert_times(&found.peaks, &(0..7).map(|k| f64::from(k) * PI).map(|t| t.min(20.0)).collect::<Vec<_>>(), 1e-7);
    let third = zeros(&mut w, &m, "x^3 - 0.5^3");
    let expected: Vec<f64> =
        (0..4).flat_map(|k| [PI / 6.0 + f64::from(k) * TAU, 5.0 * PI / 6.0 + f64::from(k) * TAU]).take(7).collect();
    assert_times(&third.times, &expected, 2e-14);
}

#[test]
fn the_angle_has_gone_round_once() {
    let mut w = World::default();
    let m = circle(&mut w, (0.0, 20.0));
    let found = zeros(&mut w, &m, "a - a@0 - 2*pi");
    assert_times(&found.times, &[TAU], 2e-14);
    assert_eq!(found.incomplete, []);
}

#[test]
fn close_pairs_turning_points_and_near_misses() {
    let mut w = World::default();
    let m = circle(&mut w, (-1.0, 6.2));
    // 1 − 1e-10 is reached at π/2 ∓ 1.414e-5.
    let pair = zeros(&mut w, &m, "x - (1 - 0.0000000001)");
    let width = (2e-10_f64).sqrt();
    assert_times(&pair.times, &[FRAC_PI_2 - width, FRAC_PI_2 + width], 2e-9);
    assert!(pair.touching.is_empty());
    let touch = zeros(&mut w, &m, "x - 1");
    assert!(touch.times.is_empty());
    assert_times(&touch.touching, &[FRAC_PI_2], 1e-7);
    let miss = zeros(&mut w, &m, "x - (1 + 0.0000000001)");
    assert!(miss.times.is_empty() && miss.touching.is_empty(), "{miss:?}");
    let g = w.e("x - 1.25");
    let least = m.minimum(&mut w.graph, g).unwrap().unwrap();
    assert_abs_diff_eq!(least.time, FRAC_PI_2, epsilon = 1e-7);
    assert_abs_diff_eq!(least.value.value, -0.25, epsilon = 1e-14);
    assert_eq!(least.incomplete, None);
    let g = w.e("sqrt(x) + 1");
    assert!(m.minimum(&mut w.graph, g).unwrap().unwrap().incomplete.is_some());
    let triple = zeros(&mut w, &m, "(x - 0.5)^3");
    assert_eq!(triple.times.len(), 2, "{triple:?}");
}

#[test]
fn pairs_at_many_distances_in_one_polynomial() {
    let mut w = World::default();
    for exponent in 1..=6 {
        let d = 10_f64.powi(-exponent);
        let text = format!("(t-0.3)*(t-0.3-{d:.6})*(t-0.7)*(t+0.9)");
        let setup = Setup {
            time: w.leaf("t"),
            span: (-1.0, 1.0),
            initial_time: 0.0,
            parameters: Vec::new(),
            source: Source::Formula { states: w.pairs(&[("x", &text)]) },
            observables: Vec::new(),
        };
        let m = Motion::new(&mut w.graph, setup).unwrap();
        let found = zeros(&mut w, &m, "x");
        assert_times(&found.times, &[-0.9, 0.3, 0.3 + d, 0.7], 1e-15 / d + 1e-15);
        let turning = zeros(&mut w, &m, "x'");
        assert_eq!(turning.times.len(), 3);
    }
}

#[test]
fn zeros_at_the_ends_of_the_span() {
    let mut w = World::default();
    let m = circle(&mut w, (0.0, 3.0));
    let found = zeros(&mut w, &m, "x");
    assert_times(&found.times, &[0.0], 0.0);
    let found = zeros(&mut w, &m, "y - 1");
    assert!(found.times.is_empty());
    assert_times(&found.touching, &[0.0], 1e-7);
}

#[test]
fn what_cannot_be_decided_is_said() {
    let mut w = World::default();
    let m = circle(&mut w, (0.0, 6.0));
    let found = zeros(&mut w, &m, "x^2 + y^2 - 1");
    // One stretch, however many pieces it was looked at in.
    assert!(matches!(found.incomplete[..], [Incomplete::Vanishing { start: 0.0, end: 6.0 }]), "{found:?}");
    let found = zeros(&mut w, &m, "sqrt(x) - 0.5");
    assert_times(&found.times, &[0.25_f64.asin(), PI - 0.25_f64.asin()], 1e-13);
    assert!(found.incomplete.iter().all(|i| matches!(i, Incomplete::NoValue { .. })), "{found:?}");
    assert!(!found.incomplete.is_empty());
    // A pole is a change of sign, but no zero.
    let found = zeros(&mut w, &m, "x/y");
    assert_times(&found.times, &[0.0, PI], 1e-14);
    let pole = |i: &Incomplete| matches!(i, Incomplete::NoValue { reason: NoValue::OutOfDomain, .. });
    assert!(found.incomplete.len() == 2 && found.incomplete.iter().all(pole), "{found:?}");
    // So is a jump at the cut of arctan2.
    let found = zeros(&mut w, &m, "atan2(x,0-1)");
    assert!(found.times.iter().all(|t| *t < 0.1), "{found:?}");
    assert!(matches!(found.incomplete[..], [Incomplete::Unresolved { .. }]), "{found:?}");
    let never = zeros(&mut w, &m, "sqrt(0-1-x^2)");
    assert!(never.times.is_empty() && !never.incomplete.is_empty());
}

#[test]
fn zeros_of_a_kink() {
    let mut w = World::default();
    let m = circle(&mut w, (-1.0, 6.0));
    let found = zeros(&mut w, &m, "abs(x) - 0.5");
    let s = PI / 6.0;
    assert_times(&found.times, &[-s, s, PI - s, PI + s, TAU - s], 2e-14);
    // Where the kink itself is a zero, the sides touch.
    let found = zeros(&mut w, &m, "abs(x)");
    assert!(found.times.is_empty(), "{found:?}");
    assert_times(&found.touching, &[0.0, PI], 1e-12);
    let found = zeros(&mut w, &m, "abs(x) + 0.001");
    assert!(found.times.is_empty() && found.touching.is_empty() && found.incomplete.is_empty(), "{found:?}");
}
