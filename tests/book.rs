//! The documentation as a site: every page is in its contents, links lead somewhere, and its tables are those of the reports.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde_json::Value;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The pages of `docs/`, by name.
fn pages() -> BTreeMap<String, String> {
    let mut out = BTreeMap::new();
    for entry in std::fs::read_dir(root().join("docs")).expect("docs can be listed") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        if name.ends_with(".md") {
            out.insert(name, read(&path));
        }
    }
    out
}

/// The text without blocks and spans of code.
fn prose(page: &str) -> String {
    let mut inside = false;
    let mut out = String::new();
    for line in page.lines() {
        if line.trim_start().starts_with("```") {
            inside = !inside;
        } else if !inside {
            out.extend(line.split('`').step_by(2));
        }
        out.push('\n');
    }
    out
}

/// (what is shown, where it leads) of each link.
fn links(page: &str) -> Vec<(String, String)> {
    let text = prose(page).replace('\n', " ");
    let mut out = Vec::new();
    for (at, _) in text.match_indices("](") {
        let shown = text[..at].rsplit('[').next().unwrap_or_default().to_owned();
        if let Some((target, _)) = text[at + 2..].split_once(')') {
            out.push((shown, target.to_owned()));
        }
    }
    out
}

/// The anchors of a page: of its headings.
fn anchors(page: &str) -> BTreeSet<String> {
    let mut inside = false;
    let mut out = BTreeSet::new();
    for line in page.lines() {
        inside ^= line.trim_start().starts_with("```");
        if !inside && line.starts_with('#') {
            let words = line.trim_start_matches('#').trim().to_lowercase();
            let kept = words.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
            out.insert(kept.map(|c| if c == ' ' { '-' } else { c }).collect());
        }
    }
    out
}

#[test]
fn the_contents_are_complete() {
    let mut pages = pages();
    let contents = pages.remove("SUMMARY.md").expect("docs/SUMMARY.md");
    let entries = links(&contents);
    let listed: BTreeSet<&str> = entries.iter().map(|(_, target)| target.as_str()).collect();
    assert_eq!(listed.len(), entries.len(), "a page is listed twice");
    assert_eq!(listed, pages.keys().map(String::as_str).collect());
    for (title, target) in &entries {
        let heading = pages[target].lines().next().unwrap_or_default().trim_start_matches('#').trim();
        assert_eq!(title, heading, "docs/{target}");
    }
}

/// Links of a file that lead nowhere.
fn broken(file: &Path, text: &str) -> Vec<String> {
    let mut out = Vec::new();
    for (shown, target) in links(text) {
        // A package has neither reports nor the sources for Python.
        let left_out = |folder: &str| target.starts_with(&format!("../{folder}/")) && !root().join(folder).exists();
        if target.contains("://") || target.starts_with("mailto:") || left_out("reports") || left_out("python") {
            continue;
        }
        let (path, anchor) = target.split_once('#').unwrap_or((&target, ""));
        let path = if path.is_empty() { file.to_owned() } else { file.with_file_name(path) };
        if !path.exists() {
            out.push(format!("{}: [{shown}]({target}): there is no such file", file.display()));
        } else if !anchor.is_empty() && !anchors(&read(&path)).contains(anchor) {
            out.push(format!("{}: [{shown}]({target}): there is no such heading", file.display()));
        }
    }
    out
}

#[test]
fn links_lead_somewhere() {
    let mut files: Vec<PathBuf> = pages().keys().map(|name| root().join("docs").join(name)).collect();
    files.extend(["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"].map(|name| root().join(name)));
    let all: Vec<(PathBuf, String)> = files.into_iter().map(|f| (f.clone(), read(&f))).collect();
    let wrong: Vec<String> = all.iter().flat_map(|(file, text)| broken(file, text)).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let seen: usize = all.iter().map(|(_, text)| links(text).len()).sum();
    assert!(seen > 60, "{seen}");
    let file = root().join("docs/made-up.md");
    let text =
        "[a](units.md) [b](nowhere.md) [c](units.md#nowhere) `[d](nowhere.md)` [e](https://x)\n```\n[f](no.md)\n```\n";
    assert_eq!(broken(&file, text).len(), 2);
}

/// The rows of the tables of a page, below their heads.
fn rows(page: &str) -> Vec<Vec<String>> {
    let cells = |line: &str| line.trim().trim_matches('|').split('|').map(|c| c.trim().to_owned()).collect();
    page.lines().filter(|l| l.starts_with('|') && !l.starts_with("|--")).skip(1).map(cells).collect()
}

fn report(id: &str) -> Option<Value> {
    let text = std::fs::read_to_string(root().join("reports").join(id).join("report.json")).ok()?;
    Some(serde_json::from_str(&text).expect("the report is JSON"))
}

