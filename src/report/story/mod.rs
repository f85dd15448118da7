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
use std::rc::Rc;

use maud::Markup;

pub(super) use html::{Medium, html};
pub(super) use markdown::{anchor, markdown};
pub(super) use terminal::terminal;
pub(super) use tex::tex;

pub(super) use super::shape::{Tone, VerdictShape};
use super::sketch::Sketch;
use latex::Scope;

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
    /// What a claim says, which leads to it: a text of the file, in which formulas stand between dollar signs.
    Said { claim: String, text: String, scope: &'a Scope, tone: Tone },
    /// Words that lead to a place of the page.
    Section(String, String),
    /// What can be typed.
    Code(String),
    /// A marked difference, where colours do not mark it.
    Difference(String),
    /// A file beside the report.
    File(String),
    /// A reason that the check gives: a formula may stand in it before "has no value".
    Reason(String, &'a Scope),
    /// What one comparison is called.
    Comparison(String, &'a Scope),
    /// A symbol.
    Shape(VerdictShape),
    /// What a terminal has no room for.
    Roomy(Vec<StorySpan<'a>>),
}

/// A table with a head.
#[derive(Clone, Debug)]
pub(super) struct StoryTable<'a> {
    /// What it shows.
    pub title: String,
    pub head: Vec<Vec<StorySpan<'a>>>,
    /// The first cell of a row is its head.
    pub rows: Vec<Vec<Vec<StorySpan<'a>>>>,
    pub cells: TableCells,
}

/// What stands in the cells of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TableCells {
    /// Symbols, one beside the other.
    Symbols,
    /// Texts, perhaps of several lines and pages.
    Texts,
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

/// A part of a report, with a heading and a place to which links lead.
#[derive(Clone, Debug)]
pub(super) struct StoryPart<'a> {
    /// Places of the page begin with a slash; the others are names of claims.
    pub place: String,
    pub level: PartLevel,
    pub title: Vec<StorySpan<'a>>,
    pub blocks: Vec<StoryBlock<'a>>,
}

/// How deep a part lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum PartLevel {
    Section,
    Subsection,
    /// A claim with several readings.
    Family,
    Claim,
    Reading,
}

/// What a printer without folds makes of one.
#[derive(Clone, Debug)]
pub(super) enum Elsewhere<'a> {
    /// Markdown folds it, too; the others print what is inside.
    Inside,
    /// The title as a line, and what is inside.
    Titled,
    /// This line, perhaps an empty one: the rest is for the page alone.
    Line(Vec<StorySpan<'a>>),
}

/// What is unfolded on request.
#[derive(Clone, Debug)]
pub(super) struct StoryFold<'a> {
    pub title: Vec<StorySpan<'a>>,
    /// Its names in the style of the page.
    pub class: String,
    pub elsewhere: Elsewhere<'a>,
    pub blocks: Vec<StoryBlock<'a>>,
}

/// What a page embeds as it is: a drawing, a table that its script knows.
#[derive(Clone)]
pub(super) struct Embedded<'a>(pub Rc<dyn Fn() -> Markup + 'a>);

impl std::fmt::Debug for Embedded<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Embedded")
    }
}

