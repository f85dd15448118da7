//! Inputs that are made to exhaust the machine: each is answered within its budget, with a report.
//!
//! Each input is generated, checked by the program in a process of its own, and judged by its exit code, by what it printed, by
//! the report that it wrote, and, on Linux, by its peak memory. Time is not measured by the clock, which depends on what else
//! runs: a process that takes a hundred times as long as it should is killed, and fails the test.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A system, a motion, and no claim.
const HEAD: &str = r"
[derivation]
title = 'x'
concerns = 'y'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'k' = { role = 'parameter' }
";
const SYSTEM: &str = r"
[system.s]
states = ['x']
equations = ['\dot x=-kx']
";
const MOTION: &str = r"
[[trajectory]]
id = 'a'
system = 's'
parameters = { 'k' = 1 }
initial = { 'x' = 1 }
span = [0, 1]
";

fn claim(id: usize, formula: &str, more: &str) -> String {
    format!("[[claim]]\nid = 'c{id}'\nsays = 's'\nalways = ['{formula}']\n{more}\n")
}

fn file(claims: &str) -> String {
    [HEAD, SYSTEM, MOTION, claims].concat()
}

fn one(formula: &str) -> String {
    file(&claim(0, formula, ""))
}

/// What a run left behind.
struct Ran {
    code: Option<i32>,
    out: String,
    err: String,
    /// Largest memory that was seen, in megabytes; nothing where it cannot be known.
    peak: Option<u64>,
    /// Seconds of processor time that were seen; nothing where they cannot be known.
    seconds: Option<u64>,
    report: bool,
}

/// The peak of a running process, in kilobytes. Until the program has taken its place, a new process has the memory of the one that
/// started it, which may be asked for in the moment between.
fn peak(child: &Child) -> Option<u64> {
    let program = fs::read_link(format!("/proc/{}/exe", child.id())).ok()?;
    if program != fs::canonicalize(env!("CARGO_BIN_EXE_rederive")).ok()? {
        return None;
    }
    let text = fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().trim_end_matches("kB").trim().parse().ok()
}

/// The processor time of a running process, in seconds: of the user and of the system, in hundredths.
fn seconds(child: &Child) -> Option<u64> {
    let text = fs::read_to_string(format!("/proc/{}/stat", child.id())).ok()?;
    let fields = text.rsplit(')').next()?.split_whitespace().skip(11).take(2);
    Some(fields.filter_map(|field| field.parse::<u64>().ok()).sum::<u64>() / 100)
}

/// Runs the program in a folder; a run that does not end is killed.
fn run(folder: &Path, arguments: &[&str], longest: Duration) -> Ran {
    let [out, err] = ["out", "err"].map(|name| fs::File::create(folder.join(name)).expect("a file"));
    let mut child = Command::new(env!("CARGO_BIN_EXE_rederive"))
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::from(out))
        .stderr(Stdio::from(err))
        .spawn()
        .expect("the program starts");
    let (started, mut most, mut took) = (Instant::now(), None, None);
    let status = loop {
        most = most.max(peak(&child));
        took = took.max(seconds(&child));
        match child.try_wait().expect("it can be asked") {
            Some(status) => break status,
            None if started.elapsed() > longest => {
                child.kill().expect("it can be stopped");
                child.wait().expect("it stops");
                panic!("{arguments:?} does not end");
            }
            None => std::thread::sleep(Duration::from_millis(5)),
        }
    };
    let text = |name: &str| String::from_utf8_lossy(&fs::read(folder.join(name)).expect("a file")).into_owned();
    let report = folder.join("reports/f/report.json").exists();
    Ran { code: status.code(), out: text("out"), err: text("err"), peak: most.map(|k| k / 1024), seconds: took, report }
}

/// Checks a file, and sees to its memory.
fn check(text: &str, arguments: &[&str], megabytes: u64) -> Ran {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("f.toml"), text).expect("written");
    let all = [&["check", "f.toml"][..], arguments].concat();
    let ran = run(folder.path(), &all, Duration::from_secs(600));
    if let Some(peak) = ran.peak {
        assert!(peak <= megabytes, "{peak} MB: {}", ran.err);
    }
    ran
}

/// A file that is decided, or undecided for a reason: an exit code of those that a reader expects, and a report.
fn answers(text: &str, code: i32, megabytes: u64) -> Ran {
    let ran = check(text, &[], megabytes);
    assert_eq!(ran.code, Some(code), "{}{}", ran.out, ran.err);
    assert!(ran.report, "{}{}", ran.out, ran.err);
    ran
}

