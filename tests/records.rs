//! What a check leaves for the next process: it changes how long that takes, and nothing else.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

use rederive::check::{Cancel, Limits, Rigor, Store};
use rederive::{Ask, Failure, Session};

/// Records in memory, and how often one was read and written.
#[derive(Default)]
struct Memory {
    records: Mutex<HashMap<String, Vec<u8>>>,
    counts: Mutex<(usize, usize)>,
}

impl Store for Memory {
    fn read(&self, name: &str) -> Option<Vec<u8>> {
        let found = self.records.lock().expect("a map").get(name).cloned();
        self.counts.lock().expect("counts").0 += usize::from(found.is_some());
        found
    }

    fn write(&self, name: &str, record: &[u8]) {
        self.counts.lock().expect("counts").1 += 1;
        self.records.lock().expect("a map").insert(name.to_owned(), record.to_vec());
    }
}

impl Memory {
    /// How often a record was read and written since this was asked.
    fn counted(&self) -> (usize, usize) {
        std::mem::take(&mut self.counts.lock().expect("counts"))
    }
}

fn derivation(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("derivations").join(name);
    fs::read_to_string(path).expect("it is there")
}

fn open(name: &str, text: &str) -> Session {
    Session::open(name, text).unwrap_or_else(|found| panic!("{}", rederive::diag::render(&found, false)))
}

/// Checks with the records, and compares with a check that knows nothing; how often records were read and written.
#[track_caller]
fn step(store: &Memory, name: &str, text: &str, ask: &Ask) -> (usize, usize) {
    let session = open(name, text);
    store.counted();
    let recalled = session.check_recorded(ask, store, &|_, _| {}).expect("it is checked");
    let whole = session.check(ask, &|_, _| {}).expect("it is checked");
    assert!(recalled.json() == whole.json(), "report.json is another one");
    assert!(recalled.page() == whole.page(), "the page is another one");
    assert!(recalled.markdown() == whole.markdown(), "report.md is another one");
    store.counted()
}

#[test]
fn edits_of_one_file() {
    let text = derivation("kepler.toml");
    let edits = [
        // A title and a remark; a formula; an assumption; a motion; a claim that asks for what no other one does; a first integral, which
        // encloses the motions for all claims.
        ("The Kepler problem: integrals", "The problem of Kepler: integrals"),
        (r"=\mu^2+2h\,", r"=\mu^2+3h\,"),
        (r"'e>10^{-9}'", r"'e>10^{-1}'"),
        ("span = [0, 30]", "span = [0, 29]"),
        ("'\\mu' = 1.3", "'\\mu' = 1.31"),
        ("first-integral = ['h']", "first-integral = ['\\dot h']"),
        (
            "[[claim]]",
            "[[claim]]\nid = \"new\"\nsays = \"New.\"\nalways = ['r\\ddot r+\\sin\\ddot r<100']\n\n[[claim]]",
        ),
    ];
    let store = Memory::default();
    let ask = Ask { rigor: Rigor::Enclosed, ..Ask::default() };
    assert_eq!(step(&store, "kepler.toml", &text, &ask), (0, 4), "nothing is known");
    assert_eq!(step(&store, "kepler.toml", &text, &ask), (1, 0), "all is known");
    assert_eq!(step(&store, "kepler.toml", &format!("# A word.\n\n{text}"), &ask), (1, 0), "words alone have changed");
    for (old, new) in edits {
        assert!(text.contains(old), "{old}");
        step(&store, "kepler.toml", &text.replacen(old, new, 1), &ask);
    }
    assert_eq!(step(&store, "kepler.toml", &text, &ask), (1, 0), "an edit that is undone is known");
}

/// After an edit of a claim motions are enclosed from the steps that are known; after one of a motion there are new ones.
#[test]
fn an_edit_of_a_claim_finds_no_new_steps() {
    let text = derivation("circuit.toml");
    let store = Memory::default();
    let ask = Ask { rigor: Rigor::Enclosed, ..Ask::default() };
    let claim = text.replacen("[[claim]]\n", "[[claim]]\nprecision = 1e-7\n", 1);
    // The one that is integrated: of formulas there are no steps.
    let motion = text.replacen("'\\dot q' = 0 }\nspan = [0, 20]", "'\\dot q' = 0 }\nspan = [0, 21]", 1);
    assert!(claim != text && motion != text);
    assert_eq!(step(&store, "circuit.toml", &text, &ask).1, 4);
    assert_eq!(step(&store, "circuit.toml", &claim, &ask).1, 3);
    assert_eq!(step(&store, "circuit.toml", &motion, &ask).1, 4);
}

