//! Which formats go where: `--format F` to standard output, `--format F --output FILE` to a file.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{ArgMatches, Args, FromArgMatches};
use rederive::files::write;
use rederive::{Detail, Format, Run};

use super::ending::{Stop, print};

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
    #[arg(long, value_parser = formats())]
    format: Vec<Format>,
    /// The file for the --format before it
    #[arg(long, value_name = "FILE")]
    output: Vec<PathBuf>,
}

/// Names of formats, with what they are.
fn formats() -> impl TypedValueParser<Value = Format> {
    let names = Format::ALL.map(|format| {
        let (name, says) = format.words();
        PossibleValue::new(name).help(says)
    });
    PossibleValuesParser::new(names).map(|name| Format::named(&name).unwrap_or(Format::Text))
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

    /// Writes every format that has a file; prints that of standard output unless it was printed file by file.
    pub fn write(&self, run: &Run, detail: Detail) -> Result<(), Stop> {
        for Target { format, output } in &self.0 {
            match output {
                Some(file) => write::write_file(file, run.text(*format, detail).as_bytes())?,
                None if format.is_of_one_file() => {}
                None => print(&run.text(*format, detail))?,
            }
        }
        Ok(())
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
