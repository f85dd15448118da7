//! Drafts: proofs while they are made. The only maker of facts, and of [`Shown`].
//!
//! **In:** a [`Sequent`], then steps, one by one. **Out:** the fact that a step makes, at once, or why the step is refused; at the end
//! [`Shown`]. **Guaranteed:** a draft that has refused a step is as it was before; what is shown is what [`replay`] of the recorded
//! steps shows, since replaying is drafting.

use super::context::{Context, Says};
use super::fact::{Because, Fact};
use super::needs::{Need, Needs, allowed, certain, is_trivial, needs};
use super::rules;
use super::sequent::Sequent;
use super::signs::{KnownSigns, Signs, of_sense, signs};
use super::step::{FactId, Given, Manner, Step};
use super::term::{Relation, Sense, Term};
use super::when::{CaseId, Instant, When};
use expr::domain::Sign;
use expr::{Expr, Symbol};
use std::collections::BTreeSet;

/// Most steps of a proof.
pub const MOST_STEPS: usize = 20_000;

/// Cases stand in each other this deep at most: to compare sets of times takes time that grows with it.
const DEEPEST_CASES: usize = 12;

/// A step that is not accepted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    /// Its position; that after the last step where the end is missing; nothing for a sequent that cannot be read.
    pub step: Option<usize>,
    /// The condition that is not met.
    pub why: String,
}

impl std::fmt::Display for Refused {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.step {
            Some(step) => write!(f, "step {}: {}", step + 1, self.why),
            None => f.write_str(&self.why),
        }
    }
}

impl std::error::Error for Refused {}

/// The result of a proof. Only [`replay`] and [`Draft::finish`] make one.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    claim: Relation,
    leaves_out: Vec<Relation>,
    leaves_out_words: Vec<String>,
    given: Vec<Given>,
    steps: usize,
    log2_error: f64,
    model: bool,
}

impl Shown {
    /// The claim.
    pub fn claim(&self) -> &Relation {
        &self.claim
    }

    /// The cases that are left out: the claim is shown at the times at which all of these are true. Nothing for a proof.
    pub fn leaves_out(&self) -> &[Relation] {
        &self.leaves_out
    }

    /// The same as formulas, in LaTeX between backquotes.
    pub fn leaves_out_words(&self) -> &[String] {
        &self.leaves_out_words
    }

    /// The places of the sequent that the proof rests on. (Definitions, and signs of constants, are used without being named.)
    pub fn given(&self) -> &[Given] {
        &self.given
    }

    /// The number of steps.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// log₂ of a bound of the probability that a trial of an identity was wrong; −∞ where all were exact.
    pub fn log2_error(&self) -> f64 {
        self.log2_error
    }

    /// Whether a motion was shown on which all that is given is true, and the claim, at some time. Without one the claim may hold since
    /// nothing satisfies what is given.
    pub fn model(&self) -> bool {
        self.model
    }
}

/// The supposition of a case.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    /// Nothing for the case that the claim has a value.
    pub(crate) says: Option<Says>,
    pub(crate) manner: Manner,
    /// Whether its times are an open set in every open set.
    pub(crate) open: bool,
    /// Whether the supposition does not move: its times are all or none.
    pub(crate) constant: bool,
}

/// The fact that a rule makes.
pub(crate) struct Made {
    pub(crate) says: Says,
    pub(crate) when: When,
    pub(crate) needs: Needs,
    pub(crate) because: Because,
}

/// A proof while it is made.
#[derive(Clone, Debug)]
pub struct Draft {
    pub(crate) context: Context,
    pub(crate) claim_needs: Vec<Need>,
    pub(crate) cases: Vec<Case>,
    pub(crate) opened: bool,
    pub(crate) everywhere: bool,
    pub(crate) analytic: BTreeSet<Symbol>,
    pub(crate) log2_error: f64,
    pub(crate) model: bool,
    pub(crate) shown: Option<(FactId, Needs)>,
    /// Products of terms that identities took, of refused steps, too: to be counted, no part of the proof.
    pub(crate) products: usize,
    facts: Vec<Fact>,
    /// Facts that later ones rest on without naming them: those that show that times are open, or functions analytic.
    lasting: Vec<FactId>,
    steps: Vec<Step>,
    claim: Relation,
}

