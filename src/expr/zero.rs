//! Zeros as factors: which terms `0·e` are there, and which are not.
//!
//! An entry that a definition leaves empty (of ε and δ, of 𝟙 and other diagonal matrices beside their diagonals) is a *structural
//! zero*: it makes no term, whatever it is multiplied by. Every other zero, written or computed, is a factor like any other:
//! `0·e` has no value where `e` has none, so that the term goes only if `e` has a value for certain.

use super::domain::{Nature, Parity, operation, row};
use super::{Expr, FastSet, Graph, Leaf, Node, Op};

impl Graph {
    /// The number that an expression is outside of products: 0 for the structural zero.
    pub fn settled(&mut self, e: Expr) -> Expr {
        if self.is_absent(e) { self.integer(0) } else { e }
    }

    /// f of the structural zero, where that is structural, too.
    pub(super) fn unary_of_absent(&self, op: Op, a: Expr) -> Option<Expr> {
        if !self.is_absent(a) {
            return None;
        }
        let odd = matches!(row(op).nature, Nature::Transcendental { parity: Parity::Odd, .. });
        let power = matches!(op, Op::Powi(n) if n > 0);
        (odd || power || [Op::Neg, Op::Abs, Op::Sqrt].contains(&op)).then_some(a)
    }

    /// A sum or product with the structural zero.
    pub(super) fn binary_of_absent(&mut self, op: Op, a: Expr, b: Expr) -> Option<Expr> {
        let absent = [a, b].map(|e| self.is_absent(e));
        if op == Op::Mul && absent.contains(&true) {
            return Some(if absent[0] { a } else { b });
        }
        let sum = op == Op::Add || op == Op::Sub;
        if sum && absent[1] {
            return Some(if op == Op::Add && absent[0] { b } else { a });
        }
        (sum && absent[0]).then(|| if op == Op::Add { b } else { self.neg(b) })
    }

    /// A product of factors of which one may be 0: the term is left out where that is structural, and is 0 where the other factor has
    /// a value for certain.
    pub fn term(&mut self, a: Expr, b: Expr) -> Expr {
        if self.is_absent(a) || self.is_absent(b) {
            return self.absent();
        }
        let zero = |graph: &mut Graph, zero: Expr, other: Expr| graph.is_zero(zero) && graph.has_value(other);
        if zero(self, a, b) {
            return a;
        }
        if zero(self, b, a) {
            return b;
        }
        self.mul(a, b)
    }

    /// A term of a derivative: 0 where one factor is, since what does not change adds nothing to a rate. Who takes the derivative
    /// sees to it that there is one, see [`Graph::rate_of`].
    pub fn mul_structural(&mut self, a: Expr, b: Expr) -> Expr {
        if self.is_zero(a) || self.is_zero(b) { self.integer(0) } else { self.mul(a, b) }
    }

    /// Whether an expression is 0 wherever it has a value, as far as products with a 0, and sums of such, show it.
    pub fn vanishes(&self, e: Expr) -> bool {
        let mut vanishing: FastSet<Expr> = FastSet::default();
        for node in self.reachable([e]) {
            let vanishes = match operation(self, node) {
                None => self.is_zero(node),
                Some((op, a, b)) => {
                    let [a, b] = [a, b].map(|e| vanishing.contains(&e));
                    let both = a && b && (op == Op::Add || op == Op::Sub);
                    both || op == Op::Mul && (a || b) || a && [Op::Neg, Op::Abs, Op::Div, Op::Restrict].contains(&op)
                }
            };
            if vanishes {
                vanishing.insert(node);
            }
        }
        vanishing.contains(&e)
    }

    /// Whether an expression has a value whatever its leaves are, and they have values wherever they are asked for.
    pub fn has_value(&mut self, e: Expr) -> bool {
        match *self.node(e) {
            Node::Constant(_) | Node::Pi => return true,
            Node::Leaf(leaf) => return self.leaf_has_value(leaf),
            Node::Unary(..) | Node::Binary(..) => {}
        }
        let all_leaves = self.leaves([e]).into_iter().all(|leaf| self.leaf_has_value(leaf));
        all_leaves && self.needs_below([e]).iter().all(|need| self.is_met(need))
    }

    fn leaf_has_value(&self, leaf: Leaf) -> bool {
        leaf.instant.is_none() && self.always_has_value(leaf.symbol)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;

    #[test]
    fn a_zero_takes_away_what_has_a_value_for_certain() {
        let mut g = Graph::new();
        let [t, x] = ["t", "x"].map(|name| g.declare(name, Shape::scalar(), false));
        g.set_always_has_value(t);
        let [t, x] = [t, x].map(|symbol| g.leaf(Leaf::now(symbol, 0)));
        let (zero, one, absent) = (g.integer(0), g.integer(1), g.absent());
        let (pole, square) = (g.div(one, t), g.powi(t, 2));
        let below = g.add(one, square);
        let bounded = g.div(one, below);
        for certain in [t, square, below, one, zero] {
            assert_eq!(g.term(zero, certain), zero);
            assert_eq!(g.term(certain, zero), zero);
        }
        assert!(!g.has_value(pole) && !g.has_value(x) && g.term(zero, pole) == g.mul(zero, pole));
        let product = g.term(x, zero);
        let (negative, doubled) = (g.neg(product), g.add(product, x));
        let difference = g.sub(negative, product);
        assert!(product != zero && g.vanishes(product) && g.vanishes(difference) && !g.vanishes(doubled));
        for other in [t, x, pole, bounded, zero, absent] {
            assert_eq!([g.term(other, absent), g.term(absent, other)], [absent; 2]);
            assert!(g.add(absent, other) == other && g.add(other, absent) == other);
        }
        // Beside sums and products it is 0, which is another node.
        assert!(absent != zero && g.is_zero(absent) && g.settled(absent) == zero && !g.is_absent(zero));
        assert_eq!(g.div(absent, t), g.div(zero, t));
        assert_eq!(g.unary(Op::Cos, absent), one);
        g.share();
        let mut copy = g.clone();
        assert!(copy.integer(0) == zero && copy.absent() == absent);
    }
}
