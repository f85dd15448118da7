//! Nodes that a walk has come to, in time and memory that grow with the walk and not with the graph.
//!
//! **In:** the nodes of one walk, each as often as it is met. **Out:** each once, in order. **Guaranteed:** nothing of one walk is left in the
//! next. A file has one graph for all of its formulas, and walks below one of them are many: a list of bits as long as the graph, made for
//! each walk, takes the square of the file.

use std::cell::RefCell;

thread_local! {
    static MARKS: RefCell<Marks> = const { RefCell::new(Marks { of: Vec::new(), walk: 0 }) };
}

/// The latest walk that came to each node. Kept for the walks that follow on a thread.
struct Marks {
    of: Vec<u32>,
    walk: u32,
}

impl Marks {
    /// Begins a walk among so many nodes.
    fn begin(&mut self, nodes: usize) {
        if self.of.len() < nodes {
            self.of.resize(nodes, 0);
        }
        self.walk = self.walk.wrapping_add(1);
        if self.walk == 0 {
            self.of.fill(0);
            self.walk = 1;
        }
    }

    /// Whether this is the first time that the walk comes to a node.
    fn is_first(&mut self, node: u32) -> bool {
        std::mem::replace(&mut self.of[node as usize], self.walk) != self.walk
    }
}

/// All nodes that can be reached from these, in order, by their numbers; `open` adds the children of a node.
pub(super) fn reached(mut roots: Vec<u32>, open: impl Fn(u32, &mut Vec<u32>)) -> Vec<u32> {
    let nodes = roots.iter().max().map_or(0, |youngest| *youngest as usize + 1);
    MARKS.with_borrow_mut(|marks| {
        marks.begin(nodes);
        let mut found = Vec::new();
        while let Some(node) = roots.pop() {
            if marks.is_first(node) {
                found.push(node);
                open(node, &mut roots);
            }
        }
        found.sort_unstable();
        found
    })
}

#[cfg(test)]
mod tests {
    use super::super::{Graph, Shape};

    #[test]
    fn a_walk_leaves_nothing_to_the_next() {
        let mut graph = Graph::new();
        let x = graph.declare("x", Shape::scalar(), false);
        let x = graph.leaf(super::super::Leaf::now(x, 0));
        let two = graph.integer(2);
        let (double, square) = (graph.mul(two, x), graph.powi(x, 2));
        for _ in 0..3 {
            assert_eq!(graph.reachable([double]), [x, two, double]);
            assert_eq!(graph.reachable([square, square]), [x, square]);
            assert_eq!(graph.reachable([square, double]), [x, two, double, square]);
            assert!(graph.reachable([]).is_empty());
        }
    }
}
