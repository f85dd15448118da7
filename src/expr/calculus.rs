//! Exact derivatives and substitution.
//!
//! Terms whose factor is the rate 0 of something that does not change are left out, so a derivative exists wherever the expression is differentiable.
//! Where a function leaps it has no derivative, though the formula of one may have a value there: atan2(y, x) does so where
//! y = 0 and x < 0, and its derivative is restricted to elsewhere. An angle that is continued beyond its cut does not leap;
//! who continues it says what its derivative is, see [`Graph::continued`].

use super::{FastMap, FastSet};

use super::{Expr, Graph, Leaf, Node, Op, Rational};

/// Why a derivative cannot be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoDerivative {
    /// The derivative of this operation is not an expression in the table's operations.
    Operation(Op),
    /// A field is derived more often than [`HIGHEST_ORDER`](super::HIGHEST_ORDER) times.
    Order,
}

impl std::fmt::Display for NoDerivative {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NoDerivative::Operation(op) => {
                write!(f, "`{}` has no derivative among the known operations", op.spelling())
            }
            NoDerivative::Order => write!(f, "a derivative of an order above {}", super::HIGHEST_ORDER),
        }
    }
}

impl std::error::Error for NoDerivative {}

impl Graph {
    /// The derivative of `e` along a direction in which each leaf moves at the speed that `tangent` gives (`None`: 0).
    ///
    /// With `tangent` = "1 for one leaf" this is a partial derivative; with the right sides of a system it is the Lie
    /// derivative; with rates it is the derivative by time.
    ///
    /// # Errors
    /// [`NoDerivative`] where the result cannot be written with the operations of the table.
    pub fn directional_derivative(
        &mut self,
        e: Expr,
        tangent: impl FnMut(&mut Graph, Leaf) -> Option<Expr>,
    ) -> Result<Expr, NoDerivative> {
        self.derivative_knowing(e, &[], tangent)
    }

    /// The same, where the derivatives of some nodes are known: pairs of a node and its derivative.
    ///
    /// # Errors
    /// See [`Graph::directional_derivative`].
    pub fn derivative_knowing(
        &mut self,
        e: Expr,
        known: &[(Expr, Expr)],
        mut tangent: impl FnMut(&mut Graph, Leaf) -> Option<Expr>,
    ) -> Result<Expr, NoDerivative> {
        if self.is_absent(e) {
            return Ok(e);
        }
        let zero = self.integer(0);
        let order = self.reachable([e]);
        let mut derivative: FastMap<Expr, Expr> = FastMap::with_capacity_and_hasher(order.len(), Default::default());
        for node in order {
            if let Some(&(_, d)) = known.iter().find(|(of, _)| *of == node) {
                derivative.insert(node, d);
                continue;
            }
            let d = match self.node(node).clone() {
                Node::Constant(_) | Node::Pi => zero,
                Node::Leaf(leaf) => tangent(self, leaf).unwrap_or(zero),
                Node::Unary(op, a) => {
                    let da = derivative[&a];
                    if self.is_zero(da) { zero } else { self.derivative(op, node, (a, da), (a, da))? }
                }
                Node::Binary(op, a, b) => self.derivative(op, node, (a, derivative[&a]), (b, derivative[&b]))?,
            };
            derivative.insert(node, d);
        }
        Ok(derivative[&e])
    }

    /// The derivative `d` of an angle, as that of the angle continued: also where atan2, alone or with a whole factor in a
    /// sum, would leap by whole turns.
    pub fn continued(&mut self, angle: Expr, d: Expr) -> Expr {
        let whole = |graph: &Graph, e: Expr| graph.as_constant(e).is_some_and(|r| r.denominator().is_one());
        let (mut open, mut off) = (vec![angle], Vec::new());
        while let Some(e) = open.pop() {
            match *self.node(e) {
                Node::Binary(Op::Arctan2, ..) => off.push(self.off_its_cut(e)),
                Node::Unary(Op::Neg, a) => open.push(a),
                Node::Binary(Op::Add | Op::Sub, a, b) => open.extend([a, b]),
                Node::Binary(Op::Mul, a, b) if whole(self, a) => open.push(b),
                Node::Binary(Op::Mul, a, b) if whole(self, b) => open.push(a),
                Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => {}
            }
        }
        self.lifted(d, |of| off.contains(&of))
    }

    /// What breaks a function: of c·|v| and c·atan2(v, u), and what is smooth beside them, |v| or atan2(v, u). Where v passes 0, at a speed
    /// that is not 0, it has a kink or leaps, and has no rate for certain. Of others nothing is said.
    pub fn broken_by(&self, function: Expr) -> Option<Expr> {
        let smooth = |e: Expr| self.reachable([e]).into_iter().all(|e| self.is_smooth(e));
        let mut at = function;
        loop {
            at = match *self.node(at) {
                Node::Unary(Op::Abs, v) => return smooth(v).then_some(at),
                Node::Binary(Op::Arctan2, v, u) => return (smooth(v) && smooth(u)).then_some(at),
                Node::Unary(Op::Neg, a) => a,
                Node::Binary(Op::Add | Op::Sub, a, b) if smooth(a) => b,
                Node::Binary(Op::Add | Op::Sub, a, b) if smooth(b) => a,
                Node::Binary(Op::Mul, a, b) if self.as_constant(a).is_some_and(|c| !c.is_zero()) => b,
                Node::Binary(Op::Mul | Op::Div, a, b) if self.as_constant(b).is_some_and(|c| !c.is_zero()) => a,
                Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => return None,
            }
        }
    }

