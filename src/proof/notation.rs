//! A problem as a reader's program has it, and what that program computes.
//!
//! **In:** expressions as they were claimed and given. **Out:** their texts in the notation of Python, and for each expression
//! the polynomials (N, D) with e = N/D that a plain evaluation of that text gives: sums are brought to a common denominator,
//! nothing is cancelled, nothing is simplified. The search for a certificate begins with exactly these polynomials, so that
//! the reader's program, which computes them from the text, arrives at the same.
//!
//! A function (cos, √, |·|, ln …) is a name for what it is lowered to: a table says which polynomial stands for which call.

use super::generators::{Generator, Generators};
use expr::{Expr, FastMap, FastSet, Graph, Leaf, Node, Op};

/// Longest text that is not cut in two, in characters; deepest nesting of its parentheses.
const LONGEST: usize = 600;
const DEEPEST: usize = 24;

/// Whether a node is a function for a reader: everything but +, −, ×, ÷, integer powers, numbers and symbols.
pub(super) fn is_function(node: &Node) -> bool {
    match *node {
        Node::Constant(_) | Node::Leaf(_) => false,
        Node::Pi => true,
        Node::Unary(op, _) => !matches!(op, Op::Neg | Op::Powi(_)),
        Node::Binary(op, ..) => !matches!(op, Op::Add | Op::Sub | Op::Mul | Op::Div),
    }
}

/// The outermost functions of expressions, definitions looked into, in order.
pub(super) fn functions(
    graph: &Graph,
    roots: impl IntoIterator<Item = Expr>,
    definitions: &FastMap<Leaf, Expr>,
) -> Vec<Expr> {
    let (mut out, mut seen) = (Vec::new(), FastSet::default());
    let mut open: Vec<Expr> = roots.into_iter().collect();
    open.reverse();
    while let Some(e) = open.pop() {
        if !seen.insert(e) {
            continue;
        }
        let node = graph.node(e);
        match node {
            _ if is_function(node) => out.push(e),
            Node::Leaf(leaf) => open.extend(definitions.get(leaf)),
            _ => open.extend(node.children()),
        }
    }
    out
}

/// The name of a function in SymPy; `None` for what is no function of one name.
fn name_of(op: Op) -> Option<&'static str> {
    Some(match op {
        Op::Sqrt => "sqrt",
        Op::Abs => "Abs",
        Op::Sin => "sin",
        Op::Cos => "cos",
        Op::Tan => "tan",
        Op::Exp => "exp",
        Op::Ln => "log",
        Op::Sinh => "sinh",
        Op::Cosh => "cosh",
        Op::Tanh => "tanh",
        Op::Arcsin => "asin",
        Op::Arccos => "acos",
        Op::Arctan => "atan",
        Op::Arctan2 => "atan2",
        Op::Agm => "agm",
        Op::Pow => "power",
        _ => return None,
    })
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bond {
    Sum,
    Product,
    Sign,
    Atom,
}

#[derive(Clone)]
struct Text {
    text: String,
    bond: Bond,
    depth: usize,
}

/// Writes expressions; what is long or used by name is written once, as a definition.
pub(super) struct Writer<'a> {
    graph: &'a Graph,
    /// Names of leaves, and of roots and absolute values that are variables.
    names: &'a FastMap<Expr, String>,
    /// What leaves are by what is given.
    given: &'a FastMap<Leaf, Expr>,
    /// Whether roots are written by their names.
    roots_by_name: bool,
    known: FastMap<Expr, Text>,
    /// Definitions so far: a name, and what it stands for.
    pub(super) definitions: Vec<(String, String)>,
    prefix: &'static str,
}

