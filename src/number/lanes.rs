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

use super::wide::Convolution;
use super::wide_lanes::{One, Steps};
use super::wide_series::SeriesSteps;
use super::{Instruction, Jet, NoValue, Number, Op, Orders, Rational, Scalar, scalar};
use pulp::{Arch, Simd, WithSimd};
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

/// Work that is done with the widest registers of this processor, see [`widely`].
pub trait Work {
    /// What it yields.
    type Output;
    /// Does it. To be `#[inline(always)]`, as everything that it calls: what is called instead has no wide registers.
    fn work(self) -> Self::Output;
}

/// Does work with the widest registers of this processor. Its operations are those of IEEE 754 in the order in which they are written,
/// none of them fused, whatever the registers.
///
/// Work is a trait and no function, since the call of a function that is handed over need not become part of the caller.
#[inline]
pub fn widely<W: Work>(work: W) -> W::Output {
    Arch::new().dispatch(Widely(work))
}

/// A call.
struct Widely<W>(W);

impl<W: Work> WithSimd for Widely<W> {
    type Output = W::Output;
    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> W::Output {
        self.0.work()
    }
}

impl<const N: usize> Lanes<N> {
    /// The same number in all lanes.
    pub const fn splat(x: f64) -> Lanes<N> {
        Lanes([x; N])
    }
}

/// The operations in the widest registers.
macro_rules! together {
    () => {
        fn rule(&mut self, _: &(), op: Op, a: &Self, b: &Self) -> Result<(), NoValue> {
            Arch::new().dispatch(One { op, out: self, a, b });
            Ok(())
        }
        fn run(_: &(), values: &mut [Self], missing: &mut [Option<NoValue>], steps: &[Instruction]) {
            Arch::new().dispatch(Steps { values, missing, steps });
        }
    };
}

impl<const N: usize> super::Uniform for Lanes<N> {
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
    together!();
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
}

impl<const N: usize> super::Uniform for DualLanes<N> {
    type Context = ();

    fn blank(_: &()) -> Self {
        DualLanes::constant(0.0)
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        self.tangent = Lanes::ZERO;
        Number::rational(&mut self.value, &(), r)
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        *self = DualLanes::constant(std::f64::consts::PI);
        Ok(())
    }
    together!();
}
