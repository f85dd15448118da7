//! The pages for those who change the program are true: files that they name are there, and what they say of crates is so.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(name: &str) -> String {
    fs::read_to_string(root().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// Targets of the links of a page that lead into the project.
fn links(page: &str) -> Vec<String> {
    let targets = page.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    targets.filter(|t| !t.contains("://")).map(|t| t.split('#').next().unwrap_or(t).to_owned()).collect()
}

#[test]
fn files_that_are_named_exist() {
    for (page, least) in [("ARCHITECTURE.md", 40), ("CONTRIBUTING.md", 20)] {
        let found = links(&read(page));
        assert!(found.len() > least, "{page}: {}", found.len());
        for target in found {
            assert!(root().join(&target).exists(), "{page}: `{target}` is not there");
        }
    }
    assert_eq!(links("see [a](src/a.rs#l1), [b](https://b.c/d)"), ["src/a.rs"]);
}

/// Rows of the map: the crate, and what it uses.
fn map() -> BTreeMap<String, BTreeSet<String>> {
    let page = read("ARCHITECTURE.md");
    let rows = page.lines().filter_map(|line| line.strip_prefix("| [`src/"));
    rows.filter_map(|row| {
        let name = row.split('`').next()?.to_owned();
        let uses = row.split(" | ").nth(2)?;
        Some((name, uses.split(", ").filter(|u| *u != "–").map(str::to_owned).collect()))
    })
    .collect()
}

#[test]
fn the_map_is_that_of_the_crates() {
    let map = map();
    let mut seen = 0;
    for entry in fs::read_dir(root().join("src")).expect("src can be listed") {
        let folder = entry.expect("an entry can be read").path();
        let Ok(manifest) = fs::read_to_string(folder.join("Cargo.toml")) else { continue };
        let name = folder.file_name().and_then(|n| n.to_str()).expect("a name").to_owned();
        let after = manifest.lines().skip_while(|l| *l != "[dependencies]").skip(1).take_while(|l| !l.starts_with('['));
        let named: BTreeSet<String> = after.filter_map(|l| l.split(['.', ' ']).next()).map(str::to_owned).collect();
        let uses: BTreeSet<String> =
            named.into_iter().filter(|n| !n.is_empty() && root().join("src").join(n).exists()).collect();
        let stated = map.get(&name).unwrap_or_else(|| panic!("ARCHITECTURE.md: no row for src/{name}"));
        assert_eq!(*stated, uses, "ARCHITECTURE.md: what src/{name} uses");
        seen += 1;
    }
    assert!(seen > 8, "{seen}");
}

#[test]
fn the_walk_names_what_is_there() {
    // The claim that is followed is one of the file, and each step names files in the order of the crates.
    let page = read("ARCHITECTURE.md");
    let claim = page.split("\n`always = ['").nth(1).and_then(|t| t.split("']`").next()).expect("a claim");
    assert!(read("derivations/pendulum.toml").contains(&format!("always = ['{claim}']")), "{claim}");
}

#[test]
fn short_names_are_commands() {
    let config = read(".cargo/config.toml");
    let section =
        config.split_once("[alias]").and_then(|(_, rest)| rest.split("\n[").next()).expect("there are short names");
    let names: Vec<&str> = section.lines().filter_map(|l| l.split_once(" = \"").map(|(name, _)| name)).collect();
    assert!(names.len() > 2, "{names:?}");
    let page = read("CONTRIBUTING.md");
    for name in names {
        assert!(page.contains(&format!("cargo {name}")), "CONTRIBUTING.md does not name `cargo {name}`");
    }
}

/// Most files of `src` that each recipe with a toy takes.
const MOST_FILES: &[(&str, usize)] = &[
    ("a-form-of-claim", 4),
    ("a-function-symbol", 2),
    ("a-number-type", 2),
    ("a-way-to-find-evidence", 3),
    ("an-operation", 9),
    ("an-output-format", 3),
];

/// The files of a patch, each with its hunks: the lines before it, and those after. A file that is new has no lines before.
fn patched(patch: &str) -> Vec<(String, Vec<[String; 2]>)> {
    let mut out: Vec<(String, Vec<[String; 2]>)> = Vec::new();
    for line in patch.lines().filter(|line| !line.starts_with("--- ")) {
        if let Some(file) = line.strip_prefix("+++ b/") {
            out.push((file.to_owned(), Vec::new()));
            continue;
        }
        let hunks = &mut out.last_mut().expect("a file").1;
        if line.starts_with("@@ ") {
            hunks.push([String::new(), String::new()]);
            continue;
        }
        let [before, after] = hunks.last_mut().expect("a hunk");
        let (mark, text) = line.split_at(1);
        for (side, other) in [(before, "+"), (after, "-")] {
            if mark != other {
                *side += &format!("{text}\n");
            }
        }
    }
    out
}

/// `tests/recipes/run` does them; here it is counted what they take, and seen that they still fit.
#[test]
fn recipes_take_as_many_files_as_they_say() {
    let page = read("CONTRIBUTING.md");
    let patches = fs::read_dir(root().join("tests/recipes")).expect("the recipes can be listed").filter_map(|entry| {
        let name = entry.expect("an entry can be read").file_name().into_string().expect("a name");
        name.strip_suffix(".patch").map(str::to_owned)
    });
    assert_eq!(patches.collect::<BTreeSet<_>>(), MOST_FILES.iter().map(|(name, _)| (*name).to_owned()).collect());
    for (name, most) in MOST_FILES {
        let found = patched(&read(&format!("tests/recipes/{name}.patch")));
        let files: BTreeSet<&str> = found.iter().map(|(file, _)| file.as_str()).collect();
        assert_eq!(files.len(), *most, "{name}: {files:?}");
        let title = name.replace('-', " ");
        let section = page.split("\n### ").find(|s| s.to_lowercase().starts_with(&title)).expect("a section");
        let named = links(section);
        let sources: Vec<&String> = named.iter().filter(|n| n.starts_with("src/")).collect();
        // The first file of a crate stands for what is in it: on the site, links lead to files.
        let is_of = |file: &str, named: &str| {
            let folder = named.strip_suffix("lib.rs");
            file == named || folder.is_some_and(|folder| file.starts_with(folder))
        };
        for (file, hunks) in &found {
            assert!(sources.iter().any(|n| is_of(file, n)), "CONTRIBUTING.md, {title}: {file} is not named");
            if hunks.iter().all(|[before, _]| before.is_empty()) {
                assert!(!root().join(file).exists(), "{name}: {file} is there already");
                continue;
            }
            let text = read(file);
            for [before, _] in hunks {
                assert_eq!(text.matches(before).count(), 1, "{name}: {file} has not, or more than once,\n{before}");
            }
        }
        // What the recipe says that it takes: no other file of the sources.
        for source in sources {
            assert!(files.iter().any(|file| is_of(file, source)), "CONTRIBUTING.md, {title}: {source} is not needed");
        }
    }
}

/// Lines of code of a file, without those of its tests.
fn code(text: &str) -> usize {
    let lines = text.lines().take_while(|l| *l != "#[cfg(test)]").map(str::trim_start);
    lines.filter(|l| !l.is_empty() && !l.starts_with("//")).count()
}

#[test]
fn front_ends_are_thin() {
    let page = read("CONTRIBUTING.md");
    let table = page.split("| front end |").nth(1).and_then(|rest| rest.split("\n\n").next()).expect("the table");
    let mut seen = 0;
    for target in links(table) {
        let folder = root().join(&target).parent().expect("a folder").to_path_buf();
        let files = fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("an entry").path());
        let rust = files.filter(|path| path.extension().is_some_and(|e| e == "rs"));
        let lines: usize = rust.map(|path| code(&fs::read_to_string(path).expect("a file"))).sum();
        assert!((20..=280).contains(&lines), "{target}: {lines} lines");
        seen += 1;
    }
    assert_eq!(seen, 4);
    assert_eq!(code("//! a\nlet b;\n\n    // c\n    d\n#[cfg(test)]\ne"), 2);
}
