//! Angles before the time: `v\cos\alpha t` is a product in a paper that prints `\sin\alpha`, as `\cos\omega t` is a function of a product.
//!
//! **In:** the sides of a paper. **Out:** whether the argument of a function may end before the time; a formula with parentheses where arguments end.
//! **Guaranteed:** it is refused only where the paper prints the name before the time as an argument of its own, and nowhere the product as one;
//! so is an end shown.

use std::collections::BTreeSet;

use super::print::{behind, is_letter_token, placed, tokens};

/// Functions of angles.
const FUNCTIONS: &[&str] = &[r"\sin", r"\cos", r"\tan", r"\cot", r"\sec", r"\csc"];

/// Letters of angles, which nobody puts before what they are multiplied by.
const LETTERS: &[&str] =
    &[r"\theta", r"\vartheta", r"\phi", r"\varphi", r"\psi", r"\chi", r"\alpha", r"\beta", r"\gamma"];
/// Letters of places, times and lengths: a fraction with one of them may belong to a phase.
const OF_PHASES: &[&str] =
    &["x", "y", "z", "r", "s", "t", "l", "n", "m", "k", "L", "R", "T", "N", r"\lambda", r"\pi", r"\ell", r"\tau"];

/// What functions of angles are applied to.
#[derive(Clone, Debug, Default)]
pub(super) struct Angles {
    /// Names that are an argument as they stand.
    names: BTreeSet<String>,
    /// What stands in parentheses or braces as an argument, and the terms of it.
    enclosed: BTreeSet<String>,
    /// Names that are a whole argument: in parentheses, or before a sign, a bracket that closes, a function.
    whole: BTreeSet<String>,
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
                let inside = inside.strip_suffix(&[r"\right"]).unwrap_or(inside);
                self.whole.extend(name_at(inside, 0).filter(|(_, end)| *end == inside.len()).map(|(name, _)| name));
            } else if let Some((name, end)) = name_at(&all, at)
                && !all.get(end).is_some_and(|t| is_letter_token(t) || matches!(*t, "(" | "[" | "{" | r"\left" | "/"))
            {
                if all.get(end).is_none_or(|t| ends_factor(t)) {
                    self.whole.insert(name.clone());
                }
                self.names.insert(name);
            }
        }
    }

    /// A formula with parentheses around the angles behind functions, where a factor follows: `\sin\theta_i E_i` is a product where the paper prints
    /// `\sin\theta_i` alone, and nowhere a function of θ_i times anything. What follows has the subscript of the angle, or is a fraction without a
    /// place or a time. `None` where nothing is shown so.
    pub fn with_ends(&self, text: &str) -> Option<String> {
        let all = placed(text);
        let plain: Vec<&str> = all.iter().map(|(_, token)| *token).collect();
        let mut out = String::with_capacity(text.len() + 8);
        let mut done = 0;
        for at in arguments(&plain) {
            let brace = usize::from(plain.get(at) == Some(&"{"));
            let Some((name, end)) = name_at(&plain, at + brace) else { continue };
            if brace > 0 && plain.get(end) != Some(&"}") || !self.is_angle(&name, plain[at + brace]) {
                continue;
            }
            let last = end + brace;
            if !is_other_factor(&plain, last, &name) {
                continue;
            }
            let (Some(from), Some(to)) = (all.get(at), all.get(last - 1)) else { continue };
            let inside = all.get(end - 1).map_or(to.0 + to.1.len(), |t| t.0 + t.1.len());
            out.push_str(&text[done..from.0]);
            out.push('(');
            out.push_str(&text[all[at + brace].0..inside]);
            out.push(')');
            done = to.0 + to.1.len();
        }
        out.push_str(&text[done..]);
        (done > 0).then_some(out)
    }

    /// Whether a name is an angle that the paper multiplies by nothing within an argument.
    fn is_angle(&self, name: &str, letter: &str) -> bool {
        let times = |inside: &String| {
            inside.strip_prefix(name).and_then(|rest| rest.chars().next()).is_some_and(|c| c != '_' && c != ')')
        };
        LETTERS.contains(&letter) && self.whole.contains(name) && !self.enclosed.iter().any(times)
    }

    /// Whether a side has a name that is an angle elsewhere between a function and the time.
    pub fn stands_before_time(&self, all: &[&str]) -> bool {
        arguments(all).into_iter().filter_map(|at| name_at(all, at)).any(|(name, end)| {
            let is_angle = self.names.contains(&name) || self.enclosed.contains(&name);
            all.get(end) == Some(&"t") && is_angle && !self.enclosed.contains(&format!("{name}t"))
        })
    }
}

