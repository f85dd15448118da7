//! Closed solutions of systems, claimed as steps: true ones are proved, and others, which differ by little, are not.

use crate::premises::{of_file, standing};

/// What is found of claims about the motions of a system, each with its assumptions: the standing of each.
fn standings(states: &[&str], equations: &[&str], positive: &[&str], claims: &[(&[&str], &str)]) -> Vec<&'static str> {
    let quoted = |all: &[&str]| all.iter().map(|e| format!("'{e}'")).collect::<Vec<_>>().join(", ");
    let mut text = String::new();
    states.iter().for_each(|s| text.push_str(&format!("'{s}' = {{ role = 'state' }}\n")));
    positive.iter().for_each(|p| text.push_str(&format!("'{p}' = {{ role = 'parameter', positive = true }}\n")));
    text.push_str(&format!("[system.s]\nstates = [{}]\nequations = [{}]\n", quoted(states), quoted(equations)));
    for (number, (assuming, always)) in claims.iter().enumerate() {
        text.push_str(&format!(
            "[[claim]]\nid = 'c{number}'\nsays = 'test'\nfollows-from = ['s']\ntrajectories = []\n"
        ));
        text.push_str(&format!("assuming = [{}]\nalways = ['{always}']\n", quoted(assuming)));
    }
    let account = of_file(&text.replace("assuming = []\n", ""));
    (0..claims.len()).map(|number| standing(&account, &format!("c{number}"))).collect()
}

type Claims = &'static [(&'static [&'static str], &'static str)];

#[track_caller]
fn solved(states: &[&str], equations: &[&str], positive: &[&str], followed: Claims, others: Claims) {
    for (standing, (given, claim)) in standings(states, equations, positive, followed).into_iter().zip(followed) {
        assert_eq!(standing, "proved", "{claim} given {given:?} and {equations:?}");
    }
    for (standing, (given, claim)) in standings(states, equations, positive, others).into_iter().zip(others) {
        assert!(!standing.starts_with("proved"), "{claim} given {given:?} and {equations:?}: {standing}");
    }
}

#[test]
fn motions_of_constant_acceleration() {
    solved(
        &["q"],
        &[r"\ddot q=-g"],
        &["g", "v"],
        &[
            (&[], r"q=q(0)+\dot q(0)t-\frac12gt^2"),
            (&["q(0)=0", r"\dot q(0)=v"], r"q=vt-\frac12gt^2"),
            (&[], r"\dot q=\dot q(0)-gt"),
        ],
        &[(&[], r"q=q(0)+\dot q(0)t+\frac12gt^2"), (&["q(0)=0"], r"q=vt-\frac12gt^2"), (&[], r"q=q(0)-\frac12gt^2")],
    );
}

#[test]
fn rates_of_observables_in_a_system_are_written_out() {
    let text = |rate: &str| {
        format!(
            "'r' = {{ role = 'state' }}\n'\\tau' = {{ role = 'state' }}\n'm' = {{ role = 'parameter' }}\n\
             'f' = {{ role = 'observable', formula = '1-\\frac{{2m}}{{r}}' }}\n\
             [system.s]\nstates = ['r', '\\tau']\nequations = ['\\dot r=r', '{rate}']\n\
             [[trajectory]]\nid = 'one'\nsystem = 's'\nspan = [0, 1]\nparameters = {{ 'm' = 0.1 }}\n\
             initial = {{ 'r' = 1, '\\tau' = 0, '\\dot\\tau' = 2 }}\n\
             [[claim]]\nid = 'c'\nsays = 'test'\nfollows-from = ['s']\nfirst-integral = ['f\\dot\\tau']\n"
        )
    };
    for (rate, wanted) in [
        (r"\frac{d}{dt}(f\dot\tau)=0", true),
        (r"\dot f\dot\tau+f\ddot\tau=0", true),
        (r"\dot f\dot\tau-f\ddot\tau=0", false),
    ] {
        let account = of_file(&text(rate));
        assert_eq!(standing(&account, "c") == "proved", wanted, "{rate}");
    }
}

