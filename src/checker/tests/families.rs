//! The families of wrong proofs S1–S8, as sequents: each way to the false claim ends in a refusal, or in a fact that needs what the
//! counterexample does not have.

use super::formula::*;
use crate::*;

/// ⌊x⌋, as formulas are read.
const FLOOR: &str = "x-1/2+atan2(sin(2*pi*x),-cos(2*pi*x))/(2*pi)";

fn always() -> When {
    When::Always
}

fn case(within: When, split: Split, branches: &[FactId], because: &[FactId]) -> Step {
    Step::Close { within, split, branches: branches.to_vec(), because: because.to_vec() }
}

#[test]
fn s1_a_leap_in_a_definition() {
    // x = 2 − t²: ⌊x⌋ is 1 but for t = 0, and tN = t always.
    let s = sequent("x", 1, "N=1").define("N", FLOOR).premise("t*N=t");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let open = w.zero("N=1", "t", &[(a, "1")]);
    assert!(w.0.needs(open).contains(&rel("t#0")));
    // t ≡ 0 on an interval is a contradiction, and so N = 1 where t ≠ 0, in the limit everywhere: but N leaps.
    let [zero_t, other] = ["t=0", "t#0"].map(|says| w.suppose(says, Manner::OnIntervals));
    let still = w.supposed(zero_t, always());
    let moves = w.rate(still);
    let left = w.sign("N=1", &[moves]);
    let not_zero = w.supposed(other, always());
    let right = w.discharge(open, &[not_zero]);
    let split = Split::Order(term("t"), term("0"));
    let end = w.step(case(always(), split, &[left, right], &[]));
    let needs = w.0.needs(end);
    // Among them |sin 2πx| + |cos 2πx| + cos 2πx ≠ 0, which is not so at whole x; and what is always so.
    assert_eq!(needs.len(), 2, "{}", w.all());
    assert!(needs.contains(&w.read("abs(sin(2*pi*x))+(abs(cos(2*pi*x))-cos(2*pi*x))#0")), "{}", w.all());
    let shown = w.end(&s, end);
    assert_eq!(shown.leaves_out(), needs);
}

#[test]
fn s2_a_start_without_a_value() {
    // x = −t²: x(0)² = x(0), x(0)ẋ = 0, and atan2(0, x) = π but for t = 0.
    let s = sequent("x", 1, "atan2(0,x)=0").instant("0").premise("x(0)^2=x(0)").premise("x(0)*x'=0");
    let mut w = Work::new(&s);
    let (a, b) = (w.premise(0), w.premise(1));
    let start = w.zero("x(0)=1", "x(0)", &[(a, "1")]);
    assert_eq!(w.0.needs(start), [rel("x(0)#0")]);
    let rate = w.zero("x'=0", "x(0)", &[(b, "1")]);
    let conserve = |rate, because| Step::Conserved { of: term("x"), at: Instant(0), rate, because };
    // With an open need, the start is none.
    w.refuse(conserve(rate, vec![]), "needs something");
    // The claim needs x² ≠ 0 at present, not x(0) ≠ 0.
    let present = w.step(Step::ClaimHasValue { need: 0, within: always() });
    w.refuse(Step::Restrict { fact: present, to: When::At(Instant(0)), because: vec![] }, "not known to be one");
    let still = w.discharge(rate, &[present]);
    assert!(!w.0.fact(still).unwrap().is_free());
    w.refuse(conserve(still, vec![present]), "not known at all times");
    // In the case x(0) ≠ 0, all goes well; in the other one nothing is known of x.
    let [not_zero, zero_x] = ["x(0)#0", "x(0)=0"].map(|says| w.suppose(says, Manner::AtTimes));
    let start_value = w.supposed(not_zero, always());
    let free = w.discharge(rate, &[start_value]);
    let x = w.step(conserve(free, vec![]));
    assert!(w.0.fact(x).unwrap().when().is_in_case());
    let nothing = w.supposed(zero_x, always());
    w.refuse(case(always(), Split::Order(term("x(0)"), term("0")), &[x, nothing], &[]), "differ");
    w.refuse(Step::Conclude { fact: x }, "not known");
    w.refuse(zero("atan2(0,x)=0", "1", &[(nothing, "1")]), "no identity");
}

