//! The program from outside: streams, files and exit codes.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;

/// A small derivation: x falls off at its own rate. The last line is a claim to be completed.
const DECAY: &str = r"
[derivation]
title = 'Decay'
concerns = 'A textbook'

[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'k' = { role = 'parameter', positive = true }

[system.decay]
states = ['x']
equations = ['\dot x=-x']

[[trajectory]]
id = 'slow'
title = 'A slow one'
system = 'decay'
initial = { 'x' = 1.5 }
parameters = { 'k' = 0.5 }
span = [0, 2]

[[claim]]
id = 'law'
says = 'the rate is minus x'
always = ['\dot x=-x']
";

const WRONG: &str = r"
[[claim]]
id = 'wrong'
says = 'the rate is x'
always = ['\dot x=x']
";

/// A project with one derivation file of this text.
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

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn bad_command_lines() {
    let project = project(DECAY);
    for (arguments, message) in [
        (&["chek"][..], "unrecognized subcommand"),
        (&["check", "--fromat", "json"], "unexpected argument"),
        (&["check", "--format", "yaml"], "invalid value"),
        (&["check", "--format", "html"], "`rederive check` writes the page"),
        (&["lint", "--format", "html", "paper.tex"], "`rederive lint PAPER.TEX --html FILE` writes the page"),
        (&["check", "--reports", "r", "--no-reports"], "cannot be used with"),
        (&["check", "missing.toml"], "derivation::unreadable"),
        (&["check", "--claim", "lwa"], "there is no claim `lwa`; did you mean `law`?"),
        (&["check", "--trajectory", "slwo"], "there is no trajectory `slwo`; did you mean `slow`?"),
        (&["explain", "nothing"], "there is no claim `nothing`"),
        (&["explain", "law", "--on", "fast"], "there is no trajectory `fast`"),
        (&["explain"], "required arguments"),
        (&[], "Usage"),
    ] {
        let run = rederive(project.path(), arguments).code(2).stdout("").stderr(predicate::str::contains(message));
        assert!(!text(&run.get_output().stderr).contains('\x1b'), "colour without a terminal: {arguments:?}");
    }
    assert!(!project.path().join("reports").exists(), "nothing is written");
}

#[test]
fn help_and_version_are_no_errors() {
    let project = project(DECAY);
    rederive(project.path(), &["--help"]).code(0).stderr("").stdout(predicate::str::contains("Exit codes"));
    rederive(project.path(), &["check", "--help"]).code(0).stdout(predicate::str::contains("--no-reports"));
    rederive(project.path(), &["--version"]).code(0).stdout(predicate::str::starts_with("rederive "));
}

#[test]
fn a_folder_without_derivation_files() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    rederive(folder.path(), &["check"]).code(2).stderr(predicate::str::contains("derivations"));
    fs::create_dir(folder.path().join("derivations")).expect("a folder can be made");
    rederive(folder.path(), &["check"]).code(2).stderr(predicate::str::contains("no derivation file (*.toml)"));
}

#[test]
fn a_bad_file_changes_nothing_and_all_problems_are_told() {
    let project = project(&DECAY.replace("says =", "say =").replace("equations", "equation"));
    fs::write(project.path().join("derivations/two.toml"), "[derivation\n").expect("a file can be written");
    let run = rederive(project.path(), &["check"]).code(2).stdout("");
    let stderr = text(&run.get_output().stderr);
    for expected in [
        "derivations/decay.toml:13:",
        "did you mean `equations`?",
        "did you mean `says`?",
        "derivations/two.toml:1:",
        "problems found",
    ] {
        assert!(stderr.contains(expected), "`{expected}` is missing in:\n{stderr}");
    }
    assert!(!project.path().join("reports").exists());
}

#[test]
fn two_files_with_one_id_are_refused() {
    let project = project(DECAY);
    fs::create_dir(project.path().join("derivations/more")).expect("a folder can be made");
    fs::write(project.path().join("derivations/more/decay.toml"), DECAY).expect("a file can be written");
    let run = rederive(project.path(), &["check"]).code(2);
    run.stderr(predicate::str::contains("`derivations/decay.toml` has the same id, `decay`"));
}

