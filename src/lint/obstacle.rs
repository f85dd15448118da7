//! What keeps a formula from being read as numbers: seen in its print, before the reader of formulas is asked.

use std::collections::{BTreeMap, BTreeSet};

use super::notation::Evidence;
use super::refusal::NotRead;
use super::space::is_vector_with_hat;
use paper::{Call, PaperName, PrintedSide, cancels_by_order, names, order_counts};

/// Letters by which sums run, where they stand twice.
fn index_count(names: &[PaperName], evidence: &Evidence) -> BTreeMap<char, usize> {
    let mut out = BTreeMap::new();
    let is_index = |n: &PaperName| !evidence.is_labelled(&n.letter) || evidence.is_summed_over(n);
    let numbered = |n: &&PaperName| !evidence.is_a_number(&n.key());
    let (indexed, labelled): (Vec<&PaperName>, Vec<&PaperName>) =
        names.iter().filter(numbered).partition(|n| is_index(n));
    for letter in indexed.into_iter().flat_map(PaperName::index_letters) {
        *out.entry(letter).or_insert(0) += 1;
    }
    // Beside an index the same letter is one, too, whatever else stands below.
    for letter in labelled.into_iter().flat_map(PaperName::index_letters).collect::<BTreeSet<_>>() {
        out.entry(letter).and_modify(|n| *n += 1);
    }
    out
}

/// Commands that make a formula one of a kind that is not read, and the name of the feature.
const FEATURES: &[(&str, &str)] = &[
    (r"\int", "an integral"),
    (r"\iint", "an integral"),
    (r"\oint", "an integral"),
    (r"\sum", "a sum"),
    (r"\prod", "a product of many factors"),
    (r"\lim", "a limit"),
    (r"\ket", "a ket"),
    (r"\bra", "a bra"),
    (r"\braket", "a bra-ket"),
    (r"\langle", "an average, or a bra-ket"),
    (r"\expval", "an average"),
    (r"\ldots", "dots"),
    (r"\cdots", "dots"),
    (r"\dots", "dots"),
    (r"\vdots", "dots"),
    (r"\begin{cases}", "cases"),
    (r"\dagger", "an operator"),
    (r"\infty", "infinity"),
    (r"\verb", "verbatim text"),
    (r"\SI", "a number with a unit"),
    (r"\si", "a unit"),
    (r"\unit", "a unit"),
    (r"\mathcal{O}", "an order of magnitude"),
    (r"\mathrm{O}", "an order of magnitude"),
    (r"\max", "a maximum"),
    (r"\min", "a minimum"),
    (r"\otimes", "a tensor product"),
    (r"\Big|", "a bar"),
    (r"\bigg|", "a bar"),
    (r"\Re", "a real part"),
    (r"\Im", "an imaginary part"),
    (r"\arg", "the argument of a complex number"),
    (r"\Arg", "the argument of a complex number"),
    (r"\operatorname{arg}", "the argument of a complex number"),
    (r"\mathrm{arg}", "the argument of a complex number"),
    (r"\operatorname{Re}", "a real part"),
    (r"\operatorname{Im}", "an imaginary part"),
    (r"\mathrm{Re}", "a real part"),
    (r"\mathrm{Im}", "an imaginary part"),
    (r"^*", "a star above: a conjugate, or a name"),
    (r"^{*}", "a star above: a conjugate, or a name"),
    (r"^\ast", "a star above: a conjugate, or a name"),
    (r"\text", "words in the formula"),
    (r"\mbox", "words in the formula"),
];

/// The feature of a formula that is not read, if one is seen.
fn feature(text: &str) -> Option<&'static str> {
    FEATURES.iter().find(|(command, _)| holds_command(text, command)).map(|(_, feature)| *feature)
}

fn holds_command(text: &str, command: &str) -> bool {
    text.match_indices(command).any(|(i, _)| {
        let next = text[i + command.len()..].chars().next();
        !command.ends_with(|c: char| c.is_ascii_alphabetic()) || !next.is_some_and(|c| c.is_ascii_alphabetic())
    })
}

