//! A story as LaTeX source.

use super::super::latex_text::{display, escaped, inline, label, prose};
use super::{Elsewhere, PartLevel, StoryBlock, StoryFold, StoryItem, StorySpan, StoryTable, TableCells, Tone};

/// The source, without a preamble.
pub(in super::super) fn tex(blocks: &[StoryBlock<'_>]) -> String {
    let mut out = String::new();
    put_all(blocks, &mut out);
    out
}

fn put_all(blocks: &[StoryBlock<'_>], out: &mut String) {
    blocks.iter().for_each(|b| put(b, out));
}

fn paragraph(spans: &[StorySpan<'_>], out: &mut String) {
    let text = line(spans);
    if !text.is_empty() {
        out.push_str(&format!("{text}\n\n"));
    }
}

fn put(block: &StoryBlock<'_>, out: &mut String) {
    match block {
        StoryBlock::Heading(text) => out.push_str(&format!("\\textbf{{{}}}\\nopagebreak\n\n", escaped(text))),
        StoryBlock::Part(of) => {
            let title = line(&of.title);
            out.push_str(&match of.level {
                PartLevel::Section => format!("\\subsection*{{{title}}}\n\n"),
                PartLevel::Subsection => format!("\\subsubsection*{{{title}}}\n\n"),
                PartLevel::Family | PartLevel::Claim => format!("\\medskip\n\\textbf{{{title}}}\\nopagebreak\n\n"),
                PartLevel::Reading => format!("{title}\\nopagebreak\n\n"),
            });
            put_all(&of.blocks, out);
        }
        StoryBlock::Paragraph(spans) => paragraph(spans, out),
        StoryBlock::Formula(text, scope) => out.push_str(&format!("{}\n", display(text, scope))),
        StoryBlock::Lines(text, _) => {
            let line = |l: &str| format!("\\texttt{{{}}}\\\\\n", escaped(l).replace(' ', "~"));
            let lines: String = text.lines().map(line).collect();
            out.push_str(&format!("{{\\tiny\\noindent\n{lines}}}\n\n"));
        }
        StoryBlock::Table(of) => out.push_str(&table(of)),
        StoryBlock::List(items) if items.is_empty() => {}
        StoryBlock::List(items) => {
            out.push_str("\\begin{itemize}\\setlength{\\itemsep}{1pt}\\setlength{\\parskip}{0pt}\n");
            items.iter().for_each(|item| put_item(item, out));
            out.push_str("\\end{itemize}\n\n");
        }
        StoryBlock::Fold(StoryFold { title, elsewhere, blocks, .. }) => match elsewhere {
            Elsewhere::Line(words) => paragraph(words, out),
            Elsewhere::Titled => {
                paragraph(title, out);
                put_all(blocks, out);
            }
            Elsewhere::Inside => put_all(blocks, out),
        },
        // A drawing of a few lines is for a screen; what it shows is in words beside it.
        StoryBlock::Figure(..) | StoryBlock::Embedded(_) => {}
        StoryBlock::Group("roomy" | "page", _) => {}
        // The rest of a remark is on the page.
        StoryBlock::Group("remark", blocks) => put_all(blocks.get(..1).unwrap_or_default(), out),
        StoryBlock::Group(_, blocks) => put_all(blocks, out),
    }
}

fn put_item(item: &StoryItem<'_>, out: &mut String) {
    // In braces: the first closing bracket would end it.
    let mark = if item.mark.is_empty() { String::new() } else { format!("[{{{}}}]", escaped(&item.mark)) };
    out.push_str(&format!("\\item{mark} {}\n\n", no_argument(line(&item.line))));
    put_all(&item.below, out);
}

/// A text that a command before it does not take for its argument: the end of a row, and an item, look for one.
fn no_argument(text: String) -> String {
    if text.trim_start().starts_with(['[', '*']) { format!("{{}}{text}") } else { text }
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
        StorySpan::Prose(text, scope, tone) | StorySpan::Said { text, scope, tone, .. } => {
            marked(prose(text, scope), *tone)
        }
        StorySpan::Reason(text, scope) => prose(text, scope),
        StorySpan::Math(formula, scope) | StorySpan::Marked { formula, scope, .. } => inline(formula, scope),
        StorySpan::Claim(name, tone) => marked(escaped(name), *tone),
        StorySpan::Section(text, _) => escaped(text),
        StorySpan::Code(text) | StorySpan::File(text) => format!("\\texttt{{{}}}", escaped(text)),
        StorySpan::Difference(_) => String::new(),
        StorySpan::Comparison(text, scope) => label(text, scope),
        StorySpan::Shape(shape) => shape.row().2.to_owned(),
        StorySpan::Roomy(inside) => inside.iter().map(self::span).collect(),
    }
}

fn table(of: &StoryTable<'_>) -> String {
    let row = |cells: &[Vec<StorySpan<'_>>]| {
        format!("{}\\\\\n", no_argument(cells.iter().map(|c| line(c)).collect::<Vec<_>>().join(" & ")))
    };
    let rows: String = of.rows.iter().map(|cells| row(cells)).collect();
    if of.cells == TableCells::Symbols {
        let columns = "c".repeat(of.head.len().saturating_sub(1));
        return format!("\\begin{{tabular}}{{l{columns}}}\n{}\\hline\n{rows}\\end{{tabular}}\n\n", row(&of.head));
    }
    let columns: String = widths(of).iter().map(|share| format!("p{{{share:.2}\\linewidth}}")).collect();
    format!("\\begin{{longtable}}{{{columns}}}\n{}\\hline\n\\endhead\n{rows}\\end{{longtable}}\n\n", row(&of.head))
}

/// Shares of the line for the columns of a table of texts, by the longest text of each.
fn widths(of: &StoryTable<'_>) -> Vec<f64> {
    let longest = |at: usize| {
        let cells = of.rows.iter().chain([&of.head]).filter_map(|row| row.get(at));
        cells.map(|cell| line(cell).len()).max().unwrap_or_default().clamp(6, 40)
    };
    let all: Vec<f64> = (0..of.head.len()).map(|at| longest(at) as f64).collect();
    let (sum, room) = (all.iter().sum::<f64>(), 1.0 - 0.04 * all.len() as f64);
    all.iter().map(|width| room * width / sum).collect()
}
