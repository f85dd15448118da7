//! For each rule, a step that would prove something false without its condition: refused.

use super::formula::*;
use crate::*;

fn always() -> When {
    When::Always
}

#[test]
fn restrict_to_a_time_that_the_sequent_does_not_name() {
    let s = sequent("x", 1, "x=2").premise("x=2");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    w.refuse(Step::Restrict { fact: a, to: When::At(Instant(0)), because: vec![] }, "no such fixed time");
    // Nor may a formula of a step name one: T need not contain it.
    w.refuse(zero("x(7)=2", "1", &[(a, "1")]), "does not name");
    // A time that has a value in some motions only.
    let s = sequent("x", 1, "x(1/c)=2").constant("c", ConstantSign::Any).instant("1/c").premise("x=2");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let end = w.step(Step::Restrict { fact: a, to: When::At(Instant(0)), because: vec![] });
    assert_eq!(w.0.needs(end), [rel("c#0")]);
    // The claim needs it, too.
    let need = w.step(Step::ClaimHasValue { need: 0, within: always() });
    let end = w.discharge(end, &[need]);
    assert!(w.end(&s, end).leaves_out().is_empty());
}

#[test]
fn a_case_is_not_left_by_restricting() {
    let s = sequent("x", 1, "x=2");
    let mut w = Work::new(&s);
    let case = w.suppose("x=2", Manner::AtTimes);
    let a = w.supposed(case, always());
    for to in [always(), When::Chosen] {
        w.refuse(Step::Restrict { fact: a, to, because: vec![] }, "not times");
    }
    w.refuse(Step::Conclude { fact: a }, "not known");
    w.refuse(Step::Rate { fact: a }, "single times");
    w.refuse(
        Step::Close { within: always(), split: Split::Order(term("x"), term("2")), branches: vec![a], because: vec![] },
        "left out",
    );
    w.refuse(
        Step::Close { within: always(), split: Split::Order(term("x"), term("0")), branches: vec![a], because: vec![] },
        "something else",
    );
    w.refuse(Step::Supposition { case, within: When::At(Instant(0)).within(case) }, "no such times");
    // A case of a number is all times or none, and nothing outside of it is known.
    let s = sequent("x", 1, "c=2").constant("c", ConstantSign::Any);
    let mut w = Work::new(&s);
    let case = w.suppose("c=2", Manner::OnIntervals);
    let a = w.supposed(case, always());
    w.refuse(Step::Conclude { fact: a }, "not known");
}

#[test]
fn cases_on_intervals_say_nothing_of_strict_relations() {
    // x ≠ 0 on intervals does not make x ≠ 0.
    let s = sequent("x", 1, "x#0").premise("x'=1");
    let mut w = Work::new(&s);
    let b = w.premise(0);
    let [zero_x, other] = ["x=0", "x#0"].map(|says| w.suppose(says, Manner::OnIntervals));
    let still = w.supposed(zero_x, always());
    let rate = w.rate(still);
    let contradiction = w.zero("1=0", "1", &[(rate, "1"), (b, "-1")]);
    let left = w.sign("x#0", &[contradiction]);
    let right = w.supposed(other, always());
    let split = Split::Order(term("x"), term("0"));
    w.refuse(Step::Close { within: always(), split, branches: vec![left, right], because: vec![] }, "strict");
}

#[test]
fn open_wants_selectors_that_do_not_leap() {
    for (selector, why) in
        [("x≥0", "single times"), ("x=0", "single times"), ("sqrt(x)<1", "not shown"), ("atan2(x,-1)>1", "not shown")]
    {
        let s = sequent("x", 1, "x=2").selector(selector);
        Work::new(&s).refuse(Step::Open { because: vec![] }, why);
    }
    for selector in ["x>0", "x#0", "1/x>1", "ln(x)<2", "abs(x)>1", "atan2(x,1+x^2)<1"] {
        let s = sequent("x", 1, "x=2").selector(selector);
        let mut w = Work::new(&s);
        w.step(Step::Open { because: vec![] });
    }
    // The rate of a definition with a kink has values at single times.
    let s = sequent("x", 1, "x=2").define("N", "x*abs(x)").assuming("N'=0");
    Work::new(&s).refuse(Step::Open { because: vec![] }, "not shown");
}

