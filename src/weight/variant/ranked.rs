//! Which of the altered formulas that pass at a few points are worth a trial, and in which order.
//!
//! **In:** trees that no point refutes. **Out:** [`Candidate`]s, the closest to the print first: none that says nothing, says what
//! another says, or says what a symbol is by that symbol, and none whose units disagree where those of the print agree.

use super::difference::difference;
use super::equivalence::Sight;
use super::generate::{ClaimVariants, Formula, Manner, Setting, Source, Variant};
use super::nearness::{Nearness, edits_between, is_circular};
use super::tree::cancelled;
use super::vocabulary::Vocabulary;
use crate::derivation::Derivation;
use crate::expr::{Expr, Graph};
use crate::findings::EditClass;
use crate::latex::Role;
use crate::latex::syntax::{Chain, to_latex};

/// Most candidates of one formula that are handed to the checker.
const MOST_CANDIDATES: usize = 12;

/// A formula that may be what was meant.
#[derive(Clone)]
pub(super) struct Candidate {
    pub claim: usize,
    pub formula: usize,
    pub tree: Chain,
    pub text: String,
    pub classes: Vec<EditClass>,
    pub difference: String,
    pub nearness: Nearness,
}

impl Candidate {
    /// An equation that says the rate of the quantity of a formula: no edit of it.
    pub fn of_rate((claim, formula): (usize, usize), tree: Chain) -> Candidate {
        let text = to_latex(&tree);
        let (classes, difference, nearness) = (Vec::new(), String::new(), Nearness::default());
        Candidate { claim, formula, tree, text, classes, difference, nearness }
    }
}

/// An altered formula, with the edits that lead to it.
pub(super) type Made = (Vec<EditClass>, Chain);

/// Candidates, the closest to the print first, without those that say nothing or what another says.
pub(super) fn ranked(
    derivation: &Derivation,
    (k, f): (usize, usize),
    graph: &mut Graph,
    setting: &Setting,
    formula: &Formula,
    vocabulary: &Vocabulary,
    made: Vec<Made>,
) -> Vec<Candidate> {
    let print = to_latex(&formula.tree);
    let mut group = ClaimVariants { formulas: vec![formula.clone()], ..ClaimVariants::default() };
    let mut kept = Vec::new();
    for (classes, tree) in made {
        // What is multiplied and divided again was never there; an addition that only undoes what is printed is none, and a
        // symbol that makes a term vanish leaves it out.
        let plain = Chain { sides: tree.sides.iter().map(cancelled).collect(), ..tree.clone() };
        let classes = match classes.as_slice() {
            [EditClass::Missing] if plain != tree => continue,
            [_] if plain != tree => vec![EditClass::Dropped],
            _ => classes,
        };
        let tree = plain;
        if is_circular(&formula.tree, &tree) {
            continue;
        }
        let Some(altered) = setting.altered(graph, formula, &tree).filter(|a| !a.is_empty()) else { continue };
        // Both sides are one expression, or nothing is left that could be compared.
        let says_nothing = altered
            .iter()
            .all(|(_, p)| p.sides.0 == p.sides.1 || graph.leaves(p.difference.iter().copied()).is_empty());
        if says_nothing && altered.len() == formula.parts.len() {
            continue;
        }
        let (difference, changed) = difference(&print, &to_latex(&tree));
        let class = classes.first().copied().unwrap_or(EditClass::Missing);
        let variant = Variant { class, formula: 0, source: Source::Tree(Box::new(tree)), altered };
        kept.push((variant, classes, difference, changed));
    }
    let nearness = Nearness::of_all(derivation, setting.claim, graph, formula, vocabulary, &kept);
    // What adds joules to kilograms is no correction of what did not.
    let as_printed: Vec<_> = formula.parts.iter().map(|p| (p.sides.0, Some(p.sides.1))).collect();
    let odd = units::inconsistent(derivation, graph, &[as_printed]).contains(&true);
    let mut kept: Vec<_> = kept.into_iter().zip(nearness).filter(|(_, n)| odd || !n.inconsistent).collect();
    kept.sort_by(|a, b| a.1.cmp(&b.1));
    let mut rest = Vec::new();
    for ((variant, classes, difference, _), nearness) in kept {
        group.variants.push(variant);
        rest.push((classes, difference, nearness));
    }
    let sights = group.sights(derivation, setting.claim, graph, true);
    let by_algebra = group.sights(derivation, setting.claim, graph, false);
    let sights = sights.into_iter().zip(by_algebra);
    // What is made of parameters alone can only be true by algebra.
    let scope = &setting.claim.scope;
    let residuals: Vec<Expr> = formula.parts.iter().flat_map(|p| p.difference.iter().copied()).collect();
    let leaves = graph.leaves(residuals);
    let moves = leaves.iter().any(|l| l.instant.is_none() && scope.role(l.symbol) != Some(Role::Parameter));
    let mut out: Vec<Candidate> = Vec::new();
    for ((variant, (sight, alone)), (classes, difference, mut nearness)) in
        std::mem::take(&mut group.variants).into_iter().zip(sights).zip(rest)
    {
        if matches!(sight, Sight::Same | Sight::Repeated(_) | Sight::Said) {
            continue;
        }
        // What does not move anyway says nothing by being constant, and what was added only to make both sides one
        // expression says nothing either.
        let trivial = sight == Sight::Empty && formula.manner == Manner::Constant;
        let made_up = moves && alone == Sight::Empty && edits_between(&classes) > edits_between(&[EditClass::Sign]);
        if trivial || made_up {
            continue;
        }
        let tree = variant.tree(&group.formulas);
        let text = to_latex(&tree);
        nearness.empty = sight == Sight::Empty;
        out.push(Candidate { claim: k, formula: f, tree, text, classes, difference, nearness });
    }
    out.sort_by(|a, b| a.nearness.cmp(&b.nearness));
    out.truncate(MOST_CANDIDATES);
    out
}
