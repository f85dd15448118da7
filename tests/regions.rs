//! Claims over ranges of values: what the loader refuses, and that no report loses them.

use std::path::Path;
use std::process::Command;

use rederive::check::{Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::report;

const HEAD: &str = r#"
[derivation]
title = "T"
concerns = "C"

[symbols]
't' = { role = "time" }
'q' = { role = "state" }
'x' = { role = "parameter", unit = "rad" }
'c' = { role = "parameter", positive = true }
'I' = { role = "parameter", shape = "diagonal 3", positive = true }
'E' = { role = "observable", formula = '\dot q^2' }
's' = { role = "abbreviation", formula = 'x+c' }

[system.free]
states = ['q']
equations = ['\dot q=x']

[[trajectory]]
id = "one"
system = "free"
initial = { 'q' = 0 }
parameters = { 'x' = 1 }
span = [0, 1]
"#;

fn load(claim: &str) -> Result<Derivation, String> {
    let text = format!("{HEAD}\n[[claim]]\nid = \"c\"\nsays = \"s\"\n{claim}\n");
    parse(Source { path: "t.toml".into(), text }, "t").map_err(|found| render(&found, false))
}

fn problems(claims: &[&str]) -> String {
    claims.iter().map(|claim| format!("{claim}\n\n{}\n", load(claim).err().unwrap_or("no problem\n".into()))).collect()
}

#[test]
fn what_is_refused() {
    insta::assert_snapshot!(
        "refused_ranges",
        problems(&[
            "ranges = { 'x' = [2, 1] }\nalways = ['x>0']",
            "ranges = { 'x' = [1, 1] }\nalways = ['x>0']",
            "ranges = { 'x' = [1] }\nalways = ['x>0']",
            "ranges = { 'x' = ['c', 2], 'c' = 1 }\nalways = ['x>0']",
            "ranges = { 'c' = [0, 1] }\nalways = ['c>0']",
            "ranges = { 'I' = [1, 2] }\nalways = ['I_1>0']",
            "ranges = { 's' = [1, 2] }\nalways = ['s>0']",
            "ranges = { 'w' = [1, 2] }\nalways = ['x>0']",
            "ranges = {}\nalways = ['1>0']",
            "ranges = { 'x' = [1, 2] }\nalways = ['s>0']",
            "ranges = { 'x' = [1, 2] }\nalways = ['\\dot q=x']",
            "ranges = { 'x' = [1, 2] }\nalways = ['q(0)<x']",
            "ranges = { 'x' = [1, 2] }\nalways = ['q+t>x']",
            "ranges = { 'x' = [1, 2] }\nalways = ['E>0']",
            "ranges = { 'x' = [1, 2] }\nalways = ['\\lim_{t\\rightarrow\\infty}x=x']",
            "ranges = { 'x' = [1, 2] }\nnever = ['x=0']",
            "ranges = { 'x' = [1, 2] }\nfirst-integral = ['x']",
            "ranges = { 'x' = [1, 2] }\nalways = ['x>0']\ntrajectories = [\"one\"]",
            "ranges = { 'x' = [1, 2] }\nalways = ['x>0']\nat = 'q=0'",
            "ranges = { 'x' = [1, 2] }\nalways = ['x>0']\nexpect = { holds = \"all\" }",
        ])
    );
    insta::assert_snapshot!(
        "refused_exists",
        problems(&[
            "exists = { unknowns = { 'x' = [0, 2] }, such-that = ['x^2=2', 'x=1'] }",
            "exists = { unknowns = { 'x' = 1 }, such-that = ['x^2=2'] }",
            "exists = { unknowns = { 'x' = [0, 2] }, such-that = ['x^2=c'] }",
            "exists = { unknowns = { 'x' = [0, 2] } }",
            "ranges = { 'x' = [0, 1] }\nexists = { unknowns = { 'x' = [0, 2] }, such-that = ['x^2=2'] }",
            "ranges = { 'c' = [1, 2] }\nalways = ['c>0']\nexists = { unknowns = { 'x' = [0, 2] }, such-that = ['x^2=c'] }",
            "exists = { unknowns = { 'x' = [0, 2] }, such-that = ['x=\\pm1'] }",
        ])
    );
}

#[test]
fn what_is_accepted() {
    for claim in [
        "ranges = { 'q' = [0, 1], 'E' = [1, 2], 't' = [0, 1] }\nalways = ['E>q-t-1']",
        "ranges = { 'I' = [[2.9, 3.1], 2, 1] }\nalways = ['I_1>I_2']",
        "ranges = { 'x' = ['\\frac13', '\\pi'], 'c' = 'x^2' }\nalways = ['s>0']",
        "exists = { unknowns = { 'x' = [0, 2] }, such-that = ['x^2=2', 'x>0'], unique = true }",
    ] {
        assert!(load(claim).is_ok(), "{claim}\n{}", problems(&[claim]));
    }
}

/// A claim that fails, one that is open, and one that is as expected.
fn three() -> Derivation {
    let claims = "ranges = { 'x' = [-1, 1], 'c' = [1, 2] }\nalways = ['x+c>0.5']\nexpect = \"holds\"\n\n\
        [[claim]]\nid = \"open\"\nsays = \"o\"\nranges = { 'x' = [0, 1] }\nalways = ['(x-0.3)^2>0']\n\n\
        [[claim]]\nid = \"root\"\nsays = \"r\"\nexists = { unknowns = { 'x' = [0, 2] }, such-that = ['x^2=2'], unique = true }\n\
        expect = \"holds\"\n\n\
        [[claim]]\nid = \"moving\"\nsays = \"m\"\nalways = ['\\dot q=x']\nexpect = \"holds\"";
    load(claims).unwrap_or_else(|found| panic!("{found}"))
}

#[test]
fn no_report_loses_a_claim_over_ranges() {
    let derivation = three();
    let account = check(&derivation, &Options::default(), &|_, _| {}).expect("an account");
    let ids: Vec<&str> = account.claims.iter().map(|c| c.id.as_str()).collect();
    assert_eq!(ids, ["c", "open", "root", "moving"], "the order of the file");
    let summary = account.summary();
    assert_eq!((summary.holds, summary.fails, summary.undecided, summary.open, summary.unexpected), (2, 1, 1, 1, 1));

    let terminal = report::summary(&derivation, &account, false, true);
    for words in ["Over ranges of values (3)", "c  F  fails (certified), expected: holds", "root  H  holds (enclosed)"]
    {
        assert!(terminal.contains(words), "{words} in\n{terminal}");
    }
    let quiet = report::exceptions(&derivation, &account, false);
    assert!(quiet.contains("expected: holds") && quiet.contains("open  ?") && !quiet.contains("root"), "{quiet}");
    let explained = report::explain(&derivation, &account, &[], &[], false);
    assert!(explained.contains("Over x from −1 to 1") && explained.contains("x in [1.414"), "{explained}");

    let markdown = report::markdown(&derivation, &account);
    assert!(markdown.contains("**expected: holds**") && markdown.contains("1.41421356"), "{markdown}");
    let findings = report::findings(&derivation, &account);
    let rules: Vec<&str> = findings.iter().map(|f| f.rule).collect();
    assert_eq!(rules, ["verdict::fails", "verdict::undecided"]);
    assert!(findings[0].message.contains("over its ranges, expected is `holds`"), "{}", findings[0].message);
    let sarif = report::sarif(&findings);
    assert!(sarif.contains("verdict::fails"));
    let junit = report::junit(&[report::Checked { derivation: &derivation, account: &account }], &[]);
    assert_eq!(junit.matches("name=\"its ranges\"").count(), 3, "{junit}");
    assert!(junit.contains("failures=\"1\"") && junit.contains("errors=\"1\""), "{junit}");
    let tex = report::tex(&derivation, &account);
    assert!(tex.contains("There is exactly one solution") && tex.contains("Fails (certified)"), "{tex}");

    let json: serde_json::Value = serde_json::from_str(&report::json(&derivation, &account)).expect("JSON");
    assert_eq!(json["claims"][0]["region"]["verdict"], "fails");
    assert_eq!(json["claims"][3]["region"], serde_json::Value::Null);
    let mut better = json.clone();
    better["claims"][0]["region"]["unexpected"] = false.into();
    let changes = report::diff(&[better], &[json]).expect("reports");
    assert!(report::is_worse(&changes), "{changes:?}");
    assert!(report::diff_text(&changes, false).contains("c on its ranges"), "{changes:?}");
}

#[test]
fn the_picture_tells_the_parts_apart_without_colour() {
    let derivation = three();
    let account = check(&derivation, &Options::default(), &|_, _| {}).expect("an account");
    // Quotes that HTML can do without may be left out.
    let page = report::page(&derivation, &account).replace('"', "");
    assert_eq!(page.matches("<figure class=map>").count(), 1, "two ranges vary in one claim");
    let figure = page.split_once("<figure class=map>").and_then(|(_, rest)| rest.split_once("</figure>"));
    let (figure, _) = figure.expect("a figure");
    for part in ["role=img", "<title>", "<desc>", "path class=rf", "path class=rp", "refuted", "x in rad"] {
        assert!(figure.contains(part), "{part} in\n{figure}");
    }
    assert!(figure.len() < 12_000, "{} bytes", figure.len());
}

#[test]
fn the_exit_code_knows_them() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("regions");
    std::fs::create_dir_all(&folder).expect("a folder");
    let run = |name: &str, claim: &str| {
        let path = folder.join(name);
        std::fs::write(&path, format!("{HEAD}\n[[claim]]\nid = \"c\"\nsays = \"s\"\n{claim}\n")).expect("a file");
        let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
        command.arg("check").arg(&path).arg("--reports").arg(folder.join("reports"));
        command.output().expect("it runs").status.code()
    };
    assert_eq!(run("good.toml", "ranges = { 'x' = [0, 1] }\nalways = ['x\\ge 0']\nexpect = \"holds\""), Some(0));
    assert_eq!(run("bad.toml", "ranges = { 'x' = [-1, 1] }\nalways = ['x\\ge 0']\nexpect = \"holds\""), Some(1));
    assert_eq!(run("wrong.toml", "ranges = { 'x' = [1, -1] }\nalways = ['x\\ge 0']"), Some(2));
    assert_eq!(run("open.toml", "ranges = { 'x' = [0, 1] }\nalways = ['(x-0.3)^2>0', 'x\\ge 0']"), Some(3));
}
