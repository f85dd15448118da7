//! Slips: a formula with one place altered.
//!
//! **In:** the syntax tree of a side. **Out:** trees that differ in one place as authors and typesetters slip: a sign, a factor of 2,
//! an exponent, a function and its partner, one name for another, a quotient upside down, what is left out. Whether
//! one of them holds is asked elsewhere.

use expr::Rational;
use latex::syntax::{Bracket, Node, NodeKind, Sign, SymbolNode};

/// The most nodes of a side that is altered.
const MOST_NODES: usize = 220;

/// How far a term that is a number may be from the right one.
const FARTHEST: i64 = 9;

/// A side with one place altered.
#[derive(Clone, Debug)]
pub struct Slip {
    /// The altered side.
    pub side: Node,
    /// The way in which it is altered.
    pub way: Alteration,
}

/// The way in which a place is altered; the plain ones come first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Alteration {
    /// A sign, a number, an exponent, a function: the same names stand there.
    Value,
    /// A factor is divided by, or what is divided by is a factor.
    Inverse,
    /// A factor is left out.
    LostFactor,
    /// A term is left out.
    LostTerm,
    /// A term is put in: the print lost it.
    MissingTerm,
    /// One name is put for another.
    Exchange {
        /// The name that was printed.
        of: String,
        /// The name that is put there.
        by: String,
    },
}

/// A tree without brackets, whose work the tree itself does, and without exponents of 1: what two sides are compared by.
pub fn bare(of: &Node) -> Node {
    let is_one = |sup: &Option<Box<Node>>| sup.as_ref().is_some_and(|n| is_one(n));
    match &of.kind {
        NodeKind::Group(inner, Bracket::Round | Bracket::Square) => return bare(inner),
        NodeKind::Scripted { base, sub: None, sup, .. } if is_one(sup) => return bare(base),
        NodeKind::Symbol(s) if is_one(&s.sup) => {
            return node(NodeKind::Symbol(SymbolNode { sup: None, ..s.clone() }), of);
        }
        _ => {}
    }
    let mut out = of.clone();
    for (k, child) in of.children().into_iter().enumerate() {
        out = with_child(&out, k, bare(child)).unwrap_or(out);
    }
    out
}

/// A tree as one would print it: what a slip put in is taken together with the fraction, or the product, that was there.
pub fn simplified(of: &Node) -> Node {
    let mut out = of.clone();
    for (k, child) in of.children().into_iter().enumerate() {
        out = with_child(&out, k, simplified(child)).unwrap_or(out);
    }
    match &out.kind {
        NodeKind::Quotient { top, bottom, slash: false } => match (&top.kind, &bottom.kind) {
            (NodeKind::Quotient { top, bottom: inner, slash: false }, NodeKind::Number(by)) => {
                let bottom = match &inner.kind {
                    NodeKind::Number(n) => node(NodeKind::Number(n.clone() * by.clone()), inner),
                    NodeKind::Product(parts) if !inner.begins_with_number() => {
                        let parts = std::iter::once((**bottom).clone()).chain(parts.iter().cloned());
                        node(NodeKind::Product(parts.collect()), inner)
                    }
                    _ if !inner.begins_with_number() => {
                        node(NodeKind::Product(vec![(**bottom).clone(), factor(inner)]), inner)
                    }
                    _ => return out,
                };
                node(NodeKind::Quotient { top: top.clone(), bottom: Box::new(bottom), slash: false }, of)
            }
            _ => out,
        },
        NodeKind::Product(parts) => match parts.as_slice() {
            [one, other] if is_number_one(one) => other.clone(),
            [one, rest @ ..] if is_number_one(one) && rest.len() > 1 => node(NodeKind::Product(rest.to_vec()), of),
            _ => out,
        },
        _ => out,
    }
}

fn is_number_one(node: &Node) -> bool {
    matches!(&node.kind, NodeKind::Number(n) if *n == Rational::ONE)
}

