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
