//! Rate: the derivative by time of an equation.
//!
//! **Theorem.** Let l = r at each time of a set U that is open in T at which the needs N hold. At a time t ∈ U at which N hold on a neighbourhood, and
//! l and r are differentiable, l′ = r′. *Proof.* l − r is 0 on a neighbourhood of t in T, which has more than one time; the limit of its
//! quotients of differences is 0 (one-sided at an end of T). By the chain rule the derivatives are those that are written. □
//!
//! **Conditions.** The set is open: `Always`, `ChosenOpen`, or a case that is. N are strict in the result (v > 0 for v ≥ 0), since a
//! need that holds at t only is no ground; to them come the needs of the derivatives and the edges of both sides. The symbols
//! have the rates that are written.
//!
//! **By a coordinate.** The same, in a neighbourhood in T, along the coordinate alone: T is open, so that it contains a segment around each point.
//!
//! **Traps.** At a fixed time, or at chosen times that may be single, an equation has no rate. r = √(x² + y²) has none where r = 0,
//! though the equation rw = r holds there.

use super::made;
use crate::context::Says;
use crate::derivative::{By, derivative_by};
use crate::draft::{Draft, Made};
use crate::needs::{Needs, around, needs, smooth};
use crate::step::FactId;
use expr::Leaf;

pub(super) fn partial(draft: &mut Draft, id: FactId, by: &str, component: u16) -> Result<Made, String> {
    let coordinate = Leaf::now(draft.context.symbol(by)?, component);
    let at = draft.context.graph.coordinate(coordinate).ok_or("no such coordinate")?;
    rate(draft, id, By::Coordinate(at))
}

pub(super) fn rate(draft: &mut Draft, id: FactId, by: By) -> Result<Made, String> {
    let fact = draft.equation(id)?;
    if !draft.is_open(&fact.when) {
        return Err("an equation that is known at single times has no rate".to_owned());
    }
    let context = &mut draft.context;
    let mut open = around(context, &fact.needs, &Needs::new());
    let mut sides = [fact.says.left, fact.says.right];
    for side in &mut sides {
        open.extend(smooth(context, *side));
        *side = derivative_by(context, *side, by)?;
        open.extend(needs(context, *side));
    }
    let says = Says { left: sides[0], sense: fact.says.sense, right: sides[1] };
    Ok(made("rate", vec![id], says, fact.when, open))
}
