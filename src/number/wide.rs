//! The operations of [`BoundedLanes`] in the widest registers of the processor.
//!
//! **In:** the steps of a program over lanes. **Out:** their results. **Guaranteed:** every lane is, bit for bit, what
//! [`Bounded`](super::Bounded) computes, on every processor: the same operations of IEEE 754 in the same order, however many
//! of them are made at once, and no fused ones.
//!
//! **Why so:** a result is written first and doubted afterwards. An error bound that is finite says that the value is, too;
//! what else an operation asks of its arguments is noted on the way. Where this does not hold in the whole block, the operation
//! is made again lane by lane, and what comes out then counts. So the common case is free of branches, and there is one place
//! that says why something has no value.
//!
//! The crate `pulp` finds out at run time which registers there are, and needs no unsafe code here. A loop over arrays is not
//! enough: the compiler splits eight lanes into unequal parts, and the program is then slower than without.

use super::bounded::{DOWN, TINY, U, UP};
use super::deviation::{Directions, Turns, Waves};
use super::elementary::whole;
use super::operation::{Apply, run_each};
use super::{BoundedLanes, Instruction, NoValue, Op};
use pulp::{Simd, WithSimd};

/// Steps over lanes, to be run with some instruction set.
pub(super) struct Steps<'s, const N: usize> {
    pub(super) values: &'s mut [BoundedLanes<N>],
    pub(super) missing: &'s mut [Option<NoValue>],
    pub(super) steps: &'s [Instruction],
}

impl<const N: usize> WithSimd for Steps<'_, N> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        run_each(self.values, self.missing, self.steps, Together(simd));
    }
}

/// All lanes together, where that can be.
struct Together<S>(S);

impl<S: Simd, const N: usize> Apply<BoundedLanes<N>> for Together<S> {
    const PAIRS: bool = true;

    #[inline(always)]
    fn apply(
        &self,
        op: Op,
        out: &mut BoundedLanes<N>,
        a: &BoundedLanes<N>,
        b: &BoundedLanes<N>,
    ) -> Result<(), NoValue> {
        if together(self.0, op, out, a, b) { Ok(()) } else { by_lanes(op, out, a, b) }
    }

