//! Identities that must be proved, and the error bound that comes with them.

use crate::infix::Reader;
use rederive::check::identity::{Condition, Identity, Options, branches_test, identity_test};

/// Tests `claim` under `premises`; `moving` names what depends on t.
pub fn test(claim: &str, premises: &str, moving: &str) -> Identity {
    let mut r = Reader::default();
    let equations = r.equations(claim);
    let given = r.premises(premises, moving);
    identity_test(&mut r.graph, &equations, &given, &Options::default())
}

#[track_caller]
fn proved(claim: &str, premises: &str) {
    match test(claim, premises, "") {
        Identity::Proved(p) => {
            assert!(p.log2_error <= -100.0, "{claim}: {}", p.log2_error);
            assert!(p.example.is_some(), "no real point for {claim}");
        }
        other => panic!("`{claim}` given `{premises}`: {other:#?}"),
    }
}

#[test]
fn trigonometry() {
    proved("sin(x)^2 + cos(x)^2 = 1", "");
    proved("sin(x+y) = sin(x)*cos(y) + cos(x)*sin(y)", "");
    proved("sin(2*x) = 2*sin(x)*cos(x); cos(3*x) = 4*cos(x)^3 - 3*cos(x)", "");
    proved("cos(x) = 1 - 2*sin(x/2)^2", "");
    proved("tan(x/2) = sin(x)/(1+cos(x))", "");
    proved("sin(x + pi) = -sin(x); cos(pi/2 - x) = sin(x); sin(pi/6) = 1/2; cos(pi/12) = (sqrt(6)+sqrt(2))/4", "");
    proved("cosh(x)^2 - sinh(x)^2 = 1; exp(x+y) = exp(x)*exp(y); tanh(x/2) = (exp(x)-1)/(exp(x)+1)", "");
    proved("sin(w*t + t*w) = 2*sin(t*w)*cos(w*t)", "");
    proved("cos(arccos(x)) = x; sin(arccos(x)) = sqrt(1-x^2); cos(arctan(x)) = 1/sqrt(1+x^2)", "");
    proved("sin(atan2(y,x)) = y/sqrt(x^2+y^2); cos(2*arcsin(x)) = 1-2*x^2", "");
    proved("tan(arctan(x)/2) = x/(1+sqrt(1+x^2))", "");
    proved("exp(2*ln(x)) = x^2; exp(ln(x)/2) = sqrt(x); ln(exp(x)) = x", "");
}

#[test]
fn roots() {
    proved("sqrt(x)^2 = x", "");
    proved("sqrt(x^2) = abs(x)", "");
    proved("sqrt(x^2) = x", "x > 0");
    proved("sqrt(a*b) = sqrt(a)*sqrt(b)", "");
    proved("sqrt(8) = 2*sqrt(2); sqrt(6) = sqrt(2)*sqrt(3); sqrt(1/2) = sqrt(2)/2", "");
    proved("abs(a*b) = abs(a)*abs(b); abs(x)^2 = x^2", "");
    proved("sqrt(x^2 + 2*x*y + y^2) = abs(x+y)", "");
    proved("sqrt(1 - cos(x)^2) = abs(sin(x))", "");
    proved("sqrt(1 + sqrt(x)) * sqrt(1 + sqrt(x)) = 1 + sqrt(x)", "");
    proved("1/(sqrt(x+1) - sqrt(x)) = sqrt(x+1) + sqrt(x)", "");
    proved("(sqrt(x) + 1)*(sqrt(x) - 1) = x - 1", "");
}

#[test]
fn premises() {
    proved("x = 2", "x^3 = 8*y; y = 1; x^2 = 4*y");
    proved("2*x = a + b; 2*y = a - b", "x + y = a; x - y = b");
    proved("x^2 = y^2", "x + y = 0");
    proved("x = -1", "x^2 = 1; x - 1 != 0");
    proved("y = 3", "x*y = 3*x; x != 0");
    proved("c*c + s*s = 1", "c = cos(u); s = sin(u)");
    proved("cos(2*u) = 0", "sin(u)^2 = 1/2");
}

#[track_caller]
fn refuted(claim: &str, premises: &str) {
    match test(claim, premises, "") {
        Identity::Refuted(r) => {
            let sides = (&r.left.exact, &r.right.exact);
            if let (Some(l), Some(r)) = sides {
                assert_ne!(l, r);
            } else {
                assert!((r.left.decimal - r.right.decimal).abs() > 1e-7, "{claim}: {r:?}");
            }
        }
        other => panic!("`{claim}` given `{premises}`: {other:#?}"),
    }
}

#[track_caller]
fn undecided(claim: &str, premises: &str) -> rederive::check::identity::Reason {
    match test(claim, premises, "") {
        Identity::Undecided(reason) => reason,
        other => panic!("`{claim}` given `{premises}`: {other:#?}"),
    }
}

#[test]
fn false_in_general() {
    refuted("sqrt(x^2) = x", "");
    refuted("sqrt(x^2) = -x", "");
    refuted("abs(x) = x", "");
    refuted("sqrt(a^2 + b^2) = a + b", "");
    refuted("arccos(cos(x)) = x", "");
    refuted("arctan(tan(x)) = x", "");
    refuted("atan2(sin(x), cos(x)) = x", "");
    refuted("sin(x + pi) = sin(x)", "");
    refuted("exp(ln(x^2)/2) = x", "");
    refuted("sin(x)^2 + cos(x)^2 = 2", "");
    refuted("x = 2", "x^2 = 4");
    refuted("x = 1", "x*y = y");
    refuted("x = 5", "");
    refuted("y = 1", "x^2 + y^2 = 1");
    // Coefficients equal modulo 2^61 − 1.
    refuted("2305843009213693952*x = x", "");
    refuted("x^2 + 2305843009213693951*x*y = x^2", "");
}

