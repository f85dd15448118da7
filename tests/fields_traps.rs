//! Traps about fields that a careless program falls into: places, singular points, boundary terms, solutions that are only formal.
//!
//! Rows are those of [`prove_traps`](crate::prove_traps). Each is refused or undecided, or the opposite is found; none is wrong.

use rederive::check::{Options, check};
use rederive::derivation::parse;
use rederive::diag::{Source, render};

use crate::prove_traps::all;

#[test]
fn what_is_given_at_places_says_nothing_of_other_places() {
    all(&[
        ("unproved", "u_x(0,t)=0", "u(x,t): field", "u_{tt}=u_{xx}; u(0,t)=0"),
        ("proved", "u_{xx}(0,t)=0", "u(x,t): field", "u_{tt}=u_{xx}; u(0,t)=0"),
        ("unproved", "u=0", "u(x,t): field", "u_{tt}=u_{xx}; u(0,t)=0"),
        ("unproved", "u_t(x,0)=0", "u(x,t): field", "u_{tt}=u_{xx}; u(x,0)=0"),
        // It is 0, for another reason than a program without uniqueness theorems knows.
        ("unrefuted", "u=0", "u(x,t): field", "u_t=-u_x; u(x,0)=0"),
        ("unrefuted", "w=0", "w(x,y): field", r"\nabla^2w=0; w(0,y)=0; w_x(0,y)=0"),
        (
            "unrefuted",
            "w=0",
            "w(x,y): field",
            r"\nabla^2w=0; w(0,y)=0; w(1,y)=0; w(x,0)=0; w(x,1)=0; x>0; x<1; y>0; y<1",
        ),
        ("unproved", "w=0", "w(x,y): field", r"\nabla^2w=0; w(0,y)=0"),
        ("unproved", "u(0,t)=u(1,t)", "u(x,t): field", "u_{tt}=u_{xx}; u_x(0,t)=u_x(1,t)"),
        ("unproved", "f(x)=f(y)", "f(x): field; y: coordinate", "x>0"),
        ("unrefuted", "f(x)=f(y)", "f(x): field; y: coordinate", "x=y"),
        ("unproved", "f'(0)=0", "f(x): field", "f(0)=0"),
        ("proved", "f'(0)=0", "f(x): field", "f(x)=3"),
        ("unproved", "u_x(0,0)=0", "u(x,t): field", "u(0,0)=0"),
        ("unproved", "u_t(0,t)=0", "u(x,t): field", "u(0,0)=0"),
        // An equation of coordinates says where the others are known: there alone, and not along it.
        ("unproved", "u_x=0", "u(x,t): field", "u_{tt}=u_{xx}; u=0; x=0"),
        ("unproved", "u_t=0", "u(x,t): field", "u_{tt}=u_{xx}; u=0; x=t"),
        ("unproved", r"\nabla^2w=0", "w(x,y): field", "w=0; x^2+y^2=1"),
        ("unproved", "u_x=2x", "u(x,t): field", "u=x^2; t=x"),
        ("unproved", "u_x=0", "u(x,t): field; q: state", "u=0; x=q"),
    ]);
}

#[test]
fn formal_solutions_and_conditions_that_contradict_each_other() {
    let fields = "u(x,t): field";
    all(&[
        // Kovalevskaya's example: every coefficient of the series can be found, and it converges nowhere.
        ("unrefuted", "u(x,0)=0", fields, r"u_t=u_{xx}; u(x,0)=\frac1{1-x}; x<1"),
        ("unproved", "1=0", fields, r"u_t=u_{xx}; u(x,0)=\frac1{1-x}"),
        ("unproved", "1=0", "u(x,y): field", r"u_x=y; u_y=-x"),
        ("unproved", "u=7", "u(x,y): field", r"u_x=y; u_y=-x"),
        ("unproved", "u=7", "u(x,y): field", r"u_x=yu+1; u_y=u"),
        ("proved", "u=0", "u(x,y): field", r"u_x=yu; u_y=u"),
        ("unrefuted", "u=0", "u(x,y): field", r"u_x=yu; u_y=u"),
        // u = 1.
        ("unproved", r"f''=-f", "f(x): field", r"(f')^2=1-f^2"),
        // Not smooth at 0, where the mixed derivatives are -1 and 1: smoothness is what a field is declared with.
        ("unproved", r"f_{xy}(0,0)=-1", r"f(x,y): field = \frac{xy(x^2-y^2)}{x^2+y^2}", ""),
        ("unproved", r"f_{xy}(0,0)=1", r"f(x,y): field = \frac{xy(x^2-y^2)}{x^2+y^2}", ""),
    ]);
}

