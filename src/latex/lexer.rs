//! Characters → tokens.
//!
//! Spacing, sizes (`\left`, `\displaystyle`), labels and comments leave no token. Everything else does: nothing is dropped
//! that could change a meaning.

use std::ops::Range;

use super::unicode;
use diag::Problem;

/// What a token is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// `\name`, without the backslash; and a sign as a label, as in `J_+`.
    Command(String),
    /// One letter.
    Letter(char),
    /// Digits, with an optional decimal part.
    Number(String),
    /// Any other single character with a meaning: `+ - * / = < > ( ) [ ] { } _ ^ , | & '`.
    Sign(char),
    /// `|` that opens or closes because of `\left`, `\right`.
    OpenBar,
    /// See [`Kind::OpenBar`].
    CloseBar,
    /// `\left.`, which opens what a bar on the right belongs to: `\left.\dot x\right|_{t=0}`.
    OpenFence,
    /// `\\` or `\cr`.
    Row,
    /// The end of the text.
    End,
}

/// A token and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Token {
    pub kind: Kind,
    pub span: Range<usize>,
}

/// Commands without meaning for a formula.
const IGNORED: &[&str] = &[
    "quad",
    "qquad",
    "displaystyle",
    "textstyle",
    "nonumber",
    "notag",
    "limits",
    "nolimits",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigm",
    "Bigm",
    "hfill",
    "hfil",
    "scriptstyle",
    "scriptscriptstyle",
    "relax",
    "null",
    "strut",
    "mathstrut",
    "allowbreak",
    "nobreak",
    "noindent",
    "normalfont",
    "thinspace",
    "negthinspace",
    "medspace",
    "thickspace",
    "enspace",
    "enskip",
];

/// Commands for the sizes of brackets that say on which side these are.
fn side(command: &str) -> Option<bool> {
    match command {
        "left" | "bigl" | "Bigl" | "biggl" | "Biggl" => Some(true),
        "right" | "bigr" | "Bigr" | "biggr" | "Biggr" => Some(false),
        _ => None,
    }
}

/// The bar with which a text begins: its length, and whether it is double.
fn bar(text: &str) -> Option<(usize, bool)> {
    const BARS: [(&str, bool); 8] = [
        (r"\lvert", false),
        (r"\rvert", false),
        (r"\vert", false),
        (r"\lVert", true),
        (r"\rVert", true),
        (r"\Vert", true),
        (r"\|", true),
        ("|", false),
    ];
    BARS.iter().find(|(bar, _)| text.starts_with(bar)).map(|(bar, double)| (bar.len(), *double))
}

/// Where the length ends that stands behind `\kern` and its kin: `3pt`, `-\!2 mu`.
fn behind_length(text: &str) -> usize {
    let sign = |c: char| matches!(c, ' ' | '+' | '-' | '.') || c.is_ascii_digit();
    let digits = text.len() - text.trim_start_matches(sign).len();
    let unit = text[digits..].get(..2).filter(|u| u.bytes().all(|b| b.is_ascii_lowercase()));
    if text[..digits].bytes().any(|b| b.is_ascii_digit()) && unit.is_some() { digits + 2 } else { 0 }
}

/// Where the space ends that a break of lines may have: `*`, `[1.5ex]`.
fn behind_row(text: &str) -> usize {
    let star = usize::from(text.starts_with('*'));
    let inside = text[star..].trim_start().strip_prefix('[').and_then(|rest| rest.split_once(']'));
    let length = inside.filter(|(length, _)| !length.is_empty() && behind_length(length) == length.trim_end().len());
    length.map_or(star, |(_, rest)| text.len() - rest.len())
}

/// Longest formula that is read, in bytes.
pub(super) const LONGEST: usize = 1 << 20;

fn problem(code: &'static str, message: String, span: Range<usize>, hint: &str) -> Problem {
    Problem { code, message, span, hint: (!hint.is_empty()).then(|| hint.to_owned()) }
}

