//! When what is given is known: the rules by which a fact of a file becomes one of a proof.
//!
//! **In:** equations, with the times and places that a claim chooses. **Out:** the same, each with when it is known (see
//! [`When`](proof::When)). **Guaranteed:** what is known *always* has values at all times.
//!
//! * *given*: what a claim assumes is known at the times that it chooses; what is about constants, always; what is typed, always.
//! * *needs*: what a claim says is said where it has a value. It is known always if it has one at all times, by its structure, by a system
//!   that needs the same, or by what is given; around each of its times, if that is an open condition (a divisor, a logarithm); at single
//!   times perhaps, if it may end there (a root).
//! * *rates*: where the formula of an observable has an edge, its rate need not exist, whether the formula is used or not.
//! * *discharge*: a need is met if its opposite contradicts what is given.

use super::definitions::Definitions;
use super::gather::{Gathered, sides};
use super::{LEFT_OUT_NODES, Pairs, Step, pairs};
use crate::derivation::Claim;
use crate::expr::domain::Sign;
use crate::expr::{Expr, FastMap, Leaf};
use crate::latex::{Relation, RelationKind, Scope};
use claim::comparison::{behind_rates, traced};
use proof::{Identity, Options, Premises, Reason, Wanted, When, is_never_negative};

impl Step<'_> {
    /// Restricts the equations from a number on to chosen times, if they move, and places, if they name fields; whether a point that
    /// satisfies them may refute.
    pub(super) fn restrict(&self, from: usize, [times, places]: [When; 2], premises: &mut Premises) -> bool {
        let graph = &self.graph;
        let of_fields = |pair: (Expr, Expr)| !graph.fields([pair.0, pair.1]).is_empty();
        let mut whole = true;
        for known in &mut premises.equations[from..] {
            let (l, r) = known.sides();
            let fields = of_fields((l, r));
            known.when = match (self.moves(l) || self.moves(r), fields) {
                (false, false) => When::Always,
                (true, false) => times,
                (false, true) => places,
                (true, true) => times.and(places),
            };
            // Along such places they may be meant to hold together: no point refutes that.
            whole &= known.when != When::Chosen;
        }
        whole
    }

    /// The places that a claim chooses, of all at which fields are meant.
    pub(super) fn places_chosen(&mut self, claim: &Claim, without: &[usize]) -> When {
        let used = claim.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        let relations: Vec<&Relation> = used.flat_map(|(_, w)| &w.value.relations).collect();
        let (mut chosen, mut placed) = (false, false);
        for relation in relations {
            let leaves = self.graph.leaves_within(pairs(relation).flat_map(|(l, r)| [l, r]));
            let names_fields = leaves.iter().any(|l| self.graph.is_field(l.symbol));
            let names_places = leaves.iter().any(|l| self.graph.coordinate(*l).is_some());
            match relation.kind {
                RelationKind::Equal => placed |= names_places && !names_fields,
                _ => chosen |= names_places || names_fields && self.inequalities != When::Always,
            }
        }
        match placed || self.may_choose_single_places(claim, without) {
            true => When::Chosen,
            false if chosen => When::ChosenOpen,
            false => When::Always,
        }
    }

    /// Whether something has a sign wherever what is given holds.
    pub(super) fn is_met(&mut self, value: Expr, sign: Sign, gathered: &Gathered) -> bool {
        if sign == Sign::NotNegative && is_never_negative(&self.graph, value) {
            return true;
        }
        let mut premises = gathered.premises.clone();
        let [zero, one] = [0, 1].map(|n| self.graph.integer(n));
        let opposite = self.graph.neg(value);
        match sign {
            Sign::NotZero => premises.give([(value, zero)], When::Chosen),
            Sign::Positive => premises.not_negative.push(opposite),
            Sign::NotNegative => premises.positive.push(opposite),
        }
        let used = self.in_part.len();
        self.definitions(&Pairs::new(), &[], Definitions::All, &mut premises);
        self.definitions_at_instants(&Pairs::new(), Definitions::All, &mut premises);
        self.in_part.truncate(used);
        self.add_positive_parameters(&Pairs::new(), &mut premises);
        let options = Options { attempts: 1, most_nodes: LEFT_OUT_NODES, wanted: Wanted::Fault, ..Options::default() };
        let found = self.test_only(&premises, &vec![(zero, one)], &options);
        matches!(found, Identity::Undecided(Reason::Contradiction))
    }

    /// What a claim says, and what is assumed, is said where it has a value: that may be at some times only, and single ones among them,
    /// if it ends there. What is typed is given of all times.
    pub(super) fn where_they_have_values(
        &mut self,
        premises: &mut Premises,
        assumed: usize,
        always: &mut [(&Scope, Pairs)],
        throughout: &Premises,
    ) {
        if self.inequalities == When::Always {
            return;
        }
        let scopes: Vec<&Scope> = always.iter().map(|(scope, _)| *scope).collect();
        let known = Gathered { throughout: throughout.clone(), ..Gathered::default() };
        let of_systems = self.sides_of_systems();
        let needed: Vec<Expr> = of_systems.into_iter().map(|e| traced(&mut self.graph, &self.claim.scope, e)).collect();
        let needed: Vec<(Expr, Sign)> = self.graph.needs_below(needed).iter().map(|n| (n.value, n.sign)).collect();
        let divided = self.divided_by_systems();
        let mut found: FastMap<(Expr, Sign), When> = FastMap::default();
        let mut of_pairs: Vec<((Expr, Expr), When)> = Vec::new();
        for at in 0..premises.equations.len() {
            let pair = premises.equations[at].sides();
            let mut when = When::Always;
            for mut e in [pair.0, pair.1] {
                for scope in scopes.iter().copied().chain([&self.claim.scope]) {
                    e = behind_rates(&mut self.graph, scope, e);
                    e = traced(&mut self.graph, scope, e);
                }
                for need in self.graph.needs_below([e]) {
                    let key = (need.value, need.sign);
                    let one = match found.get(&key) {
                        Some(&one) => one,
                        None => {
                            let squares = is_never_negative(&self.graph, need.value);
                            let met = !self.depends(need.value)
                                || needed.contains(&key)
                                || need.sign == Sign::NotZero && divided.contains(&need.value)
                                || need.sign == Sign::NotNegative && squares
                                || need.sign != Sign::NotNegative
                                    && self.never_vanishes(need.value, &known)
                                    && (squares || need.sign == Sign::NotZero)
                                || throughout.positive.contains(&need.value);
                            match (met, need.sign) {
                                (true, _) => When::Always,
                                (false, Sign::NotNegative) => When::Chosen,
                                (false, Sign::Positive | Sign::NotZero) => When::ChosenOpen,
                            }
                        }
                    };
                    found.insert(key, one);
                    when = when.and(one);
                }
            }
            premises.equations[at].when = premises.equations[at].when.and(when);
            if at < assumed {
                premises.present = premises.present.and(when);
            }
            of_pairs.push((pair, when));
        }
        for (_, list) in always {
            list.retain(|pair| of_pairs.iter().all(|(of, when)| of != pair || *when == When::Always));
        }
    }

    /// Where the formulas of the observables that occur have edges: their rates need not exist there, whether their definitions are used
    /// or not.
    pub(super) fn add_edges(&mut self, equations: &Pairs, premises: &mut Premises) {
        let facts = premises.nonzero.iter().chain(&premises.positive).chain(&premises.not_negative).copied();
        let roots: Vec<Expr> = sides(equations).chain(premises.sides()).chain(facts).collect();
        let mut symbols: Vec<Leaf> =
            self.graph.leaves_within(roots).into_iter().map(|l| Leaf::now(l.symbol, l.component)).collect();
        symbols.sort_unstable();
        symbols.dedup();
        for leaf in symbols {
            let Some(formula) = self.definition(leaf, Definitions::All) else { continue };
            if !self.edges.contains_key(&leaf) {
                let node = self.graph.leaf(leaf);
                let own = self.claim.scope.definition(leaf.symbol).is_some();
                let mut roots = if own { vec![node] } else { vec![formula] };
                self.add_definitions(&mut roots);
                let found = self.edges_below(roots);
                self.edges.insert(leaf, found);
            }
            for &edge in self.edges.get(&leaf).into_iter().flatten() {
                if !premises.edges.contains(&(leaf.symbol, edge)) {
                    premises.edges.push((leaf.symbol, edge));
                }
            }
        }
    }
}
