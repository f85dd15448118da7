//! What a series or a dual number may be built over.
//!
//! Operators here are *unchecked*: they may yield NaN or ∞, which [`Scalar::checked`] finds once per result. This keeps
//! the inner loops of the recurrences free of branches.

use super::operation::{Plain, run_each};
use super::{Instruction, Jet, NoValue, Number, Orders};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number type without a context that is cheap to copy: the base of [`Jet`](super::Jet) and of the duals.
///
/// Zero is exact: `ZERO` has no error, and [`Scalar::is_zero`] is true only for a number that is certainly 0.
pub trait Scalar:
    Number<Context = ()>
    + Copy
    + std::fmt::Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// 0, exactly.
    const ZERO: Self;
    /// No value at all: [`Scalar::checked`] refuses it (or, in lanes, every lane is without a value).
    const INVALID: Self;

    /// A small integer, exactly.
    fn integer(n: i32) -> Self;
    /// The number itself, if it is one.
    ///
    /// # Errors
    /// [`NoValue::Indeterminate`] for NaN and ∞; in lanes these become NaN, lane by lane, and there is no error.
    fn checked(self) -> Result<Self, NoValue>;
    /// Whether the number is certainly 0 (in every lane).
    fn is_zero(&self) -> bool;
    /// 1 or −1 with the sign of the number; invalid where the sign is not certain, as for 0.
    fn sign(self) -> Self;
    /// A power of two s for which the larger of |s·self| and |s·other| lies in [1, 2), or near it for subnormal numbers.
    fn scale(self, other: Self) -> Self;
    /// `self` · `tangent`, where an exact zero tangent wins over a factor that is not a value: the derivative of a constant
    /// is 0 also where the function has no derivative.
    fn times(self, tangent: Self) -> Self;
    /// 1/cosh² of `self`, the slope of tanh there; `tanh` is the value of that. It is known relative to its own size, also where tanh is so
    /// close to 1 that 1 − tanh² has no digit left: a series that starts from such a rest is wrong by as much as it grows.
    #[inline(always)]
    fn flatness(self, _tanh: Self) -> Self {
        by_exponential(self)
    }
    /// Marks `self` as invalid where `other` is, for types that hold several numbers. Elsewhere nothing happens.
    fn poisoned_by(self, other: Self) -> Self;

    /// Σᵢ aᵢ·bₙ₋₁₋ᵢ over two slices of the same length n > 0.
    ///
    /// Four partial sums, so that the additions do not wait for each other. Every base adds in this order: values over a
    /// base with error bounds are those of the plain base, bit for bit.
    #[inline(always)]
    fn convolution(a: &[Self], b: &[Self]) -> Self {
        by_four(a, b)
    }

    /// Carries out the steps of a program over series, see [`Number::run`].
    #[inline(always)]
    fn run_series(orders: &Orders, values: &mut [Jet<Self>], missing: &mut [Option<NoValue>], steps: &[Instruction]) {
        run_each(values, missing, steps, Plain(orders));
    }
}

/// The sum of [`Scalar::convolution`].
#[inline(always)]
pub(super) fn by_four<B: Scalar>(a: &[B], b: &[B]) -> B {
    let (head, tail) = a.as_chunks::<4>();
    let (rest, back) = b.as_rchunks::<4>();
    let mut sum = B::ZERO;
    if let ([p, head @ ..], [back @ .., q]) = (head, back) {
        let mut s = [p[0] * q[3], p[1] * q[2], p[2] * q[1], p[3] * q[0]];
        for (p, q) in head.iter().zip(back.iter().rev()) {
            s[0] = s[0] + p[0] * q[3];
            s[1] = s[1] + p[1] * q[2];
            s[2] = s[2] + p[2] * q[1];
            s[3] = s[3] + p[3] * q[0];
        }
        sum = (s[0] + s[2]) + (s[1] + s[3]);
    }
    for (&x, &y) in tail.iter().zip(rest.iter().rev()) {
        sum = sum + x * y;
    }
    sum
}

/// 1/cosh² a = (2E/(1 + E²))² with E = e^{−|a|}, which neither overflows nor cancels.
#[inline(always)]
pub(super) fn by_exponential<B: Scalar>(a: B) -> B {
    let e = value(B::exp, -value(B::abs, a));
    let sech = (e + e) / (B::integer(1) + e * e);
    sech * sech
}

/// The value of an operation of one argument, invalid where there is none.
#[inline(always)]
pub(super) fn value<B: Scalar>(f: impl FnOnce(&mut B, &(), &B) -> Result<(), NoValue>, a: B) -> B {
    let mut out = B::ZERO;
    match f(&mut out, &(), &a) {
        Ok(()) => out,
        Err(_) => B::INVALID,
    }
}

/// The power of two that brings the larger of |a| and |b| into [1, 2); exponents are clamped so that it is finite.
#[inline(always)]
pub(super) fn scale(a: f64, b: f64) -> f64 {
    let biased = (a.abs().max(b.abs()).to_bits() >> 52).clamp(1, 2045);
    f64::from_bits((2046 - biased) << 52)
}

impl Scalar for f64 {
    const ZERO: f64 = 0.0;
    const INVALID: f64 = f64::NAN;

    #[inline(always)]
    fn integer(n: i32) -> f64 {
        f64::from(n)
    }
    #[inline(always)]
    fn checked(self) -> Result<f64, NoValue> {
        if self.is_finite() { Ok(self) } else { Err(NoValue::Indeterminate) }
    }
    #[inline(always)]
    fn is_zero(&self) -> bool {
        *self == 0.0
    }
    #[inline(always)]
    fn sign(self) -> f64 {
        if self > 0.0 {
            1.0
        } else if self < 0.0 {
            -1.0
        } else {
            f64::NAN
        }
    }
    #[inline(always)]
    fn scale(self, other: f64) -> f64 {
        scale(self, other)
    }
    #[inline(always)]
    fn times(self, tangent: f64) -> f64 {
        if tangent == 0.0 { 0.0 } else { self * tangent }
    }
    #[inline(always)]
    fn poisoned_by(self, _: f64) -> f64 {
        self
    }
}