#[test]
fn variations_and_energies_that_are_taken_too_early() {
    all(&[
        // Routh: p_φ = ℓ is put in after varying. From L = ½m(ṙ² + r²φ̇²), m r̈ = +ℓ²/(m r³).
        (
            "proved",
            r"\frac{\delta L}{\delta r}=\frac{\ell^2}{mr^3}-m\ddot r",
            r"r, \varphi: state; m, \ell: positive; L = \frac m2(\dot r^2+r^2\dot\varphi^2)",
            r"mr^2\dot\varphi=\ell; r\ne0",
        ),
        (
            "unproved",
            r"\frac{\delta L}{\delta r}=-\frac{\ell^2}{mr^3}-m\ddot r",
            r"r, \varphi: state; m, \ell: positive; L = \frac m2(\dot r^2+r^2\dot\varphi^2)",
            r"mr^2\dot\varphi=\ell; r\ne0",
        ),
        // ∂H/∂t = 0 alone conserves nothing.
        ("unproved", r"\frac{d}{dt}H=0", r"t: time; q, p: state; H = \frac{p^2}{2}+\frac{q^2}{2}", ""),
        (
            "proved",
            r"\frac{d}{dt}H=0",
            r"t: time; q, p: state; H = \frac{p^2}{2}+\frac{q^2}{2}",
            r"\dot q=p; \dot p=-q",
        ),
        // Of p = q̇³ − q̇ there are three velocities, and no one Hamiltonian.
        ("unproved", r"\dot q=1", r"t: time; q, p: state", r"p=\dot q^3-\dot q; p=0"),
        // A density that is a divergence has no equation of motion: boundary terms do not count.
        ("proved", r"\frac{\delta W}{\delta u}=0", r"u(x,t): field; W = u_tu_{xx}+u_xu_{xt}", ""),
        ("refuted", r"W=0", r"u(x,t): field; W = u_tu_{xx}+u_xu_{xt}", ""),
        ("proved", r"\frac{\delta W}{\delta u}=0", r"u(x,t): field; W = 2uu_x", ""),
        ("refuted", r"\frac{\delta W}{\delta u}=0", r"u(x,t): field; W = uu_x^2", ""),
    ]);
}

const HEAD: &str = r#"
[derivation]
title = "T"
concerns = "C"
[symbols]
't' = { role = "time" }
'x' = { role = "coordinate" }
'y' = { role = "coordinate" }
'z' = { role = "coordinate" }
'r' = { role = "abbreviation", formula = '\sqrt{x^2+y^2+z^2}' }
'u(x,t)' = { role = "field" }
'w(x,y)' = { role = "field" }
'v(x,y,z)' = { role = "field" }
[system.shift]
fields = ['u']
equations = ['u_t=-u_x']
[system.wave]
fields = ['u']
equations = ['\partial_t^2u=\partial_x^2u']
[system.plane]
fields = ['w']
equations = ['\nabla^2w=0']
[system.space]
fields = ['v']
equations = ['\nabla^2v=0']
"#;

fn word(claim: &str) -> &'static str {
    let text = format!("{HEAD}[[claim]]\nid = 'c'\nsays = 's'\n{claim}\n");
    let source = Source { path: "t.toml".into(), text };
    let derivation = parse(source, "t").unwrap_or_else(|found| panic!("{claim}\n{}", render(&found, false)));
    let options = Options { plain: true, ..Options::default() };
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{claim}: {e:?}"));
    account.claims[0].region.as_ref().expect("a region").verdict.outcome().word()
}

