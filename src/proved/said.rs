//! What a claim says, and what is given to it: which times and places are named, and whether all of it has values.
//!
//! **In:** a claim. **Out:** [`Sayings`]. **Guaranteed:** nothing that is given is left out; formulas of what is defined count as said.

use derivation::{Claim, Derivation, Form, FormFormula, Premise, Written};
use expr::domain::Sign;
use expr::{Expr, FastSet, Graph, Leaf, Node, Partials};
use findings::standing::MOST_TOLD;
use latex::{Relation, RelationKind, Role, Scope, Statement};
use std::collections::BTreeSet;

/// What a claim says, and what is given to it, with what it assumes; both with the formulas of what is defined.
pub(crate) struct Sayings<'a> {
    pub(crate) claimed: Said<'a>,
    pub(crate) given: Said<'a>,
}

/// The claims that one follows from, however far back, that assume something of these texts, by their positions.
pub fn assumed_behind(derivation: &Derivation, claim: &Claim, texts: &[String]) -> BTreeSet<usize> {
    let mut known: BTreeSet<usize> = BTreeSet::new();
    let mut open = if texts.is_empty() { Vec::new() } else { vec![claim] };
    while let Some(of) = open.pop() {
        let further = derivation.claims_among(&of.follows_from).filter(|at| known.insert(*at));
        open.extend(further.map(|at| &derivation.claims[at]));
    }
    // Of more than are told any may be meant.
    let is_told = |text: &String| texts.len() > MOST_TOLD || texts.contains(text);
    known.retain(|at| derivation.claims[*at].assuming.iter().any(|w| is_told(&w.text)));
    known
}

impl<'a> Sayings<'a> {
    pub(crate) fn of(derivation: &'a Derivation, claim: &'a Claim) -> Sayings<'a> {
        let (claimed, given) = (Said::of_claim(derivation, claim), Said::given(derivation, claim).assuming(claim));
        let [claimed, given] = [claimed, given].map(|said| said.with_definitions(derivation));
        Sayings { claimed, given }
    }

    /// With what is presupposed beside, since claims further back assume it.
    pub(crate) fn presupposing(mut self, derivation: &'a Derivation, claim: &Claim, texts: &[String]) -> Sayings<'a> {
        let near: Vec<usize> = derivation.claims_among(&claim.follows_from).collect();
        for at in assumed_behind(derivation, claim, texts).into_iter().filter(|at| !near.contains(at)) {
            let of = Said { is_beyond_a_step: true, ..Said::default() }.assuming(&derivation.claims[at]);
            self.given.join(of.with_definitions(derivation));
        }
        self
    }

    /// The relations that are given, or assumed, where all of it is relations of each time.
    pub(crate) fn relations(&self) -> Option<&[(&'a Relation, &'a Scope)]> {
        (!self.given.relates_times).then_some(&self.given.relations)
    }

    /// Whether a fixed time, or a place, is named.
    pub(crate) fn names_a_time(&self, derivation: &Derivation) -> bool {
        self.claimed.names_a_time(derivation) || self.given.names_a_time(derivation)
    }
}

/// Formulas, and what they are said to be.
#[derive(Default)]
pub(crate) struct Said<'a> {
    pub(crate) formulas: Vec<Expr>,
    /// Each with the names by which it is written.
    relations: Vec<(&'a Relation, &'a Scope)>,
    /// Whether something other than an equation is among them, or ±: it may choose times.
    pub(crate) chooses: bool,
    /// Whether it is a claim of another form than relations at each time.
    relates_times: bool,
    /// Whether the step itself does not have all of it: a claim among it has symbols of its own, or is further back.
    pub(crate) is_beyond_a_step: bool,
}

