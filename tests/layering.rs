//! The crates of `src/` import only what they may.

use std::fs;
use std::path::{Path, PathBuf};

/// Each crate, and the others that it may import.
pub const CRATES: &[(&str, &[&str])] = &[
    ("diag", &[]),
    ("files", &[]),
    ("meter", &[]),
    ("number", &[]),
    ("reason", &["meter", "number"]),
    ("verdict", &["reason"]),
    ("expr", &["meter", "number"]),
    ("checker", &["expr", "meter", "number"]),
    ("latex", &["diag", "expr"]),
    ("flow", &["expr", "meter", "number"]),
    ("proof", &["expr", "meter", "number"]),
    ("derivation", &["diag", "expr", "files", "latex", "meter"]),
    ("paper", &["derivation", "diag", "files", "latex"]),
    ("lint", &["diag", "expr", "latex", "meter", "number", "paper", "proof"]),
    ("units", &["derivation", "expr", "latex"]),
    ("tactics", &["checker", "claim", "derivation", "expr", "latex", "meter"]),
    ("findings", &["checker", "derivation", "expr", "number", "proof", "reason", "units", "verdict"]),
    ("claim", &["derivation", "diag", "expr", "flow", "latex", "meter", "number", "reason", "verdict"]),
    (
        "proved",
        &[
            "claim",
            "derivation",
            "diag",
            "expr",
            "findings",
            "latex",
            "meter",
            "number",
            "proof",
            "reason",
            "tactics",
            "units",
            "verdict",
        ],
    ),
    (
        "boxes",
        &[
            "claim",
            "derivation",
            "diag",
            "expr",
            "findings",
            "latex",
            "meter",
            "number",
            "proof",
            "proved",
            "reason",
            "verdict",
        ],
    ),
    (
        "sampled",
        &["claim", "derivation", "diag", "expr", "findings", "flow", "latex", "meter", "number", "reason", "verdict"],
    ),
    (
        "enclosed",
        &[
            "claim",
            "derivation",
            "expr",
            "findings",
            "flow",
            "latex",
            "meter",
            "number",
            "proof",
            "reason",
            "sampled",
            "verdict",
        ],
    ),
    (
        "families",
        &[
            "claim",
            "derivation",
            "diag",
            "expr",
            "findings",
            "flow",
            "latex",
            "meter",
            "number",
            "proof",
            "proved",
            "reason",
            "sampled",
            "verdict",
        ],
    ),
    (
        "weight",
        &[
            "boxes",
            "claim",
            "derivation",
            "expr",
            "findings",
            "flow",
            "latex",
            "meter",
            "number",
            "proved",
            "sampled",
            "units",
            "verdict",
        ],
    ),
    (
        "check",
        &[
            "boxes",
            "claim",
            "derivation",
            "diag",
            "enclosed",
            "expr",
            "families",
            "files",
            "findings",
            "flow",
            "latex",
            "meter",
            "number",
            "proof",
            "proved",
            "reason",
            "sampled",
            "units",
            "verdict",
            "weight",
        ],
    ),
    (
        "report",
        &[
            "checker",
            "derivation",
            "diag",
            "expr",
            "findings",
            "latex",
            "lint",
            "meter",
            "paper",
            "reason",
            "units",
            "verdict",
        ],
    ),
];

/// Files of `src/` that belong to no room.
const OUTSIDE: &[&str] = &[
    "lib.rs",
    "main.rs",
    "ask.rs",
    "brief.rs",
    "conclusion.rs",
    "either_base.rs",
    "config.rs",
    "look.rs",
    "run.rs",
    "session.rs",
    "threads.rs",
    "cli",
];

