//! Values of the nodes of a graph at one point, each computed once.
//!
//! A tape computes what a few roots need. Here the roots come one after another, and share most of their nodes.

use expr::{Expr, FastMap, Graph, Node};
use number::{NoValue, Number};

/// The counted work of a value: finding what it is computed from, and computing it.
const OF_A_VALUE: u64 = 100;

/// What is known at one point.
#[derive(Clone, Debug)]
pub(super) struct Values<N> {
    known: FastMap<Expr, Result<N, NoValue>>,
}

impl<N> Default for Values<N> {
    fn default() -> Values<N> {
        Values { known: FastMap::default() }
    }
}

impl<N: Number> Values<N> {
    /// The value of a node, if it was computed.
    pub(super) fn of(&self, e: Expr) -> Option<Result<N, NoValue>> {
        self.known.get(&e).cloned()
    }

    /// The value of a leaf.
    pub(super) fn set(&mut self, leaf: Expr, value: Result<N, NoValue>) {
        self.known.insert(leaf, value);
    }

    /// The nodes below some roots, roots included, that have not been computed, children before parents. They count as
    /// known from now on, without a value: the leaves among them are to be set, the others to be computed.
    pub(super) fn missing(&mut self, graph: &Graph, roots: &[Expr]) -> Vec<Expr> {
        if self.known.is_empty() {
            let all = graph.reachable(roots.iter().copied());
            self.known.reserve(2 * all.len());
            self.known.extend(all.iter().map(|&e| (e, Err(NoValue::Unsupported))));
            return all;
        }
        let (mut open, mut new) = (roots.to_vec(), Vec::new());
        while let Some(e) = open.pop() {
            self.known.entry(e).or_insert_with(|| {
                new.push(e);
                open.extend(graph.node(e).children());
                Err(NoValue::Unsupported)
            });
        }
        new.sort_unstable();
        new
    }

    /// Computes nodes that [`Values::missing`] gave, once the leaves among them are set.
    pub(super) fn compute(&mut self, cx: &N::Context, graph: &Graph, new: &[Expr]) {
        meter::charge(OF_A_VALUE * new.len() as u64);
        let missing = Err(NoValue::Unsupported);
        for &e in new {
            let mut out = N::blank(cx);
            let done = match graph.node(e) {
                Node::Leaf(_) => continue,
                Node::Constant(r) => out.rational(cx, r),
                Node::Pi => out.pi(cx),
                &Node::Unary(op, a) => match self.known.get(&a).unwrap_or(&missing) {
                    Ok(a) => op.apply(cx, &mut out, a, a),
                    Err(reason) => Err(*reason),
                },
                &Node::Binary(op, a, b) => {
                    let (a, b) = (self.known.get(&a).unwrap_or(&missing), self.known.get(&b).unwrap_or(&missing));
                    match (a, b) {
                        (Ok(a), Ok(b)) => op.apply(cx, &mut out, a, b),
                        (Err(reason), _) | (_, Err(reason)) => Err(*reason),
                    }
                }
            };
            self.known.insert(e, done.map(|()| out));
        }
    }
}
