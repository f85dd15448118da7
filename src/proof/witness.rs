//! Real points that satisfy the premises: witnesses against an identity, examples for one.
//!
//! A point is built in the order of the resolution: small rational values for the free leaves, angles with rational cosine
//! and sine, then the definitions. It counts only after every premise, as it was given, has been evaluated there and found to
//! hold, within rounding first, then for certain: see `certain.rs`; so a mistake in the resolution can lose a witness, not forge one. Sides are computed twice: in binary64 from the
//! formulas as given, and exactly from the lowered formulas where every root is rational.

mod certain;
mod frame;

use self::frame::Frame;
use super::bounds::Bounds;
use super::exact::Exact;
use super::generators::{Generator, Generators};
use super::linear::Combinations;
use super::outcome::{Point, PointValue, Refutation, Side};
use expr::tape::{Slots, Tape};
use expr::{Expr, Graph, Leaf, Node, Op, Rational};
use expr::{FastMap, FastSet};
use number::{Bounded, Draws, NoValue, Number};

/// Everything a point is built from and tested with.
pub(super) struct Scene<'a> {
    pub(super) graph: &'a Graph,
    pub(super) generators: &'a Generators,
    /// The claim as given.
    pub(super) claim: &'a [(Expr, Expr)],
    /// The claim lowered, with all definitions inserted; roots are positive roots.
    pub(super) lowered: &'a [(Expr, Expr)],
    /// Premises as given, with their derivatives by time.
    pub(super) premises: &'a [(Expr, Expr)],
    pub(super) nonzero: &'a [Expr],
    pub(super) positive: &'a [Expr],
    pub(super) not_negative: &'a [Expr],
    /// Definitions before lowering.
    pub(super) explicit: &'a FastMap<Leaf, Expr>,
    /// Definitions of the case, closed.
    pub(super) defined: &'a FastMap<Leaf, Expr>,
    /// What gets its value from a generator that is solved for, see [`targets`].
    pub(super) targets: Vec<Target>,
}

/// A leaf that the argument of a generator is solved for, because the generator itself is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Target {
    /// Number of the generator: a cosine or an exponential.
    generator: usize,
    leaf: Leaf,
    /// The argument is a multiple of leaf or of 1/leaf: 1 or −1.
    power: i32,
}

/// For each cosine and exponential that is solved for, what its argument can be solved for: its only leaf, or one that
/// stands in no other argument.
pub(super) fn targets(graph: &Graph, generators: &Generators, defined: &FastMap<Leaf, Expr>) -> Vec<Target> {
    let arguments: Vec<(usize, Expr)> =
        generators.list.iter().enumerate().filter_map(|(at, g)| Some((at, g.argument()?))).collect();
    let mut out: Vec<Target> = Vec::new();
    for (at, generator) in generators.list.iter().enumerate() {
        let (argument, own) = match *generator {
            Generator::Cosine(a) => (a, at..at + 2),
            Generator::Exponential(a) => (a, at..at + 1),
            _ => continue,
        };
        if !own.clone().any(|i| generators.leaf(i).is_some_and(|l| defined.contains_key(&l))) {
            continue;
        }
        let combination = Combinations::default().of(graph, argument);
        let mut terms = combination.into_iter();
        let (Some((monomial, _)), None) = (terms.next(), terms.next()) else { continue };
        let single = monomial.len() == 1;
        let found = monomial.iter().find_map(|&(base, power)| {
            let &Node::Leaf(leaf) = graph.node(base) else { return None };
            let known = defined.contains_key(&leaf) || generators.get(leaf).is_some();
            let elsewhere = || {
                let others = monomial.iter().filter(|(b, _)| *b != base).map(|&(b, _)| b);
                let arguments = arguments.iter().filter(|(i, _)| !own.contains(i)).map(|&(_, a)| a);
                others.chain(arguments).any(|e| graph.leaves([e]).contains(&leaf))
            };
            let free = power.abs() == 1 && !known && !out.iter().any(|t| t.leaf == leaf) && (single || !elsewhere());
            free.then_some(Target { generator: at, leaf, power })
        });
        out.extend(found);
    }
    out
}

