//! Calls of macros: their arguments, and their bodies with these put in.

use super::super::token::{Kind, Token};
use super::rest::{Macro, Rest, argument, next_is, optional, spaces};

/// The arguments of a call with signs between them, as TeX takes them: up to the signs behind each, outside of braces. What is missing stays out.
fn delimited(pattern: &[Token], rest: &mut Rest) -> Vec<Vec<Token>> {
    let same = |a: &Token, b: &Token| a.kind == b.kind && a.text == b.text;
    let mut values = Vec::new();
    let mut at = 0;
    while let Some(piece) = pattern.get(at) {
        at += 1;
        if piece.kind != Kind::Argument {
            spaces(rest);
            if rest.last().is_some_and(|(t, _)| same(t, piece)) {
                rest.pop();
            }
            continue;
        }
        let signs: Vec<&Token> = pattern[at..].iter().take_while(|t| t.kind != Kind::Argument).collect();
        if signs.is_empty() {
            values.push(argument(rest));
            continue;
        }
        let ends = |rest: &Rest| {
            rest.len() >= signs.len() && signs.iter().zip(rest.iter().rev()).all(|(s, (t, _))| same(s, t))
        };
        let (mut value, mut depth) = (Vec::new(), 0usize);
        while !(depth == 0 && ends(rest))
            && let Some((t, _)) = rest.pop()
        {
            match t.kind {
                Kind::Open => depth += 1,
                Kind::Close => depth = depth.saturating_sub(1),
                _ => {}
            }
            value.push(t);
        }
        // A value in braces is what stands in them.
        if let [open, .., close] = value.as_slice()
            && (open.kind, close.kind) == (Kind::Open, Kind::Close)
            && braces_are_one(&value)
        {
            value = value[1..value.len() - 1].to_vec();
        }
        values.push(value);
    }
    values
}

/// Whether the first brace is closed by the last.
fn braces_are_one(tokens: &[Token]) -> bool {
    let mut depth = 0usize;
    for (i, t) in tokens.iter().enumerate() {
        match t.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return i + 1 == tokens.len();
        }
    }
    false
}

/// The body of a macro with its arguments put in; every token has the place of the call. `None` if it has more than `most`
/// tokens.
pub(super) fn call(found: &Macro, token: &Token, rest: &mut Rest, most: usize) -> Option<Vec<Token>> {
    let mut values: Vec<Vec<Token>> = Vec::new();
    // What is not given stands nowhere else than the call.
    let here = |all: &[Token]| all.iter().map(|t| Token { span: token.span.clone(), ..t.clone() }).collect();
    if found.has_star {
        next_is(rest, "*");
        values.push(Vec::new());
    }
    if let Some(default) = &found.default {
        values.push(optional(rest).unwrap_or_else(|| here(default)));
    }
    if found.pattern.is_empty() {
        while values.len() < found.arguments {
            values.push(argument(rest));
        }
    } else {
        values.extend(delimited(&found.pattern, rest));
    }
    values.extend(found.options.iter().map(|default| optional(rest).unwrap_or_else(|| here(default))));
    let mut out = Vec::new();
    for t in &found.body {
        if out.len() > most {
            return None;
        }
        match t.kind {
            Kind::Argument => {
                let nth: usize = t.text.parse().unwrap_or(1);
                out.extend(values.get(nth.wrapping_sub(1)).into_iter().flatten().cloned());
            }
            _ => out.push(Token { span: token.span.clone(), ..t.clone() }),
        }
    }
    (out.len() <= most).then_some(out)
}
