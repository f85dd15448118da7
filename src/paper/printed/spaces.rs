//! Spaces in a row: how wide they are together.

use super::super::mark::group_text;
use super::super::token::{Kind, Token};
use super::lengths::{is_wide_length, length};
use super::signs::is_wide;

/// Commands that print a wide space.
const WIDE: &[&str] = &["hfill", "hfil", "hfilneg", "enspace", "enskip"];
/// Commands that begin a line.
const BREAKS: &[&str] = &["break", "linebreak", "pagebreak", "newline", "par"];

/// The most tokens of spaces that are looked at.
const MOST_TOKENS: usize = 40;

/// Spaces that stand in a row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Spaces {
    /// How many small ones.
    pub small: usize,
    /// Whether a wide one is among them: a quad, a length, a fill.
    pub is_wide: bool,
    /// Whether a line is broken among them.
    pub breaks: bool,
    /// Where they end.
    pub end: usize,
}

impl Spaces {
    /// Those that begin with a command at a place; white space between them prints nothing.
    pub fn at(tokens: &[Token], at: usize) -> Spaces {
        let small = |t: &Token| {
            t.is_char("~")
                || t.kind == Kind::Command
                    && matches!(t.text.as_str(), ";" | " " | ":" | ">" | "," | "thickspace" | "medspace")
        };
        let mut found = Spaces { end: at, ..Spaces::default() };
        while let Some(token) = tokens.get(found.end) {
            let next = found.end + 1;
            if token.is("hspace") || token.is("phantom") || token.is("hphantom") {
                let star = usize::from(tokens.get(next).is_some_and(|t| t.is_char("*")));
                found.end = group_text(tokens, next + star).1;
                found.is_wide = true;
                continue;
            }
            if let Some((text, after)) = length(token, tokens, next) {
                found.end = after;
                found.is_wide |= is_wide_length(&text);
                continue;
            }
            if is_wide(token) || token.kind == Kind::Command && WIDE.contains(&token.text.as_str()) {
                found.is_wide = true;
            } else if token.kind == Kind::Command && BREAKS.contains(&token.text.as_str()) {
                found.breaks = true;
            } else if small(token) {
                found.small += 1;
            } else if token.kind != Kind::Space || found.end == at {
                break;
            }
            found.end = next;
        }
        found
    }

    /// Those that end at a place, white space apart.
    pub fn before(tokens: &[Token], end: usize) -> Spaces {
        let mut at = end.saturating_sub(MOST_TOKENS);
        while at < end {
            let found = Spaces::at(tokens, at);
            if found.end >= end {
                return found;
            }
            at = found.end.max(at + 1);
        }
        Spaces { end, ..Spaces::default() }
    }

    /// Those that begin at a place, white space apart.
    pub fn behind(tokens: &[Token], at: usize) -> Spaces {
        Spaces::at(tokens, at + tokens[at..].iter().take_while(|t| t.kind == Kind::Space).count())
    }
}
