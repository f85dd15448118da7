//! The findings of a lint: what a repository, or an editor, is told of a paper.
//!
//! **In:** a paper, and what was found of it. **Out:** [`Finding`]s, each with its place in the file that it stands in. **Guaranteed:** what is
//! wrong is an error, and nothing else is.

use lint::{Judgement, Lint, Word};
use paper::Paper;

use super::finding::{Finding, Fix, Level, Place};

/// What is wrong as an error, everything else that a reader may want to look at as a note.
pub fn lint_findings(paper: &Paper, found: &Lint) -> Vec<Finding> {
    found.judgements.iter().filter_map(|j| finding(paper, j)).collect()
}

fn finding(paper: &Paper, judgement: &Judgement) -> Option<Finding> {
    let relation = paper.printed.get(judgement.relation)?;
    let (rule, level) = match judgement.word {
        Word::Wrong => ("lint::wrong", Level::Error),
        Word::Differs => ("lint::differs", Level::Note),
        Word::NotFollowed if relation.display.is_some() => ("lint::not-followed", Level::Note),
        Word::NotRead if relation.display.is_some() => ("lint::not-read", Level::Note),
        _ => return None,
    };
    let (source, span) = paper.locate(&judgement.span);
    let message = match lint::diagnostic(paper, judgement) {
        Some(d) => format!("{}{}", d.message, d.hint.map(|h| format!("; {h}")).unwrap_or_default()),
        None => format!("{}: {}", judgement.word.text(), lint::explained(paper, judgement)),
    };
    let identity = format!("{}\n{}", source.path, relation.text());
    let place = Place::new(source, span);
    let says = "This holds, and is proved".to_owned();
    let fix = judgement.instead.clone().map(|text| Fix { place: place.clone(), text, says });
    Some(Finding { rule, level, message, place, related: Vec::new(), identity, fix })
}
