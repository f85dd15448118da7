//! Claims that are tried on nothing: when what their step came to is their verdict, and that reports tell it.

use crate::checked::said_by_prover;
use rederive::check::{Account, Options, check};
use rederive::derivation::{Derivation, parse};
use rederive::diag::{Source, render};
use rederive::report;

const HEAD: &str = r"
[derivation]
title = 'T'
concerns = 'C'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
'y' = { role = 'state' }
'a' = { role = 'parameter' }
'b' = { role = 'parameter' }
[system.s]
states = ['x', 'y']
equations = ['\dot x=1', 'x\dot y=2y']
";

/// A claim that is tried on nothing.
fn alone(id: &str, rest: &str) -> String {
    format!("[[claim]]\nid = '{id}'\nsays = 'test'\ntrajectories = []\n{rest}\n")
}

fn found(claims: &[String]) -> (Derivation, Account) {
    let text = [HEAD, &claims.concat()].concat();
    let derivation =
        parse(Source { path: "t.toml".into(), text }, "t").unwrap_or_else(|f| panic!("{}", render(&f, false)));
    let account = check(&derivation, &Options::default(), &|_, _| {}).unwrap_or_else(|e| panic!("{e:?}"));
    (derivation, account)
}

/// The standing of the step of a claim, and its verdict.
fn of(account: &Account, id: &str) -> (&'static str, Option<&'static str>) {
    let claim = account.claims.iter().find(|c| c.id == id).unwrap_or_else(|| panic!("no {id}"));
    (claim.identity.as_ref().map_or("none", said_by_prover), claim.verdict_alone())
}

#[test]
fn what_a_proof_leaves_open_is_open() {
    let from = |premise: &str| format!("follows-from = ['{premise}']\nalways = ['2a=2']\nexpect = 'holds'");
    let claims = [
        // x = t, y = t|t| is a motion: y/x² is −1, then 1.
        alone(
            "except",
            "follows-from = ['s']\nassuming = ['x\\ne0']\nfirst-integral = ['\\frac{y}{x^2}']\nexpect = 'holds'",
        ),
        alone("false", "assuming = ['b=1']\nalways = ['a=1']\nexpect = 'fails'"),
        alone("from-false", &format!("assuming = ['b=1']\n{}", from("false"))),
        alone("narrow", "assuming = ['b=1', 'a=1']\nalways = ['a=1']"),
        alone("from-narrow", &from("narrow")),
        alone("from-one-that-is", &format!("assuming = ['b=1', 'a=1']\n{}", from("narrow"))),
        "[[claim]]\nid = 'ranged'\nsays = 'test'\nranges = { 'a' = [0, 1] }\nalways = ['|a|=a']\n".to_owned(),
        alone("from-ranged", "follows-from = ['ranged']\nalways = ['|a|=a']\nexpect = 'holds'"),
    ];
    let (_, account) = found(&claims);
    assert_eq!(of(&account, "except"), ("proved except", Some("undecided")));
    assert_eq!(of(&account, "false"), ("refuted", Some("fails")));
    assert_eq!(of(&account, "from-false"), ("proved given", Some("undecided")));
    assert_eq!(of(&account, "from-narrow"), ("proved given", Some("undecided")));
    assert_eq!(of(&account, "from-one-that-is"), ("proved", Some("holds")));
    // What is said over a box says nothing beyond.
    assert_eq!(of(&account, "from-ranged"), ("undecided", Some("undecided")));
    let summary = account.summary();
    // What is narrow holds, and so does the claim over ranges.
    assert_eq!((summary.holds, summary.fails, summary.undecided, summary.unexpected), (3, 1, 4, 4));
}

#[test]
fn a_file_stands_on_its_postulates_and_a_conclusion_is_none() {
    let from = |premise: &str| format!("follows-from = ['{premise}']\nalways = ['2a=2b']\nexpect = 'holds'");
    let law = alone("law", "always = ['a=b']");
    let claims = [law, alone("step", &from("law")), alone("next", "follows-from = ['step']\nalways = ['3a=3b']")];
    let (_, account) = found(&claims);
    assert_eq!(of(&account, "law"), ("refuted", None));
    for id in ["step", "next"] {
        assert_eq!(of(&account, id), ("proved given", Some("holds")), "{id}");
    }
    assert_eq!(account.summary().unexpected, 0);
    let concluded = alone("law", "conclusion = true\nalways = ['a=b']");
    let (_, account) = found(&[concluded, alone("step", &from("law"))]);
    assert_eq!(of(&account, "law"), ("refuted", Some("fails")));
    assert_eq!(of(&account, "step"), ("proved given", Some("undecided")));
    assert_eq!(account.summary().unexpected, 2);
}

