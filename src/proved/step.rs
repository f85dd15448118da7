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
//! integrals are not identities, and have no answer, unless they say something about positive parameters only: then their
//! signs are decided for every order of size of the parameters, see [`proof::order`].
//!
//! # How a step is decided
//!
//! 1. *From what is named alone*: observables are symbols of which only the premises are known. A proof without the
//!    definitions is a proof with them, and needs no conditions for them. Then with the definitions that the claim itself
//!    makes, then with all. Only the last can refute.
//! 2. *Along the motion*, where that leaves l = r open: both sides agree at a fixed time that the formulas name, and their
//!    rates agree always. Then they agree always, where they are differentiable. Along a motion, a product that vanishes
//!    throughout has, on every interval that is short enough, a factor that vanishes throughout, with its derivative; so
//!    products are taken apart, before they are differentiated.
//!
//! Premises hold at all times. They are used at the present time and at the fixed times that the formulas name.

mod account;
mod beyond;
mod chosen;
mod definitions;
mod denied;
mod exceptions;
mod gather;
mod known;
mod orders;
mod places;
mod points;
mod questions;
mod rates;
mod reach;
mod signs;
mod times;
mod uniqueness;
mod valued;

use crate::agreement::{Signs, answer, evidence, evidence_of, reach};
use crate::derivation::{Claim, Derivation, Form, Motion};
use crate::expr::{Expr, FastMap, Graph, Leaf, Symbol};
use crate::findings::standing::{self, Decision};
use crate::findings::{AssumptionsUsed, IdentityAccount, IdentityEvidence};
use crate::latex::{Relation, RelationKind};
use crate::motions;
pub(crate) use chosen::chooses;
use claim::denial::denies;
use definitions::Definitions;
use gather::{Gathered, sides};
use proof::{Condition, Identity, Memory, Options, Premises, Proof, Reason, Wanted, When, excludes_motions, order};
use reason::{Plain, Proving};

/// A claim that is decided for all values.
pub struct Step<'a> {
    derivation: &'a Derivation,
    claim: &'a Claim,
    graph: Graph,
    /// The last question that was settled, where it was one question: what the second route is asked.
    settled: Option<Settled>,
    /// Where the last proof was found.
    proved_at: Level,
    /// What is known to be open.
    memory: Memory,
    /// Of what only a part of what is given is used: where there is something, nothing is refuted.
    in_part: Vec<Leaf>,
    /// When an inequality that is assumed holds: of a file it chooses the times that count, what is typed is so always.
    inequalities: When,
    /// What is assumed to differ at the times that the claim chooses, and is taken to differ at all: where it does not is an exception.
    apart: Pairs,
    /// Claims that are named, and not used.
    left_out: Vec<usize>,
    /// Where the formulas of observables have edges, as far as that was asked for.
    edges: FastMap<Leaf, Vec<Expr>>,
    /// The fixed time at which a proof along motions begins.
    start: Option<Expr>,
    /// The sign for which the claim is asked, where it stands among its assumptions.
    sign: Option<i64>,
    /// Whether the answer is all that is wanted, and not which assumptions it needs.
    plain: bool,
    /// Whether few points are tried, where an example or a refutation is looked for.
    has_few_points: bool,
}

/// What a proof took: how many of the definitions, see [`Definitions::LEVELS`], and whether products were taken apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
struct Level {
    split: bool,
    definitions: usize,
}

/// A question that the random test answered.
#[derive(Clone, Debug)]
struct Settled {
    premises: Premises,
    equations: Pairs,
    identity: Identity,
}

/// The largest step that is tried, in nodes of its formulas, with what they are given and defined by.
const MOST_NODES: usize = 6_000;

type Pairs = Vec<(Expr, Expr)>;
/// What a step comes to; `Err` if two routes contradict each other.
type Decided = Result<IdentityAccount, String>;

