//! Findings: what a repository should be told about a run, each with its place.
//!
//! A finding is a verdict that is not as expected, a verdict that is open, a difference between the derivation file and the
//! paper, or a problem of a file. The formats for machines ([`sarif`](super::sarif), [`github`](super::github)) are drawn
//! from the same list, so they cannot tell different stories.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::{Arc, Weak};

use sha2::{Digest, Sha256};

use super::numbers::{ascii_both as both, ascii_six as time, ascii_size as size, count};
use super::tally::{Group, declared, groups, name, says};
use super::text::capital;
use derivation::{Derivation, Form};
use diag::escape::{in_one_line, shown};
use diag::{Diagnostic, Source};
use findings::{Account, ClaimAccount, FamilyAccount, PairAccount};

/// Most values of a point where there is little room.
const MOST_VALUES: usize = 6;

/// How serious a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Worth knowing; the exit code does not depend on it.
    Note,
    /// Something is open.
    Warning,
    /// Something is not as it should be.
    Error,
}

impl Level {
    /// `note`, `warning` or `error`.
    pub fn word(self) -> &'static str {
        match self {
            Level::Note => "note",
            Level::Warning => "warning",
            Level::Error => "error",
        }
    }
}

/// A place in a file; without a span the file as a whole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file.
    pub source: Arc<Source>,
    /// Byte range in its text.
    pub span: Option<Range<usize>>,
}

/// Where a place begins and ends: lines and columns from 1, columns in UTF-16 code units, the end exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// First line.
    pub line: usize,
    /// First column.
    pub column: usize,
    /// Last line.
    pub end_line: usize,
    /// The column after the last.
    pub end_column: usize,
}

impl Place {
    /// A place in a file.
    pub fn new(source: &Arc<Source>, span: Range<usize>) -> Place {
        Place { source: Arc::clone(source), span: Some(span) }
    }

    /// Lines and columns; `None` for a file as a whole. Spans that are not of the text are moved to the nearest that are.
    pub fn region(&self) -> Option<Region> {
        let span = self.span.as_ref()?;
        let text = &self.source.text;
        let boundary = |i: usize| {
            let mut i = i.min(text.len());
            while !text.is_char_boundary(i) {
                i -= 1;
            }
            i
        };
        let start = boundary(span.start);
        let end = boundary(span.end).max(start);
        let ((line, column), (end_line, end_column)) =
            Marks::with(&self.source, |m| (m.at(text, start), m.at(text, end)));
        Some(Region { line, column, end_line, end_column })
    }
}

/// Where lines begin in a text, with places between in long lines: a file may have as many findings as letters, and to count from its
/// beginning for each would take the square.
struct Marks {
    /// Bytes in order, each with its line and its column, both from 1.
    all: Vec<(usize, usize, usize)>,
}

/// The marks of texts that somebody still has: findings go from file to file.
#[derive(Default)]
struct Known {
    /// By the address of the text, which nobody else has as long as this is here.
    of: BTreeMap<usize, (Weak<Source>, Marks)>,
    /// With so many, those of texts that are gone are forgotten.
    most: usize,
}

thread_local! {
    static KNOWN: RefCell<Known> = RefCell::default();
}

impl Known {
    fn of(&mut self, source: &Arc<Source>) -> &Marks {
        let address = Arc::as_ptr(source).addr();
        if self.of.len() > self.most && !self.of.contains_key(&address) {
            self.of.retain(|_, (text, _)| text.strong_count() > 0);
            self.most = 2 * self.of.len();
        }
        &self.of.entry(address).or_insert_with(|| (Arc::downgrade(source), Marks::of(&source.text))).1
    }
}

impl Marks {
    /// Bytes between two marks in a long line.
    const APART: usize = 1 << 10;

