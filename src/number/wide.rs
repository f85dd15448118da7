//! The operations of [`BoundedLanes`] in the widest registers of the processor.
//!
//! **In:** the steps of a program over lanes. **Out:** their results. **Guaranteed:** every lane is what [`Bounded`] computes,
//! bit for bit, on every processor: the same operations of IEEE 754 in the same order, however many of them are made at once,
//! and no fused ones.
//!
//! **Why so:** a result is written first and doubted afterwards. A finite error bound says that the value is finite too and
//! that every lane was in the domain; where that cannot be said of the whole block, the operation is made again lane by lane,
//! and what comes out then counts. So the common case is free of branches, and there is one place that says why something
//! has no value.

use super::bounded::{DOWN, TINY, U, UP};
use super::operation::run_each;
use super::{BoundedLanes, Instruction, NoValue, Op};
use pulp::{Arch, Simd, WithSimd};

/// Steps over lanes, to be run with some instruction set.
pub(super) struct Steps<'s, const N: usize> {
    pub(super) values: &'s mut [BoundedLanes<N>],
    pub(super) missing: &'s mut [Option<NoValue>],
    pub(super) steps: &'s [Instruction],
}

impl<const N: usize> Steps<'_, N> {
    /// Runs them with the widest registers that there are.
    pub(super) fn run(self) {
        Arch::new().dispatch(self);
    }
}

impl<const N: usize> WithSimd for Steps<'_, N> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        run_each(self.values, self.missing, self.steps, |op, out, a, b| {
            if together(simd, op, out, a, b) { Ok(()) } else { by_lanes(op, out, a, b) }
        });
    }
}

/// Lane by lane.
#[inline(never)]
fn by_lanes<const N: usize>(
    op: Op,
    out: &mut BoundedLanes<N>,
    a: &BoundedLanes<N>,
    b: &BoundedLanes<N>,
) -> Result<(), NoValue> {
    op.apply(&(), out, a, b)
}

/// Values and error bounds of some lanes.
struct Ball<S: Simd>(S::f64s, S::f64s);

impl<S: Simd> Clone for Ball<S> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Simd> Copy for Ball<S> {}

/// An operation in all lanes; `false` where it must be made lane by lane.
#[inline(always)]
fn together<S: Simd, const N: usize>(
    simd: S,
    op: Op,
    out: &mut BoundedLanes<N>,
    a: &BoundedLanes<N>,
    b: &BoundedLanes<N>,
) -> bool {
    match op {
        Op::Add => zip(simd, out, a, b, |_, a, b| add(simd, a, b)),
        Op::Sub => zip(simd, out, a, b, |_, a, b| add(simd, a, neg(simd, b))),
        Op::Mul => zip(simd, out, a, b, |_, a, b| mul(simd, a, b)),
        Op::Div => zip(simd, out, a, b, |sure, a, b| div(simd, sure, a, b)),
        Op::Neg => zip(simd, out, a, a, |sure, a, _| {
            sure.finite(simd, a.0);
            neg(simd, a)
        }),
        Op::Abs => zip(simd, out, a, a, |sure, a, _| {
            sure.finite(simd, a.0);
            Ball(simd.abs_f64s(a.0), a.1)
        }),
        Op::Sqrt => zip(simd, out, a, a, |sure, a, _| sqrt(simd, sure, a)),
        Op::Powi(2) => zip(simd, out, a, a, |_, a, _| mul(simd, a, a)),
        Op::Powi(n) if n > 2 => zip(simd, out, a, a, |_, a, _| power(simd, a, n.unsigned_abs())),
        _ => false,
    }
}

/// What must be so in every lane for the results to stand; see the module.
struct Sure<S: Simd>(S::m64s);

impl<S: Simd> Sure<S> {
    /// It must be so.
    #[inline(always)]
    fn and(&mut self, simd: S, so: S::m64s) {
        self.0 = simd.and_m64s(self.0, so);
    }

    /// x must be finite.
    #[inline(always)]
    fn finite(&mut self, simd: S, x: S::f64s) {
        self.and(simd, simd.less_than_or_equal_f64s(simd.abs_f64s(x), simd.splat_f64s(f64::MAX)));
    }
}

/// f of each pair of lanes. `false` where a condition of f is not met or an error bound is not finite.
#[inline(always)]
fn zip<S: Simd, const N: usize>(
    simd: S,
    out: &mut BoundedLanes<N>,
    a: &BoundedLanes<N>,
    b: &BoundedLanes<N>,
    f: impl Fn(&mut Sure<S>, Ball<S>, Ball<S>) -> Ball<S>,
) -> bool {
    if !N.is_multiple_of(S::F64_LANES) {
        return false;
    }
    let (av, ae) = (S::as_simd_f64s(&a.value).0, S::as_simd_f64s(&a.error).0);
    let (bv, be) = (S::as_simd_f64s(&b.value).0, S::as_simd_f64s(&b.error).0);
    let (ov, oe) = (S::as_mut_simd_f64s(&mut out.value).0, S::as_mut_simd_f64s(&mut out.error).0);
    let largest = simd.splat_f64s(f64::MAX);
    // 0 ≤ MAX holds in all lanes.
    let mut sure = Sure::<S>(simd.less_than_or_equal_f64s(simd.splat_f64s(0.0), largest));
    for i in 0..N / S::F64_LANES {
        let Ball(value, error) = f(&mut sure, Ball(av[i], ae[i]), Ball(bv[i], be[i]));
        (ov[i], oe[i]) = (value, error);
        sure.and(simd, simd.less_than_or_equal_f64s(error, largest));
    }
    simd.first_true_m64s(simd.not_m64s(sure.0)) >= S::F64_LANES
}

