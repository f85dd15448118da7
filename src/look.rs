//! What is known of a text at its places: what an editor shows.
//!
//! **In:** the text of a paper or of a derivation file, again whenever it has changed. **Out:** [`Looked`]: findings, a word for each formula
//! or claim, the names that the text declares. **Guaranteed:** problems of a text come before its verdicts; a defect ends the look at one
//! text, and one that is not wanted any more is ended from another thread. **Why this way:** places are bytes of the text, so that every editor counts them as it likes.

use std::collections::HashMap;
use std::ops::Range;
use std::panic::AssertUnwindSafe;
use std::path::Path;
use std::sync::Arc;

use crate::check::{Cancel, ClaimAccount, Limits};
use crate::config::Config;
use crate::derivation::{Claim, Form, SymbolEntry};
use crate::diag::escape::in_one_line;
use crate::diag::{Diagnostic, Source};
use crate::{Failure, Findings, Session, lint, paper, report};

/// Longest command that is looked for before a letter, in bytes.
const LONGEST_COMMAND: usize = 64;

/// What is said of a place beside findings.
pub struct Remark {
    /// Its bytes.
    pub span: Range<usize>,
    /// A word or two.
    pub word: String,
    /// More, in Markdown.
    pub more: String,
}

/// A name that the text declares.
pub struct Declared {
    /// As it is declared.
    pub name: String,
    /// Where it is declared.
    pub span: Range<usize>,
    /// What it is, in a line.
    pub says: String,
}

/// A text and what was found of it.
pub struct Looked {
    /// The text.
    pub source: Arc<Source>,
    /// What its writer should be told.
    pub findings: Vec<report::Finding>,
    /// What is said of its formulas, or of its claims.
    pub remarks: Vec<Remark>,
    /// The names that it declares; a paper declares none.
    pub declared: Vec<Declared>,
    /// Changes that may be meant: the bytes that they are about, and what could stand there.
    pub offers: Vec<(Range<usize>, report::Fix)>,
}

impl Looked {
    /// What could be put right, or be said, of some bytes.
    pub fn fixes(&self, of: &Range<usize>) -> Vec<&report::Fix> {
        let touches = |span: &Range<usize>| span.start <= of.end && of.start <= span.end;
        let is_here = |place: &report::Place| place.span.as_ref().is_some_and(touches);
        let found = self.findings.iter().filter_map(|f| Some((&f.place, f.fix.as_ref()?)));
        let found = found.filter(|(place, fix)| is_here(place) || is_here(&fix.place)).map(|(_, fix)| fix);
        found.chain(self.offers.iter().filter(|(span, _)| touches(span)).map(|(_, fix)| fix)).collect()
    }

    /// What stands at a byte, and what was found of it, in Markdown.
    pub fn said_at(&self, at: usize) -> Option<String> {
        let in_code = |text: &str| in_one_line(text).replace('`', "'");
        let named =
            self.declared_at(at).map(|d| format!("`{}`: {}", in_code(&d.name), report::prose(&in_one_line(&d.says))));
        let parts: Vec<String> = named.into_iter().chain(self.remark_at(at).map(|r| r.more.clone())).collect();
        (!parts.is_empty()).then(|| parts.join("\n\n"))
    }

    /// The declaration of the name at a byte.
    pub fn declared_at(&self, at: usize) -> Option<&Declared> {
        let longest = self.declared.iter().map(|d| d.name.len()).max()?;
        let (near, at) = near(&self.source.text, at, longest);
        self.declared.iter().filter(|d| is_named(near, at, &d.name)).max_by_key(|d| d.name.len())
    }

    /// The smallest remark around a byte, or else the last one before it in the same table of a derivation file.
    fn remark_at(&self, at: usize) -> Option<&Remark> {
        let around = self.remarks.iter().filter(|r| r.span.start <= at && at <= r.span.end);
        let before = || {
            let last = self.remarks.iter().filter(|r| r.span.end <= at).max_by_key(|r| r.span.end)?;
            let between = self.source.text.get(last.span.end..at)?;
            (!self.declared.is_empty() && !between.contains("\n[")).then_some(last)
        };
        around.min_by_key(|r| r.span.len()).or_else(before)
    }
}

/// Looks texts through; what is known of a derivation file is not looked for again.
#[derive(Default)]
pub struct Looker {
    sessions: HashMap<String, Session>,
}

