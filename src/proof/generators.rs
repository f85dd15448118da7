//! Transcendental functions as rational functions of generators.
//!
//! **In:** expressions. **Out:** the same expressions with +, −, ×, ÷, integer powers, √ and |·| only, over leaves and
//! *generators*.
//!
//! The argument of every sin, cos, tan is written as Σ qᵢ·mᵢ ([`linear`](super::linear)). For each monomial m, with N the
//! common denominator of its coefficients in the whole problem, two generators c, s stand for cos(m/N), sin(m/N), bound by
//! c² + s² = 1; cosines and sines of sums and multiples follow by the addition theorem. In the same way one generator
//! stands for e^{m/N}. Functions of a variable and of its cosine, sine and exponential satisfy no other algebraic relation
//! (Ax 1971), but nothing rests on that: a relation that is missed can only leave an identity undecided.
//!
//! Multiples of π/60, and halves and quarters of them, have exact values in √2, √3, √5 and roots of sums of these. cos, sin of arccos, arcsin, arctan, atan2 (once, twice … and halved)
//! are algebraic, with the roots of the principal values: sin arccos x = √(1 − x²) ≥ 0, cos atan2(y, x) = x/√(x² + y²).
//! exp(q·ln u) = u^q for integer and half-integer q, and by roots of roots for quarters and eighths. Every other occurrence of arccos, ln, agm … is a generator of its own,
//! the same for the same argument.

use super::fractions::{Relations, related, relations};
use super::linear::{Combination, Combinations, Monomial, expression};
use super::sign::Facts;
use expr::{Expr, FastMap, FastSet, Graph, Leaf, Node, Op, Rational, Shape, Symbol};

/// What a generator stands for.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Generator {
    /// The cosine of the argument; the next generator is the sine of the same.
    Cosine(Expr),
    /// The sine of the argument; the generator before is its cosine.
    Sine(Expr),
    /// The exponential of the argument: positive.
    Exponential(Expr),
    /// The value of a node that has no algebraic meaning.
    Opaque(Expr),
    /// A sign ±1: the sign of an expression, or of a root.
    Sign,
    /// A free number: t in c = (1 − t²)/(1 + t²), s = 2t/(1 + t²).
    Half,
    /// A free number: parameter of an orthogonal matrix.
    Free,
}

impl Generator {
    /// What it is a function of.
    pub(super) fn argument(&self) -> Option<Expr> {
        match *self {
            Generator::Cosine(e) | Generator::Sine(e) | Generator::Exponential(e) | Generator::Opaque(e) => Some(e),
            Generator::Sign | Generator::Half | Generator::Free => None,
        }
    }
}

/// Roots of this order at most are related to what they are of.
const HIGHEST_ROOT: i32 = 12;

/// The name of the one hidden symbol whose components are the generators.
const HIDDEN: &str = "\u{2063}generator";

/// Generators of one problem.
pub(super) struct Generators {
    symbol: Symbol,
    pub(super) list: Vec<Generator>,
    /// Roots of order above 2 among the exponentials.
    pub(super) radicals: Vec<Radical>,
}

/// An exponential that is a root: u^{1/n} = e^{(ln u)/n}.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Radical {
    /// Its number.
    pub(super) generator: usize,
    of: Expr,
    order: i32,
}

impl Generators {
    /// None yet. The hidden symbol is shared by all problems of a graph, so that they share nodes.
    pub(super) fn new(graph: &mut Graph) -> Generators {
        let symbol = match graph.find_symbol(HIDDEN) {
            Some(symbol) => symbol,
            None => graph.declare(HIDDEN, Shape::vector(u16::MAX), false),
        };
        Generators { symbol, list: Vec::new(), radicals: Vec::new() }
    }

    /// A new generator; `None` when there are too many.
    pub(super) fn add(&mut self, generator: Generator) -> Option<Leaf> {
        let component = u16::try_from(self.list.len()).ok()?;
        self.list.push(generator);
        Some(Leaf::now(self.symbol, component))
    }

