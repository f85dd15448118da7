//! Planted mistakes are found.
//!
//! `tests/mutants/<file>.toml` lists mistakes for `derivations/<file>.toml`: in the formulas of a claim (or of one reading
//! of it), the text `from`, which occurs there once, becomes `to`; where `from` is a whole formula with its quotes, `to` is
//! the new formula. Every mutant must fail, with a witness, on some trajectory on which the claim itself holds. A mutant
//! that fails nowhere must say why under `survives`, and a test fails when one survives without saying so, or says so and
//! does not survive.
//!
//! All mutants of a file are checked in one run: the file's symbols, systems and trajectories, and for every claim the claim
//! itself and its mutants.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use rederive::check::{Account, Options, Outcome, PairAccount, check};
use rederive::derivation::parse;
use rederive::diag::{Source, render};

/// One planted mistake.
#[derive(Debug)]
struct Mutant {
    claim: String,
    reading: Option<String>,
    from: String,
    to: String,
    survives: Option<String>,
}

impl Mutant {
    fn target(&self) -> (String, Option<String>) {
        (self.claim.clone(), self.reading.clone())
    }
}

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn mutants(file: &str) -> Vec<Mutant> {
    let table: toml::Table = read(&format!("tests/mutants/{file}.toml")).parse().expect("the list of mutants is TOML");
    let entries = table["mutant"].as_array().expect("an array of mutants");
    let text = |t: &toml::Value, key: &str| t.get(key).map(|v| v.as_str().expect("a string").to_owned());
    let known = ["claim", "reading", "from", "to", "survives"];
    let one = |t: &toml::Value| {
        let mut keys = t.as_table().expect("a table").keys();
        assert!(keys.all(|k| known.contains(&k.as_str())), "unknown key in {t}");
        let needed = |key: &str| text(t, key).unwrap_or_else(|| panic!("`{key}` is missing in {t}"));
        Mutant {
            claim: needed("claim"),
            reading: text(t, "reading"),
            from: needed("from"),
            to: needed("to"),
            survives: text(t, "survives"),
        }
    };
    entries.iter().map(one).collect()
}

/// The text of a file, cut before every line that begins a table of one of these names.
fn pieces<'a>(text: &'a str, headers: &[&str]) -> Vec<&'a str> {
    let mut cuts = vec![0];
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if headers.contains(&line.trim_end()) {
            cuts.push(at);
        }
        at += line.len();
    }
    cuts.push(text.len());
    cuts.windows(2).map(|w| &text[w[0]..w[1]]).collect()
}

/// The id that a piece of the file gives.
fn id(piece: &str) -> Option<&str> {
    piece.lines().find_map(|l| l.strip_prefix("id = \"")?.strip_suffix('"'))
}

/// Keys of a claim with their lines: `(key, text)`, lines that continue an array or a long string included.
fn entries(piece: &str) -> Vec<(&str, String)> {
    let mut found: Vec<(&str, String)> = Vec::new();
    for line in piece.split_inclusive('\n') {
        let key = line.split_once(" = ").map(|(k, _)| k).filter(|k| {
            k.starts_with(|c: char| c.is_ascii_lowercase())
                && k.chars().all(|c| c.is_ascii_lowercase() || "-.".contains(c))
        });
        match (key, found.last_mut()) {
            (Some(key), _) => found.push((key, line.to_owned())),
            (None, Some(last)) if !line.starts_with("[[") => last.1.push_str(line),
            _ => {}
        }
    }
    found
}

/// A claim, or one reading of it, as a claim of its own: without what refers to other claims and without expectations.
struct Target {
    head: Vec<(String, String)>,
    reading: Option<Vec<(String, String)>>,
}

/// Keys of a claim whose text holds its formulas.
const FORMULAS: &[&str] = &["always", "never", "eventually", "first-integral", "defined", "symbols"];

