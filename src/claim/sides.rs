//! Comparisons, measured.
//!
//! **In:** a compiled claim, and points. **Out:** [`Measurements`]: both sides of every comparison at every point, with the
//! error bound of their difference; and the size of their terms, which is computed only where it is asked for.
//!
//! **Why sizes on demand:** the terms of a formula are traced back to what its observables are computed from, which takes
//! four times the work of the formula itself. What is typical of their size along a motion is seen at a few samples, and
//! what counts at a single point is needed where the bound is large against that, or where a claim fails.

use std::cell::{OnceCell, RefCell};
use std::ops::Range;
use std::rc::Rc;
use std::sync::Arc;

use crate::block::{BLOCK, Block, Evaluation, Part as Tapes};
use crate::comparison::{Comparison, Group, judge};
use crate::expr::tape::Slots;
use crate::expr::{Expr, Graph, Node, Op};
use crate::flow::Points;
use crate::latex::RelationKind;
use crate::number::{Bounded, NoValue};
use crate::program::{Part, Program, What};
use crate::verdict::Possible;

/// Samples at which it is seen what is typical of the size of the terms.
const TYPICAL: usize = 4 * BLOCK;

/// Errors below this are those of results that are too small for a number.
const UNDERFLOW: f64 = 1e-290;
/// The counted work of taking up a group, beside that of its values.
const OF_A_GROUP: u64 = 500;

/// Both sides of a comparison at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The left side.
    pub left: f64,
    /// The right side.
    pub right: f64,
    /// Left − right.
    pub difference: Bounded,
}

/// A comparison at all times, for one sign of ±.
#[derive(Clone, Debug, Default)]
pub struct Series {
    left: Vec<f64>,
    right: Vec<f64>,
    difference: Vec<Bounded>,
    /// Why there is no value, time by time; empty as long as there is one at every time.
    missing: Vec<Option<NoValue>>,
}

impl Series {
    /// No times yet.
    pub fn with_capacity(times: usize) -> Series {
        let column = || Vec::with_capacity(times);
        Series { left: column(), right: column(), difference: Vec::with_capacity(times), missing: Vec::new() }
    }

    /// The number of times.
    pub fn len(&self) -> usize {
        self.difference.len()
    }

    /// Whether there is no time.
    pub fn is_empty(&self) -> bool {
        self.difference.is_empty()
    }

    /// Adds a time.
    pub fn push(&mut self, measured: Result<Measured, NoValue>) {
        let none = Measured { left: 0.0, right: 0.0, difference: Bounded::exact(0.0) };
        if let (Err(_), true) = (&measured, self.missing.is_empty()) {
            self.missing.resize(self.len(), None);
        }
        if let (Err(_), _) | (_, false) = (&measured, self.missing.is_empty()) {
            self.missing.push(measured.err());
        }
        let m = measured.unwrap_or(none);
        self.left.push(m.left);
        self.right.push(m.right);
        self.difference.push(m.difference);
    }

    /// Adds those of several times from the one at `from` on.
    pub fn push_block(&mut self, sides: Result<[&Block; 3], NoValue>, from: usize) {
        match sides {
            Ok([left, right, difference]) if self.missing.is_empty() => {
                self.left.extend_from_slice(&left.values()[from..]);
                self.right.extend_from_slice(&right.values()[from..]);
                self.difference.extend((from..BLOCK).map(|i| difference.lane(i)));
            }
            sides => (from..BLOCK).for_each(|i| {
                self.push(sides.map(|[left, right, difference]| Measured {
                    left: left.values()[i],
                    right: right.values()[i],
                    difference: difference.lane(i),
                }));
            }),
        }
    }

    /// The left side, compared with what it is at one of the times.
    fn relative_to(&mut self, reference: usize) {
        let of = self.difference(reference).map(|_| (self.left[reference], self.difference[reference].error));
        for i in 0..self.len() {
            match of {
                Err(reason) => {
                    self.missing.resize(self.difference.len(), None);
                    self.missing[i] = Some(reason);
                }
                Ok((right, error)) => {
                    let own = if i == reference { 0.0 } else { self.difference[i].error + error };
                    self.right[i] = right;
                    self.difference[i] = Bounded { value: self.left[i] - right, error: own };
                }
            }
        }
    }

