//! The LaTeX source of a paper: what it prints, and whether a derivation file says the same.
//!
//! **In:** the text of a paper, and a [`Derivation`](derivation::Derivation). **Out:** the displayed
//! [`equations`](Paper::equations) with their labels, and the formulas of the running text; from [`compare`], every formula
//! that names a label and differs from what is printed under it, and how much of the paper is covered.
//!
//! **Guaranteed:** two formulas are called the same only if LaTeX prints them alike, spacing and the size of brackets apart.
//! Macros of the paper are expanded; every place is one of the file as it was written. No text makes this panic.
//!
//! **Why this way:** nothing is *read* here in the sense of [`latex`]: what a formula means is a question to
//! the derivation file. That the file has copied the paper rightly is a question of signs on paper, and is answered with
//! signs.

#![forbid(unsafe_code)]

mod book;
mod chapter;
mod compare;
mod continued;
mod differences;
mod displays;
mod document;
mod draft;
mod environments;
mod fractions;
mod inputs;
mod kinds;
mod macros;
mod mark;
mod markdown;
mod named;
mod names;
mod note;
mod notebook;
mod opening;
mod pasted;
mod printed;
mod short;
mod takes;
mod texts;
mod token;
mod unicode;
mod upright;

use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use sha2::{Digest, Sha256};

pub use compare::{Comparison, Coverage, Difference, Relation, UnknownLabel, compare, subject};
pub use differences::DifferenceSigns;
pub use draft::{Draft, draft};
pub use kinds::is_markdown;
pub use names::{
    Call, Evidence, Notation, PaperName, cancels_by_order, is_variable, names, order_counts, squeezed, unprimed,
};
pub use note::PaperNote;
pub use opening::{Opening, opening};
pub use printed::{PrintedRelation, PrintedSide};
pub use texts::{LARGEST_PAPER, no_text, with_plain_ends};

use diag::escape::shown;
use diag::{Diagnostic, Source};
pub use document::Borders;
use document::Reader;
use environments::OwnEnvironments;
use files::Why;
use inputs::Inputs;
use kinds::FileKind;
use latex::Logarithm;
use macros::{Definitions, Doubts, Endless, Expanded};
use mark::{Mark, marks, text_of};
use texts::text_from;
use token::{Kind, Token};

/// The source of a paper.
#[derive(Clone, Debug)]
pub struct Paper {
    /// The file.
    pub file: Arc<Source>,
    /// SHA-256 of its bytes, in lower-case hexadecimal.
    pub sha256: String,
    /// The title, if there is one.
    pub title: Option<String>,
    /// Displayed equations, in the order of the paper.
    pub equations: Vec<Equation>,
    /// Formulas of the running text that relate two sides.
    pub relations: Vec<Part>,
    /// What the displays and the formulas of the running text print, as a reader sees it, in the order of the paper.
    pub printed: Vec<PrintedRelation>,
    /// Which signs of differences are something else somewhere.
    pub differences: DifferenceSigns,
    /// What could not be read as LaTeX means it: each with its place.
    pub notes: Vec<PaperNote>,
    /// Where examples, exercises and theorems begin.
    pub borders: Borders,
    /// What `\log` is, where somebody says it.
    pub logarithm: Option<Logarithm>,
    /// Files that the paper names, each with where its text begins when all are written behind each other.
    inputs: Vec<(usize, Arc<Source>)>,
    /// Where the lines of each file begin, the paper's own first.
    lines: Vec<Vec<usize>>,
}

impl Paper {
    /// The file in which a place lies, and the place in it: a paper may be written in several.
    pub fn locate(&self, span: &Range<usize>) -> (&Arc<Source>, Range<usize>) {
        let found = self.inputs.iter().rev().find(|(base, _)| *base <= span.start);
        match found {
            Some((base, source)) => {
                let end = span.end.saturating_sub(*base).min(source.text.len());
                let start = (span.start - base).min(end);
                (source, start..end)
            }
            None => {
                let end = span.end.min(self.file.text.len());
                (&self.file, span.start.min(end)..end)
            }
        }
    }

