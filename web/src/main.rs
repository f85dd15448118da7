//! What the page in a browser runs: a text on standard input, a page on standard output.
//!
//! **In:** LaTeX (a formula, a chain, a paper), or a derivation file. **Out:** the page of a lint or of a report; for a derivation file that
//! cannot be read, its problems. **Guaranteed:** every text has a page; no file is read, no clock is asked for what is said.
//!
//! **Why this way:** a program with a standard input and output needs no glue in Rust, and is tested as it is on any machine.

#![forbid(unsafe_code)]

use std::io::{Read, Write};

use rederive::check::Limits;
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
    match paper::parse_pasted("text.tex", text) {
        Ok(paper) => report::lint_page(&paper, &lint::lint(&paper, &Limits::default())),
        Err(problem) => words(&diag::render(&[*problem], false)),
    }
}

/// Words, as a page.
fn words(text: &str) -> String {
    let escaped = text.replace('&', "&amp;").replace('<', "&lt;");
    format!("<!doctype html><html lang=en><meta charset=utf-8><title>rederive</title><style>pre{{white-space:pre-wrap;overflow-wrap:anywhere}}</style><pre>{escaped}</pre></html>")
}
