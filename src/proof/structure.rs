//! What expressions are by how they are written, computed once for all questions about one graph.
//!
//! **In:** a graph, which only grows. **Out:** fractions, coefficients, leaves, and what a leaf is replaced by. The nodes that come
//! into being, and their order, are those of computing everything anew.

use std::rc::Rc;

use super::insertion::images;
use super::linear::Combinations;
use super::polynomial::{fraction_of_node, powers_of_node};
use super::values::Values;
use expr::{Expr, FastMap, Graph, Leaf, Node};
use number::{Bounded, NoValue};

/// Coefficients of a polynomial in one leaf, lowest first.
pub(super) type Powers = Rc<[Expr]>;

/// Highest degree that is looked at.
pub(super) const HIGHEST: usize = 8;

/// Real points at which the sign of an expression is looked at.
const SIGN_POINTS: usize = 8;

/// Size and leaves of an expression.
#[derive(Debug)]
pub(super) struct Extent {
    pub(super) size: usize,
    pub(super) leaves: Vec<Leaf>,
}

/// What is known of the expressions of one graph by how they are written.
#[derive(Debug, Default)]
pub(super) struct Structure {
    pub(super) combinations: Combinations,
    /// Expression → numerator and denominator.
    fractions: FastMap<Expr, (Expr, Expr)>,
    /// Expression and leaf → coefficients, for expressions that depend on the leaf.
    powers: FastMap<(Expr, u32), Option<Powers>>,
    /// Leaves by number.
    leaves: FastMap<Leaf, u32>,
    /// For each node a bit for every leaf below it, by the leaf's number modulo 127, and [`KNOWN`].
    below: Vec<u128>,
    extents: FastMap<Expr, Rc<Extent>>,
    /// Values at real points.
    real: [Values<Bounded>; SIGN_POINTS],
}

impl Structure {
    /// Brings the bits of an expression and of all below it up to date.
    fn look_below(&mut self, graph: &Graph, e: Expr) {
        if self.below.get(e.index()).is_some_and(|&bits| bits != 0) {
            return;
        }
        self.below.resize(graph.len().max(self.below.len()), 0);
        let (mut open, mut new) = (vec![e], Vec::new());
        while let Some(e) = open.pop() {
            if self.below[e.index()] == 0 {
                self.below[e.index()] = KNOWN;
                new.push(e);
                open.extend(graph.node(e).children());
            }
        }
        new.sort_unstable();
        for e in new {
            self.below[e.index()] |= match graph.node(e) {
                &Node::Leaf(leaf) => bit(self.number(leaf)),
                other => other.children().fold(0, |bits, c| bits | self.below[c.index()]),
            };
        }
    }

    fn number(&mut self, leaf: Leaf) -> u32 {
        let next = self.leaves.len() as u32;
        *self.leaves.entry(leaf).or_insert(next)
    }

    /// Whether an expression may depend on a leaf: an expression that does, does.
    fn may_depend(&self, e: Expr, leaf: u32) -> bool {
        self.below[e.index()] & bit(leaf) != 0
    }

    /// The nodes below an expression that may depend on a leaf and satisfy a condition, as do their parents; children before
    /// parents.
    fn dependent(&self, graph: &Graph, e: Expr, leaf: u32, wanted: impl Fn(Expr) -> bool) -> Vec<Expr> {
        let (mut open, mut found) = (vec![e], Vec::new());
        let mut seen = expr::FastSet::default();
        while let Some(e) = open.pop() {
            if self.may_depend(e, leaf) && wanted(e) && seen.insert(e) {
                found.push(e);
                open.extend(graph.node(e).children());
            }
        }
        found.sort_unstable();
        found
    }

    /// (N, D), see [`fraction`](super::polynomial::fraction).
    pub(super) fn fraction(&mut self, graph: &mut Graph, e: Expr) -> (Expr, Expr) {
        if let Some(&known) = self.fractions.get(&e) {
            return known;
        }
        let one = graph.integer(1);
        let (mut open, mut new) = (vec![e], Vec::new());
        while let Some(e) = open.pop() {
            self.fractions.entry(e).or_insert_with(|| {
                new.push(e);
                open.extend(graph.node(e).children());
                (e, one)
            });
        }
        new.sort_unstable();
        for node in new {
            let value = fraction_of_node(graph, &self.fractions, one, node);
            self.fractions.insert(node, value);
        }
        self.fractions.get(&e).copied().unwrap_or((e, one))
    }

