//! A value with a bound of its error.
//!
//! **In:** values with the errors of their sources. **Out:** for each result, a bound of its distance from the exact result.
//!
//! **Guaranteed:** for all exact arguments within `value ± error` of the given ones that lie in the domain of the function,
//! the exact result lies within `value ± error` of the computed one. Rounding is included, that of the value as well as
//! that of the error, which is only ever rounded up. `value` is what `f64` computes, bit for bit.
//!
//! **Where rounding bounds come from:** + − × ÷ √ err by at most half a unit in the last place (IEEE 754), that is by
//! u·|v| with u = 2⁻⁵³ and, where a product or quotient may underflow, by 2⁻¹⁰⁷⁵ more. Elementary functions are taken to
//! err by one, two or three units of 2u·|v|, each by what [`Op::units`] says of it: [`elementary`](super::elementary) says why.
//!
//! **Why balls and not intervals:** a residual is a difference of nearly equal values. What is asked of it is one number,
//! how far it may be off; centre and radius are then cheaper and no wider than two ends.

use super::deviation::{turn, turned_cosine, wave};
use super::elementary::alone;
use super::{NoValue, Number, Op, Rational, Scalar, real, scalar};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// u, half the distance from 1 to the next number: the largest relative error of a basic operation.
pub(super) const U: f64 = f64::EPSILON / 2.0;
/// The unit in which errors of elementary functions are counted.
pub(super) const ULP: f64 = f64::EPSILON;
/// More than all underflow errors of one operation and of its error bound, each at most 2⁻¹⁰⁷⁵.
pub(super) const TINY: f64 = f64::MIN_POSITIVE;
/// More than the product of the relative rounding errors, each at most 1 + u, that go into one error bound.
pub(super) const UP: f64 = 1.0 + 32.0 * U;
/// Less than the same product of factors 1 − u.
pub(super) const DOWN: f64 = 1.0 - 32.0 * U;

/// All numbers within `value ± error`.
///
/// Over `Bounded`, arctan2 of a ball that meets the negative half-axis yields *one* representative of the angle modulo 2π,
/// that of the centre; its error bound is that of the angle on the circle. Angles are unwrapped by whoever follows them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounded {
    /// The computed value.
    pub value: f64,
    /// How far the exact value may be from it; not negative.
    pub error: f64,
}

impl Bounded {
    /// A number that is known exactly.
    pub const fn exact(value: f64) -> Bounded {
        Bounded { value, error: 0.0 }
    }

    /// A value known up to `error`.
    pub const fn new(value: f64, error: f64) -> Bounded {
        Bounded { value, error }
    }

    /// Whether `x` is one of the numbers.
    pub fn contains(&self, x: f64) -> bool {
        (x - self.value).abs() * DOWN <= self.error
    }

    /// Whether 0 is one of the numbers.
    #[inline(always)]
    pub fn contains_zero(&self) -> bool {
        self.value.abs() <= self.error
    }

    /// Whether a point (x, y), with `self` for y, may lie on either side of the cut of atan2(y, x), as far as its errors tell: the
    /// angle is π or −π there, and the error of a value near one of them says nothing of the other.
    pub fn straddles_cut(&self, x: &Bounded) -> bool {
        self.error > 0.0 && self.contains_zero() && x.value - x.error < 0.0
    }

    /// At least the largest absolute value of the numbers.
    #[inline(always)]
    pub fn magnitude(&self) -> f64 {
        (self.value.abs() + self.error) * UP
    }

    /// At most the smallest absolute value of the numbers.
    #[inline(always)]
    pub fn mignitude(&self) -> f64 {
        ((self.value.abs() - self.error) * DOWN).max(0.0)
    }

    /// Exactly zero: then products and odd functions are exact too.
    #[inline(always)]
    fn is_exact_zero(&self) -> bool {
        self.value == 0.0 && self.error == 0.0
    }

    /// The result of an elementary function whose values deviate by at most `deviation` over the ball.
    #[inline(always)]
    fn elementary(&mut self, op: Op, value: f64, deviation: f64) -> Result<(), NoValue> {
        *self = Bounded { value, error: (deviation + op.units() * ULP * value.abs()) * UP + TINY }.checked()?;
        Ok(())
    }

    /// Whether the argument of an odd function is exactly 0; then so is its value.
    #[inline(always)]
    fn odd_zero(&mut self, a: &Bounded, value: f64) -> bool {
        if a.is_exact_zero() {
            *self = Bounded::exact(value);
        }
        a.is_exact_zero()
    }

