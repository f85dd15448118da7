//! Ranges of the elementary functions over intervals whose ends are finite and in the domain.
//!
//! A monotone function takes its extremes at the ends. For the others the places of the extremes are computed with
//! intervals, and a place that may lie inside counts.

use super::round::{above, add_down, add_up, below, mul_down, mul_up, sqrt_down, sqrt_up};
use super::{Continuity, Interval, NoValue, Scalar, outside};
use crate::real::AGM_ITERATIONS;

/// π and the number after it.
pub(super) const PI: Interval = Interval { lo: std::f64::consts::PI, hi: std::f64::consts::PI.next_up() };

/// Beyond this the number of half turns in an argument is not computed: a range that is not a point is everything.
const MANY_TURNS: f64 = 1e12;

/// The value of a function at one number; `exact` is an argument and its value, both binary64, where there is such a pair.
#[inline(always)]
fn at(f: impl Fn(f64) -> f64, x: f64, exact: (f64, f64)) -> Interval {
    if x == exact.0 {
        return Interval::point(exact.1);
    }
    let v = f(x);
    Interval { lo: below(v), hi: above(v) }
}

/// A rising function.
#[inline(always)]
fn rising(f: impl Fn(f64) -> f64, a: Interval, exact: (f64, f64)) -> Interval {
    Interval { lo: at(&f, a.lo, exact).lo, hi: at(&f, a.hi, exact).hi }
}

impl Interval {
    /// What is known of a range anyway. Ends that are not numbers stay so.
    #[inline(always)]
    fn within(self, lo: f64, hi: f64) -> Interval {
        Interval { lo: if self.lo < lo { lo } else { self.lo }, hi: if self.hi > hi { hi } else { self.hi } }
    }
}

pub(super) fn exp(a: Interval) -> Interval {
    rising(pxfm::f_exp, a, (0.0, 1.0)).within(0.0, f64::INFINITY)
}

pub(super) fn ln(a: Interval) -> Interval {
    rising(pxfm::f_log, a, (1.0, 0.0))
}

pub(super) fn arcsin(a: Interval) -> Interval {
    let quarter = std::f64::consts::FRAC_PI_2.next_up();
    rising(pxfm::f_asin, a, (0.0, 0.0)).within(-quarter, quarter)
}

pub(super) fn arccos(a: Interval) -> Interval {
    let falling = |x: f64| at(pxfm::f_acos, x, (1.0, 0.0));
    Interval { lo: falling(a.hi).lo, hi: falling(a.lo).hi }.within(0.0, PI.hi)
}

pub(super) fn arctan(a: Interval) -> Interval {
    let quarter = std::f64::consts::FRAC_PI_2.next_up();
    rising(pxfm::f_atan, a, (0.0, 0.0)).within(-quarter, quarter)
}

pub(super) fn sinh(a: Interval) -> Interval {
    rising(pxfm::f_sinh, a, (0.0, 0.0))
}

pub(super) fn tanh(a: Interval) -> Interval {
    rising(pxfm::f_tanh, a, (0.0, 0.0)).within(-1.0, 1.0)
}

pub(super) fn cosh(a: Interval) -> Interval {
    let size = Interval { lo: a.mignitude(), hi: a.magnitude() };
    rising(pxfm::f_cosh, size, (0.0, 1.0)).within(1.0, f64::INFINITY)
}

/// The integers k for which (k + shift)·π may lie in `a`: first and last, none when they are in the wrong order.
fn half_turns(a: Interval, shift: f64) -> Option<(f64, f64)> {
    if a.magnitude() > MANY_TURNS {
        return None;
    }
    let place = |x: f64| Interval::point(x) / PI - Interval::point(shift);
    Some((place(a.lo).lo.ceil(), place(a.hi).hi.floor()))
}