/// The present value of a component.
fn now(symbol: Symbol, component: usize) -> Leaf {
    Leaf::now(symbol, component as u16)
}

fn pairs(relation: &Relation) -> impl Iterator<Item = (Expr, Expr)> + '_ {
    relation.left.components.iter().copied().zip(relation.right.components.iter().copied())
}

/// Real points that are tried while definitions are left out: nothing is refuted then.
const FEW_POINTS: u32 = 24;
/// Most cases into which products are taken apart.
const MOST_CASES: usize = 12;
/// Claims with more assumptions are not tried without each of them.
const MOST_ASSUMPTIONS: usize = 6;

/// Solving without an assumption is given up when it has made this many nodes: then the assumption counts as used.
const LEFT_OUT_NODES: usize = 8_000;

/// Whether a proof leaves out the case that something divided by vanishes.
fn has_exceptions(proof: &Proof) -> bool {
    proof.conditions.iter().any(|c| c.leaves_out().is_some())
}

/// Whether something is proved, and no case was left out.
fn without_exceptions(identity: &Identity) -> bool {
    matches!(identity, Identity::Proved(proof) if !has_exceptions(proof))
}

/// Whether a motion may refute what is open: not where what is given contradicts itself, or the program itself.
fn may_be_refuted(account: &IdentityAccount) -> bool {
    let open = account.finding.decision() == Decision::Undecided;
    open && !account.evidence.contradiction && !account.is_defect
}

impl<'a> Step<'a> {
    /// The sides of a relation that decide by themselves: components, but of ≠ between vectors or matrices, of which some
    /// component differs, the sum of the squares and 0. With the sign for which the claim is asked.
    fn scalars(&mut self, relation: &Relation) -> Pairs {
        let mut out: Pairs = pairs(relation).collect();
        if relation.kind == RelationKind::NotEqual && out.len() > 1 {
            let mut sum = self.graph.integer(0);
            for (l, r) in out {
                let difference = self.graph.sub(l, r);
                let square = self.graph.powi(difference, 2);
                sum = self.graph.add(sum, square);
            }
            out = vec![(sum, self.graph.integer(0))];
        }
        if relation.kind == RelationKind::NotEqual && relation.has_branches {
            // l ≠ ±r says that neither sign makes them equal.
            return [1, -1].into_iter().flat_map(|value| self.branch(&out, value)).collect();
        }
        match self.sign {
            Some(value) => self.branch(&out, value),
            None => out,
        }
    }

