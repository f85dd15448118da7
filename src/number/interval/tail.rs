//! What is known of a quantity for all later times, and of its limit.
//!
//! **In:** a time T, or minus infinity's counterpart, from which on nothing is left out. **Out:** a [`Tail`]: bounds for all
//! times from T on, which may be infinite, and the limit, where the laws of limits give one.
//!
//! **Guaranteed:** if an operation yields a tail, it has a value and is continuous at all times from T on; the values lie between
//! the bounds, strictly on one side of 0 where a sign is given; and a limit that is given exists. That rests on the laws of
//! limits: sums, products, quotients where they are not of the forms ∞ − ∞, 0·∞, ∞/∞ or 0/0; continuous functions of what has a
//! limit in their domain ([Rudin 1976, theorems 3.3, 4.4, 4.7, 4.34]); monotone functions at infinity; and that what is bounded
//! times what tends to 0 tends to 0. Nothing is concluded from being small: 1/ln t tends to 0, and 10⁻³⁰ sin t has no limit that
//! would be seen.
//!
//! **Why not bounds for ever larger times:** bounds that shrink at a thousand times do not tell that they shrink for ever.
//!
//! [Rudin 1976, theorems 3.3, 4.4, 4.7, 4.34]: https://archive.org/details/principlesofmath00rudi

use super::elementary;
use super::round::{add_down, add_up, div_down, div_up, mul_down, mul_up};
use super::{Interval, NoValue, Number, Rational, Scalar};
use crate::Op;

/// What a quantity tends to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// To a number in an interval.
    Finite(Interval),
    /// Beyond all bounds.
    PlusInfinity,
    /// Below all bounds.
    MinusInfinity,
    /// It may have no limit.
    Unknown,
}

/// See the module.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tail {
    lo: f64,
    hi: f64,
    limit: Limit,
    /// Whether it is positive, or negative, at every time.
    positive: Option<bool>,
}

const ZERO: Limit = Limit::Finite(Interval::ZERO);

impl Limit {
    fn of(value: Interval) -> Limit {
        value.checked().map_or(Limit::Unknown, Limit::Finite)
    }

    fn is_zero(self) -> bool {
        matches!(self, Limit::Finite(i) if i.is_zero())
    }

    fn is_infinite(self) -> bool {
        matches!(self, Limit::PlusInfinity | Limit::MinusInfinity)
    }

    fn infinity(positive: bool) -> Limit {
        if positive { Limit::PlusInfinity } else { Limit::MinusInfinity }
    }
}

impl Tail {
    fn new(lo: f64, hi: f64, limit: Limit, positive: Option<bool>) -> Result<Tail, NoValue> {
        if lo.is_nan() || hi.is_nan() || lo > hi {
            return Err(NoValue::Indeterminate);
        }
        let positive = positive.or(if lo > 0.0 { Some(true) } else { (hi < 0.0).then_some(false) });
        let (lo, hi) = match positive {
            Some(true) => (lo.max(0.0), hi),
            Some(false) => (lo, hi.min(0.0)),
            None => (lo, hi),
        };
        // A limit lies between the bounds, too.
        let limit = match limit {
            Limit::Finite(i) => {
                let both = (i.lo.max(lo), i.hi.min(hi));
                if both.0 <= both.1 { Limit::of(Interval { lo: both.0, hi: both.1 }) } else { limit }
            }
            other => other,
        };
        Ok(Tail { lo, hi, limit, positive })
    }

    /// A quantity that does not change.
    ///
    /// # Errors
    /// [`NoValue::Indeterminate`] for bounds that are no numbers.
    pub fn constant(value: Interval) -> Result<Tail, NoValue> {
        Tail::new(value.lo, value.hi, Limit::of(value), None)
    }

    /// The time, from `from` on: to +∞, or back to −∞.
    pub fn time(from: f64, onwards: bool) -> Tail {
        if onwards {
            Tail { lo: from, hi: f64::INFINITY, limit: Limit::PlusInfinity, positive: (from > 0.0).then_some(true) }
        } else {
            Tail {
                lo: f64::NEG_INFINITY,
                hi: from,
                limit: Limit::MinusInfinity,
                positive: (from < 0.0).then_some(false),
            }
        }
    }