#[test]
fn rates_of_what_has_values_at_single_times() {
    // √(−t²) = t·√(−t²) is true at t = 0, where it has values.
    let s = sequent("x", 1, "x=2").premise("sqrt(x)=t*sqrt(x)");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let rate = w.rate(a);
    assert!(w.0.needs(rate).contains(&rel("0<x")));
    // An inequality has no rate.
    let s = sequent("x", 1, "x'≤1").premise("x≤t");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    w.refuse(Step::Rate { fact: a }, "no equation");
}

#[test]
fn algebra_divides_by_nothing_that_vanishes() {
    let s = sequent("x", 1, "1=2");
    let mut w = Work::new(&s);
    // 0·(1 − 2) = 0: d ≠ 0 is a need that nothing can show.
    let end = w.step(zero("1=2", "0", &[]));
    assert_eq!(w.0.needs(end), [rel("0#0")]);
    w.refuse(Step::Conclude { fact: end }, "never so");
    let end = w.step(zero("1=2", "x-x", &[]));
    assert_eq!(w.0.needs(end), [w.read("x-x#0")]);
    w.refuse(zero("1=2", "1", &[]), "no identity");
    w.refuse(zero("1=2", "1/(x-x)", &[]), "denominator");
    w.refuse(
        Step::Zero { says: rel("1<2"), multiplier: term("1"), terms: vec![], insert: vec![], modulo: vec![] },
        "equations",
    );
    // Sine and cosine are indeterminates; so are logarithms of different arguments.
    w.refuse(zero("sin(x)^2+cos(x)^2=1", "1", &[]), "no identity");
    w.refuse(zero("sqrt(x^2)=x", "1", &[]), "no identity");
}

#[test]
fn nothing_is_conserved_across_gaps_edges_and_poles() {
    let conserved = |of: &str, rate, because| Step::Conserved { of: term(of), at: Instant(0), rate, because };
    // x/|x|, ⌊x⌋, 1/x: the rates vanish, or are bounded, wherever they have values.
    for of in ["x/abs(x)", "atan2(0*t,x)", "arctan(1/x)+arctan(x)"] {
        let s = sequent("x", 1, "x=2").instant("0");
        let mut w = Work::new(&s);
        let e = w.0.context.read(&term(of)).unwrap();
        let d = crate::derivative::derivative(&mut w.0.context, e).unwrap();
        let zero_e = w.0.context.graph.integer(0);
        let says = crate::context::Says { left: d, sense: Sense::Equal, right: zero_e };
        let says = w.0.context.written(says).unwrap();
        let law = w.law(Law::SquareOfAbsolute, &["x"]);
        let (q, d) = if of.contains("abs") { ("x'/(x^2*abs(x))*0", "1") } else { ("0", "1") };
        let made = w.0.push(Step::Zero {
            says,
            multiplier: term(d),
            terms: vec![(law, term(q))],
            insert: vec![],
            modulo: vec![],
        });
        if let Ok(Some(rate)) = made {
            w.refuse(conserved(of, rate, vec![]), "needs something");
        }
    }
    // A rate of 0 at chosen times.
    let s = sequent("x", 1, "x=x(0)").instant("0").selector("x>1").assuming("x'=0");
    let mut w = Work::new(&s);
    let a = w.given(Given::Assumed(0));
    w.step(Step::Open { because: vec![] });
    w.refuse(conserved("x", a, vec![]), "not known at all times");
    // Another function than that whose rate vanishes.
    let s = sequent("x", 1, "x^2=0").instant("0").premise("x'=0");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    w.refuse(conserved("x^2+t", a, vec![]), "does not say");
    // |x| where x passes 0.
    w.refuse(conserved("abs(x)", a, vec![]), "does not say");
}

