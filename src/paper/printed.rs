//! Displays → printed relations: what a reader sees as one.
//!
//! **In:** the tokens of a display or of a formula of the running text. **Out:** its [`PrintedRelation`]s: the columns of an
//! `align` apart, continued lines joined, a chain over several lines as one. **Guaranteed:** every token that prints is in a
//! side or in a remark: nothing is dropped without a word.

use std::ops::Range;

use super::mark::{self, INNER, group_text};
use super::span_of;
use super::token::{Kind, Token};
use super::unicode;
use diag::escape::shown;

/// What a reader sees as one: sides, and the signs between them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PrintedRelation {
    /// The sides, in their order; never empty. One side alone is a formula that relates nothing.
    pub sides: Vec<PrintedSide>,
    /// The sign before each side but the first, as a command or a character: `=`, `\le`.
    pub signs: Vec<String>,
    /// Its label, or that of its display.
    pub label: Option<String>,
    /// Its number, where the author gives one with `\tag`.
    pub tag: Option<String>,
    /// What stands beside it in words.
    pub remark: Option<String>,
    /// Whether it says when another holds: "for x > 0".
    pub is_condition: bool,
    /// The number of its display; `None` in the running text.
    pub display: Option<usize>,
    /// The number of its section.
    pub section: usize,
}

/// A side of a relation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PrintedSide {
    /// The formula, macros expanded, without layout.
    pub text: String,
    /// Its place.
    pub span: Range<usize>,
    /// What is written has commas outside of all brackets: several formulas stand where one is read.
    pub is_list: bool,
    pub(super) tokens: Vec<Token>,
}

impl PrintedSide {
    /// The formula with a dot wherever a name that `is_factor` stands right before parentheses, so that it is read as a factor.
    pub fn with_factors(&self, is_factor: &dyn Fn(&str) -> bool) -> String {
        let mut out: Vec<Token> = Vec::with_capacity(self.tokens.len());
        for (at, token) in self.tokens.iter().enumerate() {
            let bracket = |t: Option<&Token>| t.is_some_and(|t| t.is_char("(") || t.is_char("["));
            let opens = bracket(Some(token)) && !(at > 0 && is_size(&self.tokens[at - 1]))
                || is_size(token) && bracket(self.tokens.get(at + 1));
            if opens && base_before(&out).is_some_and(is_factor) {
                out.push(Token {
                    kind: Kind::Command,
                    text: "cdot".to_owned(),
                    span: token.span.start..token.span.start,
                });
            }
            out.push(token.clone());
        }
        shown(&mark::text_of(&out)).into_owned()
    }
}

fn is_size(token: &Token) -> bool {
    token.kind == Kind::Command
        && matches!(token.text.as_str(), "left" | "big" | "Big" | "bigg" | "Bigg" | "bigl" | "Bigl" | "biggl" | "Biggl")
}

/// The letter to which the scripts at the end of some tokens belong, or that stands there.
fn base_before(tokens: &[Token]) -> Option<&str> {
    let mut end = tokens.len();
    loop {
        while end > 0 && tokens[end - 1].kind == Kind::Space {
            end -= 1;
        }
        let last = tokens.get(end.checked_sub(1)?)?;
        let mut start = end - 1;
        if last.kind == Kind::Close {
            let mut depth = 0i32;
            start = (0..end).rev().find(|&i| {
                depth += i32::from(tokens[i].kind == Kind::Close) - i32::from(tokens[i].kind == Kind::Open);
                depth == 0
            })?;
        }
        let before = tokens[..start].iter().rposition(|t| t.kind != Kind::Space);
        if let Some(script) = before.filter(|&i| tokens[i].is_char("^") || tokens[i].is_char("_")) {
            end = script;
            continue;
        }
        let letter = match last.kind {
            Kind::Other => last.text.chars().all(char::is_alphabetic),
            Kind::Command => super::names::is_letter(last),
            _ => false,
        };
        return (letter && start == end - 1).then_some(last.text.as_str());
    }
}

impl PrintedRelation {
    /// From its first to its last side.
    pub fn span(&self) -> Range<usize> {
        let start = self.sides.iter().map(|s| s.span.start).min().unwrap_or(0);
        start..self.sides.iter().map(|s| s.span.end).max().unwrap_or(start)
    }

    /// The relation as one text.
    pub fn text(&self) -> String {
        let mut out = String::new();
        for (k, side) in self.sides.iter().enumerate() {
            if let Some(sign) = k.checked_sub(1).and_then(|k| self.signs.get(k)) {
                out.push_str(sign);
                if sign.starts_with('\\') && side.text.starts_with(|c: char| c.is_ascii_alphabetic()) {
                    out.push(' ');
                }
            }
            out.push_str(&side.text);
        }
        out
    }
}