    #[inline(always)]
    fn sin_cos(&self, sin: &mut BoundedLanes<N>, cos: &mut BoundedLanes<N>, a: &BoundedLanes<N>) -> bool {
        waves(self.0, sin, cos, a)
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

/// A result in all lanes from pairs of them; `false` where a condition is not met or an error bound is not finite. A macro,
/// since what is not part of one function with the instruction set would be called for every addition.
macro_rules! zip {
    ($simd:ident, $out:ident, $x:expr, $y:expr, |$sure:ident, $a:ident, $b:ident| $ball:expr) => {{
        let (x, y) = ($x, $y);
        let (xv, xe) = (S::as_simd_f64s(&x.value).0, S::as_simd_f64s(&x.error).0);
        let (yv, ye) = (S::as_simd_f64s(&y.value).0, S::as_simd_f64s(&y.error).0);
        let (ov, oe) = (S::as_mut_simd_f64s(&mut $out.value).0, S::as_mut_simd_f64s(&mut $out.error).0);
        let largest = $simd.splat_f64s(f64::MAX);
        // 0 ≤ MAX holds in all lanes.
        let mut $sure = Sure::<S>($simd.less_than_or_equal_f64s($simd.splat_f64s(0.0), largest));
        for i in 0..N / S::F64_LANES {
            let ($a, $b) = (Ball::<S>(xv[i], xe[i]), Ball::<S>(yv[i], ye[i]));
            let Ball::<S>(value, error) = $ball;
            (ov[i], oe[i]) = (value, error);
            $sure.and($simd, $simd.less_than_or_equal_f64s(error, largest));
        }
        $simd.first_true_m64s($simd.not_m64s($sure.0)) >= S::F64_LANES
    }};
}

/// An operation in all lanes; `false` where it must be made lane by lane.
#[inline(always)]
fn together<S: Simd, const N: usize>(
    simd: S,
    op: Op,
    out: &mut BoundedLanes<N>,
    a: &BoundedLanes<N>,
    b: &BoundedLanes<N>,
) -> bool {
    if !N.is_multiple_of(S::F64_LANES) {
        return false;
    }
    match op {
        Op::Add => zip!(simd, out, a, b, |sure, a, b| add(simd, a, b)),
        Op::Sub => zip!(simd, out, a, b, |sure, a, b| add(simd, a, neg(simd, b))),
        Op::Mul => zip!(simd, out, a, b, |sure, a, b| mul(simd, a, b)),
        Op::Div => zip!(simd, out, a, b, |sure, a, b| div(simd, &mut sure, a, b)),
        Op::Neg => zip!(simd, out, a, a, |sure, a, _b| {
            sure.finite(simd, a.0);
            neg(simd, a)
        }),
        Op::Abs => zip!(simd, out, a, a, |sure, a, _b| {
            sure.finite(simd, a.0);
            Ball(simd.abs_f64s(a.0), a.1)
        }),
        Op::Sqrt => zip!(simd, out, a, a, |sure, a, _b| sqrt(simd, &mut sure, a)),
        Op::Powi(2) => zip!(simd, out, a, a, |sure, a, _b| mul(simd, a, a)),
        Op::Powi(n) if n > 2 => zip!(simd, out, a, a, |sure, a, _b| power(simd, a, n.unsigned_abs())),
        Op::Sin => waves(simd, out, &mut a.clone(), a),
        Op::Cos => waves(simd, &mut a.clone(), out, a),
        Op::Arctan2 => {
            let arguments = [&a.value, &a.error, &b.value, &b.error];
            whole(simd, Turns, &mut [&mut out.value, &mut out.error], &arguments)
        }
        Op::DirectionCosine => {
            let arguments = [&a.value, &a.error, &b.value, &b.error];
            whole(simd, Directions, &mut [&mut out.value, &mut out.error], &arguments)
        }
        _ => false,
    }
}

/// Sine and cosine in all lanes; `false` where they must be made lane by lane.
#[inline(always)]
fn waves<S: Simd, const N: usize>(
    simd: S,
    sin: &mut BoundedLanes<N>,
    cos: &mut BoundedLanes<N>,
    a: &BoundedLanes<N>,
) -> bool {
    let out = &mut [&mut sin.value, &mut sin.error, &mut cos.value, &mut cos.error];
    N.is_multiple_of(S::F64_LANES) && whole(simd, Waves, out, &[&a.value, &a.error])
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
    let exact = is_exact_zero(simd, simd.add_f64s(simd.abs_f64s(a.0), a.1));
    let tiny = simd.select_f64s(exact, simd.splat_f64s(0.0), tiny);
    let shift = simd.mul_f64s(simd.add_f64s(simd.mul_f64s(simd.abs_f64s(value), up), tiny), b.1);
    let spread = simd.div_f64s(simd.add_f64s(a.1, shift), least);
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

/// One operation in all lanes; `false` where it must be made lane by lane.
pub(super) struct Once<'s, const N: usize> {
    pub(super) op: Op,
    pub(super) out: &'s mut BoundedLanes<N>,
    pub(super) a: &'s BoundedLanes<N>,
    pub(super) b: &'s BoundedLanes<N>,
}

impl<const N: usize> WithSimd for Once<'_, N> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> bool {
        together(simd, self.op, self.out, self.a, self.b)
    }
}

/// Σᵢ aᵢ·bₙ₋₁₋ᵢ over two slices of the same length n, in the order of [`Scalar::convolution`](super::Scalar::convolution).
pub(super) struct Convolution<'s, T>(pub(super) &'s [T], pub(super) &'s [T]);

