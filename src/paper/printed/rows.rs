//! Displays → rows and cells: what only says where lines are broken is gone.

use super::super::mark::{self, INNER, group_text};
use super::super::token::{Kind, Token};
use super::{Nesting, is_relation, is_space};

/// A row of a display.
#[derive(Default)]
pub(super) struct Row {
    pub cells: Vec<Vec<Token>>,
    /// What stands between it and the row before, in words.
    pub between: Option<String>,
}

/// A display without environments that only say where its lines are broken, and without a brace that encloses all.
pub(super) fn unwrapped(body: &[Token]) -> Vec<Token> {
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
