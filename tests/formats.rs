//! Formats for machines: what they say, where it goes, and that their readers can read it.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;
use serde_json::Value;

use crate::formats_support::{commands, junit, sarif, xml};

/// One claim of every kind: expected or not, with characters that every format must escape.
const FILE: &str = r#"
[derivation]
title = "Decay & <growth>"
concerns = "A textbook, 100% right"

[symbols]
't' = { role = "time" }
'x' = { role = "state" }

[system.decay]
states = ['x']
equations = ['\dot x=-x']

[[trajectory]]
id = "slow"
system = "decay"
initial = { 'x' = 1.5 }
span = [0, 2]

[[trajectory]]
id = "negative"
system = "decay"
initial = { 'x' = -1 }
span = [0, 2]

[[claim]]
id = "law"
says = "the rate is −x, as {x} & \"x\" are < [y]"
always = ['\dot x=-x']

[[claim]]
id = "wrong"
says = "the rate is x: 100%, always"
always = ['x=x', '\frac{\dot x}{1}=x']

[[claim]]
id = "wrong-on-purpose"
says = "the rate is x"
always = ['\dot x=x']
expect = "fails"

[[claim]]
id = "better-than-expected"
says = "𝒳: the rate is −x"
always = ['\dot x=-x']
expect = { fails = ["slow"] }

[[claim]]
id = "positive"
says = "a logarithm"
assuming = ['x>0']
always = ['\ln x\le 1']

[[claim]]
id = "never"
says = "x tends to 0"
always = ['\lim_{t\rightarrow\infty}x=0']

[[claim]]
id = "never-expected"
says = "x tends to 1"
always = ['\lim_{t\rightarrow\infty}x=1']
expect = "undecided"
"#;

fn project(text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::create_dir(folder.path().join("derivations")).expect("a folder can be made");
    fs::write(folder.path().join("derivations/decay.toml"), text).expect("a file can be written");
    folder
}

fn rederive(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    command.current_dir(folder).env_remove("CLICOLOR_FORCE").args(arguments).assert()
}

/// What a run prints in a format.
fn printed(folder: &Path, format: &str, code: i32) -> String {
    // Samples alone leave something open.
    printed_with(folder, "sampled", format, code)
}

fn printed_with(folder: &Path, rigor: &str, format: &str, code: i32) -> String {
    let run = rederive(folder, &["check", "--no-reports", "--rigor", rigor, "--format", format]).code(code);
    String::from_utf8(run.get_output().stdout.clone()).expect("this is UTF-8")
}

/// Rule, level and the text at its place, of every result.
fn results(text: &str, file: &str) -> Vec<(String, String, String)> {
    let lines: Vec<&str> = file.lines().collect();
    let of = |r: &Value| {
        let region = &r["locations"][0]["physicalLocation"]["region"];
        let at = |key: &str| usize::try_from(region[key].as_u64().unwrap_or(1)).expect("small") - 1;
        let line: Vec<u16> = lines[at("startLine")].encode_utf16().collect();
        let part = String::from_utf16(&line[at("startColumn")..at("endColumn").max(at("startColumn"))]).expect("whole");
        (r["ruleId"].as_str().unwrap_or_default().into(), r["level"].as_str().unwrap_or_default().into(), part)
    };
    sarif(text).unwrap_or_else(|e| panic!("{e}\n{text}")).iter().map(of).collect()
}

#[test]
fn sarif_has_what_is_not_as_expected_with_its_place() {
    let project = project(FILE);
    let text = printed(project.path(), "sarif", 1);
    let found = results(&text, FILE);
    let found: Vec<(&str, &str, &str)> = found.iter().map(|(a, b, c)| (a.as_str(), b.as_str(), c.as_str())).collect();
    assert_eq!(
        found,
        [
            ("verdict::fails", "error", r"\frac{\dot x}{1}=x"),
            ("verdict::holds", "error", r"\dot x=-x"),
            ("verdict::drawn", "note", r"\ln x\le 1"),
            ("verdict::undecided", "warning", r"\lim_{t\rightarrow\infty}x=0"),
        ]
    );
    assert!(text.contains("\"uri\": \"derivations/decay.toml\""));
    assert!(!text.contains(&project.path().display().to_string()), "no path outside the project");
}

/// A text with the first fix of a log in it.
fn mended(log: &str, text: &str) -> String {
    let found = sarif(log).expect("valid");
    let fix = found.iter().find_map(|r| r["fixes"].get(0)).expect("a fix");
    let replacement = &fix["artifactChanges"][0]["replacements"][0];
    let at =
        |key: &str| usize::try_from(replacement["deletedRegion"][key].as_u64().expect("a place")).expect("small") - 1;
    assert_eq!(at("startLine"), at("endLine"));
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let line: Vec<u16> = lines[at("startLine")].encode_utf16().collect();
    let part = |units: &[u16]| String::from_utf16(units).expect("whole");
    let inserted = replacement["insertedContent"]["text"].as_str().expect("a text");
    lines[at("startLine")] = part(&line[..at("startColumn")]) + inserted + &part(&line[at("endColumn")..]);
    lines.join("\n") + "\n"
}

