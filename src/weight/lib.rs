//! What the evidence is worth: which altered formulas the same motions reject, what should have been printed, and which conditions
//! separate the motions on which a claim holds from those on which it fails.
//!
//! **In:** claims with their verdicts, and the motions on which they were tried. **Out:** the accounts of [`variant`] and of
//! [`separation`].
//!
//! **Guaranteed:** no verdict is changed here: it is only said what it is worth.

#![forbid(unsafe_code)]

use ::{derivation, expr, findings, flow, latex, number, verdict};

pub mod separation;
pub mod variant;
