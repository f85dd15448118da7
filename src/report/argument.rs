//! What a paper concludes, with the chain of steps under each conclusion, and where it breaks.
//!
//! **In:** the claims with their readings, and what rests on what. **Out:** for each conclusion its sentence, what became of it, as what it
//! was tested, where it holds or fails and how sure that is, and the shortest chain from the heaviest break to the conclusion. Where a
//! file names no conclusion, what its steps lead to; where it has no steps, nothing.
//!
//! A step breaks a chain if it does not stand, or if what the paper needs of it fails.

use std::collections::{BTreeMap, BTreeSet};

use super::card::{RefutingMotion, Room};
use super::consequence::Consequences;
use super::digest::{Fate, Whole};
use super::numbers::count;
use super::points::{self, NeededReading};
use super::said::said;
use super::story::{StoryBlock, StoryItem, StorySpan, Tone, joined, quiet, roomy, words};
use super::tally::declared;
use derivation::Derivation;

/// Most conclusions that are told.
const MOST_CONCLUSIONS: usize = 6;
/// Most steps of a chain; of a longer one the middle is left out.
const MOST_STEPS: usize = 4;
/// Longest words of a step, in letters.
const LONGEST_STEP: usize = 24;
/// Most grounds that are named of a conclusion whose chains are whole.
const MOST_GROUNDS: usize = 4;

/// The claims of a file by their ids.
type ById<'w, 'a> = BTreeMap<&'a str, &'w Whole<'a>>;

/// Whether a step breaks the chains that go through it.
fn breaks(whole: &Whole<'_>) -> bool {
    whole.fate.is_against() || whole.failing_need().is_some()
}

/// The conclusions with their chains. Where a file names no conclusion, what its steps lead to. The witness of the claim that is `shown`
/// stands elsewhere on the page.
pub(super) fn blocks<'a>(
    derivation: &'a Derivation,
    wholes: &[Whole<'a>],
    hangs: &Consequences<'a>,
    shown: Option<&str>,
) -> Vec<StoryBlock<'a>> {
    let by_id: ById<'_, 'a> = wholes.iter().map(|w| (w.id, w)).collect();
    let named = hangs.conclusions();
    let title = if named.is_empty() { "Where the steps lead" } else { "The paper concludes" };
    let ends: Vec<&'a str> = if named.is_empty() { ends(wholes, hangs) } else { named.to_vec() };
    let witnessed = wholes.iter().map(|w| w.id).filter(|id| Some(*id) == shown).collect();
    let mut told = Told { witnessed, chains: Vec::new() };
    let shown = ends.iter().take(MOST_CONCLUSIONS).filter_map(|id| by_id.get(id));
    let items: Vec<StoryItem<'a>> = shown.map(|whole| item(derivation, whole, &by_id, hangs, &mut told)).collect();
    if items.is_empty() {
        return Vec::new();
    }
    let heading = StoryBlock::Heading(title.to_owned());
    // The first sentences have named the letters of conclusions.
    let heading = if named.is_empty() { heading } else { StoryBlock::Group("roomy", vec![heading]) };
    let mut out = vec![heading, StoryBlock::List(items)];
    let more = ends.len().saturating_sub(MOST_CONCLUSIONS);
    if more > 0 {
        out.push(StoryBlock::Paragraph(vec![quiet(format!("And {} more.", count(more, "conclusion")))]));
    }
    out
}

/// What the page has told already.
struct Told<'a> {
    /// The claims whose witness is shown.
    witnessed: BTreeSet<&'a str>,
    /// The steps of the chains of conclusions, by their letters.
    chains: Vec<(char, Vec<&'a str>)>,
}

/// What rests on something and carries nothing, the longest argument first.
fn ends<'a>(wholes: &[Whole<'a>], hangs: &Consequences<'_>) -> Vec<&'a str> {
    let of_paper = wholes.iter().filter(|w| w.fate.is_of_the_paper());
    let is_end = |w: &&Whole<'_>| hangs.directly_on(w.id).is_empty() && !hangs.direct_grounds(w.id).is_empty();
    let mut out: Vec<&Whole<'a>> = of_paper.filter(is_end).collect();
    out.sort_by_cached_key(|w| std::cmp::Reverse(hangs.length(w.id)));
    out.into_iter().map(|w| w.id).collect()
}