/// Signs that relate two sides.
const RELATIONS: &[&str] = &[
    "equiv",
    "approx",
    "simeq",
    "sim",
    "cong",
    "propto",
    "ll",
    "gg",
    "le",
    "leq",
    "leqslant",
    "ge",
    "geq",
    "geqslant",
    "ne",
    "neq",
    "lesssim",
    "gtrsim",
    "to",
    "rightarrow",
    "longrightarrow",
    "mapsto",
    "longmapsto",
    "in",
    "notin",
    "subset",
    "subseteq",
    "doteq",
    "triangleq",
    "coloneqq",
    "coloneq",
    "eqqcolon",
    "asymp",
    "lt",
    "gt",
    "leftarrow",
    "perp",
    "parallel",
    "rightleftharpoons",
    "leftrightarrow",
    "xrightarrow",
    "eqsim",
    "approxeq",
    "thickapprox",
    "thicksim",
    "prec",
    "succ",
];

/// Signs between statements.
const BETWEEN_STATEMENTS: &[&str] = &[
    "Rightarrow",
    "implies",
    "Longrightarrow",
    "iff",
    "Leftrightarrow",
    "Longleftrightarrow",
    "therefore",
    "because",
    "impliedby",
    "Leftarrow",
];

/// Signs with which a formula goes on.
const OPERATORS: &[&str] =
    &["+", "-", "/", "*", "·", "×", "−", "pm", "mp", "times", "cdot", "div", "wedge", "otimes", "oplus", "ast"];

/// Commands that print words.
const WORDS: &[&str] =
    &["text", "mbox", "hbox", "textrm", "textit", "textbf", "textnormal", "intertext", "shortintertext"];

/// Spaces.
const SPACES: &[&str] = &[
    ",",
    ";",
    ":",
    ">",
    "!",
    " ",
    "\n",
    "\t",
    "thinspace",
    "medspace",
    "thickspace",
    "negthinspace",
    "enspace",
    "nonumber",
    "notag",
    "hfill",
    "hfil",
    "allowbreak",
    "noindent",
    "par",
    "break",
    "linebreak",
    "pagebreak",
    "allowdisplaybreaks",
    "relax",
    "protect",
    "strut",
    "displaystyle",
    "textstyle",
    "displaybreak",
    "quad",
    "qquad",
    "/",
    "centering",
    "nobreak",
    "null",
    "smallskip",
    "medskip",
];

/// The most rows of a display that are looked at as one; more are told as one formula that is not read.
const MOST_TOKENS: usize = 200_000;

fn is_wide(token: &Token) -> bool {
    token.is("quad") || token.is("qquad")
}

pub(super) fn is_space(token: &Token) -> bool {
    token.kind == Kind::Space
        || token.is_char("~")
        || token.kind == Kind::Command && SPACES.contains(&token.text.as_str())
}

pub(super) fn is_operator(token: &Token) -> bool {
    matches!(token.kind, Kind::Command | Kind::Other) && OPERATORS.contains(&token.text.as_str())
}

fn is_relation(token: &Token) -> bool {
    match token.kind {
        Kind::Other => {
            matches!(token.text.as_str(), "=" | "<" | ">" | "≈" | "≤" | "≥" | "≠" | "≡" | "∼" | "∝" | "≪" | "≫")
        }
        Kind::Command => RELATIONS.contains(&token.text.as_str()),
        _ => false,
    }
}

/// How deep a place lies in braces, brackets and environments.
#[derive(Clone, Copy, Default)]
struct Nesting {
    braces: i32,
    brackets: i32,
    environments: i32,
}

impl Nesting {
    /// Takes the next token; `after` are those that follow it. How many of them belong to it.
    fn take(&mut self, token: &Token, after: &[Token]) -> usize {
        match token.kind {
            Kind::Open => self.braces += 1,
            Kind::Close => self.braces = (self.braces - 1).max(0),
            Kind::Other => match token.text.as_str() {
                "(" | "[" => self.brackets += 1,
                ")" | "]" => self.brackets = (self.brackets - 1).max(0),
                _ => {}
            },
            Kind::Command => match token.text.as_str() {
                "begin" => self.environments += 1,
                "end" => self.environments = (self.environments - 1).max(0),
                "{" | "lbrace" | "lbrack" | "langle" | "lfloor" | "lceil" => self.brackets += 1,
                "}" | "rbrace" | "rbrack" | "rangle" | "rfloor" | "rceil" => self.brackets = (self.brackets - 1).max(0),
                "left" => {
                    self.brackets += 1;
                    return usize::from(!after.is_empty());
                }
                "right" => {
                    self.brackets = (self.brackets - 1).max(0);
                    return usize::from(!after.is_empty());
                }
                _ => {}
            },
            _ => {}
        }
        0
    }

    fn is_outside(&self) -> bool {
        self.braces == 0 && self.brackets == 0 && self.environments == 0
    }
}

/// Calls `each` with the position of every token, whether it stands outside of all brackets, and the nesting after it.
fn walk(tokens: &[Token], mut each: impl FnMut(usize, bool)) -> Nesting {
    let mut nesting = Nesting::default();
    let mut at = 0;
    while at < tokens.len() {
        let before = nesting.is_outside();
        let more = nesting.take(&tokens[at], &tokens[at + 1..]);
        each(at, before && nesting.is_outside());
        at += 1 + more;
    }
    nesting
}

