//! Frames and boxes of a display: what a frame stands around is printed as it is, what stands in a box of text is text, and a formula there is one.
//!
//! **In:** the tokens of a display. **Out:** the same without frames around whole relations, with boxes of words as words, and with a part of a
//! formula that stands between dollars in a text as that part. **Guaranteed:** two frames
//! beside each other are no product, and no chain: a frame is taken away only where what stands beside it parts formulas.

use super::super::mark::group_text;
use super::super::token::{Kind, Token};
use super::{BETWEEN_STATEMENTS, WORDS, is_space, is_wide, relates};

/// Commands that print a frame, or a colour, around a formula, and how many arguments stand before it.
const FRAMES: &[(&str, usize)] = &[
    ("boxed", 0),
    ("Aboxed", 0),
    ("fbox", 0),
    ("framebox", 0),
    ("tcboxmath", 0),
    ("tcbhighmath", 0),
    ("colorbox", 1),
    ("fcolorbox", 2),
];
/// Boxes that are as wide as they are told to be.
const BOXES: &[&str] = &["makebox", "eqmakebox"];
/// Longest option in square brackets, in tokens.
const LONGEST_OPTION: usize = 100;
/// Frames in frames.
const DEEPEST: usize = 4;

/// A display without frames around relations.
pub(super) fn opened(mut body: Vec<Token>) -> Vec<Token> {
    let has_any = |t: &Token| {
        t.kind == Kind::Dollar
            || t.kind == Kind::Command && (BOXES.contains(&t.text.as_str()) || arguments_of(t).is_some())
    };
    for _ in 0..DEEPEST {
        if !body.iter().any(has_any) {
            break;
        }
        body = once(&body);
    }
    body
}

fn once(body: &[Token]) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(body.len());
    let mut at = 0;
    while let Some(token) = body.get(at) {
        if let Some((inside, after)) = framed(body, at).filter(|(_, after)| is_apart(&out, body, *after)) {
            out.extend_from_slice(inside);
            at = after;
        } else if let Some((inside, after)) = part_in_text(body, at) {
            let brace = |kind, text: &str| Token { kind, text: text.into(), span: token.span.clone() };
            let takes = |t: &Token| t.kind == Kind::Command || t.is_char("_") || t.is_char("^");
            let is_argument = out.iter().rev().find(|t| !is_space(t)).is_some_and(takes);
            out.extend(is_argument.then(|| brace(Kind::Open, "{")));
            out.extend_from_slice(inside);
            out.extend(is_argument.then(|| brace(Kind::Close, "}")));
            at = after;
        } else if let Some(content) = words_of_box(body, at) {
            out.push(Token { text: "text".into(), ..token.clone() });
            at = content;
        } else {
            out.push(token.clone());
            at += 1;
        }
    }
    out
}

/// How many arguments a frame has before what it stands around.
fn arguments_of(token: &Token) -> Option<usize> {
    let found = FRAMES.iter().find(|(name, _)| token.is(name));
    found.map(|(_, arguments)| *arguments)
}

/// The position after spaces, and options in square brackets.
fn after_options(tokens: &[Token], at: usize) -> Option<usize> {
    let spaces = |from: usize| from + tokens.iter().skip(from).take_while(|t| t.kind == Kind::Space).count();
    let mut next = spaces(at);
    while tokens.get(next).is_some_and(|t| t.is_char("[")) {
        let end = tokens.iter().skip(next).take(LONGEST_OPTION).position(|t| t.is_char("]"))?;
        next = spaces(next + end + 1);
    }
    tokens.get(next).is_some_and(|t| t.kind == Kind::Open).then_some(next)
}