/// Whether a tree is the number 1, with a sign or without: `A^{+1}` is A.
fn is_one(node: &Node) -> bool {
    match &node.kind {
        NodeKind::Number(r) => *r == Rational::ONE,
        NodeKind::Sum(terms) => matches!(terms.as_slice(), [(Sign::Plus, one)] if is_one(one)),
        _ => false,
    }
}

/// The number of nodes of a tree.
pub fn size(node: &Node) -> usize {
    1 + node.children().into_iter().map(size).sum::<usize>()
}

/// All slips of a side, the plain ones first; `names` are the symbols of the whole step.
pub fn slips(side: &Node, names: &[SymbolNode]) -> Vec<Slip> {
    if size(side) > MOST_NODES {
        return Vec::new();
    }
    let value = |side| Slip { side, way: Alteration::Value };
    // A sign is put in front of all where it can be.
    let mut out = vec![value(negated(side))];
    out.extend(altered(side, names));
    out.extend([scaled(side, 2), halved(side)].map(value));
    out.extend(with_a_term(side, names));
    // Exchanges of names are many: they come last.
    out.sort_by_key(|s| match s.way {
        Alteration::Value => 0,
        Alteration::LostFactor | Alteration::LostTerm | Alteration::Inverse => 1,
        Alteration::Exchange { .. } => 2,
        Alteration::MissingTerm => 3,
    });
    out
}

/// The most names of which products are put in as a term.
const MOST_NAMES: usize = 6;

/// Sums with one term more: a name, or a product of two, once or twice.
fn with_a_term(side: &Node, names: &[SymbolNode]) -> Vec<Slip> {
    let NodeKind::Sum(terms) = &side.kind else { return Vec::new() };
    if terms.len() < 2 || names.len() > MOST_NAMES {
        return Vec::new();
    }
    let symbol = |s: &SymbolNode| node(NodeKind::Symbol(s.clone()), side);
    let mut more: Vec<Node> = names.iter().map(symbol).collect();
    for (k, a) in names.iter().enumerate() {
        more.extend(names[k + 1..].iter().map(|b| node(NodeKind::Product(vec![symbol(a), symbol(b)]), side)));
    }
    let mut out = Vec::new();
    for term in more {
        for term in [scaled(&term, 2), term] {
            for sign in [Sign::Plus, Sign::Minus] {
                let mut terms = terms.clone();
                terms.push((sign, term.clone()));
                out.push(Slip { side: node(NodeKind::Sum(terms), side), way: Alteration::MissingTerm });
            }
        }
    }
    out
}

/// The symbols of a tree, each once, without what stands above them.
pub fn symbols(node: &Node, out: &mut Vec<SymbolNode>) {
    if let NodeKind::Symbol(s) = &node.kind {
        let bare = SymbolNode { sup: None, sup_first: false, ..s.clone() };
        if !out.iter().any(|o| o.name == bare.name && o.sub == bare.sub && o.dots == bare.dots) {
            out.push(bare);
        }
    }
    for child in node.children() {
        symbols(child, out);
    }
}

fn node(kind: NodeKind, like: &Node) -> Node {
    Node::new(kind, like.span.clone())
}

fn number(n: i64, like: &Node) -> Node {
    node(NodeKind::Number(Rational::from(n)), like)
}

/// In parentheses, where it is a sum.
fn factor(of: &Node) -> Node {
    match of.kind {
        NodeKind::Sum(_) => node(NodeKind::Group(Box::new(of.clone()), Bracket::Round), of),
        _ => of.clone(),
    }
}

fn scaled(of: &Node, by: i64) -> Node {
    let mut parts = vec![number(by, of)];
    match &of.kind {
        NodeKind::Product(more) if !of.begins_with_number() => parts.extend(more.iter().cloned()),
        _ if of.begins_with_number() => {
            return node(NodeKind::Dot(vec![number(by, of), factor(of)]), of);
        }
        _ => parts.push(factor(of)),
    }
    node(NodeKind::Product(parts), of)
}

fn halved(of: &Node) -> Node {
    let bottom = Box::new(number(2, of));
    node(NodeKind::Quotient { top: Box::new(of.clone()), bottom, slash: false }, of)
}

