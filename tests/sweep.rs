//! Families in parts: the same bytes as on one machine, and no part that is missing, double, foreign or half written.

use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder with the derivation file of families.
struct Place(tempfile::TempDir);

const FILE: &str = "families.toml";

impl Place {
    fn new() -> Place {
        let folder = tempfile::tempdir().expect("a folder");
        let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/families.toml");
        std::fs::copy(corpus, folder.path().join(FILE)).expect("it is copied");
        Place(folder)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn text(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).expect("a file")
    }

    /// Exit code, standard output, standard error.
    fn run(&self, threads: &str, arguments: &[&str]) -> (Option<i32>, String, String) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
        command.current_dir(self.0.path()).env("RAYON_NUM_THREADS", threads).args(arguments);
        let output = command.output().expect("it runs");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    }

    /// One part, in a file of that name.
    fn sweep(&self, family: &str, part: &str, name: &str) {
        let threads = if part.len().is_multiple_of(2) { "1" } else { "2" };
        let (code, out, error) =
            self.run(threads, &["sweep", FILE, "--family", family, "--part", part, "--output", name]);
        assert_eq!((code, out.as_str()), (Some(0), ""), "{error}");
    }

    /// The parts of a family, in files `part-K.jsonl`.
    fn sweep_all(&self, family: &str, of: usize) -> Vec<String> {
        let name = |k: usize| format!("part-{k}.jsonl");
        (1..=of).for_each(|k| self.sweep(family, &format!("{k}/{of}"), &name(k)));
        (1..=of).map(name).collect()
    }

    fn merge(&self, parts: &[String], more: &[&str]) -> (Option<i32>, String, String) {
        let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
        self.run("2", &[&["merge", FILE][..], &parts, more].concat())
    }
}

#[test]
fn parts_in_any_order_give_the_bytes_of_one_machine() {
    for (family, of) in [("amplitudes", 4), ("drawn", 7), ("grid", 15), ("both", 1), ("formulas", 2)] {
        let place = Place::new();
        let mut parts = place.sweep_all(family, of);
        for format in ["json", "text"] {
            let check = ["check", FILE, "--trajectory", family, "--only-verdicts", "--format", format];
            let (code, expected, _) = place.run("1", &check);
            assert!(expected.len() > 500, "{expected}");
            let found = place.merge(&parts, &["--format", format]);
            assert_eq!((found.0, &found.1), (code, &expected), "{family}: {}", found.2);
            parts.reverse();
            let middle = parts.len() / 2;
            parts.swap(0, middle);
            assert_eq!(place.merge(&parts, &["--format", format]).1, expected, "{family}, in another order");
        }
    }
}

#[test]
fn files_can_be_put_together_and_found_in_a_folder() {
    let place = Place::new();
    let parts = place.sweep_all("amplitudes", 3);
    let (_, expected, _) = place.merge(&parts, &[]);
    let all: String = parts.iter().rev().map(|name| place.text(name)).collect();
    std::fs::create_dir(place.path("together")).expect("a folder");
    std::fs::write(place.path("together/all.jsonl"), all).expect("it is written");
    std::fs::write(place.path("together/part-2.tmp"), "half").expect("it is written");
    assert_eq!(place.merge(&["together".to_owned()], &[]).1, expected);
    assert_eq!(place.merge(&["together".to_owned()], &["--output", "all.txt"]).1, "");
    assert_eq!(place.text("all.txt"), expected);
}

#[test]
fn a_part_is_the_same_bytes_wherever_it_is_counted_and_is_not_counted_twice() {
    let place = Place::new();
    place.sweep("drawn", "2/3", "a.jsonl");
    let first = place.text("a.jsonl");
    // Elsewhere, with other threads, in a folder that is made.
    let (code, ..) =
        place.run("3", &["sweep", FILE, "--family", "drawn", "--part", "2/3", "--output", "deep/er/b.jsonl"]);
    assert_eq!((code, place.text("deep/er/b.jsonl")), (Some(0), first.clone()));
    let resumed = |part: &str| {
        place.run("1", &["sweep", FILE, "--family", "drawn", "--part", part, "--output", "a.jsonl", "--resume"])
    };
    assert!(resumed("2/3").2.contains("already"));
    // Half a part is none: it is made again.
    std::fs::write(place.path("a.jsonl"), &first[..first.len() / 2]).expect("it is written");
    assert!(!resumed("2/3").2.contains("already"));
    assert_eq!(place.text("a.jsonl"), first);
    // So is another one.
    assert!(!resumed("3/3").2.contains("already"));
    assert_ne!(place.text("a.jsonl"), first);
}

