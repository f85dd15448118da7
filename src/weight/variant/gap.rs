//! Where something may be missing in a formula, and what may be put there.
//!
//! **In:** a syntax tree. **Out:** its [`Hole`]s, and the [`Insertions`]: trees with one factor or term more, at every place, made
//! when they are asked for. What such a factor or term may be made of is the business of `atom`.

use std::ops::Range;

use super::sites::{Place, place_of};
use super::tree::{as_number, negated, number, parts_mut, product, raised, scaled, scripted, sum, transpose, walk};
use super::vocabulary::Vocabulary;
use crate::expr::Rational;
use crate::latex::syntax::{Bracket, Chain, Name, Node, NodeKind, Sign, SubItem, SymbolNode};

/// Where something may be missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Gap {
    /// A factor of a term.
    Factor,
    /// A term of a sum.
    Term,
}

/// A place in a chain where something may be missing.
#[derive(Clone, Debug)]
pub(super) struct Hole {
    side: usize,
    /// From the side to the node: positions among the parts of each node.
    path: Box<[u32]>,
    /// The term of a sum that may lack a factor; none where it is the node itself.
    term: Option<usize>,
    gap: Gap,
}

/// The places of a chain where a factor, or a term, may be missing.
pub(super) fn holes(chain: &Chain, gap: Gap, vocabulary: &Vocabulary) -> Vec<Hole> {
    let mut search = Holes { gap, vocabulary, side: 0, path: Vec::new(), out: Vec::new() };
    for (side, node) in chain.sides.iter().enumerate() {
        search.side = side;
        search.within(node, Place::Whole);
    }
    search.out
}

/// A node of a chain, to be replaced.
fn node_at<'n>(chain: &'n mut Chain, side: usize, path: &[u32]) -> Option<&'n mut Node> {
    let mut place = chain.sides.get_mut(side);
    for &at in path {
        place = place.and_then(|node| parts_mut(node).into_iter().nth(at as usize));
    }
    place
}

impl Hole {
    /// The chain with something put there. A factor is put before what is there, unless `instead`, when it takes its place.
    pub fn filled(&self, chain: &Chain, filling: &Node, instead: bool) -> Chain {
        let mut out = chain.clone();
        let Some(node) = node_at(&mut out, self.side, &self.path) else { return out };
        let times = |node: &Node| if instead { filling.clone() } else { multiplied(filling, node) };
        let new = match (&node.kind, self.gap, self.term) {
            (NodeKind::Sum(terms), Gap::Factor, Some(i)) => {
                let mut terms = terms.clone();
                terms[i].1 = times(&terms[i].1);
                sum(terms, &node.span)
            }
            (_, Gap::Factor, _) => times(node),
            (NodeKind::Sum(terms), Gap::Term, _) => added(terms.clone(), filling, &node.span),
            (_, Gap::Term, _) => {
                let terms = if node.is_zero() { Vec::new() } else { vec![(Sign::Plus, node.clone())] };
                added(terms, filling, &node.span)
            }
        };
        *node = new;
        out
    }
}

struct Holes<'a> {
    gap: Gap,
    vocabulary: &'a Vocabulary,
    side: usize,
    path: Vec<u32>,
    out: Vec<Hole>,
}

impl Holes<'_> {
    fn put(&mut self, term: Option<usize>) {
        let path = self.path.clone().into_boxed_slice();
        self.out.push(Hole { side: self.side, path, term, gap: self.gap });
    }

    fn within(&mut self, node: &Node, place: Place) {
        if place == Place::Fixed {
            return;
        }
        let fillable = !matches!(node.kind, NodeKind::Tuple(_) | NodeKind::Matrix(_) | NodeKind::Identity);
        match (&node.kind, self.gap) {
            (NodeKind::Sum(terms), Gap::Factor) => (0..terms.len()).for_each(|i| self.put(Some(i))),
            (NodeKind::Sum(_), Gap::Term) => self.put(None),
            (_, Gap::Factor) if place == Place::Whole && fillable && !node.is_zero() => self.put(None),
            (_, Gap::Term) if place == Place::Whole && fillable => self.put(None),
            _ => {}
        }
        if as_number(node).is_some() {
            return;
        }
        for (at, child) in node.children().into_iter().enumerate() {
            let place = match &node.kind {
                NodeKind::Quotient { .. } | NodeKind::Cross { .. } | NodeKind::Dot(_) => Place::Whole,
                NodeKind::Group(..) if self.gap == Gap::Term && !matches!(child.kind, NodeKind::Sum(_)) => Place::Whole,
                _ => place_of(node, at, child, self.vocabulary),
            };
            self.path.push(at as u32);
            self.within(child, place);
            self.path.pop();
        }
    }
}

/// A sum with one more term; a term with a sign of its own keeps it.
fn added(mut terms: Vec<(Sign, Node)>, term: &Node, span: &Range<usize>) -> Node {
    match &term.kind {
        NodeKind::Sum(inner) => terms.extend(inner.clone()),
        _ => terms.push((Sign::Plus, term.clone())),
    }
    sum(terms, span)
}