#[test]
fn what_it_catches_is_in_the_reports() {
    let page = pages().remove("catches.md").expect("docs/catches.md");
    let rows = rows(&page);
    assert!(rows.len() >= 10);
    for row in rows {
        let [id, claim, _, motions, correction] = &row[..] else { panic!("{row:?}") };
        let (id, claim) = (id.trim_matches('`'), claim.trim_matches('`'));
        // A package without the committed reports has nothing to compare.
        let Some(report) = report(id) else { continue };
        let (name, reading) = claim.split_once('/').map_or((claim, None), |(n, r)| (n, Some(r)));
        let claims = report["claims"].as_array().expect("claims");
        let found = claims.iter().find(|c| c["id"] == *name && c["reading"].as_str() == reading);
        let found = found.unwrap_or_else(|| panic!("{id} has no claim {claim}"));
        let fails: Vec<&Value> =
            found["results"].as_array().expect("results").iter().filter(|r| r["verdict"] == "fails").collect();
        let region = &found["region"];
        if region.is_object() {
            let without = region["ranges"].as_array().is_some_and(Vec::is_empty);
            assert_eq!(if without { "fields" } else { "ranges" }, motions, "{id}: {claim}");
            assert_eq!((region["verdict"].as_str(), region["strength"].as_str()), (Some("fails"), Some("certified")));
            continue;
        }
        assert_eq!(fails.len().to_string(), *motions, "{id}: {claim}");
        assert!(fails.iter().all(|r| r["strength"] != "sampled"), "{id}: {claim} fails by samples alone");
        let corrections = found["variants"]["erratum"]["corrections"].as_array().map_or(0, Vec::len);
        assert_eq!(correction == "yes", corrections > 0, "{id}: {claim}");
    }
}

#[test]
fn the_gallery_has_every_derivation() {
    let page = pages().remove("gallery.md").expect("docs/gallery.md");
    let listed: BTreeSet<String> = links(&page).into_iter().map(|(_, target)| target).collect();
    for entry in std::fs::read_dir(root().join("derivations")).expect("derivations can be listed") {
        let path = entry.expect("an entry").path();
        let id = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        assert!(listed.contains(&format!("../derivations/{id}.toml")), "{id} is not in the gallery");
        let Some(report) = report(&id) else { continue };
        let row = rows(&page).into_iter().find(|r| r[0].starts_with(&format!("[{id}]"))).expect("a row");
        let counts = ["claims", "trajectories"].map(|key| report[key].as_array().map_or(0, Vec::len).to_string());
        assert_eq!(row[2..4], counts, "{id}");
    }
}

/// The files of Rust below a folder, as paths from the root of the project.
fn sources(folder: &str) -> Vec<String> {
    let mut out = Vec::new();
    let mut todo = vec![root().join(folder)];
    while let Some(folder) = todo.pop() {
        for entry in std::fs::read_dir(&folder).expect("a room can be listed") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                todo.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let name = path.strip_prefix(root()).expect("below the root");
                out.push(name.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    out.sort();
    out
}

/// Every file of the engines has its place in the reading guide: by its name, or with its whole room.
#[test]
fn the_reading_guide_names_every_file_that_a_verdict_rests_on() {
    let page = read(&root().join("docs/soundness.md"));
    let named: BTreeSet<String> =
        links(&page).into_iter().filter_map(|(_, target)| target.strip_prefix("../").map(str::to_owned)).collect();
    // What only gathers a crate, holds data, or is compiled for tests.
    let other = [
        "lib.rs",
        "tests.rs",
        "model_tests.rs",
        "faults.rs",
        "hash.rs",
        "random.rs",
        "sample.rs",
        "syntax.rs",
        "name.rs",
    ];
    let whole = ["src/latex/parse/", "src/latex/elaborate/", "src/weight/", "src/derivation/", "src/checker/tests/"];
    let rooms = [
        "src/verdict",
        "src/number",
        "src/expr",
        "src/latex",
        "src/derivation",
        "src/flow",
        "src/checker",
        "src/proof",
        "src/claim",
        "src/proved",
        "src/boxes",
        "src/sampled",
        "src/enclosed",
        "src/families",
        "src/weight",
        "src/findings",
        "src/check",
    ];
    let missing: Vec<String> = rooms
        .iter()
        .flat_map(|room| sources(room))
        .filter(|file| !named.contains(file) && !whole.iter().any(|room| file.starts_with(room)))
        .filter(|file| !other.iter().any(|name| file.ends_with(&format!("/{name}"))))
        .collect();
    assert!(missing.is_empty(), "docs/soundness.md does not name {missing:?}");
}

/// Lines of Rust that are neither empty nor comments, without what is compiled for tests only.
fn lines_of_code(folder: &Path) -> usize {
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("sources can be listed") {
        let path = entry.expect("an entry").path();
        if path.is_dir() && !path.ends_with("tests") {
            count += lines_of_code(&path);
        }
        if path.extension().is_some_and(|e| e == "rs") {
            let text = read(&path);
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            count += code.lines().map(str::trim).filter(|l| !l.is_empty() && !l.starts_with("//")).count();
        }
    }
    count
}

#[test]
fn what_a_recorded_proof_rests_on_is_small() {
    let [checker, kernel] = ["src/checker", "src/verdict"].map(|folder| lines_of_code(&root().join(folder)));
    assert!(checker > 1_000 && kernel > 300, "{checker}, {kernel}");
    assert!(checker + kernel <= 4_500, "{checker} + {kernel} lines of code");
}
