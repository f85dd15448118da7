//! Ranges of functions over boxes on which they may lack values.
//!
//! **In:** decorated intervals that contain the arguments. **Out:** one that contains every value *where there is one*, and
//! whether there is one at every point, and whether it is continuous.
//!
//! **Guaranteed:** for every point of the box at which the operation has a value, the value lies in the range, rounding
//! included. [`Decorated::is_defined`] is true only if the operation, and everything before it, has a value at every point of
//! the box; [`Decorated::is_continuous`] only if it is moreover continuous there. [`NoValue::OutOfDomain`] means that there is
//! a value at no point of the box. (In the words of IEEE 1788-2015, §11.2: decorations `trv`, `def`, `dac`, and the empty set.)
//!
//! **Why beside [`Interval`]:** that one refuses every box that touches the edge of a domain, which is right along a motion.
//! Over a box of parameters the edge of a domain is an ordinary place: √x ≥ 0 holds on [−1, 1] wherever √x has a value, and
//! the domain is closed, so that 0 belongs to it.
//!
//! Ends may be infinite here: 1/x on [0, 1] is [1, ∞).

use super::{Interval, NoValue, elementary, round};
use crate::{Continuity, Number, Op, Rational, Scalar};

/// See the module.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decorated {
    range: Interval,
    defined: bool,
    continuous: bool,
}

const EVERYTHING: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

/// A range whose ends are numbers or infinite: an end that could not be computed is replaced by the infinite one.
fn settled(range: Interval) -> Interval {
    let lo = if range.lo.is_nan() || range.lo == f64::INFINITY { f64::NEG_INFINITY } else { range.lo };
    let hi = if range.hi.is_nan() || range.hi == f64::NEG_INFINITY { f64::INFINITY } else { range.hi };
    if lo <= hi { Interval { lo, hi } } else { EVERYTHING }
}

impl Decorated {
    /// A quantity of which nothing is known, not even whether it has a value.
    pub const UNKNOWN: Decorated = Decorated { range: EVERYTHING, defined: false, continuous: false };

    /// The same quantity, whose values lie also in another interval. If the two have nothing in common, nothing changes.
    pub fn narrowed(self, other: Interval) -> Decorated {
        Decorated { range: self.range.intersection(other).unwrap_or(self.range), ..self }
    }

    /// A quantity that has all values of an interval.
    pub fn all_of(range: Interval) -> Decorated {
        Decorated { range: settled(range), defined: true, continuous: true }
    }

    /// What contains the values; ends may be infinite.
    pub fn range(&self) -> Interval {
        self.range
    }

    /// Whether there is a value at every point.
    pub fn is_defined(&self) -> bool {
        self.defined
    }

    /// Whether there is a value at every point, and it depends on the point continuously.
    pub fn is_continuous(&self) -> bool {
        self.defined && self.continuous
    }

    fn is_finite(&self) -> bool {
        self.range.lo.is_finite() && self.range.hi.is_finite()
    }

    /// A result of arguments with these decorations, for an operation that is continuous.
    fn set(&mut self, range: Interval, of: &[&Decorated]) {
        *self = Decorated {
            range: settled(range),
            defined: of.iter().all(|a| a.defined),
            continuous: of.iter().all(|a| a.continuous),
        };
    }

    /// The operation lacks a value somewhere.
    fn partly(&mut self) {
        (self.defined, self.continuous) = (false, false);
    }

    /// The part of the range from `lo` to `hi`, and whether that is all of it.
    ///
    /// # Errors
    /// [`NoValue::OutOfDomain`] where nothing is left.
    fn within(&self, lo: f64, hi: f64) -> Result<(Interval, bool), NoValue> {
        let part = self.range.intersection(Interval { lo, hi }).ok_or(NoValue::OutOfDomain)?;
        Ok((part, part == self.range))
    }
}

