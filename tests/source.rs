//! A derivation file beside the source of its paper.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::paper::{self, Comparison, compare};

const PAPER: &str = include_str!("source/paper.tex");

/// A derivation file; the parts that tests change are the formulas under `motion` and `energy`.
const FILE: &str = r#"
[derivation]
title = "A pendulum"
concerns = "tests/source/paper.tex"

[symbols]
't' = { role = "time" }
'q' = { role = "state" }
'p' = { role = "state" }
'\omega_0' = { role = "parameter", positive = true }
'E' = { role = "observable", formula = '\frac12 p^2-\omega_0^2\cos q' }

[system.pendulum]
label = "motion"
states = ['q', 'p']
equations = ['\dot q=p, \quad \dot p=-\omega_0^2\sin q']

[[trajectory]]
id = "wide"
system = "pendulum"
parameters = { '\omega_0' = 1.3 }
initial = { 'q' = 0.5, 'p' = 0 }
span = [0, 3]

[[claim]]
id = "rate"
says = "the rate of the momentum"
label = "motion"
always = ['\dot p=-\omega_0^2\sin q']

[[claim]]
id = "energy"
says = "the energy"
label = "energy"
always = ['E=\frac12p^2-\omega_0^2\cos{q}']

[[claim]]
id = "conserved"
says = "the energy does not change"
always = ['\dot E=0']

[[claim]]
id = "variant"
says = "the energy, doubled"
label = "energy"
printed = false
always = ['2E=p^2-2\omega_0^2\cos q']
"#;

fn read(text: &str) -> Derivation {
    let source = Source { path: "derivations/pendulum.toml".into(), text: text.into() };
    parse(source, "pendulum").unwrap_or_else(|found| panic!("{}", render(&found, false)))
}

fn compared(file: &str, tex: &str) -> (Derivation, Comparison) {
    let derivation = read(file);
    let source = Source { path: "paper.tex".into(), text: tex.into() };
    let paper = paper::parse(source, "00".into()).unwrap_or_else(|d| panic!("{}", render(&[*d], false)));
    let comparison = compare(&derivation, &paper);
    (derivation, comparison)
}

#[test]
fn what_is_copied_rightly_is_the_same_whatever_its_spelling() {
    let (_, found) = compared(FILE, PAPER);
    assert_eq!(found.differences, []);
    assert_eq!(found.unknown, []);
    assert_eq!(found.compared, 4, "two equations of the system, two claims");
    let shown: Vec<_> = found.equations.iter().map(|e| (e.label.as_deref(), e.parts, e.printed, e.by.len())).collect();
    assert_eq!(
        shown,
        [(Some("motion"), 2, 2, 2), (Some("energy"), 1, 1, 2), (Some("period"), 1, 0, 0), (None, 1, 0, 0),]
    );
    assert_eq!(found.covered(), (2, 3));
    assert_eq!((found.relations.len(), found.found()), (3, 1), "{:?}", found.relations);
}

/// A file with one claim that names the label of a display.
fn one_claim(formula: &str) -> String {
    format!(
        "[derivation]\ntitle = 'x'\nconcerns = 'y'\n[symbols]\n'a' = {{ role = 'parameter' }}\n\
         [[claim]]\nid = 'one'\nlabel = 'one'\nsays = 'z'\nalways = ['{formula}']\n"
    )
}

#[test]
fn columns_continued_lines_and_chains_are_what_is_printed() {
    let columns = r"\begin{align} a &= aa & a &= aaa \label{one} \end{align}";
    let continued = r"\begin{align} a &= a^2 \nonumber \\ &\quad + a^3 \label{one} \end{align}";
    let chain = r"\begin{align} a &= (2a)^2 \\ &= 4a^2 \label{one} \end{align}";
    for (tex, formula, same) in [
        (columns, "a=aa", true),
        (columns, "a=aaa", true),
        (columns, "a=aa=a=aaa", false),
        (continued, "a=a^2+a^3", true),
        (continued, "a=a^2", false),
        (chain, "(2a)^2=4a^2", true),
        (chain, "a=4a^2", true),
        (chain, "a=2a^2", false),
    ] {
        let (_, found) = compared(&one_claim(formula), tex);
        assert_eq!(found.compared, 1, "{formula}");
        assert_eq!(found.differences.is_empty(), same, "{tex} and {formula}");
    }
}