/// The facts that a step without a fact of its own rests on.
fn lasting(step: &Step) -> Vec<FactId> {
    match step {
        Step::Open { because } | Step::Everywhere { because } => because.clone(),
        Step::Smooth { fact, because } => [&[*fact], &because[..]].concat(),
        Step::Analytic { equations, because } => [&equations[..], because].concat(),
        Step::Given { .. }
        | Step::HasValue { .. }
        | Step::ClaimHasValue { .. }
        | Step::Suppose { .. }
        | Step::Supposition { .. }
        | Step::Restrict { .. }
        | Step::Rate { .. }
        | Step::Partial { .. }
        | Step::Zero { .. }
        | Step::Discharge { .. }
        | Step::Close { .. }
        | Step::Conserved { .. }
        | Step::Vanishes { .. }
        | Step::Congruence { .. }
        | Step::Law { .. }
        | Step::Sign { .. }
        | Step::Summand { .. }
        | Step::Injective { .. }
        | Step::Continue { .. }
        | Step::Model { .. }
        | Step::Conclude { .. } => Vec::new(),
    }
}

impl Draft {
    /// Begins a proof of a sequent.
    ///
    /// # Errors
    /// [`Refused`] if a term cannot be read.
    pub fn new(sequent: &Sequent) -> Result<Draft, Refused> {
        let mut context = Context::new(sequent).map_err(|why| Refused { step: None, why })?;
        let mut claim_needs = Needs::new();
        for side in context.claim.sides() {
            claim_needs.extend(certain(&mut context, side));
        }
        let mut all = claim_needs.clone();
        for side in context.claim.sides() {
            all.extend(needs(&mut context, side));
        }
        let open = all == claim_needs && rules::case::is_open(&mut context, &claim_needs);
        let constant = claim_needs.iter().all(|need| !context.moves(need.value));
        let case = Case { says: None, manner: Manner::AtTimes, open: open || constant, constant };
        Ok(Draft {
            context,
            claim_needs: claim_needs.into_iter().collect(),
            cases: vec![case],
            opened: false,
            everywhere: false,
            analytic: BTreeSet::new(),
            log2_error: f64::NEG_INFINITY,
            model: false,
            shown: None,
            products: 0,
            facts: Vec::new(),
            lasting: Vec::new(),
            steps: Vec::new(),
            claim: sequent.claim.clone(),
        })
    }

    /// Takes a step.
    ///
    /// # Errors
    /// [`Refused`], with the condition that is not met.
    pub fn push(&mut self, step: Step) -> Result<Option<FactId>, Refused> {
        let refused = |why: String| Refused { step: Some(self.steps.len()), why };
        if self.shown.is_some() || self.steps.len() >= MOST_STEPS {
            return Err(refused("the proof has ended, or is too long".to_owned()));
        }
        match rules::apply(self, &step) {
            Err(why) => Err(Refused { step: Some(self.steps.len()), why }),
            Ok(Some(made)) if made.when.depth() > DEEPEST_CASES => {
                Err(Refused { step: Some(self.steps.len()), why: "cases stand too deep in each other".to_owned() })
            }
            Ok(made) => {
                self.lasting.extend(lasting(&step));
                self.steps.push(step);
                Ok(made.map(|made| self.add(made)))
            }
        }
    }

    /// The last fact.
    pub fn last(&self) -> Option<FactId> {
        self.facts.len().checked_sub(1).map(|at| FactId(at as u32))
    }

    fn add(&mut self, made: Made) -> FactId {
        let Made { says, when, needs, because } = made;
        let needs = needs.into_iter().filter(|need| !is_trivial(&self.context, *need)).collect();
        self.facts.push(Fact { says, when, needs, because });
        FactId((self.facts.len() - 1) as u32)
    }

    /// The steps so far.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// How many products of terms were expanded for identities, whether or not the steps were accepted.
    pub fn products(&self) -> usize {
        self.products
    }

    /// A fact.
    pub fn fact(&self, id: FactId) -> Option<&Fact> {
        self.facts.get(id.0 as usize)
    }

    /// The relation of a fact.
    pub fn says(&self, id: FactId) -> Option<Relation> {
        self.fact(id).and_then(|fact| self.context.written(fact.says).ok())
    }