/// Of many states of a file the last ones are kept.
#[test]
fn the_oldest_states_are_forgotten() {
    let text = derivation("circuit.toml");
    let store = Memory::default();
    let state = |n: usize| text.replacen("[[claim]]\n", &format!("[[claim]]\nprecision = {n}e-9\n"), 1);
    let check = |text: &str| {
        let session = open("circuit.toml", text);
        store.counted();
        session.check_recorded(&Ask::default(), &store, &|_, _| {}).expect("it is checked");
        store.counted().1 == 0
    };
    for n in 1..=9 {
        assert!(!check(&state(n)), "{n} is new");
    }
    let held = store.records.lock().expect("a map").values().filter(|bytes| !bytes.is_empty()).count();
    assert_eq!(held, 8 + 2, "eight accounts, their names, and the answers");
    for n in 2..=9 {
        assert!(check(&state(n)), "{n} is known");
    }
    assert!(!check(&state(1)), "it was forgotten");
}

/// Digits that binary64 does not have, and symbols of one claim that become those of another, change what is said.
#[test]
fn digits_and_whose_symbols_they_are_are_content() {
    let text = "[derivation]\ntitle = \"t\"\nconcerns = \"t\"\n[symbols]\n't' = { role = \"time\" }\n'x' = { role = \"state\" }\n\
        'c' = { role = \"parameter\" }\n'h' = { role = \"abbreviation\", formula = 'x' }\n[[trajectory]]\nid = \"m\"\n\
        formula = { 'x' = 'ct' }\nparameters = { 'c' = 0.1 }\nspan = [0, 1]\n[[claim]]\nid = \"a\"\nsays = \"t\"\n\
        always = ['10c=1', 'h=x']\n[[claim]]\nid = \"b\"\nsays = \"t\"\n\
        symbols = { 'h' = { role = \"abbreviation\", formula = 'x+1' } }\nalways = ['h=x+1']\n";
    let line = "symbols = { 'h' = { role = \"abbreviation\", formula = 'x+1' } }\n";
    let moved = text.replace(line, "").replace("id = \"a\"\n", &format!("id = \"a\"\n{line}"));
    let digits = text.replace("= 0.1 }", "= 0.10000000000000000001 }");
    let store = Memory::default();
    for (text, written) in [(text, 3), (&moved, 3), (text, 0), (&digits, 3), (text, 0)] {
        assert_eq!(step(&store, "file.toml", text, &Ask::default()).1, written, "it is another file, or it was before");
    }
}

/// A proof is asked for again where a claim that it follows from says something else, directly or through others.
#[test]
fn what_a_proof_follows_from_is_content() {
    let text = "[derivation]\ntitle = \"t\"\nconcerns = \"t\"\n[symbols]\n't' = { role = \"time\" }\n'x' = { role = \"state\" }\n\
        'c' = { role = \"parameter\", positive = true }\n[[trajectory]]\nid = \"m\"\nformula = { 'x' = 'ct' }\n\
        parameters = { 'c' = 2 }\nspan = [0, 1]\n[[claim]]\nid = \"first\"\nsays = \"t\"\nalways = ['x=ct']\n[[claim]]\nid = \"second\"\n\
        says = \"t\"\nfollows-from = [\"first\"]\nalways = ['x^2=c^2t^2']\n[[claim]]\nid = \"third\"\nsays = \"t\"\n\
        follows-from = [\"second\"]\nalways = ['x^4=c^4t^4']\n";
    let store = Memory::default();
    let standing = |text: &str, of: usize| {
        step(&store, "file.toml", text, &Ask::default());
        let found = open("file.toml", text).check_recorded(&Ask::default(), &store, &|_, _| {}).expect("it is checked");
        found.account().claims[of].identity.as_ref().map(|i| i.standing())
    };
    let (first, second) = (text.replace("'x=ct'", "'x=3ct'"), text.replace("'x^2=c^2t^2'", "'x^2=9c^2t^2'"));
    for _ in 0..2 {
        assert_eq!((standing(text, 1), standing(text, 2)), (Some("proved given"), Some("proved given")));
        assert_ne!(standing(&first, 1), Some("proved given"), "what it follows from says something else");
        assert_eq!(standing(text, 1), Some("proved given"));
        assert_ne!(standing(&second, 2), Some("proved given"));
    }
}

