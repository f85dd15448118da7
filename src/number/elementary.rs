//! Elementary functions of binary64, many at once.
//!
//! **In:** one number, or an array of them. **Out:** the values of a function, each within the bound of its
//! operation, [`Op::units`](super::Op::units). **Guaranteed:** the same bits for a number alone, and in whatever place of an array, on every processor: + − × ÷ √
//! and operations on bits, in one order, none fused. What is no number, and what is outside the domain, has no number as value.
//!
//! **How:** reduction to a small interval (by multiples of π/2 in four parts, of ln 2 in two, by eighths of a turn, by the binary
//! exponent), there a polynomial of least greatest error, and no branches: both of two formulas are evaluated and one is selected.
//! Arguments for which this does not hold (beyond 2¹⁹ for angles, tiny or huge ones for quotients, results that are not normal) go
//! one by one to `pxfm`, which is correctly rounded as far as tests tell; these are rare.
//!
//! **Where the bounds come from:** rounding errors added up by hand. With u = 2⁻⁵³, and a function of value v, what is added up is
//! in units of 2u·|v|. The reduced angle is exact to 2⁻¹⁰⁰, since no binary64 number up to 2¹⁹ is nearer than 2⁻⁶¹ to a multiple of
//! π/2 other than 0 (continued fractions tell), and products with 33 bits are exact; polynomials are within 2⁻⁵⁶ of their function.
//!
//! | function | worst place | sum | bound | greatest error seen (in units in the last place) |
//! |---|---|---|---|---|
//! | sin, cos | near odd multiples of π/4 | 0.8 | 1 | 0.59 (0.82) |
//! | exp | r near ±½ ln 2 | 0.9 | 1 | 0.70 (0.99) |
//! | ln | x near √½ | 0.7 | 1 | 0.69 (0.89) |
//! | arcsin, arccos | near ½ | 1.3 | 2 | 1.24 (1.97) |
//! | tan | near odd multiples of π/4 | 1.9 | 3 | 1.38 (2.30) |
//! | arctan, atan2 | slope tan π/8 | 2.1 | 3 | 1.24 (1.94) |
//! | sinh | near 1 | 1.8 | 3 | 1.22 (1.63) |
//! | cosh | near 0 | 1.7 | 2 | 1.00 (1.36) |
//! | tanh | up to 1 | 2.0 | 3 | 1.59 (2.71) |
//!
//! Seen at 10⁷ arguments each, usual ones and hard ones, beside functions with 64 bits. Sine loses the sign of −0, which is 0 here.

use super::register::{Register, down, up};
use pulp::Simd;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_4, LOG2_E};

/// A function of `A` numbers with `B` results, in each place of registers.
pub(super) trait Function<const A: usize, const B: usize>: Copy {
    /// Where [`Function::wide`] may be used.
    #[inline(always)]
    fn fits<S: Simd>(self, x: [Register<S>; A]) -> S::m64s {
        x[0].all(0.0).upto(0.0)
    }
    /// The results where the arguments fit.
    fn wide<S: Simd>(self, x: [Register<S>; A]) -> [Register<S>; B];
    /// The results where they do not; finite, or NaN.
    fn rare(self, _: [f64; A]) -> [f64; B] {
        [f64::NAN; B]
    }
}

/// The function of one point.
#[inline(always)]
pub(super) fn one<F: Function<A, B>, const A: usize, const B: usize>(f: F, x: [f64; A]) -> [f64; B] {
    let wide = alone(x);
    if f.fits(wide) { f.wide(wide).map(|y| y.x) } else { f.rare(x) }
}

/// One point as registers.
#[inline(always)]
pub(super) fn alone<const A: usize>(x: [f64; A]) -> [Register<pulp::Scalar>; A] {
    x.map(|x| Register { simd: pulp::Scalar::new(), x })
}

/// The function in all lanes that fill registers; whether all of them fit.
#[inline(always)]
pub(super) fn whole<F: Function<A, B>, S: Simd, const A: usize, const B: usize, const N: usize>(
    simd: S,
    f: F,
    out: &mut [&mut [f64; N]; B],
    x: &[&[f64; N]; A],
) -> bool {
    let zero = Register { simd, x: simd.splat_f64s(0.0) };
    let mut fit = zero.upto(0.0);
    for i in 0..N / S::F64_LANES {
        let mut arguments = [zero; A];
        for (argument, x) in arguments.iter_mut().zip(x) {
            argument.x = S::as_simd_f64s(*x).0[i];
        }
        fit = simd.and_m64s(fit, f.fits(arguments));
        for (out, y) in out.iter_mut().zip(f.wide(arguments)) {
            S::as_mut_simd_f64s(*out).0[i] = y.x;
        }
    }
    simd.first_true_m64s(simd.not_m64s(fit)) >= S::F64_LANES
}