    /// The leaf of a generator, by its number.
    pub(super) fn leaf(&self, at: usize) -> Option<Leaf> {
        let component = u16::try_from(at).ok().filter(|_| at < self.list.len())?;
        Some(Leaf::now(self.symbol, component))
    }

    /// What a leaf stands for, if it is a generator.
    pub(super) fn get(&self, leaf: Leaf) -> Option<&Generator> {
        if leaf.symbol == self.symbol { self.list.get(leaf.component as usize) } else { None }
    }

    /// Whether nothing relates the generators but c² + s² = 1: they are cosines, sines and exponentials of multiples of
    /// different monomials in the leaves (Ax 1971). Values of other functions may be related in ways that are not looked for.
    #[cfg(feature = "certificates")]
    pub(super) fn are_independent(&self, graph: &Graph) -> bool {
        let leaf = |base: Expr| matches!(graph.node(base), Node::Leaf(l) if self.get(*l).is_none());
        self.list.iter().all(|g| match *g {
            Generator::Cosine(a) | Generator::Sine(a) | Generator::Exponential(a) => {
                let combination = Combinations::default().of(graph, a);
                combination.keys().all(|m| m.iter().all(|&(base, _)| leaf(base)))
            }
            Generator::Opaque(_) => false,
            Generator::Sign | Generator::Half | Generator::Free => true,
        })
    }

    /// The other generator of a cosine and sine pair: (cosine, sine) for either.
    pub(super) fn circle(&self, leaf: Leaf) -> Option<(Leaf, Leaf)> {
        let at = |component| Leaf { component, ..leaf };
        match self.get(leaf)? {
            Generator::Cosine(_) => Some((leaf, at(leaf.component + 1))),
            Generator::Sine(_) => Some((at(leaf.component - 1), leaf)),
            _ => None,
        }
    }
}

/// The lowering of one problem.
pub(super) struct Lowering<'g> {
    pub(super) graph: &'g mut Graph,
    pub(super) generators: Generators,
    combinations: Combinations,
    /// Monomials of arguments that are combinations of others.
    relations: Relations,
    /// Common measures of the coefficients of a monomial: under sin, cos, tan and under exp, sinh, cosh, tanh.
    circle_units: FastMap<Monomial, Rational>,
    exp_units: FastMap<Monomial, Rational>,
    circles: FastMap<Monomial, (Expr, Expr)>,
    exponentials: FastMap<Monomial, Expr>,
    opaque: FastMap<(Op, Vec<Expr>), Expr>,
    image: FastMap<Expr, Expr>,
    /// What is given of signs, of expressions as they are before they are lowered.
    given: Facts,
}

/// Too many generators, or a coefficient out of range: the problem is outside the class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TooLarge;

/// Whether parts of an argument are known as they are: roots, and angles that are parts of a turn.
fn is_parted(graph: &Graph, m: &Monomial) -> bool {
    let &[(base, 1)] = m.as_slice() else { return false };
    let (Node::Pi | Node::Unary(Op::Ln, _)) = *graph.node(base) else { return false };
    true
}

/// The largest number of which both are whole multiples; neither is 0.
fn common_measure(a: &Rational, b: &Rational) -> Rational {
    use dashu_int::ops::Gcd;
    let parts = |r: &Rational| (r.numerator().clone().into_parts().1, r.denominator().clone());
    let ((a, c), (b, d)) = (parts(a), parts(b));
    let g = (&a * &d).gcd(&b * &c);
    Rational::from(g) / Rational::from(c * d)
}

fn integer(r: &Rational) -> Result<i32, TooLarge> {
    i32::try_from(r.clone()).ok().filter(|n| n.abs() <= 1024).ok_or(TooLarge)
}