/// The token that the spelling of a character is: none for a space; `None` where it is several.
fn unicode_token(text: &str) -> Option<Option<Kind>> {
    let mut chars = text.chars();
    match (chars.next(), chars.as_str()) {
        (Some(' ' | '~'), "") | (Some('\\'), "," | ":") => Some(None),
        (Some(c), "") if c.is_ascii_alphabetic() => Some(Some(Kind::Letter(c))),
        (Some(c), "") if c.is_ascii_digit() => Some(Some(Kind::Number(c.to_string()))),
        (Some(c), "") if c.is_ascii() => Some(Some(Kind::Sign(c))),
        (Some('\\'), "vert") => Some(Some(Kind::Sign('|'))),
        (Some('\\'), name) if !name.is_empty() && name.bytes().all(|b| b.is_ascii_alphabetic()) => {
            Some(Some(Kind::Command(name.to_owned())))
        }
        _ => None,
    }
}

/// How many `\left.` a text has.
fn lefts_without_delimiter(text: &str) -> usize {
    text.match_indices(r"\left").filter(|(i, left)| text[i + left.len()..].trim_start().starts_with('.')).count()
}

/// Splits a text into tokens; the last one is [`Kind::End`].
pub(super) fn tokens(text: &str) -> Result<Vec<Token>, Vec<Problem>> {
    if text.len() > LONGEST {
        let message = format!("the formula has {} bytes; {LONGEST} is the limit", text.len());
        return Err(vec![problem("latex::too-long", message, 0..0, "")]);
    }
    let mut out = Vec::new();
    let mut problems = Vec::new();
    let bytes = text.as_bytes();
    let mut at = 0;
    // Of each bar that is open by its command, whether it is double; of `\left.`, nothing.
    let mut bars: Vec<Option<bool>> = Vec::new();
    // How many brackets go on behind a break, `\left(a \right. \left. +b\right)`.
    let mut broken = 0usize;
    let mut lefts = lefts_without_delimiter(text);
    while let Some(c) = text[at..].chars().next() {
        let start = at;
        at += c.len_utf8();
        let lowers = matches!(out.last(), Some(Token { kind: Kind::Sign('_'), .. }));
        let mut push = |kind: Kind, end: usize| out.push(Token { kind, span: start..end });
        match c {
            ' ' | '\t' | '\n' | '\r' | '~' => continue,
            '%' => {
                at = text[at..].find('\n').map_or(text.len(), |i| at + i);
                continue;
            }
            '0'..='9' => {
                while bytes.get(at).is_some_and(u8::is_ascii_digit) {
                    at += 1;
                }
                if bytes.get(at) == Some(&b'.') && bytes.get(at + 1).is_some_and(u8::is_ascii_digit) {
                    at += 1;
                    while bytes.get(at).is_some_and(u8::is_ascii_digit) {
                        at += 1;
                    }
                }
                push(Kind::Number(text[start..at].to_owned()), at);
            }
            'a'..='z' | 'A'..='Z' => push(Kind::Letter(c), at),
            ':' if bytes.get(at) == Some(&b'=') => {
                at += 1;
                push(Kind::Sign('='), at);
            }
            '|' => push(Kind::Sign('|'), at),
            // `J_+`: a label, no sign between terms.
            '+' | '-' | '*' if lowers => push(Kind::Command(c.to_string()), at),
            '+' | '-' | '*' | '/' | '=' | '<' | '>' | '(' | ')' | '[' | ']' | '{' | '}' | '_' | '^' | ',' | '.'
            | '&' | '\'' | ';' | '!' => push(Kind::Sign(c), at),
            '\\' => {
                let rest = &text[at..];
                let letters = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
                if letters == 0 {
                    let Some(symbol) = rest.chars().next() else {
                        problems.push(problem(
                            "latex::stray-backslash",
                            "a backslash ends the formula".into(),
                            start..at,
                            "",
                        ));
                        break;
                    };
                    at += symbol.len_utf8();
                    match symbol {
                        ',' | ';' | ':' | '>' | '!' | ' ' | '/' => {}
                        '\\' => {
                            push(Kind::Row, at);
                            at += behind_row(&text[at..]);
                        }
                        '{' | '}' => push(Kind::Command(symbol.to_string()), at),
                        '|' => push(Kind::Command("|".into()), at),
                        other => problems.push(problem(
                            "latex::unknown-command",
                            format!("`\\{other}` is not known"),
                            start..at,
                            "",
                        )),
                    }
                    continue;
                }
                let name = &rest[..letters];
                at += letters;
                match name {
                    "cr" | "newline" => push(Kind::Row, at),
                    _ if side(name).is_some() => {
                        // What follows is an ordinary delimiter; only bars need to know their side.
                        let opens = side(name) == Some(true);
                        let next = text[at..].trim_start();
                        let here = text.len() - next.len();
                        let fence = matches!(name, "left" | "right");
                        let signs = if opens { ['(', '[', '<'] } else { [')', ']', '>'] };
                        if let Some((length, double)) = bar(next) {
                            at = here + length;
                            let kind = if opens { Kind::OpenBar } else { Kind::CloseBar };
                            out.push(Token { kind, span: here..at });
                            if opens {
                                bars.push(Some(double));
                            } else if bars.pop().flatten().is_some_and(|other| other != double) {
                                let message = "a single and a double bar".to_owned();
                                problems.push(problem("latex::unbalanced", message, here..at, "write two of a kind"));
                            }
                        } else if next.starts_with(signs) || next.starts_with(['\\', '/']) {
                            // A bracket that says by itself which side it is on.
                        } else if !next.starts_with('.') || !fence {
                            problems.push(problem(
                                "latex::unexpected",
                                format!("`\\{name}` stands before a bracket"),
                                start..at,
                                "",
                            ));
                        } else if !opens && lefts > broken {
                            at = here + 1;
                            broken += 1;
                        } else if opens {
                            at = here + 1;
                            lefts = lefts.saturating_sub(1);
                            if broken > 0 {
                                broken -= 1;
                                continue;
                            }
                            bars.push(None);
                            push(Kind::OpenFence, at);
                        } else {
                            problems.push(problem(
                                "latex::invisible-delimiter",
                                format!("`\\{name}.` has no delimiter"),
                                start..at,
                                "write both delimiters of the pair",
                            ));
                        }
                    }
                    // The norm of a vector is its length, as with single bars.
                    "lvert" | "lVert" => {
                        bars.push(Some(name == "lVert"));
                        push(Kind::OpenBar, at);
                    }
                    "rvert" | "rVert" => {
                        if bars.pop().flatten().is_some_and(|double| double != (name == "rVert")) {
                            let message = "a single and a double bar".to_owned();
                            problems.push(problem("latex::unbalanced", message, start..at, "write two of a kind"));
                        }
                        push(Kind::CloseBar, at);
                    }
                    "vert" => push(Kind::Sign('|'), at),
                    "kern" | "mkern" | "hskip" | "mskip" | "vskip" if behind_length(&text[at..]) > 0 => {
                        at += behind_length(&text[at..]);
                    }
                    "label" | "tag" | "hspace" | "vspace" | "kern" | "mkern" | "hskip" | "mskip" => {
                        let group = text[at..].trim_start().trim_start_matches('*').trim_start();
                        let offset = text.len() - group.len();
                        let mut depth = 0usize;
                        let end = group.bytes().position(|b| {
                            depth += usize::from(b == b'{');
                            depth = depth.saturating_sub(usize::from(b == b'}'));
                            depth == 0
                        });
                        match end {
                            Some(end) if end > 0 => at = offset + end + 1,
                            _ => problems.push(problem(
                                "latex::unbalanced",
                                format!("`\\{name}` needs an argument in braces"),
                                start..at,
                                "",
                            )),
                        }
                    }
                    _ if IGNORED.contains(&name) => {}
                    _ => push(Kind::Command(name.to_owned()), at),
                }
            }
            other => match unicode::spelled(other) {
                Some(text) => match unicode_token(&text) {
                    Some(Some(kind)) => push(kind, at),
                    Some(None) => {}
                    // What is several tokens is written out later.
                    None => push(Kind::Command(other.to_string()), at),
                },
                None => {
                    let message = format!("the character `{other}` is not part of the formula language");
                    let hint = "write letters and signs as LaTeX commands";
                    problems.push(problem("latex::unknown-character", message, start..at, hint));
                }
            },
        }
    }
    out.push(Token { kind: Kind::End, span: text.len()..text.len() });
    if problems.is_empty() { Ok(out) } else { Err(problems) }
}
