//! What is counted of a measure over the members of a family: how its values are distributed, in bins.
//!
//! **In:** the values on each member, with their error bounds, in any order. **Out:** how many lie in each bin, the least and the greatest
//! with their members, and quantiles, each between two bounds.
//!
//! **Guaranteed:** as for a [`Tally`](super::Tally), [`Distribution::join`] is associative and commutative, and nothing is lost by it: the
//! edges of the bins are fixed, so that parts are added bin by bin. A quantile lies between its bounds, which hold the width of a
//! bin, 1/128 of a value at most, and the largest error bound. Memory grows with the number of bins that are hit, not with members.
//! These are quantiles of the members, by nearest rank; of motions that are no members nothing is said.
//!
//! **Why bins of this kind** (G. Tene's HdrHistogram; Masson, Rim, Lee, DDSketch, VLDB 2019): the first bits of a binary64 number are
//! its bin, so no logarithm is computed, and every machine has the same edges.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use super::tally::Ranked;

/// So many of the last bits of a number are left out: what is left has 7 binary digits after the first.
const LEFT_OUT: u32 = 45;

/// The quantiles that a report has.
pub const SHARES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];

/// How the values of a measure are distributed over members.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Distribution {
    /// On how many members it was taken.
    pub members: u64,
    /// How many points of a grid, or draws, did not satisfy the constraints.
    pub rejected: u64,
    /// On how many of the members it has no value.
    pub without: u64,
    /// On how many it may have values that were not found, or has one somewhere and none elsewhere.
    pub partial: u64,
    /// The least value, and the first member that has it.
    pub least: Option<Ranked>,
    /// The greatest value, and the first member that has it.
    pub greatest: Option<Ranked>,
    /// The largest error bound of a value.
    #[serde(with = "super::exact")]
    pub bound: f64,
    /// How many values lie in each bin that has any.
    #[serde(with = "super::exact")]
    pub bins: BTreeMap<i64, u64>,
}

/// The bin of a number: increasing with it.
fn bin(x: f64) -> i64 {
    let size = (x.abs().to_bits() >> LEFT_OUT) as i64 + 1;
    if x == 0.0 {
        0
    } else if x < 0.0 {
        -size
    } else {
        size
    }
}

/// The ends of a bin; `None` where it is none of a finite number.
fn ends(bin: i64) -> Option<(f64, f64)> {
    let edge = |n: u64| {
        let bits = n.checked_mul(1 << LEFT_OUT).filter(|bits| *bits <= f64::INFINITY.to_bits())?;
        Some(f64::from_bits(bits))
    };
    let size = bin.unsigned_abs();
    let (low, high) = if size == 0 { (0.0, 0.0) } else { (edge(size - 1)?, edge(size)?) };
    if low.is_infinite() {
        return None;
    }
    Some(if bin < 0 { (-high, -low) } else { (low, high) })
}

/// The one of two that comes first by its measure; of equals the one with the smaller number.
fn leading(a: Option<Ranked>, b: Option<Ranked>, sign: f64) -> Option<Ranked> {
    let order =
        |x: &Ranked, y: &Ranked| (sign * x.measure).total_cmp(&(sign * y.measure)).then(x.number.cmp(&y.number));
    a.into_iter().chain(b).min_by(order)
}

impl Distribution {
    /// Counts a member, by its values with their error bounds; `is_partial` says whether others may be missing.
    pub fn count(&mut self, number: u64, values: impl Iterator<Item = (f64, f64)>, is_partial: bool) {
        self.members += 1;
        let (mut any, mut partial) = (false, is_partial);
        for (value, bound) in values {
            if !value.is_finite() || !bound.is_finite() {
                partial = true;
                continue;
            }
            any = true;
            // There is one zero.
            let one = Some(Ranked { number, measure: if value == 0.0 { 0.0 } else { value } });
            self.least = leading(self.least, one, 1.0);
            self.greatest = leading(self.greatest, one, -1.0);
            self.bound = self.bound.max(bound);
            *self.bins.entry(bin(value)).or_default() += 1;
        }
        self.without += u64::from(!any);
        self.partial += u64::from(any && partial);
    }

