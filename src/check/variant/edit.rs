//! Single edits of a formula: the slips that authors and typesetters make.
//!
//! **In:** the syntax tree of a formula, and the [`Vocabulary`]. **Out:** every tree that differs from it by one [`EditClass`]
//! edit, in an order that depends on the formula alone. Whether a tree has a meaning is not asked here.
//!
//! **Why trees and not text or graphs:** an edited tree can be printed as the formula that an author would have written, and
//! the reader of formulas refuses what has no meaning.

use super::convention::{Convention, SymbolKey, renamed};
use super::tree::{
    as_number, exponent, is_transpose, negated, neighbours, raised, scaled, scripted, sum, transpose, walk, with_part,
    without,
};
use super::vocabulary::Vocabulary;
use crate::expr::Rational;
use crate::latex::syntax::{Bracket, Chain, Name, Node, NodeKind, Sign, SubItem, SymbolNode, Target};

/// Kinds of slips.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum EditClass {
    /// The sign of a term, of an argument or of a side; ± for one of its signs.
    Sign,
    /// An index for another; two indices of a symbol exchanged.
    Index,
    /// A factor 2 or ½.
    Factor,
    /// A power one higher or lower; a root left out.
    Power,
    /// Sine for cosine, and their kin.
    Function,
    /// A symbol for another of the same shape and role.
    Symbol,
    /// A term or a factor left out.
    Dropped,
    /// A transpose set or left out.
    Transpose,
    /// The factors of a vector product, or two indices of ε, exchanged.
    Orientation,
    /// Another convention, throughout the formula: two like symbols exchanged, an angle counted from a quarter turn further
    /// or in the other direction.
    Convention,
    /// A factor or a term that is missing. Only corrections are of this class.
    Missing,
}

impl EditClass {
    /// All classes that variants are made of.
    pub const ALL: [EditClass; 10] = [
        EditClass::Sign,
        EditClass::Index,
        EditClass::Factor,
        EditClass::Power,
        EditClass::Function,
        EditClass::Symbol,
        EditClass::Dropped,
        EditClass::Transpose,
        EditClass::Orientation,
        EditClass::Convention,
    ];

    /// The word of the reports.
    pub fn word(self) -> &'static str {
        match self {
            EditClass::Sign => "sign",
            EditClass::Index => "index",
            EditClass::Factor => "factor",
            EditClass::Power => "power",
            EditClass::Function => "function",
            EditClass::Symbol => "symbol",
            EditClass::Dropped => "dropped",
            EditClass::Transpose => "transpose",
            EditClass::Orientation => "orientation",
            EditClass::Convention => "convention",
            EditClass::Missing => "missing",
        }
    }

    /// What is wrong with a formula that has such an edit, in words.
    pub fn says(self) -> &'static str {
        match self {
            EditClass::Sign => "a wrong sign",
            EditClass::Index => "a wrong index",
            EditClass::Factor => "a wrong factor 2 or ½",
            EditClass::Power => "a wrong power",
            EditClass::Function => "sine for cosine",
            EditClass::Symbol => "a wrong symbol",
            EditClass::Dropped => "a term or factor left out",
            EditClass::Transpose => "a wrong transpose",
            EditClass::Orientation => "the other orientation of a vector product",
            EditClass::Convention => "another convention for an angle or an order",
            EditClass::Missing => "a missing term or factor",
        }
    }
}

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

type Edited<T> = Vec<(EditClass, T)>;

/// Every tree that differs from a chain of relations by one edit.
pub(super) fn edits(chain: &Chain, vocabulary: &Vocabulary) -> Edited<Chain> {
    let editor = Editor::new(chain.sides.iter(), vocabulary);
    let mut out = Vec::new();
    for (k, side) in chain.sides.iter().enumerate() {
        for (class, side) in editor.within(side, Place::Whole) {
            let mut edited = chain.clone();
            edited.sides[k] = side;
            out.push((class, edited));
        }
    }
    for convention in editor.conventions() {
        let sides = chain.sides.iter().map(|s| convention.apply(s)).collect();
        out.push((EditClass::Convention, Chain { sides, ..chain.clone() }));
    }
    out
}

