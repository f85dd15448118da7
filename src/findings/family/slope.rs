//! The slope of a scaling law over a whole family: least squares of the differences between members.
//!
//! **In:** of pairs of members that follow one another how much ln|of| rises while ln|with| runs, with an error bound. **Out:** sums, and
//! from these [`SlopeAccount`]: the slope that fits all pairs best, its standard error, and the least and the greatest slope.
//!
//! **Guaranteed:** the sums are integers, and of slopes the extremes are kept; so [`Slopes::join`] is associative and commutative to the
//! last bit, as that of every tally is, and takes the same memory for any number of members.
//!
//! **Why differences:** members that differ in something else as well lie on lines of one slope and of different heights. The
//! heights cancel in differences (econometrics calls this the first-difference estimator), so none of them need be known.

use serde::{Deserialize, Serialize};
use verdict::Rise;

/// Logarithms are counted in units of 2⁻³²: those of binary64 then have 42 bits, products 84, and sums of 10⁹ of these 114.
const UNIT: f64 = 1.0 / 4_294_967_296.0;

/// Sums over pairs of members.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Slopes {
    /// How many pairs.
    pub pairs: u64,
    /// Σ run², Σ run·rise, Σ rise², in units of 2⁻⁶⁴.
    #[serde(with = "super::exact")]
    pub sums: [i128; 3],
    /// Σ |run|·error of the rise, and Σ |run|, each rounded up, in units of 2⁻⁶⁴ and 2⁻³².
    #[serde(with = "super::exact")]
    pub errors: [i128; 2],
    /// The least and the greatest slope of the pairs that begin in each cell of what varies.
    #[serde(with = "super::exact")]
    pub cells: Vec<Option<(f64, f64)>>,
}

/// What is said of a scaling law over a whole family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SlopeAccount {
    /// How many pairs of members.
    pub pairs: u64,
    /// The slope that fits them best.
    pub slope: f64,
    /// Its standard error, where there are more pairs than one.
    pub standard_error: Option<f64>,
    /// By how much errors of the quantities may have moved it.
    pub bound: f64,
    /// The least slope of a pair.
    pub least: f64,
    /// The greatest one.
    pub greatest: f64,
    /// The power that is claimed.
    pub power: f64,
    /// How far it may be off.
    pub to: f64,
    /// Whether the claimed power is nearer to the slope than two standard errors and the error bound.
    pub contains: bool,
    /// What varies, in LaTeX.
    pub with: String,
    /// The cells that have pairs.
    pub cells: Vec<SlopeCell>,
}

/// Pairs of members that begin in one cell of what varies.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SlopeCell {
    /// What varies, in the middle of it.
    pub value: f64,
    /// The logarithm of its size.
    pub logarithm: f64,
    /// The least slope of a pair.
    pub least: f64,
    /// The greatest one.
    pub greatest: f64,
}

/// The whole product of two numbers: its upper half, and its lower half.
fn product(a: u128, b: u128) -> (u128, u128) {
    const LOW: u128 = u64::MAX as u128;
    let (a1, a0, b1, b0) = (a >> 64, a & LOW, b >> 64, b & LOW);
    let (outer, inner, low) = (a1 * b0, a0 * b1, a0 * b0);
    let middle = (low >> 64) + (outer & LOW) + (inner & LOW);
    (a1 * b1 + (outer >> 64) + (inner >> 64) + (middle >> 64), (middle << 64) | (low & LOW))
}

impl Slopes {
    /// Whether there is nothing.
    pub(super) fn is_none(&self) -> bool {
        *self == Slopes::default()
    }

    /// None yet, in so many cells.
    pub fn empty(cells: usize) -> Slopes {
        Slopes { cells: vec![None; cells], ..Slopes::default() }
    }

