//! Restrict, open, everywhere: what is known at some times, at others.
//!
//! **Restrict.** *Theorem.* What holds at each time of a set holds at each time of a subset; and at a fixed time c of it, where each symbol that
//! moves has its value at c. *Proof.* Evaluation at c commutes with every operation, since operations are taken time by time, and a
//! rate at c is the rate, taken at c. □ *Conditions.* c has a value, and is one of the fixed times of the sequent, which T contains.
//! From S₀ to c only if c is chosen: every selector is true at c, and every assumption has a value there. *Trap.* That a premise is
//! assumed says nothing of c.
//!
//! **Open.** *Theorem.* S₀ is open in T if every selector is <, > or ≠, between sides that are continuous where they have values, on
//! neighbourhoods, and if every assumption has values on a neighbourhood of each time at which it has one. *Proof.* A continuous function
//! that is not 0 (positive) at t is not 0 (positive) beside t. □ *Conditions.* All needs of both sides strict, or known at all times; nothing leaps
//! (or it is known not to, at the chosen times); no rate of a definition, whose values are not known to lie in an open set. *Traps.*
//! ≤ and ≥ choose single times; so does √(−t²) = 0; so does ⌊x⌋ > 1 its ends.
//!
//! **Everywhere.** *Theorem.* S₀ = T if every selector is true, and every assumption has a value, at all times. *Proof.* Definition of S₀. □

use super::{made, needs_of};
use crate::context::Says;
use crate::draft::{Draft, Made};
use crate::needs::{Need, Needs, continuous, frozen, needs};
use crate::rules::given::certain_of;
use crate::signs::{of_sense, signs};
use crate::step::FactId;
use crate::term::Sense;
use crate::when::{Instant, When};

/// A fact at fewer times.
pub(super) fn restrict(draft: &mut Draft, id: FactId, to: &When, because: &[FactId]) -> Result<Made, String> {
    let fact = draft.get(id)?;
    let When::At(instant) = *to else {
        if !draft.exists(to) || !(draft.contained(to, &fact.when) || draft.is_universal(&fact)) {
            return Err("these are not times at which the fact is known".to_owned());
        }
        return Ok(made("restrict", vec![id], fact.says, to.clone(), fact.needs));
    };
    let c = draft.context.instant(instant)?;
    let when = if draft.is_whole(&fact.when) {
        // In a case that does not move, it is known in the case only.
        if fact.when.is_in_case() { fact.when.clone() } else { When::At(instant) }
    } else if draft.contained(&When::Chosen, &fact.when) {
        is_chosen(draft, instant, because)?;
        When::At(instant)
    } else {
        return Err("the fixed time is not known to be one at which the fact is known".to_owned());
    };
    let mut open = needs(&mut draft.context, c);
    for need in fact.needs {
        open.insert(Need { value: frozen(&mut draft.context, need.value, c), ..need });
    }
    let [left, right] = fact.says.sides().map(|e| frozen(&mut draft.context, e, c));
    let from = [&[id], because].concat();
    Ok(made("restrict", from, Says { left, sense: fact.says.sense, right }, when, open))
}

/// Whether facts show that a fixed time is chosen.
fn is_chosen(draft: &mut Draft, instant: Instant, because: &[FactId]) -> Result<(), String> {
    let (selectors, assumed) = (draft.context.selectors.clone(), draft.context.assumed.clone());
    let c = draft.context.instant(instant)?;
    let at_c = |draft: &mut Draft, says: Says| {
        let [left, right] = says.sides().map(|e| frozen(&mut draft.context, e, c));
        Says { left, sense: says.sense, right }
    };
    for says in selectors {
        let says = at_c(draft, says);
        is_shown(draft, says, because, &When::At(instant))?;
    }
    for says in assumed {
        let says = at_c(draft, says);
        let values = needs_of(draft, says);
        draft.all_shown(values, because, &When::At(instant))?;
    }
    Ok(())
}

/// Whether facts that need nothing show a relation, and that its sides have values.
fn is_shown(draft: &mut Draft, says: Says, because: &[FactId], when: &When) -> Result<(), String> {
    let values = needs_of(draft, says);
    draft.all_shown(values, because, when)?;
    let (known, open) = draft.known_signs(because, when)?;
    let difference = draft.context.difference(says);
    if open.is_empty() && signs(&draft.context, difference, &known).within(of_sense(says.sense)) {
        return Ok(());
    }
    Err(format!("not shown: `{}`", draft.context.latex(says)))
}

/// Shows that S₀ is open.
pub(super) fn open(draft: &mut Draft, because: &[FactId]) -> Result<(), String> {
    let always: Vec<FactId> = because.iter().copied().filter(|id| draft.known_at(*id, &When::Always).is_ok()).collect();
    for says in draft.context.selectors.clone() {
        match says.sense {
            Sense::NotEqual | Sense::Less => {}
            Sense::Equal | Sense::LessOrEqual => return Err("a selector may choose single times".to_owned()),
        }
        for side in says.sides() {
            let own = needs(&mut draft.context, side);
            let kept = strictness(draft, own, &always)?;
            let guards = continuous(&mut draft.context, side, &kept);
            let open: Needs = guards.difference(&certain_of(draft, says)).copied().collect();
            draft.all_shown(open, because, &When::Chosen)?;
        }
    }
    for says in draft.context.assumed.clone() {
        let own = needs_of(draft, says);
        let kept = strictness(draft, own.clone(), &always)?;
        let guards = crate::needs::around(&mut draft.context, &own, &kept);
        let open: Needs = guards.difference(&certain_of(draft, says)).copied().collect();
        draft.all_shown(open, because, &When::Chosen)?;
    }
    draft.opened = true;
    Ok(())
}

/// The needs v ≥ 0 that hold at all times, by facts.
pub(crate) fn strictness(draft: &Draft, needs: Needs, always: &[FactId]) -> Result<Needs, String> {
    let mut kept = Needs::new();
    for need in needs {
        let single: Needs = [need].into_iter().collect();
        if draft.all_shown(single, always, &When::Always).is_ok() {
            kept.insert(need);
        }
    }
    Ok(kept)
}

/// Shows that S₀ = T.
pub(super) fn everywhere(draft: &mut Draft, because: &[FactId]) -> Result<(), String> {
    for says in draft.context.selectors.clone() {
        is_shown(draft, says, because, &When::Always)?;
    }
    for says in draft.context.assumed.clone() {
        let values = needs_of(draft, says);
        draft.all_shown(values, because, &When::Always)?;
    }
    draft.everywhere = true;
    Ok(())
}
