//! Numbers with derivatives: the types of `num_dual`, over any [`Scalar`].
//!
//! **In:** values with their derivative along one direction. **Out:** results with theirs: [`Dual`] has the first,
//! [`Dual2`] the first and the second derivative.
//!
//! **Guaranteed:** the value part is what the base type computes, bit for bit. A result exists only if its derivatives do;
//! the derivative of a constant (tangent exactly 0) is 0 also at a branch point.
//!
//! **Why not the methods of `num_dual`:** there the quotient is a·(1/b), whose value differs from the quotient in every
//! fourth case; 0^1.5 and tanh 800 are NaN, and so are the derivatives of √ and arctan2 at constants. Sums and products
//! are the same.

use super::slope::{curvature, power, slope};
use super::{NoValue, Number, Op, Rational, Scalar, scalar::value};
use num_dual::{Dual, Dual2};

/// The operations that both kinds of dual number write alike.
macro_rules! common {
    ($($zero:ident)*) => {
        type Context = ();

        fn blank(_: &()) -> Self {
            Self::new(B::ZERO $(, B::$zero)*)
        }
        fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
            *self = Number::blank(&());
            self.re.rational(&(), r)
        }
        fn pi(&mut self, _: &()) -> Result<(), NoValue> {
            *self = Number::blank(&());
            self.re.pi(&())
        }
        fn restrict(&mut self, _: &(), a: &Self, _: &Self) -> Result<(), NoValue> {
            self.clone_from(a);
            Ok(())
        }
        /// The chain rule; of two arguments no derivatives are known, unless both are constant.
        #[inline(always)]
        fn rule(&mut self, _: &(), op: Op, a: &Self, b: &Self) -> Result<(), NoValue> {
            let mut v = B::ZERO;
            op.apply(&(), &mut v, &a.re, &b.re)?;
            self.assign(if op.arity() == 1 { Self::compose(op, a, v) } else { Self::unknown(a, b, v) })
        }
    };
}

/// A dual number whose parts can be checked together.
trait Parts<B>: Sized {
    /// Writes value and derivatives, if all of them exist.
    fn assign(&mut self, parts: Self) -> Result<(), NoValue>;
    /// Value v = f(a) with derivatives.
    fn compose(op: Op, a: &Self, v: B) -> Self;
    /// Value v, with the derivatives of constants if a and b are, and else with invalid ones.
    fn unknown(a: &Self, b: &Self, v: B) -> Self;
}

/// The value part of an operation of two arguments.
#[inline(always)]
fn centre<B: Scalar>(base: impl FnOnce(&mut B) -> Result<(), NoValue>) -> Result<B, NoValue> {
    let mut v = B::ZERO;
    base(&mut v)?;
    Ok(v)
}

/// b/√(a² + b²), which is the sine where a/√(a² + b²) is the cosine.
#[inline(always)]
fn other_cosine<B: Scalar>(a: B, b: B) -> B {
    value(|out: &mut B, cx, b| out.direction_cosine(cx, b, &a), b)
}

/// The arguments y, x of arctan2 times a power of two, that factor, and the square of the scaled radius.
#[inline(always)]
fn polar<B: Scalar>(y: B, x: B) -> (B, B, B, B) {
    let s = y.scale(x);
    let (y, x) = (y * s, x * s);
    (y, x, s, y * y + x * x)
}

impl<B: Scalar> Parts<B> for Dual<B> {
    #[inline(always)]
    fn assign(&mut self, parts: Self) -> Result<(), NoValue> {
        let eps = parts.eps.checked()?;
        self.re = parts.re.poisoned_by(eps);
        self.eps = eps.poisoned_by(parts.re);
        Ok(())
    }
    #[inline(always)]
    fn compose(op: Op, a: &Self, v: B) -> Self {
        if a.eps.is_zero() {
            return Dual::new(v, B::ZERO);
        }
        Dual::new(v, slope(op, a.re, v).times(a.eps))
    }
    fn unknown(a: &Self, b: &Self, v: B) -> Self {
        Dual::new(v, B::INVALID.times(a.eps) + B::INVALID.times(b.eps))
    }
}

impl<B: Scalar> super::Uniform for Dual<B> {
    common! { ZERO }

    #[inline]
    fn add(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.add(&(), &a.re, &b.re))?;
        self.assign(Dual::new(v, a.eps + b.eps))
    }
    #[inline]
    fn sub(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.sub(&(), &a.re, &b.re))?;
        self.assign(Dual::new(v, a.eps - b.eps))
    }
    #[inline]
    fn mul(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.mul(&(), &a.re, &b.re))?;
        self.assign(Dual::new(v, a.eps * b.re + b.eps * a.re))
    }
    /// (a/b)′ = (a′ − (a/b)·b′)/b.
    #[inline]
    fn div(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.div(&(), &a.re, &b.re))?;
        self.assign(Dual::new(v, (a.eps - v * b.eps) / b.re))
    }
    /// (a^b)′ = b·a^(b−1)·a′ + a^b·ln a·b′.
    fn pow(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.pow(&(), &a.re, &b.re))?;
        let mut tangent = B::ZERO;
        if !a.eps.is_zero() {
            tangent = (b.re * power(a.re, b.re - B::integer(1))).times(a.eps);
        }
        if !b.eps.is_zero() {
            tangent = tangent + (v * value(B::ln, a.re)).times(b.eps);
        }
        self.assign(Dual::new(v, tangent))
    }
    /// θ′ = (x·y′ − y·x′)/(x² + y²).
    fn arctan2(&mut self, _: &(), y: &Self, x: &Self) -> Result<(), NoValue> {
        let v = centre(|angle: &mut B| angle.arctan2(&(), &y.re, &x.re))?;
        let (sy, sx, s, square) = polar(y.re, x.re);
        self.assign(Dual::new(v, (sx * y.eps - sy * x.eps) / square * s))
    }
    /// (cos θ)′ = −sin θ·θ′, with r²θ′ = a·b′ − b·a′.
    fn direction_cosine(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.direction_cosine(&(), &a.re, &b.re))?;
        let (sb, sa, s, square) = polar(b.re, a.re);
        let turn = (sb * a.eps - sa * b.eps) / square * s;
        self.assign(Dual::new(v, other_cosine(a.re, b.re) * turn))
    }
}

