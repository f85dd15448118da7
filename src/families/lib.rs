//! Claims on families: every member is a motion like others, tried like others, and dropped.
//!
//! **In:** a derivation as it was read, and the claims that name families. **Out:** a [`FamilyAccount`] for each claim on each
//! family: how many members hold, fail, are undecided, and the members that a reader wants to see, as trajectories to paste.
//!
//! **Guaranteed:** a member's verdict is what `trial` finds for the same trajectory, at samples; where a motion is given by formulas,
//! what these decide exactly counts, as for trajectories. A family is never said to hold more strongly than *sampled*. Members
//! are made from their numbers, a few at a time, so memory does not grow with how many there are. What is counted is a [`Tally`],
//! or, of a measure,
//! a [`Distribution`], which are the same in whatever order members come, so neither threads nor machines change anything; the few members that are
//! shown are made again from their numbers.
//!
//! **Errors of members** are estimated from their own steps first ([`flow::Estimation::Steps`]). A verdict that another estimate could
//! change is taken from further integrations, as a trajectory of the file has them: whether that is so depends on the member alone.

#![forbid(unsafe_code)]

use ::{derivation, diag, expr, findings, flow, latex, number, verdict};

mod account;
mod beside;
mod boundary;
mod budget;
mod confidence;
mod draw;
mod ensemble;
mod map;
mod member;
mod of_file;
mod robustness;
mod separate;
mod sweep;

pub use crate::findings::family::{
    Axis, Boundary, Counts, Crossing, Distribution, Exception, ExtremeAccount, FailingShare, FamilyAccount, FamilyMap,
    FamilySeparation, Join, Joined, MOST_PARTS, MeasureAccount, MemberAccount, Part, PartFault, Ranked, Row, SHARES,
    SlopeAccount, SlopeCell, Slopes, Swept, SweptClaim, SweptMeasure, Tally,
};
pub use confidence::{CONFIDENCE, failing_share};
pub use of_file::Families;
pub use separate::Checker;
pub use sweep::sweep;