#[test]
fn formulas_solve_nothing_where_they_are_not_smooth() {
    let along = |formula: &str| format!("ranges = {{ 'x' = [-1, 3], 't' = [0, 1], 'u' = '{formula}' }}");
    let plane = |formula: &str| format!("ranges = {{ 'x' = [-1, 1], 'y' = [-1, 1], 'w' = '{formula}' }}");
    let space =
        |formula: &str| format!("ranges = {{ 'x' = [-1, 1], 'y' = [-1, 1], 'z' = [-1, 1], 'v' = '{formula}' }}");
    for (system, ranges) in [
        ("shift", along("|x-t|")),
        ("wave", along("|x-t|")),
        ("wave", along("|x-t|^3+|x|")),
        // Every derivative is 0 but at the leaps: the second one, too, has no value there.
        ("shift", along(r"\lfloor x\rfloor")),
        ("wave", along(r"\lfloor x\rfloor")),
        ("wave", along(r"\lfloor x-t\rfloor")),
        ("shift", along(r"\frac{|x|}x")),
        ("wave", along(r"\frac1{x-t}")),
        ("plane", plane(r"\ln(x^2+y^2)")),
        ("plane", plane(r"\operatorname{atan2}(y,x)")),
        ("space", space(r"\frac1{r}")),
    ] {
        let found = word(&format!("solves = '{system}'\n{ranges}"));
        assert!(found == "fails" || found == "undecided", "{found}: {system}, {ranges}");
    }
    assert_eq!(
        word("solves = 'wave'\nranges = { 'x' = [1.1, 1.9], 't' = [0, 1], 'u' = '\\lfloor x\\rfloor' }"),
        "holds"
    );
    assert_eq!(word("solves = 'shift'\nranges = { 'x' = [2, 3], 't' = [0, 1], 'u' = '|x-t|' }"), "holds");
    for derivative in [r"\partial_xu", r"\partial_x^2u", r"\partial_x^3u", r"\partial_x\partial_tu"] {
        let found = word(&format!("defined = ['{derivative}']\n{}", along(r"\lfloor x-t\rfloor")));
        assert!(found == "fails" || found == "undecided", "{found}: {derivative}");
    }
}

#[test]
fn what_is_assumed_at_one_place_of_a_domain_is_not_derived() {
    for (expected, ranges, assumed, claimed) in [
        ("fails", "'x' = 0, 't' = [0, 1], 'u' = 'xt'", "u=0", r"\partial_xu=0"),
        ("holds", "'x' = 0, 't' = [0, 1], 'u' = 'xt'", "u=0", r"\partial_tu=0"),
        ("fails", "'x' = [0, 1], 't' = 0, 'u' = 'xt'", "u=0", r"\partial_tu=0"),
        ("fails", "'x' = 0, 't' = [0, 1], 'u' = 'x^2'", "u_x=0", r"u_{xx}=0"),
        ("fails", "'x' = [0, 1], 't' = 0, 'u' = 'xt'", "u_x=0", r"u_{xt}=0"),
        ("fails", "'x' = [-1, 1], 't' = [0, 1], 'u' = 'x+t'", "u=t", r"u_x=0"),
        ("fails", "'x' = 1, 't' = [0, 1], 'u' = 'x-1'", "u=0", "u(0,t)=0"),
        ("holds", "'x' = 1, 't' = [0, 1], 'u' = 'x-1'", "u=0", "u(1,t)=0"),
        ("fails", "'x' = [0, 1], 't' = [0, 1], 'u' = '(x-t)^2'", "x=t", "u_{xx}=0"),
        ("holds", "'x' = [0, 1], 't' = [0, 1], 'u' = '(x-t)^2'", "x=t", "u_x=0"),
    ] {
        let found = word(&format!("ranges = {{ {ranges} }}\nassuming = ['{assumed}']\nalways = ['{claimed}']"));
        assert!(
            found == expected || expected == "holds" && found == "undecided",
            "{found}: {ranges}, {assumed}, {claimed}"
        );
    }
}
