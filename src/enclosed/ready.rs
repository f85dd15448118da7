//! A part of a claim on a stretch of time: what intervals leave possible of it.
//!
//! **In:** ranges of the differences of its comparisons over a stretch. **Out:** [`Possible`], for the selectors and for what
//! is said. The connectives are those of [`Group::value`]: nothing is combined here.
//!
//! **Guaranteed.** A range that may hold values of both kinds leaves both possible; an operation that has no value anywhere on
//! the stretch is void, one that may lack it leaves that open. Agreement to within an allowance counts as equality only where
//! [`Group::allows`] it, and is asked for by its own name, [`Ready::within`].

use super::cover::{Along, Ranges, Selection};
use crate::derivation::{Claim, Occasion};
use crate::flow::Reach;
use crate::latex::RelationKind;
use crate::number::{Interval, NoValue};
use crate::verdict::{Enclosed, Possible, Truth, Witness};
use claim::comparison::Group;
use claim::program::{Part, Program};
use reason::{Enclosing, Plain, Reason};
use std::rc::Rc;

/// The residual of an equation must be below this part of its sides, where these do not vanish.
pub(super) const TELLING: f64 = 1e-3;

/// What an enclosure shows of a part of a claim.
#[derive(Clone, Debug)]
pub(super) enum Shown {
    /// It is true, for the reason given.
    Holds(Enclosed, Reason),
    /// It is true that something never happens that should: with a time that counts.
    Excluded(Enclosed, Reason, Witness),
    /// It is false, and where that can be seen.
    Fails(Witness, Reason),
    /// It says nothing, for the reason given.
    Void(Reason),
    /// It is true if it says anything.
    Unless(Enclosed, Reason),
    /// It tells of nearly all times, and not of a stretch between: anything may be so there, alone.
    Isolated(Reason),
    /// It does not tell.
    Nothing(Reason),
}

impl Shown {
    /// What holds at one place, without a gap.
    pub fn at_one_place(reason: impl Into<Reason>) -> Shown {
        Shown::Holds(Enclosed { places: 1, gap: 0.0, scale: 1.0 }, reason.into())
    }
}

/// Comparisons with the places of their differences, and the signs of ±.
#[derive(Clone, Copy)]
struct Placed<'a> {
    group: &'a Group,
    first: usize,
    signs: usize,
}

/// A part, compiled with the selectors of the claim.
pub(super) struct Ready<'a> {
    pub part: &'a Part,
    pub group: &'a Group,
    /// The differences of the selectors, then, for each sign and comparison, that of its sides; for a claim that something
    /// is defined, the left side.
    pub roots: Selection,
    /// For each of the above: the places of left side, right side, size of the terms.
    pub sides: Vec<usize>,
    selectors: Vec<Placed<'a>>,
    said: Placed<'a>,
    pub signs: usize,
    /// Where what vanishes at the events of the claim stands, and its rate.
    pub event: Option<(usize, usize)>,
    /// Which of these events are meant.
    pub occasion: Occasion,
    pub scale: f64,
    /// Whether samples found the part to be true.
    pub agreed: bool,
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

/// Most points at which sizes are taken.
pub(super) const POINTS: usize = 40;

/// Steps that are spread over the span.
pub(super) fn spread(along: &Along) -> Vec<Interval> {
    let every = along.pieces().len().div_ceil(POINTS).max(1);
    along.pieces().iter().copied().step_by(every).collect()
}

/// All sides at the middle of steps that are spread over the span.
pub(super) fn at_middles(along: &mut Along) -> Vec<Rc<Vec<Result<Interval, NoValue>>>> {
    spread(along).into_iter().map(|time| along.at_middle(time)).collect()
}