#[test]
fn what_is_missing_double_damaged_or_foreign_is_refused() {
    let place = Place::new();
    let parts = place.sweep_all("amplitudes", 4);
    let refused = |parts: &[String], words: &[&str]| {
        let (code, out, error) = place.merge(parts, &["--format", "json", "--output", "merged.json"]);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{error}");
        assert!(words.iter().all(|w| error.contains(w)), "{error}");
        assert!(!place.path("merged.json").exists(), "{error}");
    };
    refused(&[parts[0].clone(), parts[3].clone()], &["2 of the parts are missing: 2, 3"]);
    refused(&[&parts[..], &parts[1..2]].concat(), &["part-2.jsonl", "given already"]);
    refused(&["part-9.jsonl".to_owned()], &["part-9.jsonl", "cannot be read"]);
    std::fs::write(place.path("empty.jsonl"), "").expect("it is written");
    refused(&["empty.jsonl".to_owned()], &["no part was given"]);
    let with = |name: &str, text: &str| {
        std::fs::write(place.path(name), text).expect("it is written");
        [&parts[1..], &[name.to_owned()]].concat()
    };
    let first = place.text(&parts[0]);
    refused(&with("half.jsonl", &first[..first.len() - 10]), &["half.jsonl", "it is damaged"]);
    let head = &first[..=first.find('\n').expect("a line")];
    refused(&with("head.jsonl", head), &["head.jsonl", "part 1/4 has no end"]);
    refused(&with("altered.jsonl", &first.replace("\"holds\":2", "\"holds\":1")), &["altered.jsonl", "it is damaged"]);
    place.sweep("amplitudes", "1/3", "other.jsonl");
    refused(&[&parts[1..], &["other.jsonl".to_owned()]].concat(), &["other.jsonl", "are parts of 4"]);
    place.sweep("grid", "1/4", "grid.jsonl");
    refused(&[&parts[1..], &["grid.jsonl".to_owned()]].concat(), &["grid.jsonl", "of the family `amplitudes`"]);
    // The file has changed since.
    std::fs::write(place.path(FILE), format!("{}\n", place.text(FILE))).expect("it is written");
    refused(&parts, &["part-1.jsonl", "another state of this one"]);
}

/// A part that says something else, with an end that fits.
fn forged(text: &str, old: &str, new: &str) -> String {
    use sha2::{Digest, Sha256};
    assert!(text.contains(old), "{text}");
    let body: Vec<&str> = text.lines().collect();
    let body: String = body[..body.len() - 1].iter().map(|line| format!("{}\n", line.replace(old, new))).collect();
    let hash: String = Sha256::digest(&body).iter().map(|b| format!("{b:02x}")).collect();
    format!("{body}{{\"end\":\"{hash}\"}}\n")
}

#[test]
fn a_forged_part_is_seen_where_it_is_shown() {
    let place = Place::new();
    place.sweep("amplitudes", "1/1", "whole.jsonl");
    let whole = place.text("whole.jsonl");
    let told = |old: &str, new: &str| {
        std::fs::write(place.path("forged.jsonl"), forged(&whole, old, new)).expect("it is written");
        let (code, _, error) = place.merge(&["forged.jsonl".to_owned()], &[]);
        assert_eq!(code, Some(2), "{old}: {error}");
        error
    };
    // Another member fails than says the part.
    assert!(told("\"first_failing\":8", "\"first_failing\":3").contains("member 3 of the family `amplitudes`"));
    assert!(told("{\"number\":9,", "{\"number\":8,").contains("another verdict here than its part says"));
    assert!(told("\"holds\":7", "\"holds\":8").contains("its counts do not add up"));
    assert!(told("\"of\":1", "\"of\":0").contains("not a line of a part"));
    assert!(told("\"rederive\":\"", "\"rederive\":\"9.").contains("made by version 9."));
}

/// Of a small family every member is counted again: whichever few are left out by who made a part up, they are missed, each time.
#[test]
fn no_lie_about_a_small_family_is_believed() {
    let place = Place::new();
    let claim =
        "\n[[claim]]\nid = 'rarely-false'\nsays = 's'\nalways = ['x<2.9']\nfamilies = ['f']\ntrajectories = []\n";
    let family = "\n[[family]]\nid = 'f'\nof = 'one'\nvary = { 'k' = { uniform = [0.1, 3] } }\ndraws = 100\nseed = 1\n";
    let head = "[derivation]\ntitle = 't'\nconcerns = 'c'\n[symbols]\n't' = { role = 'time' }\n'x' = { role = 'state' }\n'k' = { role = \
                'parameter' }\n[[trajectory]]\nid = 'one'\nformula = { 'x' = 'kt' }\nparameters = { 'k' = 1 }\nspan = [0, 1]\n";
    std::fs::write(place.path(FILE), [head, family, claim].concat()).expect("it is written");
    place.sweep("f", "1/1", "whole.jsonl");
    let whole = place.text("whole.jsonl");
    assert!(whole.contains("\"holds\":97,\"fails\":3"), "{whole}");
    let counts = whole.lines().nth(1).expect("a line of a claim");
    let (head, _) = counts.split_once("\"holds\"").expect("counts");
    let lie = format!(
        "{head}\"holds\":100,\"fails\":0,\"not_applicable\":0,\"undecided\":0,\"first_failing\":null,\"clearest_failing\":null,\
         \"closest_call\":null,\"first_undecided\":null,\"first_defect\":null}}"
    );
    std::fs::write(place.path("lie.jsonl"), forged(&whole, counts, &lie)).expect("it is written");
    for _ in 0..4 {
        let (code, out, error) = place.merge(&["lie.jsonl".to_owned()], &[]);
        assert_eq!(code, Some(2), "{out}{error}");
    }
    assert_eq!(place.merge(&["whole.jsonl".to_owned()], &[]).0, Some(1));
}

