//! What a run over several derivation files found, and its text in every format.
//!
//! **In:** [`Findings`] file by file, with the comparison with a paper where there is one; problems of files. **Out:** the text of a
//! [`Format`]: a document for each file, or one for all.

use crate::conclusion::{Conclusion, Demand};
use crate::derivation::Derivation;
use crate::diag::Diagnostic;
use crate::paper::{Comparison, Paper, compare, subject};
use crate::report::{self, Checked, Finding};
use crate::session::{Failure, Findings, Session};

/// How results are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A summary for people.
    Text,
    /// The report as JSON, one document for each derivation file.
    Json,
    /// The report as LaTeX source.
    Tex,
    /// The report in Markdown.
    Markdown,
    /// JUnit XML.
    Junit,
    /// SARIF 2.1.0.
    Sarif,
    /// Annotations of a GitHub workflow.
    Github,
}

impl Format {
    /// All of them.
    pub const ALL: [Format; 7] =
        [Format::Text, Format::Json, Format::Tex, Format::Markdown, Format::Junit, Format::Sarif, Format::Github];

    /// Its name, and what it is, in words.
    pub fn words(self) -> (&'static str, &'static str) {
        match self {
            Format::Text => ("text", "For people"),
            Format::Json => ("json", "As JSON"),
            Format::Tex => ("tex", "As LaTeX source, for an appendix or a letter; pdflatex compiles it"),
            Format::Markdown => ("markdown", "As Markdown, for a forge"),
            Format::Junit => ("junit", "As JUnit XML: a test case for each claim on each trajectory"),
            Format::Sarif => ("sarif", "As SARIF 2.1.0, for code scanning: what is not as expected, with its place"),
            Format::Github => ("github", "As annotations of a GitHub workflow"),
        }
    }

    /// Whether it has a document for each derivation file, and not one for all.
    pub fn is_of_one_file(self) -> bool {
        matches!(self, Format::Text | Format::Json | Format::Tex | Format::Markdown)
    }
}

/// How much the text for people says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Detail {
    /// What differs, and what is open.
    Exceptions,
    /// The first page alone.
    FirstPage,
    /// The first page, and what asks for attention.
    #[default]
    Usual,
    /// The matrix, and all that was found.
    Whole,
}

/// What was found of one derivation file.
#[derive(Clone, Debug)]
pub struct Document {
    /// The findings.
    pub findings: Findings,
    /// How it compares with the paper.
    pub paper: Option<Comparison>,
}

impl From<Findings> for Document {
    fn from(findings: Findings) -> Document {
        Document { findings, paper: None }
    }
}

impl Document {
    fn json(&self) -> String {
        match &self.paper {
            Some(paper) => report::json_with_paper(self.findings.derivation(), self.findings.account(), paper),
            None => self.findings.json(),
        }
    }

    /// Its text in a format that has a document for each file; empty for others. `colour`: with escape codes.
    pub fn text(&self, format: Format, detail: Detail, colour: bool) -> String {
        let (derivation, account) = (self.findings.derivation(), self.findings.account());
        match (format, detail) {
            (Format::Text, Detail::Exceptions) => report::exceptions(derivation, account, colour),
            (Format::Text, Detail::FirstPage) => report::front_page(derivation, account, colour),
            (Format::Text, Detail::Usual | Detail::Whole) => {
                let mut out = report::summary(derivation, account, colour, detail == Detail::Whole);
                out.extend(self.paper.as_ref().map(|paper| report::paper_summary(derivation, paper)));
                out
            }
            (Format::Json, _) => self.json(),
            (Format::Tex, Detail::FirstPage) => report::tex_summary(derivation, account),
            (Format::Tex, _) => self.findings.latex(),
            (Format::Markdown, Detail::FirstPage) => report::front_markdown(derivation, account),
            (Format::Markdown, _) => self.findings.markdown(),
            (Format::Junit | Format::Sarif | Format::Github, _) => String::new(),
        }
    }
}

impl Document {
    /// How this ends a run.
    pub fn conclusion(&self, demand: &Demand) -> Conclusion {
        Conclusion::of(self, demand)
    }

    /// What is printed on paper, for whichever program is there: LaTeX source, and a page for a browser. `summary`: the first page alone.
    pub fn printed(&self, summary: bool) -> (String, String) {
        let (derivation, account) = (self.findings.derivation(), self.findings.account());
        match summary {
            true => (report::tex_summary(derivation, account), report::first_page(derivation, account)),
            false => (self.findings.latex(), report::printed_page(derivation, account)),
        }
    }

