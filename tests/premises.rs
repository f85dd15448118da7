//! What a claim follows from, and what its proof lends to verdicts.

use crate::checked::said_by_prover;
use std::path::Path;

use rederive::check::{Account, Options, Outcome, check};
use rederive::derivation::{load, parse};
use rederive::diag::{Source, render};

fn account() -> Account {
    account_of("premises")
}

fn account_of(file: &str) -> Account {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/corpus/{file}.toml"));
    let derivation = load(&path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {});
    account.unwrap_or_else(|e| panic!("{e:?}"))
}

/// The verdict on a claim as a step, and the strengths on its motions.
fn found(account: &Account, id: &str, reading: Option<&str>) -> (&'static str, Vec<&'static str>) {
    let claim = account.claims.iter().find(|c| c.id == id && c.reading.as_deref() == reading);
    let claim = claim.unwrap_or_else(|| panic!("no claim {id}"));
    let strength = |o: Outcome| o.strength().unwrap_or("none");
    let strengths = claim.results.iter().map(|p| strength(p.verdict.outcome())).collect();
    (claim.identity.as_ref().map_or("none", |i| i.verdict()), strengths)
}

#[test]
fn a_name_without_a_reading_means_the_first_and_lends_what_that_one_has() {
    let account = account();
    assert_eq!(found(&account, "sum", Some("kept")), ("proved", vec!["proved", "proved"]));
    assert_eq!(found(&account, "sum", Some("one")).1, ["sampled", "sampled"]);
    // A step from what is only sampled is proved as a step, and stays sampled on every motion; that it fails where its
    // premise fails is no counterexample.
    assert_eq!(found(&account, "from-the-first", None), ("proved", vec!["sampled", "sampled"]));
    assert_eq!(found(&account, "lent", None), ("proved", vec!["sampled"]));
}

#[test]
fn a_reading_can_be_named() {
    let account = account();
    assert_eq!(found(&account, "from-the-second", None), ("proved", vec!["proved", "proved"]));
    assert_eq!(found(&account, "not-from-the-second", None), ("refuted", vec!["sampled", "sampled"]));
}

#[test]
fn a_definition_is_given_on_every_motion() {
    assert_eq!(found(&account(), "by-definition", None), ("proved", vec!["proved", "proved"]));
}

#[test]
fn a_motion_refutes_no_step_whose_premise_it_meets_at_some_times_only() {
    assert_ne!(found(&account(), "from-the-right-half", None).0, "refuted");
    assert_ne!(found(&account(), "from-the-turns", None).0, "proved");
}

#[test]
fn claims_on_motions_by_formulas_are_proved_at_once() {
    let account = account_of("formulas");
    let mut count = 0;
    for claim in &account.claims {
        for pair in &claim.results {
            let outcome = pair.verdict.outcome();
            if claim.id == "from-a-false-hypothesis" {
                assert!(matches!(outcome, Outcome::NotApplicable(_)), "{outcome:?}");
                continue;
            }
            assert_eq!(outcome.strength(), Some("proved"), "{}: {:?}", claim.id, pair.verdict.evidence().reason);
            assert_eq!(pair.expected, Some(outcome.word()), "{}", claim.id);
            count += 1;
        }
    }
    assert_eq!(count, 12);
}

#[test]
fn what_decays_is_proved_in_closed_form_and_nothing_beside_it() {
    let account = account_of("decay");
    for id in ["law", "law-later", "approach"] {
        assert_eq!(found(&account, id, None), ("proved", vec!["proved"]), "{id}");
    }
    for id in ["law-too-fast", "law-too-large", "approach-wrong"] {
        let (verdict, strengths) = found(&account, id, None);
        assert_eq!((verdict, strengths), ("refuted", vec!["sampled"]), "{id}");
    }
}

