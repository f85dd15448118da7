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

mod compare;
mod draft;
mod macros;
mod mark;
mod token;

use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use sha2::{Digest, Sha256};

pub use compare::{Comparison, Coverage, Difference, Relation, UnknownLabel, compare, subject};
pub use draft::{Draft, draft};

use diag::escape::{in_one_line, shown};
use diag::{Diagnostic, Source};
use files::Why;
use mark::{Mark, group_text, marks, parts, text_of};
use token::{Kind, Token};

/// Largest size of a paper, in bytes.
pub const LARGEST_PAPER: u64 = 16 << 20;

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
}

/// A displayed equation: what has one number in print.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Its label.
    pub label: Option<String>,
    /// Its place.
    pub span: Range<usize>,
    /// What it consists of, between commas and breaks of lines; never empty.
    pub parts: Vec<Part>,
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
        Part { text: shown(&text_of(tokens)).into_owned(), span: span_of(tokens), marks: marks(tokens) }
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
    let sha256 = Sha256::digest(&bytes).iter().map(|b| format!("{b:02x}")).collect();
    let text = String::from_utf8(bytes).unwrap_or_else(|e| e.as_bytes().iter().map(|b| char::from(*b)).collect());
    parse(Source { path: shown, text }, sha256)
}

/// Reads the text of a paper.
///
/// # Errors
/// Macros that do not end.
pub fn parse(file: Source, sha256: String) -> Result<Paper, Box<Diagnostic>> {
    let file = Arc::new(file);
    let all = macros::expanded(&file.text).map_err(|e| {
        let message = format!("the macro `\\{}` does not end", e.name);
        Box::new(Diagnostic::at(&file, "paper::unreadable", e.span, message))
    })?;
    let mut reader = Reader { tokens: &all, at: 0, equations: Vec::new(), relations: Vec::new(), title: None };
    reader.document();
    let Reader { equations, relations, title, .. } = reader;
    let title = title.map(|t| shown(&t).into_owned());
    Ok(Paper { file, sha256, title, equations, relations })
}

/// How the lines of a display are numbered.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Numbers {
    /// One number for all.
    One,
    /// One for each line, unless the line says otherwise.
    EachLine,
}

fn display(name: &str) -> Option<Numbers> {
    match name {
        "equation" | "equation*" | "displaymath" | "multline" | "multline*" | "math" | "dmath" | "dmath*"
        | "align*" | "eqnarray*" | "gather*" | "flalign*" | "alignat*" | "dgroup" => Some(Numbers::One),
        "align" | "eqnarray" | "gather" | "flalign" | "alignat" => Some(Numbers::EachLine),
        _ => None,
    }
}

/// Signs that make a formula of the running text one that says something.
const RELATIONS: &[&str] = &[
    "=", "<", ">", r"\le", r"\ge", r"\ne", r"\equiv", r"\approx", r"\sim", r"\simeq", r"\to", r"\propto", r"\ll",
    r"\gg",
];

struct Reader<'t> {
    tokens: &'t [Token],
    at: usize,
    equations: Vec<Equation>,
    relations: Vec<Part>,
    title: Option<String>,
}