    fn of(text: &str) -> Marks {
        let mut all = vec![(0, 1, 1)];
        let (mut line, mut column, mut last) = (1, 1, 0);
        for (at, c) in text.char_indices() {
            (line, column) = if c == '\n' { (line + 1, 1) } else { (line, column + c.len_utf16()) };
            let next = at + c.len_utf8();
            if c == '\n' || next >= last + Marks::APART {
                all.push((next, line, column));
                last = next;
            }
        }
        Marks { all }
    }

    fn with<R>(source: &Arc<Source>, ask: impl FnOnce(&Marks) -> R) -> R {
        KNOWN.with_borrow_mut(|known| ask(known.of(source)))
    }

    /// Line and column of a place between two letters.
    fn at(&self, text: &str, place: usize) -> (usize, usize) {
        let before = self.all.partition_point(|(at, ..)| *at <= place).saturating_sub(1);
        let (at, line, column) = self.all.get(before).copied().unwrap_or((0, 1, 1));
        (line, column + text.get(at..place).unwrap_or_default().encode_utf16().count())
    }
}

/// Something that a repository should be told.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The kind of problem, `room::kind`: stable, see `docs/stability.md`.
    pub rule: &'static str,
    /// How serious it is.
    pub level: Level,
    /// What it is, in sentences.
    pub message: String,
    /// Where.
    pub place: Place,
    /// Other places that it has to do with, each with a few words.
    pub related: Vec<(Place, String)>,
    /// What it is about, without lines and numbers: two runs have the same finding if this is the same.
    pub identity: String,
    /// What is right there, where that is known.
    pub fix: Option<Fix>,
}

/// A text that is right, and the place where it belongs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What it replaces.
    pub place: Place,
    /// The text, as it is written in that file.
    pub text: String,
    /// How it is known, in a sentence without its end.
    pub says: String,
}

/// The nearest right formula in the place of the printed one; `None` where the file writes that in other characters.
fn fix(derivation: &Derivation, claim: &ClaimAccount) -> Option<Fix> {
    let found = super::card::correction(claim)?;
    let forms = declared(derivation, claim)?.forms.iter().flat_map(Form::written);
    let is_it = |(text, span): &(&str, Range<usize>)| {
        *text == found.printed && derivation.file.text.get(span.clone()) == Some(*text)
    };
    let (_, span) = forms.filter(|_| !found.formula.contains(['\'', '\n'])).find(is_it)?;
    let says = format!("This is {}", super::discrimination::standing(found).replace("**", ""));
    Some(Fix { place: Place::new(&derivation.file, span), text: found.formula.clone(), says })
}

impl Finding {
    /// A digest of what it is about, which stays the same when lines move and numbers change: 32 hexadecimal digits.
    pub fn fingerprint(&self) -> String {
        let digest = Sha256::digest(format!("{}\n{}", self.rule, self.identity).as_bytes());
        digest.iter().take(16).map(|b| format!("{b:02x}")).collect()
    }
}

/// The findings of the verdicts on one derivation file, in the order of its claims.
pub fn findings(derivation: &Derivation, account: &Account) -> Vec<Finding> {
    let mut out = Vec::new();
    for claim in &account.claims {
        let of_claim = groups(claim);
        out.extend(of_claim.iter().filter_map(|group| verdict(derivation, claim, group)));
        out.extend(claim.families.iter().filter_map(|of| family(derivation, claim, of)));
        out.extend(region(derivation, claim));
        out.extend(alone(derivation, claim));
        out.extend(drawn(derivation, claim));
    }
    let summary = account.summary();
    if summary.holds + summary.fails == 0 {
        out.push(Finding {
            rule: "verdict::nothing-decided",
            level: Level::Warning,
            message: match derivation.trajectories.is_empty() && account.claims.iter().any(|c| c.region.is_none()) {
                true => {
                    "No claim was decided: the file has no motion. Add a [[trajectory]], or give the claims `ranges`."
                        .to_owned()
                }
                false => "No claim was decided: a run that checks nothing is no success.".to_owned(),
            },
            place: Place { source: Arc::clone(&derivation.file), span: None },
            related: Vec::new(),
            identity: derivation.id.clone(),
            fix: None,
        });
    }
    out
}