#[test]
fn s3_premises_that_no_motion_satisfies() {
    let s = sequent("x", 1, "x=5").premise("x=5+t").premise("x=5");
    let mut w = Work::new(&s);
    let a = w.premise(1);
    w.refuse(
        Step::Model { values: vec![("x".to_owned(), 0, term("5"))], at: "0".to_owned() },
        "not true on the motion",
    );
    w.refuse(
        Step::Model { values: vec![("x".to_owned(), 0, term("5+t"))], at: "0".to_owned() },
        "not true on the motion",
    );
    // It follows, of no motion: the proof says that it has no model.
    assert!(!w.end(&s, a).model());
}

#[test]
fn s4_a_single_chosen_time() {
    // y = 1 − t², z = 0: y ≥ 1 chooses t = 0, where tz = t.
    let s = sequent("y,z", 1, "z=1").selector("y≥1").assuming("t*z=t");
    let mut w = Work::new(&s);
    w.refuse(Step::Open { because: vec![] }, "single times");
    w.refuse(Step::Everywhere { because: vec![] }, "not shown");
    let a = w.given(Given::Assumed(0));
    w.refuse(Step::Rate { fact: a }, "single times");
    w.refuse(Step::Restrict { fact: a, to: always(), because: vec![] }, "not times");
    w.refuse(Step::Restrict { fact: a, to: When::ChosenOpen, because: vec![] }, "not times");
    let open = w.zero("z=1", "t", &[(a, "1")]);
    let [zero_t, other] = ["t=0", "t#0"].map(|says| w.suppose(says, Manner::AtTimes));
    let still = w.supposed(zero_t, When::Chosen);
    w.refuse(Step::Rate { fact: still }, "single times");
    let not_zero = w.supposed(other, When::Chosen);
    let right = w.discharge(open, &[not_zero]);
    w.refuse(Step::Sign { says: rel("z=1"), from: vec![still] }, "do not show");
    w.refuse(case(When::Chosen, Split::Order(term("t"), term("0")), &[right], &[]), "left out");
    let [zero_t, other] = ["t=0", "t#0"].map(|says| w.suppose(says, Manner::OnIntervals));
    let still = w.supposed(zero_t, When::Chosen);
    let moves = w.rate(still);
    let left = w.sign("z=1", &[moves]);
    let not_zero = w.supposed(other, When::Chosen);
    let right = w.discharge(open, &[not_zero]);
    w.refuse(case(When::Chosen, Split::Order(term("t"), term("0")), &[left, right], &[]), "open set");
    assert_eq!(w.end(&s, open).leaves_out(), [rel("t#0")]);
    // At a time that has a value in single places: √(−t²) chooses one.
    let s = sequent("y,z", 1, "z=1").assuming("t*z=t+sqrt(y)");
    let mut w = Work::new(&s);
    w.refuse(Step::Open { because: vec![] }, "not shown");
}