/// A block of a story.
#[derive(Clone, Debug)]
pub(super) enum StoryBlock<'a> {
    Heading(String),
    Part(StoryPart<'a>),
    Paragraph(Vec<StorySpan<'a>>),
    /// A formula on lines of its own.
    Formula(String, &'a Scope),
    /// Lines as they are, to be copied; of this kind.
    Lines(String, &'static str),
    Table(StoryTable<'a>),
    List(Vec<StoryItem<'a>>),
    /// What is not shown on the first screen.
    Fold(StoryFold<'a>),
    /// For a page alone.
    Embedded(Embedded<'a>),
    /// A drawing, with what it shows.
    Figure(Sketch, Vec<StorySpan<'a>>),
    /// Blocks that belong together, by the name that the style of the page has for them.
    Group(&'static str, Vec<StoryBlock<'a>>),
}

/// The symbols that stand in blocks.
pub(super) fn shapes(blocks: &[StoryBlock<'_>]) -> BTreeSet<VerdictShape> {
    fn of_spans(spans: &[StorySpan<'_>]) -> BTreeSet<VerdictShape> {
        let of = |span: &StorySpan<'_>| match span {
            StorySpan::Shape(shape) => BTreeSet::from([*shape]),
            StorySpan::Roomy(inside) => of_spans(inside),
            _ => BTreeSet::new(),
        };
        spans.iter().flat_map(of).collect()
    }
    let of_block = |block: &StoryBlock<'_>| match block {
        StoryBlock::Paragraph(spans) | StoryBlock::Figure(_, spans) => of_spans(spans),
        StoryBlock::Table(table) => table.rows.iter().flatten().flat_map(|cell| of_spans(cell)).collect(),
        StoryBlock::List(items) => {
            items.iter().flat_map(|item| of_spans(&item.line).into_iter().chain(shapes(&item.below))).collect()
        }
        StoryBlock::Fold(StoryFold { title, blocks, .. }) | StoryBlock::Part(StoryPart { title, blocks, .. }) => {
            &of_spans(title) | &shapes(blocks)
        }
        StoryBlock::Group(_, blocks) => shapes(blocks),
        StoryBlock::Heading(_) | StoryBlock::Formula(..) | StoryBlock::Lines(..) | StoryBlock::Embedded(_) => {
            BTreeSet::new()
        }
    };
    blocks.iter().flat_map(of_block).collect()
}

/// Words beside the matter for which a terminal has no room.
pub(super) fn roomy<'a>(text: impl Into<String>) -> StorySpan<'a> {
    StorySpan::Roomy(vec![quiet(text)])
}

/// Words without weight.
pub(super) fn words<'a>(text: impl Into<String>) -> StorySpan<'a> {
    StorySpan::Words(text.into(), Tone::Plain)
}

/// Words beside the matter.
pub(super) fn quiet<'a>(text: impl Into<String>) -> StorySpan<'a> {
    StorySpan::Words(text.into(), Tone::Quiet)
}

/// A text of the file, without weight.
pub(super) fn prose<'a>(text: impl Into<String>, scope: &'a Scope) -> StorySpan<'a> {
    StorySpan::Prose(text.into(), scope, Tone::Plain)
}

/// Words with weight.
pub(super) fn strong<'a>(text: impl Into<String>) -> StorySpan<'a> {
    StorySpan::Words(text.into(), Tone::Strong)
}

/// A name that leads to a claim.
pub(super) fn claim<'a>(name: impl Into<String>) -> StorySpan<'a> {
    StorySpan::Claim(name.into(), Tone::Plain)
}

/// A section of the report.
pub(super) fn section<'a>(place: &str, title: &str, blocks: Vec<StoryBlock<'a>>) -> StoryBlock<'a> {
    part(place, PartLevel::Section, vec![words(title)], blocks)
}

/// A part of the report.
pub(super) fn part<'a>(
    place: impl Into<String>,
    level: PartLevel,
    title: Vec<StorySpan<'a>>,
    blocks: Vec<StoryBlock<'a>>,
) -> StoryBlock<'a> {
    StoryBlock::Part(StoryPart { place: place.into(), level, title, blocks })
}

/// What is folded on a page and in Markdown.
pub(super) fn fold<'a>(title: impl Into<String>, blocks: Vec<StoryBlock<'a>>) -> StoryBlock<'a> {
    folded(vec![words(title)], Elsewhere::Inside, blocks)
}

/// What the page alone has, folded; elsewhere this line.
pub(super) fn on_page<'a>(title: impl Into<String>, line: &str, blocks: Vec<StoryBlock<'a>>) -> StoryBlock<'a> {
    let line = if line.is_empty() { Vec::new() } else { vec![words(line)] };
    folded(vec![words(title)], Elsewhere::Line(line), blocks)
}

/// A fold.
pub(super) fn folded<'a>(
    title: Vec<StorySpan<'a>>,
    elsewhere: Elsewhere<'a>,
    blocks: Vec<StoryBlock<'a>>,
) -> StoryBlock<'a> {
    StoryBlock::Fold(StoryFold { title, class: String::new(), elsewhere, blocks })
}

/// What a page embeds as it is.
pub(super) fn embedded<'a>(of: impl Fn() -> Markup + 'a) -> StoryBlock<'a> {
    StoryBlock::Embedded(Embedded(Rc::new(of)))
}

/// Items without a mark and without anything below.
pub(super) fn list<'a>(lines: impl IntoIterator<Item = Vec<StorySpan<'a>>>) -> StoryBlock<'a> {
    let item = |line| StoryItem { mark: String::new(), line, below: Vec::new() };
    StoryBlock::List(lines.into_iter().map(item).collect())
}

/// A table of texts.
pub(super) fn texts<'a>(
    title: impl Into<String>,
    head: &[&str],
    rows: impl IntoIterator<Item = Vec<Vec<StorySpan<'a>>>>,
) -> StoryBlock<'a> {
    let head = head.iter().map(|word| vec![words(*word)]).collect();
    StoryBlock::Table(StoryTable {
        title: title.into(),
        head,
        rows: rows.into_iter().collect(),
        cells: TableCells::Texts,
    })
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
