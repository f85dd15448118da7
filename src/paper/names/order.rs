//! Capital letters as matrices and operators stand: their order may count.

use std::collections::BTreeSet;

use super::super::PrintedSide;
use super::super::mark::{self, Mark};
use super::letters::{BOLD, is_letter_command};

/// Whether capital letters stand in a formula as matrices and operators do: beside their own inverse or transpose, or in both orders.
pub fn order_counts(text: &str) -> bool {
    let squeezed: Vec<char> = text.chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}')).collect();
    let capital = |i: usize| squeezed.get(i).is_some_and(char::is_ascii_uppercase);
    let command =
        |i: usize| squeezed[..i].iter().rposition(|c| !c.is_ascii_alphabetic()).is_some_and(|k| squeezed[k] == '\\');
    let is = |i: usize, text: &str| text.chars().enumerate().all(|(k, c)| squeezed.get(i + k) == Some(&c));
    let mut pairs = BTreeSet::new();
    for i in (0..squeezed.len()).filter(|&i| capital(i) && !command(i)) {
        let own = squeezed[i];
        let twice = squeezed.iter().filter(|c| **c == own).count() > 1;
        if twice && ["^-1", "^T", r"^\top", r"^\mathrmT", r"^\mathsfT", "^H"].iter().any(|power| is(i + 1, power)) {
            return true;
        }
        if capital(i + 1) && squeezed[i + 1] != own {
            pairs.insert((own, squeezed[i + 1]));
        }
    }
    pairs.iter().any(|(a, b)| pairs.contains(&(*b, *a)))
}

/// Whether two terms of a side would cancel, did the order of their factors not count: `ix'-x'i`. Nobody prints them of numbers.
pub fn cancels_by_order(side: &PrintedSide) -> bool {
    let marks = mark::marks(&side.tokens);
    let mut terms: Vec<(bool, Vec<String>)> = Vec::new();
    let mut from = 0;
    let mut is_minus = false;
    for at in 0..=marks.len() {
        let text = marks.get(at).map_or(")", |m| m.text.as_str());
        if !matches!(text, "+" | "-" | "(" | ")" | "[" | "]" | r"\left" | r"\right") {
            continue;
        }
        terms.extend(factors(&marks[from..at]).filter(|f| f.len() > 1).map(|f| (is_minus, f)));
        (from, is_minus) = (at + 1, text == "-");
    }
    let is_turned = |a: &[String], b: &[String]| a != b && a.iter().eq(b.iter().rev());
    terms
        .iter()
        .enumerate()
        .any(|(k, (sign, one))| terms[..k].iter().any(|(other, two)| sign != other && is_turned(one, two)))
}

/// The letters of a term, each with its style and scripts, where it is a product of letters and of nothing else.
fn factors(marks: &[Mark]) -> Option<Vec<String>> {
    let text = |at: usize| marks.get(at).map_or("", |m| m.text.as_str());
    let mut out = Vec::new();
    let mut at = 0;
    while at < marks.len() {
        let from = at;
        let command = text(at).strip_prefix('\\');
        at = match command {
            Some(style) if BOLD.contains(&style) || style == "bf" => mark::unit(marks, at + 1),
            Some(letter) if is_letter_command(letter) => at + 1,
            None if text(at).chars().all(char::is_alphabetic) => at + 1,
            None if text(at) == "{" && mark::unit(marks, at) > at + 2 => {
                // A group of one letter: `{A'}_\sigma`.
                let end = mark::unit(marks, at);
                factors(&marks[at + 1..end - 1]).filter(|inside| inside.len() == 1)?;
                end
            }
            _ => return None,
        };
        while matches!(text(at), "_" | "^" | "'") {
            at = if text(at) == "'" { at + 1 } else { mark::unit(marks, at + 1) };
        }
        out.push((from..at).map(text).filter(|t| !matches!(*t, "{" | "}")).collect());
    }
    Some(out)
}
