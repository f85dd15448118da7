//! Whether relations between numbers are true on a whole cell, false on all of it, or open.
//!
//! **In:** expressions D and relations `D ? 0`, and a cell: an interval for each variable. **Out:** a [`Truth`] for each, about
//! all points of the cell *at which D has a value*, and where that is so ([`Domain`]).
//!
//! **How.** First the natural interval extension of D: the tape evaluated on intervals with outward rounding ([Moore, Kearfott
//! & Cloud 2009, Theorem 5.1]). Where that leaves the relation open, and D is continuous with partial derivatives gᵢ that
//! have a value on all of the cell, two sharper enclosures are intersected with it:
//!
//! - *the mean value form* D(m) + Σ gᵢ(X)·(Xᵢ − mᵢ) ([the same, §6.3]);
//! - *monotonicity*: where gᵢ does not change its sign on the cell, D takes its extremes with xᵢ at an end ([the same, §6.4]).
//!   At the ends of the whole range the exact number of the file is put into the formula, so that what vanishes there vanishes
//!   exactly, and touching the border of a closed range decides as it should.
//!
//! Where D vanishes at an end a of the range of xᵢ with its first m − 1 derivatives by xᵢ, exactly and whatever the others are, a
//! cell at that end has D = (xᵢ − a)ᵐ · ∂ᵢᵐD(ξ) / m! with ξ on the cell (Taylor's theorem in Lagrange's form): the power that both
//! sides of a bound have in common is taken out ([`Flat`]).
//!
//! **Where D has a value** follows from its operations: none lacks one on the cell, or what each of them needs (a radicand
//! that is not negative, a divisor that is not 0) is true by the same means.
//!
//! [Moore, Kearfott & Cloud 2009, Theorem 5.1]: https://doi.org/10.1137/1.9780898717716
//! [the same, §6.3]: https://doi.org/10.1137/1.9780898717716
//! [the same, §6.4]: https://doi.org/10.1137/1.9780898717716

use super::faults;
use crate::expr::tape::{Slots, Tape};
use crate::expr::{Expr, FastMap, FastSet, Graph, Leaf, Node, Op};
use crate::latex::RelationKind;
use crate::number::{Decorated, Interval, NoValue};
use claim::denote::relation;

/// Most derivatives that are looked at where D vanishes at an end of a range, and the most nodes of one of them.
const MOST_FLAT: u32 = 8;
const MOST_NODES: usize = 400;

/// Most variables for which formulas at the ends of ranges are made: there are 3ⁿ of them.
const MOST_EXACT: usize = 3;

/// What is known of a relation on a cell, at the points at which both sides have values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Truth {
    /// It holds at all of them.
    True,
    /// It holds at none.
    False,
    /// Not known.
    Open,
}

/// Where on a cell a formula has a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Domain {
    Everywhere,
    Nowhere,
    /// Perhaps not everywhere: where it has a value it is that of D.
    Open,
    /// There may be a rate at which its formula has no value: of the value nothing is known there.
    Edges,
}

/// The range of D on a cell; `None` where D has a value nowhere on it.
pub(super) type Range = Option<Decorated>;

/// A variable, its range enclosed, and its exact ends.
#[derive(Clone, Debug)]
pub(super) struct Variable {
    pub leaf: Leaf,
    /// Contains the range.
    pub outer: Interval,
    /// Contained in the range.
    pub inner: Interval,
    pub ends: (Expr, Expr),
    /// The ends as a reader knows them.
    pub shown: (f64, f64),
    /// The value that an assumption gives it, where binary64 has it: no other point is of interest.
    pub only: Option<f64>,
}

/// One D, compiled.
#[derive(Debug)]
struct Compiled {
    kind: RelationKind,
    /// D is known to be 0 wherever it has a value.
    vanishes: bool,
    value: Tape,
    /// Which variables occur.
    used: Vec<bool>,
    /// ∂D by every variable; none where a derivative cannot be written.
    slopes: Option<Tape>,
    /// D with some variables at an end of their ranges, by [`pattern`].
    exact: FastMap<usize, Tape>,
    /// The ends of ranges at which it is flat.
    flat: Vec<Flat>,
    /// What the operations of D need, by number, and whether there is no value where it is not met.
    needs: Vec<(usize, bool)>,
}

