//! What is asked of the values on a stretch of time.

use super::cover::{Along, Judgement, Ranges, Selection};
use crate::check::comparison::Group;
use crate::check::program::{Program, Use};
use crate::check::verdict::Witness;
use crate::derivation::Claim;
use crate::flow::Reach;
use crate::latex::RelationKind;
use crate::number::{Interval, NoValue};
use std::rc::Rc;

/// The residual of an equation must be below this part of its sides, where these do not vanish.
pub(super) const TELLING: f64 = 1e-3;
/// What an enclosure shows of a part of a claim.
pub(super) enum Shown {
    /// It holds, for the reason given.
    Holds(String),
    /// It does not, and where that can be seen.
    Fails(Witness, String),
    /// It does not tell.
    Nothing(String),
}

/// A group, compiled with the assumptions.
pub(super) struct Ready<'a> {
    pub group: &'a Group,
    /// The differences of the assumptions, then, for each sign and comparison, that of its sides; for a claim that something
    /// is defined, the left side.
    pub roots: Selection,
    /// For each of the above: the places of left side, right side, size of the terms.
    pub sides: Vec<usize>,
    /// The places of the differences of the equations among the assumptions, and of the size of their terms.
    pub given: Vec<(usize, usize)>,
    /// The kinds of the assumptions that select times.
    pub assumptions: Vec<RelationKind>,
    pub signs: usize,
    /// Whether one sign of ± must serve the whole motion.
    pub throughout: bool,
    /// Where the rate of the only difference stands.
    pub slope: Option<usize>,
    /// Where what vanishes at the events of the claim stands, and its rate.
    pub event: Option<(usize, usize)>,
    pub scale: f64,
    /// The median size that the sides have for certain; 0 where they may vanish.
    pub known: f64,
    pub precision: f64,
}

/// Whether a relation between the sides holds for all, or for no, value of their difference.
pub(super) fn certain(kind: RelationKind, difference: Interval) -> Option<bool> {
    let (lo, hi) = (difference.lo(), difference.hi());
    let apart = lo > 0.0 || hi < 0.0;
    let decide = |yes: bool, no: bool| if yes { Some(true) } else { no.then_some(false) };
    match kind {
        RelationKind::Equal => decide(lo == 0.0 && hi == 0.0, apart),
        RelationKind::NotEqual => decide(apart, lo == 0.0 && hi == 0.0),
        RelationKind::Less => decide(hi < 0.0, lo >= 0.0),
        RelationKind::LessEqual => decide(hi <= 0.0, lo > 0.0),
        RelationKind::Greater => decide(lo > 0.0, hi <= 0.0),
        RelationKind::GreaterEqual => decide(lo >= 0.0, hi < 0.0),
    }
}

/// The median of what is not negative; 1 where there is nothing.
pub(super) fn median(mut sizes: Vec<f64>) -> f64 {
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().filter(|x| *x > 0.0).unwrap_or(0.0)
}

/// Terms below this size are lost among the last numbers before 0.
const LOST: f64 = 1e-280;

/// Most points at which sizes are taken.
pub(super) const POINTS: usize = 40;

/// All sides at the middle of steps that are spread over the span.
pub(super) fn at_middles(along: &mut Along) -> Vec<Rc<Vec<Result<Interval, NoValue>>>> {
    let every = along.pieces().len().div_ceil(POINTS).max(1);
    let times: Vec<Interval> = along.pieces().iter().copied().step_by(every).collect();
    times.into_iter().map(|time| along.at_middle(time)).collect()
}

impl<'a> Ready<'a> {
    pub fn new(
        program: &'a Program,
        (how, group): (&Use, &'a Group),
        along: &mut Along,
        claim: &Claim,
    ) -> Result<Ready<'a>, String> {
        let precision = claim.precision;
        let defined = matches!(how, Use::Defined);
        let signs = if group.branching { 2 } else { 1 };
        let sign = claim.scope.branch_sign();
        let (plus, minus) = (along.graph.integer(1), along.graph.integer(-1));
        let (mut roots, mut sides): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
        let mut last = None;
        let (mut assumptions, mut given) = (Vec::new(), Vec::new());
        for assumption in &program.assumptions {
            if assumption.group.branching {
                return Err("an assumption with ± is not enclosed".to_owned());
            }
            for c in &assumption.group.comparisons {
                let difference = along.graph.sub(c.left, c.right);
                if assumption.throughout {
                    given.push((along.difference(difference)?, along.side(c.magnitude)?));
                    continue;
                }
                roots.push(along.difference(difference)?);
                for e in [c.left, c.right, c.magnitude] {
                    sides.push(along.side(e)?);
                }
                assumptions.push(c.kind);
            }
        }
        for s in 0..signs {
            let with = if s == 0 { plus } else { minus };
            for c in &group.comparisons {
                let graph = &mut along.graph;
                let [left, right, size] =
                    [c.left, c.right, c.magnitude].map(|e| graph.substitute(e, |_, l| (l == sign).then_some(with)));
                let value = defined && c.kind == RelationKind::Equal;
                let root = if value { left } else { graph.sub(left, right) };
                roots.push(along.difference(root)?);
                last = Some(root);
                for e in [left, right, size] {
                    sides.push(along.side(e)?);
                }
            }
        }
        let mut slope = None;
        if let (Use::Eventually(_), [_], Some(difference)) = (how, group.comparisons.as_slice(), last)
            && let Ok(rate) = along.enclosure.rate(&mut along.graph, difference)
            && let Ok(place) = along.difference(rate)
        {
            slope = Some(roots.len());
            roots.push(place);
        }
        let event = match program.at {
            Some(e) => {
                let rate = along.enclosure.rate(&mut along.graph, e).map_err(|e| e.to_string())?;
                roots.extend([along.difference(e)?, along.difference(rate)?]);
                Some((roots.len() - 2, roots.len() - 1))
            }
            None => None,
        };
        let roots = Selection::new(roots);
        let throughout = signs > 1 && claim.branches_throughout;
        let (scale, known) = (1.0, 0.0);
        Ok(Ready { group, roots, sides, given, assumptions, signs, throughout, slope, event, scale, known, precision })
    }

