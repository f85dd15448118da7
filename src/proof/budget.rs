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
    meter::charge(units.saturating_mul(20));
    if let Some(left) = LEFT.get() {
        match left.checked_sub(units) {
            Some(rest) => LEFT.set(Some(rest)),
            None => {
                LEFT.set(Some(0));
                meter::unwind(Exhausted, "work limit: the algebra of a proof takes more than it may");
            }
        }
    }
}

/// A rational number. Most that occur are small, and are computed with words.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Coefficient(Value);

/// Small wherever it can be: every number is written in one way.
#[derive(Clone, Debug, PartialEq)]
enum Value {
    /// Numerator and denominator in lowest terms, the denominator positive, the numerator above −2⁶³.
    Small(i64, i64),
    Large(Box<BigRational>),
}

impl From<BigRational> for Coefficient {
    fn from(r: BigRational) -> Coefficient {
        let small = |n: &BigInt| i64::try_from(n).ok().filter(|&n| n != i64::MIN);
        match (small(r.numer()), small(r.denom())) {
            (Some(n), Some(d)) => Coefficient(Value::Small(n, d)),
            _ => Coefficient(Value::Large(Box::new(r))),
        }
    }
}

/// n/d of coprime n and d > 0, where both are small.
fn small(n: i128, d: i128) -> Option<Coefficient> {
    let n = i64::try_from(n).ok().filter(|&n| n != i64::MIN)?;
    Some(Coefficient(Value::Small(n, i64::try_from(d).ok()?)))
}

fn common_divisor(a: i64, b: i64) -> i64 {
    let (mut a, mut b) = (a.unsigned_abs(), b.unsigned_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    // Of two numbers below 2⁶³ one of which is not 0.
    (a as i64).max(1)
}

/// a/b + c/d, where that stays small.
fn small_sum((a, b): (i64, i64), (c, d): (i64, i64)) -> Option<Coefficient> {
    if b == 1 && d == 1 {
        return small(i128::from(a) + i128::from(c), 1);
    }
    let wide = |x: i64, y: i64| i128::from(x) * i128::from(y);
    let (n, d) = (wide(a, d) + wide(c, b), wide(b, d));
    let (n, d) = (i64::try_from(n).ok()?, i64::try_from(d).ok()?);
    if n == i64::MIN {
        return None;
    }
    let k = common_divisor(n, d);
    small(i128::from(n / k), i128::from(d / k))
}

/// a/b · c/d, where that stays small.
fn small_product((a, b): (i64, i64), (c, d): (i64, i64)) -> Option<Coefficient> {
    let (k, l) = (common_divisor(a, d), common_divisor(c, b));
    let wide = |x: i64, y: i64| i128::from(x) * i128::from(y);
    let (n, d) = (wide(a / k, c / l), wide(b / l, d / k));
    small(n, d)
}

impl Coefficient {
    /// The number.
    pub(super) fn big(&self) -> BigRational {
        match &self.0 {
            Value::Small(n, d) => BigRational::new_raw(BigInt::from(*n), BigInt::from(*d)),
            Value::Large(r) => (**r).clone(),
        }
    }

    fn small(&self) -> Option<(i64, i64)> {
        match self.0 {
            Value::Small(n, d) => Some((n, d)),
            Value::Large(_) => None,
        }
    }
}

fn words(c: &Coefficient) -> u64 {
    let of = |n: &BigInt| n.bits() / 64 + 1;
    match &c.0 {
        Value::Small(..) => 1,
        Value::Large(r) => of(r.numer()) + of(r.denom()) - 1,
    }
}

fn charge_for(a: &Coefficient, b: &Coefficient) {
    charge(words(a).saturating_mul(words(b)));
}

macro_rules! counted {
    ($($trait:ident $name:ident $small:expr;)*) => {
        $( impl $trait for Coefficient {
            type Output = Coefficient;
            fn $name(self, other: Coefficient) -> Coefficient {
                charge_for(&self, &other);
                if let (Some(a), Some(b)) = (self.small(), other.small())
                    && let Some(found) = $small(a, b)
                {
                    return found;
                }
                Coefficient::from(self.big().$name(other.big()))
            }
        } )*
    };
}

counted! {
    Add add small_sum;
    Sub sub |a, (c, d): (i64, i64)| small_sum(a, (-c, d));
    Mul mul small_product;
    // Division by 0 is that of the large numbers.
    Div div |a, (c, d): (i64, i64)| if c == 0 { None } else { small_quotient(a, (c, d)) };
}

/// (a/b) / (c/d) for c ≠ 0, where that stays small.
fn small_quotient((a, b): (i64, i64), (c, d): (i64, i64)) -> Option<Coefficient> {
    // a/b · d/c with the sign of c in the numerator.
    let (c, d) = if c < 0 { (-c, -d) } else { (c, d) };
    small_product((a, b), (d, c))
}

impl Neg for Coefficient {
    type Output = Coefficient;
    fn neg(self) -> Coefficient {
        match self.0 {
            Value::Small(n, d) => Coefficient(Value::Small(-n, d)),
            Value::Large(r) => Coefficient::from(-*r),
        }
    }
}

impl Zero for Coefficient {
    fn zero() -> Coefficient {
        Coefficient(Value::Small(0, 1))
    }
    fn is_zero(&self) -> bool {
        charge(1);
        matches!(self.0, Value::Small(0, _))
    }
}

impl One for Coefficient {
    fn one() -> Coefficient {
        Coefficient(Value::Small(1, 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn power(n: u32) -> Coefficient {
        let three = Coefficient::from(BigRational::from_integer(BigInt::from(3)));
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
    fn small_numbers_are_computed_like_large_ones() {
        let whole: Vec<i64> =
            vec![0, 1, -1, 2, -3, 6, 12, 35, i64::MAX, -i64::MAX, i64::MAX - 1, 1 << 62, -(1 << 62), 3 << 40, 1 << 32];
        let mut all = Vec::new();
        for &n in &whole {
            for &d in whole.iter().filter(|&&d| d != 0) {
                all.push(BigRational::new(BigInt::from(n), BigInt::from(d)));
            }
        }
        all.push(BigRational::new(BigInt::from(i64::MIN), BigInt::from(3)));
        let of = |r: &BigRational| Coefficient::from(r.clone());
        for a in &all {
            assert_eq!(of(a).big(), *a);
            assert_eq!(-of(a), of(&-a.clone()));
            assert_eq!(Zero::is_zero(&of(a)), a.is_zero());
            for b in &all {
                assert_eq!(of(a) + of(b), of(&(a + b)), "{a} + {b}");
                assert_eq!(of(a) - of(b), of(&(a - b)), "{a} - {b}");
                assert_eq!(of(a) * of(b), of(&(a * b)), "{a} * {b}");
                if !b.is_zero() {
                    assert_eq!(of(a) / of(b), of(&(a / b)), "{a} / {b}");
                }
            }
        }
        assert!(catch_unwind(|| of(&all[1]) / Coefficient::zero()).is_err());
    }

    #[test]
    fn other_panics_pass_through() {
        let caught = catch_unwind(|| within(10, || resume_unwind(Box::new("other"))));
        assert!(caught.is_err_and(|p| p.is::<&str>()));
    }
}