/// An end of the range of a variable at which D vanishes with its first derivatives, exactly, whatever the other variables are.
#[derive(Debug)]
struct Flat {
    variable: usize,
    upper: bool,
    /// ∂D … ∂ᵐD, of which the last does not vanish there.
    derivatives: Tape,
}

/// Relations `D ? 0` over some variables.
#[derive(Debug)]
pub(super) struct Signs {
    pub variables: Vec<Variable>,
    all: Vec<Compiled>,
    /// Numbers of the relations by what they say.
    known: FastMap<(Expr, RelationKind), usize>,
}

/// The memory of evaluations, and what is known on the cell at hand.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    slots: FastMap<(usize, usize), Slots<Decorated>>,
    found: Vec<Option<(Range, Truth)>>,
}

/// A cell: an interval for each variable, and whether it is the exact lower (`false`) or upper end of the range.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cell {
    pub sides: Vec<Interval>,
    pub at_end: Vec<Option<bool>>,
}

impl Cell {
    /// A cell inside the ranges.
    pub fn inside(sides: Vec<Interval>) -> Cell {
        let at_end = vec![None; sides.len()];
        Cell { sides, at_end }
    }
}

/// Which variables are at which end: a number in base 3.
fn pattern(ends: impl Iterator<Item = Option<bool>>) -> usize {
    ends.fold(0, |sum, end| 3 * sum + end.map_or(0, |upper| 1 + usize::from(upper)))
}

/// The leaves of a tape's variables.
fn leaves(variables: &[Variable]) -> Vec<Leaf> {
    variables.iter().map(|v| v.leaf).collect()
}

impl Signs {
    pub fn new(variables: Vec<Variable>) -> Signs {
        Signs { variables, all: Vec::new(), known: FastMap::default() }
    }

    /// The number of the relation `d ? 0`.
    ///
    /// # Errors
    /// A leaf of `d` that is no variable.
    pub fn add(&mut self, graph: &mut Graph, d: Expr, kind: RelationKind) -> Result<usize, Leaf> {
        if let Some(&known) = self.known.get(&(d, kind)) {
            return Ok(known);
        }
        let inputs = leaves(&self.variables);
        let value = Tape::compile(graph, &inputs, &[d])?;
        let mut needs = Vec::new();
        for need in graph.needs_below([d]) {
            needs.push((self.add(graph, need.value, relation(need.sign))?, need.certain));
        }
        let slopes: Result<Vec<Expr>, _> = inputs.iter().map(|&l| graph.partial_derivative(d, l)).collect();
        let slopes = slopes.ok().and_then(|roots| Tape::compile(graph, &inputs, &roots).ok());
        let (mut exact, mut flat) = (FastMap::default(), Vec::new());
        let occurring = graph.leaves([d]);
        let used: Vec<bool> = inputs.iter().map(|leaf| occurring.contains(leaf)).collect();
        if self.variables.len() <= MOST_EXACT {
            for number in 1..3usize.pow(self.variables.len() as u32) {
                let ends = self.ends_of(number);
                // What does not occur is not put in.
                if ends.iter().zip(&used).any(|(end, used)| end.is_some() && !used) {
                    continue;
                }
                let at = graph.substitute(d, |_, leaf| {
                    let i = inputs.iter().position(|l| *l == leaf)?;
                    let (from, to) = self.variables[i].ends;
                    ends[i].map(|upper| if upper { to } else { from })
                });
                exact.insert(number, Tape::compile(graph, &inputs, &[at])?);
                let mut given = ends.iter().enumerate().filter_map(|(i, end)| end.map(|upper| (i, upper)));
                if let (true, Some((i, upper)), None) = (is_null(graph, at), given.next(), given.next()) {
                    flat.extend(self.flat(graph, d, i, upper));
                }
            }
        }
        self.all.push(Compiled { kind, vanishes: false, value, used, slopes, exact, flat, needs });
        let number = self.all.len() - 1;
        self.known.insert((d, kind), number);
        Ok(number)
    }