#[test]
fn s5_what_is_assumed_at_chosen_times_at_others() {
    // x = t, z = 2 + (|1−t|+1−t)³.
    let s = sequent("x,z", 2, "z'(0)=0").instant("0").selector("x>1").assuming("z=2");
    let mut w = Work::new(&s);
    w.step(Step::Open { because: vec![] });
    let a = w.given(Given::Assumed(0));
    let rate = w.rate(a);
    let at = |fact, because: &[FactId]| Step::Restrict { fact, to: When::At(Instant(0)), because: because.to_vec() };
    w.refuse(at(rate, &[]), "not shown");
    let chosen = w.given(Given::Selector(0));
    w.refuse(at(rate, &[chosen]), "not known at these times");
    w.refuse(at(chosen, &[chosen]), "not known at these times");
    w.refuse(Step::Restrict { fact: rate, to: always(), because: vec![] }, "not times");
    w.refuse(Step::Everywhere { because: vec![chosen] }, "not known");
    w.refuse(Step::Conserved { of: term("z'"), at: Instant(0), rate, because: vec![] }, "not known at all times");
    w.refuse(Step::Continue { fact: rate, because: vec![] }, "analytic");
    w.refuse(Step::Conclude { fact: rate }, "not the claim");
    // With another claim in the place of the assumption.
    let mut s = sequent("x,z", 2, "z'(0)=0").instant("0").selector("x>1");
    let claim =
        Claimed { name: "premise".to_owned(), selectors: vec![rel("x>1")], hypotheses: vec![], says: rel("z=2") };
    s.claims.push(claim);
    let mut w = Work::new(&s);
    w.refuse(Step::Given { given: Given::Claimed(0), because: vec![] }, "not known to be true");
    let chosen = w.given(Given::Selector(0));
    let a = w.step(Step::Given { given: Given::Claimed(0), because: vec![chosen] });
    assert_eq!(w.0.fact(a).unwrap().when(), &When::Chosen);
    w.refuse(at(a, &[]), "not shown");
}

#[test]
fn s5c_with_a_system_of_kinks() {
    // w = t − 1, z = w|w|/2: ż(0) = 1, w(0) = −1.
    let s = sequent("z,w", 1, "z'(0)=w(0)").instant("0").system("z'=abs(w)").system("w'=1");
    let s = s.selector("w>0").assuming("z=w^2/2");
    let mut w = Work::new(&s);
    w.step(Step::Open { because: vec![] });
    let equations = vec![w.given(Given::System(0)), w.given(Given::System(1))];
    let chosen = w.given(Given::Selector(0));
    w.refuse(Step::Analytic { equations: equations.clone(), because: vec![] }, "not shown");
    w.refuse(Step::Analytic { equations: equations.clone(), because: vec![chosen] }, "not known");
    w.step(Step::Analytic { equations: vec![equations[1]], because: vec![] });
    let a = w.given(Given::Assumed(0));
    w.refuse(Step::Continue { fact: a, because: vec![] }, "analytic");
    w.refuse(Step::Smooth { fact: equations[0], because: vec![] }, "not shown");
}

#[test]
fn s6_flat_functions() {
    // y = e^{−1/t} for t > 0, 0 before: y ≤ 0 chooses t ≤ 0, at which yẏ = yẏ(1).
    let s = sequent("y", 1, "y'=y'(1)").instant("1").selector("y≤0").assuming("y*y'=y*y'(1)");
    let mut w = Work::new(&s);
    w.refuse(Step::Open { because: vec![] }, "single times");
    let a = w.given(Given::Assumed(0));
    let open = w.zero("y'=y'(1)", "y", &[(a, "1")]);
    assert_eq!(w.0.needs(open), [rel("y#0")]);
    let zero_y = w.suppose("y=0", Manner::OnIntervals);
    let still = w.supposed(zero_y, When::Chosen);
    let rate = w.rate(still);
    w.refuse(zero("y'=y'(1)", "1", &[(rate, "1")]), "no identity");
    w.refuse(Step::Restrict { fact: rate, to: When::At(Instant(1)), because: vec![] }, "no such fixed time");
    w.refuse(Step::Restrict { fact: rate, to: When::At(Instant(0)), because: vec![] }, "not known to be one");
}

