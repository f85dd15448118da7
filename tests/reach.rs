//! How far proofs reach: identities of the families that physics uses, and a near miss for most of them.
//!
//! The lists are `tests/reach/true.txt` and `tests/reach/false.txt`. What is true is proved, what is false is refuted; lines
//! that begin with ? are open in this version. Whatever else changes, no near miss is proved and nothing true is refuted.

use crate::checked::said_by_prover;
use rederive::check::{Proposition, prove};
use rederive::derivation::Derivation;

/// One line of a list.
struct Row {
    open: bool,
    symbols: Vec<String>,
    given: Vec<String>,
    formula: String,
}

fn rows(text: &str) -> Vec<Row> {
    let lines = text.lines().filter(|l| !l.is_empty() && !l.starts_with('#'));
    let parts = |text: &str, by: &str| -> Vec<String> {
        text.split(by).map(|t| t.trim().to_owned()).filter(|t| !t.is_empty()).collect()
    };
    lines
        .map(|line| {
            let (open, line) = line.strip_prefix("? ").map_or((false, line), |rest| (true, rest));
            let mut fields = line.splitn(3, " | ");
            let mut next = || fields.next().expect("three fields");
            let (symbols, given) = (parts(next(), ", "), parts(next(), ";;"));
            Row { open, symbols, given, formula: next().to_owned() }
        })
        .collect()
}

/// The word for the answer.
fn standing(row: &Row) -> String {
    let mut derivation = Derivation::blank();
    derivation.scope.set_imaginary();
    let typed: Vec<(String, String)> = row.symbols.iter().map(|s| (s.clone(), s.clone())).collect();
    derivation.declare_typed(&typed).unwrap_or_else(|e| panic!("{}: {e:?}", row.formula));
    let proposition = Proposition { formula: row.formula.clone(), given: row.given.clone(), throughout: false };
    match prove(&mut derivation, &proposition) {
        Ok(account) => said_by_prover(&account).to_owned(),
        Err(error) => panic!("{}: {error:?}", row.formula),
    }
}

/// Lines whose answer is another than `wanted`, or for open ones is `never`.
fn wrong(text: &str, wanted: &str, never: &[&str]) -> Vec<String> {
    let mut out = Vec::new();
    for row in rows(text) {
        let word = standing(&row);
        let fits = if row.open { !never.contains(&word.as_str()) } else { word == wanted };
        if !fits {
            out.push(format!("{} given {:?}: {word} instead of {wanted}", row.formula, row.given));
        }
    }
    out
}

#[test]
fn what_is_true_is_proved() {
    let wrong = wrong(include_str!("reach/true.txt"), "proved", &["refuted"]);
    assert!(wrong.is_empty(), "{} lines:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn what_is_false_is_refuted_and_never_proved() {
    let wrong = wrong(include_str!("reach/false.txt"), "refuted", &["proved", "proved except"]);
    assert!(wrong.is_empty(), "{} lines:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn the_lists_are_long_and_mostly_decided() {
    for text in [include_str!("reach/true.txt"), include_str!("reach/false.txt")] {
        let rows = rows(text);
        let open = rows.iter().filter(|r| r.open).count();
        assert!(rows.len() > 150 && open * 8 < rows.len(), "{open} of {} are open", rows.len());
    }
}
