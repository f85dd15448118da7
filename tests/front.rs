//! The first page, what must not be overlooked, and what the program says before, beside and after it: used as people use it.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use assert_cmd::Command;
use assert_cmd::assert::Assert;
use predicates::prelude::*;
use serde_json::Value;

/// Two motions of one system; claims follow.
const DECAY: &str = r"
[derivation]
title = 'Decay'
concerns = 'A textbook'
encoded-by = 'a test'

[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'k' = { role = 'parameter', positive = true }

[system.decay]
states = ['x']
equations = ['\dot x=-kx']

[[trajectory]]
id = 'slow'
title = 'A slow one'
system = 'decay'
initial = { 'x' = 1.5 }
parameters = { 'k' = 0.5 }
span = [0, 2]

[[trajectory]]
id = 'unit'
title = 'One with k = 1'
system = 'decay'
initial = { 'x' = 1.5 }
parameters = { 'k' = 1 }
span = [0, 2]
";

const LAW: &str = r"
[[claim]]
id = 'law'
says = 'The rate is minus kx.'
always = ['\dot x=-kx']
";

/// Fails on `slow`.
const UNIT_LAW: &str = r"
[[claim]]
id = 'unit-law'
says = 'The rate is minus x.'
always = ['\dot x=-x']
expect = { holds = ['unit'], fails = ['slow'] }
";

fn project(claims: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::create_dir(folder.path().join("derivations")).expect("a folder can be made");
    let text = format!("{DECAY}{}", claims.concat());
    fs::write(folder.path().join("derivations/decay.toml"), text).expect("a file can be written");
    folder
}

fn rederive(folder: &Path, arguments: &[&str]) -> Assert {
    let mut command = Command::cargo_bin("rederive").expect("the program is built");
    command.current_dir(folder).env_remove("CLICOLOR_FORCE").env_remove("COLUMNS").args(arguments).assert()
}

fn printed(run: &Assert) -> String {
    String::from_utf8_lossy(&run.get_output().stdout).into_owned()
}

/// What a file with these claims ends with, without and with `--strict`, and the words that both say loudly.
#[track_caller]
fn alarmed(claims: &[&str], code: i32, words: &str) {
    let project = project(claims);
    let run = rederive(project.path(), &["check", "--no-reports"]).code(code);
    let loud = printed(&run).lines().any(|line| line.starts_with("! "));
    assert!(loud, "nothing is said loudly:\n{}", printed(&run));
    let said = printed(&run).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains(words), "`{words}` is not said:\n{said}");
    let strict = rederive(project.path(), &["check", "--no-reports", "--strict"]).code(1);
    strict.stderr(predicate::str::contains(words));
}

#[test]
fn a_claim_that_applies_nowhere_is_said_loudly() {
    let nowhere = r"
[[claim]]
id = 'nowhere'
says = 'Where x is negative, it is large.'
assuming = ['x<0']
always = ['x>100']
expect.not-applicable = 'all'
";
    alarmed(&[LAW, nowhere], 0, "1 claim applies to no motion, so that nothing was checked of what is said: nowhere.");
}

#[test]
fn a_file_that_decides_nothing_is_no_success() {
    let nothing = r"
[[claim]]
id = 'nothing'
says = 'Where x is negative, it is large.'
assuming = ['x<0']
always = ['x>100']
expect.not-applicable = 'all'
";
    alarmed(&[nothing], 3, "No claim was decided: a run that checks nothing is no success.");
}

#[test]
fn a_refuted_premise_is_said_loudly() {
    let step = r"
[[claim]]
id = 'step'
says = 'The second rate is x.'
always = ['\ddot x=x']
follows-from = ['unit-law']
expect = { holds = ['unit'], fails = ['slow'] }
";
    alarmed(&[UNIT_LAW, step], 0, "Proofs rest on 1 premise that is refuted: unit-law.");
}

#[test]
fn a_file_without_any_of_that_passes_the_strict_check() {
    let project = project(&[LAW, UNIT_LAW]);
    let run = rederive(project.path(), &["check", "--no-reports", "--strict"]).code(0);
    assert!(!printed(&run).lines().any(|line| line.starts_with('!')), "{}", printed(&run));
}

