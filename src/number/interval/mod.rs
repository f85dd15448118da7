//! Intervals with outward rounding.
//!
//! **In:** intervals that contain the arguments. **Out:** an interval that contains every result, rounding included.
//!
//! **Guaranteed:** if an operation yields an interval, then it is defined *and continuous* at every point of the box of its
//! arguments, and every result lies in the interval. (In the words of IEEE 1788-2015, §11: the decoration of every result is
//! `com`.) [`NoValue::OutOfDomain`] means that the operation has no value at any point of the box;
//! [`NoValue::Indeterminate`] that it has none at some points, or may have none, or is not continuous, or overflows. Where
//! only continuity is missing, the range can be had from [`Interval::principal_angle`], with a [`Continuity`].
//!
//! **Where the bounds come from:** + − × ÷ √ and constants are rounded in the right direction exactly (`round`).
//! Elementary functions come from `pxfm`, which states half a unit in the last place; tests against correctly rounded values
//! found no exception, but there is no published proof, so one whole unit is granted. Sums of products inside series
//! ([`Scalar::convolution`]) are computed to nearest, and widened by the bound of [Higham 2002, §3.1] for all their roundings
//! at once: that costs a quarter of rounding each of them, and no width that matters.
//!
//! **Why two ends and not centre and radius:** a claim is decided over stretches of time on which things change by much;
//! the range of a monotone function is then exact, and the sign of an end is what decides.
//!
//! [Higham 2002, §3.1]: https://doi.org/10.1137/1.9780898718027

mod decorated;
mod elementary;
pub mod faults;
mod model;
#[cfg(test)]
mod model_tests;
mod precise;
pub(crate) mod round;
mod tail;

pub use decorated::Decorated;
pub use model::{NODES, TaylorModel};
pub use precise::{Precise, PreciseModel};
pub use tail::{Limit, Tail};

use super::{NoValue, Number, Rational, Scalar, scalar};
use round::{add_down, add_up, div_down, div_up, mul_down, mul_up};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All real numbers between two binary64 numbers, ends included.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

/// Whether a function is continuous on the box that its range was taken over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Continuity {
    /// At every point.
    Everywhere,
    /// Not at every point, though it has a value everywhere.
    Broken,
}

impl Interval {
    /// One number.
    pub const fn point(x: f64) -> Interval {
        Interval { lo: x, hi: x }
    }

    /// The numbers from `lo` to `hi`.
    ///
    /// # Errors
    /// [`NoValue::Indeterminate`] when an end is not finite, or the ends are in the wrong order.
    pub fn new(lo: f64, hi: f64) -> Result<Interval, NoValue> {
        Interval { lo, hi }.checked()
    }

    /// The numbers within `radius` of `centre`, which must be finite.
    pub fn ball(centre: f64, radius: f64) -> Interval {
        Interval { lo: add_down(centre, -radius), hi: add_up(centre, radius) }
    }

    /// The lower end.
    #[inline(always)]
    pub fn lo(&self) -> f64 {
        self.lo
    }

    /// The upper end.
    #[inline(always)]
    pub fn hi(&self) -> f64 {
        self.hi
    }

    /// At least the distance of the ends.
    #[inline(always)]
    pub fn width(&self) -> f64 {
        add_up(self.hi, -self.lo)
    }

    /// A number near the middle, inside.
    #[inline(always)]
    pub fn mid(&self) -> f64 {
        let sum = 0.5 * (self.lo + self.hi);
        if sum.is_finite() { sum.clamp(self.lo, self.hi) } else { 0.5 * self.lo + 0.5 * self.hi }
    }

    /// At least the distance of every number from [`Interval::mid`].
    #[inline(always)]
    pub fn radius(&self) -> f64 {
        let m = self.mid();
        add_up(self.hi, -m).max(add_up(m, -self.lo))
    }

