//! Absolute values in premises, written with signs.
//!
//! **In:** lowered premises. **Out:** for every |a| in them σ·a with a sign σ = ±1 of its own; the premises can then be solved
//! for what stands in a. The same |a| elsewhere becomes the same. Real points are those with σ·a ≥ 0; all others are tested
//! with them, which can lose a proof, not forge one. An |a| that stands in no premise is left to [`roots`](super::roots).

use super::generators::{Generator, Generators, TooLarge};
use super::sign::Facts;
use expr::FastMap;
use expr::{Expr, Graph, Node, Op};

/// What |a| becomes, for all that stand in premises.
pub(super) struct AbsoluteValues {
    images: FastMap<Expr, Expr>,
    rebuilt: FastMap<Expr, Expr>,
}

impl AbsoluteValues {
    /// Finds those of the premises.
    pub(super) fn of(
        graph: &mut Graph,
        generators: &mut Generators,
        facts: &mut Facts,
        premises: &[Expr],
    ) -> Result<AbsoluteValues, TooLarge> {
        let mut out = AbsoluteValues { images: FastMap::default(), rebuilt: FastMap::default() };
        for node in graph.reachable(premises.iter().copied()) {
            let Node::Unary(Op::Abs, a) = *graph.node(node) else { continue };
            let inner = out.put_into(graph, a);
            let known = facts.sign(graph, generators, inner);
            let image = if known.not_negative {
                inner
            } else if known.not_positive {
                graph.neg(inner)
            } else {
                let sign = generators.add(Generator::Sign).ok_or(TooLarge)?;
                let sign = graph.leaf(sign);
                let image = graph.mul(sign, inner);
                facts.note_not_negative(graph, image);
                image
            };
            out.images.insert(node, image);
        }
        Ok(out)
    }

    /// The expression with these absolute values replaced.
    pub(super) fn put_into(&mut self, graph: &mut Graph, e: Expr) -> Expr {
        if self.images.is_empty() {
            return e;
        }
        for node in graph.reachable([e]) {
            if self.rebuilt.contains_key(&node) {
                continue;
            }
            let of = |e: Expr| self.rebuilt.get(&e).copied().unwrap_or(e);
            let new = match (self.images.get(&node), graph.node(node)) {
                (Some(&image), _) => image,
                (None, &Node::Unary(op, a)) => graph.unary(op, of(a)),
                (None, &Node::Binary(op, a, b)) => graph.binary(op, of(a), of(b)),
                (None, _) => node,
            };
            self.rebuilt.insert(node, new);
        }
        self.rebuilt.get(&e).copied().unwrap_or(e)
    }
}
