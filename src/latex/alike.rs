//! Spellings that print alike, brought into one form: one pass each.
//!
//! **In:** tokens. **Out:** tokens without braces that print nothing, with styles under dots, bars that know their side, transposes as `^\top`, and
//! primes as `'`. **Guaranteed:** what comes out prints what came in.

use super::expand::sign;
use super::lexer::{Kind, Token};
use super::refusal::{Parsed, refuse};

/// `\frac{d{}}{dt}` as `\frac{d}{dt}`: empty braces print nothing. They are kept where a command could take them for its argument. Where a script
/// follows, it stands behind what is before, and is none of its scripts: `T^a{}_b`, `2\,{}_2F_1`. A power is clear: `x_a{}^2`, `(a+b){}^2`.
pub(super) fn without_empty_braces(tokens: Vec<Token>) -> Parsed<Vec<Token>> {
    let is = |t: Option<&Token>, c: char| t.is_some_and(|t| t.kind == Kind::Sign(c));
    if !(1..tokens.len()).any(|i| is(tokens.get(i - 1), '{') && is(tokens.get(i), '}')) {
        return Ok(tokens);
    }
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        let empty = is(tokens.get(at), '{') && is(tokens.get(at + 1), '}');
        let script = ['_', '^', '\''].iter().any(|c| is(tokens.get(at + 2), *c));
        if empty && script && !is(tokens.get(at + 2), '\'') && ends_something(&out) {
            let touches = out.last().is_some_and(|t| t.span.end == tokens[at].span.start);
            if !(touches && ends_base(&out) && is_power(&tokens[at + 2..])) {
                return refuse(
                    "latex::ambiguous",
                    "a script behind empty braces: an index of a tensor, or of what follows",
                    tokens[at].span.start..tokens[at + 2].span.end,
                    "write the scripts above each other, `T^a_b`, where their order does not count",
                );
            }
        }
        if empty && !script && is_no_argument(&out) {
            at += 2;
        } else {
            out.push(tokens[at].clone());
            at += 1;
        }
    }
    Ok(out)
}

/// Whether something ends with these tokens to which a script could belong.
fn ends_something(before: &[Token]) -> bool {
    let last = before.last().map(|t| &t.kind);
    !matches!(last, None | Some(Kind::Sign('{' | '(' | '[' | '+' | '-' | '=' | ',' | '&') | Kind::Row))
}

/// Whether brackets end with these tokens, or a script.
fn ends_base(before: &[Token]) -> bool {
    let is_script = before.len() > 1 && matches!(before[before.len() - 2].kind, Kind::Sign('_' | '^'));
    is_script || matches!(before.last().map(|t| &t.kind), Some(Kind::Sign(')' | ']' | '}') | Kind::CloseBar))
}

/// Whether a number is raised here that is a power: 2, 12, -1.
pub(super) fn is_power(tokens: &[Token]) -> bool {
    let kind = |at: usize| tokens.get(at).map(|t| &t.kind);
    let braces = usize::from(kind(1) == Some(&Kind::Sign('{')));
    let minus = usize::from(braces > 0 && kind(2) == Some(&Kind::Sign('-')));
    let at = 1 + braces + minus;
    let is_closed = braces == 0 || kind(at + 1) == Some(&Kind::Sign('}'));
    let is_number = matches!(kind(at), Some(Kind::Number(n)) if minus > 0 || !matches!(n.as_str(), "0" | "1"));
    kind(0) == Some(&Kind::Sign('^')) && is_number && is_closed
}

/// Whether braces behind these tokens are nobody's argument.
fn is_no_argument(before: &[Token]) -> bool {
    let kind = |back: usize| before.len().checked_sub(back).and_then(|i| before.get(i)).map(|t| &t.kind);
    // No command stands before it that could take it.
    let free = |back: usize| matches!(kind(back), None | Some(Kind::Sign('{' | '(' | '[' | '+' | '-' | '=' | ',')));
    match kind(1) {
        None | Some(Kind::Sign('{' | '(' | '+' | '-' | '=' | ',')) => true,
        Some(Kind::Letter('d')) => free(2),
        Some(Kind::Command(c)) => c == "partial" && free(2),
        // The order of a derivative.
        Some(Kind::Number(n)) => n.len() == 1 && kind(2) == Some(&Kind::Sign('^')),
        _ => false,
    }
}

/// `\mathbf{\dot x}` is printed as `\dot{\mathbf{x}}`: a dot has no style.
pub(super) fn styles_under_dots(mut tokens: Vec<Token>) -> Vec<Token> {
    let command = |t: &Token, is: &dyn Fn(&str) -> bool| matches!(&t.kind, Kind::Command(c) if is(c));
    let style = |t: &Token| {
        command(t, &|c| super::name::style(c).is_some_and(super::name::marks_tensor) && !super::name::is_switch(c))
    };
    let dot = |t: &Token| command(t, &|c| matches!(c, "dot" | "ddot"));
    let is = |t: Option<&Token>, c: char| t.is_some_and(|t| t.kind == Kind::Sign(c));
    let mut at = 0;
    while at + 5 < tokens.len() {
        let double = usize::from(is(tokens.get(at + 2), '{'));
        let inner = at + 2 + double;
        // `\mathbf{\dot{x}}`, `\mathbf{{\dot{x}}}`, `\mathbf{\dot x}`.
        let fits = style(&tokens[at]) && is(tokens.get(at + 1), '{') && tokens.get(inner).is_some_and(dot);
        let braced = is(tokens.get(inner + 1), '{');
        let last = inner + if braced { 4 } else { 2 };
        let closed =
            fits && (0..=double).all(|i| is(tokens.get(last + i), '}')) && (!braced || is(tokens.get(inner + 3), '}'));
        if closed {
            let (style, dot) = (tokens[at].kind.clone(), tokens[inner].kind.clone());
            tokens[at].kind = dot;
            tokens[inner].kind = style;
        }
        at += 1;
    }
    tokens
}