    /// How flat D, which vanishes at an end of the range of a variable, is there; `None` where slopes alone tell as much.
    fn flat(&self, graph: &mut Graph, d: Expr, variable: usize, upper: bool) -> Option<Flat> {
        let Variable { leaf, ends: (from, to), .. } = self.variables[variable];
        let end = if upper { to } else { from };
        let (mut derivatives, mut next) = (Vec::new(), d);
        for _ in 0..MOST_FLAT {
            next = graph.partial_derivative(next, leaf).ok()?;
            if graph.reachable([next]).len() > MOST_NODES {
                return None;
            }
            derivatives.push(next);
            let at = graph.substitute(next, |_, l| (l == leaf).then_some(end));
            if !(is_null(graph, at) || faults::too_flat() && derivatives.len() == 1) {
                let derivatives =
                    Tape::compile(graph, &leaves(&self.variables), &derivatives).ok().filter(|_| derivatives.len() > 1);
                return derivatives.map(|derivatives| Flat { variable, upper, derivatives });
            }
        }
        None
    }

    /// Which variables some relation depends on.
    pub fn named(&self) -> Vec<bool> {
        (0..self.variables.len()).map(|i| self.all.iter().any(|one| one.used[i])).collect()
    }

    /// What a relation says.
    pub fn kind(&self, relation: usize) -> RelationKind {
        self.all[relation].kind
    }

    /// Says that D vanishes wherever it has a value.
    pub fn vanishes(&mut self, relation: usize) {
        self.all[relation].vanishes = true;
    }

    fn ends_of(&self, pattern: usize) -> Vec<Option<bool>> {
        let n = self.variables.len();
        (0..n).map(|i| [None, Some(false), Some(true)][pattern / 3usize.pow((n - 1 - i) as u32) % 3]).collect()
    }

    /// Forgets what was known of another cell.
    pub fn begin(&self, scratch: &mut Scratch) {
        scratch.found.clear();
        scratch.found.resize(self.all.len(), None);
    }

    /// Where D has a value on the cell.
    pub fn domain(&self, relation: usize, cell: &Cell, scratch: &mut Scratch) -> Domain {
        if faults::no_domain() {
            return Domain::Everywhere;
        }
        let (range, _) = self.look(relation, cell, scratch);
        match range {
            None if self.all[relation].needs.iter().all(|&(_, certain)| certain) => return Domain::Nowhere,
            Some(range) if range.is_defined() => return Domain::Everywhere,
            _ => {}
        }
        let mut found = Domain::Everywhere;
        for &(need, certain) in &self.all[relation].needs {
            match self.look(need, cell, scratch) {
                (None, _) | (_, Truth::False) if certain => return Domain::Nowhere,
                (_, Truth::True) => {}
                _ if certain && found == Domain::Everywhere => found = Domain::Open,
                _ if certain => {}
                _ => found = Domain::Edges,
            }
        }
        found
    }

    /// Whether the relation is true, at the points of the cell at which D has a value.
    pub fn truth(&self, relation: usize, cell: &Cell, scratch: &mut Scratch) -> Truth {
        self.look(relation, cell, scratch).1
    }

    fn look(&self, relation: usize, cell: &Cell, scratch: &mut Scratch) -> (Range, Truth) {
        if let Some(found) = scratch.found.get(relation).copied().flatten() {
            return found;
        }
        let of = &self.all[relation];
        let mut range = self.evaluate(relation, cell, scratch);
        if of.vanishes {
            range = range.map(|r| r.narrowed(Interval::point(0.0)));
        }
        let mut truth = range.map_or(Truth::Open, |r| judged(of.kind, r.range()));
        if truth == Truth::Open
            && let Some(wide) = range
            && wide.is_continuous()
            && let Some(sharp) = self.sharper(relation, cell, wide, scratch)
        {
            range = Some(wide.narrowed(sharp));
            truth = judged(of.kind, sharp);
        }
        if let Some(slot) = scratch.found.get_mut(relation) {
            *slot = Some((range, truth));
        }
        (range, truth)
    }

