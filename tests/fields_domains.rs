//! Fields with formulas on a domain: what `solves` says there, boundary data, traps, and the pictures of the page.

use rederive::check::{Account, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::report;

const HEAD: &str = r#"
[derivation]
title = "T"
concerns = "C"

[symbols]
't' = { role = "time" }
'x' = { role = "coordinate" }
'y' = { role = "coordinate" }
'c' = { role = "parameter" }
'a' = { role = "parameter" }
'u(x,t)' = { role = "field" }
'f(x)' = { role = "field" }
'{\bf v}(x,y)' = { role = "field", shape = "2" }

[system.string]
fields = ['u']
equations = ['\partial_t^2u=c^2\partial_x^2u']

[system.shift]
fields = ['u']
equations = ['u_t=-u_x']
"#;

fn tried(claim: &str) -> (Derivation, Account) {
    let text = format!("{HEAD}\n[[claim]]\nid = \"c\"\nsays = \"s\"\n{claim}\n");
    let mut derivation =
        parse(Source { path: "t.toml".into(), text }, "t").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let account = check(&mut derivation, &Options::default(), &|_, _| {}).expect("it is checked");
    (derivation, account)
}

fn word(claim: &str) -> &'static str {
    let (_, account) = tried(claim);
    account.claims[0].region.as_ref().expect("a region").verdict.outcome().word()
}

#[test]
fn a_problem_with_its_data_is_solved_or_not() {
    let wave = r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'c' = [1, 2], 'u' = '\sin(\pi x)\cos(c\pi t)' }
solves = 'string'
";
    for (expected, data) in [
        ("holds", r"always = ['u(0,t)=0', 'u(x,0)=\sin\pi x', 'u_t(x,0)=0']"),
        ("holds", r"always = ['\left.\partial_tu\right|_{t=0}=0']"),
        ("fails", r"always = ['u(\frac12,t)=0']"),
        ("fails", r"always = ['u_x(0,t)=0']"),
        ("fails", r"always = ['u_t(x,1)=0']"),
        ("fails", r"always = ['u(x,0)=\sin 2\pi x']"),
    ] {
        assert_eq!(word(&format!("{wave}{data}")), expected, "{data}");
    }
}

#[test]
fn what_is_not_smooth_solves_nothing() {
    let of =
        |u: &str, t: &str| word(&format!("ranges = {{ 'x' = [-1, 1], 't' = {t}, 'u' = '{u}' }}\nsolves = 'shift'"));
    assert_eq!(of("(x-t)^2", "[0, 0.5]"), "holds");
    assert_eq!(of("(x+t)^2", "[0, 0.5]"), "fails");
    // A kink, an infinite slope, and a pole inside; outside of the box they do no harm.
    assert_ne!(of("|x-t|", "[0, 0.5]"), "holds");
    assert_ne!(of(r"\sqrt{x-t}", "[0, 0.5]"), "holds");
    assert_ne!(of(r"\frac{1}{x-t}", "[0, 0.5]"), "holds");
    assert_eq!(of("|x-t|", "[2, 3]"), "holds");
}

#[test]
fn a_profile_is_taken_where_it_has_gone() {
    let of = |f: &str, u: &str| {
        word(&format!("ranges = {{ 'x' = [-1, 1], 't' = [0, 1], 'c' = [1, 2], 'f' = '{f}' }}\nalways = ['''{u}''']"))
    };
    assert_eq!(of("e^{-x^2}", r"\partial_tf(x-ct)=-c\partial_xf(x-ct)"), "holds");
    assert_eq!(of("e^{-x^2}", r"f(x-ct)=e^{-(x-ct)^2}"), "holds");
    assert_eq!(of("e^{-x^2}", r"f(x-ct)=e^{-x^2}"), "fails");
    assert_eq!(of("x^3", r"f''(ct)=6ct"), "holds");
    assert_eq!(of("x^3", r"f''(ct)=6x"), "fails");
    // Where it has no value it is not counted, and is not there.
    assert_ne!(word("ranges = { 'x' = [-1, 1], 'f' = '\\ln x' }\ndefined = ['f(x)']"), "holds");
    assert_ne!(word("ranges = { 'x' = [0.5, 1], 'f' = '\\ln x' }\ndefined = ['f(x-1)']"), "holds");
}

