//! Characters → tokens.
//!
//! Spacing, sizes (`\left`, `\displaystyle`), labels and comments leave no token. Everything else does: nothing is dropped
//! that could change a meaning.

use std::ops::Range;

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
    "bigl",
    "bigr",
    "Bigl",
    "Bigr",
    "bigg",
    "Bigg",
    "biggl",
    "biggr",
    "Biggl",
    "Biggr",
    "hfill",
];

/// Longest formula that is read, in bytes.
pub(super) const LONGEST: usize = 1 << 20;

fn problem(code: &'static str, message: String, span: Range<usize>, hint: &str) -> Problem {
    Problem { code, message, span, hint: (!hint.is_empty()).then(|| hint.to_owned()) }
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
    let mut pending_bar = None;
    // Of each bar that is open by its command, whether it is double.
    let mut bars = Vec::new();
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
            '|' => match pending_bar.take() {
                Some(true) => push(Kind::OpenBar, at),
                Some(false) => push(Kind::CloseBar, at),
                None => push(Kind::Sign('|'), at),
            },
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
                        '\\' => push(Kind::Row, at),
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
                    "left" | "right" => {
                        // What follows is an ordinary delimiter; only bars need to know their side.
                        let next = text[at..].trim_start();
                        let (signs, bar) = match name {
                            "left" => (['(', '[', '|', '.'], [r"\lvert", r"\lVert"]),
                            _ => ([')', ']', '|', '.'], [r"\rvert", r"\rVert"]),
                        };
                        let whole = [r"\lfloor", r"\rfloor", r"\lceil", r"\rceil", r"\{", r"\}"];
                        if whole.iter().any(|w| next.starts_with(w)) {
                            // A bracket that says by itself which side it is on.
                        } else if !next.starts_with(signs) && !bar.iter().any(|b| next.starts_with(b)) {
                            problems.push(problem(
                                "latex::unexpected",
                                format!("`\\{name}` stands before a bracket"),
                                start..at,
                                "",
                            ));
                        } else if next.starts_with('|') {
                            pending_bar = Some(name == "left");
                        } else if next.starts_with('.') && name == "left" {
                            at = text.len() - next.len() + 1;
                            push(Kind::OpenFence, at);
                        } else if next.starts_with('.') {
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
                        bars.push(name == "lVert");
                        push(Kind::OpenBar, at);
                    }
                    "rvert" | "rVert" => {
                        if bars.pop().is_some_and(|double| double != (name == "rVert")) {
                            let message = "a single and a double bar".to_owned();
                            problems.push(problem("latex::unbalanced", message, start..at, "write two of a kind"));
                        }
                        push(Kind::CloseBar, at);
                    }
                    "label" | "tag" | "hspace" | "vspace" | "kern" => {
                        let group = text[at..].trim_start();
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
            other => {
                let hint = match other {
                    '−' | '–' => "write `-`",
                    '·' | '×' => r"write `\cdot` or `\times`",
                    _ => "write Greek letters and signs as LaTeX commands",
                };
                let message = format!("the character `{other}` is not part of the formula language");
                problems.push(problem("latex::unknown-character", message, start..at, hint));
            }
        }
    }
    out.push(Token { kind: Kind::End, span: text.len()..text.len() });
    if problems.is_empty() { Ok(out) } else { Err(problems) }
}