impl<'a> Writer<'a> {
    /// `prefix` begins the names of parts of long texts.
    pub(super) fn new(
        graph: &'a Graph,
        names: &'a FastMap<Expr, String>,
        given: &'a FastMap<Leaf, Expr>,
        roots_by_name: bool,
        prefix: &'static str,
    ) -> Writer<'a> {
        Writer { graph, names, given, roots_by_name, known: FastMap::default(), definitions: Vec::new(), prefix }
    }

    /// The text of an expression; `None` where something in it has no name.
    pub(super) fn write(&mut self, e: Expr) -> Option<String> {
        for node in self.graph.reachable([e]) {
            if self.known.contains_key(&node) {
                continue;
            }
            if let Node::Leaf(leaf) = self.graph.node(node)
                && let Some(&value) = self.given.get(leaf)
            {
                let text = self.write(value)?;
                self.definitions.push((self.names.get(&node)?.clone(), text));
            }
            let text = self.step(node)?;
            let text = if node != e && (text.text.len() > LONGEST || text.depth > DEEPEST) {
                let name = format!("{}{}", self.prefix, self.definitions.len() + 1);
                self.definitions.push((name.clone(), text.text));
                Text { text: name, bond: Bond::Atom, depth: 0 }
            } else {
                text
            };
            self.known.insert(node, text);
        }
        Some(self.known.get(&e)?.text.clone())
    }

    fn step(&self, node: Expr) -> Option<Text> {
        if let (true, Some(name)) = (self.roots_by_name || !is_function(self.graph.node(node)), self.names.get(&node)) {
            return Some(Text { text: name.clone(), bond: Bond::Atom, depth: 0 });
        }
        let of = |e: Expr| self.known.get(&e);
        let within = |t: &Text, least: Bond| {
            if t.bond < least { (format!("({})", t.text), t.depth + 1) } else { (t.text.clone(), t.depth) }
        };
        Some(match *self.graph.node(node) {
            Node::Constant(ref r) => {
                let (top, under) = (r.numerator().to_string(), r.denominator().to_string());
                let text = if under == "1" { top } else { format!("{top}/{under}") };
                let bond = match (text.starts_with('-'), under == "1") {
                    (true, _) => Bond::Sum,
                    (_, true) => Bond::Atom,
                    _ => Bond::Product,
                };
                Text { text, bond, depth: 0 }
            }
            Node::Pi => Text { text: "pi".to_owned(), bond: Bond::Atom, depth: 0 },
            // Every leaf has a name.
            Node::Leaf(_) => return None,
            Node::Unary(Op::Neg, a) => {
                let (a, depth) = within(of(a)?, Bond::Sign);
                Text { text: format!("-{a}"), bond: Bond::Sum, depth }
            }
            Node::Unary(Op::Powi(k), a) => {
                let (a, depth) = within(of(a)?, Bond::Atom);
                let k = if k < 0 { format!("({k})") } else { k.to_string() };
                Text { text: format!("{a}**{k}"), bond: Bond::Sign, depth }
            }
            Node::Unary(op, a) => {
                let a = of(a)?;
                Text { text: format!("{}({})", name_of(op)?, a.text), bond: Bond::Atom, depth: a.depth + 1 }
            }
            Node::Binary(op, a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                let (sign, own, right) = match op {
                    Op::Add => (" + ", Bond::Sum, Bond::Product),
                    Op::Sub => (" - ", Bond::Sum, Bond::Product),
                    Op::Mul => ("*", Bond::Product, Bond::Sign),
                    Op::Div => ("/", Bond::Product, Bond::Sign),
                    other => {
                        let text = format!("{}({}, {})", name_of(other)?, a.text, b.text);
                        return Some(Text { text, bond: Bond::Atom, depth: a.depth.max(b.depth) + 1 });
                    }
                };
                let ((a, i), (b, j)) = (within(a, own), within(b, right));
                Text { text: format!("{a}{sign}{b}"), bond: own, depth: i.max(j) }
            }
        })
    }
}

/// What a generator stands for, as an expression of the problem; `None` for what is no function of anything.
pub(super) fn meaning(graph: &mut Graph, generators: &Generators, leaf: Leaf) -> Option<Option<Expr>> {
    Some(match *generators.get(leaf)? {
        Generator::Cosine(a) => Some(graph.unary(Op::Cos, a)),
        Generator::Sine(a) => Some(graph.unary(Op::Sin, a)),
        Generator::Exponential(a) => Some(graph.unary(Op::Exp, a)),
        Generator::Opaque(e) => Some(e),
        Generator::Sign | Generator::Half | Generator::Free => None,
    })
}
