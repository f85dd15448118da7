//! Elimination: facts are solved one after the other, and put into what is to vanish.
//!
//! **In:** an expression, and the facts of an [`Attempt`]. **Out:** the steps that show that it is 0, or nothing. **Guaranteed:** bounded: so many rounds, so many nodes.

use crate::eliminate::{MOST_NODES, Solved};
use crate::prove::Attempt;
use checker::{FactId, Law, Relation, SymbolKind, Term};
use expr::{Expr, Leaf, Node, Op, Rational};

/// Most rounds of elimination.
const MOST_ROUNDS: usize = 120;
/// Largest fact that is divided by, in nodes, and most of them.
const LARGEST_DIVISOR: usize = 120;
const MOST_DIVISORS: usize = 24;
/// The work of a division by facts.
const DIVISION: usize = 60_000;
/// The work of a test for an identity, beside its nodes.
const IDENTITY: usize = 2_000;

/// What a fact is solved for: a rate now, a value now, a value at a fixed time, a constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    Rate,
    Value,
    Fixed,
    Constant,
}

/// What is divided by: a number, a constant, something that moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Divisor {
    Number,
    Constant,
    Moving,
}

/// A way to solve a fact for a leaf: the less, the better. The highest rate goes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Cost {
    divisor: Divisor,
    kind: Kind,
    lower: u8,
    /// Other rates that come in.
    rates: usize,
    nodes: usize,
}

/// A fact l = r that is not solved yet: e = l − r, with what is solved put in.
pub(crate) struct Open {
    pub(crate) fact: FactId,
    pub(crate) e: Expr,
}

/// What is divided by: laws of functions, or facts, too.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Depth {
    Laws,
    Facts,
}

/// The order of a derivative.
pub(crate) fn order(leaf: Leaf) -> u8 {
    leaf.rate.saturating_add(u8::try_from(leaf.partials.order()).unwrap_or(u8::MAX))
}

/// What is put in before facts are solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beginning {
    /// Nothing.
    Plain,
    /// Sides of facts that stand as they are in other formulas, as the formulas of definitions do.
    Wholes,
}