/// The finding of a claim that holds on every motion of the file and fails on one that was drawn: no verdict is other than expected, so
/// that it is a note.
fn drawn(derivation: &Derivation, claim: &ClaimAccount) -> Option<Finding> {
    claim.drawn.as_ref()?.found.as_ref()?;
    let told = super::drawn::plain(derivation, claim)?.replace('$', "");
    Some(Finding {
        rule: "verdict::drawn",
        level: Level::Note,
        message: format!(
            "`{}` holds on every motion of the file, and fails on another. It says: {} {told} {}",
            name(claim),
            sentence(&says(derivation, claim)),
            super::drawn::ADVICE,
        ),
        place: Place::new(&derivation.file, place_of_claim(derivation, claim)),
        related: Vec::new(),
        identity: format!("{}\n{}", derivation.id, name(claim)),
        fix: None,
    })
}

/// The rule of a verdict that is not as expected, or open.
fn rule(word: &str) -> &'static str {
    match word {
        "holds" => "verdict::holds",
        "fails" => "verdict::fails",
        "not-applicable" => "verdict::not-applicable",
        _ => "verdict::undecided",
    }
}

fn verdict(derivation: &Derivation, claim: &ClaimAccount, group: &Group<'_>) -> Option<Finding> {
    let open = group.word == "undecided" && group.expected.is_none();
    if !group.unexpected && !open {
        return None;
    }
    let pair = group.telling()?;
    let expected = match group.expected {
        Some(word) => format!(", expected is `{word}`"),
        None => String::new(),
    };
    let names: Vec<&str> = group.pairs.iter().map(|p| p.trajectory.as_str()).collect();
    let mut message = format!(
        "`{}` {} on {} of {} ({}){expected}. It says: {}",
        name(claim),
        phrase(group.word),
        names.len(),
        count(claim.results.len(), "trajectory"),
        names.join(", "),
        sentence(&says(derivation, claim)),
    );
    if let Some(told) = told(pair) {
        message.push(' ');
        message.push_str(&told);
    }
    if let Some(text) = super::card::instead(claim).filter(|_| group.word == "fails") {
        message.push(' ');
        message.push_str(&text);
    }
    Some(Finding {
        rule: rule(group.word),
        level: if group.unexpected { Level::Error } else { Level::Warning },
        message,
        place: Place::new(&derivation.file, place_of(derivation, claim, pair)),
        related: Vec::new(),
        identity: format!("{}\n{}\n{}", derivation.id, name(claim), group.expected.unwrap_or("nothing")),
        fix: fix(derivation, claim).filter(|_| group.word == "fails"),
    })
}

/// The finding of a claim on a family, if there is one.
fn family(derivation: &Derivation, claim: &ClaimAccount, of: &FamilyAccount) -> Option<Finding> {
    let word = of.verdict.outcome().word();
    let open = word == "undecided" && of.expected.is_none();
    if !of.is_unexpected() && !open {
        return None;
    }
    let expected = of.expected.map(|word| format!(", expected is `{word}`")).unwrap_or_default();
    let message = format!(
        "`{}` {} on the family {}{expected}. It says: {} {}",
        name(claim),
        phrase(word),
        of.family,
        sentence(&says(derivation, claim)),
        on_family(of),
    );
    Some(Finding {
        rule: rule(word),
        level: if of.is_unexpected() { Level::Error } else { Level::Warning },
        message,
        place: Place::new(&derivation.file, place_of_claim(derivation, claim)),
        related: Vec::new(),
        identity: format!("{}\n{}\n{}\n{}", derivation.id, name(claim), of.family, of.expected.unwrap_or("nothing")),
        fix: None,
    })
}

