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
use super::valued::Valued;
use super::{LEFT_OUT_NODES, Pairs, Step, pairs};
use crate::derivation::{Claim, Form};
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
            // What a field is taken at chooses nothing.
            let leaves = self.graph.leaves(pairs(relation).flat_map(|(l, r)| [l, r]));
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

    /// The needs that systems meet: what they need themselves, and divide by.
    pub(super) fn values(&mut self) -> Valued {
        let of_systems = self.sides_of_systems();
        let traced: Vec<Expr> = of_systems.into_iter().map(|e| traced(&mut self.graph, &self.claim.scope, e)).collect();
        let needed = self.graph.implied_below(traced).iter().map(|n| (n.value, n.sign)).collect();
        Valued { needed, divided: self.divided_by_systems(), found: FastMap::default() }
    }

    /// An expression with the formulas that stand behind its names, in one scope after the other.
    pub(super) fn written_out(&mut self, e: Expr, scopes: &[&Scope]) -> Expr {
        scopes.iter().fold(e, |e, scope| {
            let e = behind_rates(&mut self.graph, scope, e);
            traced(&mut self.graph, scope, e)
        })
    }

    /// When something has a value, by the signs that hold at all times. What is typed is given of all times.
    pub(super) fn has_value(&mut self, e: Expr, scopes: &[&Scope], values: &mut Valued, throughout: &Premises) -> When {
        if self.inequalities == When::Always {
            return When::Always;
        }
        let known = || Gathered { throughout: throughout.clone(), ..Gathered::default() };
        // What is known of an observable is not seen in its formula.
        let as_written = if throughout.nonzero.is_empty() { Vec::new() } else { self.graph.needs_below([e]) };
        for need in as_written.into_iter().filter(|need| need.sign == Sign::NotZero) {
            if self.never_vanishes(need.value, &known()) {
                let behind = scopes.iter().fold(need.value, |value, scope| traced(&mut self.graph, scope, value));
                values.found.insert((behind, Sign::NotZero), When::Always);
            }
        }
        let e = self.written_out(e, scopes);
        let mut when = When::Always;
        for need in self.graph.needs_below([e]) {
            let key = (need.value, need.sign);
            let one = match values.found.get(&key) {
                Some(&one) => one,
                None => {
                    let squares = is_never_negative(&self.graph, need.value);
                    let met = !self.depends(need.value)
                        || values.needed.contains(&key)
                        || need.sign == Sign::NotZero && values.divided.contains(&need.value)
                        || need.sign == Sign::NotNegative && squares
                        || need.sign != Sign::NotNegative
                            && self.never_vanishes(need.value, &known())
                            && (squares || need.sign == Sign::NotZero)
                        || throughout.positive.contains(&need.value);
                    match (met, need.sign) {
                        (true, _) => When::Always,
                        (false, Sign::NotNegative) => When::Chosen,
                        (false, Sign::Positive | Sign::NotZero) => When::ChosenOpen,
                    }
                }
            };
            values.found.insert(key, one);
            when = when.and(one);
        }
        when
    }

    /// The signs that the claims which are given say of all times: those of which both sides have values at all times. What one of them says
    /// may give another one its values.
    pub(super) fn signs_of_premises(&mut self, values: &mut Valued) -> Premises {
        let mut open: Vec<(&Scope, &Relation)> = Vec::new();
        for premise in self.claims_named() {
            // What it says under assumptions it may say at some times only.
            if self.inequalities == When::Always || premise.assuming.is_empty() {
                let signs = self.said(premise).map(|(_, signs)| signs).unwrap_or_default();
                open.extend(signs.into_iter().map(|relation| (&premise.scope, relation)));
            }
        }
        let mut out = Premises::default();
        loop {
            let before = open.len();
            for (scope, relation) in std::mem::take(&mut open) {
                // What was not met by fewer signs is asked again.
                values.found.retain(|_, when| *when == When::Always);
                match self.relation_has_values(scope, relation, values, &out) {
                    When::Always => self.give(relation, When::Always, &mut out),
                    _ => open.push((scope, relation)),
                }
            }
            if open.is_empty() || open.len() == before {
                values.found.retain(|_, when| *when == When::Always);
                return out;
            }
        }
    }

    /// Drops the rates of first integrals that may have values at single times: nothing is said of their rates there. Whether none was.
    pub(super) fn drop_rates_at_edges(
        &mut self,
        of: &Claim,
        equations: &mut Pairs,
        values: &mut Valued,
        (premises, throughout): (&Premises, &Premises),
    ) -> bool {
        let mut whole = true;
        for form in &of.forms {
            let Form::FirstIntegral(w) = form else { continue };
            for &e in &w.value.components {
                let scopes = [&of.scope, &self.claim.scope];
                let when = self.has_value(e, &scopes, values, throughout);
                if when == When::Chosen && !self.is_positive_inside((e, e), &scopes, premises) {
                    let rate = self.constancy(&of.scope, e);
                    equations.retain(|pair| Some(*pair) != rate);
                    whole = false;
                }
            }
        }
        whole
    }

    /// When both sides of a relation have values.
    pub(super) fn relation_has_values(
        &mut self,
        scope: &Scope,
        relation: &Relation,
        values: &mut Valued,
        throughout: &Premises,
    ) -> When {
        let scopes = [scope, &self.claim.scope];
        let both: Pairs = pairs(relation).collect();
        sides(&both).fold(When::Always, |when, e| when.and(self.has_value(e, &scopes, values, throughout)))
    }

    /// What a claim says, and what is assumed, is said where it has a value: that may be at some times only, and single ones among them,
    /// if it ends there. What is typed is given of all times. Whether a point that satisfies the equations may refute: at a single time
    /// nothing is known of rates, and of other times and places, but where there is a motion it binds them.
    pub(super) fn where_they_have_values(
        &mut self,
        premises: &mut Premises,
        assumed: usize,
        always: &mut [(&Scope, Pairs)],
        (values, throughout): (&mut Valued, &Premises),
    ) -> bool {
        if self.inequalities == When::Always {
            return true;
        }
        let claim = self.claim;
        // Many premises have the names of the file and none of their own: to write these out for each of many takes the square of them.
        let mut scopes: Vec<&Scope> = Vec::new();
        for scope in always.iter().map(|(scope, _)| *scope).chain([&claim.scope]) {
            if !scopes.iter().any(|known| known.has_names_of(scope)) {
                scopes.push(scope);
            }
        }
        let mut of_pairs: Vec<((Expr, Expr), When)> = Vec::new();
        let mut whole = true;
        for at in 0..premises.equations.len() {
            let pair = premises.equations[at].sides();
            let mut when = When::Always;
            for e in [pair.0, pair.1] {
                when = when.and(self.has_value(e, &scopes, values, throughout));
            }
            if when == When::Chosen && self.is_positive_inside(pair, &scopes, premises) {
                when = When::ChosenOpen;
            }
            whole &= when != When::Chosen;
            premises.equations[at].when = premises.equations[at].when.and(when);
            if at < assumed {
                premises.present = premises.present.and(when);
            }
            of_pairs.push((pair, when));
        }
        for (_, list) in always {
            list.retain(|pair| of_pairs.iter().all(|(of, when)| of != pair || *when == When::Always));
        }
        whole || !self.names_more_than_one_time(premises)
    }

    /// Whether what must not be negative is positive at the times that count: then it is so around them.
    fn is_positive_inside(&mut self, pair: (Expr, Expr), scopes: &[&Scope], premises: &Premises) -> bool {
        [pair.0, pair.1].into_iter().all(|e| {
            let e = self.written_out(e, scopes);
            let needs = self.graph.needs_below([e]);
            let open = |n: &Expr| premises.positive.contains(n) || !self.depends(*n);
            needs.iter().filter(|n| n.sign == Sign::NotNegative).all(|n| open(&n.value))
        })
    }

    /// Whether the claim, or what is given, names rates, fixed times or fields.
    fn names_more_than_one_time(&mut self, premises: &Premises) -> bool {
        let own = self.equations(self.claim).unwrap_or_default();
        let roots: Vec<Expr> = sides(&own).chain(premises.sides()).collect();
        let more = |l: &Leaf| l.rate > 0 || l.instant.is_some() || self.graph.is_field(l.symbol);
        self.graph.leaves_within(roots).iter().any(more)
    }

    /// Where the formulas of the observables that occur have edges: their rates need not exist there, whether their definitions are used
    /// or not.
    pub(super) fn add_edges(&mut self, equations: &Pairs, premises: &mut Premises) {
        let facts = premises.signs();
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
