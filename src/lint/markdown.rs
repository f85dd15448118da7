//! The sentence around a display of Markdown, where blank lines stand before it and behind it.
//!
//! **In:** the text before a display, or behind a relation. **Out:** the same without what opens or closes the display, and the blank lines
//! beside that. **Guaranteed:** a part of the text that was given.

/// A text up to the blank line before the display that begins at its end.
pub fn without_opening(text: &str) -> &str {
    let mut rest = text.trim_end();
    loop {
        let opener = rest.rfind(r"\begin{").filter(|at| !rest[*at..].contains(['\n', '$']) && rest.ends_with('}'));
        rest = match opener {
            Some(at) => &rest[..at],
            None => match rest.strip_suffix("$$").or_else(|| rest.strip_suffix(r"\[")) {
                Some(shorter) => shorter,
                None => return rest,
            },
        }
        .trim_end();
    }
}

/// A text from the blank line behind the display that ends at its beginning.
pub fn without_closing(text: &str) -> &str {
    let end = |t: &str| {
        let closes = |from: usize| {
            let rest = &t[from..];
            rest.starts_with("$$") || rest.starts_with(r"\]") || rest.starts_with(r"\end{")
        };
        (0..t.len()).filter(|&i| t.is_char_boundary(i)).find(|&i| closes(i))
    };
    let Some(at) = end(text).filter(|at| !text[..*at].contains("\n\n")) else { return text };
    let mut rest = &text[at..];
    while let Some(after) = rest
        .strip_prefix("$$")
        .or_else(|| rest.strip_prefix(r"\]"))
        .or_else(|| rest.strip_prefix(r"\end{").and_then(|r| r.split_once('}')).map(|(_, after)| after))
    {
        rest = after.trim_start();
    }
    rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_paragraphs_beside_a_display_are_found() {
        assert_eq!(without_opening("so that\n\n$$\n"), "so that");
        assert_eq!(without_opening("so that\n\n\\begin{align*}\n  "), "so that");
        assert_eq!(without_opening("so that $x$"), "so that $x$");
        assert_eq!(without_closing(".\n$$\n\nwhere $k=1$"), "where $k=1$");
        assert_eq!(without_closing(" \\end{align}\\] \n\nwhere"), "where");
        assert_eq!(without_closing("\n\nmuch later $$x$$"), "\n\nmuch later $$x$$");
    }
}
