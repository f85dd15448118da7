//! `rederive list`.

use rederive::{Ending, report};

use super::arguments::FileArguments;
use super::ending::{Stop, say};

#[derive(clap::Args)]
pub struct ListArguments {
    #[command(flatten)]
    files: FileArguments,
}

pub fn list(arguments: &ListArguments) -> Result<Ending, Stop> {
    for session in arguments.files.sessions()? {
        say(&report::contents(session.derivation()))?;
    }
    Ok(Ending::Good)
}
