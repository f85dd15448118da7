//! Algebra modulo facts, fields, and signs of parts.

use super::formula::*;
use crate::*;

fn modulo(says: &str, facts: &[FactId]) -> Step {
    Step::Zero { says: rel(says), multiplier: term("1"), terms: vec![], insert: vec![], modulo: facts.to_vec() }
}

fn root_law(w: &mut Work, of: &[&str]) -> Vec<FactId> {
    of.iter().map(|e| w.law(Law::SquareOfRoot, &[e])).collect()
}

#[test]
fn laws_and_facts_are_divided_by() {
    let s = sequent("x,y", 1, "x=0").premise("x^2+y^2=1").premise("x*y=0");
    let mut w = Work::new(&s);
    let circle = w.premise(0);
    let product = w.premise(1);
    let law = w.law(Law::Pythagoras, &["x"]);
    w.step(modulo("sin(x)^4-cos(x)^4=1-2*cos(x)^2", &[law]));
    let fact = w.step(modulo("x^3*y+y*x=x*y*(x^2+1)", &[]));
    assert!(w.0.needs(fact).is_empty());
    w.step(modulo("(x+y)^2=1", &[circle, product]));
    // What does not follow: another sign, another power, a fact that is not among them.
    w.refuse(modulo("sin(x)^2-cos(x)^2=1", &[law]), "no identity");
    w.refuse(modulo("cos(x)=sin(x)", &[law]), "no identity");
    w.refuse(modulo("(x+y)^2=1", &[circle]), "no identity");
    w.refuse(modulo("x+y=1", &[circle, product]), "no identity");
    // Of different arguments nothing is known.
    w.refuse(modulo("sin(y)^2+cos(y)^2=1", &[law]), "no identity");
}

#[test]
fn a_divisor_brings_its_needs_and_its_times() {
    let s = sequent("x,y", 1, "x=0").assuming("x^3=2").premise("x^2=1/y");
    let mut w = Work::new(&s);
    let (a, b) = (w.given(Given::Assumed(0)), w.premise(0));
    let end = w.step(modulo("x^2*y+x^3=3", &[a, b]));
    assert_eq!(w.0.fact(end).unwrap().when(), &When::Chosen);
    assert_eq!(w.0.needs(end), [rel("y#0")]);
    w.refuse(modulo("x^2*y+x^3=4", &[a, b]), "no identity");
    // A division by what is not an equation.
    let s = sequent("x", 1, "x=0").selector("x>0");
    let mut w = Work::new(&s);
    let a = w.given(Given::Selector(0));
    w.refuse(modulo("x=0", &[a]), "no equation");
    // Nothing is divided by 0 = 0, nor by 1 = 1.
    let nothing = w.zero("x=x", "1", &[]);
    w.refuse(modulo("x=0", &[nothing]), "nothing is divided");
}

#[test]
fn both_signs_of_a_root_are_tried() {
    let s = sequent("x,y,z", 1, "x=0");
    let mut w = Work::new(&s);
    // √(x²) is |x| and not x; √x·√y is √(xy), which its square does not say.
    let laws = root_law(&mut w, &["x^2"]);
    w.refuse(modulo("sqrt(x^2)=x", &laws), "no identity");
    let laws = root_law(&mut w, &["x", "y", "x*y"]);
    w.step(modulo("(sqrt(x)*sqrt(y))^2=sqrt(x*y)^2", &laws));
    w.refuse(modulo("sqrt(x)*sqrt(y)=sqrt(x*y)", &laws), "no identity");
}

#[test]
fn what_is_too_large_to_expand_is_tried_with_all_signs() {
    let s = sequent("x,y,z", 1, "x=0");
    let mut w = Work::new(&s);
    let laws = root_law(&mut w, &["x^2+y+1", "y^2+z+2"]);
    let (u, v) = ("sqrt(x^2+y+1)", "sqrt(y^2+z+2)");
    let large = format!("(({u}+{v}+x+y+z+1)^2)^24");
    let end =
        w.step(modulo(&format!("{large}=((x^2+y+1)+(y^2+z+2)+(x+y+z+1)^2+2*{u}*{v}+2*({u}+{v})*(x+y+z+1))^24"), &laws));
    assert!(w.0.log2_error > f64::NEG_INFINITY && w.0.log2_error < -99.0, "{}", w.0.log2_error);
    assert!(!w.0.needs(end).is_empty());
    // One sign of a root differs: true for that choice of signs only.
    w.refuse(modulo(&format!("{large}=(({u}-{v}+x+y+z+1)^2)^24"), &laws), "no identity");
    w.refuse(modulo(&format!("{large}=((-{u}+{v}+x+y+z+1)^2)^24"), &laws), "no identity");
}