impl Looker {
    /// Looks through the text that a file has, or would have; `each` is told what was found, the problems before the verdicts. A file whose
    /// name ends with `.toml` is a derivation file, another is a paper. Once `cancel` is raised, nothing more is told, and the look ends.
    pub fn look(&mut self, path: &Path, text: String, cancel: &Cancel, each: &mut dyn FnMut(Looked)) {
        let name = path.display().to_string();
        let text = if name.ends_with(".toml") { text } else { paper::with_plain_ends(text) };
        let source = Arc::new(Source { path: name.clone(), text });
        let limits = Limits { cancel: Some(cancel.clone()), ..Limits::default() };
        let each = &mut |looked| {
            if !cancel.is_raised() {
                each(looked);
            }
        };
        let looked = std::panic::catch_unwind(AssertUnwindSafe(|| match name.ends_with(".toml") {
            true => self.derivation(&source, cancel, each),
            // What has no folder, such as a text without a file, includes no files.
            false => {
                each(of_paper(&source, path.parent().filter(|folder| !folder.as_os_str().is_empty()), &limits));
            }
        }));
        if looked.is_err() {
            self.sessions.remove(&name);
            let message = "this text shows a defect of rederive: please report it";
            each(with_problems(&source, &[Diagnostic::at(&source, "rederive::defect", 0..0, message)]));
        }
    }

    /// Gives back what is kept of a text that is looked through no more.
    pub fn forget(&mut self, path: &Path) {
        self.sessions.remove(&path.display().to_string());
    }

    fn derivation(&mut self, source: &Arc<Source>, cancel: &Cancel, each: &mut dyn FnMut(Looked)) {
        let changed = match self.sessions.get_mut(&source.path) {
            Some(session) => session.change(source.text.clone()),
            None => Session::open(&source.path, source.text.clone())
                .map(|session| drop(self.sessions.insert(source.path.clone(), session))),
        };
        let Some(session) = self.sessions.get_mut(&source.path).filter(|_| changed.is_ok()) else {
            return each(with_problems(source, &changed.err().unwrap_or_default()));
        };
        each(Looked { declared: declared(session), ..with_problems(source, &[]) });
        match session.check_again_until(cancel) {
            Ok((found, _)) => each(with_verdicts(source, session, &found)),
            Err(Failure::Problems(problems)) => each(with_problems(source, &problems)),
            Err(other) => {
                each(with_problems(source, &[Diagnostic::at(source, "rederive::stopped", 0..0, other.to_string())]))
            }
        }
    }
}

fn with_problems(source: &Arc<Source>, problems: &[Diagnostic]) -> Looked {
    let findings = report::problems(problems);
    Looked { source: Arc::clone(source), findings, remarks: Vec::new(), declared: Vec::new(), offers: Vec::new() }
}

fn declared(session: &Session) -> Vec<Declared> {
    let of = |s: &SymbolEntry| {
        let unit = s.unit.as_ref().map(|u| format!(", in {u}")).unwrap_or_default();
        let formula = s.formula.as_ref().map(|f| format!(", {f}")).unwrap_or_default();
        let says = s.says.as_ref().map(|t| format!(": {t}")).unwrap_or_default();
        Declared { name: s.name.clone(), span: s.span.clone(), says: format!("{}{unit}{formula}{says}", s.role_word()) }
    };
    session.derivation().symbols.iter().map(of).collect()
}

fn with_verdicts(source: &Arc<Source>, session: &Session, found: &Findings) -> Looked {
    let all = found.all();
    let remark = |claim: &Claim| {
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
        let more = found.explanation(&claim.name(), &[], false).map(|text| as_it_is(&text)).unwrap_or_default();
        Remark { span: claim.span.clone(), word, more }
    };
    let derivation = session.derivation();
    Looked {
        source: Arc::clone(source),
        findings: report::findings(found.derivation(), found.account()),
        remarks: derivation.claims.iter().map(remark).collect(),
        declared: declared(session),
        offers: offers(found),
    }
}

/// The assumptions that claims could make, each over the table of its claim.
fn offers(found: &Findings) -> Vec<(Range<usize>, report::Fix)> {
    let derivation = found.derivation();
    let of = |account: &ClaimAccount| {
        let claim = derivation.claims.iter().find(|c| c.id == account.id && c.reading == account.reading);
        let forms = claim.into_iter().flat_map(|c| c.forms.iter().flat_map(Form::written)).map(|(_, span)| span.end);
        let span = claim.map_or(0..0, |c| c.span.start..forms.max().unwrap_or(c.span.end).max(c.span.end));
        report::assumptions(derivation, account).into_iter().map(move |fix| (span.clone(), fix)).collect::<Vec<_>>()
    };
    found.account().claims.iter().flat_map(of).collect()
}

/// A text as it is, in Markdown.
fn as_it_is(text: &str) -> String {
    report::fenced("text", text.trim_end())
}

