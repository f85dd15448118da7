//! Series in lanes, order by order, in the widest registers of the processor.
//!
//! **In:** the steps of a program over [`Jet`]s of [`Lanes`]. **Out:** one order of their results. **Guaranteed:** every lane is, bit
//! for bit, what a series over `f64` is, on every processor: sums in the order of [`Scalar::convolution`](super::Scalar::convolution).
//!
//! **Why so:** a motion consists of sums of products, and these are what is worth a register; all else is left to the recurrences.

use super::operation::{Apply, run_each};
use super::wide::Convolution;
use super::{Instruction, Jet, Lanes, NoValue, Op, Orders, Scalar};
use pulp::{Simd, WithSimd};

impl<const N: usize> WithSimd for Convolution<'_, Lanes<N>> {
    /// `None` where it must be made lane by lane.
    type Output = Option<Lanes<N>>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let Convolution(a, b) = self;
        if !N.is_multiple_of(S::F64_LANES) || a.len() != b.len() {
            return None;
        }
        let mut out = Lanes([0.0; N]);
        for (lanes, out) in S::as_mut_simd_f64s(&mut out.0).0.iter_mut().enumerate() {
            [*out] = convolution(simd, lanes, a, b);
        }
        Some(out)
    }
}

/// A register of lanes: that with this number.
#[inline(always)]
fn lanes_of<S: Simd, const N: usize>(x: &Lanes<N>, lanes: usize) -> S::f64s {
    S::as_simd_f64s(&x.0).0[lanes]
}

/// The sum of [`Convolution`] in `R` registers of lanes from this one on, over slices of the same length.
#[allow(clippy::needless_range_loop, reason = "a register has the same number in all sums, and in what they add up")]
#[inline(always)]
fn convolution<S: Simd, const N: usize, const R: usize>(
    simd: S,
    from: usize,
    a: &[Lanes<N>],
    b: &[Lanes<N>],
) -> [S::f64s; R] {
    let (head, tail) = a.as_chunks::<4>();
    let (rest, back) = b.as_rchunks::<4>();
    let mut sum = [simd.splat_f64s(0.0); R];
    // Macros for the reason given at `zip`.
    macro_rules! product {
        ($p:expr, $q:expr, $r:ident) => {
            simd.mul_f64s(lanes_of::<S, N>($p, from + $r), lanes_of::<S, N>($q, from + $r))
        };
    }
    if let ([p, head @ ..], [back @ .., q]) = (head, back) {
        let mut s = [[simd.splat_f64s(0.0); R]; 4];
        for r in 0..R {
            s[0][r] = product!(&p[0], &q[3], r);
            s[1][r] = product!(&p[1], &q[2], r);
            s[2][r] = product!(&p[2], &q[1], r);
            s[3][r] = product!(&p[3], &q[0], r);
        }
        for (p, q) in head.iter().zip(back.iter().rev()) {
            for r in 0..R {
                s[0][r] = simd.add_f64s(s[0][r], product!(&p[0], &q[3], r));
                s[1][r] = simd.add_f64s(s[1][r], product!(&p[1], &q[2], r));
                s[2][r] = simd.add_f64s(s[2][r], product!(&p[2], &q[1], r));
                s[3][r] = simd.add_f64s(s[3][r], product!(&p[3], &q[0], r));
            }
        }
        for r in 0..R {
            sum[r] = simd.add_f64s(simd.add_f64s(s[0][r], s[2][r]), simd.add_f64s(s[1][r], s[3][r]));
        }
    }
    for (p, q) in tail.iter().zip(rest.iter().rev()) {
        for r in 0..R {
            sum[r] = simd.add_f64s(sum[r], product!(p, q, r));
        }
    }
    sum
}

/// Steps over series in lanes, to be run with some instruction set.
pub(super) struct SeriesSteps<'s, const N: usize> {
    pub(super) orders: &'s Orders,
    pub(super) values: &'s mut [Jet<Lanes<N>>],
    pub(super) missing: &'s mut [Option<NoValue>],
    pub(super) steps: &'s [Instruction],
}

impl<const N: usize> WithSimd for SeriesSteps<'_, N> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        run_each(self.values, self.missing, self.steps, Grown(simd, self.orders));
    }
}

/// One order of a series, in all lanes together where that can be.
struct Grown<'o, S>(S, &'o Orders);

