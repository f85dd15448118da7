//! Fractions of plain TeX → those of LaTeX: `{a \over b}` prints what `\frac{a}{b}` does.
//!
//! **In:** tokens. **Out:** tokens with `\frac` in the place of each `\over` that stands alone in its group. **Guaranteed:** two of them in one
//! group, which TeX refuses, stay as they are, and so does one outside of all groups; the time grows as the text does.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use super::printed::{is_operator, is_relation, is_space};
use super::token::{Kind, Token};

/// A group with one `\over` in it, by the places of its tokens.
struct Fraction {
    open: usize,
    over: usize,
    close: usize,
}

/// Tokens in which fractions are written with `\frac`.
pub(super) fn plain(tokens: &[Token]) -> Cow<'_, [Token]> {
    if !tokens.iter().any(|t| t.is("over")) {
        return Cow::Borrowed(tokens);
    }
    let all = fractions(tokens);
    // What is written at a token; nothing where it stays.
    let mut instead: BTreeMap<usize, &[&str]> = BTreeMap::new();
    let mut own_ends = BTreeSet::new();
    for Fraction { open, over, close } in all {
        // The braces of an argument, or of a script, stay; so do those with a power behind them.
        let is_own = is_own(tokens, open, &own_ends) && !is_raised(tokens, close);
        instead.insert(open, if is_own { &[r"\frac", "{"] } else { &["{", r"\frac", "{"] });
        instead.insert(over, &["}", "{"]);
        let spaces = (open..over).rev().take_while(|&i| tokens[i].kind == Kind::Space);
        instead.extend(spaces.map(|i| (i, &[][..])));
        instead.insert(close, if is_own { &["}"] } else { &["}", "}"] });
        if is_own {
            own_ends.insert(close);
        }
    }
    let mut out = Vec::with_capacity(tokens.len() + instead.len() * 2);
    for (at, token) in tokens.iter().enumerate() {
        match instead.get(&at) {
            Some(texts) => out.extend(texts.iter().map(|text| {
                let (kind, text) = match *text {
                    "{" => (Kind::Open, "{"),
                    "}" => (Kind::Close, "}"),
                    command => (Kind::Command, command.trim_start_matches('\\')),
                };
                Token { kind, text: text.into(), span: token.span.clone() }
            })),
            None => out.push(token.clone()),
        }
    }
    Cow::Owned(out)
}

/// The groups that are a fraction, in the order in which they open.
fn fractions(tokens: &[Token]) -> Vec<Fraction> {
    // Of each open group: where it opens, where its first `\over` stands, and whether it may be one fraction.
    let mut open: Vec<(usize, Option<usize>, bool)> = Vec::new();
    let mut out = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        match token.kind {
            Kind::Open => open.push((at, None, true)),
            Kind::Close => {
                if let Some((begin, Some(over), true)) = open.pop() {
                    let is_printed = |all: &[Token]| all.iter().any(|t| !is_space(t));
                    if is_printed(&tokens[begin + 1..over]) && is_printed(&tokens[over + 1..at]) {
                        out.push(Fraction { open: begin, over, close: at });
                    }
                }
            }
            Kind::Command if token.is("over") => {
                if let Some((_, over, may)) = open.last_mut() {
                    *may &= over.replace(at).is_none();
                }
            }
            // What is aligned, or relates, is no numerator.
            _ => {
                let parts = ["atop", "choose", "begin", "\\", "cr"].iter().any(|c| token.is(c));
                if (parts || token.is_char("&") || is_relation(token))
                    && let Some((_, _, may)) = open.last_mut()
                {
                    *may = false;
                }
            }
        }
    }
    out.sort_by_key(|fraction| fraction.open);
    out
}

/// Whether a group that opens there stands by itself: no command takes it for its argument, and it is no script.
fn is_own(tokens: &[Token], open: usize, own_ends: &BTreeSet<usize>) -> bool {
    let Some(before) = (0..open).rev().find(|&i| !is_space(&tokens[i])) else { return true };
    let token = &tokens[before];
    match token.kind {
        Kind::Close => own_ends.contains(&before),
        Kind::Command => is_operator(token) || is_relation(token),
        // `\frac1{a\over b}`: the second argument.
        Kind::Other => {
            let command = tokens[..before].iter().rev().find(|t| !is_space(t)).filter(|t| t.kind == Kind::Command);
            let takes = command.is_some_and(|t| !is_operator(t) && !is_relation(t));
            !takes && !matches!(token.text.as_str(), "_" | "^" | "]")
        }
        Kind::Open => true,
        Kind::Dollar | Kind::Space | Kind::Argument => false,
    }
}

/// Whether a script, or a prime, stands behind a group.
fn is_raised(tokens: &[Token], close: usize) -> bool {
    let next = tokens[close + 1..].iter().find(|t| !is_space(t));
    next.is_some_and(|t| matches!(t.text.as_str(), "^" | "_" | "'"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::token::tokens as tokens_of;

    fn shown(text: &str) -> String {
        let command =
            |t: &Token| if t.kind == Kind::Command { format!("\\{} ", t.text.as_str()) } else { t.text.to_string() };
        plain(&tokens_of(text)).iter().map(command).collect::<String>().replace(' ', "")
    }

    #[test]
    fn what_is_over_something_is_a_fraction() {
        for (text, wanted) in [
            (r"{a\over b}", r"\frac{a}{b}"),
            (r"{{a\over b}\over c}", r"\frac{\frac{a}{b}}{c}"),
            (r"x^{1\over2}", r"x^{\frac{1}{2}}"),
            (r"{dx\over dt}", r"\frac{dx}{dt}"),
            (r"\sqrt{a+b\over2}", r"\sqrt{\frac{a+b}{2}}"),
            (r"={1\over2}{d\over dt}x", r"=\frac{1}{2}\frac{d}{dt}x"),
            (r"{a\over b}^2", r"{\frac{a}{b}}^2"),
            (r"\frac1{c\over b}", r"\frac1{\frac{c}{b}}"),
            (r"\mathbf{a}{c\over b}", r"\mathbf{a}{\frac{c}{b}}"),
        ] {
            assert_eq!(shown(text), wanted, "{text}");
        }
        for text in [
            r"{a\over b\over c}",
            r"a\over b",
            r"{\over b}",
            r"{a\over}",
            r"{a&\over b}",
            r"{a\overline b}",
            r"{a=b\over c}",
        ] {
            assert_eq!(shown(text), text.replace(' ', ""), "{text}");
        }
    }
}