    /// The rate of a function with the domain that a rate has, see [`Graph::rate_of`], where `speed` is that of the first argument of what breaks
    /// it: passed at a speed that is not 0, it leaves the function without a rate, just as the formula.
    pub fn rate_known(
        &mut self,
        function: Expr,
        formula: Expr,
        speed: Option<Expr>,
        partial: impl Fn(Leaf) -> bool,
    ) -> Expr {
        let breaks = speed.and_then(|s| self.as_constant(s)).is_some_and(|s| !s.is_zero());
        let of = if breaks { self.add(function, formula) } else { function };
        self.rate_of(of, formula, partial)
    }

    /// Half of the angle that is not π where an expression has a value, if it is one that is made for that.
    fn off_cut(&self, e: Expr) -> Option<(Expr, Expr)> {
        let Node::Unary(Op::Tan, half) = *self.node(e) else { return None };
        let angle = self.node(half).children().find(|&e| matches!(self.node(e), Node::Binary(Op::Arctan2, ..)));
        angle.map(|angle| (half, angle))
    }

    /// The halves of angles of which all that is named are rates of the angles themselves, with what is smooth beside them: where such a rate
    /// is, it is what the formula says, on the cut, too. (The angle is continuous there, so that it is one that goes on, and has the rate of
    /// that.) Of z·atan2(y, x) this is not so: along z = t, y = −t², x = −1 it has the rate −π at t = 0, and not π.
    pub fn angles_with_rates(&self, roots: impl IntoIterator<Item = Expr>) -> FastSet<Expr> {
        let (mut good, mut bad): (FastSet<Expr>, FastSet<Expr>) = Default::default();
        for node in self.reachable(roots) {
            let Node::Binary(Op::Restrict, formula, function) = *self.node(node) else { continue };
            if self.off_cut(function).is_some() {
                continue;
            }
            let own = self.broken_by(function);
            for (half, angle) in self.reachable([formula]).into_iter().filter_map(|e| self.off_cut(e)) {
                if Some(angle) == own { &mut good } else { &mut bad }.insert(half);
            }
        }
        good.retain(|half| !bad.contains(half));
        good
    }

    /// y and x of every atan2(y, x) below some expressions.
    pub fn arctan2s(&self, roots: impl IntoIterator<Item = Expr>) -> Vec<[Expr; 2]> {
        let of = |e: Expr| match *self.node(e) {
            Node::Binary(Op::Arctan2, y, x) => Some([y, x]),
            Node::Unary(..) | Node::Binary(..) | Node::Constant(_) | Node::Pi | Node::Leaf(_) => None,
        };
        self.reachable(roots).into_iter().filter_map(of).collect()
    }

    /// The rate of the angle of (x, y), (x·y′ − y·x′)/(x² + y²).
    fn turn(&mut self, [y, x]: [Expr; 2], [dy, dx]: [Expr; 2]) -> Expr {
        let left = self.mul_structural(x, dy);
        let right = self.mul_structural(y, dx);
        let top = self.sub(left, right);
        if self.is_zero(top) {
            return top;
        }
        let (yy, xx) = (self.powi(y, 2), self.powi(x, 2));
        let under = self.add(yy, xx);
        self.div(top, under)
    }

    /// Something that has a value where the angle `angle` = atan2(y, x) is not π: tan ½atan2(y, x).
    fn off_its_cut(&mut self, angle: Expr) -> Expr {
        let half = self.constant(Rational::ONE / Rational::from(2));
        let half = self.mul(half, angle);
        self.unary(Op::Tan, half)
    }

    /// ∂e/∂leaf, all leaves being independent of each other: also those of a field at a place, and what stands in the place.
    ///
    /// # Errors
    /// See [`Graph::directional_derivative`].
    pub fn slope(&mut self, e: Expr, leaf: Leaf) -> Result<Expr, NoDerivative> {
        self.directional_derivative(e, |graph, l| (l == leaf).then(|| graph.integer(1)))
    }

    /// `e` with every leaf replaced for which `with` yields an expression, and nothing in the places of fields. What is put into an
    /// exponent does not write it out: the power asks for what it asked for.
    pub fn replaced(&mut self, e: Expr, with: impl FnMut(&mut Graph, Leaf) -> Option<Expr>) -> Expr {
        self.replaced_by(e, Graph::power, with)
    }

