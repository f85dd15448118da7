//! What is given, as conditions in which nothing that is defined is left.
//!
//! **In:** a claim, and what it is said to follow from. **Out:** whether it is a system that has a motion; whether all of it is so at rest.
//! **Guaranteed:** nothing given is left out; a point is an exact one, see [`proof`].

use crate::derivation::{Claim, Derivation};
use crate::expr::domain::Sign;
use crate::expr::{Expr, FastSet, Graph, Leaf, Node, Partials, Rational, Shape, Symbol};
use crate::latex::{Relation, RelationKind, Role, Scope};
use crate::said::{Sayings, is_so};
use claim::system::VectorField;
use proof::{Identity, Options, Premises, When, identity_test};

/// Rounds in which rates at the start are formed from those of the system.
const MOST_ORDER: usize = 4;

/// Most components of fields for which formulas are tried.
const MOST_FIELDS: usize = 3;

/// A relation between components.
type Condition = (RelationKind, Expr, Expr);

#[derive(Clone)]
pub(super) struct Given<'a> {
    derivation: &'a Derivation,
    claim: &'a Claim,
    said: &'a Sayings<'a>,
    graph: Graph,
    conditions: Vec<Condition>,
    /// Of these the ones that choose places, or are about numbers alone: a whole relation of coordinates is no law of all places.
    choosing: Vec<Condition>,
    /// What must be so where the claim is to have values.
    valued: Vec<Condition>,
    /// What must be so where what is given is to have values, whatever becomes of it when formulas are put in.
    needed: Vec<Condition>,
    /// What must be so besides, near a point of a motion.
    domain: Vec<Condition>,
}

