//! Exact rational functions over ℚ.
//!
//! **In:** an expression, and relations that vanish. **Out:** whether its numerator is a sum of multiples of these, by expansion and by division; or nothing, where that is too
//! large. **Guaranteed:** exact, with no choice of a random point. Everything that is no sum, product, quotient or whole power is an indeterminate; a restriction counts as its formula.
//!
//! **Division.** A relation whose numerator has a term n·vᵏ with a number n ≠ 0, and no other term of degree k or more in v, says vᵏ = R. Where vᵏ is replaced by R, a multiple of the relation is taken
//! away. So whatever the order, and whether or not the replacing ends, what becomes 0 is such a sum.

use dashu_int::ops::BitTest;
use expr::{Expr, Graph, Node, Op, Rational};
use std::collections::BTreeMap;

/// Most terms of a polynomial, and most products of terms in one expansion.
const MOST_TERMS: usize = 3_000;
const MOST_PRODUCTS: usize = 300_000;
/// Largest power that is expanded.
const LARGEST_POWER: u32 = 24;
/// Most bits of numbers that are multiplied out.
const MOST_BITS: usize = 1 << 14;

/// Indeterminates with their powers, in order.
type Monomial = Vec<(Expr, u32)>;

/// A polynomial: its terms, none of them 0.
#[derive(Clone, Debug, Default, PartialEq)]
struct Polynomial(BTreeMap<Monomial, Rational>);

/// Work that is left.
struct Budget(usize);

impl Polynomial {
    fn constant(r: Rational) -> Polynomial {
        let mut out = Polynomial::default();
        out.add_term(Monomial::new(), r);
        out
    }

    fn variable(e: Expr) -> Polynomial {
        let mut out = Polynomial::default();
        out.add_term(vec![(e, 1)], Rational::ONE);
        out
    }

    fn is_one(&self) -> bool {
        self.0.len() == 1 && self.0.get(&Monomial::new()) == Some(&Rational::ONE)
    }

    fn add_term(&mut self, monomial: Monomial, r: Rational) {
        let sum = self.0.remove(&monomial).unwrap_or(Rational::ZERO) + r;
        if sum != Rational::ZERO {
            self.0.insert(monomial, sum);
        }
    }

    fn plus(mut self, other: &Polynomial, sign: i8) -> Option<Polynomial> {
        for (monomial, r) in &other.0 {
            self.add_term(monomial.clone(), if sign < 0 { -r.clone() } else { r.clone() });
        }
        (self.0.len() <= MOST_TERMS).then_some(self)
    }

    fn times(&self, other: &Polynomial, budget: &mut Budget) -> Option<Polynomial> {
        if self.is_one() {
            return Some(other.clone());
        }
        if other.is_one() {
            return Some(self.clone());
        }
        budget.0 = budget.0.checked_sub(self.0.len() * other.0.len())?;
        let mut out = Polynomial::default();
        for (m, r) in &self.0 {
            for (n, s) in &other.0 {
                let product = r * s;
                if bits(&product).iter().sum::<usize>() > MOST_BITS {
                    return None;
                }
                out.add_term(joined(m, n)?, product);
            }
        }
        (out.0.len() <= MOST_TERMS).then_some(out)
    }
}

/// The size of a number.
pub(crate) fn bits(r: &Rational) -> [usize; 2] {
    [r.numerator().bit_len(), r.denominator().bit_len()]
}

fn joined(m: &Monomial, n: &Monomial) -> Option<Monomial> {
    let mut out: BTreeMap<Expr, u32> = m.iter().copied().collect();
    for &(e, k) in n {
        let power = out.entry(e).or_insert(0);
        *power = power.checked_add(k)?;
    }
    Some(out.into_iter().collect())
}

/// Numerator and denominator.
#[derive(Clone)]
struct Fraction(Polynomial, Polynomial);

/// A relation, solved for a power of an indeterminate: vᵏ = R.
pub(crate) struct Rewrite {
    v: Expr,
    degree: u32,
    rest: Polynomial,
}

impl Rewrite {
    /// The relation `difference` = 0 as one; nothing if it does not begin with a number times a power of v.
    pub(crate) fn of(graph: &Graph, difference: Expr, v: Expr) -> Option<Rewrite> {
        let Fraction(top, _) = fraction(graph, difference, &[])?;
        let power = |m: &Monomial| m.iter().find(|(e, _)| *e == v).map_or(0, |(_, k)| *k);
        let degree = top.0.keys().map(power).max().filter(|k| *k > 0)?;
        let lead = top.0.get(&vec![(v, degree)])?.clone();
        let others = top.0.iter().filter(|(m, _)| **m != vec![(v, degree)]);
        let mut rest = Polynomial::default();
        for (monomial, r) in others {
            if power(monomial) >= degree {
                return None;
            }
            rest.add_term(monomial.clone(), -r.clone() / lead.clone());
        }
        Some(Rewrite { v, degree, rest })
    }