    /// The same, with powers made by `power`.
    pub(super) fn replaced_by(
        &mut self,
        e: Expr,
        power: fn(&mut Graph, Expr, Expr) -> Expr,
        mut with: impl FnMut(&mut Graph, Leaf) -> Option<Expr>,
    ) -> Expr {
        let order = self.reachable([e]);
        let mut image: FastMap<Expr, Expr> = FastMap::with_capacity_and_hasher(order.len(), Default::default());
        for node in order {
            let new = match self.node(node).clone() {
                Node::Constant(_) | Node::Pi => node,
                Node::Leaf(leaf) => with(self, leaf).unwrap_or(node),
                Node::Unary(op, a) => self.unary(op, image[&a]),
                Node::Binary(Op::Pow, a, b) if image[&b] == b => self.power(image[&a], b),
                Node::Binary(Op::Pow, a, b) => power(self, image[&a], image[&b]),
                Node::Binary(op, a, b) => self.binary(op, image[&a], image[&b]),
            };
            image.insert(node, new);
        }
        image[&e]
    }

    /// Derivative of `node` = op(a, b), where a and b move at the speeds `da` and `db`. For an operation of one argument, b is
    /// a, and `da` is not 0.
    fn derivative(
        &mut self,
        op: Op,
        node: Expr,
        (a, da): (Expr, Expr),
        (b, db): (Expr, Expr),
    ) -> Result<Expr, NoDerivative> {
        let (one, two) = (self.integer(1), self.integer(2));
        Ok(match op {
            Op::Neg => self.neg(da),
            Op::Sqrt => {
                let twice = self.mul(two, node);
                self.div(da, twice)
            }
            Op::Exp => self.mul(node, da),
            Op::Ln => self.div(da, a),
            Op::Sin => {
                let c = self.unary(Op::Cos, a);
                self.mul(c, da)
            }
            Op::Cos => {
                let s = self.unary(Op::Sin, a);
                let p = self.mul(s, da);
                self.neg(p)
            }
            Op::Tan => {
                let square = self.powi(node, 2);
                let factor = self.add(one, square);
                self.mul(factor, da)
            }
            Op::Arcsin | Op::Arccos => {
                let square = self.powi(a, 2);
                let under = self.sub(one, square);
                let root = self.unary(Op::Sqrt, under);
                let quotient = self.div(da, root);
                if op == Op::Arcsin { quotient } else { self.neg(quotient) }
            }
            Op::Arctan => {
                let square = self.powi(a, 2);
                let under = self.add(one, square);
                self.div(da, under)
            }
            Op::Sinh => {
                let c = self.unary(Op::Cosh, a);
                self.mul(c, da)
            }
            Op::Cosh => {
                let s = self.unary(Op::Sinh, a);
                self.mul(s, da)
            }
            Op::Tanh => {
                let square = self.powi(node, 2);
                let factor = self.sub(one, square);
                self.mul(factor, da)
            }
            Op::Abs => {
                // |a|′ = a/|a| · a′, without a value at a = 0.
                let sign = self.div(a, node);
                self.mul(sign, da)
            }
            Op::Restrict => da,
            Op::Powi(0) => self.integer(0),
            Op::Powi(n) => {
                let factor = self.integer(i64::from(n));
                let power = self.powi(a, n - 1);
                let outer = self.mul(factor, power);
                self.mul(outer, da)
            }
            Op::Add => self.add(da, db),
            Op::Sub => self.sub(da, db),
            Op::Mul => {
                let left = self.mul_structural(da, b);
                let right = self.mul_structural(a, db);
                self.add(left, right)
            }
            Op::Div => {
                // (a/b)′ = (a′ − (a/b)·b′)/b
                let moved = self.mul_structural(node, db);
                let top = self.sub(da, moved);
                if self.is_zero(top) { top } else { self.div(top, b) }
            }
            Op::Pow => {
                // (a^b)′ = a^b·ln a·b′ + b·a^(b−1)·a′
                let mut sum = self.integer(0);
                if !self.is_zero(da) {
                    let less = self.sub(b, one);
                    let power = self.binary(Op::Pow, a, less);
                    let factor = self.mul(b, power);
                    sum = self.mul(factor, da);
                }
                if !self.is_zero(db) {
                    let log = self.unary(Op::Ln, a);
                    let factor = self.mul(node, log);
                    let term = self.mul(factor, db);
                    sum = self.add(sum, term);
                }
                sum
            }
            Op::Arctan2 => {
                let slope = self.turn([a, b], [da, db]);
                if self.is_zero(slope) {
                    return Ok(slope);
                }
                let off = self.off_its_cut(node);
                self.binary(Op::Restrict, slope, off)
            }
            Op::DirectionCosine => {
                // (a/r)′ = (b/r)·(b·a′ − a·b′)/r²
                let turned = self.turn([a, b], [da, db]);
                if self.is_zero(turned) {
                    return Ok(turned);
                }
                let sine = self.binary(Op::DirectionCosine, b, a);
                self.mul(sine, turned)
            }
            // The derivative of the mean needs the elliptic integral of the second kind.
            Op::Agm if self.is_zero(da) && self.is_zero(db) => da,
            Op::Agm => return Err(NoDerivative::Operation(op)),
        })
    }
}
