//! How a command ends, and the streams that it writes to.
//!
//! **In:** what a command found, or why it stopped. **Out:** an exit code, and what people or programs read.

use std::error::Error;
use std::io::Write;
use std::panic::AssertUnwindSafe;

use meter::Defects;
use rederive::diag::escape::{in_one_line, spoken};
use rederive::diag::{Diagnostic, render, sort};
use rederive::{Conclusion, Demand, Document, Ending, Failure, Format};

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

/// Why a command stops before its end: a [`Failure`], or anything else that the user can change, in a sentence.
pub type Stop = Box<dyn Error>;

/// Runs a command; problems are printed. A panic is a defect of the program, also one that ended a piece of the work, and after which the
/// command went on to its end.
pub fn guarded(command: impl FnOnce() -> Result<Ending, Stop>) -> Ending {
    let before = Defects::so_far();
    let Ok(ended) = std::panic::catch_unwind(AssertUnwindSafe(command)) else {
        // The panic itself has been printed.
        return defect("it has stopped in the middle of its work");
    };
    let ending = ended.unwrap_or_else(|stop| {
        match stop.downcast_ref() {
            Some(Failure::Problems(found)) => say_problems(found.clone()),
            Some(Failure::Defect(message)) => return defect(message),
            _ => complain(&format!("error: {}", in_one_line(&stop.to_string()))),
        }
        Ending::BadInput
    });
    match before.since() {
        Some(what) if ending != Ending::Defect => defect(&what),
        _ => ending,
    }
}

/// How what was found ends a run; what is not to be seen in the verdicts is said.
pub fn concluded(document: &Document, demand: &Demand) -> Ending {
    let Conclusion { ending, notes, defect: message } = document.conclusion(demand);
    notes.iter().for_each(|note| complain(note));
    message.map_or(ending, |message| defect(&message))
}

/// Writes problems of files to standard error.
pub fn say_problems(mut found: Vec<Diagnostic>) {
    sort(&mut found);
    complain(render(&found, true).trim_end());
}

/// Asks for a report of a defect.
pub fn defect(message: &str) -> Ending {
    let version = env!("CARGO_PKG_VERSION");
    complain(&format!(
        "\nThis is a defect of rederive {version}, not of your file: {message}.\n\
         Please report it, with the file and what is printed above."
    ));
    Ending::Defect
}

/// Writes a line, or several, to standard error for people, see [`spoken`]; colours are removed where they are not wanted.
pub fn complain(text: &str) {
    // If standard error is closed, there is no place left to say so.
    let _ = anstream::stderr().write_all(spoken(&format!("{text}\n")).as_bytes());
}

/// Writes to standard output what people read, see [`spoken`].
pub fn say(text: &str) -> Result<(), Stop> {
    print(&spoken(text))
}

/// Writes to standard output what is in a format: two are for people, who may read them in the log of a workflow.
pub fn answer(format: Format, text: &str) -> Result<(), Stop> {
    if matches!(format, Format::Text | Format::Markdown) { say(text) } else { print(text) }
}

/// Writes to standard output what programs read, as it is; colours are removed where they are not wanted.
///
/// A reader who has seen enough and closed the pipe is no failure, and does not keep the rest of the work from being done.
pub fn print(text: &str) -> Result<(), Stop> {
    let mut out = anstream::stdout();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(format!("standard output cannot be written: {e}").into())
        }
        _ => Ok(()),
    }
}

/// Writes to standard output a document as JSON, in which a log of a workflow finds no command.
pub fn print_json(document: &serde_json::Value) -> Result<(), Stop> {
    print(&as_json(document)?)
}

/// A document as the JSON that is written.
pub fn as_json(document: &serde_json::Value) -> Result<String, Stop> {
    let text = serde_json::to_string_pretty(document).map_err(|error| error.to_string())?;
    Ok(rederive::diag::escape::in_json(text) + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use meter::{Limits, Task};

    #[test]
    fn a_panic_is_a_defect() {
        assert_eq!(guarded(|| panic!("on purpose")), Ending::Defect);
        assert_eq!(guarded(|| Err(Failure::Defect("1 = 2".into()).into())), Ending::Defect);
        assert_eq!(guarded(|| Err("wrong".into())), Ending::BadInput);
        assert_eq!(guarded(|| Ok(Ending::Different)), Ending::Different);
        let in_a_piece = || {
            let found = meter::piece(Task::Weighing, &Limits::default(), || panic!("on purpose"));
            found.unwrap_or_else(|_| Ok(Ending::Good))
        };
        assert_eq!(guarded(in_a_piece), Ending::Defect);
    }
}
