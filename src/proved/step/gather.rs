//! What a step may use: the claims and systems that it names, assumptions, definitions.

use super::{LEFT_OUT_NODES, MOST_CASES, Pairs, Step, now, pairs};
use crate::derivation::{Claim, Derivation, Form, Premise, Written};
use crate::expr::domain::{Change, EdgeOf, Need, Sign};
use crate::expr::{Expr, FastSet, Graph, Leaf, Node, Op, Rational};
use crate::latex::{Relation, RelationKind, Role, Scope, Statement};
use claim::comparison::{at_instant, may_leap, presupposed, traced};
use proof::{Identity, Options, Premises, Reason, Wanted, solve_for_arguments};

/// Which definitions of observables are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Definitions {
    /// None: an observable is what the premises say of it.
    None,
    /// Those of symbols that are declared for a claim.
    OfClaims,
    /// Those, and all at the fixed times that occur.
    Then,
    /// All, at the present time.
    Now,
    /// All, also at the fixed times that occur.
    All,
    /// All, and the systems that are given where no rate occurs, but an equation ties what moves. Only such a point can refute.
    Everything,
}

impl Definitions {
    /// In the order of trying: all but the last leave something out.
    pub(super) const LEVELS: [Definitions; 6] = [
        Definitions::None,
        Definitions::OfClaims,
        Definitions::Then,
        Definitions::Now,
        Definitions::All,
        Definitions::Everything,
    ];
}

/// What an angle has of its formula.
enum Continued {
    /// It is its formula.
    No,
    /// It has its rate.
    Rate(Expr),
    /// That cannot be said.
    Unknown,
}

/// Everything that is named.
#[derive(Clone, Debug, Default)]
pub(super) struct Gathered {
    /// Equations of claims and assumptions, and what they say at the fixed times that occur.
    pub(super) premises: Premises,
    /// Of these the equations and signs that hold at all times.
    pub(super) throughout: Premises,
    pub(super) systems: Pairs,
    /// Assumptions of the claims that are named.
    pub(super) inherited: Vec<String>,
    /// Equations that the claim assumes at some times only.
    pub(super) assumed_at_times: Vec<String>,
    /// Whether all of it is known at all times.
    pub(super) elsewhere: bool,
    /// Whether all of it may be used of the times between others: none is left out, or motions are analytic.
    pub(super) between: bool,
    /// The names.
    pub(super) from: Vec<String>,
    /// Whether all could be used: a refutation needs that.
    pub(super) complete: bool,
}

fn sides(pairs: &[(Expr, Expr)]) -> impl Iterator<Item = Expr> + '_ {
    pairs.iter().flat_map(|&(l, r)| [l, r])
}

impl<'a> Step<'a> {
    /// The rate of a first integral as an equation `… = 0`: it says nothing where the integral has no value.
    fn constancy(&mut self, scope: &Scope, e: Expr) -> Option<(Expr, Expr)> {
        let time = scope.time()?;
        let moves = |leaf: Leaf| scope.moves(&leaf);
        let rate = self.graph.time_derivative(e, time, moves).ok()?;
        let rate = self.graph.rate_of(e, rate, |leaf| scope.role(leaf.symbol) == Some(Role::Observable));
        Some((rate, self.graph.integer(0)))
    }

    /// What a claim says as equations; `None` where it says something else, or not at all times.
    pub(super) fn equations(&mut self, claim: &Claim) -> Option<Pairs> {
        let (equations, signs) = self.said(claim)?;
        signs.is_empty().then_some(equations)
    }

