//! Which formats go where: `--format F` to standard output, `--format F --output FILE` to a file.

use std::path::PathBuf;

use clap::ArgMatches;
use rederive::check::Account;
use rederive::derivation::Derivation;
use rederive::files::write;
use rederive::paper::Comparison;
use rederive::report::{self, Checked, Finding};

use super::{CheckArguments, Format, Stop, print};

/// A format and where it goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Target {
    /// The format.
    pub format: Format,
    /// The file; without one, standard output.
    pub output: Option<PathBuf>,
}

/// Pairs every `--output` with the `--format` before it.
///
/// # Errors
/// An output without a format of its own, a file that is named twice, or two formats for standard output.
pub fn targets(matches: &ArgMatches, formats: &[Format], outputs: &[PathBuf]) -> Result<Vec<Target>, String> {
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

/// The format of standard output: that without a file, or the summary when every format has one.
pub fn standard(targets: &[Target]) -> Format {
    targets.iter().find(|t| t.output.is_none()).map_or(Format::Text, |t| t.format)
}

/// What a run found, file by file, and what is to be told beside verdicts.
#[derive(Default)]
pub struct Found {
    /// What was checked.
    pub checked: Vec<(Derivation, Account, Option<Comparison>)>,
    /// Everything that is to be told, verdicts included.
    pub findings: Vec<Finding>,
    /// Of these, what is not of a verdict.
    pub others: Vec<Finding>,
}

impl Found {
    /// Adds what was found of one derivation file.
    pub fn account(&mut self, derivation: Derivation, account: Account, compared: Option<Comparison>) {
        let mut verdicts = report::findings(&derivation, &account);
        if let Some(comparison) = &compared {
            report::add_paper(&mut verdicts, &derivation, comparison);
            let found = report::paper_findings(&derivation, comparison);
            self.others.extend(found.iter().cloned());
            verdicts.extend(found);
        }
        self.findings.extend(verdicts);
        self.checked.push((derivation, account, compared));
    }

    /// Adds problems of files.
    pub fn problems(&mut self, found: &[rederive::diag::Diagnostic]) {
        let found = report::problems(found);
        self.findings.extend(found.iter().cloned());
        self.others.extend(found);
    }

    /// The text of a format; colour is for standard output.
    fn text(&self, format: Format, detail: Detail) -> String {
        let checked: Vec<Checked<'_>> =
            self.checked.iter().map(|(derivation, account, _)| Checked { derivation, account }).collect();
        let each = |text: &dyn Fn(&Derivation, &Account, Option<&Comparison>) -> String, between: &str| {
            self.checked.iter().map(|(d, a, p)| text(d, a, p.as_ref())).collect::<Vec<_>>().join(between)
        };
        match format {
            Format::Text if detail == Detail::Exceptions => each(&|d, a, _| report::exceptions(d, a, false), ""),
            Format::Text => each(&|d, a, p| summary(d, a, p, detail, false), "\n"),
            Format::Json => each(&json, ""),
            Format::Tex if detail == Detail::FirstPage => each(&|d, a, _| report::tex_summary(d, a), "\n"),
            Format::Tex => each(&|d, a, _| report::tex(d, a), "\n"),
            Format::Junit => report::junit(&checked, &self.others),
            Format::Sarif => report::sarif(&self.findings),
            Format::Github => report::github(&self.findings),
        }
    }

    /// Writes every format that has a file; prints that of standard output unless it was printed file by file.
    pub fn write(&self, targets: &[Target], detail: Detail) -> Result<(), Stop> {
        for target in targets {
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

impl Detail {
    /// What a command line asks for.
    pub fn of(arguments: &CheckArguments) -> Detail {
        match (arguments.quiet, arguments.summary, arguments.matrix) {
            (true, ..) => Detail::Exceptions,
            (_, true, _) => Detail::FirstPage,
            (.., true) => Detail::Whole,
            _ => Detail::Usual,
        }
    }
}

/// The report as data, with the comparison with the paper where there is one.
pub fn json(derivation: &Derivation, account: &Account, paper: Option<&Comparison>) -> String {
    match paper {
        Some(paper) => report::json_with_paper(derivation, account, paper),
        None => report::json(derivation, account),
    }
}

/// The summary for people, with the comparison with the paper where there is one.
pub fn summary(
    derivation: &Derivation,
    account: &Account,
    paper: Option<&Comparison>,
    detail: Detail,
    colour: bool,
) -> String {
    if detail == Detail::FirstPage {
        return report::front_page(derivation, account, colour);
    }
    let mut out = report::summary(derivation, account, colour, detail == Detail::Whole);
    out.extend(paper.map(|paper| report::paper_summary(derivation, paper)));
    out
}