impl Attempt<'_> {
    /// The claim `says`, whose sides differ by `goal`, as far as facts can be solved: first for what they say without dividing by anything that moves.
    pub(crate) fn algebra(&mut self, says: &Relation, goal: Expr, beginning: Beginning) -> Option<FactId> {
        self.search.solved.clear();
        let mut rest: Vec<Open> = Vec::new();
        for &fact in &self.facts.clone() {
            let Some((l, r)) = self.search.equation(fact) else { continue };
            rest.push(Open { fact, e: self.search.reader.graph.sub(l, r) });
        }
        let mut e = goal;
        if beginning == Beginning::Wholes {
            self.put_in_wholes(&mut e, &mut rest)?;
        }
        self.normalise(&mut e, &mut rest)?;
        self.unit_roots(&mut e, &mut rest)?;
        for divisor in [Divisor::Number, Divisor::Constant, Divisor::Moving] {
            if divisor == Divisor::Constant {
                if let Some(found) = self.vanishes(says, e, &rest, Depth::Facts) {
                    return Some(found);
                }
                if let Some(found) = self.complete(says, e, &rest) {
                    return Some(found);
                }
                self.solve_block(&mut e, &mut rest)?;
            }
            if divisor == Divisor::Moving
                && let Some(found) = self.complete(says, e, &rest)
            {
                return Some(found);
            }
            for kind in [Kind::Rate, Kind::Value, Kind::Fixed, Kind::Constant] {
                if let Some(found) = self.vanishes(says, e, &rest, Depth::Laws) {
                    return Some(found);
                }
                for _ in 0..MOST_ROUNDS {
                    let leaves = self.search.reader.graph.leaves([e]);
                    let Some((at, leaf)) = self.best(&rest, &leaves, divisor, kind) else { break };
                    let open = rest.remove(at);
                    let Some(solved) = self.solve(&open, leaf) else { continue };
                    if !self.search.put_in(&mut e, solved) {
                        return None;
                    }
                    rest.retain_mut(|open| self.search.put_in(&mut open.e, solved));
                }
            }
        }
        self.normalise(&mut e, &mut [])?;
        self.vanishes(says, e, &rest, Depth::Laws)
    }

    /// Puts one side of a fact for the other where that is a formula which stands in what is to vanish.
    fn put_in_wholes(&mut self, e: &mut Expr, rest: &mut Vec<Open>) -> Option<()> {
        let mut sides = vec![*e];
        if let Node::Binary(Op::Sub, a, b) = *self.search.reader.graph.node(*e) {
            sides.extend([a, b]);
        }
        for _ in 0..MOST_ROUNDS {
            let graph = &self.search.reader.graph;
            let below = graph.reachable([*e]);
            let is_whole = |x: &Expr| matches!(graph.node(*x), Node::Unary(..) | Node::Binary(..)) && below.contains(x);
            // A side of what is claimed goes in first, then the smallest.
            let mut found: Option<(bool, usize, usize, Expr, Expr)> = None;
            for (at, open) in rest.iter().enumerate() {
                let Some((l, r)) = self.search.sides_of.get(&open.fact).copied() else { continue };
                let size = |x: Expr| graph.reachable([x]).len();
                for (from, to) in [(l, r), (r, l)] {
                    if is_whole(&from) && !graph.reachable([to]).contains(&from) {
                        found = found.into_iter().chain([(!sides.contains(&from), size(to), at, from, to)]).min();
                    }
                }
            }
            let found = found.map(|(_, _, at, from, to)| (at, from, to));
            let Some((at, from, to)) = found else { break };
            let open = rest.remove(at);
            let says = self.search.reader.equation(from, to)?;
            let inserted = std::mem::take(&mut self.search.solved);
            let one = self.search.reader.graph.integer(1);
            let minus = self.search.reader.graph.integer(-1);
            let fact = [one, minus]
                .into_iter()
                .find_map(|sign| self.search.zero(says.clone(), None, &[(open.fact, sign)], &[]));
            self.search.solved = inserted;
            let Some(fact) = fact else { continue };
            self.search.solved.push(fact);
            let solved = Solved { node: from, value: to };
            self.search.put_in(e, solved).then_some(())?;
            rest.retain_mut(|open| self.search.put_in(&mut open.e, solved));
        }
        Some(())
    }

    /// The claim, if the expression vanishes as it stands, or divided by laws of the functions in it and by facts of a higher degree.
    fn vanishes(&mut self, says: &Relation, e: Expr, rest: &[Open], depth: Depth) -> Option<FactId> {
        self.search.work += IDENTITY + self.search.reader.graph.reachable([e]).len() * 10;
        if self.search.is_spent() {
            return None;
        }
        let found = self.search.zero(says.clone(), None, &[], &[]);
        if found.is_some() || self.search.reader.graph.is_zero(e) {
            return found;
        }
        let laws = self.laws(e);
        if laws.is_empty() && rest.is_empty() {
            return None;
        }
        let found = self.search.zero(says.clone(), None, &[], &laws);
        if found.is_some() || depth == Depth::Laws {
            return found;
        }
        self.search.work += DIVISION;
        let facts = self.of_higher_degree(e, rest);
        if facts.is_empty() { None } else { self.search.zero(says.clone(), None, &[], &[facts, laws].concat()) }
    }

    /// Laws of the functions below an expression that say something of their powers, each with the node in which it divides: those of what stands inside first.
    pub(crate) fn laws(&mut self, e: Expr) -> Vec<FactId> {
        let mut out = Vec::new();
        for node in self.search.reader.graph.reachable([e]) {
            let (law, argument) = match *self.search.reader.graph.node(node) {
                Node::Unary(Op::Cos, a) => (Law::Pythagoras, a),
                Node::Unary(Op::Sqrt, a) => (Law::SquareOfRoot, a),
                Node::Unary(Op::Abs, a) => (Law::SquareOfAbsolute, a),
                Node::Unary(Op::Exp, _) => {
                    out.extend(self.root_of_argument(node));
                    continue;
                }
                Node::Binary(Op::Pow, base, exponent) => {
                    out.extend(self.power_of_root(base, exponent));
                    continue;
                }
                Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => continue,
            };
            out.extend(self.search.law(law, &[argument]).map(|(fact, ..)| fact));
        }
        out
    }

    /// u = (u^{1/n})ⁿ.
    fn power_of_root(&mut self, base: Expr, exponent: Expr) -> Option<FactId> {
        let graph = &mut self.search.reader.graph;
        let n = graph.as_constant(exponent).filter(|r| *r.numerator() == 1.into())?.denominator().clone();
        let whole = graph.constant(Rational::from_parts(n.into(), 1u8.into()));
        self.search.law(Law::PowerOfPower, &[base, exponent, whole]).map(|(fact, ..)| fact)
    }

    /// Facts about what stands in an expression, as the expression has it, with all that is solved put in.
    fn of_higher_degree(&mut self, e: Expr, rest: &[Open]) -> Vec<FactId> {
        let wanted = self.search.reader.graph.leaves([e]);
        let mut out: Vec<FactId> = Vec::new();
        for open in rest {
            let size = self.search.reader.graph.reachable([open.e]).len();
            self.search.work += size;
            let leaves = self.search.reader.graph.leaves([open.e]);
            let concerns = leaves.iter().any(|leaf| wanted.contains(leaf));
            if !concerns || size > LARGEST_DIVISOR || out.len() >= MOST_DIVISORS || self.search.is_spent() {
                continue;
            }
            let Some(left) = self.search.reader.term(open.e) else { continue };
            let one = self.search.reader.graph.integer(1);
            out.extend(self.search.zero(Relation::equal(left, Term::integer(0)), None, &[(open.fact, one)], &[]));
        }
        out
    }

    /// The fact that is solved most easily for one of these leaves, as costly as is allowed.
    pub(crate) fn best(
        &mut self,
        rest: &[Open],
        leaves: &[Leaf],
        divisor: Divisor,
        kind: Kind,
    ) -> Option<(usize, Leaf)> {
        let mut best: Option<(Cost, usize, Leaf)> = None;
        for (at, open) in rest.iter().enumerate() {
            let ways = self.ways(open.e, leaves);
            let allowed = ways.into_iter().filter(|(cost, _)| cost.divisor <= divisor && cost.kind <= kind);
            if let Some((cost, leaf)) = allowed.min_by_key(|(cost, _)| *cost)
                && best.as_ref().is_none_or(|b| cost < b.0)
            {
                best = Some((cost, at, leaf));
            }
        }
        best.map(|(_, at, leaf)| (at, leaf))
    }

    pub(crate) fn kind_of(&self, leaf: Leaf) -> Option<Kind> {
        let name = self.search.reader.graph.name(leaf.symbol);
        let declared = self.sequent.symbols.iter().find(|d| d.name == name)?;
        match (declared.kind, leaf.instant, order(leaf)) {
            (SymbolKind::Time | SymbolKind::Coordinate, ..) => None,
            (SymbolKind::Constant(_), ..) => Some(Kind::Constant),
            (SymbolKind::Moves(_) | SymbolKind::Field(_) | SymbolKind::Defined, Some(_), _) => Some(Kind::Fixed),
            (SymbolKind::Moves(_) | SymbolKind::Field(_) | SymbolKind::Defined, None, 0) => Some(Kind::Value),
            (SymbolKind::Moves(_) | SymbolKind::Field(_) | SymbolKind::Defined, None, _) => Some(Kind::Rate),
        }
    }

    /// The leaves, of those that are wanted, for which an expression can be solved.
    fn ways(&mut self, e: Expr, wanted: &[Leaf]) -> Vec<(Cost, Leaf)> {
        let (nodes, leaves) = match self.search.sizes.get(&e) {
            Some(known) => known.clone(),
            None => {
                let nodes = self.search.reader.graph.reachable([e]).len();
                let leaves = self.search.reader.graph.leaves([e]);
                self.search.work += nodes;
                self.search.sizes.insert(e, (nodes, leaves.clone()));
                (nodes, leaves)
            }
        };
        let mut out = Vec::new();
        if nodes > MOST_NODES || self.search.is_spent() {
            return out;
        }
        for leaf in leaves {
            if !wanted.contains(&leaf) {
                continue;
            }
            let known = self.search.costs.get(&(e, leaf)).copied();
            let cost = known.unwrap_or_else(|| self.cost(e, nodes, leaf));
            self.search.costs.insert((e, leaf), cost);
            out.extend(cost.map(|cost| (cost, leaf)));
        }
        out
    }

    /// What it costs to solve an expression for a leaf, if that can be.
    fn cost(&mut self, e: Expr, nodes: usize, leaf: Leaf) -> Option<Cost> {
        let kind = self.kind_of(leaf)?;
        self.search.work += nodes;
        let factor = self.search.reader.graph.slope(e, leaf).ok()?;
        let below = self.search.reader.graph.leaves([factor]);
        if self.search.reader.graph.is_zero(factor) || below.contains(&leaf) {
            return None;
        }
        let moves = |l: &Leaf| matches!(self.kind_of(*l), None | Some(Kind::Rate | Kind::Value));
        let divisor = match below.iter().any(moves) {
            true => Divisor::Moving,
            false if below.is_empty() => Divisor::Number,
            false => Divisor::Constant,
        };
        let others = self.search.sizes.get(&e).map(|(_, leaves)| leaves.as_slice()).unwrap_or_default();
        let rates = others.iter().filter(|l| **l != leaf && order(**l) > 0).count();
        Some(Cost { divisor, kind, lower: u8::MAX.saturating_sub(order(leaf)), rates, nodes })
    }

    /// Solves e for a leaf: e = d·x + rest.
    pub(crate) fn solve(&mut self, open: &Open, leaf: Leaf) -> Option<Solved> {
        let graph = &mut self.search.reader.graph;
        let factor = graph.slope(open.e, leaf).ok()?;
        let (zero, one) = (graph.integer(0), graph.integer(1));
        let rest = graph.replaced(open.e, |_, l| (l == leaf).then_some(zero));
        let ratio = graph.div(rest, factor);
        let value = graph.neg(ratio);
        let node = graph.leaf(leaf);
        let says = self.search.reader.equation(node, value)?;
        let fact = self.search.zero(says, Some(factor), &[(open.fact, one)], &[])?;
        self.search.solved.push(fact);
        Some(Solved { node, value })
    }
}
