//! Every derivation file reaches exactly the verdicts that it states.
//!
//! The files are those of `derivations/`, which a user sees, and those of `tests/corpus/`, which exercise every form of
//! claim, every verdict and every kind of motion, and try to trick the program. `undecided` never stands for `holds`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use crate::checked::{anew, checked};
use rederive::check::{Account, CheckError, IdentityAccount, Options, Outcome, PairAccount, Rigor, check};
use rederive::derivation::{FormKind, load};
use rederive::diag::render;

/// Verdicts of `tests/corpus/` that are wrong in this version: file, claim, trajectory, the wrong verdict, the reason.
///
/// The files state the truth. A verdict that has become right must leave this list; a new wrong one fails the test.
const KNOWN_WRONG: &[(&str, &str, &str, &str, &str)] = &[];

/// Claims that are wrongly proved in this version: none that is known.
const KNOWN_CONTRADICTIONS: &[&str] = &[];

/// What is known to be wrong, or weaker than stated, in files that state strengths, too: file, claim, trajectory, and what is
/// found instead, such as `holds sampled`. Lines of `tests/corpus/known_wrong.txt`; `-` stands for a claim over ranges.
///
/// `REDERIVE_CORPUS_WRITE=1` writes the list anew.
fn listed() -> BTreeMap<String, String> {
    let text = std::fs::read_to_string(root().join("tests/corpus/known_wrong.txt")).unwrap_or_default();
    let lines = text.lines().filter(|l| !l.starts_with('#')).filter_map(|l| l.split_once(": "));
    lines.map(|(at, found)| (at.to_owned(), found.to_owned())).collect()
}

