//! What a printed relation is by itself: an evaluation, a congruence, an equation for what is zero, an equation of motion.
//!
//! **In:** a relation, or its sides. **Out:** whether it is so. **Guaranteed:** no other relation is looked at.

use std::collections::BTreeSet;

use paper::{PaperName, PrintedRelation, PrintedSide, names, squeezed};

use super::lone::{lone_name, unprimed};
use super::signs::{defines_behind, has_sign};

/// Whether a sign may say that two sides are equal but for multiples of something, or by definition.
pub(super) fn is_congruence(sign: &str) -> bool {
    matches!(sign, r"\equiv" | "≡")
}

/// What is not read of a sign that defines, where what it defines is no name, nor a function of some.
pub(super) fn defines_no_name([left, right]: [&PrintedSide; 2], sign: &str) -> Option<String> {
    let defined = if defines_behind(sign)? { right } else { left };
    lone_name(defined).is_none().then(|| format!("the sign `{sign}`, which defines, beside what is no name"))
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
    one == other && one.chars().any(char::is_alphabetic) && left.print() != right.print()
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

/// Whether both sides are one letter before parentheses, with another content: `E(a)=E(-a)` is said of a function.
pub(super) fn are_two_places(left: &PrintedSide, right: &PrintedSide) -> bool {
    let plain = |s: &PrintedSide| squeezed(&s.text).replace(r"\left", "").replace(r"\right", "");
    let (left, right) = (plain(left), plain(right));
    let parted = |text: &str| {
        let (name, inside) = text.split_once('(')?;
        let inside = inside.strip_suffix(')')?;
        // A sum behind a name is a factor as often as a place.
        let is_order = matches!(name, r"\Omega" | r"\Theta" | "O");
        let is_term =
            !inside.contains(['(', ')']) && (is_order || !inside.trim_start_matches('-').contains(['+', '-']));
        let is_name =
            !name.is_empty() && !name.contains(['+', '-', '^', '/', '{']) && name.chars().any(char::is_alphabetic);
        (is_name && is_term).then(|| (name.to_owned(), inside.to_owned()))
    };
    parted(&left).zip(parted(&right)).is_some_and(|(one, other)| one.0 == other.0 && one.1 != other.1)
}

/// Words with which a reason is given.
const REASONS: &[&str] = &["since", "because", "as we", "weil", "da ", "puisque", "car ", "perché", "poiché", "porque"];

/// Whether the words beside a relation give as its reason that a name is any of a set: it may stand for another one in each formula.
pub(super) fn is_of_any(relation: &PrintedRelation) -> bool {
    let words = relation.remark.as_deref().unwrap_or_default().to_lowercase();
    let words = words.trim_start_matches(|c: char| !c.is_alphabetic());
    let is_any = has_sign(words, &[r"\in", r"\forall", "arbitrary", "any "]);
    is_any && REASONS.iter().any(|w| words.starts_with(w))
}

/// Units of one letter, and those of more that are no usual product of names.
const UNITS: &[&str] = &[
    "A", "C", "F", "H", "J", "K", "N", "T", "V", "W", "g", "m", "s", "kg", "km", "cm", "mm", "nm", "Hz", "Pa", "eV",
    "mol", "keV", "MeV", "GeV", "TeV", "erg", "dyn", "kHz", "MHz", "GHz", "ms", "ns", "kJ", "MJ", "kW", "MW", "kPa",
    "MPa",
];

/// Most sides of a relation between units: each step of a chain asks.
const MOST_OF_UNITS: usize = 20;

/// Whether the names of a relation are units, three or more of them, one of more letters than one: `kg` is then no product.
pub(super) fn is_of_units(relation: &PrintedRelation) -> bool {
    if relation.sides.len() > MOST_OF_UNITS {
        return false;
    }
    let commands =
        [r"\cdot", r"\times", r"\frac", r"\dfrac", r"\tfrac", r"\left", r"\right", r"\text", r"\mathrm", r"\rm"];
    let plain = |s: &PrintedSide| commands.iter().fold(s.text.clone(), |text, c| text.replace(c, " "));
    let words: BTreeSet<String> = relation
        .sides
        .iter()
        .map(plain)
        .flat_map(|text| text.split(|c: char| !c.is_alphabetic() && c != '\\').map(str::to_owned).collect::<Vec<_>>())
        .filter(|word| !word.is_empty())
        .collect();
    words.len() > 2 && words.iter().all(|w| UNITS.contains(&w.as_str())) && words.iter().any(|w| w.len() > 1)
}

/// Whether all sides but the last are lone names, and that is one or a number.
pub(super) fn gives_values(relation: &PrintedRelation) -> bool {
    let Some((last, names_before)) = relation.sides.split_last() else { return false };
    names_before.iter().all(|s| lone_name(s).is_some()) && (names(last).is_empty() || lone_name(last).is_some())
}

/// Letters of constants of integration.
const OF_INTEGRATION: &[&str] = &["c", "C", "K", "k"];

/// Whether both sides of a step have the same constant of integration: behind an integral it may stand for another one.
pub(super) fn has_constant_of_integration(left: &PrintedSide, right: &PrintedSide) -> bool {
    let has = |side: &PrintedSide, letter: &str| names(side).iter().any(|n| n.key() == letter);
    OF_INTEGRATION.iter().any(|c| has(left, c) && has(right, c))
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
    let Some(left) = relation.sides.first() else { return BTreeSet::new() };
    let letters = match lone_name(left) {
        Some(name) => last_letters(&name),
        // A rate, `\frac{\partial c_i}{\partial T}`: a single term, in which nothing is raised.
        None if squeezed(&left.text).starts_with(r"\frac") && !left.text.contains(['^', '+', '-']) => {
            names(left).iter().flat_map(last_letters).collect()
        }
        None => return BTreeSet::new(),
    };
    let numbers: BTreeSet<String> = relation.sides.iter().flat_map(names).map(|n| n.key()).collect();
    let is_free = |l: &char| letters.iter().filter(|m| *m == l).count() == 1 && !numbers.contains(&l.to_string());
    letters.iter().copied().filter(is_free).collect()
}

/// The letters of a subscript that may be indices: its own, and those behind commas or below its labels, `k_{f,i}`, `\Theta_{F_i,\partial T}`.
fn last_letters(name: &PaperName) -> Vec<char> {
    let own = name.index_letters();
    let Some(below) = name.subscript.as_deref().filter(|_| own.is_empty()) else { return own };
    let all: Vec<char> =
        std::iter::once(',').chain(below.chars()).chain([',']).filter(|c| !c.is_whitespace()).collect();
    let ends = |c: char| matches!(c, ',' | '{' | '}' | '_');
    let alone = |w: &&[char]| "ijklmn".contains(w[1]) && ends(w[0]) && matches!(w[2], ',' | '}');
    all.windows(3).filter(alone).map(|w| w[1]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn relation(tex: &str) -> PrintedRelation {
        let paper = paper::parse_pasted("r", tex).expect("it is read");
        paper.printed.into_iter().next().expect("a relation")
    }

    #[test]
    fn a_letter_before_two_places_is_a_function() {
        let are = |tex: &str| {
            let relation = relation(tex);
            are_two_places(&relation.sides[0], &relation.sides[1])
        };
        assert!(are(r"E\left(\frac{\pi}{a}\right)=E\left(-\frac{\pi}{a}\right)") && are("f_1(x)=f_1(-x)"));
        assert!(are(r"\Omega(n+h)=\Omega(n-h)") && are("O(n^2+1)=O(n^2)"));
        for tex in ["a(b+c)=a(b-c)", "(a)=(b)", "E(x)=F(-x)", "2(x)=2(y)", "f(x)=f(x)", "g(x)h(y)=g(y)h(x)"] {
            assert!(!are(tex), "{tex}");
        }
    }

    #[test]
    fn units_of_two_letters_are_no_products() {
        let are = |tex: &str| is_of_units(&relation(tex));
        assert!(are(r"\frac{N \cdot m^2}{kg^2}=kg\cdot\frac{m^3/s^2}{kg^2}") && are(r"J=kg\,m^2/s^2"));
        for tex in ["F=mg", "N m=sT", r"F=\frac{m v^2}{s}", "a kg=m kg s", r"W=\mu N s\, m"] {
            assert!(!are(tex), "{tex}");
        }
    }
}
