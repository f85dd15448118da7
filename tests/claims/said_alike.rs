//! Claims that say the same get the same verdict, and are rigorous or sampled alike.
//!
//! The rules are those of the page on meaning. How many pairs still differ is listed by rule in
//! `tests/claims/known_changes.txt`: no rule may have more. `REDERIVE_CLAIMS` and `REDERIVE_CLAIMS_SEED` draw others,
//! `REDERIVE_CLAIMS_WRITE=1` writes the list anew.

use std::collections::BTreeMap;
use std::path::Path;

use super::claim::Claim;
use super::draw::{Chance, claim, usual_profile};
use super::judge::{Said, number_of, said};
use super::metamorphic::{Kept, RULES};
use super::truth::truth;

const CLAIMS: usize = 160;
const SEED: u64 = 31;

fn known_path() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/claims/known_changes.txt")
}

/// Rule: number of pairs that differ.
fn known() -> BTreeMap<String, usize> {
    let text = std::fs::read_to_string(known_path()).unwrap_or_default();
    let lines = text.lines().filter(|l| !l.starts_with('#')).filter_map(|l| l.split_once(": "));
    lines.map(|(rule, n)| (rule.to_owned(), n.parse().unwrap_or(0))).collect()
}

fn class(s: &Said) -> &str {
    match s {
        Said::Verdict(_, strength, _) if strength == "sampled" => "sampled",
        Said::Verdict(_, strength, _) if strength.is_empty() => "",
        Said::Verdict(..) => "rigorous",
        Said::Refused(_) | Said::Defect(_) => "",
    }
}

fn differs(kept: Kept, before: &Said, after: &Said) -> bool {
    let (b, a) = (before.word(), after.word());
    if b == "refused" || a == "refused" {
        return false;
    }
    match kept {
        Kept::Same => b != a || class(before) != class(after),
        Kept::Opposite => {
            let turned = match b {
                "holds" => "fails",
                "fails" => "holds",
                b => b,
            };
            turned != a
        }
        Kept::Fails => (b == "holds" || b == "fails") && a != "fails",
        Kept::Agreement => (b == "holds" && a == "fails") || (b == "fails" && a == "holds"),
    }
}

#[test]
fn what_says_the_same_is_judged_alike() {
    let n = usize::try_from(number_of("REDERIVE_CLAIMS", CLAIMS as u64)).expect("a number of claims");
    let seed = number_of("REDERIVE_CLAIMS_SEED", SEED);
    let mut chance = Chance::new(seed);
    let mut drawn = Vec::new();
    while drawn.len() < n {
        let profile = usual_profile(&mut chance);
        drawn.extend(claim(&profile, &mut chance).filter(|c| truth(c).is_ok_and(|t| t.len() == 1)));
    }
    let mut before = Vec::new();
    for part in drawn.chunks(100) {
        before.extend(said(&part.iter().collect::<Vec<_>>()));
    }
    let mut changes: BTreeMap<&str, usize> = BTreeMap::new();
    let mut told = String::new();
    for (rule, kept, apply) in RULES {
        let pairs: Vec<(usize, Claim)> = drawn.iter().enumerate().filter_map(|(i, c)| Some((i, apply(c)?))).collect();
        assert!(n < CLAIMS || pairs.len() >= 2, "{rule}: {} pairs", pairs.len());
        let mut count = 0;
        for part in pairs.chunks(100) {
            let after = said(&part.iter().map(|(_, c)| c).collect::<Vec<_>>());
            for ((i, c), after) in part.iter().zip(after) {
                let same_truth = *kept != Kept::Agreement || truth(&drawn[*i]) == truth(c);
                if same_truth && differs(*kept, &before[*i], &after) {
                    count += 1;
                    if count <= 4 {
                        told += &format!("--- {rule}: {:?} became {after:?}\n", before[*i]);
                        told += &format!("{}\n{}\n", drawn[*i].toml("c"), c.toml("c"));
                    }
                }
            }
        }
        println!("{rule}: {count} of {} pairs differ", pairs.len());
        changes.insert(rule, count);
    }
    if std::env::var_os("REDERIVE_CLAIMS_WRITE").is_some() {
        let mut text = "# How many pairs of claims that say the same are judged differently, by rule.\n".to_owned();
        text.extend(changes.iter().map(|(rule, n)| format!("{rule}: {n}\n")));
        std::fs::write(known_path(), text).expect("the list can be written");
    }
    let known = known();
    let more = changes.iter().filter(|(rule, n)| **n > known.get(**rule).copied().unwrap_or(0)).count();
    if more > 0 {
        println!("{told}");
    }
    assert!(more == 0, "{more} rules with more pairs that differ than are listed");
}
