//! Recorded proofs: what is written is read, and a proof that was changed is refused, or proves the same.

use super::formula::*;
use crate::*;

/// A proof with many rules.
fn recorded() -> (Sequent, Vec<Step>) {
    let s =
        sequent("x,y", 1, "x^2+y^2=1").instant("0").system("x'=y").system("y'=-x").premise("x(0)=0").premise("y(0)=1");
    let mut w = Work::new(&s);
    let (a, b) = (w.given(Given::System(0)), w.given(Given::System(1)));
    let (x, y) = (w.premise(0), w.premise(1));
    let rate = w.zero("2*x*x'+2*y*y'=0", "1", &[(a, "2*x"), (b, "2*y")]);
    let end = w.step(Step::Conserved { of: term("x^2+y^2"), at: Instant(0), rate, because: vec![] });
    let end = w.zero("x^2+y^2=1", "1", &[(end, "1"), (x, "x(0)"), (y, "y(0)+1")]);
    w.step(Step::Conclude { fact: end });
    let (steps, shown) = w.0.finish().unwrap();
    assert!(shown.leaves_out().is_empty());
    (s, steps)
}

#[test]
fn a_changed_byte_is_refused_or_proves_the_same() {
    let (sequent, steps) = recorded();
    let text = serde_json::to_string(&steps).unwrap();
    let shown = replay(&sequent, &steps).unwrap();
    let (mut refused, mut same) = (0, 0);
    for at in 0..text.len() {
        for byte in *b"0127xy-\"[ " {
            let mut bytes = text.clone().into_bytes();
            if bytes[at] == byte {
                continue;
            }
            bytes[at] = byte;
            let Ok(changed) = serde_json::from_slice::<Vec<Step>>(&bytes) else {
                refused += 1;
                continue;
            };
            match replay(&sequent, &changed) {
                Err(_) => refused += 1,
                Ok(other) => {
                    assert_eq!((other.claim(), other.leaves_out()), (shown.claim(), shown.leaves_out()), "{changed:?}");
                    same += 1;
                }
            }
        }
    }
    assert!(refused > 5_000 && same < refused / 20, "{refused} {same}");
}

#[test]
fn a_proof_of_one_sequent_is_none_of_another() {
    let (sequent, steps) = recorded();
    let mut other = sequent.clone();
    other.systems[1] = rel("y'=x");
    assert!(replay(&other, &steps).is_err());
    let mut other = sequent.clone();
    other.claim = rel("x^2+y^2=2");
    assert_eq!(replay(&other, &steps).unwrap_err().step, Some(steps.len() - 1));
    for left_out in 0..steps.len() {
        let mut fewer = steps.clone();
        fewer.remove(left_out);
        assert!(replay(&sequent, &fewer).is_err(), "{left_out}");
    }
    let mut more = steps.clone();
    more.push(steps[0].clone());
    assert!(replay(&sequent, &more).unwrap_err().why.contains("ended"));
    // Sequents are recorded, too.
    let text = serde_json::to_string(&sequent).unwrap();
    assert_eq!(serde_json::from_str::<Sequent>(&text).unwrap(), sequent);
}

#[test]
fn terms_are_read_as_they_are_written() {
    let texts = [
        "-x^3+y/2",
        "atan2(x,y)^(1/3)",
        "abs(sin(2*pi*x))-sqrt(1+y^2)",
        "restrict(x,1/y)*x'(0)",
        "agm(x^2,1)+x(0)",
        "x^y",
        "(x^2)^(t+1)",
    ];
    for text in texts {
        let s = sequent("x,y", 1, "x=0").instant("0");
        let mut w = Work::new(&s);
        let e = w.0.context.read(&term(text)).unwrap();
        let graph = w.0.context.graph.clone();
        let written = Term::of(&graph, e, |symbol| Some(graph.name(symbol).to_owned())).unwrap();
        assert_eq!(w.0.context.read(&written).unwrap(), e, "{text}");
        let json = serde_json::to_string(&written).unwrap();
        assert_eq!(serde_json::from_str::<Term>(&json).unwrap(), written);
    }
    // A sum of twenty thousand terms is no depth.
    let mut nodes = vec![TermNode::Leaf { name: "x".into(), component: 0, rate: 0, at: None }];
    for i in 0..20_000 {
        nodes.push(TermNode::Apply("+".into(), vec![i, 0]));
    }
    let long = Term(nodes);
    let read: Term = serde_json::from_str(&serde_json::to_string(&long).unwrap()).unwrap();
    assert_eq!(read, long);
    let mut w = Work::new(&sequent("x", 1, "x=0"));
    w.0.context.read(&read).unwrap();
}

#[test]
fn what_a_proof_rests_on_is_told() {
    // The assumption is known always since another claim says that every time is chosen: the proof rests on it.
    let mut s = sequent("x", 1, "x'=0").selector("x>1").assuming("x=2");
    s.claims.push(Claimed { name: "above".into(), selectors: vec![], hypotheses: vec![], says: rel("x>1") });
    let mut w = Work::new(&s);
    let above = w.step(Step::Given { given: Given::Claimed(0), because: vec![] });
    w.step(Step::Everywhere { because: vec![above] });
    let a = w.given(Given::Assumed(0));
    let always = w.step(Step::Restrict { fact: a, to: When::Always, because: vec![] });
    let end = w.rate(always);
    assert_eq!(w.end(&s, end).given(), [Given::Assumed(0), Given::Claimed(0)]);
    // What was made on the way and is not used is not told.
    let s = sequent("x,y", 1, "x'=0").premise("x=2").premise("y=3");
    let mut w = Work::new(&s);
    let (a, _) = (w.premise(0), w.premise(1));
    let end = w.rate(a);
    assert_eq!(w.end(&s, end).given(), [Given::Premise(0)]);
}
