//! `rederive` checks derivations.
//!
//! The path of a formula, and the rooms it goes through:
//!
//! ```text
//! derivation/ → latex/ → expr/ → tape/ → flow/ → check/ → report/
//!                                 ↑ number/ ↑
//! ```
pub mod check;
pub mod derivation;
pub mod diag;
pub mod expr;
pub mod flow;
pub mod latex;
pub mod number;
pub mod report;
pub mod tape;