/// A factor before what it multiplies, signs in front and numbers merged.
fn multiplied(factor: &Node, node: &Node) -> Node {
    let span = &node.span;
    if let NodeKind::Sum(terms) = &factor.kind
        && let [(Sign::Minus, inner)] = terms.as_slice()
    {
        return negated(&multiplied(inner, node));
    }
    if let Some(r) = as_number(factor) {
        return scaled(node, &r);
    }
    if let NodeKind::Quotient { top, bottom, slash } = &factor.kind {
        let over = if as_number(top) == Some(Rational::ONE) { node.clone() } else { multiplied(top, node) };
        let kind = NodeKind::Quotient { top: Box::new(over), bottom: bottom.clone(), slash: *slash };
        return Node::new(kind, span.clone());
    }
    let mut parts = match &factor.kind {
        NodeKind::Product(parts) => parts.clone(),
        _ => vec![factor.clone()],
    };
    match &node.kind {
        NodeKind::Product(more) => parts.extend(more.clone()),
        NodeKind::Quotient { top, bottom, slash } => {
            let one = as_number(top) == Some(Rational::ONE);
            let top = if one { factor.clone() } else { multiplied(factor, top) };
            let kind = NodeKind::Quotient { top: Box::new(top), bottom: bottom.clone(), slash: *slash };
            return Node::new(kind, span.clone());
        }
        _ if as_number(node) == Some(Rational::ONE) => {}
        _ => parts.push(node.clone()),
    }
    // Numbers first.
    let front: Vec<Node> = parts.iter().filter(|p| as_number(p).is_some()).cloned().collect();
    let mut rest: Vec<Node> = parts.into_iter().filter(|p| as_number(p).is_none()).collect();
    // Functions last: nothing may stand behind an argument without parentheses.
    rest.sort_by_key(|p| matches!(p.kind, NodeKind::Function(..)));
    product(front.into_iter().chain(rest).collect(), span).unwrap_or_else(|| node.clone())
}

/// c·∏ atomⁿ as a formula writes it.
pub(super) fn monomial(coefficient: &Rational, factors: &[(&Node, i32)]) -> Node {
    let span = 0..0;
    let negative = *coefficient < Rational::ZERO;
    let size = if negative { -coefficient.clone() } else { coefficient.clone() };
    let (mut over, mut under) = (Vec::new(), Vec::new());
    let (p, q) = (Rational::from(size.numerator().clone()), Rational::from(size.denominator().clone()));
    if p != Rational::ONE {
        over.push(number(p, &span));
    }
    if q != Rational::ONE {
        under.push(number(q, &span));
    }
    for (atom, n) in factors {
        let place = if *n > 0 { &mut over } else { &mut under };
        place.push(power(atom, n.abs()));
    }
    let one = || Node::new(NodeKind::Number(Rational::ONE), span.clone());
    let top = product(over, &span).unwrap_or_else(one);
    let whole = match product(under, &span) {
        None => top,
        Some(bottom) => {
            let kind = NodeKind::Quotient { top: Box::new(top), bottom: Box::new(bottom), slash: false };
            Node::new(kind, span.clone())
        }
    };
    if negative { negated(&whole) } else { whole }
}

/// An atom to a positive power.
pub(super) fn power(atom: &Node, n: i32) -> Node {
    if n == 1 {
        return atom.clone();
    }
    let sup = raised(i64::from(n), &atom.span);
    match &atom.kind {
        NodeKind::Symbol(s) if s.arguments.is_none() => {
            Node::new(NodeKind::Symbol(SymbolNode { sup, ..s.clone() }), atom.span.clone())
        }
        NodeKind::Function(f, None, arguments) => {
            Node::new(NodeKind::Function(f.clone(), Some(n), arguments.clone()), atom.span.clone())
        }
        NodeKind::Group(..) => scripted(atom.clone(), i64::from(n)),
        _ => scripted(
            Node::new(NodeKind::Group(Box::new(atom.clone()), Bracket::Round), atom.span.clone()),
            i64::from(n),
        ),
    }
}

/// Most atoms that are put into a formula one by one.
const MOST_INSERTED: usize = 20;

/// All formulas with one quantity more, as a factor or as a term, at every place: nested ones, and matrices and vectors, too.
/// They are made when they are asked for.
pub(super) struct Insertions<'a> {
    chain: &'a Chain,
    factors: Vec<Hole>,
    terms: Vec<Hole>,
    /// Side and path of every product, and a place behind one of its factors.
    behind: Vec<(usize, Box<[u32]>, usize)>,
    /// What is put, and where: each at all places of a kind.
    rounds: Vec<(Where, Node)>,
}

/// Places of one kind.
#[derive(Clone, Copy)]
enum Where {
    Factor,
    Term,
    Behind,
}

