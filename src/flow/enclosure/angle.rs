//! Angles that are followed through any number of turns.
//!
//! An angle atan2(y, x) jumps where (x, y) crosses the negative half-axis, though the angle itself does not. It is rewritten as
//! atan2(σy, σx) + δ, where σ = ±1 is chosen for each stretch of time so that (σx, σy) stays away from that half-axis, and δ
//! is a multiple of π. From one stretch to the next δ follows from continuity: the two values at the common time differ by a
//! multiple of 2π, and only one fits.

use super::{Enclosure, Reach};
use crate::definitions::{Continued, Definitions, fresh};
use crate::error::FlowError;
use expr::{Expr, Graph, Leaf, Node, Op};
use number::{Interval, NoValue, Number, Scalar};

/// Shortest stretch that is tried, as a part of the span.
const SHORTEST: f64 = 1e-7;

/// A stretch on which one choice of σ serves.
#[derive(Clone, Copy, Debug)]
struct Cell {
    from: f64,
    to: f64,
    /// δ/π.
    half_turns: i64,
    /// Whether σ = −1.
    flipped: bool,
}

#[derive(Clone, Debug)]
pub(super) struct Angle {
    /// δ
    pub(super) turns: Leaf,
    /// σ
    pub(super) side: Leaf,
    cells: Vec<Cell>,
}

/// n·π
fn half_turns(n: i64) -> Interval {
    if n == 0 {
        return Interval::ZERO;
    }
    let mut pi = Interval::ZERO;
    match pi.pi(&()) {
        Ok(()) => pi * Interval::point(n as f64),
        Err(_) => Interval::INVALID,
    }
}

impl Angle {
    /// δ and σ on a stretch that does not leave its cell.
    pub(super) fn turns(&self, stretch: Interval) -> Result<(Interval, Interval), NoValue> {
        let at = self.cells.partition_point(|c| c.to < stretch.hi());
        let cell = self.cells.get(at).filter(|c| c.from <= stretch.lo()).ok_or(NoValue::Indeterminate)?;
        Ok((half_turns(cell.half_turns), Interval::point(if cell.flipped { -1.0 } else { 1.0 })))
    }
}