impl Placed<'_> {
    /// What a range leaves possible of a comparison.
    fn comparison(&self, ranges: &Ranges, sign: usize, c: usize) -> Possible {
        let kind = self.group.comparisons[c].kind;
        match &ranges[self.place(sign, c)] {
            Ok(_) if self.group.asserted && kind == RelationKind::Equal => Possible::TRUE,
            Ok(reach) => match certain(kind, reach.range()) {
                Some(true) => Possible::TRUE,
                Some(false) => Possible::FALSE,
                None => Possible::OPEN,
            },
            Err(NoValue::OutOfDomain) => Possible::VOID,
            Err(_) => Possible::ANY,
        }
    }

    fn place(&self, sign: usize, comparison: usize) -> usize {
        self.first + sign * self.group.comparisons.len() + comparison
    }

    /// What is left possible for one sign, where `one` tells it of each comparison.
    fn value(&self, one: impl Fn(usize) -> Possible) -> Possible {
        if !self.group.asserted {
            return self.group.value(one);
        }
        // The conditions under which there is a value are compared, too: they refute, the value itself shows that it is there.
        let of = |conditions: bool| {
            let each = self.group.comparisons.iter().enumerate();
            let each = each.filter(|(_, c)| (c.kind != RelationKind::Equal) == conditions);
            each.fold(Possible::TRUE, |all, (c, _)| all.and(one(c).asserted()))
        };
        match (of(false), of(true)) {
            (_, Possible::FALSE) => Possible::FALSE,
            (value, _) => value,
        }
    }
}

