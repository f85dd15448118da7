//! What is found of a text that an editor has open.

use std::collections::HashMap;
use std::ops::Range;
use std::panic::AssertUnwindSafe;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use rederive::diag::escape::in_one_line;
use rederive::diag::{Diagnostic, Source};
use rederive::lint;
use rederive::report;
use rederive::{Failure, Findings, Session, paper};

/// What is said of a place beside findings.
pub(super) struct Remark {
    pub span: Range<usize>,
    /// A word or two.
    pub word: String,
    /// More, in Markdown.
    pub more: String,
}

/// A name that the text declares.
pub(super) struct Declared {
    pub name: String,
    pub span: Range<usize>,
    /// What it is, in a line.
    pub says: String,
}

/// A text and what was found of it.
pub(super) struct Looked {
    pub source: Arc<Source>,
    pub findings: Vec<report::Finding>,
    pub remarks: Vec<Remark>,
    pub declared: Vec<Declared>,
}

/// Looks texts through; what is known of a derivation file is not looked for again.
#[derive(Default)]
pub(super) struct Looker {
    sessions: HashMap<String, Session>,
}

impl Looker {
    /// Looks a text through; `each` is told what was found, the problems before the verdicts.
    pub(super) fn look(&mut self, uri: &str, text: String, each: &mut dyn FnMut(Looked)) {
        let path = path_of(uri);
        let shown = path.as_deref().map_or_else(|| uri.to_owned(), |p| p.display().to_string());
        let source = Arc::new(Source { path: shown, text });
        let looked = std::panic::catch_unwind(AssertUnwindSafe(|| match uri.ends_with(".toml") {
            true => self.derivation(uri, &source, each),
            false => each(of_paper(&source, path.as_deref().and_then(Path::parent))),
        }));
        if looked.is_err() {
            self.sessions.remove(uri);
            let message = "this text shows a defect of rederive: please report it";
            each(with_problems(&source, &[Diagnostic::at(&source, "rederive::defect", 0..0, message)]));
        }
    }

    fn derivation(&mut self, uri: &str, source: &Arc<Source>, each: &mut dyn FnMut(Looked)) {
        let changed = match self.sessions.get_mut(uri) {
            Some(session) => session.change(source.text.clone()),
            None => Session::open(&source.path, source.text.clone())
                .map(|session| drop(self.sessions.insert(uri.to_owned(), session))),
        };
        let Some(session) = self.sessions.get_mut(uri).filter(|_| changed.is_ok()) else {
            return each(with_problems(source, &changed.err().unwrap_or_default()));
        };
        each(Looked { declared: declared(session), ..with_problems(source, &[]) });
        match session.check_again() {
            Ok((found, _)) => each(with_verdicts(source, session, &found)),
            Err(Failure::Problems(problems)) => each(with_problems(source, &problems)),
            Err(other) => {
                each(with_problems(source, &[Diagnostic::at(source, "rederive::stopped", 0..0, other.to_string())]))
            }
        }
    }
}

/// The path that an address of a file names.
fn path_of(uri: &str) -> Option<PathBuf> {
    let path = uri.strip_prefix("file://")?;
    let mut bytes = Vec::new();
    let mut rest = path.bytes();
    while let Some(b) = rest.next() {
        match b {
            b'%' => {
                let digits = [rest.next()?, rest.next()?];
                bytes.push(u8::from_str_radix(std::str::from_utf8(&digits).ok()?, 16).ok()?);
            }
            b => bytes.push(b),
        }
    }
    String::from_utf8(bytes).ok().map(PathBuf::from)
}

fn with_problems(source: &Arc<Source>, problems: &[Diagnostic]) -> Looked {
    let findings = report::problems(problems);
    Looked { source: Arc::clone(source), findings, remarks: Vec::new(), declared: Vec::new() }
}

fn declared(session: &Session) -> Vec<Declared> {
    let of = |s: &rederive::derivation::SymbolEntry| {
        let unit = s.unit.as_ref().map(|u| format!(", in {u}")).unwrap_or_default();
        let formula = s.formula.as_ref().map(|f| format!(", {f}")).unwrap_or_default();
        let says = s.says.as_ref().map(|t| format!(": {t}")).unwrap_or_default();
        Declared { name: s.name.clone(), span: s.span.clone(), says: format!("{}{unit}{formula}{says}", s.role_word()) }
    };
    session.derivation().symbols.iter().map(of).collect()
}

