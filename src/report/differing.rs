//! The difference of two formulas, sign by sign: what is wrong in a print is marked where a reader sees it.
//!
//! **In:** two formulas as MathML. **Out:** the first, in which the signs have a class that the second has not.

/// Formulas of more signs than this are not compared sign by sign.
const MOST_COMPARED: usize = 400;

/// A formula, as MathML, in which the signs have a class that another formula has not. Signs are the leaves of the tree; the invisible
/// ones are left alone.
pub(super) fn differing(own: &str, other: &str, class: &str) -> String {
    let (signs, others) = (leaves(own), leaves(other));
    if signs.len().max(others.len()) > MOST_COMPARED {
        return own.to_owned();
    }
    // The longest common part, from the end: `length[i][j]` is that of what begins at i and j.
    let a: Vec<&str> = signs.iter().map(|&(from, to)| &own[from..to]).collect();
    let b: Vec<&str> = others.iter().map(|&(from, to)| &other[from..to]).collect();
    let mut length = vec![vec![0_usize; b.len() + 1]; a.len() + 1];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            length[i][j] = if a[i] == b[j] { length[i + 1][j + 1] + 1 } else { length[i + 1][j].max(length[i][j + 1]) };
        }
    }
    let (mut out, mut done, mut j) = (String::new(), 0, 0);
    for (i, (from, _)) in signs.iter().enumerate() {
        while j < b.len() && a[i] != b[j] && length[i][j + 1] > length[i + 1][j] {
            j += 1;
        }
        if j < b.len() && a[i] == b[j] {
            j += 1;
            continue;
        }
        if a[i].contains(['\u{2061}', '\u{2062}']) {
            continue;
        }
        // An element has one class attribute; else it comes after the name of the tag, which has three letters with its bracket.
        let (at, added) = match a[i].find("class=\"") {
            Some(of) => (from + of + 7, format!("{class} ")),
            None => (from + 3, format!(" class=\"{class}\"")),
        };
        out.push_str(&own[done..at]);
        out.push_str(&added);
        done = at;
    }
    out.push_str(&own[done..]);
    out
}

/// Where the signs of a formula are: `<mi>`, `<mn>` and `<mo>` with what they contain.
fn leaves(math: &str) -> Vec<(usize, usize)> {
    let mut out = Vec::new();
    let mut from = 0;
    while let Some(at) = math[from..].find("<m").map(|i| from + i) {
        let rest = &math[at..];
        let is_leaf =
            ["<mi", "<mn", "<mo"].iter().any(|tag| rest.starts_with(tag)) && rest[3..].starts_with([' ', '>']);
        match rest.find("</").and_then(|close| Some(close + rest[close..].find('>')? + 1)).filter(|_| is_leaf) {
            Some(length) => {
                out.push((at, at + length));
                from = at + length;
            }
            None => from = at + 2,
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_that_another_formula_has_not_are_marked() {
        let own =
            "<math><mi>a</mi><mo>+</mo><msup><mi mathvariant=\"normal\" class=\"b\">m</mi><mn>2</mn></msup></math>";
        let other = "<math><mi>a</mi><mo>−</mo><msup><mi>m</mi><mn>2</mn></msup></math>";
        assert_eq!(
            differing(own, other, "w"),
            "<math><mi>a</mi><mo class=\"w\">+</mo><msup><mi mathvariant=\"normal\" class=\"w b\">m</mi><mn>2</mn></msup></math>"
        );
        assert_eq!(differing(own, own, "w"), own);
        assert_eq!(
            differing("<math><mover><mi>x</mi><mo>˙</mo></mover></math>", "<math></math>", "w")
                .matches("\"w\"")
                .count(),
            2
        );
    }
}