impl<S: Simd, const N: usize> Apply<Jet<Lanes<N>>> for Grown<'_, S> {
    #[inline(always)]
    fn apply(&self, op: Op, out: &mut Jet<Lanes<N>>, a: &Jet<Lanes<N>>, b: &Jet<Lanes<N>>) -> Result<(), NoValue> {
        let Grown(simd, orders) = *self;
        match orders.single() {
            Some(k) if grow(simd, op, k, out, a, b) => Ok(()),
            _ => by_recurrence(op, orders, out, a, b),
        }
    }
}

/// Some of the lanes of a coefficient.
#[inline(always)]
fn coefficient<S: Simd, const N: usize>(simd: S, x: &Jet<Lanes<N>>, k: usize, lanes: usize) -> S::f64s {
    match k < x.length {
        true => lanes_of::<S, N>(&x.series[k], lanes),
        false => simd.splat_f64s(0.0),
    }
}

/// As every base does it.
#[inline(never)]
fn by_recurrence<const N: usize>(
    op: Op,
    orders: &Orders,
    out: &mut Jet<Lanes<N>>,
    a: &Jet<Lanes<N>>,
    b: &Jet<Lanes<N>>,
) -> Result<(), NoValue> {
    op.apply(orders, out, a, b)
}

/// Coefficient `k` of the operations that most right sides consist of, by the sums that [`Jet`] makes; `false` where it is left
/// to the recurrence.
#[inline(always)]
fn grow<S: Simd, const N: usize>(
    simd: S,
    op: Op,
    k: usize,
    out: &mut Jet<Lanes<N>>,
    a: &Jet<Lanes<N>>,
    b: &Jet<Lanes<N>>,
) -> bool {
    // One lane at a time would be slower than what the compiler makes of an array.
    if S::F64_LANES == 1 || !N.is_multiple_of(S::F64_LANES) || k >= out.series.len() {
        return false;
    }
    macro_rules! put {
        ($lanes:expr, $value:expr) => {{
            // x − x is 0, or NaN where x is not finite.
            let value = simd.add_f64s($value, simd.sub_f64s($value, $value));
            S::as_mut_simd_f64s(&mut out.series[k].0).0[$lanes] = value;
        }};
    }
    macro_rules! each {
        (|$lanes:ident| $value:expr) => {
            for $lanes in 0..N / S::F64_LANES {
                let value = $value;
                put!($lanes, value);
            }
        };
    }
    match op {
        Op::Add => each!(|lanes| simd.add_f64s(coefficient(simd, a, k, lanes), coefficient(simd, b, k, lanes))),
        Op::Sub => each!(|lanes| simd.sub_f64s(coefficient(simd, a, k, lanes), coefficient(simd, b, k, lanes))),
        Op::Neg => each!(|lanes| simd.neg_f64s(coefficient(simd, a, k, lanes))),
        Op::Mul => match (a.upto(k), b.upto(k)) {
            // Both in one loop, where there are two.
            (Some(p), Some(q)) if N == 2 * S::F64_LANES => {
                let [low, high] = convolution(simd, 0, p, q);
                put!(0, low);
                put!(1, high);
            }
            (Some(p), Some(q)) => each!(|lanes| {
                let [sum] = convolution(simd, lanes, p, q);
                sum
            }),
            _ if a.length == 1 => {
                each!(|lanes| simd.mul_f64s(coefficient(simd, a, 0, lanes), coefficient(simd, b, k, lanes)))
            }
            _ if b.length == 1 => {
                each!(|lanes| simd.mul_f64s(coefficient(simd, a, k, lanes), coefficient(simd, b, 0, lanes)))
            }
            _ => return false,
        },
        Op::Div => match (b.upto(k), out.series.get(..k)) {
            _ if b.length == 1 => {
                each!(|lanes| simd.div_f64s(coefficient(simd, a, k, lanes), coefficient(simd, b, 0, lanes)))
            }
            (Some([_, q @ ..]), Some(_)) => each!(|lanes| {
                let [known] = convolution(simd, lanes, q, &out.series[..k]);
                simd.div_f64s(simd.sub_f64s(coefficient(simd, a, k, lanes), known), coefficient(simd, b, 0, lanes))
            }),
            _ => return false,
        },
        _ => return false,
    }
    if !out.series[k].is_zero() {
        out.length = k + 1;
    }
    true
}