    /// Left − right at a time.
    ///
    /// # Errors
    /// Why there is none.
    #[inline]
    pub fn difference(&self, time: usize) -> Result<Bounded, NoValue> {
        match self.missing.get(time) {
            Some(Some(reason)) => Err(*reason),
            _ => self.difference.get(time).copied().ok_or(NoValue::OutOfDomain),
        }
    }

    /// Both sides at a time.
    ///
    /// # Errors
    /// Why they have no value.
    pub fn get(&self, time: usize) -> Result<Measured, NoValue> {
        let difference = self.difference(time)?;
        Ok(Measured { left: self.left[time], right: self.right[time], difference })
    }

    /// Left − right where there is a value.
    pub fn differences(&self) -> impl DoubleEndedIterator<Item = Bounded> + '_ {
        (0..self.len()).filter_map(|i| self.difference(i).ok())
    }
}

/// The sizes of the terms of comparisons, for one sign of ±, at the points at which they were measured.
#[derive(Clone)]
pub enum Sizes<'a> {
    /// `[comparison][point]`.
    Known(Rc<Vec<Vec<f64>>>),
    /// Computed when they are asked for.
    Asked(Rc<Asked<'a>>),
}

/// Sizes that are computed when they are asked for.
pub struct Asked<'a> {
    part: &'a Tapes,
    points: Arc<Points>,
    sign: f64,
    slots: RefCell<Option<Slots<Bounded>>>,
    blocks: RefCell<Option<Slots<Block>>>,
    /// `[comparison][sample]`: at some samples of all.
    typical: OnceCell<Vec<Vec<Option<f64>>>>,
}

/// Which of so many points are looked at for what is typical.
pub(crate) fn samples(count: usize) -> Vec<usize> {
    if count <= TYPICAL {
        (0..count).collect()
    } else {
        (0..TYPICAL).map(|k| k * (count - 1) / (TYPICAL - 1)).collect()
    }
}

impl Asked<'_> {
    fn at(&self, comparison: usize, time: usize) -> Option<f64> {
        let mut slots = self.slots.borrow_mut();
        let slots = self.part.run(self.points.sample(time), self.sign, &mut slots);
        self.part.tape().output(comparison, slots).ok().map(|x| x.value)
    }

    /// The sizes of some comparisons at some times: `[comparison][time]`.
    fn table(&self, comparisons: Range<usize>, times: &[usize]) -> Vec<Vec<Option<f64>>> {
        let mut all = vec![Vec::with_capacity(times.len()); comparisons.len()];
        let evaluation = Evaluation::new(self.part, &self.points, self.sign, comparisons.clone());
        let mut evaluation = evaluation.in_memory(self.blocks.take());
        let tape = self.part.tape();
        for block in times.chunks(BLOCK) {
            // The last block is filled up with its last time.
            let last = block[block.len() - 1];
            let whole = std::array::from_fn(|i| block.get(i).copied().unwrap_or(last));
            if let Some(slots) = evaluation.at_all(whole) {
                for (c, sizes) in comparisons.clone().zip(&mut all) {
                    let size = tape.output(c, slots).ok();
                    sizes.extend((0..block.len()).map(|i| size.map(|x| x.values()[i])));
                }
                continue;
            }
            for &time in block {
                let slots = evaluation.at(time);
                for (c, sizes) in comparisons.clone().zip(&mut all) {
                    sizes.push(tape.output(c, slots).ok().map(|x| x.value));
                }
            }
        }
        self.blocks.replace(evaluation.into_memory());
        all
    }

    fn typical(&self) -> &[Vec<Option<f64>>] {
        let all = 0..self.part.tape().output_count();
        self.typical.get_or_init(|| self.table(all, &samples(self.points.len())))
    }
}

