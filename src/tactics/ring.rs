//! Polynomials over ℚ, for the search of multiples of facts.
//!
//! **In:** expressions without quotients outside of functions. **Out:** [`Polynomial`]s in the order by which the checker divides: by values of functions, then by degree, then by the
//! others. **Why its own:** nothing here is believed; what is found is written as steps, which the checker expands by itself.

use expr::{Expr, Graph, Node, Op, Rational};
use std::collections::BTreeMap;

/// Most indeterminates.
pub(crate) const MOST_VARIABLES: usize = 55;
/// Most terms of a polynomial.
const MOST_TERMS: usize = 12_000;
/// Largest degree.
const LARGEST_DEGREE: u8 = 60;

/// Powers of indeterminates: those of functions, the degree, those of others. So the order of bytes is the order of monomials.
pub(crate) type Monomial = [u8; MOST_VARIABLES + 1];

/// Terms by their monomials, none of them 0.
pub(crate) type Polynomial = BTreeMap<Monomial, Rational>;

/// The indeterminates of polynomials.
pub(crate) struct Ring {
    /// Indeterminates, and where their powers stand.
    places: BTreeMap<Expr, usize>,
    degree: usize,
}

/// How an expression is made of others, as polynomials are.
enum Made {
    Number(Rational),
    Negative(Expr),
    Power(Expr, i32),
    Sum(Expr, Expr),
    Difference(Expr, Expr),
    Product(Expr, Expr),
    Same(Expr),
    Indeterminate,
}

fn made(graph: &Graph, e: Expr) -> Made {
    let node = graph.node(e);
    if let Node::Constant(r) = node {
        return Made::Number((**r).clone());
    }
    if let Node::Unary(Op::Neg, a) = *node {
        return Made::Negative(a);
    }
    if let Node::Unary(Op::Powi(n), a) = *node
        && n > 0
    {
        return Made::Power(a, n);
    }
    if let Node::Binary(Op::Add, a, b) = *node {
        return Made::Sum(a, b);
    }
    if let Node::Binary(Op::Sub, a, b) = *node {
        return Made::Difference(a, b);
    }
    if let Node::Binary(Op::Mul, a, b) = *node {
        return Made::Product(a, b);
    }
    if let Node::Binary(Op::Restrict, a, _) = *node {
        return Made::Same(a);
    }
    Made::Indeterminate
}

/// What counts as an indeterminate below an expression.
fn indeterminates(graph: &Graph, e: Expr, out: &mut Vec<Expr>) {
    let mut open = vec![e];
    let mut seen = std::collections::BTreeSet::new();
    while let Some(e) = open.pop() {
        if !seen.insert(e) {
            continue;
        }
        match made(graph, e) {
            Made::Number(_) => {}
            Made::Negative(a) | Made::Power(a, _) | Made::Same(a) => open.push(a),
            Made::Sum(a, b) | Made::Difference(a, b) | Made::Product(a, b) => open.extend([a, b]),
            Made::Indeterminate => out.push(e),
        }
    }
}

/// Whether each power of the first is at most that of the second.
pub(crate) fn divides(m: &Monomial, n: &Monomial) -> bool {
    m.iter().zip(n).all(|(a, b)| a <= b)
}

/// n/m, where m divides n.
pub(crate) fn ratio(n: &Monomial, m: &Monomial) -> Monomial {
    std::array::from_fn(|i| n[i] - m[i])
}

impl Ring {
    /// The ring of all indeterminates below expressions; nothing where they are too many.
    pub(crate) fn of(graph: &Graph, roots: &[Expr]) -> Option<Ring> {
        let mut all = Vec::new();
        for &root in roots {
            indeterminates(graph, root, &mut all);
        }
        let is_function = |e: &Expr| !matches!(graph.node(*e), Node::Leaf(_) | Node::Pi);
        let (mut functions, mut others): (Vec<Expr>, Vec<Expr>) = all.into_iter().partition(is_function);
        for list in [&mut functions, &mut others] {
            list.sort_unstable_by(|a, b| b.cmp(a));
            list.dedup();
        }
        if functions.len() + others.len() > MOST_VARIABLES {
            return None;
        }
        let degree = functions.len();
        let mut places: BTreeMap<Expr, usize> = functions.into_iter().zip(0..).collect();
        places.extend(others.into_iter().zip(degree + 1..));
        Some(Ring { places, degree })
    }

    /// The degree of a monomial.
    pub(crate) fn degree(&self, m: &Monomial) -> u8 {
        m[self.degree]
    }

    /// Whether two monomials have no indeterminate in common.
    pub(crate) fn coprime(&self, m: &Monomial, n: &Monomial) -> bool {
        (0..m.len()).all(|i| i == self.degree || m[i] == 0 || n[i] == 0)
    }

    /// The least common multiple.
    pub(crate) fn multiple(&self, m: &Monomial, n: &Monomial) -> Monomial {
        let mut out: Monomial = std::array::from_fn(|i| m[i].max(n[i]));
        out[self.degree] = 0;
        let sum: u32 = out.iter().map(|k| u32::from(*k)).sum();
        out[self.degree] = u8::try_from(sum).unwrap_or(u8::MAX);
        out
    }

    /// m·n; nothing where the degree grows too large.
    pub(crate) fn product(&self, m: &Monomial, n: &Monomial) -> Option<Monomial> {
        (m[self.degree].saturating_add(n[self.degree]) <= LARGEST_DEGREE).then(|| std::array::from_fn(|i| m[i] + n[i]))
    }