/// Whether no factor stands here: an argument before it is a whole one.
fn ends_factor(token: &str) -> bool {
    matches!(token, "+" | "-" | "=" | ")" | "]" | "}" | "&" | "," | r"\right" | r"\\" | r"\cdot" | r"\times")
        || FUNCTIONS.contains(&token)
}

/// Whether what stands behind an angle is no part of its argument: a capital letter with the subscript of the angle, or a fraction without a place or
/// a time.
fn is_other_factor(all: &[&str], at: usize, angle: &str) -> bool {
    match all.get(at) {
        Some(&(r"\frac" | r"\dfrac" | r"\tfrac")) => {
            let end = behind(all, behind(all, at + 1));
            end < all.len() + 1 && !all[at..end].iter().any(|t| OF_PHASES.contains(t))
        }
        Some(letter) if letter.len() == 1 && letter.bytes().all(|b| b.is_ascii_uppercase()) => {
            let below = angle.split_once('_').map(|(_, below)| below);
            name_at(all, at).is_some_and(|(name, _)| below.is_some() && name.split_once('_').map(|(_, b)| b) == below)
        }
        _ => false,
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
    fn the_end_of_an_argument_is_shown_where_the_paper_shows_it() {
        let shown = |paper: &[&str], text: &str| {
            let mut angles = Angles::default();
            paper.iter().for_each(|text| angles.note(text));
            angles.with_ends(text)
        };
        let whole = &[r"\cos\theta_i = 1", r"a\cos(\phi)"][..];
        for (text, with) in [
            (r"a\sin\theta_i E_i=b", r"a\sin(\theta_i) E_i=b"),
            (r"\cos{ \theta_i } E_i - E_i\cos\theta_i", r"\cos(\theta_i) E_i - E_i\cos\theta_i"),
            (r"\sin^2\theta_{i}E_{i}", r"\sin^2(\theta_{i})E_{i}"),
            (r"\tan\phi\frac{1-\beta}{2}", r"\tan(\phi)\frac{1-\beta}{2}"),
        ] {
            assert_eq!(shown(whole, text).as_deref(), Some(with));
            assert_eq!(shown(&[], text), None, "nothing shows it");
        }
        // Another subscript, none, a small letter, a fraction of a phase, the time, another letter.
        for text in [
            r"\sin\theta_i E_r",
            r"\sin\theta_i E",
            r"\sin\theta_i e_i",
            r"\sin\phi E",
            r"\sin\phi\frac{x}{L}",
            r"\sin\phi\frac{2\pi}{3}",
            r"\sin\phi t",
            r"\sin\theta_r E_r",
            r"\sin\theta_i(E_i)",
            r"\sin(\theta_iE_i)",
        ] {
            assert_eq!(shown(whole, text), None, "{text}");
        }
        // A product in an argument, or a letter of something else.
        assert_eq!(shown(&[r"\sin\theta_i", r"\cos(\theta_i E_i)"], r"\sin\theta_i E_i"), None);
        assert_eq!(shown(&[r"\sin\omega_i"], r"\sin\omega_i E_i"), None);
        assert_eq!(shown(&[r"\sin\phi\frac{1}{2}"], r"\sin\phi\frac{1}{2}"), None);
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
