//! Equations between products of powers, as equations between logarithms.
//!
//! **In:** equations and premises. **Out:** the same, where equations between products of powers of what is positive are equations
//! between the logarithms of their sides, and every logarithm is an unknown of its own; `None` where nothing changes.
//! **Guaranteed:** what is proved of the unknowns is so of the logarithms, and an equation between positive numbers holds exactly where
//! that of their logarithms does. T₁V₂^{g−1} = T₂V₃^{g−1} says that ln T₁ + (g − 1) ln V₂ = ln T₂ + (g − 1) ln V₃, which is linear.

use super::generators::Generators;
use super::outcome::{Condition, Premises};
use super::sign::Facts;
use expr::{Expr, FastMap, Graph, Leaf, Node, Op, Rational, Shape, Symbol};

type Pairs = Vec<(Expr, Expr)>;

/// The name of the hidden symbol whose components stand for logarithms.
const HIDDEN: &str = "\u{2063}logarithm";

/// A question about logarithms.
pub(super) struct OfLogarithms {
    pub(super) equations: Pairs,
    pub(super) given: Premises,
    /// The logarithms that the unknowns stand for.
    names: FastMap<Leaf, Expr>,
}

impl OfLogarithms {
    /// A condition of a proof about the unknowns, in words of the logarithms.
    pub(super) fn said(&self, graph: &mut Graph, condition: Condition) -> Condition {
        let mut put = |e: Expr| graph.substitute(e, |_, leaf| self.names.get(&leaf).copied());
        match condition {
            Condition::Denominator(e) => Condition::Denominator(put(e)),
            Condition::Pivot(e) => Condition::Pivot(put(e)),
            Condition::Rate(e) => Condition::Rate(put(e)),
            Condition::Radicand(e) => Condition::Radicand(put(e)),
            Condition::Discriminant(e) => Condition::Discriminant(put(e)),
            Condition::Unit(e) => Condition::Unit(put(e)),
            Condition::Positive(e) => Condition::Positive(put(e)),
        }
    }
}

/// Products of powers, as their logarithms.
pub(super) fn by_logarithms(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises) -> Option<OfLogarithms> {
    let is_power = |graph: &Graph, e: &Expr| match *graph.node(*e) {
        Node::Binary(Op::Pow, _, exponent) => graph.as_constant(exponent).is_none(),
        Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => false,
    };
    let sides = equations.iter().flat_map(|&(l, r)| [l, r]).chain(given.sides());
    if !graph.reachable(sides).iter().any(|e| is_power(graph, e)) {
        return None;
    }
    let mut facts = Facts::default();
    given.positive.iter().for_each(|&e| facts.note_positive(graph, e));
    let generators = Generators::new(graph);
    let symbol = match graph.find_symbol(HIDDEN) {
        Some(symbol) => symbol,
        None => graph.declare(HIDDEN, Shape::vector(u16::MAX), false),
    };
    let mut products = Products { graph, facts, generators, symbol, known: Vec::new() };
    let claim: Option<Pairs> = equations.iter().map(|&pair| products.equation(pair)).collect();
    let mut out = given.clone();
    for known in &mut out.equations {
        *known = known.with(products.equation(known.sides()).unwrap_or(known.sides()));
    }
    let equations = claim?;
    let names = products.known.iter().map(|&(log, leaf)| (leaf, log)).collect();
    Some(OfLogarithms { equations, given: out, names })
}

struct Products<'g> {
    graph: &'g mut Graph,
    facts: Facts,
    generators: Generators,
    symbol: Symbol,
    /// Logarithms, and the unknowns that stand for them.
    known: Vec<(Expr, Leaf)>,
}

impl Products<'_> {
    fn equation(&mut self, (l, r): (Expr, Expr)) -> Option<(Expr, Expr)> {
        Some((self.logarithm(l)?, self.logarithm(r)?))
    }

    /// The logarithm of a product of powers; `None` where a factor is not known to be positive.
    fn logarithm(&mut self, e: Expr) -> Option<Expr> {
        let graph = &mut *self.graph;
        match *graph.node(e) {
            Node::Constant(ref q) if **q == Rational::ONE => Some(graph.integer(0)),
            Node::Constant(ref q) => (**q > Rational::ZERO).then(|| graph.unary(Op::Ln, e)),
            Node::Unary(Op::Exp, x) => Some(x),
            Node::Unary(Op::Sqrt, a) => {
                let (log, two) = (self.logarithm(a)?, self.graph.integer(2));
                Some(self.graph.div(log, two))
            }
            Node::Unary(Op::Powi(n), a) => {
                let (log, n) = (self.logarithm(a)?, self.graph.integer(n.into()));
                Some(self.graph.mul(n, log))
            }
            Node::Binary(Op::Pow, a, b) => {
                let log = self.logarithm(a)?;
                Some(self.graph.mul(b, log))
            }
            Node::Binary(op @ (Op::Mul | Op::Div), a, b) => {
                let (a, b) = (self.logarithm(a)?, self.logarithm(b)?);
                Some(if op == Op::Mul { self.graph.add(a, b) } else { self.graph.sub(a, b) })
            }
            Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {
                let known = self.facts.sign(graph, &self.generators, e);
                (known.not_negative && known.nonzero).then_some(())?;
                let log = graph.unary(Op::Ln, e);
                self.unknown(log)
            }
        }
    }

    /// The unknown that stands for a logarithm.
    fn unknown(&mut self, log: Expr) -> Option<Expr> {
        let leaf = match self.known.iter().find(|(l, _)| *l == log) {
            Some(&(_, leaf)) => leaf,
            None => {
                let leaf = Leaf::now(self.symbol, u16::try_from(self.known.len()).ok()?);
                self.known.push((log, leaf));
                leaf
            }
        };
        Some(self.graph.leaf(leaf))
    }
}
