//! Sine, cosine and tangent of angles, without the angles.
//!
//! **In:** expressions, and which nodes are angles that have gone round. **Out:** expressions of the same values, in which nobody
//! takes the sine of atan2(y, x): it is y/√(x² + y²), [`Op::DirectionCosine`]. **Guaranteed:** a value exactly where there was one,
//! but for angles with turns, which are not always known, and whose sine is.
//!
//! **Why:** atan2 has a cut where sine and cosine of it are smooth. A right side with them has no jump, and its slopes have no hole;
//! a claim needs no turns; and two elementary functions are a root and two quotients. **Why not in every graph:** formulas are
//! printed, and proofs know what a sine is.

use super::{Expr, FastMap, Graph, Node, Op};

/// How many sums and multiples may stand between a sine and its angle: what is shared below is taken apart again for each.
const DEEPEST: usize = 8;
/// The largest multiple of an angle that is taken apart.
const LARGEST: u8 = 6;

/// Sine and cosine.
type Wave = [Expr; 2];

/// What is being rewritten.
struct Directions<'g> {
    graph: &'g mut Graph,
    /// Angles that have gone round: the whole, and what it is without its turns.
    turned: &'g [(Expr, Expr)],
    image: FastMap<Expr, Expr>,
}

impl Graph {
    /// Expressions of the same values, without angles of which a sine, cosine or tangent is taken. `turned` has nodes that are an
    /// angle and some whole turns, each with the angle.
    pub fn without_angles(&mut self, roots: &[Expr], turned: &[(Expr, Expr)]) -> Vec<Expr> {
        let order = self.reachable(roots.iter().copied());
        let is_wave = |e: &Expr| matches!(self.node(*e), Node::Unary(Op::Sin | Op::Cos | Op::Tan, _));
        let is_angle = |e: &Expr| {
            matches!(self.node(*e), Node::Binary(Op::Arctan2, ..) | Node::Unary(Op::Arctan, _))
                || turned.iter().any(|(angle, _)| angle == e)
        };
        if !(order.iter().any(is_wave) && order.iter().any(is_angle)) {
            return roots.to_vec();
        }
        let order = self.reachable(roots.iter().copied().chain(turned.iter().map(|(_, angle)| *angle)));
        let mut all = Directions { graph: self, turned, image: FastMap::default() };
        for node in order {
            let new = match *all.graph.node(node) {
                Node::Unary(op @ (Op::Sin | Op::Cos | Op::Tan), a) => match all.wave_below(a, DEEPEST) {
                    Some([sine, _]) if op == Op::Sin => sine,
                    Some([_, cosine]) if op == Op::Cos => cosine,
                    _ if op == Op::Tan => all.tangent(a),
                    _ => all.graph.unary(op, all.image[&a]),
                },
                Node::Unary(op, a) => all.graph.unary(op, all.image[&a]),
                Node::Binary(op, a, b) => all.graph.rebuilt(op, all.image[&a], all.image[&b]),
                Node::Constant(_) | Node::Pi | Node::Leaf(_) => node,
            };
            all.image.insert(node, new);
        }
        roots.iter().map(|root| all.image[root]).collect()
    }
}

impl Directions<'_> {
    /// Sine and cosine of what is an angle or has one among its terms.
    fn wave_below(&mut self, e: Expr, depth: usize) -> Option<Wave> {
        if let Some(&(_, angle)) = self.turned.iter().find(|(turned, _)| *turned == e) {
            return Some(self.wave(angle, depth));
        }
        match *self.graph.node(e) {
            Node::Binary(Op::Arctan2, y, x) => Some(self.direction(self.image[&y], self.image[&x])),
            // It has no cut, and is worth it only where nothing else moves.
            Node::Unary(Op::Arctan, a) if depth == DEEPEST => {
                let one = self.graph.integer(1);
                Some(self.direction(self.image[&a], one))
            }
            _ if depth == 0 => None,
            Node::Unary(Op::Neg, a) => {
                let [sine, cosine] = self.wave_below(a, depth - 1)?;
                Some([self.graph.neg(sine), cosine])
            }
            Node::Binary(op @ (Op::Add | Op::Sub), a, b) => {
                let (p, q) = (self.wave_below(a, depth - 1), self.wave_below(b, depth - 1));
                if p.is_none() && q.is_none() {
                    return None;
                }
                let p = p.unwrap_or_else(|| self.plain(a));
                let [sine, cosine] = q.unwrap_or_else(|| self.plain(b));
                let q = if op == Op::Sub { [self.graph.neg(sine), cosine] } else { [sine, cosine] };
                Some(self.sum(p, q))
            }
            Node::Binary(Op::Mul, a, b) => {
                let (n, angle) = match (self.whole(a), self.whole(b)) {
                    (Some(n), _) => (n, b),
                    (None, Some(n)) => (n, a),
                    (None, None) => return None,
                };
                let one = self.wave_below(angle, depth - 1)?;
                let [sine, cosine] = (1..n.unsigned_abs()).fold(one, |all, _| self.sum(all, one));
                Some([if n < 0 { self.graph.neg(sine) } else { sine }, cosine])
            }
            Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => None,
        }
    }

    /// Sine and cosine of anything.
    fn wave(&mut self, e: Expr, depth: usize) -> Wave {
        let below = if depth == 0 { None } else { self.wave_below(e, depth - 1) };
        below.unwrap_or_else(|| self.plain(e))
    }

    /// Sine and cosine as such.
    fn plain(&mut self, e: Expr) -> Wave {
        let image = self.image[&e];
        [Op::Sin, Op::Cos].map(|op| self.graph.unary(op, image))
    }

    /// Sine and cosine of the angle of (x, y).
    fn direction(&mut self, y: Expr, x: Expr) -> Wave {
        [(y, x), (x, y)].map(|(a, b)| self.graph.binary(Op::DirectionCosine, a, b))
    }

    /// Those of the sum of two angles.
    fn sum(&mut self, [s, c]: Wave, [t, d]: Wave) -> Wave {
        let graph = &mut *self.graph;
        let [sd, ct, cd, st] = [(s, d), (c, t), (c, d), (s, t)].map(|(a, b)| graph.mul(a, b));
        [graph.add(sd, ct), graph.sub(cd, st)]
    }

    /// The tangent of an angle: of atan2(y, x) it is y/x, which has a value where x ≠ 0.
    fn tangent(&mut self, e: Expr) -> Expr {
        match *self.graph.node(e) {
            Node::Binary(Op::Arctan2, y, x) => self.graph.div(self.image[&y], self.image[&x]),
            Node::Unary(Op::Arctan, a) => self.image[&a],
            Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => {
                match self.wave_below(e, DEEPEST) {
                    Some([sine, cosine]) => self.graph.div(sine, cosine),
                    None => self.graph.unary(Op::Tan, self.image[&e]),
                }
            }
        }
    }

    /// A whole number other than 0 that is small enough.
    fn whole(&self, e: Expr) -> Option<i8> {
        let n = i8::try_from(self.graph.as_constant(e)?.clone()).ok()?;
        (n != 0 && n.unsigned_abs() <= LARGEST).then_some(n)
    }
}
