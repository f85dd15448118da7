//! Vector fields, trajectories, and everything that has a value along a motion.
//!
//! **In:** equations of motion ([`VectorField::solve`]), parameters, initial values; or formulas for the states; or another
//! motion ([`Source`]). **Out:** [`Motion`], which gives the value of every leaf a formula can name, with a bound of its
//! error, at every time of its span, and finds events.
//!
//! **Guaranteed:** the rate of a state is the field at the state, and the rate of anything else follows from its definition
//! by series arithmetic: claims are tested on derivatives they had no part in producing. Every value carries an error: that
//! of the trajectory is an estimate from independent integrations (see the module `trajectory` in the source), everything
//! after it is propagated bound by bound. A trajectory that cannot go on is kept up to there ([`Motion::problem`]). The
//! same input gives the same bits on every machine.
//!
//! **Why Taylor series:** the step polynomials are the dense output, of full order; the same recurrences give rates,
//! events and the continuity of angles.

#![forbid(unsafe_code)]

// The notation of the tests, which names crates by way of the whole program.
#[cfg(test)]
extern crate self as rederive;
#[cfg(test)]
use crate as flow;
#[cfg(test)]
use ::{expr, number};
#[cfg(test)]
#[path = "../../tests/flow_support/mod.rs"]
mod flow_support;

mod abreast;
mod angle;
mod arguments;
mod core;
mod cover;
mod definitions;
mod enclosure;
mod error;
mod estimate;
mod expansion;
mod field;
mod hoist;
mod incomplete;
mod kinks;
mod motion;
mod narrow;
mod points;
mod polynomial;
mod program;
mod rapid;
mod resolve;
mod sampler;
mod search;
mod setup;
mod start;
mod taylor;
mod template;
#[cfg(test)]
mod tests;
mod trajectory;
mod zeros;

pub use abreast::Halt;
pub use arguments::may_hide;
pub use enclosure::{Compiled, Enclosure, KnownSteps, Reach, Reaches, Sharp, Steps, Stop, Stretch};
pub use error::{FlowError, Problem};
pub use estimate::Estimation;
pub use field::VectorField;
pub use incomplete::Incomplete;
pub use motion::{Draft, Motion, Observable, Point, Setup, Source};
pub use points::{Points, Sample};
pub use rapid::{Rapid, RapidSearch};
pub use sampler::Sampler;
pub use search::{Search, Searches};
pub use start::{Guess, Start};
pub use template::{Given, Sought, Template};
pub use zeros::{Minimum, Zeros};
