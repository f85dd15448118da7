//! What a search finds is a motion of the file: pasted, the claim fails on it.

use std::path::{Path, PathBuf};

use assert_cmd::Command;
use predicates::prelude::PredicateBooleanExt;
use rederive::check::search::{SearchOptions, search};
use rederive::check::{Options, Outcome, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::findings::search::SearchAccount;

const PENDULUM: &str = r"
[derivation]
title = 'A pendulum'
concerns = 'test'
[symbols]
't' = { role = 'time', unit = 's' }
'q' = { role = 'state', unit = 'rad' }
'p' = { role = 'state', unit = '1/s' }
'w' = { role = 'parameter', unit = '1/s', positive = true }
'E' = { role = 'observable', formula = '\frac12p^2-w^2\cos q' }
[system.s]
states = ['q', 'p']
equations = ['\dot q=p', '\dot p=-w^2\sin q']
[[trajectory]]
id = 'small'
system = 's'
parameters = { 'w' = 1.3 }
initial = { 'q' = 0.1, 'p' = 0 }
span = [0, 12]
[[claim]]
id = 'energy'
says = 'true'
first-integral = ['E']
[[claim]]
id = 'never-round'
says = 'it does not go over the top'
always = ['\left|q\right|<4']
[[claim]]
id = 'from-rest'
says = 'from rest it stays below the top'
assuming = ['p(0)=0']
always = ['\left|q\right|<3']
[[claim]]
id = 'listed'
says = 'the same, and names its trajectory'
always = ['\left|q\right|<4']
trajectories = ['small']
[[claim]]
id = 'two'
says = 'two readings'
[[claim.reading]]
id = 'true'
says = 'true'
always = ['\dot q=p']
[[claim.reading]]
id = 'wrong'
says = 'wrong'
always = ['\left|p\right|<w']
";

fn read(text: &str) -> Derivation {
    let source = Source { path: "test.toml".into(), text: text.into() };
    parse(source, "test").unwrap_or_else(|found| panic!("{}", render(&found, false)))
}

fn run(text: &str, claim: &str, seed: u64, tries: usize) -> SearchAccount {
    let options = SearchOptions { claim: claim.into(), seed, tries, variant: None };
    search(&read(text), &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

/// Pastes what was found and checks the claim on it.
fn fails_when_pasted(text: &str, account: &SearchAccount) {
    let found = account.found.as_ref().expect("a motion is found");
    let mut text = format!("{text}\n{}", found.table);
    if found.listed {
        text = text.replace("trajectories = ['small']", &format!("trajectories = ['small', '{}']", found.id));
    }
    let derivation = read(&text);
    let id = found.claim.split('/').next().unwrap_or_default().to_owned();
    let options = Options { claims: vec![id], trajectories: vec![found.id.clone()], ..Options::default() };
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let reading = found.claim.split('/').nth(1);
    let claim = account.claims.iter().find(|c| c.reading.as_deref() == reading).expect("the claim is tried");
    assert_eq!(claim.results.len(), 1, "{}", found.table);
    assert!(matches!(claim.results[0].verdict.outcome(), Outcome::Fails(_)), "{}", found.table);
    // Sides without a value are no numbers, which are not equal to themselves.
    assert_eq!(format!("{:?}", claim.results[0].verdict), format!("{:?}", found.verdict), "{}", found.table);
}

#[test]
fn a_wrong_claim_is_refuted_and_the_table_can_be_pasted() {
    for claim in ["never-round", "from-rest", "listed", "two/wrong", "two"] {
        fails_when_pasted(PENDULUM, &run(PENDULUM, claim, 1, 480));
    }
}

#[test]
fn a_true_claim_is_not_refuted() {
    let account = run(PENDULUM, "energy", 1, 96);
    assert!(account.found.is_none());
    assert_eq!((account.tries.fails, account.known.len()), (0, 0));
    assert!(account.tries.holds > 50, "{:?}", account.tries);
    assert!(run(PENDULUM, "two/true", 1, 48).found.is_none());
}

#[test]
fn assumptions_stay_met() {
    let account = run(PENDULUM, "from-rest", 3, 480);
    let found = account.found.as_ref().expect("found");
    assert!(found.table.contains("'p' = 0"), "{}", found.table);
}

#[test]
fn numbers_are_made_round() {
    let found = run(PENDULUM, "never-round", 2, 480).found.expect("found");
    let digits: usize = found
        .table
        .lines()
        .filter(|l| l.starts_with("parameters") || l.starts_with("initial"))
        .flat_map(|l| l.split([' ', ',']))
        .filter(|w| w.parse::<f64>().is_ok())
        .map(|w| w.chars().filter(char::is_ascii_digit).count())
        .sum();
    assert!(digits <= 7, "{}", found.table);
}

#[test]
fn the_seed_decides_and_the_threads_do_not() {
    let one = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| run(PENDULUM, "from-rest", 5, 480))
    };
    assert_eq!(one(1), one(4));
    let tables: Vec<String> =
        (0..6).filter_map(|seed| run(PENDULUM, "never-round", seed, 480).found.map(|f| f.table)).collect();
    assert!(tables.iter().any(|t| *t != tables[0]), "every seed finds the same");
}

#[test]
fn tries_are_bounded() {
    let account = run(PENDULUM, "energy", 1, 7);
    let t = account.tries;
    assert_eq!(t.holds + t.fails + t.not_applicable + t.undecided + t.impossible, 7);
    assert!(run(PENDULUM, "never-round", 1, 0).found.is_none());
}

fn comment() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations/deriglazov-comment.toml")
}

