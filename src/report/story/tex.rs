//! A story as LaTeX source.

use super::super::tex::{escaped, inline, prose};
use super::{StoryBlock, StoryItem, StorySpan, StoryTable, Tone};

/// The source, without a preamble.
pub(in super::super) fn tex(blocks: &[StoryBlock<'_>]) -> String {
    let mut out = String::new();
    blocks.iter().for_each(|b| put(b, &mut out));
    out
}

fn put(block: &StoryBlock<'_>, out: &mut String) {
    match block {
        StoryBlock::Heading(text) => out.push_str(&format!("\\textbf{{{}}}\\nopagebreak\n\n", escaped(text))),
        StoryBlock::Paragraph(spans) => out.push_str(&format!("{}\n\n", line(spans))),
        StoryBlock::Table(of) => out.push_str(&table(of)),
        StoryBlock::List(items) if items.is_empty() => {}
        StoryBlock::List(items) => {
            out.push_str("\\begin{itemize}\\setlength{\\itemsep}{1pt}\\setlength{\\parskip}{0pt}\n");
            items.iter().for_each(|item| put_item(item, out));
            out.push_str("\\end{itemize}\n\n");
        }
        StoryBlock::Fold { unfolded: Some(line), .. } => out.push_str(&format!("{}\n\n", escaped(line))),
        StoryBlock::Fold { unfolded: None, blocks, .. } => blocks.iter().for_each(|b| put(b, out)),
        // A drawing of a few lines is for a screen; what it shows is in words beside it.
        StoryBlock::Figure(..) => {}
        StoryBlock::Group("roomy", _) => {}
        // The rest of a remark is on the page.
        StoryBlock::Group("remark", blocks) => blocks.iter().take(1).for_each(|b| put(b, out)),
        StoryBlock::Group(_, blocks) => blocks.iter().for_each(|b| put(b, out)),
    }
}

fn put_item(item: &StoryItem<'_>, out: &mut String) {
    let mark = if item.mark.is_empty() { String::new() } else { format!("[{}]", escaped(&item.mark)) };
    out.push_str(&format!("\\item{mark} {}\n\n", line(&item.line)));
    item.below.iter().for_each(|b| put(b, out));
}

fn line(spans: &[StorySpan<'_>]) -> String {
    spans.iter().map(span).collect::<String>().trim().to_owned()
}

fn marked(text: String, tone: Tone) -> String {
    match tone {
        Tone::Plain | Tone::Good | Tone::Open => text,
        Tone::Strong | Tone::Bad | Tone::Alarm => format!("\\textbf{{{text}}}"),
        Tone::Quiet => format!("{{\\small {text}}}"),
    }
}

fn span(span: &StorySpan<'_>) -> String {
    match span {
        StorySpan::Words(text, tone) => marked(escaped(text), *tone),
        StorySpan::Prose(text, scope, tone) => marked(prose(text, scope), *tone),
        StorySpan::Math(formula, scope) | StorySpan::Marked { formula, scope, .. } => inline(formula, scope),
        StorySpan::Claim(name, tone) => marked(escaped(name), *tone),
        StorySpan::Section(text, _) => escaped(text),
        StorySpan::Code(text) => format!("\\texttt{{{}}}", escaped(text)),
        StorySpan::Shape(shape) => shape.row().2.to_owned(),
    }
}

fn table(of: &StoryTable<'_>) -> String {
    let row = |cells: &[Vec<StorySpan<'_>>]| {
        format!("{}\\\\\n", cells.iter().map(|c| line(c)).collect::<Vec<_>>().join(" & "))
    };
    let columns = "c".repeat(of.head.len().saturating_sub(1));
    let mut out = format!("\\begin{{tabular}}{{l{columns}}}\n{}\\hline\n", row(&of.head));
    of.rows.iter().for_each(|cells| out.push_str(&row(cells)));
    out.push_str("\\end{tabular}\n\n");
    out
}
