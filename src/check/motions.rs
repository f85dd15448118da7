//! Motions kept from one state of a file to the next.
//!
//! **In:** the graph that motions were built in, and leaves and expressions of the graph of a later state of the file. **Out:** the
//! same leaves and expressions in the graph of the motions.
//!
//! Every state of a file is read into a graph of its own, so that its numbers are those of a run that knows nothing of earlier
//! states. A motion keeps the graph that it was built in, with the searches that were made; what a later state asks of it is
//! looked up there by structure, or added.
//!
//! **Guaranteed:** a translated expression is the same operations on the same numbers in the same order. Where the graph has a + b
//! in place of b + a, nothing is translated, and the motion is built again.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::derivation::Derivation;
use crate::expr::{Expr, Graph, Leaf, Node};
use crate::flow::Search;
use sampled::setup::is_known;
use sampled::stage::{Built, Requests, searched};

/// Motions that come from one another, with the graph that they were built in.
#[derive(Debug)]
pub(super) struct Family {
    /// The graph.
    graph: Graph,
    /// How many of its symbols are those of the file; the others belong to the motions.
    symbols: usize,
    /// The motions, each by its place among the members of the family.
    members: Vec<Member>,
}

/// A motion, in the numbers of the graph of its family.
#[derive(Debug)]
struct Member {
    place: usize,
    built: Built,
    /// What was searched for; nothing where the motion does not know it.
    searches: BTreeMap<Expr, Option<Arc<Search>>>,
}

impl Family {
    /// Keeps motions with the graph that they were built in, a copy of that of the file: for each member its trajectory.
    pub fn new(derivation: &Derivation, graph: Graph, members: &[usize], built: &[(usize, Built)]) -> Family {
        let member = |(t, built): &(usize, Built)| {
            let searches = built.searches.iter().map(|(e, search)| (*e, Some(Arc::clone(search)))).collect();
            Some(Member { place: members.iter().position(|m| m == t)?, built: built.clone(), searches })
        };
        let symbols = derivation.graph.symbol_count();
        Family { graph, symbols, members: built.iter().filter_map(member).collect() }
    }

    /// The motions for a later state of the file that says the same of them, by the positions of their trajectories; `None`
    /// where they have to be built again.
    pub fn again(
        &mut self,
        derivation: &Derivation,
        requests: &Requests,
        members: &[usize],
    ) -> Option<Vec<(usize, Built)>> {
        if !self.knows(&derivation.graph) {
            return None;
        }
        let mut translation = Translation::new(&derivation.graph);
        let Family { graph, members: kept, .. } = self;
        kept.iter_mut().map(|member| member.again(derivation, requests, members, graph, &mut translation)).collect()
    }

    /// Whether the symbols of a later graph are those of this one.
    fn knows(&self, graph: &Graph) -> bool {
        let same = |at: usize| match (self.graph.symbol(at), graph.symbol(at)) {
            (Some(a), Some(b)) => {
                self.graph.name(a) == graph.name(b)
                    && self.graph.shape(a) == graph.shape(b)
                    && self.graph.is_diagonal(a) == graph.is_diagonal(b)
            }
            _ => false,
        };
        self.symbols == graph.symbol_count() && (0..self.symbols).all(same)
    }
}

impl Member {
    fn again(
        &mut self,
        derivation: &Derivation,
        requests: &Requests,
        members: &[usize],
        graph: &mut Graph,
        translation: &mut Translation,
    ) -> Option<(usize, Built)> {
        let t = *members.get(self.place)?;
        let mut asked = self.built.asked.clone();
        let mut at: BTreeMap<Leaf, usize> = asked.iter().enumerate().map(|(i, leaf)| (*leaf, i)).collect();
        let mut places = Vec::with_capacity(requests.wanted.len());
        for &leaf in requests.wanted {
            let there = translation.leaf(graph, leaf)?;
            places.push(is_known(&derivation.graph, &self.built.known, leaf).then(|| {
                *at.entry(there).or_insert_with(|| {
                    asked.push(there);
                    asked.len() - 1
                })
            }));
        }
        if asked.len() > self.built.asked.len() {
            let mut motion = self.built.motion.as_ref().clone();
            motion.prepare(graph, &asked).ok()?;
            self.built.motion = Arc::new(motion);
            self.built.asked = asked;
            self.built.samples = Arc::default();
        }
        let (wanted, watched) = searched(derivation, requests, t);
        let there: Vec<Expr> = wanted.iter().map(|&e| translation.expr(graph, e)).collect::<Option<_>>()?;
        let new: Vec<Expr> = there.iter().copied().filter(|e| !self.searches.contains_key(e)).collect();
        let rapid: Vec<Expr> = watched.iter().map(|&e| translation.expr(graph, e)).collect::<Option<_>>()?;
        if !new.is_empty() || rapid != self.built.rapid.0 {
            let found = self.built.motion.searches(graph, (&new, &rapid), self.built.span).ok()?;
            self.searches.extend(new.into_iter().zip(found.zeros.into_iter().map(Result::ok)));
            self.built.rapid = (rapid, found.rapid);
        }
        let rapid = (watched, Arc::clone(&self.built.rapid.1));
        let known = |(e, there): (Expr, Expr)| Some((e, Arc::clone(self.searches.get(&there)?.as_ref()?)));
        let searches = wanted.into_iter().zip(there).filter_map(known).collect();
        Some((t, Built { places, searches, rapid, ..self.built.clone() }))
    }
}

/// Expressions of one graph in another, which has the same symbols.
pub(super) struct Translation<'a> {
    from: &'a Graph,
    known: BTreeMap<Expr, Expr>,
}

impl<'a> Translation<'a> {
    /// From a graph.
    pub fn new(from: &'a Graph) -> Translation<'a> {
        Translation { from, known: BTreeMap::new() }
    }

    /// An expression in the other graph; `None` where it would not be the same there.
    pub fn expr(&mut self, to: &mut Graph, e: Expr) -> Option<Expr> {
        for part in self.from.reachable([e]) {
            if self.known.contains_key(&part) {
                continue;
            }
            let of = |known: &BTreeMap<Expr, Expr>, e: &Expr| known.get(e).copied();
            let node = match self.from.node(part) {
                Node::Leaf(leaf) => Node::Leaf(self.leaf(to, *leaf)?),
                Node::Unary(op, a) => Node::Unary(*op, of(&self.known, a)?),
                Node::Binary(op, a, b) => Node::Binary(*op, of(&self.known, a)?, of(&self.known, b)?),
                same @ (Node::Constant(_) | Node::Pi) => same.clone(),
            };
            let there = match &node {
                Node::Leaf(leaf) => to.leaf(*leaf),
                Node::Unary(op, a) => to.unary(*op, *a),
                Node::Binary(op, a, b) => to.binary(*op, *a, *b),
                Node::Constant(r) => to.constant((**r).clone()),
                Node::Pi => to.pi(),
            };
            if *to.node(there) != node {
                return None;
            }
            self.known.insert(part, there);
        }
        self.known.get(&e).copied()
    }

    /// A leaf in the other graph.
    pub fn leaf(&mut self, to: &mut Graph, leaf: Leaf) -> Option<Leaf> {
        let instant = match leaf.instant {
            Some(e) => Some(self.expr(to, e)?),
            None => None,
        };
        Some(Leaf { instant, ..leaf })
    }
}
