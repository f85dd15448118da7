//! Capital letters as matrices and operators stand: their order may count.

use std::collections::BTreeSet;

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
