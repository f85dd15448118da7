//! What is drawn: shares of 1, and the values at them.
//!
//! **In:** the seed of a family, the number of a member, and which of its values. **Out:** a share from 0 to 1, random or the coordinate
//! of a point of a sequence that fills space evenly; and the value that has this share of a distribution below it.
//!
//! **Guaranteed:** the same on every machine. Random shares are a hash; those of a sequence come from whole numbers alone; values come
//! from the operations of IEEE 754 and from the elementary functions that are compiled into the program.
//!
//! **How the sequence goes.** The n-th point has the coordinates s_k + n a_k, without whole parts: a Kronecker sequence, in which a_k is
//! the k-th power of 1/φ, and φ the root of φ^(d+1) = φ + 1 above 1, for d coordinates (M. Roberts, *The unreasonable effectiveness
//! of quasirandom sequences*, 2018). For d = 1 that is the golden ratio, whose multiples are the most evenly spread of all. The shifts
//! s_k come from the seed (R. Cranley, T. N. L. Patterson, SIAM J. Numer. Anal. 13, 1976). Why not one of Sobol's: this needs no table, has
//! any number of coordinates, and any run of its points is spread as evenly as the first ones, so that parts of a family are, too.

use crate::number::{Draws, Number};

/// The natural logarithm, the same on every machine; not a number where there is none.
pub(super) fn ln(x: f64) -> f64 {
    let mut out = 0.0_f64;
    Number::ln(&mut out, &(), &x).map_or(f64::NAN, |()| out)
}

/// The exponential, the same on every machine; infinite where it is too large.
pub(super) fn exp(x: f64) -> f64 {
    let mut out = 0.0_f64;
    Number::exp(&mut out, &(), &x).map_or(f64::INFINITY, |()| out)
}

fn cos(x: f64) -> f64 {
    let mut out = 0.0_f64;
    Number::cos(&mut out, &(), &x).map_or(f64::NAN, |()| out)
}

fn arccos(x: f64) -> f64 {
    let mut out = 0.0_f64;
    Number::arccos(&mut out, &(), &x).map_or(f64::NAN, |()| out)
}

/// The random shares of one value: a hash of the seed, the number of the member, the attempt, and which value it is.
pub(super) struct Random(Draws);

/// One word more in a hash.
fn mixed(state: u64, word: u64) -> u64 {
    Draws::new(state ^ word).bits()
}

impl Random {
    pub fn new(seed: u64, number: u64, attempt: u64, position: u64) -> Random {
        Random(Draws::new([number, attempt, position].into_iter().fold(mixed(0, seed), mixed)))
    }

    /// A number from 0 to below 1, a multiple of 2⁻⁵³.
    pub fn share(&mut self) -> f64 {
        (self.0.bits() >> 11) as f64 * (f64::EPSILON / 2.0)
    }
}

/// A random value of the standard normal distribution (Box and Muller).
pub(super) fn random_normal(random: &mut Random) -> f64 {
    // 1 − share is above 0.
    let (radius, turn) = ((-2.0 * ln(1.0 - random.share())).sqrt(), random.share());
    radius * cos(2.0 * std::f64::consts::PI * turn)
}

/// The points of a sequence of low discrepancy, from their numbers. Coordinates are multiples of 2⁻⁶⁴.
pub(super) struct Sequence {
    /// Where each coordinate begins, and by how much it goes on.
    coordinates: Vec<(u64, u64)>,
}

/// The product of two fractions of 2⁶⁴.
fn times(a: u64, b: u64) -> u64 {
    ((u128::from(a) * u128::from(b)) >> 64) as u64
}

impl Sequence {
    /// The sequence with so many coordinates.
    pub fn new(dimension: usize, seed: u64) -> Sequence {
        let power = |x: u64| (1..dimension).fold(x, |y, _| times(y, x));
        // The root of x^d + x^(d+1) = 1 between 0 and 1, bit by bit: 1/φ.
        let mut root = 0_u64;
        for bit in (0..64).rev() {
            let x = root | 1 << bit;
            let low = power(x);
            if low.checked_add(times(low, x)).is_some() {
                root = x;
            }
        }
        let steps = std::iter::successors(Some(root), |step| Some(times(*step, root)));
        let shifts = (0..dimension as u64).map(|k| mixed(mixed(0, seed), k));
        Sequence { coordinates: shifts.zip(steps).collect() }
    }

    /// A coordinate of a point: above 0 and below 1, an odd multiple of 2⁻⁵³.
    pub fn share(&self, coordinate: usize, number: u64) -> f64 {
        let Some((shift, step)) = self.coordinates.get(coordinate) else { return f64::NAN };
        let bits = shift.wrapping_add(number.wrapping_mul(*step));
        ((bits >> 12) as f64 + 0.5) * f64::EPSILON
    }
}