    /// u, if the relation says v² = u and v does not stand in u.
    pub(crate) fn square(&self, graph: &mut Graph) -> Option<Expr> {
        if self.degree != 2 || self.rest.0.keys().any(|m| m.iter().any(|(e, _)| *e == self.v)) {
            return None;
        }
        let mut sum = graph.integer(0);
        for (monomial, r) in &self.rest.0 {
            let mut term = graph.constant(r.clone());
            for &(e, k) in monomial {
                let power = graph.powi(e, i32::try_from(k).ok()?);
                term = graph.mul(term, power);
            }
            sum = graph.add(sum, term);
        }
        Some(sum)
    }

    /// The indeterminate.
    pub(crate) fn v(&self) -> Expr {
        self.v
    }
}

/// A polynomial with powers replaced, as far as there are any.
fn reduced(mut p: Polynomial, rewrites: &[Rewrite], budget: &mut Budget) -> Option<Polynomial> {
    for rewrite in rewrites.iter().rev() {
        loop {
            let power = |m: &Monomial| m.iter().find(|(e, _)| *e == rewrite.v).map_or(0, |(_, k)| *k);
            let high: Vec<Monomial> = p.0.keys().filter(|m| power(m) >= rewrite.degree).cloned().collect();
            if high.is_empty() {
                break;
            }
            for monomial in high {
                let Some(r) = p.0.remove(&monomial) else { continue };
                let lower = monomial.iter().filter_map(|&(e, k)| {
                    let k = if e == rewrite.v { k - rewrite.degree } else { k };
                    (k > 0).then_some((e, k))
                });
                let mut factor = Polynomial::default();
                factor.add_term(lower.collect(), r);
                p = p.plus(&factor.times(&rewrite.rest, budget)?, 1)?;
            }
        }
    }
    Some(p)
}

fn sum(a: &Fraction, b: &Fraction, sign: i8, budget: &mut Budget) -> Option<Fraction> {
    if a.1 == b.1 {
        return Some(Fraction(a.0.clone().plus(&b.0, sign)?, a.1.clone()));
    }
    let (left, right) = (a.0.times(&b.1, budget)?, b.0.times(&a.1, budget)?);
    Some(Fraction(left.plus(&right, sign)?, a.1.times(&b.1, budget)?))
}

fn product(a: &Fraction, b: &Fraction, budget: &mut Budget) -> Option<Fraction> {
    Some(Fraction(a.0.times(&b.0, budget)?, a.1.times(&b.1, budget)?))
}

/// 1/f; nothing for 0.
fn inverse(a: &Fraction) -> Option<Fraction> {
    (!a.0.0.is_empty()).then(|| Fraction(a.1.clone(), a.0.clone()))
}

fn fraction(graph: &Graph, e: Expr, rewrites: &[Rewrite]) -> Option<Fraction> {
    let one = Polynomial::constant(Rational::ONE);
    let whole = |p: Polynomial| Fraction(p, one.clone());
    let mut budget = Budget(MOST_PRODUCTS);
    let mut found: BTreeMap<Expr, Fraction> = BTreeMap::new();
    for node in graph.reachable([e]) {
        let made = match graph.node(node) {
            Node::Constant(r) => whole(Polynomial::constant((**r).clone())),
            Node::Unary(Op::Neg, a) => {
                let Fraction(top, under) = &found[a];
                Fraction(Polynomial::default().plus(top, -1)?, under.clone())
            }
            Node::Unary(Op::Powi(n), a) => {
                let base = if *n < 0 { inverse(&found[a])? } else { found[a].clone() };
                if n.unsigned_abs() > LARGEST_POWER {
                    return None;
                }
                let mut out = whole(one.clone());
                for _ in 0..n.unsigned_abs() {
                    out = product(&out, &base, &mut budget)?;
                }
                out
            }
            Node::Binary(Op::Add, a, b) => sum(&found[a], &found[b], 1, &mut budget)?,
            Node::Binary(Op::Sub, a, b) => sum(&found[a], &found[b], -1, &mut budget)?,
            Node::Binary(Op::Mul, a, b) => product(&found[a], &found[b], &mut budget)?,
            Node::Binary(Op::Div, a, b) => product(&found[a], &inverse(&found[b])?, &mut budget)?,
            Node::Binary(Op::Restrict, a, _) => found[a].clone(),
            Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => whole(Polynomial::variable(node)),
        };
        let Fraction(top, under) = made;
        let made = match rewrites {
            [] => Fraction(top, under),
            _ => Fraction(reduced(top, rewrites, &mut budget)?, reduced(under, rewrites, &mut budget)?),
        };
        found.insert(node, made);
    }
    found.remove(&e)
}

/// Whether the expression is 0 as a rational function; nothing where it is too large to expand, or divides by what is 0.
pub(crate) fn vanishes(graph: &Graph, e: Expr) -> Option<bool> {
    vanishes_modulo(graph, e, &[])
}

/// Whether the numerator of the expression is a sum of multiples of relations, as far as dividing shows it.
pub(crate) fn vanishes_modulo(graph: &Graph, e: Expr, rewrites: &[Rewrite]) -> Option<bool> {
    fraction(graph, e, rewrites).map(|Fraction(top, _)| top.0.is_empty())
}