#[test]
fn linear_systems_with_a_pole() {
    // t·ẋ = x and x(0) = 0: x = t.
    let s = sequent("x", 1, "x=0").instant("0").premise("t*x'=x").premise("x(0)=0");
    let mut w = Work::new(&s);
    let (a, start) = (w.premise(0), w.premise(1));
    let rate = w.zero("x'=1/t*x", "t", &[(a, "1")]);
    let vanishes = |rate, because| Step::Vanishes {
        of: vec![term("x")],
        matrix: vec![vec![term("1/t")]],
        at: Instant(0),
        rates: vec![rate],
        starts: vec![start],
        because,
    };
    w.refuse(vanishes(rate, vec![]), "needs something");
    // At other times than those of the start.
    let case = w.suppose("t#0", Manner::AtTimes);
    let not_zero = w.supposed(case, always());
    let free = w.discharge(rate, &[not_zero]);
    w.refuse(vanishes(free, vec![not_zero]), "not known at all times");
    // ẋ = 2√x has x = t².
    let s = sequent("x", 1, "x=0").instant("0").system("x'=2*sqrt(x)").premise("x(0)=0");
    let mut w = Work::new(&s);
    let (a, start) = (w.given(Given::System(0)), w.premise(0));
    let root = w.law(Law::SquareOfRoot, &["x"]);
    let rate = w.zero("x'=2/sqrt(x)*x", "1", &[(a, "1"), (root, "2/sqrt(x)")]);
    let vanishes = Step::Vanishes {
        of: vec![term("x")],
        matrix: vec![vec![term("2/sqrt(x)")]],
        at: Instant(0),
        rates: vec![rate],
        starts: vec![start],
        because: vec![],
    };
    w.refuse(vanishes, "needs something");
}

#[test]
fn congruence_is_of_values_and_not_of_rates() {
    let s = sequent("x,y", 1, "x'=y'").assuming("x=y");
    let mut w = Work::new(&s);
    let a = w.given(Given::Assumed(0));
    let says = |text: &str, from| Step::Congruence { says: rel(text), from, equal: vec![a] };
    w.refuse(says("x'=y'", None), "does not make them the same");
    w.refuse(says("x=2", None), "does not make them the same");
    w.refuse(says("x<y", None), "does not make them the same");
    // In a case, and outside of it.
    let case = w.suppose("x=2", Manner::AtTimes);
    let b = w.supposed(case, always());
    let c = w.step(Step::Congruence { says: rel("sin(x)=sin(2)"), from: None, equal: vec![b] });
    assert!(w.0.fact(c).unwrap().when().is_in_case());
    let d = w.step(Step::Congruence { says: rel("y=2"), from: Some(a), equal: vec![b] });
    assert!(w.0.fact(d).unwrap().when().is_in_case());
}

#[test]
fn signs_are_not_guessed() {
    let s = sequent("x,y", 1, "x>0").premise("x*y>0").premise("x≥0");
    let mut w = Work::new(&s);
    let (a, b) = (w.premise(0), w.premise(1));
    w.refuse(Step::Sign { says: rel("x>0"), from: vec![a] }, "do not show");
    w.refuse(Step::Sign { says: rel("x>0"), from: vec![b] }, "do not show");
    w.refuse(Step::Sign { says: rel("x-y>0"), from: vec![a, b] }, "do not show");
    w.refuse(Step::Sign { says: rel("x^3>0"), from: vec![b] }, "do not show");
    w.refuse(Step::Sign { says: rel("sin(x)>0"), from: vec![b] }, "do not show");
    w.refuse(Step::Sign { says: rel("abs(x)>0"), from: vec![b] }, "do not show");
    // √x ≥ 0, where it has a value.
    let root = w.sign("sqrt(y)≥0", &[]);
    assert_eq!(w.0.needs(root), [rel("y≥0")]);
    // A sum of terms that may be negative.
    let s = sequent("x,y", 1, "x=0").premise("x+y^2=0").premise("x^2+y^2=0");
    let mut w = Work::new(&s);
    let (a, b) = (w.premise(0), w.premise(1));
    w.refuse(Step::Summand { sum: a, term: term("y^2"), from: vec![] }, "may be negative");
    w.refuse(Step::Summand { sum: b, term: term("x"), from: vec![] }, "no such term");
}

