//! Signs of relation behind `_` and `^`: TeX lowers or raises the one token behind them, so `w_\perp` is a name.
//!
//! **In:** the tokens of a formula. **Out:** the same, such a sign in braces. **Guaranteed:** nothing else changes, and the print stays.

use std::borrow::Cow;

use super::super::token::{Kind, Token};
use super::signs::{is_relation, is_space};

/// Tokens in which no sign of relation stands bare behind `_` or `^`.
pub fn with_braces(tokens: &[Token]) -> Cow<'_, [Token]> {
    let is_script = |t: &Token| t.is_char("_") || t.is_char("^");
    let behind = |at: usize| tokens[..at].iter().rev().find(|t| !is_space(t)).is_some_and(is_script);
    let bare = |at: usize| is_relation(&tokens[at]) && behind(at);
    if !(0..tokens.len()).any(bare) {
        return Cow::Borrowed(tokens);
    }
    let mut out = Vec::with_capacity(tokens.len() + 2);
    for (at, token) in tokens.iter().enumerate() {
        let brace = |kind, text: &str| Token { kind, text: text.into(), span: token.span.clone() };
        if bare(at) {
            out.extend([brace(Kind::Open, "{"), token.clone(), brace(Kind::Close, "}")]);
        } else {
            out.push(token.clone());
        }
    }
    Cow::Owned(out)
}
