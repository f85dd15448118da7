//! What must be so of a motion that refutes a claim.
//!
//! **In:** a claim and what it is said to follow from. **Out:** [`Demand`]s: relations, with the times at which they must be true; and what
//! the claim says. `None` where something given is of a form that is not looked at here: then nothing is refuted.

use super::clock::{clock, read};
use super::scene::definition;
use crate::derivation::{Claim, Derivation, Form, Premise, Written};
use crate::expr::{Expr, FastMap, FastSet, Leaf, Symbol};
use crate::latex::{Relation, RelationKind, Role, Scope, Statement};
use crate::step::Step;
use proof::When;

/// Most formulas of which each names the next one.
const MOST_CHAINED: usize = 32;

/// Something that is said.
#[derive(Clone, Copy, Debug)]
pub(super) enum Said<'a> {
    Relation(&'a Relation),
    /// The same value at all times.
    Constant(Expr),
}

/// What must be so, and when.
#[derive(Clone, Debug)]
pub(super) struct Demand<'a> {
    pub(super) said: Said<'a>,
    /// By what the times are chosen at which it must be so: all where there is nothing.
    pub(super) chosen_by: Vec<&'a Relation>,
    /// Whether it must have a value at all of them.
    pub(super) asserted: bool,
    /// What it names, through the definitions.
    pub(super) names: FastSet<(Symbol, u16)>,
}

/// What a motion on which everything given holds is to show of the claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    /// That it is false.
    Fault,
    /// That it says something, and is true.
    Example,
}

/// The question of a step, as a search for a motion.
pub(super) struct Question<'a> {
    pub(super) wanted: Wanted,
    /// What plays the time.
    pub(super) clock: Option<Leaf>,
    pub(super) demands: Vec<Demand<'a>>,
    /// What the claim says: refuted where one of these is false.
    pub(super) claimed: Vec<Said<'a>>,
    /// What it says with one sign for the whole motion: refuted where one of these is false, for either sign.
    pub(super) signed: Vec<&'a Relation>,
    /// What that names, with what chooses the times.
    pub(super) claim_names: FastSet<(Symbol, u16)>,
    /// By what the times are chosen of which the claim speaks, and at which what is given speaks, too.
    pub(super) chosen_by: Vec<&'a Relation>,
    /// Everything that is named, in a fixed order.
    pub(super) names: Vec<Leaf>,
    /// The fixed times that are named.
    pub(super) instants: Vec<Expr>,
    /// The highest rate that is named.
    pub(super) order: u8,
    /// Numbers that are named.
    pub(super) numbers: Vec<i64>,
}

fn sides<'r>(relation: &'r Relation) -> impl Iterator<Item = Expr> + 'r {
    relation.left.components.iter().chain(&relation.right.components).copied()
}

impl<'a> Said<'a> {
    fn has_branches(&self) -> bool {
        matches!(self, Said::Relation(r) if r.has_branches)
    }

    pub(super) fn roots(&self) -> Vec<Expr> {
        match self {
            Said::Relation(r) => sides(r).collect(),
            Said::Constant(e) => vec![*e],
        }
    }
}

/// Gathers the demands.
struct Gathering<'a> {
    derivation: &'a Derivation,
    claim: &'a Claim,
    clock: Option<Leaf>,
    demands: Vec<Demand<'a>>,
    chosen_by: Vec<&'a Relation>,
}

