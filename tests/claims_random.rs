//! Random claims over combinations of forms: no verdict contradicts their truth, which is computed elsewhere, exactly.
//!
//! `tests/claims/truth.rs` is written from `docs/semantics.md` and shares no code with the program. `undecided` and a refusal
//! are never wrong. What is known to be wrong is listed in `tests/claims/known_wrong.txt`.
//!
//! `REDERIVE_CLAIMS=20000` tries as many claims; `REDERIVE_CLAIMS_SEED` draws others; `REDERIVE_CLAIMS_WRITE=1` writes the
//! list of what is known to be wrong anew.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::claims::claim::Claim;
use crate::claims::draw::{Chance, FORMS, Profile, SIZES, claim, profile, usual_profile};
use crate::claims::judge::{Said, key, minimized, number_of, said};
use crate::claims::logic::Truth;
use crate::claims::truth::truth;

const CLAIMS: usize = 400;
const SEED: u64 = 20_260_707;

struct Drawn {
    profile: Profile,
    claim: Claim,
    truth: Vec<Truth>,
}

/// Two dimensions, each with a value of it.
type Pair = (usize, usize, usize, usize);

/// All pairs of values that occur together.
fn pairs(profile: &Profile) -> Vec<Pair> {
    let n = profile.len();
    (0..n).flat_map(|i| (i + 1..n).map(move |k| (i, profile[i], k, profile[k]))).collect()
}

/// All triples of values that occur together, by their dimensions.
fn triples(profile: &Profile) -> Vec<[(usize, usize); 3]> {
    let n = profile.len();
    let at = |i: usize| (i, profile[i]);
    let rest = move |i: usize| (i + 1..n).flat_map(move |k| (k + 1..n).map(move |m| [i, k, m]));
    (0..n).flat_map(rest).map(|[i, k, m]| [at(i), at(k), at(m)]).collect()
}

/// Claims whose profiles cover the pairs that can occur, as far as the number reaches, then chance.
fn draws(n: usize, seed: u64) -> (Vec<Drawn>, BTreeSet<Pair>) {
    let mut chance = Chance::new(seed);
    let mut covered = BTreeSet::new();
    let mut found = Vec::new();
    while found.len() < n {
        // The one of several profiles that covers most.
        let mut candidates = Vec::new();
        let cover = found.len() < CLAIMS / 2;
        for _ in 0..if cover { 12 } else { 1 } {
            let p = if cover { profile(&mut chance) } else { usual_profile(&mut chance) };
            let drawn = claim(&p, &mut chance);
            if let Some((claim, truth)) = drawn.and_then(|c| truth(&c).ok().map(|t| (c, t))) {
                candidates.push(Drawn { profile: p, claim, truth });
            }
        }
        let new = |d: &Drawn| pairs(&d.profile).iter().filter(|p| !covered.contains(*p)).count();
        if let Some(best) = (0..candidates.len()).max_by_key(|&i| new(&candidates[i])) {
            let best = candidates.swap_remove(best);
            covered.extend(pairs(&best.profile));
            found.push(best);
        }
    }
    (found, covered)
}

fn known_path() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/claims/known_wrong.txt")
}

fn known() -> BTreeMap<String, String> {
    let text = std::fs::read_to_string(known_path()).unwrap_or_default();
    let lines = text.lines().filter(|l| !l.starts_with('#') && !l.trim().is_empty());
    lines
        .map(|l| l.split_once(' ').map_or((l.to_owned(), String::new()), |(k, r)| (k.to_owned(), r.to_owned())))
        .collect()
}

