//! How far what stands stands, in a few lines of page one: the printed equations that do, and the claims that hold as they are
//! said, but fail where the paper needs more.
//!
//! **In:** the digest of an account. **Out:** one paragraph, or none. **Guaranteed:** bounded: one claim with its
//! numbers, the one that most others assume, and how many there are beside it.

use super::card::RefutingMotion;
use super::consequence::Consequences;
use super::digest::{self, Fate, Whole};
use super::numbers::count;
use super::story::{StoryBlock, StorySpan, Tone, quiet, words};
use super::tally::{Standing, declared};
use crate::derivation::{ClaimRole, Derivation};
use findings::ClaimAccount;

/// Most labels of equations.
const MOST_LABELS: usize = 12;
/// The paragraph.
pub(super) fn blocks<'a>(
    derivation: &'a Derivation,
    wholes: &[Whole<'a>],
    hangs: &Consequences<'a>,
) -> Vec<StoryBlock<'a>> {
    let mut out = equations(derivation, wholes);
    let mut limited: Vec<(&Whole<'a>, &'a ClaimAccount)> =
        wholes.iter().filter(|w| w.fate == Fate::Stands).filter_map(|w| Some((w, needed(w)?))).collect();
    // What other claims assume comes first, then the heaviest; equals stay in the order of the paper.
    let refuted = |claim: &'a ClaimAccount| RefutingMotion::of(claim).filter(|m| m.witness().is_some());
    let assumed = |claim: &ClaimAccount| {
        let all = wholes.iter().flat_map(|w| &w.readings);
        all.filter(|r| r.claim.assumptions.iter().any(|a| claim.formulas.contains(a))).count()
    };
    limited.sort_by_cached_key(|(w, claim)| {
        std::cmp::Reverse((assumed(claim), refuted(claim).is_some(), hangs.weight(w.id)))
    });
    if let Some((whole, claim)) = limited.first() {
        if let Some(reading) = whole.readings.iter().find(|r| std::ptr::eq(r.claim, *claim)) {
            let fails = digest::verdict(reading);
            let space = if out.is_empty() { "" } else { " " };
            let readings = count(assumed(claim), "reading");
            let assumed = if assumed(claim) > 0 { format!("; {readings} assume it") } else { String::new() };
            out.extend([
                words(space),
                StorySpan::Claim(whole.id.to_owned(), Tone::Strong),
                words(" stands as it is said; as it is needed, it "),
                StorySpan::Prose(format!("{}{assumed}. ", fails.replacen('F', "f", 1)), &derivation.scope, Tone::Plain),
            ]);
            out.extend(refuted(claim).map(|m| m.says(&derivation.scope)).unwrap_or_default());
        }
        let beside = limited.len() - 1;
        if beside > 0 {
            out.push(quiet(format!(" So with {beside} more.")));
        }
    }
    if out.is_empty() { Vec::new() } else { vec![StoryBlock::Paragraph(out)] }
}

/// The reading that the paper needs and that fails, on some motion or wherever it applies.
fn needed<'a>(whole: &Whole<'a>) -> Option<&'a ClaimAccount> {
    let fails = |standing: Standing| standing == Standing::Fails || standing == Standing::Mixed;
    whole.readings.iter().find(|r| r.role == ClaimRole::Needs && fails(r.standing)).map(|r| r.claim)
}

/// The labels of printed equations of which all claims stand.
fn equations<'a>(derivation: &'a Derivation, wholes: &[Whole<'a>]) -> Vec<StorySpan<'a>> {
    let mut labels: Vec<(&'a str, bool)> = Vec::new();
    for whole in wholes.iter().filter(|w| w.fate.is_of_the_paper()) {
        let label = whole.readings.iter().find_map(|r| declared(derivation, r.claim)?.label.as_deref());
        let Some(label) = label else { continue };
        let stands = whole.fate == Fate::Stands;
        match labels.iter_mut().find(|(l, _)| *l == label) {
            Some((_, all)) => *all &= stands,
            None => labels.push((label, stands)),
        }
    }
    let stand: Vec<&str> = labels.iter().filter(|(_, stands)| *stands).map(|(l, _)| *l).collect();
    if stand.is_empty() {
        return Vec::new();
    }
    let more = stand.len().saturating_sub(MOST_LABELS);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let word = if stand.len() == 1 { "Equation" } else { "Equations" };
    let verb = if stand.len() == 1 { "stands" } else { "stand" };
    let named = stand.iter().take(MOST_LABELS).copied().collect::<Vec<_>>().join(", ");
    vec![words(format!("{word} {named}{more} {verb}."))]
}
