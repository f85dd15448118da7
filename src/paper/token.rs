//! Characters of a LaTeX document → tokens, each with its place.

use std::ops::Range;

use super::environments::OwnEnvironments;
use super::short::Short;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// `\name` or `\,`: the text is the name, without the backslash.
    Command,
    /// `{`
    Open,
    /// `}`
    Close,
    /// `$`
    Dollar,
    /// White space: a blank, or a line break where a paragraph ends.
    Space,
    /// `#` and a digit, in the body of a macro: the text is the digit.
    Argument,
    /// Any other character.
    Other,
}

/// A token and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Token {
    pub kind: Kind,
    pub text: Short,
    pub span: Range<usize>,
}

impl Token {
    /// Whether it is this command.
    pub fn is(&self, command: &str) -> bool {
        self.kind == Kind::Command && self.text == command
    }
    /// Whether it is a dollar, and another stands right behind it: two begin a display. Those between which a macro leaves nothing are an empty formula.
    pub fn is_doubled_by(&self, next: Option<&Token>) -> bool {
        let is_near = |next: &Token| next.span == self.span || next.span.start == self.span.end;
        self.kind == Kind::Dollar && next.is_some_and(|next| next.kind == Kind::Dollar && is_near(next))
    }
    /// Whether it is this character.
    pub fn is_char(&self, c: &str) -> bool {
        self.kind == Kind::Other && self.text == c
    }
}

/// Commands whose argument is no LaTeX, and how many arguments in braces stand before it.
const VERBATIM_ARGUMENT: &[(&str, usize)] = &[
    ("url", 0),
    ("nolinkurl", 0),
    ("path", 0),
    ("href", 0),
    ("lstinline", 0),
    ("spverb", 0),
    ("Verb", 0),
    ("mintinline", 1),
];

/// Commands after which a character encloses verbatim texts, and those that end this.
const SHORT_VERBATIM: &[(&str, bool)] = &[
    ("DefineShortVerb", true),
    ("MakeShortVerb", true),
    ("lstMakeShortInline", true),
    ("UndefineShortVerb", false),
    ("DeleteShortVerb", false),
    ("lstDeleteShortInline", false),
];

/// The command before the beginning of an environment of which it is not known whether it is printed; its name follows.
pub(super) const IN_DOUBT: &str = "in doubt ";

/// The command that stands where something that is not printed begins and has no end; no text has it.
pub(super) const UNENDED: &str = "has no end";

/// The most tokens that a paper may have, before its macros are expanded and after.
pub(super) const MOST_TOKENS: usize = 4_000_000;

/// Splits a text; comments and verbatim texts leave no token. Of a text with more than [`MOST_TOKENS`] one more is given, for who asks.
pub(super) fn tokens(text: &str) -> Vec<Token> {
    tokens_with(text, &mut OwnEnvironments::default())
}

