//! Where `check` keeps what it found for the next run.

use std::path::PathBuf;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use rederive::check::Store;
use rederive::files::records::Records;

/// What was found faster is not kept.
const QUICK: Duration = Duration::from_millis(300);

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
    /// The folder; `None` where nothing is to be kept.
    pub fn store(&self) -> Option<Kept> {
        let usual = || match std::env::var_os(FOLDER) {
            Some(folder) => (!folder.is_empty()).then(|| folder.into()),
            None => Records::usual_folder("rederive"),
        };
        let folder = if self.no_cache { None } else { self.cache.clone().or_else(usual) }?;
        let records = Records::new(folder, std::env::current_exe().ok()?);
        Some(Kept { records, asked: Mutex::new(Instant::now()) })
    }
}

/// The records of earlier runs.
pub struct Kept {
    records: Records,
    /// When a record was asked for.
    asked: Mutex<Instant>,
}

impl Store for Kept {
    fn read(&self, name: &str) -> Option<Vec<u8>> {
        *self.asked.lock().ok()? = Instant::now();
        self.records.read(name)
    }

    fn write(&self, name: &str, record: &[u8]) {
        if self.asked.lock().is_ok_and(|asked| asked.elapsed() >= QUICK) {
            self.records.write(name, record);
        }
    }
}
