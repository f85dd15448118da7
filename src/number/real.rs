//! binary64: the plain real numbers of the machine.
//!
//! Basic operations and √ are those of IEEE 754; elementary functions are those of [`elementary`](super::elementary), powers come
//! from `pxfm`: every machine computes the same bits. A result that is not finite is not a value.

use super::elementary::{self, one};
use super::{NoValue, Number, Rational};

/// Checks that a result is a number: anything else is an overflow, as domains are checked before.
#[inline]
fn finite(x: f64) -> Result<f64, NoValue> {
    if x.is_finite() { Ok(x) } else { Err(NoValue::Indeterminate) }
}

/// Checks the domain of a function before it is evaluated.
#[inline]
fn domain(inside: bool) -> Result<(), NoValue> {
    if inside { Ok(()) } else { Err(NoValue::OutOfDomain) }
}

/// aⁿ by repeated squaring; every number type that needs the value of a power uses this order of operations.
#[inline]
pub(super) fn powi(a: f64, n: i32) -> f64 {
    let (mut base, mut e, mut acc) = (a, n.unsigned_abs(), 1.0);
    while e > 0 {
        if e & 1 == 1 {
            acc *= base;
        }
        base *= base;
        e >>= 1;
    }
    // The reciprocal of an overflow is not 0 but unknown.
    if n >= 0 {
        acc
    } else if acc.is_infinite() {
        f64::NAN
    } else {
        1.0 / acc
    }
}

/// More iterations of the arithmetic–geometric mean than any two numbers need: one per halving of the exponent of their
/// ratio, at most 11, and about five more until they agree.
pub(super) const AGM_ITERATIONS: u32 = 32;

/// The arithmetic–geometric mean of two positive numbers; 0 when one of them is 0.
pub(super) fn agm(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    let (mut a, mut b) = (a, b);
    for _ in 0..AGM_ITERATIONS {
        if (a - b).abs() <= 4.0 * f64::EPSILON * a.abs() {
            break;
        }
        let product = a * b;
        // Outside this range the product has lost digits, or overflowed.
        let in_range = (1e-290..=f64::MAX).contains(&product);
        let geometric = if in_range { product.sqrt() } else { a.sqrt() * b.sqrt() };
        (a, b) = (0.5 * a + 0.5 * b, geometric);
    }
    0.5 * a + 0.5 * b
}

impl Number for f64 {
    type Context = ();

    fn blank(_: &()) -> f64 {
        0.0
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        *self = finite(r.to_f64().value())?;
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        *self = std::f64::consts::PI;
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &f64, _: &f64) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    fn powi(&mut self, _: &(), a: &f64, n: i32) -> Result<(), NoValue> {
        domain((n >= 0 || *a != 0.0) && !a.is_nan())?;
        *self = finite(powi(*a, n))?;
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(-*a)?;
        Ok(())
    }
    fn sqrt(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        domain(*a >= 0.0)?;
        *self = finite(a.sqrt())?;
        Ok(())
    }
    fn exp(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(one(elementary::Exp, [*a])[0])?;
        Ok(())
    }
    fn ln(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        domain(*a > 0.0)?;
        *self = finite(one(elementary::Ln, [*a])[0])?;
        Ok(())
    }
    fn sin(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(one(elementary::Sin, [*a])[0])?;
        Ok(())
    }
    fn cos(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(one(elementary::Cos, [*a])[0])?;
        Ok(())
    }
    fn tan(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(one(elementary::Tan, [*a])[0])?;
        Ok(())
    }
    fn arcsin(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        domain(a.abs() <= 1.0)?;
        *self = finite(one(elementary::Arcsin, [*a])[0])?;
        Ok(())
    }
    fn arccos(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        domain(a.abs() <= 1.0)?;
        *self = finite(one(elementary::Arccos, [*a])[0])?;
        Ok(())
    }
    fn arctan(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(one(elementary::Arctan, [*a])[0])?;
        Ok(())
    }
    fn sinh(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(one(elementary::Sinh, [*a])[0])?;
        Ok(())
    }
    fn cosh(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(one(elementary::Cosh, [*a])[0])?;
        Ok(())
    }
    fn tanh(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(one(elementary::Tanh, [*a])[0])?;
        Ok(())
    }
    fn abs(&mut self, _: &(), a: &f64) -> Result<(), NoValue> {
        *self = finite(a.abs())?;
        Ok(())
    }
    fn add(&mut self, _: &(), a: &f64, b: &f64) -> Result<(), NoValue> {
        *self = finite(a + b)?;
        Ok(())
    }
    fn sub(&mut self, _: &(), a: &f64, b: &f64) -> Result<(), NoValue> {
        *self = finite(a - b)?;
        Ok(())
    }
    fn mul(&mut self, _: &(), a: &f64, b: &f64) -> Result<(), NoValue> {
        *self = finite(a * b)?;
        Ok(())
    }
    fn div(&mut self, _: &(), a: &f64, b: &f64) -> Result<(), NoValue> {
        domain(*b != 0.0)?;
        *self = finite(a / b)?;
        Ok(())
    }
    fn pow(&mut self, _: &(), a: &f64, b: &f64) -> Result<(), NoValue> {
        domain((*a > 0.0 || (*a == 0.0 && *b > 0.0)) && !b.is_nan())?;
        *self = finite(pxfm::f_pow(*a, *b))?;
        Ok(())
    }
    fn arctan2(&mut self, _: &(), y: &f64, x: &f64) -> Result<(), NoValue> {
        domain(*y != 0.0 || *x != 0.0)?;
        *self = finite(one(elementary::Arctan2, [*y, *x])[0])?;
        Ok(())
    }
    fn agm(&mut self, _: &(), a: &f64, b: &f64) -> Result<(), NoValue> {
        domain(*a >= 0.0 && *b >= 0.0)?;
        *self = finite(agm(*a, *b))?;
        Ok(())
    }
}