/// The angle up to which a share of the surface of a sphere lies, between two circles of latitude.
pub(super) fn polar_at(share: f64, (from, to): (f64, f64)) -> f64 {
    arccos(((1.0 - share) * cos(from) + share * cos(to)).clamp(-1.0, 1.0))
}

/// A polynomial, its constant term last.
fn polynomial(x: f64, coefficients: [f64; 8]) -> f64 {
    coefficients.into_iter().fold(0.0, |sum, c| sum * x + c)
}

/// The value below which a share of the standard normal distribution lies, to 15 digits (M. J. Wichura, algorithm AS 241, Appl. Statist.
/// 37, 1988).
pub(super) fn normal_at(share: f64) -> f64 {
    let q = share - 0.5;
    if q.abs() <= 0.425 {
        let r = 0.180625 - q * q;
        return q * polynomial(r, MIDDLE[0]) / polynomial(r, MIDDLE[1]);
    }
    let r = (-ln(share.min(1.0 - share))).sqrt();
    let x = if r <= 5.0 {
        polynomial(r - 1.6, TAIL[0]) / polynomial(r - 1.6, TAIL[1])
    } else {
        polynomial(r - 5.0, FAR[0]) / polynomial(r - 5.0, FAR[1])
    };
    if q < 0.0 { -x } else { x }
}

