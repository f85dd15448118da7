//! The second route: certificates of membership, exact over ℚ and re-checkable by hand.
//!
//! The conclusion, with its fractions cleared, is a polynomial N in the leaves, in cosines, sines and exponentials, and in one
//! variable for each root and each |·|. The premises, with their fractions cleared, and the relations c² + s² − 1,
//! r²·d − n (r = √(n/d)), a² − u² (a = |u|) are polynomials pᵢ. A certificate is an identity of polynomials
//!
//! > d·N = Σ qᵢ·pᵢ
//!
//! with d a product of things that are not 0 (denominators, premises ≠ 0): wherever the formulas have a value and the premises
//! hold, N = 0. It is found by division, after Buchberger's algorithm with cofactors where the relations are not a Gröbner
//! basis as they stand, and accepted only after the right side has been expanded again
//! (`groebner::verify_lift`). Nothing of the random route enters: neither the solver nor the finite fields.
//!
//! **Not found** means nothing: the premises may imply the conclusion only over the reals, only for positive values (the
//! relations know both signs of a root), or the computation would be too large.

use super::outcome::{Premises, Reason};
use super::polynomial::{factors, fraction};
use super::prepare::{explicit, with_rates};
use super::prove::{Lowered, lower};
use super::solve::insert_definitions;
use crate::expr::FastMap;
use crate::expr::{Expr, Graph, Leaf, Node, Op, Rational};
use ::groebner::{LiftBasis, Monomial, MonomialOrder, Polynomial, PolynomialExt, PolynomialRing, verify_lift};
use num_bigint::BigInt;
use num_rational::BigRational;

type Poly = Polynomial<BigRational>;

/// A certificate for one equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// Number of the equation among those tested.
    pub equation: usize,
    /// Variables of the polynomials, and the expressions they stand for.
    pub variables: Vec<(String, Expr)>,
    /// Not 0; 1 where nothing has to be multiplied by.
    pub multiplier: String,
    /// The conclusion's numerator.
    pub conclusion: String,
    /// The relations that vanish, each with its cofactor.
    pub terms: Vec<(String, String)>,
}

/// Why there is no certificate. None of these says anything about the identity.
#[derive(Clone, Debug, PartialEq)]
pub enum NoCertificate {
    /// Not tried, or given up: too many terms.
    TooLarge,
    /// The conclusion is not in the ideal of the premises and relations.
    NotMember {
        /// Number of the equation.
        equation: usize,
    },
    /// The formulas could not be brought to polynomials.
    NotPolynomial(Reason),
}

/// Largest number of terms of a polynomial.
const MOST_TERMS: usize = 4000;
/// How large a system is given to Buchberger's algorithm, whose cost cannot be foreseen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Relations whose leading terms are not coprime to all others.
    pub relations: usize,
    /// Terms of all relations together.
    pub terms: usize,
    /// Total degree of a relation.
    pub degree: u32,
}

impl Effort {
    /// Milliseconds.
    pub const QUICK: Effort = Effort { relations: 6, terms: 64, degree: 12 };
    /// Seconds, sometimes many.
    pub const THOROUGH: Effort = Effort { relations: 12, terms: 120, degree: 12 };
}

impl Certificate {
    /// One line for SymPy that prints 0.
    pub fn sympy(&self) -> String {
        let python = |p: &str| p.replace('^', "**");
        let names: Vec<&str> = self.variables.iter().map(|(n, _)| n.as_str()).collect();
        let sum: Vec<String> = self.terms.iter().map(|(p, q)| format!("({})*({})", python(q), python(p))).collect();
        let sum = if sum.is_empty() { "0".to_owned() } else { sum.join(" + ") };
        format!(
            "from sympy import *; {} = symbols('{}'); print(expand(({})*({}) - ({sum})))",
            if names.len() == 1 { format!("({},)", names[0]) } else { names.join(", ") },
            if names.len() == 1 { format!("{},", names[0]) } else { names.join(" ") },
            python(&self.multiplier),
            python(&self.conclusion),
        )
    }
}

/// Certificates for all equations.
///
/// # Errors
/// [`NoCertificate`]; an identity without a certificate may still hold.
pub fn certify(
    graph: &mut Graph,
    equations: &[(Expr, Expr)],
    given: &Premises,
    effort: Effort,
) -> Result<Vec<Certificate>, NoCertificate> {
    let wrong = NoCertificate::NotPolynomial;
    let premises = with_rates(graph, given, equations).map_err(wrong)?;
    let solved = explicit(graph, &premises, equations, given);
    let mut inserted = Vec::new();
    for &(l, r) in equations {
        inserted.push((
            insert_definitions(graph, &solved.definitions, l),
            insert_definitions(graph, &solved.definitions, r),
        ));
    }
    let nonzero: Vec<Expr> = given.nonzero.iter().map(|&e| insert_definitions(graph, &solved.definitions, e)).collect();
    let positive: Vec<Expr> =
        given.positive.iter().map(|&e| insert_definitions(graph, &solved.definitions, e)).collect();
    let lowered = lower(graph, &solved.rest, &inserted, [&nonzero, &positive, &[]], &[]).map_err(wrong)?;
    let mut system = System::new(graph, &lowered, effort)?;
    let mut out = Vec::new();
    for (equation, &(l, r)) in lowered.claim.iter().enumerate() {
        out.push(system.certificate(graph, &lowered, equation, (l, r))?);
    }
    Ok(out)
}