/// How the verdict on a family came about, in sentences.
pub(super) fn on_family(of: &FamilyAccount) -> String {
    let mut out = super::family::sentence(&super::family::counts(of));
    if let Some(shown) = super::family::shown(of).first() {
        out.push_str(&format!(" {}", super::family::sentence(&shown.named().replace('$', ""))));
    }
    out
}

/// The only formula of a claim, or its id.
fn place_of_claim(derivation: &Derivation, claim: &ClaimAccount) -> Range<usize> {
    declared(derivation, claim).map_or(0..0, |d| match d.forms.iter().flat_map(Form::written).collect::<Vec<_>>()[..] {
        [(_, ref span)] => span.clone(),
        _ => d.span.clone(),
    })
}

/// The finding of a claim over ranges, if there is one.
fn region(derivation: &Derivation, claim: &ClaimAccount) -> Option<Finding> {
    let judged = claim.verdicts().find(|j| j.trajectory.is_none() && j.family.is_none())?;
    let word = judged.verdict.outcome().word();
    let open = word == "undecided" && judged.expected.is_none();
    if !judged.unexpected && !open {
        return None;
    }
    let expected = judged.expected.map(|word| format!(", expected is `{word}`")).unwrap_or_default();
    let mut message = format!(
        "`{}` {} over its ranges{expected}. It says: {}",
        name(claim),
        phrase(word),
        sentence(&says(derivation, claim)),
    );
    if let Some(told) = over_ranges(claim) {
        message.push_str(&format!(" {told}"));
    }
    let place = place_of_claim(derivation, claim);
    Some(Finding {
        rule: rule(word),
        level: if judged.unexpected { Level::Error } else { Level::Warning },
        message,
        place: Place::new(&derivation.file, place),
        related: Vec::new(),
        identity: format!("{}\n{}\n{}", derivation.id, name(claim), judged.expected.unwrap_or("nothing")),
        fix: None,
    })
}

/// The finding of a claim that is tried on nothing, if its step is not as expected.
pub(super) fn alone(derivation: &Derivation, claim: &ClaimAccount) -> Option<Finding> {
    let word = claim.verdict_alone().filter(|_| claim.is_unexpected_alone())?;
    let expected = claim.alone.and_then(|alone| alone.expected);
    let told = expected.map(|word| format!(", expected is `{word}`")).unwrap_or_default();
    Some(Finding {
        rule: rule(word),
        level: Level::Error,
        message: format!(
            "`{}` {} for all values{told}. It says: {}{}",
            name(claim),
            phrase(word),
            sentence(&says(derivation, claim)),
            of_step(claim).map(|told| format!(" {told}")).unwrap_or_default(),
        ),
        place: Place::new(&derivation.file, place_of_claim(derivation, claim)),
        related: Vec::new(),
        identity: format!("{}\n{}\n{}", derivation.id, name(claim), expected.unwrap_or("nothing")),
        fix: fix(derivation, claim).filter(|_| word == "fails"),
    })
}

/// How the verdict of a step came about, in a sentence.
pub(super) fn of_step(claim: &ClaimAccount) -> Option<String> {
    let step = claim.identity.as_ref()?;
    Some(match &step.witness {
        Some(point) => format!("{REFUTES}{}", sentence(&point.to_string())),
        None => sentence(&step.decided().to_string()).replace('$', ""),
    })
}

/// The same with its formulas between dollars, and with few values of a point.
pub(super) fn of_step_brief(claim: &ClaimAccount) -> Option<String> {
    let step = claim.identity.as_ref()?;
    Some(match &step.witness {
        Some(point) => format!("{REFUTES}{}", sentence(&point.marked_within(MOST_VALUES))),
        None => sentence(&step.decided().to_string()),
    })
}

/// What stands before a point that refutes a step.
const REFUTES: &str = "A point refutes it: ";

