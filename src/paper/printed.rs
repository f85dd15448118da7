//! Displays → printed relations: what a reader sees as one.
//!
//! **In:** the tokens of a display or of a formula of the running text. **Out:** its [`PrintedRelation`]s: the columns of an
//! `align` apart, continued lines joined, a chain over several lines as one. **Guaranteed:** every token that prints is in a
//! side or in a remark: nothing is dropped without a word.

mod by_hand;
mod cases;
mod frames;
mod groups;
mod last;
mod lengths;
mod pieces;
mod rows;
mod scripts;
mod side;
mod signs;
mod spaces;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::ops::Range;

use super::opening::{Opening, closes_case, is_link, opening};
use super::token::{Kind, Token};
use super::{fractions, unicode, upright};
use by_hand::ByHand;
use diag::escape::shown;
use last::Last;
use pieces::{Piece, pieces};
use rows::{Grid, Group, Row, rows, unwrapped};
pub(super) use scripts::with_braces;
use side::{is_colon_equals, side_of, sign_at, stacked, without_labels};
use signs::{BETWEEN_STATEMENTS, WIDE_WORDS, WORDS, is_wide};
pub(super) use signs::{is_equality, is_operator, is_relation, is_space};

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
    /// Words that are printed in the place of a last side, and are none: `=\text{angular velocity}`.
    pub described: Option<String>,
    /// What the words before it, in its display, make of it: "for x > 0".
    pub opening: Option<Opening>,
    /// Why what is printed here is not known, where it is not.
    pub unread: Option<String>,
    /// What stands behind it in parentheses: its number, or a factor.
    by_hand: Option<ByHand>,
    /// The last row of its display in which it stands, from 0.
    pub row: usize,
    /// The number of its display; `None` in the running text.
    pub display: Option<usize>,
    /// The number of its section.
    pub section: usize,
    /// The number of its chapter; 0 in a paper without chapters, and before the first.
    pub chapter: usize,
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

impl PrintedRelation {
    /// From its first to its last side.
    pub fn span(&self) -> Range<usize> {
        // A side that is missing stands nowhere.
        let start = self.sides.iter().filter(|s| !s.span.is_empty()).map(|s| s.span.start).min().unwrap_or(0);
        start..self.sides.iter().map(|s| s.span.end).max().unwrap_or(start)
    }

    /// Takes a last side that is words and nothing else, `\Omega=\dot\phi=\text{angular velocity}`, for what is said beside the others.
    fn describe(&mut self) {
        let ends = self.sides.len() > 2 && self.signs.last().is_some_and(|sign| sign == "=");
        let Some(words) = self.sides.last().filter(|_| ends).and_then(PrintedSide::words) else { return };
        self.sides.pop();
        self.signs.pop();
        self.described = Some(words);
    }

    /// Gives back the room that its lists do not use: a paper has hundreds of thousands.
    fn fit(&mut self) {
        self.signs.shrink_to_fit();
        self.sides.shrink_to_fit();
        for side in &mut self.sides {
            side.text.shrink_to_fit();
            side.tokens.shrink_to_fit();
        }
    }

