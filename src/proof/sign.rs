//! What is known of the signs of lowered expressions.

use super::generators::{Generator, Generators};
use expr::{Expr, Graph, Node, Op, Rational};
use expr::{FastMap, FastSet};

/// Facts about lowered expressions, and what follows from them by structure.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Facts {
    pub(super) positive: FastSet<Expr>,
    pub(super) not_negative: FastSet<Expr>,
    /// Negatives of what is not negative.
    pub(super) not_positive: FastSet<Expr>,
    pub(super) nonzero: FastSet<Expr>,
}

/// Knowledge of a sign, by two independent statements each way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Known {
    /// x ≥ 0.
    pub(super) not_negative: bool,
    /// x ≤ 0.
    pub(super) not_positive: bool,
    /// x ≠ 0.
    pub(super) nonzero: bool,
}

/// −e, in the forms in which it may occur: −e, and b − a for a − b.
fn mirrored(graph: &mut Graph, e: Expr) -> [Expr; 2] {
    let negative = graph.neg(e);
    match *graph.node(e) {
        Node::Binary(Op::Sub, a, b) => [negative, graph.sub(b, a)],
        _ => [negative; 2],
    }
}

impl Facts {
    /// Notes that e > 0.
    pub(super) fn note_positive(&mut self, graph: &mut Graph, e: Expr) {
        self.positive.insert(e);
        let mirrored = mirrored(graph, e);
        self.not_positive.extend(mirrored);
        self.nonzero.extend(mirrored);
    }

    /// Notes that e ≥ 0.
    pub(super) fn note_not_negative(&mut self, graph: &mut Graph, e: Expr) {
        self.not_negative.insert(e);
        self.not_positive.extend(mirrored(graph, e));
    }

    /// Signs of a node and everything below it, wherever it has a value.
    pub(super) fn sign(&self, graph: &Graph, generators: &Generators, e: Expr) -> Known {
        self.sign_after(graph, generators, e, &mut FastMap::default())
    }

    /// The same, after others: `known` holds what these facts say of nodes, and grows.
    pub(super) fn sign_after(
        &self,
        graph: &Graph,
        generators: &Generators,
        e: Expr,
        known: &mut FastMap<Expr, Known>,
    ) -> Known {
        if let Some(&k) = known.get(&e) {
            return k;
        }
        self.look_below(graph, generators, [e], known);
        known.get(&e).copied().unwrap_or_default()
    }

    /// What would be known of an expression if the facts said nothing of it but that it is not positive.
    pub(super) fn sign_by_parts(
        &self,
        graph: &Graph,
        generators: &Generators,
        e: Expr,
        known: &mut FastMap<Expr, Known>,
    ) -> Known {
        self.look_below(graph, generators, graph.node(e).children(), known);
        let mut k = self.step(graph, generators, e, known);
        k.not_positive |= self.not_positive.contains(&e);
        k
    }

    fn look_below(
        &self,
        graph: &Graph,
        generators: &Generators,
        roots: impl IntoIterator<Item = Expr>,
        known: &mut FastMap<Expr, Known>,
    ) {
        let (mut open, mut new): (Vec<Expr>, Vec<Expr>) = (roots.into_iter().collect(), Vec::new());
        while let Some(e) = open.pop() {
            known.entry(e).or_insert_with(|| {
                new.push(e);
                open.extend(graph.node(e).children());
                Known::default()
            });
        }
        new.sort_unstable();
        for node in new {
            let mut k = self.step(graph, generators, node, known);
            k.not_negative |= self.positive.contains(&node) || self.not_negative.contains(&node);
            k.not_positive |= self.not_positive.contains(&node);
            k.nonzero |= self.positive.contains(&node) || self.nonzero.contains(&node);
            known.insert(node, k);
        }
    }

    fn step(&self, graph: &Graph, generators: &Generators, node: Expr, known: &FastMap<Expr, Known>) -> Known {
        let at = |e: Expr| known.get(&e).copied().unwrap_or_default();
        match *graph.node(node) {
            Node::Constant(ref r) => Known {
                not_negative: **r >= Rational::ZERO,
                not_positive: **r <= Rational::ZERO,
                nonzero: **r != Rational::ZERO,
            },
            Node::Pi => Known { not_negative: true, not_positive: false, nonzero: true },
            Node::Leaf(leaf) => match generators.get(leaf) {
                Some(Generator::Exponential(_)) => Known { not_negative: true, not_positive: false, nonzero: true },
                Some(Generator::Opaque(of)) if matches!(graph.node(*of), Node::Pi) => {
                    Known { not_negative: true, not_positive: false, nonzero: true }
                }
                Some(Generator::Sign) => Known { nonzero: true, ..Known::default() },
                _ => Known::default(),
            },
            Node::Unary(op, a) => {
                let a = at(a);
                match op {
                    Op::Neg => Known { not_negative: a.not_positive, not_positive: a.not_negative, nonzero: a.nonzero },
                    Op::Sqrt | Op::Abs => Known { not_negative: true, not_positive: false, nonzero: a.nonzero },
                    Op::Powi(n) if n % 2 == 0 => {
                        Known { not_negative: true, not_positive: false, nonzero: n <= 0 || a.nonzero }
                    }
                    Op::Powi(n) => Known { nonzero: n < 0 || a.nonzero, ..a },
                    _ => Known::default(),
                }
            }
            Node::Binary(op, x, y) => {
                let (a, b) = (at(x), at(y));
                let sum = |a: Known, b: Known| {
                    let up = a.not_negative && b.not_negative;
                    let down = a.not_positive && b.not_positive;
                    Known { not_negative: up, not_positive: down, nonzero: (up || down) && (a.nonzero || b.nonzero) }
                };
                match op {
                    Op::Add => sum(a, b),
                    Op::Sub => {
                        sum(a, Known { not_negative: b.not_positive, not_positive: b.not_negative, nonzero: b.nonzero })
                    }
                    Op::Mul | Op::Div => {
                        let same = (a.not_negative && b.not_negative) || (a.not_positive && b.not_positive);
                        let opposite = (a.not_negative && b.not_positive) || (a.not_positive && b.not_negative);
                        Known {
                            not_negative: same || (op == Op::Mul && x == y),
                            not_positive: opposite,
                            nonzero: a.nonzero && (op == Op::Div || b.nonzero),
                        }
                    }
                    _ => Known::default(),
                }
            }
        }
    }
}