/// A file that is refused, with a word for it.
fn is_refused(text: &str, word: &str) {
    let ran = check(text, &[], 300);
    assert_eq!(ran.code, Some(2), "{}{}", ran.out, ran.err);
    assert!(ran.err.contains(word), "{}", ran.err);
}

#[test]
fn long_formulas_have_some_of_their_variants() {
    let product = answers(&one(&format!("x={}", "(x+k)".repeat(500))), 1, 400);
    assert!(product.out.contains("1 fail"), "{}", product.out);
    answers(&one(&format!("x={}", vec!["x"; 1_000].join("+"))), 1, 600);
    let terms: Vec<String> = (1..=300).map(|i| format!(r"{i}\sin({i}x)")).collect();
    answers(&one(&format!("x={}", terms.join("+"))), 1, 150);
}

#[test]
fn a_chain_of_fifty_thousand_relations_is_read_once() {
    let ran = check(&one(&vec!["x"; 50_000].join("=")), &["--no-reports"], 1_500);
    assert!(matches!(ran.code, Some(0 | 3)), "{}{}", ran.out, ran.err);
}

/// Masses between springs, of which those far from the ends are at rest for a while: so many unknowns, and their energy.
fn chain(unknowns: usize) -> String {
    let masses = 1..=unknowns / 2;
    let each = |of: &dyn Fn(usize) -> String, by: &str| masses.clone().map(of).collect::<Vec<_>>().join(by);
    let at = |i: usize| if masses.contains(&i) { format!("x_{{{i}}}") } else { "0".to_owned() };
    let state = |i: usize| format!("'x_{{{i}}}' = {{ role = 'state' }}\n'v_{{{i}}}' = {{ role = 'state' }}");
    let rate = |i: usize| {
        let (before, after) = (at(i - 1), at(i + 1));
        format!(r"'\dot x_{{{i}}}=v_{{{i}}}', '\dot v_{{{i}}}=k(-x_{{{i}}}+{before})+k(-x_{{{i}}}+{after})'")
    };
    let spring = |i: usize| format!(r"\frac12v_{{{i}}}^2+\frac k2({}-{})^2", at(i + 1), at(i));
    format!(
        "{}{}\n[system.s]\nstates = [{}]\nequations = [{}]\n[[trajectory]]\nid = 'a'\nsystem = 's'\nparameters = {{ 'k' = 1 }}\n\
         initial = {{ {} }}\nspan = [0, 10]\n[[claim]]\nid = 'energy'\nsays = 's'\n\
         first-integral = ['{}+\\frac k2 x_{{1}}^2']\n",
        HEAD.replace("'x' = { role = 'state' }\n", ""),
        each(&state, "\n"),
        each(&|i| format!("'x_{{{i}}}', 'v_{{{i}}}'"), ", "),
        each(&rate, ", "),
        each(&|i| format!("'x_{{{i}}}' = {}, 'v_{{{i}}}' = 0", i % 3 + 1), ", "),
        each(&spring, "+"),
    )
}

#[test]
fn two_hundred_unknowns() {
    for unknowns in [100, 200] {
        answers(&chain(unknowns), 0, 150);
    }
}

#[test]
fn many_claims_and_many_motions() {
    let claims: String = (0..10_000).map(|i| claim(i, r"\dot x=-kx", "")).collect();
    let ran = check(&file(&claims), &["--no-reports", "-q"], 700);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let motions: String = (0..10_000).map(|i| MOTION.replace("'a'", &format!("'a{i}'"))).collect();
    let text = [HEAD, SYSTEM, &motions, &claim(0, r"\dot x=-kx", "")].concat();
    let ran = check(&text, &["--no-reports", "-q"], 500);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
}

#[test]
fn a_chain_of_ten_thousand_steps_is_proved() {
    let steps = (1..10_000).map(|i| claim(i, r"\dot x=-kx", &format!("follows-from = ['c{}']", i - 1)));
    let text = file(&(claim(0, r"\dot x=-kx", "follows-from = ['s']") + &steps.collect::<String>()));
    let ran = check(&text, &["--no-reports"], 1_500);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    assert!(ran.out.contains("10000 hold"));
}

