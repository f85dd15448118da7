//! `rederive lint`.

use std::collections::BTreeSet;
use std::io::Read;
use std::path::PathBuf;

use clap::ArgAction;
use rederive::config::Config;
use rederive::diag::Source;
use rederive::diag::escape::in_one_line;
use rederive::lint::{self, Lint, Word};
use rederive::paper::{self, Paper};
use rederive::report::{self, github, lint_findings, sarif};
use rederive::{Ending, Failure, Format, files};

use super::arguments::{LimitArguments, LogarithmArgument, printed_as};
use super::ending::{Stop, as_json, print, say, say_problems};

/// The most papers of a folder that are named.
const MOST_NAMED: usize = 8;

pub const AFTER_HELP: &str = r"Every relation that the paper prints gets one word:
  follows        proved, from what stands before it or outright
  holds in numbers  not proved, and true at random points
  wrong          a point refutes it, and with one sign, factor, exponent or name
                 altered it is proved
  differs        a name that was defined before is defined again, one slip away
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
    /// The LaTeX source of a paper, a Markdown file with formulas between dollars, or a notebook (`.ipynb`); `-` is standard
    /// input. Without one, the `sources` of `rederive.toml`
    #[arg(value_name = "PAPER.TEX")]
    papers: Vec<PathBuf>,
    /// Write a page with every formula, the wrong ones beside the right ones
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Look through it again whenever it is saved
    #[arg(long, conflicts_with = "html")]
    watch: bool,
    /// With --watch, stop after so many times
    #[arg(long, value_name = "N", requires = "watch")]
    checks: Option<usize>,
    /// What is printed
    #[arg(long, action = ArgAction::Set, value_parser = printed_as(&[Format::Text, Format::Json, Format::Sarif, Format::Github]), default_value = "text")]
    format: Format,
    /// Write what is printed to this file; with a --format other than text
    #[arg(long, value_name = "FILE", requires = "format", conflicts_with = "watch")]
    output: Option<PathBuf>,
    #[command(flatten)]
    log: LogarithmArgument,
    #[command(flatten)]
    limits: LimitArguments,
}

pub fn lint(arguments: &LintArguments) -> Result<Ending, Stop> {
    let mut papers = match arguments.papers.as_slice() {
        [] => Config::find()?.sources,
        named => named.to_vec(),
    };
    // A paper that is named again is looked through once.
    let mut seen = BTreeSet::new();
    papers.retain(|paper| seen.insert(paper.clone()));
    if papers.is_empty() {
        return Err("no paper is named, and no `rederive.toml` here or above has `sources = [\"paper.tex\"]`".into());
    }
    if arguments.watch {
        return watch(arguments, &papers);
    }
    if arguments.html.is_some() && papers.len() > 1 {
        return Err("--html writes the page of one paper: name one".into());
    }
    once(arguments, &papers)
}

/// Looks through papers, and says what was found.
fn once(arguments: &LintArguments, papers: &[PathBuf]) -> Result<Ending, Stop> {
    let limits = arguments.limits.begun();
    let logarithm = arguments.log.or_configured()?;
    let mut all = Vec::new();
    for path in papers {
        let mut paper = match read(path) {
            Ok(paper) => paper,
            Err(stop) if arguments.format == Format::Json => {
                // A program is told where it looks.
                let unread = report::unread_document(&path.to_string_lossy(), &said(&*stop));
                put(arguments, papers, &json(&all, Some(unread))?)?;
                return Err(stop);
            }
            Err(stop) => return Err(stop),
        };
        paper.logarithm = logarithm;
        let found = lint::lint(&paper, &limits);
        all.push((paper, found));
    }
    if let Some(page) = &arguments.html {
        files::write::check_outputs(std::slice::from_ref(page), papers, &[])?;
        for (paper, found) in &all {
            files::write::write_file(page, report::lint_page(paper, found).as_bytes())?;
        }
    }
    let put = |text: &str| put(arguments, papers, text);
    let told = || all.iter().flat_map(|(paper, found)| lint_findings(paper, found)).collect::<Vec<_>>();
    match arguments.format {
        Format::Json => put(&json(&all, None)?)?,
        Format::Sarif => put(&sarif(&told()))?,
        Format::Github => put(&github(&told()))?,
        _ if arguments.output.is_some() => return Err("--output takes a --format that programs read".into()),
        _ => {
            for (k, (paper, found)) in all.iter().enumerate() {
                if all.len() > 1 {
                    let space = if k > 0 { "\n" } else { "" };
                    say(&format!("{space}{}\n", in_one_line(&paper.file.path)))?;
                }
                say(&lint::lint_text(paper, found))?;
            }
        }
    }
    let wrong = all.iter().any(|(_, found)| found.count(Word::Wrong) > 0);
    Ok(if wrong { Ending::Different } else { Ending::Good })
}

