//! Where something may be missing in a formula, and what may be put there.
//!
//! **In:** a syntax tree. **Out:** the trees with one factor or term more, at every place. What such a factor or term may be
//! made of is the business of `atom`.

use std::ops::Range;

use super::edit::{Place, place_of};
use super::tree::{
    anywhere, as_number, negated, number, product, raised, scaled, scripted, sum, transpose, walk, with_part,
};
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

/// Every tree that comes from putting `filling` into one gap of a chain; in an order that does not depend on the filling. A
/// factor is put before what is there, unless `instead`, when it takes its place.
pub(super) fn filled(chain: &Chain, gap: Gap, filling: &Node, instead: bool, vocabulary: &Vocabulary) -> Vec<Chain> {
    let filler = Filler { gap, filling, instead, vocabulary };
    let mut out = Vec::new();
    for (k, side) in chain.sides.iter().enumerate() {
        for side in filler.within(side, Place::Whole) {
            let mut edited = chain.clone();
            edited.sides[k] = side;
            out.push(edited);
        }
    }
    out
}

struct Filler<'a> {
    gap: Gap,
    filling: &'a Node,
    instead: bool,
    vocabulary: &'a Vocabulary,
}

impl Filler<'_> {
    fn times(&self, node: &Node) -> Node {
        if self.instead { self.filling.clone() } else { multiplied(self.filling, node) }
    }

    fn within(&self, node: &Node, place: Place) -> Vec<Node> {
        let mut out = Vec::new();
        if place == Place::Fixed {
            return out;
        }
        let fillable = !matches!(node.kind, NodeKind::Tuple(_) | NodeKind::Matrix(_) | NodeKind::Identity);
        match (&node.kind, self.gap) {
            (NodeKind::Sum(terms), Gap::Factor) => {
                for (i, (_, term)) in terms.iter().enumerate() {
                    let mut terms = terms.clone();
                    terms[i].1 = self.times(term);
                    out.push(sum(terms, &node.span));
                }
            }
            (NodeKind::Sum(terms), Gap::Term) => out.push(added(terms.clone(), self.filling, &node.span)),
            (_, Gap::Factor) if place == Place::Whole && fillable && !node.is_zero() => out.push(self.times(node)),
            (_, Gap::Term) if place == Place::Whole && fillable => {
                let terms = if node.is_zero() { Vec::new() } else { vec![(Sign::Plus, node.clone())] };
                out.push(added(terms, self.filling, &node.span));
            }
            _ => {}
        }
        if as_number(node).is_some() {
            return out;
        }
        for (at, child) in node.children().into_iter().enumerate() {
            let place = match &node.kind {
                NodeKind::Quotient { .. } | NodeKind::Cross { .. } | NodeKind::Dot(_) => Place::Whole,
                NodeKind::Group(..) if self.gap == Gap::Term && !matches!(child.kind, NodeKind::Sum(_)) => Place::Whole,
                _ => place_of(node, at, child, self.vocabulary),
            };
            for child in self.within(child, place) {
                out.push(with_part(node, at, child));
            }
        }
        out
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

/// A formula with one quantity more, as a factor or as a term, at every place: nested ones, and matrices and vectors, too.
pub(super) fn insertions(chain: &Chain, vocabulary: &Vocabulary, atoms: &[Node]) -> Vec<Chain> {
    let mut out = Vec::new();
    for atom in atoms.iter().take(MOST_INSERTED) {
        for n in [1, 2] {
            out.extend(filled(chain, Gap::Factor, &power(atom, n), false, vocabulary));
            let term = power(atom, n);
            out.extend(filled(chain, Gap::Term, &term, false, vocabulary));
            out.extend(filled(chain, Gap::Term, &negated(&term), false, vocabulary));
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
        for factor in &all {
            out.extend(filled(chain, Gap::Factor, factor, false, vocabulary));
            // Matrices do not commute: behind each factor, too.
            for (k, side) in chain.sides.iter().enumerate() {
                for side in anywhere(side, &|node| behind_each(node, factor)) {
                    let mut edited = chain.clone();
                    edited.sides[k] = side;
                    out.push(edited);
                }
            }
        }
        // One component for each value of an index of the formula; of a diagonal matrix there is one for each, too.
        if word.rank == 1 || word.is_diagonal() {
            for letter in &letters {
                let mut sub = plain.sub.clone().unwrap_or_default();
                sub.push(SubItem::Name(letter.clone()));
                let component = symbol(SymbolNode { sub: Some(sub), ..plain.clone() });
                let one = Box::new(number(Rational::ONE, &span));
                let under = NodeKind::Quotient { top: one, bottom: Box::new(component.clone()), slash: false };
                for factor in [component, Node::new(under, span.clone())] {
                    out.extend(filled(chain, Gap::Factor, &factor, false, vocabulary));
                }
            }
        }
    }
    out
}

/// Products with one factor more behind each of their factors.
fn behind_each(node: &Node, factor: &Node) -> Vec<Node> {
    let NodeKind::Product(parts) = &node.kind else { return Vec::new() };
    let with = |at: usize| {
        let mut parts = parts.clone();
        parts.insert(at, factor.clone());
        Node::new(NodeKind::Product(parts), node.span.clone())
    };
    (1..=parts.len()).map(with).collect()
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