/// The function in all lanes.
#[inline(always)]
pub(super) fn each<F: Function<A, B>, S: Simd, const A: usize, const B: usize, const N: usize>(
    simd: S,
    f: F,
    mut out: [&mut [f64; N]; B],
    x: [&[f64; N]; A],
) {
    let rest = N / S::F64_LANES * S::F64_LANES;
    if !whole(simd, f, &mut out, &x) {
        remaining(f, out, x, rest, true);
    } else if rest < N {
        remaining(f, out, x, rest, false);
    }
}

/// Lanes from `rest` on, and those of the others that do not fit.
#[cold]
#[inline(never)]
fn remaining<F: Function<A, B>, const A: usize, const B: usize, const N: usize>(
    f: F,
    mut out: [&mut [f64; N]; B],
    x: [&[f64; N]; A],
    rest: usize,
    unfit: bool,
) {
    for i in if unfit { 0..N } else { rest..N } {
        let arguments = std::array::from_fn(|a| x[a][i]);
        if i >= rest || !f.fits(alone(arguments)) {
            for (out, y) in out.iter_mut().zip(one(f, arguments)) {
                out[i] = y;
            }
        }
    }
}

/// Half of π, in three parts of 33 bits and a rest.
const QUARTER: [f64; 4] = [1.5707963267341256, 6.077100506303966e-11, 2.0222662487111665e-21, 8.4784276603689e-32];
/// π/4, of which the last three bits are 0, so that multiples up to 4 are exact, and a rest.
const EIGHTH: [f64; 2] = [FRAC_PI_4, 3.061616997868383e-17];
/// ln 2 in 42 bits and a rest.
const LN_2: [f64; 2] = [0.6931471805598903, 5.497923018708371e-14];
/// Largest angle that is reduced here.
const TURNS: f64 = 524_288.0;
/// Sizes between which quotients neither overflow nor lose digits: 2^±500.
const SIZES: [f64; 2] = [f64::from_bits(523 << 52), f64::from_bits(1523 << 52)];
/// Largest exponent whose power, and the reciprocal of it, is normal.
const EXPONENT: f64 = 708.0;

/// (sin x/x − 1)/x² in x², |x| ≤ π/4.
const SIN: [f64; 6] = [
    -0.16666666666666632,
    0.008333333333322425,
    -0.00019841269829816907,
    2.755731369518547e-6,
    -2.505075864446359e-8,
    1.5896827324248696e-10,
];
/// (cos x − 1 + x²/2)/x⁴ in x², |x| ≤ π/4.
const COS: [f64; 6] = [
    0.0416666666666666,
    -0.0013888888888874138,
    2.4801587289491888e-5,
    -2.7557314355252085e-7,
    2.0875723684787227e-9,
    -1.1359669835462548e-11,
];
/// (arctan x/x − 1)/x² in x², |x| ≤ tan π/8.
const ARCTAN: [f64; 11] = [
    -0.333333333333332,
    0.1999999999995408,
    -0.14285714280248368,
    0.1111111078613372,
    -0.09090897836375164,
    0.07692061636202359,
    -0.06663120375485122,
    0.05848008859042387,
    -0.05039845246713149,
    0.03807831374801447,
    -0.017922270723150193,
];
/// (e^x − 1 − x)/x², |x| ≤ ln 2/2.
const EXP: [f64; 10] = [
    0.5000000000000012,
    0.166666666666667,
    0.04166666666651554,
    0.008333333333307168,
    0.001388888894698167,
    0.00019841269917464252,
    2.4801489979998817e-5,
    2.755721623384279e-6,
    2.7631266063456175e-7,
    2.5117880184666697e-8,
];
/// (2 artanh x/x − 2)/x² in x², |x| ≤ (√2 − 1)/(√2 + 1).
const LN: [f64; 7] = [
    0.6666666666666734,
    0.399999999994147,
    0.28571428742384825,
    0.22222198573351296,
    0.18183564323108323,
    0.15314050494417486,
    0.14795951525027634,
];
/// (arcsin x/x − 1)/x² in x², |x| ≤ 1/2.
const ARCSIN: [f64; 13] = [
    0.16666666666666763,
    0.07499999999970264,
    0.04464285717512015,
    0.03038194268363769,
    0.02237221565990691,
    0.017351600097087843,
    0.013980961400287444,
    0.011397776363663827,
    0.010786526988517826,
    0.003683050116985621,
    0.02176347764717837,
    -0.021077258433876724,
    0.03267686608143648,
];
/// (sinh x/x − 1)/x² in x², |x| ≤ 1.
const SINH: [f64; 7] = [
    0.16666666666666669,
    0.008333333333333139,
    0.00019841269841437684,
    2.7557319155335837e-6,
    2.5052123398745496e-8,
    1.6057240325212464e-10,
    7.759312716045403e-13,
];

