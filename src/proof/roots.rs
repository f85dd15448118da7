//! Square roots and absolute values on a tower without hidden dependencies.
//!
//! **In:** lowered expressions with √ and |·| in their real meaning. **Out:** the same with every root written σ·√b, σ = ±1 a
//! sign generator for each distinct b, and |b| written σ·b; √ then means any root. An expression that vanishes for *every*
//! choice of the signs vanishes in its real meaning, whichever choice that is.
//!
//! That alone is sound, but would leave √(ab) = √a·√b undecided: of the eight choices four fail, none of which is real.
//! So roots are first brought to a normal form, by rules that hold wherever both sides have a value:
//!
//! * √(q·∏ bᵏ) is taken apart; a factor known to be ≥ 0 (declared, or the radicand of another root of the problem, or by its
//!   structure) has a root of its own, even powers of the others come out as |b|, the rest stays under one root;
//! * positive rational constants are split into primes;
//! * sums of fractions are one fraction, squares of polynomials are roots taken exactly; √e is √(eb)/√b where eb is a square
//!   and √b occurs; √(a + b√c) is taken apart where a² − b²c is a square;
//! * radicands that agree at random points up to a small rational factor are the same; a radicand that agrees at random
//!   points with the square of an expression of the problem, or of a product or quotient of two, is that square: √(m²) = |m|.
//!
//! What was recognised by random points is put on a list to be tested with the identity itself, so that it is covered by the
//! same error bound.

mod denesting;
mod signs;

use super::generators::{Generator, Generators};
use super::polynomial::{factors, polynomial_root, without_content};
use super::probe::{Probe, Sight};
use super::sign::Facts;
use super::solve::unmarked;
use expr::FastMap;
use expr::{Expr, Graph, Leaf, Node, Op, Rational};
use number::Finite;

/// The state of the normal form of one case.
pub(super) struct Roots<'a> {
    pub(super) graph: &'a mut Graph,
    pub(super) generators: &'a mut Generators,
    pub(super) probe: &'a mut Probe,
    pub(super) facts: Facts,
    /// Expressions recognised as zero by random points.
    pub(super) taken_as_zero: Vec<Expr>,
    /// Sign generator → the expression whose sign it is, or the radicand of whose root.
    pub(super) signs: Vec<(Leaf, Expr)>,
    image: FastMap<Expr, Expr>,
    /// Bases seen: expression and its values at the two points.
    bases: Vec<(Expr, [Finite; 2])>,
    base_sign: FastMap<Expr, Expr>,
    unit_roots: FastMap<Expr, Expr>,
    /// Radicands that are no numbers and whose roots have a sign of their own, in their order.
    ordered: Vec<Expr>,
    /// Signs, and the roots that they belong to.
    pairs: Vec<(Expr, Expr)>,
    /// Sums that are known to be ≥ 0 (or ≤ 0), by their polynomials up to a factor.
    sums: FastMap<Expr, bool>,
    /// Candidates for square roots: expression, squares of values.
    candidates: Vec<(Expr, [Finite; 2])>,
    /// Whether roots are written by other roots, and signs of sums are looked up.
    further: bool,
}

/// Rational factors by which two radicands may differ and still be recognised.
const SCALES: [(i64, i64); 13] =
    [(1, 1), (-1, 1), (4, 1), (1, 4), (2, 1), (1, 2), (-4, 1), (-1, 4), (3, 1), (1, 3), (9, 1), (1, 9), (-2, 1)];

const MOST_CANDIDATES: usize = 256;
/// Radicands that are looked at for products that are squares.
const MOST_RELATED: usize = 6;
/// Radicands larger than this are not taken apart into nested roots.
const MOST_NESTED: usize = 64;
/// How often squares of roots are looked for in what they leave.
const MOST_PASSES: usize = 3;