impl Enclosure {
    /// The times at which some angle changes its representation; ascending.
    pub fn angle_boundaries(&self) -> Vec<f64> {
        let mut times: Vec<f64> = self.angles.iter().flat_map(|a| &a.cells).flat_map(|c| [c.from, c.to]).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// An angle as a quantity that is continuous from the initial time on.
    pub(super) fn follow(&mut self, graph: &mut Graph, raw: Expr) -> Result<Expr, FlowError> {
        let (turns, side) = (fresh(graph, "turns"), fresh(graph, "side"));
        let (d, sign) = (graph.leaf(turns), graph.leaf(side));
        let sides = match *graph.node(raw) {
            Node::Binary(Op::Arctan2, y, x) => Some((y, x)),
            _ => None,
        };
        let turned = match sides {
            Some((y, x)) => {
                let (y, x) = (graph.mul(sign, y), graph.mul(sign, x));
                graph.binary(Op::Arctan2, y, x)
            }
            None => raw,
        };
        let roots = sides.map_or(vec![raw], |(y, x)| vec![y, x]);
        let compiled = self.compile_resolved(graph, &roots)?;
        let found = self.cells(&compiled, sides.is_some());
        self.angles.push(Angle { turns, side, cells: found });
        let followed = graph.add(turned, d);
        // On each of the cells (σx, σy) is off the cut.
        let rate = self.derivative(graph, turned).ok().map(|rate| graph.continued(turned, rate));
        self.continued.push(Continued { angle: followed, raw, rate });
        Ok(followed)
    }

    /// Whether an angle is continuous on a stretch, and for which σ.
    fn sort(&self, compiled: &super::Compiled, stretch: Interval, two_sided: bool) -> Option<(bool, Vec<Reach>)> {
        let reach: Vec<Reach> =
            self.over(compiled, &self.stretch(stretch)).into_iter().collect::<Result<_, _>>().ok()?;
        if !two_sided {
            return Some((false, reach));
        }
        let (y, x) = (reach[0].range(), reach[1].range());
        let flipped = x.lo() < 0.0 && (x.hi() <= 0.0 || y.contains(0.0));
        representative(flipped, y, x).ok().map(|_| (flipped, reach))
    }

    fn cells(&self, compiled: &super::Compiled, two_sided: bool) -> Vec<Cell> {
        let (from, to) = self.reach();
        let boundaries = self.boundaries();
        let mut ahead =
            self.chain(compiled, two_sided, boundaries.iter().copied().filter(|&t| t >= self.initial_time), to);
        let back =
            self.chain(compiled, two_sided, boundaries.iter().rev().copied().filter(|&t| t <= self.initial_time), from);
        let mut all: Vec<Cell> = back.into_iter().rev().collect();
        all.append(&mut ahead);
        all
    }

    /// Cells from the initial time on, in one direction, as far as continuity can be shown.
    fn chain(
        &self,
        compiled: &super::Compiled,
        two_sided: bool,
        boundaries: impl Iterator<Item = f64>,
        end: f64,
    ) -> Vec<Cell> {
        let shortest = SHORTEST * (self.span.1 - self.span.0);
        let mut stops: Vec<f64> = boundaries.collect();
        stops.reverse();
        let mut cells: Vec<Cell> = Vec::new();
        // What the angle was at the end of the last cell.
        let mut before: Option<Interval> = None;
        let Some(mut at) = stops.pop() else { return cells };
        while let Some(next) = stops.pop().filter(|_| at != end) {
            let stretch = Interval::point(at).hull(Interval::point(next));
            let sorted = self.sort(compiled, stretch, two_sided);
            let Some((flipped, reach)) = sorted else {
                let middle = 0.5 * (at + next);
                if (next - at).abs() < shortest || middle == at || middle == next {
                    return cells;
                }
                stops.push(next);
                stops.push(middle);
                continue;
            };
            let value = |t: f64| {
                let here = |i: usize| reach[i].at(t);
                if two_sided { representative(flipped, here(0), here(1)) } else { Ok(here(0)) }
            };
            let (Ok(first), Ok(last)) = (value(at), value(next)) else { return cells };
            let parity = i64::from(flipped);
            let count = match before {
                // At the start the angle is the principal value.
                None if !flipped => Some(0),
                None => {
                    let Ok(y) = reach[0].at(at).checked() else { return cells };
                    // atan2(y, x) = atan2(−y, −x) ± π, with + above the axis and on it.
                    if y.lo() >= 0.0 {
                        Some(1)
                    } else if y.hi() < 0.0 {
                        Some(-1)
                    } else {
                        None
                    }
                }
                Some(before) => fitting(before - first, parity),
            };
            let Some(half) = count else { return cells };
            before = Some(last + half_turns(half));
            cells.push(Cell { from: at.min(next), to: at.max(next), half_turns: half, flipped });
            at = next;
        }
        cells
    }
}

/// atan2(σy, σx)
fn representative(flipped: bool, y: Interval, x: Interval) -> Result<Interval, NoValue> {
    let mut out = Interval::ZERO;
    if flipped { out.arctan2(&(), &-y, &-x) } else { out.arctan2(&(), &y, &x) }?;
    Ok(out)
}

/// The only n of a parity with n·π in an interval.
fn fitting(difference: Interval, parity: i64) -> Option<i64> {
    let near = (difference.mid() / std::f64::consts::PI).round() as i64;
    let mut candidates = (near - 2..=near + 2)
        .filter(|n| n.rem_euclid(2) == parity && half_turns(*n).intersection(difference).is_some());
    let one = candidates.next()?;
    (candidates.next().is_none() && difference.width() < 6.0).then_some(one)
}