#[test]
fn what_is_nested_is_read_or_refused() {
    let rates = format!("x={}{}{}", r"\frac{d}{dt}(".repeat(12), r"\sin(x\cos x)", ")".repeat(12));
    answers(&one(&rates), 1, 300);
    for (open, close) in [("(", ")"), ("{", "}"), (r"\sqrt{", "}"), ("x^{", "}"), (r"\dot{", "}")] {
        is_refused(&one(&format!("x={}x{}", open.repeat(100_000), close.repeat(100_000))), "too deep");
    }
    is_refused(&(one("x=x") + "[z]\na = " + &"[".repeat(100_000)), "recurs");
    for body in [r"a_{N}+1", r"\sin(a_{N})+\cos(a_{N})", "a_{N}a_{N}+a_{N}"] {
        let each = |i: usize| {
            let formula = if i == 0 { "x+k".to_owned() } else { body.replace('N', &(i - 1).to_string()) };
            format!("'a_{{{i}}}' = {{ role = 'abbreviation', formula = '{formula}' }}\n")
        };
        let symbols: String = (0..5_000).map(each).collect();
        let text = [HEAD, &symbols, SYSTEM, MOTION, &claim(0, "x=a_{4999}", "")].concat();
        let ran = check(&text, &["--no-reports"], 500);
        assert!(matches!(ran.code, Some(1 | 3)), "{body}: {}{}", ran.out, ran.err);
    }
}

#[test]
fn large_numbers_are_no_large_work() {
    answers(&one(&format!("x={}", "7".repeat(500_000))), 3, 200);
    for formula in ["x^{1000000000}=x", "2^{1000000000}=x", "(x+k)^{1000000000}=x", r"3.7^{-1000000000}=x"] {
        let ran = check(&one(formula), &["--no-reports"], 200);
        assert!(matches!(ran.code, Some(1 | 3)), "{formula}: {}{}", ran.out, ran.err);
    }
    // Thirty squares of squares.
    for base in ["10^{9}", "2x+2k", r"\frac{3}{x}", r"2\sqrt{x}", "3+x-x"] {
        let tower = format!("{}{base}{}", "(".repeat(30), ")^2".repeat(30));
        for formula in [
            format!("x={tower}"),
            format!(r"\sqrt{{{tower}}}=x"),
            format!(r"\ln({tower})=x"),
            format!("x^2+{tower}=-1"),
        ] {
            let ran = check(&one(&formula), &["--no-reports"], 200);
            assert!(matches!(ran.code, Some(0 | 1 | 3)), "{formula}: {}{}", ran.out, ran.err);
        }
    }
    let long = file(&claim(0, r"\dot x=-kx", "")).replace("span = [0, 1]", "span = [0, 1e12]");
    let ran = check(&long, &["--no-reports"], 300);
    assert!(matches!(ran.code, Some(0 | 3)), "{}{}", ran.out, ran.err);
    let driven = long.replace(r"\dot x=-kx", r"\dot x=k\sin(x+t)");
    let ran = check(&driven, &["--no-reports"], 300);
    assert!(matches!(ran.code, Some(0 | 3)), "{}{}", ran.out, ran.err);
}

/// What varies too rapidly to be followed is undecided after a bounded number of looks, for all of a motion and not for each sample of it.
#[test]
fn what_varies_rapidly_is_looked_at_for_a_while() {
    let system = SYSTEM.replace("-kx", "k");
    let motion = MOTION.replace("span = [0, 1]", "span = [0, 100]").replace("'x' = 1", "'x' = 0");
    let formulas = [
        r"\frac{1}{(\sin(10^5x))^2}>0.5",
        r"\frac{1}{(\sin(10^5x))^2+10^{-9}}>0.5",
        r"e^{-1000(\sin(10^5x))^2}>-0.5",
        r"|\sin(10^9x)|+\arccos(\sin(10^9x))>-1",
        r"\ln|\sin(10^{15}x)|+\frac{1}{(\cos(10^6x))^{40}}>0",
    ];
    for formula in formulas {
        let text = [HEAD, &system, &motion, &claim(0, formula, "")].concat();
        let ran = check(&text, &[], 150);
        assert!(matches!(ran.code, Some(0 | 3)), "{formula}: {}{}", ran.out, ran.err);
    }
}

#[test]
fn a_search_for_solutions_ends() {
    let names = ["c", "d", "f", "g", "h", "l"];
    let symbols: String =
        ["a", "b"].iter().chain(&names).map(|n| format!("'{n}' = {{ role = 'parameter' }}\n")).collect();
    let unknowns: Vec<String> = names.iter().map(|n| format!("'{n}' = [-100, 100]")).collect();
    let pair = |i: usize| (names[i], names[(i + 1) % names.len()]);
    let equations: Vec<String> =
        (0..names.len()).map(pair).map(|(u, v)| format!(r"'\sin({u}a)+{v}b=\cos({v}{u})'")).collect();
    let text = format!(
        "[derivation]\ntitle = 'x'\nconcerns = 'y'\n[symbols]\n't' = {{ role = 'time' }}\n{symbols}[[claim]]\nid = 'c'\n\
         says = 's'\nranges = {{ 'a' = [0, 100], 'b' = [0, 100] }}\n\
         exists = {{ unknowns = {{ {} }}, such-that = [{}], unique = true }}\n",
        unknowns.join(", "),
        equations.join(", ")
    );
    let ran = answers(&text, 3, 400);
    assert!(ran.out.contains("work limit"), "{}", ran.out);
}