    /// The largest absolute value.
    #[inline(always)]
    pub fn magnitude(&self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// The smallest absolute value.
    #[inline(always)]
    pub fn mignitude(&self) -> f64 {
        if self.contains(0.0) { 0.0 } else { self.lo.abs().min(self.hi.abs()) }
    }

    /// Whether `x` is one of the numbers.
    #[inline(always)]
    pub fn contains(&self, x: f64) -> bool {
        self.lo <= x && x <= self.hi
    }

    /// Whether all numbers of `other` are among these.
    #[inline(always)]
    pub fn contains_interval(&self, other: Interval) -> bool {
        self.lo <= other.lo && other.hi <= self.hi
    }

    /// Whether `other` lies strictly between the ends.
    #[inline(always)]
    pub fn encloses_strictly(&self, other: Interval) -> bool {
        self.lo < other.lo && other.hi < self.hi
    }

    /// The smallest interval with the numbers of both.
    #[inline(always)]
    pub fn hull(self, other: Interval) -> Interval {
        Interval { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The numbers that are in both; `None` when there are none.
    #[inline(always)]
    pub fn intersection(self, other: Interval) -> Option<Interval> {
        let both = Interval { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) };
        (both.lo <= both.hi).then_some(both)
    }

    /// `self` and a margin of `part` of its width, and `least`, on both sides.
    pub fn widened(self, part: f64, least: f64) -> Interval {
        let margin = part * self.width().max(0.0) + least;
        Interval { lo: add_down(self.lo, -margin), hi: add_up(self.hi, margin) }
    }

    /// Whether only one number is in it.
    #[inline(always)]
    pub fn is_point(&self) -> bool {
        self.lo == self.hi
    }

    /// x², which unlike x·x is never negative.
    #[inline(always)]
    pub fn square(self) -> Interval {
        let (low, high) = (self.mignitude(), self.magnitude());
        Interval { lo: mul_down(low, low), hi: mul_up(high, high) }
    }
}

impl std::fmt::Display for Interval {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "[{}, {}]", self.lo, self.hi)
    }
}

impl Add for Interval {
    type Output = Interval;
    #[inline(always)]
    fn add(self, b: Interval) -> Interval {
        Interval { lo: add_down(self.lo, b.lo), hi: add_up(self.hi, b.hi) }
    }
}

impl Sub for Interval {
    type Output = Interval;
    #[inline(always)]
    fn sub(self, b: Interval) -> Interval {
        Interval { lo: add_down(self.lo, -b.hi), hi: add_up(self.hi, -b.lo) }
    }
}