/// An upright T above, `A^{\mathrm T}`, `A^\text{T}`, `A^{{\sf T}}`, `A^\intercal`, is `A^\top`: it is a transpose in print, and no power.
pub(super) fn transposes(tokens: Vec<Token>) -> Vec<Token> {
    let upright = |t: &Token| matches!(&t.kind, Kind::Command(c) if matches!(c.as_str(), "mathrm" | "text" | "textrm" | "textup" | "mathsf" | "textsf" | "rm" | "sf"));
    let sign = |t: Option<&Token>, c: char| t.is_some_and(|t| t.kind == Kind::Sign(c));
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        out.push(tokens[at].clone());
        at += 1;
        if !sign(tokens.get(at - 1), '^') {
            continue;
        }
        let mut next = at;
        let mut braces = 0;
        let mut is_upright = false;
        while let Some(t) = tokens.get(next) {
            if t.kind == Kind::Sign('{') {
                braces += 1;
            } else if upright(t) && !is_upright {
                is_upright = true;
            } else {
                break;
            }
            next += 1;
        }
        let letter = tokens.get(next).is_some_and(|t| t.kind == Kind::Letter('T')) && is_upright;
        let intercal = tokens.get(next).is_some_and(|t| matches!(&t.kind, Kind::Command(c) if c == "intercal"));
        let closed = (1..=braces).all(|i| sign(tokens.get(next + i), '}'));
        if (letter || intercal) && closed {
            out.push(Token { kind: Kind::Command("top".to_owned()), span: tokens[next].span.clone() });
            at = next + 1 + braces;
        }
    }
    out
}

/// `\|` and `\Vert` do not say their side: two of them are a pair, more could be read in two ways. What is lowered, `w_\|`, is a label.
pub(super) fn double_bars(mut tokens: Vec<Token>) -> Parsed<Vec<Token>> {
    let double = |t: &Token| matches!(&t.kind, Kind::Command(c) if c == "|" || c == "Vert");
    let is_lowered = |at: usize| {
        let before = |n: usize| at.checked_sub(n).and_then(|i| tokens.get(i)).map(|t| &t.kind);
        let alone = before(1) == Some(&Kind::Sign('{')) && sign_at(&tokens, at + 1, '}');
        before(1) == Some(&Kind::Sign('_')) || alone && before(2) == Some(&Kind::Sign('_'))
    };
    let all: Vec<usize> = (0..tokens.len()).filter(|&at| double(&tokens[at]) && !is_lowered(at)).collect();
    let Some(&first) = all.first() else { return Ok(tokens) };
    if tokens.iter().any(|t| t.kind == Kind::Sign('|')) {
        let hint = r"write `\left\|…\right\|` and `\left|…\right|`";
        return refuse(
            "latex::ambiguous",
            "single and double bars that do not say their side",
            tokens[first].span.clone(),
            hint,
        );
    }
    for at in all {
        tokens[at].kind = Kind::Sign('|');
    }
    Ok(tokens)
}

fn sign_at(tokens: &[Token], at: usize, sign: char) -> bool {
    tokens.get(at).is_some_and(|t| t.kind == Kind::Sign(sign))
}

/// Primes in one form: `x^\prime`, `x^{\prime2}` and `x^{''}` as `x'`, `x'^{2}` and `x''`.
pub(super) fn primes(tokens: Vec<Token>) -> Vec<Token> {
    let prime = |t: &Token| t.kind == Kind::Sign('\'') || matches!(&t.kind, Kind::Command(c) if c == "prime");
    let raised =
        |w: &[Token]| w[0].kind == Kind::Sign('^') && (prime(&w[1]) || w[1].kind == Kind::Sign('{') && prime(&w[2]));
    if !tokens.windows(3).any(raised) {
        return tokens;
    }
    let mut out = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while at < tokens.len() {
        if !tokens.get(at..at + 3).is_some_and(raised) {
            out.push(tokens[at].clone());
            at += 1;
            continue;
        }
        let braced = tokens[at + 1].kind == Kind::Sign('{');
        let mut next = at + 1 + usize::from(braced);
        while prime(&tokens[next]) && (braced || next == at + 1) {
            out.push(sign('\'', &tokens[next].span));
            next += 1;
        }
        if !braced {
            at = next;
        } else if tokens[next].kind == Kind::Sign('}') {
            at = next + 1;
        } else {
            out.push(tokens[at].clone());
            out.push(tokens[at + 1].clone());
            at = next;
        }
    }
    out
}
