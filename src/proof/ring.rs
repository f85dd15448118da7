//! A ring of polynomials, the relations in it, and what expressions are in it.
//!
//! **In:** expressions after lowering, and as the formulas have them. **Out:** polynomials, and quotients of two, with exact rational
//! coefficients. **Guaranteed:** nothing is cancelled and nothing is dropped: a quotient is the one that the reader of a certificate
//! gets who computes it as it is written. What would be too large is refused ([`NoCertificate::TooLarge`]).

use super::budget::Coefficient;
use super::certificate::{NoCertificate, Origin};
use super::prepare::Explicit;
use ::groebner::{LiftBasis, Monomial, MonomialOrder, Polynomial};
use expr::{Expr, FastMap, Graph, Node, Op, Rational};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use std::rc::Rc;

/// A polynomial whose work is counted.
pub(super) type Poly = Polynomial<Coefficient>;

/// The problem before it was lowered, for the text of a certificate.
#[derive(Clone, Copy)]
pub(super) struct Given<'a> {
    pub(super) equations: &'a [(Expr, Expr)],
    pub(super) solved: &'a Explicit,
    /// Functions of the formulas, and what each is lowered to.
    pub(super) images: &'a FastMap<Expr, Expr>,
}

/// Why a relation holds.
pub(super) enum Source {
    /// It is this one of the premises, definitions inserted.
    Premise(usize),
    /// It is what a variable stands for.
    Variable(Origin),
}

/// A relation between the variables.
pub(super) struct Relation {
    pub(super) polynomial: Poly,
    pub(super) source: Source,
    /// What is equal.
    pub(super) sides: (Expr, Expr),
}

/// (N, D): what the reader's program makes of a text, see [`notation`](super::notation).
pub(super) type Quotient = Rc<(Poly, Poly)>;

/// An expression, and whether it is of the problem after lowering.
pub(super) type Place = (Expr, bool);

/// A ring and the relations in it.
pub(super) struct System {
    pub(super) variables: Vec<Expr>,
    pub(super) place: FastMap<Expr, usize>,
    pub(super) relations: Vec<Relation>,
    pub(super) basis: Option<LiftBasis<Coefficient>>,
    /// What expressions are as quotients of polynomials.
    pub(super) quotients: FastMap<Place, Quotient>,
    /// Nothing is given but c² + s² = 1.
    pub(super) only_circles: bool,
}

/// The highest degree of a polynomial: that of a product of two is counted before they are multiplied.
const MOST_DEGREE: u32 = 1 << 16;

fn degree(p: &Poly) -> u32 {
    p.terms.iter().map(|(m, _)| m.degree()).max().unwrap_or(0)
}

/// The operation on quotients: over a common denominator where there is one, and nothing is cancelled.
pub(super) fn combined(op: Op, a: &(Poly, Poly), b: &(Poly, Poly), most: usize) -> Result<(Poly, Poly), NoCertificate> {
    let times = |p: &Poly, q: &Poly| {
        let small = p.terms.len().saturating_mul(q.terms.len()) <= 8 * most && degree(p) + degree(q) <= MOST_DEGREE;
        let product = if small { p * q } else { return Err(NoCertificate::TooLarge) };
        if product.terms.len() <= most { Ok(product) } else { Err(NoCertificate::TooLarge) }
    };
    Ok(match op {
        Op::Mul => (times(&a.0, &b.0)?, times(&a.1, &b.1)?),
        Op::Div => (times(&a.0, &b.1)?, times(&a.1, &b.0)?),
        Op::Add if a.1.terms == b.1.terms => (&a.0 + &b.0, a.1.clone()),
        Op::Sub if a.1.terms == b.1.terms => (&a.0 - &b.0, a.1.clone()),
        Op::Add => (&times(&a.0, &b.1)? + &times(&b.0, &a.1)?, times(&a.1, &b.1)?),
        Op::Sub => (&times(&a.0, &b.1)? - &times(&b.0, &a.1)?, times(&a.1, &b.1)?),
        _ => return Err(NoCertificate::TooLarge),
    })
}

impl System {
    /// What an expression is as a quotient: what the reader's program makes of its text.
    pub(super) fn quotient(
        &mut self,
        graph: &Graph,
        origin: Given<'_>,
        place: Place,
        most: usize,
    ) -> Result<Quotient, NoCertificate> {
        let one = self.constant(&Rational::ONE);
        let mut stack = vec![place];
        while let Some(&at) = stack.last() {
            if self.quotients.contains_key(&at) {
                stack.pop();
                continue;
            }
            let (e, lowered) = at;
            let node = graph.node(e);
            let image = origin.images.get(&e).copied().filter(|_| !lowered).map(|image| (image, true));
            let waits: Vec<Place> = match (image, node) {
                (Some(image), _) => vec![image],
                (None, _) if self.place.contains_key(&e) => Vec::new(),
                (None, Node::Leaf(leaf)) => match origin.solved.definitions.get(leaf) {
                    Some(&value) if !lowered => vec![(value, false)],
                    _ => return Err(NoCertificate::TooLarge),
                },
                (None, node) => node.children().map(|c| (c, lowered)).collect(),
            };
            let open: Vec<Place> = waits.iter().copied().filter(|w| !self.quotients.contains_key(w)).collect();
            if !open.is_empty() {
                stack.extend(open);
                continue;
            }
            let value = match (waits.as_slice(), node) {
                ([one], _) if image.is_some() || matches!(node, Node::Leaf(_)) => Rc::clone(&self.quotients[one]),
                _ if self.place.contains_key(&e) => {
                    let p = Poly::monomial(Monomial::var(self.place[&e], self.variables.len()), MonomialOrder::GRevLex);
                    Rc::new((p, one.clone()))
                }
                (_, Node::Constant(r)) => {
                    let (top, under) = Rational::clone(r).into_parts();
                    Rc::new((self.constant(&Rational::from(top)), self.constant(&Rational::from(under))))
                }
                ([a], Node::Unary(Op::Neg, _)) => {
                    let a = &self.quotients[a];
                    Rc::new((&self.constant(&Rational::ZERO) - &a.0, a.1.clone()))
                }
                ([a], Node::Unary(Op::Powi(k), _)) if k.unsigned_abs() <= 64 => {
                    let a = Rc::clone(&self.quotients[a]);
                    let a = if *k < 0 { (a.1.clone(), a.0.clone()) } else { (a.0.clone(), a.1.clone()) };
                    let mut out = (one.clone(), one.clone());
                    for _ in 0..k.unsigned_abs() {
                        out = combined(Op::Mul, &out, &a, most)?;
                    }
                    Rc::new(out)
                }
                ([a, b], Node::Binary(op, ..)) => Rc::new(combined(*op, &self.quotients[a], &self.quotients[b], most)?),
                _ => return Err(NoCertificate::TooLarge),
            };
            if value.0.terms.len().max(value.1.terms.len()) > most {
                return Err(NoCertificate::TooLarge);
            }
            self.quotients.insert(at, value);
        }
        self.quotients.get(&place).cloned().ok_or(NoCertificate::TooLarge)
    }