impl<'a> Ready<'a> {
    pub fn new(program: &'a Program, part: &'a Part, along: &mut Along, claim: &Claim) -> Result<Ready<'a>, Reason> {
        let (mut roots, mut sides): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
        let sign = claim.scope.branch_sign();
        let values = [along.graph.integer(1), along.graph.integer(-1)];
        let mut place = |group: &'a Group, along: &mut Along| -> Result<Placed<'a>, Reason> {
            let (first, signs) = (roots.len(), if group.branching { 2 } else { 1 });
            for &with in values.iter().take(signs) {
                for c in &group.comparisons {
                    let graph = &mut along.graph;
                    let [left, right, size] =
                        [c.left, c.right, c.magnitude].map(|e| graph.rewrite(e, |_, l| (l == sign).then_some(with)));
                    let value = group.asserted && c.kind == RelationKind::Equal;
                    let root = if value { left } else { graph.sub(left, right) };
                    roots.push(along.difference(root)?);
                    for e in [left, right, size] {
                        sides.push(along.side(e)?);
                    }
                }
            }
            Ok(Placed { group, first, signs })
        };
        let mut selectors = Vec::new();
        for selector in &program.selectors {
            selectors.push(place(&selector.part.group, along)?);
        }
        let said = place(&part.group, along)?;
        let event = match program.at {
            Some(e) => {
                let rate = along.enclosure.rate(&mut along.graph, e).map_err(Reason::quoted)?;
                roots.extend([along.difference(e)?, along.difference(rate)?]);
                Some((roots.len() - 2, roots.len() - 1))
            }
            None => None,
        };
        let (roots, group, signs) = (Selection::new(roots), &part.group, said.signs);
        let (scale, known, precision) = (1.0, 0.0, claim.precision);
        let occasion = claim.at.as_ref().map(|at| at.occasion).unwrap_or_default();
        let agreed = false;
        Ok(Ready {
            part,
            group,
            roots,
            sides,
            selectors,
            said,
            signs,
            event,
            occasion,
            scale,
            agreed,
            known,
            precision,
        })
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
        let places = || self.said.first..self.sides.len() / 3;
        // A lower bound: what may be 0 has no size.
        let typical = places().map(|at| of(at, 2, Interval::lo)).fold(0.0, f64::max);
        let size = Interval::mignitude;
        self.known = places().map(|at| of(at, 0, size).max(of(at, 1, size))).fold(0.0, f64::max);
        // Terms that may all be 0 have no size. Where samples see that the sides agree in units of the terms, these are 0, and numbers as
        // they are written are the unit; where samples cannot tell, the terms may be too small for anything to be small against.
        self.scale = if typical > 0.0 || !self.agreed { typical } else { 1.0 };
    }

    /// Where the difference of a comparison stands.
    pub fn place(&self, sign: usize, comparison: usize) -> usize {
        self.said.place(sign, comparison)
    }

    /// Whether any selectors, or events, decide which times count.
    pub fn is_restricted(&self) -> bool {
        !self.selectors.is_empty() || self.event.is_some()
    }

    /// The comparisons of the selectors: where their differences stand among all, and their kinds. `None` where they are more
    /// than inequalities that must all be true.
    pub fn assumed(&self) -> Option<Vec<(usize, RelationKind)>> {
        let mut out = Vec::new();
        for selector in &self.selectors {
            if selector.group.formula.is_some() || selector.signs > 1 {
                return None;
            }
            let each = selector.group.comparisons.iter().enumerate();
            out.extend(each.map(|(c, of)| (self.roots.roots()[selector.place(0, c)], of.kind)));
        }
        Some(out)
    }

    /// Whether the times of a stretch count: for certain, for certain not, or unknown.
    pub fn selected(&self, ranges: &Ranges) -> Option<bool> {
        let all = self.selectors.iter().fold(Possible::TRUE, |all, of| {
            let one = |s: usize| of.value(|c| of.comparison(ranges, s, c));
            all.and(of.group.over_signs((0..of.signs).map(one)))
        });
        match (all == Possible::TRUE, all.may_be(Truth::True)) {
            (true, _) => Some(true),
            (_, false) => Some(false),
            _ => None,
        }
    }

    /// What is left possible on a stretch, for one sign of ±.
    pub fn value_of_sign(&self, ranges: &Ranges, sign: usize) -> Possible {
        self.said.value(|c| self.said.comparison(ranges, sign, c))
    }

    /// What is left possible on a stretch.
    pub fn value(&self, ranges: &Ranges) -> Possible {
        self.group.over_signs((0..self.signs).map(|s| self.value_of_sign(ranges, s)))
    }

    /// The same, if the comparison `c` is false for one sign.
    pub fn value_without(&self, ranges: &Ranges, sign: usize, without: usize) -> Possible {
        let one = |s: usize, c: usize| match (s, c) == (sign, without) {
            true => Possible::FALSE,
            false => self.said.comparison(ranges, s, c),
        };
        self.group.over_signs((0..self.signs).map(|s| self.said.value(|c| one(s, c))))
    }

    /// What is allowed of a difference: the precision, times the size of the terms, and less than the sides themselves.
    fn room(&self) -> f64 {
        // Where huge terms cancel, a bound that is small against them may be larger than the sides: that says nothing.
        let telling = if self.known > 0.0 { TELLING * self.known } else { f64::INFINITY };
        (self.precision * self.scale).min(telling)
    }

    /// How far the sides of equations may be apart on a stretch where the part is true for a sign of ±, to within what is
    /// allowed.
    ///
    /// # Errors
    /// Why it is not known to be true, or true where it has a value.
    pub fn within(&self, ranges: &Ranges, sign: usize) -> Result<f64, Reason> {
        let (room, allows) = (self.room(), self.part.allows());
        let mut largest = 0.0_f64;
        let one = |c: usize| {
            let known = self.said.comparison(ranges, sign, c);
            let (Ok(reach), true) = (&ranges[self.place(sign, c)], allows && known == Possible::OPEN) else {
                return known;
            };
            let range = reach.range();
            let fine = match self.group.comparisons[c].kind {
                RelationKind::Equal => range.magnitude() <= room,
                RelationKind::LessEqual => range.hi() <= self.precision * self.scale,
                RelationKind::GreaterEqual => range.lo() >= -self.precision * self.scale,
                RelationKind::NotEqual | RelationKind::Less | RelationKind::Greater => false,
            };
            if fine { Possible::TRUE } else { known }
        };
        let whole = self.said.value(one);
        if !whole.may_be(Truth::False) {
            for (c, comparison) in self.group.comparisons.iter().enumerate() {
                let Ok(reach) = &ranges[self.place(sign, c)] else { continue };
                let range = reach.range();
                let open = || self.said.comparison(ranges, sign, c) == Possible::OPEN;
                let off = match comparison.kind {
                    RelationKind::LessEqual | RelationKind::GreaterEqual if !open() => 0.0,
                    RelationKind::Equal if !self.said.group.asserted => range.magnitude(),
                    RelationKind::LessEqual => range.hi(),
                    RelationKind::GreaterEqual => -range.lo(),
                    RelationKind::Equal | RelationKind::NotEqual | RelationKind::Less | RelationKind::Greater => 0.0,
                };
                largest = largest.max(off);
            }
            return Ok(if allows { largest } else { 0.0 });
        }
        let wrong = (0..self.group.comparisons.len()).find(|&c| one(c).may_be(Truth::False) || one(c) == Possible::ANY);
        let c = wrong.unwrap_or(0);
        let Some(comparison) = self.group.comparisons.get(c) else { return Err(Plain::NothingCompared.into()) };
        let label = comparison.label.as_str().into();
        let why = match &ranges[self.place(sign, c)] {
            Err(reason) => Enclosing::NoValue(label, *reason),
            Ok(reach) => Enclosing::NotApart { label, from: reach.range().lo(), to: reach.range().hi() },
        };
        Err(why.into())
    }

    /// Whether the bound of an equation is too wide, and does not refute it either: asked at a single time.
    pub fn hopeless(&self, ranges: &Ranges, sign: usize) -> bool {
        let most = self.room();
        self.part.allows()
            && self.group.comparisons.iter().enumerate().any(|(c, comparison)| match &ranges[self.place(sign, c)] {
                Ok(reach) if comparison.kind == RelationKind::Equal => {
                    let there = reach.range();
                    there.contains(0.0) && there.magnitude() > most
                }
                _ => false,
            })
    }

    /// The comparison that a witness shows: one that is false on a stretch, with a sign of ±.
    pub fn violated(&self, ranges: &Ranges, sign: usize) -> Option<usize> {
        (0..self.group.comparisons.len()).find(|&c| self.said.comparison(ranges, sign, c) == Possible::FALSE)
    }

    /// Both sides at a time.
    pub fn sides_at(&self, along: &Along, t: f64, place: usize) -> Option<(Interval, Interval)> {
        match along.sides_at(&self.sides[3 * place..3 * place + 2], t)[..] {
            [Ok(left), Ok(right)] => Some((left, right)),
            _ => None,
        }
    }

    /// A time at which the part is false for certain, and which counts.
    pub fn witness(&self, along: &mut Along, t: f64) -> Option<Witness> {
        let ranges = along.over(&self.roots, Interval::point(t));
        if self.selected(&ranges) != Some(true) || self.value(&ranges) != Possible::FALSE {
            return None;
        }
        self.shown(along, &ranges, t)
    }

    /// A time at which one sign of ± fails, and which counts.
    pub fn witness_against(&self, sign: usize, along: &mut Along, t: f64) -> Option<Witness> {
        let ranges = along.over(&self.roots, Interval::point(t));
        if self.selected(&ranges) != Some(true) || self.value_of_sign(&ranges, sign) != Possible::FALSE {
            return None;
        }
        let c = self.violated(&ranges, sign)?;
        self.point(along, &ranges, (sign, c), t)
    }

    /// What a reader is shown of a time: the comparison that is false there, or the first.
    pub fn shown(&self, along: &Along, ranges: &Ranges, t: f64) -> Option<Witness> {
        let signs = (0..self.signs).find_map(|s| Some((s, self.violated(ranges, s)?)));
        let place = signs.unwrap_or((0, 0));
        let comparison = self.group.comparisons.get(place.1)?;
        self.point(along, ranges, place, t).or_else(|| {
            // There is no value to show.
            let formula = comparison.label.clone();
            Some(Witness { t, formula, left: 0.0, right: 0.0, bound: 0.0, values: Vec::new() })
        })
    }

    fn point(&self, along: &Along, ranges: &Ranges, (s, c): (usize, usize), t: f64) -> Option<Witness> {
        let difference = ranges[self.place(s, c)].as_ref().ok()?.range();
        let (left, right) = self.sides_at(along, t, self.place(s, c))?;
        let formula = self.group.comparisons[c].label.clone();
        Some(Witness {
            t,
            formula,
            left: left.mid(),
            right: right.mid(),
            bound: difference.width(),
            values: Vec::new(),
        })
    }

    /// Whether there is, for certain, a time on a stretch at which a comparison that must differ does not, so that the part is false
    /// then: left − right, continuous on the stretch, changes its sign (Bolzano). All times of the stretch count.
    pub fn crosses(&self, ranges: &Ranges, time: Interval) -> bool {
        let each = (0..self.signs).flat_map(|s| (0..self.group.comparisons.len()).map(move |c| (s, c)));
        each.into_iter().any(|(s, c)| {
            let differs = self.group.comparisons[c].kind == RelationKind::NotEqual && !self.said.group.asserted;
            differs
                && ranges[self.place(s, c)].as_ref().is_ok_and(|reach| changes_sign(reach, time))
                && self.value_without(ranges, s, c) == Possible::FALSE
        })
    }
}

/// Whether a quantity, continuous on a stretch, has opposite signs at its ends: then it vanishes between them.
pub(super) fn changes_sign(reach: &Reach, time: Interval) -> bool {
    let (a, b) = (reach.at(time.lo()), reach.at(time.hi()));
    (a.hi() < 0.0 && b.lo() > 0.0) || (a.lo() > 0.0 && b.hi() < 0.0)
}
