//! Claims over ranges of values, in the words of every kind of report.

use super::numbers::value;
use super::story::{StoryBlock, StorySpan, Tone, prose, strong, terminal, words};
use super::tally::{glyph, name, says};
use super::text::Paint;
use super::wording::unit;
use derivation::{Derivation, FormKind};
use findings::region::{RangeAccount, RegionAccount, SolutionAccount};
use findings::{Account, ClaimAccount};
use latex::Scope;

/// What is said of the formulas of a claim over ranges, for the heading of a list of them.
pub(super) fn heading(kind: FormKind, region: &RegionAccount) -> String {
    match kind {
        FormKind::Defined => "Has a real value at every point of the ranges".to_owned(),
        FormKind::Exists => {
            let number = if region.unique { "exactly one solution" } else { "a solution" };
            let unknowns: Vec<String> = region.unknowns.iter().map(range).collect();
            format!("There is {number} for {} of", unknowns.join(", "))
        }
        _ if region.is_of_fields() => "For all fields".to_owned(),
        _ => "At every point of the ranges".to_owned(),
    }
}

/// A symbol with its range; its name is a formula between dollars.
fn range(of: &RangeAccount) -> String {
    let unit = of.unit.as_ref().filter(|u| *u != "1").map(|u| format!(" {}", unit(u))).unwrap_or_default();
    match of.values {
        Some((from, to)) if from == to => format!("${}={}${unit}", of.name, value(from)),
        Some((from, to)) => format!("${}$ from {} to {}{unit}", of.name, value(from), value(to)),
        None => match &of.formula {
            Some(formula) => format!("${}={formula}$", of.name),
            None => format!("${}$ as the others give it", of.name),
        },
    }
}

/// All ranges, in a sentence; `None` where there are none.
fn ranges(region: &RegionAccount) -> Option<String> {
    let all: Vec<String> = region.ranges.iter().map(range).collect();
    (!all.is_empty()).then(|| format!("Over {}.", all.join(", ")))
}

/// `, expected: …`, where the verdict is not as expected.
fn expected(region: &RegionAccount) -> String {
    match (region.is_unexpected(), region.expected) {
        (true, Some(word)) => format!(", expected: {word}"),
        (true, None) => ", not expected".to_owned(),
        (false, _) => String::new(),
    }
}

/// A solution: each unknown in its enclosure.
fn solution(of: &SolutionAccount) -> String {
    let one = |(name, lo, hi): &(String, f64, f64)| format!("${name}$ in [{lo:.17}, {hi:.17}]");
    of.values.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// What else is known, one sentence each, without its end.
fn notes(region: &RegionAccount) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for (i, of) in region.solutions.iter().enumerate() {
        let number = if region.solutions.len() > 1 { format!(" {}", i + 1) } else { String::new() };
        out.push(format!("solution{number}: {}", solution(of)));
    }
    out.extend(region.remarks.iter().map(ToString::to_string));
    out
}

/// The ranges, the verdict with its reason, and what else is known.
pub(super) fn told<'a>(of: &'a RegionAccount, scope: &'a Scope) -> Vec<StoryBlock<'a>> {
    let outcome = of.verdict.outcome();
    let word = match outcome.word() {
        "holds" => "Holds",
        "fails" => "Fails",
        "undecided" => "Undecided",
        _ => "Does not apply",
    };
    let strength = outcome.strength().map(|s| format!(" ({s})")).unwrap_or_default();
    let mut line = vec![strong(format!("{word}{strength}"))];
    line.extend(of.verdict.evidence().reason.as_ref().map(|why| prose(format!(": {why}"), scope)));
    if let Some(text) = expected(of).strip_prefix(", ") {
        line.extend([words(", "), StorySpan::Words(text.to_owned(), Tone::Alarm)]);
    }
    line.push(words("."));
    let mut out: Vec<StoryBlock<'a>> =
        ranges(of).map(|r| StoryBlock::Paragraph(vec![prose(r, scope)])).into_iter().collect();
    out.push(StoryBlock::Paragraph(line));
    let notes = notes(of).into_iter();
    out.extend(notes.map(|note| StoryBlock::Paragraph(vec![StorySpan::Prose(format!("{note}."), scope, Tone::Quiet)])));
    out
}

/// One claim in the terminal.
fn terminal_one(derivation: &Derivation, claim: &ClaimAccount, region: &RegionAccount, paint: Paint) -> String {
    let outcome = region.verdict.outcome();
    let strength = outcome.strength().map(|s| format!(" ({s})")).unwrap_or_default();
    let head = format!("{}  {}{strength}{}", glyph(outcome), outcome.word(), expected(region));
    let head = if region.is_unexpected() { paint.alarm(&head) } else { paint.verdict(outcome, &head) };
    let mut blocks = vec![StoryBlock::Paragraph(vec![prose(says(derivation, claim), &derivation.scope)])];
    blocks.extend(told(region, &derivation.scope));
    format!("  {}  {head}\n{}\n", paint.bold(&name(claim)), terminal(&blocks, 4, paint))
}

/// The claims over ranges in the terminal: all of them, or those that differ or are open without being expected to.
pub(super) fn summary(derivation: &Derivation, account: &Account, paint: Paint, all: bool) -> String {
    let told = |r: &&RegionAccount| all || r.is_unexpected() || r.verdict.outcome().word() == "undecided";
    let mut body = String::new();
    let mut number = 0;
    for claim in &account.claims {
        if let Some(region) = claim.region.as_ref().filter(told) {
            number += 1;
            body.push_str(&terminal_one(derivation, claim, region, paint));
        }
    }
    let of_fields = |c: &ClaimAccount| c.region.as_ref().is_some_and(RegionAccount::is_of_fields);
    let of = if account.claims.iter().any(of_fields) {
        "Of fields, and over ranges of values"
    } else {
        "Over ranges of values"
    };
    if body.is_empty() { body } else { format!("{} ({number})\n\n{body}", paint.bold(of)) }
}

/// How the verdict over ranges came about, for `rederive explain`.
pub(super) fn explain(derivation: &Derivation, claim: &ClaimAccount, paint: Paint) -> String {
    let Some(region) = &claim.region else { return String::new() };
    let mut out = terminal_one(derivation, claim, region, paint);
    if let Some(witness) = &region.witness {
        for (name, x) in &witness.values {
            out.push_str(&format!("      {name} = {x}\n"));
        }
        if let Some(((a, b), (c, d))) = witness.sides {
            out.push_str(&format!("      left in [{a}, {b}]\n      right in [{c}, {d}]\n"));
        }
        out.push('\n');
    }
    out
}
