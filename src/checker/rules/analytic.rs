//! Smooth, analytic, continue: what a system makes of its solutions.
//!
//! **Smooth.** *Theorem.* If the highest rate that x is declared to have, x⁽ᵏ⁾, is r at all times of T, and r is continuously differentiable, x has a continuous rate
//! k + 1. *Proof.* x⁽ᵏ⁾ is the same function as r. □ *Conditions.* The fact needs nothing; r touches no edge at any time; the symbols in r have one rate more than stands in it.
//!
//! **Analytic.** *Theorem.* If x₁, …, xₙ satisfy xᵢ^{(kᵢ)} = fᵢ at all times of T, where fᵢ is analytic at the values and names no symbols that move but lower rates of these and the time, all xᵢ are
//! analytic on T. *Proof.* At each time the solution of the initial value problem is unique, and analytic (Cauchy; one-sided at an end of T: it continues beyond). □
//!
//! **Continue.** *Theorem.* If l = r on S₀, which is open in T, l and r are analytic on T, and S₀ has a time in it, l = r on T. *Proof.* S₀ contains an interval; an
//! analytic function on the connected T that is 0 on an interval is 0. □
//!
//! **Traps.** Functions that are only smooth agree on an interval and part (S5, S6: e^{−1/t}). A right side with |x| is no ground where x may be 0. A symbol that no equation leads is free.

use super::made;
use crate::derivative::derivative;
use crate::draft::{Draft, Made};
use crate::needs::{needs, smooth as smoothness};
use crate::sequent::SymbolKind;
use crate::step::FactId;
use crate::when::When;
use expr::{Expr, Leaf, Node, Symbol};
use std::collections::BTreeSet;

/// A fact x⁽ᵏ⁾ = r that is known at all times and needs nothing.
fn leading(draft: &Draft, id: FactId) -> Result<(Leaf, Expr), String> {
    draft.context.is_of_times()?;
    let fact = draft.equation(id).and_then(|_| draft.known_at(id, &When::Always))?;
    match *draft.context.graph.node(fact.says.left) {
        Node::Leaf(leaf) if leaf.instant.is_none() && fact.needs.is_empty() => match draft.context.kind(leaf) {
            SymbolKind::Moves(_) => Ok((leaf, fact.says.right)),
            SymbolKind::Time
            | SymbolKind::Constant(_)
            | SymbolKind::Coordinate
            | SymbolKind::Field(_)
            | SymbolKind::Defined => Err("no rate is on the left".to_owned()),
        },
        _ => Err("no rate is on the left, or the fact needs something".to_owned()),
    }
}

pub(super) fn smooth(draft: &mut Draft, id: FactId, because: &[FactId]) -> Result<(), String> {
    let (leaf, right) = leading(draft, id)?;
    if draft.context.kind(leaf) != SymbolKind::Moves(leaf.rate) || draft.context.graph.component_count(leaf.symbol) > 1
    {
        return Err("the rate is not the highest of a symbol with one component".to_owned());
    }
    let d = derivative(&mut draft.context, right)?;
    let mut asked = smoothness(&mut draft.context, right);
    asked.extend(needs(&mut draft.context, d));
    draft.all_shown(asked, because, &When::Always)?;
    draft.context.add_order(leaf.symbol);
    Ok(())
}

pub(super) fn analytic(draft: &mut Draft, equations: &[FactId], because: &[FactId]) -> Result<(), String> {
    let mut led: Vec<(Leaf, Expr)> = Vec::new();
    for id in equations {
        let (leaf, right) = leading(draft, *id)?;
        if led.iter().any(|(l, _)| (l.symbol, l.component) == (leaf.symbol, leaf.component)) {
            return Err("two equations lead one symbol".to_owned());
        }
        led.push((leaf, right));
    }
    let is_lower = |leaf: Leaf| {
        led.iter().any(|(l, _)| (l.symbol, l.component) == (leaf.symbol, leaf.component) && leaf.rate < l.rate)
    };
    for &(_, right) in &led {
        for leaf in draft.context.graph.leaves([right]) {
            let still = !draft.context.leaf_moves(leaf) || draft.context.kind(leaf) == SymbolKind::Time;
            if !still && !is_lower(leaf) {
                return Err(format!("no equation leads `{}`", draft.context.graph.leaf_latex(leaf)));
            }
        }
        let asked = smoothness(&mut draft.context, right);
        draft.all_shown(asked, because, &When::Always)?;
    }
    let symbols: BTreeSet<Symbol> = led.iter().map(|(leaf, _)| leaf.symbol).collect();
    for symbol in symbols {
        let components = draft.context.graph.component_count(symbol);
        if led.iter().filter(|(leaf, _)| leaf.symbol == symbol).count() == components {
            draft.analytic.insert(symbol);
        }
    }
    Ok(())
}

/// An equation at all times.
pub(super) fn extend(draft: &mut Draft, id: FactId, because: &[FactId]) -> Result<Made, String> {
    let fact = draft.equation(id).and_then(|_| draft.known_at(id, &When::ChosenOpen))?;
    if !draft.opened || !fact.needs.is_empty() || fact.when.is_in_case() {
        return Err("the equation is not known on an open set of times, or needs something there".to_owned());
    }
    for side in fact.says.sides() {
        for leaf in draft.context.graph.leaves([side]) {
            let still = !draft.context.leaf_moves(leaf) || draft.context.kind(leaf) == SymbolKind::Time;
            if !still && !draft.analytic.contains(&leaf.symbol) {
                return Err(format!("`{}` is not known to be analytic", draft.context.graph.leaf_latex(leaf)));
            }
        }
        let asked = smoothness(&mut draft.context, side);
        draft.all_shown(asked, because, &When::Always)?;
    }
    Ok(made("continuation", [&[id], because].concat(), fact.says, When::Always, Default::default()))
}