#[test]
fn what_is_not_injective() {
    for (premise, why) in [
        ("sin(x)=sin(y)", "not injective"),
        ("x^0=y^0", "constant"),
        ("tan(x)=tan(y)", "not injective"),
        ("exp(x)=cosh(y)", "one operation"),
    ] {
        let s = sequent("x,y", 1, "x=y").premise(premise);
        let mut w = Work::new(&s);
        let a = w.premise(0);
        w.refuse(Step::Injective { fact: a, from: vec![] }, why);
    }
    let s = sequent("x,y", 1, "x=y").premise("x^2=y^2");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let end = w.step(Step::Injective { fact: a, from: vec![] });
    assert_eq!(w.0.needs(end), [rel("x≥0"), rel("y≥0")]);
}

#[test]
fn smooth_and_analytic_want_right_sides_that_are() {
    // ẋ = |x|^…: a right side with an edge.
    let s = sequent("x,y", 1, "x=y").system("x'=sqrt(x)").system("y'=x").selector("x#1").assuming("x=y");
    let mut w = Work::new(&s);
    w.step(Step::Open { because: vec![] });
    let (a, b, c) = (w.given(Given::System(0)), w.given(Given::System(1)), w.given(Given::Assumed(0)));
    w.refuse(Step::Smooth { fact: a, because: vec![] }, "not shown");
    w.refuse(Step::Analytic { equations: vec![a, b], because: vec![] }, "not shown");
    // y is led, x is free.
    w.refuse(Step::Analytic { equations: vec![b], because: vec![] }, "no equation leads");
    w.refuse(Step::Analytic { equations: vec![b, b], because: vec![] }, "two equations");
    w.refuse(Step::Analytic { equations: vec![c], because: vec![] }, "not known");
    w.refuse(Step::Continue { fact: c, because: vec![] }, "analytic");
    // y ∘ ẋ: a rate that is not lower.
    let s = sequent("x,y", 1, "x=y").system("x'=y'").system("y'=x'");
    let mut w = Work::new(&s);
    let (a, b) = (w.given(Given::System(0)), w.given(Given::System(1)));
    w.refuse(Step::Analytic { equations: vec![a, b], because: vec![] }, "no equation leads");
    w.refuse(Step::Smooth { fact: a, because: vec![] }, "no further rate");
}

#[test]
fn another_claim_needs_its_assumptions() {
    // "Given ẋ = 0: x = x(0)" is true; at a time at which ẋ = 0 by chance, x need not be x(0).
    let mut s = sequent("x", 1, "x=x(0)").instant("0").selector("t=1").assuming("x'=0");
    s.claims.push(Claimed {
        name: "rest".into(),
        selectors: vec![],
        hypotheses: vec![rel("x'=0")],
        says: rel("x=x(0)"),
    });
    let mut w = Work::new(&s);
    let a = w.given(Given::Assumed(0));
    w.refuse(Step::Given { given: Given::Claimed(0), because: vec![a] }, "hypothesis");
    // With the same selectors, it is the same.
    s.claims[0].selectors.push(rel("t=1"));
    let mut w = Work::new(&s);
    let a = w.given(Given::Assumed(0));
    w.refuse(Step::Given { given: Given::Claimed(0), because: vec![a] }, "selector");
    let t = w.given(Given::Selector(0));
    let end = w.step(Step::Given { given: Given::Claimed(0), because: vec![a, t] });
    assert_eq!(w.0.fact(end).unwrap().when(), &When::Chosen);
    w.end(&s, end);
}