/// The verdict, what does not stand with its reason, who encoded it and how to repeat it: on one printed page.
#[test]
fn the_first_page_says_all_that_a_letter_needs() {
    let conclusion = r"
[[claim]]
id = 'conclusion'
says = 'All decays are alike.'
conclusion = true
rests-on = ['unit-law']
always = ['x>0']
";
    let project = project(&[LAW, UNIT_LAW, conclusion]);
    let text = printed(&rederive(project.path(), &["check", "--no-reports", "--summary"]).code(0));
    let one_line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "“The rate is minus x” fails on 1 of 2 motions (certified).",
        "Of its one conclusion A stands on the motions of the file, but fails on another, drawn at random; it also rests on “The rate is \
         minus x”, which fails on 1 of 2 motions.",
        "A ◐ All decays are alike. x>0; holds at every time of 2 motions.",
        "“The rate is minus x” ◐ → A",
        "The rate is minus x. (unit-law)",
        "tested as: x\u{307}=-x",
        "Fails on 1 of 2 motions (certified)",
        "On slow at t=",
        "Conclusion A rests on it.",
        "Encoded by a test. To repeat it: rederive check derivations/decay.toml",
    ] {
        assert!(one_line.contains(part), "`{part}` is missing:\n{text}");
    }
    assert!(text.lines().count() <= 60 && text.lines().all(|l| l.chars().count() <= 100), "one page:\n{text}");
    // The report begins with the same lines, and so does the longer form; the matrix comes only when it is asked for.
    let long = printed(&rederive(project.path(), &["check", "--no-reports"]).code(0));
    assert!(long.starts_with(&text), "{long}");
    assert!(!long.contains("H holds   h holds"), "{long}");
    let matrix = printed(&rederive(project.path(), &["check", "--no-reports", "--matrix"]).code(0));
    assert!(matrix.starts_with(&text) && matrix.contains("H holds   h holds"), "{matrix}");
    let same = rederive(project.path(), &["report", "derivations/decay.toml", "--summary"]).code(0);
    assert_eq!(printed(&same), text);
    let letter = ["check", "--no-reports", "--summary", "--format", "tex"];
    let tex = printed(&rederive(project.path(), &letter).code(0));
    assert!(
        tex.contains(r"\documentclass") && tex.contains("The rate is minus") && !tex.contains(r"\begin{longtable}"),
        "{tex}"
    );
}

/// Only the labels of the matrix on page one have no room for a long name: the card below it has all of it.
#[test]
fn names_of_claims_are_not_cut() {
    let name = "a-claim-with-a-name-of-more-than-thirty-five-letters";
    let project = project(&[LAW, &UNIT_LAW.replace("unit-law", name)]);
    let text = printed(&rederive(project.path(), &["check", "--no-reports", "--matrix"]).code(0));
    assert!(text.lines().any(|l| l.contains(&format!("{name}  "))), "{text}");
    assert!(
        text.lines().any(|l| l.starts_with("What does not stand: ") && l.ends_with(&format!("({name})"))),
        "{text}"
    );
    assert!(!text.contains('…'), "page one calls it by its words: {text}");
}

/// `explain` says of every pair what `check` says: the verdict, its strength, and the proof in the same words.
#[test]
fn explain_explains_what_check_says() {
    let step = r"
[[claim]]
id = 'step'
says = 'The second rate.'
always = ['\ddot x=k^2x']
follows-from = ['law']
";
    let project = project(&[LAW, UNIT_LAW, step]);
    let check = rederive(project.path(), &["check", "--no-reports", "--format", "json"]).code(0);
    let report: Value = serde_json::from_str(&printed(&check)).expect("JSON");
    let mut seen = 0;
    for claim in report["claims"].as_array().expect("claims") {
        let id = claim["id"].as_str().expect("an id");
        let text = printed(&rederive(project.path(), &["explain", id]).code(0));
        for result in claim["results"].as_array().expect("results") {
            let on = result["trajectory"].as_str().expect("a name");
            let (verdict, strength) = (result["verdict"].as_str().expect("a verdict"), result["strength"].as_str());
            let strength = strength.map(|s| format!(" ({s})")).unwrap_or_default();
            let line = format!("  {on}  {verdict}{strength}");
            let begins = |l: &str| l == line || l.starts_with(&format!("{line},"));
            assert!(text.lines().any(begins), "{line} is not said of {id}:\n{text}");
            assert!(text.contains("What would change it:"), "{text}");
            if let Some(left) = result["witness"]["left"].as_f64() {
                assert!(text.contains(&format!("left   {left}")), "{text}");
            }
            seen += 1;
        }
        // One motion alone is explained alike.
        let alone = printed(&rederive(project.path(), &["explain", id, "--on", "slow"]).code(0));
        let pair = alone.split("\n\n  slow  ").nth(1).expect("the pair").trim_end();
        assert!(text.contains(pair), "{alone}\n{text}");
    }
    assert_eq!(seen, 6);
    let proved = printed(&rederive(project.path(), &["explain", "step"]).code(0));
    assert!(proved.contains("Follows from\n    law\n"), "{proved}");
}

