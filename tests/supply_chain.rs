//! What the program is made of: licences, sources and bans of `deny.toml`, and no `unsafe` of our own.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;
use toml::Table;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn deny() -> Table {
    fs::read_to_string(root().join("deny.toml")).expect("read").parse().expect("TOML")
}

/// What the compiler is given: every package of the lock file with its licence.
fn packages() -> Vec<Value> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    // What this system builds is at hand, but perhaps not what the Python package needs beside it.
    let version = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into())).arg("-vV").output();
    let version = String::from_utf8(version.expect("it runs").stdout).expect("UTF-8");
    let host = version.lines().find_map(|l| l.strip_prefix("host: ")).expect("a system");
    let mut command = Command::new(cargo);
    command.current_dir(root()).args(["metadata", "--format-version", "1", "--locked"]);
    command.args(["--filter-platform", host]);
    let output = command.output().expect("it runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let all: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    all["packages"].as_array().expect("packages").clone()
}

/// Whether an expression of SPDX can be satisfied with allowed licences.
fn allowed(expression: &str, is_allowed: &dyn Fn(&str) -> bool) -> bool {
    fn any(words: &mut &[String], ok: &dyn Fn(&str) -> bool) -> bool {
        let mut out = all(words, ok);
        while words.first().is_some_and(|w| w == "OR") {
            *words = &words[1..];
            let next = all(words, ok);
            out |= next;
        }
        out
    }
    fn all(words: &mut &[String], ok: &dyn Fn(&str) -> bool) -> bool {
        let mut out = one(words, ok);
        while words.first().is_some_and(|w| w == "AND") {
            *words = &words[1..];
            let next = one(words, ok);
            out &= next;
        }
        out
    }
    fn one(words: &mut &[String], ok: &dyn Fn(&str) -> bool) -> bool {
        let Some((first, rest)) = words.split_first() else { return false };
        *words = rest;
        if first == "(" {
            let out = any(words, ok);
            assert_eq!(words.first().map(String::as_str), Some(")"));
            *words = &words[1..];
            return out;
        }
        let mut name = first.clone();
        if words.first().is_some_and(|w| w == "WITH") {
            name = format!("{name} WITH {}", words[1]);
            *words = &words[2..];
        }
        ok(&name)
    }
    // The older spelling of OR.
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<String> = spaced.split_whitespace().map(str::to_owned).collect();
    let mut words = words.as_slice();
    let out = any(&mut words, is_allowed);
    out && words.is_empty()
}

#[test]
fn expressions_of_licences_are_read() {
    let mit = |name: &str| name == "MIT";
    for (text, good) in [
        ("MIT", true),
        ("GPL-3.0", false),
        ("MIT OR Apache-2.0", true),
        ("MIT/GPL-3.0", true),
        ("MIT AND GPL-3.0", false),
        ("(GPL-3.0 OR MIT) AND MIT", true),
        ("GPL-3.0 OR MIT AND ISC", false),
        ("MIT WITH x", false),
        ("", false),
    ] {
        assert_eq!(allowed(text, &mit), good, "{text}");
    }
}

#[test]
fn licences_sources_and_bans_are_those_of_the_list() {
    let deny = deny();
    let list: Vec<&str> =
        deny["licenses"]["allow"].as_array().expect("a list").iter().filter_map(|v| v.as_str()).collect();
    let banned: Vec<&str> =
        deny["bans"]["deny"].as_array().expect("a list").iter().filter_map(|v| v["crate"].as_str()).collect();
    let packages = packages();
    assert!(packages.len() > 80, "{}", packages.len());
    let mut wrong = Vec::new();
    for package in &packages {
        let name = package["name"].as_str().unwrap_or_default();
        let licence = package["license"].as_str().unwrap_or_default();
        if !allowed(licence, &|l| list.contains(&l)) {
            wrong.push(format!("{name}: the licence `{licence}` is not on the list"));
        }
        // `null` is a crate of this repository.
        let source = package["source"].as_str();
        if source.is_some_and(|s| !s.starts_with("registry+") && !s.starts_with("sparse+")) {
            wrong.push(format!("{name}: comes from {source:?}"));
        }
        if banned.contains(&name) {
            wrong.push(format!("{name} is banned"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_crate_forbids_unsafe_code() {
    let mut looked = 0;
    let mut files = vec![root().join("src/lib.rs"), root().join("src/main.rs")];
    for entry in fs::read_dir(root().join("src")).expect("listed") {
        files.push(entry.expect("entry").path().join("lib.rs"));
    }
    for file in files.iter().filter(|f| f.is_file()) {
        let text = fs::read_to_string(file).expect("read");
        assert!(text.contains("#![forbid(unsafe_code)]"), "{}", file.display());
        looked += 1;
    }
    assert!(looked >= 2, "{looked}");
}