impl Sizes<'_> {
    /// The size of the terms of a comparison at a time; `None` where it has no value.
    pub fn at(&self, comparison: usize, time: usize) -> Option<f64> {
        match self {
            Sizes::Known(all) => all.get(comparison)?.get(time).copied(),
            Sizes::Asked(asked) => asked.at(comparison, time),
        }
    }

    /// Those at several times.
    fn at_all(&self, comparison: usize, times: &[usize]) -> Vec<Option<f64>> {
        match self {
            Sizes::Known(_) => times.iter().map(|&time| self.at(comparison, time)).collect(),
            Sizes::Asked(asked) => asked.table(comparison..comparison + 1, times).pop().unwrap_or_default(),
        }
    }

    /// The sizes of a comparison at some times of those at which it has a value.
    fn some(&self, comparison: usize, series: &Series) -> Vec<f64> {
        let valued = |time: &usize| series.difference(*time).is_ok();
        let sizes: Vec<f64> = match self {
            Sizes::Known(_) => Vec::new(),
            Sizes::Asked(asked) => {
                let known = asked.typical().get(comparison).map(Vec::as_slice).unwrap_or_default();
                let at = samples(asked.points.len()).into_iter().zip(known);
                // Of times that were not measured nothing else is known.
                at.filter(|(time, _)| *time >= series.len() || valued(time)).filter_map(|(_, size)| *size).collect()
            }
        };
        // Where none of these samples counts, others may.
        if !sizes.is_empty() {
            return sizes;
        }
        let others: Vec<usize> = (0..series.len()).filter(valued).collect();
        self.at_all(comparison, &others).into_iter().flatten().collect()
    }
}

/// The middle one of some sizes; 0 where there is none.
pub(crate) fn median(mut sizes: Vec<f64>) -> f64 {
    if sizes.is_empty() {
        return 0.0;
    }
    let middle = sizes.len() / 2;
    *sizes.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// One group, measured: `signs[s][c]` is comparison c for the sign s; one sign only where no ± occurs.
pub struct MeasuredGroup<'a> {
    /// What was compared.
    pub group: &'a Group,
    /// The measurements.
    pub signs: Vec<Vec<Series>>,
    /// Whether equality within the error bound does not count: nothing is concluded from it for what should happen.
    pub strict: bool,
    /// For each sign and comparison, whether agreement within the error bound says nothing: see `mute`.
    pub mute: Vec<Vec<bool>>,
    /// For each sign and comparison, whether the sides agree within the error bound all along. Agreement at some times, as of a
    /// power that decays, does not show a weak relation, where that is `doubted`.
    pub equal: Vec<Vec<bool>>,
    /// For each sign and comparison, whether agreement within the error bound refutes a strict relation: where the event says
    /// that the sides are equal, or they change their order.
    said: Vec<Vec<bool>>,
    /// Whether agreement all along refutes a strict relation, too: where it selects times, which then are left out, or motions.
    selects: bool,
    /// Whether agreement within the error bound does not show a weak relation: where it selects times, and at events where it
    /// is denied that something happens.
    doubted: bool,
    /// For each time, where a search found it, the comparison that changes its sign there: its sides are equal.
    pub crossing: Vec<Option<usize>>,
    /// For each sign the sizes of terms, those of the group from position `first` on.
    sizes: Vec<Sizes<'a>>,
    first: usize,
    /// What is typical of the size of the terms along the motion, for each sign.
    floors: Vec<OnceCell<f64>>,
}

/// Whether a relation excludes equality.
fn is_strict(kind: RelationKind) -> bool {
    matches!(kind, RelationKind::NotEqual | RelationKind::Less | RelationKind::Greater)
}

impl<'a> MeasuredGroup<'a> {
    /// A group measured along a motion: what is typical of it is what is typical there. Its sizes are those from position
    /// `first` on.
    pub fn new(
        group: &'a Group,
        signs: Vec<Vec<Series>>,
        (sizes, first): (Vec<Sizes<'a>>, usize),
    ) -> MeasuredGroup<'a> {
        let none: Vec<Vec<bool>> = signs.iter().map(|s| vec![false; s.len()]).collect();
        let ends = |series: &Series| Some((series.differences().next()?, series.differences().next_back()?));
        let equal = |(series, comparison): (&Series, &Comparison)| {
            // Nothing else asks for it.
            comparison.kind != RelationKind::Equal
                && ends(series).is_some_and(|(first, _)| first.contains_zero())
                && series.differences().all(|d| d.contains_zero())
        };
        let equal = signs.iter().map(|s| s.iter().zip(&group.comparisons).map(equal).collect()).collect();
        let floors = signs.iter().map(|_| OnceCell::new()).collect();
        MeasuredGroup {
            group,
            signs,
            strict: false,
            mute: none.clone(),
            equal,
            said: none,
            selects: false,
            doubted: false,
            crossing: Vec::new(),
            sizes,
            first,
            floors,
        }
    }

