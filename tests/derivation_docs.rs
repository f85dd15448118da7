//! The page on the format agrees with the loader.

use std::fs;
use std::path::Path;

use rederive::derivation::{keys, parse};
use rederive::diag::{Source, render};

fn page() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/derivation-file.md");
    fs::read_to_string(path).expect("the page is there")
}

/// All TOML of the page, as one file; lines are those of the page.
fn example() -> String {
    let mut inside = false;
    let mut out = String::new();
    for line in page().lines() {
        if line.starts_with("```") {
            inside = line == "```toml";
        } else if inside {
            out.push_str(line);
        }
        out.push('\n');
    }
    out
}

#[test]
fn every_key_is_described() {
    let page = page();
    for (table, keys) in keys::ALL {
        for key in *keys {
            let described = [format!("`{key}`"), format!("`[{key}]`"), format!("`[{key}.ID]`"), format!("`[[{key}]]`")];
            assert!(described.iter().any(|d| page.contains(d)), "{table}: `{key}` is not described");
        }
    }
}

#[test]
fn every_key_is_in_the_example() {
    let example = example();
    for key in keys::ALL.iter().flat_map(|(_, keys)| *keys) {
        let optional = ["id", "source", "levels", "shape", "initial-time", "not-applicable", "undecided"];
        let used = |before: &str| {
            example.contains(&format!("{before}{key} "))
                || example.contains(&format!("[{key}"))
                || example.contains(&format!(".{key}]"))
        };
        assert!(optional.contains(key) || used("\n") || used(" "), "`{key}` is in no example");
    }
}

#[test]
fn the_example_is_a_derivation_file() {
    let source = Source { path: "docs/derivation-file.md".into(), text: example() };
    let derivation = parse(source, "pendulum").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    assert_eq!(derivation.trajectories.len(), 4);
    assert_eq!(derivation.claims.len(), 25);
}

#[test]
fn the_example_has_the_verdicts_that_it_expects() {
    let source = Source { path: "docs/derivation-file.md".into(), text: example() };
    let derivation = parse(source, "pendulum").unwrap_or_else(|found| panic!("{}", render(&found, false)));
    let account = rederive::check::check(&derivation, &rederive::check::Options::default(), &|_, _| {});
    let account = account.unwrap_or_else(|e| panic!("{e:?}"));
    for claim in &account.claims {
        for judged in claim.verdicts() {
            let word = judged.verdict.outcome().word();
            assert!(!judged.unexpected, "{} {:?} on {}: {word}", claim.id, claim.reading, judged.on());
        }
    }
    assert!(account.summary().fails > 0 && account.summary().holds > 0);
}
