//! Text for a terminal: layout and colour. Everything is readable without colour.

use std::sync::atomic::{AtomicUsize, Ordering};

use findings::Outcome;

/// Widest line of what is printed, where it does not go to a terminal.
pub(super) const WIDTH: usize = 100;
/// A terminal may be narrower or wider; beyond these widths nobody can read lines.
const WIDTHS: std::ops::RangeInclusive<usize> = 60..=160;
/// That of the terminal of this process.
static COLUMNS: AtomicUsize = AtomicUsize::new(WIDTH);

/// Lines out from now on in the width of a terminal. What is read elsewhere keeps its hundred letters.
pub fn fit_terminal(columns: usize) {
    COLUMNS.store(columns.clamp(*WIDTHS.start(), *WIDTHS.end()), Ordering::Relaxed);
}

/// The width of a line.
pub(super) fn width() -> usize {
    COLUMNS.load(Ordering::Relaxed)
}

/// Colours, or none.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paint(pub bool);

impl Paint {
    fn with(self, code: &str, text: &str) -> String {
        if self.0 && !text.trim().is_empty() { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_owned() }
    }
    pub fn bold(self, text: &str) -> String {
        self.with("1", text)
    }
    pub fn faint(self, text: &str) -> String {
        self.with("2", text)
    }
    /// What holds.
    pub fn good(self, text: &str) -> String {
        self.with("32", text)
    }
    /// What fails.
    pub fn bad(self, text: &str) -> String {
        self.with("31", text)
    }
    /// What is open.
    pub fn open(self, text: &str) -> String {
        self.with("33", text)
    }
    /// A text in the colour of a verdict.
    pub fn verdict(self, outcome: Outcome, text: &str) -> String {
        match outcome {
            Outcome::Holds(_) => self.good(text),
            Outcome::Fails(_) => self.bad(text),
            Outcome::NotApplicable(_) => self.faint(text),
            Outcome::Undecided => self.open(text),
        }
    }
    /// A text that asks for attention.
    pub fn alarm(self, text: &str) -> String {
        self.with("1;35", text)
    }
}

/// Words laid out in lines that begin with `indent` and are as wide as the terminal; a longer word has its own line.
pub(super) fn wrapped<S: AsRef<str>>(words: impl IntoIterator<Item = S>, indent: usize) -> String {
    wrapped_to(width(), words, indent)
}

fn wrapped_to<S: AsRef<str>>(most: usize, words: impl IntoIterator<Item = S>, indent: usize) -> String {
    let mut out = String::new();
    let mut width = 0;
    for word in words {
        let word = word.as_ref();
        let length = word.chars().count();
        if width > 0 && width + 1 + length > most {
            out.push('\n');
            width = 0;
        }
        if width == 0 {
            out.extend(std::iter::repeat_n(' ', indent));
            width = indent;
        } else {
            out.push(' ');
            width += 1;
        }
        out.push_str(word);
        width += length;
    }
    if width > 0 {
        out.push('\n');
    }
    out
}

/// A text laid out in lines.
pub(super) fn paragraph(text: &str, indent: usize) -> String {
    wrapped(text.split_whitespace(), indent)
}

/// A text of exactly this many characters: shortened with an ellipsis, or filled up with spaces.
pub(super) fn fitted(text: &str, width: usize) -> String {
    let length = text.chars().count();
    if length <= width {
        return format!("{text}{}", " ".repeat(width - length));
    }
    let kept: String = text.chars().take(width.saturating_sub(1)).collect();
    format!("{kept}…")
}

/// A sentence as a part of another one: its first letter is small, unless that is a letter of a formula or of a name.
pub(super) fn uncapital(text: &str) -> String {
    let mut letters = text.chars();
    let Some(first) = letters.next().filter(|_| begins_with_a_word(text)) else { return text.to_owned() };
    first.to_lowercase().chain(letters).collect()
}

/// A text as a sentence: its first letter is a capital.
pub(super) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |c| c.to_uppercase().chain(letters).collect())
}

/// Whether a text begins with a word, and not with a formula: `For every motion`, but not `R(0) = 1`, `I₁ = I₂`, or `E is conserved`.
fn begins_with_a_word(text: &str) -> bool {
    let mut words = text.split_whitespace();
    let first = words.next().unwrap_or_default().trim_end_matches([',', ':', ';', '.', '”']);
    // The article, and no letter: a noun or an adjective comes after it.
    if first == "A" {
        let next = words.next().unwrap_or_default();
        let is_verb = ["and", "or", "is", "are", "has", "does", "holds", "of", "in", "at", "to"].contains(&next);
        return !is_verb && next.starts_with(char::is_lowercase);
    }
    let mut rest = first.chars().skip(1).peekable();
    rest.peek().is_some() && rest.all(|c| c.is_lowercase() || c == '-' || c == '’')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_as_wide_as_they_may_be() {
        let words = ["word"; 40];
        for most in [60, 72, WIDTH, 160] {
            let text = wrapped_to(most, words, 2);
            let longest = text.lines().map(|l| l.chars().count()).max().unwrap_or(0);
            assert!(longest <= most && longest + 5 > most, "{most}: {text}");
        }
    }

    #[test]
    fn only_a_word_loses_its_capital() {
        for (text, within) in [
            ("For every motion", "for every motion"),
            ("A body turns", "a body turns"),
            ("Small-angle law: x", "small-angle law: x"),
            ("Holds, proved", "holds, proved"),
            ("", ""),
        ] {
            assert_eq!(uncapital(text), within);
        }
        for text in [
            "R(0) = 1",
            "I₁ = I₂",
            "E is conserved",
            "A and B do not hold",
            "E' = E",
            "2E is the sum",
            "R=1",
            "Ω × Ω",
            "$R$",
        ] {
            assert_eq!(uncapital(text), text);
        }
    }
}
