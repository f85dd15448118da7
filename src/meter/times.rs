//! How many times the usual work a run may take.
//!
//! **In:** what a user writes behind `--work`. **Out:** [`Times::of`] what is usual. In whole thousandths, so that the same text allows the
//! same work on every machine.

use std::fmt;
use std::str::FromStr;

/// So many thousandths are once.
const ONCE: u32 = 1000;

/// So many times what is usual: from a thousandth to a million.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Times(u32);

impl Default for Times {
    fn default() -> Times {
        Times(ONCE)
    }
}

impl Times {
    /// So many times something.
    pub fn of(self, usual: u64) -> u64 {
        let all = u128::from(usual) * u128::from(self.0) / u128::from(ONCE);
        u64::try_from(all).unwrap_or(u64::MAX)
    }

    /// Ten times as many.
    pub fn tenfold(self) -> Times {
        Times(self.0.saturating_mul(10))
    }
}

impl FromStr for Times {
    type Err = String;

    fn from_str(text: &str) -> Result<Times, String> {
        let thousandths = text.trim().parse::<f64>().map_or(0.0, |times| (times * f64::from(ONCE)).round());
        match (1.0..=1e9).contains(&thousandths) {
            // A whole number in the range of the type.
            true => Ok(Times(thousandths as u32)),
            false => Err("a number from 0.001 to 1000000 is expected".to_owned()),
        }
    }
}

impl fmt::Display for Times {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", f64::from(self.0) / f64::from(ONCE))
    }
}
