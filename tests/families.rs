//! Families of motions: members are the motions that their texts say, few failures are found, and bad input has its place.

use std::path::Path;
use std::process::Command;

use rederive::check::family::{Part, Row, sweep};
use rederive::check::{Account, CheckError, ClaimAccount, FamilyAccount, Limits, MemberAccount, Options, Rigor, check};
use rederive::derivation::{Derivation, load, parse};
use rederive::diag::{Source, render};
use serde_json::Value;

fn corpus() -> Derivation {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/families.toml");
    load(&path).unwrap_or_else(|found| panic!("{}", render(&found, false)))
}

fn plain() -> Options {
    Options { plain: true, ..Options::default() }
}

fn run(derivation: &mut Derivation) -> Account {
    check(derivation, &plain(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"))
}

fn claim<'a>(account: &'a Account, id: &str) -> &'a ClaimAccount {
    account.claims.iter().find(|c| c.id == id).expect("the claim")
}

fn on<'a>(account: &'a Account, id: &str, family: &str) -> &'a FamilyAccount {
    claim(account, id).families.iter().find(|f| f.family == family).expect("the family")
}

fn shown(family: &FamilyAccount) -> impl Iterator<Item = &MemberAccount> {
    let all = [&family.first_failing, &family.clearest_failing, &family.first_undecided, &family.closest_call];
    all.into_iter().flatten()
}

const HEAD: &str = r"
[derivation]
title = 'T'
concerns = 'C'

