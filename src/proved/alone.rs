//! Whether the word of the prover counts without the checker.
//!
//! **In:** a claim, with all that is given to it. **Out:** whether a proof of it that is not replayed is *proved unreplayed*, or leaves it undecided. **Guaranteed:** where it counts, no fact can be known at some times and
//! be used at others, which is how proofs went wrong: nothing is given; or all is about one time, and what is given of what moves has a value at all; or all of it has a value, and is smooth, at all times, and nothing chooses times or names one.

use crate::said::Sayings;
use derivation::Derivation;

/// Whether it does.
pub(crate) fn counts(derivation: &Derivation, said: &Sayings) -> bool {
    let Sayings { claimed, given, .. } = said;
    let nothing_given = given.formulas.is_empty();
    let at = claimed.one_place(derivation);
    nothing_given
        || claimed.one_time(derivation).is_some_and(|time| given.one_time(derivation) == Some(time))
            && (given.is_total(derivation) || !given.moves(derivation))
        || (!given.names_a_time(derivation)
            || !given.names_an_instant(derivation) && at.is_some() && given.one_place(derivation) == at)
            && !given.chooses
            && claimed.is_total(derivation)
            && given.is_total(derivation)
}