impl<'a> Given<'a> {
    /// Nothing where something given is no relation of each time. Of ± the upper sign is taken; what chooses times is to be so on an interval.
    pub(super) fn of(derivation: &'a Derivation, claim: &'a Claim, said: &'a Sayings<'a>) -> Option<Given<'a>> {
        let graph = derivation.graph.clone();
        let [conditions, choosing, valued, needed, domain] = [const { Vec::new() }; 5];
        let mut out = Given { derivation, claim, said, graph, conditions, choosing, valued, needed, domain };
        out.valued = out.values_of(&said.claimed.formulas);
        // What is given has values where the times and places that it names have.
        let placed = out.graph.placed_below(said.given.formulas.iter().copied());
        let places = out.values_of(&placed);
        out.valued.extend(places);
        for written in out.written_out(said.relations()?)? {
            let is_of_numbers = |given: &Self, c: &Condition| given.named(&[*c]).is_empty();
            let chooses = written.iter().all(|c| out.is_of_places(c) || is_of_numbers(&out, c));
            let (choosing, laws): (Vec<Condition>, Vec<Condition>) =
                written.into_iter().partition(|c| chooses || is_of_numbers(&out, c));
            out.conditions.extend(laws);
            out.choosing.extend(choosing);
        }
        let all = out.conditions.iter().chain(&out.choosing);
        let sides: Vec<Expr> = all.flat_map(|&(_, l, r)| [l, r]).collect();
        out.needed = out.values_of(&sides);
        let all = [&out.conditions, &out.choosing, &out.valued, &out.needed].into_iter().flatten();
        let is_open = out.graph.leaves_within(all.flat_map(|&(_, l, r)| [l, r])).iter().any(|l| out.is_defined(l));
        (!is_open).then_some(out)
    }

    /// Whether it names coordinates, and nothing else that is no number.
    fn is_of_places(&self, condition: &Condition) -> bool {
        let named = self.named(&[*condition]);
        !named.is_empty() && named.iter().all(|leaf| self.graph.coordinate(*leaf).is_some())
    }

    /// Whether it has a formula: then its rate could not be formed.
    fn is_defined(&self, leaf: &Leaf) -> bool {
        self.claim.scope.definition(leaf.symbol).is_some()
    }

    /// Each relation, by components.
    fn written_out(&mut self, relations: &[(&'a Relation, &'a Scope)]) -> Option<Vec<Vec<Condition>>> {
        let graph = &mut self.graph;
        let mut out = Vec::new();
        for (relation, scope) in relations {
            let sign = scope.branch_sign();
            if relation.limit.is_some() {
                return None;
            }
            let sides = relation.left.components.iter().zip(&relation.right.components);
            let components = sides.map(|(&l, &r)| {
                let [l, r] = [l, r].map(|side| {
                    let side = written(graph, scope, side);
                    graph.replaced(side, |graph, leaf| (leaf == sign).then(|| graph.integer(1)))
                });
                (relation.kind, l, r)
            });
            out.push(components.collect());
        }
        Some(out)
    }

    /// What conditions name but parameters.
    fn named(&self, conditions: &[Condition]) -> Vec<Leaf> {
        let mut leaves = self.graph.leaves_within(conditions.iter().flat_map(|&(_, l, r)| [l, r]));
        leaves.retain(|leaf| self.claim.scope.role(leaf.symbol) != Some(Role::Parameter));
        leaves
    }

    /// Whether the claim has values by what is so at several times or places: these may be one, as far as a point shows.
    pub(super) fn is_between(&self) -> bool {
        let leaves = self.named(&self.valued);
        let instants: FastSet<Expr> = leaves.iter().filter_map(|l| l.instant).collect();
        let mut places = leaves.iter().filter(|l| self.graph.is_field(l.symbol));
        let place = |l: &Leaf| self.graph.place(l.symbol).map(|place| &place.at);
        let first = places.next().map(place);
        instants.len() > 1 || places.any(|l| Some(place(l)) != first)
    }

    /// Whether a law becomes an equation of coordinates, once formulas are put in: that would have to be so at all places.
    pub(super) fn holds_at_some_places(mut self) -> bool {
        self.insert_formulas().is_some() && self.conditions.iter().any(|c| self.is_of_places(c))
    }

    /// Whether it is a system that is solved for its rates, and formulas, with values at one fixed time, if there are any, from which a motion
    /// begins on which the claim has values; or numbers alone.
    pub(super) fn has_solution(&mut self) -> bool {
        // A proof has a point of its own, at which what is defined may have any value.
        let formulas = self.said.claimed.formulas.iter().chain(&self.said.given.formulas).copied();
        let names_defined = self.graph.leaves_within(formulas).iter().any(|l| self.is_defined(l));
        if self.conditions.is_empty() && self.named(&self.choosing).is_empty() && !names_defined {
            return true;
        }
        // At the beginning, and strictly: then for a while. What is so at a fixed time is so.
        let is_fixed = |given: &Self, c: &Condition| given.named(&[*c]).iter().all(|leaf| leaf.instant.is_some());
        for (kind, l, r) in std::mem::take(&mut self.needed) {
            let kind = if is_fixed(self, &(kind, l, r)) { kind } else { strict(kind) };
            self.domain.push((kind, l, r));
        }
        // What becomes an equation of coordinates is no law of all places.
        if self.insert_formulas().is_none() || self.conditions.iter().any(|c| self.is_of_places(c)) {
            return false;
        }
        let (mut starts, moving): (Vec<Condition>, Vec<Condition>) = self
            .conditions
            .iter()
            .partition(|condition| self.named(&[**condition]).iter().all(|leaf| leaf.instant.is_some()));
        starts.append(&mut self.choosing);
        let is_of_places = |l: &Leaf| self.graph.is_field(l.symbol) || self.graph.coordinate(*l).is_some();
        let is_state = |l: &Leaf| l.instant.is_none() && l.partials == Partials::NONE && !is_of_places(l);
        if !self.named(&moving).iter().all(is_state) {
            return false;
        }
        let (moving, inequalities): (Vec<Condition>, Vec<Condition>) =
            moving.into_iter().partition(|(kind, ..)| *kind == RelationKind::Equal);
        // What is so at the beginning, and strictly, is so for a while.
        self.domain.extend(inequalities.into_iter().map(|(kind, l, r)| (strict(kind), l, r)));
        let equations: Vec<(Expr, Expr)> = moving.iter().map(|&(_, l, r)| (l, r)).collect();
        let mut states: Vec<Symbol> = self.named(&moving).iter().filter(|l| l.rate > 0).map(|l| l.symbol).collect();
        states.sort_unstable();
        states.dedup();
        let time = self.claim.scope.time();
        let Ok(field) = VectorField::solve(&mut self.graph, time, &states, &equations) else { return false };
        self.add_domain(field.rates());
        // An equation says nothing of rates that cancel, and has values where they have.
        self.add_domain(&equations.iter().flat_map(|&(l, r)| [l, r]).collect::<Vec<_>>());
        self.begins(&field, starts)
    }

    /// Whether a motion of a system begins with some values.
    fn begins(&mut self, field: &VectorField, mut starts: Vec<Condition>) -> bool {
        let [of_claim, of_given] = [&self.said.claimed, &self.said.given].map(|said| said.instants(self.derivation));
        let named = of_claim.union(&of_given).count();
        // A motion begins at one time; it need not reach another one, if the system is not linear.
        let reaches = named <= 1 || self.domain.is_empty() && self.is_linear(field);
        let is_local = !self.domain.is_empty();
        if of_given.len() > 1 || !reaches || named == 0 && is_local && self.said.names_a_time(self.derivation) {
            return false;
        }
        let begun = of_given.into_iter().chain(of_claim).next();
        if self.named(&self.valued).iter().any(|l| l.instant.is_some_and(|at| Some(at) != begun)) {
            return false;
        }
        starts.append(&mut self.valued);
        starts.append(&mut self.domain);
        for side in starts.iter_mut().flat_map(|(_, l, r)| [l, r]) {
            let Some(there) = self.at_the_start(field, *side, begun) else { return false };
            *side = there;
        }
        starts.is_empty() || self.has_point(&starts)
    }

    /// Whether the rates of a system are linear in its states, so that its motions go on for ever.
    fn is_linear(&mut self, field: &VectorField) -> bool {
        field.rates().iter().all(|&rate| {
            let states = self.graph.leaves_within([rate]).into_iter().filter(|l| field.states().contains(l));
            states.collect::<Vec<_>>().into_iter().all(|state| {
                let slope = self.graph.slope(rate, state);
                slope.is_ok_and(|slope| !self.graph.leaves_within([slope]).iter().any(|l| field.states().contains(l)))
            })
        })
    }

    /// A formula at the time at which a motion begins, in the states of its system: what they are there is a point.
    fn at_the_start(&mut self, field: &VectorField, e: Expr, begun: Option<Expr>) -> Option<Expr> {
        let (graph, scope) = (&mut self.graph, &self.claim.scope);
        let time = scope.time();
        let mut e =
            graph.replaced(e, |graph, leaf| leaf.instant.is_some().then(|| graph.leaf(Leaf { instant: None, ..leaf })));
        let rates: Vec<(Leaf, Expr)> = field.states().iter().copied().zip(field.rates().iter().copied()).collect();
        // Rates that the system gives, and their rates.
        for _ in 0..MOST_ORDER {
            let mut formed: Vec<(Leaf, Expr)> = Vec::new();
            for leaf in graph.leaves_within([e]) {
                let of = |(state, _): &&(Leaf, Expr)| (state.symbol, state.component) == (leaf.symbol, leaf.component);
                let Some(&(state, rate)) = rates.iter().rfind(of).filter(|_| !field.states().contains(&leaf)) else {
                    continue;
                };
                let mut value = rate;
                for _ in state.rate + 1..leaf.rate {
                    value = graph.time_derivative(value, time?, |leaf| scope.moves(&leaf)).ok()?;
                }
                formed.push((leaf, value));
            }
            if formed.is_empty() {
                return Some(graph.replaced(e, |_, leaf| begun.filter(|_| Some(leaf) == time)));
            }
            e = graph.replaced(e, |_, leaf| formed.iter().find(|(l, _)| *l == leaf).map(|(_, value)| *value));
        }
        None
    }

    /// What must be so where formulas are to have values.
    fn values_of(&mut self, formulas: &[Expr]) -> Vec<Condition> {
        let zero = self.graph.integer(0);
        let scope = &self.claim.scope;
        let written: Vec<Expr> = formulas.iter().map(|&e| written(&mut self.graph, scope, e)).collect();
        let mut out: Vec<Condition> = Vec::new();
        for need in self.graph.needs_below(written) {
            if !is_so(self.derivation, &self.graph, need.value, need.sign) {
                out.push((of_sign(need.sign), need.value, zero));
            }
        }
        out
    }

    /// Inserts the formulas of what moves: x = cos t. Nothing where one of them cannot be inserted.
    fn insert_formulas(&mut self) -> Option<()> {
        while let Some((at, leaf, formula)) = self.formula() {
            self.conditions.swap_remove(at);
            self.add_domain(&[formula]);
            self.insert(leaf, formula)?;
        }
        Some(())
    }

    /// Inserts a formula of what moves; conditions that it meets are left out.
    fn insert(&mut self, leaf: Leaf, formula: Expr) -> Option<()> {
        let Given { graph, claim, conditions, choosing, valued, needed, domain, .. } = self;
        for all in [conditions, choosing, valued, needed, domain] {
            for side in all.iter_mut().flat_map(|(_, l, r)| [l, r]) {
                *side = inserted(graph, &claim.scope, *side, leaf, formula)?;
            }
            all.retain(|&(kind, l, r)| kind != RelationKind::Equal || !is_identity(graph, l, r));
        }
        Some(())
    }

    /// Whether equations of fields alone are met, and the claim has values, by fields that are 0, a number, a coordinate, or half the square of one.
    pub(super) fn has_simple_fields(mut self) -> bool {
        let is_equation = |c: &Condition| c.0 == RelationKind::Equal;
        let mut leaves = self.named(&self.conditions);
        leaves.extend(self.named(&self.choosing));
        let time = self.claim.scope.time();
        let is_of_fields =
            |l: &Leaf| self.graph.is_field(l.symbol) || self.graph.coordinate(*l).is_some() || Some(*l) == time;
        let mut fields: Vec<Leaf> = leaves.iter().filter(|l| self.graph.is_field(l.symbol)).copied().collect();
        for leaf in &mut fields {
            *leaf = Leaf::now(self.graph.field_of(leaf.symbol), leaf.component);
        }
        fields.sort_unstable();
        fields.dedup();
        self.conditions.append(&mut self.choosing);
        let all = self.conditions.iter().all(is_equation) && leaves.iter().all(is_of_fields);
        all && !fields.is_empty() && fields.len() <= MOST_FIELDS && self.is_met_by(&fields)
    }

    fn is_met_by(&mut self, fields: &[Leaf]) -> bool {
        let Some((field, others)) = fields.split_first() else {
            let mut valued = std::mem::take(&mut self.valued);
            valued.append(&mut self.needed);
            return self.conditions.is_empty() && (valued.is_empty() || self.has_point(&valued));
        };
        let graph = &mut self.graph;
        let half = graph.constant(Rational::ONE / Rational::from(2));
        let mut formulas = vec![graph.integer(0), graph.integer(1)];
        for (at, coordinate) in graph.coordinates().collect::<Vec<_>>().into_iter().enumerate() {
            if graph.depends(field.symbol, at) {
                let coordinate = graph.leaf(coordinate);
                let square = graph.powi(coordinate, 2);
                formulas.extend([coordinate, graph.mul(half, square)]);
            }
        }
        formulas.into_iter().any(|formula| {
            let mut tried = self.clone();
            tried.insert(*field, formula).is_some() && tried.is_met_by(others)
        })
    }

    /// Whether it is a number, the same at all times and places.
    fn is_fixed(&self, leaf: Leaf) -> bool {
        self.claim.scope.role(leaf.symbol) == Some(Role::Parameter)
    }

    /// Whether it is a field that depends on no other coordinates than another one.
    fn is_within(&self, leaf: Leaf, field: Symbol) -> bool {
        let graph = &self.graph;
        let only = |at| !graph.depends(leaf.symbol, at) || graph.depends(field, at);
        graph.is_field(leaf.symbol) && (0..graph.coordinates().count()).all(only)
    }

    /// A condition that says what something that moves is, or what a field is, by the coordinates on which it depends.
    fn formula(&self) -> Option<(usize, Leaf, Expr)> {
        let graph = &self.graph;
        self.conditions.iter().enumerate().find_map(|(at, &(kind, l, r))| {
            [(l, r), (r, l)].into_iter().filter(|_| kind == RelationKind::Equal).find_map(|(side, formula)| {
                let Node::Leaf(leaf) = *graph.node(side) else { return None };
                let is_course = leaf == Leaf::now(leaf.symbol, leaf.component)
                    && graph.place(leaf.symbol).is_none()
                    && matches!(self.claim.scope.role(leaf.symbol), Some(Role::State | Role::Field | Role::Observable));
                let within = graph.leaves_within([formula]);
                let itself = within.iter().any(|l| graph.field_of(l.symbol) == leaf.symbol || l.instant.is_some());
                let depends_on = |l: &Leaf| match graph.coordinate(*l) {
                    Some(coordinate) => graph.depends(leaf.symbol, coordinate),
                    None if graph.is_field(leaf.symbol) => self.is_fixed(*l) || self.is_within(*l, leaf.symbol),
                    // What moves is the same at all places.
                    None => !graph.is_field(l.symbol),
                };
                (is_course && within.iter().all(depends_on) && !itself).then_some((at, leaf, formula))
            })
        })
    }

    /// What must be so of a point near which formulas have values, and are smooth; nothing where they always are.
    fn add_domain(&mut self, formulas: &[Expr]) {
        let zero = self.graph.integer(0);
        for node in self.graph.reachable(formulas.iter().copied()) {
            let needs = self.graph.needs(node).into_iter().map(|need| (need.sign, need.value));
            let edges = self.graph.edges(node).into_iter().filter_map(|edge| edge.vanishing);
            for (sign, value) in needs.chain(edges.map(|e| (Sign::NotZero, e))).collect::<Vec<_>>() {
                if !is_so(self.derivation, &self.graph, value, sign) {
                    self.domain.push((strict(of_sign(sign)), value, zero));
                }
            }
        }
    }

    /// Whether all of it is so, and the claim has values, where what moves is at rest: nothing names the time, or a coordinate.
    pub(super) fn has_rest(&mut self) -> bool {
        let mut conditions = std::mem::take(&mut self.conditions);
        conditions.append(&mut self.choosing);
        conditions.append(&mut self.valued);
        conditions.append(&mut self.needed);
        for side in conditions.iter_mut().flat_map(|(_, l, r)| [l, r]) {
            *side = self.graph.replaced(*side, |graph, leaf| {
                let changes = leaf.rate > 0 || leaf.partials != Partials::NONE;
                Some(match changes {
                    true => graph.integer(0),
                    false => graph.leaf(Leaf::now(graph.field_of(leaf.symbol), leaf.component)),
                })
            });
        }
        let time = self.claim.scope.time();
        let moves = |leaf: &Leaf| Some(*leaf) == time || self.graph.coordinate(*leaf).is_some();
        !self.named(&conditions).iter().any(moves) && self.has_point(&conditions)
    }

    /// Whether numbers are found that satisfy conditions.
    fn has_point(&mut self, conditions: &[Condition]) -> bool {
        let graph = &mut self.graph;
        let mut premises = Premises::default();
        // Numbers alone: nothing is known of how they change.
        let mut numbers: Vec<(Leaf, Expr)> = Vec::new();
        for leaf in graph.leaves_within(conditions.iter().flat_map(|&(_, l, r)| [l, r])) {
            let number = graph.declare(&graph.leaf_latex(leaf), Shape::scalar(), false);
            let number = graph.component(number, 0);
            if self.derivation.is_positive_parameter(leaf.symbol) {
                premises.positive.push(number);
            }
            numbers.push((leaf, number));
        }
        for &(kind, l, r) in conditions {
            let mut number = |_: &mut Graph, leaf: Leaf| numbers.iter().find(|(l, _)| *l == leaf).map(|(_, n)| *n);
            let (l, r) = (graph.replaced(l, &mut number), graph.replaced(r, &mut number));
            match kind {
                RelationKind::Equal => premises.give([(l, r)], When::Always),
                RelationKind::NotEqual => premises.nonzero.push(graph.sub(l, r)),
                RelationKind::Greater => premises.positive.push(graph.sub(l, r)),
                RelationKind::Less => premises.positive.push(graph.sub(r, l)),
                RelationKind::GreaterEqual => premises.not_negative.push(graph.sub(l, r)),
                RelationKind::LessEqual => premises.not_negative.push(graph.sub(r, l)),
            }
        }
        let nothing = [(graph.integer(0), graph.integer(1))];
        matches!(identity_test(graph, &nothing, &premises, &Options::default()), Identity::Refuted(_))
    }
}