    /// The line of a place in its file, from 1.
    pub fn line(&self, span: &Range<usize>) -> usize {
        self.line_and_column(span).0
    }

    /// Line and column of a place in its file, both from 1, the column in characters.
    pub fn line_and_column(&self, span: &Range<usize>) -> (usize, usize) {
        let file = self.inputs.iter().rposition(|(base, _)| *base <= span.start).map_or(0, |at| at + 1);
        let (source, place) = self.locate(span);
        let line = self.lines.get(file).map_or(0, |starts| starts.partition_point(|s| *s <= place.start));
        let start = self.lines.get(file).and_then(|starts| starts.get(line.checked_sub(1)?)).copied().unwrap_or(0);
        let column = source.text.get(start..place.start).map_or(0, |t| t.chars().count()) + 1;
        (line.max(1), column)
    }
}

/// A displayed equation: what has one number in print.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Its label.
    pub label: Option<String>,
    /// Its place.
    pub span: Range<usize>,
    /// What it consists of, between commas and breaks of lines; never empty. A line that goes on from the one above with a sign of
    /// relation has the side before it, too.
    pub parts: Vec<Part>,
    /// Of such a line: the first side of the chain, and what it says.
    whole: Vec<Mark>,
}

/// A formula of the paper.
#[derive(Clone, Debug)]
pub struct Part {
    /// The formula with macros expanded.
    pub text: String,
    /// Its place in the file.
    pub span: Range<usize>,
    marks: Vec<Mark>,
}

impl Part {
    fn new(tokens: &[Token]) -> Part {
        let mut marks = marks(tokens);
        marks.shrink_to_fit();
        Part { text: shown(&text_of(tokens)).into_owned(), span: span_of(tokens), marks }
    }
}

/// From the first to the last place.
fn span_of(tokens: &[Token]) -> Range<usize> {
    let printed = tokens.iter().filter(|t| t.kind != Kind::Space && !t.span.is_empty());
    let start = printed.clone().map(|t| t.span.start).min().unwrap_or(0);
    start..printed.map(|t| t.span.end).max().unwrap_or(start)
}

/// Reads the source of a paper. A file that is not UTF-8 is taken as ISO 8859-1, as older papers are.
///
/// # Errors
/// The file cannot be read, is too large, or has macros that do not end.
pub fn read(path: &Path) -> Result<Paper, Box<Diagnostic>> {
    let shown = shown(&path.display().to_string()).into_owned();
    let refuse = |message: String| Box::new(Diagnostic::of_file(&shown, "paper::unreadable", message));
    let bytes = files::read(path, LARGEST_PAPER).map_err(|error| match error.why {
        Why::NotAFile(what) => refuse(format!("this is {what}, not a file")),
        why => refuse(format!("this file {why}")),
    })?;
    if let Some(refusal) = FileKind::refusal(&shown) {
        return Err(refusal);
    }
    if let Some(what) = no_text(&bytes) {
        return Err(refuse(format!("this file is {what}")));
    }
    let sha256 = Sha256::digest(&bytes).iter().map(|b| format!("{b:02x}")).collect();
    let definitions = definitions_of(&shown);
    parse_with(Arc::new(Source { path: shown, text: text_from(bytes) }), sha256, path.parent(), definitions)
}

/// Reads the text of a paper. Files that it names are not read.
///
/// # Errors
/// Macros that do not end.
pub fn parse(file: Source, sha256: String) -> Result<Paper, Box<Diagnostic>> {
    let definitions = definitions_of(&file.path);
    let file = Source { path: file.path, text: with_plain_ends(file.text) };
    parse_with(Arc::new(file), sha256, None, definitions)
}