    /// Counts a pair that begins in a cell.
    pub fn count(&mut self, cell: usize, rise: &Rise) {
        let whole = |x: f64| (x / UNIT).round() as i128;
        let (run, up) = (whole(rise.run), whole(rise.rise));
        if run == 0 {
            return;
        }
        self.pairs += 1;
        let error = (rise.error / UNIT).ceil() as i128;
        let added = [run.saturating_mul(run), run.saturating_mul(up), up.saturating_mul(up)];
        self.sums.iter_mut().zip(added).for_each(|(sum, x)| *sum = sum.saturating_add(x));
        let added = [run.abs().saturating_mul(error), run.abs()];
        self.errors.iter_mut().zip(added).for_each(|(sum, x)| *sum = sum.saturating_add(x));
        let slope = rise.rise / rise.run;
        if let Some(of) = self.cells.get_mut(cell) {
            let (least, greatest) = of.unwrap_or((slope, slope));
            *of = Some((least.min(slope), greatest.max(slope)));
        }
    }

    /// Adds what was counted of other pairs.
    pub fn join(&mut self, other: &Slopes) {
        self.pairs = self.pairs.saturating_add(other.pairs);
        self.sums.iter_mut().zip(other.sums).for_each(|(sum, x)| *sum = sum.saturating_add(x));
        self.errors.iter_mut().zip(other.errors).for_each(|(sum, x)| *sum = sum.saturating_add(x));
        self.cells.resize(self.cells.len().max(other.cells.len()), None);
        for (here, there) in self.cells.iter_mut().zip(&other.cells) {
            let both = here.iter().chain(there).copied();
            *here = both.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
        }
    }

    /// What the sums say; `middles` are those of the cells, with the logarithms of their sizes. `None` without pairs.
    pub fn account(&self, with: &str, middles: &[(f64, f64)], (power, to): (f64, f64)) -> Option<SlopeAccount> {
        let [run_run, run_rise, rise_rise] = self.sums;
        if self.pairs == 0 || run_run <= 0 {
            return None;
        }
        let slope = run_rise as f64 / run_run as f64;
        // Σ (rise − slope·run)² = (Σ rise² Σ run² − (Σ run·rise)²)/Σ run²; the difference is of whole numbers.
        let (all, fitted) = (
            product(run_run.unsigned_abs(), rise_rise.unsigned_abs()),
            product(run_rise.unsigned_abs(), run_rise.unsigned_abs()),
        );
        let (low, borrow) = all.1.overflowing_sub(fitted.1);
        let high = all.0.saturating_sub(fitted.0).saturating_sub(u128::from(borrow));
        let left = (high as f64 * (2.0 * (1_u128 << 127) as f64) + low as f64) / run_run as f64;
        let standard_error = (self.pairs > 1).then(|| (left / (self.pairs - 1) as f64 / run_run as f64).sqrt());
        let [errors, runs] = self.errors;
        // What rounding to whole units leaves.
        let rounding = 0.5 * (1.0 + slope.abs()) * runs as f64;
        let bound = (errors as f64 + rounding) / run_run as f64;
        let seen = self.cells.iter().zip(middles).filter_map(|(of, &(value, logarithm))| {
            of.map(|(least, greatest)| SlopeCell { value, logarithm, least, greatest })
        });
        let cells: Vec<SlopeCell> = seen.collect();
        Some(SlopeAccount {
            pairs: self.pairs,
            slope,
            standard_error,
            bound,
            least: cells.iter().map(|c| c.least).fold(f64::INFINITY, f64::min),
            greatest: cells.iter().map(|c| c.greatest).fold(f64::NEG_INFINITY, f64::max),
            power,
            to,
            contains: (slope - power).abs() <= 2.0 * standard_error.unwrap_or(0.0) + bound,
            with: with.to_owned(),
            cells,
        })
    }

