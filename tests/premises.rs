//! What a claim follows from, and what its proof lends to verdicts.

use std::path::Path;

use rederive::check::{Account, Options, Outcome, check};
use rederive::derivation::load;
use rederive::diag::render;

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