    /// Looks at more than the comparisons: where the first of the further expressions stands.
    pub fn beside(&mut self, further: impl IntoIterator<Item = usize>) -> usize {
        let mut roots = self.roots.roots().to_vec();
        let first = roots.len();
        roots.extend(further);
        self.roots = Selection::blunt(roots);
        first
    }

    /// The median size of the terms, at the middle of steps.
    pub fn weigh(&mut self, along: &mut Along) {
        let points = at_middles(along);
        let of = |at: usize, k: usize, measure: fn(&Interval) -> f64| {
            let place = self.sides[3 * at + k];
            median(points.iter().filter_map(|p| p.get(place)?.as_ref().ok().map(measure)).collect())
        };
        let places = || self.assumptions.len()..self.sides.len() / 3;
        // A lower bound: what may be 0 has no size.
        let typical = places().map(|at| of(at, 2, Interval::lo)).fold(0.0, f64::max);
        let size = Interval::mignitude;
        self.known = places().map(|at| of(at, 0, size).max(of(at, 1, size))).fold(0.0, f64::max);
        // Terms that are there, but smaller than numbers can tell apart from 0, have no size that anything is small against.
        let largest = places().map(|at| of(at, 2, Interval::magnitude)).fold(0.0, f64::max);
        let lost = largest > 0.0 && largest < LOST;
        self.scale = if typical > 0.0 || lost { typical } else { 1.0 };
    }

    /// Where the difference of a comparison stands.
    pub fn place(&self, sign: usize, comparison: usize) -> usize {
        self.assumptions.len() + sign * self.group.comparisons.len() + comparison
    }

    /// The assumptions that select times: where their differences stand among all, and their kinds.
    pub fn assumed(&self) -> impl Iterator<Item = (usize, RelationKind)> {
        self.roots.roots().iter().copied().zip(self.assumptions.iter().copied())
    }

    /// Whether the assumptions that select times hold on a stretch: for certain, for certain not, or unknown.
    pub fn selected(&self, ranges: &Ranges) -> Option<bool> {
        let mut all = Some(true);
        for (i, &kind) in self.assumptions.iter().enumerate() {
            match &ranges[i] {
                Err(NoValue::OutOfDomain) => return Some(false),
                Err(_) => all = None,
                Ok(reach) => match certain(kind, reach.range()) {
                    Some(false) => return Some(false),
                    Some(true) => {}
                    None => all = None,
                },
            }
        }
        all
    }

    /// Whether the equations among the assumptions hold to the precision that is asked for, everywhere.
    pub fn presupposed(&self, along: &mut Along) -> Result<(), String> {
        if self.given.is_empty() {
            return Ok(());
        }
        along.presuppose((self.given.clone(), self.precision.to_bits()), |along| {
            let differences = Selection::new(self.given.iter().map(|g| g.0).collect());
            let points = at_middles(along);
            let most = |&(_, place): &(usize, usize)| {
                let sizes = points.iter().filter_map(|p| p.get(place)?.as_ref().ok().map(Interval::lo));
                let typical = median(sizes.collect());
                self.precision * if typical > 0.0 { typical } else { 1.0 }
            };
            let most: Vec<f64> = self.given.iter().map(most).collect();
            let judge = |_: Interval, ranges: &Ranges| {
                for (range, &most) in ranges.iter().zip(&most) {
                    match range {
                        Ok(r) if r.range().magnitude() <= most => {}
                        Ok(r) => {
                            let known = r.range().magnitude();
                            return Judgement::Open(format!("an assumption is not known well enough: within {known:.1e}"));
                        }
                        Err(reason) => return Judgement::Open(format!("an assumption has no value: {reason}")),
                    }
                }
                Judgement::Settled
            };
            let too_wide = |(range, &most): (&Result<Reach, NoValue>, &f64)| {
                matches!(range, Ok(r) if r.range().magnitude() > most)
            };
            along.cover(&differences, judge, |ranges| ranges.iter().zip(&most).any(too_wide)).map(|_| ())
        })
    }