#[test]
fn what_is_asked_otherwise_is_another_record() {
    let text = derivation("circuit.toml");
    let store = Memory::default();
    for (ask, written) in [
        (Ask::default(), 3),
        // The steps of the motions are in a record of their own.
        (Ask { rigor: Rigor::Enclosed, ..Ask::default() }, 4),
        (Ask { only_verdicts: true, ..Ask::default() }, 3),
    ] {
        assert_eq!(step(&store, "circuit.toml", &text, &ask), (0, written));
        assert_eq!(step(&store, "circuit.toml", &text, &ask), (1, 0));
    }
    assert_eq!(step(&store, "other.toml", &text, &Ask::default()), (0, 3), "another file");
    let claim = open("circuit.toml", &text).claims()[0].id.clone();
    let part = Ask { claims: vec![claim], ..Ask::default() };
    assert_eq!(step(&store, "circuit.toml", &text, &part), (0, 0), "a part is not recorded");
}

#[test]
fn what_is_no_record_is_nothing() {
    let text = derivation("circuit.toml");
    let store = Memory::default();
    step(&store, "circuit.toml", &text, &Ask::default());
    let whole: Vec<(String, Vec<u8>)> = store.records.lock().expect("a map").clone().into_iter().collect();
    for (name, bytes) in &whole {
        for damage in [0, 1, bytes.len() / 2, bytes.len() - 1] {
            let mut cut = bytes.clone();
            cut.truncate(damage);
            let mut other = bytes.clone();
            other[damage] ^= 0x55;
            for damaged in [cut, other] {
                store.records.lock().expect("a map").insert(name.clone(), damaged);
                // Whoever keeps records sees to it that they are whole; that a damaged one is no panic is seen here.
                let _ = open("circuit.toml", &text).check_recorded(&Ask::default(), &store, &|_, _| {});
            }
        }
        store.records.lock().expect("a map").insert(name.clone(), bytes.clone());
    }
    store.records.lock().expect("a map").values_mut().for_each(Vec::clear);
    assert_eq!(step(&store, "circuit.toml", &text, &Ask::default()).1, 3);
}

#[test]
fn what_was_not_finished_is_not_kept() {
    let text = derivation("circuit.toml");
    let store = Memory::default();
    let flag = Cancel::default();
    flag.raise();
    let ask = Ask { limits: Limits { cancel: Some(flag), ..Limits::default() }, ..Ask::default() };
    let found = open("circuit.toml", &text).check_recorded(&ask, &store, &|_, _| {});
    assert!(matches!(found, Err(Failure::Cancelled)));
    let late = Limits { deadline: Some(std::time::Instant::now()), ..Limits::default() };
    let ask = Ask { limits: late, ..Ask::default() };
    open("circuit.toml", &text).check_recorded(&ask, &store, &|_, _| {}).expect("it ends");
    assert_eq!(store.counted(), (0, 0));
}

/// The program, which keeps what it finds in a folder; the names and bytes that are in it then.
fn run(arguments: &[&str], folder: &Path, variable: Option<&Path>) -> (String, Vec<(PathBuf, Vec<u8>)>) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(arguments);
    // The secret lies in the folder of the user.
    let home = folder.with_file_name("home");
    for variable in ["HOME", "XDG_CACHE_HOME", "LOCALAPPDATA"] {
        command.env(variable, &home);
    }
    match variable {
        Some(path) => command.env("REDERIVE_CACHE", path),
        None => command.env("REDERIVE_CACHE", ""),
    };
    let out = command.output().expect("it runs");
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    let mut records: Vec<(PathBuf, Vec<u8>)> = fs::read_dir(folder)
        .into_iter()
        .flatten()
        .map(|entry| entry.expect("an entry").path())
        .map(|path| (path.clone(), fs::read(path).expect("a file")))
        .collect();
    records.sort();
    (String::from_utf8_lossy(&out.stdout).into_owned(), records)
}

#[test]
fn the_program_keeps_records_where_it_is_told() {
    let temporary = tempfile::tempdir().expect("a folder");
    let folder = temporary.path().join("kept");
    let of = folder.to_str().expect("a plain name");
    // Long enough to be kept.
    let check = ["check", "derivations/kepler-laws.toml", "--no-reports", "--rigor", "sampled", "--only-verdicts"];
    let (said, records) = run(&check, &folder, None);
    assert!(records.is_empty(), "an empty variable keeps nothing");
    let with = [&check[..], &["--cache", of]].concat();
    let (first, records) = run(&with, &folder, None);
    assert_eq!((first == said, records.len()), (true, 3));
    let (again, same) = run(&with, &folder, None);
    assert!(again == said && same == records);
    let (by_variable, same) = run(&check, &folder, Some(&folder));
    assert!(by_variable == said && same == records);
    // What is damaged is made again.
    for (path, bytes) in &records {
        fs::write(path, &bytes[..bytes.len() - 1]).expect("written");
    }
    let (mended, same) = run(&with, &folder, None);
    assert!(mended == said && same == records);
    fs::remove_dir_all(&folder).expect("it was there");
    let without = [&check[..], &["--no-cache"]].concat();
    let (fresh, none) = run(&without, &folder, Some(&folder));
    assert!(fresh == said && none.is_empty() && !folder.exists());
}

