//! How a condition is spelled: what is the same condition is found by one spelling, and an order of letters is known as one.
//!
//! **In:** a condition as a text in LaTeX. **Out:** one spelling of it, and the letters that it compares. Nothing is judged: two conditions
//! that are written in other ways may stay two.

use super::wording::dense;

/// Letters that are said to differ, or to be no values between others: what a condition says of them.
pub(super) struct Sides {
    pub letters: Vec<String>,
    pub between: Option<bool>,
}

/// The letters of a condition that is `a ≠ b`, or `(a-b)(a-c)` with a sign.
pub(super) fn sides(key: &str) -> Option<Sides> {
    let text = canonical(key);
    let is_letter = |of: &str| {
        of == "0" || of.starts_with(|c: char| c.is_alphabetic() || c == '\\') && !of.contains(['+', '-', '(', '^'])
    };
    if let Some((a, b)) = text.split_once('≠') {
        // What is zero is said last.
        let (a, b) = if a == "0" { (b, a) } else { (a, b) };
        let letters = vec![a.to_owned(), b.to_owned()];
        return letters.iter().all(|l| is_letter(l)).then_some(Sides { letters, between: None });
    }
    let (product, at_least) = match (text.strip_suffix("≥0"), text.strip_suffix("≤0")) {
        (Some(product), _) => (product, true),
        (_, Some(product)) => (product, false),
        (None, None) => return None,
    };
    let (one, other) = product.split_once("\\cdot")?;
    let difference = |of: &'_ str| -> Option<(String, String)> {
        let (a, b) = of.strip_prefix('(')?.strip_suffix(')')?.split_once('-')?;
        (is_letter(a) && is_letter(b)).then(|| (a.to_owned(), b.to_owned()))
    };
    let ((a, b), (c, d)) = (difference(one)?, difference(other)?);
    let (middle, left, right, same) = match () {
        () if a == c => (a, b, d, true),
        () if b == d => (b, a, c, true),
        () if a == d => (a, b, c, false),
        () if b == c => (b, a, d, false),
        () => return None,
    };
    let (left, right) = if right < left { (right, left) } else { (left, right) };
    Some(Sides { letters: vec![middle, left, right], between: Some(same != at_least) })
}

/// A formula whose letters are printed alike.
pub(super) fn upright(formula: &str) -> String {
    let mut text = formula.to_owned();
    for print in ["{\\bf", "\\mathbf{", "\\vec{", "\\boldsymbol{"] {
        while let Some(at) = text.find(print) {
            let end = text[at..].find('}').map_or(text.len(), |n| at + n);
            let inner = text[at + print.len()..end].trim().to_owned();
            text.replace_range(at..(end + 1).min(text.len()), &inner);
        }
    }
    text
}

/// A formula in which what is lowered stands before what is raised: `I^{-1}_i` is `I_i^{-1}`.
pub(super) fn lowered_first(text: &str) -> String {
    let mut out = text.to_owned();
    let mut from = 0;
    while let Some(at) = out[from..].find("^{").map(|n| from + n) {
        let Some(end) = out[at..].find('}').map(|n| at + n + 1) else { break };
        let index = out[end..].strip_prefix('_').and_then(|rest| rest.chars().next());
        if let Some(index) = index.filter(|c| c.is_alphanumeric()) {
            let raised = out[at..end].to_owned();
            out.replace_range(at..end + 1 + index.len_utf8(), &format!("_{index}{raised}"));
        }
        from = end;
    }
    out
}

/// One spelling of a condition that is written in several: `A - B ≠ 0` is `A \ne B`, either way round, and factors have no order.
pub(super) fn canonical(text: &str) -> String {
    let text = dense(text).replace("\\neq", "≠").replace("\\ne", "≠");
    if let Some((left, right)) = text.split_once('≠') {
        let minus: Vec<usize> = places_of(left, "-");
        let mut sides = match (right, minus.as_slice()) {
            ("0", &[at]) if at > 0 => [&left[..at], &left[at + 1..]],
            _ => [left, right],
        };
        sides.sort_unstable();
        return sides.join("≠");
    }
    let Some(at) = text.find(['≥', '≤', '<', '>']) else { return text };
    let (left, rest) = text.split_at(at);
    let mut factors = Vec::new();
    let mut from = 0;
    for dot in places_of(left, "\\cdot") {
        factors.push(&left[from..dot]);
        from = dot + "\\cdot".len();
    }
    factors.push(&left[from..]);
    factors.sort_unstable();
    format!("{}{rest}", factors.join("\\cdot"))
}

/// Where a word stands in a formula, outside of all brackets.
pub(super) fn places_of(formula: &str, word: &str) -> Vec<usize> {
    let mut depth = 0_i32;
    let mut out = Vec::new();
    for (at, c) in formula.char_indices() {
        match c {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            _ if depth == 0 && formula[at..].starts_with(word) => out.push(at),
            _ => {}
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_of_letters_has_words() {
        let of = |key: &str| sides(key).map(|s| (s.letters.join(" "), s.between));
        assert_eq!(of(r"I_2-I_1 ≠ 0"), Some(("I_1 I_2".to_owned(), None)));
        assert_eq!(of(r"m_3 ≠ 0"), Some(("m_3 0".to_owned(), None)));
        assert_eq!(of(r"(I_2-I_3)\cdot (I_2-I_1) ≥ 0"), Some(("I_2 I_1 I_3".to_owned(), Some(false))));
        assert_eq!(of(r"(I_3-I_1)\cdot (I_2-I_3) ≥ 0"), Some(("I_3 I_1 I_2".to_owned(), Some(true))));
        assert_eq!(of(r"(I_3-I_1)\cdot (I_3-I_2) ≤ 0"), Some(("I_3 I_1 I_2".to_owned(), Some(true))));
        assert_eq!(of(r"a+b ≠ 0"), None);
        assert_eq!(of(r"(a-b)\cdot (c-d) ≥ 0"), None);
        assert_eq!(of(r"x ≥ 0"), None);
    }

    #[test]
    fn one_condition_in_several_spellings_is_one() {
        for (one, other) in [
            (r"I_2-I_1 ≠ 0", r"I_1\ne I_2"),
            (r"m_3 ≠ 0", r"m_3\ne 0"),
            (r"(I_3-I_1)\cdot (I_2-I_1) ≥ 0", r"(I_2-I_1)\cdot (I_3-I_1) ≥ 0"),
        ] {
            assert_eq!(canonical(one), canonical(other));
        }
        for (one, other) in [
            (r"I_2-I_1 ≠ 0", r"I_2+I_1 ≠ 0"),
            (r"-x ≠ 0", r"x\ne 0"),
            (r"a-b-c ≠ 0", r"a\ne b-c"),
            (r"(I_2-I_3)\cdot (I_2-I_1) ≥ 0", r"(I_2-I_1)\cdot (I_3-I_1) ≥ 0"),
            (r"x ≥ 0", r"x ≤ 0"),
        ] {
            assert_ne!(canonical(one), canonical(other));
        }
    }
}