    /// The same group at other points, for which `along` says what is typical.
    fn beside(
        group: &'a Group,
        signs: Vec<Vec<Series>>,
        (sizes, first): (Vec<Sizes<'a>>, usize),
        along: &MeasuredGroup,
    ) -> MeasuredGroup<'a> {
        let floors = (0..signs.len()).map(|s| OnceCell::from(along.floor(s))).collect();
        let (mute, equal, said) = (along.mute.clone(), along.equal.clone(), along.said.clone());
        let (strict, selects, doubted) = (along.strict, along.selects, along.doubted);
        let crossing = Vec::new();
        MeasuredGroup { group, signs, strict, mute, equal, said, selects, doubted, crossing, sizes, first, floors }
    }

    /// What is equal at events, a few single times, is equal only if it is so along the whole motion; or if the event says so.
    /// What must not be 0 for a value to exist is said of single times along the motion, too: so only the event tells of it.
    fn at_events(&mut self, graph: &Graph, event: Expr, along: &MeasuredGroup) {
        self.doubted |= self.group.denied && !self.group.asserted;
        let zero = |e: Expr| matches!(graph.node(e), Node::Constant(c) if c.is_zero());
        let sides = match graph.node(event) {
            Node::Binary(Op::Sub, a, b) => Some((*a, *b)),
            Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => None,
        };
        let says = |c: &Comparison| {
            c.left == event && zero(c.right)
                || c.right == event && zero(c.left)
                || sides.is_some_and(|(a, b)| [(a, b), (b, a)].contains(&(c.left, c.right)))
        };
        for (s, there) in along.equal.iter().enumerate() {
            for ((c, there), comparison) in there.iter().enumerate().zip(&self.group.comparisons) {
                let said = self.equal[s][c] && says(comparison);
                self.equal[s][c] &= *there && !self.group.asserted || said;
                self.said[s][c] = said;
            }
        }
    }

    /// What is typical of the size of the terms of the group. The components of a vector share it: that one of them vanishes
    /// does not make its rounding significant.
    pub fn floor(&self, sign: usize) -> f64 {
        let Some(floor) = self.floors.get(sign) else { return 1.0 };
        *floor.get_or_init(|| {
            let (series, sizes) = (&self.signs[sign], &self.sizes[sign]);
            let each = || series.iter().enumerate().map(|(c, series)| (self.first + c, series));
            let typical = each().map(|(c, series)| median(sizes.some(c, series))).fold(0.0, f64::max);
            if typical > 0.0 {
                return typical;
            }
            // Terms that are 0 with an error this small are not 0, but too small for a number: nothing is small against
            // them, if not what they are at other times.
            let error = series.iter().flat_map(Series::differences).map(|d| d.error).fold(0.0, f64::max);
            let all = each().flat_map(|(c, series)| (0..series.len()).filter_map(move |i| sizes.at(c, i)));
            if error > 0.0 && error < UNDERFLOW { all.fold(0.0, f64::max) } else { 1.0 }
        })
    }

    /// What a residual must be small against: the size of the terms at that time, or what is typical of the group along
    /// the motion, whichever is larger.
    pub fn scale(&self, sign: usize, comparison: usize, time: usize) -> f64 {
        self.sizes[sign].at(self.first + comparison, time).unwrap_or(0.0).max(self.floor(sign))
    }

    /// The scales of a comparison at several times.
    pub fn scales(&self, sign: usize, comparison: usize, times: &[usize]) -> Vec<f64> {
        let sizes = self.sizes[sign].at_all(self.first + comparison, times);
        sizes.into_iter().map(|size| size.unwrap_or(0.0).max(self.floor(sign))).collect()
    }

    /// Whether the sides are equal within an error, where that does not refute a strict relation.
    fn is_open(&self, sign: usize, comparison: usize, time: usize, difference: Bounded) -> bool {
        let strict = is_strict(self.group.comparisons[comparison].kind);
        let along = || self.selects && self.equal[sign][comparison];
        let equal = || self.said[sign][comparison] || along() || self.crossing.get(time) == Some(&Some(comparison));
        strict && difference.error > 0.0 && difference.contains_zero() && !equal()
    }

