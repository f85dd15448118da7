//! Problems in what a user wrote, and how they are shown.
//!
//! **In:** a [`Problem`] at a place of one formula, or a place of a file. **Out:** a [`Diagnostic`], which knows its file,
//! and the text that a person reads: code, message, line and column, the line itself with a caret, and a hint.
//!
//! **Guaranteed:** no span makes the rendering panic: it is moved to the nearest characters of the text. Diagnostics have
//! one order, by file and place, so the same input always prints the same text. What it prints of files cannot act on a
//! terminal: see [`escape`].

#![forbid(unsafe_code)]

pub mod escape;
pub mod values;

use std::ops::Range;
use std::sync::Arc;

use crate::escape::{in_one_line, shown_with_places};
use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

/// A problem at a place in one text (a formula): the rooms that read formulas know nothing of files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Stable name, `room::kind`, for instance `latex::unknown-symbol`.
    pub code: &'static str,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// Byte range in the text.
    pub span: Range<usize>,
    /// How to write it.
    pub hint: Option<String>,
}

/// A file as it was read.
#[derive(Debug, PartialEq, Eq)]
pub struct Source {
    /// Its path, as the user gave it.
    pub path: String,
    /// Its text.
    pub text: String,
}

/// A place in a file, with a few words on what is there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Byte range in the file.
    pub span: Range<usize>,
    /// Shown beside the caret; may be empty.
    pub text: String,
}

/// A problem in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Stable name, `room::kind`.
    pub code: &'static str,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// The file; its text is empty where it could not be read.
    pub source: Arc<Source>,
    /// Where; `None` when the whole file is meant.
    pub place: Option<Label>,
    /// Another place that the problem has to do with, such as the first of two equal ids.
    pub other: Option<Label>,
    /// What to do about it.
    pub hint: Option<String>,
}

impl Diagnostic {
    /// A problem at a place of a file.
    pub fn at(source: &Arc<Source>, code: &'static str, span: Range<usize>, message: impl Into<String>) -> Diagnostic {
        let place = Some(Label { span, text: String::new() });
        Diagnostic { code, message: message.into(), source: Arc::clone(source), place, other: None, hint: None }
    }

    /// A problem of a file as a whole.
    pub fn of_file(path: &str, code: &'static str, message: impl Into<String>) -> Diagnostic {
        let source = Arc::new(Source { path: path.to_owned(), text: String::new() });
        Diagnostic { code, message: message.into(), source, place: None, other: None, hint: None }
    }

    /// A problem of a formula that begins at byte `start` of the file and is written there without escapes.
    pub fn of_formula(source: &Arc<Source>, start: usize, problem: Problem) -> Diagnostic {
        let span = start.saturating_add(problem.span.start)..start.saturating_add(problem.span.end);
        Diagnostic { hint: problem.hint, ..Diagnostic::at(source, problem.code, span, problem.message) }
    }

    /// The same with a hint.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Diagnostic {
        self.hint = Some(hint.into());
        self
    }

    /// The same with a second place.
    #[must_use]
    pub fn see(mut self, span: Range<usize>, text: impl Into<String>) -> Diagnostic {
        self.other = Some(Label { span, text: text.into() });
        self
    }

    /// Line and column of the place, both counted from 1, the column in characters.
    pub fn line_and_column(&self) -> Option<(usize, usize)> {
        let label = self.place.as_ref()?;
        let start = clamp(&self.source.text, &label.span).start;
        let before = &self.source.text[..start];
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        Some((before.matches('\n').count() + 1, before[line_start..].chars().count() + 1))
    }

    /// What decides the order of diagnostics.
    fn key(&self) -> (&str, usize, usize, &str, &str) {
        let span = self.place.as_ref().map_or(0..0, |l| l.span.clone());
        (&self.source.path, span.start, span.end, self.code, &self.message)
    }
}

/// As a person reads it, with the line and a caret.
impl std::fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&render_one(self, &renderer(false)))
    }
}

/// Sorts by file and place, and drops what is said twice.
pub fn sort(diagnostics: &mut Vec<Diagnostic>) {
    diagnostics.sort_by(|a, b| a.key().cmp(&b.key()));
    diagnostics.dedup();
}

