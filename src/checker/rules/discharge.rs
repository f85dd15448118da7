//! Discharge: a need that is known to hold is no need.
//!
//! **Theorem.** If a fact says, at all times of a set, that a need holds wherever its own needs do, the need may be replaced by those. *Proof.* Let the
//! needs of the result hold at t. Those of the facts used do, so that they are true at t, and with them the need. □
//!
//! **Conditions.** All facts are known at the times of the result: those at which all of them are. *Traps.* That d = 0 leads to a
//! contradiction *on an interval* does not say that d ≠ 0 at t (S8: x(0) = 0 and ẋ = 1 get on well); that the claim needs r ≠ 0 says so in the case that it
//! has a value, and there only (S2, S7).

use super::made;
use crate::draft::{Draft, Made};
use crate::step::FactId;

pub(super) fn discharge(draft: &mut Draft, id: FactId, because: &[FactId]) -> Result<Made, String> {
    let fact = draft.get(id)?;
    let from = [&[id], because].concat();
    let when = draft.common(&from)?;
    let open = draft.undischarged(fact.needs, because, &when)?;
    Ok(made("discharge", from, fact.says, when, open))
}
