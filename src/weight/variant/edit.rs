//! Single edits of a formula: the slips that authors and typesetters make.
//!
//! **In:** the syntax tree of a formula. **Out:** an [`Edit`]: where something is altered, and what is put there, from which the
//! altered tree can be made. Which edits there are is the business of `sites`; whether a tree has a meaning is not asked here.
//!
//! **Why trees and not text or graphs:** an edited tree can be printed as the formula that an author would have written, and
//! the reader of formulas refuses what has no meaning. **Why a description and not the tree:** there are more edits than
//! anybody tries, and each tree is as large as the formula.

use super::convention::Convention;
use super::tree::{negated, parts_mut, raised, scaled, scripted, sum, without};
use crate::expr::Rational;
use crate::findings::EditClass;
use crate::latex::syntax::{Bracket, Chain, Node, NodeKind, Sign, SymbolNode};

/// One edit of a chain of relations.
#[derive(Clone, Debug)]
pub(super) struct Edit {
    /// What kind of slip.
    pub class: EditClass,
    /// The side of the chain.
    pub side: usize,
    /// From the side to the altered node: positions among the parts of each node.
    pub path: Box<[u32]>,
    /// What is put there.
    pub change: Change,
}

/// What becomes of a node.
#[derive(Clone, Debug)]
pub(super) enum Change {
    /// Its opposite.
    Negated,
    /// A multiple of it.
    Scaled(Rational),
    /// A sum with another sign of a term.
    TermSign(usize, Sign),
    /// A sum with a multiple of a term.
    TermScaled(usize, Rational),
    /// A sum without a term.
    TermDropped(usize),
    /// A product without a factor.
    FactorDropped(usize),
    /// A quotient with 1 above.
    TopDropped,
    /// A quotient without what is below.
    BottomDropped,
    /// Something in brackets to another power.
    Power(i64),
    /// Without its superscript.
    Bare,
    /// Something in brackets, squared.
    Squared,
    /// What is under a root.
    RootLeftOut,
    /// Another function of the same.
    Function(&'static str),
    /// Another power of a function.
    FunctionPower(i32),
    /// The factors of a vector product exchanged.
    Turned,
    /// Another symbol, or the same with something else attached.
    Symbol(Box<SymbolNode>),
    /// All sides under another convention; the path says nothing.
    Throughout(Convention),
}

impl Edit {
    /// The altered chain.
    pub fn apply(&self, chain: &Chain) -> Chain {
        if let Change::Throughout(convention) = &self.change {
            let sides = chain.sides.iter().map(|s| convention.apply(s)).collect();
            return Chain { sides, ..chain.clone() };
        }
        let mut out = chain.clone();
        let mut place = out.sides.get_mut(self.side);
        for &at in &self.path {
            place = place.and_then(|node| parts_mut(node).into_iter().nth(at as usize));
        }
        if let Some(node) = place {
            *node = self.change.of(node);
        }
        out
    }
}

impl Change {
    /// The altered node; the node itself where it is not of the kind that the change is for.
    fn of(&self, node: &Node) -> Node {
        let span = &node.span;
        let kind = |kind| Node::new(kind, span.clone());
        match (self, &node.kind) {
            (Change::Negated, _) => negated(node),
            (Change::Scaled(factor), _) => scaled(node, factor),
            (Change::TermSign(i, sign), NodeKind::Sum(terms)) => {
                let mut terms = terms.clone();
                terms[*i].0 = *sign;
                sum(terms, span)
            }
            (Change::TermScaled(i, factor), NodeKind::Sum(terms)) => {
                let mut terms = terms.clone();
                terms[*i].1 = scaled(&terms[*i].1, factor);
                sum(terms, span)
            }
            (Change::TermDropped(i), NodeKind::Sum(terms)) => {
                let mut terms = terms.clone();
                terms.remove(*i);
                sum(terms, span)
            }
            (Change::FactorDropped(i), NodeKind::Product(parts)) => {
                without(parts, *i, span).unwrap_or_else(|| node.clone())
            }
            (Change::TopDropped, NodeKind::Quotient { bottom, slash, .. }) => {
                let top = Box::new(kind(NodeKind::Number(Rational::ONE)));
                kind(NodeKind::Quotient { top, bottom: bottom.clone(), slash: *slash })
            }
            (Change::BottomDropped, NodeKind::Quotient { top, .. }) => (**top).clone(),
            (Change::Power(n), NodeKind::Scripted { base, sub, sup_first, .. }) => match (raised(*n, span), sub) {
                (None, None) => (**base).clone(),
                (sup, _) => {
                    let (base, sub) = (base.clone(), sub.clone());
                    kind(NodeKind::Scripted { base, sub, sup, sup_first: *sup_first })
                }
            },
            (Change::Bare, NodeKind::Scripted { base, .. }) => (**base).clone(),
            (Change::Squared, _) => scripted(node.clone(), 2),
            (Change::RootLeftOut, NodeKind::Root(inner, _)) => kind(NodeKind::Group(inner.clone(), Bracket::Round)),
            (Change::Function(other), NodeKind::Function(_, power, arguments)) => {
                kind(NodeKind::Function((*other).into(), *power, arguments.clone()))
            }
            (Change::FunctionPower(n), NodeKind::Function(f, _, arguments)) => {
                kind(NodeKind::Function(f.clone(), (*n > 1).then_some(*n), arguments.clone()))
            }
            (Change::Turned, NodeKind::Cross { left, right, bracket }) => {
                kind(NodeKind::Cross { left: right.clone(), right: left.clone(), bracket: *bracket })
            }
            (Change::Symbol(symbol), _) => kind(NodeKind::Symbol((**symbol).clone())),
            (
                Change::TermSign(..)
                | Change::TermScaled(..)
                | Change::TermDropped(_)
                | Change::FactorDropped(_)
                | Change::TopDropped
                | Change::BottomDropped
                | Change::Power(_)
                | Change::Bare
                | Change::RootLeftOut
                | Change::Function(_)
                | Change::FunctionPower(_)
                | Change::Turned
                | Change::Throughout(_),
                _,
            ) => node.clone(),
        }
    }
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