fn item<'a>(
    derivation: &'a Derivation,
    whole: &Whole<'a>,
    by_id: &ById<'_, 'a>,
    hangs: &Consequences<'a>,
    told: &mut Told<'a>,
) -> StoryItem<'a> {
    let scope = &derivation.scope;
    let says = whole.says.trim_end_matches('.').to_owned();
    let mut line = vec![StorySpan::Prose(says, scope, Tone::Plain)];
    let mut known = vec![quiet(" ("), StorySpan::Claim(whole.id.to_owned(), Tone::Plain), quiet("): ")];
    let tone = match whole.fate {
        Fate::Fails | Fate::Partly => Tone::Bad,
        _ if whole.counted_as().stands() => Tone::Good,
        _ => Tone::Open,
    };
    known.push(StorySpan::Words(whole.counted_as().words(1).to_owned(), tone));
    // A conclusion has a letter, and on a terminal a symbol for the words.
    match hangs.letter(whole.id) {
        Some(_) => {
            let shape = whole.counted_as().shape().unwrap_or_else(|| whole.shape());
            line.splice(0..0, [StorySpan::Shape(shape), words("\u{a0}")]);
            line.push(StorySpan::Roomy(known));
        }
        None => line.extend(known),
    }
    let mut broken: Vec<&&Whole<'a>> =
        hangs.grounds_of(whole.id).into_iter().filter_map(|id| by_id.get(id)).filter(|w| breaks(w)).collect();
    broken.sort_by_cached_key(|w| (!w.fate.is_against(), std::cmp::Reverse(hangs.weight(w.id))));
    line.push(words("."));
    let mark = hangs.letter(whole.id).map(String::from).unwrap_or_default();
    told.witnessed.insert(whole.id);
    let mut below = points::lines(derivation, whole, NeededReading::NotShown);
    below.extend(points::needs(derivation, whole));
    let Some(first) = broken.first() else {
        below.push(StoryBlock::Paragraph(grounds(derivation, whole, by_id, hangs)));
        return StoryItem { mark, line, below: vec![StoryBlock::Group("chain", below)] };
    };
    let mut steps = chain(derivation, &hangs.chain(first.id, whole.id), (by_id, hangs), &mut told.chains);
    // Each break is shown once; a terminal has room for that of a conclusion that stands.
    let says = told.witnessed.insert(first.id).then(|| break_says(derivation, first)).filter(|says| !says.is_empty());
    match says {
        Some(says) if !whole.fate.is_against() => {
            steps.push(words(". "));
            steps.extend(says);
            below.push(StoryBlock::Paragraph(steps));
        }
        says => {
            steps.push(roomy("."));
            below.push(StoryBlock::Paragraph(steps));
            below.extend(says.map(|says| StoryBlock::Group("roomy", vec![StoryBlock::Paragraph(says)])));
        }
    }
    StoryItem { mark, line, below: vec![StoryBlock::Group("chain", below)] }
}

/// A step in its words, with what became of it.
fn link<'a>(derivation: &'a Derivation, id: &'a str, by_id: &ById<'_, 'a>) -> Vec<StorySpan<'a>> {
    let Some(whole) = by_id.get(id) else { return vec![StorySpan::Claim(id.to_owned(), Tone::Plain)] };
    let tone = if breaks(whole) { Tone::Bad } else { Tone::Plain };
    let mut out = vec![words("“"), said(derivation, whole, tone, LONGEST_STEP), words("”\u{a0}")];
    out.push(StorySpan::Shape(whole.shape()));
    // The sentence may stand where what the argument needs of it does not.
    if let Some(needed) = whole.failing_need().filter(|_| !whole.fate.is_against()) {
        out.extend([words("\u{a0}("), StorySpan::Shape(needed.shape()), words("\u{a0}as used)")]);
    } else if let Some(shape) = whole.shape_on_drawn() {
        out.extend([words("\u{a0}("), StorySpan::Shape(shape), words("\u{a0}on a drawn motion)")]);
    }
    out
}

