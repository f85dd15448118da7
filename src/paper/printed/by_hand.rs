//! Numbers that an author wrote behind formulas by hand, `F=ma\quad(2)`.
//!
//! **In:** the tokens of a formula; all that a paper has of the kind. **Out:** where such a number begins; why it is not known whether it is a number
//! or a factor. **Guaranteed:** behind one small space it is a number only where the numbers of the paper
//! are set so throughout.

use super::super::token::{Kind, Token};
use super::signs::is_space;
use super::spaces::Spaces;

/// What stands in parentheses behind one small space.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ByHand {
    /// Its digits; 0 for a letter, or a number of a section.
    number: usize,
    /// The text between the parentheses.
    text: String,
    /// What stands before it is a number, or closes a bracket with one.
    is_behind_digits: bool,
}

/// The most digits of a number.
const MOST_DIGITS: usize = 4;

/// Where a number begins that stands in parentheses behind a space, at the end; and what it is, where it may be a factor as well.
pub(super) fn numbered_by_hand(
    tokens: &[Token],
    relates: impl Fn(&[Token]) -> bool,
) -> Option<(usize, Option<ByHand>)> {
    let printed: Vec<usize> = (0..tokens.len())
        .filter(|&i| tokens[i].kind != Kind::Space && !tokens[i].is_char(".") && !tokens[i].is_char(","))
        .collect();
    let close = printed.len().checked_sub(1).filter(|&k| tokens[printed[k]].is_char(")"))?;
    let from = close.saturating_sub(MOST_DIGITS);
    let open = (from..close).rev().find(|&k| tokens[printed[k]].is_char("(")).map(|k| printed[k])?;
    let inside: String =
        tokens[open + 1..printed[close]].iter().filter(|t| t.kind != Kind::Space).map(|t| t.text.as_str()).collect();
    // `F=m\ (2x)` is a product.
    let digits = inside.trim_end_matches(|c: char| matches!(c, 'a'..='d' | '\'' | '*'));
    let is_digit = |c: char| c.is_ascii_digit();
    let number = digits.starts_with(is_digit)
        && digits.ends_with(is_digit)
        && digits.chars().all(|c| is_digit(c) || c == '.')
        && inside.len() <= digits.len() + 1;
    let letter = inside.len() == 1 && inside.chars().all(|c| matches!(c, 'a'..='d'));
    if !number && !letter {
        return None;
    }
    let spaces = Spaces::before(tokens, open);
    if spaces.end != open || spaces.small == 0 && !spaces.is_wide {
        return None;
    }
    if !relates(&tokens[..open]) {
        return None;
    }
    if spaces.is_wide || spaces.small > 1 {
        return Some((open, None));
    }
    let is_thin = tokens[..open].iter().rev().find(|t| t.kind != Kind::Space).is_some_and(|t| t.is(","));
    // Digits that stand above or below are no factor.
    let is_digit_token = |t: &&Token| t.kind == Kind::Other && t.text.starts_with(is_digit);
    let before = tokens[..open].iter().rev().filter(|t| !is_space(t)).skip_while(|t| t.is_char(")"));
    let is_behind_digits = before.clone().next().is_some_and(|t| is_digit_token(&t))
        && !before.clone().find(|t| !is_digit_token(t)).is_some_and(|t| t.is_char("^") || t.is_char("_"));
    let by_hand = ByHand { number: digits.parse().unwrap_or_default(), text: inside, is_behind_digits };
    // A thin space stands between factors.
    (!is_thin).then_some((open, Some(by_hand)))
}

/// Whether the formulas of a paper are numbered so: all in their order, from 1.
pub(super) fn are_numbers(all: &[&ByHand]) -> bool {
    all.len() > 1 && all.iter().enumerate().all(|(k, one)| one.number == k + 1)
}

impl ByHand {
    /// Why the formula before it is not read, if the paper does not number its formulas so, or digits stand before it.
    pub(super) fn doubt(&self, are_numbers: bool) -> Option<String> {
        let ByHand { text, is_behind_digits, .. } = self;
        let is_doubted = !are_numbers || *is_behind_digits;
        is_doubted.then(|| format!("whether `({text})` is the number of the formula or a factor is not known"))
    }
}
