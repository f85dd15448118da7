//! Documents → displays and formulas of the running text.
//!
//! **In:** the tokens of a document, macros expanded. **Out:** its displays, as what has one number in print and as
//! [`printed`](super::printed) relations. **Guaranteed:** what has no end is read as far as its paragraph goes, and told.

mod unprinted;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::differences::DifferenceSigns;
use super::displays::{Numbers, display};
use super::mark::{self, group_text, parts};
use super::note::PaperNote;
use super::opening::{Opening, opening};
use super::printed::{self, Place, PrintedRelation};
use super::token::{Kind, Token, UNENDED};
use super::{Equation, Part, span_of};
use diag::escape::in_one_line;

/// The most tokens of the options of an environment.
const MOST_OF_OPTIONS: usize = 60;

/// Environments of packages that print formulas, and are not read.
const DISPLAYS_NOT_READ: &[&str] =
    &["numcases", "subnumcases", "mathpar", "mathparpagebreakable", "dseries", "prooftree"];

/// Commands whose argument is text in a display.
const WORDS: &[&str] = &["text", "textrm", "textit", "textbf", "mbox", "hbox", "intertext", "shortintertext"];

/// The most tokens of a formula that is read: a display of a hundred pages.
const LONGEST_FORMULA: usize = 100_000;

/// Signs that make a formula of the running text one that says something.
const RELATIONS: &[&str] = &[
    "=", "<", ">", r"\le", r"\ge", r"\ne", r"\equiv", r"\approx", r"\sim", r"\simeq", r"\to", r"\propto", r"\ll",
    r"\gg",
];

/// Commands that stand in formulas alone.
const OF_FORMULAS: &[&str] =
    &["frac", "dfrac", "tfrac", "sqrt", "partial", "sum", "int", "cdot", "leq", "geq", "dot", "ddot", "nonumber"];

/// Commands that begin a section.
const SECTIONS: &[&str] = &["section", "chapter", "subsection", "part", "paragraph", "subsubsection", "appendix"];

/// Counters of what is printed on the way: of all others the next step begins something numbered.
const COUNTERS_OF_PAGES: &[&str] = &[
    "equation",
    "parentequation",
    "subequation",
    "figure",
    "table",
    "footnote",
    "mpfootnote",
    "page",
    "section",
    "subsection",
    "subsubsection",
    "chapter",
    "part",
    "enumi",
    "enumii",
    "enumiii",
    "enumiv",
];

/// Where something numbered begins, an example or an exercise, and the names of environments that are such.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Borders {
    /// Places at which a counter of the paper's own is stepped, in the order of the paper.
    pub numbered: Vec<usize>,
    /// Environments that `\\newtheorem` makes, in small letters.
    pub theorems: BTreeSet<String>,
}

/// Reads a document, from its first to its last token.
pub(super) struct Reader<'t> {
    tokens: &'t [Token],
    at: usize,
    pub equations: Vec<Equation>,
    pub relations: Vec<Part>,
    pub title: Option<String>,
    pub printed: Vec<PrintedRelation>,
    pub differences: DifferenceSigns,
    pub notes: Vec<PaperNote>,
    pub borders: Borders,
    displays: usize,
    section: usize,
    chapter: usize,
    /// The environments that have begun, and where.
    open: Vec<(String, Range<usize>)>,
    /// Those of which it is told that they are not read.
    told: BTreeSet<String>,
    /// Where what is not said begins behind what is read, and where it ends.
    passed: BTreeMap<usize, usize>,
}