/// A file with a motion x = t and its claims.
fn of_claims(claims: &str) -> Account {
    let head = "'x' = { role = 'state' }\n'y' = { role = 'state' }\n'a' = { role = 'parameter' }\n'b' = { role = 'parameter' }\n\
        [system.s]\nstates = ['x', 'y']\nequations = ['\\dot x=y', '\\dot y=-x']\n[[trajectory]]\nid = 'm'\nsystem = 's'\n\
        parameters = { 'a' = 2, 'b' = 1 }\ninitial = { 'x' = 0, 'y' = 0 }\nspan = [0, 1]\n";
    of_file(&format!("{head}{claims}"))
}

/// A claim with its formula, and what stands beside it.
fn claim(id: &str, always: &str, more: &str) -> String {
    format!("[[claim]]\nid = '{id}'\nsays = 'test'\nalways = ['{always}']\n{more}\n")
}

pub fn standing(account: &Account, id: &str) -> &'static str {
    let claim = account.claims.iter().find(|c| c.id == id).unwrap_or_else(|| panic!("no claim {id}"));
    claim.identity.as_ref().map_or("none", said_by_prover)
}

#[test]
fn what_premises_assume_must_be_assumed_or_stays_open() {
    let named =
        |of: &str| format!("symbols = {{ 'h' = {{ role = 'abbreviation', formula = '{of}' }} }}\nassuming = ['h=1']\n");
    let account = of_claims(
        &[
            claim("p", r"ax=x", "assuming = ['a=1']\nfollows-from = ['s']"),
            claim("q", r"ax+b=x+b", "follows-from = ['p']"),
            claim("two-steps", r"abx=bx", "follows-from = ['q']"),
            claim("assumed-again", r"abx=bx", "assuming = ['a=1']\nfollows-from = ['q']"),
            claim("conclusion", r"a=1", "assuming = ['x>0', 'b>0']\nfollows-from = ['q']"),
            // The same words of another symbol are another assumption.
            claim("named", r"ax=x", &format!("{}follows-from = ['s']", named("a"))),
            claim("named-otherwise", r"ax=x", &format!("{}follows-from = ['named']", named("b"))),
        ]
        .concat(),
    );
    assert_eq!(standing(&account, "p"), "proved");
    assert_eq!(standing(&account, "q"), "proved given");
    assert_eq!(standing(&account, "two-steps"), "proved given");
    assert_eq!(standing(&account, "assumed-again"), "proved");
    assert_eq!(standing(&account, "conclusion"), "proved given");
    assert_eq!(standing(&account, "named"), "proved");
    assert_eq!(standing(&account, "named-otherwise"), "proved given");
    let of = |id: &str| account.claims.iter().find(|c| c.id == id).and_then(|c| c.identity.clone()).expect("a step");
    assert_eq!(of("two-steps").presupposed, ["a=1"]);
    assert!(of("assumed-again").presupposed.is_empty());
    assert!(of("q").decided().to_string().contains("`a=1`, which is assumed by what is given, and not here"));
}

#[test]
fn systems_are_given_also_where_nothing_names_a_rate() {
    let account = of_claims(
        &[
            claim("at-rest", r"y=0", "assuming = ['x=0']"),
            claim("root", r"y=0", "assuming = ['x^2=a^2']"),
            claim("product", r"x=0", "assuming = ['xy=0']\nfollows-from = ['s']"),
            claim("nothing-of-it", r"y=0", "assuming = ['a=0']"),
        ]
        .concat(),
    );
    assert_eq!(standing(&account, "at-rest"), "proved");
    for id in ["root", "product"] {
        assert_ne!(standing(&account, id), "refuted", "{id}");
    }
    assert_eq!(standing(&account, "nothing-of-it"), "refuted");
}

#[test]
fn a_sign_that_an_assumption_shares_is_not_lost() {
    let shared = r"follows-from = ['p']";
    let account = of_claims(
        &[
            claim("p", r"y=\pm b", "assuming = ['x=\\pm a']"),
            claim("again", r"y=\pm b", &format!("assuming = ['x=\\pm a']\n{shared}")),
            claim("ratio", r"xb=ay", &format!("assuming = ['x=\\pm a']\n{shared}")),
        ]
        .concat(),
    );
    for id in ["again", "ratio"] {
        assert_ne!(standing(&account, id), "refuted", "{id}");
    }
}