impl<'a> Insertions<'a> {
    /// Those of some atoms, and of the vectors and matrices of a vocabulary.
    pub fn new(chain: &'a Chain, vocabulary: &Vocabulary, atoms: &[Node]) -> Insertions<'a> {
        let mut rounds = Vec::new();
        for atom in atoms.iter().take(MOST_INSERTED) {
            for n in [1, 2] {
                let term = power(atom, n);
                let minus = negated(&term);
                rounds.extend([(Where::Factor, term.clone()), (Where::Term, term), (Where::Term, minus)]);
            }
        }
        let letters = letters(chain, vocabulary);
        for word in vocabulary.tensors() {
            let span = 0..0;
            let plain = word.symbol();
            let symbol = |s: SymbolNode| Node::new(NodeKind::Symbol(s), span.clone());
            let mut all = vec![symbol(plain.clone())];
            if word.rank == 2 {
                let turned = |s: &SymbolNode| SymbolNode { sup: Some(Box::new(transpose(&span))), ..s.clone() };
                all.push(symbol(turned(&plain)));
                all.push(symbol(SymbolNode { sup: raised(-1, &span), ..plain.clone() }));
                if word.moves {
                    let dotted = SymbolNode { dots: 1, ..plain.clone() };
                    all.extend([symbol(turned(&dotted)), symbol(dotted)]);
                }
            }
            // Matrices do not commute: behind each factor, too.
            rounds.extend(all.into_iter().flat_map(|f| [(Where::Factor, f.clone()), (Where::Behind, f)]));
            // One component for each value of an index of the formula; of a diagonal matrix there is one for each, too.
            if word.rank == 1 || word.is_diagonal() {
                for letter in &letters {
                    let mut sub = plain.sub.clone().unwrap_or_default();
                    sub.push(SubItem::Name(letter.clone()));
                    let component = symbol(SymbolNode { sub: Some(sub), ..plain.clone() });
                    let one = Box::new(number(Rational::ONE, &span));
                    let under = NodeKind::Quotient { top: one, bottom: Box::new(component.clone()), slash: false };
                    rounds.extend([(Where::Factor, component), (Where::Factor, Node::new(under, span.clone()))]);
                }
            }
        }
        let mut behind = Vec::new();
        for (side, node) in chain.sides.iter().enumerate() {
            products(node, side, &mut Vec::new(), &mut behind);
        }
        let [factors, terms] = [Gap::Factor, Gap::Term].map(|gap| holes(chain, gap, vocabulary));
        Insertions { chain, factors, terms, behind, rounds }
    }

    fn places(&self, of: Where) -> usize {
        match of {
            Where::Factor => self.factors.len(),
            Where::Term => self.terms.len(),
            Where::Behind => self.behind.len(),
        }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.rounds.iter().map(|(of, _)| self.places(*of)).sum()
    }

    /// Those at some positions, which ascend.
    pub fn at(self, positions: impl Iterator<Item = usize>) -> impl Iterator<Item = Chain> {
        let (mut round, mut first) = (0, 0);
        positions.map_while(move |at| {
            loop {
                let (of, filling) = self.rounds.get(round)?;
                let here = self.places(*of);
                if at < first + here {
                    return Some(self.one(*of, filling, at - first));
                }
                (round, first) = (round + 1, first + here);
            }
        })
    }

    fn one(&self, of: Where, filling: &Node, at: usize) -> Chain {
        match of {
            Where::Factor => self.factors[at].filled(self.chain, filling, false),
            Where::Term => self.terms[at].filled(self.chain, filling, false),
            Where::Behind => {
                let (side, path, behind) = &self.behind[at];
                let mut out = self.chain.clone();
                if let Some(Node { kind: NodeKind::Product(parts), .. }) = node_at(&mut out, *side, path) {
                    parts.insert(*behind, filling.clone());
                }
                out
            }
        }
    }
}

/// The places behind each factor of each product.
fn products(node: &Node, side: usize, path: &mut Vec<u32>, out: &mut Vec<(usize, Box<[u32]>, usize)>) {
    if let NodeKind::Product(parts) = &node.kind {
        out.extend((1..=parts.len()).map(|at| (side, path.clone().into_boxed_slice(), at)));
    }
    for (at, child) in node.children().into_iter().enumerate() {
        path.push(at as u32);
        products(child, side, path, out);
        path.pop();
    }
}

/// The letters that stand as indices in a formula.
fn letters(chain: &Chain, vocabulary: &Vocabulary) -> Vec<Name> {
    let mut nodes = Vec::new();
    chain.sides.iter().for_each(|side| walk(side, &mut nodes));
    let mut out: Vec<Name> = Vec::new();
    for node in nodes {
        let NodeKind::Symbol(s) = &node.kind else { continue };
        let own = vocabulary.word(s).map_or(0, |(_, own)| own);
        for item in s.sub.as_deref().unwrap_or(&[]).iter().skip(own) {
            if let SubItem::Name(letter) = item
                && !out.contains(letter)
            {
                out.push(letter.clone());
            }
        }
    }
    out
}
