//! Displays that go on from the one before.
//!
//! **In:** the printed relations of a paper, and the text between them. **Out:** the last side of the display before, as the first of one that
//! begins with `=`. **Guaranteed:** nothing but a comma is printed between the two; else the side stays a missing one.

use std::ops::Range;

use super::{Paper, PrintedSide};

/// Commands between displays that print nothing, with their arguments.
const SILENT: &[&str] = &[r"\begin{", r"\end{", r"\label{"];
/// The same without arguments.
const SIGNS: &[&str] = &[r"\[", r"\]", "$$", r"\nonumber", r"\notag", r"\\", "&"];

/// Gives displays that begin with a sign of relation the side that they go on from.
pub(super) fn join(paper: &mut Paper) {
    for at in 1..paper.printed.len() {
        let Some([before, one]) = paper.printed.get(at - 1..=at) else { continue };
        let follows = before.display.zip(one.display).is_some_and(|(first, second)| first + 1 == second);
        let misses = one.sides.len() > 1 && one.sides.first().is_some_and(|side| side.text.is_empty());
        let sign = one.signs.first().map_or("", String::as_str);
        if !follows || !misses || !is_silent(paper, before.span().end..one.span().start, sign) {
            continue;
        }
        let place = one.span().start;
        // The side was printed, and judged, where it stands.
        let side = before.sides.last().filter(|side| !side.text.is_empty() && !before.sides.is_empty());
        let Some(side) = side.map(|side| PrintedSide { span: place..place, ..side.clone() }) else { continue };
        if let Some(first) = paper.printed.get_mut(at).and_then(|one| one.sides.first_mut()) {
            *first = side;
        }
    }
}

/// Whether nothing is printed between two places of one file but the ends of displays, and the sign with which the second begins.
fn is_silent(paper: &Paper, between: Range<usize>, sign: &str) -> bool {
    let Range { start, end } = between;
    let ((file, first), (other, second)) = (paper.locate(&(start..start)), paper.locate(&(end..end)));
    let Some(text) = file.text.get(first.start..second.start).filter(|_| std::sync::Arc::ptr_eq(file, other)) else {
        return false;
    };
    let text = text.trim_end().trim_end_matches(['{', '&']).trim_end();
    let mut text = text.strip_suffix(sign).unwrap_or(text).to_owned();
    for command in SILENT {
        while let Some(at) = text.find(command) {
            let Some(length) = text[at..].find('}') else { return false };
            text.replace_range(at..=at + length, "");
        }
    }
    let rest = SIGNS.iter().fold(text, |text, sign| text.replace(sign, ""));
    rest.chars().all(|c| c.is_whitespace() || c == ',')
}