    /// The natural enclosure of D.
    fn evaluate(&self, relation: usize, cell: &Cell, scratch: &mut Scratch) -> Range {
        let of = &self.all[relation];
        // A variable that does not occur is at no end: the formula is the same.
        let number = pattern(cell.at_end.iter().zip(&of.used).map(|(end, used)| end.filter(|_| *used)));
        let (tape, number) = of.exact.get(&number).map_or((&of.value, 0), |tape| (tape, number + 1));
        run(tape, (relation, number), cell, scratch).pop().flatten()
    }

    /// What slopes say of the range of D, which is continuous on the cell.
    fn sharper(&self, relation: usize, cell: &Cell, natural: Decorated, scratch: &mut Scratch) -> Option<Interval> {
        let tape = self.all[relation].slopes.as_ref()?;
        let slopes: Vec<Interval> = run(tape, (relation, 1), cell, scratch)
            .into_iter()
            .map(|s| s.filter(|s| s.is_defined()).map(|s| s.range()))
            .collect::<Option<_>>()?;
        let extreme = |upper: bool| {
            let mut face = cell.clone();
            for (i, slope) in slopes.iter().enumerate() {
                let rising = slope.lo() >= 0.0;
                if !(rising || slope.hi() <= 0.0) {
                    continue;
                }
                let (side, outer) = (cell.sides[i], self.variables[i].outer);
                let at_top = rising == upper;
                let end = if at_top { side.hi() } else { side.lo() };
                face.sides[i] = Interval::point(end);
                if face.at_end[i].is_none() && end == if at_top { outer.hi() } else { outer.lo() } {
                    // The range ends here: the exact number, which lies in this interval.
                    face.at_end[i] = Some(at_top);
                    let inner = self.variables[i].inner;
                    face.sides[i] = if at_top { inner.hi() } else { inner.lo() }.hull_with(end);
                }
            }
            face
        };
        let (low, high) = (extreme(false), extreme(true));
        let low = self.evaluate(relation, &low, scratch)?.range().lo();
        let high = self.evaluate(relation, &high, scratch)?.range().hi();
        let range = natural.range();
        let mut sharp = Interval::new(range.lo().max(low), range.hi().min(high)).ok()?;
        let middle: Vec<f64> = cell.sides.iter().map(Interval::mid).collect();
        let centre = Cell::inside(middle.iter().map(|&m| Interval::point(m)).collect());
        if let Some(at) = self.evaluate(relation, &centre, scratch) {
            let mut mean = at.range();
            for ((slope, side), m) in slopes.iter().zip(&cell.sides).zip(&middle) {
                mean = mean + *slope * (*side - Interval::point(*m));
            }
            if mean.lo() <= mean.hi() {
                sharp = sharp.intersection(mean)?;
            }
        }
        for (number, flat) in self.all[relation].flat.iter().enumerate() {
            if let Some(range) = self.beside(flat, (relation, FLAT + number), cell, scratch) {
                sharp = sharp.intersection(range)?;
            }
        }
        Some(sharp)
    }

    /// What Taylor's theorem says of the range of D on a cell beside an end at which it is flat.
    fn beside(&self, flat: &Flat, key: (usize, usize), cell: &Cell, scratch: &mut Scratch) -> Option<Interval> {
        let (side, outer) = (cell.sides[flat.variable], self.variables[flat.variable].outer);
        let touches = if flat.upper { side.hi() == outer.hi() } else { side.lo() == outer.lo() };
        if !touches || cell.at_end[flat.variable].is_some() {
            return None;
        }
        // The last one has a value on all of the cell, and those before it: then each is the derivative of the one before.
        let ranges: Vec<Interval> = run(&flat.derivatives, key, cell, scratch)
            .into_iter()
            .map(|s| s.filter(|s| s.is_defined()).map(|s| s.range()))
            .collect::<Option<_>>()?;
        // Points of the range are on one side of its end; the end itself lies in the interval or on its border.
        let width = (Interval::point(side.hi()) - Interval::point(side.lo())).hi();
        let away = if flat.upper { Interval::new(-width, 0.0) } else { Interval::new(0.0, width) }.ok()?;
        let mut range = *ranges.last()?;
        for k in 1..=ranges.len() {
            range = range * away / Interval::point(k as f64);
        }
        Some(range)
    }
}

