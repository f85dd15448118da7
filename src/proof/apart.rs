//! Several equations at once: what they say where not all of them have values.
//!
//! **In:** equations. **Out:** them in groups that have values at the same points, so far as what is given does not settle that.
//!
//! A conjunction is false where a part of it is false, whether the others have values there or not (`docs/semantics.md`).
//! Equations that are tested together are tested where all of them have values: the domain of one would hide that another
//! fails beyond it. So every group is tested by itself as well.

use std::collections::BTreeMap;

use super::conditions::domains;
use super::generators::Generators;
use super::outcome::{Condition, Premises};
use super::sign::Facts;
use expr::{Expr, FastSet, Graph};

/// The conditions under which expressions have values, without those that signs which are given settle.
pub(super) fn undeclared(graph: &mut Graph, exprs: &[Expr], given: &Premises) -> Vec<Condition> {
    let mut own = domains(graph, exprs);
    if own.is_empty() {
        return own;
    }
    let generators = Generators::new(graph);
    let mut facts = Facts::default();
    given.positive.iter().for_each(|&e| facts.note_positive(graph, e));
    given.not_negative.iter().for_each(|&e| facts.note_not_negative(graph, e));
    facts.nonzero.extend(given.nonzero.iter().copied());
    own.retain(|&condition| {
        let e = condition.subject();
        let sign = facts.sign(graph, &generators, e);
        let declared = match condition {
            Condition::Denominator(_) | Condition::Pivot(_) | Condition::Rate(_) => sign.nonzero,
            Condition::Radicand(_) | Condition::Discriminant(_) => sign.not_negative,
            Condition::Positive(_) => sign.not_negative && sign.nonzero,
            Condition::Unit(_) => false,
        };
        !declared && !graph.leaves([e]).is_empty()
    });
    own
}

/// The numbers of the equations, those together that have values under the same conditions.
pub fn by_domain(graph: &mut Graph, equations: &[(Expr, Expr)], given: &Premises) -> Vec<Vec<usize>> {
    let all: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
    // What the premises ask for is asked of all.
    let premises: Vec<Expr> = given.sides().collect();
    let presupposed: FastSet<Condition> = domains(graph, &premises).into_iter().collect();
    let of = |graph: &mut Graph, exprs: &[Expr]| {
        let mut own = undeclared(graph, exprs, given);
        own.retain(|condition| !presupposed.contains(condition));
        own.sort_unstable();
        own.dedup();
        own
    };
    if equations.len() < 2 || of(graph, &all).is_empty() {
        return vec![(0..equations.len()).collect()];
    }
    let mut groups: BTreeMap<Vec<Condition>, Vec<usize>> = BTreeMap::new();
    for (number, &(l, r)) in equations.iter().enumerate() {
        groups.entry(of(graph, &[l, r])).or_default().push(number);
    }
    let mut groups: Vec<Vec<usize>> = groups.into_values().collect();
    groups.sort_unstable();
    groups
}
