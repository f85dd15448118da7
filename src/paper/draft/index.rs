//! Indices: which letters below run over components, and may be summed over.
//!
//! **In:** the sides of a formula. **Out:** the letters that stand twice in a term, and nowhere once: a sum, for most readers. **Guaranteed:** a
//! letter that stands once in a term is no such letter: it is free, or a label.

use std::collections::{BTreeMap, BTreeSet};

use super::super::mark::group_text;
use super::super::names::letters::is_letter_command;
use super::super::names::{Evidence, INDICES, PaperName, Subscripts, is_variable, names_of};
use super::super::printed::{PrintedRelation, PrintedSide, terms};
use super::super::token::{Kind, Token};

/// Letters of which a sum may be meant, in a formula.
pub(super) fn summed(sides: &[&PrintedSide], evidence: &Evidence) -> BTreeSet<char> {
    let (summed, mixed) = letters(sides, evidence);
    summed.union(&mixed).copied().collect()
}

/// A letter of which a sum may be meant, and which stands below a name with labels, too: `\sigma_i p_i` beside `p_f`.
pub(super) fn mixed(sides: &[&PrintedSide], evidence: &Evidence) -> Option<char> {
    letters(sides, evidence).1.pop_first()
}

/// The letters that stand twice below names that have no labels, and those that stand below one, and below one with labels.
fn letters(sides: &[&PrintedSide], evidence: &Evidence) -> (BTreeSet<char>, BTreeSet<char>) {
    let mut once: BTreeSet<char> = BTreeSet::new();
    let mut often: BTreeSet<char> = BTreeSet::new();
    let (mut joined, mut free): (BTreeSet<char>, BTreeSet<char>) = Default::default();
    for side in sides {
        for term in parts(&side.tokens) {
            let mut count: BTreeMap<char, usize> = BTreeMap::new();
            let mut anywhere: BTreeMap<char, usize> = BTreeMap::new();
            let mut labels = Vec::new();
            for name in &names_of(&term) {
                if is_labelled(name, evidence) {
                    // Behind a label stands an index, `k_{f,i}`.
                    let behind = name.subscript.as_deref().and_then(|s| s.split_once(',')).map_or("", |(_, b)| b);
                    for letter in behind.chars().filter(|c| INDICES.contains(*c)) {
                        *anywhere.entry(letter).or_default() += 1;
                    }
                    labels.extend(name.index_letters());
                    continue;
                }
                let is_list = name.subscript.as_deref().is_some_and(|s| s.contains(','));
                for (at, letter) in name.index_letters().into_iter().enumerate() {
                    if !(is_list && at == 0 && evidence.labels.contains(&letter)) {
                        *count.entry(letter).or_default() += 1;
                    }
                }
                for letter in name.letters_below() {
                    *anywhere.entry(letter).or_default() += 1;
                }
            }
            // Beside an index, `\sigma_i p_i`, the same letter is one, too, whatever else stands below `p`.
            let (beside, alone): (BTreeSet<char>, BTreeSet<char>) =
                labels.into_iter().partition(|letter| count.contains_key(letter));
            joined.extend(beside);
            free.extend(alone);
            once.extend(anywhere.into_iter().filter(|(_, n)| *n == 1).map(|(letter, _)| letter));
            often.extend(count.into_iter().filter(|(_, n)| *n > 1).map(|(letter, _)| letter));
        }
    }
    often.retain(|letter| !once.contains(letter));
    joined.retain(|letter| !free.contains(letter));
    (often, joined)
}

/// The most terms into which a side is taken apart.
const MOST_PARTS: usize = 400;

/// The terms of a formula: those of a group in parentheses that is a term by itself, and for each entry of a matrix the term with that entry.
fn parts(tokens: &[Token]) -> Vec<Vec<Token>> {
    let mut open = terms(tokens);
    let mut out = Vec::new();
    while let Some(term) = open.pop() {
        if open.len() + out.len() > MOST_PARTS {
            out.push(term);
        } else if let Some(inside) = alone_in_parentheses(&term) {
            open.extend(terms(inside));
        } else if let Some((begin, end)) = matrix(&term) {
            for entry in entries(&term[begin..end]).iter().flat_map(|entry| terms(entry)) {
                open.push([&term[..begin], &entry, &term[end..]].concat());
            }
        } else {
            out.push(term);
        }
    }
    out
}

fn is_printed(token: &&Token) -> bool {
    token.kind != Kind::Space && !matches!(token.text.as_str(), "left" | "right" | "bigl" | "bigr" | "Bigl" | "Bigr")
}

/// What stands in the parentheses that a term consists of.
fn alone_in_parentheses(term: &[Token]) -> Option<&[Token]> {
    let from = term.iter().position(|t| is_printed(&t))?;
    let to = term.iter().rposition(|t| is_printed(&t))?;
    let mut depth = 0i32;
    let closing = (from..=to).find(|&i| {
        depth += i32::from(term[i].is_char("(")) - i32::from(term[i].is_char(")"));
        depth == 0
    });
    let inside = term.get(from + 1..to)?;
    let end = inside.iter().rposition(|t| !t.is("right")).map_or(0, |i| i + 1);
    (closing == Some(to) && from < to).then(|| &inside[..end])
}

/// Where the first matrix of a term begins, and where it ends.
fn matrix(term: &[Token]) -> Option<(usize, usize)> {
    let begin = term.iter().position(|t| t.is("begin"))?;
    let mut depth = 0i32;
    let end = (begin..term.len()).find(|&i| {
        depth += i32::from(term[i].is("begin")) - i32::from(term[i].is("end"));
        depth == 0
    })?;
    group_text(term, begin + 1).0.contains("matrix").then(|| (begin, group_text(term, end + 1).1))
}

/// The entries of a matrix.
fn entries(matrix: &[Token]) -> Vec<Vec<Token>> {
    let mut depth = 0i32;
    let inside = group_text(matrix, 1).1..matrix.iter().rposition(|t| t.is("end")).unwrap_or(matrix.len());
    let mut out = vec![Vec::new()];
    for token in matrix.get(inside).unwrap_or_default() {
        depth += i32::from(token.is("begin")) - i32::from(token.is("end"));
        match out.last_mut() {
            Some(last) if depth > 0 || !(token.is_char("&") || token.is("\\")) => last.push(token.clone()),
            _ => out.push(Vec::new()),
        }
    }
    out.retain(|entry| entry.iter().any(|t| is_printed(&t)));
    out
}

/// Whether the subscripts of a letter are labels: beside `E_r` and `E_t` that of `E_i` is one.
fn is_labelled(name: &PaperName, evidence: &Evidence) -> bool {
    !evidence.is_summed_over(name) && evidence.subscripts.get(&name.letter).is_some_and(Subscripts::have_label)
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
