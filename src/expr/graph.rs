//! The graph itself: nodes, leaves and the constructors that share them.

use super::field::Partials;
use super::hash::{FastHasher, FastMap};
use super::marks::reached;
use super::place::Place;
use super::{Op, Part, Rational, Shape};
use hashbrown::HashTable;
use serde::{Deserialize, Serialize};
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// A node of a [`Graph`]. Children have smaller numbers than their parents.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Expr(u32);

impl Expr {
    /// Position in the graph.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A declared symbol, by its number in the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(u32);

impl Symbol {
    /// Position in the list of symbols.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What a formula can depend on: one component of a symbol, of one of its derivatives, now or at a fixed time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Leaf {
    /// The symbol.
    pub symbol: Symbol,
    /// Row-major position in the symbol's stored components; 0 for a scalar.
    pub component: u16,
    /// Order of the time derivative; 0 for the value itself.
    pub rate: u8,
    /// Orders of the derivatives by coordinates, of a field; for anything else there are none.
    pub partials: Partials,
    /// `Some(e)`: the value at the time `e`, which is an expression without time-dependent leaves. `None`: now.
    pub instant: Option<Expr>,
}

/// One node.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// An exact rational number.
    Constant(Arc<Rational>),
    /// π.
    Pi,
    /// Something whose value comes from outside.
    Leaf(Leaf),
    /// An operation of one argument.
    Unary(Op, Expr),
    /// An operation of two arguments.
    Binary(Op, Expr, Expr),
}

impl Node {
    /// The arguments, oldest rooms of the graph first as written.
    pub fn children(&self) -> impl Iterator<Item = Expr> + use<> {
        let (a, b) = match *self {
            Node::Unary(_, a) => (Some(a), None),
            Node::Binary(_, a, b) => (Some(a), Some(b)),
            Node::Constant(_) | Node::Pi | Node::Leaf(_) => (None, None),
        };
        a.into_iter().chain(b)
    }
}

/// Name and shape of a symbol, for printing and for counting components.
#[derive(Clone, Debug)]
struct SymbolEntry {
    name: String,
    shape: Shape,
    /// Only the diagonal is stored: a square matrix whose other entries are zero.
    diagonal: bool,
    /// Another symbol has the name of a component of this one.
    numbered: bool,
    /// It has a value wherever it is asked for.
    has_value: bool,
}

/// Nodes of a graph, those from a position on.
#[derive(Clone, Debug, Default)]
struct Layer {
    first: usize,
    nodes: Vec<Node>,
    /// The nodes by what they say: one number each, since copies of a graph are many.
    index: HashTable<Expr>,
}

impl Layer {
    fn find(&self, hashed: u64, is_it: impl Fn(&Node) -> bool) -> Option<Expr> {
        self.index.find(hashed, |e| is_it(&self.nodes[e.index() - self.first])).copied()
    }

    fn push(&mut self, hashed: u64, node: Node) -> Expr {
        let Layer { first, nodes, index } = self;
        let e = Expr((*first + nodes.len()) as u32);
        nodes.push(node);
        index.insert_unique(hashed, e, |e| hash(&nodes[e.index() - *first]));
        e
    }

    /// A node that no look finds.
    fn push_unlisted(&mut self, node: Node) -> Expr {
        self.nodes.push(node);
        Expr((self.first + self.nodes.len() - 1) as u32)
    }
}

/// Hash-consed expressions over the declared symbols of one derivation.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    /// The first nodes, in common with copies: see [`Graph::share`].
    shared: Arc<Layer>,
    /// The nodes after them.
    own: Layer,
    symbols: Arc<Vec<SymbolEntry>>,
    /// What fields may depend on, see [`field`](super::field).
    pub(super) coordinates: Vec<(Symbol, u16)>,
    /// The positions of the coordinates on which a field depends, in the order in which its name shows them.
    pub(super) arguments: FastMap<Symbol, Vec<usize>>,
    /// Fields at other places, by their symbols, see [`place`](super::place).
    pub(super) places: Vec<(Symbol, Place)>,
    /// The structural zero, see [`zero`](super::zero): a constant that is looked up by its position, never by what it says.
    absent: Option<Expr>,
}

