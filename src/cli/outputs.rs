//! Which formats go where: `--format F` to standard output, `--format F --output FILE` to a file.

use std::path::PathBuf;

use clap::error::ErrorKind;
use clap::{ArgMatches, Args, FromArgMatches};
use rederive::files::write;
use rederive::{Detail, Format, Run};

use super::arguments::printed_as;
use super::ending::{Stop, print};

/// The formats and files of a command line.
#[derive(Args)]
struct Given {
    /// What is printed; may be repeated, each with an --output. The summary for people, unless another format is printed; of JSON there is
    /// a document for each derivation file
    #[arg(long, value_parser = printed_as(&Format::ALL))]
    format: Vec<Format>,
    /// The file for the --format before it
    #[arg(long, value_name = "FILE")]
    output: Vec<PathBuf>,
}

/// Every format, with its file; without one it goes to standard output.
#[derive(Clone, Debug, Default)]
pub struct Targets(Vec<(Format, Option<PathBuf>)>);

/// Which `--output` belongs to which `--format` is known by their places alone.
impl FromArgMatches for Targets {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Targets, clap::Error> {
        let Given { format, output } = Given::from_arg_matches(matches)?;
        let places = |id: &str| matches.indices_of(id).into_iter().flatten();
        let formats = places("format").zip(format.into_iter().map(Ok));
        let mut words: Vec<_> = formats.chain(places("output").zip(output.into_iter().map(Err))).collect();
        words.sort_by_key(|(place, _)| *place);
        let refused = |message: String| Err(clap::Error::raw(ErrorKind::ArgumentConflict, message));
        let mut targets: Vec<(Format, Option<PathBuf>)> = Vec::new();
        for (_, word) in words {
            match (word, targets.last_mut()) {
                (Ok(format), _) => targets.push((format, None)),
                (Err(file), Some((_, place @ None))) => *place = Some(file),
                (Err(file), _) => {
                    let file = file.display();
                    return refused(format!("`--output {file}` needs a `--format` of its own before it"));
                }
            }
        }
        if targets.iter().filter(|(_, file)| file.is_none()).count() > 1 {
            return refused("only one format can go to standard output: give the others an `--output`".to_owned());
        }
        Ok(Targets(targets))
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
        self.0.iter().find(|(_, file)| file.is_none()).map_or(Format::Text, |(format, _)| *format)
    }

    /// Writes every format that has a file; prints that of standard output unless it was printed file by file.
    pub fn write(&self, run: &Run, detail: Detail) -> Result<(), Stop> {
        for (format, file) in &self.0 {
            match file {
                Some(file) => write::write_file(file, run.text(*format, detail).as_bytes())?,
                None if format.is_of_one_file() => {}
                None => print(&run.text(*format, detail))?,
            }
        }
        Ok(())
    }

    /// The files.
    pub fn files(&self) -> Vec<PathBuf> {
        self.0.iter().filter_map(|(_, file)| file.clone()).collect()
    }
}