#[test]
fn every_slip_is_found_with_both_places() {
    let slips = [
        (r"'\dot p=-\omega_0^2\sin q'", r"'\dot p=\omega_0^2\sin q'", "\\omega", "-"),
        (r"'\dot p=-\omega_0^2\sin q'", r"'\dot p=-\omega_0^2\cos q'", "\\cos", "\\sin"),
        (r"'\dot p=-\omega_0^2\sin q'", r"'\dot p=-\omega_0\sin q'", "\\sin", "^{2}"),
        (r"'E=\frac12p^2-", r"'E=\frac12p^3-", "3", "{2}"),
        (r"'E=\frac12p^2-", r"'E=\frac12p^2+", "+", "-"),
        (r"'E=\frac12p^2-", r"'E=\frac13p^2-", "3", "{2}"),
    ];
    for (from, to, here, there) in slips {
        let file = FILE.replace(from, to);
        assert_ne!(file, FILE);
        let (derivation, found) = compared(&file, PAPER);
        let [slip] = found.differences.as_slice() else { panic!("{to}: {:?}", found.differences) };
        assert!(slip.is_near);
        let start = |text: &str, span: &std::ops::Range<usize>| text[span.start..].to_owned();
        assert!(
            start(&derivation.file.text, &slip.here).starts_with(here),
            "{to}: {:?}",
            &derivation.file.text[slip.here.clone()]
        );
        let there = there.trim_matches(['{', '}']);
        assert!(
            start(&found.paper.text, &slip.there).starts_with(there),
            "{to}: {:?}",
            &found.paper.text[slip.there.clone()]
        );
    }
}

#[test]
fn a_slip_in_the_paper_or_in_its_macros_is_found() {
    for (from, to) in [
        (r"\sin q", r"\cos q"),
        (r"\newcommand{\w}{\omega_0}", r"\newcommand{\w}{\Omega_0}"),
        (r"\newcommand{\dt}[1]{\dot{#1}}", r"\newcommand{\dt}[1]{\ddot{#1}}"),
        (r"= p \,,", "= 2p,"),
    ] {
        let (_, found) = compared(FILE, &PAPER.replace(from, to));
        assert!(!found.differences.is_empty(), "{to}");
    }
}

#[test]
fn another_formula_is_not_called_a_slip() {
    let file = FILE
        .replace(r"always = ['E=\frac12p^2-\omega_0^2\cos{q}']", r"always = ['\ddot q=-\omega_0^2\sin q', 'p=\dot q']");
    let (_, found) = compared(&file, PAPER);
    assert_eq!(found.differences.len(), 2);
    assert!(found.differences.iter().any(|d| !d.is_near), "{:?}", found.differences);
}

#[test]
fn a_formula_of_another_label_does_not_pass() {
    let (_, found) = compared(&FILE.replacen("label = \"energy\"", "label = \"motion\"", 1), PAPER);
    assert_eq!(found.differences.len(), 1);
    let (_, found) = compared(&FILE.replacen("label = \"energy\"", "label = \"enegry\"", 1), PAPER);
    assert_eq!(found.unknown[0].near.as_deref(), Some("energy"));
}

fn rederive(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    command.current_dir(folder).env_remove("CLICOLOR_FORCE").args(arguments).assert()
}

fn project(file: &str, tex: &[u8]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("pendulum.toml"), file).expect("written");
    fs::write(folder.path().join("paper.tex"), tex).expect("written");
    folder
}

#[test]
fn the_exit_code_and_the_formats_tell() {
    let good = project(FILE, PAPER.as_bytes());
    let arguments = ["check", "pendulum.toml", "--source", "paper.tex"];
    let run = rederive(good.path(), &arguments).code(0);
    run.stdout(predicate::str::contains("2 of 4 equations covered, 3 of 5 parts as printed"));
    let report = fs::read_to_string(good.path().join("reports/pendulum/report.json")).expect("there");
    let report: serde_json::Value = serde_json::from_str(&report).expect("JSON");
    assert_eq!(report["paper"]["coverage"]["covered"], 2);
    rederive(good.path(), &["check", "pendulum.toml"]).code(0);
    let report = fs::read_to_string(good.path().join("reports/pendulum/report.json")).expect("there");
    assert!(!report.contains("\"paper\""), "without a paper there is nothing to say of it");

    let bad = project(&FILE.replace(r"\frac12p^2-", r"\frac12p^2+"), PAPER.as_bytes());
    let run = rederive(bad.path(), &[&arguments[..], &["--format", "sarif"]].concat()).code(1);
    let text = String::from_utf8(run.get_output().stdout.clone()).expect("UTF-8");
    let log: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let results = log["runs"][0]["results"].as_array().expect("results");
    let rules: Vec<&str> = results.iter().filter_map(|r| r["ruleId"].as_str()).collect();
    assert_eq!(rules, ["verdict::fails", "paper::differs", "paper::not-covered", "paper::not-covered"]);
    for result in &results[..2] {
        let there = &result["relatedLocations"][0]["physicalLocation"];
        assert_eq!(there["artifactLocation"]["uri"], "paper.tex", "{result}");
        assert!(there["region"]["startLine"].as_u64().is_some_and(|l| l > 10), "{result}");
    }
    assert_eq!(results[2]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "paper.tex");
}

