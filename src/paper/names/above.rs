//! Labels above a name, and brackets around it: neither its letter nor its subscript.
//!
//! **In:** the marks of a formula. **Out:** a label, or the name of an amount, `[X]`. **Guaranteed:** what could be a power, a transpose, an
//! index or a factor is none.

use super::Names;
use super::letters::is_upright_label;

impl Names {
    /// A capital letter alone in square brackets, `[X]`: nobody sets a factor so, it is a name.
    pub(super) fn amount(&self, at: usize, to: usize) -> Option<String> {
        let inside = self.text(at + 1);
        let is_capital = inside.len() == 1 && inside.bytes().all(|b| b.is_ascii_uppercase());
        let before = at.checked_sub(1).map_or("", |b| self.text(b));
        let stands = at + 2 < to && self.text(at) == "[" && self.text(at + 2) == "]" && is_capital;
        (stands && !matches!(before, r"\sqrt" | "\\")).then(|| format!("[{inside}]"))
    }

    /// A label above a name, and the position after it: a number in parentheses, a sign alone, upright letters. Anything else is a power,
    /// or an index; an upright T is a transpose.
    pub(super) fn label_above(&self, at: usize) -> Option<(String, usize)> {
        let end = self.script_end(at);
        let (from, to) = if self.text(at) == "{" { self.inner(at) } else { (at, end) };
        let inside: Vec<&str> = (from..to).map(|i| self.text(i)).collect();
        let digits = |t: &[&str]| !t.is_empty() && t.iter().all(|t| t.len() == 1 && t.as_bytes()[0].is_ascii_digit());
        let label = match inside.as_slice() {
            ["(", inner @ .., ")"] => digits(inner) || is_word_in_parentheses(inner),
            [_, _, ..] if inside.iter().all(|t| *t == "*") => true,
            [one] => matches!(*one, "*" | "+" | "-" | r"\ast" | r"\circ" | r"\star"),
            upright => is_upright_label(upright),
        };
        label.then(|| match inside.as_slice() {
            // The braces of a single letter are those of its style.
            ["(", style, letter, ")"] if style.starts_with('\\') => (format!("({style}{{{letter}}})"), end),
            _ => (self.spelled(from, to), end),
        })
    }
}

/// Whether what stands above a name in parentheses is a label, and no order, index or place: a word, or a letter that is upright, a
/// capital, or `e`, which is no number there.
fn is_word_in_parentheses(inside: &[&str]) -> bool {
    let upright = inside.first().is_some_and(|t| matches!(*t, r"\mathrm" | r"\text" | r"\textrm"));
    let letters: Vec<&str> =
        inside.iter().skip(usize::from(upright)).copied().filter(|t| !matches!(*t, "{" | "}")).collect();
    let all = !letters.is_empty() && letters.iter().all(|t| t.len() == 1 && t.as_bytes()[0].is_ascii_alphabetic());
    let indices = letters.iter().all(|t| "ijklmnpq".contains(t));
    all && (upright
        || letters.len() > 1 && !indices
        || letters.iter().all(|t| *t == "e" || t.as_bytes()[0].is_ascii_uppercase()))
}