#[test]
fn no_random_claim_gets_a_wrong_verdict() {
    let n = usize::try_from(number_of("REDERIVE_CLAIMS", CLAIMS as u64)).expect("a number of claims");
    let seed = number_of("REDERIVE_CLAIMS_SEED", SEED);
    let (drawn, _) = draws(n, seed);
    let mut table: BTreeMap<&str, BTreeMap<String, usize>> = BTreeMap::new();
    let mut wrong = Vec::new();
    // One by one, with its text before it is tried: for a claim on which the program does not end.
    let each = std::env::var_os("REDERIVE_CLAIMS_EACH").is_some();
    for part in drawn.chunks(if each { 1 } else { 100 }) {
        if each {
            println!("trying {:?}\n{}", part[0].claim.motion, part[0].claim.toml("c"));
        }
        let claims: Vec<&Claim> = part.iter().map(|d| &d.claim).collect();
        for (d, s) in part.iter().zip(said(&claims)) {
            let row = table.entry(FORMS[d.profile[3]]).or_default();
            *row.entry(s.word().to_owned()).or_default() += 1;
            if s.is_wrong(&d.truth) {
                *row.entry("wrong".to_owned()).or_default() += 1;
                wrong.push((d, s));
            }
            if std::env::var_os("REDERIVE_CLAIMS_REFUSED").is_some()
                && let Said::Refused(words) = said(&[&d.claim]).remove(0)
            {
                println!("refused: {words}\n{}", d.claim.toml("c"));
            }
        }
    }
    for (form, row) in &table {
        println!("{form:16} {row:?}");
    }
    let triples: BTreeSet<_> = drawn.iter().flat_map(|d| triples(&d.profile)).collect();
    println!("{} of {n} claims wrong, seed {seed}; {} triples of values tried", wrong.len(), triples.len());
    let known = known();
    let keys: BTreeSet<String> = wrong.iter().map(|(d, _)| key(&d.claim)).collect();
    let drawn_keys: BTreeSet<String> = drawn.iter().map(|d| key(&d.claim)).collect();
    if std::env::var_os("REDERIVE_CLAIMS_WRITE").is_some() {
        let mut text =
            "# Random claims of which this version says what is not so: key, what it says, what is so.\n".to_owned();
        for (d, s) in &wrong {
            text += &format!("{} {} {:?} {}\n", key(&d.claim), s.word(), d.truth, FORMS[d.profile[3]]);
        }
        std::fs::write(known_path(), text).expect("the list can be written");
    }
    let new: Vec<_> = wrong.iter().filter(|(d, _)| !known.contains_key(&key(&d.claim))).collect();
    // Some of each form, made small.
    let shown = usize::try_from(number_of("REDERIVE_CLAIMS_SHOWN", 5)).expect("a number");
    let mut told: BTreeMap<&str, usize> = BTreeMap::new();
    for (d, s) in &new {
        let count = told.entry(FORMS[d.profile[3]]).or_default();
        *count += 1;
        if *count > shown {
            continue;
        }
        let (small, s2, t2) = minimized(&d.claim);
        println!("=== {} {:?} {s:?}, truth {:?}", key(&d.claim), d.profile, d.truth);
        println!("{:?} {:?} {}: {s2:?}, truth {t2:?}\n{}", small.scene, small.motion, small.span, small.toml("c"));
    }
    // Claims that are not drawn any more, and those that are right now.
    let stale: Vec<_> = known.keys().filter(|k| !drawn_keys.contains(*k) || !keys.contains(*k)).collect();
    assert!(new.is_empty(), "{} new wrong verdicts", new.len());
    assert!(stale.is_empty() || n != CLAIMS || seed != SEED, "right now, or not drawn any more: {stale:?}");
}

#[test]
fn every_pair_of_values_that_can_stand_together_is_tried() {
    let (drawn, covered) = draws(CLAIMS, SEED);
    let possible: usize =
        (0..SIZES.len()).map(|i| (i + 1..SIZES.len()).map(|k| SIZES[i] * SIZES[k]).sum::<usize>()).sum();
    println!("{} of {possible} pairs in {} claims", covered.len(), drawn.len());
    // Some cannot stand together: first integrals in boxes, ± without what could carry it.
    assert!(covered.len() * 100 > possible * 88);
}