#[test]
fn without_a_value_or_a_decision() {
    use rederive::check::identity::Reason;
    assert_eq!(undecided("x/(y - y) = 1", ""), Reason::NoValue);
    assert_eq!(undecided("(x - x)/(y - y) = 0", ""), Reason::NoValue);
    assert_eq!(undecided("x/(a - b) = x/(a - b)", "a = b"), Reason::NoValue);
    assert_eq!(undecided("0/(sin(x)^2 + cos(x)^2 - 1) = 0", ""), Reason::NoValue);
    assert_eq!(undecided("y = 1", "x = 1; x = 2"), Reason::Contradiction);
    assert_eq!(undecided("y = 1", "x^2 = 1; x - 1 != 0; x + 1 != 0"), Reason::Contradiction);
    // True, but outside the class.
    assert!(matches!(undecided("x = y", "x^5 + x = y^5 + y"), Reason::Unsolved(_) | Reason::Branches { .. }));
}

#[test]
fn what_is_asked_again() {
    proved("x = 1", "x^5 + x = 2");
    proved("arctan(x) + arctan(1/x) = pi/2", "x > 0");
    refuted("arctan(x) + arctan(1/x) = pi/2", "");
    proved("arcsin(x) + arccos(x) = pi/2", "");
    refuted("arcsin(x) + arccos(x) = pi", "");
}

#[test]
fn each_equation_where_it_has_a_value() {
    refuted("sqrt(x^2) = x; sqrt(x)^2 = x", "");
    proved("sqrt(x^2) = x; sqrt(x)^2 = x", "x > 0");
    refuted("x = 1; 1/x = 1", "x^2 = x");
    proved("x/x = 1; y/y = 1", "");
}

#[test]
fn nearly_true() {
    let sum = |n: u32| (0..n).map(|k| format!("x^{k}")).collect::<Vec<_>>().join(" + ");
    proved(&format!("(x - 1)*({}) = x^60 - 1", sum(60)), "");
    refuted(&format!("(x - 1)*({}) = x^60 - 1", sum(59)), "");
    refuted(&format!("(x - 1)*({}) + x^31 = x^60 - 1", sum(60)), "");
}

#[test]
fn the_comment() {
    for step in crate::comment::steps() {
        let start = std::time::Instant::now();
        let outcome = test(&step.claim, &step.premises, &step.moving);
        let took = start.elapsed();
        let Identity::Proved(p) = outcome else { panic!("{}: {outcome:#?}", step.id) };
        println!(
            "{:32} 2^{:.0}, degree {:.0}, height {:.0}, trials {}, signs {}, cases {}, conditions {}, {took:?}",
            step.id,
            p.log2_error,
            p.degree_bound,
            p.height_bound,
            p.trials,
            p.signs,
            p.cases,
            p.conditions.len()
        );
        assert!(p.log2_error <= -100.0 && p.example.is_some(), "{}", step.id);
    }
}

#[test]
fn what_the_comment_leaves_open() {
    // 2E = m²/I does not imply that R is the unit matrix.
    let premises = format!(
        "{}; E = (I1*w1^2 + I2*w2^2 + I3*w3^2)/2; w1 = m3*R31/I1; w2 = m3*R32/I2; w3 = m3*R33/I3; \
         2*E = m3^2/I3; I1 > 0; I2 > 0; I3 > 0",
        crate::comment::orthogonal("R")
    );
    refuted("R33 = 1", &premises);
    // ψ₀ is real for some orders of the moments only: that is among the conditions.
    let given = format!("{}; I1 - I2 != 0; I1 > 0; I2 > 0; I3 > 0", crate::comment::PSI0);
    let Identity::Proved(p) = test("sin(ps)^2 = I1*(I2 - I3)/(I3*(I2 - I1))", &given, "") else { panic!() };
    let radicands = p.conditions.iter().filter(|c| matches!(c, Condition::Discriminant(_))).count();
    assert_eq!(radicands, 2, "cos² ≥ 0 and 1 − cos² ≥ 0: {:?}", p.conditions);
}

#[test]
fn plus_or_minus() {
    let mut r = Reader::default();
    let root = "sqrt(((1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2)\
                *(1/I3 - 2*E/m3^2 + (1/I1 - 1/I3) - (1/I1 - 1/I2)*cos(ps)^2))/(1/I1 - (1/I1 - 1/I2)*cos(ps)^2)";
    let branches = vec![r.equations(&format!("ps'/ph' = {root}")), r.equations(&format!("ps'/ph' = -{root}"))];
    let given = format!(
        "{}; {}; {}; m3 != 0; I1 > 0; I2 > 0; I3 > 0",
        crate::comment::T9B,
        crate::comment::T9C,
        crate::comment::T10
    );
    let given = r.premises(&given, "");
    let verdict = branches_test(&mut r.graph, &branches, &given, &Options::default());
    assert!(matches!(verdict.pointwise, Identity::Proved(_)), "{verdict:#?}");
    assert!(verdict.throughout.iter().all(|i| matches!(i, Identity::Refuted(_))), "{verdict:#?}");
}