fn negated(of: &Node) -> Node {
    match &of.kind {
        NodeKind::Sum(terms) if matches!(terms.as_slice(), [(Sign::Minus, _)]) => terms[0].1.clone(),
        NodeKind::Sum(terms) => node(NodeKind::Sum(terms.iter().map(|(s, n)| (opposite(*s), n.clone())).collect()), of),
        _ => node(NodeKind::Sum(vec![(Sign::Minus, of.clone())]), of),
    }
}

fn opposite(sign: Sign) -> Sign {
    match sign {
        Sign::Plus => Sign::Minus,
        Sign::Minus => Sign::Plus,
        Sign::PlusMinus => Sign::MinusPlus,
        Sign::MinusPlus => Sign::PlusMinus,
    }
}

const PARTNERS: &[(&str, &str)] = &[
    ("sin", "cos"),
    ("cos", "sin"),
    ("sinh", "cosh"),
    ("cosh", "sinh"),
    ("tan", "cot"),
    ("cot", "tan"),
    ("tanh", "coth"),
];

/// The trees with one place of this one altered.
fn altered(of: &Node, names: &[SymbolNode]) -> Vec<Slip> {
    let mut out: Vec<Slip> = own(of, names);
    let children = of.children();
    for (k, child) in children.iter().enumerate() {
        for slip in altered(child, names) {
            if let Some(side) = with_child(of, k, slip.side.clone()) {
                out.push(Slip { side, ..slip.clone() });
            }
        }
    }
    out
}

/// Whether a factor is a small Latin letter: a capital one may be its own inverse, as a matrix, and so is a sign.
fn is_quantity(of: &Node) -> bool {
    let is_letter =
        |name: &str| name.len() == 1 && name.starts_with(|c: char| c.is_ascii_lowercase() && !"eijs".contains(c));
    matches!(&of.kind, NodeKind::Symbol(s) if is_letter(&s.name) && s.sup.is_none() && s.arguments.is_none() && s.dots == 0)
}

