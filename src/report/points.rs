//! A verdict in a few lines: as what a sentence was tested, where it holds, where it fails, and how sure that is.
//!
//! **In:** a reading of a claim. **Out:** at most four short lines, each with its name before it. Conditions have the words of the file,
//! where it has words for them.

use std::collections::BTreeSet;

use super::card::{FormulaShown, RefutingMotion, Room, formula_of, shown_formula};
use super::condition_spelling::canonical;
use super::digest::{self, Reading, Whole};
use super::numbers::count;
use super::story::{StoryBlock, StorySpan, Tone, joined, quiet, roomy, words};
use super::tally::{Standing, declared};
use super::text::{capital, uncapital};
use derivation::{ClaimRole, Derivation};
use findings::{ClaimAccount, Grounds, Outcome, Recorded};

/// Longest formula, in bytes of LaTeX; beside the words of a reading it has what room they leave.
const LONGEST: usize = 60;
/// Longest remark of the file, in bytes, that stands beside numbers.
const LONGEST_REMARK: usize = 160;
/// Most conditions that are named.
const MOST_CONDITIONS: usize = 3;

/// The lines on a claim: on the reading that the paper needs, if `needed`, else on that from which its fate follows.
pub(super) fn lines<'a>(derivation: &'a Derivation, whole: &Whole<'a>, needed: NeededReading) -> Vec<StoryBlock<'a>> {
    let need = whole.failing_need().filter(|_| needed == NeededReading::Shown);
    let holding = || whole.deciding().find(|r| r.standing == Standing::Holds);
    let reading = need.or_else(|| whole.failing()).or_else(|| whole.contrary()).or_else(holding);
    let Some(reading) = reading.or(whole.readings.first()) else { return Vec::new() };
    let mut tested = tested(derivation, reading);
    let (mut further, mut also) = (Vec::new(), Vec::new());
    match reading.standing {
        Standing::Fails | Standing::Mixed => {
            tested.extend((!tested.is_empty()).then(|| words("; ")));
            tested.extend(fails(derivation, reading));
            // Of what the paper needs the first sentences say on how many motions it fails.
            if need.is_some() {
                tested = vec![StorySpan::Roomy(tested)];
            }
            tested.extend(witness(derivation, reading));
            also = fails_too(derivation, whole, reading);
            further.extend(separated(derivation, reading.claim));
        }
        Standing::Holds => {
            tested.extend((!tested.is_empty()).then(|| words("; ")));
            tested.extend(holds(derivation, reading));
        }
        Standing::Open | Standing::Nowhere => {
            further.push(vec![quiet("how sure: "), words(format!("{}.", uncapital(&digest::verdict(reading))))]);
        }
    }
    let out = std::iter::once(tested).filter(|line| !line.is_empty()).chain(further);
    let mut out: Vec<StoryBlock<'a>> = out.map(StoryBlock::Paragraph).collect();
    if !also.is_empty() {
        out.push(StoryBlock::Group("roomy", vec![StoryBlock::Paragraph(also)]));
    }
    out
}

/// In what sense a claim stands that fails as it is used, and how that is known.
pub(super) fn as_stated<'a>(derivation: &'a Derivation, whole: &Whole<'a>) -> Option<StoryBlock<'a>> {
    let reading = whole.deciding().find(|r| r.standing == Standing::Holds)?;
    let scope = declared(derivation, reading.claim).map_or(&derivation.scope, |d| &d.scope);
    let mut out = vec![quiet("as stated: ")];
    if reading.claim.reading.is_some() {
        let says = reading.claim.says.trim_end_matches('.');
        out.push(StorySpan::Prose(format!("{says}; "), scope, Tone::Plain));
        out.extend(known(reading));
    } else {
        out.extend(holds(derivation, reading));
    }
    Some(StoryBlock::Paragraph(out))
}