/// The range with infinite ends replaced by the last numbers, for functions that have limits.
fn clipped(a: Interval) -> Interval {
    Interval { lo: a.lo.max(-f64::MAX), hi: a.hi.min(f64::MAX) }
}

/// a/b, where b is not 0 alone.
fn quotient(a: Interval, b: Interval) -> Interval {
    if !b.contains(0.0) {
        return settled(a / b);
    }
    // Of the divisors only those count that are not 0.
    let (above, below) = (b.hi > 0.0, b.lo < 0.0);
    match (above, below) {
        (true, false) if a.lo >= 0.0 => Interval { lo: round::div_down(a.lo, b.hi).max(0.0), hi: f64::INFINITY },
        (true, false) if a.hi <= 0.0 => Interval { lo: f64::NEG_INFINITY, hi: round::div_up(a.hi, b.hi).min(0.0) },
        (false, true) if a.lo >= 0.0 => Interval { lo: f64::NEG_INFINITY, hi: round::div_up(a.lo, b.lo).min(0.0) },
        (false, true) if a.hi <= 0.0 => Interval { lo: round::div_down(a.hi, b.lo).max(0.0), hi: f64::INFINITY },
        _ if a.is_zero() => Interval::ZERO,
        _ => EVERYTHING,
    }
}

impl crate::Uniform for Decorated {
    type Context = ();