    /// The files of the folder of its report, by name. Proofs as steps among them: `proofs/`.
    pub fn files(&self) -> Vec<(String, String)> {
        let found = &self.findings;
        let data = || (self.json(), report::certificates(found.derivation(), found.account()));
        let ((json, certificates), (page, markdown)) =
            rayon::join(data, || rayon::join(|| found.page(), || found.markdown()));
        let proofs = report::proofs(found.derivation(), found.account());
        let files = [("report.json", json), (report::PROOFS, proofs), ("report.md", markdown), ("index.html", page)];
        files.into_iter().map(|(name, text)| (name.to_owned(), text)).chain(certificates).collect()
    }
}

/// What a run found, file by file, and what is to be told beside verdicts.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// The paper of one of the derivations, with the id of that one.
    paper: Option<(Paper, String)>,
    documents: Vec<Document>,
    problems: Vec<Diagnostic>,
    /// Everything that is to be told, verdicts included.
    findings: Vec<Finding>,
    /// Of these, what is not of a verdict.
    others: Vec<Finding>,
}

impl Run {
    /// Compares what is added from now on with a paper: that one of the derivations which it is the paper of.
    ///
    /// # Errors
    /// It is the paper of none of them, or of several; in a sentence.
    pub fn compare(&mut self, paper: Paper, of: &[Session]) -> Result<(), String> {
        let id = subject(of.iter().map(Session::derivation))?.id.clone();
        self.paper = Some((paper, id));
        Ok(())
    }

    /// Adds what was found of one derivation file, beside the paper where it is that of it. Problems are added to those of the run, so
    /// that other files can be checked all the same: there is no document then.
    ///
    /// # Errors
    /// Whatever else ends a check.
    pub fn add(&mut self, found: Result<Findings, Failure>) -> Result<Option<&Document>, Failure> {
        let findings = match found {
            Err(Failure::Problems(found)) => {
                self.add_problems(found);
                return Ok(None);
            }
            found => found?,
        };
        let paper = self.paper.as_ref().filter(|(_, id)| *id == findings.derivation().id);
        let paper = paper.map(|(paper, _)| compare(findings.derivation(), paper));
        let document = Document { findings, paper };
        let found = &document.findings;
        let mut verdicts = report::findings(found.derivation(), found.account());
        if let Some(comparison) = &document.paper {
            report::add_paper(&mut verdicts, found.derivation(), comparison);
            let of_paper = report::paper_findings(found.derivation(), comparison);
            self.others.extend(of_paper.iter().cloned());
            verdicts.extend(of_paper);
        }
        self.findings.extend(verdicts);
        self.documents.push(document);
        Ok(self.documents.last())
    }

    /// Adds problems of files.
    pub fn add_problems(&mut self, found: Vec<Diagnostic>) {
        let told = report::problems(&found);
        self.problems.extend(found);
        self.findings.extend(told.iter().cloned());
        self.others.extend(told);
    }

    /// Adds that nothing was found of a file, since the program stopped in the middle of it.
    pub fn add_defect(&mut self, of: &Derivation, what: &str) {
        let message = format!("a defect of this program, not of the file: {what}");
        let told = report::problems(&[Diagnostic::of_file(&of.file.path, "check::defect", message)]);
        self.findings.extend(told.iter().cloned());
        self.others.extend(told);
    }

    /// All problems of files.
    pub fn problems(&self) -> &[Diagnostic] {
        &self.problems
    }

    /// The text of a format, without colours.
    pub fn text(&self, format: Format, detail: Detail) -> String {
        match format {
            Format::Text | Format::Json | Format::Tex | Format::Markdown => {
                let between = if format == Format::Json || detail == Detail::Exceptions { "" } else { "\n" };
                let each = self.documents.iter().map(|d| d.text(format, detail, false));
                each.collect::<Vec<_>>().join(between)
            }
            Format::Junit => {
                let findings = self.documents.iter().map(|d| &d.findings);
                let checked = findings.map(|f| Checked { derivation: f.derivation(), account: f.account() });
                report::junit(&checked.collect::<Vec<_>>(), &self.others)
            }
            Format::Sarif => report::sarif(&self.findings),
            Format::Github => report::github(&self.findings),
        }
    }
}