/// The same for a + b and b + a, which are one node.
fn hash(node: &Node) -> u64 {
    let mut hasher = FastHasher::default();
    match turned(node) {
        Some(turned @ Node::Binary(_, a, b)) if a < b => turned.hash(&mut hasher),
        _ => node.hash(&mut hasher),
    }
    hasher.finish()
}

/// The node with its arguments exchanged, where that makes no difference.
fn turned(node: &Node) -> Option<Node> {
    match *node {
        Node::Binary(op @ (Op::Add | Op::Mul | Op::Agm), a, b) => Some(Node::Binary(op, b, a)),
        _ => None,
    }
}

/// The size of a constant.
fn bits(r: &Rational) -> usize {
    use dashu_int::ops::BitTest;
    r.numerator().bit_len().max(r.denominator().bit_len())
}

/// The counted work of looking for a node, where all nodes are in the processor's caches.
const NODE_WORK: u64 = 60;
/// Nodes that the caches hold: with every so many more a look costs as much again, since memory is waited for.
const NEAR: usize = 1 << 16;
/// Most times that it costs as much.
const FAR: usize = 4;
/// The counted memory of a new node.
const NODE_BYTES: u64 = 64;

/// Whether a power of a constant is small enough to be written out: towers of powers must not exhaust the memory.
fn folds(r: &Rational, n: i32) -> bool {
    bits(r).saturating_mul(n.unsigned_abs() as usize) <= 4096
}

/// The largest exponent of a whole power.
const LARGEST_EXPONENT: u32 = 1 << 30;

/// Most bits of two constants that are combined.
const LARGEST_FOLDED: usize = 1 << 16;

/// Whether a product, quotient or sum of constants is small enough to be written out: repeated squares must not exhaust the
/// memory, either.
pub fn combines(x: &Rational, y: &Rational) -> bool {
    bits(x) + bits(y) <= LARGEST_FOLDED
}