    /// The needs of a fact.
    pub fn needs(&self, id: FactId) -> Vec<Relation> {
        let needs = self.fact(id).map(|fact| fact.needs.clone()).unwrap_or_default();
        needs.into_iter().filter_map(|need| self.relation_of(need)).collect()
    }

    /// The needs of the claim to have a value, in the order of [`Step::ClaimHasValue`].
    pub fn claim_needs(&self) -> Vec<Relation> {
        self.claim_needs.iter().filter_map(|need| self.relation_of(*need)).collect()
    }

    /// The derivative of a formula by time, as rules write it.
    ///
    /// # Errors
    /// A sentence: a name that is not declared, or a rate that a symbol does not have.
    pub fn derivative(&mut self, of: &Term) -> Result<Term, String> {
        let e = self.context.read(of)?;
        let d = super::derivative::derivative(&mut self.context, e)?;
        self.context.written(Says { left: d, sense: Sense::Equal, right: d }).map(|relation| relation.left)
    }

    /// A formula, with definitions put in.
    pub fn formula(&mut self, of: &Term) -> Option<Term> {
        let e = self.context.read(of).ok()?;
        self.context.written(Says { left: e, sense: Sense::Equal, right: e }).ok().map(|relation| relation.left)
    }

    /// A formula at a fixed time, as rules write it.
    pub fn at(&mut self, of: &Term, instant: Instant) -> Option<Term> {
        let (e, c) = (self.context.read(of).ok()?, self.context.instant(instant).ok()?);
        let e = super::needs::frozen(&mut self.context, e, c);
        self.context.written(Says { left: e, sense: Sense::Equal, right: e }).ok().map(|relation| relation.left)
    }

    /// A formula, expanded, and divided by facts as [`Step::Zero`] does; nothing where it is too large.
    pub fn normal_form(&mut self, of: &Term, modulo: &[FactId]) -> Option<Term> {
        let e = self.context.read(of).ok()?;
        let mut rewrites = Vec::new();
        for id in modulo {
            let says = self.fact(*id).filter(|fact| fact.says.sense == Sense::Equal)?.says;
            let difference = self.context.difference(says);
            rewrites.extend(super::polynomial::Rewrite::of(&self.context.graph, difference));
        }
        let e = super::polynomial::normal_form(&mut self.context.graph, e, &rewrites)?;
        self.context.written(Says { left: e, sense: Sense::Equal, right: e }).ok().map(|relation| relation.left)
    }

    /// The claim, with definitions put in.
    pub fn claim_says(&self) -> Option<Relation> {
        self.context.written(self.context.claim).ok()
    }

    /// A fact in words: `x=x(0)`, at all times, where `y\ne 0`.
    pub fn words(&self, id: FactId) -> String {
        let Some(fact) = self.fact(id) else { return String::new() };
        let mut text = format!("`{}`, {}", self.context.latex(fact.says), super::words::when(self, &fact.when));
        let needs: Vec<String> = self.needs_latex(&fact.needs);
        if !needs.is_empty() {
            text += &format!(", where {}", needs.join(", "));
        }
        text
    }

    pub(crate) fn needs_latex(&self, needs: &Needs) -> Vec<String> {
        let each = needs.iter().filter_map(|need| Some(self.context.latex(self.says_of(*need)?)));
        each.map(|text| format!("`{text}`")).collect()
    }

    /// Ends the proof.
    ///
    /// # Errors
    /// [`Refused`] if nothing was concluded.
    pub fn finish(self) -> Result<(Vec<Step>, Shown), Refused> {
        let at = self.steps.len();
        let Some((fact, needs)) = self.shown.clone() else {
            return Err(Refused { step: Some(at), why: "nothing is concluded".to_owned() });
        };
        let leaves_out = needs.iter().filter_map(|need| self.relation_of(*need)).collect();
        let leaves_out_words = self.needs_latex(&needs);
        let (given, steps) = (self.rests_on(fact), self.steps.len());
        let Draft { claim, log2_error, model, steps: recorded, .. } = self;
        Ok((recorded, Shown { claim, leaves_out, leaves_out_words, given, steps, log2_error, model }))
    }

