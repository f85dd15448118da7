//! What formulas are on a motion that is given by polynomials, piece by piece.
//!
//! **In:** formulas of a derivation, and polynomials for what moves. **Out:** their [values](super::value) on the pieces of a span.
//! **Guaranteed:** a rate is that of the function: at the end of two pieces it is there where the function does not leap and both sides have
//! the same slope; a value that is not known exactly is none.

use super::clock::read;
use super::polynomial::{Fraction, Polynomial};
use super::value::{Cell, Found, Stop, Value, apply, plain};
use crate::derivation::Derivation;
use crate::expr::{Expr, FastMap, Leaf, Node, Op, Rational, Symbol};
use crate::latex::Scope;

/// A function of the time by pieces: each polynomial up to its time, the last one from there on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Course {
    pub(super) pieces: Vec<(Rational, Polynomial)>,
    pub(super) last: Polynomial,
}

impl Course {
    pub(super) fn polynomial(p: Polynomial) -> Course {
        Course { pieces: Vec::new(), last: p }
    }

    /// The polynomial of a piece of time that no break parts.
    fn on(&self, inside: &Rational) -> &Polynomial {
        self.pieces.iter().find(|(until, _)| inside < until).map_or(&self.last, |(_, p)| p)
    }

    /// Whether it and its derivatives up to an order do not leap.
    pub(super) fn is_smooth(&self, order: u8) -> bool {
        let next = self.pieces.iter().skip(1).map(|(_, p)| p).chain([&self.last]);
        self.pieces.iter().zip(next).all(|((at, p), q)| {
            let mut difference = p.sub(q);
            (0..=order).all(|_| {
                let same = difference.at(at) == Rational::ZERO;
                difference = difference.derivative();
                same
            })
        })
    }

    /// As formulas of the time, which has this name.
    pub(super) fn shown(&self, time: &str) -> String {
        let mut out: Vec<String> =
            self.pieces.iter().map(|(until, p)| format!("{} until {time} = {until}", p.shown(time))).collect();
        match out.is_empty() {
            true => self.last.shown(time),
            false => {
                out.push(format!("then {}", self.last.shown(time)));
                out.join(", ")
            }
        }
    }
}

/// The most breaks of a span.
const MOST_BREAKS: usize = 12;
/// The counted work of a value that is a polynomial in the time.
const OF_A_NODE: u64 = 1_000;

/// The largest formula that is put in, in nodes.
const MOST_NODES: usize = 300;

/// A motion, as far as it is chosen.
pub(super) struct Scene<'a> {
    pub(super) derivation: &'a Derivation,
    pub(super) scope: &'a Scope,
    /// What plays the time.
    pub(super) clock: Option<Leaf>,
    /// The ends of the span, which do not belong to it.
    pub(super) span: (Rational, Rational),
    /// Times at which something may change, increasing.
    breaks: Vec<Rational>,
    /// The pieces between these, and these.
    cells: Vec<Cell>,
    pub(super) courses: FastMap<(Symbol, u16), Course>,
    pub(super) constants: FastMap<(Symbol, u16), Rational>,
    /// What ± is.
    pub(super) sign: std::cell::Cell<i64>,
    /// So many operations were carried out.
    work: std::cell::Cell<usize>,
}

impl<'a> Scene<'a> {
    pub(super) fn new(
        derivation: &'a Derivation,
        (scope, clock): (&'a Scope, Option<Leaf>),
        span: (Rational, Rational),
    ) -> Scene<'a> {
        let cells = vec![Cell::Open(span.0.clone(), span.1.clone())];
        let (courses, constants) = (FastMap::default(), FastMap::default());
        let (sign, work) = (std::cell::Cell::new(1), std::cell::Cell::new(0));
        Scene { derivation, scope, clock, span, breaks: Vec::new(), cells, courses, constants, sign, work }
    }

    /// How many operations were carried out.
    pub(super) fn work(&self) -> usize {
        self.work.get()
    }

    pub(super) fn cells(&self) -> &[Cell] {
        &self.cells
    }

    pub(super) fn breaks(&self) -> &[Rational] {
        &self.breaks
    }

    /// Forgets all breaks but the first ones.
    pub(super) fn join(&mut self, breaks: Vec<Rational>) {
        self.breaks = breaks;
        self.refresh();
    }

    fn refresh(&mut self) {
        let ends = std::iter::once(&self.span.0).chain(&self.breaks);
        let next = self.breaks.iter().chain([&self.span.1]);
        self.cells.clear();
        for (low, high) in ends.zip(next) {
            self.cells.push(Cell::Open(low.clone(), high.clone()));
            self.cells.push(Cell::At(high.clone()));
        }
        self.cells.pop();
    }

    /// Adds a time at which something may change; whether there is room.
    pub(super) fn part(&mut self, t: Rational) -> bool {
        match self.breaks.binary_search(&t) {
            Ok(_) => true,
            Err(at) => {
                let room = self.breaks.len() < MOST_BREAKS && t > self.span.0 && t < self.span.1;
                if room {
                    self.breaks.insert(at, t);
                    self.refresh();
                }
                room
            }
        }
    }

    /// The formula of a component that has one.
    pub(super) fn definition(&self, leaf: Leaf) -> Option<Expr> {
        definition(self.derivation, self.scope, leaf)
    }