/// A point that satisfies all premises, and what the claim's sides are there.
#[derive(Clone, Debug, Default)]
pub(super) struct Found {
    pub(super) point: Point,
    pub(super) sides: Vec<(Side, Side)>,
    /// First equation whose sides certainly differ.
    pub(super) differs: Option<usize>,
    /// Whether these are apart by their decimals, not by exact values alone.
    is_apart: bool,
    /// Whether the sides of all premises are equal as rational numbers.
    is_exact: bool,
    placed: Placed,
}

const MAGNITUDES: [(i64, i64); 10] = [(1, 1), (2, 1), (3, 1), (1, 2), (3, 2), (5, 1), (1, 3), (4, 1), (2, 3), (7, 2)];
/// Numbers below 1: entries of rotations with rational coefficients, above all.
const SMALL: [(i64, i64); 10] = [(1, 3), (2, 3), (0, 1), (3, 5), (4, 5), (2, 7), (3, 7), (6, 7), (1, 2), (1, 4)];
/// Half-angle tangents: cosine and sine are 3/5 and 4/5, 5/13 and 12/13 …
const TANGENTS: [(i64, i64); 12] =
    [(1, 2), (1, 3), (2, 3), (-1, 2), (1, 4), (3, 2), (-1, 3), (3, 1), (-2, 3), (-3, 2), (-3, 1), (7, 1)];
/// The first points are simple: few numbers; few angles, and none beyond a half turn.
const SIMPLE: u32 = 24;
const SIMPLE_ANGLES: u32 = 12;

fn ratio((n, d): (i64, i64)) -> Rational {
    Rational::from(n) / Rational::from(d)
}

/// Values of expressions with bounds of their errors.
///
/// An angle atan2(y, x) that the bounds place on both sides of the negative half-axis has no value here: [`Bounded`] would
/// yield one of two representatives.
pub(super) fn decimals(graph: &Graph, exprs: &[Expr], values: &Values) -> Vec<Option<Bounded>> {
    Decimals::of(graph, exprs).at(values)
}

/// The same at one point after another: the expressions are compiled once.
pub(super) struct Decimals {
    leaves: Vec<Leaf>,
    tape: Tape,
    slots: Slots<Bounded>,
}

impl Decimals {
    pub(super) fn of(graph: &Graph, exprs: &[Expr]) -> Decimals {
        let leaves = graph.leaves(exprs.iter().copied());
        // Every leaf is an input, so the program exists.
        let tape = Tape::compile(graph, &leaves, exprs).unwrap_or_default();
        let slots = tape.slots(&());
        Decimals { leaves, tape, slots }
    }

    pub(super) fn at(&mut self, values: &Values) -> Vec<Option<Bounded>> {
        let Decimals { leaves, tape, slots } = self;
        for (i, leaf) in leaves.iter().enumerate() {
            slots.set(i, values.get(leaf).copied().ok_or(NoValue::Unsupported));
        }
        tape.run(&(), slots);
        let torn = tape.straddles_cut(slots);
        (0..tape.output_count()).map(|i| tape.output(i, slots).ok().copied().filter(|_| !torn)).collect()
    }
}

/// The value of a rational, with its rounding.
fn rounded(r: &Rational) -> Option<Bounded> {
    let mut out = Bounded::exact(0.0);
    Number::rational(&mut out, &(), r).ok()?;
    Some(out)
}

pub(super) type Values = FastMap<Leaf, Bounded>;

/// What was computed at one point: expressions share most of their nodes.
#[derive(Default)]
struct Computed {
    decimal: super::values::Values<Bounded>,
    precise: super::values::Values<Exact>,
    /// Angles that the bounds place on both sides of the cut.
    torn: Vec<Expr>,
    /// Arguments that the bounds place on both sides of the end of what a function is defined of, with the function: a point at which premises touch, if it is one.
    at_an_end: Vec<(Op, Expr)>,
    /// Whether exact values are computed.
    is_exact: bool,
}