/// A power of a constant, where it is small enough to be written out: see [`combines`].
pub fn raised(r: &Rational, n: i32) -> Option<Rational> {
    (bits(r).saturating_mul(n.unsigned_abs() as usize) <= LARGEST_FOLDED).then(|| r.pow(n as isize))
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Graph {
        Graph::default()
    }

    /// Registers a symbol. Names need not be unique here: scopes decide which one a formula means.
    ///
    /// With `diagonal`, `shape` is n × n and only the n diagonal components are stored.
    pub fn declare(&mut self, name: &str, shape: Shape, diagonal: bool) -> Symbol {
        Arc::make_mut(&mut self.symbols).push(SymbolEntry {
            name: name.to_owned(),
            shape,
            diagonal,
            numbered: false,
            has_value: false,
        });
        Symbol((self.symbols.len() - 1) as u32)
    }

    /// Says that another symbol has the name of a component of this one: components are then written `({\bf r})_1`.
    pub fn set_numbered(&mut self, symbol: Symbol) {
        Arc::make_mut(&mut self.symbols)[symbol.index()].numbered = true;
    }

    /// Whether another symbol has the name of a component of this one.
    pub(super) fn is_numbered(&self, symbol: Symbol) -> bool {
        self.symbols[symbol.index()].numbered
    }

    /// The LaTeX name a symbol was declared with.
    pub fn name(&self, symbol: Symbol) -> &str {
        &self.symbols[symbol.index()].name
    }

    /// The symbol that was last declared with this name.
    pub fn find_symbol(&self, name: &str) -> Option<Symbol> {
        self.symbols.iter().rposition(|entry| entry.name == name).map(|at| Symbol(at as u32))
    }

    /// The shape a symbol was declared with.
    pub fn shape(&self, symbol: Symbol) -> &Shape {
        &self.symbols[symbol.index()].shape
    }

    /// Whether the symbol has a value wherever it is asked for.
    pub(super) fn always_has_value(&self, symbol: Symbol) -> bool {
        self.symbols[symbol.index()].has_value
    }

    /// Says that the symbol has a value wherever it is asked for, as the time, the states of a motion and numbers that are given.
    pub fn set_always_has_value(&mut self, symbol: Symbol) {
        Arc::make_mut(&mut self.symbols)[symbol.index()].has_value = true;
    }

    /// Whether this is the structural zero.
    pub fn is_absent(&self, e: Expr) -> bool {
        self.absent == Some(e)
    }

    /// The structural zero. It is never a child of another node: where it is not passed on, 0 takes its place.
    pub fn absent(&mut self) -> Expr {
        let own = &mut self.own;
        *self.absent.get_or_insert_with(|| own.push_unlisted(Node::Constant(Arc::new(Rational::ZERO))))
    }

    /// Whether only the diagonal of the symbol is stored.
    pub fn is_diagonal(&self, symbol: Symbol) -> bool {
        self.symbols[symbol.index()].diagonal
    }

    /// Number of stored components of a symbol.
    pub fn component_count(&self, symbol: Symbol) -> usize {
        let entry = &self.symbols[symbol.index()];
        if entry.diagonal { entry.shape.extents()[0] as usize } else { entry.shape.len() }
    }

    /// Indices (counted from 1) of a stored component, as a formula writes them: `[2, 3]` for R₂₃, `[2]` for I₂ of a
    /// diagonal I, `[]` for a scalar.
    pub fn component_indices(&self, symbol: Symbol, component: u16) -> Vec<u16> {
        let entry = &self.symbols[symbol.index()];
        if entry.diagonal { vec![component + 1] } else { entry.shape.indices(component as usize) }
    }

    /// The same without the index of the part, for a complex symbol.
    pub fn written_indices(&self, symbol: Symbol, component: u16) -> Vec<u16> {
        let entry = &self.symbols[symbol.index()];
        if entry.diagonal { vec![component + 1] } else { entry.shape.real_indices(component as usize) }
    }

    /// Which part of a complex number a leaf is, if it is one.
    pub fn part(&self, leaf: Leaf) -> Option<Part> {
        self.shape(leaf.symbol).part(usize::from(leaf.component))
    }

    /// A node.
    pub fn node(&self, e: Expr) -> &Node {
        match e.index().checked_sub(self.own.first) {
            Some(at) => &self.own.nodes[at],
            None => &self.shared.nodes[e.index()],
        }
    }

    /// Lets copies that are made from now on have all nodes that there are in common: to make one then costs nothing.
    pub fn share(&mut self) {
        let own = std::mem::take(&mut self.own);
        let shared = Arc::make_mut(&mut self.shared);
        for (node, at) in own.nodes.into_iter().zip(own.first..) {
            match self.absent {
                Some(absent) if absent.index() == at => _ = shared.push_unlisted(node),
                _ => _ = shared.push(hash(&node), node),
            }
        }
        self.own.first = shared.nodes.len();
    }

    /// The node that is written like this, if there is one already.
    pub fn find(&self, node: &Node) -> Option<Expr> {
        self.found(hash(node), |n| n == node)
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.own.first + self.own.nodes.len()
    }

    /// Whether there is no node.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The symbol at a position of the list of symbols.
    pub fn symbol(&self, at: usize) -> Option<Symbol> {
        (at < self.symbols.len()).then_some(Symbol(at as u32))
    }

    /// Number of symbols declared so far.
    pub fn symbol_count(&self) -> usize {
        self.symbols.len()
    }

    fn found(&self, hashed: u64, is_it: impl Fn(&Node) -> bool) -> Option<Expr> {
        self.own.find(hashed, &is_it).or_else(|| self.shared.find(hashed, &is_it))
    }

    fn intern(&mut self, node: Node) -> Expr {
        meter::charge(NODE_WORK * (1 + self.len() / NEAR).min(FAR) as u64);
        // a + b and b + a are one node, printed in the order in which it was first written.
        let (hashed, turned) = (hash(&node), turned(&node));
        match self.found(hashed, |n| *n == node || turned.as_ref() == Some(n)) {
            Some(e) => e,
            None => {
                meter::grow(NODE_BYTES);
                self.own.push(hashed, node)
            }
        }
    }

    /// An exact rational.
    pub fn constant(&mut self, value: Rational) -> Expr {
        self.intern(Node::Constant(Arc::new(value)))
    }

    /// An integer.
    pub fn integer(&mut self, value: i64) -> Expr {
        self.constant(Rational::from(value))
    }

    /// π.
    pub fn pi(&mut self) -> Expr {
        self.intern(Node::Pi)
    }

    /// A leaf.
    pub fn leaf(&mut self, leaf: Leaf) -> Expr {
        self.intern(Node::Leaf(leaf))
    }

    /// The present value of a component of a symbol.
    pub fn component(&mut self, symbol: Symbol, component: u16) -> Expr {
        self.leaf(Leaf::now(symbol, component))
    }

    /// The constant value of a node, if it is written as one.
    pub fn as_constant(&self, e: Expr) -> Option<&Rational> {
        match self.node(e) {
            Node::Constant(r) => Some(r),
            _ => None,
        }
    }

    /// Whether the node is a constant that binary64 holds without rounding.
    pub fn is_binary64(&self, e: Expr) -> bool {
        let held = |r: &Rational| Rational::try_from(r.to_f64().value()).is_ok_and(|back| back == *r);
        self.as_constant(e).is_some_and(held)
    }

    /// Whether the node is the constant 0.
    pub fn is_zero(&self, e: Expr) -> bool {
        self.as_constant(e).is_some_and(|r| *r == Rational::ZERO)
    }

    /// Whether the node is the constant 1.
    pub fn is_one(&self, e: Expr) -> bool {
        self.as_constant(e).is_some_and(|r| *r == Rational::ONE)
    }

    /// An operation of one argument, with constants folded where that is exact.
    pub fn unary(&mut self, op: Op, a: Expr) -> Expr {
        debug_assert_eq!(op.arity(), 1);
        if let Some(absent) = self.unary_of_absent(op, a) {
            return absent;
        }
        let a = self.settled(a);
        match (op, self.node(a).clone()) {
            (Op::Neg, Node::Constant(r)) => self.constant(-&*r),
            (Op::Neg, Node::Unary(Op::Neg, inner)) => inner,
            (Op::Powi(1), _) => a,
            (Op::Powi(n), Node::Constant(r)) if (n >= 0 || *r != Rational::ZERO) && folds(&r, n) => {
                self.constant(r.pow(n as isize))
            }
            (Op::Powi(n), _) if n.unsigned_abs() > LARGEST_EXPONENT => self.whole_power(a, n.into()),
            (Op::Abs, Node::Constant(r)) => self.constant(if *r < Rational::ZERO { -&*r } else { (*r).clone() }),
            (Op::Sin | Op::Tan | Op::Arcsin | Op::Arctan | Op::Sinh | Op::Tanh | Op::Sqrt, Node::Constant(r))
                if *r == Rational::ZERO =>
            {
                a
            }
            (Op::Cos | Op::Cosh | Op::Exp, Node::Constant(r)) if *r == Rational::ZERO => self.integer(1),
            (Op::Sqrt, Node::Constant(r)) if *r == Rational::ONE => a,
            _ => self.intern(Node::Unary(op, a)),
        }
    }

    /// An operation of two arguments, with constants folded where that is exact, and neutral elements dropped.
    pub fn binary(&mut self, op: Op, a: Expr, b: Expr) -> Expr {
        debug_assert_eq!(op.arity(), 2);
        if let Some(e) = self.binary_of_absent(op, a, b) {
            return e;
        }
        let (a, b) = (self.settled(a), self.settled(b));
        if let (Node::Constant(x), Node::Constant(y)) = (self.node(a), self.node(b))
            && combines(x, y)
        {
            let folded = match op {
                Op::Add => Some(&**x + &**y),
                Op::Sub => Some(&**x - &**y),
                Op::Mul => Some(&**x * &**y),
                Op::Div if **y != Rational::ZERO => Some(&**x / &**y),
                _ => None,
            };
            if let Some(value) = folded {
                return self.constant(value);
            }
        }
        match op {
            Op::Add if self.is_zero(a) => b,
            Op::Add | Op::Sub if self.is_zero(b) => a,
            Op::Sub if self.is_zero(a) => self.unary(Op::Neg, b),
            Op::Mul if self.is_one(a) => b,
            Op::Mul | Op::Div if self.is_one(b) => a,
            Op::Pow => {
                let exponent = |factor: u8| {
                    self.as_constant(b).and_then(|r| i64::try_from(r.clone() * Rational::from(factor)).ok())
                };
                match (exponent(1), exponent(2)) {
                    (Some(n), _) => self.whole_power(a, n),
                    // x^{n/2} by the root, which has derivatives where it should.
                    (None, Some(n)) => {
                        let root = self.unary(Op::Sqrt, a);
                        self.whole_power(root, n)
                    }
                    (None, None) => self.intern(Node::Binary(op, a, b)),
                }
            }
            _ => self.intern(Node::Binary(op, a, b)),
        }
    }

    /// aⁿ, as powers of powers where n is too large for one.
    fn whole_power(&mut self, a: Expr, n: i64) -> Expr {
        let most = i64::from(LARGEST_EXPONENT);
        if let Some(n) = i32::try_from(n).ok().filter(|n| n.unsigned_abs() <= LARGEST_EXPONENT) {
            return self.unary(Op::Powi(n), a);
        }
        let whole = self.unary(Op::Powi(LARGEST_EXPONENT as i32), a);
        let (whole, rest) = (self.whole_power(whole, n / most), n % most);
        if rest == 0 {
            return whole;
        }
        let rest = self.whole_power(a, rest);
        self.mul(whole, rest)
    }

    /// aᵇ of an exponent that is not written out, whatever it is: it needs what the operation needs. Numbers that have it are folded.
    pub(super) fn power(&mut self, a: Expr, b: Expr) -> Expr {
        let (a, b) = (self.settled(a), self.settled(b));
        let has_value = match (self.as_constant(a), self.as_constant(b)) {
            (Some(a), Some(b)) => *a > Rational::ZERO || *a == Rational::ZERO && *b > Rational::ZERO,
            _ => false,
        };
        if has_value { self.binary(Op::Pow, a, b) } else { self.intern(Node::Binary(Op::Pow, a, b)) }
    }

    /// An operation of two arguments that is in the graph, of others: what is put into an exponent does not write it out.
    pub fn rebuilt(&mut self, op: Op, a: Expr, b: Expr) -> Expr {
        if op == Op::Pow { self.power(a, b) } else { self.binary(op, a, b) }
    }

    /// a + b.
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        self.binary(Op::Add, a, b)
    }
    /// a − b.
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        self.binary(Op::Sub, a, b)
    }
    /// a · b.
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        self.binary(Op::Mul, a, b)
    }
    /// a / b.
    pub fn div(&mut self, a: Expr, b: Expr) -> Expr {
        self.binary(Op::Div, a, b)
    }
    /// −a.
    pub fn neg(&mut self, a: Expr) -> Expr {
        self.unary(Op::Neg, a)
    }
    /// aⁿ.
    pub fn powi(&mut self, a: Expr, n: i32) -> Expr {
        self.unary(Op::Powi(n), a)
    }

    /// Every node that the roots depend on, roots included, children before parents.
    pub fn reachable(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<Expr> {
        let roots = roots.into_iter().map(|root| root.0).collect();
        let found = reached(roots, |e, open| open.extend(self.node(Expr(e)).children().map(|child| child.0)));
        meter::charge(8 * found.len() as u64);
        found.into_iter().map(Expr).collect()
    }

    /// The leaves that the roots depend on, in order of first appearance in the graph.
    pub fn leaves(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<Leaf> {
        let node = |e| match self.node(e) {
            Node::Leaf(leaf) => Some(*leaf),
            _ => None,
        };
        self.reachable(roots).into_iter().filter_map(node).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_goes_on_from_what_it_shares() {
        let mut alone = Graph::new();
        let x = alone.declare("x", Shape::scalar(), false);
        let x = alone.leaf(Leaf::now(x, 0));
        let two = alone.integer(2);
        let twice = alone.mul(two, x);
        let mut shared = alone.clone();
        // What there is may be shared at any time.
        for round in 0..3 {
            shared.share();
            let mut copy = shared.clone();
            let made = [&mut alone, &mut shared, &mut copy].map(|graph| {
                let known = graph.mul(x, two);
                let more = graph.integer(round + 7);
                let sum = graph.add(twice, more);
                let node = graph.node(sum).clone();
                assert_eq!(graph.find(&node), Some(sum));
                (known, more, sum, node, graph.len(), graph.leaves([sum]), graph.node(twice).clone())
            });
            assert_eq!(made[0].0, twice);
            assert_eq!(made[1], made[0]);
            assert_eq!(made[2], made[0]);
            let other = copy.integer(-round);
            assert!(other.index() + 1 == copy.len() && shared.len() < copy.len(), "a copy is by itself");
        }
    }
}
