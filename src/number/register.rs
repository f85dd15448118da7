//! As many numbers as a register of the processor holds, with operators.
//!
//! **In:** numbers side by side. **Out:** the operations of IEEE 754 on each. **Guaranteed:** each number is what the operation of
//! one number gives, on every processor; none is fused. With [`pulp::Scalar`] a register is one `f64`.
//!
//! **Why:** a loop over arrays is left in pieces by the compiler as soon as a selection or the bits of a number come in. Operators
//! keep formulas readable; everything here must become part of the function that has the instruction set, hence no closures.

use pulp::{Simd, bytemuck::cast};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The bits of −0.
const SIGN: u64 = 1 << 63;

/// The numbers of one register.
#[derive(Clone, Copy, Debug)]
pub(super) struct Register<S: Simd> {
    pub(super) simd: S,
    pub(super) x: S::f64s,
}

/// An operator, with a register or with one number for all its places.
macro_rules! operator {
    ($($trait:ident $method:ident $simd:ident;)*) => {$(
        impl<S: Simd> $trait for Register<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, b: Self) -> Self {
                Register { simd: self.simd, x: self.simd.$simd(self.x, b.x) }
            }
        }
        impl<S: Simd> $trait<f64> for Register<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, b: f64) -> Self {
                self.$method(self.all(b))
            }
        }
        impl<S: Simd> $trait<Register<S>> for f64 {
            type Output = Register<S>;
            #[inline(always)]
            fn $method(self, b: Register<S>) -> Register<S> {
                b.all(self).$method(b)
            }
        }
    )*};
}

operator! {
    Add add add_f64s;
    Sub sub sub_f64s;
    Mul mul mul_f64s;
    Div div div_f64s;
}

impl<S: Simd> Neg for Register<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.flipped(self.bits_of(SIGN))
    }
}

impl<S: Simd> Register<S> {
    /// The same number in all places.
    #[inline(always)]
    pub(super) fn all(self, x: f64) -> Self {
        Register { simd: self.simd, x: self.simd.splat_f64s(x) }
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        Register { simd: self.simd, x: self.simd.abs_f64s(self.x) }
    }

    #[inline(always)]
    pub(super) fn sqrt(self) -> Self {
        Register { simd: self.simd, x: self.simd.sqrt_f64s(self.x) }
    }

    /// Where `self` < b; nowhere where one of them is NaN.
    #[inline(always)]
    pub(super) fn below(self, b: impl Into<Place<S>>) -> S::m64s {
        self.simd.less_than_f64s(self.x, b.into().of(self).x)
    }

    /// Where `self` ≤ b; nowhere where one of them is NaN.
    #[inline(always)]
    pub(super) fn upto(self, b: impl Into<Place<S>>) -> S::m64s {
        self.simd.less_than_or_equal_f64s(self.x, b.into().of(self).x)
    }

    /// Where `self` = b.
    #[inline(always)]
    pub(super) fn is(self, b: impl Into<Place<S>>) -> S::m64s {
        self.simd.equal_f64s(self.x, b.into().of(self).x)
    }

    /// `self` where so, else b.
    #[inline(always)]
    pub(super) fn or(self, so: S::m64s, b: impl Into<Place<S>>) -> Self {
        Register { simd: self.simd, x: self.simd.select_f64s(so, self.x, b.into().of(self).x) }
    }

    /// `self` where it is finite, else NaN.
    #[inline(always)]
    pub(super) fn finite(self) -> Self {
        self.or(self.abs().upto(f64::MAX), f64::NAN)
    }

    /// The bits of each number.
    #[inline(always)]
    pub(super) fn bits(self) -> S::u64s {
        self.simd.transmute_u64s_f64s(self.x)
    }

    /// The same bits in all places.
    #[inline(always)]
    pub(super) fn bits_of(self, bits: u64) -> S::u64s {
        self.simd.splat_u64s(bits)
    }