impl<'a> Gathering<'a> {
    fn demand(&mut self, said: Said<'a>, chosen_by: &[&'a Relation], asserted: bool) {
        let mut roots = said.roots();
        roots.extend(chosen_by.iter().flat_map(|r| sides(r)));
        let names =
            names(self.derivation, &self.claim.scope, self.clock, roots).into_iter().map(|l| (l.symbol, l.component));
        self.demands.push(Demand { said, chosen_by: chosen_by.to_vec(), asserted, names: names.collect() });
    }

    /// What a claim assumes: selectors of times, and what must be so at these; `None` of limits and signs.
    fn assumed(&self, all: &'a [Written<Statement>], scope: &Scope) -> Option<(Vec<&'a Relation>, Vec<&'a Relation>)> {
        let graph = &self.derivation.graph;
        let moves = |l: Leaf| read(graph, l).instant.is_none() && scope.role(l.symbol) != Some(Role::Parameter);
        let (mut selecting, mut others) = (Vec::new(), Vec::new());
        for relation in all.iter().flat_map(|w| &w.value.relations) {
            if relation.limit.is_some() || relation.has_branches {
                return None;
            }
            let leaves = graph.leaves_within(sides(relation));
            let is_coordinate = |l: &Leaf| graph.coordinate(*l).is_some();
            // Such an equation chooses places.
            let chooses = relation.kind == RelationKind::Equal && !leaves.iter().any(|l| graph.is_field(l.symbol));
            if chooses && leaves.iter().any(is_coordinate) {
                return None;
            }
            let moving = leaves.into_iter().any(moves);
            match relation.kind != RelationKind::Equal && moving {
                true => selecting.push(relation),
                false => others.push(relation),
            }
        }
        Some((selecting, others))
    }

    /// What a claim says, perhaps with ±; `None` of other forms than relations at all times, first integrals and systems.
    fn said(&self, claim: &'a Claim) -> Option<Vec<(Said<'a>, bool)>> {
        if claim.at.is_some() || claim.region.is_some() && !claim.is_of_fields() {
            return None;
        }
        let mut out = Vec::new();
        for form in &claim.forms {
            match form {
                Form::Always(w) => {
                    if w.value.relations.iter().any(|r| r.limit.is_some()) {
                        return None;
                    }
                    out.extend(w.value.relations.iter().map(|r| (Said::Relation(r), false)));
                }
                Form::FirstIntegral(w) => out.extend(w.value.components.iter().map(|&e| (Said::Constant(e), false))),
                Form::Solves { system } => out.extend(self.system(*system).map(|said| (said, true))),
                Form::Never(_) | Form::Eventually(_) | Form::Defined(_) | Form::SameMotion { .. } => return None,
                Form::Independent { .. } | Form::Exists { .. } | Form::Across(_) | Form::Unread { .. } => return None,
            }
        }
        Some(out)
    }

    fn system(&self, system: usize) -> impl Iterator<Item = Said<'a>> + use<'a> {
        let equations = &self.derivation.systems[system].equations;
        equations.iter().flat_map(|w| &w.value.relations).map(Said::Relation)
    }

    fn premise(&mut self, claim: &'a Claim) -> Option<()> {
        let (selecting, others) = self.assumed(&claim.assuming, &claim.scope)?;
        for (said, asserted) in self.said(claim)? {
            if said.has_branches() {
                return None;
            }
            self.demand(said, &selecting, asserted);
        }
        // What it assumes is taken to be so: then what it says is.
        for relation in others {
            self.demand(Said::Relation(relation), &selecting, false);
        }
        self.chosen_by.extend(selecting);
        Some(())
    }
}

/// What formulas name, through the definitions, present values of components only.
fn names(derivation: &Derivation, scope: &Scope, clock: Option<Leaf>, roots: Vec<Expr>) -> Vec<Leaf> {
    let graph = &derivation.graph;
    let mut out: Vec<Leaf> = Vec::new();
    let mut open = roots;
    while !open.is_empty() {
        let mut next = Vec::new();
        for leaf in graph.leaves_within(open).into_iter().map(|l| read(graph, l)) {
            next.extend(leaf.instant);
            let now = Leaf::now(leaf.symbol, leaf.component);
            if out.contains(&now) || Some(now) == clock || scope.branch_sign() == now {
                continue;
            }
            out.push(now);
            next.extend(definition(derivation, scope, now));
        }
        open = next;
    }
    out
}

/// The highest rate of what has no formula, where the formulas of the rest are written out: each may name the rate of another one. `None` where
/// too many do.
fn order(derivation: &Derivation, scope: &Scope, names: &[Leaf], leaves: &[Leaf]) -> Option<u8> {
    let graph = &derivation.graph;
    let of = |l: &Leaf| (l.symbol, l.component);
    let mut orders: FastMap<(Symbol, u16), u8> = FastMap::default();
    let highest = |orders: &FastMap<(Symbol, u16), u8>, leaves: &[Leaf]| {
        let one = |l: &Leaf| l.rate.saturating_add(orders.get(&of(l)).copied().unwrap_or(0));
        leaves.iter().map(one).max().unwrap_or(0)
    };
    let formulas = names.iter().filter_map(|name| Some((of(name), definition(derivation, scope, *name)?)));
    let formulas: Vec<((Symbol, u16), Vec<Leaf>)> = formulas
        .map(|(name, e)| (name, graph.leaves_within([e]).into_iter().map(|l| read(graph, l)).collect()))
        .collect();
    for _ in 0..MOST_CHAINED {
        let before = orders.clone();
        for (name, leaves) in &formulas {
            orders.insert(*name, highest(&orders, leaves));
        }
        if orders == before {
            return Some(highest(&orders, leaves));
        }
    }
    None
}

