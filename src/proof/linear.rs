//! Arguments of transcendental functions as rational combinations of monomials.
//!
//! sin, cos and exp of a sum are consistent with those of its parts only if equal parts are recognised: 2kt and kt + tk
//! are the same argument, (x + y)/2 is half of x plus half of y. [`Combinations::of`] expands sums and products into
//! Σ qᵢ·mᵢ with rational qᵢ and monomials mᵢ in nodes that are neither sums nor products. What is not recognised as equal
//! is taken as independent, which can only make an identity harder to prove, never easier.

use expr::FastMap;
use expr::{Expr, Graph, Node, Op, Rational};
use std::collections::BTreeMap;

/// A product of integer powers of nodes, sorted by node; empty for 1.
pub(super) type Monomial = Vec<(Expr, i32)>;

/// Σ q·m; no zero coefficients.
pub(super) type Combination = BTreeMap<Monomial, Rational>;

/// Sums longer than this are left as they are written.
const LONGEST: usize = 48;

/// Memory of the expansions of one graph.
#[derive(Debug, Default)]
pub(super) struct Combinations {
    known: FastMap<Expr, Combination>,
}

fn single(base: Expr, power: i32) -> Combination {
    Combination::from([(vec![(base, power)], Rational::ONE)])
}

/// Adds a term.
pub(super) fn add_to(sum: &mut Combination, monomial: Monomial, q: Rational) {
    let old = sum.remove(&monomial).unwrap_or(Rational::ZERO);
    let new = old + q;
    if new != Rational::ZERO {
        sum.insert(monomial, new);
    }
}

/// The largest exponent that is computed: larger ones are no numbers of this program, and two that are too large are not one.
const HIGHEST: u32 = 1 << 30;

/// The sum of two exponents; `None` where it is too large.
pub(super) fn added(n: i32, k: i32) -> Option<i32> {
    n.checked_add(k).filter(|sum| sum.unsigned_abs() <= HIGHEST)
}

/// The exponent of a power of a power; `None` where it is too large.
pub(super) fn multiplied(n: i32, k: i32) -> Option<i32> {
    n.checked_mul(k).filter(|product| product.unsigned_abs() <= HIGHEST)
}

/// A product to a power; `None` where an exponent is too large.
pub(super) fn to_power(m: &[(Expr, i32)], k: i32) -> Option<Monomial> {
    m.iter().map(|&(base, n)| Some((base, multiplied(n, k)?))).collect()
}

/// Takes a base once more into a product.
pub(super) fn put(all: &mut Vec<(Expr, i32)>, base: Expr, k: i32) {
    // What would be too large stands beside what is there already: a product is a product in two parts, too.
    let room = |(other, n): &&mut (Expr, i32)| *other == base && added(*n, k).is_some();
    match all.iter_mut().find(room) {
        Some((_, n)) => *n += k,
        None => all.push((base, k)),
    }
}

/// The product; `None` where an exponent is too large.
pub(super) fn times(a: &Monomial, b: &Monomial) -> Option<Monomial> {
    let mut product: BTreeMap<Expr, i32> = a.iter().copied().collect();
    for &(base, n) in b {
        let power = product.entry(base).or_insert(0);
        *power = added(*power, n)?;
        if *power == 0 {
            product.remove(&base);
        }
    }
    Some(product.into_iter().collect())
}

/// The product; `None` where it is too long.
pub(super) fn product(a: &Combination, b: &Combination) -> Option<Combination> {
    if a.len() * b.len() > LONGEST {
        return None;
    }
    let mut out = Combination::new();
    for (m, q) in a {
        for (n, r) in b {
            if !expr::combines(q, r) {
                return None;
            }
            add_to(&mut out, times(m, n)?, q * r);
        }
    }
    Some(out)
}

/// A power; `None` where it or a coefficient is too long, or for a power of a sum with a negative exponent.
pub(super) fn power(a: &Combination, n: i32) -> Option<Combination> {
    if n.unsigned_abs() > 64 {
        return None;
    }
    if n == 0 {
        return Some(Combination::from([(Monomial::new(), Rational::ONE)]));
    }
    if a.len() == 1
        && let Some((m, q)) = a.iter().next()
    {
        let m = to_power(m, n)?;
        return Some(Combination::from([(m, expr::raised(q, n)?)]));
    }
    if n < 0 {
        return None;
    }
    if a.is_empty() {
        return Some(Combination::new());
    }
    let mut out = Combination::from([(Vec::new(), Rational::ONE)]);
    for _ in 0..n {
        out = product(&out, a)?;
    }
    Some(out)
}

