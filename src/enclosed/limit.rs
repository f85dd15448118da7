//! Limits, at a time of the span and at infinity.
//!
//! **At a time** of the span the limit is the value there, if the quantity is continuous around that time. A quotient a/b of
//! which both sides are 0 there, exactly, is replaced by the quotient of their rates: around that time a/b takes no values but
//! those of a′/b′ (Cauchy's mean value theorem, where b′ ≠ 0), and tends to its value there (l'Hospital's rule).
//!
//! **At infinity** a limit is found by the laws of limits, see [`Tail`]: never from values at large times. That is possible
//! for motions given by formulas. It is compared with the limits of the terms, and not with what they were along the span.

use super::cover::Along;
use super::ready::{Ready, Shown, TELLING, certain};
use crate::expr::{Expr, Graph, Node, Op};
use crate::flow::Reach;
use crate::latex::{LimitPoint, RelationKind};
use crate::number::{Interval, Limit, NoValue, Number, Rational, Scalar, Tail};
use crate::verdict::Witness;
use claim::comparison::Comparison;
use reason::{Compared, Enclosing, Instant, Plain, Reason, Refutation};

/// How often a quotient is replaced by that of the rates.
const DEPTH: usize = 3;
/// Most quotients of the form 0/0 in one limit.
const MOST: usize = 6;
/// Around a time: this part of the span.
const AROUND: f64 = 1e-9;

pub(super) fn limit(ready: &Ready, point: &LimitPoint, along: &mut Along) -> Shown {
    let ([comparison], 1) = (ready.group.comparisons.as_slice(), ready.signs) else {
        return Shown::Nothing(Plain::LimitNotEnclosed.into());
    };
    let shown = match point {
        LimitPoint::Finite(at) => at_time(ready, comparison, *at, along),
        LimitPoint::PlusInfinity => at_infinity(ready, comparison, true, along),
        LimitPoint::MinusInfinity => at_infinity(ready, comparison, false, along),
    };
    shown.unwrap_or_else(Shown::Nothing)
}

/// A limit at a time of the span.
fn at_time(ready: &Ready, comparison: &Comparison, at: Expr, along: &mut Along) -> Result<Shown, Reason> {
    let mut time = Interval::ZERO;
    let exact = along.graph.as_constant(at).cloned().filter(|r| time.rational(&(), r).is_ok());
    let (from, to) = along.span;
    let around = time.widened(0.0, AROUND * (to - from));
    let span = Interval::new(from, to).ok().filter(|s| s.contains_interval(time));
    let (Some(exact), Some(around)) = (exact, span.and_then(|s| around.intersection(s))) else {
        return Err(Plain::LimitNotEnclosed.into());
    };
    let t = time.mid();
    // Before and after: an angle may be represented in two ways.
    let sides = [Interval::new(around.lo(), time.hi()), Interval::new(time.lo(), around.hi())];
    let sides: Vec<Interval> = sides.into_iter().flatten().filter(|s| !s.is_point()).collect();
    let place = ready.place(0, 0);
    let mut near: Option<Interval> = None;
    let mut missing = None;
    for &side in &sides {
        let ranges = along.over(&ready.roots, side);
        match ready.selected(&ranges) {
            Some(true) => {}
            // The limit is one through the times that count.
            Some(false) => continue,
            None => return Err(Enclosing::AssumedNear(t).into()),
        }
        match &ranges[place] {
            Ok(reach) => near = Some(near.map_or(reach.range(), |n| n.hull(reach.range()))),
            Err(reason) => missing = Some(*reason),
        }
    }
    if missing.is_none() && near.is_none() {
        return Ok(Shown::Void(Enclosing::NoTimeNear(t).into()));
    }
    let there = match (missing, near) {
        (None, Some(near)) if time.is_point() => {
            let there = along.over(&ready.roots, time);
            there[place].as_ref().map_or(near, Reach::range)
        }
        (None, Some(near)) => near,
        (missing, _) => {
            let replaced = removable(along, comparison, &exact, time, &sides);
            replaced.ok_or(Enclosing::NoLimit(t, missing.unwrap_or(NoValue::Indeterminate)))?
        }
    };
    if certain(comparison.kind, there) == Some(false) {
        let sides = ready.sides_at(along, t, place).map(|(l, r)| (l.mid(), r.mid()));
        // Where a side has no value at the time itself, what it tends to.
        let (left, right) = sides.unwrap_or((there.mid(), 0.0));
        let witness =
            Witness { t, formula: comparison.label.clone(), left, right, bound: there.width(), values: Vec::new() };
        return Ok(Shown::Fails(witness, Enclosing::AnotherLimit(t).into()));
    }
    if comparison.kind == RelationKind::Equal && there.magnitude() <= ready.precision * ready.scale {
        return Ok(Shown::at_one_place(Enclosing::LimitsAgree(t, there.magnitude())));
    }
    if comparison.kind != RelationKind::Equal && certain(comparison.kind, there) == Some(true) {
        return Ok(Shown::at_one_place(Enclosing::LimitCertain(t)));
    }
    Err(Enclosing::DifferBy(Instant::Time(t), Compared::Sides, there.lo(), there.hi()).into())
}