    /// Adds what was counted of other members.
    pub fn join(&mut self, other: &Distribution) {
        let Distribution { members, rejected, without, partial, least, greatest, bound, bins } = other;
        let counts = [
            (&mut self.members, members),
            (&mut self.rejected, rejected),
            (&mut self.without, without),
            (&mut self.partial, partial),
        ];
        counts.into_iter().for_each(|(here, there)| *here = here.saturating_add(*there));
        self.least = leading(self.least, *least, 1.0);
        self.greatest = leading(self.greatest, *greatest, -1.0);
        self.bound = self.bound.max(*bound);
        for (bin, count) in bins {
            let here = self.bins.entry(*bin).or_default();
            *here = here.saturating_add(*count);
        }
    }

    /// How many values there are.
    pub fn values(&self) -> u64 {
        self.bins.values().fold(0, |sum: u64, n| sum.saturating_add(*n))
    }

    /// Between which two numbers a quantile lies: of n values the one of rank ⌈share·n⌉ from below. `None` without values.
    pub fn quantile(&self, share: f64) -> Option<(f64, f64)> {
        let (least, greatest) = (self.least?.measure, self.greatest?.measure);
        let count = self.values();
        let rank = ((share * count as f64).ceil() as u64).clamp(1, count);
        let mut below = 0_u64;
        let bin = self.bins.iter().find_map(|(bin, n)| {
            below = below.saturating_add(*n);
            (below >= rank).then_some(*bin)
        })?;
        let (low, high) = ends(bin)?;
        // Values are off by their errors, and so are quantiles, by the largest of them at most.
        Some((low.max(least) - self.bound, high.min(greatest) + self.bound))
    }

