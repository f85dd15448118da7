//! What is counted of a claim, member by member: a value that can be joined with that of other members.
//!
//! **In:** the number of a member and its verdict, in any order. **Out:** counts, and the numbers of the members that tell most.
//!
//! **Guaranteed:** [`Tally::join`] is associative and commutative, and an empty tally is its neutral element: however numbers are
//! dealt out to machines, and in whatever order their tallies are joined, the result is the same. So a tally has counts and
//! numbers alone, of which the smallest or the largest are kept; the number of a member determines it, so that its values and
//! its verdict are found again where they are wanted. It takes the same memory for any number of members.

use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

use super::slope::Slopes;
use verdict::{Outcome, Verdict};

/// A member, and by how much it tells.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ranked {
    /// Its number.
    pub number: u64,
    /// The measure: of failing members how far the sides are apart, of those that hold how close they come.
    #[serde(with = "super::exact")]
    pub measure: f64,
}

/// How many members there are of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// How many members were tried.
    pub members: u64,
    /// How many points of a grid, or draws, did not satisfy the constraints.
    pub rejected: u64,
    /// On how many it holds.
    pub holds: u64,
    /// On how many it fails.
    pub fails: u64,
    /// To how many it does not apply.
    pub not_applicable: u64,
    /// On how many it is undecided.
    pub undecided: u64,
}

impl Counts {
    /// Adds those of other members.
    fn join(&mut self, other: &Counts) {
        let Counts { members, rejected, holds, fails, not_applicable, undecided } = other;
        let both = [
            (&mut self.members, members),
            (&mut self.rejected, rejected),
            (&mut self.holds, holds),
            (&mut self.fails, fails),
            (&mut self.not_applicable, not_applicable),
            (&mut self.undecided, undecided),
        ];
        both.into_iter().for_each(|(here, there)| *here = here.saturating_add(*there));
    }
}

/// What is counted of one claim.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Tally {
    /// The counts.
    #[serde(flatten)]
    pub counts: Counts,
    /// The failing member with the smallest number.
    pub first_failing: Option<u64>,
    /// The failing member with the largest measure; of equals the one with the smallest number.
    pub clearest_failing: Option<Ranked>,
    /// The member with the smallest measure of those on which an inequality holds; of equals the one with the smallest number.
    pub closest_call: Option<Ranked>,
    /// The undecided member with the smallest number.
    pub first_undecided: Option<u64>,
    /// The member with the smallest number on which the program contradicts itself.
    pub first_defect: Option<u64>,
    /// On how many members of each cell of the family's map it holds, fails, does not apply, is undecided; nothing without a map.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub map: Vec<[u64; 4]>,
    /// The slopes of a scaling law; nothing of other claims.
    #[serde(default, skip_serializing_if = "Slopes::is_none")]
    pub slopes: Slopes,
}

/// How far the sides of a refuting point are apart, in units of the error bound of their difference. Rounding alone is an error.
pub fn deviation(verdict: &Verdict) -> f64 {
    let Some(w) = &verdict.evidence().witness else { return -1.0 };
    let rounding = f64::EPSILON * (w.left.abs() + w.right.abs());
    let found = w.difference() / w.bound.max(rounding).max(f64::MIN_POSITIVE);
    if found.is_nan() { 0.0 } else { found }
}

/// How close the sides of an inequality come, in units of the size of their terms, at the samples that are kept.
pub fn gap(verdict: &Verdict, precision: f64) -> Option<f64> {
    let series = verdict.evidence().series.as_ref().filter(|s| !s.equation && !s.sought)?;
    let gaps = series.points.iter().filter(|p| p.limit > 0.0).map(|p| p.residual / (p.limit / precision));
    gaps.reduce(f64::min).filter(|gap| gap.is_finite())
}

/// The smaller of two numbers, where there are two.
fn first(a: Option<u64>, b: Option<u64>) -> Option<u64> {
    a.into_iter().chain(b).min()
}

/// The one whose measure comes first; of equals the one with the smaller number.
fn leading(a: Option<Ranked>, b: Option<Ranked>, rank: impl Fn(f64) -> f64) -> Option<Ranked> {
    let order = |x: &Ranked, y: &Ranked| rank(x.measure).total_cmp(&rank(y.measure)).then(x.number.cmp(&y.number));
    a.into_iter().chain(b).min_by(order)
}

