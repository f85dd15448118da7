//! Numbers as unevaluated sums of two binary64 numbers: about 106 bits.
//!
//! **In:** such numbers. **Out:** results that are rounded to such numbers; sums, products, quotients and square roots are
//! off by a few units of 2⁻¹⁰⁴ of the sizes of their terms, exp, sin, cos, tan, sinh, cosh by not much more, **the other
//! functions by as much as binary64 is**. No error bound goes with them: the series of a motion is computed with them, and
//! how far it is from the motion is found afterwards, see [`PreciseModel`].
//!
//! **Why:** error-free transforms yield the part of a sum or a product that rounding loses, exactly ([Dekker 1971]); keeping
//! it costs some twenty operations, and no library of long numbers.
//!
//! [Dekker 1971]: https://doi.org/10.1007/BF01397083

use super::interval::round::{product_error, sum_error};
use super::{NoValue, Number, Op, Precise, PreciseModel, Rational, Scalar, scalar};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The sum of two numbers, the second of which is at most half a unit in the last place of the first.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// a + b without any error.
#[inline(always)]
pub(crate) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, sum_error(a, b, s))
}

/// a·b without any error, as long as nothing underflows or overflows.
#[inline(always)]
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    (p, product_error(a, b, p))
}

impl DoubleDouble {
    /// The sum of any two numbers, without error.
    #[inline(always)]
    pub fn new(a: f64, b: f64) -> DoubleDouble {
        let (high, low) = two_sum(a, b);
        DoubleDouble { high, low }
    }

    /// One binary64 number.
    pub const fn point(x: f64) -> DoubleDouble {
        DoubleDouble { high: x, low: 0.0 }
    }

    /// The number, rounded to binary64.
    #[inline(always)]
    pub fn high(&self) -> f64 {
        self.high
    }

    /// What rounding leaves out.
    #[inline(always)]
    pub fn low(&self) -> f64 {
        self.low
    }

    /// The middle of what a function is known to be.
    fn middle(&mut self, op: Op, a: &DoubleDouble) -> Result<(), NoValue> {
        let mut out = PreciseModel::ZERO;
        let a = PreciseModel::constant(&Precise::new(*a, 0.0));
        op.apply(&(), &mut out, &a, &a)?;
        *self = out.value().centre();
        Ok(())
    }
}

impl Add for DoubleDouble {
    type Output = DoubleDouble;
    #[inline(always)]
    fn add(self, b: DoubleDouble) -> DoubleDouble {
        let (s, e) = two_sum(self.high, b.high);
        DoubleDouble::new(s, e + (self.low + b.low))
    }
}