    /// What cannot be so of a distribution over these numbers; `again` says whether draws are repeated until there is a member.
    pub fn fault(&self, numbers: &RangeInclusive<u64>, again: bool) -> Option<&'static str> {
        let size = numbers.end().saturating_sub(*numbers.start()).saturating_add(1);
        let looked_at = if again { Some(self.members) } else { self.members.checked_add(self.rejected) };
        let with = self.members.checked_sub(self.without);
        let sum = self.bins.values().try_fold(0_u64, |sum, n| sum.checked_add(*n));
        let bin_of = |r: Option<Ranked>| r.map(|r| bin(r.measure));
        let outermost = [self.bins.keys().next(), self.bins.keys().next_back()].map(Option::<&i64>::copied);
        if looked_at != Some(size) {
            Some("it does not count every number")
        } else if with
            .is_none_or(|with| with < self.partial || sum.is_none_or(|sum| sum < with || (with == 0) != (sum == 0)))
        {
            Some("its counts do not add up")
        } else if outermost != [bin_of(self.least), bin_of(self.greatest)]
            || self.bins.iter().any(|(bin, n)| *n == 0 || ends(*bin).is_none())
        {
            Some("its bins are not those of its values")
        } else if self.kept().any(|n| !numbers.contains(&n)) {
            Some("it names members of another part")
        } else if !self.bound.is_finite() || self.bound < 0.0 {
            // With an infinite one every quantile would be anything.
            Some("its error bound is none")
        } else {
            None
        }
    }

    /// The numbers of the members that are kept.
    pub fn kept(&self) -> impl Iterator<Item = u64> {
        [self.least, self.greatest].into_iter().flatten().map(|r| r.number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use number::Draws;

    #[test]
    fn every_number_lies_in_its_bin_and_bins_are_narrow() {
        let mut draws = Draws::new(3);
        let mut all: Vec<f64> = vec![0.0, -0.0, 1.0, -1.0, f64::MIN_POSITIVE, 5e-324, f64::MAX, f64::MIN, 1.0078125];
        all.extend((0..2000).map(|_| f64::from_bits(draws.bits())).filter(|x| x.is_finite()));
        for x in &all {
            let (low, high) = ends(bin(*x)).expect("a bin");
            assert!(low <= *x && *x <= high, "{x:e} {low:e} {high:e}");
            assert!(
                x.abs() < 1e-300 || high.is_infinite() || low.is_infinite() || high - low <= x.abs() / 127.0,
                "{x:e}"
            );
        }
        all.sort_by(f64::total_cmp);
        assert!(all.windows(2).all(|w| bin(w[0]) <= bin(w[1])));
        assert_eq!(ends(bin(f64::INFINITY)), None);
        assert_eq!(ends(i64::MIN), None);
    }

    /// Some values of a member; small whole numbers too, so that there are ties.
    fn values(draws: &mut Draws) -> Vec<(f64, f64)> {
        (0..draws.bits() % 3)
            .map(|_| match draws.bits() % 8 {
                0 => (f64::NAN, 0.0),
                1 => (-0.0, 1e-12),
                2 => ((draws.bits() % 4) as f64, 0.0),
                _ => ((draws.bits() % 100_000) as f64 / 1000.0 - 30.0, 1e-9),
            })
            .collect()
    }

    #[test]
    fn an_error_bound_that_says_nothing_is_refused() {
        let mut one = Distribution::default();
        one.count(0, [(1.0, 0.5)].into_iter(), false);
        assert_eq!(one.fault(&(0..=0), false), None);
        for bound in [f64::INFINITY, f64::NAN, -1.0] {
            let fault = Distribution { bound, ..one.clone() }.fault(&(0..=0), false);
            assert_eq!(fault, Some("its error bound is none"));
        }
    }

    #[test]
    fn any_partition_in_any_order_gives_the_same_and_quantiles_lie_between_their_bounds() {
        let mut draws = Draws::new(5);
        for round in 0..300_u64 {
            let size = 1 + draws.bits() % 60;
            let all: Vec<Vec<(f64, f64)>> = (0..size).map(|_| values(&mut draws)).collect();
            let mut whole = Distribution::default();
            let mut parts = vec![Distribution::default(); 1 + (draws.bits() % 5) as usize];
            for (at, of) in all.iter().enumerate() {
                whole.count(at as u64 + 1, of.iter().copied(), false);
            }
            for at in (0..all.len()).rev() {
                let n = (draws.bits() % parts.len() as u64) as usize;
                parts[n].count(at as u64 + 1, all[at].iter().copied(), false);
            }
            let mut joined = parts.pop().expect("a part");
            while let Some(part) = parts.pop() {
                if draws.bits() & 1 == 0 {
                    joined.join(&part);
                } else {
                    let mut other = part;
                    other.join(&joined);
                    joined = other;
                }
            }
            assert_eq!(joined, whole, "round {round}");
            assert_eq!(whole.fault(&(1..=size), false), None, "{whole:?}");
            let mut plain: Vec<f64> = all.iter().flatten().map(|v| v.0).filter(|x| x.is_finite()).collect();
            plain.sort_by(f64::total_cmp);
            assert_eq!(whole.values(), plain.len() as u64);
            for share in [0.0, 0.05, 0.25, 0.5, 0.95, 1.0] {
                let Some((low, high)) = whole.quantile(share) else {
                    assert!(plain.is_empty());
                    continue;
                };
                let exact = plain[((share * plain.len() as f64).ceil() as usize).max(1) - 1];
                assert!(low <= exact && exact <= high, "{share}: {low} {exact} {high}");
                assert!(high - low <= exact.abs() / 127.0 + 3e-9, "{share}: {low} {exact} {high}");
            }
        }
    }

    #[test]
    fn a_distribution_that_cannot_be_is_seen() {
        let mut good = Distribution { rejected: 1, ..Distribution::default() };
        good.count(5, [(1.0, 0.0)].into_iter(), false);
        good.count(6, [].into_iter(), true);
        good.count(7, [(3.0, 0.1), (4.0, 0.2)].into_iter(), true);
        assert_eq!((good.members, good.without, good.partial, good.values()), (3, 1, 1, 3));
        let numbers = 5..=8;
        assert_eq!(good.fault(&numbers, false), None);
        let bad = [
            Distribution { members: 4, ..good.clone() },
            Distribution { rejected: u64::MAX, ..good.clone() },
            Distribution { without: 4, ..good.clone() },
            Distribution { without: 3, partial: 0, ..good.clone() },
            Distribution { partial: 3, ..good.clone() },
            Distribution { least: None, ..good.clone() },
            Distribution { least: Some(Ranked { number: 5, measure: 1.5 }), ..good.clone() },
            Distribution { greatest: Some(Ranked { number: 9, measure: 4.0 }), ..good.clone() },
            Distribution { bound: f64::NAN, ..good.clone() },
            Distribution { bound: -1.0, ..good.clone() },
            Distribution { bins: BTreeMap::new(), ..good.clone() },
        ];
        for of in bad {
            assert!(of.fault(&numbers, false).is_some(), "{of:?}");
        }
        let mut more = good.clone();
        more.bins.insert(bin(2.0), 0);
        assert!(more.fault(&numbers, false).is_some());
        more.bins.insert(bin(2.0), u64::MAX);
        assert!(more.fault(&numbers, false).is_some());
    }
}