#[test]
fn another_claim_holds_at_our_times_if_all_of_its_times_are_ours() {
    let claimed = |selectors: &[&str]| Claimed {
        name: "rest".into(),
        selectors: selectors.iter().map(|text| rel(text)).collect(),
        hypotheses: vec![rel("x'=0")],
        says: rel("x=x(0)"),
    };
    let given = |w: &mut Work, because: Vec<FactId>| {
        w.0.push(Step::Given { given: Given::Claimed(0), because }).map_err(|refused| refused.why)
    };
    // A selector that does not move is true at all times or at none: c > 1 leaves out no time of the claim.
    let mut s =
        sequent("x,y", 1, "x=x(0)").instant("0").constant("c", ConstantSign::Any).selector("c>1").assuming("x'=0");
    s.claims.push(claimed(&[]));
    let mut w = Work::new(&s);
    let (c, a) = (w.given(Given::Selector(0)), w.given(Given::Assumed(0)));
    let end = given(&mut w, vec![c, a]).expect("it is accepted").expect("a fact");
    w.end(&s, end);
    // One that moves does: x may move where y is not above 1.
    let mut s = sequent("x,y", 1, "x=x(0)").instant("0").selector("y>1").assuming("x'=0");
    s.claims.push(claimed(&[]));
    let mut w = Work::new(&s);
    let (c, a) = (w.given(Given::Selector(0)), w.given(Given::Assumed(0)));
    assert!(given(&mut w, vec![c, a]).is_err_and(|why| why.contains("hypothesis")));
    // What is assumed beside its hypotheses has values at all of its times, or leaves out some: ln y has none where y is not positive.
    for (more, accepted) in [("x=y+1", true), ("ln(y)=x", false), ("1/y=x", false)] {
        let mut s = sequent("x,y", 1, "x=x(0)").instant("0").selector("t>1").assuming("x'=0").assuming(more);
        s.claims.push(claimed(&["t>1"]));
        let mut w = Work::new(&s);
        let because = vec![w.given(Given::Selector(0)), w.given(Given::Assumed(0)), w.given(Given::Assumed(1))];
        assert_eq!(given(&mut w, because).is_ok(), accepted, "{more}");
    }
    // Where a selector of the claim has a value, 1/y has.
    let mut s = sequent("x,y", 1, "x=x(0)").instant("0").selector("1/y>1").assuming("x'=0").assuming("1/y=x");
    s.claims.push(claimed(&["1/y>1"]));
    let mut w = Work::new(&s);
    let mut because = vec![w.given(Given::Selector(0)), w.given(Given::Assumed(0)), w.given(Given::Assumed(1))];
    because.push(w.step(Step::HasValue { given: Given::Selector(0), need: 0 }));
    assert!(given(&mut w, because).is_ok());
}

#[test]
fn a_size_is_not_below_its_number() {
    let s = sequent("x,y", 1, "0≤abs(x)-x");
    let mut w = Work::new(&s);
    let end = w.step(Step::Sign { says: rel("0≤abs(x)-x"), from: vec![] });
    w.end(&s, end);
    let mut w = Work::new(&s);
    // It may be equal; the other number may be larger, and so may minus the number be.
    for says in ["0<abs(x)-x", "0≤abs(x)-y", "0≤x-abs(x)", "abs(x)-x≤0", "0≤abs(x)+x", "0≤abs(x-y)-x"] {
        w.refuse(Step::Sign { says: rel(says), from: vec![] }, "");
    }
}

#[test]
fn what_is_void_is_not_known() {
    // A premise that has no value is not false: nothing follows where it has none.
    let s = sequent("x,y", 1, "y=1").premise("y/x=1/x");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let end = w.zero("y=1", "1", &[(a, "x")]);
    assert_eq!(w.0.needs(end), [rel("x#0")]);
    w.refuse(Step::HasValue { given: Given::Premise(0), need: 0 }, "need not have a value");
    // Assumed, it has values at the times that count.
    let s = sequent("x,y", 1, "y=1").assuming("y/x=1/x");
    let mut w = Work::new(&s);
    let a = w.given(Given::Assumed(0));
    let need = w.step(Step::HasValue { given: Given::Assumed(0), need: 0 });
    let end = w.zero("y=1", "1", &[(a, "x")]);
    let end = w.discharge(end, &[need]);
    assert!(w.end(&s, end).leaves_out().is_empty());
    // The identity x/x = 1 holds where x ≠ 0; as the claim has no value there, that is all that it says.
    let s = sequent("x", 1, "x/x=1");
    let mut w = Work::new(&s);
    let a = w.step(zero("x/x=1", "1", &[]));
    assert!(!w.0.fact(a).unwrap().is_free());
    let need = w.step(Step::ClaimHasValue { need: 0, within: When::Chosen });
    let end = w.discharge(a, &[need]);
    assert!(w.end(&s, end).leaves_out().is_empty());
}