    /// The smallest and the largest value, or bounds for them; they may be infinite.
    pub fn bounds(&self) -> (f64, f64) {
        (self.lo, self.hi)
    }

    /// What it tends to.
    pub fn limit(&self) -> Limit {
        self.limit
    }

    /// Whether it is positive at all times, or negative at all times.
    pub fn is_positive(&self) -> Option<bool> {
        self.positive
    }

    /// The same quantity, of which the limit is known otherwise.
    pub fn with_limit(self, limit: Limit) -> Result<Tail, NoValue> {
        Tail::new(self.lo, self.hi, limit, self.positive)
    }

    fn finite(&self) -> Option<Interval> {
        Interval { lo: self.lo, hi: self.hi }.checked().ok()
    }

    /// A function that rises on all of the bounds, with what it tends to at −∞ and +∞.
    fn rising(&self, f: impl Fn(Interval) -> Interval, ends: [(f64, Limit); 2]) -> Result<Tail, NoValue> {
        let at = |x: f64| f(Interval::point(x));
        // A value too large for a number is at least the largest one.
        let finite = |x: f64| if x == f64::INFINITY { f64::MAX } else { x };
        let lo = if self.lo == f64::NEG_INFINITY { ends[0].0 } else { finite(at(self.lo).lo) };
        let hi = if self.hi == f64::INFINITY { ends[1].0 } else { at(self.hi).hi };
        let limit = match self.limit {
            Limit::Finite(i) => Limit::of(f(i)),
            Limit::MinusInfinity => ends[0].1,
            Limit::PlusInfinity => ends[1].1,
            Limit::Unknown => Limit::Unknown,
        };
        Tail::new(lo, hi, limit, None)
    }

    /// A function of one argument that is known on bounded arguments only.
    fn on_bounded(&self, f: impl Fn(Interval) -> Result<Interval, NoValue>) -> Result<Tail, NoValue> {
        let range = f(self.finite().ok_or(NoValue::Indeterminate)?)?;
        let limit = match self.limit {
            Limit::Finite(i) => f(i).map_or(Limit::Unknown, Limit::of),
            _ => Limit::Unknown,
        };
        Tail::new(range.lo, range.hi, limit, None)
    }

    /// Sine or cosine.
    fn wave(&self, f: impl Fn(Interval) -> Interval) -> Result<Tail, NoValue> {
        let range = self.finite().map_or(Interval { lo: -1.0, hi: 1.0 }, &f);
        let limit = match self.limit {
            Limit::Finite(i) => Limit::of(f(i)),
            _ => Limit::Unknown,
        };
        Tail::new(range.lo, range.hi, limit, None)
    }

    fn negative(&self) -> Tail {
        let limit = match self.limit {
            Limit::Finite(i) => Limit::Finite(-i),
            Limit::PlusInfinity => Limit::MinusInfinity,
            Limit::MinusInfinity => Limit::PlusInfinity,
            Limit::Unknown => Limit::Unknown,
        };
        Tail { lo: -self.hi, hi: -self.lo, limit, positive: self.positive.map(|p| !p) }
    }

    fn size(&self) -> Result<Tail, NoValue> {
        if self.lo >= 0.0 {
            return Ok(*self);
        }
        let hi = self.hi.max(-self.lo);
        let lo = if self.hi < 0.0 { -self.hi } else { 0.0 };
        let limit = match self.limit {
            Limit::Finite(i) => Limit::Finite(Interval { lo: i.mignitude(), hi: i.magnitude() }),
            Limit::PlusInfinity | Limit::MinusInfinity => Limit::PlusInfinity,
            Limit::Unknown => Limit::Unknown,
        };
        Tail::new(lo, hi, limit, self.positive.map(|_| true))
    }

