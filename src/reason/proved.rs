//! What formulas for a motion, and its start, show exactly.

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// What is proved of a claim on a motion.
#[derive(Clone, Debug, PartialEq, Error, Serialize, Deserialize)]
pub enum Proving {
    #[error("whether there is a value near t = {0} is open: a rate may have none")]
    RateOpen(f64),
    #[error("by the initial values, at t = {0} exactly")]
    ByStart(f64),
    #[error("with the formulas of the motion put in, it divides by 0 at t = {0} exactly")]
    DividesByZero(f64),
    /// Both sides, which differ by less than numbers of binary64 show where that is said.
    #[error("with the formulas of the motion put in it is an {} in time alone, whose sides differ for certain at t = {t}{}", if *.equation { "equation" } else { "inequality" }, if *.unseen { ", by less than binary64 shows" } else { "" })]
    Differ { equation: bool, t: f64, unseen: bool },
}
