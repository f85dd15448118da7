//! Indices: which letters below run over components, and may be summed over.
//!
//! **In:** the sides of a formula. **Out:** the letters that stand twice in a term, and nowhere once: a sum, for most readers. **Guaranteed:** a
//! letter that stands once in a term is no such letter: it is free, or a label.

use std::collections::{BTreeMap, BTreeSet};

use super::super::names::letters::is_letter_command;
use super::super::names::{Evidence, PaperName, Subscripts, is_variable, names_of};
use super::super::printed::{PrintedRelation, PrintedSide, terms};

/// Letters of which a sum may be meant, in a formula.
pub(super) fn summed(sides: &[&PrintedSide], evidence: &Evidence) -> BTreeSet<char> {
    let mut once: BTreeSet<char> = BTreeSet::new();
    let mut often: BTreeSet<char> = BTreeSet::new();
    for side in sides {
        for term in terms(&side.tokens) {
            let mut count: BTreeMap<char, usize> = BTreeMap::new();
            for name in names_of(&term).iter().filter(|n| !is_labelled(n, evidence)) {
                for letter in name.index_letters() {
                    *count.entry(letter).or_default() += 1;
                }
            }
            for (letter, n) in count {
                if n == 1 {
                    once.insert(letter)
                } else {
                    often.insert(letter)
                };
            }
        }
    }
    often.difference(&once).copied().collect()
}

/// Whether the subscripts of a letter are labels: beside `E_r` and `E_t` that of `E_i` is one.
fn is_labelled(name: &PaperName, evidence: &Evidence) -> bool {
    evidence.subscripts.get(&name.letter).is_some_and(Subscripts::have_label)
}

/// Whether δ or ε with indices stands in a formula.
pub(super) fn has_symbols_of_indices(all: &[PaperName]) -> bool {
    let symbol = |n: &PaperName| matches!(n.letter.as_str(), r"\delta" | r"\epsilon" | r"\varepsilon");
    // `\delta_{k1}` is one, too.
    let two = |n: &PaperName| {
        let sub = n.subscript.as_deref().unwrap_or_default();
        let letters = sub.chars().filter(|c| "ijklmnpq".contains(*c)).count();
        letters > 0
            && letters < sub.chars().count()
            && sub.chars().all(|c| c.is_ascii_digit() || "ijklmnpq, ".contains(c))
    };
    all.iter().any(|n| symbol(n) && (n.index_letters().len() > 1 || two(n)))
}

/// Whether a paper sums over indices of letters whose subscripts are indices.
pub(super) fn is_of_indices(printed: &[PrintedRelation], evidence: &Evidence) -> bool {
    printed.iter().any(|r| {
        let sides: Vec<&PrintedSide> = r.sides.iter().collect();
        let letters = summed(&sides, evidence);
        let all = || r.sides.iter().flat_map(|s| names_of(&s.tokens));
        !letters.is_empty()
            && all().any(|n| evidence.has_indices(&n.letter) && n.index_letters().iter().any(|l| letters.contains(l)))
    })
}

/// A letter above that is an index, or could be one.
pub(super) fn upper(side: &PrintedSide) -> Option<String> {
    let marks = super::super::mark::marks(&side.tokens);
    let text = |i: usize| marks.get(i).map_or("", |m| m.text.as_str());
    let below: BTreeSet<&str> = (1..marks.len()).filter(|&i| text(i - 1) == "_").map(text).collect();
    let end = |i: usize| super::super::mark::unit(&marks, i);
    (1..marks.len()).filter(|&i| text(i) == "^" && !matches!(text(i - 1), "e" | "^")).find_map(|i| {
        let inside: Vec<&str> = (i + 1..end(i + 1)).map(text).filter(|t| !matches!(*t, "{" | "}" | ",")).collect();
        let sure = |t: &&str| matches!(*t, "i" | "j" | r"\mu" | r"\nu" | r"\alpha" | r"\beta" | r"\sigma" | r"\rho");
        let maybe = |t: &&str| matches!(*t, "k" | "l" | "m" | "n") && below.contains(*t);
        let all = !inside.is_empty() && inside.len() <= 4 && inside.iter().all(|t| sure(t) || maybe(t));
        // `\Gamma^r_{\theta\theta}`, `g^{tt}`: no power is printed so.
        let letter = |t: &str| is_variable(t) && t.strip_prefix('\\').is_none_or(is_letter_command);
        let below_it = (0..i).rev().find(|&k| text(k) == "_" && end(k + 1) == i).map_or(0, |k| {
            let inside = (k + 2..i - 1).map(text);
            if inside.clone().any(|t| matches!(t, r"\rm" | r"\mathrm" | r"\text")) { 0 } else { inside.filter(|t| letter(t)).count() }
        });
        let lone = matches!(inside.as_slice(), [one] if letter(one) && !matches!(*one, "T" | r"\top" | r"\prime" | r"\dagger"));
        let twice = matches!(inside.as_slice(), [a, b] if a == b && letter(a) && *a != r"\prime");
        let symbol = text(i - 1) == r"\Gamma" && inside.first().is_some_and(|t| letter(t));
        if lone && below_it > 1 || twice || symbol {
            return Some(inside.concat());
        }
        let digit = text(i - 1).starts_with(|c: char| c.is_ascii_digit());
        (all && !digit).then(|| inside.concat())
    })
}
