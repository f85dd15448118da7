//! One definition put into many expressions.

use expr::{Expr, FastMap, Graph, Leaf, Node};

/// What becomes of those of the nodes in `order` that depend on a leaf, when that is replaced. Children come before their
/// parents in `order`; nodes without the leaf need not be there.
pub(super) fn images(graph: &mut Graph, order: Vec<Expr>, leaf: Leaf, value: Expr) -> FastMap<Expr, Expr> {
    let mut image: FastMap<Expr, Expr> = FastMap::with_capacity_and_hasher(order.len(), Default::default());
    for node in order {
        let new = match *graph.node(node) {
            Node::Leaf(l) if l == leaf => value,
            Node::Unary(op, a) => match image.get(&a) {
                Some(&a) => graph.unary(op, a),
                None => continue,
            },
            Node::Binary(op, a, b) => match (image.get(&a), image.get(&b)) {
                (None, None) => continue,
                (p, q) => {
                    let (a, b) = (p.copied().unwrap_or(a), q.copied().unwrap_or(b));
                    graph.binary(op, a, b)
                }
            },
            _ => continue,
        };
        image.insert(node, new);
    }
    image
}

/// Replaces a leaf in all expressions. They share most of their nodes, and few of these depend on the leaf: every node is
/// looked at once, and those without the leaf stay what they are.
pub(super) fn put_in<'e>(graph: &mut Graph, into: impl Iterator<Item = &'e mut Expr>, leaf: Leaf, value: Expr) {
    let into: Vec<&mut Expr> = into.collect();
    let order = graph.reachable(into.iter().map(|e| **e));
    let image = images(graph, order, leaf, value);
    for e in into {
        *e = image.get(e).copied().unwrap_or(*e);
    }
}

/// Definitions put into one expression after another: what they share is looked at once.
pub(super) struct Insertion<'m> {
    definitions: &'m FastMap<Leaf, Expr>,
    image: FastMap<Expr, Expr>,
}

impl<'m> Insertion<'m> {
    pub(super) fn new(definitions: &'m FastMap<Leaf, Expr>) -> Insertion<'m> {
        Insertion { definitions, image: FastMap::default() }
    }

    /// The expression with the definitions inserted; those without a defined leaf stay what they are.
    pub(super) fn put_into(&mut self, graph: &mut Graph, e: Expr) -> Expr {
        let (mut open, mut new) = (vec![e], Vec::new());
        while let Some(e) = open.pop() {
            self.image.entry(e).or_insert_with(|| {
                new.push(e);
                open.extend(graph.node(e).children());
                e
            });
        }
        new.sort_unstable();
        for node in new {
            let at = |e: Expr| self.image.get(&e).copied().unwrap_or(e);
            let image = match *graph.node(node) {
                Node::Leaf(leaf) => self.definitions.get(&leaf).copied().unwrap_or(node),
                Node::Unary(op, a) => match at(a) {
                    same if same == a => continue,
                    other => graph.unary(op, other),
                },
                Node::Binary(op, a, b) => match (at(a), at(b)) {
                    same if same == (a, b) => continue,
                    (a, b) => graph.binary(op, a, b),
                },
                Node::Constant(_) | Node::Pi => continue,
            };
            self.image.insert(node, image);
        }
        self.image.get(&e).copied().unwrap_or(e)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expr::{Op, Shape};

    #[test]
    fn the_leaf_is_replaced_everywhere_and_nothing_else() {
        let mut g = Graph::new();
        let [x, y] = ["x", "y"].map(|n| {
            let symbol = g.declare(n, Shape::scalar(), false);
            Leaf::now(symbol, 0)
        });
        let (a, b) = (g.leaf(x), g.leaf(y));
        let sum = g.add(a, b);
        let sine = g.unary(Op::Sin, sum);
        let square = g.powi(b, 2);
        let three = g.integer(3);
        let mut list = [sine, square, a, g.mul(sine, square)];
        let wanted = list.map(|e| g.replaced(e, |_, l| (l == x).then_some(three)));
        put_in(&mut g, list.iter_mut(), x, three);
        assert_eq!(list, wanted);
        assert_eq!(list[1], square);
        let definitions = FastMap::from_iter([(x, three)]);
        let mut insertion = Insertion::new(&definitions);
        let product = g.mul(sine, square);
        for (e, wanted) in [product, sine, square, a, product].into_iter().zip([3, 0, 1, 2, 3]) {
            assert_eq!(insertion.put_into(&mut g, e), list[wanted]);
        }
    }
}
