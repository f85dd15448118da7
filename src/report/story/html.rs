//! A story as HTML: what a browser shows.

use maud::{Markup, PreEscaped, html as markup};

use super::super::differing::differing;
use super::super::mathml;
use super::super::page::text::{formula, prose};
use super::{StoryBlock, StoryItem, StorySpan, StoryTable, Tone};
use crate::latex::Scope;

/// The markup of blocks.
pub(in super::super) fn html(blocks: &[StoryBlock<'_>]) -> Markup {
    markup! { @for block in blocks { (put(block)) } }
}

fn put(block: &StoryBlock<'_>) -> Markup {
    markup! {
        @match block {
            StoryBlock::Heading(text) => h3 { (text) },
            StoryBlock::Paragraph(spans) => p { (line(spans)) },
            StoryBlock::Table(of) => (table(of)),
            StoryBlock::List(items) => ul.items { @for one in items { (item(one)) } },
            StoryBlock::Fold { blocks, .. } if blocks.is_empty() => {},
            StoryBlock::Fold { title, blocks, .. } => details { summary { (title) } (html(blocks)) },
            StoryBlock::Figure(sketch, caption) => {
                figure { (PreEscaped(sketch.svg())) @if !caption.is_empty() { figcaption { (line(caption)) } } }
            },
            StoryBlock::Group(name, blocks) => div class=(name) { (html(blocks)) },
        }
    }
}

fn item(item: &StoryItem<'_>) -> Markup {
    markup! { li { @if !item.mark.is_empty() { b.no { (item.mark) } " " } (line(&item.line)) (html(&item.below)) } }
}

fn line(spans: &[StorySpan<'_>]) -> Markup {
    markup! { @for one in spans { (span(one)) } }
}

fn marked(inner: Markup, tone: Tone) -> Markup {
    match tone {
        Tone::Plain => inner,
        Tone::Strong => markup! { b { (inner) } },
        Tone::Quiet => markup! { span.quiet { (inner) } },
        Tone::Good => markup! { b.stand { (inner) } },
        Tone::Bad => markup! { b.fail { (inner) } },
        Tone::Open => markup! { b.open { (inner) } },
        Tone::Alarm => markup! { strong.alarm { (inner) } },
    }
}

fn span(span: &StorySpan<'_>) -> Markup {
    match span {
        StorySpan::Words(text, tone) => marked(markup! { (text) }, *tone),
        StorySpan::Prose(text, scope, tone) => marked(prose(text, scope), *tone),
        StorySpan::Math(text, scope) => formula(text, scope),
        StorySpan::Marked { formula: text, beside, scope, wrong } => marked_formula(text, beside, scope, *wrong),
        StorySpan::Claim(name, tone) => marked(markup! { a href={ "#" (name) } { (name) } }, *tone),
        StorySpan::Section(text, place) => markup! { a href={ "#" (place) } { (text) } },
        StorySpan::Code(text) => markup! { code { (text) } },
        StorySpan::Shape(shape) => {
            markup! { span class={ "mark " (shape.class()) } role="img" aria-label=(shape.says()) {} }
        }
    }
}

/// A formula with what the other has not in another colour.
fn marked_formula(text: &str, beside: &str, scope: &Scope, wrong: bool) -> Markup {
    let class = if wrong { "wrong" } else { "right" };
    match (mathml::formula_mathml(text, scope), mathml::formula_mathml(beside, scope)) {
        (Some(own), Some(other)) => {
            let math = differing(&own, &other, class);
            markup! { span.long tabindex="0" role="group" aria-label="formula" { (PreEscaped(math)) } }
        }
        _ => formula(text, scope),
    }
}

fn table(of: &StoryTable<'_>) -> Markup {
    markup! {
        div.scroll tabindex="0" role="group" aria-label=(of.title) {
            table {
                thead { tr { @for (at, cell) in of.head.iter().enumerate() {
                    @if cell.is_empty() { td {} } @else { th scope="col" class=[(at > 0).then_some("c")] { (line(cell)) } }
                } } }
                tbody { @for row in &of.rows { tr { @for (at, cell) in row.iter().enumerate() {
                    @if at == 0 { th scope="row" { (line(cell)) } } @else { td { (line(cell)) } }
                } } } }
            }
        }
    }
}
