//! Many points at once.
//!
//! **In:** one array of points per quantity. **Out:** one array per result, in the same order.
//!
//! **Guaranteed:** each lane is, bit for bit, what `f64` (or a dual over it) computes for that point alone. A lane without a
//! value is NaN, and stays so: every operation turns anything that is not finite into NaN, so that 1/(1/0) cannot become
//! 0. No operation fails as a whole.
//!
//! **Why arrays and not iterators over points:** the price of reading one instruction of the tape is paid once per block,
//! and the loops of + − × ÷ √ become vector instructions.

use super::slope::slope;
use super::wide::{Convolution, SeriesSteps};
use super::{Instruction, Jet, NoValue, Number, Op, Orders, Rational, Scalar, real, scalar};
use pulp::Arch;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `N` points. On the boundaries of registers of four: loads that cross a cache line take twice the time. Wider ones would leave
/// half of the memory of a series of four lanes empty.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(32))]
pub struct Lanes<const N: usize>(pub [f64; N]);

/// `N` points with their derivatives along one direction each: in batches, what [`num_dual::Dual64`] is for one point.
///
/// A lane whose derivative does not exist has no value either.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DualLanes<const N: usize> {
    /// Values.
    pub value: Lanes<N>,
    /// Derivatives.
    pub tangent: Lanes<N>,
}

/// The number itself, or NaN if it is not finite.
#[inline(always)]
fn finite(x: f64) -> f64 {
    if x.abs() <= f64::MAX { x } else { f64::NAN }
}

/// x where the arguments are in the domain, else NaN.
#[inline(always)]
fn only(inside: bool, x: f64) -> f64 {
    if inside { x } else { f64::NAN }
}

/// aⁿ; a point without a value has no zeroth power either.
#[inline(always)]
fn powi(a: f64, n: i32) -> f64 {
    only(!a.is_nan(), real::powi(a, n))
}

/// a^b on the domain of the table.
#[inline(always)]
fn pow(a: f64, b: f64) -> f64 {
    if (a > 0.0 || (a == 0.0 && b > 0.0)) && !b.is_nan() { pxfm::f_pow(a, b) } else { f64::NAN }
}

/// The angle of a point other than the origin.
#[inline(always)]
fn arctan2(y: f64, x: f64) -> f64 {
    // −0 is 0: never the other side of the cut.
    only(y != 0.0 || x != 0.0, pxfm::f_atan2(y + 0.0, x + 0.0))
}

/// The mean of numbers that are not negative.
#[inline(always)]
fn agm(a: f64, b: f64) -> f64 {
    if a >= 0.0 && b >= 0.0 { real::agm(a, b) } else { f64::NAN }
}

impl<const N: usize> Lanes<N> {
    /// The same number in all lanes.
    pub const fn splat(x: f64) -> Lanes<N> {
        Lanes([x; N])
    }

    /// f of each lane.
    #[inline(always)]
    fn map(&mut self, a: &Self, f: impl Fn(f64) -> f64) -> Result<(), NoValue> {
        for i in 0..N {
            self.0[i] = finite(f(a.0[i]));
        }
        Ok(())
    }

    /// f of each pair of lanes.
    #[inline(always)]
    fn zip(&mut self, a: &Self, b: &Self, f: impl Fn(f64, f64) -> f64) -> Result<(), NoValue> {
        for i in 0..N {
            self.0[i] = finite(f(a.0[i], b.0[i]));
        }
        Ok(())
    }
}

impl<const N: usize> Number for Lanes<N> {
    type Context = ();

