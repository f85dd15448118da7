//! A text that somebody pasted, or wrote into a cell: where nothing says where formulas begin, it is formulas.

use std::borrow::Cow;

/// What says where a formula begins.
const MARKS: [&str; 4] = ["$", r"\[", r"\(", r"\begin{"];

/// A text as a paper. Where nothing in it says where formulas begin, each line is a display, and a paragraph whose lines end with `\\`
/// or have `&` is one of several lines. Lines keep their numbers; what is put before a formula moves its column.
pub(super) fn in_displays(text: &str) -> Cow<'_, str> {
    if MARKS.iter().any(|mark| text.contains(mark)) {
        return Cow::Borrowed(text);
    }
    let has_rows = |part: &str| part.contains(r"\\") || part.contains('&');
    let of_part = |part: &str| match (part.trim().is_empty(), has_rows(part)) {
        (true, _) => part.to_owned(),
        (false, true) => format!(r"\begin{{align}}{part}\end{{align}}"),
        (false, false) => {
            let display = |line: &str| if line.trim().is_empty() { line.to_owned() } else { format!(r"\[{line}\]") };
            part.split('\n').map(display).collect::<Vec<_>>().join("\n")
        }
    };
    Cow::Owned(text.split("\n\n").map(of_part).collect::<Vec<_>>().join("\n\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_without_marks_are_displays_on_their_lines() {
        assert_eq!(in_displays("a=b\nc=d"), "\\[a=b\\]\n\\[c=d\\]");
        assert_eq!(in_displays("a&=b\\\\\n&=c\n\nx=y"), "\\begin{align}a&=b\\\\\n&=c\\end{align}\n\n\\[x=y\\]");
        for as_it_is in ["", "\n", "$a=b$", r"\begin{equation}a=b\end{equation}"] {
            assert_eq!(in_displays(as_it_is), as_it_is);
        }
    }
}