/// The same, where environments are made in other files, too.
pub(super) fn tokens_with(text: &str, own: &mut OwnEnvironments) -> Vec<Token> {
    // A list that grows is copied, and is there twice then; room that is not used takes no memory.
    let mut out = Vec::with_capacity(text.len().min(MOST_TOKENS + 1));
    let mut at = 0;
    // Whether a comment ended here, so that an empty line that follows ends a paragraph.
    let mut after_comment = false;
    let mut short: Vec<char> = Vec::new();
    while out.len() <= MOST_TOKENS
        && let Some(c) = text.get(at..).and_then(|t| t.chars().next())
    {
        let start = at;
        at += c.len_utf8();
        let line_begins = std::mem::take(&mut after_comment);
        if short.contains(&c)
            && let Some(end) = text[at..].find([c, '\n']).filter(|i| text[at + i..].starts_with(c))
        {
            // Inside of a formula this is told; in the running text nobody looks at it.
            at += end + c.len_utf8();
            out.push(Token { kind: Kind::Command, text: "verb".into(), span: start..at });
            continue;
        }
        let (kind, shown) = match c {
            '%' => {
                at = text[at..].find('\n').map_or(text.len(), |i| at + i + 1);
                // A comment takes the spaces of the next line with it.
                at += text[at..].len() - text[at..].trim_start_matches([' ', '\t']).len();
                after_comment = true;
                continue;
            }
            '{' => (Kind::Open, "{"),
            '}' => (Kind::Close, "}"),
            '$' => (Kind::Dollar, "$"),
            '#' => match text[at..].chars().next() {
                Some(d @ '1'..='9') => {
                    at += 1;
                    out.push(Token { kind: Kind::Argument, text: d.into(), span: start..at });
                    continue;
                }
                _ => (Kind::Other, "#"),
            },
            '\\' => {
                let rest = &text[at..];
                let ascii = rest.bytes().take_while(|b| b.is_ascii_alphabetic() || *b == b'@').count();
                // A name in another script is one, too; behind ASCII letters such a letter is text.
                let letters = if ascii > 0 { ascii } else { letters_of_another_script(rest) };
                let length = if letters > 0 { letters } else { rest.chars().next().map_or(0, char::len_utf8) };
                let name = &rest[..length];
                at += length;
                if name == "verb" {
                    at = after_verb(text, text.len() - text[at..].trim_start_matches([' ', '\t']).len());
                    continue;
                }
                if let Some((_, begins)) = SHORT_VERBATIM.iter().find(|(command, _)| *command == name) {
                    at = short_verbatim(text, at, *begins, &mut short);
                    continue;
                }
                if let Some((_, before)) = VERBATIM_ARGUMENT.iter().find(|(command, _)| *command == name)
                    && let Some(end) = after_argument(text, at, *before, name)
                {
                    at = end;
                    continue;
                }
                own.take(name, text, at);
                if let Some(found) = own.after_unprinted(name, text, at) {
                    if found.is_err() {
                        out.push(Token { kind: Kind::Command, text: UNENDED.into(), span: start..at });
                    }
                    at = found.unwrap_or(text.len());
                    continue;
                }
                if let Some(which) = own.in_doubt(name, text, at) {
                    out.push(Token { kind: Kind::Command, text: format!("{IN_DOUBT}{which}").into(), span: start..at });
                }
                out.push(Token { kind: Kind::Command, text: name.into(), span: start..at });
                if letters > 0 {
                    at += text[at..].len() - text[at..].trim_start_matches([' ', '\t']).len();
                }
                continue;
            }
            c if c.is_whitespace() => {
                at += text[at..].len() - text[at..].trim_start().len();
                let breaks = text[start..at].matches('\n').count() + usize::from(line_begins);
                (Kind::Space, if breaks > 1 { "\n" } else { " " })
            }
            _ => {
                out.push(Token { kind: Kind::Other, text: c.into(), span: start..at });
                continue;
            }
        };
        out.push(Token { kind, text: shown.into(), span: start..at });
    }
    out
}

/// The bytes of the letters with which a text begins, none of them ASCII.
fn letters_of_another_script(text: &str) -> usize {
    text.chars().take_while(|c| !c.is_ascii() && c.is_alphabetic()).map(char::len_utf8).sum()
}

/// The end of `\verb|…|`, whose bar is at `at`.
fn after_verb(text: &str, at: usize) -> usize {
    let rest = text[at..].strip_prefix('*').unwrap_or(&text[at..]);
    let from = text.len() - rest.len();
    let Some(bar) = rest.chars().next() else { return text.len() };
    let body = from + bar.len_utf8();
    text[body..].find([bar, '\n']).map_or(text.len(), |i| body + i + 1)
}

/// Notes the character that a command of [`SHORT_VERBATIM`] names, as `{\|}`; where its argument ends.
fn short_verbatim(text: &str, at: usize, begins: bool, short: &mut Vec<char>) -> usize {
    let mut rest = text[at..].trim_start_matches('*');
    if let Some((_, after)) = rest.strip_prefix('[').and_then(|r| r.split_once(']')) {
        rest = after;
    }
    let inside = rest.trim_start_matches(['{', '\\', ' ']);
    let Some(c) = inside.chars().next().filter(|c| !c.is_alphanumeric() && !"{}\\$%".contains(*c)) else { return at };
    short.retain(|known| *known != c);
    if begins {
        short.push(c);
    }
    let after = &inside[c.len_utf8()..];
    text.len() - after.strip_prefix('}').unwrap_or(after).len()
}