    /// Why there is no result when the centre is outside the domain.
    fn outside(&self, inside_somewhere: bool) -> NoValue {
        // A ball that is not known to be a set of numbers at all says nothing.
        let known = self.value.is_finite() && self.error.is_finite();
        if inside_somewhere && known { NoValue::Indeterminate } else { NoValue::OutOfDomain }
    }
}

/// The value of an operation on the centre.
#[inline(always)]
fn centre(f: impl FnOnce(&mut f64) -> Result<(), NoValue>) -> Result<f64, NoValue> {
    let mut value = 0.0;
    f(&mut value)?;
    Ok(value)
}

impl Add for Bounded {
    type Output = Bounded;
    #[inline(always)]
    fn add(self, b: Bounded) -> Bounded {
        let value = self.value + b.value;
        // No underflow term: sums below 2⁻¹⁰²¹ are exact.
        Bounded { value, error: (self.error + b.error + U * value.abs()) * UP }
    }
}

impl Sub for Bounded {
    type Output = Bounded;
    #[inline(always)]
    fn sub(self, b: Bounded) -> Bounded {
        self + -b
    }
}

impl Neg for Bounded {
    type Output = Bounded;
    #[inline(always)]
    fn neg(self) -> Bounded {
        Bounded { value: -self.value, error: self.error }
    }
}

impl Mul for Bounded {
    type Output = Bounded;
    /// (a + δ)(b + ε) − ab = aε + bδ + δε.
    #[inline(always)]
    fn mul(self, b: Bounded) -> Bounded {
        let value = self.value * b.value;
        let spread = self.value.abs() * b.error + (b.value.abs() + b.error) * self.error;
        let tiny = if self.is_exact_zero() || b.is_exact_zero() { 0.0 } else { TINY };
        Bounded { value, error: (spread + U * value.abs()) * UP + tiny }
    }
}

impl Div for Bounded {
    type Output = Bounded;
    /// (a + δ)/(b + ε) − a/b = (δ − (a/b)ε)/(b + ε). A divisor that may be 0 leaves an infinite error.
    #[inline(always)]
    fn div(self, b: Bounded) -> Bounded {
        let value = self.value / b.value;
        let least = b.mignitude();
        // 0 stays exact, whatever it is divided by.
        let tiny = if self.is_exact_zero() { 0.0 } else { TINY };
        let spread = (self.error + (value.abs() * UP + tiny) * b.error) / least;
        let error = if least > 0.0 { (spread + U * value.abs()) * UP + tiny } else { f64::INFINITY };
        Bounded { value, error }
    }
}

impl Scalar for Bounded {
    const ZERO: Bounded = Bounded::exact(0.0);
    const INVALID: Bounded = Bounded::new(f64::NAN, f64::INFINITY);

    #[inline(always)]
    fn integer(n: i32) -> Bounded {
        Bounded::exact(f64::from(n))
    }
    #[inline(always)]
    fn checked(self) -> Result<Bounded, NoValue> {
        if self.value.is_finite() && self.error.is_finite() { Ok(self) } else { Err(NoValue::Indeterminate) }
    }
    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.is_exact_zero()
    }
    #[inline(always)]
    fn sign(self) -> Bounded {
        if self.contains_zero() { Bounded::INVALID } else { Bounded::exact(self.value.sign()) }
    }
    #[inline(always)]
    fn scale(self, other: Bounded) -> Bounded {
        Bounded::exact(scalar::scale(self.value, other.value))
    }
    #[inline(always)]
    fn times(self, tangent: Bounded) -> Bounded {
        if tangent.is_exact_zero() { tangent } else { self * tangent }
    }
    /// Two ways to it, of which the other bounds it better near 0; the value is that of the first.
    #[inline]
    fn flatness(self, tanh: Bounded) -> Bounded {
        let first = scalar::by_exponential(self);
        let one = Bounded::exact(1.0);
        let second = (one - tanh) * (one + tanh);
        let apart = ((first.value - second.value).abs() + second.error) * UP;
        Bounded { value: first.value, error: first.error.min(apart) }
    }
    #[inline(always)]
    fn poisoned_by(self, _: Bounded) -> Bounded {
        self
    }

    #[inline]
    fn convolution(a: &[Bounded], b: &[Bounded]) -> Bounded {
        convolved(a, b, |x| *x)
    }
}