/// Sine or cosine, whose extremes lie at (k + shift)·π.
fn wave(f: impl Fn(f64) -> f64, a: Interval, shift: f64, exact: (f64, f64)) -> Interval {
    if a.is_point() {
        return at(&f, a.lo, exact).within(-1.0, 1.0);
    }
    let ends = at(&f, a.lo, exact).hull(at(&f, a.hi, exact));
    let everything = Interval { lo: -1.0, hi: 1.0 };
    let Some((first, last)) = half_turns(a, shift).filter(|(first, last)| last - first < 1.5) else {
        return everything;
    };
    let mut range = ends;
    let mut k = first;
    while k <= last {
        // The value there is 1 for even k, −1 for odd k.
        range = range.hull(Interval::point(if k.rem_euclid(2.0) == 0.0 { 1.0 } else { -1.0 }));
        k += 1.0;
    }
    range.within(-1.0, 1.0)
}

pub(super) fn sin(a: Interval) -> Interval {
    wave(pxfm::f_sin, a, 0.5, (0.0, 0.0))
}

pub(super) fn cos(a: Interval) -> Interval {
    wave(pxfm::f_cos, a, 0.0, (0.0, 1.0))
}

/// Rising between its poles, at (k + ½)·π, none of which is a binary64 number.
pub(super) fn tan(a: Interval) -> Result<Interval, NoValue> {
    let free = a.is_point() || half_turns(a, 0.5).is_some_and(|(first, last)| first > last);
    if !free {
        return Err(NoValue::Indeterminate);
    }
    rising(pxfm::f_tan, a, (0.0, 0.0)).checked()
}

/// aⁿ: |a|ⁿ is rising in |a|.
pub(super) fn power(a: Interval, n: u32) -> Interval {
    match n {
        0 => return Interval::point(1.0),
        1 => return a,
        2 => return a.square(),
        _ => {}
    }
    let raise = |x: f64, times: fn(f64, f64) -> f64| {
        let (mut base, mut e, mut acc) = (x, n, 1.0);
        loop {
            if e & 1 == 1 {
                acc = times(acc, base);
            }
            e >>= 1;
            if e == 0 {
                return acc;
            }
            base = times(base, base);
        }
    };
    let (down, up) = (|x| raise(x, mul_down), |x| raise(x, mul_up));
    if n.is_multiple_of(2) {
        return Interval { lo: down(a.mignitude()), hi: up(a.magnitude()) };
    }
    let lo = if a.lo >= 0.0 { down(a.lo) } else { -up(-a.lo) };
    let hi = if a.hi >= 0.0 { up(a.hi) } else { -down(-a.hi) };
    Interval { lo, hi }
}

/// a^b for a > 0, or a ≥ 0 and b > 0.
pub(super) fn pow(a: Interval, b: Interval) -> Interval {
    let corner = |x: f64, y: f64| {
        if x == 0.0 {
            Interval::point(0.0)
        } else if x == 1.0 || y == 0.0 {
            Interval::point(1.0)
        } else {
            at(|x| pxfm::f_pow(x, y), x, (f64::NAN, 0.0))
        }
    };
    let ends = [(a.lo, b.lo), (a.lo, b.hi), (a.hi, b.lo), (a.hi, b.hi)].map(|(x, y)| corner(x, y));
    if ends.iter().any(|c| c.lo.is_nan() || c.hi.is_nan()) {
        return Interval::INVALID;
    }
    // a^b is 1 for all b where a is 1, and for all a where b is 0; the corners on both sides then contain it.
    ends[0].hull(ends[1]).hull(ends[2]).hull(ends[3]).within(0.0, f64::INFINITY)
}

