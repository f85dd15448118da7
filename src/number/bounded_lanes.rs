//! Many points at once, each with a bound of its error.
//!
//! **In:** one block of values with bounds per quantity. **Out:** one block per result, in the same order.
//!
//! **Guaranteed:** each lane is, bit for bit, what [`Bounded`] computes for that point alone. A block has a value only if all
//! of its lanes have one: where a lane has none, the whole block says so, and the points are to be evaluated one by one.
//!
//! **Why:** the price of reading an instruction of the tape is paid once per block, and the loops of + − × become vector
//! instructions. Nearly all blocks of a motion have values throughout.

use super::bounded::convolved;
use super::wide::{Convolution, Once, Steps};
use super::{Bounded, Instruction, NoValue, Number, Op, Rational, Scalar, scalar};
use pulp::Arch;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `N` points with their error bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct BoundedLanes<const N: usize> {
    pub(super) value: [f64; N],
    pub(super) error: [f64; N],
}

impl<const N: usize> BoundedLanes<N> {
    /// The same number in all lanes.
    pub const fn splat(x: Bounded) -> BoundedLanes<N> {
        BoundedLanes { value: [x.value; N], error: [x.error; N] }
    }

    /// A number for each lane.
    #[inline(always)]
    pub fn of(each: [Bounded; N]) -> BoundedLanes<N> {
        BoundedLanes { value: each.map(|x| x.value), error: each.map(|x| x.error) }
    }

    /// The values of all lanes.
    #[inline(always)]
    pub fn values(&self) -> &[f64; N] {
        &self.value
    }

    /// The number in a lane; lanes are counted from 0 to N − 1.
    #[inline(always)]
    pub fn lane(&self, i: usize) -> Bounded {
        Bounded { value: self.value[i], error: self.error[i] }
    }

    /// Whether every lane holds this number, bit for bit.
    #[inline]
    pub fn is(&self, x: Bounded) -> bool {
        let bits = |lanes: &[f64; N], x: f64| lanes.iter().fold(0, |all, lane| all | lane.to_bits() ^ x.to_bits());
        bits(&self.value, x.value) | bits(&self.error, x.error) == 0
    }

    /// Puts a number into a lane.
    #[inline(always)]
    pub fn set_lane(&mut self, i: usize, x: Bounded) {
        self.value[i] = x.value;
        self.error[i] = x.error;
    }

    /// An operation that always has a result, which may be too large.
    #[inline(always)]
    fn total(&mut self, f: impl Fn(usize) -> Bounded) -> Result<(), NoValue> {
        let mut finite = true;
        for i in 0..N {
            let x = f(i);
            self.set_lane(i, x);
            finite &= x.value.is_finite() & x.error.is_finite();
        }
        if finite { Ok(()) } else { Err(NoValue::Indeterminate) }
    }
}

/// An operator, lane by lane.
macro_rules! by_lanes {
    ($($operator:ident $method:ident),*) => {$(
        impl<const N: usize> $operator for BoundedLanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, b: Self) -> Self {
                for i in 0..N {
                    self.set_lane(i, self.lane(i).$method(b.lane(i)));
                }
                self
            }
        }
    )*};
}

by_lanes!(Add add, Sub sub, Mul mul, Div div);

impl<const N: usize> Neg for BoundedLanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for x in &mut self.value {
            *x = -*x;
        }
        self
    }
}

/// A series over lanes has a coefficient only if all lanes have one. Where some lanes of a coefficient are exactly 0 and
/// others are not, the zeros are kept as coefficients: values stay the same, bit for bit; error bounds may grow by a few units
/// in their last place.
impl<const N: usize> Scalar for BoundedLanes<N> {
    const ZERO: Self = Self::splat(Bounded::ZERO);
    const INVALID: Self = Self::splat(Bounded::INVALID);

    #[inline(always)]
    fn integer(n: i32) -> Self {
        Self::splat(Bounded::integer(n))
    }
    #[inline(always)]
    fn checked(self) -> Result<Self, NoValue> {
        let finite = (0..N).fold(true, |all, i| all & self.value[i].is_finite() & self.error[i].is_finite());
        if finite { Ok(self) } else { Err(NoValue::Indeterminate) }
    }
    #[inline(always)]
    fn is_zero(&self) -> bool {
        (0..N).all(|i| self.lane(i).is_zero())
    }
    #[inline(always)]
    fn sign(mut self) -> Self {
        for i in 0..N {
            self.set_lane(i, self.lane(i).sign());
        }
        self
    }
    #[inline(always)]
    fn scale(mut self, other: Self) -> Self {
        for i in 0..N {
            self.set_lane(i, Bounded::exact(scalar::scale(self.value[i], other.value[i])));
        }
        self
    }
    #[inline(always)]
    fn times(mut self, tangent: Self) -> Self {
        for i in 0..N {
            self.set_lane(i, self.lane(i).times(tangent.lane(i)));
        }
        self
    }
    #[inline]
    fn flatness(mut self, tanh: Self) -> Self {
        for i in 0..N {
            self.set_lane(i, self.lane(i).flatness(tanh.lane(i)));
        }
        self
    }
    #[inline(always)]
    fn poisoned_by(self, _: Self) -> Self {
        self
    }

    fn convolution(a: &[Self], b: &[Self]) -> Self {
        if let Some(sum) = Arch::new().dispatch(Convolution(a, b)) {
            return sum;
        }
        let mut out = Self::ZERO;
        for i in 0..N {
            out.set_lane(i, convolved(a, b, |x| x.lane(i)));
        }
        out
    }
}

