//! Given: what the sequent says, at the times at which it says so.
//!
//! **Theorem.** On a motion that satisfies the sequent, an equation of a system is true at all times, a premise is not false at any time, an
//! assumption is true at the times of S₀, and so is a selector.
//! *Proof.* This is what "satisfies" means: see [`Sequent`](crate::Sequent). □
//! A premise that is not false at t is true there if both sides have values, which its needs say. Systems, assumptions and selectors
//! are true, so that both sides have values: what certainly is needed for that holds, and only that. (What stands in the formula
//! for the rate of a definition may be lacking though the rate exists; it stays among the needs.)
//!
//! **Another claim** is true at the times of *its* S₀′ (those at which its selectors are true and its hypotheses have values), if its hypotheses are true at *all* times of S₀′. So its selectors are wanted
//! at the times of the result, and its hypotheses at times that contain S₀′: all of T; or S₀, if S₀ contains S₀′. *Theorem.* It does, if (1) each of our selectors is one of its selectors, or does not move;
//! and (2) each of our assumptions is one of its hypotheses, or has values wherever certain needs of its selectors and hypotheses hold. *Proof.* Let t ∈ S₀′. A selector that does not move is true at all times or at none, and S₀ is taken to have a
//! time in it; the others are true at t by (1). Its selectors and hypotheses have values at t, so that what they certainly need holds, and our assumptions have values at t by (2). So t ∈ S₀. □ (That each of its selectors is one of ours is asked for, too, so that the result is known on S₀.)
//!
//! **Traps.** An equation that is assumed is known at the chosen times and at no others, 0 perhaps not among them (x > 1, z = 2 says
//! nothing of z(0)). A hypothesis that is true at one time (ẋ = 0) does not bring the conclusion of a claim (x = x(0)) there.

use super::needs_of;
use crate::context::Says;
use crate::draft::{Draft, Made};
use crate::fact::Because;
use crate::needs::{Need, Needs, certain, needs};
use crate::signs::{of_sense, signs};
use crate::step::{FactId, Given};
use crate::when::{CaseId, When};

fn relation(draft: &Draft, given: Given) -> Result<Says, String> {
    let context = &draft.context;
    let (list, at) = match given {
        Given::System(at) => (&context.systems, at),
        Given::Premise(at) => (&context.premises, at),
        Given::Assumed(at) => (&context.assumed, at),
        Given::Selector(at) => (&context.selectors, at),
        Given::Claimed(at) => {
            return context.claims.get(at as usize).map(|c| c.says).ok_or_else(|| "no such claim".to_owned());
        }
    };
    list.get(at as usize).copied().ok_or_else(|| "nothing such is given".to_owned())
}

/// What certainly holds where a relation has values on both sides.
pub(crate) fn certain_of(draft: &mut Draft, says: Says) -> Needs {
    let mut out = certain(&mut draft.context, says.left);
    out.extend(certain(&mut draft.context, says.right));
    out
}

/// A relation of the sequent.
pub(super) fn given(draft: &mut Draft, given: Given, because: &[FactId]) -> Result<Made, String> {
    let says = relation(draft, given)?;
    let mut needs = needs_of(draft, says);
    let when = match given {
        Given::System(_) => When::Always,
        Given::Premise(_) => {
            return Ok(Made { says, when: When::Always, needs, because: Because::Given(given, vec![]) });
        }
        Given::Assumed(_) | Given::Selector(_) => When::Chosen,
        Given::Claimed(at) => {
            let when = claimed(draft, at, because)?;
            return Ok(Made { says, when, needs, because: Because::Given(given, because.to_vec()) });
        }
    };
    for need in certain_of(draft, says) {
        needs.remove(&need);
    }
    Ok(Made { says, when, needs, because: Because::Given(given, vec![]) })
}

