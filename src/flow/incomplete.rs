//! Why zeros on a stretch of time are not known.

use number::NoValue;

/// Why zeros on a stretch of time are not known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Incomplete {
    /// The expression has no value there.
    NoValue {
        /// From when.
        start: f64,
        /// To when.
        end: f64,
        /// Why.
        reason: NoValue,
    },
    /// The expression stays within its error of 0 there.
    Vanishing {
        /// From when.
        start: f64,
        /// To when.
        end: f64,
    },
    /// The expression is not resolved by polynomials there.
    Unresolved {
        /// From when.
        start: f64,
        /// To when.
        end: f64,
    },
}

impl Incomplete {
    /// From when to when.
    pub fn stretch(&self) -> (f64, f64) {
        match *self {
            Incomplete::NoValue { start, end, .. }
            | Incomplete::Vanishing { start, end }
            | Incomplete::Unresolved { start, end } => (start, end),
        }
    }
}