impl Neg for DoubleDouble {
    type Output = DoubleDouble;
    #[inline(always)]
    fn neg(self) -> DoubleDouble {
        DoubleDouble { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = DoubleDouble;
    #[inline(always)]
    fn sub(self, b: DoubleDouble) -> DoubleDouble {
        self + -b
    }
}

impl Mul for DoubleDouble {
    type Output = DoubleDouble;
    #[inline(always)]
    fn mul(self, b: DoubleDouble) -> DoubleDouble {
        let (p, e) = two_product(self.high, b.high);
        DoubleDouble::new(p, e + (self.high * b.low + self.low * b.high))
    }
}

impl Div for DoubleDouble {
    type Output = DoubleDouble;
    /// A quotient of the first numbers, and then of what it leaves.
    #[inline(always)]
    fn div(self, b: DoubleDouble) -> DoubleDouble {
        let q = self.high / b.high;
        let (p, e) = two_product(q, b.high);
        let left = ((self.high - p) - e) + (self.low - q * b.low);
        DoubleDouble::new(q, left / b.high)
    }
}

impl Scalar for DoubleDouble {
    const ZERO: DoubleDouble = DoubleDouble::point(0.0);
    const INVALID: DoubleDouble = DoubleDouble::point(f64::NAN);

    #[inline(always)]
    fn integer(n: i32) -> DoubleDouble {
        DoubleDouble::point(f64::from(n))
    }
    #[inline(always)]
    fn checked(self) -> Result<DoubleDouble, NoValue> {
        if self.high.is_finite() && self.low.is_finite() { Ok(self) } else { Err(NoValue::Indeterminate) }
    }
    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.high == 0.0 && self.low == 0.0
    }
    #[inline(always)]
    fn sign(self) -> DoubleDouble {
        DoubleDouble::point(self.high.sign())
    }
    #[inline(always)]
    fn scale(self, other: DoubleDouble) -> DoubleDouble {
        DoubleDouble::point(scalar::scale(self.high, other.high))
    }
    #[inline(always)]
    fn times(self, tangent: DoubleDouble) -> DoubleDouble {
        if tangent.is_zero() { tangent } else { self * tangent }
    }
    #[inline(always)]
    fn poisoned_by(self, _: DoubleDouble) -> DoubleDouble {
        self
    }

    /// Two sums of first numbers, and beside each all that they leave out: it is added to them only once.
    #[inline]
    fn convolution(a: &[DoubleDouble], b: &[DoubleDouble]) -> DoubleDouble {
        let (mut s, mut c) = ([0.0; 2], [0.0; 2]);
        let mut term = |k: usize, x: &DoubleDouble, y: &DoubleDouble| {
            let (p, e) = two_product(x.high, y.high);
            let (sum, t) = two_sum(s[k], p);
            s[k] = sum;
            c[k] += t + (e + (x.high * y.low + x.low * y.high));
        };
        let (pairs, rest) = a.as_chunks::<2>();
        let (single, back) = b.as_rchunks::<2>();
        for (p, q) in pairs.iter().zip(back.iter().rev()) {
            term(0, &p[0], &q[1]);
            term(1, &p[1], &q[0]);
        }
        for (p, q) in rest.iter().zip(single) {
            term(0, p, q);
        }
        DoubleDouble::new(s[0], c[0]) + DoubleDouble::new(s[1], c[1])
    }
}

impl super::Uniform for DoubleDouble {
    type Context = ();