impl Interval {
    /// The range of the angle of (x, y) in (−π, π], and whether it is continuous on the box.
    ///
    /// A box that does not contain the origin is convex, so that its extreme angles are at corners, unless it meets the
    /// negative half-axis from below.
    ///
    /// # Errors
    /// [`NoValue::OutOfDomain`] for the origin alone, [`NoValue::Indeterminate`] for a box that contains it.
    pub fn principal_angle(y: Interval, x: Interval) -> Result<(Interval, Continuity), NoValue> {
        y.checked()?;
        x.checked()?;
        if y.contains(0.0) && x.contains(0.0) {
            return Err(outside(y.is_zero() && x.is_zero()));
        }
        if x.lo < 0.0 && y.lo < 0.0 && y.hi >= 0.0 {
            return Ok((Interval { lo: -PI.hi, hi: PI.hi }, Continuity::Broken));
        }
        let corner = |y: f64, x: f64| {
            if y == 0.0 && x > 0.0 {
                return Interval::point(0.0);
            }
            // Never −0, which would be the other side of the cut.
            let v = pxfm::f_atan2(y + 0.0, x + 0.0);
            Interval { lo: below(v), hi: above(v) }
        };
        let ends = [(y.lo, x.lo), (y.lo, x.hi), (y.hi, x.lo), (y.hi, x.hi)].map(|(y, x)| corner(y, x));
        let range = ends[0].hull(ends[1]).hull(ends[2]).hull(ends[3]);
        Ok((range.within(-PI.hi, PI.hi).checked()?, Continuity::Everywhere))
    }
}

/// a/√(a² + b²), for numbers that are not both 0.
fn direction_cosine(a: f64, b: f64) -> Interval {
    if a == 0.0 {
        return Interval::ZERO;
    }
    if b == 0.0 {
        return Interval::point(a.signum());
    }
    let s = a.scale(b);
    let [x, y] = [a, b].map(|x| Interval { lo: mul_down(x, s), hi: mul_up(x, s) });
    let square = |x: Interval| power(x, 2);
    let sum = square(x) + square(y);
    x / Interval { lo: sqrt_down(sum.lo), hi: sqrt_up(sum.hi) }
}

impl Interval {
    /// The range of a/√(a² + b²) over a box that does not contain the origin: it rises with a, and the nearer to the axis b is, the
    /// farther it is from 0.
    pub(super) fn direction_cosine_of(a: Interval, b: Interval) -> Interval {
        let (near, far) = (b.mignitude(), b.magnitude());
        let lo = direction_cosine(a.lo, if a.lo < 0.0 { near } else { far }).lo;
        let hi = direction_cosine(a.hi, if a.hi > 0.0 { near } else { far }).hi;
        Interval { lo, hi }.within(-1.0, 1.0)
    }
}

/// The arithmetic–geometric mean of two numbers that are not negative, which lies between all pairs of the iteration.
pub(super) fn agm(a: f64, b: f64) -> Interval {
    if a == 0.0 || b == 0.0 {
        return Interval::ZERO;
    }
    if a == b {
        return Interval::point(a);
    }
    let (mut x, mut y) = (Interval::point(a), Interval::point(b));
    let mut found = x.hull(y);
    for _ in 0..AGM_ITERATIONS {
        let half = |z: f64| 0.5 * z;
        let mean = Interval {
            lo: if x.lo.max(y.lo) < 1e-300 { x.lo.min(y.lo) } else { half(add_down(x.lo, y.lo)) },
            hi: if x.hi.max(y.hi) < 1e-300 || x.hi.max(y.hi) > 1e300 {
                x.hi.max(y.hi)
            } else {
                half(add_up(x.hi, y.hi))
            },
        };
        let geometric = Interval {
            lo: mul_down(sqrt_down(x.lo), sqrt_down(y.lo)).max(0.0),
            hi: mul_up(sqrt_up(x.hi), sqrt_up(y.hi)),
        };
        let product = x * y;
        // The root of the product is sharper, where the product is in range.
        let sharp = Interval { lo: sqrt_down(product.lo.max(0.0)), hi: sqrt_up(product.hi) };
        (x, y) = (mean, geometric.intersection(sharp).unwrap_or(geometric));
        let now = x.hull(y);
        match found.intersection(now) {
            Some(both) if both != found => found = both,
            _ => break,
        }
    }
    found
}
