//! Motions given by formulas, for all times after their span, and in the limit.
//!
//! A formula is one for all times. An angle that is followed keeps, after the end of the span, the representation that it has
//! there, as long as that stays continuous: then it is the followed angle, by continuity.
//!
//! **Quotients.** Where both sides of a quotient tend to 0, or its lower side to ±∞, the quotient tends to what that of the
//! derivatives tends to, if this exists ([Rudin 1976, theorem 5.13], l'Hospital's rule): the lower derivative must be
//! different from 0 at all later times, as it is when the quotient of the derivatives has a [`Tail`].
//!
//! [Rudin 1976, theorem 5.13]: https://archive.org/details/principlesofmath00rudi

use super::Enclosure;
use crate::definitions::Definitions;
use expr::{Expr, Graph, Leaf, Node, Op};
use number::{Interval, Limit, NoValue, Number, Tail};
use std::collections::HashMap;

/// How often a quotient of derivatives is looked at instead of a quotient.
const DEPTH: usize = 3;
/// Later times are tried up to this multiple of the end of the span.
const LATEST: f64 = 1e6;

impl Enclosure {
    /// What is known of an expression, resolved, at all times after the span (or before it), and of its limit there.
    ///
    /// # Errors
    /// Why nothing is: the motion is integrated, or the expression may have no value, or jump, at some later time.
    pub fn tail(&self, graph: &mut Graph, resolved: Expr, onwards: bool) -> Result<Tail, NoValue> {
        let end = if onwards { self.span.1 } else { self.span.0 };
        let leaves = graph.leaves([resolved]);
        // What an angle is after a gap is not known.
        let follows = leaves.iter().any(|l| self.angles.iter().any(|a| a.turns == *l || a.side == *l));
        let mut from = end;
        let mut found = self.from(graph, resolved, from, onwards, DEPTH);
        let settled = |found: &Result<Tail, NoValue>| found.is_ok_and(|t| t.limit() != Limit::Unknown);
        while !settled(&found) && !follows && from.abs() < LATEST * end.abs().max(1.0) {
            from = if onwards { (2.0 * from).max(from + 1.0).max(1.0) } else { (2.0 * from).min(from - 1.0).min(-1.0) };
            let later = self.from(graph, resolved, from, onwards, DEPTH);
            if settled(&later) || found.is_err() {
                found = later;
            }
        }
        found
    }

    /// Whether the motion is given by formulas: then it is known for all times at which they have values.
    pub fn is_known_for_all_times(&self) -> bool {
        self.tube.is_none()
    }

    fn leaf_tail(&self, leaf: Leaf, from: f64, onwards: bool) -> Result<Tail, NoValue> {
        if leaf == self.time {
            return Ok(Tail::time(from, onwards));
        }
        if let Some((_, value)) = self.constants.iter().find(|c| c.0 == leaf) {
            return Tail::constant((*value)?);
        }
        for angle in &self.angles {
            if angle.turns == leaf {
                return Tail::constant(angle.turns(Interval::point(from))?.0);
            }
            if angle.side == leaf {
                return Tail::constant(angle.turns(Interval::point(from))?.1);
            }
        }
        Err(NoValue::Unsupported)
    }

    fn from(&self, graph: &mut Graph, e: Expr, from: f64, onwards: bool, depth: usize) -> Result<Tail, NoValue> {
        let mut known: HashMap<Expr, Result<Tail, NoValue>> = HashMap::new();
        let blank = Tail::blank(&());
        for node in graph.reachable([e]) {
            let mut out = blank;
            let found = match graph.node(node).clone() {
                Node::Pi => out.pi(&()),
                Node::Constant(_) => match graph.as_constant(node) {
                    Some(r) => out.rational(&(), r),
                    None => Err(NoValue::Unsupported),
                },
                Node::Leaf(leaf) => self.leaf_tail(leaf, from, onwards).map(|tail| out = tail),
                Node::Unary(op, a) => known[&a].and_then(|a| op.apply(&(), &mut out, &a, &blank)),
                Node::Binary(op, a, b) => {
                    let both = known[&a].and_then(|x| Ok((x, known[&b]?)));
                    let plain = both.and_then(|(x, y)| op.apply(&(), &mut out, &x, &y));
                    if let (Op::Div, Ok(()), Ok((x, y)), Limit::Unknown, true) =
                        (op, plain, both, out.limit(), depth > 0)
                    {
                        let limit = self.quotient(graph, (a, b), (x, y), from, onwards, depth - 1);
                        limit.map_or(Ok(()), |limit| out.with_limit(limit).map(|tail| out = tail))
                    } else {
                        plain
                    }
                }
            };
            known.insert(node, found.map(|()| out));
        }
        known[&e]
    }

    /// The limit of a quotient of the form 0/0 or ∞/∞, by that of the derivatives.
    fn quotient(
        &self,
        graph: &mut Graph,
        (a, b): (Expr, Expr),
        (x, y): (Tail, Tail),
        from: f64,
        onwards: bool,
        depth: usize,
    ) -> Option<Limit> {
        let zero = |t: Tail| matches!(t.limit(), Limit::Finite(i) if i.lo() == 0.0 && i.hi() == 0.0);
        let beyond = matches!(y.limit(), Limit::PlusInfinity | Limit::MinusInfinity);
        if !(beyond || (zero(x) && zero(y))) {
            return None;
        }
        let (above, below) = (self.derivative(graph, a).ok()?, self.derivative(graph, b).ok()?);
        let quotient = graph.div(above, below);
        let limit = self.from(graph, quotient, from, onwards, depth).ok()?.limit();
        // The lower derivative has a sign of its own also where the quotient was simplified.
        let sign = self.from(graph, below, from, onwards, 0).ok()?.is_positive();
        sign.and(Some(limit)).filter(|limit| *limit != Limit::Unknown)
    }
}