/// Files whose claims state how strong a verdict must be at least, and whose wrong verdicts are in the list of [`listed`].
fn states_strengths(file: &str) -> bool {
    file.starts_with("semantics")
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All `.toml` files below a folder, in the order of their names.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    for path in entries.map(|e| e.expect("an entry can be read").path()) {
        if path.is_dir() {
            found.extend(files_below(&path));
        } else if path.extension().is_some_and(|e| e == "toml") {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn stem(path: &Path) -> String {
    path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default()
}

/// What differs between the verdicts of a file and its expectations, one line for each pair.
fn differences(file: &str, account: &Account, known: &[(&str, &str, &str, &str, &str)]) -> Vec<String> {
    let mut found = Vec::new();
    for claim in &account.claims {
        let name = claim.reading.as_ref().map_or(claim.id.clone(), |r| format!("{}/{r}", claim.id));
        for judged in claim.verdicts().filter(|j| j.trajectory.is_none()) {
            let word = judged.verdict.outcome().word();
            if judged.expected != Some(word) {
                let reason = &judged.verdict.evidence().reason;
                found.push(format!("{file}: {name}: expected {:?}, found {word}\n    {reason:?}", judged.expected));
            }
        }
        for pair in &claim.results {
            let word = pair.verdict.outcome().word();
            let at = format!("{file}: {name} on {}", pair.trajectory);
            let wrong = known.iter().find(|(f, c, t, ..)| *f == file && *c == name && *t == pair.trajectory);
            let evidence = pair.verdict.evidence();
            match (pair.expected, wrong) {
                (None, _) => found.push(format!("{at}: no verdict is expected, found {word}")),
                (Some(e), None) if e != word && pair.is_unexpected() => {
                    found.push(format!("{at}: expected {e}, found {word}\n    {:?}", evidence.reason));
                }
                (Some(e), Some(_)) if e == word => {
                    found.push(format!("{at}: {word} is right now: take it out of KNOWN_WRONG"));
                }
                (Some(_), Some((.., listed, _))) if *listed != word => {
                    found.push(format!("{at}: known to be wrong as {listed}, found {word}"));
                }
                _ => {}
            }
        }
    }
    found
}

/// Verdicts rest on what they must carry.
fn incomplete(file: &str, account: &Account) -> Vec<String> {
    let mut found = Vec::new();
    for claim in &account.claims {
        for pair in &claim.results {
            let evidence = pair.verdict.evidence();
            let complete = match pair.verdict.outcome() {
                Outcome::Holds(_) => evidence.samples > 0 && evidence.witness.is_none(),
                Outcome::Fails(_) => evidence.witness.is_some(),
                Outcome::NotApplicable(_) | Outcome::Undecided => {
                    evidence.reason.as_ref().is_some_and(|r| !r.to_string().is_empty()) && evidence.witness.is_none()
                }
            };
            if !complete {
                found.push(format!("{file}: {} on {}: {:?}", claim.id, pair.trajectory, pair.verdict));
            }
        }
    }
    found
}

/// Whether the claims that a claim is said to follow from hold on a trajectory; systems and symbols have no verdicts.
fn given(account: &Account, from: &[String], trajectory: &str) -> bool {
    from.iter().all(|name| {
        let (id, reading) = name.split_once('/').map_or((name.as_str(), None), |(id, r)| (id, Some(r)));
        let premise =
            account.claims.iter().find(|c| c.id == id && (reading.is_none() || c.reading.as_deref() == reading));
        premise.is_none_or(|c| {
            let holds = |p: &PairAccount| matches!(p.verdict.outcome(), Outcome::Holds(_));
            c.results.iter().any(|p| p.trajectory == trajectory && holds(p))
        })
    })
}

/// Claims that are proved, and fail on an integrated motion where their premises hold: one of the two is wrong.
fn contradictions(file: &str, account: &Account) -> Vec<String> {
    let integrated = |id: &str| account.trajectories.iter().any(|t| t.id == id && t.source == "integrated");
    // A proof that presupposes what the premises assume says nothing of motions on which that is not so.
    let everywhere = |i: &IdentityAccount| i.verdict() == "proved" && i.presupposed.is_empty();
    let proved = account.claims.iter().filter(|c| c.identity.as_ref().is_some_and(everywhere));
    let refuted = proved.filter(|c| {
        let from = c.identity.as_ref().map_or(&[][..], |i| &i.from);
        let fails = |p: &PairAccount| {
            let possible = integrated(&p.trajectory) && given(account, from, &p.trajectory);
            matches!(p.verdict.outcome(), Outcome::Fails(_)) && possible
        };
        c.results.iter().any(fails)
    });
    refuted
        .map(|c| format!("{file}: {}", c.reading.as_ref().map_or(c.id.clone(), |r| format!("{}/{r}", c.id))))
        .collect()
}

fn decided(account: &Account) -> usize {
    let summary = account.summary();
    summary.holds + summary.fails
}

#[track_caller]
fn assert_none(found: &[String]) {
    assert!(found.is_empty(), "{} differences\n{}", found.len(), found.join("\n"));
}

#[test]
fn derivations_reach_the_verdicts_that_they_state() {
    let files = files_below(&root().join("derivations"));
    assert!(files.len() >= 3, "{files:?}");
    let mut found = Vec::new();
    for path in &files {
        // What a file expects it expects of `rederive check`, which asks for every time.
        let derivation = load(path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
        let options = Options { rigor: Rigor::Enclosed, plain: true, ..Options::default() };
        let account = &check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
        let file = stem(path);
        assert!(decided(account) > 0, "{file}: nothing was decided");
        found.extend(differences(&file, account, &[]));
        found.extend(incomplete(&file, account));
        found.extend(contradictions(&file, account));
    }
    assert_none(&found);
}

#[test]
fn the_corpus_reaches_the_verdicts_that_it_states() {
    let files = files_below(&root().join("tests/corpus"));
    let mut found = Vec::new();
    let (mut forms, mut verdicts, mut sources) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    let mut contradicted = BTreeSet::new();
    for path in files.iter().filter(|p| !states_strengths(&stem(p))) {
        let (derivation, account) = &*checked(path);
        let file = stem(path);
        // Samples decide nothing of limits.
        assert!(decided(account) > 0 || file == "limits", "{file}: nothing was decided");
        found.extend(differences(&file, account, KNOWN_WRONG));
        found.extend(incomplete(&file, account));
        contradicted.extend(contradictions(&file, account));
        forms.extend(derivation.claims.iter().flat_map(|c| &c.forms).map(|f| f.kind()));
        verdicts.extend(account.claims.iter().flat_map(|c| &c.results).map(|p| p.verdict.outcome().word()));
        sources.extend(account.trajectories.iter().map(|t| t.source));
    }
    assert_none(&found);
    assert_eq!(contradicted, KNOWN_CONTRADICTIONS.iter().map(|&c| c.to_owned()).collect());
    // The corpus is worth its name: every form, every verdict and every source of motions occurs.
    let every = [
        FormKind::Always,
        FormKind::Never,
        FormKind::Eventually,
        FormKind::FirstIntegral,
        FormKind::Defined,
        FormKind::Solves,
        FormKind::SameMotion,
        FormKind::Independent,
        FormKind::Exists,
    ];
    assert!(every.iter().all(|f| forms.contains(f)), "{forms:?}");
    assert_eq!(verdicts.len(), 4, "{verdicts:?}");
    assert_eq!(sources.len(), 3, "{sources:?}");
}

/// How much a strength is worth; `certified` is what an enclosure is called where it refutes.
fn rank(strength: &str) -> usize {
    match strength {
        "proved" => 3,
        "enclosed" | "certified" => 2,
        "sampled" => 1,
        _ => 0,
    }
}

#[test]
fn meanings_reach_the_verdicts_and_strengths_that_they_state() {
    let mut found = BTreeMap::new();
    let mut tried = 0;
    for path in files_below(&root().join("tests/corpus")).iter().filter(|p| states_strengths(&stem(p))) {
        let file = stem(path);
        let derivation = load(path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
        let options = Options { plain: true, rigor: Rigor::Enclosed, ..Options::default() };
        let account = match check(&derivation, &options, &|_, _| {}) {
            Ok(account) => account,
            Err(CheckError::Defect(words)) => {
                found.insert(format!("{file} all"), format!("a defect, {words}"));
                continue;
            }
            Err(CheckError::Problems(problems)) => panic!("{}", render(&problems, false)),
        };
        for (claim, given) in account.claims.iter().zip(&derivation.claims) {
            let stated = given.remark.as_deref().and_then(|r| r.strip_prefix("strength: ")).unwrap_or("");
            for judged in claim.verdicts() {
                let outcome = judged.verdict.outcome();
                let (word, strength) = (outcome.word(), outcome.strength().unwrap_or(""));
                tried += 1;
                assert!(judged.expected.is_some(), "{file} {}: no verdict is expected", claim.id);
                if judged.expected != Some(word) || rank(strength) < rank(stated) {
                    let at = format!("{file} {} {}", claim.id, judged.trajectory.unwrap_or("-"));
                    found.insert(at, format!("{word} {strength}").trim().to_owned());
                }
            }
        }
    }
    assert!(tried > 100, "{tried}");
    if std::env::var_os("REDERIVE_CORPUS_WRITE").is_some() {
        let mut text =
            "# What the corpus states otherwise, or stronger: file, claim, trajectory: what is found.\n".to_owned();
        text.extend(found.iter().map(|(at, said)| format!("{at}: {said}\n")));
        std::fs::write(root().join("tests/corpus/known_wrong.txt"), text).expect("the list can be written");
    }
    let listed = listed();
    let new: Vec<_> = found.iter().filter(|(at, said)| listed.get(*at) != Some(said)).collect();
    let right: Vec<_> = listed.iter().filter(|(at, _)| !found.contains_key(*at)).collect();
    assert!(new.is_empty(), "not as stated, and not listed: {new:#?}");
    assert!(right.is_empty(), "right now, or gone: take it out of tests/corpus/known_wrong.txt: {right:#?}");
}

#[test]
fn known_wrong_verdicts_are_verdicts_of_the_corpus() {
    for (file, claim, trajectory, _, _) in KNOWN_WRONG {
        let path = root().join(format!("tests/corpus/{file}.toml"));
        let derivation = load(&path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
        let tried = derivation.claims.iter().any(|c| {
            let name = |&t: &usize| derivation.trajectories[t].id == *trajectory;
            c.name() == *claim && c.trajectories.iter().any(name)
        });
        assert!(tried, "{file}: {claim} is not tried on {trajectory}");
    }
}

#[test]
fn a_difference_is_noticed() {
    let (_, mut account) = anew(&root().join("tests/corpus/kinks.toml"));
    assert_eq!(differences("kinks", &account, KNOWN_WRONG), Vec::<String>::new());
    let listed = [("kinks", "no-pulse", "pulse", "undecided", "a pulse")];
    assert!(!differences("kinks", &account, &listed).is_empty(), "a verdict that is right is not known to be wrong");
    let other =
        |claim: &mut rederive::check::ClaimAccount| claim.results.iter_mut().for_each(|r| r.expected = Some("holds"));
    account.claims.iter_mut().filter(|c| c.id == "no-pulse").for_each(other);
    assert!(!differences("kinks", &account, &[]).is_empty(), "a verdict that is not expected is noticed");
}
