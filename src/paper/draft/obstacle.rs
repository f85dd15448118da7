//! What keeps a formula from being read, whatever its names are declared as.
//!
//! **In:** the sides of a formula, its names, and the evidence of the paper. **Out:** the feature that is not understood, or both readings of
//! what is ambiguous. **Guaranteed:** nothing is decided for a formula that has one.

use super::super::names::{
    Call, Evidence, INDICES, PaperName, Primes, cancels_by_order, order_counts, squeezed, unprimed,
};
use super::super::printed::PrintedSide;
use super::guess::Place;
use super::index;
use super::spelling::is_name;

/// What keeps a formula from being read as numbers, vectors and functions.
pub(super) fn obstacle(
    sides: &[&PrintedSide],
    all: &[PaperName],
    evidence: &Evidence,
    place: Place,
) -> Result<(), String> {
    for side in sides {
        if side.text.is_empty() {
            return Err("a side that is missing".to_owned());
        }
        if let Some(letter) = index::upper(side) {
            return Err(format!("an upper index, {letter}"));
        }
        if adds_identity_to_exponential(&side.text) {
            return Err("a sum with the identity, or with a number".to_owned());
        }
        let is_matrix = |n: &PaperName| evidence.size(&n.key()).is_some();
        let is_unsized = || !all.iter().any(|n| n.is_bold || is_matrix(n)) && order_counts(&side.text);
        if is_unsized() || !all.iter().any(is_matrix) && cancels_by_order(side) {
            return Err("products whose order may count: matrices, or operators".to_owned());
        }
    }
    if let Some(run) = sides.iter().find_map(|s| evidence.runs.name_in(s)) {
        return Err(format!("a name of several letters, {run}, or a product"));
    }
    if evidence.local.has_matrices(place.section) && sides.iter().any(|s| has_capital_beside_matrix(s, evidence)) {
        return Err("a letter beside a matrix: a matrix, or a number".to_owned());
    }
    if let Some(name) = all.iter().find(|n| n.has_hat && !n.is_bold) {
        return Err(format!("a hat, {}: an operator, or a unit vector", name.key()));
    }
    if evidence.has_complex_j && all.iter().any(|n| n.key() == "j") {
        return Err("j, which may be the imaginary unit".to_owned());
    }
    let is_called = |n: &PaperName| matches!(&n.call, Call::Places(p) if p.iter().all(|p| is_name(p)));
    if all.iter().any(|n| unprimed(n) == "t" && (n.primes > 0 && is_called(n) || is_called(n) && n.dots == 0)) {
        return Err("the time as a function of something else".to_owned());
    }
    if all.iter().any(|n| n.key() == "t" && n.derived_by.as_deref().is_some_and(|by| by != "t")) {
        return Err("the time as a function of something else".to_owned());
    }
    let unclear = |n: &&PaperName| n.primes > 0 && evidence.primes_in(&unprimed(n), place.section) == Primes::Unclear;
    if let Some(name) = all.iter().find(unclear) {
        return Err(format!("a prime, {}: a derivative, or another name", name.key()));
    }
    if let Some(name) = derived_rate(all, evidence) {
        return Err(format!("the rate of a variable, {}, derived by another: a function of its own", name.key()));
    }
    let bare_e = evidence.keys.contains_key("e");
    let raised = |s: &&&PrintedSide, bare: bool| raised_e(s).is_some_and(|(a, b)| if bare { a } else { b });
    // In a paper without exponentials it is a charge, or another name.
    let is_unclear = bare_e && evidence.has_exponentials && !evidence.local.is_e_a_name(place.chapter);
    if is_unclear && sides.iter().any(|s| raised(&s, true)) {
        return Err("e to a number: a charge, or Euler's number".to_owned());
    }
    if all.iter().any(|n| n.key() == "e") && sides.iter().any(|s| raised(&s, false)) {
        return Err("e as a factor, and to a power: a name, or Euler's number".to_owned());
    }
    Ok(())
}

