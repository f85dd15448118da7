//! What a value can be.
//!
//! **In:** exact rationals and the operations of one table ([`Op`]). **Out:** the trait [`Number`], one implementation for
//! each arithmetic that a formula may be evaluated in, and [`NoValue`], the reason why an operation has no result.
//!
//! **Guaranteed:** an operation either yields a value of its mathematical function (to the accuracy that the number type
//! documents) or says [`NoValue`]; infinities and NaN are never values. The value part of a number with derivatives is the
//! same, bit for bit, as the value computed without them.
//!
//! **Why this way:** a formula is compiled once and evaluated by one loop; *what* the loop computes is the choice of a
//! number type. The table below generates the trait, so that an operation without an implementation in some number type
//! does not compile. Results are written in place: series and lanes then need no allocation in the loop.

#![forbid(unsafe_code)]

mod bounded;
mod bounded_lanes;
mod deviation;
mod double_double;
mod dual;
mod elementary;
mod finite;
mod growth;
mod interval;
mod jet;
mod lanes;
mod operation;
mod random;
mod real;
mod register;
mod scalar;
mod series;
mod shown;
mod slope;
mod wide;
mod wide_lanes;
mod wide_series;

pub use bounded::Bounded;
pub use bounded_lanes::BoundedLanes;
pub use dashu_ratio::RBig as Rational;
pub use double_double::DoubleDouble;
pub use finite::{Finite, FiniteField, is_prime};
pub use growth::{Growth, Recurrences};
#[cfg(any(test, debug_assertions))]
pub use interval::faults as interval_faults;
pub use interval::{Continuity, Decorated, Interval, Limit, NODES, Precise, PreciseModel, Tail, TaylorModel};
pub use jet::{Jet, Orders};
pub use lanes::{DualLanes, Lanes, Work, widely};
pub use operation::{Instruction, Number, Op, Uniform};
pub use random::Draws;
pub use scalar::Scalar;
pub use shown::six;

/// Why an operation has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
pub enum NoValue {
    /// The arguments lie outside the real domain of the function: √(−1), 1/0, arccos 2.
    OutOfDomain,
    /// A value may exist, but this number type cannot tell: the quotient by a quantity whose error bound contains 0, the
    /// derivative of √x at 0, a result too large for binary64.
    Indeterminate,
    /// The operation has no meaning in this number type: the sine of an element of a finite field.
    Unsupported,
}

impl std::fmt::Display for NoValue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            NoValue::OutOfDomain => "outside the real domain",
            NoValue::Indeterminate => "not determined at this precision",
            NoValue::Unsupported => "not supported in this arithmetic",
        })
    }
}

impl std::error::Error for NoValue {}
