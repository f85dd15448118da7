//! What a letter is where it stands: a matrix of so many rows and columns, or a charge that is printed as Euler's number.
//!
//! **In:** the relations of a paper, or the texts of a step. **Out:** the shapes of names, by their sections; whether `e` is a name.
//! **Guaranteed:** a shape that does not fit is a refusal of the reader, and never another reading.

use std::collections::BTreeMap;
use std::ops::Range;

use expr::Shape;
use paper::{Paper, PaperName};

use super::lone::lone_name;
use super::notation::Evidence;

/// So many relations before and behind one that sets a name equal to a matrix have the name as one.
const NEAR: usize = 30;

/// Of names: where the section begins and ends in which they are set equal to a matrix, and its rows and columns.
pub type Sizes = BTreeMap<String, Vec<(Range<usize>, (usize, usize))>>;

/// The sizes of the names that are set equal to matrices, by the sections in which they are.
pub fn sizes(paper: &Paper) -> Sizes {
    let mut sections: BTreeMap<usize, Range<usize>> = BTreeMap::new();
    for relation in &paper.printed {
        let span = relation.span();
        let section = sections.entry(relation.section).or_insert_with(|| span.clone());
        *section = section.start.min(span.start)..section.end.max(span.end + 1);
    }
    let mut out = Sizes::new();
    for (at, relation) in paper.printed.iter().enumerate() {
        let near = |k: usize| paper.printed.get(k).map_or(usize::MAX, |r| r.span().end.saturating_add(1));
        let (from, to) = (near(at.saturating_sub(NEAR)).min(relation.span().start), near(at + NEAR));
        for pair in relation.sides.windows(2) {
            for (side, other) in [(&pair[0], &pair[1]), (&pair[1], &pair[0])] {
                if let (Some(size), Some(section)) = (other.matrix_size(), sections.get(&relation.section))
                    && let Some(name) = lone_name(side)
                {
                    let place = section.start.max(from)..section.end.min(to).max(relation.span().end);
                    out.entry(name.key()).or_default().push((place, size));
                }
            }
        }
    }
    out
}

/// The shape of a name: that of the matrix to which the paper sets it equal, or that of its style.
pub fn shape_of(name: &PaperName, key: &str, evidence: &Evidence, place: usize) -> Option<Shape> {
    let extent = |n: usize| u16::try_from(n).ok();
    match evidence.matrix_size(key, place) {
        Some((1, 1)) => None,
        Some((rows, 1)) => extent(rows).map(Shape::vector),
        Some((rows, columns)) => extent(rows).zip(extent(columns)).map(|(r, c)| Shape::matrix(r, c)),
        None => name.is_bold.then(|| Shape::vector(3)),
    }
}

/// Whether `e` is raised to nothing but numbers, beside other names and no logarithm: a charge. What is proved of it is true of Euler's number,
/// too.
pub fn is_charge(texts: &[&str]) -> bool {
    let mut is_raised = false;
    for text in texts {
        let text = text.replace("^ ", "^").replace(" ^", "^");
        if [r"\ln", r"\log", r"\exp", r"\mathrm{e}"].iter().any(|w| text.contains(w)) {
            return false;
        }
        for (at, _) in text.match_indices("e^") {
            let before = text[..at].trim_end_matches(|c: char| c.is_ascii_alphabetic());
            if before.ends_with(['_', '\\']) && before.len() < at || before.ends_with('_') {
                continue;
            }
            let above = &text[at + 2..];
            let above = above
                .strip_prefix('{')
                .and_then(|rest| rest.split('}').next())
                .unwrap_or(above.get(..1).unwrap_or_default());
            if above.is_empty() || !above.chars().all(|c| c.is_ascii_digit()) {
                return false;
            }
            is_raised = true;
        }
    }
    is_raised
}

#[cfg(test)]
mod tests {
    use super::is_charge;

    #[test]
    fn a_letter_that_is_raised_to_numbers_alone_is_a_charge() {
        assert!(is_charge(&[r"\frac{e^2}{4\pi r}"]) && is_charge(&[r"\theta e^{2}", "x"]));
        for text in [r"e^{2x}e^2", r"e^x", r"\ln e^2", r"e^{-2}", r"x_e^2", r"ab", r"\theta e^{x}e^2"] {
            assert!(!is_charge(&[text]), "{text}");
        }
    }
}
