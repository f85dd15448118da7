//! A story as Markdown, as a forge renders it.

use super::super::markup::{append, code, display, fenced, math, prose};
use super::super::wording::label;
use super::{Elsewhere, PartLevel, StoryBlock, StoryFold, StoryItem, StorySpan, StoryTable, Tone};

/// Writes a claim: by its name, or by words in its place.
type Link<'l> = &'l dyn Fn(&str, Option<&str>) -> String;

/// The text; `link` writes claims.
pub(in super::super) fn markdown(blocks: &[StoryBlock<'_>], link: Link<'_>) -> String {
    let mut out = String::new();
    put_all(blocks, 0, link, &mut out);
    out
}

/// Longest formula that stands in a line with others, in bytes of LaTeX.
const SHORT: usize = 90;

/// The anchor of a claim: what a forge makes of a heading is not the same everywhere.
pub(in super::super) fn anchor(name: &str) -> String {
    format!("claim-{}", name.replace('/', "--"))
}

/// Blocks, one below the other; short formulas stand in one line, behind a sentence that leads to them.
fn put_all(blocks: &[StoryBlock<'_>], indent: usize, link: Link<'_>, out: &mut String) {
    let mut is_open = false;
    for (at, block) in blocks.iter().enumerate() {
        let is_short = |b: Option<&StoryBlock<'_>>| matches!(b, Some(StoryBlock::Formula(text, _)) if text.len() <= SHORT && !text.contains('\n'));
        let leads = |line: &str| line.ends_with(':') && is_short(blocks.get(at + 1));
        match block {
            StoryBlock::Formula(text, _) if is_short(Some(block)) => {
                out.push_str(&format!("{}{}", " ".repeat(if is_open { 0 } else { indent }), math(text)));
                is_open = is_short(blocks.get(at + 1));
                out.push_str(if is_open { ", " } else { "\n\n" });
            }
            StoryBlock::Paragraph(spans) if leads(&line(spans, link)) => {
                out.push_str(&format!("{}{} ", " ".repeat(indent), line(spans, link)));
                is_open = true;
            }
            block => put(block, indent, link, out),
        }
    }
}

fn put(block: &StoryBlock<'_>, indent: usize, link: Link<'_>, out: &mut String) {
    let space = " ".repeat(indent);
    let paragraph = |spans: &[StorySpan<'_>]| match line(spans, link) {
        text if text.is_empty() => text,
        text => format!("{space}{text}\n\n"),
    };
    match block {
        StoryBlock::Heading(text) => out.push_str(&format!("{space}**{}**\n\n", prose(text))),
        StoryBlock::Part(of) => {
            if !of.place.is_empty() && !of.place.starts_with('/') {
                out.push_str(&format!("<a id=\"{}\"></a>\n\n", anchor(&of.place)));
            }
            let lead = match of.level {
                PartLevel::Section => "## ",
                PartLevel::Subsection => "### ",
                PartLevel::Family | PartLevel::Claim => "#### ",
                PartLevel::Reading => "",
            };
            out.push_str(&format!("{lead}{}\n\n", line(&of.title, link)));
            put_all(&of.blocks, indent, link, out);
        }
        StoryBlock::Paragraph(spans) => out.push_str(&paragraph(spans)),
        StoryBlock::Formula(text, _) => out.push_str(&display(text)),
        StoryBlock::Lines(text, kind) => {
            out.push_str(&fenced(if kind.is_empty() { "text" } else { kind }, text.trim_end()))
        }
        StoryBlock::Table(of) => out.push_str(&table(of, link)),
        StoryBlock::List(items) => {
            items.iter().for_each(|item| put_item(item, indent, link, out));
            out.push('\n');
        }
        StoryBlock::Fold(StoryFold { title, elsewhere, blocks, .. }) => match elsewhere {
            Elsewhere::Line(words) => out.push_str(&paragraph(words)),
            Elsewhere::Titled => {
                out.push_str(&paragraph(title));
                put_all(blocks, indent, link, out);
            }
            Elsewhere::Inside => {
                let mut inside = String::new();
                put_all(blocks, indent, link, &mut inside);
                out.push_str(&format!(
                    "{space}<details><summary>{}</summary>\n\n{inside}{space}</details>\n\n",
                    line(title, link)
                ));
            }
        },
        StoryBlock::Embedded(_) | StoryBlock::Group("page" | "paper", _) => {}
        StoryBlock::Figure(sketch, caption) => {
            let lines = sketch.lines();
            if !lines.is_empty() {
                let body: String = lines.iter().map(|l| format!("{space}{l}\n")).collect();
                out.push_str(&format!("{space}```text\n{body}{space}```\n\n"));
                out.push_str(&paragraph(caption));
            }
        }
        StoryBlock::Group(_, blocks) => put_all(blocks, indent, link, out),
    }
}

fn put_item(item: &StoryItem<'_>, indent: usize, link: Link<'_>, out: &mut String) {
    let numbered = item.mark.strip_suffix('.').filter(|n| n.parse::<usize>().is_ok());
    let (mark, lead) = match numbered {
        Some(n) => (format!("{n}."), String::new()),
        None if item.mark.is_empty() => ("-".to_owned(), String::new()),
        None => ("-".to_owned(), format!("**{}** ", prose(&item.mark))),
    };
    out.push_str(&format!("{}{mark} {lead}{}\n", " ".repeat(indent), line(&item.line, link)));
    if !item.below.is_empty() {
        let deeper = indent + mark.len() + 1;
        out.push('\n');
        put_all(&item.below, deeper, link, out);
    }
}

fn line(spans: &[StorySpan<'_>], link: Link<'_>) -> String {
    let mut out = String::new();
    spans.iter().for_each(|s| append(&mut out, &span(s, link)));
    out.trim().to_owned()
}

/// A text between marks, its spaces outside of them.
fn marked(text: &str, tone: Tone) -> String {
    let inner = text.trim();
    let mark = match tone {
        Tone::Plain | Tone::Quiet | Tone::Good | Tone::Open => "",
        Tone::Strong | Tone::Bad | Tone::Alarm => "**",
    };
    let at = text.len() - text.trim_start().len();
    let end = text.trim_end().len();
    if inner.is_empty() || mark.is_empty() {
        return text.to_owned();
    }
    format!("{}{mark}{inner}{mark}{}", &text[..at], &text[end..])
}

/// A text of which the spaces at its ends are kept.
fn kept(text: &str) -> String {
    let before = if text.starts_with(char::is_whitespace) { " " } else { "" };
    let after = if text.ends_with(char::is_whitespace) && !text.trim().is_empty() { " " } else { "" };
    format!("{before}{}{after}", prose(text))
}

fn span(span: &StorySpan<'_>, link: Link<'_>) -> String {
    match span {
        StorySpan::Words(text, tone) | StorySpan::Prose(text, _, tone) => marked(&kept(text), *tone),
        StorySpan::Reason(text, _) => kept(text),
        StorySpan::File(name) => format!("[{}](./{name})", prose(name)),
        StorySpan::Math(formula, _) | StorySpan::Marked { formula, .. } => prose(&format!("${}$", formula.trim())),
        StorySpan::Claim(name, tone) => marked(&link(name, None), *tone),
        StorySpan::Said { claim, text, tone, .. } => marked(&link(claim, Some(&prose(text))), *tone),
        StorySpan::Section(text, _) => prose(text),
        StorySpan::Code(text) | StorySpan::Difference(text) => code(text),
        StorySpan::Comparison(text, _) => {
            let of = label(text);
            let component = of.component.map(|c| format!(" (component {})", math(c))).unwrap_or_default();
            format!("{}{}{}{component}", of.before, math(of.formula), of.after)
        }
        StorySpan::Shape(shape) => shape.sign().to_owned(),
        StorySpan::Roomy(inside) => {
            let mut out = String::new();
            inside.iter().for_each(|s| append(&mut out, &self::span(s, link)));
            out
        }
    }
}

fn table(of: &StoryTable<'_>, link: Link<'_>) -> String {
    let cell = |spans: &Vec<StorySpan<'_>>| line(spans, link);
    let row = |cells: &[Vec<StorySpan<'_>>]| {
        let told = |text: String| if text.is_empty() { " |".to_owned() } else { format!(" {text} |") };
        format!("|{}\n", cells.iter().map(cell).map(told).collect::<String>())
    };
    let mut out = format!("{}|{}\n", row(&of.head), "---|".repeat(of.head.len()));
    of.rows.iter().for_each(|cells| out.push_str(&row(cells)));
    out.push('\n');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_stand_at_words_and_formulas_stay_formulas() {
        assert_eq!(marked(" a b ", Tone::Bad), " **a b** ");
        assert_eq!(marked(" ", Tone::Strong), " ");
        assert_eq!(kept("where $x|y$, "), r"where $`x\vert y`$, ");
    }
}
