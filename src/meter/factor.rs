//! The factor by which a run may take more, or less, than the usual work.
//!
//! **In:** what a user writes behind `--work`. **Out:** [`WorkFactor::of`] what is usual. In whole thousandths, so that the same text allows the
//! same work on every machine.

use std::fmt;
use std::str::FromStr;

/// So many thousandths are once.
const ONCE: u32 = 1000;

/// A factor on the usual work and memory: from a thousandth to a million.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct WorkFactor(u32);

impl Default for WorkFactor {
    fn default() -> WorkFactor {
        WorkFactor(ONCE)
    }
}

impl WorkFactor {
    /// So many times something.
    pub fn of(self, usual: u64) -> u64 {
        let all = u128::from(usual) * u128::from(self.0) / u128::from(ONCE);
        u64::try_from(all).unwrap_or(u64::MAX)
    }

    /// Ten times as many.
    pub fn tenfold(self) -> WorkFactor {
        WorkFactor(self.0.saturating_mul(10))
    }
}

impl FromStr for WorkFactor {
    type Err = String;

    fn from_str(text: &str) -> Result<WorkFactor, String> {
        let thousandths = text.trim().parse::<f64>().map_or(0.0, |times| (times * f64::from(ONCE)).round());
        match (1.0..=1e9).contains(&thousandths) {
            // A whole number in the range of the type.
            true => Ok(WorkFactor(thousandths as u32)),
            false => Err("a number from 0.001 to 1000000 is expected".to_owned()),
        }
    }
}

impl fmt::Display for WorkFactor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", f64::from(self.0) / f64::from(ONCE))
    }
}
