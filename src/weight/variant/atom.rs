//! What a missing factor or term may be made of.
//!
//! **In:** a formula, what else is written of the same matter, and the declared symbols. **Out:** atoms: quantities that
//! stand in a product or a sum by themselves, the nearest to the formula first.
//!
//! An author leaves out what belongs to the matter. So the atoms are the formula's own factors and their kin (sine for cosine,
//! another component, a value at the start, a rate), what is given (the time, parameters), the factors of the other formulas of
//! the claim and of its system, and the other scalars of the file. Nothing is known of any field.

use super::edit::confused;
use super::tree::{is_transpose, walk, without_places};
use super::vocabulary::{Vocabulary, Word};
use crate::latex::syntax::{Chain, Node, NodeKind, Sign, SubItem, SymbolNode};

/// Most atoms.
const MOST_ATOMS: usize = 34;

/// Atoms, each once, without places.
struct Collected<'v> {
    vocabulary: &'v Vocabulary,
    out: Vec<Node>,
}

fn symbol(s: SymbolNode) -> Node {
    Node::new(NodeKind::Symbol(s), 0..0)
}

fn bare(s: &SymbolNode) -> SymbolNode {
    SymbolNode { sup: None, sup_first: false, ..s.clone() }
}

impl Collected<'_> {
    fn put(&mut self, node: Node) {
        let plain = without_places(&node);
        if !self.out.contains(&plain) {
            self.out.push(plain);
        }
    }

    /// The factors of a formula: symbols, functions, exponentials, roots.
    fn factors(&mut self, nodes: &[&Node]) {
        for node in nodes {
            match &node.kind {
                NodeKind::Symbol(s) if !is_transpose(node) => {
                    let declared = self.vocabulary.word(s).is_some_and(|(w, _)| !w.is_function);
                    if declared || s.arguments.is_some() {
                        self.put(symbol(bare(s)));
                    }
                }
                NodeKind::Function(f, _, arguments) => {
                    let function = |f: &str| Node::new(NodeKind::Function(f.into(), None, arguments.clone()), 0..0);
                    self.put(function(f));
                    if let Some(other) = confused(f).filter(|_| matches!(f.as_str(), "sin" | "cos")) {
                        self.put(function(other));
                    }
                }
                NodeKind::Exponential { .. } | NodeKind::Root(..) | NodeKind::Pi => self.put((*node).clone()),
                _ => {}
            }
        }
    }

    /// Other components of the vectors that occur: I_2 where I_1 does.
    fn components(&mut self, nodes: &[&Node]) {
        for node in nodes {
            let NodeKind::Symbol(s) = &node.kind else { continue };
            let Some((word, own)) = self.vocabulary.word(s) else { continue };
            if let Some([SubItem::Digit(_)]) = s.sub.as_deref().and_then(|sub| sub.get(own..)) {
                for d in 1..=extent(word) {
                    self.put(symbol(with_digit(s, own, d)));
                }
            }
        }
    }

    /// Sums of two terms in parentheses, with the other sign, and between the other components of the same vector.
    fn groups(&mut self, nodes: &[&Node]) {
        for node in nodes {
            let NodeKind::Group(inner, bracket) = &node.kind else { continue };
            let NodeKind::Sum(terms) = &inner.kind else { continue };
            let [(first, a), (second, b)] = terms.as_slice() else { continue };
            let sum = |a: &Node, sign: Sign, b: &Node| {
                let sum = NodeKind::Sum(vec![(*first, a.clone()), (sign, b.clone())]);
                Node::new(NodeKind::Group(Box::new(Node::new(sum, 0..0)), *bracket), 0..0)
            };
            self.put(sum(a, *second, b));
            match second {
                Sign::Plus => self.put(sum(a, Sign::Minus, b)),
                Sign::Minus => self.put(sum(a, Sign::Plus, b)),
                Sign::PlusMinus | Sign::MinusPlus => {}
            }
            let (NodeKind::Symbol(s), NodeKind::Symbol(t)) = (&a.kind, &b.kind) else { continue };
            let (Some((word, own)), Some((other, _))) = (self.vocabulary.word(s), self.vocabulary.word(t)) else {
                continue;
            };
            let digits =
                |s: &SymbolNode| matches!(s.sub.as_deref().and_then(|sub| sub.get(own..)), Some([SubItem::Digit(_)]));
            if word == other && digits(s) && digits(t) {
                let count = extent(word);
                for (i, j) in (1..=count).flat_map(|i| (i + 1..=count).map(move |j| (i, j))) {
                    self.put(sum(&symbol(with_digit(s, own, j)), *second, &symbol(with_digit(t, own, i))));
                }
            }
        }
    }

    /// Sines and cosines of what stands in their arguments.
    fn angles(&mut self, nodes: &[&Node]) {
        for node in nodes {
            let NodeKind::Function(f, _, arguments) = &node.kind else { continue };
            if !matches!(f.as_str(), "sin" | "cos") {
                continue;
            }
            let mut inner = Vec::new();
            arguments.iter().for_each(|a| walk(a, &mut inner));
            for part in inner {
                let NodeKind::Symbol(s) = &part.kind else { continue };
                if self.vocabulary.word(s).is_some_and(|(w, _)| w.moves && w.rank == 0) && s.dots == 0 {
                    for f in ["sin", "cos"] {
                        self.put(Node::new(NodeKind::Function(f.into(), None, vec![part.clone()]), 0..0));
                    }
                }
            }
        }
    }

    /// Values at the start, where such a value occurs.
    fn starts(&mut self, nodes: &[&Node]) {
        let start = nodes.iter().find_map(|n| match &n.kind {
            NodeKind::Symbol(s) if s.arguments.as_ref().is_some_and(|a| a.len() == 1 && a[0].is_zero()) => Some(s),
            _ => None,
        });
        let Some(start) = start else { return };
        for node in nodes {
            if let NodeKind::Symbol(s) = &node.kind
                && s.arguments.is_none()
                && self.vocabulary.word(s).is_some_and(|(w, _)| w.moves)
            {
                let (arguments, arguments_text) = (start.arguments.clone(), start.arguments_text.clone());
                self.put(symbol(SymbolNode { arguments, arguments_text, ..bare(s) }));
            }
        }
    }

    /// Rates of the scalars that move, of every order that occurs.
    fn rates(&mut self, nodes: &[&Node]) {
        let dots = |node: &&Node| match &node.kind {
            NodeKind::Symbol(s) if s.dots > 0 => Some(s.dots),
            _ => None,
        };
        let mut orders: Vec<u8> = std::iter::once(1).chain(nodes.iter().filter_map(dots)).collect();
        orders.sort_unstable();
        orders.dedup();
        for node in nodes {
            if let NodeKind::Symbol(s) = &node.kind
                && s.arguments.is_none()
                && s.dots == 0
                && self.vocabulary.word(s).is_some_and(|(w, _)| w.moves && w.rank == 0)
            {
                orders.iter().for_each(|&dots| self.put(symbol(SymbolNode { dots, ..bare(s) })));
            }
        }
    }
}

