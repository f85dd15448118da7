//! True proofs, each with the rules that it is about.

use super::formula::*;
use crate::*;

#[test]
fn energy_is_conserved() {
    let s = sequent("x,y", 1, "x^2+y^2=x(0)^2+y(0)^2").instant("0").system("x'=y").system("y'=-x");
    let mut w = Work::new(&s);
    let (a, b) = (w.given(Given::System(0)), w.given(Given::System(1)));
    let rate = w.zero("2*x*x'+2*y*y'=0", "1", &[(a, "2*x"), (b, "2*y")]);
    let end = w.step(Step::Conserved { of: term("x^2+y^2"), at: Instant(0), rate, because: vec![] });
    let shown = w.end(&s, end);
    assert!(shown.leaves_out().is_empty() && !shown.model() && shown.log2_error() == f64::NEG_INFINITY);
    assert_eq!(shown.given(), [Given::System(0), Given::System(1)]);
}

#[test]
fn a_proof_can_have_a_model() {
    let s = sequent("x,y", 1, "x^2+y^2=x(0)^2+y(0)^2").instant("0").system("x'=y").system("y'=-x");
    let mut w = Work::new(&s);
    let at_rest = |x: &str| Step::Model {
        values: vec![("x".to_owned(), 0, term(x)), ("y".to_owned(), 0, term("0"))],
        at: "0".to_owned(),
    };
    w.refuse(at_rest("1"), "not true on the motion");
    w.refuse(at_rest("t"), "not true on the motion");
    w.step(at_rest("0"));
    assert!(w.0.model);
}

#[test]
fn division_leaves_a_case_out_and_cases_close_it() {
    // x y = x, and x is never 0: y = 1.
    let s = sequent("x,y", 1, "y=1").premise("x*y=x").premise("x>0");
    let mut w = Work::new(&s);
    let (a, positive) = (w.premise(0), w.premise(1));
    let open = w.zero("y=1", "x", &[(a, "1")]);
    assert_eq!(w.0.needs(open), [rel("x#0")]);
    let end = w.discharge(open, &[positive]);
    assert!(w.end(&s, end).leaves_out().is_empty());
    // Without it, the case is left out, and told.
    let s = sequent("x,y", 1, "y=1").premise("x*y=x");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let end = w.zero("y=1", "x", &[(a, "1")]);
    assert_eq!(w.end(&s, end).leaves_out(), [rel("x#0")]);
}

#[test]
fn cases_on_intervals_end_in_the_limit() {
    // x' x = 0 on T: on intervals x' ≡ 0 or x ≡ 0, whose rate is 0. So x' = 0 always.
    let s = sequent("x", 1, "x'=0").premise("x*x'=0");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let zero_x = w.suppose("x=0", Manner::OnIntervals);
    let rest = w.suppose("x'=0", Manner::OnIntervals);
    let x = w.supposed(zero_x, When::Always);
    let left = w.rate(x);
    let right = w.supposed(rest, When::Always);
    let end = w.step(Step::Close {
        within: When::Always,
        split: Split::Product(a),
        branches: vec![left, right],
        because: vec![],
    });
    assert!(w.end(&s, end).leaves_out().is_empty());
}