/// How the verdict over ranges, or for all fields, came about, in a sentence.
pub(super) fn over_ranges(claim: &ClaimAccount) -> Option<String> {
    let region = claim.region.as_ref()?;
    let says = sentence(&region.verdict.evidence().reason.as_ref()?.to_string()).replace('$', "");
    Some(if region.is_of_fields() { capital(&says) } else { format!("Over its ranges: {says}") })
}

/// The same beside the word for the verdict, which says that it is over ranges; with its formulas between dollars, and with few values of a
/// point.
pub(super) fn over_ranges_brief(claim: &ClaimAccount) -> Option<String> {
    let reason = claim.region.as_ref()?.verdict.evidence().reason.as_ref()?;
    Some(capital(&sentence(&reason.brief(MOST_VALUES))))
}

/// `fails`, `does not apply`.
pub(super) fn phrase(word: &str) -> &str {
    match word {
        "not-applicable" => "does not apply",
        "undecided" => "is undecided",
        other => other,
    }
}

/// A text that ends like a sentence.
fn sentence(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if text.ends_with(['.', '!', '?']) { text } else { format!("{text}.") }
}

/// The witness or the reason of a verdict, in a sentence.
pub(super) fn told(pair: &PairAccount) -> Option<String> {
    let evidence = pair.verdict.evidence();
    if let Some(w) = &evidence.witness {
        let formula = w.formula.split_whitespace().collect::<Vec<_>>().join(" ");
        let (left, right) = both(w.left, w.right);
        return Some(format!(
            "On {} at t = {}: {formula} has the left side {left}, the right side {right}, error bound {}.",
            pair.trajectory,
            time(w.t),
            size(w.bound),
        ));
    }
    evidence.reason.as_ref().map(|r| format!("On {}: {}", pair.trajectory, sentence(&r.to_string())))
}

/// Where a verdict belongs: the formula of the witness, the only formula, or the id of the claim.
fn place_of(derivation: &Derivation, claim: &ClaimAccount, pair: &PairAccount) -> Range<usize> {
    let Some(declared) = declared(derivation, claim) else { return 0..0 };
    let written: Vec<(&str, Range<usize>)> = declared.forms.iter().flat_map(Form::written).collect();
    let shown = pair.verdict.evidence().witness.as_ref().map(|w| w.formula.trim());
    let named = written.iter().find(|(text, _)| shown == Some(*text));
    match (named, written.as_slice()) {
        (Some((_, span)), _) => span.clone(),
        (None, [(_, span)]) => span.clone(),
        _ => declared.span.clone(),
    }
}

/// Problems of files as findings.
pub fn problems(diagnostics: &[Diagnostic]) -> Vec<Finding> {
    diagnostics.iter().map(problem).collect()
}

fn problem(diagnostic: &Diagnostic) -> Finding {
    let place = |span: Option<&Range<usize>>| Place { source: Arc::clone(&diagnostic.source), span: span.cloned() };
    let mut message = sentence(&shown(&diagnostic.message));
    if let Some(hint) = &diagnostic.hint {
        message.push_str(" Hint: ");
        message.push_str(&sentence(&shown(hint)));
    }
    let other = diagnostic.other.iter().map(|l| (place(Some(&l.span)), in_one_line(&l.text)));
    Finding {
        rule: diagnostic.code,
        level: Level::Error,
        place: place(diagnostic.place.as_ref().map(|l| &l.span)),
        related: other.collect(),
        identity: format!("{}\n{}", diagnostic.source.path, diagnostic.message),
        message,
        fix: declaration(diagnostic),
    }
}

/// The declaration of a symbol that a derivation file lacks.
fn declaration(of: &Diagnostic) -> Option<Fix> {
    const TABLE: &str = "[symbols]\n";
    let span = of.place.as_ref().filter(|_| of.code == "latex::unknown-symbol")?.span.clone();
    let name = of.source.text.get(span).filter(|name| !name.contains(['\'', '\n']))?;
    let at = of.source.text.find(TABLE)? + TABLE.len();
    let text = format!("'{name}' = {{ role = 'parameter' }}\n");
    Some(Fix { place: Place::new(&of.source, at..at), text, says: "Declare it as a parameter".to_owned() })
}