/// The values of leaves at one point.
#[derive(Clone, Debug, Default)]
struct Placed {
    values: Values,
    exact: FastMap<Leaf, Rational>,
    /// Cosine and sine of angles, where both are rational.
    circles: FastMap<Leaf, (Rational, Rational)>,
}

impl Computed {
    /// What [`decimals`] gives. Every leaf has its value by now.
    fn decimals(&mut self, graph: &Graph, exprs: &[Expr], values: &Values) -> Vec<Option<Bounded>> {
        let new = self.decimal.missing(graph, exprs);
        for &e in &new {
            if let Node::Leaf(leaf) = graph.node(e) {
                self.decimal.set(e, values.get(leaf).copied().ok_or(NoValue::Unsupported));
            }
        }
        self.decimal.compute(&(), graph, &new);
        for &e in &new {
            if let &Node::Unary(op @ (Op::Sqrt | Op::Arcsin | Op::Arccos), a) = graph.node(e)
                && let Some(Ok(at)) = self.decimal.of(a)
            {
                let inside = if op == Op::Sqrt { at.value } else { 1.0 - at.value.abs() };
                if at.error > 0.0 && inside < at.error {
                    self.at_an_end.push((op, a));
                }
            }
            if let &Node::Binary(Op::Arctan2, y, x) = graph.node(e)
                && let (Some(Ok(y)), Some(Ok(x))) = (self.decimal.of(y), self.decimal.of(x))
                && y.error > 0.0
                && y.contains_zero()
                && x.value < 0.0
            {
                self.torn.push(e);
            }
        }
        let torn = !self.torn.is_empty() && {
            let below = graph.reachable(exprs.iter().copied());
            self.torn.iter().any(|e| below.contains(e))
        };
        exprs.iter().map(|&e| self.decimal.of(e)?.ok().filter(|_| !torn)).collect()
    }

    /// Whether a function whose argument may lie beyond the end of what it is defined of has a value for certain.
    fn are_inside(&self) -> bool {
        self.at_an_end.iter().all(|&(op, a)| match self.precise.of(a) {
            Some(Ok(Exact(r))) if op == Op::Sqrt => r >= Rational::ZERO,
            Some(Ok(Exact(r))) => r <= Rational::ONE && r >= -Rational::ONE,
            Some(Err(_)) | None => false,
        })
    }

    /// Exact values, from those of the leaves that have one: no other leaf gets one later. None, where none are computed.
    fn exactly(&mut self, graph: &Graph, exprs: &[Expr], exact: &FastMap<Leaf, Rational>) -> Vec<Option<Rational>> {
        if !self.is_exact {
            return vec![None; exprs.len()];
        }
        let new = self.precise.missing(graph, exprs);
        for &e in &new {
            if let Node::Leaf(leaf) = graph.node(e) {
                self.precise.set(e, exact.get(leaf).cloned().map(Exact).ok_or(NoValue::Unsupported));
            }
        }
        self.precise.compute(&(), graph, &new);
        exprs.iter().map(|&e| self.precise.of(e)?.ok().map(|e| e.0)).collect()
    }
}

/// The counted work of a point beside the values that are computed at it.
const OF_A_POINT: u64 = 3_000;

