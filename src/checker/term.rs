//! Terms: formulas as a recorded proof holds them.
//!
//! **In:** an expression of a graph. **Out:** [`Term`], a flat list of nodes in which arguments stand before what is made of them, so
//! that no depth of a formula can exhaust a stack; [`Relation`], two terms with a sense. **Guaranteed:** a term that was read from a
//! report is turned into an expression node by node, by [`Context`](super::context::Context), which refuses what is not declared.

use expr::{Expr, Graph, Node, Op, Rational, Symbol};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Most digits of a number.
const MOST_DIGITS: usize = 20_000;

/// Most nodes of a term.
pub const LARGEST_TERM: usize = 50_000;

/// A node of a term; arguments are positions of earlier nodes.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TermNode {
    /// An exact rational, written `n` or `n/d`.
    Number(String),
    /// π.
    Pi,
    /// A component of a symbol or of one of its rates, now or at a fixed time.
    Leaf {
        /// The symbol.
        name: String,
        /// Its component, counted from 0.
        component: u16,
        /// The order of the rate.
        rate: u8,
        /// The position of the fixed time.
        at: Option<u32>,
    },
    /// A component of a field, derived by the time and by coordinates, each with its name, its component and the order.
    Partial {
        /// The field.
        name: String,
        /// Its component, counted from 0.
        component: u16,
        /// The order of the derivative by time.
        rate: u8,
        /// The orders of the others.
        by: Vec<(String, u16, u8)>,
    },
    /// An operation, by its name, and its arguments.
    Apply(String, Vec<u32>),
}

/// A formula. The last node is the whole.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Term(pub Vec<TermNode>);

/// How the sides of a relation stand to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sense {
    /// l = r
    Equal,
    /// l ≠ r
    NotEqual,
    /// l < r
    Less,
    /// l ≤ r
    LessOrEqual,
}

/// A relation between two formulas.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Relation {
    /// The left side.
    pub left: Term,
    /// How they stand to each other.
    pub sense: Sense,
    /// The right side.
    pub right: Term,
}

impl Relation {
    /// left = right.
    pub fn equal(left: Term, right: Term) -> Relation {
        Relation { left, sense: Sense::Equal, right }
    }
}

/// The name of an operation in a record: its spelling, but for integer powers, which have their exponent.
fn name_of(op: Op) -> String {
    match op {
        Op::Powi(n) => format!("^{n}"),
        other => other.spelling().to_owned(),
    }
}

/// The operation of a name with so many arguments.
pub fn operation(name: &str, arity: usize) -> Option<Op> {
    if arity == 1
        && let Some(exponent) = name.strip_prefix('^').filter(|n| !n.is_empty())
    {
        return exponent.parse().ok().map(Op::Powi);
    }
    let has_name = |op: &Op| op.arity() == arity && !matches!(op, Op::Powi(_)) && op.spelling() == name;
    Op::EVERY.iter().copied().chain([Op::Restrict]).find(has_name)
}

/// An exact rational, written `n` or `n/d` with digits, d ≠ 0.
pub(crate) fn rational(text: &str) -> Result<Rational, String> {
    let (top, under) = text.split_once('/').unwrap_or((text, "1"));
    let digits = |text: &str| !text.is_empty() && text.len() <= MOST_DIGITS && text.bytes().all(|b| b.is_ascii_digit());
    let is_number = digits(top.strip_prefix('-').unwrap_or(top)) && digits(under) && under.bytes().any(|b| b != b'0');
    let value = if is_number { text.parse().ok() } else { None };
    value.ok_or_else(|| format!("no rational number: {text:.40}"))
}

impl Term {
    /// A whole number.
    pub fn integer(n: i64) -> Term {
        Term(vec![TermNode::Number(n.to_string())])
    }

    /// An expression of a graph, with the names of symbols that `name` gives.
    ///
    /// # Errors
    /// A sentence: a symbol without a name, or a field at another place.
    pub fn of(graph: &Graph, e: Expr, name: impl Fn(Symbol) -> Option<String>) -> Result<Term, String> {
        // Fixed times are older than the leaves that are taken at them.
        let mut roots = vec![e];
        loop {
            let leaves = graph.leaves(roots.iter().copied());
            let instants: Vec<Expr> =
                leaves.iter().filter_map(|leaf| leaf.instant).filter(|c| !roots.contains(c)).collect();
            if instants.is_empty() {
                break;
            }
            roots.extend(instants);
        }
        let mut at: BTreeMap<Expr, u32> = BTreeMap::new();
        let mut nodes = Vec::new();
        for node in graph.reachable(roots).into_iter().filter(|node| *node <= e) {
            let made = match graph.node(node) {
                Node::Constant(r) => TermNode::Number(r.to_string()),
                Node::Pi => TermNode::Pi,
                Node::Leaf(leaf) => {
                    if graph.place(leaf.symbol).is_some() {
                        return Err("fields at other places are not among the terms of recorded proofs".to_owned());
                    }
                    let own = name(leaf.symbol).ok_or("a symbol without a name")?;
                    let mut by = Vec::new();
                    for (coordinate, order) in graph.coordinates().zip(leaf.partials.orders()).filter(|(_, n)| *n > 0) {
                        let of = name(coordinate.symbol).ok_or("a symbol without a name")?;
                        by.push((of, coordinate.component, order));
                    }
                    match by.is_empty() {
                        true => {
                            let instant = leaf.instant.map(|c| at[&c]);
                            TermNode::Leaf { name: own, component: leaf.component, rate: leaf.rate, at: instant }
                        }
                        false => TermNode::Partial { name: own, component: leaf.component, rate: leaf.rate, by },
                    }
                }
                Node::Unary(op, a) => TermNode::Apply(name_of(*op), vec![at[a]]),
                Node::Binary(op, a, b) => TermNode::Apply(name_of(*op), vec![at[a], at[b]]),
            };
            at.insert(node, nodes.len() as u32);
            nodes.push(made);
        }
        Ok(Term(nodes))
    }
}