    /// What a claim says as equations, and as other relations; `None` where it says something else, or not at all times.
    fn said<'c>(&mut self, claim: &'c Claim) -> Option<(Pairs, Vec<&'c Relation>)> {
        let (mut out, mut signs) = (Vec::new(), Vec::new());
        if claim.at.is_some() {
            return None;
        }
        for form in &claim.forms {
            if let Form::FirstIntegral(w) = form {
                for &e in &w.value.components {
                    out.push(self.constancy(&claim.scope, e)?);
                }
            } else if let Form::Solves { system } = form {
                let relations = self.derivation.systems[*system].equations.iter().flat_map(|w| &w.value.relations);
                out.extend(relations.flat_map(pairs));
            } else if let Form::Always(w) = form {
                for relation in &w.value.relations {
                    match relation.kind {
                        _ if relation.limit.is_some() => return None,
                        RelationKind::Equal => out.extend(pairs(relation)),
                        // A sign of another claim is not known, and what is said over a box says nothing beyond.
                        _ if relation.has_branches || claim.region.is_some() => return None,
                        _ => signs.push(relation),
                    }
                }
            } else {
                return None;
            }
        }
        if let Some(value) = self.sign.filter(|_| std::ptr::eq(claim, self.claim)) {
            out = self.branch(&out, value);
        }
        Some((out, signs))
    }

    /// Adds a relation to what is given.
    fn give(&mut self, relation: &Relation, premises: &mut Premises) {
        for (l, r) in self.scalars(relation) {
            match relation.kind {
                RelationKind::Equal => premises.equations.push((l, r)),
                RelationKind::NotEqual => premises.nonzero.push(self.graph.sub(l, r)),
                RelationKind::Greater => premises.positive.push(self.graph.sub(l, r)),
                RelationKind::Less => premises.positive.push(self.graph.sub(r, l)),
                RelationKind::GreaterEqual => premises.not_negative.push(self.graph.sub(l, r)),
                RelationKind::LessEqual => premises.not_negative.push(self.graph.sub(r, l)),
            }
        }
    }

    /// Adds the assumptions of a claim but those with the given numbers.
    ///
    /// Whether all of them could be used: a limit says nothing of present values, and a sign of another claim is not known.
    ///
    /// Equations of fields are assumed at all places; where an equation says at which places, they are assumed there alone, and
    /// nothing is known of their derivatives.
    ///
    /// At single times nothing is known of the rates of what is assumed there, and a point that refutes may belong to no such time.
    fn assume(&mut self, claim: &Claim, without: &[usize], single: bool, premises: &mut Premises) -> bool {
        let used = claim.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        let mut complete = true;
        let before = premises.equations.len();
        for relation in used.flat_map(|(_, w)| &w.value.relations) {
            if relation.limit.is_some() || relation.has_branches && self.sign.is_none() {
                complete = false;
                continue;
            }
            self.give(relation, premises);
        }
        let single_places = self.may_choose_single_places(claim, without);
        let graph = &self.graph;
        let of_fields = |(l, r): &(Expr, Expr)| !graph.fields([*l, *r]).is_empty();
        let is_place = |pair: &(Expr, Expr)| {
            let leaves = graph.leaves_within([pair.0, pair.1]);
            !of_fields(pair) && leaves.iter().any(|l| graph.coordinate(*l).is_some())
        };
        if premises.equations[before..].iter().any(is_place) || single_places {
            let (there, everywhere) = premises.equations.drain(before..).partition::<Pairs, _>(of_fields);
            premises.equations.extend(everywhere);
            // Along such places they may be meant to hold together: no point refutes that.
            complete &= there.is_empty();
            premises.only_now.extend(there);
        }
        complete & !self.keep_for_now(before, single, premises)
    }

    /// Keeps the equations from a number on for the present time, where that is single; whether there are any that move.
    fn keep_for_now(&self, from: usize, single: bool, premises: &mut Premises) -> bool {
        let moves = |&(l, r): &(Expr, Expr)| self.moves(l) || self.moves(r);
        if !single || !premises.equations[from..].iter().any(moves) {
            return false;
        }
        let (moving, constant) = premises.equations.drain(from..).partition::<Pairs, _>(moves);
        premises.equations.extend(constant);
        premises.only_now.extend(moving);
        true
    }

    /// The relations that a claim assumes, but those with the given numbers, by which times are chosen.
    fn choosing<'c>(&self, claim: &'c Claim, without: &[usize]) -> Vec<&'c Relation> {
        let used = claim.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        let apart = |r: &&Relation| r.kind == RelationKind::NotEqual && pairs(r).all(|pair| self.apart.contains(&pair));
        let relations = used.flat_map(|(_, w)| &w.value.relations).filter(|r| !apart(r));
        relations.filter(|r| chooses(&self.graph, &claim.scope, r)).collect()
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
        let has_jumps = jumping.iter().any(|edge| !edge.vanishing.is_some_and(|e| is_sum_of_squares(&self.graph, e)));
        let ends = |need: Need| {
            need.sign == Sign::NotNegative && self.depends(need.value) && !is_sum_of_squares(&self.graph, need.value)
        };
        !has_jumps && !needs.into_iter().any(ends)
    }

    /// Whether something changes along a motion, or from place to place.
    fn depends(&self, e: Expr) -> bool {
        let place = |l: &Leaf| self.graph.coordinate(*l).is_some() || self.graph.is_field(l.symbol);
        self.moves(e) || self.graph.leaves([e]).iter().any(place)
    }

    /// Whether single times may be all that a claim chooses: nothing is known of rates then.
    fn may_choose_single_times(&mut self, of: &Claim, without: &[usize]) -> bool {
        let mut choosing = self.choosing(of, without);
        // What is assumed of all times may leave single ones, if it is about the time itself.
        let names_time = |r: &&Relation| {
            let leaves = self.graph.leaves_within(pairs(r).flat_map(|(l, r)| [l, r]));
            leaves.iter().any(|l| Some(*l) == of.scope.time())
        };
        choosing.retain(|r| !self.at_all_times || names_time(r));
        !choosing.into_iter().all(|r| self.holds_for_a_while(&of.scope, r))
    }

    /// Whether a relation that a claim assumes may leave single places: nothing is known of derivatives there.
    fn may_choose_single_places(&mut self, of: &Claim, without: &[usize]) -> bool {
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
    fn goes_on(&mut self, of: &Claim, without: &[usize]) -> bool {
        let everywhere = self.at_all_times || self.choosing(of, without).is_empty();
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
    fn is_known_elsewhere(&mut self, of: &Claim, without: &[usize], equations: &Pairs) -> bool {
        if self.at_all_times || self.choosing(of, without).is_empty() {
            return true;
        }
        let mut leaps = |e: Expr| {
            let e = traced(&mut self.graph, &of.scope, e);
            may_leap(&self.graph, e)
        };
        !equations.iter().any(|&(l, r)| leaps(l) || leaps(r)) && self.goes_on(of, without)
    }

    /// What `follows-from` and the assumptions give; `without` some assumptions.
    pub(super) fn gather(&mut self, without: Option<&[usize]>) -> Gathered {
        let (derivation, claim) = (self.derivation, self.claim);
        let mut out = Gathered { complete: !self.lacks_systems(), ..Gathered::default() };
        let mut premises = Premises::default();
        self.roles(&mut premises);
        let absent = without.unwrap_or(&[]);
        let single = self.may_choose_single_times(claim, absent);
        out.complete &= self.assume(claim, absent, single, &mut premises);
        // Each with the scope that says what moves in it.
        let mut always: Vec<(&Scope, Pairs)> = Vec::new();
        out.elsewhere = self.at_all_times || self.choosing(claim, absent).is_empty();
        out.between = self.goes_on(claim, absent);
        if self.is_known_elsewhere(claim, absent, &premises.equations) {
            always.push((&claim.scope, premises.equations.clone()));
        }
        let mut constant = self.constants();
        let known: Pairs = self.about_constants(claim, absent, &constant);
        if !out.elsewhere {
            always.push((&claim.scope, known));
        }
        let mut given: Vec<&Claim> = Vec::new();
        for name in Step::given(derivation, claim) {
            out.from.push(name.clone());
            let premise = match derivation.premise(&name) {
                Premise::System(system) => {
                    let equations = &derivation.systems[system].equations;
                    out.systems.extend(equations.iter().flat_map(|w| &w.value.relations).flat_map(pairs));
                    continue;
                }
                Premise::Claim(claim) => &derivation.claims[claim],
                Premise::Definition => continue,
            };
            let mut at_others = true;
            let single = single && !premise.assuming.is_empty() || self.may_choose_single_times(premise, &[]);
            match self.said(premise) {
                Some((equations, signs)) => {
                    let equations = self.without_branches(premise, equations, &mut out.complete);
                    let before = premises.equations.len();
                    premises.equations.extend(&equations);
                    out.complete &= !self.keep_for_now(before, single, &mut premises);
                    // What it assumes is known at other times if it is assumed here of all of them.
                    let of_constants = |w: &Written<Statement>| {
                        w.value.relations.iter().all(|r| self.is_about_constants(r, &constant))
                    };
                    at_others = premise.assuming.iter().all(of_constants)
                        || self.is_known_elsewhere(premise, &[], &equations)
                            && self.is_known_elsewhere(claim, absent, &equations);
                    out.elsewhere &= at_others;
                    out.between &= at_others;
                    for form in &premise.forms {
                        if let (Form::FirstIntegral(w), true) = (form, at_others) {
                            constant.extend(w.value.components.iter().map(|&e| (&premise.scope, e)));
                        }
                    }
                    always.extend(at_others.then_some((&premise.scope, equations)));
                    // What it says under assumptions it may say at some times only.
                    let throughout = self.at_all_times || premise.assuming.is_empty();
                    out.between &= throughout || signs.is_empty();
                    for relation in signs {
                        self.give(relation, &mut premises);
                        if throughout {
                            self.give(relation, &mut out.throughout);
                        }
                    }
                }
                None => out.complete = false,
            }
            let before = premises.equations.len();
            // An assumption that is left out is left out everywhere.
            let dropped =
                |of: &Statement| without.is_some_and(|w| w.iter().any(|&i| claim.assuming[i].value.says_the_same(of)));
            let numbers: Vec<usize> =
                (0..premise.assuming.len()).filter(|&i| dropped(&premise.assuming[i].value)).collect();
            out.complete &= self.assume(premise, &numbers, single, &mut premises);
            let assumed = premises.equations[before..].to_vec();
            if at_others && self.is_known_elsewhere(claim, absent, &assumed) {
                always.push((&premise.scope, assumed));
            }
            given.push(premise);
        }
        out.assumed_at_times = self.assumed_at_times(absent, &constant);
        for premise in given {
            out.inherited.extend(self.presupposes(premise, &out.assumed_at_times));
        }
        let mut seen = Vec::new();
        out.inherited.retain(|text| {
            !seen.contains(text) && {
                seen.push(text.clone());
                true
            }
        });
        out.throughout.equations.extend(always.iter().flat_map(|(_, pairs)| pairs));
        for instant in self.instants_with_values(claim, absent) {
            self.give_at(instant, claim, absent, &mut premises);
        }
        self.signs_throughout(&premises, &mut out.throughout);
        self.at_instants(&always, &constant, &out.throughout, &mut premises);
        out.premises = premises;
        out
    }

    /// The fixed times that a claim names which are among those that it chooses wherever its own formulas have values.
    fn instants_with_values(&mut self, claim: &Claim, without: &[usize]) -> Vec<Expr> {
        let choosing = self.choosing(claim, without);
        let scalar =
            |r: &&Relation| r.kind == RelationKind::NotEqual && r.left.components.len() == 1 && !r.has_branches;
        if self.at_all_times || choosing.is_empty() || !choosing.iter().all(scalar) {
            return Vec::new();
        }
        let own: Vec<Expr> = sides(&self.equations(claim).unwrap_or_default()).collect();
        let mut instants: Vec<Expr> =
            self.graph.leaves_within(own.clone()).into_iter().filter_map(|l| l.instant).collect();
        instants.sort_unstable();
        instants.dedup();
        let values: Vec<Expr> = own.into_iter().flat_map(|e| presupposed(&mut self.graph, &claim.scope, e)).collect();
        let needs = self.graph.needs_below(values).into_iter().filter(|n| n.sign == Sign::NotZero && n.certain);
        let mut known = Gathered::default();
        known.throughout.nonzero = needs.map(|n| n.value).collect();
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

    /// Adds what a claim assumes at a fixed time that it chooses.
    fn give_at(&mut self, instant: Expr, claim: &Claim, without: &[usize], premises: &mut Premises) {
        let mut then = Premises::default();
        self.assume(claim, without, false, &mut then);
        let graph = &mut self.graph;
        let mut at = |e: Expr| at_instant(graph, &claim.scope, e, instant);
        premises.equations.extend(then.equations.into_iter().map(|(l, r)| (at(l), at(r))).filter(|(l, r)| l != r));
        premises.nonzero.extend(then.nonzero.into_iter().map(&mut at));
        premises.positive.extend(then.positive.into_iter().map(&mut at));
        premises.not_negative.extend(then.not_negative.into_iter().map(&mut at));
    }

    /// Adds to the signs that hold at all times those of what does not move; all of them, if what is assumed is assumed of all times.
    fn signs_throughout(&self, premises: &Premises, throughout: &mut Premises) {
        let scope = &self.claim.scope;
        let moves = |l: &Leaf| l.instant.is_none() && (scope.moves(l) || Some(*l) == scope.time());
        let holds = |e: &&Expr| self.at_all_times || !self.graph.leaves_within([**e]).iter().any(moves);
        throughout.nonzero.extend(premises.nonzero.iter().filter(|e| !self.apart.is_empty() || holds(e)));
        throughout.positive.extend(premises.positive.iter().filter(holds));
        throughout.not_negative.extend(premises.not_negative.iter().filter(holds));
    }

    /// Whether something vanishes at no time, by the signs that hold at all times.
    pub(super) fn never_vanishes(&mut self, e: Expr, gathered: &Gathered) -> bool {
        let mut premises = gathered.throughout.clone();
        let [zero, one] = [0, 1].map(|n| self.graph.integer(n));
        let instants: Vec<Expr> = self.graph.leaves_within([e]).into_iter().filter_map(|l| l.instant).collect();
        for signs in [&mut premises.nonzero, &mut premises.positive, &mut premises.not_negative] {
            for fact in signs.clone() {
                signs.extend(instants.iter().map(|&i| at_instant(&mut self.graph, &self.claim.scope, fact, i)));
            }
        }
        premises.equations.push((e, zero));
        let loosened = self.loosened;
        self.definitions(&Pairs::new(), &[], Definitions::All, &mut premises);
        self.loosened = loosened;
        self.add_positive_parameters(&Pairs::new(), &mut premises);
        let options = Options { attempts: 1, most_nodes: LEFT_OUT_NODES, wanted: Wanted::Fault, ..Options::default() };
        let found = self.test_only(&premises, &vec![(zero, one)], &options);
        matches!(found, Identity::Undecided(Reason::Contradiction))
    }

    /// The first integrals that are given of all motions.
    fn constants(&self) -> Vec<(&'a Scope, Expr)> {
        let derivation = self.derivation;
        let mut out: Vec<(&'a Scope, Expr)> = Vec::new();
        for name in Step::given(derivation, self.claim) {
            let Premise::Claim(at) = derivation.premise(&name) else { continue };
            let premise = &derivation.claims[at];
            for form in premise.forms.iter().filter(|_| premise.assuming.is_empty() && premise.at.is_none()) {
                if let Form::FirstIntegral(w) = form {
                    out.extend(w.value.components.iter().map(|&e| (&premise.scope, e)));
                }
            }
        }
        out
    }

    /// Whether a relation is an equation between constants: it holds always, if it holds once.
    fn is_about_constants(&self, relation: &Relation, constant: &[(&Scope, Expr)]) -> bool {
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
    fn about_constants(&self, claim: &Claim, without: &[usize], constant: &[(&Scope, Expr)]) -> Pairs {
        let used = claim.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        let relations = used.flat_map(|(_, w)| &w.value.relations);
        let equations = relations.filter(|r| r.kind == RelationKind::Equal && !r.has_branches);
        equations.filter(|r| self.is_about_constants(r, constant)).flat_map(pairs).collect()
    }

    /// The equations that the claim assumes at the times that it chooses, and that are not known at others: they do not go on, and are not
    /// about constants.
    fn assumed_at_times(&mut self, without: &[usize], constant: &[(&Scope, Expr)]) -> Vec<String> {
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
    pub(super) fn assumed_for_a_while(&self) -> Vec<usize> {
        let constant = self.constants();
        let stays = |w: &Written<Statement>| w.value.relations.iter().all(|r| self.is_about_constants(r, &constant));
        let all = self.claim.assuming.iter().enumerate();
        all.filter(|(_, w)| !stays(w)).map(|(at, _)| at).collect()
    }

    /// What a premise assumes, and the claim does not: that is presupposed here, and a proof does not reach beyond it. A name may mean
    /// something else in each claim, and an equation that is assumed there of more times is another assumption.
    fn presupposes(&self, premise: &Claim, assumed_at_times: &[String]) -> Vec<String> {
        let scope = &self.claim.scope;
        let among = |all: &[Written<Statement>], of: &Statement| all.iter().any(|w| w.value.says_the_same(of));
        let choosing = |w: &&Written<Statement>| w.value.relations.iter().any(|r| chooses(&self.graph, scope, r));
        let as_often = self.claim.assuming.iter().filter(choosing).all(|w| among(&premise.assuming, &w.value));
        let own = |w: &&Written<Statement>| {
            among(&self.claim.assuming, &w.value) && (as_often || !assumed_at_times.contains(&w.text))
        };
        premise.assuming.iter().filter(|w| !own(w)).map(|w| w.text.clone()).collect()
    }

    /// ± in a premise: at each time one of the signs holds, so the product of the two residuals vanishes.
    fn without_branches(&mut self, premise: &Claim, equations: Pairs, complete: &mut bool) -> Pairs {
        let sign = premise.scope.branch_sign();
        let branching = |graph: &Graph, &(l, r): &(Expr, Expr)| graph.leaves_within([l, r]).contains(&sign);
        let count = equations.iter().filter(|p| branching(&self.graph, p)).count();
        // One sign for several equations, for all times, or for an assumption, too, says more than the products.
        let assumed = premise.assuming.iter().flat_map(|w| &w.value.relations).any(|r| r.has_branches);
        *complete &= count == 0 || count == 1 && !premise.branches_throughout && !assumed;
        let one = |this: &mut Self, pair: (Expr, Expr)| {
            if !branching(&this.graph, &pair) {
                return pair;
            }
            let residual = this.graph.sub(pair.0, pair.1);
            let [p, q] = [1, -1].map(|v| this.graph.rewrite(residual, |g, l| (l == sign).then(|| g.integer(v))));
            (this.graph.mul(p, q), this.graph.integer(0))
        };
        equations.into_iter().map(|pair| one(self, pair)).collect()
    }

    /// What holds at all times holds at the fixed times that occur; constants have their present value there.
    fn at_instants(
        &mut self,
        always: &[(&Scope, Pairs)],
        constant: &[(&Scope, Expr)],
        throughout: &Premises,
        premises: &mut Premises,
    ) {
        let mut roots: Vec<Expr> = always.iter().flat_map(|(_, p)| sides(p)).collect();
        roots.extend(premises.nonzero.iter().chain(&premises.positive).chain(&premises.not_negative));
        let own = self.equations(self.claim).unwrap_or_default();
        roots.extend(sides(&own));
        let mut instants: Vec<Expr> = self.graph.leaves_within(roots).into_iter().filter_map(|l| l.instant).collect();
        instants.sort_unstable();
        instants.dedup();
        for &instant in &instants {
            for &(scope, e) in constant {
                let then = at_instant(&mut self.graph, scope, e, instant);
                premises.equations.push((e, then));
            }
            for (scope, list) in always {
                for &(l, r) in list {
                    if self.graph.leaves_within([l, r]).iter().any(|l| l.rate > 0) {
                        continue;
                    }
                    let then = [l, r].map(|e| at_instant(&mut self.graph, scope, e, instant));
                    if then != [l, r] && then[0] != then[1] && !premises.equations.contains(&(then[0], then[1])) {
                        premises.equations.push((then[0], then[1]));
                    }
                }
            }
            let scope = &self.claim.scope;
            let lists = [
                (&mut premises.nonzero, &throughout.nonzero),
                (&mut premises.positive, &throughout.positive),
                (&mut premises.not_negative, &throughout.not_negative),
            ];
            for (list, of) in lists {
                for &e in of {
                    if self.graph.leaves_within([e]).iter().all(|l| l.rate == 0) {
                        let then = at_instant(&mut self.graph, scope, e, instant);
                        if !list.contains(&then) {
                            list.push(then);
                        }
                    }
                }
            }
        }
    }

    /// Which symbols move, and which are parameters.
    fn roles(&mut self, premises: &mut Premises) {
        let Derivation { symbols, claims, scope, .. } = self.derivation;
        premises.time = scope.time();
        for entry in symbols.iter().chain(claims.iter().flat_map(|c| &c.symbols)) {
            let count = self.graph.component_count(entry.symbol);
            match entry.role {
                Role::State | Role::Observable => {
                    premises.moving.push(entry.symbol);
                    premises.angles.extend(entry.angle.then_some(entry.symbol));
                }
                Role::Parameter => premises.parameters.extend((0..count).map(|c| now(entry.symbol, c))),
                Role::Coordinate => premises.parameters.extend((0..count).map(|c| now(entry.symbol, c))),
                Role::Time | Role::Abbreviation | Role::Argument | Role::Field => {}
            }
        }
    }

    /// All premises of a question, with some definitions.
    pub(super) fn premises(&mut self, gathered: &Gathered, equations: &Pairs, which: Definitions) -> Premises {
        let mut premises = gathered.premises.clone();
        self.definitions(equations, &gathered.systems, which, &mut premises);
        self.definitions_at_instants(equations, which, &mut premises);
        self.add_positive_parameters(equations, &mut premises);
        solve_for_arguments(&mut self.graph, &mut premises);
        premises
    }

    /// What is positive among the parameters that occur.
    pub(super) fn add_positive_parameters(&mut self, equations: &Pairs, premises: &mut Premises) {
        let roots: Vec<Expr> = sides(equations).chain(sides(&premises.equations)).collect();
        for leaf in self.graph.leaves_within(roots) {
            if self.is_positive_parameter(leaf) {
                let node = self.graph.leaf(leaf);
                premises.positive.push(node);
            }
        }
    }

    /// The definition of a component, as far as definitions are used.
    fn definition(&self, leaf: Leaf, which: Definitions) -> Option<Expr> {
        let Derivation { claims, scope, .. } = self.derivation;
        let in_file = || {
            scope
                .definition(leaf.symbol)
                .filter(|_| matches!(which, Definitions::Now | Definitions::All | Definitions::Everything))
        };
        // The claims are many, and asked for the same symbols again and again.
        let in_claim = || {
            let found = || {
                let own = scope.definition(leaf.symbol).is_none();
                claims.iter().filter(|_| own).find_map(|c| c.scope.definition(leaf.symbol))
            };
            *self.of_claims.borrow_mut().entry(leaf.symbol).or_insert_with(found)
        };
        let definition = match which {
            Definitions::None => None,
            _ => in_file().or_else(in_claim),
        };
        definition?.components.get(usize::from(leaf.component)).copied()
    }

    /// Whether systems that are given may tie states by what they say of rates: several may name one rate, and one that does not determine
    /// its rates may say something else.
    fn systems_tie_states(&mut self) -> bool {
        let given = Step::given(self.derivation, self.claim);
        let systems = given.iter().filter(|name| matches!(self.derivation.premise(name), Premise::System(_))).count();
        systems > 1 || systems == 1 && self.rates_of_systems().is_none()
    }

    /// The definitions of the observables that occur, of those in these, and so on; where rates occur, the systems that
    /// are given join in. What does not occur is left out: a premise less can only lose a proof. Where a point may refute, the
    /// systems join in, too, where an equation that is given ties what moves, or they have one without a rate: with the rates of that
    /// they may say more.
    fn definitions(
        &mut self,
        equations: &Pairs,
        systems: &[(Expr, Expr)],
        which: Definitions,
        premises: &mut Premises,
    ) {
        let mut seen: Vec<Leaf> = Vec::new();
        let tied = |graph: &Graph, &(l, r): &(Expr, Expr)| {
            graph.leaves_within([l, r]).iter().any(|l| l.instant.is_none() && self.claim.scope.moves(l))
        };
        let constraint =
            |graph: &Graph, &(l, r): &(Expr, Expr)| graph.leaves_within([l, r]).iter().all(|l| l.rate == 0);
        let mut moving = which == Definitions::Everything
            && (premises.equations.iter().any(|pair| tied(&self.graph, pair))
                || systems.iter().any(|pair| constraint(&self.graph, pair))
                || self.systems_tie_states());
        let roots: Vec<Expr> = sides(equations)
            .chain(sides(&premises.equations))
            .chain(premises.nonzero.iter().chain(&premises.positive).chain(&premises.not_negative).copied())
            .collect();
        let mut open = self.graph.leaves_within(roots);
        let mut joined = false;
        loop {
            while let Some(leaf) = open.pop() {
                moving |= leaf.rate > 0 || self.graph.is_field(leaf.symbol);
                let value = Leaf { rate: 0, ..leaf };
                if value.instant.is_some() || seen.contains(&value) {
                    continue;
                }
                seen.push(value);
                if let Some(e) = self.definition(value, which) {
                    match self.continued(value, e, equations, premises) {
                        Continued::No => {
                            let node = self.graph.leaf(value);
                            premises.equations.push((node, e));
                        }
                        // Whole turns may lie between it and its formula: only its rate is that of the formula.
                        Continued::Rate(rate) => {
                            let node = self.graph.leaf(Leaf { rate: 1, ..value });
                            premises.equations.push((node, rate));
                            (moving, self.loosened) = (true, true);
                        }
                        Continued::Unknown => self.loosened = true,
                    }
                    open.extend(self.graph.leaves_within([e]));
                }
            }
            if !moving || systems.is_empty() || std::mem::replace(&mut joined, true) {
                return;
            }
            let new: Pairs = systems.iter().filter(|p| !premises.equations.contains(p)).copied().collect();
            premises.equations.extend(new);
            open.extend(self.graph.leaves_within(sides(systems)));
        }
    }

    /// What an angle that is continued along motions has of its formula, where more of it occurs than its sine and cosine.
    fn continued(&mut self, leaf: Leaf, e: Expr, equations: &Pairs, premises: &Premises) -> Continued {
        if !self.derivation.is_angle(leaf.symbol) || !may_leap(&self.graph, e) {
            return Continued::No;
        }
        let node = self.graph.leaf(leaf);
        let roots = sides(equations)
            .chain(sides(&premises.equations))
            .chain(premises.nonzero.iter().chain(&premises.positive).chain(&premises.not_negative).copied());
        let bare = self.tells_turns(roots, node);
        let scope = &self.claim.scope;
        let (true, Some(time)) = (bare, scope.time()) else { return Continued::No };
        let moves = |leaf: Leaf| scope.moves(&leaf);
        match self.graph.time_derivative(e, time, moves) {
            Ok(rate) => Continued::Rate(self.graph.continued(e, rate)),
            Err(_) => Continued::Unknown,
        }
    }

    /// Whether whole turns of an angle change a formula: it stands elsewhere than in sums and whole multiples below a sine, a
    /// cosine or a tangent.
    fn tells_turns(&self, roots: impl Iterator<Item = Expr>, angle: Expr) -> bool {
        let whole = |e: Expr| self.graph.as_constant(e).is_some_and(|r| r.denominator().is_one());
        let mut seen: FastSet<(Expr, bool)> = FastSet::default();
        let mut open: Vec<(Expr, bool)> = roots.map(|e| (e, false)).collect();
        while let Some((e, periodic)) = open.pop() {
            if !seen.insert((e, periodic)) {
                continue;
            }
            if e == angle && !periodic {
                return true;
            }
            match *self.graph.node(e) {
                Node::Unary(Op::Sin | Op::Cos | Op::Tan, a) => open.push((a, true)),
                Node::Unary(Op::Neg, a) => open.push((a, periodic)),
                Node::Binary(Op::Add | Op::Sub, a, b) => open.extend([(a, periodic), (b, periodic)]),
                Node::Binary(Op::Mul, a, b) => open.extend([(a, periodic && whole(b)), (b, periodic && whole(a))]),
                Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => {
                    open.extend(self.graph.node(e).children().map(|child| (child, false)));
                }
            }
        }
        false
    }

    /// The values at fixed times that occur obey the definitions at these times.
    fn definitions_at_instants(&mut self, equations: &Pairs, which: Definitions, premises: &mut Premises) {
        let roots: Vec<Expr> = sides(equations)
            .chain(sides(&premises.equations))
            .chain(premises.nonzero.iter().chain(&premises.positive).chain(&premises.not_negative).copied())
            .collect();
        let which = match which {
            Definitions::Now => return,
            Definitions::Then => Definitions::All,
            other => other,
        };
        let scope = &self.claim.scope;
        let mut open: Vec<Leaf> = self.graph.leaves_within(roots);
        open.retain(|l| l.instant.is_some());
        let mut seen: Vec<Leaf> = Vec::new();
        while let Some(leaf) = open.pop() {
            let (Some(instant), false) = (leaf.instant, seen.contains(&leaf)) else { continue };
            seen.push(leaf);
            if leaf.rate > 0 {
                continue;
            }
            if let Some(e) = self.definition(Leaf { instant: None, ..leaf }, which) {
                if self.derivation.is_angle(leaf.symbol) && may_leap(&self.graph, e) {
                    self.loosened = true;
                    continue;
                }
                let then = at_instant(&mut self.graph, scope, e, instant);
                open.extend(self.graph.leaves_within([then]));
                let node = self.graph.leaf(leaf);
                premises.equations.push((node, then));
            }
        }
    }

    /// Premises with every choice of factors of the equations `product = 0` among them and their derivatives.
    pub(super) fn cases(&mut self, premises: &Premises) -> Vec<Premises> {
        let (mut open, mut done) = (vec![premises.clone()], Vec::new());
        while let Some(case) = open.pop() {
            if open.len() + done.len() > MOST_CASES {
                return vec![premises.clone()];
            }
            match self.factors_of_one(&case) {
                None => done.push(case),
                Some(factors) => {
                    let zero = self.graph.integer(0);
                    let case = self.of_one_time(case);
                    for factor in factors.into_iter().rev() {
                        let mut one = case.clone();
                        // First, so that it is solved first.
                        one.equations.insert(0, (factor, zero));
                        open.push(one);
                    }
                }
            }
        }
        done
    }

    /// Premises without what they say of fixed times: another factor may vanish there.
    pub(super) fn of_one_time(&self, mut case: Premises) -> Premises {
        let graph = &self.graph;
        let now = |e: &Expr| graph.leaves_within([*e]).iter().all(|leaf| leaf.instant.is_none());
        case.equations.retain(|(l, r)| now(l) && now(r));
        for facts in [&mut case.nonzero, &mut case.positive, &mut case.not_negative] {
            facts.retain(now);
        }
        case
    }

    /// The factors of the first premise, or derivative of one, that is a product and has no factor among the premises yet.
    fn factors_of_one(&mut self, case: &Premises) -> Option<Vec<Expr>> {
        let time = case.time?;
        for at in 0..case.equations.len() {
            let (l, r) = case.equations[at];
            let residual = self.graph.sub(l, r);
            let rate = self.graph.time_derivative(residual, time, |l| case.moving.contains(&l.symbol));
            for e in [Some(residual), rate.ok()].into_iter().flatten() {
                let bases = bases(&self.graph, e);
                let product = bases.len() > 1;
                let settled = |b: &Expr| case.equations.iter().any(|&(l, r)| l == *b && self.graph.is_zero(r));
                if bases.iter().any(settled) {
                    continue;
                }
                let moving = |b: &Expr| self.graph.leaves_within([*b]).iter().any(|l| case.moving.contains(&l.symbol));
                let bases: Vec<Expr> = bases.into_iter().filter(|b| !case.nonzero.contains(b)).collect();
                if product && bases.iter().any(moving) {
                    return Some(bases);
                }
            }
        }
        None
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

/// Whether something is never negative where it has a value, by its structure.
fn is_sum_of_squares(graph: &Graph, e: Expr) -> bool {
    match *graph.node(e) {
        Node::Constant(_) => graph.as_constant(e).is_some_and(|r| *r >= Rational::ZERO),
        Node::Unary(Op::Powi(n), _) if n % 2 == 0 => true,
        Node::Unary(Op::Sqrt | Op::Abs | Op::Exp, _) => true,
        Node::Unary(Op::Powi(_), a) => is_sum_of_squares(graph, a),
        Node::Binary(Op::Mul, a, b) if a == b => true,
        Node::Binary(Op::Add | Op::Mul | Op::Div, a, b) => is_sum_of_squares(graph, a) && is_sum_of_squares(graph, b),
        Node::Pi => true,
        Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => false,
    }
}

/// The factors of a product, by its structure; powers and quotients are taken apart.
fn bases(graph: &Graph, e: Expr) -> Vec<Expr> {
    let mut out = Vec::new();
    let mut stack = vec![e];
    while let Some(e) = stack.pop() {
        match *graph.node(e) {
            Node::Constant(_) => {}
            Node::Unary(Op::Neg, a) => stack.push(a),
            Node::Unary(Op::Powi(n), a) if n > 0 => stack.push(a),
            Node::Binary(Op::Mul, a, b) => stack.extend([b, a]),
            Node::Binary(Op::Div, a, _) => stack.push(a),
            _ if out.contains(&e) => {}
            _ => out.push(e),
        }
    }
    out
}
