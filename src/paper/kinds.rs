//! What a file is by its name: LaTeX, Markdown, a notebook, or nothing that is read.
//!
//! **In:** the name of a file. **Out:** how its text is read. **Guaranteed:** a name that says nothing is read as LaTeX; one that says that
//! something else is in the file is refused.

use std::path::Path;

use diag::Diagnostic;

/// How a file is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FileKind {
    Latex,
    Markdown,
    Notebook,
    /// It is not: what it is.
    Refused(&'static str),
}

/// Endings of files that are neither LaTeX nor Markdown, and what they are.
const REFUSED: &[(&str, &[&str])] = &[
    ("reStructuredText", &["rst", "rest"]),
    ("AsciiDoc", &["adoc", "asciidoc"]),
    ("Org", &["org"]),
    ("Typst", &["typ"]),
    ("HTML", &["html", "htm", "xhtml"]),
    ("XML", &["xml", "svg", "jats"]),
    ("a bibliography", &["bib", "bbl", "ris"]),
    ("a PDF", &["pdf"]),
    ("a document of a word processor", &["doc", "docx", "odt", "rtf", "pages", "lyx", "epub"]),
    ("a picture", &["png", "jpg", "jpeg", "gif", "eps", "ps", "webp", "tif", "tiff"]),
    ("an archive", &["zip", "gz", "tgz", "tar", "bz2", "xz", "7z"]),
    ("data", &["json", "csv", "tsv", "yaml", "yml", "xlsx", "ods", "npz", "npy", "h5"]),
    (
        "a program",
        &[
            "py", "pyx", "rs", "c", "h", "cc", "cpp", "hpp", "java", "js", "ts", "jl", "r", "f", "f90", "go", "hs",
            "lua", "sh", "pl", "rb", "nb", "wl", "mlx", "lean",
        ],
    ),
    ("what a run of LaTeX left", &["aux", "log", "toc", "out", "synctex"]),
];

impl FileKind {
    /// By the ending of a name.
    pub fn of(path: &str) -> FileKind {
        let ending = Path::new(path).extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        match ending.as_str() {
            "md" | "markdown" => FileKind::Markdown,
            "ipynb" => FileKind::Notebook,
            ending => {
                let refused = REFUSED.iter().find(|(_, endings)| endings.contains(&ending));
                refused.map_or(FileKind::Latex, |(what, _)| FileKind::Refused(what))
            }
        }
    }

    /// That a file is not read, where its name says so.
    pub fn refusal(path: &str) -> Option<Box<Diagnostic>> {
        let FileKind::Refused(what) = FileKind::of(path) else { return None };
        let message = format!(
            "this file is {what} by its name, and is not read: LaTeX (`.tex`), Markdown (`.md`), notebooks (`.ipynb`) and standard input are"
        );
        Some(Box::new(Diagnostic::of_file(path, "paper::unreadable", message)))
    }
}

/// Whether a file is Markdown, by its name: there a display stands in a paragraph of its own, and its sentence around it.
pub fn is_markdown(path: &str) -> bool {
    matches!(FileKind::of(path), FileKind::Markdown | FileKind::Notebook)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_is_read() {
        for path in ["p.tex", "p.ltx", "p.latex", "p.txt", "p.sty", "p.mkd", "p.Rmd", "p.qmd", "p", "-", "p.1"] {
            assert_eq!(FileKind::of(path), FileKind::Latex, "{path}");
        }
        assert_eq!(FileKind::of("a.b/p.MD"), FileKind::Markdown);
        assert_eq!(FileKind::of("p.ipynb"), FileKind::Notebook);
        for path in ["p.rst", "p.html", "p.py", "p.bib", "p.docx", "p.PDF"] {
            assert!(FileKind::refusal(path).is_some_and(|d| d.message.contains("`.ipynb`")), "{path}");
        }
    }
}