impl<'t> Reader<'t> {
    pub(super) fn new(tokens: &'t [Token]) -> Reader<'t> {
        Reader {
            tokens,
            at: 0,
            equations: Vec::new(),
            relations: Vec::new(),
            title: None,
            printed: Vec::new(),
            differences: DifferenceSigns::default(),
            notes: Vec::new(),
            borders: Borders::default(),
            displays: 0,
            section: 0,
            chapter: 0,
            open: Vec::new(),
            told: BTreeSet::new(),
            passed: BTreeMap::new(),
        }
    }

    /// Tells of an environment that has a formula in it, and is not known to be a display.
    fn formula_outside(&mut self) {
        let Some((name, span)) = self.open.last().filter(|(name, _)| name != "document") else { return };
        if self.told.insert(name.clone()) {
            let message = format!("the environment `{}` is not known: its formulas are not read", in_one_line(name));
            self.notes.push(PaperNote { message, span: span.clone() });
        }
    }

    pub(super) fn document(&mut self) {
        while let Some(token) = self.tokens.get(self.at) {
            if let Some(end) = self.passed.remove(&self.at) {
                self.at = end;
                continue;
            }
            self.at += 1;
            match token.kind {
                Kind::Dollar if token.is_doubled_by(self.tokens.get(self.at)) => {
                    self.at += 1;
                    let body = self.until_dollar(true);
                    self.at += usize::from(self.tokens.get(self.at).is_some_and(|t| t.kind == Kind::Dollar));
                    self.equation(&body, Numbers::One, "$$");
                }
                Kind::Dollar => {
                    let body = self.until_dollar(false);
                    self.running(&body);
                }
                Kind::Command => match token.text.as_str() {
                    "[" => {
                        let body = self.until(r"\]", |tokens, i| tokens[i].is("]").then_some(i + 1));
                        self.equation(&body, Numbers::One, "[");
                    }
                    "(" => {
                        let body = self.until(r"\)", |tokens, i| tokens[i].is(")").then_some(i + 1));
                        self.running(&body);
                    }
                    name if SECTIONS.contains(&name) => {
                        self.section += 1;
                        self.chapter += usize::from(name == "chapter");
                    }
                    "refstepcounter" | "stepcounter" => {
                        let counter = group_text(self.tokens, self.at).0;
                        if !COUNTERS_OF_PAGES.contains(&counter.trim()) {
                            self.borders.numbered.push(token.span.start);
                        }
                    }
                    "newtheorem" => {
                        let star = usize::from(self.tokens.get(self.at).is_some_and(|t| t.is_char("*")));
                        let name = group_text(self.tokens, self.at + star).0;
                        self.borders.theorems.insert(name.trim().to_lowercase());
                    }
                    "title" if self.title.is_none() => {
                        let (text, _) = group_text(self.tokens, self.at);
                        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
                        self.title = (!text.is_empty()).then_some(text);
                    }
                    "begin" => {
                        let (name, after) = group_text(self.tokens, self.at);
                        if name == "lrbox" && self.box_environment(after) {
                            continue;
                        }
                        let (inner, after) = match name.as_str() {
                            "empheq" => group_text(self.tokens, self.after_options(after)),
                            _ => (name.clone(), after),
                        };
                        if let Some(numbers) = display(&inner) {
                            self.at = after;
                            if ["alignat", "xalignat", "IEEEeqnarray"].iter().any(|with| name.starts_with(with)) {
                                self.at = group_text(self.tokens, self.at).1;
                            }
                            let body = self.environment(&name);
                            self.equation(&body, numbers, inner.trim_start_matches("sub").trim_start_matches('x'));
                        } else {
                            let is_display = DISPLAYS_NOT_READ.contains(&name.as_str());
                            self.open.push((name, token.span.clone()));
                            if is_display {
                                self.formula_outside();
                            }
                        }
                    }
                    "end" => {
                        self.open.pop();
                    }
                    "ensuremath" => {
                        let body = self.argument();
                        self.running(&body);
                    }
                    UNENDED => {
                        let message = "nothing ends this environment, which is not printed: what follows is not read";
                        self.notes.push(PaperNote { message: message.to_owned(), span: token.span.clone() });
                    }
                    name if self.passes_over(name) => {}
                    name if OF_FORMULAS.contains(&name) => self.formula_outside(),
                    _ => {}
                },
                _ => {}
            }
        }
    }

    /// The tokens of a group that comes next, which are passed over.
    fn argument(&mut self) -> Vec<Token> {
        let after = group_text(self.tokens, self.at).1;
        let all = self.tokens.get(self.at..after).unwrap_or_default();
        self.at = after;
        let from = all.iter().position(|t| t.kind == Kind::Open).map_or(0, |i| i + 1);
        let to = all.len() - usize::from(all.last().is_some_and(|t| t.kind == Kind::Close));
        all.get(from..to).unwrap_or_default().to_vec()
    }

    /// Reads the formulas that stand in words of a display, `\text{where $a=b$}`; those of cases are read with these.
    fn formulas_in_words(&mut self, body: &[Token]) {
        let is_cases = |at: usize| group_text(body, at + 1).0.ends_with("cases");
        let (mut groups, mut cases) = (Vec::new(), 0usize);
        // Where words begin, or a formula in them; what the words before it make of it.
        let (mut words, mut formula, mut said) = (0, None, None);
        for (at, token) in body.iter().enumerate() {
            match token.kind {
                Kind::Open => {
                    let before = body[..at].iter().rev().find(|t| t.kind != Kind::Space);
                    let begins = before.is_some_and(|t| t.kind == Kind::Command && WORDS.contains(&t.text.as_str()));
                    if begins && groups.last() != Some(&true) {
                        (words, said) = (at + 1, None);
                    }
                    groups.push(begins || groups.last() == Some(&true));
                }
                Kind::Close => drop(groups.pop()),
                Kind::Dollar if groups.last() == Some(&true) && cases == 0 => match formula.take() {
                    Some(from) => {
                        let before = self.printed.len();
                        self.running(&body[from..at]);
                        // Nothing that words do not say to be meant so is stated here.
                        let opening = said.unwrap_or(Opening::Remark);
                        self.printed.iter_mut().skip(before).for_each(|r| r.opening = Some(opening));
                        words = at + 1;
                    }
                    None => {
                        let text: String = body[words..at].iter().map(|t| t.text.as_str()).collect();
                        said = opening(text.trim()).filter(|o| *o != Opening::Link).or(said);
                        formula = Some(at + 1);
                    }
                },
                _ if token.is("begin") && is_cases(at) => cases += 1,
                _ if token.is("end") && is_cases(at) => cases = cases.saturating_sub(1),
                _ => {}
            }
        }
    }

    /// The position after `[box=\fbox]`, where that stands there.
    fn after_options(&self, at: usize) -> usize {
        let rest = self.tokens.get(at..).unwrap_or_default();
        let begins = rest.iter().find(|t| t.kind != Kind::Space).is_some_and(|t| t.is_char("["));
        let end = rest.iter().take(MOST_OF_OPTIONS).position(|t| t.is_char("]")).filter(|_| begins);
        end.map_or(at, |end| at + end + 1)
    }

    /// The tokens up to where `ends` says, which gives the position after the end. Where there is no end, they go as far as what
    /// they stand in, and that is told.
    fn until(&mut self, wanted: &str, ends: impl Fn(&[Token], usize) -> Option<usize>) -> Vec<Token> {
        let from = self.at;
        for i in from..self.tokens.len() {
            if let Some(after) = ends(self.tokens, i) {
                self.at = after;
                return self.tokens[from..i].to_vec();
            }
            if self.begins_other(i) {
                break;
            }
        }
        let paragraph = |t: &Token| t.kind == Kind::Space && t.text == "\n";
        let more =
            (from..self.tokens.len()).take_while(|&i| !paragraph(&self.tokens[i]) && !self.begins_other(i)).count();
        self.at = from + more;
        self.unended(from, wanted);
        self.tokens[from..self.at].to_vec()
    }

    /// Whether what begins here cannot stand inside of a display.
    fn begins_other(&self, i: usize) -> bool {
        let token = &self.tokens[i];
        match token.text.as_str() {
            _ if token.kind != Kind::Command => false,
            "[" => true,
            "begin" => {
                let name = group_text(self.tokens, i + 1).0;
                name == "empheq" || display(&name).is_some()
            }
            name => SECTIONS.contains(&name),
        }
    }

    fn unended(&mut self, from: usize, wanted: &str) {
        let span = span_of(&self.tokens[from.saturating_sub(1)..self.at.max(from)]);
        let message = format!("this has no `{wanted}`: it is read as far as its paragraph goes");
        self.notes.push(PaperNote { message, span });
    }

    /// The tokens up to the next dollar, at most to the end of the paragraph.
    fn until_dollar(&mut self, is_display: bool) -> Vec<Token> {
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
                Kind::Space if self.tokens[i].text == "\n" => {
                    self.at = i;
                    self.unended(from, if is_display { "$$" } else { "$" });
                    // What stands between is text as well as formulas.
                    return if is_display { self.tokens[from..i].to_vec() } else { Vec::new() };
                }
                _ => {}
            }
        }
        self.at = self.tokens.len();
        self.unended(from, if is_display { "$$" } else { "$" });
        Vec::new()
    }

    /// The tokens up to the `\end` of an environment.
    fn environment(&mut self, name: &str) -> Vec<Token> {
        self.until(&format!("\\end{{{}}}", in_one_line(name)), |tokens, i| {
            let (found, after) = if tokens[i].is("end") { group_text(tokens, i + 1) } else { return None };
            (found == name).then_some(after)
        })
    }

    /// Whether a formula is longer than one that is read, which is noted.
    fn is_too_long(&mut self, body: &[Token]) -> bool {
        if body.len() > LONGEST_FORMULA {
            let message = format!("this formula is longer than {LONGEST_FORMULA} signs, and is not read");
            self.notes.push(PaperNote { message, span: span_of(body) });
        }
        body.len() > LONGEST_FORMULA
    }

    fn running(&mut self, body: &[Token]) {
        if self.is_too_long(body) {
            return;
        }
        let body = &*printed::with_braces(body);
        self.differences.note(body);
        let place = Place { environment: "", display: None, section: self.section, chapter: self.chapter };
        self.printed.extend(printed::relations(body, &place).into_iter().filter(|r| !r.signs.is_empty()));
        let part = Part::new(body);
        if part.marks.iter().any(|m| RELATIONS.contains(&m.text.as_str())) {
            self.relations.push(part);
        }
    }

    fn equation(&mut self, body: &[Token], numbers: Numbers, environment: &str) {
        if self.is_too_long(body) {
            return;
        }
        let body = &*printed::with_braces(body);
        self.differences.note(body);
        let place = Place { environment, display: Some(self.displays), section: self.section, chapter: self.chapter };
        self.printed.extend(printed::relations(body, &place));
        self.displays += 1;
        self.formulas_in_words(body);
        let lines = match numbers {
            Numbers::One => vec![body.to_vec()],
            Numbers::EachLine => numbered(body),
        };
        // The first and the last side of the chain so far.
        let mut chain: Option<(Vec<Token>, Vec<Token>)> = None;
        for line in lines {
            let label = line.iter().position(|t| t.is("label")).map(|i| group_text(&line, i + 1).0);
            let columns = columns(&line, environment.starts_with("eqnarray"));
            let mut all: Vec<Vec<Token>> = columns.iter().flat_map(|c| joined(parts(c))).collect();
            let mut whole = Vec::new();
            if let Some(part) = all.first_mut() {
                let (mut sides, goes_on) = printed::sides_of(part);
                let last = sides.pop().unwrap_or_default();
                let first = match chain.take() {
                    Some((first, before)) if goes_on => {
                        // A line that begins with `=` says it of what stands last in the line above, and of the first side.
                        whole = mark::marks(&[first.as_slice(), part].concat());
                        part.splice(0..0, before);
                        first
                    }
                    _ => sides.into_iter().next().unwrap_or_default(),
                };
                chain = (all.len() == 1).then_some((first, last));
            }
            let parts: Vec<Part> = all.iter().map(|p| Part::new(p)).collect();
            if !parts.is_empty() {
                let label = label.map(|l| in_one_line(&l)).filter(|l| !l.is_empty());
                self.equations.push(Equation { label, span: span_of(&line), parts, whole });
            }
        }
    }
}