    /// The step that a claim makes, if it is one: all its forms are equations without limits, or first integrals; or it is
    /// about parameters only.
    pub fn of(derivation: &'a Derivation, claim: &'a Claim) -> Option<Step<'a>> {
        if claim.unread().is_some() {
            return None;
        }
        let step = Step {
            derivation,
            claim,
            graph: derivation.graph.clone(),
            settled: None,
            proved_at: Level::default(),
            memory: Memory::default(),
            sign: None,
            start: None,
            left_out: Vec::new(),
            edges: FastMap::default(),
            in_part: Vec::new(),
            plain: false,
            has_few_points: false,
            inequalities: When::Chosen,
            apart: Pairs::new(),
        };
        let possible = !claim.forms.is_empty() && claim.at.is_none();
        (possible && (step.is_equations() || step.is_about_parameters() || denies(claim))).then_some(step)
    }

    fn is_equations(&self) -> bool {
        let equations =
            |relations: &[Relation]| relations.iter().all(|r| r.kind == RelationKind::Equal && r.limit.is_none());
        self.claim.forms.iter().all(|form| match form {
            Form::Always(w) => equations(&w.value.relations),
            Form::FirstIntegral(_) => true,
            _ => false,
        })
    }

    /// Whether everything that the claim says and assumes has a sign in the positive parameters.
    fn is_about_parameters(&self) -> bool {
        let mut roots: Vec<Expr> = Vec::new();
        for form in &self.claim.forms {
            match form {
                Form::Always(w) if w.value.relations.iter().all(|r| r.limit.is_none()) => {
                    roots.extend(w.value.relations.iter().flat_map(pairs).flat_map(|(l, r)| [l, r]));
                }
                Form::Defined(w) => roots.extend(&w.value.components),
                _ => return false,
            }
        }
        let assumed = self.claim.assuming.iter().flat_map(|w| &w.value.relations).flat_map(pairs);
        roots.extend(assumed.flat_map(|(l, r)| [l, r]));
        let leaves = self.graph.leaves_within(roots);
        !leaves.is_empty() && leaves.iter().all(|&l| self.is_positive_parameter(l))
    }

    fn is_positive_parameter(&self, leaf: Leaf) -> bool {
        self.derivation.is_positive_parameter(leaf.symbol)
    }

    /// What a claim is said to follow from, see [`Derivation::given_to`].
    pub fn given(derivation: &Derivation, claim: &Claim) -> Vec<String> {
        derivation.given_to(claim)
    }

    /// The systems of the motions on which a claim is tried, if all of these are integrated, or are analytic functions of such, or of the
    /// time.
    pub fn behind(derivation: &Derivation, claim: &Claim) -> Option<Vec<usize>> {
        let mut out: Vec<usize> = Vec::new();
        let leaps = |e: &Expr| claim::comparison::may_leap(&derivation.graph, *e);
        let mut open: Vec<usize> = claim.families.iter().map(|&f| derivation.families[f].of).collect();
        open.extend(&claim.trajectories);
        while let Some(at) = open.pop() {
            match &derivation.trajectories[at].motion {
                Motion::Integrated { system, .. } => out.push(*system),
                Motion::Formula { states }
                    if states.iter().flat_map(|(_, w)| &w.value).any(|e| {
                        !derivation.scope.time().is_some_and(|time| derivation.graph.is_analytic_in(*e, time))
                    }) =>
                {
                    return None;
                }
                Motion::Formula { .. } => {}
                Motion::Derived { map, .. } if map.iter().flat_map(|(_, w)| &w.value).any(leaps) => return None,
                Motion::Derived { from, .. } => open.push(*from),
            }
        }
        out.sort_unstable();
        out.dedup();
        Some(out)
    }

    /// Whether motions of a claim that names nothing obey equations that are not given: those of several systems, or one that is not
    /// written. No point refutes it then.
    pub(crate) fn lacks_systems(derivation: &Derivation, claim: &Claim) -> bool {
        let systems = derivation.systems_of_motions(claim);
        claim.follows_from.is_empty() && !matches!(systems.as_slice(), [] | [Some(_)])
    }

    /// Why a point refutes nothing: what is missing among what is given.
    fn not_given(&self) -> reason::Reason {
        let (derivation, claim) = (self.derivation, self.claim);
        let systems = derivation.systems_of_motions(claim).into_iter().flatten();
        let systems: Vec<std::sync::Arc<str>> = systems.map(|at| derivation.systems[at].id.as_str().into()).collect();
        if Step::lacks_systems(derivation, claim) && systems.len() > 1 {
            return reason::Proving::SeveralSystems(systems).into();
        }
        reason::Plain::RefutedWithoutAll.into()
    }

    /// The same step; with `plain` it is not asked which assumptions a proof needs.
    pub fn with(self, plain: bool) -> Step<'a> {
        Step { plain, ..self }
    }

    /// The same step, where only a proof is of interest: few points are tried for an example or a refutation.
    pub fn with_few_points(self) -> Step<'a> {
        Step { has_few_points: true, ..self }
    }

    /// The same step, where what is assumed is assumed of all times: of a file, an inequality chooses the times that count.
    pub fn typed(self) -> Step<'a> {
        Step { inequalities: When::Always, ..self }
    }

    /// The same step, before anything was asked.
    fn afresh(&self) -> Option<Step<'a>> {
        let step = Step::of(self.derivation, self.claim)?.with(self.plain);
        Some(Step { has_few_points: self.has_few_points, inequalities: self.inequalities, ..step })
    }

    /// Decides the step; `Err` if the two routes contradict each other.
    pub fn decide(mut self) -> Option<Decided> {
        if !self.is_equations() {
            return match self.is_about_parameters() {
                true => self.by_order().map(Ok),
                false => self.decide_denials(),
            };
        }
        if self.is_of_each_sign() {
            return self.for_each_sign(Step::decide_equations);
        }
        // One sign with that of the claim, which must be so for both: either of them would be less.
        if self.sign.is_none() && self.assumes_sign() && self.claim.forms.iter().any(Form::has_branches) {
            let reason = Some(Plain::SignAtOtherTimes.into());
            return Some(Ok(IdentityAccount { reason, ..IdentityAccount::default() }));
        }
        let (mut between, beside) = (self.afresh()?, self.afresh()?);
        between.apart = if self.inequalities == When::Always { Pairs::new() } else { self.chosen_apart() };
        let found = self.decide_or_search()?;
        // As long as what differs does so, all goes on.
        let is_open = matches!(&found, Ok(account) if account.finding.decision() == Decision::Undecided);
        if !between.apart.is_empty() && is_open {
            match between.decide_equations()? {
                Ok(account) if account.finding.is_proved_in_part() => return Some(Ok(account)),
                Ok(_) => {}
                defect => return Some(defect),
            }
        }
        match found {
            Ok(account) if beside.claim.is_tried() && !account.finding.is_proved_in_part() => {
                Some(beside.excluding(account))
            }
            found => Some(found),
        }
    }

    /// Decides a claim that consists of equations; what stays open is looked for on motions.
    fn decide_or_search(self) -> Option<Decided> {
        let (derivation, claim) = (self.derivation, self.claim);
        let (inequalities, searches) = (self.inequalities, !self.has_few_points);
        let found = self.decide_equations()?;
        let is_open = |account: &IdentityAccount| {
            let is_shown = account.finding.is_proved_in_part();
            let refutable = is_shown && !account.finding.is_whole() || may_be_refuted(account);
            searches && refutable
        };
        if matches!(&found, Ok(account) if is_open(account))
            && let Some(motion) = motions::refuting(derivation, claim, inequalities)
        {
            return Some(Ok(motions::account(derivation, claim, &motion)));
        }
        Some(found)
    }

    /// Decides a claim that consists of equations.
    fn decide_equations(mut self) -> Option<Decided> {
        let mut gathered = self.gather(None);
        if self.claim.states_integral() {
            gathered = match self.between_times(&gathered) {
                Some(between) => between,
                None => return Some(Ok(self.open(&gathered, Plain::OnlyRates))),
            };
        }
        let mut equations = self.equations(self.claim)?;
        // Sides that are one expression: nothing is tried of a claim about fields, or of one without motions, but this.
        let on_motions = self.claim.is_tried() && self.claim.region.is_none();
        if on_motions || equations.iter().any(|(l, r)| l != r) {
            equations.retain(|(l, r)| l != r);
        }
        if equations.is_empty() {
            return None;
        }
        if self.is_too_large(&gathered, &equations) {
            return Some(Ok(self.open(&gathered, Plain::TooLargeForProof)));
        }
        // Before fields are put in, and times become the present.
        if let Some(valued) = proof::with_values_of_places(&mut self.graph, &equations, &gathered.premises) {
            gathered.premises = valued;
        }
        self.give_equal_places(&mut gathered, &equations);
        self.put_in_fields(&mut gathered, &mut equations);
        self.give_at_places(&mut gathered, &equations);
        let times = self.unite_times(&mut gathered, &mut equations);
        let several =
            self.graph.leaves_within(equations.iter().flat_map(|&(l, r)| [l, r])).iter().any(|l| l.instant.is_some());
        let at_times = equations.clone();
        let mut claims_more = false;
        if let Some((present, alone)) = self.at_present(&mut gathered, &equations) {
            (equations, claims_more) = (present, !alone);
        }
        let (mut identity, mut moved) = (self.levels(&gathered, &equations, false, Wanted::Answer), false);
        if !matches!(identity, Identity::Proved(_)) {
            let settled = self.settled.take();
            match self.by_rate(&gathered, &equations) {
                Some((by_rate, of)) => (identity, moved, equations) = (by_rate, true, of),
                None => self.settled = settled,
            }
        }
        if claims_more && !matches!(identity, Identity::Proved(_)) {
            // What is claimed of all times may be false where what is said of some is true.
            equations = at_times;
            identity = self.levels(&gathered, &equations, false, Wanted::Answer);
        }
        if let Identity::Proved(proof) = &identity
            && has_exceptions(proof)
        {
            identity = match moved {
                false => self.without_empty_cases(identity, &gathered, &equations, true),
                // What was proved is about rates; a point that refutes it says nothing of values.
                true => match self.start_and_rates(&gathered, &equations) {
                    Some(all) => self.without_empty_cases(identity, &gathered, &all, false),
                    None => identity,
                },
            };
        }
        if let (Identity::Proved(proof), true) = (&mut identity, moved) {
            match self.open_at_start(&gathered, &equations) {
                Some(open) => proof.conditions.extend(open.into_iter().map(Condition::Pivot)),
                None => return Some(Ok(self.open(&gathered, Plain::Unconnected))),
            }
        }
        if matches!(identity, Identity::Proved(_)) && self.contradicts_itself(&gathered, &equations) {
            self.settled = None;
            identity = Identity::Undecided(Reason::Contradiction);
        }
        if !matches!(identity, Identity::Proved(_)) && !standing::is_empty(&identity) {
            let still = self.at_rest(&gathered, &equations);
            let undecided = !matches!(identity, Identity::Refuted(_)) || several;
            let complete = gathered.complete && self.in_part.is_empty();
            if let Some(refuted) = still.filter(|_| undecided && complete) {
                self.settled = None;
                let evidence = match self.evidence(&refuted) {
                    Ok(evidence) => evidence,
                    Err(defect) => return Some(Err(format!("{}: {defect}", self.claim.name()))),
                };
                let account = self.account(refuted, gathered.from.clone(), gathered.complete);
                return Some(Ok(IdentityAccount { evidence, ..account }));
            }
        }
        let weighed =
            matches!(identity, Identity::Proved(_) | Identity::Undecided(Reason::Contradiction | Reason::Defect(_)));
        if !weighed && self.joins_times(&gathered, &equations) {
            return Some(Ok(self.open(&gathered, Plain::OnlyRates)));
        }
        if matches!(identity, Identity::Refuted(_)) && self.joins_places(&gathered, &equations) {
            self.settled = None;
            identity = Identity::Undecided(Reason::Unextended);
        }
        if matches!(identity, Identity::Refuted(_)) && (times.unclear || self.ties(&gathered)) {
            match self.at_fixed_time(&gathered, &equations) {
                None if times.unclear => return Some(Ok(self.open(&gathered, Plain::Unconnected))),
                None => {}
                Some(refuted @ Identity::Refuted(_)) => identity = refuted,
                Some(_) => return Some(Ok(self.open(&gathered, Plain::Unconnected))),
            }
        }
        let evidence = match self.evidence(&identity) {
            Ok(evidence) => evidence,
            Err(defect) => return Some(Err(format!("{}: {defect}", self.claim.name()))),
        };
        let identity = reach(identity, &evidence);
        let proved = matches!(identity, Identity::Proved(_));
        let leaping = if proved { self.leaping(&gathered, &equations, moved) } else { Vec::new() };
        if let (true, Some(&one)) = (moved, leaping.first()) {
            let account = self.open(&gathered, Proving::MayLeap(self.shown(one).into()));
            return Some(Ok(IdentityAccount { evidence, ..account }));
        }
        let mut along = if proved { self.continuation(&gathered, &equations, moved, &leaping) } else { Vec::new() };
        if proved && !self.has_values_together(&equations, &identity, &evidence) {
            along.push(standing::Exception::OneSign);
        }
        if proved {
            let differences = self.apart.iter().map(|&(l, r)| self.graph.sub(l, r));
            along.extend(differences.map(standing::Exception::Passes));
        }
        if proved {
            match self.beyond_what_is_named(&equations) {
                (_, exceptions) if exceptions.is_empty() => {}
                (left_out, exceptions) => match self.proved_without(left_out, Step::decide_equations) {
                    Some(account) => return Some(Ok(account)),
                    None => along.extend(exceptions),
                },
            }
        }
        let contradicts = matches!(identity, Identity::Undecided(Reason::Contradiction));
        let complete = gathered.complete && self.in_part.is_empty();
        let following = self.following(&identity, &gathered, &equations, moved);
        let account = self.account_along(identity, (gathered.from.clone(), complete), along, &following);
        if account.finding.is_whole() && self.excludes_at_times(&gathered, &equations) {
            let open = self.account(Identity::Undecided(Reason::Contradiction), account.from, true);
            let evidence = IdentityEvidence { contradiction: true, ..IdentityEvidence::default() };
            return Some(Ok(IdentityAccount { evidence, ..open }));
        }
        let mut account = IdentityAccount { evidence, ..account };
        if let Some((one, other)) = contradicts.then(|| self.contradicting(&equations)).flatten() {
            account.reason = Some(Proving::Contradict(one.into(), other.into()).into());
        }
        if account.finding.is_proved_in_part() {
            account.assumptions = if self.plain { None } else { self.assumptions_used(&equations, moved) };
            account.generic |= !gathered.inherited.is_empty();
            account.presupposed.clone_from(&gathered.inherited);
            account.assumed_at_times.clone_from(&gathered.assumed_at_times);
        }
        Some(Ok(account))
    }

    /// Whether what is given contradicts itself, at one time or between several: then nothing is said.
    fn contradicts_itself(&mut self, gathered: &Gathered, equations: &Pairs) -> bool {
        self.is_without_motion(gathered, equations) || self.excludes_between_times(gathered, equations)
    }

    /// Whether no motion satisfies what is given: then nothing is said, whatever follows.
    fn is_without_motion(&mut self, gathered: &Gathered, equations: &Pairs) -> bool {
        let premises = self.premises(gathered, equations, Definitions::Everything);
        excludes_motions(&mut self.memory, &mut self.graph, &premises)
    }

    /// Two assumptions that no motion satisfies together.
    fn contradicting(&mut self, equations: &Pairs) -> Option<(String, String)> {
        let count = self.claim.assuming.len();
        let text = |n: usize| self.claim.assuming[n].text.clone();
        let pairs = (0..count.min(MOST_ASSUMPTIONS)).flat_map(|i| (0..i).map(move |j| (j, i)));
        let texts: Vec<((usize, usize), (String, String))> = pairs.map(|(j, i)| ((j, i), (text(j), text(i)))).collect();
        texts.into_iter().find_map(|((j, i), texts)| {
            let others: Vec<usize> = (0..count).filter(|n| *n != i && *n != j).collect();
            let gathered = self.gather(Some(&others));
            self.is_without_motion(&gathered, equations).then_some(texts)
        })
    }

    /// Whether a step is about more than a proof has room for: what it takes grows with the square of that.
    fn is_too_large(&self, gathered: &Gathered, equations: &Pairs) -> bool {
        let given = gathered.systems.iter().flat_map(|&(l, r)| [l, r]).chain(gathered.premises.sides());
        let mut roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).chain(given).collect();
        self.add_definitions(&mut roots);
        self.graph.reachable(roots).len() > MOST_NODES
    }

    /// The account of a step that stays open, for a reason.
    fn open(&mut self, gathered: &Gathered, reason: impl Into<reason::Reason>) -> IdentityAccount {
        let open = Identity::Undecided(Reason::NoDerivative);
        let account = self.account(open, gathered.from.clone(), gathered.complete);
        IdentityAccount { reason: Some(reason.into()), ..account }
    }

    /// What the second route says of the question that was settled.
    fn evidence(&mut self, identity: &Identity) -> Result<IdentityEvidence, String> {
        let of_question = |s: &Settled| s.identity.word() == identity.word();
        let Some(Settled { premises, equations, identity: found }) = self.settled.take().filter(of_question) else {
            // What the answer itself says: of several questions, or of one that stayed open.
            return evidence_of(&self.graph, identity);
        };
        let sign = self.claim.scope.branch_sign();
        let roots: Vec<Expr> = equations.iter().flat_map(|&(l, r)| [l, r]).collect();
        if !self.graph.leaves_within(roots).contains(&sign) {
            return evidence(&mut self.graph, &equations, &premises, &found);
        }
        let signs = Signs { leaf: sign, branching: self.branching(&equations, &premises) };
        answer(&mut self.graph, &equations, &premises, Some(signs)).map(|(_, evidence)| evidence)
    }

    /// The assumptions of the claim that its proof needs; `None` where it has none. One is not needed only if
    /// a proof without it leaves out no case: the case left out may be the one that it excludes.
    fn assumptions_used(&mut self, equations: &Pairs, moved: bool) -> Option<AssumptionsUsed> {
        let count = self.claim.assuming.len();
        if count == 0 || count > MOST_ASSUMPTIONS {
            return None;
        }
        let least = self.proved_at;
        let mut left_out: Vec<usize> = Vec::new();
        for at in 0..count {
            let mut without = left_out.clone();
            without.push(at);
            let gathered = self.gather(Some(&without));
            let holds = match moved {
                false => self.is_proved(&gathered, equations, least),
                true => match self.start_and_rates(&gathered, equations) {
                    Some(all) => self.is_proved(&gathered, &all, least),
                    None => false,
                },
            };
            if holds && self.leaping(&gathered, equations, moved).is_empty() {
                left_out = without;
            }
        }
        let text = |i: usize| self.claim.assuming[i].text.clone();
        Some(AssumptionsUsed {
            used: (0..count).filter(|i| !left_out.contains(i)).map(text).collect(),
            unused: left_out.iter().map(|&i| text(i)).collect(),
        })
    }

    /// Whether a proof that reaches every case is found, at a level that takes no less than the given one; nothing is
    /// refuted. What takes less was not enough with more premises, either.
    fn is_proved(&mut self, gathered: &Gathered, equations: &Pairs, least: Level) -> bool {
        let mut tried: Option<Premises> = None;
        for definitions in least.definitions..Definitions::LEVELS.len() {
            let premises = self.premises(gathered, equations, Definitions::LEVELS[definitions]);
            if tried.as_ref().is_some_and(|t| t.equations == premises.equations) {
                continue;
            }
            let options =
                Options { attempts: 1, most_nodes: LEFT_OUT_NODES, wanted: Wanted::Proof, ..Options::default() };
            if without_exceptions(&self.ask(&premises, equations, &options, least.split)) {
                return true;
            }
            tried = Some(premises);
        }
        false
    }

    /// Claims about positive parameters: the sign of everything, for every order of size.
    fn by_order(&mut self) -> Option<IdentityAccount> {
        let question = self.order_question();
        let found = order::decide(&mut self.graph, &question);
        Some(self.account_of_order(&question, found))
    }
}
