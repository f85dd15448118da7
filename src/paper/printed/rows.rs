//! Displays → rows and cells: what only says where lines are broken is gone; rows → groups: which cells of a row print one formula.
//!
//! **In:** the tokens of a display. **Out:** its rows, and for each row its [`Group`]s with their columns. **Guaranteed:** every cell is in one
//! group. Two cells are one formula where the first waits for more (it ends with a sign, or in an open bracket), where the second begins with a
//! sign of relation, or where the columns of the environment are halves of one formula; two equations side by side never are.

use super::super::mark::{self, INNER, group_text};
use super::super::token::{Kind, Token};
use super::frames::opened;
use super::side::without_labels;
use super::{Nesting, is_operator, is_relation, is_space, is_wide, relates, walk, walk_from};

/// A row of a display.
#[derive(Default)]
pub(super) struct Row {
    pub cells: Vec<Vec<Token>>,
    /// What stands between it and the row before, in words.
    pub between: Option<String>,
}

/// Commands of plain TeX around rows.
const PLAIN_ROWS: &[&str] = &["eqalign", "eqalignno", "leqalignno", "displaylines"];

/// What stands between the braces that open there.
fn group(tokens: &[Token], at: usize) -> Option<std::ops::Range<usize>> {
    let open = at + tokens.get(at..)?.iter().take_while(|t| t.kind == Kind::Space).count();
    if tokens.get(open)?.kind != Kind::Open {
        return None;
    }
    let mut depth = 0i32;
    let close = (open..tokens.len()).find(|&i| {
        depth += i32::from(tokens[i].kind == Kind::Open) - i32::from(tokens[i].kind == Kind::Close);
        depth == 0
    })?;
    Some(open + 1..close)
}