/// |x|·u.
#[inline(always)]
fn rounding<S: Simd>(simd: S, x: S::f64s) -> S::f64s {
    simd.mul_f64s(simd.splat_f64s(U), simd.abs_f64s(x))
}

#[inline(always)]
fn neg<S: Simd>(simd: S, a: Ball<S>) -> Ball<S> {
    Ball(simd.neg_f64s(a.0), a.1)
}

#[inline(always)]
fn add<S: Simd>(simd: S, a: Ball<S>, b: Ball<S>) -> Ball<S> {
    let value = simd.add_f64s(a.0, b.0);
    let spread = simd.add_f64s(simd.add_f64s(a.1, b.1), rounding(simd, value));
    Ball(value, simd.mul_f64s(spread, simd.splat_f64s(UP)))
}

/// Whether 0 is exact: |value| + error is 0 only then, since no sum underflows.
#[inline(always)]
fn is_exact_zero<S: Simd>(simd: S, size: S::f64s) -> S::m64s {
    simd.equal_f64s(size, simd.splat_f64s(0.0))
}

#[inline(always)]
fn mul<S: Simd>(simd: S, a: Ball<S>, b: Ball<S>) -> Ball<S> {
    let value = simd.mul_f64s(a.0, b.0);
    let size = simd.abs_f64s(a.0);
    let outer = simd.add_f64s(simd.abs_f64s(b.0), b.1);
    let spread = simd.add_f64s(simd.mul_f64s(size, b.1), simd.mul_f64s(outer, a.1));
    let exact = simd.or_m64s(is_exact_zero(simd, simd.add_f64s(size, a.1)), is_exact_zero(simd, outer));
    let tiny = simd.select_f64s(exact, simd.splat_f64s(0.0), simd.splat_f64s(TINY));
    let spread = simd.add_f64s(spread, rounding(simd, value));
    Ball(value, simd.add_f64s(simd.mul_f64s(spread, simd.splat_f64s(UP)), tiny))
}

/// The divisor must not contain 0.
#[inline(always)]
fn div<S: Simd>(simd: S, sure: &mut Sure<S>, a: Ball<S>, b: Ball<S>) -> Ball<S> {
    let (up, tiny) = (simd.splat_f64s(UP), simd.splat_f64s(TINY));
    let size = simd.abs_f64s(b.0);
    sure.and(simd, simd.less_than_f64s(b.1, size));
    let value = simd.div_f64s(a.0, b.0);
    let least = simd.mul_f64s(simd.sub_f64s(size, b.1), simd.splat_f64s(DOWN));
    let shift = simd.mul_f64s(simd.add_f64s(simd.mul_f64s(simd.abs_f64s(value), up), tiny), b.1);
    let spread = simd.div_f64s(simd.add_f64s(a.1, shift), least);
    let exact = is_exact_zero(simd, simd.add_f64s(simd.abs_f64s(a.0), a.1));
    let tiny = simd.select_f64s(exact, simd.splat_f64s(0.0), tiny);
    let spread = simd.add_f64s(spread, rounding(simd, value));
    Ball(value, simd.add_f64s(simd.mul_f64s(spread, up), tiny))
}

/// The argument must be positive, with an error that does not reach 0.
#[inline(always)]
fn sqrt<S: Simd>(simd: S, sure: &mut Sure<S>, a: Ball<S>) -> Ball<S> {
    let (zero, down) = (simd.splat_f64s(0.0), simd.splat_f64s(DOWN));
    let low = simd.mul_f64s(simd.sub_f64s(a.0, a.1), down);
    sure.and(simd, simd.less_than_f64s(zero, a.0));
    sure.and(simd, simd.less_than_or_equal_f64s(zero, low));
    sure.finite(simd, a.0);
    let value = simd.sqrt_f64s(a.0);
    let slope = simd.mul_f64s(simd.add_f64s(value, simd.sqrt_f64s(low)), down);
    let deviation = simd.select_f64s(simd.equal_f64s(a.1, zero), zero, simd.div_f64s(a.1, slope));
    let rounding = simd.mul_f64s(simd.splat_f64s(U), value);
    Ball(value, simd.mul_f64s(simd.add_f64s(deviation, rounding), simd.splat_f64s(UP)))
}

/// Repeated squaring, n ≥ 2.
#[inline(always)]
fn power<S: Simd>(simd: S, a: Ball<S>, mut n: u32) -> Ball<S> {
    let (mut base, mut acc) = (a, None);
    loop {
        if n & 1 == 1 {
            acc = Some(match acc {
                None => base,
                Some(acc) => mul(simd, acc, base),
            });
        }
        n >>= 1;
        match acc {
            Some(power) if n == 0 => return power,
            _ => base = mul(simd, base, base),
        }
    }
}