#[test]
fn a_formula_that_solves_a_system_is_its_solution() {
    let s = sequent("x", 2, "x=cos(t)").instant("0").premise("x''=-x").premise("x(0)=1").premise("x'(0)=0");
    let mut w = Work::new(&s);
    let (a, start, slow) = (w.premise(0), w.premise(1), w.premise(2));
    let rates = vec![
        w.zero("x'-(-sin(t)*1)=0*(x-cos(t))+1*(x'+sin(t))", "1", &[]),
        w.zero("x''+cos(t)*1=-1*(x-cos(t))+0*(x'+sin(t))", "1", &[(a, "1")]),
    ];
    let cosine = w.step(Step::Congruence { says: rel("cos(0)=1"), from: None, equal: vec![] });
    let sine = w.step(Step::Congruence { says: rel("sin(0)=0"), from: None, equal: vec![] });
    let starts = vec![
        w.zero("x(0)-cos(0)=0", "1", &[(start, "1"), (cosine, "0")]),
        w.zero("x'(0)+sin(0)=0", "1", &[(slow, "1"), (sine, "0")]),
    ];
    let matrix = vec![vec![term("0"), term("1")], vec![term("-1"), term("0")]];
    let of = vec![term("x-cos(t)"), term("x'+sin(t)")];
    let zero = w.step(Step::Vanishes { of, matrix, at: Instant(0), rates, starts, because: vec![] });
    let end = w.zero("x=cos(t)", "1", &[(zero, "1")]);
    w.end(&s, end);
}

#[test]
fn congruence_and_laws() {
    let s = sequent("a", 0, "exp(sin(a)^2)*exp(cos(a)^2)=exp(1)");
    let mut w = Work::new(&s);
    let one = w.law(Law::Pythagoras, &["a"]);
    let sum = w.law(Law::ExponentialOfSum, &["sin(a)^2", "cos(a)^2"]);
    let e = w.step(Step::Congruence { says: rel("exp(sin(a)^2+cos(a)^2)=exp(1)"), from: None, equal: vec![one] });
    let end = w.zero("exp(sin(a)^2)*exp(cos(a)^2)=exp(1)", "1", &[(sum, "-1"), (e, "1")]);
    w.end(&s, end);
    // The value of a function that moves at times that are equal.
    let s = sequent("f", 0, "f(p)=f(q)").constant("p", ConstantSign::Any).constant("q", ConstantSign::Any);
    let s = s.instant("p").instant("q").premise("p=q");
    let mut w = Work::new(&s);
    let same = w.premise(0);
    let end = w.step(Step::Congruence { says: rel("f(p)=f(q)"), from: None, equal: vec![same] });
    w.end(&s, end);
}

#[test]
fn selectors_open_sets_and_rates() {
    let s = sequent("x,z", 2, "z''=0").selector("x>1").assuming("z=2*t");
    let mut w = Work::new(&s);
    w.step(Step::Open { because: vec![] });
    let a = w.given(Given::Assumed(0));
    let rate = w.rate(a);
    let end = w.rate(rate);
    w.end(&s, end);
}

#[test]
fn roots_and_orders() {
    let s = sequent("", 0, "a=b")
        .constant("a", ConstantSign::Positive)
        .constant("b", ConstantSign::NotNegative)
        .premise("a^2=b^2");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let end = w.step(Step::Injective { fact: a, from: vec![] });
    w.end(&s, end);
    let s = sequent("x,y", 0, "x=0").premise("x^2+(y-1)^2=0");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let square = w.step(Step::Summand { sum: a, term: term("x^2"), from: vec![] });
    let again = w.suppose("x=0", Manner::AtTimes);
    let x = w.supposed(again, When::Always);
    let end =
        w.step(Step::Close { within: When::Always, split: Split::Product(square), branches: vec![x], because: vec![] });
    w.end(&s, end);
    let s = sequent("x", 0, "x+1/x>0").premise("x>0");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let sum = w.sign("x+1/x>0", &[a]);
    let end = w.discharge(sum, &[a]);
    w.end(&s, end);
}

#[test]
fn analytic_functions_go_on() {
    let s = sequent("x,y,z", 1, "z=x").system("x'=y").system("y'=-x").system("z'=y").selector("t>1").assuming("z=x");
    let mut w = Work::new(&s);
    w.step(Step::Open { because: vec![] });
    let equations: Vec<FactId> = (0..3).map(|i| w.given(Given::System(i))).collect();
    w.step(Step::Analytic { equations, because: vec![] });
    let a = w.given(Given::Assumed(0));
    let end = w.step(Step::Continue { fact: a, because: vec![] });
    assert!(matches!(w.0.fact(end).unwrap().when(), When::Always));
    w.end(&s, end);
}

