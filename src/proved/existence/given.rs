//! What is given, as conditions in which nothing that is defined is left.
//!
//! **In:** a claim, and what it is said to follow from. **Out:** whether it is a system that has a motion; whether all of it is so at rest.
//! **Guaranteed:** nothing given is left out; a point is an exact one, see [`proof`].

use crate::derivation::{Claim, Derivation};
use crate::expr::domain::Sign;
use crate::expr::{Expr, Graph, Leaf, Node, Partials, Rational, Shape, Symbol};
use crate::latex::{Relation, RelationKind, Role, Scope};
use crate::said::{Sayings, is_so};
use proof::{Identity, Options, Premises, When, identity_test};

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
    /// What must be so at some time: inequalities of a file choose the times of which a claim speaks.
    chosen: Vec<Condition>,
    /// What must be so besides, near a point of a motion.
    domain: Vec<Condition>,
}

impl<'a> Given<'a> {
    /// Nothing where something given is no relation of each time. Of ± the upper sign is taken.
    pub(super) fn of(
        derivation: &'a Derivation,
        claim: &'a Claim,
        said: &'a Sayings<'a>,
        inequalities: When,
    ) -> Option<Given<'a>> {
        let graph = derivation.graph.clone();
        let empty = Vec::new;
        let mut out = Given { derivation, claim, said, graph, conditions: empty(), chosen: empty(), domain: empty() };
        let (given, assumed) = said.relations()?;
        out.conditions = out.written_out(given)?;
        let assumed = out.written_out(assumed)?;
        let chooses = |c: &Condition| c.0 != RelationKind::Equal && !out.named(&[*c]).is_empty();
        if inequalities != When::Always && assumed.iter().any(chooses) {
            out.chosen = assumed;
        } else {
            out.conditions.extend(assumed);
        }
        Some(out)
    }

    fn written_out(&mut self, relations: &[&Relation]) -> Option<Vec<Condition>> {
        let (graph, scope) = (&mut self.graph, &self.claim.scope);
        let sign = scope.branch_sign();
        let mut out = Vec::new();
        for relation in relations {
            if relation.limit.is_some() {
                return None;
            }
            for (&l, &r) in relation.left.components.iter().zip(&relation.right.components) {
                let [l, r] = [l, r].map(|side| {
                    let side = claim::comparison::behind_rates(graph, scope, side);
                    let side = claim::comparison::traced(graph, scope, side);
                    graph.replaced(side, |graph, leaf| (leaf == sign).then(|| graph.integer(1)))
                });
                out.push((relation.kind, l, r));
            }
        }
        Some(out)
    }

    /// What conditions name but parameters.
    fn named(&self, conditions: &[Condition]) -> Vec<Leaf> {
        let mut leaves = self.graph.leaves_within(conditions.iter().flat_map(|&(_, l, r)| [l, r]));
        leaves.retain(|leaf| self.claim.scope.role(leaf.symbol) != Some(Role::Parameter));
        leaves
    }

    /// Whether it is a system that is solved for its rates, and formulas, with values at one fixed time, if there are any, from which a motion
    /// begins; or numbers alone.
    pub(super) fn has_solution(&mut self) -> bool {
        if self.named(&self.conditions).is_empty() && self.chosen.is_empty() {
            return true;
        }
        if self.insert_formulas().is_none() {
            return false;
        }
        let of_start = |this: &Self, c: &Condition| {
            let leaves = this.named(&[*c]);
            leaves.iter().all(|leaf| leaf.instant.is_some())
        };
        let (mut starts, moving): (Vec<Condition>, Vec<Condition>) =
            self.conditions.iter().partition(|condition| of_start(self, condition));
        let leaves = self.named(&moving);
        let is_state = |l: &Leaf| l.instant.is_none() && l.partials == Partials::NONE && !self.graph.is_field(l.symbol);
        let equations: Vec<(Expr, Expr)> = moving.iter().map(|&(_, l, r)| (l, r)).collect();
        if moving.iter().any(|(kind, ..)| *kind != RelationKind::Equal) || !leaves.iter().all(is_state) {
            return false;
        }
        let mut states: Vec<Symbol> = leaves.iter().filter(|l| l.rate > 0).map(|l| l.symbol).collect();
        states.sort_unstable();
        states.dedup();
        let time = self.claim.scope.time();
        let Ok(field) = claim::system::field(&mut self.graph, time, &states, &equations) else { return false };
        self.add_domain(field.rates());
        // From where what is given begins, a motion need not reach the other times that are named.
        let [of_claim, of_given] = [&self.said.claimed, &self.said.given].map(|said| said.instants(self.derivation));
        let named = of_claim.union(&of_given).count();
        let names_a_place = named == 0 && self.said.names_a_time(self.derivation);
        let is_local = !self.domain.is_empty() || !self.chosen.is_empty();
        if of_given.len() > 1 || is_local && (named > 1 || names_a_place) || named == 1 && !self.chosen.is_empty() {
            return false;
        }
        let begun = of_given.into_iter().chain(of_claim).next();
        starts.append(&mut self.domain);
        starts.append(&mut self.chosen);
        if starts.is_empty() {
            return true;
        }
        // The point at which it begins, with the rates that the system gives it.
        let rates: Vec<(Leaf, Expr)> = field.states().iter().copied().zip(field.rates().iter().copied()).collect();
        let rate = |leaf: Leaf| {
            let of = |(state, _): &&(Leaf, Expr)| Leaf { rate: state.rate + 1, ..*state } == leaf;
            rates.iter().find(of).filter(|_| !field.states().contains(&leaf)).map(|(_, rate)| *rate)
        };
        for side in starts.iter_mut().flat_map(|(_, l, r)| [l, r]) {
            let here = |graph: &mut Graph, leaf: Leaf| Some(graph.leaf(Leaf { instant: None, ..leaf }));
            *side = self.graph.replaced(*side, |graph, leaf| leaf.instant.and_then(|_| here(graph, leaf)));
            *side = self.graph.replaced(*side, |_, leaf| rate(leaf));
            *side = self.graph.replaced(*side, |_, leaf| begun.filter(|_| Some(leaf) == time));
        }
        // Higher rates than the system gives are no numbers of their own.
        let is_given = |l: &Leaf| l.rate > 0 && states.contains(&l.symbol) && !field.states().contains(l);
        if self.named(&starts).iter().any(is_given) {
            return false;
        }
        self.has_point(&starts)
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
        let Given { graph, claim, conditions, chosen, domain, .. } = self;
        for all in [conditions, chosen, domain] {
            for side in all.iter_mut().flat_map(|(_, l, r)| [l, r]) {
                *side = inserted(graph, &claim.scope, *side, leaf, formula)?;
            }
            all.retain(|&(kind, l, r)| kind != RelationKind::Equal || !is_identity(graph, l, r));
        }
        Some(())
    }

    /// Whether equations of fields alone are met by fields that are 0, a number, a coordinate, or half the square of one.
    pub(super) fn has_simple_fields(mut self) -> bool {
        let is_equation = |c: &Condition| c.0 == RelationKind::Equal;
        let leaves = self.named(&self.conditions);
        let time = self.claim.scope.time();
        let is_of_fields =
            |l: &Leaf| self.graph.is_field(l.symbol) || self.graph.coordinate(*l).is_some() || Some(*l) == time;
        let mut fields: Vec<Leaf> = leaves.iter().filter(|l| self.graph.is_field(l.symbol)).copied().collect();
        for leaf in &mut fields {
            *leaf = Leaf::now(self.graph.field_of(leaf.symbol), leaf.component);
        }
        fields.sort_unstable();
        fields.dedup();
        let all = self.conditions.iter().all(is_equation) && leaves.iter().all(is_of_fields) && self.chosen.is_empty();
        all && !fields.is_empty() && fields.len() <= MOST_FIELDS && self.is_met_by(&fields)
    }

    fn is_met_by(&mut self, fields: &[Leaf]) -> bool {
        let Some((field, others)) = fields.split_first() else { return self.conditions.is_empty() };
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

    /// A condition that says what something that moves is.
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
                (is_course && !itself).then_some((at, leaf, formula))
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
                    let kind = match sign {
                        Sign::NotZero => RelationKind::NotEqual,
                        Sign::Positive | Sign::NotNegative => RelationKind::Greater,
                    };
                    self.domain.push((kind, value, zero));
                }
            }
        }
    }

    /// Whether all of it is so where what moves is at rest: nothing names the time, or a coordinate.
    pub(super) fn has_rest(&mut self) -> bool {
        let mut conditions = std::mem::take(&mut self.conditions);
        conditions.append(&mut self.chosen);
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
            value = graph.replaced(value, |graph, leaf| match scope.moves(&leaf) {
                true => Some(graph.leaf(Leaf { instant: Some(at), ..leaf })),
                false => (Some(leaf) == scope.time()).then_some(at),
            });
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