/// The function that is put for another by mistake.
pub(super) fn confused(function: &str) -> Option<&'static str> {
    Some(match function {
        "sin" => "cos",
        "cos" => "sin",
        "sinh" => "cosh",
        "cosh" => "sinh",
        "arcsin" => "arccos",
        "arccos" => "arcsin",
        "tan" => "cot",
        "cot" => "tan",
        _ => return None,
    })
}

struct Editor<'a> {
    vocabulary: &'a Vocabulary,
    symbols: Vec<&'a SymbolNode>,
    /// Letters that stand as indices somewhere.
    letters: Vec<Name>,
    /// Symbols that stand alone as the argument of a sine or cosine.
    angles: Vec<SymbolKey>,
}

impl<'a> Editor<'a> {
    fn new(sides: impl Iterator<Item = &'a Node>, vocabulary: &'a Vocabulary) -> Editor<'a> {
        let mut nodes = Vec::new();
        for side in sides {
            walk(side, &mut nodes);
        }
        let mut editor = Editor { vocabulary, symbols: Vec::new(), letters: Vec::new(), angles: Vec::new() };
        for node in nodes {
            match &node.kind {
                NodeKind::Symbol(s) if !is_transpose(node) => {
                    for item in &s.sub.as_deref().unwrap_or(&[])[editor.own(s)..] {
                        if let SubItem::Name(letter) = item
                            && !editor.letters.contains(letter)
                        {
                            editor.letters.push(letter.clone());
                        }
                    }
                    editor.symbols.push(s);
                }
                NodeKind::Function(f, _, arguments) if matches!(f.as_str(), "sin" | "cos") => {
                    if let [Node { kind: NodeKind::Symbol(s), .. }] = arguments.as_slice()
                        && let Some(key) = editor.key(s).filter(|k| !editor.angles.contains(k))
                    {
                        editor.angles.push(key);
                    }
                }
                _ => {}
            }
        }
        editor
    }

    /// How much of a subscript belongs to the name.
    fn own(&self, s: &SymbolNode) -> usize {
        self.vocabulary.word(s).map_or(0, |(_, own)| own)
    }

    fn key(&self, s: &SymbolNode) -> Option<SymbolKey> {
        self.vocabulary.word(s).map(|(word, _)| SymbolKey { name: s.name.clone(), sub: word.sub.clone() })
    }

    fn conventions(&self) -> Vec<Convention> {
        let mut out = Vec::new();
        let mut present: Vec<SymbolKey> = Vec::new();
        for s in &self.symbols {
            if let Some(key) = self.key(s)
                && !present.contains(&key)
            {
                present.push(key);
            }
        }
        for (i, a) in present.iter().enumerate() {
            for b in &present[i + 1..] {
                let word = |k: &SymbolKey| self.symbols.iter().find(|s| k.is(s)).and_then(|s| self.vocabulary.word(s));
                if let (Some((a_word, _)), Some((b_word, _))) = (word(a), word(b))
                    && self.vocabulary.like(a_word).any(|w| w == b_word)
                {
                    out.push(Convention::Exchange(a.clone(), b.clone()));
                }
            }
        }
        for angle in &self.angles {
            out.push(Convention::QuarterTurn(angle.clone()));
            out.push(Convention::Backwards(angle.clone()));
        }
        out
    }

    /// Every edit of a node and of what is inside it.
    fn within(&self, node: &Node, place: Place) -> Edited<Node> {
        let mut out = Vec::new();
        if place == Place::Fixed {
            return out;
        }
        if place == Place::Whole && !node.is_zero() && !matches!(node.kind, NodeKind::Sum(_)) {
            if !matches!(node.kind, NodeKind::Tuple(_) | NodeKind::Matrix(_) | NodeKind::Identity) {
                out.push((EditClass::Sign, negated(node)));
            }
            self.factors(node, |scaled| scaled, &mut out);
        }
        self.local(node, &mut out);
        if as_number(node).is_some() {
            return out;
        }
        for (at, child) in node.children().into_iter().enumerate() {
            let place = place_of(node, at, child, self.vocabulary);
            for (class, child) in self.within(child, place) {
                out.push((class, with_part(node, at, child)));
            }
        }
        out
    }

    fn factors(&self, node: &Node, around: impl Fn(Node) -> Node, out: &mut Edited<Node>) {
        if node.is_zero() || matches!(node.kind, NodeKind::Tuple(_) | NodeKind::Matrix(_) | NodeKind::Identity) {
            return;
        }
        let two = Rational::from(2);
        let half = Rational::ONE / &two;
        for factor in [two, half] {
            out.push((EditClass::Factor, around(scaled(node, &factor))));
        }
    }

    /// Edits of the node itself.
    fn local(&self, node: &Node, out: &mut Edited<Node>) {
        let span = &node.span;
        let kind = |kind| Node::new(kind, span.clone());
        match &node.kind {
            NodeKind::Symbol(s) => self.symbol(s, node, out),
            NodeKind::Sum(terms) => {
                for (i, (sign, term)) in terms.iter().enumerate() {
                    let with = |sign: Sign, term: Node| {
                        let mut terms = terms.clone();
                        terms[i] = (sign, term);
                        sum(terms, span)
                    };
                    let signs: &[Sign] = match sign {
                        Sign::Plus => &[Sign::Minus],
                        Sign::Minus => &[Sign::Plus],
                        Sign::PlusMinus | Sign::MinusPlus => &[Sign::Plus, Sign::Minus],
                    };
                    for &other in signs {
                        out.push((EditClass::Sign, with(other, term.clone())));
                    }
                    self.factors(term, |scaled| with(*sign, scaled), out);
                    if terms.len() > 1 {
                        let mut rest = terms.clone();
                        rest.remove(i);
                        out.push((EditClass::Dropped, sum(rest, span)));
                    }
                }
            }
            NodeKind::Product(parts) => {
                for (i, part) in parts.iter().enumerate() {
                    if !part.is_numeric() {
                        out.extend(without(parts, i, span).map(|n| (EditClass::Dropped, n)));
                    }
                }
            }
            NodeKind::Quotient { top, bottom, slash } => {
                if !top.is_numeric() {
                    let one = Box::new(kind(NodeKind::Number(Rational::ONE)));
                    let alone = NodeKind::Quotient { top: one, bottom: bottom.clone(), slash: *slash };
                    out.push((EditClass::Dropped, kind(alone)));
                }
                if !bottom.is_numeric() {
                    out.push((EditClass::Dropped, (**top).clone()));
                }
            }
            NodeKind::Scripted { base, sub, sup, sup_first } => {
                if let (Some(n), NodeKind::Group(..)) = (sup.as_deref().and_then(exponent), &base.kind) {
                    for m in neighbours(n) {
                        let sup = raised(m, span);
                        let new = match (&sup, sub) {
                            (None, None) => (**base).clone(),
                            _ => {
                                let (base, sub) = (base.clone(), sub.clone());
                                kind(NodeKind::Scripted { base, sub, sup, sup_first: *sup_first })
                            }
                        };
                        out.push((EditClass::Power, new));
                    }
                }
                if sup.as_deref().is_some_and(is_transpose) && sub.is_none() {
                    out.push((EditClass::Transpose, (**base).clone()));
                }
            }
            NodeKind::Group(_, Bracket::Round) => out.push((EditClass::Power, scripted(node.clone(), 2))),
            NodeKind::Root(inner, _) => {
                let group = kind(NodeKind::Group(inner.clone(), Bracket::Round));
                out.push((EditClass::Power, group));
            }
            NodeKind::Function(f, power, arguments) => {
                if let Some(other) = confused(f) {
                    let new = NodeKind::Function(other.into(), *power, arguments.clone());
                    out.push((EditClass::Function, kind(new)));
                }
                if arguments.len() == 1 && !matches!(f.as_str(), "tr" | "det" | "diag") {
                    let n = power.unwrap_or(1);
                    for m in [n - 1, n + 1].into_iter().filter(|m| *m > 0) {
                        let new = NodeKind::Function(f.clone(), (m > 1).then_some(m), arguments.clone());
                        out.push((EditClass::Power, kind(new)));
                    }
                }
            }
            NodeKind::Cross { left, right, bracket } => {
                let new = NodeKind::Cross { left: right.clone(), right: left.clone(), bracket: *bracket };
                out.push((EditClass::Orientation, kind(new)));
            }
            NodeKind::Number(_)
            | NodeKind::Pi
            | NodeKind::Identity
            | NodeKind::Group(..)
            | NodeKind::Dot(_)
            | NodeKind::Exponential { .. }
            | NodeKind::Absolute(_)
            | NodeKind::Derivative { .. }
            | NodeKind::Tuple(_)
            | NodeKind::Matrix(_)
            | NodeKind::Limit(..) => {}
        }
    }

    fn symbol(&self, s: &SymbolNode, node: &Node, out: &mut Edited<Node>) {
        let span = &node.span;
        let kind = |s: SymbolNode| Node::new(NodeKind::Symbol(s), span.clone());
        let found = self.vocabulary.word(s);
        let own = found.map_or(0, |(_, own)| own);
        let sub: &[SubItem] = s.sub.as_deref().unwrap_or(&[]);
        let epsilon = found.is_none() && matches!(s.name.as_str(), "\\epsilon" | "\\varepsilon") && sub.len() == 3;
        if epsilon {
            let mut turned = sub.to_vec();
            turned.swap(0, 1);
            out.push((EditClass::Orientation, kind(SymbolNode { sub: Some(turned), ..s.clone() })));
        }
        if let Some((word, _)) = found
            && s.arguments.as_ref().is_none_or(|a| a.len() == 1)
        {
            for other in self.vocabulary.like(word) {
                out.push((EditClass::Symbol, kind(renamed(s, own, &other.name, &other.sub))));
            }
        }
        // Indices.
        for (i, item) in sub.iter().enumerate().skip(own) {
            let with = |item: SubItem| {
                let mut sub = sub.to_vec();
                sub[i] = item;
                kind(SymbolNode { sub: Some(sub), ..s.clone() })
            };
            match item {
                SubItem::Digit(d) => {
                    let extent = found.and_then(|(w, _)| w.extents.iter().max().copied()).unwrap_or(3);
                    for other in (1..=extent.min(9)).filter(|o| o != d) {
                        out.push((EditClass::Index, with(SubItem::Digit(other))));
                    }
                }
                SubItem::Name(letter) => {
                    for other in self.letters.iter().filter(|o| *o != letter) {
                        out.push((EditClass::Index, with(SubItem::Name(other.clone()))));
                    }
                }
                SubItem::Other(_) => {}
            }
        }
        if let ([first, second], false) = (&sub[own..], epsilon)
            && first != second
        {
            let mut turned = sub.to_vec();
            turned.swap(own, own + 1);
            out.push((EditClass::Index, kind(SymbolNode { sub: Some(turned), ..s.clone() })));
        }
        // Powers and transposes.
        let with_sup = |sup: Option<Box<Node>>| kind(SymbolNode { sup, ..s.clone() });
        match s.sup.as_deref() {
            Some(sup) if is_transpose(sup) => out.push((EditClass::Transpose, with_sup(None))),
            Some(sup) => {
                if let Some(n) = exponent(sup) {
                    out.extend(neighbours(n).map(|m| (EditClass::Power, with_sup(raised(m, span)))));
                }
            }
            None => {
                let left = found.map_or(0, |(w, _)| w.rank).saturating_sub(sub.len() - own);
                let places = found.is_some_and(|(w, _)| w.rank > 0) && sub.len() > own;
                if found.is_some() && (left == 0 || places) && s.arguments.is_none() {
                    out.extend(neighbours(1).map(|m| (EditClass::Power, with_sup(raised(m, span)))));
                }
                if left == 2 && sub.len() == own {
                    out.push((EditClass::Transpose, with_sup(Some(Box::new(transpose(span))))));
                }
            }
        }
    }
}

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