#[test]
fn fields_are_drawn() {
    let (derivation, account) = tried(
        r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'u' = '\sin(x+2t)' }
always = ['u_t=u_x']",
    );
    let of = account.claims[0].region.as_ref().expect("a region");
    assert_eq!(of.portraits.iter().map(|p| p.residual).collect::<Vec<_>>(), [false, true]);
    let page = report::page(&derivation, &account);
    for said in
        ["class=fp", "class=fx", "The cross marks the point at which the claim fails", "The left side minus the right"]
    {
        assert!(page.contains(said), "{said}");
    }
    // An identity has no residual to be seen; arrows have no squares.
    let (derivation, account) = tried(
        r"ranges = { 'x' = [-1, 1], 'y' = [-1, 1], '{\bf v}' = '(-y,x)' }
always = ['\nabla\cdot{\bf v}=0']",
    );
    let of = account.claims[0].region.as_ref().expect("a region");
    assert_eq!(of.portraits.len(), 1);
    let page = report::page(&derivation, &account);
    assert!(page.contains("class=fa") && page.contains("arrows, the longest of length"));
    // One range is no map.
    let (_, account) = tried("ranges = { 'x' = [0, 1], 't' = 0, 'u' = 'x' }\nalways = ['u_x=1']");
    assert!(account.claims[0].region.as_ref().expect("a region").portraits.is_empty());
}

/// The altered formulas of the only claim: how many are rejected, of how many, and those that are not.
fn altered(claim: &str) -> Option<(usize, usize, Vec<String>)> {
    let (_, account) = tried(claim);
    let variants = account.claims[0].variants.as_ref()?;
    let (rejected, of) = variants.together()?;
    Some((rejected, of, variants.survivors.iter().map(|s| s.formula.clone()).collect()))
}

#[test]
fn altered_formulas_of_fields_are_told_from_them() {
    // By values through which solutions pass.
    let flow = r"follows-from = ['string']
always = ['\partial_t((\partial_tu)^2+(c\,\partial_xu)^2)=2c^2\partial_x(\partial_tu\,\partial_xu)']";
    let (rejected, of, left) = altered(flow).expect("they are tried");
    assert!(of > 20 && rejected == of && left.is_empty(), "{rejected} of {of}: {left:?}");
    // By points of a box. That the field solves another equation as well is no fault of the test.
    let runs = r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'c' = [1, 2], 'u' = '\sin(x-ct)' }
always = ['\partial_t^2u=c^2\partial_x^2u']";
    let (rejected, of, left) = altered(runs).expect("they are tried");
    assert!(of > 10 && rejected == of && left.is_empty(), "{rejected} of {of}: {left:?}");
    let still = r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'c' = 0, 'u' = 'x' }
always = ['\partial_t^2u=c^2\partial_x^2u']";
    let (rejected, of, left) = altered(still).expect("they are tried");
    assert!(rejected == 0 && left.len() == of, "{rejected} of {of}: {left:?}");
    // Where it applies.
    let half = r"ranges = { 'x' = [-1, 1], 't' = [0, 1], 'u' = '|x|' }
assuming = ['x>0']
always = ['u_x=1']";
    let (rejected, of, left) = altered(half).expect("they are tried");
    assert!(rejected == of && left.is_empty(), "{rejected} of {of}: {left:?}");
    // Where no theorem gives a solution, none is tried; and none of a claim that does not hold.
    assert_eq!(altered("assuming = ['(\\partial_xu)^2=u', '(\\partial_tu)^2=u']\nalways = ['4u_x^2=4u']"), None);
    assert_eq!(altered("always = ['u_x=u_t']"), None);
}

#[test]
fn pages_say_where_altered_formulas_were_tried() {
    for (claim, said) in [
        (
            r"follows-from = ['shift']
always = ['u_{tt}=u_{xx}']",
            "would be noticed by solutions of what is given",
        ),
        (
            r"ranges = { 'x' = [0, 1], 't' = [0, 1], 'u' = 'x-t' }
always = ['u_t=-u_x']",
            "would be noticed at points of the ranges",
        ),
    ] {
        let (derivation, account) = tried(claim);
        let page = report::page(&derivation, &account);
        assert!(page.contains(said), "{said}");
    }
}