    /// Coefficients of e as a polynomial in x, lowest first; `None` when x stands under a root or in a denominator, or the
    /// degree is above [`HIGHEST`].
    pub(super) fn powers(&mut self, graph: &mut Graph, e: Expr, x: Leaf) -> Option<Powers> {
        let number = self.number(x);
        if let Some(known) = self.powers.get(&(e, number)) {
            return known.clone();
        }
        let zero = graph.integer(0);
        let one = graph.integer(1);
        self.look_below(graph, e);
        // What cannot be written in powers stays on the list: it ends the search where it comes.
        let known = &self.powers;
        let new = self.dependent(graph, e, number, |e| !matches!(known.get(&(e, number)), Some(Some(_))));
        for node in new {
            let found = match graph.node(node) {
                Node::Leaf(leaf) if *leaf == x => Some(Some(Rc::from([zero, one].as_slice()))),
                _ => powers_of_node(graph, node, zero, HIGHEST, |e| self.powers.get(&(e, number))?.clone()),
            };
            // Nodes without x are their own coefficients.
            let Some(found) = found else { continue };
            let failed = found.is_none();
            self.powers.insert((node, number), found);
            if failed {
                self.powers.insert((e, number), None);
                return None;
            }
        }
        match self.powers.get(&(e, number)) {
            Some(known) => known.clone(),
            None => Some(Rc::from([e].as_slice())),
        }
    }

    /// Size and leaves.
    pub(super) fn extent(&mut self, graph: &Graph, e: Expr) -> Rc<Extent> {
        let known = self.extents.entry(e).or_insert_with(|| {
            let nodes = graph.reachable([e]);
            let leaf = |&e: &Expr| match graph.node(e) {
                Node::Leaf(leaf) => Some(*leaf),
                _ => None,
            };
            Rc::new(Extent { size: nodes.len(), leaves: nodes.iter().filter_map(leaf).collect() })
        });
        Rc::clone(known)
    }

    /// Whether an expression depends on a leaf.
    pub(super) fn depends(&mut self, graph: &Graph, e: Expr, leaf: Leaf) -> bool {
        self.look_below(graph, e);
        let number = self.number(leaf);
        self.may_depend(e, number) && self.extent(graph, e).leaves.contains(&leaf)
    }

    /// The expression with a leaf replaced.
    pub(super) fn replaced(&mut self, graph: &mut Graph, e: Expr, leaf: Leaf, value: Expr) -> Expr {
        self.look_below(graph, e);
        let number = self.number(leaf);
        let order = self.dependent(graph, e, number, |_| true);
        let image = images(graph, order, leaf, value);
        image.get(&e).copied().unwrap_or(e)
    }

    /// Whether an expression is certainly positive at one real point, and certainly negative at another.
    pub(super) fn has_both_signs(&mut self, graph: &Graph, e: Expr) -> bool {
        let (mut above, mut below) = (false, false);
        for point in 0..SIGN_POINTS {
            let Ok(value) = self.real_value(graph, point, e) else { continue };
            if value.contains_zero() || !value.value.is_finite() {
                continue;
            }
            above |= value.value > 0.0;
            below |= value.value < 0.0;
            if above && below {
                return true;
            }
        }
        false
    }

    fn real_value(&mut self, graph: &Graph, point: usize, e: Expr) -> Result<Bounded, NoValue> {
        if let Some(known) = self.real[point].of(e) {
            return known;
        }
        let new = self.real[point].missing(graph, &[e]);
        for &node in &new {
            if let Node::Leaf(leaf) = *graph.node(node) {
                // Eighths of either sign, the same for a leaf whatever is asked first.
                let number = u64::from(self.number(leaf)) * SIGN_POINTS as u64 + point as u64 + 1;
                let mixed =
                    number.wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(29).wrapping_mul(0xBF58_476D_1CE4_E5B9);
                let magnitude = (3 + (mixed >> 40) % 18) as f64 / 8.0;
                let value = if mixed >> 63 == 0 { magnitude } else { -magnitude };
                self.real[point].set(node, Ok(Bounded::exact(value)));
            }
        }
        self.real[point].compute(&(), graph, &new);
        self.real[point].of(e).unwrap_or(Err(NoValue::Unsupported))
    }
}

