//! Systems that are implicit in their rates.

use crate::flow_support::World;
use rederive::flow::FlowError;

/// Values of the rates of a field at given states and parameters, by integrating to a very short time: x₁ is the rate.
fn rates(w: &mut World, states: &[&str], equations: &[&str], initial: &[(&str, &str)]) -> Vec<f64> {
    let field = w.field(states, equations).unwrap();
    let mut m = w.integrate(&field, initial, &[], &[], (0.0, 1e-3), 0.0).unwrap();
    let names: Vec<String> = initial.iter().map(|(n, _)| format!("{n}'")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    w.prepare(&mut m, &names);
    m.at(0.0).iter().map(|x| x.unwrap().value).collect()
}

#[test]
fn coupled_blocks_of_every_size() {
    let mut w = World::default();
    // 2x′ + y′ = 5, x′ − y′ = 1; z′ needs both.
    let found = rates(
        &mut w,
        &["z", "x", "y"],
        &["z' + x' - y' = 4", "2*x' + y' = 5", "x' - y' = 1"],
        &[("z", "0"), ("x", "0"), ("y", "0")],
    );
    assert_eq!(found, [3.0, 2.0, 1.0]);
    // Six coupled rates: by elimination. Row i: Σⱼ aᵢⱼ xⱼ′ with aᵢⱼ = 1/(i + j) + δᵢⱼ, solution xⱼ′ = j.
    let names = ["a", "b", "c", "d", "e", "f"];
    let lines: Vec<String> = (1..=6)
        .map(|i| {
            let left: Vec<String> =
                (1..=6).map(|j| format!("(1/{}{})*{}'", i + j, if i == j { "+1" } else { "" }, names[j - 1])).collect();
            let right: Vec<String> =
                (1..=6).map(|j| format!("{j}*(1/{}{})", i + j, if i == j { "+1" } else { "" })).collect();
            format!("{} = {}", left.join("+"), right.join("+"))
        })
        .collect();
    let lines: Vec<&str> = lines.iter().map(String::as_str).collect();
    let initial: Vec<(&str, &str)> = names.iter().map(|n| (*n, "0")).collect();
    for (j, x) in rates(&mut w, &names, &lines, &initial).iter().enumerate() {
        assert!((x - (j + 1) as f64).abs() < 1e-13, "{j}: {x}");
    }
}

#[test]
fn a_full_inertia_tensor_with_a_zero_on_the_diagonal() {
    let mut w = World::default();
    let found = rates(&mut w, &["x", "y"], &["0*x' + y' = 2", "3*x' + 4*y' = 20"], &[("x", "1"), ("y", "1")]);
    assert_eq!(found, [4.0, 2.0]);
}

#[test]
fn an_explicit_equation_stays_as_it_is() {
    let mut w = World::default();
    let field = w.field(&["x", "y"], &["x' = y*(x+y)", "sin(x)*y = y'"]).unwrap();
    assert_eq!(field.rates(), [w.e("y*(x+y)"), w.e("sin(x)*y")]);
    assert!(field.parameters().is_empty());
}

#[test]
fn systems_of_mixed_order() {
    let mut w = World::default();
    let field = w.field(&["q", "s"], &["m*q'' + s' = 0-q", "s' = q'"]).unwrap();
    let names: Vec<_> = ["q", "q'", "s"].iter().map(|n| w.leaf(n)).collect();
    assert_eq!(field.states(), names);
    assert_eq!(field.parameters(), [w.leaf("m")]);
}

#[test]
fn what_cannot_be_solved_says_which_equation_or_state() {
    let mut w = World::default();
    let mut error = |states: &[&str], lines: &[&str]| w.field(states, lines).unwrap_err();
    assert!(matches!(error(&["x"], &["x'^2 = 1"]), FlowError::Nonlinear { equation: 0, .. }));
    assert!(matches!(error(&["x", "y"], &["x' = 1", "y'*x' = 1"]), FlowError::Nonlinear { equation: 1, .. }));
    assert!(matches!(error(&["x"], &["1/x' = 1"]), FlowError::Nonlinear { .. }));
    assert!(matches!(error(&["x"], &["sin(x') = 1"]), FlowError::Nonlinear { .. }));
    assert!(matches!(error(&["x"], &["x' = 1", "x' = 1"]), FlowError::OverDetermined { equation: 1, .. }));
    assert!(matches!(error(&["x"], &["x' = 1", "x^2 = 1"]), FlowError::Constraint { equation: 1 }));
    assert!(matches!(error(&["x", "y"], &["x' = 1"]), FlowError::NoEquation { state } if state == "y"));
    let twice = error(&["x", "y", "z"], &["x' = 1", "x' + 0 = 2", "y' + z' = 0"]);
    assert!(matches!(&twice, FlowError::Undetermined { .. }), "{twice}");
    assert_eq!(
        error(&["x"], &["x' = 1", "2*x' = 2"]).to_string(),
        "equation 2 is one too many: 2 equations for 1 rates (leave repeated equations out, also consistent ones)"
    );
    assert!(matches!(error(&["x", "y"], &["x'+y' = 1"]), FlowError::Undetermined { .. }));
}

#[test]
fn zero_entries_of_diagonal_matrices_are_skipped() {
    let mut w = World::default();
    assert!(w.field(&["x"], &["0 = 0", "x' = 1"]).is_ok());
}

#[test]
fn a_determinant_that_vanishes_in_numbers_is_found_at_run_time() {
    let mut w = World::default();
    let field = w.field(&["x", "y"], &["x' + y' = 1", "x' + a*y' = 1"]).unwrap();
    let start = [("x", "0"), ("y", "0")];
    let error = w.integrate(&field, &start, &[("a", "1")], &[], (0.0, 1.0), 0.0).unwrap_err();
    assert!(matches!(error, FlowError::Singular { .. }), "{error}");
    assert!(w.integrate(&field, &start, &[("a", "2")], &[], (0.0, 1.0), 0.0).is_ok());
}