/// An expression with a formula for a component, its rates and derivatives, at fixed times and at places, too.
fn inserted(graph: &mut Graph, scope: &Scope, e: Expr, course: Leaf, formula: Expr) -> Option<Expr> {
    let mut all: Vec<(Leaf, Expr)> = Vec::new();
    for leaf in graph.leaves_within([e]) {
        if graph.field_of(leaf.symbol) != course.symbol || leaf.component != course.component {
            continue;
        }
        let mut value = formula;
        for by in leaf.partials.steps() {
            value = graph.derivative_by(value, by).ok()?;
        }
        if let Some(place) = graph.place(leaf.symbol).cloned() {
            let coordinates: Vec<Leaf> = graph.coordinates().collect();
            let at: Option<Vec<(Leaf, Expr)>> =
                place.at.iter().map(|&(at, e)| Some((*coordinates.get(at)?, e))).collect();
            value = graph.taken_at(value, &at?);
        }
        for _ in 0..leaf.rate {
            value = graph.time_derivative(value, scope.time()?, |leaf| scope.moves(&leaf)).ok()?;
        }
        if let Some(at) = leaf.instant {
            value = taken(graph, scope, value, at);
        }
        all.push((leaf, value));
    }
    Some(graph.substitute(e, |_, leaf| all.iter().find(|(l, _)| *l == leaf).map(|(_, value)| *value)))
}

