//! Signs that are known at all times tie the values of a motion at different times: what is never 0 does not change its sign, and what grows does
//! not come back.
//!
//! **In:** the signs among the premises, and a point. **Out:** whether a motion with the values of the point at its several times can keep them.
//! **Guaranteed:** where rates or the time itself are bound, or a straight way from value to value leaves what is allowed, the answer is no; the
//! point then refutes nothing.

use super::super::known::When;
use super::super::outcome::{Point, Premises};
use super::super::witness::{decimals, values_at};
use expr::{Expr, Graph, Leaf, Node};
use number::Bounded;

/// Places on the way from one value to another.
const STEPS: u32 = 16;
/// A value of what the point does not name.
const FREE: f64 = 0.7109375;

/// Signs of what moves, known at all times.
#[derive(Clone, Debug, Default)]
pub(super) struct Signs {
    /// Not 0.
    nonzero: Vec<Expr>,
    /// Positive, or not negative.
    positive: Vec<Expr>,
    /// Whether rates are bound, or the time is named.
    of_rates: bool,
    /// Whether something is known of the time itself: t ≠ 0 parts −1 from 1.
    of_time: bool,
    /// What moves in them, at the present.
    moving: Vec<Leaf>,
}

impl Signs {
    /// Those among the premises.
    pub(super) fn of(graph: &Graph, premises: &Premises, time: Leaf, moves: &impl Fn(Leaf) -> bool) -> Signs {
        let mut out = Signs::default();
        if premises.present != When::Always {
            return out;
        }
        let now = |l: &Leaf| l.instant.is_none() && moves(*l);
        // Between times that are positive all are.
        let is_time = |e: Expr| matches!(graph.node(e), Node::Leaf(l) if *l == time);
        let ordered = premises.positive.iter().chain(&premises.not_negative).copied().filter(|&e| !is_time(e));
        out.of_time = graph.leaves_within(premises.nonzero.iter().copied().chain(ordered)).contains(&time);
        let changes = |e: &Expr| graph.leaves_within([*e]).iter().any(now);
        out.nonzero = premises.nonzero.iter().copied().filter(&changes).collect();
        out.positive = premises.positive.iter().chain(&premises.not_negative).copied().filter(&changes).collect();
        let leaves = graph.leaves_within(out.nonzero.iter().chain(&out.positive).copied());
        out.of_rates = leaves.iter().any(|l| *l == time || now(l) && l.rate > 0);
        out.moving = leaves.into_iter().filter(now).collect();
        out
    }

    /// Whether a motion can have the values of a point at its several times and keep the signs.
    pub(super) fn allow(&self, graph: &Graph, point: &Point) -> bool {
        if self.of_time && point.values.iter().any(|(l, _)| l.instant.is_some()) {
            return false;
        }
        let of = |l: &Leaf| self.moving.iter().any(|m| (m.symbol, m.component) == (l.symbol, l.component));
        let mut times: Vec<Option<Expr>> =
            point.values.iter().map(|(l, _)| l).filter(|l| of(l)).map(|l| l.instant).collect();
        times.sort_unstable();
        times.dedup();
        if times.len() < 2 {
            return true;
        }
        if self.of_rates {
            return false;
        }
        let known = values_at(point);
        let value = |l: &Leaf, instant: Option<Expr>| {
            let own = known.get(&Leaf { instant, ..*l }).or_else(|| known.get(l));
            own.map_or(FREE, |v| v.value)
        };
        let facts: Vec<Expr> = self.nonzero.iter().chain(&self.positive).copied().collect();
        let signs_on_the_way = |from: Option<Expr>, to: Option<Expr>| {
            let mut first: Option<Vec<bool>> = None;
            (0..=STEPS).all(|step| {
                let share = f64::from(step) / f64::from(STEPS);
                let mut values = known.clone();
                for leaf in &self.moving {
                    let at = (1.0 - share) * value(leaf, from) + share * value(leaf, to);
                    values.insert(*leaf, Bounded::exact(at));
                }
                let found: Option<Vec<Bounded>> = decimals(graph, &facts, &values).into_iter().collect();
                let Some(found) = found else { return false };
                if !found.iter().all(|v| v.value.abs() > v.error) {
                    return false;
                }
                let signs: Vec<bool> = found.iter().map(|v| v.value > 0.0).collect();
                signs[self.nonzero.len()..].iter().all(|s| *s) && *first.get_or_insert_with(|| signs.clone()) == signs
            })
        };
        times.iter().enumerate().all(|(i, &a)| times[i + 1..].iter().all(|&b| signs_on_the_way(a, b)))
    }
}