/// Wichura's coefficients for shares from 0.075 to 0.925: numerator and denominator.
const MIDDLE: [[f64; 8]; 2] = [
    [
        2_509.080_928_730_122_7,
        33_430.575_583_588_13,
        67_265.770_927_008_7,
        45_921.953_931_549_87,
        13_731.693_765_509_46,
        1_971.590_950_306_551_3,
        133.141_667_891_784_38,
        3.387_132_872_796_366_5,
    ],
    [
        5_226.495_278_852_854,
        28_729.085_735_721_943,
        39_307.895_800_092_71,
        21_213.794_301_586_597,
        5_394.196_021_424_751,
        687.187_007_492_057_9,
        42.313_330_701_600_91,
        1.0,
    ],
];
/// For those nearer to an end.
const TAIL: [[f64; 8]; 2] = [
    [
        0.000_774_545_014_278_341_4,
        0.022_723_844_989_269_184,
        0.241_780_725_177_450_6,
        1.270_458_252_452_368_4,
        3.647_848_324_763_204_5,
        5.769_497_221_460_691,
        4.630_337_846_156_546,
        1.423_437_110_749_683_5,
    ],
    [
        1.050_750_071_644_416_9e-9,
        0.000_547_593_808_499_534_5,
        0.015_198_666_563_616_457,
        0.148_103_976_427_480_08,
        0.689_767_334_985_1,
        1.676_384_830_183_803_8,
        2.053_191_626_637_759,
        1.0,
    ],
];
/// For those within e⁻²⁵ of an end.
const FAR: [[f64; 8]; 2] = [
    [
        2.010_334_399_292_288_1e-7,
        2.711_555_568_743_487_6e-5,
        0.001_242_660_947_388_078_4,
        0.026_532_189_526_576_124,
        0.296_560_571_828_504_87,
        1.784_826_539_917_291_3,
        5.463_784_911_164_114,
        6.657_904_643_501_103,
    ],
    [
        2.044_263_103_389_939_7e-15,
        1.421_511_758_316_446e-7,
        1.846_318_317_510_054_8e-5,
        0.000_786_869_131_145_613_3,
        0.014_875_361_290_850_615,
        0.136_929_880_922_735_8,
        0.599_832_206_555_888,
        1.0,
    ],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_are_those_of_every_machine() {
        let mut draw = Random::new(7, 1, 0, 0);
        let found: Vec<f64> = (0..2).map(|_| draw.share()).collect();
        let mut again = Random::new(7, 1, 0, 0);
        assert_eq!(found, [again.share(), again.share()]);
        assert_ne!(Random::new(7, 2, 0, 0).share(), found[0]);
        assert_ne!(Random::new(7, 1, 1, 0).share(), found[0]);
        assert_ne!(Random::new(7, 1, 0, 1).share(), found[0]);
        assert_ne!(Random::new(8, 1, 0, 0).share(), found[0]);
    }

    #[test]
    fn shares_fill_the_range_evenly() {
        let n = 20_000;
        let all: Vec<f64> = (1..=n).map(|number| Random::new(3, number, 0, 0).share()).collect();
        assert!(all.iter().all(|x| (0.0..1.0).contains(x)));
        let mean = all.iter().sum::<f64>() / n as f64;
        let square = all.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / n as f64;
        // Four standard errors.
        assert!((mean - 0.5).abs() < 4.0 * (1.0 / 12.0 / n as f64).sqrt(), "{mean}");
        assert!((square - 1.0 / 12.0).abs() < 0.002, "{square}");
        for tenth in 0..10 {
            let here = all.iter().filter(|x| (**x * 10.0) as usize == tenth).count();
            assert!((here as f64 - 2000.0).abs() < 200.0, "{tenth}: {here}");
        }
    }

    /// Computed with 400 bits by a program in Python: coordinates, seed, number, shares.
    const POINTS: [(u64, u64, &[f64]); 6] = [
        (7, 1, &[0.339_542_169_354_865_2]),
        (7, 1_000_000_000, &[0.471_403_028_809_557_15]),
        (7, 2, &[0.231_263_513_098_355_86, 0.378_965_054_853_381_33]),
        (7, 1_000_000_000, &[0.968_200_940_654_479_3, 0.237_337_738_768_674_78]),
        (0, 1, &[0.471_620_999_770_196_7, 0.705_055_308_008_135_7, 0.392_665_988_808_053_37]),
        (0, 1000, &[0.824_961_882_538_472, 0.077_618_405_093_554_87, 0.543_443_412_876_35]),
    ];

    #[test]
    fn points_of_the_sequence_are_those_of_exact_arithmetic() {
        for (seed, number, shares) in POINTS {
            let sequence = Sequence::new(shares.len(), seed);
            for (k, share) in shares.iter().enumerate() {
                let found = sequence.share(k, number);
                // Steps are off by a few units of 2⁻⁶⁴, shares by their rounding.
                assert!((found - share).abs() < 1e-18 * number as f64 + 1e-15, "{number} {k}: {found} {share}");
            }
        }
        assert!(Sequence::new(1, 3).share(1, 1).is_nan());
    }

    /// The largest distance between the share of points in a box with a corner at 0 and its volume, over some boxes.
    fn discrepancy(points: &[[f64; 2]]) -> f64 {
        let ends = || (1..=40).map(|k| f64::from(k) / 40.0);
        let of = |x: f64, y: f64| {
            let inside = points.iter().filter(|p| p[0] < x && p[1] < y).count();
            (inside as f64 / points.len() as f64 - x * y).abs()
        };
        ends().flat_map(|x| ends().map(move |y| of(x, y))).fold(0.0, f64::max)
    }

    #[test]
    fn the_sequence_fills_the_square_more_evenly_than_random_draws() {
        let n = 1000;
        let sequence = Sequence::new(2, 5);
        let even: Vec<[f64; 2]> = (1..=n).map(|i| [sequence.share(0, i), sequence.share(1, i)]).collect();
        let later: Vec<[f64; 2]> =
            (1..=n).map(|i| [sequence.share(0, i + 777_777), sequence.share(1, i + 777_777)]).collect();
        let one = |i: u64, k: u64| Random::new(5, i, 0, k).share();
        let random: Vec<[f64; 2]> = (1..=n).map(|i| [one(i, 0), one(i, 1)]).collect();
        // Of random draws about 1/√n; of the sequence about (ln n)²/n at most.
        let found = [discrepancy(&even), discrepancy(&later), discrepancy(&random)];
        assert!(found[0] < 0.008 && found[1] < 0.008 && found[2] > 0.015, "{found:?}");
        // On a line the gaps between n points have three lengths at most, and none is twice its share.
        let sequence = Sequence::new(1, 1);
        let mut line: Vec<f64> = (1..=n).map(|i| sequence.share(0, i)).collect();
        line.sort_by(f64::total_cmp);
        assert!(line.windows(2).all(|w| w[1] - w[0] < 2.0 / n as f64 && w[1] > w[0]));
    }

    #[test]
    fn a_share_of_the_normal_distribution_lies_below_its_quantile() {
        // Computed with 200 bits.
        let known = [
            (1e-300, -37.047_096_299_361_2),
            (1e-16, -8.222_082_216_130_436),
            (1e-5, -4.264_890_793_922_825),
            (0.02, -2.053_748_910_631_823),
            (0.07, -1.475_791_028_179_170_7),
            (0.3, -0.524_400_512_708_040_8),
            (0.5, 0.0),
            (0.9, 1.281_551_565_544_600_6),
            (0.999, 3.090_232_306_167_813),
        ];
        for (share, x) in known {
            let found = normal_at(share);
            assert!((found - x).abs() <= 1e-15 * x.abs().max(0.1) * 4.0, "{share}: {found} {x}");
        }
    }

    #[test]
    fn polar_angles_have_their_share_of_the_sphere() {
        let pi = std::f64::consts::PI;
        for (share, angle) in [(0.0, 0.0), (0.25, pi / 3.0), (0.5, pi / 2.0), (1.0, pi)] {
            assert!((polar_at(share, (0.0, pi)) - angle).abs() < 1e-15, "{share}");
        }
        // Half of what lies within 60° of the pole.
        assert!((polar_at(0.5, (0.0, pi / 3.0)) - arccos(0.75)).abs() < 1e-15);
    }
}
