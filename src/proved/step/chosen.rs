//! The times, and places, that a claim chooses by what it assumes: what is known there, and what goes on beyond.
//!
//! **In:** what a claim and its premises assume. **Out:** which of it is known at all times, which for a while, and which at single times
//! only. A claim says nothing of times that it does not choose; so what is assumed there may be used of others only if it goes on: it is
//! about constants, or what chooses is strict and the motions are analytic.

use super::gather::{Gathered, sides};
use super::valued::Valued;
use super::{Pairs, Step, pairs};
use crate::derivation::{Claim, Form, Written};
use crate::expr::domain::{Change, EdgeOf, Need, Sign};
use crate::expr::{Expr, Graph, Leaf, Node};
use crate::latex::{Relation, RelationKind, Scope, Statement};
use claim::comparison::{at_instant, may_leap, presupposed, traced};
use proof::{Premises, When, is_never_negative};

impl<'a> Step<'a> {
    /// The relations that a claim assumes, but those with the given numbers, by which times are chosen: what is so at all times chooses none.
    pub(super) fn choosing<'c>(&mut self, claim: &'c Claim, without: &[usize]) -> Vec<&'c Relation> {
        let used = claim.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        let apart = |r: &&Relation| r.kind == RelationKind::NotEqual && pairs(r).all(|pair| self.apart.contains(&pair));
        let relations = used.flat_map(|(_, w)| &w.value.relations).filter(|r| !apart(r));
        let choosing: Vec<&Relation> = relations.filter(|r| chooses(&self.graph, &claim.scope, r)).collect();
        choosing.into_iter().filter(|r| !self.is_always_so(&claim.scope, r)).collect()
    }

    /// Whether a relation is so for all values, and has a value for all: that squares are not negative.
    fn is_always_so(&mut self, scope: &Scope, relation: &Relation) -> bool {
        let (more, less) = match relation.kind {
            RelationKind::GreaterEqual => (&relation.left, &relation.right),
            RelationKind::LessEqual => (&relation.right, &relation.left),
            RelationKind::Equal | RelationKind::NotEqual | RelationKind::Less | RelationKind::Greater => return false,
        };
        let mut sides = more.components.iter().zip(&less.components);
        let so = sides.all(|(&more, &less)| self.graph.is_zero(less) && is_never_negative(&self.graph, more));
        let traced: Vec<Expr> = more.components.iter().map(|&e| traced(&mut self.graph, scope, e)).collect();
        so && self.graph.needs_below(traced).is_empty()
    }

    /// What the claim assumes to differ at the times that it chooses, and for a while around these.
    pub(super) fn chosen_apart(&mut self) -> Pairs {
        let claim = self.claim;
        let mut out = Pairs::new();
        for relation in self.choosing(claim, &[]) {
            let scalar = relation.kind == RelationKind::NotEqual && relation.left.components.len() == 1;
            if scalar && !relation.has_branches && self.holds_for_a_while(&claim.scope, relation) {
                out.extend(pairs(relation));
            }
        }
        out
    }

    /// Whether a relation that chooses times holds around each time at which it holds: it is strict, between sides that are continuous,
    /// and have values around each time at which they have one.
    fn holds_for_a_while(&mut self, scope: &Scope, relation: &Relation) -> bool {
        if matches!(relation.kind, RelationKind::Equal | RelationKind::GreaterEqual | RelationKind::LessEqual) {
            return false;
        }
        let sides: Vec<Expr> = relation.left.components.iter().chain(&relation.right.components).copied().collect();
        let sides: Vec<Expr> = sides.into_iter().map(|e| traced(&mut self.graph, scope, e)).collect();
        let needs = self.graph.needs_below(sides.clone());
        let nodes = self.graph.reachable(sides);
        // At a jump a function has the value from where the term is positive.
        let jumps = |edge: &EdgeOf| matches!(edge.change, Change::Jump(_));
        let jumping: Vec<EdgeOf> = nodes.into_iter().flat_map(|e| self.graph.edges(e)).filter(jumps).collect();
        let has_jumps = jumping.iter().any(|edge| !edge.vanishing.is_some_and(|e| is_never_negative(&self.graph, e)));
        let ends = |need: Need| {
            need.sign == Sign::NotNegative && self.depends(need.value) && !is_never_negative(&self.graph, need.value)
        };
        !has_jumps && !needs.into_iter().any(ends)
    }

    /// The times that a claim chooses.
    pub(super) fn times_chosen(&mut self, of: &Claim, without: &[usize]) -> When {
        match self.may_choose_single_times(of, without) {
            true => When::Chosen,
            false if self.inequalities == When::Always || self.choosing(of, without).is_empty() => When::Always,
            false => When::ChosenOpen,
        }
    }

    /// Whether something changes along a motion, or from place to place.
    pub(super) fn depends(&self, e: Expr) -> bool {
        let place = |l: &Leaf| self.graph.coordinate(*l).is_some() || self.graph.is_field(l.symbol);
        self.moves(e) || self.graph.leaves([e]).iter().any(place)
    }

    /// Whether single times may be all that a claim chooses: nothing is known of rates then.
    pub(super) fn may_choose_single_times(&mut self, of: &Claim, without: &[usize]) -> bool {
        let mut choosing = self.choosing(of, without);
        // What is assumed of all times may leave single ones, if it is about the time itself.
        let names_time = |r: &&Relation| {
            let leaves = self.graph.leaves_within(pairs(r).flat_map(|(l, r)| [l, r]));
            leaves.iter().any(|l| Some(*l) == of.scope.time())
        };
        choosing.retain(|r| self.inequalities != When::Always || names_time(r));
        !choosing.into_iter().all(|r| self.holds_for_a_while(&of.scope, r))
    }

    /// Whether a relation that a claim assumes may leave single places: nothing is known of derivatives there.
    pub(super) fn may_choose_single_places(&mut self, of: &Claim, without: &[usize]) -> bool {
        let used = of.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        used.flat_map(|(_, w)| &w.value.relations).any(|r| {
            let sides = r.left.components.iter().chain(&r.right.components).copied();
            let leaves = self.graph.leaves(sides);
            let of_places = leaves.iter().any(|l| self.graph.coordinate(*l).is_some() || self.graph.is_field(l.symbol));
            of_places && r.kind != RelationKind::Equal && !self.holds_for_a_while(&of.scope, r)
        })
    }

    /// Whether what is so at the times that a claim chooses goes on at all others: none is left out; or it is so for a while, and motions
    /// are analytic.
    pub(super) fn goes_on(&mut self, of: &Claim, without: &[usize]) -> bool {
        let everywhere = self.inequalities == When::Always || self.choosing(of, without).is_empty();
        everywhere || !self.may_choose_single_times(of, without) && self.motions_are_analytic(of)
    }

    /// Whether motions are analytic in everything that two claims name: the systems that are given determine it, by right sides that are
    /// analytic wherever the states have values. Where none is given, the motions that are meant are such as the claim is tried on.
    pub(super) fn motions_are_analytic(&mut self, of: &Claim) -> bool {
        let given = self.equations_of_systems();
        let systems = match (given.is_empty(), Step::behind(self.derivation, self.claim)) {
            (false, _) => vec![given],
            (true, Some(behind)) => behind.into_iter().map(|system| self.equations_of(system)).collect(),
            (true, None) => return false,
        };
        !systems.is_empty() && systems.into_iter().all(|equations| self.is_analytic_along(of, equations))
    }

    fn is_analytic_along(&mut self, of: &Claim, equations: Pairs) -> bool {
        let Some(determined) = self.determined(&equations) else { return false };
        let claim = self.claim;
        let named: Vec<Expr> = sides(&equations).collect();
        let mut named: Vec<Expr> = named.into_iter().map(|e| traced(&mut self.graph, &claim.scope, e)).collect();
        for one in [of, claim] {
            let assumed = one.assuming.iter().flat_map(|w| &w.value.relations);
            let (equations, signs) = self.said(one).unwrap_or_default();
            let relations = assumed.chain(signs).flat_map(pairs);
            let all: Vec<Expr> = relations.chain(equations).flat_map(|(l, r)| [l, r]).collect();
            named.extend(all.into_iter().map(|e| traced(&mut self.graph, &one.scope, e)));
        }
        // Rates of what has a formula.
        for leaf in self.graph.leaves(named.iter().copied()).into_iter().filter(|l| l.rate > 0) {
            let scope = [&claim.scope, &of.scope].into_iter().find(|s| s.definition(leaf.symbol).is_some());
            let Some(scope) = scope else { continue };
            let node = self.graph.leaf(Leaf { rate: 0, ..leaf });
            named.push(traced(&mut self.graph, scope, node));
        }
        let has_formula = |l: &Leaf| [claim, of].iter().any(|c| c.scope.definition(l.symbol).is_some());
        let moves = |leaf: &Leaf| claim.scope.moves(leaf) || of.scope.moves(leaf);
        let is_known = |leaf: &Leaf| {
            !moves(leaf) || determined.contains(&(leaf.symbol, leaf.component)) || leaf.rate > 0 && has_formula(leaf)
        };
        self.graph.leaves(named).iter().all(|leaf| !self.graph.is_field(leaf.symbol) && is_known(leaf))
    }

    /// Whether equations that are so at the times that count are so at all others, since they go on and cannot leap.
    pub(super) fn is_known_elsewhere(&mut self, of: &Claim, without: &[usize], equations: &Pairs) -> bool {
        if self.inequalities == When::Always || self.choosing(of, without).is_empty() {
            return true;
        }
        let mut leaps = |e: Expr| {
            let e = traced(&mut self.graph, &of.scope, e);
            may_leap(&self.graph, e)
        };
        !equations.iter().any(|&(l, r)| leaps(l) || leaps(r)) && self.goes_on(of, without)
    }

    /// The fixed times that a claim names which are among those that it chooses wherever its own formulas have values.
    pub(super) fn instants_with_values(&mut self, claim: &Claim, without: &[usize]) -> Vec<Expr> {
        let choosing = self.choosing(claim, without);
        let scalar =
            |r: &&Relation| r.kind == RelationKind::NotEqual && r.left.components.len() == 1 && !r.has_branches;
        if self.inequalities == When::Always || choosing.is_empty() || !choosing.iter().all(scalar) {
            return Vec::new();
        }
        let own: Vec<Expr> = sides(&self.equations(claim).unwrap_or_default()).collect();
        let mut instants: Vec<Expr> =
            self.graph.leaves_within(own.clone()).into_iter().filter_map(|l| l.instant).collect();
        instants.sort_unstable();
        instants.dedup();
        let values: Vec<Expr> = own.into_iter().flat_map(|e| presupposed(&mut self.graph, &claim.scope, e)).collect();
        let needs = self.graph.implied_below(values).into_iter().filter(|n| n.sign == Sign::NotZero);
        let mut known = Gathered::default();
        // What a formula needs at the present says nothing of a fixed time.
        known.throughout.nonzero = needs.map(|n| n.value).filter(|&e| !self.moves(e)).collect();
        let differences: Vec<(Expr, Expr)> = choosing.into_iter().flat_map(pairs).collect();
        instants.retain(|&instant| {
            differences.iter().all(|&(l, r)| {
                let difference = self.graph.sub(l, r);
                let then = at_instant(&mut self.graph, &claim.scope, difference, instant);
                let then = traced(&mut self.graph, &claim.scope, then);
                self.never_vanishes(then, &known)
            })
        });
        instants
    }

    /// The first integrals that are given of all motions and have values at all times: others need not be the same on both sides of where
    /// they have none.
    pub(super) fn constants(&mut self, values: &mut Valued, throughout: &Premises) -> Vec<(&'a Scope, Expr)> {
        let mut out = self.first_integrals();
        let own = &self.claim.scope;
        out.retain(|&(scope, e)| self.has_value(e, &[scope, own], values, throughout) == When::Always);
        out
    }

    /// The first integrals that are given of all motions.
    fn first_integrals(&self) -> Vec<(&'a Scope, Expr)> {
        let mut out: Vec<(&'a Scope, Expr)> = Vec::new();
        for premise in self.claims_named() {
            for form in premise.forms.iter().filter(|_| premise.assuming.is_empty() && premise.at.is_none()) {
                if let Form::FirstIntegral(w) = form {
                    out.extend(w.value.components.iter().map(|&e| (&premise.scope, e)));
                }
            }
        }
        out
    }

    /// Whether a relation is an equation between constants: it holds always, if it holds once.
    pub(super) fn is_about_constants(&self, relation: &Relation, constant: &[(&Scope, Expr)]) -> bool {
        let scope = &self.claim.scope;
        let is_constant =
            |l: &Leaf| constant.iter().any(|&(_, c)| matches!(self.graph.node(c), Node::Leaf(of) if of == l));
        let moves = |l: &Leaf| l.instant.is_none() && (scope.moves(l) || Some(*l) == scope.time());
        let rests = |e: Expr| {
            constant.iter().any(|&(_, c)| c == e)
                || self.graph.leaves_within([e]).iter().all(|l| !moves(l) || is_constant(l))
        };
        match relation.kind {
            RelationKind::Equal => relation.limit.is_none() && pairs(relation).all(|(l, r)| rests(l) && rests(r)),
            _ => !chooses(&self.graph, &self.claim.scope, relation),
        }
    }

    /// The equations between constants that a claim assumes, but those with the given numbers.
    pub(super) fn about_constants(&self, claim: &Claim, without: &[usize], constant: &[(&Scope, Expr)]) -> Pairs {
        let used = claim.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        let relations = used.flat_map(|(_, w)| &w.value.relations);
        let equations = relations.filter(|r| r.kind == RelationKind::Equal && !r.has_branches);
        equations.filter(|r| self.is_about_constants(r, constant)).flat_map(pairs).collect()
    }

    /// The equations that the claim assumes at the times that it chooses, and that are not known at others: they do not go on, and are not
    /// about constants.
    pub(super) fn assumed_at_times(&mut self, without: &[usize], constant: &[(&Scope, Expr)]) -> Vec<String> {
        let claim = self.claim;
        let mut out = Vec::new();
        for w in &claim.assuming {
            let equations = w.value.relations.iter().filter(|r| r.kind == RelationKind::Equal);
            let moving = equations.filter(|r| !self.is_about_constants(r, constant)).flat_map(pairs).collect();
            if !self.is_known_elsewhere(claim, without, &moving) && !moving.is_empty() {
                out.push(w.text.clone());
            }
        }
        out
    }

    /// The numbers of the assumptions of the claim that need not hold at all times.
    pub(super) fn assumed_for_a_while(&mut self) -> Vec<usize> {
        let mut values = self.values();
        let signs = self.signs_of_premises(&mut values);
        let constant = self.constants(&mut values, &signs);
        let stays = |w: &Written<Statement>| w.value.relations.iter().all(|r| self.is_about_constants(r, &constant));
        let all = self.claim.assuming.iter().enumerate();
        all.filter(|(_, w)| !stays(w)).map(|(at, _)| at).collect()
    }

    /// What a premise assumes, and the claim does not: that is presupposed here, and a proof does not reach beyond it. A name may mean
    /// something else in each claim, and an equation that is assumed there of more times is another assumption.
    pub(super) fn presupposes(&self, premise: &Claim, assumed_at_times: &[String]) -> Vec<String> {
        let scope = &self.claim.scope;
        let among = |all: &[Written<Statement>], of: &Statement| all.iter().any(|w| w.value.says_the_same(of));
        let choosing = |w: &&Written<Statement>| w.value.relations.iter().any(|r| chooses(&self.graph, scope, r));
        let as_often = self.claim.assuming.iter().filter(choosing).all(|w| among(&premise.assuming, &w.value));
        let own = |w: &&Written<Statement>| {
            among(&self.claim.assuming, &w.value) && (as_often || !assumed_at_times.contains(&w.text))
        };
        premise.assuming.iter().filter(|w| !own(w)).map(|w| w.text.clone()).collect()
    }
}

/// Whether a relation chooses times: something moves in it, and it is no equation. What must not be 0, and is an analytic function of
/// the time alone, leaves out single times, and goes on beyond.
pub(crate) fn chooses(graph: &Graph, scope: &Scope, relation: &Relation) -> bool {
    let sides: Vec<Expr> = relation.left.components.iter().chain(&relation.right.components).copied().collect();
    let time = scope.time();
    let mut moving = graph.leaves_within(sides.iter().copied());
    moving.retain(|l| l.instant.is_none() && (scope.moves(l) || Some(*l) == time));
    let of_time =
        |time: Leaf| moving.iter().all(|&l| l == time) && sides.iter().all(|&e| graph.is_analytic_in(e, time));
    match relation.kind {
        RelationKind::Equal => false,
        RelationKind::NotEqual => !moving.is_empty() && !time.is_some_and(of_time),
        _ => !moving.is_empty(),
    }
}
