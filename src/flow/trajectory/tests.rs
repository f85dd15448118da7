//! That what is integrated side by side is what it is alone.

use super::*;
use crate::flow_support::World;

/// Fields of all kinds: polynomials, functions, roots, kinks, jumps, edges, what moves by the time, what blows up, what rests.
const FIELDS: &[(&[&str], &[&str])] = &[
    (&["x", "y", "z"], &["x' = 10*(y-x)", "y' = x*(28-z)-y", "z' = x*y-8/3*z"]),
    (&["x", "y"], &["x'' = -x/sqrt(x^2+y^2)^3", "y'' = -y/sqrt(x^2+y^2)^3"]),
    (&["x"], &["x'' = -sin(x)"]),
    (&["x", "y"], &["x' = exp(-x^2)*cos(y)", "y' = tanh(x)+ln(2+x^2)"]),
    (&["x"], &["x'' = -abs(x)*x-abs(x)"]),
    (&["x"], &["x'' = -x+cos(3*t)"]),
    (&["x"], &["x' = x^2"]),
    (&["x", "y"], &["x' = sqrt(abs(y))", "y' = -x"]),
    (&["x", "y"], &["x' = atan2(x,y)", "y' = 1/(1+x^3)"]),
    (&["x", "y"], &["x' = 0*y", "y' = x*y-y/(2+x)"]),
];

/// Motions of a field, from starts of many kinds; with the field, compiled.
fn plans(states: &[&str], equations: &[&str]) -> (Flow, Vec<Plan>) {
    let mut w = World::default();
    let field = w.field(states, equations).unwrap();
    let names: Vec<String> = equations.iter().map(|e| e.split('\'').next().unwrap().to_owned()).collect();
    let rates = names.iter().zip(equations).filter(|(_, e)| e.contains("\'\'")).map(|(n, _)| format!("{n}'"));
    let all: Vec<String> = names.iter().cloned().chain(rates).collect();
    let initial: Vec<(&str, &str)> = all.iter().map(|n| (n.as_str(), "0.5")).collect();
    let motion = w.integrate(&field, &initial, &[], &[], (0.0, 0.125), 0.0).unwrap();
    let orbit = motion.core.orbit.as_ref().unwrap();
    let mut draws = number::Draws::new(5);
    let plan = |i: usize| {
        let mut number = || {
            let x = draws.below(4001) as f64 / 1000.0 - 2.0;
            let value = if draws.below(8) == 0 { 0.0 } else { x };
            Bounded::new(value, if i.is_multiple_of(3) { 1e-15 } else { 0.0 })
        };
        let span = [(0.0, 3.0), (-1.0, 2.0), (0.0, 8.0), (-2.5, 0.0)][i % 4];
        Plan {
            constants: orbit.constants.clone(),
            initial_time: 0.0,
            state: (0..orbit.field.states.len()).map(|_| number()).collect(),
            span,
            max_steps: if i % 7 == 6 { 5 } else { 300 },
        }
    };
    (orbit.field.flow.clone(), (0..23).map(plan).collect())
}

