//! Characters of Unicode that are mathematics → the commands that print them.
//!
//! **In:** tokens. **Out:** tokens with commands in the place of characters: the table is that of the reader of formulas, so that a paper is
//! read as its formulas are. **Guaranteed:** places are those of the characters.

use super::token::{Kind, Token, tokens as tokens_of};

/// Tokens with commands in the place of characters that print the same.
pub(super) fn plain(tokens: &[Token]) -> Vec<Token> {
    let mut out = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        let c = token.text.chars().next().filter(|c| token.kind == Kind::Other && !c.is_ascii());
        match c.and_then(latex::spelled) {
            Some(text) if text != token.text => {
                out.extend(tokens_of(&text).into_iter().map(|t| Token { span: token.span.clone(), ..t }));
            }
            // Small signs, raised or lowered, are a script.
            Some(_) if latex::raised_or_lowered(&token.text).is_some() => {
                let raised = |t: &Token| latex::raised_or_lowered(&t.text);
                let above = raised(token).is_some_and(|(above, _)| above);
                let mut text = String::from(if above { "^{" } else { "_{" });
                at -= 1;
                while let Some((here, sign)) = tokens.get(at).filter(|t| t.kind == Kind::Other).and_then(raised)
                    && here == above
                {
                    text.push_str(sign);
                    at += 1;
                }
                text.push('}');
                out.extend(tokens_of(&text).into_iter().map(|t| Token { span: token.span.clone(), ..t }));
            }
            _ => out.push(token.clone()),
        }
    }
    out
}
