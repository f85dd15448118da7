//! How a command ends, and the streams that it writes to.
//!
//! **In:** what a command found, or why it stopped. **Out:** an exit code, and what people or programs read.

use std::io::Write;
use std::panic::AssertUnwindSafe;

use rederive::check::{CheckError, Summary};
use rederive::diag::shown::{in_one_line, spoken};
use rederive::diag::{Diagnostic, render, sort};
use rederive::files::FileError;
use rederive::{Failure, Findings};

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// Every verdict is as expected, and at least one claim was decided.
    Good,
    /// Some verdict differs from what is expected.
    Different,
    /// The command line or a file could not be read, or a report could not be written.
    BadInput,
    /// Nothing differs, but some verdict is undecided without being expected so, or nothing was checked.
    Undecided,
    /// A defect of the program.
    Defect,
}

impl Exit {
    pub fn code(self) -> u8 {
        match self {
            Exit::Good => 0,
            Exit::Different => 1,
            Exit::BadInput => 2,
            Exit::Undecided => 3,
            Exit::Defect => 70,
        }
    }

    /// The more serious of two.
    pub fn and(self, other: Exit) -> Exit {
        let rank = |e: Exit| match e {
            Exit::Good => 0,
            Exit::Undecided => 1,
            Exit::Different => 2,
            Exit::BadInput => 3,
            Exit::Defect => 4,
        };
        if rank(other) > rank(self) { other } else { self }
    }

    /// What the verdicts of a file end a run with; what is not to be seen in them is said.
    pub fn of(found: &Findings) -> Exit {
        let (file, account) = (&found.derivation().file.path, found.account());
        let summary = account.summary();
        let mut exit = Exit::of_verdicts(&summary);
        if summary.holds + summary.fails == 0 {
            complain(&format!("{file}: no claim was decided\n"));
            exit = exit.and(Exit::Undecided);
        }
        if let Some((claim, on, why)) = account.defects().next() {
            let more = account.defects().count() - 1;
            let more = if more > 0 { format!(" (and {more} more)") } else { String::new() };
            exit = exit.and(defect(&format!("{claim} on {on}{more} has no verdict: {why}")));
        }
        if account.units.unexpected() > 0 { exit.and(Exit::Different) } else { exit }
    }

    fn of_verdicts(summary: &Summary) -> Exit {
        if summary.unexpected > 0 {
            Exit::Different
        } else if summary.open > 0 {
            Exit::Undecided
        } else {
            Exit::Good
        }
    }
}

pub const EXIT_CODES: &str = "\
Exit codes:
  0   every verdict is as expected, and at least one claim was decided
  1   some verdict differs from what is expected (without an expectation: some
      claim fails), the units of a formula do not agree, what --strict asks for
      is not met, or --min-discrimination is not reached
  2   the command line or a file could not be read, or a report could not be
      written
  3   nothing differs, but some verdict is undecided that the file does not
      expect to be
  70  a defect of rederive itself";

/// Why a command stops before its end.
pub enum Stop {
    /// Problems in files.
    Diagnostics(Vec<Diagnostic>),
    /// Anything else that the user can change, in a sentence.
    Message(String),
    /// The program contradicts itself.
    Defect(String),
}

impl From<FileError> for Stop {
    fn from(error: FileError) -> Stop {
        Stop::Message(error.to_string())
    }
}

impl From<CheckError> for Stop {
    fn from(error: CheckError) -> Stop {
        match error {
            CheckError::Problems(found) => Stop::Diagnostics(found),
            CheckError::Defect(message) => Stop::Defect(message),
        }
    }
}

impl From<Failure> for Stop {
    fn from(failure: Failure) -> Stop {
        match failure {
            Failure::Problems(found) => Stop::Diagnostics(found),
            Failure::Defect(message) => Stop::Defect(message),
            Failure::Unknown(_) | Failure::Parts(_) | Failure::Cancelled => Stop::Message(failure.to_string()),
        }
    }
}

/// Runs a command; problems are printed, and a panic is a defect of the program.
pub fn guarded(command: impl FnOnce() -> Result<Exit, Stop>) -> Exit {
    match std::panic::catch_unwind(AssertUnwindSafe(command)) {
        Ok(Ok(exit)) => exit,
        Ok(Err(Stop::Diagnostics(mut found))) => {
            sort(&mut found);
            complain(&render(&found, true));
            Exit::BadInput
        }
        Ok(Err(Stop::Message(message))) => {
            complain(&format!("error: {}\n", in_one_line(&message)));
            Exit::BadInput
        }
        Ok(Err(Stop::Defect(message))) => defect(&message),
        // The panic itself has been printed.
        Err(_) => defect("it has stopped in the middle of its work"),
    }
}

/// Asks for a report of a defect.
pub fn defect(message: &str) -> Exit {
    let version = env!("CARGO_PKG_VERSION");
    complain(&format!(
        "\nThis is a defect of rederive {version}, not of your file: {message}.\n\
         Please report it, with the file and what is printed above.\n"
    ));
    Exit::Defect
}

/// Writes to standard error what people read, see [`spoken`]; colours are removed where they are not wanted.
pub fn complain(text: &str) {
    // If standard error is closed, there is no place left to say so.
    let _ = anstream::stderr().write_all(spoken(text).as_bytes());
}

/// Writes to standard output what people read, see [`spoken`].
pub fn say(text: &str) -> Result<(), Stop> {
    print(&spoken(text))
}

/// Writes to standard output what programs read, as it is; colours are removed where they are not wanted.
///
/// A reader who has seen enough and closed the pipe is no failure, and does not keep the rest of the work from being done.
pub fn print(text: &str) -> Result<(), Stop> {
    let mut out = anstream::stdout();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Stop::Message(format!("standard output cannot be written: {e}")))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_defect() {
        assert_eq!(guarded(|| panic!("on purpose")), Exit::Defect);
        assert_eq!(guarded(|| Err(CheckError::Defect("1 = 2".into()).into())), Exit::Defect);
        assert_eq!(guarded(|| Err(Stop::Message("wrong".into()))), Exit::BadInput);
        assert_eq!(guarded(|| Ok(Exit::Different)), Exit::Different);
    }

    #[test]
    fn the_most_serious_ending_counts() {
        use Exit::{BadInput, Defect, Different, Good, Undecided};
        let order = [Good, Undecided, Different, BadInput, Defect];
        for (i, a) in order.iter().enumerate() {
            for (j, b) in order.iter().enumerate() {
                assert_eq!(a.and(*b), order[i.max(j)]);
            }
        }
        assert_eq!(order.map(Exit::code), [0, 3, 1, 2, 70]);
    }
}
