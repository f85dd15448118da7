//! Text for a terminal: layout and colour. Everything is readable without colour.

use findings::Outcome;

/// Widest line of a summary.
pub(super) const WIDTH: usize = 100;

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

/// Words laid out in lines that begin with `indent` and are at most [`WIDTH`] wide; a longer word has its own line.
pub(super) fn wrapped<S: AsRef<str>>(words: impl IntoIterator<Item = S>, indent: usize) -> String {
    let mut out = String::new();
    let mut width = 0;
    for word in words {
        let word = word.as_ref();
        let length = word.chars().count();
        if width > 0 && width + 1 + length > WIDTH {
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

/// A sentence as a part of another one: its first letter is small.
pub(super) fn uncapital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_lowercase().collect::<String>() + letters.as_str()).unwrap_or_default()
}
