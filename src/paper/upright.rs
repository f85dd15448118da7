//! Upright words for what ∇ does, and for functions → the sign: `\operatorname{rot}` is `\nabla\times`, `{\rm sin}` is `\sin`.
//!
//! **In:** tokens. **Out:** tokens with ∇ in the place of `grad`, `div`, `rot` and `curl`, and with the command of a function in that of its
//! name, before something that they act on. **Guaranteed:** a label, as in E_rot, stays one, and so does a word before a sign, or alone.

use super::token::{Kind, Token, tokens as tokens_of};

/// Commands that print a word upright.
const UPRIGHT: &[&str] = &["operatorname", "mathrm", "text", "textrm", "textup", "mathop"];

/// Functions that an upright word is, and their commands.
const FUNCTIONS: &[(&str, &str)] = &[
    ("sin", r"\sin"),
    ("cos", r"\cos"),
    ("tan", r"\tan"),
    ("cot", r"\cot"),
    ("sinh", r"\sinh"),
    ("cosh", r"\cosh"),
    ("tanh", r"\tanh"),
    ("arcsin", r"\arcsin"),
    ("arccos", r"\arccos"),
    ("arctan", r"\arctan"),
    ("exp", r"\exp"),
    ("ln", r"\ln"),
    ("log", r"\log"),
];

/// Tokens in which these words are written with ∇.
pub(super) fn plain(tokens: &[Token]) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    // Of each open brace: whether it is a script, or in one.
    let mut scripts: Vec<bool> = Vec::new();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        let raised = out.iter().rev().find(|t| t.kind != Kind::Space).is_some_and(|t| t.is_char("_") || t.is_char("^"));
        let in_script = raised || scripts.last() == Some(&true);
        let is_sign = |sign: &str, after: usize| match sign {
            r"\mathrm{d}" => true,
            _ if FUNCTIONS.iter().any(|(_, function)| *function == sign) => {
                acts(tokens, after) || is_raised(tokens, after)
            }
            _ => acts(tokens, after),
        };
        if let Some((sign, after)) = word(tokens, at).filter(|(sign, after)| !in_script && is_sign(sign, *after)) {
            let span = token.span.start..tokens[after - 1].span.end;
            out.extend(tokens_of(sign).into_iter().map(|t| Token { span: span.clone(), ..t }));
            at = after;
            continue;
        }
        match token.kind {
            Kind::Open => scripts.push(in_script),
            Kind::Close => {
                scripts.pop();
            }
            Kind::Command | Kind::Dollar | Kind::Space | Kind::Argument | Kind::Other => {}
        }
        out.push(token.clone());
        at += 1;
    }
    out
}

/// The sign of a word that begins there, and where it ends: `\operatorname{rot}`, `{\rm rot}`, `\mathop{\rm rot}`.
fn word(tokens: &[Token], at: usize) -> Option<(&'static str, usize)> {
    let is_upright = tokens[at].kind == Kind::Command && UPRIGHT.iter().any(|c| tokens[at].is(c));
    let mut open = at + usize::from(is_upright);
    open += tokens.get(open..)?.iter().take_while(|t| is_upright && t.kind == Kind::Space).count();
    if tokens.get(open)?.kind != Kind::Open {
        return None;
    }
    let close = open + tokens[open..].iter().take(8).position(|t| t.kind == Kind::Close)?;
    let mut inside = tokens[open + 1..close].iter().filter(|t| t.kind != Kind::Space).peekable();
    let switched = inside.next_if(|t| t.is("rm") || t.is("mathrm") || t.is("operatorname")).is_some();
    let word: String = inside.map(|t| if t.kind == Kind::Other { t.text.as_str() } else { "\\" }).collect();
    if !is_upright && !switched {
        return None;
    }
    let sign =
        latex::sign_of_nabla(&word).or_else(|| FUNCTIONS.iter().find(|(name, _)| *name == word).map(|(_, sign)| *sign));
    // `{\rm d}x` prints what `\mathrm{d}x` does.
    let sign = sign.or_else(|| (word == "d" && !is_upright).then_some(r"\mathrm{d}"))?;
    Some((sign, close + 1))
}

/// Whether a power stands there, with more behind it: `{\rm sin}^2 x`.
fn is_raised(tokens: &[Token], at: usize) -> bool {
    tokens.get(at).is_some_and(|t| t.is_char("^")) && tokens.get(at + 2).is_some()
}

/// Whether something stands there that can be acted on.
fn acts(tokens: &[Token], at: usize) -> bool {
    let is_gap = |t: &&Token| t.kind == Kind::Space || [",", ";", ":", "!", " ", "quad"].iter().any(|c| t.is(c));
    tokens.get(at..).unwrap_or_default().iter().find(|t| !is_gap(t)).is_some_and(|next| match next.kind {
        Kind::Open => true,
        Kind::Command => !["\\", "right", "quad", "qquad", "end", "equiv", "times", "cdot", "text", "label"]
            .iter()
            .any(|c| next.is(c)),
        Kind::Other => next.text.chars().all(|c| c.is_alphanumeric() || c == '(' || c == '['),
        Kind::Close | Kind::Dollar | Kind::Space | Kind::Argument => false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> String {
        plain(&tokens_of(text))
            .iter()
            .map(
                |t| {
                    if t.kind == Kind::Command { format!("\\{} ", t.text.as_str()) } else { t.text.as_str().to_owned() }
                },
            )
            .collect()
    }

    #[test]
    fn words_before_something_are_signs() {
        for (text, wanted) in [
            (r"\operatorname{rot}A", r"\nabla \times A"),
            (r"{\rm div}{\bf A}", r"\nabla \cdot {\bf A}"),
            (r"\mathrm{grad}\,f", r"\nabla \, f"),
            (r"\text{rot}(A)", r"\nabla \times (A)"),
            (r"\mathop{\rm curl}A", r"\nabla \times A"),
            (r"{\rm sin}^2x", r"\sin ^2x"),
            (r"\mathrm{exp}(a)", r"\exp (a)"),
            (r"{\rm d}x", r"\mathrm {d}x"),
        ] {
            assert_eq!(shown(text).replace("  ", " "), wanted, "{text}");
        }
        for text in [
            r"E_{\rm rot}x",
            r"E_\mathrm{rot}x",
            r"E^{a,\mathrm{rot}}x",
            r"\mathrm{rot}=A",
            r"\mathrm{div}",
            r"{rot}A",
            r"\mathrm{rotor}A",
        ] {
            assert!(!shown(text).contains("nabla"), "{text}");
        }
        for text in [
            r"S_{\rm exp}x",
            r"\sigma^{\rm exp}_a",
            r"{\rm exp}=A",
            r"{exp}A",
            r"{\rm experiment}A",
            r"x_{\rm d}",
            r"{d}x",
        ] {
            assert_eq!(shown(text).replace(' ', ""), text.replace(' ', ""), "{text}");
        }
    }
}
