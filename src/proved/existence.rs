//! Whether a motion is known on which everything given is so, and the claim has values: from none, anything would follow.
//!
//! **In:** a claim, and what it is said to follow from. **Out:** whether there is a motion for certain. **Guaranteed:** one of these is the reason:
//!
//! | what is given | why there is a motion |
//! |---|---|
//! | values at several fixed times, and more than a system | polynomials are found; else one of these: |
//! | the claim applies to a motion of its file, which has its systems and goes through the times that are named | this, see [`motions_of_file`] |
//! | nothing of what moves | a proof needs a point, see [`proof`] |
//! | formulas of what moves | they have values near a point |
//! | a system that is solved for its rates | one begins at every point of its domain |
//! | that, with values at one fixed time | one begins at that time, at a point that has these values, inside of the domain |
//! | a linear system | it goes on for ever: also other fixed times may be named |
//! | nothing of fixed times and places | a point is found through which one passes, see `Step::has_motion` |
//! | nothing of the time | what moves is at rest at a point at which all of it is so |
//! | equations of fields | fields as simple as a coordinate, or half its square, satisfy them |
//! | anything | polynomials of the time are found |

mod given;
mod of_file;

use crate::derivation::{Claim, Derivation};
pub use crate::said::assumed_behind;
use crate::said::{Said, Sayings};
use crate::step::Step;
use given::Given;
pub use of_file::motions_of_file;
use proof::When;

/// Whether a claim speaks of all times of each motion: it chooses none, and its formulas have values at all.
pub fn is_of_all_times(derivation: &Derivation, claim: &Claim) -> bool {
    let said = Said::of_claim(derivation, claim).assuming(claim).with_definitions(derivation);
    !said.chooses && said.is_total(derivation)
}

/// Whether there is, for a proof that is whole, or leaves out times.
pub(crate) fn is_known(
    derivation: &Derivation,
    claim: &Claim,
    said: &Sayings,
    (is_whole, has_motion): (bool, bool),
    inequalities: When,
) -> bool {
    let needs_example = needs_example(derivation, said, is_whole);
    if has_motion && !needs_example {
        return true;
    }
    let given = Given::of(derivation, claim, said);
    if given.clone().is_some_and(Given::holds_at_some_places) {
        return false;
    }
    let example = || !said.given.is_beyond_a_step && crate::motions::has_example(derivation, claim, inequalities);
    if needs_example {
        return example();
    }
    let is_between = given.as_ref().is_none_or(Given::is_between);
    !is_between && given.clone().is_some_and(|mut given| given.has_solution())
        || is_known_by_a_point(derivation, claim, said, is_between)
        || given.clone().is_some_and(|mut given| given.has_rest())
        || given.is_some_and(Given::has_simple_fields)
        || example()
}

/// Whether a point is found; not where a premise calls something by a name of its own, or is further back: that is not looked through.
fn is_known_by_a_point(derivation: &Derivation, claim: &Claim, said: &Sayings, is_between: bool) -> bool {
    !is_between
        && !said.given.is_beyond_a_step
        && !said.names_a_time(derivation)
        && through_a_point(derivation, claim, said)
}

/// Whether polynomials alone will do: values at several fixed times are named, and what is given fixes some of them at two, chooses times, or
/// has no value at some; or the proof leaves out times.
fn needs_example(derivation: &Derivation, said: &Sayings, is_whole: bool) -> bool {
    let Sayings { claimed, given, .. } = said;
    let (of_claim, of_given) = (claimed.instants(derivation), given.instants(derivation));
    let several = of_claim.union(&of_given).count() > 1;
    several && (of_given.len() > 1 || !is_whole || given.chooses || !given.is_total(derivation))
}

/// Whether a point is found through which a motion passes, on which all that is assumed is so on an interval, and the claim has values.
fn through_a_point(derivation: &Derivation, claim: &Claim, said: &Sayings) -> bool {
    let has_motion = |step: Step<'_>| step.typed().has_motion(&said.claimed.formulas, &said.given.formulas);
    Step::of(derivation, claim).and_then(has_motion) == Some(true)
}
