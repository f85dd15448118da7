//! What a derivation file says against what the paper prints.

use std::ops::Range;
use std::sync::Arc;

use super::mark::{Mark, marks, parts};
use super::token::tokens;
use super::{Equation, Paper, Part};
use derivation::{Derivation, Form, SymbolEntry};
use diag::Source;

/// A formula that is not what the paper prints under its label.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The claim or system that has the formula: `id`, `id/reading`, `system.id`.
    pub owner: String,
    /// The label that it names.
    pub label: String,
    /// The formula as the derivation file has it.
    pub formula: String,
    /// What the paper prints, where it is most like the formula.
    pub printed: String,
    /// What differs, in the derivation file.
    pub here: Range<usize>,
    /// What differs, in the paper.
    pub there: Range<usize>,
    /// Whether the two have enough in common for `here` and `there` to be the slip, and not all of both.
    pub is_near: bool,
}

/// A label that the paper does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownLabel {
    /// The claim or system that names it.
    pub owner: String,
    /// The label.
    pub label: String,
    /// Its owner's place in the derivation file.
    pub span: Range<usize>,
    /// A label of the paper that may be meant.
    pub near: Option<String>,
}

/// How an equation of the paper is covered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coverage {
    /// Its label.
    pub label: Option<String>,
    /// What it prints, in one line.
    pub text: String,
    /// Its place in the paper.
    pub span: Range<usize>,
    /// How many parts it has.
    pub parts: usize,
    /// How many of them the derivation file has as printed.
    pub printed: usize,
    /// Claims and systems that have a part of it as printed, or that name its label.
    pub by: Vec<String>,
}

impl Coverage {
    /// Whether anything in the derivation file is about it: it has it as printed, or names its label.
    pub fn is_covered(&self) -> bool {
        !self.by.is_empty()
    }
}

/// A relation of the running text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Relation {
    /// What it prints.
    pub text: String,
    /// Its place in the paper.
    pub span: Range<usize>,
    /// Whether the derivation file has it word for word.
    pub is_found: bool,
}

/// A derivation file beside a paper.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// The paper's file.
    pub paper: Arc<Source>,
    /// SHA-256 of its bytes.
    pub sha256: String,
    /// How many formulas were compared.
    pub compared: usize,
    /// Those that differ.
    pub differences: Vec<Difference>,
    /// Labels that the paper does not have.
    pub unknown: Vec<UnknownLabel>,
    /// The displayed equations of the paper.
    pub equations: Vec<Coverage>,
    /// The relations of its running text.
    pub relations: Vec<Relation>,
}

impl Comparison {
    /// How many displayed equations are covered, and how many parts of them are in the file as printed.
    pub fn covered(&self) -> (usize, usize) {
        let covered = self.equations.iter().filter(|e| e.is_covered()).count();
        (covered, self.equations.iter().map(|e| e.printed).sum())
    }

    /// How many parts the displayed equations have.
    pub fn parts(&self) -> usize {
        self.equations.iter().map(|e| e.parts).sum()
    }

    /// How many relations of the running text the file has word for word.
    pub fn found(&self) -> usize {
        self.relations.iter().filter(|r| r.is_found).count()
    }
}

/// A formula of the derivation file.
struct Formula<'d> {
    owner: String,
    label: Option<&'d str>,
    /// Whether the owner says it; otherwise it is assumed, or a definition.
    said: bool,
    text: String,
    span: Range<usize>,
    /// Its parts, spans from the beginning of the file.
    parts: Vec<Vec<Mark>>,
}

impl<'d> Formula<'d> {
    fn new(owner: &str, label: Option<&'d str>, text: &str, span: Range<usize>) -> Formula<'d> {
        let moved = |m: Mark| Mark { span: m.span.start + span.start..m.span.end + span.start, ..m };
        let parts = parts(&tokens(text)).iter().map(|p| marks(p).into_iter().map(moved).collect()).collect();
        Formula { owner: owner.to_owned(), label, said: true, text: text.to_owned(), span, parts }
    }

    fn unsaid(self) -> Formula<'d> {
        Formula { said: false, ..self }
    }

    fn words(&self) -> Vec<&str> {
        words(self.parts.iter().flatten())
    }
}

fn words<'m>(marks: impl Iterator<Item = &'m Mark>) -> Vec<&'m str> {
    // A break of a line inside a part is no sign.
    marks.map(|m| m.text.as_str()).filter(|t| *t != "\\").collect()
}

