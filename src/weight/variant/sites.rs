//! Where a formula can be altered by one edit, and how.
//!
//! **In:** the syntax tree of a formula, and the [`Vocabulary`]. **Out:** [`Sites`]: how many single edits there are, in an order
//! that depends on the formula alone, and the [`Edit`]s at chosen positions of that order. To count them takes no memory; a
//! large formula has millions.

use super::convention::{Convention, SymbolKey, renamed};
use super::edit::{Change, Edit, confused};
use super::tree::{as_number, exponent, is_transpose, neighbours, raised, transpose, walk};
use super::vocabulary::{Vocabulary, Word};
use crate::expr::{FastMap, FastSet, Rational};
use crate::findings::EditClass;
use crate::latex::syntax::{Bracket, Chain, Name, Node, NodeKind, Sign, SubItem, SymbolNode, Target};

/// Most symbols of a formula that change places with others of another kind.
const MOST_EXCHANGED: usize = 24;

/// What a node stands for in the formula around it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    /// A side, an argument, an entry, a radicand: it can have a sign and a factor of its own.
    Whole,
    /// A term, whose sign and factor belong to the sum around it.
    Term,
    /// Anything else.
    Part,
    /// An exponent that is a number: it has been dealt with as a power.
    Fixed,
}

/// All single edits of a chain of relations.
pub(super) struct Sites<'a> {
    chain: &'a Chain,
    vocabulary: &'a Vocabulary,
    /// Letters that stand as indices somewhere.
    letters: Vec<Name>,
    /// The declared symbols that occur, each once, in the order in which they do.
    present: Vec<(SymbolKey, &'a Word)>,
    /// Symbols that stand alone as the argument of a sine or cosine.
    angles: Vec<SymbolKey>,
    count: usize,
}

/// A walk along all edits that makes those at some positions, which ascend.
struct Walk<'w> {
    next: usize,
    wanted: std::iter::Peekable<&'w mut dyn Iterator<Item = usize>>,
    side: usize,
    path: Vec<u32>,
    out: Vec<Edit>,
}

impl Walk<'_> {
    /// Passes `n` edits of one class, and makes those that are wanted.
    fn several(&mut self, class: EditClass, n: usize, change: impl Fn(usize) -> Change) {
        let first = self.next;
        self.next += n;
        while let Some(at) = self.wanted.next_if(|at| *at < first + n) {
            if at >= first {
                let (side, path) = (self.side, self.path.clone().into_boxed_slice());
                self.out.push(Edit { class, side, path, change: change(at - first) });
            }
        }
    }

    fn one(&mut self, class: EditClass, change: impl Fn() -> Change) {
        self.several(class, 1, |_| change());
    }

    /// A factor 2, and ½.
    fn factors(&mut self, node: &Node, change: impl Fn(Rational) -> Change) {
        if node.is_zero() || matches!(node.kind, NodeKind::Tuple(_) | NodeKind::Matrix(_) | NodeKind::Identity) {
            return;
        }
        let two = Rational::from(2);
        self.several(EditClass::Factor, 2, |i| change(if i == 0 { two.clone() } else { Rational::ONE / &two }));
    }
}