/// What the relations of a claim name, and those that it assumes.
fn named(derivation: &Derivation, claim: &Claim) -> Vec<Leaf> {
    let assumed = claim.assuming.iter().flat_map(|w| &w.value.relations);
    derivation.graph.leaves_within(claim.stated().chain(assumed).flat_map(sides))
}

/// What a claim asks of a motion that refutes it; `inequalities`: when those that are assumed hold; where that is not always, they choose the times.
pub(super) fn question<'a>(
    derivation: &'a Derivation,
    claim: &'a Claim,
    inequalities: When,
    wanted: Wanted,
) -> Option<Question<'a>> {
    // Motions of several systems obey more than is given.
    if Step::lacks_systems(derivation, claim) {
        return None;
    }
    let clock = clock(derivation, &claim.scope, &named(derivation, claim))?;
    let mut all = Gathering { derivation, claim, clock, demands: Vec::new(), chosen_by: Vec::new() };
    let (selecting, others) = all.assumed(&claim.assuming, &claim.scope)?;
    if inequalities == When::Always {
        for relation in selecting.into_iter().chain(others) {
            all.demand(Said::Relation(relation), &[], false);
        }
    } else {
        for relation in others {
            all.demand(Said::Relation(relation), &selecting, false);
        }
        all.chosen_by = selecting;
    }
    for name in Step::given(derivation, claim) {
        match derivation.premise(&name) {
            Premise::System(system) => {
                for said in all.system(system) {
                    all.demand(said, &[], true);
                }
            }
            Premise::Claim(at) => all.premise(&derivation.claims[at])?,
            Premise::Definition => {}
        }
    }
    let claimed: Vec<Said> = all.said(claim)?.into_iter().map(|(said, _)| said).collect();
    if claimed.iter().any(Said::has_branches) && !claim.branches_throughout {
        return None;
    }
    let mut roots: Vec<Expr> =
        claimed.iter().chain(all.demands.iter().map(|d| &d.said)).flat_map(Said::roots).collect();
    roots.extend(all.chosen_by.iter().flat_map(|r| sides(r)));
    let mut of_claim: Vec<Expr> = claimed.iter().flat_map(Said::roots).collect();
    of_claim.extend(all.chosen_by.iter().flat_map(|r| sides(r)));
    let claim_names =
        names(derivation, &claim.scope, clock, of_claim).into_iter().map(|l| (l.symbol, l.component)).collect();
    let names = names(derivation, &claim.scope, clock, roots.clone());
    roots.extend(names.iter().filter_map(|l| definition(derivation, &claim.scope, *l)));
    let graph = &derivation.graph;
    let leaves: Vec<Leaf> = graph.leaves_within(roots.iter().copied()).into_iter().map(|l| read(graph, l)).collect();
    let mut instants: Vec<Expr> = leaves.iter().filter_map(|l| l.instant).collect();
    instants.sort_unstable();
    instants.dedup();
    let order = order(derivation, &claim.scope, &names, &leaves)?;
    let nodes = graph.reachable(roots);
    let number = |e: Expr| graph.as_constant(e).filter(|r| r.denominator().is_one());
    let mut numbers: Vec<i64> = nodes.into_iter().filter_map(|e| i64::try_from(number(e)?.numerator()).ok()).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let Gathering { demands, chosen_by, .. } = all;
    let signed = claimed.iter().filter_map(|said| match said {
        Said::Relation(relation) if relation.has_branches => Some(*relation),
        Said::Relation(_) | Said::Constant(_) => None,
    });
    let signed = signed.collect();
    let claimed = claimed.into_iter().filter(|said| !said.has_branches()).collect();
    Some(Question { wanted, clock, demands, claimed, signed, claim_names, chosen_by, names, instants, order, numbers })
}
