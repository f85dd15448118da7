//! Limits of a run that its user sets, see [`meter`]: a time, memory, a flag that ends it, and how much counted work a piece of it takes.
//!
//! **In:** when a run must end, and what ends it from outside. **Out:** whether that is reached, asked between one piece of work and the
//! next, and within each. What is not done then is undecided, for this reason.

pub use meter::{Cancel, Limits, WorkFactor};