/// The most diagnostics that [`render`] shows in full.
pub const SHOWN: usize = 50;

/// The text that a person reads: each diagnostic, then how many there are. With `colour`, escape codes are used.
pub fn render(diagnostics: &[Diagnostic], colour: bool) -> String {
    let renderer = renderer(colour);
    let mut out = String::new();
    for diagnostic in diagnostics.iter().take(SHOWN) {
        out.push_str(&render_one(diagnostic, &renderer));
        out.push_str("\n\n");
    }
    if diagnostics.len() > SHOWN {
        out.push_str(&format!("… and {} more\n\n", diagnostics.len() - SHOWN));
    }
    out.push_str(&match diagnostics.len() {
        1 => "1 problem found\n".to_owned(),
        n => format!("{n} problems found\n"),
    });
    out
}

fn renderer(colour: bool) -> Renderer {
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    renderer.decor_style(DecorStyle::Ascii).term_width(120)
}

fn render_one(diagnostic: &Diagnostic, renderer: &Renderer) -> String {
    let text = &diagnostic.source.text;
    // Files are quoted as they are: nothing of them may act here.
    let (message, path) = (in_one_line(&diagnostic.message), in_one_line(&diagnostic.source.path));
    let hint = diagnostic.hint.as_deref().map(in_one_line);
    let words = |l: &Label| in_one_line(&l.text);
    let (label_words, other_words) = (
        diagnostic.place.as_ref().map(words).unwrap_or_default(),
        diagnostic.other.as_ref().map(words).unwrap_or_default(),
    );
    let source;
    let title = Level::ERROR.primary_title(message.as_str()).id(diagnostic.code);
    let mut group: Group<'_> = match &diagnostic.place {
        None => title.element(Origin::path(path.as_str())),
        Some(label) => {
            let place = clamp(text, &label.span);
            let other = diagnostic.other.as_ref().map(|l| (clamp(text, &l.span), other_words.as_str()));
            // Only the lines that are shown are given to the renderer: it scans all it gets, and files may be large.
            let first = other.as_ref().map_or(place.start, |(o, _)| o.start.min(place.start));
            let last = other.as_ref().map_or(place.end, |(o, _)| o.end.max(place.end));
            let from = text[..first].rfind('\n').map_or(0, |i| i + 1);
            let to = text[last..].find('\n').map_or(text.len(), |i| last + i);
            let (lines, moved) = shown_with_places(&text[from..to]);
            source = lines;
            let within = |r: &Range<usize>| moved(r.start - from)..moved(r.end - from);
            let line = text[..from].matches('\n').count() + 1;
            let mut snippet = Snippet::source(source.as_str())
                .line_start(line)
                .annotation(AnnotationKind::Primary.span(within(&place)).label(label_words.as_str()));
            if let Some((span, words)) = &other {
                snippet = snippet.annotation(AnnotationKind::Context.span(within(span)).label(*words));
            }
            // A sign that is written out moves what stands behind it: the column is that of the file.
            let begin = text[..place.start].rfind('\n').map_or(0, |i| i + 1);
            let is_moved = shown_with_places(&text[begin..place.start]).0 != text[begin..place.start];
            match diagnostic.line_and_column().filter(|_| is_moved) {
                Some((line, column)) => {
                    title.element(Origin::path(path.as_str()).line(line).char_column(column)).element(snippet)
                }
                None => title.element(snippet.path(path.as_str())),
            }
        }
    };
    if let Some(hint) = &hint {
        group = group.element(Level::HELP.with_name("hint").message(hint.as_str()));
    }
    renderer.render(&[group])
}

/// The first place, this one or behind it, at which a character begins; or the end of the text.
pub fn next_character(text: &str, mut at: usize) -> usize {
    while at < text.len() && !text.is_char_boundary(at) {
        at += 1;
    }
    at.min(text.len())
}

/// The nearest range of whole characters inside the text.
fn clamp(text: &str, span: &Range<usize>) -> Range<usize> {
    let boundary = |mut i: usize| {
        i = i.min(text.len());
        while !text.is_char_boundary(i) {
            i -= 1;
        }
        i
    };
    let start = boundary(span.start);
    start..boundary(span.end).max(start)
}