/// Σᵢ aᵢ·bₙ₋₁₋ᵢ over two slices of the same length n, of which `of` takes one number each.
///
/// Values are added as over `f64`. Of n products and their sum, each term is rounded at most n times, by u each.
#[inline(always)]
pub(super) fn convolved<T>(a: &[T], b: &[T], of: impl Fn(&T) -> Bounded) -> Bounded {
    let (head, tail) = a.as_chunks::<4>();
    let (rest, back) = b.as_rchunks::<4>();
    let (mut s, mut size, mut spread) = ([0.0; 4], [0.0; 4], [0.0; 4]);
    let mut value = 0.0;
    let mut weigh = |i: usize, p: &Bounded, q: &Bounded| {
        let (x, y) = (p.value.abs(), q.value.abs());
        size[i] += x * y;
        spread[i] += x * q.error + (y + q.error) * p.error;
    };
    for (p, q) in head.iter().zip(back.iter().rev()) {
        for i in 0..4 {
            let (p, q) = (of(&p[i]), of(&q[3 - i]));
            s[i] += p.value * q.value;
            weigh(i, &p, &q);
        }
    }
    value += (s[0] + s[2]) + (s[1] + s[3]);
    for (i, (p, q)) in tail.iter().zip(rest.iter().rev()).enumerate() {
        let (p, q) = (of(p), of(q));
        value += p.value * q.value;
        weigh(i, &p, &q);
    }
    let n = a.len() as f64;
    let size = (size[0] + size[1]) + (size[2] + size[3]);
    let spread = (spread[0] + spread[1]) + (spread[2] + spread[3]);
    let zero = |(p, q): (&T, &T)| of(p).is_zero() || of(q).is_zero();
    if size == 0.0 && spread == 0.0 && a.iter().zip(b.iter().rev()).all(zero) {
        return Bounded { value, error: 0.0 };
    }
    Bounded { value, error: (spread + (n + 1.0) * U * size) * (UP + 2.0 * n * U) + n * TINY }
}

/// At least the largest |arcsin p − arcsin q| (and |arccos p − arccos q|) for q the centre and p within `error` of it.
///
/// Where the ball stays inside (−1, 1), the slope at its outer end bounds it. Everywhere, arccos being steepest at the ends
/// of [−1, 1], the angle is at most arccos(1 − e) = 2·arcsin √(e/2).
fn arc_deviation(centre: f64, error: f64) -> f64 {
    let outer = (centre.abs() + error) * UP;
    let by_slope = if outer < 1.0 { error / ((1.0 - outer) * (1.0 + outer) * DOWN).sqrt() } else { f64::INFINITY };
    let by_end = 2.0 * pxfm::f_asin((0.5 * error * UP).sqrt().min(1.0)) * UP;
    by_slope.min(by_end)
}

impl Number for Bounded {
    type Context = ();