/// What the paper needs of a claim whose contrary holds, and what fails, too: with its motion and its numbers.
pub(super) fn needs<'a>(derivation: &'a Derivation, whole: &Whole<'a>) -> Vec<StoryBlock<'a>> {
    // What fails in its own words has its numbers.
    let is_silent = whole.fate.is_against() && whole.failing().is_none();
    let Some(reading) = whole.failing_nowhere_true().filter(|_| is_silent) else { return Vec::new() };
    let scope = declared(derivation, reading.claim).map_or(&derivation.scope, |d| &d.scope);
    let says = reading.claim.says.trim_end_matches('.').to_owned();
    let mut out = vec![quiet("it needs: "), StorySpan::Prose(says, scope, Tone::Plain)];
    out.extend([words(" ("), StorySpan::Shape(reading.shape()), words(").")]);
    // A short remark tells what the numbers mean.
    let remark = reading.claim.remark.as_deref().filter(|text| text.len() <= LONGEST_REMARK);
    let told = remark.map(|text| capital(text.trim_start_matches("Refuted: ")));
    let mut numbers: Vec<StorySpan<'a>> =
        told.map(|text| StorySpan::Prose(format!("{text} "), scope, Tone::Quiet)).into_iter().collect();
    numbers.extend(
        RefutingMotion::of(derivation, reading.claim).into_iter().flat_map(|m| m.says(derivation, scope, Room::OnPage)),
    );
    // A terminal has no room for them.
    vec![StoryBlock::Paragraph(out), StoryBlock::Group("roomy", vec![StoryBlock::Paragraph(numbers)])]
}

/// Whether the lines are on the reading that the paper needs.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum NeededReading {
    Shown,
    NotShown,
}

/// As what a sentence was tested: the words of the reading, and its formula where it is short.
fn tested<'a>(derivation: &'a Derivation, reading: &Reading<'a>) -> Vec<StorySpan<'a>> {
    let claim = reading.claim;
    let lead = match (reading.role, reading.standing) {
        (ClaimRole::Against, Standing::Holds) => "the contrary holds: ",
        (ClaimRole::Needs, _) => "as the paper uses it: ",
        _ => "tested as: ",
    };
    // As what a conclusion was tested is the first that stands below it.
    let lead = if lead == "tested as: " { roomy(lead) } else { quiet(lead) };
    let scope = declared(derivation, claim).map_or(&derivation.scope, |d| &d.scope);
    let says = claim.says.trim_end_matches('.');
    let formula = short_formula(derivation, claim).filter(|shown| shown.is_within(room(claim)));
    // Without a reading its words are those of the claim, which stand above.
    if claim.reading.is_none() && formula.is_none() {
        return Vec::new();
    }
    let mut out = vec![lead];
    if claim.reading.is_some() {
        out.push(StorySpan::Prose(says.to_owned(), scope, Tone::Plain));
        out.extend(formula.is_some().then(|| quiet(": ")));
    }
    out.extend(formula.map(|shown| shown.spans(None, false)).unwrap_or_default());
    out
}

/// The formula of a claim that a witness is of, else its first, where it is short.
fn short_formula<'a>(derivation: &'a Derivation, claim: &'a ClaimAccount) -> Option<FormulaShown<'a>> {
    formula_of(derivation, claim, shown_formula(claim, None)).filter(|shown| shown.is_within(LONGEST))
}

/// How long the formula may be that stands beside the words of a reading.
fn room(claim: &ClaimAccount) -> usize {
    if claim.reading.is_some() { LONGEST.saturating_sub(claim.says.len()) } else { LONGEST }
}

/// What separates the motions on which a claim holds from those on which it fails; nothing, where other conditions fit as well.
fn separated<'a>(derivation: &'a Derivation, claim: &'a ClaimAccount) -> Option<Vec<StorySpan<'a>>> {
    let separation = claim.conditions.separation.as_ref().filter(|s| s.rivals.is_empty() && s.more_rivals == 0)?;
    let text = digest::explanation(separation.told()?);
    Some(vec![
        quiet("on the motions tried it holds exactly where: "),
        StorySpan::Prose(text, &derivation.scope, Tone::Plain),
    ])
}

/// On how much a reading fails, and how sure that is.
fn fails<'a>(derivation: &'a Derivation, reading: &Reading<'a>) -> Vec<StorySpan<'a>> {
    let claim = reading.claim;
    let scope = declared(derivation, claim).map_or(&derivation.scope, |d| &d.scope);
    let says = digest::verdict(reading).replace(" to which it applies", "");
    let mut out = vec![StorySpan::Words("fails".to_owned(), Tone::Bad)];
    let rest = says.strip_prefix("Fails").map_or_else(|| format!(": {}", uncapital(&says)), str::to_owned);
    match rest.split_once(" motions").filter(|_| reading.standing == Standing::Mixed) {
        Some((of, how)) => {
            let prose = |text: &str| StorySpan::Prose(text.to_owned(), scope, Tone::Plain);
            out.extend([prose(of), StorySpan::Roomy(vec![words(" motions")]), prose(how)]);
        }
        None => out.push(StorySpan::Prose(rest, scope, Tone::Plain)),
    }
    // What is left and right at the witness is said here, where it is not said before.
    if let Some(shown) = short_formula(derivation, claim).filter(|shown| !shown.is_within(room(claim))) {
        let formula = std::iter::once(quiet(": ")).chain(shown.spans(None, false));
        out.push(StorySpan::Roomy(formula.collect()));
    }
    out.push(words(". "));
    out
}