#[test]
fn further_rates() {
    let s = sequent("x,y", 1, "x''=-x").system("x'=y").system("y'=-x");
    // Not declared: refused where it is read.
    assert!(Draft::new(&s).is_err());
    let s = sequent("x,y", 1, "x'=y").system("x'=y").system("y'=-x");
    let mut w = Work::new(&s);
    let a = w.given(Given::System(0));
    w.refuse(Step::Rate { fact: a }, "no further rate");
    w.step(Step::Smooth { fact: a, because: vec![] });
    let b = w.rate(a);
    assert_eq!(w.0.says(b).unwrap(), rel("x''=y'"));
}

#[test]
fn trials_take_over_where_expansion_is_too_large() {
    let power = "(x+y+x*y+x^2+3)^90";
    let s = sequent("x,y", 0, &format!("{power}*{power}=(x+y+x*y+x^2+3)^180"));
    let mut w = Work::new(&s);
    let end = w.step(zero(&format!("{power}*{power}=(x+y+x*y+x^2+3)^180"), "1", &[]));
    w.refuse(zero(&format!("{power}*{power}=(x+y+x*y+x^2+3)^181"), "1", &[]), "does not follow");
    let shown = w.end(&s, end);
    assert!(shown.log2_error() <= -100.0 && shown.log2_error() > -300.0, "{}", shown.log2_error());
}

#[test]
fn sequents_in_words() {
    let s = sequent("x,z", 1, "z'=2").selector("x>1").assuming("z=2*t").premise("x'=1").instant("0").define("w", "x^2");
    assert_eq!(
        s.words().unwrap(),
        r"For every motion (`x`, a function of time with 1 continuous rates; `z`, a function of time with 1 continuous rates) with `w=x^2` by definition; with `\dot{x}=1` at all times; with `z=2\cdot t` at every time at which `1<x`, on times among which are `0`: at every time at which `1<x` and the assumptions have values, `\dot{z}=2` where both sides have values."
    );
}

#[test]
fn solved_equations_are_put_in() {
    // a·x = b and y = sin(x²), a ≠ 0: what a solver finds, without cofactors.
    let s =
        sequent("x,y", 1, "a*x*y=b*sin((b/a)^2)").constant("a", ConstantSign::NotZero).constant("b", ConstantSign::Any);
    let s = s.premise("a*x=b").premise("y=sin(x^2)");
    let mut w = Work::new(&s);
    let (p, q) = (w.premise(0), w.premise(1));
    let x = w.zero("x=b/a", "a", &[(p, "1")]);
    assert!(w.0.fact(x).unwrap().is_free());
    w.refuse(inserted("a*x*y=b*sin((b/a)^2)", &[q]), "no identity");
    // In the order in which they are given.
    w.refuse(inserted("a*x*y=b*sin((b/a)^2)", &[x, q]), "no identity");
    let end = w.step(inserted("a*x*y=b*sin((b/a)^2)", &[q, x]));
    w.end(&s, end);
    // A pivot that may vanish stays a need.
    let s = sequent("x,y", 1, "y=1").premise("x*y=x");
    let mut w = Work::new(&s);
    let p = w.premise(0);
    let y = w.zero("y=x/x", "x", &[(p, "1")]);
    let end = w.step(inserted("y=1", &[y]));
    assert_eq!(w.0.needs(end), [rel("x#0")]);
    // Known at chosen times, it is put in there; a rate is not touched.
    let s = sequent("x,y", 1, "x'=0").assuming("x=2");
    let mut w = Work::new(&s);
    let p = w.given(Given::Assumed(0));
    let end = w.step(inserted("x*y=2*y", &[p]));
    assert_eq!(w.0.fact(end).unwrap().when(), &When::Chosen);
    w.refuse(inserted("x'=0", &[p]), "no identity");
}
