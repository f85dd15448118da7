//! Limits: what is enclosed is true, and what is decided today stays decided.

use rederive::check::{Options, Outcome, Rigor, check};
use rederive::derivation::load;
use rederive::diag::render;
use std::path::Path;

/// What the file says is true, and whether it is decided: `None` where it is not.
const LIMITS: &[(&str, Option<bool>)] = &[
    ("to-zero", Some(true)),
    ("slowly", Some(true)),
    ("slowly-elsewhere", Some(false)),
    ("wrong-value", Some(false)),
    ("right-value", Some(true)),
    ("no-limit", None),
    ("no-limit-small", None),
    ("growing", None),
    ("never-growing", None),
    ("late", Some(false)),
    ("late-zero", Some(true)),
    ("overflow", Some(false)),
    ("overflow-below", Some(true)),
    ("huge-before", Some(false)),
    ("huge-before-three", Some(true)),
    ("rational", Some(true)),
    ("rational-wrong", Some(false)),
    ("rational-mixed", None),
    ("hospital-is-silent", None),
    ("difference-of-infinities", None),
    ("at-the-cut", None),
    ("above-the-cut", Some(true)),
    ("below-the-cut", Some(false)),
    ("assumption-ends", None),
    ("assumption-stays", Some(true)),
    ("assumption-drifts", None),
    ("backwards", Some(true)),
    ("backwards-wrong", Some(false)),
    ("quotient", Some(true)),
    ("quotient-wrong", Some(false)),
    ("quotient-twice", Some(true)),
    ("quotient-with-a-sign", None),
    ("quotient-beyond", None),
    ("quotient-below-the-cut", None),
    ("quotient-nearly", None),
];

#[test]
fn limits_are_what_they_are() {
    let path = format!("{}/tests/corpus/limits.toml", env!("CARGO_MANIFEST_DIR"));
    let derivation = load(Path::new(&path)).unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let options = Options { rigor: Rigor::Enclosed, ..Options::default() };
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let mut wrong = Vec::new();
    assert_eq!(account.claims.len(), LIMITS.len());
    for claim in &account.claims {
        let Some((_, expected)) = LIMITS.iter().find(|(id, _)| *id == claim.id) else {
            panic!("{} is not listed", claim.id)
        };
        let verdict = &claim.results[0].verdict;
        let found = match verdict.outcome() {
            Outcome::Holds(_) => Some(true),
            Outcome::Fails(_) => Some(false),
            _ => None,
        };
        if found != *expected {
            wrong.push(format!(
                "{}: {expected:?} expected, {found:?} found\n    {:?}",
                claim.id,
                verdict.evidence().reason
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
