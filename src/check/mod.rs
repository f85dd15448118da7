//! Claims against trajectories: the only room that can make a [`Verdict`].

mod account;
pub mod identity;
mod verdict;

pub use account::{Account, ClaimAccount, Measurement, PairAccount, Summary, TrajectoryAccount};
pub use verdict::{Evidence, Exclusion, Outcome, Residual, Strength, Verdict, Witness};
