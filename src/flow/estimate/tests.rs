//! That the estimate is no smaller than the error: random systems against twice as many digits.

use super::super::taylor::Flow;
use super::super::trajectory::{Plan, Trajectory};
use super::*;
use crate::flow_support::World;
use number::{DoubleDouble, Draws};

/// Order of the series of the reference.
const LONG: usize = 30;

/// A random system of polynomials, as equations for x₀, x₁, …
fn system(draws: &mut Draws, n: usize) -> Vec<String> {
    let mut number = |most: u64| format!("{}.{:03}", draws.below(most), draws.below(1000));
    let kind = number(6).as_bytes()[0] - b'0';
    let mut equations = Vec::new();
    let mut place = |of: usize| number(of as u64).as_bytes()[0] - b'0';
    let mut places = Vec::new();
    for _ in 0..40 {
        places.push((place(n), place(n), place(n), place(10)));
    }
    let mut at = places.into_iter().cycle();
    let mut coefficient = || {
        let (_, _, sign, _) = at.next().unwrap_or_default();
        let x = number(2);
        if sign % 2 == 0 { format!("+{x}") } else { format!("-{x}") }
    };
    let matrix: Vec<String> = (0..n * n).map(|_| coefficient()).collect();
    let entry = |i: usize, j: usize| matrix[i * n + j].as_str();
    let flip = |c: &str| if let Some(c) = c.strip_prefix('+') { format!("-{c}") } else { c.replace('-', "+") };
    for i in 0..n {
        let mut terms = String::new();
        for j in 0..n {
            let c = if j > i { entry(i, j).to_owned() } else { flip(entry(j, i)) };
            match kind {
                // Rotation, with a rate that depends on the state.
                0 if i != j => terms += &format!("{c}*x{j}*(1+x0^2)"),
                1 if i != j => terms += &format!("{c}*x{j}"),
                // Anything linear.
                2 => terms += &format!("{}*x{j}", entry(i, j)),
                // A chain of oscillators with cubic forces.
                3 if i + 1 == j => terms += &format!("+x{j}-0.1*x{i}*x{j}*x{j}"),
                3 if j + 1 == i => terms += &format!("-x{j}-0.3*x{j}^3/7"),
                // Quadratic without a source: energy is conserved.
                4 if i != j => terms += &format!("{c}*x{j}*x{}", (i + j) % n),
                // Decay and turning.
                5 if i == j => terms += &format!("-0.4*x{i}"),
                5 => terms += &format!("{c}*x{j}*x{j}/3"),
                _ => {}
            }
        }
        equations.push(format!("x{i}' = 0*x{i}{terms}"));
    }
    equations
}