impl Scene<'_> {
    /// Tries one point. Most do not satisfy the premises: exact values are computed of those that do.
    pub(super) fn attempt(&self, frame: &Frame, number: u32, draws: &mut Draws) -> Option<Found> {
        let Frame { given, .. } = frame;
        meter::charge(OF_A_POINT);
        let mut computed = Computed::default();
        let before = draws.clone();
        let Placed { values, .. } = self.place(frame, &mut computed, number, draws)?;
        if given.iter().any(|l| !values.contains_key(l)) || !self.admits(&mut computed, &values) {
            return None;
        }
        // The same draws once more; what is known in decimals is not computed again.
        *draws = before;
        computed.is_exact = true;
        let placed = self.place(frame, &mut computed, number, draws)?;
        let Placed { values, exact, circles } = &placed;
        let mut found = self.sides(&mut computed, values, exact)?;
        if !computed.are_inside() {
            return None;
        }
        let point = given
            .iter()
            .filter(|l| self.generators.get(**l).is_none())
            .filter_map(|&l| {
                let &Bounded { value: decimal, error } = values.get(&l)?;
                let value = PointValue {
                    exact: exact.get(&l).cloned(),
                    circle: circles.get(&l).filter(|_| self.is_whole_angle(l)).cloned(),
                    decimal,
                    error,
                };
                Some((l, value))
            })
            .collect();
        found.point = Point { values: point };
        found.is_exact = self.is_exact(&mut computed, exact);
        found.placed = placed;
        Some(found)
    }

    /// The values of all leaves, as far as the draws and the definitions give any.
    fn place(&self, frame: &Frame, computed: &mut Computed, number: u32, draws: &mut Draws) -> Option<Placed> {
        let mut placed = Placed::default();
        let Placed { values, exact, circles } = &mut placed;
        self.draw_angles(frame, number, draws, values, circles);
        for &(leaf, chosen) in &frame.drawn {
            if values.contains_key(&leaf) {
                continue;
            }
            let declared = frame.declared.contains(&leaf);
            let mut r = if number % 3 == 2 && !declared && !chosen {
                ratio(SMALL[draws.below(10) as usize])
            } else {
                ratio(MAGNITUDES[draws.below(if number < SIMPLE { 6 } else { 10 }) as usize])
            };
            if !declared && !chosen && draws.bits() & 3 == 0 {
                r = -r;
            }
            r = frame.bounds.within(leaf, r);
            values.insert(leaf, rounded(&r)?);
            exact.insert(leaf, r);
        }
        self.signs(draws, values, exact);
        // What is solved for may depend on generators, whose arguments may depend on what is solved for.
        loop {
            let before = values.len();
            self.generate((frame, computed), values, exact, circles)?;
            self.define((frame, computed), self.defined, values, exact)?;
            self.invert_solved(frame, values, exact, circles, draws)?;
            self.define((frame, computed), self.explicit, values, exact)?;
            if values.len() == before {
                return Some(placed);
            }
        }
    }

    /// Whether a generator is the cosine of a leaf itself: cosine and sine of another part of it do not say what it is.
    fn is_whole_angle(&self, leaf: Leaf) -> bool {
        self.generators.list.iter().any(|g| match *g {
            Generator::Cosine(a) => matches!(self.graph.node(a), Node::Leaf(l) if *l == leaf),
            _ => false,
        })
    }

    fn generator_leaf(&self, at: usize) -> Option<Leaf> {
        self.generators.leaf(at)
    }

    /// Whether a leaf gets its value from a generator that is solved for.
    fn awaited(&self, leaf: Leaf) -> bool {
        self.targets.iter().any(|t| t.leaf == leaf)
    }

    /// Angles with rational half-angle tangents: their cosines and sines are rational.
    fn draw_angles(
        &self,
        frame: &Frame,
        number: u32,
        draws: &mut Draws,
        values: &mut Values,
        circles: &mut FastMap<Leaf, (Rational, Rational)>,
    ) {
        for &(ref q, leaf) in &frame.angles {
            let t = ratio(TANGENTS[draws.below(if number < SIMPLE_ANGLES { 4 } else { 12 }) as usize]);
            let square = &t * &t;
            let under = Rational::ONE + &square;
            circles.insert(leaf, ((Rational::ONE - &square) / &under, (&t + &t) / &under));
            let mut angle = rounded(&t).and_then(|t| function(|out| Number::arctan(out, &(), &t)));
            // Half of a whole turn, up or down.
            if number >= SIMPLE_ANGLES && draws.bits() & 3 == 0 {
                let half = function(|out| Number::pi(out, &()));
                let half = if draws.bits() & 1 == 0 { half } else { half.map(|pi| -pi) };
                angle = angle.zip(half).and_then(|(a, b)| function(|out| Number::add(out, &(), &a, &b)));
            }
            let factor = rounded(&(Rational::from(2) / q));
            if let (Some(angle), Some(factor)) = (angle, factor) {
                values.extend(function(|out| Number::mul(out, &(), &angle, &factor)).map(|v| (leaf, v)));
            }
        }
    }

    fn signs(&self, draws: &mut Draws, values: &mut Values, exact: &mut FastMap<Leaf, Rational>) {
        for at in 0..self.generators.list.len() {
            if let (Generator::Sign, Some(leaf)) = (&self.generators.list[at], self.generator_leaf(at))
                && !self.defined.contains_key(&leaf)
            {
                let sign = if draws.bits() & 1 == 0 { 1 } else { -1 };
                values.insert(leaf, Bounded::exact(f64::from(sign)));
                exact.insert(leaf, Rational::from(sign));
            }
        }
    }

    /// Definitions whose leaves have values; `None` when one of them has no real value.
    fn define(
        &self,
        (frame, computed): (&Frame, &mut Computed),
        definitions: &FastMap<Leaf, Expr>,
        values: &mut Values,
        exact: &mut FastMap<Leaf, Rational>,
    ) -> Option<()> {
        let mut open: Vec<(Leaf, Expr)> = definitions.iter().map(|(&l, &e)| (l, e)).collect();
        open.retain(|&(l, e)| !values.contains_key(&l) && frame.has_what_it_needs(e, values));
        open.sort_unstable();
        let exprs: Vec<Expr> = open.iter().map(|&(_, e)| e).collect();
        let decimal = computed.decimals(self.graph, &exprs, values);
        let precise = computed.exactly(self.graph, &exprs, exact);
        for ((&(leaf, _), decimal), precise) in open.iter().zip(decimal).zip(precise) {
            values.insert(leaf, decimal?);
            exact.extend(precise.map(|r| (leaf, r)));
        }
        Some(())
    }

    /// Values of the generators that are not solved for and whose arguments have values.
    fn generate(
        &self,
        (frame, computed): (&Frame, &mut Computed),
        values: &mut Values,
        exact: &mut FastMap<Leaf, Rational>,
        circles: &FastMap<Leaf, (Rational, Rational)>,
    ) -> Option<()> {
        for at in 0..self.generators.list.len() {
            let Some(leaf) = self.generator_leaf(at) else { continue };
            if self.defined.contains_key(&leaf) || values.contains_key(&leaf) {
                continue;
            }
            let argument = match self.generators.list[at] {
                Generator::Cosine(a) | Generator::Sine(a) | Generator::Exponential(a) | Generator::Opaque(a) => a,
                Generator::Sign | Generator::Half | Generator::Free => continue,
            };
            if !frame.has_what_it_needs(argument, values) {
                continue;
            }
            let value = computed.decimals(self.graph, &[argument], values)[0]?;
            let value = match self.generators.list[at] {
                Generator::Cosine(_) => function(|out| Number::cos(out, &(), &value)),
                Generator::Sine(_) => function(|out| Number::sin(out, &(), &value)),
                Generator::Exponential(_) => function(|out| Number::exp(out, &(), &value)),
                _ => Some(value),
            };
            values.insert(leaf, value?);
            let multiple = frame.multiples.get(&argument).and_then(Option::as_ref);
            let rational = multiple.and_then(|(_, l)| circles.get(l));
            match (&self.generators.list[at], rational) {
                (Generator::Cosine(_), Some((c, _))) => drop(exact.insert(leaf, c.clone())),
                (Generator::Sine(_), Some((_, s))) => drop(exact.insert(leaf, s.clone())),
                _ => {}
            }
        }
        Some(())
    }

    /// Angles whose cosine and sine, and exponents whose exponential, were solved for.
    fn invert_solved(
        &self,
        frame: &Frame,
        values: &mut Values,
        exact: &FastMap<Leaf, Rational>,
        circles: &mut FastMap<Leaf, (Rational, Rational)>,
        draws: &mut Draws,
    ) -> Option<()> {
        for at in 0..self.generators.list.len() {
            let Some(leaf) = self.generator_leaf(at) else { continue };
            let (argument, circle) = match self.generators.list[at] {
                Generator::Cosine(a) => (a, true),
                Generator::Exponential(a) => (a, false),
                _ => continue,
            };
            let sine = self.generators.leaf(at + 1);
            let solved = |l: Option<Leaf>| l.is_some_and(|l| self.defined.contains_key(&l));
            if !(solved(Some(leaf)) || circle && solved(sine)) {
                continue;
            }
            let target = self.targets.iter().find(|t| t.generator == at)?;
            if values.contains_key(&target.leaf) {
                continue;
            }
            // The argument where the leaf is 1.
            let one = rounded(&Rational::ONE)?;
            values.insert(target.leaf, one);
            let unit = match frame.has_what_it_needs(argument, values) {
                true => decimals(self.graph, &[argument], values)[0],
                false => None,
            };
            values.remove(&target.leaf);
            let Some(unit) = unit else { continue };
            let mut inverse = if circle {
                let (Some(&c), Some(&s)) = (values.get(&leaf), values.get(&sine?)) else { continue };
                if let (Some(c), Some(s)) = (exact.get(&leaf), exact.get(&sine?)) {
                    circles.insert(target.leaf, (c.clone(), s.clone()));
                }
                // Either end of the cut is an angle with this cosine and sine.
                function(|out| Number::arctan2(out, &(), &s, &c))
            } else {
                let Some(e) = values.get(&leaf) else { continue };
                function(|out| Number::ln(out, &(), e))
            };
            // Every angle with this cosine and sine is one.
            if circle && draws.bits() & 3 == 0 {
                let turn = function(|out| Number::pi(out, &()));
                let turns = Bounded::exact(if draws.bits() & 1 == 0 { 2.0 } else { -2.0 });
                let turned = turn.and_then(|pi| function(|out| Number::mul(out, &(), &turns, &pi)));
                inverse = turned.zip(inverse).and_then(|(t, a)| function(|out| Number::add(out, &(), &a, &t)));
            }
            let inverse = inverse?;
            let (above, below) = if target.power > 0 { (inverse, unit) } else { (unit, inverse) };
            values.insert(target.leaf, function(|out| Number::div(out, &(), &above, &below))?);
        }
        Some(())
    }

    /// Whether the premises hold at a point, as far as the bounds tell, and these are small.
    fn admits(&self, computed: &mut Computed, values: &Values) -> bool {
        let sides: Vec<Expr> = self.premises.iter().flat_map(|&(l, r)| [l, r]).collect();
        let equal = computed.decimals(self.graph, &sides, values).chunks(2).all(|pair| match pair {
            &[Some(l), Some(r)] => {
                let error = l.error + r.error;
                (l.value - r.value).abs() <= error && error <= 1e-6 * l.value.abs().max(1.0)
            }
            _ => false,
        });
        equal && self.has_facts(computed, values)
    }

    /// Whether what is given beside equations holds at a point for certain.
    fn has_facts(&self, computed: &mut Computed, values: &Values) -> bool {
        let nonzero = computed.decimals(self.graph, self.nonzero, values);
        let positive = computed.decimals(self.graph, self.positive, values);
        let not_negative = computed.decimals(self.graph, self.not_negative, values);
        not_negative.iter().all(|v| v.is_some_and(|v| v.value >= v.error))
            && nonzero.iter().all(|v| v.is_some_and(|v| !v.contains_zero()))
            && positive.iter().all(|v| v.is_some_and(|v| v.value > v.error))
    }

    fn sides(&self, computed: &mut Computed, values: &Values, exact: &FastMap<Leaf, Rational>) -> Option<Found> {
        let exprs: Vec<Expr> = self.claim.iter().flat_map(|&(l, r)| [l, r]).collect();
        let given = computed.decimals(self.graph, &exprs, values);
        let exprs: Vec<Expr> = self.lowered.iter().flat_map(|&(l, r)| [l, r]).collect();
        let precise = computed.exactly(self.graph, &exprs, exact);
        let mut found = Found::default();
        for (at, pair) in given.chunks(2).enumerate() {
            let &[Some(left), Some(right)] = pair else { return None };
            let (l, r) = (precise[2 * at].clone(), precise[2 * at + 1].clone());
            // The exact value of the lowered formula must be one that the formula as given may have.
            let fits = |e: &Option<Rational>, d: Bounded| {
                e.as_ref()
                    .is_none_or(|e| rounded(e).is_some_and(|e| (e.value - d.value).abs() <= 2.0 * (e.error + d.error)))
            };
            if !fits(&l, left) || !fits(&r, right) {
                return None;
            }
            let error = left.error + right.error;
            let apart = (left.value - right.value).abs() > 4.0 * error;
            let differs = match (&l, &r) {
                (Some(l), Some(r)) => l != r,
                _ => apart,
            };
            if differs && found.differs.is_none() {
                (found.differs, found.is_apart) = (Some(at), apart);
            }
            found.sides.push((Side { exact: l, decimal: left.value }, Side { exact: r, decimal: right.value }));
        }
        Some(found)
    }
}