fn extent(word: &Word) -> u16 {
    word.extents.iter().max().copied().unwrap_or(3).min(3)
}

fn with_digit(s: &SymbolNode, own: usize, digit: u16) -> SymbolNode {
    let mut sub = s.sub.clone().unwrap_or_default();
    if let Some(place) = sub.get_mut(own) {
        *place = SubItem::Digit(digit);
    }
    SymbolNode { sub: Some(sub), ..bare(s) }
}

/// What a missing factor or term of a formula may be made of.
pub(super) fn atoms(chain: &Chain, vocabulary: &Vocabulary, phrases: &[Chain]) -> Vec<Node> {
    let nodes_of = |chains: &'_ [Chain]| -> Vec<Node> {
        let mut nodes = Vec::new();
        chains.iter().flat_map(|c| &c.sides).for_each(|side| walk(side, &mut nodes));
        nodes.into_iter().cloned().collect()
    };
    let (own, near) = (nodes_of(std::slice::from_ref(chain)), nodes_of(phrases));
    let (own, near): (Vec<&Node>, Vec<&Node>) = (own.iter().collect(), near.iter().collect());
    let mut all = Collected { vocabulary, out: Vec::new() };
    all.factors(&own);
    all.components(&own);
    all.angles(&own);
    all.starts(&own);
    all.groups(&own);
    let scalars = vocabulary.scalars();
    let given = |w: &&&Word| !w.moves;
    scalars.iter().filter(given).take(MOST_ATOMS / 3).for_each(|w| all.put(symbol(w.symbol())));
    all.rates(&own);
    all.groups(&near);
    all.angles(&near);
    all.factors(&near);
    scalars.iter().for_each(|w| all.put(symbol(w.symbol())));
    all.out.truncate(MOST_ATOMS);
    all.out
}