#[test]
fn parts_of_what_is_not_zero() {
    let s = sequent("x,y", 1, "1/(x^2+y^2)=0").system("1/sqrt(x^2+y^2)=x").system("1/(x^2*y)=1");
    let mut w = Work::new(&s);
    let root = w.step(Step::HasValue { given: Given::System(0), need: 0 });
    let fact = w.zero("1/(x^2+y^2)=1/(y^2+x^2)", "1", &[]);
    let free = w.discharge(fact, &[root]);
    assert!(w.0.needs(free).is_empty(), "{}", w.all());
    // That a sum is not 0 says nothing of its terms.
    let fact = w.zero("1/x=1/x", "1", &[]);
    let still = w.discharge(fact, &[root]);
    assert_eq!(w.0.needs(still), [rel("x#0")]);
}

fn field() -> Sequent {
    let symbols = vec![
        declared("t", SymbolKind::Time),
        declared("x", SymbolKind::Coordinate),
        declared("u", SymbolKind::Field(2)),
        declared("c", SymbolKind::Constant(ConstantSign::Positive)),
    ];
    Sequent::of(symbols, rel("u=0"))
}

fn partial(by: &[(&str, u8)], rate: u8) -> Term {
    let by = by.iter().map(|(name, n)| ((*name).to_owned(), 0, *n)).collect();
    Term(vec![TermNode::Partial { name: "u".to_owned(), component: 0, rate, by }])
}

#[test]
fn equations_of_fields_have_derivatives_by_coordinates() {
    let mut s = field();
    s.systems.push(Relation::equal(partial(&[], 1), partial(&[("x", 1)], 0)));
    s.claim = Relation::equal(partial(&[], 2), partial(&[("x", 2)], 0));
    let mut w = Work::new(&s);
    let a = w.given(Given::System(0));
    let by_time = w.rate(a);
    let by_x = w.step(Step::Partial { fact: a, by: "x".to_owned(), component: 0 });
    let one = term("1");
    let end = w.step(Step::Zero {
        says: s.claim.clone(),
        multiplier: one.clone(),
        terms: vec![(by_time, one.clone()), (by_x, one)],
        insert: vec![],
        modulo: vec![],
    });
    assert!(w.end(&s, end).leaves_out().is_empty());
    assert!(s.words().unwrap().contains("at every place and time"), "{}", s.words().unwrap());
}

#[test]
fn fields_are_no_functions_of_the_time_alone() {
    // ∂u/∂t = 0 does not make u a number, nor u at one place that at another.
    let mut s = field();
    s.systems.push(Relation::equal(partial(&[], 1), term("0")));
    assert!(Draft::new(&s.clone().instant("0")).is_err());
    let mut w = Work::new(&s);
    let a = w.given(Given::System(0));
    w.refuse(Step::Conserved { of: term("u"), at: Instant(0), rate: a, because: vec![] }, "time alone");
    w.refuse(Step::Smooth { fact: a, because: vec![] }, "time alone");
    w.refuse(Step::Analytic { equations: vec![a], because: vec![] }, "time alone");
    w.refuse(Step::Model { values: vec![], at: "0".to_owned() }, "time alone");
    // What is assumed at chosen places has no derivative unless these are open.
    let mut s = field();
    s.assumed.push(rel("u=x"));
    s.selectors.push(rel("x≤0"));
    let mut w = Work::new(&s);
    let a = w.given(Given::Assumed(0));
    w.refuse(Step::Partial { fact: a, by: "x".to_owned(), component: 0 }, "single times");
    w.refuse(Step::Open { because: vec![] }, "single times");
    // No further derivative than there are, and none by what is no coordinate.
    let mut s = field();
    s.systems.push(Relation::equal(partial(&[("x", 2)], 0), term("0")));
    let mut w = Work::new(&s);
    let a = w.given(Given::System(0));
    w.refuse(Step::Partial { fact: a, by: "x".to_owned(), component: 0 }, "no further");
    w.refuse(Step::Partial { fact: a, by: "c".to_owned(), component: 0 }, "no such coordinate");
}