impl<'a> Said<'a> {
    pub(crate) fn of_formulas(formulas: Vec<Expr>) -> Said<'a> {
        Said { formulas, ..Said::default() }
    }

    pub(crate) fn of_claim(derivation: &'a Derivation, claim: &'a Claim) -> Said<'a> {
        let mut out = Said::default();
        for form in &claim.forms {
            match form {
                Form::Always(w) => out.add(std::iter::once(w), &claim.scope),
                other => {
                    out.relates_times = true;
                    for formula in other.formulas() {
                        match formula {
                            FormFormula::Statement(w) => out.add(std::iter::once(w), &claim.scope),
                            FormFormula::Quantity(w) => out.formulas.extend(&w.value.components),
                            FormFormula::Limit { of, value } => {
                                out.formulas.extend(of.value.components.iter().chain(&value.value.components));
                            }
                        }
                    }
                    if let Form::Solves { system, .. } = other {
                        out.add(derivation.systems[*system].equations.iter(), &derivation.scope);
                    }
                }
            }
        }
        out
    }

    fn given(derivation: &'a Derivation, claim: &'a Claim) -> Said<'a> {
        let mut given = Said::default();
        for name in derivation.given_to(claim) {
            match derivation.premise(&name) {
                Premise::System(at) => given.add(derivation.systems[at].equations.iter(), &derivation.scope),
                Premise::Claim(at) => {
                    let of = &derivation.claims[at];
                    given.is_beyond_a_step |= !of.symbols.is_empty();
                    given.join(Said::of_claim(derivation, of).assuming(of));
                }
                Premise::Definition => {}
            }
        }
        given
    }

    /// With what a claim assumes.
    pub(crate) fn assuming(mut self, claim: &'a Claim) -> Said<'a> {
        self.add(claim.assuming.iter(), &claim.scope);
        self
    }

    fn add(&mut self, statements: impl Iterator<Item = &'a Written<Statement>>, scope: &'a Scope) {
        for relation in statements.flat_map(|w| &w.value.relations) {
            self.chooses |= relation.kind != RelationKind::Equal || relation.has_branches || relation.limit.is_some();
            self.relations.push((relation, scope));
            self.formulas.extend(relation.left.components.iter().chain(&relation.right.components));
        }
    }

    fn join(&mut self, other: Said<'a>) {
        self.formulas.extend(other.formulas);
        self.relations.extend(other.relations);
        self.chooses |= other.chooses;
        self.relates_times |= other.relates_times;
        self.is_beyond_a_step |= other.is_beyond_a_step;
    }

    /// With the formulas of what is defined.
    pub(crate) fn with_definitions(mut self, derivation: &Derivation) -> Said<'a> {
        let mut known = FastSet::default();
        let mut at = 0;
        while at < self.formulas.len() {
            for leaf in derivation.graph.leaves_within([self.formulas[at]]) {
                if known.insert(leaf.symbol)
                    && let Some(formula) = derivation.definition(leaf.symbol)
                {
                    self.formulas.extend(&formula.components);
                }
            }
            at += 1;
        }
        self
    }

    /// The one time that it is about: a fixed one, or any; nothing where there are several, or rates.
    pub(crate) fn one_time(&self, derivation: &Derivation) -> Option<Option<Expr>> {
        let mut leaves = derivation.graph.leaves_within(self.formulas.iter().copied());
        leaves.retain(|leaf| leaf.instant.is_some() || derivation.role(leaf.symbol) != Some(Role::Parameter));
        let first = leaves.first().and_then(|leaf| leaf.instant);
        let alike = |l: &Leaf| l.rate == 0 && l.partials == Partials::NONE && l.instant == first;
        // A field at another place is not known by its formula here.
        let is_here = !derivation.graph.has_places(self.formulas.iter().copied());
        (!self.relates_times && is_here && leaves.iter().all(alike)).then_some(first)
    }

    /// Whether it names a place that does not move with the others, as f(0) does, and not f(x + y).
    fn names_a_place(&self, derivation: &Derivation) -> bool {
        let graph = &derivation.graph;
        let is_fixed = |e: Expr| graph.leaves_within([e]).is_empty();
        let leaves = graph.leaves_within(self.formulas.iter().copied());
        let mut places = leaves.iter().filter_map(|leaf| graph.place(leaf.symbol));
        places.any(|place| place.at.iter().any(|&(_, e)| is_fixed(e)))
    }

    /// The one fixed place at which every field in it is taken, u(0,t), without a rate across it: there all of it moves with time
    /// alone. Nothing where there are several, or something that moves beside fields.
    pub(crate) fn one_place(&self, derivation: &Derivation) -> Option<Vec<(usize, Expr)>> {
        let graph = &derivation.graph;
        let mut leaves = graph.leaves_within(self.formulas.iter().copied());
        leaves.retain(|leaf| derivation.role(leaf.symbol) != Some(Role::Parameter));
        let at = &graph.place(leaves.iter().find(|leaf| graph.is_field(leaf.symbol))?.symbol)?.at;
        let own: Vec<Leaf> = graph.coordinates().collect();
        let is_own = |e: Expr| matches!(graph.node(e), Node::Leaf(leaf) if own.contains(leaf));
        let fixed = |&&(_, e): &&(usize, Expr)| graph.leaves_within([e]).is_empty();
        let is_known = at.iter().all(|one| fixed(&one) || is_own(one.1));
        let is_there = |leaf: &Leaf| {
            let across = at.iter().filter(fixed).any(|&(at, _)| leaf.partials.steps().any(|by| by == at));
            own.contains(leaf) || graph.place(leaf.symbol).is_some_and(|place| &place.at == at) && !across
        };
        (is_known && leaves.iter().all(is_there)).then(|| at.clone())
    }

    /// Whether it names something that moves: where that has no value at some times, nothing is given at these.
    pub(crate) fn moves(&self, derivation: &Derivation) -> bool {
        let leaves = derivation.graph.leaves_within(self.formulas.iter().copied());
        leaves.iter().any(|leaf| leaf.instant.is_none() && derivation.role(leaf.symbol) != Some(Role::Parameter))
    }

    pub(crate) fn instants(&self, derivation: &Derivation) -> FastSet<Expr> {
        let leaves = derivation.graph.leaves_within(self.formulas.iter().copied());
        leaves.into_iter().filter_map(|leaf| leaf.instant).collect()
    }

    pub(crate) fn names_an_instant(&self, derivation: &Derivation) -> bool {
        !self.instants(derivation).is_empty()
    }

    /// Whether it names a fixed time, or a place.
    pub(crate) fn names_a_time(&self, derivation: &Derivation) -> bool {
        self.names_a_place(derivation) || self.names_an_instant(derivation)
    }

    pub(crate) fn is_total(&self, derivation: &Derivation) -> bool {
        is_total(derivation, &mut derivation.graph.clone(), &self.formulas)
    }
}

/// Whether formulas have values, and are smooth, wherever their symbols have values.
pub(crate) fn is_total(derivation: &Derivation, graph: &mut Graph, formulas: &[Expr]) -> bool {
    let all: Vec<Expr> = graph.reachable(formulas.iter().copied());
    all.into_iter().all(|node| {
        let needs = graph.needs(node);
        let edges = graph.edges(node);
        needs.iter().all(|need| is_so(derivation, graph, need.value, need.sign))
            && edges.iter().filter_map(|edge| edge.vanishing).all(|e| is_so(derivation, graph, e, Sign::NotZero))
    })
}

/// Whether a number, or a parameter that is declared as positive, has a sign.
pub(crate) fn is_so(derivation: &Derivation, graph: &Graph, e: Expr, sign: Sign) -> bool {
    if let Node::Leaf(leaf) = graph.node(e) {
        return derivation.is_positive_parameter(leaf.symbol);
    }
    graph.as_constant(e).is_some_and(|number| sign.is_of(number))
}
