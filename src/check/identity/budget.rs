//! Rational coefficients whose arithmetic is counted, so that a computation of unforeseeable length ends.
//!
//! The count depends on the operands alone: not on the clock, the machine or the number of threads. So whether a certificate
//! is found does not, either.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::cell::Cell;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

thread_local! {
    /// Work that is left to the computation of this thread, `None` outside of one.
    static LEFT: Cell<Option<u64>> = const { Cell::new(None) };
}

/// The work of a computation is used up.
struct Exhausted;

/// Runs a computation on [`Coefficient`]s, and stops it when its work exceeds `work`: one unit for each operation, and one
/// for each product of 64-bit words in it. Gives what the computation gave, if it came to its end, and the work that is left.
pub(super) fn within<R>(work: u64, computation: impl FnOnce() -> R) -> (Option<R>, u64) {
    let before = LEFT.replace(Some(work));
    let outcome = catch_unwind(AssertUnwindSafe(computation));
    let left = LEFT.replace(before).unwrap_or(0);
    match outcome {
        Ok(value) => (Some(value), left),
        Err(payload) if payload.is::<Exhausted>() => (None, 0),
        Err(payload) => resume_unwind(payload),
    }
}

fn charge(units: u64) {
    if let Some(left) = LEFT.get() {
        match left.checked_sub(units) {
            Some(rest) => LEFT.set(Some(rest)),
            None => {
                LEFT.set(Some(0));
                // No panic: nothing is printed, and `within` catches it.
                resume_unwind(Box::new(Exhausted));
            }
        }
    }
}

/// A rational number.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Coefficient(pub(super) BigRational);

fn words(r: &BigRational) -> u64 {
    let of = |n: &BigInt| n.bits() / 64 + 1;
    of(r.numer()) + of(r.denom()) - 1
}

fn charge_for(a: &Coefficient, b: &Coefficient) {
    charge(words(&a.0).saturating_mul(words(&b.0)));
}

macro_rules! counted {
    ($($trait:ident $name:ident;)*) => {
        $( impl $trait for Coefficient {
            type Output = Coefficient;
            fn $name(self, other: Coefficient) -> Coefficient {
                charge_for(&self, &other);
                Coefficient(self.0.$name(other.0))
            }
        } )*
    };
}

counted! { Add add; Sub sub; Mul mul; Div div; }

impl Neg for Coefficient {
    type Output = Coefficient;
    fn neg(self) -> Coefficient {
        Coefficient(-self.0)
    }
}

impl Zero for Coefficient {
    fn zero() -> Coefficient {
        Coefficient(BigRational::zero())
    }
    fn is_zero(&self) -> bool {
        charge(1);
        self.0.is_zero()
    }
}

impl One for Coefficient {
    fn one() -> Coefficient {
        Coefficient(BigRational::one())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn power(n: u32) -> Coefficient {
        let three = Coefficient(BigRational::from_integer(BigInt::from(3)));
        (0..n).fold(Coefficient::one(), |a, _| a * three.clone())
    }

    #[test]
    fn a_computation_ends_when_its_work_is_used_up() {
        let (value, left) = within(1000, || power(40));
        assert_eq!(value, Some(power(40)));
        assert!(left < 1000 && left > 800, "{left}");
        assert_eq!(within(30, || power(40)).0, None);
        // Outside of a budget nothing is counted, also after one has ended.
        assert_eq!(within(30, || power(20)).0, Some(power(20)));
        power(10_000);
    }

    #[test]
    fn large_numbers_cost_more() {
        let work = |n: u32| 10_000_000 - within(10_000_000, || power(n)).1;
        assert_eq!(work(20), 20);
        assert!(work(1000) > 10_000, "{}", work(1000));
        assert_eq!(work(1000), work(1000));
    }

    #[test]
    fn other_panics_pass_through() {
        let caught = catch_unwind(|| within(10, || resume_unwind(Box::new("other"))));
        assert!(caught.is_err_and(|p| p.is::<&str>()));
    }
}
