//! What the README and the page on the method say is true of this version.

use std::path::Path;
use std::process::Command;

use rederive::check::{Options, check};
use rederive::derivation::load;
use rederive::diag::render;
use serde_json::Value;

fn read(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The text after `<!-- name -->`, up to the end of its code block or table.
fn part(page: &str, name: &str) -> String {
    let marker = format!("<!-- {name} -->\n");
    let (_, after) = page.split_once(&marker).unwrap_or_else(|| panic!("{marker} is missing"));
    let block = after.strip_prefix("```").and_then(|b| b.split_once('\n')).map(|(_, body)| body);
    let (body, end) = block.map_or((after, "<!-- end -->"), |body| (body, "```"));
    body.split_once(end).unwrap_or_else(|| panic!("{name} has no end")).0.to_owned()
}

/// The cells of the rows of a table, its head and the line below apart; the head first.
fn table(text: &str) -> Vec<Vec<String>> {
    let row = |line: &str| -> Vec<String> {
        line.trim().trim_matches('|').split('|').map(|c| c.trim().trim_matches('`').to_owned()).collect()
    };
    let rows: Vec<&str> = text.lines().filter(|l| l.starts_with('|') && !l.starts_with("|---")).collect();
    rows.into_iter().map(row).collect()
}

/// The committed report on the Comment, or a fresh one where none is there.
fn report() -> Value {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let committed = root.join("reports/deriglazov-comment/report.json");
    let text = std::fs::read_to_string(committed).unwrap_or_else(|_| {
        let path = root.join("derivations/deriglazov-comment.toml");
        let derivation = load(&path).unwrap_or_else(|found| panic!("{}", render(&found, false)));
        let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
        rederive::report::json(&derivation, &account)
    });
    serde_json::from_str(&text).expect("the report is JSON")
}

fn array<'a>(value: &'a Value, key: &str) -> &'a Vec<Value> {
    value[key].as_array().unwrap_or_else(|| panic!("`{key}` is no array"))
}

#[test]
fn the_matrix_is_that_of_the_report() {
    let report = report();
    let rows = table(&part(&read("README.md"), "matrix"));
    let motions = &rows[0][2..];
    assert_eq!(motions.len(), 5);
    let mut cells = 0;
    for row in &rows[1..] {
        let (id, reading) = row[1].split_once('/').map_or((row[1].as_str(), None), |(i, r)| (i, Some(r)));
        let claim = array(&report, "claims").iter().find(|c| c["id"] == *id && c["reading"].as_str() == reading);
        let claim = claim.unwrap_or_else(|| panic!("the report has no claim {}", row[1]));
        for (motion, cell) in motions.iter().zip(&row[2..]) {
            let result = array(claim, "results").iter().find(|r| r["trajectory"] == *motion);
            let found = match result.and_then(|r| r["verdict"].as_str()) {
                Some("holds") => "H",
                Some("fails") => "F",
                Some("not-applicable") => "–",
                Some("undecided") => "?",
                Some(other) => panic!("{other} is no verdict"),
                None => "",
            };
            assert_eq!(cell, found, "{} on {motion}", row[1]);
            cells += usize::from(!found.is_empty());
        }
    }
    assert!(cells > 50, "{cells}");
    let count = array(&report, "trajectories").len();
    assert!(read("README.md").contains(&format!("five of the {count} motions")), "there are {count} motions");
}

#[test]
fn the_measured_values_are_those_of_the_report() {
    let report = report();
    let rows = table(&part(&read("README.md"), "measured"));
    assert!(rows.len() > 4);
    for row in &rows[1..] {
        let found = array(&report, "measurements")
            .iter()
            .find(|m| m["trajectory"] == row[1] && m["measure"] == row[2])
            .unwrap_or_else(|| panic!("{} is not measured on {}", row[2], row[1]));
        let value = found["values"][0]["value"].as_f64().expect("a number");
        let number = row[3].split(' ').next().unwrap_or_default();
        let digits = number.split_once('.').map_or(0, |(_, d)| d.len());
        let shown = format!("{value:.digits$}");
        assert_eq!(number, shown.strip_prefix('-').filter(|_| value.abs() < 1e-9).unwrap_or(&shown), "{row:?}");
    }
}

fn run(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    let output = command.current_dir(folder).env("NO_COLOR", "1").args(arguments).output().expect("the program runs");
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
}

