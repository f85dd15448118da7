//! `rederive list`.

use std::path::PathBuf;

use rederive::report;

use super::ending::{Exit, Stop, say};
use super::files;

#[derive(clap::Args)]
pub struct ListArguments {
    /// Derivation file, or a folder that contains them
    #[arg(value_name = "FILE", default_value = "derivations")]
    path: PathBuf,
}

pub fn list(arguments: &ListArguments) -> Result<Exit, Stop> {
    for session in files::load_all(&files::find(std::slice::from_ref(&arguments.path))?)? {
        say(&report::contents(session.derivation()))?;
    }
    Ok(Exit::Good)
}
