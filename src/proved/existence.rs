//! Whether a motion is known on which everything given is so: from none, anything would follow.
//!
//! **In:** a claim, and what it is said to follow from. **Out:** whether there is a motion for certain. **Guaranteed:** one of these is the reason:
//!
//! | what is given | why there is a motion |
//! |---|---|
//! | the claim has motions in its file | these |
//! | nothing of what moves | a proof needs a point, see [`proof`] |
//! | formulas of what moves | they have values near a point |
//! | a system that is solved for its rates | one begins at every point of its domain |
//! | that, with values at one fixed time | one begins at that time, at a point that has these values, inside of the domain |
//! | nothing of fixed times and places | a point is found through which one passes, see [`Step::has_motion`] |
//! | nothing of the time | what moves is at rest at a point at which all of it is so |
//! | equations of fields | fields as simple as a coordinate, or half its square, satisfy them |
//! | anything | polynomials of the time are found |

mod given;

use crate::derivation::{Claim, Derivation};
use crate::step::Step;
use given::Given;
use proof::When;

/// Whether there is.
pub(crate) fn is_known(derivation: &Derivation, claim: &Claim, inequalities: When) -> bool {
    if !claim.trajectories.is_empty() || !claim.families.is_empty() {
        return true;
    }
    let given = || Given::of(derivation, claim, inequalities);
    given().is_some_and(|mut given| given.has_solution())
        || through_a_point(derivation, claim, inequalities)
        || given().is_some_and(|mut given| given.has_rest())
        || given().is_some_and(|given| given.has_simple_fields())
        || crate::motions::has_example(derivation, claim, inequalities)
}

/// Whether a point is found through which a motion passes, where nothing is said of fixed times and places.
fn through_a_point(derivation: &Derivation, claim: &Claim, inequalities: When) -> bool {
    if crate::alone::names_a_time(derivation, claim) {
        return false;
    }
    let step = Step::of(derivation, claim);
    let step = step.map(|step| if inequalities == When::Always { step.typed() } else { step });
    step.and_then(Step::has_motion) == Some(true)
}