#[test]
fn s7_the_rate_of_a_root() {
    // x = y = 0, w = t: rw = r, ẇ = 1.
    let s = sequent("x,y,w", 1, "w'=0").define("r", "sqrt(x^2+y^2)").premise("r*w=r");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    let rate = w.rate(a);
    assert!(!w.0.needs(rate).is_empty());
    let one = w.zero("w=1", "r", &[(a, "1")]);
    let end = w.rate(one);
    let r = Relation::clone(&w.0.needs(end)[0]);
    w.refuse(Step::Sign { says: r, from: vec![] }, "do not show");
    w.refuse(Step::ClaimHasValue { need: 0, within: always() }, "no such need");
    // On intervals on which r ≡ 0, nothing is known of w.
    let zero_r = w.suppose("r=0", Manner::OnIntervals);
    let still = w.supposed(zero_r, always());
    w.refuse(zero("w'=0", "1", &[(still, "1")]), "no identity");
    assert!(!w.end(&s, end).leaves_out().is_empty());
    // The rate of r, in the claim, does not make r ≠ 0: where r = 0 for a while, it has the rate 0.
    let s = sequent("x,y,w", 1, "r'*w=r'").define("r", "sqrt(x^2+y^2)").premise("r*w=r");
    let mut w = Work::new(&s);
    w.refuse(Step::ClaimHasValue { need: 0, within: always() }, "no such need");
}

#[test]
fn s8_a_division_at_one_time() {
    // x = t, y = 5.
    let s = sequent("x,y", 1, "y(0)=1").instant("0").premise("x(0)*y(0)=x(0)").premise("x'=1");
    let mut w = Work::new(&s);
    let (a, b) = (w.premise(0), w.premise(1));
    let open = w.zero("y(0)=1", "x(0)", &[(a, "1")]);
    assert_eq!(w.0.needs(open), [rel("x(0)#0")]);
    // The case x(0) = 0 does not contradict ẋ = 1, on intervals neither.
    for manner in [Manner::AtTimes, Manner::OnIntervals] {
        let zero_x = w.suppose("x(0)=0", manner);
        let other = w.suppose("x(0)#0", manner);
        let still = w.supposed(zero_x, always());
        let rate = w.rate(still);
        assert_eq!(w.0.says(rate).unwrap(), rel("0=0"));
        w.refuse(Step::Sign { says: rel("y(0)=1"), from: vec![rate, b] }, "do not show");
        let not_zero = w.supposed(other, always());
        let right = w.discharge(open, &[not_zero]);
        let split = Split::Order(term("x(0)"), term("0"));
        w.refuse(case(always(), split, &[right], &[]), "left out");
    }
    // x = 0 on intervals is another case than x(0) = 0.
    let zero_x = w.suppose("x=0", Manner::OnIntervals);
    let other = w.suppose("x#0", Manner::OnIntervals);
    let still = w.supposed(zero_x, always());
    let rate = w.rate(still);
    let contradiction = w.zero("1=0", "1", &[(rate, "1"), (b, "-1")]);
    let left = w.sign("y(0)=1", &[contradiction]);
    let not_zero = w.supposed(other, always());
    let right = w.discharge(open, &[not_zero]);
    assert!(!w.0.fact(right).unwrap().is_free());
    let end = w.step(case(always(), Split::Order(term("x"), term("0")), &[left, right], &[]));
    assert_eq!(w.0.needs(end), [rel("x(0)#0")]);
    assert_eq!(w.end(&s, open).leaves_out(), [rel("x(0)#0")]);
}

#[test]
fn the_mean_at_its_edge() {
    // agm(−y²,1) has values where y = 0 only.
    let s = sequent("y", 1, "y'=0").premise("agm(-y^2,1)+1>0");
    let mut w = Work::new(&s);
    let a = w.premise(0);
    assert!(!w.0.fact(a).unwrap().is_free());
    w.refuse(Step::Rate { fact: a }, "no equation");
    // A system would have values at all times: then y ≡ 0.
    let s = sequent("y", 1, "y'=0").system("agm(-y^2,1)=0*y");
    let mut w = Work::new(&s);
    let need = w.step(Step::HasValue { given: Given::System(0), need: 0 });
    let at_least = w.sign("0≤y^2", &[]);
    let zero = w.sign("y^2=0", &[need, at_least]);
    let root = w.suppose("y=0", Manner::AtTimes);
    let y = w.supposed(root, always());
    let y = w.step(case(always(), Split::Product(zero), &[y], &[]));
    let end = w.rate(y);
    assert!(w.end(&s, end).leaves_out().is_empty());
}