    /// The value of a formula on a piece.
    pub(super) fn value(&self, e: Expr, cell: usize) -> Found {
        let graph = &self.derivation.graph;
        let place = self.cells.get(cell).ok_or(Stop::Unknown)?;
        let order = graph.reachable([e]);
        if order.len() > MOST_NODES {
            return Err(Stop::Unknown);
        }
        self.work.set(self.work.get() + order.len());
        meter::charge(OF_A_NODE * order.len() as u64);
        let mut known: FastMap<Expr, Found> = FastMap::default();
        for node in order {
            let restricts = |op: &Op| *op == Op::Restrict;
            let of = |e: &Expr| known.get(e).cloned().unwrap_or(Err(Stop::Unknown));
            let found = match graph.node(node) {
                Node::Constant(r) => Ok(plain(Fraction::constant(Rational::clone(r)))),
                Node::Pi => Ok(Value::Plain(Fraction::constant(Rational::ONE), 1)),
                Node::Leaf(leaf) => self.leaf(*leaf, cell, place),
                Node::Unary(op, a) => of(a).and_then(|a| apply(*op, &a, None, place)),
                Node::Binary(op, a, b) => match (of(a), of(b)) {
                    (Ok(a), Ok(b)) => apply(*op, &a, Some(&b), place),
                    (_, Err(part @ Stop::Part(_))) | (Err(part @ Stop::Part(_)), _) => Err(part),
                    (_, Err(Stop::Void)) => Err(Stop::Void),
                    (Err(Stop::Void), _) if !restricts(op) => Err(Stop::Void),
                    _ => Err(Stop::Unknown),
                },
            };
            if let Err(Stop::Part(_)) = found {
                return found;
            }
            known.insert(node, found);
        }
        known.remove(&e).unwrap_or(Err(Stop::Unknown))
    }

    fn leaf(&self, leaf: Leaf, cell: usize, place: &Cell) -> Found {
        let leaf = read(&self.derivation.graph, leaf);
        if let Some(instant) = leaf.instant {
            let Value::Plain(at, 0) = self.value(instant, cell)? else { return Err(Stop::Unknown) };
            let at = at.as_constant().ok_or(Stop::Unknown)?;
            let Ok(number) = self.breaks.binary_search(&at) else {
                let inside = at > self.span.0 && at < self.span.1;
                return Err(if inside { Stop::Part(at) } else { Stop::Unknown });
            };
            let then = 2 * number + 1;
            return self.leaf(Leaf { instant: None, ..leaf }, then, &Cell::At(at));
        }
        let graph = &self.derivation.graph;
        if Some(leaf) == self.clock {
            return Ok(plain(match place {
                Cell::Open(..) => Fraction::of(Polynomial::integers(&[0, 1])),
                Cell::At(t) => Fraction::constant(t.clone()),
            }));
        }
        if self.scope.branch_sign() == leaf {
            return Ok(plain(Fraction::constant(Rational::from(self.sign.get()))));
        }
        let component = (leaf.symbol, leaf.component);
        if !leaf.partials.is_none() || graph.place(leaf.symbol).is_some() || graph.coordinate(leaf).is_some() {
            return Err(Stop::Unknown);
        }
        if let Some(c) = self.constants.get(&component) {
            return if leaf.rate == 0 { Ok(plain(Fraction::constant(c.clone()))) } else { Err(Stop::Unknown) };
        }
        if let Some(course) = self.courses.get(&component) {
            let mut p = course.on(&place.inside()).clone();
            for _ in 0..leaf.rate {
                p = p.derivative();
            }
            return Ok(plain(match place {
                Cell::Open(..) => Fraction::of(p),
                Cell::At(t) => Fraction::constant(p.at(t)),
            }));
        }
        if self.derivation.is_angle(leaf.symbol) || graph.is_field(leaf.symbol) {
            return Err(Stop::Unknown);
        }
        let formula = self.definition(leaf).ok_or(Stop::Unknown)?;
        self.rate(formula, leaf.rate, cell)
    }

    /// The value of a rate of a formula on a piece.
    fn rate(&self, e: Expr, order: u8, cell: usize) -> Found {
        if order == 0 {
            return self.value(e, cell);
        }
        let lower = |cell: usize| match self.rate(e, order - 1, cell)? {
            Value::Plain(f, k) => Ok((f, k)),
            Value::Wave { .. } | Value::Root(..) => Err(Stop::Unknown),
        };
        let (f, k) = lower(cell)?;
        let made = |f: Fraction, k: i32| {
            let turns = if f.is_zero() { 0 } else { k };
            Value::Plain(f, turns)
        };
        let Some(Cell::At(t)) = self.cells().get(cell).cloned() else {
            return f.derivative().map(|d| made(d, k)).ok_or(Stop::Unknown);
        };
        // Beyond a time without a value there may be one side only.
        let unless_void = |stop| if stop == Stop::Void { Stop::Unknown } else { stop };
        let mut slopes = Vec::new();
        for beside in [cell.wrapping_sub(1), cell + 1] {
            let (g, l) = lower(beside).map_err(unless_void)?;
            let limit = g.at(&t).ok_or(Stop::Unknown)?;
            let same = f.as_constant() == Some(limit.clone()) && (k == l || limit == Rational::ZERO);
            if !same {
                return Err(Stop::Void);
            }
            let slope = g.derivative().and_then(|d| d.at(&t)).ok_or(Stop::Unknown)?;
            slopes.push(made(Fraction::constant(slope), l));
        }
        match slopes.as_slice() {
            [before, after] if before == after => Ok(after.clone()),
            _ => Err(Stop::Void),
        }
    }
}

/// The formula of a component that has one: that of the claim, of the file, or of another claim that declares it.
pub(super) fn definition(derivation: &Derivation, scope: &Scope, leaf: Leaf) -> Option<Expr> {
    let found = scope.definition(leaf.symbol).or_else(|| derivation.definition(leaf.symbol))?;
    found.components.get(usize::from(leaf.component)).copied()
}