    /// Whether its words make it say when another one holds, or what a name stands for.
    pub fn is_condition(&self) -> bool {
        matches!(self.opening, Some(Opening::Case | Opening::Remark | Opening::Meaning))
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

/// The most rows of a display that are looked at as one; more are told as one formula that is not read.
const MOST_TOKENS: usize = 200_000;

/// How deep a place lies in braces, brackets and environments.
#[derive(Clone, Copy, Debug, Default)]
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
fn walk(tokens: &[Token], each: impl FnMut(usize, bool)) -> Nesting {
    walk_from(Nesting::default(), tokens, each)
}

/// The same where the first lies in brackets.
fn walk_from(mut nesting: Nesting, tokens: &[Token], mut each: impl FnMut(usize, bool)) -> Nesting {
    let mut at = 0;
    while at < tokens.len() {
        let before = nesting.is_outside();
        let more = nesting.take(&tokens[at], &tokens[at + 1..]);
        each(at, before && nesting.is_outside());
        at += 1 + more;
    }
    nesting
}

/// Whether a sign of relation stands outside of all brackets.
fn relates(tokens: &[Token]) -> bool {
    let mut found = false;
    walk(tokens, |i, outside| found |= outside && is_relation(&tokens[i]));
    found
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

/// The terms of a side: what stands between plus and minus, outside of all brackets.
pub(super) fn terms(tokens: &[Token]) -> Vec<Vec<Token>> {
    let mut signs = Vec::new();
    let sign = |t: &Token| t.is_char("+") || t.is_char("-") || t.is("pm") || t.is("mp");
    walk(tokens, |i, outside| {
        if outside && sign(&tokens[i]) {
            signs.push(i);
        }
    });
    let mut out = Vec::new();
    let mut from = 0;
    for end in signs.into_iter().chain([tokens.len()]) {
        out.push(tokens[from..end].to_vec());
        from = end + 1;
    }
    out.retain(|t| !t.iter().all(is_space));
    out
}

/// What is known of a display.
pub(super) struct Place<'p> {
    /// The name of its environment; empty in the running text.
    pub environment: &'p str,
    /// Its number.
    pub display: Option<usize>,
    /// The number of its section.
    pub section: usize,
    /// The number of its chapter.
    pub chapter: usize,
}

impl PrintedSide {
    /// Whether it is a whole display that is longer than is taken apart.
    pub fn is_whole_display(&self) -> bool {
        self.tokens.len() > MOST_TOKENS
    }
}

/// The relations that a display prints.
pub(super) fn relations(body: &[Token], place: &Place<'_>) -> Vec<PrintedRelation> {
    let stacked = body.iter().any(|t| t.is("begin"));
    let mut found = Relations {
        place,
        out: Vec::new(),
        last: BTreeMap::new(),
        open: Vec::new(),
        ended: Vec::new(),
        indented: Vec::new(),
        stacked,
        row: 0,
    };
    if body.len() > MOST_TOKENS {
        found.put(0, side_of(body), None);
        return found.out;
    }
    let body = upright::plain(&fractions::plain(&unicode::plain(&unwrapped(body))));
    let rows = rows(&body);
    let grid = Grid::of(&rows, place.environment);
    for (number, row) in rows.into_iter().enumerate() {
        found.row = number;
        found.row(row, grid);
    }
    found.end();
    // A label of a display belongs to all that has none.
    let label = found.out.iter().find_map(|r| r.label.clone());
    if place.display.is_some() && found.out.iter().filter(|r| r.label.is_some()).count() == 1 {
        found.out.iter_mut().for_each(|r| r.label = label.clone());
    }
    found.out.retain(|r| !(r.sides.len() == 1 && r.sides[0].text.is_empty() && r.remark.is_none()));
    for relation in &mut found.out {
        relation.describe();
        relation.fit();
    }
    found.out
}

struct Relations<'p> {
    place: &'p Place<'p>,
    out: Vec<PrintedRelation>,
    /// The last side of each relation, which may go on: until the end of the display another stands in its place.
    last: BTreeMap<usize, Last>,
    /// For each column, the relation that may go on.
    open: Vec<Option<usize>>,
    /// Whether it ended with a comma or a full stop.
    ended: Vec<bool>,
    /// Whether its first row left the first cell empty.
    indented: Vec<bool>,
    /// Whether lines stand below each other by an environment of their own: a display alone has but one.
    stacked: bool,
    /// The row that is looked at.
    row: usize,
}

impl Relations<'_> {
    fn row(&mut self, row: Row, grid: Grid) {
        if let Some(words) = row.between {
            self.remark(&words);
        }
        let single = row.cells.len() == 1;
        let mut last = None;
        for group in grid.groups(&row.cells) {
            if self.open.len() <= group.column {
                self.open.resize(group.column + 1, None);
                self.ended.resize(group.column + 1, true);
                self.indented.resize(group.column + 1, false);
            }
            last = self.group(&group, last, single);
        }
    }

