//! The report as LaTeX source, for an appendix or a letter to an editor: plain `pdflatex` compiles it.
//!
//! **In:** a derivation and its account. **Out:** one file that needs only `amsmath`, `amssymb`, `bm` and `longtable`, which
//! every distribution has.
//!
//! **Guaranteed:** texts of the file are escaped: no command of theirs is carried out. Formulas are written anew from their
//! syntax trees, so that only commands of the formula language reach LaTeX; a text that is no formula is set as it is,
//! letter by letter. Letters that plain `pdflatex` does not know are replaced by commands or spelled out.

use super::latex_text::prose;
use super::{page_one, sections, story, whole};
use derivation::Derivation;
use findings::Account;

const PREAMBLE: &str = r"\documentclass[11pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath,amssymb,bm,longtable}
\usepackage[margin=25mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt plus 2pt}
\emergencystretch=3em
\allowdisplaybreaks
\begin{document}
";

/// The LaTeX source.
pub fn tex(derivation: &Derivation, account: &Account) -> String {
    document(derivation, PREAMBLE, whole::report(derivation, account, None))
}

/// The first page as a document of its own, for a letter.
pub fn tex_summary(derivation: &Derivation, account: &Account) -> String {
    let preamble = PREAMBLE.replace("11pt", "10pt").replace("margin=25mm", "margin=20mm");
    document(derivation, &preamble, page_one::blocks(derivation, account))
}

fn document(derivation: &Derivation, preamble: &str, report: Vec<story::StoryBlock<'_>>) -> String {
    let mut blocks = sections::concerns(derivation);
    blocks.extend(report);
    let title = prose(&derivation.title, &derivation.scope);
    format!("{preamble}\\section*{{{title}}}\n\n{}\\end{{document}}\n", story::tex(&blocks))
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::super::tests::derivation;
    use super::*;
    use findings::sample;

    #[test]
    fn the_source_is_whole() {
        let out = tex(&derivation(), &sample::account());
        assert!(out.starts_with(r"\documentclass") && out.ends_with("\\end{document}\n"));
        assert_eq!(out.matches(r"\begin{").count(), out.matches(r"\end{").count());
        assert!(out.contains(r"everywhere \textless{}sic\textgreater{}"));
        let page = tex_summary(&derivation(), &sample::account());
        assert!(page.starts_with(r"\documentclass") && page.ends_with("\\end{document}\n"));
        assert_eq!(page.matches(r"\begin{").count(), page.matches(r"\end{").count());
    }
}