/// The sides of a formula, and whether a sign of relation stands before the first.
pub(super) fn sides_of(tokens: &[Token]) -> (Vec<Vec<Token>>, bool) {
    let mut signs = Vec::new();
    walk(tokens, |i, outside| {
        if outside && is_relation(&tokens[i]) {
            signs.push(i);
        }
    });
    let mut out = Vec::new();
    let mut from = 0;
    for &sign in &signs {
        out.push(tokens[from..sign].to_vec());
        from = sign + 1;
    }
    out.push(tokens[from.min(tokens.len())..].to_vec());
    let begins = !signs.is_empty() && out.first().is_some_and(|s| s.iter().all(is_space));
    (out, begins)
}

/// A row of a display.
#[derive(Default)]
struct Row {
    cells: Vec<Vec<Token>>,
    /// What stands between it and the row before, in words.
    between: Option<String>,
}

/// What is known of a display.
pub(super) struct Place<'p> {
    /// The name of its environment; empty in the running text.
    pub environment: &'p str,
    /// Its number.
    pub display: Option<usize>,
    /// The number of its section.
    pub section: usize,
}

/// The relations that a display prints.
pub(super) fn relations(body: &[Token], place: &Place<'_>) -> Vec<PrintedRelation> {
    let mut found = Relations { place, out: Vec::new(), open: Vec::new(), ended: Vec::new() };
    if body.len() > MOST_TOKENS {
        found.put(0, side_of(body), None);
        return found.out;
    }
    let body = unicode::plain(&unwrapped(body));
    for row in rows(&body) {
        found.row(row);
    }
    // A label of a display belongs to all that has none.
    let label = found.out.iter().find_map(|r| r.label.clone());
    if place.display.is_some() && found.out.iter().filter(|r| r.label.is_some()).count() == 1 {
        found.out.iter_mut().for_each(|r| r.label = label.clone());
    }
    found.out.retain(|r| !(r.sides.len() == 1 && r.sides[0].text.is_empty() && r.remark.is_none()));
    found.out
}

/// A display without environments that only say where its lines are broken, and without a brace that encloses all.
fn unwrapped(body: &[Token]) -> Vec<Token> {
    let mut body = body.to_vec();
    if let Some(inside) = without_brace(&body) {
        body = inside;
    }
    let mut out = Vec::with_capacity(body.len());
    let mut nesting = Nesting::default();
    let mut at = 0;
    while at < body.len() {
        let token = &body[at];
        if nesting.is_outside() && (token.is("begin") || token.is("end")) {
            let (name, after) = group_text(&body, at + 1);
            let is_table = name == "array" && is_table_of_relations(&body, at);
            if INNER.contains(&name.trim_end_matches('*')) || is_table {
                let mut next = after;
                if token.is("begin") {
                    next = after_option(&body, next);
                    if name == "array" || name.starts_with("alignedat") {
                        next = group_text(&body, next).1;
                    }
                }
                // An array ends where its own end stands: the depth of what is between counts.
                at = next;
                continue;
            }
            if token.is("end") && name == "array" {
                at = after;
                continue;
            }
        }
        let more = nesting.take(token, &body[at + 1..]);
        out.extend_from_slice(&body[at..(at + 1 + more).min(body.len())]);
        at += 1 + more;
    }
    out
}

/// The position after `[…]`, where that stands there.
fn after_option(tokens: &[Token], at: usize) -> usize {
    let next = at + tokens[at.min(tokens.len())..].iter().take_while(|t| t.kind == Kind::Space).count();
    if !tokens.get(next).is_some_and(|t| t.is_char("[")) {
        return at;
    }
    tokens[next..].iter().take(6).position(|t| t.is_char("]")).map_or(at, |end| next + end + 1)
}

/// What is inside of `\left\{ … \right.`, where that is all.
fn without_brace(body: &[Token]) -> Option<Vec<Token>> {
    let printed: Vec<usize> = (0..body.len()).filter(|&i| !is_space(&body[i])).collect();
    let (&first, &last) = (printed.first()?, printed.last()?);
    let brace = body.get(first)?.is("left") && body.get(printed.get(1).copied()?)?.is("{");
    let dot =
        body.get(last)?.is_char(".") && body.get(printed.get(printed.len().checked_sub(2)?).copied()?)?.is("right");
    if !brace || !dot {
        return None;
    }
    let inside = &body[printed[1] + 1..printed[printed.len() - 2]];
    // The two belong together only if nothing between them ends the first.
    let mut depth = 0i32;
    let closed = inside.iter().any(|t| {
        depth += i32::from(t.is("left")) - i32::from(t.is("right"));
        depth < 0
    });
    let environment = inside.iter().find(|t| !is_space(t)).is_some_and(|t| t.is("begin"));
    (!closed && environment).then(|| inside.to_vec())
}