    /// Takes what stands in the cells of a group; `before` is the column of the row that has something before it.
    fn group(&mut self, group: &Group, before: Option<usize>, single: bool) -> Option<usize> {
        let (tokens, label, tag) = without_labels(&group.tokens);
        let layout = Layout { left_empty: group.left_empty && !single, single };
        let pieces = pieces(&tokens);
        let mut here = before;
        let mut column = group.column;
        let mut is_behind_relation = false;
        let mut is_meaning = false;
        for (k, piece) in pieces.into_iter().enumerate() {
            let words = piece.words.clone();
            let links = words.as_deref().is_some_and(is_link);
            // "where A=1, B=2 and C=3": all of these are meanings.
            let goes_on_meaning = is_meaning && piece.relates() && (links || words.is_none());
            let opening = words.as_deref().filter(|_| !goes_on_meaning).and_then(opening);
            let opening = opening.or_else(|| (piece.in_parentheses || goes_on_meaning).then_some(Opening::Meaning));
            if words.as_deref().is_some_and(closes_case)
                && let Some(last) = self.out.last_mut()
            {
                last.opening = Some(Opening::Case);
            }
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
                && let Some(beside) = before.or_else(|| (0..column).rev().find(|&c| self.open[c].is_some()))
            {
                column = beside;
            }
            let goes_on = match k {
                0 => self.goes_on(&piece, column, layout),
                _ => begins && !piece.implied && !piece.comma && !self.is_apart(&piece, column, is_behind_relation),
            };
            // A value behind another, `x=1 or -1`: neither is what the left is equal to.
            let relates = self.open[column].is_some_and(|at| self.out[at].sides.len() > 1);
            let is_value = links && relates && !piece.relates() && !piece.implied;
            let is_beside = piece.comma && !piece.wide && k > 0;
            let list = is_beside && (!piece.relates() || self.lists_names(&piece, column)) || is_value;
            is_behind_relation |= piece.relates();
            is_meaning = opening == Some(Opening::Meaning);
            let ended = piece.ended;
            if (goes_on || list)
                && let Some(at) = self.open[column]
            {
                self.append(at, &piece.tokens, list);
            } else {
                self.begin(&piece, column, opening);
                self.indented[column] = layout.left_empty;
            }
            if group.is_unclear
                && let Some(at) = self.open[column]
            {
                self.out[at].sides.iter_mut().for_each(|side| side.is_list = true);
            }
            if let Some(at) = self.open[column] {
                let relation = &mut self.out[at];
                relation.by_hand = piece.by_hand.or(relation.by_hand.take());
                relation.unread = relation.unread.take().or(piece.word_in_doubt.as_deref().map(product_or_word));
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
        if self.open[column].is_none() {
            return false;
        }
        let Some(first) = piece.first() else { return false };
        if piece.implied {
            return false;
        }
        // Words between two values, or before an equation with a sign: neither goes on from the other.
        if piece.words.as_deref().is_some_and(is_link) && is_operator(first) {
            return false;
        }
        let unfinished = self.waits(column);
        let lines = matches!(
            self.place.environment.trim_end_matches('*'),
            "multline" | "equation" | "dmath" | "displaymath" | "[" | "$$"
        );
        // A row with a sign and an equation of its own goes on from the row before where it begins behind that one's beginning.
        let signed = piece.relates() && matches!(first.text.as_str(), "-" | "−" | "pm" | "mp");
        let behind = match signed {
            true => {
                layout.left_empty && (!self.indented[column] || piece.wide) || lines && layout.single && !self.stacked
            }
            false => layout.left_empty || !piece.relates() || lines && layout.single,
        };
        unfinished
            || is_relation(first)
            || is_operator(first) && behind
            || !piece.relates() && !self.ended[column] && (layout.left_empty || lines)
    }

    /// Whether a piece with a sign at its beginning, behind another in its row, is a formula of its own: it relates something, and words or a wide
    /// space stand before its sign; or it is a value with a sign.
    fn is_apart(&self, piece: &Piece, column: usize, is_behind_relation: bool) -> bool {
        let signed = piece.first().is_some_and(|t| matches!(t.text.as_str(), "-" | "−" | "pm" | "mp"));
        piece.wide && signed && piece.relates() && is_behind_relation && !self.waits(column)
    }

    /// Whether what stands before a comma is equal to the same: `r_1, r_2 = -p\pm q` says something of both, and what belongs to which is
    /// not printed. That `x, y > 0` says something of `y` is true.
    fn lists_names(&self, piece: &Piece, column: usize) -> bool {
        let is_lone = self.open[column].is_some_and(|at| self.out[at].sides.len() == 1);
        let mut sign = None;
        walk(&piece.tokens, |i, outside| {
            if outside && sign.is_none() && is_relation(&piece.tokens[i]) {
                sign = Some(&piece.tokens[i]);
            }
        });
        is_lone && sign.is_some_and(is_equality)
    }

    /// Whether the formula of a column is not yet complete.
    fn waits(&self, column: usize) -> bool {
        self.open[column].and_then(|at| self.last.get(&at)).is_some_and(Last::waits)
    }

    /// Puts the last sides in their places.
    fn end(&mut self) {
        for (at, mut last) in std::mem::take(&mut self.last) {
            if let Some(place) = self.out.get_mut(at).and_then(|r| r.sides.last_mut()) {
                let mut side = last.side();
                side.is_list |= place.is_list;
                *place = side;
            }
        }
    }

    fn begin(&mut self, piece: &Piece, column: usize, opening: Option<Opening>) {
        let remark = piece.implied.then(|| "⇒".to_owned());
        let at = self.put(column, side_of(&[]), remark);
        self.out[at].opening = opening;
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
            described: None,
            opening: None,
            unread: None,
            by_hand: None,
            row: self.row,
            display: self.place.display,
            section: self.place.section,
            chapter: self.place.chapter,
        });
        if let Some(open) = self.open.get_mut(column) {
            *open = Some(at);
        }
        at
    }