#[test]
fn a_sweep_that_cannot_be_made_leaves_nothing() {
    let place = Place::new();
    let refused = |arguments: &[&str], words: &str| {
        let (code, _, error) = place.run("1", &[&["sweep", FILE, "--output", "out.jsonl"], arguments].concat());
        assert!(code == Some(2) && error.contains(words), "{error}");
        assert!(!place.path("out.jsonl").exists());
    };
    refused(&["--family", "grid", "--part", "0/4"], "parts are numbered from 1/4 to 4/4");
    refused(&["--family", "grid", "--part", "5/4"], "parts are numbered from 1/4 to 4/4");
    refused(&["--family", "grid", "--part", "4"], "a part is written K/N");
    refused(&["--family", "grid", "--part", "1/2000000"], "at most 1000000");
    refused(&["--family", "grid", "--part", "1/16"], "has 15 members, which are not divided into 16 parts");
    refused(&["--family", "gird"], "there is no family `gird`");
    let text = place.text(FILE);
    std::fs::write(place.path(FILE), text.replace("draws = 40", "draws = 500000000")).expect("it is written");
    refused(&["--family", "drawn", "--part", "1/100"], "take at least 500 parts");
    let unasked = text.replace("families = [\"formulas\"]", "").replace(", \"formulas\"]", "]");
    std::fs::write(place.path(FILE), unasked).expect("it is written");
    refused(&["--family", "formulas"], "no claim is tried on the family `formulas`");
    let (code, _, error) = place.run("1", &["sweep", FILE, "--family", "grid", "--output", FILE]);
    assert!(code == Some(2) && error.contains("is read in this run"), "{error}");
}

const MANY: &str = r"
[derivation]
title = 'Many'
concerns = 'Tests'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'k' = { role = 'parameter' }
[[trajectory]]
id = 'one'
parameters = { 'k' = 2 }
formula = { 'x' = '\sin kt' }
span = [0, 1]
[[family]]
id = 'many'
of = 'one'
vary = { 'k' = { from = 1, to = 10, count = 10000 } }
[[claim]]
id = 'rate'
says = 'The rate'
trajectories = []
families = ['many']
always = ['\dot x=k\cos kt']
";

#[test]
fn the_ten_lines_of_the_page_are_a_family() {
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/scale.md")).expect("the page");
    let pieces = page.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next());
    let text: String = pieces.collect();
    assert_eq!(
        text.split("[[family]]").nth(1).map(|lines| lines.lines().filter(|l| l.contains('=')).count()),
        Some(10)
    );
    let place = Place::new();
    std::fs::write(place.path("ten.toml"), text).expect("written");
    let (code, out, error) = place.run("1", &["check", "ten.toml", "--matrix"]);
    assert_eq!(code, Some(0), "{out}{error}");
    assert!(out.contains("olds on all 200 members tried") && out.contains("1.5 %"), "{out}");
}

#[test]
fn ten_thousand_parts_are_joined() {
    let place = Place::new();
    std::fs::write(place.path(FILE), MANY).expect("it is written");
    place.sweep("many", "5000/10000", "one.jsonl");
    let one = place.text("one.jsonl");
    assert!(one.len() < 1024 && one.contains("\"holds\":1,"), "{one}");
    // The part of one member, once for each: no member of them is shown.
    let folder = place.path("parts");
    std::fs::create_dir(&folder).expect("a folder");
    for k in (1..=10_000).filter(|k| *k != 77) {
        let text = forged(&one, "\"part\":5000", &format!("\"part\":{k}"));
        std::fs::write(folder.join(format!("{k}.jsonl")), text).expect("it is written");
    }
    let (code, _, error) = place.merge(&["parts".to_owned()], &[]);
    assert!(code == Some(2) && error.contains("1 of the parts are missing: 77"), "{error}");
    place.sweep("many", "77/10000", "parts/77.jsonl");
    let (code, out, error) = place.merge(&["parts".to_owned()], &["--format", "json"]);
    assert_eq!(code, Some(0), "{error}");
    assert!(out.contains("\"members\":10000,\"rejected\":0,\"holds\":10000,"), "{out}");
}
