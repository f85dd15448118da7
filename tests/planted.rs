//! One random edit is planted in each of the formulas of many derivations: is it found, and is the original offered?
//!
//! The whole table takes a few minutes: `cargo test --release --test all planted -- --ignored --nocapture`. Every eighth formula
//! is part of the usual run.

use std::time::{Duration, Instant};

use crate::checked::checked;
use rederive::check::{AlteredFormula, Options, Sameness, VariantAccount, altered_formulas, check, says_the_same};
use rederive::derivation::{Derivation, FormKind, parse};
use rederive::diag::{Source, render};
use rederive::number::Draws;

/// The start of the generator that chooses the edits.
const SEED: u64 = 2023;
/// Most motions on which one planted formula is tried.
const MOST_MOTIONS: usize = 6;

const FILES: &[&str] = &[
    "derivations/deriglazov-comment.toml",
    "derivations/kepler.toml",
    "derivations/pendulum.toml",
    "tests/planted/oscillators.toml",
    "tests/planted/fields.toml",
    "tests/planted/central.toml",
    "tests/planted/constrained.toml",
];

fn read(path: &str, text: String) -> Option<Derivation> {
    parse(Source { path: path.into(), text }, "planted").ok()
}

/// What came of one planted edit.
struct Outcome {
    claim: String,
    planted: AlteredFormula,
    caught: bool,
    /// Whether the report on the original names it among the formulas that no motion rejects.
    named: bool,
    /// Where the original stands among the corrections, and the first that is the same by the definitions or given what the
    /// claim assumes.
    rank: Option<usize>,
    assumed: Option<usize>,
    offered: Option<String>,
    time: Duration,
}

/// Plants an edit in one formula and looks what is made of it.
fn plant(
    path: &str,
    text: &str,
    original: &Derivation,
    claim: usize,
    planted: &AlteredFormula,
    variants: &VariantAccount,
) -> Option<Outcome> {
    let mut altered = text.to_owned();
    altered.replace_range(planted.place.clone(), &planted.formula);
    let mut derivation = read(path, altered)?;
    let of = &mut derivation.claims[claim];
    let name = of.name();
    let holds: Vec<usize> =
        of.trajectories.iter().zip(&of.expect).filter(|(_, e)| **e == Some("holds")).map(|(t, _)| *t).collect();
    // The motions that the report on the original calls the fewest that suffice, and others, evenly.
    let id = |t: usize| &derivation.trajectories[t].id;
    let mut chosen: Vec<usize> = holds.iter().copied().filter(|&t| variants.cover.contains(id(t))).collect();
    let step = holds.len().div_ceil(MOST_MOTIONS).max(1);
    for t in holds.into_iter().step_by(step) {
        if chosen.len() < MOST_MOTIONS && !chosen.contains(&t) {
            chosen.push(t);
        }
    }
    chosen.sort_unstable();
    of.expect = vec![Some("holds"); chosen.len()];
    of.trajectories = chosen.clone();
    of.id = "planted".into();
    let trajectories = chosen.iter().map(|&t| derivation.trajectories[t].id.clone()).collect();
    let options = Options { claims: vec!["planted".into()], trajectories, ..Options::default() };
    let start = Instant::now();
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{name}: {e:?}"));
    let time = start.elapsed();
    let found = account.claims.iter().find(|c| c.id == "planted")?;
    let erratum = found.variants.as_ref().and_then(|v| v.erratum.as_ref());
    let corrections = erratum.map_or(&[][..], |e| e.corrections.as_slice());
    let constant = original.claims[claim]
        .formulas
        .iter()
        .any(|f| f.kind == FormKind::FirstIntegral && f.text.trim() == planted.printed);
    let same = |formula: &str| says_the_same(original, claim, &planted.printed, formula, constant);
    let is_survivor = |s: &&rederive::check::Survivor| s.everywhere && s.formula == planted.formula;
    Some(Outcome {
        claim: name,
        planted: planted.clone(),
        caught: found.results.iter().any(|p| p.is_unexpected()),
        named: variants.survivors.iter().any(|s| is_survivor(&s)),
        rank: corrections.iter().position(|c| same(&c.formula) == Some(Sameness::Defined)),
        assumed: corrections.iter().position(|c| same(&c.formula).is_some()),
        offered: corrections.first().map(|c| c.formula.clone()),
        time,
    })
}