/// Reads the text of a paper as it stands in an editor: the files that it names are read in the folder, as [`read`] does. The text has
/// [plain ends](with_plain_ends) of lines.
///
/// # Errors
/// Macros that do not end.
pub fn parse_in(file: Arc<Source>, folder: Option<&Path>) -> Result<Paper, Box<Diagnostic>> {
    let sha256 = Sha256::digest(file.text.as_bytes()).iter().map(|b| format!("{b:02x}")).collect();
    let definitions = definitions_of(&file.path);
    let text = with_plain_ends(file.text.clone());
    let file = if text == file.text { file } else { Arc::new(Source { path: file.path.clone(), text }) };
    parse_with(file, sha256, folder, definitions)
}

/// Reads a text that is handed over under a name, of which nothing else is read. Where nothing in it says where formulas begin, each line is a
/// formula, and a paragraph whose lines end with `\\\\` or have `&` is one of several lines; what is put before a formula moves its column.
///
/// # Errors
/// Macros that do not end.
pub fn parse_pasted(name: &str, text: &str) -> Result<Paper, Box<Diagnostic>> {
    let text = with_plain_ends(text.replace("\r\n", "\n"));
    let text = pasted::in_displays(&text).into_owned();
    let sha256 = Sha256::digest(text.as_bytes()).iter().map(|b| format!("{b:02x}")).collect();
    parse_with(Arc::new(Source { path: name.to_owned(), text }), sha256, None, Definitions::OfTheWhole)
}

/// Where definitions end in a file: a page has those of all its formulas.
fn definitions_of(path: &str) -> Definitions {
    if is_markdown(path) { Definitions::OfTheWhole } else { Definitions::OfTheirGroup }
}

/// Marks the formulas of which it is not known whether they are printed, or as what, and tells of each such place.
fn mark_doubts(printed: &mut [PrintedRelation], doubts: &Doubts) -> Vec<PaperNote> {
    let mut told = BTreeSet::new();
    let mut notes = Vec::new();
    for relation in printed {
        let Some((number, doubt)) = doubts.of(&relation.span()) else { continue };
        relation.unread = Some(doubt.why());
        if told.insert(number) {
            notes.push(PaperNote { message: doubt.message(), span: doubt.span.clone() });
        }
    }
    // What such a name makes of its arguments may be a formula that nobody sees.
    let others = doubts.of_names().filter(|(number, _)| !told.contains(number));
    notes.extend(others.map(|(_, doubt)| PaperNote { message: doubt.message(), span: doubt.span.clone() }));
    notes
}

/// Most macros without an end that are left out.
const MOST_ENDLESS: usize = 8;