/// The code without comments, strings and characters; line breaks are kept.
pub fn code_only(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut out = String::new();
    let mut i = 0;
    let at = |i: usize| chars.get(i).copied().unwrap_or('\0');
    while i < chars.len() {
        let raw = (at(i) == 'r' && !out.ends_with(|c: char| c.is_alphanumeric() || c == '_'))
            .then(|| chars[i + 1..].iter().take_while(|c| **c == '#').count())
            .filter(|hashes| at(i + 1 + hashes) == '"');
        if at(i) == '/' && at(i + 1) == '/' {
            while i < chars.len() && at(i) != '\n' {
                i += 1;
            }
        } else if at(i) == '/' && at(i + 1) == '*' {
            let mut depth = 0;
            while i < chars.len() {
                match (at(i), at(i + 1)) {
                    ('/', '*') => (depth, i) = (depth + 1, i + 2),
                    ('*', '/') => (depth, i) = (depth - 1, i + 2),
                    _ => i += 1,
                }
                if depth == 0 {
                    break;
                }
            }
        } else if let Some(hashes) = raw {
            let end: String = std::iter::once('"').chain(std::iter::repeat_n('#', hashes)).collect();
            i += 2 + hashes;
            while i < chars.len() && !chars[i..].iter().take(1 + hashes).copied().eq(end.chars()) {
                i += 1;
            }
            i += 1 + hashes;
        } else if at(i) == '"' {
            i += 1;
            while i < chars.len() && at(i) != '"' {
                i += if at(i) == '\\' { 2 } else { 1 };
            }
            i += 1;
        } else if at(i) == '\'' && (at(i + 1) == '\\' || at(i + 2) == '\'') {
            // A character; anything else after a quote is a lifetime.
            i += if at(i + 1) == '\\' { 3 } else { 2 };
            while i < chars.len() && at(i) != '\'' {
                i += 1;
            }
            i += 1;
        } else {
            out.push(at(i));
            i += 1;
        }
    }
    out
}

/// The first segment of every path that begins with `crate::` (or, with `root`, that name), also in braces.
fn imports(code: &str, root: &str) -> Vec<String> {
    let squeezed: String =
        code.split_whitespace().collect::<Vec<_>>().join(" ").replace(" ::", "::").replace(":: ", "::");
    let mut out = Vec::new();
    for (start, _) in squeezed.match_indices(&format!("{root}::")) {
        if squeezed[..start].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '$') {
            continue;
        }
        let rest = &squeezed[start + root.len() + 2..];
        match rest.strip_prefix('{') {
            None => out.push(first_name(rest)),
            Some(list) => {
                let mut depth = 0;
                let mut item = true;
                for (i, c) in list.char_indices() {
                    match c {
                        '{' => depth += 1,
                        '}' if depth == 0 => break,
                        '}' => depth -= 1,
                        ',' if depth == 0 => item = true,
                        ' ' => {}
                        _ if item && depth == 0 => {
                            out.push(first_name(&list[i..]));
                            item = false;
                        }
                        _ => {}
                    }
                }
            }
        }
    }
    out.retain(|n| !n.is_empty());
    out
}