/// The times at which another claim may be used.
fn claimed(draft: &mut Draft, at: u32, because: &[FactId]) -> Result<When, String> {
    let claim = draft.context.claims.get(at as usize).cloned().ok_or("no such claim")?;
    let shows = |draft: &mut Draft, says: Says, when: &When| -> Result<bool, String> {
        let at_these: Vec<FactId> = because.iter().copied().filter(|id| draft.known_at(*id, when).is_ok()).collect();
        let (known, needs) = draft.known_signs(&at_these, when)?;
        let difference = draft.context.difference(says);
        let values = needs_of(draft, says);
        let own = draft.all_shown(values, &at_these, when).is_ok();
        Ok(own && needs.is_empty() && signs(&draft.context, difference, &known).within(of_sense(says.sense)))
    };
    let is_among = |says: &Says, list: &[Says]| list.iter().any(|other| other.is(*says));
    let still = |says: &Says| says.sides().into_iter().all(|e| !draft.context.moves(e));
    let same_selectors = claim.selectors.iter().all(|s| is_among(s, &draft.context.selectors))
        && draft.context.selectors.iter().all(|s| is_among(s, &claim.selectors) || still(s));
    let same_times = same_selectors && {
        let mut certain = Needs::new();
        for says in claim.selectors.iter().chain(&claim.hypotheses) {
            certain.extend(certain_of(draft, *says));
        }
        let has_value = |draft: &mut Draft, says: Says| needs_of(draft, says).is_subset(&certain);
        draft.context.assumed.clone().into_iter().all(|a| is_among(&a, &claim.hypotheses) || has_value(draft, a))
    };
    let mut only_chosen = false;
    for &hypothesis in &claim.hypotheses {
        let always = shows(draft, hypothesis, &When::Always)?;
        only_chosen |= !always;
        let here = same_times && shows(draft, hypothesis, &When::Chosen)?;
        if !(always || here) {
            return Err("a hypothesis of the claim is not known at all times at which it is assumed".to_owned());
        }
    }
    if claim.hypotheses.is_empty() && claim.selectors.is_empty() {
        return Ok(When::Always);
    }
    let candidates: Vec<When> = [When::Always, When::Chosen].into_iter().chain([draft.common(because)?]).collect();
    for when in candidates {
        // A time at which no value of a hypothesis is known need not be one of the claim.
        let mut all = !only_chosen || draft.contained(&when, &When::Chosen);
        for &selector in &claim.selectors {
            all &= shows(draft, selector, &when)?;
        }
        if all {
            return Ok(when);
        }
    }
    Err("a selector of the claim is not known to be true".to_owned())
}

/// A need of something that has a value.
pub(super) fn has_value(draft: &mut Draft, given: Given, need: u32) -> Result<Made, String> {
    let says = relation(draft, given)?;
    let when = match given {
        Given::System(_) => When::Always,
        Given::Assumed(_) | Given::Selector(_) => When::Chosen,
        Given::Premise(_) | Given::Claimed(_) => return Err("a premise need not have a value".to_owned()),
    };
    let all: Vec<Need> = certain_of(draft, says).into_iter().collect();
    let (says, needs) = need_of(draft, &all, need)?;
    Ok(Made { says, when, needs, because: Because::Given(given, vec![]) })
}

/// One of the needs that certainly hold, and what else its own value needs.
fn need_of(draft: &mut Draft, all: &[Need], at: u32) -> Result<(Says, Needs), String> {
    let need = *all.get(at as usize).ok_or("no such need")?;
    let mut open = needs(&mut draft.context, need.value);
    open.retain(|need| !all.contains(need));
    Ok((draft.says_of(need).ok_or("no zero")?, open))
}

/// A need of the claim, in the case that it has a value.
pub(super) fn claim_has_value(draft: &mut Draft, need: u32, within: &When) -> Result<Made, String> {
    if !draft.exists(within) {
        return Err("there are no such times".to_owned());
    }
    let all = draft.claim_needs.clone();
    let (says, needs) = need_of(draft, &all, need)?;
    Ok(Made { says, when: within.clone().within(CaseId::CLAIM), needs, because: Because::Supposed })
}