/// What is in the names of a step that keeps it from being read.
pub fn obstacle(
    sides: &[&PrintedSide],
    all: &[PaperName],
    evidence: &Evidence,
    free: &BTreeSet<char>,
) -> Option<NotRead> {
    if let Some(found) = evidence.obstacle_together(sides) {
        return Some(found);
    }
    for side in sides {
        if side.is_list {
            return Some(NotRead::of("a list"));
        }
        if side.text.is_empty() {
            return Some(NotRead::of("a side that is missing"));
        }
        if let Some(feature) = feature(&side.text) {
            // Words in a subscript are a label, and are read as one.
            let words = matches!(feature, "words in the formula") && !words_outside(&side.text);
            let label = matches!(feature, "a maximum" | "a minimum" | "infinity") && in_scripts(&side.text, feature);
            if !words && !label {
                return Some(NotRead::of(feature));
            }
        }
        if let Some(found) = evidence.obstacle(side) {
            return Some(found);
        }
        // `\delta_{ij}` and ε are indices in any case.
        if side.text.contains(r"\delta_{") || side.text.contains(r"\epsilon_{") || side.text.contains(r"\varepsilon_{")
        {
            return Some(NotRead::of("indices"));
        }
        if has_number_as_label(&side.text) {
            return Some(NotRead::of("a number in parentheses below or above: a label"));
        }
        if is_zero_and_more(&side.text) {
            return Some(NotRead::of("0 before e: a word, or a factor"));
        }
        if has_derivative_at(&side.text) {
            return Some(NotRead::of("a derivative with a place behind it, or a product"));
        }
        if order_counts(&side.text) || cancels_by_order(side) {
            return Some(NotRead::of("products whose order may count: matrices, or operators"));
        }
        if applies_a_sum(&side.text, evidence) {
            return Some(NotRead::of("a function of anything, or a product"));
        }
        if is_sandwiched(&side.text) {
            return Some(NotRead::of("products whose order may count: matrices, or operators"));
        }
        let indices = index_count(&names(side), evidence);
        if let Some((letter, _)) = indices.iter().find(|(l, n)| **n > 1 && !free.contains(l)) {
            return Some(NotRead::of(format!("an index that may be summed over, {letter}")));
        }
    }
    for name in all {
        if name.is_difference || evidence.is_unsure_difference(name) {
            return Some(NotRead::of("a differential or a difference"));
        }
        if name.has_hat && !is_vector_with_hat(name, evidence) {
            return Some(NotRead::of("a hat: an operator, or a unit vector"));
        }
        if evidence.has_complex_j && name.key() == "j" {
            return Some(NotRead::of("j, which may be the imaginary unit"));
        }
        let known = evidence.calls.get(&name.key());
        // `f(0)f(1)`: a number in parentheses is a place as often as a factor.
        let is_number = |p: &String| p.chars().all(|c| c.is_ascii_digit());
        if matches!(&name.call, Call::Places(places) if places.iter().all(is_number)) && name.letter != r"\pi" {
            let is_called = known.is_some_and(|calls| calls.keys().flatten().any(|p| is_place(p)));
            if !is_called && evidence.variables_of(name).is_empty() {
                return Some(NotRead::of("a value at a place, or a product"));
            }
        }
        let count = |wanted: bool| -> usize {
            let of = |c: &BTreeMap<Option<Vec<String>>, usize>| {
                c.iter().filter(|(k, _)| k.as_ref().is_some_and(|p| is_place(p)) == wanted).map(|(_, n)| *n).sum()
            };
            known.map_or(0, of)
        };
        // What is printed with a place more than once, and not mostly without, is a function.
        if name.call == Call::Other && count(true) > 0 && count(true) * 3 >= count(false) {
            return Some(NotRead::of(format!("a function of anything, {}", name.key())));
        }
    }
    None
}

/// Whether a side begins with 0 and the letter e before a name: `x=0 e y=0` are two equations in Italian.
fn is_zero_and_more(text: &str) -> bool {
    let rest = text.trim_start().strip_prefix('0').map(str::trim_start).and_then(|rest| rest.strip_prefix('e'));
    rest.is_some_and(|rest| rest.trim_start().starts_with(|c: char| c.is_alphabetic() || c == '\\'))
}

/// Whether a group holds a number in parentheses and nothing else, `\frac{2x}{(1)}`, and is no label of a name.
fn has_number_as_label(text: &str) -> bool {
    let squeezed: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    squeezed.match_indices("{(").any(|(at, _)| {
        let inside = squeezed[at + 2..].split(')').next().unwrap_or_default();
        let is_number = !inside.is_empty() && inside.chars().all(|c| c.is_ascii_digit());
        is_number && squeezed[at + 2 + inside.len()..].starts_with(")}") && !squeezed[..at].ends_with(['^', '_'])
    })
}

/// Whether a derivative has more behind it in parentheses than its variable, with a sum in it: `\frac{d\phi}{dt}(t+T)` is a value at a
/// place, and no product.
fn has_derivative_at(text: &str) -> bool {
    let squeezed: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    [r"\frac{", r"\dfrac{", r"\tfrac{"].iter().any(|command| {
        squeezed.match_indices(command).any(|(at, _)| {
            let rest = &squeezed[at + command.len()..];
            let Some((above, below)) = group(rest) else { return false };
            // `\frac{d}{dx}(…)` is an operator on what stands behind it.
            let bare = above.trim_matches(|c: char| c.is_ascii_digit() || matches!(c, '^' | '{' | '}'));
            if matches!(bare, "d" | r"\mathrm{d" | r"\partial" | r"\dd" | "") {
                return false;
            }
            let Some((below, after)) = below.strip_prefix('{').and_then(group) else { return false };
            let by = [r"\mathrm{d}", r"\partial", r"\dd", "d"].iter().find_map(|d| below.strip_prefix(d));
            let (Some(by), Some(inside)) = (by, after.strip_prefix("\\left").unwrap_or(after).strip_prefix('(')) else {
                return false;
            };
            let inside = inside.split(')').next().unwrap_or("");
            let by = by.trim_matches(['{', '}']).trim_start_matches('\\');
            let letters = |c: char| c.is_ascii_alphabetic();
            !by.is_empty() && by.chars().all(letters) && inside.split(|c| !letters(c)).any(|word| word == by)
        })
    })
}

