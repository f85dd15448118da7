//! Claims as steps of a derivation: what holds for every value of every symbol.
//!
//! **In:** a claim, and what it follows from. **Out:** [`IdentityAccount`]: proved, refuted or undecided, with what was
//! taken as given.
//!
//! Given are always the definitions of the symbols and the claim's own assumptions; beside them what `follows-from` names
//! (claims, systems, symbols), or, where it names nothing, the equations of the derivation's systems. A claim that holds on
//! every trajectory may well be refuted here: then it needs more than what is given, an initial condition for instance.
//!
//! Claims with several equations are one question: all must follow. Claims of other kinds than equations and first
//! integrals are not identities, and have no answer.

use super::account::IdentityAccount;
use super::comparison::at_instant;
use super::identity::{Condition, Identity, Point, Premises, Reason};
use super::second_route::{IdentityEvidence, Signs, answer};
use super::verdict::Witness;
use crate::derivation::{Claim, Derivation, Form, Motion};
use crate::expr::{Expr, Graph, Leaf, Node, Op, Rational, Symbol};
use crate::latex::{Relation, RelationKind, Role};

/// A claim whose equations are decided for all values.
pub(super) struct Step<'a> {
    derivation: &'a Derivation,
    claim: &'a Claim,
    graph: Graph,
}

/// Most characters of a formula that is shown whole.
const LONGEST: usize = 160;

/// The present value of a component.
fn now(symbol: Symbol, component: usize) -> Leaf {
    Leaf { symbol, component: component as u16, rate: 0, instant: None }
}

fn pairs(relation: &Relation) -> impl Iterator<Item = (Expr, Expr)> + '_ {
    relation.left.components.iter().copied().zip(relation.right.components.iter().copied())
}

