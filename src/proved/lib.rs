//! Claims for all values: what follows from what is given, by proof.
//!
//! **In:** a claim with what it is said to follow from; or a motion that is given by formulas. **Out:** an
//! [`IdentityAccount`](findings::IdentityAccount) for each [`step`], with the evidence of [both routes](agreement); verdicts of the
//! strength *proved* or *certified* where a motion is known by [formulas](by_formula).
//!
//! **Guaranteed:** what is handed to the proofs as given is what the file gives; two routes that contradict each other are a defect,
//! and no answer.

#![forbid(unsafe_code)]

use ::{derivation, diag, expr, findings, latex, number, verdict};

pub mod agreement;
mod alone;
pub mod by_formula;
pub mod conditional;
pub mod existence;
mod motions;
pub mod proposition;
pub mod replay;
mod said;
pub mod step;
