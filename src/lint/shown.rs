//! What was found, for a terminal: a line for each printed relation, and what is wrong with its place in the source.

use std::fmt::Write;

use diag::Diagnostic;
use diag::escape::in_one_line;
use paper::Paper;

use super::{Judgement, Lint, LintStep, LintWitness, Word, line};

/// The most characters of a formula in the list.
const WIDTH: usize = 78;

/// Why a judgement is as it is, in one line; may be empty.
pub fn explained(paper: &Paper, judgement: &Judgement) -> String {
    let mut out = in_one_line(&judgement.why);
    if !judgement.with.is_empty() {
        let own = paper.locate(&judgement.span).0;
        let (mut lines, mut others): (Vec<usize>, Vec<String>) = (Vec::new(), Vec::new());
        for relation in judgement.with.iter().filter_map(|r| paper.printed.get(*r)) {
            let (line, file) = (paper.line(&relation.span()), paper.locate(&relation.span()).0);
            match std::sync::Arc::ptr_eq(own, file) {
                true => lines.push(line),
                false => others.push(format!("{}:{line}", in_one_line(&file.path))),
            }
        }
        lines.sort_unstable();
        lines.dedup();
        let many: Vec<String> = lines.iter().map(usize::to_string).collect();
        let word = if many.len() == 1 { "line" } else { "lines" };
        let here = (!many.is_empty()).then(|| format!("{word} {}", many.join(", ")));
        let all: Vec<String> = here.into_iter().chain(others).collect();
        if !out.is_empty() {
            out.push_str("; ");
        }
        let _ = write!(out, "with {}", all.join(", "));
    }
    out
}

/// What is wrong, as a diagnostic with its place; `None` for every other word.
pub fn diagnostic(paper: &Paper, judgement: &Judgement) -> Option<Diagnostic> {
    if judgement.word != Word::Wrong {
        return None;
    }
    let (source, span) = paper.locate(&judgement.span);
    let mut message = "this step is wrong".to_owned();
    if let Some(witness) = &judgement.witness {
        message = format!("this step is wrong: {}", at_a_point(witness));
    }
    let mut found = Diagnostic::at(source, "lint::wrong", span, message);
    if let Some(instead) = &judgement.instead {
        found = found.hint(format!("this holds, and is proved: {}", in_one_line(instead)));
    }
    Some(found)
}

/// "for a = 2, b = 1 its sides are 3 and 5".
pub fn at_a_point(witness: &LintWitness) -> String {
    let values: Vec<String> = witness.values.iter().take(8).map(|(n, v)| format!("{} = {v}", in_one_line(n))).collect();
    let sides = format!("its sides are {} and {}", decimal(witness.left), decimal(witness.right));
    if values.is_empty() { sides } else { format!("for {} {sides}", values.join(", ")) }
}

