//! Degree and height bounds, propagated through the tape.
//!
//! [`Growth`] is a number type: the same loop that evaluates a formula bounds it. A value stands for a fraction N/D of
//! elements of ℤ\[x, r\], x the free leaves and r roots (rⱼ² ∈ ℤ\[x, r₁ … rⱼ₋₁\]). It bounds, for N and for D,
//!
//! * the degree in x, where a root counts half of the degree of its square;
//! * log₂ of the largest |value| for |xᵢ| = 1 and every choice of roots; every coefficient of a polynomial in ℤ\[x\] is at most
//!   that (Cauchy's bound on the torus).
//!
//! Both are subadditive under products and the same for all choices of the signs of roots; hence the norm of N, the product
//! over at most 2ᵏ choices, has at most 2ᵏ times of each. Fractions are never reduced, so the bounds hold for what is
//! evaluated. √(n/d) is treated as √(n·d)/d, whose numerator is integral over ℤ\[x\].

use dashu_int::ops::BitTest;
use number::{NoValue, Op, Rational};

/// Bounds for a fraction N/D, see the module. Degrees and bits are `f64`: rounding is covered by [`MARGIN`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Growth {
    pub(super) top_degree: f64,
    pub(super) under_degree: f64,
    pub(super) top_bits: f64,
    pub(super) under_bits: f64,
}

/// Relative allowance for rounding in [`Growth`]: 2⁻⁵³ per operation, for up to 2³⁰ operations, is below 2⁻²².
pub(super) const MARGIN: f64 = 1.0 + 1e-6;

impl Growth {
    /// A free leaf: x/1.
    pub(super) const FREE: Growth = Growth { top_degree: 1.0, under_degree: 0.0, top_bits: 0.0, under_bits: 0.0 };
    /// A sign ±1.
    pub(super) const SIGN: Growth = Growth { top_degree: 0.0, under_degree: 0.0, top_bits: 0.0, under_bits: 0.0 };
}

/// An upper bound of log₂(2ᵃ + 2ᵇ): log₂(1 + 2⁻ᵈ) ≤ min(1, 2⁻ᵈ·log₂e), d the difference.
fn sum_bits(a: f64, b: f64) -> f64 {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    let whole = (high - low).floor().min(60.0) as i32;
    high + (1.45 / (1u64 << whole) as f64).min(1.0)
}

impl number::Uniform for Growth {
    type Context = ();

    fn blank(_: &()) -> Growth {
        Growth::default()
    }
    /// Fractions have the operations that are written out, and no other.
    fn rule(&mut self, _: &(), _: Op, _: &Growth, _: &Growth) -> Result<(), NoValue> {
        Err(NoValue::Unsupported)
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        let bits = |n: usize| n as f64;
        *self = Growth {
            top_degree: 0.0,
            under_degree: 0.0,
            top_bits: bits(r.numerator().bit_len()),
            under_bits: if r.is_int() { 0.0 } else { bits(r.denominator().bit_len()) },
        };
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        Err(NoValue::Unsupported)
    }
    fn restrict(&mut self, _: &(), a: &Growth, _: &Growth) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    fn powi(&mut self, _: &(), a: &Growth, n: i32) -> Result<(), NoValue> {
        let k = f64::from(n.unsigned_abs());
        let (t, u) = if n < 0 {
            ((a.under_degree, a.under_bits), (a.top_degree, a.top_bits))
        } else {
            ((a.top_degree, a.top_bits), (a.under_degree, a.under_bits))
        };
        *self = Growth { top_degree: k * t.0, under_degree: k * u.0, top_bits: k * t.1, under_bits: k * u.1 };
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &Growth) -> Result<(), NoValue> {
        *self = *a;
        Ok(())
    }
    fn sqrt(&mut self, _: &(), a: &Growth) -> Result<(), NoValue> {
        *self = Growth {
            top_degree: 0.5 * (a.top_degree + a.under_degree),
            under_degree: a.under_degree,
            top_bits: 0.5 * (a.top_bits + a.under_bits),
            under_bits: a.under_bits,
        };
        Ok(())
    }
    fn add(&mut self, _: &(), a: &Growth, b: &Growth) -> Result<(), NoValue> {
        *self = Growth {
            top_degree: (a.top_degree + b.under_degree).max(b.top_degree + a.under_degree),
            under_degree: a.under_degree + b.under_degree,
            top_bits: sum_bits(a.top_bits + b.under_bits, b.top_bits + a.under_bits),
            under_bits: a.under_bits + b.under_bits,
        };
        Ok(())
    }
    fn sub(&mut self, cx: &(), a: &Growth, b: &Growth) -> Result<(), NoValue> {
        self.add(cx, a, b)
    }
    fn mul(&mut self, _: &(), a: &Growth, b: &Growth) -> Result<(), NoValue> {
        *self = Growth {
            top_degree: a.top_degree + b.top_degree,
            under_degree: a.under_degree + b.under_degree,
            top_bits: a.top_bits + b.top_bits,
            under_bits: a.under_bits + b.under_bits,
        };
        Ok(())
    }
    fn div(&mut self, _: &(), a: &Growth, b: &Growth) -> Result<(), NoValue> {
        *self = Growth {
            top_degree: a.top_degree + b.under_degree,
            under_degree: a.under_degree + b.top_degree,
            top_bits: a.top_bits + b.under_bits,
            under_bits: a.under_bits + b.top_bits,
        };
        Ok(())
    }
}