fn bit(leaf: u32) -> u128 {
    1 << (leaf % 127)
}

/// The bits of the leaves of a node are known.
const KNOWN: u128 = 1 << 127;

#[cfg(test)]
mod tests {
    use super::super::polynomial::fraction;
    use super::*;
    use expr::{Op, Shape};

    fn graph() -> (Graph, [Leaf; 3]) {
        let mut g = Graph::new();
        let leaves = ["x", "y", "z"].map(|n| {
            let symbol = g.declare(n, Shape::scalar(), false);
            Leaf::now(symbol, 0)
        });
        (g, leaves)
    }

    #[test]
    fn what_is_kept_is_what_would_be_computed() {
        let (mut g, [x, y, z]) = graph();
        let (a, b, c) = (g.leaf(x), g.leaf(y), g.leaf(z));
        let (one, two) = (g.integer(1), g.integer(2));
        let sum = g.add(a, b);
        let square = g.powi(sum, 2);
        let quotient = g.div(c, sum);
        let root = g.unary(Op::Sqrt, sum);
        let product = g.mul(square, c);
        let all = {
            let (deep, rooted) = (g.add(quotient, square), g.mul(root, c));
            let ninth = g.powi(a, 9);
            [sum, square, quotient, root, product, deep, rooted, ninth]
        };
        let mut s = Structure::default();
        // Twice: the second time everything is known.
        for _ in 0..2 {
            for e in all {
                assert_eq!(s.fraction(&mut g, e), fraction(&mut g, e));
                for leaf in [x, y, z] {
                    assert_eq!(s.depends(&g, e, leaf), g.leaves([e]).contains(&leaf));
                    let replaced = s.replaced(&mut g, e, leaf, two);
                    assert_eq!(replaced, g.replaced(e, |_, l| (l == leaf).then_some(two)));
                }
            }
            let twice = g.mul(two, b);
            assert!(s.powers(&mut g, square, x).is_some_and(|p| p.len() == 3 && p[2] == one));
            assert!(s.powers(&mut g, product, z).is_some_and(|p| p.len() == 2 && p[1] == square));
            assert_eq!(s.powers(&mut g, twice, z).as_deref(), Some([twice].as_slice()));
            // Below a division, under a root, and above the highest degree; what contains them, too.
            for e in [quotient, root, all[5], all[6], all[7]] {
                assert_eq!(s.powers(&mut g, e, x), None);
            }
            assert!(s.powers(&mut g, all[6], z).is_some());
        }
    }

    #[test]
    fn a_sum_of_squares_never_has_both_signs() {
        let (mut g, [x, y, z]) = graph();
        let (a, b, c) = (g.leaf(x), g.leaf(y), g.leaf(z));
        let [aa, bb] = [a, b].map(|e| g.powi(e, 2));
        let circle = g.add(aa, bb);
        let sum = g.add(a, b);
        let twice = g.mul(a, b);
        let expanded = {
            // x² + 2xy + y² − (x + y)² + z², whose terms cancel but for one.
            let double = g.add(twice, twice);
            let all = g.add(circle, double);
            let square = g.powi(sum, 2);
            let nothing = g.sub(all, square);
            let last = g.powi(c, 2);
            g.add(nothing, last)
        };
        let negative = g.neg(circle);
        let mut s = Structure::default();
        for e in [circle, negative, expanded, aa] {
            assert!(!s.has_both_signs(&g, e));
        }
        let difference = g.sub(aa, bb);
        for e in [sum, difference, twice, c] {
            assert!(s.has_both_signs(&g, e));
        }
        // Without a value nothing is said.
        let root = g.unary(Op::Sqrt, negative);
        assert!(!s.has_both_signs(&g, root));
    }
}