    /// Whether agreement within the error bound shows nothing of what should be.
    fn is_doubted(&self, sign: usize, comparison: usize) -> bool {
        let weak = self.group.comparisons[comparison].kind != RelationKind::Equal;
        self.strict || self.doubted && weak && !self.equal[sign][comparison]
    }

    /// What is known of the group at every time, for one sign.
    pub fn stand(&self, sign: usize, precision: f64) -> Vec<Possible> {
        let all = &self.signs[sign];
        let times = all.first().map_or(0, Series::len);
        if self.group.formula.is_some() {
            let at = |time: usize| self.group.value(|c| self.standing(sign, c, time, precision));
            return (0..times).map(at).collect();
        }
        let mut whole = vec![Possible::TRUE; times];
        for (c, series) in all.iter().enumerate() {
            let equation = self.group.comparisons[c].kind == RelationKind::Equal;
            let plain = equation
                && !self.group.asserted
                && !self.is_doubted(sign, c)
                && !self.mute[sign][c]
                && series.missing.is_empty();
            for (i, whole) in whole.iter_mut().enumerate() {
                // Nearly all points of an equation that holds.
                let agrees = |d: &Bounded| d.value.abs() <= d.error && d.error <= precision * self.floor(sign);
                if plain && series.difference.get(i).is_some_and(agrees) {
                    continue;
                }
                *whole = whole.and(self.standing(sign, c, i, precision));
            }
        }
        whole
    }

    /// What is known of a comparison at a time.
    pub fn standing(&self, sign: usize, comparison: usize, time: usize, precision: f64) -> Possible {
        let kind = self.group.comparisons[comparison].kind;
        // Where something must have a value, an equation only says that there is one; its conditions are inequalities.
        let asserted = self.group.asserted;
        let exists = asserted && kind == RelationKind::Equal;
        match self.signs[sign][comparison].difference(time) {
            Ok(_) if exists => Possible::TRUE,
            // No bound is small enough for what cannot be seen.
            Ok(d) if self.mute[sign][comparison] => judge(kind, d, 0.0, precision),
            Ok(d) => {
                // The size of the terms decides only what lies within the error bound, and is asked for only where that is
                // large against what is typical.
                let scale = match d.value.abs() <= d.error {
                    false => 0.0,
                    true if d.error <= precision * self.floor(sign) => self.floor(sign),
                    true => self.scale(sign, comparison, time),
                };
                match judge(kind, d, scale, precision) {
                    Possible::FALSE if self.is_open(sign, comparison, time, d) => Possible::OPEN,
                    Possible::TRUE if self.is_doubted(sign, comparison) && d.error > 0.0 && d.contains_zero() => {
                        Possible::OPEN
                    }
                    known => known,
                }
            }
            Err(NoValue::OutOfDomain) if asserted => Possible::FALSE,
            Err(NoValue::OutOfDomain) => Possible::VOID,
            // A value may exist: this is a bound that is too large, not a formula that says nothing.
            Err(_) if asserted => Possible::OPEN,
            Err(_) => Possible::ANY,
        }
    }

    /// Whether the sides of a comparison, which lie within their error bound of one another at a time, cannot be taken for equal: only of
    /// what is said of every time, and where the bound is small enough.
    pub fn is_unequal(&self, sign: usize, comparison: usize, time: usize, precision: f64) -> bool {
        match self.signs[sign][comparison].difference(time) {
            // What has no value is no matter of equality.
            Err(_) => false,
            Ok(d) if d.value == 0.0 && d.error == 0.0 => false,
            // What is typical is known; the size of the terms at one time takes work.
            Ok(d) => {
                let exceeds = |scale: f64| d.error > precision * scale;
                self.strict
                    || !self.group.allows()
                    || exceeds(self.floor(sign)) && exceeds(self.scale(sign, comparison, time))
            }
        }
    }

