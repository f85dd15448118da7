//! Lengths of TeX that stand without braces, `\kern1pt`, and how wide they are.

use super::super::token::{Kind, Token};

/// Where the length ends that stands behind `\kern` and its kin without braces, `\mkern-1.5mu`, `\hskip 1cm plus 1fil`, with its text.
pub(super) fn length(token: &Token, tokens: &[Token], from: usize) -> Option<(String, usize)> {
    let is_kern = matches!(token.text.as_str(), "kern" | "mkern" | "hskip" | "mskip" | "vskip");
    if token.kind != Kind::Command || !is_kern {
        return None;
    }
    let (mut text, mut end) = dimension(tokens, from)?;
    for word in ["plus", "minus"] {
        let begin = end + tokens[end..].iter().take_while(|t| t.kind == Kind::Space).count();
        let is_here = word.chars().enumerate().all(|(k, c)| {
            tokens.get(begin + k).is_some_and(|t| t.kind == Kind::Other && t.text == c.to_string().as_str())
        });
        let stretch = if is_here { dimension(tokens, begin + word.len()) } else { None };
        if let Some((stretch, after)) = stretch {
            text.push_str(&format!(" {word} {stretch}"));
            end = after;
        }
    }
    Some((text, end))
}

/// A number with a unit, and the position after it.
fn dimension(tokens: &[Token], from: usize) -> Option<(String, usize)> {
    let part = |t: &Token| t.kind == Kind::Space || t.text.bytes().all(|b| b.is_ascii_digit() || b"+-.".contains(&b));
    let digits = tokens[from..].iter().take_while(|t| part(t) && t.kind != Kind::Command).count();
    let number = &tokens[from..from + digits];
    let has_digit = number.iter().any(|t| t.text.starts_with(|c: char| c.is_ascii_digit()));
    let letter = |t: &Token| t.kind == Kind::Other && t.text.bytes().all(|b| b.is_ascii_lowercase());
    let unit = tokens.get(from + digits..from + digits + 2).filter(|unit| unit.iter().all(letter) && has_digit)?;
    let text: String = number.iter().filter(|t| t.kind != Kind::Space).chain(unit).map(|t| t.text.as_str()).collect();
    // `1fil`, `1filll`.
    let end = from + digits + 2;
    let more =
        if text.ends_with("fi") { tokens[end..].iter().take(3).take_while(|t| t.is_char("l")).count() } else { 0 };
    Some((text, end + more))
}

/// Whether a length is as wide as a space between formulas: half a quad, or more.
pub(super) fn is_wide_length(length: &str) -> bool {
    let first = length.split(' ').next().unwrap_or_default();
    let (number, unit) = first.split_at(first.len() - 2.min(first.len()));
    // In units of a quad.
    let size = match unit {
        "mu" => 1.0 / 18.0,
        "em" => 1.0,
        "ex" => 0.43,
        "pt" | "bp" => 0.1,
        "mm" => 0.28,
        "cm" => 2.8,
        "in" => 7.2,
        "pc" => 1.2,
        _ => 0.0,
    };
    number.parse::<f64>().is_ok_and(|n| n * size >= 0.5) || length.contains(" plus ")
}
