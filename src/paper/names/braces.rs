//! Braces around a name that print nothing.
//!
//! **In:** the marks of a formula. **Out:** the same without them, where a script follows: it belongs to the name.

use super::super::mark::{self, Mark};
use super::letters::{BOLD, DOTS, HATS, STYLES, is_switch};

/// `{\bf P}_x` is `\mathbf P_x`: braces around one name that print nothing, where a script follows them.
pub fn without_braces_of_names(marks: Vec<Mark>) -> Vec<Mark> {
    let command = |m: Option<&Mark>| m.and_then(|m| m.text.strip_prefix('\\')).unwrap_or("").to_owned();
    let mut out: Vec<Mark> = Vec::with_capacity(marks.len());
    let mut closing: Vec<usize> = Vec::new();
    let units = mark::units(&marks);
    for at in 0..marks.len() {
        if closing.last() == Some(&at) {
            closing.pop();
            continue;
        }
        let named = command(marks.get(at + 1));
        let styled = [BOLD, HATS, STYLES].iter().any(|s| s.contains(&named.as_str())) && !is_switch(&named)
            || DOTS.iter().any(|(d, _)| *d == named);
        let before = out.last().map_or("", |m| m.text.as_str());
        if marks[at].text == "{" && styled && !matches!(before, "_" | "^") && !before.starts_with('\\') {
            let end = units.get(at + 2).copied().unwrap_or(marks.len());
            let last = marks.get(end).is_some_and(|m| m.text == "}");
            if last && marks.get(end + 1).is_some_and(|m| matches!(m.text.as_str(), "_" | "'")) {
                closing.push(end);
                continue;
            }
        }
        out.push(marks[at].clone());
    }
    out
}
