//! The report as a whole: its sections in their order.
//!
//! **In:** a derivation and its account. **Out:** blocks, of which Markdown, LaTeX and paper have all, and the page those that need no script.

use super::claim_story;
use super::digest::{self, Whole};
use super::headline::{self, CountedFate};
use super::hypotheses;
use super::letters::{LEGEND, letters};
use super::page_one;
use super::sections;
use super::story::{
    PartLevel, StoryBlock, StorySpan, claim, joined, list, on_page, part, prose, quiet, section, words,
};
use super::units;
use derivation::Derivation;
use findings::Account;

/// All sections, with the graph as this kind of report draws it.
pub(super) fn report<'a>(
    derivation: &'a Derivation,
    account: &'a Account,
    graph: Option<StoryBlock<'a>>,
) -> Vec<StoryBlock<'a>> {
    let found = front(derivation, account).into_iter().chain(listed(derivation, account));
    let mut out = vec![section(FOUND.0, FOUND.1, found.collect()), claim_story::claims(derivation, account)];
    out.extend(matrix(account));
    out.extend(graph);
    out.extend(sections::motions(derivation, account));
    out.extend(rest(derivation, account));
    out
}

/// The sections behind claims and motions.
pub(super) fn rest<'a>(derivation: &'a Derivation, account: &'a Account) -> Vec<StoryBlock<'a>> {
    let mut out: Vec<StoryBlock<'a>> = sections::measures(derivation, account).into_iter().collect();
    out.extend(sections::conventions(derivation));
    out.push(sections::symbols(derivation));
    out.extend(sections::systems(derivation));
    out.extend(units::units(&account.units, &derivation.scope));
    out.push(sections::making(derivation));
    out
}

/// One letter for each pair: the whole matrix in a few kilobytes.
fn matrix<'a>(account: &Account) -> Option<StoryBlock<'a>> {
    let says = format!("{LEGEND} Columns are the motions by number.");
    let blocks = |body| vec![StoryBlock::Paragraph(vec![words(says)]), StoryBlock::Lines(body, "letters")];
    letters(account).map(|body| section("/matrix", "Claims and motions", blocks(body)))
}

/// The title of the section on what was found.
pub(super) const FOUND: (&str, &str) = ("/findings", "What was found");

/// Page one, and what has no room on its first screen.
pub(super) fn front<'a>(derivation: &'a Derivation, account: &'a Account) -> Vec<StoryBlock<'a>> {
    let mut blocks = page_one::blocks(derivation, account);
    let below = blocks.pop();
    std::iter::once(StoryBlock::Group("front", blocks)).chain(below).collect()
}

/// What was found, below page one: the counts, a map of the claims, and what was left unsaid.
pub(super) fn listed<'a>(derivation: &'a Derivation, account: &'a Account) -> Vec<StoryBlock<'a>> {
    let wholes = digest::wholes(derivation, account);
    let mut blocks = Vec::new();
    let counts = CountedFate::told().filter_map(|counted| {
        let n = wholes.iter().filter(|w| w.counted_as() == counted).count();
        let text = format!("{n} {}", counted.words(n));
        (n > 0).then(|| vec![StorySpan::Section(text, format!("/found/{}", counted.fate().key()))])
    });
    let counts = StoryBlock::Paragraph(joined(counts, " · "));
    blocks.push(StoryBlock::Group("page", vec![StoryBlock::Group("counts", vec![counts])]));
    blocks.push(StoryBlock::Paragraph(expected(account)));
    blocks.push(StoryBlock::Group("page", vec![in_order(derivation, &wholes)]));
    blocks.extend(hypotheses::section(derivation, account, &wholes));
    blocks
}

/// How all was tried, and that all is as expected; what is not is named on page one.
fn expected<'a>(account: &Account) -> Vec<StorySpan<'a>> {
    let all =
        if headline::unexpected(account).is_empty() { " Every verdict is as the derivation file expects." } else { "" };
    vec![quiet(format!("{}{all}", headline::tried(account)))]
}

/// Every claim of the paper in its order, with the shape of its fate: a map of the paper, at one glance.
fn in_order<'a>(derivation: &'a Derivation, wholes: &[Whole<'a>]) -> StoryBlock<'a> {
    let told = wholes.iter().filter(|w| w.fate.is_of_the_paper());
    let lines = told.map(|whole| {
        let says = prose(format!(" {}", whole.says), &derivation.scope);
        vec![StorySpan::Shape(whole.shape()), words(" "), claim(whole.id), says]
    });
    let blocks = vec![on_page("All of them", "", vec![StoryBlock::Group("order", vec![list(lines)])])];
    part("/order", PartLevel::Subsection, vec![words("The claims in their order")], blocks)
}
