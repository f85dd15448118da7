//! A story as HTML: what a browser shows.

use maud::{Markup, PreEscaped, html as markup};

use super::super::differing::differing;
use super::super::mathml;
use super::super::page::text::{display, formula, label, prose, reason};
use super::{
    Elsewhere, PartLevel, StoryBlock, StoryFold, StoryItem, StoryPart, StorySpan, StoryTable, TableCells, Tone,
};
use latex::Scope;

/// Where the page is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Medium {
    Screen,
    /// Nothing can be unfolded.
    Paper,
}

/// The markup of blocks.
pub(in super::super) fn html(blocks: &[StoryBlock<'_>], medium: Medium) -> Markup {
    markup! { @for block in blocks { (put(block, medium)) } }
}

fn put(block: &StoryBlock<'_>, medium: Medium) -> Markup {
    markup! {
        @match block {
            StoryBlock::Heading(text) => h3 { (text) },
            StoryBlock::Part(of) => (part(of, medium)),
            StoryBlock::Paragraph(spans) => p { (line(spans)) },
            StoryBlock::Formula(text, scope) => (display(text, scope)),
            StoryBlock::Lines(text, kind) => pre class=[(!kind.is_empty()).then_some(kind)] tabindex="0" { (text) },
            StoryBlock::Table(of) => (table(of)),
            StoryBlock::List(items) => ul.items { @for one in items { (item(one, medium)) } },
            StoryBlock::Fold(of) => (fold(of, medium)),
            StoryBlock::Embedded(of) => ((of.0)()),
            StoryBlock::Figure(sketch, caption) => {
                figure { (PreEscaped(sketch.svg())) @if !caption.is_empty() { figcaption { (line(caption)) } } }
            },
            StoryBlock::Group("page", blocks) => @if medium == Medium::Screen { (html(blocks, medium)) },
            StoryBlock::Group("paper", blocks) => @if medium == Medium::Paper { (html(blocks, medium)) },
            // Page one is laid out for itself.
            StoryBlock::Group("front", blocks) => div.front id="/front" { (html(blocks, Medium::Screen)) },
            StoryBlock::Group(name, blocks) => div class=(name) { (html(blocks, medium)) },
        }
    }
}

fn part(of: &StoryPart<'_>, medium: Medium) -> Markup {
    let StoryPart { place, level, title, blocks } = of;
    let inside = || html(blocks, medium);
    markup! {
        @match level {
            PartLevel::Section => section id=(place) { h2 { (line(title)) } (inside()) },
            PartLevel::Subsection => { h3 id=(place) { (line(title)) } (inside()) },
            PartLevel::Family => div.family { h4 id=[(!place.is_empty()).then_some(place)] { (line(title)) } (inside()) },
            PartLevel::Claim => article.claim id=(place) { h4 { (line(title)) } (inside()) },
            PartLevel::Reading => article.claim id=(place) { h5 { (line(title)) } (inside()) },
        }
    }
}

fn fold(of: &StoryFold<'_>, medium: Medium) -> Markup {
    let StoryFold { title, class, elsewhere, blocks } = of;
    let inside = || html(blocks, medium);
    markup! {
        @match (medium, elsewhere) {
            (Medium::Screen, _) if blocks.is_empty() => {},
            (Medium::Screen, _) => details class=[(!class.is_empty()).then_some(class)] { summary { (line(title)) } (inside()) },
            (Medium::Paper, Elsewhere::Inside) => (inside()),
            (Medium::Paper, Elsewhere::Titled) => { p { (line(title)) } (inside()) },
            (Medium::Paper, Elsewhere::Line(words)) => @if !words.is_empty() { p { (line(words)) } },
        }
    }
}

fn item(item: &StoryItem<'_>, medium: Medium) -> Markup {
    markup! { li { @if !item.mark.is_empty() { b.no { (item.mark) } " " } (line(&item.line)) (html(&item.below, medium)) } }
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
        StorySpan::Said { claim, text, scope, tone } => {
            marked(markup! { a href={ "#" (claim) } title=(claim) { (prose(text, scope)) } }, *tone)
        }
        StorySpan::Section(text, place) => markup! { a href={ "#" (place) } { (text) } },
        StorySpan::Code(text) => markup! { code { (text) } },
        StorySpan::Difference(_) => Markup::default(),
        StorySpan::File(name) => markup! { a href=(name) { (name) } },
        StorySpan::Reason(text, scope) => reason(text, scope),
        StorySpan::Comparison(text, scope) => label(text, scope),
        StorySpan::Shape(shape) => {
            markup! { span class={ "mark " (shape.class()) } role="img" aria-label=(shape.says()) {} }
        }
        StorySpan::Roomy(inside) => markup! { @for of in inside { (self::span(of)) } },
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
                    @if cell.is_empty() { td {} } @else { th scope="col" class=[(at > 0 && of.cells == TableCells::Symbols).then_some("c")] { (line(cell)) } }
                } } }
                tbody { @for row in &of.rows { tr { @for (at, cell) in row.iter().enumerate() {
                    @if at == 0 { th scope="row" { (line(cell)) } } @else { td { (line(cell)) } }
                } } } }
            }
        }
    }
}