/// Whether the array that begins here has rows `left & = & right`.
fn is_table_of_relations(body: &[Token], at: usize) -> bool {
    if body[at].is("end") {
        return false;
    }
    let after = group_text(body, group_text(body, at + 1).1).1;
    let mut nesting = Nesting::default();
    let mut cells = vec![Vec::new()];
    let mut next = after;
    while let Some(token) = body.get(next) {
        let outside = nesting.is_outside();
        if outside && (token.is("end") || token.is("\\") || token.is("cr")) {
            break;
        }
        if outside && token.is_char("&") {
            cells.push(Vec::new());
        } else if !is_space(token)
            && let Some(cell) = cells.last_mut()
        {
            cell.push(token);
        }
        next += 1 + nesting.take(token, &body[next + 1..]);
    }
    // It must be all that is printed: a matrix in a formula is none.
    let alone = body[..at].iter().all(is_space);
    alone && cells.len() == 3 && matches!(cells[1].as_slice(), [one] if is_relation(one))
}

/// The rows of a display, each in cells.
fn rows(body: &[Token]) -> Vec<Row> {
    let mut out = vec![Row { cells: vec![Vec::new()], between: None }];
    let (mut braces, mut environments) = (0i32, 0i32);
    let mut at = 0;
    while let Some(token) = body.get(at) {
        at += 1;
        let outside = braces == 0 && environments == 0;
        match token.kind {
            Kind::Open => braces += 1,
            Kind::Close => braces = (braces - 1).max(0),
            Kind::Other if token.text == "&" && outside => {
                if let Some(row) = out.last_mut() {
                    row.cells.push(Vec::new());
                }
                continue;
            }
            Kind::Command => match token.text.as_str() {
                "begin" => environments += 1,
                "end" => environments = (environments - 1).max(0),
                "\\" | "cr" | "newline" | "tabularnewline" if outside => {
                    at = mark::after_row(body, at);
                    out.push(Row { cells: vec![Vec::new()], between: None });
                    continue;
                }
                "intertext" | "shortintertext" if outside => {
                    let (words, after) = group_text(body, at);
                    at = after;
                    out.push(Row { cells: vec![Vec::new()], between: Some(words) });
                    continue;
                }
                _ => {}
            },
            _ => {}
        }
        if let Some(cell) = out.last_mut().and_then(|row| row.cells.last_mut()) {
            cell.push(token.clone());
        }
    }
    out
}

/// A part of a row: what stands between commas, wide spaces and words.
#[derive(Default)]
struct Piece {
    tokens: Vec<Token>,
    /// Words before it.
    words: Option<String>,
    /// A sign between statements stands before it.
    implied: bool,
    /// What separates it from the one before is a comma.
    comma: bool,
    /// What separates it is a wide space, or words.
    wide: bool,
    /// It ends with a comma, a semicolon or a full stop.
    ended: bool,
}

impl Piece {
    fn is_empty(&self) -> bool {
        self.tokens.iter().all(|t| is_space(t) || t.is_char("&"))
    }

    fn relates(&self) -> bool {
        let mut found = false;
        walk(&self.tokens, |i, outside| found |= outside && is_relation(&self.tokens[i]));
        found
    }

    fn first(&self) -> Option<&Token> {
        self.tokens.iter().find(|t| !is_space(t))
    }
}

/// Words behind which a condition stands.
const CONDITIONAL: &[&str] = &[
    "for", "if", "when", "where", "with", "as", "at", "provided", "unless", "whenever", "only if", "for all", "given",
    "assuming", "on", "in",
];

/// The pieces of a row.
fn pieces(tokens: &[Token]) -> Vec<Piece> {
    let mut out = vec![Piece::default()];
    let mut nesting = Nesting::default();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let outside = nesting.is_outside();
        let mut next = None;
        if outside && (token.is_char(",") || token.is_char(";") || token.is_char(".") && ends_sentence(tokens, at)) {
            if let Some(piece) = out.last_mut() {
                piece.ended = true;
            }
            next = Some((Piece { comma: !token.is_char("."), ..Piece::default() }, at + 1));
        } else if outside && is_wide(token) {
            next = Some((Piece { wide: true, ..Piece::default() }, at + 1));
        } else if outside && token.kind == Kind::Command && BETWEEN_STATEMENTS.contains(&token.text.as_str()) {
            next = Some((Piece { implied: true, wide: true, ..Piece::default() }, at + 1));
        } else if outside && token.kind == Kind::Command && WORDS.contains(&token.text.as_str()) {
            let (words, after) = group_text(tokens, at + 1);
            if after > at + 1 && !is_operand(tokens, at, after, &words) {
                next = Some((Piece { words: Some(words.trim().to_owned()), wide: true, ..Piece::default() }, after));
            }
        }
        match next {
            Some((piece, after)) => {
                match out.last_mut() {
                    // Two separators in a row are one.
                    Some(last) if last.is_empty() => {
                        let words = match (last.words.take(), piece.words) {
                            (Some(a), Some(b)) => Some(format!("{a} {b}")),
                            (a, b) => a.or(b),
                        };
                        last.words = words;
                        last.implied |= piece.implied;
                        last.comma |= piece.comma;
                        last.wide |= piece.wide;
                    }
                    _ => out.push(piece),
                }
                at = after;
            }
            None => {
                let more = nesting.take(token, &tokens[at + 1..]);
                let end = (at + 1 + more).min(tokens.len());
                if let Some(piece) = out.last_mut() {
                    piece.tokens.extend_from_slice(&tokens[at..end]);
                }
                at = end;
            }
        }
    }
    out
}