impl Reader<'_> {
    fn document(&mut self) {
        while let Some(token) = self.tokens.get(self.at) {
            self.at += 1;
            match token.kind {
                Kind::Dollar if self.tokens.get(self.at).is_some_and(|t| t.kind == Kind::Dollar) => {
                    self.at += 1;
                    let body = self.until_dollar();
                    self.at += usize::from(self.tokens.get(self.at).is_some_and(|t| t.kind == Kind::Dollar));
                    self.equation(&body, Numbers::One);
                }
                Kind::Dollar => {
                    let body = self.until_dollar();
                    self.running(&body);
                }
                Kind::Command => match token.text.as_str() {
                    "[" => {
                        let body = self.until(|tokens, i| tokens[i].is("]").then_some(i + 1));
                        self.equation(&body, Numbers::One);
                    }
                    "(" => {
                        let body = self.until(|tokens, i| tokens[i].is(")").then_some(i + 1));
                        self.running(&body);
                    }
                    "title" if self.title.is_none() => {
                        let (text, _) = group_text(self.tokens, self.at);
                        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
                        self.title = (!text.is_empty()).then_some(text);
                    }
                    "begin" => {
                        let (name, after) = group_text(self.tokens, self.at);
                        if let Some(numbers) = display(&name) {
                            self.at = after;
                            if name.starts_with("alignat") {
                                self.at = group_text(self.tokens, self.at).1;
                            }
                            let body = self.environment(&name);
                            self.equation(&body, numbers);
                        }
                    }
                    _ => {}
                },
                _ => {}
            }
        }
    }

    /// The tokens up to where `ends` says, which gives the position after the end.
    fn until(&mut self, ends: impl Fn(&[Token], usize) -> Option<usize>) -> Vec<Token> {
        let from = self.at;
        for i in from..self.tokens.len() {
            if let Some(after) = ends(self.tokens, i) {
                self.at = after;
                return self.tokens[from..i].to_vec();
            }
        }
        self.at = self.tokens.len();
        Vec::new()
    }

    fn until_dollar(&mut self) -> Vec<Token> {
        // A dollar inside a group (of a \text) belongs to the group.
        let from = self.at;
        let mut depth = 0i32;
        for i in from..self.tokens.len() {
            match self.tokens[i].kind {
                Kind::Open => depth += 1,
                Kind::Close => depth -= 1,
                Kind::Dollar if depth <= 0 => {
                    self.at = i + 1;
                    return self.tokens[from..i].to_vec();
                }
                _ => {}
            }
        }
        self.at = self.tokens.len();
        Vec::new()
    }

    /// The tokens up to the `\end` of an environment.
    fn environment(&mut self, name: &str) -> Vec<Token> {
        self.until(|tokens, i| {
            let (found, after) = if tokens[i].is("end") { group_text(tokens, i + 1) } else { return None };
            (found == name).then_some(after)
        })
    }

    fn running(&mut self, body: &[Token]) {
        let part = Part::new(body);
        if part.marks.iter().any(|m| RELATIONS.contains(&m.text.as_str())) {
            self.relations.push(part);
        }
    }

    fn equation(&mut self, body: &[Token], numbers: Numbers) {
        let lines = match numbers {
            Numbers::One => vec![body.to_vec()],
            Numbers::EachLine => numbered(body),
        };
        for line in lines {
            let label = line.iter().position(|t| t.is("label")).map(|i| group_text(&line, i + 1).0);
            let parts: Vec<Part> = parts(&line).iter().map(|p| Part::new(p)).collect();
            if !parts.is_empty() {
                let label = label.map(|l| in_one_line(&l)).filter(|l| !l.is_empty());
                self.equations.push(Equation { label, span: span_of(&line), parts });
            }
        }
    }
}

/// The lines of a display that have a number each: a line without one belongs to the next that has one, or to the last.
fn numbered(body: &[Token]) -> Vec<Vec<Token>> {
    let mut out: Vec<Vec<Token>> = vec![Vec::new()];
    let (mut braces, mut environments) = (0i32, 0i32);
    let mut at = 0;
    let mut has_number = true;
    while let Some(token) = body.get(at) {
        at += 1;
        match token.kind {
            Kind::Open => braces += 1,
            Kind::Close => braces -= 1,
            _ if token.is("begin") => environments += 1,
            _ if token.is("end") => environments -= 1,
            _ if token.is("nonumber") || token.is("notag") => has_number = false,
            _ if token.is("\\") && braces == 0 && environments == 0 => {
                let after = mark::after_row(body, at);
                match out.last_mut() {
                    Some(line) if !has_number => line.extend_from_slice(&body[at - 1..after]),
                    _ => out.push(Vec::new()),
                }
                at = after;
                has_number = true;
                continue;
            }
            _ => {}
        }
        if let Some(line) = out.last_mut() {
            line.push(token.clone());
        }
    }
    if !has_number && out.len() > 1 {
        // The last line has no number: it ends the equation before it.
        let last = out.pop().unwrap_or_default();
        if let Some(before) = out.last_mut() {
            let end = last.first().map_or(0, |t| t.span.start);
            before.push(Token { kind: Kind::Command, text: "\\".to_owned(), span: end..end });
            before.extend(last);
        }
    }
    out
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
                one(Some("d"), &["a = b", "+c"]),
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
