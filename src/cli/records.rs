//! Where `check` keeps what it found for the next run.

use std::path::PathBuf;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use rederive::check::Store;
use rederive::files::records::Records;

/// What was found faster is not kept.
const QUICK: Duration = Duration::from_millis(300);

#[derive(clap::Args)]
pub struct RecordArguments {
    /// Keep what was found in this folder, and recall from it what is the same: only what changed is checked. Without it in that of the
    /// user for such things; what another version of the program kept is not used
    #[arg(long, value_name = "DIR", env = "REDERIVE_CACHE", hide_env_values = true)]
    cache: Option<PathBuf>,
    /// Recall nothing, and keep nothing
    #[arg(long, conflicts_with = "cache")]
    no_cache: bool,
}

impl RecordArguments {
    /// The folder; `None` where nothing is to be kept.
    pub fn store(&self) -> Option<Kept> {
        // An empty name is none.
        let given = self.cache.clone().or_else(|| Records::usual_folder("rederive"));
        let folder = given.filter(|folder| !self.no_cache && !folder.as_os_str().is_empty())?;
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
