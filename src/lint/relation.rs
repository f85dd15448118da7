//! What a printed relation is by itself: an evaluation, a congruence, an equation for what is zero, an equation of motion.
//!
//! **In:** a relation, or its sides. **Out:** whether it is so. **Guaranteed:** no other relation is looked at.

use std::collections::BTreeSet;

use paper::{PrintedRelation, PrintedSide, names, squeezed};

use super::lone::{lone_name, unprimed};

/// Whether a sign may say that two sides are equal but for multiples of something, or by definition.
pub(super) fn is_congruence(sign: &str) -> bool {
    matches!(sign, r"\equiv" | "≡")
}

/// Whether one side is the other with a sign or a number before it, or divided by one: an equation for what is zero.
pub(super) fn are_multiples(left: &PrintedSide, right: &PrintedSide) -> bool {
    let core = |side: &PrintedSide| {
        let text: String = side.text.chars().filter(|c| !c.is_whitespace()).collect();
        let below = text.strip_prefix(r"\frac{").and_then(|rest| {
            let (above, below) = rest.strip_suffix('}')?.rsplit_once("}{")?;
            below.chars().all(|c| c.is_ascii_digit()).then(|| above.to_owned())
        });
        let text = below.unwrap_or(text);
        text.trim_start_matches(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+')).to_owned()
    };
    let (one, other) = (core(left), core(right));
    one == other && one.chars().any(char::is_alphabetic) && squeezed(&left.text) != squeezed(&right.text)
}

/// Whether a side stands in brackets: dimensions are compared.
pub(super) fn has_dimensions(relation: &PrintedRelation) -> bool {
    let of = |text: &str| text.trim().starts_with('[') && text.trim().ends_with(']');
    relation.sides.iter().any(|s| of(&s.text))
        || relation.sides.iter().any(|s| s.text.matches('[').count() > 1 && !s.text.contains('('))
}

/// Whether a later side is a number: beside sides with names the values of the names count then, or an equation is solved. A step between
/// numbers is one all the same.
pub(super) fn is_evaluated(relation: &PrintedRelation) -> bool {
    let is_number =
        |s: &PrintedSide| s.text.contains(|c: char| c.is_ascii_digit()) && s.text.trim() != "0" && names(s).is_empty();
    relation.sides.iter().skip(1).any(is_number)
}

/// Whether a side is a letter with a group in parentheses behind it, and nothing else.
pub(super) fn is_letter_at_place(side: &PrintedSide) -> bool {
    let text = squeezed(&side.text).replace(r"\left", "").replace(r"\right", "");
    let Some((name, inside)) = text.split_once('(') else { return false };
    let is_command = name.strip_prefix('\\').is_some_and(|n| n.chars().all(|c| c.is_alphanumeric() || c == '_'));
    let is_letter = name.chars().count() == 1 || name.chars().nth(1) == Some('_') || is_command;
    is_letter && inside.strip_suffix(')').is_some_and(|i| !i.contains(['(', ')']))
}

/// Whether all sides but the last are lone names, and that is one or a number.
pub(super) fn gives_values(relation: &PrintedRelation) -> bool {
    let Some((last, names_before)) = relation.sides.split_last() else { return false };
    names_before.iter().all(|s| lone_name(s).is_some()) && (names(last).is_empty() || lone_name(last).is_some())
}

/// Letters of constants of integration.
const OF_INTEGRATION: &[&str] = &["c", "C", "K", "k"];

/// Whether both sides of a step of a chain that has an integral before it have the same constant of integration: it may stand for another one.
pub(super) fn is_integrated(relation: &PrintedRelation, step: usize) -> bool {
    let has = |side: &PrintedSide, letter: &str| names(side).iter().any(|n| n.key() == letter);
    let [left, right] = [step - 1, step].map(|k| &relation.sides[k]);
    relation.sides[..step].iter().any(|s| s.text.contains(r"\int"))
        && OF_INTEGRATION.iter().any(|c| has(left, c) && has(right, c))
}

/// The later side of an equation of two.
pub(super) fn lone_right(relation: &PrintedRelation) -> Option<&PrintedSide> {
    match relation.sides.as_slice() {
        [_, right] => Some(right),
        _ => None,
    }
}

/// The name whose highest rate an equation gives, where that is a second one or more, and there is just one.
pub(super) fn moved(sides: &[&PrintedSide]) -> Option<String> {
    // How often a name is derived by a quotient is printed above the bar.
    let by_quotient = sides.iter().any(|s| {
        let text = squeezed(&s.text);
        ["d^2", "d^3", "d^4", r"\mathrmd^2"].iter().any(|d| text.contains(&format!(r"\frac{d}")))
    });
    let order = |n: &paper::PaperName| {
        let quotient = usize::from(n.derived_by.is_some() && !n.is_partial) * if by_quotient { 2 } else { 1 };
        n.dots.max(n.primes).max(quotient)
    };
    let all: Vec<paper::PaperName> = sides.iter().flat_map(|s| names(s)).filter(|n| order(n) > 1).collect();
    let highest = all.iter().map(order).max()?;
    let mut keys: Vec<String> = all.iter().filter(|n| order(n) == highest).map(|n| unprimed(n).key()).collect();
    keys.dedup();
    match keys.as_slice() {
        [one] => Some(one.clone()),
        _ => None,
    }
}

/// Index letters that stand once in a lone name on the left: they are free, and nothing is summed over them. What is a number somewhere in the
/// relation is no index: `E_n=n^2\pi^2\ldots`.
pub(super) fn free_indices(relation: &PrintedRelation) -> BTreeSet<char> {
    let Some(name) = lone_name(&relation.sides[0]) else { return BTreeSet::new() };
    let letters = name.index_letters();
    let numbers: BTreeSet<String> = relation.sides.iter().flat_map(names).map(|n| n.key()).collect();
    let is_free = |l: &char| letters.iter().filter(|m| *m == l).count() == 1 && !numbers.contains(&l.to_string());
    letters.iter().copied().filter(is_free).collect()
}
