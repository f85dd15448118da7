//! `rederive` checks derivations: which claims of a paper hold, along which trajectories, and how strongly.
//!
//! A *derivation file* names a paper's symbols, systems of equations, trajectories and claims, with the formulas in LaTeX as
//! they are printed. [`derivation::load`] reads it, [`check::check`] decides every claim on every trajectory, [`report`]
//! writes down what was found.
//!
//! # The path of a formula
//!
//! ```text
//! derivation/ → latex/ → expr/ → flow/, proof/ → check/ → report/
//!                          ↑ number/ ↑
//! ```
//!
//! | room | what happens there | imports |
//! |---|---|---|
//! | [`diag`] | a problem at a place of a file, and how it is shown | – |
//! | [`number`] | what a value can be: binary64, duals, error bounds, series, lanes, finite fields | – |
//! | [`expr`] | the shared graph of expressions, derivatives, printing; [`tape`]: graph → straight-line program; the one evaluation loop | number |
//! | [`latex`] | formula text → expressions, or a refusal with its place | diag, expr |
//! | [`derivation`] | the TOML file as written, every formula read | diag, expr, latex |
//! //! | [`flow`] | vector fields, trajectories, observables, events | expr, tape, number |
//! | [`check`] | claims → verdicts: along motions, and for all values | diag, derivation, latex, flow, tape, expr, number |
//! | [`paper`] | the paper's LaTeX source beside the derivation file | diag, derivation, latex |
//! | [`report`] | verdicts → text, JSON, Markdown, HTML, LaTeX; no arithmetic | diag, expr, latex, derivation, check, paper |
//!
//! Each room is a crate, with its own `Cargo.toml`; `tests/layering.rs` keeps these rules.

pub use ::{check, derivation, diag, expr, flow, latex, number, paper, proof, report};
pub use expr::tape;