fn of_paper(source: &Arc<Source>, folder: Option<&Path>, limits: &Limits) -> Looked {
    let mut paper = match paper::parse_in(Arc::clone(source), folder) {
        Ok(paper) => paper,
        Err(problem) => return with_problems(source, &[*problem]),
    };
    // What `\log` is, `rederive.toml` says, as on the command line.
    let configured = folder.and_then(|f| std::path::absolute(f).ok()).map(|f| Config::of(&f));
    match configured.unwrap_or_else(|| Ok(Config::default())) {
        Ok(config) => paper.logarithm = config.log,
        Err(why) => {
            let message = format!("the configuration is not read: {}", in_one_line(&why.to_string()));
            paper.notes.push(paper::PaperNote { message, span: 0..0 });
        }
    }
    let found = lint::lint(&paper, limits);
    // Other files have places of their own.
    let mut findings = report::lint_findings(&paper, &found);
    findings.retain(|f| Arc::ptr_eq(&f.place.source, source));
    let mut remarks = Vec::new();
    for judgement in &found.judgements {
        let (file, span) = paper.locate(&judgement.span);
        if !Arc::ptr_eq(file, source) {
            continue;
        }
        let mut more = format!(
            "**{}** {}",
            judgement.word.text(),
            report::prose(&in_one_line(&lint::explained(&paper, judgement)))
        );
        if let Some(problem) = lint::diagnostic(&paper, judgement) {
            more.extend(report::problems(&[problem]).iter().map(|f| format!("\n\n{}", as_it_is(&f.message))));
        }
        remarks.push(Remark { span, word: judgement.word.text().to_owned(), more });
    }
    for note in &paper.notes {
        let (_, span) = paper.locate(&note.span);
        findings.extend(report::problems(&[Diagnostic::at(source, "paper::note", span, note.message.clone())]));
    }
    Looked { source: Arc::clone(source), findings, remarks, declared: Vec::new(), offers: Vec::new() }
}

/// Whether a name stands in a text around a byte, and is not a part of a command.
fn is_named(of_line: &str, at: usize, name: &str) -> bool {
    let letters = |c: char| c.is_ascii_alphabetic();
    let whole = |start: usize| {
        let (before, after) = (&of_line[..start], &of_line[start + name.len()..]);
        // A letter that follows letters after a backslash is one of a command; a command ends where no letter follows.
        let in_command = name.starts_with(letters) && before.trim_end_matches(letters).ends_with('\\');
        let goes_on = name.starts_with('\\') && name.ends_with(letters) && after.starts_with(letters);
        !in_command && !goes_on
    };
    of_line.match_indices(name).any(|(start, _)| (start..=start + name.len()).contains(&at) && whole(start))
}