    fn blank(_: &()) -> Decorated {
        Decorated::all_of(Interval::ZERO)
    }
    /// What is an interval has values everywhere, and is continuous. Of anything else nothing is known.
    fn rule(&mut self, cx: &(), op: Op, a: &Decorated, b: &Decorated) -> Result<(), NoValue> {
        let (mut range, known) = (Interval::ZERO, a.is_finite() && b.is_finite());
        match op.apply(cx, &mut range, &a.range, &b.range) {
            Ok(()) if known => self.set(range, &[a, b]),
            Err(NoValue::OutOfDomain) if known => return Err(NoValue::OutOfDomain),
            Ok(()) | Err(_) => *self = Decorated::UNKNOWN,
        }
        Ok(())
    }
    fn rational(&mut self, cx: &(), r: &Rational) -> Result<(), NoValue> {
        let mut value = Interval::ZERO;
        value.rational(cx, r)?;
        *self = Decorated::all_of(value);
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        *self = Decorated::all_of(elementary::PI);
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &Decorated, b: &Decorated) -> Result<(), NoValue> {
        self.set(a.range, &[a, b]);
        Ok(())
    }
    fn powi(&mut self, _: &(), a: &Decorated, n: i32) -> Result<(), NoValue> {
        let power = settled(elementary::power(a.range, n.unsigned_abs()));
        if n >= 0 {
            self.set(power, &[a]);
            return Ok(());
        }
        if a.range.is_zero() {
            return Err(NoValue::OutOfDomain);
        }
        self.set(quotient(Interval::point(1.0), power), &[a]);
        if a.range.contains(0.0) {
            self.partly();
        }
        Ok(())
    }
    fn neg(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        self.set(-a.range, &[a]);
        Ok(())
    }
    fn sqrt(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        let (part, all) = a.within(0.0, f64::INFINITY)?;
        let lo = if part.lo == 0.0 { 0.0 } else { round::sqrt_down(part.lo) };
        let hi = if part.hi == f64::INFINITY { f64::INFINITY } else { round::sqrt_up(part.hi) };
        self.set(Interval { lo, hi }, &[a]);
        if !all {
            self.partly();
        }
        Ok(())
    }
    fn exp(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        let lo = if a.range.lo == f64::NEG_INFINITY { 0.0 } else { elementary::exp(Interval::point(a.range.lo)).lo };
        let hi = if a.range.hi == f64::INFINITY { a.range.hi } else { elementary::exp(Interval::point(a.range.hi)).hi };
        self.set(Interval { lo, hi }, &[a]);
        Ok(())
    }
    fn ln(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        if a.range.hi <= 0.0 {
            return Err(NoValue::OutOfDomain);
        }
        let positive = a.range.lo > 0.0;
        let lo = if positive { elementary::ln(Interval::point(a.range.lo)).lo } else { f64::NEG_INFINITY };
        let hi = if a.range.hi == f64::INFINITY { a.range.hi } else { elementary::ln(Interval::point(a.range.hi)).hi };
        self.set(Interval { lo, hi }, &[a]);
        if !positive {
            self.partly();
        }
        Ok(())
    }
    fn sin(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        let all = Interval { lo: -1.0, hi: 1.0 };
        self.set(if a.is_finite() { elementary::sin(a.range) } else { all }, &[a]);
        Ok(())
    }
    fn cos(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        let all = Interval { lo: -1.0, hi: 1.0 };
        self.set(if a.is_finite() { elementary::cos(a.range) } else { all }, &[a]);
        Ok(())
    }
    fn arcsin(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        let (part, all) = a.within(-1.0, 1.0)?;
        self.set(elementary::arcsin(part), &[a]);
        if !all {
            self.partly();
        }
        Ok(())
    }
    fn arccos(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        let (part, all) = a.within(-1.0, 1.0)?;
        self.set(elementary::arccos(part), &[a]);
        if !all {
            self.partly();
        }
        Ok(())
    }
    fn arctan(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        self.set(elementary::arctan(clipped(a.range)), &[a]);
        Ok(())
    }
    fn sinh(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        let one = |x: f64| if x.is_finite() { elementary::sinh(Interval::point(x)) } else { Interval::point(x) };
        self.set(Interval { lo: one(a.range.lo).lo, hi: one(a.range.hi).hi }, &[a]);
        Ok(())
    }
    fn cosh(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        let range = if a.is_finite() { elementary::cosh(a.range) } else { Interval { lo: 1.0, hi: f64::INFINITY } };
        self.set(range, &[a]);
        Ok(())
    }
    fn tanh(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        self.set(elementary::tanh(clipped(a.range)), &[a]);
        Ok(())
    }
    fn abs(&mut self, _: &(), a: &Decorated) -> Result<(), NoValue> {
        self.set(Interval { lo: a.range.mignitude(), hi: a.range.magnitude() }, &[a]);
        Ok(())
    }
    fn add(&mut self, _: &(), a: &Decorated, b: &Decorated) -> Result<(), NoValue> {
        self.set(a.range + b.range, &[a, b]);
        Ok(())
    }
    fn sub(&mut self, _: &(), a: &Decorated, b: &Decorated) -> Result<(), NoValue> {
        self.set(a.range - b.range, &[a, b]);
        Ok(())
    }
    fn mul(&mut self, _: &(), a: &Decorated, b: &Decorated) -> Result<(), NoValue> {
        self.set(a.range * b.range, &[a, b]);
        Ok(())
    }
    fn div(&mut self, _: &(), a: &Decorated, b: &Decorated) -> Result<(), NoValue> {
        if b.range.is_zero() {
            return Err(NoValue::OutOfDomain);
        }
        self.set(quotient(a.range, b.range), &[a, b]);
        if b.range.contains(0.0) {
            self.partly();
        }
        Ok(())
    }
    fn pow(&mut self, _: &(), a: &Decorated, b: &Decorated) -> Result<(), NoValue> {
        let (base, all) = a.within(0.0, f64::INFINITY)?;
        let at_zero = base.lo == 0.0 && b.range.lo <= 0.0;
        if base.is_zero() && b.range.hi <= 0.0 {
            return Err(NoValue::OutOfDomain);
        }
        let range = if a.is_finite() && b.is_finite() && !at_zero {
            elementary::pow(base, b.range)
        } else {
            Interval { lo: 0.0, hi: f64::INFINITY }
        };
        self.set(range, &[a, b]);
        if !all || at_zero {
            self.partly();
        }
        Ok(())
    }
    fn arctan2(&mut self, _: &(), y: &Decorated, x: &Decorated) -> Result<(), NoValue> {
        let all = Interval { lo: -elementary::PI.hi, hi: elementary::PI.hi };
        if y.range.is_zero() && x.range.is_zero() {
            return Err(NoValue::OutOfDomain);
        }
        if y.range.contains(0.0) && x.range.contains(0.0) {
            self.set(all, &[y, x]);
            self.partly();
            return Ok(());
        }
        let found = Interval::principal_angle(y.range, x.range).ok().filter(|_| y.is_finite() && x.is_finite());
        let (range, continuity) = found.unwrap_or((all, Continuity::Broken));
        self.set(range, &[y, x]);
        self.continuous &= continuity == Continuity::Everywhere;
        Ok(())
    }
    fn direction_cosine(&mut self, _: &(), a: &Decorated, b: &Decorated) -> Result<(), NoValue> {
        if a.range.is_zero() && b.range.is_zero() {
            return Err(NoValue::OutOfDomain);
        }
        let around = a.range.contains(0.0) && b.range.contains(0.0);
        let known = !around && a.is_finite() && b.is_finite();
        let all = Interval { lo: -1.0, hi: 1.0 };
        self.set(if known { Interval::direction_cosine_of(a.range, b.range) } else { all }, &[a, b]);
        if around {
            self.partly();
        }
        Ok(())
    }
    fn agm(&mut self, _: &(), a: &Decorated, b: &Decorated) -> Result<(), NoValue> {
        let ((p, all_of_a), (q, all_of_b)) = (a.within(0.0, f64::INFINITY)?, b.within(0.0, f64::INFINITY)?);
        let range = if a.is_finite() && b.is_finite() {
            Interval { lo: elementary::agm(p.lo, q.lo).lo, hi: elementary::agm(p.hi, q.hi).hi }
        } else {
            Interval { lo: 0.0, hi: f64::INFINITY }
        };
        self.set(range, &[a, b]);
        if !(all_of_a && all_of_b) {
            self.partly();
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Draws, Op};

    fn of(lo: f64, hi: f64) -> Decorated {
        Decorated::all_of(Interval { lo, hi })
    }

    fn apply(op: Op, a: Decorated, b: Decorated) -> Result<Decorated, NoValue> {
        let mut out = Decorated::blank(&());
        op.apply(&(), &mut out, &a, &b).map(|()| out)
    }

    #[test]
    fn edges_of_domains_belong_to_them_or_not() {
        let unit = of(0.0, 1.0);
        let root = apply(Op::Sqrt, unit, unit).expect("a value");
        assert!(root.is_continuous() && root.range() == unit.range());
        let beyond = apply(Op::Sqrt, of(-1.0, 1.0), unit).expect("a value at some points");
        assert!(!beyond.is_defined() && !beyond.is_continuous());
        assert_eq!(beyond.range(), unit.range());
        assert_eq!(apply(Op::Sqrt, of(-2.0, -1e-300), unit), Err(NoValue::OutOfDomain));
        let log = apply(Op::Ln, unit, unit).expect("a value at some points");
        assert!(!log.is_defined() && log.range().lo() == f64::NEG_INFINITY);
        assert_eq!(apply(Op::Ln, of(-1.0, 0.0), unit), Err(NoValue::OutOfDomain));
        assert_eq!(apply(Op::Arccos, of(1.0 + 1e-15, 2.0), unit), Err(NoValue::OutOfDomain));
        assert!(apply(Op::Arccos, of(-1.0, 1.0), unit).is_ok_and(|v| v.is_defined()));
    }

    #[test]
    fn a_divisor_that_may_vanish_leaves_half_lines() {
        let one = of(1.0, 2.0);
        let q = apply(Op::Div, one, of(0.0, 4.0)).expect("a value at some points");
        assert_eq!((q.range().lo(), q.range().hi()), (0.25, f64::INFINITY));
        assert!(!q.is_defined());
        let q = apply(Op::Div, one, of(-4.0, 0.0)).expect("a value at some points");
        assert_eq!((q.range().lo(), q.range().hi()), (f64::NEG_INFINITY, -0.25));
        let q = apply(Op::Div, one, of(-1.0, 4.0)).expect("a value at some points");
        assert_eq!(q.range(), EVERYTHING);
        assert_eq!(apply(Op::Div, one, of(0.0, 0.0)), Err(NoValue::OutOfDomain));
        let power = apply(Op::Powi(-2), of(-1.0, 2.0), one).expect("a value at some points");
        assert_eq!((power.range().lo(), power.range().hi(), power.is_defined()), (0.25, f64::INFINITY, false));
    }

    #[test]
    fn a_cut_is_defined_and_not_continuous() {
        let angle = apply(Op::Arctan2, of(-1.0, 1.0), of(-2.0, -1.0)).expect("a value");
        assert!(angle.is_defined() && !angle.is_continuous());
        let angle = apply(Op::Arctan2, of(-1.0, 1.0), of(-1.0, 1.0)).expect("a value at some points");
        assert!(!angle.is_defined());
        // What comes after a break stays broken.
        let broken = apply(Op::Arctan2, of(-1.0, 1.0), of(-2.0, -1.0)).expect("a value");
        assert!(!apply(Op::Mul, broken, of(0.0, 1.0)).expect("a value").is_continuous());
    }

    /// Every value at a point of the box lies in the range, and where one is missing the range says so.
    #[test]
    fn values_at_points_lie_in_the_range() {
        let mut draws = Draws::new(7);
        let mut uniform = |lo: f64, hi: f64| lo + (hi - lo) * ((draws.bits() >> 11) as f64 / (1u64 << 53) as f64);
        let ends = [f64::NEG_INFINITY, -3.0, -1.0, -0.25, 0.0, 0.5, 1.0, 2.0, f64::INFINITY];
        let mut compared = 0;
        for &op in Op::EVERY {
            for round in 0..3_000 {
                let mut side = |wild: bool| {
                    let (a, b) = if wild {
                        let pick = |x: f64| ends[(x * ends.len() as f64) as usize % ends.len()];
                        (pick(uniform(0.0, 1.0)), pick(uniform(0.0, 1.0)))
                    } else {
                        (uniform(-3.0, 3.0), uniform(-3.0, 3.0))
                    };
                    let (lo, hi) = (a.min(b), a.max(b));
                    if lo == hi && lo.is_infinite() { (0.0, f64::INFINITY) } else { (lo, hi) }
                };
                let (p, q) = (side(round % 2 == 0), side(round % 2 == 0));
                let range = apply(op, of(p.0, p.1), of(q.0, q.1));
                for _ in 0..4 {
                    let (x, y) = (uniform(p.0.max(-50.0), p.1.min(50.0)), uniform(q.0.max(-50.0), q.1.min(50.0)));
                    let mut value = Interval::ZERO;
                    let at_point = op.apply(&(), &mut value, &Interval::point(x), &Interval::point(y));
                    match (at_point, range) {
                        (Ok(()), Ok(range)) => {
                            compared += 1;
                            let meets = range.range().intersection(value).is_some();
                            assert!(meets, "{op:?} at ({x}, {y}): {value} outside {:?} for {p:?}, {q:?}", range);
                        }
                        (Ok(()), Err(reason)) => panic!("{op:?} has a value at ({x}, {y}): {reason} for {p:?}, {q:?}"),
                        (Err(NoValue::OutOfDomain), Ok(range)) => {
                            assert!(!range.is_defined(), "{op:?} has no value at ({x}, {y}) in {p:?}, {q:?}");
                        }
                        _ => {}
                    }
                }
            }
        }
        assert!(compared > 50_000, "{compared}");
    }
}
