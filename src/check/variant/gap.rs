//! Where something may be missing in a formula, and what may be put there.
//!
//! **In:** a syntax tree. **Out:** the trees with one factor or term more, at every place; and the atoms that such a factor
//! or term may be made of.

use std::ops::Range;

use super::edit::{Place, confused, place_of};
use super::tree::{
    as_number, is_transpose, negated, number, parts_mut, product, raised, scaled, scripted, sum, walk, with_part,
};
use super::vocabulary::Vocabulary;
use crate::expr::Rational;
use crate::latex::syntax::{Bracket, Chain, Node, NodeKind, Sign, SubItem, SymbolNode};

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
                NodeKind::Quotient { .. } => Place::Whole,
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
fn power(atom: &Node, n: i32) -> Node {
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

/// A formula with one quantity more, as a factor or as a term, at every place: nested ones, and matrices and vectors, too.
pub(super) fn insertions(chain: &Chain, vocabulary: &Vocabulary) -> Vec<Chain> {
    let mut out = Vec::new();
    let small = atoms(chain, vocabulary);
    for atom in &small {
        for n in [1, 2] {
            out.extend(filled(chain, Gap::Factor, &power(atom, n), false, vocabulary));
            let term = power(atom, n);
            out.extend(filled(chain, Gap::Term, &term, false, vocabulary));
            out.extend(filled(chain, Gap::Term, &negated(&term), false, vocabulary));
        }
    }
    let span = 0..0;
    for word in vocabulary.tensors() {
        let plain = SymbolNode {
            name: word.name.clone(),
            dots: 0,
            sub: (!word.sub.is_empty()).then(|| word.sub.clone()),
            sup: None,
            sup_first: false,
            arguments: None,
            arguments_text: String::new(),
        };
        let symbol = |s: SymbolNode| Node::new(NodeKind::Symbol(s), span.clone());
        let mut all = vec![symbol(plain.clone())];
        if word.rank == 2 {
            let t = symbol(SymbolNode { name: "T".into(), ..plain.clone() });
            all.push(symbol(SymbolNode { sup: Some(Box::new(t)), ..plain.clone() }));
            all.push(symbol(SymbolNode { sup: raised(-1, &span), ..plain.clone() }));
        }
        for factor in &all {
            out.extend(filled(chain, Gap::Factor, factor, false, vocabulary));
        }
    }
    out
}

/// Most atoms that monomials are made of.
const MOST_ATOMS: usize = 20;

/// What a missing factor or term may be made of: the factors that the formula has, without their powers; like components and
/// functions; the scalars that are declared.
pub(super) fn atoms(chain: &Chain, vocabulary: &Vocabulary) -> Vec<Node> {
    let mut nodes = Vec::new();
    for side in &chain.sides {
        walk(side, &mut nodes);
    }
    let span = 0..0;
    let mut out: Vec<Node> = Vec::new();
    let mut put = |node: Node| {
        let plain = without_places(&node);
        if !out.contains(&plain) {
            out.push(plain);
        }
    };
    let symbol = |s: SymbolNode| Node::new(NodeKind::Symbol(s), span.clone());
    for node in &nodes {
        match &node.kind {
            NodeKind::Symbol(s)
                if !is_transpose(node)
                    && (vocabulary.word(s).is_some_and(|(w, _)| !w.is_function) || s.arguments.is_some()) =>
            {
                put(symbol(SymbolNode { sup: None, sup_first: false, ..s.clone() }));
            }
            NodeKind::Function(f, _, arguments) => {
                let function = |f: &str| Node::new(NodeKind::Function(f.into(), None, arguments.clone()), span.clone());
                put(function(f));
                if let Some(other) = confused(f).filter(|_| matches!(f.as_str(), "sin" | "cos")) {
                    put(function(other));
                }
            }
            NodeKind::Exponential { .. } | NodeKind::Root(..) | NodeKind::Pi => put((*node).clone()),
            _ => {}
        }
    }
    // Like components: I_2 where I_1 occurs.
    for node in &nodes {
        if let NodeKind::Symbol(s) = &node.kind
            && let Some((word, own)) = vocabulary.word(s)
            && let Some([SubItem::Digit(_)]) = s.sub.as_deref().and_then(|sub| sub.get(own..))
        {
            for d in 1..=word.extents.iter().max().copied().unwrap_or(3).min(3) {
                let mut sub = s.sub.clone().unwrap_or_default();
                sub[own] = SubItem::Digit(d);
                put(symbol(SymbolNode { sub: Some(sub), sup: None, sup_first: false, ..s.clone() }));
            }
        }
    }
    // Sines and cosines of what stands in their arguments, and values at the start where such a value occurs.
    for node in &nodes {
        if let NodeKind::Function(f, _, arguments) = &node.kind
            && matches!(f.as_str(), "sin" | "cos")
        {
            let mut inner = Vec::new();
            arguments.iter().for_each(|a| walk(a, &mut inner));
            for part in inner {
                let NodeKind::Symbol(s) = &part.kind else { continue };
                if vocabulary.word(s).is_some_and(|(w, _)| w.moves && w.rank == 0) && s.dots == 0 {
                    for f in ["sin", "cos"] {
                        put(Node::new(NodeKind::Function(f.into(), None, vec![part.clone()]), span.clone()));
                    }
                }
            }
        }
    }
    let at_start = nodes.iter().find_map(|n| match &n.kind {
        NodeKind::Symbol(s) if s.arguments.as_ref().is_some_and(|a| a.len() == 1 && a[0].is_zero()) => Some(s),
        _ => None,
    });
    if let Some(start) = at_start {
        for node in &nodes {
            if let NodeKind::Symbol(s) = &node.kind
                && s.arguments.is_none()
                && vocabulary.word(s).is_some_and(|(w, _)| w.moves)
            {
                let (arguments, arguments_text) = (start.arguments.clone(), start.arguments_text.clone());
                put(symbol(SymbolNode { arguments, arguments_text, sup: None, sup_first: false, ..(*s).clone() }));
            }
        }
    }
    for word in vocabulary.scalars() {
        put(symbol(SymbolNode {
            name: word.name.clone(),
            dots: 0,
            sub: (!word.sub.is_empty()).then(|| word.sub.clone()),
            sup: None,
            sup_first: false,
            arguments: None,
            arguments_text: String::new(),
        }));
    }
    out.truncate(MOST_ATOMS);
    out
}

/// The same tree with all places removed, so that trees can be compared.
fn without_places(node: &Node) -> Node {
    let mut out = node.clone();
    out.span = 0..0;
    for part in parts_mut(&mut out) {
        *part = without_places(part);
    }
    out
}
