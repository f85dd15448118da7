//! Rows → pieces: what stands between commas, wide spaces and words.

use super::super::mark::group_text;
use super::super::token::{Kind, Token};
use super::{BETWEEN_STATEMENTS, Nesting, WIDE_WORDS, WORDS, is_operator, is_relation, is_space, is_wide, walk};

/// A part of a row: what stands between commas, wide spaces and words.
#[derive(Default)]
pub(super) struct Piece {
    pub tokens: Vec<Token>,
    /// Words before it.
    pub words: Option<String>,
    /// A sign between statements stands before it.
    pub implied: bool,
    /// What separates it from the one before is a comma.
    pub comma: bool,
    /// What separates it is a wide space, or words.
    pub wide: bool,
    /// It ends with a comma, a semicolon or a full stop.
    pub ended: bool,
}

impl Piece {
    pub fn is_empty(&self) -> bool {
        self.tokens.iter().all(|t| is_space(t) || t.is_char("&"))
    }

    pub fn relates(&self) -> bool {
        let mut found = false;
        walk(&self.tokens, |i, outside| found |= outside && is_relation(&self.tokens[i]));
        found
    }

    pub fn first(&self) -> Option<&Token> {
        self.tokens.iter().find(|t| !is_space(t))
    }
}

/// Words behind which a condition stands.
pub(super) const CONDITIONAL: &[&str] = &[
    "for", "if", "when", "where", "with", "as", "at", "provided", "unless", "whenever", "only if", "for all", "given",
    "assuming", "on", "in",
];

/// The pieces of a row.
pub(super) fn pieces(tokens: &[Token]) -> Vec<Piece> {
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
        } else if outside && (token.is("qc") || token.is("qcomma")) {
            if let Some(piece) = out.last_mut() {
                piece.ended = true;
            }
            next = Some((Piece { comma: true, wide: true, ..Piece::default() }, at + 1));
        } else if outside
            && token.kind == Kind::Command
            && let Some(word) = token.text.strip_prefix('q').filter(|w| WIDE_WORDS.contains(w))
        {
            next = Some((Piece { words: Some(word.to_owned()), wide: true, ..Piece::default() }, at + 1));
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