    /// The values of the left sides, each compared with what it is at the first of the times that count at which it has one, in
    /// place of what they were compared with. What never has one stays as it is: without a value.
    pub fn relative_to_the_first(&mut self, times: usize, counts: impl Fn(usize) -> bool) {
        for series in self.signs.iter_mut().flatten() {
            if let Some(first) = (0..times).find(|&i| counts(i) && series.difference(i).is_ok()) {
                series.relative_to(first);
            }
        }
    }
}

/// Everything measured for one claim at a list of times.
pub struct Measurements<'a> {
    /// The selectors.
    pub selectors: Vec<MeasuredGroup<'a>>,
    /// The hypotheses.
    pub hypotheses: Vec<MeasuredGroup<'a>>,
    /// What the claim says, part by part.
    pub parts: Vec<MeasuredGroup<'a>>,
    /// Memory for measuring single parts at other points.
    memory: RefCell<Option<Slots<Block>>>,
}

impl Measurements<'_> {
    /// The measurements are those at the zeros of `event`, on a motion that was measured `along`.
    pub fn at_events(&mut self, graph: &Graph, event: Expr, along: &Measurements) {
        let groups = self.selectors.iter_mut().zip(&along.selectors).chain(self.parts.iter_mut().zip(&along.parts));
        groups.for_each(|(here, there)| here.at_events(graph, event, there));
    }
}

/// Measures all groups of a program at the given points. What is typical of the size of their terms is that of `along`, the
/// measurements along the whole motion; without it, that of the points.
pub fn measure<'a>(program: &'a Program, points: &Arc<Points>, along: Option<&Measurements>) -> Measurements<'a> {
    gathered(program, (points, points.len()), along)
}

/// The same for the first of the points, up to `times`; all of them say what is typical.
pub fn measure_first<'a>(program: &'a Program, points: &Arc<Points>, times: usize) -> Measurements<'a> {
    gathered(program, (points, times.min(points.len())), None)
}

fn gathered<'a>(
    program: &'a Program,
    (points, times): (&Arc<Points>, usize),
    along: Option<&Measurements>,
) -> Measurements<'a> {
    let groups = program.selectors.len() + program.hypotheses.len() + program.parts.len();
    meter::charge(OF_A_GROUP * groups as u64);
    let signs: &[f64] = if program.is_branching() { &[1.0, -1.0] } else { &[1.0] };
    let mut by_sign: Vec<Vec<Series>> = signs.iter().map(|&sign| program.measure((points, times), sign)).collect();
    let sizes: Vec<Sizes> = signs.iter().map(|&sign| sizes(program, points, sign)).collect();
    let mut next = 0;
    let mut gather = |group: &'a Group, along: Option<&MeasuredGroup>| {
        let first = next;
        next += group.comparisons.len();
        let used = if group.branching { by_sign.len() } else { 1 };
        let mut series = |s: usize, c: usize| by_sign[s].get_mut(first + c).map(std::mem::take).unwrap_or_default();
        let signs = (0..used).map(|s| (0..group.comparisons.len()).map(|c| series(s, c)).collect()).collect();
        let sizes = (sizes[..used].to_vec(), first);
        match along {
            Some(along) => MeasuredGroup::beside(group, signs, sizes, along),
            None => MeasuredGroup::new(group, signs, sizes),
        }
    };
    let mut each = |of: Vec<&'a Part>, known: Option<&Vec<MeasuredGroup>>| -> Vec<MeasuredGroup<'a>> {
        let one = |(k, part): (usize, &'a Part)| {
            let mut group = gather(&part.group, known.and_then(|m| m.get(k)));
            group.strict = matches!(part.what, What::Denied);
            group
        };
        of.into_iter().enumerate().map(one).collect()
    };
    let mut selectors = each(program.selectors.iter().map(|a| &a.part).collect(), along.map(|m| &m.selectors));
    selectors.iter_mut().for_each(|group| (group.doubted, group.selects) = (true, true));
    let hypotheses = each(program.hypotheses.iter().map(|a| &a.part).collect(), along.map(|m| &m.hypotheses));
    let mut parts = each(program.parts.iter().collect(), along.map(|m| &m.parts));
    parts.iter_mut().for_each(|group| group.selects = program.tells_apart);
    Measurements { selectors, hypotheses, parts, memory: RefCell::default() }
}