#[test]
fn what_a_motion_does_not_know_says_nothing() {
    let text = claim("c", "x=0", "").replace("always = ['x=0']", r"defined = ['\sqrt c', 'x']");
    let symbol = "symbols = { 'c' = { role = 'parameter', positive = true } }\n";
    let account = of_claims(&format!("{text}{symbol}"));
    let claim = &account.claims[0];
    assert!(matches!(claim.results[0].verdict.outcome(), Outcome::NotApplicable(_)), "{:?}", claim.results[0].verdict);
    assert_ne!(standing(&account, "c"), "refuted");
}

#[test]
fn an_inequality_chooses_times_and_says_nothing_of_others() {
    let given = "follows-from = ['p']\nassuming = ['x>0']";
    let account = of_claims(
        &[
            claim("p", r"\sqrt{x^2}=x", "assuming = ['x>0']\nfollows-from = ['s']"),
            claim("now", r"\sqrt{x^2}=x", given),
            claim("then", r"\sqrt{x(1)^2}=x(1)", given),
            claim("then-by-itself", r"\sqrt{x(1)^2}=x(1)", "assuming = ['x>0']"),
            claim("hypothesis", r"y(1)=\sqrt{x(1)^2}", "assuming = ['x>0', 'y=\\sqrt{x^2}']"),
            claim("of-all-times", r"y(1)=\sqrt{x(1)^2}", "assuming = ['a>0', 'y=\\sqrt{x^2}']"),
            // No system is given, so that what is so for a while need not go on.
            claim("goes-on", r"y(1)=2x(1)", "assuming = ['x>0', 'y=2x']"),
        ]
        .concat(),
    );
    for id in ["now", "of-all-times"] {
        assert_eq!(standing(&account, id), "proved", "{id}");
    }
    for id in ["then", "then-by-itself", "hypothesis", "goes-on"] {
        assert_ne!(standing(&account, id), "proved", "{id}");
    }
}