/// Whether a formula is 0 wherever it has a value, as its sums and products show.
fn is_null(graph: &Graph, e: Expr) -> bool {
    let mut null: FastSet<Expr> = FastSet::default();
    for part in graph.reachable([e]) {
        let is = |e: Expr| null.contains(&e);
        let found = match *graph.node(part) {
            Node::Constant(_) => graph.is_zero(part),
            Node::Unary(Op::Neg | Op::Sin, a) => is(a),
            Node::Binary(Op::Add, a, b) => is(a) && is(b),
            Node::Binary(Op::Sub, a, b) => a == b || is(a) && is(b),
            Node::Binary(Op::Mul, a, b) => is(a) || is(b),
            Node::Binary(Op::Div, a, _) => is(a),
            Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => false,
        };
        if found {
            null.insert(part);
        }
    }
    null.contains(&e)
}

/// Keys of the slots of derivatives at flat ends; those before are of D itself, of its slopes, and of D at ends.
const FLAT: usize = 1 << 16;

/// Runs a tape on a cell: a range for each output, `None` where it has a value nowhere.
fn run(tape: &Tape, key: (usize, usize), cell: &Cell, scratch: &mut Scratch) -> Vec<Range> {
    let slots = scratch.slots.entry(key).or_insert_with(|| tape.slots::<Decorated>(&()));
    ranges(tape, cell.sides.iter(), slots).collect()
}

/// The range of each output of a tape over a box; `None` where it has a value nowhere on it.
pub(super) fn ranges<'s>(
    tape: &'s Tape,
    sides: impl Iterator<Item = &'s Interval>,
    slots: &'s mut Slots<Decorated>,
) -> impl Iterator<Item = Range> + 's {
    for (i, side) in sides.enumerate() {
        slots.set(i, Ok(Decorated::all_of(*side)));
    }
    tape.run(&(), slots);
    found(tape, slots)
}

/// The outputs of a tape that was run on a box; `None` where one has a value nowhere on it.
pub(super) fn found<'s>(tape: &'s Tape, slots: &'s Slots<Decorated>) -> impl Iterator<Item = Range> + 's {
    (0..tape.output_count()).map(|k| match tape.output(k, slots) {
        Ok(value) => Some(*value),
        Err(NoValue::OutOfDomain) => None,
        // Nothing is known.
        Err(NoValue::Indeterminate | NoValue::Unsupported) => Some(Decorated::UNKNOWN),
    })
}

/// What a range of D says of `D ? 0`.
fn judged(kind: RelationKind, d: Interval) -> Truth {
    let kind = match kind {
        RelationKind::Less if faults::weak() => RelationKind::LessEqual,
        RelationKind::Greater if faults::weak() => RelationKind::GreaterEqual,
        kind => kind,
    };
    let (lo, hi) = (d.lo(), d.hi());
    let zero = lo == 0.0 && hi == 0.0;
    let (yes, no) = match kind {
        RelationKind::Equal => (zero, lo > 0.0 || hi < 0.0),
        RelationKind::NotEqual => (lo > 0.0 || hi < 0.0, zero),
        RelationKind::Less => (hi < 0.0, lo >= 0.0),
        RelationKind::LessEqual => (hi <= 0.0, lo > 0.0),
        RelationKind::Greater => (lo > 0.0, hi <= 0.0),
        RelationKind::GreaterEqual => (lo >= 0.0, hi < 0.0),
    };
    match (yes, no) {
        (true, _) => Truth::True,
        (_, true) => Truth::False,
        _ => Truth::Open,
    }
}

/// The interval between two numbers in any order.
trait Hull {
    fn hull_with(self, other: f64) -> Interval;
}

impl Hull for f64 {
    fn hull_with(self, other: f64) -> Interval {
        Interval::point(self).hull(Interval::point(other))
    }
}
