//! Every edge of the table of domains, crossed with every form of claim: a hole on the way, at a sample, at the start.
//!
//! The motion is x = t, so that where a formula has no value is known from the row of its operation alone. What has no value at
//! some time is not defined, whatever it is multiplied by; and a time without a value neither refutes nor confirms anything.

use rederive::check::{Options, check};
use rederive::derivation::load;
use rederive::expr::Op;
use rederive::expr::domain::row;

/// Formulas in x with a hole, or an end of their domain, at x = c: written with `@` for x − c.
fn formulas(op: Op) -> &'static [&'static str] {
    match op {
        Op::Sqrt => &[r"\sqrt{@}", r"\sqrt{(@)^2-10^{-9}}"],
        Op::Ln => &[r"\ln|@|", r"\ln(@)", r"\ln((@)^2-10^{-9})"],
        Op::Tan => &[r"\tan(@+\frac{\pi}{2})"],
        Op::Arcsin => &[r"\arcsin(1+@)", r"\arcsin(1-(@)^2+10^{-9})"],
        Op::Arccos => &[r"\arccos(1+@)", r"\arccos(1-(@)^2+10^{-9})"],
        Op::Div => &[r"\frac{1}{@}", r"\frac{@}{@}"],
        Op::Pow => &[r"(@)^{0.3}", r"((@)^2-10^{-9})^{0.3}", r"|@|^{-0.3}"],
        Op::Arctan2 => &[r"\operatorname{atan2}(@,0)", r"\operatorname{atan2}(@,2(@))"],
        Op::Agm => &[r"\operatorname{agm}(@,1)", r"\operatorname{agm}(1,(@)^2-10^{-9})"],
        Op::Powi(n) if n < 0 => &["(@)^{-1}", "(@)^{-2}", "(@)^{-3}"],
        Op::Neg
        | Op::Exp
        | Op::Sin
        | Op::Cos
        | Op::Arctan
        | Op::Sinh
        | Op::Cosh
        | Op::Tanh
        | Op::Abs
        | Op::Add
        | Op::Sub
        | Op::Mul
        | Op::Powi(_)
        | Op::DirectionCosine
        | Op::Restrict => &[],
    }
}

/// Formulas that have a value at x = c, and none before: on a span that begins there they are defined.
const CLOSED: &[&str] = &[r"\sqrt{@}", "(@)^{0.3}", r"\operatorname{agm}(@,1)"];

/// Places of the hole: at the start, in the middle, at no sample, beside the end.
const PLACES: &[&str] = &["0", "1", r"\frac{5}{7}", "1.9371"];

#[test]
fn what_has_no_value_is_not_defined_and_says_nothing() {
    let mut text = String::from(
        "[derivation]\ntitle = \"edges\"\nconcerns = \"the table of domains\"\n[symbols]\n't' = { role = \"time\" }\n\
         'x' = { role = \"state\" }\n[system.s]\nstates = ['x']\nequations = ['\\dot x=1']\n[[trajectory]]\nid = \"m\"\n\
         system = \"s\"\ninitial = { 'x' = 0 }\nspan = [0, 2]\n",
    );
    // What must not be said of a claim, by its number.
    let mut never: Vec<(String, &[&str])> = Vec::new();
    for &op in Op::ALL {
        assert_eq!(
            formulas(op).is_empty(),
            row(op).needs.is_empty(),
            "{op:?} has needs and no formula, or the other way"
        );
        for f in formulas(op) {
            for place in PLACES {
                let whole = *place == "0" && CLOSED.contains(f);
                let f = f.replace('@', &format!("x-{place}"));
                let undefined: &[&str] =
                    if whole { &["fails", "not-applicable"] } else { &["holds", "not-applicable"] };
                let rate_undefined: &[&str] = &["holds", "not-applicable"];
                let void: &[&str] = &["fails"];
                let wrong: &[&str] = &["holds"];
                let claims = [
                    (format!("defined = ['{f}']"), undefined),
                    (format!("defined = ['0\\cdot {f}']"), undefined),
                    (format!("defined = ['{f}-{f}']"), undefined),
                    (format!("defined = ['({f})^0']"), undefined),
                    (format!("defined = ['\\frac{{d}}{{dt}}{f}']"), rate_undefined),
                    (format!("always = ['0\\cdot {f}=0']"), void),
                    (format!("never = ['0\\cdot {f}=1']"), void),
                    (format!("eventually = ['0\\cdot {f}=0']"), void),
                    (format!("first-integral = ['0\\cdot {f}']"), void),
                    (format!("always = ['0\\cdot {f}=1']"), wrong),
                    (format!("never = ['0\\cdot {f}=0']"), wrong),
                    (format!("eventually = ['0\\cdot {f}=1']"), wrong),
                ];
                for (claim, forbidden) in claims {
                    // The mean has no derivative among the operations: refused.
                    if op == Op::Agm && claim.contains("{dt}") {
                        continue;
                    }
                    text.push_str(&format!("[[claim]]\nid = \"c{}\"\nsays = \"an edge\"\n{claim}\n", never.len()));
                    never.push((claim, forbidden));
                }
            }
        }
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("edges.toml");
    std::fs::write(&path, text).expect("a file");
    let derivation = load(&path).unwrap_or_else(|found| panic!("{}", rederive::diag::render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {}).expect("verdicts");
    let (mut wrong, mut settled) = (Vec::new(), 0);
    for (claim, (text, forbidden)) in account.claims.iter().zip(&never) {
        let verdict = &claim.results[0].verdict;
        let word = verdict.outcome().word();
        if forbidden.contains(&word) {
            wrong.push(format!("{text}: {word} {:?}", verdict.evidence().reason));
        }
        settled += usize::from(word != "undecided");
    }
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), never.len(), wrong.join("\n"));
    assert_eq!(account.claims.len(), never.len());
    // It is not right because it says nothing.
    assert!(2 * settled > never.len(), "{settled} of {} are settled", never.len());
}

