//! Which sign of ± a formula with it holds for.

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The sign in the place of ±.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error, Serialize, Deserialize)]
pub enum Sign {
    #[error("+")]
    Plus,
    #[error("−")]
    Minus,
}

/// A stretch of time on which one sign alone serves.
#[derive(Clone, Copy, Debug, PartialEq, Error, Serialize, Deserialize)]
#[error("{sign} on [{from:.4}, {to:.4}]")]
pub struct SignRun {
    pub sign: Sign,
    pub from: f64,
    pub to: f64,
}

/// Which sign serves along a motion, at the samples.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum SignsAlong {
    #[error("either sign")]
    Either,
    #[error("{0} throughout")]
    Throughout(Sign),
    /// The first runs, and how many more there are.
    #[error("{}", changing(.runs, *.more))]
    Changing { runs: Vec<SignRun>, more: usize },
}

/// Most runs of a motion that are kept.
const MOST_RUNS: usize = 6;

impl SignsAlong {
    /// Of the runs on which one sign alone serves, in their order.
    pub fn of(mut runs: Vec<SignRun>) -> SignsAlong {
        match runs.as_slice() {
            [] => SignsAlong::Either,
            [only] => SignsAlong::Throughout(only.sign),
            _ => {
                let more = runs.len().saturating_sub(MOST_RUNS);
                runs.truncate(MOST_RUNS);
                SignsAlong::Changing { runs, more }
            }
        }
    }
}

fn changing(runs: &[SignRun], more: usize) -> String {
    let listed: Vec<String> = runs.iter().map(ToString::to_string).collect();
    let more = if more > 0 { format!(" and {more} more changes") } else { String::new() };
    format!("{}{more}", listed.join(", "))
}

/// Which sign a proof for all values is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error, Serialize, Deserialize)]
pub enum SignsProved {
    #[error("with either sign")]
    Either,
    #[error("with the upper sign")]
    Upper,
    #[error("with the lower sign")]
    Lower,
    #[error("with one sign or the other at each point; neither was proved for all points")]
    PointByPoint,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_many_changes_the_first_are_kept() {
        let run = |i: usize| {
            let sign = if i.is_multiple_of(2) { Sign::Plus } else { Sign::Minus };
            SignRun { sign, from: i as f64, to: i as f64 + 0.5 }
        };
        let words = |n: usize| SignsAlong::of((0..n).map(run).collect()).to_string();
        assert_eq!(words(0), "either sign");
        assert_eq!(words(1), "+ throughout");
        assert_eq!(words(2), "+ on [0.0000, 0.5000], − on [1.0000, 1.5000]");
        assert!(!words(6).contains("more"));
        assert!(words(8).ends_with("− on [5.0000, 5.5000] and 2 more changes"), "{}", words(8));
    }
}
