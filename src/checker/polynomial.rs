//! Exact rational functions over ℚ.
//!
//! **In:** an expression, and relations that vanish. **Out:** whether its numerator is a sum of multiples of these, by expansion and by division; or nothing, where that is too
//! large. **Guaranteed:** exact, with no choice of a random point. Everything that is no sum, product, quotient or whole power is an indeterminate; a restriction counts as its formula.
//!
//! **Division.** A relation whose numerator is n·m − …, with a monomial m and a number n ≠ 0, says what m is. Where a multiple of m is replaced by that, a multiple of the relation is taken
//! away. So whatever the order, and whether or not the replacing ends, what becomes 0 is such a sum; and each formula keeps its value where the relations are true.

use dashu_int::ops::BitTest;
use expr::{Expr, Graph, Node, Op, Rational};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// Most terms of a polynomial, and most products of terms in one expansion.
const MOST_TERMS: usize = 3_000;
const MOST_PRODUCTS: usize = 300_000;
/// The same where relations are divided by.
const MOST_DIVISIONS: usize = 60_000;
/// The same for a relation that is divided by.
const MOST_OF_A_RELATION: usize = 6_000;
/// Largest power that is expanded.
const LARGEST_POWER: u32 = 24;
/// Most bits of numbers that are multiplied out.
const MOST_BITS: usize = 1 << 14;

/// Units of work of a term, and of a pair of words of its number.
const WORK_OF_A_TERM: u64 = 100;
const WORK_OF_WORDS: u64 = 4;

/// Indeterminates with their powers, in order.
type Monomial = Vec<(Expr, u32)>;

/// A polynomial: its terms, none of them 0.
#[derive(Clone, Debug, Default, PartialEq)]
struct Polynomial(BTreeMap<Monomial, Rational>);

/// Work that is left.
struct Budget(usize);

impl Polynomial {
    fn constant(r: Rational) -> Polynomial {
        if r == Rational::ZERO { Polynomial::default() } else { Polynomial(BTreeMap::from([(Monomial::new(), r)])) }
    }

    fn variable(e: Expr) -> Polynomial {
        Polynomial(BTreeMap::from([(vec![(e, 1)], Rational::ONE)]))
    }

    fn is_one(&self) -> bool {
        self.0.len() == 1 && self.0.get(&Monomial::new()) == Some(&Rational::ONE)
    }

    /// Adds a term; nothing, where its number becomes too long: of fractions the denominators grow with each.
    fn add_term(&mut self, monomial: Monomial, r: Rational) -> Option<()> {
        if r == Rational::ZERO {
            return Some(());
        }
        match self.0.entry(monomial) {
            Entry::Vacant(free) => _ = free.insert(r),
            Entry::Occupied(mut held) => {
                *held.get_mut() += r;
                if *held.get() == Rational::ZERO {
                    held.remove();
                } else {
                    counted(held.get())?;
                }
            }
        }
        Some(())
    }

    fn plus(mut self, other: &Polynomial, sign: i8) -> Option<Polynomial> {
        for (monomial, r) in &other.0 {
            self.add_term(monomial.clone(), if sign < 0 { -r.clone() } else { r.clone() })?;
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
                counted(&product)?;
                out.add_term(joined(m, n)?, product)?;
            }
        }
        (out.0.len() <= MOST_TERMS).then_some(out)
    }
}

/// The size of a number.
pub(crate) fn bits(r: &Rational) -> [usize; 2] {
    [r.numerator().bit_len(), r.denominator().bit_len()]
}

/// Counts the work of finding a number; nothing, where that is too long.
fn counted(r: &Rational) -> Option<()> {
    let bits: usize = bits(r).iter().sum();
    let words = bits as u64 / 64;
    // A number without common factors takes the square of its length.
    meter::charge(WORK_OF_A_TERM + words * words * WORK_OF_WORDS);
    (bits <= MOST_BITS).then_some(())
}