/// What a frame stands around that begins here, where that relates something, and the position after it.
fn framed(tokens: &[Token], at: usize) -> Option<(&[Token], usize)> {
    let arguments = arguments_of(tokens.get(at)?)?;
    let mut open = after_options(tokens, at + 1)?;
    for _ in 0..arguments {
        open = after_options(tokens, group_text(tokens, open).1)?;
    }
    let after = group_text(tokens, open).1;
    let inside = tokens.get(open + 1..after.checked_sub(1)?)?;
    let mut printed = inside;
    while let Some((_, rest)) = printed.split_first().filter(|(first, _)| is_space(first)) {
        printed = rest;
    }
    while let Some((_, rest)) = printed.split_last().filter(|(last, _)| is_space(last)) {
        printed = rest;
    }
    if let [first, between @ .., last] = printed
        && first.kind == Kind::Dollar
        && last.kind == Kind::Dollar
    {
        printed = between;
    }
    let is_formula = printed.iter().all(|t| t.kind != Kind::Dollar);
    (is_formula && (relates(printed) || begins_lines(printed))).then_some((printed, after))
}

/// Whether lines of formulas stand below each other: `\boxed{\begin{aligned}…`.
fn begins_lines(tokens: &[Token]) -> bool {
    tokens.first().is_some_and(|t| t.is("begin")) && group_text(tokens, 1).0.starts_with("aligned")
}

/// Whether what stands before and behind a frame parts formulas.
fn is_apart(before: &[Token], body: &[Token], after: usize) -> bool {
    let parts = |t: &Token| {
        t.is_char("&")
            || t.is_char(",")
            || t.is_char(";")
            || is_wide(t)
            || t.kind == Kind::Command
                && matches!(t.text.as_str(), "\\" | "cr" | "label" | "tag" | "nonumber" | "notag" | "begin" | "end")
            || t.kind == Kind::Command && WORDS.contains(&t.text.as_str())
    };
    let printed = |t: &&Token| t.kind != Kind::Space;
    let first = before.iter().rev().find(printed);
    // A label or an environment ends with its brace.
    let begins = first.is_none_or(|t| parts(t) || t.kind == Kind::Close && ends_name(before));
    begins && body.iter().skip(after).find(printed).is_none_or(|t| parts(t) || t.is_char("."))
}

/// Whether some tokens end with `\begin{…}` or `\label{…}`.
fn ends_name(tokens: &[Token]) -> bool {
    let Some(open) = tokens.iter().rposition(|t| t.kind == Kind::Open) else { return false };
    let command = open.checked_sub(1).and_then(|at| tokens.get(at));
    command.is_some_and(|t| t.is("begin") || t.is("label") || t.is("tag"))
}

/// Where the text begins of a box that begins here, behind its options, `\makebox[3cm][l]{for all times}`, where no formula is in it.
fn words_of_box(tokens: &[Token], at: usize) -> Option<usize> {
    tokens.get(at).filter(|t| t.kind == Kind::Command && BOXES.contains(&t.text.as_str()))?;
    let open = after_options(tokens, at + 1)?;
    let inside = tokens.get(open..group_text(tokens, open).1)?;
    inside.iter().all(|t| t.kind != Kind::Dollar).then_some(open)
}

/// The part of a formula that begins here, where it stands between dollars in a text, and nothing else does, `a\mbox{$+$}b`; and the position
/// after it. What relates something there, or parts formulas, is not one.
fn part_in_text(tokens: &[Token], at: usize) -> Option<(&[Token], usize)> {
    tokens.get(at).filter(|t| t.kind == Kind::Command && WORDS.contains(&t.text.as_str()))?;
    let after = group_text(tokens, at + 1).1;
    let [open, between @ .., close] = tokens.get(at + 1..after)? else { return None };
    let [first, inside @ .., last] = between else { return None };
    let parts = |t: &Token| {
        t.kind == Kind::Dollar
            || matches!(t.text.as_str(), "," | ";")
            || t.kind == Kind::Command && BETWEEN_STATEMENTS.contains(&t.text.as_str())
    };
    let is_one =
        open.kind == Kind::Open && close.kind == Kind::Close && [first, last].iter().all(|t| t.kind == Kind::Dollar);
    (is_one && !inside.iter().any(parts) && !relates(inside)).then_some((inside, after))
}