fn first_name(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// What is wrong in the code of a file in a crate: what it may not import. `Cargo.toml` keeps out the rest.
fn violations(room: &str, allowed: &[&str], text: &str) -> Vec<String> {
    let mut found = imports(&code_only(text), "crate");
    found.extend(imports(&code_only(text), "rederive"));
    let is_crate = |name: &String| CRATES.iter().any(|(other, _)| other == name);
    found.retain(|target| target != room && is_crate(target) && !allowed.contains(&target.as_str()));
    found
}

pub fn rust_files(path: &Path, out: &mut Vec<PathBuf>) {
    if path.is_dir() {
        for entry in fs::read_dir(path).expect("a folder can be listed") {
            rust_files(&entry.expect("an entry can be read").path(), out);
        }
    } else if path.extension().is_some_and(|e| e == "rs") {
        out.push(path.to_path_buf());
    }
}

#[test]
fn rooms_import_only_what_they_may() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut seen, mut all) = (0, Vec::new());
    for (room, allowed) in CRATES {
        let mut files = Vec::new();
        rust_files(&src.join(room), &mut files);
        let single = src.join(format!("{room}.rs"));
        if single.exists() {
            files.push(single);
        }
        seen += files.len();
        for file in files {
            let text = fs::read_to_string(&file).expect("a source file can be read");
            let found = violations(room, allowed, &text);
            if !found.is_empty() {
                all.push(format!("{}: `{room}` may not import {}", file.display(), found.join(", ")));
            }
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
    assert!(seen > 10, "only {seen} files were looked at");
}

/// Rooms that a crate names under a heading of its `Cargo.toml`.
fn named(manifest: &str, heading: &str) -> Vec<String> {
    let after = manifest.lines().skip_while(|l| l.trim() != heading).skip(1);
    let names = after.take_while(|l| !l.starts_with('[')).filter_map(|l| l.split(['.', ' ', '=']).next());
    names.filter(|n| CRATES.iter().any(|(room, _)| room == n) || n.starts_with("rederive")).map(str::to_owned).collect()
}

#[test]
fn crates_name_only_what_they_may() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let whole = fs::read_to_string(root.join("Cargo.toml")).expect("the workspace has a Cargo.toml");
    for (room, allowed) in CRATES {
        let file = root.join("src").join(room).join("Cargo.toml");
        let manifest = fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
        let name = format!("name = \"rederive-{room}\"");
        assert!(manifest.contains(&name), "src/{room}/Cargo.toml: no `{name}`");
        for heading in ["[dependencies]", "[dev-dependencies]", "[build-dependencies]"] {
            for found in named(&manifest, heading) {
                assert!(allowed.contains(&found.as_str()), "src/{room}/Cargo.toml: `{room}` may not import {found}");
            }
        }
        // As the path of the dependency, a member, and one whose tests `cargo test` runs.
        let places = whole.matches(&format!("\"src/{room}\"")).count();
        assert_eq!(places, 3, "Cargo.toml: src/{room} is a dependency, a member and a default member");
    }
    let broken = "[package]\n[dependencies]\nflow.workspace = true\nserde = \"1\"\n[features]\nnumber = []\n";
    assert_eq!(named(broken, "[dependencies]"), ["flow"]);
}

#[test]
fn every_file_is_in_a_room() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for entry in fs::read_dir(src).expect("src can be listed") {
        let name = entry.expect("an entry can be read").file_name().to_string_lossy().into_owned();
        if name.starts_with('.') {
            continue; // left by an editor or a test run
        }
        let room = CRATES.iter().any(|(room, _)| name == *room);
        assert!(room || OUTSIDE.contains(&name.as_str()), "src/{name} is no crate: add it to CRATES");
    }
}

/// Tests that no binary has are not run, and nobody would know.
#[test]
fn every_file_of_tests_is_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let all = fs::read_to_string(root.join("tests/all.rs")).expect("tests/all.rs");
    for entry in fs::read_dir(root.join("tests")).expect("tests can be listed") {
        let path = entry.expect("an entry can be read").path();
        let name = path.file_stem().and_then(|s| s.to_str()).unwrap_or_default();
        let is_module = path.extension().is_some_and(|e| e == "rs") || path.join("mod.rs").exists();
        let is_there = name == "all" || all.lines().any(|line| line == format!("mod {name};"));
        assert!(!is_module || is_there, "tests/all.rs has no line `mod {name};`: the tests of that file do not run");
    }
}