#[test]
fn a_fix_makes_right_what_was_wrong() {
    let wrong = FILE.split("[[claim]]").next().expect("a head").to_owned()
        + "[[claim]]\nid = \"solved\"\nsays = \"𝒳 decays\"\nalways = ['x=x(0)e^{t}']\n";
    let text = printed(project(&wrong).path(), "sarif", 1);
    let right = mended(&text, &wrong);
    assert!(right.contains(r"'x=x(0)e^{-t}'"), "{right}");
    printed(project(&right).path(), "sarif", 0);
    let paper = "𝒳 \\(u\\)\n\\begin{align}\n (a+b)^2 &= a^2+2ab+b^2 \\\\\n &= a^2+b(3a+b).\n\\end{align}\n";
    let folder = tempfile::tempdir().expect("a folder");
    let lint = |text: &str, code: i32| {
        fs::write(folder.path().join("a.tex"), text).expect("written");
        let mut run = Command::cargo_bin("rederive").expect("the program");
        let run = run.current_dir(folder.path()).args(["lint", "a.tex", "--format", "sarif"]).assert().code(code);
        String::from_utf8(run.get_output().stdout.clone()).expect("text")
    };
    let right = mended(&lint(paper, 1), paper);
    assert!(right.contains("a^2+b(2a+b)."), "{right}");
    lint(&right, 0);
}

#[test]
fn fingerprints_stay_when_lines_move_and_numbers_change() {
    let prints = |file: &str| -> Vec<(Value, Value)> {
        let text = printed(project(file).path(), "sarif", 1);
        let found = sarif(&text).expect("valid");
        found.iter().map(|r| (r["partialFingerprints"].clone(), r["locations"].clone())).collect()
    };
    let first = prints(FILE);
    let moved = prints(&FILE.replace("[symbols]", "# one\n# two\n\n[symbols]").replace("'x' = 1.5", "'x' = 1.25"));
    assert_eq!(first.len(), moved.len());
    for (a, b) in first.iter().zip(&moved) {
        assert_eq!(a.0, b.0);
        assert_ne!(a.1, b.1, "the place has moved");
    }
    let other = prints(&FILE.replace("id = \"wrong\"", "id = \"wrong-too\""));
    assert_ne!(first[0].0, other[0].0, "another claim is another finding");
    assert_eq!(
        first[1..].iter().map(|f| &f.0).collect::<Vec<_>>(),
        other[1..].iter().map(|f| &f.0).collect::<Vec<_>>()
    );
}

#[test]
fn a_validator_that_says_yes_to_everything_would_be_noticed() {
    let text = printed(project(FILE).path(), "sarif", 1);
    for (from, to) in [
        ("\"version\": \"2.1.0\"", "\"version\": \"2.0.0\""),
        ("\"ruleIndex\": 0", "\"ruleIndex\": 1"),
        ("\"startLine\": ", "\"startLine\": -"),
        ("primaryLocationLineHash", "lineHash"),
        ("\"level\": \"error\"", "\"level\": \"bad\""),
        ("derivations/decay.toml", "derivations/a decay.toml"),
        ("`wrong` ", "`wrong` {0} "),
        ("`wrong` ", "`wrong` [there](7) "),
    ] {
        assert!(text.contains(from), "{from}");
        assert!(sarif(&text.replace(from, to)).is_err(), "{from} → {to} is not noticed");
    }
    let text = printed(project(FILE).path(), "junit", 1);
    for (from, to) in [
        ("</testcase>", ""),
        ("&amp;", "&"),
        ("<failure ", "<mistake "),
        ("classname=\"decay.", "class=\"decay."),
        ("tests=\"14\"", "tests=\"13\""),
    ] {
        assert!(text.contains(from), "{from}\n{text}");
        assert!(junit(&text.replace(from, to)).is_err(), "{from} → {to} is not noticed");
    }
}

