//! Which formats go where: `--format F` to standard output, `--format F --output FILE` to a file.

use std::path::PathBuf;

use clap::error::ErrorKind;
use clap::{ArgMatches, Args, FromArgMatches, ValueEnum};
use rederive::Findings;
use rederive::files::write;
use rederive::paper::Comparison;
use rederive::report::{self, Checked, Finding};

use super::ending::{Stop, print};

/// How results are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// A summary for people
    Text,
    /// The report as JSON, one document for each derivation file
    Json,
    /// The report as LaTeX source, for an appendix or a letter; pdflatex compiles it
    Tex,
    /// JUnit XML: a test case for each claim on each trajectory
    Junit,
    /// SARIF 2.1.0, for code scanning: what is not as expected, with its place
    Sarif,
    /// Annotations of a GitHub workflow
    Github,
}

impl Format {
    /// Whether it is printed as soon as a derivation file is checked, and not at the end.
    pub fn is_printed_by_file(self) -> bool {
        matches!(self, Format::Text | Format::Json | Format::Tex)
    }
}

/// A format and where it goes.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Target {
    /// The format.
    format: Format,
    /// The file; without one, standard output.
    output: Option<PathBuf>,
}

/// The formats and files of a command line.
#[derive(Args)]
struct Given {
    /// What is printed; may be repeated, each with an --output. The summary, unless another format is printed
    #[arg(long, value_enum)]
    format: Vec<Format>,
    /// The file for the --format before it
    #[arg(long, value_name = "FILE")]
    output: Vec<PathBuf>,
}

/// Every format, with where it goes.
#[derive(Clone, Debug, Default)]
pub struct Targets(Vec<Target>);

impl FromArgMatches for Targets {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Targets, clap::Error> {
        let Given { format, output } = Given::from_arg_matches(matches)?;
        let paired = paired(matches, &format, &output);
        paired.map(Targets).map_err(|message| clap::Error::raw(ErrorKind::ArgumentConflict, message))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Targets::from_arg_matches(matches)?;
        Ok(())
    }
}

impl Args for Targets {
    fn augment_args(command: clap::Command) -> clap::Command {
        Given::augment_args(command)
    }

    fn augment_args_for_update(command: clap::Command) -> clap::Command {
        Given::augment_args_for_update(command)
    }
}

impl Targets {
    /// The format of standard output: that without a file, or the summary when every format has one.
    pub fn standard(&self) -> Format {
        self.0.iter().find(|t| t.output.is_none()).map_or(Format::Text, |t| t.format)
    }

    /// The files.
    pub fn files(&self) -> Vec<PathBuf> {
        self.0.iter().filter_map(|t| t.output.clone()).collect()
    }
}

/// Pairs every `--output` with the `--format` before it.
///
/// # Errors
/// An output without a format of its own, a file that is named twice, or two formats for standard output.
fn paired(matches: &ArgMatches, formats: &[Format], outputs: &[PathBuf]) -> Result<Vec<Target>, String> {
    let places = |id: &str| -> Vec<usize> { matches.indices_of(id).map(Iterator::collect).unwrap_or_default() };
    let mut given: Vec<(usize, Format)> = places("format").into_iter().zip(formats.iter().copied()).collect();
    given.sort_by_key(|(place, _)| *place);
    let mut files: Vec<(usize, &PathBuf)> = places("output").into_iter().zip(outputs).collect();
    files.sort_by_key(|(place, _)| *place);

    let mut out: Vec<Target> = given.iter().map(|&(_, format)| Target { format, output: None }).collect();
    for (place, file) in files {
        let of = given.iter().rposition(|(p, _)| *p < place);
        let Some(target) = of.and_then(|i| out.get_mut(i)).filter(|t| t.output.is_none()) else {
            return Err(format!("`--output {}` needs a `--format` of its own before it", file.display()));
        };
        target.output = Some(file.clone());
    }
    let named: Vec<&PathBuf> = out.iter().filter_map(|t| t.output.as_ref()).collect();
    if let Some(twice) =
        named.iter().enumerate().find(|(i, f)| named[..*i].iter().any(|g| write::same_place(g, f))).map(|(_, f)| f)
    {
        return Err(format!("`{}` is the output of two formats", twice.display()));
    }
    if out.iter().filter(|t| t.output.is_none()).count() > 1 {
        return Err("only one format can go to standard output: give the others an `--output`".to_owned());
    }
    Ok(out)
}