fn compiled(equations: &[String], initial: &[String]) -> Option<(Flow, Plan)> {
    let mut w = World::default();
    let names: Vec<String> = (0..equations.len()).map(|i| format!("x{i}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let equations: Vec<&str> = equations.iter().map(String::as_str).collect();
    let field = w.field(&names, &equations).ok()?;
    let initial: Vec<(&str, &str)> = names.iter().copied().zip(initial.iter().map(String::as_str)).collect();
    let motion = w.integrate(&field, &initial, &[], &[], (0.0, 0.01), 0.0).ok()?;
    let orbit = motion.core.orbit.as_ref()?;
    let state = (0..names.len()).map(|i| orbit.trajectory.bounded(orbit.trajectory.place(0.0), i)).collect();
    let plan = Plan { constants: orbit.constants.clone(), initial_time: 0.0, state, span: (0.0, 20.0), max_steps: 400 };
    Some((orbit.field.flow.clone(), plan))
}

/// The true states at the ends of the steps of a trajectory, for start and constants somewhere in their bounds.
fn truth(flow: &Flow, plan: &Plan, times: &[f64], draws: &mut Draws) -> Vec<Vec<DoubleDouble>> {
    let mut somewhere = |x: &Bounded| {
        let part = draws.below(2001) as f64 / 1000.0 - 1.0;
        DoubleDouble::new(x.value, part * x.error)
    };
    let constants: Vec<DoubleDouble> = plan.constants.iter().map(&mut somewhere).collect();
    let mut state: Vec<DoubleDouble> = plan.state.iter().map(&mut somewhere).collect();
    let mut slots = flow.slots(LONG, &constants);
    let mut series = vec![DoubleDouble::new(0.0, 0.0); state.len() * (LONG + 1)];
    let mut out = vec![state.clone()];
    for pair in times.windows(2) {
        // In halves.
        for part in 0..2 {
            let half = (pair[1] - pair[0]) / 2.0;
            let h = if part == 0 {
                DoubleDouble::new(half, 0.0)
            } else {
                DoubleDouble::new(pair[1], -pair[0]) - DoubleDouble::new(half, 0.0)
            };
            if flow.expand(&mut slots, LONG, DoubleDouble::new(0.0, 0.0), &state, &mut series).is_err() {
                return out;
            }
            for (x, c) in state.iter_mut().zip(series.chunks(LONG + 1)) {
                *x = c.iter().rev().fold(DoubleDouble::new(0.0, 0.0), |sum, &c| sum * h + c);
            }
        }
        out.push(state.clone());
    }
    out
}

/// Bound over error, at all step ends where there is an error; how many of these there are.
fn ratios(systems: u64, seed: u64) -> (Vec<f64>, usize) {
    let mut draws = Draws::new(seed);
    let (mut least, mut compared) = (Vec::new(), 0);
    for _ in 0..systems {
        let n = 2 + draws.below(4) as usize;
        let equations = system(&mut draws, n);
        let exact = draws.below(2) == 0;
        let mut start = |_| match exact {
            true => format!("{}", draws.below(5) as f64 * 0.25 - 0.5).replace('-', "0-"),
            false => format!("0.{:03}", draws.below(1000)),
        };
        let initial: Vec<String> = (0..n).map(&mut start).collect();
        let Some((flow, plan)) = compiled(&equations, &initial) else { continue };
        let Some(found) = Trajectory::integrate(&flow, std::slice::from_ref(&plan), Estimation::Steps, &|| false)
        else {
            continue;
        };
        let Some(Ok(trajectory)) = found.into_iter().next() else { continue };
        let times = trajectory.boundaries();
        let truth = truth(&flow, &plan, &times, &mut draws);
        let mut worst = vec![f64::INFINITY];
        for (step, (&time, truth)) in times.iter().zip(&truth).enumerate().skip(1) {
            let place = trajectory.place_before(time, step - 1);
            for (i, truth) in truth.iter().enumerate() {
                let found = trajectory.bounded(place, i);
                let off = (*truth - DoubleDouble::new(found.value, 0.0)).high().abs();
                assert!(
                    off <= found.error,
                    "{equations:?} from {initial:?}: x{i} at {time}: {off:e} > {:e}",
                    found.error
                );
                if off > 0.0 {
                    worst.push(found.error / off);
                    compared += 1;
                }
            }
        }
        least.push(worst.into_iter().fold(f64::INFINITY, f64::min));
    }
    least.sort_by(f64::total_cmp);
    (least, compared)
}

#[test]
fn no_error_is_larger_than_the_estimate() {
    let (least, compared) = ratios(300, 1);
    let at = |share: f64| least[((least.len() - 1) as f64 * share) as usize];
    println!(
        "{} systems, {compared}: least {:.1} 10% {:.1} median {:.1} 90% {:.1}",
        least.len(),
        at(0.0),
        at(0.1),
        at(0.5),
        at(0.9)
    );
    assert!(least.len() > 250 && compared > 50_000, "{} {compared}", least.len());
}

#[test]
fn a_difference_without_a_value_is_not_lost_among_others() {
    assert_eq!(size(&Lanes([1.0, -4.0, 2.0, 3.0])), 4.0);
    for lane in 0..LANES {
        for missing in [f64::NAN, f64::INFINITY] {
            let mut lanes = Lanes([1.0, -4.0, 2.0, 3.0]);
            lanes.0[lane] = missing;
            assert!(!size(&lanes).is_finite(), "{lanes:?}");
        }
    }
}
