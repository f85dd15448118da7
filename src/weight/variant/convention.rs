//! Conventions: rules that change a formula throughout.
//!
//! Nothing is built in about any of them: which symbols are alike, and which are angles, is seen from the formula and from the
//! declarations of the file.

use super::tree::{negated, parts_mut, scripted};
use crate::latex::syntax::{Bracket, Name, Node, NodeKind, SubItem, SymbolNode};

/// A rule that is applied to the whole formula.
#[derive(Clone, Debug)]
pub(super) enum Convention {
    /// Two symbols change places.
    Exchange(SymbolKey, SymbolKey),
    /// The angle is counted from a quarter turn further: sin becomes cos, cos becomes −sin.
    QuarterTurn(SymbolKey),
    /// The angle is counted in the other direction.
    Backwards(SymbolKey),
}

/// A symbol without its indices and other attachments.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SymbolKey {
    /// Its name.
    pub name: Name,
    /// The part of the subscript that belongs to it.
    pub sub: Vec<SubItem>,
}

impl SymbolKey {
    /// Whether a symbol is this one, with whatever indices.
    pub fn is(&self, s: &SymbolNode) -> bool {
        s.name == self.name && s.sub.as_deref().unwrap_or(&[]).starts_with(&self.sub)
    }
    fn is_alone(&self, node: &Node) -> bool {
        matches!(&node.kind, NodeKind::Symbol(s) if self.is(s) && s.dots == 0 && s.sup.is_none() && s.arguments.is_none())
    }
}

/// A symbol under another name, with its indices; `own` is how much of its subscript belongs to the old name.
pub(super) fn renamed(s: &SymbolNode, own: usize, name: &Name, sub: &[SubItem]) -> SymbolNode {
    let rest = s.sub.as_deref().unwrap_or(&[]).get(own..).unwrap_or(&[]);
    let all: Vec<SubItem> = sub.iter().chain(rest).cloned().collect();
    SymbolNode { name: name.clone(), sub: (!all.is_empty()).then_some(all), ..s.clone() }
}

impl Convention {
    /// The formula under the other convention.
    pub fn apply(&self, node: &Node) -> Node {
        let mut out = node.clone();
        for part in parts_mut(&mut out) {
            *part = self.apply(part);
        }
        match (self, &out.kind) {
            (Convention::Exchange(a, b), NodeKind::Symbol(s)) => {
                let new = match (a.is(s), b.is(s)) {
                    (true, false) => renamed(s, a.sub.len(), &b.name, &b.sub),
                    (false, true) => renamed(s, b.sub.len(), &a.name, &a.sub),
                    _ => return out,
                };
                out.kind = NodeKind::Symbol(new);
                out
            }
            (Convention::QuarterTurn(angle), NodeKind::Function(f, power, arguments)) => {
                let [argument] = arguments.as_slice() else { return out };
                if !angle.is_alone(argument) {
                    return out;
                }
                let function =
                    |f: &str, p| Node::new(NodeKind::Function(f.into(), p, arguments.clone()), out.span.clone());
                match f.as_str() {
                    "sin" => function("cos", *power),
                    "cos" if power.is_some_and(|n| n % 2 == 0) => function("sin", *power),
                    "cos" => {
                        let minus = negated(&function("sin", None));
                        let group = Node::new(NodeKind::Group(Box::new(minus), Bracket::Round), out.span.clone());
                        match power {
                            None => group,
                            Some(n) => scripted(group, i64::from(*n)),
                        }
                    }
                    _ => out,
                }
            }
            (Convention::Backwards(angle), NodeKind::Symbol(s)) if angle.is(s) => {
                let minus = negated(&Node::new(out.kind.clone(), out.span.clone()));
                Node::new(NodeKind::Group(Box::new(minus), Bracket::Round), out.span.clone())
            }
            _ => out,
        }
    }
}