    fn blank(_: &()) -> Self {
        Self::ZERO
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        let mut x = 0.0;
        x.rational(&(), r)?;
        *self = Lanes::splat(x);
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        *self = Lanes::splat(std::f64::consts::PI);
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |a, b| only(!b.is_nan(), a))
    }
    fn powi(&mut self, _: &(), a: &Self, n: i32) -> Result<(), NoValue> {
        match n {
            2 => self.map(a, |x| x * x),
            _ => self.map(a, |x| powi(x, n)),
        }
    }
    fn neg(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, |x| -x)
    }
    fn sqrt(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, f64::sqrt)
    }
    fn exp(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, pxfm::f_exp)
    }
    fn ln(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, pxfm::f_log)
    }
    fn sin(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, pxfm::f_sin)
    }
    fn cos(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, pxfm::f_cos)
    }
    fn tan(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, pxfm::f_tan)
    }
    fn arcsin(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, |x| only(x.abs() <= 1.0, pxfm::f_asin(x)))
    }
    fn arccos(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, |x| only(x.abs() <= 1.0, pxfm::f_acos(x)))
    }
    fn arctan(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, pxfm::f_atan)
    }
    fn sinh(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, pxfm::f_sinh)
    }
    fn cosh(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, pxfm::f_cosh)
    }
    fn tanh(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, pxfm::f_tanh)
    }
    fn abs(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(a, f64::abs)
    }
    fn add(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |x, y| x + y)
    }
    fn sub(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |x, y| x - y)
    }
    fn mul(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |x, y| x * y)
    }
    fn div(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |x, y| x / y)
    }
    fn pow(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, pow)
    }
    fn arctan2(&mut self, _: &(), y: &Self, x: &Self) -> Result<(), NoValue> {
        self.zip(y, x, arctan2)
    }
    fn agm(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, agm)
    }
}

/// Unchecked operators, as the recurrences of series need them.
macro_rules! operator {
    ($trait:ident $method:ident $assign:tt) => {
        impl<const N: usize> $trait for Lanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, b: Self) -> Self {
                for i in 0..N {
                    self.0[i] $assign b.0[i];
                }
                self
            }
        }
    };
}
operator!(Add add +=);
operator!(Sub sub -=);
operator!(Mul mul *=);
operator!(Div div /=);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for x in &mut self.0 {
            *x = -*x;
        }
        self
    }
}

impl<const N: usize> Scalar for Lanes<N> {
    const ZERO: Self = Lanes::splat(0.0);
    const INVALID: Self = Lanes::splat(f64::NAN);

    #[inline(always)]
    fn integer(n: i32) -> Self {
        Lanes::splat(f64::from(n))
    }
    #[inline(always)]
    fn checked(mut self) -> Result<Self, NoValue> {
        for x in &mut self.0 {
            *x = finite(*x);
        }
        Ok(self)
    }
    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.0.iter().all(|x| *x == 0.0)
    }
    #[inline(always)]
    fn sign(mut self) -> Self {
        for x in &mut self.0 {
            *x = x.sign();
        }
        self
    }
    #[inline(always)]
    fn scale(mut self, other: Self) -> Self {
        for i in 0..N {
            self.0[i] = scalar::scale(self.0[i], other.0[i]);
        }
        self
    }
    #[inline(always)]
    fn times(mut self, tangent: Self) -> Self {
        for i in 0..N {
            self.0[i] = self.0[i].times(tangent.0[i]);
        }
        self
    }
    #[inline(always)]
    fn poisoned_by(mut self, other: Self) -> Self {
        for i in 0..N {
            self.0[i] = only(!other.0[i].is_nan(), self.0[i]);
        }
        self
    }

    fn convolution(a: &[Self], b: &[Self]) -> Self {
        Arch::new().dispatch(Convolution(a, b)).unwrap_or_else(|| scalar::by_four(a, b))
    }

    fn run_series(orders: &Orders, values: &mut [Jet<Self>], missing: &mut [Option<NoValue>], steps: &[Instruction]) {
        Arch::new().dispatch(SeriesSteps { orders, values, missing, steps });
    }
}

impl<const N: usize> DualLanes<N> {
    /// The same number in all lanes, with derivative 0.
    pub const fn constant(x: f64) -> DualLanes<N> {
        DualLanes { value: Lanes::splat(x), tangent: Lanes::splat(0.0) }
    }

    /// Writes one lane: value and derivative, or neither.
    #[inline(always)]
    fn put(&mut self, i: usize, value: f64, tangent: f64) {
        let (v, t) = (finite(value), finite(tangent));
        self.value.0[i] = only(!t.is_nan(), v);
        self.tangent.0[i] = only(!v.is_nan(), t);
    }