    fn sum(&self, b: &Tail) -> Result<Tail, NoValue> {
        let bounded = |t: &Tail, positive: bool| if positive { t.lo.is_finite() } else { t.hi.is_finite() };
        let limit = match (self.limit, b.limit) {
            (Limit::Finite(x), Limit::Finite(y)) => Limit::of(x + y),
            (Limit::PlusInfinity, _) if bounded(b, true) => Limit::PlusInfinity,
            (_, Limit::PlusInfinity) if bounded(self, true) => Limit::PlusInfinity,
            (Limit::MinusInfinity, _) if bounded(b, false) => Limit::MinusInfinity,
            (_, Limit::MinusInfinity) if bounded(self, false) => Limit::MinusInfinity,
            (Limit::PlusInfinity, Limit::PlusInfinity) => Limit::PlusInfinity,
            (Limit::MinusInfinity, Limit::MinusInfinity) => Limit::MinusInfinity,
            _ => Limit::Unknown,
        };
        let above = (self.positive == Some(true) && b.lo >= 0.0) || (b.positive == Some(true) && self.lo >= 0.0);
        let below = (self.positive == Some(false) && b.hi <= 0.0) || (b.positive == Some(false) && self.hi <= 0.0);
        let positive = if above { Some(true) } else { below.then_some(false) };
        Tail::new(add_down(self.lo, b.lo), add_up(self.hi, b.hi), limit, positive)
    }

    fn product(&self, b: &Tail) -> Result<Tail, NoValue> {
        let corners = [(self.lo, b.lo), (self.lo, b.hi), (self.hi, b.lo), (self.hi, b.hi)];
        let lo = corners.iter().map(|&(x, y)| mul_down(x, y)).fold(f64::INFINITY, f64::min);
        let hi = corners.iter().map(|&(x, y)| mul_up(x, y)).fold(f64::NEG_INFINITY, f64::max);
        let positive = self.positive.zip(b.positive).map(|(x, y)| x == y);
        // The sign that something keeps, and stays away from 0 with.
        let away = |t: &Tail| match t.limit {
            Limit::Finite(i) if i.lo > 0.0 => Some(true),
            Limit::Finite(i) if i.hi < 0.0 => Some(false),
            Limit::PlusInfinity => Some(true),
            Limit::MinusInfinity => Some(false),
            Limit::Unknown if t.lo > 0.0 => Some(true),
            Limit::Unknown if t.hi < 0.0 => Some(false),
            _ => None,
        };
        let vanishes =
            |x: &Tail, y: &Tail| x.limit.is_zero() && (y.finite().is_some() || matches!(y.limit, Limit::Finite(_)));
        let limit = match (self.limit, b.limit) {
            _ if vanishes(self, b) || vanishes(b, self) => ZERO,
            (Limit::Finite(x), Limit::Finite(y)) => Limit::of(x * y),
            (x, y) if x.is_infinite() || y.is_infinite() => match (away(self), away(b)) {
                (Some(x), Some(y)) => Limit::infinity(x == y),
                _ => Limit::Unknown,
            },
            _ => Limit::Unknown,
        };
        // Ends of two squares of the same sign are not below 0, whatever rounding says.
        let least = if (self.lo >= 0.0 && b.lo >= 0.0) || (self.hi <= 0.0 && b.hi <= 0.0) { 0.0 } else { lo };
        Tail::new(lo.max(least), hi, limit, positive)
    }

    fn reciprocal(&self) -> Result<Tail, NoValue> {
        let Some(positive) = self.positive else {
            return Err(if self.lo == 0.0 && self.hi == 0.0 { NoValue::OutOfDomain } else { NoValue::Indeterminate });
        };
        if !positive {
            return Ok(self.negative().reciprocal()?.negative());
        }
        let lo = if self.hi == f64::INFINITY { 0.0 } else { div_down(1.0, self.hi) };
        let hi = if self.lo <= 0.0 { f64::INFINITY } else { div_up(1.0, self.lo) };
        let limit = match self.limit {
            Limit::Finite(i) if i.lo > 0.0 => Limit::of(Interval::point(1.0) / i),
            Limit::Finite(i) if i.is_zero() => Limit::PlusInfinity,
            Limit::PlusInfinity => ZERO,
            _ => Limit::Unknown,
        };
        Tail::new(lo, hi, limit, Some(true))
    }

    fn raised(&self, n: u32) -> Result<Tail, NoValue> {
        let power = |a: Interval| elementary::power(a, n);
        let infinite = [(f64::NEG_INFINITY, Limit::MinusInfinity), (f64::INFINITY, Limit::PlusInfinity)];
        match n {
            0 => Tail::constant(Interval::point(1.0)),
            _ if n.is_multiple_of(2) => {
                let found = self.size()?.rising(power, infinite)?;
                Tail::new(found.lo.max(0.0), found.hi, found.limit, self.positive.map(|_| true))
            }
            _ => {
                let found = self.rising(power, infinite)?;
                Tail::new(found.lo, found.hi, found.limit, self.positive)
            }
        }
    }