/// The columns of the lines of a display: what stands left and right of a sign of alignment belongs together, and the lines of a
/// column, too.
fn columns(line: &[Token], is_table: bool) -> Vec<Vec<Token>> {
    let size = if is_table { 3 } else { 2 };
    let mut out: Vec<Vec<Token>> = vec![Vec::new()];
    // The row in which each column was last.
    let mut rows = vec![0usize];
    let (mut braces, mut environments, mut cell, mut row) = (0i32, 0i32, 0usize, 0usize);
    let mut broken = 0..0;
    for (i, token) in line.iter().enumerate() {
        match token.kind {
            Kind::Open => braces += 1,
            Kind::Close => braces -= 1,
            _ if token.is("begin") || token.is("end") => {
                let inner = mark::INNER.contains(&group_text(line, i + 1).0.as_str());
                let step = if token.is("begin") { 1 } else { -1 };
                environments += if inner { 0 } else { step };
            }
            _ => {}
        }
        let outside = braces == 0 && environments == 0;
        let breaks = outside && (token.is("\\") || token.is("cr") || token.is("newline"));
        if outside && token.is_char("&") {
            cell += 1;
            if out.len() <= cell / size {
                out.push(Vec::new());
                rows.push(row);
            }
            continue;
        }
        if breaks {
            (cell, row, broken) = (0, row + 1, token.span.clone());
            continue;
        }
        if let (Some(column), Some(last)) = (out.get_mut(cell / size), rows.get_mut(cell / size)) {
            // A column goes on in a later line.
            if std::mem::replace(last, row) < row {
                column.push(Token { kind: Kind::Command, text: "\\".into(), span: broken.clone() });
            }
            column.push(token.clone());
        }
    }
    out
}

/// Parts of which those that begin with an operator, and relate nothing, go on from the one before.
fn joined(parts: Vec<Vec<Token>>) -> Vec<Vec<Token>> {
    let mut out: Vec<Vec<Token>> = Vec::new();
    for part in parts {
        let goes_on =
            part.iter().find(|t| t.kind != Kind::Space && !printed::is_space(t)).is_some_and(printed::is_operator)
                && !part.iter().any(|t| t.is_char("="));
        match out.last_mut().filter(|_| goes_on) {
            Some(last) => {
                let at = last.last().map_or(0, |t| t.span.end);
                last.push(Token { kind: Kind::Space, text: " ".into(), span: at..at });
                last.extend(part);
            }
            None => out.push(part),
        }
    }
    out
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
            before.push(Token { kind: Kind::Command, text: "\\".into(), span: end..end });
            before.extend(last);
        }
    }
    out
}
