//! The tokens of a document that are still to be read, and the pieces that are taken from them.
//!
//! **In:** tokens on a stack, the next one last, each with the depth of macros that it came from. **Out:** arguments, options, names.

use super::super::token::{Kind, Token};

/// The most arguments of a macro, as TeX has it.
pub(super) const MOST_ARGUMENTS: usize = 9;
/// The most characters of the name of an environment or of a file.
pub(super) const MOST_NAME: usize = 200;

#[derive(Clone, Debug)]
pub(super) struct Macro {
    pub arguments: usize,
    pub default: Option<Vec<Token>>,
    pub body: Vec<Token>,
    /// The pattern of a call behind its name, where that is more than arguments: `#1` and the signs between them, as in
    /// `\def\at(#1,#2){…}`, or the slash of `\def\ns/{…}`.
    pub pattern: Vec<Token>,
    /// Defaults of options behind the arguments, as `\NewDocumentCommand{\rhs}{mmO{l}}{…}` has one.
    pub options: Vec<Vec<Token>>,
    /// `\edef` leaves it as it stands.
    pub is_robust: bool,
    /// A star may stand behind its name: its first argument, which conditions ask for.
    pub has_star: bool,
}

impl Macro {
    /// A macro whose arguments stand behind each other.
    pub(super) fn plain(arguments: usize, default: Option<Vec<Token>>, body: Vec<Token>) -> Macro {
        Macro { arguments, default, body, pattern: Vec::new(), options: Vec::new(), is_robust: false, has_star: false }
    }
}

pub(super) type Rest = Vec<(Token, usize)>;

pub(super) fn spaces(rest: &mut Rest) {
    while rest.last().is_some_and(|(t, _)| t.kind == Kind::Space) {
        rest.pop();
    }
}

pub(super) fn next_is(rest: &mut Rest, c: &str) -> bool {
    spaces(rest);
    let found = rest.last().is_some_and(|(t, _)| t.is_char(c));
    if found {
        rest.pop();
    }
    found
}

/// Whether an argument in braces comes next, or an option and then one.
pub(super) fn takes_braces(rest: &Rest) -> bool {
    let mut next = rest.iter().rev().map(|(t, _)| t).filter(|t| t.kind != Kind::Space).peekable();
    while next.peek().is_some_and(|t| t.is_char("[")) {
        if next.by_ref().take(MOST_NAME).all(|t| !t.is_char("]")) {
            return false;
        }
    }
    next.next().is_some_and(|t| t.kind == Kind::Open)
}

/// An argument: a group without its braces, or one token.
pub(super) fn argument(rest: &mut Rest) -> Vec<Token> {
    spaces(rest);
    match rest.pop() {
        Some((t, _)) if t.kind == Kind::Open => {
            let mut depth = 0;
            let mut out = Vec::new();
            while let Some((t, _)) = rest.pop() {
                match t.kind {
                    Kind::Open => depth += 1,
                    Kind::Close if depth == 0 => break,
                    Kind::Close => depth -= 1,
                    _ => {}
                }
                out.push(t);
            }
            out
        }
        Some((t, _)) => vec![t],
        None => Vec::new(),
    }
}

/// An argument in brackets, if there is one.
pub(super) fn optional(rest: &mut Rest) -> Option<Vec<Token>> {
    if !next_is(rest, "[") {
        return None;
    }
    let mut depth = 0;
    let mut out = Vec::new();
    while let Some((t, _)) = rest.pop() {
        match t.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth -= 1,
            _ if depth == 0 && t.is_char("]") => break,
            _ => {}
        }
        out.push(t);
    }
    Some(out)
}

/// The name that a definition defines: `\name` or `{\name}`.
pub(super) fn defined_name(rest: &mut Rest) -> Option<String> {
    let found = argument(rest);
    let name = found.iter().find(|t| t.kind != Kind::Space)?;
    (name.kind == Kind::Command).then(|| name.text.to_string())
}

/// The name in braces that comes next.
pub(super) fn name_ahead(rest: &Rest) -> String {
    let mut next = rest.iter().rev().map(|(t, _)| t).skip_while(|t| t.kind == Kind::Space);
    if next.next().is_none_or(|t| t.kind != Kind::Open) {
        return String::new();
    }
    next.take_while(|t| t.kind != Kind::Close).take(MOST_NAME).map(|t| t.text.as_str()).collect()
}

/// The most tokens that are looked at, in all, to find where what is ahead ends.
pub(super) const MOST_AHEAD: usize = 20_000_000;

/// The end of the groups and options that follow right here, if there are such.
pub(super) fn end_of_groups(rest: &Rest, looked: &mut usize) -> Option<usize> {
    let (mut depth, mut end) = (0usize, None);
    for (token, _) in rest.iter().rev() {
        *looked += 1;
        if *looked > MOST_AHEAD {
            return None;
        }
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close if depth == 0 => return end,
            Kind::Close => depth -= 1,
            Kind::Space if token.text.contains('\n') && depth == 0 => return end,
            Kind::Space => continue,
            _ if token.is_char("[") && depth == 0 => depth += 1,
            _ if token.is_char("]") && depth == 1 => depth -= 1,
            _ if depth == 0 => return end,
            _ => {}
        }
        if depth == 0 {
            end = Some(token.span.end);
        }
    }
    end
}
