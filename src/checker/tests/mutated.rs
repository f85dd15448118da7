//! Recorded proofs in which something is changed: no fact is made that a motion refutes.
//!
//! A proof is written as a tree of JSON; a number becomes another one, a name the name of something else in the proof, an element of a list
//! is left out or comes twice. What can be read is replayed, refused steps are left out, and every fact is tried on a motion that satisfies the sequent.

use super::attack::{Scene, TIMES, scenes};
use super::formula::*;
use crate::*;
use number::Draws;
use serde_json::Value;

/// True proofs of scenes, by their positions.
fn proofs() -> Vec<(usize, Vec<Step>)> {
    let all = scenes();
    let work = |at: usize| Work::new(&all[at].sequent);
    let mut out = Vec::new();
    // The angle: on intervals, up to the leap.
    let mut w = work(0);
    let a = w.given(Given::Assumed(0));
    w.step(Step::Open { because: vec![] });
    let open = w.zero("N=1", "t", &[(a, "1")]);
    let [zero_t, other] = ["t=0", "t#0"].map(|says| w.suppose(says, Manner::OnIntervals));
    let still = w.supposed(zero_t, When::ChosenOpen);
    let moves = w.rate(still);
    let left = w.sign("N=1", &[moves]);
    let not_zero = w.supposed(other, When::ChosenOpen);
    let right = w.discharge(open, &[not_zero]);
    let split = Split::Order(term("t"), term("0"));
    w.step(Step::Close { within: When::ChosenOpen, split, branches: vec![left, right], because: vec![] });
    out.push((0, w.0.steps().to_vec()));
    // A start in a case.
    let mut w = work(1);
    let (a, b) = (w.premise(0), w.premise(1));
    let case = w.suppose("x(0)#0", Manner::AtTimes);
    let not_zero = w.supposed(case, When::Always);
    let start = w.zero("x(0)=1", "x(0)", &[(a, "1")]);
    let rate = w.zero("x'=0", "x(0)", &[(b, "1")]);
    let start = w.discharge(start, &[not_zero]);
    let rate = w.discharge(rate, &[not_zero]);
    let x = w.step(Step::Conserved { of: term("x"), at: Instant(0), rate, because: vec![] });
    w.step(inserted("x=1", &[x, start]));
    out.push((1, w.0.steps().to_vec()));
    // What is assumed at chosen times, and one of them.
    let mut w = work(3);
    w.step(Step::Open { because: vec![] });
    let (a, system) = (w.given(Given::Assumed(0)), w.given(Given::System(0)));
    w.rate(a);
    w.step(inserted("x'*z=2", &[system, a]));
    let case = w.suppose("x(2)>1", Manner::AtTimes);
    let chosen = w.supposed(case, When::Always);
    w.step(Step::Restrict { fact: chosen, to: When::Always.within(case), because: vec![] });
    out.push((3, w.0.steps().to_vec()));
    // The division at one time.
    let mut w = work(7);
    let (a, b) = (w.premise(0), w.premise(1));
    let open = w.zero("y(0)=1", "x(0)", &[(a, "1")]);
    let [zero_x, other] = ["x=0", "x#0"].map(|says| w.suppose(says, Manner::OnIntervals));
    let still = w.supposed(zero_x, When::Always);
    let rate = w.rate(still);
    let contradiction = w.zero("1=0", "1", &[(rate, "1"), (b, "-1")]);
    let left = w.sign("y(0)=1", &[contradiction]);
    let not_zero = w.supposed(other, When::Always);
    let right = w.discharge(open, &[not_zero]);
    let split = Split::Order(term("x"), term("0"));
    w.step(Step::Close { within: When::Always, split, branches: vec![left, right], because: vec![] });
    out.push((7, w.0.steps().to_vec()));
    // Energy, its value at the start, and the solution.
    let mut w = work(8);
    let (a, b, start) = (w.given(Given::System(0)), w.given(Given::System(1)), w.premise(0));
    let rate = w.zero("2*x*x'+2*y*y'=0", "1", &[(a, "2*x"), (b, "2*y")]);
    let energy = w.step(Step::Conserved { of: term("x^2+y^2"), at: Instant(0), rate, because: vec![] });
    w.step(inserted("x^2+y^2=1+y(0)^2", &[energy, start]));
    let second = w.rate(a);
    w.step(inserted("x''=-x", &[second, b]));
    w.step(Step::Analytic { equations: vec![a, b], because: vec![] });
    out.push((8, w.0.steps().to_vec()));
    // Two functions that vanish in turn.
    let mut w = work(10);
    let (a, _) = (w.premise(0), w.premise(1));
    let [u, v] = ["u=0", "v=0"].map(|says| w.suppose(says, Manner::OnIntervals));
    let (zero_u, zero_v) = (w.supposed(u, When::Always), w.supposed(v, When::Always));
    let (rate_u, rate_v) = (w.rate(zero_u), w.rate(zero_v));
    let left = w.step(inserted("u'*v'=0", &[rate_u]));
    let right = w.step(inserted("u'*v'=0", &[rate_v]));
    w.step(Step::Close {
        within: When::Always,
        split: Split::Product(a),
        branches: vec![left, right],
        because: vec![],
    });
    out.push((10, w.0.steps().to_vec()));
    out
}

