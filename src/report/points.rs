//! A verdict in a few lines: as what a sentence was tested, where it holds, where it fails, and how sure that is.
//!
//! **In:** a reading of a claim. **Out:** at most four short lines, each with its name before it. Conditions have the words of the file,
//! where it has words for them.

use super::card::{FormulaShown, RefutingMotion, formula_of, shown_formula};
use super::digest::{self, Reading, Whole};
use super::hypotheses::canonical;
use super::story::{StoryBlock, StorySpan, Tone, joined, quiet, words};
use super::tally::{Standing, declared};
use super::text::uncapital;
use crate::derivation::{ClaimRole, Derivation};
use findings::{ClaimAccount, Grounds, Recorded};

/// Longest formula, in bytes of LaTeX; beside the words of a reading it has what room they leave.
const LONGEST: usize = 60;
/// Longest title of a motion, in letters.
const LONGEST_TITLE: usize = 48;
/// Most conditions that are named.
const MOST_CONDITIONS: usize = 3;

/// The lines on a claim: on the reading that the paper needs, if `needed`, else on that from which its fate follows.
pub(super) fn lines<'a>(derivation: &'a Derivation, whole: &Whole<'a>, needed: NeededReading) -> Vec<StoryBlock<'a>> {
    let need = whole.failing_need().filter(|_| needed == NeededReading::Shown);
    let holding = || whole.deciding().find(|r| r.standing == Standing::Holds);
    let reading = need.or_else(|| whole.failing()).or_else(|| whole.contrary()).or_else(holding);
    let Some(reading) = reading.or(whole.readings.first()) else { return Vec::new() };
    let mut tested = tested(derivation, reading);
    let mut further = Vec::new();
    match reading.standing {
        Standing::Fails | Standing::Mixed => {
            further.extend(separated(derivation, reading.claim));
            further.push(fails(derivation, reading));
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
    out.map(StoryBlock::Paragraph).collect()
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
        (ClaimRole::Needs, _) => "needed, and tested: ",
        _ => "tested as: ",
    };
    let scope = declared(derivation, claim).map_or(&derivation.scope, |d| &d.scope);
    let says = claim.says.trim_end_matches('.');
    let formula = short_formula(derivation, claim).filter(|shown| shown.is_within(room(claim)));
    // Without a reading its words are those of the claim, which stand above.
    if claim.reading.is_none() && formula.is_none() {
        return Vec::new();
    }
    let mut out = vec![quiet(lead)];
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

/// What separates the motions on which a claim holds from those on which it fails.
fn separated<'a>(derivation: &'a Derivation, claim: &'a ClaimAccount) -> Option<Vec<StorySpan<'a>>> {
    let separation = claim.conditions.separation.as_ref()?;
    let text = digest::explanation(separation.explanation.as_ref()?);
    let others =
        if separation.rivals.is_empty() { "" } else { ", or where another condition is met that fits as well" };
    Some(vec![quiet("holds just where: "), StorySpan::Prose(format!("{text}{others}"), &derivation.scope, Tone::Plain)])
}

/// On how much a reading fails, how sure that is, and the motion that tells most, in its own words and with its numbers.
fn fails<'a>(derivation: &'a Derivation, reading: &Reading<'a>) -> Vec<StorySpan<'a>> {
    let claim = reading.claim;
    let scope = declared(derivation, claim).map_or(&derivation.scope, |d| &d.scope);
    let says = digest::verdict(reading).replace(" to which it applies", "");
    let mut out = vec![StorySpan::Words("fails".to_owned(), Tone::Bad)];
    let rest = says.strip_prefix("Fails").map_or_else(|| format!(": {}", uncapital(&says)), str::to_owned);
    out.push(StorySpan::Prose(rest, scope, Tone::Plain));
    // What is left and right at the witness is said here, where it is not said before.
    if let Some(shown) = short_formula(derivation, claim).filter(|shown| !shown.is_within(room(claim))) {
        out.push(quiet(": "));
        out.extend(shown.spans(None, false));
    }
    let Some(motion) = RefutingMotion::of(derivation, claim) else {
        out.push(words("."));
        return out;
    };
    out.push(words(". "));
    let title = derivation.trajectories.iter().find(|t| t.id == motion.name).map(|t| t.title.as_str());
    let title = title.and_then(|t| t.split([':', ',', ';']).next());
    let is_short = |t: &&str| *t != motion.name && t.chars().count() <= LONGEST_TITLE;
    let title = title.filter(is_short).map(|t| StorySpan::Prose(format!(" ({t})"), &derivation.scope, Tone::Quiet));
    out.extend(motion.says_with(title, scope));
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
    let replayed = match reading.claim.identity.as_ref().and_then(|i| i.recorded.as_ref()).map(Recorded::grounds) {
        _ if !reading.basis().is_proof() => "",
        Some(Grounds::Checker) => ", replayed by the checker",
        Some(Grounds::CheckerBut(_)) => ", replayed but for some cases",
        Some(Grounds::Prover) => ", not replayed by the checker",
        None => "",
    };
    let basis = reading.basis();
    let known = if basis.is_proof() { basis.kind().to_owned() } else { format!("holds {}", basis.words()) };
    out.push(StorySpan::Words(known, Tone::Good));
    out.push(words(format!("{replayed}.")));
    out
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
    let of = |c: &&crate::derivation::Condition| matches!(c.holds.as_slice(), [one] if canonical(&one.text) == wanted);
    derivation.conditions.iter().find(of).map(|c| c.says.as_str())
}
