//! Which of several corrections is the nearest to the print.
//!
//! **In:** altered formulas. **Out:** an order, the most likely first. Nothing in it looks at what a formula is about:
//!
//! 1. Where symbols have units, what is consistent in them goes before what is not.
//! 2. Fewer slips go before more. A correction undoes a slip, and a slip leaves something out more often than it puts something
//!    in: so leaving out a term or a factor of the print comes after single edits and completions.
//! 3. What is true by the definitions alone comes later: it would hardly have been printed.
//! 4. What is proved from what the claim follows from goes before what was only found to hold.
//! 5. Where one side is a symbol or a rate alone, the formula says what that is: the slip is on the other side.
//! 6. Fewer changed pieces of text go before more.
//! 7. Symbols that were declared for this claim alone are there to be used in it.
//! 8. The simpler meaning: fewer operations once every definition is inserted.
//! 9. What defines something usually stands on the right: there the slip is looked for first. Then shorter text.

use std::cmp::{Ordering, Reverse};

use super::generate::{Formula, Manner, Variant};
use super::tree::{walk, without_places};
use super::vocabulary::Vocabulary;
use crate::derivation::{Claim, Derivation};
use crate::expr::Graph;
use crate::findings::EditClass;
use crate::latex::syntax::{Chain, Node, NodeKind, SymbolNode, to_latex};
use claim::comparison::traced;

/// How near a correction is to the print; smaller is nearer. Fields in the order of their weight.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Nearness {
    /// Whether its units are inconsistent.
    pub inconsistent: bool,
    /// See [`edits_between`].
    pub edits: usize,
    /// Whether it is true by the definitions alone.
    pub empty: bool,
    /// Whether a side that was a symbol or a rate alone was changed.
    defined: bool,
    /// Pieces of text that were changed.
    changed: usize,
    /// Symbols in it that are declared for the claim alone.
    own: Reverse<usize>,
    /// Operations of its residual.
    operations: usize,
    /// Whether the left side was changed.
    left: bool,
    /// Its length.
    length: usize,
}

/// How many slips lead from a formula to the print, in halves: single edits, then what completes a formula, then what leaves
/// something out, then pairs.
pub(super) fn edits_between(classes: &[EditClass]) -> usize {
    let each = |class: &EditClass| match class {
        EditClass::Missing => 3,
        EditClass::Dropped => 4,
        _ => 2,
    };
    classes.iter().map(each).sum::<usize>() + 2 * classes.len().saturating_sub(1)
}

/// An altered formula: what it is, the edits, how it differs from the print as text, and in how many pieces.
pub(super) type Made = (Variant, Vec<EditClass>, String, usize);

impl Nearness {
    /// That of each of several alterations of a formula; whether one is empty is not yet asked.
    pub fn of_all(
        derivation: &Derivation,
        claim: &Claim,
        graph: &mut Graph,
        formula: &Formula,
        vocabulary: &Vocabulary,
        made: &[Made],
    ) -> Vec<Nearness> {
        let sides = |(variant, ..): &Made| {
            let constant = formula.manner == Manner::Constant;
            variant.altered.iter().map(|(_, p)| (p.sides.0, (!constant).then_some(p.sides.1))).collect()
        };
        let sides: Vec<Vec<_>> = made.iter().map(sides).collect();
        let inconsistent = units::inconsistent(derivation, graph, &sides);
        let mut out = Vec::new();
        for ((variant, classes, _, changed), inconsistent) in made.iter().zip(inconsistent) {
            let tree = &variant.tree(std::slice::from_ref(formula));
            let mut nodes = Vec::new();
            tree.sides.iter().for_each(|side| walk(side, &mut nodes));
            let is_own = |kind: &NodeKind| match kind {
                NodeKind::Symbol(s) => vocabulary.word(s).is_some_and(|(w, _)| w.is_own),
                _ => false,
            };
            let own = nodes.iter().filter(|n| is_own(&n.kind)).count();
            let residuals: Vec<_> = variant.altered.iter().filter_map(|(_, p)| p.difference.first().copied()).collect();
            let basic: Vec<_> = residuals.into_iter().map(|e| traced(graph, &claim.scope, e)).collect();
            out.push(Nearness {
                inconsistent,
                edits: edits_between(classes),
                empty: false,
                defined: formula.tree.sides.iter().zip(&tree.sides).any(|(old, new)| is_alone(old) && old != new),
                changed: *changed,
                own: Reverse(own),
                operations: graph.reachable(basic).len(),
                left: tree.sides.len() > 1 && tree.sides.first() != formula.tree.sides.first(),
                length: to_latex(tree).len(),
            });
        }
        out
    }

    /// The order when it is known which of two are proved.
    pub fn than(&self, proved: bool, other: &Nearness, other_proved: bool) -> Ordering {
        self.before_proofs().cmp(&other.before_proofs()).then(other_proved.cmp(&proved)).then_with(|| self.cmp(other))
    }

    /// What counts before it is asked which are proved.
    pub fn before_proofs(&self) -> (bool, usize, bool) {
        (self.inconsistent, self.edits, self.empty)
    }

    /// Whether nothing else needs to be looked for, once it is proved: one slip, and it says something.
    pub fn settles(&self) -> bool {
        !self.inconsistent && !self.empty && self.edits <= edits_between(&[EditClass::Sign])
    }
}

/// Whether a side is a symbol or a rate, and nothing else.
fn is_alone(side: &Node) -> bool {
    match &side.kind {
        NodeKind::Symbol(s) => s.sup.is_none(),
        NodeKind::Derivative { of, .. } => is_alone(of),
        _ => false,
    }
}

/// Whether a formula says what a symbol is, by that symbol: it stands alone on one side, and on the other, where the print does
/// not have it.
pub(super) fn is_circular(print: &Chain, altered: &Chain) -> bool {
    let ([_, _], [left, right]) = (print.sides.as_slice(), altered.sides.as_slice()) else { return false };
    let has = |side: &Node, symbol: &SymbolNode| {
        let mut nodes = Vec::new();
        walk(side, &mut nodes);
        nodes.iter().any(|n| matches!(&n.kind, NodeKind::Symbol(s) if is_same(s, symbol)))
    };
    [(left, right, 1), (right, left, 0)].into_iter().any(|(alone, other, at)| match &alone.kind {
        NodeKind::Symbol(symbol) if is_alone(alone) => {
            has(other, symbol) && !print.sides.get(at).is_some_and(|side| has(side, symbol))
        }
        _ => false,
    })
}

/// Whether two symbols are one, whatever their powers.
fn is_same(a: &SymbolNode, b: &SymbolNode) -> bool {
    let plain = |s: &SymbolNode| {
        let s = SymbolNode { sup: None, sup_first: false, ..s.clone() };
        without_places(&Node::new(NodeKind::Symbol(s), 0..0))
    };
    a.name == b.name && plain(a) == plain(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_leaves_out_more_often_than_it_puts_in() {
        use EditClass::{Dropped, Missing, Sign, Symbol};
        let in_order: [&[EditClass]; 6] =
            [&[Sign], &[Missing], &[Dropped], &[Sign, Symbol], &[Sign, Dropped], &[Dropped, Dropped]];
        assert!(in_order.is_sorted_by_key(|classes| edits_between(classes)));
        assert!(edits_between(&[Dropped]) < edits_between(&[Sign, Symbol]));
    }
}