/// The known word that is nearest to `word`, if one is near enough to be meant.
///
/// Near: at most a third of the longer word's letters inserted, deleted, changed or exchanged with their neighbour.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let (d, best) = known.into_iter().map(|k| (distance(word, k), k)).min()?;
    (d * 3 <= word.chars().count().max(best.chars().count()) && d > 0).then_some(best)
}

/// Edit distance with exchanges of neighbours (optimal string alignment).
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(64).collect(), b.chars().take(64).collect());
    let mut rows = [vec![0; b.len() + 1], (0..=b.len()).collect::<Vec<usize>>(), vec![0; b.len() + 1]];
    for i in 1..=a.len() {
        rows[2][0] = i;
        for j in 1..=b.len() {
            let change = usize::from(a[i - 1] != b[j - 1]);
            let mut d = (rows[1][j] + 1).min(rows[2][j - 1] + 1).min(rows[1][j - 1] + change);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                d = d.min(rows[0][j - 2] + 1);
            }
            rows[2][j] = d;
        }
        rows.rotate_left(1);
    }
    rows[1][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(text: &str) -> Arc<Source> {
        Arc::new(Source { path: "derivations/pendulum.toml".into(), text: text.into() })
    }

    #[test]
    fn a_problem_of_a_formula_is_shown_in_its_line() {
        let text = "[symbols]\n\nformula = '\\tfrac12 \\omega^2 - \\cos q'\n";
        let problem = Problem {
            code: "latex::unknown-symbol",
            message: "`\\omega` is not declared".into(),
            span: 9..15,
            hint: Some("declare it under [symbols], or did you mean `\\Omega`?".into()),
        };
        let diagnostic = Diagnostic::of_formula(&source(text), 22, problem);
        assert_eq!(diagnostic.line_and_column(), Some((3, 21)));
        insta::assert_snapshot!(render(&[diagnostic], false), @r"
        error[latex::unknown-symbol]: `\omega` is not declared
         --> derivations/pendulum.toml:3:21
          |
        3 | formula = '\tfrac12 \omega^2 - \cos q'
          |                     ^^^^^^
          |
          = hint: declare it under [symbols], or did you mean `\Omega`?

        1 problem found
        ");
    }

    #[test]
    fn columns_are_those_of_the_file() {
        for before in ["a", "\u{202e}", "\t\u{1b}\u{ad}é", "𝒳\u{301}\u{200b}"] {
            let text = format!("x\n{before}ψ = b\ny");
            let at = text.find('ψ').expect("there");
            let diagnostic = Diagnostic::at(&source(&text), "x::y", at..at + 2, "m");
            let column = before.chars().count() + 1;
            assert_eq!(diagnostic.line_and_column(), Some((2, column)));
            let shown = diagnostic.to_string();
            assert!(shown.contains(&format!("derivations/pendulum.toml:2:{column}\n")), "{shown}");
            assert!(shown.contains("2 | ") && shown.contains('^'), "{shown}");
        }
    }

    #[test]
    fn no_span_panics() {
        let text = "é = 'ψ'\nnext";
        for start in 0..text.len() + 3 {
            for end in 0..text.len() + 3 {
                let d = Diagnostic::at(&source(text), "x::y", start..end, "m").see(end..start, "there");
                assert!(render(&[d], true).contains("x::y"), "{start}..{end}");
            }
        }
        let empty = Diagnostic::at(&source(""), "x::y", 0..0, "m");
        assert!(render(&[empty], false).contains("x::y"));
    }

    #[test]
    fn nearest_finds_slips_and_nothing_else() {
        let known = ["assuming", "always", "never", "eventually", "expect"];
        assert_eq!(nearest("asuming", known), Some("assuming"));
        assert_eq!(nearest("expcet", known), Some("expect"));
        assert_eq!(nearest("colour", known), None);
    }

    #[test]
    fn many_problems_are_counted_not_all_shown() {
        let s = source("a\n");
        let all: Vec<_> = (0..80).map(|i| Diagnostic::at(&s, "x::y", 0..1, format!("m{i:02}"))).collect();
        let text = render(&all, false);
        assert!(text.contains("m49") && !text.contains("m50") && text.contains("… and 30 more"));
        assert!(text.ends_with("80 problems found\n"));
    }
}