    /// The places of the sequent that a fact rests on, or may: what shows that times are open is counted always.
    fn rests_on(&self, fact: FactId) -> Vec<Given> {
        let (mut seen, mut open, mut out) = (BTreeSet::new(), self.lasting.clone(), BTreeSet::new());
        open.push(fact);
        while let Some(id) = open.pop() {
            if let Some(fact) = self.fact(id).filter(|_| seen.insert(id)) {
                open.extend(fact.because.facts());
                if let Because::Given(given, _) = fact.because {
                    out.insert(given);
                }
            }
        }
        out.into_iter().collect()
    }

    /// A need as a relation; its zero is a node from the beginning.
    pub(crate) fn says_of(&self, need: Need) -> Option<Says> {
        let zero = self.context.zero;
        Some(match need.sign {
            Sign::Positive => Says { left: zero, sense: Sense::Less, right: need.value },
            Sign::NotNegative => Says { left: zero, sense: Sense::LessOrEqual, right: need.value },
            Sign::NotZero => Says { left: need.value, sense: Sense::NotEqual, right: zero },
        })
    }

    fn relation_of(&self, need: Need) -> Option<Relation> {
        self.context.written(self.says_of(need)?).ok()
    }

    /// A fact, for a rule.
    pub(crate) fn get(&self, id: FactId) -> Result<Fact, String> {
        self.fact(id).cloned().ok_or_else(|| format!("there is no fact {}", id.0))
    }

    /// A fact that is an equation.
    pub(crate) fn equation(&self, id: FactId) -> Result<Fact, String> {
        self.get(id).and_then(|fact| match fact.says.sense {
            Sense::Equal => Ok(fact),
            Sense::NotEqual | Sense::Less | Sense::LessOrEqual => Err(format!("fact {} is no equation", id.0)),
        })
    }

    /// Whether a fact is a relation between constants, and belongs to no case: it is used at any time.
    pub(crate) fn is_universal(&self, fact: &Fact) -> bool {
        let still = |e: Expr| !self.context.moves(e);
        !fact.when.is_in_case() && fact.says.sides().into_iter().all(still) && fact.needs.iter().all(|n| still(n.value))
    }

    /// Whether each time of the first set is one of the second.
    pub(crate) fn contained(&self, small: &When, large: &When) -> bool {
        if small == large {
            return true;
        }
        match (small, large) {
            (When::In(case, inner), _) => {
                let same_case = match large {
                    When::In(other, outer) => case == other && self.contained(inner, outer),
                    When::At(_) | When::Chosen | When::ChosenOpen | When::Always => false,
                };
                same_case || self.contained(inner, large)
            }
            (When::At(_) | When::Chosen | When::ChosenOpen, When::Always) | (When::ChosenOpen, When::Chosen) => true,
            (When::Chosen, When::ChosenOpen) => self.opened,
            (When::Always, When::Chosen) => self.everywhere,
            (When::Always, When::ChosenOpen) => self.everywhere && self.opened,
            (When::At(_), _) | (_, When::At(_)) | (_, When::In(..)) | (When::Always, When::Always) => false,
            (When::Chosen, When::Chosen) | (When::ChosenOpen, When::ChosenOpen) => true,
        }
    }

    /// A set of times that lies in both.
    fn meet(&self, a: &When, b: &When) -> Result<When, String> {
        if self.contained(a, b) {
            return Ok(a.clone());
        }
        if self.contained(b, a) {
            return Ok(b.clone());
        }
        match (a, b) {
            (When::In(case, inner), _) => Ok(self.meet(inner, b)?.within(*case)),
            (_, When::In(case, inner)) => Ok(self.meet(a, inner)?.within(*case)),
            (When::At(_) | When::Chosen | When::ChosenOpen | When::Always, _) => {
                Err("the facts are known at different times".to_owned())
            }
        }
    }

    /// The times at which all facts are known.
    pub(crate) fn common(&self, facts: &[FactId]) -> Result<When, String> {
        let mut when: Option<When> = None;
        for id in facts {
            let fact = self.get(*id)?;
            if !self.is_universal(&fact) {
                when = Some(match when {
                    Some(known) => self.meet(&known, &fact.when)?,
                    None => fact.when,
                });
            }
        }
        Ok(when.unwrap_or(When::Always))
    }