    fn exponential(&self) -> Result<Tail, NoValue> {
        let found = self.rising(elementary::exp, [(0.0, ZERO), (f64::INFINITY, Limit::PlusInfinity)])?;
        Tail::new(found.lo, found.hi, found.limit, Some(true))
    }

    fn logarithm(&self) -> Result<Tail, NoValue> {
        if self.positive != Some(true) {
            return Err(if self.hi <= 0.0 { NoValue::OutOfDomain } else { NoValue::Indeterminate });
        }
        let at = |x: f64| elementary::ln(Interval::point(x));
        let lo = if self.lo <= 0.0 { f64::NEG_INFINITY } else { at(self.lo).lo };
        let hi = if self.hi == f64::INFINITY { f64::INFINITY } else { at(self.hi).hi };
        let limit = match self.limit {
            Limit::Finite(i) if i.lo > 0.0 => Limit::of(elementary::ln(i)),
            Limit::Finite(i) if i.is_zero() => Limit::MinusInfinity,
            Limit::PlusInfinity => Limit::PlusInfinity,
            _ => Limit::Unknown,
        };
        Tail::new(lo, hi, limit, None)
    }

    fn arctangent(&self) -> Result<Tail, NoValue> {
        let half = Interval { lo: 0.5 * elementary::PI.lo, hi: 0.5 * elementary::PI.hi };
        let found =
            self.rising(elementary::arctan, [(-half.hi, Limit::Finite(-half)), (half.hi, Limit::Finite(half))])?;
        Tail::new(found.lo, found.hi, found.limit, self.positive)
    }

    /// The angle of (x, y), in a half-plane that the point never leaves.
    fn angle(y: &Tail, x: &Tail) -> Result<Tail, NoValue> {
        let pi = Tail::constant(elementary::PI)?;
        let half = Tail::constant(Interval { lo: 0.5 * elementary::PI.lo, hi: 0.5 * elementary::PI.hi })?;
        let quotient = |a: &Tail, b: &Tail| a.product(&b.reciprocal()?)?.arctangent();
        if x.positive == Some(true) {
            quotient(y, x)
        } else if y.positive == Some(true) {
            half.sum(&quotient(x, y)?.negative())
        } else if y.positive == Some(false) {
            half.negative().sum(&quotient(x, y)?.negative())
        } else if x.positive == Some(false) && y.lo >= 0.0 {
            // From above, the half-axis belongs to the plane.
            pi.sum(&quotient(y, x)?)
        } else {
            Err(NoValue::Indeterminate)
        }
    }
}

impl crate::Uniform for Tail {
    type Context = ();