/// What the difference of the sides tends to, with quotients of the form 0/0 replaced by what they can be, and are in the limit.
fn removable(along: &mut Along, c: &Comparison, at: &Rational, time: Interval, sides: &[Interval]) -> Option<Interval> {
    let mut near = along.graph.sub(c.left, c.right);
    let mut there = near;
    let mut found = false;
    for _ in 0..MOST {
        // From the inside out.
        let quotients: Vec<(Expr, Expr, Expr)> = along
            .graph
            .reachable([near])
            .into_iter()
            .filter_map(|node| match *along.graph.node(node) {
                Node::Binary(Op::Div, a, b) => Some((node, a, b)),
                _ => None,
            })
            .collect();
        let next =
            quotients.into_iter().find(|&(_, a, b)| vanishes(along, a, at, time) && vanishes(along, b, at, time));
        let Some((node, a, b)) = next else { break };
        let (around, limit) = quotient(along, a, b, at, time, sides)?;
        // Nothing may be concluded from how the quotient is correlated with the rest: only its bounds are put in.
        let instead = [around, limit].map(|value| along.enclosure.between(&mut along.graph, value));
        near = replaced(&mut along.graph, near, node, instead[0])?;
        there = replaced(&mut along.graph, there, node, instead[1])?;
        found = true;
    }
    if !found {
        return None;
    }
    // Where it is continuous for all values that the quotients can have, its limit is its value.
    let all: Option<Vec<Interval>> = sides.iter().map(|&side| ranges(along, [near], side).map(|[r]| r)).collect();
    let hull = all?.into_iter().reduce(Interval::hull)?;
    if time.is_point() { ranges(along, [there], time).and_then(|[r]| r.intersection(hull)) } else { Some(hull) }
}

/// All values of a quotient 0/0 around a time, that time apart, and its limit.
fn quotient(
    along: &mut Along,
    a: Expr,
    b: Expr,
    at: &Rational,
    time: Interval,
    sides: &[Interval],
) -> Option<(Interval, Interval)> {
    let (mut a, mut b) = (a, b);
    for _ in 0..DEPTH {
        (a, b) = (rate(along, a)?, rate(along, b)?);
        let quotient = along.graph.div(a, b);
        let over = |along: &mut Along, side: Interval| {
            let [value, below] = ranges(along, [quotient, b], side)?;
            (!below.contains(0.0)).then_some(value)
        };
        let near: Option<Vec<Interval>> = sides.iter().map(|&side| over(along, side)).collect();
        if let Some(near) = near {
            let hull = near.into_iter().reduce(Interval::hull)?;
            let there = if time.is_point() { over(along, time)?.intersection(hull)? } else { hull };
            return Some((hull, there));
        }
        if !(vanishes(along, a, at, time) && vanishes(along, b, at, time)) {
            return None;
        }
    }
    None
}

/// The ranges of expressions over a stretch.
fn ranges<const N: usize>(along: &mut Along, exprs: [Expr; N], stretch: Interval) -> Option<[Interval; N]> {
    let compiled = along.enclosure.compile(&mut along.graph, &exprs).ok()?;
    let found = along.enclosure.over(&compiled, &along.enclosure.stretch(stretch));
    let found: Option<Vec<Interval>> = found.into_iter().map(|r| r.ok().map(|r| r.range())).collect();
    found?.try_into().ok()
}

/// The derivative along the motion, in the leaves of the derivation where that is possible.
fn rate(along: &mut Along, e: Expr) -> Option<Expr> {
    along.enclosure.rate(&mut along.graph, e).ok()
}

/// Whether an expression is 0 at a time: exactly.
fn vanishes(along: &mut Along, e: Expr, at: &Rational, time: Interval) -> bool {
    let now = along.enclosure.time();
    let instant = along.graph.constant(at.clone());
    // What moves has, at that time, the value that it has at that time.
    let there = along.graph.substitute(e, |graph, leaf| {
        if leaf == now {
            return Some(instant);
        }
        let fixed = leaf.instant.is_some() || leaf.rate > 0;
        (!fixed).then(|| graph.leaf(expr::Leaf { instant: Some(instant), ..leaf }))
    });
    if along.graph.is_zero(there) {
        return true;
    }
    let Ok(compiled) = along.enclosure.compile(&mut along.graph, &[e]) else { return false };
    matches!(along.enclosure.value(&compiled, time)[..], [Ok(value)] if value.lo() == 0.0 && value.hi() == 0.0)
}