const MOTIONS: &str = r"
[derivation]
title = 'T'
concerns = 'C'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'y' = { role = 'state' }
'a' = { role = 'parameter' }
'b' = { role = 'parameter' }
'p' = { role = 'parameter', positive = true }
[system.s]
states = ['x', 'y']
equations = ['\dot x=0', '\dot y=1']
[[trajectory]]
id = 'm'
formula = { 'x' = '0', 'y' = 't' }
parameters = { 'a' = -2, 'b' = 2, 'p' = 2 }
span = [0, 1]
[[trajectory]]
id = 'i'
system = 's'
initial = { 'x' = 0, 'y' = 0 }
parameters = { 'a' = -2, 'b' = 2, 'p' = 2 }
span = [0, 0.7]
[[trajectory]]
id = 'left'
formula = { 'x' = 't-1', 'y' = 't' }
parameters = { 'a' = -2, 'b' = 2, 'p' = 2 }
span = [0, 1]
";

/// The words of the verdicts on each claim: on its motions, or over its ranges.
fn words(claims: &[&str]) -> Vec<Vec<&'static str>> {
    let mut text = MOTIONS.to_owned();
    for (number, claim) in claims.iter().enumerate() {
        text.push_str(&format!("[[claim]]\nid = 'c{number}'\nsays = 'test'\n{claim}\n"));
    }
    let source = rederive::diag::Source { path: "t.toml".into(), text };
    let derivation = rederive::derivation::parse(source, "t")
        .unwrap_or_else(|found| panic!("{}", rederive::diag::render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    account.claims.iter().map(|c| c.verdicts().map(|j| j.verdict.outcome().word()).collect()).collect()
}

/// What is put into an exponent does not write it out: 0⁰, (−1)¹ and (−2)² have no value where the exponent is no written number.
#[test]
fn a_power_needs_at_a_single_point_what_it_needs() {
    let never: &[(&str, &[&str])] = &[
        ("ranges = { 'b' = 0, 'a' = [0, 1] }\nalways = ['b^a=0']", &["fails"]),
        ("ranges = { 'b' = -1, 'a' = [1, 3] }\nalways = ['b^a>0']", &["holds", "fails"]),
        ("ranges = { 'b' = -1, 'a' = [1, 3] }\nalways = ['b^a>-2']", &["holds", "fails"]),
        ("ranges = { 'b' = -1, 'a' = [1, 2] }\nassuming = ['b^a=1']\nalways = ['a=5']", &["holds", "fails"]),
        ("ranges = { 'a' = -2, 'b' = 2 }\nalways = ['a^b=4']", &["holds", "fails"]),
        ("ranges = { 'a' = -2, 'b' = 2 }\nalways = ['a^b=5']", &["holds", "fails"]),
        ("ranges = { 'a' = -2, 'b' = 2 }\ndefined = ['a^b']", &["holds"]),
        ("ranges = { 'a' = [-3, -2], 'b' = 2 }\ndefined = ['a^b']", &["holds"]),
        ("trajectories = ['m', 'i']\nalways = ['x^y=0']", &["fails"]),
        ("trajectories = ['m', 'i']\nnever = ['x^y=1']", &["fails"]),
        ("trajectories = ['m', 'i']\neventually = ['x^y=1']", &["holds"]),
        ("trajectories = ['m', 'i']\neventually = ['x^y>\\frac12']", &["holds"]),
        ("trajectories = ['m', 'i']\ndefined = ['x^y']", &["holds"]),
        ("trajectories = ['left']\neventually = ['x^{0\\cdot x}=1']", &["holds"]),
        ("trajectories = ['left']\neventually = ['x^{x-x}=1']", &["holds"]),
        ("trajectories = ['left']\ndefined = ['x^{x-x}']", &["holds"]),
        ("trajectories = ['m', 'i', 'left']\nalways = ['a^b=4']", &["holds", "fails"]),
        ("trajectories = ['m', 'i', 'left']\nalways = ['a^b=5']", &["holds", "fails"]),
        ("trajectories = ['m', 'i', 'left']\ndefined = ['a^b']", &["holds"]),
    ];
    let claims: Vec<&str> = never.iter().map(|(claim, _)| *claim).collect();
    for ((claim, forbidden), found) in never.iter().zip(words(&claims)) {
        assert!(found.iter().all(|word| !forbidden.contains(word)), "{claim}: {found:?}");
    }
    // What is written out is an operation of its own, and what has a value has it.
    let so = [
        "ranges = { 'a' = -2 }\nalways = ['a^2=4', 'a^{-1}=-\\frac12', 'a^{\\pm1}<0']",
        "ranges = { 'a' = 2, 'b' = 3 }\nalways = ['a^b=8']",
        "ranges = { 'b' = 0, 'a' = [1, 2] }\nalways = ['b^a=0']",
        "trajectories = ['m', 'i', 'left']\nalways = ['a^2=4', 'b^b=4', 'x^0=1']",
    ];
    for (claim, found) in so.iter().zip(words(&so)) {
        assert!(found.iter().all(|word| *word == "holds"), "{claim}: {found:?}");
    }
}

/// A condition in which no parameter occurs is asked, too.
#[test]
fn numbers_without_a_value_leave_what_positive_parameters_make_of_them_without_one() {
    let without = [
        r"\frac{p}{\sin\pi}",
        r"\frac{p}{\ln1}",
        r"p\tan\frac\pi2",
        r"\frac{p}{\sqrt2\sqrt2-2}",
        r"\frac{p}{e^{\ln2}-2}",
        r"\frac p0",
        r"\sqrt{-1}p",
        r"\ln(-1)p",
        r"p\arccos2",
    ];
    let claims: Vec<String> =
        without
            .iter()
            .flat_map(|f| ["['m']", "[]"].map(|on| format!("trajectories = {on}\ndefined = ['{f}']\nexpect = 'fails'")))
            .chain([r"\ln(-1)>0", r"\arccos2>0", r"\frac{1}{\sin\pi}>0"].map(|assumed| {
                format!("trajectories = []\nassuming = ['{assumed}']\nalways = ['p>0']\nexpect = 'holds'")
            }))
            .collect();
    let mut text = MOTIONS.to_owned();
    for (number, claim) in claims.iter().enumerate() {
        text.push_str(&format!("[[claim]]\nid = 'c{number}'\nsays = 'test'\n{claim}\n"));
    }
    let kept = r"\frac{p}{\ln2}+\sqrt{\pi-3}p+p\arccos\frac12";
    text.push_str(&format!("[[claim]]\nid = 'kept'\nsays = 'test'\ntrajectories = ['m']\ndefined = ['{kept}']\n"));
    text.push_str("[[claim]]\nid = 'zero'\nsays = 'test'\ntrajectories = ['m']\ndefined = ['(p-p)^p']\n");
    let source = rederive::diag::Source { path: "t.toml".into(), text };
    let derivation = rederive::derivation::parse(source, "t")
        .unwrap_or_else(|found| panic!("{}", rederive::diag::render(&found, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    for (claim, text) in account.claims.iter().zip(&claims) {
        let step = claim.identity.as_ref().map(|i| i.standing());
        assert!(step.is_none_or(|word| word != "proved"), "{text}: {step:?}");
        assert!(claim.results.iter().all(|r| r.verdict.outcome().word() != "holds"), "{text}: {:?}", claim.results);
        assert!(claim.verdict_alone() != Some("holds"), "{text}");
    }
    for id in ["kept", "zero"] {
        let claim = account.claims.iter().find(|c| c.id == id).expect("the claim");
        let (step, word) = (claim.identity.as_ref().map(|i| i.standing()), claim.results[0].verdict.outcome().word());
        assert!(step != Some("refuted") && word == "holds", "{id}: {step:?} {word}");
    }
}