    /// Whether all comparisons hold on a stretch with a sign of ±, and how far the sides of equations may be apart.
    pub fn holds(&self, ranges: &Ranges, sign: usize) -> Result<f64, String> {
        let room = self.precision * self.scale;
        // Where huge terms cancel, a bound that is small against them may be larger than the sides: that says nothing.
        let telling = if self.known > 0.0 { TELLING * self.known } else { f64::INFINITY };
        let mut largest = 0.0_f64;
        for (c, comparison) in self.group.comparisons.iter().enumerate() {
            let range = match &ranges[self.place(sign, c)] {
                Ok(reach) => reach.range(),
                Err(reason) => return Err(format!("`{}` has no value: {reason}", comparison.label)),
            };
            let fine = match comparison.kind {
                RelationKind::Equal => range.magnitude() <= room.min(telling),
                RelationKind::LessEqual => range.hi() <= room,
                RelationKind::GreaterEqual => range.lo() >= -room,
                kind => certain(kind, range) == Some(true),
            };
            if !fine {
                let (lo, hi) = (range.lo(), range.hi());
                return Err(format!(
                    "the sides of `{}` cannot be told apart: their difference lies in [{lo:.2e}, {hi:.2e}]",
                    comparison.label
                ));
            }
            if comparison.kind == RelationKind::Equal {
                largest = largest.max(range.magnitude());
            }
        }
        Ok(largest)
    }

    /// Whether the bound of an equation is too wide, and does not refute it either: asked at a single time.
    pub fn hopeless(&self, ranges: &Ranges, sign: usize) -> bool {
        let telling = if self.known > 0.0 { TELLING * self.known } else { f64::INFINITY };
        let most = (self.precision * self.scale).min(telling);
        self.group.comparisons.iter().enumerate().any(|(c, comparison)| match &ranges[self.place(sign, c)] {
            Ok(reach) if comparison.kind == RelationKind::Equal => {
                let there = reach.range();
                there.contains(0.0) && there.magnitude() > most
            }
            _ => false,
        })
    }

    /// The comparison that does not hold anywhere on a stretch, with a sign of ±.
    pub fn violated(&self, ranges: &Ranges, sign: usize) -> Option<usize> {
        (0..self.group.comparisons.len()).find(|&c| match &ranges[self.place(sign, c)] {
            Ok(reach) => certain(self.group.comparisons[c].kind, reach.range()) == Some(false),
            Err(_) => false,
        })
    }

    /// Whether all comparisons hold for certain on a stretch, with one sign of ±, and the assumptions.
    pub fn certainly(&self, ranges: &Ranges) -> bool {
        let one = |s: usize, c: usize| match &ranges[self.place(s, c)] {
            Ok(reach) => certain(self.group.comparisons[c].kind, reach.range()) == Some(true),
            Err(_) => false,
        };
        let all = |s: usize| (0..self.group.comparisons.len()).all(|c| one(s, c));
        self.selected(ranges) == Some(true) && (0..self.signs).any(all)
    }

    pub fn nowhere_defined(&self, ranges: &Ranges, sign: usize) -> bool {
        let place = |c: usize| self.place(sign, c);
        (0..self.group.comparisons.len()).any(|c| matches!(ranges[place(c)], Err(NoValue::OutOfDomain)))
    }

    /// Both sides at a time.
    pub fn sides_at(&self, along: &Along, t: f64, place: usize) -> Option<(Interval, Interval)> {
        match along.sides_at(&self.sides[3 * place..3 * place + 2], t)[..] {
            [Ok(left), Ok(right)] => Some((left, right)),
            _ => None,
        }
    }

    /// A point at which every sign of ± fails, assumptions being met.
    pub fn witness(&self, along: &mut Along, t: f64, values: Vec<(String, f64)>) -> Option<Witness> {
        let ranges = along.over(&self.roots, Interval::point(t));
        if self.selected(&ranges) != Some(true) {
            return None;
        }
        let worst: Option<Vec<usize>> = (0..self.signs).map(|s| self.violated(&ranges, s)).collect();
        self.shown(along, &ranges, (0, *worst?.first()?), t, values)
    }

    /// A point at which one sign of ± fails, assumptions being met.
    pub fn witness_against(&self, sign: usize, along: &mut Along, t: f64) -> Option<Witness> {
        let ranges = along.over(&self.roots, Interval::point(t));
        let worst = self.violated(&ranges, sign).filter(|_| self.selected(&ranges) == Some(true))?;
        self.shown(along, &ranges, (sign, worst), t, Vec::new())
    }

    fn shown(
        &self,
        along: &Along,
        ranges: &Ranges,
        (s, c): (usize, usize),
        t: f64,
        values: Vec<(String, f64)>,
    ) -> Option<Witness> {
        let difference = ranges[self.place(s, c)].as_ref().ok()?.range();
        let (left, right) = self.sides_at(along, t, self.place(s, c))?;
        let formula = self.group.comparisons[c].label.clone();
        Some(Witness { t, formula, left: left.mid(), right: right.mid(), bound: difference.width(), values })
    }
}
