//! What was found of a paper, as JSON: one document for the command line, for agents and for Python.
//!
//! **In:** a paper, and what was found of it. **Out:** one object for each relation, in the order of the paper. **Guaranteed:** a verdict
//! has its strength in its name, since programs read names first; `instead` is said of nothing that is not proved.

use lint::{Judgement, Lint, Word};
use paper::Paper;
use serde_json::{Map, Value, json};

/// The document of a paper: how often each word is said, what was noted while reading, and each relation with its place.
pub fn lint_document(paper: &Paper, found: &Lint) -> Value {
    let counts: Map<String, Value> = Word::ALL.iter().map(|w| (w.text().to_owned(), found.count(*w).into())).collect();
    let notes: Vec<Value> =
        paper.notes.iter().map(|n| json!({ "line": paper.line(&n.span), "message": n.message })).collect();
    let relations: Vec<Value> = found.judgements.iter().filter_map(|j| relation(paper, j)).collect();
    json!({ "paper": paper.file.path, "words": counts, "notes": notes, "relations": relations })
}

/// The document of a paper that could not be read: why, and nothing else.
pub fn unread_document(path: &str, why: &str) -> Value {
    json!({ "paper": path, "unreadable": why, "words": {}, "notes": [], "relations": [] })
}

fn relation(paper: &Paper, j: &Judgement) -> Option<Value> {
    let relation = paper.printed.get(j.relation)?;
    let (line, column) = paper.line_and_column(&j.span);
    let witness = j.witness.as_ref().map(|w| {
        let values: Map<String, Value> = w.values.iter().map(|(n, v)| (n.clone(), v.clone().into())).collect();
        json!({ "values": values, "left": w.left, "right": w.right })
    });
    let lines: Vec<usize> =
        j.with.iter().filter_map(|r| paper.printed.get(*r)).map(|r| paper.line(&r.span())).collect();
    let place =
        |r: &paper::PrintedRelation| json!({ "file": paper.locate(&r.span()).0.path, "line": paper.line(&r.span()) });
    let places: Vec<Value> = j.with.iter().filter_map(|r| paper.printed.get(*r)).map(place).collect();
    let step = |step: &lint::LintStep| {
        let (line, column) = paper.line_and_column(&step.span);
        json!({ "line": line, "column": column, "word": step.word.text(), "verdict": verdict(step.word) })
    };
    let chain: Vec<Value> = j.chain.iter().map(step).collect();
    Some(json!({
        "word": j.word.text(),
        "verdict": verdict(j.word),
        "file": paper.locate(&j.span).0.path,
        "line": line,
        "column": column,
        "formula": relation.text(),
        "label": relation.label,
        "inline": relation.display.is_none(),
        "why": j.why,
        "message": lint::diagnostic(paper, j).map(|d| d.message),
        "instead": j.instead,
        "witness": witness,
        "with_lines": lines,
        "with_places": places,
        "steps": j.steps.1,
        "steps_proved": j.steps.0,
        "chain": chain,
    }))
}

/// A word with its strength in its name.
fn verdict(word: Word) -> String {
    match word {
        Word::Follows => "follows_proved".to_owned(),
        Word::Wrong => "wrong_refuted_by_a_point".to_owned(),
        word => word.text().replace(' ', "_"),
    }
}