    /// Numbers with these bits.
    #[inline(always)]
    pub(super) fn with_bits(self, bits: S::u64s) -> Self {
        Register { simd: self.simd, x: self.simd.transmute_f64s_u64s(bits) }
    }

    /// The sign of each number, as the bits of 0 or −0.
    #[inline(always)]
    pub(super) fn sign(self) -> S::u64s {
        self.simd.and_u64s(self.bits(), self.bits_of(SIGN))
    }

    /// The other sign where the highest bit is set; no other bit is.
    #[inline(always)]
    pub(super) fn flipped(self, sign: S::u64s) -> Self {
        self.with_bits(self.simd.xor_u64s(self.bits(), sign))
    }

    /// The power of two that brings the larger of |self| and |b| into [1, 2), as [`Scalar::scale`](super::Scalar::scale) does.
    #[inline(always)]
    pub(super) fn scale(self, b: Self) -> Self {
        let (p, q) = (self.abs(), b.abs());
        let larger = self.simd.max_u64s(p.bits(), q.bits());
        let biased = self.simd.and_u64s(larger, self.bits_of(0x7FF << 52));
        let least = self.simd.max_u64s(biased, self.bits_of(1 << 52));
        let kept = self.simd.min_u64s(least, self.bits_of(2045 << 52));
        self.with_bits(self.simd.sub_u64s(self.bits_of(2046 << 52), kept))
    }

    /// The nearest whole number, ties to even; |x| ≤ 2⁵⁰.
    #[inline(always)]
    pub(super) fn rounded(self) -> Self {
        const ROUND: f64 = 1.5 * (1_u64 << 52) as f64;
        (self + ROUND) - ROUND
    }

    /// Σ cₖxᵏ: sums of the even and of the odd terms, so that one need not wait for the other.
    #[inline(always)]
    pub(super) fn polynomial<const K: usize>(self, c: &[f64; K]) -> Self {
        let square = self * self;
        let (mut sums, mut k) = ([self.all(c[K - 2]), self.all(c[K - 1])], K - 2);
        while k >= 2 {
            sums = [sums[0] * square + c[k - 2], sums[1] * square + c[k - 1]];
            k -= 2;
        }
        // An odd number of terms leaves one, and the sums change their places.
        if k == 1 { (sums[1] * square + sums[0] * self) + c[0] } else { sums[0] + sums[1] * self }
    }
}

/// What a register is compared with: another, or one number for all places.
pub(super) enum Place<S: Simd> {
    Each(Register<S>),
    All(f64),
}

impl<S: Simd> Place<S> {
    #[inline(always)]
    fn of(self, like: Register<S>) -> Register<S> {
        match self {
            Place::Each(x) => x,
            Place::All(x) => like.all(x),
        }
    }
}

impl<S: Simd> From<Register<S>> for Place<S> {
    #[inline(always)]
    fn from(x: Register<S>) -> Place<S> {
        Place::Each(x)
    }
}

impl<S: Simd> From<f64> for Place<S> {
    #[inline(always)]
    fn from(x: f64) -> Place<S> {
        Place::All(x)
    }
}

/// Bits of which the lower halves are 0, moved up. There are no shifts of 64 bits here, but of 32.
#[inline(always)]
pub(super) fn up<S: Simd>(simd: S, bits: S::u64s, by: u32) -> S::u64s {
    if S::IS_SCALAR {
        return cast(cast::<S::u64s, u64>(bits) << by);
    }
    cast(simd.wrapping_dyn_shl_u32s(cast(bits), simd.splat_u32s(by)))
}

/// Bits of which the lower halves are 0 before and after, moved down.
#[inline(always)]
pub(super) fn down<S: Simd>(simd: S, bits: S::u64s, by: u32) -> S::u64s {
    if S::IS_SCALAR {
        return cast(cast::<S::u64s, u64>(bits) >> by);
    }
    cast(simd.wrapping_dyn_shr_u32s(cast(bits), simd.splat_u32s(by)))
}
