//! Verdicts as people and programs read them.
//!
//! **In:** an [`Account`](crate::check::Account) and the [`Derivation`](crate::derivation::Derivation) that it is of.
//! **Out:** [`summary`] for a terminal, [`json`] (the contract), [`markdown`] (for a forge), [`page`] (for a browser), [`tex`] (for an
//! appendix), [`explain`] (one verdict);
//! [`write_files`] puts them into a folder, all or none.
//!
//! **Guaranteed:** the same account gives the same bytes; no clock, no machine, no path outside the project. Nothing is
//! computed here: every number comes from the account, and is only chosen and written.

mod explain;
mod json;
mod markdown;
mod mathml;
mod numbers;
mod page;
mod plot;
mod summary;
mod tally;
mod tex;
mod text;
mod write;

pub use explain::explain;
pub use json::json;
pub use markdown::markdown;
pub use page::page;
pub use summary::{exceptions, summary};
pub use tex::tex;
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