/// The result of an operation, if it has one.
fn function(f: impl FnOnce(&mut Bounded) -> Result<(), NoValue>) -> Option<Bounded> {
    let mut out = Bounded::exact(0.0);
    f(&mut out).ok()?;
    Some(out)
}

/// The refutation from points found: the first exact one, or the first; with a second point whose sides differ otherwise.
pub(super) fn refutation(found: &[Found]) -> Option<Refutation> {
    let refuting = || found.iter().filter(|f| f.differs.is_some());
    let is_exact =
        |f: &&Found| f.differs.is_some_and(|at| f.sides[at].0.exact.is_some() && f.sides[at].1.exact.is_some());
    let best = refuting().find(is_exact).or_else(|| refuting().next())?;
    let equation = best.differs?;
    let gap = |f: &Found| f.sides[equation].0.decimal - f.sides[equation].1.decimal;
    let second = found
        .iter()
        .find(|f| (gap(f) - gap(best)).abs() > 1e-6 * gap(best).abs())
        .map(|f| (f.point.clone(), f.sides[equation].0.clone(), f.sides[equation].1.clone()));
    let (left, right) = best.sides[equation].clone();
    Some(Refutation { equation, point: best.point.clone(), named: Vec::new(), left, right, second })
}

/// The first of these expressions that may vanish at a point; what has no value there counts as not vanishing.
pub(super) fn vanishing(graph: &Graph, exprs: &[Expr], point: &Point) -> Option<Expr> {
    let at = decimals(graph, exprs, &values_at(point));
    exprs.iter().zip(at).find_map(|(&e, v)| v.is_some_and(|v| v.contains_zero()).then_some(e))
}

/// The values at a point, with their rounding.
pub(super) fn values_at(point: &Point) -> Values {
    let value = |&(leaf, ref v): &(Leaf, PointValue)| {
        let rounding = v.decimal.abs() * 8.0 * f64::EPSILON;
        let exact = v.exact.as_ref().and_then(rounded);
        (leaf, exact.unwrap_or(Bounded { value: v.decimal, error: rounding.max(v.error) }))
    };
    point.values.iter().map(value).collect()
}