#[test]
fn sequents_that_are_not_well_formed() {
    let bad = |s: Sequent, why: &str| match Draft::new(&s) {
        Err(refused) => assert!(refused.why.contains(why), "{refused}"),
        Ok(_) => panic!("{why}"),
    };
    bad(sequent("x,x", 1, "x=0"), "twice");
    bad(sequent("x", 1, "x''=0"), "no such rate");
    bad(sequent("x", 1, "y=0"), "no symbol");
    bad(sequent("x", 1, "x(0)=0"), "does not name");
    bad(sequent("x", 1, "x=0").instant("x"), "moves");
    bad(sequent("x", 1, "x=0").define("N", "N+1"), "before it is defined");
    bad(sequent("x", 1, "x=0").define("N", "1").define("N", "2"), "twice");
    bad(sequent("x", 1, "c'=0").constant("c", ConstantSign::Any), "no such rate");
    let mut s = sequent("x", 1, "x=0");
    s.claim.left = Term(vec![TermNode::Apply("+".into(), vec![0, 0])]);
    bad(s.clone(), "no such node");
    s.claim.left = Term(vec![]);
    bad(s.clone(), "empty");
    for text in ["1/0", "1/-2", "", "-", "0x1", "1.5", "1/2/3", "-/2", "+1", "1/00"] {
        s.claim.left = Term(vec![TermNode::Number(text.into())]);
        bad(s.clone(), "no rational");
    }
}

#[test]
fn a_need_at_a_single_time_is_no_ground_for_a_rate() {
    // y = −t², z = 1 + t: both sides have values at t = 0 only.
    let s = sequent("y,z", 1, "z'=0").premise("sqrt(y)+z=sqrt(y)+1");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let z = w.zero("z=1", "1", &[(a, "1")]);
    assert_eq!(w.0.needs(z), [rel("0≤y")]);
    let rate = w.rate(z);
    assert_eq!(w.0.needs(rate), [rel("0<y")]);
}

#[test]
fn every_factor_has_its_branch() {
    let s = sequent("x,y", 1, "x=0").premise("2*x*y^2=0");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    for manner in [Manner::AtTimes, Manner::OnIntervals] {
        let case = w.suppose("x=0", manner);
        let x = w.supposed(case, always());
        let close = Step::Close { within: always(), split: Split::Product(a), branches: vec![x], because: vec![] };
        w.refuse(close, "no branch for `y=0`");
    }
}

#[test]
fn a_leap_of_an_angle_is_no_first_integral() {
    // x = −1, y = t: atan2(y,x) + atan2(−y,x) is 0 but for t = 0, where it is 2π; its rate is 0.
    let s = sequent("x,y", 1, "atan2(y,x)+atan2(-y,x)=0").instant("1").premise("x<0");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let rate = w.zero("(x*y'-y*x')/(y^2+x^2)+(x*(-y')-(-y)*x')/((-y)^2+x^2)=0", "1", &[]);
    let squares = w.sign("y^2+x^2#0", &[a]);
    let turned = w.sign("(-y)^2+x^2#0", &[a]);
    let rate = w.discharge(rate, &[squares, turned]);
    assert!(w.0.fact(rate).unwrap().is_free());
    let of = term("atan2(y,x)+atan2(-y,x)");
    w.refuse(Step::Conserved { of, at: Instant(0), rate, because: vec![a, squares, turned] }, "not shown");
}

#[test]
fn cases_do_not_stand_too_deep_in_each_other() {
    let mut w = Work::new(&sequent("x", 1, "x=2"));
    let case = w.suppose("x=2", Manner::AtTimes);
    let deep = |n: usize| (0..n).fold(When::Always, |when, _| when.within(case));
    w.supposed(case, deep(11));
    w.refuse(Step::Supposition { case, within: deep(12) }, "too deep");
    w.refuse(Step::Supposition { case, within: deep(90) }, "no such times");
}