#[test]
fn oscillations() {
    solved(
        &["q"],
        &[r"m\ddot q=-kq"],
        &["m", "k", r"\omega"],
        &[(&[r"\omega=\sqrt{\frac km}"], r"q=q(0)\cos\omega t+\frac{\dot q(0)}{\omega}\sin\omega t")],
        &[
            (&[r"\omega=\sqrt{\frac km}"], r"q=q(0)\cos\omega t"),
            (&[r"\omega=\sqrt{\frac km}"], r"q=q(0)\cos\omega t+\dot q(0)\sin\omega t"),
            (&[r"\omega=2"], r"q=q(0)\cos\omega t+\frac{\dot q(0)}{\omega}\sin\omega t"),
        ],
    );
    solved(
        &["x", "y"],
        &[r"\dot x=y", r"\dot y=-x"],
        &[],
        &[(&[], r"x=x(0)\cos t+y(0)\sin t"), (&[], r"y=y(0)\cos t-x(0)\sin t"), (&["x(0)=0", "y(0)=0"], "x=0")],
        &[(&[], r"x=x(0)\cos t-y(0)\sin t"), (&["x(0)=0"], "x=0"), (&["x(0)=0"], "x^2=0")],
    );
}

#[test]
fn growth_and_decay() {
    solved(
        &["v"],
        &[r"\dot v=g-kv^2"],
        &["g", "k"],
        &[(&["v(0)=0"], r"v=\sqrt{\frac gk}\tanh(\sqrt{gk}t)")],
        &[(&["v(0)=0"], r"v=\sqrt{\frac gk}\tanh(gkt)"), (&[], r"v=\sqrt{\frac gk}\tanh(\sqrt{gk}t)")],
    );
    let given: &[&str] = &["A(0)=N", "B(0)=0", "C(0)=0", r"a\ne b"];
    let found = standings(
        &["A", "B", "C"],
        &[r"\dot A=-aA", r"\dot B=aA-bB", r"\dot C=bB"],
        &["a", "b", "N"],
        &[
            (given, r"B=\frac{aN}{b-a}(e^{-at}-e^{-bt})"),
            (given, r"C=N(1-\frac{be^{-at}-ae^{-bt}}{b-a})"),
            (given, r"B=\frac{aN}{b-a}(e^{-at}+e^{-bt})"),
            (&given[1..], r"B=\frac{aN}{b-a}(e^{-at}-e^{-bt})"),
        ],
    );
    assert_eq!(found, ["proved", "proved", "undecided", "undecided"]);
}

#[test]
fn nothing_is_said_where_a_state_does_not_determine_the_motion() {
    // Several motions go through one state: x = 0 and x = t³; x = ct² on either side of t = 0.
    solved(&["x"], &[r"\dot x=3x^{2/3}"], &[], &[], &[(&["x(0)=0"], "x=0"), (&["x(0)=0"], "x=t^3")]);
    solved(&["x"], &[r"\dot x=2\sqrt x"], &[], &[], &[(&["x(0)=0"], "x=0"), (&["x(0)=0"], "x=t^2")]);
    solved(&["x"], &[r"t\dot x=2x"], &[], &[], &[(&["x(1)=1"], "x=t^2"), (&["x(0)=0"], "x=0")]);
    solved(&["x"], &[r"\dot x=\frac{2x}{t}"], &[], &[], &[(&["x(1)=1"], "x=t^2"), (&["x(0)=0"], "x=0")]);
    solved(&["x", "y"], &[r"\dot x=1", r"x\dot y=2y"], &[], &[], &[(&["x(0)=0", "y(0)=0"], "y=0")]);
    // The square vanishes once, and not always.
    solved(&["x"], &[r"\dot x=1"], &[], &[(&[], "x=x(0)+t")], &[(&["x(0)=0"], "x^2=0"), (&["x(0)=0"], "x=0")]);
    // What bends is another function beyond.
    solved(&["x", "y"], &[r"\dot x=1", r"\dot y=|x|"], &[], &[], &[(&["x(0)=1", "y(0)=0"], r"y=t+\frac12t^2")]);
    // y is whatever it likes.
    solved(
        &["x", "y"],
        &[r"\dot x=y", r"\dot y=-y"],
        &[],
        &[],
        &[(&["x(0)=0"], "x=0"), (&["x(0)=0", "y(0)=1"], "x=1")],
    );
}
