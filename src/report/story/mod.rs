//! A report as a story of blocks: a section is written once, and printed for a terminal, as Markdown, as LaTeX and as HTML.
//!
//! **In:** [`StoryBlock`]s, which a section makes from findings. **Out:** text of one kind, by one of four printers.
//!
//! No section knows its printer, and no printer knows a finding: what is said is in the blocks, how it looks is in the printer.
//! Words of the program, texts of the file and formulas are told apart ([`StorySpan`]), so that each printer escapes what it must.

mod html;
mod markdown;
mod terminal;
mod tex;

use std::collections::BTreeSet;

pub(super) use html::html;
pub(super) use markdown::markdown;
pub(super) use terminal::terminal;
pub(super) use tex::tex;

pub(super) use super::shape::{Tone, VerdictShape};
use super::sketch::Sketch;
use crate::latex::Scope;

/// A piece of a line.
#[derive(Clone, Debug)]
pub(super) enum StorySpan<'a> {
    /// Words of the program.
    Words(String, Tone),
    /// A text of the file, in which formulas stand between dollar signs.
    Prose(String, &'a Scope, Tone),
    /// A formula.
    Math(String, &'a Scope),
    /// A formula of which the parts are marked that another has not: `wrong` in the print, else in what is right.
    Marked { formula: String, beside: String, scope: &'a Scope, wrong: bool },
    /// The name of a claim, which leads to what is said of it.
    Claim(String, Tone),
    /// Words that lead to a section of the page, by its place.
    Section(String, &'static str),
    /// What can be typed.
    Code(String),
    /// A symbol.
    Shape(VerdictShape),
}

/// A table with a head.
#[derive(Clone, Debug)]
pub(super) struct StoryTable<'a> {
    /// What it shows.
    pub title: String,
    pub head: Vec<Vec<StorySpan<'a>>>,
    /// The first cell of a row is its head.
    pub rows: Vec<Vec<Vec<StorySpan<'a>>>>,
}

/// An item of a list.
#[derive(Clone, Debug)]
pub(super) struct StoryItem<'a> {
    /// What stands before it: a number, a letter; empty for a dot.
    pub mark: String,
    pub line: Vec<StorySpan<'a>>,
    /// What stands below the line, deeper.
    pub below: Vec<StoryBlock<'a>>,
}

/// A block of a story.
#[derive(Clone, Debug)]
pub(super) enum StoryBlock<'a> {
    Heading(String),
    Paragraph(Vec<StorySpan<'a>>),
    Table(StoryTable<'a>),
    List(Vec<StoryItem<'a>>),
    /// What is not shown on the first screen. Where a line says what is there, only a page has it.
    Fold {
        title: String,
        unfolded: Option<String>,
        blocks: Vec<StoryBlock<'a>>,
    },
    /// A drawing, with what it shows.
    Figure(Sketch, Vec<StorySpan<'a>>),
    /// Blocks that belong together, by the name that the style of the page has for them.
    Group(&'static str, Vec<StoryBlock<'a>>),
}

/// The symbols that stand in blocks.
pub(super) fn shapes(blocks: &[StoryBlock<'_>]) -> BTreeSet<VerdictShape> {
    let of_spans = |spans: &[StorySpan<'_>]| -> BTreeSet<VerdictShape> {
        spans.iter().filter_map(|s| if let StorySpan::Shape(shape) = s { Some(*shape) } else { None }).collect()
    };
    let of_block = |block: &StoryBlock<'_>| match block {
        StoryBlock::Paragraph(spans) | StoryBlock::Figure(_, spans) => of_spans(spans),
        StoryBlock::Table(table) => table.rows.iter().flatten().flat_map(|cell| of_spans(cell)).collect(),
        StoryBlock::List(items) => {
            items.iter().flat_map(|item| of_spans(&item.line).into_iter().chain(shapes(&item.below))).collect()
        }
        StoryBlock::Fold { blocks, .. } | StoryBlock::Group(_, blocks) => shapes(blocks),
        StoryBlock::Heading(_) => BTreeSet::new(),
    };
    blocks.iter().flat_map(of_block).collect()
}

/// Words without weight.
pub(super) fn words<'a>(text: impl Into<String>) -> StorySpan<'a> {
    StorySpan::Words(text.into(), Tone::Plain)
}

/// Words beside the matter.
pub(super) fn quiet<'a>(text: impl Into<String>) -> StorySpan<'a> {
    StorySpan::Words(text.into(), Tone::Quiet)
}

/// Several pieces with something between them.
pub(super) fn joined<'a>(all: impl IntoIterator<Item = Vec<StorySpan<'a>>>, between: &str) -> Vec<StorySpan<'a>> {
    let mut out = Vec::new();
    for (i, one) in all.into_iter().enumerate() {
        if i > 0 {
            out.push(words(between));
        }
        out.extend(one);
    }
    out
}