/// What is found of a file with these symbols, systems, motions and claims.
pub fn of_file(text: &str) -> Account {
    let head = "[derivation]\ntitle = 't'\nconcerns = 'test'\n[symbols]\n't' = { role = 'time' }\n";
    let source = Source { path: "test.toml".into(), text: format!("{head}{text}") };
    let derivation = parse(source, "test").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

const TWO_STATES: &str = "'x' = { role = 'state' }\n'y' = { role = 'state' }\n";

#[test]
fn a_proof_does_not_pass_times_that_an_inequality_leaves_out() {
    // x = t − 1: y moves while x is negative.
    let kinked = format!("{TWO_STATES}[system.s]\nstates = ['x', 'y']\nequations = ['\\dot x=1', '\\dot y=|x|-x']\n");
    let given = |id: &str, always: &str, assuming: &str, from: &str| {
        claim(id, always, &format!("assuming = [{assuming}]\nfollows-from = [{from}]\ntrajectories = []"))
    };
    let account = of_file(
        &[
            kinked,
            given("rate", r"\dot y=0", "'x>0'", "'s'"),
            given("joined", "y=y(0)", "'x>0'", "'s'"),
            given("by-a-claim", "y=y(0)", "'x>0'", "'rate'"),
            given("not-strict", "y=y(0)", r"'x\ge0'", "'s'"),
            given("supposed", "y(0)=1", "'x>0', 'y=1'", "'s'"),
            given("supposed-alone", "y(0)=1", "'x>0', 'y=1'", ""),
            given("throughout", "x=x(0)+t-t(0)", "'x>0'", "'s'").replace("t-t(0)", "t"),
            "[[claim]]\nid = 'integral'\nsays = 'test'\nfirst-integral = ['y']\nassuming = ['x>0']\n\
                follows-from = ['s']\ntrajectories = []\n"
                .to_owned(),
        ]
        .concat(),
    );
    assert_eq!(standing(&account, "rate"), "proved");
    for id in ["joined", "by-a-claim", "not-strict", "supposed", "supposed-alone", "integral"] {
        assert!(["undecided", "refuted"].contains(&standing(&account, id)), "{id}");
    }
    assert_eq!(standing(&account, "by-a-claim"), "refuted", "x = t and y = 0 behind it");
    // What needs no assumption is proved as before.
    assert_eq!(standing(&account, "throughout"), "proved");
    // A motion that is analytic is what it is for a while.
    let smooth = format!("{TWO_STATES}[system.s]\nstates = ['x', 'y']\nequations = ['\\dot x=1', '\\dot y=x^2-y']\n");
    let account = of_file(&[smooth, given("supposed", "y(0)=1", "'x>0', 'y=1'", "'s'")].concat());
    assert_ne!(standing(&account, "supposed"), "refuted");
}

#[test]
fn first_integrals_say_nothing_where_they_have_no_value() {
    let drag = "'x' = { role = 'state' }\n'v' = { role = 'state' }\n'k' = { role = 'parameter', positive = true }\n\
        [system.air]\nstates = ['x', 'v']\nequations = ['\\dot x=v', '\\dot v=-k|v|v']\n";
    let account = of_file(
        &[
            drag.to_owned(),
            "[[claim]]\nid = 'log'\nsays = 'test'\nfirst-integral = ['\\ln v+kx']\nfollows-from = ['air']\n".to_owned(),
            "[[claim]]\nid = 'nowhere'\nsays = 'test'\nfirst-integral = ['x+\\ln(-1-x^2)']\nfollows-from = ['air']\n"
                .to_owned(),
            "[[claim]]\nid = 'premise'\nsays = 'test'\nfirst-integral = ['x+0\\cdot\\ln v']\nfollows-from = []\n"
                .to_owned(),
            claim("beyond", r"\dot x=0", "follows-from = ['premise']"),
        ]
        .concat(),
    );
    for id in ["log", "nowhere"] {
        assert_ne!(standing(&account, id), "refuted", "{id}");
    }
    let beyond = account.claims.iter().find(|c| c.id == "beyond").and_then(|c| c.identity.clone()).expect("a step");
    assert!(!beyond.is_proved() || !beyond.conditions.is_empty(), "{beyond:?}");
}

#[test]
fn claims_on_families_and_computed_motions_obey_their_systems() {
    let head = "'x' = { role = 'state' }\n'v' = { role = 'state' }\n'c' = { role = 'parameter' }\n\
        [system.s]\nstates = ['x', 'v']\nequations = ['\\dot x=v', '\\dot v=-c^2x']\n\
        [system.r]\nstates = ['x', 'v']\nequations = ['\\dot x=v', '\\dot v=-c^2x']\n\
        [[trajectory]]\nid = 'o'\nsystem = 's'\nparameters = { 'c' = 1 }\ninitial = { 'x' = 1, 'v' = 0 }\nspan = [0, 1]\n\
        [[trajectory]]\nid = 'p'\nsystem = 'r'\nparameters = { 'c' = 1 }\ninitial = { 'x' = 1, 'v' = 0 }\nspan = [0, 1]\n\
        [[trajectory]]\nid = 'q'\nfrom = 'o'\nmap = { 'x' = '-x', 'v' = '-v' }\n\
        [[family]]\nid = 'f'\nof = 'o'\nvary = { 'c' = { from = 1, to = 2, count = 3 } }\n";
    let account = of_file(
        &[
            head.to_owned(),
            claim("members", r"\ddot x=-c^2x", "trajectories = []\nfamilies = ['f']"),
            claim("two", r"\dot x=v", "trajectories = ['o', 'p']"),
            claim("computed", r"\dot x=v", "trajectories = ['q']"),
            claim("neither", "x=v", "trajectories = ['o']"),
        ]
        .concat(),
    );
    assert_eq!(standing(&account, "members"), "proved");
    for id in ["two", "computed"] {
        assert_ne!(standing(&account, id), "refuted", "{id}");
    }
    assert_eq!(standing(&account, "neither"), "refuted");
}

#[test]
fn a_claim_that_is_tried_on_nothing_has_the_verdict_of_its_step() {
    let motion = "'q' = { role = 'state' }\n'g' = { role = 'parameter', positive = true }\n\
        'h' = { role = 'parameter', positive = true }\n'T' = { role = 'parameter', positive = true }\n\
        [system.fall]\nstates = ['q']\nequations = ['\\ddot q=-g']\n\
        [[trajectory]]\nid = 'm'\nsystem = 'fall'\nparameters = { 'g' = 10 }\n\
        initial = { 'q' = 0, '\\dot q' = 0 }\nspan = [0, 1]\n\
        [[claim]]\nid = 'energy'\nsays = 'test'\nfirst-integral = ['\\frac12\\dot q^2+gq']\n";
    let step = |id: &str, always: &str, expect: &str| {
        claim(id, always, &format!("assuming = ['h=\\frac12gT^2']\ntrajectories = []\n{expect}"))
    };
    let unexpected =
        |claims: &[String]| of_file(&[&[motion.to_owned()], claims].concat().concat()).summary().unexpected;
    let right = r"T=\sqrt{\frac{2h}g}";
    let wrong = r"T=\sqrt{\frac hg}";
    assert_eq!(unexpected(&[step("a", right, "")]), 0);
    assert_eq!(unexpected(&[step("a", right, "expect = 'holds'")]), 0);
    assert_eq!(unexpected(&[step("a", right, "expect = 'fails'")]), 1);
    assert_eq!(unexpected(&[step("a", wrong, "")]), 1);
    assert_eq!(unexpected(&[step("a", wrong, "expect = 'holds'")]), 1);
    assert_eq!(unexpected(&[step("a", wrong, "expect = 'fails'")]), 0);
    // What says so is a postulate; what follows from nothing, and of which nothing follows, is none.
    assert_eq!(unexpected(&[claim("law", "h=gT^2", "trajectories = []\npostulate = true")]), 0);
    assert_eq!(unexpected(&[claim("law", "h=gT^2", "trajectories = []")]), 1);
    assert_eq!(unexpected(&[claim("law", "h=gT^2", "trajectories = []\nexpect = 'holds'")]), 1);
}

#[test]
fn of_motions_of_several_systems_the_line_to_add_is_named() {
    let text = r"
[derivation]
title = 'Thrown, and at rest'
concerns = 'Any textbook'
[symbols]
't' = { role = 'time' }
'g' = { role = 'parameter', positive = true }
'z' = { role = 'state' }
'w' = { role = 'state' }
[system.fall]
states = ['z', 'w']
equations = ['\dot z=w, \quad \dot w=-g']
[system.rest]
states = ['z', 'w']
equations = ['\dot z=0, \quad \dot w=0']
[[trajectory]]
id = 'up'
system = 'fall'
parameters = { 'g' = 9.81 }
initial = { 'z' = 0.7, 'w' = 5.3 }
span = [0, 1]
[[trajectory]]
id = 'still'
system = 'rest'
parameters = { 'g' = 9.81 }
initial = { 'z' = 0, 'w' = 0 }
span = [0, 1]
[[claim]]
id = 'law'
says = 'The law'
always = ['\dot z=w']
";
    let decided = |more: &str| {
        let source = Source { path: "two.toml".into(), text: format!("{text}{more}") };
        let derivation = parse(source, "two").unwrap_or_else(|found| panic!("{}", render(&found, false)));
        let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
        account.claims[0].identity.as_ref().expect("it was asked").decided().to_string()
    };
    let said = decided("");
    for part in ["`fall` and `rest`", "follows-from = [\"fall\"]", "trajectories = […]"] {
        assert!(said.contains(part), "{said}");
    }
    assert!(decided("follows-from = ['fall']\n").starts_with("An identity"));
}