/// What is altered at the top of a tree.
fn own(of: &Node, names: &[SymbolNode]) -> Vec<Slip> {
    let mut out: Vec<Node> = Vec::new();
    let mut exchanged = Vec::new();
    let mut dropped: Vec<Node> = Vec::new();
    let mut inverse: Vec<Node> = Vec::new();
    match &of.kind {
        NodeKind::Number(r) => {
            let near = [Rational::ONE, -Rational::ONE, r.clone()].map(|d| r.clone() + d);
            // A larger number that was reckoned wrongly.
            let is_large = *r > Rational::from(FARTHEST);
            let far = (2..=FARTHEST).flat_map(|k| [r.clone() + Rational::from(k), r.clone() - Rational::from(k)]);
            let all = near.into_iter().chain(far.filter(|_| is_large));
            out.extend(all.filter(|n| *n > Rational::ZERO).map(|n| node(NodeKind::Number(n), of)));
        }
        NodeKind::Sum(terms) => {
            for i in 0..terms.len() {
                let with = |term: (Sign, Node)| {
                    let mut terms = terms.clone();
                    terms[i] = term;
                    node(NodeKind::Sum(terms), of)
                };
                let (sign, term) = &terms[i];
                if let NodeKind::Number(r) = &term.kind {
                    // A sum that was added up wrongly.
                    let near =
                        (2..=FARTHEST).flat_map(|k| [r.clone() + Rational::from(k), r.clone() - Rational::from(k)]);
                    out.extend(near.map(|n| match n < Rational::ZERO {
                        true => with((opposite(*sign), node(NodeKind::Number(-n), of))),
                        false => with((*sign, node(NodeKind::Number(n), of))),
                    }));
                }
                out.push(with((opposite(*sign), term.clone())));
                out.extend([2, 3, 4].map(|by| with((*sign, scaled(term, by)))));
                out.push(with((*sign, halved(term))));
                if terms.len() > 2 {
                    let mut rest = terms.clone();
                    rest.remove(i);
                    dropped.push(node(NodeKind::Sum(rest), of));
                }
            }
        }
        NodeKind::Product(parts) if parts.len() > 1 => {
            for i in 0..parts.len() {
                let mut rest = parts.clone();
                rest.remove(i);
                let rest = match rest.len() {
                    1 => rest.swap_remove(0),
                    _ => node(NodeKind::Product(rest), of),
                };
                if is_quantity(&parts[i]) {
                    let [top, bottom] = [&rest, &parts[i]].map(|n| Box::new(n.clone()));
                    inverse.push(node(NodeKind::Quotient { top, bottom, slash: false }, of));
                }
                dropped.push(rest);
            }
        }
        NodeKind::Quotient { top, bottom, slash } => {
            // A lost square of what is divided by; a quotient upside down.
            if matches!(bottom.kind, NodeKind::Sum(_)) {
                let sup = Some(Box::new(number(2, of)));
                let base = Box::new(factor(bottom));
                let squared = Box::new(node(NodeKind::Scripted { base, sub: None, sup, sup_first: false }, of));
                out.push(node(NodeKind::Quotient { top: top.clone(), bottom: squared, slash: *slash }, of));
            }
            if is_quantity(bottom) {
                inverse.push(node(NodeKind::Product(vec![factor(top), (**bottom).clone()]), of));
            }
            let (top, bottom) = (bottom.clone(), top.clone());
            out.push(node(NodeKind::Quotient { top, bottom, slash: *slash }, of));
        }
        NodeKind::Function(name, power, arguments) => {
            if let Some((_, partner)) = PARTNERS.iter().find(|(f, _)| f == name) {
                out.push(node(NodeKind::Function((*partner).to_owned(), *power, arguments.clone()), of));
            }
            let other = match power {
                None => Some(2),
                Some(2) => None,
                Some(n) => Some(n - 1),
            };
            out.push(node(NodeKind::Function(name.clone(), other, arguments.clone()), of));
            if let [one] = arguments.as_slice() {
                let with = |argument| node(NodeKind::Function(name.clone(), *power, vec![argument]), of);
                out.extend([scaled(one, 2), halved(one), negated(one)].map(with));
            }
        }
        NodeKind::Exponential { exponent, upright } => {
            let with = |e| node(NodeKind::Exponential { exponent: Box::new(e), upright: *upright }, of);
            out.extend([scaled(exponent, 2), halved(exponent), negated(exponent)].map(with));
        }
        NodeKind::Root(inner, 2) => out.push(node(NodeKind::Group(inner.clone(), Bracket::Round), of)),
        NodeKind::Symbol(s) => {
            match &s.sup {
                None => {
                    let sup = Some(Box::new(number(2, of)));
                    out.push(node(NodeKind::Symbol(SymbolNode { sup, ..s.clone() }), of));
                }
                Some(sup) if matches!(sup.kind, NodeKind::Number(_)) => {
                    out.push(node(NodeKind::Symbol(SymbolNode { sup: None, ..s.clone() }), of));
                }
                Some(_) => {}
            }
            // A name without its label is that name, where it is plain which is meant.
            let is_short = |n: &SymbolNode| n.name == s.name && n.sub.is_none() != s.sub.is_none();
            let is_other = |n: &&SymbolNode| (&n.name, &n.sub, n.dots) != (&s.name, &s.sub, s.dots) && !is_short(n);
            for other in names.iter().filter(is_other) {
                let symbol = SymbolNode { sup: s.sup.clone(), sup_first: s.sup_first, ..other.clone() };
                let spelled = |s: &SymbolNode| format!("{}{:?}", s.name, s.sub);
                exchanged.push(Slip {
                    side: node(NodeKind::Symbol(symbol), of),
                    way: Alteration::Exchange { of: spelled(s), by: spelled(other) },
                });
            }
        }
        NodeKind::Group(inner, bracket) => {
            let _ = bracket;
            if !matches!(inner.kind, NodeKind::Sum(_)) {
                return Vec::new();
            }
            out.push(node(
                NodeKind::Scripted {
                    base: Box::new(of.clone()),
                    sub: None,
                    sup: Some(Box::new(number(2, of))),
                    sup_first: false,
                },
                of,
            ));
        }
        NodeKind::Pi => {
            let sup = Some(Box::new(number(2, of)));
            out.push(node(NodeKind::Scripted { base: Box::new(of.clone()), sub: None, sup, sup_first: false }, of));
        }
        NodeKind::Scripted { base, sub: None, .. } => out.push((**base).clone()),
        _ => {}
    }
    let lost = if matches!(of.kind, NodeKind::Sum(_)) { Alteration::LostTerm } else { Alteration::LostFactor };
    let plain = out.into_iter().map(|side| Slip { side, way: Alteration::Value });
    let with = |all: Vec<Node>, way: Alteration| all.into_iter().map(move |side| Slip { side, way: way.clone() });
    plain.chain(with(dropped, lost)).chain(with(inverse, Alteration::Inverse)).chain(exchanged).collect()
}