/// A ring and the relations in it.
struct System {
    variables: Vec<Expr>,
    place: FastMap<Expr, usize>,
    relations: Vec<Poly>,
    basis: Option<LiftBasis<BigRational>>,
    effort: Effort,
}

impl System {
    fn new(graph: &mut Graph, lowered: &Lowered, effort: Effort) -> Result<System, NoCertificate> {
        let mut roots: Vec<Expr> = lowered.claim.iter().flat_map(|&(l, r)| [l, r]).collect();
        roots.extend(lowered.premises.iter().map(|&(e, _)| e));
        // Variables: roots and |·| first, then rates, then the rest, so that elimination goes that way.
        let mut variables = Vec::new();
        for e in graph.reachable(roots.iter().copied()) {
            match *graph.node(e) {
                Node::Leaf(leaf) => {
                    variables.push((if leaf.rate > 0 { 1 } else { 2 }, e));
                    // The partner of a cosine or sine is needed for their relation.
                    if let Some((c, s)) = lowered.generators.circle(leaf) {
                        let (c, s) = (graph.leaf(c), graph.leaf(s));
                        variables.extend([(2, c), (2, s)]);
                    }
                }
                Node::Unary(Op::Sqrt | Op::Abs, _) => variables.push((0, e)),
                _ => {}
            }
        }
        variables.sort_unstable_by_key(|&(class, e)| (class, std::cmp::Reverse(e)));
        variables.dedup();
        let variables: Vec<Expr> = variables.into_iter().map(|(_, e)| e).collect();
        let place = variables.iter().enumerate().map(|(i, &e)| (e, i)).collect();
        let mut system = System { variables, place, relations: Vec::new(), basis: None, effort };
        for e in system.variables.clone() {
            if let Some(relation) = system.own_relation(graph, lowered, e) {
                let (top, _) = fraction(graph, relation);
                let p = system.expand(graph, top)?;
                if !p.is_zero() {
                    system.relations.push(p);
                }
            }
        }
        for &(e, _) in &lowered.premises {
            let (top, _) = fraction(graph, e);
            let p = system.expand(graph, top)?;
            if !p.is_zero() {
                system.relations.push(p);
            }
        }
        Ok(system)
    }

    /// What a variable satisfies by its meaning.
    fn own_relation(&self, graph: &mut Graph, lowered: &Lowered, e: Expr) -> Option<Expr> {
        let square = graph.powi(e, 2);
        match *graph.node(e) {
            Node::Unary(Op::Sqrt, u) => Some(graph.sub(square, u)),
            Node::Unary(Op::Abs, u) => {
                let other = graph.powi(u, 2);
                Some(graph.sub(square, other))
            }
            Node::Leaf(leaf) => {
                let (c, s): (Leaf, Leaf) = lowered.generators.circle(leaf)?;
                if leaf != s {
                    return None;
                }
                let c = graph.leaf(c);
                let (cc, one) = (graph.powi(c, 2), graph.integer(1));
                let sum = graph.add(square, cc);
                Some(graph.sub(sum, one))
            }
            _ => None,
        }
    }

    fn certificate(
        &mut self,
        graph: &mut Graph,
        lowered: &Lowered,
        equation: usize,
        (l, r): (Expr, Expr),
    ) -> Result<Certificate, NoCertificate> {
        let residual = graph.sub(l, r);
        let (top, under) = fraction(graph, residual);
        let conclusion = self.expand(graph, top)?;
        if self.expand(graph, under)?.is_zero() {
            return Err(NoCertificate::NotPolynomial(Reason::NoValue));
        }
        let mut multiplier = self.constant(&Rational::ONE);
        let mut factor = self.constant(&Rational::ONE);
        for base in not_zero(graph, lowered) {
            let (top, _) = fraction(graph, base);
            if let Ok(p) = self.expand(graph, top) {
                if p.is_zero() {
                    return Err(NoCertificate::NotPolynomial(Reason::NoValue));
                }
                if factor.terms.len() * p.terms.len() > 64 {
                    break;
                }
                factor = &factor * &p;
            }
        }
        for _ in 0..3 {
            if multiplier.terms.len() * conclusion.terms.len() > 4 * MOST_TERMS {
                break;
            }
            let target = &multiplier * &conclusion;
            if let Some(cofactors) = self.lift(&target)? {
                return self.written(graph, equation, &multiplier, &conclusion, &cofactors);
            }
            multiplier = &multiplier * &factor;
        }
        Err(NoCertificate::NotMember { equation })
    }