    /// Adds tokens to the last side of a relation; signs among them begin further sides.
    fn append(&mut self, at: usize, tokens: &[Token], list: bool) {
        let relation = &mut self.out[at];
        relation.row = self.row;
        let last = self.last.entry(at).or_default();
        if list {
            last.begin_another();
        }
        let mut remarked = None;
        // What is read in this row, and is not yet a part of the side.
        let mut current: Vec<Token> = Vec::new();
        let mut ends = |last: &mut Last, current: &mut Vec<Token>, sign: String| {
            last.add(&std::mem::take(current));
            let mut side = last.side();
            if let Some(place) = relation.sides.last_mut() {
                side.is_list |= place.is_list;
                *place = side;
            }
            relation.sides.push(side_of(&[]));
            relation.signs.push(sign);
        };
        let mut i = 0;
        while i < tokens.len() {
            let token = &tokens[i];
            let over =
                matches!(token.text.as_str(), "stackrel" | "overset" | "underset") && token.kind == Kind::Command;
            if last.nesting.is_outside()
                && over
                && let Some((sign, words, after)) = stacked(tokens, i)
            {
                ends(last, &mut current, sign);
                remarked.get_or_insert(words);
                i = after;
                continue;
            }
            if last.nesting.is_outside() && (is_relation(token) || token.is("not") || is_colon_equals(tokens, i)) {
                let (sign, after) = sign_at(tokens, i);
                ends(last, &mut current, sign);
                i = after;
                continue;
            }
            let more = last.nesting.take(token, &tokens[i + 1..]);
            let end = (i + 1 + more).min(tokens.len());
            current.extend_from_slice(&tokens[i..end]);
            i = end;
        }
        last.add(&current);
        relation.remark = relation.remark.take().or(remarked);
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
                    described: None,
                    opening: None,
                    unread: None,
                    by_hand: None,
                    row: self.row,
                    display: self.place.display,
                    section: self.place.section,
                    chapter: self.place.chapter,
                });
            }
        }
    }
}

/// Takes relations for unread behind which a number or a factor stands, which of them is not known.
pub(super) fn settle_numbers(relations: &mut [PrintedRelation]) {
    let all: Vec<&ByHand> = relations.iter().filter_map(|r| r.by_hand.as_ref()).collect();
    let are_numbers = by_hand::are_numbers(&all);
    for relation in relations {
        let doubt = relation.by_hand.as_ref().and_then(|by_hand| by_hand.doubt(are_numbers));
        relation.unread = relation.unread.take().or(doubt);
    }
}

/// Why a formula is not read beside which letters stand that may be a word.
fn product_or_word(word: &str) -> String {
    format!("whether `{word}` is a word or a product of letters is not known: words stand in `\\text`")
}

/// How what stands in a row is aligned.
#[derive(Clone, Copy)]
struct Layout {
    /// Nothing stands before the sign of alignment.
    left_empty: bool,
    /// There is no sign of alignment.
    single: bool,
}