/// Every n-th formula of a file that holds on some motion, with one edit planted.
fn plant_all(path: &str, each: usize) -> Vec<Outcome> {
    let text = std::fs::read_to_string(path).expect(path);
    let source = Source { path: path.into(), text: text.clone() };
    let original = parse(source, "planted").unwrap_or_else(|e| panic!("{}", render(&e, false)));
    let (_, account) = &*checked(path);
    let mut out = Vec::new();
    let mut number = 0;
    let mut seen: Vec<String> = Vec::new();
    for (c, claim) in original.claims.iter().enumerate() {
        if !claim.expect.contains(&Some("holds")) {
            continue;
        }
        let variants = account.claims[c].variants.clone().unwrap_or_default();
        let mut all = altered_formulas(&original, c);
        // An inequality with one edit is often as true as before.
        let inequality = |f: &str| {
            let after =
                |sign: &str| f.split(sign).skip(1).any(|rest| !rest.starts_with(|c: char| c.is_ascii_alphabetic()));
            f.contains(['<', '>']) || [r"\le", r"\ge", r"\ne"].iter().any(|sign| after(sign))
        };
        all.retain(|a| !inequality(&a.formula));
        let mut places: Vec<_> = all.iter().map(|a| a.place.clone()).collect();
        places.dedup();
        for place in places {
            let of: Vec<&AlteredFormula> = all.iter().filter(|a| a.place == place).collect();
            // A formula that several readings share counts once.
            if seen.contains(&of[0].printed) {
                continue;
            }
            seen.push(of[0].printed.clone());
            number += 1;
            if number % each != 0 {
                continue;
            }
            let mut draws = Draws::new(SEED + number as u64);
            // Some altered formulas would not be read in their place; then another is drawn.
            for _ in 0..5 {
                let planted = of[draws.below(of.len() as u64) as usize];
                if let Some(outcome) = plant(path, &text, &original, c, planted, &variants) {
                    out.push(outcome);
                    break;
                }
            }
        }
    }
    out
}

/// What is counted, for a row of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Counts {
    formulas: usize,
    caught: usize,
    named: usize,
    first: usize,
    first_assumed: usize,
    offered: usize,
}

impl Counts {
    fn of(all: &[Outcome]) -> Counts {
        let count = |is: &dyn Fn(&Outcome) -> bool| all.iter().filter(|o| is(o)).count();
        Counts {
            formulas: all.len(),
            caught: count(&|o| o.caught),
            named: count(&|o| !o.caught && o.named),
            first: count(&|o| o.rank == Some(0)),
            first_assumed: count(&|o| o.rank != Some(0) && o.assumed == Some(0)),
            offered: count(&|o| o.assumed.is_some()),
        }
    }

    fn row(&self, name: &str) -> String {
        let Counts { formulas, caught, named, first, first_assumed, offered } = self;
        format!("| {name} | {formulas} | {caught} | {named} | {first} | {first_assumed} | {offered} |")
    }
}

const HEAD: &str = "| file | formulas | caught | not caught, but named | original first | the same as it, given what is \
                    assumed, first | original offered |\n|---|---|---|---|---|---|---|";

/// The rows of the table, and everything behind them.
fn report(each: usize) -> (Vec<String>, Vec<Outcome>) {
    let mut all: Vec<Outcome> = Vec::new();
    let mut rows = Vec::new();
    println!("{HEAD}");
    for path in FILES {
        let found = plant_all(path, each);
        rows.push(Counts::of(&found).row(path));
        println!("{}", rows[rows.len() - 1]);
        for o in found.iter().filter(|o| !o.caught || o.rank != Some(0)) {
            let state = match (o.caught, o.named) {
                (true, _) => "caught",
                (false, true) => "NAMED",
                (false, false) => "NOT CAUGHT",
            };
            println!(
                "{state} {} [{}] rank {:?}, as assumed {:?}, {} ms\n  print   {}\n  planted {}\n  offered {:?}",
                o.claim,
                o.planted.class.word(),
                o.rank,
                o.assumed,
                o.time.as_millis(),
                o.planted.printed,
                o.planted.formula,
                o.offered
            );
        }
        all.extend(found);
    }
    rows.push(Counts::of(&all).row("all"));
    println!("{}", rows[rows.len() - 1]);
    let total: Duration = all.iter().map(|o| o.time).sum();
    let longest = all.iter().map(|o| o.time).max().unwrap_or_default();
    let mean = total / all.len().max(1) as u32;
    println!("mean {} ms, longest {} ms", mean.as_millis(), longest.as_millis());
    (rows, all)
}

#[test]
fn planted_edits_are_found_and_undone() {
    let (_, all) = report(8);
    let counts = Counts::of(&all);
    let share = |count: usize| count as f64 / all.len() as f64;
    assert!(all.len() >= 20, "{} formulas", all.len());
    // What is not caught holds on the motions of the Comment, too.
    assert!(share(counts.caught) >= 0.85, "{counts:?}");
    assert_eq!(counts.caught + counts.named, counts.formulas, "a planted edit was neither caught nor named");
    assert!(counts.first as f64 >= 0.8 * counts.caught as f64, "{counts:?}");
}

#[test]
#[ignore = "takes a few minutes: the table of docs/discrimination.md"]
fn the_whole_table() {
    let (rows, all) = report(1);
    assert!(all.len() >= 200, "{} formulas", all.len());
    let page = std::fs::read_to_string("docs/discrimination.md").expect("the page");
    for row in rows {
        assert!(page.contains(&row), "docs/discrimination.md has another row than\n{row}");
    }
}
