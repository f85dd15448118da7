//! What rates of given equations need to have values.
//!
//! **In:** what is asked, and what is given with its derivatives. **Out:** which derivatives may have no value, and what must not vanish so
//! that they have. **Guaranteed:** a derivative that is not marked has a value wherever the claim and what is given have one.
//!
//! √x has a value at x = 0 and its rate ẋ/(2√x) has none: so at a time at which x is 0 nothing follows from the rate of an equation that
//! names √x, and a motion may stay there. The same is true of a symbol that stands for √x, whether its formula is used or not: see
//! [`Premises::edges`](super::Premises::edges).

use super::generators::Generators;
use super::outcome::{Condition, Premises};
use super::polynomial::factors;
use super::prepare::Premise;
use super::restate::restated;
use super::sign::Facts;
use expr::domain::Sign;
use expr::{Expr, FastMap, FastSet, Graph, Leaf, Node};

/// What else is not 0 where a fact holds: the factors of what is not.
fn note_nonzero(graph: &mut Graph, facts: &mut Facts, e: Expr) {
    facts.nonzero.insert(e);
    let bases: Vec<Expr> = factors(graph, e).1.into_iter().map(|(base, _)| base).collect();
    facts.nonzero.extend(bases);
}

/// Marks the derivatives among the premises that may have no value; what must not vanish so that they have.
pub(super) fn mark_partial(
    graph: &mut Graph,
    claim: &[(Expr, Expr)],
    premises: &mut [Premise],
    given: &Premises,
) -> Vec<Expr> {
    if !premises.iter().any(|p| p.derived) {
        return Vec::new();
    }
    let own: Vec<Expr> = premises.iter().filter(|p| !p.derived).flat_map(|p| [p.left, p.right]).collect();
    let own: Vec<Expr> = own.into_iter().chain(claim.iter().flat_map(|&(l, r)| [l, r])).collect();
    let generators = Generators::new(graph);
    let mut facts = Facts::default();
    given.positive.iter().for_each(|&e| facts.note_positive(graph, e));
    given.not_negative.iter().for_each(|&e| facts.note_not_negative(graph, e));
    given.nonzero.iter().for_each(|&e| note_nonzero(graph, &mut facts, e));
    let mut known_nonzero: Vec<Expr> = given.nonzero.iter().chain(&given.positive).copied().collect();
    for need in graph.implied_below(own.iter().copied()) {
        match need.sign {
            Sign::Positive => facts.note_positive(graph, need.value),
            Sign::NotNegative => facts.note_not_negative(graph, need.value),
            Sign::NotZero => note_nonzero(graph, &mut facts, need.value),
        }
        if need.sign != Sign::NotNegative {
            known_nonzero.push(need.value);
        }
    }
    let known: Vec<Leaf> = graph.leaves_within(own);
    // A rate that is named has a value: then the function does not leap there.
    for premise in premises.iter().filter(|p| p.derived) {
        let named = [premise.left, premise.right].into_iter().any(|e| match graph.node(e) {
            Node::Leaf(leaf) => leaf.rate > 0 && known.contains(leaf),
            Node::Constant(_) | Node::Pi | Node::Unary(..) | Node::Binary(..) => false,
        });
        if named {
            let [l, r] = [premise.left, premise.right].map(|e| graph.unrestricted(e));
            let of_formula: FastSet<Expr> = graph.needs_below([l, r]).into_iter().map(|n| n.value).collect();
            let beside = graph.needs_below([premise.left, premise.right]);
            for need in beside.into_iter().filter(|n| n.sign == Sign::NotZero && !of_formula.contains(&n.value)) {
                known_nonzero.push(need.value);
            }
        }
    }
    // What a symbol stands for is not 0 where the symbol is not; and all of it in the form in which needs are told.
    let definitions: Vec<(Expr, Expr)> = premises.iter().filter(|p| !p.derived).map(|p| (p.left, p.right)).collect();
    let mut at = 0;
    while let Some(&e) = known_nonzero.get(at) {
        at += 1;
        let told = restated(graph, &generators, &Facts::default(), Condition::Rate(e));
        for base in told.into_iter().map(Condition::subject).chain([e]) {
            let base = graph.root_of_zeros(base);
            note_nonzero(graph, &mut facts, base);
            let same = definitions.iter().flat_map(|&(l, r)| [(l, r), (r, l)]).filter(|&(l, _)| l == base);
            let new: Vec<Expr> = same.map(|(_, other)| other).filter(|other| !known_nonzero.contains(other)).collect();
            known_nonzero.extend(new);
        }
    }
    let mut out: Vec<Expr> = Vec::new();
    let mut open_of: FastMap<Expr, Vec<Expr>> = FastMap::default();
    for premise in premises.iter_mut().filter(|p| p.derived) {
        let sides = [premise.left, premise.right];
        let mut values: Vec<Expr> = Vec::new();
        for need in graph.needs_below(sides) {
            match need.sign {
                Sign::NotZero | Sign::Positive => values.push(need.value),
                // The function needs it, too.
                Sign::NotNegative => {}
            }
        }
        values.extend(edges_of_rates(graph, sides, given, &known));
        let mut partial = false;
        for value in values {
            let open = match open_of.get(&value) {
                Some(open) => open.clone(),
                None => {
                    let all = restated(graph, &generators, &facts, Condition::Rate(value));
                    let open: Vec<Expr> = all.into_iter().map(Condition::subject).collect();
                    open_of.insert(value, open.clone());
                    open
                }
            };
            for e in open {
                if graph.leaves([e]).is_empty() && graph.as_constant(e).is_none_or(|r| !r.is_zero()) {
                    continue;
                }
                partial = true;
                if !out.contains(&e) {
                    out.push(e);
                }
            }
        }
        premise.partial = partial;
    }
    out
}

/// Where the formulas of what is named with a rate have edges, unless that rate is named by what is known to have a value.
fn edges_of_rates(graph: &mut Graph, sides: [Expr; 2], given: &Premises, known: &[Leaf]) -> Vec<Expr> {
    if given.edges.is_empty() {
        return Vec::new();
    }
    let has_rate = |l: &Leaf| {
        let same = |k: &&Leaf| (k.symbol, k.component, k.instant) == (l.symbol, l.component, l.instant);
        known.iter().filter(same).any(|k| k.rate >= l.rate)
    };
    let mut seen: FastSet<Expr> = FastSet::default();
    let mut out = Vec::new();
    for leaf in graph.leaves_within(sides).into_iter().filter(|l| l.rate > 0 && !has_rate(l)) {
        for &(_, edge) in given.edges.iter().filter(|(symbol, _)| *symbol == leaf.symbol) {
            let there = match leaf.instant {
                None => edge,
                Some(instant) => graph.substitute(edge, |graph, l| match l {
                    l if given.time == Some(l) => Some(instant),
                    l if l.instant.is_none() && given.moving.contains(&l.symbol) => {
                        Some(graph.leaf(Leaf { instant: Some(instant), ..l }))
                    }
                    _ => None,
                }),
            };
            if seen.insert(there) {
                out.push(there);
            }
        }
    }
    out
}