/// Compares a derivation file with the paper.
///
/// A formula is compared if its claim or system has a `label` and does not say `printed = false`. It must be one part of the
/// equation, or several that follow each other; parts end at commas and at breaks of lines.
pub fn compare(derivation: &Derivation, paper: &Paper) -> Comparison {
    let mut out = Comparison {
        paper: Arc::clone(&paper.file),
        sha256: paper.sha256.clone(),
        compared: 0,
        differences: Vec::new(),
        unknown: Vec::new(),
        equations: Vec::new(),
        relations: Vec::new(),
    };
    let formulas = formulas(derivation);
    let mut covered: Vec<Vec<bool>> = paper.equations.iter().map(|e| vec![false; e.parts.len()]).collect();
    let mut by: Vec<Vec<String>> = vec![Vec::new(); paper.equations.len()];
    for (owner, label, span) in labels(derivation) {
        match paper.equations.iter().position(|e| e.label.as_deref() == Some(label)) {
            Some(at) if by[at].contains(&owner) => {}
            Some(at) => by[at].push(owner),
            None => out.unknown.push(UnknownLabel {
                owner,
                label: label.to_owned(),
                span,
                near: diag::nearest(label, paper.equations.iter().filter_map(|e| e.label.as_deref()))
                    .map(str::to_owned),
            }),
        }
    }
    for formula in formulas.iter().filter(|f| f.said) {
        let words = formula.words();
        for (at, equation) in paper.equations.iter().enumerate() {
            let named = formula.label.is_some() && formula.label == equation.label.as_deref();
            // Under another label, only a whole relation that is the same to the last sign is about this equation.
            let whole = || words_of_whole(equation, &words);
            let run = run_of(equation, &words).or_else(whole).filter(|_| named || formula.label.is_none());
            if let Some(run) = &run {
                covered[at][run.clone()].fill(true);
                if !by[at].contains(&formula.owner) {
                    by[at].push(formula.owner.clone());
                }
            }
            if named {
                out.compared += 1;
                if run.is_none() {
                    out.differences.extend(difference(formula, equation));
                }
            }
        }
    }
    for ((equation, covered), by) in paper.equations.iter().zip(covered).zip(by) {
        out.equations.push(Coverage {
            label: equation.label.clone(),
            text: equation.parts.iter().map(|p| one_line(&p.text)).collect::<Vec<_>>().join(", "),
            span: equation.span.clone(),
            parts: equation.parts.len(),
            printed: covered.iter().filter(|c| **c).count(),
            by,
        });
    }
    let all: Vec<Vec<&str>> = formulas.iter().flat_map(|f| f.parts.iter().map(|p| words(p.iter()))).collect();
    out.relations.extend(paper.relations.iter().map(|r| {
        let parts = parts(&tokens(&r.text));
        let is_found = parts.iter().all(|p| {
            let marks = marks(p);
            let words = words(marks.iter());
            all.contains(&words)
        });
        Relation { text: one_line(&r.text), span: r.span.clone(), is_found }
    }));
    out
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The labels that are named: by whom, and where.
fn labels(derivation: &Derivation) -> Vec<(String, &str, Range<usize>)> {
    let systems = derivation.systems.iter().map(|s| (format!("system.{}", s.id), s.label.as_deref(), s.span.clone()));
    let claims = derivation.claims.iter().map(|c| (c.name(), c.label.as_deref(), c.span.clone()));
    systems.chain(claims).filter_map(|(owner, label, span)| Some((owner, label?, span))).collect()
}

/// The derivation that a paper is compared with: the only one, or the only one that names labels.
///
/// # Errors
/// None names a label, or several do; in a sentence.
pub fn subject<'d>(derivations: impl Iterator<Item = &'d Derivation>) -> Result<&'d Derivation, String> {
    let derivations: Vec<&Derivation> = derivations.collect();
    let labels =
        |d: &&Derivation| d.claims.iter().any(|c| c.label.is_some()) || d.systems.iter().any(|s| s.label.is_some());
    let named: Vec<&Derivation> = derivations.iter().copied().filter(labels).collect();
    match (derivations.as_slice(), named.as_slice()) {
        ([one], _) | (_, [one]) => Ok(one),
        (_, []) => Err("no derivation file names a label, so that none can be compared with a paper".to_owned()),
        (_, many) => {
            let names: Vec<&str> = many.iter().map(|d| d.id.as_str()).collect();
            Err(format!("`--source` is the paper of one derivation file, but {} name labels", names.join(", ")))
        }
    }
}