#[test]
fn a_motion_is_the_same_alone_and_beside_others() {
    let (mut stopped, mut whole) = (0, 0);
    for (states, equations) in FIELDS {
        let (flow, plans) = plans(states, equations);
        let told = |found: Option<Vec<Result<Trajectory, (usize, NoValue)>>>| -> Vec<String> {
            found.unwrap().into_iter().map(|t| format!("{t:?}")).collect()
        };
        fn one_by_one<'a>(flow: &'a Flow, runs: &mut [Run<'a>]) -> bool {
            runs.iter_mut().all(|run| abreast::run(flow, std::slice::from_mut(run), &|| false))
        }
        for estimation in [Estimation::Steps, Estimation::Companions] {
            let alone = told(Trajectory::by(one_by_one, &flow, &plans, estimation));
            let some = |some: &[Plan]| told(Trajectory::integrate(&flow, some, estimation, &|| false));
            assert_eq!(alone, some(&plans), "{equations:?}");
            let each = plans.iter().flat_map(|plan| some(std::slice::from_ref(plan)));
            assert_eq!(alone, each.collect::<Vec<_>>(), "{equations:?}");
            let fives = plans.chunks(5).flat_map(some);
            assert_eq!(alone, fives.collect::<Vec<_>>(), "{equations:?}");
        }
        let alone = told(Trajectory::by(one_by_one, &flow, &plans, Estimation::Companions));
        stopped += alone.iter().filter(|t| t.contains("problem: Some") || t.starts_with("Err")).count();
        whole += alone.iter().filter(|t| !t.contains("problem: Some") && !t.starts_with("Err")).count();
    }
    assert!(stopped > 40 && whole > 100, "{stopped} {whole}");
}

/// The estimate from the steps changes nothing but errors, and is there for polynomials alone.
#[test]
fn values_are_those_of_either_estimate() {
    let mut by_steps = 0;
    for (states, equations) in FIELDS {
        let (flow, plans) = plans(states, equations);
        let found = |estimation| Trajectory::integrate(&flow, &plans, estimation, &|| false).unwrap();
        let both = found(Estimation::Steps).into_iter().zip(found(Estimation::Companions));
        for (steps, companions) in both.filter_map(|(a, b)| Some((a.ok()?, b.ok()?))) {
            assert!(!companions.is_by_steps());
            by_steps += usize::from(steps.is_by_steps());
            let branches = |t: &Trajectory| [t.forward.clone(), t.backward.clone()];
            for (a, b) in branches(&steps).into_iter().zip(branches(&companions)) {
                // A companion that ends before the motion cuts it.
                let known = b.times.len();
                assert_eq!(a.times[..known], b.times, "{equations:?}");
                assert_eq!(a.coefficients[..b.coefficients.len()], b.coefficients, "{equations:?}");
                assert!(a.error.iter().all(|e| *e >= 0.0));
            }
        }
    }
    assert!(by_steps > 20, "{by_steps}");
}

/// What is saved does not come from a clock: how often series are grown is counted, by how often it is asked whether to stop.
#[test]
fn lanes_are_filled() {
    use std::sync::atomic::{AtomicUsize, Ordering};
    let (flow, plans) = plans(&["x"], &["x'' = -sin(x)"]);
    let counted = |plans: &[Plan]| {
        let asked = AtomicUsize::new(0);
        let halt = || {
            asked.fetch_add(1, Ordering::Relaxed);
            false
        };
        let found = Trajectory::integrate(&flow, plans, Estimation::Companions, &halt).unwrap();
        let steps = |t: &Trajectory| t.forward.times.len() + t.backward.times.len() - 2;
        (asked.into_inner(), found.iter().map(|t| steps(t.as_ref().unwrap())).sum::<usize>())
    };
    let plans: Vec<Plan> =
        (0..40).map(|i| Plan { span: (0.0, 40.0), max_steps: 10_000, ..plans[3 * (i % 7)].clone() }).collect();
    let (asked, steps) = counted(&plans);
    // Four integrations of each, a little longer than what is kept, in eight lanes.
    assert!(64 * asked < steps, "{asked} looks in {steps} steps");
}

#[test]
fn what_is_to_stop_stops() {
    let (flow, plans) = plans(&["x"], &["x'' = -sin(x)"]);
    let long: Vec<Plan> =
        plans.iter().map(|plan| Plan { span: (0.0, 1e9), max_steps: usize::MAX, ..plan.clone() }).collect();
    assert!(Trajectory::integrate(&flow, &long, Estimation::Companions, &|| true).is_none());
    // The last one that is left has a path of its own.
    let mut last = [Whole::new(&flow, &long[1], 1e9)];
    assert!(!abreast::run(&flow, &mut last, &|| true));
}
