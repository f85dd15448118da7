//! A story as Markdown, as a forge renders it.

use super::super::markup::{code, prose};
use super::{StoryBlock, StoryItem, StorySpan, StoryTable, Tone};

/// The text; `link` writes the name of a claim.
pub(in super::super) fn markdown(blocks: &[StoryBlock<'_>], link: &dyn Fn(&str) -> String) -> String {
    let mut out = String::new();
    for block in blocks {
        put(block, 0, link, &mut out);
    }
    out
}

fn put(block: &StoryBlock<'_>, indent: usize, link: &dyn Fn(&str) -> String, out: &mut String) {
    let space = " ".repeat(indent);
    match block {
        StoryBlock::Heading(text) => out.push_str(&format!("{space}**{}**\n\n", prose(text))),
        StoryBlock::Paragraph(spans) => out.push_str(&format!("{space}{}\n\n", line(spans, link))),
        StoryBlock::Table(of) => out.push_str(&table(of, link)),
        StoryBlock::List(items) => {
            items.iter().for_each(|item| put_item(item, indent, link, out));
            out.push('\n');
        }
        StoryBlock::Fold { unfolded: Some(line), .. } if line.is_empty() => {}
        StoryBlock::Fold { unfolded: Some(line), .. } => out.push_str(&format!("{space}{}\n\n", prose(line))),
        StoryBlock::Fold { title, blocks, .. } => {
            let mut inside = String::new();
            blocks.iter().for_each(|b| put(b, indent, link, &mut inside));
            out.push_str(&format!(
                "{space}<details><summary>{}</summary>\n\n{inside}{space}</details>\n\n",
                prose(title)
            ));
        }
        StoryBlock::Figure(sketch, caption) => {
            let lines = sketch.lines();
            if !lines.is_empty() {
                let body: String = lines.iter().map(|l| format!("{space}{l}\n")).collect();
                out.push_str(&format!("{space}```text\n{body}{space}```\n\n"));
                if !caption.is_empty() {
                    out.push_str(&format!("{space}{}\n\n", line(caption, link)));
                }
            }
        }
        StoryBlock::Group(_, blocks) => blocks.iter().for_each(|b| put(b, indent, link, out)),
    }
}

fn put_item(item: &StoryItem<'_>, indent: usize, link: &dyn Fn(&str) -> String, out: &mut String) {
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
        item.below.iter().for_each(|b| put(b, deeper, link, out));
    }
}

fn line(spans: &[StorySpan<'_>], link: &dyn Fn(&str) -> String) -> String {
    spans.iter().map(|s| span(s, link)).collect::<String>().trim().to_owned()
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

fn span(span: &StorySpan<'_>, link: &dyn Fn(&str) -> String) -> String {
    match span {
        StorySpan::Words(text, tone) | StorySpan::Prose(text, _, tone) => marked(&kept(text), *tone),
        StorySpan::Math(formula, _) | StorySpan::Marked { formula, .. } => prose(&format!("${}$", formula.trim())),
        StorySpan::Claim(name, tone) => marked(&link(name), *tone),
        StorySpan::Section(text, _) => prose(text),
        StorySpan::Code(text) => code(text),
        StorySpan::Shape(shape) => shape.sign().to_owned(),
    }
}

fn table(of: &StoryTable<'_>, link: &dyn Fn(&str) -> String) -> String {
    let cell = |spans: &Vec<StorySpan<'_>>| line(spans, link);
    let row =
        |cells: &[Vec<StorySpan<'_>>]| format!("| {} |\n", cells.iter().map(cell).collect::<Vec<_>>().join(" | "));
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
