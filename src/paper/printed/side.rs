//! Sides, and the signs between them.

use super::super::mark::{self, group_text};
use super::super::span_of;
use super::super::token::{Kind, Token};
use super::groups::without_parting;
use super::lengths::length;
use super::signs::RELATIONS;
use super::{PrintedSide, is_space, walk};
use diag::escape::shown;

/// So many letters are those of a name, or of a unit, as often as those of a word.
const SHORT: usize = 4;

impl PrintedSide {
    /// What it prints: two sides with the same print are the same, letter by letter.
    pub fn print(&self) -> String {
        mark::print(&self.tokens)
    }

    /// The formula with a dot wherever a name that `is_factor` stands right before parentheses, so that it is read as a factor.
    pub fn with_factors(&self, is_factor: &dyn Fn(&str) -> bool) -> String {
        let mut out: Vec<Token> = Vec::with_capacity(self.tokens.len());
        for (at, token) in self.tokens.iter().enumerate() {
            let bracket = |t: Option<&Token>| t.is_some_and(|t| t.is_char("(") || t.is_char("["));
            let opens = bracket(Some(token)) && !(at > 0 && is_size(&self.tokens[at - 1]))
                || is_size(token) && bracket(self.tokens.get(at + 1));
            if opens && base_before(&out).is_some_and(is_factor) {
                out.push(Token { kind: Kind::Command, text: "cdot".into(), span: token.span.start..token.span.start });
            }
            out.push(token.clone());
        }
        shown(&mark::text_of(&out)).into_owned()
    }

    /// How often it has a sign of two branches, `\pm` or `\mp`.
    pub fn branch_signs(&self) -> usize {
        self.tokens.iter().filter(|t| branch_sign(t, true).is_some()).count()
    }

    /// The same with the upper, or the lower, of its signs of two branches.
    pub fn branch(&self, upper: bool) -> PrintedSide {
        let one = |token: &Token| match branch_sign(token, upper) {
            Some(sign) => Token { kind: Kind::Other, text: sign.into(), span: token.span.clone() },
            None => token.clone(),
        };
        PrintedSide { span: self.span.clone(), ..side_of(&self.tokens.iter().map(one).collect::<Vec<_>>()) }
    }

    /// The words that it consists of, where it is a text of several words, or of one of many letters, and nothing else.
    pub fn words(&self) -> Option<String> {
        let [command, rest @ ..] = self.tokens.as_slice() else { return None };
        if command.kind != Kind::Command || !super::WORDS.contains(&command.text.as_str()) || rest.is_empty() {
            return None;
        }
        let (words, end) = group_text(&self.tokens, 1);
        let is_all = self.tokens.iter().skip(end).all(|t| is_space(t) || t.is_char("."));
        let words = words.trim();
        let are_words = words.chars().all(|c| c.is_alphabetic() || matches!(c, ' ' | '-' | ',' | '.'))
            && words.split_whitespace().any(|word| word.chars().filter(|c| c.is_alphabetic()).count() > SHORT);
        (is_all && are_words).then(|| words.to_owned())
    }

    /// What stands before and behind each space that the author set in it, outside of all brackets: a space alone may part two formulas.
    pub fn parted_at_spaces(&self) -> Vec<[PrintedSide; 2]> {
        let mut out = Vec::new();
        let mut depth = 0i32;
        for (at, token) in self.tokens.iter().enumerate() {
            let opens = |t: &Token| t.kind == Kind::Open || t.is_char("(") || t.is_char("[") || t.is("{");
            let closes = |t: &Token| t.kind == Kind::Close || t.is_char(")") || t.is_char("]") || t.is("}");
            depth += i32::from(opens(token)) - i32::from(closes(token));
            // A space that is printed has no length in the source: see `side_of`.
            if depth == 0 && token.kind == Kind::Space && token.span.is_empty() {
                let halves = [side_of(&self.tokens[..at]), side_of(&self.tokens[at + 1..])];
                if halves.iter().all(|side| !side.text.is_empty()) {
                    out.push(halves);
                }
            }
        }
        out
    }
}

