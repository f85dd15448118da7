//! `rederive watch`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use rederive::derivation::{LARGEST_FILE, load};
use rederive::files::records::Records;
use rederive::{Ending, Failure, Session, files, report};

use super::ending::{Stop, say, say_problems};
use super::records::RecordArguments;

#[derive(clap::Args)]
pub struct WatchArguments {
    /// The derivation file
    file: PathBuf,
    /// Stop after so many checks
    #[arg(long, value_name = "N")]
    checks: Option<usize>,
    #[command(flatten)]
    records: RecordArguments,
}

pub fn watch(arguments: &WatchArguments) -> Result<Ending, Stop> {
    let path = files::named(&arguments.file)?;
    let mut session = Session::blank();
    // At least one.
    let checks = arguments.checks.map_or(usize::MAX, |n| n.max(1));
    let store = arguments.records.store();
    files::changes(&path, LARGEST_FILE).take(checks).try_for_each(|()| check(&path, &mut session, store.as_ref()))?;
    Ok(Ending::Good)
}

/// Checks the file as it is now, and prints what is not as expected.
fn check(path: &Path, session: &mut Session, store: Option<&Records>) -> Result<(), Stop> {
    let started = Instant::now();
    let checked = load(path).map_err(Failure::Problems).and_then(|derivation| {
        session.replace(derivation);
        match store {
            Some(store) => session.check_again_recorded(store),
            None => session.check_again(),
        }
    });
    match checked {
        Ok((found, checked)) => {
            let (derivation, account) = (found.derivation(), found.account());
            say(&report::checked_again(derivation, account, checked.len(), started.elapsed(), true))
        }
        Err(Failure::Problems(found)) => {
            say_problems(found);
            Ok(())
        }
        Err(other) => Err(other.into()),
    }
}