impl<'g> Lowering<'g> {
    /// Prepares for the given roots: whatever is lowered later must be part of them.
    pub(super) fn new(graph: &'g mut Graph, roots: &[Expr], given: Facts) -> Lowering<'g> {
        let generators = Generators::new(graph);
        let mut combinations = Combinations::default();
        let mut arguments: Vec<(bool, Combination)> = Vec::new();
        for e in graph.reachable(roots.iter().copied()) {
            arguments.push(match *graph.node(e) {
                Node::Unary(Op::Sin | Op::Cos | Op::Tan, a) => (true, combinations.of(graph, a)),
                Node::Unary(Op::Exp | Op::Sinh | Op::Cosh | Op::Tanh, a) => (false, combinations.of(graph, a)),
                Node::Binary(Op::Pow, a, b) => {
                    let log = graph.unary(Op::Ln, a);
                    let argument = graph.mul(b, log);
                    (false, combinations.of(graph, argument))
                }
                _ => continue,
            });
        }
        let monomials = arguments.iter().flat_map(|(_, argument)| argument.keys().cloned()).collect();
        let relations = relations(graph, &mut combinations, &monomials);
        let (mut circle, mut exp) = (FastMap::default(), FastMap::default());
        for (is_angle, argument) in arguments {
            let table: &mut FastMap<Monomial, Rational> = if is_angle { &mut circle } else { &mut exp };
            for (m, q) in related(&relations, argument).into_iter().filter(|(_, q)| *q != Rational::ZERO) {
                let first = if is_parted(graph, &m) { Rational::ONE } else { q.clone() };
                let unit = table.remove(&m).unwrap_or(first);
                table.insert(m, common_measure(&unit, &q));
            }
        }
        Lowering {
            graph,
            generators,
            combinations,
            relations,
            circle_units: circle,
            exp_units: exp,
            circles: FastMap::default(),
            exponentials: FastMap::default(),
            opaque: FastMap::default(),
            image: FastMap::default(),
            given,
        }
    }

    /// The image of an expression.
    pub(super) fn lower(&mut self, e: Expr) -> Result<Expr, TooLarge> {
        for node in self.needed(e) {
            let image = self.step(node)?;
            self.image.insert(node, image);
        }
        Ok(self.image[&e])
    }

    /// The nodes whose images are missing, children before parents. What stands in the argument of a cosine or an exponential
    /// has a place of its own only where [`Self::step`] asks for it.
    fn needed(&self, e: Expr) -> Vec<Expr> {
        let (mut open, mut new) = (vec![e], FastSet::default());
        while let Some(e) = open.pop() {
            if self.image.contains_key(&e) || !new.insert(e) {
                continue;
            }
            let node = self.graph.node(e);
            match *node {
                Node::Unary(Op::Sin | Op::Cos | Op::Tan | Op::Exp | Op::Sinh | Op::Cosh | Op::Tanh, _) => {}
                Node::Binary(Op::Pow, ..) => {}
                Node::Unary(Op::Ln, a) => match *self.graph.node(a) {
                    Node::Unary(Op::Exp, x) => open.push(x),
                    Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => open.push(a),
                },
                Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => {
                    open.extend(node.children());
                }
            }
        }
        let mut new: Vec<Expr> = new.into_iter().collect();
        new.sort_unstable();
        new
    }

    fn step(&mut self, node: Expr) -> Result<Expr, TooLarge> {
        Ok(match *self.graph.node(node) {
            Node::Constant(_) | Node::Leaf(_) => node,
            Node::Pi => self.opaque_node(node, Op::Neg, vec![])?,
            Node::Unary(op, a) => match op {
                Op::Neg | Op::Powi(_) | Op::Sqrt | Op::Abs => {
                    let a = self.image[&a];
                    self.graph.unary(op, a)
                }
                Op::Sin => self.circle(a)?.1,
                Op::Cos => self.circle(a)?.0,
                Op::Tan => {
                    let (c, s) = self.circle(a)?;
                    self.graph.div(s, c)
                }
                Op::Exp => self.exponential(a)?,
                Op::Sinh | Op::Cosh | Op::Tanh => {
                    let e = self.exponential(a)?;
                    let one = self.graph.integer(1);
                    let two = self.graph.integer(2);
                    let inverse = self.graph.div(one, e);
                    let (sum, difference) = (self.graph.add(e, inverse), self.graph.sub(e, inverse));
                    let (above, below) =
                        (if op == Op::Cosh { sum } else { difference }, if op == Op::Tanh { sum } else { two });
                    self.graph.div(above, below)
                }
                Op::Ln => {
                    if let Node::Unary(Op::Exp, x) = *self.graph.node(a) {
                        self.image[&x]
                    } else {
                        let image = self.image[&a];
                        self.opaque_node(node, op, vec![image])?
                    }
                }
                Op::Arcsin | Op::Arctan if self.graph.is_zero(self.image[&a]) => self.image[&a],
                Op::Arccos if self.graph.is_one(self.image[&a]) => self.graph.integer(0),
                Op::Arcsin | Op::Arccos | Op::Arctan => {
                    let image = self.image[&a];
                    self.opaque_node(node, op, vec![image])?
                }
                Op::Add
                | Op::Sub
                | Op::Mul
                | Op::Div
                | Op::Pow
                | Op::Arctan2
                | Op::Agm
                | Op::DirectionCosine
                | Op::Restrict => {
                    return Err(TooLarge);
                }
            },
            Node::Binary(op, a, b) => match op {
                Op::Add | Op::Sub | Op::Mul | Op::Div => {
                    let (a, b) = (self.image[&a], self.image[&b]);
                    self.graph.binary(op, a, b)
                }
                Op::Pow => {
                    let log = self.graph.unary(Op::Ln, a);
                    let argument = self.graph.mul(b, log);
                    self.exponential(argument)?
                }
                // Equal where it has a value; the needs of what restricts it are conditions.
                Op::Restrict => self.image[&a],
                _ => {
                    let (y, x) = (self.image[&a], self.image[&b]);
                    let ahead = self.graph.as_constant(x).is_some_and(|x| *x > Rational::ZERO);
                    if op == Op::Arctan2 && self.graph.is_zero(y) && ahead {
                        y
                    } else {
                        self.opaque_node(node, op, vec![y, x])?
                    }
                }
            },
        })
    }

    fn opaque_node(&mut self, node: Expr, op: Op, images: Vec<Expr>) -> Result<Expr, TooLarge> {
        if let Some(&e) = self.opaque.get(&(op, images.clone())) {
            return Ok(e);
        }
        let leaf = self.generators.add(Generator::Opaque(node)).ok_or(TooLarge)?;
        let e = self.graph.leaf(leaf);
        self.opaque.insert((op, images), e);
        Ok(e)
    }

    /// (cos, sin) of the sum of two angles.
    fn turn(&mut self, (c, s): (Expr, Expr), (d, t): (Expr, Expr)) -> (Expr, Expr) {
        let g = &mut *self.graph;
        let (cd, st) = (g.mul_structural(c, d), g.mul_structural(s, t));
        let (sd, ct) = (g.mul_structural(s, d), g.mul_structural(c, t));
        (g.sub(cd, st), g.add(sd, ct))
    }

    /// (cos, sin) of n times an angle.
    fn multiple(&mut self, angle: (Expr, Expr), n: i32) -> (Expr, Expr) {
        let mut base = if n < 0 { (angle.0, self.graph.neg(angle.1)) } else { angle };
        let mut out = (self.graph.integer(1), self.graph.integer(0));
        let mut e = n.unsigned_abs();
        while e > 0 {
            if e & 1 == 1 {
                out = self.turn(out, base);
            }
            e >>= 1;
            if e > 0 {
                base = self.turn(base, base);
            }
        }
        out
    }

    /// What an argument is.
    fn argument(&mut self, argument: Expr) -> Combination {
        related(&self.relations, self.combinations.of(self.graph, argument))
    }

    /// (cos, sin) of an argument.
    fn circle(&mut self, argument: Expr) -> Result<(Expr, Expr), TooLarge> {
        let combination = self.argument(argument);
        let mut out = (self.graph.integer(1), self.graph.integer(0));
        for (m, q) in combination {
            let part = match self.special_angle(&m, &q)? {
                Some(pair) => pair,
                None => {
                    let unit = self.circle_units.get(&m).cloned().unwrap_or(Rational::ONE);
                    let times = integer(&(q / &unit))?;
                    let angle = self.circle_generators(&m, &unit)?;
                    self.multiple(angle, times)
                }
            };
            out = self.turn(out, part);
        }
        Ok(out)
    }

    fn circle_generators(&mut self, m: &Monomial, unit: &Rational) -> Result<(Expr, Expr), TooLarge> {
        if let Some(&pair) = self.circles.get(m) {
            return Ok(pair);
        }
        let argument = expression(self.graph, m, unit);
        let c = self.generators.add(Generator::Cosine(argument)).ok_or(TooLarge)?;
        let s = self.generators.add(Generator::Sine(argument)).ok_or(TooLarge)?;
        let pair = (self.graph.leaf(c), self.graph.leaf(s));
        self.circles.insert(m.clone(), pair);
        Ok(pair)
    }

    /// Angles whose cosine and sine are algebraic: multiples of π/12, and of arccos, arcsin, arctan, atan2 or their halves.
    fn special_angle(&mut self, m: &Monomial, q: &Rational) -> Result<Option<(Expr, Expr)>, TooLarge> {
        let &[(base, 1)] = m.as_slice() else { return Ok(None) };
        if matches!(self.graph.node(base), Node::Pi) {
            return Ok(self.part_of_pi(q));
        }
        // The argument may have been made while lowering.
        let (first, second) = match *self.graph.node(base) {
            Node::Unary(Op::Arccos | Op::Arcsin | Op::Arctan, u) => (self.lower(u)?, None),
            Node::Binary(Op::Arctan2, y, x) => (self.lower(y)?, Some(self.lower(x)?)),
            Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => return Ok(None),
        };
        let g = &mut *self.graph;
        let one = g.integer(1);
        let pair = match (*g.node(base)).clone() {
            Node::Unary(op @ (Op::Arccos | Op::Arcsin), _) => {
                let u = first;
                let square = g.powi(u, 2);
                let under = g.sub(one, square);
                let root = g.unary(Op::Sqrt, under);
                if op == Op::Arccos { (u, root) } else { (root, u) }
            }
            Node::Unary(Op::Arctan, _) => {
                let u = first;
                let square = g.powi(u, 2);
                let under = g.add(one, square);
                let root = g.unary(Op::Sqrt, under);
                (g.div(one, root), g.div(u, root))
            }
            Node::Binary(Op::Arctan2, ..) => {
                let (y, x) = (first, second.unwrap_or(one));
                let (yy, xx) = (g.powi(y, 2), g.powi(x, 2));
                let under = g.add(xx, yy);
                let root = g.unary(Op::Sqrt, under);
                (g.div(x, root), g.div(y, root))
            }
            Node::Constant(_) | Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => return Ok(None),
        };
        if let Ok(n) = i64::try_from(q.clone()) {
            return Ok(Some(self.multiple(pair, integer(&Rational::from(n))?)));
        }
        let Ok(halves) = i64::try_from(q * Rational::from(2)) else { return Ok(None) };
        // All principal values lie in [−π, π], so the cosine of the half is not negative; its sine has the sign of the
        // sine of the whole, and for arccos, in [0, π], it is a root itself. The value π is also attained by atan2, where
        // y = 0 and x < 0: there the cosine of the half is 0, and divides nothing.
        if let Node::Binary(Op::Arctan2, y, x) = *g.node(base) {
            let sign = |e: Expr| self.given.sign(g, &self.generators, e);
            if !sign(y).nonzero && !sign(x).not_negative {
                return Ok(None);
            }
        }
        let two = g.integer(2);
        let more = g.add(one, pair.0);
        let over = g.div(more, two);
        let c = g.unary(Op::Sqrt, over);
        let s = if matches!(g.node(base), Node::Unary(Op::Arccos, _)) {
            let less = g.sub(one, pair.0);
            let over = g.div(less, two);
            g.unary(Op::Sqrt, over)
        } else {
            let twice = g.mul(two, c);
            g.div(pair.1, twice)
        };
        Ok(Some(self.multiple((c, s), integer(&Rational::from(halves))?)))
    }

    /// (cos, sin) of qπ for multiples of π/60, and for halves and quarters of them; `None` for others.
    fn part_of_pi(&mut self, q: &Rational) -> Option<(Expr, Expr)> {
        // Without whole turns, however many.
        let two = Rational::from(2);
        let q = &(q - Rational::from((q / &two).floor()) * &two);
        let sixtieths = i64::try_from(q * Rational::from(60)).ok();
        if let Some(n) = sixtieths {
            // n/60 = a/12 + b/5 with n = 5a + 12b: 12·3 = 36 = 1 modulo 5.
            let b = (3 * n).rem_euclid(5);
            let a = (n - 12 * b) / 5;
            let twelfth = self.twelfths_of_pi(a.rem_euclid(24) as i32);
            if b == 0 {
                return Some(twelfth);
            }
            let fifth = self.fifth_of_pi();
            let fifths = self.multiple(fifth, b as i32);
            return Some(self.turn(twelfth, fifths));
        }
        // Of halves, π/2ᵏ⁺¹ from π/2ᵏ: in (0, π) the sine and the cosine of the half are positive.
        let (top, under) = q.clone().into_parts();
        let under = i64::try_from(under).ok().filter(|n| *n <= 240)?;
        let whole = Rational::ONE / Rational::from(under / 2);
        if under % 2 != 0 {
            return None;
        }
        let (c, _) = self.part_of_pi(&whole)?;
        let g = &mut *self.graph;
        let (one, two) = (g.integer(1), g.integer(2));
        let half = |g: &mut Graph, e: Expr| {
            let over = g.div(e, two);
            g.unary(Op::Sqrt, over)
        };
        let (more, less) = (g.add(one, c), g.sub(one, c));
        let pair = (half(g, more), half(g, less));
        let n = i32::try_from(top % (2 * under)).ok()?;
        Some(self.multiple(pair, n))
    }

    /// (cos, sin) of π/5: (1 + √5)/4 and √(10 − 2√5)/4.
    fn fifth_of_pi(&mut self) -> (Expr, Expr) {
        let g = &mut *self.graph;
        let (one, two, four, five, ten) = (g.integer(1), g.integer(2), g.integer(4), g.integer(5), g.integer(10));
        let root = g.unary(Op::Sqrt, five);
        let sum = g.add(one, root);
        let twice = g.mul(two, root);
        let under = g.sub(ten, twice);
        let sine = g.unary(Op::Sqrt, under);
        (g.div(sum, four), g.div(sine, four))
    }

    /// (cos, sin) of n·π/12: a quarter turn n div 6 times, then π/12 = π/3 − π/4, π/6, π/4, π/3, 5π/12 = π/4 + π/6.
    fn twelfths_of_pi(&mut self, n: i32) -> (Expr, Expr) {
        let g = &mut *self.graph;
        let (zero, one, two, three) = (g.integer(0), g.integer(1), g.integer(2), g.integer(3));
        let half = g.div(one, two);
        let (root2, root3) = (g.unary(Op::Sqrt, two), g.unary(Op::Sqrt, three));
        let (cos45, cos30) = (g.div(root2, two), g.div(root3, two));
        let (eighth, twelfth) = ((cos45, cos45), (cos30, half));
        let minus = g.neg(cos45);
        let part = match n % 6 {
            0 => (one, zero),
            1 => self.turn((half, cos30), (cos45, minus)),
            2 => twelfth,
            3 => eighth,
            4 => (half, cos30),
            _ => self.turn(eighth, twelfth),
        };
        let mut out = part;
        for _ in 0..n / 6 {
            out = (self.graph.neg(out.1), out.0);
        }
        out
    }

    /// e^argument.
    fn exponential(&mut self, argument: Expr) -> Result<Expr, TooLarge> {
        let combination = self.argument(argument);
        let mut out = self.graph.integer(1);
        for (m, q) in combination {
            let factor = match self.power_of_log(&m, &q)? {
                Some(e) => e,
                None => {
                    let unit = self.exp_units.get(&m).cloned().unwrap_or(Rational::ONE);
                    let times = integer(&(q / &unit))?;
                    let base = match self.exponentials.get(&m) {
                        Some(&e) => e,
                        None => {
                            let part = expression(self.graph, &m, &unit);
                            let leaf = self.generators.add(Generator::Exponential(part)).ok_or(TooLarge)?;
                            self.note_radical(&m, &unit, leaf)?;
                            let e = self.graph.leaf(leaf);
                            self.exponentials.insert(m.clone(), e);
                            e
                        }
                    };
                    self.graph.powi(base, times)
                }
            };
            out = self.graph.mul(out, factor);
        }
        Ok(out)
    }

    /// Keeps what a root is of, if the exponential is one, and of something that is not a number.
    fn note_radical(&mut self, m: &Monomial, unit: &Rational, leaf: Leaf) -> Result<(), TooLarge> {
        let &[(base, 1)] = m.as_slice() else { return Ok(()) };
        let &Node::Unary(Op::Ln, of) = self.graph.node(base) else { return Ok(()) };
        let order = integer(&(Rational::ONE / unit))?;
        if order > 2 && order <= HIGHEST_ROOT && !self.graph.leaves([of]).is_empty() {
            self.generators.radicals.push(Radical { generator: leaf.component.into(), of, order });
        }
        Ok(())
    }

    /// rⁿ − u for the roots r = u^{1/n}.
    pub(super) fn radicals(&mut self) -> Result<Vec<Expr>, TooLarge> {
        let mut out = Vec::new();
        // Lowering what a root is of may bring others.
        let mut at = 0;
        while let Some(&Radical { generator, of, order }) = self.generators.radicals.get(at) {
            let of = self.lower(of)?;
            if let Some(leaf) = self.generators.leaf(generator) {
                let root = self.graph.leaf(leaf);
                let power = self.graph.powi(root, order);
                out.push(self.graph.sub(power, of));
            }
            at += 1;
        }
        Ok(out)
    }

    /// exp(q·ln u) = u^q for q a multiple of ½, or of ¼ or ⅛ where no other parts of ln u occur.
    fn power_of_log(&mut self, m: &Monomial, q: &Rational) -> Result<Option<Expr>, TooLarge> {
        let &[(base, 1)] = m.as_slice() else { return Ok(None) };
        let &Node::Unary(Op::Ln, u) = self.graph.node(base) else { return Ok(None) };
        let parts = self.exp_units.get(m).and_then(|unit| i64::try_from(Rational::ONE / unit).ok());
        let roots = match i64::try_from(q.denominator().clone()) {
            Ok(1) => 0,
            Ok(2) => 1,
            Ok(4) if matches!(parts, Some(4 | 8)) => 2,
            Ok(8) if parts == Some(8) => 3,
            _ => return Ok(None),
        };
        let exponent = integer(&Rational::from(q.numerator().clone()))?;
        // The argument may have been made while lowering: the logarithm of a power's base.
        let mut root = self.lower(u)?;
        for _ in 0..roots {
            root = self.graph.unary(Op::Sqrt, root);
        }
        Ok(Some(self.graph.powi(root, exponent)))
    }
}