#[test]
fn the_list_of_a_file() {
    let project = project(DECAY);
    let run = rederive(project.path(), &["list"]).code(0).stderr("");
    insta::assert_snapshot!(text(&run.get_output().stdout));
}

#[test]
fn reports_are_written_whole_and_the_same_every_time() {
    let project = project(DECAY);
    let read = |name: &str| fs::read(project.path().join("reports/decay").join(name)).expect("a report is there");
    rederive(project.path(), &["check"]).stdout(predicate::str::contains("report: reports/decay/report.md"));
    let (json, markdown) = (read("report.json"), read("report.md"));
    let absolute = project.path().join("derivations/decay.toml");
    rederive(project.path(), &["check", &absolute.display().to_string()]);
    assert_eq!((read("report.json"), read("report.md")), (json, markdown.clone()));
    assert!(!text(&markdown).contains(&project.path().display().to_string()), "no path outside the project");
    let entries = fs::read_dir(project.path().join("reports/decay")).expect("listed").count();
    assert_eq!(entries, 5, "four files, and a folder of certificates");
    assert!(project.path().join("reports/decay/certificates/proof-law.py").exists());
}

#[test]
fn a_report_that_cannot_be_written_is_an_error() {
    let project = project(DECAY);
    fs::write(project.path().join("reports"), "in the way").expect("a file can be written");
    rederive(project.path(), &["check"]).code(2).stderr(predicate::str::contains("cannot be written"));
    assert_eq!(fs::read_to_string(project.path().join("reports")).expect("read"), "in the way");
}

#[test]
fn filters_write_no_report() {
    let project = project(&format!("{DECAY}{WRONG}"));
    let run = rederive(project.path(), &["check", "--claim", "wrong"]);
    let run = run.stderr(predicate::str::contains("no report was written"));
    assert!(!text(&run.get_output().stdout).contains("law"));
    rederive(project.path(), &["check", "--no-reports"]);
    assert!(!project.path().join("reports").exists());
    rederive(project.path(), &["check", "--reports", "elsewhere"]);
    assert!(project.path().join("elsewhere/decay/report.json").exists());
}

#[test]
fn json_on_standard_output_is_the_report() {
    let project = project(DECAY);
    let run = rederive(project.path(), &["check", "--format", "json"]);
    let written = fs::read(project.path().join("reports/decay/report.json")).expect("a report is there");
    assert_eq!(run.get_output().stdout, written);
    let value: serde_json::Value = serde_json::from_slice(&written).expect("this is JSON");
    assert_eq!(value["schema"], 1);
    assert_eq!(value["derivation"]["id"], "decay");
    assert_eq!(value["claims"][0]["results"][0]["trajectory"], "slow");
}

#[test]
fn a_closed_pipe_is_no_failure() {
    let project = project(DECAY);
    let program = assert_cmd::cargo::cargo_bin("rederive");
    let mut child = std::process::Command::new(program)
        .args(["check"])
        .current_dir(project.path())
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("the program ends");
    assert!(!text(&output.stderr).contains("panicked"), "{}", text(&output.stderr));
    assert_ne!(output.status.code(), Some(70));
    assert!(project.path().join("reports/decay/report.json").exists());
}

#[test]
fn a_file_without_claims_is_no_success() {
    let project = project(DECAY.split("[[claim]]").next().unwrap_or_default());
    rederive(project.path(), &["check"]).code(3).stderr(predicate::str::contains("no claim was decided"));
}

#[test]
fn exit_codes_of_verdicts() {
    let good = project(DECAY);
    rederive(good.path(), &["check"]).code(0);
    rederive(good.path(), &["check", "--quiet"]).code(0).stdout("").stderr("");
    let fails = project(&format!("{DECAY}{WRONG}"));
    rederive(fails.path(), &["check"]).code(1).stdout(predicate::str::contains("wrong  fails on 1 of 1"));
    rederive(fails.path(), &["check", "--claim", "law"]).code(0);
    let expected = project(&format!("{DECAY}{WRONG}expect = 'fails'\n"));
    rederive(expected.path(), &["check"]).code(0);
    let unexpected = project(&format!("{DECAY}expect = 'fails'\n"));
    rederive(unexpected.path(), &["check"]).code(1);
    rederive(fails.path(), &["explain", "wrong", "--on", "slow"]).code(0).stdout(predicate::str::contains("left"));
}
