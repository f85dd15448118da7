//! Claims against trajectories: the only room that can make a [`Verdict`].

mod account;
mod verdict;

pub use account::{Account, ClaimAccount, Measurement, PairAccount, Summary, TrajectoryAccount};
pub use verdict::{Evidence, Exclusion, Outcome, Residual, Strength, Verdict, Witness};

// Stand-in for the checks themselves, replaced when they are merged.
mod stub;
pub use stub::{CheckError, Options, check};

#[cfg(test)]
pub(crate) mod sample;