#[test]
fn junit_has_every_pair_and_unknown_is_no_pass() {
    let project = project(FILE);
    let text = printed(project.path(), "junit", 1);
    let [tests, failures, errors, skipped] = junit(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    // wrong ×2 and better-than-expected on one; never ×2; never-expected ×2 and positive where x<0.
    assert_eq!([tests, failures, errors, skipped], [14, 3, 2, 3]);
    let root = xml(&text).expect("well-formed");
    let case = root.children[0].all("testcase").find(|c| c.attribute("classname") == "decay.wrong").expect("there");
    let failure = case.all("failure").next().expect("it fails");
    assert!(failure.text.contains(r"\frac{\dot x}{1}=x"), "{}", failure.text);
    assert!(failure.text.contains("Holds instead: "), "{}", failure.text);
    assert!(!text.contains("timestamp") && !text.contains(" time="), "no clock");
}

#[test]
fn annotations_can_be_read_back() {
    let project = project(FILE);
    let text = printed(project.path(), "github", 1);
    let found = commands(&text).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(found.iter().map(|c| c.kind.as_str()).collect::<Vec<_>>(), ["error", "error", "notice", "warning"]);
    let line = FILE.lines().position(|l| l.contains(r"\frac{\dot x}{1}=x")).expect("there") + 1;
    assert_eq!(found[0].properties["line"], line.to_string());
    assert_eq!(found[0].properties["file"], "derivations/decay.toml");
    assert!(found[0].message.contains("100%, always"), "{}", found[0].message);
    assert!(found[0].properties["title"].contains("verdict::fails: "));
}

#[test]
fn several_formats_at_once_and_the_summary_stays() {
    let project = project(FILE);
    let read = |name: &str| fs::read_to_string(project.path().join(name)).expect("it is there");
    let arguments = ["check", "--format", "sarif", "--output", "out/a.sarif", "--format", "junit", "--output", "b.xml"];
    let run = rederive(project.path(), &arguments).code(1);
    run.stdout(predicate::str::contains("Differs from what is expected"));
    let alone = |format: &str| printed_with(project.path(), "enclosed", format, 1);
    assert_eq!(read("out/a.sarif"), alone("sarif"));
    assert_eq!(read("b.xml"), alone("junit"));
    let arguments = ["check", "--format", "json", "--output", "c.json", "--format", "github", "--format", "text"];
    rederive(project.path(), &arguments).code(2).stderr(predicate::str::contains("only one format"));
    assert!(!project.path().join("c.json").exists());
    let arguments =
        ["check", "--format", "json", "--output", "c.json", "--format", "text", "--output=d", "--format=github"];
    rederive(project.path(), &arguments).code(1).stdout(predicate::str::starts_with("::error "));
    assert_eq!(read("c.json"), read("reports/decay/report.json"));
    assert!(read("d").contains("Differs from what is expected") && !read("d").contains('\x1b'));
    for (bad, message) in [
        (&["check", "--output", "x", "--format", "sarif"][..], "needs a `--format` of its own before it"),
        (&["check", "--format", "sarif", "--output", "x", "--output", "y"], "needs a `--format` of its own before it"),
        (
            &["check", "--format", "sarif", "--output", "x", "--format", "junit", "--output", "x"],
            "output of two formats",
        ),
        (&["check", "--format", "sarif", "--output", "derivations"], "cannot be written"),
    ] {
        rederive(project.path(), bad).code(2).stderr(predicate::str::contains(message));
        assert!(!project.path().join("x").exists());
    }
}

#[test]
fn problems_of_files_are_told_in_every_format() {
    let file = FILE.replace("'\\ln x\\le 1'", "'\\ln y\\le [1'").replace("says = \"a log", "say = \"a log");
    let project = project(&file);
    let text = printed(project.path(), "sarif", 2);
    let found = results(&text, &file);
    assert!(
        found.iter().any(|(rule, level, part)| rule == "derivation::unknown-key" && level == "error" && part == "say")
    );
    assert!(found.iter().any(|(rule, _, _)| rule.starts_with("latex::")), "{found:?}");
    assert!(commands(&printed(project.path(), "github", 2)).expect("commands").len() >= 2);
    assert!(junit(&printed(project.path(), "junit", 2)).expect("valid")[1] >= 2);
    let missing = rederive(project.path(), &["check", "none.toml", "--format", "sarif", "--output", "x.sarif"]).code(2);
    missing.stderr(predicate::str::contains("derivation::unreadable"));
    let text = fs::read_to_string(project.path().join("x.sarif")).expect("it is written all the same");
    assert_eq!(sarif(&text).expect("valid").len(), 1);
}

#[test]
fn nothing_to_tell_is_told() {
    let good = FILE.split("[[claim]]\nid = \"wrong\"").next().expect("the law alone");
    let project = project(good);
    assert!(sarif(&printed(project.path(), "sarif", 0)).expect("valid").is_empty());
    assert_eq!(printed(project.path(), "github", 0), "");
    assert_eq!(junit(&printed(project.path(), "junit", 0)), Ok([2, 0, 0, 0]));
}

#[test]
fn all_formats_are_the_same_bytes_on_every_run() {
    let project = project(FILE);
    for format in ["sarif", "junit", "github", "json"] {
        assert_eq!(printed(project.path(), format, 1), printed(project.path(), format, 1), "{format}");
    }
}

#[test]
fn the_derivations_of_this_project_can_be_read_by_machines() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let [cases, log] = ["cases.xml", "log.sarif"].map(|name| folder.path().join(name));
    let files = ["check", "derivations/kepler.toml", "derivations/pendulum.toml", "--no-reports"];
    let output =
        |format, path: &Path| ["--format", format, "--output", path.to_str().expect("UTF-8")].map(str::to_owned);
    let formats = [output("junit", &cases), output("sarif", &log)].concat();
    rederive(root, &files.into_iter().chain(formats.iter().map(String::as_str)).collect::<Vec<_>>());
    let [cases, log] = [cases, log].map(|path| fs::read_to_string(path).expect("it is written"));
    let [tests, failures, ..] = junit(&cases).expect("valid");
    assert!(tests > 50 && failures == 0, "{tests}");
    sarif(&log).expect("valid");
}