impl<B: Scalar> Parts<B> for Dual2<B> {
    #[inline(always)]
    fn assign(&mut self, parts: Self) -> Result<(), NoValue> {
        let (v1, v2) = (parts.v1.checked()?, parts.v2.checked()?);
        self.re = parts.re.poisoned_by(v1).poisoned_by(v2);
        self.v1 = v1.poisoned_by(self.re);
        self.v2 = v2.poisoned_by(self.re);
        Ok(())
    }
    /// f(a)′ = f′(a)·a′, f(a)″ = f′(a)·a″ + f″(a)·a′².
    #[inline(always)]
    fn compose(op: Op, a: &Self, v: B) -> Self {
        let s = slope(op, a.re, v);
        let c = curvature(op, a.re, v, s);
        Dual2::new(v, s.times(a.v1), s.times(a.v2) + c.times(a.v1).times(a.v1))
    }
    fn unknown(a: &Self, b: &Self, v: B) -> Self {
        let [v1, v2] = [(a.v1, b.v1), (a.v2, b.v2)].map(|(a, b)| B::INVALID.times(a) + B::INVALID.times(b));
        Dual2::new(v, v1, v2)
    }
}

impl<B: Scalar> super::Uniform for Dual2<B> {
    common! { ZERO ZERO }

    #[inline]
    fn add(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.add(&(), &a.re, &b.re))?;
        self.assign(Dual2::new(v, a.v1 + b.v1, a.v2 + b.v2))
    }
    #[inline]
    fn sub(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.sub(&(), &a.re, &b.re))?;
        self.assign(Dual2::new(v, a.v1 - b.v1, a.v2 - b.v2))
    }
    #[inline]
    fn mul(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.mul(&(), &a.re, &b.re))?;
        let cross = a.v1 * b.v1;
        self.assign(Dual2::new(v, a.v1 * b.re + b.v1 * a.re, a.v2 * b.re + (cross + cross) + b.v2 * a.re))
    }
    /// With q = a/b: q′ = (a′ − q·b′)/b, q″ = (a″ − 2q′·b′ − q·b″)/b.
    #[inline]
    fn div(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.div(&(), &a.re, &b.re))?;
        let v1 = (a.v1 - v * b.v1) / b.re;
        let cross = v1 * b.v1;
        self.assign(Dual2::new(v, v1, (a.v2 - (cross + cross) - v * b.v2) / b.re))
    }
    /// The partial derivatives of a^b, with p = a^(b−1) and l = ln a: b·p and a^b·l; b(b−1)·a^(b−2), p·(1 + b·l), a^b·l².
    fn pow(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.pow(&(), &a.re, &b.re))?;
        let one = B::integer(1);
        let (mut v1, mut v2) = (B::ZERO, B::ZERO);
        let less = b.re - one;
        if !(a.v1.is_zero() && a.v2.is_zero()) {
            let by_a = b.re * power(a.re, less);
            let by_aa = b.re * less * power(a.re, less - one);
            v1 = by_a.times(a.v1);
            v2 = by_a.times(a.v2) + by_aa.times(a.v1).times(a.v1);
        }
        if !(b.v1.is_zero() && b.v2.is_zero()) {
            let log = value(B::ln, a.re);
            let (by_b, cross) = (v * log, power(a.re, less) * (one + b.re * log));
            v1 = v1 + by_b.times(b.v1);
            let mixed = cross.times(a.v1).times(b.v1);
            v2 = v2 + by_b.times(b.v2) + (by_b * log).times(b.v1).times(b.v1) + (mixed + mixed);
        }
        self.assign(Dual2::new(v, v1, v2))
    }
    /// r²θ′ = x·y′ − y·x′ and r²θ″ = x·y″ − y·x″ − 2θ′·(x·x′ + y·y′).
    fn arctan2(&mut self, _: &(), y: &Self, x: &Self) -> Result<(), NoValue> {
        let v = centre(|angle: &mut B| angle.arctan2(&(), &y.re, &x.re))?;
        let (sy, sx, s, square) = polar(y.re, x.re);
        let v1 = (sx * y.v1 - sy * x.v1) / square * s;
        let outward = v1 * (sx * x.v1 + sy * y.v1);
        let v2 = (sx * y.v2 - sy * x.v2 - (outward + outward)) / square * s;
        self.assign(Dual2::new(v, v1, v2))
    }
    /// (cos θ)′ = −sin θ·θ′ and (cos θ)″ = −sin θ·θ″ − cos θ·θ′², with θ as in `arctan2`.
    fn direction_cosine(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        let v = centre(|x: &mut B| x.direction_cosine(&(), &a.re, &b.re))?;
        let (sb, sa, s, square) = polar(b.re, a.re);
        // −θ′ and −θ″.
        let v1 = (sb * a.v1 - sa * b.v1) / square * s;
        let outward = v1 * (sa * a.v1 + sb * b.v1);
        let v2 = (sb * a.v2 - sa * b.v2 - (outward + outward)) / square * s;
        let sine = other_cosine(a.re, b.re);
        self.assign(Dual2::new(v, sine * v1, sine * v2 - v * v1 * v1))
    }
}
