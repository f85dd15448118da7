//! `rederive watch`.
//!
//! The file is looked at forty times a second. This needs no service of the operating system, and works on every file system
//! and with editors that replace a file instead of writing to it.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use rederive::derivation::{LARGEST_FILE, load};
use rederive::{Ending, Failure, Session, files, report};

use super::ending::{Stop, say, say_problems};

/// Between two looks at the file.
const PAUSE: Duration = Duration::from_millis(25);

#[derive(clap::Args)]
pub struct WatchArguments {
    /// The derivation file
    file: PathBuf,
    /// Stop after so many checks
    #[arg(long, value_name = "N")]
    checks: Option<usize>,
}

pub fn watch(arguments: &WatchArguments) -> Result<Ending, Stop> {
    let path = files::named(&arguments.file)?;
    let mut session = Session::blank();
    let mut last = None;
    let mut checks = 0;
    loop {
        // A file that is being replaced may be missing for a moment; if it stays away, that is told once.
        let now = files::read(&path, LARGEST_FILE).ok();
        if now.is_some() && now != last || last.is_none() && checks == 0 {
            last = now;
            check(&path, &mut session)?;
            checks += 1;
            if arguments.checks.is_some_and(|n| checks >= n) {
                return Ok(Ending::Good);
            }
        }
        std::thread::sleep(PAUSE);
    }
}

/// Checks the file as it is now, and prints what is not as expected.
fn check(path: &Path, session: &mut Session) -> Result<(), Stop> {
    let started = Instant::now();
    let checked = load(path).map_err(Failure::Problems).and_then(|derivation| {
        session.replace(derivation);
        session.check_again()
    });
    let (found, checked) = match checked {
        Ok(found) => found,
        Err(Failure::Problems(found)) => {
            say_problems(found);
            return Ok(());
        }
        Err(other) => return Err(other.into()),
    };
    let (derivation, account) = (found.derivation(), found.account());
    say(&report::checked_again(derivation, account, checked.len(), started.elapsed(), true))
}