    /// A fact that is known at all of these times.
    pub(crate) fn known_at(&self, id: FactId, when: &When) -> Result<Fact, String> {
        let fact = self.get(id)?;
        if self.is_universal(&fact) || self.contained(when, &fact.when) {
            return Ok(fact);
        }
        Err(format!("fact {} is not known at these times", id.0))
    }

    /// Whether each time of the set has a neighbourhood in T that belongs to it.
    pub(crate) fn is_open(&self, when: &When) -> bool {
        match when {
            When::Always | When::ChosenOpen => true,
            When::Chosen => self.opened,
            When::At(_) => false,
            When::In(case, inner) => self.cases.get(case.0 as usize).is_some_and(|case| match case.manner {
                Manner::OnIntervals => true,
                Manner::AtTimes => case.open && self.is_open(inner),
            }),
        }
    }

    /// Whether the set is T, or has no time.
    pub(crate) fn is_whole(&self, when: &When) -> bool {
        match when {
            When::Always => true,
            When::Chosen | When::ChosenOpen => self.everywhere,
            When::At(_) => false,
            When::In(case, inner) => {
                self.cases.get(case.0 as usize).is_some_and(|case| case.constant) && self.is_whole(inner)
            }
        }
    }

    /// Whether all cases in it are opened. A fixed time is not among the sets that a rule may be asked for: what is known there is a
    /// relation between constants, which [`Step::Restrict`] makes.
    pub(crate) fn exists(&self, when: &When) -> bool {
        when.depth() <= DEEPEST_CASES && self.names_only_what_there_is(when)
    }

    fn names_only_what_there_is(&self, when: &When) -> bool {
        match when {
            When::At(_) => false,
            When::Chosen | When::Always => true,
            When::ChosenOpen => self.opened,
            When::In(CaseId(case), inner) => {
                (*case as usize) < self.cases.len() && self.names_only_what_there_is(inner)
            }
        }
    }

    /// The signs that facts say, at times, and the needs of these facts.
    pub(crate) fn known_signs(&self, facts: &[FactId], when: &When) -> Result<(KnownSigns, Needs), String> {
        let (mut known, mut needs) = (KnownSigns::new(), Needs::new());
        for id in facts {
            let fact = self.known_at(*id, when)?;
            let (l, r, signs) = (fact.says.left, fact.says.right, of_sense(fact.says.sense));
            let mut learn = |pair, signs: Signs| {
                let old = known.get(&pair).copied().unwrap_or(Signs::ALL);
                known.insert(pair, old.and(signs));
            };
            learn((l, r), signs);
            for (part, signs) in super::signs::of_parts(&self.context, fact.says) {
                learn((part, self.context.zero), signs);
            }
            needs.extend(fact.needs);
        }
        Ok((known, needs))
    }

    /// The needs that facts do not show, at times, by the rules of signs; with what these facts need.
    pub(crate) fn undischarged(&self, needs: Needs, facts: &[FactId], when: &When) -> Result<Needs, String> {
        let (known, added) = self.known_signs(facts, when)?;
        let open = |need: &Need| !signs(&self.context, need.value, &known).within(allowed(need.sign));
        let mut out: Needs = needs.into_iter().filter(open).collect();
        out.extend(added);
        Ok(out)
    }

    /// Whether facts show all needs, at times, without needing anything.
    pub(crate) fn all_shown(&self, needs: Needs, facts: &[FactId], when: &When) -> Result<(), String> {
        let open: Needs = self.undischarged(needs, facts, when)?;
        let open: Needs = open.into_iter().filter(|need| !is_trivial(&self.context, *need)).collect();
        if open.is_empty() { Ok(()) } else { Err(format!("not shown: {}", self.needs_latex(&open).join(", "))) }
    }
}

/// Replays a recorded proof.
///
/// # Errors
/// [`Refused`], with the first step that is not accepted.
pub fn replay(sequent: &Sequent, steps: &[Step]) -> Result<Shown, Refused> {
    let mut draft = Draft::new(sequent)?;
    for step in steps {
        draft.push(step.clone())?;
    }
    draft.finish().map(|(_, shown)| shown)
}
