//! Differences: `\Delta x` as one name.
//!
//! **In:** a sign and what stands behind it. **Out:** the name of both. **Guaranteed:** what may go on is no name: in `\Delta xy` the difference may
//! be one of the product, in `\Delta x^2` of the square.

use super::letters::SIGNS_OF_DIFFERENCES as SIGNS;
use super::{By, Call, Names, PaperName};

impl Names {
    /// The name of a difference, whose sign stands before a place; the position after it.
    pub(super) fn joined(&mut self, sign: &str, at: usize, to: usize, by: &By) -> Option<usize> {
        if !SIGNS.contains(&sign) || !self.begins_name(at, to) || self.text(at) == "(" || self.text(at) == "^" {
            return None;
        }
        let count = self.out.len();
        let end = self.name(at, to, by).filter(|_| self.out.len() == count + 1);
        let name = self.out.get(count).cloned();
        self.out.truncate(count);
        let (end, name) = (end?, name?);
        let is_plain = name.dots + name.primes == 0
            && !name.has_hat
            && !name.is_difference
            && name.call == Call::None
            && !SIGNS.contains(&name.letter.as_str());
        if !is_plain || self.goes_on(end, to) {
            return None;
        }
        self.out.push(PaperName { base: format!("{sign} {}", name.base), ..name });
        Some(end)
    }

    /// Whether what a difference is taken of may go on: with a power, a factor, a place.
    fn goes_on(&self, at: usize, to: usize) -> bool {
        let text = self.text(at);
        let is_factor = text.starts_with(|c: char| c.is_alphanumeric()) || matches!(text, "(" | "[" | "^" | "'" | "!");
        let opens = matches!(text, r"\left" | r"\big" | r"\bigl" | r"\Big" | r"\Bigl" | r"\qty");
        at < to && !SIGNS.contains(&text) && (is_factor || opens || self.begins_name(at, to))
    }
}
