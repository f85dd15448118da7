//! JUnit XML: a suite for each derivation file, a case for each claim on each trajectory.
//!
//! | verdict | case |
//! |---|---|
//! | differs from what is expected; fails with nothing expected | failure |
//! | undecided with nothing expected | error: unknown never counts as a pass |
//! | does not apply, or is undecided, as expected | skipped, with the reason |
//! | holds, or fails as expected | passed |
//!
//! There are no times and no time stamps in it: the same input gives the same bytes.

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use super::finding::{Finding, Level, of_step, on_family, over_ranges, phrase, told};
use super::tally::{name, says};
use derivation::Derivation;
use diag::escape::in_one_line;
use findings::{Account, ClaimAccount, Judged, PairAccount};

/// One derivation file and what was found, for [`junit`].
#[derive(Clone, Copy, Debug)]
pub struct Checked<'a> {
    /// The file.
    pub derivation: &'a Derivation,
    /// Its verdicts.
    pub account: &'a Account,
}

/// The report of a run: the files that were checked, then what was found beside verdicts.
pub fn junit(checked: &[Checked<'_>], others: &[Finding]) -> String {
    let mut report = Report::new(crate::PROGRAM);
    for one in checked {
        let mut suite = TestSuite::new(one.derivation.id.as_str());
        suite.add_property(("file", one.derivation.file.path.as_str()));
        suite.add_property(("sha256", one.derivation.sha256.as_str()));
        for claim in &one.account.claims {
            for pair in &claim.results {
                suite.add_test_case(case(one.derivation, claim, pair));
            }
            for judged in claim.verdicts().filter(|j| j.trajectory.is_none()) {
                let told = judged.family.map(on_family).or_else(|| over_ranges(claim));
                suite.add_test_case(case_of(one.derivation, claim, &judged, told));
            }
            suite.add_test_cases(alone(one.derivation, claim));
        }
        report.add_test_suite(suite);
    }
    if !others.is_empty() {
        let mut suite = TestSuite::new("files");
        suite.add_test_cases(others.iter().map(of_finding));
        report.add_test_suite(suite);
    }
    // Writing to a string does not fail: control characters are dropped by the library.
    let mut text = report.to_string().unwrap_or_default();
    if !text.ends_with('\n') {
        text.push('\n');
    }
    // The log of a workflow finds no command in it.
    without_skipped_in_all(&text).replace("##[", "#&#35;[").replace("##vso[", "#&#35;vso[")
}

/// The number of skipped cases of the whole run is left out: strict readers know it of a suite only.
fn without_skipped_in_all(text: &str) -> String {
    let Some((before, after)) = text.split_once("<testsuites") else { return text.to_owned() };
    let Some((head, rest)) = after.split_once('>') else { return text.to_owned() };
    let head: Vec<&str> = head.split(' ').filter(|a| !a.starts_with("skipped=\"")).collect();
    format!("{before}<testsuites{}>{rest}", head.join(" "))
}

fn case(derivation: &Derivation, claim: &ClaimAccount, pair: &PairAccount) -> TestCase {
    let judged = Judged {
        trajectory: Some(&pair.trajectory),
        family: None,
        verdict: &pair.verdict,
        expected: pair.expected,
        unexpected: pair.is_unexpected(),
    };
    case_of(derivation, claim, &judged, told(pair))
}

fn case_of(derivation: &Derivation, claim: &ClaimAccount, judged: &Judged<'_>, told: Option<String>) -> TestCase {
    let outcome = judged.verdict.outcome();
    let verdict = (outcome.word(), outcome.strength());
    case_with(derivation, claim, (judged.on(), verdict), (judged.expected, judged.unexpected), told)
}

/// The case of a claim that is tried on nothing.
fn alone(derivation: &Derivation, claim: &ClaimAccount) -> Option<TestCase> {
    let word = claim.verdict_alone()?;
    let expected = (claim.alone.and_then(|alone| alone.expected), claim.is_unexpected_alone());
    Some(case_with(derivation, claim, ("all values", (word, None)), expected, of_step(claim)))
}

fn case_with(
    derivation: &Derivation,
    claim: &ClaimAccount,
    (on, (word, strength)): (&str, (&str, Option<&str>)),
    (expected, unexpected): (Option<&str>, bool),
    told: Option<String>,
) -> TestCase {
    let is_expected = expected.map_or_else(|| "nothing is".to_owned(), |e| format!("`{e}` is"));
    let mut status = match word {
        _ if unexpected => TestCaseStatus::non_success(NonSuccessKind::Failure),
        "undecided" if expected.is_none() => TestCaseStatus::non_success(NonSuccessKind::Error),
        "undecided" | "not-applicable" => TestCaseStatus::skipped(),
        _ => TestCaseStatus::success(),
    };
    status.set_message(format!("{} ({is_expected} expected)", phrase(word)));
    status.set_type(word);
    let corrected = super::card::instead(claim).filter(|_| unexpected && word == "fails");
    let told: Vec<String> = told.into_iter().chain(corrected).collect();
    if !told.is_empty() {
        status.set_description(told.join(" "));
    }
    let mut case = TestCase::new(on, status);
    case.set_classname(format!("{}.{}", derivation.id, name(claim)));
    let strength = strength.map(|s| format!(" ({s})")).unwrap_or_default();
    let drawn = super::drawn::plain(derivation, claim).map(|text| format!("\n{}", in_one_line(&text.replace('$', ""))));
    let drawn = drawn.unwrap_or_default();
    case.set_system_out(format!("{}\n{}{strength}{drawn}", in_one_line(&says(derivation, claim)), phrase(word)));
    case
}

fn of_finding(finding: &Finding) -> TestCase {
    let mut status = match finding.level {
        Level::Error => TestCaseStatus::non_success(NonSuccessKind::Failure),
        Level::Warning => TestCaseStatus::non_success(NonSuccessKind::Error),
        Level::Note => TestCaseStatus::skipped(),
    };
    let place = finding.place.region().map_or_else(String::new, |r| format!(":{}:{}", r.line, r.column));
    let place = format!("{}{place}", finding.place.source.path);
    status.set_message(finding.message.as_str());
    status.set_type(finding.rule);
    status.set_description(format!("{place}: {}", finding.message));
    let mut case = TestCase::new(place, status);
    case.set_classname(finding.rule);
    case
}
