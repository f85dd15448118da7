//! What stays constant along a motion is computed once.

use std::collections::HashMap;

use expr::{Expr, Graph, Leaf, Node};

/// Replaces every maximal operation on leaves that do not move by a new leaf, and says which expression it stands for.
///
/// `name` makes the leaf for the n-th constant found.
pub(super) fn hoist(
    graph: &mut Graph,
    roots: &[Expr],
    moves: impl Fn(Leaf) -> bool,
    mut name: impl FnMut(&mut Graph, Expr) -> Leaf,
) -> Vec<Expr> {
    let order = graph.reachable(roots.iter().copied());
    let mut moving: HashMap<Expr, bool> = HashMap::new();
    for &e in &order {
        let m = match graph.node(e) {
            Node::Constant(_) | Node::Pi => false,
            Node::Leaf(leaf) => moves(*leaf),
            node => node.children().any(|c| moving[&c]),
        };
        moving.insert(e, m);
    }
    let mut image: HashMap<Expr, Expr> = HashMap::new();
    let mut fixed = |graph: &mut Graph, image: &mut HashMap<Expr, Expr>, e: Expr| {
        if let Some(&done) = image.get(&e) {
            return done;
        }
        let operation = matches!(graph.node(e), Node::Unary(..) | Node::Binary(..));
        let new = if operation && !moving[&e] {
            let leaf = name(graph, e);
            graph.leaf(leaf)
        } else {
            e
        };
        image.insert(e, new);
        new
    };
    for &e in &order {
        if !moving[&e] {
            continue;
        }
        let new = match *graph.node(e) {
            Node::Unary(op, a) => {
                let a = fixed(graph, &mut image, a);
                graph.unary(op, a)
            }
            Node::Binary(op, a, b) => {
                let (a, b) = (fixed(graph, &mut image, a), fixed(graph, &mut image, b));
                graph.rebuilt(op, a, b)
            }
            _ => e,
        };
        image.insert(e, new);
    }
    roots.iter().map(|&r| fixed(graph, &mut image, r)).collect()
}