#[test]
fn the_example_prints_what_it_is_said_to_print() {
    let page = read("README.md");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let save = |text: &str| std::fs::write(folder.path().join("larmor.toml"), text).expect("a file can be written");
    let command = "cargo run --release -- check larmor.toml --no-reports\n";
    assert!(page.contains(command));

    let example = part(&page, "example");
    save(&example);
    let (code, output) = run(folder.path(), &["check", "larmor.toml", "--no-reports"]);
    assert_eq!(output, part(&page, "output"), "the README shows another output; the program prints\n{output}");
    assert_eq!(code, Some(1));

    // What it says about the repair, and about expectations.
    save(&format!("{example}{}", part(&page, "repair")));
    let (code, output) = run(folder.path(), &["check", "larmor.toml", "--no-reports", "--matrix"]);
    assert_eq!(code, Some(0), "{output}");
    assert!(output.contains("radius            H -"), "{output}");
    let expectation = "expect = { holds = [\"circle\"], fails = [\"helix\"] }";
    assert!(page.contains(expectation));
    save(&format!("{example}{expectation}\n"));
    assert_eq!(run(folder.path(), &["check", "larmor.toml", "--no-reports"]).0, Some(0));
    let (code, output) = run(folder.path(), &["explain", "radius", "larmor.toml"]);
    assert!(code.is_some_and(|c| c < 2) && output.contains("helix  fails"), "{output}");
}

#[test]
fn the_exit_codes_are_those_of_the_program() {
    let page = read("README.md");
    let (_, help) = run(Path::new(env!("CARGO_MANIFEST_DIR")), &["check", "--help"]);
    for code in ["0", "1", "2", "3", "70"] {
        assert!(page.lines().any(|l| l.starts_with(&format!("| {code} | "))), "{code} is not in the README");
        assert!(help.lines().any(|l| l.trim_start().starts_with(&format!("{code} "))), "{code} is not in the help");
    }
}

#[test]
fn the_workflow_uses_what_the_action_has() {
    let (workflow, action) = (part(&read("README.md"), "workflow"), read("action.yml"));
    assert!(workflow.lines().count() <= 10, "ten lines to copy");
    assert!(workflow.contains("with: { files: ") && action.contains("\n  files:\n"));
    let sarif = workflow.split("sarif_file: ").nth(1).and_then(|t| t.split(' ').next()).expect("a file");
    assert!(action.contains(&format!("default: {sarif}\n")), "{sarif} is not what the action writes");
}

/// What a forge calls a heading: its letters, digits and hyphens in lower case, spaces as hyphens.
fn anchor(heading: &str) -> String {
    let text = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = text.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn links_lead_somewhere() {
    let pages = ["docs/continuous-integration.md", "docs/stability.md", "docs/schema.md"];
    for page in ["README.md", "CHANGELOG.md", "docs/method.md", "docs/derivation-file.md"].into_iter().chain(pages) {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = root.join(page);
        let folder = folder.parent().expect("a page lies in a folder");
        let text = read(page);
        for target in text.split("](").skip(1).filter_map(|t| t.split_once(')').map(|(t, _)| t)) {
            if target.contains("://") {
                continue;
            }
            let (file, heading) = target.split_once('#').unwrap_or((target, ""));
            let path = if file.is_empty() { root.join(page) } else { folder.join(file) };
            assert!(path.exists(), "{page}: there is no {file}");
            if !heading.is_empty() {
                let text = std::fs::read_to_string(path).expect("a page can be read");
                let found = text.lines().filter(|l| l.starts_with('#')).any(|l| anchor(l) == heading);
                assert!(found, "{page}: {file} has no heading for #{heading}");
            }
        }
    }
}

#[test]
fn files_that_are_named_are_there() {
    for page in ["README.md", "CHANGELOG.md", "docs/method.md"] {
        for name in read(page).split('`').skip(1).step_by(2) {
            let local = ["tests/", "derivations/", "docs/", "src/"].iter().any(|f| name.starts_with(f));
            assert!(!local || Path::new(env!("CARGO_MANIFEST_DIR")).join(name).exists(), "{page}: there is no {name}");
        }
    }
}

#[test]
fn the_constants_of_the_method_are_those_of_the_source() {
    let rows: Vec<_> =
        table(&read("docs/method.md")).into_iter().filter(|r| r.len() == 3 && r[2].ends_with(".rs")).collect();
    assert!(rows.len() > 5, "{rows:?}");
    for row in rows {
        let source = read(&row[2]);
        let defined = source.lines().any(|l| {
            let value = l.split_once(" = ").and_then(|(_, v)| v.strip_suffix(';'));
            l.contains(&format!("const {}:", row[0])) && value == Some(row[1].as_str())
        });
        assert!(defined, "{} = {} is not in {}", row[0], row[1], row[2]);
    }
}
