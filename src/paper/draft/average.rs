//! Averages of one name, as names of their own: `\langle E\rangle` is `E_{\text{mean}}`.
//!
//! **In:** the sides of a formula. **Out:** the same with such names. **Guaranteed:** only where all angle brackets of a formula hold one name and
//! nothing else, with no bar and no subscript behind them: averages of products, bras and kets are none.

use super::super::mark;
use super::super::names::letters::{BOLD, is_letter_command};
use super::super::printed::PrintedSide;
use super::super::token::{Kind, Token};

/// What stands below the name of an average.
const BELOW: &str = "mean";

/// The sides with names for averages.
pub(super) fn named(sides: &[&PrintedSide]) -> Option<Vec<PrintedSide>> {
    if sides.iter().any(|s| s.text.contains(BELOW)) {
        return None;
    }
    sides.iter().map(|side| of_side(side)).collect()
}

fn of_side(side: &PrintedSide) -> Option<PrintedSide> {
    let all = side.tokens.as_slice();
    let mut tokens: Vec<Token> = Vec::with_capacity(all.len());
    let mut at = 0;
    while let Some(token) = all.get(at) {
        at += 1;
        if !token.is("langle") {
            if token.is("rangle") {
                return None;
            }
            tokens.push(token.clone());
            continue;
        }
        let end = at + all[at..].iter().position(|t| t.is("rangle"))?;
        let mut inside: Vec<&Token> = all[at..end].iter().filter(|t| t.kind != Kind::Space).collect();
        inside.pop_if(|t| t.is("right"));
        tokens.pop_if(|t| t.is("left"));
        tokens.extend(name(&inside, token)?);
        at = end + 1;
        let mut behind = all[at..].iter().skip_while(|t| matches!(t.kind, Kind::Close | Kind::Space));
        if behind.next().is_some_and(|t| t.is_char("_")) {
            return None;
        }
    }
    Some(PrintedSide { text: mark::text_of(&tokens), tokens, ..side.clone() })
}

fn token_like(token: &Token, text: &str) -> Token {
    Token { kind: Kind::Other, text: text.into(), span: token.span.clone() }
}

/// The name of the average of what stands in brackets; `None` where that is no name.
fn name(inside: &[&Token], at: &Token) -> Option<Vec<Token>> {
    let inside = bare(inside);
    let split = inside.iter().position(|t| t.is_char("_")).unwrap_or(inside.len());
    let (base, below) = inside.split_at(split);
    let letter = match bare(base) {
        [style, letter @ ..] if style.kind == Kind::Command && BOLD.contains(&style.text.as_str()) => bare(letter),
        letter => letter,
    };
    let [one] = letter else { return None };
    let is_letter = match one.kind {
        Kind::Other => one.text.chars().all(|c| c.is_ascii_alphabetic()),
        Kind::Command => is_letter_command(&one.text),
        _ => false,
    };
    let below = bare(below.get(1..).unwrap_or_default());
    let is_label = below.iter().all(|t| t.kind == Kind::Other && t.text.chars().all(char::is_alphanumeric));
    if !is_letter || !is_label {
        return None;
    }
    let sign = |kind: Kind, text: &str| Token { kind, ..token_like(at, text) };
    let mut out: Vec<Token> = bare(base).iter().map(|t| (*t).clone()).collect();
    out.extend([sign(Kind::Other, "_"), sign(Kind::Open, "{")]);
    out.extend(below.iter().map(|t| (*t).clone()));
    out.extend((!below.is_empty()).then(|| sign(Kind::Other, ",")));
    out.extend([sign(Kind::Command, "text"), sign(Kind::Open, "{")]);
    out.extend(BELOW.chars().map(|c| sign(Kind::Other, c.encode_utf8(&mut [0; 4]))));
    out.extend([sign(Kind::Close, "}"), sign(Kind::Close, "}")]);
    Some(out)
}

/// What stands in braces around all of it.
fn bare<'a, 't>(mut all: &'a [&'t Token]) -> &'a [&'t Token] {
    while let [open, inside @ .., close] = all
        && (open.kind, close.kind) == (Kind::Open, Kind::Close)
        && is_balanced(inside)
    {
        all = inside;
    }
    all
}

fn is_balanced(all: &[&Token]) -> bool {
    let mut depth = 0i32;
    let closes_first = all.iter().any(|t| {
        depth += i32::from(t.kind == Kind::Open) - i32::from(t.kind == Kind::Close);
        depth < 0
    });
    !closes_first && depth == 0
}