/// A tree with another child in the place of one; `None` for kinds in which nothing is altered.
fn with_child(of: &Node, k: usize, child: Node) -> Option<Node> {
    let boxed = |n: Node| Box::new(n);
    let kind = match &of.kind {
        NodeKind::Symbol(s) => {
            let mut s = s.clone();
            let above = usize::from(s.sup.is_some());
            if k < above {
                s.sup = Some(boxed(child));
            } else {
                *s.arguments.as_mut()?.get_mut(k - above)? = child;
            }
            NodeKind::Symbol(s)
        }
        NodeKind::Scripted { base, sub, sup, sup_first } => {
            let (mut base, mut sup) = (base.clone(), sup.clone());
            if k == 0 {
                base = boxed(child)
            } else {
                sup = Some(boxed(child))
            }
            NodeKind::Scripted { base, sub: sub.clone(), sup, sup_first: *sup_first }
        }
        NodeKind::Sum(terms) => {
            let mut terms = terms.clone();
            terms.get_mut(k)?.1 = child;
            NodeKind::Sum(terms)
        }
        NodeKind::Product(parts) => NodeKind::Product(replaced(parts, k, child)?),
        NodeKind::Dot(parts) => NodeKind::Dot(replaced(parts, k, child)?),
        NodeKind::Tuple(parts) => NodeKind::Tuple(replaced(parts, k, child)?),
        NodeKind::Matrix(rows) => {
            let mut rows = rows.clone();
            *rows.iter_mut().flatten().nth(k)? = child;
            NodeKind::Matrix(rows)
        }
        NodeKind::Function(f, p, parts) => NodeKind::Function(f.clone(), *p, replaced(parts, k, child)?),
        NodeKind::Quotient { top, bottom, slash } => {
            let (mut top, mut bottom) = (top.clone(), bottom.clone());
            if k == 0 {
                top = boxed(child)
            } else {
                bottom = boxed(child)
            }
            NodeKind::Quotient { top, bottom, slash: *slash }
        }
        NodeKind::Group(_, bracket) => NodeKind::Group(boxed(child), *bracket),
        NodeKind::Root(_, n) => NodeKind::Root(boxed(child), *n),
        NodeKind::Absolute(_) => NodeKind::Absolute(boxed(child)),
        NodeKind::Exponential { upright, .. } => NodeKind::Exponential { exponent: boxed(child), upright: *upright },
        NodeKind::Derivative { of: _, by, order, operator, upright } if k == 0 => NodeKind::Derivative {
            of: boxed(child),
            by: by.clone(),
            order: *order,
            operator: *operator,
            upright: *upright,
        },
        NodeKind::Partial { of: _, by, form } if k == 0 => {
            NodeKind::Partial { of: boxed(child), by: by.clone(), form: *form }
        }
        _ => return None,
    };
    Some(Node::new(kind, of.span.clone()))
}

fn replaced(parts: &[Node], k: usize, child: Node) -> Option<Vec<Node>> {
    let mut parts = parts.to_vec();
    *parts.get_mut(k)? = child;
    Some(parts)
}