/// A number in at most six digits behind the point.
pub fn decimal(x: f64) -> String {
    let text = format!("{x:.6}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short.is_empty() || short == "-" { "0".to_owned() } else { short.to_owned() }
}

/// The list of all relations, then what is wrong.
pub fn lint_text(paper: &Paper, lint: &Lint) -> String {
    let mut out = nothing_tested(lint).map(|text| text + "\n\n").unwrap_or_default();
    let several = paper.printed.iter().any(|r| !std::sync::Arc::ptr_eq(paper.locate(&r.span()).0, &paper.file));
    for judgement in &lint.judgements {
        if !is_listed(paper, judgement) {
            continue;
        }
        let relation = &paper.printed[judgement.relation];
        let text = in_one_line(&relation.text());
        let short: String = text.chars().take(WIDTH).collect();
        let more = if text.chars().count() > WIDTH { "…" } else { "" };
        let why = explained(paper, judgement);
        let why = if why.is_empty() { String::new() } else { format!(" ({why})") };
        let file = match several {
            true => format!("{}:", in_one_line(&paper.locate(&judgement.span).0.path)),
            false => String::new(),
        };
        let place = format!("{file}{}", line(paper, judgement));
        let _ = writeln!(out, "{place:>6}  {:<16} {short}{more}{why}", judgement.word.text());
        if is_parted(judgement) {
            judgement.chain.iter().for_each(|step| step_text(&mut out, paper, judgement, step));
        }
    }
    for note in &paper.notes {
        let place = paper.line(&note.span);
        let _ = writeln!(out, "{place:>6}  {:<16} {}", "note", in_one_line(&note.message));
    }
    for found in lint.judgements.iter().filter_map(|j| diagnostic(paper, j)) {
        let _ = write!(out, "\n{found}\n");
    }
    let _ = writeln!(out, "\n{}", summary(lint));
    if let Some(unlisted) = unlisted(paper, lint) {
        let _ = writeln!(out, "{unlisted}: --format json has all");
    }
    out
}

/// Whether a formula is listed: one of the running text is where something is said of it.
pub fn is_listed(paper: &Paper, judgement: &Judgement) -> bool {
    let in_text = paper.printed.get(judgement.relation).is_some_and(|r| r.display.is_none());
    !(in_text && matches!(judgement.word, Word::NotRead | Word::Condition | Word::NotFollowed))
}

/// How many formulas are counted and not listed, in a sentence without its stop; `None` where all are listed.
pub fn unlisted(paper: &Paper, lint: &Lint) -> Option<String> {
    let n = lint.judgements.iter().filter(|j| !is_listed(paper, j)).count();
    let (formulas, verb) = if n == 1 { ("formula", "is") } else { ("formulas", "are") };
    (n > 0).then(|| format!("{n} {formulas} of the running text, which nothing above decides, {verb} not listed"))
}

/// Whether something is known of a formula, or of one of its steps.
fn is_tested(of: &Judgement) -> bool {
    of.steps.0 > 0
        || match of.word {
            Word::Follows | Word::Numbers | Word::Wrong | Word::Differs => true,
            Word::Defines | Word::Condition | Word::Approximates | Word::NotFollowed | Word::NotRead => false,
        }
}

/// How many formulas were tested, and what the words for the others mean; `None` where none was.
pub fn tested(lint: &Lint) -> Option<String> {
    let n = lint.judgements.iter().filter(|j| is_tested(j)).count();
    let verb = if n == 1 { "was" } else { "were" };
    let mut out = format!("{n} of {} {verb} tested, at least in part.", lint.judgements.len());
    if lint.count(Word::Defines) + lint.count(Word::Condition) + lint.count(Word::Approximates) > 0 {
        out.push_str(
            " What defines a name, is a condition, or approximates says what is meant: there is nothing to test.",
        );
    }
    if lint.count(Word::NotFollowed) + lint.count(Word::NotRead) > 0 {
        out.push_str(" What is not followed, or not read, may be right or wrong.");
    }
    (n > 0).then_some(out)
}

/// That nothing was tested, where that is so: a reader must not take silence for approval.
pub fn nothing_tested(lint: &Lint) -> Option<String> {
    if lint.judgements.iter().any(is_tested) {
        return None;
    }
    Some(match lint.judgements.len() {
        0 => "Nothing was tested: no formula was found.".to_owned(),
        1 => "Nothing was tested: of the one formula it is not said whether it is right.".to_owned(),
        n => format!("Nothing was tested: of none of the {n} formulas is it said whether it is right."),
    })
}

/// Whether the steps of a relation have different words, of which one is a proof, and its own word does not tell that.
fn is_parted(judgement: &Judgement) -> bool {
    let has = |word: Word| judgement.chain.iter().any(|step| step.word == word);
    judgement.chain.len() > 1
        && (has(Word::Follows) || has(Word::Numbers))
        && matches!(judgement.word, Word::Wrong | Word::NotFollowed | Word::NotRead)
}

/// A line for a step of a chain: its later side, at its own line.
fn step_text(out: &mut String, paper: &Paper, judgement: &Judgement, step: &LintStep) {
    let relation = &paper.printed[judgement.relation];
    let Some(k) = relation.sides.iter().position(|side| side.span == step.span).filter(|k| *k > 0) else { return };
    let text = in_one_line(&format!("{} {}", relation.signs[k - 1], relation.sides[k].text));
    let short: String = text.chars().take(WIDTH).collect();
    let more = if text.chars().count() > WIDTH { "…" } else { "" };
    let _ = writeln!(out, "{:>6}    {:<14} {short}{more}", paper.line(&step.span), step.word.text());
}

/// "31 relations: 1 wrong, 12 follow, …". Where nothing was tested, that nothing is wrong is not said.
pub fn summary(lint: &Lint) -> String {
    let is_tested = nothing_tested(lint).is_none();
    let counts: Vec<String> = Word::ALL
        .iter()
        .map(|w| (w, lint.count(*w)))
        .filter(|(w, n)| *n > 0 || **w == Word::Wrong && is_tested)
        .map(|(w, n)| format!("{n} {}", w.text()))
        .collect();
    let noun = if lint.judgements.len() == 1 { "relation" } else { "relations" };
    let counted = if counts.is_empty() { String::new() } else { format!(": {}", counts.join(", ")) };
    format!("{} {noun}{counted}", lint.judgements.len())
}
