//! Arguments that several commands have.

use std::time::{Duration, Instant};

use clap::ValueEnum;
use rederive::check::{Limits, Rigor};

/// How much is asked of a verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RigorArgument {
    /// At finitely many times
    Sampled,
    /// At every time of the span where it is possible, with rounding accounted for
    Enclosed,
}

impl From<RigorArgument> for Rigor {
    fn from(argument: RigorArgument) -> Rigor {
        match argument {
            RigorArgument::Sampled => Rigor::Sampled,
            RigorArgument::Enclosed => Rigor::Enclosed,
        }
    }
}

/// What a run may take.
#[derive(clap::Args)]
pub struct LimitArguments {
    /// Begin nothing after so many seconds: what is left is undecided. Results may then differ from run to run
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    deadline: Option<Duration>,
    /// Begin nothing while so many megabytes are in use: what is left is undecided (on Linux)
    #[arg(long, value_name = "MEGABYTES")]
    memory: Option<u64>,
    /// Use so many threads; as many as there are processors, unless given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
}

impl LimitArguments {
    /// The limits, counted from now.
    pub fn begun(&self) -> Limits {
        let deadline = self.deadline.and_then(|after| Instant::now().checked_add(after));
        let memory = self.memory.map(|megabytes| megabytes.saturating_mul(1_000_000));
        Limits { deadline, memory, cancel: None }
    }
}

/// A number of seconds that is not negative.
pub fn seconds(text: &str) -> Result<Duration, String> {
    let number = text.parse::<f64>().ok().and_then(|x| Duration::try_from_secs_f64(x).ok());
    number.ok_or_else(|| "a number of seconds is expected".to_owned())
}