    /// Cofactors over the relations, verified.
    fn lift(&mut self, target: &Poly) -> Result<Option<Vec<Poly>>, NoCertificate> {
        if self.relations.is_empty() {
            return Ok(target.is_zero().then(Vec::new));
        }
        let (quotients, remainder) = target.divide_with_remainder(&self.relations);
        if remainder.is_zero() && verify_lift(&self.relations, &quotients, target) {
            return Ok(Some(quotients));
        }
        if self.is_basis() {
            return Ok(None);
        }
        if self.basis.is_none() {
            let terms: usize = self.relations.iter().map(|p| p.terms.len()).sum();
            let degree = self.relations.iter().map(Poly::total_degree).max().unwrap_or(0);
            let overlapping = self.relations.iter().filter(|p| self.overlaps(p)).count();
            let Effort { relations, terms: most_terms, degree: highest } = self.effort;
            if overlapping > relations || terms > most_terms || degree > highest {
                return Err(NoCertificate::TooLarge);
            }
            self.basis = Some(LiftBasis::new(&self.relations).map_err(|_| NoCertificate::TooLarge)?);
        }
        let Some(basis) = &self.basis else { return Ok(None) };
        let found = basis.lift(target).map_err(|_| NoCertificate::TooLarge)?;
        Ok(found.filter(|cofactors| verify_lift(&self.relations, cofactors, target)))
    }

    fn overlaps(&self, p: &Poly) -> bool {
        self.relations.iter().any(|q| match (p.lm(), q.lm()) {
            (Some(a), Some(b)) => p != q && !a.is_coprime(b),
            _ => false,
        })
    }

    /// Whether the leading terms are pairwise coprime: then the relations are a Gröbner basis (Buchberger's first criterion).
    fn is_basis(&self) -> bool {
        !self.relations.iter().any(|p| self.overlaps(p))
    }

    fn constant(&self, r: &Rational) -> Poly {
        Poly::constant(big(r), self.variables.len(), MonomialOrder::GRevLex)
    }

    /// A polynomial, from an expression without division.
    fn expand(&self, graph: &Graph, e: Expr) -> Result<Poly, NoCertificate> {
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
                if p.terms.len().saturating_mul(q.terms.len()) <= 8 * MOST_TERMS {
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
            if value.terms.len() > MOST_TERMS {
                return Err(NoCertificate::TooLarge);
            }
            known.insert(node, value);
        }
        known.remove(&e).ok_or(NoCertificate::TooLarge)
    }

    fn written(
        &self,
        graph: &Graph,
        equation: usize,
        multiplier: &Poly,
        conclusion: &Poly,
        cofactors: &[Poly],
    ) -> Result<Certificate, NoCertificate> {
        let names: Vec<String> = self.variables.iter().enumerate().map(|(i, &e)| plain_name(graph, e, i)).collect();
        let ring = PolynomialRing::<BigRational>::new(names.clone(), MonomialOrder::GRevLex)
            .map_err(|_| NoCertificate::TooLarge)?;
        let text = |p: &Poly| ring.format(p).map_err(|_| NoCertificate::TooLarge);
        let mut terms = Vec::new();
        for (p, q) in self.relations.iter().zip(cofactors).filter(|(_, q)| !q.is_zero()) {
            terms.push((text(p)?, text(q)?));
        }
        Ok(Certificate {
            equation,
            variables: names.into_iter().zip(self.variables.iter().copied()).collect(),
            multiplier: text(multiplier)?,
            conclusion: text(conclusion)?,
            terms,
        })
    }
}

/// Factors that are not 0 where the formulas have a value and the premises hold.
fn not_zero(graph: &Graph, lowered: &Lowered) -> Vec<Expr> {
    let mut out: Vec<Expr> = Vec::new();
    for &e in lowered.denominators.iter().chain(&lowered.assumed) {
        for (base, _) in factors(graph, e).1 {
            if !out.contains(&base) && graph.as_constant(base).is_none() {
                out.push(base);
            }
        }
    }
    out
}

fn big(r: &Rational) -> BigRational {
    let integer = |text: String| text.parse::<BigInt>().unwrap_or_default();
    BigRational::new(integer(r.numerator().to_string()), integer(r.denominator().to_string()))
}

/// A name that every computer algebra system accepts: the letters of the LaTeX name, numbered to be unique.
fn plain_name(graph: &Graph, e: Expr, number: usize) -> String {
    let letters: String = match graph.node(e) {
        Node::Leaf(leaf) => graph.name(leaf.symbol).chars().filter(char::is_ascii_alphanumeric).collect(),
        Node::Unary(Op::Sqrt, _) => "root".to_owned(),
        _ => "abs".to_owned(),
    };
    let start = if letters.starts_with(|c: char| c.is_ascii_alphabetic()) { "" } else { "x" };
    format!("{start}{letters}_{number}")
}