/// Writes what programs read, to standard output or to a file.
fn put(arguments: &LintArguments, papers: &[PathBuf], text: &str) -> Result<(), Stop> {
    let Some(output) = &arguments.output else { return print(text) };
    let inputs: Vec<PathBuf> = papers.iter().chain(&arguments.html).cloned().collect();
    files::write::check_outputs(std::slice::from_ref(output), &inputs, &[])?;
    Ok(files::write::write_file(output, text.as_bytes())?)
}

/// Why a paper could not be read, in a sentence.
fn said(stop: &(dyn std::error::Error + 'static)) -> String {
    match stop.downcast_ref() {
        Some(Failure::Problems(found)) => found.iter().map(|d| d.message.clone()).collect::<Vec<_>>().join("; "),
        _ => stop.to_string(),
    }
}

/// Looks through a paper whenever it is saved.
fn watch(arguments: &LintArguments, papers: &[PathBuf]) -> Result<Ending, Stop> {
    let [paper] = papers else { return Err("--watch looks at one paper: name one".into()) };
    if paper.as_os_str() == "-" {
        return Err("--watch looks at a file, and standard input is none".into());
    }
    let path = files::named(paper)?;
    let times = arguments.checks.map_or(usize::MAX, |n| n.max(1));
    for () in files::changes(&path, paper::LARGEST_PAPER).take(times) {
        match once(arguments, papers) {
            Ok(_) => {}
            // What cannot be read now may be read when it is saved again.
            Err(stop) => match *stop.downcast::<Failure>()? {
                Failure::Problems(found) => say_problems(found),
                other => return Err(other.into()),
            },
        }
    }
    Ok(Ending::Good)
}

/// A paper: a file, or standard input.
fn read(path: &std::path::Path) -> Result<Paper, Stop> {
    if path.as_os_str() != "-" {
        return Ok(paper::read(&files::named(path)?).map_err(Failure::from)?);
    }
    let mut bytes = Vec::new();
    std::io::stdin().lock().take(paper::LARGEST_PAPER + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > paper::LARGEST_PAPER {
        return Err("standard input is too large for a paper".into());
    }
    if let Some(what) = paper::no_text(&bytes) {
        return Err(format!("standard input is {what}").into());
    }
    let text = String::from_utf8(bytes).map_err(|_| "standard input is not UTF-8")?;
    let source = Source { path: "-".to_owned(), text };
    Ok(paper::parse(source, String::new()).map_err(Failure::from)?)
}

/// Whether a command line names a paper where a command is expected.
pub fn is_paper(word: &std::ffi::OsStr) -> bool {
    let path = std::path::Path::new(word);
    path.extension().is_some_and(|e| e == "tex" || e == "md" || e == "ipynb")
        && !word.to_string_lossy().starts_with('-')
}

/// What a folder, or a file that is no paper by its name, needs in the place of a command.
pub fn instead_of_command(word: &std::ffi::OsStr) -> Option<String> {
    let path = std::path::Path::new(word);
    let name = in_one_line(&word.to_string_lossy());
    if path.is_file() {
        return Some(format!(
            "`{name}` is a file, and no command: `rederive lint {name}` looks through a paper, `rederive check {name}` checks a derivation file"
        ));
    }
    let inside = path.is_dir().then(|| files::search(path, &|p| is_paper(p.as_os_str())).ok())??;
    let name_of = |p: &PathBuf| in_one_line(&p.to_string_lossy());
    let papers: Vec<String> = inside.found.iter().take(MOST_NAMED).map(name_of).collect();
    Some(match papers.is_empty() {
        true => format!(
            "`{name}` is a folder, and no command; no `.tex` file is in it. `rederive check {name}` checks the derivation files in it"
        ),
        false => format!(
            "`{name}` is a folder, and no command: `rederive lint {}` looks through the papers in it",
            papers.join(" ")
        ),
    })
}

/// The document of a paper; of several a list of them, one that could not be read the last.
fn json(all: &[(Paper, Lint)], unread: Option<serde_json::Value>) -> Result<String, Stop> {
    let read = all.iter().map(|(paper, found)| report::lint_document(paper, found));
    let documents: Vec<serde_json::Value> = read.chain(unread).collect();
    match documents.as_slice() {
        [one] => as_json(one),
        several => as_json(&several.to_vec().into()),
    }
}