impl<const N: usize> super::Uniform for BoundedLanes<N> {
    type Context = ();

    fn blank(_: &()) -> Self {
        Self::splat(Bounded::ZERO)
    }
    /// Lane by lane.
    #[inline(always)]
    fn rule(&mut self, _: &(), op: Op, a: &Self, b: &Self) -> Result<(), NoValue> {
        let mut x = Bounded::ZERO;
        for i in 0..N {
            op.apply(&(), &mut x, &a.lane(i), &b.lane(i))?;
            self.set_lane(i, x);
        }
        Ok(())
    }
    fn rational(&mut self, _: &(), r: &Rational) -> Result<(), NoValue> {
        let mut x = Bounded::ZERO;
        x.rational(&(), r)?;
        *self = Self::splat(x);
        Ok(())
    }
    fn pi(&mut self, _: &()) -> Result<(), NoValue> {
        let mut x = Bounded::ZERO;
        x.pi(&())?;
        *self = Self::splat(x);
        Ok(())
    }
    fn restrict(&mut self, _: &(), a: &Self, _: &Self) -> Result<(), NoValue> {
        self.total(|i| a.lane(i))
    }
    fn powi(&mut self, _: &(), a: &Self, n: i32) -> Result<(), NoValue> {
        match n {
            2 => self.total(|i| a.lane(i) * a.lane(i)),
            _ => super::Uniform::rule(self, &(), Op::Powi(n), a, a),
        }
    }
    fn neg(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        self.total(|i| -a.lane(i))
    }
    fn sin(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        if Arch::new().dispatch(Once { op: Op::Sin, out: self, a, b: a }) {
            return Ok(());
        }
        super::Uniform::rule(self, &(), Op::Sin, a, a)
    }
    fn cos(&mut self, _: &(), a: &Self) -> Result<(), NoValue> {
        if Arch::new().dispatch(Once { op: Op::Cos, out: self, a, b: a }) {
            return Ok(());
        }
        super::Uniform::rule(self, &(), Op::Cos, a, a)
    }
    fn add(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.total(|i| a.lane(i) + b.lane(i))
    }
    fn sub(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        self.total(|i| a.lane(i) - b.lane(i))
    }
    fn mul(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        if Arch::new().dispatch(Once { op: Op::Mul, out: self, a, b }) {
            return Ok(());
        }
        self.total(|i| a.lane(i) * b.lane(i))
    }
    fn div(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        if (0..N).any(|i| b.lane(i).contains_zero()) {
            return Err(NoValue::Indeterminate);
        }
        self.total(|i| a.lane(i) / b.lane(i))
    }
    fn arctan2(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        if Arch::new().dispatch(Once { op: Op::Arctan2, out: self, a, b }) {
            return Ok(());
        }
        super::Uniform::rule(self, &(), Op::Arctan2, a, b)
    }
    fn direction_cosine(&mut self, _: &(), a: &Self, b: &Self) -> Result<(), NoValue> {
        if Arch::new().dispatch(Once { op: Op::DirectionCosine, out: self, a, b }) {
            return Ok(());
        }
        super::Uniform::rule(self, &(), Op::DirectionCosine, a, b)
    }
    fn run(_: &(), values: &mut [Self], missing: &mut [Option<NoValue>], steps: &[Instruction]) {
        Arch::new().dispatch(Steps { values, missing, steps });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Draws;

    #[test]
    fn zeros_with_another_sign_are_other_numbers() {
        let mut lanes = BoundedLanes::<4>::splat(Bounded::new(0.0, 1e-3));
        assert!(
            lanes.is(Bounded::new(0.0, 1e-3)) && !lanes.is(Bounded::new(-0.0, 1e-3)) && !lanes.is(Bounded::exact(0.0))
        );
        lanes.set_lane(3, Bounded::new(-0.0, 1e-3));
        assert!(!lanes.is(Bounded::new(0.0, 1e-3)));
    }

    #[test]
    fn each_lane_is_what_one_point_is() {
        let mut draws = Draws::new(7);
        let mut number = || {
            let x = draws.below(4001) as f64 / 1000.0 - 2.0;
            Bounded::new(x, if x > 1.0 { 0.0 } else { x.abs() * 1e-12 })
        };
        let mut compared = 0;
        for _ in 0..200 {
            let (mut a, mut b) = (BoundedLanes::<4>::blank(&()), BoundedLanes::<4>::blank(&()));
            for i in 0..4 {
                a.set_lane(i, number());
                b.set_lane(i, number());
            }
            for &op in Op::EVERY {
                let mut block = BoundedLanes::<4>::blank(&());
                let found = op.apply(&(), &mut block, &a, &b);
                let each: Vec<Result<Bounded, NoValue>> = (0..4)
                    .map(|i| {
                        let mut x = Bounded::ZERO;
                        op.apply(&(), &mut x, &a.lane(i), &b.lane(i)).map(|()| x)
                    })
                    .collect();
                assert_eq!(found.is_ok(), each.iter().all(Result::is_ok), "{op:?} of {a:?} and {b:?}");
                if found.is_ok() {
                    compared += 1;
                    for (i, x) in each.into_iter().enumerate() {
                        assert_eq!(Ok(block.lane(i)), x, "{op:?}");
                    }
                }
            }
        }
        assert!(compared > 2000, "{compared}");
    }
}