/// Whether a full stop ends a formula, and is no decimal point.
fn ends_sentence(tokens: &[Token], at: usize) -> bool {
    let digit = |t: Option<&Token>| t.is_some_and(|t| t.text.starts_with(|c: char| c.is_ascii_digit()));
    !digit(tokens.get(at + 1)) && !(at > 0 && (tokens[at - 1].is("right") || tokens[at - 1].is("left")))
}

/// Whether words are a part of a formula: `F = \text{const}`.
fn is_operand(tokens: &[Token], at: usize, after: usize, words: &str) -> bool {
    let before = tokens[..at].iter().rev().find(|t| !is_space(t));
    let behind = tokens[after..].iter().find(|t| !is_space(t));
    let word = words.trim().trim_end_matches([',', '.', ':']).to_lowercase();
    if CONDITIONAL.contains(&word.as_str()) || matches!(word.as_str(), "and" | "or" | "") {
        return false;
    }
    let script = |t: &&Token| t.is_char("_") || t.is_char("^");
    let begins = before.is_some_and(|t| is_relation(t) || is_operator(t) || script(&t));
    let goes_on = behind.is_some_and(|t| is_relation(t) || is_operator(t) || script(&t));
    begins || goes_on || (before.is_some_and(|t| t.kind == Kind::Open))
}

struct Relations<'p> {
    place: &'p Place<'p>,
    out: Vec<PrintedRelation>,
    /// For each column, the relation that may go on.
    open: Vec<Option<usize>>,
    /// Whether it ended with a comma or a full stop.
    ended: Vec<bool>,
}

