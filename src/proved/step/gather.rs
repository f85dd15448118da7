//! What a step may use: the claims and systems that it names, assumptions, definitions.

use super::definitions::Definitions;
use super::{LEFT_OUT_NODES, MOST_CASES, Pairs, Step, now, pairs};
use crate::derivation::{Claim, Derivation, Form, Premise, Written};
use crate::expr::{Expr, Graph, Leaf, Node, Op};
use crate::latex::{Relation, RelationKind, Role, Scope, Statement};
use claim::comparison::at_instant;
use proof::{Identity, Options, Premises, Reason, Wanted, When, solve_for_arguments};

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
    /// When all of it is known.
    pub(super) known: When,
    /// When what is so at the times that count may be used: also between them, if none is left out, or motions are analytic.
    pub(super) lasting: When,
    /// The names.
    pub(super) from: Vec<String>,
    /// Whether all could be used: a refutation needs that.
    pub(super) complete: bool,
}

pub(super) fn sides(pairs: &[(Expr, Expr)]) -> impl Iterator<Item = Expr> + '_ {
    pairs.iter().flat_map(|&(l, r)| [l, r])
}
/// Always, or at the times that a claim chooses.
fn always_if(all: bool) -> When {
    if all { When::Always } else { When::Chosen }
}

impl<'a> Step<'a> {
    /// The rate of a first integral as an equation `… = 0`: it says nothing where the integral has no value.
    pub(super) fn constancy(&mut self, scope: &Scope, e: Expr) -> Option<(Expr, Expr)> {
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
    pub(super) fn said<'c>(&mut self, claim: &'c Claim) -> Option<(Pairs, Vec<&'c Relation>)> {
        let (mut out, mut signs) = (Vec::new(), Vec::new());
        // What another claim says over a box says nothing beyond.
        if claim.at.is_some() || claim.is_over_ranges() && !std::ptr::eq(claim, self.claim) {
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
                        // A sign of another claim is not known, nor what an inequality over a box is beyond.
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
    pub(super) fn give(&mut self, relation: &Relation, when: When, premises: &mut Premises) {
        for (l, r) in self.scalars(relation) {
            match relation.kind {
                RelationKind::Equal => premises.give([(l, r)], when),
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
    /// `when` are the times that the claim chooses. At single ones nothing is known of the rates of what is assumed there, and a point that
    /// refutes may belong to no such time. What is about constants is known always.
    pub(super) fn assume(&mut self, claim: &Claim, without: &[usize], when: When, premises: &mut Premises) -> bool {
        let used = claim.assuming.iter().enumerate().filter(|(i, _)| !without.contains(i));
        let mut complete = true;
        let before = premises.equations.len();
        for relation in used.flat_map(|(_, w)| &w.value.relations) {
            if relation.limit.is_some() || relation.chooses_sign() && self.sign.is_none() {
                complete = false;
                continue;
            }
            self.give(relation, when, premises);
        }
        let places = self.places_chosen(claim, without);
        complete & self.restrict(before, [when, places], premises)
    }

    /// What `follows-from` and the assumptions give; `without` some assumptions.
    pub(super) fn gather(&mut self, without: Option<&[usize]>) -> Gathered {
        let (derivation, claim) = (self.derivation, self.claim);
        let mut out = Gathered { complete: !Step::lacks_systems(self.derivation, self.claim), ..Gathered::default() };
        let mut premises = Premises::default();
        self.roles(&mut premises);
        let mut values = self.values();
        let of_premises = self.signs_of_premises(&mut values);
        let absent = without.unwrap_or(&[]);
        let chosen = self.times_chosen(claim, absent);
        out.complete &= self.assume(claim, absent, chosen, &mut premises);
        let mut throughout = of_premises.clone();
        let places = self.places_chosen(claim, absent);
        self.signs_throughout(&premises, places, &mut throughout);
        premises.present = chosen.and(places);
        // Each with the scope that says what moves in it.
        let mut always: Vec<(&Scope, Pairs)> = Vec::new();
        out.known = always_if(self.inequalities == When::Always || self.choosing(claim, absent).is_empty());
        out.lasting = always_if(self.goes_on(claim, absent));
        let own: Pairs = premises.pairs().collect();
        if self.is_known_elsewhere(claim, absent, &own) {
            // What is so for a while goes on.
            if chosen == When::ChosenOpen {
                premises.equations.iter_mut().filter(|k| self.moves(k.left) || self.moves(k.right)).for_each(|k| {
                    k.when = When::Always;
                });
            }
            always.push((&claim.scope, own));
        }
        let assumed = premises.equations.len();
        let mut constant = self.constants(&mut values, &throughout);
        let known: Pairs = self.about_constants(claim, absent, &constant);
        if out.known != When::Always {
            always.push((&claim.scope, known));
        }
        let mut given: Vec<&Claim> = Vec::new();
        for name in Step::given(derivation, claim) {
            out.from.push(name.clone());
            let premise = match derivation.premise(&name) {
                Premise::System(system) => {
                    out.systems.extend(self.equations_of(system));
                    continue;
                }
                Premise::Claim(claim) if !self.left_out.contains(&claim) => &derivation.claims[claim],
                Premise::Claim(_) | Premise::Definition => continue,
            };
            let mut at_others = true;
            let times = self.times_chosen(premise, &[]);
            let mut when = times;
            // What is assumed of constants holds always, if it holds at the present.
            let of_constants =
                |w: &Written<Statement>| w.value.relations.iter().all(|r| self.is_about_constants(r, &constant));
            if !premise.assuming.iter().all(of_constants) {
                when = when.and(chosen);
            }
            let places = self.places_chosen(premise, &[]);
            // At single times an integral says nothing of its rate.
            let integral = premise.states_integral();
            let is_said = !integral || times.is_on_intervals();
            match self.said(premise).filter(|_| is_said) {
                Some((equations, signs)) => {
                    let mut equations = self.without_branches(premise, equations, &mut out.complete);
                    out.complete &=
                        self.drop_rates_at_edges(premise, &mut equations, &mut values, (&premises, &throughout));
                    let before = premises.equations.len();
                    premises.give(equations.iter().copied(), when);
                    out.complete &= self.restrict(before, [when, places], &mut premises);
                    // What it assumes is known at other times if it is assumed here of all of them.
                    let of_constants = |w: &Written<Statement>| {
                        w.value.relations.iter().all(|r| self.is_about_constants(r, &constant))
                    };
                    at_others = premise.assuming.iter().all(of_constants)
                        || self.is_known_elsewhere(premise, &[], &equations)
                            && self.is_known_elsewhere(claim, absent, &equations);
                    for k in premises.equations[before..].iter_mut().filter(|k| at_others && k.when == When::ChosenOpen)
                    {
                        k.when = if self.moves(k.left) || self.moves(k.right) { places } else { k.when };
                    }
                    out.known = out.known.and(always_if(at_others));
                    out.lasting = out.lasting.and(always_if(at_others));
                    for form in &premise.forms {
                        let Form::FirstIntegral(w) = form else { continue };
                        for &e in &w.value.components {
                            let when = self.has_value(e, &[&premise.scope, &claim.scope], &mut values, &throughout);
                            if at_others && when == When::Always {
                                constant.push((&premise.scope, e));
                            }
                        }
                    }
                    always.extend(at_others.then_some((&premise.scope, equations)));
                    // What it says under assumptions it may say at some times only.
                    let of_all_times = self.inequalities == When::Always || premise.assuming.is_empty();
                    for relation in signs {
                        let has_value = self.relation_has_values(&premise.scope, relation, &mut values, &throughout);
                        out.lasting = out.lasting.and(always_if(of_all_times && has_value == When::Always));
                        out.known = out.known.and(has_value);
                        self.give(relation, when, &mut premises);
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
            out.complete &= self.assume(premise, &numbers, when, &mut premises);
            let assumed: Pairs = premises.equations[before..].iter().map(proof::Known::sides).collect();
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
        out.throughout = of_premises;
        self.signs_throughout(&premises, places, &mut out.throughout);
        out.complete &=
            self.where_they_have_values(&mut premises, assumed, &mut always, (&mut values, &out.throughout));
        let moving = |k: &&proof::Known| self.moves(k.left) || self.moves(k.right);
        let moving = premises.equations.iter().filter(moving).map(|k| k.when);
        out.known = moving.fold(out.known.and(chosen), When::and);
        out.throughout.give(always.iter().flat_map(|(_, pairs)| pairs.iter().copied()), When::Always);
        for instant in self.instants_with_values(claim, absent) {
            self.give_at(instant, claim, absent, &mut premises);
        }
        self.at_instants(&always, &constant, &out.throughout, &mut premises);
        out.premises = premises;
        out
    }

    /// Adds what a claim assumes at a fixed time that it chooses.
    fn give_at(&mut self, instant: Expr, claim: &Claim, without: &[usize], premises: &mut Premises) {
        let mut then = Premises::default();
        self.assume(claim, without, When::Chosen, &mut then);
        let graph = &mut self.graph;
        let mut at = |e: Expr| at_instant(graph, &claim.scope, e, instant);
        let pairs: Pairs = then.pairs().map(|(l, r)| (at(l), at(r))).filter(|(l, r)| l != r).collect();
        premises.give(pairs, When::Always);
        premises.nonzero.extend(then.nonzero.into_iter().map(&mut at));
        premises.positive.extend(then.positive.into_iter().map(&mut at));
        premises.not_negative.extend(then.not_negative.into_iter().map(&mut at));
    }

    /// Adds to the signs that hold at all times and places those of what does not move, and, where places are chosen, of what names none;
    /// all of them, if what is assumed is assumed of all.
    fn signs_throughout(&self, premises: &Premises, places: When, throughout: &mut Premises) {
        let (scope, graph) = (&self.claim.scope, &self.graph);
        let moves = |l: &Leaf| l.instant.is_none() && (scope.moves(l) || Some(*l) == scope.time());
        let of_places = |l: &Leaf| graph.is_field(l.symbol) || graph.coordinate(*l).is_some();
        let holds = |e: &&Expr| {
            let named = graph.leaves_within([**e]);
            (self.inequalities == When::Always || !named.iter().any(moves))
                && (places == When::Always || !named.iter().any(of_places))
        };
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
        // At some time: nothing is said of its rate.
        premises.give([(e, zero)], When::Chosen);
        let used = self.in_part.len();
        self.definitions(&Pairs::new(), &[], Definitions::All, &mut premises);
        self.in_part.truncate(used);
        self.add_positive_parameters(&Pairs::new(), &mut premises);
        let options = Options { attempts: 1, most_nodes: LEFT_OUT_NODES, wanted: Wanted::Fault, ..Options::default() };
        let found = self.test_only(&premises, &vec![(zero, one)], &options);
        matches!(found, Identity::Undecided(Reason::Contradiction))
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
        roots.extend(premises.signs());
        let own = self.equations(self.claim).unwrap_or_default();
        roots.extend(sides(&own));
        let mut instants: Vec<Expr> = self.graph.leaves_within(roots).into_iter().filter_map(|l| l.instant).collect();
        instants.sort_unstable();
        instants.dedup();
        for &instant in &instants {
            for &(scope, e) in constant {
                let then = at_instant(&mut self.graph, scope, e, instant);
                premises.give([(e, then)], When::Always);
            }
            for (scope, list) in always {
                for &(l, r) in list {
                    if self.graph.leaves_within([l, r]).iter().any(|l| l.rate > 0) {
                        continue;
                    }
                    let then = [l, r].map(|e| at_instant(&mut self.graph, scope, e, instant));
                    if then != [l, r] && then[0] != then[1] && !premises.says((then[0], then[1])) {
                        premises.give([(then[0], then[1])], When::Always);
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
    pub(super) fn roles(&mut self, premises: &mut Premises) {
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
        self.add_edges(equations, &mut premises);
        premises
    }

    /// What is positive among the parameters that occur.
    pub(super) fn add_positive_parameters(&mut self, equations: &Pairs, premises: &mut Premises) {
        let roots: Vec<Expr> = sides(equations).chain(premises.sides()).chain(premises.signs()).collect();
        for leaf in self.graph.leaves_within(roots) {
            if self.is_positive_parameter(leaf) {
                let node = self.graph.leaf(leaf);
                premises.positive.push(node);
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
                        one.equations.insert(0, proof::Known::of((factor, zero), When::ChosenOpen));
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
        case.equations.retain(|k| now(&k.left) && now(&k.right));
        for facts in [&mut case.nonzero, &mut case.positive, &mut case.not_negative] {
            facts.retain(now);
        }
        case
    }

    /// The factors of the first premise, or derivative of one, that is a product and has no factor among the premises yet.
    fn factors_of_one(&mut self, case: &Premises) -> Option<Vec<Expr>> {
        let time = case.time?;
        for at in 0..case.equations.len() {
            let (l, r) = case.equations[at].sides();
            if !case.equations[at].when.is_on_intervals() {
                continue;
            }
            let residual = self.graph.sub(l, r);
            let rate = self.graph.time_derivative(residual, time, |l| case.moving.contains(&l.symbol));
            for e in [Some(residual), rate.ok()].into_iter().flatten() {
                let bases = bases(&self.graph, e);
                let product = bases.len() > 1;
                let settled = |b: &Expr| case.pairs().any(|(l, r)| l == *b && self.graph.is_zero(r));
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

/// The factors of a product, by its structure, but numbers that are not 0; powers and quotients are taken apart.
fn bases(graph: &Graph, e: Expr) -> Vec<Expr> {
    let mut out = Vec::new();
    let mut stack = vec![e];
    while let Some(e) = stack.pop() {
        match *graph.node(e) {
            Node::Constant(_) if !graph.is_zero(e) => {}
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
