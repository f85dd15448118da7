//! Where `check` keeps what it found for the next run.

use std::path::PathBuf;

use rederive::files::records::Records;

#[derive(clap::Args)]
pub struct RecordArguments {
    /// Keep what is found in this folder, and recall from it what is the same: only what changed is looked for again. Else in the folder
    /// that REDERIVE_CACHE names; else in that of the user for such things
    #[arg(long, value_name = "DIR")]
    cache: Option<PathBuf>,
    /// Recall nothing, and keep nothing
    #[arg(long, conflicts_with = "cache")]
    no_cache: bool,
}

impl RecordArguments {
    /// The records of earlier runs; `None` where nothing is to be kept.
    pub fn store(&self) -> Option<Records> {
        if self.no_cache { None } else { Records::of_user(self.cache.clone(), "REDERIVE_CACHE", "rederive") }
    }
}
