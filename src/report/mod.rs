//! Verdicts as people and programs read them.
//!
//! **In:** an [`Account`](crate::check::Account) and the [`Derivation`](crate::derivation::Derivation) that it is of.
//! **Out:** [`summary`] for a terminal, [`json`] (the contract), [`markdown`] (for a forge), [`explain`] (one verdict);
//! [`junit`], [`sarif`] and [`github`] for machines, the last two drawn from [`findings`];
//! [`write_files`] puts them into a folder, all or none.
//!
//! **Guaranteed:** the same account gives the same bytes; no clock, no machine, no path outside the project. Nothing is
//! computed here: every number comes from the account, and is only chosen and written.

mod diff;
mod explain;
mod finding;
mod github;
mod json;
mod junit;
mod markdown;
mod numbers;
mod paper;
mod sarif;
mod schema;
mod summary;
mod tally;
mod text;
mod write;

pub use diff::{Change, Direction, diff, diff_text, is_worse};
pub use explain::explain;
pub use finding::{Finding, Level, Place, Region, findings, problems, rule_says};
pub use github::github;
pub use json::{json, json_with_paper};
pub use junit::{Checked, junit};
pub use markdown::markdown;
pub use paper::{add_paper, paper_findings, paper_summary};
pub use sarif::sarif;
pub use schema::schema;
pub use summary::{exceptions, summary};
pub use write::{WriteError, write_files};

#[cfg(test)]
mod tests {
    use crate::check::sample;
    use crate::derivation::{Derivation, parse};
    use crate::diag::{Source, render};

    /// The derivation that the handmade account is of.
    pub(super) fn derivation() -> Derivation {
        let source = Source { path: "derivations/spring.toml".into(), text: sample::FILE.into() };
        parse(source, "spring").unwrap_or_else(|e| panic!("{}", render(&e, false)))
    }
}