impl Tally {
    /// Counts a member; `precision` is what the claim asks for.
    pub fn count(&mut self, number: u64, verdict: &Verdict, precision: f64) {
        self.counts.members += 1;
        if verdict.defect().is_some() {
            self.first_defect = first(self.first_defect, Some(number));
        }
        match verdict.outcome() {
            Outcome::Holds(_) => {
                self.counts.holds += 1;
                let one = gap(verdict, precision).map(|measure| Ranked { number, measure });
                self.closest_call = leading(self.closest_call, one, |x| x);
            }
            Outcome::Fails(_) => {
                self.counts.fails += 1;
                self.first_failing = first(self.first_failing, Some(number));
                let one = Ranked { number, measure: deviation(verdict) };
                self.clearest_failing = leading(self.clearest_failing, Some(one), |x| -x);
            }
            Outcome::NotApplicable(_) => self.counts.not_applicable += 1,
            Outcome::Undecided => {
                self.counts.undecided += 1;
                self.first_undecided = first(self.first_undecided, Some(number));
            }
        }
    }

    /// Counts a member in its cell of the map.
    pub fn locate(&mut self, cell: usize, verdict: &Verdict) {
        let kind = match verdict.outcome() {
            Outcome::Holds(_) => 0,
            Outcome::Fails(_) => 1,
            Outcome::NotApplicable(_) => 2,
            Outcome::Undecided => 3,
        };
        if let Some(counts) = self.map.get_mut(cell) {
            counts[kind] += 1;
        }
    }

    /// Adds what was counted of other members.
    pub fn join(&mut self, other: &Tally) {
        self.counts.join(&other.counts);
        self.first_failing = first(self.first_failing, other.first_failing);
        self.clearest_failing = leading(self.clearest_failing, other.clearest_failing, |x| -x);
        self.closest_call = leading(self.closest_call, other.closest_call, |x| x);
        self.first_undecided = first(self.first_undecided, other.first_undecided);
        self.first_defect = first(self.first_defect, other.first_defect);
        self.slopes.join(&other.slopes);
        // A tally of no members has no cells.
        self.map.resize(self.map.len().max(other.map.len()), [0; 4]);
        for (here, there) in self.map.iter_mut().zip(&other.map) {
            here.iter_mut().zip(there).for_each(|(a, b)| *a = a.saturating_add(*b));
        }
    }

    /// The numbers of the members that are kept.
    pub fn kept(&self) -> impl Iterator<Item = u64> {
        let ranked = [self.clearest_failing, self.closest_call].into_iter().flatten().map(|r| r.number);
        let plain = [self.first_failing, self.first_undecided, self.first_defect];
        plain.into_iter().flatten().chain(ranked)
    }