/// Before what is 0 at all times anything is 0.
#[test]
fn what_leaves_out_all_is_no_proof() {
    let s = sequent("x,y", 1, "x=5");
    let mut w = Work::new(&s);
    let fact = w.zero("x=5", "(x+y)*(x-y)-x^2+y^2", &[]);
    w.refuse(Step::Conclude { fact }, "is never so");
    let fact = w.zero("x=5", "1", &[(fact, "1")]);
    w.refuse(Step::Conclude { fact }, "is never so");
}

#[test]
fn a_function_has_a_sign_on_a_stretch_of_its_argument() {
    // From, to; what follows; what follows where an end belongs to it.
    let rows = [
        ("x>0", "x<pi", "sin(x)>0", "sin(x)≥0"),
        ("x>(0-1)*pi", "x<0", "sin(x)<0", "sin(x)≤0"),
        ("x>(0-1/2)*pi", "x<1/2*pi", "cos(x)>0", "cos(x)≥0"),
        ("x>1/2*pi", "x<3/2*pi", "cos(x)<0", "cos(x)≤0"),
        ("x>0", "x<1/2*pi", "tan(x)>0", "tan(x)≥0"),
        ("x>1", "0=0", "ln(x)>0", "ln(x)≥0"),
        ("x<1", "0=0", "ln(x)<0", "ln(x)≤0"),
        ("x>0", "0=0", "exp(x)-1>0", "exp(x)-1≥0"),
        ("x>y", "0=0", "exp(x)-exp(y)>0", "arctan(x)-arctan(y)≥0"),
    ];
    for (low, high, inside, within) in rows {
        let closed = |text: &str| text.replace('<', "≤").replace('>', "≥");
        let s = sequent("x,y", 1, inside).premise(low).premise(high).premise(&closed(low)).premise(&closed(high));
        let mut w = Work::new(&s);
        let of: Vec<FactId> = (0..4).map(|at| w.premise(at)).collect();
        w.sign(inside, &of[..2]);
        w.sign(within, &of[2..]);
        // With the ends, it may be 0; with one end alone, anything.
        w.refuse(Step::Sign { says: rel(inside), from: of[2..].to_vec() }, "do not show");
        w.refuse(Step::Sign { says: rel(within), from: vec![of[1]] }, "do not show");
        if high != "0=0" {
            w.refuse(Step::Sign { says: rel(within), from: vec![of[0]] }, "do not show");
        }
        // Nor does the other sign follow.
        let other = if within.contains('≥') { within.replace('≥', "<") } else { within.replace('≤', ">") };
        w.refuse(Step::Sign { says: rel(&other), from: of.clone() }, "do not show");
    }
    // Sine and tangent do not rise throughout, a cosine is about two sides of 0, and an end may be written otherwise.
    let s = sequent("x,y", 1, "x>0").premise("x>y").premise("x>0").premise("x<3");
    let mut w = Work::new(&s);
    let of: Vec<FactId> = (0..3).map(|at| w.premise(at)).collect();
    for says in ["sin(x)-sin(y)>0", "tan(x)-tan(y)>0", "cos(x)>0", "sin(x)>0", "exp(x)-2>0", "cosh(x)-cosh(y)>0"] {
        w.refuse(Step::Sign { says: rel(says), from: of.clone() }, "do not show");
    }
}

#[test]
fn a_power_has_the_sign_of_its_base_if_its_exponent_is_odd() {
    let s = sequent("x,y", 1, "x>0").premise("x^3>0").premise("y^2>0").premise("x*y>0");
    let mut w = Work::new(&s);
    let (odd, even, product) = (w.premise(0), w.premise(1), w.premise(2));
    w.step(Step::Sign { says: rel("x>0"), from: vec![odd] });
    w.step(Step::Sign { says: rel("y#0"), from: vec![even] });
    w.refuse(Step::Sign { says: rel("y>0"), from: vec![even] }, "do not show");
    w.refuse(Step::Sign { says: rel("x>0"), from: vec![product] }, "do not show");
    w.step(Step::Sign { says: rel("x#0"), from: vec![product] });
    // A product that is not negative says nothing of its factors.
    let s = sequent("x,y", 1, "x>0").premise("x*y≥0");
    let mut w = Work::new(&s);
    let product = w.premise(0);
    w.refuse(Step::Sign { says: rel("x≥0"), from: vec![product] }, "do not show");
}