    pub(super) fn constant(&self, r: &Rational) -> Poly {
        Poly::constant(Coefficient::from(big(r)), self.variables.len(), MonomialOrder::GRevLex)
    }

    pub(super) fn expand(&self, graph: &Graph, e: Expr, most_terms: usize) -> Result<Poly, NoCertificate> {
        let mut known: FastMap<Expr, Poly> = FastMap::default();
        let n = self.variables.len();
        let mut stack = vec![e];
        while let Some(&node) = stack.last() {
            if known.contains_key(&node) {
                stack.pop();
                continue;
            }
            if let Some(&i) = self.place.get(&node) {
                let p = Poly::monomial(Monomial::var(i, n), MonomialOrder::GRevLex);
                known.insert(node, p);
                continue;
            }
            let waiting: Vec<Expr> = graph.node(node).children().filter(|c| !known.contains_key(c)).collect();
            if !waiting.is_empty() {
                stack.extend(waiting);
                continue;
            }
            let small = |p: &Poly, q: &Poly| {
                if p.terms.len().saturating_mul(q.terms.len()) <= 8 * most_terms {
                    Ok(p * q)
                } else {
                    Err(NoCertificate::TooLarge)
                }
            };
            let value = match *graph.node(node) {
                Node::Constant(ref r) => self.constant(r),
                Node::Unary(Op::Neg, a) => &Poly::zero(n, MonomialOrder::GRevLex) - &known[&a],
                Node::Unary(Op::Powi(k), a) if (0..=64).contains(&k) => {
                    let mut out = self.constant(&Rational::ONE);
                    for _ in 0..k {
                        out = small(&out, &known[&a])?;
                    }
                    out
                }
                Node::Binary(Op::Add, a, b) => &known[&a] + &known[&b],
                Node::Binary(Op::Sub, a, b) => &known[&a] - &known[&b],
                Node::Binary(Op::Mul, a, b) => small(&known[&a], &known[&b])?,
                _ => return Err(NoCertificate::TooLarge),
            };
            if value.terms.len() > most_terms {
                return Err(NoCertificate::TooLarge);
            }
            known.insert(node, value);
        }
        known.remove(&e).ok_or(NoCertificate::TooLarge)
    }
}

/// Whether the leading terms are pairwise coprime: then the relations are a Gröbner basis (Buchberger's first criterion).
pub(super) fn is_basis(relations: &[Poly]) -> bool {
    relations.iter().enumerate().all(|(i, p)| {
        relations[..i].iter().all(|q| match (p.lm(), q.lm()) {
            (Some(a), Some(b)) => a.is_coprime(b),
            _ => true,
        })
    })
}

fn big(r: &Rational) -> BigRational {
    if let Ok(n) = i64::try_from(r.clone()) {
        return BigRational::from_integer(BigInt::from(n));
    }
    let integer = |text: String| text.parse::<BigInt>().unwrap_or_default();
    BigRational::new(integer(r.numerator().to_string()), integer(r.denominator().to_string()))
}

pub(super) fn map(p: &Poly, f: impl Fn(&BigRational) -> BigRational) -> Poly {
    let terms = p.terms.iter().map(|(m, c)| (m.clone(), Coefficient::from(f(&c.big())))).collect();
    Poly { terms, nvars: p.nvars, order: p.order.clone() }
}

/// The least common denominator of the coefficients.
pub(super) fn denominators<'p>(polynomials: impl Iterator<Item = &'p Poly>) -> BigInt {
    let mut all = BigRational::one();
    for (_, c) in polynomials.flat_map(|p| &p.terms) {
        // lcm(a, b) = a·(b / gcd(a, b)): the denominator of b/a in lowest terms is a/gcd(a, b).
        let quotient = BigRational::new(c.big().denom().clone(), all.numer().clone());
        all = BigRational::from_integer(all.numer() * quotient.numer());
    }
    all.numer().clone()
}

/// The polynomial times its least common denominator.
pub(super) fn integral(p: &Poly) -> Poly {
    let k = BigRational::from_integer(denominators(std::iter::once(p)));
    map(p, |c| c * &k)
}

/// k with p = k·q; 1 for 0.
pub(super) fn ratio(p: &Poly, q: &Poly) -> BigRational {
    match (p.terms.first(), q.terms.first()) {
        (Some((_, a)), Some((_, b))) => a.big() / b.big(),
        _ => BigRational::one(),
    }
}