/// What a sign of two branches is in one of them; `None` for any other token.
fn branch_sign(token: &Token, upper: bool) -> Option<&'static str> {
    let is = |name: &str| token.kind == Kind::Command && token.text == name;
    match (is("pm"), is("mp")) {
        (true, _) => Some(if upper { "+" } else { "-" }),
        (_, true) => Some(if upper { "-" } else { "+" }),
        (false, false) => None,
    }
}

fn is_size(token: &Token) -> bool {
    token.kind == Kind::Command
        && matches!(token.text.as_str(), "left" | "big" | "Big" | "bigg" | "Bigg" | "bigl" | "Bigl" | "biggl" | "Biggl")
}

/// The letter to which the scripts at the end of some tokens belong, or that stands there.
fn base_before(tokens: &[Token]) -> Option<&str> {
    let mut end = tokens.len();
    loop {
        while end > 0 && tokens[end - 1].kind == Kind::Space {
            end -= 1;
        }
        let last = tokens.get(end.checked_sub(1)?)?;
        let mut start = end - 1;
        if last.kind == Kind::Close {
            let mut depth = 0i32;
            start = (0..end).rev().find(|&i| {
                depth += i32::from(tokens[i].kind == Kind::Close) - i32::from(tokens[i].kind == Kind::Open);
                depth == 0
            })?;
        }
        let before = tokens[..start].iter().rposition(|t| t.kind != Kind::Space);
        if let Some(script) = before.filter(|&i| tokens[i].is_char("^") || tokens[i].is_char("_")) {
            end = script;
            continue;
        }
        let letter = match last.kind {
            Kind::Other => last.text.chars().all(char::is_alphabetic),
            Kind::Command => super::super::names::is_letter(last),
            _ => false,
        };
        return (letter && start == end - 1).then_some(last.text.as_str());
    }
}

pub(super) fn is_colon_equals(tokens: &[Token], at: usize) -> bool {
    tokens[at].is_char(":") && tokens.get(at + 1).is_some_and(|t| t.is_char("="))
}

/// The sign that begins at a place, and the position after it: `:=`, `\not=`, `=`.
pub(super) fn sign_at(tokens: &[Token], at: usize) -> (String, usize) {
    let spelled = |t: &Token| if t.kind == Kind::Command { format!("\\{}", t.text) } else { t.text.to_string() };
    let mut next = at + 1;
    let mut sign = spelled(&tokens[at]);
    if is_colon_equals(tokens, at) {
        return (":=".to_owned(), at + 2);
    }
    if tokens[at].is("not") {
        while tokens.get(next).is_some_and(is_space) {
            next += 1;
        }
        if let Some(t) = tokens.get(next) {
            sign.push_str(&spelled(t));
            next += 1;
        }
    }
    // `<=` of two characters is no sign of mathematics, but `=:` is.
    if sign == "=" && tokens.get(next).is_some_and(|t| t.is_char(":")) {
        return ("=:".to_owned(), next + 1);
    }
    (sign, next)
}

/// A relation sign with something above or below it.
pub(super) fn stacked(tokens: &[Token], at: usize) -> Option<(String, String, usize)> {
    let (words, middle) = group_text(tokens, at + 1);
    let (sign, end) = group_text(tokens, middle);
    let name = sign.trim();
    let known = matches!(name, "=" | "<" | ">") || name.strip_prefix('\\').is_some_and(|n| RELATIONS.contains(&n));
    (middle > at + 1 && end > middle && known).then(|| {
        // What stands above an equals sign says how it is meant: it is no plain one unless it is a reference.
        let plain = name == "="
            && (words.contains('(') || words.contains("ref") || words_without_commands(&words).contains('r'));
        (if plain { "=".to_owned() } else { format!("\\stackrel{{{words}}}{{{name}}}") }, words, end)
    })
}

