//! Angles before the time: `v\cos\alpha t` is a product in a paper that prints `\sin\alpha`, as `\cos\omega t` is a function of a product.
//!
//! **In:** the sides of a paper. **Out:** whether the argument of a function may end before the time. **Guaranteed:** it is refused only where
//! the paper prints the name before the time as an argument of its own, and nowhere the product as one.

use std::collections::BTreeSet;

use super::print::{behind, is_letter_token, tokens};

/// Functions of angles.
const FUNCTIONS: &[&str] = &[r"\sin", r"\cos", r"\tan", r"\cot", r"\sec", r"\csc"];

/// What functions of angles are applied to.
#[derive(Clone, Debug, Default)]
pub(super) struct Angles {
    /// Names that are an argument as they stand.
    names: BTreeSet<String>,
    /// What stands in parentheses or braces as an argument, and the terms of it.
    enclosed: BTreeSet<String>,
}

impl Angles {
    /// Takes note of a side.
    pub fn note(&mut self, text: &str) {
        if !FUNCTIONS.iter().any(|f| text.contains(f)) {
            return;
        }
        let all = tokens(text);
        for at in arguments(&all) {
            let left = usize::from(matches!(all.get(at), Some(&r"\left" | &r"\bigl" | &r"\big")));
            let first = at + left;
            if matches!(all.get(first), Some(&"(" | &"[" | &"{")) {
                let end = closing(&all, first);
                let inside = &all[first + 1..end.saturating_sub(1).max(first + 1)];
                for term in inside.split(|t| matches!(*t, "+" | "-")) {
                    let plain: String =
                        term.iter().filter(|t| !matches!(**t, "{" | "}" | r"\right" | r"\,")).copied().collect();
                    self.enclosed.insert(plain);
                }
            } else if let Some((name, end)) = name_at(&all, at)
                && !all.get(end).is_some_and(|t| is_letter_token(t) || matches!(*t, "(" | "[" | "{" | r"\left" | "/"))
            {
                self.names.insert(name);
            }
        }
    }

    /// Whether a side has a name that is an angle elsewhere between a function and the time.
    pub fn stands_before_time(&self, all: &[&str]) -> bool {
        arguments(all).into_iter().filter_map(|at| name_at(all, at)).any(|(name, end)| {
            let is_angle = self.names.contains(&name) || self.enclosed.contains(&name);
            all.get(end) == Some(&"t") && is_angle && !self.enclosed.contains(&format!("{name}t"))
        })
    }
}

/// Where the arguments of functions begin, behind their powers.
fn arguments(all: &[&str]) -> Vec<usize> {
    let begins = |i: &usize| FUNCTIONS.contains(&all[*i]);
    (0..all.len())
        .filter(begins)
        .map(|i| if all.get(i + 1) == Some(&"^") { behind(all, i + 2) } else { i + 1 })
        .collect()
}

/// A letter with its subscript, without braces, and where it ends.
fn name_at(all: &[&str], at: usize) -> Option<(String, usize)> {
    let letter = all.get(at).filter(|t| is_letter_token(t))?;
    let end = if all.get(at + 1) == Some(&"_") { behind(all, at + 2) } else { at + 1 };
    let below: String = all[at + 1..end].iter().filter(|t| !matches!(**t, "{" | "}")).copied().collect();
    Some((format!("{letter}{below}"), end))
}

/// The position after the bracket that closes the one here.
fn closing(all: &[&str], at: usize) -> usize {
    let mut depth = 0i32;
    for (i, token) in all.iter().enumerate().skip(at) {
        match *token {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return i + 1;
        }
    }
    all.len()
}

#[cfg(test)]
mod tests {
    use super::{Angles, tokens};

    fn is_unclear(paper: &[&str], side: &str) -> bool {
        let mut angles = Angles::default();
        paper.iter().for_each(|text| angles.note(text));
        angles.stands_before_time(&tokens(side))
    }

    #[test]
    fn an_angle_of_the_paper_may_end_before_the_time() {
        let side = r"v_0\cos\alpha t";
        for paper in [&[r"\frac{v^2\sin^2\alpha}{2g}"][..], &[r"\sin(\alpha)"], &[r"\cos{\alpha} + 1"]] {
            assert!(is_unclear(paper, side), "{paper:?}");
        }
        for paper in [&[r"x\cos\omega t"][..], &[r"\sin\beta"], &[r"\sin\alpha", r"\cos(\alpha t + \phi)"], &[]] {
            assert!(!is_unclear(paper, side), "{paper:?}");
        }
        assert!(
            is_unclear(&[r"\tan\alpha_1"], r"\sin\alpha_1 t") && !is_unclear(&[r"\tan\alpha_1"], r"\sin\alpha_2 t")
        );
        assert!(!is_unclear(&[r"\sin\alpha"], r"\sin(\alpha t)") && !is_unclear(&[r"\sin\alpha"], r"t\sin\alpha"));
    }
}
