//! Initial values that equations determine: the one solution, or a refusal.

use rederive::check::{CheckError, Options, Rigor, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};

const HEAD: &str = r"
[derivation]
title = 'T'
concerns = 'C'

[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'y' = { role = 'state' }
'a' = { role = 'parameter' }

[system.s]
states = ['x', 'y']
equations = ['\dot x=y', '\dot y=-x']
";

/// Everything that a verdict may rest on, and nothing else.
fn options() -> Options {
    Options { plain: true, rigor: Rigor::Enclosed, ..Options::default() }
}

fn load(motion: &str, more: &str) -> Result<Derivation, String> {
    let motion =
        format!("[[trajectory]]\nid = 'm'\nsystem = 's'\nparameters = {{ 'a' = 2 }}\nspan = [0, 1]\n{motion}\n");
    let claim = "[[claim]]\nid = 'c'\nsays = 's'\nalways = ['x^2+y^2=x(0)^2+y(0)^2']\n";
    let source = Source { path: "test.toml".into(), text: [HEAD, &motion, claim, more].concat() };
    parse(source, "test").map_err(|found| render(&found, false))
}

/// The problems of a file with this motion; nothing where there is none.
fn problems(motion: &str) -> String {
    let derivation = match load(motion, "") {
        Ok(derivation) => derivation,
        Err(found) => return found,
    };
    match check(&derivation, &options(), &|_, _| {}) {
        Ok(_) => String::new(),
        Err(CheckError::Problems(found)) => render(&found, false),
        Err(other) => panic!("{other:?}"),
    }
}

/// The verdict on a claim, with its strength.
fn verdict(motion: &str, claim: &str) -> String {
    let more = format!("[[claim]]\nid = 'd'\nsays = 's'\n{claim}\n");
    let derivation = load(motion, &more).unwrap_or_else(|found| panic!("{found}"));
    let account = check(&derivation, &options(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let claim = account.claims.iter().find(|c| c.id == "d").expect("the claim is there");
    let outcome = claim.results[0].verdict.outcome();
    format!("{} {}", outcome.word(), outcome.strength().unwrap_or("")).trim().to_owned()
}

fn constrained(x: &str, y: &str, constraints: &str) -> String {
    format!("initial = {{ 'x' = {x}, 'y' = {y} }}\nconstraints = [{constraints}]")
}

#[track_caller]
fn refused(motion: &str, code: &str, words: &str) {
    let found = problems(motion);
    assert!(found.contains(&format!("[{code}]")) && found.contains(words), "{motion}\n{found}");
    assert!(found.contains("hint:"), "{found}");
}

#[test]
fn there_is_no_solution_near() {
    refused(&constrained("{ near = 1 }", "0", "'x^2=-1'"), "flow::initial", "no initial values satisfy");
    refused(&constrained("{ near = 5 }", "0", "'x^2=4'"), "flow::initial", "2.5 ≤ x ≤ 7.5");
    // Where there is no value, there is no solution.
    refused(&constrained("{ near = -3 }", "0", "'\\sqrt x=1'"), "flow::initial", "no initial values satisfy");
}

#[test]
fn there_are_two_solutions_near() {
    refused(&constrained("{ near = 1, within = 4 }", "0", "'x^2=4'"), "flow::initial", "x = -2.0, and x = 2.0");
    refused(
        &constrained("{ near = 1 }", "{ near = 1 }", "'x+y=2', 'xy=0.99'"),
        "flow::initial",
        "two choices of initial values",
    );
}

/// Bounds of guesses are what their decimals say, also where these are no numbers of the machine.
#[test]
fn a_border_is_exact() {
    let two = "'(x-\\frac25)(x-\\frac7{10})=0'";
    refused(&constrained("{ near = 0.6, within = 0.2 }", "0", two), "flow::initial", "x = 0.7, and x = 0.4");
    let one = "'(x-\\frac15)(x-3)=0'";
    refused(&constrained("{ near = 0.3, within = 0.1 }", "0", one), "flow::initial", "at the edge of");
    let beyond = "'(x-\\frac{3}{10}-10^{-18})(x-3)=0'";
    refused(&constrained("{ near = 0.1, within = 0.2 }", "0", beyond), "flow::initial", "x ≤ 0.3");
    assert_eq!(problems(&constrained("{ near = 0.6, within = 0.25 }", "0", "'x=\\frac25'")), "");
}

/// Times may be written as formulas of numbers.
#[test]
fn a_span_is_a_formula_of_numbers() {
    let of = |span: &str| {
        let motion = format!(
            "[[trajectory]]\nid = 'm'\nsystem = 's'\nparameters = {{ 'a' = 2 }}\nspan = {span}\ninitial = {{ 'x' = 0, 'y' = 1 }}\n"
        );
        let claim = "[[claim]]\nid = 'c'\nsays = 's'\nalways = ['x=\\sin t']\n";
        let source = Source { path: "test.toml".into(), text: [HEAD, &motion, claim].concat() };
        parse(source, "test").map(|d| d.trajectories[0].span).map_err(|found| render(&found, false))
    };
    assert_eq!(of(r"[0, '2\pi']"), Ok((0.0, 2.0 * std::f64::consts::PI)));
    assert_eq!(of(r"['-\frac13', '1+10^{-15}']"), Ok((-1.0 / 3.0, 1.0 + 1e-15)));
    for (span, words) in [
        ("[0, 'a']", "a formula of numbers"),
        (r"[0, '\frac10']", "a formula of numbers"),
        ("['1', '0']", "before the last"),
    ] {
        assert!(of(span).is_err_and(|found| found.contains(words)), "{span}");
    }
}

#[test]
fn a_solution_is_not_simple() {
    refused(&constrained("{ near = 1 }", "0", "'(x-1)^2=0'"), "flow::initial", "Jacobian");
    // Two equations that say the same.
    refused(&constrained("{ near = 1 }", "{ near = 1 }", "'x+y=2', '2x+2y=4'"), "flow::initial", "Jacobian");
    // At the edge of a domain.
    refused(&constrained("{ near = 0, within = 1 }", "0", "'\\sqrt x=0'"), "flow::initial", "edge of its domain");
}

#[test]
fn a_solution_lies_at_the_edge() {
    refused(&constrained("{ near = 1, within = '\\sqrt2-1' }", "0", "'x^2=2'"), "flow::initial", "lie at the edge of");
}

#[test]
fn a_guess_without_a_place() {
    refused(&constrained("{ near = 'a-2' }", "0", "'x=1'"), "flow::initial", "its guess is 0");
    refused(&constrained("{ near = 1, within = 'a-3' }", "0", "'x=1'"), "flow::initial", "`within` is not positive");
}

#[test]
fn values_that_need_themselves() {
    refused("initial = { 'x' = '\\dot y', 'y' = '\\dot x' }", "flow::initial", "needs that value itself");
}

#[test]
fn the_one_solution_is_enclosed_to_thirty_digits() {
    // √2 = 1.4142135623730950488016887242096980785696718…
    let motion = constrained("{ near = 1.4 }", "{ near = 0.5, within = 0.4 }", "'x^2=a', 'y=\\frac{1}{x}'");
    let bounds = "always = ['1.41421356237309<x(0)<1.41421356237310', 'y(0)=\\frac{1}{\\sqrt2}']";
    assert_eq!(verdict(&motion, bounds), "holds enclosed");
    assert_eq!(verdict(&motion, "always = ['x(0)^2=a']"), "holds enclosed");
    assert_eq!(verdict(&motion, "always = ['x(0)=1.414213562373']\nprecision = 1e-15"), "fails certified");
    assert_eq!(verdict(&motion, "first-integral = ['x^2+y^2']"), "holds proved");
}

#[test]
fn nothing_is_proved_of_a_value_that_is_only_enclosed() {
    // That x(0) is rational is no matter of intervals: neither is refuted by a number that is close to it.
    let motion = constrained("{ near = 1 }", "0", "'\\cos x=x'");
    assert_eq!(verdict(&motion, "always = ['\\cos x(0)=x(0)']"), "holds enclosed");
    let found = verdict(&motion, "never = ['\\cos x(0)=x(0)']");
    assert!(!found.contains("proved") && !found.starts_with("holds"), "{found}");
    let found = verdict(&motion, "always = ['\\cos x(0)\\ne x(0)']");
    assert!(!found.starts_with("holds"), "{found}");
}

#[test]
fn solutions_do_not_depend_on_the_guess() {
    for guess in ["{ near = 2.4 }", "{ near = 1.9, within = 0.8 }", "{ near = 2, within = '\\frac{1}{1000}' }"] {
        let motion = constrained(guess, "0", "'x^3-x=6'");
        assert_eq!(verdict(&motion, "always = ['x(0)=2']"), "holds enclosed", "{guess}");
    }
}

#[test]
fn equations_and_guesses_are_read_strictly() {
    let of = |motion: &str| problems(motion);
    let cases: [(&str, &str, &str); 12] = [
        ("initial = { 'x' = { near = 1 }, 'y' = 0 }", "derivation::constraints", "0 equations for 1 initial values"),
        ("initial = { 'x' = 1, 'y' = 0 }\nconstraints = ['x=1']", "derivation::constraints", "1 equations for 0"),
        (&constrained("{ near = 1 }", "0", "'x=1', 'x=y'"), "derivation::constraints", "2 equations for 1"),
        (
            &constrained("{ near = 1 }", "{ near = 1 }", "'x=1', '2x=2'"),
            "derivation::constraints",
            "no constraint contains `y`",
        ),
        (&constrained("{ near = 1 }", "0", "'x=b'"), "latex::unknown-symbol", "`b` is not declared"),
        (&constrained("{ near = 1 }", "0", "'x=x(0)'"), "derivation::no-value", "write x, not x(0)"),
        (&constrained("{ near = 1 }", "0", "'x>0'"), "derivation::not-an-equation", "plain equations"),
        (&constrained("{ near = 'y' }", "0", "'x=1'"), "derivation::no-value", "the trajectory's parameters"),
        (&constrained("{ near = 0 }", "0", "'x=1'"), "derivation::bad-range", "how near to 0"),
        (&constrained("{ within = 1 }", "0", "'x=1'"), "derivation::missing-key", "needs `near`"),
        (&constrained("{ near = 1, far = 2 }", "0", "'x=1'"), "derivation::unknown-key", "`far`"),
        ("formula = { 'x' = { near = 1 }, 'y' = 0 }\n", "derivation::missing-key", "exactly one of"),
    ];
    for (motion, code, words) in cases {
        let found = of(motion);
        assert!(found.contains(&format!("[{code}]")) && found.contains(words), "{motion}\n{found}");
    }
    let twice = "initial = { 'x' = { near = 1 }, ' x' = 1, 'y' = 0 }\nconstraints = ['x=1']";
    assert!(of(twice).contains("[derivation::duplicate-id]"), "{}", of(twice));
    let parameter = "initial = { 'x' = 1, 'y' = 0 }\n[[trajectory]]\nid = 'n'\nsystem = 's'\nspan = [0, 1]\n\
                     initial = { 'x' = 1, 'y' = 0 }\nparameters = { 'a' = { near = 1 } }";
    assert!(of(parameter).contains("stands among initial values only"), "{}", of(parameter));
}

#[test]
fn members_of_a_family_are_solved_one_by_one() {
    let motion = constrained("{ near = 1.5, within = 1.4 }", "0", "'x^2=a'");
    let family = "[[family]]\nid = 'f'\nof = 'm'\nvary = { 'a' = { from = 1, to = 4, count = 4 } }\n\
                  [[claim]]\nid = 'd'\nsays = 's'\nalways = ['x(0)=\\sqrt a']\nfamilies = ['f']\n";
    let derivation = load(&motion, family).unwrap_or_else(|found| panic!("{found}"));
    let account = check(&derivation, &options(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let claim = account.claims.iter().find(|c| c.id == "d").expect("the claim is there");
    assert!(claim.verdicts().all(|v| v.verdict.outcome().word() == "holds"));
    assert_eq!(claim.verdicts().count(), 2);
}
