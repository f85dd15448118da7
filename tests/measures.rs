//! Measures: between two events, and over families; the table of members.

use std::path::Path;
use std::process::Command;

use rederive::check::family::Part;
use rederive::check::{Account, Limits, Measurement, Options, Rigor, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::{Ask, Session, report};

const HEAD: &str = r"
[derivation]
title = 't'
concerns = 'c'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'v' = { role = 'state' }
'a' = { role = 'parameter' }
'w' = { role = 'parameter', positive = true }
[system.spring]
states = ['x', 'v']
equations = ['\dot x=v, \quad \dot v=-w^2x']
[[trajectory]]
id = 'formula'
parameters = { 'a' = 3, 'w' = 2 }
formula = { 'x' = 'a\cos wt', 'v' = '-aw\sin wt' }
span = [0, 10]
[[trajectory]]
id = 'integrated'
system = 'spring'
parameters = { 'a' = 3, 'w' = 2 }
initial = { 'x' = 'a', 'v' = 0 }
span = [0, 10]
";

fn derivation(text: &str) -> Result<Derivation, String> {
    let text = format!("{HEAD}{text}");
    parse(Source { path: "t.toml".into(), text }, "t").map_err(|found| render(&found, false))
}

fn run(text: &str) -> (Derivation, Account) {
    let derivation = derivation(text).unwrap_or_else(|e| panic!("{e}"));
    let options = Options { plain: true, rigor: Rigor::Sampled, ..Options::default() };
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    (derivation, account)
}

/// What a measure with these lines finds on both motions.
fn measured(lines: &str) -> Vec<Measurement> {
    run(&format!("[[measure]]\nid = 'm'\nsays = 's'\n{lines}\n")).1.measurements
}

/// That a measure has these values on both motions, each within its bound, and the bounds are small.
#[track_caller]
fn has(lines: &str, expected: &[f64]) {
    for of in measured(lines) {
        assert_eq!(of.values.len(), expected.len(), "{lines}: {of:?}");
        for ((_, value, bound), expected) in of.values.iter().zip(expected) {
            assert!((value - expected).abs() <= *bound + 1e-15 * expected.abs(), "{lines}: {of:?} {expected}");
            assert!(*bound < 1e-8, "{lines}: {of:?}");
        }
    }
}

#[test]
fn changes_and_means_between_events() {
    let pi = std::f64::consts::PI;
    // x = 3 cos 2t passes 0 at π/4, 3π/4, …; upwards at 3π/4 + kπ: of 0.75, 1.75, 2.75 π three lie below 10.
    let up = "{ when = 'x=0', direction = 'up' }";
    let second = "{ when = 'x=0', direction = 'up', count = 2 }";
    has(&format!("formula = 't'\nat = {up}"), &[0.75 * pi, 1.75 * pi, 2.75 * pi]);
    // Times of return, each since the one before; the first has none before it.
    has(&format!("formula = 't'\nsince = {up}\nat = {up}"), &[pi, pi]);
    has(&format!("formula = 't'\nsince = 'x=0'\nat = {second}"), &[0.5 * pi]);
    has(&format!("formula = 'v'\nsince = 'v=0'\nat = {second}\ntake = 'change'"), &[6.0]);
    // Means over a period, and over a half of one.
    has(&format!("formula = 'x^2'\nsince = {up}\nat = {second}\ntake = 'mean'"), &[4.5]);
    has(&format!("formula = 'x'\nsince = {up}\nat = {second}\ntake = 'mean'"), &[0.0]);
    has(&format!("formula = '\\frac12v^2+2x^2'\nsince = {up}\nat = {up}\ntake = 'mean'"), &[18.0, 18.0]);
    has(&format!("formula = '|x|'\nsince = 'x=0'\nat = {second}\ntake = 'mean'"), &[6.0 / pi]);
    has(&format!("formula = 'e^{{x}}'\nsince = {up}\nat = {second}\ntake = 'mean'"), &[4.880_792_585_865_024]);
    // Over a kink, and over leaps, that lie inside: the mean of |x| is 6/π, and of the sign 0.
    has(&format!("formula = '|x|'\nsince = {up}\nat = {second}\ntake = 'mean'"), &[6.0 / pi]);
    let slanted = "{ when = 'v=2x', direction = 'up' }";
    has(
        &format!("formula = '\\operatorname{{sgn}}(x)'\nsince = {slanted}\nat = {slanted}\ntake = 'mean'"),
        &[0.0, 0.0],
    );
    // Through a pole there is no integral.
    for pole in ["\\frac1x", "\\frac{1}{x^2}"] {
        let lines = format!("formula = '{pole}'\nsince = {slanted}\nat = {slanted}\ntake = 'mean'");
        assert!(measured(&lines).iter().all(|m| m.values.is_empty() && m.reason.is_some()), "{pole}");
    }
}

/// What is narrower than the samples are dense is part of a mean; a kink is no place at which two rules differ by more than they are off.
#[test]
fn means_over_what_varies_rapidly() {
    let mean = |formula: &str, from: &str, to: &str| {
        format!("formula = '{formula}'\nsince = 't={from}'\nat = 't={to}'\ntake = 'mean'")
    };
    let needle = 0.5 * std::f64::consts::PI.sqrt();
    has(&mean("10^6e^{-(10^6(t-2.49))^2}", "1", "3"), &[needle]);
    // A hat of height 1 and width 2 · 10⁻³, of area 10⁻³.
    let hat = r"\frac12(|10^3(t-2.49)+1|+|10^3(t-2.49)-1|-2|10^3(t-2.49)|)";
    has(&mean(hat, "1", "3"), &[5e-4]);
    for (from, to, at) in [(0.45, 3.71, 2.85), (0.1, 3.3, 0.7), (1.23, 9.1, 3.21), (0.31, 2.87, 1.6180339)] {
        let area: f64 = 0.5 * ((at - from) * (at - from) + (to - at) * (to - at));
        has(&mean(&format!("|t-{at}|"), &from.to_string(), &to.to_string()), &[area / (to - from)]);
    }
    // Beside a pole with an integral the bound is an estimate, good to a factor.
    let root = 2.0 * (0.58_f64.sqrt() + 1.87_f64.sqrt()) / 2.45;
    for of in measured(&mean(r"\frac{1}{\sqrt{|t-0.81|}}", "0.23", "2.68")) {
        let (known, within) = (of.values.first(), |(_, x, bound): &(f64, f64, f64)| (x - root).abs() <= 4.0 * bound);
        assert!(known.is_none_or(within), "{of:?} {root}");
    }
}

#[test]
fn what_is_not_known_has_no_value() {
    let none = |lines: &str, words: &str| {
        for of in measured(lines) {
            let reason = of.reason.as_ref().map(ToString::to_string).unwrap_or_default();
            assert!(of.values.is_empty() && reason.contains(words), "{lines}: {of:?}");
        }
    };
    let first = "{ when = 'x=0', count = 1 }";
    none(&format!("formula = 't'\nsince = {first}\nat = {first}"), "does not happen before t = 0.785");
    none(&format!("formula = 't'\nsince = 'x=7'\nat = {first}"), "`x=7` does not happen before");
    none(&format!("formula = 't'\nsince = {first}\nat = 'x=7'"), "`x=7` does not happen on this motion");
    // Which of two events at one time comes first.
    none(&format!("formula = 't'\nsince = 'x^3=0'\nat = {first}"), "cannot be told");
    // The sides touch in between: that may have been the last time, or not.
    none(
        "formula = 't'\nsince = 'x+3=0'\nat = { when = 'v=0', direction = 'down', count = 2 }",
        "may happen at another time before",
    );
    none(
        &format!("formula = '\\sqrt{{x}}'\nsince = {first}\nat = {{ when = 'x=0', count = 2 }}\ntake = 'mean'"),
        "no value at",
    );
    // A whole part at a whole number is one of two, and so is an angle on its cut.
    for leaps in [r"\lfloor3t\rfloor", r"\operatorname{atan2}(t-2,-1)"] {
        none(&format!("formula = '{leaps}'\nat = 'e^{{t-2}}-1=0'"), "not determined");
        let change = "since = 't=1.7'\nat = 'e^{t-2}-1=0'\ntake = 'change'";
        none(&format!("formula = '{leaps}'\n{change}"), "not determined");
    }
}

#[test]
fn bad_input_is_refused() {
    let cases = [
        ("formula = 't'\nsince = 'x=0'", "needs `at`"),
        ("formula = 't'\nat = 'x=0'\ntake = 'mean'", "needs `since`"),
        ("formula = 't'\nsince = 'x=0'\nat = 'x=0'\ntake = 'median'", "there is no take `median`"),
        ("formula = 't'\nsince = { direction = 'up' }\nat = 'x=0'", "`since` needs `when`"),
        ("formula = 't'\nsince = 'x<0'\nat = 'x=0'", "an event is one equation"),
        ("formula = 't'\nfamilies = ['f']", "there is no family `f`"),
        ("formula = 't'\nsince = 'x=0'\nat = 'x=0'", "no problem"),
    ];
    for (lines, expected) in cases {
        let found = match derivation(&format!("[[measure]]\nid = 'm'\nsays = 's'\n{lines}\n")) {
            Err(found) => found,
            Ok(_) => "no problem".to_owned(),
        };
        assert!(found.contains(expected), "{lines}: {found}");
    }
}

const FAMILY: &str = r"
[[family]]
id = 'f'
of = 'formula'
vary = { 'a' = { from = 1, to = 100, count = 100 }, 'w' = { values = [2, 1] } }
where = ['a>0.5+w']
[[claim]]
id = 'small'
says = 's'
trajectories = []
families = ['f']
always = ['x<90.5']
expect = 'fails'
[[measure]]
id = 'energy'
says = 'energy'
formula = '\frac12v^2+\frac12w^2x^2'
trajectories = []
families = ['f']
[[measure]]
id = 'period'
says = 'time of return'
formula = 't'
since = { when = 'x=0', direction = 'up' }
at = { when = 'x=0', direction = 'up' }
trajectories = []
families = ['f']
";

#[test]
fn quantiles_over_a_family_hold_those_of_its_members() {
    let (derivation, account) = run(FAMILY);
    assert_eq!(account.measurements, []);
    let [energy, period] = &account.distributions[..] else { panic!("{:?}", account.distributions) };
    // a > 2.5 for w = 2, a > 1.5 for w = 1: 98 and 99 members.
    let mut all: Vec<f64> = (3..=100).map(|a| 2.0 * f64::from(a * a)).collect();
    all.extend((2..=100).map(|a| 0.5 * f64::from(a * a)));
    all.sort_by(f64::total_cmp);
    let found = &energy.distribution;
    assert_eq!((found.members, found.rejected, found.without, found.partial, found.values()), (197, 3, 0, 0, 197));
    for share in [0.05, 0.25, 0.5, 0.75, 0.95] {
        let exact = all[(share * 197.0_f64).ceil() as usize - 1];
        let (low, high) = found.quantile(share).expect("values");
        assert!(low <= exact && exact <= high && high - low < 0.01 * exact, "{share}: {low} {exact} {high}");
    }
    let (least, greatest) = (energy.least.as_ref().expect("one"), energy.greatest.as_ref().expect("one"));
    assert_eq!((least.number, greatest.number), (4, 199));
    assert!((least.value - 2.0).abs() < 1e-12 && (greatest.value - 20_000.0).abs() < 1e-9);
    assert!(greatest.toml.contains("'a' = 100.0, 'w' = 2.0"), "{}", greatest.toml);
    // With w = 1 there is one passage upwards before 10 and no return: 3π/2, and 7π/2 > 10.
    assert_eq!((period.distribution.without, period.distribution.values()), (99, 2 * 98));
    // Every kind of report tells them.
    for text in [report::page(&derivation, &account), report::markdown(&derivation, &account)] {
        assert!(text.contains("197 values on 197 members") && text.contains("50 % at most"), "{text}");
        assert!(text.contains("change of") && text.contains("no value on 99"), "{text}");
    }
    let text = report::summary(&derivation, &account, false, true);
    assert!(text.contains("197 values on 197 members"), "{text}");
    let data: serde_json::Value = serde_json::from_str(&report::json(&derivation, &account)).expect("JSON");
    assert_eq!(data["distributions"][0]["quantiles"].as_array().map(Vec::len), Some(5));
    assert_eq!(data["distributions"][0]["greatest"]["number"], 199);
}

#[test]
fn parts_have_the_same_quantiles_as_the_whole() {
    let session = || Session::of(derivation(FAMILY).expect("a derivation"));
    let ask = Ask { only_verdicts: true, trajectories: vec!["f".into()], ..Ask::default() };
    let text = |found: Result<rederive::Findings, rederive::Failure>| found.unwrap_or_else(|e| panic!("{e}")).json();
    let whole = text(session().check(&ask, &|_, _| {}));
    assert!(whole.contains("\"quantiles\""));
    let part = |k: u64| session().sweep("f", Part::new(k, 4).expect("a part"), &Limits::default(), &|_, _| {});
    let parts: Vec<String> = [3, 1, 4, 2].map(|k| part(k).unwrap_or_else(|e| panic!("{e}"))).into();
    let join = |parts: &[String]| {
        let named = parts.iter().enumerate().map(|(n, text)| Ok((n.to_string(), text.clone())));
        session().join(named, &Limits::default(), &|_, _| {})
    };
    assert_eq!(text(join(&parts)), whole);
    // A part whose greatest value is that of another member is seen: it is tried again.
    let mut forged = parts.clone();
    forged[2] = forged_part(&parts[2], "\"number\":199", "\"number\":198");
    let error = join(&forged).err().map(|e| e.to_string()).unwrap_or_default();
    assert!(error.contains("member 198 of the family `f`"), "{error}");
    forged[2] = forged_part(&parts[2], "\"rejected\":0,\"without\"", "\"rejected\":1,\"without\"");
    let error = join(&forged).err().map(|e| e.to_string()).unwrap_or_default();
    assert!(error.contains("it does not count every number"), "{error}");
}

/// A part that says something else, with an end that fits.
fn forged_part(text: &str, old: &str, new: &str) -> String {
    use sha2::{Digest, Sha256};
    assert!(text.contains(old), "{text}");
    let lines: Vec<&str> = text.lines().collect();
    let body: String = lines[..lines.len() - 1].iter().map(|line| format!("{}\n", line.replace(old, new))).collect();
    let hash: String = Sha256::digest(&body).iter().map(|b| format!("{b:02x}")).collect();
    format!("{body}{{\"end\":\"{hash}\"}}\n")
}

fn program(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    let output = command.current_dir(folder).args(arguments).output().expect("it runs");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn the_members_are_a_table() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("t.toml"), format!("{HEAD}{FAMILY}")).expect("it is written");
    let sweep = |more: &[&str]| program(folder.path(), &[&["sweep", "t.toml", "--family", "f"], more].concat());
    let (code, error) = sweep(&["--output", "all.jsonl", "--members", "all.csv"]);
    assert_eq!(code, Some(0), "{error}");
    let text = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect("it is there");
    let all = text("all.csv");
    let lines: Vec<&str> = all.lines().collect();
    assert_eq!((lines[0], lines.len()), ("member,a,w,small,energy,period", 198));
    assert!(lines[1].starts_with("4,2.0,1.0,holds,") && lines[1].ends_with(','), "{}", lines[1]);
    let last: Vec<&str> = lines[196].split(',').collect();
    assert_eq!(last[..4], ["199", "100.0", "2.0", "fails"]);
    let number = |x: &str| x.parse::<f64>().unwrap_or_else(|e| panic!("{x}: {e}"));
    assert!((number(last[4]) - 20_000.0).abs() < 1e-9);
    let periods: Vec<f64> = last[5].split(' ').map(number).collect();
    assert!(periods.len() == 2 && periods.iter().all(|p| (p - std::f64::consts::PI).abs() < 1e-9), "{periods:?}");
    // Parts, one behind the other, are the whole.
    let mut joined = String::new();
    for k in 1..=3 {
        let (part, csv) = (format!("{k}/3"), format!("{k}.csv"));
        assert_eq!(sweep(&["--part", &part, "--output", "p.jsonl", "--members", &csv]).0, Some(0));
        joined.push_str(text(&csv).split_once('\n').map_or("", |(_, rest)| rest));
    }
    assert_eq!(joined, all.split_once('\n').map_or("", |(_, rest)| rest));
    // The part is the same with and without its table.
    let with = text("p.jsonl");
    assert_eq!(sweep(&["--part", "3/3", "--output", "p.jsonl"]).0, Some(0));
    assert_eq!(text("p.jsonl"), with);
    // What cannot be meant leaves nothing.
    let (code, error) = sweep(&["--output", "same", "--members", "./same"]);
    assert!(code == Some(2) && error.contains("the output of two") && !folder.path().join("same").exists(), "{error}");
    let (code, error) = sweep(&["--output", "new.jsonl", "--members", "t.toml"]);
    assert!(code == Some(2) && !folder.path().join("new.jsonl").exists(), "{error}");
    let (code, _) = sweep(&["--output", "new.jsonl", "--members", "new.csv", "--resume"]);
    assert!(code == Some(2) && !folder.path().join("new.csv").exists());
    let (code, error) = sweep(&["--part", "3/1000", "--output", "new.jsonl", "--members", "new.csv"]);
    assert!(code == Some(2) && !folder.path().join("new.csv").exists(), "{error}");
}