#[test]
fn a_motion_against_the_comment() {
    let text = std::fs::read_to_string(comment()).expect("the file is there");
    fails_when_pasted(&text, &run(&text, "psi0-formula/real", 1, 48));
    // What is right is not refuted, with its assumptions met on many of the tries.
    let account = run(&text, "t10", 1, 24);
    assert!(account.found.is_none(), "{:?}", account.found);
    assert!(account.tries.holds > 5, "{:?}", account.tries);
}

#[test]
fn a_motion_that_tells_an_altered_formula_from_the_claim() {
    // At rest every formula for the energy would do.
    let text = PENDULUM.replace("'q' = 0.1, 'p' = 0", "'q' = 0, 'p' = 0");
    let derivation = read(&text);
    let options = Options { claims: vec!["two".into()], ..Options::default() };
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let survivors = account.claims[0].variants.as_ref().expect("variants").survivors.clone();
    assert!(!survivors.is_empty());
    let search = |claim: &str, variant| {
        let options = SearchOptions { claim: claim.into(), seed: 1, tries: 96, variant: Some(variant) };
        search(&read(&text), &options, &|_, _| {})
    };
    for (n, survivor) in survivors.iter().enumerate() {
        let found = search("two/true", n).unwrap_or_else(|e| panic!("{e:?}"));
        assert_eq!(found.variant.as_ref(), Some(&survivor.formula));
        let table = &found.found.as_ref().expect("a motion").table;
        // On that motion the claim holds, and is no longer taken for its altered formula.
        let pasted = read(&format!("{text}\n{table}"));
        let account = check(&pasted, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
        let pair = account.claims[0].results.last().expect("the new motion");
        assert!(matches!(pair.verdict.outcome(), Outcome::Holds(_)), "{table}");
        let left = &account.claims[0].variants.as_ref().expect("variants").survivors;
        let alive = left.iter().any(|s| s.everywhere && s.formula == survivor.formula);
        assert!(!alive, "{}\n{table}", survivor.formula);
    }
    assert!(search("two/true", survivors.len()).is_err());
    assert!(search("two", 0).is_err(), "which reading is not said");
}

#[test]
fn the_command() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("test.toml");
    std::fs::write(&path, PENDULUM).expect("written");
    let run = |arguments: &[&str]| {
        Command::cargo_bin("rederive").expect("built").arg("search").args(arguments).arg(&path).assert()
    };
    let found = run(&["never-round"]).code(0);
    let table = String::from_utf8(found.get_output().stdout.clone()).expect("text");
    assert!(table.contains("[[trajectory]]") && table.contains("against-never-round-1"), "{table}");
    run(&["energy", "--tries", "24"]).code(3).stdout(predicates::str::is_empty());
    run(&["listed"]).code(0).stderr(predicates::str::contains("names its motions"));
    run(&["energy", "--variant", "999"]).code(2).stderr(predicates::str::contains("numbered from 0"));
    run(&["nothing"]).code(2).stdout(predicates::str::is_empty().and(predicates::str::is_empty()));
    // All of standard output can be appended to the file.
    std::fs::write(&path, format!("{PENDULUM}{table}")).expect("written");
    let check = |claim: &str| {
        let arguments = ["check", "--no-reports", "--claim", claim];
        Command::cargo_bin("rederive").expect("built").args(arguments).arg(&path).assert()
    };
    check("never-round").code(1);
    check("energy").code(0);
}