/// `(u\cdot v)(x+h)`: a product or sum of functions, at a place.
fn applies_a_sum(text: &str, evidence: &Evidence) -> bool {
    let squeezed: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let plain = squeezed.replace(r"\left", "").replace(r"\right", "").replace(r"\cdot", "*").replace(r"\circ", "*");
    plain.match_indices(")(").any(|(at, _)| {
        let Some(open) = plain[..at].rfind('(') else { return false };
        let inside = &plain[open + 1..at];
        let letters: Vec<char> = inside.chars().filter(char::is_ascii_alphabetic).collect();
        inside.chars().all(|c| c.is_ascii_alphabetic() || matches!(c, '*' | '+' | '-'))
            && letters.len() > 1
            && letters.iter().all(|c| evidence.may_be_function(&c.to_string()))
    })
}

/// A name, something else, and the inverse of the name: `gxg^{-1}`.
fn is_sandwiched(text: &str) -> bool {
    let mut squeezed: String = text.chars().filter(|c| !c.is_whitespace() && !matches!(c, '{' | '}')).collect();
    // A style is no name: without it a letter is one.
    for style in [r"\mathscr", r"\mathcal", r"\mathbf", r"\mathrm", r"\boldsymbol", r"\hat", r"\tilde"] {
        squeezed = squeezed.replace(style, "");
    }
    let behind = squeezed.match_indices("^-1").any(|(at, _)| {
        let Some(name) = squeezed[..at].chars().next_back().filter(char::is_ascii_uppercase) else { return false };
        let term = squeezed[at + 3..].split(['+', '-', '=', '/']).next().unwrap_or_default();
        // `U^{-1}HU`: what stands between is one letter or more.
        term.chars().next().is_some_and(|c| c.is_ascii_uppercase() && c != name)
            && term.chars().skip(1).any(|c| c == name)
            && !term.contains(r"\frac")
    });
    behind
        || squeezed.match_indices("^-1").any(|(at, _)| {
            let before = &squeezed[..at];
            let command =
                before.rfind('\\').filter(|k| before[k + 1..].chars().all(|c| c.is_ascii_alphabetic()) && at - k > 2);
            let last = before.char_indices().next_back().map_or(0, |(k, _)| k);
            let name = &before[command.unwrap_or(last)..];
            let term = before[..before.len() - name.len()].rsplit(['+', '-', '=', '/']).next().unwrap_or_default();
            let letter = name.chars().all(|c| c.is_ascii_alphabetic() || c == '\\');
            letter && term.find(name).is_some_and(|k| k + name.len() < term.len() && !term.contains(r"\frac"))
        })
}

/// What stands in a group whose brace is open, and what stands behind it.
fn group(text: &str) -> Option<(&str, &str)> {
    let mut depth = 1;
    for (i, c) in text.char_indices() {
        depth += match c {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        if depth == 0 {
            return Some((&text[..i], &text[i + 1..]));
        }
    }
    None
}

/// Whether what stands in parentheses is a place of a function: a name, or several.
pub fn is_place(places: &[String]) -> bool {
    places.iter().any(|p| !p.chars().all(|c| c.is_ascii_digit()))
}

fn words_outside(text: &str) -> bool {
    [r"\text", r"\mbox"].iter().any(|w| {
        text.match_indices(w).any(|(i, _)| {
            let before = text[..i].trim_end();
            let is_label = before.ends_with(['_', '^']) || before.ends_with("_{") || before.ends_with("^{");
            !is_label && !is_function(&text[i..])
        })
    })
}

/// Whether what stands here is the name of a function in upright letters, and its argument in parentheses: `\text{exp}\left(x\right)`.
fn is_function(text: &str) -> bool {
    let inside = text.find('{').and_then(|at| text[at + 1..].split_once('}'));
    inside.is_some_and(|(word, behind)| {
        let behind = behind.trim_start();
        latex::is_function(word.trim()) && (behind.starts_with('(') || behind.starts_with(r"\left("))
    })
}

fn in_scripts(text: &str, feature: &str) -> bool {
    let command = match feature {
        "a maximum" => r"\max",
        "a minimum" => r"\min",
        _ => r"\infty",
    };
    text.match_indices(command).all(|(i, _)| {
        let before = text[..i].trim_end();
        before.ends_with('_') || before.ends_with("_{")
    })
}
