//! What the page in a browser runs: a text on standard input, a page on standard output.
//!
//! **In:** LaTeX (a formula, a chain, a paper), or a derivation file. **Out:** the page of a lint or of a report; for a derivation file that
//! cannot be read, its problems. **Guaranteed:** every text has a page; no file is read, no clock is asked for what is said.
//!
//! **Why this way:** a program with a standard input and output needs no glue in Rust, and is tested as it is on any machine.

#![forbid(unsafe_code)]

use std::io::{Read, Write};

use rederive::{Ask, Session, diag, lint, paper, report};

fn main() -> std::io::Result<()> {
    let mut bytes = Vec::new();
    std::io::stdin().read_to_end(&mut bytes)?;
    std::io::stdout().write_all(page(&String::from_utf8_lossy(&bytes)).as_bytes())
}

/// The page on a text.
fn page(text: &str) -> String {
    if text.lines().any(|line| line.trim() == "[derivation]") { of_derivation(text) } else { of_paper(text) }
}

fn of_derivation(text: &str) -> String {
    let session = match Session::open("derivation.toml", text) {
        Ok(session) => session,
        Err(problems) => return words(&diag::render(&problems, false)),
    };
    match session.check(&Ask::default(), &|_, _| {}) {
        Ok(findings) => findings.page(),
        Err(failure) => words(&failure.to_string()),
    }
}

fn of_paper(text: &str) -> String {
    let source = diag::Source { path: "text.tex".into(), text: in_displays(text) };
    match paper::parse(source, String::new()) {
        Ok(paper) => report::lint_page(&paper, &lint::lint(&paper)),
        Err(problem) => words(&diag::render(&[*problem], false)),
    }
}

/// A text in which nothing says where formulas begin is formulas: each paragraph is a display. Lines stay where they are.
fn in_displays(text: &str) -> String {
    if ["$", r"\[", r"\(", r"\begin{"].iter().any(|mark| text.contains(mark)) {
        return text.to_owned();
    }
    let rows = |part: &str| part.contains(r"\\") || part.contains('&');
    let of_part = |part: &str| match (part.trim().is_empty(), rows(part)) {
        (true, _) => part.to_owned(),
        (false, true) => format!(r"\begin{{align}}{part}\end{{align}}"),
        (false, false) => {
            let display = |line: &str| if line.trim().is_empty() { line.to_owned() } else { format!(r"\[{line}\]") };
            part.split('\n').map(display).collect::<Vec<_>>().join("\n")
        }
    };
    text.split("\n\n").map(of_part).collect::<Vec<_>>().join("\n\n")
}

/// Words, as a page.
fn words(text: &str) -> String {
    let escaped = text.replace('&', "&amp;").replace('<', "&lt;");
    format!("<!doctype html><html lang=en><meta charset=utf-8><title>rederive</title><style>pre{{white-space:pre-wrap;overflow-wrap:anywhere}}</style><pre>{escaped}</pre></html>")
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