#[test]
fn a_violation_is_found() {
    let allowed = &["expr"];
    let check = |text: &str| violations("latex", allowed, text);
    assert_eq!(check("use crate::flow::Trajectory;"), ["flow"]);
    assert_eq!(check("use crate::{expr::{Expr, Graph}, report, check::Verdict as V};"), ["report", "check"]);
    assert_eq!(check("fn f(x: &crate::number::NoValue) {}"), ["number"]);
    assert_eq!(check("use crate :: flow;"), ["flow"]);
    assert_eq!(check("use crate::\n    flow;"), ["flow"]);
    assert_eq!(check("let c = '\\''; let d = '\"'; use crate::flow; // \""), ["flow"]);
    assert_eq!(check("fn f<'a>(x: &'a str) -> &'a str { crate::flow::g(x) }"), ["flow"]);
    assert_eq!(check("pub(crate) use crate::{\n  flow, // last\n};"), ["flow"]);
}

#[test]
fn what_is_no_import_is_not_found() {
    let check = |text: &str| violations("latex", &["expr"], text);
    assert!(check("use crate::expr::Expr; use crate::latex::Scope; use super::flow;").is_empty());
    assert!(
        check("// use crate::flow;\n/// [`crate::flow`]\n/* crate::flow /* crate::tape */ crate::flow */").is_empty()
    );
    assert!(check("let s = \"crate::flow \\\" crate::tape\"; let r = r#\"crate::flow \" \"#;").is_empty());
    assert!(check("use other_crate::flow; mycrate::flow();").is_empty());
}

/// How many `match`es over operations or forms still end in a wildcard: each recognises a few shapes and leaves the others alone.
/// None is to be added; where one is taken out, the number falls with it.
const MOST_RECOGNISING: usize = 84;

/// How many `matches!` name operations or forms: each is a list of a few, which another room may have to know of, too.
const MOST_MATCHING: usize = 41;

/// How many `match`es name operations, and take all others together as `Unary(..)` or `Binary(..)`.
const MOST_TOGETHER: usize = 48;

/// Files in which every operation, and every form, has to be named.
const EXHAUSTIVE: &[&str] = &[
    "src/expr/domain.rs",
    "src/expr/calculus.rs",
    "src/checker/derivative.rs",
    "src/checker/rules/sign.rs",
    "src/checker/signs.rs",
    "src/boxes/signs.rs",
    "src/proof/conditions.rs",
    "src/flow/narrow.rs",
];

/// The position after the bracket that closes the one at `open`.
fn closing(code: &[char], open: usize) -> usize {
    let mut depth = 0;
    for (i, c) in code.iter().enumerate().skip(open) {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return i + 1;
        }
    }
    code.len()
}

/// The patterns of the arms of a `match`, from what stands between its braces.
fn patterns(body: &[char]) -> Vec<String> {
    let (mut out, mut pattern, mut i) = (Vec::new(), String::new(), 0);
    while i < body.len() {
        if "([{".contains(body[i]) {
            let end = closing(body, i);
            pattern.extend(&body[i..end]);
            i = end;
        } else if body[i] == '=' && body.get(i + 1) == Some(&'>') {
            out.push(pattern.trim().trim_start_matches(',').trim().to_owned());
            pattern.clear();
            i += 2;
            while body.get(i).is_some_and(|c| c.is_whitespace()) {
                i += 1;
            }
            let block = body.get(i) == Some(&'{');
            while i < body.len() && body[i] != ',' {
                if "([{".contains(body[i]) {
                    i = closing(body, i);
                    if block {
                        break;
                    }
                } else {
                    i += 1;
                }
            }
        } else {
            pattern.push(body[i]);
            i += 1;
        }
    }
    out
}