/// Measures one part of a program, the only one then, and the selectors, at other points than those `along` the motion: of a claim with many
/// parts, each of which is looked at elsewhere, all of them each time would be the square of their number.
pub fn measure_part<'a>(
    program: &'a Program,
    points: &Arc<Points>,
    along: &Measurements,
    position: usize,
) -> Measurements<'a> {
    meter::charge(OF_A_GROUP * (program.selectors.len() + 1) as u64);
    let signs: &[f64] = if program.is_branching() { &[1.0, -1.0] } else { &[1.0] };
    let sizes: Vec<Sizes> = signs.iter().map(|&sign| sizes(program, points, sign)).collect();
    let beside = |group: &'a Group, known: &MeasuredGroup| {
        let used = if group.branching { signs.len() } else { 1 };
        let some = known.first..known.first + group.comparisons.len();
        let of = |&sign: &f64| program.measure_some((points, points.len()), sign, some.clone(), &along.memory);
        let series = signs[..used].iter().map(of).collect();
        MeasuredGroup::beside(group, series, (sizes[..used].to_vec(), known.first), known)
    };
    let selectors = program.selectors.iter().zip(&along.selectors).map(|(a, known)| beside(&a.part.group, known));
    let part = beside(&program.parts[position].group, &along.parts[position]);
    Measurements {
        selectors: selectors.collect(),
        hypotheses: Vec::new(),
        parts: vec![part],
        memory: RefCell::default(),
    }
}

/// The sizes of the terms of all comparisons of a program, for one sign of ±.
fn sizes<'a>(program: &'a Program, points: &Arc<Points>, sign: f64) -> Sizes<'a> {
    match program.sizes() {
        None => Sizes::Known(Rc::default()),
        Some(part) => {
            let (slots, blocks, typical) = (RefCell::default(), RefCell::default(), OnceCell::new());
            Sizes::Asked(Rc::new(Asked { part, points: Arc::clone(points), sign, slots, blocks, typical }))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::Block;

    fn at(value: f64) -> Measured {
        Measured { left: value + 1.0, right: 1.0, difference: Bounded::new(value, 1e-15) }
    }

    #[test]
    fn a_column_remembers_where_it_has_no_value() {
        let mut series = Series::with_capacity(20);
        series.push(Ok(at(0.5)));
        let block = |x: f64| Block::splat(Bounded::exact(x));
        let sides = [block(3.0), block(1.0), block(2.0)];
        series.push_block(Ok([&sides[0], &sides[1], &sides[2]]), 5);
        series.push(Err(NoValue::Indeterminate));
        series.push_block(Ok([&sides[0], &sides[1], &sides[2]]), 6);
        series.push_block(Err(NoValue::OutOfDomain), 7);
        let two = || Ok(Measured { left: 3.0, right: 1.0, difference: Bounded::exact(2.0) });
        let (lost, none) = (Err(NoValue::Indeterminate), Err(NoValue::OutOfDomain));
        let all = [Ok(at(0.5)), two(), two(), two(), lost, two(), two(), none];
        assert_eq!((0..series.len()).map(|i| series.get(i)).collect::<Vec<_>>(), all);
        assert_eq!(series.get(8), none, "beyond the end");
        assert_eq!(series.differences().count(), 6);
    }

    #[test]
    fn what_is_typical_is_seen_at_few_samples_and_at_all_where_these_do_not_count() {
        assert_eq!(samples(3), [0, 1, 2]);
        let many = samples(1000);
        assert_eq!((many.len(), many[0], many[TYPICAL - 1]), (TYPICAL, 0, 999));
        assert_eq!(median(vec![5.0, 1.0, 9.0]), 5.0);
        assert_eq!(median(Vec::new()), 0.0);
        let mut series = Series::with_capacity(4);
        for m in [Err(NoValue::OutOfDomain), Ok(at(0.0)), Ok(at(1.0)), Err(NoValue::OutOfDomain)] {
            series.push(m);
        }
        let sizes = Sizes::Known(Rc::new(vec![vec![100.0, 2.0, 3.0, 100.0]]));
        assert_eq!(sizes.some(0, &series), [2.0, 3.0]);
        assert_eq!((sizes.at(0, 3), sizes.at(0, 4), sizes.at(1, 0)), (Some(100.0), None, None));
    }
}