/// The motion that tells most of why a reading fails, with its numbers.
fn witness<'a>(derivation: &'a Derivation, reading: &Reading<'a>) -> Vec<StorySpan<'a>> {
    let scope = declared(derivation, reading.claim).map_or(&derivation.scope, |d| &d.scope);
    let motion = RefutingMotion::of(derivation, reading.claim);
    motion.map(|motion| motion.says(derivation, scope, Room::OnPage)).unwrap_or_default()
}

/// What else of a claim fails that fails in the sense that was shown, and on how many motions it does in one sense or another.
fn fails_too<'a>(derivation: &'a Derivation, whole: &Whole<'a>, shown: &Reading<'a>) -> Vec<StorySpan<'a>> {
    if !shown.role.decides() {
        return Vec::new();
    }
    let others: Vec<&Reading<'a>> = whole.all_failing().filter(|r| !std::ptr::eq(r.claim, shown.claim)).collect();
    let Some(first) = others.first() else { return Vec::new() };
    let scope = declared(derivation, first.claim).map_or(&derivation.scope, |d| &d.scope);
    let says = first.claim.says.trim_end_matches('.');
    let on = uncapital(&digest::verdict(first)).replace(" to which it applies", "");
    let mut out =
        vec![quiet("in another reading, too: "), StorySpan::Prose(format!("“{says}” {on}"), scope, Tone::Plain)];
    let failing = whole.all_failing().flat_map(|r| &r.claim.results);
    let failing = failing.filter(|p| matches!(p.verdict.outcome(), Outcome::Fails(_)));
    let motions = failing.map(|p| p.trajectory.as_str()).collect::<BTreeSet<_>>().len();
    out.push(words(match others.len() {
        1 if motions > 1 => format!("; {motions} motions in all."),
        1 => ".".to_owned(),
        more => format!("; with {} more, {} in all.", more - 1, count(motions, "motion")),
    }));
    out
}

/// How a reading is known to hold, what it assumes, and whether its proof was made again.
fn holds<'a>(derivation: &'a Derivation, reading: &Reading<'a>) -> Vec<StorySpan<'a>> {
    let mut out = Vec::new();
    let assumed = reading.claim.assumptions.iter().take(MOST_CONDITIONS);
    let assumed: Vec<_> = assumed.map(|formula| vec![in_words(derivation, formula, reading.claim)]).collect();
    if !assumed.is_empty() {
        out.push(words("where "));
        out.extend(joined(assumed, ", "));
        out.push(words("; "));
    }
    out.extend(known(reading));
    out
}

/// How a reading is known to hold, and whether its proof was made again.
fn known<'a>(reading: &Reading<'a>) -> Vec<StorySpan<'a>> {
    let replayed = match reading.claim.identity.as_ref().and_then(|i| i.recorded.as_ref()).map(Recorded::grounds) {
        _ if !reading.basis().is_proof() => "",
        Some(Grounds::Checker) => ", replayed",
        Some(Grounds::CheckerBut(_)) => ", replayed but for some cases",
        Some(Grounds::Prover) => ", not replayed by the checker",
        None => "",
    };
    let basis = reading.basis();
    let known = if basis.is_proof() { basis.kind().to_owned() } else { format!("holds {}", basis.words()) };
    vec![StorySpan::Words(known, Tone::Good), StorySpan::Roomy(vec![words(replayed)]), words(".")]
}

/// A condition in the words of the file; the formula, where the file has none.
pub(super) fn in_words<'a>(derivation: &'a Derivation, formula: &str, of: &ClaimAccount) -> StorySpan<'a> {
    match said(derivation, formula) {
        Some(says) => StorySpan::Prose(says.trim_end_matches('.').to_owned(), &derivation.scope, Tone::Plain),
        None => {
            let scope = declared(derivation, of).map_or(&derivation.scope, |d| &d.scope);
            StorySpan::Math(formula.to_owned(), scope)
        }
    }
}

/// The words that the file has for a condition of one formula.
fn said<'a>(derivation: &'a Derivation, formula: &str) -> Option<&'a str> {
    let wanted = canonical(formula);
    let of = |c: &&derivation::Condition| matches!(c.holds.as_slice(), [one] if canonical(&one.text) == wanted);
    derivation.conditions.iter().find(of).map(|c| c.says.as_str())
}
