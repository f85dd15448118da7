//! The kernel: what is true, what is known, what is said. The only crate that can make a [`Verdict`].
//!
//! Three layers that are never mixed. **Truth** ([`Truth`], [`Proposition`]): what a claim denotes; knows no method.
//! **Knowledge** ([`Possible`], [`Finding`]): what methods leave possible of the parts of a claim, with [`Evidence`] as plain
//! data; knows no form of claim. **Verdict** ([`Verdict::decide`]): one function of the two.
//!
//! **In:** propositions and findings. **Out:** verdicts. **Guaranteed:** `holds` is said only where `false` and `void` are
//! excluded, `fails` only where the others are; of a strength only with evidence of that strength. The crate imports
//! [`reason`](reason::Reason) alone, which it passes on and does not read.
//! `docs/semantics.md` teaches what is written here.

#![forbid(unsafe_code)]

mod decision;
mod evidence;
mod proposition;
mod truth;

pub use decision::{Finding, Outcome, Strength, Verdict};
pub use evidence::{
    Enclosed, Evidence, Exclusion, Obstacle, PartShown, Proof, Residual, ResidualPoint, Residuals, Rise, Witness,
};
pub use proposition::{Proposition, Quantifier};
pub use truth::{Possible, Truth};