    /// a·b; nothing where that is too large.
    pub(crate) fn times(&self, a: &Polynomial, b: &Polynomial, work: &mut usize) -> Option<Polynomial> {
        *work = work.checked_sub(a.len() * b.len())?;
        let mut out = Polynomial::new();
        for (m, r) in a {
            for (n, s) in b {
                add(&mut out, self.product(m, n)?, r * s);
            }
        }
        (out.len() <= MOST_TERMS).then_some(out)
    }

    /// p/d, where d divides p; nothing where it does not, or that is too large.
    pub(crate) fn quotient(&self, mut p: Polynomial, d: &Polynomial, work: &mut usize) -> Option<Polynomial> {
        let (lead, over) = d.last_key_value()?;
        let mut out = Polynomial::new();
        while let Some((m, r)) = p.last_key_value().map(|(m, r)| (*m, r.clone())) {
            *work = work.checked_sub(d.len())?;
            if !divides(lead, &m) {
                return None;
            }
            let (factor, r) = (ratio(&m, lead), r / over);
            for (n, s) in d {
                add(&mut p, self.product(n, &factor)?, -(s * &r));
            }
            out.insert(factor, r);
        }
        Some(out)
    }

    /// An expression as a polynomial; nothing where it is none in these indeterminates, or too large.
    pub(crate) fn read(&self, graph: &Graph, e: Expr, work: &mut usize) -> Option<Polynomial> {
        let mut image: BTreeMap<Expr, Polynomial> = BTreeMap::new();
        for node in graph.reachable([e]) {
            let read = match made(graph, node) {
                Made::Number(r) => constant(r),
                Made::Negative(a) => image.get(&a).map(|p| p.iter().map(|(m, r)| (*m, -r.clone())).collect()),
                Made::Power(a, n) => match image.get(&a) {
                    Some(base) => Some(self.power(base, n, work)?),
                    None => None,
                },
                Made::Sum(a, b) => self.sum(image.get(&a), image.get(&b), 1, work)?,
                Made::Difference(a, b) => self.sum(image.get(&a), image.get(&b), -1, work)?,
                Made::Product(a, b) => match (image.get(&a), image.get(&b)) {
                    (Some(a), Some(b)) => Some(self.times(a, b, work)?),
                    _ => None,
                },
                Made::Same(a) => image.get(&a).cloned(),
                Made::Indeterminate => self.places.get(&node).map(|&place| self.variable(place)),
            };
            if let Some(read) = read {
                image.insert(node, read);
            }
        }
        image.remove(&e)
    }

    /// The product of all powers that each term has.
    pub(crate) fn content(&self, p: &Polynomial) -> Option<Monomial> {
        let all = p.keys().copied().reduce(|m, n| std::array::from_fn(|i| m[i].min(n[i])))?;
        Some(self.multiple(&all, &all))
    }

    /// The places of the indeterminates in monomials.
    pub(crate) fn places(&self) -> Vec<usize> {
        self.places.values().copied().collect()
    }

    /// An indeterminate.
    pub(crate) fn variable(&self, place: usize) -> Polynomial {
        let mut m = [0; MOST_VARIABLES + 1];
        m[place] = 1;
        m[self.degree] = 1;
        Polynomial::from([(m, Rational::ONE)])
    }

    fn power(&self, base: &Polynomial, n: i32, work: &mut usize) -> Option<Polynomial> {
        if n > i32::from(LARGEST_DEGREE) {
            return None;
        }
        let mut out = base.clone();
        for _ in 1..n {
            out = self.times(&out, base, work)?;
        }
        Some(out)
    }

    /// a ± b, of those that are polynomials; nothing where that is too large.
    fn sum(
        &self,
        a: Option<&Polynomial>,
        b: Option<&Polynomial>,
        sign: i8,
        work: &mut usize,
    ) -> Option<Option<Polynomial>> {
        let (Some(a), Some(b)) = (a, b) else { return Some(None) };
        *work = work.checked_sub(b.len())?;
        let mut out = a.clone();
        for (m, r) in b {
            add(&mut out, *m, if sign < 0 { -r.clone() } else { r.clone() });
        }
        Some(Some(out))
    }

    /// A polynomial as an expression.
    pub(crate) fn write(&self, graph: &mut Graph, terms: &[(Monomial, Rational)]) -> Expr {
        let mut sum = graph.integer(0);
        for (m, r) in terms {
            let mut term = graph.constant(r.clone());
            for (&e, &place) in &self.places {
                if m[place] > 0 {
                    let power = graph.powi(e, i32::from(m[place]));
                    term = graph.mul(term, power);
                }
            }
            sum = graph.add(sum, term);
        }
        sum
    }
}

fn constant(r: Rational) -> Option<Polynomial> {
    let one = [0; MOST_VARIABLES + 1];
    Some(if r == Rational::ZERO { Polynomial::new() } else { Polynomial::from([(one, r)]) })
}

/// Adds a term.
pub(crate) fn add(p: &mut Polynomial, m: Monomial, r: Rational) {
    use std::collections::btree_map::Entry;
    match p.entry(m) {
        Entry::Vacant(free) => {
            if r != Rational::ZERO {
                free.insert(r);
            }
        }
        Entry::Occupied(mut held) => {
            let sum = held.get() + r;
            if sum == Rational::ZERO {
                held.remove();
            } else {
                held.insert(sum);
            }
        }
    }
}