/// What is left of a text without its commands: of `\mathrm{def}` it is `{def}`.
fn words_without_commands(text: &str) -> String {
    let mut parts = text.split('\\');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |out, part| out + part.trim_start_matches(|c: char| c.is_ascii_alphabetic()))
}

/// Takes labels and tags out of a cell.
pub(super) fn without_labels(tokens: &[Token]) -> (Vec<Token>, Option<String>, Option<String>) {
    let (mut label, mut tag) = (None, None);
    let mut out = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        if token.is("label") || token.is("tag") {
            let star = usize::from(tokens.get(at + 1).is_some_and(|t| t.is_char("*")));
            let (text, after) = group_text(tokens, at + 1 + star);
            let text = diag::escape::in_one_line(&text);
            if token.is("label") {
                label = Some(text)
            } else {
                tag = Some(text)
            }
            at = after.max(at + 1);
            continue;
        }
        if token.is("eqno") || token.is("leqno") {
            // In plain TeX the number is all that follows.
            let number: String = tokens[at + 1..].iter().map(|t| t.text.as_str()).collect();
            let number = diag::escape::in_one_line(number.trim().trim_matches(['(', ')']));
            tag = tag.or(Some(number));
            break;
        }
        out.push(token.clone());
        at += 1;
    }
    (out, label.filter(|l| !l.is_empty()), tag)
}

/// Tokens in which each space that is printed is a space of no length in the source, whatever command makes it.
pub(super) fn with_plain_spaces(tokens: &[Token]) -> Vec<Token> {
    let mut kept: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        let is_differential = || match tokens.get(at..at + 3) {
            Some([open, d, close]) => open.kind == Kind::Open && d.is_char("d") && close.kind == Kind::Close,
            _ => false,
        };
        let is = |names: &[&str]| token.kind == Kind::Command && names.contains(&token.text.as_str());
        if let Some((_, after)) = length(token, tokens, at) {
            at = after;
            kept.extend(between_numbers(&kept, &tokens[at..]).then(|| space(token)));
        } else if is(&["hspace", "vspace", "mspace", "hskip", "vskip", "kern", "mkern", "mskip", "noalign"]) {
            let star = usize::from(tokens.get(at).is_some_and(|t| t.is_char("*")));
            at = group_text(tokens, at + star).1;
            kept.extend(between_numbers(&kept, &tokens[at..]).then(|| space(token)));
        } else if token.is("text") && is_differential() {
            // An upright differential, whichever command makes it upright.
            kept.push(Token { text: "mathrm".into(), ..token.clone() });
        } else if token.kind == Kind::Command && is_space(token) || token.is_char("~") {
            kept.push(space(token));
        } else {
            kept.push(token.clone());
        }
    }
    kept
}

/// Whether numbers may stand on both sides, which a length parts.
fn between_numbers(before: &[Token], behind: &[Token]) -> bool {
    let is_of_number = |t: &Token| t.is_char(".") || t.text.starts_with(|c: char| c.is_ascii_digit());
    before.last().is_some_and(|t| t.kind == Kind::Close || is_of_number(t))
        && behind.iter().find(|t| t.kind != Kind::Space).is_some_and(|t| t.kind == Kind::Open || is_of_number(t))
}

/// A space of any width is a space.
fn space(token: &Token) -> Token {
    Token { kind: Kind::Space, text: " ".into(), span: token.span.start..token.span.start }
}

/// A side made of these tokens.
pub(super) fn side_of(tokens: &[Token]) -> PrintedSide {
    let mut kept = without_parting(with_plain_spaces(tokens));
    let idle = |t: &Token| t.kind == Kind::Space;
    while kept.last().is_some_and(idle) {
        kept.pop();
    }
    let begin = kept.iter().take_while(|t| idle(t)).count();
    kept.drain(..begin);
    let text = shown(&mark::text_of(&kept)).into_owned();
    let mut is_list = false;
    walk(&kept, |i, outside| is_list |= outside && kept[i].is_char(","));
    PrintedSide { text, span: span_of(&kept), is_list, tokens: kept }
}