[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'k' = { role = 'parameter', positive = true }
'I' = { role = 'parameter', shape = 'diagonal 3', positive = true }
'c' = { role = 'parameter' }
'e' = { role = 'constant', formula = '2' }
'y' = { role = 'observable', formula = 'x^2' }

[system.s]
states = ['x']
equations = ['\ddot x=-kx']

[[trajectory]]
id = 'a'
system = 's'
parameters = { 'k' = 1, 'I' = [1, 2, 3] }
initial = { 'x' = 1, '\dot x' = 0 }
span = [0, 1]

[[trajectory]]
id = 'mirrored'
from = 'a'
map = { 'x' = '-x' }

[[trajectory]]
id = 'formula'
formula = { 'x' = 'k t' }
parameters = { 'k' = 1 }
span = [0, 1]
";

const CLAIM: &str = "\n[[claim]]\nid = 'c'\nsays = 's'\nalways = ['x<2']\nfamilies = ['f']\n";

/// The problems of a file with these lines of one family, when it is read or when it is checked.
fn problems(family: &str) -> String {
    let text = format!("{HEAD}\n[[family]]\nid = 'f'\n{family}\n{CLAIM}");
    let source = Source { path: "derivations/test.toml".into(), text };
    match parse(source, "test") {
        Err(found) => render(&found, false),
        Ok(derivation) => match check(&derivation, &plain(), &|_, _| {}) {
            Err(CheckError::Problems(found)) => render(&found, false),
            other => format!("no problem: {other:?}"),
        },
    }
}

#[test]
fn a_member_that_is_pasted_reaches_the_same_verdict() {
    let mut derivation = corpus();
    let account = run(&mut derivation);
    let mut pasted = 0;
    for found in &account.claims {
        for member in found.families.iter().flat_map(shown) {
            let text = format!("{}\n{}", derivation.file.text, member.toml);
            let source = Source { path: "derivations/pasted.toml".into(), text };
            let mut again =
                parse(source, "pasted").unwrap_or_else(|e| panic!("{}\n{}", render(&e, false), member.toml));
            let last = again.trajectories.len() - 1;
            let id = again.trajectories[last].id.clone();
            for c in again.claims.iter_mut().filter(|c| c.id == found.id) {
                c.trajectories = vec![last];
                c.expect = vec![None];
                c.families.clear();
                c.expect_of_families.clear();
            }
            let options = Options { claims: vec![found.id.clone()], trajectories: vec![id], ..plain() };
            let account = check(&again, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
            let verdict = &claim(&account, &found.id).results[0].verdict;
            assert_eq!(verdict.outcome(), member.verdict.outcome(), "{} {}", found.id, member.toml);
            let sides = |v: &rederive::check::Verdict| v.evidence().witness.as_ref().map(|w| (w.t, w.left, w.right));
            assert_eq!(sides(verdict), sides(&member.verdict), "{} {}", found.id, member.toml);
            pasted += 1;
        }
    }
    assert!(pasted >= 7, "{pasted}");
}

/// Errors of members are estimated from their steps at first, with wider bounds: claims that are false by as little as rounding must
/// have the verdicts that trajectories of the file have.
#[test]
fn what_is_nearly_true_has_the_verdict_of_a_trajectory() {
    const SIZES: [&str; 9] =
        ["10^{-10}", "10^{-11}", "10^{-12}", "3*10^{-13}", "10^{-13}", "3*10^{-14}", "10^{-14}", "10^{-15}", "0"];
    let claims: Vec<String> = SIZES
        .iter()
        .map(|size| size.replace('*', r"\cdot "))
        .enumerate()
        .flat_map(|(n, size)| {
            let claim = |kind: &str, formula: String| {
                format!("\n[[claim]]\nid = '{kind}{n}'\nsays = 's'\nalways = ['{formula}']\ntrajectories = ['a']\nfamilies = ['f']\n")
            };
            [
                claim("equal", format!("\\dot x^2+kx^2=k+{size}t")),
                claim("less", format!("\\dot x^2+kx^2\\le k+{size}(1-t)")),
                claim("apart", format!("\\dot x^2+kx^2\\ne k+{size}")),
            ]
        })
        .collect();
    let (decided, failing) = as_members_and_alone(&claims.concat());
    assert!(decided > 400 && failing > 150, "{decided} {failing}");
}

/// Where a family has equations alone, those that hold beyond doubt are not weighed member by member.
#[test]
fn equations_by_themselves_have_the_verdict_of_a_trajectory() {
    let always = |n: usize, formula: &str| {
        let form = if formula.contains('=') { "always" } else { "first-integral" };
        format!(
            "\n[[claim]]\nid = 'c{n}'\nsays = 's'\n{form} = ['{formula}']\ntrajectories = ['a']\nfamilies = ['f']\n"
        )
    };
    let one = |formulas: &[&str]| -> (usize, usize) {
        as_members_and_alone(&formulas.iter().enumerate().map(|(n, formula)| always(n, formula)).collect::<String>())
    };
    // What holds by itself; what is off by little; what is hidden by the size of its terms, or by how wide its bound is.
    assert_eq!(one(&[r"\dot x^2+kx^2=k", r"kx^2+\dot x^2"]), (60, 0));
    for size in ["10^{-10}", "10^{-12}", "10^{-13}", r"3\cdot10^{-14}", "10^{-14}"] {
        let found = one(&[&format!(r"\dot x^2+kx^2=k+{size}t")]);
        assert!(found.0 > 0, "{size}: {found:?}");
    }
    assert_eq!(one(&[r"(x+10^{20})-10^{20}=2x"]).0, 0, "its terms hide what it says");
    assert_eq!(one(&[r"(x+10^{6})-10^{6}=x"]), (30, 0));
    assert_eq!(one(&[r"(x+10^{12})-10^{12}=x", r"\dot x^2+kx^2=k"]), (60, 0));
    assert_eq!(one(&[r"\frac{x}{x}=1"]).1, 0, "it has no value where x vanishes");
    let fast = r"\cos((10^8+1)x)=\cos(10^8x)\cos x-\sin(10^8x)\sin x";
    assert_eq!(one(&[fast]).0, 0, "its bounds are wider than what is asked");
}

/// Tries claims on the members of a family and on trajectories of a file, one by one: how many were decided, and how many of these
/// fail. No two verdicts contradict each other.
fn as_members_and_alone(claims: &str) -> (usize, usize) {
    let family = "\n[[family]]\nid = 'f'\nof = 'a'\nvary = { 'k' = { from = 1, to = 30, count = 30 } }\n";
    let text = format!("{HEAD}{family}{claims}").replace("span = [0, 1]", "span = [0, 10]");
    let alone = text.replace(family, "").replace("families = ['f']\n", "");
    let parsed = |text: String| {
        let source = Source { path: "derivations/nearly.toml".into(), text };
        parse(source, "nearly").unwrap_or_else(|e| panic!("{}", render(&e, false)))
    };
    let mut rows: Vec<(u64, Vec<Option<bool>>)> = Vec::new();
    let derivation = parsed(text.clone());
    let mut each = |row: &Row| {
        rows.push((row.number, row.verdicts.iter().map(|v| v.outcome().truth()).collect()));
    };
    sweep(&derivation, "f", Part::WHOLE, &Limits::default(), &|_, _| {}, &mut each).unwrap();
    let (mut decided, mut failing) = (0, 0);
    for (number, verdicts) in rows {
        let derivation = parsed(alone.replace("'k' = 1, 'I'", &format!("'k' = {number}, 'I'")));
        let options = Options { rigor: Rigor::Sampled, ..plain() };
        let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
        for (claim, verdict) in account.claims.iter().zip(verdicts) {
            let alone = claim.results[0].verdict.outcome().truth();
            let contradicts = verdict.zip(alone).is_some_and(|(a, b)| a != b);
            assert!(!contradicts, "{} on {number}: {verdict:?}, alone {alone:?}", claim.id);
            // Further integrations are made where the steps alone do not decide.
            assert!(verdict.is_some() || alone.is_none(), "{} on {number}: alone {alone:?}", claim.id);
            decided += usize::from(verdict.is_some());
            failing += usize::from(verdict == Some(false));
        }
    }
    (decided, failing)
}

#[test]
fn a_claim_that_is_false_for_few_members_is_caught() {
    let account = run(&mut corpus());
    let found = on(&account, "bounded", "amplitudes");
    assert_eq!((found.counts.members, found.counts.fails, found.counts.holds, found.counts.rejected), (9, 2, 7, 0));
    let first = found.first_failing.as_ref().expect("a member");
    assert_eq!((first.number, first.values.as_slice()), (8, &[("x".to_owned(), 3.01)][..]));
    assert_eq!(found.clearest_failing.as_ref().map(|m| m.number), Some(9));
    assert_eq!(found.closest_call.as_ref().map(|m| m.number), Some(7));
    // A grid is no sample.
    assert_eq!(found.failing_share, None);
    assert_eq!(account.summary().fails, 4);
}

#[test]
fn draws_are_counted_and_bound_the_share_that_fails() {
    let account = run(&mut corpus());
    let found = on(&account, "energy", "drawn");
    assert_eq!((found.counts.members, found.counts.holds), (40, 40));
    assert!(found.counts.rejected > 0, "{found:?}");
    let share = found.failing_share.expect("a sample");
    // 1 − 0.05^(1/40)
    assert!((share.at_most - 0.072_157_5).abs() < 1e-6, "{share:?}");
    assert_eq!(on(&account, "energy", "both").failing_share, None);
    assert_eq!(on(&account, "energy", "both").counts.members, 12);
    // The strongest word for a family, whatever is proved of its members.
    assert!(
        account
            .claims
            .iter()
            .flat_map(|c| &c.families)
            .all(|f| { matches!(f.verdict.outcome().strength(), Some("sampled") | None) })
    );
}

#[test]
fn the_number_of_a_member_determines_it() {
    // The same draws, of which more are made: the first are the same.
    let of = |draws: usize| {
        let family = format!(
            "of = 'a'\nvary = {{ 'k' = {{ log-uniform = [0.1, 10] }}, 'x' = {{ normal = [0, 1] }} }}\ndraws = {draws}\nseed = 5\nwhere = ['x>0']"
        );
        let text = format!("{HEAD}\n[[family]]\nid = 'f'\n{family}\n{}", CLAIM.replace("x<2", "x<0"));
        let mut derivation = parse(Source { path: "t.toml".into(), text }, "t").expect("no problems");
        let account = run(&mut derivation);
        on(&account, "c", "f").first_failing.clone().expect("it fails on all")
    };
    let (few, many) = (of(3), of(50));
    assert_eq!((few.number, &few.values), (1, &many.values));
    let texts: Vec<String> = few.values.iter().map(|(name, x)| format!("{name} = {x:?}")).collect();
    assert_eq!(texts, FIRST_DRAWN);
    assert!(few.toml.contains("system = 's'") && few.toml.contains("span = [0, 1]"), "{}", few.toml);
}

/// The first member above, on every machine; computed a second time by a program of ten lines in Python.
const FIRST_DRAWN: [&str; 2] = ["k = 2.14951873669175", "x = 0.312135213535817"];

#[test]
fn bad_input_is_refused_with_its_place() {
    let grid = "'x' = { from = 0, to = 1, count = 3 }";
    let drawn = "draws = 5\nseed = 1";
    let cases: &[(&str, &[&str])] = &[
        ("of = 'a'", &["[[family]] needs `vary`"]),
        ("of = 'a'\nvary = {}", &["varies nothing", "^"]),
        ("of = 'b'\nvary = {}", &["there is no trajectory `b`", "^"]),
        ("of = 'mirrored'\nvary = {}", &["`mirrored` comes from another trajectory", "vary the trajectory"]),
        ("of = 'a'\nvary = { 'z' = { values = [1] } }", &["there is no symbol `z`"]),
        ("of = 'a'\nvary = { 'c' = { values = [1] } }", &["`a` gives no value to `c`", "add 'c' to `parameters`"]),
        ("of = 'a'\nvary = { 'e' = { values = [1] } }", &["`e` is a constant"]),
        ("of = 'a'\nvary = { 'y' = { values = [1] } }", &["`y` is neither a parameter nor a state"]),
        (
            "of = 'a'\nvary = { 'I' = { values = [1] } }",
            &["`I` is not one real number", "give its components by parameters"],
        ),
        ("of = 'formula'\nvary = { 'x' = { values = [1] } }", &["`formula` gives no value to `x`", "formulas in time"]),
        ("of = 'a'\nvary = { 'x' = { values = [0.1000000000000000001] } }", &["it has too many digits"]),
        ("of = 'a'\nvary = { 'x' = { values = [] } }", &["has no members: `values` is empty"]),
        (
            "of = 'a'\nvary = { 'x' = { from = 0, to = 1, count = 0 } }",
            &["this family has no members", "`count` is 2 or more"],
        ),
        ("of = 'a'\nvary = { 'x' = { from = 0, to = 1, count = 1 } }", &["at least its two ends"]),
        ("of = 'a'\nvary = { 'x' = { from = 0, to = 1 } }", &["needs `count`"]),
        ("of = 'a'\nvary = { 'x' = { from = 1, to = 0, count = 3 } }", &["in the wrong order"]),
        ("of = 'a'\nvary = { 'x' = { from = '\\pi', to = 3, count = 3 } }", &["in the wrong order", "^"]),
        ("of = 'a'\nvary = { 'x' = { from = 1, to = 1, count = 3 } }", &["the same number"]),
        (
            "of = 'a'\nvary = { 'x' = { from = 0, to = 1, count = 3, spacing = 'logarithmic' } }",
            &["a logarithmic range lies above 0"],
        ),
        ("of = 'a'\nvary = { 'x' = { from = 0, to = 1, count = 3, spacing = 'log' } }", &["there is no spacing `log`"]),
        ("of = 'a'\nvary = { 'k' = { from = 0, to = 1, count = 3 } }", &["`k` is declared positive"]),
        ("of = 'a'\nvary = { 'k' = { values = ['\\sqrt{-1}'] } }", &["are no real numbers"]),
        ("of = 'a'\nvary = { 'k' = { normal = [-1, 1] } }\ndraws = 5\nseed = 1", &["`k` is declared positive"]),
        ("of = 'a'\nvary = { 'x' = { normal = [1, 0] } }\ndraws = 5\nseed = 1", &["a standard deviation lies above 0"]),
        (
            "of = 'a'\nvary = { 'x' = { log-uniform = [0, 1] } }\ndraws = 5\nseed = 1",
            &["a logarithmic range lies above 0"],
        ),
        ("of = 'a'\nvary = { 'x' = { uniform = [1] } }\ndraws = 5\nseed = 1", &["`uniform` has two numbers"]),
        (
            "of = 'a'\nvary = { 'x' = { uniform = [0, 1], values = [1] } }\ndraws = 5\nseed = 1",
            &["it varies in two ways"],
        ),
        ("of = 'a'\nvary = { 'x' = {} }", &["how it varies is not said"]),
        ("of = 'a'\nvary = { 'x' = [0, 1] }", &["must be one of { from = a"]),
        (
            "of = 'a'\nvary = { 'x' = { uniform = [0, 1] } }",
            &["`draws` says how many times", "`seed` says which draws"],
        ),
        ("of = 'a'\nvary = { 'x' = { uniform = [0, 1] } }\ndraws = 0\nseed = 1", &["this family has no members"]),
        ("of = 'a'\nvary = { 'x' = { uniform = [0, 1] } }\ndraws = -3\nseed = 1", &["`draws` is a whole number"]),
        (
            "of = 'a'\nvary = { 'x' = { uniform = [0, 1] } }\ndraws = 5000000000\nseed = 1",
            &["at most 1000000000 members"],
        ),
        ("of = 'a'\nvary = { 'x' = { values = [1] } }\ndraws = 5", &["nothing is drawn"]),
        (
            "of = 'a'\nvary = { 'x' = { values = [1] } }\nsequence = 'random'",
            &["no sequence of draws", "leave `sequence` out"],
        ),
        (
            "of = 'a'\nvary = { 'x' = { uniform = [0, 1] } }\ndraws = 5\nseed = 1\nsequence = 'sobol'",
            &["there is no sequence `sobol`"],
        ),
        (
            "of = 'a'\nvary = { 'x' = { polar = [0, 4] } }\ndraws = 5\nseed = 1",
            &["a polar angle lies between 0 and π", "an azimuth is uniform"],
        ),
        ("of = 'a'\nvary = { 'x' = { polar = [1, 0] } }\ndraws = 5\nseed = 1", &["in the wrong order"]),
        ("of = 'a'\nvary = { 'k' = { polar = [0, 1] } }\ndraws = 5\nseed = 1", &["`k` is declared positive"]),
        ("of = 'a'\nvary = { 'x' = { values = [1] } }\nmembers = 5", &["has no key `members`"]),
    ];
    for (family, expected) in cases {
        let found = problems(family);
        for words in *expected {
            assert!(found.contains(words), "{family}\n{found}");
        }
        assert!(found.contains("derivations/test.toml:"), "{family}\n{found}");
    }
    for (constraint, expected) in [
        ("'x=1'", "a constraint is an inequality"),
        ("'t<1'", "`t` has no value here"),
        ("'z<1'", "z"),
        ("'\\lim_{t\\rightarrow\\infty}x<1'", "a member satisfies relations between numbers"),
        ("'x<0'", "the family `f` has no members: all 3 are rejected"),
        ("'x+k>\\frac1x'", "no problem"),
        ("'y\\le k'", "no problem"),
    ] {
        let found = problems(&format!("of = 'a'\nvary = {{ {grid} }}\nwhere = [{constraint}]"));
        assert!(found.contains(expected), "{constraint}\n{found}");
    }
    let rare = problems(&format!("of = 'a'\nvary = {{ 'x' = {{ uniform = [0, 1] }} }}\n{drawn}\nwhere = ['x>1']"));
    assert!(rare.contains("work limit: of 10000 draws for member 1") && rare.contains("where = ['x>1']"), "{rare}");
}

#[test]
fn names_are_looked_up_where_claims_use_them() {
    let family = "\n[[family]]\nid = 'f'\nof = 'a'\nvary = { 'x' = { values = [1, 3] } }\n";
    let read = |tail: &str| {
        let text = format!("{HEAD}{family}{tail}");
        parse(Source { path: "t.toml".into(), text }, "t").map_err(|found| render(&found, false))
    };
    let refused = |tail: &str| read(tail).expect_err("it is refused");
    assert!(refused(family).contains("there are two of family `f`"));
    assert!(refused(&family.replace("'f'", "'a'")).contains("a trajectory is called `a`, too"));
    let claim = |rest: &str| format!("\n[[claim]]\nid = 'c'\nsays = 's'\nalways = ['x<2']\n{rest}\n");
    assert!(refused(&claim("families = ['g']")).contains("there is no family `g`"));
    assert!(refused(&claim("families = ['f', 'f']")).contains("`f` is listed twice"));
    assert!(refused(&claim("expect = { holds = ['f'] }")).contains("`c` is not tried on `f`"));
    let ranges = claim("ranges = { 'x' = [0, 1] }\nfamilies = ['f']");
    assert!(refused(&ranges).contains("a claim over ranges has no `families`"));
    let both = read(&claim("families = ['f']\nexpect = { holds = ['a'], fails = 'others' }")).expect("it is read");
    assert_eq!(both.claims[0].expect, [Some("holds"), Some("fails"), Some("fails")]);
    assert_eq!(both.claims[0].expect_of_families, [Some("fails")]);
    let alone = read(&claim("trajectories = []\nfamilies = ['f']")).expect("it is read");
    assert_eq!((alone.claims[0].trajectories.len(), alone.claims[0].families.len()), (0, 1));
}

/// A family of points of a sequence, with what is in it and a claim that fails on all of it.
fn sequence(lines: &str, draws: usize) -> FamilyAccount {
    let family = format!("of = 'c'\n{lines}\ndraws = {draws}\nseed = 7\nsequence = 'low-discrepancy'");
    let more = "\n[[trajectory]]\nid = 'c'\nsystem = 's'\nparameters = { 'k' = 1, 'c' = 1 }\ninitial = { 'x' = 1, '\\dot x' = 0 }\nspan = [0, 1]\n";
    let claim = CLAIM.replace("x<2", "x(0)<0").replace("says", "trajectories = []\nsays");
    let text = format!("{HEAD}{more}\n[[family]]\nid = 'f'\n{family}\n{claim}");
    let mut derivation =
        parse(Source { path: "t.toml".into(), text }, "t").unwrap_or_else(|e| panic!("{}", render(&e, false)));
    on(&run(&mut derivation), "c", "f").clone()
}

#[test]
fn points_of_a_sequence_are_members_and_no_sample() {
    let found = sequence("vary = { 'c' = { uniform = [0, 1] }, 'x' = { uniform = [1, 2] } }\nwhere = ['x<2-c']", 500);
    // Who does not satisfy the constraint is not drawn again: half of them, and more evenly so than at random.
    assert_eq!(found.counts.members + found.counts.rejected, 500);
    assert!(found.counts.members.abs_diff(250) <= 4, "{:?}", found.counts);
    // Clopper and Pearson is about independent draws.
    assert_eq!(found.failing_share, None);
    // Computed with 400 bits by a program in Python: 0.476… and 1 + 0.809… are rejected, the next is not.
    let first = found.first_failing.expect("it fails");
    let values: Vec<f64> = first.values.iter().map(|(_, x)| *x).collect();
    assert_eq!((first.number, values), (2, vec![0.231_263_513_098_356, 1.378_965_054_853_38]));
    assert!(first.toml.contains("0.231263513098356"), "{}", first.toml);
    // The first points of a longer sequence are the same; a normal distribution has its quantiles at them.
    let more = sequence("vary = { 'k' = { values = [1, 2] }, 'x' = { normal = [9, 1] } }", 40);
    assert_eq!((more.counts.members, more.counts.fails), (80, 80));
    let clearest = sequence("vary = { 'k' = { log-uniform = [1, 2] }, 'x' = { polar = [1, 2] } }", 40);
    assert_eq!((clearest.counts.members, clearest.counts.rejected), (40, 0));
}

/// Exit code, and what is printed, of a check of a text; with so many threads.
fn program(text: &str, threads: &str, arguments: &[&str]) -> (Option<i32>, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("t.toml");
    std::fs::write(&file, text).expect("it is written");
    let mut command = Command::new(env!("CARGO_BIN_EXE_rederive"));
    command.current_dir(folder.path()).env("RAYON_NUM_THREADS", threads);
    let output = command.args(["check", "t.toml"]).args(arguments).output().expect("it runs");
    (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
}

#[test]
fn exit_codes_are_those_of_trajectories() {
    let family = "\n[[family]]\nid = 'f'\nof = 'a'\nvary = { 'x' = { values = [1, 3] } }\n";
    let with = |says: &str| {
        let claim = format!("\n[[claim]]\nid = 'c'\nsays = 's'\ntrajectories = []\nfamilies = ['f']\n{says}\n");
        program(&format!("{HEAD}{family}{claim}"), "1", &[])
    };
    assert_eq!(with("always = ['x<4']").0, Some(0));
    let (code, printed) = with("always = ['x<2']");
    assert_eq!(code, Some(1), "{printed}");
    // What differs is told with the member to paste.
    assert!(printed.contains("Of 2 members it fails on 1, holds on 1.") && printed.contains("'x' = 3.0"), "{printed}");
    assert_eq!(with("always = ['x<2']\nexpect = 'fails'").0, Some(0));
    assert_eq!(with("always = ['x<4']\nexpect = 'fails'").0, Some(1));
    assert_eq!(with("always = ['\\lim_{t\\rightarrow\\infty}x=0']").0, Some(3));
    // It is as expected, but a run that decides nothing is no success.
    assert_eq!(with("always = ['\\lim_{t\\rightarrow\\infty}x=0']\nexpect = 'undecided'").0, Some(3));
    // One family alone may be asked for.
    let (code, printed) = program(&format!("{HEAD}{family}{CLAIM}"), "1", &["--trajectory", "f"]);
    assert_eq!(code, Some(1), "{printed}");
    let (code, printed) = program(&format!("{HEAD}{family}{CLAIM}"), "1", &["--trajectory", "a"]);
    assert!(code == Some(0) && !printed.contains("members"), "{printed}");
}

#[test]
fn the_same_bytes_with_one_and_two_threads() {
    let text = corpus().file.text.clone();
    let first = program(&text, "1", &["--format", "json", "--only-verdicts"]);
    let second = program(&text, "2", &["--format", "json", "--only-verdicts"]);
    assert!(first.1.len() > 1000 && first == second);
    let value: Value = serde_json::from_str(&first.1).expect("JSON");
    let text = value.to_string();
    assert!(text.contains("\"first_failing\"") && text.contains("\"failing_share\""), "{}", text.len());
}

/// What separates the members of a family of springs that begin at rest, on which `x<2` is claimed: it fails from x = 2 on.
fn separation(vary: &str, more: &str, plain: bool) -> (FamilyAccount, String) {
    let family = format!("\n[[family]]\nid = 'f'\nof = 'a'\n{vary}\n");
    let claim = CLAIM.replace("says = 's'", "says = 's'\ntrajectories = []");
    let text = format!("{HEAD}{family}{claim}{more}");
    let derivation =
        parse(Source { path: "t.toml".into(), text }, "t").unwrap_or_else(|e| panic!("{}", render(&e, false)));
    let options = Options { plain, ..Options::default() };
    let account = check(&derivation, &options, &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let page = rederive::report::markdown(&derivation, &account);
    (on(&account, "c", "f").clone(), page)
}

#[test]
fn what_separates_is_tried_on_fresh_members() {
    let formula = |of: &rederive::check::family::FamilySeparation| {
        let explanation = of.explanation.as_ref().expect("a condition");
        explanation.conditions.iter().map(|c| c.formula.clone()).collect::<Vec<_>>()
    };
    // Nine members below 2, and seven above.
    let row = "vary = { 'x' = { from = 0.3, to = 3.3, count = 16 } }";
    let (found, page) = separation(row, "", false);
    let of = found.separation.as_ref().expect("what separates");
    assert_eq!((formula(of), of.sides), (vec!["x<2.0".to_owned()], (9, 7)));
    assert_eq!((of.right, of.wrong, of.open, &of.exception), (24, 0, 0, &None));
    assert!(
        page.contains("24 fresh members, which were not used to find that, the condition is right on 24, wrong on 0"),
        "{page}"
    );
    // By chance: two members say that it lies in the middle between them, and fresh ones that it does not.
    let (found, page) = separation("vary = { 'x' = { values = [1, 5] } }", "", false);
    let of = found.separation.as_ref().expect("what separates");
    assert_eq!((formula(of), of.sides), (vec!["x<3.0".to_owned()], (1, 1)));
    assert!(of.right + of.wrong == 24 && (1..16).contains(&of.wrong), "{of:?}");
    let exception = of.exception.as_ref().expect("a member");
    let x = exception.values[0].1;
    assert!((2.0..3.0).contains(&x) && !exception.holds, "{exception:?}");
    assert!(exception.toml.contains(&format!("'x' = {x:?}")) && page.contains(&format!("{x:?}")), "{}", exception.toml);
    // What lies between two numbers.
    let row = "vary = { 'x' = { values = [-3, -2.5, -1, 0, 1, 2.5, 3] } }";
    let claim = "\n[[claim]]\nid = 'd'\nsays = 's'\ntrajectories = []\nfamilies = ['f']\nalways = ['|x|<2']\n";
    let text = format!("{HEAD}\n[[family]]\nid = 'f'\nof = 'a'\n{row}\n{claim}");
    let derivation = parse(Source { path: "t.toml".into(), text }, "t").expect("no problems");
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    let of = on(&account, "d", "f").separation.clone().expect("what separates");
    assert_eq!(formula(&of), ["x>-2.0", "x<2.0"], "{of:?}");
    // With the constraints of the family, and a condition of the file, which comes first.
    let drawn =
        "vary = { 'x' = { uniform = [0, 4] }, 'k' = { uniform = [1, 2] } }\ndraws = 30\nseed = 2\nwhere = ['x>k']";
    let condition = "\n[[condition]]\nid = 'near'\nsays = 'it begins near'\nholds = ['x(0)^2<4']\n";
    let (found, page) = separation(drawn, condition, false);
    let of = found.separation.as_ref().expect("what separates");
    let explanation = of.explanation.as_ref().expect("a condition");
    assert_eq!(explanation.conditions[0].id.as_deref(), Some("near"), "{of:?}");
    assert_eq!((of.right, of.wrong, of.open), (24, 0, 0));
    assert!(page.contains("it begins near"), "{page}");
    // Fresh ones satisfy the constraints, too: between 0.5 and 2 this number would be wrong.
    let apart = "vary = { 'x' = { uniform = [0, 4] } }\ndraws = 30\nseed = 2\nwhere = ['(x-0.5)(x-2)>0']";
    let of = separation(apart, "", false).0.separation.expect("what separates");
    assert_eq!((formula(&of), of.right, of.wrong, of.open), (vec!["x<1.0".to_owned()], 24, 0, 0));
    // Verdicts alone, and claims that do not fail on some and hold on others, are not asked.
    assert_eq!(separation(row, "", true).0.separation, None);
    assert_eq!(separation("vary = { 'x' = { values = [1, 1.5] } }", "", false).0.separation, None);
}
