//! Where `check` keeps what it found for the next run.

use std::path::PathBuf;

use rederive::files::records::Records;

/// The variable that names the folder; where it is empty, nothing is kept.
const FOLDER: &str = "REDERIVE_CACHE";

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
        let usual = || match std::env::var_os(FOLDER) {
            Some(folder) => (!folder.is_empty()).then(|| folder.into()),
            None => Records::usual_folder("rederive"),
        };
        let folder = if self.no_cache { None } else { self.cache.clone().or_else(usual) }?;
        Some(Records::new(folder, std::env::current_exe().ok()?))
    }
}
