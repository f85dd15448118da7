//! What a claim says of its formulas, for the headings of every kind of report.
//!
//! **In:** a claim, and the number of one of its formulas. **Out:** what is said of this formula, in words without an end; or
//! that it is the name of something.

use derivation::{Claim, FormKind};
use findings::ClaimAccount;

/// What is said of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Heading {
    /// These words; names in them are formulas between dollars.
    Words(String),
    /// It names the system that the motion solves.
    System,
    /// It names the trajectory whose motion it is.
    Trajectory,
}

/// The form of the claim that a formula belongs to, and what is said of the formula. Of a claim that the file does not declare, that it
/// holds at every time.
pub(super) fn heading(claim: &ClaimAccount, declared: Option<&Claim>, formula: usize) -> (FormKind, Heading) {
    let kind = declared.and_then(|d| d.formulas.get(formula)).map_or(FormKind::Always, |f| f.kind);
    let over = claim.region.as_ref().map(|region| super::region::heading(kind, region));
    if let Some(words) = over.or_else(|| declared.and_then(super::family::compared)) {
        return (kind, Heading::Words(words));
    }
    let heading = match kind {
        FormKind::Solves => Heading::System,
        FormKind::SameMotion => Heading::Trajectory,
        kind => Heading::Words(kind.heading().to_owned()),
    };
    (kind, heading)
}