/// a − b, and what was rounded away.
#[inline(always)]
fn difference<S: Simd>(a: Register<S>, b: Register<S>) -> [Register<S>; 2] {
    let value = a - b;
    let part = value - a;
    [value, (a - (value - part)) - (b + part)]
}

/// Sine and cosine of an angle up to [`TURNS`].
#[inline(always)]
pub(super) fn sin_cos<S: Simd>(x: Register<S>) -> [Register<S>; 2] {
    let n = (x * FRAC_2_PI).rounded();
    // x − nπ/2 as a sum: the first difference and all products but the last are exact.
    let [first, rest] = difference(x - n * QUARTER[0], n * QUARTER[1]);
    let [second, more] = difference(first, n * QUARTER[2]);
    let tail = (rest + more) - n * QUARTER[3];
    let angle = second + tail;
    let low = (second - angle) + tail;
    let z = angle * angle;
    let half = 0.5 * z;
    let sin = angle + (angle * z * z.polynomial(&SIN) + low * (1.0 - half));
    let most = 1.0 - half;
    let cos = most + (((1.0 - most) - half) + (z * z * z.polynomial(&COS) - angle * low));
    // n modulo 4, from bit 32 on: a number of that size has its units there.
    let simd = x.simd;
    let quarters = (n + 1.5 * f64::from(1 << 20)).bits();
    let odd = simd.and_u64s(quarters, x.bits_of(1 << 32));
    let even = simd.equal_u64s(odd, x.bits_of(0));
    let two = x.bits_of(2 << 32);
    let sign = up(simd, simd.and_u64s(quarters, two), 30);
    let next = simd.add_u64s(quarters, x.bits_of(1 << 32));
    let sign_of_next = up(simd, simd.and_u64s(next, two), 30);
    [sin.or(even, cos).flipped(sign), cos.or(even, sin).flipped(sign_of_next)]
}

/// e^x for an exponent up to [`EXPONENT`].
#[inline(always)]
fn exp<S: Simd>(x: Register<S>) -> Register<S> {
    let n = (x * LOG2_E).rounded();
    let (high, low) = (x - n * LN_2[0], n * LN_2[1]);
    let r = high - low;
    let value = 1.0 + (high - (low - r * r * r.polynomial(&EXP)));
    // 2ⁿ: the units of a number of this size stand 20 bits below those of its exponent.
    let power = up(x.simd, (n + (1.5 * f64::from(1 << 20) + 1023.0)).bits(), 20);
    value * x.with_bits(power)
}

/// ln x for a normal number.
#[inline(always)]
fn ln<S: Simd>(x: Register<S>) -> Register<S> {
    // √½ in its upper bits: x = 2ᵏm with √½ ≤ m < √2.
    const HALF: u64 = 0x3FE6_A09E_0000_0000;
    let simd = x.simd;
    let bits = simd.add_u64s(x.bits(), x.bits_of((1023 << 52) - HALF));
    let exponent = simd.or_u64s(down(simd, simd.and_u64s(bits, x.bits_of(0x7FF << 52)), 20), x.bits_of(1043 << 52));
    let k = x.with_bits(exponent) - (f64::from(1 << 20) + 1023.0);
    let m = x.with_bits(simd.add_u64s(simd.and_u64s(bits, x.bits_of(!0 >> 12)), x.bits_of(HALF)));
    let f = m - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let half = 0.5 * f * f;
    let rest = s * (half + z * z.polynomial(&LN)) + k * LN_2[1];
    k * LN_2[0] - ((half - rest) - f)
}

