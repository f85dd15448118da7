//! Steps that a proof uses, without those of the search that led nowhere.
//!
//! **In:** steps that the checker accepted. **Out:** those on which the conclusion rests, numbered anew. **Guaranteed:** steps that make no fact stay.

use checker::{FactId, Split, Step};
use std::collections::BTreeMap;

/// Calls a function on each fact that a step names.
fn each_fact(step: &mut Step, mut see: impl FnMut(&mut FactId)) {
    match step {
        Step::Given { because, .. } | Step::Open { because } | Step::Everywhere { because } => {
            because.iter_mut().for_each(see);
        }
        Step::HasValue { .. }
        | Step::ClaimHasValue { .. }
        | Step::Suppose { .. }
        | Step::Supposition { .. }
        | Step::Law { .. }
        | Step::Model { .. } => {}
        Step::Rate { fact } | Step::Partial { fact, .. } | Step::Conclude { fact } => see(fact),
        Step::Restrict { fact, because, .. }
        | Step::Discharge { fact, because }
        | Step::Smooth { fact, because }
        | Step::Continue { fact, because }
        | Step::Injective { fact, from: because } => {
            see(fact);
            because.iter_mut().for_each(see);
        }
        Step::Zero { terms, insert, modulo, .. } => {
            terms.iter_mut().map(|(fact, _)| fact).chain(insert).chain(modulo).for_each(see);
        }
        Step::Close { split, branches, because, .. } => {
            if let Split::Product(fact) = split {
                see(fact);
            }
            branches.iter_mut().chain(because).for_each(see);
        }
        Step::Conserved { rate, because, .. } => {
            see(rate);
            because.iter_mut().for_each(see);
        }
        Step::Vanishes { rates, starts, because, .. } => {
            rates.iter_mut().chain(starts).chain(because).for_each(see);
        }
        Step::Congruence { from, equal, .. } => from.iter_mut().chain(equal).for_each(see),
        Step::Sign { from, .. } => from.iter_mut().for_each(see),
        Step::Summand { sum, from, .. } => {
            see(sum);
            from.iter_mut().for_each(see);
        }
        Step::Analytic { equations, because } => equations.iter_mut().chain(because).for_each(see),
    }
}

/// Whether a step makes a fact.
fn makes_fact(step: &Step) -> bool {
    match step {
        Step::Suppose { .. }
        | Step::Open { .. }
        | Step::Everywhere { .. }
        | Step::Smooth { .. }
        | Step::Analytic { .. }
        | Step::Model { .. }
        | Step::Conclude { .. } => false,
        Step::Given { .. }
        | Step::HasValue { .. }
        | Step::ClaimHasValue { .. }
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
        | Step::Continue { .. } => true,
    }
}

/// The steps on which the conclusion rests.
pub(crate) fn used(mut steps: Vec<Step>) -> Vec<Step> {
    let mut numbers: Vec<Option<u32>> = Vec::with_capacity(steps.len());
    let mut next = 0;
    for step in &steps {
        numbers.push(makes_fact(step).then_some(next));
        next += u32::from(makes_fact(step));
    }
    let mut wanted = vec![false; next as usize];
    let mut kept = vec![false; steps.len()];
    for at in (0..steps.len()).rev() {
        kept[at] = numbers[at].is_none_or(|fact| wanted[fact as usize]);
        if kept[at] {
            each_fact(&mut steps[at], |fact| {
                if let Some(known) = wanted.get_mut(fact.0 as usize) {
                    *known = true;
                }
            });
        }
    }
    let mut anew: BTreeMap<FactId, FactId> = BTreeMap::new();
    let mut out = Vec::new();
    for (at, mut step) in steps.into_iter().enumerate() {
        if kept[at] {
            each_fact(&mut step, |fact| {
                if let Some(&new) = anew.get(fact) {
                    *fact = new;
                }
            });
            if let Some(old) = numbers[at] {
                let new = anew.len() as u32;
                anew.insert(FactId(old), FactId(new));
            }
            out.push(step);
        }
    }
    out
}