#[test]
fn reports_of_two_derivations_are_compared_and_said_to_be_two() {
    let project = project(&[LAW, UNIT_LAW]);
    let other = fs::read_to_string(project.path().join("derivations/decay.toml")).expect("the file");
    fs::write(project.path().join("derivations/other.toml"), other.replace("'x' = 1.5", "'x' = 1.25"))
        .expect("written");
    rederive(project.path(), &["check", "--quiet"]).code(0);
    let (old, new) = ("reports/decay/report.json", "reports/other/report.json");
    let run = rederive(project.path(), &["diff", old, new]).code(0);
    run.stderr(predicate::str::contains("`decay` is compared with `other`: the derivations have different ids"))
        .stdout("No verdict has changed.\n");
}

#[test]
fn without_derivations_the_next_step_is_said() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for command in ["check", "list"] {
        let run = rederive(folder.path(), &[command]).code(2);
        run.stderr(predicate::str::contains("rederive init PAPER.tex").and(predicate::str::contains("`derivations`")));
    }
}

/// The commands of the program, as its own help lists them.
fn commands() -> Vec<String> {
    let help = printed(&rederive(Path::new("."), &["--help"]).code(0));
    let list = help.split("Commands:\n").nth(1).and_then(|rest| rest.split("\n\n").next()).expect("a list").to_owned();
    let first =
        |line: &str| line.strip_prefix("  ").filter(|l| !l.starts_with(' '))?.split(' ').next().map(str::to_owned);
    list.lines().filter_map(first).filter(|name| name != "help").collect()
}

/// Lines that we broke ourselves are not broken again on a terminal of eighty letters, and files that are named exist.
#[test]
fn help_is_laid_out_and_names_what_exists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut names = commands();
    assert!(names.len() > 8 && names.contains(&"prove".to_owned()), "{names:?}");
    names.insert(0, String::new());
    for name in &names {
        let arguments: Vec<&str> = [name.as_str(), "--help"].into_iter().filter(|a| !a.is_empty()).collect();
        let help = printed(&rederive(root, &arguments).code(0));
        let own = ["\nExit codes:\n", "\nSymbols: "].iter().filter_map(|m| help.find(m)).min().unwrap_or(help.len());
        for line in help[own..].lines() {
            assert!(line.chars().count() <= 80, "{name}: {line}");
            // A line goes on deeper than it began, and never at the margin.
            let fresh = line.is_empty() || line.starts_with("  ") || line.ends_with(':') || !help[..own].is_empty();
            assert!(fresh, "{name}: {line}");
        }
        for code in help[own..].split("Exit codes:\n").skip(1).flat_map(str::lines) {
            let entry = code.trim_start().split("  ").next().is_some_and(|n| n.trim().parse::<u8>().is_ok());
            assert!(entry || code.starts_with("      "), "{name}: {code}");
        }
        for word in help.split_whitespace().filter(|w| w.starts_with("derivations/") && w.ends_with(".toml")) {
            assert!(word == "derivations/PAPER.toml" || root.join(word).is_file(), "{name}: {word} does not exist");
        }
    }
}

/// On a terminal, what takes longer than half a second says what is being done, also while a single enclosure is at work.
#[test]
#[cfg(unix)]
fn progress_is_said_on_a_terminal() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let program = assert_cmd::cargo::cargo_bin("rederive");
    let line = format!("'{}' check derivations/pendulum.toml --no-reports", program.display());
    let started = Instant::now();
    let Ok(run) = std::process::Command::new("script").args(["-qec", &line, "/dev/null"]).current_dir(root).output()
    else {
        eprintln!("there is no `script` here: that progress is shown was not tried");
        return;
    };
    let (took, out) = (started.elapsed(), String::from_utf8_lossy(&run.stdout).into_owned());
    let told = out.find("The plane pendulum").expect("the first page");
    let says = |words: &str| out[..told].contains(&format!("pendulum: {words}"));
    let any = says("motions are built")
        || says("claims are tried on motions")
        || says("proofs, enclosures, altered formulas");
    assert!(any || took < Duration::from_millis(900), "nothing is said in {took:?}:\n{out}");
}

/// Of claims that carry nothing the one that is off by more comes first, wherever the paper has it.
#[test]
fn a_large_error_comes_before_a_small_one() {
    let nearly = "\n[[claim]]\nid = 'nearly'\nsays = 'Nearly.'\nalways = ['\\dot x=-1.001kx']\n";
    let far = "\n[[claim]]\nid = 'far'\nsays = 'Far.'\nalways = ['\\dot x=-2kx']\n";
    let folder = project(&[nearly, far]);
    let run = rederive(folder.path(), &["check", "--no-reports", "--no-cache", "--summary"]);
    let text = printed(&run);
    let cards = text.split_once("heaviest first").map_or("", |(_, cards)| cards);
    let place = |words: &str| cards.find(words).unwrap_or_else(|| panic!("{words} is missing: {text}"));
    assert!(place("Far.") < place("Nearly."), "{text}");
}