/// The same with squares of cosines written by sines, and those of hyperbolic cosines, where the sine is there: both sum up to 1, or
/// differ by it. So arguments that are equal by that are seen to be.
fn without_squares(graph: &Graph, of: Combination) -> Combination {
    let squared = |&(base, n): &(Expr, i32)| {
        let Node::Unary(op, a) = *graph.node(base) else { return None };
        let squares = [(Op::Cos, Op::Sin, Rational::NEG_ONE), (Op::Cosh, Op::Sinh, Rational::ONE)];
        let (_, sine, sign) = squares.into_iter().find(|(cosine, ..)| *cosine == op)?;
        let sine = graph.find(&Node::Unary(sine, a)).filter(|_| n >= 2)?;
        Some((base, sine, sign))
    };
    let mut out = of;
    // Each turn takes a square away from one term.
    for _ in 0..LONGEST {
        let next = out.keys().find_map(|m| m.iter().find_map(squared).map(|found| (m.clone(), found)));
        let Some((monomial, (base, sine, sign))) = next else { break };
        let rest = times(&monomial, &vec![(base, -2)]);
        let Some(rest) = rest else { break };
        let Some(turned) = times(&rest, &vec![(sine, 2)]) else { break };
        let q = out.remove(&monomial).unwrap_or(Rational::ZERO);
        add_to(&mut out, turned, &q * sign);
        add_to(&mut out, rest, q);
    }
    out
}

impl Combinations {
    /// The combination that a node stands for.
    pub(super) fn of(&mut self, graph: &Graph, e: Expr) -> Combination {
        if let Some(known) = self.known.get(&e) {
            return known.clone();
        }
        for node in graph.reachable([e]) {
            if self.known.contains_key(&node) {
                continue;
            }
            let value = self.step(graph, node).unwrap_or_else(|| single(node, 1));
            let value = without_squares(graph, value);
            self.known.insert(node, value);
        }
        self.known.get(&e).cloned().unwrap_or_else(|| single(e, 1))
    }

    /// The same without whole powers of sums, which come from under a fraction: what was divided by twice is a sum again.
    fn opened(&self, of: Option<Combination>) -> Option<Combination> {
        let of = of?;
        let is_sum = |&(base, n): &(Expr, i32)| n > 0 && self.known.get(&base).is_some_and(|c| *c != single(base, 1));
        if !of.keys().flatten().any(is_sum) {
            return Some(of);
        }
        let mut out = Combination::new();
        for (m, q) in of {
            let (sums, rest): (Monomial, Monomial) = m.into_iter().partition(is_sum);
            let mut term = Combination::from([(rest, q)]);
            for (base, n) in sums {
                term = product(&term, &power(self.known.get(&base)?, n)?)?;
            }
            for (m, q) in term {
                add_to(&mut out, m, q);
            }
        }
        Some(out)
    }

    fn step(&self, graph: &Graph, node: Expr) -> Option<Combination> {
        let known = |e: Expr| self.known.get(&e);
        Some(match *graph.node(node) {
            Node::Constant(ref r) if **r == Rational::ZERO => Combination::new(),
            Node::Constant(ref r) => Combination::from([(Vec::new(), (**r).clone())]),
            Node::Unary(Op::Neg, a) => known(a)?.iter().map(|(m, q)| (m.clone(), -q.clone())).collect(),
            Node::Unary(Op::Powi(n), a) => match self.opened(power(known(a)?, n)) {
                Some(c) => c,
                None => single(a, n),
            },
            Node::Binary(op @ (Op::Add | Op::Sub), a, b) => {
                let (a, b) = (known(a)?, known(b)?);
                if a.len() + b.len() > LONGEST {
                    return None;
                }
                let mut sum = a.clone();
                for (m, q) in b {
                    add_to(&mut sum, m.clone(), if op == Op::Add { q.clone() } else { -q.clone() });
                }
                sum
            }
            Node::Binary(Op::Mul, a, b) => product(known(a)?, known(b)?)?,
            Node::Binary(Op::Div, a, b) => {
                let under = match self.opened(power(known(b)?, -1)) {
                    Some(c) => c,
                    None => single(b, -1),
                };
                product(known(a)?, &under)?
            }
            _ => return None,
        })
    }
}

/// The expression q·m.
pub(super) fn expression(graph: &mut Graph, monomial: &Monomial, q: &Rational) -> Expr {
    let mut out = graph.constant(q.clone());
    for &(base, n) in monomial {
        let power = graph.powi(base, n);
        out = graph.mul(out, power);
    }
    out
}