impl Neg for Interval {
    type Output = Interval;
    #[inline(always)]
    fn neg(self) -> Interval {
        Interval { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Interval {
    type Output = Interval;
    #[inline(always)]
    fn mul(self, b: Interval) -> Interval {
        let a = self;
        let ends = |x: f64, y: f64, z: f64, w: f64| Interval { lo: mul_down(x, y), hi: mul_up(z, w) };
        if a.lo >= 0.0 {
            if b.lo >= 0.0 {
                ends(a.lo, b.lo, a.hi, b.hi)
            } else if b.hi <= 0.0 {
                ends(a.hi, b.lo, a.lo, b.hi)
            } else {
                ends(a.hi, b.lo, a.hi, b.hi)
            }
        } else if a.hi <= 0.0 {
            if b.lo >= 0.0 {
                ends(a.lo, b.hi, a.hi, b.lo)
            } else if b.hi <= 0.0 {
                ends(a.hi, b.hi, a.lo, b.lo)
            } else {
                ends(a.lo, b.hi, a.lo, b.lo)
            }
        } else if b.lo >= 0.0 {
            ends(a.lo, b.hi, a.hi, b.hi)
        } else if b.hi <= 0.0 {
            ends(a.hi, b.lo, a.lo, b.lo)
        } else if a.lo < 0.0 && b.lo < 0.0 {
            Interval {
                lo: mul_down(a.lo, b.hi).min(mul_down(a.hi, b.lo)),
                hi: mul_up(a.lo, b.lo).max(mul_up(a.hi, b.hi)),
            }
        } else {
            Interval::INVALID
        }
    }
}

impl Div for Interval {
    type Output = Interval;
    /// Invalid where 0 is among the divisors.
    #[inline(always)]
    fn div(self, b: Interval) -> Interval {
        let a = self;
        let ends = |x: f64, y: f64, z: f64, w: f64| Interval { lo: div_down(x, y), hi: div_up(z, w) };
        if b.lo > 0.0 {
            if a.lo >= 0.0 {
                ends(a.lo, b.hi, a.hi, b.lo)
            } else if a.hi <= 0.0 {
                ends(a.lo, b.lo, a.hi, b.hi)
            } else {
                ends(a.lo, b.lo, a.hi, b.lo)
            }
        } else if b.hi < 0.0 {
            if a.lo >= 0.0 {
                ends(a.hi, b.hi, a.lo, b.lo)
            } else if a.hi <= 0.0 {
                ends(a.hi, b.lo, a.lo, b.hi)
            } else {
                ends(a.hi, b.hi, a.lo, b.hi)
            }
        } else {
            Interval::INVALID
        }
    }
}

/// u, the largest relative error of an operation that rounds to nearest.
const U: f64 = f64::EPSILON / 2.0;

impl Scalar for Interval {
    const ZERO: Interval = Interval::point(0.0);
    const INVALID: Interval = Interval { lo: f64::NAN, hi: f64::NAN };

    #[inline(always)]
    fn integer(n: i32) -> Interval {
        Interval::point(f64::from(n))
    }
    #[inline(always)]
    fn checked(self) -> Result<Interval, NoValue> {
        let finite = self.lo.is_finite() && self.hi.is_finite();
        if finite && self.lo <= self.hi { Ok(self) } else { Err(NoValue::Indeterminate) }
    }
    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }
    #[inline(always)]
    fn sign(self) -> Interval {
        if self.lo > 0.0 {
            Interval::point(1.0)
        } else if self.hi < 0.0 {
            Interval::point(-1.0)
        } else {
            Interval::INVALID
        }
    }
    #[inline(always)]
    fn scale(self, other: Interval) -> Interval {
        Interval::point(scalar::scale(self.magnitude(), other.magnitude()))
    }
    #[inline(always)]
    fn times(self, tangent: Interval) -> Interval {
        if tangent.is_zero() { tangent } else { self * tangent }
    }
    /// Both ways lead to intervals that hold it.
    #[inline]
    fn flatness(self, tanh: Interval) -> Interval {
        let (first, one) = (scalar::by_exponential(self), Interval::point(1.0));
        let second = (one - tanh) * (one + tanh);
        Interval { lo: most(first.lo, second.lo), hi: least(first.hi, second.hi) }
    }
    #[inline(always)]
    fn poisoned_by(self, _: Interval) -> Interval {
        self
    }

    /// Ends are added to nearest. Of n products and their sum, each term is rounded at most n times.
    #[inline]
    fn convolution(a: &[Interval], b: &[Interval]) -> Interval {
        let n = a.len();
        if let ([x], [y]) = (a, b) {
            return *x * *y;
        }
        let (mut lo, mut hi, mut size) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        let mut term = |k: usize, x: &Interval, y: &Interval| {
            let (p, q, r, s) = (x.lo * y.lo, x.lo * y.hi, x.hi * y.lo, x.hi * y.hi);
            let (low, high) = (least(least(p, q), least(r, s)), most(most(p, q), most(r, s)));
            lo[k] += low;
            hi[k] += high;
            size[k] += most(-low, high);
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
        let (lo, hi, size) = (lo[0] + lo[1], hi[0] + hi[1], size[0] + size[1]);
        if size == 0.0 && a.iter().zip(b.iter().rev()).all(|(x, y)| x.is_zero() || y.is_zero()) {
            return Interval::ZERO;
        }
        let slips = n as f64;
        // (1 + u)ⁿ − 1 < (n + 1)u for the n ≤ 2³⁰ that fit; `size` itself may have been rounded down by as much.
        let room = (slips + 2.0) * U * size * (1.0 + 4.0 * slips * U) + slips * f64::MIN_POSITIVE;
        let room = if faults::nearest() { 0.0 * room } else { room };
        if room.is_nan() || room >= f64::MAX {
            return Interval::INVALID;
        }
        Interval { lo: add_down(lo, -room), hi: add_up(hi, room) }
    }
}

/// The smaller one; the second where they cannot be compared. Compiles to one instruction, unlike `f64::min`.
#[inline(always)]
fn least(x: f64, y: f64) -> f64 {
    if x < y { x } else { y }
}

/// The larger one; the second where they cannot be compared.
#[inline(always)]
fn most(x: f64, y: f64) -> f64 {
    if x > y { x } else { y }
}

/// Why an operation has no value on a whole box: none of its points is in the domain, or some.
fn outside(nowhere: bool) -> NoValue {
    if nowhere { NoValue::OutOfDomain } else { NoValue::Indeterminate }
}

impl Number for Interval {
    type Context = ();

    fn blank(_: &()) -> Interval {
        Interval::ZERO
    }
    /// The two neighbours of a number that is not binary64.
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        let near = r.to_f64().value();
        let exact = Rational::try_from(near).map_err(|_| NoValue::Indeterminate)?;
        *self = match exact.cmp(r) {
            std::cmp::Ordering::Equal => Interval::point(near),
            std::cmp::Ordering::Less => Interval { lo: near, hi: near.next_up() },
            std::cmp::Ordering::Greater => Interval { lo: near.next_down(), hi: near },
        }
        .checked()?;
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        *self = elementary::PI;
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &Interval, _: &Interval) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    fn powi(&mut self, _: &(), a: &Interval, n: i32) -> Result<(), NoValue> {
        if n < 0 && a.contains(0.0) {
            return Err(outside(a.is_zero()));
        }
        let power = elementary::power(*a, n.unsigned_abs());
        *self = if n < 0 { Interval::point(1.0) / power.checked()? } else { power }.checked()?;
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        *self = (-*a).checked()?;
        Ok(())
    }
    fn sqrt(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        a.checked()?;
        if a.lo < 0.0 {
            return Err(outside(a.hi < 0.0));
        }
        *self = Interval { lo: round::sqrt_down(a.lo), hi: round::sqrt_up(a.hi) }.checked()?;
        Ok(())
    }
    fn exp(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        *self = elementary::exp(a.checked()?).checked()?;
        Ok(())
    }
    fn ln(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        a.checked()?;
        if a.lo <= 0.0 {
            return Err(outside(a.hi <= 0.0));
        }
        *self = elementary::ln(*a).checked()?;
        Ok(())
    }
    fn sin(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        *self = elementary::sin(a.checked()?);
        Ok(())
    }
    fn cos(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        *self = elementary::cos(a.checked()?);
        Ok(())
    }
    fn tan(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        *self = elementary::tan(a.checked()?)?;
        Ok(())
    }
    fn arcsin(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        a.checked()?;
        if a.magnitude() > 1.0 {
            return Err(outside(a.lo > 1.0 || a.hi < -1.0));
        }
        *self = elementary::arcsin(*a);
        Ok(())
    }
    fn arccos(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        a.checked()?;
        if a.magnitude() > 1.0 {
            return Err(outside(a.lo > 1.0 || a.hi < -1.0));
        }
        *self = elementary::arccos(*a);
        Ok(())
    }
    fn arctan(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        *self = elementary::arctan(a.checked()?);
        Ok(())
    }
    fn sinh(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        *self = elementary::sinh(a.checked()?).checked()?;
        Ok(())
    }
    fn cosh(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        *self = elementary::cosh(a.checked()?).checked()?;
        Ok(())
    }
    fn tanh(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        *self = elementary::tanh(a.checked()?);
        Ok(())
    }
    /// Continuous everywhere.
    fn abs(&mut self, _: &(), a: &Interval) -> Result<(), NoValue> {
        a.checked()?;
        *self = Interval { lo: a.mignitude(), hi: a.magnitude() };
        Ok(())
    }
    fn add(&mut self, _: &(), a: &Interval, b: &Interval) -> Result<(), NoValue> {
        *self = (*a + *b).checked()?;
        Ok(())
    }
    fn sub(&mut self, _: &(), a: &Interval, b: &Interval) -> Result<(), NoValue> {
        *self = (*a - *b).checked()?;
        Ok(())
    }
    fn mul(&mut self, _: &(), a: &Interval, b: &Interval) -> Result<(), NoValue> {
        *self = (*a * *b).checked()?;
        Ok(())
    }
    fn div(&mut self, _: &(), a: &Interval, b: &Interval) -> Result<(), NoValue> {
        a.checked()?;
        b.checked()?;
        if b.contains(0.0) {
            return Err(outside(b.is_zero()));
        }
        *self = (*a / *b).checked()?;
        Ok(())
    }
    /// a^b is monotone in a and in b, so that its extremes lie at corners.
    fn pow(&mut self, _: &(), a: &Interval, b: &Interval) -> Result<(), NoValue> {
        a.checked()?;
        b.checked()?;
        if a.hi < 0.0 || (a.is_zero() && b.hi <= 0.0) {
            return Err(NoValue::OutOfDomain);
        }
        if a.lo < 0.0 || (a.lo == 0.0 && b.lo <= 0.0) {
            return Err(NoValue::Indeterminate);
        }
        *self = elementary::pow(*a, *b).checked()?;
        Ok(())
    }
    /// The principal value, where it is continuous on the box.
    fn arctan2(&mut self, _: &(), y: &Interval, x: &Interval) -> Result<(), NoValue> {
        match Interval::principal_angle(*y, *x)? {
            (angle, Continuity::Everywhere) => *self = angle,
            (_, Continuity::Broken) => return Err(NoValue::Indeterminate),
        }
        Ok(())
    }
    fn direction_cosine(&mut self, _: &(), a: &Interval, b: &Interval) -> Result<(), NoValue> {
        a.checked()?;
        b.checked()?;
        if a.contains(0.0) && b.contains(0.0) {
            return Err(outside(a.is_zero() && b.is_zero()));
        }
        *self = Interval::direction_cosine_of(*a, *b).checked()?;
        Ok(())
    }
    fn agm(&mut self, _: &(), a: &Interval, b: &Interval) -> Result<(), NoValue> {
        a.checked()?;
        b.checked()?;
        if a.lo < 0.0 || b.lo < 0.0 {
            return Err(outside(a.hi < 0.0 || b.hi < 0.0));
        }
        *self = Interval { lo: elementary::agm(a.lo, b.lo).lo, hi: elementary::agm(a.hi, b.hi).hi }.checked()?;
        Ok(())
    }
}
