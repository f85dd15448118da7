//! The rules: one function each, with its theorem.
//!
//! **In:** a [`Draft`](super::Draft) and a step. **Out:** the fact that the step makes, or the condition that is not met.
//!
//! In the comments, *at t* means at one time of the set at which a fact is known, and *free* that a fact needs nothing. In every
//! rule: if all needs of the result hold at t, then those of the facts that it uses hold, so that these are true at t.

pub(crate) mod analytic;
pub(crate) mod case;
mod conclude;
mod congruence;
mod discharge;
mod given;
pub(crate) mod model;
mod rate;
mod sign;
mod start;
mod times;
mod zero;

use super::context::Says;
use super::derivative::By;
use super::draft::{Draft, Made};
use super::fact::Because;
use super::needs::{Needs, needs};
use super::step::{FactId, Step};
use super::when::When;

/// Carries out a step.
pub(crate) fn apply(draft: &mut Draft, step: &Step) -> Result<Option<Made>, String> {
    match step {
        Step::Given { given, because } => given::given(draft, *given, because).map(Some),
        Step::HasValue { given, need } => given::has_value(draft, *given, *need).map(Some),
        Step::ClaimHasValue { need, within } => given::claim_has_value(draft, *need, within).map(Some),
        Step::Suppose { says, manner } => case::suppose(draft, says, *manner).map(|()| None),
        Step::Supposition { case, within } => case::supposition(draft, *case, within).map(Some),
        Step::Restrict { fact, to, because } => times::restrict(draft, *fact, to, because).map(Some),
        Step::Open { because } => times::open(draft, because).map(|()| None),
        Step::Everywhere { because } => times::everywhere(draft, because).map(|()| None),
        Step::Rate { fact } => rate::rate(draft, *fact, By::Time).map(Some),
        Step::Partial { fact, by, component } => rate::partial(draft, *fact, by, *component).map(Some),
        Step::Zero { says, multiplier, terms, insert, modulo } => {
            zero::zero(draft, says, multiplier, terms, insert, modulo).map(Some)
        }
        Step::Discharge { fact, because } => discharge::discharge(draft, *fact, because).map(Some),
        Step::Close { within, split, branches, because } => {
            case::close(draft, within, split, branches, because).map(Some)
        }
        Step::Conserved { of, at, rate, because } => start::conserved(draft, of, *at, *rate, because).map(Some),
        Step::Vanishes { of, matrix, at, rates, starts, because } => {
            let linear = start::Linear { of, matrix, at: *at, rates, starts, because };
            start::vanishes(draft, &linear).map(Some)
        }
        Step::Congruence { says, from, equal } => congruence::congruence(draft, says, *from, equal).map(Some),
        Step::Law { law, of } => super::law::law(draft, *law, of).map(Some),
        Step::Sign { says, from } => sign::sign(draft, says, from).map(Some),
        Step::Summand { sum, term, from } => sign::summand(draft, *sum, term, from).map(Some),
        Step::Injective { fact, from } => sign::injective(draft, *fact, from).map(Some),
        Step::Smooth { fact, because } => analytic::smooth(draft, *fact, because).map(|()| None),
        Step::Analytic { equations, because } => analytic::analytic(draft, equations, because).map(|()| None),
        Step::Continue { fact, because } => analytic::extend(draft, *fact, because).map(Some),
        Step::Model { values, at } => model::model(draft, values, at).map(|()| None),
        Step::Conclude { fact } => conclude::conclude(draft, *fact).map(|()| None),
    }
}

/// What both sides of a relation need to have values.
pub(crate) fn needs_of(draft: &mut Draft, says: Says) -> Needs {
    let mut out = needs(&mut draft.context, says.left);
    out.extend(needs(&mut draft.context, says.right));
    out
}

/// The result of a rule.
pub(crate) fn made(rule: &'static str, from: Vec<FactId>, says: Says, when: When, needs: Needs) -> Made {
    Made { says, when, needs, because: Because::Rule(rule, from) }
}