impl<'a> Step<'a> {
    /// The step that a claim makes, if it is one: all its forms are equations without limits, or first integrals.
    pub fn of(derivation: &'a Derivation, claim: &'a Claim) -> Option<Step<'a>> {
        let equations =
            |relations: &[Relation]| relations.iter().all(|r| r.kind == RelationKind::Equal && r.limit.is_none());
        let decidable = claim.forms.iter().all(|form| match form {
            Form::Always(w) => equations(&w.value.relations),
            Form::FirstIntegral(_) => true,
            _ => false,
        });
        (decidable && claim.at.is_none() && !claim.forms.is_empty()).then(|| Step {
            derivation,
            claim,
            graph: derivation.graph.clone(),
        })
    }

    /// What a claim is said to follow from: the names that it gives, or the one system of its trajectories.
    pub fn given(derivation: &Derivation, claim: &Claim) -> Vec<String> {
        if claim.follows_from.is_empty() {
            // Two systems that move the same states contradict each other, and everything would follow.
            let mut systems: Vec<usize> = claim
                .trajectories
                .iter()
                .filter_map(|&t| match derivation.trajectories[t].motion {
                    Motion::Integrated { system, .. } => Some(system),
                    _ => None,
                })
                .collect();
            systems.sort_unstable();
            systems.dedup();
            match systems.as_slice() {
                [only] => vec![derivation.systems[*only].id.clone()],
                _ => Vec::new(),
            }
        } else {
            claim.follows_from.clone()
        }
    }

    /// The answer where a motion gives it: one on which everything given holds, and the claim does not.
    pub fn refuted_by(&self, trajectory: &str, witness: &Witness) -> IdentityAccount {
        IdentityAccount {
            verdict: "refuted",
            log2_error: None,
            from: Step::given(self.derivation, self.claim),
            conditions: Vec::new(),
            generic: false,
            reason: None,
            witness: Some(format!(
                "left {}, right {} on the trajectory {trajectory} at t = {}",
                witness.left, witness.right, witness.t
            )),
            evidence: IdentityEvidence::default(),
        }
    }

    /// The rate of a first integral as an equation `… = 0`.
    fn constancy(&mut self, claim: &Claim, e: Expr) -> Option<(Expr, Expr)> {
        let scope = &claim.scope;
        let time = scope.time()?;
        let moves = |leaf: Leaf| matches!(scope.role(leaf.symbol), Some(Role::State | Role::Observable));
        let rate = self.graph.time_derivative(e, time, moves).ok()?;
        Some((rate, self.graph.integer(0)))
    }

    /// What a claim says as equations; `None` where it says something else.
    fn equations(&mut self, claim: &Claim) -> Option<Vec<(Expr, Expr)>> {
        let mut out = Vec::new();
        for form in &claim.forms {
            match form {
                Form::Always(w) => {
                    for relation in &w.value.relations {
                        if relation.kind != RelationKind::Equal || relation.limit.is_some() {
                            return None;
                        }
                        out.extend(pairs(relation));
                    }
                }
                Form::FirstIntegral(w) => {
                    for &e in &w.value.components {
                        out.push(self.constancy(claim, e)?);
                    }
                }
                Form::Solves { system } => {
                    let relations = self.derivation.systems[*system].equations.iter().flat_map(|w| &w.value.relations);
                    out.extend(relations.flat_map(pairs));
                }
                _ => return None,
            }
        }
        Some(out)
    }

    /// Adds the assumptions of a claim; whether all could be used.
    fn assume(&mut self, claim: &Claim, premises: &mut Premises) -> bool {
        let mut complete = true;
        for relation in claim.assuming.iter().flat_map(|w| &w.value.relations) {
            for (l, r) in pairs(relation) {
                match relation.kind {
                    RelationKind::Equal => premises.equations.push((l, r)),
                    RelationKind::NotEqual => premises.nonzero.push(self.graph.sub(l, r)),
                    RelationKind::Greater => premises.positive.push(self.graph.sub(l, r)),
                    RelationKind::Less => premises.positive.push(self.graph.sub(r, l)),
                    // Left out: a proof without it is a proof, a refutation may be wrong.
                    RelationKind::GreaterEqual | RelationKind::LessEqual => complete = false,
                }
            }
        }
        complete
    }

    /// Which symbols move, and which are positive.
    fn roles(&mut self, premises: &mut Premises) {
        let Derivation { symbols, claims, scope, .. } = self.derivation;
        premises.time = scope.time();
        for entry in symbols.iter().chain(claims.iter().flat_map(|c| &c.symbols)) {
            let count = self.graph.component_count(entry.symbol);
            match entry.role {
                Role::State | Role::Observable => premises.moving.push(entry.symbol),
                Role::Parameter => premises.parameters.extend((0..count).map(|c| now(entry.symbol, c))),
                Role::Time | Role::Abbreviation | Role::Argument => {}
            }
        }
    }

    /// What is positive among the parameters that occur.
    fn positive_parameters(&mut self, equations: &[(Expr, Expr)], premises: &mut Premises) {
        let Derivation { symbols, .. } = self.derivation;
        let roots: Vec<Expr> = equations.iter().chain(&premises.equations).flat_map(|&(l, r)| [l, r]).collect();
        for leaf in self.graph.leaves(roots) {
            if symbols.iter().any(|s| s.symbol == leaf.symbol && s.positive && s.role == Role::Parameter) {
                let node = self.graph.leaf(leaf);
                premises.positive.push(node);
            }
        }
    }

    /// The definitions of the observables that occur, of those in these, and so on; where rates occur, the systems that
    /// are given join in. What does not occur is left out: a premise less can only lose a proof.
    fn definitions(&mut self, equations: &[(Expr, Expr)], systems: &[(Expr, Expr)], premises: &mut Premises) {
        let Derivation { claims, scope, .. } = self.derivation;
        let mut seen: Vec<Leaf> = Vec::new();
        let mut moving = false;
        let mut open: Vec<Leaf> = {
            let given = equations.iter().chain(&premises.equations).flat_map(|&(l, r)| [l, r]);
            let roots: Vec<Expr> = given.chain(premises.nonzero.clone()).chain(premises.positive.clone()).collect();
            self.graph.leaves(roots)
        };
        loop {
            while let Some(leaf) = open.pop() {
                moving |= leaf.rate > 0;
                let value = Leaf { rate: 0, ..leaf };
                if value.instant.is_some() || seen.contains(&value) {
                    continue;
                }
                seen.push(value);
                let in_claim = || claims.iter().find_map(|c| c.scope.definition(value.symbol));
                let Some(definition) = scope.definition(value.symbol).or_else(in_claim) else { continue };
                if let Some(&e) = definition.components.get(usize::from(value.component)) {
                    let node = self.graph.leaf(value);
                    premises.equations.push((node, e));
                    open.extend(self.graph.leaves([e]));
                }
            }
            if !moving || systems.is_empty() || premises.equations.contains(&systems[0]) {
                return;
            }
            premises.equations.extend(systems);
            let roots: Vec<Expr> = systems.iter().flat_map(|&(l, r)| [l, r]).collect();
            open.extend(self.graph.leaves(roots));
        }
    }

    /// The values at fixed times that the equations name obey the definitions at these times.
    fn definitions_at_instants(&mut self, equations: &[(Expr, Expr)], premises: &mut Premises) {
        let roots: Vec<Expr> = equations
            .iter()
            .chain(&premises.equations)
            .flat_map(|&(l, r)| [l, r])
            .chain(premises.nonzero.clone())
            .collect();
        let scope = &self.claim.scope;
        let mut open: Vec<Leaf> = self.graph.leaves(roots);
        open.retain(|l| l.instant.is_some());
        let mut seen: Vec<Leaf> = Vec::new();
        while let Some(leaf) = open.pop() {
            let (Some(instant), false) = (leaf.instant, seen.contains(&leaf)) else { continue };
            seen.push(leaf);
            let definition = scope.definition(leaf.symbol).filter(|_| leaf.rate == 0);
            if let Some(&e) = definition.and_then(|d| d.components.get(usize::from(leaf.component))) {
                let then = at_instant(&mut self.graph, scope, e, instant);
                open.extend(self.graph.leaves([then]));
                let node = self.graph.leaf(leaf);
                premises.equations.push((node, then));
            }
        }
    }

    /// What is given as constant has its present value at the fixed times that occur, too.
    fn constants_at_instants(&mut self, constant: &[Expr], equations: &[(Expr, Expr)], premises: &mut Premises) {
        let roots: Vec<Expr> = equations.iter().chain(&premises.equations).flat_map(|&(l, r)| [l, r]).collect();
        let mut instants: Vec<Expr> = self.graph.leaves(roots).into_iter().filter_map(|l| l.instant).collect();
        instants.sort_unstable();
        instants.dedup();
        for &e in constant {
            for &instant in &instants {
                let then = at_instant(&mut self.graph, &self.claim.scope, e, instant);
                premises.equations.push((e, then));
            }
        }
    }

    /// Decides the step; `Err` if the two routes contradict each other.
    pub fn decide(mut self) -> Option<Result<IdentityAccount, String>> {
        let (derivation, claim) = (self.derivation, self.claim);
        let mut premises = Premises::default();
        self.roles(&mut premises);
        let mut systems: Vec<(Expr, Expr)> = Vec::new();
        let mut constant: Vec<Expr> = Vec::new();
        let mut inherited: Vec<String> = Vec::new();
        let mut complete = self.assume(claim, &mut premises);
        let mut from = Vec::new();
        for name in Step::given(derivation, claim) {
            let name = name.as_str();
            from.push(name.to_owned());
            if let Some(system) = derivation.systems.iter().find(|s| s.id == name) {
                systems.extend(system.equations.iter().flat_map(|w| &w.value.relations).flat_map(pairs));
                continue;
            }
            // Of a claim with readings the first is meant.
            let Some(premise) = derivation.claims.iter().find(|c| c.name() == name || c.id == name) else { continue };
            for form in &premise.forms {
                if let Form::FirstIntegral(w) = form {
                    constant.extend(w.value.components.iter().copied());
                }
            }
            match self.equations(premise) {
                Some(equations) => premises.equations.extend(equations),
                None => complete = false,
            }
            complete &= self.assume(premise, &mut premises);
            // What a premise presupposes is presupposed here: a proof says so, and does not reach beyond it.
            let own = |text: &str| claim.assuming.iter().any(|w| w.text == text);
            inherited.extend(premise.assuming.iter().filter(|w| !own(&w.text)).map(|w| w.text.clone()));
        }
        let mut equations = self.equations(claim)?;
        equations.retain(|(l, r)| l != r);
        if equations.is_empty() {
            return None;
        }
        self.constants_at_instants(&constant, &equations, &mut premises);
        self.definitions(&equations, &systems, &mut premises);
        self.definitions_at_instants(&equations, &mut premises);
        self.positive_parameters(&equations, &mut premises);
        let sign = claim.scope.branch_sign();
        let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        let branching = self.graph.leaves(roots).contains(&sign);
        let signs = branching.then_some(Signs { leaf: sign, throughout: claim.branches_throughout });
        let (identity, evidence) = match answer(&mut self.graph, &equations, &premises, signs) {
            Ok(found) => found,
            Err(defect) => return Some(Err(format!("{}: {defect}", claim.name()))),
        };
        let mut account = IdentityAccount { evidence, ..self.account(identity, from, complete) };
        if account.verdict == "proved" && !inherited.is_empty() {
            inherited.dedup();
            account.generic = true;
            account.conditions.extend(inherited.into_iter().map(|a| format!("{a} (assumed by what is given)")));
        }
        Some(Ok(account))
    }

    /// What an answer says of the claim, nothing being given.
    pub fn of_identity(&self, identity: Identity, evidence: IdentityEvidence) -> IdentityAccount {
        IdentityAccount { evidence, ..self.account(identity, Vec::new(), true) }
    }

    /// Whether a condition is a false statement about a number.
    fn is_impossible(&self, condition: &Condition) -> bool {
        let number = |e: Expr| self.graph.as_constant(e).cloned();
        let (zero, one) = (Rational::ZERO, Rational::ONE);
        match condition {
            Condition::Denominator(e) | Condition::Pivot(e) => number(*e).is_some_and(|r| r == zero),
            Condition::Radicand(e) => number(*e).is_some_and(|r| r < zero),
            Condition::Positive(e) => number(*e).is_some_and(|r| r <= zero),
            Condition::Unit(e) => number(*e).is_some_and(|r| r > one || r < -one),
        }
    }

    fn shown(&self, e: Expr) -> String {
        let text = self.graph.to_latex(e);
        if text.len() <= LONGEST { text } else { format!("(an expression of {} characters)", text.len()) }
    }

    fn point(&self, point: &Point) -> String {
        let value = |(leaf, value): &(Leaf, super::identity::PointValue)| {
            let name = self.graph.leaf_latex(*leaf);
            match (&value.exact, &value.circle) {
                (Some(r), _) => format!("{name} = {r}"),
                (None, Some((c, s))) => format!("cos {name} = {c}, sin {name} = {s}"),
                (None, None) => format!("{name} = {}", value.decimal),
            }
        };
        point.values.iter().map(value).collect::<Vec<_>>().join("; ")
    }

    fn account(&self, identity: Identity, from: Vec<String>, complete: bool) -> IdentityAccount {
        // A locally constant function may still jump.
        let jumps = self.claim.forms.iter().any(|form| match form {
            Form::FirstIntegral(w) => self
                .graph
                .reachable(w.value.components.iter().copied())
                .iter()
                .any(|&e| matches!(self.graph.node(e), Node::Unary(Op::Abs, _) | Node::Binary(Op::Arctan2, ..))),
            _ => false,
        });
        let mut out = IdentityAccount {
            verdict: identity.word(),
            log2_error: None,
            from,
            conditions: Vec::new(),
            generic: false,
            reason: None,
            witness: None,
            evidence: IdentityEvidence::default(),
        };
        match identity {
            Identity::Proved(proof) => {
                out.log2_error = Some(proof.log2_error);
                for condition in &proof.conditions {
                    out.conditions.push(match condition {
                        Condition::Denominator(e) => format!("{} ≠ 0", self.shown(*e)),
                        Condition::Pivot(e) => format!("{} ≠ 0 (the other case was not reached)", self.shown(*e)),
                        Condition::Radicand(e) => format!("{} ≥ 0", self.shown(*e)),
                        Condition::Unit(e) => format!("|{}| ≤ 1", self.shown(*e)),
                        Condition::Positive(e) => format!("{} > 0", self.shown(*e)),
                    });
                    out.generic |= matches!(condition, Condition::Pivot(_));
                }
                out.generic |= jumps;
                if proof.conditions.iter().any(|c| self.is_impossible(c)) {
                    out.verdict = "undecided";
                    out.log2_error = None;
                    out.reason = Some("what is given makes a formula have no value".to_owned());
                }
                if proof.example.is_none() {
                    out.reason = Some("no real point was found that satisfies what is given".to_owned());
                    out.generic = true;
                }
            }
            Identity::Refuted(refutation) if complete => {
                let side = |s: &super::identity::Side| match &s.exact {
                    Some(r) => r.to_string(),
                    None => s.decimal.to_string(),
                };
                out.witness = Some(format!(
                    "left {}, right {} at {}",
                    side(&refutation.left),
                    side(&refutation.right),
                    self.point(&refutation.point)
                ));
            }
            Identity::Refuted(_) => {
                out.verdict = "undecided";
                out.reason = Some("refuted without an assumption that could not be used".to_owned());
            }
            Identity::Undecided(Reason::Unsolved(e)) => {
                out.reason =
                    Some(format!("a premise could not be solved for any of its unknowns: {} = 0", self.shown(e)));
            }
            Identity::Undecided(reason) => out.reason = Some(reason.to_string()),
        }
        out
    }
}