/// The angle of (x, y) in the upper half-plane, sizes of both given; x < 0 where `left`.
#[inline(always)]
fn angle<S: Simd>(y: Register<S>, x: Register<S>, left: S::m64s) -> Register<S> {
    const TAN_EIGHTH: f64 = 0.414_213_562_373_095_03;
    let steep = x.below(y);
    let (a, b) = (x.or(steep, y), y.or(steep, x));
    let near = (b * TAN_EIGHTH).below(a);
    let q = (a - b).or(near, a) / (a + b).or(near, b);
    let z = q * q;
    // In eighths of a turn, and whether what remains is taken away.
    let (zero, minus) = (q.all(0.0), q.all(-0.0));
    let eighths = zero.all(1.0).or(near, zero);
    let eighths = (2.0 - eighths).or(steep, eighths);
    let eighths = (4.0 - eighths).or(left, eighths);
    let sign = q.simd.xor_u64s(minus.or(steep, zero).bits(), minus.or(left, zero).bits());
    let q = q.flipped(sign);
    eighths * EIGHTH[0] + (q + (q * z * z.polynomial(&ARCTAN) + eighths * EIGHTH[1]))
}

/// arcsin s − s, and s: that of |x| up to 1/2, beyond it √((1 − |x|)/2), which is the sine of half the complement.
#[inline(always)]
fn arc<S: Simd>(x: Register<S>) -> ([Register<S>; 2], S::m64s) {
    let size = x.abs();
    let small = size.upto(0.5);
    let z = (x * x).or(small, (1.0 - size) * 0.5);
    let s = size.or(small, z.sqrt());
    ([s * z * z.polynomial(&ARCSIN), s], small)
}

/// sinh x − x, |x| ≤ 1.
#[inline(always)]
fn above<S: Simd>(x: Register<S>) -> Register<S> {
    let z = x * x;
    x * z * z.polynomial(&SINH)
}

/// A function of one number: its formula, where it may be used, and what is used elsewhere.
macro_rules! function {
    ($($Name:ident |$x:ident| $fits:expr, $wide:expr, $rare:path;)*) => {$(
        #[doc = concat!("See [`Op::", stringify!($Name), "`].")]
        #[derive(Clone, Copy)]
        pub(super) struct $Name;

        impl Function<1, 1> for $Name {
            #[inline(always)]
            fn fits<S: Simd>(self, [$x]: [Register<S>; 1]) -> S::m64s {
                $fits
            }
            #[inline(always)]
            fn wide<S: Simd>(self, [$x]: [Register<S>; 1]) -> [Register<S>; 1] {
                [$wide]
            }
            fn rare(self, [x]: [f64; 1]) -> [f64; 1] {
                [finite($rare(x))]
            }
        }
    )*};
}

/// The number itself, or NaN if it is not finite.
pub(super) fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { f64::NAN }
}

function! {
    Sin |x| x.abs().upto(TURNS), sin_cos(x)[0], pxfm::f_sin;
    Cos |x| x.abs().upto(TURNS), sin_cos(x)[1], pxfm::f_cos;
    Tan |x| x.abs().upto(TURNS), {
        let [sin, cos] = sin_cos(x);
        sin / cos
    }, pxfm::f_tan;
    Exp |x| x.abs().upto(EXPONENT), exp(x), pxfm::f_exp;
    Ln |x| x.simd.and_m64s(x.all(f64::MIN_POSITIVE).upto(x), x.upto(f64::MAX)), ln(x), pxfm::f_log;
    Arcsin |x| x.abs().upto(1.0), {
        let ([w, s], small) = arc(x);
        let quarter = [2.0 * EIGHTH[0], 2.0 * EIGHTH[1]];
        let large = (quarter[0] - 2.0 * s) + (quarter[1] - 2.0 * w);
        (s + w).or(small, large).flipped(x.sign())
    }, pxfm::f_asin;
    Arccos |x| x.abs().upto(1.0), {
        let ([w, s], small) = arc(x);
        let quarter = [2.0 * EIGHTH[0], 2.0 * EIGHTH[1]];
        let middle = quarter[0] - (x - (quarter[1] - w.flipped(x.sign())));
        let left = (quarter[0] - s) + (quarter[1] - w);
        middle.or(small, 2.0 * left.or(x.below(0.0), s + w))
    }, pxfm::f_acos;
    Arctan |x| x.abs().upto(SIZES[1]), {
        let angle = angle(x.abs(), x.all(1.0), x.below(x));
        angle.flipped(x.sign())
    }, pxfm::f_atan;
    Sinh |x| x.abs().upto(EXPONENT), {
        let power = exp(x.abs());
        let large = (0.5 * power - 0.5 / power).flipped(x.sign());
        (x + above(x)).or(x.abs().upto(1.0), large)
    }, pxfm::f_sinh;
    Cosh |x| x.abs().upto(EXPONENT), {
        let power = exp(x.abs());
        0.5 * power + 0.5 / power
    }, pxfm::f_cosh;
    Tanh |x| x.abs().upto(0.5 * EXPONENT), {
        let large = (1.0 - 2.0 / (exp(2.0 * x.abs()) + 1.0)).flipped(x.sign());
        let sinh = x + above(x);
        (sinh / (1.0 + sinh * sinh).sqrt()).or(x.abs().upto(1.0), large)
    }, pxfm::f_tanh;
}