    /// What cannot be so of a tally of these numbers; `drawn` says whether draws are repeated until there is a member.
    pub fn fault(&self, numbers: &RangeInclusive<u64>, drawn: bool) -> Option<&'static str> {
        let size = numbers.end().saturating_sub(*numbers.start()).saturating_add(1);
        let Counts { members, rejected, holds, fails, not_applicable, undecided } = self.counts;
        let all = [holds, fails, not_applicable, undecided];
        let sum = all.iter().try_fold(0_u64, |sum, n| sum.checked_add(*n));
        let looked_at = if drawn { Some(members) } else { members.checked_add(rejected) };
        let measured = [self.clearest_failing, self.closest_call];
        let mapped = |kind: usize| self.map.iter().try_fold(0_u64, |sum, cell| sum.checked_add(cell[kind]));
        if sum != Some(members) {
            Some("its counts do not add up")
        } else if !self.map.is_empty() && all.iter().enumerate().any(|(kind, n)| mapped(kind) != Some(*n)) {
            Some("its map does not add up")
        } else if self.slopes.fault(members) {
            Some("its slopes do not add up")
        } else if looked_at != Some(size) {
            Some("it does not count every number")
        } else if self.kept().any(|n| !numbers.contains(&n)) || measured.iter().flatten().any(|r| r.measure.is_nan()) {
            Some("it names members of another part")
        } else if (fails > 0) != self.first_failing.is_some()
            || (fails > 0) != self.clearest_failing.is_some()
            || (undecided > 0) != self.first_undecided.is_some()
            || (holds == 0 && self.closest_call.is_some())
            || (undecided == 0 && self.first_defect.is_some())
        {
            Some("it does not name the members that it counts")
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use number::Draws;
    use reason::Plain;
    use std::sync::Arc;
    use verdict::{Evidence, Finding, Possible, ResidualPoint, Residuals, Witness};

    /// A verdict of any kind, with few different measures, so that there are ties.
    fn verdict(draws: &mut Draws) -> Verdict {
        let mut small = |n: u64| draws.bits() % n;
        let kind = small(5);
        let size = small(4) as f64;
        let point = ResidualPoint { t: 0.0, left: 0.0, right: 0.0, residual: size, bound: 0.1, limit: 1e-9 };
        let series = Residuals { formula: String::new(), equation: false, sought: false, of: 1, points: vec![point] };
        let witness =
            Witness { t: 0.0, formula: String::new(), left: size, right: -1.0, bound: 0.1, values: Vec::new() };
        let evidence = |possible: Possible| {
            let witness = (possible == Possible::FALSE).then(|| witness.clone());
            Evidence { samples: 1, series: Some(Arc::new(series.clone())), witness, ..Evidence::default() }
        };
        let sampled = |possible: Possible| Verdict::of(Finding::sampled(possible, evidence(possible)));
        match kind {
            0 => sampled(Possible::TRUE),
            1 => sampled(Possible::FALSE),
            2 => Verdict::of(Finding::sampled(Possible::VOID, Evidence::because(Plain::NoValueDetermined))),
            3 => Verdict::of(Finding::open(Plain::NotLookedAt)),
            _ => {
                let mut verdict = sampled(Possible::TRUE);
                verdict.contradict(reason::Reason::quoted("on purpose"));
                verdict
            }
        }
    }

    /// The cells of a map.
    const CELLS: u64 = 5;

    #[test]
    fn any_partition_in_any_order_gives_the_same() {
        let mut draws = Draws::new(11);
        for round in 0..300_u64 {
            let size = 1 + draws.bits() % 40;
            let verdicts: Vec<Option<Verdict>> =
                (0..size).map(|_| (!draws.bits().is_multiple_of(6)).then(|| verdict(&mut draws))).collect();
            let one = |tally: &mut Tally, number: u64| match &verdicts[number as usize - 1] {
                Some(verdict) => {
                    tally.count(number, verdict, 1e-9);
                    tally.map.resize(CELLS as usize, [0; 4]);
                    tally.locate((number % CELLS) as usize, verdict);
                }
                None => tally.counts.rejected += 1,
            };
            let mut whole = Tally::default();
            (1..=size).for_each(|number| one(&mut whole, number));
            assert_eq!(whole.fault(&(1..=size), false), None, "{whole:?}");
            // Dealt out to some parts, not even in rows; some of them are empty.
            let mut parts = vec![Tally::default(); 1 + (draws.bits() % 9) as usize];
            let mut numbers: Vec<u64> = (1..=size).collect();
            for i in (1..numbers.len()).rev() {
                numbers.swap(i, (draws.bits() % (i as u64 + 1)) as usize);
            }
            for number in numbers {
                let at = (draws.bits() % parts.len() as u64) as usize;
                one(&mut parts[at], number);
            }
            // Joined in pairs in any order, until one is left.
            while parts.len() > 1 {
                let taken = parts.swap_remove((draws.bits() % parts.len() as u64) as usize);
                let at = (draws.bits() % parts.len() as u64) as usize;
                if draws.bits() & 1 == 0 {
                    parts[at].join(&taken);
                } else {
                    let mut other = taken;
                    other.join(&parts[at]);
                    parts[at] = other;
                }
            }
            assert_eq!(parts[0], whole, "round {round}");
            parts[0].join(&Tally::default());
            assert_eq!(parts[0], whole, "the empty tally is neutral");
        }
    }

    #[test]
    fn a_tally_that_cannot_be_is_seen() {
        let counts = Counts { members: 3, rejected: 1, holds: 2, fails: 1, ..Counts::default() };
        let good = Tally { counts, first_failing: Some(7), ..Tally::default() };
        let good = Tally { clearest_failing: Some(Ranked { number: 7, measure: 2.0 }), ..good };
        let numbers = 5..=8;
        assert_eq!(good.fault(&numbers, false), None);
        let drawn = Tally { counts: Counts { members: 4, holds: 3, rejected: 1000, ..counts }, ..good.clone() };
        assert_eq!(drawn.fault(&numbers, true), None);
        let bad = [
            Tally { counts: Counts { holds: 3, ..counts }, ..good.clone() },
            Tally { counts: Counts { holds: u64::MAX, ..counts }, ..good.clone() },
            Tally { counts: Counts { rejected: 0, ..counts }, ..good.clone() },
            Tally { counts: Counts { rejected: u64::MAX, ..counts }, ..good.clone() },
            Tally { first_failing: None, ..good.clone() },
            Tally { first_failing: Some(4), ..good.clone() },
            Tally { clearest_failing: None, ..good.clone() },
            Tally { clearest_failing: Some(Ranked { number: 9, measure: 2.0 }), ..good.clone() },
            Tally { clearest_failing: Some(Ranked { number: 7, measure: f64::NAN }), ..good.clone() },
            Tally { first_undecided: Some(6), ..good.clone() },
            Tally { first_defect: Some(6), ..good.clone() },
            Tally { slopes: Slopes { pairs: 4, ..Slopes::default() }, ..good.clone() },
            Tally { slopes: Slopes { pairs: 1, sums: [-1, 0, 0], ..Slopes::default() }, ..good.clone() },
            Tally {
                slopes: Slopes { pairs: 1, cells: vec![Some((1.0, f64::NAN))], ..Slopes::default() },
                ..good.clone()
            },
        ];
        for tally in bad {
            assert!(tally.fault(&numbers, false).is_some(), "{tally:?}");
        }
    }
}