/// A threshold from which a factor 2 is lost: true on both motions of the file.
const LOST: &str = r"
[[trajectory]]
id = 'swings'
system = 's'
parameters = { 'w' = 1.3 }
initial = { 'q' = 0, 'p' = 1 }
span = [0, 12]
[[trajectory]]
id = 'round'
system = 's'
parameters = { 'w' = 1.3 }
initial = { 'q' = 0, 'p' = 4 }
span = [0, 12]
[[claim]]
id = 'lost'
says = 'below the threshold it does not go over the top'
assuming = ['q(0)=0', 'p(0)^2<8w^2']
always = ['\left|q\right|<\pi']
[[claim]]
id = 'right'
says = 'below the threshold it does not go over the top'
assuming = ['q(0)=0', 'p(0)^2<4w^2']
always = ['\left|q\right|<\pi']
";

fn checked(text: &str, claims: &[&str]) -> Vec<rederive::check::ClaimAccount> {
    let claims = claims.iter().map(|c| (*c).to_owned()).collect();
    let options = Options { claims, ..Options::default() };
    check(&read(text), &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}")).claims
}

/// What holds on every motion of the file is tried on others, and what is found of it changes no verdict.
#[test]
fn a_check_finds_a_motion_on_which_a_lost_factor_shows() {
    let text = format!("{PENDULUM}{LOST}");
    let claims = checked(&text, &[]);
    let of = |id: &str| claims.iter().find(|c| c.id == id).expect("a claim");
    let lost = of("lost");
    assert!(lost.results.iter().all(|p| !matches!(p.verdict.outcome(), Outcome::Fails(_))));
    let drawn = lost.drawn.as_ref().expect("drawn");
    let found = drawn.found.as_deref().expect("a motion");
    assert!(!found.changed.is_empty() && found.changed.iter().all(|c| c.now != c.then), "{found:?}");
    let account = SearchAccount {
        claim: "lost".into(),
        variant: None,
        seed: drawn.seed,
        found: Some(found.clone()),
        tries: drawn.tries,
        known: Vec::new(),
    };
    fails_when_pasted(&text, &account);
    // What is true stays true; what is proved, or fails already, is not asked.
    let right = of("right").drawn.as_ref().expect("drawn");
    assert!(right.found.is_none() && right.tries.fails == 0 && right.tries.holds > 2, "{right:?}");
    assert!(of("energy").drawn.is_none() && of("never-round").drawn.is_none());
}

/// The draws of a claim do not depend on what else is checked; where nothing but verdicts is asked, there are none.
#[test]
fn what_a_check_draws_is_the_same_every_time() {
    let text = format!("{PENDULUM}{LOST}");
    let all = checked(&text, &[]);
    let drawn = |claims: &[rederive::check::ClaimAccount]| {
        format!("{:?}", claims.iter().find(|c| c.id == "lost").and_then(|c| c.drawn.clone()).expect("drawn"))
    };
    assert!(drawn(&all) == drawn(&checked(&text, &[])), "the same twice");
    assert!(drawn(&all) == drawn(&checked(&text, &["lost"])), "the same alone");
    let plain = Options { plain: true, ..Options::default() };
    let plain = check(&read(&text), &plain, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    assert!(plain.claims.iter().all(|c| c.drawn.is_none()));
}

/// It is told on page one, in `explain`, and to machines, and the exit code is that of the verdicts.
#[test]
fn what_a_check_draws_is_told_everywhere() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("lost.toml");
    // Of the others some fail.
    let (symbols, _) = PENDULUM.split_once("[[trajectory]]").expect("motions");
    std::fs::write(&file, format!("{symbols}{LOST}")).expect("written");
    let run = |arguments: &[&str]| {
        let ran = Command::cargo_bin("rederive")
            .expect("built")
            .env("REDERIVE_CACHE", "")
            .args(arguments)
            .arg(&file)
            .output();
        let ran = ran.expect("it runs");
        assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
        String::from_utf8_lossy(&ran.stdout).into_owned()
    };
    let one_line = |text: String| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let page = one_line(run(&["check", "--no-reports"]));
    assert!(page.contains("One claim fails on a motion drawn at random: "), "{page}");
    assert!(page.contains("It fails on ") && page.contains("in place of"), "{page}");
    let told = run(&["explain", "lost"]);
    assert!(told.contains("[[trajectory]]") && told.contains("against-lost-1"), "{told}");
    for format in ["sarif", "junit", "json"] {
        let text = run(&["check", "--no-reports", "--format", format]);
        let key = match format {
            "sarif" => "verdict::drawn",
            "junit" => "drawn at random with seed 1",
            _ => "\"drawn\"",
        };
        assert!(text.contains(key), "{format}: {text}");
    }
}