/// Whether a text names an operation or a form. `PartialForm::` is another type.
fn names_operations(p: &str) -> bool {
    let names =
        |what: &str| p.match_indices(what).any(|(at, _)| !p[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_'));
    names("Op::") || names("Form::")
}

/// How many `matches!` over operations or forms there are.
fn lists(text: &str) -> usize {
    let code: Vec<char> = code_only(text).chars().collect();
    let word: Vec<char> = "matches!(".chars().collect();
    let starts = (0..code.len()).filter(|&i| code[i..].starts_with(&word)).map(|i| i + word.len() - 1);
    starts.filter(|&open| names_operations(&code[open..closing(&code, open)].iter().collect::<String>())).count()
}

/// How many `match`es over operations or forms have a wildcard.
fn wildcards(text: &str) -> usize {
    open_matches(text, &|all| all.iter().any(|p| p == "_" || p.starts_with("_ if ")))
}

/// How many `match`es over operations have no wildcard, and take the others together by their number of arguments.
fn together(text: &str) -> usize {
    let wild = |all: &[String]| all.iter().any(|p| p == "_" || p.starts_with("_ if "));
    open_matches(text, &|all| !wild(all) && all.iter().any(|p| p.contains("Unary(..)") || p.contains("Binary(..)")))
}

/// How many `match`es over operations or forms have patterns that are open in some way.
fn open_matches(text: &str, is_open: &dyn Fn(&[String]) -> bool) -> usize {
    let code: Vec<char> = code_only(text).chars().collect();
    let word: Vec<char> = "match ".chars().collect();
    let starts = (0..code.len()).filter(|&i| code[i..].starts_with(&word));
    let starts = starts.filter(|&i| i == 0 || !(code[i - 1].is_alphanumeric() || code[i - 1] == '_'));
    let is_wild = |start: usize| {
        let mut i = start;
        while i < code.len() && code[i] != '{' {
            i = if "([".contains(code[i]) { closing(&code, i) } else { i + 1 };
        }
        let all = patterns(
            &code[(i + 1).min(code.len())
                ..closing(&code, i.min(code.len())).saturating_sub(1).max(i + 1).min(code.len())],
        );
        all.iter().any(|p| names_operations(p)) && is_open(&all)
    };
    starts.filter(|&start| is_wild(start)).count()
}

#[test]
fn no_wildcard_stands_for_operations_or_forms() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    rust_files(&root.join("src"), &mut files);
    let (mut wrong, mut count) = (Vec::new(), 0);
    let (mut listing, mut taken_together) = (0, 0);
    for file in files {
        let name = file.strip_prefix(root).unwrap_or(&file).to_string_lossy().replace('\\', "/");
        let text = fs::read_to_string(&file).expect("a source file can be read");
        let found = wildcards(&text);
        (listing, taken_together) = (listing + lists(&text), taken_together + together(&text));
        count += found;
        if found > 0 {
            wrong.push(format!("{name}: {found}"));
        }
    }
    let named = |name: &&str| wrong.iter().all(|line: &String| !line.starts_with(*name));
    assert!(EXHAUSTIVE.iter().all(named), "name every operation and every form:\n{}", wrong.join("\n"));
    assert!(EXHAUSTIVE.iter().all(|name| root.join(name).exists()), "a file has moved");
    assert!(count <= MOST_RECOGNISING, "{count} wildcards over operations or forms:\n{}", wrong.join("\n"));
    assert!(listing <= MOST_MATCHING, "{listing} `matches!` over operations or forms: ask the table of domains");
    assert!(taken_together <= MOST_TOGETHER, "{taken_together} matches that take operations together: ask the table");
    assert_eq!(lists("matches!(op, Op::Sin | Op::Cos) && matches!(kind, Kind::A)"), 1);
    assert_eq!(together("match n { Node::Unary(Op::Sin, a) => 1, Node::Unary(..) | Node::Binary(..) => 2 }"), 1);
    assert_eq!(wildcards("match op { Op::Sin => 1, _ => 2 }"), 1);
    assert_eq!(wildcards("match f { Form::Always(w) if a => { g(w) } _ => {} }"), 1);
    assert_eq!(wildcards("match op { Op::Sin => match x { A => 1, _ => 2 }, Op::Cos => { 2 } }"), 0);
    assert_eq!(wildcards("match (op, a) { (Op::Neg, _) => 1, (Op::Sin, b) => 2 }"), 0);
}