/// A chain from its ground up to a conclusion, which stands above it: by its letter. Of one that begins as another that was told, the
/// steps are told from the last that they share.
fn chain<'a>(
    derivation: &'a Derivation,
    ids: &[&'a str],
    (by_id, hangs): (&ById<'_, 'a>, &Consequences<'_>),
    told: &mut Vec<(char, Vec<&'a str>)>,
) -> Vec<StorySpan<'a>> {
    let Some((last, all)) = ids.split_last() else { return Vec::new() };
    let common = |of: &[&str]| of.iter().zip(all).take_while(|(a, b)| a == b).count();
    let before = told.iter().map(|(letter, of)| (common(of), *letter)).reduce(|a, b| if b.0 > a.0 { b } else { a });
    let before = before.filter(|(shared, _)| *shared > 1);
    told.extend(hangs.letter(last).map(|letter| (letter, all.to_vec())));
    let below = before.and_then(|(shared, _)| all.get(shared - 1..)).unwrap_or(all);
    let shown = if below.len() >= MOST_STEPS { &below[..MOST_STEPS - 2] } else { below };
    let mut steps: Vec<Vec<StorySpan<'a>>> = Vec::new();
    steps.extend(before.map(|(_, letter)| vec![quiet(format!("as under {letter}"))]));
    steps.extend(shown.iter().map(|id| link(derivation, id, by_id)));
    if below.len() > shown.len() {
        steps.push(vec![quiet(format!("… {} more …", below.len() - shown.len()))]);
    }
    let end = hangs.letter(last).map_or_else(|| "this".to_owned(), String::from);
    let mut end = vec![StorySpan::Words(end, Tone::Strong)];
    let shape = by_id.get(last).map(|w| StorySpan::Roomy(vec![words("\u{a0}"), StorySpan::Shape(w.shape())]));
    end.extend(shape);
    steps.push(end);
    joined(steps, " → ")
}

/// What a conclusion rests on, where nothing of it is broken.
fn grounds<'a>(
    derivation: &'a Derivation,
    whole: &Whole<'a>,
    by_id: &ById<'_, 'a>,
    hangs: &Consequences<'a>,
) -> Vec<StorySpan<'a>> {
    let all = hangs.grounds_of(whole.id);
    let direct = hangs.direct_grounds(whole.id);
    if direct.is_empty() {
        return vec![quiet("Rests on no other claim of the file.")];
    }
    let mut out = vec![quiet("Rests on ")];
    out.extend(joined(direct.iter().take(MOST_GROUNDS).map(|id| link(derivation, id, by_id)), ", "));
    let more = all.len().saturating_sub(direct.len().min(MOST_GROUNDS));
    if more > 0 {
        out.push(quiet(format!(" and, through them or beside them, {more} more")));
    }
    let on_drawn = all.iter().filter_map(|id| by_id.get(id)).any(|w| w.shape_on_drawn().is_some());
    out.push(quiet(if on_drawn { "." } else { "; no step fails." }));
    out
}

/// Why a step breaks the chain of a conclusion that stands.
fn break_says<'a>(derivation: &'a Derivation, whole: &Whole<'a>) -> Vec<StorySpan<'a>> {
    let need = whole.failing_need().filter(|_| !whole.fate.is_against());
    let reading = need.or_else(|| whole.failing()).or(whole.readings.first());
    let Some(reading) = reading else { return Vec::new() };
    let scope = declared(derivation, reading.claim).map_or(&derivation.scope, |d| &d.scope);
    // It is the first of the chain that stands before.
    let mut out = vec![StorySpan::Words("The first step fails".to_owned(), Tone::Bad)];
    if need.is_some() {
        let says = format!(" as the paper uses it: {}", reading.claim.says.trim_end_matches('.'));
        out.push(StorySpan::Prose(says, scope, Tone::Plain));
    }
    out.push(words(". "));
    if let Some(motion) = RefutingMotion::of(derivation, reading.claim) {
        out.extend(motion.says(derivation, scope, Room::OnPage));
    } else if let Some(contrary) = whole.contrary() {
        let says = contrary.claim.says.trim_end_matches('.');
        out.push(StorySpan::Prose(format!("The contrary holds: “{says}”."), scope, Tone::Plain));
    }
    out
}
