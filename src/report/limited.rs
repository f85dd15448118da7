//! How far what stands stands: the claims that hold as they are stated, and fail where the paper uses them.
//!
//! **In:** the claims with their readings. **Out:** these claims, the one that most others assume first, and a bounded card of them.

use super::card::RefutingMotion;
use super::consequence::Consequences;
use super::digest::{Fate, Reading, Whole};
use super::headline::CountedFate;
use super::numbers::count;
use super::points::{self, NeededReading};
use super::said::said;
use super::story::{StoryBlock, StorySpan, Tone, on_page, quiet, roomy, words};
use derivation::Derivation;

/// Longest words for a claim, in letters.
const LONGEST_NAME: usize = 34;
/// Most claims that fail as they are used, that are unfolded.
const MOST_AS_NEEDED: usize = 12;

/// A claim that stands as it is stated, and fails as the paper uses it.
pub(super) struct Limited<'w, 'a> {
    pub whole: &'w Whole<'a>,
    /// The reading that the paper uses.
    pub used: &'w Reading<'a>,
    /// How many readings assume it.
    pub assumed: usize,
}

/// All of them: what other claims assume comes first, then the heaviest; equals stay in the order of the paper.
pub(super) fn limited<'w, 'a>(
    derivation: &Derivation,
    wholes: &'w [Whole<'a>],
    hangs: &Consequences<'_>,
) -> Vec<Limited<'w, 'a>> {
    let refuted = |r: &Reading<'a>| RefutingMotion::of(derivation, r.claim).is_some_and(|m| m.witness().is_some());
    let assumed = |r: &Reading<'a>| {
        let all = wholes.iter().flat_map(|w| &w.readings);
        all.filter(|other| other.claim.assumptions.iter().any(|a| r.claim.formulas.contains(a))).count()
    };
    let standing = wholes.iter().filter(|w| w.fate == Fate::Stands);
    let with_use = standing.filter_map(|whole| Some((whole, whole.failing_need()?)));
    let mut out: Vec<Limited<'w, 'a>> =
        with_use.map(|(whole, used)| Limited { whole, used, assumed: assumed(used) }).collect();
    out.sort_by_cached_key(|l| std::cmp::Reverse((l.assumed, refuted(l.used), hangs.weight(l.whole.id))));
    out
}

/// How far what stands stands: the claims that hold as they are stated, but fail where the paper uses them. Bounded: one claim with its
/// numbers, the one that most others assume, and the others folded.
pub(super) fn limits<'a>(
    derivation: &'a Derivation,
    wholes: &[Whole<'a>],
    hangs: &Consequences<'a>,
) -> Vec<StoryBlock<'a>> {
    let limited = limited(derivation, wholes, hangs);
    let Some((first, rest)) = limited.split_first() else { return Vec::new() };
    let mut card = as_used(derivation, first);
    if let Some(StoryBlock::Paragraph(line)) = card.first_mut() {
        line.insert(0, StorySpan::Words("Stated and used differently: ".to_owned(), Tone::Strong));
        line.push(quiet(match rest.len() {
            0 => ".".to_owned(),
            n => format!(", and {n} more."),
        }));
    }
    let sketch = RefutingMotion::of(derivation, first.used.claim).and_then(|motion| motion.sketch());
    if let Some(sketch) = sketch {
        card.insert(1, StoryBlock::Group("roomy", vec![StoryBlock::Figure(sketch, Vec::new())]));
    }
    let mut blocks = vec![StoryBlock::Group("card", card)];
    if !rest.is_empty() {
        let items = rest.iter().take(MOST_AS_NEEDED).flat_map(|l| as_used(derivation, l)).collect();
        let n = rest.len();
        let verb = CountedFate::AsSaid.words(n);
        let title = format!("{n} more {} {verb}", if n == 1 { "claim" } else { "claims" });
        blocks.push(on_page(title, "", items));
    }
    blocks
}

/// What such a claim says, in what sense it stands, and where it fails as it is used.
fn as_used<'a>(derivation: &'a Derivation, of: &Limited<'_, 'a>) -> Vec<StoryBlock<'a>> {
    let mut line = vec![words("“"), said(derivation, of.whole, Tone::Strong, LONGEST_NAME)];
    line.push(quiet("”"));
    if of.assumed > 0 {
        let verb = if of.assumed == 1 { "assumes" } else { "assume" };
        line.push(roomy(format!(" ({} {verb} it)", count(of.assumed, "reading"))));
    }
    let mut out = vec![StoryBlock::Paragraph(line)];
    // A terminal has the first sentences for it.
    out.extend(points::as_stated(derivation, of.whole).map(|line| StoryBlock::Group("roomy", vec![line])));
    out.extend(points::lines(derivation, of.whole, NeededReading::Shown));
    out
}