#[test]
fn papers_that_are_no_papers() {
    let folder = tempfile::tempdir().expect("a folder");
    let draft = |body: &str, megabytes: u64| {
        fs::write(folder.path().join("p.tex"), body).expect("written");
        let ran = run(folder.path(), &["init", "p.tex", "-o", "-"], Duration::from_secs(600));
        assert!(ran.peak.is_none_or(|peak| peak <= megabytes), "{:?} MB", ran.peak);
        assert!(matches!(ran.code, Some(0 | 2)), "{:?}: {}", ran.code, ran.err);
        ran
    };
    let whole = |body: &str| format!("\\documentclass{{article}}\\begin{{document}}{body}\\end{{document}}\n");
    draft(&whole(&format!("{}{}", "{".repeat(200_000), "}".repeat(200_000))), 300);
    let equation = |body: &str| format!("\\begin{{equation}}{body}\\end{{equation}}\n");
    draft(&whole(&equation(&format!("{}x=x{}", "{".repeat(200_000), "}".repeat(200_000)))), 400);
    let labelled: String = (0..60_000).map(|i| equation(&format!("\\label{{l{i}}}x=x"))).collect();
    assert_eq!(draft(&whole(&labelled), 900).code, Some(0));
    let alike: String = (0..60_000).map(|_| equation("\\label{l}x=x")).collect();
    assert_eq!(draft(&whole(&alike), 900).code, Some(0));
    // Names that are many, each of one formula, or each with a rate: not square in their number.
    let of_names = |body: &str, n: usize| -> String {
        let each = |i: usize| equation(&body.replace('N', &i.to_string()).replace('M', &(i + 1).to_string()));
        whole(&(0..n).map(each).collect::<String>())
    };
    assert!(draft(&of_names("a_{N}=b_{N}+1", 20_000), 900).seconds.is_none_or(|s| s < 15));
    assert!(draft(&of_names(r"\dot x_{N}=-k_{N}x_{M}", 10_000), 900).seconds.is_none_or(|s| s < 15));
    draft(&format!("\\newcommand{{\\a}}[99999999999]{{x}}{}", whole(&equation("\\a=x"))), 100);
}

#[test]
fn a_time_that_is_over_leaves_a_report() {
    for arguments in [&["--deadline", "0"][..], &["--memory", "1"]] {
        let ran = check(&one(r"\dot x=-kx"), arguments, 200);
        if arguments[0] == "--memory" && !cfg!(target_os = "linux") {
            continue;
        }
        assert_eq!(ran.code, Some(3), "{}{}", ran.out, ran.err);
        assert!(ran.report && ran.out.contains("1 undecided"), "{}", ran.out);
        assert!(ran.out.contains("work limit"), "{}", ran.out);
    }
    let ran = check(&one(r"\dot x=-kx"), &["--deadline", "1000", "--memory", "100000", "--jobs", "1"], 200);
    assert_eq!(ran.code, Some(0), "{}{}", ran.out, ran.err);
    let ran = check(&one(r"\dot x=-kx"), &["--deadline", "-1"], 200);
    assert_eq!(ran.code, Some(2));
}

#[test]
fn verdicts_alone_are_the_same_verdicts() {
    let text = file(&(claim(0, r"\dot x=-kx", "") + &claim(1, r"\dot x=kx", "") + &claim(2, "x<2", "")));
    let whole = check(&text, &["--format", "json"], 200);
    let alone = check(&text, &["--format", "json", "--only-verdicts"], 200);
    let read = |ran: &Ran| serde_json::from_str::<serde_json::Value>(&ran.out).expect("JSON");
    let (whole, alone) = (read(&whole), read(&alone));
    assert_eq!(whole["summary"], alone["summary"]);
    for (a, b) in whole["claims"].as_array().expect("claims").iter().zip(alone["claims"].as_array().expect("claims")) {
        for key in ["verdict", "strength", "residual", "witness"] {
            assert_eq!(a["results"][0][key], b["results"][0][key], "{key}");
        }
        assert!(b["results"][0]["discrimination"].is_null());
        assert!(b["variants"].is_null(), "{}", b["variants"]);
    }
    assert!(!whole["claims"][0]["results"][0]["discrimination"].is_null());
}