impl Relations<'_> {
    fn row(&mut self, row: Row) {
        let cells = row.cells;
        if let Some(words) = row.between {
            self.remark(&words);
        }
        let single = cells.len() == 1;
        let table = self.place.environment.starts_with("eqnarray") || cells.len() == 3 && is_sign_alone(&cells[1]);
        let size = if table { 3 } else { 2 };
        let mut last = None;
        for (column, pair) in cells.chunks(size).enumerate() {
            let left_empty = !single && pair[0].iter().all(|t| is_space(t) || is_idle(t) || is_braces(t));
            let tokens: Vec<Token> = pair.concat();
            if self.open.len() <= column {
                self.open.resize(column + 1, None);
                self.ended.resize(column + 1, true);
            }
            last = self.pair(&tokens, column, last, Layout { left_empty, single });
        }
    }

    /// Takes what stands in two cells; `before` is the column of the row that has something before it.
    fn pair(&mut self, tokens: &[Token], column: usize, before: Option<usize>, layout: Layout) -> Option<usize> {
        let (tokens, label, tag) = without_labels(tokens);
        let pieces = pieces(&tokens);
        let mut here = before;
        let mut column = column;
        for (k, piece) in pieces.into_iter().enumerate() {
            let words = piece.words.clone();
            let conditional = words.as_deref().is_some_and(is_conditional);
            if let Some(words) = words.filter(|w| !w.is_empty()) {
                self.remark(&words);
            }
            if piece.is_empty() {
                continue;
            }
            let begins = piece.first().is_some_and(|t| is_relation(t) || is_operator(t));
            let operator = piece.first().is_some_and(is_operator) && !piece.relates();
            if k == 0
                && begins
                && (layout.left_empty || operator)
                && self.open[column].is_none()
                && let Some(previous) = before
            {
                column = previous;
            }
            let goes_on =
                if k == 0 { self.goes_on(&piece, column, layout) } else { begins && !piece.implied && !piece.comma };
            let list = piece.comma && !piece.wide && k > 0 && !piece.relates();
            let ended = piece.ended;
            if (goes_on || list)
                && let Some(at) = self.open[column]
            {
                self.append(at, &piece.tokens, list);
            } else {
                self.begin(&piece, column, conditional);
            }
            self.ended[column] = ended;
            here = Some(column);
        }
        if let Some(at) = self.open.get(column).copied().flatten() {
            let relation = &mut self.out[at];
            relation.label = label.or(relation.label.take());
            relation.tag = tag.or(relation.tag.take());
        } else if let Some(relation) = self.out.last_mut() {
            relation.label = label.or(relation.label.take());
        }
        here
    }

    /// Whether a piece at the beginning of a row goes on from the row before.
    fn goes_on(&self, piece: &Piece, column: usize, layout: Layout) -> bool {
        let Some(at) = self.open[column] else { return false };
        let Some(first) = piece.first() else { return false };
        if piece.implied {
            return false;
        }
        let last = self.out[at].sides.last();
        let unfinished = last.is_some_and(|side| {
            let printed: Vec<&Token> = side.tokens.iter().filter(|t| !is_space(t)).collect();
            printed.last().is_none_or(|t| is_operator(t)) || walk(&side.tokens, |_, _| {}).brackets > 0
        });
        let lines = matches!(
            self.place.environment.trim_end_matches('*'),
            "multline" | "equation" | "dmath" | "displaymath" | "[" | "$$"
        );
        unfinished
            || is_relation(first)
            || is_operator(first) && (layout.left_empty || !piece.relates() || lines && layout.single)
            || !piece.relates() && !self.ended[column] && (layout.left_empty || lines)
    }

    fn begin(&mut self, piece: &Piece, column: usize, conditional: bool) {
        let remark = piece.implied.then(|| "⇒".to_owned());
        let at = self.put(column, side_of(&[]), remark);
        self.out[at].is_condition = conditional;
        self.append(at, &piece.tokens, false);
    }

    fn put(&mut self, column: usize, side: PrintedSide, remark: Option<String>) -> usize {
        let at = self.out.len();
        self.out.push(PrintedRelation {
            sides: vec![side],
            signs: Vec::new(),
            label: None,
            tag: None,
            remark,
            is_condition: false,
            display: self.place.display,
            section: self.place.section,
        });
        if let Some(open) = self.open.get_mut(column) {
            *open = Some(at);
        }
        at
    }

    /// Adds tokens to the last side of a relation; signs among them begin further sides.
    fn append(&mut self, at: usize, tokens: &[Token], list: bool) {
        let relation = &mut self.out[at];
        let mut current = relation.sides.pop().map(|s| s.tokens).unwrap_or_default();
        let was_list = list;
        if list {
            let end = current.last().map_or(0, |t| t.span.end);
            current.push(Token { kind: Kind::Other, text: ",".to_owned(), span: end..end });
        }
        let mut nesting = Nesting::default();
        for token in &current {
            nesting.take(token, &[]);
        }
        nesting = walk(&current, |_, _| {});
        let mut i = 0;
        while i < tokens.len() {
            let token = &tokens[i];
            let over =
                matches!(token.text.as_str(), "stackrel" | "overset" | "underset") && token.kind == Kind::Command;
            if nesting.is_outside()
                && over
                && let Some((sign, words, after)) = stacked(tokens, i)
            {
                relation.sides.push(side_of(&std::mem::take(&mut current)));
                relation.signs.push(sign);
                relation.remark.get_or_insert(words);
                i = after;
                continue;
            }
            if nesting.is_outside() && (is_relation(token) || token.is("not") || is_colon_equals(tokens, i)) {
                let (sign, after) = sign_at(tokens, i);
                relation.sides.push(side_of(&std::mem::take(&mut current)));
                relation.signs.push(sign);
                i = after;
                continue;
            }
            let more = nesting.take(token, &tokens[i + 1..]);
            let end = (i + 1 + more).min(tokens.len());
            current.extend_from_slice(&tokens[i..end]);
            i = end;
        }
        let mut side = side_of(&current);
        side.is_list |= was_list;
        relation.sides.push(side);
        // A sign at the beginning of all has nothing to its left: it is told as it is.
    }

    fn remark(&mut self, words: &str) {
        let words = shown(words.trim()).into_owned();
        match self.out.last_mut() {
            Some(last) => {
                last.remark = Some(match last.remark.take() {
                    Some(before) => format!("{before} {words}"),
                    None => words,
                });
            }
            None => {
                // Words before the first formula belong to it.
                self.out.push(PrintedRelation {
                    sides: vec![side_of(&[])],
                    signs: Vec::new(),
                    label: None,
                    tag: None,
                    remark: Some(words),
                    is_condition: false,
                    display: self.place.display,
                    section: self.place.section,
                });
            }
        }
    }
}

/// How what stands in a row is aligned.
#[derive(Clone, Copy)]
struct Layout {
    /// Nothing stands before the sign of alignment.
    left_empty: bool,
    /// There is no sign of alignment.
    single: bool,
}

fn is_conditional(words: &str) -> bool {
    let words = words.trim().trim_matches(|c: char| !c.is_alphabetic()).to_lowercase();
    CONDITIONAL.iter().any(|c| words == *c || words.starts_with(&format!("{c} ")))
}

fn is_sign_alone(cell: &[Token]) -> bool {
    let printed: Vec<&Token> = cell.iter().filter(|t| !is_space(t)).collect();
    matches!(printed.as_slice(), [one] if is_relation(one))
}

fn is_idle(token: &Token) -> bool {
    token.is("label") || token.is("tag")
}

fn is_braces(token: &Token) -> bool {
    matches!(token.kind, Kind::Open | Kind::Close)
}

fn is_colon_equals(tokens: &[Token], at: usize) -> bool {
    tokens[at].is_char(":") && tokens.get(at + 1).is_some_and(|t| t.is_char("="))
}

