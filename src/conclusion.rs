//! How a run ends, for the program that waits for it.
//!
//! **In:** what was found of a derivation file, and how much is demanded of it. **Out:** an [`Ending`], which has an exit code, and what is
//! to be said of it that is not to be seen in the verdicts.

use crate::check::standing::Decision;
use crate::report;
use crate::run::Document;
use crate::session::Answer;

/// How a run ended; what is more serious is greater.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ending {
    /// Every verdict is as expected, and at least one claim was decided.
    Good,
    /// Nothing differs, but some verdict is undecided without being expected so, or nothing was checked.
    Undecided,
    /// Some verdict differs from what is expected.
    Different,
    /// The command line or a file could not be read, or a report could not be written.
    BadInput,
    /// A defect of the program.
    Defect,
}

impl Ending {
    /// The exit code of a program.
    pub fn code(self) -> u8 {
        match self {
            Ending::Good => 0,
            Ending::Different => 1,
            Ending::BadInput => 2,
            Ending::Undecided => 3,
            Ending::Defect => 70,
        }
    }
}

impl Answer {
    /// How it ends a run: a case that is left out, what must be assumed beside what is given, and what is open, are undecided.
    pub fn ending(&self) -> Ending {
        match self.account().finding.decision() {
            Decision::Proved | Decision::Unreplayed if self.account().is_shown() => Ending::Good,
            Decision::Refuted => Ending::Different,
            Decision::Proved | Decision::ProvedExcept | Decision::Unreplayed | Decision::Undecided => Ending::Undecided,
        }
    }
}

/// What is demanded beside verdicts that are as expected.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Demand {
    /// Every claim applies to some motion, something is decided, and no proof rests on a refuted premise.
    pub strict: bool,
    /// Of each claim that holds, at least this share of the altered formulas is rejected, 0 … 1.
    pub discrimination: f64,
}

/// How what was found of a derivation file ends a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conclusion {
    /// The most serious of all.
    pub ending: Ending,
    /// What is to be said, a line each.
    pub notes: Vec<String>,
    /// The first verdict that is missing because the program contradicts itself.
    pub defect: Option<String>,
}

impl Conclusion {
    fn note(&mut self, ending: Ending, note: String) {
        self.ending = self.ending.max(ending);
        self.notes.push(note);
    }

    /// How what was found ends a run.
    pub fn of(document: &Document, demand: &Demand) -> Conclusion {
        let (derivation, account) = (document.findings.derivation(), document.findings.account());
        let (file, summary) = (&derivation.file.path, account.summary());
        let ending = if summary.unexpected > 0 || account.units.unexpected() > 0 {
            Ending::Different
        } else if summary.open > 0 {
            Ending::Undecided
        } else {
            Ending::Good
        };
        let mut out = Conclusion { ending, notes: Vec::new(), defect: None };
        if document.paper.as_ref().is_some_and(|c| c.differences.len() + c.unknown.len() > 0) {
            out.note(Ending::Different, format!("{file}: what it says is not what the paper prints"));
        }
        if summary.holds + summary.fails == 0 {
            out.note(Ending::Undecided, format!("{file}: no claim was decided"));
        }
        for alarm in report::alarms(derivation, account).into_iter().filter(|_| demand.strict) {
            out.note(Ending::Different, format!("{file}: {alarm}"));
        }
        for (claim, rejected, of) in account.discriminating_less_than(demand.discrimination) {
            let share = format!("only {rejected} of {of} altered formulas are rejected by any motion");
            out.note(Ending::Different, format!("{claim}: {share}"));
        }
        if let Some((claim, on, why)) = account.defects().next() {
            let more = match account.defects().count() - 1 {
                0 => String::new(),
                more => format!(" (and {more} more)"),
            };
            out.defect = Some(format!("{claim} on {on}{more} has no verdict: {why}"));
            out.ending = Ending::Defect;
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_most_serious_ending_is_the_greatest() {
        use Ending::{BadInput, Defect, Different, Good, Undecided};
        let order = [Good, Undecided, Different, BadInput, Defect];
        assert!(order.is_sorted());
        assert_eq!(order.map(Ending::code), [0, 3, 1, 2, 70]);
    }
}