impl Target {
    fn find(text: &str, claim: &str, reading: Option<&str>) -> Target {
        let all = pieces(text, &["[[claim]]", "[[measure]]", "[[trajectory]]"]);
        let piece = all.iter().find(|p| p.starts_with("[[claim]]") && id(p) == Some(claim));
        let piece = piece.unwrap_or_else(|| panic!("there is no claim `{claim}`"));
        let parts = pieces(piece, &["[[claim.reading]]"]);
        let own = |part: &str| -> Vec<(String, String)> {
            let kept = |key: &str| key != "follows-from" && !key.starts_with("expect");
            entries(part).into_iter().filter(|(k, _)| kept(k)).map(|(k, t)| (k.to_owned(), t)).collect()
        };
        let reading = reading.map(|r| {
            let part = parts.iter().skip(1).find(|p| id(p) == Some(r));
            own(part.unwrap_or_else(|| panic!("`{claim}` has no reading `{r}`")))
        });
        assert!(reading.is_some() || parts.len() == 1, "`{claim}` has readings: name one");
        Target { head: own(parts[0]), reading }
    }

    /// The claim under a new id, after an edit of its formulas.
    fn written(&self, new_id: &str, edit: Option<(&str, &str)>) -> String {
        let mut hits = 0;
        let mut part = |part: &[(String, String)], id: &str| {
            let mut out = String::new();
            for (key, text) in part {
                match (key.as_str(), edit) {
                    ("id", _) => out.push_str(&format!("id = \"{id}\"\n")),
                    // Claims are tried alone: those that they rest on are not there.
                    ("rests-on", _) => {}
                    (key, Some((from, to))) if FORMULAS.contains(&key) => {
                        hits += text.matches(from).count();
                        out.push_str(&text.replacen(from, to, 1));
                    }
                    _ => out.push_str(text),
                }
            }
            out
        };
        let mut out = format!("[[claim]]\n{}", part(&self.head, new_id));
        if let Some(reading) = &self.reading {
            out.push_str(&format!("[[claim.reading]]\n{}", part(reading, "only")));
        }
        if let Some((from, _)) = edit {
            assert_eq!(hits, 1, "{from} occurs {hits} times in the formulas of\n{out}");
        }
        out.push('\n');
        out
    }
}

/// The results of claim `id`.
fn results<'a>(account: &'a Account, id: &str) -> &'a [PairAccount] {
    account.claims.iter().find(|c| c.id == id).map(|c| c.results.as_slice()).unwrap_or_default()
}

fn holds(pair: &PairAccount) -> bool {
    matches!(pair.verdict.outcome(), Outcome::Holds(_))
}