/// A name by which the paper derives partially, and of which the rate is derived so here, by something else than the time.
fn derived_rate<'a>(all: &'a [PaperName], evidence: &Evidence) -> Option<&'a PaperName> {
    let is_index = |sub: &str| sub.chars().count() == 1 && sub.starts_with(|c| INDICES.contains(c));
    let is_variable = |n: &PaperName| {
        // Beside `\partial n_j` that of `n_k` is the rate of a variable, too.
        let has_index = n.subscript.as_deref().is_some_and(is_index);
        let alike =
            |v: &String| has_index && v.split_once('_').is_some_and(|(base, sub)| base == n.base && is_index(sub));
        let key = n.key();
        !evidence.partial.contains_key(&key)
            && (evidence.variables.contains(&key) || evidence.variables.iter().any(alike))
    };
    let by_other = |n: &PaperName| n.derived_by.as_deref().is_some_and(|by| by != "t");
    let by_dots = all.iter().find(|n| n.dots > 0 && by_other(n) && is_variable(n));
    // `\frac{\partial}{\partial T}\frac{dV}{dt}`
    let nested = |three: &&[PaperName]| {
        let [name, time, other] = three else { return false };
        name.derived_by.as_deref() == Some("t")
            && !name.is_partial
            && is_variable(name)
            && (time.is_variable && time.key() == "t")
            && (other.is_variable && other.key() != "t")
    };
    by_dots.or_else(|| all.windows(3).find(nested).map(|three| &three[0]))
}

/// Whether a capital letter of which nothing shows what it is stands right beside one that is a matrix, perhaps with brackets between: `A(BC)`.
fn has_capital_beside_matrix(side: &PrintedSide, evidence: &Evidence) -> bool {
    let letters: Vec<char> = squeezed(&side.text).chars().filter(|c| !matches!(c, '(' | ')')).collect();
    let is_bare = |at: usize| {
        let before = letters[..at].iter().rev().find(|c| !c.is_ascii_alphabetic());
        letters[at].is_ascii_uppercase()
            && !matches!(before, Some('\\' | '_'))
            && !matches!(letters.get(at + 1), Some('_' | '\''))
    };
    let is_matrix = |at: usize| evidence.sizes.contains_key(letters[at].to_string().as_str());
    (1..letters.len()).any(|at| {
        is_bare(at - 1) && is_bare(at) && is_matrix(at - 1) != is_matrix(at) && letters[at - 1] != letters[at]
    })
}

/// Whether I is added to an exponential with a capital above, `e^{Bt}-I`: both are matrices, perhaps.
fn adds_identity_to_exponential(text: &str) -> bool {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    ["}-I", "}+I"].iter().flat_map(|sum| text.match_indices(sum)).any(|(at, sum)| {
        let begin = text[..at].rfind("e^{").map_or(at, |from| from + "e^{".len());
        let is_bare = |c: Option<char>| !c.is_some_and(|c| c.is_alphanumeric() || matches!(c, '_' | '^' | '(' | '\''));
        is_bare(text[at + sum.len()..].chars().next()) && text[begin..at].chars().any(|c| c.is_ascii_uppercase())
    })
}

/// Whether `e` stands in a side to a bare number, and to anything else.
pub(super) fn raised_e(side: &PrintedSide) -> Option<(bool, bool)> {
    let marks = super::super::mark::marks(&side.tokens);
    let text = |i: usize| marks.get(i).map_or("", |m| m.text.as_str());
    let (mut number, mut other) = (false, false);
    for at in (0..marks.len()).filter(|&i| text(i) == "e" && text(i + 1) == "^" && (i == 0 || text(i - 1) != "_")) {
        let end = super::super::mark::unit(&marks, at + 2);
        let digits = (at + 2..end).map(text).filter(|t| !matches!(*t, "{" | "}"));
        let bare = digits.clone().all(|t| t.chars().all(|c| c.is_ascii_digit()));
        number |= bare;
        other |= !bare;
    }
    (number || other).then_some((number, other))
}