fn parse_with(
    file: Arc<Source>,
    sha256: String,
    folder: Option<&Path>,
    definitions: Definitions,
) -> Result<Paper, Box<Diagnostic>> {
    if let Some(refusal) = FileKind::refusal(&file.path) {
        return Err(refusal);
    }
    let (file, cells) = notebook::as_read(file)?;
    let mut passed: BTreeSet<String> = BTreeSet::new();
    let mut endless = Vec::new();
    let (mut own, mut is_reread) = (OwnEnvironments::default(), false);
    let (Expanded { tokens: all, cut, doubts, notes: told }, inputs) = loop {
        let mut inputs = Inputs::new(&file, folder, own.clone());
        let preamble = inputs.preamble(&file);
        let document = inputs::tokens_of(&file, &mut inputs.own);
        let known = inputs.own.clone();
        let mut input = |name: &str, named, span: &Range<usize>| inputs.tokens(name, named, span);
        let found = macros::expanded(document, preamble, &passed, definitions, &mut input);
        let Endless { name, span } = match found {
            // An environment that another file makes is one of the whole paper: that is read anew, once.
            Ok(_) if !is_reread && !inputs.own.read_as(&known) => {
                (own, is_reread) = (inputs.own, true);
                continue;
            }
            Ok(all) => break (all, inputs),
            Err(endless) => endless,
        };
        // Without its definition the rest of the paper is read.
        let message = format!("the macro `\\{name}` does not end");
        if endless.len() >= MOST_ENDLESS || !passed.insert(name) {
            return Err(Box::new(Diagnostic::at(&file, "paper::unreadable", span, message)));
        }
        endless.push(PaperNote { message: format!("{message}; its definition is left out"), span });
    };
    let mut reader = Reader::new(&all);
    reader.document();
    let Reader { equations, relations, title, mut printed, differences, mut notes, mut borders, .. } = reader;
    printed::settle_numbers(&mut printed);
    notes.extend(mark_doubts(&mut printed, &doubts));
    notes.extend(told);
    notes.extend(cells);
    borders.numbered.sort_unstable();
    let title = title.map(|t| shown(&t).into_owned());
    notes.extend(inputs.notes);
    notes.extend(endless);
    notes.extend(cut.map(|span| {
        let most = token::MOST_TOKENS;
        let message = format!("the paper is longer than can be read, {most} words and signs: what follows is not read");
        PaperNote { message, span }
    }));
    if printed.is_empty() {
        let message = match file.text.trim().is_empty() {
            true => "this file is empty",
            false => "no formula that relates something is seen: formulas stand between dollars, or in a display",
        };
        notes.push(PaperNote { message: message.to_owned(), span: 0..0 });
    }
    notes.sort_by_key(|n| (n.span.start, n.span.end));
    let starts = |text: &str| std::iter::once(0).chain(text.match_indices('\n').map(|(i, _)| i + 1)).collect();
    let lines = std::iter::once(&file).chain(inputs.files.iter().map(|(_, f)| f)).map(|f| starts(&f.text)).collect();
    let mut paper = Paper {
        file,
        sha256,
        title,
        equations,
        relations,
        printed,
        differences,
        notes,
        borders,
        logarithm: None,
        inputs: inputs.files,
        lines,
    };
    continued::join(&mut paper);
    Ok(paper)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn equations(text: &str) -> Vec<(Option<String>, Vec<String>)> {
        let paper = parse(Source { path: "p.tex".into(), text: text.into() }, String::new()).expect("read");
        let texts = |e: &Equation| e.parts.iter().map(|p| p.text.clone()).collect();
        paper.equations.iter().map(|e| (e.label.clone(), texts(e))).collect()
    }

    fn one(label: Option<&str>, parts: &[&str]) -> (Option<String>, Vec<String>) {
        (label.map(Into::into), parts.iter().map(|p| (*p).to_owned()).collect())
    }

    #[test]
    fn displays_of_every_kind() {
        let text = r"
\newcommand{\be}{\begin{equation}} \newcommand{\ee}{\end{equation}} \newcommand{\w}{\omega}
\be \label{a} \dot q=p, \quad \dot p=-\w^2 q. \ee
\begin{eqnarray}\label{b} x=1,\cr y=2. \\ z=3 \label{c}\end{eqnarray}
\begin{align} a &= b \nonumber \\ &\quad +c \label{d} \\ e &= f \end{align}
\[ g=h \] and $$ i = j $$ and $k=l$ and $m$ and \(n<1\).
% \begin{equation} no = 1 \end{equation}
\begin{align*} o &= p \\ q &= r \end{align*}";
        assert_eq!(
            equations(text),
            [
                one(Some("a"), &[r"\dot q=p", r"\dot p=-\omega^2 q"]),
                one(Some("b"), &["x=1", "y=2"]),
                one(Some("c"), &["z=3"]),
                one(Some("d"), &["a = b +c"]),
                one(None, &["e = f"]),
                one(None, &["g=h"]),
                one(None, &["i = j"]),
                one(None, &["o = p", "q = r"]),
            ]
        );
    }

    #[test]
    fn no_text_panics() {
        let text =
            r"\begin{align}a&\nonumber\\[2pt]b\end{align}$$x$$\[y\]\(z=1\)\begin{alignat}{2}c\label{d}\\\end{alignat}";
        for end in 0..text.len() {
            equations(&text[..end]);
        }
    }
}
