//! Complex numbers as pairs of real expressions, and their functions by principal values.
//!
//! **In:** pairs. **Out:** pairs. **Guaranteed:** both parts together have a value only where the function has one; where a
//! part alone would have a value elsewhere, [`Pair::joined`] takes it away before anybody sees it alone.
//!
//! **Cuts.** With r = |z| = √(x² + y²) the argument is arg z = 2·arctan(y/(r + x)), in (−π, π), and √z = p + iy/(2p) with
//! p = √((r + x)/2). Both divide by 0 exactly where x ≤ 0 and y = 0: on the cut there is *no value*, and everywhere else they
//! are analytic, since r + x is. All other functions are made of these two, of exp, sin, cos and of rational operations, in
//! the forms of DLMF §§ 4.2, 4.23, 4.37 and of W. Kahan, *Branch cuts for complex elementary functions*, 1987. So the table of
//! domains knows of every cut by the division, and nothing that crosses one is taken for continuous.

use expr::{Expr, Graph, Leaf, Op, Part, Rational, Shape, Tensor};

/// x + iy. The imaginary part of something real is not there: a structural zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pair {
    pub re: Expr,
    pub im: Expr,
}

/// Highest power that is multiplied out.
pub(super) const HIGHEST_POWER: u32 = 1024;

impl Pair {
    /// A real number.
    pub fn real(graph: &mut Graph, re: Expr) -> Pair {
        Pair { re, im: graph.absent() }
    }

    /// i.
    pub fn unit(graph: &mut Graph) -> Pair {
        Pair { re: graph.absent(), im: graph.integer(1) }
    }

    /// A whole number.
    pub fn whole(graph: &mut Graph, n: i64) -> Pair {
        let re = graph.integer(n);
        Pair::real(graph, re)
    }

    /// The number as it stands in a tensor: a real or a complex scalar.
    pub fn of(graph: &mut Graph, tensor: &Tensor) -> Option<Pair> {
        match (tensor.as_scalar(), tensor.shape.real_extents(), tensor.components.as_slice()) {
            (Some(e), ..) => Some(Pair::real(graph, e)),
            (None, [], &[re, im]) => Some(Pair { re, im }),
            _ => None,
        }
    }

    /// As a complex scalar.
    pub fn scalar(self) -> Tensor {
        Tensor { shape: Shape::scalar().complexified(), components: vec![self.re, self.im] }
    }

    /// Both parts, each with a value only where both have one. `partial` says of a leaf whether it may lack a value.
    pub fn joined(self, graph: &mut Graph, partial: impl Fn(Leaf) -> bool) -> Pair {
        let both = graph.add(self.re, self.im);
        Pair { re: graph.rate_of(both, self.re, &partial), im: graph.rate_of(both, self.im, &partial) }
    }

    /// One of the parts.
    pub fn part(self, part: Part) -> Expr {
        match part {
            Part::Real => self.re,
            Part::Imaginary => self.im,
        }
    }

    /// x − iy.
    pub fn conjugate(self, graph: &mut Graph) -> Pair {
        Pair { re: self.re, im: graph.neg(self.im) }
    }

    pub fn plus(self, graph: &mut Graph, other: Pair) -> Pair {
        Pair { re: graph.add(self.re, other.re), im: graph.add(self.im, other.im) }
    }

    pub fn minus(self, graph: &mut Graph, other: Pair) -> Pair {
        Pair { re: graph.sub(self.re, other.re), im: graph.sub(self.im, other.im) }
    }

    pub fn negated(self, graph: &mut Graph) -> Pair {
        Pair { re: graph.neg(self.re), im: graph.neg(self.im) }
    }

    /// The product, of real products that `times` makes.
    pub fn times_by(self, graph: &mut Graph, other: Pair, times: fn(&mut Graph, Expr, Expr) -> Expr) -> Pair {
        let (xx, yy) = (times(graph, self.re, other.re), times(graph, self.im, other.im));
        let (xy, yx) = (times(graph, self.re, other.im), times(graph, self.im, other.re));
        Pair { re: graph.sub(xx, yy), im: graph.add(xy, yx) }
    }

    pub fn times(self, graph: &mut Graph, other: Pair) -> Pair {
        self.times_by(graph, other, Graph::term)
    }

    /// x² + y².
    fn square_of_size(self, graph: &mut Graph) -> Expr {
        let squares = [self.re, self.im].map(|e| if graph.is_zero(e) { e } else { graph.powi(e, 2) });
        graph.add(squares[0], squares[1])
    }

    /// |z|.
    pub fn size(self, graph: &mut Graph) -> Expr {
        if graph.is_zero(self.im) {
            return graph.unary(Op::Abs, self.re);
        }
        let square = self.square_of_size(graph);
        graph.unary(Op::Sqrt, square)
    }