/// Every formula of the file that could be in the paper.
fn formulas(derivation: &Derivation) -> Vec<Formula<'_>> {
    let mut out = Vec::new();
    for system in &derivation.systems {
        let owner = format!("system.{}", system.id);
        let label = system.label.as_deref();
        out.extend(system.equations.iter().map(|w| Formula::new(&owner, label, &w.text, w.span.clone())));
    }
    for claim in &derivation.claims {
        let owner = claim.name();
        let label = claim.label.as_deref().filter(|_| claim.printed);
        let said = claim.forms.iter().flat_map(Form::written);
        out.extend(said.map(|(text, span)| Formula::new(&owner, label, text, span)));
        // What a claim assumes may be printed somewhere, but not under its label.
        out.extend(claim.assuming.iter().map(|w| Formula::new(&owner, None, &w.text, w.span.clone()).unsaid()));
        out.extend(claim.symbols.iter().filter_map(definition));
    }
    out.extend(derivation.symbols.iter().filter_map(definition));
    out
}

/// The definition of a symbol as a paper would print it.
fn definition(symbol: &SymbolEntry) -> Option<Formula<'_>> {
    let text = format!("{}={}", symbol.name, symbol.formula.as_ref()?);
    Some(Formula::new(&symbol.name, None, &text, symbol.span.clone()).unsaid())
}

/// The most parts of an equation of which runs are tried.
const MOST_PARTS: usize = 200;

/// Every run of parts that follow each other.
fn runs(equation: &Equation) -> impl Iterator<Item = (Range<usize>, &[Part])> {
    let n = equation.parts.len().min(MOST_PARTS);
    (0..n).flat_map(move |a| (a + 1..=n).map(move |b| (a..b, &equation.parts[a..b])))
}

/// The parts of an equation that together are these words.
fn run_of(equation: &Equation, wanted: &[&str]) -> Option<Range<usize>> {
    runs(equation).find(|(_, parts)| words(parts.iter().flat_map(|p| &p.marks)) == wanted).map(|(run, _)| run)
}

/// The first part of an equation, where these words are the first side of its chain and what the part says of it.
fn words_of_whole(equation: &Equation, wanted: &[&str]) -> Option<Range<usize>> {
    (!equation.whole.is_empty() && words(equation.whole.iter()) == wanted).then_some(0..1)
}

/// The longest formula, in signs, of which the distance to another is computed.
const LONGEST: usize = 2000;

/// The run of parts that is most like a formula, and where the two differ.
fn difference(formula: &Formula<'_>, equation: &Equation) -> Option<Difference> {
    let here: Vec<&Mark> = formula.parts.iter().flatten().filter(|m| m.text != "\\").collect();
    let best = runs(equation)
        .filter(|(run, _)| run.len() <= formula.parts.len().max(1) + 1)
        .map(|(_, parts)| {
            let there: Vec<&Mark> = parts.iter().flat_map(|p| &p.marks).filter(|m| m.text != "\\").collect();
            (distance(&here, &there), there, parts)
        })
        .min_by_key(|(d, ..)| *d)?;
    let (d, there, parts) = best;
    let same = |(a, b): &(&&Mark, &&Mark)| a.text == b.text;
    let before = here.iter().zip(&there).take_while(same).count();
    let after = here[before..].iter().rev().zip(there[before..].iter().rev()).take_while(same).count();
    let place = |marks: &[&Mark], whole: Range<usize>| {
        let differing = marks.get(before..marks.len() - after).unwrap_or_default();
        match (differing.iter().map(|m| m.span.start).min(), differing.iter().map(|m| m.span.end).max()) {
            (Some(start), Some(end)) if start < end => start..end,
            // Nothing of this side differs: the sign after it is where the other has more.
            _ => marks.get(before).or(marks.last()).map_or(whole, |m| m.span.clone()),
        }
    };
    let start = parts.iter().map(|p| p.span.start).min().unwrap_or(0);
    let whole = start..parts.iter().map(|p| p.span.end).max().unwrap_or(start);
    let is_near = d * 2 <= here.len().max(there.len());
    let printed = parts.iter().map(|p| one_line(&p.text)).collect::<Vec<_>>().join(", ");
    Some(Difference {
        owner: formula.owner.clone(),
        label: formula.label.unwrap_or_default().to_owned(),
        formula: one_line(&formula.text),
        printed,
        here: if is_near { place(&here, formula.span.clone()) } else { formula.span.clone() },
        there: if is_near { place(&there, whole) } else { whole },
        is_near,
    })
}

/// How many signs must be changed, added or taken away.
fn distance(a: &[&Mark], b: &[&Mark]) -> usize {
    if a.len().max(b.len()) > LONGEST {
        return a.iter().zip(b).filter(|(x, y)| x.text != y.text).count() + a.len().abs_diff(b.len());
    }
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let change = diagonal + usize::from(x.text != y.text);
            diagonal = row[j + 1];
            row[j + 1] = change.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}