impl<'a> Sites<'a> {
    /// Looks at a chain, and counts its edits.
    pub fn new(chain: &'a Chain, vocabulary: &'a Vocabulary) -> Sites<'a> {
        let mut nodes = Vec::new();
        chain.sides.iter().for_each(|side| walk(side, &mut nodes));
        let mut out =
            Sites { chain, vocabulary, letters: Vec::new(), present: Vec::new(), angles: Vec::new(), count: 0 };
        let (mut letters, mut keys, mut angles) = (FastSet::default(), FastMap::default(), FastSet::default());
        for node in nodes {
            match &node.kind {
                NodeKind::Symbol(s) if !is_transpose(node) => {
                    let found = vocabulary.word(s);
                    let own = found.map_or(0, |(_, own)| own);
                    for item in &s.sub.as_deref().unwrap_or(&[])[own..] {
                        if let SubItem::Name(letter) = item
                            && letters.insert(letter)
                        {
                            out.letters.push(letter.clone());
                        }
                    }
                    if let Some((word, _)) = found
                        && keys.insert((&s.name, &word.sub), ()).is_none()
                    {
                        out.present.push((SymbolKey { name: s.name.clone(), sub: word.sub.clone() }, word));
                    }
                }
                NodeKind::Function(f, _, arguments) if matches!(f.as_str(), "sin" | "cos") => {
                    if let [Node { kind: NodeKind::Symbol(s), .. }] = arguments.as_slice()
                        && let Some((word, _)) = vocabulary.word(s)
                        && angles.insert((&s.name, &word.sub))
                    {
                        out.angles.push(SymbolKey { name: s.name.clone(), sub: word.sub.clone() });
                    }
                }
                _ => {}
            }
        }
        out.count = out.walk(&mut std::iter::empty()).next;
        out
    }

    /// How many edits there are.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The edits at some positions, which ascend.
    pub fn at(&self, positions: &mut dyn Iterator<Item = usize>) -> Vec<Edit> {
        self.walk(positions).out
    }

    /// Two symbols of different kinds change places throughout. These are many, and few authors make them: only corrections
    /// are made of them.
    pub fn exchanges(&self) -> Vec<Edit> {
        let present = &self.present[..self.present.len().min(MOST_EXCHANGED)];
        let mut out = Vec::new();
        for (i, (a, word)) in present.iter().enumerate() {
            for (b, _) in present[i + 1..].iter().filter(|(_, other)| word.may_change_places_with(other)) {
                let change = Change::Throughout(Convention::Exchange(a.clone(), b.clone()));
                out.push(Edit { class: EditClass::Symbol, side: 0, path: Box::default(), change });
            }
        }
        out
    }

    fn walk<'w>(&self, wanted: &'w mut dyn Iterator<Item = usize>) -> Walk<'w> {
        let mut walk = Walk { next: 0, wanted: wanted.peekable(), side: 0, path: Vec::new(), out: Vec::new() };
        for (side, node) in self.chain.sides.iter().enumerate() {
            walk.side = side;
            self.within(node, Place::Whole, &mut walk);
        }
        walk.side = 0;
        self.conventions(&mut walk);
        walk
    }

    fn conventions(&self, walk: &mut Walk) {
        for (i, (a, word)) in self.present.iter().enumerate() {
            for (b, other) in &self.present[i + 1..] {
                if word.may_be(other) {
                    let exchange = || Change::Throughout(Convention::Exchange(a.clone(), b.clone()));
                    walk.one(EditClass::Convention, exchange);
                }
            }
        }
        for angle in &self.angles {
            let conventions = [Convention::QuarterTurn(angle.clone()), Convention::Backwards(angle.clone())];
            walk.several(EditClass::Convention, 2, |i| Change::Throughout(conventions[i].clone()));
        }
    }

    /// Every edit of a node and of what is inside it.
    fn within(&self, node: &Node, place: Place, walk: &mut Walk) {
        if place == Place::Fixed {
            return;
        }
        if place == Place::Whole && !node.is_zero() && !matches!(node.kind, NodeKind::Sum(_)) {
            if !matches!(node.kind, NodeKind::Tuple(_) | NodeKind::Matrix(_) | NodeKind::Identity) {
                walk.one(EditClass::Sign, || Change::Negated);
            }
            walk.factors(node, Change::Scaled);
        }
        self.local(node, walk);
        if as_number(node).is_some() {
            return;
        }
        for (at, child) in node.children().into_iter().enumerate() {
            walk.path.push(at as u32);
            self.within(child, place_of(node, at, child, self.vocabulary), walk);
            walk.path.pop();
        }
    }

    /// Edits of the node itself.
    fn local(&self, node: &Node, walk: &mut Walk) {
        match &node.kind {
            NodeKind::Symbol(s) => self.symbol(s, node, walk),
            NodeKind::Sum(terms) => {
                for (i, (sign, term)) in terms.iter().enumerate() {
                    let signs: &[Sign] = match sign {
                        Sign::Plus => &[Sign::Minus],
                        Sign::Minus => &[Sign::Plus],
                        Sign::PlusMinus | Sign::MinusPlus => &[Sign::Plus, Sign::Minus],
                    };
                    walk.several(EditClass::Sign, signs.len(), |k| Change::TermSign(i, signs[k]));
                    walk.factors(term, |factor| Change::TermScaled(i, factor));
                    if terms.len() > 1 {
                        walk.one(EditClass::Dropped, || Change::TermDropped(i));
                    }
                }
            }
            NodeKind::Product(parts) => {
                for (i, part) in parts.iter().enumerate() {
                    if !part.is_numeric() && parts.len() > 1 {
                        walk.one(EditClass::Dropped, || Change::FactorDropped(i));
                    }
                }
            }
            NodeKind::Quotient { top, bottom, .. } => {
                if !top.is_numeric() {
                    walk.one(EditClass::Dropped, || Change::TopDropped);
                }
                if !bottom.is_numeric() {
                    walk.one(EditClass::Dropped, || Change::BottomDropped);
                }
            }
            NodeKind::Scripted { base, sub, sup, .. } => {
                if let (Some(n), NodeKind::Group(..)) = (sup.as_deref().and_then(exponent), &base.kind) {
                    for m in neighbours(n) {
                        walk.one(EditClass::Power, || Change::Power(m));
                    }
                }
                if sup.as_deref().is_some_and(is_transpose) && sub.is_none() {
                    walk.one(EditClass::Transpose, || Change::Bare);
                }
            }
            NodeKind::Group(_, Bracket::Round) => walk.one(EditClass::Power, || Change::Squared),
            NodeKind::Root(..) => walk.one(EditClass::Power, || Change::RootLeftOut),
            NodeKind::Function(f, power, arguments) => {
                if let Some(other) = confused(f) {
                    walk.one(EditClass::Function, || Change::Function(other));
                }
                if arguments.len() == 1 && !matches!(f.as_str(), "tr" | "det" | "diag") {
                    let n = power.unwrap_or(1);
                    for m in [n - 1, n + 1].into_iter().filter(|m| *m > 0) {
                        walk.one(EditClass::Power, || Change::FunctionPower(m));
                    }
                }
            }
            NodeKind::Cross { .. } => walk.one(EditClass::Orientation, || Change::Turned),
            NodeKind::Number(_)
            | NodeKind::Pi
            | NodeKind::Euler { .. }
            | NodeKind::At { .. }
            | NodeKind::Factorial(_)
            | NodeKind::Identity
            | NodeKind::Group(..)
            | NodeKind::Dot(_)
            | NodeKind::Exponential { .. }
            | NodeKind::Conjugate(_)
            | NodeKind::Conjugation { .. }
            | NodeKind::Absolute(_)
            | NodeKind::Derivative { .. }
            | NodeKind::Partial { .. }
            | NodeKind::Nabla { .. }
            | NodeKind::Poisson(..)
            | NodeKind::Variation { .. }
            | NodeKind::Differential { .. }
            | NodeKind::Tuple(_)
            | NodeKind::Matrix(_)
            | NodeKind::Limit(..) => {}
        }
    }

    fn symbol(&self, s: &SymbolNode, node: &Node, walk: &mut Walk) {
        let span = &node.span;
        let put = |s: SymbolNode| Change::Symbol(Box::new(s));
        let found = self.vocabulary.word(s);
        let own = found.map_or(0, |(_, own)| own);
        let sub: &[SubItem] = s.sub.as_deref().unwrap_or(&[]);
        let exchanged = |i: usize| {
            let mut turned = sub.to_vec();
            turned.swap(i, i + 1);
            put(SymbolNode { sub: Some(turned), ..s.clone() })
        };
        let epsilon = found.is_none() && matches!(s.name.as_str(), "\\epsilon" | "\\varepsilon") && sub.len() == 3;
        if epsilon {
            walk.one(EditClass::Orientation, || exchanged(0));
        }
        if let Some((word, _)) = found
            && s.arguments.as_ref().is_none_or(|a| a.len() == 1)
        {
            let others = self.vocabulary.like(word);
            walk.several(EditClass::Symbol, others.len(), |k| {
                put(others.get(k).map_or_else(|| s.clone(), |other| renamed(s, own, &other.name, &other.sub)))
            });
        }
        // Indices.
        for (i, item) in sub.iter().enumerate().skip(own) {
            let with = |item: SubItem| {
                let mut sub = sub.to_vec();
                sub[i] = item;
                put(SymbolNode { sub: Some(sub), ..s.clone() })
            };
            match item {
                SubItem::Digit(d) => {
                    let extent = found.and_then(|(w, _)| w.extents.iter().max().copied()).unwrap_or(3);
                    for other in (1..=extent.min(9)).filter(|o| o != d) {
                        walk.one(EditClass::Index, || with(SubItem::Digit(other)));
                    }
                }
                SubItem::Name(letter) => {
                    for other in self.letters.iter().filter(|o| *o != letter) {
                        walk.one(EditClass::Index, || with(SubItem::Name(other.clone())));
                    }
                }
                SubItem::Other(_) => {}
            }
        }
        if let ([first, second], false) = (&sub[own..], epsilon)
            && first != second
        {
            walk.one(EditClass::Index, || exchanged(own));
        }
        // Powers and transposes.
        let with_sup = |sup: Option<Box<Node>>| put(SymbolNode { sup, ..s.clone() });
        match s.sup.as_deref() {
            Some(sup) if is_transpose(sup) => walk.one(EditClass::Transpose, || with_sup(None)),
            Some(sup) => {
                if let Some(n) = exponent(sup) {
                    for m in neighbours(n) {
                        walk.one(EditClass::Power, || with_sup(raised(m, span)));
                    }
                }
            }
            None => {
                let left = found.map_or(0, |(w, _)| w.rank).saturating_sub(sub.len() - own);
                let places = found.is_some_and(|(w, _)| w.rank > 0) && sub.len() > own;
                if found.is_some() && (left == 0 || places) && s.arguments.is_none() {
                    for m in neighbours(1) {
                        walk.one(EditClass::Power, || with_sup(raised(m, span)));
                    }
                }
                if found.is_some_and(|(w, _)| w.complex) && s.arguments.is_none() {
                    let star = NodeKind::Conjugation { transposed: false };
                    walk.one(EditClass::Transpose, || with_sup(Some(Box::new(Node::new(star.clone(), span.clone())))));
                }
                if left == 2 && sub.len() == own {
                    walk.one(EditClass::Transpose, || with_sup(Some(Box::new(transpose(span)))));
                }
            }
        }
    }
}