/// The product of two monomials.
fn joined(m: &Monomial, n: &Monomial) -> Option<Monomial> {
    let (mut i, mut j, mut out) = (0, 0, Monomial::with_capacity(m.len() + n.len()));
    while let (Some(&(a, k)), Some(&(b, l))) = (m.get(i), n.get(j)) {
        match a.cmp(&b) {
            Ordering::Less => {
                out.push((a, k));
                i += 1;
            }
            Ordering::Greater => {
                out.push((b, l));
                j += 1;
            }
            Ordering::Equal => {
                out.push((a, k.checked_add(l)?));
                (i, j) = (i + 1, j + 1);
            }
        }
    }
    out.extend_from_slice(&m[i..]);
    out.extend_from_slice(&n[j..]);
    Some(out)
}

/// Numerator and denominator.
#[derive(Clone)]
struct Fraction(Polynomial, Polynomial);

/// A relation that vanishes, solved for its first monomial.
pub(crate) struct Rewrite {
    lead: Monomial,
    rest: Polynomial,
}

/// Factors with their powers.
type Factors = Vec<(Expr, u32)>;

/// The order of monomials: by values of functions, the last made first; then by degree; then by the others.
fn rank(graph: &Graph, monomial: &Monomial) -> (Factors, u32, Factors) {
    let is_function = |e: Expr| !matches!(graph.node(e), Node::Leaf(_) | Node::Pi);
    let turned = |functions: bool| monomial.iter().rev().copied().filter(move |(e, _)| is_function(*e) == functions);
    (turned(true).collect(), monomial.iter().map(|(_, k)| *k).sum(), turned(false).collect())
}

impl Rewrite {
    /// The numerator of `difference`, which vanishes, as one; nothing if it is too large, a number or 0.
    pub(crate) fn of(graph: &Graph, difference: Expr) -> Option<Rewrite> {
        let Fraction(mut top, _) = fraction(graph, difference, &[], &mut Budget(MOST_OF_A_RELATION))?;
        let lead = top.0.keys().max_by_key(|monomial| rank(graph, monomial))?.clone();
        let number = top.0.remove(&lead)?;
        let mut rest = Polynomial::default();
        for (monomial, r) in top.0 {
            rest.add_term(monomial, -r / number.clone())?;
        }
        (!lead.is_empty()).then_some(Rewrite { lead, rest })
    }

    /// v and u, if the relation says v² = u and v does not stand in u.
    pub(crate) fn square(&self, graph: &mut Graph) -> Option<(Expr, Expr)> {
        let [(v, 2)] = self.lead[..] else { return None };
        if self.rest.0.keys().any(|m| m.iter().any(|(e, _)| *e == v)) {
            return None;
        }
        Some((v, self.rest.written(graph)?))
    }
}

impl Polynomial {
    fn written(&self, graph: &mut Graph) -> Option<Expr> {
        let mut sum = graph.integer(0);
        for (monomial, r) in &self.0 {
            let mut term = graph.constant(r.clone());
            for &(e, k) in monomial {
                let power = graph.powi(e, i32::try_from(k).ok()?);
                term = graph.mul(term, power);
            }
            sum = graph.add(sum, term);
        }
        Some(sum)
    }
}

/// m/n, if n divides m.
fn divided(m: &Monomial, n: &Monomial) -> Option<Monomial> {
    let mut out = m.clone();
    for (e, k) in n {
        let (_, power) = out.iter_mut().find(|(other, _)| other == e)?;
        *power = power.checked_sub(*k)?;
    }
    out.retain(|(_, k)| *k > 0);
    Some(out)
}

/// A polynomial without multiples of relations, as far as dividing takes them away.
fn reduced(mut p: Polynomial, rewrites: &[Rewrite], budget: &mut Budget) -> Option<Polynomial> {
    let mut out = Polynomial::default();
    while let Some((monomial, r)) = p.0.pop_last() {
        let found = rewrites.iter().find_map(|rewrite| Some((divided(&monomial, &rewrite.lead)?, rewrite)));
        let Some((factor, rewrite)) = found else {
            out.add_term(monomial, r)?;
            continue;
        };
        budget.0 = budget.0.checked_sub(1 + rewrite.rest.0.len())?;
        for (m, s) in &rewrite.rest.0 {
            let product = &r * s;
            counted(&product).filter(|()| p.0.len() <= MOST_TERMS)?;
            p.add_term(joined(m, &factor)?, product)?;
        }
    }
    Some(out)
}

