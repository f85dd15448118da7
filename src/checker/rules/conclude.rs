//! Conclude: a fact is the claim.
//!
//! **Theorem.** If the claim is true at each time of S₀ at which it has a value, it is not false at any time of S₀. *Proof.* A relation of which a
//! side has no value is not false. □ *Conditions.* The fact says the relation of the claim, and is known at all times of S₀, or at those in the
//! case that the claim has a value. What the fact still needs is left out: the claim is shown where it holds. *Traps.* What is divided by may be 0 everywhere, so that all is left out: where that is seen, as an identity or by signs, the end is refused; where it is not, as in
//! sin²x + cos²x − 1 ≠ 0, the proof says little, and the report that a case is left out. Facts that are known in
//! another case, or at a fixed time, do not say the claim.

use crate::draft::Draft;
use crate::needs::allowed;
use crate::polynomial;
use crate::signs::{KnownSigns, Signs, signs};
use crate::step::FactId;
use crate::when::{CaseId, When};

pub(super) fn conclude(draft: &mut Draft, id: FactId) -> Result<(), String> {
    let times = When::Chosen.within(CaseId::CLAIM);
    let fact = draft.known_at(id, &times)?;
    if !fact.says.is(draft.context.claim) {
        return Err(format!("`{}` is not the claim", draft.context.latex(fact.says)));
    }
    for need in &fact.needs {
        let possible = signs(&draft.context, need.value, &KnownSigns::new());
        let is_nothing = polynomial::vanishes(&draft.context.graph, need.value) == Some(true);
        let possible = if is_nothing { Signs::ZERO } else { possible };
        if possible.and(allowed(need.sign)) == Signs::NONE {
            return Err("what the fact needs is never so".to_owned());
        }
    }
    draft.shown = Some((id, fact.needs));
    Ok(())
}
