//! Exact rationals as a number type, for witnesses that can be checked by hand.

use dashu_int::ops::{BitTest, SquareRootRem};
use number::{NoValue, Op, Rational};

/// A rational number; a root exists only of squares of rationals, transcendental functions never.
#[derive(Clone, Debug, PartialEq)]
pub struct Exact(pub Rational);

/// Witnesses longer than this are no use to a reader.
const LONGEST: usize = 2048;

fn short(r: Rational) -> Result<Exact, NoValue> {
    let bits = r.numerator().bit_len().max(r.denominator().bit_len());
    if bits <= LONGEST { Ok(Exact(r)) } else { Err(NoValue::Indeterminate) }
}

/// √r, if it is rational.
pub fn rational_root(r: &Rational) -> Option<Rational> {
    let (sign, top) = r.numerator().clone().into_parts();
    if sign == dashu_int::Sign::Negative {
        return None;
    }
    let (a, rest_a) = top.sqrt_rem();
    let (b, rest_b) = r.denominator().sqrt_rem();
    (rest_a == dashu_int::UBig::ZERO && rest_b == dashu_int::UBig::ZERO).then(|| Rational::from(a) / Rational::from(b))
}

impl number::Uniform for Exact {
    type Context = ();

    fn blank(_: &()) -> Exact {
        Exact(Rational::ZERO)
    }
    /// Rationals have the operations that are written out, and no other.
    fn rule(&mut self, _: &(), _: Op, _: &Exact, _: &Exact) -> Result<(), NoValue> {
        Err(NoValue::Unsupported)
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        *self = short(r.clone())?;
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        Err(NoValue::Unsupported)
    }
    fn restrict(&mut self, _: &(), a: &Exact, _: &Exact) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    fn powi(&mut self, _: &(), a: &Exact, n: i32) -> Result<(), NoValue> {
        if n < 0 && a.0 == Rational::ZERO {
            return Err(NoValue::OutOfDomain);
        }
        let bits = a.0.numerator().bit_len().max(a.0.denominator().bit_len());
        if bits.saturating_mul(n.unsigned_abs() as usize) > 4 * LONGEST {
            return Err(NoValue::Indeterminate);
        }
        *self = short(a.0.pow(n as isize))?;
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &Exact) -> Result<(), NoValue> {
        *self = Exact(-a.0.clone());
        Ok(())
    }
    fn sqrt(&mut self, _: &(), a: &Exact) -> Result<(), NoValue> {
        if a.0 < Rational::ZERO {
            return Err(NoValue::OutOfDomain);
        }
        *self = Exact(rational_root(&a.0).ok_or(NoValue::Unsupported)?);
        Ok(())
    }
    fn abs(&mut self, _: &(), a: &Exact) -> Result<(), NoValue> {
        *self = Exact(if a.0 < Rational::ZERO { -a.0.clone() } else { a.0.clone() });
        Ok(())
    }
    fn add(&mut self, _: &(), a: &Exact, b: &Exact) -> Result<(), NoValue> {
        *self = short(&a.0 + &b.0)?;
        Ok(())
    }
    fn sub(&mut self, _: &(), a: &Exact, b: &Exact) -> Result<(), NoValue> {
        *self = short(&a.0 - &b.0)?;
        Ok(())
    }
    fn mul(&mut self, _: &(), a: &Exact, b: &Exact) -> Result<(), NoValue> {
        *self = short(&a.0 * &b.0)?;
        Ok(())
    }
    fn div(&mut self, _: &(), a: &Exact, b: &Exact) -> Result<(), NoValue> {
        if b.0 == Rational::ZERO {
            return Err(NoValue::OutOfDomain);
        }
        *self = short(&a.0 / &b.0)?;
        Ok(())
    }
}
