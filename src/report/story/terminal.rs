//! A story for a terminal: at most a hundred letters wide, readable without colour.

use super::super::numbers::retold;
use super::super::plain::plain as plain_formula;
use super::super::text::{Paint, fitted, width as columns};
use super::super::wording::{self, Part};
use super::{Elsewhere, StoryBlock, StoryFold, StoryItem, StorySpan, StoryTable, Tone, joined};

/// Widest head of a row of a table.
const HEAD: usize = 44;

/// The text, with escape codes if `paint` has colours.
pub(in super::super) fn terminal(blocks: &[StoryBlock<'_>], indent: usize, paint: Paint) -> String {
    let mut out = String::new();
    put_all(blocks, indent, paint, &mut out);
    out
}

/// Blocks, one below the other; what is a sentence stands behind its heading.
fn put_all(blocks: &[StoryBlock<'_>], indent: usize, paint: Paint, out: &mut String) {
    let mut all = blocks.iter().peekable();
    while let Some(block) = all.next() {
        match (block, all.peek()) {
            (StoryBlock::Heading(text), Some(StoryBlock::Paragraph(spans))) => {
                all.next();
                let lead = [StorySpan::Words(format!("{text}: "), Tone::Strong)];
                let line: Vec<StorySpan<'_>> = lead.into_iter().chain(spans.iter().cloned()).collect();
                out.push_str(&lines(&line, indent, indent, paint));
            }
            // So does the first line of the one card below a heading.
            (StoryBlock::Heading(text), Some(StoryBlock::Group("card", card))) if is_one_card(blocks) => {
                let Some((StoryBlock::Paragraph(spans), below)) = card.split_first() else {
                    put(block, indent, paint, out);
                    continue;
                };
                all.next();
                let lead = [StorySpan::Words(format!("{text}: "), Tone::Strong)];
                let line: Vec<StorySpan<'_>> = lead.into_iter().chain(spans.iter().cloned()).collect();
                out.push_str(&lines(&line, indent, indent, paint));
                below.iter().for_each(|b| put(b, indent + 3, paint, out));
            }
            _ => put(block, indent, paint, out),
        }
    }
}

/// Whether one of these blocks is a card, and no more.
fn is_one_card(blocks: &[StoryBlock<'_>]) -> bool {
    blocks.iter().filter(|b| matches!(b, StoryBlock::Group("card", _))).count() == 1
}

fn put(block: &StoryBlock<'_>, indent: usize, paint: Paint, out: &mut String) {
    match block {
        StoryBlock::Heading(text) => out.push_str(&format!("{}\n", paint.bold(text))),
        StoryBlock::Paragraph(spans) => out.push_str(&lines(spans, indent, indent, paint)),
        StoryBlock::Table(of) => out.push_str(&table(of, paint)),
        StoryBlock::List(items) => items.iter().for_each(|item| put_item(item, indent, paint, out)),
        StoryBlock::Part(of) => {
            out.push_str(&lines(&of.title, indent, indent, paint));
            put_all(&of.blocks, indent + 2, paint, out);
            out.push('\n');
        }
        StoryBlock::Formula(text, _) => {
            let line = StorySpan::Words(wording::one_line(text), Tone::Plain);
            out.push_str(&lines(&[line], indent + 2, indent + 4, paint));
        }
        StoryBlock::Lines(text, _) => {
            text.lines().for_each(|line| out.push_str(&format!("{}{line}\n", " ".repeat(indent))));
        }
        StoryBlock::Embedded(_) | StoryBlock::Group("page" | "paper", _) => {}
        StoryBlock::Fold(StoryFold { title, elsewhere, blocks, .. }) => match elsewhere {
            Elsewhere::Line(words) if words.is_empty() => {}
            Elsewhere::Line(words) => out.push_str(&lines(words, indent, indent, paint)),
            Elsewhere::Titled => {
                out.push_str(&lines(title, indent, indent, paint));
                put_all(blocks, indent, paint, out);
            }
            Elsewhere::Inside => put_all(blocks, indent, paint, out),
        },
        StoryBlock::Figure(sketch, _) => {
            for line in sketch.lines() {
                out.push_str(&format!("{}{line}\n", " ".repeat(indent)));
            }
        }
        StoryBlock::Group("roomy", _) => {}
        // Of a remark the first sentences are shown; the rest is on the page.
        StoryBlock::Group("remark", blocks) => blocks.iter().take(1).for_each(|b| put(b, indent, paint, out)),
        StoryBlock::Group("keys", blocks) => blocks.iter().for_each(|b| match b {
            StoryBlock::List(items) => put_in_line(items, indent + 1, paint, out),
            other => put(other, indent, paint, out),
        }),
        StoryBlock::Group("card", blocks) => {
            // Below its first line a card stands deeper: there is no frame.
            blocks.iter().enumerate().for_each(|(at, b)| put(b, indent + if at > 0 { 3 } else { 0 }, paint, out));
        }
        StoryBlock::Group(_, blocks) => put_all(blocks, indent, paint, out),
    }
}

/// Short items, one behind the other.
fn put_in_line(items: &[StoryItem<'_>], indent: usize, paint: Paint, out: &mut String) {
    let item = |item: &StoryItem<'_>| -> Vec<StorySpan<'static>> {
        let line = plain(&item.line);
        vec![StorySpan::Words(format!("{} ", item.mark), Tone::Strong), StorySpan::Words(line, Tone::Plain)]
    };
    out.push_str(&lines(&joined(items.iter().map(item), "; "), indent, indent, paint));
}

fn put_item(item: &StoryItem<'_>, indent: usize, paint: Paint, out: &mut String) {
    let mark = if item.mark.is_empty() { "-" } else { &item.mark };
    let deeper = indent + mark.chars().count() + 2;
    let text = lines(&item.line, deeper, deeper, paint);
    out.push_str(&format!("{}{mark} ", " ".repeat(indent + 1)));
    out.push_str(text.get(deeper..).unwrap_or_default());
    item.below.iter().for_each(|b| put(b, deeper, paint, out));
}

/// A text of the file, its formulas as plain text.
fn prose(text: &str) -> String {
    let part = |part| match part {
        Part::Words(words) => retold(&words.replace('$', "")),
        Part::Formula(formula) => plain_formula(formula),
    };
    wording::parts(text).into_iter().map(part).collect()
}

fn text(span: &StorySpan<'_>) -> (String, Tone) {
    match span {
        StorySpan::Words(text, tone) => (text.clone(), *tone),
        StorySpan::Prose(text, _, tone) | StorySpan::Said { text, tone, .. } => (prose(text), *tone),
        StorySpan::Reason(text, _) => (prose(text), Tone::Plain),
        StorySpan::Math(formula, _) => (plain_formula(formula), Tone::Plain),
        StorySpan::Marked { formula, wrong, .. } => {
            (plain_formula(formula), if *wrong { Tone::Bad } else { Tone::Good })
        }
        StorySpan::Claim(name, tone) => (name.clone(), *tone),
        StorySpan::Section(text, _)
        | StorySpan::Code(text)
        | StorySpan::Difference(text)
        | StorySpan::File(text)
        | StorySpan::Comparison(text, _) => (text.clone(), Tone::Plain),
        StorySpan::Shape(shape) => (shape.sign().to_owned(), shape.tone()),
        StorySpan::Roomy(_) => (String::new(), Tone::Plain),
    }
}

fn painted(text: &str, tone: Tone, paint: Paint) -> String {
    match tone {
        Tone::Plain => text.to_owned(),
        Tone::Strong => paint.bold(text),
        Tone::Quiet => paint.faint(text),
        Tone::Good => paint.good(text),
        Tone::Bad => paint.bad(text),
        Tone::Open => paint.open(text),
        Tone::Alarm => paint.alarm(text),
    }
}

/// Spans laid out in lines: the first begins at `first`, the others at `further`.
fn lines(spans: &[StorySpan<'_>], first: usize, further: usize, paint: Paint) -> String {
    // A word is what stands between spaces; it may have parts of several spans.
    let mut all: Vec<Vec<(String, Tone)>> = vec![Vec::new()];
    for span in spans {
        let (text, tone) = text(span);
        for (i, part) in text.split(char::is_whitespace).enumerate() {
            if i > 0 && all.last().is_some_and(|w| !w.is_empty()) {
                all.push(Vec::new());
            }
            if let Some(word) = all.last_mut().filter(|_| !part.is_empty()) {
                word.push((part.to_owned(), tone));
            }
        }
    }
    let mut out = " ".repeat(first);
    let mut width = first;
    let mut fresh = true;
    for word in all.iter().filter(|w| !w.is_empty()) {
        let length: usize = word.iter().map(|(part, _)| part.chars().count()).sum();
        if !fresh && width + 1 + length > columns() {
            out.push('\n');
            out.push_str(&" ".repeat(further));
            (width, fresh) = (further, true);
        }
        if !fresh {
            out.push(' ');
            width += 1;
        }
        for (part, tone) in word {
            out.push_str(&painted(part, *tone, paint));
        }
        (width, fresh) = (width + length, false);
    }
    out.push('\n');
    out
}

fn plain(spans: &[StorySpan<'_>]) -> String {
    spans.iter().map(|s| text(s).0).collect::<String>().split_whitespace().collect::<Vec<_>>().join(" ")
}

fn table(of: &StoryTable<'_>, paint: Paint) -> String {
    let columns = of.head.len();
    let mut widths: Vec<usize> = of.head.iter().map(|h| plain(h).chars().count()).collect();
    for row in &of.rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(plain(cell).chars().count());
        }
    }
    if let Some(first) = widths.first_mut() {
        *first = (*first).min(HEAD);
    }
    let mut out = String::new();
    let head: Vec<String> = of.head.iter().zip(&widths).map(|(h, width)| fitted(&plain(h), *width)).collect();
    out.push_str(&paint.faint(format!("  {}", head.join("  ")).trim_end()));
    out.push('\n');
    for row in &of.rows {
        let mut line = String::from("  ");
        for (at, (cell, width)) in row.iter().zip(&widths).enumerate().take(columns) {
            let shown = plain(cell);
            let tone = cell.first().map_or(Tone::Plain, |s| text(s).1);
            let filled = fitted(&shown, *width);
            let (inner, space) = filled.split_at(filled.trim_end().len());
            line.push_str(&if at == 0 { inner.to_owned() } else { painted(inner, tone, paint) });
            line.push_str(&format!("{space}  "));
        }
        out.push_str(line.trim_end());
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::words;
    use super::*;

    #[test]
    fn words_of_several_spans_stay_together_and_lines_are_short() {
        let spans = [
            words("a "),
            StorySpan::Words("bold".into(), Tone::Strong),
            words(", and ".to_owned() + &"word ".repeat(60)),
        ];
        let text = lines(&spans, 2, 4, Paint(false));
        assert!(text.starts_with("  a bold, and word word"), "{text}");
        assert!(text.lines().skip(1).all(|l| l.starts_with("    word")) && text.lines().all(|l| l.len() <= columns()));
    }
}