    fn blank(_: &()) -> Tail {
        Tail { lo: 0.0, hi: 0.0, limit: ZERO, positive: None }
    }
    /// Of one argument that stays bounded.
    fn rule(&mut self, cx: &(), op: Op, a: &Tail, _: &Tail) -> Result<(), NoValue> {
        if op.arity() != 1 {
            return Err(NoValue::Unsupported);
        }
        *self = a.on_bounded(|i| {
            let mut out = Interval::ZERO;
            op.apply(cx, &mut out, &i, &i).map(|()| out)
        })?;
        Ok(())
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        let mut value = Interval::ZERO;
        value.rational(&(), r)?;
        *self = Tail::constant(value)?;
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        *self = Tail::constant(elementary::PI)?;
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &Tail, _: &Tail) -> Result<(), NoValue> {
        self.clone_from(a);
        Ok(())
    }
    fn powi(&mut self, _: &(), a: &Tail, n: i32) -> Result<(), NoValue> {
        let power = a.raised(n.unsigned_abs())?;
        *self = if n < 0 { power.reciprocal()? } else { power };
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        *self = a.negative();
        Ok(())
    }
    fn sqrt(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        if a.lo < 0.0 {
            return Err(if a.hi < 0.0 { NoValue::OutOfDomain } else { NoValue::Indeterminate });
        }
        let root = |i: Interval| {
            let mut out = Interval::ZERO;
            // A limit may be said to lie below 0 by rounding alone.
            let inside = Interval { lo: i.lo.max(0.0), hi: i.hi };
            out.sqrt(&(), &inside).map_or(Interval::INVALID, |()| out)
        };
        let found = a.rising(root, [(f64::NAN, Limit::Unknown), (f64::INFINITY, Limit::PlusInfinity)])?;
        *self = Tail::new(found.lo, found.hi, found.limit, a.positive)?;
        Ok(())
    }
    fn exp(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        *self = a.exponential()?;
        Ok(())
    }
    fn ln(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        *self = a.logarithm()?;
        Ok(())
    }
    fn sin(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        *self = a.wave(elementary::sin)?;
        Ok(())
    }
    fn cos(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        *self = a.wave(elementary::cos)?;
        Ok(())
    }
    fn arctan(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        *self = a.arctangent()?;
        Ok(())
    }
    fn sinh(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        let ends = [(f64::NEG_INFINITY, Limit::MinusInfinity), (f64::INFINITY, Limit::PlusInfinity)];
        let found = a.rising(elementary::sinh, ends)?;
        *self = Tail::new(found.lo, found.hi, found.limit, a.positive)?;
        Ok(())
    }
    fn cosh(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        let ends = [(f64::NAN, Limit::Unknown), (f64::INFINITY, Limit::PlusInfinity)];
        *self = a.size()?.rising(elementary::cosh, ends)?;
        Ok(())
    }
    fn tanh(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        let one = |x: f64| (x, Limit::Finite(Interval::point(x)));
        let found = a.rising(elementary::tanh, [one(-1.0), one(1.0)])?;
        *self = Tail::new(found.lo, found.hi, found.limit, a.positive)?;
        Ok(())
    }
    fn abs(&mut self, _: &(), a: &Tail) -> Result<(), NoValue> {
        *self = a.size()?;
        Ok(())
    }
    fn add(&mut self, _: &(), a: &Tail, b: &Tail) -> Result<(), NoValue> {
        *self = a.sum(b)?;
        Ok(())
    }
    fn sub(&mut self, _: &(), a: &Tail, b: &Tail) -> Result<(), NoValue> {
        *self = a.sum(&b.negative())?;
        Ok(())
    }
    fn mul(&mut self, _: &(), a: &Tail, b: &Tail) -> Result<(), NoValue> {
        *self = a.product(b)?;
        Ok(())
    }
    fn div(&mut self, _: &(), a: &Tail, b: &Tail) -> Result<(), NoValue> {
        *self = a.product(&b.reciprocal()?)?;
        Ok(())
    }
    /// e^(b ln a), for a base that stays positive.
    fn pow(&mut self, _: &(), a: &Tail, b: &Tail) -> Result<(), NoValue> {
        *self = b.product(&a.logarithm()?)?.exponential()?;
        Ok(())
    }
    fn arctan2(&mut self, _: &(), y: &Tail, x: &Tail) -> Result<(), NoValue> {
        *self = Tail::angle(y, x)?;
        Ok(())
    }
    fn direction_cosine(&mut self, _: &(), a: &Tail, b: &Tail) -> Result<(), NoValue> {
        // The opposite direction has no cut on the left.
        *self = match a.positive {
            Some(false) => Tail::angle(&b.negative(), &a.negative())?.wave(elementary::cos)?.negative(),
            Some(true) | None => Tail::angle(b, a)?.wave(elementary::cos)?,
        };
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const START: f64 = 3.0;

    fn time() -> Tail {
        Tail::time(START, true)
    }

    fn number(x: f64) -> Tail {
        Tail::constant(Interval::point(x)).expect("a number")
    }

    /// An operation of the table.
    fn of(f: impl Fn(&mut Tail) -> Result<(), NoValue>) -> Result<Tail, NoValue> {
        let mut out = Tail::blank(&());
        f(&mut out).map(|()| out)
    }

    fn quotient(a: &Tail, b: &Tail) -> Result<Tail, NoValue> {
        of(|out| out.div(&(), a, b))
    }

    fn sine(a: &Tail) -> Tail {
        of(|out| out.sin(&(), a)).expect("a value")
    }

    fn exponential(a: &Tail) -> Tail {
        a.exponential().expect("a value")
    }

    #[test]
    fn forms_without_a_limit_have_none() {
        let t = time();
        let inverse = t.reciprocal().expect("not 0");
        let unknown = |tail: Result<Tail, NoValue>| assert_eq!(tail.expect("a value").limit(), Limit::Unknown);
        unknown(t.sum(&t.negative()));
        unknown(t.product(&inverse));
        unknown(quotient(&t, &t));
        unknown(quotient(&inverse, &inverse));
        unknown(Ok(sine(&t)));
        unknown(t.product(&sine(&t)));
        unknown(sine(&t).product(&number(1e-300)));
        unknown(sine(&t).sum(&number(1.0)));
        // 2 + sin t is bounded and away from 0; sin t / t is not away from 0.
        let small = quotient(&sine(&t), &t).expect("a value");
        assert_eq!(small.limit(), ZERO);
        assert!(small.reciprocal().is_err());
        unknown(sine(&t).sum(&number(2.0)).expect("a value").reciprocal());
    }

    #[test]
    fn limits_that_exist_are_found() {
        let t = time();
        let falling = exponential(&t.negative());
        assert_eq!((falling.limit(), falling.is_positive()), (ZERO, Some(true)));
        assert_eq!(falling.reciprocal().expect("positive").limit(), Limit::PlusInfinity);
        assert_eq!(falling.product(&sine(&t)).expect("a value").limit(), ZERO);
        assert_eq!(t.sum(&sine(&t)).expect("a value").limit(), Limit::PlusInfinity);
        assert_eq!(exponential(&t.raised(2).expect("a value")).limit(), Limit::PlusInfinity);
        assert_eq!(t.negative().raised(3).expect("a value").limit(), Limit::MinusInfinity);
        let Limit::Finite(half) = t.arctangent().expect("a value").limit() else { panic!("no limit") };
        assert!(half.contains(std::f64::consts::FRAC_PI_2) && half.width() < 1e-15);
        // From above the negative half-axis, from below, and across.
        let (one, inverse) = (number(-1.0), t.reciprocal().expect("not 0"));
        let Limit::Finite(above) = Tail::angle(&inverse, &one).expect("a value").limit() else { panic!("no limit") };
        assert!(above.contains(std::f64::consts::PI));
        let Limit::Finite(below) = Tail::angle(&inverse.negative(), &one).expect("a value").limit() else { panic!() };
        assert!(below.contains(-std::f64::consts::PI));
        assert!(Tail::angle(&quotient(&sine(&t), &t).expect("a value"), &one).is_err());
    }

    /// Bounds contain the values at many times, of combinations of all operations.
    #[test]
    fn bounds_contain_the_values() {
        let t = time();
        type Function = Box<dyn Fn(f64) -> f64>;
        let all: Vec<(Tail, Function)> = vec![
            (t, Box::new(|t| t)),
            (exponential(&number(-0.1).product(&t).expect("a value")), Box::new(|t| pxfm::f_exp(-0.1 * t))),
            (sine(&t), Box::new(pxfm::f_sin)),
            (t.logarithm().expect("positive"), Box::new(pxfm::f_log)),
            (t.arctangent().expect("a value"), Box::new(pxfm::f_atan)),
        ];
        for i in 0..5 {
            for j in 0..5 {
                let (a, b) = (all[i].0, all[j].0);
                let sum = a.sum(&b.negative()).expect("a value");
                let product = a.product(&b).expect("a value");
                let values = [START, 3.7, 11.0, 250.0, 1e5, 1e12].map(|t| (all[i].1(t), all[j].1(t)));
                for (x, y) in values {
                    let inside = |tail: &Tail, v: f64| {
                        // What is too large, or divided by what is too small, for a number says nothing.
                        if !v.is_finite() {
                            return;
                        }
                        let room = 1e-12 * (1.0 + v.abs());
                        assert!(tail.lo <= v + room && v - room <= tail.hi, "{i} {j}: {v} in {tail:?}");
                    };
                    inside(&sum, x - y);
                    inside(&product, x * y);
                    if let Ok(q) = quotient(&a, &b) {
                        inside(&q, x / y);
                    }
                    inside(&product.size().expect("a value"), (x * y).abs());
                    inside(&sum.raised(3).expect("a value"), (x - y) * (x - y) * (x - y));
                    inside(&product.raised(2).expect("a value"), x * y * x * y);
                }
            }
        }
    }
}