fn sum(a: Fraction, b: &Fraction, sign: i8, budget: &mut Budget) -> Option<Fraction> {
    if a.1 == b.1 {
        return Some(Fraction(a.0.plus(&b.0, sign)?, a.1));
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

fn fraction(graph: &Graph, e: Expr, rewrites: &[Rewrite], budget: &mut Budget) -> Option<Fraction> {
    let one = Polynomial::constant(Rational::ONE);
    let whole = |p: Polynomial| Fraction(p, one.clone());
    let mut found: BTreeMap<Expr, Fraction> = BTreeMap::new();
    let order = graph.reachable([e]);
    let mut uses: BTreeMap<Expr, usize> = BTreeMap::new();
    order.iter().flat_map(|node| graph.node(*node).children()).for_each(|part| *uses.entry(part).or_default() += 1);
    // What nobody else asks for is not copied: a long sum would be at each of its signs.
    let take = |found: &mut BTreeMap<Expr, Fraction>, part: &Expr| match uses[part] {
        1 => found.remove(part),
        _ => found.get(part).cloned(),
    };
    for node in order {
        let made = match graph.node(node) {
            Node::Constant(r) => whole(Polynomial::constant((**r).clone())),
            Node::Unary(Op::Neg, a) => {
                let Fraction(top, under) = take(&mut found, a)?;
                Fraction(Polynomial::default().plus(&top, -1)?, under)
            }
            Node::Unary(Op::Powi(n), a) => {
                let base = if *n < 0 { inverse(&found[a])? } else { found[a].clone() };
                if n.unsigned_abs() > LARGEST_POWER {
                    return None;
                }
                let mut out = whole(one.clone());
                for _ in 0..n.unsigned_abs() {
                    out = product(&out, &base, budget)?;
                }
                out
            }
            Node::Binary(Op::Add, a, b) => sum(take(&mut found, a)?, &found[b], 1, budget)?,
            Node::Binary(Op::Sub, a, b) => sum(take(&mut found, a)?, &found[b], -1, budget)?,
            Node::Binary(Op::Mul, a, b) => product(&found[a], &found[b], budget)?,
            Node::Binary(Op::Div, a, b) => product(&found[a], &inverse(&found[b])?, budget)?,
            Node::Binary(Op::Restrict, a, _) => take(&mut found, a)?,
            Node::Pi | Node::Leaf(_) | Node::Unary(..) | Node::Binary(..) => whole(Polynomial::variable(node)),
        };
        let Fraction(top, under) = made;
        let made = match rewrites {
            [] => Fraction(top, under),
            _ => Fraction(reduced(top, rewrites, budget)?, reduced(under, rewrites, budget)?),
        };
        found.insert(node, made);
    }
    found.remove(&e)
}

/// Whether the expression is 0 as a rational function; nothing where it is too large to expand, or divides by what is 0.
pub(crate) fn vanishes(graph: &Graph, e: Expr) -> Option<bool> {
    vanishes_modulo(graph, e, &[]).0
}

/// Whether the numerator of the expression is a sum of multiples of relations, as far as dividing shows it; and how many products of terms that took.
pub(crate) fn vanishes_modulo(graph: &Graph, e: Expr, rewrites: &[Rewrite]) -> (Option<bool>, usize) {
    let most = if rewrites.is_empty() { MOST_PRODUCTS } else { MOST_DIVISIONS };
    let mut budget = Budget(most);
    let found = fraction(graph, e, rewrites, &mut budget).map(|Fraction(top, _)| top.0.is_empty());
    // What is too large took all of it.
    let spent = if found.is_none() { most } else { most - budget.0 };
    (found, spent)
}

/// An expression, expanded and divided by relations: numerator by denominator; nothing where it is too large.
pub(crate) fn normal_form(graph: &mut Graph, e: Expr, rewrites: &[Rewrite]) -> Option<Expr> {
    let Fraction(top, under) = fraction(graph, e, rewrites, &mut Budget(MOST_DIVISIONS))?;
    let (top, under) = (top.written(graph)?, under.written(graph)?);
    Some(graph.div(top, under))
}
