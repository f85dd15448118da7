//! `rederive` checks derivations: which claims of a paper hold, along which trajectories, and how strongly.
//!
//! A *derivation file* names a paper's symbols, systems of equations, trajectories and claims, with the formulas in LaTeX as
//! they are printed. The program `rederive` checks such files; this is the library that it is built on.
//!
//! # A first check
//!
//! A [`Session`] reads the text of a derivation file. What it finds is plain data: one [`Finding`] for each claim on each
//! motion, with its verdict and how strong that is.
//!
//! ```
//! use rederive::{Ask, Outcome, Session, Strength};
//!
//! let text = r"
//! [derivation]
//! title = 'A spring'
//! concerns = 'A textbook'
//!
//! [symbols]
//! 't' = { role = 'time' }
//! 'x' = { role = 'state' }
//! 'v' = { role = 'state' }
//!
//! [system.spring]
//! states = ['x', 'v']
//! equations = ['\dot x=v', '\dot v=-x']
//!
//! [[trajectory]]
//! id = 'pulled'
//! system = 'spring'
//! initial = { 'x' = 1, 'v' = 0 }
//! span = [0, 10]
//!
//! [[claim]]
//! id = 'energy'
//! says = 'The energy is what it was'
//! always = ['x^2+v^2=x(0)^2+v(0)^2']
//!
//! [[claim]]
//! id = 'rest'
//! says = 'It stays where it is'
//! always = ['x=1']
//! ";
//! let session = Session::open("spring.toml", text).expect("no problems");
//! let findings = session.check(&Ask::default(), &|_, _| {})?;
//! let [energy, rest] = &findings.all()[..] else { panic!("two claims on one motion") };
//!
//! assert!(matches!(energy.outcome, Outcome::Holds(strength) if strength >= Strength::Enclosed));
//! assert!(matches!(rest.outcome, Outcome::Fails(_)));
//! // A failure has a point that can be checked by hand.
//! let witness = rest.witness.as_ref().expect("a witness");
//! assert!((witness.left - witness.t.cos()).abs() < 1e-9 && witness.right == 1.0);
//! # Ok::<(), rederive::Failure>(())
//! ```
//!
//! What the text gets wrong is a list of [`diag::Diagnostic`]s, each with its place and a hint:
//!
//! ```
//! let problems = rederive::Session::open("empty.toml", "[derivation]\ntitle = 'Nothing'").unwrap_err();
//! assert_eq!(problems[0].code, "derivation::missing-key");
//! assert!(rederive::diag::render(&problems, false).contains("empty.toml:"));
//! ```
//!
//! # While a file is written
//!
//! [`Session::change`] takes the next state of the text, [`Session::check_again`] finds what is not known from the one before.
//!
//! # What is stable
//!
//! Nothing is promised before version 1.0. What will be is what this page names: [`Session`], [`Ask`], [`Findings`],
//! [`Finding`], [`Question`], [`Answer`], [`Failure`]. The crates below serve them.
//!
//! # The path of a formula
//!
//! ```text
//! derivation/ → latex/ → expr/ → claim/ → sampled/, enclosed/, proved/, boxes/ → check/ → report/
//!                          ↑ number/, flow/, proof/
//! ```
//!
//! | crate | what happens there | imports |
//! |---|---|---|
//! | [`files`] | what may be read and written, and how | – |
//! | [`diag`] | a problem at a place of a file, and how it is shown; texts of strangers, as people may see them | – |
//! | [`number`] | what a value can be: binary64, duals, error bounds, series, lanes, finite fields | – |
//! | [`expr`] | the shared graph of expressions, derivatives, printing; [`tape`]: graph → straight-line program; the one evaluation loop | number |
//! | [`latex`] | formula text → expressions, or a refusal with its place | diag, expr |
//! | [`derivation`] | the TOML file as written, every formula read | diag, expr, files, latex |
//! | [`flow`] | vector fields, trajectories, observables, events | expr, number |
//! | [`proof`] | identities for all values: proved, refuted, undecided | expr, number |
//! | [`units`] | whether formulas are consistent in their units | derivation, expr, latex |
//! | [`reason`] | why a verdict is as it is, as data; the only place where reasons become words | number |
//! | [`verdict`] | the kernel: what is true, what is known, what is said; alone makes verdicts | reason |
//! | [`findings`] | what was found, as plain data | checker, derivation, expr, proof, reason, units, verdict |
//! | [`claim`] | a claim, compiled to comparisons | derivation, diag, expr, flow, latex, number, reason, verdict |
//! | [`proved`] | claims for all values | claim, findings, proof, units, and what these use |
//! | [`boxes`] | claims over ranges of values | claim, findings, proof, proved, and what these use |
//! | [`sampled`] | claims along motions, from samples | claim, findings, flow, and what these use |
//! | [`enclosed`] | claims for every time of a span | claim, findings, flow, sampled, and what these use |
//! | [`families`] | claims on many motions | claim, findings, proved, sampled, and what these use |
//! | [`weight`] | what the evidence is worth | boxes, claim, findings, proved, sampled, and what these use |
//! | [`check`] | the methods in their order, and what is known from before | all above |
//! | [`paper`] | the paper's LaTeX source beside the derivation file | diag, derivation, files, latex |
//! | [`lint`] | what follows, and what is wrong, of what a paper prints | diag, expr, latex, meter, number, paper, proof |
//! | [`report`] | verdicts → text, JSON, Markdown, HTML, LaTeX; no arithmetic | diag, expr, latex, derivation, findings, paper, reason |
//!
//! `ARCHITECTURE.md` has the map in full; `tests/layering.rs` keeps these rules.

#![forbid(unsafe_code)]

mod ask;
mod brief;
/// The command line, for programs that bring it along: one function, which takes the words of a command and gives its exit code.
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod cli;
mod conclusion;
pub mod config;
mod either_base;
pub mod look;
mod run;
mod session;
pub mod threads;

// The command line is written as a user of this library.
#[cfg(feature = "cli")]
extern crate self as rederive;

pub use ::{
    boxes, check, claim, derivation, diag, enclosed, expr, families, files, findings, flow, latex, lint, number, paper,
    proof, proved, reason, report, sampled, units, verdict, weight,
};
pub use ask::{Ask, Unknown};
pub use check::{Outcome, Rigor, Strength, Witness};
pub use conclusion::{Conclusion, Demand, Ending};
pub use expr::tape;
pub use run::{Detail, Document, Format, Run};
pub use session::{Answer, ClaimName, Failure, Finding, Findings, Question, Session};
pub use threads::threads;
