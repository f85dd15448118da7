//! Nodes that a walk has come to, in time and memory that grow with the walk and not with the graph.
//!
//! **In:** the nodes of one walk, each as often as it is met. **Out:** each once, in order. **Guaranteed:** nothing of one walk is left in the
//! next. A file has one graph for all of its formulas, and walks below one of them are many: a list of bits as long as the graph, made for
//! each walk, takes the square of the file.

use std::cell::RefCell;

thread_local! {
    static MARKS: RefCell<Marks> = const { RefCell::new(Marks { of: Vec::new(), walk: 0 }) };
}

/// Graphs of at most so many nodes are small.
const SMALL: usize = 1 << 13;

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
pub(super) fn reached(roots: Vec<u32>, open: impl Fn(u32, &mut Vec<u32>)) -> Vec<u32> {
    let nodes = roots.iter().max().map_or(0, |youngest| *youngest as usize + 1);
    if nodes <= SMALL { by_bits(roots, nodes, open) } else { by_marks(roots, nodes, open) }
}

/// Of a small graph there is a bit for each node: reading them in order gives the order that is asked for.
fn by_bits(mut roots: Vec<u32>, nodes: usize, open: impl Fn(u32, &mut Vec<u32>)) -> Vec<u32> {
    let mut seen = vec![0u64; nodes.div_ceil(64)];
    let mut count = 0;
    while let Some(node) = roots.pop() {
        let (word, bit) = (node as usize / 64, 1 << (node % 64));
        if seen[word] & bit == 0 {
            seen[word] |= bit;
            count += 1;
            open(node, &mut roots);
        }
    }
    let mut found = Vec::with_capacity(count);
    for (word, mut bits) in seen.into_iter().enumerate() {
        while bits != 0 {
            found.push(word as u32 * 64 + bits.trailing_zeros());
            bits &= bits - 1;
        }
    }
    found
}

/// Of a large one there is the latest walk for each node.
fn by_marks(mut roots: Vec<u32>, nodes: usize, open: impl Fn(u32, &mut Vec<u32>)) -> Vec<u32> {
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
    fn both_ways_find_the_same() {
        // Node n has the children n/2 and n/3.
        let open = |n: u32, all: &mut Vec<u32>| all.extend([n / 2, n / 3].into_iter().filter(|child| *child < n));
        for roots in [vec![], vec![0], vec![77, 5000, 77], vec![4095, 4096], (0..300).collect()] {
            let nodes = roots.iter().max().map_or(0, |n| *n as usize + 1);
            assert_eq!(super::by_bits(roots.clone(), nodes, open), super::by_marks(roots, nodes, open));
        }
    }

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