    fn blank(_: &()) -> Bounded {
        Bounded::ZERO
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        if let (true, Ok(whole)) = (r.is_int(), i64::try_from(r.numerator()))
            && whole.unsigned_abs() <= 1 << f64::MANTISSA_DIGITS
        {
            *self = Bounded::exact(whole as f64);
            return Ok(());
        }
        let value = centre(|x| x.rational(&(), r))?;
        let exact = Rational::try_from(value).is_ok_and(|back| back == *r);
        *self = Bounded { value, error: if exact { 0.0 } else { U * value.abs() * UP + TINY } }.checked()?;
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        // π − PI = 1.22…e−16.
        *self = Bounded::new(std::f64::consts::PI, 1.25e-16);
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &Bounded, _: &Bounded) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    /// The products of repeated squaring, each with its bound.
    fn powi(&mut self, _: &(), a: &Bounded, n: i32) -> Result<(), NoValue> {
        if n < 0 && a.contains_zero() {
            return Err(if a.is_exact_zero() { NoValue::OutOfDomain } else { NoValue::Indeterminate });
        }
        let (mut base, mut e, mut acc) = (*a, n.unsigned_abs(), None);
        while e > 0 {
            if e & 1 == 1 {
                acc = Some(match acc {
                    None => base,
                    Some(acc) => acc * base,
                });
            }
            e >>= 1;
            if e > 0 {
                base = base * base;
            }
        }
        let power = acc.unwrap_or(Bounded::exact(1.0));
        *self = if n < 0 { Bounded::exact(1.0) / power } else { power }.checked()?;
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        *self = (-*a).checked()?;
        Ok(())
    }
    /// Below the centre √ falls by e/(√a + √(a − e)), or by √a where the ball reaches 0; above, it rises by less than
    /// e/(√a + √(a + e)).
    fn sqrt(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let Ok(value) = centre(|x| x.sqrt(&(), &a.value)) else {
            // Rounding has moved a small value across 0: its root lies between 0 and that of the largest value.
            let largest = a.value + a.error;
            if !(a.value < 0.0 && largest >= 0.0 && largest.is_finite()) {
                return Err(a.outside(a.value >= 0.0));
            }
            *self = Bounded { value: 0.0, error: (largest * UP).sqrt() * UP };
            return Ok(());
        };
        let low = (a.value - a.error) * DOWN;
        let deviation = if a.error == 0.0 {
            0.0
        } else if low >= 0.0 {
            a.error / ((value + low.sqrt()) * DOWN)
        } else {
            (value * UP).max(a.error / ((value + (a.value + a.error).sqrt()) * DOWN))
        };
        *self = Bounded { value, error: (deviation + U * value) * UP }.checked()?;
        Ok(())
    }
    /// e^(a+e) − e^a = e^a·(e^e − 1), which is less than e^(a+e).
    fn exp(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let value = centre(|x| x.exp(&(), &a.value))?;
        let mut deviation = (value * UP + TINY) * pxfm::f_expm1(a.error) * UP;
        if !deviation.is_finite() {
            // A large error of a large negative exponent: the product of 0 and ∞ is no bound, the largest power is.
            deviation = pxfm::f_exp((a.value + a.error) + a.magnitude() * f64::EPSILON) * UP + TINY;
        }
        self.elementary(Op::Exp, value, deviation)
    }
    /// ln a − ln(a − e) = ln(1 + e/(a − e)).
    fn ln(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let low = (a.value - a.error) * DOWN;
        match centre(|x| x.ln(&(), &a.value)) {
            Ok(value) if low > 0.0 => self.elementary(Op::Ln, value, pxfm::f_log1p(a.error / low * UP) * UP),
            Ok(_) => Err(NoValue::Indeterminate),
            Err(_) => Err(a.outside(a.value + a.error > 0.0)),
        }
    }
    fn sin(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let value = centre(|x| x.sin(&(), &a.value))?;
        if self.odd_zero(a, value) { Ok(()) } else { self.elementary(Op::Sin, value, wave(alone([value, a.error])).x) }
    }
    fn cos(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let value = centre(|x| x.cos(&(), &a.value))?;
        self.elementary(Op::Cos, value, wave(alone([value, a.error])).x)
    }
    /// tan(a + δ) − tan a = tan δ·(1 + t²)/(1 − t·tan δ) with t = tan a; the ball holds a pole when |t|·tan e ≥ 1.
    fn tan(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let value = centre(|x| x.tan(&(), &a.value))?;
        if self.odd_zero(a, value) {
            return Ok(());
        }
        if a.error >= 1.5 {
            return Err(NoValue::Indeterminate);
        }
        let (t, step) = (value.abs() * UP, pxfm::f_tan(a.error) * UP);
        let under = (1.0 - t * step * UP) * DOWN;
        if under <= 0.0 {
            return Err(NoValue::Indeterminate);
        }
        self.elementary(Op::Tan, value, step * (1.0 + t * t) / under)
    }
    fn arcsin(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let Ok(value) = centre(|x| x.arcsin(&(), &a.value)) else {
            return Err(a.outside(a.value.abs() - a.error <= 1.0));
        };
        if self.odd_zero(a, value) {
            Ok(())
        } else {
            self.elementary(Op::Arcsin, value, arc_deviation(a.value, a.error))
        }
    }
    fn arccos(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let Ok(value) = centre(|x| x.arccos(&(), &a.value)) else {
            return Err(a.outside(a.value.abs() - a.error <= 1.0));
        };
        self.elementary(Op::Arccos, value, arc_deviation(a.value, a.error))
    }
    /// arctan(a + δ) − arctan a = arctan(δ/(1 + a² + aδ)) where that denominator is positive; the slope is at most 1.
    fn arctan(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let value = centre(|x| x.arctan(&(), &a.value))?;
        if self.odd_zero(a, value) {
            return Ok(());
        }
        let (low, size) = (a.mignitude(), a.value.abs());
        // 1 + a² − |a|e ≥ 1 + |a|·(|a| − e)
        let under = (1.0 + size * low * DOWN) * DOWN;
        // An overflow here would hide the deviation: the reciprocals do not overflow.
        let deviation = if under.is_finite() { a.error / under } else { a.error / low / size * UP };
        self.elementary(Op::Arctan, value, deviation.min(a.error))
    }
    /// sinh(a + δ) − sinh a = 2 cosh(a + δ/2) sinh(δ/2).
    fn sinh(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let value = centre(|x| x.sinh(&(), &a.value))?;
        if self.odd_zero(a, value) {
            return Ok(());
        }
        let (half, middle) = (0.5 * a.error, (a.value.abs() + 0.5 * a.error) * UP);
        let deviation = if a.error == 0.0 { 0.0 } else { 2.0 * pxfm::f_cosh(middle) * pxfm::f_sinh(half) * UP + TINY };
        self.elementary(Op::Sinh, value, deviation)
    }
    /// cosh(a + δ) − cosh a = 2 sinh(a + δ/2) sinh(δ/2).
    fn cosh(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let value = centre(|x| x.cosh(&(), &a.value))?;
        let (half, middle) = (0.5 * a.error, (a.value.abs() + 0.5 * a.error) * UP);
        let deviation = if a.error == 0.0 { 0.0 } else { 2.0 * pxfm::f_sinh(middle) * pxfm::f_sinh(half) * UP + TINY };
        self.elementary(Op::Cosh, value, deviation)
    }
    /// tanh(a + δ) − tanh a = tanh δ·(1 − t²)/(1 + t·tanh δ) with t = tanh a; the slope is at most 1.
    fn tanh(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        let value = centre(|x| x.tanh(&(), &a.value))?;
        if self.odd_zero(a, value) {
            return Ok(());
        }
        let (t, step) = (value.abs(), (pxfm::f_tanh(a.error) * UP).min(1.0));
        let off = Op::Tanh.units() * ULP;
        let under = (1.0 - t * step) * DOWN - off;
        let steep = step * (1.0 - t + off) * (1.0 + t) * UP / under;
        // All values lie between that of the smallest argument in size, or its opposite, and 1.
        let low = a.mignitude();
        let least = if low > 0.0 { pxfm::f_tanh(low) * DOWN - off } else { -1.0 };
        let most = ((t - least).max(1.0 - t) + off) * UP;
        self.elementary(Op::Tanh, value, if under > 0.0 { steep.min(most) } else { most }.min(a.error))
    }
    fn abs(&mut self, _: &(), a: &Bounded) -> Result<(), NoValue> {
        *self = Bounded { value: a.value.abs(), error: a.error }.checked()?;
        Ok(())
    }
    fn add(&mut self, _: &(), a: &Bounded, b: &Bounded) -> Result<(), NoValue> {
        *self = (*a + *b).checked()?;
        Ok(())
    }
    fn sub(&mut self, _: &(), a: &Bounded, b: &Bounded) -> Result<(), NoValue> {
        *self = (*a - *b).checked()?;
        Ok(())
    }
    fn mul(&mut self, _: &(), a: &Bounded, b: &Bounded) -> Result<(), NoValue> {
        *self = (*a * *b).checked()?;
        Ok(())
    }
    fn div(&mut self, _: &(), a: &Bounded, b: &Bounded) -> Result<(), NoValue> {
        if b.contains_zero() {
            return Err(if b.is_exact_zero() { NoValue::OutOfDomain } else { NoValue::Indeterminate });
        }
        *self = (*a / *b).checked()?;
        Ok(())
    }
    /// x^y = e^(y·ln x): the exponent moves by at most |y|·Δ + |ln x|·e + Δ·e with Δ the deviation of ln x. A base that may
    /// be 0 has powers between 0 and the largest one.
    fn pow(&mut self, _: &(), a: &Bounded, b: &Bounded) -> Result<(), NoValue> {
        let Ok(value) = centre(|x| x.pow(&(), &a.value, &b.value)) else {
            // Overflow and rounding aside, the centre is outside.
            let inside = a.value + a.error > 0.0 || (a.value + a.error >= 0.0 && b.value + b.error > 0.0);
            let in_domain = a.value > 0.0 || (a.value == 0.0 && b.value > 0.0);
            return Err(if in_domain { NoValue::Indeterminate } else { a.outside(inside && b.error.is_finite()) });
        };
        let low = (a.value - a.error) * DOWN;
        if low > 0.0 {
            let log = pxfm::f_log(a.value).abs() * UP;
            let moved = pxfm::f_log1p(a.error / low * UP) * UP;
            let exponent = (b.value.abs() * moved + log * b.error + moved * b.error) * UP;
            // A power computed as 0 may have been as large as the smallest number.
            self.elementary(Op::Pow, value, (value * UP + TINY) * pxfm::f_expm1(exponent) * UP)
        } else if a.is_exact_zero() && b.value - b.error > 0.0 {
            *self = Bounded::exact(value);
            Ok(())
        } else if b.value - b.error > 0.0 {
            let top = a.magnitude();
            let exponent = if top > 1.0 { b.magnitude() } else { b.mignitude() };
            self.elementary(Op::Pow, value, pxfm::f_pow(top, exponent).max(value) * UP)
        } else {
            Err(NoValue::Indeterminate)
        }
    }
    /// See [`Bounded`] for the cut.
    fn arctan2(&mut self, _: &(), y: &Bounded, x: &Bounded) -> Result<(), NoValue> {
        let Ok(value) = centre(|angle| angle.arctan2(&(), &y.value, &x.value)) else {
            let exact = y.is_exact_zero() && x.is_exact_zero();
            return Err(if exact { NoValue::OutOfDomain } else { NoValue::Indeterminate });
        };
        if y.is_exact_zero() && x.value > 0.0 && x.mignitude() > 0.0 {
            *self = Bounded { value, error: 0.0 };
            return Ok(());
        }
        if y.contains_zero() && x.contains_zero() {
            return Err(NoValue::Indeterminate);
        }
        let angle = turn(alone([y.value, y.error]), alone([x.value, x.error])).x;
        self.elementary(Op::Arctan2, value, angle)
    }
    /// The cosine of an angle θ that moves by δ moves by at most |sin θ|·δ + δ²/2. The cut of the angle is none here.
    fn direction_cosine(&mut self, _: &(), a: &Bounded, b: &Bounded) -> Result<(), NoValue> {
        let Ok(value) = centre(|x| x.direction_cosine(&(), &a.value, &b.value)) else {
            let exact = a.is_exact_zero() && b.is_exact_zero();
            return Err(if exact { NoValue::OutOfDomain } else { NoValue::Indeterminate });
        };
        if a.contains_zero() && b.contains_zero() {
            return Err(NoValue::Indeterminate);
        }
        // On an axis the cosine is 0, 1 or −1.
        if a.is_exact_zero() || b.is_exact_zero() {
            *self = Bounded::exact(value);
            return Ok(());
        }
        let [cosine] = alone([value]);
        let moved = turned_cosine(cosine, alone([a.value, a.error]), alone([b.value, b.error])).x;
        self.elementary(Op::DirectionCosine, value, moved)
    }
    /// The mean is homogeneous and grows with both arguments, so a relative change of at most r in both changes it by at
    /// most r. Each iteration rounds by at most 3u, and the last two means differ by at most 4u.
    fn agm(&mut self, _: &(), a: &Bounded, b: &Bounded) -> Result<(), NoValue> {
        let Ok(value) = centre(|x| x.agm(&(), &a.value, &b.value)) else {
            let inside = a.value + a.error >= 0.0 && b.value + b.error >= 0.0;
            let known = b.value.is_finite() && b.error.is_finite();
            let in_domain = a.value >= 0.0 && b.value >= 0.0;
            return Err(if in_domain { NoValue::Indeterminate } else { a.outside(inside && known) });
        };
        if a.is_exact_zero() || b.is_exact_zero() {
            *self = Bounded::exact(value);
            return Ok(());
        }
        let rounding = (3.0 * f64::from(real::AGM_ITERATIONS) + 8.0) * U;
        let deviation = if a.error == 0.0 && b.error == 0.0 {
            0.0
        } else {
            let relative = (a.error / a.value).max(b.error / b.value) * UP;
            let top = real::agm(a.magnitude(), b.magnitude()) * (1.0 + 2.0 * rounding);
            let rise = top - value + rounding * value;
            // Where a ball reaches 0 the mean may fall to 0.
            if relative < 1.0 { relative * value * (1.0 + 2.0 * rounding) } else { rise.max(value * (1.0 + rounding)) }
        };
        self.elementary(Op::Agm, value, deviation + rounding * value)
    }
}