impl<const N: usize> WithSimd for Convolution<'_, BoundedLanes<N>> {
    /// `None` where it must be made lane by lane: a sum of exact zeros is exact.
    type Output = Option<BoundedLanes<N>>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Self::Output {
        let Convolution(a, b) = self;
        if !N.is_multiple_of(S::F64_LANES) || a.len() != b.len() {
            return None;
        }
        let (n, body) = (a.len(), a.len() / 4 * 4);
        let zero = simd.splat_f64s(0.0);
        let count = n as f64;
        let mut out = BoundedLanes { value: [0.0; N], error: [0.0; N] };
        for lanes in 0..N / S::F64_LANES {
            let (mut s, mut size, mut spread) = ([zero; 4], [zero; 4], [zero; 4]);
            let mut value = zero;
            // A macro for the reason given at `zip`.
            macro_rules! term {
                ($t:expr, $i:expr, $sum:expr) => {{
                    let (p, q) = (&a[$t], &b[n - 1 - $t]);
                    let (pv, pe) = (S::as_simd_f64s(&p.value).0[lanes], S::as_simd_f64s(&p.error).0[lanes]);
                    let (qv, qe) = (S::as_simd_f64s(&q.value).0[lanes], S::as_simd_f64s(&q.error).0[lanes]);
                    $sum = simd.add_f64s($sum, simd.mul_f64s(pv, qv));
                    let (x, y) = (simd.abs_f64s(pv), simd.abs_f64s(qv));
                    size[$i] = simd.add_f64s(size[$i], simd.mul_f64s(x, y));
                    let reach = simd.mul_f64s(simd.add_f64s(y, qe), pe);
                    spread[$i] = simd.add_f64s(spread[$i], simd.add_f64s(simd.mul_f64s(x, qe), reach));
                }};
            }
            for t in (0..body).step_by(4) {
                term!(t, 0, s[0]);
                term!(t + 1, 1, s[1]);
                term!(t + 2, 2, s[2]);
                term!(t + 3, 3, s[3]);
            }
            let sum = simd.add_f64s(simd.add_f64s(s[0], s[2]), simd.add_f64s(s[1], s[3]));
            value = simd.add_f64s(value, sum);
            for t in body..n {
                term!(t, t - body, value);
            }
            let size = simd.add_f64s(simd.add_f64s(size[0], size[1]), simd.add_f64s(size[2], size[3]));
            let spread = simd.add_f64s(simd.add_f64s(spread[0], spread[1]), simd.add_f64s(spread[2], spread[3]));
            let exact = simd.and_m64s(simd.equal_f64s(size, zero), simd.equal_f64s(spread, zero));
            if simd.first_true_m64s(exact) < S::F64_LANES {
                return None;
            }
            let rounding = simd.mul_f64s(simd.splat_f64s((count + 1.0) * U), size);
            let error = simd.mul_f64s(simd.add_f64s(spread, rounding), simd.splat_f64s(UP + 2.0 * count * U));
            S::as_mut_simd_f64s(&mut out.value).0[lanes] = value;
            S::as_mut_simd_f64s(&mut out.error).0[lanes] = simd.add_f64s(error, simd.splat_f64s(count * TINY));
        }
        Some(out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Bounded, Draws, Jet, Lanes, Number, Orders, Scalar};

    /// Numbers of all sizes, exact or not, with zeros, and now and then one that is not finite.
    fn number(draws: &mut Draws) -> Bounded {
        let sign = if draws.below(2) == 0 { 1.0 } else { -1.0 };
        let value = match draws.below(40) {
            0 => 0.0,
            1 => f64::MIN_POSITIVE / 8.0,
            2 => 1e300,
            3 => f64::NAN,
            4 => f64::INFINITY,
            5..=8 => 1e-160,
            9..=12 => 1.0,
            _ => draws.below(1 << 20) as f64 / 65536.0,
        };
        let error = match draws.below(16) {
            0 => value.abs(),
            1 => 2.0 * value.abs(),
            2 => f64::INFINITY,
            3 => f64::MIN_POSITIVE / 8.0,
            4..=9 => 0.0,
            _ => value.abs() * 1e-12,
        };
        Bounded::new(sign * value, error)
    }

    #[test]
    fn wide_sums_are_those_of_one_point() {
        let mut draws = Draws::new(13);
        let mut exact = 0;
        for round in 0..2000 {
            let n = 1 + round % 23;
            let mut series = || -> Vec<BoundedLanes<8>> {
                // Exact zeros make sums exact.
                let zeros = round % 5 == 0;
                let mut of = |_| if zeros && draws.below(3) > 0 { Bounded::exact(0.0) } else { number(&mut draws) };
                (0..n).map(|_| BoundedLanes::of(std::array::from_fn(&mut of))).collect()
            };
            let (a, b) = (series(), series());
            let sum = BoundedLanes::convolution(&a, &b);
            let narrow = Convolution(&a, &b).with_simd(pulp::Scalar::new());
            let finite = sum.value.iter().chain(&sum.error).all(|x| x.is_finite());
            assert!(!finite || narrow.is_none_or(|narrow| narrow == sum), "{a:?} {b:?}");
            let plain = |x: &[BoundedLanes<8>]| x.iter().map(|x| Lanes(x.value)).collect::<Vec<Lanes<8>>>();
            let values = Lanes::convolution(&plain(&a), &plain(&b));
            for i in 0..8 {
                let of = |x: &[BoundedLanes<8>]| x.iter().map(|x| x.lane(i)).collect::<Vec<Bounded>>();
                let value = |x: &[BoundedLanes<8>]| x.iter().map(|x| x.value[i]).collect::<Vec<f64>>();
                let one = Bounded::convolution(&of(&a), &of(&b));
                // A NaN is one, whatever its bits.
                let same = |x: f64, y: f64| x.to_bits() == y.to_bits() || x.is_nan() && y.is_nan();
                assert!(same(sum.value[i], one.value) && same(sum.error[i], one.error), "{a:?} {b:?}");
                assert!(same(values.0[i], f64::convolution(&value(&a), &value(&b))), "{a:?} {b:?}");
                exact += usize::from(one.error == 0.0);
            }
        }
        assert!(exact > 20, "{exact}");
    }

    /// Runs a program over series in lanes and over those of one point, order by order: how many coefficients were compared.
    fn check_series<const N: usize>(rounds: usize) -> usize {
        const DEGREE: usize = 13;
        let mut draws = Draws::new(17);
        let mut compared = 0;
        let ops = [Op::Add, Op::Sub, Op::Mul, Op::Div, Op::Neg, Op::Mul, Op::Powi(2), Op::Sqrt, Op::Sin, Op::Arctan2];
        for round in 0..rounds {
            // Arguments that end early, begin with zeros, or are not finite somewhere.
            let mut argument = |_| -> Vec<[f64; N]> {
                let length = if draws.below(3) == 0 { 1 + draws.below(4) as usize } else { DEGREE + 1 };
                let zeros = draws.below(4) == 0;
                let mut of = |k: usize| match k >= length || zeros && draws.below(2) == 0 {
                    true => 0.0,
                    false if round % 3 > 0 => draws.below(1 << 20) as f64 / 65536.0 - 3.0,
                    false => number(&mut draws).value,
                };
                (0..=DEGREE).map(|k| std::array::from_fn(|_| of(k))).collect()
            };
            let arguments: Vec<Vec<[f64; N]>> = (0..3).map(&mut argument).collect();
            let steps: Vec<Instruction> = (3..9)
                .map(|out| {
                    let (a, b) = (draws.below(u64::from(out)) as u32, draws.below(u64::from(out)) as u32);
                    let op = ops[draws.below(ops.len() as u64) as usize];
                    Instruction { op, a, b: if op.arity() == 1 { a } else { b }, out }
                })
                .collect();
            fn grown<B: Scalar>(arguments: &[Vec<B>], steps: &[Instruction]) -> (Vec<Jet<B>>, Vec<Option<NoValue>>) {
                let orders = Orders::all(DEGREE);
                let mut values = vec![Jet::constant(B::ZERO, &orders); 9];
                for (x, argument) in values.iter_mut().zip(arguments) {
                    argument.iter().enumerate().for_each(|(k, c)| x.set_coefficient(k, *c));
                    // What is known of an argument does not end with a zero.
                    argument.iter().enumerate().filter(|(_, c)| !c.is_zero()).for_each(|(k, _)| x.length = k + 1);
                }
                let mut missing = vec![None; 9];
                let mut first = vec![None; 9];
                for k in 0..=DEGREE {
                    Jet::run(&Orders::only(k, DEGREE), &mut values, &mut missing, steps);
                    first.iter_mut().zip(&missing).for_each(|(f, m): (&mut Option<NoValue>, _)| *f = f.or(*m));
                }
                (values, first)
            }
            let lanes: Vec<Vec<Lanes<N>>> = arguments.iter().map(|a| a.iter().map(|c| Lanes(*c)).collect()).collect();
            let (wide, missing) = grown(&lanes, &steps);
            assert!(missing.iter().all(Option::is_none));
            for i in 0..N {
                let one: Vec<Vec<f64>> = arguments.iter().map(|a| a.iter().map(|c| c[i]).collect()).collect();
                let (narrow, missing) = grown(&one, &steps);
                for slot in 3..9 {
                    for k in 0..=DEGREE {
                        let (x, y) = (wide[slot].coefficient(k).0[i], narrow[slot].coefficient(k));
                        // A lane may be without a value where a point is not: it is grown again alone then.
                        if missing[slot].is_none() && !x.is_nan() {
                            assert_eq!(x, y, "{steps:?} slot {slot} order {k} of {one:?}");
                            compared += 1;
                        }
                    }
                    let valued = (0..=DEGREE).all(|k| !wide[slot].coefficient(k).0[i].is_nan());
                    assert!(missing[slot].is_none() || !valued, "{steps:?} slot {slot} of {one:?}");
                }
            }
        }
        compared
    }

    #[test]
    fn wide_series_are_those_of_one_point() {
        let compared = (check_series::<8>(400), check_series::<4>(400), check_series::<3>(100));
        assert!(compared.0 > 50_000 && compared.1 > 25_000 && compared.2 > 3_000, "{compared:?}");
    }

    fn check<const N: usize>(blocks: usize) -> usize {
        let mut draws = Draws::new(11);
        let mut compared = 0;
        let ops: Vec<Op> = Op::EVERY.iter().copied().chain([0, 1, 2, 5, 6, -1].map(Op::Powi)).collect();
        for round in 0..blocks {
            // Most blocks have a value throughout, others in most lanes.
            let mut tame = || loop {
                let x = number(&mut draws);
                if round % 3 == 0 || x.value.is_finite() && x.error <= 1e-6 * x.value.abs() {
                    return x;
                }
            };
            let (a, b) = (std::array::from_fn(|_| tame()), std::array::from_fn(|_| tame()));
            let mut values = vec![BoundedLanes::<N>::of(a), BoundedLanes::of(b), BoundedLanes::splat(a[0])];
            for &op in &ops {
                let mut missing = [None; 3];
                BoundedLanes::run(&(), &mut values, &mut missing, &[Instruction { op, a: 0, b: 1, out: 2 }]);
                let mut other = values[2];
                let reason = op.apply(&(), &mut other, &values[0], &values[1]).err();
                assert_eq!(missing[2], reason, "{op:?} of {a:?} and {b:?}");
                // What a processor without wide registers does.
                let mut narrow = values[2];
                if together(pulp::Scalar::new(), op, &mut narrow, &values[0], &values[1]) {
                    assert!(reason.is_none() && narrow == values[2], "{op:?} of {a:?} and {b:?}");
                }
                for i in 0..N {
                    let mut x = Bounded::exact(0.0);
                    let one = op.apply(&(), &mut x, &a[i], &b[i]);
                    assert!(one.is_ok() || reason.is_some(), "{op:?} of {a:?} and {b:?}");
                    if reason.is_none() {
                        let bits = |x: Bounded| (x.value.to_bits(), x.error.to_bits());
                        assert_eq!(bits(values[2].lane(i)), bits(x), "{op:?} of {:?} and {:?}", a[i], b[i]);
                        compared += 1;
                    }
                }
            }
        }
        compared
    }

    #[test]
    fn wide_operations_are_those_of_one_point() {
        let compared = (check::<8>(3000), check::<4>(1000), check::<3>(1000));
        assert!(compared.0 > 300_000 && compared.1 > 30_000 && compared.2 > 20_000, "{compared:?}");
    }

    #[test]
    fn what_is_missing_is_passed_on() {
        let one = BoundedLanes::<8>::splat(Bounded::exact(1.0));
        let mut values = [one; 5];
        let mut missing = [None, Some(NoValue::OutOfDomain), None, None, None];
        let step = |a, b, out| Instruction { op: Op::Add, a, b, out };
        BoundedLanes::run(&(), &mut values, &mut missing, &[step(0, 1, 2), step(0, 0, 3), step(3, 2, 4)]);
        assert_eq!(missing[2..], [Some(NoValue::OutOfDomain), None, Some(NoValue::OutOfDomain)]);
        assert_eq!(values[3].lane(7).value, 2.0);
    }
}