/// What a part of a node stands for.
pub(super) fn place_of(parent: &Node, at: usize, child: &Node, vocabulary: &Vocabulary) -> Place {
    match &parent.kind {
        NodeKind::Sum(_) => Place::Term,
        NodeKind::Function(..)
        | NodeKind::Exponential { .. }
        | NodeKind::Root(..)
        | NodeKind::Tuple(_)
        | NodeKind::Matrix(_) => Place::Whole,
        NodeKind::Symbol(s) => {
            let in_script = s.sup.is_some() && at == 0;
            let function = vocabulary.word(s).is_some_and(|(w, _)| w.is_function);
            if (in_script && (exponent(child).is_some() || is_transpose(child))) || (!in_script && !function) {
                Place::Fixed
            } else {
                Place::Whole
            }
        }
        NodeKind::Scripted { sup, .. } if at == 1 || sup.is_none() && at > 0 => {
            if exponent(child).is_some() || is_transpose(child) { Place::Fixed } else { Place::Whole }
        }
        NodeKind::Limit(_, Target::Finite(_)) if at == 0 => Place::Fixed,
        NodeKind::Limit(..) => Place::Whole,
        NodeKind::Group(..) | NodeKind::Absolute(_) => match child.kind {
            NodeKind::Sum(_) => Place::Part,
            _ => Place::Term,
        },
        _ => Place::Part,
    }
}