/// A step that is refuted is no success, whatever else is in the file; and one that is proved is.
#[test]
fn a_refuted_step_never_passes() {
    let motion = |parameters: &str| {
        format!("[[trajectory]]\nid = 'm'\nsystem = 's'\n{parameters}initial = {{ 'x' = 1, 'y' = 1 }}\nspan = [0, 1]\n")
    };
    let everywhere = |id: &str, rest: &str| format!("[[claim]]\nid = '{id}'\nsays = 'test'\n{rest}\n");
    let (wrong, right) = ("always = ['(a+b)^2=a^2+b^2']", "always = ['(a+b)^2=a^2+2ab+b^2']");
    let none = motion("");
    let lucky = motion("parameters = { 'a' = 0, 'b' = 2 }\n");
    // The claims, and how many hold, how many fail, and how many are not as expected.
    for (n, (claims, sums)) in [
        (vec![alone("c", wrong)], (0, 1, 1)),
        (vec![alone("c", right)], (1, 0, 0)),
        // The motion knows neither a nor b.
        (vec![none.clone(), everywhere("c", wrong)], (0, 1, 1)),
        (vec![none.clone(), everywhere("c", right)], (1, 0, 0)),
        // It is true of the parameters that the motion has, and not of all.
        (vec![lucky.clone(), everywhere("c", wrong)], (1, 1, 1)),
        (vec![lucky.clone(), everywhere("c", right)], (1, 0, 0)),
        // It holds on the motion by its start, and is said to follow from the system.
        (vec![none.clone(), everywhere("c", "follows-from = ['s']\nalways = ['x=1+t']")], (1, 1, 1)),
        // It holds by its start, and does not follow from the system.
        (vec![none.clone(), everywhere("c", "always = ['x=1+t']")], (1, 0, 0)),
        // A postulate, by its word, or since something follows from it.
        (vec![alone("c", &format!("postulate = true\n{wrong}"))], (0, 0, 0)),
        (vec![alone("c", "always = ['a=b']"), alone("d", "follows-from = ['c']\nalways = ['2a=2b']")], (1, 0, 0)),
        (vec![alone("c", "always = ['a=b']"), alone("d", right)], (1, 1, 1)),
        (vec![alone("c", &format!("{wrong}\nexpect = 'fails'"))], (0, 1, 0)),
    ]
    .into_iter()
    .enumerate()
    {
        let (_, account) = found(&claims);
        let s = account.summary();
        assert_eq!((s.holds, s.fails, s.unexpected), sums, "{n}: {claims:?}");
    }
    let both = alone("c", "postulate = true\nfollows-from = ['s']\nalways = ['a=b']");
    let text = [HEAD, &both].concat();
    let refused = parse(Source { path: "t.toml".into(), text }, "t").expect_err("a postulate that follows");
    assert!(render(&refused, false).contains("a postulate follows from nothing"), "{}", render(&refused, false));
}

#[test]
fn reports_tell_what_is_tried_on_nothing() {
    let claims = [
        alone("right", "assuming = ['a=b']\nalways = ['2a=2b']"),
        alone("wrong", "assuming = ['a>0']\nalways = ['a=1']"),
        alone("open", "assuming = ['a>0']\nnever = ['a=1']\nexpect = 'holds'"),
    ];
    let (derivation, account) = found(&claims);
    let quiet = report::exceptions(&derivation, &account, false);
    assert!(quiet.contains("`wrong` fails for all values") && quiet.contains("`open` is undecided"), "{quiet}");
    assert!(!quiet.contains("`right`"), "{quiet}");
    for text in [
        report::summary(&derivation, &account, false, false),
        report::front_page(&derivation, &account, false),
        report::markdown(&derivation, &account),
    ] {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        for words in ["applies to none of the motions", "apply to none of the motions", "No claim was decided"] {
            assert!(!text.contains(words), "{words}: {text}");
        }
    }
    let markdown = report::markdown(&derivation, &account);
    for words in ["Refuted for all values", "Undecided for all values", "proved for all values"] {
        assert!(markdown.contains(words), "{words}: {markdown}");
    }
}

#[test]
fn what_a_sentence_comes_to_counts_what_holds_for_all_values() {
    let reading = |claim: &str, id: &str, role: &str, says: &str| {
        alone(id, &format!("{role}\nfollows-from = ['s']\n{says}")).replace("[[claim]]", &format!("[[claim.{claim}]]"))
    };
    let claims = [
        "[[claim]]\nid = 'contrary'\nsays = 'test'\n".to_owned(),
        reading("reading", "open", "", "eventually = ['x=5']"),
        reading("reading", "against", "role = 'against'", "always = ['\\dot x=1']"),
        "[[claim]]\nid = 'either'\nsays = 'test'\n".to_owned(),
        reading("reading", "one", "role = 'may-mean'", "always = ['\\ddot x=0']"),
        reading("reading", "two", "role = 'may-mean'", "always = ['x=0']\nexpect = 'fails'"),
    ];
    let (derivation, account) = found(&claims);
    let page = report::front_page(&derivation, &account, false);
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(page.contains("1 does not hold and 1 depends on what it means"), "{page}");
}

#[test]
fn sides_that_are_one_expression_are_decided() {
    let one = |id: &str, formula: &str| alone(id, &format!("always = ['{formula}']"));
    let claims = [one("sum", "a+b=b+a"), one("root", r"\sqrt a=\sqrt a"), one("nowhere", r"\frac1{a-a}=\frac1{a-a}")];
    let (_, account) = found(&claims);
    assert_eq!(of(&account, "sum"), ("proved", Some("holds")));
    assert_eq!(of(&account, "root"), ("proved", Some("holds")));
    assert_eq!(of(&account, "nowhere").1, None);
}