    /// Whether nothing imaginary is there.
    fn is_real(self, graph: &Graph) -> bool {
        graph.is_zero(self.im)
    }

    pub fn over(self, graph: &mut Graph, below: Pair) -> Pair {
        if below.is_real(graph) {
            let re = graph.div(self.re, below.re);
            let im = if self.is_real(graph) { self.im } else { graph.div(self.im, below.re) };
            return Pair { re, im };
        }
        let turned = below.conjugate(graph);
        let above = self.times(graph, turned);
        let square = below.square_of_size(graph);
        Pair { re: graph.div(above.re, square), im: graph.div(above.im, square) }
    }

    /// zⁿ; `None` where that is too long to be written out.
    pub fn powi(self, graph: &mut Graph, n: i32) -> Option<Pair> {
        if self.is_real(graph) {
            let re = graph.powi(self.re, n);
            return Some(Pair { re, im: self.im });
        }
        let size = n.unsigned_abs();
        if size > HIGHEST_POWER {
            return None;
        }
        if size == 0 {
            // 1, where z has a value.
            let (x, y) = (graph.powi(self.re, 0), graph.powi(self.im, 0));
            let re = graph.mul(x, y);
            return Some(Pair::real(graph, re));
        }
        let mut power: Option<Pair> = None;
        let (mut base, mut rest) = (self, size);
        loop {
            if rest & 1 == 1 {
                power = Some(match power {
                    Some(p) => p.times(graph, base),
                    None => base,
                });
            }
            rest >>= 1;
            if rest == 0 {
                break;
            }
            base = base.times(graph, base);
        }
        let power = power?;
        let one = Pair::whole(graph, 1);
        Some(if n < 0 { one.over(graph, power) } else { power })
    }

    pub fn exp(self, graph: &mut Graph) -> Pair {
        let size = graph.unary(Op::Exp, self.re);
        let (c, s) = (graph.unary(Op::Cos, self.im), graph.unary(Op::Sin, self.im));
        Pair { re: graph.term(size, c), im: graph.term(size, s) }
    }

    /// r + x, which vanishes on the cut and nowhere else.
    fn off_the_cut(self, graph: &mut Graph) -> Expr {
        let size = self.size(graph);
        graph.add(size, self.re)
    }

    /// arg z in (−π, π); no value where x ≤ 0 and y = 0.
    pub fn argument(self, graph: &mut Graph) -> Expr {
        if self.is_real(graph) {
            // 0, where x > 0.
            let (ln, im) = (graph.unary(Op::Ln, self.re), graph.settled(self.im));
            return graph.mul(im, ln);
        }
        if graph.is_zero(self.re) {
            // ±π/2, where y is not 0.
            let (size, pi, two) = (graph.unary(Op::Abs, self.im), graph.pi(), graph.integer(2));
            let (sign, quarter) = (graph.div(self.im, size), graph.div(pi, two));
            return graph.mul(sign, quarter);
        }
        let below = self.off_the_cut(graph);
        let ratio = graph.div(self.im, below);
        let half = graph.unary(Op::Arctan, ratio);
        let two = graph.integer(2);
        graph.mul(two, half)
    }

    /// ln|z| + i arg z.
    pub fn ln(self, graph: &mut Graph) -> Pair {
        let size = self.size(graph);
        let re = if graph.is_one(size) { graph.integer(0) } else { graph.unary(Op::Ln, size) };
        Pair { re, im: self.argument(graph) }
    }

    /// √z, with a positive real part.
    pub fn sqrt(self, graph: &mut Graph) -> Pair {
        let (sum, two) = (self.off_the_cut(graph), graph.integer(2));
        let half = graph.div(sum, two);
        let re = graph.unary(Op::Sqrt, half);
        let twice = graph.mul(two, re);
        Pair { re, im: graph.div(self.im, twice) }
    }

    /// e^{w ln z}.
    pub fn power(self, graph: &mut Graph, exponent: Pair) -> Pair {
        let ln = self.ln(graph);
        let product = exponent.times(graph, ln);
        product.exp(graph)
    }

    /// z to a rational power that is written out: whole powers by products, halves by the root.
    pub fn rational_power(self, graph: &mut Graph, exponent: &Rational) -> Option<Pair> {
        let whole = |q: Rational| i32::try_from(q).ok();
        match (whole(exponent.clone()), whole(exponent.clone() * Rational::from(2))) {
            (Some(n), _) => self.powi(graph, n),
            (None, Some(n)) => self.sqrt(graph).powi(graph, n),
            (None, None) => {
                let q = graph.constant(exponent.clone());
                let q = Pair::real(graph, q);
                Some(self.power(graph, q))
            }
        }
    }

    pub fn sin(self, graph: &mut Graph) -> Pair {
        let (s, c) = (graph.unary(Op::Sin, self.re), graph.unary(Op::Cos, self.re));
        let (sh, ch) = (graph.unary(Op::Sinh, self.im), graph.unary(Op::Cosh, self.im));
        Pair { re: graph.term(s, ch), im: graph.term(c, sh) }
    }

