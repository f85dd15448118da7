//! `rederive lint`.

use std::path::PathBuf;

use clap::ArgAction;
use rederive::lint::{self, Judgement, Lint, Word};
use rederive::paper::{self, Paper};
use rederive::report::{Finding, Level, Place, github, sarif};
use rederive::{Ending, Failure, Format, files};

use super::arguments::printed_as;
use super::ending::{Stop, print, say};

pub const AFTER_HELP: &str = r"Every relation that the paper prints gets one word:
  follows        proved, from what stands before it or outright
  holds in numbers  not proved, and true at random points
  wrong          a point refutes it, and with one sign, factor, exponent or name
                 altered it is proved
  defines        says what a name stands for
  condition      says what holds, or when
  approximates   about equal, proportional, of this order
  not followed   read, and nothing above decides it
  not read       with the name of what is not understood

`rederive PAPER.TEX` is short for it. Exit codes:
  0   nothing is wrong
  1   something is
  2   the file could not be read
  70  a defect of rederive itself";

#[derive(clap::Args)]
pub struct LintArguments {
    /// The LaTeX source of a paper, or a Markdown file with formulas between dollars
    #[arg(value_name = "PAPER.TEX")]
    paper: PathBuf,
    /// What is printed
    #[arg(long, action = ArgAction::Set, value_parser = printed_as(&[Format::Text, Format::Json, Format::Sarif, Format::Github]), default_value = "text")]
    format: Format,
}

pub fn lint(arguments: &LintArguments) -> Result<Ending, Stop> {
    let path = files::named(&arguments.paper)?;
    let paper = paper::read(&path).map_err(Failure::from)?;
    let found = lint::lint(&paper);
    match arguments.format {
        Format::Json => print(&json(&paper, &found))?,
        Format::Sarif => print(&sarif(&findings(&paper, &found)))?,
        Format::Github => print(&github(&findings(&paper, &found)))?,
        _ => say(&lint::lint_text(&paper, &found))?,
    }
    Ok(if found.count(Word::Wrong) > 0 { Ending::Different } else { Ending::Good })
}

/// Whether a command line names a paper where a command is expected.
pub fn is_paper(word: &std::ffi::OsStr) -> bool {
    let path = std::path::Path::new(word);
    path.extension().is_some_and(|e| e == "tex" || e == "md") && !word.to_string_lossy().starts_with('-')
}

/// What is wrong as an error, everything else that a reader may want to look at as a note.
fn findings(paper: &Paper, found: &Lint) -> Vec<Finding> {
    found.judgements.iter().filter_map(|j| finding(paper, j)).collect()
}

fn finding(paper: &Paper, judgement: &Judgement) -> Option<Finding> {
    let relation = paper.printed.get(judgement.relation)?;
    let (rule, level) = match judgement.word {
        Word::Wrong => ("lint::wrong", Level::Error),
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
    Some(Finding { rule, level, message, place: Place::new(source, span), related: Vec::new(), identity })
}

/// One object for each relation, in the order of the paper.
fn json(paper: &Paper, found: &Lint) -> String {
    let one = |j: &Judgement| {
        let relation = &paper.printed[j.relation];
        let (line, column) = paper.line_and_column(&j.span);
        let witness = j.witness.as_ref().map(|w| {
            let values: serde_json::Map<String, serde_json::Value> =
                w.values.iter().map(|(n, v)| (n.clone(), v.clone().into())).collect();
            serde_json::json!({ "values": values, "left": w.left, "right": w.right })
        });
        let lines: Vec<usize> =
            j.with.iter().filter_map(|r| paper.printed.get(*r)).map(|r| paper.line(&r.span())).collect();
        serde_json::json!({
            "word": j.word.text(),
            "file": paper.locate(&j.span).0.path,
            "line": line,
            "column": column,
            "formula": relation.text(),
            "label": relation.label,
            "inline": relation.display.is_none(),
            "why": j.why,
            "instead": j.instead,
            "witness": witness,
            "with_lines": lines,
            "steps": j.steps.1,
            "steps_proved": j.steps.0,
        })
    };
    let counts: serde_json::Map<String, serde_json::Value> =
        Word::ALL.iter().map(|w| (w.text().to_owned(), found.count(*w).into())).collect();
    let notes: Vec<serde_json::Value> =
        paper.notes.iter().map(|n| serde_json::json!({ "line": paper.line(&n.span), "message": n.message })).collect();
    let relations: Vec<serde_json::Value> = found.judgements.iter().map(one).collect();
    let document =
        serde_json::json!({ "paper": paper.file.path, "words": counts, "notes": notes, "relations": relations });
    let text = serde_json::to_string_pretty(&document).unwrap_or_default();
    rederive::diag::escape::in_json(&text) + "\n"
}