/// The sign that begins at a place, and the position after it: `:=`, `\not=`, `=`.
fn sign_at(tokens: &[Token], at: usize) -> (String, usize) {
    let spelled = |t: &Token| if t.kind == Kind::Command { format!("\\{}", t.text) } else { t.text.clone() };
    let mut next = at + 1;
    let mut sign = spelled(&tokens[at]);
    if is_colon_equals(tokens, at) {
        return (":=".to_owned(), at + 2);
    }
    if tokens[at].is("not") {
        while tokens.get(next).is_some_and(is_space) {
            next += 1;
        }
        if let Some(t) = tokens.get(next) {
            sign.push_str(&spelled(t));
            next += 1;
        }
    }
    // `<=` of two characters is no sign of mathematics, but `=:` is.
    if sign == "=" && tokens.get(next).is_some_and(|t| t.is_char(":")) {
        return ("=:".to_owned(), next + 1);
    }
    (sign, next)
}

/// A relation sign with something above or below it.
fn stacked(tokens: &[Token], at: usize) -> Option<(String, String, usize)> {
    let (words, middle) = group_text(tokens, at + 1);
    let (sign, end) = group_text(tokens, middle);
    let name = sign.trim();
    let known = matches!(name, "=" | "<" | ">") || name.strip_prefix('\\').is_some_and(|n| RELATIONS.contains(&n));
    (middle > at + 1 && end > middle && known).then(|| {
        // What stands above an equals sign says how it is meant: it is no plain one unless it is a reference.
        let plain = name == "=" && words.contains(['(', 'r']);
        (if plain { "=".to_owned() } else { format!("\\stackrel{{{words}}}{{{name}}}") }, words, end)
    })
}

/// Takes labels and tags out of a cell.
fn without_labels(tokens: &[Token]) -> (Vec<Token>, Option<String>, Option<String>) {
    let (mut label, mut tag) = (None, None);
    let mut out = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if token.is("label") || token.is("tag") {
            let star = usize::from(tokens.get(at + 1).is_some_and(|t| t.is_char("*")));
            let (text, after) = group_text(tokens, at + 1 + star);
            let text = diag::escape::in_one_line(&text);
            if token.is("label") {
                label = Some(text)
            } else {
                tag = Some(text)
            }
            at = after.max(at + 1);
            continue;
        }
        out.push(token.clone());
        at += 1;
    }
    (out, label.filter(|l| !l.is_empty()), tag)
}