    pub fn cos(self, graph: &mut Graph) -> Pair {
        let (s, c) = (graph.unary(Op::Sin, self.re), graph.unary(Op::Cos, self.re));
        let (sh, ch) = (graph.unary(Op::Sinh, self.im), graph.unary(Op::Cosh, self.im));
        let im = graph.term(s, sh);
        Pair { re: graph.term(c, ch), im: graph.neg(im) }
    }

    pub fn sinh(self, graph: &mut Graph) -> Pair {
        let (s, c) = (graph.unary(Op::Sin, self.im), graph.unary(Op::Cos, self.im));
        let (sh, ch) = (graph.unary(Op::Sinh, self.re), graph.unary(Op::Cosh, self.re));
        Pair { re: graph.term(sh, c), im: graph.term(ch, s) }
    }

    pub fn cosh(self, graph: &mut Graph) -> Pair {
        let (s, c) = (graph.unary(Op::Sin, self.im), graph.unary(Op::Cos, self.im));
        let (sh, ch) = (graph.unary(Op::Sinh, self.re), graph.unary(Op::Cosh, self.re));
        Pair { re: graph.term(ch, c), im: graph.term(sh, s) }
    }

    fn times_i(self, graph: &mut Graph) -> Pair {
        Pair { re: graph.neg(self.im), im: self.re }
    }

    fn over_i(self, graph: &mut Graph) -> Pair {
        Pair { re: self.im, im: graph.neg(self.re) }
    }

    fn half(self, graph: &mut Graph) -> Pair {
        let two = Pair::whole(graph, 2);
        self.over(graph, two)
    }

    /// ln(z + √(z² + 1)).
    fn asinh(self, graph: &mut Graph) -> Pair {
        let (square, one) = (self.times(graph, self), Pair::whole(graph, 1));
        let root = square.plus(graph, one).sqrt(graph);
        self.plus(graph, root).ln(graph)
    }

    /// ln(z + √(z + 1)√(z − 1)).
    fn acosh(self, graph: &mut Graph) -> Pair {
        let one = Pair::whole(graph, 1);
        let (above, below) = (self.plus(graph, one).sqrt(graph), self.minus(graph, one).sqrt(graph));
        let roots = above.times(graph, below);
        self.plus(graph, roots).ln(graph)
    }

    /// (ln(1 + z) − ln(1 − z))/2.
    fn atanh(self, graph: &mut Graph) -> Pair {
        let one = Pair::whole(graph, 1);
        let (above, below) = (one.plus(graph, self).ln(graph), one.minus(graph, self).ln(graph));
        above.minus(graph, below).half(graph)
    }

    /// −i asinh(iz).
    fn arcsin(self, graph: &mut Graph) -> Pair {
        let turned = self.times_i(graph).asinh(graph);
        turned.over_i(graph)
    }

    /// A function of one argument, by its name; `None` where it has no complex arguments here.
    pub fn function(self, graph: &mut Graph, name: &str) -> Option<Pair> {
        let one = Pair::whole(graph, 1);
        Some(match name {
            "exp" => self.exp(graph),
            "ln" => self.ln(graph),
            "sin" => self.sin(graph),
            "cos" => self.cos(graph),
            "sinh" => self.sinh(graph),
            "cosh" => self.cosh(graph),
            "tan" => {
                let below = self.cos(graph);
                self.sin(graph).over(graph, below)
            }
            "cot" => {
                let below = self.sin(graph);
                self.cos(graph).over(graph, below)
            }
            "tanh" => {
                let below = self.cosh(graph);
                self.sinh(graph).over(graph, below)
            }
            "coth" => {
                let below = self.sinh(graph);
                self.cosh(graph).over(graph, below)
            }
            "sec" => {
                let below = self.cos(graph);
                one.over(graph, below)
            }
            "csc" => {
                let below = self.sin(graph);
                one.over(graph, below)
            }
            "sech" => {
                let below = self.cosh(graph);
                one.over(graph, below)
            }
            "csch" => {
                let below = self.sinh(graph);
                one.over(graph, below)
            }
            "asinh" => self.asinh(graph),
            "acosh" => self.acosh(graph),
            "atanh" => self.atanh(graph),
            "arcsin" => self.arcsin(graph),
            "arccos" => {
                let (pi, two) = (graph.pi(), graph.integer(2));
                let quarter = graph.div(pi, two);
                let quarter = Pair::real(graph, quarter);
                let arcsin = self.arcsin(graph);
                quarter.minus(graph, arcsin)
            }
            "arctan" => {
                let turned = self.times_i(graph).atanh(graph);
                turned.over_i(graph)
            }
            _ => return None,
        })
    }
}
