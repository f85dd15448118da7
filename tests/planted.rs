//! One random edit is planted in each of the formulas of many derivations: is it found, and is the original offered?
//!
//! The whole table takes a few minutes: `cargo test --release --test planted -- --ignored --nocapture`. Every eighth formula
//! is part of the usual run.

use std::time::{Duration, Instant};

use rederive::check::{AlteredFormula, Options, altered_formulas, check, says_the_same};
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
    /// Where the original stands among the corrections.
    rank: Option<usize>,
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
    cover: &[String],
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
    let mut chosen: Vec<usize> = holds.iter().copied().filter(|&t| cover.contains(id(t))).collect();
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
    let account = check(&mut derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{name}: {e:?}"));
    let time = start.elapsed();
    let found = account.claims.iter().find(|c| c.id == "planted")?;
    let erratum = found.variants.as_ref().and_then(|v| v.erratum.as_ref());
    let corrections = erratum.map_or(&[][..], |e| e.corrections.as_slice());
    let constant = original.claims[claim]
        .formulas
        .iter()
        .any(|f| f.kind == FormKind::FirstIntegral && f.text.trim() == planted.printed);
    let rank = corrections.iter().position(|c| says_the_same(original, claim, &planted.printed, &c.formula, constant));
    Some(Outcome {
        claim: name,
        planted: planted.clone(),
        caught: found.results.iter().any(|p| p.is_unexpected()),
        rank,
        offered: corrections.first().map(|c| c.formula.clone()),
        time,
    })
}

/// Every n-th formula of a file that holds on some motion, with one edit planted.
fn plant_all(path: &str, each: usize) -> Vec<Outcome> {
    let text = std::fs::read_to_string(path).expect(path);
    let source = Source { path: path.into(), text: text.clone() };
    let original = parse(source, "planted").unwrap_or_else(|e| panic!("{}", render(&e, false)));
    let mut run = original.clone();
    let account = check(&mut run, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{path}: {e:?}"));
    let mut out = Vec::new();
    let mut number = 0;
    let mut seen: Vec<String> = Vec::new();
    for (c, claim) in original.claims.iter().enumerate() {
        if !claim.expect.contains(&Some("holds")) {
            continue;
        }
        let cover = account.claims[c].variants.as_ref().map(|v| v.cover.clone()).unwrap_or_default();
        let mut all = altered_formulas(&original, c);
        // An inequality with one edit is often as true as before.
        all.retain(|a| !["<", ">", r"\le ", r"\le1", r"\ge", r"\ne"].iter().any(|sign| a.formula.contains(sign)));
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
                if let Some(outcome) = plant(path, &text, &original, c, planted, &cover) {
                    out.push(outcome);
                    break;
                }
            }
        }
    }
    out
}

fn row(name: &str, all: &[&Outcome]) -> String {
    let caught = all.iter().filter(|o| o.caught).count();
    let first = all.iter().filter(|o| o.rank == Some(0)).count();
    let some = all.iter().filter(|o| o.rank.is_some()).count();
    let total: Duration = all.iter().map(|o| o.time).sum();
    let longest = all.iter().map(|o| o.time).max().unwrap_or_default();
    let mean = total / all.len().max(1) as u32;
    format!(
        "| {name} | {} | {caught} | {first} | {some} | {} ms | {} ms |",
        all.len(),
        mean.as_millis(),
        longest.as_millis()
    )
}

fn report(each: usize) -> Vec<Outcome> {
    let mut all = Vec::new();
    println!("| file | formulas | caught | original offered first | original offered | mean time | longest |");
    println!("|---|---|---|---|---|---|---|");
    for path in FILES {
        let found = plant_all(path, each);
        println!("{}", row(path, &found.iter().collect::<Vec<_>>()));
        all.extend(found);
    }
    println!("{}", row("all", &all.iter().collect::<Vec<_>>()));
    for o in all.iter().filter(|o| !o.caught || o.rank != Some(0)) {
        let state = if o.caught { "caught" } else { "NOT CAUGHT" };
        println!(
            "{state} {} [{}] rank {:?} {} ms\n  print   {}\n  planted {}\n  offered {:?}",
            o.claim,
            o.planted.class.word(),
            o.rank,
            o.time.as_millis(),
            o.planted.printed,
            o.planted.formula,
            o.offered
        );
    }
    all
}

#[test]
fn planted_edits_are_found_and_undone() {
    let all = report(8);
    let share = |count: usize| count as f64 / all.len() as f64;
    assert!(all.len() >= 20, "{} formulas", all.len());
    // What is not caught holds on the motions of the Comment, too: m is constant and along z.
    assert!(share(all.iter().filter(|o| o.caught).count()) >= 0.85);
    assert!(share(all.iter().filter(|o| o.rank == Some(0)).count()) >= 0.7);
}

#[test]
#[ignore = "takes a few minutes: the table of docs/discrimination.md"]
fn the_whole_table() {
    let all = report(1);
    assert!(all.len() >= 200, "{} formulas", all.len());
}
