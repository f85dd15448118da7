//! A motion that refutes a step: everything given holds on it, exactly, and the claim does not.
//!
//! **In:** a claim, and what it is said to follow from. **Out:** polynomials for the states, by pieces, numbers for the parameters, and a
//! time at which the claim is false; or none, where a bounded search finds none. **Guaranteed:** everything given is looked at, and what is
//! not known exactly is no refutation; the states are as smooth as the formulas ask, and once more; the fixed times that are named belong
//! to the span.
//!
//! **Why beside the points of [`proof`]:** a point refutes where a motion passes through it. Where what is given vanishes at single times, or
//! says something at chosen times only, that is seen on a motion: x = 2 − t² has ⌊x⌋ = 2 at one time, and t⌊x⌋ = t at all.

mod clock;
mod demand;
mod polynomial;
mod scene;
mod search;
mod value;

use crate::derivation::{Claim, Derivation};
use crate::findings::IdentityAccount;
use crate::findings::standing::Finding;
use crate::said::Sayings;
use crate::step::Step;
use proof::When;
use reason::{Coordinate, Point, Refuting};

/// A motion on which everything given holds, and the claim does not. Fields of one coordinate are motions along that.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Motion {
    /// What moves, and what is constant, by name.
    pub(crate) courses: Vec<(String, String)>,
    /// The name of the time, or of the coordinate.
    pub(crate) clock: String,
    /// Where the claim is false; of a sign that should serve for the whole motion, where the upper one does not.
    pub(crate) first: At,
    /// Where the lower one does not.
    pub(crate) second: Option<At>,
}

/// A time at which a claim is false.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct At {
    pub(crate) t: String,
    /// What the sides are then.
    pub(crate) sides: [String; 2],
}

/// A motion that refutes a claim as a step.
pub(crate) fn refuting(derivation: &Derivation, claim: &Claim, inequalities: When) -> Option<Motion> {
    if names_what_has_no_value(derivation, claim) {
        return None;
    }
    let question = demand::question(derivation, claim, inequalities, demand::Wanted::Fault)?;
    search::search(derivation, claim, &question)
}

/// Whether a motion is found on which everything given holds, and the claim says something.
pub(crate) fn has_example(derivation: &Derivation, claim: &Claim, inequalities: When) -> bool {
    if names_what_has_no_value(derivation, claim) {
        return false;
    }
    let question = demand::question(derivation, claim, inequalities, demand::Wanted::Example);
    question.is_some_and(|question| search::search(derivation, claim, &question).is_some())
}

/// Whether a time or a place that is named may have no value, as that of q(√t₀): a motion would not know where it is.
fn names_what_has_no_value(derivation: &Derivation, claim: &Claim) -> bool {
    let said = Sayings::of(derivation, claim);
    let formulas = said.claimed.formulas.iter().chain(&said.given.formulas);
    !derivation.graph.clone().placed_below(formulas.copied()).is_empty()
}

/// The account of a step that a motion refutes.
pub(crate) fn account(derivation: &Derivation, claim: &Claim, motion: &Motion) -> IdentityAccount {
    let value = |(name, value): &(String, String)| Coordinate::Value(name.clone(), value.clone());
    let point = |at: &At| {
        let [left, right] = at.sides.clone();
        let time = Coordinate::Value(motion.clock.clone(), at.t.clone());
        Point { left, right, at: motion.courses.iter().map(value).chain([time]).collect() }
    };
    let first = point(&motion.first);
    let witness = match &motion.second {
        Some(lower) => Refuting::Signs { upper: first, lower: point(lower) },
        None => Refuting::Point { first, second: None },
    };
    IdentityAccount {
        finding: Finding::of_example(motion.courses.len()),
        from: Step::given(derivation, claim),
        witness: Some(witness),
        ..IdentityAccount::default()
    }
}