/// Sine and cosine of one angle.
#[derive(Clone, Copy)]
pub(super) struct SinCos;

impl Function<1, 2> for SinCos {
    #[inline(always)]
    fn fits<S: Simd>(self, x: [Register<S>; 1]) -> S::m64s {
        Sin.fits(x)
    }
    #[inline(always)]
    fn wide<S: Simd>(self, [x]: [Register<S>; 1]) -> [Register<S>; 2] {
        sin_cos(x)
    }
    fn rare(self, x: [f64; 1]) -> [f64; 2] {
        [Sin.rare(x)[0], Cos.rare(x)[0]]
    }
}

/// The angle of the point with the ordinate y and the abscissa x, in this order. −0 is 0: never the other side of the cut.
#[derive(Clone, Copy)]
pub(super) struct Arctan2;

impl Function<2, 1> for Arctan2 {
    #[inline(always)]
    fn fits<S: Simd>(self, [y, x]: [Register<S>; 2]) -> S::m64s {
        let simd = x.simd;
        let [y, x] = [y.abs(), x.abs()];
        let low = x.all(SIZES[0]);
        let (some, none) = ([low.upto(y), low.upto(x)], [y.is(0.0), x.is(0.0)]);
        // Neither too large, at least one of them not too small, and the other not either, or 0.
        let upper = simd.and_m64s(y.upto(SIZES[1]), x.upto(SIZES[1]));
        let each = simd.and_m64s(simd.or_m64s(some[0], none[0]), simd.or_m64s(some[1], none[1]));
        simd.and_m64s(simd.and_m64s(upper, each), simd.or_m64s(some[0], some[1]))
    }
    #[inline(always)]
    fn wide<S: Simd>(self, [y, x]: [Register<S>; 2]) -> [Register<S>; 1] {
        let y = y + 0.0;
        [angle(y.abs(), x.abs(), x.below(0.0)).flipped(y.sign())]
    }
    fn rare(self, [y, x]: [f64; 2]) -> [f64; 1] {
        [if y == 0.0 && x == 0.0 { f64::NAN } else { finite(pxfm::f_atan2(y + 0.0, x + 0.0)) }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Op;
    use crate::{Draws, Lanes};

    /// A number of some size, 2^`from` … 2^`to`, with a sign.
    fn scaled(draws: &mut Draws, from: i32, to: i32) -> f64 {
        let exponent = from + draws.below((to - from) as u64) as i32;
        let mantissa = 1.0 + draws.below(1 << 52) as f64 / (1_u64 << 52) as f64;
        // In two factors, so that none is too small.
        let power = |e: i32| f64::from_bits(((1023 + e) as u64) << 52);
        let size = mantissa * power(exponent / 2) * power(exponent - exponent / 2);
        if draws.below(2) == 0 { size } else { -size }
    }

    /// Usual arguments, neighbours of the places where formulas change, and numbers of all sizes, not finite ones among them.
    fn argument(draws: &mut Draws) -> f64 {
        const PLACES: [f64; 12] = [
            0.0,
            0.5,
            1.0,
            FRAC_2_PI,
            0.414_213_562_373_095_03,
            0.346_573_590_279_972_64,
            354.0,
            708.0,
            709.78,
            TURNS,
            1e150,
            1e-150,
        ];
        match draws.below(8) {
            0 | 1 => scaled(draws, -4, 4),
            2 => scaled(draws, -1074, 1023),
            3 => scaled(draws, -30, 20),
            4 => draws.below(700_000) as f64 * FRAC_PI_4 * (1.0 + scaled(draws, -53, -51)),
            5 => PLACES[draws.below(12) as usize] * (1.0 + scaled(draws, -53, -4)),
            6 => 1.0 + scaled(draws, -53, -1),
            _ => [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 5e-324, -1.0, 1.0][draws.below(8) as usize],
        }
    }

    /// How far y is from the value of `pxfm`, in units in the last place; 0 where both are no number.
    fn distance(y: f64, exact: f64) -> u64 {
        // −0 beside 0 aside, numbers of one sign are ordered as their bits are.
        match (y.is_finite(), exact.is_finite()) {
            (true, true) if y == exact => 0,
            (true, true) if (y < 0.0) == (exact < 0.0) => y.to_bits().abs_diff(exact.to_bits()),
            (false, false) => 0,
            _ => u64::MAX,
        }
    }

    #[test]
    fn values_are_within_their_bounds() {
        type Of = fn(f64) -> f64;
        let oracles: [(Op, Of); 11] = [
            (Op::Exp, pxfm::f_exp),
            (Op::Ln, pxfm::f_log),
            (Op::Sin, pxfm::f_sin),
            (Op::Cos, pxfm::f_cos),
            (Op::Tan, pxfm::f_tan),
            (Op::Arcsin, pxfm::f_asin),
            (Op::Arccos, pxfm::f_acos),
            (Op::Arctan, pxfm::f_atan),
            (Op::Sinh, pxfm::f_sinh),
            (Op::Cosh, pxfm::f_cosh),
            (Op::Tanh, pxfm::f_tanh),
        ];
        let mut draws = Draws::new(5);
        for (op, exact) in oracles {
            let (mut values, mut farthest) = (0, 0);
            for _ in 0..100_000 {
                let (x, mut y) = (argument(&mut draws), 0.0);
                let found = op.apply(&(), &mut y, &x, &x).is_ok();
                let off = distance(if found { y } else { f64::NAN }, exact(x));
                // The value of the oracle is half a unit off itself.
                assert!(off as f64 <= op.units(), "{op:?} of {x:e} is {y:e}, {off} units off");
                values += usize::from(found);
                farthest = farthest.max(off);
            }
            assert!(values > 30_000 && farthest > 0, "{op:?}: {values} {farthest}");
        }
        let mut farthest = 0;
        for _ in 0..100_000 {
            let y = argument(&mut draws);
            let x = if draws.below(2) == 0 { argument(&mut draws) } else { y * scaled(&mut draws, -3, 3) };
            let [angle] = one(Arctan2, [y, x]);
            let exact = if y == 0.0 && x == 0.0 { f64::NAN } else { pxfm::f_atan2(y + 0.0, x + 0.0) };
            let off = distance(angle, exact);
            assert!(off as f64 <= Op::Arctan2.units(), "atan2({y:e}, {x:e}) is {angle:e}, {off} units off");
            farthest = farthest.max(off);
        }
        assert!(farthest > 0);
    }

    /// Blocks of lanes with some that fit and some that do not, in registers and left over.
    fn check<const N: usize>(blocks: usize) {
        let mut draws = Draws::new(11);
        for _ in 0..blocks {
            let usual = draws.below(2) == 0;
            let mut lanes = || {
                Lanes::<N>(std::array::from_fn(
                    |_| if usual { scaled(&mut draws, -8, 0) } else { argument(&mut draws) },
                ))
            };
            let (a, b) = (lanes(), lanes());
            for &op in Op::EVERY {
                let mut out = Lanes::splat(0.0);
                assert!(op.apply(&(), &mut out, &a, &b).is_ok());
                let mut narrow = [0.0; N];
                super::super::real::apply(pulp::Scalar::new(), op, &mut narrow, &a.0, &b.0);
                for (i, narrow) in narrow.into_iter().enumerate() {
                    let mut x = 0.0;
                    let found = op.apply(&(), &mut x, &a.0[i], &b.0[i]);
                    let x = if found.is_ok() { x } else { f64::NAN };
                    for y in [out.0[i], narrow] {
                        let same = x.to_bits() == y.to_bits() || x.is_nan() && y.is_nan();
                        assert!(same, "{op:?} of {} and {}: {x} {y}", a.0[i], b.0[i]);
                    }
                }
            }
        }
    }

    #[test]
    fn lanes_are_numbers_alone() {
        check::<16>(500);
        check::<5>(500);
    }
}