fn with_verdicts(source: &Arc<Source>, session: &Session, found: &Findings) -> Looked {
    let all = found.all();
    let remark = |claim: &rederive::derivation::Claim| {
        let of = all.iter().filter(|f| f.claim.id == claim.id && f.claim.reading == claim.reading);
        let mut words: Vec<(&str, usize)> = Vec::new();
        for word in of.map(|f| f.outcome.word()) {
            match words.iter_mut().find(|(known, _)| *known == word) {
                Some((_, n)) => *n += 1,
                None => words.push((word, 1)),
            }
        }
        let said: Vec<String> = words.iter().map(|(word, n)| format!("{word} on {n}")).collect();
        let word = if said.is_empty() { "on no motion".to_owned() } else { said.join(", ") };
        let more = found.explanation(&claim.name(), &[], false).map(|text| fenced(&text)).unwrap_or_default();
        Remark { span: claim.span.clone(), word, more }
    };
    let derivation = session.derivation();
    Looked {
        source: Arc::clone(source),
        findings: report::findings(found.derivation(), found.account()),
        remarks: derivation.claims.iter().map(remark).collect(),
        declared: declared(session),
    }
}

/// A text as it is, in Markdown.
fn fenced(text: &str) -> String {
    format!("~~~~~~text\n{}\n~~~~~~\n", text.trim_end().replace("~~~~~~", "~~~~~"))
}

fn of_paper(source: &Arc<Source>, folder: Option<&Path>) -> Looked {
    let paper = match paper::parse_in(Arc::clone(source), folder) {
        Ok(paper) => paper,
        Err(problem) => return with_problems(source, &[*problem]),
    };
    let found = lint::lint(&paper);
    // Other files have places of their own.
    let mut findings = report::lint_findings(&paper, &found);
    findings.retain(|f| Arc::ptr_eq(&f.place.source, source));
    let mut remarks = Vec::new();
    for judgement in &found.judgements {
        let (file, span) = paper.locate(&judgement.span);
        if !Arc::ptr_eq(file, source) {
            continue;
        }
        let mut more = format!("**{}** {}", judgement.word.text(), in_one_line(&lint::explained(&paper, judgement)));
        if let Some(problem) = lint::diagnostic(&paper, judgement) {
            more.extend(report::problems(&[problem]).iter().map(|f| format!("\n\n{}", fenced(&f.message))));
        }
        remarks.push(Remark { span, word: judgement.word.text().to_owned(), more });
    }
    for note in &paper.notes {
        let (_, span) = paper.locate(&note.span);
        findings.extend(report::problems(&[Diagnostic::at(source, "paper::note", span, note.message.clone())]));
    }
    Looked { source: Arc::clone(source), findings, remarks, declared: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rederive::report::Level;

    fn looked(uri: &str, text: &str) -> Vec<Looked> {
        let mut all = Vec::new();
        Looker::default().look(uri, text.to_owned(), &mut |one| all.push(one));
        all
    }

    #[test]
    fn a_wrong_step_of_a_paper_has_the_right_one_beside_it() {
        let text = "\\[(a+b)^2=a^2-2ab+b^2\\] and \\[x^2-y^2=(x-y)(x+y)\\]";
        let [of] = &looked("file:///a%20b.tex", text)[..] else { panic!("once") };
        assert_eq!(of.source.path, "/a b.tex");
        let [wrong] = &of.findings[..] else { panic!("{:?}", of.findings) };
        assert_eq!((wrong.rule, wrong.level), ("lint::wrong", Level::Error));
        let words: Vec<&str> = of.remarks.iter().map(|r| r.word.as_str()).collect();
        assert_eq!(words, ["wrong", "follows"]);
    }

    #[test]
    fn problems_of_a_derivation_file_come_before_its_verdicts() {
        let uri = "file:///spring.toml";
        let broken = &looked(uri, "[derivation]\ntitle = 1")[..];
        assert!(matches!(broken, [one] if !one.findings.is_empty()));
        let text = "[derivation]\ntitle = 'A'\nconcerns = 'B'\n[symbols]\n'a' = { role = 'parameter' }\n[[claim]]\nid = 'one'\nsays = 'c'\nalways = ['a=a']\n";
        let [first, second] = &looked(uri, text)[..] else { panic!("twice") };
        assert_eq!((first.findings.len(), first.declared.len(), second.declared.len()), (0, 1, 1));
        assert_eq!(second.remarks.len(), 1);
    }
}