    /// f of each lane by the chain rule.
    #[inline(always)]
    fn map(&mut self, op: Op, a: &Self, f: impl Fn(f64) -> f64) -> Result<(), NoValue> {
        for i in 0..N {
            let v = f(a.value.0[i]);
            self.put(i, v, slope(op, a.value.0[i], v).times(a.tangent.0[i]));
        }
        Ok(())
    }

    /// A pair (value, tangent) from the pairs of both arguments, in each lane.
    #[inline(always)]
    fn zip(&mut self, a: &Self, b: &Self, f: impl Fn([f64; 2], [f64; 2]) -> [f64; 2]) -> Result<(), NoValue> {
        for i in 0..N {
            let [v, t] = f([a.value.0[i], a.tangent.0[i]], [b.value.0[i], b.tangent.0[i]]);
            self.put(i, v, t);
        }
        Ok(())
    }

    /// An operation without a vector form, point by point through the dual number of one point.
    fn pointwise(&mut self, op: Op, a: &Self, b: &Self) -> Result<(), NoValue> {
        use num_dual::Dual64;
        self.zip(a, b, |a, b| {
            let mut out = Dual64::new(0.0, 0.0);
            match op.apply(&(), &mut out, &Dual64::new(a[0], a[1]), &Dual64::new(b[0], b[1])) {
                Ok(()) => [out.re, out.eps],
                Err(_) => [f64::NAN; 2],
            }
        })
    }
}

impl<const N: usize> Number for DualLanes<N> {
    type Context = ();

    fn blank(_: &()) -> Self {
        DualLanes::constant(0.0)
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        self.tangent = Lanes::ZERO;
        self.value.rational(&(), r)
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        *self = DualLanes::constant(std::f64::consts::PI);
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |[a, da], [b, _]| [only(!b.is_nan(), a), da])
    }
    fn powi(&mut self, _: &(), a: &Self, n: i32) -> Result<(), NoValue> {
        match n {
            2 => self.map(Op::Powi(2), a, |x| x * x),
            _ => self.map(Op::Powi(n), a, |x| powi(x, n)),
        }
    }
    fn neg(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Neg, a, |x| -x)
    }
    fn sqrt(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Sqrt, a, f64::sqrt)
    }
    fn exp(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Exp, a, pxfm::f_exp)
    }
    fn ln(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Ln, a, pxfm::f_log)
    }
    fn sin(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Sin, a, pxfm::f_sin)
    }
    fn cos(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Cos, a, pxfm::f_cos)
    }
    fn tan(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Tan, a, pxfm::f_tan)
    }
    fn arcsin(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Arcsin, a, |x| only(x.abs() <= 1.0, pxfm::f_asin(x)))
    }
    fn arccos(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Arccos, a, |x| only(x.abs() <= 1.0, pxfm::f_acos(x)))
    }
    fn arctan(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Arctan, a, pxfm::f_atan)
    }
    fn sinh(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Sinh, a, pxfm::f_sinh)
    }
    fn cosh(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Cosh, a, pxfm::f_cosh)
    }
    fn tanh(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Tanh, a, pxfm::f_tanh)
    }
    fn abs(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.map(Op::Abs, a, f64::abs)
    }
    fn add(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |[x, s], [y, t]| [x + y, s + t])
    }
    fn sub(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |[x, s], [y, t]| [x - y, s - t])
    }
    fn mul(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |[x, s], [y, t]| [x * y, s * y + t * x])
    }
    fn div(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.zip(a, b, |[x, s], [y, t]| {
            let v = x / y;
            [v, (s - v * t) / y]
        })
    }
    fn pow(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.pointwise(Op::Pow, a, b)
    }
    fn arctan2(&mut self, _: &(), y: &Self, x: &Self) -> Result<(), NoValue> {
        self.zip(y, x, |[y, dy], [x, dx]| {
            let s = scalar::scale(y, x);
            let (sy, sx) = (y * s, x * s);
            [arctan2(y, x), (sx * dy - sy * dx) / (sy * sy + sx * sx) * s]
        })
    }
    fn agm(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.pointwise(Op::Agm, a, b)
    }
}
