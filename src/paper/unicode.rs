//! Characters of Unicode that are mathematics → the commands that print them.

use super::token::{Kind, Token};

/// Greek letters in the order of Unicode, from alpha; the final sigma is one of them.
const SMALL: &[&str] = &[
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "o", "pi", "rho", "varsigma", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega",
];
const CAPITAL: &[&str] = &[
    "A", "B", "Gamma", "Delta", "E", "Z", "H", "Theta", "I", "K", "Lambda", "M", "N", "Xi", "O", "Pi", "P", "Theta",
    "Sigma", "T", "Upsilon", "Phi", "X", "Psi", "Omega",
];
/// Signs, each with what prints it.
const SIGNS: &[(char, &[&str])] = &[
    ('∂', &["\\partial"]),
    ('∇', &["\\nabla"]),
    ('∞', &["\\infty"]),
    ('·', &["\\cdot"]),
    ('⋅', &["\\cdot"]),
    ('×', &["\\times"]),
    ('−', &["-"]),
    ('±', &["\\pm"]),
    ('∓', &["\\mp"]),
    ('≤', &["\\le"]),
    ('≥', &["\\ge"]),
    ('≠', &["\\ne"]),
    ('≈', &["\\approx"]),
    ('≡', &["\\equiv"]),
    ('∼', &["\\sim"]),
    ('∝', &["\\propto"]),
    ('≪', &["\\ll"]),
    ('≫', &["\\gg"]),
    ('→', &["\\to"]),
    ('⇒', &["\\Rightarrow"]),
    ('∫', &["\\int"]),
    ('∑', &["\\sum"]),
    ('√', &["\\sqrt"]),
    ('ℏ', &["\\hbar"]),
    ('ℓ', &["\\ell"]),
    ('′', &["'"]),
    ('″', &["'", "'"]),
    ('½', &["\\frac", "1", "2"]),
    ('¼', &["\\frac", "1", "4"]),
    ('¾', &["\\frac", "3", "4"]),
    ('²', &["^", "2"]),
    ('³', &["^", "3"]),
];

/// Tokens with commands in the place of characters that print the same.
pub(super) fn plain(tokens: &[Token]) -> Vec<Token> {
    let mut out = Vec::with_capacity(tokens.len());
    for token in tokens {
        match (token.kind, token.text.chars().next()) {
            (Kind::Other, Some(c)) if !c.is_ascii() => match spelled(c) {
                Some(parts) => out.extend(parts.iter().map(|p| one(p, token))),
                None => out.push(token.clone()),
            },
            _ => out.push(token.clone()),
        }
    }
    out
}

fn one(text: &str, like: &Token) -> Token {
    match text.strip_prefix('\\') {
        Some(command) => Token { kind: Kind::Command, text: command.to_owned(), span: like.span.clone() },
        None => Token { kind: Kind::Other, text: text.to_owned(), span: like.span.clone() },
    }
}

fn spelled(c: char) -> Option<Vec<String>> {
    if let Some((_, parts)) = SIGNS.iter().find(|(sign, _)| *sign == c) {
        return Some(parts.iter().map(|p| (*p).to_owned()).collect());
    }
    let at = |base: u32| (c as u32).checked_sub(base).map(|i| i as usize);
    let greek = |name: &&str| if name.len() > 1 { format!("\\{name}") } else { (*name).to_owned() };
    // Greek as in text, and the italic Greek of mathematics.
    for (base, letters) in [(0x3B1, SMALL), (0x391, CAPITAL), (0x1D6FC, SMALL), (0x1D6E2, CAPITAL)] {
        if let Some(name) = at(base).and_then(|i| letters.get(i)) {
            return Some(vec![greek(name)]);
        }
    }
    let latin = |i: usize, first: u8| char::from(first + i as u8).to_string();
    match c as u32 {
        0x1D434..=0x1D44D => Some(vec![latin(at(0x1D434)?, b'A')]),
        0x1D44E..=0x1D467 => Some(vec![latin(at(0x1D44E)?, b'a')]),
        0x210E => Some(vec!["h".to_owned()]),
        0x3D5 => Some(vec!["\\phi".to_owned()]),
        0x3F5 | 0x1D716 => Some(vec!["\\epsilon".to_owned()]),
        0x1D715 => Some(vec!["\\partial".to_owned()]),
        0x1D717 | 0x3D1 => Some(vec!["\\vartheta".to_owned()]),
        0x1D719 => Some(vec!["\\phi".to_owned()]),
        _ => None,
    }
}
