//! Roots by other roots: products that are squares, and roots of sums with a root.

use super::super::generators::Generator;
use super::super::linear::Combinations;
use super::super::polynomial::{flat, fraction, is_nothing, polynomial_root, replaced, whole_root};
use super::Roots;
use super::{MOST_NESTED, MOST_PASSES, MOST_RELATED};
use expr::{Expr, Node, Op, Rational};

impl Roots<'_> {
    /// √e = √(e·b)/√b where e·b is a square, for b a radicand seen before or a product of two: none of them is negative, as
    /// all roots of the problem have values.
    pub(super) fn by_others(&mut self, e: Expr) -> Option<Expr> {
        if !self.further {
            return None;
        }
        let seen: Vec<Expr> = self.ordered.iter().copied().take(MOST_RELATED).collect();
        let pairs = seen.iter().enumerate().flat_map(|(i, &a)| seen[i + 1..].iter().map(move |&b| (a, Some(b))));
        let choices: Vec<(Expr, Option<Expr>)> = seen.iter().map(|&a| (a, None)).chain(pairs).collect();
        for (a, b) in choices {
            let others: Vec<Expr> = [Some(a), b].into_iter().flatten().collect();
            let all = others.iter().fold(e, |product, &b| self.graph.mul(product, b));
            let Some((m, q)) = polynomial_root(self.graph, all) else { continue };
            let size = self.absolute(m);
            let constant = self.constant_root(&q);
            let mut out = self.graph.mul(constant, size);
            for b in others {
                let root = *self.unit_roots.get(&b)?;
                out = self.graph.div(out, root);
            }
            return Some(out);
        }
        None
    }

    /// √(a + b√c) = |√((a + m)/2) ± √((a − m)/2)| where a² − b²c = m², with the sign of b.
    ///
    /// With a ≥ 0 and m² = a² − b²c ≤ a² both roots on the right exist.
    /// The difference of the roots has the sign of m.
    pub(super) fn nested(&mut self, e: Expr) -> Option<Expr> {
        let below = self.graph.reachable([e]);
        if !self.further || below.len() > MOST_NESTED {
            return None;
        }
        let (zero, one, two) = (self.graph.integer(0), self.graph.integer(1), self.graph.integer(2));
        let roots: Vec<(Expr, Expr)> = self.unit_roots.iter().map(|(&c, &root)| (c, root)).collect();
        let mut roots: Vec<(Expr, Expr)> = roots.into_iter().filter(|(_, root)| below.contains(root)).collect();
        // The outermost first.
        roots.sort_unstable_by_key(|&(_, root)| std::cmp::Reverse(root));
        for (c, root) in roots {
            let mut at = |value: Expr| replaced(self.graph, e, root, value);
            let (a, b) = (at(zero), at(one));
            let b = self.graph.sub(b, a);
            let (a, b) = (flat(self.graph, a), flat(self.graph, b));
            let (_, linear) = {
                let product = self.graph.mul(b, root);
                let sum = self.graph.add(a, product);
                (sum, self.graph.sub(e, sum))
            };
            let plain = [a, b].iter().all(|&x| !self.graph.reachable([x]).contains(&root));
            if !plain || !is_nothing(self.graph, linear) || self.graph.is_zero(a) {
                continue;
            }
            let sign = self.sign_of_terms(b);
            let (positive, negative) = (sign == Some(true), sign == Some(false));
            // That a is not negative must be known: where the root is 0, it need not follow.
            if !positive && !negative || self.sign_of_terms(a) != Some(true) && !self.not_negative(a) {
                continue;
            }
            let (aa, bb) = (self.graph.powi(a, 2), self.graph.powi(b, 2));
            let product = self.graph.mul(bb, c);
            let difference = self.graph.sub(aa, product);
            let difference = self.without_squared_roots(difference);
            let Some((m, q)) = polynomial_root(self.graph, difference) else { continue };
            let (n, d) = q.clone().into_parts();
            let (Some(n), Some(d)) = (whole_root(&Rational::from(n)), whole_root(&Rational::from(d))) else { continue };
            let scale = self.graph.constant(n / d);
            let m = self.graph.mul(scale, m);
            let (sum, less) = (self.graph.add(a, m), self.graph.sub(a, m));
            let halves = [sum, less].map(|x| {
                let half = self.graph.div(x, two);
                flat(self.graph, half)
            });
            for half in halves {
                self.facts.note_not_negative(self.graph, half);
            }
            let [p, s] = halves.map(|half| self.root(half));
            if positive {
                return Some(self.graph.add(p, s));
            }
            let difference = self.graph.sub(p, s);
            let m = flat(self.graph, m);
            return Some(if self.not_negative(m) {
                difference
            } else if self.not_positive(m) {
                self.graph.neg(difference)
            } else {
                let sign = self.sign_of(m);
                self.graph.mul(sign, difference)
            });
        }
        None
    }

    /// A radicand in which squares of roots stand, without them.
    pub(super) fn without_roots_of(&mut self, e: Expr) -> Expr {
        let below = self.graph.reachable([e]);
        let rooted = |&e: &Expr| matches!(self.graph.node(e), Node::Unary(Op::Sqrt, _));
        if below.len() > MOST_NESTED || !below.iter().any(rooted) {
            return e;
        }
        let (top, under) = fraction(self.graph, e);
        let (a, b) = (self.without_squared_roots(top), self.without_squared_roots(under));
        if self.graph.is_zero(b) {
            return e;
        }
        let plain = self.graph.div(a, b);
        if self.graph.reachable([plain]).len() < below.len() { plain } else { e }
    }

    /// The expression multiplied out, with (√u)² = u and σ² = 1.
    pub(super) fn without_squared_roots(&mut self, e: Expr) -> Expr {
        let mut e = flat(self.graph, e);
        for _ in 0..MOST_PASSES {
            let all = Combinations::default().of(self.graph, e);
            let mut out = self.graph.integer(0);
            for (m, q) in &all {
                let mut term = self.graph.constant(q.clone());
                for &(base, k) in m {
                    let (base, k) = match *self.graph.node(base) {
                        Node::Unary(Op::Sqrt, u) if k > 1 => {
                            let power = self.graph.powi(u, k / 2);
                            term = self.graph.mul(term, power);
                            (base, k % 2)
                        }
                        Node::Leaf(leaf) if self.generators.get(leaf) == Some(&Generator::Sign) => (base, k % 2),
                        Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => (base, k),
                    };
                    if k != 0 {
                        let power = self.graph.powi(base, k);
                        term = self.graph.mul(term, power);
                    }
                }
                out = self.graph.add(out, term);
            }
            let next = flat(self.graph, out);
            if next == e {
                break;
            }
            e = next;
        }
        e
    }
}
