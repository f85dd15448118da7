//! The numbers at the ends of ranges, as the file has them.
//!
//! **In:** an expression without leaves. **Out:** an interval that contains its value, and the binary64 number that is shown of it.

use crate::expr::tape::Tape;
use crate::expr::{Expr, Graph};
use crate::number::Interval;

/// The value of an expression without leaves.
pub(super) fn enclosed(graph: &Graph, e: Expr) -> Option<Interval> {
    let tape = Tape::compile(graph, &[], &[e]).ok()?;
    let mut slots = tape.slots::<Interval>(&());
    tape.evaluate(&(), &[], &mut slots).pop()?.ok()
}

/// The binary64 number by which a reader knows a number of the file.
pub(super) fn nearest(graph: &Graph, e: Expr, enclosure: Interval) -> f64 {
    graph.as_constant(e).map_or(enclosure.mid(), |r| r.to_f64().value())
}
