//! `rederive watch`.

use std::path::{Path, PathBuf};
use std::time::Instant;

use rederive::derivation::{LARGEST_FILE, load};
use rederive::{Ending, Failure, Session, files, report};

use super::ending::{Stop, say, say_problems};

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
    // At least one.
    let checks = arguments.checks.map_or(usize::MAX, |n| n.max(1));
    files::changes(&path, LARGEST_FILE).take(checks).try_for_each(|()| check(&path, &mut session))?;
    Ok(Ending::Good)
}

/// Checks the file as it is now, and prints what is not as expected.
fn check(path: &Path, session: &mut Session) -> Result<(), Stop> {
    let started = Instant::now();
    let checked = load(path).map_err(Failure::Problems).and_then(|derivation| {
        session.replace(derivation);
        session.check_again()
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