/// All places of a tree at which something can be changed, by numbers.
fn places(value: &mut Value, change: &mut dyn FnMut(&mut Value)) {
    change(value);
    match value {
        Value::Array(all) => all.iter_mut().for_each(|v| places(v, change)),
        Value::Object(all) => all.values_mut().for_each(|v| places(v, change)),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

fn mutate(value: &mut Value, words: &[String], draws: &mut Draws) {
    let mut count = 0;
    places(value, &mut |_| count += 1);
    let (at, mut now) = (draws.below(count), 0);
    places(value, &mut |v| {
        if now == at {
            match v {
                Value::Number(n) => {
                    *v = Value::from(n.as_u64().unwrap_or(0).wrapping_add(draws.below(5)).saturating_sub(2))
                }
                Value::String(text) => text.clone_from(&words[draws.below(words.len() as u64) as usize]),
                Value::Array(all) if !all.is_empty() => {
                    let i = draws.below(all.len() as u64) as usize;
                    let one = all[i].clone();
                    match draws.below(3) {
                        0 => drop(all.remove(i)),
                        1 => all.insert(i, one),
                        _ => all.swap(0, i),
                    }
                }
                Value::Array(_) | Value::Object(_) | Value::Null | Value::Bool(_) => {}
            }
        }
        now += 1;
    });
}

/// The names that stand in a proof, and some that may.
fn words(value: &mut Value) -> Vec<String> {
    let mut out: Vec<String> =
        ["0", "1", "-1", "always", "chosen", "Always", "Chosen", "ChosenOpen", "equal", "less", "not-equal"]
            .map(str::to_owned)
            .to_vec();
    places(value, &mut |v| {
        if let Value::String(text) = v {
            out.push(text.clone());
        }
    });
    out
}

fn replayed(scene: &Scene, steps: &[Step]) -> usize {
    let mut draft = Draft::new(&scene.sequent).expect("a sequent");
    let mut accepted = 0;
    for step in steps {
        let Ok(made) = draft.push(step.clone()) else { continue };
        accepted += 1;
        if let Some(t) = made.and_then(|id| scene.motion.refutes(&draft, id, &TIMES)) {
            let all: Vec<String> =
                (0..).map(FactId).take_while(|id| draft.fact(*id).is_some()).map(|id| draft.words(id)).collect();
            panic!("false at {t}: {step:?}\n{}", all.join("\n"));
        }
    }
    accepted
}

#[test]
fn no_changed_proof_proves_what_a_motion_refutes() {
    let rounds: u64 = std::env::var("CHECKER_SEEDS").ok().and_then(|n| n.parse().ok()).unwrap_or(1);
    let scenes = scenes();
    let (mut read, mut accepted) = (0, 0);
    for (at, steps) in proofs() {
        assert_eq!(replayed(&scenes[at], &steps), steps.len());
        let tree = serde_json::to_value(&steps).expect("steps can be written");
        let words = words(&mut tree.clone());
        for seed in 0..700 * rounds {
            let (mut changed, mut draws) = (tree.clone(), Draws::new(seed * 31 + at as u64));
            for _ in 0..=draws.below(3) {
                mutate(&mut changed, &words, &mut draws);
            }
            if let Ok(steps) = serde_json::from_value::<Vec<Step>>(changed) {
                read += 1;
                accepted += replayed(&scenes[at], &steps);
            }
        }
    }
    assert!(read > 1_000 && accepted > 5_000, "{read} proofs, {accepted} steps");
    println!("{read} changed proofs, {accepted} steps accepted");
}
