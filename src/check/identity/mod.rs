//! Identities, for all values of all symbols.
//!
//! placeholder
mod exact;
mod field;
mod growth;
mod linear;
mod lower;
mod outcome;
mod polynomial;
mod prepare;
mod probe;
mod prove;
mod roots;
mod sign;
mod solve;
mod witness;

pub use outcome::{Condition, Identity, Options, Point, PointValue, Premises, Proof, Reason, Refutation, Side};
pub use prove::identity_test;