/// What a run found, file by file, and what is to be told beside verdicts.
#[derive(Default)]
pub struct Found {
    /// What was checked.
    checked: Vec<(Findings, Option<Comparison>)>,
    /// Everything that is to be told, verdicts included.
    findings: Vec<Finding>,
    /// Of these, what is not of a verdict.
    others: Vec<Finding>,
}

impl Found {
    /// Adds what was found of one derivation file.
    pub fn add(&mut self, found: Findings, compared: Option<Comparison>) {
        let mut verdicts = report::findings(found.derivation(), found.account());
        if let Some(comparison) = &compared {
            report::add_paper(&mut verdicts, found.derivation(), comparison);
            let of_paper = report::paper_findings(found.derivation(), comparison);
            self.others.extend(of_paper.iter().cloned());
            verdicts.extend(of_paper);
        }
        self.findings.extend(verdicts);
        self.checked.push((found, compared));
    }

    /// Adds problems of files.
    pub fn problems(&mut self, found: &[rederive::diag::Diagnostic]) {
        let found = report::problems(found);
        self.findings.extend(found.iter().cloned());
        self.others.extend(found);
    }

    /// The text of a format; colour is for standard output.
    fn text(&self, format: Format, detail: Detail) -> String {
        let each = |text: &dyn Fn(&Findings, Option<&Comparison>) -> String, between: &str| {
            self.checked.iter().map(|(found, paper)| text(found, paper.as_ref())).collect::<Vec<_>>().join(between)
        };
        match format {
            Format::Text => {
                each(&|f, p| summary(f, p, detail, false), if detail == Detail::Exceptions { "" } else { "\n" })
            }
            Format::Json => each(&json, ""),
            Format::Tex => each(&|f, _| tex(f, detail), "\n"),
            Format::Junit => {
                let checked = self.checked.iter();
                let checked = checked.map(|(f, _)| Checked { derivation: f.derivation(), account: f.account() });
                report::junit(&checked.collect::<Vec<_>>(), &self.others)
            }
            Format::Sarif => report::sarif(&self.findings),
            Format::Github => report::github(&self.findings),
        }
    }

    /// Writes every format that has a file; prints that of standard output unless it was printed file by file.
    pub fn write(&self, targets: &Targets, detail: Detail) -> Result<(), Stop> {
        for target in &targets.0 {
            match &target.output {
                Some(file) => write::write_file(file, self.text(target.format, detail).as_bytes())?,
                None if target.format.is_printed_by_file() => {}
                None => print(&self.text(target.format, detail))?,
            }
        }
        Ok(())
    }
}

/// How much the text for people says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// What differs, and what is open.
    Exceptions,
    /// The first page alone.
    FirstPage,
    /// The first page, and what asks for attention.
    Usual,
    /// The matrix, and all that was found.
    Whole,
}

/// The report as data, with the comparison with the paper where there is one.
pub fn json(found: &Findings, paper: Option<&Comparison>) -> String {
    match paper {
        Some(paper) => report::json_with_paper(found.derivation(), found.account(), paper),
        None => found.json(),
    }
}

/// The report as LaTeX source.
pub fn tex(found: &Findings, detail: Detail) -> String {
    match detail {
        Detail::FirstPage => report::tex_summary(found.derivation(), found.account()),
        _ => report::tex(found.derivation(), found.account()),
    }
}

/// The text for people, with the comparison with the paper where there is one.
pub fn summary(found: &Findings, paper: Option<&Comparison>, detail: Detail, colour: bool) -> String {
    let (derivation, account) = (found.derivation(), found.account());
    match detail {
        Detail::Exceptions => report::exceptions(derivation, account, colour),
        Detail::FirstPage => report::front_page(derivation, account, colour),
        Detail::Usual | Detail::Whole => {
            let mut out = report::summary(derivation, account, colour, detail == Detail::Whole);
            out.extend(paper.map(|paper| report::paper_summary(derivation, paper)));
            out
        }
    }
}
