//! Arguments that several commands have.

use std::path::PathBuf;
use std::time::Duration;

use super::ending::Stop;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use rederive::Format;
use rederive::check::{Limits, Rigor, WorkFactor};
use rederive::config::Config;
use rederive::latex::Logarithm;

/// One of some values, each with its name and with what it is.
pub fn one_of<T: Clone + Send + Sync + 'static>(
    all: impl IntoIterator<Item = (&'static str, &'static str, T)>,
) -> impl TypedValueParser<Value = T> {
    let all: Vec<_> = all.into_iter().collect();
    let names: Vec<_> = all.iter().map(|(name, says, _)| PossibleValue::new(name).help(says)).collect();
    PossibleValuesParser::new(names).try_map(move |name| {
        let found = all.iter().find(|(of, ..)| *of == name).map(|(.., value)| value.clone());
        found.ok_or("it is none of these")
    })
}

/// One of some formats.
pub fn printed_as(formats: &[Format]) -> impl TypedValueParser<Value = Format> {
    one_of(formats.iter().map(|format| (format.words().0, format.words().1, *format)))
}

/// The derivation files that a command is about.
#[derive(clap::Args)]
pub struct FileArguments {
    /// Derivation file, or a folder that contains them
    #[arg(value_name = "FILE", default_value = "derivations")]
    pub path: PathBuf,
}

#[derive(clap::Args)]
pub struct RigorArgument {
    /// How much is asked of a verdict
    #[arg(long, value_parser = one_of(Rigor::ALL.map(|r| (r.words().0, r.words().1, r))), default_value = "enclosed")]
    pub rigor: Rigor,
}

#[derive(clap::Args)]
pub struct LogarithmArgument {
    /// What `\log` is; unless given, what `rederive.toml` says, or else it is not read
    #[arg(long = "log", value_name = "WHICH", value_parser = one_of(Logarithm::ALL))]
    log: Option<Logarithm>,
}

impl LogarithmArgument {
    /// What the command line says, or else the configuration.
    pub fn or_configured(&self) -> Result<Option<Logarithm>, Stop> {
        self.log.map_or_else(|| Ok(Config::find()?.log), |said| Ok(Some(said)))
    }
}

#[derive(clap::Args)]
pub struct ThreadArguments {
    /// Use so many threads; as many as there are processors, unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

/// What a run may take.
#[derive(clap::Args)]
pub struct LimitArguments {
    /// End after so many seconds: what is left is undecided. Results may then differ from run to run
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    deadline: Option<f64>,
    /// Go on with nothing while so many megabytes are in use: what is left is undecided (on Linux)
    #[arg(long, value_name = "MEGABYTES")]
    memory: Option<u64>,
    /// Allow each piece of the work so many times what is counted for it: see `docs/limits.md`
    #[arg(long, value_name = "TIMES", default_value_t, hide_default_value = true)]
    work: WorkFactor,
}

impl LimitArguments {
    /// The limits, counted from now.
    pub fn begun(&self) -> Limits {
        let memory = self.memory.map(|megabytes| megabytes.saturating_mul(1_000_000));
        Limits { deadline: Limits::after(self.deadline), memory, work: self.work, ..Limits::default() }
    }
}

/// A number of seconds that is not negative.
fn seconds(text: &str) -> Result<f64, String> {
    number(text, |x| Duration::try_from_secs_f64(x).is_ok(), "a number of seconds is expected")
}

/// A number that is one of those that are meant; else what is expected.
pub fn number(text: &str, is_meant: impl Fn(f64) -> bool, expected: &str) -> Result<f64, String> {
    text.parse().ok().filter(|x| is_meant(*x)).ok_or_else(|| expected.to_owned())
}