/// What `explain` says is what `check` says of a claim, whether `check` was run before, and kept what it found, or nothing was.
#[test]
fn what_is_explained_is_recalled() {
    let temporary = tempfile::tempdir().expect("a folder");
    let folder = temporary.path().join("kept");
    let of = folder.to_str().expect("a plain name");
    let file = "derivations/kepler-laws.toml";
    let claims: Vec<String> =
        open("kepler-laws.toml", &derivation("kepler-laws.toml")).claims().into_iter().map(|c| c.id).collect();
    let explain =
        |more: &[&str]| run(&[&["explain", &claims[0], file, "--rigor", "sampled"], more].concat(), &folder, None);
    let (cold, none) = explain(&["--no-cache"]);
    assert!(none.is_empty() && cold.contains(&claims[0]));
    run(&["check", file, "--no-reports", "--rigor", "sampled", "--cache", of], &folder, None);
    let (warm, records) = explain(&["--cache", of]);
    assert!(warm == cold && records.len() == 3, "{warm}\n{cold}");

    // The other way about: `check` recalls what `explain` kept.
    fs::remove_dir_all(&folder).expect("it was there");
    let (first, records) = explain(&["--cache", of]);
    assert!(first == cold && records.len() == 3);
    let (_, same) = run(&["check", file, "--no-reports", "--rigor", "sampled", "--cache", of], &folder, None);
    assert!(same == records, "nothing was found again");

    // One motion alone is told in the same words.
    let on = open("kepler-laws.toml", &derivation("kepler-laws.toml")).derivation().trajectories[0].id.clone();
    let (alone, _) = explain(&["--cache", of, "--on", &on]);
    let (cold, _) = explain(&["--no-cache", "--on", &on]);
    assert!(alone == cold && alone.len() < first.len());
}

/// Every claim of a derivation is explained alike with and without records.
#[test]
fn explanations_are_the_same_for_every_claim() {
    for name in ["circuit.toml", "pendulum.toml", "kepler-laws.toml"] {
        let (session, store) = (open(name, &derivation(name)), Memory::default());
        let [kept, recalled] =
            [0, 1].map(|_| session.check_recorded(&Ask::default(), &store, &|_, _| {}).expect("checked"));
        assert_eq!(store.counted(), (1, 3));
        let cold = session.check(&Ask::default(), &|_, _| {}).expect("it is checked");
        for claim in session.claims() {
            let told = cold.explanation(&claim.id, &[], true);
            assert!(
                told == recalled.explanation(&claim.id, &[], true) && told == kept.explanation(&claim.id, &[], true)
            );
            for on in &session.derivation().trajectories {
                let on = [on.id.clone()];
                assert!(cold.explanation(&claim.id, &on, false) == recalled.explanation(&claim.id, &on, false));
            }
        }
    }
}

/// A file that is watched begins with what is known of it, and what was found while it changed is known later.
#[test]
fn who_watches_a_file_recalls_what_was_found() {
    let text = derivation("circuit.toml");
    let edited = text.replacen("[[claim]]\n", "[[claim]]\nprecision = 1e-7\n", 1);
    assert!(edited != text);
    let store = Memory::default();
    let again = |session: &mut Session, text: &str| {
        session.change(text).expect("it is read");
        let (found, checked) = session.check_again_recorded(&store).expect("it is checked");
        let whole = open("circuit.toml", text).check(&Ask::default(), &|_, _| {}).expect("it is checked");
        assert!(found.json() == whole.json() && found.page() == whole.page());
        !checked.is_empty()
    };
    open("circuit.toml", &text).check_recorded(&Ask::default(), &store, &|_, _| {}).expect("it is checked");
    let mut first = open("circuit.toml", &text);
    assert!(!again(&mut first, &text), "it is known from the check");
    assert!(again(&mut first, &edited));
    assert!(!again(&mut open("circuit.toml", &text), &edited), "it is known from who watched");
    assert!(!again(&mut first, &text), "what is undone is known");
    assert!(!again(&mut first, &edited));
}
