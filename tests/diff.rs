//! `rederive diff`: what it calls worse, and what it does not.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;
use rederive::report::{Direction, diff, is_worse};
use serde_json::{Value, json};

/// A report with one claim on one trajectory.
fn report(verdict: &str, strength: Option<&str>, unexpected: bool) -> Value {
    json!({
        "schema": 1,
        "derivation": { "id": "d" },
        "claims": [{ "id": "c", "reading": null, "identity": null, "results": [
            { "trajectory": "t", "verdict": verdict, "strength": strength, "unexpected": unexpected },
        ]}],
    })
}

#[track_caller]
fn direction(old: &Value, new: &Value) -> Option<Direction> {
    let changes = diff(std::slice::from_ref(old), std::slice::from_ref(new)).expect("two reports");
    assert!(changes.len() < 2);
    changes.first().map(|c| c.direction)
}

#[test]
fn what_is_worse() {
    let proved = report("holds", Some("proved"), false);
    let sampled = report("holds", Some("sampled"), false);
    let undecided = report("undecided", None, false);
    let not_applicable = report("not-applicable", None, false);
    let broken = report("fails", Some("sampled"), true);
    let wrong_on_purpose = report("fails", Some("sampled"), false);
    let order = [&broken, &undecided, &not_applicable, &sampled, &proved];
    for (i, a) in order.iter().enumerate() {
        for (j, b) in order.iter().enumerate() {
            let wanted = match i.cmp(&j) {
                std::cmp::Ordering::Less => Some(Direction::Better),
                std::cmp::Ordering::Equal => None,
                std::cmp::Ordering::Greater => Some(Direction::Worse),
            };
            assert_eq!(direction(a, b), wanted, "{i} {j}");
        }
    }
    assert_eq!(direction(&sampled, &wrong_on_purpose), Some(Direction::Changed), "the file says so, too");
    assert_eq!(direction(&wrong_on_purpose, &report("holds", Some("sampled"), true)), Some(Direction::Worse));
}

#[test]
fn what_is_gone_is_worse_and_what_is_new_is_not_unless_it_fails() {
    let none = json!({ "schema": 1, "derivation": { "id": "d" }, "claims": [] });
    let good = report("holds", Some("sampled"), false);
    assert_eq!(direction(&good, &none), Some(Direction::Worse));
    assert_eq!(direction(&none, &good), Some(Direction::New));
    assert_eq!(direction(&none, &report("fails", Some("sampled"), true)), Some(Direction::Worse));
}

#[test]
fn identities_count() {
    let with = |verdict: &str| {
        let mut r = report("holds", Some("sampled"), false);
        r["claims"][0]["identity"] = json!({ "verdict": verdict });
        r
    };
    assert_eq!(direction(&with("proved"), &with("undecided")), Some(Direction::Worse));
    assert_eq!(direction(&with("proved"), &with("refuted")), Some(Direction::Worse));
    assert_eq!(direction(&with("undecided"), &with("proved")), Some(Direction::Better));
    assert!(is_worse(&diff(&[with("proved")], &[]).expect("reports")));
}

#[test]
fn what_is_no_report_is_refused() {
    for bad in [json!({}), json!([]), json!({ "schema": 2 }), json!({ "schema": 1, "derivation": {} }), json!(null)] {
        assert!(diff(std::slice::from_ref(&bad), &[]).is_err(), "{bad}");
    }
}

/// Small bytes are large values once they are read, and an id is told with each verdict.
#[test]
fn a_report_of_many_values_or_of_long_ids_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let good = report("holds", Some("sampled"), false);
    fs::write(folder.path().join("good.json"), good.to_string()).expect("written");
    let with = |more: &str| good.to_string().replacen('{', &format!("{{\"more\":{more},"), 1);
    let many = |value: &str| format!("[{}1]", [value, ","].concat().repeat(6_000_000));
    for text in [many("1"), with(&many("1")), with(&many("{}"))] {
        fs::write(folder.path().join("many.json"), text).expect("written");
        let run = rederive(folder.path(), &["diff", "good.json", "many.json"]).code(2);
        let told = "`many.json` cannot be compared: it has more than 5000000 values of JSON";
        run.stderr(predicate::str::contains(told));
    }
    // What is not compared is not kept, and does not count unless it is much.
    fs::write(folder.path().join("more.json"), with("[1,{},\",,\"]")).expect("written");
    rederive(folder.path(), &["diff", "good.json", "more.json"]).code(0);
    let long = good.to_string().replace("\"d\"", &format!("\"{}\"", "d".repeat(1000)));
    fs::write(folder.path().join("long.json"), long).expect("written");
    let run = rederive(folder.path(), &["diff", "good.json", "long.json"]).code(2);
    run.stderr(predicate::str::contains("an id or a word has 1000 bytes"));
}

fn rederive(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    command.current_dir(folder).env_remove("CLICOLOR_FORCE").args(arguments).assert()
}

const FILE: &str = r"
[derivation]
title = 'Decay'
concerns = 'A textbook'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
[system.decay]
states = ['x']
equations = ['\dot x=-x']
[[trajectory]]
id = 'slow'
system = 'decay'
initial = { 'x' = 1.5 }
span = [0, 2]
[[trajectory]]
id = 'fast'
system = 'decay'
initial = { 'x' = 3 }
span = [0, 1]
[[claim]]
id = 'law'
says = 'the rate is minus x'
always = ['\dot x=-x']
";

#[test]
fn the_command_compares_what_check_has_written() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("decay.toml"), FILE).expect("written");
    rederive(folder.path(), &["check", "decay.toml", "--reports", "old"]).code(0);
    fs::write(folder.path().join("decay.toml"), FILE.replace(r"always = ['\dot x=-x']", r"always = ['\dot x=-x+1']"))
        .expect("written");
    rederive(folder.path(), &["check", "decay.toml", "--reports", "new"]).code(1);
    rederive(folder.path(), &["diff", "old", "old"]).code(0).stdout("No verdict has changed.\n");
    let run = rederive(folder.path(), &["diff", "old", "new/decay/report.json"]).code(1);
    run.stdout(predicate::str::contains("Worse (").and(predicate::str::contains("decay: law on slow, fast")));
    rederive(folder.path(), &["diff", "new", "old"]).code(0).stdout(predicate::str::contains("Better ("));
    let run = rederive(folder.path(), &["diff", "old", "new", "--format", "markdown"]).code(1);
    run.stdout(predicate::str::contains("- **decay**, `law` on slow, fast: holds"));
    rederive(folder.path(), &["diff", "old", "none"]).code(2).stderr(predicate::str::contains("`none` cannot be read"));
    fs::write(folder.path().join("x.json"), "{}").expect("written");
    rederive(folder.path(), &["diff", "old", "x.json"]).code(2).stderr(predicate::str::contains("x.json"));
    fs::create_dir(folder.path().join("empty")).expect("made");
    rederive(folder.path(), &["diff", "empty", "old"]).code(2).stderr(predicate::str::contains("no report.json"));
}