/// The end of an argument that is no LaTeX, behind so many others in braces: in braces, or between two signs.
fn after_argument(text: &str, at: usize, before: usize, command: &str) -> Option<usize> {
    let mut at = at;
    let blank = |at: usize| at + text[at..].len() - text[at..].trim_start_matches([' ', '*']).len();
    at = blank(at);
    if text[at..].starts_with('[') {
        at += text[at..].lines().next()?.find(']')? + 1;
    }
    for _ in 0..before {
        at = after_braces(text, blank(at))?;
    }
    let next = text[at..].chars().next()?;
    if next == '{' {
        return after_braces(text, at);
    }
    // Behind a name in a definition no sign encloses anything.
    let encloses = next.is_ascii_punctuation() && !"{}\\#%=,.;:)(".contains(next);
    let is_code = matches!(command, "lstinline" | "mintinline" | "Verb" | "spverb");
    // `\path(0,0)` draws.
    let is_name = matches!(command, "url" | "path" | "nolinkurl") && "|!\"/@~^".contains(next);
    (encloses && is_code || is_name).then(|| after_verb(text, at))
}

/// The end of what stands in braces, of which the first is at `at`; an escaped one counts for none.
fn after_braces(text: &str, at: usize) -> Option<usize> {
    let mut depth = 0usize;
    let mut escaped = false;
    for (i, c) in text.get(at..)?.char_indices() {
        match c {
            _ if escaped => {
                escaped = false;
                continue;
            }
            '\\' => escaped = true,
            '{' => depth += 1,
            '}' if depth <= 1 => return (depth == 1).then_some(at + i + 1),
            '}' => depth -= 1,
            _ if depth == 0 => return None,
            // What is in braces ends with its paragraph.
            '\n' if text[at + i + 1..].trim_start_matches([' ', '\t']).starts_with('\n') => return None,
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<String> {
        tokens(text).into_iter().map(|t| t.text.to_string()).collect()
    }

    #[test]
    fn tokens_know_their_place() {
        let text = r"a\dot q % no \label{x}
  =\,1";
        let found = tokens(text);
        assert_eq!(shown(text), ["a", "dot", "q", " ", "=", ",", "1"]);
        for token in found.iter().filter(|t| t.kind == Kind::Other) {
            assert_eq!(text[token.span.clone()], token.text);
        }
    }

    #[test]
    fn what_is_verbatim_or_a_comment_is_passed_over() {
        assert_eq!(shown(r"\ابتدا{a}\é b\alpha中"), ["ابتدا", "{", "a", "}", "é", "b", "alpha", "中"]);
        assert_eq!(shown(r"\verb|$x$|y\begin{verbatim}$z$\end{verbatim}\%50%$"), ["y", "%", "5", "0"]);
    }

    #[test]
    fn arguments_that_are_no_latex_are_passed_over() {
        for (text, is_printed) in [
            (r"\url{http://a%20b}Q", true),
            (r"\href{http://a%20b}{Q}", true),
            (r"\url{$Q$}\lstinline|$Q$|\mintinline{c}{$Q$}\lstinline[a=b]{$Q$}", false),
            (r"\path|$Q$|\url!Q!", false),
            (r"\path (0,0) -- (Q);", true),
            (r"\mintinline{c}|Q|Q", true),
            (r"\verb |Q| x", false),
            (r"\verb* |Q| x", false),
        ] {
            assert_eq!(shown(text).iter().any(|t| t == "Q"), is_printed, "{text}");
        }
        // The name in its own definition is none of these.
        assert_eq!(shown(r"\def\url#1{x}").concat(), "defurl1{x}");
    }

    #[test]
    fn no_text_panics() {
        for text in [
            "\\",
            "\\verb",
            "\\verb*",
            "\\begin{verbatim",
            "\\begin{verbatim}é",
            "%",
            "#",
            "é\\é",
            "\\verb|é",
            "\\lstinline[é]{é}",
            "\\newenvironment{é}[1]{\\é}{}",
            "\\url{é}",
        ] {
            for end in (0..=text.len()).filter(|i| text.is_char_boundary(*i)) {
                tokens(&text[..end]);
            }
        }
    }
}