/// A side made of these tokens.
fn side_of(tokens: &[Token]) -> PrintedSide {
    let mut kept: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        if token.kind == Kind::Command && matches!(token.text.as_str(), "hspace" | "vspace" | "hskip" | "vskip") {
            let star = usize::from(tokens.get(at).is_some_and(|t| t.is_char("*")));
            at = group_text(tokens, at + star).1;
        } else if token.is("text") && group_text(tokens, at) == ("d".to_owned(), at + 3) {
            // An upright differential, whichever command makes it upright.
            kept.push(Token { text: "mathrm".to_owned(), ..token.clone() });
        } else if token.kind == Kind::Command && is_space(token) || token.is_char("~") {
            // A space of any width is a space.
            kept.push(Token { kind: Kind::Space, text: " ".to_owned(), span: token.span.start..token.span.start });
        } else {
            kept.push(token.clone());
        }
    }
    let idle = |t: &Token| t.kind == Kind::Space;
    while kept.last().is_some_and(idle) {
        kept.pop();
    }
    let begin = kept.iter().take_while(|t| idle(t)).count();
    kept.drain(..begin);
    let text = shown(&mark::text_of(&kept)).into_owned();
    let mut is_list = false;
    walk(&kept, |i, outside| is_list |= outside && kept[i].is_char(","));
    PrintedSide { text, span: span_of(&kept), is_list, tokens: kept }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    fn read(environment: &str, text: &str) -> Vec<String> {
        read_spaced(environment, text)
            .iter()
            .map(|r| r.replace(" +", "+").replace(" -", "-").replace(" \\times", "\\times"))
            .collect()
    }

    fn read_spaced(environment: &str, text: &str) -> Vec<String> {
        let place = Place { environment, display: Some(0), section: 0 };
        relations(&tokens(text), &place)
            .iter()
            .map(|r| {
                let remark = r.remark.as_ref().map(|w| format!(" [{w}]")).unwrap_or_default();
                let sides: Vec<&str> = r.sides.iter().map(|s| s.text.as_str()).collect();
                let mut out = sides[0].to_owned();
                for (sign, side) in r.signs.iter().zip(&sides[1..]) {
                    out.push_str(&format!(" {sign} {side}"));
                }
                out + &remark
            })
            .collect()
    }

    #[test]
    fn columns_are_relations_of_their_own() {
        assert_eq!(read("align", r"u &= ab & v &= cd"), ["u = ab", "v = cd"]);
        assert_eq!(read("align", r"u &= ab & v &= cd \\ &= ba & &= dc"), ["u = ab = ba", "v = cd = dc"]);
        assert_eq!(read("alignat", r"a &= b &+ c"), ["a = b+ c"]);
        assert_eq!(read("align", r"x &= y && \text{by (3)}"), ["x = y [by (3)]"]);
        assert_eq!(read("align", r"x &= y & \text{for } z&>0"), ["x = y [for]", "z > 0"]);
        assert_eq!(read("eqnarray", r"a &=& b \\ &=& c"), ["a = b = c"]);
    }

    #[test]
    fn lines_go_on() {
        assert_eq!(read("align", r"E &= \frac12mv^2 \nonumber\\ &\quad+mgh"), [r"E = \frac12mv^2+mgh"]);
        assert_eq!(read("align", r"A &= (a+b)^2 \\ &= a^2+2ab+b^2"), ["A = (a+b)^2 = a^2+2ab+b^2"]);
        assert_eq!(read("multline", r"a = b \\ + c \\ - d"), ["a = b+ c- d"]);
        assert_eq!(read("align", r"a &= b \\ -c &= d"), ["a = b", "-c = d"]);
        assert_eq!(
            read("align", r"a &= \left(b \right. \\ & \left. c\right)"),
            [r"a = \left(b \right. \left. c\right)"]
        );
        assert_eq!(read("align", r"a &= x \\ &\quad \times y"), [r"a = x\times y"]);
        assert_eq!(read("equation", r"\begin{split} a &= b \\ &= c \end{split}"), ["a = b = c"]);
        assert_eq!(
            read("equation", r"\left\{\begin{aligned} a &= b \\ c &= d \end{aligned}\right."),
            ["a = b", "c = d"]
        );
        assert_eq!(read("equation", r"\begin{array}{rcl} a &=& b \\ &=& c \end{array}"), ["a = b = c"]);
        assert_eq!(read("gather", r"a = b \\ c = d"), ["a = b", "c = d"]);
    }

    #[test]
    fn what_is_between_brackets_is_not_cut() {
        assert_eq!(read("[", r"\Phi=\left\{T, V, n\right\}"), [r"\Phi = \left\{T, V, n\right\}"]);
        assert_eq!(read("[", r"\Phi=\{T, V, n\}"), [r"\Phi = \{T, V, n\}"]);
        assert_eq!(read("[", r"f(x,y)=1, \quad g=2."), ["f(x,y) = 1", "g = 2"]);
        assert_eq!(
            read("[", r"A=\begin{pmatrix}1&2\\3&4\end{pmatrix}."),
            [r"A = \begin{pmatrix}1&2\\3&4\end{pmatrix}"]
        );
        assert_eq!(read("[", r"x=1.5, y=2"), ["x = 1.5", "y = 2"]);
    }

    #[test]
    fn nothing_is_dropped() {
        assert_eq!(read("[", r"i=1,2,3"), ["i = 1,2,3"]);
        assert_eq!(read("[", r"a=b \text{ and } c=\text{const}"), ["a = b [and]", r"c = \text{const}"]);
        assert_eq!(read("[", r"a=b \quad (x>0)"), ["a = b", "(x>0)"]);
        assert_eq!(read("align", r"a &= b \\ \intertext{and so} c &= d"), ["a = b [and so]", "c = d"]);
        assert_eq!(read("[", r"a=b \Rightarrow c=d"), ["a = b", "c = d [⇒]"]);
        assert_eq!(read("[", r"a \stackrel{!}{=} b"), [r"a \stackrel{!}{=} b [!]"]);
        assert_eq!(read("[", r"x \not= y"), [r"x \not= y"]);
        assert_eq!(read("[", r"x := y"), [r"x := y"]);
    }

    #[test]
    fn every_mark_that_prints_is_somewhere() {
        let letters = |text: &str| {
            let text = text.replace(r"\Rightarrow", "");
            let mut found: Vec<char> = text.chars().filter(|c| c.is_ascii_uppercase()).collect();
            found.sort_unstable();
            found
        };
        for (environment, text) in [
            ("align", r"A &= B & C &= D \\ &\quad + E & &= F, \quad G \\ H && \text{I} & J"),
            ("equation", r"\left\{\begin{aligned} A &= B, C \\ D \end{aligned}\right. \qquad E \text{F} G"),
            ("gather", r"A \\ B = \\ C \\ + D \intertext{E} \Rightarrow F"),
            ("eqnarray", r"A &=& B \\ C & & D \\ & & E & F"),
            ("multline", r"A = B, \\ C \\ \text{D} = E"),
        ] {
            assert_eq!(letters(&read(environment, text).join(" ")), letters(text), "{text}");
        }
    }

    #[test]
    fn no_text_panics() {
        let text = r"\left\{\begin{aligned}a&=\left(b\right.\\&+c,\quad\stackrel{a}{=}\text{x}\not\end{aligned}\right.\Rightarrow\begin{array}{l}a&=&b\end{array}:=\intertext{a}";
        for environment in ["align", "equation", "multline", "eqnarray", ""] {
            for end in 0..text.len() {
                read(environment, &text[..end]);
            }
        }
    }
}