#[test]
fn papers_that_cannot_be_read() {
    // A macro without an end is left out, and told.
    let project = project(FILE, br"\def\a{\a}\a");
    let run = rederive(project.path(), &["lint", "paper.tex"]).code(0);
    run.stdout(predicate::str::contains("does not end; its definition is left out"));
    let many: String = (0..12).map(|i| format!("\\def\\a{0}{{\\a{0}}}\\a{0}", char::from(b'a' + i))).collect();
    std::fs::write(project.path().join("many.tex"), many).expect("written");
    let run = rederive(project.path(), &["check", "pendulum.toml", "--source", "many.tex"]).code(2);
    run.stderr(predicate::str::contains("does not end"));
    let run = rederive(project.path(), &["check", "pendulum.toml", "--source", "none.tex"]).code(2);
    run.stderr(predicate::str::contains("paper::unreadable"));
    // One that calls others for ever longer is named, the one that the text calls, and the rest is read.
    let fourfold = |w: u8| format!("\\def\\{0}{{\\{1}\\{1}\\{1}\\{1}}}", char::from(w + 1), char::from(w));
    let bomb: String = (b'a'..=b'y').map(fourfold).collect();
    std::fs::write(project.path().join("bomb.tex"), format!("\\def\\a{{x=y}}{bomb}$$\\z$$ $$q=2$$")).expect("written");
    let run = rederive(project.path(), &["lint", "bomb.tex"]).code(0);
    run.stdout(predicate::str::contains(r"the macro `\z` does not end").and(predicate::str::contains("q=2")));
    // What is longer than can be read is read as far as that, and no display is cut.
    let long = format!("\\[ q=2 \\]\n\nOn\n\n{}\\[ p=q+1 \\]", "x".repeat(4_000_000));
    std::fs::write(project.path().join("long.tex"), long).expect("written");
    let run = rederive(project.path(), &["lint", "long.tex"]).code(0);
    let told = predicate::str::contains("longer than can be read, 4000000 words and signs: what follows is not read");
    run.stdout(told.and(predicate::str::contains("q=2")).and(predicate::str::contains("p=q").not()));
    // Nothing is named, and nothing is missed.
    std::fs::write(project.path().join("plain.tex"), r"\input\jobname $$q=2$$").expect("written");
    rederive(project.path(), &["lint", "plain.tex"]).code(0).stdout(predicate::str::contains("``").not());
    let mut latin = PAPER.as_bytes().to_vec();
    latin.extend_from_slice(b"% caf\xe9");
    fs::write(project.path().join("paper.tex"), latin).expect("written");
    rederive(project.path(), &["check", "pendulum.toml", "--source", "paper.tex"]).code(0);
}

#[test]
fn a_paper_is_of_one_derivation() {
    let project = project(FILE, PAPER.as_bytes());
    fs::write(project.path().join("other.toml"), FILE).expect("written");
    let arguments = ["check", "pendulum.toml", "other.toml", "--source", "paper.tex", "--no-reports"];
    rederive(project.path(), &arguments).code(2).stderr(predicate::str::contains("pendulum, other name labels"));
    let plain = FILE
        .replace("label = ", "place = ")
        .replacen("place = \"motion\"", "says = 'x'", 1)
        .replace("printed = false", "");
    fs::write(project.path().join("other.toml"), plain).expect("written");
    rederive(project.path(), &arguments).code(0).stdout(predicate::str::contains("Compared with paper.tex").count(1));
}
