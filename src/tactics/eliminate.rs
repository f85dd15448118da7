//! Elimination: what equations are solved for is put into others.
//!
//! **In:** a draft, and expressions. **Out:** the expressions with values put in, as the checker will see them, and how much work that took.

use crate::vanish::Cost;
use crate::write::Reader;
use checker::{CaseId, Draft, FactId, Law, Manner, Relation, Sense, Step, Term};
use expr::{Expr, Leaf, Node};
use std::collections::{BTreeMap, BTreeSet};

/// Most nodes of an expression that is reduced.
pub(crate) const MOST_NODES: usize = 6_000;
/// Most nodes that are looked at for one relation.
const MOST_WORK: usize = 250_000;

/// Most terms that are looked at for sums of multiples in one proof.
const MOST_MULTIPLES: usize = 360_000;

/// So many products of terms that the checker expands count as one node.
const PRODUCTS: usize = 6;

/// Counted work of a step, and of a node of what it makes: the checker makes each of them again.
const STEP: u64 = 2_000;
/// See [`STEP`].
const NODE: u64 = 500;

/// A node, and what it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Solved {
    pub(crate) node: Expr,
    pub(crate) value: Expr,
}

/// A search for a proof.
pub(crate) struct Search {
    pub(crate) reader: Reader,
    pub(crate) draft: Draft,
    /// Facts that are solved for something: it is their left side.
    pub(crate) solved: Vec<FactId>,
    /// Nodes that were looked at.
    pub(crate) work: usize,
    /// The sides of facts that were asked for.
    pub(crate) sides_of: BTreeMap<FactId, (Expr, Expr)>,
    /// Nodes and leaves of expressions, and what it costs to solve them for leaves.
    pub(crate) sizes: BTreeMap<Expr, (usize, Vec<Leaf>)>,
    pub(crate) costs: BTreeMap<(Expr, Leaf), Option<Cost>>,
    /// What was not found to be a sum of multiples of these.
    pub(crate) completed: BTreeSet<(Expr, Vec<Expr>)>,
    /// Terms that may still be looked at for sums of multiples.
    pub(crate) multiples: usize,
}

impl Search {
    pub(crate) fn new(reader: Reader, draft: Draft) -> Search {
        Search {
            reader,
            draft,
            solved: Vec::new(),
            work: 0,
            sides_of: BTreeMap::new(),
            sizes: BTreeMap::new(),
            costs: BTreeMap::new(),
            completed: BTreeSet::new(),
            multiples: MOST_MULTIPLES,
        }
    }

    /// Whether the work of the search is done with.
    pub(crate) fn is_spent(&self) -> bool {
        self.work > MOST_WORK
    }

    /// Another way is tried: of what was spent, half is free again, so that all ways together take no more than a few times the first.
    pub(crate) fn renew(&mut self) {
        self.work = self.work.min(MOST_WORK) / 2;
    }

    /// Takes a step; the fact that it makes.
    pub(crate) fn push(&mut self, step: Step) -> Option<FactId> {
        let before = self.draft.products();
        let made = self.draft.push(step).ok().flatten();
        self.work += self.draft.products().saturating_sub(before) / PRODUCTS;
        let size = made.and_then(|id| self.draft.says(id)).map_or(0, |says| says.left.0.len() + says.right.0.len());
        meter::charge(STEP + NODE * size as u64);
        made
    }

    /// Opens a case.
    pub(crate) fn suppose(&mut self, says: Relation, manner: Manner) -> Option<CaseId> {
        self.draft.push(Step::Suppose { says, manner }).ok()?;
        let cases = self.draft.steps().iter().filter(|step| matches!(step, Step::Suppose { .. })).count();
        // The first case is that of the claim.
        u32::try_from(cases).ok().map(CaseId)
    }

    /// The sides of an equation that is a fact.
    pub(crate) fn equation(&mut self, id: FactId) -> Option<(Expr, Expr)> {
        if let Some(known) = self.sides_of.get(&id) {
            return Some(*known);
        }
        let says = self.draft.says(id).filter(|says| says.sense == Sense::Equal)?;
        let sides = self.reader.sides(&says)?;
        self.sides_of.insert(id, sides);
        Some(sides)
    }

    /// A law, and its sides.
    pub(crate) fn law(&mut self, law: Law, of: &[Expr]) -> Option<(FactId, Expr, Expr)> {
        let of: Option<Vec<Term>> = of.iter().map(|e| self.reader.term(*e)).collect();
        let fact = self.push(Step::Law { law, of: of? })?;
        let (l, r) = self.equation(fact)?;
        Some((fact, l, r))
    }

    /// Puts a value into an expression; whether there was room for it.
    pub(crate) fn put_in(&mut self, e: &mut Expr, solved: Solved) -> bool {
        let graph = &mut self.reader.graph;
        let nodes = graph.reachable([*e]);
        self.work += nodes.len();
        if nodes.len() > MOST_NODES || self.work > MOST_WORK {
            return false;
        }
        let mut image: BTreeMap<Expr, Expr> = BTreeMap::new();
        for node in nodes {
            let new = match *graph.node(node) {
                _ if node == solved.node => solved.value,
                Node::Constant(_) | Node::Pi | Node::Leaf(_) => node,
                Node::Unary(op, a) => graph.unary(op, image[&a]),
                Node::Binary(op, a, b) => graph.rebuilt(op, image[&a], image[&b]),
            };
            image.insert(node, new);
        }
        *e = image[e];
        true
    }

    /// An equation by algebra, with all that is solved put in.
    pub(crate) fn zero(
        &mut self,
        says: Relation,
        multiplier: Option<Expr>,
        terms: &[(FactId, Expr)],
        modulo: &[FactId],
    ) -> Option<FactId> {
        let multiplier = match multiplier {
            Some(e) => self.reader.term(e)?,
            None => Term::integer(1),
        };
        let terms: Option<Vec<_>> = terms.iter().map(|&(fact, q)| Some((fact, self.reader.term(q)?))).collect();
        let step = Step::Zero { says, multiplier, terms: terms?, insert: self.solved.clone(), modulo: modulo.to_vec() };
        self.push(step)
    }
}