/// Runs that would take more seconds of processor time if one of their loops went over all that there is for each.
const LINEAR: u64 = 60;

fn is_linear(folder: &Path, arguments: &[&str]) -> Ran {
    let ran = run(folder, arguments, Duration::from_secs(600));
    assert!(ran.seconds.is_none_or(|seconds| seconds <= LINEAR), "{arguments:?}: {:?} s", ran.seconds);
    assert!(ran.peak.is_none_or(|peak| peak <= 600), "{:?} MB", ran.peak);
    ran
}

#[test]
fn many_symbols_are_found_by_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let each = |n: usize, line: &dyn Fn(usize) -> String| (0..n).map(line).collect::<String>();
    let tables = [
        each(60_000, &|i| format!("'a_{{{i}}}' = {{ role = 'parameter' }}\n")),
        each(60_000, &|i| format!("'a^{{({i})}}' = {{ role = 'parameter' }}\n")),
        each(45_000, &|i| {
            format!("'f_{{{i}}}(z)' = {{ role = 'abbreviation', arguments = ['z'], formula = 'z+{i}' }}\n")
        }),
    ];
    for table in tables {
        let text = [HEAD, &table, SYSTEM, MOTION, &claim(0, r"\dot x=-kx", "")].concat();
        fs::write(folder.path().join("f.toml"), text).expect("written");
        let ran = is_linear(folder.path(), &["check", "f.toml", "--no-reports", "--rigor", "sampled"]);
        assert_eq!(ran.code, Some(0), "{}", ran.err);
    }
}

#[test]
fn long_papers_are_looked_through() {
    let folder = tempfile::tempdir().expect("a folder");
    let displays: String = (0..30_000).map(|i| format!("\\[x_{{{i}}}=y+{i}\\] by \\eqref{{e{i}}}\n")).collect();
    let nested = |open: &str, close: &str| format!("\\[x={}y{}\\]", open.repeat(25_000), close.repeat(25_000));
    for body in [displays, nested("{", "}"), nested("x^{", "}"), nested(r"\hat{{", "}}")] {
        let text = format!("\\documentclass{{article}}\\begin{{document}}{body}\\end{{document}}\n");
        fs::write(folder.path().join("p.tex"), text).expect("written");
        let ran = is_linear(folder.path(), &["lint", "p.tex"]);
        assert!(matches!(ran.code, Some(0 | 3)), "{:?} {}", ran.code, ran.err);
    }
}

/// Problems at many places, in the formats for machines, and a diff of many verdicts.
#[test]
fn many_findings_are_told_with_their_places() {
    let folder = tempfile::tempdir().expect("a folder");
    let symbols: String = (0..40_000).map(|i| format!("'x_{{{i}}}'={{role='b'}}\n")).collect();
    fs::write(folder.path().join("f.toml"), format!("[symbols]\n{symbols}")).expect("written");
    for format in ["sarif", "github", "junit"] {
        let ran = is_linear(folder.path(), &["check", "f.toml", "--no-reports", "--format", format]);
        assert_eq!(ran.code, Some(2), "{}", ran.err);
    }
    let claims: Vec<String> =
        (0..60_000).map(|i| format!(r#"{{"id":"c{i}","results":[{{"trajectory":"t","verdict":"holds"}}]}}"#)).collect();
    let report = |claims: &str| format!(r#"{{"schema":1,"derivation":{{"id":"d"}},"claims":[{claims}]}}"#);
    fs::write(folder.path().join("all.json"), report(&claims.join(","))).expect("written");
    fs::write(folder.path().join("none.json"), report("")).expect("written");
    assert_eq!(is_linear(folder.path(), &["diff", "none.json", "all.json"]).code, Some(0));
}

/// What is kept of many verdicts takes no more memory than finding them.
#[test]
fn records_of_many_verdicts_are_bounded() {
    let motions: String =
        (0..1500).map(|i| format!("[[trajectory]]\nid='t{i}'\nformula={{'x'='t+{i}'}}\nspan=[0,1]\n")).collect();
    let claims: String = (0..20)
        .map(|i| claim(i, &format!("x>t-{}", i + 1), "").replace("always", "precision = 1e-6\nalways"))
        .collect();
    let head =
        "[derivation]\ntitle = 'x'\nconcerns = 'y'\n[symbols]\n't' = { role = 'time' }\n'x' = { role = 'state' }\n";
    let ran = check(&[head, &motions, &claims].concat(), &["--no-reports", "--cache", "kept"], 900);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
}