/// What a rule is about, in a sentence.
pub fn rule_says(rule: &str) -> &'static str {
    match rule {
        "verdict::fails" => "A claim fails, and the file does not expect it to.",
        "verdict::holds" => "A claim holds, and the file expects another verdict.",
        "verdict::not-applicable" => "A claim does not apply, and the file expects another verdict.",
        "verdict::undecided" => "The evidence does not settle a claim, and the file does not expect that.",
        "verdict::nothing-decided" => "No claim of a file was decided.",
        "verdict::drawn" => "A claim holds on every motion of the file, and fails on one that was drawn at random.",
        "paper::differs" => "A formula is not what the paper prints under its label.",
        "paper::unknown-label" => "The paper has no equation with this label.",
        "paper::not-covered" => "No claim covers an equation of the paper.",
        "lint::wrong" => "A step of the paper is wrong: a point refutes it, and one slip away it is proved.",
        "lint::differs" => "A name is defined again, one slip away from before.",
        "lint::not-followed" => "Nothing that stands above a step decides it.",
        "lint::not-read" => "A formula of the paper is not read.",
        "paper::unreadable" => "The paper's source cannot be read.",
        rule if rule.starts_with("latex::") => "A formula cannot be read, or has no single meaning.",
        rule if rule.starts_with("derivation::") => "The derivation file is not as its format wants it.",
        _ => "A derivation file cannot be checked.",
    }
}

#[cfg(all(test, debug_assertions))]
mod tests {
    use super::*;
    use crate::tests::derivation;
    use findings::sample::account;

    #[test]
    fn what_is_not_as_expected_and_what_is_open_is_found_and_nothing_else() {
        let found = findings(&derivation(), &account());
        let rules: Vec<(&str, Level)> = found.iter().map(|f| (f.rule, f.level)).collect();
        let unexpected = account().claims.iter().flat_map(|c| &c.results).filter(|p| p.is_unexpected()).count();
        assert!(unexpected > 0 && !found.is_empty(), "{rules:?}");
        for claim in &account().claims {
            for pair in &claim.results {
                let word = pair.verdict.outcome().word();
                let told = pair.is_unexpected() || word == "undecided" && pair.expected.is_none();
                let here = found.iter().any(|f| {
                    f.rule == rule(word)
                        && f.message.starts_with(&format!("`{}` ", name(claim)))
                        && f.message.contains(&pair.trajectory)
                });
                assert!(here || !told, "{} on {}", claim.id, pair.trajectory);
            }
        }
    }

    #[test]
    fn regions_count_utf16_units_and_survive_any_span() {
        let source = Arc::new(Source { path: "x".into(), text: "a\n𝒳é = b\n".into() });
        let region = Place::new(&source, 6..9).region().expect("a region");
        assert_eq!((region.line, region.column, region.end_line, region.end_column), (2, 3, 2, 5));
        for start in 0..20 {
            for end in 0..20 {
                let region = Place::new(&source, start..end).region().expect("a region");
                assert!((region.line, region.column) <= (region.end_line, region.end_column));
            }
        }
    }

    #[test]
    fn a_fingerprint_does_not_depend_on_lines_or_numbers() {
        let (d, a) = (derivation(), account());
        let mut moved = findings(&d, &a);
        for finding in &mut moved {
            finding.message.push('!');
            finding.place.span = Some(1..2);
        }
        let prints = |f: &[Finding]| f.iter().map(Finding::fingerprint).collect::<Vec<_>>();
        assert_eq!(prints(&findings(&d, &a)), prints(&moved));
        let mut all = prints(&moved);
        all.sort();
        all.dedup();
        assert_eq!(all.len(), moved.len(), "each has its own");
    }
}