fn is_identity(graph: &mut Graph, l: Expr, r: Expr) -> bool {
    let apart = graph.sub(l, r);
    let options = Options { attempts: 1, ..Options::default() };
    graph.vanishes(apart)
        || matches!(identity_test(graph, &[(l, r)], &Premises::default(), &options), Identity::Proved(proof) if proof.conditions.is_empty())
}

/// What a sign says, beside 0.
fn of_sign(sign: Sign) -> RelationKind {
    match sign {
        Sign::NotZero => RelationKind::NotEqual,
        Sign::Positive => RelationKind::Greater,
        Sign::NotNegative => RelationKind::GreaterEqual,
    }
}

/// The relation without equality.
fn strict(kind: RelationKind) -> RelationKind {
    match kind {
        RelationKind::GreaterEqual => RelationKind::Greater,
        RelationKind::LessEqual => RelationKind::Less,
        RelationKind::Equal | RelationKind::NotEqual | RelationKind::Greater | RelationKind::Less => kind,
    }
}

/// A formula in which nothing that is defined is left, nor its rates: a definition may name the rate of another one. What cannot be formed
/// stays.
fn written(graph: &mut Graph, scope: &Scope, e: Expr) -> Expr {
    let mut e = e;
    // Definitions are acyclic.
    loop {
        let behind = claim::comparison::behind_rates(graph, scope, e);
        let then = then(graph, scope, behind);
        let traced = claim::comparison::traced(graph, scope, then);
        if traced == e {
            return e;
        }
        e = traced;
    }
}

/// Rates of what is defined, at fixed times, written out; what cannot be formed stays.
fn then(graph: &mut Graph, scope: &Scope, e: Expr) -> Expr {
    let mut formed: Vec<(Leaf, Expr)> = Vec::new();
    for leaf in graph.leaves_within([e]) {
        let Some(at) = leaf.instant.filter(|_| leaf.rate > 0 && scope.definition(leaf.symbol).is_some()) else {
            continue;
        };
        let now = graph.leaf(Leaf { instant: None, ..leaf });
        let rate = claim::comparison::behind_rates(graph, scope, now);
        let rate = claim::comparison::traced_now(graph, scope, rate);
        formed.push((leaf, taken(graph, scope, rate, at)));
    }
    graph.replaced(e, |_, leaf| formed.iter().find(|(l, _)| *l == leaf).map(|(_, value)| *value))
}

/// A formula at a fixed time.
fn taken(graph: &mut Graph, scope: &Scope, e: Expr, at: Expr) -> Expr {
    graph.replaced(e, |graph, leaf| match scope.moves(&leaf) {
        true => Some(graph.leaf(Leaf { instant: Some(at), ..leaf })),
        false => (Some(leaf) == scope.time()).then_some(at),
    })
}
