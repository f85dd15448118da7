//! The unit of every node of the graph.

use std::collections::{BTreeMap, HashMap};

use super::Term;
use derivation::Unit;
use expr::{Expr, Graph, Leaf, Node, Op, Rational, Symbol};

/// What is known of the unit of an expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum State {
    /// It is 0, which agrees with every unit.
    Zero,
    /// It has this unit.
    Known(Unit),
    /// A symbol in it has no unit.
    Unknown,
}

/// What is wrong at a node.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Fault {
    /// Quantities of two kinds.
    Different { relation: String, terms: Box<[Term; 2]> },
    /// Quantities of one kind, in units of different size.
    Scale { relation: String, terms: Box<[Term; 2]> },
}

/// The units of the symbols, and of every expression that was asked for.
pub(super) struct Inference<'g> {
    graph: &'g Graph,
    time: Option<Leaf>,
    sign: Leaf,
    /// The unit of the time; `None` if it has none.
    seconds: Option<Unit>,
    symbols: BTreeMap<Symbol, Vec<State>>,
    states: HashMap<Expr, State>,
    faults: HashMap<Expr, Fault>,
}

impl<'g> Inference<'g> {
    pub fn new(graph: &'g Graph, time: Option<Leaf>, sign: Leaf) -> Inference<'g> {
        let (symbols, states, faults) = (BTreeMap::new(), HashMap::new(), HashMap::new());
        Inference { graph, time, sign, seconds: None, symbols, states, faults }
    }

    /// Gives the time its unit.
    pub fn set_time(&mut self, unit: Option<Unit>) {
        self.seconds = unit;
    }

    /// Gives a symbol its unit.
    pub fn declare(&mut self, symbol: Symbol, unit: Option<Unit>) {
        let state = unit.map_or(State::Unknown, State::Known);
        self.symbols.insert(symbol, vec![state; self.graph.component_count(symbol)]);
    }

    /// Gives the components of a symbol their units.
    pub fn define(&mut self, symbol: Symbol, states: Vec<State>) {
        self.symbols.insert(symbol, states);
    }

    /// The unit of a leaf.
    pub fn leaf_state(&self, leaf: Leaf) -> State {
        if leaf == self.sign {
            return State::Known(Unit::one());
        }
        let own = match self.time {
            Some(time) if time.symbol == leaf.symbol => self.seconds.clone().map_or(State::Unknown, State::Known),
            _ => {
                let states = self.symbols.get(&self.graph.field_of(leaf.symbol));
                states.and_then(|s| s.get(usize::from(leaf.component))).cloned().unwrap_or(State::Unknown)
            }
        };
        let own = self.graph.coordinates().zip(leaf.partials.orders()).filter(|(_, n)| *n > 0).fold(
            own,
            |own, (coordinate, n)| match (own, self.leaf_state(coordinate)) {
                (State::Known(unit), State::Known(by)) => State::Known(unit.over(&by.power(&Rational::from(n)))),
                (State::Zero, _) => State::Zero,
                _ => State::Unknown,
            },
        );
        match (own, leaf.rate, &self.seconds) {
            (own, 0, _) => own,
            (State::Known(unit), n, Some(t)) => State::Known(unit.over(&t.power(&Rational::from(n)))),
            (State::Zero, ..) => State::Zero,
            _ => State::Unknown,
        }
    }

    /// The unit of an expression. Faults inside are remembered.
    pub fn state(&mut self, e: Expr) -> State {
        if let Some(state) = self.states.get(&e) {
            return state.clone();
        }
        for node in self.graph.reachable([e]) {
            if !self.states.contains_key(&node) {
                let (state, fault) = self.node(node);
                self.states.insert(node, state);
                if let Some(fault) = fault {
                    self.faults.insert(node, fault);
                }
            }
        }
        self.states.get(&e).cloned().unwrap_or(State::Unknown)
    }

    fn known(&self, e: Expr) -> State {
        if self.graph.is_zero(e) { State::Zero } else { self.states.get(&e).cloned().unwrap_or(State::Unknown) }
    }

    /// One node whose arguments are done.
    fn node(&mut self, e: Expr) -> (State, Option<Fault>) {
        let one = || State::Known(Unit::one());
        match self.graph.node(e).clone() {
            Node::Constant(r) if *r == Rational::ZERO => (State::Zero, None),
            Node::Constant(_) | Node::Pi => (one(), None),
            Node::Leaf(leaf) => {
                let fault = leaf.instant.and_then(|at| self.instant(at)).or_else(|| self.placed(leaf.symbol));
                (self.leaf_state(leaf), fault)
            }
            Node::Unary(op, a) => {
                let own = self.known(a);
                match op {
                    Op::Neg | Op::Abs => (own, None),
                    Op::Sqrt => (raised(own, &(Rational::ONE / Rational::from(2))), None),
                    Op::Powi(0) => (one(), None),
                    Op::Powi(n) => (raised(own, &Rational::from(n)), None),
                    _ => {
                        let fault = self.is_number(a, &own, &format!("is the argument of {}", op.spelling()));
                        (one(), fault)
                    }
                }
            }
            Node::Binary(op, a, b) => {
                let (x, y) = (self.known(a), self.known(b));
                match op {
                    Op::Add | Op::Sub => self.same(a, b, "are added"),
                    Op::Mul => match (x, y) {
                        (State::Zero, _) | (_, State::Zero) => (State::Zero, None),
                        (State::Known(x), State::Known(y)) => (State::Known(x.times(&y)), None),
                        _ => (State::Unknown, None),
                    },
                    Op::Div => match (x, y) {
                        (State::Zero, _) | (_, State::Zero) => (State::Zero, None),
                        (State::Known(x), State::Known(y)) => (State::Known(x.over(&y)), None),
                        _ => (State::Unknown, None),
                    },
                    Op::Pow => match self.graph.as_constant(b).cloned() {
                        Some(power) => (raised(x, &power), None),
                        None => {
                            let exponent = self.is_number(b, &y, "is an exponent");
                            let base = self.is_number(a, &x, "is raised to a power that is not a fixed number");
                            (one(), exponent.or(base))
                        }
                    },
                    Op::Arctan2 | Op::DirectionCosine => {
                        (one(), self.same(a, b, r"are the arguments of \operatorname{atan2}").1)
                    }
                    Op::Agm => self.same(a, b, r"are the arguments of \operatorname{agm}"),
                    Op::Restrict => (x, None),
                    // The table has no other operation of two arguments.
                    _ => (State::Unknown, None),
                }
            }
        }
    }

    /// The common unit of two terms, and the fault where they have none.
    fn same(&self, a: Expr, b: Expr, relation: &str) -> (State, Option<Fault>) {
        match (self.known(a), self.known(b)) {
            (State::Known(x), State::Known(y)) if x != y => {
                let fault = Fault::between(relation, (self.term(a), &x), (self.term(b), &y));
                (State::Known(x), Some(fault))
            }
            (State::Zero, other) | (other, State::Zero) => (other, None),
            // If the formula is right, a term without a unit has that of the other.
            (State::Unknown, other) => (other, None),
            (other, _) => (other, None),
        }
    }

    /// The fault where something that must be a number is none.
    fn is_number(&self, e: Expr, state: &State, relation: &str) -> Option<Fault> {
        match state {
            State::Known(unit) if *unit != Unit::one() => {
                let number = ("a number".to_owned(), &Unit::one());
                Some(Fault::between(relation, (self.term(e), unit), number))
            }
            _ => None,
        }
    }

    /// The fault where a time is none; a mere number is taken in the unit of the time.
    pub fn instant(&mut self, at: Expr) -> Option<Fault> {
        if self.graph.leaves([at]).is_empty() {
            return None;
        }
        let (Some(seconds), State::Known(unit)) = (self.seconds.clone(), self.state(at)) else { return None };
        let time = self.time.map_or("t".to_owned(), |t| self.graph.leaf_latex(t));
        (unit != seconds).then(|| Fault::between("is put for", (self.term(at), &unit), (time, &seconds)))
    }

    /// The fault where something is put for a coordinate that has another unit; a mere number is taken in that of the coordinate.
    fn placed(&mut self, symbol: Symbol) -> Option<Fault> {
        let place = self.graph.place(symbol)?;
        let coordinates: Vec<Leaf> = self.graph.coordinates().collect();
        place.at.iter().find_map(|&(position, e)| {
            let coordinate = *coordinates.get(position)?;
            if self.graph.leaves([e]).is_empty() {
                return None;
            }
            let (State::Known(own), State::Known(unit)) = (self.leaf_state(coordinate), self.state(e)) else {
                return None;
            };
            let name = self.graph.leaf_latex(coordinate);
            (unit != own).then(|| Fault::between("is put for", (self.term(e), &unit), (name, &own)))
        })
    }

    /// The fault between two sides.
    pub fn compared(&mut self, left: Expr, right: Expr) -> Option<Fault> {
        let _ = (self.state(left), self.state(right));
        self.same(left, right, "are compared").1
    }

    /// The first fault inside expressions.
    pub fn fault(&mut self, exprs: &[Expr]) -> Option<Fault> {
        for &e in exprs {
            let _ = self.state(e);
        }
        let all: Vec<&Fault> =
            self.graph.reachable(exprs.iter().copied()).iter().filter_map(|e| self.faults.get(e)).collect();
        let different = all.iter().find(|f| matches!(f, Fault::Different { .. }));
        different.or(all.first()).map(|f| (*f).clone())
    }

    /// Names of the symbols in expressions that have no unit.
    pub fn without_unit(&self, exprs: &[Expr]) -> Vec<String> {
        let mut out: Vec<String> = Vec::new();
        let leaves = self.graph.leaves_within(exprs.iter().copied());
        let instants = leaves.iter().filter_map(|l| l.instant).flat_map(|at| self.graph.leaves([at]));
        for leaf in leaves.iter().copied().chain(instants) {
            let unknown = self.leaf_state(leaf) == State::Unknown;
            let time = self.time.filter(|_| leaf.rate > 0 && self.seconds.is_none());
            let symbol = time.map_or(leaf.symbol, |t| t.symbol);
            let name = self.graph.name(self.graph.field_of(symbol));
            if unknown && !out.iter().any(|n| n == name) {
                out.push(name.to_owned());
            }
        }
        out
    }

    /// The term of a sum that has its unit, in LaTeX: the whole sum says less, and more than one can read.
    pub fn term(&self, e: Expr) -> String {
        let mut at = e;
        while let Node::Binary(Op::Add | Op::Sub, a, b) = *self.graph.node(at) {
            at = if self.known(a) == self.known(e) { a } else { b };
        }
        self.graph.to_latex(at)
    }
}

fn raised(state: State, power: &Rational) -> State {
    match state {
        State::Known(unit) => State::Known(unit.power(power)),
        other => other,
    }
}