/// Checks all mutants of a file and says what is wrong with them.
fn run(file: &str) -> (usize, Vec<String>) {
    let text = read(&format!("derivations/{file}.toml"));
    let mutants = mutants(file);
    let before = pieces(&text, &["[[claim]]", "[[measure]]"])[0];
    let mut all = before.to_owned();
    let mut targets: BTreeMap<(String, Option<String>), (String, Target)> = BTreeMap::new();
    for m in &mutants {
        let count = targets.len();
        targets.entry(m.target()).or_insert_with(|| {
            let target = Target::find(&text, &m.claim, m.reading.as_deref());
            let id = format!("claim-{count}");
            all.push_str(&target.written(&id, None));
            (id, target)
        });
    }
    for (k, m) in mutants.iter().enumerate() {
        let whole = m.from.len() > 1 && m.from.starts_with('\'') && m.from.ends_with('\'');
        let to = if whole { format!("'{}'", m.to) } else { m.to.clone() };
        all.push_str(&targets[&m.target()].1.written(&format!("mutant-{k}"), Some((&m.from, &to))));
    }
    let source = Source { path: format!("mutants of {file}"), text: all };
    let derivation = parse(source, file).unwrap_or_else(|found| panic!("{}", render(&found, false)));
    // What is looked at here are verdicts; how mistakes are corrected is what `planted.rs` and `variants.rs` look at.
    let options = Options { plain: true, ..Options::default() };
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));

    let mut problems = Vec::new();
    for claim in &account.claims {
        let fails = claim.results.iter().find(|p| matches!(p.verdict.outcome(), Outcome::Fails(_)));
        if let (Some(pair), Some("proved")) = (fails, claim.identity.as_ref().map(|i| i.verdict())) {
            problems.push(format!("{:?}\n    is proved, and fails on {}", claim.formulas, pair.trajectory));
        }
    }
    for (k, m) in mutants.iter().enumerate() {
        let name = format!(
            "{}{}: {} → {}",
            m.claim,
            m.reading.as_ref().map_or(String::new(), |r| format!("/{r}")),
            m.from,
            m.to
        );
        let original = results(&account, &targets[&m.target()].0);
        let mutated = results(&account, &format!("mutant-{k}"));
        assert_eq!(original.len(), mutated.len(), "{name}");
        let held = original.iter().filter(|p| holds(p)).count();
        if held == 0 {
            problems.push(format!("{name}\n    the claim itself holds nowhere"));
            continue;
        }
        let caught = original.iter().zip(mutated).filter(|(o, m)| {
            let refuted = matches!(m.verdict.outcome(), Outcome::Fails(_)) && m.verdict.evidence().witness.is_some();
            holds(o) && refuted
        });
        match (caught.count(), &m.survives) {
            (0, None) => {
                let words: Vec<String> =
                    mutated.iter().map(|p| format!("{} {}", p.trajectory, p.verdict.outcome().word())).collect();
                problems.push(format!("{name}\n    survives: {}", words.join(", ")));
            }
            (n @ 1.., Some(reason)) => {
                problems.push(format!("{name}\n    was to survive ({reason}), and fails on {n} of {held}"));
            }
            _ => {}
        }
    }
    (mutants.iter().filter(|m| m.survives.is_none()).count(), problems)
}

#[track_caller]
fn all_are_found(file: &str, at_least: usize) {
    let (count, problems) = run(file);
    assert!(problems.is_empty(), "{} mutants\n{}", problems.len(), problems.join("\n"));
    assert!(count >= at_least, "only {count} mutants of {file} are there to be found");
}

#[test]
fn mistakes_in_the_kepler_problem_are_found() {
    all_are_found("kepler", 25);
}

#[test]
fn mistakes_in_the_pendulum_are_found() {
    all_are_found("pendulum", 15);
}

#[test]
fn mistakes_in_the_comment_are_found() {
    all_are_found("deriglazov-comment", 60);
}

/// A user who edits a copy of the file and runs the program sees the mistake.
#[test]
fn a_flipped_sign_in_t9_is_found_by_the_program() {
    let text = read("derivations/deriglazov-comment.toml");
    let (from, to) = (r"\dot\psi=-(\frac{m_3}{I_1}\sin^2\psi", r"\dot\psi=(\frac{m_3}{I_1}\sin^2\psi");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("copy.toml");
    let check = |text: &str| {
        std::fs::write(&file, text).expect("a file can be written");
        let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
        command.current_dir(folder.path()).args([
            "check",
            "copy.toml",
            "--no-reports",
            "--claim",
            "t9-psi",
            "--trajectory",
            "racket-out",
        ]);
        let output = command.output().expect("the program runs");
        (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let (code, output) = check(&text);
    assert_eq!(code, Some(0), "{output}");
    let (before, claim) = text.split_at(text.find("id = \"t9-psi\"").expect("the claim is there"));
    let (code, output) = check(&format!("{before}{}", claim.replacen(from, to, 1)));
    assert_eq!(code, Some(1), "{output}");
    for part in [
        "Differs from what is expected",
        "t9-psi  fails on",
        "expected: holds",
        "left  ",
        "right  ",
        "error bound",
        r"\psi",
    ] {
        assert!(output.contains(part), "{part} is not in\n{output}");
    }
}