/// The part of its line that may belong to a name at a place, where the longest has so many bytes, and the place within it: a line may be a whole file.
fn near(text: &str, at: usize, longest: usize) -> (&str, usize) {
    let boundary = |mut i: usize| {
        while !text.is_char_boundary(i) {
            i -= 1;
        }
        i
    };
    let at = boundary(at.min(text.len()));
    // The command that a letter may be one of begins before it.
    let from = boundary(at.saturating_sub(longest + LONGEST_COMMAND));
    let to = boundary(text.len().min(at + longest + 4));
    let from = text[from..at].rfind('\n').map_or(from, |n| from + n + 1);
    let to = text[at..to].find('\n').map_or(to, |n| at + n);
    (&text[from..to], at - from)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Level;

    fn looked(path: &str, text: &str) -> Vec<Looked> {
        let mut all = Vec::new();
        Looker::default().look(Path::new(path), text.to_owned(), &Cancel::default(), &mut |one| all.push(one));
        all
    }

    #[test]
    fn a_wrong_step_of_a_paper_has_the_right_one_beside_it() {
        let text = "\\[(a+b)^2=a^2-2ab+b^2\\] and \\[x^2-y^2=(x-y)(x+y)\\]";
        let [of] = &looked("/a b.tex", text)[..] else { panic!("once") };
        assert_eq!(of.source.path, "/a b.tex");
        let [wrong] = &of.findings[..] else { panic!("{:?}", of.findings) };
        assert_eq!((wrong.rule, wrong.level), ("lint::wrong", Level::Error));
        let words: Vec<&str> = of.remarks.iter().map(|r| r.word.as_str()).collect();
        assert_eq!(words, ["wrong", "follows"]);
    }

    #[test]
    fn problems_of_a_derivation_file_come_before_its_verdicts() {
        let path = "/spring.toml";
        let broken = &looked(path, "[derivation]\ntitle = 1")[..];
        assert!(matches!(broken, [one] if !one.findings.is_empty()));
        let text = "[derivation]\ntitle = 'A'\nconcerns = 'B'\n[symbols]\n'a' = { role = 'parameter' }\n[[claim]]\nid = 'one'\nsays = 'c'\nalways = ['a=a']\n";
        let [first, second] = &looked(path, text)[..] else { panic!("twice") };
        assert_eq!((first.findings.len(), first.declared.len(), second.declared.len()), (0, 1, 1));
        assert_eq!(second.remarks.len(), 1);
    }

    #[test]
    fn what_is_closed_is_not_kept() {
        let mut looker = Looker::default();
        let text = "[derivation]\ntitle = 'A'\nconcerns = 'B'\n[symbols]\n'a' = { role = 'parameter' }\n[[claim]]\nid = 'one'\nsays = 'c'\nalways = ['a=a']\n";
        let (one, other) = (Path::new("/one.toml"), Path::new("/other.toml"));
        for path in [one, other] {
            looker.look(path, text.to_owned(), &Cancel::default(), &mut |_| {});
        }
        assert_eq!(looker.sessions.len(), 2);
        looker.forget(one);
        assert_eq!(looker.sessions.len(), 1);
        looker.look(one, text.to_owned(), &Cancel::default(), &mut |of| assert!(of.findings.is_empty()));
        assert_eq!(looker.sessions.len(), 2);
    }

    #[test]
    fn what_a_file_says_is_no_markup_where_it_is_shown() {
        let hostile = r"[l](command:x) ![p](y) <img src=z> ~~~~~~~ ``````` *b*";
        let text = format!(
            "[derivation]\ntitle = 'A'\nconcerns = 'B'\n[symbols]\n'a' = {{ role = 'parameter', says = '{hostile}' }}\n[[claim]]\nid = \
             'one'\nsays = \"\"\"{hostile}\n~~~~~~~\n```````\n<img src=x>\"\"\"\nalways = ['a=a']\n"
        );
        let of = looked("/a.toml", &text).pop().expect("it is looked at");
        let symbol = of.said_at(text.find("'a'").expect("the symbol") + 1).expect("it is declared");
        assert!(symbol.starts_with("`a`: parameter: "), "{symbol}");
        for markup in ["[l](", "![p](", "<img", " ~~~~~~~", " ```", " *b"] {
            assert!(!symbol.contains(markup), "{markup}: {symbol}");
        }
        let claim = of.said_at(text.find("id = 'one'").expect("the claim") + 6).expect("it is told");
        let fence: String = claim.chars().take_while(|c| *c == '`').collect();
        let inside = claim.trim_end().strip_suffix(&fence).and_then(|c| c.strip_prefix(&fence)).expect("a fence");
        assert!(fence.len() > 2 && !inside.contains(&fence) && inside.contains("[l](command:x)"), "{claim}");
    }

    #[test]
    fn a_name_is_no_part_of_a_command() {
        let text = r"a=\omega_{12}o\sin x^2";
        let named: Vec<&str> =
            [r"\omega_{12}", r"\omega", "o", "x", r"\si", "n"].into_iter().filter(|n| is_named(text, 4, n)).collect();
        assert_eq!(named, [r"\omega_{12}", r"\omega"]);
        assert!(is_named(text, 14, "o") && is_named(text, 19, "x") && !is_named(text, 17, "n"));
        assert!(!is_named(text, 16, r"\si") && !is_named("", 0, "x"));
    }

    #[test]
    fn what_a_proof_uses_can_be_assumed() {
        let head = "[derivation]\ntitle = 'A'\nconcerns = 'B'\n[symbols]\n'a' = { role = 'parameter' }\n'b' = { role = 'parameter' }\n";
        let claim =
            |more: &str| format!("{head}[[claim]]\nid = 'one'\n{more}says = 'c'\nalways = ['\\frac{{ab}}{{a}}=b']\n");
        for (before, after) in
            [("", "assuming = ['a\\ne0']\n"), ("assuming = ['b>0']\n", "assuming = ['b>0', 'a\\ne0']\n")]
        {
            let text = claim(before);
            let of = looked("/a.toml", &text).pop().expect("it is looked at");
            let at = text.find("always").expect("the claim");
            let [fix] = of.fixes(&(at..at))[..] else { panic!("{:?}", of.offers) };
            let place = fix.place.span.clone().expect("a place");
            let mut put = text.clone();
            put.replace_range(place, &fix.text);
            assert_eq!(put, claim(after));
            let again = looked("/b.toml", &put).pop().expect("it is looked at");
            assert!(again.fixes(&(at..at)).is_empty(), "{:?}", again.offers);
        }
    }
}