/// An expression with a part of it replaced.
fn replaced(graph: &mut Graph, e: Expr, part: Expr, by: Expr) -> Option<Expr> {
    let mut image = std::collections::HashMap::new();
    for node in graph.reachable([e]) {
        let new = if node == part {
            by
        } else {
            match graph.node(node).clone() {
                Node::Pi | Node::Constant(_) | Node::Leaf(_) => node,
                Node::Unary(op, a) => {
                    let a = *image.get(&a)?;
                    graph.unary(op, a)
                }
                Node::Binary(op, a, b) => {
                    let (a, b) = (*image.get(&a)?, *image.get(&b)?);
                    graph.rebuilt(op, a, b)
                }
            }
        };
        image.insert(node, new);
    }
    image.get(&e).copied()
}

/// A limit as the time goes to +∞, or to −∞.
fn at_infinity(ready: &Ready, c: &Comparison, onwards: bool, along: &mut Along) -> Result<Shown, Reason> {
    // Also of what does not depend on the motion: a limit goes through the times that are known.
    if !along.enclosure.is_known_for_all_times() {
        return Err(Plain::IntegratedTail.into());
    }
    let tail = |along: &mut Along, e: Expr| {
        let resolved = along.enclosure.resolved(&mut along.graph, e).map_err(Reason::quoted)?;
        along.enclosure.tail(&mut along.graph, resolved, onwards).map_err(|reason| match reason {
            NoValue::Unsupported => Plain::IntegratedTail.into(),
            other => Reason::from(Enclosing::NoTail(other)),
        })
    };
    // The claim is about times at which its assumptions hold.
    let assumed = ready.assumed().ok_or(Plain::AssumptionsNotFollowed)?;
    for (place, kind) in assumed {
        let difference = along.difference_at(place);
        if !always(kind, &tail(along, difference)?) {
            return Err(Plain::AssumedLaterOpen.into());
        }
    }
    let difference = along.graph.sub(c.left, c.right);
    let [left, right, difference] = [tail(along, c.left)?, tail(along, c.right)?, tail(along, difference)?];
    let size = tail(along, c.magnitude).map_or(Limit::Unknown, |size| size.limit());
    let at = if onwards { Instant::Infinity } else { Instant::MinusInfinity };
    // A witness is a time of the span, with what both sides are then.
    let t = if onwards { along.span.1 } else { along.span.0 };
    let fails = |along: &Along, shown: (f64, f64), bound: f64, reason: Refutation| {
        let (left, right) = match shown {
            (l, r) if l.is_finite() && r.is_finite() => shown,
            _ => ready.sides_at(along, t, ready.place(0, 0)).map_or((0.0, 0.0), |(l, r)| (l.mid(), r.mid())),
        };
        let formula = format!("{}, in the limit", c.label);
        Shown::Fails(Witness { t, formula, left, right, bound, values: Vec::new() }, reason.into())
    };
    let middle = |limit: Limit| match limit {
        Limit::Finite(i) => i.mid(),
        _ => f64::INFINITY,
    };
    let sides = (middle(left.limit()), middle(right.limit()));
    match difference.limit() {
        Limit::Unknown => Err(Enclosing::LimitUnknown(at).into()),
        Limit::Finite(i) => {
            let room = match size {
                Limit::Finite(size) => ready.precision * size.lo().max(0.0),
                _ => 0.0,
            };
            let known = [left.limit(), right.limit()].map(|l| match l {
                Limit::Finite(i) => i.mignitude(),
                _ => 0.0,
            });
            let known = known[0].max(known[1]);
            let telling = if known > 0.0 { TELLING * known } else { f64::INFINITY };
            let exact = i.lo() == 0.0 && i.hi() == 0.0;
            match c.kind {
                _ if certain(c.kind, i) == Some(false) => {
                    Ok(fails(along, sides, i.width(), Refutation::LimitsDiffer(at, i.mid())))
                }
                RelationKind::Equal if exact || i.magnitude() <= room.min(telling) => {
                    Ok(Shown::at_one_place(Enclosing::LawsOfLimits(at, Some(i.magnitude()))))
                }
                kind if kind != RelationKind::Equal && certain(kind, i) == Some(true) => {
                    Ok(Shown::at_one_place(Enclosing::LawsOfLimits(at, None)))
                }
                _ => Err(Enclosing::DifferBy(at, Compared::Limits, i.lo(), i.hi()).into()),
            }
        }
        beyond => {
            // A relation between numbers: a limit is finite.
            let up = beyond == Limit::PlusInfinity;
            Ok(fails(along, (f64::INFINITY, 0.0), 0.0, Refutation::Unbounded { at, up }))
        }
    }
}

/// Whether a relation holds between the sides of a difference at all times of a tail.
fn always(kind: RelationKind, difference: &Tail) -> bool {
    let ((lo, hi), sign) = (difference.bounds(), difference.is_positive());
    match kind {
        RelationKind::Equal => lo == 0.0 && hi == 0.0,
        RelationKind::NotEqual => sign.is_some(),
        RelationKind::Less => sign == Some(false),
        RelationKind::LessEqual => hi <= 0.0,
        RelationKind::Greater => sign == Some(true),
        RelationKind::GreaterEqual => lo >= 0.0,
    }
}
