//! Braces that part what a reader sees as one: `{a\times\Bigl(}{b+c\Bigr)}`.
//!
//! **In:** the tokens of a side. **Out:** the same without such braces. **Guaranteed:** braces around an argument, a script or what is complete by
//! itself stay.

use super::super::takes::Wanted;
use super::super::token::{Kind, Token};
use super::is_space;

/// Takes braces away that are no argument, where a bracket is opened or closed inside that is closed or opened outside, or a sign ends the
/// group.
pub(super) fn without_parting(tokens: Vec<Token>) -> Vec<Token> {
    let mut dropped = vec![false; tokens.len()];
    let mut at = 0;
    // What the command before wants, and whether it stands right before.
    let (mut wanted, mut is_command) = (Wanted::Nothing, false);
    while let Some(token) = tokens.get(at) {
        match token.kind {
            Kind::Space => at += 1,
            Kind::Open => {
                let end = closing(&tokens, at);
                if !wanted.takes_group() && end < tokens.len() && parts(&tokens[at + 1..end]) {
                    dropped[at] = true;
                    dropped[end] = true;
                }
                (wanted, is_command) = (wanted.less_one(true), false);
                at = end + 1;
            }
            // `\operatorname*{a}`, `\sqrt[3]{a}`
            _ if is_command && wanted.takes_group() && token.is_char("*") => at += 1,
            _ if is_command && wanted.takes_group() && token.is_char("[") => {
                at = behind_option(&tokens, at);
                is_command = false;
            }
            _ => {
                let left = wanted.less_one(false);
                let own = Wanted::by(token);
                wanted = if own == Wanted::Nothing { left } else { own };
                is_command = token.kind == Kind::Command && token.text.starts_with(|c: char| c.is_ascii_alphabetic());
                at += 1;
            }
        }
    }
    let mut dropped = dropped.into_iter();
    let mut tokens = tokens;
    tokens.retain(|_| dropped.next() != Some(true));
    tokens
}

/// The place behind an option in brackets; of a bracket that is not closed, that behind it.
fn behind_option(tokens: &[Token], at: usize) -> usize {
    let (mut brackets, mut braces) = (0i32, 0i32);
    let end = (at..tokens.len()).find(|&i| {
        let token = &tokens[i];
        braces += i32::from(token.kind == Kind::Open) - i32::from(token.kind == Kind::Close);
        brackets += i32::from(token.is_char("[")) - i32::from(token.is_char("]"));
        brackets == 0 && braces == 0 || braces < 0
    });
    end.map_or(at + 1, |end| end + 1)
}

/// Where the group ends that begins here.
fn closing(tokens: &[Token], at: usize) -> usize {
    let mut depth = 0i32;
    let end = (at..tokens.len()).find(|&i| {
        depth += i32::from(tokens[i].kind == Kind::Open) - i32::from(tokens[i].kind == Kind::Close);
        depth == 0
    });
    end.unwrap_or(tokens.len())
}

/// Whether a group is no formula by itself.
fn parts(inside: &[Token]) -> bool {
    let count = |sign: &str| inside.iter().filter(|t| t.is_char(sign)).count();
    let is_open = count("(") != count(")") || count("[") != count("]");
    let last = inside.iter().rev().find(|t| !is_space(t));
    let sign = |t: &Token| t.is("times") || t.is("cdot") || t.is_char("+") || t.is_char("-");
    let has_more = inside.iter().filter(|t| !is_space(t)).count() > 1;
    is_open || has_more && last.is_some_and(sign)
}

#[cfg(test)]
mod tests {
    use super::super::super::mark;
    use super::super::super::token::tokens;
    use super::without_parting;

    #[test]
    fn braces_that_part_brackets_are_none() {
        let shown = |text: &str| mark::text_of(&without_parting(tokens(text)));
        assert_eq!(shown(r"{a\times\Bigl(}{b+c\Bigr)}"), shown(r"a\times\Bigl(b+c\Bigr)"));
        assert_eq!(shown(r"{a -} {b}"), shown(r"a - {b}"));
        assert_eq!(shown(r"x_1{a+}b"), shown(r"x_1a+b"));
        assert_eq!(shown(r"\sqrt2{a+}b"), shown(r"\sqrt2a+b"));
        for same in [
            r"\frac1{1+}\frac12",
            r"\frac1 {1+}\frac12",
            r"\frac\alpha{1+}z",
            r"\frac{1}{1+}z",
            r"\sqrt[3]{a+}b",
            r"\binom1{2+}3",
            r"\dv x{y+}z",
            r"\frac{a(}{b)}",
            r"x^{(}",
            r"{a+b}",
            r"{-}",
            r"{(a+b)}c",
            r"x_{a+}",
        ] {
            assert_eq!(shown(same), mark::text_of(&tokens(same)), "{same}");
        }
    }
}