/// A display without environments that only say where its lines are broken, and without a brace that encloses all.
pub(super) fn unwrapped(body: &[Token]) -> Vec<Token> {
    let mut body = opened(body.to_vec());
    if let Some(inside) = without_brace(&body) {
        body = inside;
    }
    let mut out = Vec::with_capacity(body.len());
    let mut nesting = Nesting::default();
    let mut at = 0;
    while at < body.len() {
        let token = &body[at];
        if nesting.is_outside()
            && PLAIN_ROWS.iter().any(|command| token.is(command))
            && let Some(inside) = group(&body, at + 1)
        {
            out.extend_from_slice(&body[inside.clone()]);
            at = inside.end + 1;
            continue;
        }
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

/// Whether the array that begins here has rows `left & = & right`, or is all that is printed and has an equation in each row.
fn is_table_of_relations(body: &[Token], at: usize) -> bool {
    if body[at].is("end") {
        return false;
    }
    let after = group_text(body, group_text(body, at + 1).1).1;
    let mut nesting = Nesting::default();
    let mut rows: Vec<Vec<Vec<Token>>> = vec![vec![Vec::new()]];
    let mut next = after;
    while let Some(token) = body.get(next) {
        let outside = nesting.is_outside();
        if outside && token.is("end") {
            break;
        }
        let more = nesting.take(token, &body[next + 1..]);
        let Some(row) = rows.last_mut() else { break };
        if outside && (token.is("\\") || token.is("cr")) {
            rows.push(vec![Vec::new()]);
        } else if outside && token.is_char("&") {
            row.push(Vec::new());
        } else if !is_space(token)
            && let Some(cell) = row.last_mut()
        {
            cell.extend_from_slice(&body[next..(next + 1 + more).min(body.len())]);
        }
        next += 1 + more;
    }
    // It must be all that is printed: a matrix in a formula is none.
    let alone = body[..at].iter().all(is_space);
    let in_three = |row: &[Vec<Token>]| row.len() == 3 && matches!(row[1].as_slice(), [one] if is_relation(one));
    let end = group_text(body, next + 1).1.min(body.len());
    let ends = without_labels(&body[end..]).0.iter().all(|t| is_space(t) || t.is_char(".") || t.is_char(","));
    rows.retain(|row| row.iter().any(|cell| !cell.is_empty()));
    let is_equation = |row: &Vec<Vec<Token>>| matches!(row.as_slice(), [one] if relates(one));
    alone && (rows.first().is_some_and(|row| in_three(row)) || ends && rows.len() > 1 && rows.iter().all(is_equation))
}

/// The rows of a display, each in cells.
pub(super) fn rows(body: &[Token]) -> Vec<Row> {
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

/// Cells of a row that print one formula.
#[derive(Debug, Default)]
pub(super) struct Group {
    pub tokens: Vec<Token>,
    /// The column of its first cell, in groups of the environment.
    pub column: usize,
    /// The column of its last cell.
    last: usize,
    /// Nothing stands before its sign of alignment.
    pub left_empty: bool,
    /// Two equations are set without a space between them: it is not known whether they are a chain.
    pub is_unclear: bool,
    /// How deep its end lies in brackets, and whether it relates something: it is not walked through anew for each cell that is added.
    end: Nesting,
    relates: bool,
}

impl Group {
    /// Takes more tokens.
    fn add(&mut self, mut tokens: Vec<Token>) {
        let mut found = false;
        self.end = walk_from(self.end, &tokens, |i, outside| found |= outside && is_relation(&tokens[i]));
        self.relates |= found;
        self.tokens.append(&mut tokens);
    }

    /// Whether it waits for more: it ends with a sign, or in an open bracket.
    fn waits(&self) -> bool {
        ends_with_sign(&self.tokens) || self.end.brackets > 0
    }
}

/// How the cells of a display are one formula.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    /// How many cells are one formula, if they are all filled.
    width: usize,
    /// Columns stand side by side without a space.
    is_tight: bool,
    /// Terms of one side stand in columns of their own: each row is one equation.
    has_columns_of_terms: bool,
}

impl Grid {
    /// The grid of a display.
    pub fn of(rows: &[Row], environment: &str) -> Grid {
        let is_tight = environment.starts_with("alignat") || environment.starts_with("xalignat");
        let mut grid = Grid { width: width(rows, environment), is_tight, has_columns_of_terms: false };
        grid.has_columns_of_terms = rows.iter().any(|row| {
            let all = grid.groups(&row.cells);
            all.iter().any(|g| {
                g.last > g.column
                    && !g.left_empty
                    && row.cells.iter().skip(1).any(|c| first(c).is_some_and(is_operator))
            })
        });
        grid
    }

    /// The groups of a row.
    pub fn groups(self, cells: &[Vec<Token>]) -> Vec<Group> {
        let mut out: Vec<Group> = Vec::new();
        // The last one in which something is printed.
        let mut printed = None;
        for (column, chunk) in cells.chunks(self.width).enumerate() {
            let left_empty = cells.len() > 1 && is_blank(&chunk[0]);
            let mut group =
                Group { column, last: column, left_empty, is_unclear: has_border(chunk), ..Group::default() };
            group.add(chunk.concat());
            let before = printed.and_then(|at: usize| out.get_mut(at));
            match before {
                Some(before) if self.is_one(before, &group) => {
                    before.add(group.tokens);
                    before.last = column;
                    before.left_empty &= !self.has_columns_of_terms;
                    before.is_unclear |= group.is_unclear;
                }
                _ => {
                    printed = if is_blank(&group.tokens) { printed } else { Some(out.len()) };
                    out.push(group);
                }
            }
        }
        out
    }

    /// Whether a group prints one formula with the one before it in its row.
    fn is_one(self, before: &Group, group: &Group) -> bool {
        let Some(first) = first(&group.tokens) else { return false };
        if is_ended(&before.tokens) {
            return false;
        }
        if before.waits() {
            return true;
        }
        // What goes on from the row above has nothing to do with the column beside it.
        let is_begun = self.has_columns_of_terms || !before.left_empty && !goes_on(&before.tokens);
        let relates = before.relates;
        if is_relation(first) {
            let is_beside = !group.left_empty && (self.width > 1 || !goes_on(&before.tokens));
            return is_beside || !relates && is_begun;
        }
        let is_apart = begins_wide(&group.tokens) || is_in_parentheses(before) || group.left_empty;
        let is_next = before.last + 1 == group.column || self.has_columns_of_terms;
        let is_term = if relates { self.is_tight } else { is_begun && is_next };
        is_operator(first) && !is_apart && is_term
    }
}

/// How many cells of a display are one formula, if they are all filled.
fn width(rows: &[Row], environment: &str) -> usize {
    if environment.starts_with("eqnarray") {
        // Columns with space between them: two equations in one row are two.
        return if rows.iter().any(|row| has_border(&row.cells)) { 1 } else { 3 };
    }
    let count = rows.iter().map(|row| row.cells.len()).max().unwrap_or(0);
    let signs = columns_of_signs(rows, count);
    let are_middle = !signs.is_empty() && signs.iter().all(|column| column % 3 == 1);
    if are_middle && count > 2 { 3 } else { 2 }
}

/// The columns that have signs of relation, each alone in its cell, and nothing else.
fn columns_of_signs(rows: &[Row], count: usize) -> Vec<usize> {
    // Of each column, whether it has a sign, and whether it has something else.
    let mut found = vec![(false, false); count];
    for row in rows {
        for (cell, of) in row.cells.iter().zip(&mut found).filter(|(cell, _)| !is_blank(cell)) {
            let is_sign = is_sign_alone(cell);
            *of = (of.0 || is_sign, of.1 || !is_sign);
        }
    }
    (0..count).filter(|&column| found[column] == (true, false)).collect()
}

/// Whether two equations stand beside each other in these cells.
fn has_border(cells: &[Vec<Token>]) -> bool {
    let printed: Vec<&Vec<Token>> = cells.iter().filter(|cell| !is_blank(cell)).collect();
    printed.windows(2).any(|two| is_border(two[0], two[1]))
}

/// Whether two cells are two equations: both relate, and no sign stands between them.
fn is_border(left: &[Token], right: &[Token]) -> bool {
    relates(left) && relates(right) && !waits(left) && !is_ended(left) && !goes_on(right) && !begins_wide(right)
}

/// Whether a formula begins with a sign that wants something before it.
fn goes_on(tokens: &[Token]) -> bool {
    first(tokens).is_some_and(|t| is_relation(t) || is_operator(t))
}

/// Whether a formula waits for more: it ends with a sign, or in an open bracket.
fn waits(tokens: &[Token]) -> bool {
    ends_with_sign(tokens) || walk(tokens, |_, _| {}).brackets > 0
}

fn ends_with_sign(tokens: &[Token]) -> bool {
    let last = tokens.iter().rev().find(|t| !is_space(t) && !is_brace(t));
    last.is_some_and(|t| is_operator(t) || is_relation(t))
}

/// Whether a mark of the sentence, or a wide space, ends a formula.
fn is_ended(tokens: &[Token]) -> bool {
    let mut spaces = tokens.iter().rev().take_while(|t| is_space(t));
    let last = tokens.iter().rev().find(|t| !is_space(t));
    spaces.any(is_wide) || last.is_some_and(|t| t.is_char(",") || t.is_char(";") || t.is_char("."))
}

fn begins_wide(tokens: &[Token]) -> bool {
    tokens.iter().take_while(|t| is_space(t)).any(is_wide)
}

/// Whether parentheses are all of it: a number of a line, `(2)`.
fn is_in_parentheses(group: &Group) -> bool {
    let printed: Vec<&Token> = group.tokens.iter().filter(|t| !is_space(t)).collect();
    printed.first().is_some_and(|t| t.is_char("(")) && printed.last().is_some_and(|t| t.is_char(")"))
}

fn first(tokens: &[Token]) -> Option<&Token> {
    tokens.iter().find(|t| !is_space(t) && !is_brace(t))
}

fn is_brace(token: &Token) -> bool {
    matches!(token.kind, Kind::Open | Kind::Close)
}

/// Whether nothing is printed in a cell.
fn is_blank(cell: &[Token]) -> bool {
    without_labels(cell).0.iter().all(|t| is_space(t) || is_brace(t))
}

fn is_sign_alone(cell: &[Token]) -> bool {
    let printed: Vec<&Token> = cell.iter().filter(|t| !is_space(t) && !is_brace(t)).collect();
    matches!(printed.as_slice(), [one] if is_relation(one))
}
