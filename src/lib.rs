//! `rederive` checks derivations: which claims of a paper hold, along which trajectories, and how strongly.
//!
//! A *derivation file* names a paper's symbols, systems of equations, trajectories and claims, with the formulas in LaTeX as
//! they are printed. [`derivation::load`] reads it, [`check::check`] decides every claim on every trajectory, [`report`]
//! writes down what was found.
//!
//! # The path of a formula
//!
//! ```text
//! derivation/ → latex/ → expr/ → tape/ → flow/ → check/ → report/
//!                                 ↑ number/ ↑
//! ```
//!
//! | room | what happens there | imports |
//! |---|---|---|
//! | [`shown`] | texts that strangers wrote, as people may see them | – |
//! | [`files`] | what may be read and written, and how | – |
//! | [`diag`] | a problem at a place of a file, and how it is shown | shown |
//! | [`number`] | what a value can be: binary64, duals, error bounds, series, lanes, finite fields | – |
//! | [`expr`] | the shared graph of expressions, derivatives, printing | number |
//! | [`latex`] | formula text → expressions, or a refusal with its place | diag, expr, shown |
//! | [`derivation`] | the TOML file as written, every formula read | diag, expr, files, latex, shown |
//! | [`tape`] | graph → straight-line program; the one evaluation loop | expr, number |
//! | [`flow`] | vector fields, trajectories, observables, events | expr, tape, number |
//! | [`check`] | claims → verdicts: along motions, and for all values | diag, derivation, latex, flow, tape, expr, number |
//! | [`paper`] | the paper's LaTeX source beside the derivation file | diag, derivation, files, latex, shown |
//! | [`report`] | verdicts → text, JSON, Markdown, HTML, LaTeX; no arithmetic | diag, expr, latex, derivation, check, paper, shown |
//!
//! `tests/layering.rs` keeps these rules.

#[cfg(test)]
extern crate self as rederive;

/// The notation of the tests, for those beside the code.
#[cfg(test)]
#[path = "../tests/flow_support/mod.rs"]
mod flow_support;

pub mod check;
pub mod derivation;
pub mod diag;
pub mod expr;
pub mod files;
pub mod flow;
pub mod latex;
pub mod number;
pub mod paper;
pub mod report;
pub mod shown;
pub mod tape;
