//! What was found on families: counts that can be added in any order, and the members that tell most.

mod account;
mod distribution;
mod exact;
mod map;
mod parts;
mod slope;
mod sums;
mod tally;

pub use account::{
    Exception, ExtremeAccount, FailingShare, FamilyAccount, FamilySeparation, MeasureAccount, MemberAccount, Row,
};
pub use distribution::{Distribution, SHARES};
pub use map::{Axis, Boundary, Crossing, FamilyMap};
pub use parts::{Join, Joined, MOST_PARTS, Part, PartFault, Swept, SweptClaim, SweptMeasure};
pub use slope::{SlopeAccount, SlopeCell, Slopes};
pub use sums::Sums;
pub use tally::{Counts, Ranked, Tally, deviation, gap};