impl<'a> Roots<'a> {
    pub(super) fn new(
        graph: &'a mut Graph,
        generators: &'a mut Generators,
        probe: &'a mut Probe,
        facts: Facts,
        further: bool,
    ) -> Roots<'a> {
        Roots {
            graph,
            generators,
            probe,
            facts,
            taken_as_zero: Vec::new(),
            signs: Vec::new(),
            image: FastMap::default(),
            bases: Vec::new(),
            base_sign: FastMap::default(),
            unit_roots: FastMap::default(),
            ordered: Vec::new(),
            pairs: Vec::new(),
            sums: FastMap::default(),
            candidates: Vec::new(),
            further,
        }
    }

    /// Looks through the expressions: their radicands become facts, their root-free parts candidates for square roots.
    pub(super) fn prepare(&mut self, exprs: &[Expr]) {
        let all = self.graph.reachable(exprs.iter().copied());
        let mut with_root: FastMap<Expr, bool> = FastMap::default();
        let mut free = Vec::new();
        let mut any = false;
        for &node in &all {
            let rooted = match *self.graph.node(node) {
                Node::Unary(Op::Sqrt, a) => {
                    any = true;
                    if unmarked(self.graph, self.generators, a).is_none() {
                        self.facts.not_negative.insert(a);
                    }
                    true
                }
                Node::Unary(Op::Abs, _) => true,
                Node::Leaf(leaf) => self.generators.get(leaf) == Some(&Generator::Sign),
                ref n => n.children().any(|c| with_root.get(&c).copied().unwrap_or(false)),
            };
            with_root.insert(node, rooted);
            if !rooted && !matches!(self.graph.node(node), Node::Constant(_)) {
                free.push(node);
            }
        }
        if !any {
            return;
        }
        if self.further {
            self.note_sums();
        }
        // The last are the largest; both ends are wanted when there are too many.
        if free.len() > MOST_CANDIDATES {
            let tail = free.split_off(free.len() - MOST_CANDIDATES / 2);
            free.truncate(MOST_CANDIDATES / 2);
            free.extend(tail);
        }
        let at: Vec<_> = (0..2).map(|p| self.probe.values(self.graph, self.generators, p, &free)).collect();
        for (i, &e) in free.iter().enumerate() {
            if let (Ok(x), Ok(y)) = (at[0][i], at[1][i])
                && !x.is_zero()
                && !y.is_zero()
            {
                let f = &self.probe.field;
                self.candidates.push((e, [f.product(x, x), f.product(y, y)]));
            }
        }
    }

    /// The normal form of an expression.
    pub(super) fn normal(&mut self, e: Expr) -> Expr {
        for node in self.graph.reachable([e]) {
            if self.image.contains_key(&node) {
                continue;
            }
            let image = match *self.graph.node(node) {
                Node::Constant(_) | Node::Pi | Node::Leaf(_) => node,
                Node::Unary(op, a) => {
                    let inner = self.image[&a];
                    match op {
                        Op::Sqrt => match unmarked(self.graph, self.generators, a) {
                            Some(plain) => {
                                let plain = match self.image.get(&plain) {
                                    Some(&image) => image,
                                    None => plain,
                                };
                                self.graph.unary(Op::Sqrt, plain)
                            }
                            None => self.root(inner),
                        },
                        Op::Abs => self.absolute(inner),
                        _ => self.graph.unary(op, inner),
                    }
                }
                Node::Binary(op, a, b) => {
                    let (a, b) = (self.image[&a], self.image[&b]);
                    self.graph.binary(op, a, b)
                }
            };
            // Facts stated for an expression hold for its normal form.
            if self.facts.positive.contains(&node) {
                self.facts.positive.insert(image);
            }
            if self.facts.not_negative.contains(&node) {
                self.facts.not_negative.insert(image);
            }
            if self.facts.not_positive.contains(&node) {
                self.facts.not_positive.insert(image);
            }
            if self.facts.nonzero.contains(&node) {
                self.facts.nonzero.insert(image);
            }
            self.image.insert(node, image);
        }
        self.image[&e]
    }

    fn sign_leaf(&mut self, of: Expr) -> Expr {
        match self.generators.add(Generator::Sign) {
            Some(leaf) => {
                self.signs.push((leaf, of));
                self.graph.leaf(leaf)
            }
            // Out of generators: the caller sees a root without a sign; the count of signs already exceeds every limit.
            None => self.graph.integer(1),
        }
    }

    /// The representative of a base, and the rational factor: b = q·representative.
    fn representative(&mut self, b: Expr) -> (Rational, Expr) {
        if self.bases.iter().any(|&(e, _)| e == b) {
            return (Rational::ONE, b);
        }
        let (Some(x), Some(y)) = (self.value(0, b), self.value(1, b)) else { return (Rational::ONE, b) };
        for (e, [u, v]) in self.bases.clone() {
            for (n, d) in SCALES {
                let f = &self.probe.field;
                let (n, d) = (f.integer(n), f.integer(d));
                if f.product(d, x) == f.product(n, u) && f.product(d, y) == f.product(n, v) {
                    let (n, d) = self.scale(n, d);
                    let q = n / d;
                    let scaled = self.graph.constant(q.clone());
                    let image = self.graph.mul(scaled, e);
                    let difference = self.graph.sub(b, image);
                    if !self.confirmed(difference) {
                        continue;
                    }
                    self.taken_as_zero.push(difference);
                    return (q, e);
                }
            }
        }
        self.bases.push((b, [x, y]));
        (Rational::ONE, b)
    }

    fn scale(&self, n: Finite, d: Finite) -> (Rational, Rational) {
        let f = &self.probe.field;
        let back = |v: Finite| {
            SCALES.iter().flat_map(|&(n, d)| [n, d]).find(|&k| f.integer(k) == v).map_or(Rational::ONE, Rational::from)
        };
        (back(n), back(d))
    }

    /// Whether a relation seen at two points holds at more, with other signs of the roots in it.
    fn confirmed(&mut self, difference: Expr) -> bool {
        self.probe.sight(self.graph, self.generators, difference) == Sight::Zero
    }

    fn value(&mut self, point: usize, e: Expr) -> Option<Finite> {
        self.probe.values(self.graph, self.generators, point, &[e])[0].ok()
    }

    fn not_negative(&mut self, e: Expr) -> bool {
        self.facts.sign(self.graph, self.generators, e).not_negative || self.sign_of_sum(e) == Some(true)
    }

    fn not_positive(&mut self, e: Expr) -> bool {
        self.facts.sign(self.graph, self.generators, e).not_positive || self.sign_of_sum(e) == Some(false)
    }

    /// |e|.
    fn absolute(&mut self, e: Expr) -> Expr {
        if self.graph.is_zero(e) {
            return e;
        }
        if self.not_negative(e) {
            return e;
        }
        if self.not_positive(e) {
            return self.graph.neg(e);
        }
        let (q, parts) = factors(self.graph, e);
        let (q, parts) = without_content(self.graph, q, parts, false);
        let mut out = self.graph.constant(if q < Rational::ZERO { -q } else { q });
        for (base, k) in parts {
            let power = self.graph.powi(base, k);
            out = self.graph.mul(out, power);
            if k % 2 != 0 && self.not_positive(base) {
                out = self.graph.neg(out);
            } else if k % 2 != 0 && !self.not_negative(base) {
                let sign = self.sign_of(base);
                out = self.graph.mul(out, sign);
            }
        }
        out
    }

    fn sign_of(&mut self, base: Expr) -> Expr {
        let (q, e) = self.representative(base);
        let sign = match self.base_sign.get(&e) {
            Some(&s) => s,
            None => {
                let s = self.sign_leaf(e);
                self.base_sign.insert(e, s);
                s
            }
        };
        if q < Rational::ZERO { self.graph.neg(sign) } else { sign }
    }

    /// √e.
    fn root(&mut self, e: Expr) -> Expr {
        if self.graph.is_zero(e) || self.graph.is_one(e) {
            return e;
        }
        let e = if self.further { self.without_roots_of(e) } else { e };
        let (mut q, mut parts) = factors(self.graph, e);
        // A sum of fractions is one fraction, and what all terms have in common comes out.
        if self.further {
            let (scale, apart) = without_content(self.graph, q.clone(), parts.clone(), false);
            if apart.len() > parts.len() {
                (q, parts) = (scale, apart);
            }
        }
        // Products are taken apart first; only what stays together is looked up.
        let together = parts.iter().filter(|&&(base, k)| k % 2 != 0 && !self.not_negative(base)).count();
        if (together > 1 || parts.len() == 1)
            && let Some(square) = self.as_square(e).or_else(|| self.nested(e))
        {
            return square;
        }
        let mut out = self.graph.integer(1);
        let mut rest = self.graph.integer(1);
        let mut rest_empty = true;
        for (mut base, k) in parts {
            let sum = matches!(self.graph.node(base), Node::Binary(Op::Add | Op::Sub, ..));
            if self.further
                && sum
                && let Some((m, p)) = polynomial_root(self.graph, base)
                && let Some(scale) = expr::raised(&p, k)
            {
                let size = self.absolute(m);
                let power = self.graph.powi(size, k);
                out = self.graph.mul(out, power);
                q *= scale;
                continue;
            }
            if k % 2 != 0 && self.not_positive(base) {
                base = self.graph.neg(base);
                q = -q;
            }
            let odd = k.rem_euclid(2);
            let whole = (k - odd) / 2;
            if whole != 0 {
                let inner = self.absolute(base);
                let power = self.graph.powi(inner, whole);
                out = self.graph.mul(out, power);
            }
            if odd == 1 {
                if self.not_negative(base) {
                    let root = match self.as_square(base) {
                        Some(root) => root,
                        None => {
                            let (scale, base) = self.representative(base);
                            q *= scale;
                            self.unit_root(base)
                        }
                    };
                    out = self.graph.mul(out, root);
                } else {
                    rest = self.graph.mul(rest, base);
                    rest_empty = false;
                }
            }
        }
        if rest_empty {
            let constant = self.constant_root(&q);
            return self.graph.mul(out, constant);
        }
        // The sign of the constant stays with factors of unknown sign.
        let magnitude = if q < Rational::ZERO {
            rest = self.graph.neg(rest);
            -q
        } else {
            q
        };
        let (scale, rest) = if rest == e { (Rational::ONE, e) } else { self.same_radicand(rest) };
        let constant = self.constant_root(&(magnitude * scale));
        let root = self.unit_root(rest);
        let product = self.graph.mul(constant, root);
        self.graph.mul(out, product)
    }

    /// Positive multiples of a radicand seen before.
    fn same_radicand(&mut self, e: Expr) -> (Rational, Expr) {
        let (q, base) = self.representative(e);
        if q > Rational::ZERO { (q, base) } else { (Rational::ONE, e) }
    }

    fn unit_root(&mut self, e: Expr) -> Expr {
        let (q, e) = match self.unit_roots.contains_key(&e) {
            true => (Rational::ONE, e),
            false => self.same_radicand(e),
        };
        let constant = if q == Rational::ONE { self.graph.integer(1) } else { self.constant_root(&q) };
        if let Some(&r) = self.unit_roots.get(&e) {
            return self.graph.mul(constant, r);
        }
        let image = match self.by_others(e) {
            Some(root) => root,
            None => {
                let sign = self.sign_leaf(e);
                let root = self.graph.unary(Op::Sqrt, e);
                self.ordered.push(e);
                self.pairs.push((sign, root));
                self.graph.mul(sign, root)
            }
        };
        self.unit_roots.insert(e, image);
        // It stands for the root that is not negative.
        if self.further {
            self.facts.note_not_negative(self.graph, image);
        }
        self.graph.mul(constant, image)
    }

    /// √q for a rational: squares come out, small primes have roots of their own.
    fn constant_root(&mut self, q: &Rational) -> Expr {
        if *q < Rational::ZERO {
            let e = self.graph.constant(q.clone());
            return self.unit_root_of_constant(e);
        }
        // √(n/d) = √(n·d)/d.
        let (top, under) = q.clone().into_parts();
        let under = Rational::from(under);
        let mut left = Rational::from(top) * under.clone();
        let mut outside = Rational::ONE / under;
        let mut primes = Vec::new();
        let mut p: u32 = 2;
        while p < 1000 && left != Rational::ONE {
            let prime = Rational::from(p);
            let square = &prime * &prime;
            while (&left / &square).is_int() {
                left /= &square;
                outside *= &prime;
            }
            if (&left / &prime).is_int() {
                left /= &prime;
                primes.push(prime);
            }
            p += 1;
        }
        if left != Rational::ONE {
            primes.push(left);
        }
        let mut out = self.graph.constant(outside);
        for p in primes {
            let e = self.graph.constant(p);
            let root = self.unit_root_of_constant(e);
            out = self.graph.mul(out, root);
        }
        out
    }

    fn unit_root_of_constant(&mut self, e: Expr) -> Expr {
        if let Some(&r) = self.unit_roots.get(&e) {
            return r;
        }
        let sign = self.sign_leaf(e);
        let root = self.graph.unary(Op::Sqrt, e);
        self.pairs.push((sign, root));
        let image = self.graph.mul(sign, root);
        self.unit_roots.insert(e, image);
        image
    }

    /// √e = √q·|m₁·m₂| when e = q·(m₁m₂)² for expressions of the problem.
    fn as_square(&mut self, e: Expr) -> Option<Expr> {
        if self.further
            && let Some((m, q)) = polynomial_root(self.graph, e)
        {
            let size = self.absolute(m);
            let constant = self.constant_root(&q);
            return Some(self.graph.mul(constant, size));
        }
        let compound = matches!(self.graph.node(e), Node::Binary(Op::Add | Op::Sub | Op::Mul | Op::Div, ..));
        if !compound || self.candidates.is_empty() {
            return None;
        }
        let (x, y) = (self.value(0, e)?, self.value(1, e)?);
        let f = self.probe.field.clone();
        let index: FastMap<Finite, usize> =
            self.candidates.iter().enumerate().rev().map(|(i, (_, v))| (v[0], i)).collect();
        let (inverse_x, inverse_y) = (f.inverse(x)?, f.inverse(y)?);
        let mut inverse_squares: Vec<Finite> = self.candidates.iter().map(|(_, v)| v[0]).collect();
        if !f.invert_all(&mut inverse_squares) {
            return None;
        }
        for (n, d) in SCALES.into_iter().filter(|&(n, _)| n > 0) {
            let q = Rational::from(n) / Rational::from(d);
            let scale = f.product(f.integer(n), f.inverse(f.integer(d))?);
            let target = f.product(x, f.inverse(scale)?);
            let target_y = f.product(y, f.inverse(scale)?);
            // e/q = m²
            let mut found = index.get(&target).filter(|&&i| self.candidates[i].1[1] == target_y).map(|&i| (i, None));
            if found.is_none() {
                let inverse_target = f.product(inverse_x, scale);
                let inverse_target_y = f.product(inverse_y, scale);
                for (j, inverse) in inverse_squares.iter().enumerate() {
                    // e/q = (m_i·m_j)²
                    let wanted = f.product(target, *inverse);
                    if let Some(&i) = index.get(&wanted)
                        && f.product(self.candidates[i].1[1], self.candidates[j].1[1]) == target_y
                    {
                        found = Some((i, Some((j, false))));
                        break;
                    }
                    // e/q = (m_j/m_i)²
                    let wanted = f.product(self.candidates[j].1[0], inverse_target);
                    if let Some(&i) = index.get(&wanted)
                        && self.candidates[j].1[1]
                            == f.product(self.candidates[i].1[1], f.inverse(inverse_target_y).unwrap_or_default())
                    {
                        found = Some((i, Some((j, true))));
                        break;
                    }
                }
            }
            let Some((i, second)) = found else { continue };
            let m = self.candidates[i].0;
            let m = match second {
                None => m,
                Some((j, false)) => self.graph.mul(m, self.candidates[j].0),
                Some((j, true)) => self.graph.div(self.candidates[j].0, m),
            };
            let square = self.graph.powi(m, 2);
            let factor = self.graph.constant(q.clone());
            let scaled = self.graph.mul(factor, square);
            let difference = self.graph.sub(e, scaled);
            if !self.confirmed(difference) {
                continue;
            }
            self.taken_as_zero.push(difference);
            let absolute = self.absolute(m);
            let constant = self.constant_root(&q);
            return Some(self.graph.mul(constant, absolute));
        }
        None
    }
}