    /// What cannot be so of the slopes of so many members.
    pub fn fault(&self, members: u64) -> bool {
        let extremes = self.cells.iter().flatten();
        self.pairs > members
            || self.sums[0] < 0
            || self.sums[2] < 0
            || self.errors.iter().any(|e| *e < 0)
            || extremes.clone().any(|(least, greatest)| !matches!(least.partial_cmp(greatest), Some(o) if o.is_le()))
            || (extremes.count() as u64) > self.pairs
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use number::Draws;

    fn account(slopes: &Slopes) -> SlopeAccount {
        slopes.account("x", &[(1.0, 0.0), (2.0, 0.7), (3.0, 1.1)], (2.0, 0.1)).expect("pairs")
    }

    #[test]
    fn a_power_law_has_its_power_and_no_error() {
        let mut slopes = Slopes::empty(3);
        for k in 1..30 {
            let run = 0.1 / f64::from(k);
            slopes.count(k as usize % 3, &Rise { run, rise: 2.0 * run, error: 0.0 });
        }
        let found = account(&slopes);
        // Logarithms are counted in units of 2⁻³², beside runs of 0.1/k.
        assert!(
            (found.slope - 2.0).abs() <= found.bound && found.standard_error.is_some_and(|s| s < 1e-8),
            "{found:?}"
        );
        assert!(found.contains && found.bound > 0.0 && found.bound < 1e-7, "{found:?}");
        assert_eq!((found.cells.len(), found.pairs), (3, 29));
    }

    #[test]
    fn least_squares_are_those_of_the_textbook() {
        // y = 1, 3, 5 at x = 1, 2, 2 through the origin: slope (1 + 6 + 10)/9, residuals −8/9, −7/9, 11/9.
        let mut slopes = Slopes::empty(1);
        for (run, rise) in [(1.0, 1.0), (2.0, 3.0), (2.0, 5.0)] {
            slopes.count(0, &Rise { run, rise, error: 0.125 });
        }
        let found = account(&slopes);
        assert_eq!(found.slope, 17.0 / 9.0);
        let expected = ((64.0_f64 + 49.0 + 121.0) / 81.0 / 2.0 / 9.0).sqrt();
        assert!((found.standard_error.expect("pairs") - expected).abs() < 1e-12, "{found:?} {expected}");
        assert!((found.bound - 0.125 * 5.0 / 9.0).abs() < 1e-9);
        assert_eq!((found.least, found.greatest), (1.0, 2.5));
        assert!(found.contains);
        let far = slopes.account("x", &[(1.0, 0.0)], (3.0, 0.1)).expect("pairs");
        assert!(!far.contains);
        assert_eq!(Slopes::empty(3).account("x", &[(1.0, 0.0)], (3.0, 0.1)), None);
    }

    #[test]
    fn the_order_of_pairs_and_of_parts_does_not_matter() {
        let mut draws = Draws::new(3);
        let mut number = || (draws.bits() % 2_000_001) as f64 / 1e6 - 1.0;
        let rises: Vec<Rise> =
            (0..200).map(|_| Rise { run: number(), rise: 700.0 * number(), error: number().abs() }).collect();
        let counted = |of: &mut dyn Iterator<Item = &Rise>| {
            let mut out = Slopes::empty(3);
            of.for_each(|r| out.count(((r.run.abs() * 2.9) as usize).min(2), r));
            out
        };
        let whole = counted(&mut rises.iter());
        for parts in [2, 3, 7] {
            let mut joined = Slopes::default();
            for part in (0..parts).rev() {
                joined.join(&counted(&mut rises.iter().skip(part).step_by(parts)));
            }
            assert_eq!(joined, whole);
        }
        assert!(!whole.fault(200) && whole.fault(199));
    }

    #[test]
    fn long_products_are_whole() {
        assert_eq!(product(u128::MAX, u128::MAX), (u128::MAX - 1, 1));
        assert_eq!(product(1 << 100, 1 << 100), (1 << 72, 0));
        assert_eq!(product(u128::from(u64::MAX), 3), (0, 3 * u128::from(u64::MAX)));
    }
}