    fn blank(_: &()) -> DoubleDouble {
        DoubleDouble::ZERO
    }
    /// What binary64 has, at the numbers rounded to it.
    fn rule(&mut self, cx: &(), op: Op, a: &DoubleDouble, b: &DoubleDouble) -> Result<(), NoValue> {
        let mut value = 0.0;
        op.apply(cx, &mut value, &a.high, &b.high)?;
        *self = DoubleDouble::point(value);
        Ok(())
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        let high = r.to_f64().value();
        let rest = r - Rational::try_from(high).map_err(|_| NoValue::Indeterminate)?;
        *self = DoubleDouble::new(high, rest.to_f64().value()).checked()?;
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        *self = PI;
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &DoubleDouble, _: &DoubleDouble) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    fn powi(&mut self, _: &(), a: &DoubleDouble, n: i32) -> Result<(), NoValue> {
        if n < 0 && a.is_zero() {
            return Err(NoValue::OutOfDomain);
        }
        let (mut base, mut e, mut power) = (*a, n.unsigned_abs(), DoubleDouble::point(1.0));
        while e > 0 {
            if e & 1 == 1 {
                power = power * base;
            }
            e >>= 1;
            if e > 0 {
                base = base * base;
            }
        }
        *self = if n < 0 { DoubleDouble::point(1.0) / power } else { power }.checked()?;
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &DoubleDouble) -> Result<(), NoValue> {
        *self = -*a;
        Ok(())
    }
    fn sqrt(&mut self, _: &(), a: &DoubleDouble) -> Result<(), NoValue> {
        let mut root = 0.0;
        root.sqrt(&(), &a.high)?;
        *self = DoubleDouble::point(root);
        if root > 0.0 {
            // A step of Newton's method.
            let left = *a - *self * *self;
            *self = DoubleDouble::new(root, left.high / (2.0 * root));
        }
        self.checked().map(|_| ())
    }
    fn exp(&mut self, _: &(), a: &DoubleDouble) -> Result<(), NoValue> {
        self.middle(Op::Exp, a)
    }
    fn sin(&mut self, _: &(), a: &DoubleDouble) -> Result<(), NoValue> {
        self.middle(Op::Sin, a)
    }
    fn cos(&mut self, _: &(), a: &DoubleDouble) -> Result<(), NoValue> {
        self.middle(Op::Cos, a)
    }
    fn tan(&mut self, _: &(), a: &DoubleDouble) -> Result<(), NoValue> {
        self.middle(Op::Tan, a)
    }
    fn sinh(&mut self, _: &(), a: &DoubleDouble) -> Result<(), NoValue> {
        self.middle(Op::Sinh, a)
    }
    fn cosh(&mut self, _: &(), a: &DoubleDouble) -> Result<(), NoValue> {
        self.middle(Op::Cosh, a)
    }
    fn abs(&mut self, _: &(), a: &DoubleDouble) -> Result<(), NoValue> {
        *self = if a.high < 0.0 { -*a } else { *a };
        Ok(())
    }
    fn add(&mut self, _: &(), a: &DoubleDouble, b: &DoubleDouble) -> Result<(), NoValue> {
        *self = (*a + *b).checked()?;
        Ok(())
    }
    fn sub(&mut self, _: &(), a: &DoubleDouble, b: &DoubleDouble) -> Result<(), NoValue> {
        *self = (*a - *b).checked()?;
        Ok(())
    }
    fn mul(&mut self, _: &(), a: &DoubleDouble, b: &DoubleDouble) -> Result<(), NoValue> {
        *self = (*a * *b).checked()?;
        Ok(())
    }
    fn div(&mut self, _: &(), a: &DoubleDouble, b: &DoubleDouble) -> Result<(), NoValue> {
        if b.is_zero() {
            return Err(NoValue::OutOfDomain);
        }
        *self = (*a / *b).checked()?;
        Ok(())
    }
    fn direction_cosine(&mut self, cx: &(), a: &DoubleDouble, b: &DoubleDouble) -> Result<(), NoValue> {
        if a.is_zero() && b.is_zero() {
            return Err(NoValue::OutOfDomain);
        }
        let s = a.scale(*b);
        let (a, b) = (*a * s, *b * s);
        let mut radius = DoubleDouble::ZERO;
        Number::sqrt(&mut radius, cx, &(a * a + b * b))?;
        *self = (a / radius).checked()?;
        Ok(())
    }
    fn pow(&mut self, cx: &(), a: &DoubleDouble, b: &DoubleDouble) -> Result<(), NoValue> {
        // Powers of roots.
        let halves = 2.0 * b.high;
        if b.low == 0.0 && halves.abs() <= 64.0 && halves == halves.round() && a.high > 0.0 {
            let mut root = DoubleDouble::ZERO;
            Number::sqrt(&mut root, cx, a)?;
            return Number::powi(self, cx, &root, halves as i32);
        }
        super::Uniform::rule(self, cx, Op::Pow, a, b)
    }
}

/// π, but for less than 3e−33.
pub(crate) const PI: DoubleDouble = DoubleDouble { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(x: DoubleDouble) -> Rational {
        let number = |x: f64| Rational::try_from(x).expect("finite");
        number(x.high) + number(x.low)
    }

    #[test]
    fn results_have_a_hundred_bits() {
        let value = |text: &str| {
            let mut x = DoubleDouble::ZERO;
            x.rational(&(), &text.parse().expect("a number")).expect("finite");
            x
        };
        let (a, b) = (value("22/7"), value("-1/30"));
        let (p, q) = (exact(a), exact(b));
        let close = |x: DoubleDouble, y: Rational| {
            let off = (exact(x) - &y) / y;
            assert!(off.to_f64().value().abs() < 1e-30, "{x:?}");
        };
        close(a + b, &p + &q);
        close(a - b, &p - &q);
        close(a * b, &p * &q);
        close(a / b, &p / &q);
        let mut root = DoubleDouble::ZERO;
        root.sqrt(&(), &a).expect("positive");
        close(root * root, p.clone());
        let (list, other) = (vec![a, b, a * a], vec![b, b * b, a]);
        close(DoubleDouble::convolution(&list, &other), &p * &p + &q * &q * &q + &p * &p * &q);
    }
}
